// SPDX-License-Identifier: MIT
// Scene files. Keys are snake case and carry their unit; docs/scenes.md lists them. What a file leaves out keeps the
// default of the def that it fills.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "files/file_text.h"
#include "scene/scene_components.h"
#include "scene/scene_inputs.h"
#include "scene/scene_measured.h"
#include "scene/scene_source.h"
#include "scene/scene_waves.h"
#include "seaway/math.h"

#define MAX_SCENE_SIZE ((size_t)1 << 20)

typedef struct Reader
{
    swScene* scene;
    const char* folder;
    bool opensNone;
} Reader;

static Reader* getReader(const swYaml* yaml)
{
    return yaml->context;
}

// ---- sections that fill one def ----

// What the table of a view cannot say.
static swResult checkView(swYaml* yaml, const swYamlMapping* mapping, const swViewDef* view)
{
    const yaml_node_t *resolution = swGetYamlNode(mapping, "resolution"),
                      *texel = swGetYamlNode(mapping, "finest_texel_m");
    swResult result = SW_SUCCESS;
    if (resolution != NULL && view->resolution % 64 != 0)
    {
        result = swFailYaml(yaml, resolution, SW_MISTAKE_OUT_OF_RANGE, "resolution is %d; it must be a multiple of 64.",
                            view->resolution);
    }
    if (texel != NULL && !swIsYamlWrong(mapping, "finest_texel_m"))
    {
        float power = 16.0f;
        while (power > view->finestTexel)
        {
            power *= 0.5f;
        }
        if (power != view->finestTexel)
        {
            result = swFailYaml(yaml, texel, SW_MISTAKE_OUT_OF_RANGE,
                                "finest_texel_m is %g; it must be a power of two, such as %g.",
                                (double)view->finestTexel, (double)power);
        }
    }
    return result;
}

// A section holds those fields of the scene's defs that stand in it.
static swResult readSection(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, key->key);
    for (int i = 0; i < SW_SCENE_PART_COUNT; ++i)
    {
        swScenePart part = swGetScenePart(i);
        swAddYamlFields(&mapping, part.fields, part.offset, key->key);
    }
    swResult result = swReadYamlMapping(yaml, node, &mapping, target);
    bool isView = strcmp(key->key, "view") == 0;
    return isView ? swKeepFailure(result, checkView(yaml, &mapping, &((swScene*)target)->view)) : result;
}

// ---- lists ----

static swResult readWaves(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swScene* scene = target;
    const Reader* reader = getReader(yaml);
    int count = 0;
    swResult result = swReadYamlList(yaml, node, key->key, SW_MAX_WAVE_SYSTEMS, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        // Counted first, so that what a failed one has read is freed.
        scene->wavesCount = i + 1;
        scene->waves[i].item = i + 1;
        scene->waves[i].line = (int)swGetYamlItem(yaml, node, i)->start_mark.line + 1;
        result = swKeepFailure(result, swReadSceneWaves(yaml, swGetYamlItem(yaml, node, i), reader->folder,
                                                        reader->opensNone, &scene->waves[i], &scene->source->waves[i]));
    }
    return result;
}

static swResult checkSceneView(swYaml* yaml, yaml_node_t* node, const swScene* scene, int index,
                               const swYamlMapping* mapping)
{
    const swSceneView* view = &scene->views[index];
    const yaml_node_t* name = swGetYamlNode(mapping, "name");
    swResult result = SW_SUCCESS;
    if (name == NULL)
    {
        result = swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the view has no name; give it one to ask for.");
    }
    for (int i = 0; i < index && view->name[0] != '\0'; ++i)
    {
        if (strcmp(scene->views[i].name, view->name) == 0)
        {
            result = swFailYaml(yaml, name, SW_MISTAKE_REPEATED, "a view named '%s' stands above; names must differ.",
                                view->name);
            break;
        }
    }
    const yaml_node_t* azimuth = swGetYamlNode(mapping, "sun_azimuth_deg");
    const yaml_node_t* elevation = swGetYamlNode(mapping, "sun_elevation_deg");
    if ((azimuth == NULL) != (elevation == NULL))
    {
        result = swFailYaml(yaml, azimuth != NULL ? azimuth : elevation, SW_MISTAKE_MISSING_KEY,
                            "a view's own sun needs both sun_azimuth_deg and sun_elevation_deg.");
    }
    return result;
}

static swResult readSceneView(swYaml* yaml, yaml_node_t* node, swScene* scene, int index)
{
    swSceneView* view = &scene->views[index];
    *view = swDefaultSceneView();
    view->item = index + 1;
    view->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "views");
    swAddYamlFields(&mapping, swGetSceneViewFields(), 0, "views");
    swResult result = swReadYamlMapping(yaml, node, &mapping, view);
    view->hasSun = swGetYamlNode(&mapping, "sun_azimuth_deg") != NULL;
    return node->type == YAML_MAPPING_NODE ? swKeepFailure(result, checkSceneView(yaml, node, scene, index, &mapping))
                                           : result;
}

static swResult readViews(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swScene* scene = target;
    swResult result = swReadYamlList(yaml, node, key->key, SW_MAX_SCENE_VIEWS, &scene->viewCount);
    for (int i = 0; i < scene->viewCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readSceneView(yaml, swGetYamlItem(yaml, node, i), scene, i));
    }
    return result;
}

// ---- the file ----

// The line of a key's value, or where the scene begins.
static int findLine(const swYamlMapping* mapping, const yaml_node_t* root, const char* key)
{
    const yaml_node_t* node = swGetYamlNode(mapping, key);
    return (int)(node != NULL ? node : root)->start_mark.line + 1;
}

