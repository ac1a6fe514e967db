// SPDX-License-Identifier: MIT
#include "core/input/inputs.h"

#include <math.h>
#include <string.h>

#include "core/input/hull.h"
#include "core/input/raster.h"

void swBeginInputs(swInputs* inputs, swMemory* memory, const swIdPool* systemIds, double seaLevel)
{
    *inputs = (swInputs){.memory = memory, .systemIds = systemIds, .seaLevel = seaLevel};
    inputs->set.version = inputs->set.wordsVersion = 1;
}

// ---- data ----

static void freeData(const swHost* host, swInputData* data)
{
    if (data != NULL)
    {
        swReleaseRaster(data->raster);
        swReleaseHull(data->hull);
        swFree(host, data, data->size);
    }
}

static size_t roundUp(size_t size)
{
    return (size + 63) & ~(size_t)63;
}

// One block: the head, points, both copies of the words. NULL with `isFine` where a def needs none.
static swInputData* makeData(const swHost* host, const swInputDef* def, bool* isFine)
{
    int room = def->pointCapacity > def->pointCount ? def->pointCapacity : def->pointCount;
    int words = swCountInputWords(def);
    *isFine = true;
    if (room == 0 && words == 0 && def->raster == NULL && def->hull == NULL)
    {
        return NULL;
    }
    size_t head = roundUp(sizeof(swInputData));
    size_t pointSize = roundUp((size_t)room * sizeof(swInputPoint));
    size_t wordSize = roundUp((size_t)words * sizeof(float));
    size_t size = head + pointSize + 2 * wordSize;
    swInputData* data = swAllocateZero(host, size);
    *isFine = data != NULL;
    if (data == NULL)
    {
        return NULL;
    }
    data->size = size;
    data->raster = def->raster;
    swRetainRaster(data->raster);
    data->hull = def->hull;
    swRetainHull(data->hull);
    data->pointCapacity = room;
    data->pointCount = def->pointCount;
    data->points = (swInputPoint*)(void*)((char*)data + head);
    data->words[0] = (float*)(void*)((char*)data + head + pointSize);
    data->words[1] = (float*)(void*)((char*)data + head + pointSize + wordSize);
    data->wordCapacity = words;
    if (def->pointCount > 0)
    {
        memcpy(data->points, def->points, (size_t)def->pointCount * sizeof(swInputPoint));
    }
    data->wordCount[0] = words > 0 ? swWriteInputWords(def, def->pointCount, data->points, data->words[0]) : 0;
    return data;
}

// A def's pointers are those of the data.
static void adoptDef(swInput* input, const swInputDef* def, swInputData* data)
{
    input->def = *def;
    input->data = data;
    input->def.points = data != NULL && data->pointCount > 0 ? data->points : NULL;
    input->def.pointCount = data != NULL ? data->pointCount : 0;
    input->def.pointCapacity = data != NULL ? data->pointCapacity : 0;
}

// What the last step's set points to lives until the next one.
static void buryData(swInputs* inputs, swInputData* data)
{
    if (data != NULL)
    {
        data->next = inputs->dead;
        inputs->dead = data;
    }
}

static void freeDead(swInputs* inputs)
{
    while (inputs->dead != NULL)
    {
        swInputData* data = inputs->dead;
        inputs->dead = data->next;
        freeData(&inputs->memory->host, data);
    }
}

// ---- room ----

typedef struct Room
{
    void** place;
    size_t itemSize; // bytes an input
} Room;

#define ROOMS 9

static void listRooms(swInputs* inputs, Room rooms[ROOMS])
{
    const Room all[ROOMS] = {
        {(void**)&inputs->order, sizeof *inputs->order},
        {(void**)&inputs->sources, sizeof *inputs->sources},
        {(void**)&inputs->records, sizeof *inputs->records},
        {(void**)&inputs->words, sizeof *inputs->words},
        {(void**)&inputs->functions, sizeof *inputs->functions},
        {(void**)&inputs->contexts, sizeof *inputs->contexts},
        {(void**)&inputs->boxes, sizeof *inputs->boxes},
        {(void**)&inputs->items, 2 * sizeof *inputs->items},
        {(void**)&inputs->nodes, SW_INDEX_NODES(1) * sizeof *inputs->nodes},
    };
    memcpy(rooms, all, sizeof all);
}

