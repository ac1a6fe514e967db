// SPDX-License-Identifier: MIT
#pragma once

// A zone is a stack of levels in the sea that the host places, each twice as wide as the one before, all centred on one
// point. Simulated fields live in zones: their texels decide what the sea does, so they are saved, digested and rolled
// back with the world. Levels are snapped to texels and scroll with the zone, see core/lod/layer_stack.h.

#include "core/base/field.h"
#include "core/world/world.h"

typedef struct swZoneDef
{
    int levelCount;
    int resolution;    // texels along a level's side
    float finestTexel; // m
} swZoneDef;
extern const swFields swZoneFields;

struct swZone
{
    swWorld* world;
    swZoneDef def;
    uint32_t version;
    swPosXZ centre, last; // in the sea: of the next step, of the last one
    swLayerStack layers;
};

swResult swCheckZoneDef(const swHost* host, const swZoneDef* def); // SW_ERROR_INVALID and a sentence in the log
size_t swCountZoneFloats(const swZoneDef* def);                    // that are saved
// SW_ERROR_INVALID, SW_ERROR_LIMIT, SW_ERROR_NO_MEMORY.
swResult swAddZone(swWorld* world, const swZoneDef* def, swZone** zone);
void swRemoveZone(swZone* zone);
// From the next step on; in the host's coordinates.
void swPlaceZone(swZone* zone, swPosXZ centre);
swZoneFrame* swFindZoneFrame(const swZone* zone); // NULL before its first step

void swStepZones(swWorld* world, int64_t elapsedTicks); // to their centres, and simulated fields by that time
void swDeriveZones(swWorld* world);                     // the frame of the last step, of what a saved world holds
void swHashZones(swHash* hash, const swWorld* world);

// zone_save.c: all zones; those that are read are made. A world without zones writes nothing.
swResult swStreamZones(swWorld* world, swStream* stream);
// The same into the zones that the world has: first look whether they fit, then read. SW_ERROR_UNSUPPORTED: it had
// other zones then.
swResult swCheckZones(const swWorld* world, swStream* stream);
void swReadZones(swWorld* world, swStream* stream);
