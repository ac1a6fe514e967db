// SPDX-License-Identifier: MIT
// Recording is all or nothing: after a failure, or commands that were thrown away, the next recording leaves what a
// twin leaves that never missed anything. Both twins are of one world on one device, so that they can be compared bit
// for bit.

#include "parity/parity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/vk/vk_submit.h"
#include "support/counting_host.h"

#define RESOLUTION 64
#define SLICES 3

// ---- creations that fail ----

static int s_failAt = -1; // index of the creation that fails; -1: none
static int s_created;
static PFN_vkCreateBuffer s_createBuffer;
static PFN_vkCreateImage s_createImage;
static PFN_vkAllocateMemory s_allocateMemory;
static PFN_vkCreateComputePipelines s_createPipelines;

static bool FailsNow(void)
{
    return s_created++ == s_failAt;
}

static VKAPI_ATTR VkResult VKAPI_CALL CreateBufferOrFail(VkDevice device, const VkBufferCreateInfo* info,
                                                         const VkAllocationCallbacks* callbacks, VkBuffer* buffer)
{
    return FailsNow() ? VK_ERROR_OUT_OF_DEVICE_MEMORY : s_createBuffer(device, info, callbacks, buffer);
}

static VKAPI_ATTR VkResult VKAPI_CALL CreateImageOrFail(VkDevice device, const VkImageCreateInfo* info,
                                                        const VkAllocationCallbacks* callbacks, VkImage* image)
{
    return FailsNow() ? VK_ERROR_OUT_OF_DEVICE_MEMORY : s_createImage(device, info, callbacks, image);
}

static VKAPI_ATTR VkResult VKAPI_CALL AllocateMemoryOrFail(VkDevice device, const VkMemoryAllocateInfo* info,
                                                           const VkAllocationCallbacks* callbacks,
                                                           VkDeviceMemory* memory)
{
    return FailsNow() ? VK_ERROR_OUT_OF_DEVICE_MEMORY : s_allocateMemory(device, info, callbacks, memory);
}

static VKAPI_ATTR VkResult VKAPI_CALL CreatePipelinesOrFail(VkDevice device, VkPipelineCache cache, uint32_t count,
                                                            const VkComputePipelineCreateInfo* infos,
                                                            const VkAllocationCallbacks* callbacks,
                                                            VkPipeline* pipelines)
{
    return FailsNow() ? VK_ERROR_OUT_OF_HOST_MEMORY
                      : s_createPipelines(device, cache, count, infos, callbacks, pipelines);
}

// ---- commands that are recorded ----

static int s_commands;
static PFN_vkCmdDispatch s_dispatch;
static PFN_vkCmdCopyBuffer s_copyBuffer;
static PFN_vkCmdPipelineBarrier2 s_barrier;

static VKAPI_ATTR void VKAPI_CALL CountDispatch(VkCommandBuffer commands, uint32_t x, uint32_t y, uint32_t z)
{
    s_commands += 1;
    s_dispatch(commands, x, y, z);
}

static VKAPI_ATTR void VKAPI_CALL CountCopy(VkCommandBuffer commands, VkBuffer from, VkBuffer to, uint32_t count,
                                            const VkBufferCopy* copies)
{
    s_commands += 1;
    s_copyBuffer(commands, from, to, count, copies);
}

static VKAPI_ATTR void VKAPI_CALL CountBarrier(VkCommandBuffer commands, const VkDependencyInfo* info)
{
    s_commands += 1;
    s_barrier(commands, info);
}

