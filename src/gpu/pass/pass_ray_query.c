// SPDX-License-Identifier: MIT
// One dispatch a query of rays; nothing waits between queries.

#include "gpu/pass/passes.h"

static const uint32_t rayQueryCode[] =
#include "ray_query.comp.inc"
    ;

swResult swCreateRayQuery(swGpu* gpu, swPasses* passes)
{
    if (passes->rayQuery.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    swComputeDef def = {
        .shader = SW_SHADER(rayQueryCode),
        .bindingCount = 7,
        .pushSize = sizeof(swRayParams),
        .name = "ray_query",
    };
    for (uint32_t i = 0; i < def.bindingCount; ++i)
    {
        def.types[i] = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
    return swCreateComputePipeline(gpu, &def, &passes->rayQuery);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swRayParams params = query->rays;
    const swBinding bindings[] = {
        swBindUpload(&query->tiles),
        swBindUpload(&query->waves),
        swBindBuffer(&gpuWorld->texels),
        swBindPoints(query, &params.source),
        swBindPlane(query, query->planes.heights),
        swBindPlane(query, query->planes.hits),
        swBindPlane(query, query->planes.normals),
    };
    swBindPipeline(gpu, commands, &gpuWorld->passes.rayQuery, bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_QUERY_POINTS);
}

void swRecordRayQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (!gpuWorld->hasRays)
    {
        return;
    }
    swBeginPass(gpuWorld->gpu, commands, "ray_query");
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind == SW_GPU_QUERY_KIND_RAYS)
        {
            recordQuery(gpuWorld, query, commands);
        }
    }
    swEndPass(gpuWorld->gpu, commands);
}
