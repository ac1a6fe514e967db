// SPDX-License-Identifier: MIT
#include "core/input/input_arrays.h"

#include <math.h>
#include <string.h>

#include "core/input/even_flow.h"

typedef struct Room
{
    void** place;
    size_t itemSize; // bytes an input
} Room;

#define ROOMS 10

static void listRooms(swInputArrays* arrays, Room rooms[ROOMS])
{
    const Room all[ROOMS] = {
        {(void**)&arrays->sources, sizeof *arrays->sources},
        {(void**)&arrays->records, sizeof *arrays->records},
        {(void**)&arrays->words, sizeof *arrays->words},
        {(void**)&arrays->functions, sizeof *arrays->functions},
        {(void**)&arrays->contexts, sizeof *arrays->contexts},
        {(void**)&arrays->least, sizeof *arrays->least},
        {(void**)&arrays->most, sizeof *arrays->most},
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

// Between which numbers the first number of a field lies, whatever lies over what; `below` is among them.
static void findRange(const swInputArrays* arrays, int field, float below, float* low, float* high)
{
    swInputRange range = arrays->set.ranges[field];
    *low = *high = below;
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputRecord* record = &arrays->records[i];
        float least = record->value.x + arrays->least[i], most = record->value.x + arrays->most[i];
        if (record->blend == SW_JOIN_ADD)
        {
            *low += fminf(0.0f, record->weight * least);
            *high += fmaxf(0.0f, record->weight * most);
            continue;
        }
        if (record->blend == SW_JOIN_MULTIPLY)
        {
            float factor = fmaxf(1.0f, fmaxf(fabsf(least), fabsf(most)));
            most = factor * fmaxf(fabsf(*low), fabsf(*high));
            least = -most;
        }
        *low = fminf(*low, least);
        *high = fmaxf(*high, most);
    }
}

// The length of a displacement, all of them added up.
static float findDisplacement(const swInputArrays* arrays)
{
    swInputRange range = arrays->set.ranges[SW_INPUT_DISPLACEMENT];
    float reach = 0.0f;
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputRecord* record = &arrays->records[i];
        float own = fmaxf(fabsf(arrays->least[i]), fabsf(arrays->most[i]));
        sw_vec4 v = record->value;
        float scale = record->blend == SW_JOIN_MULTIPLY ? reach : fmaxf(1.0f, record->weight);
        reach += scale * (1.75f * own + fabsf(v.x) + fabsf(v.y) + fabsf(v.z));
    }
    return reach;
}

void swFindSetReaches(swInputArrays* arrays)
{
    swInputSet* set = &arrays->set;
    float low, high;
    findRange(arrays, SW_INPUT_LEVEL, 0.0f, &set->lowestLevel, &set->highestLevel);
    findRange(arrays, SW_INPUT_WAVES, 1.0f, &low, &high);
    set->weightReach = fmaxf(fabsf(low), fabsf(high));
    set->displacementReach = findDisplacement(arrays);
    swFindSetFlow(set);
    set->ribbonSystems = 0;
    for (int i = 0; i < set->recordCount; ++i)
    {
        const swInputRecord* record = &arrays->records[i];
        if ((record->flags & SW_INPUT_ALONG_SPLINE) != 0)
        {
            set->ribbonSystems |= record->system == SW_ALL_SYSTEMS ? UINT32_MAX : 1u << record->system;
        }
    }
}
