// SPDX-License-Identifier: MIT
#include "core/input/input_arrays.h"

#include <math.h>
#include <string.h>

typedef struct Room
{
    void** place;
    size_t itemSize; // bytes an input
} Room;

#define ROOMS 9

static void listRooms(swInputArrays* arrays, Room rooms[ROOMS])
{
    const Room all[ROOMS] = {
        {(void**)&arrays->sources, sizeof *arrays->sources},
        {(void**)&arrays->records, sizeof *arrays->records},
        {(void**)&arrays->words, sizeof *arrays->words},
        {(void**)&arrays->functions, sizeof *arrays->functions},
        {(void**)&arrays->contexts, sizeof *arrays->contexts},
        {(void**)&arrays->reaches, sizeof *arrays->reaches},
        {(void**)&arrays->boxes, sizeof *arrays->boxes},
        {(void**)&arrays->items, 2 * sizeof *arrays->items},
        {(void**)&arrays->nodes, SW_INDEX_NODES(1) * sizeof *arrays->nodes},
    };
    memcpy(rooms, all, sizeof all);
}

static void showArrays(swInputArrays* arrays)
{
    arrays->scratch = arrays->items + arrays->capacity;
    arrays->set.records = arrays->records;
    arrays->set.nodes = arrays->nodes;
    arrays->set.words = arrays->words;
    arrays->set.functions = arrays->functions;
    arrays->set.contexts = arrays->contexts;
}

bool swReserveInputArrays(const swHost* host, swInputArrays* arrays, int count)
{
    if (count <= arrays->capacity)
    {
        return true;
    }
    int capacity = arrays->capacity > 0 ? arrays->capacity : 16;
    while (capacity < count)
    {
        capacity *= 2;
    }
    Room rooms[ROOMS];
    void* made[ROOMS] = {NULL};
    bool isFine = true;
    listRooms(arrays, rooms);
    for (int i = 0; i < ROOMS && isFine; ++i)
    {
        made[i] = swAllocateZero(host, (size_t)capacity * rooms[i].itemSize);
        isFine = made[i] != NULL;
    }
    for (int i = 0; i < ROOMS; ++i)
    {
        size_t size = (size_t)arrays->capacity * rooms[i].itemSize;
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
        arrays->capacity = capacity;
        showArrays(arrays);
    }
    return isFine;
}

void swFreeInputArrays(const swHost* host, swInputArrays* arrays)
{
    Room rooms[ROOMS];
    listRooms(arrays, rooms);
    for (int i = 0; i < ROOMS; ++i)
    {
        swFree(host, *rooms[i].place, (size_t)arrays->capacity * rooms[i].itemSize);
        *rooms[i].place = NULL;
    }
    arrays->capacity = 0;
}

// How far from 0 a field may be, wherever its records lie: added up they go on, mixed they do not.
static float findReach(const swInputArrays* arrays, int field, float below)
{
    const swInputRange* range = &arrays->set.ranges[field];
    float reach = below;
    for (uint32_t i = range->firstRecord; i < range->firstRecord + range->recordCount; ++i)
    {
        const swInputRecord* record = &arrays->records[i];
        float own = arrays->reaches[i];
        own += fmaxf(fmaxf(fabsf(record->value.x), fabsf(record->value.y)), fabsf(record->value.z));
        reach = record->blend == SW_JOIN_ADD        ? reach + record->weight * own
                : record->blend == SW_JOIN_MULTIPLY ? reach * fmaxf(1.0f, own)
                                                    : fmaxf(reach, own);
    }
    return reach;
}

void swFindSetReaches(swInputArrays* arrays)
{
    arrays->set.levelReach = findReach(arrays, SW_INPUT_LEVEL, 0.0f);
    arrays->set.weightReach = findReach(arrays, SW_INPUT_WAVES, 1.0f);
    arrays->set.displacementReach = findReach(arrays, SW_INPUT_DISPLACEMENT, 0.0f);
}
