// SPDX-License-Identifier: MIT
// One dispatch a query of the water below, after its surface was searched; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "volume_query_shader.h"

swResult swCreateVolumeQuery(swGpu* gpu, swPasses* passes)
{
    if (passes->volumeQuery.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    return swCreateComputePipeline(gpu, &swVolumeQueryShader, NULL, &passes->volumeQuery);
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
    static_assert(sizeof(swVolumeParams) == SW_VOLUME_QUERY_PUSH_SIZE, "what volume_query.comp is given");
    swVolumeParams params = query->volume;
    const swVolumeQueryBindings bindings = {
        .tiles = swBindUpload(&query->volumeTiles),
        .freeWaves = swBindUpload(&query->waves),
        .waves = swBindBuffer(&gpuWorld->volumeWaves),
        .points = swBindPoints(query, &params.source),
        .levels = bindLevels(query),
        .heights = swBindPlane(query, query->planes.heights),
        .depths = swBindPlane(query, query->planes.depths),
        .velocities = swBindPlane(query, query->planes.velocities),
        .accelerations = swBindPlane(query, query->planes.accelerations),
    };
    swBindVolumeQuery(gpu, commands, &gpuWorld->passes.volumeQuery, &bindings, &params);
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
