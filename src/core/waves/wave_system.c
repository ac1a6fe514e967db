// SPDX-License-Identifier: MIT
// Wave systems, and how they change. A system's parts add up to its sea: one, unless a cross-fade is under way. What a
// part weighs and how far its mix has come are functions of time, so that steps of any length give the same sea.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/waves/waves.h"

// Two systems are told of if their variance is more than this part too high.
#define TWIN_PART 0.05

// ---- limits ----

// Tiles and free waves of a system that are not also those of an earlier system or part.
static void countWaves(const swWaveSystem* systems, int* tiles, int* waves)
{
    const swWaveSet* seen[SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_PARTS];
    int seenCount = 0;
    *tiles = 0;
    *waves = 0;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].partCount; ++i)
        {
            const swWaveSet* set = systems[slot].parts[i].set;
            bool isNew = true;
            for (int k = 0; k < seenCount; ++k)
            {
                isNew = isNew && seen[k] != set;
            }
            if (isNew)
            {
                seen[seenCount++] = set;
                *tiles += set->tileCount;
                *waves += set->waveCount;
            }
        }
    }
}

bool swIsWithinLimits(const swWaves* waves, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS])
{
    int tileCount, waveCount;
    countWaves(systems, &tileCount, &waveCount);
    if (tileCount > SW_MAX_TILES)
    {
        swFail(&waves->memory->host, SW_ERROR_LIMIT, "the waves would have %d tiles; %d are possible", tileCount,
               SW_MAX_TILES);
        return false;
    }
    if (waveCount > SW_MAX_FREE_WAVES)
    {
        swFail(&waves->memory->host, SW_ERROR_LIMIT, "the waves would have %d free waves; %d are possible", waveCount,
               SW_MAX_FREE_WAVES);
        return false;
    }
    return true;
}

// Put a system into a slot if the waves then keeps to its limits.
static swResult placeSystem(swWaves* waves, int slot, const swWaveSystem* system)
{
    swWaveSystem before = waves->systems[slot];
    waves->systems[slot] = *system;
    if (!swIsWithinLimits(waves, waves->systems))
    {
        waves->systems[slot] = before;
        return SW_ERROR_LIMIT;
    }
    waves->isTileListStale = true;
    waves->isChanged = true;
    return SW_SUCCESS;
}

// ---- create, remove ----

// Systems of one seed have one phase for each wave: where they overlap, heights add up instead of energies.
static void warnOfTwins(swWaves* waves, int slot, const swWaveSet* set)
{
    for (int other = 0; other < SW_MAX_WAVE_SYSTEMS; ++other)
    {
        const swWaveSystem* system = &waves->systems[other];
        if (other == slot || system->partCount == 0)
        {
            continue;
        }
        const swWaveSet* twin = system->parts[system->partCount - 1].set;
        twin = twin->to != NULL ? twin->to : twin;
        if (twin == set || twin->def.seed != set->def.seed)
        {
            continue;
        }
        double part = swFindSharedVariance(set->bands, twin->bands, set->response);
        if (part > TWIN_PART)
        {
            swLog(&waves->memory->host, SW_LOG_WARNING,
                  "two wave systems have the seed %u and waves in common, whose heights add up instead of their "
                  "energies: their variance is %.0f %% too high; give each system a seed of its own.",
                  (unsigned)set->def.seed, 100.0 * part);
        }
    }
}

// Of a system that has waves the path goes on from where it is; that of a new one began at time 0.
swDrift swPlanDrift(const swWaves* waves, int slot, const swWaveSystemDef* def, double seconds)
{
    const swWaveSystem* system = &waves->systems[slot];
    if (system->partCount == 0)
    {
        return (swDrift){.fromX = def->currentX, .fromZ = def->currentZ, .toX = def->currentX, .toZ = def->currentZ};
    }
    const swDrift* before = &system->parts[system->partCount - 1].set->drift;
    if (before->toX == def->currentX && before->toZ == def->currentZ)
    {
        return *before;
    }
    double passed = (double)swGetTicksBetween(before->begin, waves->ticks);
    bool isOver = passed >= (double)before->length;
    float part = isOver ? 1.0f : passed > 0.0 ? (float)(passed / (double)before->length) : 0.0f;
    swPosXZ path = swFindDrift(before, waves->ticks);
    return (swDrift){
        .begin = waves->ticks,
        .length = (int64_t)floor(seconds * SW_TICKS_PER_SECOND + 0.5),
        .x = path.x,
        .z = path.z,
        .fromX = before->fromX + (before->toX - before->fromX) * part,
        .fromZ = before->fromZ + (before->toZ - before->fromZ) * part,
        .toX = def->currentX,
        .toZ = def->currentZ,
    };
}

