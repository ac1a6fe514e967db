// SPDX-License-Identifier: MIT
// The motion of the water below its surface, by linear theory: each wave's velocity potential fades as
// cosh k (y + d) / cosh k d [Dean and Dalrymple 1991]. Heights y count from still water.
//
// Between trough and crest linear theory has nothing to say. Wheeler's stretching [Wheeler 1970] lets heights count
// from the surface: with eta the water's height above a place, y' = d (d + y) / (d + eta) - d, in deep water y - eta,
// so that the surface moves as linear theory says of still water. It needs eta, which is searched for as for any query.
//
// Waves that their places shape have the share, the way and the turn there that they have at the surface above.
//
// Which waves are too short to reach a place depends on its own height alone (waves_sum.inl), so that its bits do not
// depend on the batch that it came in.

#include "core/query/volume.h"

#include <math.h>
#include <string.h>

#include "core/frame/asked.h"
#include "core/math/scalar.h"
#include "core/query/answers.h"
#include "core/surface/search.h"

// Places that can be answered: `at` says which they are.
typedef struct Block
{
    int count;
    int at[SW_QUERY_BLOCK];
    swPosXZ points[SW_QUERY_BLOCK]; // in the sea
    float levels[SW_QUERY_BLOCK];   // above sea level
    float heights[SW_QUERY_BLOCK];  // the same, stretched; of a place in the air none that a wave reaches
    bool isWet[SW_QUERY_BLOCK];
    float depth[SW_QUERY_BLOCK]; // below the surface
} Block;

static float findBottom(const swQuery* query)
{
    float bottom = INFINITY;
    for (int i = 0; i < query->tileCount; ++i)
    {
        bottom = swIsTileAsked(query, &query->tiles[i]) ? fminf(bottom, query->tiles[i].depth) : bottom;
    }
    for (int i = 0; i < query->waveCount; ++i)
    {
        bottom = fminf(bottom, query->waves[i].depth);
    }
    return bottom;
}

// Height y' that counts for a place y under water of height eta.
static float stretch(float y, float eta, float bottom)
{
    float below = y - eta;
    if (!(bottom < 1e9f))
    {
        return below;
    }
    float column = bottom + eta;
    return column > 0.0f ? bottom * below / column : 0.0f;
}

static void markBad(const swVolumeSamples* samples, int point)
{
    float* numbers[] = {samples->depth, samples->pressureHead};
    swVec3* vectors[] = {samples->velocity, samples->acceleration};
    for (int i = 0; i < 2; ++i)
    {
        if (numbers[i] != NULL)
        {
            numbers[i][point] = SW_NO_NUMBER;
        }
        if (vectors[i] != NULL)
        {
            vectors[i][point] = SW_NO_VECTOR;
        }
    }
}

void swRefuseVolume(int count, const swVolumeSamples* samples, swQueryStats* stats)
{
    for (int i = 0; i < count && samples != NULL; ++i)
    {
        markBad(samples, i);
    }
    swRefuseStats(count, stats);
}

// Fill a block from place `first` on; those on the way that cannot be answered are marked and counted.
// Returns the place to go on with.
static int fillBlock(const swQuery* query, int first, int count, const swPos* points, const swVolumeSamples* samples,
                     Block* block, swQueryStats* stats)
{
    block->count = 0;
    int point = first;
    for (; point < count && block->count < SW_QUERY_BLOCK; ++point)
    {
        int i = block->count;
        bool isGood =
            swPlacePoint(query, points[point].x, points[point].z, &block->points[i]) && swIsNear(points[point].y);
        if (isGood)
        {
            block->at[i] = point;
            block->levels[i] = (float)(points[point].y - query->seaLevel);
            block->count += 1;
        }
        else
        {
            markBad(samples, point);
            stats->badCount += 1;
        }
    }
    return point;
}

__attribute__((noinline)) static void searchBlock(const swQuery* query, float bottom, Block* block, swQueryStats* stats)
{
    swFound found;
    found.gradients = NULL;
    swFindParticles(query, block->count, block->points, NULL, &found);
    for (int i = 0; i < block->count; ++i)
    {
        float y = block->levels[i] - found.levels[i];
        float eta = found.displacement[i][1];
        block->depth[i] = eta - y;
        block->isWet[i] = eta >= y;
        float stretched = query->def->stretching == SW_STRETCHING_WHEELER ? stretch(y, eta, bottom) : y;
        block->heights[i] = block->isWet[i] ? fminf(stretched, 0.0f) : -INFINITY;
    }
    swCountFound(stats, &found, block->count, query->def->tolerance);
}

