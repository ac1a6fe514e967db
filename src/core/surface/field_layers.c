// SPDX-License-Identifier: MIT
#include "core/surface/field_layers.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/host.h"
#include "core/input/input_record.h"
#include "core/lod/redraw.h"
#include "core/surface/input_places.h"
#include "shared/fields.h"

typedef struct FieldJob
{
    const swInputSet* inputs;
    swPlaces places;
    const swSlice* slice;
    int resolution;
    swTexelRect rect;
    float* grounds; // of the slice, or NULL; like the others
    float *flows, *slopes;
} FieldJob;

void swPlanFields(const swLayerPlan* plan)
{
    const swInputSet* inputs = plan->frame->inputs;
    plan->stack->layers[SW_LAYER_PLACES].isAuthored =
        swHasInputs(inputs, SW_INPUT_FLOOR) || swHasInputs(inputs, SW_INPUT_LEVEL);
    plan->stack->layers[SW_LAYER_FLOW].isAuthored = swHasInputs(inputs, SW_INPUT_FLOW);
    plan->stack->layers[SW_LAYER_FLOW_SLOPES].isAuthored = swHasInputs(inputs, SW_INPUT_FLOW);
}

static void makeGrounds(const FieldJob* job, int count, const swPosXZ* points, float* texels)
{
    float depths[SW_PLACE_BLOCK], levels[SW_PLACE_BLOCK] = {0.0f};
    float slopes[SW_PLACE_BLOCK][2], levelSlopes[SW_PLACE_BLOCK][2];
    swFindInputDepths(job->inputs, count, points, depths, slopes);
    if (job->places.level != NULL)
    {
        job->places.level(job->places.context, -1, 0, count, points, levels, levelSlopes);
    }
    for (int i = 0; i < count; ++i)
    {
        const float texel[4] = {depths[i] < SW_NO_DEPTH ? depths[i] : SW_NO_DEPTH, slopes[i][0], slopes[i][1],
                                levels[i]};
        memcpy(texels + 4 * i, texel, sizeof texel);
    }
}

static void makeFlows(const FieldJob* job, int count, const swPosXZ* points, float* flows, float* slopes)
{
    float velocities[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4];
    job->places.water(job->places.context, 0, count, points, velocities, gradients);
    for (int i = 0; i < count; ++i)
    {
        const float texel[4] = {velocities[i][0], velocities[i][1], 0.0f, 0.0f};
        memcpy(flows + 4 * i, texel, sizeof texel);
    }
    memcpy(slopes, gradients, (size_t)count * sizeof gradients[0]);
}

static void makeTexels(const FieldJob* job, int row, int column, int count)
{
    const swSlice* slice = job->slice;
    swPosXZ points[SW_PLACE_BLOCK];
    for (int i = 0; i < count; ++i)
    {
        points[i] = (swPosXZ){(double)(slice->firstX + column + i) * slice->texel,
                              (double)(slice->firstZ + row) * slice->texel};
    }
    size_t at = 4 * ((size_t)row * (size_t)job->resolution + (size_t)column);
    if (job->grounds != NULL)
    {
        makeGrounds(job, count, points, job->grounds + at);
    }
    if (job->flows != NULL)
    {
        makeFlows(job, count, points, job->flows + at, job->slopes + at);
    }
}

static void makeRows(void* context, int begin, int end, int worker)
{
    const FieldJob* job = context;
    (void)worker;
    for (int row = job->rect.firstZ + begin; row < job->rect.firstZ + end; ++row)
    {
        for (int column = job->rect.firstX; column < job->rect.endX; column += SW_PLACE_BLOCK)
        {
            int left = job->rect.endX - column;
            makeTexels(job, row, column, left < SW_PLACE_BLOCK ? left : SW_PLACE_BLOCK);
        }
    }
}

