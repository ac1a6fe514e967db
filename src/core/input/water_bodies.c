// SPDX-License-Identifier: MIT
#include "core/input/water_bodies.h"

#include <math.h>
#include <string.h>

#include "core/input/polygon.h"

void swBeginWaterBodies(swWaterBodies* bodies, swInputs* inputs)
{
    *bodies = (swWaterBodies){.inputs = inputs};
}

static swWaterBody* getSlot(const swWaterBodies* bodies, size_t slot)
{
    return (swWaterBody*)bodies->slots.data + slot;
}

static const swHost* getHost(const swWaterBodies* bodies)
{
    return &bodies->inputs->memory->host;
}

static void freePoints(const swWaterBodies* bodies, swWaterBody* body)
{
    swFree(getHost(bodies), body->points, (size_t)body->def.pointCount * sizeof(swVec2));
    body->points = NULL;
}

// The inputs end by themselves.
void swEndWaterBodies(swWaterBodies* bodies)
{
    for (size_t i = 0; i < bodies->slots.count; ++i)
    {
        if (getSlot(bodies, i)->isUsed)
        {
            freePoints(bodies, getSlot(bodies, i));
        }
    }
    swFreeItems(getHost(bodies), &bodies->slots, sizeof(swWaterBody));
    swFreeItems(getHost(bodies), &bodies->shown, sizeof(swBodyFrame));
}

// ---- its inputs ----

typedef struct Part
{
    swInputField field;
    float value;
    bool isThere, isOwn; // waves of its own, not those of all systems
} Part;

static void listParts(const swWaterBodies* bodies, const swWaterBodyDef* def, int number, Part parts[SW_BODY_INPUTS])
{
    float level = (float)(def->position.y - bodies->inputs->seaLevel);
    const Part all[SW_BODY_INPUTS] = {
        {SW_INPUT_LEVEL, level, def->setsLevel, false}, {SW_INPUT_CLIP, 0.0f, def->leavesWater, false},
        {SW_INPUT_WAVES, 0.0f, def->isCalm, false},     {SW_INPUT_WAVES, 1.0f, !SW_IS_NULL(def->waves), true},
        {SW_INPUT_BODY, (float)number, true, false},
    };
    memcpy(parts, all, sizeof all);
}

static swInputDef describePart(const swWaterBodyDef* def, const Part* part, const swInputPoint* points)
{
    swInputDef input = swDefaultInputDef();
    memcpy(input.name, def->name, sizeof input.name);
    input.field = part->field;
    input.shape = SW_SHAPE_POLYGON;
    input.blend = part->field == SW_INPUT_WAVES ? SW_BLEND_ALPHA : SW_BLEND_REPLACE;
    input.order = def->order;
    input.isEnabled = def->isEnabled;
    input.value[0] = part->value;
    input.feather = part->field == SW_INPUT_WAVES ? def->wavesFeather : 0.0f;
    input.position = def->position;
    input.points = points;
    input.pointCount = def->pointCount;
    input.system = part->isOwn ? def->waves : (swWaveSystemId){0, 0};
    if (part->field == SW_INPUT_LEVEL)
    {
        memcpy(input.tide, def->tide, sizeof input.tide);
    }
    return input;
}

static void removeInputs(swWaterBodies* bodies, swId inputs[SW_BODY_INPUTS])
{
    for (int i = 0; i < SW_BODY_INPUTS; ++i)
    {
        swInput* input = swFindInput(bodies->inputs, inputs[i]);
        if (input != NULL)
        {
            swRemoveInput(bodies->inputs, input);
        }
        inputs[i] = (swId){0, 0};
    }
}

// All of them or none.
static swResult addInputs(swWaterBodies* bodies, const swWaterBodyDef* def, int number, const swInputPoint* points,
                          swId inputs[SW_BODY_INPUTS])
{
    Part parts[SW_BODY_INPUTS];
    listParts(bodies, def, number, parts);
    memset(inputs, 0, SW_BODY_INPUTS * sizeof *inputs);
    for (int i = 0; i < SW_BODY_INPUTS; ++i)
    {
        const swInputDef input = describePart(def, &parts[i], points);
        swResult result = parts[i].isThere ? swAddInput(bodies->inputs, &input, &inputs[i]) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            removeInputs(bodies, inputs);
            return result;
        }
        if (parts[i].isThere)
        {
            swFindInput(bodies->inputs, inputs[i])->flags = SW_INPUT_IS_OF_BODY;
        }
    }
    return SW_SUCCESS;
}

