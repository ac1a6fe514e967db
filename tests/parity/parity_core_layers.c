// SPDX-License-Identifier: MIT
// Where the core makes the layers, the device holds just them: bit for bit, derivatives as half floats, and tiles and
// their slopes as the passes would make them.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int OpenCoreGpu(void** state)
{
    return OpenParityGpuWith(state, SW_LAYERS_CORE);
}

static void CheckLayers(Parity* parity, const char* what)
{
    Difference displacement = CompareLayer(parity, SW_LAYER_DISPLACEMENT);
    Difference derivatives = CompareLayer(parity, SW_LAYER_DERIVATIVES);
    Difference foam = CompareLayer(parity, SW_LAYER_FOAM);
    PrintDifference(what, derivatives, "of derivatives");
    assert_true(displacement.worst == 0.0 && displacement.scale > 0.0);
    assert_true(foam.worst == 0.0);
    assert_true(derivatives.worst <= 0x1p-10); // half a step of halves below 4
}

static void LayersAreTheCores(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.spectrum.windSpeed = 14.0f;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 4, 64, (swPos){3.0, 2.0, -7.0});
    for (int i = 0; i < 6; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){3.0 + 4.0 * i, 2.0 + 8.0 * i, -7.0});
        StepParity(&parity, 0.25);
        CheckLayers(&parity, "a moving viewer");
    }
    swWorld_SetTime(parity.world, 1e6);
    StepParity(&parity, 0.0);
    CheckLayers(&parity, "after a jump");
    FreeParity(&parity);
}

// A view without CPU layers is made by the passes, from the core's tiles.
static void AViewWithoutCoreLayersIsMadeByThePasses(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 3, 64, (swPos){0.0, 2.0, 0.0});
    swViewDef def = swDefaultViewDef();
    def.sliceCount = 3;
    def.resolution = 64;
    swView* plain = NULL;
    assert_int_equal(swCreateView(parity.world, &def, &plain), SW_SUCCESS);
    swView_SetViewpoint(plain, (swPos){0.0, 2.0, 0.0});
    StepParity(&parity, 1.0);
    assert_true(parity.gpuWorld->tiles.isCore);
    const size_t count = 64 * 64;
    float* texels = malloc(count * 4 * sizeof(float));
    assert_non_null(texels);
    for (int slice = 0; slice < 3; ++slice)
    {
        assert_int_equal(swGpuWorld_ReadLayer(parity.gpuWorld, plain, SW_LAYER_DISPLACEMENT, slice, texels),
                         SW_SUCCESS);
        Difference difference = Compare(swView_GetDisplacement(parity.view, slice), texels, count, 4, 3);
        PrintDifference("passes over the core's tiles", difference, "m");
        assert_true(difference.scale > 0.0 && difference.worst < 1e-3);
    }
    free(texels);
    swDestroyView(plain);
    FreeParity(&parity);
}

// Velocity is a field that the core does not have in this world: the passes make all of the tiles.
static void AQueryOfVelocityStillHasItsTiles(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.outputs = SW_GPU_QUERY_VELOCITY;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &query), SW_SUCCESS);
    StepParity(&parity, 1.0);
    assert_true(parity.gpuWorld->tiles.isCore);
    swGpuQuery_SetPoints(query, 1, &(swPosXZ){5.0, 6.0});
    StepParity(&parity, 0.1);
    assert_false(parity.gpuWorld->tiles.isCore);
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    float height = (float)swMoment_GetHeight(swWorld_GetMoment(parity.world), 5.0, 6.0);
    assert_float_equal(results.heights[0].height, height, 1e-3f);
    assert_true(results.velocities[0].y != 0.0f);
    CheckLayers(&parity, "beside a query of velocity");
    FreeParity(&parity);
}

// The device's own scene of slopes comes from the core's tiles as from its own.
static void DetailIsThatOfThePasses(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    StepParity(&parity, 1.0);
    size_t side = swGetDetailImage(parity.gpuWorld)->width;
    float* core = malloc(side * side * 4 * sizeof(float));
    float* passes = malloc(side * side * 4 * sizeof(float));
    assert_true(core != NULL && passes != NULL && parity.gpuWorld->tiles.count > 0);
    for (int tile = 0; tile < parity.gpuWorld->tiles.count; ++tile)
    {
        parity.gpu->usesCoreLayers = true;
        StepParity(&parity, 0.0);
        assert_int_equal(swReadDetail(parity.gpuWorld, tile, 0, core), SW_SUCCESS);
        parity.gpu->usesCoreLayers = false;
        StepParity(&parity, 0.0);
        assert_int_equal(swReadDetail(parity.gpuWorld, tile, 0, passes), SW_SUCCESS);
        Difference difference = Compare(core, passes, side * side, 4, 4);
        assert_true(difference.scale > 0.0 && difference.worst < 2e-3 * fmax(1.0, difference.scale));
    }
    parity.gpu->usesCoreLayers = true;
    free(core);
    free(passes);
    FreeParity(&parity);
}

static void ViewsAreFittedToTheDeviceAndThePicture(void** state)
{
    swGpu* gpu = *state;
    swViewDef usual = swDefaultViewDef();
    assert_true(swGpu_WantsCpuLayers(gpu));
    swViewDef large = swGpu_FitView(gpu, &usual, 720);
    assert_true(large.enableCpuLayers && large.resolution == usual.resolution);
    swViewDef small = swGpu_FitView(gpu, &usual, 360);
    if (swGpu_IsSoftware(gpu))
    {
        assert_true(small.resolution == usual.resolution / 2 && small.finestTexel == 2.0f * usual.finestTexel);
    }
    usual.resolution = 256;
    assert_int_equal(swGpu_FitView(gpu, &usual, 180).resolution, 256); // what was asked for stays
    gpu->usesCoreLayers = false;
    assert_false(swGpu_FitView(gpu, &usual, 180).enableCpuLayers);
    gpu->usesCoreLayers = true;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAreTheCores),
        cmocka_unit_test(AViewWithoutCoreLayersIsMadeByThePasses),
        cmocka_unit_test(AQueryOfVelocityStillHasItsTiles),
        cmocka_unit_test(DetailIsThatOfThePasses),
        cmocka_unit_test(ViewsAreFittedToTheDeviceAndThePicture),
    };
    return cmocka_run_group_tests_name("layers that the core makes", tests, OpenCoreGpu, CloseParityGpu);
}
