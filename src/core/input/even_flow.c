// SPDX-License-Identifier: MIT
#include "core/input/even_flow.h"

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"

static bool isEverywhere(const swInputRecord* record)
{
    return record->shape == SW_FORM_EVERYWHERE;
}

// Whether the path of what records that are everywhere say has a closed form.
static bool isClosed(const swInputSet* set)
{
    swInputRange range = set->ranges[SW_INPUT_FLOW];
    int tides = 0;
    bool isClosed = true;
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputRecord* record = &set->records[i];
        if (!isEverywhere(record))
        {
            continue;
        }
        bool changes = (record->flags & SW_INPUT_CHANGES) != 0;
        bool bounds = record->blend == SW_JOIN_MIN || record->blend == SW_JOIN_MAX;
        tides += changes ? 1 : 0;
        isClosed = isClosed && !(changes && record->blend == SW_JOIN_MULTIPLY) && !(bounds && tides > 0);
    }
    return isClosed && tides <= SW_EVEN_TIDES;
}

// What a record says wherever it is asked, to the bit.
static swInputSample sampleEverywhere(const swInputRecord* record)
{
    swInputSample sample = swBeginInputSample(*record);
    sample.share = sample.share * record->weight;
    return sample;
}

void swFindSetFlow(swInputSet* set)
{
    swInputRange range = set->ranges[SW_INPUT_FLOW];
    bool hasEven = isClosed(set);
    swInputValue value = swGetFieldBelow(SW_FIELD_OF_FLOW);
    set->hasEvenFlow = hasEven;
    set->hasOtherFlows = false;
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputRecord* record = &set->records[i];
        if (hasEven && isEverywhere(record))
        {
            value = swBlendInput(*record, value, sampleEverywhere(record));
        }
        else
        {
            set->hasOtherFlows = true;
        }
    }
    bool isNumber = fabsf(value.value.x) <= 1e6f && fabsf(value.value.y) <= 1e6f; // a damaged moment may say anything
    set->evenX = isNumber ? value.value.x : 0.0f;
    set->evenZ = isNumber ? value.value.y : 0.0f;
}

// ---- the closed form ----

// Velocity and swings alone, of one axis multiplied by x, of the other by z.
static void scaleFlow(swEvenFlow* flow, float x, float z)
{
    flow->velocityX *= x;
    flow->velocityZ *= z;
    for (int i = 0; i < flow->swingCount; ++i)
    {
        swEvenSwing* swing = &flow->swings[i];
        swing->cosineX *= x;
        swing->sineX *= x;
        swing->cosineZ *= z;
        swing->sineZ *= z;
    }
}

static void addConstituent(const swTideConstituent* tide, float share, swEvenFlow* flow)
{
    double x = (double)(share * tide->amplitude), z = (double)(share * tide->amplitudeAcross);
    swEvenSwing swing = {
        .speed = (double)tide->speed,
        .cosineX = (float)(x * swCos((double)tide->phase)),
        .sineX = (float)(x * swSin((double)tide->phase)),
        .cosineZ = (float)(z * swCos((double)tide->phaseAcross)),
        .sineZ = (float)(z * swSin((double)tide->phaseAcross)),
    };
    if (x == 0.0 && z == 0.0)
    {
        return;
    }
    if (tide->speed == 0.0f)
    {
        flow->velocityX += swing.cosineX;
        flow->velocityZ += swing.cosineZ;
        return;
    }
    flow->swings[flow->swingCount++] = swing;
}

