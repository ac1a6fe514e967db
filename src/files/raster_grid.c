// SPDX-License-Identifier: MIT
#include "files/raster_grid.h"

#include <math.h>

// WGS 84.
#define EQUATOR 6378137.0
#define SQUARED_ECCENTRICITY 6.69437999014e-3
#define DEGREE (SW_PI / 180.0)
#define LATITUDE_SLACK 0.05 // of the length of a degree of longitude, before it is told

static void measureDegrees(swRasterGrid* grid)
{
    double latitude = grid->originNorth * DEGREE;
    double bend = 1.0 - SQUARED_ECCENTRICITY * sin(latitude) * sin(latitude);
    grid->metresEast = DEGREE * EQUATOR / sqrt(bend) * cos(latitude);
    grid->metresNorth = DEGREE * EQUATOR * (1.0 - SQUARED_ECCENTRICITY) / (bend * sqrt(bend));
}

static double getEnd(const swRasterAxis* axis)
{
    return axis->first + axis->spacing * (axis->count - 1);
}

// Numbers that can be degrees and would be odd as metres.
static bool looksLikeDegrees(const swRasterGrid* grid)
{
    return grid->east.spacing < 1.0 && grid->north.spacing < 1.0 && grid->east.first >= -360.0 &&
           getEnd(&grid->east) <= 360.0 && grid->north.first >= -90.0 && getEnd(&grid->north) <= 90.0 &&
           (grid->east.spacing * grid->east.count > 1e-3) && grid->east.spacing < 0.6;
}

static void chooseUnit(swRasterGrid* grid, char unit)
{
    swRasterCoordinates asked = grid->def->coordinates;
    if (asked != SW_RASTER_BY_FILE || unit != 0)
    {
        grid->isDegrees = asked == SW_RASTER_BY_FILE ? unit == 'd' : asked == SW_RASTER_DEGREES;
        return;
    }
    grid->isDegrees = looksLikeDegrees(grid);
    if (grid->isDegrees)
    {
        swLog(grid->host, SW_LOG_WARNING,
              "%s does not say what its coordinates are; from their size they are taken for degrees. "
              "swRasterFileDef::coordinates tells it.",
              grid->name);
    }
}

static swResult chooseOrigin(swRasterGrid* grid)
{
    const swRasterFileDef* def = grid->def;
    double middleEast = 0.5 * (grid->east.first + getEnd(&grid->east));
    double middleNorth = 0.5 * (grid->north.first + getEnd(&grid->north));
    grid->originEast = isfinite(def->originEast) ? def->originEast : grid->isDegrees ? middleEast : 0.0;
    grid->originNorth = isfinite(def->originNorth) ? def->originNorth : grid->isDegrees ? middleNorth : 0.0;
    grid->metresEast = grid->metresNorth = 1.0;
    if (!grid->isDegrees)
    {
        return SW_SUCCESS;
    }
    if (fabs(grid->originNorth) > 89.0 || fabs(grid->north.first) > 90.5 || fabs(getEnd(&grid->north)) > 90.5)
    {
        return swFail(grid->host, SW_ERROR_FORMAT,
                      "%s would have latitudes from %g to %g about an origin at %g; are its coordinates metres?",
                      grid->name, grid->north.first, getEnd(&grid->north), grid->originNorth);
    }
    measureDegrees(grid);
    // Longitudes may be counted from -180 or from 0; the raster lies on the origin's side.
    grid->east.first += 360.0 * rint((grid->originEast - middleEast) / 360.0);
    if (!isfinite(def->originEast) || !isfinite(def->originNorth))
    {
        swLog(grid->host, SW_LOG_INFO, "%s: the origin of the world is its middle, %.6f east, %.6f north.", grid->name,
              grid->originEast, grid->originNorth);
    }
    return SW_SUCCESS;
}

// Keep the cells whose middles lie in [low, high], metres from the origin.
static void crop(swRasterAxis* axis, double origin, double metres, double low, double high)
{
    axis->begin = 0;
    axis->end = axis->count;
    while (axis->begin < axis->end && metres * (axis->first + axis->spacing * axis->begin - origin) < low)
    {
        axis->begin += 1;
    }
    while (axis->end > axis->begin && metres * (axis->first + axis->spacing * (axis->end - 1) - origin) > high)
    {
        axis->end -= 1;
    }
}

