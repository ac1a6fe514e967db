// SPDX-License-Identifier: MIT
// The inputs and bodies of water of a scene in a world, and those that move by themselves.

#include "core/base/host.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"
#include "scene/scene_source.h"

void swFreeSceneSeaInputs(swSceneSea* sea)
{
    swFree(&sea->host, sea->inputs, (size_t)sea->inputRoom * sizeof(swInputId));
    swFree(&sea->host, sea->nested, (size_t)sea->nestedRoom * sizeof(swInputId));
    swFree(&sea->host, sea->waterBodies, (size_t)sea->waterBodyRoom * sizeof(swWaterBodyId));
    swFree(&sea->host, sea->windSeas, (size_t)sea->windSeaRoom * sizeof(swWindSea));
    sea->inputs = sea->nested = NULL;
    sea->waterBodies = NULL;
    sea->windSeas = NULL;
    sea->inputCount = sea->inputRoom = sea->nestedCount = sea->nestedRoom = 0;
    sea->waterBodyCount = sea->waterBodyRoom = sea->windSeaCount = sea->windSeaRoom = 0;
}

// NULL for none; `isMissing` becomes true where there is no memory.
static void* makeRoom(const swScene* scene, int count, size_t size, bool* isMissing)
{
    void* room = count > 0 ? swAllocateZero(&scene->host, (size_t)count * size) : NULL;
    *isMissing = *isMissing || (count > 0 && room == NULL);
    return room;
}

static swResult makeRoomForInputs(const swScene* scene, swSceneSea* sea)
{
    bool isMissing = false;
    sea->host = scene->host;
    sea->inputRoom = scene->inputCount;
    sea->waterBodyRoom = scene->waterBodyCount;
    sea->windSeaRoom = scene->windSeaCount;
    for (int i = 0; i < scene->inputCount; ++i)
    {
        sea->nestedRoom += scene->inputs[i].nestCount > 1 ? scene->inputs[i].nestCount - 1 : 0;
    }
    sea->inputs = makeRoom(scene, sea->inputRoom, sizeof(swInputId), &isMissing);
    sea->nested = makeRoom(scene, sea->nestedRoom, sizeof(swInputId), &isMissing);
    sea->waterBodies = makeRoom(scene, sea->waterBodyRoom, sizeof(swWaterBodyId), &isMissing);
    sea->windSeas = makeRoom(scene, sea->windSeaRoom, sizeof(swWindSea), &isMissing);
    return isMissing
               ? swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for the inputs of the scene '%s'.", scene->name)
               : SW_SUCCESS;
}

static swResult createInput(swWorld* world, const swSceneInput* input, swSceneSea* sea, swInputId* id)
{
    swInputDef def = input->def;
    swSceneInput_GetPlace(input, swWorld_GetTime(world), &def.position, &def.rotation);
    swSceneInput_GetValue(input, swWorld_GetTime(world), def.value);
    def.system = input->waves >= 0 ? sea->systems[input->waves] : def.system;
    if (input->nest == NULL)
    {
        return swCreateInput(world, &def, id);
    }
    swInputId ids[SW_MAX_NEST];
    swResult result = swCreateNest(world, &def, input->nestCount, input->nest, ids);
    for (int i = 0; i < input->nestCount && result == SW_SUCCESS; ++i)
    {
        *(i == 0 ? id : &sea->nested[sea->nestedCount++]) = ids[i];
    }
    return result;
}

// All of them, so that each that is refused is told.
static swResult createInputs(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < scene->inputCount; ++i)
    {
        sea->inputCount = i + 1;
        int waves = scene->inputs[i].waves;
        if (scene->inputs[i].isLeftOut || (waves >= 0 && SW_IS_NULL(sea->systems[waves])))
        {
            continue;
        }
        swResult own = createInput(world, &scene->inputs[i], sea, &sea->inputs[i]);
        result = own != SW_SUCCESS ? swKeepFailure(result, swTellRefused(scene, own, scene->inputs[i].line, "input", i))
                                   : result;
    }
    return result;
}

static void removeInputs(swWorld* world, int count, const swInputId* ids)
{
    for (int i = 0; i < count; ++i)
    {
        if (swInput_IsValid(world, ids[i]))
        {
            swDestroyInput(world, ids[i]);
        }
    }
}

static void removeAll(swWorld* world, swSceneSea* sea)
{
    removeInputs(world, sea->inputCount, sea->inputs);
    removeInputs(world, sea->nestedCount, sea->nested);
    for (int i = 0; i < sea->waterBodyCount; ++i)
    {
        if (swWaterBody_IsValid(world, sea->waterBodies[i]))
        {
            swDestroyWaterBody(world, sea->waterBodies[i]);
        }
    }
    for (int i = 0; i < sea->windSeaCount; ++i)
    {
        swDestroyWindSea(world, &sea->windSeas[i]);
    }
}

swResult swAddSceneInputs(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    swResult result = makeRoomForInputs(scene, sea);
    sea->world = world;
    sea->scene = scene;
    sea->origin = swWorld_GetOrigin(world);
    if (result == SW_SUCCESS) // all three, so that each that is refused is told
    {
        result = swCreateSceneWindSeas(world, scene, sea);
        result = swKeepFailure(result, swCreateSceneBodies(world, scene, sea));
        result = swKeepFailure(result, createInputs(world, scene, sea));
    }
    if (result != SW_SUCCESS)
    {
        removeAll(world, sea);
    }
    return result;
}

// ---- through time ----

static swResult moveInput(const swSceneSea* sea, int index, double time)
{
    const swSceneInput* input = &sea->scene->inputs[index];
    swPosXZ origin = swWorld_GetOrigin(sea->world);
    swPos position;
    swAngles rotation;
    bool isThere = swSceneInput_GetPlace(input, time, &position, &rotation);
    position.x += sea->origin.x - origin.x;
    position.z += sea->origin.z - origin.z;
    if (!isThere)
    {
        return swFail(&sea->scene->host, SW_ERROR_INVALID,
                      "%s:%d: the motion of input %d has brought it beyond 1e9 m by %g s; give it a path that loops.",
                      sea->scene->source->name, input->line, index + 1, time);
    }
    swInput_Move(sea->world, sea->inputs[index], position, rotation);
    return SW_SUCCESS;
}

swResult swAdvanceSceneInputs(const swSceneSea* sea, double time)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < sea->inputCount; ++i)
    {
        const swSceneInput* input = &sea->scene->inputs[i];
        bool isThere = swInput_IsValid(sea->world, sea->inputs[i]);
        if (isThere && swSceneInput_IsMoving(input))
        {
            result = swKeepFailure(result, moveInput(sea, i, time));
        }
        if (isThere && swSceneInput_IsChanging(input))
        {
            float value[4];
            swSceneInput_GetValue(input, time, value);
            swInput_SetValue(sea->world, sea->inputs[i], value);
        }
    }
    for (int i = 0; i < sea->waterBodyCount; ++i)
    {
        const swSceneWaterBody* body = &sea->scene->waterBodies[i];
        if (body->tide.count > 0 && swWaterBody_IsValid(sea->world, sea->waterBodies[i]))
        {
            swWaterBody_SetLevel(sea->world, sea->waterBodies[i], swSceneWaterBody_GetLevel(body, time));
        }
    }
    return result;
}
