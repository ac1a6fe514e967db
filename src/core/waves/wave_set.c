// SPDX-License-Identifier: MIT
// Sets of waves: what a def is made into. A set is shared by all who ask for the same def, whatever their weights.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/waves/waves.h"

static size_t getTexelBytes(int resolution)
{
    size_t pitch = (size_t)resolution + 3;
    return pitch * pitch * 4 * sizeof(float);
}

static void freeSet(swWaves* waves, swWaveSet* set)
{
    const swHost* host = &waves->memory->host;
    for (int field = 0; field < SW_TEXELS_COUNT; ++field)
    {
        for (int band = 0; band < SW_SET_TILES; ++band)
        {
            swFree(host, set->texels[field][band], getTexelBytes(set->def.resolution));
        }
    }
    swFreeModes(host, set->bands);
    swFreeModeMix(host, set->mix);
    swFree(host, set->waves, (size_t)set->waveCount * sizeof(swFreeWave));
    swFree(host, set->copies, set->copiesSize);
    swFree(host, set, sizeof *set);
}

void swReleaseSet(swWaves* waves, swWaveSet* set)
{
    set->useCount -= 1;
    if (set->useCount > 0)
    {
        return;
    }
    if (set->mix != NULL)
    {
        swReleaseSet(waves, set->to);
    }
    set->nextRetired = waves->retired;
    waves->retired = set;
    waves->isTileListStale = true;
}

void swFreeRetiredSets(swWaves* waves)
{
    while (waves->retired != NULL)
    {
        swWaveSet* set = waves->retired;
        waves->retired = set->nextRetired;
        freeSet(waves, set);
    }
}

// ---- the same def ----

static bool areSameDrifts(const swDrift* a, const swDrift* b)
{
    return a->begin == b->begin && a->length == b->length && a->x == b->x && a->z == b->z && a->fromX == b->fromX &&
           a->fromZ == b->fromZ && a->toX == b->toX && a->toZ == b->toZ;
}

static swWaveSet* findSet(swWaves* waves, int own, const swWaveSystemDef* def, const swDrift* drift)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < waves->systems[slot].partCount && (!def->isLocal || slot == own); ++i)
        {
            swWaveSet* set = waves->systems[slot].parts[i].set;
            set = set->mix != NULL ? set->to : set;
            if (swAreSameWaves(&set->def, def) && areSameDrifts(&set->drift, drift))
            {
                return set;
            }
        }
    }
    return NULL;
}

// ---- making ----

// The def with its own table and components.
static bool copyDef(const swHost* host, const swWaveSystemDef* def, swWaveSet* set)
{
    set->def = *def;
    const swSpectrumTable* table = def->spectrum.kind == SW_SPECTRUM_TABLE ? def->spectrum.table : NULL;
    size_t frequencies = table != NULL ? (size_t)table->frequencyCount : 0;
    size_t densities = table != NULL ? frequencies * (size_t)table->directionCount : 0;
    size_t tableBytes = table != NULL ? (sizeof *table + 15) / 16 * 16 : 0;
    size_t components = def->method == SW_WAVES_GERSTNER ? (size_t)def->componentCount : 0;
    set->copiesSize = tableBytes + (2 * frequencies + densities) * sizeof(float) + components * sizeof(swWaveComponent);
    set->def.spectrum.table = NULL;
    set->def.components = NULL;
    set->def.componentCount = (int)components;
    if (set->copiesSize == 0)
    {
        return true;
    }
    char* memory = swAllocate(host, set->copiesSize);
    set->copies = memory;
    if (memory == NULL)
    {
        return false;
    }
    if (table != NULL)
    {
        float* floats = (float*)(void*)(memory + tableBytes);
        swSpectrumTable* copy = (swSpectrumTable*)(void*)memory;
        *copy = *table;
        copy->frequencies = memcpy(floats, table->frequencies, frequencies * sizeof(float));
        copy->bandwidths = memcpy(floats + frequencies, table->bandwidths, frequencies * sizeof(float));
        copy->density = memcpy(floats + 2 * frequencies, table->density, densities * sizeof(float));
        set->def.spectrum.table = copy;
    }
    if (components > 0)
    {
        set->def.components = memcpy(memory + set->copiesSize - components * sizeof(swWaveComponent), def->components,
                                     components * sizeof(swWaveComponent));
    }
    return true;
}

