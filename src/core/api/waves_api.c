// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"

swWaveSystemDef swDefaultWaveSystemDef(void)
{
    return (swWaveSystemDef){
        .spectrum = swDefaultSpectrumDef(),
        .method = SW_WAVES_FFT,
        .resolution = 128,
        .tileWaves = 32,
        .componentsPerOctave = 8,
        .leastJacobian = 0.1f,
        .minWavelength = 0.0625f,
        .maxWavelength = 4096.0f,
        .chop = 1.0f,
        .weight = 1.0f,
        .seed = 1,
        .internalValue = SW_DEF_COOKIE,
    };
}

static bool isPowerOfTwo(int value)
{
    return value > 0 && (value & (value - 1)) == 0;
}

static swResult checkTiles(const swHost* host, const swWaveSystemDef* def)
{
    if (!isPowerOfTwo(def->resolution) || def->resolution < 16 || def->resolution > 512)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's resolution is %d; it must be a power of two in [16, 512]", def->resolution);
    }
    if (def->tileWaves < 4 || def->tileWaves > def->resolution / 4)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's tileWaves is %d; with resolution %d it must be in [4, %d]", def->tileWaves,
                      def->resolution, def->resolution / 4);
    }
    return SW_SUCCESS;
}

static bool isWithin(float value, double least, double most)
{
    return (double)value >= least && (double)value <= most; // false for NaN
}

static swResult checkComponents(const swHost* host, const swWaveSystemDef* def)
{
    if (def->componentCount < 0 || def->componentCount > SW_MAX_FREE_WAVES ||
        (def->componentCount > 0 && def->components == NULL))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's components are %d at %s; it may have up to %d",
                      def->componentCount, def->components == NULL ? "NULL" : "an address", SW_MAX_FREE_WAVES);
    }
    for (int i = 0; i < def->componentCount; ++i)
    {
        const swWaveComponent* c = &def->components[i];
        if (!isWithin(c->wavelength, 0.0625, 4096.0) || !isWithin(c->direction, -1000.0, 1000.0) ||
            !isWithin(c->amplitude, 0.0, 40.0) || !isWithin(c->phase, -1e6, 1e6))
        {
            return swFail(
                host, SW_ERROR_INVALID,
                "component %d of a wave system has wavelength %g m (0.0625 to 4096), direction %g rad (-1000 to "
                "1000), amplitude %g m (0 to 40) and phase %g rad (-1e6 to 1e6)",
                i, (double)c->wavelength, (double)c->direction, (double)c->amplitude, (double)c->phase);
        }
    }
    return SW_SUCCESS;
}

static swResult checkGerstner(const swHost* host, const swWaveSystemDef* def)
{
    if (def->componentsPerOctave < 1 || def->componentsPerOctave > 32)
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's componentsPerOctave is %d; it must be in [1, 32]",
                      def->componentsPerOctave);
    }
    if (!isWithin(def->reverseWeight, 0.0, 1.0) || !isWithin(def->directionVariance, 0.0, 3.1416))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's reverseWeight is %g (0 to 1) and its directionVariance %g rad (0 to pi)",
                      (double)def->reverseWeight, (double)def->directionVariance);
    }
    if (!isWithin(def->leastJacobian, -10.0, 0.9))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's leastJacobian is %g; it must be in [-10, 0.9]",
                      (double)def->leastJacobian);
    }
    return checkComponents(host, def);
}

static swResult checkWaves(const swHost* host, const swWaveSystemDef* def)
{
    if (!(def->minWavelength >= 0.0625f && def->minWavelength < def->maxWavelength && def->maxWavelength <= 4096.0f))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's wavelengths are %g to %g m; they must ascend within 0.0625 to 4096",
                      (double)def->minWavelength, (double)def->maxWavelength);
    }
    if (!(def->chop >= 0.0f && def->chop <= 2.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's chop is %g; it must be in [0, 2]", (double)def->chop);
    }
    if (!(def->weight >= 0.0f && def->weight <= 10.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's weight is %g; it must be in [0, 10]",
                      (double)def->weight);
    }
    if (!(def->loopPeriod >= 0.0f && (double)def->loopPeriod <= SW_LARGEST_TIME))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's loop period is %g s; it must be in [0, %g]",
                      (double)def->loopPeriod, SW_LARGEST_TIME);
    }
    return SW_SUCCESS;
}

swResult swCheckWaveSystemDef(const swHost* host, const swWaveSystemDef* def)
{
    if ((unsigned)def->method >= SW_WAVE_METHOD_COUNT)
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's method is %d; it must be in [0, %d]", (int)def->method,
                      SW_WAVE_METHOD_COUNT - 1);
    }
    swResult result = swCheckSpectrum(host, &def->spectrum);
    result = result == SW_SUCCESS ? checkWaves(host, def) : result;
    if (result == SW_SUCCESS)
    {
        result = def->method == SW_WAVES_FFT ? checkTiles(host, def) : checkGerstner(host, def);
    }
    return result;
}

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
    result = result == SW_SUCCESS ? swAddSystem(world, def, &id) : result;
    if (result == SW_SUCCESS)
    {
        *idOut = (swWaveSystemId){id.index1, id.generation};
    }
    return result;
}

// NULL for a handle that is stale or null, which is told.
static swWaveSystem* findSystem(const swWorld* world, swWaveSystemId id, const char* call)
{
    SW_REQUIRE(
        swWaveSystem_IsValid(world, id), NULL, swFindHost(world),
        "%s was given the wave system %d of generation %u, which is not there: destroyed, of another world, or null",
        call, id.index1, id.generation);
    return (swWaveSystem*)&world->systems[id.index1 - 1];
}

void swDestroyWaveSystem(swWorld* world, swWaveSystemId id)
{
    if (findSystem(world, id, "swDestroyWaveSystem()") != NULL)
    {
        swRemoveSystem(world, (swId){id.index1, id.generation});
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
    swWaveSystem* system = findSystem(world, id, "swWaveSystem_Set()");
    if (system == NULL)
    {
        return SW_ERROR_INVALID;
    }
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swWaveSystem_Set() needs a def made by swDefaultWaveSystemDef()");
    SW_REQUIRE(isTransition(seconds), SW_ERROR_INVALID, &world->host,
               "swWaveSystem_Set() was asked to take %g s; a change takes 0 to %g s", seconds, SW_MAX_TRANSITION);
    swResult result = swCheckWaveSystemDef(&world->host, def);
    return result == SW_SUCCESS ? swChangeSystem(world, system, def, seconds) : result;
}

swWaveSystemDef swWaveSystem_Get(const swWorld* world, swWaveSystemId id)
{
    const swWaveSystem* system = findSystem(world, id, "swWaveSystem_Get()");
    if (system == NULL)
    {
        return swDefaultWaveSystemDef();
    }
    swWaveSystemDef def = *swGetSystemDef(system);
    def.weight = system->weight.to;
    return def;
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
    swWaveSystem* system = findSystem(world, id, "swWaveSystem_FadeWeight()");
    if (system == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(isWithin(weight, 0.0, 10.0) && isTransition(seconds), &world->host,
                    "a wave system was asked for the weight %g (0 to 10) over %g s (0 to %g)", (double)weight, seconds,
                    SW_MAX_TRANSITION);
    swRampWeight(world, system, weight, seconds);
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
    const swWaveSet* set = system->layers[system->layerCount - 1].set;
    float weight = swGetRamp(&system->weight, world->frame.ticks);
    float square = weight * weight;
    return set->def.method == SW_WAVES_FFT ? listBands(set, square, bands) : listOctaves(set, square, bands);
}
