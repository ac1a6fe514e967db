// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swRaster: one block of memory, the values behind the head.

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
    float least, most;
    size_t unknownCount;
    size_t memory;
    uint64_t hash;
    float* values; // [height][width]
};

// The value at one point, see swRaster_Sample().
float swSampleRaster(const swRaster* raster, double x, double z);
