// SPDX-License-Identifier: MIT
#pragma once

// A renderer has what pictures share: pipelines, those that draw once for each set of formats, and the foam's texture.
// A picture has what depends on its camera and on the frames before.

#include "gpu/draw/surface.h"
#include "gpu/draw/tonemap.h"

// Pipelines that draw to one set of formats.
typedef struct swFormatPipelines
{
    struct swFormatPipelines* next;
    VkFormat color, depth, output;
    swPipeline surfaces[SW_SURFACE_KIND_COUNT]; // by abilities; null until a picture needs them
    swPipeline sky, tonemap;
} swFormatPipelines;

struct swRenderer
{
    swGpuWorld* gpuWorld;
    swSkyPipelines sky;
    swPipeline cull, expose;
    swFoamTexture foam;
    swFormatPipelines* firstFormats;
    swPicture* firstPicture;
    uint32_t discardCount; // of the world, as far as the shared part knows
};

struct swPicture
{
    swRenderer* renderer;
    swPicture *previous, *next; // in the renderer's list
    swFormatPipelines* pipelines;
    swSky sky;
    swSurface surface;
    swTonemap tonemap;
    bool isPrepared;
    uint32_t discardCount; // as above, of this picture
    swPictureFrame frame;  // of the last swPreparePicture()
    const swGpuView* view;
    float time, exposureEv;
    swDebugMode debug;
    VkImageView opaqueColor, opaqueDepth;
    bool hasPlaces, hasColors, hasMadeFoam, hasHoles, hasWeights,
        carriesFoam; // of what inputs say, see swSurfaceAbility
};

swResult swMakeRenderer(swGpuWorld* gpuWorld, swRenderer** renderer);
// At once, with its pictures; the device is idle.
void swFreeRenderer(swRenderer* renderer);

swResult swMakePicture(swRenderer* renderer, const swPictureDef* formats, swPicture** picture);
// What frames in flight may use goes later.
void swFreePicture(swPicture* picture);

// The abilities of the surface that the prepared shot wants.
int swChooseSurface(const swPicture* picture);

// All that comes before drawing, outside of rendering. Nothing is recorded if it fails.
swResult swPreparePicture(swPicture* picture, VkCommandBuffer commands, const swShot* shot, uint64_t frameIndex);
