// SPDX-License-Identifier: MIT
// Dimensions are known by their names, or by the standard_name or units of the variable that belongs to them; one that
// is neither time, frequency nor direction tells places apart. What writers name them: time, valid_time (ECMWF),
// time_index (MHKiT), ocean_time (WWM), waveTime (CDIP); frequency, freq, frequencyNumber, nfreq, waveFrequency;
// direction, dir, directionNumber, ndir, waveDirectionBins.

#include "files/netcdf_axes.h"

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"

#define MAX_PLACES 1000000
#define MAX_SPECTRA 4000000

static const char* const timeNames[] = {"time",     "valid_time", "time_index", "ocean_time", "wavetime",
                                        "datetime", "date",       "times",      "t",          NULL};
static const char* const frequencyNames[] = {"frequency",
                                             "freq",
                                             "frequencynumber",
                                             "frequencies",
                                             "freqs",
                                             "f",
                                             "wavefrequency",
                                             "nfreq",
                                             "wave_frequency",
                                             "spsig",
                                             "omega",
                                             "fr",
                                             "frequency_bins",
                                             "angular_frequency",
                                             NULL};
static const char* const directionNames[] = {
    "direction", "dir",   "directionnumber", "directions",        "dirs",  "theta",
    "ndir",      "spdir", "wave_direction",  "wavedirectionbins", "angle", NULL};

static swResult fail(const swNetcdfAxes* axes, const char* sentence)
{
    return swFail(axes->file.host, SW_ERROR_FORMAT, "%s: %s", axes->file.name, sentence);
}

// ---- dimensions ----

static swNetcdfRole findRoleByVariable(const swNetcdfFile* file, const char* dimensionName)
{
    char name[128], unit[128];
    swNetcdfVariable variable;
    if (!swFindNetcdfVariable(file, dimensionName, &variable))
    {
        return SW_NETCDF_PLACE;
    }
    swGetNetcdfText(file, variable.id, "standard_name", true, name, sizeof(name));
    swGetNetcdfText(file, variable.id, "units", true, unit, sizeof(unit));
    bool isDirection = strstr(name, "wave") != NULL && strstr(name, "direction") != NULL;
    return strcmp(name, "time") == 0 || strstr(unit, " since ") != NULL ? SW_NETCDF_TIME
           : strstr(name, "frequency") != NULL                          ? SW_NETCDF_FREQUENCY
           : isDirection                                                ? SW_NETCDF_DIRECTION
                                                                        : SW_NETCDF_PLACE;
}

static swNetcdfRole findRole(const swNetcdfFile* file, const char* name)
{
    char lower[257];
    size_t i = 0;
    for (; name[i] != '\0' && i < 256; ++i)
    {
        lower[i] = name[i] >= 'A' && name[i] <= 'Z' ? (char)(name[i] + 32) : name[i];
    }
    lower[i] = '\0';
    swNetcdfRole role = swIsOneOf(lower, timeNames)        ? SW_NETCDF_TIME
                        : swIsOneOf(lower, frequencyNames) ? SW_NETCDF_FREQUENCY
                        : swIsOneOf(lower, directionNames) ? SW_NETCDF_DIRECTION
                                                           : findRoleByVariable(file, name);
    bool isUnclear = role == SW_NETCDF_PLACE; // names such as wave_freq and direction_from
    return isUnclear && strstr(lower, "freq") != NULL                                           ? SW_NETCDF_FREQUENCY
           : isUnclear && (strstr(lower, "direction") != NULL || strncmp(lower, "dir", 3) == 0) ? SW_NETCDF_DIRECTION
                                                                                                : role;
}

bool swHasNetcdfRole(const swNetcdfAxes* axes, swNetcdfRole role)
{
    for (int i = 0; i < axes->main.dimensionCount; ++i)
    {
        char name[257];
        swGetNetcdfName(&axes->file, axes->main.dimensions[i], name);
        if (findRole(&axes->file, name) == role)
        {
            return true;
        }
    }
    return false;
}

