// SPDX-License-Identifier: MIT
// The records of a measured sea: kept, put in order and found. Where they come from: ndbc_sea.c, summary_sea.c, and the
// other formats by way of measured_def.c.

#include "core/records/measured.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/misuse.h"

swResult swCreateMeasuredSea(const swHost* host, const char* name, swMeasuredSea** result)
{
    SW_REQUIRE_PLACE(host, result, "swCreateMeasuredSea()");
    swMeasuredSea* sea = swAllocateZero(host, sizeof(*sea));
    if (sea == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a measured sea.");
    }
    sea->host = *host;
    name = name != NULL ? name : "measured sea";
    size_t length = strlen(name);
    length = length < sizeof(sea->name) ? length : sizeof(sea->name) - 1;
    memcpy(sea->name, name, length);
    *result = sea;
    return SW_SUCCESS;
}

void swDestroyMeasuredSea(swMeasuredSea* sea)
{
    if (sea == NULL)
    {
        return;
    }
    swHost host = sea->host;
    swSeaRecord* records = sea->records.data;
    for (size_t i = 0; i < sea->records.count; ++i)
    {
        swFree(&host, records[i].floats, records[i].floatsSize);
    }
    swFreeItems(&host, &sea->records, sizeof(swSeaRecord));
    swFreeItems(&host, &sea->locations, sizeof(swMeasuredLocation));
    swFreeSeaPlaces(sea);
    swFree(&host, sea, sizeof(*sea));
}

// ---- filling ----

swResult swMeasuredSea_AddLocation(swMeasuredSea* sea, const char* name, double longitude, double latitude,
                                   int* location)
{
    SW_REQUIRE(sea != NULL, SW_ERROR_INVALID, NULL, "swMeasuredSea_AddLocation() needs a sea");
    swMeasuredLocation* added = swAppendItems(&sea->host, &sea->locations, 1, sizeof(*added));
    if (added == NULL)
    {
        return swFail(&sea->host, SW_ERROR_NO_MEMORY, "No memory for the places of %s.", sea->name);
    }
    memset(added, 0, sizeof(*added));
    size_t length = name != NULL ? strlen(name) : 0;
    length = length < sizeof(added->name) ? length : sizeof(added->name) - 1;
    if (length > 0)
    {
        memcpy(added->name, name, length);
    }
    added->longitude = longitude;
    added->latitude = latitude;
    if (!swIndexSeaPlace(sea, (int)sea->locations.count - 1))
    {
        --sea->locations.count;
        return swFail(&sea->host, SW_ERROR_NO_MEMORY, "No memory for the places of %s.", sea->name);
    }
    if (location != NULL)
    {
        *location = (int)sea->locations.count - 1;
    }
    return SW_SUCCESS;
}

swResult swAddSeaRecord(swMeasuredSea* sea, int frequencyCount, int directionCount, swSeaRecord** result)
{
    *result = NULL;
    size_t floatCount = (size_t)frequencyCount * ((size_t)SW_SEA_TABLE + (size_t)directionCount);
    if (sea->floatCount + floatCount > SW_SEA_MAX_FLOATS)
    {
        sea->isFull = true;
        return swFail(&sea->host, SW_ERROR_FORMAT, "%s: more than %zu values, the most that is read; cut it in time.",
                      sea->name, SW_SEA_MAX_FLOATS);
    }
    float* floats = swAllocateZero(&sea->host, floatCount * sizeof(float));
    swSeaRecord* record = floats != NULL ? swAppendItems(&sea->host, &sea->records, 1, sizeof(*record)) : NULL;
    if (record == NULL)
    {
        swFree(&sea->host, floats, floatCount * sizeof(float));
        return swFail(&sea->host, SW_ERROR_NO_MEMORY, "No memory for %s: record %zu needs %zu bytes.", sea->name,
                      sea->records.count + 1, floatCount * sizeof(float));
    }
    memset(record, 0, sizeof(*record));
    record->order = (int)sea->records.count - 1;
    record->frequencyCount = frequencyCount;
    record->directionCount = directionCount;
    record->floatsSize = floatCount * sizeof(float);
    record->floats = floats;
    sea->floatCount += floatCount;
    *result = record;
    return SW_SUCCESS;
}

// A gap matters where its neighbours have more than this part of the largest density on average.
#define GAP_PART 0.01