static void BeginFailing(swGpu* gpu)
{
    s_commands = 0;
    s_dispatch = gpu->vk.CmdDispatch;
    s_copyBuffer = gpu->vk.CmdCopyBuffer;
    s_barrier = gpu->vk.CmdPipelineBarrier2;
    gpu->vk.CmdDispatch = CountDispatch;
    gpu->vk.CmdCopyBuffer = CountCopy;
    gpu->vk.CmdPipelineBarrier2 = CountBarrier;
    s_createBuffer = gpu->vk.CreateBuffer;
    s_createImage = gpu->vk.CreateImage;
    s_allocateMemory = gpu->vk.AllocateMemory;
    s_createPipelines = gpu->vk.CreateComputePipelines;
    gpu->vk.CreateBuffer = CreateBufferOrFail;
    gpu->vk.CreateImage = CreateImageOrFail;
    gpu->vk.AllocateMemory = AllocateMemoryOrFail;
    gpu->vk.CreateComputePipelines = CreatePipelinesOrFail;
}

static void EndFailing(swGpu* gpu)
{
    gpu->vk.CmdDispatch = s_dispatch;
    gpu->vk.CmdCopyBuffer = s_copyBuffer;
    gpu->vk.CmdPipelineBarrier2 = s_barrier;
    gpu->vk.CreateBuffer = s_createBuffer;
    gpu->vk.CreateImage = s_createImage;
    gpu->vk.AllocateMemory = s_allocateMemory;
    gpu->vk.CreateComputePipelines = s_createPipelines;
    s_failAt = -1;
}

// ---- twins ----

typedef struct Twins
{
    CountingMemory memory;
    swGpu* gpu; // of its own: its host's memory can fail
    swWorld* world;
    swWaveSystemId sea;
    swView* views[2];
    int viewCount;
    swGpuWorld *sound, *hurt;
    uint64_t frameIndex;
} Twins;

static swWaveSystemDef Breeze(float windSpeed)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = windSpeed;
    def.minWavelength = 2.0f; // few tiles: these tests run many times
    return def;
}

static void AddView(Twins* twins)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = SLICES;
    def.resolution = RESOLUTION;
    def.finestTexel = 0.25f;
    assert_int_equal(swCreateView(twins->world, &def, &twins->views[twins->viewCount]), SW_SUCCESS);
    swView_SetViewpoint(twins->views[twins->viewCount], (swPos){10.0 * twins->viewCount, 2.0, 0.0});
    twins->viewCount += 1;
}

// Four small frames are in flight, so that as many can be taken back.
static Twins* MakeTwins(void)
{
    static Twins twins; // where its host's memory is counted
    memset(&twins, 0, sizeof(twins));
    swHost host = MakeCountingHost(&twins.memory);
    swGpuDef def = swDefaultGpuDef();
    def.layers = SW_LAYERS_GPU;
    def.framesInFlight = 4;
    def.enableValidation = true;
    if (swCreateGpu(&host, &def, &twins.gpu) != SW_SUCCESS)
    {
        def.enableValidation = false; // the layers are not installed
        assert_int_equal(swCreateGpu(&host, &def, &twins.gpu), SW_SUCCESS);
    }
    swHost worldHost = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.foam.threshold = 0.9f; // foam everywhere: it is what has a past
    assert_int_equal(swCreateWorld(&worldHost, &worldDef, &twins.world), SW_SUCCESS);
    swWaveSystemDef sea = Breeze(9.0f);
    assert_int_equal(swCreateWaveSystem(twins.world, &sea, &twins.sea), SW_SUCCESS);
    AddView(&twins);
    assert_int_equal(swCreateGpuWorld(twins.gpu, twins.world, &twins.sound), SW_SUCCESS);
    assert_int_equal(swCreateGpuWorld(twins.gpu, twins.world, &twins.hurt), SW_SUCCESS);
    return &twins;
}

static void FreeTwins(Twins* twins)
{
    swDestroyGpuWorld(twins->sound);
    swDestroyGpuWorld(twins->hurt);
    for (int i = 0; i < twins->viewCount; ++i)
    {
        swDestroyView(twins->views[i]);
    }
    swDestroyWorld(twins->world);
    assert_int_equal(swGpu_GetValidationCount(twins->gpu), 0);
    swDestroyGpu(twins->gpu);
}

