// SPDX-License-Identifier: MIT
// A netCDF variable over an axis of x or longitude and one of y or latitude. The coordinates are the middles of cells,
// however the grid is registered.

#include <math.h>
#include <netcdf.h>
#include <string.h>

#include "files/netcdf_file.h"
#include "files/netcdf_rasters.h"
#include "files/raster_grid.h"

// An axis may be printed with few digits: how far its steps may be from even, in steps.
#define SLACK 0.05

#define ROWS_AT_ONCE 64

typedef struct NetcdfGrid
{
    swNetcdfFile file;
    swRasterGrid grid;
    swNetcdfVariable values, axes[2]; // of the values' dimensions
    bool isEastFirst;                 // the first dimension is x
    bool isFalling[2];                // of east and north
    bool hasLayers;                   // a variable has several times or depths
    char unit;
    double size;        // metres of one of the values' units; below 0 if they count northwards
    double least, most; // what the file says that its values lie between
} NetcdfGrid;

static bool isAxis(const swNetcdfFile* file, const swNetcdfVariable* axis, bool isEast)
{
    static const char* const easts[] = {"x", "lon", "longitude", "easting", "nx", "xc", NULL};
    static const char* const norths[] = {"y", "lat", "latitude", "northing", "ny", "yc", NULL};
    char name[257];
    swGetNetcdfVariableName(file, axis->id, name);
    return swIsOneOf(name, isEast ? easts : norths);
}

// The last two dimensions; those before them, such as a time, have one place each.
static bool findAxes(NetcdfGrid* reader, const swNetcdfVariable* variable, swNetcdfVariable axes[2], bool* isEastFirst)
{
    static const char* const none[] = {NULL};
    int first = variable->dimensionCount - 2;
    if (first < 0 || !swFindNetcdfCoordinate(&reader->file, variable->dimensions[first], none, &axes[0]) ||
        !swFindNetcdfCoordinate(&reader->file, variable->dimensions[first + 1], none, &axes[1]))
    {
        return false;
    }
    bool isUsual = isAxis(&reader->file, &axes[0], false) && isAxis(&reader->file, &axes[1], true);
    *isEastFirst = isAxis(&reader->file, &axes[0], true) && isAxis(&reader->file, &axes[1], false);
    bool isFlat = true;
    for (int i = 0; i < first; ++i)
    {
        isFlat = isFlat && swGetNetcdfLength(&reader->file, variable->dimensions[i]) == 1;
    }
    reader->hasLayers = reader->hasLayers || ((isUsual || *isEastFirst) && !isFlat);
    return (isUsual || *isEastFirst) && isFlat;
}

static swResult findValues(NetcdfGrid* reader)
{
    static const char* const usual[] = {"elevation", "z", "band1", "depth", "topo", NULL};
    const swNetcdfFile* file = &reader->file;
    const char* asked = reader->grid.def->variable;
    int count = 0, fitting = 0, found = -1;
    nc_inq_nvars(file->id, &count);
    bool isUsual = false;
    for (int i = 0; i < count; ++i)
    {
        swNetcdfVariable variable, axes[2];
        bool isEastFirst = false;
        char name[257], exact[NC_MAX_NAME + 1] = "";
        nc_inq_varname(file->id, i, exact);
        swGetNetcdfVariableName(file, i, name);
        if (!swGetNetcdfVariable(file, i, &variable) || !findAxes(reader, &variable, axes, &isEastFirst) ||
            (asked != NULL && strcmp(exact, asked) != 0))
        {
            continue;
        }
        bool isBetter = swIsOneOf(name, usual) && !isUsual;
        fitting += 1;
        if (found < 0 || isBetter)
        {
            found = i;
            isUsual = isUsual || isBetter;
        }
    }
    if (found < 0 && reader->hasLayers)
    {
        return swFail(file->host, SW_ERROR_FORMAT,
                      "%s: its variables over x and y have several times or depths; take one of them out, as `ncks -d "
                      "time,0` does.",
                      file->name);
    }
    if (found < 0 || (fitting > 1 && !isUsual))
    {
        return swFail(file->host, SW_ERROR_FORMAT,
                      "%s: %s%s%s over an axis of x or longitude and one of y or latitude, each with its coordinates%s",
                      file->name, found < 0 ? "there is no variable" : "several variables are",
                      found < 0 && asked != NULL ? " " : "", found < 0 && asked != NULL ? asked : "",
                      found < 0 ? "." : "; swRasterFileDef::variable names the one to read.");
    }
    swGetNetcdfVariable(file, found, &reader->values);
    findAxes(reader, &reader->values, reader->axes, &reader->isEastFirst);
    return SW_SUCCESS;
}

