// SPDX-License-Identifier: MIT
#pragma once

// What recorded passes leave for drawing: the GPU's counterpart of core/frame/frame.h. Plain data, owned and filled by
// record/; passes and drawing only read it. All images rest in VK_IMAGE_LAYOUT_GENERAL, because compute shaders write
// them each frame. After swGpuWorld_Record() a barrier has made everything here visible to vertex, fragment and compute
// shaders of the same queue.

#include "gpu/layer/gpu_view.h"
#include "gpu/vk/vk_pipeline.h"
#include "shared/limits.h"
#include "shared/query.h"
#include "shared/waves.h"

// Side of the detail layers, texels: the largest tile resolution, kept within these.
#define SW_DETAIL_MIN 32
#define SW_DETAIL_MAX 256

// What a frame leaves of a query, and the points that it was asked. There is one slot more than frames in flight, so
// that the newest that has arrived can be read while all others are on their way.
#define SW_QUERY_SLOTS (SW_MAX_FRAMES_IN_FLIGHT + 1)
typedef struct swGpuQuerySlot
{
    bool isRecorded;
    uint64_t frameIndex;
    double time;
    double seaLevel;
    uint32_t pointsVersion;
    int count;
} swGpuQuerySlot;

// What the wave passes make of the tiles this frame. Displacement is always there and comes first; velocity and
// acceleration are made in frames in which a query wants them, and cost nothing otherwise.
typedef struct swTileFields
{
    uint32_t count;
    uint32_t derivatives;            // see swWavesParams
    uint32_t lines, texels;          // of one field
    uint32_t velocity, acceleration; // which field they are; 0: not made
} swTileFields;

struct swGpuQuery
{
    swGpuWorld* gpuWorld;
    swGpuQuery *previous, *next; // in the world's list
    swGpuQueryDef def;
    int slotCount;

    // Places to answer: the host's, in one of the slots of `points`, or in a buffer of its own. A slot holds
    // swQueryPoint[] and, of the water below, the places' heights above `level`; or swQueryRay[].
    int count;
    uint32_t pointsVersion;
    swPosXZ origin; // of cells, or of the floats, in the host's coordinates
    double level;   // m
    swBuffer points;
    int pointSlot;
    bool isPointSlotUsed;  // a recorded frame reads it
    VkDeviceSize levelsAt; // in a slot
    VkBuffer hostPoints;   // null: `points`
    VkDeviceSize hostOffset;

    // Answers: planes of `capacity` elements, see swGpuQueryBuffer.
    swBuffer answers;
    swGpuQueryBuffer planes;
    VkDeviceSize answerSize; // of all planes
    swBuffer copies;         // of the answers, for each slot; none unless def.readBack
    int answerSlot;          // of the last recorded frame
    swGpuQuerySlot slots[SW_QUERY_SLOTS];

    // Set by each swGpuWorld_Record(), valid for this frame.
    swUpload tiles; // swQueryTile[]
    swUpload waves; // swQueryWave[]
    swQueryParams params;
    swUpload volumeTiles; // swVolumeTile[]; of the water below
    swVolumeParams volume;
    swRayParams rays; // of a query of rays
};

// Pipelines of the passes, by log2(resolution) - 4 where a tile's resolution is built in.
#define SW_TILE_SIZES 6
typedef struct swPasses
{
    swPipeline wavesRows[SW_TILE_SIZES];
    swPipeline wavesColumns[SW_TILE_SIZES];
    swPipeline detail;
    swPipeline slices;
    swPipeline foam;
    // Made with the first query that needs them.
    swPipeline surfaceQuery[2]; // without and with velocity or acceleration
    swPipeline volumeWaves, volumeQuery;
    swPipeline rayQuery;
} swPasses;

struct swGpuWorld
{
    swGpu* gpu;
    const swWorld* world;
    swPasses passes;
    swBuffer roots;       // SW_TWIDDLES complex roots of unity
    swBuffer modes;       // of all tiles, as swMode
    swBuffer rows;        // see swTileParams::firstRow
    swBuffer lines;       // between the FFT's axes, of each field
    swBuffer texels;      // of each field; see shaders/shared/waves.h
    swBuffer volumeWaves; // of each mode, swVolumeWave; none before a query of the water below

    // RGBA16F 2D array, one layer a tile, SW_DETAIL_MIPS mips: (sx, sz, sx^2, sz^2) with s the slope of the tile's
    // height by rest position at sample points; mips are averages, so that slopes lost by filtering have variance s2 -
    // s s. Rest point u of the plane is at uv = u / side + 0.5 / detail.width. Repeats.
    swImage detail;

    uint64_t frameIndex; // of the last recorded frame
    bool isRecorded;     // the last swGpuWorld_Record() succeeded, and its commands were not discarded
    uint32_t discardCount;
    uint64_t discardedFrom; // frame index of the last discard
    bool hasTiles;          // tilesVersion and spectrumVersions are of what modes and rows hold
    uint32_t tilesVersion;
    uint32_t spectrumVersions[SW_MAX_TILES];

    // Set by each swGpuWorld_Record(), valid for this frame.
    int tileCount;
    swTileFields fields;
    bool bringsModes;  // modes and rows are uploaded
    bool hasCoreTiles; // the core made the texels, they are only copied
    swUpload modesUpload, rowsUpload, texelsUpload;
    const swTile* tiles;                // the frame's tiles; index = element of tileParams = layer of detail
    swTileParams params[SW_MAX_TILES];  // host copy of tileParams
    swUpload tileParams;                // swTileParams[tileCount]
    swUpload order;                     // indices of tiles, grouped by resolution
    uint32_t groupFirst[SW_TILE_SIZES]; // of each resolution, in order
    uint32_t groupCount[SW_TILE_SIZES];
    swGpuView views[SW_MAX_VIEWS];
    swGpuQuery* firstQuery;
    bool hasVolume; // a query of this frame asks for the water below
    bool hasRays;   // likewise of rays
};

// The layers of a view, or NULL if the last frame was not recorded, or without it.
const swGpuView* swFindGpuView(const swGpuWorld* gpuWorld, const swView* view);
