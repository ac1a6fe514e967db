// SPDX-License-Identifier: MIT
#pragma once

// The pattern of foam that all pictures share.

#include "gpu/vk/vk_pipeline.h"

typedef struct swFoamTexture
{
    swImage image;
    swUpload upload; // of this frame, while the image has not been filled
} swFoamTexture;

swResult swCreateFoamTexture(swGpu* gpu, swFoamTexture* foam);
void swDestroyFoamTexture(swGpu* gpu, swFoamTexture* foam);

// All of it that may fail; records nothing.
swResult swPrepareFoamTexture(swGpu* gpu, swFoamTexture* foam);
// Once: fill the image. `halve` makes mips.
void swRecordFoamTexture(swGpu* gpu, VkCommandBuffer commands, const swPipeline* halve, swFoamTexture* foam);
// What was recorded did not run: fill it again.
void swForgetFoamTexture(swFoamTexture* foam);