// ---- bodies ----

static void findBounds(swWaterBody* body)
{
    body->low = body->high = body->points[0];
    for (int i = 1; i < body->def.pointCount; ++i)
    {
        swVec2 p = body->points[i];
        body->low = (swVec2){fminf(body->low.x, p.x), fminf(body->low.y, p.y)};
        body->high = (swVec2){fmaxf(body->high.x, p.x), fmaxf(body->high.y, p.y)};
    }
}

// Gives a body in a slot what a def says; nothing has changed where that fails.
static swResult fillBody(swWaterBodies* bodies, swWaterBody* body, const swWaterBodyDef* def)
{
    const swHost* host = getHost(bodies);
    size_t count = (size_t)def->pointCount;
    swVec2* points = swAllocate(host, count * sizeof *points);
    swInputPoint* shore = swAllocateZero(host, count * sizeof *shore);
    swResult result =
        points != NULL && shore != NULL ? SW_SUCCESS : swFailMemory(bodies->inputs->memory, "a body of water");
    for (size_t i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        points[i] = def->points[i];
        shore[i] = (swInputPoint){.x = points[i].x, .z = points[i].y, .weight = 1.0f};
    }
    swId inputs[SW_BODY_INPUTS];
    int number = (int)(body - getSlot(bodies, 0));
    result = result == SW_SUCCESS ? addInputs(bodies, def, number, shore, inputs) : result;
    swFree(host, shore, count * sizeof *shore);
    if (result != SW_SUCCESS)
    {
        swFree(host, points, count * sizeof *points);
        return result;
    }
    removeInputs(bodies, body->inputs);
    freePoints(bodies, body);
    memcpy(body->inputs, inputs, sizeof body->inputs);
    body->def = *def;
    body->def.points = body->points = points;
    findBounds(body);
    return SW_SUCCESS;
}

// One more slot, which is free; NULL if there is no memory.
static swWaterBody* appendSlot(swWaterBodies* bodies)
{
    const swHost* host = getHost(bodies);
    bool isShown = bodies->shown.count > bodies->slots.count ||
                   swAppendItems(host, &bodies->shown, 1, sizeof(swBodyFrame)) != NULL;
    swWaterBody* slot = isShown ? swAppendItems(host, &bodies->slots, 1, sizeof(swWaterBody)) : NULL;
    if (slot != NULL)
    {
        *slot = (swWaterBody){.isUsed = false};
    }
    return slot;
}

// A slot that is free, the first; NULL if there is no memory.
static swWaterBody* takeSlot(swWaterBodies* bodies)
{
    for (size_t i = 0; i < bodies->slots.count; ++i)
    {
        if (!getSlot(bodies, i)->isUsed)
        {
            return getSlot(bodies, i);
        }
    }
    return appendSlot(bodies);
}

swResult swAddWaterBody(swWaterBodies* bodies, const swWaterBodyDef* def, swId* id)
{
    if (bodies->count == SW_MAX_WATER_BODIES)
    {
        return swFail(bodies->inputs->memory->uncounted, SW_ERROR_LIMIT,
                      "the world has %d bodies of water, which is the most", SW_MAX_WATER_BODIES);
    }
    swWaterBody* body = takeSlot(bodies);
    swResult result =
        body != NULL ? fillBody(bodies, body, def) : swFailMemory(bodies->inputs->memory, "a body of water");
    if (result != SW_SUCCESS)
    {
        return result;
    }
    body->isUsed = true;
    body->generation += 1;
    bodies->count += 1;
    *id = swGetWaterBodyId(bodies, body);
    return SW_SUCCESS;
}

swResult swChangeWaterBody(swWaterBodies* bodies, swWaterBody* body, const swWaterBodyDef* def)
{
    return fillBody(bodies, body, def);
}

void swRemoveWaterBody(swWaterBodies* bodies, swWaterBody* body)
{
    removeInputs(bodies, body->inputs);
    freePoints(bodies, body);
    body->isUsed = false;
    bodies->count -= 1;
}

