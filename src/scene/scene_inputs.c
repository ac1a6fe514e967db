// SPDX-License-Identifier: MIT
// Inputs of a scene file.

#include "scene/scene_inputs.h"

#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "scene/scene_lists.h"

// Keys of an input beside its def's fields.
typedef struct InputKeys
{
    swSceneInput* input;
    swYamlMapping mapping;
} InputKeys;

static bool hasKey(const InputKeys* keys, const char* key)
{
    return swGetYamlNode(&keys->mapping, key) != NULL;
}

// A point is a mapping of its fields, or [x, z].
static swResult readPoint(swYaml* yaml, yaml_node_t* node, int wanted, swInputPoint* point)
{
    swFillDef(swGetInputPointFields(), point);
    if (node->type == YAML_SEQUENCE_NODE)
    {
        float numbers[4] = {0.0f};
        swResult result = swReadYamlNumbers(yaml, node, "a point [x, z]", 2, numbers);
        point->x = numbers[0];
        point->z = numbers[1];
        return result;
    }
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a point");
    swAddYamlFields(&mapping, swGetInputPointFields(), 0, "points");
    swAddYamlKey(&mapping, "value", swKeepYamlNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, point);
    yaml_node_t* value = node->type == YAML_MAPPING_NODE ? swGetYamlNode(&mapping, "value") : NULL;
    return value != NULL ? swKeepFailure(result, swReadYamlNumbers(yaml, value, "value", wanted, point->value))
                         : result;
}

static swResult readPoints(swYaml* yaml, yaml_node_t* node, swSceneInput* input)
{
    int wanted = swInputField_CountNumbers(input->def.field);
    swResult result = swAllocateYamlItems(yaml, node, "points", SW_MAX_INPUT_POINTS, sizeof(swInputPoint),
                                          (void**)&input->points, &input->pointCount);
    for (int i = 0; i < input->pointCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readPoint(yaml, swGetYamlItem(yaml, node, i), wanted, &input->points[i]));
    }
    input->def.points = input->points;
    input->def.pointCount = input->pointCount;
    return result;
}

// What a shape needs beside its def's fields.
typedef struct Need
{
    swInputShape shape;
    const char* key;
} Need;

static const Need needs[] = {
    {SW_SHAPE_RASTER, "raster"},    {SW_SHAPE_POLYGON, "points"}, {SW_SHAPE_POLYLINE, "points"},
    {SW_SHAPE_PARTICLES, "points"}, {SW_SHAPE_SPLINE, "spline"},  {SW_SHAPE_MESH, "mesh"},
    {SW_SHAPE_HULL, "hull"},
};

static bool isNeeded(swInputShape shape, const char* key)
{
    for (size_t i = 0; i < sizeof(needs) / sizeof(needs[0]); ++i)
    {
        if (needs[i].shape == shape && strcmp(needs[i].key, key) == 0)
        {
            return true;
        }
    }
    return false;
}

// A raster, or a nest of them.
static swResult checkNest(swYaml* yaml, const InputKeys* keys)
{
    yaml_node_t* nest = swGetYamlNode(&keys->mapping, "nest");
    if (nest != NULL && keys->input->def.shape != SW_SHAPE_RASTER)
    {
        return swFailYaml(yaml, nest, SW_MISTAKE_NO_EFFECT,
                          "nest has an effect on the shape 'raster' alone; remove it.");
    }
    return nest != NULL && hasKey(keys, "raster")
               ? swFailYaml(yaml, nest, SW_MISTAKE_CONFLICT, "nest stands beside raster; remove one.")
               : SW_SUCCESS;
}

// Keys that are missing, and keys that say nothing beside the others.
static swResult checkKeys(swYaml* yaml, yaml_node_t* node, const InputKeys* keys)
{
    static const char* const others[] = {"raster", "points", "spline", "mesh", "hull"};
    const swInputDef* def = &keys->input->def;
    const char* shape = swFields_Find(swGetInputFields(), "shape")->words[def->shape];
    swResult result = checkNest(yaml, keys);
    if (def->shape == SW_SHAPE_FUNCTION)
    {
        return swFailYaml(yaml, swGetYamlNode(&keys->mapping, "shape"), SW_MISTAKE_UNKNOWN_WORD,
                          "the shape 'function' is of hosts that have one; a scene file takes a raster instead.");
    }
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        bool needed = isNeeded(def->shape, others[i]);
        if (needed && !hasKey(keys, others[i]) && !(i == 0 && hasKey(keys, "nest")))
        {
            result = swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the shape '%s' needs %s.", shape, others[i]);
        }
        if (!needed && hasKey(keys, others[i]))
        {
            result = swFailYaml(yaml, swGetYamlNode(&keys->mapping, others[i]), SW_MISTAKE_NO_EFFECT,
                                "%s has no effect on the shape '%s'; remove it.", others[i], shape);
        }
    }
    for (int i = 0; i < keys->mapping.count; ++i)
    {
        const swYamlKey* key = &keys->mapping.keys[i];
        if (key->node != NULL && key->field != NULL && !swFields_Counts(key->fields, key->field, def))
        {
            result = swFailYaml(yaml, key->node, SW_MISTAKE_NO_EFFECT, "%s has no effect on the shape '%s'; remove it.",
                                key->key, shape);
        }
    }
    return result;
}

