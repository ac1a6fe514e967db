// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame, and what the GPU keeps of a world.

#include "gpu/pass/gpu_world.h"

swResult swMakeGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);
void swFreeGpuWorld(swGpuWorld* gpuWorld);

// Record all passes of the world's last frame.
swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);

// Bring buffers, images and this frame's parameters up to the frame: all that may fail. Records nothing; after a
// failure the next call makes up for everything.
swResult swPrepareFrame(swGpuWorld* gpuWorld, const swFrame* frame);
swResult swPrepareTiles(swGpuWorld* gpuWorld, const swFrame* frame);
swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view);
// Record the copies that it prepared. Cannot fail.
void swRecordUploads(swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordTiles(swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordCoreLayers(swGpu* gpu, VkCommandBuffer commands, const swGpuView* view);
// Note what the device will hold. `frame` is that of swPrepareFrame().
void swCommitFrame(swGpuWorld* gpuWorld, const swFrame* frame);
void swCommitTiles(swGpuWorld* gpuWorld, const swFrame* frame);
// Take back the notes of `frameIndex` and all later frames, which will not run.
void swDiscardFrames(swGpuWorld* gpuWorld, uint64_t frameIndex);

// Queries of a world; see gpu_query.c and gpu_query_water.c.
swResult swMakeGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** query);
void swFreeGpuQuery(swGpuQuery* query);
void swPlaceQueryPoints(swGpuQuery* query, int count, const swPosXZ* points);
void swPlaceVolumePoints(swGpuQuery* query, int count, const swPos* places);
void swPlaceQueryRays(swGpuQuery* query, int count, const swRay* rays);
void swBindQueryPoints(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin);
// Bits of swGpuQueryOutput that the queries of this frame want of the tiles.
uint32_t swFindWantedFields(const swGpuWorld* gpuWorld);
// This frame's parameters of all queries. Nothing is recorded.
swResult swUploadQueries(swGpuWorld* gpuWorld, const swFrame* frame);
// After the query pass: copy answers to where the host reads them, and stamp them.
void swRecordQueryCopies(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame);
// Answers of `frameIndex` and later will not come.
void swDiscardQueries(swGpuWorld* gpuWorld, uint64_t frameIndex);
// The newest slot whose frame is known to be done, or NULL.
const swGpuQuerySlot* swFindQueryAnswers(const swGpuQuery* query);
void swFillQueryResults(const swGpuQuery* query, const swGpuQuerySlot* slot, swGpuQueryResults* results);
void swUnpackQueryResults(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats);
void swUnpackVolumeResults(const swGpuQueryResults* results, const swVolumeSamples* samples, swQueryStats* stats);
void swUnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits, swQueryStats* stats);
size_t swGetQueryMemory(const swGpuQuery* query);

// Copy one slice of a layer to the host; waits.
swResult swReadLayer(swGpuWorld* gpuWorld, const swGpuView* view, swLayer layer, int slice, float* texels);
// Copy one mip of one tile's detail to the host, 4 floats a texel; waits. For tests.
swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels);
// Copy the tiles' texels (resolution rows of resolution + 3 columns) to the host; waits. For tests.
swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels);
