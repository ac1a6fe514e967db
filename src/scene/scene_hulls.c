// SPDX-License-Identifier: MIT
// Hulls of a scene file: the inside of closed meshes, for inputs of the shape hull.

#include "core/base/field.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"

static swResult makeHull(swYaml* yaml, const swMesh* mesh, swSceneHull* hull)
{
    swMeshInfo info = swMesh_GetInfo(mesh);
    swHullDef def = swDefaultHullDef();
    def.name = hull->name;
    def.resolution = hull->resolution;
    def.vertices = swMesh_GetVertices(mesh);
    def.vertexCount = info.vertexCount;
    def.indices = swMesh_GetIndices(mesh);
    def.triangleCount = info.triangleCount;
    return swCreateHull(yaml->host, &def, &hull->hull);
}

static swResult openHull(swYaml* yaml, const yaml_node_t* node, const swSceneReader* reader, swSceneHull* hull)
{
    if (reader->opensNone)
    {
        return SW_SUCCESS;
    }
    char path[SW_MAX_PATH];
    swMesh* mesh = NULL;
    swJoinScenePath(reader->folder, hull->file, path);
    swResult result = swReadMesh(yaml->host, path, &hull->def, &mesh);
    result = result == SW_SUCCESS ? makeHull(yaml, mesh, hull) : result;
    swDestroyMesh(mesh);
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE,
                            "the hull '%s' cannot be made of %s; the message before says why.", hull->name, hull->file);
}

static swResult readHull(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneHull* hull = &reader->scene->hulls[index];
    swFillDef(swGetSceneHullFields(), hull);
    hull->def = swDefaultMeshFileDef();
    hull->item = index + 1;
    hull->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a hull");
    swAddYamlFields(&mapping, swGetSceneHullFields(), 0, "hulls");
    swResult result = swReadYamlMapping(yaml, node, &mapping, hull);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    result = swKeepFailure(
        result, swCheckYamlName(yaml, node, &mapping, "hull", reader->scene->hulls, sizeof(swSceneHull), index));
    yaml_node_t* file = swGetYamlNode(&mapping, "file");
    if (file == NULL)
    {
        result = swKeepFailure(result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                  "the hull has no file; name the one that holds its triangles."));
    }
    return result == SW_SUCCESS ? openHull(yaml, file, reader, hull) : result;
}

swResult swReadHulls(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "hulls", SW_MAX_SCENE_RESOURCES, sizeof(swSceneHull),
                                          (void**)&scene->hulls, &scene->hullCount);
    for (int i = 0; i < scene->hullCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readHull(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

void swFreeHulls(swScene* scene)
{
    for (int i = 0; i < scene->hullCount; ++i)
    {
        swDestroyHull(scene->hulls[i].hull);
    }
    swFree(&scene->host, scene->hulls, (size_t)scene->hullCount * sizeof(swSceneHull));
    scene->hullCount = 0;
    scene->hulls = NULL;
}
