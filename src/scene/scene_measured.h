// SPDX-License-Identifier: MIT
#pragma once

// A measured sea in a scene file: which files, which place, which record, or all of them one after another.

#include "scene/yaml_read.h"
#include "seaway/scene.h"

// The keys of a wave system that concern it. Nodes are NULL where the file says nothing.
typedef struct swMeasuredText
{
    const char* folder; // that file names are relative to
    yaml_node_t *system, *fileNode, *listNode, *locationNode, *atNode, *replayNode, *methodNode;
    char file[512];
    char location[64];
    char at[32];
    yaml_node_t* fromNode;
    char from[32];
    yaml_node_t *latitudeNode, *longitudeNode;
    double latitude, longitude; // degrees
    yaml_node_t* directionsNode;
    int directions;    // index into swDirectionWords
    double replayTime; // s
    double replaySpeed;
} swMeasuredText;

// "from", "to"
extern const char* const swDirectionWords[];

// The mapping `replay`.
swResult swReadReplay(swYaml* yaml, yaml_node_t* node, swMeasuredText* text);

// Read the files, and let the wave system be of the record or the records that are asked for. What is read belongs to
// `waves` also if this fails.
swResult swReadSceneMeasured(swYaml* yaml, const swMeasuredText* text, swSceneWaves* waves);

// When the scene's time is known: the record that each replay is nearest to then.
void swChooseReplayRecords(swScene* scene);
