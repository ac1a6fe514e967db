// SPDX-License-Identifier: MIT
// Displacement agrees within a millimetre at every texel of every slice, wherever the viewer is and whenever;
// derivatives within what half floats hold.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>

#define DISPLACEMENT_M 1e-3
#define DERIVATIVE 4e-3 // half floats step by 1/1024 around 1, by 1/512 around 2

static swWaveSystemDef Breeze(void)
{
    return swDefaultWaveSystemDef();
}

static swWaveSystemDef Gale(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 24.0f;
    def.spectrum.fetch = 800e3f;
    def.seed = 5;
    return def;
}

static void CheckSlices(Parity* parity, const char* what)
{
    char text[96];
    Difference displacement = CompareLayer(parity, SW_LAYER_DISPLACEMENT);
    snprintf(text, sizeof(text), "%s: displacement", what);
    PrintDifference(text, displacement, "m");
    Difference derivatives = CompareLayer(parity, SW_LAYER_DERIVATIVES);
    snprintf(text, sizeof(text), "%s: derivatives", what);
    PrintDifference(text, derivatives, "");
    assert_true(displacement.worst < DISPLACEMENT_M);
    assert_true(derivatives.worst < DERIVATIVE);
}

static void ADefaultViewAgrees(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = Breeze();
    AddParitySea(&parity, &def);
    AddParityView(&parity, 7, 384, (swPos){3.3, 2.0, -7.1});
    StepParity(&parity, 12.0);
    CheckSlices(&parity, "breeze, 7 x 384^2");
    FreeParity(&parity);
}

static void ASwellOfParallelTilesAgrees(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum = swMakeSwellSpectrum(2.5f, 10.0f, 0.4f, 0.15f);
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity.world, &def, &id), SW_SUCCESS);
    AddParityView(&parity, 5, 128, (swPos){3.3, 40.0, -7.1});
    StepParity(&parity, 12.0);
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(parity.world, id, bands);
    assert_true(swGetWorldFrame(parity.world)->tileCount > count);
    CheckSlices(&parity, "narrow swell, 5 x 128^2");
    FreeParity(&parity);
}

static void ViewersEverywhereAgree(void** state)
{
    const struct
    {
        const char* name;
        swPos viewpoint;
    } viewers[] = {
        {"at the origin", {0.0, 1.7, 0.0}},
        {"20 m up, negative", {-1234.567, 20.0, -98.76}},
        {"5 km up", {40.0, 5000.0, 70.0}},
        {"1,000 km away", {1.0e6 + 0.3, 5.0, -1.0e6 - 0.7}},
        {"1,000 km away, 300 m up", {-1.0e6, 300.0, 1.0e6 + 12345.678}},
    };
    Parity parity = MakeParity(state);
    swWaveSystemDef def = Gale();
    AddParitySea(&parity, &def);
    AddParityView(&parity, 5, 128, viewers[0].viewpoint);
    for (size_t i = 0; i < sizeof(viewers) / sizeof(viewers[0]); ++i)
    {
        swView_SetViewpoint(parity.view, viewers[i].viewpoint);
        StepParity(&parity, 1.3);
        CheckSlices(&parity, viewers[i].name);
    }
    FreeParity(&parity);
}

static void TwoSystemsAgreeAfterAMonth(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Breeze();
    sea.resolution = 64;
    sea.tileWaves = 16;
    AddParitySea(&parity, &sea);
    swWaveSystemDef swell = Gale();
    swell.spectrum.direction = -2.2f;
    swell.resolution = 256; // finer than slices need: whole rows of tiles are passed over
    swell.tileWaves = 8;
    swell.currentX = 1.2f;
    swell.currentZ = -0.4f;
    AddParitySea(&parity, &swell);
    AddParityView(&parity, 4, 128, (swPos){-55.0, 8.0, 1e4});
    swWorld_SetTime(parity.world, 30.0 * 86400.0);
    StepParity(&parity, 0.0);
    CheckSlices(&parity, "two systems after 30 days");
    swWorld_SetTime(parity.world, -86400.0);
    StepParity(&parity, 0.1);
    CheckSlices(&parity, "two systems a day before");
    FreeParity(&parity);
}

// More tiles and knots than a block lays out at once.
static void ManySystemsAgree(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Breeze();
    AddParityView(&parity, 4, 128, (swPos){7.0, 8.0, -3.0});
    for (int i = 0; i < 5; ++i)
    {
        sea.seed = 20u + (uint32_t)i;
        sea.minWavelength = i < 2 ? 0.0625f : 1.0f;
        AddParitySea(&parity, &sea);
        StepParity(&parity, 0.3);
        CheckSlices(&parity, "one system more");
    }
    FreeParity(&parity);
}