typedef enum Fate
{
    RUN,
    THROW_AWAY
} Fate;

static swResult Record(Twins* twins, swGpuWorld* gpuWorld, Fate fate)
{
    VkCommandBuffer commands;
    assert_int_equal(swBeginSubmit(twins->gpu, &commands), SW_SUCCESS);
    swResult result = swGpuWorld_Record(gpuWorld, commands, twins->frameIndex++);
    if (fate == RUN)
    {
        assert_int_equal(swEndSubmit(twins->gpu), SW_SUCCESS);
    }
    return result;
}

static void RunBoth(Twins* twins, double dt)
{
    assert_int_equal(swWorld_Step(twins->world, dt), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->sound, RUN), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->hurt, RUN), SW_SUCCESS);
}

static void CheckLayersEqual(const Twins* twins, bool withFoam)
{
    static float sound[RESOLUTION * RESOLUTION * 4], hurt[RESOLUTION * RESOLUTION * 4];
    float foamSum = 0.0f;
    for (int view = 0; view < twins->viewCount; ++view)
    {
        for (int i = 0; i < SLICES * (withFoam ? SW_LAYER_COUNT : SW_LAYER_FOAM); ++i)
        {
            swLayer layer = (swLayer)(i / SLICES);
            size_t size = RESOLUTION * RESOLUTION * sizeof(float) * (layer == SW_LAYER_FOAM ? 1 : 4);
            assert_int_equal(swGpuWorld_ReadLayer(twins->sound, twins->views[view], layer, i % SLICES, sound),
                             SW_SUCCESS);
            assert_int_equal(swGpuWorld_ReadLayer(twins->hurt, twins->views[view], layer, i % SLICES, hurt),
                             SW_SUCCESS);
            assert_memory_equal(sound, hurt, size);
            foamSum += layer == SW_LAYER_FOAM ? sound[RESOLUTION] + sound[RESOLUTION * RESOLUTION / 2] : 1.0f;
        }
    }
    assert_true(foamSum > 0.0f);
}

static void CheckDetailEqual(const Twins* twins)
{
    static float sound[SW_DETAIL_MAX * SW_DETAIL_MAX * 4], hurt[SW_DETAIL_MAX * SW_DETAIL_MAX * 4];
    size_t side = swGetDetailImage(twins->sound)->width;
    for (int tile = 0; tile < twins->sound->tiles.count; ++tile)
    {
        assert_int_equal(swReadDetail(twins->sound, tile, 0, sound), SW_SUCCESS);
        assert_int_equal(swReadDetail(twins->hurt, tile, 0, hurt), SW_SUCCESS);
        assert_memory_equal(sound, hurt, side * side * 4 * sizeof(float));
    }
}

static void CheckEqual(const Twins* twins)
{
    CheckLayersEqual(twins, true);
    CheckDetailEqual(twins);
}

// A sea with more waves, a second view, and a query: everything that makes a recording allocate.
static void ChangeAll(Twins* twins, swGpuQuery** query)
{
    swWaveSystemDef sea = Breeze(14.0f);
    sea.minWavelength = 1.0f;
    sea.resolution = 64;
    sea.tileWaves = 16;
    assert_int_equal(swWaveSystem_Set(twins->world, twins->sea, &sea, 0.0), SW_SUCCESS);
    AddView(twins);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.outputs = SW_GPU_QUERY_VELOCITY;
    assert_int_equal(swCreateGpuQuery(twins->hurt, &def, query), SW_SUCCESS);
    swGpuQuery_SetPoints(*query, 1, &(swPosXZ){1.0, 2.0});
}

