// SPDX-License-Identifier: MIT
#include "core/world/view_save.h"

#include <math.h>

#include "core/waves/waves_save.h"

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
    swStreamRange(stream, &state->scaleLevel, 0, maxScaleLevel);
    swFoamClock* foam = &state->foam;
    swStreamBool(stream, &foam->isRunning);
    swStreamI64(stream, &foam->remainder);
    swStreamI64(stream, &foam->clock);
    swStreamU32(stream, &foam->resetCount);
    bool isClock = foam->remainder >= 0 && foam->remainder < (int64_t)SW_TICKS_PER_SECOND && foam->clock >= 0 &&
                   foam->clock <= SW_LARGEST_TICKS;
    stream->isBroken = stream->isBroken || !isClock;
}

size_t swCountSavedTexels(const swViewDef* def)
{
    return def->enableCpuLayers ? (size_t)def->sliceCount * (size_t)def->resolution * (size_t)def->resolution : 0;
}

void swStreamViewFoam(swStream* stream, size_t texels, float* foam)
{
    for (size_t i = 0; i < texels && !stream->isBroken; ++i)
    {
        float value = foam != NULL ? foam[i] : 0.0f;
        swStreamF32(stream, &value);
        stream->isBroken = stream->isBroken || !(value >= 0.0f && value <= 1.0f); // NaN as well
        if (foam != NULL && swIsReading(stream))
        {
            foam[i] = value;
        }
    }
}

static swViewState getViewState(const swView* view)
{
    const swViewFrame* frame = swFindViewFrame(view);
    return (swViewState){
        .viewpoint = view->viewpoint,
        .last = frame != NULL ? frame->viewpoint : view->viewpoint,
        .isPlaced = view->stack.isPlaced,
        .scaleLevel = view->stack.scaleLevel,
        .foam = view->foamState,
    };
}

// Slices are those of the last step, where the next one finds its foam.
void swSetViewState(swView* view, const swViewState* state)
{
    view->viewpoint = state->viewpoint;
    view->stack.isPlaced = state->isPlaced;
    view->stack.scaleLevel = state->scaleLevel;
    view->foamState = state->foam;
    if (state->isPlaced)
    {
        swPlaceStack(&view->stack, state->last, view->world->def.seaLevel);
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
        // Before memory for layers is asked for: their foam must be there.
        bool isFine =
            !stream->isBroken && swCheckViewDef(&world->host, &def, world->def.enableQueries) == SW_SUCCESS &&
            (swCountSavedTexels(&def) == 0 || swStreamHasLeft(stream, swCountSavedTexels(&def), sizeof(float)));
        swResult result = isFine ? swAddView(world, &def, &view) : SW_ERROR_FORMAT;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    swStreamViewState(stream, def.maxScaleLevel, &state);
    swStreamViewFoam(stream, swCountSavedTexels(&def), view->foam[view->foamIndex]);
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
