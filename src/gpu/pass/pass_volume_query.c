// SPDX-License-Identifier: MIT
// One dispatch a query of the water below, after its surface was searched; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "gpu/pass/query_passes.h"
#include "volume_query_shader.h"

typedef struct State
{
    swPipeline pipeline;
} State;

static swBinding bindLevels(const swGpuQuery* query)
{
    VkDeviceSize size = query->points.size / (VkDeviceSize)query->slotCount;
    return (swBinding){
        .buffer = query->points.handle,
        .offset = size * (VkDeviceSize)query->pointSlot + query->levelsAt,
        .range = size - query->levelsAt,
    };
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    (void)state;
    *isNeeded = swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_VOLUME);
    return SW_SUCCESS;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    return swCreateOnce(gpuWorld->gpu, &swVolumeQueryShader, &((State*)state)->pipeline);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, const State* state,
                        VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    static_assert(sizeof(swVolumeParams) == SW_VOLUME_QUERY_PUSH_SIZE, "what volume_query.comp is given");
    swVolumeParams params = query->volume;
    const swVolumeQueryBindings bindings = {
        .tiles = swBindUpload(&query->volumeTiles),
        .freeWaves = swBindUpload(&query->waves),
        .waves = swBindBuffer(swGetVolumeWaves(gpuWorld)),
        .points = swBindPoints(query, &params.source),
        .levels = bindLevels(query),
        .heights = swBindPlane(query, query->planes.heights),
        .depths = swBindPlane(query, query->planes.depths),
        .velocities = swBindPlane(query, query->planes.velocities),
        .accelerations = swBindPlane(query, query->planes.accelerations),
        .stills = swBindPlane(query, query->planes.stills),
    };
    swBindVolumeQuery(gpu, commands, &state->pipeline, &bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_VOLUME_POINTS);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind == SW_GPU_QUERY_KIND_VOLUME)
        {
            recordQuery(gpuWorld, query, state, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyPipeline(gpu, &((State*)state)->pipeline);
}

const swPass swPass_volume_query = {
    .name = "volume_query",
    .stateSize = sizeof(State),
    .reads = SW_OUTPUT_BIT(SW_PASS_SURFACE_QUERY) | SW_OUTPUT_BIT(SW_PASS_VOLUME_WAVES),
    .writes = SW_OUTPUT_BIT(SW_PASS_VOLUME_QUERY),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
