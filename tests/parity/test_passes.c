// SPDX-License-Identifier: MIT
// The order of a frame follows from the table of passes: what each reads and writes says where barriers stand.

#include "parity/parity.h"

#include <stdio.h>

// ---- steps that are made up ----

#define A ((swResources)1)
#define B ((swResources)2)
#define C ((swResources)4)
#define COMPUTE (1u << SW_STAGE_COMPUTE)
#define COPY (1u << SW_STAGE_COPY)

static void AStepWaitsForWhatItReads(void** state)
{
    (void)state;
    swHazards hazards = {0};
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, 0, A), 0);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, B, C), 0); // has nothing to do with A
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A, 0), COMPUTE);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A | C, 0), 0); // one barrier was for both
}

static void AStepWaitsForWhoReadsWhatItWrites(void** state)
{
    (void)state;
    swHazards hazards = {0};
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A, B), 0);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A, C), 0); // readers do not wait for each other
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, 0, A), COMPUTE);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, 0, A), COMPUTE); // nor do two writers overlap
}

static void AStepMayGoOnFromItsOwnPast(void** state)
{
    (void)state;
    swHazards hazards = {0};
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A | B, B), 0); // as foam does, from one image to the other
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, B, 0), COMPUTE);
}

// A barrier for one stage leaves the other to wait by itself.
static void StagesWaitEachForItself(void** state)
{
    (void)state;
    swHazards hazards = {0};
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COPY, 0, A), 0);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, 0, B), 0);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, A, 0), COMPUTE | COPY);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COPY, B, 0), COMPUTE | COPY);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, B, 0), 0);
    assert_int_equal(swTakeStep(&hazards, SW_STAGE_COMPUTE, 0, B), COMPUTE | COPY); // the copy still reads it
}

// ---- the table ----

static void EveryPassReadsWhatWasMadeBefore(void** state)
{
    (void)state;
    swResources made = SW_MODES_BIT | SW_INPUTS_BIT;
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        const swPass* pass = swGetPass((swPassId)i);
        swResources past = pass->writes & SW_ALL_LAYERS_BITS; // a layer may go on from its own past
        assert_int_equal(pass->reads & ~(made | past), 0);
        assert_int_equal(pass->writes & made, 0); // nothing is made twice
        assert_int_not_equal(pass->writes, 0);
        made |= pass->writes;
    }
    assert_int_equal(made & SW_ALL_LAYERS_BITS, SW_ALL_LAYERS_BITS); // and every layer is made
}

// ---- barriers of real frames ----

static PFN_vkCmdPipelineBarrier2 s_barrier;
static int s_memoryBarriers, s_imageBarriers;

static VKAPI_ATTR void VKAPI_CALL CountBarrier(VkCommandBuffer commands, const VkDependencyInfo* info)
{
    s_memoryBarriers += (int)info->memoryBarrierCount;
    s_imageBarriers += (int)info->imageMemoryBarrierCount;
    s_barrier(commands, info);
}

static int CountFrameBarriers(Parity* parity)
{
    s_barrier = parity->gpu->vk.CmdPipelineBarrier2;
    parity->gpu->vk.CmdPipelineBarrier2 = CountBarrier;
    s_memoryBarriers = 0;
    s_imageBarriers = 0;
    StepParity(parity, 0.1); // foam steps
    parity->gpu->vk.CmdPipelineBarrier2 = s_barrier;
    return s_memoryBarriers;
}

static Parity MakeSea(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 2.0f;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 3, 64, (swPos){0.0, 2.0, 0.0});
    StepParity(&parity, 0.0);
    StepParity(&parity, 1.0 / 30.0);
    return parity;
}

// Between frames, rows to columns, columns to slices, slices to foam, and to drawing. It was one more when each place
// had its barrier by hand: also frames that bring no modes waited for copies.
static void AFrameHasFiveBarriers(void** state)
{
    Parity parity = MakeSea(state);
    int count = CountFrameBarriers(&parity);
    printf("  %d barriers of a frame with a view\n", count);
    assert_int_equal(count, 5);
    assert_int_equal(s_imageBarriers, 0);
    FreeParity(&parity);
}

