// SPDX-License-Identifier: MIT
// Spectra by frequency and direction in netCDF files.
//
// WAVEWATCH III [WW3DG 2019]: efth(time, station, frequency, direction), m2 s rad-1. Whether directions are where waves go
// or come from is told by the direction's standard_name or long_name, "sea_surface_wave_to_direction" as a rule; they are
// degrees clockwise from north. frequency1 and frequency2 are the edges of bands.
//
// ERA5 [Hersbach 2020]: d2fd(time, direction, frequency, latitude, longitude) in any order, the logarithm to base 10 of
// m2 s rad-1. Where the coordinates are only numbers from 1 on, frequencies are 0.03453 * 1.1^i Hz and directions, where
// waves go, the middles of equal sectors from north on: 7.5 + 15 j degrees for 24.
//
// Dimensions are known by their names; one that is neither time, frequency nor direction tells places apart.

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "scene/measured_formats.h"
#include "scene/netcdf_file.h"
#include "scene/netcdf_header.h"

#define MAX_FREQUENCIES 1025
#define MAX_DIRECTIONS 720
#define MAX_PLACES 1000000
#define MAX_SPECTRA 4000000
#define DEGREE (SW_PI / 180.0)

typedef enum Role
{
    TIME,
    FREQUENCY,
    DIRECTION,
    PLACE
} Role;

// Too large for a stack.
typedef struct Reader
{
    swNetcdfFile file;
    swMeasuredSea* sea;
    swNetcdfVariable spectrum;
    bool isLogarithm;
    double unit; // to m2 s rad-1
    Role roles[SW_NETCDF_MAX_DIMENSIONS];
    size_t lengths[SW_NETCDF_MAX_DIMENSIONS];
    int timeAt, frequencyAt, directionAt; // indices of dimensions; -1: there is none
    size_t placeCount;
    double timeFactor; // s
    double timeOrigin; // s since 1970
    bool hasTime;
    swNetcdfVariable time;
    bool hasBands;
    double frequencies[MAX_FREQUENCIES];
    double bandwidths[MAX_FREQUENCIES];
    double directions[MAX_DIRECTIONS];
    size_t blockSize;
    double* block;   // as the file has it
    double* density; // [frequency][direction]
} Reader;

static swResult fail(const Reader* reader, const char* sentence)
{
    return swFail(reader->file.host, SW_ERROR_FORMAT, "%s: %s", reader->file.name, sentence);
}

// ---- the variable ----

static bool isOneOf(const char* name, const char* const* names)
{
    for (; *names != NULL; ++names)
    {
        if (strcmp(name, *names) == 0)
        {
            return true;
        }
    }
    return false;
}

static Role findRole(const char* name)
{
    static const char* const times[] = {"time", "valid_time", "Time", NULL};
    static const char* const frequencies[] = {"frequency", "freq", "frequencyNumber", "frequencies", "f", NULL};
    static const char* const directions[] = {"direction", "dir", "directionNumber", "directions", "theta", NULL};
    return isOneOf(name, times)         ? TIME
           : isOneOf(name, frequencies) ? FREQUENCY
           : isOneOf(name, directions)  ? DIRECTION
                                        : PLACE;
}

static bool findSpectrum(Reader* reader)
{
    int count = 0;
    reader->isLogarithm = swFindNetcdfVariable(&reader->file, "d2fd", &reader->spectrum);
    if (reader->isLogarithm || swFindNetcdfVariable(&reader->file, "efth", &reader->spectrum))
    {
        return true;
    }
    for (int i = 0; nc_inq_nvars(reader->file.id, &count) == NC_NOERR && i < count; ++i)
    {
        char name[NC_MAX_NAME + 1] = {0}, text[128];
        swGetNetcdfText(&reader->file, i, "standard_name", text, sizeof(text));
        if (strcmp(text, "sea surface wave directional variance spectral density") == 0 &&
            nc_inq_varname(reader->file.id, i, name) == NC_NOERR)
        {
            return swFindNetcdfVariable(&reader->file, name, &reader->spectrum);
        }
    }
    return false;
}

