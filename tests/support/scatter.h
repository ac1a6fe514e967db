// SPDX-License-Identifier: MIT
#pragma once

// Scattered numbers that are the same in every run.

#include <stdint.h>

#include <seaway/math.h>

// In [0, 1).
static inline double NextPart(uint32_t* seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) * 0x1p-24;
}

// Over a square around a point.
static inline void ScatterPoints(swPosXZ* points, int count, double aroundX, double aroundZ, double side)
{
    uint32_t seed = 12345;
    for (int i = 0; i < count; ++i)
    {
        points[i].x = aroundX + side * (NextPart(&seed) - 0.5);
        points[i].z = aroundZ + side * (NextPart(&seed) - 0.5);
    }
}
