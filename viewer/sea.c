// SPDX-License-Identifier: MIT
#include "sea.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void SayInSea(const Sea* sea, const char* text)
{
    if (sea->host->log != NULL)
    {
        sea->host->log(sea->host->logContext, SW_LOG_ERROR, text);
    }
}

// Settings of an open sea under a fresh breeze.
static void DescribeOpenSea(Sea* sea)
{
    snprintf(sea->name, sizeof(sea->name), "open sea");
    sea->worldDef = swDefaultWorldDef();
    sea->look.sky = swDefaultSkyDef();
    sea->look.water = swDefaultWaterDef();
    sea->wavesCount = 1;
    sea->waves[0] = (SeaWaves){.def = swDefaultWaveSystemDef(), .file = ""};
}

static bool TakeHandWaves(SeaWaves* waves, const swSceneWaves* from)
{
    waves->hand = calloc(1, sizeof(HandWaves));
    if (waves->hand == NULL)
    {
        return false;
    }
    waves->hand->filed = from->components;
    waves->hand->filedCount = from->componentCount;
    waves->def.componentCount = 0;
    waves->def.components = waves->hand->waves;
    for (int i = 0; i < from->componentCount; i++)
    {
        waves->hand->waves[i] = from->components[i];
        waves->hand->filedRows[i] = waves->hand->appliedRows[i] = i;
        waves->def.componentCount++;
    }
    return true;
}

static swResult DescribeScene(Sea* sea, const swScene* scene)
{
    snprintf(sea->name, sizeof(sea->name), "%s", scene->name);
    sea->worldDef = scene->world;
    sea->look.sky = scene->sky;
    sea->look.water = scene->water;
    sea->look.exposureEv = scene->exposureEv;
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
        if (from->componentCount > 0 && !TakeHandWaves(&sea->waves[i], from))
        {
            SayInSea(sea, "there is no memory for the scene's waves by hand");
            return SW_ERROR_NO_MEMORY;
        }
    }
    return SW_SUCCESS;
}

