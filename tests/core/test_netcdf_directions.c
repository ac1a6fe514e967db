// SPDX-License-Identifier: MIT
// A direction of 90 degrees in a netCDF file may be where waves come from or where they go. Labels in all words that
// writers use, none at all, units and dimensions of all writers, and the caller's word: every way the sea must come
// from the right side, and what was assumed must be said.

#include "support/cmocka_setup.h"
#include "support/sea_states.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "seaway/files.h"
#include "support/netcdf_maker.h"

#define DATA SW_SOURCE_DIR "/../shared/data"
#define FREQUENCIES 12
#define DIRECTIONS 36
#define DEGREE (SW_PI / 180.0)
#define PEAK 0.1 // Hz

static char s_path[128];

static swResult Read(const char* path, swDirectionMeaning directions, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    def.directions = directions;
    swResult result = swReadMeasuredFile(&host, path, &def, sea);
    assert_true((result == SW_SUCCESS) == (*sea != NULL));
    return result;
}

static double GetBearingFrom(const swMeasuredSea* sea, int index)
{
    return (double)GetSeaState(sea, index, true).meanDirection / DEGREE - 90.0;
}

// A file of one spectrum around 70 degrees of whatever its directions mean.
typedef struct FileText
{
    const char *variable, *frequency, *direction; // names; the latter two of dimensions and coordinates
    const char *directionAttribute, *directionText, *directionUnit, *densityUnit, *standardName;
    const char *fileAttribute, *fileText;
    const char* frequencyUnit;
} FileText;

#define MEAN 70.0

// Per degree; 4 sqrt(m0) is 2 m.
static double GetDensity(int frequency, int direction)
{
    double half = 0.5 * (360.0 / DIRECTIONS * direction - MEAN) * DEGREE;
    double sum = 0.0, share = pow(cos(half), 20.0);
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        sum += pow(cos(0.5 * (360.0 / DIRECTIONS * j - MEAN) * DEGREE), 20.0) * 360.0 / DIRECTIONS;
    }
    return frequency == 4 ? 0.25 / 0.01 * share / sum : 0.0;
}

static void WriteSpectra(const FileText* text)
{
    int file = MakeNetcdf(s_path, NC_CLASSIC_MODEL);
    const int dimensions[2] = {AddDimension(file, text->frequency, FREQUENCIES),
                               AddDimension(file, text->direction, DIRECTIONS)};
    int frequency = AddVariable(file, text->frequency, NC_DOUBLE, 1, &dimensions[0]);
    int direction = AddVariable(file, text->direction, NC_FLOAT, 1, &dimensions[1]);
    int density = AddVariable(file, text->variable, NC_DOUBLE, 2, dimensions);
    if (text->directionAttribute != NULL)
    {
        AddText(file, direction, text->directionAttribute, text->directionText);
    }
    AddText(file, direction, "units", text->directionUnit);
    AddText(file, density, "units", text->densityUnit);
    AddText(file, frequency, "units", text->frequencyUnit);
    AddText(file, density, "standard_name", text->standardName);
    if (text->fileAttribute != NULL)
    {
        AddText(file, NC_GLOBAL, text->fileAttribute, text->fileText);
    }
    CheckNetcdf(nc_enddef(file));
    bool isRadian = text->directionUnit != NULL && strncmp(text->directionUnit, "rad", 3) == 0;
    bool isPerRadian = text->densityUnit != NULL && strstr(text->densityUnit, "rad") != NULL;
    double frequencies[FREQUENCIES], directions[DIRECTIONS], densities[FREQUENCIES * DIRECTIONS];
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        frequencies[i] = 0.06 + 0.01 * i;
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            directions[j] = 360.0 / DIRECTIONS * j * (isRadian ? DEGREE : 1.0);
            densities[i * DIRECTIONS + j] = GetDensity(i, j) / (isPerRadian ? DEGREE : 1.0);
        }
    }
    PutNumbers(file, frequency, frequencies);
    PutNumbers(file, direction, directions);
    PutNumbers(file, density, densities);
    CheckNetcdf(nc_close(file));
}

