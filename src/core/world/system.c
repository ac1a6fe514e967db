// SPDX-License-Identifier: MIT
// Wave systems, and how they change. A system's layers add up to its sea: one, unless a cross-fade is under way. What a
// layer weighs and how far its mix has come are functions of time, so that steps of any length give the same sea.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/scalar.h"
#include "core/world/world.h"

// Two systems are told of if their variance is more than this part too high.
#define TWIN_PART 0.05

static swRamp makeConstant(float value)
{
    return (swRamp){.from = value, .to = value};
}

static swRamp makeRamp(const swWorld* world, float from, float to, double seconds)
{
    return (swRamp){
        .from = from,
        .to = to,
        .begin = world->frame.ticks,
        .length = (int64_t)floor(seconds * SW_TICKS_PER_SECOND + 0.5),
    };
}

// How far a ramp has come, 0 to 1.
static double getProgress(const swRamp* ramp, int64_t ticks)
{
    int64_t passed = swGetTicksBetween(ramp->begin, ticks);
    if (ramp->length <= 0 || passed >= ramp->length)
    {
        return 1.0;
    }
    return passed > 0 ? (double)passed / (double)ramp->length : 0.0;
}

bool swIsRampOver(const swRamp* ramp, int64_t ticks)
{
    return getProgress(ramp, ticks) >= 1.0;
}

float swGetRamp(const swRamp* ramp, int64_t ticks)
{
    float part = (float)getProgress(ramp, ticks);
    return ramp->from + (ramp->to - ramp->from) * part;
}

// Weights of cross-fades: what comes and what goes have squares that add up to one.
static float getFade(const swRamp* fade, int64_t ticks)
{
    double part = getProgress(fade, ticks);
    if (part >= 1.0)
    {
        return fade->to;
    }
    float sine, cosine;
    swSinCosTurns((uint32_t)(part * 0x1p30), &sine, &cosine);
    return fade->from * cosine + fade->to * sine;
}

// ---- limits ----

// Tiles and free waves of a system that are not also those of an earlier system or layer.
static void countWaves(const swWaveSystem* systems, int* tiles, int* waves)
{
    const swWaveSet* seen[SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_LAYERS];
    int seenCount = 0;
    *tiles = 0;
    *waves = 0;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].layerCount; ++i)
        {
            const swWaveSet* set = systems[slot].layers[i].set;
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

bool swIsWithinLimits(const swWorld* world, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS])
{
    int tiles, waves;
    countWaves(systems, &tiles, &waves);
    if (tiles > SW_MAX_TILES)
    {
        swFail(&world->host, SW_ERROR_LIMIT, "the world would have %d tiles; %d are possible", tiles, SW_MAX_TILES);
        return false;
    }
    if (waves > SW_MAX_FREE_WAVES)
    {
        swFail(&world->host, SW_ERROR_LIMIT, "the world would have %d free waves; %d are possible", waves,
               SW_MAX_FREE_WAVES);
        return false;
    }
    return true;
}

// Put a system into a slot if the world then keeps to its limits.
static swResult placeSystem(swWorld* world, int slot, const swWaveSystem* system)
{
    swWaveSystem before = world->systems[slot];
    world->systems[slot] = *system;
    if (!swIsWithinLimits(world, world->systems))
    {
        world->systems[slot] = before;
        return SW_ERROR_LIMIT;
    }
    world->isTileListStale = true;
    world->isChanged = true;
    return SW_SUCCESS;
}

// ---- create, remove ----

// Systems of one seed have one phase for each wave: where they overlap, heights add up instead of energies.
static void warnOfTwins(swWorld* world, int slot, const swWaveSet* set)
{
    for (int other = 0; other < SW_MAX_WAVE_SYSTEMS; ++other)
    {
        const swWaveSystem* system = &world->systems[other];
        if (other == slot || system->layerCount == 0)
        {
            continue;
        }
        const swWaveSet* twin = system->layers[system->layerCount - 1].set;
        twin = twin->to != NULL ? twin->to : twin;
        if (twin == set || twin->def.seed != set->def.seed)
        {
            continue;
        }
        double part = swFindSharedVariance(set->bands, twin->bands, set->response);
        if (part > TWIN_PART)
        {
            swLog(&world->host, SW_LOG_WARNING,
                  "two wave systems have the seed %u and waves in common, whose heights add up instead of their "
                  "energies: their variance is %.0f %% too high; give each system a seed of its own.",
                  (unsigned)set->def.seed, 100.0 * part);
        }
    }
}

