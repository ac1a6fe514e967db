// SPDX-License-Identifier: MIT
// The order of a step.

#include <math.h>

#include "core/base/host.h"
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
    swAdvanceSystems(world);
    swListTiles(world);
    swFindFoamLaw(&world->whitecaps, &world->frame);
    swPlaceViews(world, swGetTicksBetween(before, world->frame.ticks));
}

static float* getTexels(const swWorld* world, int tile, int field)
{
    const swWaveSource* source = &world->tileSources[tile];
    return source->set->texels[field][source->index];
}

// Item i is field i % SW_TEXELS_COUNT of a pair: displacement, velocity, acceleration.
static void transformPairs(void* context, int begin, int end, int worker)
{
    swWorld* world = context;
    char* scratch = (char*)world->scratch + (size_t)worker * world->scratchSize;
    for (int i = begin; i < end; ++i)
    {
        const swTilePair* pair = &world->pairs[i / SW_TEXELS_COUNT];
        int field = i % SW_TEXELS_COUNT;
        float* first = getTexels(world, pair->first, field);
        if (first == NULL)
        {
            continue;
        }
        bool isPair = pair->second >= 0;
        swTransformTiles(world->kernels, &world->tiles[pair->first], first, isPair ? &world->tiles[pair->second] : NULL,
                         isPair ? getTexels(world, pair->second, field) : NULL, world->frame.ticks, field, scratch);
    }
}

static void stepSystems(swWorld* world)
{
    if (world->def.enableQueries)
    {
        swParallelFor(&world->host, transformPairs, world, world->pairCount * SW_TEXELS_COUNT, 1);
    }
}

void swStepWorldTo(swWorld* world, double time)
{
    beginFrame(world, time); // time, tiles, slices snapped to texels
    stepSystems(world);      // spectra to tiles
    swStepViews(world);      // tiles to slices, then foam
    world->isChanged = false;
}

void swStepWorld(swWorld* world, double dt)
{
    swStepWorldTo(world, world->time + dt);
}