// One part of the scratch for each worker, large enough for tiles of that resolution.
static bool growScratch(swWaves* waves, int resolution)
{
    size_t needed = (swGetTileScratchSize(resolution) + 63) & ~(size_t)63;
    if (needed <= waves->scratchSize || !swHasAnyTexels(waves))
    {
        return true;
    }
    size_t workers = (size_t)waves->memory->host.workerCount;
    void* scratch = swAllocate(&waves->memory->host, needed * workers);
    if (scratch == NULL)
    {
        return false;
    }
    swFree(&waves->memory->host, waves->scratch, waves->scratchSize * workers);
    waves->scratch = scratch;
    waves->scratchSize = needed;
    return true;
}

bool swAllocateTexels(swWaves* waves, swWaveSet* set)
{
    size_t size = getTexelBytes(set->def.resolution);
    if (!growScratch(waves, set->def.resolution))
    {
        return false;
    }
    for (int i = 0; i < SW_TEXELS_COUNT * SW_SET_TILES; ++i)
    {
        int field = i % SW_TEXELS_COUNT, band = i / SW_TEXELS_COUNT;
        float** texels = &set->texels[field][band];
        if (set->bands[band].modeCount > 0 && waves->hasTexels[field] && *texels == NULL)
        {
            *texels = swAllocateZero(&waves->memory->host, size);
            if (*texels == NULL)
            {
                return false;
            }
        }
    }
    return true;
}

static bool allocateTexels(swWaves* waves, swWaveSet* set)
{
    for (int band = 0; band < SW_SET_TILES; ++band)
    {
        set->tileCount += set->bands[band].modeCount > 0 ? 1 : 0;
    }
    return swAllocateTexels(waves, set);
}

static swResult failSet(swWaves* waves, swWaveSet* set, swResult result)
{
    if (set != NULL)
    {
        freeSet(waves, set);
    }
    if (result == SW_ERROR_NO_MEMORY)
    {
        return swFailMemory(waves->memory, "the waves of a system");
    }
    return result;
}

static swResult makeWaves(swWaves* waves, swWaveSet* set)
{
    float gravity = waves->gravity;
    float tension = waves->surfaceTension;
    if (set->def.method == SW_WAVES_GERSTNER)
    {
        return swBuildFreeWaves(&waves->memory->host, &set->def, gravity, tension, &set->waves, &set->waveCount,
                                set->bands);
    }
    swFillSplineResponse(set->def.resolution, set->response);
    swResult result = swBuildModes(&waves->memory->host, &set->def, gravity, tension, set->bands);
    if (result == SW_SUCCESS && !allocateTexels(waves, set))
    {
        result = SW_ERROR_NO_MEMORY;
    }
    return result;
}

static void numberSet(swWaves* waves, swWaveSet* set)
{
    waves->version += 1;
    set->version = waves->version;
    set->hash = swHashSet(set);
    set->identity = swIdentifySet(set);
    set->useCount = 1;
}

void swTurnSet(swWaves* waves, swWaveSet* set, const swWaveSystemDef* def, const swDrift* drift)
{
    set->def.currentX = def->currentX;
    set->def.currentZ = def->currentZ;
    set->drift = *drift;
    set->hash = swHashSet(set);
    set->identity = swIdentifySet(set);
    waves->isChanged = true;
}

swResult swAcquireSet(swWaves* waves, int slot, const swWaveSystemDef* def, const swDrift* drift, swWaveSet** out)
{
    swWaveSet* set = findSet(waves, slot, def, drift);
    if (set != NULL)
    {
        set->useCount += 1;
        *out = set;
        return SW_SUCCESS;
    }
    set = swAllocateZero(&waves->memory->host, sizeof *set);
    if (set == NULL || !copyDef(&waves->memory->host, def, set))
    {
        return failSet(waves, set, SW_ERROR_NO_MEMORY);
    }
    set->drift = *drift;
    swResult result = makeWaves(waves, set);
    if (result != SW_SUCCESS)
    {
        return failSet(waves, set, result);
    }
    numberSet(waves, set);
    *out = set;
    return SW_SUCCESS;
}

