// SPDX-License-Identifier: MIT
#include "core/input/sample_inputs.h"

#include <math.h>

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

static void findPlace(swPosXZ point, Place* place)
{
    place->point = point;
    bool fitsX = swFindCell(point.x, &place->cellX, &place->restX);
    bool fitsZ = swFindCell(point.z, &place->cellZ, &place->restZ);
    place->isFar = !fitsX || !fitsZ;
}

// Numbers and derivatives within what any input may say; no flow or wind faster than one may be.
static bool isAnswerFine(const swInputRecord* record, const swInputAnswer* answer)
{
    bool isSpeed = record->field == SW_INPUT_FLOW || record->field == SW_INPUT_WIND;
    float most = isSpeed ? SW_MAX_INPUT_SPEED : 1e6f;
    float factor = isSpeed ? fabsf(record->gain) : 1.0f;
    bool isFine = answer->share > 0.0f && answer->share <= 1.0f && fabsf(answer->shareAlongX) <= 1e9f &&
                  fabsf(answer->shareAlongZ) <= 1e9f;
    for (int i = 0; i < 4; ++i)
    {
        isFine = isFine && factor * fabsf(answer->value[i]) <= most && fabsf(answer->valueAlongX[i]) <= 1e9f &&
                 fabsf(answer->valueAlongZ[i]) <= 1e9f;
    }
    return isFine;
}

// What a function of the host's says. An answer out of range covers nothing.
static swInputSample askFunction(const swInputSet* set, uint32_t at, const Place* place)
{
    const swInputRecord* record = &set->records[at];
    const double cell = (double)SW_QUERY_CELL;
    double dx = place->point.x - ((double)record->cellX * cell + (double)record->restX);
    double dz = place->point.z - ((double)record->cellZ * cell + (double)record->restZ);
    double c = (double)record->cosine, s = (double)record->sine;
    const swPosXZ own = {c * dx + s * dz, c * dz - s * dx};
    swInputAnswer answer = {.share = 0.0f};
    set->functions[at](set->contexts[at], set->time, 1, &own, &answer);
    swInputSample sample = swBeginInputSample(*record);
    const float* v = answer.value;
    const float *x = answer.valueAlongX, *z = answer.valueAlongZ;
    float g = record->gain;
    sample.value = (sw_vec4){record->value.x + g * v[0], record->value.y + g * v[1], record->value.z + g * v[2],
                             record->value.w + g * v[3]};
    sample.valueX = (sw_vec4){g * x[0], g * x[1], g * x[2], g * x[3]};
    sample.valueZ = (sw_vec4){g * z[0], g * z[1], g * z[2], g * z[3]};
    sample.share = answer.share;
    sample.shareX = answer.shareAlongX;
    sample.shareZ = answer.shareAlongZ;
    sample.share = isAnswerFine(record, &answer) ? sample.share : 0.0f;
    if (sample.share > 0.0f)
    {
        sample = swCoverRectangle(sample, (float)own.x, (float)own.z, record->halfX, record->halfZ, record->feather);
    }
    return swFinishInputSample(*record, sample);
}

static swInputSample sampleRecord(const swInputSet* set, uint32_t at, const Place* place)
{
    const swInputRecord* record = &set->records[at];
    if (record->shape == SW_FORM_FUNCTION)
    {
        return askFunction(set, at, place);
    }
    return swSampleInput(set->words[at], *record, place->cellX, place->cellZ, place->restX, place->restZ, 0.0f);
}

// Whether a record says something about a system's waves, of another field about anything, at a place.
static bool isMeant(const swInputRecord* record, int system, const Place* place)
{
    bool isHere = !place->isFar || (record->flags & SW_INPUT_IS_BOUNDLESS) != 0;
    return isHere && swHasSay(*record, (sw_uint)system);
}

// Joins the record at `at` to what is below it.
typedef void JoinRecord(const swInputSet* set, uint32_t at, int system, const Place* place, void* below);

static void joinValue(const swInputSet* set, uint32_t at, int system, const Place* place, void* below)
{
    swInputValue* value = below;
    *value = swJoinInput(set->records[at], (sw_uint)system, *value, sampleRecord(set, at, place));
}

static void joinLooks(const swInputSet* set, uint32_t at, int system, const Place* place, void* below)
{
    swWaveLooks* looks = below;
    const float* words = set->words[at];
    const swInputRecord* record = &set->records[at];
    swLookSay say = swSampleLook(words, *record, place->cellX, place->cellZ, place->restX, place->restZ);
    *looks = swJoinLooks(words, *record, (sw_uint)system, *looks, say);
}

