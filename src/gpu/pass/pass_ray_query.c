// SPDX-License-Identifier: MIT
// One dispatch a query of rays; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "ray_query_shader.h"

swResult swCreateRayQuery(swGpu* gpu, swPasses* passes)
{
    if (passes->rayQuery.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    return swCreateComputePipeline(gpu, &swRayQueryShader, NULL, &passes->rayQuery);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    static_assert(sizeof(swRayParams) == SW_RAY_QUERY_PUSH_SIZE, "what ray_query.comp is given");
    swRayParams params = query->rays;
    const swRayQueryBindings bindings = {
        .tiles = swBindUpload(&query->tiles),
        .waves = swBindUpload(&query->waves),
        .texels = swBindBuffer(&gpuWorld->texels),
        .points = swBindPoints(query, &params.source),
        .heights = swBindPlane(query, query->planes.heights),
        .hits = swBindPlane(query, query->planes.hits),
        .normals = swBindPlane(query, query->planes.normals),
    };
    swBindRayQuery(gpu, commands, &gpuWorld->passes.rayQuery, &bindings, &params);
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
