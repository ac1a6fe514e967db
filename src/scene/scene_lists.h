// SPDX-License-Identifier: MIT
#pragma once

// What lists of a scene file share whose items have names and whose lengths are not known before.

#include "files/file_text.h"
#include "scene/yaml_read.h"
#include "scene/yaml_tree.h"
#include "seaway/scene.h"

// Where a scene's files are.
typedef struct swSceneReader
{
    const char* folder;
    bool opensNone; // no file is read
    swScene* scene;
} swSceneReader;

// A key that is read later, when all keys are known.
swResult swKeepYamlNode(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target);

// Room for the items of a list, all zero; `items` stays NULL where there are none.
swResult swAllocateYamlItems(swYaml* yaml, yaml_node_t* node, const char* what, int most, size_t size, void** items,
                             int* count);

// Items whose structs begin with a name: the index of one, or -1; and whether an item's name is there and its own.
int swFindYamlName(const void* items, size_t size, int count, const char* name);
swResult swCheckYamlName(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping, const char* what,
                         const void* items, size_t size, int index);

// One number, or a list of `wanted` (at most 4), which are no field by themselves.
swResult swReadYamlNumbers(swYaml* yaml, yaml_node_t* node, const char* what, int wanted, float numbers[4]);

// One number within +-most.
swResult swReadYamlNumber(swYaml* yaml, const yaml_node_t* node, const char* what, double most, double* number);

// The number of one of the scene's wave systems, from 1 on, as an index.
swResult swReadWavesNumber(swYaml* yaml, yaml_node_t* node, const swScene* scene, int* waves);

// scene_resources.c
swResult swReadRasters(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
swResult swReadMeshes(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
swResult swReadSplines(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
void swFreeSceneResources(swScene* scene);

// What the world refused, after its own message: "file:line: input 3 cannot be made ... [refused]". Returns `result`.
swResult swTellRefused(const swScene* scene, swResult result, int line, const char* what, int index);

// The path of a file that a scene names.
void swJoinScenePath(const char* folder, const char* file, char path[SW_MAX_PATH]);

// scene_hulls.c
swResult swReadHulls(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
void swFreeHulls(swScene* scene);

// scene_tide.c: the constituents of a level, or of a flow; or a table, here or in a file.
typedef struct swTideReader
{
    const swSceneReader* reader;
    bool isFlow;
    const float* value;              // that the table adds to
    swTideConstituent* constituents; // [SW_MAX_TIDE]
    swSceneTide* table;
} swTideReader;

swResult swReadTide(swYaml* yaml, yaml_node_t* node, const swTideReader* tide);
void swFreeTide(const swHost* host, swSceneTide* tide);
// The name of a constituent of this speed; NULL if none is known.
const char* swFindTideName(float speed);

// scene_motion.c
swResult swReadMotion(swYaml* yaml, yaml_node_t* node, swSceneMotion* motion);
void swFreeMotion(const swHost* host, swSceneMotion* motion);

// scene_wind_seas.c
swResult swReadWindSeas(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
void swFreeWindSeas(swScene* scene);

// scene_inputs.c
swResult swReadInputs(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
void swFreeInput(const swHost* host, swSceneInput* input);
void swFreeInputs(swScene* scene);

// scene_bodies.c: other looks of water, and bodies that have them.
swResult swReadLooks(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
swResult swReadWaterBodies(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader);
void swFreeWaterBodies(swScene* scene);

// ---- writing ----

// The number of one of the scene's wave systems; none for -1.
void swAddWavesNumber(swTree* tree, int parent, int waves);
// Fields of a def that count and that scene files have.
void swAddCountedFields(swTree* tree, int parent, const swFields* fields, const void* def);
// A list of [x, z] or of mappings, in the order of the text's.
void swAddPointTrees(swTree* tree, int parent, int count, const swInputPoint* points, int valueCount);
void swAddShoreTrees(swTree* tree, int parent, int count, const swVec2* points);
void swAddTideTrees(swTree* tree, int parent, const swTideConstituent tide[SW_MAX_TIDE], bool isFlow);
// An item for each input, and for each body of water.
void swAddInputTrees(swTree* tree, int list, const swScene* scene);
void swAddBodyTrees(swTree* tree, int list, const swScene* scene);
