// SPDX-License-Identifier: MIT
// Rasters, meshes and splines of a scene file, which its inputs name.

#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "files/file_text.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"

void swJoinScenePath(const char* folder, const char* file, char path[SW_MAX_PATH])
{
    bool isOwn = folder == NULL || folder[0] == '\0' || file[0] == '/';
    snprintf(path, SW_MAX_PATH, "%s%s%s", isOwn ? "" : folder, isOwn ? "" : "/", file);
}

// ---- rasters ----

// Whether a file that may be missing is; told as a warning.
static bool isLeftOut(swYaml* yaml, const swSceneRaster* raster, const char* path)
{
    bool isMissing = raster->isOptional && !swHasFile(path);
    if (isMissing)
    {
        swLog(yaml->host, SW_LOG_WARNING, "%s:%d: %s is not there; inputs of the raster '%s' are left out. [left_out]",
              yaml->name, raster->line, path, raster->name);
    }
    return isMissing;
}

// Where the values of a raster of several channels, or of a file of several frames, go.
typedef struct Assembly
{
    swRasterDef def;
    float* values;
    size_t size; // bytes
} Assembly;

static swResult beginAssembly(swYaml* yaml, const swSceneRaster* raster, const swRasterInfo* info, Assembly* assembly)
{
    if (info->height % raster->frames != 0)
    {
        return swFail(yaml->host, SW_ERROR_FORMAT, "%s has %d rows, which are not %d frames of the same size.",
                      info->name, info->height, raster->frames);
    }
    int channels = raster->channelCount > 0 ? raster->channelCount : 1;
    assembly->size = (size_t)info->width * (size_t)info->height * (size_t)channels * sizeof(float);
    assembly->values = swAllocate(yaml->host, assembly->size);
    if (assembly->values == NULL)
    {
        return swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for the raster '%s'.", raster->name);
    }
    assembly->def = swDefaultRasterDef();
    assembly->def.name = raster->name;
    assembly->def.width = info->width;
    assembly->def.height = info->height / raster->frames;
    assembly->def.x = info->x;
    assembly->def.z = info->z;
    assembly->def.spacingX = info->spacingX;
    assembly->def.spacingZ = info->spacingZ;
    assembly->def.channels = channels;
    assembly->def.frames = raster->frames;
    assembly->def.values = assembly->values;
    return SW_SUCCESS;
}

// One channel of it, from a raster of the same lattice as the first.
static swResult addChannel(swYaml* yaml, const swSceneRaster* raster, int channel, const swRaster* read,
                           Assembly* assembly)
{
    swRasterInfo info = swRaster_GetInfo(read);
    const swRasterDef* def = &assembly->def;
    swResult result = channel == 0 ? beginAssembly(yaml, raster, &info, assembly) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (info.width != def->width || info.height != def->height * def->frames || info.x != def->x || info.z != def->z ||
        info.spacingX != def->spacingX || info.spacingZ != def->spacingZ)
    {
        return swFail(yaml->host, SW_ERROR_FORMAT,
                      "%s, channel %d of the raster '%s', has another lattice than the first.", info.name, channel + 1,
                      raster->name);
    }
    const float* from = swRaster_GetValues(read);
    for (size_t i = 0; i < (size_t)info.width * (size_t)info.height; ++i)
    {
        assembly->values[i * (size_t)def->channels + (size_t)channel] = from[i];
    }
    return SW_SUCCESS;
}

// A raster of one channel and one frame as the file has it, any other put together of several.
static swResult assembleRaster(swYaml* yaml, const swSceneReader* reader, swSceneRaster* raster)
{
    char path[SW_MAX_PATH];
    if (raster->channelCount == 0 && raster->frames == 1)
    {
        swJoinScenePath(reader->folder, raster->file, path);
        return swReadRaster(yaml->host, path, &raster->def, &raster->raster);
    }
    Assembly assembly = {.values = NULL};
    swResult result = SW_SUCCESS;
    for (int i = 0; i < (raster->channelCount > 0 ? raster->channelCount : 1) && result == SW_SUCCESS; ++i)
    {
        swRasterFileDef def = raster->def;
        swRaster* read = NULL;
        swJoinScenePath(reader->folder, raster->files[i][0] != '\0' ? raster->files[i] : raster->file, path);
        def.variable = raster->variables[i][0] != '\0' ? raster->variables[i] : def.variable;
        result = swReadRaster(yaml->host, path, &def, &read);
        result = result == SW_SUCCESS ? addChannel(yaml, raster, i, read, &assembly) : result;
        swDestroyRaster(read);
    }
    result = result == SW_SUCCESS ? swCreateRaster(yaml->host, &assembly.def, &raster->raster) : result;
    swFree(yaml->host, assembly.values, assembly.size);
    return result;
}

