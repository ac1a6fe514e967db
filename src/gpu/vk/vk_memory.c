// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_memory.h"

#include <string.h>

#include "gpu/vk/vk_device.h"

// Large enough that a default world fits in one or two, small enough not to matter on a laptop.
#define SW_BLOCK_BYTES (32u << 20)
// Memory that the host sees and the device owns can be scarce.
#define SW_HOST_BLOCK_BYTES (4u << 20)

static VkMemoryPropertyFlags requiredFlags(swMemoryUse use)
{
    return use == SW_MEMORY_DEVICE ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                   : VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
}

// What is worth a search before the required flags. Shaders read uploads in place, over and over: in device memory that
// costs a cache miss, across the bus a microsecond.
static VkMemoryPropertyFlags wantedFlags(swMemoryUse use)
{
    return requiredFlags(use) |
           (use == SW_MEMORY_READBACK ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
}

// Index of the next memory type to try, leaving out the bits of `tried`: one with the wanted flags, else the required
// ones, else (device memory only) any. -1 if there is none left.
static int findType(const swGpu* gpu, uint32_t allowed, uint32_t tried, swMemoryUse use)
{
    const VkMemoryPropertyFlags tries[] = {wantedFlags(use), requiredFlags(use), 0};
    int tryCount = use == SW_MEMORY_DEVICE ? 3 : 2;
    for (int t = 0; t < tryCount; ++t)
    {
        for (uint32_t i = 0; i < gpu->memory.properties.memoryTypeCount; ++i)
        {
            VkMemoryPropertyFlags flags = gpu->memory.properties.memoryTypes[i].propertyFlags;
            if ((allowed & ~tried & (1u << i)) != 0 && (flags & tries[t]) == tries[t])
            {
                return (int)i;
            }
        }
    }
    return -1;
}

static VkDeviceSize alignUp(VkDeviceSize value, VkDeviceSize alignment)
{
    return (value + alignment - 1) / alignment * alignment;
}

// Room for one more free range.
static bool growRanges(const swGpu* gpu, swMemoryBlock* block)
{
    if (block->freeCount < block->freeCapacity)
    {
        return true;
    }
    int capacity = block->freeCapacity > 0 ? 2 * block->freeCapacity : 16;
    swMemoryRange* ranges = swAllocate(&gpu->host, sizeof(swMemoryRange) * (size_t)capacity);
    if (ranges == NULL)
    {
        return false;
    }
    if (block->freeCount > 0)
    {
        memcpy(ranges, block->free, sizeof(swMemoryRange) * (size_t)block->freeCount);
    }
    swFree(&gpu->host, block->free, sizeof(swMemoryRange) * (size_t)block->freeCapacity);
    block->free = ranges;
    block->freeCapacity = capacity;
    return true;
}

static void removeRange(swMemoryBlock* block, int index)
{
    block->freeCount -= 1;
    memmove(&block->free[index], &block->free[index + 1], sizeof(swMemoryRange) * (size_t)(block->freeCount - index));
}

// Cut [offset, offset + size) out of the first range that holds it, aligned. False if none does.
static bool takeRange(const swGpu* gpu, swMemoryBlock* block, const VkMemoryRequirements* needs, VkDeviceSize* offset)
{
    for (int i = 0; i < block->freeCount; ++i)
    {
        swMemoryRange range = block->free[i];
        VkDeviceSize begin = alignUp(range.offset, needs->alignment);
        VkDeviceSize end = begin + needs->size;
        if (end > range.offset + range.size)
        {
            continue;
        }
        swMemoryRange before = {range.offset, begin - range.offset};
        swMemoryRange after = {end, range.offset + range.size - end};
        if (before.size > 0 && after.size > 0)
        {
            if (!growRanges(gpu, block))
            {
                return false;
            }
            memmove(&block->free[i + 1], &block->free[i], sizeof(swMemoryRange) * (size_t)(block->freeCount - i));
            block->freeCount += 1;
            block->free[i] = before;
            block->free[i + 1] = after;
        }
        else if (before.size > 0 || after.size > 0)
        {
            block->free[i] = before.size > 0 ? before : after;
        }
        else
        {
            removeRange(block, i);
        }
        *offset = begin;
        return true;
    }
    return false;
}

static void returnRange(const swGpu* gpu, swMemoryBlock* block, VkDeviceSize offset, VkDeviceSize size)
{
    int at = 0;
    while (at < block->freeCount && block->free[at].offset < offset)
    {
        at += 1;
    }
    bool joinsBefore = at > 0 && block->free[at - 1].offset + block->free[at - 1].size == offset;
    bool joinsAfter = at < block->freeCount && offset + size == block->free[at].offset;
    if (joinsBefore)
    {
        block->free[at - 1].size += size;
        if (joinsAfter)
        {
            block->free[at - 1].size += block->free[at].size;
            removeRange(block, at);
        }
    }
    else if (joinsAfter)
    {
        block->free[at].offset = offset;
        block->free[at].size += size;
    }
    else if (growRanges(gpu, block)) // without room for the entry the range stays unused until the block goes
    {
        memmove(&block->free[at + 1], &block->free[at], sizeof(swMemoryRange) * (size_t)(block->freeCount - at));
        block->freeCount += 1;
        block->free[at] = (swMemoryRange){offset, size};
    }
}

static void destroyBlock(swGpu* gpu, swMemoryBlock* block)
{
    gpu->vk.FreeMemory(gpu->device, block->memory, NULL); // unmaps
    swFree(&gpu->host, block->free, sizeof(swMemoryRange) * (size_t)block->freeCapacity);
    *block = (swMemoryBlock){0};
}

// Index of an unused block entry, or -1.
static int findEntry(swGpu* gpu)
{
    swMemory* memory = &gpu->memory;
    for (int i = 0; i < memory->blockCount; ++i)
    {
        if (memory->blocks[i].memory == VK_NULL_HANDLE)
        {
            return i;
        }
    }
    if (memory->blockCount == memory->blockCapacity)
    {
        int capacity = memory->blockCapacity > 0 ? 2 * memory->blockCapacity : 8;
        swMemoryBlock* blocks = swAllocateZero(&gpu->host, sizeof(swMemoryBlock) * (size_t)capacity);
        if (blocks == NULL)
        {
            return -1;
        }
        if (memory->blockCount > 0)
        {
            memcpy(blocks, memory->blocks, sizeof(swMemoryBlock) * (size_t)memory->blockCount);
        }
        swFree(&gpu->host, memory->blocks, sizeof(swMemoryBlock) * (size_t)memory->blockCapacity);
        memory->blocks = blocks;
        memory->blockCapacity = capacity;
    }
    return memory->blockCount++;
}

static VkResult createBlock(swGpu* gpu, uint32_t type, VkDeviceSize size, swMemoryUse use, bool forImages, int index)
{
    swMemoryBlock* block = &gpu->memory.blocks[index];
    *block = (swMemoryBlock){.size = size, .type = type, .forImages = forImages};
    if (!growRanges(gpu, block))
    {
        return VK_ERROR_OUT_OF_HOST_MEMORY;
    }
    const VkMemoryAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
        .allocationSize = size,
        .memoryTypeIndex = type,
    };
    VkResult result = gpu->vk.AllocateMemory(gpu->device, &info, NULL, &block->memory);
    if (result == VK_SUCCESS && use != SW_MEMORY_DEVICE)
    {
        void* mapped = NULL;
        result = gpu->vk.MapMemory(gpu->device, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
        block->mapped = mapped;
    }
    if (result != VK_SUCCESS)
    {
        destroyBlock(gpu, block);
        return result;
    }
    block->freeCount = 1;
    block->free[0] = (swMemoryRange){0, size};
    return VK_SUCCESS;
}

static void fillAllocation(swGpu* gpu, int index, VkDeviceSize offset, VkDeviceSize size, swAllocation* allocation)
{
    const swMemoryBlock* block = &gpu->memory.blocks[index];
    *allocation = (swAllocation){
        .memory = block->memory,
        .offset = offset,
        .size = size,
        .mapped = block->mapped ? block->mapped + offset : NULL,
        .block = index,
    };
    gpu->memory.usedBytes += (size_t)size;
}

// From a block of that type that has room, else from a new block.
static VkResult allocateOfType(swGpu* gpu, uint32_t type, const VkMemoryRequirements* needs, swMemoryUse use,
                               bool forImage, swAllocation* allocation)
{
    VkDeviceSize offset = 0;
    for (int i = 0; i < gpu->memory.blockCount; ++i)
    {
        swMemoryBlock* block = &gpu->memory.blocks[i];
        bool isMapped = block->mapped != NULL;
        if (block->memory != VK_NULL_HANDLE && block->type == type && block->forImages == forImage &&
            isMapped == (use != SW_MEMORY_DEVICE) && takeRange(gpu, block, needs, &offset))
        {
            fillAllocation(gpu, i, offset, needs->size, allocation);
            return VK_SUCCESS;
        }
    }
    int index = findEntry(gpu);
    if (index < 0)
    {
        return VK_ERROR_OUT_OF_HOST_MEMORY;
    }
    VkDeviceSize usual = use == SW_MEMORY_DEVICE ? SW_BLOCK_BYTES : SW_HOST_BLOCK_BYTES;
    VkDeviceSize size = needs->size > usual ? needs->size : usual;
    VkResult result = createBlock(gpu, type, size, use, forImage, index);
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY && size > needs->size)
    {
        result = createBlock(gpu, type, needs->size, use, forImage, index);
    }
    if (result == VK_SUCCESS && takeRange(gpu, &gpu->memory.blocks[index], needs, &offset))
    {
        fillAllocation(gpu, index, offset, needs->size, allocation);
        return VK_SUCCESS;
    }
    return result == VK_SUCCESS ? VK_ERROR_OUT_OF_HOST_MEMORY : result;
}

