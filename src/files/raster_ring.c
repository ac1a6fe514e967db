// SPDX-License-Identifier: MIT
// Rasters of the whole earth: a row begins at a seam, such as 180 degrees, and a place near that has neighbours at both
// ends of the row.

#include <math.h>
#include <string.h>

#include "files/raster_grid.h"

// Columns to the full turn: 0 where they do not go all the way round. One more may stand there twice.
static int countRing(const swRasterAxis* east)
{
    double turn = 360.0 / east->spacing;
    bool isWhole = turn >= 2.0 && turn <= 1e7 && fabs(turn - rint(turn)) < 0.01;
    int count = isWhole ? (int)rint(turn) : 0;
    return isWhole && (east->count == count || east->count == count + 1) ? count : 0;
}

void swFindRasterRing(swRasterGrid* grid)
{
    const swRasterFileDef* def = grid->def;
    swRasterAxis* east = &grid->east;
    int count = grid->isDegrees ? countRing(east) : 0;
    double last = east->first + east->spacing * (east->count - 1);
    bool isInside = grid->originEast + def->west / grid->metresEast >= east->first &&
                    grid->originEast + def->east / grid->metresEast <= last;
    if (count == 0 || isInside)
    {
        return;
    }
    double middle = east->first + 0.5 * east->spacing * (count - 1);
    int steps = (int)rint((grid->originEast - middle) / east->spacing);
    if (steps == 0)
    {
        return;
    }
    grid->isRing = true;
    grid->ring = (swRasterAxis){.first = east->first + east->spacing * steps, .spacing = east->spacing, .count = count};
    grid->ringFirst = ((steps % count) + count) % count;
}

swResult swTurnRingRows(const swRasterGrid* grid, float* values)
{
    const swRasterAxis* ring = &grid->ring;
    size_t count = (size_t)ring->count, kept = (size_t)(ring->end - ring->begin);
    size_t rows = (size_t)(grid->north.end - grid->north.begin);
    size_t first = ((size_t)grid->ringFirst + (size_t)ring->begin) % count;
    size_t upToSeam = kept < count - first ? kept : count - first;
    float* row = swAllocate(grid->host, count * sizeof(float));
    if (row == NULL)
    {
        return swFail(grid->host, SW_ERROR_NO_MEMORY, "No memory for a row of %s.", grid->name);
    }
    for (size_t i = 0; i < rows; ++i)
    {
        memcpy(row, values + i * count, count * sizeof(float));
        memcpy(values + i * kept, row + first, upToSeam * sizeof(float));
        memcpy(values + i * kept + upToSeam, row, (kept - upToSeam) * sizeof(float));
    }
    swFree(grid->host, row, count * sizeof(float));
    return SW_SUCCESS;
}
