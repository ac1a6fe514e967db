// SPDX-License-Identifier: MIT
// A world's state as bytes, see seaway/save.h: clocks, waves (core/waves/waves_save.c), inputs and
// bodies of water (core/input), handles, views (view_save.c), zones (zone_save.c). What a step works out is not saved:
// it is derived again.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/input/water_bodies_save.h"
#include "core/waves/waves_save.h"
#include "core/world/view_save.h"
#include "core/world/zone.h"

// ---- systems ----

// Layers that are read do not yet count as users of their sets.
static void streamSystems(swStream* stream, const swSetList* list, swIdPool* ids, swWaveSystem* systems)
{
    swStreamU64(stream, &ids->used);
    if (ids->used >> SW_MAX_WAVE_SYSTEMS != 0)
    {
        stream->isBroken = true;
        ids->used = 0;
    }
    int count = 0;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        swStreamU32(stream, &ids->generations[slot]);
        if ((ids->used >> slot & 1) != 0)
        {
            count += 1;
            swStreamSystem(stream, list, &systems[slot]);
        }
    }
    if (swIsReading(stream))
    {
        ids->count = count;
    }
}

// ---- all of it ----

// Times, the origin, whether a change waits for the next step, and how far the wind has changed.
typedef struct Clocks
{
    double time, stepped;
    int64_t ticks;
    swPosXZ origin;
    bool isChanged;
    swWind wind;
} Clocks;

static Clocks getClocks(const swWorld* world)
{
    return (Clocks){world->time,   world->frame.time,      world->frame.ticks,
                    world->origin, world->waves.isChanged, world->wind};
}

static bool isWithin(double value, double largest)
{
    return value <= largest && value >= -largest; // false for NaN
}

static void streamClocks(swStream* stream, const swWorld* world, Clocks* clocks)
{
    swStreamF64(stream, &clocks->time);
    swStreamF64(stream, &clocks->stepped);
    swStreamI64(stream, &clocks->ticks);
    swStreamF64(stream, &clocks->origin.x);
    swStreamF64(stream, &clocks->origin.z);
    swStreamBool(stream, &clocks->isChanged);
    swStreamWind(stream, &world->def.wind, &clocks->wind);
    bool isFine = isWithin(clocks->time, SW_LARGEST_TIME) && isWithin(clocks->stepped, SW_LARGEST_TIME) &&
                  isWithin(clocks->origin.x, SW_FARTHEST_ORIGIN) && isWithin(clocks->origin.z, SW_FARTHEST_ORIGIN) &&
                  clocks->ticks == (int64_t)floor(clocks->stepped * SW_TICKS_PER_SECOND + 0.5);
    stream->isBroken = stream->isBroken || !isFine;
}

// Everything that was read is in its place but the frame of the last step, which is derived.
static void finishReading(swWorld* world, const Clocks* clocks, const swPos last[SW_MAX_VIEWS])
{
    world->origin = clocks->origin;
    world->wind = clocks->wind;
    swSetFrameTime(world, clocks->stepped, 0.0);
    world->waves.isTileListStale = true;
    swAdvanceWaves(&world->waves, world->frame.ticks);
    world->inputs.ticks = world->frame.ticks;
    swDeriveWater(world);
    swDeriveZones(world);
    swDeriveViews(world, last);
    world->time = clocks->time;
    world->waves.isChanged = clocks->isChanged;
}

swResult swStreamState(swWorld* world, swStream* stream, const swRestoreDef* find)
{
    Clocks clocks = getClocks(world);
    swSetList list = {0};
    swPos last[SW_MAX_VIEWS];
    streamClocks(stream, world, &clocks);
    if (stream->isBroken)
    {
        return SW_ERROR_FORMAT;
    }
    if (!swIsReading(stream))
    {
        swListSets(&world->waves, &list);
    }
    swResult result = swStreamSets(&world->waves, stream, &list);
    if (result == SW_SUCCESS)
    {
        streamSystems(stream, &list, &world->systemIds, world->waves.systems);
        result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    }
    if (swIsReading(stream))
    {
        swUseLayers(world->waves.systems);
    }
    for (int i = 0; i < list.count && swIsReading(stream); ++i)
    {
        swReleaseSet(&world->waves, list.sets[i]);
    }
    result = result == SW_SUCCESS ? swStreamInputs(&world->inputs, stream, find) : result;
    result = result == SW_SUCCESS ? swStreamWaterBodies(&world->waterBodies, stream) : result;
    for (int i = 0; i < world->inputs.count && result == SW_SUCCESS && swIsReading(stream); ++i)
    {
        bool isFlow = swGetInputAt(&world->inputs, i)->def.field == SW_INPUT_FLOW;
        result = isFlow ? swCarryWaves(&world->waves) : result;
    }
    result = result == SW_SUCCESS ? swStreamViews(world, stream, last) : result;
    result = result == SW_SUCCESS ? swStreamZones(world, stream) : result;
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        result = swIsWithinLimits(&world->waves, world->waves.systems) ? SW_SUCCESS : SW_ERROR_FORMAT;
        if (result == SW_SUCCESS)
        {
            finishReading(world, &clocks, last);
        }
    }
    return result == SW_SUCCESS && stream->isBroken ? SW_ERROR_FORMAT : result;
}

