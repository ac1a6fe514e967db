// SPDX-License-Identifier: MIT
// What is saved of an input is its def, its points, and the hashes of what it uses: a raster of a gigabyte stays where
// it is.

#include "core/input/inputs_save.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/input/hull.h"
#include "core/input/input_def.h"
#include "core/input/mesh.h"
#include "core/input/raster.h"
#include "core/input/spline.h"

typedef struct Saved
{
    bool isUsed;
    uint32_t generation;
    uint64_t serial;
    swInputDef def;                                // without pointers
    uint64_t raster, hull, mesh, spline, function; // hashes, 0: none
} Saved;

static Saved getSaved(const swInput* input)
{
    const swInputDef* def = &input->def;
    return (Saved){
        .isUsed = input->isUsed,
        .generation = input->generation,
        .serial = input->serial,
        .def = *def,
        .raster = input->isUsed && def->raster != NULL ? def->raster->hash : 0,
        .hull = input->isUsed && def->hull != NULL ? def->hull->hash : 0,
        .mesh = input->isUsed && def->mesh != NULL ? def->mesh->hash : 0,
        .spline = input->isUsed && def->spline != NULL ? def->spline->hash : 0,
        .function = def->functionFingerprint,
    };
}

static void streamSaved(swStream* stream, Saved* saved)
{
    swStreamBool(stream, &saved->isUsed);
    swStreamU32(stream, &saved->generation);
    if (!saved->isUsed)
    {
        return;
    }
    swStreamU64(stream, &saved->serial);
    swStreamDef(stream, &swInputFields, &saved->def);
    swStreamI32(stream, &saved->def.system.index1);
    swStreamU32(stream, &saved->def.system.generation);
    swStreamU64(stream, &saved->raster);
    swStreamU64(stream, &saved->hull);
    swStreamU64(stream, &saved->mesh);
    swStreamU64(stream, &saved->spline);
    swStreamU64(stream, &saved->function);
    swStreamRange(stream, &saved->def.pointCount, 0, SW_MAX_INPUT_POINTS);
}

// A host's places and its origin are within 1e9 m each.
bool swTakeSavedPlace(swPos* position)
{
    bool isFine = fabs(position->x) <= 2e9 && fabs(position->z) <= 2e9; // false for NaN
    position->x = position->z = 0.0;
    return isFine;
}

static swResult checkSavedDef(const swHost* host, const swInputDef* saved)
{
    swInputDef def = *saved;
    bool isFine = swTakeSavedPlace(&def.position) && swCheckInputDef(host, &def) == SW_SUCCESS;
    return isFine ? SW_SUCCESS : SW_ERROR_FORMAT;
}

static void streamPoint(swStream* stream, swInputPoint* point)
{
    swStreamF32(stream, &point->x);
    swStreamF32(stream, &point->z);
    swStreamF32(stream, &point->radius);
    swStreamF32(stream, &point->weight);
    swStreamFloats(stream, point->value, 4);
}

// The path of the flow that is the same everywhere has a past.
static void streamEvenFlow(swStream* stream, swEvenFlow* flow)
{
    swStreamI64(stream, &flow->begin);
    swStreamF64(stream, &flow->x);
    swStreamF64(stream, &flow->z);
    swStreamF32(stream, &flow->velocityX);
    swStreamF32(stream, &flow->velocityZ);
    swStreamRange(stream, &flow->swingCount, 0, SW_MAX_EVEN_SWINGS);
    for (int i = 0; i < flow->swingCount && !stream->isBroken; ++i)
    {
        swEvenSwing* swing = &flow->swings[i];
        swStreamF64(stream, &swing->speed);
        swStreamF32(stream, &swing->cosineX);
        swStreamF32(stream, &swing->cosineZ);
        swStreamF32(stream, &swing->sineX);
        swStreamF32(stream, &swing->sineZ);
    }
    stream->isBroken = stream->isBroken || !swIsEvenFlowGood(flow);
}

// ---- reading into a new world ----

