// SPDX-License-Identifier: MIT
#include "core/surface/carry.h"

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"
#include "shared/carry.h"

static int64_t getLoopTicks(const swWaveGroup* group)
{
    return group->tile != NULL ? group->tile->loopTicks : group->waves[0].loopTicks;
}

uint32_t swFindCarryPhase(const swWaveGroup* group, int64_t ticks, float* period)
{
    return swGetCarryPhase(group->k, getLoopTicks(group), ticks, period);
}

// ---- correlation ----

// Points that are looked up together, to spare the stack.
#define LOOK_BLOCK 8

// Of a tile from its own texels, exact for its waves, and periodic as they are.
static void correlateTile(const swPlaceBlock* block, const swTile* tile, int count, const swPosXZ* ways,
                          bool withSlopes, float* rho, float (*slopes)[2])
{
    swPointSums sums[LOOK_BLOCK];
    swTile likeness = *tile;
    likeness.texels = tile->likeness;
    likeness.shiftX = likeness.shiftZ = 0.0;
    for (int first = 0; first < count; first += LOOK_BLOCK)
    {
        int some = count - first < LOOK_BLOCK ? count - first : LOOK_BLOCK;
        memset(sums, 0, (size_t)some * sizeof sums[0]);
        swAddTile(block->kernels, &likeness, 0, some, ways + first, NULL, withSlopes, sums);
        for (int i = 0; i < some; ++i)
        {
            rho[first + i] = sums[i].value[1] + sums[i].value[5];
            slopes[first + i][0] = sums[i].alongX[1] + sums[i].alongX[5];
            slopes[first + i][1] = sums[i].alongZ[1] + sums[i].alongZ[5];
        }
    }
}

// The mean of cos(k . way), by energy.
static void correlateFreeWaves(const swWaveGroup* group, int count, const swPosXZ* ways, float* rho, float (*slopes)[2])
{
    for (int i = 0; i < count; ++i)
    {
        float energy = 0.0f, sum = 0.0f, alongX = 0.0f, alongZ = 0.0f;
        for (int w = 0; w < group->waveCount; ++w)
        {
            const swFreeWave* wave = &group->waves[w];
            float sine, cosine, square = wave->amplitude * wave->amplitude;
            swSinCosTurns(swGetFractionOfTurn(wave->turnsX * ways[i].x + wave->turnsZ * ways[i].z), &sine, &cosine);
            energy += square;
            sum += square * cosine;
            alongX -= square * sine * (float)(6.283185307179586 * wave->turnsX);
            alongZ -= square * sine * (float)(6.283185307179586 * wave->turnsZ);
        }
        float share = energy > 0.0f ? 1.0f / energy : 0.0f;
        rho[i] = energy > 0.0f ? sum * share : 1.0f;
        slopes[i][0] = alongX * share;
        slopes[i][1] = alongZ * share;
    }
}

// Where the flow is even, one way does for all points.
static bool areWaysEqual(int count, const swPosXZ* ways)
{
    bool areEqual = true;
    for (int i = 1; i < count && areEqual; ++i)
    {
        areEqual = ways[i].x == ways[0].x && ways[i].z == ways[0].z;
    }
    return areEqual;
}

static void correlate(const swPlaceBlock* block, const swWaveGroup* group, int count, const swPosXZ* ways,
                      bool withSlopes, float* rho, float (*slopes)[2])
{
    int own = count > 0 && areWaysEqual(count, ways) ? 1 : count;
    if (group->tile != NULL)
    {
        correlateTile(block, group->tile, own, ways, withSlopes, rho, slopes);
    }
    else
    {
        correlateFreeWaves(group, own, ways, rho, slopes);
    }
    for (int i = own; i < count; ++i)
    {
        rho[i] = rho[0];
        memcpy(slopes[i], slopes[0], sizeof slopes[0]);
    }
}

// ---- copies ----

// The flow in the axes in which the waves lie, and its gradients.
static void turnFlow(const swPlaceBlock* block, const swWarp* warps, int i, float velocity[2], float gradients[4])
{
    memcpy(velocity, block->flow[i], sizeof block->flow[i]);
    memcpy(gradients, block->flowGradients[i], sizeof block->flowGradients[i]);
    if (warps == NULL)
    {
        return;
    }
    const swWarp* warp = &warps[i];
    const float* u = block->flow[i];
    const float* g = block->flowGradients[i];
    float c = warp->cosine, s = warp->sine;
    velocity[0] = c * u[0] + s * u[1];
    velocity[1] = c * u[1] - s * u[0];
    gradients[0] = c * g[0] + s * g[2] + warp->turnX * velocity[1];
    gradients[1] = c * g[1] + s * g[3] + warp->turnZ * velocity[1];
    gradients[2] = c * g[2] - s * g[0] - warp->turnX * velocity[0];
    gradients[3] = c * g[3] - s * g[1] - warp->turnZ * velocity[0];
}

// The flow at each point of a block, in the axes of its waves: 0 where it carries nothing.
typedef struct Moving
{
    bool isCarried[SW_PLACE_BLOCK];
    int count, point[SW_PLACE_BLOCK]; // those that are carried
    float velocity[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4];
} Moving;

static void findMoving(const swPlaceBlock* block, const swWarp* warps, Moving* moving)
{
    moving->count = 0;
    memset(moving->velocity, 0, (size_t)block->count * sizeof moving->velocity[0]);
    memset(moving->gradients, 0, (size_t)block->count * sizeof moving->gradients[0]);
    for (int i = 0; i < block->count; ++i)
    {
        moving->isCarried[i] = block->isAsked[i] && block->isMoving[i];
        if (moving->isCarried[i])
        {
            moving->point[moving->count++] = i;
            turnFlow(block, warps, i, moving->velocity[i], moving->gradients[i]);
        }
    }
}

