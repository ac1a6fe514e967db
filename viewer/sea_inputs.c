// SPDX-License-Identifier: MIT
// What the scene puts into the sea: inputs and bodies of water, whose values the panel may change.

#include <stdlib.h>
#include <string.h>

#include "sea.h"

static int CountInputs(const Sea* sea)
{
    return sea->scene != NULL ? sea->scene->inputCount : 0;
}

static int CountBodies(const Sea* sea)
{
    return sea->scene != NULL ? sea->scene->waterBodyCount : 0;
}

static bool MakeRoom(Sea* sea)
{
    size_t inputs = (size_t)CountInputs(sea), bodies = (size_t)CountBodies(sea);
    sea->inputs = inputs > 0 ? calloc(inputs, sizeof(SeaInput)) : NULL;
    sea->bodies = bodies > 0 ? calloc(bodies, sizeof(SeaBody)) : NULL;
    return (inputs == 0 || sea->inputs != NULL) && (bodies == 0 || sea->bodies != NULL);
}

swResult OpenInputs(Sea* sea)
{
    const swScene* scene = sea->scene;
    if (scene == NULL)
    {
        return SW_SUCCESS;
    }
    if (!MakeRoom(sea))
    {
        SayInSea(sea, "there is no memory for the scene's inputs");
        return SW_ERROR_NO_MEMORY;
    }
    for (int i = 0; i < scene->inputCount; i++)
    {
        SeaInput* input = &sea->inputs[i];
        input->def = input->filedDef = input->takenDef = scene->inputs[i].def;
        if (!TakeInputPoints(input, scene->inputs[i].pointCount, scene->inputs[i].points))
        {
            SayInSea(sea, "there is no memory for the points of the scene's inputs");
            return SW_ERROR_NO_MEMORY;
        }
    }
    for (int i = 0; i < scene->waterBodyCount; i++)
    {
        SeaBody* body = &sea->bodies[i];
        body->def = body->filedDef = body->takenDef = scene->waterBodies[i].def;
        if (!TakeShore(body, scene->waterBodies[i].pointCount, scene->waterBodies[i].points))
        {
            SayInSea(sea, "there is no memory for the shores of the scene's bodies of water");
            return SW_ERROR_NO_MEMORY;
        }
    }
    swWaveSystemId systems[SW_MAX_WAVE_SYSTEMS] = {0};
    for (int i = 0; i < scene->wavesCount; i++)
    {
        systems[i] = sea->waves[i].id;
    }
    swResult result = swCreateSceneInputs(sea->world, scene, systems, &sea->authored);
    for (int i = 0; i < sea->authored.inputCount; i++)
    {
        sea->inputs[i].id = sea->authored.inputs[i];
    }
    return result;
}

void CloseInputs(Sea* sea)
{
    swDestroySceneSea(&sea->authored);
    for (int i = 0; i < CountInputs(sea) && sea->inputs != NULL; i++)
    {
        free(sea->inputs[i].points);
    }
    for (int i = 0; i < CountBodies(sea) && sea->bodies != NULL; i++)
    {
        free(sea->bodies[i].points);
    }
    free(sea->inputs);
    free(sea->bodies);
    sea->inputs = NULL;
    sea->bodies = NULL;
}

// Defs of the panel count in the file's coordinates.
static swPos PlaceInWorld(const Sea* sea, swPos position)
{
    swPosXZ origin = swWorld_GetOrigin(sea->world);
    return (swPos){position.x - origin.x, position.y, position.z - origin.z};
}

// Waves that are there now; null, and false, of those that were removed.
static bool FindWaves(const Sea* sea, int waves, swWaveSystemId* system)
{
    bool isThere = waves < 0 || !sea->waves[waves].isRemoved;
    *system = waves >= 0 && isThere ? sea->waves[waves].id : (swWaveSystemId){0};
    return isThere;
}

// Of a nest the world has an input for each raster; what they share follows.
static void FollowNest(Sea* sea, const swSceneInput* input, int first, const swInputDef* def)
{
    for (int i = 0; i < input->nestCount - 1; i++)
    {
        swInputId id = sea->authored.nested[first + i];
        swInputDef other = swInput_Get(sea->world, id);
        other.isEnabled = def->isEnabled;
        other.weight = def->weight;
        other.gain = def->gain;
        other.position = def->position;
        memcpy(other.value, def->value, sizeof(other.value));
        swInput_Set(sea->world, id, &other);
    }
}

// Where an input of the panel is at a time, and what it says then, as the world has it.
static void FollowMotion(const Sea* sea, int index, double time, swInputDef* def)
{
    swSceneInput now = sea->scene->inputs[index];
    now.def = *def;
    if (!swSceneInput_GetPlace(&now, time, &def->position, &def->rotation))
    {
        def->position = now.def.position; // it has left the sea
    }
    swSceneInput_GetValue(&now, time, def->value);
    def->position = PlaceInWorld(sea, def->position);
}

