// SPDX-License-Identifier: MIT
#include "core/input/water_bodies_save.h"

#include <math.h>

#include "core/base/host.h"
#include "core/input/inputs_save.h"

typedef struct Saved
{
    bool isUsed;
    uint32_t generation;
    swWaterBodyDef def;
    swId inputs[SW_BODY_INPUTS];
} Saved;

// An input that the host has destroyed is none.
static Saved getSaved(const swWaterBodies* bodies, const swWaterBody* body)
{
    Saved saved = {.isUsed = body->isUsed, .generation = body->generation, .def = body->def};
    for (int i = 0; i < SW_BODY_INPUTS && body->isUsed; ++i)
    {
        bool isThere = swFindInput(bodies->inputs, body->inputs[i]) != NULL;
        saved.inputs[i] = isThere ? body->inputs[i] : (swId){0, 0};
    }
    return saved;
}

// All but the points, which follow.
static void streamSaved(swStream* stream, Saved* saved)
{
    swStreamBool(stream, &saved->isUsed);
    swStreamU32(stream, &saved->generation);
    if (!saved->isUsed)
    {
        return;
    }
    swStreamDef(stream, &swWaterBodyFields, &saved->def);
    swStreamI32(stream, &saved->def.waves.index1);
    swStreamU32(stream, &saved->def.waves.generation);
    for (int i = 0; i < SW_BODY_INPUTS; ++i)
    {
        swStreamI32(stream, &saved->inputs[i].index1);
        swStreamU32(stream, &saved->inputs[i].generation);
    }
    swStreamRange(stream, &saved->def.pointCount, 3, SW_MAX_SHORE_POINTS);
}

static void streamPoint(swStream* stream, swVec2* point)
{
    swStreamF32(stream, &point->x);
    swStreamF32(stream, &point->y);
}

// The def has its points.
static bool isDefGood(const Saved* saved)
{
    const swHost silent = {0};
    swWaterBodyDef def = saved->def;
    return swTakeSavedPlace(&def.position) && swCheckWaterBodyDef(&silent, &def) == SW_SUCCESS;
}

// ---- reading into a new world ----

static bool hasInputs(const swWaterBodies* bodies, const Saved* saved)
{
    for (int i = 0; i < SW_BODY_INPUTS; ++i)
    {
        const swInput* input = swFindInput(bodies->inputs, saved->inputs[i]);
        bool isNone = saved->inputs[i].index1 == 0;
        if (!isNone && (input == NULL || (input->flags & SW_INPUT_IS_OF_BODY) != 0))
        {
            return false;
        }
    }
    return true;
}

static swResult readBody(swWaterBodies* bodies, swStream* stream, Saved* saved)
{
    const swHost* host = &bodies->inputs->memory->host;
    size_t count = (size_t)saved->def.pointCount;
    if (!swStreamHasLeft(stream, count, 8))
    {
        return SW_ERROR_FORMAT;
    }
    swVec2* points = swAllocate(host, count * sizeof *points);
    if (points == NULL)
    {
        return swFailMemory(bodies->inputs->memory, "the shore of a body of water");
    }
    for (size_t i = 0; i < count; ++i)
    {
        streamPoint(stream, &points[i]);
    }
    saved->def.points = points;
    bool isFine = !stream->isBroken && isDefGood(saved) && hasInputs(bodies, saved);
    swResult result =
        isFine ? swRestoreWaterBody(bodies, &saved->def, saved->generation, saved->inputs) : SW_ERROR_FORMAT;
    swFree(host, points, count * sizeof *points);
    return result;
}

static swResult readSlots(swWaterBodies* bodies, swStream* stream, int count)
{
    for (int slot = 0; slot < count; ++slot)
    {
        Saved saved = {.def = swDefaultWaterBodyDef()};
        streamSaved(stream, &saved);
        if (stream->isBroken)
        {
            return SW_ERROR_FORMAT;
        }
        swResult result =
            saved.isUsed ? readBody(bodies, stream, &saved) : swRestoreFreeWaterBody(bodies, saved.generation);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

swResult swStreamWaterBodies(swWaterBodies* bodies, swStream* stream)
{
    int count = (int)bodies->slots.count;
    swStreamRange(stream, &count, 0, SW_MAX_WATER_BODIES);
    if (swIsReading(stream))
    {
        bool isThere = swStreamHasLeft(stream, (size_t)count, 5); // of a free slot, which takes the least
        return isThere && !stream->isBroken ? readSlots(bodies, stream, count) : SW_ERROR_FORMAT;
    }
    for (int slot = 0; slot < count; ++slot)
    {
        const swWaterBody* body = (const swWaterBody*)bodies->slots.data + slot;
        Saved saved = getSaved(bodies, body);
        streamSaved(stream, &saved);
        for (int i = 0; body->isUsed && i < body->def.pointCount; ++i)
        {
            streamPoint(stream, &body->points[i]);
        }
    }
    return SW_SUCCESS;
}

// ---- going back ----

static bool hasShore(const swWaterBody* body, swStream* stream, int count)
{
    bool isSame = body != NULL && body->def.pointCount == count;
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        swVec2 point = {0.0f, 0.0f};
        streamPoint(stream, &point);
        isSame = isSame && point.x == body->points[i].x && point.y == body->points[i].y;
    }
    return isSame;
}

swResult swCheckWaterBodies(const swWaterBodies* bodies, swStream* stream)
{
    int count = 0;
    bool isSame = true;
    swStreamRange(stream, &count, 0, SW_MAX_WATER_BODIES);
    for (int slot = 0; slot < count && !stream->isBroken; ++slot)
    {
        Saved saved = {.def = swDefaultWaterBodyDef()};
        streamSaved(stream, &saved);
        if (!saved.isUsed || stream->isBroken)
        {
            continue;
        }
        const swWaterBody* body = swGetWaterBodyAt(bodies, slot);
        bool hasSameShore = hasShore(body, stream, saved.def.pointCount);
        isSame = isSame && hasSameShore && body->generation == saved.generation;
        saved.def.points = body != NULL ? body->points : NULL;
        stream->isBroken = stream->isBroken || (isSame && !isDefGood(&saved));
    }
    return stream->isBroken ? SW_ERROR_FORMAT : isSame ? SW_SUCCESS : SW_ERROR_UNSUPPORTED;
}

void swRewindWaterBodies(swWaterBodies* bodies, swStream* stream)
{
    int count = 0;
    swStreamRange(stream, &count, 0, SW_MAX_WATER_BODIES);
    for (int slot = 0; slot < (int)bodies->slots.count; ++slot)
    {
        swWaterBody* body = (swWaterBody*)bodies->slots.data + slot;
        Saved saved = {.def = swDefaultWaterBodyDef()};
        if (slot < count)
        {
            streamSaved(stream, &saved);
        }
        if (!saved.isUsed)
        {
            swForgetWaterBody(bodies, body, saved.generation);
            continue;
        }
        hasShore(body, stream, saved.def.pointCount); // skips it
        swRewindWaterBody(bodies, body, &saved.def, saved.inputs);
    }
}
