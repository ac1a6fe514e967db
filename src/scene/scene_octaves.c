// SPDX-License-Identifier: MIT
// An equaliser in a scene file: where it starts from, then the octaves that are different, each named by its shortest
// wave.

#include "scene/scene_octaves.h"

#include <math.h>
#include <string.h>

const char* const swOctaveStartWords[] = {"default", "swell", "pierson_moskowitz", "jonswap", NULL};

enum
{
    START_DEFAULT,
    START_SWELL,
    START_PIERSON_MOSKOWITZ,
    START_JONSWAP
};

typedef struct OctaveText
{
    float wavelength;
    swOctave octave;
} OctaveText;

enum
{
    WAVELENGTH,
    POWER,
    ENABLED,
    CHOP,
    GRAVITY_SCALE
};

static const swYamlField octaveFields[] = {
    [WAVELENGTH] = {.key = "wavelength_m",
                    .type = SW_YAML_FLOAT,
                    .offset = offsetof(OctaveText, wavelength),
                    .low = 0.0625,
                    .high = 512.0},
    [POWER] = {.key = "power",
               .type = SW_YAML_FLOAT,
               .offset = offsetof(OctaveText, octave.power),
               .low = -10.0,
               .high = 5.0},
    [ENABLED] = {.key = "enabled", .type = SW_YAML_BOOL, .offset = offsetof(OctaveText, octave.isEnabled)},
    [CHOP] =
        {.key = "chop", .type = SW_YAML_FLOAT, .offset = offsetof(OctaveText, octave.chop), .low = 0.0, .high = 4.0},
    [GRAVITY_SCALE] = {.key = "gravity_scale",
                       .type = SW_YAML_FLOAT,
                       .offset = offsetof(OctaveText, octave.gravityScale),
                       .low = 0.0,
                       .high = 4.0},
};

static int findOctave(float wavelength)
{
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        float shortest = ldexpf(1.0f, i - 4);
        if (fabsf(wavelength - shortest) <= 0.005f * shortest)
        {
            return i;
        }
    }
    return -1;
}

static swResult readOctave(swYaml* yaml, yaml_node_t* node, swOctavesText* text)
{
    OctaveText read;
    memset(&read, 0, sizeof(read));
    swYamlNodes nodes;
    swResult result =
        swReadYamlMapping(yaml, node, "an octave", octaveFields, SW_YAML_COUNT(octaveFields), &read, &nodes);
    if (node->type != YAML_MAPPING_NODE || nodes.isWrong[WAVELENGTH])
    {
        return result;
    }
    int index = nodes.nodes[WAVELENGTH] != NULL ? findOctave(read.wavelength) : -1;
    if (index < 0)
    {
        return swFailYaml(
            yaml, nodes.nodes[WAVELENGTH] != NULL ? nodes.nodes[WAVELENGTH] : node, SW_MISTAKE_OUT_OF_RANGE,
            "an octave needs a wavelength_m that is a power of two from 0.0625 to 512, its shortest wave.");
    }
    if (text->hasPower[index] || text->hasEnabled[index] || text->hasChop[index] || text->hasGravity[index])
    {
        return swFailYaml(yaml, node, SW_MISTAKE_REPEATED, "the octave of %g m stands twice; remove one.",
                          (double)ldexpf(1.0f, index - 4));
    }
    text->octaves[index] = read.octave;
    text->hasPower[index] = nodes.nodes[POWER] != NULL;
    text->hasEnabled[index] = nodes.nodes[ENABLED] != NULL;
    text->hasChop[index] = nodes.nodes[CHOP] != NULL;
    text->hasGravity[index] = nodes.nodes[GRAVITY_SCALE] != NULL;
    return result;
}

swResult swReadOctaves(swYaml* yaml, yaml_node_t* node, swOctavesText* text)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "octaves", SW_OCTAVE_COUNT, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readOctave(yaml, swGetYamlItem(yaml, node, i), text));
    }
    return result;
}

static void startFrom(int start, swSpectrumDef* spectrum)
{
    if (start == START_PIERSON_MOSKOWITZ || start == START_JONSWAP)
    {
        swSpectrumDef source = *spectrum;
        source.kind = start == START_JONSWAP ? SW_SPECTRUM_JONSWAP : SW_SPECTRUM_PIERSON_MOSKOWITZ;
        source.significantHeight = 0.0f;
        float height = spectrum->significantHeight;
        *spectrum = swMakeOctaveSpectrum(&source);
        spectrum->significantHeight = height;
        return;
    }
    spectrum->octaves = start == START_SWELL ? swDefaultSwellOctaves() : swDefaultOctaves();
}

void swBuildOctaves(const swOctavesText* text, swSpectrumDef* spectrum)
{
    startFrom(text->start, spectrum);
    spectrum->kind = SW_SPECTRUM_OCTAVES;
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        swOctave* octave = &spectrum->octaves.octaves[i];
        octave->power = text->hasPower[i] ? text->octaves[i].power : octave->power;
        // Who gives an octave a power wants to see it.
        octave->isEnabled = text->hasEnabled[i] ? text->octaves[i].isEnabled : octave->isEnabled || text->hasPower[i];
        octave->chop = text->hasChop[i] ? text->octaves[i].chop : octave->chop;
        octave->gravityScale = text->hasGravity[i] ? text->octaves[i].gravityScale : octave->gravityScale;
    }
    spectrum->octaves.multiplier *= text->multiplier;
    spectrum->octaves.multiplier = fminf(spectrum->octaves.multiplier, 10.0f);
    spectrum->octaves.gravityScale = text->gravityScale;
    spectrum->octaves.limitByWind = text->hasLimit ? text->limitByWind : spectrum->octaves.limitByWind;
}
