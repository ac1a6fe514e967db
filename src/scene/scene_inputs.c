// SPDX-License-Identifier: MIT
// Rasters, splines and inputs of a scene file. Lists stand in any order; an input names what it uses, so all are read
// once the whole file is known.

#include "scene/scene_inputs.h"

#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "files/file_text.h"
#include "scene/exact_number.h"

typedef struct Reader
{
    const char* folder;
    bool opensNone;
    swScene* scene;
} Reader;

// Read later, when all keys are known.
static swResult keepNode(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    (void)yaml;
    (void)node;
    (void)key;
    (void)target;
    return SW_SUCCESS;
}

void swAddInputKeys(swYamlMapping* mapping)
{
    swAddYamlKey(mapping, "rasters", keepNode);
    swAddYamlKey(mapping, "splines", keepNode);
    swAddYamlKey(mapping, "inputs", keepNode);
}

// Room for the items of a list, all zero; `items` stays NULL where there are none.
static swResult allocateItems(swYaml* yaml, yaml_node_t* node, const char* what, int most, size_t size, void** items,
                              int* count)
{
    swResult result = swReadYamlList(yaml, node, what, most, count);
    if (*count == 0)
    {
        return result;
    }
    *items = swAllocateZero(yaml->host, (size_t)*count * size);
    if (*items == NULL)
    {
        swResult failed =
            swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for %d %s of %s.", *count, what, yaml->name);
        *count = 0;
        return failed;
    }
    return result;
}

// ---- names ----

// A resource's name, which stands first in its struct, so that lists of all kinds are searched alike.
static const char* getName(const void* items, size_t size, int index)
{
    return (const char*)items + (size_t)index * size;
}

static int findName(const void* items, size_t size, int count, const char* name)
{
    for (int i = 0; i < count; ++i)
    {
        if (strcmp(getName(items, size, i), name) == 0)
        {
            return i;
        }
    }
    return -1;
}

static swResult checkName(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping, const char* what,
                          const void* items, size_t size, int index)
{
    if (node->type != YAML_MAPPING_NODE)
    {
        return SW_SUCCESS; // told already
    }
    const yaml_node_t* name = swGetYamlNode(mapping, "name");
    if (name == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the %s has no name; inputs use it by its name.", what);
    }
    const char* own = getName(items, size, index);
    return own[0] != '\0' && findName(items, size, index, own) >= 0
               ? swFailYaml(yaml, name, SW_MISTAKE_REPEATED, "a %s named '%s' stands above; names must differ.", what,
                            own)
               : SW_SUCCESS;
}

static void joinPath(const char* folder, const char* file, char path[SW_MAX_PATH])
{
    bool isOwn = folder == NULL || folder[0] == '\0' || file[0] == '/';
    snprintf(path, SW_MAX_PATH, "%s%s%s", isOwn ? "" : folder, isOwn ? "" : "/", file);
}

// ---- rasters ----

static swResult openRaster(swYaml* yaml, const yaml_node_t* node, const Reader* reader, swSceneRaster* raster)
{
    char path[SW_MAX_PATH];
    joinPath(reader->folder, raster->file, path);
    raster->def.variable = raster->variable[0] != '\0' ? raster->variable : NULL;
    swResult result = reader->opensNone ? SW_SUCCESS : swReadRaster(yaml->host, path, &raster->def, &raster->raster);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE,
                            "the raster '%s' cannot be read from %s; the message before says why.", raster->name,
                            raster->file);
}

static swResult readRaster(swYaml* yaml, yaml_node_t* node, const Reader* reader, int index)
{
    swSceneRaster* raster = &reader->scene->rasters[index];
    swFillDef(swGetSceneRasterFields(), raster);
    raster->def = swDefaultRasterFileDef();
    raster->item = index + 1;
    raster->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a raster");
    swAddYamlFields(&mapping, swGetSceneRasterFields(), 0, "rasters");
    swResult result = swReadYamlMapping(yaml, node, &mapping, raster);
    result = swKeepFailure(
        result, checkName(yaml, node, &mapping, "raster", reader->scene->rasters, sizeof(swSceneRaster), index));
    if (node->type == YAML_MAPPING_NODE && swGetYamlNode(&mapping, "file") == NULL)
    {
        result = swKeepFailure(result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                  "the raster has no file; name the one that holds its numbers."));
    }
    return result == SW_SUCCESS ? openRaster(yaml, swGetYamlNode(&mapping, "file"), reader, raster) : result;
}

