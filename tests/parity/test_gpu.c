// SPDX-License-Identifier: MIT
// Devices: what is said when there is none, that nothing leaks whatever allocation fails, and pipeline caches.

#include "parity/parity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/vk/vk_submit.h"
#include "support/counting_host.h"

static swGpuDef PlainDef(void)
{
    return swDefaultGpuDef();
}

static void AMissingDeviceIsNamed(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swGpuDef def = PlainDef();
    def.choice = SW_DEVICE_INDEX;
    def.deviceIndex = 99;
    swGpu* gpu = NULL;
    assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_ERROR_NO_DEVICE);
    assert_null(gpu);
    assert_int_equal(atomic_load(&memory.messages), 1);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void HalfOfAHostsDeviceIsRefused(void** state)
{
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swGpuDef def = PlainDef();
    def.instance = swGpu_GetInstance(*state);
    swGpu* gpu = NULL;
    assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_ERROR_INVALID);
    assert_int_equal(atomic_load(&memory.messages), 1);
    def = PlainDef();
    def.framesInFlight = 5;
    assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_ERROR_INVALID);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void AHostsDeviceIsUsedAndLeftAlone(void** state)
{
    swGpu* owner = *state;
    swHost host = swDefaultHost();
    swGpuDef def = PlainDef();
    def.getInstanceProcAddr = owner->getInstanceProcAddr;
    def.instance = swGpu_GetInstance(owner);
    def.physicalDevice = swGpu_GetPhysicalDevice(owner);
    def.device = swGpu_GetDevice(owner);
    def.queue = swGpu_GetQueue(owner);
    def.queueFamily = swGpu_GetQueueFamily(owner);
    swGpu* gpu = NULL;
    assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_SUCCESS);
    assert_string_equal(swGpu_GetDeviceName(gpu), swGpu_GetDeviceName(owner));
    swDestroyGpu(gpu);
    assert_int_equal(owner->vk.DeviceWaitIdle(owner->device), VK_SUCCESS);
}

static void TheDeviceInUseLacksNothing(void** state)
{
    swGpu* gpu = *state;
    char missing[256] = "?";
    assert_true(
        swGpu_CheckDevice(gpu->getInstanceProcAddr, gpu->instance, gpu->physicalDevice, missing, sizeof(missing)));
    assert_string_equal(missing, "");
}

static void APipelineCacheComesBackAndADamagedOneIsIgnored(void** state)
{
    size_t size = 0;
    assert_int_equal(swGpu_GetPipelineCache(*state, NULL, &size), SW_SUCCESS);
    assert_true(size >= 32);
    uint8_t* cache = malloc(size);
    assert_int_equal(swGpu_GetPipelineCache(*state, cache, &size), SW_SUCCESS);
    swHost host = swDefaultHost();
    for (int damage = 0; damage < 2; ++damage)
    {
        swGpuDef def = PlainDef();
        def.pipelineCache = cache;
        def.pipelineCacheSize = damage == 0 ? size : 20;
        memset(cache + 8, damage == 0 ? cache[8] : 0xee, damage == 0 ? 1 : 12);
        swGpu* gpu = NULL;
        assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_SUCCESS);
        swDestroyGpu(gpu);
    }
    free(cache);
}

// Create a device, a world on it with waves, a view and a query, and record a frame. True if all of it succeeded.
static bool RunEverything(const swHost* host, const swWorld* world)
{
    swGpuDef def = PlainDef();
    swGpu* gpu = NULL;
    if (swCreateGpu(host, &def, &gpu) != SW_SUCCESS)
    {
        return false;
    }
    swGpuWorld* gpuWorld = NULL;
    bool isGood = swCreateGpuWorld(gpu, world, &gpuWorld) == SW_SUCCESS;
    swGpuQueryDef queryDef = swDefaultGpuQueryDef();
    swGpuQuery* query = NULL;
    queryDef.outputs = SW_GPU_QUERY_VELOCITY;
    isGood = isGood && swCreateGpuQuery(gpuWorld, &queryDef, &query) == SW_SUCCESS;
    swGpuQuery* below = NULL;
    queryDef.kind = SW_GPU_QUERY_KIND_VOLUME;
    isGood = isGood && swCreateGpuQuery(gpuWorld, &queryDef, &below) == SW_SUCCESS;
    if (isGood)
    {
        swGpuQuery_SetPoints(query, 1, &(swPosXZ){0.0, 0.0});
        swGpuQuery_SetPlaces(below, 1, &(swPos){0.0, -1.0, 0.0});
    }
    VkCommandBuffer commands = VK_NULL_HANDLE;
    if (isGood && swBeginSubmit(gpu, &commands) == SW_SUCCESS)
    {
        isGood = swGpuWorld_Record(gpuWorld, commands, 0) == SW_SUCCESS;
        isGood = swEndSubmit(gpu) == SW_SUCCESS && isGood;
    }
    swDestroyGpuWorld(gpuWorld);
    swDestroyGpu(gpu);
    return isGood;
}

