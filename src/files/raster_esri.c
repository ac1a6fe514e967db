// SPDX-License-Identifier: MIT
// Esri's ASCII grid: a heading of keys and numbers, then rows from north to south. A corner is that of the
// south-western cell, whose middle is half a cell farther.

#include <math.h>
#include <string.h>

#include "core/base/text.h"
#include "files/raster_grid.h"

#define MOST_CELLS 1000000

typedef struct EsriGrid
{
    swText text;
    swRasterGrid grid;
    double x, y, missing;
    bool hasColumns, hasRows, hasX, hasY, hasSizeX, hasSizeY, isMiddleX, isMiddleY, hasMissing;
} EsriGrid;

static char toLower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool isKey(swToken token, const char* word)
{
    int i = 0;
    while (i < token.size && word[i] != '\0' && toLower(token.text[i]) == word[i])
    {
        ++i;
    }
    return i == token.size && word[i] == '\0';
}

bool swIsEsriGrid(const swFileText* text)
{
    swText lines = swOpenText(NULL, text->data, text->size, "");
    if (!swNextLine(&lines))
    {
        return false;
    }
    swToken key = swNextToken(&lines);
    return isKey(key, "ncols") || isKey(key, "nrows");
}

static swResult readSize(EsriGrid* esri, double* spacing, bool* isThere)
{
    *isThere = true;
    swResult result = swReadNumber(&esri->text, "the size of cells", false, spacing);
    if (result == SW_SUCCESS && !(*spacing > 0.0))
    {
        result = swFail(esri->text.host, SW_ERROR_FORMAT, "%s:%d: the size of cells is %g; it must be above 0.",
                        esri->text.name, esri->text.line, *spacing);
    }
    return result;
}

static swResult readKey(EsriGrid* esri, swToken key)
{
    swRasterGrid* grid = &esri->grid;
    if (isKey(key, "ncols"))
    {
        esri->hasColumns = true;
        return swReadCount(&esri->text, "ncols", 1, MOST_CELLS, &grid->east.count);
    }
    if (isKey(key, "nrows"))
    {
        esri->hasRows = true;
        return swReadCount(&esri->text, "nrows", 1, MOST_CELLS, &grid->north.count);
    }
    bool isEast = isKey(key, "xllcorner") || isKey(key, "xllcenter");
    bool isNorth = isKey(key, "yllcorner") || isKey(key, "yllcenter");
    if ((isEast && esri->hasX) || (isNorth && esri->hasY))
    {
        return swFail(esri->text.host, SW_ERROR_FORMAT,
                      "%s:%d: '%.*s' tells the place a second time; a grid has its corner or its middle, once.",
                      esri->text.name, esri->text.line, key.size, key.text);
    }
    if (isEast)
    {
        esri->hasX = true;
        esri->isMiddleX = isKey(key, "xllcenter");
        return swReadNumber(&esri->text, "the western edge", false, &esri->x);
    }
    if (isNorth)
    {
        esri->hasY = true;
        esri->isMiddleY = isKey(key, "yllcenter");
        return swReadNumber(&esri->text, "the southern edge", false, &esri->y);
    }
    if (isKey(key, "nodata_value"))
    {
        esri->hasMissing = true;
        if (swHasPrefix(&esri->text, "nan") || swHasPrefix(&esri->text, "NaN"))
        {
            esri->missing = (double)NAN;
            esri->text.at += 3;
            return SW_SUCCESS;
        }
        return swReadNumber(&esri->text, "NODATA_value", false, &esri->missing);
    }
    if (isKey(key, "dx") || isKey(key, "cellsize"))
    {
        swResult result = readSize(esri, &grid->east.spacing, &esri->hasSizeX);
        if (isKey(key, "cellsize"))
        {
            grid->north.spacing = grid->east.spacing;
            esri->hasSizeY = true;
        }
        return result;
    }
    if (isKey(key, "dy"))
    {
        return readSize(esri, &grid->north.spacing, &esri->hasSizeY);
    }
    return swFail(esri->text.host, SW_ERROR_FORMAT,
                  "%s:%d: '%.*s' is no key of an Esri ASCII grid; those are ncols, nrows, xllcorner or xllcenter, "
                  "yllcorner or yllcenter, cellsize (or dx and dy) and NODATA_value.",
                  esri->text.name, esri->text.line, key.size, key.text);
}

