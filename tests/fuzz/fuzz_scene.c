// SPDX-License-Identifier: MIT
// Scene texts from anywhere. What is read can be asked for its views and its seas; what is not is explained. What is
// read is written as it was, and after a change it is read again with that change or refused with a sentence.

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "fuzz.h"
#include "seaway/scene.h"

#define ROOM ((size_t)1 << 21)

// By a number that comes from the text, so that the same text is changed in the same way.
static void ChangeScene(swScene* scene, uint32_t how)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    swSceneView view = swDefaultSceneView();
    scene->sky.haze = how % 2 == 0 ? scene->sky.haze : 2.5f;
    scene->exposureEv = how % 3 == 0 ? scene->exposureEv : -1.0f;
    for (int i = 0; i < scene->wavesCount && how % 5 == 0; ++i)
    {
        scene->waves[i].def.spectrum.turbulence = 0.25f;
        scene->waves[i].def.weight = 2.0f;
    }
    if (how % 7 < 2 && scene->wavesCount > 0)
    {
        swScene_RemoveWaves(scene, (int)(how % (uint32_t)scene->wavesCount));
    }
    if (how % 7 > 4)
    {
        def.spectrum = swMakeBeaufortSpectrum(4.0f, 1.0f);
        swScene_AddWaves(scene, &def);
    }
    if (how % 13 < 3 && scene->inputCount > 0)
    {
        swScene_RemoveInput(scene, (int)(how % (uint32_t)scene->inputCount));
    }
    for (int i = 0; how % 13 > 10 && i < scene->inputCount; ++i)
    {
        scene->inputs[i].def.field = SW_INPUT_FLOW;
        scene->inputs[i].def.tide[0].amplitude = 1.5f;
        for (int k = 0; k < scene->inputs[i].pointCount; ++k)
        {
            scene->inputs[i].points[k].x += 1.0f;
        }
    }
    if (how % 17 < 4)
    {
        const swInputDef input = swDefaultInputDef();
        swScene_AddInput(scene, &input, -1);
    }
    if (how % 11 < 3 && scene->viewCount > 0)
    {
        swScene_RemoveView(scene, (int)(how % (uint32_t)scene->viewCount));
    }
    if (how % 11 > 8)
    {
        memcpy(view.name, "fuzz: #1", 9);
        swScene_AddView(scene, &view);
    }
}

static void CheckWriting(const swHost* host, swScene* scene, const uint8_t* data, size_t size, int* messages)
{
    char* text = malloc(ROOM);
    size_t made = ROOM;
    uint32_t how = (uint32_t)size;
    FUZZ_CHECK(text != NULL);
    for (size_t i = 0; i < size; ++i)
    {
        how = 31u * how + data[i];
    }
    bool isWide = size >= 2 && (memcmp(data, "\xFF\xFE", 2) == 0 || memcmp(data, "\xFE\xFF", 2) == 0);
    swResult result = swPrintScene(scene, text, &made);
    FUZZ_CHECK(isWide == (result != SW_SUCCESS));
    FUZZ_CHECK(isWide || (made == size && memcmp(text, data, size) == 0));
    ChangeScene(scene, how);
    made = ROOM;
    *messages = 0;
    result = swPrintScene(scene, text, &made);
    FUZZ_CHECK(result == SW_SUCCESS || *messages > 0);
    swScene* again = NULL;
    if (result == SW_SUCCESS)
    {
        FUZZ_CHECK(swReadSceneText(host, text, made, "again", "/nonexistent", &again) == SW_SUCCESS);
        FUZZ_CHECK(again->sky.haze == scene->sky.haze && again->exposureEv == scene->exposureEv);
        FUZZ_CHECK(again->wavesCount == scene->wavesCount && again->viewCount == scene->viewCount);
        FUZZ_CHECK(strcmp(again->name, scene->name) == 0);
    }
    swDestroyScene(again);
    free(text);
}

// A scene with inputs is opened: it answers numbers, and remarks are sentences, or it is refused with one.
static void CheckWorld(const swHost* host, const swScene* scene, const int* messages)
{
    swWorld* world = NULL;
    int before = *messages;
    swResult result = swCreateSceneWorld(host, scene, &world);
    FUZZ_CHECK((result == SW_SUCCESS) == (world != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || *messages > before);
    swSceneRemark remarks[8];
    int count = swScene_Check(scene, world, 8, remarks);
    for (int i = 0; i < count && i < 8; ++i)
    {
        FUZZ_CHECK(remarks[i].code != NULL && strlen(remarks[i].text) > 0 && remarks[i].line >= 0);
    }
    if (world != NULL)
    {
        const swPosXZ points[3] = {{0.0, 0.0}, {20.0, 3.0}, {1e6, -1e6}};
        float depth[3], level[3], clip[3];
        const swFieldSamples samples = {.depth = depth, .level = level, .clip = clip};
        FUZZ_CHECK(swMoment_QueryFields(swWorld_GetMoment(world), 3, points, &samples) == 0);
        for (int i = 0; i < 3; ++i)
        {
            FUZZ_CHECK(!isnan(depth[i]) && isfinite(level[i]) && isfinite(clip[i]));
        }
    }
    swDestroyWorld(world);
}

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
    if (scene != NULL && scene->inputCount > 0)
    {
        CheckWorld(&host, scene, &messages);
    }
    if (scene != NULL)
    {
        CheckWriting(&host, scene, data, size, &messages);
    }
    swDestroyScene(scene);
    return 0;
}
