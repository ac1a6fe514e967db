// SPDX-License-Identifier: MIT
#pragma once

// From the HDR target to the screen: automatic exposure and the tone curve.

#include "gpu/draw/picture.h"

// Of one picture: what its eye has got used to.
typedef struct swTonemap
{
    swBuffer exposure; // swExposure
    bool isCleared;
    uint64_t clearedFrame; // index of the frame that did
} swTonemap;

swResult swCreateExposePipeline(swGpu* gpu, swPipeline* pipeline);
// To a picture's formats.
swResult swCreateTonemapPipeline(swGpu* gpu, const swPictureDef* formats, swPipeline* pipeline);

swResult swCreateTonemap(swGpu* gpu, swTonemap* tonemap);
// Once no frame in flight can use it any more.
void swRetireTonemap(swGpu* gpu, swTonemap* tonemap);

// Outside of rendering, before anything reads the exposure.
void swClearExposure(swGpu* gpu, VkCommandBuffer commands, swTonemap* tonemap);
void swRecordExposure(swGpu* gpu, VkCommandBuffer commands, const swPipeline* expose, swTonemap* tonemap,
                      VkImageView hdr, float dt, bool immediate);
// Frames from `frameIndex` on did not run.
void swForgetExposure(swTonemap* tonemap, uint64_t frameIndex);
// Inside rendering. `isRaw` shows the target's colours as they are, for debug modes.
void swDrawTonemap(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swTonemap* tonemap,
                   VkImageView hdr, float time, float stops, bool isRaw);
