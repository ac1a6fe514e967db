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

// Of a tile from its own texels, exact for its waves, and periodic as they are.
static void correlateTile(const swPlaceBlock* block, const swTile* tile, int count, const swPosXZ* ways,
                          bool withSlopes, float* rho, float (*slopes)[2])
{
    swPointSums sums[SW_PLACE_BLOCK];
    memset(sums, 0, (size_t)count * sizeof sums[0]);
    swTile likeness = *tile;
    likeness.texels = tile->likeness;
    likeness.shiftX = likeness.shiftZ = 0.0;
    swAddTile(block->kernels, &likeness, 0, count, ways, NULL, withSlopes, sums);
    for (int i = 0; i < count; ++i)
    {
        rho[i] = sums[i].value[1] + sums[i].value[5];
        slopes[i][0] = sums[i].alongX[1] + sums[i].alongX[5];
        slopes[i][1] = sums[i].alongZ[1] + sums[i].alongZ[5];
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

// Moves a copy of point i against the flow by the way of some seconds.
static void moveCopy(float seconds, const float velocity[2], const float gradients[4], int i, swCopy* copy)
{
    copy->source[i].x -= (double)(seconds * velocity[0]);
    copy->source[i].z -= (double)(seconds * velocity[1]);
    for (int g = 0; g < 4; ++g)
    {
        copy->way[i][g] -= seconds * gradients[g];
    }
}

// Points of a block where the water moves, with the flow in the axes of their waves.
typedef struct Moving
{
    int count;
    int point[SW_PLACE_BLOCK];
    float velocity[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4];
    float rho[SW_PLACE_BLOCK], slopes[SW_PLACE_BLOCK][2];
} Moving;

static void findMoving(const swPlaceBlock* block, const swWarp* warps, Moving* moving)
{
    moving->count = 0;
    for (int i = 0; i < block->count; ++i)
    {
        if (block->isAsked[i] && !swIsStill(block, i))
        {
            moving->point[moving->count] = i;
            turnFlow(block, warps, i, moving->velocity[moving->count], moving->gradients[moving->count]);
            moving->count += 1;
        }
    }
}

// What a copy's waves count by at a moving point: its part of both, over the root of the sum's variance.
static void weighCopies(const Moving* moving, int m, const float weights[2], float half, swLook* look)
{
    swCarryFactor found = swGetCarryFactor(weights[0], moving->rho[m]);
    float factor = found.value, slope = found.slope * half; // by rho, times the way's
    const float* g = moving->gradients[m];
    const float* along = moving->slopes[m];
    float factorX = slope * (along[0] * g[0] + along[1] * g[2]);
    float factorZ = slope * (along[0] * g[1] + along[1] * g[3]);
    int i = moving->point[m];
    for (int c = 0; c < 2; ++c)
    {
        swCopy* copy = &look->copies[c];
        copy->alongX[i] = weights[c] * (copy->alongX[i] * factor + copy->weight[i] * factorX);
        copy->alongZ[i] = weights[c] * (copy->alongZ[i] * factor + copy->weight[i] * factorZ);
        copy->weight[i] *= weights[c] * factor;
    }
}

// The second copy as the first; where the water stands still, it counts nothing.
static void addSecondCopy(const swPlaceBlock* block, const Moving* moving, swLook* look)
{
    swCopy* first = &look->copies[0];
    swCopy* second = &look->copies[1];
    if (!first->hasWay)
    {
        memset(first->way, 0, (size_t)block->count * sizeof first->way[0]);
        first->hasWay = true;
    }
    look->copyCount = 2;
    second->warps = first->warps;
    second->hasWay = true;
    // Points that stand still have a place and a way, too: what counts nothing is looked up all the same.
    memcpy(second->source, first->source, (size_t)block->count * sizeof first->source[0]);
    memcpy(second->way, first->way, (size_t)block->count * sizeof first->way[0]);
    memset(second->weight, 0, sizeof second->weight);
    memset(second->alongX, 0, sizeof second->alongX);
    memset(second->alongZ, 0, sizeof second->alongZ);
    for (int m = 0; m < moving->count; ++m)
    {
        int i = moving->point[m];
        second->weight[i] = first->weight[i];
        second->alongX[i] = first->alongX[i];
        second->alongZ[i] = first->alongZ[i];
    }
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
    float weight = swGetCarryWeight(phases[0]);
    const float weights[2] = {weight, 1.0f - weight};
    Moving moving;
    swPosXZ ways[SW_PLACE_BLOCK];
    float half = 0.5f * period;
    findMoving(block, look->copies[0].warps, &moving);
    for (int m = 0; m < moving.count; ++m)
    {
        ways[m] = (swPosXZ){(double)(half * moving.velocity[m][0]), (double)(half * moving.velocity[m][1])};
    }
    correlate(block, group, moving.count, ways, withSlopes, moving.rho, moving.slopes);
    addSecondCopy(block, &moving, look);
    for (int m = 0; m < moving.count; ++m)
    {
        weighCopies(&moving, m, weights, half, look);
        for (int c = 0; c < 2; ++c)
        {
            moveCopy((phases[c] - 0.5f) * period, moving.velocity[m], moving.gradients[m], moving.point[m],
                     &look->copies[c]);
        }
    }
}
