// SPDX-License-Identifier: MIT
#pragma once

// What recorded passes leave for drawing: the GPU's counterpart of core/frame/frame.h. Plain data, owned and filled by
// record/; passes and drawing only read it. All images rest in VK_IMAGE_LAYOUT_GENERAL, because compute shaders write
// them each frame. After swGpuWorld_Record() a barrier has made everything here visible to vertex, fragment and compute
// shaders of the same queue.

#include "core/frame/frame.h"
#include "gpu/vk/vk_device.h"
#include "gpu/vk/vk_pipeline.h"
#include "shared/waves.h"

// Sides of the detail layers: the largest tile resolution, kept within these. SW_DETAIL_MIPS mips, the last of a block of
// 32 x 32 texels.
#define SW_DETAIL_MIN 32
#define SW_DETAIL_MAX 256
#define SW_DETAIL_MIPS 6

// Layers of one view. Array layer = slice; texel centres are the lattice points, so point (column, row) of a slice is at
// uv = ((column + 0.5) / R, (row + 0.5) / R).
typedef struct swGpuView
{
    uint32_t viewVersion; // of the view it belongs to, 0 if the entry is free
    const swView* view;   // identity only
    int sliceCount, resolution;
    swImage displacement; // RGBA32F: x, y, z, J. J in full precision is what foam grows by
    swImage derivatives;  // RGBA16F: gx, gz, J, 0
    swImage foam[2];      // R32F, written in turns
    int foamIndex;        // the one that the last recorded frame wrote
    bool hasFoam;
    int64_t foamClock;
    uint32_t foamResetCount;
    swSlice foamSlices[SW_MAX_SLICES]; // where the foam lies
} swGpuView;

// Pipelines of the passes, by log2(resolution) - 4 where a tile's resolution is built in.
#define SW_TILE_SIZES 6
typedef struct swPasses
{
    swPipeline wavesRows[SW_TILE_SIZES];
    swPipeline wavesColumns[SW_TILE_SIZES];
    swPipeline detail;
    swPipeline slices;
    swPipeline foam;
} swPasses;

struct swGpuWorld
{
    swGpu* gpu;
    const swWorld* world;
    swPasses passes;
    swBuffer twiddles; // 512 complex roots of unity
    swBuffer modes;    // of all tiles, as swMode
    swBuffer rows;     // see swTileParams::firstRow
    swBuffer lines;    // between the FFT's axes
    swBuffer texels;
    uint64_t frameIndex; // of the last recorded frame
    bool hasRecorded;

    // Set by each swGpuWorld_Record(), valid for this frame.
    int tileCount;
    const swTile* tiles;                 // the frame's tiles; index = element of tileParams = layer of detail
    swUpload tileParams;                 // swTileParams[tileCount]
    uint32_t tileVersions[SW_MAX_TILES]; // spectrumVersion that was uploaded
    uint32_t tilesVersion;
    swTileParams params[SW_MAX_TILES]; // host copy of tileParams

    // RGBA16F 2D array, one layer a tile, SW_DETAIL_MIPS mips: (sx, sz, sx^2, sz^2) with s the slope of the tile's height
    // by rest position at sample points; mips are averages, so that slopes lost by filtering have variance s2 - s s.
    // Rest point u of the plane is at uv = u / side + 0.5 / detail.width. Repeats.
    swImage detail;

    int viewCapacity;
    swGpuView views[SW_MAX_VIEWS];
};

// The layers of a view, or NULL if it was not recorded.
const swGpuView* swFindGpuView(const swGpuWorld* gpuWorld, const swView* view);

// Foam of the last recorded frame.
static inline const swImage* swGetFoamImage(const swGpuView* view)
{
    return &view->foam[view->foamIndex];
}
