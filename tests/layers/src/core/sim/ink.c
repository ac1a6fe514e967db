// SPDX-License-Identifier: MIT
// Ink in zones: shared/ink.h has the law. Drops fall at the sea's origin.

#include "core/sim/ink.h"

#include "core/base/host.h"
#include "shared/ink.h"

typedef struct InkJob
{
    const swSlice* slice;
    int resolution;
    bool isPoured;
    const float* previous; // of this level
    float* next;
} InkJob;

void swPlanInk(const swLayerPlan* plan)
{
    (void)plan; // the law has no parameters
}

// Clear water outside the level.
static float readInk(const InkJob* job, int column, int row)
{
    bool isInside = column >= 0 && row >= 0 && column < job->resolution && row < job->resolution;
    return isInside ? job->previous[(size_t)row * (size_t)job->resolution + (size_t)column] : 0.0f;
}

static void stepRows(void* context, int begin, int end, int worker)
{
    const InkJob* job = context;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; ++column)
        {
            bool isOrigin = job->slice->firstX + column == 0 && job->slice->firstZ + row == 0;
            float ink =
                swInkStep(readInk(job, column, row), readInk(job, column - 1, row), readInk(job, column + 1, row),
                          readInk(job, column, row - 1), readInk(job, column, row + 1));
            job->next[(size_t)row * (size_t)job->resolution + (size_t)column] = job->isPoured && isOrigin ? 1.0f : ink;
        }
    }
}

void swStepInk(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    size_t levelSize = (size_t)stack->resolution * (size_t)stack->resolution;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        InkJob job = {
            .slice = &stack->slices[i],
            .resolution = stack->resolution,
            .isPoured = step->clock % SW_INK_POUR_STEPS == 1,
            .previous = step->previous[SW_LAYER_INDEX_INK] + (size_t)i * levelSize,
            .next = step->next[SW_LAYER_INDEX_INK] + (size_t)i * levelSize,
        };
        swParallelFor(step->host, stepRows, &job, stack->resolution, 16);
    }
}
