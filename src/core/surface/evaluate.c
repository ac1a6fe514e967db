// SPDX-License-Identifier: MIT
#include "core/surface/evaluate.h"

#include <math.h>
#include <string.h>

#include "core/surface/displace.h"
#include "core/surface/evaluate_shaped.h"
#include "core/surface/input_places.h"
#include "shared/surface_normal.h"

// Free waves of at least a length; they come longest first.
static int countLongWaves(const swFrame* frame, float minWavelength)
{
    int count = frame->waveCount;
    while (count > 0 && frame->waves[count - 1].wavelength < minWavelength)
    {
        count -= 1;
    }
    return count;
}

// Of a tile's waves all have the same chop but for the depth's part: its strain, over its slopes, is the square of it.
static void findSideways(swQuery* query)
{
    float square = 0.0f;
    float least = 0.01f * query->def->tolerance * query->def->tolerance;
    query->longestFelt = 0.0f;
    for (int i = 0; i < query->tileCount; ++i)
    {
        const swTile* tile = &query->tiles[i];
        float slopes = tile->slopeVarianceX + tile->slopeVarianceZ;
        if (slopes > 0.0f && swIsTileAsked(query, tile))
        {
            float part = tile->variance * swGetStrainVariance(&tile->strain) / slopes;
            square += part;
            query->longestFelt = part >= least ? fmaxf(query->longestFelt, tile->maxWavelength) : query->longestFelt;
        }
    }
    for (int i = 0; i < query->waveCount; ++i)
    {
        const swFreeWave* wave = &query->waves[i];
        square += 0.5f * wave->amplitude * wave->amplitude * (wave->dx * wave->dx + wave->dz * wave->dz);
    }
    query->sideways = sqrtf(square);
}

static void useFrame(swQuery* query, const swFrame* frame)
{
    query->waves = frame->waves;
    query->waveCount = countLongWaves(frame, query->def->minWavelength);
    query->tiles = frame->tiles;
    query->tileTicks = frame->ticks;
    // A world without queries has no texels: it answers sea level.
    query->tileCount = frame->tileCount > 0 && frame->tiles[0].texels != NULL ? frame->tileCount : 0;
    findSideways(query);
}

static void usePlaces(swQuery* query, const swFrame* frame)
{
    query->inputs = frame->inputs;
    query->lowestLevel = frame->inputs != NULL ? frame->inputs->lowestLevel : 0.0f;
    query->highestLevel = frame->inputs != NULL ? frame->inputs->highestLevel : 0.0f;
    query->clip = swHasInputs(frame->inputs, SW_INPUT_CLIP) ? frame->inputs : NULL;
    query->places = swMakeInputPlaces(frame->inputs, &query->inputPlaces) ? &query->inputPlaces : NULL;
}

void swBeginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def,
                  swPosXZ origin)
{
    query->kernels = kernels;
    query->def = def;
    usePlaces(query, frame);
    query->origin = origin;
    query->seaLevel = frame->seaLevel;
    bool isNow = def->time == SW_QUERY_NOW;
    query->ticks = isNow ? frame->ticks : (int64_t)floor(def->time * SW_TICKS_PER_SECOND + 0.5);
    query->isNow = query->ticks == frame->ticks;
    query->after = NULL;
    useFrame(query, frame);
}

void swBlendQuery(swQuery* query, const swFrame* after)
{
    query->after = after;
}

// ---- what is asked for ----

swWaveSumJob swMakeSumJob(const swQuery* query, const swEvaluation* out, int count, const swPosXZ* points)
{
    int first = 0, end = query->waveCount;
    while (out->longest > 0.0f && first < end && query->waves[first].wavelength >= out->longest)
    {
        first += 1;
    }
    while (out->shortest > 0.0f && end > first && query->waves[end - 1].wavelength < out->shortest)
    {
        end -= 1;
    }
    return (swWaveSumJob){
        .tiles = query->tiles,
        .shortest = fmaxf(out->shortest, query->def->minWavelength),
        .longest = out->longest,
        .waveCount = end - first,
        .waves = query->waves + first,
        .ticks = query->ticks,
        .count = count,
        .points = points,
    };
}

