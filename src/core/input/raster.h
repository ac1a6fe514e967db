// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swRaster: one block of memory, the values behind the head.

#include <stdatomic.h>

#include "core/base/field.h"
#include "seaway/raster.h"

extern const swFields swRasterFields;

struct swRaster
{
    swHost host;
    char name[256];
    int width, height;
    double x, z;
    double spacingX, spacingZ;
    int channels, frames;
    float least, most;
    size_t unknownCount;
    size_t memory;
    uint64_t hash;
    atomic_int references; // the host's handle and each input that uses it
    float* values;         // [frames][height][width][channels]
};

// Raster may be NULL. It is freed with the last reference.
void swRetainRaster(const swRaster* raster);
void swReleaseRaster(const swRaster* raster);

// The first channel of the first frame at one point, see swRaster_Sample().
float swSampleRaster(const swRaster* raster, double x, double z);
