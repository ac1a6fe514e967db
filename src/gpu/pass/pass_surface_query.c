// SPDX-License-Identifier: MIT
// One dispatch a query of the surface or of the water below it; nothing waits between queries.

#include "gpu/pass/passes.h"
#include "gpu/pass/query_passes.h"
#include "surface_query_shader.h"

typedef struct State
{
    swVariants pipelines; // without and with velocity or acceleration, and inputs
} State;

// Of a query of the water below, only the surface's heights are wanted here.
static swSurfaceQueryConstants constantsOf(const swGpuWorld* gpuWorld, const swGpuQuery* query)
{
    bool isSurface = query->def.kind == SW_GPU_QUERY_KIND_SURFACE;
    bool hasMotion = (query->def.outputs & (SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION)) != 0;
    return (swSurfaceQueryConstants){.withMotion = isSurface && hasMotion ? 1 : 0,
                                     .withInputs = gpuWorld->inputs.isAuthored ? 1 : 0,
                                     .withFlow = gpuWorld->inputs.hasFlow ? 1 : 0,
                                     .withDisplacement = gpuWorld->inputs.hasDisplacement ? 1 : 0,
                                     .withRibbons = gpuWorld->inputs.hasRibbons ? 1 : 0};
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    (void)state;
    *isNeeded = swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_SURFACE) || swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_VOLUME);
    return SW_SUCCESS;
}

// Also of queries that rest: they may ask at any time.
static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL && result == SW_SUCCESS; query = query->next)
    {
        if (query->def.kind != SW_GPU_QUERY_KIND_RAYS)
        {
            swSurfaceQueryConstants constants = constantsOf(gpuWorld, query);
            result = swCreateVariant(gpuWorld->gpu, &swSurfaceQueryShader, &constants, &s->pipelines);
        }
    }
    return result;
}

static void recordQuery(const swGpuWorld* gpuWorld, const swGpuQuery* query, const State* state,
                        VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    static_assert(sizeof(swQueryParams) == SW_SURFACE_QUERY_PUSH_SIZE, "what surface_query.comp is given");
    swQueryParams params = query->params;
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    const swSurfaceQueryBindings bindings = {
        .tiles = swBindUpload(&query->tiles),
        .waves = swBindUpload(&query->waves),
        .texels = swBindBuffer(&gpuWorld->tiles.texels),
        .points = swBindPoints(query, &params.source),
        .heights = swBindPlane(query, query->planes.heights),
        .sideways = swBindPlane(query, query->planes.sideways),
        .normals = swBindPlane(query, query->planes.normals),
        .velocities = swBindPlane(query, query->planes.velocities),
        .accelerations = swBindPlane(query, query->planes.accelerations),
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .likeness = swBindLikeness(gpuWorld),
        .stills = swBindPlane(query, query->planes.stills),
    };
    swSurfaceQueryConstants constants = constantsOf(gpuWorld, query);
    const swPipeline* pipeline = swFindVariant(&state->pipelines, &swSurfaceQueryShader, &constants);
    swBindSurfaceQuery(gpu, commands, pipeline, &bindings, &params);
    swDispatchPoints(gpu, commands, query, SW_QUERY_POINTS);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0 && query->def.kind != SW_GPU_QUERY_KIND_RAYS)
        {
            recordQuery(gpuWorld, query, state, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_surface_query = {
    .name = "surface_query",
    .stateSize = sizeof(State),
    .reads = SW_TEXELS_BIT | SW_MODES_BIT | SW_INPUTS_BIT,
    .writes = SW_OUTPUT_BIT(SW_PASS_SURFACE_QUERY),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
