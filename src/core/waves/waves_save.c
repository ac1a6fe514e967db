// SPDX-License-Identifier: MIT
// Waves as bytes. Sets of waves come first, each once: by the def that they are made of, or, of a mix, by its waves,
// whose first sea may be gone. Then systems, whose parts name the sets by their numbers.

#include "core/waves/waves_save.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "seaway/waves.h"

#define MAX_SET_TILES (2 * SW_MAX_TILES) // of what is seen, and of what mixes become
#define LEAST_SET_BYTES 16
#define MAX_TABLE_FREQUENCIES 1024
#define MAX_TABLE_DIRECTIONS 720

// ---- defs ----

// Arrays of a def while it is read.
typedef struct Arrays
{
    size_t size;
    float* floats;
    swSpectrumTable table;
} Arrays;

static swResult makeArrays(const swWaves* waves, size_t count, Arrays* arrays)
{
    arrays->size = count * sizeof(float);
    arrays->floats = swAllocateZero(&waves->memory->host, arrays->size);
    return arrays->floats != NULL || count == 0 ? SW_SUCCESS
                                                : swFailMemory(waves->memory, "a spectrum's table or components");
}

static swResult streamTable(swStream* stream, const swWaves* waves, swSpectrumDef* def, Arrays* arrays)
{
    swSpectrumTable table = {0};
    if (!swIsReading(stream))
    {
        table = *def->table;
    }
    swStreamRange(stream, &table.frequencyCount, 2, MAX_TABLE_FREQUENCIES);
    swStreamRange(stream, &table.directionCount, 4, MAX_TABLE_DIRECTIONS);
    swStreamF32(stream, &table.firstDirection);
    size_t frequencies = (size_t)table.frequencyCount;
    size_t densities = frequencies * (size_t)table.directionCount;
    if (!swIsReading(stream))
    {
        swStreamFloats(stream, (float*)table.frequencies, frequencies);
        swStreamFloats(stream, (float*)table.bandwidths, frequencies);
        swStreamFloats(stream, (float*)table.density, densities);
        return SW_SUCCESS;
    }
    if (!swStreamHasLeft(stream, 2 * frequencies + densities, sizeof(float)))
    {
        return SW_ERROR_FORMAT;
    }
    swResult result = makeArrays(waves, 2 * frequencies + densities, arrays);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swStreamFloats(stream, arrays->floats, 2 * frequencies + densities);
    table.frequencies = arrays->floats;
    table.bandwidths = arrays->floats + frequencies;
    table.density = arrays->floats + 2 * frequencies;
    arrays->table = table;
    def->table = &arrays->table;
    return SW_SUCCESS;
}

static swResult streamComponents(swStream* stream, const swWaves* waves, swWaveSystemDef* def, Arrays* arrays)
{
    int count = def->componentCount;
    swStreamRange(stream, &count, 0, SW_MAX_FREE_WAVES);
    size_t floats = (size_t)count * (sizeof(swWaveComponent) / sizeof(float));
    def->componentCount = count;
    if (!swIsReading(stream))
    {
        swStreamFloats(stream, (float*)def->components, floats);
        return SW_SUCCESS;
    }
    if (!swStreamHasLeft(stream, floats, sizeof(float)))
    {
        return SW_ERROR_FORMAT;
    }
    swResult result = makeArrays(waves, floats, arrays);
    if (result == SW_SUCCESS)
    {
        swStreamFloats(stream, arrays->floats, floats);
        def->components = (const swWaveComponent*)arrays->floats;
    }
    return result;
}

// `arrays` are freed by the caller, whatever the result.
static swResult streamSystemDef(swStream* stream, const swWaves* waves, swWaveSystemDef* def, Arrays arrays[2])
{
    swStreamDef(stream, &swWaveSystemFields, def);
    swResult result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    if (result == SW_SUCCESS && def->spectrum.kind == SW_SPECTRUM_TABLE)
    {
        result = streamTable(stream, waves, &def->spectrum, &arrays[0]);
    }
    return result == SW_SUCCESS ? streamComponents(stream, waves, def, &arrays[1]) : result;
}

// ---- sets ----

static int findInList(const swSetList* list, const swWaveSet* set)
{
    for (int i = 0; i < list->count; ++i)
    {
        if (list->sets[i] == set)
        {
            return i;
        }
    }
    return -1;
}

