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
static void correlateTile(const swPlaceBlock* block, const swTile* tile, const swPosXZ* ways, float* rho,
                          float (*slopes)[2])
{
    swPointSums sums[SW_PLACE_BLOCK];
    memset(sums, 0, sizeof sums);
    swTile likeness = *tile;
    likeness.texels = tile->likeness;
    likeness.shiftX = likeness.shiftZ = 0.0;
    swAddTile(block->kernels, &likeness, 0, block->count, ways, true, sums);
    for (int i = 0; i < block->count; ++i)
    {
        rho[i] = sums[i].value[1] + sums[i].value[5];
        slopes[i][0] = sums[i].alongX[1] + sums[i].alongX[5];
        slopes[i][1] = sums[i].alongZ[1] + sums[i].alongZ[5];
    }
}

// The mean of cos(k . way), by energy.
static void correlateFreeWaves(const swPlaceBlock* block, const swWaveGroup* group, const swPosXZ* ways, float* rho,
                               float (*slopes)[2])
{
    for (int i = 0; i < block->count; ++i)
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

// Moves a copy against the flow by the way of some seconds.
static void moveCopy(const swPlaceBlock* block, float seconds, float (*velocities)[2], float (*gradients)[4],
                     swCopy* copy)
{
    for (int i = 0; i < block->count; ++i)
    {
        copy->source[i].x -= (double)(seconds * velocities[i][0]);
        copy->source[i].z -= (double)(seconds * velocities[i][1]);
        for (int g = 0; g < 4; ++g)
        {
            copy->way[i][g] -= seconds * gradients[i][g];
        }
    }
}

void swCarryLook(const swPlaceBlock* block, const swWaveGroup* group, swLook* carried)
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
    float velocities[SW_PLACE_BLOCK][2], gradients[SW_PLACE_BLOCK][4], rho[SW_PLACE_BLOCK], slopes[SW_PLACE_BLOCK][2];
    swPosXZ ways[SW_PLACE_BLOCK];
    float half = 0.5f * period;
    for (int i = 0; i < block->count; ++i)
    {
        turnFlow(block, carried->copies[0].warps, i, velocities[i], gradients[i]);
        ways[i] = (swPosXZ){(double)(half * velocities[i][0]), (double)(half * velocities[i][1])};
    }
    if (group->tile != NULL)
    {
        correlateTile(block, group->tile, ways, rho, slopes);
    }
    else
    {
        correlateFreeWaves(block, group, ways, rho, slopes);
    }
    carried->copyCount = 2;
    carried->copies[1] = carried->copies[0];
    for (int i = 0; i < block->count; ++i)
    {
        swCarryFactor found = swGetCarryFactor(weight, rho[i]);
        float factor = found.value, slope = found.slope * half; // by rho, times the way's
        const float* g = gradients[i];
        float factorX = slope * (slopes[i][0] * g[0] + slopes[i][1] * g[2]);
        float factorZ = slope * (slopes[i][0] * g[1] + slopes[i][1] * g[3]);
        for (int c = 0; c < 2; ++c)
        {
            swCopy* copy = &carried->copies[c];
            copy->alongX[i] = weights[c] * (copy->alongX[i] * factor + copy->weight[i] * factorX);
            copy->alongZ[i] = weights[c] * (copy->alongZ[i] * factor + copy->weight[i] * factorZ);
            copy->weight[i] *= weights[c] * factor;
        }
    }
    for (int c = 0; c < 2; ++c)
    {
        moveCopy(block, (phases[c] - 0.5f) * period, velocities, gradients, &carried->copies[c]);
    }
}
