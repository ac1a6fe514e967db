// SPDX-License-Identifier: MIT
// Spectra by frequency and direction in netCDF files.
//
// WAVEWATCH III [WW3DG 2019]: efth(time, station, frequency, direction), m2 s rad-1, as shorts log10 of it; directions
// are where waves go, which standard_name says. frequency1 and frequency2 are the edges of bands.
//
// ERA5 [Hersbach 2020]: d2fd(time, direction, frequency, latitude, longitude) in any order, the logarithm to base 10 of
// m2 s rad-1. Where the coordinates are only numbers from 1 on, frequencies are 0.03453 * 1.1^i Hz and directions,
// where waves go, the middles of equal sectors from north on: 7.5 + 15 j degrees for 24.
//
// SWAN [SWAN 2024]: density(time, points, frequency, direction), m2 s rad-1, directions in radians. In its nautical
// convention they are where waves come from; its "to" is counted counterclockwise from the x-axis. As shorts each
// spectrum has its factor in scale_density.
//
// WWM [Roland 2012]: action AC(ocean_time, nbstation, ndir, nfreq) over SPSIG, rad/s, and SPDIR, radians
// counterclockwise from east where waves go. Energy is action times frequency: E(f) = AC * SPSIG * 2 pi. (Python's
// wavespectra takes SPDIR as bearings; WWM's own boundary files are read as here by ECMWF's WAM.)
//
// Python's wavespectra writes efth(time, site, freq, dir), m2 s degree-1, and takes directions as where waves come
// from. MET Norway's WAM writes SPEC(time, y, x, freq, direction), where waves go; Sofar directional_variance_density,
// degrees counterclockwise from east; the Field Research Facility at Duck directionalWaveEnergyDensity; MHKiT
// spectral_density.

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "files/netcdf_sea.h"

#define DEGREE (SW_PI / 180.0)
#define MAX_DENSITY 1e6 // m2/Hz/rad: what a measured sea takes

typedef struct Format
{
    const char* variable;  // NULL: known by its standard_name
    const char* dimension; // that it has; NULL: any
    swNetcdfWriter writer;
    bool isLogarithm, isAction, isPerDegree;
} Format;

// The first that fits.
static const Format formats[] = {
    {"d2fd", NULL, {"ECMWF", SW_DIRECTIONS_TO, true, false}, true, false, false},
    {"efth", "dir", {"wavespectra", SW_DIRECTIONS_FROM, false, false}, false, false, true},
    {"efth", NULL, {"WAVEWATCH III", SW_DIRECTIONS_TO, false, false}, false, false, false},
    {"density", NULL, {"SWAN", SW_DIRECTIONS_FROM, false, true}, false, false, false},
    {"AC", "ndir", {"WWM", SW_DIRECTIONS_TO_FROM_EAST, true, false}, false, true, false},
    {"SPEC", NULL, {"MET Norway", SW_DIRECTIONS_TO, false, false}, false, false, false},
    {"directional_variance_density", NULL, {"Sofar", SW_DIRECTIONS_TO_FROM_EAST, false, false}, false, false, true},
    {"spectral_density", NULL, {"MHKiT", SW_DIRECTIONS_FROM, false, false}, false, false, true},
    {"directionalWaveEnergyDensity", NULL, {"the FRF", SW_DIRECTIONS_FROM, false, false}, false, false, true},
    {NULL, NULL, {"most others", SW_DIRECTIONS_FROM, false, false}, false, false, false},
};

// Too large for a stack.
typedef struct Reader
{
    swNetcdfAxes* axes;
    swMeasuredSea* sea;
    const Format* format;
    bool isLogarithm;
    double offset; // that was added before the logarithm
    double unit;   // to m2 s rad-1
    bool hasScale;
    swNetcdfVariable scale; // of each spectrum, beside its own
    swNetcdfLosses losses;
    double directions[SW_NETCDF_MAX_DIRECTIONS];
    size_t blockSize;
    double* block;   // as the file has it
    double* density; // [frequency][direction]
} Reader;

// ---- the variable ----

static bool hasDimension(const swNetcdfAxes* axes, const char* name)
{
    for (int i = 0; i < axes->main.dimensionCount; ++i)
    {
        char other[257];
        swGetNetcdfName(&axes->file, axes->main.dimensions[i], other);
        if (strcmp(name, other) == 0)
        {
            return true;
        }
    }
    return false;
}

