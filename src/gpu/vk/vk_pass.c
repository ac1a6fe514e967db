// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_pass.h"

#include <string.h>

#include "gpu/vk/vk_device.h"

swResult swCreatePassTimer(swGpu* gpu)
{
    swPassTimer* timer = &gpu->timer;
    timer->openPass = -1;
    timer->isEnabled = true;
    VkQueueFamilyProperties families[32];
    uint32_t count = 32;
    gpu->vk.GetPhysicalDeviceQueueFamilyProperties(gpu->physicalDevice, &count, families);
    if (gpu->queueFamily >= count || families[gpu->queueFamily].timestampValidBits == 0)
    {
        return SW_SUCCESS;
    }
    for (int i = 0; i < gpu->framesInFlight; ++i)
    {
        const VkQueryPoolCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
            .queryType = VK_QUERY_TYPE_TIMESTAMP,
            .queryCount = 2 * SW_MAX_TIMED_PASSES,
        };
        VkResult result = gpu->vk.CreateQueryPool(gpu->device, &info, NULL, &timer->pools[i]);
        if (result != VK_SUCCESS)
        {
            return swCheckVk(gpu, result, "creating a query pool");
        }
    }
    return SW_SUCCESS;
}

void swDestroyPassTimer(swGpu* gpu)
{
    for (int i = 0; i < SW_MAX_FRAMES_IN_FLIGHT; ++i)
    {
        gpu->vk.DestroyQueryPool(gpu->device, gpu->timer.pools[i], NULL);
    }
}

// Take a slot's timestamps if they have all arrived; else the results of an earlier frame stay.
static void collectTimes(swGpu* gpu, int slot)
{
    swPassTimer* timer = &gpu->timer;
    int count = timer->counts[slot];
    if (count == 0)
    {
        return;
    }
    uint64_t times[2 * SW_MAX_TIMED_PASSES];
    VkResult result = gpu->vk.GetQueryPoolResults(gpu->device, timer->pools[slot], 0, 2 * (uint32_t)count,
                                                  sizeof(times), times, sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
    if (result != VK_SUCCESS)
    {
        return;
    }
    double period = (double)gpu->properties.limits.timestampPeriod * 1e-6;
    for (int i = 0; i < count; ++i)
    {
        double ticks = (double)(times[2 * i + 1] - times[2 * i]);
        timer->results[i] = (swPassTime){.name = timer->names[slot][i], .milliseconds = (float)(ticks * period)};
    }
    timer->resultCount = count;
}

void swBeginGpuFrame(swGpu* gpu, uint64_t frameIndex)
{
    if (gpu->hasFrame && gpu->frameIndex == frameIndex)
    {
        return;
    }
    gpu->hasFrame = true;
    gpu->frameIndex = frameIndex;
    gpu->frameSlot = (int)(frameIndex % (uint64_t)gpu->framesInFlight);
    collectTimes(gpu, gpu->frameSlot);
    swResetUpload(gpu, gpu->frameSlot);
    swResetSets(gpu, gpu->frameSlot);
    swDestroyRetired(gpu, frameIndex);
    gpu->timer.counts[gpu->frameSlot] = 0;
    gpu->timer.isStarted = false;
}

void swStartPassTimer(swGpu* gpu, VkCommandBuffer commands)
{
    VkQueryPool pool = gpu->timer.pools[gpu->frameSlot];
    if (pool != VK_NULL_HANDLE && !gpu->timer.isStarted)
    {
        gpu->vk.CmdResetQueryPool(commands, pool, 0, 2 * SW_MAX_TIMED_PASSES);
    }
    gpu->timer.isStarted = true;
}

void swDiscardGpuFrame(swGpu* gpu)
{
    gpu->timer.isStarted = false;
    memset(gpu->timer.counts, 0, sizeof(gpu->timer.counts));
}

void swBeginPass(swGpu* gpu, VkCommandBuffer commands, const char* name)
{
    if (gpu->vk.CmdBeginDebugUtilsLabelEXT != NULL)
    {
        const VkDebugUtilsLabelEXT label = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = name};
        gpu->vk.CmdBeginDebugUtilsLabelEXT(commands, &label);
    }
    swPassTimer* timer = &gpu->timer;
    int slot = gpu->frameSlot;
    timer->openPass = -1;
    if (timer->isEnabled && timer->pools[slot] != VK_NULL_HANDLE && timer->counts[slot] < SW_MAX_TIMED_PASSES)
    {
        timer->openPass = timer->counts[slot]++;
        timer->names[slot][timer->openPass] = name;
        gpu->vk.CmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timer->pools[slot],
                                   2 * (uint32_t)timer->openPass);
    }
}

void swEndPass(swGpu* gpu, VkCommandBuffer commands)
{
    swPassTimer* timer = &gpu->timer;
    if (timer->openPass >= 0)
    {
        gpu->vk.CmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timer->pools[gpu->frameSlot],
                                   2 * (uint32_t)timer->openPass + 1);
        timer->openPass = -1;
    }
    if (gpu->vk.CmdEndDebugUtilsLabelEXT != NULL)
    {
        gpu->vk.CmdEndDebugUtilsLabelEXT(commands);
    }
}

void swBarrier(swGpu* gpu, VkCommandBuffer commands, VkPipelineStageFlags2 fromStages, VkAccessFlags2 fromAccess,
               VkPipelineStageFlags2 toStages, VkAccessFlags2 toAccess)
{
    const VkMemoryBarrier2 barrier = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = fromStages,
        .srcAccessMask = fromAccess,
        .dstStageMask = toStages,
        .dstAccessMask = toAccess,
    };
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
        .memoryBarrierCount = 1,
        .pMemoryBarriers = &barrier,
    };
    gpu->vk.CmdPipelineBarrier2(commands, &info);
}

void swComputeBarrier(swGpu* gpu, VkCommandBuffer commands)
{
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                  VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

void swImageBarrier(swGpu* gpu, VkCommandBuffer commands, const swImage* image, VkImageLayout from, VkImageLayout to,
                    VkPipelineStageFlags2 fromStages, VkAccessFlags2 fromAccess, VkPipelineStageFlags2 toStages,
                    VkAccessFlags2 toAccess)
{
    bool isDepth = image->format == VK_FORMAT_D16_UNORM || image->format == VK_FORMAT_D32_SFLOAT ||
                   image->format == VK_FORMAT_X8_D24_UNORM_PACK32;
    const VkImageMemoryBarrier2 barrier = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = fromStages,
        .srcAccessMask = fromAccess,
        .dstStageMask = toStages,
        .dstAccessMask = toAccess,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image->handle,
        .subresourceRange = {.aspectMask = isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT,
                             .levelCount = VK_REMAINING_MIP_LEVELS,
                             .layerCount = VK_REMAINING_ARRAY_LAYERS},
    };
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
        .imageMemoryBarrierCount = 1,
        .pImageMemoryBarriers = &barrier,
    };
    gpu->vk.CmdPipelineBarrier2(commands, &info);
}