// How alike both copies are, and the gradient of that along the way between them; 1 where nothing is carried.
typedef struct Likeness
{
    float rho[SW_PLACE_BLOCK], alongX[SW_PLACE_BLOCK], alongZ[SW_PLACE_BLOCK];
} Likeness;

static void findLikeness(const swPlaceBlock* block, const swWaveGroup* group, const Moving* moving, float half,
                         bool withSlopes, Likeness* likeness)
{
    swPosXZ ways[SW_PLACE_BLOCK];
    float rho[SW_PLACE_BLOCK], slopes[SW_PLACE_BLOCK][2];
    for (int m = 0; m < moving->count; ++m)
    {
        const float* velocity = moving->velocity[moving->point[m]];
        ways[m] = (swPosXZ){(double)(half * velocity[0]), (double)(half * velocity[1])};
    }
    correlate(block, group, moving->count, ways, withSlopes, rho, slopes);
    for (int i = 0; i < SW_PLACE_BLOCK; ++i)
    {
        likeness->rho[i] = 1.0f;
        likeness->alongX[i] = likeness->alongZ[i] = 0.0f;
    }
    for (int m = 0; m < moving->count; ++m)
    {
        int i = moving->point[m];
        likeness->rho[i] = rho[m];
        likeness->alongX[i] = slopes[m][0];
        likeness->alongZ[i] = slopes[m][1];
    }
}

// What waves of both copies count by: their parts, over the root of the sum's variance. Where nothing is carried the
// first stays as it is, and the second counts nothing. Without a branch, for all points together.
static void weighCopies(const swPlaceBlock* block, const Moving* moving, const Likeness* likeness,
                        const float weights[2], float half, swLook* look)
{
    swCopy *first = &look->copies[0], *second = &look->copies[1];
    float factors[SW_PLACE_BLOCK], factorSlopes[SW_PLACE_BLOCK];
    for (int i = 0; i < SW_PLACE_BLOCK; ++i) // apart, so that compilers make vectors of it
    {
        swCarryFactor found = swGetCarryFactor(weights[0], likeness->rho[i]);
        factors[i] = found.value;
        factorSlopes[i] = found.slope * half; // by rho, times the way's
    }
    for (int i = 0; i < block->count; ++i)
    {
        float factor = factors[i], slope = factorSlopes[i];
        const float* g = moving->gradients[i];
        float factorX = slope * (likeness->alongX[i] * g[0] + likeness->alongZ[i] * g[2]);
        float factorZ = slope * (likeness->alongX[i] * g[1] + likeness->alongZ[i] * g[3]);
        float own = first->weight[i], alongX = first->alongX[i], alongZ = first->alongZ[i];
        float bothX = alongX * factor + own * factorX, bothZ = alongZ * factor + own * factorZ;
        bool isCarried = moving->isCarried[i];
        first->weight[i] = isCarried ? own * (weights[0] * factor) : own;
        first->alongX[i] = isCarried ? weights[0] * bothX : alongX;
        first->alongZ[i] = isCarried ? weights[0] * bothZ : alongZ;
        second->weight[i] = isCarried ? own * (weights[1] * factor) : 0.0f;
        second->alongX[i] = isCarried ? weights[1] * bothX : 0.0f;
        second->alongZ[i] = isCarried ? weights[1] * bothZ : 0.0f;
    }
}

// Both copies lie against the flow by the way of some seconds each.
static void moveCopies(const swPlaceBlock* block, const Moving* moving, const float seconds[2], swLook* look)
{
    swCopy *first = &look->copies[0], *second = &look->copies[1];
    if (!first->hasWay)
    {
        memset(first->way, 0, (size_t)block->count * sizeof first->way[0]);
    }
    for (int i = 0; i < block->count; ++i)
    {
        const float* v = moving->velocity[i];
        swPosXZ source = first->source[i];
        first->source[i].x = source.x - (double)(seconds[0] * v[0]);
        first->source[i].z = source.z - (double)(seconds[0] * v[1]);
        second->source[i].x = source.x - (double)(seconds[1] * v[0]);
        second->source[i].z = source.z - (double)(seconds[1] * v[1]);
        for (int g = 0; g < 4; ++g)
        {
            float way = first->way[i][g], gradient = moving->gradients[i][g];
            first->way[i][g] = way - seconds[0] * gradient;
            second->way[i][g] = way - seconds[1] * gradient;
        }
    }
    first->hasWay = second->hasWay = true;
}

void swCarryLook(const swPlaceBlock* block, const swWaveGroup* group, bool withSlopes, swLook* look)
{
    if (group->tile != NULL && group->tile->likeness == NULL)
    {
        return;
    }
    float period;
    uint32_t turns = swFindCarryPhase(group, block->ticks, &period);
    const float phases[2] = {(float)(turns >> 8) * 0x1p-24f, (float)((turns + 0x80000000u) >> 8) * 0x1p-24f};
    const float seconds[2] = {(phases[0] - 0.5f) * period, (phases[1] - 0.5f) * period};
    float weight = swGetCarryWeight(phases[0]);
    const float weights[2] = {weight, 1.0f - weight};
    float half = 0.5f * period;
    Moving moving;
    Likeness likeness;
    findMoving(block, look->copies[0].warps, &moving);
    findLikeness(block, group, &moving, half, withSlopes, &likeness);
    look->copyCount = 2;
    look->copies[1].warps = look->copies[0].warps;
    weighCopies(block, &moving, &likeness, weights, half, look);
    moveCopies(block, &moving, seconds, look);
}
