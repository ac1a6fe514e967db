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
    block->leastDepth = INFINITY;
    if ((block->touched & SW_TOUCHES_DEPTH) == 0)
    {
        return;
    }
    places->depth(places->context, -1, block->ticks, block->count, block->rest, block->depth, block->depthGradients);
    for (int i = 0; i < block->count; ++i)
    {
        if (!(block->depth[i] > 0.0f)) // dry
        {
            block->depth[i] = block->depthGradients[i][0] = block->depthGradients[i][1] = 0.0f;
        }
        block->leastDepth = fminf(block->leastDepth, block->depth[i]);
    }
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
        const float* g = block->flowGradients[i];
        isStill = isStill && block->flow[i][0] == 0.0f && block->flow[i][1] == 0.0f && g[0] == 0.0f && g[1] == 0.0f &&
                  g[2] == 0.0f && g[3] == 0.0f;
    }
    block->touched &= isStill ? ~SW_TOUCHES_FLOW : SW_TOUCHES_ALL;
}

void swBeginPlaces(swPlaceBlock* block, const swPlaces* places, const swWaveKernels* kernels, int64_t ticks, int count,
                   const swPosXZ* rest)
{
    block->places = places;
    block->kernels = kernels;
    block->ticks = ticks;
    block->count = count;
    block->rest = rest;
    block->system = -1;
    block->touched = swFindTouchedFields(places, ticks, count, rest, 0.0);
    findDepths(block);
    findFlow(block);
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

// Whether the depth takes some of the waves anywhere in the block. The share falls with the depth.
static bool isAttenuated(const swPlaceBlock* block, const swWaveGroup* group)
{
    if ((block->touched & SW_TOUCHES_DEPTH) == 0)
    {
        return false;
    }
    const swPlaces* places = block->places;
    float slope;
    float share = places->attenuate(places->context, group, block->leastDepth, &slope);
    return share != 1.0f || slope != 0.0f;
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

static bool isPointPlain(const swPlaceBlock* block, const swWaveGroup* group, int i)
{
    const swPlaces* places = block->places;
    const float* w = block->weightGradients[i];
    const float* g = block->flowGradients[i];
    bool isEven = !block->isWeighted || (block->weight[i] == 1.0f && w[0] == 0.0f && w[1] == 0.0f);
    bool isStill =
        (block->touched & SW_TOUCHES_FLOW) == 0 || (block->flow[i][0] == 0.0f && block->flow[i][1] == 0.0f &&
                                                    g[0] == 0.0f && g[1] == 0.0f && g[2] == 0.0f && g[3] == 0.0f);
    if (block->isGone || isPointWarped(block, i) || !isEven || !isStill)
    {
        return false;
    }
    float slope = 0.0f;
    return (block->touched & SW_TOUCHES_DEPTH) == 0 ||
           (places->attenuate(places->context, group, block->depth[i], &slope) == 1.0f && slope == 0.0f);
}

bool swKeepPlainPoints(swPlaceBlock* block, const swWaveGroup* group, bool* isPlain)
{
    findSystem(block, group->system);
    bool areAll = true;
    for (int i = 0; i < block->count; ++i)
    {
        isPlain[i] = isPlain[i] && isPointPlain(block, group, i);
        areAll = areAll && isPlain[i];
    }
    return areAll;
}

static void placePlain(const swPlaceBlock* block, swCopy* copy)
{
    memset(copy->way, 0, sizeof copy->way);
    copy->warps = NULL;
    for (int i = 0; i < block->count; ++i)
    {
        copy->source[i] = block->rest[i];
        copy->weight[i] = block->isWeighted ? block->weight[i] : 1.0f;
        copy->alongX[i] = block->isWeighted ? block->weightGradients[i][0] : 0.0f;
        copy->alongZ[i] = block->isWeighted ? block->weightGradients[i][1] : 0.0f;
    }
}

static void placeWarped(const swPlaceBlock* block, const swWarp* warps, swCopy* copy)
{
    copy->warps = warps;
    for (int i = 0; i < block->count; ++i)
    {
        copy->source[i] = warps[i].source;
        copy->weight[i] = warps[i].weight;
        copy->alongX[i] = warps[i].alongX;
        copy->alongZ[i] = warps[i].alongZ;
        memcpy(copy->way[i], warps[i].gradients, sizeof copy->way[i]);
    }
}

// Product rule: a weight times what the depth leaves.
static void attenuate(const swPlaceBlock* block, const swWaveGroup* group, swCopy* copy)
{
    const swPlaces* places = block->places;
    for (int i = 0; i < block->count; ++i)
    {
        float slope;
        float share = places->attenuate(places->context, group, block->depth[i], &slope);
        slope *= copy->weight[i];
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

void swFindLook(swPlaceBlock* block, const swWaveGroup* group, int index, swLook* look)
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
        attenuate(block, group, &look->copies[0]);
    }
    if ((block->touched & SW_TOUCHES_FLOW) != 0)
    {
        swCarryLook(block, group, look);
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
    if (places == NULL || places->flow == NULL)
    {
        return;
    }
    float flow[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4];
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        places->flow(places->context, ticks, some, points + first, flow, gradients);
        for (int i = 0; i < some; ++i)
        {
            velocities[first + i][0] += flow[i][0];
            velocities[first + i][2] += flow[i][1];
        }
    }
}
