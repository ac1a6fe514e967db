// SPDX-License-Identifier: MIT
// The order of a step.

#include <math.h>

#include "core/base/host.h"
#include "core/world/world.h"

// Time and the list of tiles, then the views, which need to know what waves there are.
static void beginFrame(swWorld* world, double dt)
{
    int64_t before = world->frame.ticks;
    world->time += dt;
    world->frame.time = world->time;
    world->frame.ticks = (int64_t)floor(world->time * SW_TICKS_PER_SECOND + 0.5);
    world->frame.dt = dt;
    swListTiles(world);
    swPlaceViews(world, world->frame.ticks - before);
}

static void transformPairs(void* context, int begin, int end, int worker)
{
    swWorld* world = context;
    char* scratch = (char*)world->scratch + (size_t)worker * world->scratchSize;
    for (int i = begin; i < end; ++i)
    {
        int first = world->pairs[i].first;
        int second = world->pairs[i].second;
        swTransformTiles(world->kernels, &world->tiles[first], world->tileTexels[first],
                         second >= 0 ? &world->tiles[second] : NULL, second >= 0 ? world->tileTexels[second] : NULL,
                         world->frame.ticks, scratch);
    }
}

static void stepSystems(swWorld* world)
{
    if (world->def.enableQueries)
    {
        swParallelFor(&world->host, transformPairs, world, world->pairCount, 1);
    }
}

void swStepWorld(swWorld* world, double dt)
{
    beginFrame(world, dt); // time, tiles, slices snapped to texels
    stepSystems(world);    // spectra to tiles
    swStepLayers(world);   // tiles to slices, then foam
}
