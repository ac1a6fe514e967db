// SPDX-License-Identifier: MIT
#pragma once

// Queries of a world on the GPU: points go in, answers come back some frames later.

#include "gpu/pass/gpu_world.h"

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