static swResult readRasters(swYaml* yaml, yaml_node_t* node, const Reader* reader)
{
    swScene* scene = reader->scene;
    swResult result = allocateItems(yaml, node, "rasters", SW_MAX_SCENE_RESOURCES, sizeof(swSceneRaster),
                                    (void**)&scene->rasters, &scene->rasterCount);
    for (int i = 0; i < scene->rasterCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readRaster(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

// ---- splines ----

static swResult readSplinePoint(swYaml* yaml, yaml_node_t* node, swSplinePoint* point)
{
    *point = swDefaultSplinePoint(0.0, 0.0, 0.0);
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a point of a spline");
    swAddYamlFields(&mapping, swGetSplinePointFields(), 0, "spline_points");
    return swReadYamlMapping(yaml, node, &mapping, point);
}

static swResult readSplinePoints(swYaml* yaml, yaml_node_t* node, swSceneSpline* spline)
{
    swResult result = allocateItems(yaml, node, "points", SW_MAX_SPLINE_POINTS, sizeof(swSplinePoint),
                                    (void**)&spline->points, &spline->pointCount);
    for (int i = 0; i < spline->pointCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readSplinePoint(yaml, swGetYamlItem(yaml, node, i), &spline->points[i]));
    }
    spline->def.points = spline->points;
    spline->def.pointCount = spline->pointCount;
    return result;
}

static swResult makeSpline(swYaml* yaml, const yaml_node_t* node, swSceneSpline* spline)
{
    spline->def.name = spline->name;
    swResult result = swCreateSpline(yaml->host, &spline->def, &spline->spline);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE,
                            "the spline '%s' cannot be made; the message before says why.", spline->name);
}

static swResult readSplineName(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swSceneSpline* spline = target;
    return swReadYamlText(yaml, node, key->key, spline->name, sizeof(spline->name));
}

static swResult readSpline(swYaml* yaml, yaml_node_t* node, const Reader* reader, int index)
{
    swSceneSpline* spline = &reader->scene->splines[index];
    spline->def = swDefaultSplineDef();
    spline->item = index + 1;
    spline->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a spline");
    swAddYamlKey(&mapping, "name", readSplineName);
    swAddYamlFields(&mapping, swGetSplineFields(), offsetof(swSceneSpline, def), "splines");
    swAddYamlKey(&mapping, "points", keepNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, spline);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    result = swKeepFailure(
        result, checkName(yaml, node, &mapping, "spline", reader->scene->splines, sizeof(swSceneSpline), index));
    yaml_node_t* points = swGetYamlNode(&mapping, "points");
    result = swKeepFailure(result, points != NULL ? readSplinePoints(yaml, points, spline)
                                                  : swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                               "the spline has no points; give it two or more."));
    return result == SW_SUCCESS ? makeSpline(yaml, node, spline) : result;
}

static swResult readSplines(swYaml* yaml, yaml_node_t* node, const Reader* reader)
{
    swScene* scene = reader->scene;
    swResult result = allocateItems(yaml, node, "splines", SW_MAX_SCENE_RESOURCES, sizeof(swSceneSpline),
                                    (void**)&scene->splines, &scene->splineCount);
    for (int i = 0; i < scene->splineCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readSpline(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

// ---- inputs ----

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

// A number of a list that is no field by itself.
static swResult readNumber(swYaml* yaml, const yaml_node_t* node, const char* what, float* number)
{
    double value = 0.0;
    bool isNumber = node->type == YAML_SCALAR_NODE &&
                    swParseExactNumber((const char*)node->data.scalar.value, (int)node->data.scalar.length, &value);
    if (!isNumber || !(value >= -1e6 && value <= 1e6))
    {
        return swFailYaml(yaml, node, isNumber ? SW_MISTAKE_OUT_OF_RANGE : SW_MISTAKE_WRONG_FORM,
                          "%s must be a number from -1e+06 to 1e+06.", what);
    }
    *number = (float)value;
    return SW_SUCCESS;
}

// One number, or a list of as many as the field has.
static swResult readNumbers(swYaml* yaml, yaml_node_t* node, const char* what, int wanted, float numbers[4])
{
    if (node->type == YAML_SCALAR_NODE && wanted == 1)
    {
        return readNumber(yaml, node, what, &numbers[0]);
    }
    int count = 0;
    swResult result = swReadYamlList(yaml, node, what, 4, &count);
    if (result == SW_SUCCESS && count != wanted)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_WRONG_FORM, "%s has %d numbers; the field has %d.", what, count,
                          wanted);
    }
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        result = readNumber(yaml, swGetYamlItem(yaml, node, i), what, &numbers[i]);
    }
    return result;
}

static int countNumbers(swInputField field)
{
    switch (field)
    {
    case SW_INPUT_ALBEDO:
        return 4;
    case SW_INPUT_DISPLACEMENT:
        return 3;
    case SW_INPUT_FLOW:
    case SW_INPUT_WIND:
        return 2;
    default:
        return 1;
    }
}

