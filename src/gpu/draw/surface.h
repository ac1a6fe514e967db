// SPDX-License-Identifier: MIT
#pragma once

// The water's surface: culling on the GPU and one indirect draw.

#include "gpu/draw/sky.h"

typedef struct swSurface
{
    swPipeline cullPipeline;
    swPipeline drawPipeline;
    swPipeline wirePipeline; // null if the device has no wireframe
    swBuffer indices;        // of a tile's grid
    uint32_t indicesSide;    // that the indices are for
    swBuffer visible;        // swMeshTile[SW_MAX_MESH_TILES]
    swBuffer arguments;      // VkDrawIndexedIndirectCommand
    swImage foamTexture;
    swUpload foamUpload; // of this frame, while the texture has not been filled
} swSurface;

swResult swCreateSurface(swGpu* gpu, const swRendererDef* def, swSurface* surface);
void swDestroySurface(swGpu* gpu, swSurface* surface);

// All of it that may fail; records nothing.
swResult swPrepareSurface(swGpu* gpu, swSurface* surface, const swPictureFrame* picture);
// Outside of rendering: the tiles that the camera sees. `halve` makes mips.
void swRecordSurface(swGpu* gpu, VkCommandBuffer commands, swSurface* surface, const swPipeline* halve,
                     const swPictureFrame* picture);
// What was recorded did not run: fill the texture again.
void swForgetSurface(swSurface* surface);
// Inside rendering.
void swDrawSurface(swGpu* gpu, VkCommandBuffer commands, const swSurface* surface, const swSky* sky,
                   const swGpuWorld* gpuWorld, const swGpuView* view, const swPictureFrame* picture);
