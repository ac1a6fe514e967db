// SPDX-License-Identifier: MIT
#include "core/surface/slices.h"

#include "core/base/host.h"
#include "core/surface/evaluate.h"
#include "shared/surface_normal.h"

typedef struct swSliceJob
{
    const swSlice* slice;
    int resolution;
    swTile tiles[SW_MAX_TILES];
    swQueryDef def;
    swQuery query;
    float* displacement;
    float* derivatives;
} swSliceJob;

int swSelectSliceTiles(const swFrame* frame, float minWavelength, swTile* out)
{
    int count = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (frame->tiles[i].texels != NULL && frame->tiles[i].minWavelength >= minWavelength)
        {
            out[count++] = frame->tiles[i];
        }
    }
    return count;
}

// The waves of a slice: a query's but for tiles, all of whose waves must be long enough.
static void beginJob(swSliceJob* job, const swWaveKernels* kernels, const swFrame* frame, const swSlice* slice)
{
    job->slice = slice;
    job->def = (swQueryDef){.minWavelength = slice->minWavelength, .time = SW_QUERY_NOW};
    swBeginQuery(&job->query, frame, kernels, &job->def, (swPosXZ){0.0, 0.0});
    job->query.tileCount = swSelectSliceTiles(frame, slice->minWavelength, job->tiles);
    job->query.tiles = job->tiles;
}

static void sampleBlock(const swSliceJob* job, int row, int column, int count)
{
    const swSlice* slice = job->slice;
    swPosXZ points[SW_QUERY_BLOCK];
    float gradients[SW_QUERY_BLOCK][8];
    for (int i = 0; i < count; ++i)
    {
        points[i].x = (double)(slice->firstX + column + i) * slice->texel;
        points[i].z = (double)(slice->firstZ + row) * slice->texel;
    }
    size_t first = ((size_t)row * (size_t)job->resolution + (size_t)column) * 4;
    const swEvaluation evaluation = {
        .displacement = (float(*)[4])(job->displacement + first), .gradients = gradients, .withHeights = true};
    swEvaluate(&job->query, count, points, &evaluation);
    float* derivatives = job->derivatives + first;
    for (int i = 0; i < count; ++i)
    {
        const float* g = gradients[i];
        derivatives[4 * i + 0] = swSurfaceNormalX(g[2], g[3], g[4], g[5]);
        derivatives[4 * i + 1] = swSurfaceNormalZ(g[0], g[2], g[4], g[5]);
        derivatives[4 * i + 2] = swSurfaceJacobian(g[0], g[2], g[3]);
        derivatives[4 * i + 3] = 0.0f;
    }
}

static void sampleRows(void* context, int begin, int end, int worker)
{
    const swSliceJob* job = context;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        for (int column = 0; column < job->resolution; column += SW_QUERY_BLOCK)
        {
            int left = job->resolution - column;
            sampleBlock(job, row, column, left < SW_QUERY_BLOCK ? left : SW_QUERY_BLOCK);
        }
    }
}

void swPlanSlices(const swLayerPlan* plan)
{
    (void)plan;
}

void swStepSlices(const swLayerStep* step)
{
    const swFrame* frame = step->frame;
    const swStackFrame* stack = step->stack;
    size_t sliceSize = (size_t)stack->resolution * (size_t)stack->resolution * 4;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        swSliceJob job;
        beginJob(&job, step->kernels, frame, &stack->slices[i]);
        job.resolution = stack->resolution;
        job.displacement = step->next[SW_LAYER_DISPLACEMENT] + (size_t)i * sliceSize;
        job.derivatives = step->next[SW_LAYER_DERIVATIVES] + (size_t)i * sliceSize;
        swParallelFor(step->host, sampleRows, &job, stack->resolution, 4);
    }
}
