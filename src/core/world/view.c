// SPDX-License-Identifier: MIT
#include "core/world/world.h"

#include <string.h>

#include "core/base/host.h"

swLayerStack swDescribeViewLayers(const swViewDef* def)
{
    return (swLayerStack){.stack = swMakeStack(def), .hasTexels = def->enableCpuLayers};
}

swResult swMakeViewFields(swWorld* world)
{
    for (int i = 0; i < world->viewCount; ++i)
    {
        if (!swMakeFieldTexels(&world->memory.host, &world->views[i]->layers))
        {
            return swFailMemory(&world->memory, "the authored layers of a view's slices");
        }
    }
    return SW_SUCCESS;
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
    view->layers = swDescribeViewLayers(def);
    bool isMade = swMakeLayers(&world->memory.host, &view->layers);
    if (isMade && world->inputs.count > 0 && !swMakeFieldTexels(&world->memory.host, &view->layers))
    {
        swFreeLayers(&world->memory.host, &view->layers);
        isMade = false;
    }
    if (!isMade)
    {
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
    swFreeLayers(&world->memory.host, &view->layers);
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

// A view at a place in the sea, and its frame. Of no elapsed time nothing is advanced.
static void placeView(swWorld* world, swView* view, swPos place, int64_t elapsedTicks, swViewFrame* frame)
{
    swPlaceLayers(&view->layers, place, world->def.seaLevel, elapsedTicks, &frame->stack);
    frame->view = view;
    frame->viewVersion = view->version;
    frame->viewpoint = place;
    frame->fade = view->layers.stack.fade;
    frame->scaleLevel = view->layers.stack.scaleLevel;
    swPlanLayers(world, &view->layers, &frame->stack);
}

static void makeLayers(swWorld* world)
{
    for (int i = 0; i < world->frame.viewCount; ++i)
    {
        if (world->views[i]->def.enableCpuLayers)
        {
            swMakeFrameLayers(world, &world->views[i]->layers, &world->viewFrames[i].stack);
        }
    }
}

void swStepViews(swWorld* world, int64_t elapsedTicks)
{
    for (int i = 0; i < world->viewCount; ++i)
    {
        placeView(world, world->views[i], world->views[i]->viewpoint, elapsedTicks, &world->viewFrames[i]);
    }
    world->frame.viewCount = world->viewCount;
    makeLayers(world);
}

void swDeriveViews(swWorld* world, const swPos places[SW_MAX_VIEWS])
{
    world->frame.viewCount = 0;
    for (int i = 0; i < world->viewCount && world->views[i]->layers.stack.isPlaced; ++i)
    {
        placeView(world, world->views[i], places[i], 0, &world->viewFrames[i]);
        world->frame.viewCount = i + 1;
    }
    makeLayers(world);
}