static bool isOfStandardName(const swNetcdfAxes* axes, int variable)
{
    static const char* const names[] = {"sea surface wave directional variance spectral density", NULL};
    char text[128];
    swGetNetcdfText(&axes->file, variable, "standard_name", true, text, sizeof(text));
    return swIsOneOf(text, names);
}

static bool isByDirection(const swNetcdfAxes* axes)
{
    return swHasNetcdfRole(axes, SW_NETCDF_FREQUENCY) && swHasNetcdfRole(axes, SW_NETCDF_DIRECTION);
}

// NULL if there is none; otherwise axes->main is the variable.
static const Format* findFormat(swNetcdfAxes* axes)
{
    const Format* format = formats;
    for (; format->variable != NULL; ++format)
    {
        if (swFindNetcdfVariable(&axes->file, format->variable, &axes->main) && isByDirection(axes) &&
            (format->dimension == NULL || hasDimension(axes, format->dimension)))
        {
            return format;
        }
    }
    int count = 0;
    for (int i = 0; nc_inq_nvars(axes->file.id, &count) == NC_NOERR && i < count; ++i)
    {
        if (isOfStandardName(axes, i) && swGetNetcdfVariable(&axes->file, i, &axes->main) && isByDirection(axes))
        {
            return format;
        }
    }
    return NULL;
}

bool swFindNetcdfSpectra(swNetcdfAxes* axes)
{
    return findFormat(axes) != NULL;
}

// ---- units ----

// 10^x, the same on every machine: a power of ten times a series for the rest, which is at most half a decade.
static double raiseTen(double x)
{
    double whole = floor(x + 0.5);
    double y = (x - whole) * 2.302585092994046;
    double term = 1.0, sum = 1.0;
    for (int i = 1; i < 24; ++i)
    {
        term *= y / i;
        sum += term;
    }
    for (int i = 0; i < (int)fabs(whole) && i < 60; ++i)
    {
        sum = whole < 0.0 ? sum / 10.0 : sum * 10.0;
    }
    return sum;
}

// Densities are per radian or per degree. Where the unit does not tell, the writer's is assumed with a warning.
static void findUnit(Reader* reader)
{
    const swNetcdfAxes* axes = reader->axes;
    char unit[64];
    swGetNetcdfText(&axes->file, axes->main.id, "units", true, unit, sizeof(unit));
    bool isLog10 = strncmp(unit, "log10", 5) == 0;
    reader->isLogarithm = reader->format->isLogarithm || isLog10;
    reader->offset = isLog10 && strstr(unit, "1e 12") != NULL ? 1e-12 : 0.0; // "1E-12" as words
    bool isPerDegree = strstr(unit, "deg") != NULL;
    bool isTold = isPerDegree || strstr(unit, "rad") != NULL || reader->isLogarithm || reader->format->isAction;
    if (!isTold)
    {
        isPerDegree = reader->format->isPerDegree;
        swLog(
            axes->file.host, SW_LOG_WARNING,
            "%s: the unit of its densities, '%s', does not tell whether they are per radian or per degree. As in files "
            "of %s they are taken per %s.",
            axes->file.name, unit, reader->format->writer.name, isPerDegree ? "degree" : "radian");
    }
    const char* radian = strstr(unit, "rad");
    bool isOfFrequency =
        radian != NULL && (isPerDegree || strstr(radian + 1, "rad") != NULL || (radian[3] == ' ' && radian[4] == '2'));
    if (axes->isAngular && strstr(unit, "hz") == NULL && !isOfFrequency && !reader->format->isAction)
    {
        swLog(
            axes->file.host, SW_LOG_WARNING,
            "%s: its frequencies are in rad/s, and the unit of its densities, '%s', does not tell whether they are per "
            "rad/s or per Hz. They are taken per rad/s.",
            axes->file.name, unit);
    }
    reader->unit = reader->format->isAction ? 1.0 : swFindNetcdfUnit(axes, unit) * (isPerDegree ? 1.0 / DEGREE : 1.0);
}

// ---- coordinates ----

// 1, 2, 3, ... or 0, 1, 2, ...
static bool areNumbers(const double* values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
    {
        if (values[i] != values[0] + (double)i)
        {
            return false;
        }
    }
    return values[0] == 1.0 || values[0] == 0.0;
}

