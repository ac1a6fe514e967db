// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; a view whose foam stays as it is has none.

#include "foam_shader.h"
#include "gpu/pass/passes.h"

// Of one view, in this frame.
typedef struct ViewState
{
    swUpload params;  // swFoamSliceParams[sliceCount]
    swUpload sources; // swPastSource[sliceCount * (SW_PAST_SOURCES + 1)]
} ViewState;

typedef struct State
{
    swPipeline pipeline;
    ViewState views[SW_MAX_VIEWS];
} State;

static bool isDue(const swGpuView* view)
{
    return view->isUsed && view->layers[SW_LAYER_FOAM].due.isDue;
}

static swResult uploadView(swGpu* gpu, const swFrame* frame, const swGpuView* gpuView, ViewState* view)
{
    const swStackFrame* stack = &gpuView->frame->stack;
    const swGpuLayer* foam = &gpuView->layers[SW_LAYER_FOAM];
    float seconds = (float)foam->due.steps / (float)SW_FOAM_RATE;
    swFoamSliceParams params[SW_MAX_SLICES] = {0};
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES + 1] = {0};
    swFillPastSources(gpuView, SW_LAYER_FOAM, SW_PAST_SOURCES + 1, sources[0]);
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        params[i] = swGetFoamParams(frame, stack, i, seconds, foam->due.isReset);
        sources[i][SW_PAST_SOURCES] = swGetFoamBirth(stack, i).fold;
    }
    swResult result = swUploadData(gpu, params, sizeof(params), &view->params);
    return result == SW_SUCCESS ? swUploadData(gpu, sources, sizeof(sources), &view->sources) : result;
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
    return swCreateOnce(gpuWorld->gpu, &swFoamShader, &((State*)state)->pipeline);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(int32_t) == SW_FOAM_PUSH_SIZE, "what foam.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const State* s = state;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (!isDue(view))
        {
            continue;
        }
        const swImage* displacement = swGetLayerImage(view, SW_LAYER_DISPLACEMENT);
        const swFoamBindings bindings = {
            .slices = swBindUpload(&s->views[i].params),
            .sources = swBindUpload(&s->views[i].sources),
            .displacement = swBindImage(gpu, displacement, SW_SAMPLER_NEAREST_CLAMP),
            .previous = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
            .nextFoam = swBindImage(gpu, swGetNextLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
        };
        int32_t resolution = view->resolution;
        uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
        swBindFoam(gpu, commands, &s->pipeline, &bindings, &resolution);
        gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyPipeline(gpu, &((State*)state)->pipeline);
}

const swPass swPass_foam = {
    .name = "foam",
    .stateSize = sizeof(State),
    .reads = SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) | SW_LAYER_BIT(SW_LAYER_FOAM),
    .writes = SW_LAYER_BIT(SW_LAYER_FOAM),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
