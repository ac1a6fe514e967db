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
const swFields* swGetInputPointFields(void);  // of swInputPoint

// Put a scene's inputs into a world whose wave systems the sea has. On failure the sea has those that were made.
swResult swCreateSceneInputs(swWorld* world, const swScene* scene, swSceneSea* sea);
swResult swCreateSceneBodies(swWorld* world, const swScene* scene, swSceneSea* sea);
swResult swCreateSceneWindSeas(swWorld* world, const swScene* scene, swSceneSea* sea);
void swRemoveSceneInputs(swWorld* world, swSceneSea* sea);
swResult swMakeRoomForInputs(const swScene* scene, swSceneSea* sea);
void swFreeSceneSeaInputs(swSceneSea* sea);
