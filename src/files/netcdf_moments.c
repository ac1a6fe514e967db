// SPDX-License-Identifier: MIT
// Energies by frequency with circular moments in netCDF files, as buoys report them. What each means by a direction:
//
// NDBC [NDBC 2024]: alpha1 and alpha2 are where waves come from, degrees clockwise from true north; r1 and r2 the
// lengths. CDIP [CDIP 2024]: a1, b1, a2, b2 of where waves come from, cosines towards north and sines towards east, so
// that waveMeanDirection is the angle of (a1, b1). A record has a flag: 1 good, 2 not evaluated, 3 questionable, 4 bad,
// 9 missing. Sofar: a1, b1, a2, b2 of where waves go, cosines towards east and sines towards north, as in its JSON; its
// own package counts angles counterclockwise from east.
// Copernicus' in situ data, WAVEWATCH III's and SWAN's spectra without directions: mean direction where waves come
// from, and spread, the circular standard deviations sqrt(2 (1 - r1)) and sqrt((1 - r2) / 2) [Kuik 1988].

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "files/netcdf_sea.h"

#define DEGREE (SW_PI / 180.0)
#define MAX_ENERGY 5e4 // m2/Hz: what a measured sea takes
#define ROWS 5

typedef enum MomentKind
{
    FOURIER, // a1, b1, a2, b2
    POLAR,   // direction 1, r1, direction 2, r2
    SPREAD   // direction 1, spread 1, direction 2, spread 2
} MomentKind;

typedef struct Format
{
    swNetcdfWriter writer;
    MomentKind kind;
    const char* energy; // NULL: known by its standard_name
    const char* moments[4];
    const char* flag; // of a record; NULL: there is none
} Format;

// The first whose energies and first moments are there.
static const Format formats[] = {
    {{"NDBC", SW_DIRECTIONS_FROM, true, false},
     POLAR,
     "spectral_wave_density",
     {"mean_wave_dir", "wave_spectrum_r1", "principal_wave_dir", "wave_spectrum_r2"},
     NULL},
    {{"CDIP", SW_DIRECTIONS_FROM, true, false},
     FOURIER,
     "waveEnergyDensity",
     {"waveA1Value", "waveB1Value", "waveA2Value", "waveB2Value"},
     "waveFlagPrimary"},
    {{"CDIP", SW_DIRECTIONS_FROM, true, false},
     SPREAD,
     "waveEnergyDensity",
     {"waveMeanDirection", "waveSpread", NULL, NULL},
     "waveFlagPrimary"},
    {{"Sofar", SW_DIRECTIONS_TO_FROM_EAST, true, false}, FOURIER, "variance_density", {"a1", "b1", "a2", "b2"}, NULL},
    {{"Sofar", SW_DIRECTIONS_TO_FROM_EAST, true, false}, FOURIER, "varianceDensity", {"a1", "b1", "a2", "b2"}, NULL},
    {{"Copernicus", SW_DIRECTIONS_FROM, true, false},
     SPREAD,
     "VSPEC1D",
     {"THETA1", "STHETA1", "THETA2", "STHETA2"},
     NULL},
    {{"WAVEWATCH III", SW_DIRECTIONS_FROM, false, false}, SPREAD, "ef", {"th1m", "sth1m", "th2m", "sth2m"}, NULL},
    {{"SWAN", SW_DIRECTIONS_FROM, false, true}, SPREAD, "energy_1d", {"theta_1d", "spread_1d", NULL, NULL}, NULL},
    {{"most others", SW_DIRECTIONS_FROM, false, false}, FOURIER, NULL, {"a1", "b1", "a2", "b2"}, NULL},
    {{"most others", SW_DIRECTIONS_FROM, false, false}, POLAR, NULL, {"alpha1", "r1", "alpha2", "r2"}, NULL},
    {{"most others", SW_DIRECTIONS_FROM, false, false}, SPREAD, NULL, {"theta1", "spread1", "theta2", "spread2"}, NULL},
};
#define FORMAT_COUNT (sizeof(formats) / sizeof(formats[0]))

