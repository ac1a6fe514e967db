// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/vk/vk_memory.h"

typedef struct swBuffer
{
    VkBuffer handle; // null if there is none
    VkDeviceSize size;
    void* mapped; // NULL for SW_MEMORY_DEVICE
    swAllocation memory;
} swBuffer;

// A transfer destination and source always; `usage` adds to that. `name` appears in errors and in debuggers.
swResult swCreateBuffer(swGpu* gpu, VkDeviceSize size, VkBufferUsageFlags usage, swMemoryUse use, const char* name,
                        swBuffer* buffer);
// At once; the GPU must be done with it. Clears the buffer; null is allowed.
void swDestroyBuffer(swGpu* gpu, swBuffer* buffer);
// Once no frame in flight can use it any more. Clears the buffer; null is allowed.
void swRetireBuffer(swGpu* gpu, swBuffer* buffer);
// Keep the buffer if it has `size` bytes, else retire it and make one of at least `size` (contents are lost).
swResult swGrowBuffer(swGpu* gpu, VkDeviceSize size, VkBufferUsageFlags usage, swMemoryUse use, const char* name,
                      swBuffer* buffer);
