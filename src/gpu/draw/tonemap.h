// SPDX-License-Identifier: MIT
#pragma once

// From the HDR target to the screen: automatic exposure and the tone curve.

#include "gpu/draw/picture.h"

typedef struct swTonemap
{
    swPipeline exposePipeline, tonemapPipeline;
    swBuffer exposure; // swExposure
    bool isCleared;
    uint64_t clearedFrame; // index of the frame that did
} swTonemap;

swResult swCreateTonemap(swGpu* gpu, const swRendererDef* def, swTonemap* tonemap);
void swDestroyTonemap(swGpu* gpu, swTonemap* tonemap);

// Outside of rendering, before anything reads the exposure.
void swClearExposure(swGpu* gpu, VkCommandBuffer commands, swTonemap* tonemap);
void swRecordExposure(swGpu* gpu, VkCommandBuffer commands, swTonemap* tonemap, VkImageView hdr, float dt,
                      bool immediate);
// Frames from `frameIndex` on did not run.
void swForgetExposure(swTonemap* tonemap, uint64_t frameIndex);
// Inside rendering. `isRaw` shows the target's colours as they are, for debug modes.
void swDrawTonemap(swGpu* gpu, VkCommandBuffer commands, const swTonemap* tonemap, VkImageView hdr, float time,
                   float stops, bool isRaw);
