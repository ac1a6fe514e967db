// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swHull: one block of memory, the words of shaders/shared/shape_hull.h behind the head.

#include <stdatomic.h>

#include "core/base/field.h"
#include "core/input/hull_grid.h"
#include "seaway/hull.h"

extern const swFields swHullFields;

struct swHull
{
    swHost host;
    atomic_int references; // the host's handle, and inputs
    char name[256];
    swVec3 low, high; // of the mesh
    swHullGrid grid;
    size_t memory;
    uint64_t hash;
    int wordCount;
    float* words;
};

void swRetainHull(const swHull* hull);
void swReleaseHull(const swHull* hull);
