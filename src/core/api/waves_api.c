// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"

swResult swCreateWaveSystem(swWorld* world, const swWaveSystemDef* def, swWaveSystemId* idOut)
{
    if (idOut != NULL)
    {
        *idOut = (swWaveSystemId){0, 0};
    }
    SW_REQUIRE(world != NULL && idOut != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateWaveSystem() needs a world and a place for the handle");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateWaveSystem() needs a def made by swDefaultWaveSystemDef()");
    swResult result = swCheckWaveSystemDef(&world->host, def);
    swId id;
    result = result == SW_SUCCESS ? swCreateSystem(world, def, &id) : result;
    if (result == SW_SUCCESS)
    {
        *idOut = (swWaveSystemId){id.index1, id.generation};
    }
    return result;
}

// NULL for a handle that is stale or null, which is told.
static const swWaveSystem* findSystem(const swWorld* world, swWaveSystemId id, const char* call)
{
    SW_REQUIRE(
        swWaveSystem_IsValid(world, id), NULL, swFindHost(world),
        "%s was given the wave system %d of generation %u, which is not there: destroyed, of another world, or null",
        call, id.index1, id.generation);
    return &world->waves.systems[id.index1 - 1];
}

void swDestroyWaveSystem(swWorld* world, swWaveSystemId id)
{
    if (findSystem(world, id, "swDestroyWaveSystem()") != NULL)
    {
        swDestroySystem(world, (swId){id.index1, id.generation});
    }
}

bool swWaveSystem_IsValid(const swWorld* world, swWaveSystemId id)
{
    return world != NULL && swIsIdValid(&world->systemIds, (swId){id.index1, id.generation});
}

static bool isTransition(double seconds)
{
    return seconds >= 0.0 && seconds <= SW_MAX_TRANSITION;
}

swResult swWaveSystem_Set(swWorld* world, swWaveSystemId id, const swWaveSystemDef* def, double seconds)
{
    const swWaveSystem* system = findSystem(world, id, "swWaveSystem_Set()");
    if (system == NULL)
    {
        return SW_ERROR_INVALID;
    }
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swWaveSystem_Set() needs a def made by swDefaultWaveSystemDef()");
    SW_REQUIRE(isTransition(seconds), SW_ERROR_INVALID, &world->host,
               "swWaveSystem_Set() was asked to take %g s; a change takes 0 to %g s", seconds, SW_MAX_TRANSITION);
    swResult result = swCheckWaveSystemDef(&world->host, def);
    return result == SW_SUCCESS ? swChangeWorldSystem(world, id.index1 - 1, def, seconds) : result;
}

swWaveSystemDef swWaveSystem_Get(const swWorld* world, swWaveSystemId id)
{
    if (findSystem(world, id, "swWaveSystem_Get()") == NULL)
    {
        return swDefaultWaveSystemDef();
    }
    return swGetWorldSystemDef(world, id.index1 - 1);
}

swResult swWaveSystem_SetSpectrum(swWorld* world, swWaveSystemId id, const swSpectrumDef* spectrum)
{
    SW_REQUIRE(spectrum != NULL, SW_ERROR_INVALID, swFindHost(world), "swWaveSystem_SetSpectrum() needs a spectrum");
    if (findSystem(world, id, "swWaveSystem_SetSpectrum()") == NULL)
    {
        return SW_ERROR_INVALID;
    }
    swWaveSystemDef def = swWaveSystem_Get(world, id);
    def.spectrum = *spectrum;
    return swWaveSystem_Set(world, id, &def, 0.0);
}

void swWaveSystem_SetWeight(swWorld* world, swWaveSystemId id, float weight)
{
    swWaveSystem_FadeWeight(world, id, weight, 0.0);
}

void swWaveSystem_FadeWeight(swWorld* world, swWaveSystemId id, float weight, double seconds)
{
    const swWaveSystem* system = findSystem(world, id, "swWaveSystem_FadeWeight()");
    if (system == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(weight >= 0.0f && weight <= 10.0f && isTransition(seconds), &world->host,
                    "a wave system was asked for the weight %g (0 to 10) over %g s (0 to %g)", (double)weight, seconds,
                    SW_MAX_TRANSITION);
    swRampWeight(&world->waves, id.index1 - 1, weight, seconds);
}

float swWaveSystem_GetWeight(const swWorld* world, swWaveSystemId id)
{
    const swWaveSystem* system = findSystem(world, id, "swWaveSystem_GetWeight()");
    return system != NULL ? swGetRamp(&system->weight, world->frame.ticks) : 0.0f;
}

// The octave of a free wave.
static int findBand(float wavelength)
{
    int band = 0;
    while (band < SW_MAX_BANDS - 1 && ldexpf(1.0f, band - 3) <= wavelength)
    {
        band += 1;
    }
    return band;
}

static int listOctaves(const swWaveSet* set, float square, swBandInfo* bands)
{
    swBandInfo octaves[SW_MAX_BANDS] = {0};
    for (int i = 0; i < set->waveCount; ++i)
    {
        const swFreeWave* wave = &set->waves[i];
        swBandInfo* octave = &octaves[findBand(wave->wavelength)];
        octave->modeCount += 1;
        octave->variance += 0.5f * wave->amplitude * wave->amplitude * square;
        octave->meanSquareSlope += swGetFreeWaveSlope(wave) * square;
    }
    int count = 0;
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        if (octaves[band].modeCount > 0)
        {
            octaves[band].minWavelength = ldexpf(1.0f, band - 4);
            octaves[band].maxWavelength = ldexpf(1.0f, band - 3);
            bands[count++] = octaves[band];
        }
    }
    return count;
}

// Parallel tiles of a band are one.
static int listBands(const swWaveSet* set, float square, swBandInfo* bands)
{
    swBandInfo infos[SW_MAX_BANDS] = {0};
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        const swBandModes* band = &set->bands[i];
        swBandInfo* info = &infos[band->band];
        if (band->modeCount > 0)
        {
            info->minWavelength = band->minWavelength;
            info->maxWavelength = band->maxWavelength;
            info->tileSide = info->tileCount == 0 ? (float)band->side : info->tileSide;
            info->tileCount += 1;
            info->modeCount += band->modeCount;
            info->variance += band->variance * square;
            info->meanSquareSlope += (band->slopeVarianceX + band->slopeVarianceZ) * square;
        }
    }
    int count = 0;
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        if (infos[band].modeCount > 0)
        {
            bands[count++] = infos[band];
        }
    }
    return count;
}

int swWaveSystem_GetBands(const swWorld* world, swWaveSystemId id, swBandInfo* bands)
{
    const swWaveSystem* system = findSystem(world, id, "swWaveSystem_GetBands()");
    if (system == NULL)
    {
        return 0;
    }
    SW_REQUIRE(bands != NULL, 0, &world->host, "swWaveSystem_GetBands() needs room for SW_MAX_BANDS bands");
    const swWaveSet* set = system->parts[system->partCount - 1].set;
    float weight = swGetRamp(&system->weight, world->frame.ticks);
    float square = weight * weight;
    return set->def.method == SW_WAVES_FFT ? listBands(set, square, bands) : listOctaves(set, square, bands);
}
