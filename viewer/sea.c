// SPDX-License-Identifier: MIT
#include "sea.h"

#include <math.h>
#include <stdio.h>

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
        sea->waves[i] =
            (SeaWaves){.def = from->def, .measured = from->measured, .record = from->record, .file = from->file};
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

static swResult CreateWaves(Sea* sea, SeaWaves* waves)
{
    swMeasuredRecord record;
    swWaveSystemDef def = CompleteDef(waves, &record);
    swResult result = swCreateWaveSystem(sea->world, &def, &waves->id);
    return result ? result : swSpectrum_GetSeaState(&def.spectrum, 0.0f, 0.0f, &waves->asked);
}

static swResult BuildSea(Sea* sea)
{
    swViewDef viewDef = sea->scene ? sea->scene->view : swDefaultViewDef();
    swRendererDef rendererDef = swDefaultRendererDef();
    swResult result = swCreateWorld(sea->host, &sea->worldDef, &sea->world);
    for (int i = 0; i < sea->wavesCount && result == SW_SUCCESS; i++)
    {
        result = CreateWaves(sea, &sea->waves[i]);
    }
    result = result ? result : swCreateView(sea->world, &viewDef, &sea->view);
    result = result ? result : swCreateGpuWorld(sea->gpu, sea->world, &sea->gpuWorld);
    result = result ? result : swCreateRenderer(sea->gpuWorld, &rendererDef, &sea->renderer);
    if (result == SW_SUCCESS)
    {
        swWorld_SetTime(sea->world, sea->scene ? sea->scene->time : 0.0);
    }
    return result;
}

bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, const char* path)
{
    *sea = (Sea){.host = host, .gpu = gpu};
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
    swDestroyWorld(sea->world);
    if (sea->scene != NULL)
    {
        swDestroyScene(sea->scene);
    }
    *sea = (Sea){0};
}

// Whether only spectrum and weight differ, which a living system can take.
static bool KeepsSystem(const swWaveSystemDef* a, const swWaveSystemDef* b)
{
    return a->resolution == b->resolution && a->tileWaves == b->tileWaves && a->minWavelength == b->minWavelength &&
           a->maxWavelength == b->maxWavelength && a->chop == b->chop && a->loopPeriod == b->loopPeriod &&
           a->seed == b->seed;
}

static swResult ReplaceWaves(Sea* sea, SeaWaves* waves)
{
    swWaveSystemId old = waves->id;
    swResult result = CreateWaves(sea, waves);
    if (result == SW_SUCCESS)
    {
        swDestroyWaveSystem(sea->world, old);
    }
    return result;
}

static swResult UpdateWaves(Sea* sea, SeaWaves* waves)
{
    swMeasuredRecord record;
    swWaveSystemDef def = CompleteDef(waves, &record);
    swResult result = swWaveSystem_SetSpectrum(sea->world, waves->id, &def.spectrum);
    result = result ? result : swSpectrum_GetSeaState(&def.spectrum, 0.0f, 0.0f, &waves->asked);
    if (result == SW_SUCCESS)
    {
        swWaveSystem_SetWeight(sea->world, waves->id, def.weight);
    }
    return result;
}

bool ChangeWaves(Sea* sea, int index, const swWaveSystemDef* def, int record)
{
    SeaWaves changed = sea->waves[index];
    bool keepsSystem = KeepsSystem(&changed.def, def);
    changed.def = *def;
    changed.record = record;
    swResult result = keepsSystem ? UpdateWaves(sea, &changed) : ReplaceWaves(sea, &changed);
    if (result == SW_SUCCESS)
    {
        sea->waves[index] = changed;
    }
    return result == SW_SUCCESS;
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
