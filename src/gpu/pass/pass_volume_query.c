// SPDX-License-Identifier: MIT
// One dispatch a query of the water below, after its surface was searched; nothing waits between queries.

#include "gpu/pass/passes.h"

static const uint32_t volumeQueryCode[] =
#include "volume_query.comp.inc"
    ;

swResult swCreateVolumeQuery(swGpu* gpu, swPasses* passes)
{
    if (passes->volumeQuery.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    swComputeDef def = {
        .shader = SW_SHADER(volumeQueryCode),
        .bindingCount = 9,
        .pushSize = sizeof(swVolumeParams),
        .name = "volume_query",
    };
    for (uint32_t i = 0; i < def.bindingCount; ++i)
    {
        def.types[i] = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
    return swCreateComputePipeline(gpu, &def, &passes->volumeQuery);
}

static swBinding bindLevels(const swGpuQuery* query)
{
    VkDeviceSize size = query->points.size / (VkDeviceSize)query->slotCount;
    return (swBinding){
        .buffer = query->points.handle,
        .offset = size * (VkDeviceSize)query->pointSlot + query->levelsAt,
        .range = size - query->levelsAt,
    };
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swVolumeParams params = query->volume;
    const swBinding bindings[] = {
        swBindUpload(&query->volumeTiles),
        swBindUpload(&query->waves),
        swBindBuffer(&gpuWorld->volumeWaves),
        swBindPoints(query, &params.source),
        bindLevels(query),
        swBindPlane(query, query->planes.heights),
        swBindPlane(query, query->planes.depths),
        swBindPlane(query, query->planes.velocities),
        swBindPlane(query, query->planes.accelerations),
    };
    swBindPipeline(gpu, commands, &gpuWorld->passes.volumeQuery, bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_VOLUME_POINTS);
}

void swRecordVolumeQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (!gpuWorld->hasVolume)
    {
        return;
    }
    swBeginPass(gpuWorld->gpu, commands, "volume_query");
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind == SW_GPU_QUERY_KIND_VOLUME)
        {
            recordQuery(gpuWorld, query, commands);
        }
    }
    swEndPass(gpuWorld->gpu, commands);
}
