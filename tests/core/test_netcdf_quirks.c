// SPDX-License-Identifier: MIT
// netCDF of other writers than the models themselves: sites named by strings, degrees where waves come from, densities
// per degree, times of integers, and gaps.

#include "support/cmocka_setup.h"
#include "support/netcdf_maker.h"

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "seaway/files.h"

#define FREQUENCIES 20
#define DIRECTIONS 24
#define SITES 2
#define TIMES 3
#define DEGREE (SW_PI / 180.0)

static char s_path[64];

// m^2/Hz/degree of waves that come from 320 degrees at the first site, from 50 at the second.
static float Density(int frequency, int direction, int site)
{
    double f = 0.05 + 0.01 * frequency;
    double half = 0.5 * (15.0 * direction - (site == 0 ? 320.0 : 50.0)) * DEGREE;
    return (float)(0.02 * exp(-0.5 * pow((f - 0.1) / 0.02, 2.0)) * pow(cos(half) * cos(half), 10.0));
}

// Of one site: 4 sqrt(m0), with bandwidths half-way to the neighbours.
static double GetHeight(void)
{
    double m0 = 0.0;
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            m0 += (double)Density(i, j, 0) * 0.01 * (360.0 / DIRECTIONS);
        }
    }
    return 4.0 * sqrt(m0);
}

static void WriteSpectra(int file, int efth)
{
    float fill = -999.0f;
    for (size_t k = 0; k < (size_t)TIMES * SITES * FREQUENCIES * DIRECTIONS; ++k)
    {
        size_t place = k / ((size_t)FREQUENCIES * DIRECTIONS);
        size_t index[4] = {place / SITES, place % SITES, k / DIRECTIONS % FREQUENCIES, k % DIRECTIONS};
        float value = Density((int)index[2], (int)index[3], (int)index[1]);
        value = index[0] == 1 && index[1] == 1 ? fill : value; // a gap
        CheckNetcdf(nc_put_var1_float(file, efth, index, &value));
    }
}

static void WriteFile(void)
{
    int file = 0, dimensions[4] = {0};
    const char* const names[4] = {"time", "site", "freq", "dir"};
    const size_t lengths[4] = {TIMES, SITES, FREQUENCIES, DIRECTIONS};
    CheckNetcdf(nc_create(s_path, NC_NETCDF4 | NC_CLOBBER, &file));
    for (int i = 0; i < 4; ++i)
    {
        CheckNetcdf(nc_def_dim(file, names[i], lengths[i], &dimensions[i]));
    }
    int time = AddVariable(file, "time", NC_INT64, 1, &dimensions[0]);
    AddText(file, time, "units", "minutes since 2020-02-28 23:30");
    AddText(file, time, "calendar", "proleptic_gregorian");
    int name = AddVariable(file, "station_name", NC_STRING, 1, &dimensions[1]);
    int longitude = AddVariable(file, "lon", NC_DOUBLE, 1, &dimensions[1]);
    int latitude = AddVariable(file, "lat", NC_DOUBLE, 1, &dimensions[1]);
    int frequency = AddVariable(file, "freq", NC_DOUBLE, 1, &dimensions[2]);
    int direction = AddVariable(file, "dir", NC_SHORT, 1, &dimensions[3]);
    AddText(file, direction, "standard_name", "sea_surface_wave_from_direction");
    AddText(file, direction, "units", "degree");
    int efth = AddVariable(file, "efth", NC_FLOAT, 4, dimensions);
    float fill = -999.0f;
    CheckNetcdf(nc_put_att_float(file, efth, "_FillValue", NC_FLOAT, 1, &fill));
    AddText(file, efth, "units", "m^{2}.s.degree^{-1}");
    CheckNetcdf(nc_enddef(file));
    const long long minutes[TIMES] = {0, 60, 120};
    const char* stations[SITES] = {"Ilot d'Amont", "B"};
    const double longitudes[SITES] = {-5.25, 170.0}, latitudes[SITES] = {48.5, -41.0};
    CheckNetcdf(nc_put_var_longlong(file, time, minutes));
    CheckNetcdf(nc_put_var_string(file, name, stations));
    CheckNetcdf(nc_put_var_double(file, longitude, longitudes));
    CheckNetcdf(nc_put_var_double(file, latitude, latitudes));
    for (size_t i = 0; i < FREQUENCIES; ++i)
    {
        double value = 0.05 + 0.01 * (double)i;
        CheckNetcdf(nc_put_var1_double(file, frequency, &i, &value));
    }
    for (size_t j = 0; j < DIRECTIONS; ++j)
    {
        short value = (short)(15 * j);
        CheckNetcdf(nc_put_var1_short(file, direction, &j, &value));
    }
    WriteSpectra(file, efth);
    CheckNetcdf(nc_close(file));
}

static void SitesOfOtherWritersAreRead(void** state)
{
    (void)state;
    snprintf(s_path, sizeof(s_path), "test_netcdf_quirks_%d.nc", (int)getpid());
    WriteFile();
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    swResult result = swReadMeasuredSea(&host, s_path, &sea);
    remove(s_path);
    assert_int_equal(result, SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetCount(sea), TIMES * SITES - 1);
    assert_string_equal(swMeasuredSea_GetLocation(sea, 0).name, "Ilot d'Amont");
    assert_int_equal(swMeasuredSea_FindLocation(sea, "B"), 1);
    swMeasuredLocation second = swMeasuredSea_GetLocation(sea, 1);
    assert_int_equal(second.recordCount, TIMES - 1);
    assert_true(fabs(second.longitude - 170.0) < 1e-9 && fabs(second.latitude + 41.0) < 1e-9);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 1).time, "2020-02-29 00:30");
    for (int i = 0; i < SITES; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, swMeasuredSea_GetLocation(sea, i).firstRecord);
        swSpectrumDef def = swDefaultSpectrumDef();
        swSeaState seaState;
        def.kind = SW_SPECTRUM_TABLE;
        def.table = &record.table;
        assert_int_equal(swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &seaState), SW_SUCCESS);
        double from = (double)seaState.meanDirection / DEGREE - 90.0;
        print_message("site %d: Hs %.4f m, from %.2f\n", i, (double)seaState.significantHeight, from);
        assert_true(fabs((double)seaState.significantHeight / GetHeight() - 1.0) < 1e-4);
        assert_true(fabs(remainder(from - (i == 0 ? 320.0 : 50.0), 360.0)) < 0.05);
    }
    swDestroyMeasuredSea(sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SitesOfOtherWritersAreRead),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