static swResult findDimensions(Reader* reader)
{
    reader->timeAt = reader->frequencyAt = reader->directionAt = -1;
    reader->placeCount = 1;
    for (int i = 0; i < reader->spectrum.dimensionCount; ++i)
    {
        char name[257];
        swGetNetcdfName(&reader->file, reader->spectrum.dimensions[i], name);
        reader->lengths[i] = swGetNetcdfLength(&reader->file, reader->spectrum.dimensions[i]);
        reader->roles[i] = findRole(name);
        int* at = reader->roles[i] == TIME        ? &reader->timeAt
                  : reader->roles[i] == FREQUENCY ? &reader->frequencyAt
                  : reader->roles[i] == DIRECTION ? &reader->directionAt
                                                  : NULL;
        if (at != NULL)
        {
            *at = i;
            continue;
        }
        if (reader->lengths[i] == 0 || reader->lengths[i] > MAX_PLACES / reader->placeCount)
        {
            return fail(reader, "it holds no place, or more than 1000000 of them.");
        }
        reader->placeCount *= reader->lengths[i];
    }
    if (reader->timeAt >= 0 && reader->lengths[reader->timeAt] > MAX_SPECTRA / reader->placeCount)
    {
        return fail(reader, "it holds more than 4000000 spectra; cut it in time or space.");
    }
    bool isWhole = reader->frequencyAt >= 0 && reader->directionAt >= 0;
    size_t frequencies = isWhole ? reader->lengths[reader->frequencyAt] : 0;
    size_t directions = isWhole ? reader->lengths[reader->directionAt] : 0;
    if (frequencies < 2 || frequencies > MAX_FREQUENCIES || directions < 4 || directions > MAX_DIRECTIONS)
    {
        return swFail(reader->file.host, SW_ERROR_FORMAT,
                      "%s: the spectra have %zu frequencies and %zu directions; 2 to %d and 4 to %d are read, in "
                      "dimensions named frequency and direction.",
                      reader->file.name, frequencies, directions, MAX_FREQUENCIES, MAX_DIRECTIONS);
    }
    return SW_SUCCESS;
}

// ---- coordinates ----

// Values of a coordinate; false if the file has none of that length.
static bool readCoordinate(const Reader* reader, int at, const char* name, double* values)
{
    swNetcdfVariable variable;
    size_t start = 0;
    return swFindNetcdfVariable(&reader->file, name, &variable) && variable.dimensionCount == 1 &&
           variable.dimensions[0] == reader->spectrum.dimensions[at] &&
           swReadNetcdfBlock(&reader->file, &variable, &start, &reader->lengths[at], values) == SW_SUCCESS;
}

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

static swResult readFrequencies(Reader* reader)
{
    char name[257];
    size_t count = reader->lengths[reader->frequencyAt];
    swGetNetcdfName(&reader->file, reader->spectrum.dimensions[reader->frequencyAt], name);
    bool isThere = readCoordinate(reader, reader->frequencyAt, name, reader->frequencies);
    if (reader->isLogarithm && (!isThere || areNumbers(reader->frequencies, count)))
    {
        double frequency = 0.03453;
        for (size_t i = 0; i < count; ++i, frequency *= 1.1)
        {
            reader->frequencies[i] = frequency;
        }
        return SW_SUCCESS;
    }
    double low[MAX_FREQUENCIES];
    reader->hasBands = readCoordinate(reader, reader->frequencyAt, "frequency1", low) &&
                       readCoordinate(reader, reader->frequencyAt, "frequency2", reader->bandwidths);
    for (size_t i = 0; i < count && reader->hasBands; ++i)
    {
        reader->bandwidths[i] -= low[i];
        reader->hasBands = reader->bandwidths[i] > 1e-9;
    }
    return isThere ? SW_SUCCESS : fail(reader, "the frequencies have no values.");
}

// Whether the coordinate says that waves come from there, whether it is in radians, and whether it says either.
static void describeDirections(const Reader* reader, const char* name, bool* isFrom, bool* isRadian, bool* hasUnit)
{
    char text[3][128] = {{0}};
    swNetcdfVariable variable;
    if (swFindNetcdfVariable(&reader->file, name, &variable))
    {
        swGetNetcdfText(&reader->file, variable.id, "standard_name", text[0], sizeof(text[0]));
        swGetNetcdfText(&reader->file, variable.id, "long_name", text[1], sizeof(text[1]));
        swGetNetcdfText(&reader->file, variable.id, "units", text[2], sizeof(text[2]));
    }
    bool isTo = strstr(text[0], "to direction") != NULL;
    *isFrom = !isTo && (strstr(text[0], "from direction") != NULL || strstr(text[1], "from") != NULL);
    *isRadian = strncmp(text[2], "rad", 3) == 0;
    *hasUnit = *isRadian || strncmp(text[2], "deg", 3) == 0;
}