// What is read of the file: the bearing that waves come from.
static double ReadBearing(const FileText* text, swDirectionMeaning asked, swMeasuredDirections* directions)
{
    WriteSpectra(text);
    swMeasuredSea* sea = NULL;
    swResult result = Read(s_path, asked, &sea);
    remove(s_path);
    if (result != SW_SUCCESS)
    {
        print_message("%s", s_messages);
    }
    assert_int_equal(result, SW_SUCCESS);
    *directions = swMeasuredSea_GetDirections(sea);
    swSeaState state = GetSeaState(sea, 0, true);
    assert_true(fabs((double)state.significantHeight / 2.0 - 1.0) < 1e-3);
    assert_true(fabs((double)state.peakPeriod * PEAK - 1.0) < 1e-3);
    double bearing = GetBearingFrom(sea, 0);
    swDestroyMeasuredSea(sea);
    return bearing;
}

static FileText MakeText(void)
{
    return (FileText){.variable = "efth",
                      .frequency = "freq",
                      .direction = "dir",
                      .directionUnit = "degree",
                      .densityUnit = "m2 s degree-1"};
}

static void LabelsInAnyWordsAreUnderstood(void** state)
{
    (void)state;
    static const struct
    {
        const char *attribute, *text;
        double from; // bearing; -1: it tells nothing
    } cases[] = {
        {"standard_name", "sea_surface_wave_from_direction", MEAN},
        {"standard_name", "sea_surface_wave_to_direction", MEAN + 180.0},
        {"standard_name", "sea_surface_wind_wave_from_direction", MEAN},
        {"long_name", "wave direction, coming from", MEAN},
        {"long_name", "sea surface wave to direction", MEAN + 180.0},
        {"long_name", "Wave Direction (going to)", MEAN + 180.0},
        {"long_name", "direction towards which waves propagate", MEAN + 180.0},
        {"long_name", "Direction of wave propagation", MEAN + 180.0},
        {"long_name", "direction from which waves arrive", MEAN},
        {"long_name", "coming-from direction", MEAN},
        {"long_name", "direction FROM", MEAN},
        {"long_name", "direction to", MEAN + 180.0},
        {"comment", "Direction the waves are coming from, measured clockwise from North", MEAN},
        {"comment", "Direction the waves are going to, measured clockwise from North", MEAN + 180.0},
        {"comment", "Direction the waves are going to, measured anti-clockwise from East", 270.0 - MEAN},
        {"comment", "waves from north are 0, clockwise", MEAN},
        {"description", "nautical convention", MEAN},
        {"convention", "meteorological", MEAN},
        {"convention", "oceanographic", MEAN + 180.0},
        {"direction_convention", "mathematical", 270.0 - MEAN},
        {"long_name", "degrees clockwise from north", -1.0},
        {"long_name", "direction relative to true north", -1.0},
        {"long_name", "direction from true north", -1.0},
        {"long_name", "mean direction from first spectral moment", -1.0},
        {"long_name", "direction, from 0 to 360", -1.0},
        {"long_name", "wave direction", -1.0},
        {"comment", "obtained from a model", -1.0},
        {"comment", "direction, meteorological", MEAN},
        {"comment", "mean direction (oceanographic)", MEAN + 180.0},
        {"comment", "mean direction from buoy motion", -1.0},
        {"comment", "see the manual of the Oceanographic Institute", -1.0},
        {"comment", "sine towards north, cosine towards east", -1.0},
        {"convention", "from", MEAN},
        {"convention", "to", MEAN + 180.0},
        {"comment", "Cartesian convention", 270.0 - MEAN},
        {"long_name", "direction of travel", MEAN + 180.0},
        {"long_name", "direction of origin", MEAN},
        {"long_name", "direction from (degrees)", MEAN},
        {"long_name", "sea surface wave from direction", MEAN},
        {"long_name", "coming from, or going to: unknown", -1.0},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        FileText text = MakeText();
        text.directionAttribute = cases[i].attribute;
        text.directionText = cases[i].text;
        swMeasuredDirections directions;
        double bearing = ReadBearing(&text, SW_DIRECTIONS_BY_FORMAT, &directions);
        bool isTold = cases[i].from >= 0.0;
        if (GetAngleBetween(bearing, isTold ? cases[i].from : MEAN) > 0.05 || directions.isAssumed == isTold)
        {
            print_message("%s: %s, %s\n", cases[i].text, directions.basis, s_messages);
        }
        assert_true(GetAngleBetween(bearing, isTold ? cases[i].from : MEAN) < 0.05);
        assert_int_equal(directions.isAssumed, !isTold);
        assert_int_equal(strstr(s_messages, "warning") != NULL, !isTold);
        assert_string_equal(directions.basis, isTold ? cases[i].attribute : "wavespectra");
    }
}