static swResult checkSteps(const NetcdfGrid* reader, const char* side, const double* places, size_t count, double step)
{
    for (size_t i = 1; i < count; ++i)
    {
        if (!(fabs(places[i] - places[0] - step * (double)i) <= SLACK * fabs(step)))
        {
            return swFail(
                reader->file.host, SW_ERROR_FORMAT,
                "%s: the axis towards the %s is uneven or not finite at number %zu, %g; a raster's cells are all "
                "alike. Regrid it first.",
                reader->file.name, side, i + 1, places[i]);
        }
    }
    return SW_SUCCESS;
}

static bool isLongitude(const NetcdfGrid* reader, const swNetcdfVariable* axis)
{
    char unit[64], name[257];
    swGetNetcdfText(&reader->file, axis->id, "units", true, unit, sizeof(unit));
    swGetNetcdfVariableName(&reader->file, axis->id, name);
    return strncmp(unit, "deg", 3) == 0 || (unit[0] == '\0' && strncmp(name, "lon", 3) == 0);
}

// Metres of one of an axis' units, 1 of degrees and where nothing is said.
static swResult findAxisSize(NetcdfGrid* reader, const swNetcdfVariable* axis, const char* side, double* size)
{
    char unit[64];
    swGetNetcdfText(&reader->file, axis->id, "units", true, unit, sizeof(unit));
    double known = swFindRasterUnit(unit);
    *size = known > 0.0 ? known : 1.0;
    bool isMetric = known > 0.0 || strncmp(unit, "met", 3) == 0 || strncmp(unit, "deg", 3) == 0;
    if (!isMetric && reader->grid.def->coordinates == SW_RASTER_BY_FILE)
    {
        return swFail(reader->file.host, SW_ERROR_FORMAT,
                      "%s: the axis towards the %s counts in '%s', which is neither a length nor degrees that are "
                      "known here; convert it, or say by swRasterFileDef::coordinates (in scenes coordinates) what it "
                      "counts.",
                      reader->file.name, side, unit);
    }
    return SW_SUCCESS;
}

static swResult readAxis(NetcdfGrid* reader, const swNetcdfVariable* variable, bool isEast)
{
    const swHost* host = reader->file.host;
    const char* side = isEast ? "east" : "north";
    swRasterAxis* axis = isEast ? &reader->grid.east : &reader->grid.north;
    size_t count = swGetNetcdfLength(&reader->file, variable->dimensions[0]), start = 0;
    if (count < 1 || count > 10000000)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s: the axis towards the %s has %zu places.", reader->file.name, side,
                      count);
    }
    double* places = swAllocate(host, count * sizeof(double));
    if (places == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for an axis of %s.", reader->file.name);
    }
    swResult result = swReadNetcdfBlock(&reader->file, variable, &start, &count, places);
    if (result == SW_SUCCESS && isEast && isLongitude(reader, variable))
    {
        swUnwrapLongitudes(places, count);
    }
    double size = 1.0;
    result = result != SW_SUCCESS ? result : findAxisSize(reader, variable, side, &size);
    for (size_t i = 0; i < count && size != 1.0; ++i)
    {
        places[i] *= size;
    }
    double step = count > 1 ? (places[count - 1] - places[0]) / (double)(count - 1) : 1.0;
    if (result == SW_SUCCESS && !(isfinite(places[0]) && isfinite(step) && step != 0.0))
    {
        result = swFail(host, SW_ERROR_FORMAT, "%s: the axis towards the %s does not run anywhere.", reader->file.name,
                        side);
    }
    result = result != SW_SUCCESS ? result : checkSteps(reader, side, places, count, step);
    reader->isFalling[isEast ? 0 : 1] = step < 0.0;
    *axis =
        (swRasterAxis){.first = step < 0.0 ? places[count - 1] : places[0], .spacing = fabs(step), .count = (int)count};
    swFree(host, places, count * sizeof(double));
    return result;
}

static bool saysNorthward(const NetcdfGrid* reader, const char* attribute)
{
    char text[256];
    swGetNetcdfText(&reader->file, reader->values.id, attribute, true, text, sizeof(text));
    return strstr(text, "northward") != NULL || strstr(text, "meridional") != NULL;
}

