// SPDX-License-Identifier: MIT
#include "gpu_answers.h"

#include <stdlib.h>

#include "common.h"
#include "vulkan_calls.h"

struct GpuAnswers
{
    swGpu* gpu;
    swGpuWorld* world;
    swGpuQuery* query;
    VulkanCalls calls;
    VkDevice device;
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkFence fence;
    uint64_t frameIndex;
};

static bool Succeed(VkResult result, const char* what)
{
    if (result != VK_SUCCESS)
    {
        Complain("%s (Vulkan error %d)", what, (int)result);
    }
    return result == VK_SUCCESS;
}

static swResult CreateSea(GpuAnswers* answers, const DeviceName* device, const swWorld* world, const swGpuQueryDef* def)
{
    swHost host = MakeHost();
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.choice = device->choice;
    gpuDef.deviceIndex = device->index;
    swResult result = swCreateGpu(&host, &gpuDef, &answers->gpu);
    result = result == SW_SUCCESS ? swCreateGpuWorld(answers->gpu, world, &answers->world) : result;
    return result == SW_SUCCESS ? swCreateGpuQuery(answers->world, def, &answers->query) : result;
}

static bool CreateCommands(GpuAnswers* answers)
{
    answers->device = swGpu_GetDevice(answers->gpu);
    VulkanCalls* calls = &answers->calls;
    if (!LoadInstanceCalls(calls, swGpu_GetInstance(answers->gpu)) || !LoadDeviceCalls(calls, answers->device))
    {
        return false;
    }
    const VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                              .queueFamilyIndex = swGpu_GetQueueFamily(answers->gpu)};
    const VkFenceCreateInfo fenceInfo = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    if (!Succeed(calls->CreateCommandPool(answers->device, &poolInfo, NULL, &answers->pool), "no command pool") ||
        !Succeed(calls->CreateFence(answers->device, &fenceInfo, NULL, &answers->fence), "no fence"))
    {
        return false;
    }
    const VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .commandPool = answers->pool,
                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                              .commandBufferCount = 1};
    return Succeed(calls->AllocateCommandBuffers(answers->device, &info, &answers->commands), "no command buffer");
}

GpuAnswers* OpenGpuAnswers(const DeviceName* device, const swWorld* world, const swGpuQueryDef* def)
{
    GpuAnswers* answers = calloc(1, sizeof(GpuAnswers));
    if (answers == NULL)
    {
        Complain("no memory for a query");
        return NULL;
    }
    swResult result = CreateSea(answers, device, world, def);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the GPU cannot be asked; without --backend gpu the CPU answers");
    }
    if (result != SW_SUCCESS || !CreateCommands(answers))
    {
        CloseGpuAnswers(answers);
        return NULL;
    }
    return answers;
}

void CloseGpuAnswers(GpuAnswers* answers)
{
    if (answers == NULL)
    {
        return;
    }
    if (answers->pool != VK_NULL_HANDLE)
    {
        answers->calls.DeviceWaitIdle(answers->device);
        answers->calls.DestroyFence(answers->device, answers->fence, NULL);
        answers->calls.DestroyCommandPool(answers->device, answers->pool, NULL);
    }
    swDestroyGpuQuery(answers->query);
    swDestroyGpuWorld(answers->world);
    swDestroyGpu(answers->gpu);
    free(answers);
}

static bool RunFrame(GpuAnswers* answers)
{
    VulkanCalls* calls = &answers->calls;
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    if (!Succeed(calls->ResetCommandPool(answers->device, answers->pool, 0), "the commands could not be reset") ||
        !Succeed(calls->BeginCommandBuffer(answers->commands, &begin), "the commands could not be begun"))
    {
        return false;
    }
    swResult result = swGpuWorld_Record(answers->world, answers->commands, answers->frameIndex);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the passes could not be recorded");
        return false;
    }
    const VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &answers->commands};
    return Succeed(calls->EndCommandBuffer(answers->commands), "the commands could not be ended") &&
           Succeed(calls->QueueSubmit(swGpu_GetQueue(answers->gpu), 1, &submit, answers->fence),
                   "the device took no commands") &&
           Succeed(calls->WaitForFences(answers->device, 1, &answers->fence, VK_TRUE, UINT64_MAX),
                   "the device did not finish the query") &&
           Succeed(calls->ResetFences(answers->device, 1, &answers->fence), "the fence could not be reset");
}

static bool FetchResults(GpuAnswers* answers, swGpuQueryResults* results)
{
    if (!RunFrame(answers))
    {
        return false;
    }
    swGpu_SetFinishedFrame(answers->gpu, answers->frameIndex++);
    bool isThere = swGpuQuery_GetResults(answers->query, results);
    if (!isThere)
    {
        Complain("the device gave no answers");
    }
    return isThere;
}

bool AskGpu(GpuAnswers* answers, int count, const swPosXZ* points, const swSurfaceSamples* samples)
{
    swGpuQuery_SetPoints(answers->query, count, points);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_Unpack(&results, samples, NULL);
    }
    return isThere;
}

bool AskGpuBelow(GpuAnswers* answers, int count, const swPos* places, const swVolumeSamples* samples)
{
    swGpuQuery_SetPlaces(answers->query, count, places);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_UnpackVolume(&results, samples, NULL);
    }
    return isThere;
}

bool AskGpuRays(GpuAnswers* answers, int count, const swRay* rays, swRayHit* hits)
{
    swGpuQuery_SetRays(answers->query, count, rays);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_UnpackHits(&results, rays, hits, NULL);
    }
    return isThere;
}
