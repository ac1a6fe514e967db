// SPDX-License-Identifier: MIT
// The frame's tiles and free waves. The list is made anew, in the order of the systems' slots, by the step that follows
// a change; weights are brought up to date in each step. Tiles of one set are paired in order of their bands: a tile's
// bits depend on its partner, so the pairing depends on nothing but the set. Sets without weight are not listed.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/waves/waves.h"

static void addTile(swWaves* waves, swWaveSet* set, int bandIndex)
{
    int index = waves->tileCount;
    waves->tileSources[index] = (swWaveSource){set, bandIndex};
    const swBandModes* band = &set->bands[bandIndex];
    waves->tiles[index] = (swTile){
        .band = band->band,
        .resolution = set->def.resolution,
        .maxBin = band->maxBin,
        .side = band->side,
        .loopTicks = band->loopTicks,
        .minWavelength = band->minWavelength,
        .maxWavelength = band->maxWavelength,
        .depth = band->depth,
        .modeCount = band->modeCount,
        .modes = band->modes,
        .response = set->response,
        .texels = set->texels[SW_TEXELS_DISPLACEMENT][bandIndex],
        .velocity = set->texels[SW_TEXELS_VELOCITY][bandIndex],
        .acceleration = set->texels[SW_TEXELS_ACCELERATION][bandIndex],
    };
    waves->tileCount = index + 1;
}

static void listTilesOfSet(swWaves* waves, swWaveSet* set)
{
    int first = waves->tileCount;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        int tile = i % SW_BAND_TILES * SW_MAX_BANDS + i / SW_BAND_TILES; // band by band
        if (set->bands[tile].modeCount > 0)
        {
            addTile(waves, set, tile);
        }
    }
    for (int tile = first; tile < waves->tileCount; tile += 2)
    {
        int second = tile + 1 < waves->tileCount ? tile + 1 : -1;
        waves->pairs[waves->pairCount++] = (swTilePair){tile, second};
    }
}

// Merge: waves of a set are in order already.
static void listWavesOfSet(swWaves* waves, swWaveSet* set)
{
    int count = waves->freeWaveCount;
    int total = count + set->waveCount;
    int old = count - 1;
    int added = set->waveCount - 1;
    for (int at = total - 1; added >= 0; --at)
    {
        if (old >= 0 && waves->freeWaves[old].wavelength < set->waves[added].wavelength)
        {
            waves->freeWaves[at] = waves->freeWaves[old];
            waves->freeWaveSources[at] = waves->freeWaveSources[old];
            old -= 1;
        }
        else
        {
            waves->freeWaves[at] = set->waves[added];
            waves->freeWaveSources[at] = (swWaveSource){set, added};
            added -= 1;
        }
    }
    waves->freeWaveCount = total;
}

static void listSet(swWaves* waves, swWaveSet* set)
{
    if (set->isListed || set->weight == 0.0f)
    {
        return;
    }
    set->isListed = true;
    listTilesOfSet(waves, set);
    listWavesOfSet(waves, set);
}

// What `do` is done with: the set of every layer.
static void forEachSet(swWaves* waves, void (*visit)(swWaves* waves, swWaveSet* set))
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < waves->systems[slot].layerCount; ++i)
        {
            visit(waves, waves->systems[slot].layers[i].set);
        }
    }
}

static void unlistSet(swWaves* waves, swWaveSet* set)
{
    (void)waves;
    set->isListed = false;
}

// A set that got or lost its weight changes the list.
static void noticeWeight(swWaves* waves, swWaveSet* set)
{
    waves->isTileListStale = waves->isTileListStale || set->isListed != (set->weight != 0.0f);
}

static void weighTile(swTile* tile, const swWaveSource* source)
{
    const swWaveSet* set = source->set;
    const swBandModes* band = &set->bands[source->index];
    float square = set->weight * set->weight;
    tile->system = set->system;
    tile->weight = set->weight;
    tile->variance = band->variance * square;
    tile->slopeVarianceX = band->slopeVarianceX * square;
    tile->slopeVarianceZ = band->slopeVarianceZ * square;
    tile->strain = band->strain;
    swScaleStrain(&tile->strain, square);
    tile->spectrumVersion = set->version;
}

static void weighWave(swFreeWave* wave, const swWaveSource* source)
{
    wave->amplitude = source->set->waves[source->index].amplitude * source->set->weight;
    wave->system = source->set->system;
}

static void addLevels(const swWaveSet* set, float weight, float* levels)
{
    for (int step = 0; step < SW_MAX_BANDS * SW_WIND_STEPS; ++step)
    {
        levels[step] += weight * weight * set->bands[step / SW_WIND_STEPS].wind[step % SW_WIND_STEPS];
    }
}

static void uncountSet(swWaves* waves, swWaveSet* set)
{
    (void)waves;
    set->isCounted = false;
}

// The wind that a system knows. It fades with the system's weight and does not grow beyond weight 1. While a known wind
// gives way to one that the waves tell, or the other way round, what is left of it counts as a level of all waves.
static float findKnownWind(const swWaveSystem* system, double gravity)
{
    float known = 0.0f, all = 0.0f;
    float levels[SW_MAX_BANDS * SW_WIND_STEPS] = {0};
    for (int i = 0; i < system->layerCount; ++i)
    {
        const swWaveLayer* layer = &system->layers[i];
        known += layer->weight * layer->weight * layer->set->bands[0].knownWind;
        all += layer->weight * layer->weight;
        addLevels(layer->set, layer->weight, levels);
    }
    if (!(known > 0.0f))
    {
        return 0.0f;
    }
    known /= fmaxf(all, 1.0f);
    for (int step = 0; step < SW_MAX_BANDS * SW_WIND_STEPS; ++step)
    {
        levels[step] += known;
    }
    return fmaxf(known, swFindWind(levels, gravity));
}

// The levels of waves that tell their wind add up; of the winds that are known the strongest counts.
static float findWind(swWaves* waves)
{
    float levels[SW_MAX_BANDS * SW_WIND_STEPS] = {0};
    double gravity = (double)waves->gravity;
    forEachSet(waves, uncountSet);
    float wind = 0.0f;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        const swWaveSystem* system = &waves->systems[slot];
        for (int i = 0; i < system->layerCount; ++i)
        {
            swWaveSet* set = system->layers[i].set;
            addLevels(set, set->isCounted ? 0.0f : set->weight, levels);
            set->isCounted = true;
        }
        wind = fmaxf(wind, findKnownWind(system, gravity));
    }
    return fminf(fmaxf(wind, swFindWind(levels, gravity)), SW_STRONGEST_WIND);
}

void swListTiles(swWaves* waves, swFrame* frame)
{
    forEachSet(waves, noticeWeight);
    if (waves->isTileListStale)
    {
        swFreeRetiredSets(waves);
        waves->tileCount = 0;
        waves->freeWaveCount = 0;
        waves->pairCount = 0;
        forEachSet(waves, unlistSet);
        forEachSet(waves, listSet);
        waves->version += 1;
        frame->tilesVersion = waves->version;
        waves->isTileListStale = false;
    }
    for (int i = 0; i < waves->tileCount; ++i)
    {
        weighTile(&waves->tiles[i], &waves->tileSources[i]);
    }
    for (int i = 0; i < waves->freeWaveCount; ++i)
    {
        weighWave(&waves->freeWaves[i], &waves->freeWaveSources[i]);
    }
    frame->tileCount = waves->tileCount;
    frame->tiles = waves->tiles;
    frame->waveCount = waves->freeWaveCount;
    frame->waves = waves->freeWaves;
    frame->wind = findWind(waves);
}