// Which of the scene's wave systems it weighs: all where the file says nothing.
static swResult readWaves(swYaml* yaml, const InputKeys* keys, const swScene* scene)
{
    swSceneInput* input = keys->input;
    yaml_node_t* waves = swGetYamlNode(&keys->mapping, "waves");
    input->waves = -1;
    if (waves != NULL && input->def.field != SW_INPUT_WAVES)
    {
        return swFailYaml(yaml, waves, SW_MISTAKE_NO_EFFECT, "waves has no effect on this field; remove it.");
    }
    return waves != NULL ? swReadWavesNumber(yaml, waves, scene, &input->waves) : SW_SUCCESS;
}

static swResult findResource(swYaml* yaml, const InputKeys* keys, const char* key, const void* items, size_t size,
                             int count, int* index)
{
    yaml_node_t* node = swGetYamlNode(&keys->mapping, key);
    char name[64] = "";
    *index = -1;
    if (node == NULL || !isNeeded(keys->input->def.shape, key))
    {
        return SW_SUCCESS;
    }
    swResult result = swReadYamlText(yaml, node, key, name, sizeof(name));
    *index = result == SW_SUCCESS ? swFindYamlName(items, size, count, name) : -1;
    return result == SW_SUCCESS && *index < 0
               ? swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD,
                            "there is no %s named '%s'; the scene's list of %ss has %d.", key, name, key, count)
               : result;
}

// Rasters of a nest; those of optional files that are not there are left out.
static swResult readNest(swYaml* yaml, yaml_node_t* node, const swScene* scene, swSceneInput* input)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "nest", SW_MAX_NEST, &count);
    input->nest = count > 0 ? swAllocateZero(yaml->host, SW_MAX_NEST * sizeof(*input->nest)) : NULL;
    if (count > 0 && input->nest == NULL)
    {
        return swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for a nest of %s.", yaml->name);
    }
    if (count == 0)
    {
        return swKeepFailure(
            result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "nest is empty; name the rasters that it has."));
    }
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        char name[64] = "";
        yaml_node_t* item = swGetYamlItem(yaml, node, i);
        swResult own = swReadYamlText(yaml, item, "nest", name, sizeof(name));
        int index =
            own == SW_SUCCESS ? swFindYamlName(scene->rasters, sizeof(swSceneRaster), scene->rasterCount, name) : -1;
        if (own == SW_SUCCESS && index < 0)
        {
            own = swFailYaml(yaml, item, SW_MISTAKE_UNKNOWN_WORD,
                             "there is no raster named '%s'; the scene's list of rasters has %d.", name,
                             scene->rasterCount);
        }
        if (index >= 0 && scene->rasters[index].raster != NULL)
        {
            input->nest[input->nestCount++] = scene->rasters[index].raster;
        }
        result = swKeepFailure(result, own);
    }
    input->isLeftOut = input->nestCount == 0;
    return result;
}

static swResult findResources(swYaml* yaml, const InputKeys* keys, const swScene* scene)
{
    swSceneInput* input = keys->input;
    swInputDef* def = &input->def;
    int raster = -1, spline = -1, mesh = -1, hull = -1;
    swResult result =
        findResource(yaml, keys, "raster", scene->rasters, sizeof(swSceneRaster), scene->rasterCount, &raster);
    result = swKeepFailure(
        result, findResource(yaml, keys, "spline", scene->splines, sizeof(swSceneSpline), scene->splineCount, &spline));
    result = swKeepFailure(
        result, findResource(yaml, keys, "mesh", scene->meshes, sizeof(swSceneMesh), scene->meshCount, &mesh));
    result = swKeepFailure(
        result, findResource(yaml, keys, "hull", scene->hulls, sizeof(swSceneHull), scene->hullCount, &hull));
    def->raster = raster >= 0 ? scene->rasters[raster].raster : NULL;
    def->spline = spline >= 0 ? scene->splines[spline].spline : NULL;
    def->mesh = mesh >= 0 ? scene->meshes[mesh].mesh : NULL;
    def->hull = hull >= 0 ? scene->hulls[hull].hull : NULL;
    input->resource = raster >= 0 ? raster : spline >= 0 ? spline : mesh >= 0 ? mesh : hull;
    input->isLeftOut = raster >= 0 && scene->rasters[raster].isOptional && def->raster == NULL;
    yaml_node_t* nest = swGetYamlNode(&keys->mapping, "nest");
    return nest != NULL ? swKeepFailure(result, readNest(yaml, nest, scene, input)) : result;
}

