// SPDX-License-Identifier: MIT
// Energies with circular moments in netCDF, as NDBC, CDIP, Sofar, Copernicus and WAVEWATCH III write them: the same
// waves in each one's names, units and conventions become the same sea. Then what may be wrong with a file: records
// without values, bad flags, missing times, cut files.

#include "support/cmocka_setup.h"
#include "support/sea_states.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "seaway/files.h"
#include "support/netcdf_maker.h"

#define DATA SW_SOURCE_DIR "/../shared/data/spectra"
#define DEGREE (SW_PI / 180.0)
#define FREQUENCIES 8
#define TIMES 4
#define FROM 300.0 // bearing
#define R1 0.85
#define R2 0.6

static char s_path[128];

static swResult Read(const char* path, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    swResult result = swReadMeasuredSea(&host, path, sea);
    assert_true((result == SW_SUCCESS) == (*sea != NULL));
    return result;
}

static swMeasuredSea* ReadFine(const char* path)
{
    swMeasuredSea* sea = NULL;
    swResult result = Read(path, &sea);
    if (result != SW_SUCCESS)
    {
        print_message("%s", s_messages);
    }
    assert_int_equal(result, SW_SUCCESS);
    return sea;
}

// ---- one sea in everyone's words ----

typedef enum Kind
{
    FOURIER,
    POLAR,
    SPREAD
} Kind;

typedef struct Writer
{
    Kind kind;
    double angle; // of the first moments, as this writer counts it, degrees
    const char *time, *timeUnit, *frequency, *energy, *energyUnit;
    const char* moments[4];
    const char* width;
    double scale; // packed integers of this; 0: doubles
    const char* flag;
} Writer;

static const Writer writers[] = {
    {POLAR,
     FROM,
     "time",
     "seconds since 1970-01-01T00:00:00+00:00",
     "frequency",
     "spectral_wave_density",
     "(meter * meter)/Hz",
     {"mean_wave_dir", "wave_spectrum_r1", "principal_wave_dir", "wave_spectrum_r2"},
     NULL,
     1e-5,
     NULL},
    {FOURIER,
     FROM,
     "waveTime",
     "seconds since 1970-01-01 00:00:00 UTC",
     "waveFrequency",
     "waveEnergyDensity",
     "meter^2 second",
     {"waveA1Value", "waveB1Value", "waveA2Value", "waveB2Value"},
     "waveBandwidth",
     0.0,
     "waveFlagPrimary"},
    {FOURIER,
     270.0 - FROM,
     "time",
     "minutes since 1970-01-01T00:00:00",
     "frequency",
     "variance_density",
     "m^2/Hz",
     {"a1", "b1", "a2", "b2"},
     NULL,
     0.0,
     NULL},
    {SPREAD,
     FROM,
     "TIME",
     "days since 1950-01-01T00:00:00Z",
     "FREQUENCY",
     "VSPEC1D",
     "m2 s",
     {"THETA1", "STHETA1", "THETA2", "STHETA2"},
     NULL,
     0.0,
     NULL},
    {SPREAD,
     FROM,
     "time",
     "days since 1990-01-01 00:00:00",
     "frequency",
     "ef",
     "m2 s",
     {"th1m", "sth1m", "th2m", "sth2m"},
     NULL,
     0.0,
     NULL},
};
#define WRITER_COUNT (sizeof(writers) / sizeof(writers[0]))

static double GetTimeUnit(const Writer* writer, double seconds)
{
    double origin = strstr(writer->timeUnit, "1950") != NULL   ? -631152000.0
                    : strstr(writer->timeUnit, "1990") != NULL ? 631152000.0
                                                               : 0.0;
    double unit = writer->timeUnit[0] == 'd' ? 86400.0 : writer->timeUnit[0] == 'm' ? 60.0 : 1.0;
    return (seconds - origin) / unit;
}

// What the writer has for moment j.
static double GetMoment(const Writer* writer, int j)
{
    double angle = writer->angle * DEGREE, r = j < 2 ? R1 : R2;
    int order = j < 2 ? 1 : 2;
    bool isFirst = j % 2 == 0;
    if (writer->kind == FOURIER)
    {
        return r * (isFirst ? cos(order * angle) : sin(order * angle));
    }
    double spread = order == 1 ? sqrt(2.0 * (1.0 - R1)) : sqrt((1.0 - R2) / 2.0);
    return isFirst ? writer->angle : writer->kind == POLAR ? r : spread / DEGREE;
}

