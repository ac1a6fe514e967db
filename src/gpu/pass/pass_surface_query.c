// SPDX-License-Identifier: MIT
// One dispatch a query of the surface or of the water below it; nothing waits between queries.

#include "gpu/pass/passes.h"

static const uint32_t surfaceQueryCode[] =
#include "surface_query.comp.inc"
    ;

static bool hasMotion(uint32_t outputs)
{
    return (outputs & (SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION)) != 0;
}

swResult swCreateSurfaceQuery(swGpu* gpu, uint32_t outputs, swPasses* passes)
{
    const uint32_t withMotion = hasMotion(outputs) ? 1 : 0;
    swPipeline* pipeline = &passes->surfaceQuery[withMotion];
    if (pipeline->handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    swComputeDef def = {
        .shader = SW_SHADER(surfaceQueryCode),
        .bindingCount = 9,
        .pushSize = sizeof(swQueryParams),
        .constantCount = 1,
        .constants = &withMotion,
        .name = "surface_query",
    };
    for (uint32_t i = 0; i < def.bindingCount; ++i)
    {
        def.types[i] = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
    return swCreateComputePipeline(gpu, &def, pipeline);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swQueryParams params = query->params;
    const swBinding bindings[] = {
        swBindUpload(&query->tiles),
        swBindUpload(&query->waves),
        swBindBuffer(&gpuWorld->texels),
        swBindPoints(query, &params.source),
        swBindPlane(query, query->planes.heights),
        swBindPlane(query, query->planes.sideways),
        swBindPlane(query, query->planes.normals),
        swBindPlane(query, query->planes.velocities),
        swBindPlane(query, query->planes.accelerations),
    };
    const swPipeline* pipeline = &gpuWorld->passes.surfaceQuery[hasMotion(params.outputs) ? 1 : 0];
    swBindPipeline(gpu, commands, pipeline, bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_QUERY_POINTS);
}

void swRecordSurfaceQuery(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (gpuWorld->firstQuery == NULL)
    {
        return;
    }
    swBeginPass(gpuWorld->gpu, commands, "surface_query");
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind != SW_GPU_QUERY_KIND_RAYS)
        {
            recordQuery(gpuWorld, query, commands);
        }
    }
    swEndPass(gpuWorld->gpu, commands);
}
