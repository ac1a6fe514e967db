// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/waves/replay.h"
#include "core/world/world.h"
#include "seaway/replay.h"

struct swSeaReplay
{
    swWorld* world;
    swSeaReplayDef def;
    swWaveSystemId system;
    swReplay replay;
};

#define SW_DEF swSeaReplayDef
static const swField replayFields[] = {
    SW_GIVEN(sea, .key = NULL, .label = "sea"),
    SW_NUMBER(location, "", SW_WITHIN(0.0, INT32_MAX), 0.0, .key = NULL, .label = "place", .use = SW_USE_HERE),
    SW_PART(waves, &swWaveSystemFields, .key = NULL, .label = "waves"),
    SW_NUMBER(startTime, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), 0.0, .key = "time_s", .label = "at",
              .tip = "The world's time at which the sea is that of the first moment", SW_KNOB(-3600.0, 3600.0)),
    SW_NUMBER(startSeconds, "s", SW_WITHIN(-1e15, 1e15), (double)NAN, .key = NULL, .label = "from",
              .tip = "Seconds since 1970, UTC", SW_OR((double)NAN), SW_KNOB(0.0, 4e9)),
    SW_NUMBER(speed, "", SW_WITHIN(-1e6, 1e6), 1.0, .key = "speed", .label = "speed",
              .tip = "Seconds of records a second of the world", SW_KNOB(0.0, 3600.0)),
    SW_GIVEN(system, .key = NULL, .label = "system"),
};
#undef SW_DEF

static const swFields seaReplayFields = SW_FIELDS(swSeaReplayDef, "replay", "replay", replayFields, -1);

const swFields* swGetSeaReplayFields(void)
{
    return &seaReplayFields;
}

swSeaReplayDef swDefaultSeaReplayDef(void)
{
    swSeaReplayDef def;
    swFillDef(&seaReplayFields, &def);
    def.waves = swDefaultWaveSystemDef();
    return def;
}

// The first record and the last count for all times before and after.
static swRecordClock makeClock(const swSeaReplayDef* def, double seconds, int before, int after)
{
    swRecordClock clock = {
        .isRunning = true,
        .startTime = def->startTime,
        .startSeconds = def->startSeconds,
        .speed = def->speed,
        .first = swMeasuredSea_GetRecord(def->sea, before).seconds,
        .last = swMeasuredSea_GetRecord(def->sea, after).seconds,
    };
    if (before == after)
    {
        bool isAlone = swMeasuredSea_GetLocation(def->sea, def->location).recordCount == 1;
        bool isBefore = seconds <= clock.first;
        clock.first = isAlone || isBefore ? -(double)INFINITY : clock.first;
        clock.last = isAlone || !isBefore ? (double)INFINITY : clock.last;
    }
    return clock;
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
    swRecordClock clock = makeClock(&replay->def, seconds, before, after);
    return swShowRecords(&replay->world->waves, &replay->replay, replay->system.index1 - 1, before, after, fraction,
                         &clock);
}

static swResult failReplay(swWorld* world, const char* what)
{
    return swFail(&world->host, SW_ERROR_INVALID, "a sea's replay cannot be made: %s", what);
}

static swResult checkDef(swWorld* world, const swSeaReplayDef* def)
{
    swResult result = swCheckDef(&world->host, &seaReplayFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->sea == NULL || def->location >= swMeasuredSea_GetLocationCount(def->sea))
    {
        return failReplay(world, def->sea == NULL ? "its sea is NULL" : "its sea has no such location");
    }
    if (def->waves.method != SW_WAVES_FFT)
    {
        return failReplay(world, "its waves must have the method SW_WAVES_FFT");
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
    SW_REQUIRE(def != NULL, SW_ERROR_INVALID, &world->host, "swCreateSeaReplay() needs a def");
    swResult result = checkDef(world, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swSeaReplay* replay = swAllocateZero(&world->memory.host, sizeof *replay);
    if (replay == NULL)
    {
        return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for a sea's replay");
    }
    replay->world = world;
    replay->def = *def;
    replay->def.startSeconds = findFirstSeconds(def);
    replay->system = def->system;
    replay->replay = (swReplay){.sea = def->sea, .waves = def->waves, .before = -1, .after = -1};
    bool isNew = SW_IS_NULL(def->system);
    if (isNew)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(def->sea, 0);
        swWaveSystemDef waves = swMakeRecordDef(&def->waves, &record.table);
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
        if (swWaveSystem_IsValid(replay->world, replay->system))
        {
            swStopRecords(&replay->world->waves, replay->system.index1 - 1);
        }
        swEndReplay(&replay->world->waves, &replay->replay);
        swFree(&replay->world->memory.host, replay, sizeof *replay);
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
    *before = replay->replay.before;
    *after = replay->replay.after;
    *fraction = replay->replay.fraction;
}
