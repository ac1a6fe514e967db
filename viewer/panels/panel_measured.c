// SPDX-License-Identifier: MIT
// Measured seas: one record that stays, or a replay of all of a place.

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "panels.h"

// The place that a record is of.
static int FindPlace(const swMeasuredSea* sea, int record)
{
    for (int i = 0; i < swMeasuredSea_GetLocationCount(sea); i++)
    {
        swMeasuredLocation place = swMeasuredSea_GetLocation(sea, i);
        if (record >= place.firstRecord && record < place.firstRecord + place.recordCount)
        {
            return i;
        }
    }
    return 0;
}

static const char* GetPlaceName(void* context, int index)
{
    static char text[80];
    swMeasuredLocation place = swMeasuredSea_GetLocation(context, index);
    if (place.name[0] != '\0')
    {
        snprintf(text, sizeof(text), "%s", place.name);
    }
    else
    {
        snprintf(text, sizeof(text), "place %d", index + 1);
    }
    return text;
}

// Its time, and its place where a file has several.
static const char* GetRecordName(void* context, int index)
{
    static char text[112];
    swMeasuredRecord record = swMeasuredSea_GetRecord(context, index);
    bool hasPlaces = swMeasuredSea_GetLocationCount(context) > 1;
    snprintf(text, sizeof(text), "%s%s%s", record.time, hasPlaces ? "  " : "",
             hasPlaces ? GetPlaceName(context, FindPlace(context, index)) : "");
    return text;
}

static bool DrawRecord(SeaWaves* waves)
{
    int* record = &waves->record;
    int last = swMeasuredSea_GetCount(waves->measured) - 1;
    void* context = (void*)(uintptr_t)waves->measured;
    bool hasChanged = TurnChoice("record", record, &waves->filedRecord, last + 1, GetRecordName, context);
    hasChanged |= last > 0 && UiSliderInt("record number", record, 0, last, "%d");
    if (UiButton("largest"))
    {
        *record = swMeasuredSea_FindLargest(waves->measured);
        hasChanged = true;
    }
    UiTip("The record with the largest significant height");
    return hasChanged;
}

// Where a replay is between two records.
static void DrawPlaceInRecords(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    int before = 0, after = 0;
    double fraction = 0.0;
    char now[20], text[64];
    WriteUtc(GetReplaySeconds(sea, index), now);
    UiText("%s UTC", now);
    swSeaReplay_GetRecords(waves->replay, &before, &after, &fraction);
    swMeasuredRecord a = swMeasuredSea_GetRecord(waves->measured, before);
    swMeasuredRecord b = swMeasuredSea_GetRecord(waves->measured, after);
    snprintf(text, sizeof(text), "%.11s %.5s to %.5s", a.time, a.time + 11, b.time + 11);
    UiBar((float)fraction, text);
}

static void DrawReplaySpeed(Sea* sea, int index)
{
    const swSeaReplayDef *replay = &sea->waves[index].replayDef, *filed = &sea->waves[index].filedReplay;
    double seconds = GetReplaySeconds(sea, index);
    float speed = (float)fabs(replay->speed);
    bool isBackwards = replay->speed < 0.0, stands = replay->speed == 0.0;
    UiMarkNext(replay->speed != filed->speed, "In the file: x %.4g. Click to go back to it.", filed->speed);
    bool hasChanged = UiLogSlider("replay speed", &speed, 0.1f, 1e5f, stands ? "stands still" : "x %.1f");
    UiTip("Seconds of records that pass in one of the sea; the timeline above moves through them");
    if (UiWasReset())
    {
        ChangeReplay(sea, index, seconds, filed->speed);
    }
    else if (hasChanged)
    {
        ChangeReplay(sea, index, seconds, isBackwards ? -(double)speed : (double)speed);
    }
    if (UiCheckbox("records backwards", &isBackwards))
    {
        ChangeReplay(sea, index, seconds, -replay->speed);
    }
    UiSameLine();
    if (UiCheckbox("halt", &stands))
    {
        ChangeReplay(sea, index, seconds, stands ? 0.0 : filed->speed != 0.0 ? filed->speed : 1.0);
    }
    UiTip("The records stand still while the waves run on");
}

// The moment of the records, from the place's first to its last.
static void DrawReplayMoment(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    swMeasuredLocation place = swMeasuredSea_GetLocation(waves->measured, waves->replayDef.location);
    double first = swMeasuredSea_GetRecord(waves->measured, place.firstRecord).seconds;
    double last = swMeasuredSea_GetRecord(waves->measured, place.firstRecord + place.recordCount - 1).seconds;
    double now = GetReplaySeconds(sea, index), filed = GetFiledReplaySeconds(sea, index);
    double hours = (now - first) / 3600.0;
    UiMarkNext(fabs(now - filed) > 1e-3, "By the file it would be %.2f h. Click to go there.",
               (filed - first) / 3600.0);
    bool hasChanged = UiDoubleSlider("moment", &hours, 0.0, (last - first) / 3600.0, "%.2f h");
    UiTip("Hours since the first record; pull to go to another moment of them, the waves run on");
    if (UiWasReset())
    {
        ResetReplayMoment(sea, index);
    }
    else if (hasChanged)
    {
        ChangeReplay(sea, index, first + 3600.0 * hours, waves->replayDef.speed);
    }
}

static void DrawReplayPlace(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    int place = waves->replayDef.location, count = swMeasuredSea_GetLocationCount(waves->measured);
    if (count > 1 && TurnChoice("place", &place, &waves->filedReplay.location, count, GetPlaceName,
                                (void*)(uintptr_t)waves->measured))
    {
        ChangeReplayPlace(sea, index, place);
    }
}

static void DrawReplay(Sea* sea, int index)
{
    DrawPlaceInRecords(sea, index);
    DrawReplayPlace(sea, index);
    DrawReplayMoment(sea, index);
    DrawReplaySpeed(sea, index);
}

bool DrawMeasured(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    swSpectrumDef* spectrum = &waves->def.spectrum;
    const swSpectrumDef* filed = &waves->filedDef.spectrum;
    bool hasChanged = false;
    const char* slash = strrchr(waves->file, '/');
    UiFaint("%s", slash != NULL ? slash + 1 : waves->file);
    UiTip(waves->file);
    if (waves->replay != NULL)
    {
        DrawReplay(sea, index);
    }
    else
    {
        hasChanged = DrawRecord(waves);
    }
    hasChanged |= TurnKnob(&(Knob){.label = "height Hs", .high = 20.0f, .format = "%.2f m", .zero = "as measured"},
                           &spectrum->significantHeight, &filed->significantHeight);
    hasChanged |=
        TurnKnob(&(Knob){.label = "turned by", .low = -180.0f, .high = 180.0f, .format = "%.0f deg", .unit = DEGREE},
                 &spectrum->direction, &filed->direction);
    hasChanged |= TurnMember(swGetSpectrumFields(), "extendTail", spectrum, filed);
    return hasChanged;
}