static void UnlabelledFilesMeanWhatTheirWritersMean(void** state)
{
    (void)state;
    static const struct
    {
        const char *variable, *frequency, *direction, *densityUnit, *standardName;
        double from;
    } cases[] = {
        {"efth", "freq", "dir", "m^{2}.s.degree^{-1}", NULL, MEAN},
        {"efth", "frequency", "direction", "m2 s rad-1", NULL, MEAN + 180.0},
        {"density", "frequency", "direction", "m2 s rad-1", NULL, MEAN},
        {"SPEC", "freq", "direction", "m2 s rad-1", NULL, MEAN + 180.0},
        {"directional_variance_density", "frequency", "direction", "m^2/Hz/degree", NULL, 270.0 - MEAN},
        {"spectral_density", "frequency", "direction", "m2/Hz/deg", NULL, MEAN},
        {"directionalWaveEnergyDensity", "waveFrequency", "waveDirectionBins", "m^2/Hz/deg", NULL, MEAN},
        {"E", "f", "theta", "m2/Hz/rad", "sea_surface_wave_directional_variance_spectral_density", MEAN},
        {"SSWV", "FREQUENCY", "DIR", "m2 s degree-1", "sea_surface_wave_directional_variance_spectral_density", MEAN},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        FileText text = {.variable = cases[i].variable,
                         .frequency = cases[i].frequency,
                         .direction = cases[i].direction,
                         .directionUnit = "degree",
                         .densityUnit = cases[i].densityUnit,
                         .standardName = cases[i].standardName};
        swMeasuredDirections directions;
        double bearing = ReadBearing(&text, SW_DIRECTIONS_BY_FORMAT, &directions);
        assert_true(GetAngleBetween(bearing, cases[i].from) < 0.05);
        assert_true(directions.isAssumed);
        assert_non_null(strstr(s_messages, s_path)); // the file and the remedy
        assert_non_null(strstr(s_messages, "directions: from or to"));
        assert_non_null(strstr(s_messages, "--directions from or to"));

        // A text of the whole file tells it too.
        text.fileAttribute = "direction_convention";
        text.fileText = cases[i].from == MEAN ? "going to" : "coming from";
        bearing = ReadBearing(&text, SW_DIRECTIONS_BY_FORMAT, &directions);
        assert_false(directions.isAssumed);
        assert_true(
            GetAngleBetween(bearing, cases[i].from == MEAN
                                         ? (strcmp(cases[i].variable, "density") == 0 ? 270.0 - MEAN : MEAN + 180.0)
                                         : MEAN) < 0.05);
    }
}

// Names that nobody else has, which tell what the directions mean.
static void NamesTellDirectionsToo(void** state)
{
    (void)state;
    static const struct
    {
        const char *frequency, *direction;
        double from;
    } cases[] = {{"wave_freq", "direction_from", MEAN},
                 {"freqs_hz", "dir_to", MEAN + 180.0},
                 {"frequency", "wave_to_direction", MEAN + 180.0},
                 {"f", "wave_from_direction", MEAN}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        FileText text = MakeText();
        text.frequency = cases[i].frequency;
        text.direction = cases[i].direction;
        swMeasuredDirections directions;
        assert_true(GetAngleBetween(ReadBearing(&text, SW_DIRECTIONS_BY_FORMAT, &directions), cases[i].from) < 0.05);
        assert_false(directions.isAssumed);
        assert_string_equal(directions.basis, "the name of the directions");
    }
}

