// SPDX-License-Identifier: MIT
#include "core/sim/foam.h"

#include <math.h>

#include "core/base/host.h"
#include "core/math/scalar.h"

// More steps than this in one frame are taken as this many longer ones.
#define SW_MOST_FOAM_STEPS 4

typedef struct swFoamJob
{
    const swFoamSource* sources;
    const swFoamSource* fold;
    int resolution;
    swFoamSliceParams params;
    const float* derivatives; // all slices
    const float* previous;    // all slices
    float* next;              // of this slice
} swFoamJob;

void swPlanFoam(swFoamClock* state, int64_t elapsedTicks, swViewFrame* view)
{
    const int64_t tick = (int64_t)SW_TICKS_PER_SECOND;
    bool isJump = elapsedTicks < 0 || elapsedTicks > (int64_t)(SW_LONGEST_FOAM_GAP * SW_TICKS_PER_SECOND);
    view->foamReset = isJump || !state->isRunning;
    int64_t steps = 0;
    if (view->foamReset)
    {
        state->isRunning = true;
        state->remainder = 0;
        state->resetCount += 1;
    }
    else
    {
        int64_t total = state->remainder + elapsedTicks * SW_FOAM_RATE;
        steps = total / tick;
        state->remainder = total - steps * tick;
        state->clock += steps;
    }
    view->foamSteps = steps < SW_MOST_FOAM_STEPS ? (int)steps : SW_MOST_FOAM_STEPS;
    view->foamStepDt = view->foamSteps == 0 ? 0.0f : (float)steps / (float)SW_FOAM_RATE / (float)view->foamSteps;
    view->foamClock = state->clock;
    view->foamResetCount = state->resetCount;
}

// Linear between four texels of `stride` floats, whose corner (x, z) may be exact on either axis.
static float blendTexels(const float* texels, int stride, int resolution, int x, int z, float alongX, float alongZ)
{
    size_t stepX = alongX > 0.0f ? (size_t)stride : 0;
    const float* near = texels + ((size_t)z * (size_t)resolution + (size_t)x) * (size_t)stride;
    const float* far = alongZ > 0.0f ? near + (size_t)resolution * (size_t)stride : near;
    float a = near[0] + (near[stepX] - near[0]) * alongX;
    float b = far[0] + (far[stepX] - far[0]) * alongX;
    return a + (b - a) * alongZ;
}

// A texel's value in another slice; false if that does not hold it.
static bool readSource(const swFoamSource* source, const float* slices, int stride, int resolution, int column, int row,
                       float* value)
{
    int x = swFoamTap(source->shift, source->baseX, source->restX, column);
    int z = swFoamTap(source->shift, source->baseZ, source->restZ, row);
    float alongX = swFoamTapFraction(source->shift, source->restX, column);
    float alongZ = swFoamTapFraction(source->shift, source->restZ, row);
    int lastX = resolution - (alongX > 0.0f ? 2 : 1);
    int lastZ = resolution - (alongZ > 0.0f ? 2 : 1);
    if (x < 0 || z < 0 || x > lastX || z > lastZ)
    {
        return false;
    }
    size_t sliceSize = (size_t)resolution * (size_t)resolution * (size_t)stride;
    *value = blendTexels(slices + (size_t)source->slice * sliceSize, stride, resolution, x, z, alongX, alongZ);
    return true;
}

// Foam of the step before at a texel; false if no slice of the previous stack held it.
static bool readPrevious(const swFoamJob* job, int column, int row, float* foam)
{
    for (int i = 0; i < SW_FOAM_SOURCES && job->sources[i].slice >= 0; ++i)
    {
        if (readSource(&job->sources[i], job->previous, 1, job->resolution, column, row, foam))
        {
            return true;
        }
    }
    return false;
}

// The fold that a texel knows; flat water beyond what is known.
static float readFold(const swFoamJob* job, int column, int row)
{
    float jacobian = 1.0f;
    readSource(job->fold, job->derivatives + 2, 4, job->resolution, column, row, &jacobian);
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
            bool hasPast = params->isSteady == 0 && readPrevious(job, column, row, &foam);
            job->next[(size_t)row * (size_t)job->resolution + (size_t)column] =
                hasPast ? swFoamStep(foam, birth, params->fadeRate, params->dt)
                        : swFoamStart(birth, params->fadeRate, params->start);
        }
    }
}

void swStepFoam(const swHost* host, const swFrame* frame, const swViewFrame* view, const float* previous, float* next)
{
    size_t sliceSize = (size_t)view->resolution * (size_t)view->resolution;
    float seconds = view->foamStepDt * (float)view->foamSteps;
    for (int i = 0; i < view->sliceCount; ++i)
    {
        swFoamJob job = {
            .sources = view->foamSources[i],
            .fold = &view->foamBirth[i].fold,
            .resolution = view->resolution,
            .params = swGetFoamParams(frame, view, i, seconds, view->foamReset),
            .derivatives = view->derivatives,
            .previous = previous,
            .next = next + (size_t)i * sliceSize,
        };
        swParallelFor(host, stepRows, &job, view->resolution, 16);
    }
}
