// SPDX-License-Identifier: MIT
#include "core/world/view_save.h"

#include <math.h>

static void streamPlace(swStream* stream, swPos* place)
{
    swStreamF64(stream, &place->x);
    swStreamF64(stream, &place->y);
    swStreamF64(stream, &place->z);
    const double farthest = SW_FARTHEST_VIEWPOINT + SW_FARTHEST_ORIGIN; // it counts from the sea's origin
    bool isNear = fabs(place->x) <= farthest && fabs(place->y) <= farthest && fabs(place->z) <= farthest;
    stream->isBroken = stream->isBroken || !isNear;
}

void swStreamViewState(swStream* stream, int maxScaleLevel, swViewState* state)
{
    streamPlace(stream, &state->viewpoint);
    streamPlace(stream, &state->last);
    swStreamBool(stream, &state->isPlaced);
    swStreamBool(stream, &state->hasFields);
    swStreamRange(stream, &state->scaleLevel, 0, maxScaleLevel);
}

static swViewState getViewState(const swView* view)
{
    const swViewFrame* frame = swFindViewFrame(view);
    return (swViewState){
        .viewpoint = view->viewpoint,
        .last = frame != NULL ? frame->viewpoint : view->viewpoint,
        .isPlaced = view->layers.stack.isPlaced,
        .hasFields = swHasFieldTexels(&view->layers),
        .scaleLevel = view->layers.stack.scaleLevel,
    };
}

// Slices are those of the last step, where the next one finds the past of layers.
void swSetViewState(swView* view, const swViewState* state)
{
    swStack* stack = &view->layers.stack;
    view->viewpoint = state->viewpoint;
    stack->isPlaced = state->isPlaced;
    stack->scaleLevel = state->scaleLevel;
    if (state->isPlaced)
    {
        swPlaceStack(stack, state->last, view->world->def.seaLevel);
    }
}

static swResult streamOneView(swWorld* world, swStream* stream, int index, swPos* last)
{
    swView* view = swIsReading(stream) ? NULL : world->views[index];
    swViewDef def = view != NULL ? view->def : swDefaultViewDef();
    swViewState state = view != NULL ? getViewState(view) : (swViewState){.isPlaced = false};
    swStreamDef(stream, &swViewFields, &def);
    if (swIsReading(stream))
    {
        // Before memory for layers is asked for: what is saved of them must be there.
        bool isFine = !stream->isBroken && swCheckViewDef(&world->host, &def, world->def.enableQueries) == SW_SUCCESS;
        const swLayerStack layers = isFine ? swDescribeViewLayers(&def) : (swLayerStack){.hasTexels = false};
        isFine = isFine && swStreamHasLeft(stream, swCountSavedFloats(&layers), sizeof(float));
        swResult result = isFine ? swAddView(world, &def, &view) : SW_ERROR_FORMAT;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    swStreamViewState(stream, def.maxScaleLevel, &state);
    bool isMissing = swIsReading(stream) && state.hasFields && !stream->isBroken;
    if (isMissing && !swMakeFieldTexels(&world->memory.host, &view->layers))
    {
        return swFailMemory(&world->memory, "the authored layers of a view's slices");
    }
    swStreamLayers(stream, &view->layers);
    if (stream->isBroken)
    {
        return SW_ERROR_FORMAT;
    }
    *last = state.last;
    if (swIsReading(stream))
    {
        swSetViewState(view, &state);
    }
    return SW_SUCCESS;
}

swResult swStreamViews(swWorld* world, swStream* stream, swPos last[SW_MAX_VIEWS])
{
    int count = world->viewCount;
    swStreamRange(stream, &count, 0, SW_MAX_VIEWS);
    for (int i = 0; i < count; ++i)
    {
        swResult result = streamOneView(world, stream, i, &last[i]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}
