// SPDX-License-Identifier: MIT
// Files of measured seas that need a library: JSON of Spotter buoys and of MHKiT, netCDF of WAVEWATCH III and ERA5,
// which these tests write themselves in the orders and units that their makers may choose.

#include "support/cmocka_setup.h"
#include "support/netcdf_maker.h"
#include "support/sea_states.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#if defined(SW_HAS_NETCDF)
#include <netcdf.h>
#endif

#include "seaway/math.h"
#include "seaway/measured.h"
#include "seaway/files.h"

#define DATA SW_SOURCE_DIR "/../shared/data/spectra"
#define DEGREE (SW_PI / 180.0)

static char s_path[256];

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

static void SkipWithout(const char* path)
{
    if (access(path, R_OK) != 0)
    {
        print_message("skipped: %s is absent\n", path);
        skip();
    }
}

static void WriteFile(const char* text)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
    fclose(file);
}

// ---- JSON ----

#if defined(SW_HAS_JSON)

static void SpottersJsonIsRead(void** state)
{
    (void)state;
    WriteFile("{\"data\":{\"spotterId\":\"SPOT-7\",\"frequencyData\":["
              "{\"frequency\":[0.20,0.1,0.3],\"df\":[0.05,0.02,0.1],\"varianceDensity\":[2.0,3.0,null],"
              "\"a1\":[-0.6,0.8,null],\"b1\":[0.0,0.0,null],\"a2\":[0.1,0.5,null],\"b2\":[0.0,0.0,null],"
              "\"timestamp\":\"2018-02-14T04:27:19.250Z\",\"latitude\":-61.1,\"longitude\":173.4},"
              "{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,1],\"timestamp\":\"2018-02-14T00:27:19.000Z\"}]}}");
    swMeasuredSea* sea = ReadFine(s_path);
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    assert_string_equal(swMeasuredSea_GetLocation(sea, 0).name, "SPOT-7");
    assert_true(swMeasuredSea_GetLocation(sea, 0).latitude == -61.1);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 1);
    assert_string_equal(record.time, "2018-02-14 04:27");
    assert_true(fabs(record.seconds - 1518582439.25) < 1e-3);
    assert_true(record.table.frequencies[0] == 0.1f && record.table.bandwidths[0] == 0.02f);
    assert_true(record.energy[0] == 3.0f && record.energy[1] == 2.0f && record.energy[2] == 0.0f);
    assert_true(GetAngleBetween(GetBearing(record.meanDirection[0]), 270.0) < 1e-3); // goes east
    assert_true(GetAngleBetween(GetBearing(record.meanDirection[1]), 90.0) < 1e-3);
    assert_null(swMeasuredSea_GetRecord(sea, 0).meanDirection);
    swDestroyMeasuredSea(sea);
}

static void OneBrokenRecordOfJsonIsLeftOut(void** state)
{
    (void)state;
#define RECORD(hour, density)                                                                                          \
    "{\"frequency\":[0.1,0.2],\"varianceDensity\":[1," density "],\"timestamp\":\"2018-02-14T0" hour ":00:00.000Z\"}"
    static const char* const broken[] = {RECORD("1", "\"high\""), RECORD("x", "1"), RECORD("1", "1e9"), "7",
                                         "{\"frequency\":[0.1,0.2],\"varianceDensity\":[1]}"};
    for (size_t i = 0; i < sizeof(broken) / sizeof(broken[0]); ++i)
    {
        char text[1024];
        snprintf(text, sizeof(text), "\xEF\xBB\xBF{\"data\":{\"frequencyData\":[%s,%s,%s]}}", RECORD("0", "1"),
                 broken[i], RECORD("2", "1"));
        WriteFile(text);
        swMeasuredSea* sea = ReadFine(s_path);
        assert_int_equal(swMeasuredSea_GetCount(sea), 2);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 1).time, "2018-02-14 02:00");
        assert_non_null(strstr(s_messages, "It is left out (record 2)."));
        swDestroyMeasuredSea(sea);
    }
}

