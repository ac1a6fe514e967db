// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"
#include "math.h"

/// @file
/// Rasters: numbers on a lattice of the plane, such as the heights of a sea floor. A raster never changes once it is
/// made; any number of threads may read it. Files of them are read by files.h.

/// Most cells along a side.
#define SW_MAX_RASTER_SIDE 16384

/// Most values of all cells, channels and frames.
#define SW_MAX_RASTER_VALUES 1073741824

typedef struct swRaster swRaster;

/// Must be initialized with swDefaultRasterDef().
typedef struct swRasterDef
{
    /// For messages. At most 255 characters are kept. Default "raster".
    const char* name;

    /// Cells along x and along z. Range [1, 16384]. Default 1.
    int width, height;

    /// Where the middle of the first cell lies, m: the north-western one. Range [-1e9, 1e9]. Default 0.
    double x, z;

    /// From cell to cell eastwards (x) and southwards (z), m. Range [0.001, 1e6]. Default 1.
    double spacingX, spacingZ;

    /// Numbers of each cell, such as the two of a flow. Range [1, 4]. Default 1.
    int channels;

    /// Lattices of one after another, such as a flow that was computed elsewhere; see swInputDef::framesPerSecond.
    /// Range [1, 65536]. Default 1.
    int frames;

    /// [frames][height][width][channels], rows from north to south, each from west to east, at most
    /// SW_MAX_RASTER_VALUES. NaN where nothing is known; else at most 1e6 either way. They are copied.
    const float* values;

    /// Set by swDefaultRasterDef().
    int internalValue;
} swRasterDef;

SW_API swRasterDef swDefaultRasterDef(void);
SW_API const swFields* swGetRasterFields(void);

/// @return SW_ERROR_INVALID (the host's log names the cell or the number), SW_ERROR_NO_MEMORY
SW_API swResult swCreateRaster(const swHost* host, const swRasterDef* def, swRaster** raster);
/// Give the handle back. A raster that inputs use lives as long as they do. NULL is allowed.
SW_API void swDestroyRaster(swRaster* raster);

typedef struct swRasterInfo
{
    const char* name; ///< lives as long as the raster
    int width, height;
    double x, z;
    double spacingX, spacingZ;
    float least, most; ///< of what is known; NaN if nothing is
    size_t unknownCount;
    size_t memory; ///< bytes
    uint64_t hash; ///< of its place and values, bit by bit: the same on every machine
    int channels, frames;
} swRasterInfo;

SW_API swRasterInfo swRaster_GetInfo(const swRaster* raster);

/// The values as they were given: [frames][height][width][channels].
SW_API const float* swRaster_GetValues(const swRaster* raster);

/// Values of the first channel of the first frame at points, bilinearly between the middles of cells. NaN outside of
/// the outermost middles, where a cell that has a part in it is unknown, and at points that are not finite. The same
/// bits on every machine.
SW_API void swRaster_Sample(const swRaster* raster, int count, const swPosXZ* points, float* values);
