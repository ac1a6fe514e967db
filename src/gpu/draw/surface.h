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
    swBuffer visible;     // swMeshTile[], as many as the sea and each body may have
    swBuffer arguments;   // VkDrawIndexedIndirectCommand
} swSurface;

// What the surface is drawn from.
typedef struct swSurfaceSources
{
    const swGpuWorld* gpuWorld;
    const swGpuView* view;
    const swFoamTexture* foam;
    const swSky* sky;
    VkImageView opaqueColor, opaqueDepth; // null: nothing is seen through the water
} swSurfaceSources;

// What a surface's pipeline can do beyond a sea with nothing in it: bits.
typedef enum swSurfaceAbility
{
    SW_SURFACE_IS_CLEAR = 1, // shows what stands in the water
    SW_SURFACE_IS_WIRE = 2,
    SW_SURFACE_HAS_PLACES = 4, // inputs say how deep the water is, or how high it stands
    SW_SURFACE_HAS_COLORS = 8, // inputs colour the water or shade it
    SW_SURFACE_HAS_MADE_FOAM = 16,
    SW_SURFACE_HAS_HOLES = 32,     // inputs cut the water away
    SW_SURFACE_HAS_BODIES = 64,    // there are bodies of water
    SW_SURFACE_HAS_WEIGHTS = 128,  // inputs say how much of which waves there is
    SW_SURFACE_CARRIES_FOAM = 256, // the water flows
    SW_SURFACE_KIND_COUNT = 512
} swSurfaceAbility;

// To the formats of colour and depth. `kind` is a sum of abilities.
swResult swCreateSurfacePipeline(swGpu* gpu, VkFormat color, VkFormat depth, int kind, swPipeline* pipeline);
swResult swCreateCullPipeline(swGpu* gpu, swPipeline* pipeline);

swResult swCreateSurface(swGpu* gpu, swSurface* surface);
// Once no frame in flight can use it any more.
void swRetireSurface(swGpu* gpu, swSurface* surface);

// All of it that may fail; records nothing.
swResult swPrepareSurface(swGpu* gpu, swSurface* surface, const swPictureFrame* picture);
// Outside of rendering: the tiles that the camera sees.
void swRecordSurface(const swGpuWorld* gpuWorld, VkCommandBuffer commands, const swPipeline* cull, swSurface* surface,
                     const swPictureFrame* picture);
// Inside rendering.
void swDrawSurface(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swSurfaceSources* from,
                   const swSurface* surface, const swPictureFrame* picture);
