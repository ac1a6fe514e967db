// SPDX-License-Identifier: MIT
// Replays. A replayed system has one layer: the set of one record, or a mix of two whose share the replay sets. The two
// sets stay with the replay as long as their pair is current, so that a step forward makes one new set and not two.

#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"
#include "seaway/replay.h"

struct swSeaReplay
{
    swWorld* world;
    swSeaReplayDef def;
    swWaveSystemId system;
    int before, after; // records; -1: none yet
    double fraction;
    uint32_t rewindCount; // of the world, when the pair became current
    swWaveSet* sets[2];   // of both; the second may be the first
};

swSeaReplayDef swDefaultSeaReplayDef(void)
{
    return (swSeaReplayDef){
        .waves = swDefaultWaveSystemDef(),
        .startSeconds = (double)NAN,
        .speed = 1.0,
        .internalValue = SW_DEF_COOKIE,
    };
}

// One of the sets that the replay holds, or a new one; counted as used once more.
static swResult acquireRecord(swSeaReplay* replay, int index, swWaveSet** set)
{
    for (int i = 0; i < 2; ++i)
    {
        if (replay->sets[i] != NULL && index == (i == 0 ? replay->before : replay->after))
        {
            *set = replay->sets[i];
            (*set)->useCount += 1;
            return SW_SUCCESS;
        }
    }
    swMeasuredRecord record = swMeasuredSea_GetRecord(replay->def.sea, index);
    swWaveSystemDef def = replay->def.waves;
    def.spectrum.kind = SW_SPECTRUM_TABLE;
    def.spectrum.table = &record.table;
    return swAcquireSet(replay->world, &def, set);
}

static void releaseSets(swSeaReplay* replay, swWaveSet* sets[2])
{
    for (int i = 0; i < 2; ++i)
    {
        if (sets[i] != NULL)
        {
            swReleaseSet(replay->world, sets[i]);
            sets[i] = NULL;
        }
    }
}

// Make the pair current: its sets, their mix, and the system's only layer.
static swResult changePair(swSeaReplay* replay, swWaveSystem* system, int before, int after)
{
    swWaveSet* sets[2] = {NULL, NULL};
    swWaveSet* shown = NULL;
    swResult result = acquireRecord(replay, before, &sets[0]);
    result = result == SW_SUCCESS ? acquireRecord(replay, after, &sets[1]) : result;
    if (result == SW_SUCCESS && sets[0] != sets[1])
    {
        result = swMixSets(replay->world, sets[0], sets[1], &shown);
        result = result == SW_ERROR_UNSUPPORTED ? SW_ERROR_INVALID : result;
    }
    else if (result == SW_SUCCESS)
    {
        shown = sets[0];
        shown->useCount += 1;
    }
    if (result == SW_SUCCESS)
    {
        result = swShowSet(replay->world, system, shown); // uses it by itself
        swReleaseSet(replay->world, shown);
    }
    if (result != SW_SUCCESS)
    {
        releaseSets(replay, sets);
        return result;
    }
    releaseSets(replay, replay->sets);
    replay->sets[0] = sets[0];
    replay->sets[1] = sets[1];
    replay->before = before;
    replay->after = after;
    replay->rewindCount = replay->world->rewindCount;
    return SW_SUCCESS;
}