// Places from `first` on whose waves are as anywhere.
static void sumPlain(const swQuery* query, const Block* block, int first, int count, const swDepthSums* sums)
{
    const swDepthSums own = {sums->velocity + first, sums->acceleration + first, sums->head + first};
    const swWaveSumJob job = {
        .tileCount = query->tileCount,
        .tiles = query->tiles,
        .shortest = query->def->minWavelength,
        .waveCount = query->waveCount,
        .waves = query->waves,
        .ticks = query->ticks,
        .count = count,
        .points = block->points + first,
        .heights = block->heights + first,
        .below = &own,
    };
    swSumWaves(query->kernels, &job);
}

// Waves of a group at one place, `from` there, with a weight, turned as its own axes are.
static void addGroup(const swQuery* query, const swWaveGroup* group, const swCopy* copy, float height, float* velocity,
                     float* acceleration, float* head)
{
    float v[1][4] = {{0.0f}}, a[1][4] = {{0.0f}}, h[1] = {0.0f};
    const swDepthSums own = {v, a, h};
    const swWaveSumJob job = {
        .tileCount = group->tile != NULL ? 1 : 0,
        .tiles = group->tile,
        .waveCount = group->waveCount,
        .waves = group->waves,
        .ticks = query->ticks,
        .count = 1,
        .points = copy->source,
        .heights = &height,
        .below = &own,
    };
    swSumWaves(query->kernels, &job);
    float c = copy->warps != NULL ? copy->warps[0].cosine : 1.0f;
    float s = copy->warps != NULL ? copy->warps[0].sine : 0.0f;
    float weight = copy->weight[0];
    velocity[0] += weight * (c * v[0][0] - s * v[0][2]);
    velocity[1] += weight * v[0][1];
    velocity[2] += weight * (s * v[0][0] + c * v[0][2]);
    acceleration[0] += weight * (c * a[0][0] - s * a[0][2]);
    acceleration[1] += weight * a[0][1];
    acceleration[2] += weight * (s * a[0][0] + c * a[0][2]);
    *head += weight * h[0];
}

// One place whose waves are shaped: each group by its share, as at the surface above.
static void sumShaped(const swQuery* query, const Block* block, int i, const swDepthSums* sums)
{
    swPlaceBlock place;
    swLook look;
    swWarp warps[SW_MAX_WARPS][SW_PLACE_BLOCK];
    swBeginPlaces(&place, query->places, warps, query->kernels, query->ticks, 1, &block->points[i]);
    for (int t = 0, w = 0; t < query->tileCount || w < query->waveCount;)
    {
        bool isTile = t < query->tileCount;
        swWaveGroup group =
            isTile ? swGroupTile(&query->tiles[t]) : swGroupFreeWaves(query->waveCount - w, query->waves + w);
        t += isTile ? 1 : 0;
        w += group.waveCount;
        if (isTile && !swIsTileAsked(query, group.tile))
        {
            continue;
        }
        int lookCount = swCountLooks(&place, &group);
        for (int n = 0; n < lookCount; ++n)
        {
            swFindLook(&place, &group, n, false, &look);
            for (int k = 0; k < look.copyCount; ++k)
            {
                addGroup(query, &group, &look.copies[k], block->heights[i], sums->velocity[i], sums->acceleration[i],
                         &sums->head[i]);
            }
        }
    }
}

static bool areShaped(const swQuery* query, int count, const swPosXZ* points)
{
    const swPlaces* places = query->places;
    return places != NULL && (places->localSystems != 0 ||
                              (swFindTouchedFields(places, query->ticks, count, points, 0.0) & ~SW_TOUCHES_LEVEL) != 0);
}

// Whether places shape the waves is found for each point by itself: its bits do not depend on the others.
static void sumBlock(const swQuery* query, const Block* block, const swDepthSums* sums)
{
    if (!areShaped(query, block->count, block->points))
    {
        sumPlain(query, block, 0, block->count, sums);
        return;
    }
    for (int i = 0; i < block->count; ++i)
    {
        if (!areShaped(query, 1, &block->points[i]))
        {
            sumPlain(query, block, i, 1, sums);
            continue;
        }
        sumShaped(query, block, i, sums);
    }
}

static void writeBlock(const Block* block, const swDepthSums* sums, const swVolumeSamples* samples)
{
    for (int i = 0; i < block->count; ++i)
    {
        const float* v = sums->velocity[i];
        const float* a = sums->acceleration[i];
        if (samples->depth != NULL)
        {
            samples->depth[block->at[i]] = block->depth[i];
        }
        if (samples->velocity != NULL)
        {
            samples->velocity[block->at[i]] = (swVec3){v[0], v[1], v[2]};
        }
        if (samples->acceleration != NULL)
        {
            samples->acceleration[block->at[i]] = (swVec3){a[0], a[1], a[2]};
        }
        if (samples->pressureHead != NULL)
        {
            samples->pressureHead[block->at[i]] = sums->head[i];
        }
    }
}