// Without moments the directions and spreads tell them.
static void SpottersDirectionsStandInForMoments(void** state)
{
    (void)state;
    WriteFile(
        "{\"data\":{\"frequencyData\":[{\"frequency\":[0.1,0.11],\"varianceDensity\":[1,2],\"direction\":[250,250],"
        "\"directionalSpread\":[20,20],\"timestamp\":\"2020-01-02T03:04:05Z\"}]}}");
    swMeasuredSea* sea = NULL;
    assert_int_equal(Read(s_path, &sea), SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_non_null(record.meanDirection);
    double spread = 20.0 * (SW_PI / 180.0),
           turned = (double)(record.meanDirection[1] - SW_DIRECTION_FROM_BEARING(250.0));
    assert_true(cos(turned) > 0.999999);
    assert_true(fabs((double)record.r1[1] - (1.0 - 0.5 * spread * spread)) < 1e-4);
    swDestroyMeasuredSea(sea);
}

static void WrongJsonIsNamed(void** state)
{
    (void)state;
    static const char* const cases[][2] = {
        {"{\"a\":", ":1: this is no JSON"},
        {"{\"a\":\n\n}", ":3: this is no JSON"},
        {"[1,2]", "neither frequencyData"},
        {"{\"frequencyData\":[]}", "no list of records"},
        {"{\"frequencyData\":[{\"frequency\":[1,2],\"varianceDensity\":[1]}]}", "varianceDensity has 1 numbers"},
        {"{\"frequencyData\":[{\"frequency\":[1,\"x\"],\"varianceDensity\":[1,1]}]}", "item 2 of frequency"},
        {"{\"frequencyData\":[{\"frequency\":[1,2],\"varianceDensity\":[1,1],\"timestamp\":\"noon\"}]}", "timestamp"},
        {"{\"A\":{\"S\":{\"low\":1}}}", "'low' in S"},
        {"{\"A\":{\"S\":{\"0.1\":1}}}", "1 frequencies"},
        {"{\"A\":{\"S\":{\"0.1\":1,\"0.2\":1e9}}}", "at most 50000"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        WriteFile(cases[i][0]);
        assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
        if (strstr(s_messages, cases[i][1]) == NULL)
        {
            print_message("%s says %s\n", cases[i][0], s_messages);
        }
        assert_non_null(strstr(s_messages, cases[i][1]));
    }
}

static void SouthernOceansSpotterIsReadAsExpected(void** state)
{
    (void)state;
    SkipWithout(DATA "/spotter_southern_ocean_2018-02/spotter_20180214.json");
    // Hs, Tp, mean period, direction and spread of the peak, mean direction and spread: the buoy's own.
    static const double expected[8][7] = {
        {1.62, 10.24, 8.73, 299.98, 63.32, 349.21, 69.95}, {1.67, 14.63, 7.79, 22.83, 46.53, 355.16, 65.48},
        {1.60, 6.02, 7.26, 16.32, 57.64, 6.85, 64.96},     {2.43, 10.24, 7.90, 309.21, 53.66, 295.79, 63.15},
        {2.39, 10.24, 8.16, 303.86, 60.24, 285.60, 64.19}, {2.20, 10.24, 8.07, 314.49, 59.45, 287.57, 63.20},
        {2.28, 10.24, 8.49, 312.41, 61.23, 285.67, 60.63}, {2.32, 10.24, 8.64, 310.69, 58.02, 287.82, 59.12}};
    swMeasuredSea* sea = ReadFine(DATA "/spotter_southern_ocean_2018-02/spotter_20180214.json");
    assert_int_equal(swMeasuredSea_GetCount(sea), 8);
    double worst[6] = {0};
    for (int i = 0; i < 8; ++i)
    {
        swSeaState seaState = GetSeaState(sea, i, true);
        worst[0] = fmax(worst[0], fabs((double)seaState.significantHeight - expected[i][0]));
        worst[1] = fmax(worst[1], fabs((double)seaState.peakPeriod - expected[i][1]));
        worst[2] = fmax(worst[2], fabs((double)seaState.periodTm01 / expected[i][2] - 1.0));
        worst[3] = fmax(worst[3], GetAngleBetween(GetBearing(seaState.peakDirection), expected[i][3]));
        worst[4] = fmax(worst[4], GetAngleBetween(GetBearing(seaState.meanDirection), expected[i][5]));
        worst[5] = fmax(worst[5], fabs((double)seaState.spread / DEGREE - expected[i][6]));
    }
    print_message("Spotter, worst: Hs %.3f m, Tp %.3f s, Tm01 %.2f %%, direction at the peak %.2f, mean %.2f, spread "
                  "%.2f degrees\n",
                  worst[0], worst[1], 100.0 * worst[2], worst[3], worst[4], worst[5]);
    assert_true(worst[0] < 0.03 && worst[1] < 0.02 && worst[2] < 0.02);
    assert_true(worst[3] < 3.0 && worst[4] < 3.0 && worst[5] < 3.0);
    swDestroyMeasuredSea(sea);
}

static void CdipsSpectraHaveTheirMoments(void** state)
{
    (void)state;
    SkipWithout(DATA "/cdip_mhkit/ValData2_CDiP.json");
    // Hm0, Te, Tm01, Tm02, Tp.
    static const double expected[2][5] = {{3.04809, 8.90335, 7.76839, 6.97749, 11.7647},
                                          {1.02972, 6.51356, 5.45806, 4.94286, 8.33333}};
    swMeasuredSea* sea = ReadFine(DATA "/cdip_mhkit/ValData2_CDiP.json");
    assert_int_equal(swMeasuredSea_FindLocation(sea, "CDiP6"), 1);
    for (int i = 0; i < 2; ++i)
    {
        swSeaState seaState = GetSeaState(sea, i, true);
        const double values[5] = {(double)seaState.significantHeight, (double)seaState.energyPeriod,
                                  (double)seaState.periodTm01, (double)seaState.periodTm02,
                                  (double)seaState.peakPeriod};
        for (int j = 0; j < 5; ++j)
        {
            assert_true(fabs(values[j] / expected[i][j] - 1.0) < 0.01);
        }
        assert_string_equal(swMeasuredSea_GetRecord(sea, i).time, "");
    }
    swDestroyMeasuredSea(sea);
}

#endif

// ---- netCDF ----

#if defined(SW_HAS_NETCDF)

#define FREQUENCIES 30
#define DIRECTIONS 24

// A swell from 250 degrees; m^2/Hz/rad by where waves come from.
static double Density(double frequency, double bearing)
{
    double x = log(frequency / 0.08) / 0.2, half = 0.5 * (bearing - 250.0) * DEGREE;
    return 3.0 * exp(-0.5 * x * x) * pow(cos(half) * cos(half), 12.0);
}

static double GetFrequency(int i)
{
    return 0.03453 * pow(1.1, i);
}

static void CheckSwell(const swMeasuredSea* sea, int index, double scale)
{
    double m0 = 0.0;
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        int low = i > 0 ? i - 1 : i, high = i + 1 < FREQUENCIES ? i + 1 : i;
        double width = (GetFrequency(high) - GetFrequency(low)) / (high - low);
        for (int j = 0; j < 720; ++j)
        {
            m0 += Density(GetFrequency(i), 0.5 * j) * width * 0.5 * DEGREE;
        }
    }
    swSeaState seaState = GetSeaState(sea, index, true);
    double height = (double)seaState.significantHeight / (4.0 * sqrt(scale * m0)) - 1.0;
    double direction = GetAngleBetween(GetBearing(seaState.meanDirection), 250.0);
    print_message("Hs off by %.4f %%, direction by %.4f degrees\n", 100.0 * height, direction);
    assert_true(fabs(height) < 1e-3);
    assert_true(direction < 0.1);
}

// WAVEWATCH III's layout: two times, two stations; directions descending, or where waves come from.
static void WriteWavewatch(int mode, bool isFrom)
{
    int file = 0;
    CheckNetcdf(nc_create(s_path, mode | NC_CLOBBER, &file));
    int dimensions[5] = {AddDimension(file, "time", NC_UNLIMITED), AddDimension(file, "station", 2),
                         AddDimension(file, "frequency", FREQUENCIES), AddDimension(file, "direction", DIRECTIONS),
                         AddDimension(file, "string40", 40)};
    const int names[2] = {dimensions[1], dimensions[4]};
    int time = AddVariable(file, "time", NC_DOUBLE, 1, dimensions);
    AddText(file, time, "units", "days since 1990-01-01 00:00:00");
    AddText(file, time, "calendar", "standard");
    int name = AddVariable(file, "station_name", NC_CHAR, 2, names);
    int longitude = AddVariable(file, "longitude", NC_FLOAT, 2, dimensions);
    int latitude = AddVariable(file, "latitude", NC_FLOAT, 2, dimensions);
    int frequency = AddVariable(file, "frequency", NC_FLOAT, 1, dimensions + 2);
    int direction = AddVariable(file, "direction", NC_FLOAT, 1, dimensions + 3);
    AddText(file, direction, "standard_name",
            isFrom ? "sea_surface_wave_from_direction" : "sea_surface_wave_to_direction");
    AddText(file, direction, "units", "degree");
    int efth = AddVariable(file, "efth", NC_FLOAT, 4, dimensions);
    float fill = 9.96921e36f;
    CheckNetcdf(nc_put_att_float(file, efth, "_FillValue", NC_FLOAT, 1, &fill));
    AddText(file, efth, "units", "m2 s rad-1");
    CheckNetcdf(nc_enddef(file));
    for (size_t t = 0; t < 2; ++t)
    {
        double days = 10957.0 + 0.25 * (double)t; // 2020-01-01
        CheckNetcdf(nc_put_var1_double(file, time, &t, &days));
        for (size_t s = 0; s < 2; ++s)
        {
            const size_t at[4] = {t, s, 0, 0}, count[4] = {1, 1, FREQUENCIES, DIRECTIONS};
            double place[2] = {-71.0 - (double)s, 41.0};
            float block[FREQUENCIES * DIRECTIONS];
            for (int i = 0; i < FREQUENCIES * DIRECTIONS; ++i)
            {
                double bearing = 90.0 - 15.0 * (i % DIRECTIONS) + (isFrom ? 0.0 : 180.0);
                block[i] = t == 1 && s == 1
                               ? fill
                               : (float)(Density(GetFrequency(i / DIRECTIONS), bearing) * (s == 0 ? 1.0 : 4.0));
            }
            CheckNetcdf(nc_put_vara_float(file, efth, at, count, block));
            CheckNetcdf(nc_put_var1_double(file, longitude, at, &place[0]));
            CheckNetcdf(nc_put_var1_double(file, latitude, at, &place[1]));
        }
    }
    for (size_t s = 0; s < 2; ++s)
    {
        const size_t at[2] = {s, 0}, count[2] = {1, 6};
        CheckNetcdf(nc_put_vara_text(file, name, at, count, s == 0 ? "44097 " : "44098 "));
    }
    for (size_t i = 0; i < FREQUENCIES; ++i)
    {
        double value = GetFrequency((int)i);
        CheckNetcdf(nc_put_var1_double(file, frequency, &i, &value));
    }
    for (size_t i = 0; i < DIRECTIONS; ++i)
    {
        double value = 90.0 - 15.0 * (double)i;
        value += value < 0.0 ? 360.0 : 0.0;
        CheckNetcdf(nc_put_var1_double(file, direction, &i, &value));
    }
    CheckNetcdf(nc_close(file));
}

static void CheckWavewatch(int mode, bool isFrom)
{
    WriteWavewatch(mode, isFrom);
    swMeasuredSea* sea = ReadFine(s_path);
    assert_int_equal(swMeasuredSea_GetCount(sea), 3); // one spectrum is missing
    assert_int_equal(swMeasuredSea_FindLocation(sea, "44098"), 1);
    assert_true(swMeasuredSea_GetLocation(sea, 1).longitude == -72.0);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2020-01-01 00:00");
    assert_string_equal(swMeasuredSea_GetRecord(sea, 1).time, "2020-01-01 06:00");
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).table.directionCount, DIRECTIONS);
    CheckSwell(sea, 1, 1.0);
    CheckSwell(sea, 2, 4.0);
    swDestroyMeasuredSea(sea);
}

