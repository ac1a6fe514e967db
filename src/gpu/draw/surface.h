// SPDX-License-Identifier: MIT
#pragma once

// The water's surface: culling on the GPU and one indirect draw.

#include "gpu/draw/foam_texture.h"
#include "gpu/draw/sky.h"

// Of one picture.
typedef struct swSurface
{
    swBuffer indices;     // of a tile's grid
    uint32_t indicesSide; // that the indices are for
    swBuffer visible;     // swMeshTile[SW_MAX_MESH_TILES]
    swBuffer arguments;   // VkDrawIndexedIndirectCommand
} swSurface;

// What the surface is drawn from.
typedef struct swSurfaceSources
{
    const swGpuWorld* gpuWorld;
    const swGpuView* view;
    const swFoamTexture* foam;
    const swSky* sky;
} swSurfaceSources;

// To a picture's formats. `wire` stays null if the device has no wireframe.
swResult swCreateSurfacePipelines(swGpu* gpu, const swPictureDef* formats, swPipeline* fill, swPipeline* wire);
swResult swCreateCullPipeline(swGpu* gpu, swPipeline* pipeline);

swResult swCreateSurface(swGpu* gpu, swSurface* surface);
// Once no frame in flight can use it any more.
void swRetireSurface(swGpu* gpu, swSurface* surface);

// All of it that may fail; records nothing.
swResult swPrepareSurface(swGpu* gpu, swSurface* surface, const swPictureFrame* picture);
// Outside of rendering: the tiles that the camera sees.
void swRecordSurface(swGpu* gpu, VkCommandBuffer commands, const swPipeline* cull, swSurface* surface,
                     const swPictureFrame* picture);
// Inside rendering.
void swDrawSurface(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swSurfaceSources* from,
                   const swSurface* surface, const swPictureFrame* picture);
