// SPDX-License-Identifier: MIT
#include "scene/scene_lists.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "scene/exact_number.h"
#include "scene/scene_inputs.h"
#include "scene/scene_source.h"

swResult swKeepYamlNode(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    (void)yaml;
    (void)node;
    (void)key;
    (void)target;
    return SW_SUCCESS;
}

swResult swAllocateYamlItems(swYaml* yaml, yaml_node_t* node, const char* what, int most, size_t size, void** items,
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

// A resource's name, which stands first in its struct, so that lists of all kinds are searched alike.
static const char* getName(const void* items, size_t size, int index)
{
    return (const char*)items + (size_t)index * size;
}

int swFindYamlName(const void* items, size_t size, int count, const char* name)
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

swResult swCheckYamlName(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping, const char* what,
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
    return own[0] != '\0' && swFindYamlName(items, size, index, own) >= 0
               ? swFailYaml(yaml, name, SW_MISTAKE_REPEATED, "a %s named '%s' stands above; names must differ.", what,
                            own)
               : SW_SUCCESS;
}

swResult swReadYamlNumber(swYaml* yaml, const yaml_node_t* node, const char* what, double most, double* number)
{
    double value = 0.0;
    bool isNumber = node->type == YAML_SCALAR_NODE &&
                    swParseExactNumber((const char*)node->data.scalar.value, (int)node->data.scalar.length, &value);
    if (!isNumber || !(value >= -most && value <= most))
    {
        return swFailYaml(yaml, node, isNumber ? SW_MISTAKE_OUT_OF_RANGE : SW_MISTAKE_WRONG_FORM,
                          "%s must be a number from %g to %g.", what, -most, most);
    }
    *number = value;
    return SW_SUCCESS;
}

// A number of a list that is no field by itself.
static swResult readNumber(swYaml* yaml, const yaml_node_t* node, const char* what, float* number)
{
    double value = 0.0;
    swResult result = swReadYamlNumber(yaml, node, what, 1e6, &value);
    *number = result == SW_SUCCESS ? (float)value : *number;
    return result;
}

swResult swReadYamlNumbers(swYaml* yaml, yaml_node_t* node, const char* what, int wanted, float numbers[4])
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

swResult swReadWavesNumber(swYaml* yaml, yaml_node_t* node, const swScene* scene, int* waves)
{
    float number = 0.0f;
    swResult result = readNumber(yaml, node, "waves", &number);
    if (result == SW_SUCCESS && !(number >= 1.0f && number <= (float)scene->wavesCount && number == floorf(number)))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE,
                          "waves is %g; it is the number of one of the scene's waves, 1 to %d.", (double)number,
                          scene->wavesCount);
    }
    *waves = (int)number - 1;
    return result;
}

swResult swTellRefused(const swScene* scene, swResult result, int line, const char* what, int index)
{
    if (result != SW_ERROR_NO_MEMORY)
    {
        swLog(&scene->host, SW_LOG_ERROR, "%s:%d: %s %d cannot be made; the message before says why. [refused]",
              scene->source->name, line, what, index + 1);
    }
    return result;
}

// ---- all lists ----

void swAddInputKeys(swYamlMapping* mapping)
{
    swAddYamlKey(mapping, "rasters", swKeepYamlNode);
    swAddYamlKey(mapping, "meshes", swKeepYamlNode);
    swAddYamlKey(mapping, "hulls", swKeepYamlNode);
    swAddYamlKey(mapping, "splines", swKeepYamlNode);
    swAddYamlKey(mapping, "looks", swKeepYamlNode);
    swAddYamlKey(mapping, "wind_seas", swKeepYamlNode);
    swAddYamlKey(mapping, "water_bodies", swKeepYamlNode);
    swAddYamlKey(mapping, "inputs", swKeepYamlNode);
}

swResult swReadSceneInputs(swYaml* yaml, const swYamlMapping* mapping, const char* folder, bool opensNone,
                           swScene* scene)
{
    const swSceneReader reader = {folder, opensNone, scene};
    swResult result = SW_SUCCESS;
    const struct
    {
        const char* key;
        swResult (*read)(swYaml*, yaml_node_t*, const swSceneReader*);
    } lists[] = {{"rasters", swReadRasters},          {"meshes", swReadMeshes}, {"hulls", swReadHulls},
                 {"splines", swReadSplines},          {"looks", swReadLooks},   {"wind_seas", swReadWindSeas},
                 {"water_bodies", swReadWaterBodies}, {"inputs", swReadInputs}};
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
    swFreeInputs(scene);
    swFreeWaterBodies(scene);
    swFreeWindSeas(scene);
    swFreeHulls(scene);
    swFreeSceneResources(scene);
}
