// SPDX-License-Identifier: MIT
// Lines of x, y and value, in any order, on a regular lattice of which cells may be missing.

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/array.h"
#include "core/base/text.h"
#include "files/raster_grid.h"

// Coordinates are printed with few digits: how far from the lattice they may be, in cells.
#define SLACK 0.1

typedef struct XyzPoint
{
    double x, y;
    float value;
    int line;
} XyzPoint;

typedef struct XyzGrid
{
    swText text;
    swRasterGrid grid;
    swArray points; // XyzPoint
} XyzGrid;

static swResult readNumber(XyzGrid* xyz, const char* what, double* number)
{
    swText* text = &xyz->text;
    while (swPeekChar(text) == ',' || swPeekChar(text) == ';')
    {
        ++text->at;
    }
    const char* begin = text->at;
    while (text->at < text->lineEnd && strchr(" \t,;\r", *text->at) == NULL)
    {
        ++text->at;
    }
    swToken token = {begin, (int)(text->at - begin < 80 ? text->at - begin : 80)};
    if (!swParseToken(token, number))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the %s should be a number, not '%.*s'.", text->name,
                      text->line, what, token.size, token.text);
    }
    return SW_SUCCESS;
}

static swResult readPoint(XyzGrid* xyz)
{
    XyzPoint point = {.line = xyz->text.line};
    double value = 0.0;
    swResult result = readNumber(xyz, "x", &point.x);
    result = result != SW_SUCCESS ? result : readNumber(xyz, "y", &point.y);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (swHasPrefix(&xyz->text, "nan") || swHasPrefix(&xyz->text, "NaN"))
    {
        value = (double)NAN;
        xyz->text.at += 3;
    }
    else
    {
        result = readNumber(xyz, "value", &value);
    }
    point.value = (float)value;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (swPeekChar(&xyz->text) != '\0')
    {
        return swFail(xyz->text.host, SW_ERROR_FORMAT,
                      "%s:%d: a line holds x, y and value, and nothing behind them. A table of heights without places "
                      "needs the heading of an Esri ASCII grid.",
                      xyz->text.name, xyz->text.line);
    }
    XyzPoint* added = swAppendItems(xyz->text.host, &xyz->points, 1, sizeof(XyzPoint));
    if (added == NULL)
    {
        return swFail(xyz->text.host, SW_ERROR_NO_MEMORY, "No memory for the points of %s.", xyz->text.name);
    }
    *added = point;
    return SW_SUCCESS;
}

