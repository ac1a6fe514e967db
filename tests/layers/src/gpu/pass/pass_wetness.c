// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; a view whose wetness stays as it is has none.

#include "gpu/pass/passes.h"
#include "shared/wetness.h"
#include "wetness_shader.h"

// Of one view, in this frame.
typedef struct ViewState
{
    swUpload params;  // swWetnessParams[sliceCount]
    swUpload sources; // swPastSource[sliceCount * SW_PAST_SOURCES]
} ViewState;

typedef struct State
{
    swPipeline pipeline;
    ViewState views[SW_MAX_VIEWS];
} State;

static bool isDue(const swGpuView* view)
{
    return view->isUsed && view->layers[SW_LAYER_INDEX_WETNESS].due.isDue;
}

// The core's parameters, but for the time that has passed since this device's last step.
static swResult uploadView(swGpu* gpu, const swGpuView* gpuView, ViewState* view)
{
    const swStackFrame* stack = &gpuView->frame->stack;
    const swLayerCatchUp* due = &gpuView->layers[SW_LAYER_INDEX_WETNESS].due;
    swWetnessParams params[SW_MAX_SLICES] = {0};
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES] = {0};
    swFillPastSources(gpuView, SW_LAYER_INDEX_WETNESS, SW_PAST_SOURCES, sources[0]);
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        memcpy(&params[i], stack->layers[SW_LAYER_INDEX_WETNESS].params[i], sizeof(params[i]));
        params[i].dt = (float)due->steps / (float)swGetLayerInfo(SW_LAYER_INDEX_WETNESS)->rate;
        params[i].isDry = due->isReset ? 1 : 0;
    }
    swResult result = swUploadData(gpu, params, sizeof(params), &view->params);
    return result == SW_SUCCESS ? swUploadData(gpu, sources, sizeof(sources), &view->sources) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    (void)frame;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isDue(&gpuWorld->views[i]))
        {
            *isNeeded = true;
            result = uploadView(gpuWorld->gpu, &gpuWorld->views[i], &s->views[i]);
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    return swCreateOnce(gpuWorld->gpu, &swWetnessShader, &((State*)state)->pipeline);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(int32_t) == SW_WETNESS_PUSH_SIZE, "what wetness.comp is given");
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
        const swImage* previous = swGetLayerImage(view, SW_LAYER_INDEX_WETNESS);
        const swImage* next = swGetNextLayerImage(view, SW_LAYER_INDEX_WETNESS);
        const swWetnessBindings bindings = {
            .slices = swBindUpload(&s->views[i].params),
            .sources = swBindUpload(&s->views[i].sources),
            .displacement = swBindImage(gpu, displacement, SW_SAMPLER_NEAREST_CLAMP),
            .previous = swBindImage(gpu, previous, SW_SAMPLER_NEAREST_CLAMP),
            .nextWetness = swBindImage(gpu, next, SW_SAMPLER_NEAREST_CLAMP),
        };
        int32_t resolution = view->resolution;
        uint32_t blocks = (uint32_t)resolution / 16;
        swBindWetness(gpu, commands, &s->pipeline, &bindings, &resolution);
        gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyPipeline(gpu, &((State*)state)->pipeline);
}

const swPass swPass_wetness = {
    .name = "wetness",
    .stateSize = sizeof(State),
    .reads = SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) | SW_LAYER_BIT(SW_LAYER_INDEX_WETNESS),
    .writes = SW_LAYER_BIT(SW_LAYER_INDEX_WETNESS),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