void swCloseSeaGaps(swSeaRecord* record)
{
    float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    int count = record->frequencyCount;
    float largest = 0.0f, below = 0.0f;
    for (int i = 0; i < count; ++i)
    {
        largest = energy[i] > largest ? energy[i] : largest; // false for NaN
    }
    for (int i = 0; i < count; ++i)
    {
        if (energy[i] == energy[i])
        {
            below = energy[i];
            continue;
        }
        int above = i + 1;
        while (above < count && energy[above] != energy[above])
        {
            ++above;
        }
        float mean = 0.5f * (below + (above < count ? energy[above] : 0.0f));
        record->missingCount += mean > (float)GAP_PART * largest ? above - i : 0;
        for (; i < above; ++i)
        {
            energy[i] = 0.0f;
        }
        --i;
    }
}

int swCountSeaGaps(const double* row, int count, double largest)
{
    int gaps = 0;
    for (int i = 0; i < count; ++i)
    {
        double sides[2] = {0.0, 0.0};
        for (int side = 0; side < 2 && row[i] != row[i]; ++side)
        {
            int at = i;
            for (int step = 1; step < count && row[at] != row[at]; ++step)
            {
                at = (i + (side == 0 ? step : count - step)) % count;
            }
            sides[side] = row[at] == row[at] ? row[at] : 0.0;
        }
        gaps += 0.5 * (sides[0] + sides[1]) > GAP_PART * largest ? 1 : 0;
    }
    return gaps;
}

void swSumSeaRecord(swSeaRecord* record)
{
    const float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    const float* bandwidths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    record->variance = 0.0;
    for (int i = 0; i < record->frequencyCount; ++i)
    {
        record->variance += (double)energy[i] * (double)bandwidths[i];
    }
}

double swFindLeastDensity(const double* densities, size_t count)
{
    double largest = 0.0;
    for (size_t i = 0; i < count; ++i)
    {
        largest = densities[i] > largest ? densities[i] : largest; // false for NaN
    }
    return -largest;
}

void swClipSeaRow(swSeaRecord* record, double least, double cell, int count, double* row)
{
    double kept = 0.0, taken = 0.0;
    for (int i = 0; i < count; ++i)
    {
        taken -= row[i] < 0.0 && row[i] >= least ? row[i] : 0.0;
        row[i] = row[i] > 0.0 ? row[i] : 0.0; // 0 for NaN
        kept += row[i];
    }
    if (!(taken > 0.0))
    {
        return;
    }
    double scale = kept > taken ? (kept - taken) / kept : 0.0;
    for (int i = 0; i < count; ++i)
    {
        row[i] *= scale;
    }
    record->negativeVariance += cell * taken;
    record->addedVariance += taken > kept ? cell * (taken - kept) : 0.0;
}

// ---- order ----

static int compareRecords(const void* a, const void* b)
{
    const swSeaRecord* first = a;
    const swSeaRecord* second = b;
    if (first->location != second->location)
    {
        return first->location < second->location ? -1 : 1;
    }
    if (first->seconds != second->seconds)
    {
        return first->seconds < second->seconds ? -1 : 1;
    }
    return (first->order > second->order) - (first->order < second->order);
}

static bool isSameMoment(const swSeaRecord* a, const swSeaRecord* b)
{
    return a->location == b->location && a->hasTime && b->hasTime && a->seconds == b->seconds;
}

static void dropSeconds(swMeasuredSea* sea)
{
    swSeaRecord* records = sea->records.data;
    size_t kept = 0;
    for (size_t i = 0; i < sea->records.count; ++i)
    {
        if (kept > 0 && isSameMoment(&records[kept - 1], &records[i]))
        {
            char time[20];
            swPrintMinutes((int64_t)floor(records[i].seconds / 60.0), time);
            swLog(&sea->host, SW_LOG_WARNING, "%s: a second record of %s at place %d is ignored.", sea->name, time,
                  records[i].location + 1);
            swFree(&sea->host, records[i].floats, records[i].floatsSize);
            continue;
        }
        records[kept++] = records[i];
    }
    sea->records.count = kept;
}

static float getPart(double part, double whole)
{
    return (float)(whole > 0.0 ? part / whole : part > 0.0 ? 1.0 : 0.0);
}

static void warnOfNegatives(const swMeasuredSea* sea)
{
    const swSeaRecord* records = sea->records.data;
    float negative = 0.0f, added = 0.0f;
    size_t count = 0;
    for (size_t i = 0; i < sea->records.count; ++i)
    {
        if (records[i].negativeCount > 0)
        {
            float part = getPart(records[i].negativeVariance, records[i].variance);
            float more = getPart(records[i].addedVariance, records[i].variance);
            negative = part > negative ? part : negative;
            added = more > added ? more : added;
            ++count;
        }
    }
    if (count > 0)
    {
        char gained[128] = "";
        if (added > 0.0f)
        {
            snprintf(gained, sizeof(gained), " Where one cannot, a record has up to %.2g %% more than the file.",
                     100.0 * (double)added);
        }
        swLog(&sea->host, SW_LOG_WARNING,
              "%s: %zu of %zu records hold negative densities, at most %.2g %% of a record's variance. They count as "
              "none, "
              "and each frequency is scaled to keep its energy.%s",
              sea->name, count, sea->records.count, 100.0 * (double)negative, gained);
    }
}

