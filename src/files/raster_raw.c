// SPDX-License-Identifier: MIT
// Numbers without a heading, of a size that the caller states. Lowest byte first, whatever the machine.

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/raster_grid.h"

static size_t getNumberSize(swRasterNumbers numbers)
{
    return numbers == SW_RASTER_FLOAT32 ? 4 : 2;
}

static float decode(swRasterNumbers numbers, const unsigned char* bytes)
{
    uint32_t word = (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8;
    if (numbers == SW_RASTER_UINT16)
    {
        return (float)word;
    }
    if (numbers == SW_RASTER_INT16)
    {
        return (float)((int32_t)word - (word >= 0x8000u ? 0x10000 : 0));
    }
    word |= (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    float value;
    memcpy(&value, &word, sizeof(value));
    return value;
}

static swResult checkSize(const swRasterGrid* grid, FILE* file)
{
    const swRasterFileDef* def = grid->def;
    long long expected = (long long)def->rawWidth * (long long)def->rawHeight * (long long)getNumberSize(def->numbers);
    if (fseek(file, 0, SEEK_END) != 0)
    {
        return swFail(grid->host, SW_ERROR_FILE, "Cannot read %s: %s", grid->name, strerror(errno));
    }
    long long size = (long long)ftell(file);
    if (size != expected)
    {
        return swFail(
            grid->host, SW_ERROR_FORMAT,
            "%s has %lld bytes; %d x %d numbers of %zu bytes are %lld. Set rawWidth, rawHeight and numbers of "
            "swRasterFileDef to what the file holds.",
            grid->name, size, def->rawWidth, def->rawHeight, getNumberSize(def->numbers), expected);
    }
    return SW_SUCCESS;
}

static swResult readRows(const swRasterGrid* grid, FILE* file, float* values)
{
    const swRasterFileDef* def = grid->def;
    size_t numberSize = getNumberSize(def->numbers);
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    unsigned char* bytes = swAllocate(grid->host, width * numberSize);
    if (bytes == NULL)
    {
        return swFail(grid->host, SW_ERROR_NO_MEMORY, "No memory for a row of %s.", grid->name);
    }
    swImageRows rows = swGetImageRows(grid);
    swResult result = SW_SUCCESS;
    for (int row = rows.first; row < rows.end && result == SW_SUCCESS; ++row)
    {
        long long at = ((long long)row * def->rawWidth + grid->east.begin) * (long long)numberSize;
        if (fseek(file, (long)at, SEEK_SET) != 0 || fread(bytes, numberSize, width, file) != width)
        {
            result = swFail(grid->host, SW_ERROR_FILE, "Cannot read row %d of %s.", row, grid->name);
        }
        for (size_t i = 0; i < width && result == SW_SUCCESS; ++i)
        {
            values[(size_t)(row - rows.first) * width + i] = decode(def->numbers, bytes + i * numberSize);
        }
    }
    swFree(grid->host, bytes, width * numberSize);
    return result;
}

static swResult readOpen(swRasterGrid* grid, FILE* file, swRaster** raster)
{
    const double unknown[2] = {(double)NAN, (double)NAN};
    swResult result = checkSize(grid, file);
    result = result != SW_SUCCESS
                 ? result
                 : swPlaceImageGrid(grid, grid->def->rawWidth, grid->def->rawHeight, unknown, unknown, 0);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    float* values = swAllocateCells(grid, &result);
    result = result != SW_SUCCESS ? result : readRows(grid, file, values);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(grid, values, raster);
    swFreeCells(grid, values);
    return result;
}

swResult swReadRawGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    swRasterGrid grid = {.host = host, .name = path, .def = def, .isDepth = def->isDepth};
    FILE* file = fopen(path, "rb");
    if (file == NULL)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot read %s: %s", path, strerror(errno));
    }
    swResult result = readOpen(&grid, file, raster);
    fclose(file);
    return result;
}
