// SPDX-License-Identifier: MIT
// V23: a million metres from the origin the sea is what it is at the origin. A band's waves repeat with its tile, so
// places that lie whole tiles apart, on any heading, have to have the same water; and what queries read there is as
// near to the waves' direct sum as it is at home. Nor does the sea change when the host moves its coordinates along
// with the player, which is asked of heights, of normals, of velocities below and of a view's slices and foam.

#include "truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINT_COUNT, points, &(swSurfaceSamples){.height = heights},
                          NULL);
}

// Waves of one octave, steep as a gale's, with chop.
static void CheckBand(int band)
{
    double shortest = ldexp(1.0, band - 4), period = 1.0 / swGetWaveFrequency(1.4 * shortest, (double)INFINITY, 9.81);
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
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 256, points, &(swSurfaceSamples){.height = read}, NULL);
    swWorld_SetTime(world, 0.0);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    query.time = 100.0;
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 256, points, &(swSurfaceSamples){.height = summed}, NULL);
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

// ---- shifts of the origin ----

enum
{
    PLACES = 512,
    SIDE = 64,
    SLICES = 3
};

typedef struct Answers
{
    float heights[PLACES];
    swVec3 normals[PLACES];
    swVec3 below[PLACES];
    float displacement[SLICES][SIDE * SIDE * 4];
    float foam[SLICES][SIDE * SIDE];
} Answers;

// The same places of the sea, and the same viewpoint, whatever the origin.
static void Ask(swWorld* world, swView* view, swPosXZ origin, swPosXZ center, Answers* answers)
{
    static swPosXZ points[PLACES];
    static swPos places[PLACES];
    swWorld_SetOrigin(world, origin);
    ScatterPoints(1000.0, 5, PLACES, points);
    for (int i = 0; i < PLACES; ++i)
    {
        points[i] = (swPosXZ){center.x + points[i].x - origin.x, center.z + points[i].z - origin.z};
        places[i] = (swPos){points[i].x, -5.0, points[i].z};
    }
    swView_SetViewpoint(view, (swPos){center.x - origin.x, 12.0, center.z - origin.z});
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swQueryDef query = swDefaultQueryDef();
    swSurfaceSamples surface = {.height = answers->heights, .normal = answers->normals};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, PLACES, points, &surface, NULL);
    swMoment_QueryVolume(swWorld_GetMoment(world), &query, PLACES, places,
                         &(swVolumeSamples){.velocity = answers->below}, NULL);
    for (int i = 0; i < SLICES; ++i)
    {
        memcpy(answers->displacement[i], swView_GetDisplacement(view, i), sizeof(answers->displacement[i]));
        memcpy(answers->foam[i], swView_GetFoam(view, i), sizeof(answers->foam[i]));
    }
}

typedef struct Changes
{
    double height, normal, below, slices, foam;
} Changes;

static double FindChange(const void* a, const void* b, size_t bytes)
{
    const float *x = a, *y = b;
    double worst = 0.0;
    for (size_t i = 0; i < bytes / sizeof(float); ++i)
    {
        worst = fmax(worst, fabs((double)x[i] - (double)y[i]));
    }
    return worst;
}

// Waves by transforms and Gerstner waves across them, and a view that has seen two seconds of foam.
static swWorld* CreateWatchedSea(swPosXZ center, swView** view)
{
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 4.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 0.5, 4096.0, 1);
    def.chop = 1.5f;
    swWorld* world = CreateTruthSea(&def);
    def.method = SW_WAVES_GERSTNER;
    def.spectrum.direction = 2.0f;
    def.chop = 1.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = SLICES;
    viewDef.resolution = SIDE;
    viewDef.enableCpuLayers = true;
    assert_int_equal(swCreateView(world, &viewDef, view), SW_SUCCESS);
    swView_SetViewpoint(*view, (swPos){center.x, 12.0, center.z});
    for (int i = 0; i < 20; ++i)
    {
        assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
    }
    return world;
}

static void CheckShifts(const char* where, swPosXZ center)
{
    static Answers wanted, got;
    swView* view = NULL;
    swWorld* world = CreateWatchedSea(center, &view);
    Changes worst = {0};
    Ask(world, view, (swPosXZ){0.0, 0.0}, center, &wanted);
    for (int i = 0; i < HEADINGS; ++i)
    {
        double heading = TURN * (i + 0.3) / HEADINGS, distance = i % 2 == 0 ? FAR : 1234.567;
        Ask(world, view, (swPosXZ){distance * sin(heading), -distance * cos(heading)}, center, &got);
        worst.height = fmax(worst.height, FindChange(got.heights, wanted.heights, sizeof(got.heights)));
        worst.normal = fmax(worst.normal, FindChange(got.normals, wanted.normals, sizeof(got.normals)));
        worst.below = fmax(worst.below, FindChange(got.below, wanted.below, sizeof(got.below)));
        worst.slices = fmax(worst.slices, FindChange(got.displacement, wanted.displacement, sizeof(got.displacement)));
        worst.foam = fmax(worst.foam, FindChange(got.foam, wanted.foam, sizeof(got.foam)));
    }
    char what[128];
    const char* const source = "the sea before the shift";
    snprintf(what, sizeof(what), "Height %s, worst change by shifts of the origin at 24 headings", where);
    FindBelow(&(Finding){"V23", what, source, "mm", 4}, 0.1, 1e3 * worst.height);
    FindBelow(&(Finding){"V23", "Component of the normal, the same", source, "", 6}, 1e-4, worst.normal);
    FindBelow(&(Finding){"V23", "Velocity 5 m below, the same", source, "mm/s", 4}, 0.1, 1e3 * worst.below);
    FindBelow(&(Finding){"V23", "Displacement in a view's slices, the same", source, "mm", 4}, 0.1, 1e3 * worst.slices);
    FindBelow(&(Finding){"V23", "Foam in a view's slices, the same", source, "", 6}, 1e-4, worst.foam);
    swDestroyWorld(world);
}

static void AShiftOfTheOriginChangesNothing(void** state)
{
    (void)state;
    CheckShifts("at home", (swPosXZ){123.5, -77.25});
    CheckShifts("1000 km away", (swPosXZ){-0.6e6 + 0.37, 0.8e6 + 0.11});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheSeaIsTheSameAThousandKilometresAway),
        cmocka_unit_test(ReadingIsAsExactFarAway),
        cmocka_unit_test(AShiftOfTheOriginChangesNothing),
    };
    BeginTruth("truth_precision");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
