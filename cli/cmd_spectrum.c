// SPDX-License-Identifier: MIT
// `seaway spectrum`: a measured sea state, printed and drawn.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "output.h"
#include "seaway/files.h"
#include "spectrum_plot.h"
#include "text.h"
#include "verbs.h"

// Seas that are made of the record and measured for a plot.
#define PLOT_SEEDS 4

static swSpectrumDef MakeTableDef(const swMeasuredRecord* record)
{
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record->table;
    def.direction = 0.0f;
    def.extendTail = false;
    return def;
}

// Whether the file tells how far directions spread, at any frequency; otherwise that was assumed.
static bool HasSpread(const swMeasuredRecord* record)
{
    for (int i = 0; i < record->table.frequencyCount && record->meanDirection != NULL; ++i)
    {
        if (!isnan(record->measuredR1[i]))
        {
            return true;
        }
    }
    return false;
}

// What was not measured is NAN: directions and spreads that the file does not hold, and all but the height of a calm.
static bool FindState(const swMeasuredRecord* record, swSeaState* state)
{
    swSpectrumDef def = MakeTableDef(record);
    memset(state, 0, sizeof(*state));
    bool hasWaves = swSpectrum_GetSeaState(&def, 0.0f, 0.0f, state) == SW_SUCCESS;
    if (!hasWaves)
    {
        memset(state, 0, sizeof(*state));
        state->peakPeriod = state->periodTm01 = state->periodTm02 = state->energyPeriod = NAN;
    }
    if (!hasWaves || record->meanDirection == NULL)
    {
        state->meanDirection = state->peakDirection = NAN;
    }
    state->spread = hasWaves && HasSpread(record) ? state->spread : NAN;
    return hasWaves;
}

// The bin with the highest density.
static int FindPeak(const swMeasuredRecord* record)
{
    int peak = 0;
    for (int i = 1; i < record->table.frequencyCount; ++i)
    {
        peak = record->energy[i] > record->energy[peak] ? i : peak;
    }
    return peak;
}

static float GetSpread(float r1)
{
    return (float)(sqrt(fmax(2.0 * (1.0 - (double)r1), 0.0)) * (180.0 / SW_PI)); // NAN stays
}

// Directions by frequency and those at the peak, null where they were not measured.
static void WriteMoments(Json* json, const swMeasuredRecord* record)
{
    int count = record->table.frequencyCount, peak = FindPeak(record);
    bool hasDirections = record->meanDirection != NULL;
    float* rows[3];
    static const char* const keys[3] = {"direction_from_deg", "directional_spread_deg", "r1"};
    float* numbers = malloc(3 * (size_t)count * sizeof(float));
    if (numbers == NULL)
    {
        Complain("no memory for the directions of %d frequencies", count);
        return;
    }
    for (int i = 0; i < 3; ++i)
    {
        rows[i] = numbers + (size_t)i * (size_t)count;
    }
    for (int i = 0; i < count; ++i)
    {
        rows[0][i] = hasDirections ? (float)BearingFrom((double)record->measuredDirection[i]) : NAN;
        rows[2][i] = hasDirections ? record->measuredR1[i] : NAN;
        rows[1][i] = isnan(rows[2][i]) ? NAN : GetSpread(rows[2][i]);
    }
    bool hasPeak = record->energy[peak] > 0.0f;
    JsonNumber(json, "peak_frequency_hz", hasPeak ? (double)record->table.frequencies[peak] : (double)NAN);
    JsonNumber(json, "peak_spread_deg", hasPeak ? (double)rows[1][peak] : (double)NAN);
    JsonNumber(json, "peak_r1", hasPeak ? (double)rows[2][peak] : (double)NAN);
    for (int i = 0; i < 3; ++i)
    {
        JsonFloats(json, keys[i], rows[i], count);
    }
    free(numbers);
}

// "3", or the name where there is one.
static const char* NameLocation(const swMeasuredSea* sea, int location, char text[80])
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    char name[80];
    snprintf(text, 80, place.name[0] != '\0' ? "%d %s" : "%d", location + 1,
             CopyPrintable(name, sizeof(name) - 16, place.name));
    return text;
}

static void WriteLocation(Json* json, const swMeasuredSea* sea, int location)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    JsonInteger(json, "location", location + 1);
    JsonText(json, "location_name", place.name);
    JsonNumber(json, "longitude_deg", place.longitude); // null where it is not known
    JsonNumber(json, "latitude_deg", place.latitude);
}

