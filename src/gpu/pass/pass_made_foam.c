// SPDX-License-Identifier: MIT
// One dispatch for each of the two layers of a view that inputs and shores make foam in.

#include "gpu/pass/passes.h"
#include "made_foam_shader.h"

#define SW_MADE_FOAMS 2

static const int madeLayers[SW_MADE_FOAMS] = {SW_LAYER_WAKE_FOAM, SW_LAYER_SHORE_FOAM};

// Of one layer of a view, in this frame.
typedef struct LayerState
{
    swUpload params;  // swMadeFoamParams
    swUpload sources; // swPastSource[sliceCount * SW_PAST_SOURCES]
} LayerState;

typedef struct ViewState
{
    swUpload slices; // swFieldSlice[sliceCount]
    LayerState layers[SW_MADE_FOAMS];
} ViewState;

typedef struct State
{
    swVariants pipelines;
    swMadeFoamConstants constants; // of this frame
    ViewState views[SW_MAX_VIEWS];
} State;

static bool isDue(const swGpuView* view, int i)
{
    return view->isUsed && view->layers[madeLayers[i]].due.isDue;
}

static swResult uploadSlices(swGpu* gpu, const swGpuView* gpuView, ViewState* view)
{
    swFieldSlice slices[SW_MAX_SLICES] = {0};
    swFillFieldSlices(&gpuView->frame->stack, slices);
    return swUploadData(gpu, slices, sizeof(slices), &view->slices);
}

static swResult uploadLayer(swGpu* gpu, const swFrame* frame, const swGpuView* gpuView, int layer, LayerState* state)
{
    const swGpuLayer* foam = &gpuView->layers[layer];
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES] = {0};
    swFillPastSources(gpuView, layer, SW_PAST_SOURCES, sources[0]);
    float seconds = (float)foam->due.steps / (float)SW_FOAM_RATE;
    swMadeFoamParams params = swGetMadeFoamParams(frame, layer, seconds, foam->due.isReset);
    swResult result = swUploadData(gpu, sources, sizeof(sources), &state->sources);
    return result == SW_SUCCESS ? swUploadData(gpu, &params, sizeof(params), &state->params) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    s->constants.withInputs = swHasInputs(frame->inputs, SW_INPUT_FOAM) ? 1 : 0;
    for (int i = 0; i < SW_MAX_VIEWS * SW_MADE_FOAMS && result == SW_SUCCESS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i / SW_MADE_FOAMS];
        int kind = i % SW_MADE_FOAMS;
        ViewState* of = &s->views[i / SW_MADE_FOAMS];
        if (isDue(view, kind))
        {
            *isNeeded = true;
            result = uploadSlices(gpuWorld->gpu, view, of);
            result = result == SW_SUCCESS ? uploadLayer(gpuWorld->gpu, frame, view, madeLayers[kind], &of->layers[kind])
                                          : result;
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    return swCreateVariant(gpuWorld->gpu, &swMadeFoamShader, &s->constants, &s->pipelines);
}

static void recordLayer(const swGpuWorld* gpuWorld, const State* s, int index, int kind, VkCommandBuffer commands)
{
    static_assert(sizeof(int32_t) == SW_MADE_FOAM_PUSH_SIZE, "what made_foam.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swGpuView* view = &gpuWorld->views[index];
    const LayerState* layer = &s->views[index].layers[kind];
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    const swMadeFoamBindings bindings = {
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .slices = swBindUpload(&s->views[index].slices),
        .sources = swBindUpload(&layer->sources),
        .params = swBindUpload(&layer->params),
        .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
        .places = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .previous = swBindImage(gpu, swGetLayerImage(view, madeLayers[kind]), SW_SAMPLER_NEAREST_CLAMP),
        .nextFoam = swBindImage(gpu, swGetNextLayerImage(view, madeLayers[kind]), SW_SAMPLER_NEAREST_CLAMP),
    };
    int32_t resolution = view->resolution;
    uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
    swBindMadeFoam(gpu, commands, swFindVariant(&s->pipelines, &swMadeFoamShader, &s->constants), &bindings,
                   &resolution);
    gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (int i = 0; i < SW_MAX_VIEWS * SW_MADE_FOAMS; ++i)
    {
        if (isDue(&gpuWorld->views[i / SW_MADE_FOAMS], i % SW_MADE_FOAMS))
        {
            recordLayer(gpuWorld, state, i / SW_MADE_FOAMS, i % SW_MADE_FOAMS, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_made_foam = {
    .name = "made_foam",
    .stateSize = sizeof(State),
    .reads = SW_INPUTS_BIT | SW_LAYER_BIT(SW_LAYER_PLACES) | SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) |
             SW_LAYER_BIT(SW_LAYER_WAKE_FOAM) | SW_LAYER_BIT(SW_LAYER_SHORE_FOAM),
    .writes = SW_LAYER_BIT(SW_LAYER_WAKE_FOAM) | SW_LAYER_BIT(SW_LAYER_SHORE_FOAM),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