static void listOnce(swSetList* list, swWaveSet* set)
{
    if (set->to != NULL)
    {
        listOnce(list, set->to);
    }
    if (findInList(list, set) < 0)
    {
        list->sets[list->count++] = set;
    }
}

void swListSets(const swWaves* waves, swSetList* list)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < waves->systems[slot].partCount; ++i)
        {
            listOnce(list, waves->systems[slot].parts[i].set);
        }
    }
}

static void streamDrift(swStream* stream, swDrift* drift)
{
    swStreamI64(stream, &drift->begin);
    swStreamI64(stream, &drift->length);
    swStreamF64(stream, &drift->x);
    swStreamF64(stream, &drift->z);
    swStreamF32(stream, &drift->fromX);
    swStreamF32(stream, &drift->fromZ);
    swStreamF32(stream, &drift->toX);
    swStreamF32(stream, &drift->toZ);
    const float speeds[4] = {drift->fromX, drift->fromZ, drift->toX, drift->toZ};
    bool isFine = drift->begin <= SW_LARGEST_TICKS && drift->begin >= -SW_LARGEST_TICKS && drift->length >= 0 &&
                  drift->length <= (int64_t)(SW_MAX_TRANSITION * SW_TICKS_PER_SECOND) && fabs(drift->x) < 1e14 &&
                  fabs(drift->z) < 1e14;
    for (int i = 0; i < 4; ++i)
    {
        isFine = isFine && fabsf(speeds[i]) <= SW_MAX_CURRENT;
    }
    stream->isBroken = stream->isBroken || !isFine;
}

static swResult streamPlainSet(swWaves* waves, swStream* stream, swWaveSet** set)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    Arrays arrays[2] = {{0}};
    if (!swIsReading(stream))
    {
        def = (*set)->def;
    }
    swDrift drift = {0};
    if (!swIsReading(stream))
    {
        drift = (*set)->drift;
    }
    swResult result = streamSystemDef(stream, waves, &def, arrays);
    if (result == SW_SUCCESS)
    {
        streamDrift(stream, &drift);
    }
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        bool isFine = !stream->isBroken && swCheckWaveSystemDef(&waves->memory->host, &def) == SW_SUCCESS;
        result = isFine ? swAcquireSet(waves, -1, &def, &drift, set) : SW_ERROR_FORMAT;
    }
    swFree(&waves->memory->host, arrays[0].floats, arrays[0].size);
    swFree(&waves->memory->host, arrays[1].floats, arrays[1].size);
    return result;
}

// Ahead of each set stand its identity, by which a world that has it already knows it, and the number of its bytes.
static size_t beginSet(swStream* stream, uint64_t* hash, uint32_t* size)
{
    swStreamU64(stream, hash);
    swStreamU32(stream, size);
    return stream->at;
}

static void endSet(swStream* stream, size_t begin)
{
    uint32_t size = (uint32_t)(stream->at - begin);
    if (stream->purpose == SW_STREAM_WRITE)
    {
        swStream head = {.purpose = SW_STREAM_WRITE, .data = stream->data, .size = begin, .at = begin - sizeof size};
        swStreamU32(&head, &size);
    }
}

static swResult streamSet(swWaves* waves, swStream* stream, swSetList* list, int index)
{
    swWaveSet* set = swIsReading(stream) ? NULL : list->sets[index];
    uint64_t hash = set != NULL ? set->identity : 0;
    uint32_t size = 0;
    size_t begin = beginSet(stream, &hash, &size);
    int to = set != NULL && set->to != NULL ? findInList(list, set->to) : -1;
    swStreamRange(stream, &to, -1, index - 1);
    swResult result = SW_SUCCESS;
    if (to < 0)
    {
        result = streamPlainSet(waves, stream, &set);
    }
    else if (list->sets[to]->to != NULL || list->sets[to]->def.method != SW_WAVES_FFT)
    {
        result = SW_ERROR_FORMAT; // a mix becomes a sea of tiles
    }
    else
    {
        result = swStreamMix(waves, stream, list->sets[to], &set);
    }
    endSet(stream, begin);
    if (result == SW_SUCCESS)
    {
        list->sets[index] = set;
        list->count = swIsReading(stream) ? index + 1 : list->count;
        list->tileCount += set->tileCount;
        result = list->tileCount <= MAX_SET_TILES ? SW_SUCCESS : SW_ERROR_FORMAT;
    }
    return result;
}