// Energies are 2 m2/Hz at 0.1 Hz. Record 1 has no value at all.
static void WriteMoments(const Writer* writer, bool withEmpty, const double* flags)
{
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    const int dimensions[4] = {AddDimension(file, writer->time, TIMES),
                               AddDimension(file, writer->frequency, FREQUENCIES), AddDimension(file, "latitude", 1),
                               AddDimension(file, "longitude", 1)};
    nc_type type = writer->scale > 0.0 ? NC_INT : NC_DOUBLE;
    double fill = writer->scale > 0.0 ? -32767.0 : -999.99;
    int time = AddVariable(file, writer->time, NC_DOUBLE, 1, &dimensions[0]);
    int frequency = AddVariable(file, writer->frequency, NC_DOUBLE, 1, &dimensions[1]);
    int latitude = AddVariable(file, "latitude", NC_FLOAT, 1, &dimensions[2]);
    int longitude = AddVariable(file, "longitude", NC_FLOAT, 1, &dimensions[3]);
    int width = writer->width != NULL ? AddVariable(file, writer->width, NC_DOUBLE, 1, &dimensions[1]) : -1;
    int flag = writer->flag != NULL ? AddVariable(file, writer->flag, NC_BYTE, 1, &dimensions[0]) : -1;
    int variables[5];
    for (int j = 0; j < 5; ++j)
    {
        variables[j] = AddVariable(file, j == 0 ? writer->energy : writer->moments[j - 1], type, 4, dimensions);
        AddNumber(file, variables[j], "_FillValue", type, fill);
        if (writer->scale > 0.0)
        {
            AddNumber(file, variables[j], "scale_factor", NC_DOUBLE, writer->scale);
        }
    }
    AddText(file, variables[0], "units", writer->energyUnit);
    AddText(file, time, "units", writer->timeUnit);
    CheckNetcdf(nc_enddef(file));
    double times[TIMES], values[TIMES * FREQUENCIES], frequencies[FREQUENCIES], widths[FREQUENCIES];
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        frequencies[i] = 0.07 + 0.01 * i;
        widths[i] = 0.01;
    }
    for (int i = 0; i < TIMES; ++i)
    {
        times[i] = GetTimeUnit(writer, 1577836800.0 + 3600.0 * i); // 2020-01-01
    }
    for (int j = 0; j < 5; ++j)
    {
        for (int i = 0; i < TIMES * FREQUENCIES; ++i)
        {
            double value = j == 0 ? (i % FREQUENCIES == 3 ? 2.0 : 0.1) : GetMoment(writer, j - 1);
            bool isMissing = withEmpty && i / FREQUENCIES == 1;
            isMissing = isMissing || (j > 0 && i % FREQUENCIES == 7); // a frequency without directions
            values[i] = isMissing ? fill : writer->scale > 0.0 ? floor(value / writer->scale + 0.5) : value;
        }
        PutNumbers(file, variables[j], values);
    }
    PutNumbers(file, time, times);
    PutNumbers(file, frequency, frequencies);
    PutNumbers(file, latitude, (const double[]){27.5});
    PutNumbers(file, longitude, (const double[]){-82.0});
    if (width >= 0)
    {
        PutNumbers(file, width, widths);
    }
    if (flag >= 0)
    {
        PutNumbers(file, flag, flags);
    }
    CheckNetcdf(nc_close(file));
}

static const double fineFlags[TIMES] = {1.0, 1.0, 2.0, 1.0};

