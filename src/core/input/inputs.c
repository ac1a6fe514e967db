// SPDX-License-Identifier: MIT
#include "core/input/inputs.h"

#include <math.h>
#include <string.h>

#include "core/input/hull.h"
#include "core/input/mesh.h"
#include "core/input/raster.h"
#include "core/input/spline.h"

void swBeginInputs(swInputs* inputs, swMemory* memory, const swIdPool* systemIds, double seaLevel)
{
    *inputs = (swInputs){.memory = memory, .systemIds = systemIds, .seaLevel = seaLevel};
    inputs->arrays.set.version = inputs->arrays.set.wordsVersion = 1;
    inputs->arrays.set.weightReach = 1.0f;
    inputs->changes.from = 1;
}

void swTouchInput(swInputs* inputs, swInput* input)
{
    input->isTouched = true;
    inputs->isChanged = true;
}

// ---- data ----

static void freeData(const swHost* host, swInputData* data)
{
    if (data != NULL)
    {
        swReleaseRaster(data->raster);
        swReleaseMesh(data->mesh);
        swReleaseSpline(data->spline);
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
    if (room == 0 && words == 0 && def->raster == NULL && def->hull == NULL && def->mesh == NULL && def->spline == NULL)
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
    data->mesh = def->mesh;
    swHoldMesh(data->mesh);
    data->spline = def->spline;
    swRetainSpline(data->spline);
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

static bool reserve(swInputs* inputs, int count)
{
    const swHost* host = &inputs->memory->host;
    if (count > inputs->orderCapacity)
    {
        int capacity = inputs->orderCapacity > 0 ? 2 * inputs->orderCapacity : 16;
        uint32_t* order = swAllocateZero(host, (size_t)capacity * sizeof *order);
        if (order == NULL)
        {
            return false;
        }
        size_t size = (size_t)inputs->orderCapacity * sizeof *order;
        if (size > 0)
        {
            memcpy(order, inputs->order, size);
        }
        swFree(host, inputs->order, size);
        inputs->order = order;
        inputs->orderCapacity = capacity;
    }
    return swReserveInputArrays(host, &inputs->arrays, count);
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
    swFreeInputArrays(host, &inputs->arrays);
    swFree(host, inputs->order, (size_t)inputs->orderCapacity * sizeof *inputs->order);
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
    swTouchInput(inputs, input);
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
    swTouchInput(inputs, input);
    return SW_SUCCESS;
}

void swRemoveInput(swInputs* inputs, swInput* input)
{
    removeFromOrder(inputs, (uint32_t)swGetInputId(inputs, input).index1 - 1);
    buryData(inputs, input->data);
    input->data = NULL;
    input->isUsed = false;
    swTouchInput(inputs, input);
}

// Words of the points that are there.
static void writeWords(swInputs* inputs, swInput* input, int count)
{
    swInputData* data = input->data;
    int next = 1 - data->shown;
    data->pointCount = input->def.pointCount = count;
    input->def.points = count > 0 ? data->points : NULL;
    data->wordCount[next] = swWriteInputWords(&input->def, count, data->points, data->words[next]);
    data->isNew = true;
    swTouchInput(inputs, input);
}

void swSetInputPoints(swInputs* inputs, swInput* input, int count, const swInputPoint* points)
{
    if (count > 0)
    {
        memmove(input->data->points, points, (size_t)count * sizeof *points);
    }
    if (input->data != NULL)
    {
        writeWords(inputs, input, count);
    }
}

// ---- saved inputs ----

swResult swRestoreFreeSlot(swInputs* inputs, int slot, uint32_t generation)
{
    bool isNew = (size_t)slot >= inputs->slots.count;
    swInput* input = isNew ? swAppendItems(&inputs->memory->host, &inputs->slots, 1, sizeof(swInput))
                           : getSlot(inputs, (size_t)slot);
    if (input == NULL)
    {
        return swFailMemory(inputs->memory, "an input");
    }
    *input = (swInput){.generation = generation, .isTouched = !isNew && input->isTouched};
    return SW_SUCCESS;
}

swResult swRestoreInput(swInputs* inputs, const swInputDef* def, int slot, uint32_t generation, uint64_t serial)
{
    swResult result = swRestoreFreeSlot(inputs, slot, generation);
    bool isFine = result == SW_SUCCESS && reserve(inputs, inputs->count + 1);
    swInputData* data = isFine ? makeData(&inputs->memory->host, def, &isFine) : NULL;
    if (!isFine)
    {
        return result != SW_SUCCESS ? result : swFailMemory(inputs->memory, "an input");
    }
    swInput* input = getSlot(inputs, (size_t)slot);
    input->isUsed = true;
    input->serial = serial;
    adoptDef(input, def, data);
    insertInOrder(inputs, (uint32_t)slot);
    swTouchInput(inputs, input);
    return SW_SUCCESS;
}

void swRewindInput(swInputs* inputs, swInput* input, const swInputDef* def, uint64_t serial)
{
    uint32_t slot = (uint32_t)swGetInputId(inputs, input).index1 - 1;
    removeFromOrder(inputs, slot);
    swInputDef rewound = *def;
    rewound.raster = input->def.raster;
    rewound.hull = input->def.hull;
    rewound.mesh = input->def.mesh;
    rewound.spline = input->def.spline;
    rewound.function = input->def.function;
    rewound.functionContext = input->def.functionContext;
    rewound.functionFingerprint = input->def.functionFingerprint;
    input->serial = serial;
    swInputData* data = input->data;
    if (data != NULL)
    {
        data->pointCount = def->pointCount;
    }
    adoptDef(input, &rewound, data);
    insertInOrder(inputs, slot);
    if (data != NULL)
    {
        writeWords(inputs, input, def->pointCount);
    }
    swTouchInput(inputs, input);
}

// ---- the set ----

static bool counts(const swInputs* inputs, const swInput* input)
{
    const swInputDef* def = &input->def;
    swId system = {def->system.index1, def->system.generation};
    return def->isEnabled && def->weight > 0.0f &&
           (def->field != SW_INPUT_WAVES || system.index1 == 0 || swIsIdValid(inputs->systemIds, system));
}

// Words that were made since the last step are shown from now on.
static void showWords(swInputs* inputs)
{
    swInput* slots = inputs->slots.data;
    for (size_t i = 0; i < inputs->slots.count; ++i)
    {
        swInputData* data = slots[i].data;
        if (data != NULL && data->isNew)
        {
            data->shown = 1 - data->shown;
            data->isNew = false;
        }
    }
}

static void addRecord(const swInputs* inputs, uint32_t slot, double time, swInputArrays* arrays)
{
    const swInput* input = getSlot(inputs, slot);
    const swInputDef* def = &input->def;
    int at = arrays->set.recordCount++;
    swInputRecord* record = &arrays->records[at];
    swMakeInputRecord(def, input->data, inputs->seaLevel, time, record, &arrays->boxes[at]);
    record->flags |= input->flags;
    int count = 0;
    arrays->words[at] = swGetInputWords(input->data, &count);
    record->wordCount = (sw_uint)count;
    arrays->sources[at] = slot;
    arrays->functions[at] = def->function;
    arrays->contexts[at] = def->functionContext;
    swFindInputRange(def, input->data, &arrays->least[at], &arrays->most[at]);
    swInputRange* range = &arrays->set.ranges[def->field];
    range->firstRecord = range->recordCount == 0 ? (uint32_t)at : range->firstRecord;
    range->recordCount += 1;
}

void swFillInputArrays(const swInputs* inputs, double time, uint32_t localSystems, swInputArrays* arrays)
{
    swInputSet* set = &arrays->set;
    memset(set->ranges, 0, sizeof set->ranges);
    set->recordCount = 0;
    for (int i = 0; i < inputs->count; ++i)
    {
        if (counts(inputs, swGetInputAt(inputs, i)))
        {
            addRecord(inputs, inputs->order[i], time, arrays);
        }
    }
    set->nodeCount = swBuildInputIndex(set, arrays->boxes, arrays->items, arrays->scratch, arrays->nodes);
    set->version += 1;
    set->wordsVersion += 1;
    set->time = time;
    set->localSystems = localSystems;
    swFindSetReaches(arrays);
}

// ---- the flow that is the same everywhere ----

typedef struct Sources
{
    const swInputs* inputs;
    const swInputArrays* arrays;
} Sources;

static const swInputDef* getRecordDef(const void* context, int record)
{
    const Sources* sources = context;
    return &getSlot(sources->inputs, sources->arrays->sources[record])->def;
}

void swFindEvenFlow(const swInputs* inputs, const swInputArrays* arrays, int64_t ticks, swEvenFlow* flow)
{
    const Sources sources = {inputs, arrays};
    *flow = inputs->evenFlow;
    swPlanEvenFlow(&arrays->set, getRecordDef, &sources, inputs->ticks, ticks, flow);
}

// ---- where it has changed ----

// Of too many, those of earlier versions are forgotten, and if that is not enough all.
static void noteChange(swInputChanges* changes, uint32_t version, const swInputRecord* record)
{
    if (record->field != SW_INPUT_FLOOR && record->field != SW_INPUT_LEVEL && record->field != SW_INPUT_FLOW)
    {
        return;
    }
    if (changes->count == SW_MAX_CHANGES)
    {
        int kept = 0;
        for (int i = 0; i < changes->count; ++i)
        {
            changes->changes[kept] = changes->changes[i];
            kept += changes->changes[i].version == version ? 1 : 0;
        }
        changes->from = kept < SW_MAX_CHANGES ? version - 1 : version;
        changes->count = kept < SW_MAX_CHANGES ? kept : 0;
    }
    swInputChange* change = &changes->changes[changes->count++];
    change->version = version;
    swFindInputArea(record, &change->low, &change->high);
}

// Records of inputs that were touched: as the last step made them, or as this one does.
static void noteTouched(swInputs* inputs, uint32_t version)
{
    for (int i = 0; i < inputs->arrays.set.recordCount; ++i)
    {
        if (getSlot(inputs, inputs->arrays.sources[i])->isTouched)
        {
            noteChange(&inputs->changes, version, &inputs->arrays.records[i]);
        }
    }
}

static void forgetTouches(swInputs* inputs)
{
    for (size_t i = 0; i < inputs->slots.count; ++i)
    {
        getSlot(inputs, i)->isTouched = false;
    }
}

// Records that change with time alone.
static void moveTime(swInputs* inputs, double time)
{
    swInputArrays* arrays = &inputs->arrays;
    bool hasChanged = false;
    for (int i = 0; i < arrays->set.recordCount; ++i)
    {
        const swInputDef* def = &getSlot(inputs, arrays->sources[i])->def;
        if (swDoesInputChange(def))
        {
            swSetInputTime(def, time, &arrays->records[i]);
            noteChange(&inputs->changes, arrays->set.version + 1, &arrays->records[i]);
            hasChanged = true;
        }
    }
    if (hasChanged)
    {
        arrays->set.version += 1;
        swFindSetReaches(arrays);
    }
    arrays->set.time = time;
}

// A set that is made anew is of another time, too.
static void noteTimes(swInputs* inputs, uint32_t version)
{
    for (int i = 0; i < inputs->arrays.set.recordCount; ++i)
    {
        if (swDoesInputChange(&getSlot(inputs, inputs->arrays.sources[i])->def))
        {
            noteChange(&inputs->changes, version, &inputs->arrays.records[i]);
        }
    }
}

void swStepInputs(swInputs* inputs, double time, int64_t ticks, uint32_t localSystems)
{
    if (inputs->isChanged || localSystems != inputs->arrays.set.localSystems)
    {
        uint32_t version = inputs->arrays.set.version + 1;
        noteTouched(inputs, version);
        showWords(inputs);
        swFillInputArrays(inputs, time, localSystems, &inputs->arrays);
        inputs->arrays.set.changes = &inputs->changes;
        noteTouched(inputs, version);
        noteTimes(inputs, version);
        forgetTouches(inputs);
        freeDead(inputs);
        inputs->isChanged = false;
    }
    else if (time != inputs->arrays.set.time)
    {
        moveTime(inputs, time);
    }
    swEvenFlow flow;
    swFindEvenFlow(inputs, &inputs->arrays, ticks, &flow);
    inputs->evenFlow = flow;
    inputs->ticks = ticks;
}
