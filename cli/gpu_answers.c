// SPDX-License-Identifier: MIT
#include "gpu_answers.h"

#include <stdlib.h>

#include "seaway/stage.h"

#include "common.h"

struct GpuAnswers
{
    swStage* stage;
    swGpuWorld* world;
    swGpuQuery* query;
};

static swResult CreateSea(GpuAnswers* answers, const DeviceName* device, const swWorld* world, const swGpuQueryDef* def)
{
    swHost host = MakeHost();
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.choice = device->choice;
    gpuDef.deviceIndex = device->index;
    swResult result = swCreateStage(&host, &gpuDef, &answers->stage);
    result = result == SW_SUCCESS ? swCreateGpuWorld(swStage_GetGpu(answers->stage), world, &answers->world) : result;
    return result == SW_SUCCESS ? swCreateGpuQuery(answers->world, def, &answers->query) : result;
}

GpuAnswers* OpenGpuAnswers(const DeviceName* device, const swWorld* world, const swGpuQueryDef* def)
{
    GpuAnswers* answers = calloc(1, sizeof(GpuAnswers));
    if (answers == NULL)
    {
        Complain("no memory for a query");
        return NULL;
    }
    swResult result = CreateSea(answers, device, world, def);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the GPU cannot be asked; without --backend gpu the CPU answers");
        CloseGpuAnswers(answers);
        return NULL;
    }
    return answers;
}

void CloseGpuAnswers(GpuAnswers* answers)
{
    if (answers == NULL)
    {
        return;
    }
    if (answers->stage != NULL)
    {
        swStage_Wait(answers->stage);
    }
    swDestroyGpuQuery(answers->query);
    swDestroyGpuWorld(answers->world);
    swDestroyStage(answers->stage);
    free(answers);
}

static swResult RunFrame(GpuAnswers* answers)
{
    swStageFrame frame;
    swResult result = swStage_BeginFrame(answers->stage, &frame);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    result = swGpuWorld_Record(answers->world, frame.commands, frame.index);
    if (result != SW_SUCCESS)
    {
        swStage_DropFrame(answers->stage, &frame);
        return result;
    }
    result = swStage_SubmitFrame(answers->stage, &frame, NULL);
    return result == SW_SUCCESS ? swStage_Wait(answers->stage) : result;
}

static bool FetchResults(GpuAnswers* answers, swGpuQueryResults* results)
{
    swResult result = RunFrame(answers);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the device did not finish the query");
        return false;
    }
    bool isThere = swGpuQuery_GetResults(answers->query, results);
    if (!isThere)
    {
        Complain("the device gave no answers");
    }
    return isThere;
}

bool AskGpu(GpuAnswers* answers, int count, const swPosXZ* points, const swSurfaceSamples* samples)
{
    swGpuQuery_SetPoints(answers->query, count, points);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_Unpack(&results, samples, NULL);
    }
    return isThere;
}

bool AskGpuBelow(GpuAnswers* answers, int count, const swPos* places, const swVolumeSamples* samples)
{
    swGpuQuery_SetPlaces(answers->query, count, places);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_UnpackVolume(&results, samples, NULL);
    }
    return isThere;
}

bool AskGpuRays(GpuAnswers* answers, int count, const swRay* rays, swRayHit* hits)
{
    swGpuQuery_SetRays(answers->query, count, rays);
    swGpuQueryResults results;
    bool isThere = FetchResults(answers, &results);
    if (isThere)
    {
        swGpuQueryResults_UnpackHits(&results, rays, hits, NULL);
    }
    return isThere;
}
