// SPDX-License-Identifier: MIT
#include "tuning.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

typedef struct Field
{
    size_t offset, size;
} Field;

#define FIELD(type, member)                                                                                            \
    {                                                                                                                  \
        offsetof(type, member), sizeof(((type*)0)->member)                                                             \
    }
#define COUNT(list) ((int)(sizeof(list) / sizeof((list)[0])))

#define SYSTEM(member) FIELD(swWaveSystemDef, member)
static const Field systemFields[] = {
    SYSTEM(spectrum.kind),
    SYSTEM(spectrum.windSpeed),
    SYSTEM(spectrum.fetch),
    SYSTEM(spectrum.gamma),
    SYSTEM(spectrum.growth),
    SYSTEM(spectrum.significantHeight),
    SYSTEM(spectrum.peakPeriod),
    SYSTEM(spectrum.direction),
    SYSTEM(spectrum.spreading),
    SYSTEM(spectrum.spreadExponent),
    SYSTEM(spectrum.turbulence),
    SYSTEM(spectrum.swell),
    SYSTEM(spectrum.depth),
    SYSTEM(spectrum.extendTail),
    SYSTEM(spectrum.octaves.multiplier),
    SYSTEM(spectrum.octaves.chop),
    SYSTEM(spectrum.octaves.gravityScale),
    SYSTEM(spectrum.octaves.limitByWind),
    SYSTEM(method),
    SYSTEM(componentsPerOctave),
    SYSTEM(reverseWeight),
    SYSTEM(leastJacobian),
    SYSTEM(directionVariance),
    SYSTEM(chop),
    SYSTEM(weight),
    SYSTEM(seed),
};

#define OCTAVE(member) FIELD(swOctave, member)
static const Field octaveFields[] = {OCTAVE(power), OCTAVE(isEnabled), OCTAVE(chop), OCTAVE(gravityScale)};

#define ROW(member) FIELD(swWaveComponent, member)
static const Field rowFields[] = {ROW(wavelength), ROW(direction), ROW(amplitude), ROW(phase)};

#define REPLAY(member) FIELD(swSeaReplayDef, member)
static const Field replayFields[] = {REPLAY(location), REPLAY(startTime), REPLAY(startSeconds), REPLAY(speed)};

#define LOOK(member) FIELD(SeaLook, member)
static const Field lookFields[] = {
    LOOK(sky.sunAzimuth),     LOOK(sky.sunElevation),   LOOK(sky.haze),           LOOK(sky.clouds),
    LOOK(exposureEv),         LOOK(water.absorption.x), LOOK(water.absorption.y), LOOK(water.absorption.z),
    LOOK(water.scattering.x), LOOK(water.scattering.y), LOOK(water.scattering.z), LOOK(water.refractiveIndex),
    LOOK(water.foamAlbedo),   LOOK(water.windSpeed),    LOOK(foam.fadeRate),      LOOK(foam.threshold),
    LOOK(foam.coverage),      LOOK(foam.windSpeed),     LOOK(foam.minWavelength),
};

static int CountDifferent(const void* value, const void* filed, const Field* fields, int count)
{
    int different = 0;
    for (int i = 0; i < count; i++)
    {
        const char* a = (const char*)value + fields[i].offset;
        different += memcmp(a, (const char*)filed + fields[i].offset, fields[i].size) != 0;
    }
    return different;
}

static int CountOctaveChanges(const swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    int count = 0;
    // Octaves that neither spectrum uses, as where the kind went from one formula to another, are nobody's values.
    for (int i = 0; i < SW_OCTAVE_COUNT && spectrum->kind == filed->kind; i++)
    {
        count += CountDifferent(&spectrum->octaves.octaves[i], &filed->octaves.octaves[i], octaveFields,
                                COUNT(octaveFields));
    }
    return count;
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
        count += row < 0 ? 1 : CountDifferent(&hand->waves[i], &hand->filed[row], rowFields, COUNT(rowFields));
    }
    return count;
}

bool HasReplayChanged(const SeaWaves* waves)
{
    return CountDifferent(&waves->replayDef, &waves->filedReplay, replayFields, COUNT(replayFields)) > 0;
}

int CountWavesChanges(const SeaWaves* waves)
{
    if (waves->isAdded || waves->isRemoved)
    {
        return 1;
    }
    return CountDifferent(&waves->def, &waves->filedDef, systemFields, COUNT(systemFields)) +
           CountOctaveChanges(&waves->def.spectrum, &waves->filedDef.spectrum) + CountRowChanges(waves) +
           (waves->record != waves->filedRecord) + HasReplayChanged(waves);
}

int CountChanges(const Sea* sea)
{
    int count = CountDifferent(&sea->look, &sea->filedLook, lookFields, COUNT(lookFields));
    for (int i = 0; i < sea->wavesCount; i++)
    {
        count += CountWavesChanges(&sea->waves[i]);
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