static void showArrays(swInputs* inputs)
{
    inputs->scratch = inputs->items + inputs->capacity;
    inputs->set.records = inputs->records;
    inputs->set.nodes = inputs->nodes;
    inputs->set.words = inputs->words;
    inputs->set.functions = inputs->functions;
    inputs->set.contexts = inputs->contexts;
}

static bool reserve(swInputs* inputs, int count)
{
    if (count <= inputs->capacity)
    {
        return true;
    }
    const swHost* host = &inputs->memory->host;
    int capacity = inputs->capacity > 0 ? 2 * inputs->capacity : 16;
    Room rooms[ROOMS];
    void* made[ROOMS] = {NULL};
    bool isFine = true;
    listRooms(inputs, rooms);
    for (int i = 0; i < ROOMS && isFine; ++i)
    {
        made[i] = swAllocateZero(host, (size_t)capacity * rooms[i].itemSize);
        isFine = made[i] != NULL;
    }
    for (int i = 0; i < ROOMS; ++i)
    {
        size_t size = (size_t)inputs->capacity * rooms[i].itemSize;
        if (!isFine)
        {
            swFree(host, made[i], (size_t)capacity * rooms[i].itemSize);
            continue;
        }
        if (size > 0)
        {
            memcpy(made[i], *rooms[i].place, size);
        }
        swFree(host, *rooms[i].place, size);
        *rooms[i].place = made[i];
    }
    if (isFine)
    {
        inputs->capacity = capacity;
        showArrays(inputs);
    }
    return isFine;
}

void swEndInputs(swInputs* inputs)
{
    const swHost* host = &inputs->memory->host;
    swInput* slots = inputs->slots.data;
    for (size_t i = 0; i < inputs->slots.count; ++i)
    {
        if (slots[i].isUsed)
        {
            freeData(host, slots[i].data);
        }
    }
    freeDead(inputs);
    Room rooms[ROOMS];
    listRooms(inputs, rooms);
    for (int i = 0; i < ROOMS; ++i)
    {
        swFree(host, *rooms[i].place, (size_t)inputs->capacity * rooms[i].itemSize);
    }
    swFreeItems(host, &inputs->slots, sizeof(swInput));
}

// ---- handles and order ----

static swInput* getSlot(const swInputs* inputs, size_t index)
{
    return (swInput*)inputs->slots.data + index;
}

swInput* swFindInput(const swInputs* inputs, swId id)
{
    if (id.index1 <= 0 || (size_t)id.index1 > inputs->slots.count)
    {
        return NULL;
    }
    swInput* input = getSlot(inputs, (size_t)id.index1 - 1);
    return input->isUsed && input->generation == id.generation ? input : NULL;
}

swId swGetInputId(const swInputs* inputs, const swInput* input)
{
    return (swId){(int32_t)(input - (swInput*)inputs->slots.data) + 1, input->generation};
}

swInput* swGetInputAt(const swInputs* inputs, int index)
{
    return getSlot(inputs, inputs->order[index]);
}

static bool joinsBefore(const swInput* a, const swInput* b)
{
    if (a->def.field != b->def.field)
    {
        return a->def.field < b->def.field;
    }
    return a->def.order != b->def.order ? a->def.order < b->def.order : a->serial < b->serial;
}

// The order has room for one more.
static void insertInOrder(swInputs* inputs, uint32_t slot)
{
    int at = inputs->count;
    while (at > 0 && joinsBefore(getSlot(inputs, slot), swGetInputAt(inputs, at - 1)))
    {
        inputs->order[at] = inputs->order[at - 1];
        at -= 1;
    }
    inputs->order[at] = slot;
    inputs->count += 1;
}

static void removeFromOrder(swInputs* inputs, uint32_t slot)
{
    int at = 0;
    while (inputs->order[at] != slot)
    {
        at += 1;
    }
    inputs->count -= 1;
    memmove(inputs->order + at, inputs->order + at + 1, (size_t)(inputs->count - at) * sizeof *inputs->order);
}

