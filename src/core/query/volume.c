// SPDX-License-Identifier: MIT
// The motion of the water below its surface, by linear theory: each wave's velocity potential fades as
// cosh k (y + d) / cosh k d [Dean and Dalrymple 1991]. Heights y count from still water.
//
// Between trough and crest linear theory has nothing to say. Wheeler's stretching [Wheeler 1970] lets heights count from
// the surface: with eta the water's height above a place, y' = d (d + y) / (d + eta) - d, in deep water y - eta, so that
// the surface moves as linear theory says of still water. It needs eta, which is searched for as for any query.

#include "core/query/volume.h"

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"

// Waves that have faded to exp(-20) do not count.
#define FADED 20.0f

typedef struct Block
{
    int count;
    swPosXZ points[SW_QUERY_BLOCK]; // in the sea
    float heights[SW_QUERY_BLOCK];  // above still water, stretched
    bool isWet[SW_QUERY_BLOCK];
    float depth[SW_QUERY_BLOCK]; // below the surface
} Block;

static float findBottom(const swQuery* query)
{
    float bottom = INFINITY;
    for (int i = 0; i < query->tileCount; ++i)
    {
        bottom = fminf(bottom, query->tiles[i].depth);
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

static void placeBlock(const swQuery* query, const swPos* points, float bottom, Block* block)
{
    for (int i = 0; i < block->count; ++i)
    {
        block->points[i] = (swPosXZ){points[i].x + query->origin.x, points[i].z + query->origin.z};
    }
    swFound found;
    swFindParticles(query, block->count, block->points, &found);
    for (int i = 0; i < block->count; ++i)
    {
        float y = (float)(points[i].y - query->seaLevel);
        float eta = found.displacement[i][1];
        block->depth[i] = eta - y;
        block->isWet[i] = eta >= y;
        float stretched = query->def->stretching == SW_STRETCHING_WHEELER ? stretch(y, eta, bottom) : y;
        block->heights[i] = fminf(stretched, 0.0f);
    }
}

// Sum of the waves that reach the highest place of the block.
static void sumBlock(const swQuery* query, const Block* block, const swDepthSums* sums)
{
    float highest = -INFINITY;
    for (int i = 0; i < block->count; ++i)
    {
        highest = fmaxf(highest, block->heights[i]);
    }
    float shortest = -highest * 6.2831853f / FADED;
    swTile tiles[SW_MAX_TILES];
    int tileCount = 0;
    for (int i = 0; i < query->tileCount; ++i)
    {
        if (query->tiles[i].maxWavelength > shortest)
        {
            tiles[tileCount++] = query->tiles[i];
        }
    }
    int waveCount = query->waveCount;
    while (waveCount > 0 && query->waves[waveCount - 1].wavelength < shortest)
    {
        waveCount -= 1;
    }
    const swWaveSumJob job = {
        .tileCount = tileCount,
        .tiles = tiles,
        .waveCount = waveCount,
        .waves = query->waves,
        .ticks = query->ticks,
        .count = block->count,
        .points = block->points,
        .heights = block->heights,
        .below = sums,
    };
    swSumWaves(query->kernels, &job);
}

static swVec3 takeVector(const Block* block, int i, float (*rows)[4])
{
    return block->isWet[i] ? (swVec3){rows[i][0], rows[i][1], rows[i][2]} : (swVec3){0.0f, 0.0f, 0.0f};
}

void swQueryVolume(const swQuery* query, int count, const swPos* points, const swVolumeSamples* samples)
{
    float bottom = findBottom(query);
    for (int first = 0; first < count; first += SW_QUERY_BLOCK)
    {
        Block block = {.count = count - first < SW_QUERY_BLOCK ? count - first : SW_QUERY_BLOCK};
        placeBlock(query, points + first, bottom, &block);
        float velocity[SW_QUERY_BLOCK][4] = {{0.0f}};
        float acceleration[SW_QUERY_BLOCK][4] = {{0.0f}};
        float head[SW_QUERY_BLOCK] = {0.0f};
        const swDepthSums sums = {velocity, acceleration, head};
        bool needsSums = samples->velocity != NULL || samples->acceleration != NULL || samples->pressureHead != NULL;
        if (needsSums)
        {
            sumBlock(query, &block, &sums);
        }
        for (int i = 0; i < block.count; ++i)
        {
            if (samples->depth != NULL)
            {
                samples->depth[first + i] = block.depth[i];
            }
            if (samples->velocity != NULL)
            {
                samples->velocity[first + i] = takeVector(&block, i, velocity);
            }
            if (samples->acceleration != NULL)
            {
                samples->acceleration[first + i] = takeVector(&block, i, acceleration);
            }
            if (samples->pressureHead != NULL)
            {
                samples->pressureHead[first + i] = block.isWet[i] ? head[i] : 0.0f;
            }
        }
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
        for (int m = 0; m < tile->modeCount; ++m)
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
