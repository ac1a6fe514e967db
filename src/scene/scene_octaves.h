// SPDX-License-Identifier: MIT
#pragma once

// The equaliser of a scene's wave system.

#include "scene/yaml_read.h"
#include "seaway/spectrum.h"

// What a file says of octaves: for each which fields it sets.
typedef struct swOctavesText
{
    int start; // index into swOctaveStartWords
    swOctave octaves[SW_OCTAVE_COUNT];
    bool hasPower[SW_OCTAVE_COUNT], hasEnabled[SW_OCTAVE_COUNT], hasChop[SW_OCTAVE_COUNT], hasGravity[SW_OCTAVE_COUNT];
    float multiplier; // on that of the start
    float gravityScale;
    bool limitByWind;
    bool hasLimit;
} swOctavesText;

extern const char* const swOctaveStartWords[];

// A list of octaves into an swOctavesText.
swResult swReadOctaves(swYaml* yaml, yaml_node_t* node, swOctavesText* text);

// Put the equaliser of a spectrum together.
void swBuildOctaves(const swOctavesText* text, swSpectrumDef* spectrum);
