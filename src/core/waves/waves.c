// SPDX-License-Identifier: MIT
#include "core/waves/waves.h"

void swBeginWaves(swWaves* waves, swMemory* memory, const swWaveKernels* kernels, const swWorldDef* def)
{
    waves->memory = memory;
    waves->kernels = kernels;
    waves->gravity = def->gravity;
    waves->surfaceTension = def->surfaceTension;
    waves->hasTexels[SW_TEXELS_DISPLACEMENT] = def->enableQueries;
    waves->hasTexels[SW_TEXELS_VELOCITY] = def->enableQueries && def->enableVelocity;
    waves->hasTexels[SW_TEXELS_ACCELERATION] = def->enableQueries && def->enableAcceleration;
}

void swEndWaves(swWaves* waves)
{
    const swHost* host = &waves->memory->host;
    swFreeAllSystems(waves);
    swFree(host, waves->scratch, waves->scratchSize * (size_t)host->workerCount);
}

void swAdvanceWaves(swWaves* waves, swFrame* frame)
{
    waves->ticks = frame->ticks;
    swAdvanceSystems(waves);
    swListTiles(waves, frame);
}

static float* getTexels(const swWaves* waves, int tile, int field)
{
    const swWaveSource* source = &waves->tileSources[tile];
    return source->set->texels[field][source->index];
}

// Item i is field i % SW_TEXELS_COUNT of a pair: displacement, velocity, acceleration.
static void transformPairs(void* context, int begin, int end, int worker)
{
    swWaves* waves = context;
    char* scratch = (char*)waves->scratch + (size_t)worker * waves->scratchSize;
    for (int i = begin; i < end; ++i)
    {
        const swTilePair* pair = &waves->pairs[i / SW_TEXELS_COUNT];
        int field = i % SW_TEXELS_COUNT;
        float* first = getTexels(waves, pair->first, field);
        if (first == NULL)
        {
            continue;
        }
        bool isPair = pair->second >= 0;
        swTransformTiles(waves->kernels, &waves->tiles[pair->first], first, isPair ? &waves->tiles[pair->second] : NULL,
                         isPair ? getTexels(waves, pair->second, field) : NULL, waves->ticks, field, scratch);
    }
}

void swTransformWaves(swWaves* waves)
{
    if (waves->hasTexels[SW_TEXELS_DISPLACEMENT])
    {
        swParallelFor(&waves->memory->host, transformPairs, waves, waves->pairCount * SW_TEXELS_COUNT, 1);
    }
}