// What the directions in the file mean, and how that is known.
static void WriteDirections(Json* json, const swMeasuredSea* sea)
{
    static const char* const words[] = {"by_format", "from", "to", "to_from_east"};
    swMeasuredDirections directions = swMeasuredSea_GetDirections(sea);
    JsonText(json, "directions", words[directions.meaning]);
    JsonFlag(json, "directions_assumed", directions.isAssumed);
    JsonText(json, "directions_known_by", directions.basis[0] != '\0' ? directions.basis : NULL);
}

static void PrintDirections(const swMeasuredSea* sea)
{
    static const char* const words[] = {"", "where waves come from", "where waves go",
                                        "where waves go, counterclockwise from east"};
    swMeasuredDirections directions = swMeasuredSea_GetDirections(sea);
    if (directions.meaning != SW_DIRECTIONS_BY_FORMAT)
    {
        printf("  directions in the file are %s%s (%s)\n", directions.isAssumed ? "ASSUMED to be " : "",
               words[directions.meaning], directions.basis);
    }
}

// Where waves come from, degrees, or a word where that was not measured.
static const char* PrintBearing(char text[16], const swMeasuredRecord* record, float direction, const char* unknown)
{
    if (record->meanDirection == NULL)
    {
        return unknown;
    }
    snprintf(text, 16, "%.0f", BearingFrom((double)direction));
    return text;
}

static void PrintList(const swMeasuredSea* sea, int location, bool asJson)
{
    bool hasPlaces = swMeasuredSea_GetLocationCount(sea) > 1;
    Json json = OpenJson(stdout);
    if (asJson)
    {
        JsonOpenArray(&json, NULL);
    }
    else
    {
        printf("%-16s  %6s  %6s  %6s  %5s%s\n", "time (UTC)", "Hs, m", "Tp, s", "Tm02,s", "from",
               hasPlaces ? "  location" : "");
    }
    for (int i = 0; i < swMeasuredSea_GetCount(sea); ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        if (location >= 0 && record.location != location)
        {
            continue;
        }
        char place[80];
        const char* where = hasPlaces ? NameLocation(sea, record.location, place) : "";
        swSeaState state;
        bool isCalm = !FindState(&record, &state); // a record without energy
        if (asJson)
        {
            JsonOpenObject(&json, NULL);
            JsonText(&json, "time_utc", record.time);
            WriteSeaState(&json, &state);
            JsonFlag(&json, "has_directions", record.meanDirection != NULL);
            WriteLocation(&json, sea, record.location);
            WriteDirections(&json, sea);
            JsonCloseObject(&json);
        }
        else if (isCalm)
        {
            printf("%-16s  %6.2f       -       -      -%s%s\n", record.time, 0.0, hasPlaces ? "  " : "", where);
        }
        else
        {
            char from[16];
            printf("%-16s  %6.2f  %6.2f  %6.2f  %5s%s%s\n", record.time, (double)state.significantHeight,
                   (double)state.peakPeriod, (double)state.periodTm02,
                   PrintBearing(from, &record, state.meanDirection, "-"), hasPlaces ? "  " : "", where);
        }
    }
    if (asJson)
    {
        JsonCloseArray(&json);
    }
}

static void PrintLocation(const swMeasuredSea* sea, int location, double distance)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    char name[80];
    if (swMeasuredSea_GetLocationCount(sea) > 1 || place.name[0] != '\0')
    {
        printf("  location %s of %d\n", NameLocation(sea, location, name), swMeasuredSea_GetLocationCount(sea));
    }
    if (place.latitude == place.latitude && place.longitude == place.longitude)
    {
        printf("  at %.4f N %.4f E", place.latitude, place.longitude);
        if (distance == distance)
        {
            printf(", %.1f km from the point that was asked for", distance / 1000.0);
        }
        printf("\n");
    }
}