static swResult readScene(swYaml* yaml, yaml_node_t* root, swScene* scene)
{
    const Reader* reader = getReader(yaml);
    swYamlMapping mapping;
    const char* sections[SW_SCENE_MAX_SECTIONS];
    int count = swListSceneSections(sections);
    swBeginYamlMapping(&mapping, "a scene");
    swAddYamlFields(&mapping, swGetSceneFields(), 0, "scene");
    for (int i = 0; i < count; ++i)
    {
        swAddYamlKey(&mapping, sections[i], readSection);
    }
    swAddYamlKey(&mapping, "waves", readWaves);
    swAddYamlKey(&mapping, "views", readViews);
    swAddInputKeys(&mapping);
    swResult result = swReadYamlMapping(yaml, root, &mapping, scene);
    scene->source->lines = (swSceneLines){.waves = findLine(&mapping, root, "waves"),
                                          .views = findLine(&mapping, root, "views"),
                                          .view = findLine(&mapping, root, "view"),
                                          .foam = findLine(&mapping, root, "foam"),
                                          .looks = findLine(&mapping, root, "looks")};
    return root->type == YAML_MAPPING_NODE && !swIsYamlOver(yaml, result)
               ? swKeepFailure(result, swReadSceneInputs(yaml, &mapping, reader->folder, reader->opensNone, scene))
               : result;
}

static swResult readRoot(const swHost* host, const char* text, size_t size, const char* name, Reader* reader)
{
    swYaml yaml;
    yaml_node_t* root = NULL;
    swResult result = swOpenYaml(host, text, size, name, &yaml, &root);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    yaml.context = reader;
    if (root == NULL)
    {
        result = swFail(host, SW_ERROR_FORMAT,
                        "%s:1: the scene file is empty; it needs at least a list of waves. [missing_key]", name);
    }
    else
    {
        result = readScene(&yaml, root, reader->scene);
    }
    if (result == SW_SUCCESS)
    {
        swChooseReplayRecords(reader->scene);
    }
    swCloseYaml(&yaml);
    return result;
}

static swResult keepText(swScene* scene, const char* text, size_t size)
{
    char* copy = swAllocate(&scene->host, size + 1);
    if (copy == NULL)
    {
        return swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for the scene %s.", scene->source->name);
    }
    memcpy(copy, text, size);
    copy[size] = '\0';
    return swKeepSceneText(scene, copy, size);
}

static swResult readText(const swHost* host, const char* text, size_t size, const char* name, Reader* reader,
                         swScene** scene)
{
    if (size > MAX_SCENE_SIZE)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:1: the scene file has %zu bytes; at most %zu are read. [too_large]",
                      name, size, MAX_SCENE_SIZE);
    }
    reader->scene = swMakeScene(host, name, reader->folder);
    if (reader->scene == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    swResult result = readRoot(host, text, size, name, reader);
    result = result == SW_SUCCESS ? keepText(reader->scene, text, size) : result;
    if (result != SW_SUCCESS)
    {
        swDestroyScene(reader->scene);
        return result;
    }
    *scene = reader->scene;
    return SW_SUCCESS;
}

swResult swReadSceneKeys(const swHost* host, const char* text, size_t size, const char* name, swScene** scene)
{
    Reader reader = {.opensNone = true};
    return readText(host, text, size, name, &reader, scene);
}

swResult swReadSceneText(const swHost* host, const char* text, size_t size, const char* name, const char* folder,
                         swScene** scene)
{
    SW_REQUIRE_PLACE(host, scene, "swReadSceneText()");
    SW_REQUIRE(text != NULL || size == 0, SW_ERROR_INVALID, host, "swReadSceneText() needs the text of a scene");
    Reader reader = {.folder = folder};
    return readText(host, text != NULL ? text : "", size, name != NULL ? name : "scene", &reader, scene);
}

swResult swReadScene(const swHost* host, const char* path, swScene** scene)
{
    SW_REQUIRE_PLACE(host, scene, "swReadScene()");
    SW_REQUIRE(path != NULL, SW_ERROR_INVALID, host, "swReadScene() needs a path");
    char folder[SW_MAX_PATH];
    if (strlen(path) >= sizeof(folder))
    {
        return swFail(host, SW_ERROR_FILE, "The path of a scene has %zu bytes; at most %zu are read.", strlen(path),
                      sizeof(folder) - 1);
    }
    swFindFolder(path, folder);
    swFileText text;
    swResult result = swReadText(host, path, MAX_SCENE_SIZE, &text);
    if (result == SW_SUCCESS)
    {
        result = swReadSceneText(host, text.data != NULL ? text.data : "", text.size, path, folder, scene);
        if (result == SW_SUCCESS)
        {
            (*scene)->source->isFile = true;
        }
        swFreeText(host, &text);
    }
    return result;
}

void swDestroyScene(swScene* scene)
{
    if (scene != NULL)
    {
        swHost host = scene->host;
        for (int i = 0; i < scene->wavesCount; ++i)
        {
            swDestroyMeasuredSea(scene->waves[i].measured);
            swFreeComponents(&host, &scene->waves[i]);
        }
        swFreeSceneInputs(scene);
        swSceneSource* source = scene->source;
        swFree(&host, source->text, source->text != NULL ? source->size + 1 : 0);
        swFreeTree(&source->tree);
        swFree(&host, source, sizeof(*source));
        swFree(&host, scene, sizeof(*scene));
    }
}