static void joinFlow(const swInputRecord* record, const swInputDef* def, swEvenFlow* flow)
{
    float share = record->weight;
    float x = def->value[0], z = def->value[1];
    if (record->blend == SW_JOIN_MULTIPLY || record->blend == SW_JOIN_MIN || record->blend == SW_JOIN_MAX)
    {
        // Nothing of it changes with time, or it is multiplied by a number that does not.
        swInputValue below = swGetFieldBelow(SW_FIELD_OF_FLOW);
        bool multiplies = record->blend == SW_JOIN_MULTIPLY;
        below.value.x = multiplies ? 1.0f : flow->velocityX;
        below.value.y = multiplies ? 1.0f : flow->velocityZ;
        swInputValue joined = swBlendInput(*record, below, sampleEverywhere(record));
        if (multiplies)
        {
            scaleFlow(flow, joined.value.x, joined.value.y);
            return;
        }
        flow->velocityX = joined.value.x;
        flow->velocityZ = joined.value.y;
        return;
    }
    bool replaces =
        share > 0.0f && (record->blend == SW_JOIN_REPLACE || (record->blend == SW_JOIN_ALPHA && share >= 1.0f));
    float kept = record->blend == SW_JOIN_ALPHA ? 1.0f - share : 1.0f;
    float part = replaces ? 1.0f : share;
    if (replaces)
    {
        *flow = (swEvenFlow){0};
    }
    scaleFlow(flow, kept, kept);
    flow->velocityX += part * x;
    flow->velocityZ += part * z;
    for (int i = 0; i < SW_MAX_TIDE; ++i)
    {
        addConstituent(&def->tide[i], part, flow);
    }
}

static bool isSameFlow(const swEvenFlow* a, const swEvenFlow* b)
{
    bool isSame = a->velocityX == b->velocityX && a->velocityZ == b->velocityZ && a->swingCount == b->swingCount;
    for (int i = 0; i < a->swingCount && isSame; ++i)
    {
        const swEvenSwing *one = &a->swings[i], *other = &b->swings[i];
        isSame = one->speed == other->speed && one->cosineX == other->cosineX && one->cosineZ == other->cosineZ &&
                 one->sineX == other->sineX && one->sineZ == other->sineZ;
    }
    return isSame;
}

void swPlanEvenFlow(const swInputSet* set, swGetRecordDef* getDef, const void* context, int64_t changed, int64_t ticks,
                    swEvenFlow* flow)
{
    swInputRange range = set->ranges[SW_INPUT_FLOW];
    swEvenFlow next = {0};
    uint32_t end = isClosed(set) ? range.firstRecord + range.recordCount : range.firstRecord;
    for (uint32_t i = range.firstRecord; i < end; ++i)
    {
        if (isEverywhere(&set->records[i]))
        {
            joinFlow(&set->records[i], getDef(context, (int)i), &next);
        }
    }
    if (!isSameFlow(flow, &next))
    {
        swPosXZ path = swIntegrateEvenFlow(flow, changed);
        next.begin = changed;
        next.x = path.x;
        next.z = path.z;
        *flow = next;
    }
    flow->path = swIntegrateEvenFlow(flow, ticks);
    flow->ticks = ticks;
}

bool swIsEvenFlowGood(const swEvenFlow* flow)
{
    bool isFine = fabs(flow->x) < 1e14 && fabs(flow->z) < 1e14 && fabsf(flow->velocityX) < 1e6f &&
                  fabsf(flow->velocityZ) < 1e6f && fabs(flow->path.x) < 1e20 && fabs(flow->path.z) < 1e20 &&
                  flow->swingCount >= 0 && flow->swingCount <= SW_MAX_EVEN_SWINGS && flow->begin <= SW_LARGEST_TICKS &&
                  flow->begin >= -SW_LARGEST_TICKS;
    for (int i = 0; isFine && i < flow->swingCount; ++i)
    {
        const swEvenSwing* swing = &flow->swings[i];
        isFine = swing->speed > 0.0 && swing->speed <= 1.0 && fabsf(swing->cosineX) < 1e6f &&
                 fabsf(swing->cosineZ) < 1e6f && fabsf(swing->sineX) < 1e6f && fabsf(swing->sineZ) < 1e6f;
    }
    static const swEvenSwing none;
    for (int i = isFine ? flow->swingCount : SW_MAX_EVEN_SWINGS; i < SW_MAX_EVEN_SWINGS; ++i)
    {
        isFine = isFine && memcmp(&flow->swings[i], &none, sizeof none) == 0;
    }
    return isFine;
}