// A degree of longitude has one length all over the raster. Where it would be of another length, cells lie aside.
static void warnOfLatitudes(const swRasterGrid* grid)
{
    double south = grid->north.first + grid->north.spacing * grid->north.begin;
    double north = grid->north.first + grid->north.spacing * (grid->north.end - 1);
    double here = cos(grid->originNorth * DEGREE);
    double off = fmax(fabs(cos(south * DEGREE) / here - 1.0), fabs(cos(north * DEGREE) / here - 1.0));
    const swRasterAxis* axis = swGetKeptEast(grid);
    double west = axis->first + axis->spacing * axis->begin;
    double east = axis->first + axis->spacing * (axis->end - 1);
    double reach = fmax(fabs(west - grid->originEast), fabs(east - grid->originEast)) * grid->metresEast;
    if (off > LATITUDE_SLACK)
    {
        swLog(grid->host, SW_LOG_WARNING,
              "%s reaches from %.6g to %.6g degrees north, where a degree of longitude is up to %.0f %% longer or "
              "shorter than at its origin, %.6g: cells lie up to %.3g km aside. Crop it, or set "
              "swRasterFileDef::originNorth (in scenes origin_north) nearer.",
              grid->name, south, north, 100.0 * off, grid->originNorth, 1e-3 * off * reach);
    }
}

swResult swPlaceRasterGrid(swRasterGrid* grid, char unit)
{
    const swRasterFileDef* def = grid->def;
    chooseUnit(grid, unit);
    swResult result = chooseOrigin(grid);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swFindRasterRing(grid);
    swRasterAxis* east = grid->isRing ? &grid->ring : &grid->east;
    crop(east, grid->originEast, grid->metresEast, def->west, def->east);
    if (grid->isRing)
    {
        grid->east.begin = 0;
        grid->east.end = grid->ring.count;
    }
    crop(&grid->north, grid->originNorth, grid->metresNorth, -def->south, -def->north); // z is south
    int width = east->end - east->begin, height = grid->north.end - grid->north.begin;
    if (width < 1 || height < 1)
    {
        return swFail(
            grid->host, SW_ERROR_FORMAT,
            "%s has no cell between x = %g and %g, z = %g and %g m; it reaches from x = %g to %g and from z = "
            "%g to %g.",
            grid->name, def->west, def->east, def->north, def->south,
            grid->metresEast * (east->first - grid->originEast), grid->metresEast * (getEnd(east) - grid->originEast),
            -grid->metresNorth * (getEnd(&grid->north) - grid->originNorth),
            -grid->metresNorth * (grid->north.first - grid->originNorth));
    }
    size_t size = swCountGridCells(grid) * sizeof(float);
    if (width > SW_MAX_RASTER_SIDE || height > SW_MAX_RASTER_SIDE || size > def->memoryLimit)
    {
        return swFail(grid->host, SW_ERROR_LIMIT,
                      "%s has %d x %d cells, %zu bytes; at most %d along a side and %zu bytes are read. Crop it by "
                      "swRasterFileDef::west and the others (in scenes west_m).",
                      grid->name, width, height, size, SW_MAX_RASTER_SIDE, def->memoryLimit);
    }
    if (grid->isDegrees)
    {
        warnOfLatitudes(grid);
    }
    return SW_SUCCESS;
}

void swUnwrapLongitudes(double* places, size_t count)
{
    for (size_t i = 1; i < count; ++i)
    {
        double turns = rint((places[i - 1] - places[i]) / 360.0);
        places[i] += isfinite(turns) ? 360.0 * turns : 0.0;
    }
}

