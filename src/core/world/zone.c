// SPDX-License-Identifier: MIT
#include "core/world/zone.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"

#define SW_DEF swZoneDef
static const swField zoneFields[] = {
    SW_NUMBER(levelCount, "", SW_WITHIN(1.0, SW_MAX_SLICES), 4.0, .key = "level_count", .label = "levels",
              SW_KNOB(1.0, SW_MAX_SLICES)),
    SW_NUMBER(resolution, "", SW_WITHIN(16.0, 1024.0), 256.0, .key = "resolution", .label = "resolution",
              .tip = "Texels along a level's side, a multiple of 16", SW_KNOB(16.0, 1024.0)),
    SW_NUMBER(finestTexel, "m", SW_WITHIN(0.015625, 16.0), 0.25, .key = "finest_texel_m", .label = "finest texel",
              .tip = "Of the finest level, a power of two", SW_LOG_KNOB(0.015625, 16.0)),
};
#undef SW_DEF

const swFields swZoneFields = SW_PART_FIELDS(swZoneDef, "zone", "zone", zoneFields);

swResult swCheckZoneDef(const swHost* host, const swZoneDef* def)
{
    int exponent;
    swResult result = swCheckDef(host, &swZoneFields, def);
    if (result == SW_SUCCESS && (def->resolution % 16 != 0 || frexpf(def->finestTexel, &exponent) != 0.5f))
    {
        return swFail(
            host, SW_ERROR_INVALID,
            "swZoneDef::resolution is %d and finestTexel %g m; they must be a multiple of 16 and a power of two.",
            def->resolution, (double)def->finestTexel);
    }
    return result;
}

static swLayerStack describeLayers(const swZoneDef* def)
{
    const swViewDef stack = {
        .sliceCount = def->levelCount, .resolution = def->resolution, .finestTexel = def->finestTexel};
    return (swLayerStack){.stack = swMakeStack(&stack), .isZone = true, .hasTexels = true};
}

size_t swCountZoneFloats(const swZoneDef* def)
{
    const swLayerStack layers = describeLayers(def);
    return swCountSavedFloats(&layers);
}

swResult swAddZone(swWorld* world, const swZoneDef* def, swZone** zoneOut)
{
    *zoneOut = NULL;
    swResult result = swCheckZoneDef(&world->host, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (world->zoneCount == SW_MAX_ZONES)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "the world has %d zones, which is the most", SW_MAX_ZONES);
    }
    swZone* zone = swAllocateZero(&world->memory.host, sizeof *zone);
    if (zone == NULL)
    {
        return swFailMemory(&world->memory, "a zone");
    }
    zone->world = world;
    zone->def = *def;
    zone->layers = describeLayers(def);
    if (!swMakeLayers(&world->memory.host, &zone->layers))
    {
        swFree(&world->memory.host, zone, sizeof *zone);
        return swFailMemory(&world->memory, "the layers of a zone's levels");
    }
    world->zoneVersion += 1;
    zone->version = world->zoneVersion;
    world->zones[world->zoneCount] = zone;
    world->zoneCount += 1;
    *zoneOut = zone;
    return SW_SUCCESS;
}

void swRemoveZone(swZone* zone)
{
    swWorld* world = zone->world;
    int index = 0;
    while (world->zones[index] != zone)
    {
        index += 1;
    }
    int after = world->zoneCount - index - 1;
    memmove(&world->zones[index], &world->zones[index + 1], (size_t)after * sizeof world->zones[0]);
    world->zoneCount -= 1;
    // Frames of zones come first and in order; a zone made since the last step has none yet.
    if (index < world->frame.zoneCount)
    {
        int framesAfter = world->frame.zoneCount - index - 1;
        memmove(&world->zoneFrames[index], &world->zoneFrames[index + 1],
                (size_t)framesAfter * sizeof world->zoneFrames[0]);
        world->frame.zoneCount -= 1;
    }
    swFreeLayers(&world->memory.host, &zone->layers);
    swFree(&world->memory.host, zone, sizeof *zone);
}

void swPlaceZone(swZone* zone, swPosXZ centre)
{
    swPosXZ origin = zone->world->origin;
    zone->centre = (swPosXZ){centre.x + origin.x, centre.z + origin.z};
}

swZoneFrame* swFindZoneFrame(const swZone* zone)
{
    swWorld* world = zone->world;
    for (int i = 0; i < world->frame.zoneCount; ++i)
    {
        if (world->zoneFrames[i].zoneVersion == zone->version)
        {
            return &world->zoneFrames[i];
        }
    }
    return NULL;
}

// A zone at a place in the sea, and its frame. Of no elapsed time nothing is advanced.
static void stepZone(swWorld* world, swZone* zone, swPosXZ place, int64_t elapsedTicks, swZoneFrame* frame)
{
    double level = world->def.seaLevel;
    zone->last = place;
    swPlaceLayers(&zone->layers, (swPos){place.x, level, place.z}, level, elapsedTicks, &frame->stack);
    frame->zoneVersion = zone->version;
    frame->centre = place;
    swPlanLayers(world, &zone->layers, &frame->stack);
    swMakeFrameLayers(world, &zone->layers, &frame->stack);
}

void swStepZones(swWorld* world, int64_t elapsedTicks)
{
    for (int i = 0; i < world->zoneCount; ++i)
    {
        stepZone(world, world->zones[i], world->zones[i]->centre, elapsedTicks, &world->zoneFrames[i]);
    }
    world->frame.zoneCount = world->zoneCount;
}

// Zones that were made since the last step come last: their first step is still to come.
void swDeriveZones(swWorld* world)
{
    world->frame.zoneCount = 0;
    for (int i = 0; i < world->zoneCount && world->zones[i]->layers.stack.isPlaced; ++i)
    {
        stepZone(world, world->zones[i], world->zones[i]->last, 0, &world->zoneFrames[i]);
        world->frame.zoneCount = i + 1;
    }
}

void swHashZones(swHash* hash, const swWorld* world)
{
    for (int i = 0; i < world->zoneCount; ++i)
    {
        const swZone* zone = world->zones[i];
        swHashDef(hash, &swZoneFields, &zone->def);
        swAddHashDouble(hash, zone->centre.x);
        swAddHashDouble(hash, zone->centre.z);
        swHashLayers(hash, &zone->layers);
    }
}
