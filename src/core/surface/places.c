// SPDX-License-Identifier: MIT
#include "core/surface/places.h"

#include <math.h>
#include <string.h>

#include "core/surface/carry.h"

// ---- a block of points ----

uint32_t swFindTouchedFields(const swPlaces* places, int64_t ticks, int count, const swPosXZ* points, double reach)
{
    uint32_t there = (places->level != NULL ? SW_TOUCHES_LEVEL : 0) |
                     (places->depth != NULL && places->attenuate != NULL ? SW_TOUCHES_DEPTH : 0) |
                     (places->weight != NULL ? SW_TOUCHES_WEIGHT : 0) | (places->warps != NULL ? SW_TOUCHES_WARP : 0) |
                     (places->flow != NULL ? SW_TOUCHES_FLOW : 0);
    bool isAsked = there != 0 && places->touched != NULL;
    return isAsked ? there & places->touched(places->context, ticks, count, points, reach) : there;
}

static void findDepths(swPlaceBlock* block)
{
    const swPlaces* places = block->places;
    block->sharedWaves = NULL;
    if ((block->touched & SW_TOUCHES_DEPTH) == 0)
    {
        return;
    }
    memset(block->depth, 0, sizeof block->depth);
    places->depth(places->context, -1, block->ticks, block->count, block->rest, block->depth, block->depthGradients);
    for (int i = 0; i < block->count; ++i)
    {
        if (!(block->depth[i] > 0.0f)) // dry
        {
            block->depth[i] = block->depthGradients[i][0] = block->depthGradients[i][1] = 0.0f;
        }
    }
}

static bool isMoving(const swPlaceBlock* block, int i)
{
    const float *v = block->flow[i], *g = block->flowGradients[i];
    float sum = fabsf(v[0]) + fabsf(v[1]) + fabsf(g[0]) + fabsf(g[1]) + fabsf(g[2]) + fabsf(g[3]);
    return sum > 0.0f && sum <= 1e9f; // what a damaged moment says that is no number carries nothing
}

static void findFlow(swPlaceBlock* block)
{
    const swPlaces* places = block->places;
    if ((block->touched & SW_TOUCHES_FLOW) == 0)
    {
        return;
    }
    places->flow(places->context, block->ticks, block->count, block->rest, block->flow, block->flowGradients);
    bool isStill = true;
    for (int i = 0; i < block->count; ++i)
    {
        block->isMoving[i] = isMoving(block, i);
        isStill = isStill && !block->isMoving[i];
    }
    block->touched &= isStill ? ~SW_TOUCHES_FLOW : SW_TOUCHES_ALL;
}

void swBeginPlaces(swPlaceBlock* block, const swPlaces* places, swWarp (*warps)[SW_PLACE_BLOCK],
                   const swWaveKernels* kernels, int64_t ticks, int count, const swPosXZ* rest)
{
    block->warps = warps;
    block->places = places;
    block->kernels = kernels;
    block->ticks = ticks;
    block->count = count;
    memcpy(block->rest, rest, (size_t)count * sizeof *rest);
    memset(block->isAsked, true, sizeof block->isAsked);
    block->areAllAsked = true;
    block->system = -1;
    block->warpCount = 0;
    block->touched = swFindTouchedFields(places, ticks, count, rest, 0.0);
    findDepths(block);
    findFlow(block);
}

static void moveDepth(swPlaceBlock* block, int i, float x, float z)
{
    float depth = block->depth[i] + block->depthGradients[i][0] * x + block->depthGradients[i][1] * z;
    block->depth[i] = fmaxf(depth, 0.0f);
}

static void moveFlow(swPlaceBlock* block, int i, float x, float z)
{
    const float* g = block->flowGradients[i];
    block->flow[i][0] += g[0] * x + g[1] * z;
    block->flow[i][1] += g[2] * x + g[3] * z;
}

void swMovePlaces(swPlaceBlock* block, const swPosXZ* rest)
{
    for (int i = 0; i < block->count; ++i)
    {
        float x = (float)(rest[i].x - block->rest[i].x), z = (float)(rest[i].z - block->rest[i].z);
        block->rest[i] = rest[i];
        if ((block->touched & SW_TOUCHES_DEPTH) != 0)
        {
            moveDepth(block, i, x, z);
        }
        if ((block->touched & SW_TOUCHES_FLOW) != 0)
        {
            moveFlow(block, i, x, z);
        }
        if (block->system >= 0 && block->isWeighted)
        {
            block->weight[i] += block->weightGradients[i][0] * x + block->weightGradients[i][1] * z;
        }
    }
    memset(block->isAsked, true, sizeof block->isAsked);
    block->areAllAsked = true;
    block->sharedWaves = NULL;
}

