// SPDX-License-Identifier: MIT
// The wind of all systems together, see wind_level.h.

#include <math.h>

#include "core/waves/waves.h"

static void addLevels(const swWaveSet* set, float weight, float* levels)
{
    for (int step = 0; step < SW_MAX_BANDS * SW_WIND_STEPS; ++step)
    {
        levels[step] += weight * weight * set->bands[step / SW_WIND_STEPS].wind[step % SW_WIND_STEPS];
    }
}

// The wind that a system knows. It fades with the system's weight and does not grow beyond weight 1. While a known wind
// gives way to one that the waves tell, or the other way round, what is left of it counts as a level of all waves.
static float findKnownWind(const swWaveSystem* system, int64_t ticks, double gravity)
{
    float known = 0.0f, all = 0.0f;
    float levels[SW_MAX_BANDS * SW_WIND_STEPS] = {0};
    for (int i = 0; i < system->partCount; ++i)
    {
        const swWavePart* part = &system->parts[i];
        float weight = swGetRamp(&system->weight, ticks) * swGetFade(&part->fade, ticks);
        known += weight * weight * part->set->bands[0].knownWind;
        all += weight * weight;
        addLevels(part->set, weight, levels);
    }
    if (!(known > 0.0f))
    {
        return 0.0f;
    }
    known /= fmaxf(all, 1.0f);
    for (int step = 0; step < SW_MAX_BANDS * SW_WIND_STEPS; ++step)
    {
        levels[step] += known;
    }
    return fmaxf(known, swFindWind(levels, gravity));
}

// The levels of waves that tell their wind add up; of the winds that are known the strongest counts.
float swFindWindOfWaves(const swWaves* waves, const swShown* shown)
{
    float levels[SW_MAX_BANDS * SW_WIND_STEPS] = {0};
    for (int i = 0; i < shown->count; ++i)
    {
        addLevels(shown->sets[i].set, shown->sets[i].weight, levels);
    }
    double gravity = (double)waves->gravity;
    float wind = swFindWind(levels, gravity);
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        wind = fmaxf(wind, findKnownWind(&waves->systems[slot], waves->ticks, gravity));
    }
    return fminf(wind, SW_STRONGEST_WIND);
}