static void EveryWriterTellsTheSameSea(void** state)
{
    (void)state;
    for (size_t i = 0; i < WRITER_COUNT; ++i)
    {
        WriteMoments(&writers[i], false, fineFlags);
        swMeasuredSea* sea = ReadFine(s_path);
        remove(s_path);
        assert_int_equal(swMeasuredSea_GetCount(sea), TIMES);
        for (int k = 0; k < TIMES; ++k)
        {
            swMeasuredRecord record = swMeasuredSea_GetRecord(sea, k);
            char time[32];
            snprintf(time, sizeof(time), "2020-01-01 %02d:00", k);
            assert_string_equal(record.time, time);
            assert_non_null(record.meanDirection);
            for (int j = 0; j < FREQUENCIES; ++j)
            {
                assert_true(GetAngleBetween(GetBearing(record.meanDirection[j]), FROM) < 0.02);
                assert_true(fabs((double)record.r1[j] - R1) < 1e-3);
                assert_true(fabs((double)record.r2[j] - R2) < 1e-3);
                // Twice the angle is counted from 0 to 360, so the angle itself from 0 to 180.
                assert_true(fabs(remainder(GetBearing(record.direction2[j]) - FROM, 180.0)) < 0.02);
                assert_true(fabs((double)record.energy[j] / (j == 3 ? 2.0 : 0.1) - 1.0) < 1e-4);
                assert_true(fabs((double)record.table.bandwidths[j] / 0.01 - 1.0) < 1e-4);
            }
        }
        assert_true(fabs(swMeasuredSea_GetLocation(sea, 0).longitude + 82.0) < 1e-4);
        assert_int_equal(swMeasuredSea_GetDirections(sea).isAssumed, strcmp(writers[i].energy, "ef") == 0);
        swDestroyMeasuredSea(sea);
    }
}

static void RecordsWithoutValuesAreLeftOutAloud(void** state)
{
    (void)state;
    for (size_t i = 0; i < WRITER_COUNT; ++i)
    {
        WriteMoments(&writers[i], true, fineFlags);
        swMeasuredSea* sea = ReadFine(s_path);
        remove(s_path);
        assert_int_equal(swMeasuredSea_GetCount(sea), TIMES - 1);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 1).time, "2020-01-01 02:00");
        assert_non_null(strstr(s_messages, "warning: "));
        assert_non_null(strstr(s_messages, "1 of 4 records hold no value at all"));
        swDestroyMeasuredSea(sea);
    }
}

static void RecordsFlaggedAsBadAreLeftOut(void** state)
{
    (void)state;
    const double flags[TIMES] = {1.0, 4.0, 3.0, 9.0};
    const Writer* cdip = &writers[1];
    WriteMoments(cdip, false, flags);
    swMeasuredSea* sea = ReadFine(s_path);
    remove(s_path);
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    assert_non_null(strstr(s_messages, "2 of 4 records are flagged as bad or missing"));
    assert_non_null(strstr(s_messages, "1 of 4 records are flagged as questionable"));
    swDestroyMeasuredSea(sea);
}

static void EnergiesAloneHaveNoDirections(void** state)
{
    (void)state;
    Writer lone = writers[0];
    lone.moments[0] = "unheard_of";
    WriteMoments(&lone, false, fineFlags);
    swMeasuredSea* sea = ReadFine(s_path);
    remove(s_path);
    assert_null(swMeasuredSea_GetRecord(sea, 0).meanDirection);
    assert_non_null(strstr(s_messages, "without directions"));
    swDestroyMeasuredSea(sea);
}

// NDBC's 999 and CDIP's -999.99 without an attribute that declares them.
static void UndeclaredFillersAreMissing(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_CLASSIC_MODEL);
    const int dimensions[2] = {AddDimension(file, "time", 1), AddDimension(file, "frequency", 4)};
    int time = AddVariable(file, "time", NC_DOUBLE, 1, dimensions);
    int frequency = AddVariable(file, "frequency", NC_DOUBLE, 1, &dimensions[1]);
    int energy = AddVariable(file, "spectral_wave_density", NC_DOUBLE, 2, dimensions);
    int angle = AddVariable(file, "mean_wave_dir", NC_DOUBLE, 2, dimensions);
    int length = AddVariable(file, "wave_spectrum_r1", NC_DOUBLE, 2, dimensions);
    AddText(file, time, "units", "seconds since 1970-01-01");
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, time, (const double[]){0.0});
    PutNumbers(file, frequency, (const double[]){0.1, 0.11, 0.12, 0.13});
    PutNumbers(file, energy, (const double[]){1.0, 999.0, 1.0, 1.0});
    PutNumbers(file, angle, (const double[]){FROM, 999.0, 999.0, FROM});
    PutNumbers(file, length, (const double[]){R1, 999.0, R1, 999.0});
    CheckNetcdf(nc_close(file));
    swMeasuredSea* sea = ReadFine(s_path);
    remove(s_path);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(record.energy[0] == 1.0f && record.energy[1] == 0.0f);
    for (int i = 0; i < 4; ++i)
    {
        assert_true(GetAngleBetween(GetBearing(record.meanDirection[i]), FROM) < 0.02);
        // The last frequency has a direction and no r1: that of cos^16(theta/2).
        assert_true(fabs((double)record.r1[i] - (i < 2 ? R1 : 8.0 / 9.0)) < 1e-3);
    }
    swDestroyMeasuredSea(sea);
}

