// SPDX-License-Identifier: MIT
// Bodies of water of a scene file, and what their water looks like.

#include "core/base/field.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"

// ---- looks ----

swResult swReadLooks(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "looks", SW_MAX_SCENE_LOOKS, sizeof(swWaterDef),
                                          (void**)&scene->looks, &scene->lookCount);
    for (int i = 0; i < scene->lookCount && !swIsYamlOver(yaml, result); ++i)
    {
        swYamlMapping mapping;
        scene->looks[i] = swDefaultWaterDef();
        swBeginYamlMapping(&mapping, "a look");
        swAddYamlFields(&mapping, swGetWaterFields(), 0, "water");
        result =
            swKeepFailure(result, swReadYamlMapping(yaml, swGetYamlItem(yaml, node, i), &mapping, &scene->looks[i]));
    }
    return result;
}

static swResult checkLook(swYaml* yaml, const swYamlMapping* mapping, const swScene* scene, int look)
{
    const yaml_node_t* node = swGetYamlNode(mapping, "look");
    return node != NULL && !swIsYamlWrong(mapping, "look") && look > scene->lookCount
               ? swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE,
                            "look is %d; it is 0, or the number of one of the scene's looks, 1 to %d.", look,
                            scene->lookCount)
               : SW_SUCCESS;
}

// ---- bodies ----

static swResult readShorePoint(swYaml* yaml, yaml_node_t* node, swVec2* point)
{
    float numbers[4] = {0.0f};
    swResult result = swReadYamlNumbers(yaml, node, "a point [x, z]", 2, numbers);
    *point = (swVec2){numbers[0], numbers[1]};
    return result;
}

static swResult readShore(swYaml* yaml, yaml_node_t* node, swSceneWaterBody* body)
{
    swResult result = swAllocateYamlItems(yaml, node, "points", SW_MAX_SHORE_POINTS, sizeof(swVec2),
                                          (void**)&body->points, &body->pointCount);
    for (int i = 0; i < body->pointCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readShorePoint(yaml, swGetYamlItem(yaml, node, i), &body->points[i]));
    }
    body->def.points = body->points;
    body->def.pointCount = body->pointCount;
    return result;
}

static swResult readBody(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneWaterBody* body = &reader->scene->waterBodies[index];
    body->def = swDefaultWaterBodyDef();
    body->waves = -1;
    body->item = index + 1;
    body->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a body of water");
    swAddYamlFields(&mapping, swGetWaterBodyFields(), 0, "water_bodies");
    swAddYamlKey(&mapping, "waves", swKeepYamlNode);
    swAddYamlKey(&mapping, "points", swKeepYamlNode);
    swAddYamlKey(&mapping, "tide", swKeepYamlNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, &body->def);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    yaml_node_t *points = swGetYamlNode(&mapping, "points"), *waves = swGetYamlNode(&mapping, "waves");
    result = swKeepFailure(result, points != NULL ? readShore(yaml, points, body)
                                                  : swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                               "the body of water has no points; give it its shore."));
    result = swKeepFailure(result, checkLook(yaml, &mapping, reader->scene, body->def.look));
    yaml_node_t* tide = swGetYamlNode(&mapping, "tide");
    const float height = (float)body->def.position.y;
    const swTideReader tideReader = {
        .reader = reader, .value = &height, .constituents = body->def.tide, .table = &body->tide};
    result = tide != NULL ? swKeepFailure(result, swReadTide(yaml, tide, &tideReader)) : result;
    return waves != NULL ? swKeepFailure(result, swReadWavesNumber(yaml, waves, reader->scene, &body->waves)) : result;
}

swResult swReadWaterBodies(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "water_bodies", SW_MAX_WATER_BODIES, sizeof(swSceneWaterBody),
                                          (void**)&scene->waterBodies, &scene->waterBodyCount);
    for (int i = 0; i < scene->waterBodyCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readBody(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

void swAddBodyTrees(swTree* tree, int list, const swScene* scene)
{
    for (int i = 0; i < scene->waterBodyCount && !tree->isBroken; ++i)
    {
        const swSceneWaterBody* body = &scene->waterBodies[i];
        int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
        swSetTreeItem(tree, node, body->item - 1, false);
        swAddCountedFields(tree, node, swGetWaterBodyFields(), &body->def);
        swAddWavesNumber(tree, node, body->waves);
        swAddShoreTrees(tree, node, body->pointCount, body->points);
        if (body->tide.count == 0)
        {
            swAddTideTrees(tree, node, body->def.tide, false);
        }
    }
}

void swFreeWaterBodies(swScene* scene)
{
    for (int i = 0; i < scene->waterBodyCount; ++i)
    {
        swSceneWaterBody* body = &scene->waterBodies[i];
        swFree(&scene->host, body->points, (size_t)body->pointCount * sizeof(swVec2));
        swFreeTide(&scene->host, &body->tide);
    }
    swFree(&scene->host, scene->waterBodies, (size_t)scene->waterBodyCount * sizeof(swSceneWaterBody));
    swFree(&scene->host, scene->looks, (size_t)scene->lookCount * sizeof(swWaterDef));
    scene->waterBodyCount = scene->lookCount = 0;
    scene->waterBodies = NULL;
    scene->looks = NULL;
}

swResult swCreateSceneBodies(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    swResult result = SW_SUCCESS;
    sea->waterBodyCount = scene->waterBodyCount;
    for (int i = 0; i < scene->waterBodyCount; ++i)
    {
        swWaterBodyDef def = scene->waterBodies[i].def;
        def.position.y = swSceneWaterBody_GetLevel(&scene->waterBodies[i], swWorld_GetTime(world));
        def.waves = scene->waterBodies[i].waves >= 0 ? sea->systems[scene->waterBodies[i].waves] : def.waves;
        swResult own = swCreateWaterBody(world, &def, &sea->waterBodies[i]);
        int line = scene->waterBodies[i].line;
        result =
            own != SW_SUCCESS ? swKeepFailure(result, swTellRefused(scene, own, line, "body of water", i)) : result;
    }
    return result;
}