void swSetWaterBodyLevel(swWaterBodies* bodies, swWaterBody* body, double level)
{
    body->def.position.y = level;
    swInput* input = swFindInput(bodies->inputs, body->inputs[0]);
    if (input != NULL)
    {
        input->def.value[0] = (float)(level - bodies->inputs->seaLevel);
        swTouchInput(bodies->inputs, input);
    }
}

swWaterBody* swFindWaterBody(const swWaterBodies* bodies, swId id)
{
    swWaterBody* body = swGetWaterBodyAt(bodies, id.index1 - 1);
    return body != NULL && body->generation == id.generation ? body : NULL;
}

swId swGetWaterBodyId(const swWaterBodies* bodies, const swWaterBody* body)
{
    return (swId){(int32_t)(body - getSlot(bodies, 0)) + 1, body->generation};
}

swWaterBody* swGetWaterBodyAt(const swWaterBodies* bodies, int slot)
{
    bool isThere = slot >= 0 && (size_t)slot < bodies->slots.count && getSlot(bodies, (size_t)slot)->isUsed;
    return isThere ? getSlot(bodies, (size_t)slot) : NULL;
}

// ---- saved bodies ----

swResult swRestoreFreeWaterBody(swWaterBodies* bodies, uint32_t generation)
{
    swWaterBody* body = appendSlot(bodies);
    if (body == NULL)
    {
        return swFailMemory(bodies->inputs->memory, "a body of water");
    }
    body->generation = generation;
    return SW_SUCCESS;
}

swResult swRestoreWaterBody(swWaterBodies* bodies, const swWaterBodyDef* def, uint32_t generation,
                            const swId inputs[SW_BODY_INPUTS])
{
    size_t size = (size_t)def->pointCount * sizeof(swVec2);
    swVec2* points = swAllocate(getHost(bodies), size);
    swWaterBody* body = points != NULL ? appendSlot(bodies) : NULL;
    if (body == NULL)
    {
        swFree(getHost(bodies), points, size);
        return swFailMemory(bodies->inputs->memory, "a body of water");
    }
    body->isUsed = true;
    body->generation = generation;
    body->points = memcpy(points, def->points, size);
    bodies->count += 1;
    swRewindWaterBody(bodies, body, def, inputs);
    findBounds(body);
    return SW_SUCCESS;
}

void swRewindWaterBody(swWaterBodies* bodies, swWaterBody* body, const swWaterBodyDef* def,
                       const swId inputs[SW_BODY_INPUTS])
{
    body->def = *def;
    body->def.points = body->points;
    memcpy(body->inputs, inputs, sizeof body->inputs);
    for (int i = 0; i < SW_BODY_INPUTS; ++i)
    {
        swInput* input = swFindInput(bodies->inputs, inputs[i]);
        if (input != NULL)
        {
            input->flags |= SW_INPUT_IS_OF_BODY;
        }
    }
}

void swForgetWaterBody(swWaterBodies* bodies, swWaterBody* body, uint32_t generation)
{
    if (body->isUsed)
    {
        freePoints(bodies, body);
        body->isUsed = false;
        bodies->count -= 1;
    }
    memset(body->inputs, 0, sizeof body->inputs);
    body->generation = generation;
}

// ---- a frame ----

void swStepWaterBodies(swWaterBodies* bodies, swFrame* frame)
{
    swBodyFrame* shown = bodies->shown.data;
    int count = 0;
    for (size_t i = 0; i < bodies->slots.count; ++i)
    {
        const swWaterBody* body = getSlot(bodies, i);
        const swWaterBodyDef* def = &body->def;
        if (body->isUsed && def->isEnabled)
        {
            float tide, none;
            swGetTide(SW_MAX_TIDE, def->tide, frame->time, &tide, &none);
            shown[count++] = (swBodyFrame){
                .number = (int)i,
                .look = def->look,
                .setsLevel = def->setsLevel,
                .level = (float)(def->position.y - bodies->inputs->seaLevel) + tide,
                .low = {def->position.x + (double)body->low.x, def->position.z + (double)body->low.y},
                .high = {def->position.x + (double)body->high.x, def->position.z + (double)body->high.y},
            };
        }
    }
    frame->bodyCount = count;
    frame->bodies = shown;
}