swResult swPlaceImageGrid(swRasterGrid* grid, int width, int height, const double spacing[2], const double first[2],
                          char unit)
{
    const swRasterFileDef* def = grid->def;
    double east = isfinite(def->spacingEast) ? def->spacingEast : spacing[0];
    double north = isfinite(def->spacingNorth) ? def->spacingNorth : spacing[1];
    double west = isfinite(def->imageEast) ? def->imageEast : first[0];
    double top = isfinite(def->imageNorth) ? def->imageNorth : first[1];
    bool isGuessed = !isfinite(east) || !isfinite(north) || !isfinite(west) || !isfinite(top);
    east = isfinite(east) ? east : 1.0;
    north = isfinite(north) ? north : 1.0;
    west = isfinite(west) ? west : -0.5 * east * (width - 1);
    top = isfinite(top) ? top : 0.5 * north * (height - 1);
    if (!(east > 0.0) || !(north > 0.0))
    {
        return swFail(grid->host, SW_ERROR_FORMAT, "%s has cells of %g x %g; their sides must be above 0.", grid->name,
                      east, north);
    }
    if (isGuessed)
    {
        swLog(
            grid->host, SW_LOG_INFO,
            "%s does not say where it lies: its cells are taken as %g x %g and the middle of its north-western one at "
            "%g east, %g north. swRasterFileDef::spacingEast and the others tell it.",
            grid->name, east, north, west, top);
    }
    grid->east = (swRasterAxis){.first = west, .spacing = east, .count = width};
    grid->north = (swRasterAxis){.first = top - north * (height - 1), .spacing = north, .count = height};
    grid->isNorthFirst = true;
    bool isMetric = unit == 0 && def->coordinates == SW_RASTER_BY_FILE;
    return swPlaceRasterGrid(grid, isMetric ? 'm' : unit);
}

swImageRows swGetImageRows(const swRasterGrid* grid)
{
    return (swImageRows){grid->north.count - grid->north.end, grid->north.count - grid->north.begin};
}

float* swAllocateCells(const swRasterGrid* grid, swResult* result)
{
    size_t size = swCountGridCells(grid) * sizeof(float);
    float* values = swAllocate(grid->host, size);
    if (values == NULL)
    {
        *result = swFail(grid->host, SW_ERROR_NO_MEMORY, "No memory for the cells of %s, %zu bytes.", grid->name, size);
    }
    return values;
}

void swFreeCells(const swRasterGrid* grid, float* values)
{
    swFree(grid->host, values, swCountGridCells(grid) * sizeof(float));
}

static void swapRows(const swRasterGrid* grid, float* values)
{
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    size_t height = (size_t)(grid->north.end - grid->north.begin);
    for (size_t row = 0; row < height / 2; ++row)
    {
        float *a = values + row * width, *b = values + (height - 1 - row) * width;
        for (size_t column = 0; column < width; ++column)
        {
            float value = a[column];
            a[column] = b[column];
            b[column] = value;
        }
    }
}

// A file's numbers to metres. Where there is nothing to do, the bits stay.
static void scaleCells(const swRasterGrid* grid, float* values)
{
    const swRasterFileDef* def = grid->def;
    bool isScaled = def->scale != 1.0 || def->offset != 0.0;
    if (!isScaled && !grid->isDepth && isnan(def->missing))
    {
        return;
    }
    size_t count = swCountGridCells(grid);
    for (size_t i = 0; i < count; ++i)
    {
        float value = (double)values[i] == def->missing || values[i] == (float)def->missing ? NAN : values[i];
        value = isScaled ? (float)(def->offset + def->scale * (double)value) : value;
        values[i] = grid->isDepth ? -value : value;
    }
}

swResult swMakeGridRaster(const swRasterGrid* grid, float* values, swRaster** raster)
{
    if (!grid->isNorthFirst)
    {
        swapRows(grid, values);
    }
    scaleCells(grid, values);
    swResult result = grid->isRing ? swTurnRingRows(grid, values) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const swRasterAxis* east = swGetKeptEast(grid);
    swRasterDef def = swDefaultRasterDef();
    def.name = grid->name;
    def.width = east->end - east->begin;
    def.height = grid->north.end - grid->north.begin;
    def.spacingX = grid->metresEast * east->spacing;
    def.spacingZ = grid->metresNorth * grid->north.spacing;
    double west = east->first + east->spacing * east->begin;
    double north = grid->north.first + grid->north.spacing * (grid->north.end - 1);
    def.x = grid->metresEast * (west - grid->originEast);
    def.z = -grid->metresNorth * (north - grid->originNorth);
    def.values = values;
    result = swCreateRaster(grid->host, &def, raster);
    return result == SW_ERROR_INVALID ? SW_ERROR_FORMAT : result;
}