static void warnOfGaps(const swMeasuredSea* sea)
{
    const swSeaRecord* records = sea->records.data;
    size_t count = 0;
    int most = 0;
    for (size_t i = 0; i < sea->records.count; ++i)
    {
        count += records[i].missingCount > 0 ? 1 : 0;
        most = records[i].missingCount > most ? records[i].missingCount : most;
    }
    if (count > 0)
    {
        swLog(&sea->host, SW_LOG_WARNING,
              "%s: in %zu of %zu records densities are missing between others that have energy, up to %d in one. They "
              "count as none: such a record is lower than the sea was.",
              sea->name, count, sea->records.count, most);
    }
}

swResult swMeasuredSea_Finish(swMeasuredSea* sea)
{
    SW_REQUIRE(sea != NULL, SW_ERROR_INVALID, NULL, "swMeasuredSea_Finish() needs a sea");
    if (sea->records.count == 0)
    {
        return swFail(&sea->host, SW_ERROR_FORMAT, "%s holds no spectrum that could be used.", sea->name);
    }
    if (sea->locations.count == 0)
    {
        swResult result = swMeasuredSea_AddLocation(sea, NULL, (double)NAN, (double)NAN, NULL);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    qsort(sea->records.data, sea->records.count, sizeof(swSeaRecord), compareRecords);
    dropSeconds(sea);
    warnOfNegatives(sea);
    warnOfGaps(sea);
    const swSeaRecord* records = sea->records.data;
    swMeasuredLocation* locations = sea->locations.data;
    for (size_t i = sea->records.count; i > 0; --i)
    {
        swMeasuredLocation* location = &locations[records[i - 1].location];
        location->firstRecord = (int)i - 1;
        ++location->recordCount;
    }
    return SW_SUCCESS;
}

// ---- records ----

int swMeasuredSea_GetCount(const swMeasuredSea* sea)
{
    SW_REQUIRE(sea != NULL, 0, NULL, "swMeasuredSea_GetCount() needs a sea");
    return (int)sea->records.count;
}

swMeasuredRecord swMeasuredSea_GetRecord(const swMeasuredSea* sea, int index)
{
    swMeasuredRecord result;
    memset(&result, 0, sizeof(result));
    SW_REQUIRE(sea != NULL, result, NULL, "swMeasuredSea_GetRecord() needs a sea");
    if (index < 0 || index >= (int)sea->records.count)
    {
        return result;
    }
    const swSeaRecord* record = (const swSeaRecord*)sea->records.data + index;
    if (record->hasTime)
    {
        swPrintMinutes((int64_t)floor(record->seconds / 60.0), result.time);
        result.seconds = record->seconds;
    }
    result.location = record->location;
    result.table.frequencyCount = record->frequencyCount;
    result.table.directionCount = record->directionCount;
    result.table.firstDirection = record->firstDirection;
    result.table.frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    result.table.bandwidths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    result.table.density = swGetSeaRow(record, SW_SEA_TABLE);
    result.energy = swGetSeaRow(record, SW_SEA_ENERGY);
    result.correctedCount = record->correctedCount;
    result.partitionCount = record->partitionCount;
    result.averagePeriod = record->averagePeriod;
    result.gamma = record->gamma;
    result.tailExponent = record->tailExponent;
    result.missingCount = record->missingCount;
    result.negativeCount = record->negativeCount;
    result.negativePart = getPart(record->negativeVariance, record->variance);
    result.addedPart = getPart(record->addedVariance, record->variance);
    if (record->hasDirections)
    {
        result.meanDirection = swGetSeaRow(record, SW_SEA_MEAN_DIRECTION);
        result.r1 = swGetSeaRow(record, SW_SEA_R1);
        result.direction2 = swGetSeaRow(record, SW_SEA_DIRECTION2);
        result.r2 = swGetSeaRow(record, SW_SEA_R2);
        result.measuredDirection = swGetSeaRow(record, SW_SEA_MEASURED_DIRECTION);
        result.measuredR1 = swGetSeaRow(record, SW_SEA_MEASURED_R1);
    }
    return result;
}

// ---- places ----

int swMeasuredSea_GetLocationCount(const swMeasuredSea* sea)
{
    SW_REQUIRE(sea != NULL, 0, NULL, "swMeasuredSea_GetLocationCount() needs a sea");
    return (int)sea->locations.count;
}

swMeasuredLocation swMeasuredSea_GetLocation(const swMeasuredSea* sea, int location)
{
    swMeasuredLocation none;
    memset(&none, 0, sizeof(none));
    SW_REQUIRE(sea != NULL, none, NULL, "swMeasuredSea_GetLocation() needs a sea");
    bool isThere = location >= 0 && location < (int)sea->locations.count;
    return isThere ? ((const swMeasuredLocation*)sea->locations.data)[location] : none;
}

swMeasuredDirections swMeasuredSea_GetDirections(const swMeasuredSea* sea)
{
    SW_REQUIRE(sea != NULL, (swMeasuredDirections){0}, NULL, "swMeasuredSea_GetDirections() needs a measured sea");
    return sea->directions;
}

void swMeasuredSea_SetDirections(swMeasuredSea* sea, const swMeasuredDirections* directions)
{
    SW_REQUIRE_VOID(sea != NULL && directions != NULL && (unsigned)directions->meaning <= SW_DIRECTIONS_TO_FROM_EAST,
                    sea != NULL ? &sea->host : NULL,
                    "swMeasuredSea_SetDirections() needs a measured sea, and directions of a meaning that exists");
    sea->directions = *directions;
    sea->directions.basis[sizeof(sea->directions.basis) - 1] = '\0';
}

// ---- searching ----

// Digits at *text, at most `most` of them, which it then stands behind. False if there are none.
static bool readDigits(const char** text, int most, int* value)
{
    const char* begin = *text;
    *value = 0;
    for (; **text >= '0' && **text <= '9' && *text - begin < most; ++*text)
    {
        *value = 10 * *value + (**text - '0');
    }
    return *text > begin;
}

static bool skipChar(const char** text, char c)
{
    bool isThere = **text == c;
    *text += isThere ? 1 : 0;
    return isThere;
}

// ":ss.sss" or nothing.
static bool readSecond(const char** text, double* second)
{
    int whole = 0;
    double place = 0.1;
    *second = 0.0;
    if (!skipChar(text, ':'))
    {
        return true;
    }
    if (!readDigits(text, 2, &whole))
    {
        return false;
    }
    *second = whole;
    if (skipChar(text, '.'))
    {
        for (; **text >= '0' && **text <= '9'; ++*text, place *= 0.1)
        {
            *second += place * (**text - '0');
        }
    }
    return true;
}

static bool isUtc(const char* text)
{
    static const char* const endings[] = {"", "Z", " UTC", " Z", "+00:00", " +00:00", " +0:00", " 00:00"};
    for (size_t i = 0; i < sizeof(endings) / sizeof(endings[0]); ++i)
    {
        if (strcmp(text, endings[i]) == 0)
        {
            return true;
        }
    }
    return false;
}

bool swParseMeasuredTime(const char* text, double* seconds)
{
    int year = 0, month = 0, day = 0, hour = 0, minute = 0;
    double second = 0.0;
    if (text == NULL || !readDigits(&text, 4, &year) || !skipChar(&text, '-') || !readDigits(&text, 2, &month) ||
        !skipChar(&text, '-') || !readDigits(&text, 2, &day))
    {
        return false;
    }
    bool hasClock = (*text == ' ' || *text == 'T') && text[1] >= '0' && text[1] <= '9';
    text += hasClock ? 1 : 0;
    if (hasClock && (!readDigits(&text, 2, &hour) || !skipChar(&text, ':') || !readDigits(&text, 2, &minute) ||
                     !readSecond(&text, &second)))
    {
        return false;
    }
    return isUtc(text) && swMakeSeconds(year, month, day, hour, minute, second, seconds);
}

bool swMeasuredSea_Bracket(const swMeasuredSea* sea, int location, double seconds, int* before, int* after,
                           double* fraction)
{
    bool isComplete = before != NULL && after != NULL && fraction != NULL;
    SW_REQUIRE(sea != NULL && isComplete, false, sea != NULL ? &sea->host : NULL,
               "swMeasuredSea_Bracket() needs a sea and a place for each answer");
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    if (place.recordCount == 0 || seconds != seconds)
    {
        return false;
    }
    const swSeaRecord* records = sea->records.data;
    int low = place.firstRecord;
    int high = low + place.recordCount - 1;
    *fraction = 0.0;
    if (seconds <= records[low].seconds || seconds >= records[high].seconds)
    {
        *before = *after = seconds <= records[low].seconds ? low : high;
        return true;
    }
    while (high - low > 1)
    {
        int middle = low + (high - low) / 2;
        if (records[middle].seconds <= seconds)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    *before = low;
    *after = high;
    *fraction = (seconds - records[low].seconds) / (records[high].seconds - records[low].seconds);
    return true;
}
