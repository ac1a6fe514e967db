// SPDX-License-Identifier: MIT
// A scene that is changed, and written.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "scene/scene_components.h"
#include "scene/scene_lists.h"
#include "scene/scene_source.h"
#include "scene/yaml_merge.h"

#define MAX_SCENE_SIZE ((size_t)1 << 20)

swSceneView swDefaultSceneView(void)
{
    swSceneView view;
    swFillDef(swGetSceneViewFields(), &view);
    return view;
}

swResult swCreateScene(const swHost* host, swScene** scene)
{
    SW_REQUIRE_PLACE(host, scene, "swCreateScene()");
    *scene = swMakeScene(host, "a new scene", "");
    return *scene != NULL ? SW_SUCCESS : SW_ERROR_NO_MEMORY;
}

// ---- waves ----

// The def with waves of its own.
static swResult takeDef(swScene* scene, swSceneWaves* waves, const swWaveSystemDef* def)
{
    size_t count = def->components != NULL && def->componentCount > 0 ? (size_t)def->componentCount : 0;
    swWaveComponent* copy = swAllocate(&scene->host, count * sizeof(swWaveComponent));
    if (count > 0 && copy == NULL)
    {
        return swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for %zu waves of a scene.", count);
    }
    if (count > 0)
    {
        memcpy(copy, def->components, count * sizeof(swWaveComponent));
    }
    swFreeComponents(&scene->host, waves);
    waves->components = copy;
    waves->componentCount = (int)count;
    waves->def = *def;
    waves->def.components = copy;
    waves->def.componentCount = (int)count;
    if (waves->measured != NULL)
    {
        waves->def.spectrum.table = &waves->table;
    }
    return SW_SUCCESS;
}

static swResult checkDef(const swScene* scene, const swWaveSystemDef* def, bool mayBeTable)
{
    swResult result = swCheckDef(&scene->host, swGetWaveSystemFields(), def);
    if (result == SW_SUCCESS && def->spectrum.kind == SW_SPECTRUM_TABLE && !mayBeTable)
    {
        return swFail(&scene->host, SW_ERROR_INVALID,
                      "A table cannot be added to a scene; name the file that holds it in the scene file.");
    }
    return result;
}