// Energies that may stand alone, without moments.
static const char* const energies[] = {"spectral_wave_density",
                                       "waveEnergyDensity",
                                       "variance_density",
                                       "varianceDensity",
                                       "VSPEC1D",
                                       "ef",
                                       "energy_1d",
                                       "efth",
                                       NULL};

// Too large for a stack.
typedef struct Reader
{
    swNetcdfAxes* axes;
    swMeasuredSea* sea;
    const Format* format; // NULL: no moments
    bool hasMoments[4];
    swNetcdfVariable moments[4];
    double degrees; // of one unit of the directions
    bool hasFlag;
    swNetcdfVariable flag;
    double unit; // to m2/Hz
    swDirectionMeaning meaning;
    swNetcdfLosses losses;
    double rows[ROWS][SW_NETCDF_MAX_FREQUENCIES]; // energy, then the moments
} Reader;

// ---- the variables ----

static bool findByStandardName(swNetcdfAxes* axes)
{
    int count = 0;
    for (int i = 0; nc_inq_nvars(axes->file.id, &count) == NC_NOERR && i < count; ++i)
    {
        char text[128];
        swGetNetcdfText(&axes->file, i, "standard_name", true, text, sizeof(text));
        if (strcmp(text, "sea surface wave variance spectral density") == 0 &&
            swGetNetcdfVariable(&axes->file, i, &axes->main) && swHasNetcdfRole(axes, SW_NETCDF_FREQUENCY))
        {
            return true;
        }
    }
    return false;
}

bool swFindNetcdfMoments(swNetcdfAxes* axes)
{
    for (const char* const* name = energies; *name != NULL; ++name)
    {
        if (swFindNetcdfVariable(&axes->file, *name, &axes->main) && swHasNetcdfRole(axes, SW_NETCDF_FREQUENCY))
        {
            return true;
        }
    }
    return findByStandardName(axes);
}

// A variable over the frequencies.
static bool findMoment(const swNetcdfAxes* axes, const char* name, swNetcdfVariable* variable)
{
    bool hasFrequencies = false;
    if (name == NULL || !swFindNetcdfVariable(&axes->file, name, variable))
    {
        return false;
    }
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        hasFrequencies = hasFrequencies || variable->dimensions[i] == axes->main.dimensions[axes->frequencyAt];
    }
    return hasFrequencies;
}

static void findFormat(Reader* reader)
{
    char name[NC_MAX_NAME + 1] = {0};
    const swNetcdfAxes* axes = reader->axes;
    nc_inq_varname(axes->file.id, axes->main.id, name);
    for (size_t i = 0; i < FORMAT_COUNT && reader->format == NULL; ++i)
    {
        const Format* format = &formats[i];
        if (format->energy != NULL && strcmp(format->energy, name) != 0)
        {
            continue;
        }
        for (int j = 0; j < 4; ++j)
        {
            reader->hasMoments[j] = findMoment(axes, format->moments[j], &reader->moments[j]);
        }
        bool isThere = reader->hasMoments[0] && (format->kind != FOURIER || reader->hasMoments[1]);
        reader->format = isThere ? format : NULL;
    }
    const char* flag = reader->format != NULL                                                ? reader->format->flag
                       : swFindNetcdfVariable(&axes->file, "waveFlagPrimary", &reader->flag) ? "waveFlagPrimary"
                                                                                             : NULL;
    reader->hasFlag = flag != NULL && swFindNetcdfVariable(&axes->file, flag, &reader->flag);
}

// ---- the head ----

static swResult findUnit(Reader* reader)
{
    char unit[64];
    const swNetcdfAxes* axes = reader->axes;
    swGetNetcdfText(&axes->file, axes->main.id, "units", true, unit, sizeof(unit));
    if (strstr(unit, "rad") != NULL || strstr(unit, "deg") != NULL)
    {
        return swFail(axes->file.host, SW_ERROR_FORMAT,
                      "%s: its densities, in %s, are by direction, but none of their dimensions is named direction.",
                      axes->file.name, unit);
    }
    reader->unit = swFindNetcdfUnit(axes, unit);
    return SW_SUCCESS;
}

