// SPDX-License-Identifier: MIT
// One dispatch for each of the two layers of a view that inputs and shores make foam in, or one for each of its steps
// where water carries foam.

#include "gpu/pass/passes.h"
#include "made_foam_shader.h"

#define SW_MADE_FOAMS 2

static const int madeLayers[SW_MADE_FOAMS] = {SW_LAYER_WAKE_FOAM, SW_LAYER_SHORE_FOAM};

// What a step is told: the first, and all that follow.
typedef struct StepState
{
    swUpload params;  // swMadeFoamParams
    swUpload sources; // swPastSource[sliceCount * SW_PAST_SOURCES]
} StepState;

// Of one layer of a view, in this frame.
typedef struct LayerState
{
    StepState steps[2];
    swMadeFoamConstants constants;
} LayerState;

typedef struct ViewState
{
    swUpload slices; // swFieldSlice[sliceCount]
    LayerState layers[SW_MADE_FOAMS];
} ViewState;

typedef struct State
{
    swVariants pipelines;
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

static swResult uploadStep(swGpu* gpu, const swFrame* frame, const swGpuView* view, int layer, bool isFirst,
                           StepState* step)
{
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES] = {0};
    if (isFirst)
    {
        swFillPastSources(view, layer, SW_PAST_SOURCES, sources[0]);
    }
    else
    {
        swFillStillSources(view, SW_PAST_SOURCES, sources[0]);
    }
    float seconds = swFindLayerSteps(view, layer).dt;
    bool isReset = isFirst && view->layers[layer].due.isReset;
    swMadeFoamParams params = swGetMadeFoamParams(frame, layer, seconds, isReset);
    swResult result = swUploadData(gpu, sources, sizeof(sources), &step->sources);
    return result == SW_SUCCESS ? swUploadData(gpu, &params, sizeof(params), &step->params) : result;
}

static swResult uploadLayer(swGpu* gpu, const swFrame* frame, const swGpuView* view, int layer, LayerState* state)
{
    const swStackFrame* stack = &view->frame->stack;
    bool isCarried = stack->layers[layer].isCarried;
    state->constants = (swMadeFoamConstants){
        .withInputs = swHasInputs(frame->inputs, SW_INPUT_FOAM) ? 1 : 0,
        .withTransport = isCarried ? 1 : 0,
        .withFlow = isCarried && stack->layers[SW_LAYER_FLOW].isAuthored ? 1 : 0,
    };
    bool hasMore = swFindLayerSteps(view, layer).count > 1;
    swResult result = uploadStep(gpu, frame, view, layer, true, &state->steps[0]);
    return result == SW_SUCCESS && hasMore ? uploadStep(gpu, frame, view, layer, false, &state->steps[1]) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
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
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS * SW_MADE_FOAMS && result == SW_SUCCESS; ++i)
    {
        const LayerState* layer = &s->views[i / SW_MADE_FOAMS].layers[i % SW_MADE_FOAMS];
        if (isDue(&gpuWorld->views[i / SW_MADE_FOAMS], i % SW_MADE_FOAMS))
        {
            result = swCreateVariant(gpuWorld->gpu, &swMadeFoamShader, &layer->constants, &s->pipelines);
        }
    }
    return result;
}

static void recordStep(const swGpuWorld* gpuWorld, const State* s, int index, int kind, int step, int count,
                       VkCommandBuffer commands)
{
    static_assert(sizeof(int32_t) == SW_MADE_FOAM_PUSH_SIZE, "what made_foam.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swGpuView* view = &gpuWorld->views[index];
    const LayerState* layer = &s->views[index].layers[kind];
    const StepState* told = &layer->steps[step == 0 ? 0 : 1];
    int made = madeLayers[kind];
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    swBinding fields[2] = {swBindUpload(&s->views[index].slices), swBindUpload(&s->views[index].slices)};
    swBindFieldPlaces(gpuWorld, index, &fields[0], &fields[1]);
    const swMadeFoamBindings bindings = {
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .slices = swBindUpload(&s->views[index].slices),
        .sources = swBindUpload(&told->sources),
        .params = swBindUpload(&told->params),
        .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
        .places = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .previous = swBindImage(gpu, swGetStepSource(view, made, step, count), SW_SAMPLER_NEAREST_CLAMP),
        .nextFoam = swBindImage(gpu, swGetStepTarget(view, made, step, count), SW_SAMPLER_NEAREST_CLAMP),
        .flow = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .flowSlopes = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
        .blocks = fields[1],
    };
    int32_t resolution = view->resolution;
    uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
    swBindMadeFoam(gpu, commands, swFindVariant(&s->pipelines, &swMadeFoamShader, &layer->constants), &bindings,
                   &resolution);
    gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (int i = 0; i < SW_MAX_VIEWS * SW_MADE_FOAMS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i / SW_MADE_FOAMS];
        int kind = i % SW_MADE_FOAMS;
        int count = isDue(view, kind) ? swFindLayerSteps(view, madeLayers[kind]).count : 0;
        for (int step = 0; step < count; ++step)
        {
            if (step > 0)
            {
                swComputeBarrier(gpuWorld->gpu, commands);
            }
            recordStep(gpuWorld, state, i / SW_MADE_FOAMS, kind, step, count, commands);
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
    .reads = SW_INPUTS_BIT | SW_LAYER_BIT(SW_LAYER_PLACES) | SW_LAYER_BIT(SW_LAYER_FLOW) |
             SW_LAYER_BIT(SW_LAYER_FLOW_SLOPES) | SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) |
             SW_LAYER_BIT(SW_LAYER_WAKE_FOAM) | SW_LAYER_BIT(SW_LAYER_SHORE_FOAM) | SW_OUTPUT_BIT(SW_PASS_FIELDS),
    .writes = SW_LAYER_BIT(SW_LAYER_WAKE_FOAM) | SW_LAYER_BIT(SW_LAYER_SHORE_FOAM),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
