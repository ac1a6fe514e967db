// SPDX-License-Identifier: MIT
// One dispatch a query; nothing waits between queries.

#include "gpu/pass/passes.h"

static const uint32_t surfaceQueryCode[] =
#include "surface_query.comp.inc"
    ;

// What offsets of storage buffers are rounded down to: the most that a device may ask for.
#define SW_OFFSET_ALIGNMENT 256u

// Workgroups along an axis that every device can have.
#define SW_MOST_GROUPS 65535u

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

// Points that the host set, or the part of the host's buffer that holds them.
static swBinding bindPoints(const swGpuQuery* query, swQueryParams* params)
{
    params->isFloatPoint = query->hostPoints != VK_NULL_HANDLE ? 1 : 0;
    if (query->hostPoints == VK_NULL_HANDLE)
    {
        VkDeviceSize size = query->points.size / (VkDeviceSize)query->slotCount;
        return (swBinding){query->points.handle, .offset = size * (VkDeviceSize)query->pointSlot, .range = size};
    }
    VkDeviceSize aligned = query->hostOffset / SW_OFFSET_ALIGNMENT * SW_OFFSET_ALIGNMENT;
    VkDeviceSize skipped = query->hostOffset - aligned;
    params->firstPoint = (uint32_t)(skipped / sizeof(swVec2));
    return (swBinding){
        .buffer = query->hostPoints,
        .offset = aligned,
        .range = skipped + (VkDeviceSize)query->count * sizeof(swVec2),
    };
}

static swBinding bindPlane(const swGpuQuery* query, VkDeviceSize offset)
{
    return (swBinding){.buffer = query->answers.handle, .offset = offset};
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swQueryParams params = query->params;
    const swBinding bindings[] = {
        swBindUpload(&query->tiles),
        swBindUpload(&query->waves),
        swBindBuffer(&gpuWorld->texels),
        bindPoints(query, &params),
        bindPlane(query, query->planes.heights),
        bindPlane(query, query->planes.sideways),
        bindPlane(query, query->planes.normals),
        bindPlane(query, query->planes.velocities),
        bindPlane(query, query->planes.accelerations),
    };
    const swPipeline* pipeline = &gpuWorld->passes.surfaceQuery[hasMotion(query->def.outputs) ? 1 : 0];
    swBindPipeline(gpu, commands, pipeline, bindings, &params);
    uint32_t groups = (params.pointCount + SW_QUERY_POINTS - 1) / SW_QUERY_POINTS;
    uint32_t columns = groups < SW_MOST_GROUPS ? groups : SW_MOST_GROUPS;
    gpu->vk.CmdDispatch(commands, columns, (groups + columns - 1) / columns, 1);
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
        if (query->count > 0)
        {
            recordQuery(gpuWorld, query, commands);
        }
    }
    swEndPass(gpuWorld->gpu, commands);
}
