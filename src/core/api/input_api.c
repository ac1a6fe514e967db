// SPDX-License-Identifier: MIT
#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/input/input_def.h"
#include "core/query/query_fields.h"
#include "core/world/world.h"

// ---- defs ----

// A def as the world keeps it: what its shape looks at, at its place in the sea.
static swInputDef placeInSea(const swWorld* world, const swInputDef* def)
{
    swInputDef placed = *def;
    swForgetUnused(&placed);
    placed.position.x += world->origin.x;
    placed.position.z += world->origin.z;
    placed.name[SW_MAX_INPUT_NAME - 1] = '\0';
    return placed;
}

// Waves are those of a system that is there.
static swResult checkSystem(const swWorld* world, const swInputDef* def)
{
    bool isForAll = SW_IS_NULL(def->system);
    if (def->field != SW_INPUT_WAVES || isForAll || swWaveSystem_IsValid(world, def->system))
    {
        return SW_SUCCESS;
    }
    return swFail(&world->host, SW_ERROR_INVALID,
                  "the input '%s' weighs the waves of system %d of generation %u, which is not there; set "
                  "swInputDef::system to one that swCreateWaveSystem() gave, or to null for all systems",
                  def->name, def->system.index1, def->system.generation);
}

static swResult checkDef(const swWorld* world, const swInputDef* def)
{
    swResult result = swCheckInputDef(&world->host, def);
    return result == SW_SUCCESS ? checkSystem(world, def) : result;
}

swResult swCreateInput(swWorld* world, const swInputDef* def, swInputId* idOut)
{
    if (idOut != NULL)
    {
        *idOut = (swInputId){0, 0};
    }
    SW_REQUIRE(world != NULL && idOut != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateInput() needs a world and a place for the handle");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateInput() needs a def made by swDefaultInputDef()");
    swResult result = checkDef(world, def);
    result = result == SW_SUCCESS && def->field == SW_INPUT_FLOW ? swCarryWaves(&world->waves) : result;
    swId id = {0, 0};
    if (result == SW_SUCCESS)
    {
        swInputDef placed = placeInSea(world, def);
        result = swMakeViewFields(world);
        result = result == SW_SUCCESS ? swAddInput(&world->inputs, &placed, &id) : result;
    }
    *idOut = (swInputId){id.index1, id.generation};
    return result;
}

// ---- handles ----

// NULL for a handle that is stale or null, which is told.
static swInput* findInput(const swWorld* world, swInputId id, const char* call)
{
    SW_REQUIRE(swInput_IsValid(world, id), NULL, swFindHost(world),
               "%s was given the input %d of generation %u, which is not there: destroyed, of another world, or null",
               call, id.index1, id.generation);
    return swFindInput(&world->inputs, (swId){id.index1, id.generation});
}

bool swInput_IsValid(const swWorld* world, swInputId id)
{
    return world != NULL && swFindInput(&world->inputs, (swId){id.index1, id.generation}) != NULL;
}

void swDestroyInput(swWorld* world, swInputId id)
{
    swInput* input = findInput(world, id, "swDestroyInput()");
    if (input != NULL)
    {
        swRemoveInput(&world->inputs, input);
    }
}

swResult swInput_Set(swWorld* world, swInputId id, const swInputDef* def)
{
    swInput* input = findInput(world, id, "swInput_Set()");
    if (input == NULL)
    {
        return SW_ERROR_INVALID;
    }
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swInput_Set() needs a def made by swDefaultInputDef()");
    swResult result = checkDef(world, def);
    result = result == SW_SUCCESS && def->field == SW_INPUT_FLOW ? swCarryWaves(&world->waves) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swInputDef placed = placeInSea(world, def);
    return swChangeInput(&world->inputs, input, &placed);
}

swInputDef swInput_Get(const swWorld* world, swInputId id)
{
    const swInput* input = findInput(world, id, "swInput_Get()");
    if (input == NULL)
    {
        return swDefaultInputDef();
    }
    swInputDef def = input->def;
    def.position.x -= world->origin.x;
    def.position.z -= world->origin.z;
    return def;
}

// ---- changes ----

