// SPDX-License-Identifier: MIT
// The tiles that the GPU transforms hold the same spline coefficients as the core's, for every resolution and at any
// time. Compared are all samples of all tiles, x, y and z.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// A metre-high sea agrees to this: float transforms of thousands of waves, in two orders.
#define TOLERANCE_M 2e-4

static Difference CompareTiles(Parity* parity)
{
    const swFrame* frame = swGetWorldFrame(parity->world);
    Difference difference = {0};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        size_t n = (size_t)tile->resolution;
        float* texels = malloc(n * (n + 3) * 4 * sizeof(float));
        assert_non_null(texels);
        assert_int_equal(swReadTile(parity->gpuWorld, i, texels), SW_SUCCESS);
        difference = MaxDifference(difference, Compare(tile->texels, texels, n * (n + 3), 4, 4));
        free(texels);
    }
    return difference;
}

static void CheckTiles(Parity* parity, const char* what)
{
    Difference difference = CompareTiles(parity);
    PrintDifference(what, difference, "m");
    assert_true(difference.worst < TOLERANCE_M);
}

static void TilesOfEveryResolutionAgree(void** state)
{
    for (int resolution = 16; resolution <= 512; resolution *= 2)
    {
        Parity parity = MakeParity(state);
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.resolution = resolution;
        def.tileWaves = resolution / 4 < 32 ? resolution / 4 : 32;
        def.minWavelength = resolution > 128 ? 8.0f : 0.0625f; // fewer bands where tiles are large
        AddParitySea(&parity, &def);
        StepParity(&parity, 7.25);
        char what[64];
        snprintf(what, sizeof(what), "N = %d, %d tiles", resolution, swGetWorldFrame(parity.world)->tileCount);
        CheckTiles(&parity, what);
        FreeParity(&parity);
    }
}

static void TilesAgreeAtAnyTime(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    const double times[] = {0.0, 1.0 / 60.0, 3601.3, 30.0 * 86400.0 + 0.1, -1234.5};
    for (size_t i = 0; i < sizeof(times) / sizeof(times[0]); ++i)
    {
        swWorld_SetTime(parity.world, times[i]);
        StepParity(&parity, 0.0);
        char what[64];
        snprintf(what, sizeof(what), "at %.1f s", times[i]);
        CheckTiles(&parity, what);
    }
    FreeParity(&parity);
}

static void TilesOfTwoSystemsAgree(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.spectrum.windSpeed = 22.0f;
    AddParitySea(&parity, &sea);
    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.spectrum.significantHeight = 3.0f;
    swell.spectrum.peakPeriod = 14.0f;
    swell.spectrum.spreadExponent = 60.0f;
    swell.spectrum.direction = 2.0f;
    swell.resolution = 64;
    swell.tileWaves = 16;
    swell.loopPeriod = 60.0f;
    swell.weight = 0.7f;
    swell.seed = 9;
    AddParitySea(&parity, &swell);
    StepParity(&parity, 100.0);
    CheckTiles(&parity, "gale of 22 m/s and a swell that loops");
    FreeParity(&parity);
}

static void ANewSpectrumReachesTheGpu(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity.world, &def, &id), SW_SUCCESS);
    StepParity(&parity, 1.0);
    for (int i = 0; i < 6; ++i) // more changes than frames in flight
    {
        def.spectrum.windSpeed = 6.0f + 3.0f * (float)i;
        assert_int_equal(swWaveSystem_SetSpectrum(parity.world, id, &def.spectrum), SW_SUCCESS);
        swWaveSystem_SetWeight(parity.world, id, 1.0f - 0.1f * (float)i);
        StepParity(&parity, 0.5);
        char what[64];
        snprintf(what, sizeof(what), "wind of %.0f m/s", (double)def.spectrum.windSpeed);
        CheckTiles(&parity, what);
    }
    swDestroyWaveSystem(parity.world, id);
    StepParity(&parity, 0.5);
    assert_int_equal(swGetWorldFrame(parity.world)->tileCount, 0);
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TilesOfEveryResolutionAgree),
        cmocka_unit_test(TilesAgreeAtAnyTime),
        cmocka_unit_test(TilesOfTwoSystemsAgree),
        cmocka_unit_test(ANewSpectrumReachesTheGpu),
    };
    return cmocka_run_group_tests_name("waves: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