// A slot that is free, the first; NULL if there is no memory.
static swInput* takeSlot(swInputs* inputs)
{
    for (size_t i = (size_t)inputs->count < inputs->slots.count ? 0 : inputs->slots.count; i < inputs->slots.count; ++i)
    {
        if (!getSlot(inputs, i)->isUsed)
        {
            return getSlot(inputs, i);
        }
    }
    swInput* slot = swAppendItems(&inputs->memory->host, &inputs->slots, 1, sizeof(swInput));
    if (slot != NULL)
    {
        *slot = (swInput){.isUsed = false};
    }
    return slot;
}

// ---- changes ----

swResult swAddInput(swInputs* inputs, const swInputDef* def, swId* id)
{
    if (inputs->count == SW_MAX_INPUTS)
    {
        return swFail(inputs->memory->uncounted, SW_ERROR_LIMIT, "the world has %d inputs, which is the most",
                      SW_MAX_INPUTS);
    }
    bool isFine = reserve(inputs, inputs->count + 1);
    swInput* input = isFine ? takeSlot(inputs) : NULL;
    swInputData* data = input != NULL ? makeData(&inputs->memory->host, def, &isFine) : NULL;
    if (input == NULL || !isFine)
    {
        return swFailMemory(inputs->memory, "an input");
    }
    input->isUsed = true;
    input->generation += 1;
    input->serial = ++inputs->serials;
    input->flags = 0;
    adoptDef(input, def, data);
    *id = swGetInputId(inputs, input);
    insertInOrder(inputs, (uint32_t)id->index1 - 1);
    inputs->isChanged = true;
    return SW_SUCCESS;
}

swResult swChangeInput(swInputs* inputs, swInput* input, const swInputDef* def)
{
    bool isFine;
    swInputData* data = makeData(&inputs->memory->host, def, &isFine);
    if (!isFine)
    {
        return swFailMemory(inputs->memory, "an input");
    }
    uint32_t slot = (uint32_t)swGetInputId(inputs, input).index1 - 1;
    removeFromOrder(inputs, slot);
    buryData(inputs, input->data);
    adoptDef(input, def, data);
    insertInOrder(inputs, slot);
    inputs->isChanged = true;
    return SW_SUCCESS;
}

void swRemoveInput(swInputs* inputs, swInput* input)
{
    removeFromOrder(inputs, (uint32_t)swGetInputId(inputs, input).index1 - 1);
    buryData(inputs, input->data);
    input->data = NULL;
    input->isUsed = false;
    inputs->isChanged = true;
}

void swSetInputPoints(swInputs* inputs, swInput* input, int count, const swInputPoint* points)
{
    swInputData* data = input->data;
    if (count > 0)
    {
        memcpy(data->points, points, (size_t)count * sizeof *points);
    }
    data->pointCount = input->def.pointCount = count;
    int next = 1 - data->shown;
    data->wordCount[next] = swWriteInputWords(&input->def, count, data->points, data->words[next]);
    data->isNew = true;
    inputs->isChanged = true;
}

// ---- the set ----

static bool counts(const swInputs* inputs, const swInput* input)
{
    const swInputDef* def = &input->def;
    swId system = {def->system.index1, def->system.generation};
    return def->isEnabled && def->weight > 0.0f &&
           (def->field != SW_INPUT_WAVES || system.index1 == 0 || swIsIdValid(inputs->systemIds, system));
}

static const float* showWords(swInputData* data)
{
    if (data == NULL)
    {
        return NULL;
    }
    if (data->isNew)
    {
        data->shown = 1 - data->shown;
        data->isNew = false;
    }
    if (data->raster != NULL)
    {
        return data->raster->values;
    }
    return data->hull != NULL ? data->hull->words : data->words[data->shown];
}

static void addRecord(swInputs* inputs, uint32_t slot, int at, double time)
{
    swInput* input = getSlot(inputs, slot);
    const swInputDef* def = &input->def;
    inputs->sources[at] = slot;
    inputs->words[at] = showWords(input->data);
    inputs->functions[at] = def->function;
    inputs->contexts[at] = def->functionContext;
    swMakeInputRecord(def, input->data, inputs->seaLevel, time, &inputs->records[at], &inputs->boxes[at]);
    inputs->records[at].flags |= input->flags;
}

