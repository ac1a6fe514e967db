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

void swAdvanceWaves(swWaves* waves, int64_t ticks)
{
    waves->ticks = ticks;
    swAdvanceSystems(waves);
}

static void shareMixes(swWaves* waves)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < waves->systems[slot].partCount; ++i)
        {
            const swWavePart* part = &waves->systems[slot].parts[i];
            if (part->set->mix != NULL)
            {
                swShareMix(part->set, swGetRamp(&part->share, waves->ticks));
                waves->version += 1;
                part->set->version = waves->version;
            }
        }
    }
}

// Whether other sets are listed than in the last step, or there was a change.
static bool noticeSets(swWaves* waves, const swShown* shown)
{
    bool isSame = !waves->isTileListStale;
    int count = 0;
    for (int i = 0; i < shown->count; ++i)
    {
        if (shown->sets[i].weight != 0.0f)
        {
            isSame = isSame && count < waves->listedCount && waves->listed[count] == shown->sets[i].set;
            waves->listed[count++] = shown->sets[i].set;
        }
    }
    isSame = isSame && count == waves->listedCount;
    waves->listedCount = count;
    waves->isTileListStale = false;
    return !isSame;
}

void swDeriveWaves(swWaves* waves, swFrame* frame)
{
    shareMixes(waves);
    swShown shown;
    swFindShown(waves, frame->time, waves->ticks, &shown);
    if (noticeSets(waves, &shown))
    {
        swFreeRetiredSets(waves);
        waves->version += 1;
        frame->tilesVersion = waves->version;
    }
    swTileList* list = &waves->list;
    swClearTileList(list);
    for (int i = 0; i < shown.count; ++i)
    {
        swListSet(list, &shown.sets[i], shown.sets[i].set->bands, waves->ticks);
    }
    frame->tileCount = list->tileCount;
    frame->tiles = list->tiles;
    frame->waveCount = list->waveCount;
    frame->waves = list->waves;
    frame->wind = swFindWindOfWaves(waves, &shown);
}

swResult swCarryWaves(swWaves* waves)
{
    if (waves->hasTexels[SW_TEXELS_LIKENESS])
    {
        return SW_SUCCESS;
    }
    waves->hasTexels[SW_TEXELS_LIKENESS] = true;
    bool isDone = true;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS && isDone; ++slot)
    {
        for (int i = 0; i < waves->systems[slot].partCount && isDone; ++i)
        {
            swWaveSet* set = waves->systems[slot].parts[i].set;
            isDone = swAllocateTexels(waves, set) && (set->to == NULL || swAllocateTexels(waves, set->to));
        }
    }
    waves->hasTexels[SW_TEXELS_LIKENESS] = isDone; // what was taken goes with its sets
    return isDone ? SW_SUCCESS : swFailMemory(waves->memory, "waves that a flow carries");
}

static void transform(void* context, int begin, int end, int worker)
{
    swWaves* waves = context;
    char* scratch = (char*)waves->scratch + (size_t)worker * waves->scratchSize;
    for (int i = begin; i < end; ++i)
    {
        swTransformListed(&waves->list, waves->kernels, waves->ticks, i, scratch);
    }
}

void swTransformWaves(swWaves* waves)
{
    if (!swHasAnyTexels(waves))
    {
        return;
    }
    swParallelFor(&waves->memory->host, transform, waves, swCountTransforms(&waves->list), 1);
    for (int i = 0; i < waves->listedCount && waves->hasTexels[SW_TEXELS_LIKENESS]; ++i)
    {
        waves->listed[i]->likenessVersion = waves->listed[i]->version;
    }
}
