// SPDX-License-Identifier: MIT
#include "core/world/world.h"

#include <string.h>

#include "core/base/host.h"
#include "core/surface/slices.h"

static size_t countTexels(const swViewDef* def)
{
    return (size_t)def->sliceCount * (size_t)def->resolution * (size_t)def->resolution;
}

static void freeLayers(swView* view)
{
    const swHost* host = &view->world->memory.host;
    size_t texels = countTexels(&view->def);
    swFree(host, view->displacement, texels * 4 * sizeof(float));
    swFree(host, view->derivatives, texels * 4 * sizeof(float));
    swFree(host, view->foam[0], texels * sizeof(float));
    swFree(host, view->foam[1], texels * sizeof(float));
}

static bool allocateLayers(swView* view)
{
    const swHost* host = &view->world->memory.host;
    size_t texels = countTexels(&view->def);
    view->displacement = swAllocateZero(host, texels * 4 * sizeof(float));
    view->derivatives = swAllocateZero(host, texels * 4 * sizeof(float));
    view->foam[0] = swAllocateZero(host, texels * sizeof(float));
    view->foam[1] = swAllocateZero(host, texels * sizeof(float));
    return view->displacement != NULL && view->derivatives != NULL && view->foam[0] != NULL && view->foam[1] != NULL;
}

swResult swAddView(swWorld* world, const swViewDef* def, swView** viewOut)
{
    if (world->viewCount == SW_MAX_VIEWS)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "the world has %d views, which is the most", SW_MAX_VIEWS);
    }
    swView* view = swAllocateZero(&world->memory.host, sizeof *view);
    if (view == NULL)
    {
        return swFailMemory(&world->memory, "a view");
    }
    view->world = world;
    view->def = *def;
    view->viewpoint = (swPos){0.0, world->def.seaLevel, 0.0};
    view->stack = swMakeStack(def);
    if (def->enableCpuLayers && !allocateLayers(view))
    {
        freeLayers(view);
        swFree(&world->memory.host, view, sizeof *view);
        return swFailMemory(&world->memory, "the layers of a view's slices");
    }
    world->viewVersion += 1;
    view->version = world->viewVersion;
    world->views[world->viewCount] = view;
    world->viewCount += 1;
    *viewOut = view;
    return SW_SUCCESS;
}

void swRemoveView(swView* view)
{
    swWorld* world = view->world;
    int index = 0;
    while (world->views[index] != view)
    {
        index += 1;
    }
    int after = world->viewCount - index - 1;
    memmove(&world->views[index], &world->views[index + 1], (size_t)after * sizeof world->views[0]);
    world->viewCount -= 1;
    // Frames of views come first and in order; a view made since the last step has none yet.
    if (index < world->frame.viewCount)
    {
        int framesAfter = world->frame.viewCount - index - 1;
        memmove(&world->viewFrames[index], &world->viewFrames[index + 1],
                (size_t)framesAfter * sizeof world->viewFrames[0]);
        world->frame.viewCount -= 1;
    }
    freeLayers(view);
    swFree(&world->memory.host, view, sizeof *view);
}

swViewFrame* swFindViewFrame(const swView* view)
{
    swWorld* world = view->world;
    for (int i = 0; i < world->frame.viewCount; ++i)
    {
        if (world->viewFrames[i].view == view)
        {
            return &world->viewFrames[i];
        }
    }
    return NULL;
}

static void placeView(swWorld* world, int64_t elapsedTicks, swView* view, swViewFrame* frame)
{
    bool isFirst = !view->stack.isPlaced;
    swSlice previous[SW_MAX_SLICES];
    memcpy(previous, view->stack.slices, sizeof previous);
    swPlaceStack(&view->stack, view->viewpoint, world->def.seaLevel);
    *frame = (swViewFrame){
        .view = view,
        .viewVersion = view->version,
        .sliceCount = view->def.sliceCount,
        .resolution = view->def.resolution,
        .viewpoint = view->viewpoint,
        .fade = view->stack.fade,
        .scaleLevel = view->stack.scaleLevel,
        .displacement = view->displacement,
        .derivatives = view->derivatives,
    };
    memcpy(frame->slices, view->stack.slices, sizeof frame->slices);
    memcpy(frame->previousSlices, isFirst ? view->stack.slices : previous, sizeof frame->previousSlices);
    swPlanFoam(&view->foamState, elapsedTicks, frame);
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        swFindFoamSources(&frame->slices[i], frame->resolution, frame->sliceCount, frame->previousSlices,
                          frame->foamSources[i]);
    }
    swPlanFoamBirth(&world->frame, frame);
    frame->foamAtRest = world->frame.foamLaw.cover;
}

void swPlaceViews(swWorld* world, int64_t elapsedTicks)
{
    for (int i = 0; i < world->viewCount; ++i)
    {
        placeView(world, elapsedTicks, world->views[i], &world->viewFrames[i]);
    }
    world->frame.viewCount = world->viewCount;
}

void swStepLayers(swWorld* world)
{
    for (int i = 0; i < world->viewCount; ++i)
    {
        swView* view = world->views[i];
        swViewFrame* frame = &world->viewFrames[i];
        if (!view->def.enableCpuLayers)
        {
            continue;
        }
        swSampleSlices(&world->host, world->kernels, &world->frame, frame, view->displacement, view->derivatives);
        const float* previous = view->foam[view->foamIndex];
        view->foamIndex ^= 1;
        swStepFoam(&world->host, &world->frame, frame, previous, view->foam[view->foamIndex]);
        frame->foam = view->foam[view->foamIndex];
    }
}
