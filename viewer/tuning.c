// SPDX-License-Identifier: MIT
#include "tuning.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int CountDifferentParts(const swField* field, const char* value, const char* filed);

// Numbers that differ, one by one. Lists and what is given are counted elsewhere.
static int CountDifferent(const swFields* fields, const void* value, const void* filed)
{
    int count = 0;
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        count += CountDifferentParts(field, (const char*)value + field->offset, (const char*)filed + field->offset);
    }
    return count;
}

static int CountDifferentParts(const swField* field, const char* value, const char* filed)
{
    if (field->type > SW_FIELD_DEFS || field->type == SW_FIELD_TEXT)
    {
        return 0;
    }
    size_t size = field->size / (size_t)field->count;
    int count = 0;
    for (int i = 0; i < field->count; i++, value += size, filed += size)
    {
        count += field->fields != NULL ? CountDifferent(field->fields, value, filed) : memcmp(value, filed, size) != 0;
    }
    return count;
}

// Octaves that neither spectrum uses, as where the kind went from one formula to another, are nobody's values.
static int CountSystemChanges(const swWaveSystemDef* def, const swWaveSystemDef* filed)
{
    swWaveSystemDef other = *filed;
    if (def->spectrum.kind != filed->spectrum.kind)
    {
        memcpy(other.spectrum.octaves.octaves, def->spectrum.octaves.octaves, sizeof(other.spectrum.octaves.octaves));
    }
    return CountDifferent(swGetWaveSystemFields(), def, &other);
}

int CountMissingRows(const SeaWaves* waves)
{
    int present = 0;
    for (int i = 0; waves->hand != NULL && i < waves->def.componentCount; i++)
    {
        present += waves->hand->filedRows[i] >= 0;
    }
    return waves->hand != NULL ? waves->hand->filedCount - present : 0;
}

static int CountRowChanges(const SeaWaves* waves)
{
    const HandWaves* hand = waves->hand;
    int count = CountMissingRows(waves);
    for (int i = 0; hand != NULL && i < waves->def.componentCount; i++)
    {
        int row = hand->filedRows[i];
        count += row < 0 ? 1 : CountDifferent(swGetWaveComponentFields(), &hand->waves[i], &hand->filed[row]);
    }
    return count;
}

bool HasReplayChanged(const SeaWaves* waves)
{
    const swSeaReplayDef *replay = &waves->replayDef, *filed = &waves->filedReplay;
    return replay->location != filed->location || replay->startTime != filed->startTime ||
           memcmp(&replay->startSeconds, &filed->startSeconds, sizeof(double)) != 0 || replay->speed != filed->speed;
}

int CountWavesChanges(const SeaWaves* waves)
{
    if (waves->isAdded || waves->isRemoved)
    {
        return 1;
    }
    return CountSystemChanges(&waves->def, &waves->filedDef) + CountRowChanges(waves) +
           (waves->record != waves->filedRecord) + HasReplayChanged(waves);
}

int CountInputChanges(const SeaInput* input)
{
    if (input->isAdded || input->isRemoved)
    {
        return 1;
    }
    const swInputDef *def = &input->def, *filed = &input->filedDef;
    int least = def->pointCount < filed->pointCount ? def->pointCount : filed->pointCount;
    int count = CountDifferent(swGetInputFields(), def, filed) + abs(def->pointCount - filed->pointCount);
    for (int i = 0; i < least; i++)
    {
        count += memcmp(&def->points[i], &filed->points[i], sizeof(swInputPoint)) != 0;
    }
    return count;
}

int CountBodyChanges(const SeaBody* body)
{
    const swWaterBodyDef *def = &body->def, *filed = &body->filedDef;
    int least = def->pointCount < filed->pointCount ? def->pointCount : filed->pointCount;
    int count = CountDifferent(swGetWaterBodyFields(), def, filed) + abs(def->pointCount - filed->pointCount);
    for (int i = 0; i < least; i++)
    {
        count += memcmp(&def->points[i], &filed->points[i], sizeof(swVec2)) != 0;
    }
    return count;
}

