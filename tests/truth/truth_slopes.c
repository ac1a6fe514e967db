// SPDX-License-Identifier: MIT
// V9: the slopes of the surface and the roughness that the picture adds for ripples make up the slopes that Cox and Munk
// saw, within the scatter of their measurements, under winds for which they measured.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#include "shared/roughness.h"

#define SEED_COUNT 4
#define POINT_COUNT 4096

typedef struct SlopeCase
{
    swWaveSystemDef def;
    SurfaceSums sums[SEED_COUNT];
    float bands[SEED_COUNT]; // mean square slope that the system itself tells
} SlopeCase;

static void MeasureSlopes(void* context, int seed)
{
    SlopeCase* slopes = context;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swWaveSystemId id;
    swBandInfo bands[SW_MAX_BANDS];
    swWaveSystemDef def = slopes->def;
    def.seed = 1u + (uint32_t)seed;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS || swCreateWaveSystem(world, &def, &id) != SW_SUCCESS)
    {
        abort();
    }
    for (int i = 0; i < 4; ++i)
    {
        swWorld_SetTime(world, 37.0 * i);
        if (swWorld_Step(world, 0.0) != SW_SUCCESS ||
            !LookAtSurface(world, 3000.0, POINT_COUNT, 0.5f, slopes->sums + seed))
        {
            abort();
        }
    }
    int count = swWaveSystem_GetBands(world, id, bands);
    for (int i = 0; i < count; ++i)
    {
        slopes->bands[seed] += bands[i].meanSquareSlope;
    }
    swDestroyWorld(world);
}

static void CheckWind(double wind, double fetch)
{
    SlopeCase slopes = {.def = swDefaultWaveSystemDef()};
    slopes.def.spectrum.windSpeed = (float)wind;
    slopes.def.spectrum.fetch = (float)fetch;
    int count = Seeds(SEED_COUNT);
    RunJobs(MeasureSlopes, &slopes, count);
    double sum = 0.0, points = 0.0;
    for (int i = 0; i < count; ++i)
    {
        sum += slopes.sums[i].particleSlopeSquare;
        points += slopes.sums[i].count;
    }
    double resolved = sum / points, ripples = 2.0 * (double)swRippleVariance((float)wind, slopes.bands[0]);
    char what[128];
    snprintf(what, sizeof(what), "Mean square slope, U10 %.0f m/s over %.0f km, waves of 6 cm and longer", wind,
             fetch / 1e3);
    FindWithin(&(Finding){"V9", what, "\xe2\x88\xab k\xc2\xb2 S", "", 4}, (double)slopes.bands[0], resolved, 0.02);
    snprintf(what, sizeof(what), "Mean square slope, U10 %.0f m/s over %.0f km, with the picture's roughness", wind,
             fetch / 1e3);
    FindNear(&(Finding){"V9", what, "0.003 + 0.00512 U [Cox 1954]", "", 4}, 0.003 + 5.12e-3 * wind, resolved + ripples,
             0.004);
}

static void SlopesAndRoughnessAreThoseOfTheGlitter(void** state)
{
    (void)state;
    CheckWind(5.0, 100e3);
    CheckWind(8.0, 300e3);
    CheckWind(10.0, 100e3);
    CheckWind(10.0, 300e3);
    CheckWind(14.0, 300e3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SlopesAndRoughnessAreThoseOfTheGlitter),
    };
    BeginTruth("truth_slopes");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
