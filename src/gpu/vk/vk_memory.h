// SPDX-License-Identifier: MIT
#pragma once

// Device memory: a few large blocks, cut first-fit. Buffers and images live in separate blocks, so the distance that
// some devices want between them never matters.

#include "seaway/gpu.h"

typedef enum swMemoryUse
{
    SW_MEMORY_DEVICE,   // GPU only
    SW_MEMORY_UPLOAD,   // written by the host (never read), read by the GPU in place; mapped and coherent
    SW_MEMORY_READBACK, // written by the GPU, read by the host; mapped and coherent, cached where there is such
    SW_MEMORY_USE_COUNT
} swMemoryUse;

// A part of a block. memory is null if nothing is held.
typedef struct swAllocation
{
    VkDeviceMemory memory;
    VkDeviceSize offset, size;
    void* mapped; // of this part, NULL for SW_MEMORY_DEVICE
    int block;    // index in swMemory::blocks
} swAllocation;

typedef struct swMemoryRange
{
    VkDeviceSize offset, size;
} swMemoryRange;

typedef struct swMemoryBlock
{
    VkDeviceMemory memory; // null: an unused entry
    VkDeviceSize size;
    uint8_t* mapped;
    uint32_t type;
    bool forImages;
    int freeCount, freeCapacity;
    swMemoryRange* free; // ascending, never touching
} swMemoryBlock;

typedef struct swMemory
{
    VkPhysicalDeviceMemoryProperties properties;
    int blockCount, blockCapacity;
    swMemoryBlock* blocks;
    size_t usedBytes; // handed out
} swMemory;

// @return SW_ERROR_NO_MEMORY (with a sentence in the log that names `name`) or SW_ERROR_DEVICE
swResult swAllocateDeviceMemory(swGpu* gpu, const VkMemoryRequirements* needs, swMemoryUse use, bool forImage,
                                const char* name, swAllocation* allocation);
// Clears the allocation; null is allowed.
void swFreeDeviceMemory(swGpu* gpu, swAllocation* allocation);
void swDestroyDeviceMemory(swGpu* gpu);
