// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_buffer.h"

#include "gpu/vk/vk_device.h"

swResult swCreateBuffer(swGpu* gpu, VkDeviceSize size, VkBufferUsageFlags usage, swMemoryUse use, const char* name,
                        swBuffer* buffer)
{
    *buffer = (swBuffer){.size = size};
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
        .size = size,
        .usage = usage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
    };
    VkResult created = gpu->vk.CreateBuffer(gpu->device, &info, NULL, &buffer->handle);
    if (created != VK_SUCCESS)
    {
        *buffer = (swBuffer){0};
        return swCheckVk(gpu, created, name);
    }
    VkMemoryRequirements needs;
    gpu->vk.GetBufferMemoryRequirements(gpu->device, buffer->handle, &needs);
    swResult result = swAllocateDeviceMemory(gpu, &needs, use, false, name, &buffer->memory);
    if (result == SW_SUCCESS)
    {
        VkResult bound =
            gpu->vk.BindBufferMemory(gpu->device, buffer->handle, buffer->memory.memory, buffer->memory.offset);
        result = swCheckVk(gpu, bound, name);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyBuffer(gpu, buffer);
        return result;
    }
    buffer->mapped = buffer->memory.mapped;
    swNameObject(gpu, VK_OBJECT_TYPE_BUFFER, (uint64_t)buffer->handle, name);
    return SW_SUCCESS;
}

void swDestroyBuffer(swGpu* gpu, swBuffer* buffer)
{
    gpu->vk.DestroyBuffer(gpu->device, buffer->handle, NULL);
    swFreeDeviceMemory(gpu, &buffer->memory);
    *buffer = (swBuffer){0};
}

void swRetireBuffer(swGpu* gpu, swBuffer* buffer)
{
    if (buffer->handle != VK_NULL_HANDLE)
    {
        swRetire(gpu, &(swRetired){.buffer = buffer->handle, .memory = buffer->memory});
    }
    *buffer = (swBuffer){0};
}

swResult swGrowBuffer(swGpu* gpu, VkDeviceSize size, VkBufferUsageFlags usage, swMemoryUse use, const char* name,
                      swBuffer* buffer)
{
    if (buffer->handle != VK_NULL_HANDLE && buffer->size >= size)
    {
        return SW_SUCCESS;
    }
    // What this frame has put into the old buffer is not recorded yet: it must outlive this call.
    swResult result = buffer->handle != VK_NULL_HANDLE ? swMakeRoomToRetire(gpu) : SW_SUCCESS;
    swBuffer grown;
    result = result == SW_SUCCESS ? swCreateBuffer(gpu, size, usage, use, name, &grown) : result;
    if (result == SW_SUCCESS)
    {
        swRetireBuffer(gpu, buffer);
        *buffer = grown;
    }
    return result;
}