// Fields are made beside the waves, so shaped waves wait for both at once, and slices for those; and where nothing
// changes nothing is brought or made.
static void AuthoredFieldsCostOneBarrierMore(void** state)
{
    Parity parity = MakeSea(state);
    swInputDef seabed = swDefaultInputDef();
    seabed.value[0] = -8.0f;
    swInputId id;
    assert_int_equal(swCreateInput(parity.world, &seabed, &id), SW_SUCCESS);
    assert_false(parity.gpuWorld->passes[SW_PASS_FIELDS].isNeeded);
    StepParity(&parity, 1.0 / 30.0);
    assert_true(parity.gpuWorld->inputs.isBrought);
    assert_true(parity.gpuWorld->passes[SW_PASS_FIELDS].isNeeded);
    int count = CountFrameBarriers(&parity);
    assert_false(parity.gpuWorld->passes[SW_PASS_FIELDS].isNeeded);
    assert_false(parity.gpuWorld->inputs.isBrought);
    printf("  %d barriers with authored fields\n", count);
    assert_int_equal(count, 6);
    FreeParity(&parity);
}

// The copy to the host waits once more; that the host may read is part of the last. It was eight.
static void AQueryCostsOneBarrierMore(void** state)
{
    Parity parity = MakeSea(state);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    swGpuQuery* query;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &query), SW_SUCCESS);
    swGpuQuery_SetPoints(query, 1, &(swPosXZ){1.0, 2.0});
    StepParity(&parity, 1.0 / 30.0);
    int count = CountFrameBarriers(&parity);
    printf("  %d barriers with a query\n", count);
    assert_int_equal(count, 6);
    swDestroyGpuQuery(query);
    FreeParity(&parity);
}

static void APassWithNothingToDoRecordsNothing(void** state)
{
    Parity parity = MakeParity(state);
    StepParity(&parity, 0.0);
    StepParity(&parity, 1.0 / 30.0);
    assert_int_equal(CountFrameBarriers(&parity), 2); // between frames, and to drawing
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        assert_false(parity.gpuWorld->passes[i].isNeeded);
    }
    FreeParity(&parity);
}

static void APassOwnsOnlyWhatItNeeds(void** state)
{
    Parity parity = MakeSea(state);
    assert_int_equal(swGetVolumeWaves(parity.gpuWorld)->size, 0); // no query of the water below
    assert_true(swGetDetailImage(parity.gpuWorld)->handle != VK_NULL_HANDLE);
    FreeParity(&parity);
}

// ---- variants ----

static void VariantsAreMadeOnce(void** state)
{
    Parity parity = MakeSea(state);
    const uint32_t without[SW_MAX_CONSTANTS] = {0};
    swGpuQueryDef def = swDefaultGpuQueryDef();
    swGpuQuery* queries[2];
    for (int i = 0; i < 2; ++i)
    {
        assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &queries[i]), SW_SUCCESS);
    }
    const swVariants* variants = parity.gpuWorld->passes[SW_PASS_SURFACE_QUERY].state;
    assert_int_equal(variants->count, 1);
    def.outputs = SW_GPU_QUERY_VELOCITY;
    swGpuQuery* moving;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &moving), SW_SUCCESS);
    assert_int_equal(variants->count, 2);
    assert_ptr_equal(swFindVariant(variants, variants->pipelines[0].shader, without), &variants->pipelines[0]);
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AStepWaitsForWhatItReads),
        cmocka_unit_test(AStepWaitsForWhoReadsWhatItWrites),
        cmocka_unit_test(AStepMayGoOnFromItsOwnPast),
        cmocka_unit_test(StagesWaitEachForItself),
        cmocka_unit_test(EveryPassReadsWhatWasMadeBefore),
        cmocka_unit_test(AFrameHasFiveBarriers),
        cmocka_unit_test(AuthoredFieldsCostOneBarrierMore),
        cmocka_unit_test(AQueryCostsOneBarrierMore),
        cmocka_unit_test(APassWithNothingToDoRecordsNothing),
        cmocka_unit_test(APassOwnsOnlyWhatItNeeds),
        cmocka_unit_test(VariantsAreMadeOnce),
    };
    return cmocka_run_group_tests_name("passes", tests, OpenParityGpu, CloseParityGpu);
}