static void PrintRecord(const char* path, const swMeasuredSea* sea, const swMeasuredRecord* record, double distance)
{
    swSeaState state;
    bool hasWaves = FindState(record, &state);
    const swSpectrumTable* table = &record->table;
    char time[32], name[MAX_PATH_LENGTH];
    snprintf(time, sizeof(time), "%s UTC", record->time);
    printf("%s, %s, one of %d records\n", CopyPrintable(name, sizeof(name), path),
           record->time[0] != '\0' ? time : "no time", swMeasuredSea_GetCount(sea));
    PrintLocation(sea, record->location, distance);
    PrintDirections(sea);
    if (record->partitionCount > 0)
    {
        printf("  built up from heights, periods and directions of %d system%s of waves\n", record->partitionCount,
               record->partitionCount > 1 ? "s" : "");
    }
    if (record->averagePeriod > 0.0f)
    {
        printf("  the buoy's average period is %.1f s: for it a peak of gamma %.2g and a tail f^-%.2g were chosen\n",
               (double)record->averagePeriod, (double)record->gamma, (double)record->tailExponent);
    }
    else if (record->gamma > 0.0f)
    {
        printf("  no average period is told: a peak of gamma %.2g and a tail f^-%.2g were assumed\n",
               (double)record->gamma, (double)record->tailExponent);
    }
    printf("  %d frequencies, %.4g to %.4g Hz; %s\n", table->frequencyCount, (double)table->frequencies[0],
           (double)table->frequencies[table->frequencyCount - 1],
           record->meanDirection != NULL ? "with directions"
                                         : "without directions: its sea is spread as cos^16(theta/2) around east");
    if (record->correctedCount > 0)
    {
        printf("  %d frequencies had moments that no distribution can have; they were corrected\n",
               record->correctedCount);
    }
    if (record->missingCount > 0)
    {
        printf("  %d densities are missing between others and count as none: the sea was higher\n",
               record->missingCount);
    }
    if (record->negativeCount > 0)
    {
        printf("  %d densities were negative, %.2g %% of the energy; each frequency is scaled to keep its own\n",
               record->negativeCount, 100.0 * (double)record->negativePart);
    }
    if (record->addedPart > 0.0f)
    {
        printf("  where a frequency could not, %.2g %% of the energy was gained\n", 100.0 * (double)record->addedPart);
    }
    if (!hasWaves)
    {
        printf("  no waves\n");
        return;
    }
    printf("  Hs    %6.2f m     significant wave height\n", (double)state.significantHeight);
    printf("  Tp    %6.2f s     period of the peak\n", (double)state.peakPeriod);
    printf("  Tm01  %6.2f s\n", (double)state.periodTm01);
    printf("  Tm02  %6.2f s\n", (double)state.periodTm02);
    printf("  Te    %6.2f s     energy period\n", (double)state.energyPeriod);
    if (record->meanDirection == NULL)
    {
        printf("  from   not measured\n  peak   not measured\n");
    }
    else
    {
        printf("  from  %6.0f deg   mean direction that waves come from, clockwise from north\n",
               BearingFrom((double)state.meanDirection));
        printf("  peak  %6.0f deg   direction at the peak\n", BearingFrom((double)state.peakDirection));
    }
    if (isnan(state.spread))
    {
        printf("  spread not measured%s\n", record->meanDirection != NULL ? "; one was assumed" : "");
    }
    else
    {
        printf("  spread%6.0f deg\n", (double)state.spread * (180.0 / SW_PI));
    }
    printf("  slope %8.5f   mean square slope of these frequencies\n", (double)state.meanSquareSlope);
}

static void PrintRecordJson(const char* path, const swMeasuredSea* sea, const swMeasuredRecord* record, double distance)
{
    swSeaState state;
    FindState(record, &state);
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "file", path);
    JsonText(&json, "time_utc", record->time);
    JsonInteger(&json, "record_count", swMeasuredSea_GetCount(sea));
    WriteSeaState(&json, &state);
    JsonNull(&json, "whitecap_fraction");
    JsonFlag(&json, "has_directions", record->meanDirection != NULL);
    JsonInteger(&json, "corrected_count", record->correctedCount);
    JsonInteger(&json, "missing_count", record->missingCount);
    JsonInteger(&json, "negative_count", record->negativeCount);
    JsonNumber(&json, "negative_fraction", (double)record->negativePart);
    JsonNumber(&json, "added_fraction", (double)record->addedPart);
    JsonInteger(&json, "partition_count", record->partitionCount);
    JsonNumber(&json, "reported_tm02_s", record->averagePeriod > 0.0f ? (double)record->averagePeriod : (double)NAN);
    JsonNumber(&json, "assumed_gamma", record->gamma > 0.0f ? (double)record->gamma : (double)NAN);
    JsonNumber(&json, "assumed_tail_exponent", record->gamma > 0.0f ? (double)record->tailExponent : (double)NAN);
    WriteLocation(&json, sea, record->location);
    JsonNumber(&json, "distance_km", distance / 1000.0); // null unless a point was asked for
    WriteDirections(&json, sea);
    JsonFloats(&json, "frequency_hz", record->table.frequencies, record->table.frequencyCount);
    JsonFloats(&json, "bandwidth_hz", record->table.bandwidths, record->table.frequencyCount);
    JsonFloats(&json, "density_m2_per_hz", record->energy, record->table.frequencyCount);
    WriteMoments(&json, record);
    JsonCloseObject(&json);
}

