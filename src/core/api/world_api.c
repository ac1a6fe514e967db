// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/world/world.h"

#define SW_LONGEST_STEP 3600.0

// The mean fold below 0.5 of all waves, measured at 1.6 million points, is 0.0014, 0.019, 0.16, 0.36, 1.2 and 2.5 e-4 at
// 3, 5, 8, 10, 15 and 20 m/s; times gain / fadeRate that is the mean foam, less what is cut off at 1.
swFoamDef swDefaultFoamDef(void)
{
    return (swFoamDef){.fadeRate = 0.25f, .threshold = 0.5f, .gain = 65.0f, .internalValue = SW_DEF_COOKIE};
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

static bool isFoamValid(const swFoamDef* foam)
{
    return isWithin(foam->fadeRate, 0.01f, 10.0f) && isWithin(foam->threshold, 0.0f, 1.0f) &&
           isWithin(foam->gain, 0.0f, 1000.0f);
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
    if (!isFoamValid(&def->foam))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "foam has fade rate %g (0.01 to 10), threshold %g (0 to 1) and gain %g (0 to 1000)",
                      (double)def->foam.fadeRate, (double)def->foam.threshold, (double)def->foam.gain);
    }
    if ((unsigned)def->isa >= SW_ISA_COUNT)
    {
        return swFail(host, SW_ERROR_INVALID, "instruction set %d does not exist", (int)def->isa);
    }
    return SW_SUCCESS;
}

swResult swCreateWorld(const swHost* host, const swWorldDef* def, swWorld** world)
{
    SW_ASSERT(swIsHostValid(host) && def != NULL && def->internalValue == SW_DEF_COOKIE && world != NULL);
    if (world != NULL)
    {
        *world = NULL;
    }
    if (!swIsHostValid(host) || def == NULL || def->internalValue != SW_DEF_COOKIE || world == NULL)
    {
        return SW_ERROR_INVALID;
    }
    swResult result = swCheckWorldDef(host, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const swWaveKernels* kernels = swGetWaveKernels(def->isa);
    if (kernels == NULL)
    {
        return swFail(host, SW_ERROR_UNSUPPORTED, "this machine or build has no %s kernels", swIsa_GetName(def->isa));
    }
    return swMakeWorld(host, def, kernels, world);
}

void swDestroyWorld(swWorld* world)
{
    if (world != NULL)
    {
        swFreeWorld(world);
    }
}

swResult swWorld_Step(swWorld* world, double dt)
{
    bool isValid = world != NULL && dt >= 0.0 && dt <= SW_LONGEST_STEP && fabs(world->time + dt) <= SW_LARGEST_TIME;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return SW_ERROR_INVALID;
    }
    swStepWorld(world, dt);
    return SW_SUCCESS;
}

void swWorld_SetTime(swWorld* world, double time)
{
    bool isValid = fabs(time) <= SW_LARGEST_TIME;
    SW_ASSERT(world != NULL && isValid);
    if (world != NULL && isValid)
    {
        world->time = time;
    }
}

swResult swWorld_StepTo(swWorld* world, double time)
{
    bool isValid = world != NULL && fabs(time) <= SW_LARGEST_TIME;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return SW_ERROR_INVALID;
    }
    swStepWorldTo(world, time);
    return SW_SUCCESS;
}

void swWorld_SetOrigin(swWorld* world, swPosXZ origin)
{
    bool isValid = world != NULL && fabs(origin.x) <= SW_FARTHEST_ORIGIN && fabs(origin.z) <= SW_FARTHEST_ORIGIN;
    SW_ASSERT(isValid);
    if (isValid)
    {
        world->origin = origin;
    }
}

swPosXZ swWorld_GetOrigin(const swWorld* world)
{
    return world->origin;
}

double swWorld_GetTime(const swWorld* world)
{
    return world->frame.time;
}

void swWorld_SetFoam(swWorld* world, const swFoamDef* foam)
{
    bool isValid = world != NULL && foam != NULL && foam->internalValue == SW_DEF_COOKIE && isFoamValid(foam);
    SW_ASSERT(isValid);
    if (isValid)
    {
        world->def.foam = *foam;
        world->frame.foam = *foam;
    }
}

double swWorld_GetSeaLevel(const swWorld* world)
{
    return world->def.seaLevel;
}

float swWorld_GetGravity(const swWorld* world)
{
    return world->def.gravity;
}

swIsa swWorld_GetIsa(const swWorld* world)
{
    return swGetWaveKernelsIsa(world->kernels);
}

const char* swIsa_GetName(swIsa isa)
{
    static const char* const names[SW_ISA_COUNT] = {"best", "scalar", "sse2", "avx2", "neon"};
    return (unsigned)isa < SW_ISA_COUNT ? names[isa] : "unknown";
}

uint64_t swWorld_GetDigest(const swWorld* world)
{
    return swHashWorld(world);
}

size_t swWorld_GetMemory(const swWorld* world)
{
    return world->memory;
}
