// SPDX-License-Identifier: MIT
#include "core/input/sample_inputs.h"

#include "core/input/input_record.h"
#include "shared/input_shapes.h"

// Records that are collected at once; where more lie over one another they are looked up one by one.
#define COLLECTED 32

// A point in cells; of a far one only what is everywhere counts.
typedef struct Place
{
    int32_t cellX, cellZ;
    float restX, restZ;
    bool isFar;
    swPosXZ point;
} Place;

static Place findPlace(swPosXZ point)
{
    Place place = {.point = point};
    bool fitsX = swFindCell(point.x, &place.cellX, &place.restX);
    bool fitsZ = swFindCell(point.z, &place.cellZ, &place.restZ);
    place.isFar = !fitsX || !fitsZ;
    return place;
}

static swInputSample sampleRecord(const swInputSet* set, uint32_t at, const Place* place)
{
    const swInputRecord* record = &set->records[at];
    return swSampleInput(set->words[at], *record, place->cellX, place->cellZ, place->restX, place->restZ, 0.0f);
}

static void joinRecord(const swInputSet* set, uint32_t at, int system, const Place* place, swInputValue* value)
{
    const swInputRecord* record = &set->records[at];
    bool isMeant =
        record->field != SW_FIELD_OF_WAVES || record->system == SW_ALL_SYSTEMS || (int)record->system == system;
    bool isHere = !place->isFar || (record->flags & SW_INPUT_IS_BOUNDLESS) != 0;
    if (isMeant && isHere)
    {
        *value = swBlendInput(*record, *value, sampleRecord(set, at, place));
    }
}

static void findValue(const swInputSet* set, int field, int system, const Place* place, swInputValue* value)
{
    const swCellBox box = {place->cellX, place->cellZ, place->cellX, place->cellZ};
    uint32_t records[COLLECTED];
    int count = swCollectInputs(set, field, &box, records, COLLECTED);
    for (int i = 0; i < count && i < COLLECTED; ++i)
    {
        joinRecord(set, records[i], system, place, value);
    }
    if (count <= COLLECTED)
    {
        return;
    }
    uint32_t next = swFindNextInput(set, field, &box, records[COLLECTED - 1] + 1);
    for (; next != SW_NO_RECORD; next = swFindNextInput(set, field, &box, next + 1))
    {
        joinRecord(set, next, system, place, value);
    }
}

void swFindInputValues(const swInputSet* set, int field, int system, int count, const swPosXZ* points,
                       swInputValue* values)
{
    bool isLocal = field == SW_INPUT_WAVES && system >= 0 && (set->localSystems >> system & 1) != 0;
    for (int i = 0; i < count; ++i)
    {
        values[i] = swGetFieldBelow((sw_uint)field);
        values[i].value.x = isLocal ? 0.0f : values[i].value.x;
        if (set->ranges[field].recordCount > 0)
        {
            Place place = findPlace(points[i]);
            findValue(set, field, system, &place, &values[i]);
        }
    }
}

static swCellBox coverBoth(const Place* a, const Place* b)
{
    return (swCellBox){.minX = a->cellX < b->cellX ? a->cellX : b->cellX,
                       .minZ = a->cellZ < b->cellZ ? a->cellZ : b->cellZ,
                       .maxX = a->cellX > b->cellX ? a->cellX : b->cellX,
                       .maxZ = a->cellZ > b->cellZ ? a->cellZ : b->cellZ};
}

void swFindWaterValues(const swInputSet* set, int field, int count, const swPosXZ* here, const swPosXZ* rest,
                       float* values)
{
    for (int i = 0; i < count; ++i)
    {
        swInputValue value = swGetFieldBelow((sw_uint)field);
        Place there = findPlace(here[i]), atRest = findPlace(rest[i]);
        swCellBox box = coverBoth(&there, &atRest);
        uint32_t next = swFindNextInput(set, field, &box, 0);
        for (; next != SW_NO_RECORD; next = swFindNextInput(set, field, &box, next + 1))
        {
            bool follows = (set->records[next].flags & SW_INPUT_FOLLOWS_WAVES) != 0;
            joinRecord(set, next, -1, follows ? &atRest : &there, &value);
        }
        values[i] = value.value.x;
    }
}

bool swIsNearInputs(const swInputSet* set, uint32_t mask, swPosXZ point, double reach)
{
    swCellBox box;
    float rest;
    bool fits = swFindCell(point.x - reach, &box.minX, &rest) && swFindCell(point.x + reach, &box.maxX, &rest) &&
                swFindCell(point.z - reach, &box.minZ, &rest) && swFindCell(point.z + reach, &box.maxZ, &rest);
    return !fits || swTouchesInputs(set, mask, &box);
}
