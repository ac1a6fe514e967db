// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/sim/foam.h"
#include "core/world/world.h"

#define SW_LONGEST_STEP 3600.0

swResult swCreateWorld(const swHost* host, const swWorldDef* def, swWorld** world)
{
    if (world != NULL)
    {
        *world = NULL;
    }
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host, "swCreateWorld() needs a host made by swDefaultHost()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE && world != NULL, SW_ERROR_INVALID, host,
               "swCreateWorld() needs a def made by swDefaultWorldDef() and a place for the world");
    swResult result = swCheckDef(host, &swWorldFields, def);
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
    SW_REQUIRE(world != NULL, SW_ERROR_INVALID, NULL, "swWorld_Step() needs a world");
    SW_REQUIRE(dt >= 0.0 && dt <= SW_LONGEST_STEP, SW_ERROR_INVALID, &world->host,
               "swWorld_Step() was asked to advance by %g s; it must be 0 to %g", dt, SW_LONGEST_STEP);
    SW_REQUIRE(fabs(world->time + dt) <= SW_LARGEST_TIME, SW_ERROR_INVALID, &world->host,
               "swWorld_Step() was asked to go on to %.17g s; times end at %.17g", world->time + dt, SW_LARGEST_TIME);
    swStepWorld(world, dt);
    return SW_SUCCESS;
}

void swWorld_SetTime(swWorld* world, double time)
{
    SW_REQUIRE_VOID(world != NULL && fabs(time) <= SW_LARGEST_TIME, swFindHost(world),
                    "swWorld_SetTime() was given %.17g s; a time must be within %.17g of 0", time, SW_LARGEST_TIME);
    world->time = time;
}

swResult swWorld_StepTo(swWorld* world, double time)
{
    SW_REQUIRE(world != NULL && fabs(time) <= SW_LARGEST_TIME, SW_ERROR_INVALID, swFindHost(world),
               "swWorld_StepTo() was given %.17g s; a time must be within %.17g of 0", time, SW_LARGEST_TIME);
    swStepWorldTo(world, time);
    return SW_SUCCESS;
}

void swWorld_SetOrigin(swWorld* world, swPosXZ origin)
{
    SW_REQUIRE_VOID(world != NULL && fabs(origin.x) <= SW_FARTHEST_ORIGIN && fabs(origin.z) <= SW_FARTHEST_ORIGIN,
                    swFindHost(world), "swWorld_SetOrigin() was given (%g, %g) m; an origin must be within %g m of 0",
                    origin.x, origin.z, SW_FARTHEST_ORIGIN);
    world->origin = origin;
}

swPosXZ swWorld_GetOrigin(const swWorld* world)
{
    SW_REQUIRE(world != NULL, (swPosXZ){0}, NULL, "swWorld_GetOrigin() needs a world");
    return world->origin;
}

double swWorld_GetTime(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0.0, NULL, "swWorld_GetTime() needs a world");
    return world->frame.time;
}

void swWorld_SetFoam(swWorld* world, const swFoamDef* foam)
{
    SW_REQUIRE_VOID(world != NULL && foam != NULL, swFindHost(world), "swWorld_SetFoam() needs a world and a def");
    if (swCheckDef(&world->host, &swFoamFields, foam) != SW_SUCCESS)
    {
        return;
    }
    world->def.foam = *foam;
    world->frame.foam = *foam;
}

swFoamState swWorld_GetFoamState(const swWorld* world)
{
    SW_REQUIRE(world != NULL, (swFoamState){0}, NULL, "swWorld_GetFoamState() needs a world");
    const swFoamLaw* law = &world->frame.foamLaw;
    return (swFoamState){.windSpeed = law->wind, .cover = law->cover, .threshold = law->threshold};
}

double swWorld_GetSeaLevel(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0.0, NULL, "swWorld_GetSeaLevel() needs a world");
    return world->def.seaLevel;
}

float swWorld_GetGravity(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0.0f, NULL, "swWorld_GetGravity() needs a world");
    return world->def.gravity;
}

swIsa swWorld_GetIsa(const swWorld* world)
{
    SW_REQUIRE(world != NULL, SW_ISA_BEST, NULL, "swWorld_GetIsa() needs a world");
    return swGetWaveKernelsIsa(world->kernels);
}

const char* swIsa_GetName(swIsa isa)
{
    return (unsigned)isa < SW_ISA_COUNT ? swIsaWords[isa] : "unknown";
}

uint64_t swWorld_GetDigest(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetDigest() needs a world");
    return swHashWorld(world);
}

size_t swWorld_GetMemory(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetMemory() needs a world");
    return world->memory.held;
}
