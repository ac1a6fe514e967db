// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"

const swMoment* swWorld_GetMoment(const swWorld* world)
{
    SW_REQUIRE(world != NULL, NULL, NULL, "swWorld_GetMoment() needs a world");
    return &world->moment;
}

swMomentDef swDefaultMomentDef(void)
{
    return (swMomentDef){.internalValue = SW_DEF_COOKIE};
}

size_t swWorld_GetMomentSize(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetMomentSize() needs a world");
    return swFindMomentSize(&world->waves, &world->inputs);
}

static swMomentSource getSource(const swWorld* world)
{
    return (swMomentSource){&world->host,  &world->waves, &world->inputs,
                            &world->frame, world->origin, swFindLocalSystems(world)};
}

swResult swCreateMoment(const swWorld* world, const swMomentDef* def, swMoment** moment)
{
    if (moment != NULL)
    {
        *moment = NULL;
    }
    SW_REQUIRE(world != NULL && moment != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateMoment() needs a world and a place for the moment");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateMoment() needs a def made by swDefaultMomentDef()");
    SW_REQUIRE(fabs(def->time) <= SW_LARGEST_TIME, SW_ERROR_INVALID, &world->host,
               "swCreateMoment() was given %.17g s; a time must be within %.17g of 0", def->time, SW_LARGEST_TIME);
    SW_REQUIRE((uintptr_t)def->memory % 64 == 0, SW_ERROR_INVALID, &world->host,
               "swCreateMoment() was given memory that is not 64-byte aligned");
    swMomentSource source = getSource(world);
    swOwnMoment* own = NULL;
    swResult result = swMakeMoment(&source, def, &own);
    *moment = result == SW_SUCCESS ? &own->moment : NULL;
    return result;
}

static bool isOwn(const swMoment* moment)
{
    return moment != NULL && moment->isOwn;
}

static const swHost* findHost(const swMoment* moment)
{
    return moment != NULL ? moment->host : NULL;
}

swResult swMoment_Set(swMoment* moment, const swWorld* world, double time)
{
    SW_REQUIRE(isOwn(moment) && !((swOwnMoment*)moment)->isMapped, SW_ERROR_INVALID,
               moment != NULL ? moment->host : swFindHost(world),
               "swMoment_Set() needs a moment made by swCreateMoment()");
    SW_REQUIRE(world != NULL && fabs(time) <= SW_LARGEST_TIME, SW_ERROR_INVALID, moment->host,
               "swMoment_Set() needs a world, and a time within %.17g of 0; it was given %.17g s", SW_LARGEST_TIME,
               time);
    swMomentSource source = getSource(world);
    return swSetMoment((swOwnMoment*)moment, &source, time);
}

void swDestroyMoment(swMoment* moment)
{
    if (moment == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(moment->isOwn, moment->host, "swDestroyMoment() was given the moment that a world has of its own");
    swFreeMoment((swOwnMoment*)moment);
}

const void* swMoment_GetMemory(const swMoment* moment, size_t* size)
{
    SW_REQUIRE(moment != NULL && size != NULL, NULL, findHost(moment),
               "swMoment_GetMemory() needs a moment and a place for the size");
    const swOwnMoment* own = isOwn(moment) ? (const swOwnMoment*)moment : NULL;
    *size = own != NULL ? own->usedSize : 0;
    return own != NULL ? own->memory : NULL;
}

swResult swMapMoment(const swHost* host, const void* memory, size_t size, swMoment** moment)
{
    if (moment != NULL)
    {
        *moment = NULL;
    }
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host, "swMapMoment() needs a host made by swDefaultHost()");
    SW_REQUIRE(memory != NULL && (uintptr_t)memory % 64 == 0 && moment != NULL, SW_ERROR_INVALID, host,
               "swMapMoment() needs the memory of a moment, 64-byte aligned, and a place for the moment");
    swOwnMoment* own = NULL;
    swResult result = swMapMomentBlock(host, memory, size, &own);
    *moment = result == SW_SUCCESS ? &own->moment : NULL;
    return result;
}

double swMoment_GetTime(const swMoment* moment)
{
    SW_REQUIRE(moment != NULL, 0.0, NULL, "swMoment_GetTime() needs a moment");
    return moment->frame->time;
}

bool swMoment_IsHeld(const swMoment* moment)
{
    SW_REQUIRE(moment != NULL, false, NULL, "swMoment_IsHeld() needs a moment");
    return moment->isHeld;
}
