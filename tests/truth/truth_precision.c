// SPDX-License-Identifier: MIT
// V23: a million metres from the origin the sea is what it is at the origin. A band's waves repeat with its tile, so places
// that lie whole tiles apart, on any heading, have to have the same water; and what queries read there is as near to the
// waves' direct sum as it is at home.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#include "core/waves/waves_fft.h"

#define POINT_COUNT 2048
#define HEADINGS 24
#define FAR 1e6

static void QueryAround(const swWorld* world, swPosXZ center, float* heights)
{
    static swPosXZ points[POINT_COUNT];
    swQueryDef query = swDefaultQueryDef();
    ScatterPoints(1000.0, 3, POINT_COUNT, points);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i] = (swPosXZ){center.x + points[i].x, center.z + points[i].z};
    }
    swWorld_QuerySurface(world, &query, POINT_COUNT, points, &(swSurfaceSamples){.height = heights}, NULL);
}

// Waves of one octave, steep as a gale's, with chop.
static void CheckBand(int band)
{
    double shortest = ldexp(1.0, band - 4), period = 1.0 / FindFrequency(1.4 * shortest, (double)INFINITY, 9.81);
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 0.04 * shortest, period, 0.3, 2.0);
    swWaveSystemDef def = MakeWaves(&spectrum, shortest, 2.0 * shortest, 5);
    swWorld* world = CreateTruthSea(&def);
    static float near[POINT_COUNT], far[POINT_COUNT];
    double side = swGetTileSide(band, def.tileWaves), worst = 0.0;
    QueryAround(world, (swPosXZ){0.0, 0.0}, near);
    for (int i = 0; i < HEADINGS; ++i)
    {
        double heading = TURN * i / HEADINGS;
        swPosXZ center = {side * floor(FAR * sin(heading) / side), side * floor(-FAR * cos(heading) / side)};
        QueryAround(world, center, far);
        for (int j = 0; j < POINT_COUNT; ++j)
        {
            worst = fmax(worst, fabs((double)far[j] - (double)near[j]));
        }
    }
    char what[128];
    snprintf(what, sizeof(what), "Height of waves of %g to %g m, 1000 km away at 24 headings, worst change", shortest,
             2.0 * shortest);
    FindBelow(&(Finding){"V23", what, "whole tiles away", "mm", 4}, 0.1, 1e3 * worst);
    swDestroyWorld(world);
}

static void TheSeaIsTheSameAThousandKilometresAway(void** state)
{
    (void)state;
    CheckBand(0);
    CheckBand(4);
    CheckBand(8);
    CheckBand(11);
}

// Error of heights as queries read them against the direct sum of all waves, RMS, m: a query for another time sums.
static double FindReadingError(swWorld* world, swPosXZ center)
{
    static swPosXZ points[256];
    static float read[256], summed[256];
    double square = 0.0;
    swQueryDef query = swDefaultQueryDef();
    ScatterPoints(1000.0, 4, 256, points);
    for (int i = 0; i < 256; ++i)
    {
        points[i] = (swPosXZ){center.x + points[i].x, center.z + points[i].z};
    }
    swWorld_SetTime(world, 100.0);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swWorld_QuerySurface(world, &query, 256, points, &(swSurfaceSamples){.height = read}, NULL);
    swWorld_SetTime(world, 0.0);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    query.time = 100.0;
    swWorld_QuerySurface(world, &query, 256, points, &(swSurfaceSamples){.height = summed}, NULL);
    for (int i = 0; i < 256; ++i)
    {
        square += ((double)read[i] - (double)summed[i]) * ((double)read[i] - (double)summed[i]) / 256.0;
    }
    return sqrt(square);
}

static void ReadingIsAsExactFarAway(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 1.0, 4096.0, 1);
    swWorld* world = CreateTruthSea(&def);
    const char* const source = "direct sum of the waves";
    FindBelow(
        &(Finding){"V23", "Heights of a sea of Hs 2 m less the direct sum, at the origin, RMS", source, "% of Hs", 2},
        0.5, 50.0 * FindReadingError(world, (swPosXZ){0.0, 0.0}));
    FindBelow(&(Finding){"V23", "The same, 1000 km away", source, "% of Hs", 2}, 0.5,
              50.0 * FindReadingError(world, (swPosXZ){0.6e6, -0.8e6}));
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheSeaIsTheSameAThousandKilometresAway),
        cmocka_unit_test(ReadingIsAsExactFarAway),
    };
    BeginTruth("truth_precision");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