// ---- times ----

static void TimesOfAnyOriginAreRead(void** state)
{
    (void)state;
    static const struct
    {
        const char *unit, *calendar;
        double value;
        const char* time; // NULL: refused
    } cases[] = {
        {"seconds since 1970-01-01 00:00:00 UTC", NULL, 1577836800.0, "2020-01-01 00:00"},
        {"Seconds since 1970-1-1 0:0:0", "standard", 1577836800.0, "2020-01-01 00:00"},
        {"days since 1858-11-17 00:00:00", "gregorian", 58849.25, "2020-01-01 06:00"},
        {"days since 0001-01-01 00:00:00", "gregorian", 737426.0, "2020-01-01 00:00"}, // Julian: two days more
        {"days since 0001-01-01", "proleptic_gregorian", 737424.0, "2020-01-01 00:00"},
        {"hours since 1900-01-01 00:00:0.0", NULL, 1051896.0, "2020-01-01 00:00"},
        {"hours since 2020-01-01T03:00:00+03:00", NULL, 1.0, "2020-01-01 01:00"},
        {"minutes since 2019-12-31 19:00 -0500", NULL, 30.0, NULL},
        {"minutes since 2019-12-31 19:00 -05:00", NULL, 30.0, "2020-01-01 00:30"},
        {"nanoseconds since 1970-01-01", NULL, 1577836800e9, "2020-01-01 00:00"},
        {"h since 2020-01-01", NULL, 2.0, "2020-01-01 02:00"},
        {"days since 2020-01-01", "noleap", 1.0, NULL},
        {"days since yesterday", NULL, 1.0, NULL},
        {"months since 2020-01-01", NULL, 1.0, NULL},
        {"days", NULL, 1.0, NULL},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        int file = MakeNetcdf(s_path, NC_CLASSIC_MODEL);
        const int dimensions[2] = {AddDimension(file, "time", 1), AddDimension(file, "freq", 3)};
        int time = AddVariable(file, "time", NC_DOUBLE, 1, &dimensions[0]);
        int frequency = AddVariable(file, "freq", NC_DOUBLE, 1, &dimensions[1]);
        int energy = AddVariable(file, "efth", NC_DOUBLE, 2, dimensions);
        AddText(file, time, "units", cases[i].unit);
        AddText(file, time, "calendar", cases[i].calendar);
        AddText(file, energy, "units", "m2 s");
        CheckNetcdf(nc_enddef(file));
        PutNumbers(file, time, &cases[i].value);
        PutNumbers(file, frequency, (const double[]){0.1, 0.2, 0.3});
        PutNumbers(file, energy, (const double[]){0.0, 1.0, 0.0});
        CheckNetcdf(nc_close(file));
        swMeasuredSea* sea = NULL;
        swResult result = Read(s_path, &sea);
        remove(s_path);
        if (result != (cases[i].time != NULL ? SW_SUCCESS : SW_ERROR_FORMAT))
        {
            print_message("%s: %s\n", cases[i].unit, s_messages);
        }
        assert_int_equal(result, cases[i].time != NULL ? SW_SUCCESS : SW_ERROR_FORMAT);
        if (sea != NULL)
        {
            assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, cases[i].time);
        }
        swDestroyMeasuredSea(sea);
    }
}

// ---- grids ----

