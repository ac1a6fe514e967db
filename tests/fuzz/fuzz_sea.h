// SPDX-License-Identifier: MIT
#pragma once

// What must be true of every measured sea, whoever wrote the file.

#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "seaway/measured.h"

static inline void CheckRecord(const swMeasuredSea* sea, int index)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record.table;
    swSeaState state;
    double variance = 0.0;
    for (int j = 0; j < record.table.frequencyCount; ++j)
    {
        FUZZ_CHECK(record.table.frequencies[j] > (j > 0 ? record.table.frequencies[j - 1] : 0.0f));
        FUZZ_CHECK(record.energy[j] >= 0.0f);
        variance += (double)record.energy[j] * (double)record.table.bandwidths[j];
    }
    if (swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &state) == SW_SUCCESS)
    {
        double height = 4.0 * sqrt(variance);
        FUZZ_CHECK(fabs((double)state.significantHeight - height) <= 1e-3 * height);
        FUZZ_CHECK(state.spread >= 0.0f && state.spread <= 1.4143f);
        FUZZ_CHECK(fabsf(state.meanDirection) < 4.0f);
    }
    else
    {
        FUZZ_CHECK(variance < 1e-6);
    }
}

// A record's own time and a place's own position find them, or others as near; what is found is there.
static inline void CheckSearch(const swMeasuredSea* sea, int count)
{
    for (int i = 0; i < count && i < 4; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        swMeasuredLocation place = swMeasuredSea_GetLocation(sea, record.location);
        int index = -1, location = -1;
        double distance = -1.0;
        swResult found = swMeasuredSea_ChooseRecord(sea, record.location, record.time, &index);
        FUZZ_CHECK((found == SW_SUCCESS) == (record.time[0] != '\0'));
        FUZZ_CHECK(found != SW_SUCCESS || strcmp(swMeasuredSea_GetRecord(sea, index).time, record.time) == 0);
        location = swMeasuredSea_FindNearest(sea, place.longitude, place.latitude, &distance);
        FUZZ_CHECK(location < swMeasuredSea_GetLocationCount(sea));
        FUZZ_CHECK(location < 0 || (distance >= 0.0 && distance < 1.0));
    }
}

static inline void CheckSea(const swMeasuredSea* sea)
{
    int count = swMeasuredSea_GetCount(sea);
    for (int i = 0; i < count && i < 4; ++i)
    {
        CheckRecord(sea, i);
    }
    int records = 0;
    for (int i = 0; i < swMeasuredSea_GetLocationCount(sea); ++i)
    {
        swMeasuredLocation location = swMeasuredSea_GetLocation(sea, i);
        FUZZ_CHECK(memchr(location.name, 0, sizeof(location.name)) != NULL);
        records += location.recordCount;
        int before = -1, after = -1;
        double fraction = -1.0;
        FUZZ_CHECK(swMeasuredSea_Bracket(sea, i, 1e9, &before, &after, &fraction) == (location.recordCount > 0));
        FUZZ_CHECK(location.recordCount == 0 || (before >= location.firstRecord && after - before <= 1 &&
                                                 after >= before && fraction >= 0.0 && fraction <= 1.0));
    }
    FUZZ_CHECK(records == count);
    CheckSearch(sea, count);
}
