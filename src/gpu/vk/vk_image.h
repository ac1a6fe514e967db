// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/vk/vk_memory.h"

#define SW_MAX_MIPS 14

typedef struct swImageDef
{
    VkFormat format;
    uint32_t width, height;
    uint32_t depth;  // > 1: a 3D image. 0 counts as 1
    uint32_t layers; // 0 counts as 1
    uint32_t mips;   // 0 counts as 1
    bool isArray;    // view as an array even with one layer
    VkImageUsageFlags usage;
    VkImageLayout layout; // that it rests in between passes: GENERAL if shaders write it, else SHADER_READ_ONLY_OPTIMAL
    const char* name;
} swImageDef;

typedef struct swImage
{
    VkImage handle;                    // null if there is none
    VkImageView view;                  // all layers and mips
    VkImageView mipViews[SW_MAX_MIPS]; // all layers of one mip; mipViews[0] is null unless mips > 1
    VkFormat format;
    VkImageLayout layout; // see swImageDef
    uint32_t width, height, depth, layers, mips;
    bool isInitialized; // set by swInitializeImage()
    swAllocation memory;
} swImage;

// Transfer destination and source always; `usage` adds to that. Depth formats get a depth view.
swResult swCreateImage(swGpu* gpu, const swImageDef* def, swImage* image);
// At once; the GPU must be done with it. Clears the image; null is allowed.
void swDestroyImage(swGpu* gpu, swImage* image);
// Once no frame in flight can use it any more.
void swRetireImage(swGpu* gpu, swImage* image);
// The first time: a barrier from UNDEFINED to the resting layout. Later calls do nothing.
void swInitializeImage(swGpu* gpu, VkCommandBuffer commands, swImage* image);

// Samplers that every swGpu has.
typedef enum swSamplerKind
{
    SW_SAMPLER_NEAREST_CLAMP,
    SW_SAMPLER_LINEAR_CLAMP,
    SW_SAMPLER_LINEAR_REPEAT,      // trilinear
    SW_SAMPLER_ANISOTROPIC_REPEAT, // trilinear, up to 16 x or what the device has
    SW_SAMPLER_LINEAR_REPEAT_X,    // repeats along u, clamps along v
    SW_SAMPLER_COUNT
} swSamplerKind;