static swResult refuseMissing(const swHost* host, const char* what, const Saved* saved, uint64_t hash, uint64_t given)
{
    const unsigned long long wanted = hash, other = given;
    return given == 0 ? swFail(host, SW_ERROR_UNSUPPORTED,
                               "the saved input '%s' uses a %s with the hash %016llx, which "
                               "swRestoreDef::findResource did not give",
                               saved->def.name, what, wanted)
                      : swFail(host, SW_ERROR_UNSUPPORTED,
                               "the saved input '%s' uses a %s with the hash %016llx, but swRestoreDef::findResource "
                               "gave another one, with the hash %016llx; give the one that it was saved with",
                               saved->def.name, what, wanted, other);
}

// Asks for what has a hash; 0 is nothing. What is given must have it.
static swResult findResource(const swHost* host, const swRestoreDef* find, const Saved* saved, swResourceKind kind,
                             uint64_t hash, swResource* resource)
{
    static const char* const words[] = {"raster", "hull", "mesh", "spline"};
    bool isGiven = hash == 0 || (find->findResource != NULL &&
                                 find->findResource(find->resourceContext, kind, hash, saved->def.name, resource));
    uint64_t given = 0;
    if (hash != 0 && isGiven)
    {
        given = kind == SW_RESOURCE_RASTER && resource->raster != NULL   ? resource->raster->hash
                : kind == SW_RESOURCE_HULL && resource->hull != NULL     ? resource->hull->hash
                : kind == SW_RESOURCE_MESH && resource->mesh != NULL     ? resource->mesh->hash
                : kind == SW_RESOURCE_SPLINE && resource->spline != NULL ? resource->spline->hash
                                                                         : 0;
    }
    return given == hash ? SW_SUCCESS : refuseMissing(host, words[kind], saved, hash, given);
}