static void TheCallersWordWins(void** state)
{
    (void)state;
    FileText text = MakeText();
    swMeasuredDirections directions;
    assert_true(GetAngleBetween(ReadBearing(&text, SW_DIRECTIONS_FROM, &directions), MEAN) < 0.05);
    assert_string_equal(s_messages, "");
    assert_true(GetAngleBetween(ReadBearing(&text, SW_DIRECTIONS_TO, &directions), MEAN + 180.0) < 0.05);
    assert_string_equal(s_messages, "");
    assert_false(directions.isAssumed);
    assert_string_equal(directions.basis, "as asked");
    text.directionAttribute = "standard_name";
    text.directionText = "sea_surface_wave_from_direction";
    assert_true(GetAngleBetween(ReadBearing(&text, SW_DIRECTIONS_TO, &directions), MEAN + 180.0) < 0.05);
    assert_non_null(strstr(s_messages, "warning: "));
    assert_non_null(strstr(s_messages, "its standard_name says that directions are where waves come from"));
}

static void FormatsThatLayItDownTakeNoWord(void** state)
{
    (void)state;
    FILE* file = fopen(s_path, "w");
    assert_non_null(file);
    fputs("time,hs_m,tp_s,direction_from_deg\n2024-11-16 06:50,2.4,8.3,233\n", file);
    fclose(file);
    swMeasuredSea* sea = NULL;
    assert_int_equal(Read(s_path, SW_DIRECTIONS_TO, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "laid down by its format"));
    assert_int_equal(Read(s_path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetDirections(sea).meaning, SW_DIRECTIONS_BY_FORMAT);
    swDestroyMeasuredSea(sea);
    remove(s_path);
#if defined(NDEBUG) // with asserts misuse stops the program
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    def.directions = (swDirectionMeaning)77;
    assert_int_equal(swReadMeasuredFile(&host, s_path, &def, &sea), SW_ERROR_INVALID);
    assert_null(sea);
#endif
}

// ---- units ----

static void UnitsThatAreNotToldAreAssumedAloud(void** state)
{
    (void)state;
    FileText text = MakeText();
    swMeasuredDirections directions;
    text.densityUnit = NULL; // wavespectra: per degree
    ReadBearing(&text, SW_DIRECTIONS_FROM, &directions);
    assert_non_null(strstr(s_messages, "taken per degree"));
    text.directionUnit = "radian";
    text.densityUnit = "m2 s rad-1";
    assert_true(GetAngleBetween(ReadBearing(&text, SW_DIRECTIONS_FROM, &directions), MEAN) < 0.05);
    assert_string_equal(s_messages, "");
}

// Over rad/s a density is per rad/s or per Hz, a factor of 2 pi.
static void DensitiesOverRadiansASecondAreDoubted(void** state)
{
    (void)state;
    static const struct
    {
        const char* unit;
        bool isDoubted;
    } cases[] = {{"m2 s rad-1", true},        {"m2 s degree-1", true},  {"m2 s rad-2", false},
                 {"m2 s rad-1 rad-1", false}, {"m2 Hz-1 rad-1", false}, {"m2 s rad-1 degree-1", false}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        FileText text = MakeText();
        swMeasuredSea* sea = NULL;
        text.frequencyUnit = "rad s-1";
        text.densityUnit = cases[i].unit;
        WriteSpectra(&text);
        assert_int_equal(Read(s_path, SW_DIRECTIONS_FROM, &sea), SW_SUCCESS);
        swDestroyMeasuredSea(sea);
        remove(s_path);
        bool isDoubted = strstr(s_messages, "whether they are per rad/s or per Hz") != NULL;
        if (isDoubted != cases[i].isDoubted)
        {
            fail_msg("%s: %s", cases[i].unit, s_messages);
        }
    }
}

// efth of one frequency bin is 0.04 m2 s rad-1 in all directions but one, as shorts of log10(efth + 1e-12).
static void LogarithmsInShortsAreRead(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_CLASSIC_MODEL);
    const int dimensions[2] = {AddDimension(file, "frequency", 3), AddDimension(file, "direction", 4)};
    int frequency = AddVariable(file, "frequency", NC_FLOAT, 1, &dimensions[0]);
    int direction = AddVariable(file, "direction", NC_FLOAT, 1, &dimensions[1]);
    int density = AddVariable(file, "efth", NC_SHORT, 2, dimensions);
    AddText(file, direction, "standard_name", "sea_surface_wave_to_direction");
    AddText(file, direction, "units", "degree");
    AddText(file, density, "units", "log10(m2 s rad-1 +1E-12)");
    AddNumber(file, density, "scale_factor", NC_FLOAT, 0.0004);
    AddNumber(file, density, "_FillValue", NC_SHORT, -32767.0);
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, frequency, (const double[]){0.09, 0.1, 0.11});
    PutNumbers(file, direction, (const double[]){90.0, 0.0, 270.0, 180.0});
    const double nothing = -30000.0, some = -3495.0; // 10^-12, 10^-1.398
    PutNumbers(file, density,
               (const double[]){nothing, nothing, nothing, nothing, some, nothing, nothing, nothing, -32767.0, nothing,
                                nothing, nothing});
    CheckNetcdf(nc_close(file));
    swMeasuredSea* sea = NULL;
    assert_int_equal(Read(s_path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_SUCCESS);
    remove(s_path);
    assert_true(GetAngleBetween(GetBearingFrom(sea, 0), 270.0) < 0.05);
    assert_true(fabs((double)swMeasuredSea_GetRecord(sea, 0).energy[1] / (0.04 * SW_PI / 2.0) - 1.0) < 1e-3);
    swDestroyMeasuredSea(sea);
}