static void WavewatchsNetcdfIsRead(void** state)
{
    (void)state;
    CheckWavewatch(0, false);
    CheckWavewatch(NC_NETCDF4, false);
    CheckWavewatch(0, true);
}

// ERA5's layout, packed in shorts, coordinates being numbers or values, dimensions in the order given.
static void WriteEra5(bool areNumbers, bool isNew)
{
    int file = 0;
    CheckNetcdf(nc_create(s_path, NC_CLOBBER, &file));
    int longitudes = AddDimension(file, "longitude", 2), latitudes = AddDimension(file, "latitude", 1);
    int frequencies = AddDimension(file, isNew ? "frequencyNumber" : "frequency", FREQUENCIES);
    int directions = AddDimension(file, isNew ? "directionNumber" : "direction", DIRECTIONS);
    int times = AddDimension(file, isNew ? "valid_time" : "time", 1);
    int longitude = AddVariable(file, "longitude", NC_FLOAT, 1, &longitudes);
    int latitude = AddVariable(file, "latitude", NC_FLOAT, 1, &latitudes);
    int time = AddVariable(file, isNew ? "valid_time" : "time", NC_INT, 1, &times);
    AddText(file, time, "units", isNew ? "seconds since 1970-01-01" : "hours since 1900-01-01 00:00:00.0");
    int frequency = AddVariable(file, isNew ? "frequencyNumber" : "frequency", NC_DOUBLE, 1, &frequencies);
    int direction = AddVariable(file, isNew ? "directionNumber" : "direction", NC_DOUBLE, 1, &directions);
    if (!areNumbers)
    {
        AddText(file, direction, "units", "degree");
    }
    const int shape[5] = {times, isNew ? frequencies : directions, isNew ? directions : frequencies, latitudes,
                          longitudes};
    int d2fd = AddVariable(file, "d2fd", NC_SHORT, 5, shape);
    const double scale = 2.5e-4, offset = -4.0;
    short fill = -32767;
    CheckNetcdf(nc_put_att_double(file, d2fd, "scale_factor", NC_DOUBLE, 1, &scale));
    CheckNetcdf(nc_put_att_double(file, d2fd, "add_offset", NC_DOUBLE, 1, &offset));
    CheckNetcdf(nc_put_att_short(file, d2fd, "_FillValue", NC_SHORT, 1, &fill));
    CheckNetcdf(nc_put_att_short(file, d2fd, "missing_value", NC_SHORT, 1, &fill));
    CheckNetcdf(nc_enddef(file));
    const double places[2] = {170.0, 171.0}, south = -45.0, when = isNew ? 1577880000.0 : 1051908.0; // 2020-01-01 12:00
    const size_t first = 0;
    CheckNetcdf(nc_put_var_double(file, longitude, places));
    CheckNetcdf(nc_put_var1_double(file, latitude, &first, &south));
    CheckNetcdf(nc_put_var1_double(file, time, &first, &when));
    for (size_t i = 0; i < FREQUENCIES; ++i)
    {
        double value = areNumbers ? (double)i + 1.0 : GetFrequency((int)i);
        CheckNetcdf(nc_put_var1_double(file, frequency, &i, &value));
        for (size_t j = 0; j < DIRECTIONS; ++j)
        {
            double bearing = 7.5 + 15.0 * (double)j;
            value = areNumbers ? (double)j + 1.0 : bearing;
            CheckNetcdf(nc_put_var1_double(file, direction, &j, &value));
            double level = (log10(Density(GetFrequency((int)i), bearing + 180.0)) - offset) / scale;
            const short packed = level < -32000.0 ? fill : (short)lround(level);
            const size_t at[5] = {0, isNew ? i : j, isNew ? j : i, 0, 0}, land[5] = {0, at[1], at[2], 0, 1};
            CheckNetcdf(nc_put_var1_short(file, d2fd, at, &packed));
            CheckNetcdf(nc_put_var1_short(file, d2fd, land, &fill));
        }
    }
    CheckNetcdf(nc_close(file));
}

