// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/host.h"
#include "core/world/world.h"

swFoamDef swDefaultFoamDef(void)
{
    return (swFoamDef){.fadeRate = 0.25f, .coverage = 1.0f, .internalValue = SW_DEF_COOKIE};
}

swWorldDef swDefaultWorldDef(void)
{
    return (swWorldDef){
        .gravity = 9.81f,
        .surfaceTension = 7.4e-5f,
        .enableQueries = true,
        .foam = swDefaultFoamDef(),
        .isa = SW_ISA_BEST,
        .internalValue = SW_DEF_COOKIE,
    };
}

// Comparisons are written so that NaN fails them.
static bool isWithin(float value, float least, float most)
{
    return value >= least && value <= most;
}

// A sentence goes to the log.
bool swIsFoamValid(const swHost* host, const swFoamDef* foam)
{
    const struct
    {
        const char* name;
        float value, least, most;
    } fields[] = {
        {"a fade rate", foam->fadeRate, 0.01f, 10.0f},   {"a coverage", foam->coverage, 0.0f, 100.0f},
        {"a wind speed", foam->windSpeed, 0.0f, 100.0f}, {"a shortest wavelength", foam->minWavelength, 0.0f, 1024.0f},
        {"a threshold", foam->threshold, -4.0f, 1.0f},
    };
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; ++i)
    {
        if (!isWithin(fields[i].value, fields[i].least, fields[i].most))
        {
            swFail(host, SW_ERROR_INVALID, "foam has %s of %g; it must be in [%g, %g]", fields[i].name,
                   (double)fields[i].value, (double)fields[i].least, (double)fields[i].most);
            return false;
        }
    }
    return true;
}

swResult swCheckWorldDef(const swHost* host, const swWorldDef* def)
{
    if (!(def->gravity > 0.0f && def->gravity <= 100.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "gravity is %g m/s^2; it must be above 0 and at most 100",
                      (double)def->gravity);
    }
    if (!isWithin(def->surfaceTension, 0.0f, 1e-3f))
    {
        return swFail(host, SW_ERROR_INVALID, "surface tension is %g m^3/s^2; it must be in [0, 0.001]",
                      (double)def->surfaceTension);
    }
    if (!(fabs(def->seaLevel) <= 1e6))
    {
        return swFail(host, SW_ERROR_INVALID, "sea level is %g m; it must be within 1000 km of 0", def->seaLevel);
    }
    if (!swIsFoamValid(host, &def->foam))
    {
        return SW_ERROR_INVALID;
    }
    if ((unsigned)def->isa >= SW_ISA_COUNT)
    {
        return swFail(host, SW_ERROR_INVALID, "instruction set %d does not exist", (int)def->isa);
    }
    return SW_SUCCESS;
}