// ---- back to a state of this world ----

// All of a state but waves and layers, read before anything is changed.
typedef struct Rewind
{
    Clocks clocks;
    swSetList sets; // of the world's own
    swIdPool ids;
    swWaveSystem systems[SW_MAX_WAVE_SYSTEMS];
    swViewState views[SW_MAX_VIEWS];
    size_t layers[SW_MAX_VIEWS];  // where they are in the stream
    size_t inputs, bodies, zones; // likewise
} Rewind;

static swResult failRewind(const swWorld* world, const char* what)
{
    return swFail(&world->host, SW_ERROR_UNSUPPORTED, "the world cannot go back to a saved state: %s", what);
}

static swResult findSets(const swWorld* world, swStream* stream, swSetList* sets)
{
    swResult result = swFindSets(&world->waves, stream, sets);
    return result != SW_ERROR_UNSUPPORTED
               ? result
               : failRewind(world, "a wave system had other waves then, which are gone; make "
                                   "a world of it with swRestoreWorld()");
}

static swResult readViews(const swWorld* world, swStream* stream, Rewind* rewind)
{
    int count = 0;
    swStreamRange(stream, &count, 0, SW_MAX_VIEWS);
    if (!stream->isBroken && count != world->viewCount)
    {
        return failRewind(world, "it had another number of views then");
    }
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        swViewDef def = world->views[i]->def;
        swStreamDef(stream, &swViewFields, &def);
        if (!stream->isBroken && !swIsSameDef(&swViewFields, &def, &world->views[i]->def))
        {
            return failRewind(world, "a view had another def then");
        }
        swStreamViewState(stream, def.maxScaleLevel, &rewind->views[i]);
        rewind->layers[i] = stream->at;
        swCheckLayers(stream, &world->views[i]->layers);
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

static swResult findInputs(const swWorld* world, swStream* stream)
{
    swResult result = swCheckInputs(&world->inputs, stream);
    return result != SW_ERROR_UNSUPPORTED
               ? result
               : failRewind(world, "an input that it had then is gone, or has another shape, raster, function or room "
                                   "for points");
}

static swResult findWaterBodies(const swWorld* world, swStream* stream)
{
    swResult result = swCheckWaterBodies(&world->waterBodies, stream);
    return result != SW_ERROR_UNSUPPORTED
               ? result
               : failRewind(world, "a body of water that it had then is gone, or has another shore");
}

static swResult findZones(const swWorld* world, swStream* stream)
{
    swResult result = swCheckZones(world, stream);
    return result != SW_ERROR_UNSUPPORTED ? result : failRewind(world, "it had other zones then");
}

static void applyRewind(swWorld* world, const swStream* stream, const Rewind* rewind)
{
    swUseLayers(rewind->systems);
    swUnuseLayers(&world->waves, world->waves.systems);
    world->systemIds = rewind->ids;
    memcpy(world->waves.systems, rewind->systems, sizeof world->waves.systems);
    swPos last[SW_MAX_VIEWS];
    for (int i = 0; i < world->viewCount; ++i)
    {
        swView* view = world->views[i];
        swStream layers = *stream;
        layers.at = rewind->layers[i];
        swStreamLayers(&layers, &view->layers);
        swSetViewState(view, &rewind->views[i]);
        last[i] = rewind->views[i].last;
    }
    swStream inputs = *stream;
    inputs.at = rewind->inputs;
    swRewindInputs(&world->inputs, &inputs);
    swStream bodies = *stream;
    bodies.at = rewind->bodies;
    swRewindWaterBodies(&world->waterBodies, &bodies);
    swStream zones = *stream;
    zones.at = rewind->zones;
    swReadZones(world, &zones);
    world->waves.rewindCount += 1;
    finishReading(world, &rewind->clocks, last);
}

swResult swRewindState(swWorld* world, swStream* stream)
{
    Rewind rewind = {.ids = swMakeIdPool(SW_MAX_WAVE_SYSTEMS)};
    streamClocks(stream, world, &rewind.clocks);
    swResult result = stream->isBroken ? SW_ERROR_FORMAT : findSets(world, stream, &rewind.sets);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    streamSystems(stream, &rewind.sets, &rewind.ids, rewind.systems);
    rewind.inputs = stream->at;
    result = stream->isBroken ? SW_ERROR_FORMAT : findInputs(world, stream);
    rewind.bodies = stream->at;
    result = result == SW_SUCCESS ? findWaterBodies(world, stream) : result;
    result = result == SW_SUCCESS ? readViews(world, stream, &rewind) : result;
    rewind.zones = stream->at;
    result = result == SW_SUCCESS ? findZones(world, stream) : result;
    bool isFine = stream->at == stream->size && swIsWithinLimits(&world->waves, rewind.systems);
    result = result == SW_SUCCESS && !isFine ? SW_ERROR_FORMAT : result;
    if (result == SW_SUCCESS)
    {
        applyRewind(world, stream, &rewind);
    }
    return result;
}