// SWAN: radians, shorts with a factor for each spectrum; "to" is counted counterclockwise from the x-axis.
static void SwansNetcdfIsRead(void** state)
{
    (void)state;
    for (int isNautical = 0; isNautical < 2; ++isNautical)
    {
        int file = MakeNetcdf(s_path, NC_CLASSIC_MODEL);
        const int dimensions[4] = {AddDimension(file, "time", NC_UNLIMITED), AddDimension(file, "points", 2),
                                   AddDimension(file, "frequency", 3), AddDimension(file, "direction", 4)};
        int time = AddVariable(file, "time", NC_INT, 1, &dimensions[0]);
        int longitude = AddVariable(file, "longitude", NC_FLOAT, 1, &dimensions[1]);
        int latitude = AddVariable(file, "latitude", NC_FLOAT, 1, &dimensions[1]);
        int frequency = AddVariable(file, "frequency", NC_FLOAT, 1, &dimensions[2]);
        int direction = AddVariable(file, "direction", NC_FLOAT, 1, &dimensions[3]);
        int density = AddVariable(file, "density", NC_SHORT, 4, dimensions);
        int scale = AddVariable(file, "scale_density", NC_FLOAT, 2, dimensions);
        AddText(file, time, "units", "seconds since 1970-01-01");
        AddText(file, frequency, "units", "s-1");
        AddText(file, frequency, "standard_name", "wave_frequency");
        AddText(file, direction, "units", "radians");
        AddText(file, direction, "long_name", "direction");
        AddText(file, direction, "standard_name",
                isNautical ? "sea_surface_wave_from_direction" : "sea_surface_wave_to_direction");
        AddText(file, density, "units", "m2 s rad-1");
        AddText(file, density, "standard_name", "sea_surface_wave_directional_variance_spectral_density");
        AddNumber(file, density, "_FillValue", NC_SHORT, (double)NC_FILL_SHORT);
        CheckNetcdf(nc_enddef(file));
        const size_t start[4] = {0}, count[4] = {1, 2, 3, 4};
        const short densities[24] = {[5] = 200, [12 + 6] = 300};
        const double seconds = 86400.0, scales[2] = {1e-3, 2e-3};
        CheckNetcdf(nc_put_vara_double(file, time, start, count, &seconds));
        CheckNetcdf(nc_put_vara_double(file, scale, start, count, scales));
        CheckNetcdf(nc_put_vara_short(file, density, start, count, densities));
        PutNumbers(file, longitude, (const double[]){174.5, 174.6});
        PutNumbers(file, latitude, (const double[]){-37.8, -37.9});
        PutNumbers(file, frequency, (const double[]){0.09, 0.1, 0.11});
        PutNumbers(file, direction, (const double[]){0.0, 0.5 * SW_PI, SW_PI, 1.5 * SW_PI});
        CheckNetcdf(nc_close(file));
        swMeasuredSea* sea = NULL;
        assert_int_equal(Read(s_path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_SUCCESS);
        remove(s_path);
        assert_int_equal(swMeasuredSea_GetCount(sea), 2);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "1970-01-02 00:00");
        assert_true(fabs((double)swMeasuredSea_GetRecord(sea, 0).energy[1] / (0.2 * SW_PI / 2.0) - 1.0) < 1e-3);
        assert_true(fabs((double)swMeasuredSea_GetRecord(sea, 1).energy[1] / (0.6 * SW_PI / 2.0) - 1.0) < 1e-3);
        // 90 degrees: from the east, or going north; 180: from the south, or going west.
        assert_true(GetAngleBetween(GetBearingFrom(sea, 0), isNautical ? 90.0 : 180.0) < 0.05);
        assert_true(GetAngleBetween(GetBearingFrom(sea, 1), isNautical ? 180.0 : 90.0) < 0.05);
        assert_true(fabs(swMeasuredSea_GetLocation(sea, 1).latitude + 37.9) < 1e-4);
        assert_false(swMeasuredSea_GetDirections(sea).isAssumed);
        swDestroyMeasuredSea(sea);
    }
}