swResult swAddSystem(swWaves* waves, int slot, const swWaveSystemDef* def)
{
    swWaveSet* set = NULL;
    swDrift drift = swPlanDrift(waves, slot, def, 0.0);
    swResult result = swAcquireSet(waves, slot, def, &drift, &set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swWaveSystem system = {.partCount = 1, .weight = swMakeConstantRamp(def->weight)};
    system.parts[0] = (swWavePart){.set = set, .fade = swMakeConstantRamp(1.0f)};
    result = placeSystem(waves, slot, &system);
    if (result != SW_SUCCESS)
    {
        swReleaseSet(waves, set);
        return result;
    }
    warnOfTwins(waves, slot, set);
    return result;
}

static void releaseParts(swWaves* waves, swWaveSystem* system, int count)
{
    for (int i = 0; i < count; ++i)
    {
        swReleaseSet(waves, system->parts[i].set);
    }
    system->partCount -= count;
    memmove(system->parts, system->parts + count, (size_t)system->partCount * sizeof system->parts[0]);
}

void swRemoveSystem(swWaves* waves, int slot)
{
    swWaveSystem* system = &waves->systems[slot];
    releaseParts(waves, system, system->partCount);
    *system = (swWaveSystem){0};
    waves->isTileListStale = true;
    waves->isChanged = true;
}

void swFreeAllSystems(swWaves* waves)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        releaseParts(waves, &waves->systems[slot], waves->systems[slot].partCount);
    }
    swFreeRetiredSets(waves);
}

const swWaveSystemDef* swGetSystemDef(const swWaveSystem* system)
{
    const swWaveSet* set = system->parts[system->partCount - 1].set;
    return set->mix != NULL ? &set->to->def : &set->def;
}

// ---- change ----

// The newest part turns into `set` wave by wave. SW_ERROR_UNSUPPORTED if their phases differ.
static swResult mixPart(swWaves* waves, int slot, swWaveSet* set, double seconds)
{
    swWaveSystem changed = waves->systems[slot];
    swWavePart* part = &changed.parts[changed.partCount - 1];
    swWaveSet* before = part->set;
    swWaveSet* mix = NULL;
    swResult result = swMixSets(waves, before, swGetRamp(&part->share, waves->ticks), set, &mix);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    part->set = mix;
    part->share = swMakeRamp(waves->ticks, 0.0f, 1.0f, seconds);
    part->isMixing = true;
    result = placeSystem(waves, slot, &changed);
    swReleaseSet(waves, result == SW_SUCCESS ? before : mix);
    return result;
}

// All parts of now fade out, a new one fades in.
static swResult addPart(swWaves* waves, int slot, swWaveSet* set, double seconds)
{
    swWaveSystem changed = waves->systems[slot];
    if (changed.partCount == SW_MAX_WAVE_PARTS)
    {
        return swFail(&waves->memory->host, SW_ERROR_LIMIT,
                      "a wave system has %d cross-fades under way, which is the most; wait for one to end",
                      SW_MAX_WAVE_PARTS - 1);
    }
    for (int i = 0; i < changed.partCount; ++i)
    {
        swWavePart* part = &changed.parts[i];
        part->fade = swMakeRamp(waves->ticks, swGetFade(&part->fade, waves->ticks), 0.0f, seconds);
        part->records = (swRecordClock){0}; // a replay shares out the newest part only
    }
    set->useCount += 1;
    changed.parts[changed.partCount++] =
        (swWavePart){.set = set, .fade = swMakeRamp(waves->ticks, 0.0f, 1.0f, seconds)};
    swResult result = placeSystem(waves, slot, &changed);
    if (result != SW_SUCCESS)
    {
        set->useCount -= 1;
    }
    return result;
}

static swResult replaceParts(swWaves* waves, int slot, swWaveSet* set)
{
    swWaveSystem before = waves->systems[slot];
    swWaveSystem changed = before;
    set->useCount += 1;
    changed.partCount = 1;
    changed.parts[0] = (swWavePart){.set = set, .fade = swMakeConstantRamp(1.0f)};
    swResult result = placeSystem(waves, slot, &changed);
    if (result != SW_SUCCESS)
    {
        set->useCount -= 1;
        return result;
    }
    for (int i = 0; i < before.partCount; ++i)
    {
        swReleaseSet(waves, before.parts[i].set);
    }
    return SW_SUCCESS;
}

swResult swShowSet(swWaves* waves, int slot, swWaveSet* set)
{
    return replaceParts(waves, slot, set);
}

void swSharePart(swWaves* waves, int slot, float share, const swRecordClock* records)
{
    swWaveSystem* system = &waves->systems[slot];
    swWavePart* part = &system->parts[system->partCount - 1];
    part->share = swMakeConstantRamp(share);
    part->isShared = part->set->mix != NULL;
    part->records = *records;
    waves->isChanged = true;
}

void swStopRecords(swWaves* waves, int slot)
{
    swWaveSystem* system = &waves->systems[slot];
    system->parts[system->partCount - 1].records = (swRecordClock){0};
}