swResult swSeaReplay_Advance(swSeaReplay* replay, double time)
{
    SW_REQUIRE(replay != NULL, SW_ERROR_INVALID, NULL, "swSeaReplay_Advance() needs a replay");
    SW_REQUIRE(fabs(time) <= SW_LARGEST_TIME, SW_ERROR_INVALID, &replay->world->host,
               "swSeaReplay_Advance() was given %.17g s; a time must be within %.17g of 0", time, SW_LARGEST_TIME);
    if (!swWaveSystem_IsValid(replay->world, replay->system))
    {
        return swFail(&replay->world->host, SW_ERROR_INVALID, "a replay's wave system is gone");
    }
    double seconds = replay->def.startSeconds + (time - replay->def.startTime) * replay->def.speed;
    int before = 0, after = 0;
    double fraction = 0.0;
    if (!swMeasuredSea_Bracket(replay->def.sea, replay->def.location, seconds, &before, &after, &fraction))
    {
        return swFail(&replay->world->host, SW_ERROR_INVALID, "a replay's place has no records");
    }
    swWaveSystem* system = &replay->world->systems[replay->system.index1 - 1];
    if (before != replay->before || after != replay->after || replay->rewindCount != replay->world->rewindCount)
    {
        swResult result = changePair(replay, system, before, after);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    replay->fraction = fraction;
    swShareLayer(replay->world, system, (float)fraction);
    return SW_SUCCESS;
}

static swResult failReplay(swWorld* world, const char* what)
{
    return swFail(&world->host, SW_ERROR_INVALID, "a sea's replay cannot be made: %s", what);
}

static swResult checkDef(swWorld* world, const swSeaReplayDef* def)
{
    if (def->sea == NULL || def->location < 0 || def->location >= swMeasuredSea_GetLocationCount(def->sea))
    {
        return failReplay(world, def->sea == NULL ? "its sea is NULL" : "its sea has no such location");
    }
    if (def->waves.method != SW_WAVES_FFT)
    {
        return failReplay(world, "its waves must have the method SW_WAVES_FFT");
    }
    bool isStart = isnan(def->startSeconds) || fabs(def->startSeconds) <= 1e15;
    if (!(fabs(def->startTime) <= SW_LARGEST_TIME && fabs(def->speed) <= 1e6 && isStart))
    {
        return failReplay(world, "its startTime, startSeconds or speed is out of range");
    }
    return SW_SUCCESS;
}

static double findFirstSeconds(const swSeaReplayDef* def)
{
    if (!isnan(def->startSeconds))
    {
        return def->startSeconds;
    }
    int before = 0, after = 0;
    double fraction = 0.0;
    swMeasuredSea_Bracket(def->sea, def->location, -1e18, &before, &after, &fraction);
    return swMeasuredSea_GetRecord(def->sea, before).seconds;
}

swResult swCreateSeaReplay(swWorld* world, const swSeaReplayDef* def, swSeaReplay** replayOut)
{
    if (replayOut != NULL)
    {
        *replayOut = NULL;
    }
    SW_REQUIRE(world != NULL && replayOut != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateSeaReplay() needs a world and a place for the replay");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE && def->waves.internalValue == SW_DEF_COOKIE,
               SW_ERROR_INVALID, &world->host, "swCreateSeaReplay() needs a def made by swDefaultSeaReplayDef()");
    swResult result = checkDef(world, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swSeaReplay* replay = swAllocateZero(&world->countedHost, sizeof *replay);
    if (replay == NULL)
    {
        return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for a sea's replay");
    }
    replay->world = world;
    replay->def = *def;
    replay->def.startSeconds = findFirstSeconds(def);
    replay->system = def->system;
    replay->before = replay->after = -1;
    bool isNew = SW_IS_NULL(def->system);
    if (isNew)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(def->sea, 0);
        swWaveSystemDef waves = def->waves;
        waves.spectrum.kind = SW_SPECTRUM_TABLE;
        waves.spectrum.table = &record.table;
        result = swCreateWaveSystem(world, &waves, &replay->system);
    }
    if (result == SW_SUCCESS)
    {
        result = swSeaReplay_Advance(replay, world->time);
    }
    if (result != SW_SUCCESS)
    {
        if (isNew && swWaveSystem_IsValid(world, replay->system))
        {
            swDestroyWaveSystem(world, replay->system);
        }
        swDestroySeaReplay(replay);
        return result;
    }
    *replayOut = replay;
    return SW_SUCCESS;
}

void swDestroySeaReplay(swSeaReplay* replay)
{
    if (replay != NULL)
    {
        releaseSets(replay, replay->sets);
        swFree(&replay->world->countedHost, replay, sizeof *replay);
    }
}

swWaveSystemId swSeaReplay_GetSystem(const swSeaReplay* replay)
{
    SW_REQUIRE(replay != NULL, (swWaveSystemId){0}, NULL, "swSeaReplay_GetSystem() needs a replay");
    return replay->system;
}

void swSeaReplay_GetRecords(const swSeaReplay* replay, int* before, int* after, double* fraction)
{
    bool isComplete = before != NULL && after != NULL && fraction != NULL;
    SW_REQUIRE_VOID(replay != NULL && isComplete, replay != NULL ? &replay->world->host : NULL,
                    "swSeaReplay_GetRecords() needs a replay and a place for each answer");
    *before = replay->before;
    *after = replay->after;
    *fraction = replay->fraction;
}