bool swHasTexels(const swQuery* query, int field)
{
    if (!query->isNow || query->tileCount == 0)
    {
        return query->isNow;
    }
    const swTile* tile = &query->tiles[0];
    const float* texels = field == 0 ? tile->texels : field == 1 ? tile->velocity : tile->acceleration;
    return texels != NULL;
}

// ---- waves that are the same everywhere ----

// Waves one by one, added to what is there.
static void sumOneByOne(const swQuery* query, bool withTiles, int count, const swPosXZ* rest, const swEvaluation* out)
{
    swWaveSumJob job = swMakeSumJob(query, out, count, rest);
    if (!withTiles && job.waveCount == 0)
    {
        return;
    }
    const swSurfaceSums sums = {out->displacement, out->gradients, out->velocity, out->acceleration};
    job.tileCount = withTiles ? query->tileCount : 0;
    job.surface = &sums;
    swSumWaves(query->kernels, &job);
}

// What tiles have no texels for: motion of tiles wave by wave.
static void sumTileMotion(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out,
                          float (*velocity)[4], float (*acceleration)[4])
{
    const swSurfaceSums sums = {.velocity = velocity, .acceleration = acceleration};
    swWaveSumJob job = swMakeSumJob(query, out, count, rest);
    job.waveCount = 0;
    job.tileCount = query->tileCount;
    job.surface = &sums;
    swSumWaves(query->kernels, &job);
}

// Few points are not worth the tile's columns that a row adds up.
#define LEAST_ROW 12

static bool isRow(int count, const swPosXZ* points)
{
    if (count < LEAST_ROW)
    {
        return false;
    }
    for (int i = 1; i < count; ++i)
    {
        if (points[i].z != points[0].z || !(points[i].x > points[i - 1].x))
        {
            return false;
        }
    }
    return true;
}

static void sampleRow(const swQuery* query, const swTileChoice* choice, int count, const swPosXZ* rest, float (*out)[4],
                      float (*gradients)[8])
{
    double x[SW_QUERY_BLOCK];
    for (int i = 0; i < count; ++i)
    {
        x[i] = rest[i].x;
    }
    swSampleRow(query->kernels, choice, count, x, rest[0].z, out[0], gradients);
}

static void sampleField(const swQuery* query, int field, int count, const swPosXZ* rest, const swEvaluation* range,
                        float (*out)[4], float (*gradients)[8])
{
    const swTileChoice choice = {query->tileCount, query->tiles, fmaxf(range->shortest, query->def->minWavelength),
                                 range->longest, field};
    if (isRow(count, rest))
    {
        sampleRow(query, &choice, count, rest, out, gradients);
        return;
    }
    swSampleChosenTiles(query->kernels, &choice, count, rest, out[0], gradients != NULL ? gradients[0] : NULL);
}

static void evaluateMotion(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    bool needsVelocity = out->velocity != NULL && !swHasTexels(query, 1);
    bool needsAcceleration = out->acceleration != NULL && !swHasTexels(query, 2);
    if (needsVelocity || needsAcceleration)
    {
        sumTileMotion(query, count, rest, out, needsVelocity ? out->velocity : NULL,
                      needsAcceleration ? out->acceleration : NULL);
    }
    if (out->velocity != NULL && !needsVelocity)
    {
        sampleField(query, 1, count, rest, out, out->velocity, NULL);
    }
    if (out->acceleration != NULL && !needsAcceleration)
    {
        sampleField(query, 2, count, rest, out, out->acceleration, NULL);
    }
}

void swEvaluatePlain(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    size_t rows = (size_t)count * 4 * sizeof(float);
    if (out->velocity != NULL)
    {
        memset(out->velocity, 0, rows);
    }
    if (out->acceleration != NULL)
    {
        memset(out->acceleration, 0, rows);
    }
    if (query->isNow)
    {
        if (out->displacement != NULL)
        {
            sampleField(query, 0, count, rest, out, out->displacement, out->gradients);
        }
        evaluateMotion(query, count, rest, out);
    }
    else
    {
        if (out->displacement != NULL)
        {
            memset(out->displacement, 0, rows);
        }
        if (out->gradients != NULL)
        {
            memset(out->gradients, 0, 2 * rows);
        }
    }
    sumOneByOne(query, !query->isNow, count, rest, out);
}