// ECMWF's, where the file only counts.
static swResult readFrequencies(swNetcdfAxes* axes, bool isCounted)
{
    swNetcdfVariable variable;
    bool isThere = swFindNetcdfFrequencies(axes, &variable);
    swResult result = isThere || !isCounted ? swReadNetcdfFrequencies(axes) : SW_SUCCESS;
    if (result == SW_SUCCESS && isCounted && (!isThere || areNumbers(axes->frequencies, axes->frequencyCount)))
    {
        double frequency = 0.03453;
        for (size_t i = 0; i < axes->frequencyCount; ++i, frequency *= 1.1)
        {
            axes->frequencies[i] = frequency;
        }
        axes->hasBands = axes->isAngular = false;
    }
    return result;
}

// Degrees or radians: by the unit, or by how far the values reach.
static double findDegrees(const Reader* reader, int variable)
{
    char unit[64], name[257];
    const swNetcdfAxes* axes = reader->axes;
    swGetNetcdfText(&axes->file, variable, "units", true, unit, sizeof(unit));
    swGetNetcdfVariableName(&axes->file, variable, name);
    if (strncmp(unit, "rad", 3) == 0 || strcmp(name, "spdir") == 0)
    {
        return 1.0 / DEGREE;
    }
    double low = reader->directions[0], high = low;
    for (size_t i = 1; i < axes->directionCount; ++i)
    {
        low = reader->directions[i] < low ? reader->directions[i] : low;
        high = reader->directions[i] > high ? reader->directions[i] : high;
    }
    if (strncmp(unit, "deg", 3) != 0 && high - low < 2.0 * SW_PI + 0.01)
    {
        swLog(axes->file.host, SW_LOG_WARNING,
              "%s: its directions have no unit and reach from %g to %g: they are taken as radians.", axes->file.name,
              low, high);
        return 1.0 / DEGREE;
    }
    return 1.0;
}

static bool hasUnit(const swNetcdfAxes* axes, int variable)
{
    char unit[64];
    swGetNetcdfText(&axes->file, variable, "units", true, unit, sizeof(unit));
    return strncmp(unit, "deg", 3) == 0 || strncmp(unit, "rad", 3) == 0;
}

static swResult readDirections(Reader* reader, swDirectionMeaning asked)
{
    const swNetcdfAxes* axes = reader->axes;
    const swNetcdfFile* file = &axes->file;
    swNetcdfVariable variable;
    size_t start = 0;
    bool isThere = swFindNetcdfDirectionValues(axes, &variable) &&
                   swReadNetcdfBlock(file, &variable, &start, &axes->directionCount, reader->directions) == SW_SUCCESS;
    bool isCounted =
        reader->format->isLogarithm &&
        (!isThere || (!hasUnit(axes, variable.id) && areNumbers(reader->directions, axes->directionCount)));
    if (!isThere && !isCounted)
    {
        return swFail(file->host, SW_ERROR_FORMAT, "%s: the directions have no values.", file->name);
    }
    swMeasuredDirections directions =
        swFindNetcdfDirections(file, isThere ? variable.id : -1, axes->main.id, &reader->format->writer, asked);
    swMeasuredSea_SetDirections(reader->sea, &directions);
    double degrees = isCounted ? 1.0 : findDegrees(reader, variable.id);
    for (size_t i = 0; i < axes->directionCount; ++i)
    {
        double value =
            isCounted ? 360.0 * ((double)i + 0.5) / (double)axes->directionCount : reader->directions[i] * degrees;
        if (!(fabs(value) < 5000.0))
        {
            return swFail(file->host, SW_ERROR_FORMAT, "%s: a direction is missing or out of range.", file->name);
        }
        reader->directions[i] = swTurnDirection(directions.meaning, value);
    }
    return SW_SUCCESS;
}

// ---- spectra ----

// Block to density by frequency and direction, and the largest of it. False if all is missing.
static bool arrange(Reader* reader, double factor, double* largest)
{
    const swNetcdfAxes* axes = reader->axes;
    size_t frequencies = axes->frequencyCount, directions = axes->directionCount;
    bool isFrequencyFirst = axes->frequencyAt < axes->directionAt, hasData = false;
    *largest = 0.0;
    for (size_t i = 0; i < frequencies; ++i)
    {
        double scale = factor * (reader->format->isAction ? axes->frequencies[i] * 4.0 * SW_PI * SW_PI : reader->unit);
        for (size_t j = 0; j < directions; ++j)
        {
            double value = reader->block[isFrequencyFirst ? i * directions + j : j * frequencies + i];
            hasData = hasData || value == value;
            // ERA5 writes no number where a logarithm has none.
            value = reader->isLogarithm ? (value != value ? 0.0 : raiseTen(value) - reader->offset) : value;
            value = reader->isLogarithm && value < 0.0 ? 0.0 : value * scale;
            reader->density[i * directions + j] = value;
            *largest = value > *largest ? value : *largest;
        }
    }
    return hasData;
}

