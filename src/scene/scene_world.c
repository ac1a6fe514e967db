// SPDX-License-Identifier: MIT
// What a scene is read for.

#include <string.h>

#include "core/base/host.h"
#include "seaway/scene.h"

const swSceneView* swScene_FindView(const swScene* scene, const char* name)
{
    for (int i = 0; i < scene->viewCount; ++i)
    {
        if (name == NULL || strcmp(scene->views[i].name, name) == 0)
        {
            return &scene->views[i];
        }
    }
    return NULL;
}

swSkyDef swScene_GetSky(const swScene* scene, const swSceneView* view)
{
    swSkyDef sky = scene->sky;
    if (view != NULL && view->hasSun)
    {
        sky.sunAzimuth = view->sunAzimuth;
        sky.sunElevation = view->sunElevation;
    }
    return sky;
}

swResult swCreateSceneWorld(const swHost* host, const swScene* scene, swWorld** world)
{
    *world = NULL;
    swWorld* made = NULL;
    swResult result = swCreateWorld(host, &scene->world, &made);
    for (int i = 0; i < scene->wavesCount && result == SW_SUCCESS; ++i)
    {
        swWaveSystemId id;
        result = swCreateWaveSystem(made, &scene->waves[i].def, &id);
        if (result != SW_SUCCESS)
        {
            swLog(host, SW_LOG_ERROR, "Wave system %d of the scene '%s' could not be created.", i + 1, scene->name);
        }
    }
    if (result == SW_SUCCESS)
    {
        swWorld_SetTime(made, scene->time);
        result = swWorld_Step(made, 0.0);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyWorld(made);
        return result;
    }
    *world = made;
    return SW_SUCCESS;
}
