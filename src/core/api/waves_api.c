// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/world/world.h"

swWaveSystemDef swDefaultWaveSystemDef(void)
{
    return (swWaveSystemDef){
        .spectrum = swDefaultSpectrumDef(),
        .resolution = 128,
        .tileWaves = 32,
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
    if (!(def->minWavelength >= 0.0625f && def->minWavelength < def->maxWavelength && def->maxWavelength <= 4096.0f))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's wavelengths are %g to %g m; they must ascend within 0.0625 to 4096",
                      (double)def->minWavelength, (double)def->maxWavelength);
    }
    return SW_SUCCESS;
}

static swResult checkWaves(const swHost* host, const swWaveSystemDef* def)
{
    if (!(def->chop >= 0.0f && def->chop <= 2.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's chop is %g; it must be in [0, 2]", (double)def->chop);
    }
    if (!(def->weight >= 0.0f && def->weight <= 10.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's weight is %g; it must be in [0, 10]",
                      (double)def->weight);
    }
    if (!(def->loopPeriod >= 0.0f && def->loopPeriod < INFINITY))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's loop period is %g s; it must be 0 or more",
                      (double)def->loopPeriod);
    }
    return SW_SUCCESS;
}

swResult swCreateWaveSystem(swWorld* world, const swWaveSystemDef* def, swWaveSystemId* idOut)
{
    bool isValid = world != NULL && def != NULL && def->internalValue == SW_DEF_COOKIE && idOut != NULL;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return SW_ERROR_INVALID;
    }
    *idOut = (swWaveSystemId){0, 0};
    swResult result = checkTiles(&world->host, def);
    result = result == SW_SUCCESS ? checkWaves(&world->host, def) : result;
    swId id;
    result = result == SW_SUCCESS ? swAddSystem(world, def, &id) : result;
    if (result == SW_SUCCESS)
    {
        *idOut = (swWaveSystemId){id.index1, id.generation};
    }
    return result;
}

// NULL for a stale handle.
static swWaveSystem* findSystem(const swWorld* world, swWaveSystemId id)
{
    bool isValid = swWaveSystem_IsValid(world, id);
    return isValid ? (swWaveSystem*)&world->systems[id.index1 - 1] : NULL;
}

void swDestroyWaveSystem(swWorld* world, swWaveSystemId id)
{
    bool isValid = swWaveSystem_IsValid(world, id);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swRemoveSystem(world, (swId){id.index1, id.generation});
    }
}

bool swWaveSystem_IsValid(const swWorld* world, swWaveSystemId id)
{
    return world != NULL && swIsIdValid(&world->systemIds, (swId){id.index1, id.generation});
}

swResult swWaveSystem_SetSpectrum(swWorld* world, swWaveSystemId id, const swSpectrumDef* spectrum)
{
    swWaveSystem* system = findSystem(world, id);
    SW_ASSERT(system != NULL && spectrum != NULL);
    if (system == NULL || spectrum == NULL)
    {
        return SW_ERROR_INVALID;
    }
    return swReplaceSpectrum(world, system, spectrum);
}

void swWaveSystem_SetWeight(swWorld* world, swWaveSystemId id, float weight)
{
    swWaveSystem* system = findSystem(world, id);
    bool isValid = system != NULL && weight >= 0.0f && weight <= 10.0f;
    SW_ASSERT(isValid);
    if (isValid)
    {
        system->def.weight = weight;
    }
}

float swWaveSystem_GetWeight(const swWorld* world, swWaveSystemId id)
{
    const swWaveSystem* system = findSystem(world, id);
    SW_ASSERT(system != NULL);
    return system != NULL ? system->def.weight : 0.0f;
}

int swWaveSystem_GetBands(const swWorld* world, swWaveSystemId id, swBandInfo* bands)
{
    const swWaveSystem* system = findSystem(world, id);
    SW_ASSERT(system != NULL && bands != NULL);
    if (system == NULL || bands == NULL)
    {
        return 0;
    }
    int count = 0;
    float square = system->def.weight * system->def.weight;
    for (int i = 0; i < SW_MAX_BANDS; ++i)
    {
        const swBandModes* band = &system->set->bands[i];
        if (band->modeCount > 0)
        {
            bands[count++] = (swBandInfo){
                .minWavelength = band->minWavelength,
                .maxWavelength = band->maxWavelength,
                .tileSide = (float)band->side,
                .modeCount = band->modeCount,
                .variance = band->variance * square,
                .meanSquareSlope = (band->slopeVarianceX + band->slopeVarianceZ) * square,
            };
        }
    }
    return count;
}
