// SPDX-License-Identifier: MIT
#include "core/world/zone.h"

#include <math.h>

#include "core/base/host.h"

// What a zone has beside its layers.
typedef struct ZoneState
{
    swZoneDef def;
    swPosXZ centre, last;
    bool isPlaced;
} ZoneState;

static void streamPlace(swStream* stream, swPosXZ* place)
{
    const double farthest = SW_FARTHEST_VIEWPOINT + SW_FARTHEST_ORIGIN;
    swStreamF64(stream, &place->x);
    swStreamF64(stream, &place->z);
    stream->isBroken = stream->isBroken || !(fabs(place->x) <= farthest && fabs(place->z) <= farthest);
}

static void streamState(swStream* stream, ZoneState* state)
{
    swStreamDef(stream, &swZoneFields, &state->def);
    streamPlace(stream, &state->centre);
    streamPlace(stream, &state->last);
    swStreamBool(stream, &state->isPlaced);
}

static ZoneState getState(const swZone* zone)
{
    return (ZoneState){zone->def, zone->centre, zone->last, zone->layers.stack.isPlaced};
}

// Levels are those of the last step, where the next one finds the past of layers.
static void setState(swZone* zone, const ZoneState* state)
{
    swStack* stack = &zone->layers.stack;
    double seaLevel = zone->world->def.seaLevel;
    zone->centre = state->centre;
    zone->last = state->last;
    stack->isPlaced = state->isPlaced;
    if (state->isPlaced)
    {
        swPlaceStack(stack, (swPos){state->last.x, seaLevel, state->last.z}, seaLevel);
    }
}

static swResult readZone(swWorld* world, swStream* stream)
{
    ZoneState state = {0};
    swZone* zone = NULL;
    streamState(stream, &state);
    // Before memory is asked for: what is saved of the layers must be there.
    bool isFine = !stream->isBroken && swCheckZoneDef(&world->host, &state.def) == SW_SUCCESS &&
                  swStreamHasLeft(stream, swCountZoneFloats(&state.def), sizeof(float));
    swResult result = isFine ? swAddZone(world, &state.def, &zone) : SW_ERROR_FORMAT;
    if (result == SW_SUCCESS)
    {
        setState(zone, &state);
        swStreamLayers(stream, &zone->layers);
        result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    }
    return result;
}

swResult swStreamZones(swWorld* world, swStream* stream)
{
    bool isReading = swIsReading(stream);
    int count = world->zoneCount;
    if (isReading ? stream->at == stream->size : count == 0)
    {
        return SW_SUCCESS;
    }
    swStreamRange(stream, &count, 1, SW_MAX_ZONES);
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        if (!isReading)
        {
            ZoneState state = getState(world->zones[i]);
            streamState(stream, &state);
            swStreamLayers(stream, &world->zones[i]->layers);
            continue;
        }
        swResult result = readZone(world, stream);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

swResult swCheckZones(const swWorld* world, swStream* stream)
{
    int count = 0;
    if (stream->at < stream->size)
    {
        swStreamRange(stream, &count, 1, SW_MAX_ZONES);
    }
    if (!stream->isBroken && count != world->zoneCount)
    {
        return SW_ERROR_UNSUPPORTED;
    }
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        ZoneState state = {0};
        streamState(stream, &state);
        if (!stream->isBroken && !swIsSameDef(&swZoneFields, &state.def, &world->zones[i]->def))
        {
            return SW_ERROR_UNSUPPORTED;
        }
        swCheckLayers(stream, &world->zones[i]->layers);
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

void swReadZones(swWorld* world, swStream* stream)
{
    int count = 0;
    if (world->zoneCount > 0)
    {
        swStreamRange(stream, &count, 1, SW_MAX_ZONES);
    }
    for (int i = 0; i < count; ++i)
    {
        ZoneState state = {0};
        streamState(stream, &state);
        setState(world->zones[i], &state);
        swStreamLayers(stream, &world->zones[i]->layers);
    }
}