// Sets that are read belong to the list until they are released.
swResult swStreamSets(swWaves* waves, swStream* stream, swSetList* list)
{
    int count = list->count;
    swStreamRange(stream, &count, 0, SW_MAX_SETS);
    swStreamHasLeft(stream, (size_t)count, LEAST_SET_BYTES);
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        swResult result = streamSet(waves, stream, list, i);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

static bool isAmong(const swSetList* list, int count, const swWaveSet* set)
{
    for (int i = 0; i < count; ++i)
    {
        if (list->sets[i] == set)
        {
            return true;
        }
    }
    return false;
}

// The sets by their identities; what stands behind them is what the module has. SW_ERROR_UNSUPPORTED if it has one not.
swResult swFindSets(const swWaves* waves, swStream* stream, swSetList* found)
{
    swSetList own = {0};
    swListSets(waves, &own);
    swStreamRange(stream, &found->count, 0, SW_MAX_SETS);
    for (int i = 0; i < found->count && !stream->isBroken; ++i)
    {
        uint64_t identity = 0;
        uint32_t size = 0;
        beginSet(stream, &identity, &size);
        stream->isBroken = stream->isBroken || size > stream->size - stream->at;
        stream->at += stream->isBroken ? 0 : size;
        for (int k = 0; k < own.count; ++k)
        {
            bool isFree = !isAmong(found, i, own.sets[k]); // local systems may have the same waves, each its own set
            found->sets[i] = own.sets[k]->identity == identity && isFree ? own.sets[k] : found->sets[i];
        }
        if (found->sets[i] == NULL && !stream->isBroken)
        {
            return SW_ERROR_UNSUPPORTED;
        }
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

// ---- systems ----

static void streamRamp(swStream* stream, swRamp* ramp)
{
    swStreamF32(stream, &ramp->from);
    swStreamF32(stream, &ramp->to);
    swStreamI64(stream, &ramp->begin);
    swStreamI64(stream, &ramp->length);
    bool isTime = ramp->begin <= SW_LARGEST_TICKS && ramp->begin >= -SW_LARGEST_TICKS && ramp->length >= 0 &&
                  ramp->length <= (int64_t)(SW_MAX_TRANSITION * SW_TICKS_PER_SECOND);
    bool isFine = isTime && ramp->from >= 0.0f && ramp->from <= 10.0f && ramp->to >= 0.0f && ramp->to <= 10.0f;
    stream->isBroken = stream->isBroken || !isFine;
}

static void streamPart(swStream* stream, const swSetList* list, swWavePart* part)
{
    int index = swIsReading(stream) ? 0 : findInList(list, part->set);
    swStreamRange(stream, &index, 0, list->count > 0 ? list->count - 1 : 0);
    stream->isBroken = stream->isBroken || list->count == 0;
    streamRamp(stream, &part->fade);
    streamRamp(stream, &part->share);
    swStreamBool(stream, &part->isMixing);
    swStreamBool(stream, &part->isShared);
    if (swIsReading(stream) && !stream->isBroken && list->count > 0)
    {
        part->set = list->sets[index];
        bool isMix = part->set->mix != NULL;
        part->isMixing = part->isMixing && isMix;
        part->isShared = part->isShared && isMix;
    }
}

static void streamOwnWind(swStream* stream, swOwnWind* own)
{
    swStreamBool(stream, &own->isReplaced);
    swStreamBool(stream, &own->isKnown);
    swStreamF32(stream, &own->speed);
    swStreamF32(stream, &own->direction);
    bool isFine = !own->isReplaced || (own->speed > 0.0f && own->speed <= 100.0f && fabsf(own->direction) <= 1000.0f);
    stream->isBroken = stream->isBroken || !isFine;
}

void swStreamSystem(swStream* stream, const swSetList* list, swWaveSystem* system)
{
    int count = system->partCount;
    swStreamRange(stream, &count, 1, SW_MAX_WAVE_PARTS);
    streamRamp(stream, &system->weight);
    streamOwnWind(stream, &system->own);
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        streamPart(stream, list, &system->parts[i]);
        if (swIsReading(stream) && !stream->isBroken)
        {
            system->partCount = i + 1;
        }
    }
}

void swUseLayers(const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS])
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].partCount; ++i)
        {
            systems[slot].parts[i].set->useCount += 1;
        }
    }
}

void swUnuseLayers(swWaves* waves, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS])
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].partCount; ++i)
        {
            swReleaseSet(waves, systems[slot].parts[i].set);
        }
    }
}
