// SPDX-License-Identifier: MIT
#pragma once

// Descriptor sets that live for one frame, for shaders of the host: our own pipelines push theirs. Each frame slot has
// pools of its own, which are emptied when the slot's next frame begins.

#include "gpu/vk/vk_pipeline.h"

#define SW_SETS_OF_POOL 32
#define SW_MAX_SET_POOLS 8

typedef struct swSetRing
{
    VkDescriptorPool pools[SW_MAX_SET_POOLS]; // made as they are needed
    int used;                                 // sets in this frame
} swSetRing;

// After swBeginGpuFrame(). The layout has at most one storage buffer and SW_MAX_BINDINGS sampled images.
// @return SW_ERROR_LIMIT after SW_SETS_OF_POOL * SW_MAX_SET_POOLS sets in one frame
swResult swAllocateSet(swGpu* gpu, VkDescriptorSetLayout layout, VkDescriptorSet* set);
void swResetSets(swGpu* gpu, int slot);
void swDestroySets(swGpu* gpu);

// Write bindings 0 .. count - 1 of a set.
void swWriteSet(swGpu* gpu, VkDescriptorSet set, uint32_t count, const VkDescriptorType* types,
                const swBinding* bindings);
