// SPDX-License-Identifier: MIT
// An equaliser in a scene file: where it starts from, then the octaves that are different, each named by its shortest
// wave.

#include "scene/scene_octaves.h"

#include <math.h>
#include <string.h>

enum
{
    START_DEFAULT,
    START_SWELL,
    START_PIERSON_MOSKOWITZ,
    START_JONSWAP
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

static swResult readOctave(swYaml* yaml, yaml_node_t* node, int item, swOctavesText* text)
{
    swOctaveText read = {.item = item};
    const swFields* fields = swGetOctaveFields();
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "an octave");
    swAddYamlFields(&mapping, swGetOctaveTextFields(), 0, "octaves");
    swAddYamlFields(&mapping, fields, offsetof(swOctaveText, octave), "octaves");
    swResult result = swReadYamlMapping(yaml, node, &mapping, &read);
    if (node->type != YAML_MAPPING_NODE || swIsYamlWrong(&mapping, "wavelength_m"))
    {
        return result;
    }
    const yaml_node_t* wavelength = swGetYamlNode(&mapping, "wavelength_m");
    int index = wavelength != NULL ? findOctave(read.wavelength) : -1;
    if (index < 0)
    {
        return swFailYaml(
            yaml, wavelength != NULL ? wavelength : node, SW_MISTAKE_OUT_OF_RANGE,
            "an octave needs a wavelength_m that is a power of two from 0.0625 to 512, its shortest wave.");
    }
    if (text->octaves[index].given != 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_REPEATED, "the octave of %g m stands twice; remove one.",
                          (double)ldexpf(1.0f, index - 4));
    }
    for (int i = 0; i < fields->count; ++i)
    {
        const char* key = fields->fields[i].key;
        read.given |= key != NULL && swGetYamlNode(&mapping, key) != NULL ? 1u << i : 0;
    }
    text->octaves[index] = read;
    return result;
}

swResult swReadOctaves(swYaml* yaml, yaml_node_t* node, swOctavesText* text)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "octaves", SW_OCTAVE_COUNT, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readOctave(yaml, swGetYamlItem(yaml, node, i), i, text));
    }
    return result;
}

void swStartOctaves(const swOctavesText* text, swSpectrumDef* spectrum)
{
    if (text->start == START_PIERSON_MOSKOWITZ || text->start == START_JONSWAP)
    {
        swSpectrumDef source = *spectrum;
        source.kind = text->start == START_JONSWAP ? SW_SPECTRUM_JONSWAP : SW_SPECTRUM_PIERSON_MOSKOWITZ;
        source.significantHeight = 0.0f;
        float height = spectrum->significantHeight;
        *spectrum = swMakeOctaveSpectrum(&source);
        spectrum->significantHeight = height;
    }
    else
    {
        spectrum->octaves = text->start == START_SWELL ? swDefaultSwellOctaves() : swDefaultOctaves();
    }
    spectrum->kind = SW_SPECTRUM_OCTAVES;
}

static void copyField(const swField* field, const void* from, void* to)
{
    memcpy((char*)to + field->offset, (const char*)from + field->offset, field->size);
}

void swBuildOctaves(const swOctavesText* text, const swYamlMapping* mapping, swSpectrumDef* spectrum)
{
    swStartOctaves(text, spectrum);
    const swFields* fields = swGetOctaveFields();
    const swField* power = swFields_Find(fields, "power");
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        const swOctaveText* given = &text->octaves[i];
        swOctave* octave = &spectrum->octaves.octaves[i];
        // Who gives an octave a power wants to see it.
        octave->isEnabled = octave->isEnabled || (given->given >> (power - fields->fields) & 1u) != 0;
        for (int j = 0; j < fields->count; ++j)
        {
            if ((given->given >> j & 1u) != 0)
            {
                copyField(&fields->fields[j], &given->octave, octave);
            }
        }
    }
    float multiplier = spectrum->octaves.multiplier;
    fields = swGetOctavesFields();
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (field->type < SW_FIELD_DEF && field->key != NULL && swGetYamlNode(mapping, field->key) != NULL)
        {
            copyField(field, &text->given, &spectrum->octaves);
        }
    }
    if (swGetYamlNode(mapping, "multiplier") != NULL)
    {
        spectrum->octaves.multiplier = fminf(multiplier * text->given.multiplier, 10.0f);
    }
}
