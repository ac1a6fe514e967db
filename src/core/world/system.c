// SPDX-License-Identifier: MIT
// Wave systems and their tiles. The list of tiles is made anew, in the order of the systems' slots, by the step that
// follows a change. Tiles of one system are paired in order of their bands: a tile's bits depend on its partner, so the
// pairing depends on nothing but the spectrum.

#include "core/world/world.h"

#include "core/base/host.h"

static size_t getTexelBytes(int resolution)
{
    size_t pitch = (size_t)resolution + 3;
    return pitch * pitch * 4 * sizeof(float);
}

static void freeBandSet(swWorld* world, swBandSet* set)
{
    if (set == NULL)
    {
        return;
    }
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        swFree(&world->countedHost, set->texels[band], getTexelBytes(set->resolution));
    }
    swFreeModes(&world->countedHost, set->bands);
    swFree(&world->countedHost, set, sizeof *set);
}

static swResult allocateTexels(swWorld* world, swBandSet* set)
{
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        if (set->bands[band].modes == NULL || set->bands[band].modeCount == 0)
        {
            continue;
        }
        set->tileCount += 1;
        if (!world->def.enableQueries)
        {
            continue;
        }
        set->texels[band] = swAllocateZero(&world->countedHost, getTexelBytes(set->resolution));
        if (set->texels[band] == NULL)
        {
            return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for a tile of %d x %d samples", set->resolution,
                          set->resolution);
        }
    }
    return SW_SUCCESS;
}

// `replaced` is the set that the new one stands in for, NULL for a new system.
static swResult makeBandSet(swWorld* world, const swWaveSystemDef* def, const swBandSet* replaced, swBandSet** setOut)
{
    swBandSet* set = swAllocateZero(&world->countedHost, sizeof *set);
    if (set == NULL)
    {
        return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for a wave system");
    }
    set->resolution = def->resolution;
    swResult result = swBuildModes(&world->countedHost, def, world->def.gravity, world->def.surfaceTension, set->bands);
    if (result == SW_ERROR_NO_MEMORY)
    {
        swFail(&world->host, result, "no memory for the waves of a system with tiles of %d x %d samples",
               def->resolution, def->resolution);
    }
    if (result == SW_SUCCESS)
    {
        result = allocateTexels(world, set);
    }
    if (result == SW_SUCCESS)
    {
        int total = set->tileCount - (replaced != NULL ? replaced->tileCount : 0);
        for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
        {
            total += world->systems[slot].set != NULL ? world->systems[slot].set->tileCount : 0;
        }
        if (total > SW_MAX_TILES)
        {
            result = swFail(&world->host, SW_ERROR_LIMIT, "the world would have %d tiles; %d are possible", total,
                            SW_MAX_TILES);
        }
    }
    if (result != SW_SUCCESS)
    {
        freeBandSet(world, set);
        return result;
    }
    world->version += 1;
    set->version = world->version;
    *setOut = set;
    return SW_SUCCESS;
}

// One part of the scratch for each worker, large enough for tiles of that resolution.
static swResult growScratch(swWorld* world, int resolution)
{
    size_t needed = (swGetTileScratchSize(resolution) + 63) & ~(size_t)63;
    if (needed <= world->scratchSize || !world->def.enableQueries)
    {
        return SW_SUCCESS;
    }
    size_t workers = (size_t)world->host.workerCount;
    void* scratch = swAllocate(&world->countedHost, needed * workers);
    if (scratch == NULL)
    {
        return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory to transform tiles of %d x %d samples", resolution,
                      resolution);
    }
    swFree(&world->countedHost, world->scratch, world->scratchSize * workers);
    world->scratch = scratch;
    world->scratchSize = needed;
    return SW_SUCCESS;
}

static void retireSet(swWorld* world, swBandSet* set)
{
    set->nextRetired = world->retired;
    world->retired = set;
    world->isTileListStale = true;
}