static void Era5sNetcdfIsRead(void** state)
{
    (void)state;
    for (int i = 0; i < 4; ++i)
    {
        WriteEra5(i % 2 == 1, i / 2 == 1);
        swMeasuredSea* sea = ReadFine(s_path);
        assert_int_equal(swMeasuredSea_GetCount(sea), 1); // the other place is land
        assert_int_equal(swMeasuredSea_GetLocationCount(sea), 2);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2020-01-01 12:00");
        assert_true(swMeasuredSea_GetLocation(sea, 0).latitude == -45.0);
        assert_true(fabsf(swMeasuredSea_GetRecord(sea, 0).table.frequencies[29] - (float)GetFrequency(29)) < 1e-6f);
        CheckSwell(sea, 0, 1.0);
        swDestroyMeasuredSea(sea);
    }
}

static void NetcdfOfOtherThingsIsRefused(void** state)
{
    (void)state;
    int file = 0;
    CheckNetcdf(nc_create(s_path, NC_CLOBBER, &file));
    AddDimension(file, "x", 3);
    CheckNetcdf(nc_close(file));
    swMeasuredSea* sea = NULL;
    assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "no variable of spectra"));
    WriteFile("CDF\001 and then nothing of the kind");
    assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "no netCDF file"));
}

#endif

