// SPDX-License-Identifier: MIT
// The order of a step.

#include <math.h>

#include "core/world/zone.h"

void swSetFrameTime(swWorld* world, double time, double dt)
{
    world->time = time;
    world->frame.time = time;
    world->frame.ticks = (int64_t)floor(time * SW_TICKS_PER_SECOND + 0.5);
    world->frame.dt = dt;
}

// Slots of systems whose waves are only where an input says so.
uint32_t swFindLocalSystems(const swWorld* world)
{
    uint32_t systems = 0;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        bool isLocal = swIsSlotUsed(&world->systemIds, slot) && swGetSystemDef(&world->waves.systems[slot])->isLocal;
        systems |= isLocal ? 1u << slot : 0u;
    }
    return systems;
}

// The water of the present time: the inputs that shape it, its tiles and free waves, and what foam is born by. Nothing
// here has a past.
void swDeriveWater(swWorld* world)
{
    swStepInputs(&world->inputs, world->frame.time, world->frame.ticks, swFindLocalSystems(world));
    swStepWaterBodies(&world->waterBodies, &world->frame);
    swDeriveWaves(&world->waves, &world->frame);
    swDeriveWorldWind(world);
    swFindFoamLaw(&world->whitecaps, &world->frame);
    swTransformWaves(&world->waves); // spectra to tiles
}

void swStepWorldTo(swWorld* world, double time)
{
    int64_t before = world->frame.ticks;
    swSetFrameTime(world, time, time - world->time);
    int64_t elapsed = swGetTicksBetween(before, world->frame.ticks);
    swAdvanceWaves(&world->waves, world->frame.ticks); // changes that are over end
    swDeriveWater(world);                              // waves to tiles
    swStepZones(world, elapsed);                       // simulated fields
    swStepViews(world, elapsed);                       // tiles to slices, then foam
    world->waves.isChanged = false;
}

void swStepWorld(swWorld* world, double dt)
{
    swStepWorldTo(world, world->time + dt);
}