static void readDirections(Reader* reader, swDirectionMeaning asked)
{
    const swNetcdfFile* file = &reader->axes->file;
    if (reader->format == NULL)
    {
        swLog(file->host, SW_LOG_INFO, "%s: it holds energies without directions.", file->name);
        return;
    }
    swMeasuredDirections directions =
        swFindNetcdfDirections(file, reader->moments[0].id, -1, &reader->format->writer, asked);
    swMeasuredSea_SetDirections(reader->sea, &directions);
    reader->meaning = directions.meaning;
    char unit[64];
    swGetNetcdfText(file, reader->moments[0].id, "units", true, unit, sizeof(unit));
    reader->degrees = strncmp(unit, "rad", 3) == 0 ? 1.0 / DEGREE : 1.0;
}

static swResult readHead(Reader* reader, swDirectionMeaning asked)
{
    swNetcdfAxes* axes = reader->axes;
    swResult result = swFindNetcdfAxes(axes);
    result = result == SW_SUCCESS ? swReadNetcdfFrequencies(axes) : result;
    result = result == SW_SUCCESS ? swReadNetcdfTimeUnit(axes) : result;
    result = result == SW_SUCCESS ? findUnit(reader) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    findFormat(reader);
    readDirections(reader, asked);
    return swAddNetcdfPlaces(axes, reader->sea);
}

// ---- moments ----

// r of a spread in radians.
static double findLength(double spread, int order)
{
    double r = order == 1 ? 1.0 - 0.5 * spread * spread : 1.0 - 2.0 * spread * spread;
    return r > 0.0 || spread != spread ? r : 0.0;
}

// Numbers that stand for missing ones, as 99, 999 and -999.99, where the file does not declare them.
static void dropFillers(const Reader* reader, int j, double* row)
{
    bool isAngle = reader->format->kind != FOURIER && j % 2 == 0;
    double low = isAngle ? -361.0 : reader->format->kind == FOURIER ? -1.5 : 0.0;
    double high = isAngle                           ? 721.0
                  : reader->format->kind == FOURIER ? 1.5
                  : reader->format->kind == POLAR   ? 101.0
                                                    : 181.0;
    for (size_t i = 0; i < reader->axes->frequencyCount; ++i)
    {
        row[i] = row[i] >= low && row[i] <= high ? row[i] : (double)NAN;
    }
}

// The two values that a file has for an order, as they are where waves go: cos and sin, or angle and length.
static void convertPair(const Reader* reader, int order, bool isPercent, double* first, double* second)
{
    if (reader->format->kind == FOURIER)
    {
        swTurnMoments(reader->meaning, order, first, second);
        return;
    }
    *first = swTurnDirection(reader->meaning, *first * reader->degrees);
    *second = reader->format->kind == POLAR ? *second * (isPercent ? 0.01 : 1.0)
                                            : findLength(*second * reader->degrees * DEGREE, order);
}

// NDBC's archives have r times 100, which shows by its size.
static bool arePercent(const double* values, size_t count)
{
    double largest = 0.0;
    for (size_t i = 0; i < count; ++i)
    {
        largest = values[i] > largest ? values[i] : largest;
    }
    return largest > 1.5;
}

static void readMoments(Reader* reader, const size_t* start)
{
    size_t count = reader->axes->frequencyCount;
    for (int j = 0; j < 4; ++j)
    {
        double* row = reader->rows[1 + j];
        if (!reader->hasMoments[j] || !swReadNetcdfRow(reader->axes, &reader->moments[j], start, row))
        {
            for (size_t i = 0; i < count; ++i)
            {
                row[i] = (double)NAN;
            }
        }
        dropFillers(reader, j, row);
    }
    for (int order = 1; order <= 2; ++order)
    {
        double* first = reader->rows[2 * order - 1];
        double* second = reader->rows[2 * order];
        bool isPercent = reader->format->kind == POLAR && arePercent(second, count);
        for (size_t i = 0; i < count; ++i)
        {
            convertPair(reader, order, isPercent, &first[i], &second[i]);
        }
    }
}

// ---- records ----