// Move the texels of a slice that are kept, in place: rows in the order in which none is written before it is read.
static void scrollTexels(float* texels, int resolution, const swRedraw* redraw)
{
    int columns = resolution - abs(redraw->shiftX), rows = resolution - abs(redraw->shiftZ);
    int toX = redraw->shiftX < 0 ? -redraw->shiftX : 0, toZ = redraw->shiftZ < 0 ? -redraw->shiftZ : 0;
    bool isStill = redraw->shiftX == 0 && redraw->shiftZ == 0;
    for (int i = 0; i < rows && !isStill && texels != NULL; ++i)
    {
        int row = redraw->shiftZ < 0 ? toZ + rows - 1 - i : toZ + i;
        size_t to = (size_t)row * (size_t)resolution + (size_t)toX;
        size_t from = (size_t)(row + redraw->shiftZ) * (size_t)resolution + (size_t)(toX + redraw->shiftX);
        memmove(texels + 4 * to, texels + 4 * from, 4 * (size_t)columns * sizeof *texels);
    }
}

// What a function of the host's answers may be another thing at any time.
static void redrawFunctions(const swInputSet* inputs, const swSlice* slice, int resolution, swRedraw* redraw)
{
    const int fields[3] = {SW_INPUT_FLOOR, SW_INPUT_LEVEL, SW_INPUT_FLOW};
    for (int i = 0; i < 3; ++i)
    {
        const swInputRange* range = &inputs->ranges[fields[i]];
        for (uint32_t k = range->firstRecord; k < range->firstRecord + range->recordCount; ++k)
        {
            swPosXZ low, high;
            swFindInputArea(&inputs->records[k], &low, &high);
            if (inputs->records[k].shape == SW_FORM_FUNCTION)
            {
                swAddRedraw(slice, resolution, low, high, redraw);
            }
        }
    }
}

static void makeSlice(const swLayerStep* step, FieldJob* job, const swRedraw* redraw)
{
    scrollTexels(job->grounds, job->resolution, redraw);
    scrollTexels(job->flows, job->resolution, redraw);
    scrollTexels(job->slopes, job->resolution, redraw);
    for (int i = 0; i < redraw->count; ++i)
    {
        job->rect = redraw->rects[i];
        swParallelFor(step->host, makeRows, job, job->rect.endZ - job->rect.firstZ, 8);
    }
    step->note->made += swCountRedrawn(redraw);
}

static float* findTexels(const swLayerStep* step, int layer)
{
    return step->stack->layers[layer].isAuthored ? step->next[layer] : NULL;
}

// Whether texels of before are there to go on from.
static bool isBegun(const swStackFrame* stack, int layer)
{
    return !stack->layers[layer].isAuthored || stack->layers[layer].isBegun;
}

void swStepFields(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    const swInputSet* inputs = step->frame->inputs;
    float* layers[3] = {findTexels(step, SW_LAYER_PLACES), findTexels(step, SW_LAYER_FLOW),
                        findTexels(step, SW_LAYER_FLOW_SLOPES)};
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution * 4;
    FieldJob job = {.inputs = inputs, .resolution = stack->resolution};
    bool goesOn = isBegun(stack, SW_LAYER_PLACES) && isBegun(stack, SW_LAYER_FLOW);
    step->note->made = 0;
    swMakeInputPlaces(job.inputs, &job.places);
    for (int i = 0; i < stack->sliceCount && (layers[0] != NULL || layers[1] != NULL); ++i)
    {
        size_t first = (size_t)i * sliceSize;
        job.slice = &stack->slices[i];
        job.grounds = layers[0] != NULL ? layers[0] + first : NULL;
        job.flows = layers[1] != NULL ? layers[1] + first : NULL;
        job.slopes = layers[2] != NULL ? layers[2] + first : NULL;
        swRedraw redraw;
        swRedrawAll(stack->resolution, &redraw);
        if (goesOn)
        {
            swPlanRedraw(job.slice, &stack->previousSlices[i], stack->resolution, inputs, step->note->version, &redraw);
            redrawFunctions(inputs, job.slice, stack->resolution, &redraw);
        }
        makeSlice(step, &job, &redraw);
    }
    step->note->version = inputs != NULL ? inputs->version : 0;
}
