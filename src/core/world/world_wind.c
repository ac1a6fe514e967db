// SPDX-License-Identifier: MIT
// The world's wind, and the wave systems that take it: their waves are made of a spectrum with the world's wind in it,
// and the wind that their def names is kept beside them.

#include <math.h>

#include "core/world/world.h"

// The def to make waves of, which no longer tells that the wind was taken: systems with the same waves share them.
static swWaveSystemDef takeWind(const swWindDef* wind, const swWaveSystemDef* def, swOwnWind* own)
{
    swWaveSystemDef made = *def;
    made.takesWind = false;
    *own = (swOwnWind){0};
    if (def->takesWind)
    {
        const swSpectrumDef* spectrum = &def->spectrum;
        *own = (swOwnWind){true, spectrum->hasWind, spectrum->windSpeed, spectrum->direction};
        if (wind->speed > 0.0f)
        {
            made.spectrum.windSpeed = wind->speed;
            made.spectrum.direction = wind->direction;
            made.spectrum.hasWind = true;
        }
    }
    return made;
}

swResult swAddWorldSystem(swWorld* world, int slot, const swWaveSystemDef* def)
{
    swOwnWind own;
    swWaveSystemDef made = takeWind(&world->wind.to, def, &own);
    swResult result = swAddSystem(&world->waves, slot, &made);
    if (result == SW_SUCCESS)
    {
        world->waves.systems[slot].own = own;
    }
    return result;
}

swResult swChangeWorldSystem(swWorld* world, int slot, const swWaveSystemDef* def, double seconds)
{
    swOwnWind own;
    swWaveSystemDef made = takeWind(&world->wind.to, def, &own);
    swResult result = swChangeSystem(&world->waves, slot, &made, seconds);
    if (result == SW_SUCCESS)
    {
        world->waves.systems[slot].own = own;
    }
    return result;
}

swWaveSystemDef swGetWorldSystemDef(const swWorld* world, int slot)
{
    const swWaveSystem* system = &world->waves.systems[slot];
    swWaveSystemDef def = *swGetSystemDef(system);
    def.weight = system->weight.to;
    if (system->own.isReplaced)
    {
        def.takesWind = true;
        def.spectrum.hasWind = system->own.isKnown;
        def.spectrum.windSpeed = system->own.speed;
        def.spectrum.direction = system->own.direction;
    }
    return def;
}

swResult swChangeWorldWind(swWorld* world, const swWindDef* def, double seconds)
{
    const swWind before = world->wind;
    swChangeWind(&world->wind, def, world->frame.ticks, seconds);
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        swWaveSystem* system = &world->waves.systems[slot];
        if (system->partCount == 0 || !system->own.isReplaced)
        {
            continue;
        }
        const swWaveSystemDef asked = swGetWorldSystemDef(world, slot);
        const swRamp weight = system->weight; // it may be running
        swResult result = swChangeWorldSystem(world, slot, &asked, seconds);
        if (result != SW_SUCCESS)
        {
            world->wind = before;
            return result;
        }
        system->weight = weight;
    }
    world->def.wind = *def;
    swDeriveWind(&world->wind, world->frame.ticks, &world->frame.windField);
    return SW_SUCCESS;
}

void swDeriveWorldWind(swWorld* world)
{
    swFrame* frame = &world->frame;
    swDeriveWind(&world->wind, frame->ticks, &frame->windField);
    if (frame->windField.isNamed)
    {
        swVec2 mean = swFindMeanWind(&frame->windField, frame->ticks);
        frame->wind = sqrtf(mean.x * mean.x + mean.y * mean.y);
    }
}
