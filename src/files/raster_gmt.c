// SPDX-License-Identifier: MIT
// netCDF as GMT 3 wrote it, and GDAL's GMT driver still does (such as ETOPO's *_gdal.grd): no axes but the ends of each
// (x_range, y_range), the numbers of nodes, and the values in one long row, the northern edge first. The ends are those
// of the outermost nodes, or of the outermost cells where node_offset is 1, half a cell farther.

#include <math.h>
#include <netcdf.h>
#include <string.h>

#include "files/netcdf_rasters.h"
#include "files/raster_grid.h"

typedef struct GmtGrid
{
    swNetcdfFile file;
    swRasterGrid grid;
    swNetcdfVariable values;
    char unit;
} GmtGrid;

bool swIsGmtGrid(const swNetcdfFile* file)
{
    swNetcdfVariable found[4];
    return swFindNetcdfVariable(file, "x_range", &found[0]) && swFindNetcdfVariable(file, "y_range", &found[1]) &&
           swFindNetcdfVariable(file, "dimension", &found[2]) && swFindNetcdfVariable(file, "z", &found[3]) &&
           found[3].dimensionCount == 1;
}

static swResult readPair(const GmtGrid* reader, const char* name, double pair[2])
{
    swNetcdfVariable variable;
    const size_t start = 0, count = 2;
    if (!swFindNetcdfVariable(&reader->file, name, &variable) || variable.dimensionCount != 1 ||
        swGetNetcdfLength(&reader->file, variable.dimensions[0]) != 2)
    {
        return swFail(reader->file.host, SW_ERROR_FORMAT, "%s: %s should hold two numbers.", reader->file.name, name);
    }
    return swReadNetcdfBlock(&reader->file, &variable, &start, &count, pair);
}

static bool makeAxis(const double range[2], double count, bool isOfCells, swRasterAxis* axis)
{
    double span = range[1] - range[0];
    bool isAxis = count >= 1.0 && count <= 1e7 && span >= 0.0 && isfinite(range[0]) && isfinite(span);
    if (!isAxis)
    {
        return false;
    }
    axis->count = (int)count;
    double steps = isOfCells ? axis->count : axis->count - 1;
    axis->spacing = steps > 0.0 ? span / steps : 1.0;
    axis->first = range[0] + (isOfCells ? 0.5 * axis->spacing : 0.0);
    return axis->spacing > 0.0;
}

static swResult readAxes(GmtGrid* reader)
{
    double east[2], north[2], counts[2];
    swResult result = readPair(reader, "x_range", east);
    result = result != SW_SUCCESS ? result : readPair(reader, "y_range", north);
    result = result != SW_SUCCESS ? result : readPair(reader, "dimension", counts);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    int isOfCells = 0;
    nc_get_att_int(reader->file.id, reader->values.id, "node_offset", &isOfCells);
    size_t length = swGetNetcdfLength(&reader->file, reader->values.dimensions[0]);
    if (!makeAxis(east, counts[0], isOfCells == 1, &reader->grid.east) ||
        !makeAxis(north, counts[1], isOfCells == 1, &reader->grid.north) ||
        (size_t)reader->grid.east.count * (size_t)reader->grid.north.count != length)
    {
        return swFail(reader->file.host, SW_ERROR_FORMAT,
                      "%s: %g x %g nodes from %g to %g and from %g to %g do not fit %zu values.", reader->file.name,
                      counts[0], counts[1], east[0], east[1], north[0], north[1], length);
    }
    return SW_SUCCESS;
}

static void findUnit(GmtGrid* reader)
{
    swNetcdfVariable range;
    char unit[64] = "";
    if (swFindNetcdfVariable(&reader->file, "x_range", &range))
    {
        swGetNetcdfText(&reader->file, range.id, "units", true, unit, sizeof(unit));
    }
    bool isDegrees = strstr(unit, "deg") != NULL || strncmp(unit, "lon", 3) == 0;
    reader->unit = isDegrees ? 'd' : strcmp(unit, "m") == 0 || strncmp(unit, "met", 3) == 0 ? 'm' : 0;
}

static swResult readRows(const GmtGrid* reader, double* row, float* values)
{
    const swRasterGrid* grid = &reader->grid;
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    swImageRows rows = swGetImageRows(grid);
    swResult result = SW_SUCCESS;
    for (int i = rows.first; i < rows.end && result == SW_SUCCESS; ++i)
    {
        size_t start = (size_t)i * (size_t)grid->east.count + (size_t)grid->east.begin;
        result = swReadNetcdfBlock(&reader->file, &reader->values, &start, &width, row);
        for (size_t k = 0; k < width && result == SW_SUCCESS; ++k)
        {
            values[(size_t)(i - rows.first) * width + k] = (float)row[k];
        }
    }
    return result;
}

static swResult readCells(GmtGrid* reader, swRaster** raster)
{
    const swHost* host = reader->file.host;
    swResult result = SW_SUCCESS;
    size_t rowSize = (size_t)(reader->grid.east.end - reader->grid.east.begin) * sizeof(double);
    float* values = swAllocateCells(&reader->grid, &result);
    double* row = result == SW_SUCCESS ? swAllocate(host, rowSize) : NULL;
    if (result == SW_SUCCESS && row == NULL)
    {
        result = swFail(host, SW_ERROR_NO_MEMORY, "No memory for a row of %s.", reader->file.name);
    }
    result = result != SW_SUCCESS ? result : readRows(reader, row, values);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(&reader->grid, values, raster);
    swFree(host, row, rowSize);
    swFreeCells(&reader->grid, values);
    return result;
}

swResult swReadGmtGrid(const swNetcdfFile* file, const swRasterFileDef* def, swRaster** raster)
{
    GmtGrid reader = {
        .file = *file,
        .grid = {.host = file->host, .name = file->name, .def = def, .isDepth = def->isDepth, .isNorthFirst = true}};
    swFindNetcdfVariable(file, "z", &reader.values);
    bool isAsked = def->variable == NULL || strcmp(def->variable, "z") == 0;
    swResult result = isAsked ? readAxes(&reader)
                              : swFail(file->host, SW_ERROR_FORMAT, "%s: there is no variable %s; it has z alone.",
                                       file->name, def->variable);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    findUnit(&reader);
    result = swPlaceRasterGrid(&reader.grid, reader.unit);
    return result != SW_SUCCESS ? result : readCells(&reader, raster);
}
