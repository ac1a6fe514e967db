// SPDX-License-Identifier: MIT
// Rasters, meshes and splines of a scene file, which its inputs name.

#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "files/file_text.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"

static void joinPath(const char* folder, const char* file, char path[SW_MAX_PATH])
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
        swLog(yaml->host, SW_LOG_WARNING, "%s:%d: %s is not there; inputs of the raster '%s' are left out.", yaml->name,
              raster->line, raster->file, raster->name);
    }
    return isMissing;
}

static swResult openRaster(swYaml* yaml, const yaml_node_t* node, const swSceneReader* reader, swSceneRaster* raster)
{
    char path[SW_MAX_PATH];
    joinPath(reader->folder, raster->file, path);
    raster->def.variable = raster->variable[0] != '\0' ? raster->variable : NULL;
    if (reader->opensNone || (!raster->isIsland && isLeftOut(yaml, raster, path)))
    {
        return SW_SUCCESS;
    }
    swResult result = raster->isIsland ? swCreateIsland(yaml->host, &raster->island, &raster->raster)
                                       : swReadRaster(yaml->host, path, &raster->def, &raster->raster);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE,
                            "the raster '%s' cannot be read from %s; the message before says why.", raster->name,
                            raster->file);
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

// A file or an island, and keys that go with it.
static swResult checkSource(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping)
{
    const yaml_node_t *file = swGetYamlNode(mapping, "file"), *island = swGetYamlNode(mapping, "island");
    if (file == NULL && island == NULL)
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
    joinPath(reader->folder, mesh->file, path);
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