void MoveInputs(Sea* sea, double time)
{
    for (int i = 0; i < CountInputs(sea); i++)
    {
        const swSceneInput* input = &sea->scene->inputs[i];
        swInputId id = sea->inputs[i].id;
        swInputDef def = sea->inputs[i].takenDef;
        if (!swInput_IsValid(sea->world, id) || !(swSceneInput_IsMoving(input) || swSceneInput_IsChanging(input)))
        {
            continue;
        }
        FollowMotion(sea, i, time, &def);
        swInput_Move(sea->world, id, def.position, def.rotation);
        swInput_SetValue(sea->world, id, def.value);
        sea->movesFloor = sea->movesFloor || (def.field == SW_INPUT_FLOOR && def.isEnabled);
    }
    for (int i = 0; i < CountBodies(sea); i++)
    {
        swSceneWaterBody now = sea->scene->waterBodies[i];
        now.def = sea->bodies[i].takenDef;
        if (now.tide.count > 0)
        {
            swWaterBody_SetLevel(sea->world, sea->authored.waterBodies[i], swSceneWaterBody_GetLevel(&now, time));
        }
    }
}

// What the world has, where it refused something else.
static void GiveBack(const Sea* sea, SeaInput* input)
{
    swInputDef now = swInput_Get(sea->world, input->id);
    input->def = input->takenDef;
    TakeInputPoints(input, now.pointCount, now.points);
}

static void ApplyInput(Sea* sea, int index, int firstNested)
{
    SeaInput* input = &sea->inputs[index];
    const swSceneInput* filed = &sea->scene->inputs[index];
    swInputId id = input->id;
    swInputDef def = input->def;
    input->hasChanged = false;
    if (!swInput_IsValid(sea->world, id))
    {
        return; // left out
    }
    bool hasWaves = FindWaves(sea, def.field == SW_INPUT_WAVES ? filed->waves : -1, &def.system);
    def.isEnabled = hasWaves && def.isEnabled && !input->isRemoved;
    FollowMotion(sea, index, swWorld_GetTime(sea->world), &def);
    if (filed->nest != NULL)
    {
        swInputDef now = swInput_Get(sea->world, id); // its raster, and a feather that suits the nest
        def.raster = now.raster;
        def.feather = now.feather;
        def.order = now.order;
    }
    if (swInput_Set(sea->world, id, &def) != SW_SUCCESS)
    {
        GiveBack(sea, input); // the log says why
        return;
    }
    sea->floorVersion += input->takenDef.field == SW_INPUT_FLOOR && def.field != SW_INPUT_FLOOR;
    input->takenDef = input->def;
    FollowNest(sea, filed, firstNested, &def);
    sea->floorVersion += def.field == SW_INPUT_FLOOR;
}

static void ApplyBody(Sea* sea, int index)
{
    SeaBody* body = &sea->bodies[index];
    swWaterBodyDef def = body->def;
    body->hasChanged = false;
    FindWaves(sea, sea->scene->waterBodies[index].waves, &def.waves);
    swSceneWaterBody now = sea->scene->waterBodies[index];
    now.def = def;
    def.position = PlaceInWorld(sea, def.position);
    def.position.y = swSceneWaterBody_GetLevel(&now, swWorld_GetTime(sea->world));
    if (swWaterBody_Set(sea->world, sea->authored.waterBodies[index], &def) != SW_SUCCESS)
    {
        swWaterBodyDef taken = swWaterBody_Get(sea->world, sea->authored.waterBodies[index]);
        body->def = body->takenDef;
        TakeShore(body, taken.pointCount, taken.points);
    }
    body->takenDef = body->def;
}

void ApplyInputs(Sea* sea)
{
    for (int i = 0, nested = 0; i < CountInputs(sea); i++)
    {
        if (sea->inputs[i].hasChanged)
        {
            ApplyInput(sea, i, nested);
        }
        nested += sea->scene->inputs[i].nestCount > 1 ? sea->scene->inputs[i].nestCount - 1 : 0;
    }
    for (int i = 0; i < CountBodies(sea); i++)
    {
        if (sea->bodies[i].hasChanged)
        {
            ApplyBody(sea, i);
        }
    }
}

// Inputs and bodies that have to do with waves that went or came back.
void FollowWaves(Sea* sea, int waves)
{
    for (int i = 0; i < CountInputs(sea); i++)
    {
        sea->inputs[i].hasChanged = sea->inputs[i].hasChanged || sea->scene->inputs[i].waves == waves;
    }
    for (int i = 0; i < CountBodies(sea); i++)
    {
        sea->bodies[i].hasChanged = sea->bodies[i].hasChanged || sea->scene->waterBodies[i].waves == waves;
    }
    ApplyInputs(sea);
}

void ResetInput(Sea* sea, int index)
{
    SeaInput* input = &sea->inputs[index];
    if (input->isAdded)
    {
        RemoveInput(sea, index);
        return;
    }
    input->def = input->filedDef;
    TakeInputPoints(input, input->filedDef.pointCount, input->filedDef.points);
    input->isRemoved = false;
    input->hasChanged = true;
}

void ResetInputs(Sea* sea)
{
    for (int i = CountInputs(sea) - 1; i >= 0; i--) // backwards: added ones leave the list
    {
        ResetInput(sea, i);
    }
    for (int i = 0; i < CountBodies(sea); i++)
    {
        SeaBody* body = &sea->bodies[i];
        body->def = body->filedDef;
        TakeShore(body, body->filedDef.pointCount, body->filedDef.points);
        body->hasChanged = true;
    }
}
