// SPDX-License-Identifier: MIT
#pragma once

// What a host would put into the sea, as scene files have it: rasters and splines with names, and inputs that use them.

#include "scene/yaml_read.h"
#include "seaway/scene.h"

// Keys of a scene's top level; their nodes are read by swReadSceneInputs(), when all of them are known.
void swAddInputKeys(swYamlMapping* mapping);

// Rasters, splines, then inputs. `opensNone`: no file is read, so inputs have no rasters.
swResult swReadSceneInputs(swYaml* yaml, const swYamlMapping* mapping, const char* folder, bool opensNone,
                           swScene* scene);
void swFreeSceneInputs(swScene* scene);

// Tables of what is no def.
const swFields* swGetSceneRasterFields(void); // of swSceneRaster
const swFields* swGetSceneMeshFields(void);   // of swSceneMesh
const swFields* swGetSceneHullFields(void);   // of swSceneHull

// Put a scene's seas by a wind map, bodies of water and inputs into a world whose wave systems the sea has. On failure
// none of them is there.
swResult swAddSceneInputs(swWorld* world, const swScene* scene, swSceneSea* sea);
swResult swCreateSceneBodies(swWorld* world, const swScene* scene, swSceneSea* sea);
swResult swCreateSceneWindSeas(swWorld* world, const swScene* scene, swSceneSea* sea);
// Move those that move by themselves to where they are at a time.
swResult swAdvanceSceneInputs(const swSceneSea* sea, double time);
void swFreeSceneSeaInputs(swSceneSea* sea);
