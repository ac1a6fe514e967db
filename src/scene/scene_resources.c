// SPDX-License-Identifier: MIT
// Rasters and splines of a scene file, which its inputs name.

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

static swResult openRaster(swYaml* yaml, const yaml_node_t* node, const swSceneReader* reader, swSceneRaster* raster)
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

static swResult readRaster(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
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
        result, swCheckYamlName(yaml, node, &mapping, "raster", reader->scene->rasters, sizeof(swSceneRaster), index));
    if (node->type == YAML_MAPPING_NODE && swGetYamlNode(&mapping, "file") == NULL)
    {
        result = swKeepFailure(result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                  "the raster has no file; name the one that holds its numbers."));
    }
    return result == SW_SUCCESS ? openRaster(yaml, swGetYamlNode(&mapping, "file"), reader, raster) : result;
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
    swFree(&scene->host, scene->splines, (size_t)scene->splineCount * sizeof(swSceneSpline));
    swFree(&scene->host, scene->rasters, (size_t)scene->rasterCount * sizeof(swSceneRaster));
    scene->rasterCount = scene->splineCount = 0;
    scene->rasters = NULL;
    scene->splines = NULL;
}