// Six places of a grid at two times: land, a place whose latitude is missing, one bad time, one impossible density.
static void OneBadElementSpoilsNoOther(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    const int dimensions[5] = {AddDimension(file, "valid_time", 3), AddDimension(file, "latitude", 3),
                               AddDimension(file, "longitude", 2), AddDimension(file, "frequency", 4),
                               AddDimension(file, "direction", 4)};
    int time = AddVariable(file, "valid_time", NC_DOUBLE, 1, &dimensions[0]);
    int latitude = AddVariable(file, "latitude", NC_DOUBLE, 1, &dimensions[1]);
    int longitude = AddVariable(file, "longitude", NC_DOUBLE, 1, &dimensions[2]);
    int density = AddVariable(file, "d2fd", NC_DOUBLE, 5, dimensions);
    AddText(file, time, "units", "hours since 2020-01-01");
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, time, (const double[]){0.0, (double)NAN, 6.0});
    PutNumbers(file, latitude, (const double[]){50.0, (double)NAN, 49.0});
    PutNumbers(file, longitude, (const double[]){357.0, 358.0});
    double values[3 * 6 * 16];
    for (int i = 0; i < 3 * 6 * 16; ++i)
    {
        int place = i / 16 % 6, moment = i / 96;
        values[i] = place == 1 || (place == 4 && moment == 2) ? (double)NAN : place == 5 && moment == 0 ? 9.0 : -1.0;
    }
    PutNumbers(file, density, values);
    CheckNetcdf(nc_close(file));
    swMeasuredSea* sea = ReadFine(s_path);
    remove(s_path);
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), 6);
    assert_int_equal(swMeasuredSea_GetLocation(sea, 0).recordCount, 2);
    assert_int_equal(swMeasuredSea_GetLocation(sea, 1).recordCount, 0); // land
    assert_int_equal(swMeasuredSea_GetLocation(sea, 2).recordCount, 2);
    assert_true(swMeasuredSea_GetLocation(sea, 2).latitude != swMeasuredSea_GetLocation(sea, 2).latitude);
    assert_int_equal(swMeasuredSea_GetLocation(sea, 4).recordCount, 1);
    assert_int_equal(swMeasuredSea_GetLocation(sea, 5).recordCount, 1);
    assert_non_null(strstr(s_messages, "1 of 6 places have no spectra"));
    assert_non_null(strstr(s_messages, "warning: "));
    assert_non_null(strstr(s_messages, "6 of 18 records have no time"));
    assert_non_null(strstr(s_messages, "1 of 18 records hold densities that no sea has"));
    double distance = 0.0;
    assert_int_equal(swMeasuredSea_FindNearest(sea, -2.1, 49.1, &distance), 5);
    assert_int_equal(swMeasuredSea_FindNearest(sea, 358.0, 50.0, &distance), 0); // 1 is land
    swDestroyMeasuredSea(sea);
}

// ---- damage ----

