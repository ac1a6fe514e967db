// SPDX-License-Identifier: MIT
// Foam agrees within 0.01 at every texel of every slice, over many frames in which slices scroll, the stack's scale
// changes and the viewer jumps.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TOLERANCE 0.01

static Parity MakeFoamySea(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 22.0f;
    def.spectrum.fetch = 500e3f;
    AddParitySea(&parity, &def);
    return parity;
}

static void CheckFoam(Difference difference, const char* what)
{
    PrintDifference(what, difference, "");
    assert_true(difference.worst < TOLERANCE);
    assert_true(difference.scale > 0.01); // there is foam at all
}

static void FoamAgreesOverManyFrames(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 4, 128, (swPos){0.0, 2.0, 0.0});
    Difference difference = {0};
    for (int i = 0; i < 60; ++i)
    {
        StepParity(&parity, 1.0 / 30.0);
        difference = i % 10 == 9 ? MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM)) : difference;
    }
    CheckFoam(difference, "60 frames, viewer at rest");
    FreeParity(&parity);
}

static void FoamAgreesWhileSlicesScroll(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 4, 64, (swPos){-10.0, 2.0, 1e6});
    Difference difference = {0};
    for (int i = 0; i < 60; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){-10.0 - 0.21 * i, 2.0, 1e6 + 0.13 * i});
        StepParity(&parity, i % 7 == 0 ? 0.11 : 1.0 / 60.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM));
    }
    CheckFoam(difference, "60 frames, viewer moving, 1,000 km out");
    FreeParity(&parity);
}

static void FoamAgreesWhileTheScaleChanges(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 4, 64, (swPos){0.0, 2.0, 0.0});
    Difference difference = {0};
    for (int i = 0; i < 48; ++i)
    {
        double height = 2.0 * exp2(0.25 * (i < 24 ? i : 48 - i)); // up to 128 m and back
        swView_SetViewpoint(parity.view, (swPos){0.5 * i, height, 0.0});
        StepParity(&parity, 1.0 / 30.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM));
    }
    CheckFoam(difference, "48 frames, up and down");
    FreeParity(&parity);
}

static void FoamAgreesAfterJumps(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 3, 64, (swPos){0.0, 2.0, 0.0});
    Difference difference = {0};
    for (int i = 0; i < 24; ++i)
    {
        if (i % 6 == 3)
        {
            swView_SetViewpoint(parity.view, (swPos){5e3 * i, 2.0, -8e3 * i});
        }
        if (i % 8 == 5)
        {
            swWorld_SetTime(parity.world, 1000.0 * i);
        }
        StepParity(&parity, i % 5 == 4 ? 0.0 : 1.0 / 30.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM));
    }
    CheckFoam(difference, "24 frames, jumps in place and time");
    FreeParity(&parity);
}

static void FoamThatACurrentCarriesAgrees(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 22.0f;
    def.spectrum.fetch = 500e3f;
    def.currentX = 1.5f;
    def.currentZ = 0.5f;
    AddParitySea(&parity, &def);
    AddParityView(&parity, 4, 64, (swPos){-10.0, 2.0, 1e6});
    Difference difference = {0};
    for (int i = 0; i < 40; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){-10.0 - 0.21 * i, 2.0 + 0.2 * i, 1e6 + 0.13 * i});
        StepParity(&parity, i % 7 == 0 ? 0.11 : 1.0 / 60.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM));
    }
    CheckFoam(difference, "40 frames in a current");
    FreeParity(&parity);
}

// Folds then come from a coarser slice.
static void FoamOfLongWavesAgrees(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 4, 64, (swPos){0.0, 2.0, 0.0});
    swFoamDef foam = swDefaultFoamDef();
    foam.minWavelength = 8.0f;
    swWorld_SetFoam(parity.world, &foam);
    Difference difference = {0};
    for (int i = 0; i < 30; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){0.3 * i, 2.0, 0.0});
        StepParity(&parity, 1.0 / 20.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_FOAM));
    }
    CheckFoam(difference, "30 frames, waves of 8 m and more");
    FreeParity(&parity);
}

static void RecordingAFrameTwiceDoesNotAgeFoam(void** state)
{
    Parity parity = MakeFoamySea(state);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    for (int i = 0; i < 5; ++i)
    {
        StepParity(&parity, 1.0 / 30.0);
    }
    float* before = malloc(64 * 64 * sizeof(float));
    float* after = malloc(64 * 64 * sizeof(float));
    assert_int_equal(swGpuWorld_ReadLayer(parity.gpuWorld, parity.view, SW_LAYER_FOAM, 0, before), SW_SUCCESS);
    StepParity(&parity, 0.0);
    StepParity(&parity, 0.0);
    assert_int_equal(swGpuWorld_ReadLayer(parity.gpuWorld, parity.view, SW_LAYER_FOAM, 0, after), SW_SUCCESS);
    assert_memory_equal(before, after, 64 * 64 * sizeof(float));
    free(before);
    free(after);
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(FoamAgreesOverManyFrames),           cmocka_unit_test(FoamAgreesWhileSlicesScroll),
        cmocka_unit_test(FoamAgreesWhileTheScaleChanges),     cmocka_unit_test(FoamAgreesAfterJumps),
        cmocka_unit_test(FoamThatACurrentCarriesAgrees),      cmocka_unit_test(FoamOfLongWavesAgrees),
        cmocka_unit_test(RecordingAFrameTwiceDoesNotAgeFoam),
    };
    return cmocka_run_group_tests_name("foam: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