static swResult readDirections(Reader* reader)
{
    char name[257];
    size_t count = reader->lengths[reader->directionAt];
    swGetNetcdfName(&reader->file, reader->spectrum.dimensions[reader->directionAt], name);
    bool isFrom = false, isRadian = false, hasUnit = false;
    bool isThere = readCoordinate(reader, reader->directionAt, name, reader->directions);
    describeDirections(reader, name, &isFrom, &isRadian, &hasUnit);
    bool isCounted = reader->isLogarithm && (!isThere || (!hasUnit && areNumbers(reader->directions, count)));
    if (!isThere && !isCounted)
    {
        return fail(reader, "the directions have no values.");
    }
    for (size_t i = 0; i < count; ++i)
    {
        double bearing = isCounted ? 360.0 * ((double)i + 0.5) / (double)count
                                   : reader->directions[i] * (isRadian ? 1.0 / DEGREE : 1.0);
        reader->directions[i] = (bearing + (isFrom && !isCounted ? 90.0 : -90.0)) * DEGREE;
        if (!(fabs(reader->directions[i]) < 100.0))
        {
            return fail(reader, "a direction is missing or out of range.");
        }
    }
    return SW_SUCCESS;
}

// "days since 1990-01-01 00:00:00"
static swResult readTimeUnit(Reader* reader)
{
    static const struct
    {
        const char* name;
        double seconds;
    } units[] = {{"day", 86400.0}, {"hour", 3600.0}, {"minute", 60.0}, {"second", 1.0}};
    char text[128], calendar[64], name[257] = "time";
    if (reader->timeAt >= 0)
    {
        swGetNetcdfName(&reader->file, reader->spectrum.dimensions[reader->timeAt], name);
    }
    reader->hasTime =
        swFindNetcdfVariable(&reader->file, name, &reader->time) && reader->time.dimensionCount <= 1 &&
        (reader->time.dimensionCount == 0 ||
         (reader->timeAt >= 0 && reader->time.dimensions[0] == reader->spectrum.dimensions[reader->timeAt]));
    if (!reader->hasTime)
    {
        return reader->timeAt < 0 ? SW_SUCCESS : fail(reader, "the times have no values.");
    }
    swGetNetcdfText(&reader->file, reader->time.id, "units", text, sizeof(text));
    swGetNetcdfText(&reader->file, reader->time.id, "calendar", calendar, sizeof(calendar));
    for (size_t i = 0; i < sizeof(units) / sizeof(units[0]); ++i)
    {
        if (strncmp(text, units[i].name, strlen(units[i].name)) == 0)
        {
            reader->timeFactor = units[i].seconds;
        }
    }
    char* since = strstr(text, "since ");
    if (since != NULL && strlen(since) > 16 && since[16] == 't')
    {
        since[16] = 'T'; // lowered with the rest
    }
    char* z = since != NULL && since[strlen(since) - 1] == 'z' ? since + strlen(since) - 1 : NULL;
    if (z != NULL)
    {
        *z = '\0';
    }
    bool isStrange = strcmp(calendar, "360 day") == 0 || strcmp(calendar, "noleap") == 0 ||
                     strcmp(calendar, "365 day") == 0 || strcmp(calendar, "all leap") == 0;
    if (isStrange || reader->timeFactor == 0.0 || since == NULL || !swParseMeasuredTime(since + 6, &reader->timeOrigin))
    {
        return swFail(reader->file.host, SW_ERROR_FORMAT,
                      "%s: the time's units are '%s', its calendar '%s'; units such as hours since 1990-01-01 00:00:00 "
                      "and the usual calendar are read.",
                      reader->file.name, text, calendar);
    }
    return SW_SUCCESS;
}

static swResult readTime(const Reader* reader, size_t index, double* seconds)
{
    double value = 0.0;
    size_t one = 1;
    *seconds = (double)NAN;
    if (!reader->hasTime)
    {
        return SW_SUCCESS;
    }
    swResult result = swReadNetcdfBlock(&reader->file, &reader->time, &index, &one, &value);
    *seconds = reader->timeOrigin + value * reader->timeFactor;
    // Days as floating-point numbers are off by microseconds.
    *seconds = floor(*seconds * 1000.0 + 0.5) / 1000.0;
    return result == SW_SUCCESS && value != value ? fail(reader, "a time is missing.") : result;
}

// ---- places ----