swResult swAddSystem(swWorld* world, const swWaveSystemDef* def, swId* id)
{
    if (world->systemIds.count == SW_MAX_WAVE_SYSTEMS)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "the world has %d wave systems, which is the most",
                      SW_MAX_WAVE_SYSTEMS);
    }
    swWaveSet* set = NULL;
    swResult result = swAcquireSet(world, def, &set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    *id = swAllocId(&world->systemIds);
    swWaveSystem system = {.layerCount = 1, .weight = makeConstant(def->weight)};
    system.layers[0] = (swWaveLayer){.set = set, .fade = makeConstant(1.0f)};
    result = placeSystem(world, id->index1 - 1, &system);
    if (result != SW_SUCCESS)
    {
        swReleaseSet(world, set);
        swFreeId(&world->systemIds, *id);
        return result;
    }
    warnOfTwins(world, id->index1 - 1, set);
    return result;
}

static void releaseLayers(swWorld* world, swWaveSystem* system, int count)
{
    for (int i = 0; i < count; ++i)
    {
        swReleaseSet(world, system->layers[i].set);
    }
    system->layerCount -= count;
    memmove(system->layers, system->layers + count, (size_t)system->layerCount * sizeof system->layers[0]);
}

void swRemoveSystem(swWorld* world, swId id)
{
    swWaveSystem* system = &world->systems[id.index1 - 1];
    releaseLayers(world, system, system->layerCount);
    *system = (swWaveSystem){0};
    world->isTileListStale = true;
    world->isChanged = true;
    swFreeId(&world->systemIds, id);
}

void swFreeAllSystems(swWorld* world)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        releaseLayers(world, &world->systems[slot], world->systems[slot].layerCount);
    }
    swFreeRetiredSets(world);
}

const swWaveSystemDef* swGetSystemDef(const swWaveSystem* system)
{
    const swWaveSet* set = system->layers[system->layerCount - 1].set;
    return set->mix != NULL ? &set->to->def : &set->def;
}

// ---- change ----

// The newest layer turns into `set` wave by wave. SW_ERROR_UNSUPPORTED if their phases differ.
static swResult mixLayer(swWorld* world, int slot, swWaveSet* set, double seconds)
{
    swWaveSystem changed = world->systems[slot];
    swWaveLayer* layer = &changed.layers[changed.layerCount - 1];
    swWaveSet* before = layer->set;
    swWaveSet* mix = NULL;
    swResult result = swMixSets(world, before, set, &mix);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    layer->set = mix;
    layer->share = makeRamp(world, 0.0f, 1.0f, seconds);
    layer->isMixing = true;
    result = placeSystem(world, slot, &changed);
    swReleaseSet(world, result == SW_SUCCESS ? before : mix);
    return result;
}

// All layers of now fade out, a new one fades in.
static swResult addLayer(swWorld* world, int slot, swWaveSet* set, double seconds)
{
    swWaveSystem changed = world->systems[slot];
    if (changed.layerCount == SW_MAX_WAVE_LAYERS)
    {
        return swFail(&world->host, SW_ERROR_LIMIT,
                      "a wave system has %d cross-fades under way, which is the most; wait for one to end",
                      SW_MAX_WAVE_LAYERS - 1);
    }
    for (int i = 0; i < changed.layerCount; ++i)
    {
        swWaveLayer* layer = &changed.layers[i];
        layer->fade = makeRamp(world, getFade(&layer->fade, world->frame.ticks), 0.0f, seconds);
    }
    set->useCount += 1;
    changed.layers[changed.layerCount++] = (swWaveLayer){.set = set, .fade = makeRamp(world, 0.0f, 1.0f, seconds)};
    swResult result = placeSystem(world, slot, &changed);
    if (result != SW_SUCCESS)
    {
        set->useCount -= 1;
    }
    return result;
}

static swResult replaceLayers(swWorld* world, int slot, swWaveSet* set)
{
    swWaveSystem before = world->systems[slot];
    swWaveSystem changed = before;
    set->useCount += 1;
    changed.layerCount = 1;
    changed.layers[0] = (swWaveLayer){.set = set, .fade = makeConstant(1.0f)};
    swResult result = placeSystem(world, slot, &changed);
    if (result != SW_SUCCESS)
    {
        set->useCount -= 1;
        return result;
    }
    for (int i = 0; i < before.layerCount; ++i)
    {
        swReleaseSet(world, before.layers[i].set);
    }
    return SW_SUCCESS;
}

