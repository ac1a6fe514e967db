// SPDX-License-Identifier: MIT
#include "core/surface/slices.h"

#include "core/base/host.h"
#include "core/waves/waves_sum.h"
#include "shared/surface_normal.h"

// Texels sampled at once: keeps points and results in the first-level cache.
#define SW_SLICE_BLOCK 128

typedef struct swSliceJob
{
    const swWaveKernels* kernels;
    const swSlice* slice;
    int resolution;
    int tileCount;
    swTile tiles[SW_MAX_TILES];
    int64_t ticks;
    int waveCount;
    const swFreeWave* waves;
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

// Free waves, added to what tiles gave.
static void addFreeWaves(const swSliceJob* job, int count, const double* x, double z, float* displacement,
                         float (*gradients)[8])
{
    if (job->waveCount == 0)
    {
        return;
    }
    swPosXZ points[SW_SLICE_BLOCK];
    for (int i = 0; i < count; ++i)
    {
        points[i] = (swPosXZ){x[i], z};
    }
    const swSurfaceSums sums = {.displacement = (float(*)[4])displacement, .gradients = gradients};
    const swWaveSumJob sum = {
        .waveCount = job->waveCount,
        .waves = job->waves,
        .ticks = job->ticks,
        .count = count,
        .points = points,
        .surface = &sums,
    };
    swSumWaves(job->kernels, &sum);
}

static int countLongWaves(const swFrame* frame, float minWavelength)
{
    int count = 0;
    while (count < frame->waveCount && frame->waves[count].wavelength >= minWavelength)
    {
        count += 1;
    }
    return count;
}

static void sampleBlock(const swSliceJob* job, int row, int column, int count)
{
    const swSlice* slice = job->slice;
    double x[SW_SLICE_BLOCK];
    double z = (double)(slice->firstZ + row) * slice->texel;
    float gradients[SW_SLICE_BLOCK][8];
    for (int i = 0; i < count; ++i)
    {
        x[i] = (double)(slice->firstX + column + i) * slice->texel;
    }
    size_t first = ((size_t)row * (size_t)job->resolution + (size_t)column) * 4;
    swSampleRow(job->kernels, job->tileCount, job->tiles, count, x, z, job->displacement + first, gradients);
    addFreeWaves(job, count, x, z, job->displacement + first, gradients);
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
        for (int column = 0; column < job->resolution; column += SW_SLICE_BLOCK)
        {
            int left = job->resolution - column;
            sampleBlock(job, row, column, left < SW_SLICE_BLOCK ? left : SW_SLICE_BLOCK);
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
        swSliceJob job = {
            .kernels = step->kernels,
            .slice = &stack->slices[i],
            .resolution = stack->resolution,
            .ticks = frame->ticks,
            .waveCount = countLongWaves(frame, stack->slices[i].minWavelength),
            .waves = frame->waves,
            .displacement = step->next[SW_LAYER_DISPLACEMENT] + (size_t)i * sliceSize,
            .derivatives = step->next[SW_LAYER_DERIVATIVES] + (size_t)i * sliceSize,
        };
        job.tileCount = swSelectSliceTiles(frame, stack->slices[i].minWavelength, job.tiles);
        swParallelFor(step->host, sampleRows, &job, stack->resolution, 4);
    }
}