static swResult openRaster(swYaml* yaml, const yaml_node_t* node, const swSceneReader* reader, swSceneRaster* raster)
{
    char path[SW_MAX_PATH];
    swJoinScenePath(reader->folder, raster->files[0][0] != '\0' ? raster->files[0] : raster->file, path);
    raster->def.variable = raster->variable[0] != '\0' ? raster->variable : NULL;
    if (reader->opensNone || (!raster->isIsland && isLeftOut(yaml, raster, path)))
    {
        return SW_SUCCESS;
    }
    swResult result = raster->isIsland ? swCreateIsland(yaml->host, &raster->island, &raster->raster)
                                       : assembleRaster(yaml, reader, raster);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE,
                            "the raster '%s' cannot be read from %s; the message before says why.", raster->name,
                            raster->files[0][0] != '\0' ? raster->files[0] : raster->file);
}

static swResult readIsland(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swSceneRaster* raster = target;
    swYamlMapping mapping;
    raster->isIsland = true;
    swBeginYamlMapping(&mapping, key->key);
    swAddYamlFields(&mapping, swGetIslandFields(), 0, "island");
    return swReadYamlMapping(yaml, node, &mapping, &raster->island);
}

// The files of the channels, or the variables of one file.
static swResult readChannels(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swSceneRaster* raster = target;
    bool isFiles = strcmp(key->key, "files") == 0;
    int count = 0;
    swResult result = swReadYamlList(yaml, node, key->key, SW_MAX_SCENE_CHANNELS, &count);
    if (raster->channelCount > 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_CONFLICT, "files and variables both name channels; remove one.");
    }
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        yaml_node_t* item = swGetYamlItem(yaml, node, i);
        result = swKeepFailure(
            result, isFiles ? swReadYamlText(yaml, item, key->key, raster->files[i], sizeof(raster->files[i]))
                            : swReadYamlText(yaml, item, key->key, raster->variables[i], sizeof(raster->variables[i])));
    }
    raster->channelCount = count;
    return result;
}

// A file or an island, and keys that go with it.
static swResult checkSource(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping)
{
    const yaml_node_t *file = swGetYamlNode(mapping, "file"), *island = swGetYamlNode(mapping, "island");
    const yaml_node_t *files = swGetYamlNode(mapping, "files"), *variable = swGetYamlNode(mapping, "variable");
    const yaml_node_t* variables = swGetYamlNode(mapping, "variables");
    if (file != NULL && files != NULL)
    {
        return swFailYaml(yaml, file, SW_MISTAKE_CONFLICT, "file stands beside files; remove one.");
    }
    if (variable != NULL && variables != NULL)
    {
        return swFailYaml(yaml, variable, SW_MISTAKE_CONFLICT, "variable stands beside variables; remove one.");
    }
    if (file == NULL && files == NULL && island == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                          "the raster has no file; name the one that holds its numbers, or give it an island.");
    }
    swResult result = SW_SUCCESS;
    for (int i = 0; i < mapping->count && island != NULL; ++i)
    {
        const swYamlKey* key = &mapping->keys[i];
        if (key->node != NULL && key->node != island && strcmp(key->key, "name") != 0)
        {
            result = swFailYaml(yaml, key->node, SW_MISTAKE_NO_EFFECT, "%s has no effect on an island; remove it.",
                                key->key);
        }
    }
    return result;
}

static swResult readRaster(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneRaster* raster = &reader->scene->rasters[index];
    swFillDef(swGetSceneRasterFields(), raster);
    raster->def = swDefaultRasterFileDef();
    raster->island = swDefaultIslandDef();
    raster->item = index + 1;
    raster->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a raster");
    swAddYamlFields(&mapping, swGetSceneRasterFields(), 0, "rasters");
    swAddYamlKey(&mapping, "files", readChannels);
    swAddYamlKey(&mapping, "variables", readChannels);
    swAddYamlKey(&mapping, "island", readIsland);
    swResult result = swReadYamlMapping(yaml, node, &mapping, raster);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    result = swKeepFailure(
        result, swCheckYamlName(yaml, node, &mapping, "raster", reader->scene->rasters, sizeof(swSceneRaster), index));
    result = swKeepFailure(result, checkSource(yaml, node, &mapping));
    yaml_node_t* file = swGetYamlNode(&mapping, "file");
    return result == SW_SUCCESS ? openRaster(yaml, file != NULL ? file : node, reader, raster) : result;
}