static bool beginsNumber(char c)
{
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

static swResult readHeading(EsriGrid* esri)
{
    for (;;)
    {
        swResult result = swNeedLine(&esri->text, "rows of heights");
        if (result != SW_SUCCESS)
        {
            return result;
        }
        char first = swPeekChar(&esri->text);
        if (beginsNumber(first) || swIsMissingField((swToken){esri->text.at, 3}))
        {
            break;
        }
        result = readKey(esri, swNextToken(&esri->text));
        if (result == SW_SUCCESS && swPeekChar(&esri->text) != '\0')
        {
            result = swFail(esri->text.host, SW_ERROR_FORMAT,
                            "%s:%d: a line of the heading is a key and a number, and nothing behind them; decimals "
                            "follow a point, not a comma.",
                            esri->text.name, esri->text.line);
        }
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    const char* lacking = !esri->hasColumns ? "ncols"
                          : !esri->hasRows  ? "nrows"
                          : !esri->hasX     ? "xllcorner"
                          : !esri->hasY     ? "yllcorner"
                          : !esri->hasSizeX ? "cellsize"
                          : !esri->hasSizeY ? "dy"
                                            : NULL;
    if (lacking != NULL)
    {
        return swFail(esri->text.host, SW_ERROR_FORMAT, "%s:%d: the heading of the grid lacks %s.", esri->text.name,
                      esri->text.line, lacking);
    }
    swRasterGrid* grid = &esri->grid;
    grid->east.first = esri->x + (esri->isMiddleX ? 0.0 : 0.5 * grid->east.spacing);
    grid->north.first = esri->y + (esri->isMiddleY ? 0.0 : 0.5 * grid->north.spacing);
    return SW_SUCCESS;
}

// The next number of the rows, which may be wrapped at will.
static swResult readCell(EsriGrid* esri, float* value)
{
    swText* text = &esri->text;
    while (swPeekChar(text) == '\0' || *text->at == ',')
    {
        if (text->at < text->lineEnd)
        {
            ++text->at;
            continue;
        }
        swResult result = swNeedLine(text, "more heights");
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    swToken token = swNextToken(text);
    double number = 0.0;
    if (isKey(token, "nan"))
    {
        *value = NAN;
        return SW_SUCCESS;
    }
    if (!swParseToken(token, &number))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: '%.*s' should be a height.", text->name, text->line,
                      token.size, token.text);
    }
    bool isMissing = esri->hasMissing && (number == esri->missing || (float)number == (float)esri->missing);
    *value = isMissing ? NAN : (float)number;
    return SW_SUCCESS;
}

static swResult readRows(EsriGrid* esri, float* values)
{
    const swRasterAxis *east = &esri->grid.east, *north = &esri->grid.north;
    size_t width = (size_t)(east->end - east->begin);
    for (int row = north->count - 1; row >= 0; --row) // as the axis counts: the file begins in the north
    {
        for (int column = 0; column < east->count; ++column)
        {
            float value = 0.0f;
            swResult result = readCell(esri, &value);
            if (result != SW_SUCCESS)
            {
                return result;
            }
            if (row >= north->begin && row < north->end && column >= east->begin && column < east->end)
            {
                values[(size_t)(row - north->begin) * width + (size_t)(column - east->begin)] = value;
            }
        }
    }
    if (swPeekChar(&esri->text) != '\0' || swNextLine(&esri->text))
    {
        return swFail(esri->text.host, SW_ERROR_FORMAT,
                      "%s:%d: there are more heights than the %d x %d of the heading.", esri->text.name,
                      esri->text.line, east->count, north->count);
    }
    return SW_SUCCESS;
}

swResult swReadEsriGrid(const swHost* host, const swFileText* text, const char* name, const swRasterFileDef* def,
                        swRaster** raster)
{
    EsriGrid esri = {.text = swOpenText(host, text->data, text->size, name),
                     .grid = {.host = host, .name = name, .def = def, .isDepth = def->isDepth}};
    swResult result = readHeading(&esri);
    result = result != SW_SUCCESS ? result : swPlaceRasterGrid(&esri.grid, 0);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t size = swCountGridCells(&esri.grid) * sizeof(float);
    float* values = swAllocate(host, size);
    if (values == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the cells of %s, %zu bytes.", name, size);
    }
    result = readRows(&esri, values);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(&esri.grid, values, raster);
    swFree(host, values, size);
    return result;
}