// ---- a system ----

static void findWeights(swPlaceBlock* block, int system)
{
    const swPlaces* places = block->places;
    if ((block->touched & SW_TOUCHES_WEIGHT) == 0)
    {
        block->isWeighted = false;
        block->isGone = (places->localSystems >> system & 1u) != 0;
        return;
    }
    places->weight(places->context, system, block->ticks, block->count, block->rest, block->weight,
                   block->weightGradients);
    bool isOne = true, isNone = true;
    for (int i = 0; i < block->count; ++i)
    {
        bool isEven = block->weightGradients[i][0] == 0.0f && block->weightGradients[i][1] == 0.0f;
        isOne = isOne && isEven && block->weight[i] == 1.0f;
        isNone = isNone && isEven && block->weight[i] == 0.0f;
    }
    block->isWeighted = !isOne;
    block->isGone = isNone;
}

static void findSystem(swPlaceBlock* block, int system)
{
    if (block->system == system)
    {
        return;
    }
    const swPlaces* places = block->places;
    block->system = system;
    findWeights(block, system);
    block->warpCount = (block->touched & SW_TOUCHES_WARP) != 0 ? places->warps(places->context, system, block->ticks,
                                                                               block->count, block->rest, block->warps)
                                                               : 0;
}

// ---- groups of waves ----

swWaveGroup swGroupTile(const swTile* tile)
{
    return (swWaveGroup){.system = tile->system, .k = swGetTileWaveNumber(tile), .tile = tile};
}

swWaveGroup swGroupFreeWaves(int count, const swFreeWave* waves)
{
    float k = swGetOctaveWaveNumber(waves[0].wavelength);
    return (swWaveGroup){
        .system = waves[0].system, .k = k, .waveCount = swFindCarriedEnd(waves, 0, count), .waves = waves};
}

// ---- shapes ----

// What the depth leaves of a group's waves at each point: found once, however often it is asked. Returns whether it
// takes some of them anywhere in the block.
static bool isAttenuated(swPlaceBlock* block, const swWaveGroup* group)
{
    const swPlaces* places = block->places;
    const void* waves = group->tile != NULL ? (const void*)group->tile : (const void*)group->waves;
    if ((block->touched & SW_TOUCHES_DEPTH) == 0)
    {
        return false;
    }
    if (block->sharedWaves == waves)
    {
        return block->isShared;
    }
    places->attenuate(places->context, block->kernels, group, block->count, block->depth, block->share,
                      block->shareSlope);
    block->sharedWaves = waves;
    block->isShared = false;
    for (int i = 0; i < block->count; ++i)
    {
        block->isShared = block->isShared || block->share[i] != 1.0f || block->shareSlope[i] != 0.0f;
    }
    return block->isShared;
}

bool swIsGroupPlain(swPlaceBlock* block, const swWaveGroup* group)
{
    findSystem(block, group->system);
    return !block->isGone && !block->isWeighted && block->warpCount == 0 && (block->touched & SW_TOUCHES_FLOW) == 0 &&
           !isAttenuated(block, group);
}

static bool isPointWarped(const swPlaceBlock* block, int i)
{
    bool isWarped = false;
    for (int w = 0; w < block->warpCount; ++w)
    {
        const swWarp* warp = &block->warps[w][i];
        isWarped = isWarped || warp->weight != 0.0f || warp->alongX != 0.0f || warp->alongZ != 0.0f;
    }
    return isWarped;
}

static bool isPointPlain(const swPlaceBlock* block, int i)
{
    const float* w = block->weightGradients[i];
    bool isEven = !block->isWeighted || (block->weight[i] == 1.0f && w[0] == 0.0f && w[1] == 0.0f);
    bool isStill = (block->touched & SW_TOUCHES_FLOW) == 0 || !block->isMoving[i];
    bool isDeep = (block->touched & SW_TOUCHES_DEPTH) == 0 || (block->share[i] == 1.0f && block->shareSlope[i] == 0.0f);
    return !block->isGone && isEven && isStill && isDeep && !isPointWarped(block, i);
}

bool swKeepPlainPoints(swPlaceBlock* block, const swWaveGroup* group, bool* isPlain)
{
    findSystem(block, group->system);
    isAttenuated(block, group);
    bool isAny = false;
    for (int i = 0; i < block->count; ++i)
    {
        isPlain[i] = isPlain[i] && isPointPlain(block, i);
        isAny = isAny || isPlain[i];
    }
    return isAny;
}

void swAskPoints(swPlaceBlock* block, const bool* isAsked)
{
    block->areAllAsked = true;
    for (int i = 0; i < block->count; ++i)
    {
        block->isAsked[i] = isAsked[i];
        block->areAllAsked = block->areAllAsked && isAsked[i];
    }
}

