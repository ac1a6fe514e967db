// SPDX-License-Identifier: MIT
#include "core/surface/field_layers.h"

#include <string.h>

#include "core/base/host.h"
#include "core/surface/input_places.h"
#include "shared/fields.h"

typedef struct FieldJob
{
    const swInputSet* inputs;
    swPlaces places;
    const swSlice* slice;
    int resolution;
    float* grounds; // of the slice, or NULL
} FieldJob;

void swPlanFields(const swLayerPlan* plan)
{
    const swInputSet* inputs = plan->frame->inputs;
    plan->stack->layers[SW_LAYER_PLACES].isAuthored =
        swHasInputs(inputs, SW_INPUT_FLOOR) || swHasInputs(inputs, SW_INPUT_LEVEL);
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

static void makeRows(void* context, int begin, int end, int worker)
{
    const FieldJob* job = context;
    const swSlice* slice = job->slice;
    swPosXZ points[SW_PLACE_BLOCK];
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; column += SW_PLACE_BLOCK) // a multiple of 64
        {
            for (int i = 0; i < SW_PLACE_BLOCK; ++i)
            {
                points[i] = (swPosXZ){(double)(slice->firstX + column + i) * slice->texel,
                                      (double)(slice->firstZ + row) * slice->texel};
            }
            size_t texel = (size_t)row * (size_t)job->resolution + (size_t)column;
            makeGrounds(job, SW_PLACE_BLOCK, points, job->grounds + 4 * texel);
        }
    }
}

void swStepFields(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution * 4;
    float* grounds = step->next[SW_LAYER_PLACES];
    FieldJob job = {.inputs = step->frame->inputs, .resolution = stack->resolution};
    swMakeInputPlaces(job.inputs, &job.places);
    for (int i = 0; i < stack->sliceCount && stack->layers[SW_LAYER_PLACES].isAuthored && grounds != NULL; ++i)
    {
        job.slice = &stack->slices[i];
        job.grounds = grounds + (size_t)i * sliceSize;
        swParallelFor(step->host, makeRows, &job, stack->resolution, 8);
    }
}