static void joinAll(const swInputSet* set, int field, int system, const Place* place, JoinRecord* join, void* below)
{
    const swCellBox box = {place->cellX, place->cellZ, place->cellX, place->cellZ};
    uint32_t records[COLLECTED];
    int count = swCollectInputs(set, field, &box, records, COLLECTED);
    for (int i = 0; i < count && i < COLLECTED; ++i)
    {
        if (isMeant(&set->records[records[i]], system, place))
        {
            join(set, records[i], system, place, below);
        }
    }
    if (count <= COLLECTED)
    {
        return;
    }
    uint32_t next = swFindNextInput(set, field, &box, records[COLLECTED - 1] + 1);
    for (; next != SW_NO_RECORD; next = swFindNextInput(set, field, &box, next + 1))
    {
        if (isMeant(&set->records[next], system, place))
        {
            join(set, next, system, place, below);
        }
    }
}

static swInputValue beginValue(const swInputSet* set, int field, int system)
{
    bool isLocal = field == SW_INPUT_WAVES && system >= 0 && (set->localSystems >> system & 1) != 0;
    swInputValue value = swGetFieldBelow((sw_uint)field);
    value.value.x = isLocal ? 0.0f : value.value.x;
    return value;
}

void swJoinInputValues(const swInputSet* set, int field, int system, int count, const swPosXZ* points,
                       swInputValue* values)
{
    for (int i = 0; i < count && set->ranges[field].recordCount > 0; ++i)
    {
        Place place;
        findPlace(points[i], &place);
        joinAll(set, field, system, &place, joinValue, &values[i]);
    }
}

void swFindInputValues(const swInputSet* set, int field, int system, int count, const swPosXZ* points,
                       swInputValue* values)
{
    for (int i = 0; i < count; ++i)
    {
        values[i] = beginValue(set, field, system);
    }
    swJoinInputValues(set, field, system, count, points, values);
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
        Place there, atRest;
        findPlace(here[i], &there);
        findPlace(rest[i], &atRest);
        swCellBox box = coverBoth(&there, &atRest);
        uint32_t next = swFindNextInput(set, field, &box, 0);
        for (; next != SW_NO_RECORD; next = swFindNextInput(set, field, &box, next + 1))
        {
            bool follows = (set->records[next].flags & SW_INPUT_FOLLOWS_WAVES) != 0;
            const Place* place = follows ? &atRest : &there;
            if (isMeant(&set->records[next], -1, place))
            {
                joinValue(set, next, -1, place, &value);
            }
        }
        values[i] = value.value.x;
    }
}

void swFindWaveLooks(const swInputSet* set, int system, int count, const swPosXZ* points, swWaveLooks* looks)
{
    for (int i = 0; i < count; ++i)
    {
        looks[i] = (swWaveLooks){beginValue(set, SW_INPUT_WAVES, system), swBeginLooks()};
        Place place;
        findPlace(points[i], &place);
        joinAll(set, SW_INPUT_WAVES, system, &place, joinLooks, &looks[i]);
    }
}

// ---- displacement ----

typedef struct Displaced
{
    swDisplaceRange range;
    swInputValue waves;
    swInputChannel height, level;
} Displaced;

static void joinWaves(const swInputSet* set, uint32_t at, int system, const Place* place, void* below)
{
    Displaced* displaced = below;
    (void)system;
    if (swIsDisplacing(set->records[at], displaced->range, true))
    {
        displaced->waves =
            swDisplaceAtRest(set->records[at], displaced->range, displaced->waves, sampleRecord(set, at, place));
    }
}

static void joinHeight(const swInputSet* set, uint32_t at, int system, const Place* place, void* below)
{
    Displaced* displaced = below;
    (void)system;
    if (swIsDisplacing(set->records[at], displaced->range, false))
    {
        displaced->height =
            swDisplaceHeight(set->records[at], displaced->height, displaced->level, sampleRecord(set, at, place));
    }
}

void swDisplaceAt(const swInputSet* set, swDisplaceRange range, swPosXZ rest, swInputValue* waves)
{
    Displaced displaced = {.range = range, .waves = *waves};
    Place place;
    findPlace(rest, &place);
    joinAll(set, SW_INPUT_DISPLACEMENT, -1, &place, joinWaves, &displaced);
    *waves = displaced.waves;
}

void swDisplaceHeightAt(const swInputSet* set, swDisplaceRange range, swPosXZ point, swInputChannel* height)
{
    swInputValue level;
    swFindInputValues(set, SW_INPUT_LEVEL, -1, 1, &point, &level);
    Displaced displaced = {.range = range, .height = *height, .level = {level.value.x, level.alongX.x, level.alongZ.x}};
    Place place;
    findPlace(point, &place);
    joinAll(set, SW_INPUT_DISPLACEMENT, -1, &place, joinHeight, &displaced);
    *height = displaced.height;
}

bool swFindCellBox(swPosXZ point, double reach, swCellBox* box)
{
    float rest;
    return swFindCell(point.x - reach, &box->minX, &rest) && swFindCell(point.x + reach, &box->maxX, &rest) &&
           swFindCell(point.z - reach, &box->minZ, &rest) && swFindCell(point.z + reach, &box->maxZ, &rest);
}