swResult swScene_AddWaves(swScene* scene, const swWaveSystemDef* def)
{
    SW_REQUIRE(scene != NULL && def != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swScene_AddWaves() needs a scene and a def");
    swResult result = checkDef(scene, def, false);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (scene->wavesCount == SW_MAX_WAVE_SYSTEMS)
    {
        return swFail(&scene->host, SW_ERROR_LIMIT, "A scene has at most %d wave systems; remove one first.",
                      SW_MAX_WAVE_SYSTEMS);
    }
    swSceneWaves* waves = &scene->waves[scene->wavesCount];
    memset(waves, 0, sizeof(*waves));
    result = takeDef(scene, waves, def);
    scene->wavesCount += result == SW_SUCCESS;
    return result;
}

swResult swScene_SetWaves(swScene* scene, int index, const swWaveSystemDef* def)
{
    SW_REQUIRE(scene != NULL && def != NULL && index >= 0 && index < scene->wavesCount, SW_ERROR_INVALID,
               scene != NULL ? &scene->host : NULL, "swScene_SetWaves() needs a scene, a def and an index that it has");
    swSceneWaves* waves = &scene->waves[index];
    swResult result = checkDef(scene, def, waves->measured != NULL);
    return result == SW_SUCCESS ? takeDef(scene, waves, def) : result;
}

// Inputs and bodies of water name waves by their number. Returns whether these were the removed ones.
static bool renumber(int index, int* waves)
{
    bool isGone = *waves == index;
    *waves = isGone ? -1 : *waves - (*waves > index ? 1 : 0);
    return isGone;
}

static void renumberWaves(swScene* scene, int index)
{
    for (int i = 0; i < scene->inputCount; ++i)
    {
        swSceneInput* input = &scene->inputs[i];
        input->hasLostWaves = renumber(index, &input->waves) || input->hasLostWaves;
        input->isLeftOut = input->isLeftOut || input->hasLostWaves;
    }
    for (int i = 0; i < scene->waterBodyCount; ++i)
    {
        renumber(index, &scene->waterBodies[i].waves); // the body stays, without waves of its own
    }
}

void swScene_RemoveWaves(swScene* scene, int index)
{
    SW_REQUIRE_VOID(scene != NULL && index >= 0 && index < scene->wavesCount, scene != NULL ? &scene->host : NULL,
                    "swScene_RemoveWaves() needs a scene and an index that it has");
    renumberWaves(scene, index);
    swDestroyMeasuredSea(scene->waves[index].measured);
    swFreeComponents(&scene->host, &scene->waves[index]);
    scene->wavesCount -= 1;
    memmove(&scene->waves[index], &scene->waves[index + 1], (size_t)(scene->wavesCount - index) * sizeof(swSceneWaves));
    for (int i = index; i < scene->wavesCount; ++i)
    {
        swSceneWaves* waves = &scene->waves[i];
        waves->def.spectrum.table = waves->measured != NULL ? &waves->table : waves->def.spectrum.table;
    }
    memset(&scene->waves[scene->wavesCount], 0, sizeof(swSceneWaves));
}

// ---- inputs ----

// Which of the scene's lists an input's shape names, and where; -1 if it needs none, -2 if the scene has it not.
static int findResource(const swScene* scene, const swInputDef* def)
{
    int count = def->shape == SW_SHAPE_RASTER   ? scene->rasterCount
                : def->shape == SW_SHAPE_MESH   ? scene->meshCount
                : def->shape == SW_SHAPE_HULL   ? scene->hullCount
                : def->shape == SW_SHAPE_SPLINE ? scene->splineCount
                                                : -1;
    for (int i = 0; i < count; ++i)
    {
        bool isIt = def->shape == SW_SHAPE_RASTER ? scene->rasters[i].raster == def->raster
                    : def->shape == SW_SHAPE_MESH ? scene->meshes[i].mesh == def->mesh
                    : def->shape == SW_SHAPE_HULL ? scene->hulls[i].hull == def->hull
                                                  : scene->splines[i].spline == def->spline;
        if (isIt)
        {
            return i;
        }
    }
    return count < 0 ? -1 : -2;
}

static swResult checkInput(const swScene* scene, const swInputDef* def, int waves, int resource)
{
    swResult result = swCheckDef(&scene->host, swGetInputFields(), def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->shape == SW_SHAPE_FUNCTION)
    {
        return swFail(&scene->host, SW_ERROR_UNSUPPORTED, "A function cannot be added to a scene; give it a raster.");
    }
    if (resource == -2 || waves < -1 || waves >= scene->wavesCount)
    {
        return swFail(&scene->host, SW_ERROR_INVALID, "The input '%.63s' names %s that the scene does not have.",
                      def->name, resource == -2 ? "a raster, mesh, hull or spline" : "waves");
    }
    return scene->inputCount == SW_MAX_SCENE_INPUTS
               ? swFail(&scene->host, SW_ERROR_LIMIT, "A scene has at most %d inputs; remove one first.",
                        SW_MAX_SCENE_INPUTS)
               : SW_SUCCESS;
}

// The list with room for `count`; the scene keeps the old one if there is no memory.
static bool resizeInputs(swScene* scene, int count)
{
    swSceneInput* inputs = count > 0 ? swAllocateZero(&scene->host, (size_t)count * sizeof(swSceneInput)) : NULL;
    int kept = count < scene->inputCount ? count : scene->inputCount;
    if (count > 0 && inputs == NULL)
    {
        swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for %d inputs of a scene.", count);
        return false;
    }
    if (kept > 0)
    {
        memcpy(inputs, scene->inputs, (size_t)kept * sizeof(swSceneInput));
    }
    swFree(&scene->host, scene->inputs, (size_t)scene->inputCount * sizeof(swSceneInput));
    scene->inputs = inputs;
    scene->inputCount = count;
    return true;
}

swResult swScene_AddInput(swScene* scene, const swInputDef* def, int waves)
{
    SW_REQUIRE(scene != NULL && def != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swScene_AddInput() needs a scene and a def");
    int resource = findResource(scene, def), index = scene->inputCount;
    swResult result = checkInput(scene, def, waves, resource);
    if (result != SW_SUCCESS || !resizeInputs(scene, index + 1))
    {
        return result != SW_SUCCESS ? result : SW_ERROR_NO_MEMORY;
    }
    scene->inputs[index] = (swSceneInput){.def = *def, .waves = waves, .resource = resource};
    scene->inputs[index].def.points = NULL;
    scene->inputs[index].def.pointCount = 0;
    result = def->pointCount > 0 ? swScene_SetInputPoints(scene, index, def->pointCount, def->points) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        swScene_RemoveInput(scene, index);
    }
    return result;
}

swResult swScene_SetInputPoints(swScene* scene, int index, int count, const swInputPoint* points)
{
    SW_REQUIRE(scene != NULL && index >= 0 && index < scene->inputCount && count > 0 && count <= SW_MAX_INPUT_POINTS &&
                   points != NULL,
               SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swScene_SetInputPoints() needs a scene, an index that it has, and 1 to %d points", SW_MAX_INPUT_POINTS);
    swSceneInput* input = &scene->inputs[index];
    swInputPoint* copy = swAllocate(&scene->host, (size_t)count * sizeof(swInputPoint));
    if (copy == NULL)
    {
        return swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for %d points of a scene's input.", count);
    }
    memcpy(copy, points, (size_t)count * sizeof(swInputPoint));
    swFree(&scene->host, input->points, (size_t)input->pointCount * sizeof(swInputPoint));
    input->points = copy;
    input->pointCount = count;
    input->def.points = copy;
    input->def.pointCount = count;
    return SW_SUCCESS;
}

swResult swScene_SetShore(swScene* scene, int index, int count, const swVec2* points)
{
    SW_REQUIRE(scene != NULL && index >= 0 && index < scene->waterBodyCount && count >= 3 &&
                   count <= SW_MAX_SHORE_POINTS && points != NULL,
               SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swScene_SetShore() needs a scene, an index that it has, and 3 to %d points", SW_MAX_SHORE_POINTS);
    swSceneWaterBody* body = &scene->waterBodies[index];
    swVec2* copy = swAllocate(&scene->host, (size_t)count * sizeof(swVec2));
    if (copy == NULL)
    {
        return swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for %d points of a shore.", count);
    }
    memcpy(copy, points, (size_t)count * sizeof(swVec2));
    swFree(&scene->host, body->points, (size_t)body->pointCount * sizeof(swVec2));
    body->points = copy;
    body->pointCount = count;
    body->def.points = copy;
    body->def.pointCount = count;
    return SW_SUCCESS;
}

void swScene_RemoveInput(swScene* scene, int index)
{
    SW_REQUIRE_VOID(scene != NULL && index >= 0 && index < scene->inputCount, scene != NULL ? &scene->host : NULL,
                    "swScene_RemoveInput() needs a scene and an index that it has");
    swSceneInput gone = scene->inputs[index];
    int last = scene->inputCount - 1;
    memmove(&scene->inputs[index], &scene->inputs[index + 1], (size_t)(last - index) * sizeof(swSceneInput));
    memset(&scene->inputs[last], 0, sizeof(swSceneInput));
    if (!resizeInputs(scene, last))
    {
        scene->inputs[last].isLeftOut = scene->inputs[last].hasLostWaves = true; // an empty one stays at the end
    }
    swFreeInput(&scene->host, &gone);
}

// ---- views ----

swResult swScene_AddView(swScene* scene, const swSceneView* view)
{
    SW_REQUIRE(scene != NULL && view != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swScene_AddView() needs a scene and a view");
    if (scene->viewCount == SW_MAX_SCENE_VIEWS)
    {
        return swFail(&scene->host, SW_ERROR_LIMIT, "A scene has at most %d views; remove one first.",
                      SW_MAX_SCENE_VIEWS);
    }
    if (view->name[0] == '\0' || memchr(view->name, '\0', sizeof(view->name)) == NULL ||
        swScene_FindView(scene, view->name) != NULL)
    {
        return swFail(&scene->host, SW_ERROR_INVALID, "A view '%.63s' needs a name that no other has.", view->name);
    }
    swResult result = swCheckDef(&scene->host, swGetSceneViewFields(), view);
    if (result == SW_SUCCESS)
    {
        scene->views[scene->viewCount] = *view;
        scene->views[scene->viewCount++].item = 0;
    }
    return result;
}

void swScene_RemoveView(swScene* scene, int index)
{
    SW_REQUIRE_VOID(scene != NULL && index >= 0 && index < scene->viewCount, scene != NULL ? &scene->host : NULL,
                    "swScene_RemoveView() needs a scene and an index that it has");
    scene->viewCount -= 1;
    memmove(&scene->views[index], &scene->views[index + 1], (size_t)(scene->viewCount - index) * sizeof(swSceneView));
}

// ---- writing ----

// Every value is one that can be read.
static swResult checkScene(const swScene* scene)
{
    if (scene->wavesCount < 0 || scene->wavesCount > SW_MAX_WAVE_SYSTEMS || scene->viewCount < 0 ||
        scene->viewCount > SW_MAX_SCENE_VIEWS)
    {
        return swFail(&scene->host, SW_ERROR_INVALID, "A scene has %d wave systems and %d views; at most %d and %d.",
                      scene->wavesCount, scene->viewCount, SW_MAX_WAVE_SYSTEMS, SW_MAX_SCENE_VIEWS);
    }
    swResult result = swCheckDef(&scene->host, swGetSceneFields(), scene);
    for (int i = 0; i < SW_SCENE_PART_COUNT && result == SW_SUCCESS; ++i)
    {
        swScenePart part = swGetScenePart(i);
        result = swCheckDef(&scene->host, part.fields, (const char*)scene + part.offset);
    }
    for (int i = 0; i < scene->wavesCount && result == SW_SUCCESS; ++i)
    {
        result = swCheckDef(&scene->host, swGetWaveSystemFields(), &scene->waves[i].def);
    }
    for (int i = 0; i < scene->viewCount && result == SW_SUCCESS; ++i)
    {
        result = swCheckDef(&scene->host, swGetSceneViewFields(), &scene->views[i]);
    }
    for (int i = 0; i < scene->inputCount && result == SW_SUCCESS; ++i)
    {
        result = swCheckDef(&scene->host, swGetInputFields(), &scene->inputs[i].def);
    }
    for (int i = 0; i < scene->waterBodyCount && result == SW_SUCCESS; ++i)
    {
        result = swCheckDef(&scene->host, swGetWaterBodyFields(), &scene->waterBodies[i].def);
    }
    return result;
}

// Read what was made, and see that it says what was wanted. What it was read into is given back.
static swResult readBack(const swScene* scene, const swTree* wanted, const char* text, size_t size, swScene** read)
{
    const char* name = scene->source->name;
    if (size > MAX_SCENE_SIZE)
    {
        return swFail(&scene->host, SW_ERROR_FORMAT, "%s: the scene would have %zu bytes; at most %zu are read.", name,
                      size, MAX_SCENE_SIZE);
    }
    *read = NULL;
    swResult result = swReadSceneKeys(&scene->host, text, size, name, read);
    const char* key = "";
    if (result == SW_SUCCESS && !swAreTreesEqual(wanted, 0, &(*read)->source->tree, 0))
    {
        key = swFindTreeDifference(wanted, 0, &(*read)->source->tree, 0);
        swDestroyScene(*read);
        *read = NULL;
        result = SW_ERROR_FORMAT;
    }
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFail(&scene->host, SW_ERROR_FORMAT,
                        "%s: the changed scene would be read as another one%s%s%s, so nothing was written; change the "
                        "file by hand.",
                        name, key[0] != '\0' ? " at the key '" : "", key, key[0] != '\0' ? "'" : "");
}

// The text, and the scene that is read from it. Both are of the host's memory.
static swResult printScene(const swScene* scene, char** text, size_t* size, swScene** read)
{
    const swSceneSource* source = scene->source;
    swResult result = checkScene(scene);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swTree wanted = swMakeSceneTree(scene, false);
    swTree empty = swBeginTree(&scene->host, SW_TREE_MAPPING);
    result = swMergeYaml(&scene->host, source->text != NULL ? source->text : "", source->size, source->name,
                         source->text != NULL ? &source->tree : &empty, &wanted, text, size);
    if (result == SW_SUCCESS)
    {
        result = readBack(scene, &wanted, *text, *size, read);
        if (result != SW_SUCCESS)
        {
            swFree(&scene->host, *text, *size + 1);
        }
    }
    swFreeTree(&empty);
    swFreeTree(&wanted);
    return result;
}

swResult swPrintScene(const swScene* scene, char* text, size_t* size)
{
    SW_REQUIRE(scene != NULL && size != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swPrintScene() needs a scene and a place for the size");
    size_t room = *size, needed = 0;
    char* made = NULL;
    swScene* read = NULL;
    swResult result = printScene(scene, &made, &needed, &read);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    *size = needed;
    if (text != NULL && room >= needed)
    {
        memcpy(text, made, needed);
    }
    swDestroyScene(read);
    swFree(&scene->host, made, needed + 1);
    return text != NULL && room < needed ? SW_ERROR_LIMIT : SW_SUCCESS;
}

// The file must still be the one that was read: whoever changed it since would lose that.
static swResult checkFile(const swScene* scene, const char* path)
{
    const swSceneSource* source = scene->source;
    if (!source->isFile || !swIsSameFile(path, source->name))
    {
        return SW_SUCCESS;
    }
    swFileText text;
    swResult result = swReadText(&scene->host, path, MAX_SCENE_SIZE, &text);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    bool isSame = text.size == source->size && (text.size == 0 || memcmp(text.data, source->text, text.size) == 0);
    bool isPacked = text.isPacked;
    swFreeText(&scene->host, &text);
    if (isPacked)
    {
        return swFail(&scene->host, SW_ERROR_FILE, "%s is packed by gzip; unpack it to write it.", path);
    }
    return isSame
               ? SW_SUCCESS
               : swFail(&scene->host, SW_ERROR_FILE,
                        "%s has changed since it was read, so it was not written; read it again, or write to another "
                        "file.",
                        path);
}

static swResult checkFileName(const swScene* scene, const char* path, const char* folder, const char* name)
{
    const char* old = scene->source->folder;
    char file[SW_MAX_PATH + 512];
    snprintf(file, sizeof(file), "%s%s%s", folder, folder[0] != '\0' ? "/" : "", name);
    if (name[0] == '\0' || name[0] == '/' || swHasFile(file))
    {
        return SW_SUCCESS;
    }
    return swFail(
        &scene->host, SW_ERROR_FILE,
        "Cannot write %s: the scene names the file %s, which is not there beside it; write the scene into the "
        "folder %s, or copy that file first.",
        path, name, old[0] != '\0' ? old : ".");
}

// Relative names of files must lead there from the new file too.
static swResult checkNames(const swScene* scene, const char* path)
{
    const char* old = scene->source->folder;
    char folder[SW_MAX_PATH];
    swFindFolder(path, folder);
    if (swIsSameFile(folder[0] != '\0' ? folder : ".", old[0] != '\0' ? old : "."))
    {
        return SW_SUCCESS;
    }
    swResult result = SW_SUCCESS;
    for (int i = 0; i < scene->wavesCount && result == SW_SUCCESS; ++i)
    {
        result = checkFileName(scene, path, folder, scene->waves[i].file);
    }
    for (int i = 0; i < scene->rasterCount && result == SW_SUCCESS; ++i)
    {
        const swSceneRaster* raster = &scene->rasters[i];
        result = raster->isOptional ? SW_SUCCESS : checkFileName(scene, path, folder, raster->file);
    }
    for (int i = 0; i < scene->meshCount && result == SW_SUCCESS; ++i)
    {
        result = checkFileName(scene, path, folder, scene->meshes[i].file);
    }
    return result;
}

// From now on the scene is the one that was read from the text.
static void goOn(swScene* scene, swScene* read, const char* path)
{
    swSceneSource* old = scene->source;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        scene->waves[i].item = i + 1;
        read->source->records[i] = scene->waves[i].record;
        read->source->replays[i] = scene->waves[i].replay;
    }
    for (int i = 0; i < scene->viewCount; ++i)
    {
        scene->views[i].item = i + 1;
    }
    for (int i = 0, item = 0; i < scene->inputCount; ++i)
    {
        scene->inputs[i].item = scene->inputs[i].hasLostWaves ? 0 : ++item;
    }
    swFindFolder(path, read->source->folder);
    snprintf(read->source->name, sizeof(read->source->name), "%s", path);
    read->source->isFile = true;
    scene->source = read->source;
    scene->source->tree.host = &scene->host;
    read->source = old;
    old->tree.host = &read->host;
}

swResult swWriteScene(swScene* scene, const char* path)
{
    SW_REQUIRE(scene != NULL && path != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swWriteScene() needs a scene and a path");
    char* text = NULL;
    size_t size = 0;
    swScene* read = NULL;
    swResult result = checkFile(scene, path);
    result = result == SW_SUCCESS ? checkNames(scene, path) : result;
    result = result == SW_SUCCESS ? printScene(scene, &text, &size, &read) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    result = swWriteText(&scene->host, path, text, size);
    if (result == SW_SUCCESS)
    {
        goOn(scene, read, path);
    }
    swDestroyScene(read);
    swFree(&scene->host, text, size + 1);
    return result;
}
