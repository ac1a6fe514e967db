// SPDX-License-Identifier: MIT
#pragma once

// One pair of functions a line of core/frame/passes.inl: create the pass's pipeline, and record it. Each records its
// own label and timestamps; barriers between passes belong to record/.

#include "gpu/pass/gpu_world.h"

// Pipelines are created by the first frame that needs them, those of the FFT for each resolution of tiles: a second
// call does nothing.
swResult swCreateWavesRows(swGpu* gpu, int resolution, swPasses* passes);
swResult swCreateWavesColumns(swGpu* gpu, int resolution, swPasses* passes);
swResult swCreateDetail(swGpu* gpu, swPasses* passes);
swResult swCreateSlices(swGpu* gpu, swPasses* passes);
swResult swCreateFoam(swGpu* gpu, swPasses* passes);
swResult swCreateSurfaceQuery(swGpu* gpu, uint32_t outputs, swPasses* passes); // a second call does nothing
swResult swCreateVolumeWaves(swGpu* gpu, swPasses* passes);                    // likewise
swResult swCreateVolumeQuery(swGpu* gpu, swPasses* passes);                    // likewise
swResult swCreateRayQuery(swGpu* gpu, swPasses* passes);                       // likewise
void swDestroyPasses(swGpu* gpu, swPasses* passes);

void swRecordWavesRows(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordWavesColumns(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordDetail(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordSlices(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordFoam(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordVolumeWaves(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordSurfaceQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordRayQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordVolumeQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands);

// What the passes of queries share. Points that the host set, or the part of the host's buffer that holds them; fills
// `source`.
swBinding swBindPoints(const swGpuQuery* query, swQuerySource* source);
swBinding swBindPlane(const swGpuQuery* query, VkDeviceSize offset); // of the answers
// Workgroups of `points` points each.
void swDispatchPoints(swGpu* gpu, VkCommandBuffer commands, const swGpuQuery* query, uint32_t points);

// Of the tiles of a resolution.
static inline swWavesParams swMakeWavesParams(const swGpuWorld* gpuWorld, int size)
{
    const swTileFields* fields = &gpuWorld->fields;
    return (swWavesParams){gpuWorld->groupFirst[size], fields->derivatives, fields->lines, fields->texels};
}

// log2(resolution) - 4: the index of a tile resolution's pipelines.
static inline int swTileSizeIndex(int resolution)
{
    int index = 0;
    while ((16 << index) < resolution)
    {
        index += 1;
    }
    return index;
}