// Currents and winds in files count northwards, z is south. A scale of the def's own counts instead.
static void turnNorthward(NetcdfGrid* reader)
{
    static const char* const usual[] = {"v", "vo", "v10", "v10n", "vwnd", "vgrd", "vgos", "vwind", NULL};
    char name[257], standard[64];
    swGetNetcdfVariableName(&reader->file, reader->values.id, name);
    swGetNetcdfText(&reader->file, reader->values.id, "standard_name", true, standard, sizeof(standard));
    if (reader->grid.def->scale != 1.0)
    {
        return;
    }
    if (saysNorthward(reader, "standard_name") || saysNorthward(reader, "long_name"))
    {
        reader->size = -reader->size;
        swLog(reader->file.host, SW_LOG_INFO, "%s: %s counts northwards; it is turned to count southwards, as z does.",
              reader->file.name, name);
    }
    else if (standard[0] == '\0' && swIsOneOf(name, usual))
    {
        swLog(reader->file.host, SW_LOG_WARNING,
              "%s does not say which way %s counts; it is taken to count southwards, as z does. If it counts "
              "northwards, give it a standard_name such as northward_sea_water_velocity, or set "
              "swRasterFileDef::scale to -1.",
              reader->file.name, name);
    }
}

static void findUnits(NetcdfGrid* reader)
{
    char unit[64], positive[64];
    const swNetcdfVariable* east = &reader->axes[reader->isEastFirst ? 0 : 1];
    swGetNetcdfText(&reader->file, east->id, "units", true, unit, sizeof(unit));
    bool isMetric =
        strncmp(unit, "met", 3) == 0 || (unit[0] != '\0' && strcmp(unit, "1") != 0 && swFindRasterUnit(unit) > 0.0);
    reader->unit = strncmp(unit, "deg", 3) == 0 ? 'd' : isMetric ? 'm' : 0;
    char name[257];
    swGetNetcdfVariableName(&reader->file, east->id, name);
    reader->unit = reader->unit == 0 && (strncmp(name, "lon", 3) == 0) ? 'd' : reader->unit;
    swGetNetcdfText(&reader->file, reader->values.id, "positive", true, positive, sizeof(positive));
    reader->grid.isDepth = reader->grid.def->isDepth || strcmp(positive, "down") == 0;
    swGetNetcdfText(&reader->file, reader->values.id, "units", true, unit, sizeof(unit));
    reader->size = swKnowRasterUnit(&reader->grid, unit);
    turnNorthward(reader);
}

static bool getRange(const NetcdfGrid* reader, const char* attribute, size_t count, double* numbers)
{
    nc_type type = NC_NAT;
    size_t length = 0;
    int file = reader->file.id, variable = reader->values.id;
    return nc_inq_att(file, variable, attribute, &type, &length) == NC_NOERR && length == count && type != NC_CHAR &&
           type <= NC_UINT64 && type != NC_STRING && nc_get_att_double(file, variable, attribute, numbers) == NC_NOERR;
}

// valid_range, or valid_min and valid_max: what lies outside is not known. They count as the values are stored, but
// for those of whole numbers that are given as floats.
static void findRange(NetcdfGrid* reader)
{
    double range[2] = {-(double)INFINITY, (double)INFINITY};
    reader->least = range[0];
    reader->most = range[1];
    const char* attribute = "valid_range";
    if (!getRange(reader, attribute, 2, range))
    {
        bool hasLeast = getRange(reader, "valid_min", 1, &range[0]);
        bool hasMost = getRange(reader, "valid_max", 1, &range[1]);
        if (!hasLeast && !hasMost)
        {
            return;
        }
        attribute = hasLeast ? "valid_min" : "valid_max";
    }
    nc_type stored = NC_NAT, type = NC_NAT;
    nc_inq_vartype(reader->file.id, reader->values.id, &stored);
    nc_inq_atttype(reader->file.id, reader->values.id, attribute, &type);
    bool isMeant = (type == NC_FLOAT || type == NC_DOUBLE) && stored != NC_FLOAT && stored != NC_DOUBLE;
    double scale = isMeant ? 1.0 : reader->values.scale, offset = isMeant ? 0.0 : reader->values.offset;
    double a = offset + scale * range[0], b = offset + scale * range[1];
    double slack = 1e-6 * fabs(scale);
    reader->least = fmin(a, b) - slack;
    reader->most = fmax(a, b) + slack;
}

