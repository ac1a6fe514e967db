// SPDX-License-Identifier: MIT
#include "core/sim/foam.h"

#include "core/base/host.h"
#include "core/lod/transport.h"
#include "core/math/scalar.h"

typedef struct swFoamJob
{
    const swPastSource* sources;
    const swPastSource* fold;
    swTransport transport;
    int resolution;
    swFoamSliceParams params;
    const float* derivatives; // all slices
    const float* previous;    // all slices
    float* next;              // of this slice
} swFoamJob;

// The fold that a texel knows; flat water beyond what is known.
static float readFold(const swFoamJob* job, int column, int row)
{
    float jacobian = 1.0f;
    swReadSource(job->fold, job->derivatives + 2, 4, job->resolution, column, row, &jacobian);
    return swFoamFold(jacobian, job->params.threshold, job->params.rest);
}

static void stepRows(void* context, int begin, int end, int worker)
{
    const swFoamJob* job = context;
    const swFoamSliceParams* params = &job->params;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; ++column)
        {
            float birth = params->growth * readFold(job, column, row);
            float foam;
            bool hasPast = params->isSteady == 0 && swReadCarried(&job->transport, job->sources, job->previous,
                                                                  job->resolution, column, row, &foam);
            job->next[(size_t)row * (size_t)job->resolution + (size_t)column] =
                hasPast ? swFoamStep(foam, birth, params->fadeRate, params->dt)
                        : swFoamStart(birth, params->fadeRate, params->start);
        }
    }
}

void swStepFoam(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    const swLayerFrame* layer = &stack->layers[SW_LAYER_FOAM];
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        swFoamBirth birth = swGetFoamBirth(stack, i);
        swFoamJob job = {
            .sources = step->sources[i],
            .fold = &birth.fold,
            .transport = swMakeTransport(step->frame, stack, i, step->dt),
            .resolution = stack->resolution,
            .params = swGetFoamParams(step->frame, stack, i, step->dt, layer->isReset && step->index == 0),
            .derivatives = stack->layers[SW_LAYER_DERIVATIVES].texels,
            .previous = step->previous[SW_LAYER_FOAM],
            .next = step->next[SW_LAYER_FOAM] + (size_t)i * sliceSize,
        };
        swParallelFor(step->host, stepRows, &job, stack->resolution, 16);
    }
}
