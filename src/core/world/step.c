// SPDX-License-Identifier: MIT
// The order of a step.

#include <math.h>

#include "core/world/world.h"

// Time, systems and the list of tiles, then the views, which need to know what waves there are.
static void beginFrame(swWorld* world, double time)
{
    int64_t before = world->frame.ticks;
    double dt = time - world->time;
    world->time = time;
    world->frame.time = world->time;
    world->frame.ticks = (int64_t)floor(world->time * SW_TICKS_PER_SECOND + 0.5);
    world->frame.dt = dt;
    swAdvanceWaves(&world->waves, &world->frame);
    swFindFoamLaw(&world->whitecaps, &world->frame);
    swPlaceViews(world, swGetTicksBetween(before, world->frame.ticks));
}

void swStepWorldTo(swWorld* world, double time)
{
    beginFrame(world, time);         // time, tiles, slices snapped to texels
    swTransformWaves(&world->waves); // spectra to tiles
    swStepViews(world);              // tiles to slices, then foam
    world->waves.isChanged = false;
}

void swStepWorld(swWorld* world, double dt)
{
    swStepWorldTo(world, world->time + dt);
}