// What is described now is what the file has.
static void KeepFiled(Sea* sea)
{
    sea->look.foam = sea->worldDef.foam;
    sea->filedLook = sea->look;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        SeaWaves* waves = &sea->waves[i];
        waves->serial = sea->lastSerial++;
        waves->filedDef = waves->def;
        waves->filedRecord = waves->record;
        waves->filedReplay = waves->replayDef;
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

// Make a system in the world, with a weight of its own until the next change.
static swResult CreateWaves(Sea* sea, SeaWaves* waves, float weight)
{
    swMeasuredRecord record;
    swWaveSystemDef def = CompleteDef(waves, &record);
    swResult result = SW_SUCCESS;
    def.weight = weight;
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

swResult RaiseWaves(Sea* sea, SeaWaves* waves)
{
    swResult result = CreateWaves(sea, waves, 0.0f);
    waves->hasChanged = result == SW_SUCCESS;
    return result;
}

static swResult BuildSea(Sea* sea, uint32_t height)
{
    swViewDef usual = swDefaultViewDef();
    swViewDef viewDef = swGpu_FitView(sea->gpu, sea->scene ? &sea->scene->view : &usual, height);
    swPictureDef pictureDef = swDefaultPictureDef();
    swResult result = swCreateWorld(sea->host, &sea->worldDef, &sea->world);
    if (result == SW_SUCCESS)
    {
        swWorld_SetTime(sea->world, sea->scene ? sea->scene->time : 0.0);
    }
    for (int i = 0; i < sea->wavesCount && result == SW_SUCCESS; i++)
    {
        result = CreateWaves(sea, &sea->waves[i], sea->waves[i].def.weight);
    }
    result = result ? result : OpenInputs(sea);
    result = result ? result : swCreateView(sea->world, &viewDef, &sea->view);
    result = result ? result : swCreateGpuWorld(sea->gpu, sea->world, &sea->gpuWorld);
    result = result ? result : swCreateRenderer(sea->gpuWorld, &sea->renderer);
    return result ? result : swCreatePicture(sea->renderer, &pictureDef, &sea->picture);
}

bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, uint32_t height, const char* path)
{
    *sea = (Sea){.host = host, .gpu = gpu, .transition = 1.0f, .nextChange = (double)-INFINITY};
    swResult result = path ? swReadScene(host, path, &sea->scene) : SW_SUCCESS;
    if (result == SW_SUCCESS && sea->scene != NULL)
    {
        result = DescribeScene(sea, sea->scene);
    }
    else if (result == SW_SUCCESS)
    {
        DescribeOpenSea(sea);
    }
    if (result == SW_SUCCESS)
    {
        KeepFiled(sea);
        result = BuildSea(sea, height);
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
    swDestroyPicture(sea->picture);
    swDestroyRenderer(sea->renderer);
    swDestroyGpuWorld(sea->gpuWorld);
    swDestroyView(sea->view);
    for (int i = 0; i < sea->wavesCount; i++)
    {
        swDestroySeaReplay(sea->waves[i].replay);
        free(sea->waves[i].hand);
    }
    CloseInputs(sea);
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

// What the world has, where it refused something else. Tables and rows are still those of the panel.
static void RestoreDef(const Sea* sea, SeaWaves* waves)
{
    swWaveSystemDef def = swWaveSystem_Get(sea->world, waves->id);
    def.spectrum.table = waves->def.spectrum.table;
    if (waves->hand != NULL && def.componentCount > 0)
    {
        size_t count = (size_t)def.componentCount;
        memcpy(waves->hand->waves, def.components, count * sizeof(swWaveComponent));
        memcpy(waves->hand->filedRows, waves->hand->appliedRows, count * sizeof(int));
    }
    def.components = waves->def.components;
    waves->def = def;
}

// The world has taken the panel's waves.
static void KeepApplied(SeaWaves* waves)
{
    if (waves->hand != NULL)
    {
        memcpy(waves->hand->appliedRows, waves->hand->filedRows, sizeof(waves->hand->appliedRows));
    }
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
    else
    {
        KeepApplied(waves);
    }
    waves->hasChanged = false;
}

void ApplyChanges(Sea* sea, bool isPaused)
{
    double now = swWorld_GetTime(sea->world);
    double seconds = isPaused ? 0.0 : (double)sea->transition;
    bool isEarly = now < sea->nextChange && now > sea->nextChange - SW_MAX_TRANSITION; // or time was set back
    ClearLeavingWaves(sea, isPaused);
    ApplyInputs(sea);
    for (int i = 0; i < sea->wavesCount; i++)
    {
        SeaWaves* waves = &sea->waves[i];
        if (waves->hasChanged && !waves->isRemoved && (isPaused || !isEarly))
        {
            ApplyChange(sea, waves, seconds);
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
    MoveInputs(sea, time);
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

void ChangeReplayPlace(Sea* sea, int index, int location)
{
    sea->waves[index].replayDef.location = location;
    sea->waves[index].hasChanged = true;
}

double GetFiledReplaySeconds(const Sea* sea, int index)
{
    const swSeaReplayDef* filed = &sea->waves[index].filedReplay;
    return filed->startSeconds + (swWorld_GetTime(sea->world) - filed->startTime) * filed->speed;
}

void ResetReplayMoment(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    const swSeaReplayDef* filed = &waves->filedReplay;
    ChangeReplay(sea, index, GetFiledReplaySeconds(sea, index), waves->replayDef.speed);
    if (waves->replayDef.speed == filed->speed) // then the same from its start on, to the bit
    {
        waves->replayDef.startTime = filed->startTime;
        waves->replayDef.startSeconds = filed->startSeconds;
    }
}

float GetAskedHeight(const Sea* sea)
{
    float square = 0.0f;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        const SeaWaves* waves = &sea->waves[i];
        float height = waves->isRemoved ? 0.0f : waves->asked.significantHeight * waves->def.weight;
        square += height * height;
    }
    return sqrtf(square);
}

float GetCarriedHeight(const Sea* sea)
{
    float variance = 0.0f;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        if (sea->waves[i].isRemoved)
        {
            continue;
        }
        swBandInfo bands[SW_MAX_BANDS];
        int count = swWaveSystem_GetBands(sea->world, sea->waves[i].id, bands);
        for (int b = 0; b < count; b++)
        {
            variance += bands[b].variance;
        }
    }
    return 4.0f * sqrtf(variance);
}
