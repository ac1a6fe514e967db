// SPDX-License-Identifier: MIT
#pragma once

// A pass is a stretch of commands with a name: a debug label and a pair of timestamps. Barriers are global memory
// barriers: on every device in use they cost what an image barrier costs, and nothing can be forgotten.

#include "seaway/gpu.h"

#define SW_MAX_FRAMES_IN_FLIGHT 4
#define SW_MAX_TIMED_PASSES 48

typedef struct swPassTimer
{
    VkQueryPool pools[SW_MAX_FRAMES_IN_FLIGHT]; // null if the queue has no timestamps
    const char* names[SW_MAX_FRAMES_IN_FLIGHT][SW_MAX_TIMED_PASSES];
    int counts[SW_MAX_FRAMES_IN_FLIGHT];
    bool isStarted;  // in this frame
    int openPass;    // index of the pass between begin and end, -1 if it is not timed
    bool isEnabled;  // true; a benchmark turns it off to time whole frames
    int resultCount; // of the latest frame whose timestamps arrived
    swPassTime results[SW_MAX_TIMED_PASSES];
} swPassTimer;

swResult swCreatePassTimer(swGpu* gpu);
void swDestroyPassTimer(swGpu* gpu);

// Begin frame `frameIndex`, once per index however often it is called: takes the slot's timestamps, makes its upload
// ring empty, and destroys what was retired long enough ago. All that prepares or records for a frame calls it first.
void swBeginGpuFrame(swGpu* gpu, uint64_t frameIndex);
// Record the reset of the frame's timestamps, once a frame, before its first pass. Outside of rendering.
void swStartPassTimer(swGpu* gpu, VkCommandBuffer commands);
// The commands of recorded frames will not run: their times will not come, and timestamps are reset again.
void swDiscardGpuFrame(swGpu* gpu);

// `name` must be a literal. Passes do not nest.
void swBeginPass(swGpu* gpu, VkCommandBuffer commands, const char* name);
void swEndPass(swGpu* gpu, VkCommandBuffer commands);

// What was written by `fromStages` becomes visible to `toStages`.
void swBarrier(swGpu* gpu, VkCommandBuffer commands, VkPipelineStageFlags2 fromStages, VkAccessFlags2 fromAccess,
               VkPipelineStageFlags2 toStages, VkAccessFlags2 toAccess);
// Compute shader writes become visible to compute shaders.
void swComputeBarrier(swGpu* gpu, VkCommandBuffer commands);
// Move an image between layouts; all its layers and mips.
struct swImage;
void swImageBarrier(swGpu* gpu, VkCommandBuffer commands, const struct swImage* image, VkImageLayout from,
                    VkImageLayout to, VkPipelineStageFlags2 fromStages, VkAccessFlags2 fromAccess,
                    VkPipelineStageFlags2 toStages, VkAccessFlags2 toAccess);