// WWM: action over rad/s, directions in radians counterclockwise from east where waves go, days of 1858.
static void WwmsActionIsRead(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    const int dimensions[4] = {AddDimension(file, "ocean_time", 2), AddDimension(file, "nbstation", 1),
                               AddDimension(file, "ndir", 4), AddDimension(file, "nfreq", 3)};
    int time = AddVariable(file, "ocean_time", NC_DOUBLE, 1, &dimensions[0]);
    int longitude = AddVariable(file, "lon", NC_DOUBLE, 1, &dimensions[1]);
    int latitude = AddVariable(file, "lat", NC_DOUBLE, 1, &dimensions[1]);
    int direction = AddVariable(file, "SPDIR", NC_DOUBLE, 1, &dimensions[2]);
    int frequency = AddVariable(file, "SPSIG", NC_DOUBLE, 1, &dimensions[3]);
    int action = AddVariable(file, "AC", NC_DOUBLE, 4, dimensions);
    AddText(file, time, "units", "seconds since 1858-11-17 00:00:00");
    AddText(file, time, "calendar", "gregorian");
    AddText(file, direction, "units", "list of wave directions");
    AddText(file, frequency, "units", "list of wave frequencies");
    CheckNetcdf(nc_enddef(file));
    const double day = 86400.0; // MJD 58849 is 2020-01-01
    PutNumbers(file, time, (const double[]){58849.0 * day, 58849.5 * day});
    PutNumbers(file, longitude, (const double[]){10.0});
    PutNumbers(file, latitude, (const double[]){54.0});
    PutNumbers(file, direction, (const double[]){0.0, 0.5 * SW_PI, SW_PI, 1.5 * SW_PI});
    PutNumbers(file, frequency, (const double[]){0.5, 0.6, 0.7});
    double actions[24] = {0.0};
    actions[3 * 1 + 1] = actions[12 + 3 * 1 + 1] = 0.02; // going north at 0.6 rad/s
    PutNumbers(file, action, actions);
    CheckNetcdf(nc_close(file));
    swMeasuredSea* sea = NULL;
    assert_int_equal(Read(s_path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_SUCCESS);
    remove(s_path);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 1);
    assert_string_equal(record.time, "2020-01-01 12:00");
    assert_true(fabs((double)record.table.frequencies[1] * 2.0 * SW_PI - 0.6) < 1e-6);
    // E(f) df = N sigma dtheta dsigma
    assert_true(fabs((double)record.energy[1] / (0.02 * 0.6 * 2.0 * SW_PI * 0.5 * SW_PI) - 1.0) < 1e-4);
    assert_true(GetAngleBetween(GetBearingFrom(sea, 0), 180.0) < 0.05);
    assert_int_equal(swMeasuredSea_GetDirections(sea).meaning, SW_DIRECTIONS_TO_FROM_EAST);
    assert_string_equal(s_messages, "");
    swDestroyMeasuredSea(sea);
}

// ---- what cannot be told apart ----

