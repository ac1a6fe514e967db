// SPDX-License-Identifier: MIT
#pragma once

// The tiles of waves on the GPU: what the passes of waves share, and hand on to all others.

#include "core/frame/frame.h"
#include "gpu/vk/vk_device.h"
#include "gpu/vk/vk_pipeline.h"
#include "shared/limits.h"
#include "shared/waves.h"

// Resolutions that a tile may have, each twice the one before.
#define SW_TILE_SIZES 6

// What the wave passes make of the tiles this frame. Displacement is always there and comes first; velocity and
// acceleration are made in frames in which a query wants them, and cost nothing otherwise.
typedef struct swTileFields
{
    uint32_t count;
    uint32_t derivatives;            // see swWavesParams
    uint32_t lines, texels;          // of one field
    uint32_t velocity, acceleration; // which field they are; 0: not made
} swTileFields;

typedef struct swGpuTiles
{
    swBuffer roots;  // SW_TWIDDLES complex roots of unity
    swBuffer modes;  // of all tiles, as swMode
    swBuffer rows;   // see swTileParams::firstRow
    swBuffer lines;  // between the FFT's axes, of each field
    swBuffer texels; // of each field; see shaders/shared/waves.h
    // swTile::likeness, a number for each texel of displacement; while a flow may carry waves.
    swBuffer likeness;

    bool hasModes;    // tilesVersion and spectrumVersions are of what modes and rows hold
    bool hasLikeness; // and likeness
    uint32_t tilesVersion;
    uint32_t spectrumVersions[SW_MAX_TILES];

    // Set by each swGpuWorld_Record(), valid for this frame.
    int count;
    swTileFields fields;
    bool bringsModes; // modes and rows are uploaded
    bool isCarried;   // likeness is there
    bool bringsLikeness;
    bool isCore; // the core made the texels, they are only copied
    swUpload modesUpload, rowsUpload, texelsUpload, likenessUpload;
    swTileParams params[SW_MAX_TILES]; // by index of the frame's tiles, as in the layers of detail
    swUpload paramsUpload;
    swUpload order;                     // indices of tiles, grouped by resolution
    uint32_t groupFirst[SW_TILE_SIZES]; // of each resolution, in order
    uint32_t groupCount[SW_TILE_SIZES];
} swGpuTiles;

swResult swCreateGpuTiles(swGpuWorld* gpuWorld);
void swDestroyGpuTiles(swGpu* gpu, swGpuTiles* tiles);
size_t swGetGpuTileMemory(const swGpuTiles* tiles);

// All that may fail for a frame; records nothing. Queries say what fields they want.
swResult swPrepareGpuTiles(swGpuWorld* gpuWorld, const swFrame* frame);
void swCopyGpuTiles(swGpu* gpu, VkCommandBuffer commands, const swGpuTiles* tiles);
void swCommitGpuTiles(swGpuTiles* tiles, const swFrame* frame);
void swDiscardGpuTiles(swGpuTiles* tiles);

// swGpuTiles::likeness; something that is not read where no flow carries waves.
swBinding swBindLikeness(const swGpuWorld* gpuWorld);

// Of the tiles of a resolution.
static inline swWavesParams swMakeWavesParams(const swGpuTiles* tiles, int size)
{
    const swTileFields* fields = &tiles->fields;
    return (swWavesParams){tiles->groupFirst[size], fields->derivatives, fields->lines, fields->texels};
}

// log2(resolution) - 4: the index of a tile resolution.
static inline int swTileSizeIndex(int resolution)
{
    int index = 0;
    while ((16 << index) < resolution)
    {
        index += 1;
    }
    return index;
}
