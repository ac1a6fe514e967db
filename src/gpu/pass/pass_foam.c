// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; a view whose foam stays as it is has none.

#include <string.h>

#include "foam_shader.h"
#include "gpu/pass/passes.h"

// Of one view, in this frame.
typedef struct ViewState
{
    bool moves;       // there is something to do
    swUpload params;  // swFoamSliceParams[sliceCount]
    swUpload sources; // swFoamSource[sliceCount * (SW_FOAM_SOURCES + 1)]
} ViewState;

typedef struct State
{
    swPipeline pipeline;
    ViewState views[SW_MAX_VIEWS];
} State;

static bool slicesMoved(const swLayerMark* mark, const swViewFrame* frame)
{
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        const swSlice* a = &mark->slices[i];
        const swSlice* b = &frame->slices[i];
        if (a->level != b->level || a->firstX != b->firstX || a->firstZ != b->firstZ)
        {
            return true;
        }
    }
    return false;
}

static swResult uploadView(swGpuWorld* gpuWorld, const swFrame* frame, const swGpuView* gpuView, ViewState* view)
{
    const swViewFrame* viewFrame = gpuView->frame;
    const swLayerMark* mark = &gpuView->layers[SW_LAYER_FOAM].mark;
    int64_t passed = viewFrame->foamClock - mark->clock;
    bool isSteady = !mark->isHeld || mark->resetCount != viewFrame->foamResetCount || passed < -SW_FOAM_RATE;
    int64_t steps = isSteady || passed < 0 ? 0 : passed; // a world that went back a little meets its foam again
    view->moves = isSteady || steps != 0 || slicesMoved(mark, viewFrame);
    if (!view->moves)
    {
        return SW_SUCCESS;
    }
    float seconds = (float)steps / (float)SW_FOAM_RATE;
    swFoamSliceParams params[SW_MAX_SLICES] = {0};
    swFoamSource sources[SW_MAX_SLICES][SW_FOAM_SOURCES + 1] = {0};
    for (int i = 0; i < viewFrame->sliceCount; ++i)
    {
        params[i] = swGetFoamParams(frame, viewFrame, i, seconds, isSteady);
        swFindFoamSources(&viewFrame->slices[i], viewFrame->resolution, isSteady ? 0 : viewFrame->sliceCount,
                          mark->slices, sources[i]);
        sources[i][SW_FOAM_SOURCES] = viewFrame->foamBirth[i].fold;
    }
    swResult result = swUploadData(gpuWorld->gpu, params, sizeof(params), &view->params);
    return result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, sources, sizeof(sources), &view->sources) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        s->views[i].moves = false;
        if (view->isUsed && !view->isCore)
        {
            result = uploadView(gpuWorld, frame, view, &s->views[i]);
            *isNeeded = *isNeeded || s->views[i].moves;
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
        if (!s->views[i].moves)
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

static void commit(swGpuWorld* gpuWorld, const swFrame* frame, void* state)
{
    (void)frame;
    const State* s = state;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &gpuWorld->views[i];
        if (!s->views[i].moves)
        {
            continue;
        }
        const swViewFrame* viewFrame = view->frame;
        const swLayerMark* before = &view->layers[SW_LAYER_FOAM].mark;
        bool isBehind = before->resetCount == viewFrame->foamResetCount && before->clock > viewFrame->foamClock &&
                        before->clock - viewFrame->foamClock <= SW_FOAM_RATE;
        swLayerMark mark = {
            .isHeld = true,
            .frameIndex = gpuWorld->frameIndex,
            .clock = isBehind ? before->clock : viewFrame->foamClock,
            .resetCount = viewFrame->foamResetCount,
        };
        memcpy(mark.slices, viewFrame->slices, sizeof(mark.slices));
        swTurnLayer(view, SW_LAYER_FOAM, &mark);
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
    .commit = commit,
    .destroy = destroy,
};
