// SPDX-License-Identifier: MIT
// Scene texts from anywhere. What is read can be asked for its views and its seas; what is not is explained.

#include <math.h>
#include <stdint.h>

#include "fuzz.h"
#include "seaway/scene.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    swHost host = swDefaultHost();
    host.log = CountMessage;
    int messages = 0;
    host.logContext = &messages;
    swScene* scene = NULL;
    // No file of this machine is to be opened: relative names lead into a folder that does not exist.
    swResult result = swReadSceneText(&host, size > 0 ? (const char*)data : "", size, "fuzz", "/nonexistent", &scene);
    FUZZ_CHECK((result == SW_SUCCESS) == (scene != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (scene != NULL)
    {
        FUZZ_CHECK(scene->wavesCount >= 0 && scene->wavesCount <= SW_MAX_WAVE_SYSTEMS);
        FUZZ_CHECK((swScene_FindView(scene, NULL) != NULL) == (scene->viewCount > 0));
        for (int i = 0; i < scene->wavesCount; ++i)
        {
            const swWaveSystemDef* def = &scene->waves[i].def;
            for (int j = 0; j < def->componentCount; ++j)
            {
                FUZZ_CHECK(def->components[j].wavelength > 0.0f && isfinite(def->components[j].phase));
            }
            swSeaState seaState;
            if (swSpectrum_GetSeaState(&scene->waves[i].def.spectrum, 0.0f, 0.0f, &seaState) == SW_SUCCESS)
            {
                FUZZ_CHECK(isfinite(seaState.significantHeight) && isfinite(seaState.periodTm02));
            }
        }
    }
    swDestroyScene(scene);
    return 0;
}
