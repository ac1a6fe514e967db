// SPDX-License-Identifier: MIT
#include "core/world/zone.h"

#include "core/base/host.h"

swResult swMakeWorld(const swHost* host, const swWorldDef* def, const swWaveKernels* kernels, swWorld** worldOut)
{
    swWorld* world = swAllocateZero(host, sizeof(swWorld));
    if (world == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a world (%zu bytes)", sizeof(swWorld));
    }
    world->host = *host;
    swBeginMemory(&world->memory, &world->host, sizeof(swWorld));
    world->def = *def;
    world->kernels = kernels;
    swBeginWaves(&world->waves, &world->memory, kernels, def);
    world->systemIds = swMakeIdPool(SW_MAX_WAVE_SYSTEMS);
    swBeginInputs(&world->inputs, &world->memory, &world->systemIds, def->seaLevel);
    world->waves.list.evenFlow = &world->inputs.evenFlow;
    swBeginWaterBodies(&world->waterBodies, &world->inputs);
    world->frame = (swFrame){
        .inputs = &world->inputs.arrays.set,
        .seaLevel = def->seaLevel,
        .gravity = def->gravity,
        .foam = def->foam,
        .views = world->viewFrames,
        .zones = world->zoneFrames,
    };
    world->moment =
        (swMoment){.host = &world->host, .kernels = kernels, .frame = &world->frame, .origin = &world->origin};
    world->wind = swMakeWind(&def->wind);
    swDeriveWind(&world->wind, 0, &world->frame.windField);
    *worldOut = world;
    return SW_SUCCESS;
}

void swFreeWorld(swWorld* world)
{
    while (world->zoneCount > 0)
    {
        swRemoveZone(world->zones[world->zoneCount - 1]);
    }
    while (world->viewCount > 0)
    {
        swRemoveView(world->views[world->viewCount - 1]);
    }
    swEndWaterBodies(&world->waterBodies);
    swEndInputs(&world->inputs);
    swEndWaves(&world->waves);
    swHost host = world->host;
    swFree(&host, world, sizeof(swWorld));
}

swResult swCreateSystem(swWorld* world, const swWaveSystemDef* def, swId* id)
{
    if (world->systemIds.count == SW_MAX_WAVE_SYSTEMS)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "the world has %d wave systems, which is the most",
                      SW_MAX_WAVE_SYSTEMS);
    }
    *id = swAllocId(&world->systemIds);
    swResult result = swAddWorldSystem(world, id->index1 - 1, def);
    if (result != SW_SUCCESS)
    {
        swFreeId(&world->systemIds, *id);
    }
    return result;
}

void swDestroySystem(swWorld* world, swId id)
{
    swRemoveSystem(&world->waves, id.index1 - 1);
    swFreeId(&world->systemIds, id);
    world->inputs.isChanged = true; // those that weigh its waves have none any more
}

const swFrame* swGetWorldFrame(const swWorld* world)
{
    return &world->frame;
}

const swHost* swGetWorldHost(const swWorld* world)
{
    return &world->host;
}

const swHost* swFindHost(const swWorld* world)
{
    return world != NULL ? &world->host : NULL;
}

swPosXZ swGetWorldOrigin(const swWorld* world)
{
    return world->origin;
}
