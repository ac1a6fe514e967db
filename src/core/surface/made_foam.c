// SPDX-License-Identifier: MIT
#include "core/surface/made_foam.h"

#include "core/base/host.h"
#include "core/input/sample_inputs.h"
#include "core/lod/transport.h"
#include "core/surface/places.h"

typedef struct MadeJob
{
    const swInputSet* inputs; // of foam that inputs make; NULL: there are none
    const swSlice* slice;
    const swPastSource* sources;
    swTransport transport;
    int resolution;
    swMadeFoamParams params;
    const float* displacement; // of this slice, as all below
    const float* places;
    const float* previous; // all slices
    float* next;
} MadeJob;

// Inputs that make foam leave some behind when they are gone: the layer stays until there is a jump in time.
void swPlanMadeFoam(const swLayerPlan* plan)
{
    swLayerFrame* wake = &plan->stack->layers[SW_LAYER_WAKE_FOAM];
    swLayerFrame* shore = &plan->stack->layers[SW_LAYER_SHORE_FOAM];
    const swFoamDef* foam = &plan->frame->foam;
    wake->isAuthored = swHasInputs(plan->frame->inputs, SW_INPUT_FOAM) || (wake->isBegun && !wake->isReset);
    shore->isAuthored =
        swHasInputs(plan->frame->inputs, SW_INPUT_FLOOR) && foam->shoreWidth > 0.0f && foam->shoreRate > 0.0f;
    wake->isCarried = shore->isCarried = swIsFoamCarried(plan->frame);
}

// Foam that inputs make at a block of texels of a row, per second.
static void findWakeBirths(const MadeJob* job, int column, int row, float* births)
{
    swPosXZ here[SW_PLACE_BLOCK], rest[SW_PLACE_BLOCK];
    const swSlice* slice = job->slice;
    for (int i = 0; i < SW_PLACE_BLOCK; ++i)
    {
        const float* moved = job->displacement + 4 * ((size_t)row * (size_t)job->resolution + (size_t)(column + i));
        rest[i] = (swPosXZ){(double)(slice->firstX + column + i) * slice->texel,
                            (double)(slice->firstZ + row) * slice->texel};
        here[i] = (swPosXZ){rest[i].x + (double)moved[0], rest[i].z + (double)moved[2]};
        births[i] = 0.0f;
    }
    if (job->inputs != NULL)
    {
        swFindWaterValues(job->inputs, SW_INPUT_FOAM, SW_PLACE_BLOCK, here, rest, births);
    }
}

static void findShoreBirths(const MadeJob* job, int column, int row, float* births)
{
    for (int i = 0; i < SW_PLACE_BLOCK; ++i)
    {
        const float* place = job->places + 4 * ((size_t)row * (size_t)job->resolution + (size_t)(column + i));
        births[i] = swFindShoreBirth(swFindShoreDistance(place[0], place[1], place[2]), job->params.shoreWidth,
                                     job->params.shoreRate);
    }
}

static void stepRows(void* context, int begin, int end, int worker)
{
    const MadeJob* job = context;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; column += SW_PLACE_BLOCK) // a multiple of 64
        {
            float births[SW_PLACE_BLOCK];
            (job->params.isWake != 0 ? findWakeBirths : findShoreBirths)(job, column, row, births);
            float* next = job->next + (size_t)row * (size_t)job->resolution + (size_t)column;
            for (int i = 0; i < SW_PLACE_BLOCK; ++i)
            {
                float foam = 0.0f, birth = births[i] > 0.0f ? births[i] : 0.0f;
                bool hasPast = job->params.isSteady == 0 && swReadCarried(&job->transport, job->sources, job->previous,
                                                                          job->resolution, column + i, row, &foam);
                next[i] = swMadeFoamStep(foam, hasPast, birth, job->params);
            }
        }
    }
}

static void stepLayer(const swLayerStep* step, int layer)
{
    const swStackFrame* stack = step->stack;
    const swLayerFrame* now = &stack->layers[layer];
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution;
    bool hasInputs = swHasInputs(step->frame->inputs, SW_INPUT_FOAM);
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        const float* places = stack->layers[SW_LAYER_PLACES].texels;
        MadeJob job = {
            .inputs = hasInputs ? step->frame->inputs : NULL,
            .slice = &stack->slices[i],
            .sources = step->sources[i],
            .transport = swMakeTransport(step->frame, stack, i, step->dt),
            .resolution = stack->resolution,
            .params =
                swGetMadeFoamParams(step->frame, layer, step->dt, step->index == 0 && (now->isReset || !now->isBegun)),
            .displacement = stack->layers[SW_LAYER_DISPLACEMENT].texels + 4 * (size_t)i * sliceSize,
            .places = places != NULL ? places + 4 * (size_t)i * sliceSize : NULL,
            .previous = step->previous[layer],
            .next = step->next[layer] + (size_t)i * sliceSize,
        };
        swParallelFor(step->host, stepRows, &job, stack->resolution, 16);
    }
}

void swStepMadeFoam(const swLayerStep* step)
{
    for (int layer = SW_LAYER_WAKE_FOAM; layer <= SW_LAYER_SHORE_FOAM; ++layer)
    {
        if (step->stack->layers[layer].isAuthored && step->next[layer] != NULL)
        {
            stepLayer(step, layer);
        }
    }
}