static swResult readSpectrum(Reader* reader, size_t time, size_t place, double seconds)
{
    const swNetcdfAxes* axes = reader->axes;
    size_t start[SW_NETCDF_MAX_DIMENSIONS], count[SW_NETCDF_MAX_DIMENSIONS];
    swFindNetcdfPlace(axes, place, start);
    for (int i = 0; i < axes->main.dimensionCount; ++i)
    {
        start[i] = i == axes->timeAt ? time : start[i];
        count[i] = i == axes->frequencyAt || i == axes->directionAt ? axes->lengths[i] : 1;
    }
    swResult result = swReadNetcdfBlock(&axes->file, &axes->main, start, count, reader->block);
    double factor = reader->hasScale ? swReadNetcdfAt(axes, &reader->scale, start) : 1.0;
    double largest = 0.0;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (factor != factor || !arrange(reader, factor, &largest))
    {
        ++reader->losses.emptyCount;
        return SW_SUCCESS;
    }
    if (largest > MAX_DENSITY)
    {
        ++reader->losses.beyondCount;
        return SW_SUCCESS;
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = (int)place;
    def.seconds = seconds;
    def.frequencyCount = (int)axes->frequencyCount;
    def.frequencies = axes->frequencies;
    def.bandwidths = axes->hasBands ? axes->bandwidths : NULL;
    def.directionCount = (int)axes->directionCount;
    def.directions = reader->directions;
    def.density = reader->density;
    return swMeasuredSea_AddSpectrum(reader->sea, &def);
}

static swResult readAll(Reader* reader)
{
    const swNetcdfAxes* axes = reader->axes;
    for (size_t i = 0; i < axes->timeCount; ++i)
    {
        double seconds = 0.0;
        if (!swReadNetcdfTime(axes, i, &seconds))
        {
            reader->losses.timeCount += (int)axes->placeCount;
            continue;
        }
        for (size_t j = 0; j < axes->placeCount; ++j)
        {
            swResult result = readSpectrum(reader, i, j, seconds);
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
    }
    return swFinishNetcdfSea(axes, &reader->losses, reader->sea);
}

static swResult readHead(Reader* reader, swDirectionMeaning asked)
{
    swNetcdfAxes* axes = reader->axes;
    reader->format = findFormat(axes);
    swResult result = swFindNetcdfAxes(axes);
    result = result == SW_SUCCESS ? readFrequencies(axes, reader->format->isLogarithm) : result;
    result = result == SW_SUCCESS ? readDirections(reader, asked) : result;
    result = result == SW_SUCCESS ? swReadNetcdfTimeUnit(axes) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    findUnit(reader);
    char name[257], scale[280];
    swGetNetcdfVariableName(&axes->file, axes->main.id, name);
    snprintf(scale, sizeof(scale), "scale_%s", name);
    reader->hasScale = swFindNetcdfVariable(&axes->file, scale, &reader->scale);
    return swAddNetcdfPlaces(axes, reader->sea);
}

static swResult readSea(Reader* reader, swDirectionMeaning asked)
{
    swResult result = readHead(reader, asked);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t values = reader->axes->frequencyCount * reader->axes->directionCount;
    reader->blockSize = 2 * values * sizeof(double);
    reader->block = swAllocate(reader->axes->file.host, reader->blockSize);
    if (reader->block == NULL)
    {
        return swFail(reader->axes->file.host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %s.",
                      reader->axes->file.name);
    }
    reader->density = reader->block + values;
    return readAll(reader);
}

swResult swReadNetcdfSpectra(swNetcdfAxes* axes, swDirectionMeaning asked, swMeasuredSea* sea)
{
    const swHost* host = axes->file.host;
    Reader* reader = swAllocateZero(host, sizeof(*reader));
    if (reader == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", axes->file.name);
    }
    reader->axes = axes;
    reader->sea = sea;
    swResult result = readSea(reader, asked);
    swFree(host, reader->block, reader->blockSize);
    swFree(host, reader, sizeof(*reader));
    return result;
}
