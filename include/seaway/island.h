// SPDX-License-Identifier: MIT
#pragma once

#include "raster.h"

/// @file
/// Islands out of nothing but a seed: a mountain with ridges and valleys, a beach, a shelf, and the slope down to the
/// sea floor, as a raster for an input of the field SW_INPUT_FLOOR and for a terrain.

/// Must be initialized with swDefaultIslandDef().
typedef struct swIslandDef
{
    /// Another seed is another island. Range [0, UINT32_MAX]. Default 1.
    uint32_t seed;

    /// Where its middle lies, m. Range [-1e8, 1e8]. Default 0.
    double x, z;

    /// From the middle to the coast on the average, m. Range [50, 20000]. Default 1000.
    float radius;

    /// Height of its mountain, about, m. Range [1, 4000]. Default 300.
    float height;

    /// Depth of the sea around it, m. Range [1, 8000]. Default 150.
    float depth;

    /// How far the beach goes on under water before the floor falls, m. Its depth follows Dean's law, 0.12 m^(1/3)
    /// times the distance from the coast to the power 2/3. Range [0, 20000]. Default 300.
    float shelfWidth;

    /// How much coast, mountain and floor are broken up: 0 is a smooth cone. Range [0, 1]. Default 0.6.
    float ruggedness;

    /// Side of the square whose floor is known, m. Range [100, 200000]. Default 6000.
    float extent;

    /// Cells along a side; their spacing is the extent over one less. Range [2, 8192]. Default 1025.
    int cells;

    /// Set by swDefaultIslandDef().
    int internalValue;
} swIslandDef;

SW_API swIslandDef swDefaultIslandDef(void);
SW_API const swFields* swGetIslandFields(void);

/// Make the heights of an island, m above sea level: the same bits on every machine. About 2 us a cell, on one thread.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY
SW_API swResult swCreateIsland(const swHost* host, const swIslandDef* def, swRaster** raster);
