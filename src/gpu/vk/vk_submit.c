// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_submit.h"

#include "gpu/vk/vk_device.h"

static swResult createSubmit(swGpu* gpu)
{
    const VkCommandPoolCreateInfo poolInfo = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
        .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
        .queueFamilyIndex = gpu->queueFamily,
    };
    VkResult result = gpu->vk.CreateCommandPool(gpu->device, &poolInfo, NULL, &gpu->submitPool);
    if (result == VK_SUCCESS)
    {
        const VkCommandBufferAllocateInfo info = {
            .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
            .commandPool = gpu->submitPool,
            .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
            .commandBufferCount = 1,
        };
        result = gpu->vk.AllocateCommandBuffers(gpu->device, &info, &gpu->submitCommands);
    }
    if (result == VK_SUCCESS)
    {
        const VkFenceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
        result = gpu->vk.CreateFence(gpu->device, &info, NULL, &gpu->submitFence);
    }
    if (result != VK_SUCCESS)
    {
        swDestroySubmit(gpu);
    }
    return swCheckVk(gpu, result, "creating a command buffer");
}

swResult swBeginSubmit(swGpu* gpu, VkCommandBuffer* commands)
{
    if (gpu->submitPool == VK_NULL_HANDLE)
    {
        swResult result = createSubmit(gpu);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    VkResult result = gpu->vk.ResetCommandPool(gpu->device, gpu->submitPool, 0);
    if (result == VK_SUCCESS)
    {
        const VkCommandBufferBeginInfo info = {
            .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT,
        };
        result = gpu->vk.BeginCommandBuffer(gpu->submitCommands, &info);
    }
    *commands = gpu->submitCommands;
    return swCheckVk(gpu, result, "beginning a command buffer");
}

swResult swEndSubmit(swGpu* gpu)
{
    VkResult result = gpu->vk.EndCommandBuffer(gpu->submitCommands);
    if (result == VK_SUCCESS)
    {
        const VkCommandBufferSubmitInfo commands = {
            .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
            .commandBuffer = gpu->submitCommands,
        };
        const VkSubmitInfo2 submit = {
            .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
            .commandBufferInfoCount = 1,
            .pCommandBufferInfos = &commands,
        };
        result = gpu->vk.QueueSubmit2(gpu->queue, 1, &submit, gpu->submitFence);
    }
    if (result == VK_SUCCESS)
    {
        result = gpu->vk.WaitForFences(gpu->device, 1, &gpu->submitFence, VK_TRUE, UINT64_MAX);
    }
    if (result == VK_SUCCESS)
    {
        result = gpu->vk.ResetFences(gpu->device, 1, &gpu->submitFence);
    }
    return swCheckVk(gpu, result, "submitting commands");
}

void swDestroySubmit(swGpu* gpu)
{
    gpu->vk.DestroyFence(gpu->device, gpu->submitFence, NULL);
    gpu->vk.DestroyCommandPool(gpu->device, gpu->submitPool, NULL);
    gpu->submitFence = VK_NULL_HANDLE;
    gpu->submitPool = VK_NULL_HANDLE;
}