// Of a variable over some of the spectrum's dimensions, the value at a place; time is the first. NAN if there is none.
static double readAtPlace(const Reader* reader, const char* const* names, const size_t* start)
{
    swNetcdfVariable variable;
    for (; *names != NULL; ++names)
    {
        if (!swFindNetcdfVariable(&reader->file, *names, &variable))
        {
            continue;
        }
        size_t at[SW_NETCDF_MAX_DIMENSIONS] = {0}, count[SW_NETCDF_MAX_DIMENSIONS];
        for (int i = 0; i < variable.dimensionCount; ++i)
        {
            count[i] = 1;
            for (int j = 0; j < reader->spectrum.dimensionCount; ++j)
            {
                at[i] = variable.dimensions[i] == reader->spectrum.dimensions[j] ? start[j] : at[i];
            }
        }
        double value = (double)NAN;
        return swReadNetcdfBlock(&reader->file, &variable, at, count, &value) == SW_SUCCESS ? value : (double)NAN;
    }
    return (double)NAN;
}

// Index along the spectrum's dimension that a variable shares; 0 if it shares none.
static size_t findIndex(const Reader* reader, const swNetcdfVariable* variable, int dimension, const size_t* start)
{
    size_t index = 0;
    for (int j = 0; j < reader->spectrum.dimensionCount; ++j)
    {
        index = variable->dimensions[dimension] == reader->spectrum.dimensions[j] ? start[j] : index;
    }
    return index;
}

// station_name(station, string16), or of strings station_name(station).
static void nameStation(const Reader* reader, const size_t* start, char name[64])
{
    swNetcdfVariable variable;
    nc_type type = NC_NAT;
    memset(name, 0, 64);
    if ((!swFindNetcdfVariable(&reader->file, "station_name", &variable) &&
         !swFindNetcdfVariable(&reader->file, "station_id", &variable)) ||
        nc_inq_vartype(reader->file.id, variable.id, &type) != NC_NOERR)
    {
        return;
    }
    size_t at[2] = {findIndex(reader, &variable, 0, start), 0};
    if (type == NC_CHAR && variable.dimensionCount == 2)
    {
        size_t count[2] = {1, swGetNetcdfLength(&reader->file, variable.dimensions[1])};
        count[1] = count[1] < 63 ? count[1] : 63;
        if (nc_get_vara_text(reader->file.id, variable.id, at, count, name) != NC_NOERR)
        {
            name[0] = '\0';
        }
    }
    char* string = NULL;
    if (type == NC_STRING && variable.dimensionCount == 1 &&
        nc_get_var1_string(reader->file.id, variable.id, at, &string) == NC_NOERR && string != NULL)
    {
        size_t length = strlen(string);
        memcpy(name, string, length < 63 ? length : 63);
        nc_free_string(1, &string);
    }
    for (size_t length = strlen(name); length > 0 && name[length - 1] == ' '; --length)
    {
        name[length - 1] = '\0';
    }
}

static void findPlace(const Reader* reader, size_t place, size_t start[SW_NETCDF_MAX_DIMENSIONS])
{
    for (int i = reader->spectrum.dimensionCount - 1; i >= 0; --i)
    {
        start[i] = reader->roles[i] == PLACE ? place % reader->lengths[i] : 0;
        place /= reader->roles[i] == PLACE ? reader->lengths[i] : 1;
    }
}

static swResult addPlaces(Reader* reader)
{
    static const char* const longitudes[] = {"longitude", "lon", NULL};
    static const char* const latitudes[] = {"latitude", "lat", NULL};
    swResult result = SW_SUCCESS;
    for (size_t place = 0; place < reader->placeCount && result == SW_SUCCESS; ++place)
    {
        char name[64];
        size_t start[SW_NETCDF_MAX_DIMENSIONS];
        findPlace(reader, place, start);
        nameStation(reader, start, name);
        result = swMeasuredSea_AddLocation(reader->sea, name, readAtPlace(reader, longitudes, start),
                                           readAtPlace(reader, latitudes, start), NULL);
    }
    return result;
}

// ---- spectra ----

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

// Block to density by frequency and direction. False if all is missing.
static bool arrange(Reader* reader)
{
    size_t frequencies = reader->lengths[reader->frequencyAt], directions = reader->lengths[reader->directionAt];
    bool isFrequencyFirst = reader->frequencyAt < reader->directionAt, hasData = false;
    for (size_t i = 0; i < frequencies; ++i)
    {
        for (size_t j = 0; j < directions; ++j)
        {
            double value = reader->block[isFrequencyFirst ? i * directions + j : j * frequencies + i];
            hasData = hasData || value == value;
            reader->density[i * directions + j] = value != value        ? 0.0
                                                  : reader->isLogarithm ? raiseTen(value)
                                                                        : value * reader->unit;
        }
    }
    return hasData;
}

