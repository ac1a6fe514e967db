// SPDX-License-Identifier: MIT
// Many points a frame on the GPU: drifting markers ask where the water is and read, without waiting, what a frame some
// frames ago has answered. The stamp says which; the core, set to that time, says the same.
#include <seaway/gpu.h>
#include <seaway/seaway.h>

#include <vulkan/vulkan.h>

#include <math.h>
#include <stdio.h>

#define MARKERS 2000
#define FRAME_COUNT 6
#define FRAMES_IN_FLIGHT 2

typedef struct Frames
{
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer commands[FRAMES_IN_FLIGHT];
    VkFence fences[FRAMES_IN_FLIGHT];
} Frames;

static bool CreateFrames(Frames* frames, const swGpu* gpu)
{
    frames->device = swGpu_GetDevice(gpu);
    frames->queue = swGpu_GetQueue(gpu);
    VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                        .queueFamilyIndex = swGpu_GetQueueFamily(gpu)};
    if (vkCreateCommandPool(frames->device, &poolInfo, NULL, &frames->pool) != VK_SUCCESS)
    {
        return false;
    }
    for (int i = 0; i < FRAMES_IN_FLIGHT; ++i)
    {
        VkFenceCreateInfo fenceInfo = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO,
                                       .flags = VK_FENCE_CREATE_SIGNALED_BIT};
        if (vkCreateFence(frames->device, &fenceInfo, NULL, &frames->fences[i]) != VK_SUCCESS)
        {
            return false;
        }
    }
    VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                        .commandPool = frames->pool,
                                        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                        .commandBufferCount = FRAMES_IN_FLIGHT};
    return vkAllocateCommandBuffers(frames->device, &info, frames->commands) == VK_SUCCESS;
}

static void DestroyFrames(Frames* frames)
{
    if (frames->device)
    {
        vkDeviceWaitIdle(frames->device);
        for (int i = 0; i < FRAMES_IN_FLIGHT; ++i)
        {
            vkDestroyFence(frames->device, frames->fences[i], NULL);
        }
        vkDestroyCommandPool(frames->device, frames->pool, NULL);
    }
}

// A frame waits for the one that had its command buffer before, as swGpuDef::framesInFlight wants it, and for nothing
// else.
static bool RunFrame(Frames* frames, swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    uint64_t slot = frameIndex % FRAMES_IN_FLIGHT;
    VkCommandBuffer commands = frames->commands[slot];
    VkCommandBufferBeginInfo beginInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                          .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    VkSubmitInfo submitInfo = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    return vkWaitForFences(frames->device, 1, &frames->fences[slot], VK_TRUE, UINT64_MAX) == VK_SUCCESS &&
           vkResetFences(frames->device, 1, &frames->fences[slot]) == VK_SUCCESS &&
           vkBeginCommandBuffer(commands, &beginInfo) == VK_SUCCESS &&
           swGpuWorld_Record(gpuWorld, commands, frameIndex) == SW_SUCCESS &&
           vkEndCommandBuffer(commands) == VK_SUCCESS &&
           vkQueueSubmit(frames->queue, 1, &submitInfo, frames->fences[slot]) == VK_SUCCESS;
}

// Markers drift east at 1 m/s, 1,000 km from the origin.
static void PlaceMarkers(swPosXZ* markers, double time)
{
    for (int i = 0; i < MARKERS; ++i)
    {
        markers[i] = (swPosXZ){1.0e6 + 7.0 * (i % 50) + time, -1.0e6 + 7.0 * (i / 50)};
    }
}

// The stamp's time, asked of the core. Returns the largest difference of a height.
static double CompareWithCore(swWorld* world, const swGpuQueryResults* results)
{
    swPosXZ markers[MARKERS];
    float gpu[MARKERS], core[MARKERS];
    PlaceMarkers(markers, results->time);
    double now = swWorld_GetTime(world);
    swWorld_SetTime(world, results->time);
    if (swWorld_Step(world, 0.0) != SW_SUCCESS)
    {
        return 1.0;
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = core};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, results->count, markers, &samples, NULL);
    samples.height = gpu;
    swGpuQueryResults_Unpack(results, &samples, NULL);
    double worst = 0.0;
    for (int i = 0; i < results->count; ++i)
    {
        worst = fmax(worst, fabs((double)gpu[i] - (double)core[i]));
    }
    swWorld_SetTime(world, now);
    return worst;
}

// [query]
// Each frame asks and takes what has arrived; the first frames find nothing yet.
static bool RunMarkers(Frames* frames, swWorld* world, swGpuWorld* gpuWorld, swGpuQuery* query)
{
    swPosXZ markers[MARKERS];
    for (uint64_t frameIndex = 0; frameIndex < FRAME_COUNT; ++frameIndex)
    {
        if (swWorld_Step(world, 1.0 / 60.0) != SW_SUCCESS)
        {
            return false;
        }
        PlaceMarkers(markers, swWorld_GetTime(world));
        swGpuQuery_SetPoints(query, MARKERS, markers);
        if (!RunFrame(frames, gpuWorld, frameIndex))
        {
            return false;
        }
        swGpuQueryResults results;
        if (swGpuQuery_GetResults(query, &results))
        {
            printf("frame %d has answers of frame %d, at %.3f s: the first marker is at %6.3f m\n", (int)frameIndex,
                   (int)results.frameIndex, results.time, results.seaLevel + (double)results.heights[0].height);
        }
    }
    return true;
}
// [/query]

static bool RunSea(Frames* frames, swWorld* world, swGpu* gpu)
{
    swGpuWorld* gpuWorld = NULL;
    swGpuQuery* query = NULL;
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = MARKERS;
    bool isGood = CreateFrames(frames, gpu) && swCreateGpuWorld(gpu, world, &gpuWorld) == SW_SUCCESS &&
                  swCreateGpuQuery(gpuWorld, &def, &query) == SW_SUCCESS && RunMarkers(frames, world, gpuWorld, query);
    swGpuQueryResults results;
    if (isGood && swGpuQuery_GetResults(query, &results))
    {
        double worst = CompareWithCore(world, &results);
        printf("largest difference from the core: %.2g m\n", worst);
        isGood = worst < 2e-3; // residuals of half a millimetre on either side, on a steep slope
    }
    DestroyFrames(frames);
    swDestroyGpuQuery(query);
    swDestroyGpuWorld(gpuWorld);
    return isGood;
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.framesInFlight = FRAMES_IN_FLIGHT;
    swWorld* world = NULL;
    swWaveSystemId sea;
    swGpu* gpu = NULL;
    Frames frames = {0};
    bool isGood = swCreateWorld(&host, &worldDef, &world) == SW_SUCCESS &&
                  swCreateWaveSystem(world, &waves, &sea) == SW_SUCCESS &&
                  swCreateGpu(&host, &gpuDef, &gpu) == SW_SUCCESS && RunSea(&frames, world, gpu);
    swDestroyGpu(gpu);
    swDestroyWorld(world);
    return isGood ? 0 : 1; // the host's log has said why
}
