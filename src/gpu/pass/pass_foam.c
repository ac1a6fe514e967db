// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices, or one for each step where water carries foam; a view whose foam stays as it
// is has none.

#include "foam_shader.h"
#include "gpu/pass/passes.h"

#define SOURCES (SW_PAST_SOURCES + 1) // a slice: of the past, and one for the fold

// What a step is told: the first, and all that follow.
typedef struct StepState
{
    swUpload params;  // swFoamSliceParams[sliceCount]
    swUpload sources; // swPastSource[sliceCount * SOURCES]
} StepState;

// Of one view, in this frame.
typedef struct ViewState
{
    StepState steps[2];
    swFoamConstants constants;
} ViewState;

typedef struct State
{
    swVariants pipelines;
    ViewState views[SW_MAX_VIEWS];
} State;

static bool isDue(const swGpuView* view)
{
    return view->isUsed && view->layers[SW_LAYER_FOAM].due.isDue;
}

static swResult uploadStep(swGpu* gpu, const swFrame* frame, const swGpuView* view, bool isFirst, StepState* step)
{
    const swStackFrame* stack = &view->frame->stack;
    bool isReset = isFirst && view->layers[SW_LAYER_FOAM].due.isReset;
    float seconds = swFindLayerSteps(view, SW_LAYER_FOAM).dt;
    swFoamSliceParams params[SW_MAX_SLICES] = {0};
    swPastSource sources[SW_MAX_SLICES][SOURCES] = {0};
    if (isFirst)
    {
        swFillPastSources(view, SW_LAYER_FOAM, SOURCES, sources[0]);
    }
    else
    {
        swFillStillSources(view, SOURCES, sources[0]);
    }
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        params[i] = swGetFoamParams(frame, stack, i, seconds, isReset);
        sources[i][SW_PAST_SOURCES] = swGetFoamBirth(stack, i).fold;
    }
    swResult result = swUploadData(gpu, params, sizeof(params), &step->params);
    return result == SW_SUCCESS ? swUploadData(gpu, sources, sizeof(sources), &step->sources) : result;
}

static swResult uploadView(swGpu* gpu, const swFrame* frame, const swGpuView* gpuView, ViewState* view)
{
    const swStackFrame* stack = &gpuView->frame->stack;
    bool isCarried = stack->layers[SW_LAYER_FOAM].isCarried;
    view->constants = (swFoamConstants){
        .withTransport = isCarried ? 1 : 0,
        .withFlow = isCarried && stack->layers[SW_LAYER_FLOW].isAuthored ? 1 : 0,
    };
    bool hasMore = swFindLayerSteps(gpuView, SW_LAYER_FOAM).count > 1;
    swResult result = uploadStep(gpu, frame, gpuView, true, &view->steps[0]);
    return result == SW_SUCCESS && hasMore ? uploadStep(gpu, frame, gpuView, false, &view->steps[1]) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isDue(&gpuWorld->views[i]))
        {
            *isNeeded = true;
            result = uploadView(gpuWorld->gpu, frame, &gpuWorld->views[i], &s->views[i]);
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isDue(&gpuWorld->views[i]))
        {
            result = swCreateVariant(gpuWorld->gpu, &swFoamShader, &s->views[i].constants, &s->pipelines);
        }
    }
    return result;
}

static void recordStep(const swGpuWorld* gpuWorld, const State* s, int index, int step, int count,
                       VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    const swGpuView* view = &gpuWorld->views[index];
    const ViewState* of = &s->views[index];
    const StepState* told = &of->steps[step == 0 ? 0 : 1];
    swBinding fields[2] = {swBindUpload(&told->params), swBindUpload(&told->params)};
    swBindFieldPlaces(gpuWorld, index, &fields[0], &fields[1]);
    const swFoamBindings bindings = {
        .slices = swBindUpload(&told->params),
        .sources = swBindUpload(&told->sources),
        .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
        .previous = swBindImage(gpu, swGetStepSource(view, SW_LAYER_FOAM, step, count), SW_SAMPLER_NEAREST_CLAMP),
        .nextFoam = swBindImage(gpu, swGetStepTarget(view, SW_LAYER_FOAM, step, count), SW_SAMPLER_NEAREST_CLAMP),
        .flow = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .flowSlopes = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
        .blocks = fields[1],
    };
    int32_t resolution = view->resolution;
    uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
    swBindFoam(gpu, commands, swFindVariant(&s->pipelines, &swFoamShader, &of->constants), &bindings, &resolution);
    gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(int32_t) == SW_FOAM_PUSH_SIZE, "what foam.comp is given");
    const State* s = state;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        int count = isDue(view) ? swFindLayerSteps(view, SW_LAYER_FOAM).count : 0;
        for (int step = 0; step < count; ++step)
        {
            if (step > 0)
            {
                swComputeBarrier(gpuWorld->gpu, commands);
            }
            recordStep(gpuWorld, s, i, step, count, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_foam = {
    .name = "foam",
    .stateSize = sizeof(State),
    .reads = SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) | SW_LAYER_BIT(SW_LAYER_FOAM) | SW_LAYER_BIT(SW_LAYER_FLOW) |
             SW_LAYER_BIT(SW_LAYER_FLOW_SLOPES) | SW_OUTPUT_BIT(SW_PASS_FIELDS),
    .writes = SW_LAYER_BIT(SW_LAYER_FOAM),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