static char* ReadBytes(const char* path, size_t* size)
{
    FILE* file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char* bytes = malloc(*size);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

// A cut file is read as far as it goes or refused with a sentence; it never crashes.
static void CutFilesAreRefused(void** state)
{
    (void)state;
    WriteMoments(&writers[0], false, fineFlags);
    size_t size = 0;
    char* bytes = ReadBytes(s_path, &size);
    int refused = 0, tries = 0;
    for (size_t length = 0; length < size; length += size / 40 + 1, ++tries)
    {
        FILE* file = fopen(s_path, "wb");
        assert_non_null(file);
        assert_int_equal(fwrite(bytes, 1, length, file), length);
        fclose(file);
        swMeasuredSea* sea = NULL;
        swResult result = Read(s_path, &sea);
        assert_true(result == SW_SUCCESS || strlen(s_messages) > 0);
        refused += result != SW_SUCCESS;
        swDestroyMeasuredSea(sea);
    }
    remove(s_path);
    free(bytes);
    print_message("%d of %d cut files were refused\n", refused, tries);
    assert_true(refused > tries / 2);
}

static void EmptyAndHugeDimensionsAreRefused(void** state)
{
    (void)state;
    for (int i = 0; i < 4; ++i)
    {
        int file = MakeNetcdf(s_path, NC_NETCDF4);
        const size_t lengths[4] = {i == 0 ? NC_UNLIMITED : 1, i == 1 ? 2000 : i == 2 ? 1 : 4, i == 3 ? 2000000 : 1, 0};
        const int dimensions[3] = {AddDimension(file, "time", lengths[0]), AddDimension(file, "frequency", lengths[1]),
                                   AddDimension(file, "station", lengths[2])};
        int time = AddVariable(file, "time", NC_DOUBLE, 1, dimensions);
        AddVariable(file, "frequency", NC_DOUBLE, 1, &dimensions[1]);
        AddVariable(file, "spectral_wave_density", NC_FLOAT, 3, dimensions);
        AddText(file, time, "units", "hours since 2020-01-01");
        CheckNetcdf(nc_enddef(file));
        CheckNetcdf(nc_close(file));
        swMeasuredSea* sea = NULL;
        assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
        remove(s_path);
        assert_true(strlen(s_messages) > 0);
    }
}

// Texts, and structures, where numbers should be.
static void WhatIsNoNumberIsRefused(void** state)
{
    (void)state;
    for (int i = 0; i < 6; ++i)
    {
        int file = MakeNetcdf(s_path, NC_NETCDF4);
        nc_type structure = NC_NAT;
        CheckNetcdf(nc_def_compound(file, sizeof(double), "structure", &structure));
        CheckNetcdf(nc_insert_compound(file, structure, "part", 0, NC_DOUBLE));
        nc_type type = i % 3 == 0 ? NC_CHAR : i % 3 == 1 ? NC_STRING : structure;
        const int dimensions[2] = {AddDimension(file, "time", 1), AddDimension(file, "frequency", 4)};
        int time = AddVariable(file, "time", NC_DOUBLE, 1, dimensions);
        int frequency = AddVariable(file, "frequency", i < 3 ? NC_DOUBLE : type, 1, &dimensions[1]);
        AddVariable(file, "spectral_wave_density", i < 3 ? type : NC_DOUBLE, 2, dimensions);
        AddText(file, time, "units", "hours since 2020-01-01");
        CheckNetcdf(nc_enddef(file));
        PutNumbers(file, time, (const double[]){1.0});
        if (i < 3)
        {
            PutNumbers(file, frequency, (const double[]){0.1, 0.2, 0.3, 0.4});
        }
        CheckNetcdf(nc_close(file));
        swMeasuredSea* sea = NULL;
        assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
        remove(s_path);
        assert_non_null(strstr(s_messages, "does not hold numbers"));
    }
}

// ---- files of others ----

static void SamplesOfOthersAreRead(void** state)
{
    (void)state;
    static const struct
    {
        const char *path, *basis;
        int count;
        double low, high; // Hs of the highest record
    } cases[] = {{DATA "/ndbc_netcdf_42098/42098w9999.nc", "NDBC", 100, 1.6, 1.75},
                 {DATA "/sofar_netcdf_2025-08/spotter_spectrum.nc", "Sofar", 103, 6.0, 6.2},
                 {DATA "/mhkit_netcdf/dir_spectra.nc", "MHKiT", 100, 0.5, 0.6}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        if (access(cases[i].path, R_OK) != 0)
        {
            print_message("skipped: %s is absent\n", cases[i].path);
            skip();
        }
        swMeasuredSea* sea = ReadFine(cases[i].path);
        assert_int_equal(swMeasuredSea_GetCount(sea), cases[i].count);
        assert_string_equal(swMeasuredSea_GetDirections(sea).basis, cases[i].basis);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, swMeasuredSea_FindLargest(sea));
        double variance = 0.0;
        for (int j = 0; j < record.table.frequencyCount; ++j)
        {
            variance += (double)record.energy[j] * (double)record.table.bandwidths[j];
        }
        assert_true(4.0 * sqrt(variance) > cases[i].low && 4.0 * sqrt(variance) < cases[i].high);
        assert_non_null(record.meanDirection);
        swDestroyMeasuredSea(sea);
    }
}

int main(void)
{
    snprintf(s_path, sizeof(s_path), "test_netcdf_moments_%d.nc", (int)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryWriterTellsTheSameSea),       cmocka_unit_test(RecordsWithoutValuesAreLeftOutAloud),
        cmocka_unit_test(RecordsFlaggedAsBadAreLeftOut),    cmocka_unit_test(EnergiesAloneHaveNoDirections),
        cmocka_unit_test(UndeclaredFillersAreMissing),      cmocka_unit_test(TimesOfAnyOriginAreRead),
        cmocka_unit_test(OneBadElementSpoilsNoOther),       cmocka_unit_test(CutFilesAreRefused),
        cmocka_unit_test(EmptyAndHugeDimensionsAreRefused), cmocka_unit_test(SamplesOfOthersAreRead),
        cmocka_unit_test(WhatIsNoNumberIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
