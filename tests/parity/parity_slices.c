// SPDX-License-Identifier: MIT
// Displacement agrees within a millimetre at every texel of every slice, wherever the viewer is and whenever;
// derivatives within what half floats hold.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/surface/evaluate.h"
#include "core/surface/slices.h"
#include "shared/depth_share.h"

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

// Depth and its slope as swGpuBottom has them.
static void FindBottom(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                       float (*gradients)[2])
{
    const swGpuBottom* bottom = context;
    (void)system;
    (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double depth =
            (double)bottom->depth + points[i].x * (double)bottom->alongX + points[i].z * (double)bottom->alongZ;
        values[i] = depth > 0.0 ? (float)depth : 0.0f;
        gradients[i][0] = bottom->alongX;
        gradients[i][1] = bottom->alongZ;
    }
}

static float Attenuate(const void* context, const swWaveGroup* group, float depth, float* slope)
{
    (void)context;
    swDepthShare found = swFindNaturalShare(group->k * depth);
    *slope = found.slope * group->k;
    return found.share;
}

// Displacement of some texels of a slice against the core's sum with that bottom.
static double CompareShaped(Parity* parity, int slice)
{
    enum
    {
        STRIDE = 5
    };
    const swFrame* frame = swGetWorldFrame(parity->world);
    const swSlice* place = &frame->views[0].stack.slices[slice];
    const swPlaces places = {.context = &parity->gpuWorld->bottom, .depth = FindBottom, .attenuate = Attenuate};
    swQueryDef def = swDefaultQueryDef();
    swQuery query;
    swBeginQuery(&query, frame, swGetWaveKernels(SW_ISA_BEST), &def, (swPosXZ){0.0, 0.0});
    swTile tiles[SW_MAX_TILES];
    query.tileCount = swSelectSliceTiles(frame, place->minWavelength, tiles);
    query.tiles = tiles;
    query.places = &places;
    size_t side = (size_t)parity->resolution;
    float* texels = malloc(side * side * 4 * sizeof(float));
    assert_non_null(texels);
    assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, SW_LAYER_DISPLACEMENT, slice, texels),
                     SW_SUCCESS);
    double worst = 0.0;
    for (size_t at = 0; at < side * side; at += STRIDE)
    {
        swPosXZ rest = {(double)(place->firstX + (int64_t)(at % side)) * place->texel,
                        (double)(place->firstZ + (int64_t)(at / side)) * place->texel};
        float displacement[1][4] = {{0.0f}};
        const swEvaluation out = {.displacement = displacement};
        swEvaluate(&query, 1, &rest, &out);
        for (int c = 0; c < 3; ++c)
        {
            double error = fabs((double)displacement[0][c] - (double)texels[4 * at + (size_t)c]);
            worst = error > worst ? error : worst;
        }
    }
    free(texels);
    return worst;
}

static void BlocksInGeneralAgreeWithCubics(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Gale();
    AddParitySea(&parity, &sea);
    sea.method = SW_WAVES_GERSTNER;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 4, 128, (swPos){-55.0, 8.0, 1e4});
    parity.gpuWorld->bottom = (swGpuBottom){.depth = 1e9f, .share = 0.5f};
    StepParity(&parity, 3.0);
    CheckSlices(&parity, "half in general, in deep water");
    parity.gpuWorld->bottom.share = 1.0f;
    StepParity(&parity, 0.1);
    CheckSlices(&parity, "all in general, in deep water");
    FreeParity(&parity);
}

static void WavesOverABottomAgreeWithTheCore(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = Breeze();
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 3, 64, (swPos){20.0, 8.0, -30.0});
    const swGpuBottom bottoms[] = {{.depth = 6.0f, .share = 1.0f},
                                   {.depth = 3.0f, .alongX = 0.05f, .alongZ = -0.03f, .share = 1.0f}};
    for (int i = 0; i < 2; ++i)
    {
        parity.gpuWorld->bottom = bottoms[i];
        StepParity(&parity, 1.0);
        for (int slice = 0; slice < 3; ++slice)
        {
            double worst = CompareShaped(&parity, slice);
            printf("  %s, slice %d: max %.3g m\n", i == 0 ? "6 m deep" : "a beach", slice, worst);
            assert_true(worst < DISPLACEMENT_M);
        }
    }
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
        cmocka_unit_test(BlocksInGeneralAgreeWithCubics),
        cmocka_unit_test(WavesOverABottomAgreeWithTheCore),
    };
    return cmocka_run_group_tests_name("slices: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
