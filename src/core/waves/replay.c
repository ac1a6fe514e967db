// SPDX-License-Identifier: MIT
#include "core/waves/replay.h"

swWaveSystemDef swMakeRecordDef(const swWaveSystemDef* waves, const swSpectrumTable* table)
{
    swWaveSystemDef def = *waves;
    def.spectrum.kind = SW_SPECTRUM_TABLE;
    def.spectrum.table = table;
    return def;
}

// One of the sets that the replay holds, or a new one; counted as used once more.
static swResult acquireRecord(swWaves* waves, swReplay* replay, int slot, int index, swWaveSet** set)
{
    for (int i = 0; i < 2; ++i)
    {
        if (replay->sets[i] != NULL && index == (i == 0 ? replay->before : replay->after))
        {
            *set = replay->sets[i];
            (*set)->useCount += 1;
            return SW_SUCCESS;
        }
    }
    swMeasuredRecord record = swMeasuredSea_GetRecord(replay->sea, index);
    swWaveSystemDef def = swMakeRecordDef(&replay->waves, &record.table);
    swDrift drift = swPlanDrift(waves, slot, &def, 0.0);
    return swAcquireSet(waves, -1, &def, &drift, set);
}

static void releaseSets(swWaves* waves, swWaveSet* sets[2])
{
    for (int i = 0; i < 2; ++i)
    {
        if (sets[i] != NULL)
        {
            swReleaseSet(waves, sets[i]);
            sets[i] = NULL;
        }
    }
}

// Make the pair current: its sets, their mix, and the system's only part.
static swResult changePair(swWaves* waves, swReplay* replay, int slot, int before, int after)
{
    swWaveSet* sets[2] = {NULL, NULL};
    swWaveSet* shown = NULL;
    swResult result = acquireRecord(waves, replay, slot, before, &sets[0]);
    result = result == SW_SUCCESS ? acquireRecord(waves, replay, slot, after, &sets[1]) : result;
    if (result == SW_SUCCESS && sets[0] != sets[1])
    {
        result = swMixSets(waves, sets[0], 0.0f, sets[1], &shown);
        result = result == SW_ERROR_UNSUPPORTED ? SW_ERROR_INVALID : result;
    }
    else if (result == SW_SUCCESS)
    {
        shown = sets[0];
        shown->useCount += 1;
    }
    if (result == SW_SUCCESS)
    {
        result = swShowSet(waves, slot, shown); // uses it by itself
        swReleaseSet(waves, shown);
    }
    if (result != SW_SUCCESS)
    {
        releaseSets(waves, sets);
        return result;
    }
    releaseSets(waves, replay->sets);
    replay->sets[0] = sets[0];
    replay->sets[1] = sets[1];
    replay->before = before;
    replay->after = after;
    replay->rewindCount = waves->rewindCount;
    return SW_SUCCESS;
}

swResult swShowRecords(swWaves* waves, swReplay* replay, int slot, int before, int after, double fraction,
                       const swRecordClock* clock)
{
    if (before != replay->before || after != replay->after || replay->rewindCount != waves->rewindCount)
    {
        swResult result = changePair(waves, replay, slot, before, after);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    replay->fraction = fraction;
    swSharePart(waves, slot, (float)fraction, clock);
    return SW_SUCCESS;
}

void swEndReplay(swWaves* waves, swReplay* replay)
{
    releaseSets(waves, replay->sets);
}