swResult swAllocateDeviceMemory(swGpu* gpu, const VkMemoryRequirements* needs, swMemoryUse use, bool forImage,
                                const char* name, swAllocation* allocation)
{
    *allocation = (swAllocation){0};
    VkResult result = VK_ERROR_FEATURE_NOT_PRESENT;
    uint32_t tried = 0;
    int type = findType(gpu, needs->memoryTypeBits, tried, use);
    while (type >= 0 && result != VK_SUCCESS)
    {
        result = allocateOfType(gpu, (uint32_t)type, needs, use, forImage, allocation);
        tried |= 1u << type;
        type = findType(gpu, needs->memoryTypeBits, tried, use);
    }
    if (result == VK_SUCCESS)
    {
        return SW_SUCCESS;
    }
    return swFail(&gpu->host, result == VK_ERROR_DEVICE_LOST ? SW_ERROR_DEVICE_LOST : SW_ERROR_NO_MEMORY,
                  "no device memory for %s (%llu KiB, %llu KiB are in use): %s", name,
                  (unsigned long long)(needs->size >> 10), (unsigned long long)(gpu->memory.usedBytes >> 10),
                  swVkResultName(result));
}

void swFreeDeviceMemory(swGpu* gpu, swAllocation* allocation)
{
    if (allocation->memory == VK_NULL_HANDLE)
    {
        return;
    }
    swMemoryBlock* block = &gpu->memory.blocks[allocation->block];
    returnRange(gpu, block, allocation->offset, allocation->size);
    gpu->memory.usedBytes -= (size_t)allocation->size;
    if (block->freeCount == 1 && block->free[0].size == block->size)
    {
        destroyBlock(gpu, block);
    }
    *allocation = (swAllocation){0};
}

void swDestroyDeviceMemory(swGpu* gpu)
{
    swMemory* memory = &gpu->memory;
    for (int i = 0; i < memory->blockCount; ++i)
    {
        destroyBlock(gpu, &memory->blocks[i]);
    }
    swFree(&gpu->host, memory->blocks, sizeof(swMemoryBlock) * (size_t)memory->blockCapacity);
    memory->blocks = NULL;
    memory->blockCount = memory->blockCapacity = 0;
}