// The frame that makes everything new, with one of its creations failing; false once there was none to fail. Commands
// of the frame that failed run or not, just as a host likes.
static bool FailOnce(int failAt, bool hostMemory)
{
    Twins* twins = MakeTwins();
    RunBoth(twins, 0.0);
    RunBoth(twins, 0.1);
    swGpuQuery* query = NULL;
    ChangeAll(twins, &query);
    assert_int_equal(swWorld_Step(twins->world, 0.1), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->sound, RUN), SW_SUCCESS);

    BeginFailing(twins->gpu);
    s_created = 0;
    s_failAt = hostMemory ? -1 : failAt;
    long long before = atomic_load(&twins->memory.allocations);
    atomic_store(&twins->memory.failAt, hostMemory ? before + failAt : -1);
    swResult result = Record(twins, twins->hurt, failAt % 2 == 0 ? RUN : THROW_AWAY);
    bool hasFailed = hostMemory ? atomic_load(&twins->memory.allocations) > before + failAt : s_created > failAt;
    EndFailing(twins->gpu);
    atomic_store(&twins->memory.failAt, -1);
    if (result == SW_SUCCESS && failAt % 2 == 1)
    {
        swGpuWorld_Discard(twins->hurt, twins->frameIndex - 1);
    }
    assert_int_equal(s_commands > 0, result == SW_SUCCESS);         // all or nothing
    assert_true(hostMemory || (result != SW_SUCCESS) == hasFailed); // without host memory to note it, one waits instead
    float texel[RESOLUTION * RESOLUTION * 4];
    if (result != SW_SUCCESS)
    {
        assert_int_equal(swGpuWorld_ReadLayer(twins->hurt, twins->views[0], SW_LAYER_DISPLACEMENT, 0, texel),
                         SW_ERROR_INVALID); // nothing was recorded
    }
    assert_int_equal(Record(twins, twins->hurt, RUN), SW_SUCCESS);
    CheckEqual(twins);
    RunBoth(twins, 0.1);
    CheckEqual(twins);
    FreeTwins(twins);
    return hasFailed;
}

static void ARecordingMakesUpForOneThatFailed(void** state)
{
    (void)state;
    int count = 0;
    while (FailOnce(count, false))
    {
        count += 1;
    }
    printf("  %d creations, each failed once\n", count);
    assert_true(count > 5);
    int hostCount = 0;
    while (FailOnce(hostCount, true))
    {
        hostCount += 1;
    }
    printf("  %d allocations of the host, each failed once\n", hostCount);
}

static void TheFirstFrameMayBeThrownAway(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    assert_int_equal(swWorld_Step(twins->world, 0.0), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
    swGpuWorld_Discard(twins->hurt, twins->frameIndex - 1);
    assert_int_equal(Record(twins, twins->sound, RUN), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->hurt, RUN), SW_SUCCESS);
    CheckEqual(twins);
    FreeTwins(twins);
}

// The same frame again: also foam is that of the twin.
static void AFrameThatWasThrownAwayIsRecordedAgain(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    RunBoth(twins, 0.0);
    RunBoth(twins, 0.1);
    swGpuQuery* query = NULL;
    ChangeAll(twins, &query);
    assert_int_equal(swWorld_Step(twins->world, 0.1), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->sound, RUN), SW_SUCCESS);
    for (int i = 0; i < 3; ++i)
    {
        assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
        swGpuWorld_Discard(twins->hurt, twins->frameIndex - 1);
        swGpuQueryResults results;
        swGpu_SetFinishedFrame(twins->gpu, twins->frameIndex - 1);
        assert_false(swGpuQuery_GetResults(query, &results)); // answers that never came
    }
    assert_int_equal(Record(twins, twins->hurt, RUN), SW_SUCCESS);
    CheckEqual(twins);
    RunBoth(twins, 0.1);
    CheckEqual(twins);
    FreeTwins(twins);
}