static void FreeWavesAgree(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Breeze();
    sea.method = SW_WAVES_GERSTNER;
    sea.currentZ = 0.8f;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 5, 128, (swPos){-55.0, 8.0, 1e4});
    StepParity(&parity, 3.0);
    CheckSlices(&parity, "106 free waves");
    swWaveSystemDef tiles = Breeze();
    tiles.spectrum.direction = 2.0f;
    tiles.spectrum.depth = 20.0f;
    AddParitySea(&parity, &tiles);
    swView_SetViewpoint(parity.view, (swPos){1.0e6 + 0.3, 40.0, -1.0e6 - 0.7});
    swWorld_SetTime(parity.world, 30.0 * 86400.0);
    StepParity(&parity, 0.0);
    CheckSlices(&parity, "free waves and tiles, 1,000 km out after 30 days");
    FreeParity(&parity);
}

// Mixes and cross-fades change modes and tiles from frame to frame.
static void ASeaThatChangesAgrees(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Breeze();
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity.world, &sea, &id), SW_SUCCESS);
    AddParityView(&parity, 3, 128, (swPos){5.0, 8.0, 5.0});
    StepParity(&parity, 1.0);
    sea.spectrum.windSpeed = 14.0f;
    assert_int_equal(swWaveSystem_Set(parity.world, id, &sea, 1.0), SW_SUCCESS);
    for (int i = 0; i < 3; ++i)
    {
        StepParity(&parity, 0.4);
        CheckSlices(&parity, "turning into a gale");
    }
    sea.seed = 9;
    assert_int_equal(swWaveSystem_Set(parity.world, id, &sea, 1.0), SW_SUCCESS);
    for (int i = 0; i < 3; ++i)
    {
        StepParity(&parity, 0.4);
        CheckSlices(&parity, "another seed");
    }
    FreeParity(&parity);
}

static void WaterWithoutWavesIsFlat(void** state)
{
    Parity parity = MakeParity(state);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    StepParity(&parity, 1.0);
    Difference displacement = CompareLayer(&parity, SW_LAYER_DISPLACEMENT);
    Difference derivatives = CompareLayer(&parity, SW_LAYER_DERIVATIVES);
    assert_true(displacement.worst == 0.0 && displacement.scale == 0.0);
    assert_true(derivatives.worst == 0.0);
    FreeParity(&parity);
}

static void SlicesFollowAMovingViewer(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = Gale();
    AddParitySea(&parity, &def);
    AddParityView(&parity, 4, 64, (swPos){0.0, 2.0, 0.0});
    Difference displacement = {0};
    for (int i = 0; i < 60; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){0.37 * i, 2.0 + 0.05 * i * i, -1.9 * i});
        StepParity(&parity, 1.0 / 30.0);
        displacement = MaxDifference(displacement, CompareLayer(&parity, SW_LAYER_DISPLACEMENT));
    }
    PrintDifference("60 frames of flight", displacement, "m");
    assert_true(displacement.worst < DISPLACEMENT_M);
    FreeParity(&parity);
}

static void ViewsComeAndGo(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = Breeze();
    AddParitySea(&parity, &def);
    AddParityView(&parity, 3, 64, (swPos){0.0, 2.0, 0.0});
    StepParity(&parity, 0.1);
    size_t oneView = swGpuWorld_GetMemory(parity.gpuWorld);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = 128;
    swView* second = NULL;
    assert_int_equal(swCreateView(parity.world, &viewDef, &second), SW_SUCCESS);
    StepParity(&parity, 0.1);
    assert_true(swGpuWorld_GetMemory(parity.gpuWorld) > oneView);
    assert_true(CompareLayer(&parity, SW_LAYER_DISPLACEMENT).worst < DISPLACEMENT_M);
    swDestroyView(second);
    for (int i = 0; i < 4; ++i)
    {
        StepParity(&parity, 0.1);
    }
    assert_true(swGpuWorld_GetMemory(parity.gpuWorld) == oneView);
    assert_true(CompareLayer(&parity, SW_LAYER_DISPLACEMENT).worst < DISPLACEMENT_M);
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ADefaultViewAgrees),
        cmocka_unit_test(ViewersEverywhereAgree),
        cmocka_unit_test(ASwellOfParallelTilesAgrees),
        cmocka_unit_test(TwoSystemsAgreeAfterAMonth),
        cmocka_unit_test(ManySystemsAgree),
        cmocka_unit_test(FreeWavesAgree),
        cmocka_unit_test(ASeaThatChangesAgrees),
        cmocka_unit_test(WaterWithoutWavesIsFlat),
        cmocka_unit_test(SlicesFollowAMovingViewer),
        cmocka_unit_test(ViewsComeAndGo),
    };
    return cmocka_run_group_tests_name("slices: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