// A key that only some inputs can have.
static swResult refuseKey(swYaml* yaml, const yaml_node_t* node, const char* key, const char* where)
{
    return swFailYaml(yaml, node, SW_MISTAKE_NO_EFFECT, "%s has %s; remove it.", key, where);
}

// The tide of a level or a flow.
static swResult readTide(swYaml* yaml, const InputKeys* keys, const swSceneReader* reader)
{
    swInputDef* def = &keys->input->def;
    yaml_node_t* node = swGetYamlNode(&keys->mapping, "tide");
    const swTideReader tide = {.reader = reader,
                               .isFlow = def->field == SW_INPUT_FLOW,
                               .value = def->value,
                               .constituents = def->tide,
                               .table = &keys->input->tide};
    if (node == NULL)
    {
        return SW_SUCCESS;
    }
    if (def->field != SW_INPUT_LEVEL && def->field != SW_INPUT_FLOW)
    {
        return refuseKey(yaml, node, "tide", "an effect on level and flow alone");
    }
    swResult result = swReadTide(yaml, node, &tide);
    return result == SW_SUCCESS && keys->input->tide.count > 0 && hasKey(keys, "nest")
               ? swFailYaml(yaml, node, SW_MISTAKE_CONFLICT, "a tide by a table stands beside nest; remove one.")
               : result;
}

static swResult readMotion(swYaml* yaml, const InputKeys* keys)
{
    yaml_node_t* node = swGetYamlNode(&keys->mapping, "motion");
    const swFields* fields = swGetInputFields();
    if (node == NULL)
    {
        return SW_SUCCESS;
    }
    if (!swFields_Counts(fields, swFields_Find(fields, "position"), &keys->input->def))
    {
        return refuseKey(yaml, node, "motion", "no effect on what is everywhere");
    }
    return hasKey(keys, "nest") ? swFailYaml(yaml, node, SW_MISTAKE_CONFLICT, "motion stands beside nest; remove one.")
                                : swReadMotion(yaml, node, &keys->input->motion);
}

static swResult readInput(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    InputKeys keys = {.input = &reader->scene->inputs[index]};
    swSceneInput* input = keys.input;
    input->def = swDefaultInputDef();
    input->waves = -1;
    input->resource = -1;
    input->item = index + 1;
    input->line = (int)node->start_mark.line + 1;
    swBeginYamlMapping(&keys.mapping, "an input");
    swAddYamlKey(&keys.mapping, "value", swKeepYamlNode);
    swAddYamlFields(&keys.mapping, swGetInputFields(), 0, "inputs");
    static const char* const others[] = {"waves",  "raster", "nest",   "mesh",  "hull",
                                         "spline", "tide",   "points", "motion"};
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        swAddYamlKey(&keys.mapping, others[i], swKeepYamlNode);
    }
    swResult result = swReadYamlMapping(yaml, node, &keys.mapping, &input->def);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    if (!hasKey(&keys, "field"))
    {
        result = swKeepFailure(result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                  "the input has no field; name what it says, such as level."));
    }
    result = swKeepFailure(result, checkKeys(yaml, node, &keys));
    result = swKeepFailure(result, readWaves(yaml, &keys, reader->scene));
    result = swKeepFailure(result, findResources(yaml, &keys, reader->scene));
    yaml_node_t *value = swGetYamlNode(&keys.mapping, "value"), *points = swGetYamlNode(&keys.mapping, "points");
    if (value != NULL)
    {
        result =
            swKeepFailure(result, swReadYamlNumbers(yaml, value, "value", swInputField_CountNumbers(input->def.field),
                                                    input->def.value));
    }
    result = swKeepFailure(result, readTide(yaml, &keys, reader));
    result = swKeepFailure(result, readMotion(yaml, &keys));
    return points != NULL ? swKeepFailure(result, readPoints(yaml, points, input)) : result;
}

swResult swReadInputs(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "inputs", SW_MAX_SCENE_INPUTS, sizeof(swSceneInput),
                                          (void**)&scene->inputs, &scene->inputCount);
    for (int i = 0; i < scene->inputCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readInput(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

void swFreeInput(const swHost* host, swSceneInput* input)
{
    swFree(host, input->points, (size_t)input->pointCount * sizeof(swInputPoint));
    swFreeTide(host, &input->tide);
    swFreeMotion(host, &input->motion);
    swFree(host, input->nest, input->nest != NULL ? SW_MAX_NEST * sizeof(*input->nest) : 0);
}

void swFreeInputs(swScene* scene)
{
    for (int i = 0; i < scene->inputCount; ++i)
    {
        swFreeInput(&scene->host, &scene->inputs[i]);
    }
    swFree(&scene->host, scene->inputs, (size_t)scene->inputCount * sizeof(swSceneInput));
    scene->inputCount = 0;
    scene->inputs = NULL;
}
