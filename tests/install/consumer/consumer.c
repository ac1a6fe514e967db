// SPDX-License-Identifier: MIT
// Links one function of each installed library and makes a little sea.
#include <seaway/seaway.h>
#ifdef USE_GPU
#include <seaway/draw.h>
#include <seaway/layers.h>
#endif
#ifdef USE_STAGE
#include <seaway/stage.h>
#endif
#ifdef USE_SCENE
#include <seaway/scene.h>
#endif

#include <stdio.h>

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swWaveSystemId id;
    waves.resolution = 32;
    waves.tileWaves = 8;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS || swCreateWaveSystem(world, &waves, &id) != SW_SUCCESS ||
        swWorld_Step(world, 1.0) != SW_SUCCESS)
    {
        swDestroyWorld(world);
        return 1;
    }
    printf("version %d, height %.3f m", swGetVersion(), swMoment_GetHeight(swWorld_GetMoment(world), 3.0, 4.0));
    swDestroyWorld(world);

#ifdef USE_GPU
    printf(", %d frames in flight", swDefaultGpuDef().framesInFlight);
#endif
#ifdef USE_STAGE
    swDeviceChoice choice;
    int index = 0;
    printf(", device 3 %s", swParseStageDevice("3", &choice, &index) && index == 3 ? "is a choice" : "is none");
#endif
#ifdef USE_SCENE
    host.log = NULL;
    swScene* scene = NULL;
    swResult result = swReadScene(&host, "/nowhere.yaml", &scene);
    printf(", reading nothing gives %s", swResult_GetName(result));
    swDestroyScene(scene);
    if (result != SW_ERROR_FILE)
    {
        return 1;
    }
#endif
    printf("\n");
    return 0;
}
