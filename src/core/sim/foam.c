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
    int resolution;
    bool isSteady; // no past: every texel starts from the steady state
    float threshold, deviation;
    float keep, grow, ceiling;
    const float* derivatives; // of this slice
    const float* previous;    // all slices
    float* next;              // of this slice
} swFoamJob;

void swPlanFoam(swFoamState* state, int64_t elapsedTicks, swViewFrame* view)
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

float swGetFoamDeviation(const swFrame* frame, float minWavelength)
{
    float variance = 0.0f;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        variance += tile->minWavelength < minWavelength ? tile->strainVariance : 0.0f;
    }
    for (int i = frame->waveCount - 1; i >= 0 && frame->waves[i].wavelength < minWavelength; --i)
    {
        variance += swGetFreeWaveStrain(&frame->waves[i]);
    }
    return sqrtf(variance);
}

float swGetFoamAtRest(const swFrame* frame)
{
    const swFoamDef* foam = &frame->foam;
    float fold = swFoamFold(1.0f, foam->threshold, swGetFoamDeviation(frame, INFINITY));
    return swFoamSteady(fold, foam->gain / foam->fadeRate);
}

// Linear between four texels, whose corner (x, z) may be exact on either axis.
static float blendTexels(const float* foam, int resolution, int x, int z, float alongX, float alongZ)
{
    int stepX = alongX > 0.0f ? 1 : 0;
    const float* near = foam + (size_t)z * (size_t)resolution + (size_t)x;
    const float* far = alongZ > 0.0f ? near + resolution : near;
    float a = near[0] + (near[stepX] - near[0]) * alongX;
    float b = far[0] + (far[stepX] - far[0]) * alongX;
    return a + (b - a) * alongZ;
}

// Foam of the step before at a texel; false if no slice of the previous stack held it.
static bool readPrevious(const swFoamJob* job, int column, int row, float* foam)
{
    size_t sliceSize = (size_t)job->resolution * (size_t)job->resolution;
    for (int i = 0; i < SW_FOAM_SOURCES && job->sources[i].slice >= 0; ++i)
    {
        const swFoamSource* source = &job->sources[i];
        int x = swFoamTap(source->shift, source->baseX, source->restX, column);
        int z = swFoamTap(source->shift, source->baseZ, source->restZ, row);
        float alongX = swFoamTapFraction(source->shift, source->restX, column);
        float alongZ = swFoamTapFraction(source->shift, source->restZ, row);
        int lastX = job->resolution - (alongX > 0.0f ? 2 : 1);
        int lastZ = job->resolution - (alongZ > 0.0f ? 2 : 1);
        if (x >= 0 && z >= 0 && x <= lastX && z <= lastZ)
        {
            *foam =
                blendTexels(job->previous + (size_t)source->slice * sliceSize, job->resolution, x, z, alongX, alongZ);
            return true;
        }
    }
    return false;
}

static void stepRows(void* context, int begin, int end, int worker)
{
    const swFoamJob* job = context;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; ++column)
        {
            size_t texel = (size_t)row * (size_t)job->resolution + (size_t)column;
            float fold = swFoamFold(job->derivatives[4 * texel + 2], job->threshold, job->deviation);
            float foam;
            bool hasPast = !job->isSteady && readPrevious(job, column, row, &foam);
            job->next[texel] =
                hasPast ? swFoamStep(foam, fold, job->keep, job->grow) : swFoamSteady(fold, job->ceiling);
        }
    }
}

void swStepFoam(const swHost* host, const swFoamDef* def, const swViewFrame* view, const float* previous, float* next)
{
    size_t sliceSize = (size_t)view->resolution * (size_t)view->resolution;
    float keep = swExpF(-def->fadeRate * view->foamStepDt * (float)view->foamSteps);
    for (int i = 0; i < view->sliceCount; ++i)
    {
        swFoamJob job = {
            .sources = view->foamSources[i],
            .resolution = view->resolution,
            .isSteady = view->foamReset,
            .threshold = def->threshold,
            .deviation = view->foamDeviation[i],
            .keep = keep,
            .grow = def->gain * (1.0f - keep) / def->fadeRate,
            .ceiling = def->gain / def->fadeRate,
            .derivatives = view->derivatives + (size_t)i * sliceSize * 4,
            .previous = previous,
            .next = next + (size_t)i * sliceSize,
        };
        swParallelFor(host, stepRows, &job, view->resolution, 16);
    }
}