// Two frames of one and the same index, as a host has them that counts what it submits.
static void AFrameIndexMayBeUsedAgain(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    RunBoth(twins, 0.0);
    assert_int_equal(swWorld_Step(twins->world, 0.1), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->sound, RUN), SW_SUCCESS);
    uint64_t index = twins->frameIndex;
    assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
    assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
    swGpuWorld_Discard(twins->hurt, index);
    twins->frameIndex = index;
    assert_int_equal(Record(twins, twins->hurt, RUN), SW_SUCCESS);
    CheckEqual(twins);
    RunBoth(twins, 0.1);
    CheckEqual(twins);
    FreeTwins(twins);
}

// Frames that the other twin never recorded: foam goes on from the last that ran.
static void SeveralFramesInFlightMayBeThrownAway(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    RunBoth(twins, 0.0);
    RunBoth(twins, 0.1);
    RunBoth(twins, 0.1);
    uint64_t first = twins->frameIndex;
    for (int i = 0; i < 4; ++i)
    {
        assert_int_equal(swWorld_Step(twins->world, 0.1), SW_SUCCESS);
        assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
    }
    swGpuWorld_Discard(twins->hurt, first);
    RunBoth(twins, 0.1);
    CheckEqual(twins);
    FreeTwins(twins);
}

// More than can be taken back: foam begins anew, all else is as it should be.
static void TooManyFramesCostThePastOfFoam(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    RunBoth(twins, 0.0);
    uint64_t first = twins->frameIndex;
    for (int i = 0; i < 8; ++i)
    {
        assert_int_equal(swWorld_Step(twins->world, 0.1), SW_SUCCESS);
        assert_int_equal(Record(twins, twins->hurt, THROW_AWAY), SW_SUCCESS);
    }
    swGpuWorld_Discard(twins->hurt, first);
    RunBoth(twins, 0.1);
    CheckLayersEqual(twins, false);
    FreeTwins(twins);
}

#ifdef NDEBUG // with asserts it stops
static void AShaderWithTooMuchToBindIsRefused(void** state)
{
    (void)state;
    Twins* twins = MakeTwins();
    uint32_t constants[SW_MAX_CONSTANTS + 1] = {0};
    const swShader shaders[] = {
        {.constantCount = SW_MAX_CONSTANTS + 1, .name = "constants"},
        {.bindingCount = SW_MAX_BINDINGS + 1, .name = "bindings"},
        {.pushSize = SW_MAX_PUSH_BYTES + 4, .name = "push"},
        {.constantCount = 1, .name = "constants that are not given"},
    };
    for (size_t i = 0; i < sizeof(shaders) / sizeof(shaders[0]); ++i)
    {
        swPipeline pipeline;
        const void* values = shaders[i].constantCount > 1 ? constants : NULL;
        long long messages = atomic_load(&twins->memory.messages);
        assert_int_equal(swCreateComputePipeline(twins->gpu, &shaders[i], values, &pipeline), SW_ERROR_INVALID);
        assert_true(pipeline.handle == VK_NULL_HANDLE);
        assert_int_equal(atomic_load(&twins->memory.messages), messages + 1);
        const swGraphicsDef draw = {.vertex = &shaders[i], .constants = values, .name = shaders[i].name};
        assert_int_equal(swCreateGraphicsPipeline(twins->gpu, &draw, &pipeline), SW_ERROR_INVALID);
    }
    FreeTwins(twins);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheFirstFrameMayBeThrownAway),      cmocka_unit_test(AFrameThatWasThrownAwayIsRecordedAgain),
        cmocka_unit_test(AFrameIndexMayBeUsedAgain),         cmocka_unit_test(SeveralFramesInFlightMayBeThrownAway),
        cmocka_unit_test(TooManyFramesCostThePastOfFoam),    cmocka_unit_test(ARecordingMakesUpForOneThatFailed),
#ifdef NDEBUG
        cmocka_unit_test(AShaderWithTooMuchToBindIsRefused),
#endif
    };
    return cmocka_run_group_tests_name("recording", tests, NULL, NULL);
}