static swResult findResources(const swHost* host, const swRestoreDef* find, Saved* saved)
{
    const uint64_t hashes[] = {[SW_RESOURCE_RASTER] = saved->raster,
                               [SW_RESOURCE_HULL] = saved->hull,
                               [SW_RESOURCE_MESH] = saved->mesh,
                               [SW_RESOURCE_SPLINE] = saved->spline};
    swResource found[4] = {{0}};
    for (int kind = SW_RESOURCE_RASTER; kind <= SW_RESOURCE_SPLINE; ++kind)
    {
        swResult result = findResource(host, find, saved, (swResourceKind)kind, hashes[kind], &found[kind]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    swInputDef* def = &saved->def;
    def->raster = saved->raster != 0 ? found[SW_RESOURCE_RASTER].raster : NULL;
    def->hull = saved->hull != 0 ? found[SW_RESOURCE_HULL].hull : NULL;
    def->mesh = saved->mesh != 0 ? found[SW_RESOURCE_MESH].mesh : NULL;
    def->spline = saved->spline != 0 ? found[SW_RESOURCE_SPLINE].spline : NULL;
    if (def->shape == SW_SHAPE_FUNCTION)
    {
        swResource resource = {0};
        bool isGiven =
            find->findResource != NULL &&
            find->findResource(find->resourceContext, SW_RESOURCE_FUNCTION, saved->function, def->name, &resource) &&
            resource.function != NULL;
        if (!isGiven)
        {
            return refuseMissing(host, "function", saved, saved->function, 0);
        }
        def->function = resource.function;
        def->functionContext = resource.functionContext;
    }
    def->functionFingerprint = saved->function;
    return SW_SUCCESS;
}

// The points of one input, read into memory that lasts until the input has them.
static swResult readInput(swInputs* inputs, swStream* stream, const swRestoreDef* find, Saved* saved, int slot)
{
    const swHost* host = &inputs->memory->host;
    size_t count = (size_t)saved->def.pointCount;
    swInputPoint* points = NULL;
    if (!swStreamHasLeft(stream, count, 32))
    {
        return SW_ERROR_FORMAT;
    }
    if (count > 0)
    {
        points = swAllocate(host, count * sizeof *points);
        if (points == NULL)
        {
            return swFailMemory(inputs->memory, "an input's points");
        }
    }
    for (size_t i = 0; i < count; ++i)
    {
        streamPoint(stream, &points[i]);
    }
    saved->def.points = points;
    swResult result = findResources(inputs->memory->uncounted, find, saved);
    if (result == SW_SUCCESS)
    {
        result = checkSavedDef(inputs->memory->uncounted, &saved->def);
    }
    result =
        result == SW_SUCCESS ? swRestoreInput(inputs, &saved->def, slot, saved->generation, saved->serial) : result;
    swFree(host, points, count * sizeof *points);
    return result;
}

static swResult readSlots(swInputs* inputs, swStream* stream, const swRestoreDef* find, int count)
{
    for (int slot = 0; slot < count && !stream->isBroken; ++slot)
    {
        Saved saved = {.def = swDefaultInputDef()};
        streamSaved(stream, &saved);
        swResult result = stream->isBroken || saved.serial > inputs->serials ? SW_ERROR_FORMAT : SW_SUCCESS;
        if (result == SW_SUCCESS && saved.isUsed)
        {
            result = readInput(inputs, stream, find, &saved, slot);
        }
        else if (result == SW_SUCCESS)
        {
            result = swRestoreFreeSlot(inputs, slot, saved.generation);
        }
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

swResult swStreamInputs(swInputs* inputs, swStream* stream, const swRestoreDef* find)
{
    int count = (int)inputs->slots.count;
    swStreamRange(stream, &count, 0, SW_MAX_INPUTS);
    swStreamU64(stream, &inputs->serials);
    swEvenFlow flow = swIsReading(stream) ? (swEvenFlow){0} : inputs->evenFlow;
    streamEvenFlow(stream, &flow);
    if (swIsReading(stream))
    {
        inputs->evenFlow = flow;
        bool isThere = swStreamHasLeft(stream, (size_t)count, 5); // of a free slot, which takes the least
        return isThere && !stream->isBroken ? readSlots(inputs, stream, find, count) : SW_ERROR_FORMAT;
    }
    for (int slot = 0; slot < count; ++slot)
    {
        const swInput* input = (const swInput*)inputs->slots.data + slot;
        Saved saved = getSaved(input);
        streamSaved(stream, &saved);
        for (int i = 0; input->isUsed && i < saved.def.pointCount; ++i)
        {
            streamPoint(stream, &input->data->points[i]);
        }
    }
    return SW_SUCCESS;
}

// ---- going back ----

// What cannot be read from bytes is what it was then.
static bool hasResources(const swInput* input, const Saved* saved)
{
    Saved now = getSaved(input);
    return input->isUsed && now.generation == saved->generation && now.raster == saved->raster &&
           now.hull == saved->hull && now.mesh == saved->mesh && now.spline == saved->spline &&
           now.function == saved->function && now.def.shape == saved->def.shape &&
           now.def.pointCapacity >= saved->def.pointCount;
}

swResult swCheckInputs(const swInputs* inputs, swStream* stream)
{
    int count = 0;
    uint64_t serials = 0;
    swStreamRange(stream, &count, 0, SW_MAX_INPUTS);
    swStreamU64(stream, &serials);
    swEvenFlow flow = {0};
    streamEvenFlow(stream, &flow);
    for (int slot = 0; slot < count && !stream->isBroken; ++slot)
    {
        Saved saved = {.def = swDefaultInputDef()};
        streamSaved(stream, &saved);
        bool isThere = (size_t)slot < inputs->slots.count;
        const swInput* input = isThere ? (const swInput*)inputs->slots.data + slot : NULL;
        if (saved.isUsed && !stream->isBroken && (!isThere || !hasResources(input, &saved)))
        {
            return SW_ERROR_UNSUPPORTED;
        }
        if (!saved.isUsed)
        {
            continue;
        }
        swInputPoint point;
        for (int i = 0; i < saved.def.pointCount && !stream->isBroken; ++i)
        {
            streamPoint(stream, &point);
        }
        const swHost silent = {0};
        saved.def.raster = input != NULL ? input->def.raster : NULL;
        saved.def.spline = input != NULL ? input->def.spline : NULL;
        saved.def.mesh = input != NULL ? input->def.mesh : NULL;
        saved.def.hull = input != NULL ? input->def.hull : NULL;
        saved.def.function = input != NULL ? input->def.function : NULL;
        bool isPlace = swTakeSavedPlace(&saved.def.position);
        bool isFine = isPlace && swCheckDef(&silent, &swInputFields, &saved.def) == SW_SUCCESS;
        stream->isBroken = stream->isBroken || !isFine;
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

void swRewindInputs(swInputs* inputs, swStream* stream)
{
    int count = 0;
    swStreamRange(stream, &count, 0, SW_MAX_INPUTS);
    swStreamU64(stream, &inputs->serials);
    swEvenFlow flow = {0};
    streamEvenFlow(stream, &flow);
    inputs->evenFlow = flow;
    for (int slot = 0; slot < (int)inputs->slots.count; ++slot)
    {
        swInput* input = (swInput*)inputs->slots.data + slot;
        Saved saved = {.def = swDefaultInputDef()};
        if (slot < count)
        {
            streamSaved(stream, &saved);
        }
        if (!saved.isUsed)
        {
            if (input->isUsed)
            {
                swRemoveInput(inputs, input);
            }
            input->generation = saved.generation;
            continue;
        }
        for (int i = 0; i < saved.def.pointCount; ++i)
        {
            streamPoint(stream, &input->data->points[i]);
        }
        swRewindInput(inputs, input, &saved.def, saved.serial);
    }
}

// ---- digest ----

static void hashInput(swHash* hash, const swInput* input)
{
    Saved saved = getSaved(input);
    swHashDef(hash, &swInputFields, &input->def);
    swAddHash(hash, input->def.field == SW_INPUT_WAVES ? (uint64_t)input->def.system.index1 : 0);
    swAddHash(hash, saved.raster);
    swAddHash(hash, saved.hull);
    swAddHash(hash, saved.mesh);
    swAddHash(hash, saved.spline);
    swAddHash(hash, saved.function);
    for (int k = 0; k < input->def.pointCount; ++k)
    {
        const swInputPoint* p = &input->data->points[k];
        const float numbers[8] = {p->x, p->z, p->radius, p->weight, p->value[0], p->value[1], p->value[2], p->value[3]};
        swAddHashFloats(hash, numbers, 8);
    }
}

static void hashEvenFlow(swHash* hash, const swEvenFlow* flow)
{
    if (swIsEvenFlowStill(flow))
    {
        return;
    }
    const float speeds[2] = {flow->velocityX, flow->velocityZ};
    swAddHash(hash, (uint64_t)flow->begin);
    swAddHashDouble(hash, flow->x);
    swAddHashDouble(hash, flow->z);
    swAddHashFloats(hash, speeds, 2);
    for (int i = 0; i < flow->swingCount; ++i)
    {
        const swEvenSwing* swing = &flow->swings[i];
        const float parts[4] = {swing->cosineX, swing->cosineZ, swing->sineX, swing->sineZ};
        swAddHashDouble(hash, swing->speed);
        swAddHashFloats(hash, parts, 4);
    }
}

void swHashInputs(swHash* hash, const swInputs* inputs)
{
    for (int i = 0; i < inputs->count; ++i)
    {
        hashInput(hash, swGetInputAt(inputs, i));
    }
    hashEvenFlow(hash, &inputs->evenFlow);
}

void swHashFieldInputs(swHash* hash, const swInputs* inputs, swInputField field)
{
    for (int i = 0; i < inputs->count; ++i)
    {
        const swInput* input = swGetInputAt(inputs, i);
        if (input->def.field == field)
        {
            hashInput(hash, input);
        }
    }
}
