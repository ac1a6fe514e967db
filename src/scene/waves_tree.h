// SPDX-License-Identifier: MIT
#pragma once

// A wave system as keys and values of a tree.

#include "scene/scene_fields.h"
#include "scene/yaml_tree.h"

// One system to be written, and how.
typedef struct swWavesWriter
{
    const swScene* scene;
    const swSceneWaves* waves;
    swWavesText text; // the file's, or what a new system is told by
    int record;       // as it was read
    const swSeaReplayDef* replay;
    bool isNew;
    bool isBroken; // memory has run out
} swWavesWriter;

// The pairs of a system, told by the kind that writer->text has.
void swFillWavesTree(swTree* tree, int parent, const swWavesWriter* writer);