// Of a set that is itself a mix, at `share`, the amplitudes of now are taken. Uses `to` until it is released.
swResult swMixSets(swWaves* waves, swWaveSet* from, float share, swWaveSet* to, swWaveSet** out)
{
    const swWaveSystemDef* a = &from->def;
    const swWaveSystemDef* b = &to->def;
    if (a->method != SW_WAVES_FFT || b->method != SW_WAVES_FFT || a->resolution != b->resolution ||
        a->tileWaves != b->tileWaves || a->seed != b->seed)
    {
        return SW_ERROR_UNSUPPORTED;
    }
    swWaveSet* set = swAllocateZero(&waves->memory->host, sizeof *set);
    if (set == NULL)
    {
        return failSet(waves, set, SW_ERROR_NO_MEMORY);
    }
    set->def = to->def;
    set->drift = to->drift;
    set->attenuationBefore = swGetSetAttenuation(from, share);
    memcpy(set->response, to->response, sizeof set->response);
    swResult result = swMakeModeMix(&waves->memory->host, from->bands, to->bands, set->response, set->bands, &set->mix);
    if (result == SW_SUCCESS && !allocateTexels(waves, set))
    {
        result = SW_ERROR_NO_MEMORY;
    }
    if (result != SW_SUCCESS)
    {
        return failSet(waves, set, result);
    }
    set->to = to;
    to->useCount += 1;
    numberSet(waves, set);
    *out = set;
    return SW_SUCCESS;
}

swAttenuation swGetSetAttenuation(const swWaveSet* set, float share)
{
    float shallows = set->def.shallowsDepth;
    swAttenuation own = {set->def.attenuation, shallows > 0.0f ? 1.0f / shallows : 0.0f};
    swAttenuation before = set->attenuationBefore;
    if (set->mix == NULL)
    {
        return own;
    }
    return (swAttenuation){before.strength + (own.strength - before.strength) * share,
                           before.perFreeDepth + (own.perFreeDepth - before.perFreeDepth) * share};
}

void swShareMix(swWaveSet* set, float share)
{
    swApplyModeMix(set->mix, share, set->bands);
}

static void streamAttenuation(swStream* stream, swAttenuation* attenuation)
{
    swStreamF32(stream, &attenuation->strength);
    swStreamF32(stream, &attenuation->perFreeDepth);
    stream->isBroken = stream->isBroken || !(attenuation->strength >= 0.0f && attenuation->strength <= 1.0f) ||
                       !(attenuation->perFreeDepth >= 0.0f && attenuation->perFreeDepth <= 1e9f);
}

// `set` is read, as a new one, or written.
swResult swStreamMix(swWaves* waves, swStream* stream, swWaveSet* to, swWaveSet** setPointer)
{
    const swHost* host = &waves->memory->host;
    const swWaveSystemDef* def = &to->def;
    swWaveSet* set = *setPointer;
    if (!swIsReading(stream))
    {
        streamAttenuation(stream, &set->attenuationBefore);
        return swStreamModeMix(stream, host, def->tileWaves, def->resolution, set->bands, &set->mix);
    }
    set = swAllocateZero(host, sizeof *set);
    if (set == NULL)
    {
        return failSet(waves, set, SW_ERROR_NO_MEMORY);
    }
    set->def = *def;
    set->drift = to->drift;
    memcpy(set->response, to->response, sizeof set->response);
    streamAttenuation(stream, &set->attenuationBefore);
    swResult result = swStreamModeMix(stream, host, def->tileWaves, def->resolution, set->bands, &set->mix);
    if (result == SW_SUCCESS && !allocateTexels(waves, set))
    {
        result = SW_ERROR_NO_MEMORY;
    }
    if (result != SW_SUCCESS)
    {
        return failSet(waves, set, result);
    }
    set->to = to;
    to->useCount += 1;
    numberSet(waves, set);
    *setPointer = set;
    return SW_SUCCESS;
}
