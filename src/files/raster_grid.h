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
    swRasterAxis east, north; // as the file has them
    bool isRing;              // columns go all the way round, and what is kept runs over the file's seam:
    swRasterAxis ring;        // the axis of what is kept, beginning at the file's column ringFirst
    int ringFirst;
    bool isDegrees;
    bool isDepth;
    bool isNorthFirst; // the values run from north to south
    double originEast, originNorth;
    double metresEast, metresNorth; // of one unit of the file
} swRasterGrid;

// After the axes are known: finds the origin and the scale, crops, and checks the size. `unit` is what the file says,
// 'd' for degrees, 'm' for metres, 0 for nothing.
swResult swPlaceRasterGrid(swRasterGrid* grid, char unit);

// The same for an image, whose rows run from north to south: its axes follow from its size and the def. `spacing` and
// `first` (east, north, of the middle of the north-western cell) are what the file says, or NaN.
swResult swPlaceImageGrid(swRasterGrid* grid, int width, int height, const double spacing[2], const double first[2],
                          char unit);

// Kept cells of an image: rows [first, end) from the north on, columns from the grid's east axis.
typedef struct swImageRows
{
    int first, end;
} swImageRows;
swImageRows swGetImageRows(const swRasterGrid* grid);

// Make the raster from the kept cells: rows from south to north as the axes run (or as isNorthFirst says), each from
// west to east. The values are heights or depths as the file has them, NaN where nothing is known. They are turned and
// scaled in place.
swResult swMakeGridRaster(const swRasterGrid* grid, float* values, swRaster** raster);

// Memory for the kept cells; a sentence in the log if there is none.
float* swAllocateCells(const swRasterGrid* grid, swResult* result);
void swFreeCells(const swRasterGrid* grid, float* values);

// Longitudes in the order of a file that run over 180 or 360 degrees: each at most half a turn from the one before.
void swUnwrapLongitudes(double* places, size_t count);

// Raster columns that go all the way round the earth, where the wanted ones run over both ends of a row. Readers read
// whole rows then (`east` keeps all columns but those that stand twice), and swTurnRingRows() puts them in order.
void swFindRasterRing(swRasterGrid* grid);
swResult swTurnRingRows(const swRasterGrid* grid, float* values);

// The axis towards the east of what is kept.
static inline const swRasterAxis* swGetKeptEast(const swRasterGrid* grid)
{
    return grid->isRing ? &grid->ring : &grid->east;
}

// What one of a unit is: metres of a length, metres a second of a speed, 1 of what is no unit. NaN if it is not known.
double swFindRasterUnit(const char* text);

// The same for the values of a file. One that is not known counts as 1, which the log tells. So does any where the def
// has a scale of its own: the host has looked.
double swKnowRasterUnit(const swRasterGrid* grid, const char* text);

// Cells that are read.
static inline size_t swCountGridCells(const swRasterGrid* grid)
{
    return (size_t)(grid->east.end - grid->east.begin) * (size_t)(grid->north.end - grid->north.begin);
}

swResult swReadEsriGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                        swRaster** raster);
swResult swReadXyzGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                       swRaster** raster);
bool swIsEsriGrid(const swFileText* text);

swResult swReadRawGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);

#if SW_HAS_PNG
swResult swReadPngGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
#endif
#if SW_HAS_EXR
swResult swReadExrGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
#endif
#if SW_HAS_TIFF
swResult swReadTiffGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
#endif
#if SW_HAS_NETCDF
swResult swReadNetcdfGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
#endif
