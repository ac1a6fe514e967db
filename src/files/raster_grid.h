// SPDX-License-Identifier: MIT
#pragma once

// What the readers of rasters share: a lattice in the file's own coordinates, and its way into the world.

#include "core/base/host.h"
#include "files/file_text.h"
#include "seaway/files.h"

// An axis of middles of cells, ascending.
typedef struct swRasterAxis
{
    double first, spacing; // metres or degrees, as the file has them
    int count;
    int begin, end; // what is kept after cropping
} swRasterAxis;

typedef struct swRasterGrid
{
    const swHost* host;
    const char* name; // for messages
    const swRasterFileDef* def;
    swRasterAxis east, north;
    bool isDegrees;
    bool isDepth;
    double originEast, originNorth;
    double metresEast, metresNorth; // of one unit of the file
} swRasterGrid;

// After the axes are known: finds the origin and the scale, crops, and checks the size. `unit` is what the file says,
// 'd' for degrees, 'm' for metres, 0 for nothing.
swResult swPlaceRasterGrid(swRasterGrid* grid, char unit);

// Make the raster from the kept cells: rows from south to north as the axes run, each from west to east. The values are
// heights or depths as the file has them, NaN where nothing is known.
swResult swMakeGridRaster(const swRasterGrid* grid, const float* values, swRaster** raster);

// Kept cells.
static inline size_t swCountGridCells(const swRasterGrid* grid)
{
    return (size_t)(grid->east.end - grid->east.begin) * (size_t)(grid->north.end - grid->north.begin);
}

swResult swReadEsriGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                        swRaster** raster);
swResult swReadXyzGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                       swRaster** raster);
bool swIsEsriGrid(const swFileText* text);

#if SW_HAS_NETCDF
swResult swReadNetcdfGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
#endif