swResult swAddSystem(swWorld* world, const swWaveSystemDef* def, swId* id)
{
    if (world->systemIds.count == SW_MAX_WAVE_SYSTEMS)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "the world has %d wave systems, which is the most",
                      SW_MAX_WAVE_SYSTEMS);
    }
    swResult result = growScratch(world, def->resolution);
    swBandSet* set = NULL;
    if (result == SW_SUCCESS)
    {
        result = makeBandSet(world, def, NULL, &set);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    *id = swAllocId(&world->systemIds);
    swWaveSystem* system = &world->systems[id->index1 - 1];
    *system = (swWaveSystem){.def = *def, .set = set};
    system->def.spectrum.table = NULL;
    world->isTileListStale = true;
    return SW_SUCCESS;
}

void swRemoveSystem(swWorld* world, swId id)
{
    swWaveSystem* system = &world->systems[id.index1 - 1];
    retireSet(world, system->set);
    *system = (swWaveSystem){0};
    swFreeId(&world->systemIds, id);
}

swResult swReplaceSpectrum(swWorld* world, swWaveSystem* system, const swSpectrumDef* spectrum)
{
    swWaveSystemDef def = system->def;
    def.spectrum = *spectrum;
    swBandSet* set = NULL;
    swResult result = makeBandSet(world, &def, system->set, &set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    retireSet(world, system->set);
    system->set = set;
    system->def.spectrum = *spectrum;
    system->def.spectrum.table = NULL;
    return SW_SUCCESS;
}

void swFreeRetiredSets(swWorld* world)
{
    while (world->retired != NULL)
    {
        swBandSet* set = world->retired;
        world->retired = set->nextRetired;
        freeBandSet(world, set);
    }
}

void swFreeAllSystems(swWorld* world)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        freeBandSet(world, world->systems[slot].set);
        world->systems[slot].set = NULL;
    }
    swFreeRetiredSets(world);
}

static void addTile(swWorld* world, int slot, int bandIndex)
{
    const swBandSet* set = world->systems[slot].set;
    const swBandModes* band = &set->bands[bandIndex];
    int index = world->frame.tileCount;
    world->tileTexels[index] = set->texels[bandIndex];
    world->tiles[index] = (swTile){
        .system = slot,
        .band = band->band,
        .resolution = set->resolution,
        .maxBin = band->maxBin,
        .side = band->side,
        .loopTicks = band->loopTicks,
        .minWavelength = band->minWavelength,
        .maxWavelength = band->maxWavelength,
        .modeCount = band->modeCount,
        .modes = band->modes,
        .spectrumVersion = set->version,
        .texels = set->texels[bandIndex],
    };
    world->frame.tileCount = index + 1;
}

static void listSystem(swWorld* world, int slot)
{
    int first = world->frame.tileCount;
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        if (world->systems[slot].set->bands[band].modeCount > 0)
        {
            addTile(world, slot, band);
        }
    }
    for (int tile = first; tile < world->frame.tileCount; tile += 2)
    {
        int second = tile + 1 < world->frame.tileCount ? tile + 1 : -1;
        world->pairs[world->pairCount++] = (swTilePair){tile, second};
    }
}

// Weights may change with every step, without a new list.
static void weighTiles(swWorld* world)
{
    for (int i = 0; i < world->frame.tileCount; ++i)
    {
        swTile* tile = &world->tiles[i];
        const swWaveSystem* system = &world->systems[tile->system];
        const swBandModes* band = &system->set->bands[tile->band];
        float weight = system->def.weight;
        tile->weight = weight;
        tile->variance = band->variance * weight * weight;
        tile->slopeVarianceX = band->slopeVarianceX * weight * weight;
        tile->slopeVarianceZ = band->slopeVarianceZ * weight * weight;
    }
}

void swListTiles(swWorld* world)
{
    if (world->isTileListStale)
    {
        swFreeRetiredSets(world);
        world->frame.tileCount = 0;
        world->pairCount = 0;
        for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
        {
            if (world->systems[slot].set != NULL)
            {
                listSystem(world, slot);
            }
        }
        world->version += 1;
        world->frame.tilesVersion = world->version;
        world->isTileListStale = false;
    }
    weighTiles(world);
}