static void evaluateFrame(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    if (query->places != NULL)
    {
        swEvaluateShaped(query, count, rest, out);
    }
    else
    {
        swEvaluatePlain(query, count, rest, out);
    }
}

// ---- between two frames ----

// Points of which both ends are held at once; it bounds the stack of a query.
#define BETWEEN_BLOCK 4

// Part of the way from what `out` has of a few points to what another frame has: of displacement and gradients (field
// 0), velocity (1) or acceleration (2).
static void blendField(const swQuery* to, float part, int field, int count, const swPosXZ* rest, int first,
                       const swEvaluation* out)
{
    float rows[BETWEEN_BLOCK][4], gradients[BETWEEN_BLOCK][8];
    float(*from)[4] = field == 0 ? out->displacement : field == 1 ? out->velocity : out->acceleration;
    const swEvaluation end = {
        .displacement = field == 0 ? rows : NULL,
        .gradients = field == 0 && out->gradients != NULL ? gradients : NULL,
        .velocity = field == 1 ? rows : NULL,
        .acceleration = field == 2 ? rows : NULL,
        .shortest = out->shortest,
        .longest = out->longest,
    };
    evaluateFrame(to, count, rest + first, &end);
    for (int i = 0; i < count; ++i)
    {
        for (int k = 0; k < 4; ++k)
        {
            from[first + i][k] += part * (rows[i][k] - from[first + i][k]);
        }
        for (int k = 0; k < 8 && end.gradients != NULL; ++k)
        {
            out->gradients[first + i][k] += part * (gradients[i][k] - out->gradients[first + i][k]);
        }
    }
}

// Texels of both frames; waves that are summed are of the query's own time on both sides, so that only their amplitudes
// are blended.
static void evaluateBetween(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    float part = (float)((double)(query->ticks - query->tileTicks) / (double)(query->after->ticks - query->tileTicks));
    swQuery at = *query;
    at.isNow = true;
    evaluateFrame(&at, count, rest, out);
    useFrame(&at, query->after);
    if (query->places == NULL || query->places == &query->inputPlaces)
    {
        usePlaces(&at, query->after);
    }
    const bool isAsked[3] = {out->displacement != NULL, out->velocity != NULL, out->acceleration != NULL};
    for (int field = 0; field < 3; ++field)
    {
        for (int i = 0; i < count && isAsked[field]; i += BETWEEN_BLOCK)
        {
            blendField(&at, part, field, count - i < BETWEEN_BLOCK ? count - i : BETWEEN_BLOCK, rest, i, out);
        }
    }
}

static bool isBetween(const swQuery* query)
{
    return query->after != NULL && query->ticks > query->tileTicks && query->ticks <= query->after->ticks;
}

void swEvaluate(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    if (isBetween(query))
    {
        evaluateBetween(query, count, rest, out);
    }
    else
    {
        evaluateFrame(query, count, rest, out);
    }
    swDisplaceWaves(query, count, rest, out);
    if (out->displacement != NULL && (out->levels != NULL || out->withHeights))
    {
        swDisplaceHeights(query, count, rest, out->displacement, out->gradients);
    }
    if (out->levels != NULL)
    {
        swFindLevels(query->places, query->ticks, count, rest, out->displacement, out->levels, out->gradients);
    }
}

swVec3 swMakeNormal(const float g[8], float* jacobian)
{
    float dxdz = g[6] != 0.0f ? g[1] : g[2];
    *jacobian = swSurfaceArea(g[0], dxdz, g[2], g[3]);
    float x = swSurfaceNormalX(g[2], g[3], g[4], g[5]);
    float z = swSurfaceNormalZ(g[0], dxdz, g[4], g[5]);
    float length = sqrtf(x * x + *jacobian * *jacobian + z * z);
    if (length < 1e-20f)
    {
        return (swVec3){0.0f, 1.0f, 0.0f};
    }
    float scale = (*jacobian < 0.0f ? -1.0f : 1.0f) / length;
    return (swVec3){-x * scale, *jacobian * scale, -z * scale};
}