swResult swReadRasters(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "rasters", SW_MAX_SCENE_RESOURCES, sizeof(swSceneRaster),
                                          (void**)&scene->rasters, &scene->rasterCount);
    for (int i = 0; i < scene->rasterCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readRaster(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

// ---- meshes ----

static swResult openMesh(swYaml* yaml, const yaml_node_t* node, const swSceneReader* reader, swSceneMesh* mesh)
{
    char path[SW_MAX_PATH];
    swJoinScenePath(reader->folder, mesh->file, path);
    swResult result = reader->opensNone ? SW_SUCCESS : swReadMesh(yaml->host, path, &mesh->def, &mesh->mesh);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE,
                            "the mesh '%s' cannot be read from %s; the message before says why.", mesh->name,
                            mesh->file);
}

static swResult readMesh(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneMesh* mesh = &reader->scene->meshes[index];
    mesh->def = swDefaultMeshFileDef();
    mesh->item = index + 1;
    mesh->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a mesh");
    swAddYamlFields(&mapping, swGetSceneMeshFields(), 0, "meshes");
    swResult result = swReadYamlMapping(yaml, node, &mapping, mesh);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    result = swKeepFailure(
        result, swCheckYamlName(yaml, node, &mapping, "mesh", reader->scene->meshes, sizeof(swSceneMesh), index));
    if (swGetYamlNode(&mapping, "file") == NULL)
    {
        result = swKeepFailure(result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                  "the mesh has no file; name the one that holds its triangles."));
    }
    return result == SW_SUCCESS ? openMesh(yaml, node, reader, mesh) : result;
}

swResult swReadMeshes(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "meshes", SW_MAX_SCENE_RESOURCES, sizeof(swSceneMesh),
                                          (void**)&scene->meshes, &scene->meshCount);
    for (int i = 0; i < scene->meshCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readMesh(yaml, swGetYamlItem(yaml, node, i), reader, i));
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
    swResult result = swAllocateYamlItems(yaml, node, "points", SW_MAX_SPLINE_POINTS, sizeof(swSplinePoint),
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

static swResult readSpline(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneSpline* spline = &reader->scene->splines[index];
    spline->def = swDefaultSplineDef();
    spline->item = index + 1;
    spline->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a spline");
    swAddYamlKey(&mapping, "name", readSplineName);
    swAddYamlFields(&mapping, swGetSplineFields(), offsetof(swSceneSpline, def), "splines");
    swAddYamlKey(&mapping, "points", swKeepYamlNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, spline);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    result = swKeepFailure(
        result, swCheckYamlName(yaml, node, &mapping, "spline", reader->scene->splines, sizeof(swSceneSpline), index));
    yaml_node_t* points = swGetYamlNode(&mapping, "points");
    result = swKeepFailure(result, points != NULL ? readSplinePoints(yaml, points, spline)
                                                  : swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                               "the spline has no points; give it two or more."));
    return result == SW_SUCCESS ? makeSpline(yaml, node, spline) : result;
}

swResult swReadSplines(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "splines", SW_MAX_SCENE_RESOURCES, sizeof(swSceneSpline),
                                          (void**)&scene->splines, &scene->splineCount);
    for (int i = 0; i < scene->splineCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readSpline(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

void swFreeSceneResources(swScene* scene)
{
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
    for (int i = 0; i < scene->meshCount; ++i)
    {
        swDestroyMesh(scene->meshes[i].mesh);
    }
    swFree(&scene->host, scene->meshes, (size_t)scene->meshCount * sizeof(swSceneMesh));
    swFree(&scene->host, scene->splines, (size_t)scene->splineCount * sizeof(swSceneSpline));
    swFree(&scene->host, scene->rasters, (size_t)scene->rasterCount * sizeof(swSceneRaster));
    scene->rasterCount = scene->meshCount = scene->splineCount = 0;
    scene->meshes = NULL;
    scene->rasters = NULL;
    scene->splines = NULL;
}