static swResult readPoints(XyzGrid* xyz)
{
    while (swNextLine(&xyz->text))
    {
        char first = swPeekChar(&xyz->text);
        bool isHeading = xyz->points.count == 0 && ((first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z'));
        if (first == '#' || first == '>' || isHeading)
        {
            continue;
        }
        swResult result = readPoint(xyz);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (xyz->points.count == 0)
    {
        return swFail(xyz->text.host, SW_ERROR_FORMAT, "%s holds no points; a line is x, y and value.", xyz->text.name);
    }
    return SW_SUCCESS;
}

static int compareNumbers(const void* a, const void* b)
{
    double first = *(const double*)a, second = *(const double*)b;
    return (first > second) - (first < second);
}

// The axis of sorted coordinates: the smallest step that is no rounding of the same place.
static void findAxis(double* places, size_t count, swRasterAxis* axis)
{
    qsort(places, count, sizeof(double), compareNumbers);
    double span = places[count - 1] - places[0];
    size_t distinct = 1;
    for (size_t i = 1; i < count; ++i)
    {
        distinct += places[i] - places[i - 1] > 1e-6 * span ? 1 : 0;
    }
    *axis = (swRasterAxis){.first = places[0], .spacing = 1.0, .count = 1};
    if (distinct < 2)
    {
        return;
    }
    double least = 0.05 * span / (double)(distinct - 1), step = span;
    for (size_t i = 1; i < count; ++i)
    {
        double difference = places[i] - places[i - 1];
        step = difference >= least && difference < step ? difference : step;
    }
    double cells = fmin(rint(span / step), 1e9);
    axis->count = (int)cells + 1;
    axis->spacing = span / cells;
}

// Whether x is a longitude: what the def says, or else numbers that can be nothing else.
static bool hasLongitudes(const XyzGrid* xyz)
{
    const XyzPoint* points = xyz->points.data;
    bool isPossible = true;
    for (size_t i = 0; i < xyz->points.count && isPossible; ++i)
    {
        isPossible = fabs(points[i].x) <= 360.0 && fabs(points[i].y) <= 90.0;
    }
    return xyz->grid.def->coordinates == SW_RASTER_DEGREES ||
           (xyz->grid.def->coordinates == SW_RASTER_BY_FILE && isPossible);
}

// Points on both sides of the 180th meridian: sorted, they leave a gap of more than half a turn. Those before it move
// on by a turn. Where nobody says that x is a longitude, the two sides must also meet at the meridian.
static void joinLongitudes(XyzGrid* xyz, double* places)
{
    size_t count = xyz->points.count;
    XyzPoint* points = xyz->points.data;
    for (size_t i = 0; i < count; ++i)
    {
        places[i] = points[i].x;
    }
    qsort(places, count, sizeof(double), compareNumbers);
    bool isMeeting = places[0] + 360.0 - places[count - 1] <= 1.0;
    for (size_t i = 1; i < count && (isMeeting || xyz->grid.def->coordinates == SW_RASTER_DEGREES); ++i)
    {
        double before = places[i - 1];
        if (places[i] - before > 180.0)
        {
            for (size_t k = 0; k < count; ++k)
            {
                points[k].x += points[k].x <= before ? 360.0 : 0.0;
            }
            return;
        }
    }
}

static swResult findAxes(XyzGrid* xyz)
{
    size_t count = xyz->points.count;
    const XyzPoint* points = xyz->points.data;
    double* places = swAllocate(xyz->text.host, count * sizeof(double));
    if (places == NULL)
    {
        return swFail(xyz->text.host, SW_ERROR_NO_MEMORY, "No memory for the points of %s.", xyz->text.name);
    }
    if (hasLongitudes(xyz))
    {
        joinLongitudes(xyz, places);
    }
    for (int side = 0; side < 2; ++side)
    {
        for (size_t i = 0; i < count; ++i)
        {
            places[i] = side == 0 ? points[i].x : points[i].y;
        }
        findAxis(places, count, side == 0 ? &xyz->grid.east : &xyz->grid.north);
    }
    swFree(xyz->text.host, places, count * sizeof(double));
    return SW_SUCCESS;
}

// The cell of a place, or -1 off the lattice.
static int findCell(const swRasterAxis* axis, double first, double place)
{
    double at = (place - first) / axis->spacing, cell = rint(at);
    return fabs(at - cell) <= SLACK && cell >= 0.0 && cell < axis->count ? (int)cell : -1;
}

// A cell that has a point already may have it again; a point of another place says that the lattice is another one.
static swResult checkRepeated(const XyzGrid* xyz, const XyzPoint* first, const XyzPoint* point)
{
    return first->x == point->x && first->y == point->y
               ? SW_SUCCESS
               : swFail(xyz->text.host, SW_ERROR_FORMAT,
                        "%s:%d: the point at %g, %g is in the cell of that at %g, %g on line %d, if points are on a "
                        "lattice of %g x %g; points that lie closer here than there must be gridded first.",
                        xyz->text.name, point->line, point->x, point->y, first->x, first->y, first->line,
                        xyz->grid.east.spacing, xyz->grid.north.spacing);
}

// `owners`: for each cell the number of its point, from 1 on; all 0 at first.
static swResult fillCells(const XyzGrid* xyz, double firstEast, float* values, uint32_t* owners)
{
    const swRasterAxis *east = &xyz->grid.east, *north = &xyz->grid.north;
    const XyzPoint* points = xyz->points.data;
    size_t width = (size_t)(east->end - east->begin), cells = swCountGridCells(&xyz->grid);
    int repeated = 0;
    for (size_t i = 0; i < cells; ++i)
    {
        values[i] = NAN;
    }
    for (size_t i = 0; i < xyz->points.count; ++i)
    {
        int column = findCell(east, firstEast, points[i].x), row = findCell(north, north->first, points[i].y);
        if (column < 0 || row < 0)
        {
            return swFail(xyz->text.host, SW_ERROR_FORMAT,
                          "%s:%d: the point at %g, %g is on no lattice of %g x %g; points of a survey must be gridded "
                          "first.",
                          xyz->text.name, points[i].line, points[i].x, points[i].y, east->spacing, north->spacing);
        }
        if (column < east->begin || column >= east->end || row < north->begin || row >= north->end)
        {
            continue;
        }
        size_t cell = (size_t)(row - north->begin) * width + (size_t)(column - east->begin);
        float* value = &values[cell];
        swResult result = owners[cell] > 0 ? checkRepeated(xyz, &points[owners[cell] - 1], &points[i]) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            return result;
        }
        owners[cell] = (uint32_t)i + 1;
        repeated += !isnan(*value) && *value != points[i].value ? 1 : 0;
        *value = isnan(*value) ? points[i].value : *value;
    }
    if (repeated > 0)
    {
        swLog(xyz->text.host, SW_LOG_WARNING,
              "%s: %d points lie where another one with another value was; the first counts.", xyz->text.name,
              repeated);
    }
    return SW_SUCCESS;
}

static swResult makeRaster(XyzGrid* xyz, swRaster** raster)
{
    swResult result = readPoints(xyz);
    result = result != SW_SUCCESS ? result : findAxes(xyz);
    double firstEast = xyz->grid.east.first;
    result = result != SW_SUCCESS ? result : swPlaceRasterGrid(&xyz->grid, 0);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t size = swCountGridCells(&xyz->grid) * sizeof(float);
    float* values = swAllocate(xyz->text.host, size);
    uint32_t* owners = swAllocateZero(xyz->text.host, size);
    if (values == NULL || owners == NULL)
    {
        result = swFail(xyz->text.host, SW_ERROR_NO_MEMORY, "No memory for the cells of %s, %zu bytes.", xyz->text.name,
                        2 * size);
    }
    result = result != SW_SUCCESS ? result : fillCells(xyz, firstEast, values, owners);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(&xyz->grid, values, raster);
    swFree(xyz->text.host, owners, size);
    swFree(xyz->text.host, values, size);
    return result;
}

swResult swReadXyzGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                       swRaster** raster)
{
    XyzGrid xyz = {.text = swOpenText(host, text->data, text->size, name),
                   .grid = {.host = host, .name = name, .def = def, .isDepth = def->isDepth}};
    swResult result = makeRaster(&xyz, raster);
    swFreeItems(host, &xyz.points, sizeof(XyzPoint));
    return result;
}