swResult swShowSet(swWorld* world, swWaveSystem* system, swWaveSet* set)
{
    return replaceLayers(world, (int)(system - world->systems), set);
}

void swShareLayer(swWorld* world, swWaveSystem* system, float share)
{
    swWaveLayer* layer = &system->layers[system->layerCount - 1];
    layer->share = makeConstant(share);
    layer->isShared = layer->set->mix != NULL;
    world->isChanged = true;
}

static swResult changeWaves(swWorld* world, int slot, swWaveSet* set, double seconds)
{
    if (seconds == 0.0)
    {
        return replaceLayers(world, slot, set);
    }
    swResult result = mixLayer(world, slot, set, seconds);
    return result == SW_ERROR_UNSUPPORTED ? addLayer(world, slot, set, seconds) : result;
}

swResult swChangeSystem(swWorld* world, swWaveSystem* system, const swWaveSystemDef* def, double seconds)
{
    int slot = (int)(system - world->systems);
    swWaveSet* set = NULL;
    swResult result = swAcquireSet(world, def, &set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const swWaveSet* newest = system->layers[system->layerCount - 1].set;
    if (set != newest && set != newest->to)
    {
        result = changeWaves(world, slot, set, seconds);
        warnOfTwins(world, slot, set);
    }
    else if (seconds == 0.0 && (set != newest || system->layerCount > 1))
    {
        result = replaceLayers(world, slot, set); // where it was going anyway, but now
    }
    swReleaseSet(world, set);
    if (result == SW_SUCCESS)
    {
        swRampWeight(world, system, def->weight, seconds);
    }
    return result;
}

void swRampWeight(swWorld* world, swWaveSystem* system, float weight, double seconds)
{
    float before = swGetRamp(&system->weight, world->frame.ticks);
    system->weight = seconds == 0.0 ? makeConstant(weight) : makeRamp(world, before, weight, seconds);
    world->isChanged = true;
}

// ---- as time goes on ----

static void finishMix(swWorld* world, swWaveLayer* layer)
{
    swWaveSet* mix = layer->set;
    layer->set = mix->to;
    layer->set->useCount += 1;
    layer->isMixing = false;
    swReleaseSet(world, mix);
}

static void shareMix(swWorld* world, swWaveLayer* layer)
{
    swShareMix(layer->set, swGetRamp(&layer->share, world->frame.ticks));
    world->version += 1;
    layer->set->version = world->version;
}

static void advanceMix(swWorld* world, swWaveLayer* layer)
{
    int64_t ticks = world->frame.ticks;
    if (getProgress(&layer->share, ticks) >= 1.0)
    {
        finishMix(world, layer);
        return;
    }
    shareMix(world, layer);
}

static void advanceSystem(swWorld* world, swWaveSystem* system)
{
    int64_t ticks = world->frame.ticks;
    int gone = 0;
    for (int i = 0; i < system->layerCount; ++i)
    {
        swWaveLayer* layer = &system->layers[i];
        if (layer->isMixing)
        {
            advanceMix(world, layer);
        }
        else if (layer->isShared)
        {
            shareMix(world, layer);
        }
        bool isGone = i == gone && i + 1 < system->layerCount && layer->fade.to == 0.0f &&
                      getProgress(&layer->fade, ticks) >= 1.0;
        gone += isGone ? 1 : 0;
    }
    if (gone > 0)
    {
        releaseLayers(world, system, gone);
        world->isTileListStale = true;
    }
}

static void weighSystem(swWorld* world, int slot)
{
    swWaveSystem* system = &world->systems[slot];
    float weight = swGetRamp(&system->weight, world->frame.ticks);
    for (int i = 0; i < system->layerCount; ++i)
    {
        swWaveSet* set = system->layers[i].set;
        float share = weight * getFade(&system->layers[i].fade, world->frame.ticks);
        set->system = share > 0.0f && set->weight == 0.0f ? slot : set->system;
        set->weight += share;
        system->layers[i].weight = share;
    }
}

void swAdvanceSystems(swWorld* world)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        advanceSystem(world, &world->systems[slot]);
    }
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < world->systems[slot].layerCount; ++i)
        {
            world->systems[slot].layers[i].set->weight = 0.0f;
        }
    }
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        weighSystem(world, slot);
    }
}