static void EveryAllocationMayFailOnce(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 32.0f;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    assert_int_equal(swWorld_Step(parity.world, 0.0), SW_SUCCESS);
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    assert_true(RunEverything(&host, parity.world));
    long long count = atomic_load(&memory.allocations);
    printf("  %lld allocations, each failed once\n", count);
    for (long long i = 0; i < count; ++i)
    {
        host = MakeCountingHost(&memory);
        atomic_store(&memory.failAt, i);
        RunEverything(&host, parity.world); // may succeed: a full list of retired buffers only costs a wait
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    FreeParity(&parity);
}

static void PassTimesHaveTheNamesOfThePasses(void** state)
{
    const char* const names[] = {
#define SW_PASS(NAME, name, text) #name,
#include "core/frame/passes.inl"
#undef SW_PASS
    };
    const int nameCount = sizeof(names) / sizeof(names[0]);
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    AddParityView(&parity, 2, 64, (swPos){0.0, 2.0, 0.0});
    swInputDef seabed = swDefaultInputDef();
    seabed.value[0] = -8.0f;
    swInputId id;
    assert_int_equal(swCreateInput(parity.world, &seabed, &id), SW_SUCCESS);
    swGpuQueryDef queryDef = swDefaultGpuQueryDef();
    swGpuQuery* query = NULL; // the passes are there with the first query
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &queryDef, &query), SW_SUCCESS);
    swGpuQuery_SetPoints(query, 1, &(swPosXZ){0.0, 0.0});
    queryDef.kind = SW_GPU_QUERY_KIND_VOLUME;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &queryDef, &query), SW_SUCCESS);
    swGpuQuery_SetPlaces(query, 1, &(swPos){0.0, -1.0, 0.0});
    queryDef.kind = SW_GPU_QUERY_KIND_RAYS;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &queryDef, &query), SW_SUCCESS);
    swRay ray = swDefaultRay((swPos){0.0, 10.0, 0.0}, (swVec3){1.0f, -1.0f, 0.0f});
    swGpuQuery_SetRays(query, 1, &ray);
    for (int i = 0; i < 4; ++i)
    {
        const float depth[4] = {-8.0f - (float)i}; // what does not change is not made again
        swInput_SetValue(parity.world, id, depth);
        StepParity(&parity, 0.1);
    }
    swPassTime times[16];
    int count = swGpu_GetPassTimes(*state, times, 16);
    assert_int_equal(count, nameCount);
    for (int i = 0; i < count; ++i)
    {
        assert_string_equal(times[i].name, names[i]);
        assert_true(times[i].milliseconds >= 0.0f && times[i].milliseconds < 1e5f);
    }
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AMissingDeviceIsNamed),
        cmocka_unit_test(HalfOfAHostsDeviceIsRefused),
        cmocka_unit_test(AHostsDeviceIsUsedAndLeftAlone),
        cmocka_unit_test(TheDeviceInUseLacksNothing),
        cmocka_unit_test(APipelineCacheComesBackAndADamagedOneIsIgnored),
        cmocka_unit_test(EveryAllocationMayFailOnce),
        cmocka_unit_test(PassTimesHaveTheNamesOfThePasses),
    };
    return cmocka_run_group_tests_name("devices", tests, OpenParityGpu, CloseParityGpu);
}
