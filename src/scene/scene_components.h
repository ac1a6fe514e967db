// SPDX-License-Identifier: MIT
#pragma once

// Waves given by hand in a scene file.

#include "scene/yaml_read.h"
#include "seaway/scene.h"

// Read the list into waves->components, which swFreeComponents() frees.
swResult swReadComponents(swYaml* yaml, yaml_node_t* node, swSceneWaves* waves);
void swFreeComponents(const swHost* host, swSceneWaves* waves);
