// SPDX-License-Identifier: MIT
// One dispatch a query of the surface or of the water below it; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "surface_query_shader.h"

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
    const swSurfaceQueryConstants constants = {.withMotion = withMotion};
    return swCreateComputePipeline(gpu, &swSurfaceQueryShader, &constants, pipeline);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    static_assert(sizeof(swQueryParams) == SW_SURFACE_QUERY_PUSH_SIZE, "what surface_query.comp is given");
    swQueryParams params = query->params;
    const swSurfaceQueryBindings bindings = {
        .tiles = swBindUpload(&query->tiles),
        .waves = swBindUpload(&query->waves),
        .texels = swBindBuffer(&gpuWorld->texels),
        .points = swBindPoints(query, &params.source),
        .heights = swBindPlane(query, query->planes.heights),
        .sideways = swBindPlane(query, query->planes.sideways),
        .normals = swBindPlane(query, query->planes.normals),
        .velocities = swBindPlane(query, query->planes.velocities),
        .accelerations = swBindPlane(query, query->planes.accelerations),
    };
    const swPipeline* pipeline = &gpuWorld->passes.surfaceQuery[hasMotion(params.outputs) ? 1 : 0];
    swBindSurfaceQuery(gpu, commands, pipeline, &bindings, &params);
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