void swInput_Move(swWorld* world, swInputId id, swPos position, swAngles rotation)
{
    swInput* input = findInput(world, id, "swInput_Move()");
    if (input == NULL)
    {
        return;
    }
    bool isPlace = fabs(position.x) <= 1e9 && fabs(position.y) <= 1e9 && fabs(position.z) <= 1e9;
    bool isTurn = fabsf(rotation.yaw) <= 1000.0f && fabsf(rotation.pitch) <= 1000.0f && fabsf(rotation.roll) <= 1000.0f;
    SW_REQUIRE_VOID(isPlace && isTurn, &world->host,
                    "swInput_Move() was given (%g, %g, %g) m, turned by (%g, %g, %g); a place is within 1e9 m and an "
                    "angle within 1000 radians of 0",
                    position.x, position.y, position.z, (double)rotation.yaw, (double)rotation.pitch,
                    (double)rotation.roll);
    input->def.position = (swPos){position.x + world->origin.x, position.y, position.z + world->origin.z};
    input->def.rotation = rotation;
    swTouchInput(&world->inputs, input);
}

void swInput_Enable(swWorld* world, swInputId id, bool isEnabled)
{
    swInput* input = findInput(world, id, "swInput_Enable()");
    if (input != NULL)
    {
        if (input->def.isEnabled != isEnabled)
        {
            input->def.isEnabled = isEnabled;
            swTouchInput(&world->inputs, input);
        }
    }
}

void swInput_SetValue(swWorld* world, swInputId id, const float value[4])
{
    swInput* input = findInput(world, id, "swInput_SetValue()");
    if (input == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(value != NULL, &world->host, "swInput_SetValue() needs four numbers");
    swInputDef def = input->def;
    memcpy(def.value, value, sizeof def.value);
    if (swCheckInputValues(&world->host, &def) == SW_SUCCESS)
    {
        memcpy(input->def.value, value, sizeof def.value);
        swTouchInput(&world->inputs, input);
    }
}

void swInput_SetWeight(swWorld* world, swInputId id, float weight)
{
    swInput* input = findInput(world, id, "swInput_SetWeight()");
    if (input == NULL)
    {
        return;
    }
    swInputDef def = input->def;
    def.weight = weight;
    if (swCheckInputValues(&world->host, &def) == SW_SUCCESS)
    {
        input->def.weight = weight;
        swTouchInput(&world->inputs, input);
    }
}

swResult swInput_SetPoints(swWorld* world, swInputId id, int count, const swInputPoint* points)
{
    swInput* input = findInput(world, id, "swInput_SetPoints()");
    if (input == NULL)
    {
        return SW_ERROR_INVALID;
    }
    SW_REQUIRE(count >= 0 && points != NULL, SW_ERROR_INVALID, &world->host,
               "swInput_SetPoints() needs points, and their number");
    if (count > input->def.pointCapacity)
    {
        return swFail(&world->host, SW_ERROR_INVALID,
                      "swInput_SetPoints() was given %d points for an input that was made for %d; see "
                      "swInputDef::pointCapacity",
                      count, input->def.pointCapacity);
    }
    swResult result = swCheckInputPoints(&world->host, &input->def, count, points);
    if (result == SW_SUCCESS)
    {
        swSetInputPoints(&world->inputs, input, count, points);
    }
    return result;
}

// ---- all of them ----

int swWorld_GetInputCount(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetInputCount() needs a world");
    return world->inputs.count;
}

swInputId swWorld_GetInput(const swWorld* world, int index)
{
    SW_REQUIRE(world != NULL && index >= 0 && index < world->inputs.count, (swInputId){0}, swFindHost(world),
               "swWorld_GetInput() was asked for input %d of a world that has %d", index,
               world != NULL ? world->inputs.count : 0);
    swId id = swGetInputId(&world->inputs, swGetInputAt(&world->inputs, index));
    return (swInputId){id.index1, id.generation};
}

// ---- queries ----

int swMoment_QueryFields(const swMoment* moment, int count, const swPosXZ* points, const swFieldSamples* samples)
{
    bool isFine = moment != NULL && samples != NULL && count >= 0 && (count == 0 || points != NULL);
    if (!isFine)
    {
        swTellMisuse(moment != NULL ? moment->host : NULL,
                     "swMoment_QueryFields() needs a moment, points and a place for their answers");
        SW_ASSERT(!"a query is refused; the host's log says why");
        swRefuseFields(count, samples);
        return count > 0 ? count : 0;
    }
    return swFindFields(moment->frame, *moment->origin, samples->system.index1 - 1, count, points, samples);
}