// From the file's order of rows to south first, west first.
static void keepRows(const NetcdfGrid* reader, size_t firstRow, size_t rowCount, const double* block, float* values)
{
    const swRasterAxis *east = &reader->grid.east, *north = &reader->grid.north;
    const swRasterAxis *rows = reader->isEastFirst ? east : north, *columns = reader->isEastFirst ? north : east;
    bool isRowFalling = reader->isFalling[reader->isEastFirst ? 0 : 1];
    bool isColumnFalling = reader->isFalling[reader->isEastFirst ? 1 : 0];
    size_t width = (size_t)(east->end - east->begin), columnCount = (size_t)(columns->end - columns->begin);
    size_t allRows = (size_t)(rows->end - rows->begin);
    for (size_t i = 0; i < rowCount; ++i)
    {
        size_t row = isRowFalling ? allRows - 1 - (firstRow + i) : firstRow + i;
        for (size_t j = 0; j < columnCount; ++j)
        {
            size_t column = isColumnFalling ? columnCount - 1 - j : j;
            size_t at = reader->isEastFirst ? column * width + row : row * width + column;
            double value = block[i * columnCount + j];
            bool isKnown = value >= reader->least && value <= reader->most;
            values[at] = isKnown ? (float)(reader->size == 1.0 ? value : reader->size * value) : NAN;
        }
    }
}

// The first place in the file of what is kept of an axis.
static size_t getStart(const swRasterAxis* axis, bool isFalling)
{
    return (size_t)(isFalling ? axis->count - axis->end : axis->begin);
}

static swResult readRows(NetcdfGrid* reader, double* block, float* values)
{
    const swRasterAxis* rows = reader->isEastFirst ? &reader->grid.east : &reader->grid.north;
    const swRasterAxis* columns = reader->isEastFirst ? &reader->grid.north : &reader->grid.east;
    size_t rowCount = (size_t)(rows->end - rows->begin);
    for (size_t first = 0; first < rowCount; first += ROWS_AT_ONCE)
    {
        size_t part = rowCount - first < ROWS_AT_ONCE ? rowCount - first : ROWS_AT_ONCE;
        size_t start[SW_NETCDF_MAX_DIMENSIONS] = {0}, count[SW_NETCDF_MAX_DIMENSIONS];
        int last = reader->values.dimensionCount - 1;
        for (int i = 0; i < last - 1; ++i)
        {
            count[i] = 1;
        }
        start[last - 1] = getStart(rows, reader->isFalling[reader->isEastFirst ? 0 : 1]) + first;
        start[last] = getStart(columns, reader->isFalling[reader->isEastFirst ? 1 : 0]);
        count[last - 1] = part;
        count[last] = (size_t)(columns->end - columns->begin);
        swResult result = swReadNetcdfBlock(&reader->file, &reader->values, start, count, block);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        keepRows(reader, first, part, block, values);
    }
    return SW_SUCCESS;
}

static swResult readCells(NetcdfGrid* reader, swRaster** raster)
{
    const swHost* host = reader->file.host;
    const swRasterAxis* columns = reader->isEastFirst ? &reader->grid.north : &reader->grid.east;
    size_t size = swCountGridCells(&reader->grid) * sizeof(float);
    size_t blockSize = ROWS_AT_ONCE * (size_t)(columns->end - columns->begin) * sizeof(double);
    float* values = swAllocate(host, size);
    double* block = swAllocate(host, blockSize);
    swResult result = SW_SUCCESS;
    if (values == NULL || block == NULL)
    {
        result = swFail(host, SW_ERROR_NO_MEMORY, "No memory for the cells of %s, %zu bytes.", reader->file.name, size);
    }
    result = result != SW_SUCCESS ? result : readRows(reader, block, values);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(&reader->grid, values, raster);
    swFree(host, values, size);
    swFree(host, block, blockSize);
    return result;
}

static swResult read(NetcdfGrid* reader, swRaster** raster)
{
    swResult result = findValues(reader);
    for (int i = 0; i < 2 && result == SW_SUCCESS; ++i)
    {
        result = readAxis(reader, &reader->axes[i], (i == 0) == reader->isEastFirst);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    findUnits(reader);
    findRange(reader);
    result = swPlaceRasterGrid(&reader->grid, reader->unit);
    return result != SW_SUCCESS ? result : readCells(reader, raster);
}

swResult swReadNetcdfGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    NetcdfGrid reader = {.file = {.host = host, .name = path, .id = -1},
                         .grid = {.host = host, .name = path, .def = def}};
    swResult result = swOpenNetcdfFile(&reader.file);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    result = swIsGmtGrid(&reader.file) ? swReadGmtGrid(&reader.file, def, raster) : read(&reader, raster);
    swCloseNetcdfFile(&reader.file);
    return result;
}
