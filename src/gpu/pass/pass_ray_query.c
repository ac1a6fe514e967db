// SPDX-License-Identifier: MIT
// One dispatch a query of rays; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "gpu/pass/query_passes.h"
#include "ray_query_shader.h"

typedef struct State
{
    swVariants pipelines; // without and with inputs, and waves along splines
} State;

static swRayQueryConstants constantsOf(const swGpuWorld* gpuWorld)
{
    return (swRayQueryConstants){.withInputs = gpuWorld->inputs.isAuthored ? 1 : 0,
                                 .withFlow = gpuWorld->inputs.hasFlow ? 1 : 0,
                                 .withDisplacement = gpuWorld->inputs.hasDisplacement ? 1 : 0,
                                 .withRibbons = gpuWorld->inputs.hasRibbons ? 1 : 0};
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    (void)state;
    *isNeeded = swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_RAYS);
    return SW_SUCCESS;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    swRayQueryConstants constants = constantsOf(gpuWorld);
    return swCreateVariant(gpuWorld->gpu, &swRayQueryShader, &constants, &((State*)state)->pipelines);
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, const State* state,
                        VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    static_assert(sizeof(swRayParams) == SW_RAY_QUERY_PUSH_SIZE, "what ray_query.comp is given");
    swRayParams params = query->rays;
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    const swRayQueryBindings bindings = {
        .tiles = swBindUpload(&query->tiles),
        .waves = swBindUpload(&query->waves),
        .texels = swBindBuffer(&gpuWorld->tiles.texels),
        .points = swBindPoints(query, &params.source),
        .heights = swBindPlane(query, query->planes.heights),
        .hits = swBindPlane(query, query->planes.hits),
        .normals = swBindPlane(query, query->planes.normals),
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .likeness = swBindLikeness(gpuWorld),
    };
    swRayQueryConstants constants = constantsOf(gpuWorld);
    const swPipeline* pipeline = swFindVariant(&state->pipelines, &swRayQueryShader, &constants);
    swBindRayQuery(gpu, commands, pipeline, &bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_QUERY_POINTS);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind == SW_GPU_QUERY_KIND_RAYS)
        {
            recordQuery(gpuWorld, query, state, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_ray_query = {
    .name = "ray_query",
    .stateSize = sizeof(State),
    .reads = SW_TEXELS_BIT | SW_MODES_BIT | SW_INPUTS_BIT,
    .writes = SW_OUTPUT_BIT(SW_PASS_RAY_QUERY),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
