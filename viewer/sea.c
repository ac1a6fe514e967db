// SPDX-License-Identifier: MIT
#include "sea.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Settings of an open sea under a fresh breeze.
static void DescribeOpenSea(Sea* sea)
{
    snprintf(sea->name, sizeof(sea->name), "open sea");
    sea->worldDef = swDefaultWorldDef();
    sea->sky = swDefaultSkyDef();
    sea->water = swDefaultWaterDef();
    sea->wavesCount = 1;
    sea->waves[0] = (SeaWaves){.def = swDefaultWaveSystemDef(), .file = ""};
}

// Waves by hand are copied, to be changed. Without memory the scene's own are shown, which nobody can change.
static void TakeComponents(SeaWaves* waves)
{
    size_t size = (size_t)waves->def.componentCount * sizeof(swWaveComponent);
    waves->components = size > 0 ? malloc(size) : NULL;
    if (waves->components != NULL)
    {
        memcpy(waves->components, waves->def.components, size);
        waves->def.components = waves->components;
    }
}

static void DescribeScene(Sea* sea, const swScene* scene)
{
    snprintf(sea->name, sizeof(sea->name), "%s", scene->name);
    sea->worldDef = scene->world;
    sea->sky = scene->sky;
    sea->water = scene->water;
    sea->exposureEv = scene->exposureEv;
    sea->wavesCount = scene->wavesCount;
    for (int i = 0; i < scene->wavesCount; i++)
    {
        const swSceneWaves* from = &scene->waves[i];
        sea->waves[i] = (SeaWaves){.def = from->def,
                                   .measured = from->measured,
                                   .record = from->record,
                                   .file = from->file,
                                   .replayDef = from->replay,
                                   .records = {-1, -1}};
        TakeComponents(&sea->waves[i]);
    }
}

// A measured system's def with its record's table, which `record` keeps for as long as the def is used.
static swWaveSystemDef CompleteDef(const SeaWaves* waves, swMeasuredRecord* record)
{
    swWaveSystemDef def = waves->def;
    if (waves->measured != NULL)
    {
        *record = swMeasuredSea_GetRecord(waves->measured, waves->record);
        def.spectrum.table = &record->table;
    }
    return def;
}

static swResult FindAsked(SeaWaves* waves, const swSpectrumDef* spectrum)
{
    float variance = 0.0f;
    for (int i = 0; i < waves->def.componentCount; i++)
    {
        variance += 0.5f * waves->def.components[i].amplitude * waves->def.components[i].amplitude;
    }
    if (waves->def.componentCount > 0)
    {
        waves->asked = (swSeaState){.significantHeight = 4.0f * sqrtf(variance)};
        return SW_SUCCESS;
    }
    return swSpectrum_GetSeaState(spectrum, 0.0f, 0.0f, &waves->asked);
}

static swResult CreateWaves(Sea* sea, SeaWaves* waves)
{
    swMeasuredRecord record;
    swWaveSystemDef def = CompleteDef(waves, &record);
    swResult result = SW_SUCCESS;
    if (waves->replayDef.sea != NULL)
    {
        swSeaReplayDef replay = waves->replayDef;
        replay.waves = def;
        result = swCreateSeaReplay(sea->world, &replay, &waves->replay);
        waves->id = result == SW_SUCCESS ? swSeaReplay_GetSystem(waves->replay) : waves->id;
    }
    else
    {
        result = swCreateWaveSystem(sea->world, &def, &waves->id);
    }
    return result ? result : FindAsked(waves, &def.spectrum);
}

static swResult BuildSea(Sea* sea)
{
    swViewDef viewDef = sea->scene ? sea->scene->view : swDefaultViewDef();
    swRendererDef rendererDef = swDefaultRendererDef();
    swResult result = swCreateWorld(sea->host, &sea->worldDef, &sea->world);
    if (result == SW_SUCCESS)
    {
        swWorld_SetTime(sea->world, sea->scene ? sea->scene->time : 0.0);
    }
    for (int i = 0; i < sea->wavesCount && result == SW_SUCCESS; i++)
    {
        result = CreateWaves(sea, &sea->waves[i]);
    }
    result = result ? result : swCreateView(sea->world, &viewDef, &sea->view);
    result = result ? result : swCreateGpuWorld(sea->gpu, sea->world, &sea->gpuWorld);
    return result ? result : swCreateRenderer(sea->gpuWorld, &rendererDef, &sea->renderer);
}

bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, const char* path)
{
    *sea = (Sea){.host = host, .gpu = gpu, .transition = 1.0f, .nextChange = (double)-INFINITY};
    swResult result = path ? swReadScene(host, path, &sea->scene) : SW_SUCCESS;
    if (result == SW_SUCCESS)
    {
        if (sea->scene != NULL)
        {
            DescribeScene(sea, sea->scene);
        }
        else
        {
            DescribeOpenSea(sea);
        }
        result = BuildSea(sea);
    }
    if (result != SW_SUCCESS)
    {
        CloseSea(sea);
        return false;
    }
    return true;
}

void CloseSea(Sea* sea)
{
    swDestroyRenderer(sea->renderer);
    swDestroyGpuWorld(sea->gpuWorld);
    swDestroyView(sea->view);
    for (int i = 0; i < sea->wavesCount; i++)
    {
        swDestroySeaReplay(sea->waves[i].replay);
        free(sea->waves[i].components);
    }
    swDestroyWorld(sea->world);
    if (sea->scene != NULL)
    {
        swDestroyScene(sea->scene);
    }
    *sea = (Sea){0};
}

