// SPDX-License-Identifier: MIT
// The sum of waves that their places shape. With a wave's displacement D, its weight w and the way s by which it has
// been carried, a particle that rests at x is displaced by w(x) D(x + s(x)); gradients follow by product and chain
// rule:
//   d/dx = w (dD/dx (1 + ds_x/dx) + dD/dz ds_z/dx) + dw/dx D,  and so along z.
// Tiles are added one at a time, each with its shape, and free waves too. How a point's place changes with time makes
// no part of velocity and acceleration.

#include "core/surface/evaluate_shaped.h"

#include <string.h>

typedef swPointSums Sums[SW_PLACE_BLOCK];

// Add waves of one shape, `own`, to all.
static void addShaped(const swShape* shape, int i, bool withSlopes, const swPointSums* own, swPointSums* all)
{
    float weight = shape->weight[i];
    const float* s = shape->warp[i];
    for (int c = 0; c < 8; ++c)
    {
        all->value[c] += weight * own->value[c];
    }
    for (int c = 0; c < 8 && withSlopes; ++c)
    {
        float alongX = own->alongX[c] * (1.0f + s[0]) + own->alongZ[c] * s[2];
        float alongZ = own->alongX[c] * s[1] + own->alongZ[c] * (1.0f + s[3]);
        all->alongX[c] += weight * alongX + shape->alongX[i] * own->value[c];
        all->alongZ[c] += weight * alongZ + shape->alongZ[i] * own->value[c];
    }
}

// Waves that the job names, one by one, in the form that tiles have.
static void sumPart(const swQuery* query, swWaveSumJob* job, int field, bool withSlopes, swPointSums* own)
{
    float values[SW_PLACE_BLOCK][4] = {{0.0f}};
    float gradients[SW_PLACE_BLOCK][8] = {{0.0f}};
    const swSurfaceSums sums = {
        .displacement = field == 0 ? values : NULL,
        .gradients = withSlopes ? gradients : NULL,
        .velocity = field == 1 ? values : NULL,
        .acceleration = field == 2 ? values : NULL,
    };
    job->surface = &sums;
    swSumWaves(query->kernels, job);
    for (int i = 0; i < job->count; ++i)
    {
        const float* g = gradients[i];
        own[i] = (swPointSums){.alongX = {g[0], g[4], g[2]}, .alongZ = {g[1], g[5], g[3]}};
        memcpy(own[i].value, values[i], sizeof values[i]);
    }
}

static void addTiles(const swQuery* query, const swWaveSumJob* asked, int field, bool withSlopes, swPlaceBlock* block,
                     swPointSums* all)
{
    swShape shape;
    Sums own;
    for (int t = 0; t < query->tileCount; ++t)
    {
        const swTile* tile = &query->tiles[t];
        if (!swIsTileChosen(tile, asked->shortest, asked->longest))
        {
            continue;
        }
        swFindShape(block, tile->system, swGetTileWaveNumber(tile), &shape);
        memset(own, 0, sizeof own);
        if (swHasTexels(query, field))
        {
            swAddTile(query->kernels, tile, field, block->count, shape.source, withSlopes, own);
        }
        else
        {
            swWaveSumJob job = {
                .tileCount = 1, .tiles = tile, .ticks = query->ticks, .count = block->count, .points = shape.source};
            sumPart(query, &job, field, withSlopes, own);
        }
        for (int i = 0; i < block->count; ++i)
        {
            addShaped(&shape, i, withSlopes, &own[i], &all[i]);
        }
    }
}

static void addFreeWaves(const swQuery* query, const swWaveSumJob* asked, int field, bool withSlopes,
                         swPlaceBlock* block, swPointSums* all)
{
    swShape shape;
    Sums own;
    for (int w = 0; w < asked->waveCount; ++w)
    {
        const swFreeWave* wave = &asked->waves[w];
        swFindShape(block, wave->system, 6.2831853f / wave->wavelength, &shape);
        swWaveSumJob job = {
            .waveCount = 1, .waves = wave, .ticks = query->ticks, .count = block->count, .points = shape.source};
        sumPart(query, &job, field, withSlopes, own);
        for (int i = 0; i < block->count; ++i)
        {
            addShaped(&shape, i, withSlopes, &own[i], &all[i]);
        }
    }
}

// `gradients` may be NULL.
static void evaluateField(const swQuery* query, const swWaveSumJob* asked, int field, swPlaceBlock* block,
                          float (*out)[4], float (*gradients)[8])
{
    Sums all;
    memset(all, 0, sizeof all);
    addTiles(query, asked, field, gradients != NULL, block, all);
    addFreeWaves(query, asked, field, gradients != NULL, block, all);
    swStorePointSums(query->kernels, block->count, all, out[0], gradients != NULL ? gradients[0] : NULL);
}

void swEvaluateShaped(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        const swWaveSumJob asked = swMakeSumJob(query, out, some, rest + first);
        swPlaceBlock block;
        swBeginPlaces(&block, query->places, query->ticks, some, rest + first);
        float(*const fields[3])[4] = {out->displacement, out->velocity, out->acceleration};
        for (int field = 0; field < 3; ++field)
        {
            if (fields[field] != NULL)
            {
                evaluateField(query, &asked, field, &block, fields[field] + first,
                              field == 0 && out->gradients != NULL ? out->gradients + first : NULL);
            }
        }
    }
}
