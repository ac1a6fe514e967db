// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swMesh: one block of memory, what was given and the words of shaders/shared/shape_mesh.h behind
// the head.

#include <stdatomic.h>

#include "core/base/field.h"
#include "seaway/mesh.h"
#include "shared/input.h"

extern const swFields swMeshFields;

struct swMesh
{
    swHost host;
    atomic_int users; // the host's handle, and inputs
    char name[256];
    swVec3 low, high;
    float highest;
    int vertexCount, triangleCount, channelCount;
    size_t memory;
    uint64_t hash;
    const swVec3* vertices;
    const uint32_t* indices;
    const float* values; // NULL: none
    float largest;       // of its values, either way; without any it says 1
    int countX, countZ;  // cells of the grid
    uint32_t firstEntry, firstTriangle;
    uint32_t wordCount;
    const float* words;
};

// NULL is allowed. It is freed with the last user.
void swHoldMesh(const swMesh* mesh);
void swReleaseMesh(const swMesh* mesh);

// What a record says about the words of a mesh: sizes, and its bounds.
void swDescribeMesh(const swMesh* mesh, swInputRecord* record);

// Whether a record of words from elsewhere names none that it does not have.
bool swAreMeshWordsGood(const swInputRecord* record, const float* words);
