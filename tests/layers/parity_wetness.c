// SPDX-License-Identifier: MIT
// A made-up look on both halves: wetness agrees at every texel while slices scroll, the scale changes, and frames have
// any length.

#include "parity/parity.h"

#include <stdlib.h>

#define TOLERANCE 1e-4 // soaks by twice the height, whose parity is held to 0.02 mm

static Difference CompareWetness(Parity* parity)
{
    size_t count = (size_t)parity->resolution * (size_t)parity->resolution;
    float* gpu = malloc(count * sizeof(float));
    assert_non_null(gpu);
    const swGpuView* view = swFindGpuView(parity->gpuWorld, parity->view);
    const float* cpu = swGetWorldFrame(parity->world)->views[0].stack.layers[SW_LAYER_INDEX_WETNESS].texels;
    Difference difference = {0};
    for (int slice = 0; slice < parity->sliceCount; ++slice)
    {
        assert_int_equal(swReadLayer(parity->gpu, view, SW_LAYER_INDEX_WETNESS, slice, gpu), SW_SUCCESS);
        difference = MaxDifference(difference, Compare(cpu + (size_t)slice * count, gpu, count, 1, 1));
    }
    free(gpu);
    return difference;
}

static Parity MakeWetSea(void** state, int sliceCount)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    AddParityView(&parity, sliceCount, 64, (swPos){0.0, 2.0, 0.0});
    return parity;
}

static void CheckWetness(Difference difference, const char* what)
{
    PrintDifference(what, difference, "");
    assert_true(difference.worst < TOLERANCE);
    assert_true(difference.scale > 0.01); // something is wet at all
}

static void WetnessAgreesWhileSlicesScroll(void** state)
{
    Parity parity = MakeWetSea(state, 4);
    Difference difference = {0};
    for (int i = 0; i < 30; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){-0.21 * i, 2.0, 0.13 * i});
        StepParity(&parity, i % 7 == 0 ? 0.11 : 1.0 / 60.0);
        difference = MaxDifference(difference, CompareWetness(&parity));
    }
    CheckWetness(difference, "30 frames, viewer moving");
    FreeParity(&parity);
}

static void WetnessAgreesWhileTheScaleChanges(void** state)
{
    Parity parity = MakeWetSea(state, 3);
    Difference difference = {0};
    for (int i = 0; i < 30; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){0.0, 2.0 + (i < 15 ? i : 30 - i) * 2.0, 0.0});
        StepParity(&parity, 0.05);
        difference = MaxDifference(difference, CompareWetness(&parity));
    }
    CheckWetness(difference, "30 frames, viewer climbing and sinking");
    FreeParity(&parity);
}

static void WetnessAgreesAfterAJump(void** state)
{
    Parity parity = MakeWetSea(state, 5);
    StepParity(&parity, 0.1);
    StepParity(&parity, 5.0);
    for (int i = 0; i < 5; ++i)
    {
        StepParity(&parity, 0.1);
    }
    CheckWetness(CompareWetness(&parity), "after a jump in time");
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WetnessAgreesWhileSlicesScroll),
        cmocka_unit_test(WetnessAgreesWhileTheScaleChanges),
        cmocka_unit_test(WetnessAgreesAfterAJump),
    };
    return cmocka_run_group_tests(tests, OpenParityGpu, CloseParityGpu);
}