int CountChanges(const Sea* sea)
{
    const SeaLook *look = &sea->look, *filed = &sea->filedLook;
    int count = CountDifferent(swGetSkyFields(), &look->sky, &filed->sky) +
                CountDifferent(swGetWaterFields(), &look->water, &filed->water) +
                CountDifferent(swGetFoamFields(), &look->foam, &filed->foam) + (look->exposureEv != filed->exposureEv);
    for (int i = 0; i < sea->wavesCount; i++)
    {
        count += CountWavesChanges(&sea->waves[i]);
    }
    for (int i = 0; sea->scene != NULL && i < sea->scene->inputCount; i++)
    {
        count += CountInputChanges(&sea->inputs[i]);
    }
    for (int i = 0; sea->scene != NULL && i < sea->scene->waterBodyCount; i++)
    {
        count += CountBodyChanges(&sea->bodies[i]);
    }
    return count;
}

void ResetWaves(SeaWaves* waves)
{
    HandWaves* hand = waves->hand;
    waves->def = waves->filedDef;
    waves->record = waves->filedRecord;
    waves->replayDef = waves->filedReplay;
    for (int i = 0; hand != NULL && i < hand->filedCount; i++)
    {
        hand->waves[i] = hand->filed[i];
        hand->filedRows[i] = i;
    }
    waves->hasChanged = true;
}

bool ResetChanges(Sea* sea)
{
    bool isGood = true;
    sea->look = sea->filedLook;
    swWorld_SetFoam(sea->world, &sea->look.foam);
    ResetInputs(sea);
    for (int i = sea->wavesCount - 1; i >= 0; i--) // backwards: added ones leave the list
    {
        if (sea->waves[i].isAdded)
        {
            RemoveWaves(sea, i);
        }
        else if (CountWavesChanges(&sea->waves[i]) > 0)
        {
            ResetWaves(&sea->waves[i]);
            isGood = (!sea->waves[i].isRemoved || BringBackWaves(sea, i)) && isGood;
        }
    }
    return isGood;
}

float ShowValue(const Knob* knob, float value)
{
    float shown = value / (knob->unit != 0.0f ? knob->unit : 1.0f);
    if (knob->isBearing)
    {
        shown = fmodf(value / DEGREE - 90.0f, 360.0f);
        shown = shown < 0.0f ? shown + 360.0f : shown;
    }
    return shown;
}

float ReadShown(const Knob* knob, float shown)
{
    return knob->isBearing ? SW_DIRECTION_FROM_BEARING((double)shown)
                           : shown * (knob->unit != 0.0f ? knob->unit : 1.0f);
}

const char* ChooseFormat(const Knob* knob, float value)
{
    return knob->zero != NULL && value == 0.0f ? knob->zero : knob->format;
}

// Whether two spectra have the same waves along their mean direction: what a number of Beaufort's decides.
static bool HaveSameHeights(const swSpectrumDef* a, const swSpectrumDef* b)
{
    return a->kind == b->kind && fabsf(a->windSpeed - b->windSpeed) <= 1e-4f * b->windSpeed &&
           fabsf(a->significantHeight - b->significantHeight) <= 1e-3f * b->significantHeight &&
           fabsf(a->peakPeriod - b->peakPeriod) <= 1e-3f * b->peakPeriod && fabsf(a->gamma - b->gamma) <= 1e-2f;
}

BeaufortNumber FindBeaufort(const swSpectrumDef* spectrum)
{
    float number = powf(fmaxf(spectrum->windSpeed, 0.0f) / 0.836f, 2.0f / 3.0f);
    BeaufortNumber found = {fminf(number, 12.0f), false};
    float rounded = roundf(number * 100.0f) / 100.0f; // knobs turn by hundredths
    swSpectrumDef exact = swMakeBeaufortSpectrum(number, spectrum->direction);
    swSpectrumDef near = swMakeBeaufortSpectrum(rounded, spectrum->direction);
    found.isExact = HaveSameHeights(spectrum, &exact) || HaveSameHeights(spectrum, &near);
    return found;
}

void SetBeaufort(swSpectrumDef* spectrum, float number)
{
    swSpectrumDef made = swMakeBeaufortSpectrum(number, spectrum->direction);
    made.turbulence = spectrum->turbulence;
    made.swell = spectrum->swell;
    made.depth = spectrum->depth;
    made.octaves = spectrum->octaves;
    made.extendTail = spectrum->extendTail;
    *spectrum = made;
}
