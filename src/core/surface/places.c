// SPDX-License-Identifier: MIT
#include "core/surface/places.h"

#include <math.h>
#include <string.h>

void swBeginPlaces(swPlaceBlock* block, const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest)
{
    block->places = places;
    block->ticks = ticks;
    block->count = count;
    block->rest = rest;
    block->system = -1;
    if (places->depth != NULL)
    {
        places->depth(places->context, -1, ticks, count, rest, block->depth, block->depthGradients);
    }
}

static void findWeights(const swPlaceBlock* block, int system, swShape* shape)
{
    const swPlaces* places = block->places;
    float gradients[SW_PLACE_BLOCK][2];
    if (places->weight != NULL)
    {
        places->weight(places->context, system, block->ticks, block->count, block->rest, shape->weight, gradients);
    }
    for (int i = 0; i < block->count; ++i)
    {
        bool isSet = places->weight != NULL;
        shape->weight[i] = isSet ? shape->weight[i] : 1.0f;
        shape->alongX[i] = isSet ? gradients[i][0] : 0.0f;
        shape->alongZ[i] = isSet ? gradients[i][1] : 0.0f;
    }
}

static void findSources(const swPlaceBlock* block, int system, swShape* shape)
{
    const swPlaces* places = block->places;
    memcpy(shape->source, block->rest, (size_t)block->count * sizeof(swPosXZ));
    memset(shape->warp, 0, sizeof shape->warp);
    if (places->warp == NULL)
    {
        return;
    }
    float ways[SW_PLACE_BLOCK][2];
    places->warp(places->context, system, block->ticks, block->count, block->rest, ways, shape->warp);
    for (int i = 0; i < block->count; ++i)
    {
        shape->source[i].x += (double)ways[i][0];
        shape->source[i].z += (double)ways[i][1];
    }
}

// Product rule: a weight times what the depth leaves.
static void attenuate(const swPlaceBlock* block, float k, swShape* shape)
{
    for (int i = 0; i < block->count; ++i)
    {
        float slope;
        float share = block->places->attenuate(k * block->depth[i], &slope);
        slope *= k * shape->weight[i];
        shape->alongX[i] = shape->alongX[i] * share + slope * block->depthGradients[i][0];
        shape->alongZ[i] = shape->alongZ[i] * share + slope * block->depthGradients[i][1];
        shape->weight[i] *= share;
    }
}

void swFindShape(swPlaceBlock* block, int system, float k, swShape* shape)
{
    if (block->system != system)
    {
        findWeights(block, system, &block->shape);
        findSources(block, system, &block->shape);
        block->system = system;
    }
    *shape = block->shape;
    if (block->places->depth != NULL && block->places->attenuate != NULL)
    {
        attenuate(block, k, shape);
    }
}

static void findSomeLevels(const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest,
                           float (*displacement)[4], float* levels, float (*gradients)[8])
{
    swPosXZ points[SW_PLACE_BLOCK] = {{0.0, 0.0}};
    float slopes[SW_PLACE_BLOCK][2];
    for (int i = 0; i < count; ++i)
    {
        points[i].x = rest[i].x + (double)displacement[i][0];
        points[i].z = rest[i].z + (double)displacement[i][2];
    }
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
