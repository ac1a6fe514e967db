// SPDX-License-Identifier: MIT
#pragma once

// A measured sea in a scene file: which files, which place, which record, or all of them one after another.

#include "scene/scene_fields.h"
#include "scene/yaml_read.h"

// What a wave system says of it, and where. Nodes are NULL where the file says nothing.
typedef struct swMeasuredKeys
{
    const swMeasuredText* text;
    const char* folder; // that file names are relative to
    bool opensNone;     // only the keys are checked
    yaml_node_t *system, *file, *list, *location, *latitude, *longitude, *directions, *at, *replay, *from, *method;
} swMeasuredKeys;

// The mapping `replay`; `from` is the node of that key.
swResult swReadReplay(swYaml* yaml, yaml_node_t* node, swMeasuredText* text, yaml_node_t** from);

// Read the files, and let the wave system be of the record or the records that are asked for. What is read belongs to
// `waves` also if this fails.
swResult swReadSceneMeasured(swYaml* yaml, const swMeasuredKeys* keys, swSceneWaves* waves);

// When the scene's time is known: the record that each replay is nearest to then.
void swChooseReplayRecords(swScene* scene);
