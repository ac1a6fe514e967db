// SPDX-License-Identifier: MIT
// The CPU's wetness: shared/wetness.h has the law. The GPU's twin is shaders/sim/wetness.comp.

#include "core/sim/wetness.h"

#include "core/base/host.h"
#include "core/lod/scroll.h"
#include "shared/wetness.h"

typedef struct WetnessJob
{
    const swPastSource* sources;
    int resolution;
    swWetnessParams params;
    const float* displacement; // of this slice
    const float* previous;     // all slices
    float* next;               // of this slice
} WetnessJob;

void swPlanWetness(const swLayerPlan* plan)
{
    swLayerFrame* layer = &plan->stack->layers[SW_LAYER_INDEX_WETNESS];
    const swWetnessParams params = {
        .soak = plan->def->wetness.soak,
        .dryRate = plan->def->wetness.dryRate,
        .dt = layer->stepDt * (float)layer->steps,
        .isDry = layer->isReset ? 1 : 0,
    };
    for (int i = 0; i < plan->stack->sliceCount; ++i)
    {
        memcpy(layer->params[i], &params, sizeof params);
    }
}

static void stepRows(void* context, int begin, int end, int worker)
{
    const WetnessJob* job = context;
    const swWetnessParams* params = &job->params;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; ++column)
        {
            size_t at = (size_t)row * (size_t)job->resolution + (size_t)column;
            float past = 0.0f;
            if (params->isDry == 0)
            {
                swReadPast(job->sources, job->previous, 1, job->resolution, column, row, &past);
            }
            job->next[at] =
                swWetnessStep(past, job->displacement[4 * at + 1], params->soak, params->dryRate, params->dt);
        }
    }
}

void swStepWetness(const swLayerStep* step)
{
    const swStackFrame* stack = step->stack;
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        WetnessJob job = {
            .sources = stack->sources[i],
            .resolution = stack->resolution,
            .displacement = stack->layers[SW_LAYER_DISPLACEMENT].texels + 4 * (size_t)i * sliceSize,
            .previous = step->previous[SW_LAYER_INDEX_WETNESS],
            .next = step->next[SW_LAYER_INDEX_WETNESS] + (size_t)i * sliceSize,
        };
        memcpy(&job.params, stack->layers[SW_LAYER_INDEX_WETNESS].params[i], sizeof job.params);
        swParallelFor(step->host, stepRows, &job, stack->resolution, 16);
    }
}
