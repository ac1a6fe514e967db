// SPDX-License-Identifier: MIT
#pragma once

// The equaliser of a scene's wave system.

#include "scene/scene_fields.h"
#include "scene/yaml_read.h"

// A list of octaves into a swOctavesText.
swResult swReadOctaves(swYaml* yaml, yaml_node_t* node, swOctavesText* text);

// Let the spectrum have the equaliser that the text starts from. Wind and peak are the spectrum's own.
void swStartOctaves(const swOctavesText* text, swSpectrumDef* spectrum);

// Put the equaliser of a spectrum together; `mapping` knows which of its keys the file has.
void swBuildOctaves(const swOctavesText* text, const swYamlMapping* mapping, swSpectrumDef* spectrum);