static swResult checkLengths(const swNetcdfAxes* axes)
{
    if (axes->timeCount > MAX_SPECTRA / axes->placeCount)
    {
        return fail(axes, "it holds more than 4000000 spectra; cut it in time or space.");
    }
    if (axes->timeCount == 0)
    {
        return fail(axes, "it holds no time, so there is no spectrum in it.");
    }
    bool hasDirections = axes->directionAt >= 0;
    if (axes->frequencyAt < 0 || axes->frequencyCount < 2 || axes->frequencyCount > SW_NETCDF_MAX_FREQUENCIES ||
        (hasDirections && (axes->directionCount < 4 || axes->directionCount > SW_NETCDF_MAX_DIRECTIONS)))
    {
        return swFail(axes->file.host, SW_ERROR_FORMAT,
                      "%s: the spectra have %zu frequencies and %zu directions; 2 to %d and 4 to %d are read, in "
                      "dimensions named frequency and direction.",
                      axes->file.name, axes->frequencyAt >= 0 ? axes->frequencyCount : 0,
                      hasDirections ? axes->directionCount : 0, SW_NETCDF_MAX_FREQUENCIES, SW_NETCDF_MAX_DIRECTIONS);
    }
    return SW_SUCCESS;
}

swResult swFindNetcdfAxes(swNetcdfAxes* axes)
{
    axes->timeAt = axes->frequencyAt = axes->directionAt = -1;
    axes->timeCount = axes->placeCount = axes->frequencyCount = axes->directionCount = 1;
    for (int i = 0; i < axes->main.dimensionCount; ++i)
    {
        char name[257];
        swGetNetcdfName(&axes->file, axes->main.dimensions[i], name);
        size_t length = axes->lengths[i] = swGetNetcdfLength(&axes->file, axes->main.dimensions[i]);
        swNetcdfRole role = axes->roles[i] = findRole(&axes->file, name);
        if (role == SW_NETCDF_PLACE)
        {
            if (length == 0 || length > MAX_PLACES / axes->placeCount)
            {
                return fail(axes, "it holds no place, or more than 1000000 of them.");
            }
            axes->placeCount *= length;
            continue;
        }
        int* at = role == SW_NETCDF_TIME        ? &axes->timeAt
                  : role == SW_NETCDF_FREQUENCY ? &axes->frequencyAt
                                                : &axes->directionAt;
        if (*at >= 0)
        {
            return swFail(axes->file.host, SW_ERROR_FORMAT,
                          "%s: the spectra have two dimensions of one kind, the second being '%s'; one time, one "
                          "frequency and one direction are read.",
                          axes->file.name, name);
        }
        *at = i;
        *(role == SW_NETCDF_TIME        ? &axes->timeCount
          : role == SW_NETCDF_FREQUENCY ? &axes->frequencyCount
                                        : &axes->directionCount) = length;
    }
    return checkLengths(axes);
}

// ---- frequencies ----

bool swFindNetcdfFrequencies(const swNetcdfAxes* axes, swNetcdfVariable* variable)
{
    return swFindNetcdfCoordinate(&axes->file, axes->main.dimensions[axes->frequencyAt], frequencyNames, variable);
}

bool swFindNetcdfDirectionValues(const swNetcdfAxes* axes, swNetcdfVariable* variable)
{
    return swFindNetcdfCoordinate(&axes->file, axes->main.dimensions[axes->directionAt], directionNames, variable);
}

static bool readOverFrequencies(const swNetcdfAxes* axes, const char* name, double* values)
{
    swNetcdfVariable variable;
    size_t start = 0;
    return swFindNetcdfVariable(&axes->file, name, &variable) && variable.dimensionCount == 1 &&
           variable.dimensions[0] == axes->main.dimensions[axes->frequencyAt] &&
           swReadNetcdfBlock(&axes->file, &variable, &start, &axes->frequencyCount, values) == SW_SUCCESS;
}

// CF's `bounds`: the name of a variable of two edges for each value.
static bool readBounds(swNetcdfAxes* axes, const swNetcdfVariable* frequency)
{
    char name[257];
    swNetcdfVariable bounds;
    swGetNetcdfText(&axes->file, frequency->id, "bounds", false, name, sizeof(name));
    if (name[0] == '\0' || !swFindNetcdfVariable(&axes->file, name, &bounds) || bounds.dimensionCount != 2 ||
        bounds.dimensions[0] != axes->main.dimensions[axes->frequencyAt] ||
        swGetNetcdfLength(&axes->file, bounds.dimensions[1]) != 2)
    {
        return false;
    }
    for (size_t i = 0; i < axes->frequencyCount; ++i)
    {
        double edges[2];
        const size_t start[2] = {i, 0}, count[2] = {1, 2};
        if (swReadNetcdfBlock(&axes->file, &bounds, start, count, edges) != SW_SUCCESS)
        {
            return false;
        }
        axes->bandwidths[i] = fabs(edges[1] - edges[0]);
    }
    return true;
}

