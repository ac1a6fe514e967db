// SPDX-License-Identifier: MIT
// What a scene is read for.

#include <string.h>

#include "core/base/misuse.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"
#include "seaway/scene.h"

const swSceneView* swScene_FindView(const swScene* scene, const char* name)
{
    SW_REQUIRE(scene != NULL, NULL, NULL, "swScene_FindView() needs a scene");
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
    SW_REQUIRE(scene != NULL, swDefaultSkyDef(), NULL, "swScene_GetSky() needs a scene");
    swSkyDef sky = scene->sky;
    if (view != NULL && view->hasSun)
    {
        sky.sunAzimuth = view->sunAzimuth;
        sky.sunElevation = view->sunElevation;
    }
    return sky;
}

static swResult createSystem(swWorld* world, const swSceneWaves* waves, swSceneSea* sea)
{
    int index = sea->systemCount;
    if (!waves->isReplay)
    {
        return swCreateWaveSystem(world, &waves->def, &sea->systems[index]);
    }
    swSeaReplayDef def = waves->replay;
    def.waves = waves->def;
    swResult result = swCreateSeaReplay(world, &def, &sea->replays[index]);
    if (result == SW_SUCCESS)
    {
        sea->systems[index] = swSeaReplay_GetSystem(sea->replays[index]);
    }
    return result;
}

static swResult createSystems(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        swResult result = createSystem(world, &scene->waves[i], sea);
        if (result != SW_SUCCESS)
        {
            return swTellRefused(scene, result, scene->waves[i].line, "wave system", i);
        }
        sea->systemCount += 1;
    }
    return SW_SUCCESS;
}

swResult swCreateSceneSea(swWorld* world, const swScene* scene, swSceneSea* sea)
{
    if (sea != NULL)
    {
        memset(sea, 0, sizeof(*sea));
    }
    SW_REQUIRE(world != NULL && scene != NULL && sea != NULL, SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swCreateSceneSea() needs a world, a scene and a place for the sea");
    swResult result = createSystems(world, scene, sea);
    result = result == SW_SUCCESS ? swAddSceneInputs(world, scene, sea) : result;
    if (result != SW_SUCCESS)
    {
        int count = sea->systemCount;
        swDestroySceneSea(sea);
        for (int i = 0; i < count; ++i)
        {
            swDestroyWaveSystem(world, sea->systems[i]);
        }
    }
    return result;
}

swResult swCreateSceneInputs(swWorld* world, const swScene* scene, const swWaveSystemId* systems, swSceneSea* sea)
{
    if (sea != NULL)
    {
        memset(sea, 0, sizeof(*sea));
    }
    SW_REQUIRE(world != NULL && scene != NULL && sea != NULL && systems != NULL, SW_ERROR_INVALID,
               scene != NULL ? &scene->host : NULL,
               "swCreateSceneInputs() needs a world, a scene, the systems of its waves and a place for the sea");
    sea->systemCount = scene->wavesCount;
    memcpy(sea->systems, systems, (size_t)scene->wavesCount * sizeof(*systems));
    swResult result = swAddSceneInputs(world, scene, sea);
    if (result != SW_SUCCESS)
    {
        swDestroySceneSea(sea);
    }
    return result;
}

swResult swSceneSea_Advance(swSceneSea* sea, double time)
{
    SW_REQUIRE(sea != NULL && time - time == 0.0, SW_ERROR_INVALID, NULL,
               "swSceneSea_Advance() needs a sea and a time that is a number");
    swResult result = SW_SUCCESS;
    for (int i = 0; i < sea->systemCount && result == SW_SUCCESS; ++i)
    {
        result = sea->replays[i] != NULL ? swSeaReplay_Advance(sea->replays[i], time) : SW_SUCCESS;
    }
    return result == SW_SUCCESS ? swAdvanceSceneInputs(sea, time) : result;
}

void swDestroySceneSea(swSceneSea* sea)
{
    if (sea == NULL)
    {
        return;
    }
    for (int i = 0; i < sea->systemCount; ++i)
    {
        swDestroySeaReplay(sea->replays[i]);
        sea->replays[i] = NULL;
    }
    sea->systemCount = 0;
    swFreeSceneSeaInputs(sea);
}

swResult swOpenScene(const swHost* host, const swScene* scene, swWorld** world, swSceneSea* sea)
{
    if (sea != NULL)
    {
        memset(sea, 0, sizeof(*sea));
    }
    if (world != NULL)
    {
        *world = NULL;
    }
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, scene != NULL ? &scene->host : NULL,
               "swOpenScene() needs a host made by swDefaultHost()");
    SW_REQUIRE_PLACE(host, world, "swOpenScene()");
    SW_REQUIRE(scene != NULL && sea != NULL, SW_ERROR_INVALID, host,
               "swOpenScene() needs a scene and a place for its sea");
    swWorld* made = NULL;
    swResult result = swCreateWorld(host, &scene->world, &made);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swWorld_SetTime(made, scene->time);
    result = swCreateSceneSea(made, scene, sea);
    result = result == SW_SUCCESS ? swAdvanceSceneInputs(sea, scene->time) : result;
    result = result == SW_SUCCESS ? swWorld_Step(made, 0.0) : result;
    if (result != SW_SUCCESS)
    {
        swDestroySceneSea(sea);
        swDestroyWorld(made);
        return result;
    }
    *world = made;
    return SW_SUCCESS;
}

swResult swCreateSceneWorld(const swHost* host, const swScene* scene, swWorld** world)
{
    swSceneSea sea;
    swResult result = swOpenScene(host, scene, world, &sea);
    swDestroySceneSea(&sea);
    return result;
}
