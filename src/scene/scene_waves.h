// SPDX-License-Identifier: MIT
#pragma once

// A wave system in a scene file.

#include "scene/scene_fields.h"
#include "scene/yaml_read.h"

// Read a system into `waves`, and keep what the file says in `text`. What is read belongs to `waves` also if this
// fails. `opensNone`: files of measured seas are left alone, so that only the keys are read.
swResult swReadSceneWaves(swYaml* yaml, yaml_node_t* node, const char* folder, bool opensNone, swSceneWaves* waves,
                          swWavesText* text);

// Whether a key of wave systems has an effect on waves of a kind, see swGetWavesWord().
bool swGoesWithWaves(const char* key, int kind);