static void placePlain(const swPlaceBlock* block, swCopy* copy)
{
    copy->hasWay = false;
    copy->warps = NULL;
    for (int i = 0; i < block->count; ++i)
    {
        bool isWeighted = block->isWeighted && block->isAsked[i];
        copy->source[i] = block->rest[i];
        copy->weight[i] = isWeighted ? block->weight[i] : block->isAsked[i] ? 1.0f : 0.0f;
        copy->alongX[i] = isWeighted ? block->weightGradients[i][0] : 0.0f;
        copy->alongZ[i] = isWeighted ? block->weightGradients[i][1] : 0.0f;
    }
}

static void placeWarped(const swPlaceBlock* block, const swWarp* warps, swCopy* copy)
{
    copy->warps = warps;
    copy->hasWay = true;
    for (int i = 0; i < block->count; ++i)
    {
        copy->source[i] = warps[i].source;
        copy->weight[i] = block->isAsked[i] ? warps[i].weight : 0.0f;
        copy->alongX[i] = block->isAsked[i] ? warps[i].alongX : 0.0f;
        copy->alongZ[i] = block->isAsked[i] ? warps[i].alongZ : 0.0f;
        memcpy(copy->way[i], warps[i].gradients, sizeof copy->way[i]);
    }
}

// Product rule: a weight times what the depth leaves.
static void attenuate(const swPlaceBlock* block, swCopy* copy)
{
    for (int i = 0; i < block->count; ++i)
    {
        float share = block->share[i], slope = block->shareSlope[i] * copy->weight[i];
        copy->alongX[i] = copy->alongX[i] * share + slope * block->depthGradients[i][0];
        copy->alongZ[i] = copy->alongZ[i] * share + slope * block->depthGradients[i][1];
        copy->weight[i] *= share;
    }
}

int swCountLooks(swPlaceBlock* block, const swWaveGroup* group)
{
    findSystem(block, group->system);
    return (block->isGone ? 0 : 1) + block->warpCount;
}

void swFindLook(swPlaceBlock* block, const swWaveGroup* group, int index, bool withSlopes, swLook* look)
{
    findSystem(block, group->system);
    int warp = block->isGone ? index : index - 1;
    look->copyCount = 1;
    if (warp < 0)
    {
        placePlain(block, &look->copies[0]);
    }
    else
    {
        placeWarped(block, block->warps[warp], &look->copies[0]);
    }
    if (isAttenuated(block, group))
    {
        attenuate(block, &look->copies[0]);
    }
    if ((block->touched & SW_TOUCHES_FLOW) != 0)
    {
        swCarryLook(block, group, withSlopes, look);
    }
}

// ---- what lies under the waves ----

static void placeMoved(int count, const swPosXZ* rest, float (*displacement)[4], swPosXZ* points)
{
    for (int i = 0; i < count; ++i)
    {
        points[i].x = rest[i].x + (double)displacement[i][0];
        points[i].z = rest[i].z + (double)displacement[i][2];
    }
}

static void findSomeLevels(const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest,
                           float (*displacement)[4], float* levels, float (*gradients)[8])
{
    swPosXZ points[SW_PLACE_BLOCK] = {{0.0, 0.0}};
    float slopes[SW_PLACE_BLOCK][2];
    placeMoved(count, rest, displacement, points);
    places->level(places->context, -1, ticks, count, points, levels, slopes);
    for (int i = 0; i < count && gradients != NULL; ++i)
    {
        // Chain rule: the level is a function of where particles are, gradients are by where they rest.
        float* g = gradients[i];
        g[4] += slopes[i][0] * (1.0f + g[0]) + slopes[i][1] * g[2];
        g[5] += slopes[i][0] * g[1] + slopes[i][1] * (1.0f + g[3]);
    }
}

void swFindLevels(const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest, float (*displacement)[4],
                  float* levels, float (*gradients)[8])
{
    if (places == NULL || places->level == NULL)
    {
        memset(levels, 0, (size_t)count * sizeof(float));
        return;
    }
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        findSomeLevels(places, ticks, some, rest + first, displacement + first, levels + first,
                       gradients != NULL ? gradients + first : NULL);
    }
}

void swAddFlow(const swPlaces* places, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[4])
{
    swFindFlow* find = places == NULL ? NULL : places->water != NULL ? places->water : places->flow;
    if (find == NULL)
    {
        return;
    }
    float flow[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4];
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        find(places->context, ticks, some, points + first, flow, gradients);
        for (int i = 0; i < some; ++i)
        {
            velocities[first + i][0] += flow[i][0];
            velocities[first + i][2] += flow[i][1];
        }
    }
}
