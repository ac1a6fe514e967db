// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_sets.h"

#include "core/base/assert.h"
#include "gpu/vk/vk_device.h"

static swResult createPool(swGpu* gpu, VkDescriptorPool* pool)
{
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, SW_SETS_OF_POOL},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, SW_SETS_OF_POOL * SW_MAX_BINDINGS},
    };
    const VkDescriptorPoolCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
        .maxSets = SW_SETS_OF_POOL,
        .poolSizeCount = 2,
        .pPoolSizes = sizes,
    };
    return swCheckVk(gpu, gpu->vk.CreateDescriptorPool(gpu->device, &info, NULL, pool), "creating a descriptor pool");
}

swResult swAllocateSet(swGpu* gpu, VkDescriptorSetLayout layout, VkDescriptorSet* set)
{
    *set = VK_NULL_HANDLE;
    swSetRing* ring = &gpu->sets[gpu->frameSlot];
    int index = ring->used / SW_SETS_OF_POOL;
    if (index >= SW_MAX_SET_POOLS)
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "more than %d descriptor sets of layers in one frame",
                      SW_SETS_OF_POOL * SW_MAX_SET_POOLS);
    }
    VkDescriptorPool* pool = &ring->pools[index];
    swResult result = *pool == VK_NULL_HANDLE ? createPool(gpu, pool) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const VkDescriptorSetAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
        .descriptorPool = *pool,
        .descriptorSetCount = 1,
        .pSetLayouts = &layout,
    };
    result = swCheckVk(gpu, gpu->vk.AllocateDescriptorSets(gpu->device, &info, set), "allocating a descriptor set");
    ring->used += result == SW_SUCCESS ? 1 : 0;
    return result;
}

void swResetSets(swGpu* gpu, int slot)
{
    swSetRing* ring = &gpu->sets[slot];
    for (int i = 0; i * SW_SETS_OF_POOL < ring->used; ++i)
    {
        gpu->vk.ResetDescriptorPool(gpu->device, ring->pools[i], 0); // cannot fail
    }
    ring->used = 0;
}

void swDestroySets(swGpu* gpu)
{
    for (int slot = 0; slot < SW_MAX_FRAMES_IN_FLIGHT; ++slot)
    {
        for (int i = 0; i < SW_MAX_SET_POOLS; ++i)
        {
            gpu->vk.DestroyDescriptorPool(gpu->device, gpu->sets[slot].pools[i], NULL);
        }
    }
}

void swWriteSet(swGpu* gpu, VkDescriptorSet set, uint32_t count, const VkDescriptorType* types,
                const swBinding* bindings)
{
    VkWriteDescriptorSet writes[SW_MAX_BINDINGS];
    VkDescriptorBufferInfo buffers[SW_MAX_BINDINGS];
    VkDescriptorImageInfo images[SW_MAX_BINDINGS];
    SW_ASSERT(count <= SW_MAX_BINDINGS);
    for (uint32_t i = 0; i < count; ++i)
    {
        const swBinding* binding = &bindings[i];
        bool isImage = types[i] == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        buffers[i] = (VkDescriptorBufferInfo){binding->buffer, binding->offset, binding->range};
        images[i] = (VkDescriptorImageInfo){binding->sampler, binding->view, binding->layout};
        writes[i] = (VkWriteDescriptorSet){
            .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
            .dstSet = set,
            .dstBinding = i,
            .descriptorCount = 1,
            .descriptorType = types[i],
            .pImageInfo = isImage ? &images[i] : NULL,
            .pBufferInfo = isImage ? NULL : &buffers[i],
        };
    }
    gpu->vk.UpdateDescriptorSets(gpu->device, count, writes, 0, NULL);
}