static swResult changeWaves(swWaves* waves, int slot, swWaveSet* set, double seconds)
{
    if (seconds == 0.0)
    {
        return replaceParts(waves, slot, set);
    }
    swResult result = mixPart(waves, slot, set, seconds);
    return result == SW_ERROR_UNSUPPORTED ? addPart(waves, slot, set, seconds) : result;
}

swResult swChangeSystem(swWaves* waves, int slot, const swWaveSystemDef* def, double seconds)
{
    const swWaveSystem* system = &waves->systems[slot];
    swWaveSet* newest = system->parts[system->partCount - 1].set;
    swDrift drift = swPlanDrift(waves, slot, def, seconds);
    bool isOwn = newest->mix == NULL && newest->useCount == 1;
    if (isOwn && swAreSameWaves(&newest->def, def))
    {
        swTurnSet(waves, newest, def, &drift); // a current that changes in every step costs nothing
    }
    swWaveSet* set = NULL;
    swResult result = swAcquireSet(waves, slot, def, &drift, &set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (set != newest && set != newest->to)
    {
        result = changeWaves(waves, slot, set, seconds);
        warnOfTwins(waves, slot, set);
    }
    else if (seconds == 0.0 && (set != newest || system->partCount > 1))
    {
        result = replaceParts(waves, slot, set); // where it was going anyway, but now
    }
    swReleaseSet(waves, set);
    if (result == SW_SUCCESS)
    {
        swRampWeight(waves, slot, def->weight, seconds);
    }
    return result;
}

void swRampWeight(swWaves* waves, int slot, float weight, double seconds)
{
    swWaveSystem* system = &waves->systems[slot];
    float before = swGetRamp(&system->weight, waves->ticks);
    system->weight = seconds == 0.0 ? swMakeConstantRamp(weight) : swMakeRamp(waves->ticks, before, weight, seconds);
    waves->isChanged = true;
}

// ---- as time goes on ----

static void finishMix(swWaves* waves, swWavePart* part)
{
    swWaveSet* mix = part->set;
    part->set = mix->to;
    part->set->useCount += 1;
    part->isMixing = part->isShared = false;
    part->records = (swRecordClock){0};
    swReleaseSet(waves, mix);
}

static void advanceSystem(swWaves* waves, swWaveSystem* system)
{
    int gone = 0;
    for (int i = 0; i < system->partCount; ++i)
    {
        swWavePart* part = &system->parts[i];
        if (part->isMixing && swIsRampOver(&part->share, waves->ticks))
        {
            finishMix(waves, part);
        }
        bool isGone =
            i == gone && i + 1 < system->partCount && part->fade.to == 0.0f && swIsRampOver(&part->fade, waves->ticks);
        gone += isGone ? 1 : 0;
    }
    if (gone > 0)
    {
        releaseParts(waves, system, gone);
        waves->isTileListStale = true;
    }
}

void swAdvanceSystems(swWaves* waves)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        advanceSystem(waves, &waves->systems[slot]);
    }
}

// ---- at any time ----

// Of a mix by a replay's records: what swSeaReplay_Advance() would ask for at that time.
static float getRecordShare(const swRecordClock* records, double time, bool* isHeld)
{
    double seconds = records->startSeconds + (time - records->startTime) * records->speed;
    bool isInside = seconds >= records->first && seconds <= records->last;
    *isHeld = *isHeld || !isInside;
    if (!isInside)
    {
        return seconds < records->first ? 0.0f : 1.0f;
    }
    double span = records->last - records->first; // infinite of one record for all times before or after
    return span > 0.0 && isfinite(span) ? (float)((seconds - records->first) / span) : 0.0f;
}

static void showSet(swShown* shown, swWaveSet* set, float share, float weight, int slot)
{
    int i = 0;
    while (i < shown->count && shown->sets[i].set != set)
    {
        i += 1;
    }
    if (i == shown->count)
    {
        shown->sets[shown->count++] = (swShownSet){.set = set, .system = slot, .share = share};
    }
    swShownSet* one = &shown->sets[i];
    one->system = weight > 0.0f && one->weight == 0.0f ? slot : one->system;
    one->weight += weight;
}

void swFindShown(const swWaves* waves, double time, int64_t ticks, swShown* shown)
{
    shown->count = 0;
    shown->isHeld = false;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        const swWaveSystem* system = &waves->systems[slot];
        for (int i = 0; i < system->partCount; ++i)
        {
            const swWavePart* part = &system->parts[i];
            float weight = swGetRamp(&system->weight, ticks) * swGetFade(&part->fade, ticks);
            bool isOver = part->isMixing && swIsRampOver(&part->share, ticks);
            float share = swGetRamp(&part->share, ticks);
            if (ticks != waves->ticks && part->records.isRunning && !part->isMixing)
            {
                share = getRecordShare(&part->records, time, &shown->isHeld);
            }
            else if (ticks != waves->ticks && part->isShared && !part->isMixing)
            {
                shown->isHeld = true; // of a replay that was saved and has not been taken up
            }
            showSet(shown, isOver ? part->set->to : part->set, share, weight, slot);
        }
    }
}