// Hand the system over to a replay with other settings; it goes on from where the sea is.
static swResult ReplaceReplay(Sea* sea, SeaWaves* waves, const swWaveSystemDef* def)
{
    swSeaReplay* fresh = NULL;
    swSeaReplayDef replay = waves->replayDef;
    replay.waves = *def;
    replay.system = waves->id;
    swResult result = swCreateSeaReplay(sea->world, &replay, &fresh);
    if (result == SW_SUCCESS)
    {
        swDestroySeaReplay(waves->replay);
        waves->replay = fresh;
        waves->records[0] = waves->records[1] = -1; // their height may have been set
        swWaveSystem_SetWeight(sea->world, waves->id, def->weight);
    }
    return result;
}

// What the world has, where it refused something else. Tables and components are still those of the panel.
static void RestoreDef(const Sea* sea, SeaWaves* waves)
{
    swWaveSystemDef def = swWaveSystem_Get(sea->world, waves->id);
    def.spectrum.table = waves->def.spectrum.table;
    size_t size = (size_t)def.componentCount * sizeof(swWaveComponent);
    if (waves->components != NULL && size > 0)
    {
        memcpy(waves->components, def.components, size);
    }
    def.components = waves->def.components;
    waves->def = def;
}

static void ApplyChange(Sea* sea, SeaWaves* waves, double seconds)
{
    swMeasuredRecord record;
    swWaveSystemDef def = CompleteDef(waves, &record);
    swResult result = FindAsked(waves, &def.spectrum);
    if (result == SW_SUCCESS)
    {
        result = waves->replay != NULL ? ReplaceReplay(sea, waves, &def)
                                       : swWaveSystem_Set(sea->world, waves->id, &def, seconds);
    }
    if (result != SW_SUCCESS)
    {
        RestoreDef(sea, waves);
        def = CompleteDef(waves, &record);
        FindAsked(waves, &def.spectrum);
    }
    waves->hasChanged = false;
}

void ApplyChanges(Sea* sea, bool isPaused)
{
    double now = swWorld_GetTime(sea->world);
    double seconds = isPaused ? 0.0 : (double)sea->transition;
    bool isEarly = now < sea->nextChange && now > sea->nextChange - SW_MAX_TRANSITION; // or time was set back
    for (int i = 0; i < sea->wavesCount; i++)
    {
        if (sea->waves[i].hasChanged && (isPaused || !isEarly))
        {
            ApplyChange(sea, &sea->waves[i], seconds);
            sea->nextChange = now + 0.4 * seconds;
        }
    }
}

// What a replay asks for now: energy runs evenly from one record to the other, the rest is that of the nearer one.
static void FollowReplay(SeaWaves* waves)
{
    int records[2];
    double fraction = 0.0;
    swSeaReplay_GetRecords(waves->replay, &records[0], &records[1], &fraction);
    for (int i = 0; i < 2; i++)
    {
        if (records[i] != waves->records[i])
        {
            swMeasuredRecord record = swMeasuredSea_GetRecord(waves->measured, records[i]);
            swSpectrumDef spectrum = waves->def.spectrum;
            spectrum.table = &record.table;
            swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &waves->recorded[i]);
            waves->records[i] = records[i];
        }
    }
    float a = waves->recorded[0].significantHeight, b = waves->recorded[1].significantHeight, part = (float)fraction;
    waves->asked = waves->recorded[part < 0.5f ? 0 : 1];
    waves->asked.significantHeight = sqrtf((1.0f - part) * a * a + part * b * b);
}

bool AdvanceSea(Sea* sea, double time)
{
    for (int i = 0; i < sea->wavesCount; i++)
    {
        SeaWaves* waves = &sea->waves[i];
        if (waves->replay != NULL && swSeaReplay_Advance(waves->replay, time) != SW_SUCCESS)
        {
            return false;
        }
        if (waves->replay != NULL)
        {
            FollowReplay(waves);
        }
    }
    return true;
}

double GetReplaySeconds(const Sea* sea, int index)
{
    const swSeaReplayDef* replay = &sea->waves[index].replayDef;
    return replay->startSeconds + (swWorld_GetTime(sea->world) - replay->startTime) * replay->speed;
}

void ChangeReplay(Sea* sea, int index, double seconds, double speed)
{
    SeaWaves* waves = &sea->waves[index];
    waves->replayDef.startTime = swWorld_GetTime(sea->world);
    waves->replayDef.startSeconds = seconds;
    waves->replayDef.speed = speed;
    waves->hasChanged = true;
}

float GetAskedHeight(const Sea* sea)
{
    float square = 0.0f;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        float height = sea->waves[i].asked.significantHeight * sea->waves[i].def.weight;
        square += height * height;
    }
    return sqrtf(square);
}

float GetCarriedHeight(const Sea* sea)
{
    float variance = 0.0f;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        swBandInfo bands[SW_MAX_BANDS];
        int count = swWaveSystem_GetBands(sea->world, sea->waves[i].id, bands);
        for (int b = 0; b < count; b++)
        {
            variance += bands[b].variance;
        }
    }
    return 4.0f * sqrtf(variance);
}