static void makeSet(swInputs* inputs, double time)
{
    swInputSet* set = &inputs->set;
    memset(set->ranges, 0, sizeof set->ranges);
    set->recordCount = 0;
    for (int i = 0; i < inputs->count; ++i)
    {
        const swInput* input = swGetInputAt(inputs, i);
        if (!counts(inputs, input))
        {
            continue;
        }
        addRecord(inputs, inputs->order[i], set->recordCount, time);
        swInputRange* range = &set->ranges[input->def.field];
        range->firstRecord = range->recordCount == 0 ? (uint32_t)set->recordCount : range->firstRecord;
        range->recordCount += 1;
        set->recordCount += 1;
    }
    set->nodeCount = swBuildInputIndex(set, inputs->boxes, inputs->items, inputs->scratch, inputs->nodes);
    set->version += 1;
    set->wordsVersion += 1;
}

// Records that change with time alone.
static void moveTime(swInputs* inputs, double time)
{
    bool hasChanged = false;
    for (int i = 0; i < inputs->set.recordCount; ++i)
    {
        const swInputDef* def = &getSlot(inputs, inputs->sources[i])->def;
        if (swDoesInputChange(def))
        {
            swSetInputTime(def, time, &inputs->records[i]);
            hasChanged = true;
        }
    }
    inputs->set.version += hasChanged ? 1 : 0;
}

// What a record may say of a field of one number. Shapes whose values are not known here may say anything.
static void findRange(const swInputDef* def, const swInputRecord* record, float* low, float* high)
{
    float value = record->value.x;
    *low = *high = value;
    if (def->shape == SW_SHAPE_RASTER)
    {
        float a = def->gain * def->raster->least, b = def->gain * def->raster->most;
        *low = a == a ? value + fminf(a, b) : value;
        *high = b == b ? value + fmaxf(a, b) : value;
    }
    else if (def->shape == SW_SHAPE_POLYLINE || def->shape == SW_SHAPE_PARTICLES)
    {
        for (int i = 0; i < def->pointCount; ++i)
        {
            *low = fminf(*low, value + def->points[i].value[0]);
            *high = fmaxf(*high, value + def->points[i].value[0]);
        }
    }
    else if (def->shape == SW_SHAPE_SPLINE || def->shape == SW_SHAPE_MESH || def->shape == SW_SHAPE_FUNCTION)
    {
        *low = -1e6f;
        *high = 1e6f;
    }
}

// Between which heights still water stands, whatever is above or below another.
static void findLevels(swInputs* inputs)
{
    float low = 0.0f, high = 0.0f;
    swInputRange range = inputs->set.ranges[SW_INPUT_LEVEL];
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputDef* def = &getSlot(inputs, inputs->sources[i])->def;
        float least, most;
        findRange(def, &inputs->records[i], &least, &most);
        if (def->blend == SW_BLEND_ADD)
        {
            low += fminf(0.0f, def->weight * least);
            high += fmaxf(0.0f, def->weight * most);
            continue;
        }
        if (def->blend == SW_BLEND_MULTIPLY)
        {
            float factor = fmaxf(1.0f, fmaxf(fabsf(least), fabsf(most)));
            float reach = factor * fmaxf(fabsf(low), fabsf(high));
            least = -reach;
            most = reach;
        }
        low = fminf(low, least);
        high = fmaxf(high, most);
    }
    inputs->set.lowestLevel = low;
    inputs->set.highestLevel = high;
}

void swStepInputs(swInputs* inputs, double time, uint32_t localSystems)
{
    if (inputs->isChanged)
    {
        makeSet(inputs, time);
        freeDead(inputs);
        inputs->isChanged = false;
    }
    else if (time != inputs->set.time)
    {
        moveTime(inputs, time);
    }
    findLevels(inputs);
    inputs->set.time = time;
    inputs->set.localSystems = localSystems;
}
