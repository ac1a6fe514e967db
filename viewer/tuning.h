// SPDX-License-Identifier: MIT
#pragma once

// What the user has changed beside what the file has: each value for itself, and how many there are. And what a knob of
// the panel shows of a value, in the unit that people use, and back.

#include "sea.h"

// How many values of the sea, rows and systems differ from the file's. Every value that the panel turns counts.
int CountChanges(const Sea* sea);
int CountWavesChanges(const SeaWaves* waves);
int CountInputChanges(const SeaInput* input);
int CountBodyChanges(const SeaBody* body);

// Rows of the file that are not there any more.
int CountMissingRows(const SeaWaves* waves);

// Place, moment or speed of a replay.
bool HasReplayChanged(const SeaWaves* waves);

// Everything as the file has it; the world follows with ApplyChanges(). False if the world had no room for a system.
bool ResetChanges(Sea* sea);
void ResetWaves(SeaWaves* waves);

// A value in the panel. Shown is value / unit; bearings are degrees clockwise from north where waves come from, of a
// direction in radians where they go.
typedef struct Knob
{
    const char* label;
    float low, high; // as shown
    const char* format;
    float unit; // 0 means 1
    bool isLogarithmic;
    bool isBearing;
    const char* zero; // what is written instead of 0
    const char* tip;
} Knob;

#define DEGREE ((float)(SW_PI / 180.0))

float ShowValue(const Knob* knob, float value);
float ReadShown(const Knob* knob, float shown);

// The format that a knob is shown with: its own, or the word for zero.
const char* ChooseFormat(const Knob* knob, float value);

// Beaufort's number of a spectrum, and whether the spectrum is that sea; else the number tells its wind.
typedef struct BeaufortNumber
{
    float number;
    bool isExact;
} BeaufortNumber;

BeaufortNumber FindBeaufort(const swSpectrumDef* spectrum);

// The sea of that number, from where it comes now, over the depth and with the directions' own settings kept, as in a
// scene file.
void SetBeaufort(swSpectrumDef* spectrum, float number);
