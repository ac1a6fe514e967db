// SPDX-License-Identifier: MIT
// Seas by a map of the wind in a scene file, and in its world.

#include "core/base/field.h"
#include "scene/scene_components.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"
#include "scene/scene_waves.h"

static swResult findMap(swYaml* yaml, yaml_node_t* node, const swScene* scene, swSceneWindSea* sea)
{
    char name[64] = "";
    swResult result = swReadYamlText(yaml, node, "raster", name, sizeof(name));
    int index =
        result == SW_SUCCESS ? swFindYamlName(scene->rasters, sizeof(swSceneRaster), scene->rasterCount, name) : -1;
    if (result == SW_SUCCESS && index < 0)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD,
                          "there is no raster named '%s'; the scene's list of rasters has %d.", name,
                          scene->rasterCount);
    }
    sea->def.raster = index >= 0 ? scene->rasters[index].raster : NULL;
    sea->isLeftOut = index >= 0 && scene->rasters[index].isOptional && sea->def.raster == NULL;
    return result;
}

static swResult readWaves(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, swSceneWindSea* sea)
{
    swWavesText text;
    sea->waves = swAllocateZero(yaml->host, sizeof(*sea->waves));
    if (sea->waves == NULL)
    {
        return swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for the waves of %s.", yaml->name);
    }
    swResult result = swReadSceneWaves(yaml, node, reader->folder, reader->opensNone, sea->waves, &text);
    sea->def.waves = sea->waves->def;
    return result;
}

static swResult readWindSea(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader, int index)
{
    swSceneWindSea* sea = &reader->scene->windSeas[index];
    sea->def = swDefaultWindSeaDef();
    sea->item = index + 1;
    sea->line = (int)node->start_mark.line + 1;
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a wind sea");
    swAddYamlKey(&mapping, "raster", swKeepYamlNode);
    swAddYamlKey(&mapping, "waves", swKeepYamlNode);
    swAddYamlFields(&mapping, swGetWindSeaFields(), 0, "wind_seas");
    swResult result = swReadYamlMapping(yaml, node, &mapping, &sea->def);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    yaml_node_t *raster = swGetYamlNode(&mapping, "raster"), *waves = swGetYamlNode(&mapping, "waves");
    result =
        swKeepFailure(result, raster != NULL ? findMap(yaml, raster, reader->scene, sea)
                                             : swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                          "the wind sea has no raster; name the one with its winds."));
    return waves != NULL ? swKeepFailure(result, readWaves(yaml, waves, reader, sea)) : result;
}

swResult swReadWindSeas(swYaml* yaml, yaml_node_t* node, const swSceneReader* reader)
{
    swScene* scene = reader->scene;
    swResult result = swAllocateYamlItems(yaml, node, "wind_seas", SW_MAX_WAVE_SYSTEMS, sizeof(swSceneWindSea),
                                          (void**)&scene->windSeas, &scene->windSeaCount);
    for (int i = 0; i < scene->windSeaCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readWindSea(yaml, swGetYamlItem(yaml, node, i), reader, i));
    }
    return result;
}

void swFreeWindSeas(swScene* scene)
{
    for (int i = 0; i < scene->windSeaCount; ++i)
    {
        swSceneWaves* waves = scene->windSeas[i].waves;
        if (waves != NULL)
        {
            swDestroyMeasuredSea(waves->measured);
            swFreeComponents(&scene->host, waves);
            swFree(&scene->host, waves, sizeof(*waves));
        }
    }
    swFree(&scene->host, scene->windSeas, (size_t)scene->windSeaCount * sizeof(swSceneWindSea));
    scene->windSeaCount = 0;
    scene->windSeas = NULL;
}

swResult swCreateSceneWindSeas(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < scene->windSeaCount; ++i)
    {
        sea->windSeaCount = i + 1;
        if (scene->windSeas[i].isLeftOut)
        {
            continue;
        }
        swResult own = swCreateWindSea(world, &scene->windSeas[i].def, &sea->windSeas[i]);
        int line = scene->windSeas[i].line;
        result = own != SW_SUCCESS ? swKeepFailure(result, swTellRefused(scene, own, line, "wind sea", i)) : result;
    }
    return result;
}