// A scene of nothing but the record, to make its sea of.
static swScene* MakeRecordScene(const swMeasuredRecord* record)
{
    swScene* scene = calloc(1, sizeof(swScene));
    if (scene != NULL)
    {
        scene->world = swDefaultWorldDef();
        scene->wavesCount = 1;
        scene->waves[0].def = swDefaultWaveSystemDef();
        scene->waves[0].def.spectrum = MakeTableDef(record);
    }
    return scene;
}

static bool PlotRecord(const char* plotPath, const char* path, const swMeasuredRecord* record)
{
    const MeasureOptions options = {.seeds = PLOT_SEEDS, .withDirections = true};
    const char* slash = strrchr(path, '/');
    char title[256];
    swScene* scene = MakeRecordScene(record);
    SeaMeasurement* sea = scene != NULL ? MeasureSea(scene, &options) : NULL;
    snprintf(title, sizeof(title), "%s, %s UTC", slash != NULL ? slash + 1 : path, record->time);
    bool isFine = sea != NULL &&
                  PlotSea(plotPath, title,
                          record->meanDirection != NULL ? NULL : "no directions measured: spread around the west", sea);
    DestroyMeasurement(sea);
    free(scene);
    return isFine;
}

static int ShowRecord(const char* path, const swMeasuredSea* sea, int index, double distance, const char* plotPath,
                      bool asJson)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
    if (asJson)
    {
        PrintRecordJson(path, sea, &record, distance);
    }
    else
    {
        PrintRecord(path, sea, &record, distance);
    }
    swSeaState state;
    bool hasWaves = FindState(&record, &state);
    if (plotPath != NULL && !hasWaves)
    {
        Complain("%s at %s holds no waves to plot", path, record.time);
        return EXIT_PROBLEM;
    }
    bool isFine = FinishOutput();
    return (plotPath == NULL || PlotRecord(plotPath, path, &record)) && isFine ? EXIT_FINE : EXIT_PROBLEM;
}

// The place that is asked for: by name or number, or by where it lies. NULL and NAN: not asked for.
typedef struct PlaceChoice
{
    const char* name;
    double latitude, longitude;
    double distance; // m, found; NAN if no point was asked for
} PlaceChoice;

// *location is -1 where records of all places may be taken. False if there is no such place, which it has said.
static bool ChoosePlace(const swMeasuredSea* sea, PlaceChoice* choice, int* location)
{
    bool hasLatitude = choice->latitude == choice->latitude, hasLongitude = choice->longitude == choice->longitude;
    choice->distance = (double)NAN;
    *location = -1;
    if (hasLatitude != hasLongitude || (hasLatitude && choice->name != NULL))
    {
        Complain(choice->name != NULL ? "spectrum: --location and --latitude both choose a place; keep one of them"
                                      : "spectrum: --latitude and --longitude belong together; give both");
        return false;
    }
    if (hasLatitude)
    {
        return swMeasuredSea_ChooseNearest(sea, choice->longitude, choice->latitude, location, &choice->distance) ==
               SW_SUCCESS;
    }
    *location = choice->name != NULL ? swFindMeasuredPlace(sea, choice->name) : -1;
    if (choice->name != NULL && *location < 0)
    {
        Complain("spectrum: --location wants a name or a number from 1 to %d, not \"%s\"; --list shows them",
                 swMeasuredSea_GetLocationCount(sea), choice->name);
        return false;
    }
    if (*location >= 0 && swMeasuredSea_GetLocation(sea, *location).recordCount == 0)
    {
        Complain("spectrum: location \"%s\" has no record; --list shows those that have", choice->name);
        return false;
    }
    return true;
}

static bool ChooseRecord(const swMeasuredSea* sea, int location, const char* at, int* index)
{
    double seconds = 0.0;
    if (at != NULL && !swParseMeasuredTime(at, &seconds))
    {
        Complain("spectrum: --at wants a time such as \"2022-05-08 12:40\" (UTC), not \"%s\"", at);
        return false;
    }
    return swMeasuredSea_ChooseRecord(sea, location, at, index) == SW_SUCCESS;
}

