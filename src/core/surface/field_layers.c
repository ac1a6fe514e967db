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
    job->places.flow(job->places.context, 0, count, points, velocities, gradients);
    for (int i = 0; i < count; ++i)
    {
        const float texel[4] = {velocities[i][0], velocities[i][1], 0.0f, 0.0f};
        memcpy(flows + 4 * i, texel, sizeof texel);
    }
    memcpy(slopes, gradients, (size_t)count * sizeof gradients[0]);
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
            size_t at = 4 * ((size_t)row * (size_t)job->resolution + (size_t)column);
            if (job->grounds != NULL)
            {
                makeGrounds(job, SW_PLACE_BLOCK, points, job->grounds + at);
            }
            if (job->flows != NULL)
            {
                makeFlows(job, SW_PLACE_BLOCK, points, job->flows + at, job->slopes + at);
            }
        }
    }
}

static float* findTexels(const swLayerStep* step, int layer)
{
    return step->stack->layers[layer].isAuthored ? step->next[layer] : NULL;
}

void swStepFields(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    float* layers[3] = {findTexels(step, SW_LAYER_PLACES), findTexels(step, SW_LAYER_FLOW),
                        findTexels(step, SW_LAYER_FLOW_SLOPES)};
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution * 4;
    FieldJob job = {.inputs = step->frame->inputs, .resolution = stack->resolution};
    swMakeInputPlaces(job.inputs, &job.places);
    for (int i = 0; i < stack->sliceCount && (layers[0] != NULL || layers[1] != NULL); ++i)
    {
        size_t first = (size_t)i * sliceSize;
        job.slice = &stack->slices[i];
        job.grounds = layers[0] != NULL ? layers[0] + first : NULL;
        job.flows = layers[1] != NULL ? layers[1] + first : NULL;
        job.slopes = layers[2] != NULL ? layers[2] + first : NULL;
        swParallelFor(step->host, makeRows, &job, stack->resolution, 8);
    }
}