// A point is a mapping of its fields, or [x, z].
static swResult readPoint(swYaml* yaml, yaml_node_t* node, int wanted, swInputPoint* point)
{
    swFillDef(swGetInputPointFields(), point);
    if (node->type == YAML_SEQUENCE_NODE)
    {
        float numbers[4] = {0.0f};
        swResult result = readNumbers(yaml, node, "a point [x, z]", 2, numbers);
        point->x = numbers[0];
        point->z = numbers[1];
        return result;
    }
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a point");
    swAddYamlFields(&mapping, swGetInputPointFields(), 0, "points");
    swAddYamlKey(&mapping, "value", keepNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, point);
    yaml_node_t* value = node->type == YAML_MAPPING_NODE ? swGetYamlNode(&mapping, "value") : NULL;
    return value != NULL ? swKeepFailure(result, readNumbers(yaml, value, "value", wanted, point->value)) : result;
}

static swResult readPoints(swYaml* yaml, yaml_node_t* node, swSceneInput* input)
{
    int wanted = countNumbers(input->def.field);
    swResult result = allocateItems(yaml, node, "points", SW_MAX_INPUT_POINTS, sizeof(swInputPoint),
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
    {SW_SHAPE_PARTICLES, "points"}, {SW_SHAPE_SPLINE, "spline"},
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

// Keys that are missing, and keys that say nothing beside the others.
static swResult checkKeys(swYaml* yaml, yaml_node_t* node, const InputKeys* keys)
{
    static const char* const others[] = {"raster", "points", "spline"};
    const swInputDef* def = &keys->input->def;
    const char* shape = swFields_Find(swGetInputFields(), "shape")->words[def->shape];
    swResult result = SW_SUCCESS;
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        bool needed = isNeeded(def->shape, others[i]);
        if (needed && !hasKey(keys, others[i]))
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

// The number of a wave system in the scene's list, counted from 1.
static swResult readWaves(swYaml* yaml, yaml_node_t* node, const InputKeys* keys, const swScene* scene)
{
    swSceneInput* input = keys->input;
    yaml_node_t* waves = swGetYamlNode(&keys->mapping, "waves");
    bool isWeight = input->def.field == SW_INPUT_WAVES;
    input->waves = -1;
    if (waves == NULL || !isWeight)
    {
        return isWeight ? swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                     "the field 'waves' needs waves: which of the scene's waves it weighs, 1 to %d.",
                                     scene->wavesCount)
               : waves != NULL
                   ? swFailYaml(yaml, waves, SW_MISTAKE_NO_EFFECT, "waves has no effect on this field; remove it.")
                   : SW_SUCCESS;
    }
    float number = 0.0f;
    swResult result = readNumber(yaml, waves, "waves", &number);
    if (result == SW_SUCCESS && !(number >= 1.0f && number <= (float)scene->wavesCount && number == (float)(int)number))
    {
        return swFailYaml(yaml, waves, SW_MISTAKE_OUT_OF_RANGE,
                          "waves is %g; it is the number of one of the scene's waves, 1 to %d.", (double)number,
                          scene->wavesCount);
    }
    input->waves = (int)number - 1;
    return result;
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
    *index = result == SW_SUCCESS ? findName(items, size, count, name) : -1;
    return result == SW_SUCCESS && *index < 0
               ? swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD,
                            "there is no %s named '%s'; the scene's list of %ss has %d.", key, name, key, count)
               : result;
}

static swResult findResources(swYaml* yaml, const InputKeys* keys, const swScene* scene)
{
    int index = -1;
    swResult result =
        findResource(yaml, keys, "raster", scene->rasters, sizeof(swSceneRaster), scene->rasterCount, &index);
    keys->input->def.raster = index >= 0 ? scene->rasters[index].raster : NULL;
    result = swKeepFailure(
        result, findResource(yaml, keys, "spline", scene->splines, sizeof(swSceneSpline), scene->splineCount, &index));
    keys->input->def.spline = index >= 0 ? scene->splines[index].spline : NULL;
    return result;
}

static swResult readInput(swYaml* yaml, yaml_node_t* node, const Reader* reader, int index)
{
    InputKeys keys = {.input = &reader->scene->inputs[index]};
    swSceneInput* input = keys.input;
    input->def = swDefaultInputDef();
    input->waves = -1;
    input->item = index + 1;
    input->line = (int)node->start_mark.line + 1;
    swBeginYamlMapping(&keys.mapping, "an input");
    swAddYamlKey(&keys.mapping, "value", keepNode);
    swAddYamlFields(&keys.mapping, swGetInputFields(), 0, "inputs");
    swAddYamlKey(&keys.mapping, "waves", keepNode);
    swAddYamlKey(&keys.mapping, "raster", keepNode);
    swAddYamlKey(&keys.mapping, "spline", keepNode);
    swAddYamlKey(&keys.mapping, "points", keepNode);
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
    result = swKeepFailure(result, readWaves(yaml, node, &keys, reader->scene));
    result = swKeepFailure(result, findResources(yaml, &keys, reader->scene));
    yaml_node_t *value = swGetYamlNode(&keys.mapping, "value"), *points = swGetYamlNode(&keys.mapping, "points");
    if (value != NULL)
    {
        result =
            swKeepFailure(result, readNumbers(yaml, value, "value", countNumbers(input->def.field), input->def.value));
    }
    return points != NULL ? swKeepFailure(result, readPoints(yaml, points, input)) : result;
}

static swResult readInputs(swYaml* yaml, yaml_node_t* node, const Reader* reader)
{
    swScene* scene = reader->scene;
    swResult result = allocateItems(yaml, node, "inputs", SW_MAX_SCENE_INPUTS, sizeof(swSceneInput),
                                    (void**)&scene->inputs, &scene->inputCount);
    for (int i = 0; i < scene->inputCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readInput(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

swResult swReadSceneInputs(swYaml* yaml, const swYamlMapping* mapping, const char* folder, bool opensNone,
                           swScene* scene)
{
    const Reader reader = {folder, opensNone, scene};
    swResult result = SW_SUCCESS;
    const struct
    {
        const char* key;
        swResult (*read)(swYaml*, yaml_node_t*, const Reader*);
    } lists[] = {{"rasters", readRasters}, {"splines", readSplines}, {"inputs", readInputs}};
    for (size_t i = 0; i < sizeof(lists) / sizeof(lists[0]); ++i)
    {
        yaml_node_t* node = swGetYamlNode(mapping, lists[i].key);
        if (node != NULL && !swIsYamlOver(yaml, result))
        {
            result = swKeepFailure(result, lists[i].read(yaml, node, &reader));
        }
    }
    return result;
}

void swFreeSceneInputs(swScene* scene)
{
    for (int i = 0; i < scene->inputCount; ++i)
    {
        swSceneInput* input = &scene->inputs[i];
        swFree(&scene->host, input->points, (size_t)input->pointCount * sizeof(swInputPoint));
    }
    for (int i = 0; i < scene->rasterCount; ++i)
    {
        swDestroyRaster(scene->rasters[i].raster);
    }
    for (int i = 0; i < scene->splineCount; ++i)
    {
        swSceneSpline* spline = &scene->splines[i];
        swDestroySpline(spline->spline);
        swFree(&scene->host, spline->points, (size_t)spline->pointCount * sizeof(swSplinePoint));
    }
    swFree(&scene->host, scene->inputs, (size_t)scene->inputCount * sizeof(swSceneInput));
    swFree(&scene->host, scene->splines, (size_t)scene->splineCount * sizeof(swSceneSpline));
    swFree(&scene->host, scene->rasters, (size_t)scene->rasterCount * sizeof(swSceneRaster));
    scene->inputCount = scene->rasterCount = scene->splineCount = 0;
    scene->inputs = NULL;
    scene->splines = NULL;
    scene->rasters = NULL;
}

// ---- in a world ----

void swFreeSceneSeaInputs(swSceneSea* sea)
{
    if (sea->inputs != NULL)
    {
        swFree(&sea->host, sea->inputs, (size_t)sea->inputRoom * sizeof(swInputId));
    }
    sea->inputs = NULL;
    sea->inputCount = sea->inputRoom = 0;
}

swResult swCreateSceneInputs(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    if (scene->inputCount == 0)
    {
        return SW_SUCCESS;
    }
    sea->inputs = swAllocateZero(&scene->host, (size_t)scene->inputCount * sizeof(swInputId));
    if (sea->inputs == NULL)
    {
        return swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for %d inputs of the scene '%s'.", scene->inputCount,
                      scene->name);
    }
    sea->host = scene->host;
    sea->inputRoom = scene->inputCount;
    for (int i = 0; i < scene->inputCount; ++i)
    {
        swInputDef def = scene->inputs[i].def;
        def.system = scene->inputs[i].waves >= 0 ? sea->systems[scene->inputs[i].waves] : def.system;
        swResult result = swCreateInput(world, &def, &sea->inputs[i]);
        if (result != SW_SUCCESS)
        {
            swLog(&scene->host, SW_LOG_ERROR, "Input %d of the scene '%s' could not be created.", i + 1, scene->name);
            return result;
        }
        sea->inputCount = i + 1;
    }
    return SW_SUCCESS;
}