static void UnknownFilesAreToldWhatIsRead(void** state)
{
    (void)state;
    swMeasuredSea* sea = NULL;
    WriteFile("hello\n");
    assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "SWAN"));
    assert_non_null(strstr(s_messages, "ERA5"));
    WriteFile("");
    assert_int_equal(Read(s_path, &sea), SW_ERROR_FORMAT);
    assert_int_equal(Read("/nowhere/at.all", &sea), SW_ERROR_FILE);
}

static int MakePath(void** state)
{
    (void)state;
    snprintf(s_path, sizeof(s_path), "measured_%ld.tmp", (long)getpid());
    return 0;
}

static int RemovePath(void** state)
{
    (void)state;
    remove(s_path);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#if defined(SW_HAS_JSON)
        cmocka_unit_test(SpottersJsonIsRead),
        cmocka_unit_test(OneBrokenRecordOfJsonIsLeftOut),
        cmocka_unit_test(SpottersDirectionsStandInForMoments),
        cmocka_unit_test(WrongJsonIsNamed),
        cmocka_unit_test(SouthernOceansSpotterIsReadAsExpected),
        cmocka_unit_test(CdipsSpectraHaveTheirMoments),
#endif
#if defined(SW_HAS_NETCDF)
        cmocka_unit_test(WavewatchsNetcdfIsRead),
        cmocka_unit_test(Era5sNetcdfIsRead),
        cmocka_unit_test(NetcdfOfOtherThingsIsRefused),
#endif
        cmocka_unit_test(UnknownFilesAreToldWhatIsRead),
    };
    return cmocka_run_group_tests(tests, MakePath, RemovePath);
}
