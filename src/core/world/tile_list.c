// SPDX-License-Identifier: MIT
// The frame's tiles and free waves. The list is made anew, in the order of the systems' slots, by the step that follows
// a change; weights are brought up to date in each step. Tiles of one set are paired in order of their bands: a tile's
// bits depend on its partner, so the pairing depends on nothing but the set. Sets without weight are not listed.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/world/world.h"

static void addTile(swWorld* world, swWaveSet* set, int bandIndex)
{
    int index = world->frame.tileCount;
    world->tileSources[index] = (swWaveSource){set, bandIndex};
    const swBandModes* band = &set->bands[bandIndex];
    world->tiles[index] = (swTile){
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
    world->frame.tileCount = index + 1;
}

static void listTilesOfSet(swWorld* world, swWaveSet* set)
{
    int first = world->frame.tileCount;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        int tile = i % SW_BAND_TILES * SW_MAX_BANDS + i / SW_BAND_TILES; // band by band
        if (set->bands[tile].modeCount > 0)
        {
            addTile(world, set, tile);
        }
    }
    for (int tile = first; tile < world->frame.tileCount; tile += 2)
    {
        int second = tile + 1 < world->frame.tileCount ? tile + 1 : -1;
        world->pairs[world->pairCount++] = (swTilePair){tile, second};
    }
}

// Merge: waves of a set are in order already.
static void listWavesOfSet(swWorld* world, swWaveSet* set)
{
    int count = world->frame.waveCount;
    int total = count + set->waveCount;
    int old = count - 1;
    int added = set->waveCount - 1;
    for (int at = total - 1; added >= 0; --at)
    {
        if (old >= 0 && world->waves[old].wavelength < set->waves[added].wavelength)
        {
            world->waves[at] = world->waves[old];
            world->waveSources[at] = world->waveSources[old];
            old -= 1;
        }
        else
        {
            world->waves[at] = set->waves[added];
            world->waveSources[at] = (swWaveSource){set, added};
            added -= 1;
        }
    }
    world->frame.waveCount = total;
}

static void listSet(swWorld* world, swWaveSet* set)
{
    if (set->isListed || set->weight == 0.0f)
    {
        return;
    }
    set->isListed = true;
    listTilesOfSet(world, set);
    listWavesOfSet(world, set);
}

// What `do` is done with: the set of every layer.
static void forEachSet(swWorld* world, void (*visit)(swWorld* world, swWaveSet* set))
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < world->systems[slot].layerCount; ++i)
        {
            visit(world, world->systems[slot].layers[i].set);
        }
    }
}

static void unlistSet(swWorld* world, swWaveSet* set)
{
    (void)world;
    set->isListed = false;
}

// A set that got or lost its weight changes the list.
static void noticeWeight(swWorld* world, swWaveSet* set)
{
    world->isTileListStale = world->isTileListStale || set->isListed != (set->weight != 0.0f);
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

static void addWindLevels(swWorld* world, swWaveSet* set)
{
    if (!set->isCounted)
    {
        set->isCounted = true;
        addLevels(set, set->weight, world->windLevels);
    }
}

static void uncountSet(swWorld* world, swWaveSet* set)
{
    (void)world;
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
static void findWind(swWorld* world)
{
    memset(world->windLevels, 0, sizeof world->windLevels);
    forEachSet(world, uncountSet);
    forEachSet(world, addWindLevels);
    double gravity = (double)world->def.gravity;
    float wind = swFindWind(world->windLevels, gravity);
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        wind = fmaxf(wind, findKnownWind(&world->systems[slot], gravity));
    }
    world->frame.wind = fminf(wind, SW_STRONGEST_WIND);
}

void swListTiles(swWorld* world)
{
    forEachSet(world, noticeWeight);
    if (world->isTileListStale)
    {
        swFreeRetiredSets(world);
        world->frame.tileCount = 0;
        world->frame.waveCount = 0;
        world->pairCount = 0;
        forEachSet(world, unlistSet);
        forEachSet(world, listSet);
        world->version += 1;
        world->frame.tilesVersion = world->version;
        world->isTileListStale = false;
    }
    for (int i = 0; i < world->frame.tileCount; ++i)
    {
        weighTile(&world->tiles[i], &world->tileSources[i]);
    }
    for (int i = 0; i < world->frame.waveCount; ++i)
    {
        weighWave(&world->waves[i], &world->waveSources[i]);
    }
    findWind(world);
}
