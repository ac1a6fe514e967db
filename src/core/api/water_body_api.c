// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/input/sample_inputs.h"
#include "core/world/world.h"

static swWaterBodyId makeId(swId id)
{
    return (swWaterBodyId){id.index1, id.generation};
}

// A def as the world keeps it: its place in the sea.
static swWaterBodyDef placeInSea(const swWorld* world, const swWaterBodyDef* def)
{
    swWaterBodyDef placed = *def;
    placed.position.x += world->origin.x;
    placed.position.z += world->origin.z;
    placed.name[SW_MAX_INPUT_NAME - 1] = '\0';
    return placed;
}

static swResult checkDef(const swWorld* world, const swWaterBodyDef* def)
{
    swResult result = swCheckWaterBodyDef(&world->host, def);
    if (result == SW_SUCCESS && !SW_IS_NULL(def->waves) && !swWaveSystem_IsValid(world, def->waves))
    {
        return swFail(&world->host, SW_ERROR_INVALID,
                      "the body of water '%s' has the waves of system %d of generation %u, which is not there; set "
                      "swWaterBodyDef::waves to one that swCreateWaveSystem() gave, or to null",
                      def->name, def->waves.index1, def->waves.generation);
    }
    return result;
}

swResult swCreateWaterBody(swWorld* world, const swWaterBodyDef* def, swWaterBodyId* idOut)
{
    if (idOut != NULL)
    {
        *idOut = (swWaterBodyId){0, 0};
    }
    SW_REQUIRE(world != NULL && idOut != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateWaterBody() needs a world and a place for the handle");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateWaterBody() needs a def made by swDefaultWaterBodyDef()");
    swResult result = checkDef(world, def);
    swId id = {0, 0};
    if (result == SW_SUCCESS)
    {
        const swWaterBodyDef placed = placeInSea(world, def);
        result = swMakeViewFields(world);
        result = result == SW_SUCCESS ? swAddWaterBody(&world->waterBodies, &placed, &id) : result;
        world->frame.bodies = world->waterBodies.shown.data; // which may have moved
    }
    *idOut = makeId(id);
    return result;
}

bool swWaterBody_IsValid(const swWorld* world, swWaterBodyId id)
{
    return world != NULL && swFindWaterBody(&world->waterBodies, (swId){id.index1, id.generation}) != NULL;
}

// NULL for a handle that is stale or null, which is told.
static swWaterBody* findBody(const swWorld* world, swWaterBodyId id, const char* call)
{
    SW_REQUIRE(swWaterBody_IsValid(world, id), NULL, swFindHost(world),
               "%s was given the body of water %d of generation %u, which is not there: destroyed, of another world, "
               "or null",
               call, id.index1, id.generation);
    return swFindWaterBody(&world->waterBodies, (swId){id.index1, id.generation});
}

void swDestroyWaterBody(swWorld* world, swWaterBodyId id)
{
    swWaterBody* body = findBody(world, id, "swDestroyWaterBody()");
    if (body != NULL)
    {
        swRemoveWaterBody(&world->waterBodies, body);
    }
}

swResult swWaterBody_Set(swWorld* world, swWaterBodyId id, const swWaterBodyDef* def)
{
    swWaterBody* body = findBody(world, id, "swWaterBody_Set()");
    if (body == NULL)
    {
        return SW_ERROR_INVALID;
    }
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swWaterBody_Set() needs a def made by swDefaultWaterBodyDef()");
    swResult result = checkDef(world, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const swWaterBodyDef placed = placeInSea(world, def);
    return swChangeWaterBody(&world->waterBodies, body, &placed);
}

swWaterBodyDef swWaterBody_Get(const swWorld* world, swWaterBodyId id)
{
    const swWaterBody* body = findBody(world, id, "swWaterBody_Get()");
    if (body == NULL)
    {
        return swDefaultWaterBodyDef();
    }
    swWaterBodyDef def = body->def;
    def.position.x -= world->origin.x;
    def.position.z -= world->origin.z;
    return def;
}

void swWaterBody_SetLevel(swWorld* world, swWaterBodyId id, double level)
{
    swWaterBody* body = findBody(world, id, "swWaterBody_SetLevel()");
    if (body == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(fabs(level) <= 1e6, &world->host,
                    "swWaterBody_SetLevel() was given %g m; a level is within 1e6 m of 0", level);
    swSetWaterBodyLevel(&world->waterBodies, body, level);
}

// ---- which there are ----

swWaterBodyId swWorld_GetNumberedWaterBody(const swWorld* world, int number)
{
    SW_REQUIRE(world != NULL, (swWaterBodyId){0}, NULL, "swWorld_GetNumberedWaterBody() needs a world");
    const swWaterBody* body = swGetWaterBodyAt(&world->waterBodies, number);
    return body != NULL ? makeId(swGetWaterBodyId(&world->waterBodies, body)) : (swWaterBodyId){0};
}

swWaterBodyId swWorld_FindWaterBody(const swWorld* world, double x, double z)
{
    SW_REQUIRE(world != NULL, (swWaterBodyId){0}, NULL, "swWorld_FindWaterBody() needs a world");
    const swPosXZ point = {x + world->origin.x, z + world->origin.z};
    if (!(fabs(point.x) <= 1e12 && fabs(point.z) <= 1e12))
    {
        return (swWaterBodyId){0};
    }
    swInputValue value;
    swFindInputValues(&world->inputs.arrays.set, SW_INPUT_BODY, -1, 1, &point, &value);
    return swWorld_GetNumberedWaterBody(world, swGetBodyNumber(value.value.x));
}

int swWorld_GetWaterBodyCount(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetWaterBodyCount() needs a world");
    return world->waterBodies.count;
}

swWaterBodyId swWorld_GetWaterBody(const swWorld* world, int index)
{
    SW_REQUIRE(world != NULL && index >= 0 && index < world->waterBodies.count, (swWaterBodyId){0}, swFindHost(world),
               "swWorld_GetWaterBody() was asked for body %d of a world that has %d", index,
               world != NULL ? world->waterBodies.count : 0);
    const swWaterBody* body = NULL;
    for (int slot = 0; index >= 0; ++slot)
    {
        body = swGetWaterBodyAt(&world->waterBodies, slot);
        index -= body != NULL ? 1 : 0;
    }
    return makeId(swGetWaterBodyId(&world->waterBodies, body));
}