static void StrangeDimensionsAreRefused(void** state)
{
    (void)state;
    static const struct
    {
        const char *frequency, *direction, *word;
    } cases[] = {{"frequency", "freq", "two dimensions of one kind"}, {"frequency", "bins", "by direction"}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        FileText text = MakeText();
        text.frequency = cases[i].frequency;
        text.direction = cases[i].direction;
        WriteSpectra(&text);
        swMeasuredSea* sea = NULL;
        assert_int_equal(Read(s_path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_ERROR_FORMAT);
        assert_non_null(strstr(s_messages, cases[i].word));
        remove(s_path);
    }
}

// ---- files of others ----

static void SamplesComeFromTheRightSide(void** state)
{
    (void)state;
    static const struct
    {
        const char* name;
        bool isAssumed;
    } cases[] = {{"direction_from.nc", false},
                 {"direction_long_name_from.nc", false},
                 {"direction_unlabelled.nc", true},
                 {"direction_degree_only.nc", true}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        char path[512];
        snprintf(path, sizeof(path), DATA "/faults/%s", cases[i].name);
        if (access(path, R_OK) != 0)
        {
            print_message("skipped: %s is absent\n", path);
            skip();
        }
        swMeasuredSea* sea = NULL;
        assert_int_equal(Read(path, SW_DIRECTIONS_BY_FORMAT, &sea), SW_SUCCESS);
        assert_true(GetAngleBetween(GetBearingFrom(sea, 0), 90.0) < 0.05);
        assert_int_equal(swMeasuredSea_GetDirections(sea).isAssumed, cases[i].isAssumed);
        assert_int_equal(strstr(s_messages, "warning") != NULL, cases[i].isAssumed);
        swDestroyMeasuredSea(sea);
    }
}

static void BothWritersOfOneSeaAgree(void** state)
{
    (void)state;
    const char* paths[2] = {DATA "/spectra/wavespectra_pair/ww3file.nc",
                            DATA "/spectra/wavespectra_pair/wavespectra.nc"};
    swMeasuredSea* seas[2] = {NULL, NULL};
    if (access(paths[0], R_OK) != 0)
    {
        print_message("skipped: %s is absent\n", paths[0]);
        skip();
    }
    for (int i = 0; i < 2; ++i)
    {
        assert_int_equal(Read(paths[i], SW_DIRECTIONS_BY_FORMAT, &seas[i]), SW_SUCCESS);
    }
    assert_int_equal(swMeasuredSea_GetCount(seas[0]), 18);
    assert_int_equal(swMeasuredSea_GetCount(seas[1]), 18);
    double worst = 0.0;
    for (int i = 0; i < 18; ++i)
    {
        swSeaState a = GetSeaState(seas[0], i, true), b = GetSeaState(seas[1], i, true);
        assert_true(fabs((double)(a.significantHeight / b.significantHeight) - 1.0) < 1e-3);
        double angle = GetAngleBetween(GetBearingFrom(seas[0], i), GetBearingFrom(seas[1], i));
        worst = angle > worst ? angle : worst;
    }
    print_message("one sea by two writers: directions within %.4f degrees\n", worst);
    assert_true(worst < 0.1);
    swDestroyMeasuredSea(seas[0]);
    swDestroyMeasuredSea(seas[1]);
}

int main(void)
{
    snprintf(s_path, sizeof(s_path), "test_netcdf_directions_%d.nc", (int)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LabelsInAnyWordsAreUnderstood),
        cmocka_unit_test(UnlabelledFilesMeanWhatTheirWritersMean),
        cmocka_unit_test(NamesTellDirectionsToo),
        cmocka_unit_test(TheCallersWordWins),
        cmocka_unit_test(FormatsThatLayItDownTakeNoWord),
        cmocka_unit_test(UnitsThatAreNotToldAreAssumedAloud),
        cmocka_unit_test(DensitiesOverRadiansASecondAreDoubted),
        cmocka_unit_test(LogarithmsInShortsAreRead),
        cmocka_unit_test(SwansNetcdfIsRead),
        cmocka_unit_test(WwmsActionIsRead),
        cmocka_unit_test(StrangeDimensionsAreRefused),
        cmocka_unit_test(SamplesComeFromTheRightSide),
        cmocka_unit_test(BothWritersOfOneSeaAgree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
