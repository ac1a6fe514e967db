// SPDX-License-Identifier: MIT
#pragma once

// Queries of a world on the GPU: points go in, answers come back some frames later.

#include "gpu/pass/query_passes.h"

swResult swMakeGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** query);
void swFreeGpuQuery(swGpuQuery* query);
void swPlaceQueryPoints(swGpuQuery* query, int count, const swPosXZ* points);
void swPlaceVolumePoints(swGpuQuery* query, int count, const swPos* places);
void swPlaceQueryRays(swGpuQuery* query, int count, const swRay* rays);
void swBindQueryPoints(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin);
// This frame's parameters of all queries. Nothing is recorded.
swResult swUploadQueries(swGpuWorld* gpuWorld, const swFrame* frame);
// Whether a query of this frame wants its answers where the host reads them.
bool swHasAnswers(const swGpuWorld* gpuWorld);
// Record their copies. swCommitQueries() has not stamped them yet.
void swCopyAnswers(swGpuWorld* gpuWorld, VkCommandBuffer commands);
// The passes were recorded: stamp what answers will be.
void swCommitQueries(swGpuWorld* gpuWorld, const swFrame* frame);
// Answers of `frameIndex` and later will not come.
void swDiscardQueries(swGpuWorld* gpuWorld, uint64_t frameIndex);
// The newest slot whose frame is known to be done, or NULL.
const swGpuQuerySlot* swFindQueryAnswers(const swGpuQuery* query);
void swFillQueryResults(const swGpuQuery* query, const swGpuQuerySlot* slot, swGpuQueryResults* results);
void swUnpackQueryResults(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats);
void swUnpackVolumeResults(const swGpuQueryResults* results, const swVolumeSamples* samples, swQueryStats* stats);
void swUnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits, swQueryStats* stats);
size_t swGetQueryMemory(const swGpuQuery* query);