static bool readBands(swNetcdfAxes* axes, const swNetcdfVariable* frequency)
{
    static const char* const widths[] = {
        "waveBandwidth", "waveFrequencyBandwidth", "bandwidth", "frequency_bandwidth", "df", NULL};
    double low[SW_NETCDF_MAX_FREQUENCIES];
    bool isRead = false;
    if (readOverFrequencies(axes, "frequency1", low) && readOverFrequencies(axes, "frequency2", axes->bandwidths))
    {
        isRead = true;
        for (size_t i = 0; i < axes->frequencyCount; ++i)
        {
            axes->bandwidths[i] -= low[i];
        }
    }
    isRead = isRead || readBounds(axes, frequency);
    for (const char* const* name = widths; *name != NULL && !isRead; ++name)
    {
        isRead = readOverFrequencies(axes, *name, axes->bandwidths);
    }
    for (size_t i = 0; i < axes->frequencyCount && isRead; ++i)
    {
        isRead = axes->bandwidths[i] > 1e-9;
    }
    return isRead;
}

swResult swReadNetcdfFrequencies(swNetcdfAxes* axes)
{
    char unit[64];
    size_t start = 0;
    swNetcdfVariable variable;
    if (!swFindNetcdfFrequencies(axes, &variable) ||
        swReadNetcdfBlock(&axes->file, &variable, &start, &axes->frequencyCount, axes->frequencies) != SW_SUCCESS)
    {
        return fail(axes, "the frequencies have no values.");
    }
    char name[257];
    swGetNetcdfVariableName(&axes->file, variable.id, name);
    swGetNetcdfText(&axes->file, variable.id, "units", true, unit, sizeof(unit));
    if (strcmp(unit, "s") == 0 || strncmp(unit, "sec", 3) == 0)
    {
        return fail(axes, "its frequencies have the unit of periods, s; Hz and rad/s are read.");
    }
    axes->isAngular = strncmp(unit, "rad", 3) == 0 || strcmp(name, "spsig") == 0 || strcmp(name, "omega") == 0 ||
                      strcmp(name, "angular_frequency") == 0;
    axes->hasBands = readBands(axes, &variable);
    for (size_t i = 0; i < axes->frequencyCount; ++i)
    {
        axes->frequencies[i] /= axes->isAngular ? 2.0 * SW_PI : 1.0;
        axes->bandwidths[i] /= axes->isAngular ? 2.0 * SW_PI : 1.0;
    }
    return SW_SUCCESS;
}

// ---- rows and single values ----

// Where a variable's dimensions are those of the main one; the first entry of those that it has alone.
static void findStart(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start, size_t* at)
{
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        at[i] = 0;
        for (int j = 0; j < axes->main.dimensionCount; ++j)
        {
            at[i] = variable->dimensions[i] == axes->main.dimensions[j] ? start[j] : at[i];
        }
    }
}

double swReadNetcdfAt(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start)
{
    double value = (double)NAN;
    size_t at[SW_NETCDF_MAX_DIMENSIONS] = {0}, count[SW_NETCDF_MAX_DIMENSIONS];
    findStart(axes, variable, start, at);
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        count[i] = 1;
    }
    return swReadNetcdfBlock(&axes->file, variable, at, count, &value) == SW_SUCCESS ? value : (double)NAN;
}

bool swReadNetcdfRow(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start, double* values)
{
    bool hasFrequencies = false;
    size_t at[SW_NETCDF_MAX_DIMENSIONS] = {0}, count[SW_NETCDF_MAX_DIMENSIONS];
    findStart(axes, variable, start, at);
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        bool isFrequency = variable->dimensions[i] == axes->main.dimensions[axes->frequencyAt];
        count[i] = isFrequency ? axes->frequencyCount : 1;
        hasFrequencies = hasFrequencies || isFrequency;
    }
    return hasFrequencies && swReadNetcdfBlock(&axes->file, variable, at, count, values) == SW_SUCCESS;
}

// ---- losses ----

static void report(const swNetcdfFile* file, int count, size_t recordCount, const char* what)
{
    if (count > 0)
    {
        swLog(file->host, SW_LOG_WARNING, "%s: %d of %zu records %s.", file->name, count, recordCount, what);
    }
}

void swReportNetcdfLosses(const swNetcdfFile* file, const swNetcdfLosses* losses, size_t recordCount)
{
    report(file, losses->emptyCount, recordCount, "hold no value at all, as on land, and are left out");
    report(file, losses->timeCount, recordCount,
           "have no time, or one out of the years 1900 to 2199, and are left out");
    report(file, losses->beyondCount, recordCount, "hold densities that no sea has and are left out");
    report(file, losses->flaggedCount, recordCount, "are flagged as bad or missing by the file and are left out");
    report(file, losses->doubtfulCount, recordCount, "are flagged as questionable by the file; they are read");
}