// A flow is that of the surface, down to the bottom; the air has none.
static void addFlow(const swQuery* query, const Block* block, float (*velocity)[4])
{
    swAddFlow(query->places, query->ticks, block->count, block->points, velocity);
    for (int i = 0; i < block->count; ++i)
    {
        if (!block->isWet[i])
        {
            memset(velocity[i], 0, sizeof velocity[i]);
        }
    }
}

// Not inlined: what it needs shall not be on the stack together with what the search needs.
__attribute__((noinline)) static void answerBlock(const swQuery* query, const Block* block,
                                                  const swVolumeSamples* samples)
{
    float velocity[SW_QUERY_BLOCK][4] = {{0.0f}};
    float acceleration[SW_QUERY_BLOCK][4] = {{0.0f}};
    float head[SW_QUERY_BLOCK] = {0.0f};
    const swDepthSums sums = {velocity, acceleration, head};
    if (samples->velocity != NULL || samples->acceleration != NULL || samples->pressureHead != NULL)
    {
        sumBlock(query, block, &sums);
    }
    if (samples->velocity != NULL)
    {
        addFlow(query, block, velocity);
    }
    writeBlock(block, &sums, samples);
}

static void queryBlock(const swQuery* query, float bottom, Block* block, const swVolumeSamples* samples,
                       swQueryStats* stats)
{
    searchBlock(query, bottom, block, stats);
    answerBlock(query, block, samples);
}

void swQueryVolume(const swQuery* query, int count, const swPos* points, const swVolumeSamples* samples,
                   swQueryStats* stats)
{
    swQueryStats total = {0};
    float bottom = findBottom(query);
    Block block;
    for (int next = 0; next < count;)
    {
        next = fillBlock(query, next, count, points, samples, &block, &total);
        if (block.count > 0)
        {
            queryBlock(query, bottom, &block, samples, &total);
        }
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}

// ---- Stokes drift ----

// Of a wave of amplitude 1: omega k cosh 2 k (d - depth) / (2 sinh^2 k d), in deep water omega k exp(-2 k depth).
static double getDrift(double k, double omega, double waterDepth, double depth)
{
    if (depth > waterDepth)
    {
        return 0.0;
    }
    double down = swExp(-2.0 * k * depth);
    if (!(waterDepth < 1e9))
    {
        return omega * k * down;
    }
    double twice = swExp(-2.0 * k * waterDepth);
    double up = swExp(-2.0 * k * (2.0 * waterDepth - depth));
    return omega * k * (down + up) / ((1.0 - twice) * (1.0 - twice));
}

static double getOmegaOf(uint64_t frequency)
{
    return (double)frequency * (SW_TICKS_PER_SECOND * 2.0 * SW_PI * 0x1p-64);
}

// A pair of opposite waves: their drifts are opposite too.
static void addModeDrift(const swTile* tile, const swMode* mode, double depth, double drift[2])
{
    int qx = mode->qx < 0 ? -mode->qx : mode->qx;
    double damping = (double)tile->response[qx] * (double)tile->response[mode->qz] * (double)tile->weight;
    double forwardRe = (double)mode->pr + (double)mode->qr, forwardIm = (double)mode->pi + (double)mode->qi;
    double backRe = (double)mode->pr - (double)mode->qr, backIm = (double)mode->pi - (double)mode->qi;
    double squares = forwardRe * forwardRe + forwardIm * forwardIm - backRe * backRe - backIm * backIm;
    double q = sqrt((double)(mode->qx * mode->qx + mode->qz * mode->qz));
    double k = 2.0 * SW_PI * q / tile->side;
    double omega = getOmegaOf(((uint64_t)mode->frequencyHigh << 32) | mode->frequencyLow);
    double speed = damping * damping * squares * getDrift(k, omega, (double)tile->depth, depth);
    drift[0] += speed * mode->qx / q;
    drift[1] += speed * mode->qz / q;
}

swVec2 swFindStokesDrift(const swQuery* query, double depthBelow)
{
    double drift[2] = {0.0, 0.0};
    for (int i = 0; i < query->tileCount; ++i)
    {
        const swTile* tile = &query->tiles[i];
        for (int m = 0; m < tile->modeCount && swIsTileAsked(query, tile); ++m)
        {
            addModeDrift(tile, &tile->modes[m], depthBelow, drift);
        }
    }
    for (int i = 0; i < query->waveCount; ++i)
    {
        const swFreeWave* wave = &query->waves[i];
        double turns = sqrt(wave->turnsX * wave->turnsX + wave->turnsZ * wave->turnsZ);
        double square = (double)wave->amplitude * (double)wave->amplitude;
        double speed =
            square * getDrift(2.0 * SW_PI * turns, getOmegaOf(wave->frequency), (double)wave->depth, depthBelow);
        drift[0] += speed * wave->turnsX / turns;
        drift[1] += speed * wave->turnsZ / turns;
    }
    return (swVec2){(float)drift[0], (float)drift[1]};
}
