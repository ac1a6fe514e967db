// SPDX-License-Identifier: MIT
#include "save.h"

#include <stdio.h>
#include <string.h>

// A view may have brought a sun of its own; the scene's is only changed if the user has moved it.
static void PutLook(const Sea* sea, swScene* scene)
{
    const SeaLook *look = &sea->look, *filed = &sea->filedLook;
    bool isSunMoved =
        look->sky.sunAzimuth != filed->sky.sunAzimuth || look->sky.sunElevation != filed->sky.sunElevation;
    float azimuth = scene->sky.sunAzimuth, elevation = scene->sky.sunElevation;
    scene->sky = look->sky;
    scene->sky.sunAzimuth = isSunMoved ? look->sky.sunAzimuth : azimuth;
    scene->sky.sunElevation = isSunMoved ? look->sky.sunElevation : elevation;
    scene->water = look->water;
    scene->world.foam = look->foam;
    scene->exposureEv = look->exposureEv;
}

// One system that the file has, whose measured sea is the scene's own.
static swResult PutWaves(const SeaWaves* waves, swScene* scene, int index)
{
    swSceneWaves* to = &scene->waves[index];
    swWaveSystemDef def = waves->def;
    def.spectrum.table = to->def.spectrum.table;
    swResult result = swScene_SetWaves(scene, index, &def);
    if (result == SW_SUCCESS && to->measured != NULL)
    {
        to->record = waves->record;
        to->replay.location = waves->replayDef.location;
        to->replay.startTime = waves->replayDef.startTime;
        to->replay.startSeconds = waves->replayDef.startSeconds;
        to->replay.speed = waves->replayDef.speed;
    }
    return result;
}

static swResult PutAllWaves(const Sea* sea, swScene* scene)
{
    int filedCount = 0;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        filedCount += sea->waves[i].isAdded ? 0 : 1;
    }
    // The open sea without a file has waves of its own, which no file has.
    bool isNew = scene->wavesCount == 0;
    if (!isNew && filedCount != scene->wavesCount)
    {
        SayInSea(sea, "the scene was not saved: the file has other wave systems than when it was read; read it again");
        return SW_ERROR_INVALID;
    }
    swResult result = SW_SUCCESS;
    for (int i = 0, at = 0; i < sea->wavesCount && result == SW_SUCCESS; i++)
    {
        const SeaWaves* waves = &sea->waves[i];
        bool isFiled = !waves->isAdded && !isNew;
        if (waves->isRemoved)
        {
            if (isFiled)
            {
                swScene_RemoveWaves(scene, at);
            }
            continue;
        }
        result = isFiled ? PutWaves(waves, scene, at) : swScene_AddWaves(scene, &waves->def);
        at += isFiled ? 1 : 0;
    }
    return result;
}

static bool HaveSamePoints(const swInputDef* a, const swInputDef* b)
{
    return a->pointCount == b->pointCount &&
           (a->pointCount == 0 || memcmp(a->points, b->points, (size_t)a->pointCount * sizeof(swInputPoint)) == 0);
}

// One that the file has: what its table has, and its points. What it names stays the scene's own.
static swResult PutInput(const SeaInput* input, swScene* scene, int at)
{
    swSceneInput* to = &scene->inputs[at];
    const swInputDef own = to->def;
    bool hasPoints = HasPoints(input->def.shape) && !HaveSamePoints(&input->def, &own);
    to->def = input->def;
    to->def.raster = own.raster;
    to->def.mesh = own.mesh;
    to->def.hull = own.hull;
    to->def.spline = own.spline;
    to->def.points = own.points;
    to->def.pointCount = own.pointCount;
    to->waves = input->def.field == SW_INPUT_WAVES ? to->waves : -1;
    return hasPoints ? swScene_SetInputPoints(scene, at, input->def.pointCount, input->def.points) : SW_SUCCESS;
}

static swResult PutInputs(const Sea* sea, swScene* scene)
{
    int inputs = sea->scene != NULL ? sea->scene->inputCount : 0, filedCount = 0;
    for (int i = 0; i < inputs; i++)
    {
        filedCount += sea->inputs[i].isAdded ? 0 : 1;
    }
    if (filedCount != scene->inputCount)
    {
        SayInSea(sea, "the scene was not saved: the file has other inputs than when it was read; read it again");
        return SW_ERROR_INVALID;
    }
    swResult result = SW_SUCCESS;
    for (int i = 0, at = 0; i < inputs && result == SW_SUCCESS; i++)
    {
        const SeaInput* input = &sea->inputs[i];
        if (input->isRemoved)
        {
            swScene_RemoveInput(scene, at);
            continue;
        }
        result = input->isAdded ? swScene_AddInput(scene, &input->def, -1) : PutInput(input, scene, at);
        at += 1;
    }
    return result;
}

static swResult PutBodies(const Sea* sea, swScene* scene)
{
    int bodies = sea->scene != NULL ? sea->scene->waterBodyCount : 0;
    if (bodies != scene->waterBodyCount)
    {
        SayInSea(sea,
                 "the scene was not saved: the file has other bodies of water than when it was read; read it again");
        return SW_ERROR_INVALID;
    }
    for (int i = 0; i < bodies; i++)
    {
        const swWaterBodyDef* from = &sea->bodies[i].def;
        swWaterBodyDef *to = &scene->waterBodies[i].def, own = *to;
        bool isSame = from->pointCount == own.pointCount &&
                      memcmp(from->points, own.points, (size_t)own.pointCount * sizeof(swVec2)) == 0;
        *to = *from;
        to->points = own.points;
        to->pointCount = own.pointCount;
        swResult result = isSame ? SW_SUCCESS : swScene_SetShore(scene, i, from->pointCount, from->points);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

swResult SaveSea(const Sea* sea, const char* from, const char* path)
{
    swScene* scene = NULL;
    swResult result = from != NULL ? swReadScene(sea->host, from, &scene) : swCreateScene(sea->host, &scene);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    PutLook(sea, scene);
    result = PutInputs(sea, scene);
    result = result == SW_SUCCESS ? PutBodies(sea, scene) : result;
    result = result == SW_SUCCESS ? PutAllWaves(sea, scene) : result;
    result = result == SW_SUCCESS ? swWriteScene(scene, path) : result;
    swDestroyScene(scene);
    return result;
}

bool NameScene(char* path, size_t size)
{
    for (int i = 1; i < 10000; i++)
    {
        snprintf(path, size, "seaway_%04d.yaml", i);
        FILE* file = fopen(path, "rb");
        if (file == NULL)
        {
            return true;
        }
        fclose(file);
    }
    return false;
}