int RunSpectrum(int argumentCount, char** arguments)
{
    const char* path = NULL;
    const char* at = NULL;
    static const char* const directionWords[] = {"from", "to", NULL};
    PlaceChoice place = {.latitude = (double)NAN, .longitude = (double)NAN};
    int directions = -1;
    const char* plotPath = NULL;
    bool asJson = false, asList = false;
    static const char* const plotEndings[] = {".svg", NULL};
    static const char* const ofOneRecord[] = {"at", "plot", NULL};
    const Option options[] = {
        {.name = "at",
         .kind = OPTION_TEXT,
         .value = &at,
         .placeholder = "TIME",
         .help = "the record nearest to \"YYYY-MM-DD hh:mm\" UTC (default: the largest Hs)"},
        {.name = "location",
         .kind = OPTION_TEXT,
         .value = &place.name,
         .placeholder = "N|NAME",
         .help = "records of one place only, by number from 1 on or by name (default: of all)"},
        {.name = "latitude",
         .kind = OPTION_NUMBER,
         .value = &place.latitude,
         .placeholder = "DEG",
         .help = "records of the place nearest to this latitude and longitude, at most 100 km away",
         .min = -90.0,
         .max = 90.0},
        {.name = "longitude",
         .kind = OPTION_NUMBER,
         .value = &place.longitude,
         .placeholder = "DEG",
         .help = "degrees east, from -180 to 360",
         .min = -180.0,
         .max = 360.0},
        {.name = "directions",
         .kind = OPTION_CHOICE,
         .value = &directions,
         .placeholder = "from|to",
         .help = "what directions in a netCDF file mean: where waves come from or go (default: what it says)",
         .choices = directionWords},
        {.name = "plot",
         .kind = OPTION_OUTPUT,
         .value = &plotPath,
         .placeholder = "FILE.svg",
         .help = "make its sea, and draw the record and what the surface measures",
         .choices = plotEndings},
        {.name = "list",
         .kind = OPTION_FLAG,
         .value = &asList,
         .help = "one line for each record",
         .without = ofOneRecord},
        {.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"},
    };
    const Verb verb = {.name = "spectrum",
                       .synopsis = "FILE [--at TIME] [--location N|NAME] [--latitude DEG --longitude DEG]\n"
                                   "                [--directions from|to] [--plot FILE.svg] [--list] [--json]",
                       .text =
                           "Read a measured or computed sea state. The format is known by the contents: spectra and\n"
                           "summaries of NDBC (name the energy file, such as 44013.data_spec or 44013w2022.txt; the\n"
                           "direction files beside it are found by name), of SWAN, WAVEWATCH III (text and\n"
                           "partitions), Octopus, TriAxys, Datawell (.spt), Obscape, Nortek AWAC (NMEA), Sofar\n"
                           "Spotter (JSON and the dashboard's table), MHKiT (JSON), netCDF (WAVEWATCH III, SWAN, WWM,\n"
                           "ERA5, NDBC, CDIP, Sofar, Copernicus, MHKiT and wavespectra), and\n"
                           "a table of partitions: time,hs_m,tp_s,direction_from_deg,spread_deg,gamma.",
                       .options = options,
                       .optionCount = sizeof(options) / sizeof(options[0]),
                       .positionalMin = 1,
                       .positionalMax = 1,
                       .positionalName = "a spectrum file",
                       .positionals = &path};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    if (plotPath != NULL && !ProbeOutput(plotPath))
    {
        return EXIT_PROBLEM;
    }
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    def.directions = directions == 0   ? SW_DIRECTIONS_FROM
                     : directions == 1 ? SW_DIRECTIONS_TO
                                       : SW_DIRECTIONS_BY_FORMAT;
    swResult result = swReadMeasuredFile(&host, path, &def, &sea);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, path);
        return EXIT_PROBLEM;
    }
    int exitCode = EXIT_USAGE;
    int location = -1, index = -1;
    bool isChosen = ChoosePlace(sea, &place, &location) && ChooseRecord(sea, location, at, &index);
    if (isChosen && asList)
    {
        PrintList(sea, location, asJson);
        exitCode = FinishOutput() ? EXIT_FINE : EXIT_PROBLEM;
    }
    else if (isChosen)
    {
        exitCode = ShowRecord(path, sea, index, place.distance, plotPath, asJson);
    }
    swDestroyMeasuredSea(sea);
    return exitCode;
}