// False if the file's own flag says that the record is worth nothing.
static bool isGood(Reader* reader, const size_t* start)
{
    double flag = reader->hasFlag ? swReadNetcdfAt(reader->axes, &reader->flag, start) : 1.0;
    bool isBad = flag == 4.0 || flag == 9.0;
    reader->losses.flaggedCount += isBad ? 1 : 0;
    reader->losses.doubtfulCount += flag == 3.0 ? 1 : 0;
    return !isBad;
}

// Energies to m2/Hz, and the largest of them. False if all are missing.
static bool convertEnergies(Reader* reader, double* largest)
{
    bool hasData = false;
    double* energy = reader->rows[0];
    *largest = 0.0;
    for (size_t i = 0; i < reader->axes->frequencyCount; ++i)
    {
        energy[i] = energy[i] == 999.0 ? (double)NAN : energy[i]; // NDBC's word for a missing one
        hasData = hasData || energy[i] == energy[i];
        energy[i] *= reader->unit;
        *largest = energy[i] > *largest ? energy[i] : *largest;
    }
    return hasData;
}

static swResult addRecord(Reader* reader, size_t place, double seconds)
{
    const swNetcdfAxes* axes = reader->axes;
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = (int)place;
    def.seconds = seconds;
    def.frequencyCount = (int)axes->frequencyCount;
    def.frequencies = axes->frequencies;
    def.bandwidths = axes->hasBands ? axes->bandwidths : NULL;
    def.energy = reader->rows[0];
    if (reader->format != NULL && reader->format->kind == FOURIER)
    {
        def.a1 = reader->rows[1];
        def.b1 = reader->rows[2];
        def.a2 = reader->rows[3];
        def.b2 = reader->rows[4];
    }
    else if (reader->format != NULL)
    {
        def.meanDirection = reader->rows[1];
        def.r1 = reader->hasMoments[1] ? reader->rows[2] : NULL;
        def.direction2 = reader->rows[3];
        def.r2 = reader->rows[4];
    }
    return swMeasuredSea_AddSpectrum(reader->sea, &def);
}

static swResult readRecord(Reader* reader, size_t time, size_t place, double seconds)
{
    const swNetcdfAxes* axes = reader->axes;
    size_t start[SW_NETCDF_MAX_DIMENSIONS];
    double largest = 0.0;
    swFindNetcdfPlace(axes, place, start);
    if (axes->timeAt >= 0)
    {
        start[axes->timeAt] = time;
    }
    if (!isGood(reader, start))
    {
        return SW_SUCCESS;
    }
    if (!swReadNetcdfRow(axes, &axes->main, start, reader->rows[0]))
    {
        return SW_ERROR_FORMAT;
    }
    if (!convertEnergies(reader, &largest))
    {
        ++reader->losses.emptyCount;
        return SW_SUCCESS;
    }
    if (largest > MAX_ENERGY)
    {
        ++reader->losses.beyondCount;
        return SW_SUCCESS;
    }
    if (reader->format != NULL)
    {
        readMoments(reader, start);
    }
    return addRecord(reader, place, seconds);
}

static swResult readAll(Reader* reader, swDirectionMeaning asked)
{
    const swNetcdfAxes* axes = reader->axes;
    swResult result = readHead(reader, asked);
    for (size_t i = 0; i < axes->timeCount && result == SW_SUCCESS; ++i)
    {
        double seconds = 0.0;
        if (!swReadNetcdfTime(axes, i, &seconds))
        {
            reader->losses.timeCount += (int)axes->placeCount;
            continue;
        }
        for (size_t j = 0; j < axes->placeCount && result == SW_SUCCESS; ++j)
        {
            result = readRecord(reader, i, j, seconds);
        }
    }
    return result == SW_SUCCESS ? swFinishNetcdfSea(axes, &reader->losses, reader->sea) : result;
}

swResult swReadNetcdfMoments(swNetcdfAxes* axes, swDirectionMeaning asked, swMeasuredSea* sea)
{
    const swHost* host = axes->file.host;
    Reader* reader = swAllocateZero(host, sizeof(*reader));
    if (reader == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", axes->file.name);
    }
    reader->axes = axes;
    reader->sea = sea;
    swResult result = readAll(reader, asked);
    swFree(host, reader, sizeof(*reader));
    return result;
}