static swResult readSpectrum(Reader* reader, size_t time, size_t place, double seconds)
{
    size_t start[SW_NETCDF_MAX_DIMENSIONS], count[SW_NETCDF_MAX_DIMENSIONS];
    findPlace(reader, place, start);
    for (int i = 0; i < reader->spectrum.dimensionCount; ++i)
    {
        start[i] = reader->roles[i] == TIME ? time : start[i];
        count[i] = i == reader->frequencyAt || i == reader->directionAt ? reader->lengths[i] : 1;
    }
    swResult result = swReadNetcdfBlock(&reader->file, &reader->spectrum, start, count, reader->block);
    if (result != SW_SUCCESS || !arrange(reader))
    {
        return result; // land
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = (int)place;
    def.seconds = seconds;
    def.frequencyCount = (int)reader->lengths[reader->frequencyAt];
    def.frequencies = reader->frequencies;
    def.bandwidths = reader->hasBands ? reader->bandwidths : NULL;
    def.directionCount = (int)reader->lengths[reader->directionAt];
    def.directions = reader->directions;
    def.density = reader->density;
    return swMeasuredSea_AddSpectrum(reader->sea, &def);
}

static swResult readSpectra(Reader* reader)
{
    swResult result = SW_SUCCESS;
    size_t times = reader->timeAt >= 0 ? reader->lengths[reader->timeAt] : 1;
    for (size_t i = 0; i < times && result == SW_SUCCESS; ++i)
    {
        double seconds = 0.0;
        result = readTime(reader, i, &seconds);
        for (size_t j = 0; j < reader->placeCount && result == SW_SUCCESS; ++j)
        {
            result = readSpectrum(reader, i, j, seconds);
        }
    }
    return result;
}

// ---- the file ----

static swResult readHead(Reader* reader)
{
    if (!findSpectrum(reader))
    {
        return fail(reader, "it holds no variable efth (WAVEWATCH III), d2fd (ERA5) or of standard_name "
                            "sea_surface_wave_directional_variance_spectral_density.");
    }
    char unit[64];
    swGetNetcdfText(&reader->file, reader->spectrum.id, "units", unit, sizeof(unit));
    reader->unit = strstr(unit, "deg") != NULL ? 1.0 / DEGREE : 1.0;
    swResult result = findDimensions(reader);
    if (result == SW_SUCCESS)
    {
        result = readFrequencies(reader);
    }
    if (result == SW_SUCCESS)
    {
        result = readDirections(reader);
    }
    if (result == SW_SUCCESS)
    {
        result = readTimeUnit(reader);
    }
    return result == SW_SUCCESS ? addPlaces(reader) : result;
}

static swResult read(Reader* reader)
{
    swResult result = readHead(reader);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t values = reader->lengths[reader->frequencyAt] * reader->lengths[reader->directionAt];
    reader->blockSize = 2 * values * sizeof(double);
    reader->block = swAllocate(reader->file.host, reader->blockSize);
    if (reader->block == NULL)
    {
        return swFail(reader->file.host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %s.", reader->file.name);
    }
    reader->density = reader->block + values;
    result = readSpectra(reader);
    return result == SW_SUCCESS ? swMeasuredSea_Finish(reader->sea) : result;
}

swResult swReadNetcdfSea(const swHost* host, const char* path, swMeasuredSea** sea)
{
    *sea = NULL;
    swResult checked = swCheckNetcdfFile(host, path);
    if (checked != SW_SUCCESS)
    {
        return checked;
    }
    Reader* reader = swAllocateZero(host, sizeof(*reader));
    if (reader == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
    }
    reader->file = (swNetcdfFile){host, path, -1};
    int code = nc_open(path, NC_NOWRITE, &reader->file.id);
    swResult result = code == NC_NOERR
                          ? swCreateMeasuredSea(host, path, &reader->sea)
                          : swFail(host, SW_ERROR_FORMAT, "%s: this is no netCDF file that can be read: %s.", path,
                                   nc_strerror(code));
    if (result == SW_SUCCESS)
    {
        result = read(reader);
    }
    if (code == NC_NOERR)
    {
        nc_close(reader->file.id);
    }
    if (result == SW_SUCCESS)
    {
        *sea = reader->sea;
    }
    else
    {
        swDestroyMeasuredSea(reader->sea);
    }
    swFree(host, reader->block, reader->blockSize);
    swFree(host, reader, sizeof(*reader));
    return result;
}
