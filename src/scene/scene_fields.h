// SPDX-License-Identifier: MIT
#pragma once

// What scene files say of waves beyond the defs that are made of it, and the tables of those keys.

#include "seaway/field.h"
#include "seaway/scene.h"

// An octave of the equaliser: which fields of swGetOctaveFields() the file gives (bit i), and which item of its list.
typedef struct swOctaveText
{
    float wavelength;
    swOctave octave;
    uint32_t given;
    int item; // -1: the file has none
} swOctaveText;

// What a file says of octaves.
typedef struct swOctavesText
{
    int start;
    swOctaveText octaves[SW_OCTAVE_COUNT];
    swOctaves given; // as the file has it: `multiplier` is a factor on that of the start
} swOctavesText;

// The keys of a wave system that concern measured seas.
typedef struct swMeasuredText
{
    char file[512];
    char location[64];
    char at[32];
    double latitude, longitude; // degrees
    int directions;             // index into the words
    char from[32];
    double replayTime; // s
    double replaySpeed;
} swMeasuredText;

// What waves a system is of: a swSpectrumKind, or one of these.
enum
{
    SW_WAVES_WIND_SEA = SW_SPECTRUM_KIND_COUNT,
    SW_WAVES_SWELL,
    SW_WAVES_BEAUFORT,
    SW_WAVES_SEA_STATE,
    SW_WAVES_COMPONENTS,
    SW_WAVES_KIND_COUNT
};

// A wave system as a file has it.
typedef struct swWavesText
{
    int kind;
    float beaufort, seaState;
    float durationHours;
    float spread;
    swOctavesText octaves;
    swMeasuredText measured;
    bool hasFetch, hasDuration, hasLocation, hasPlace, hasDirections, hasAt, hasFrom, hasWindSpeed; // in the file
    swWaveSystemDef def;
} swWavesText;

const swFields* swGetWavesTextFields(void);    // of swWavesText: beaufort, sea_state, ...
const swFields* swGetMeasuredTextFields(void); // of swMeasuredText: file, location, ...; the section "replay" too
const swFields* swGetOctaveTextFields(void);   // of swOctaveText: wavelength_m

// The word of a kind in scene files: of `spectrum`, or the key that stands in its place. NULL behind the last.
const char* swGetWavesWord(int kind);
