// SPDX-License-Identifier: MIT
#include "golden/canvas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_PASSES 48

struct Canvas
{
    swHost host;
    swStage* stage;
    swGpu* gpu;
    swStageTargets targets;
    swStageBuffer readback;
    uint32_t width, height;
};

// One sea and its twin.
typedef struct Sea
{
    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swRenderer* renderer;
    swPicture* picture;
    swStageTerrain* terrain; // NULL: no land
} Sea;

static float Radians(float degrees)
{
    return degrees * (float)(SW_PI / 180.0);
}

Canvas* CreateCanvas(uint32_t width, uint32_t height, bool enableValidation)
{
    return CreateCanvasBy(width, height, enableValidation, NULL);
}

Canvas* CreateCanvasBy(uint32_t width, uint32_t height, bool enableValidation, PFN_vkGetInstanceProcAddr loader)
{
    Canvas* canvas = calloc(1, sizeof(*canvas));
    if (!canvas)
    {
        return NULL;
    }
    canvas->host = swDefaultHost();
    canvas->width = width;
    canvas->height = height;
    swGpuDef def = swDefaultGpuDef();
    def.getInstanceProcAddr = loader;
    def.enableValidation = enableValidation;
    def.layers = SW_LAYERS_CORE; // where a shot has them
    bool isReady = swCreateStage(&canvas->host, &def, &canvas->stage) == SW_SUCCESS &&
                   swStage_CreateTargets(canvas->stage, width, height, 0, 0, &canvas->targets) == SW_SUCCESS &&
                   swStage_CreateBuffer(canvas->stage, 8ull * width * height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                        &canvas->readback) == SW_SUCCESS;
    if (!isReady)
    {
        DestroyCanvas(canvas);
        return NULL;
    }
    canvas->gpu = swStage_GetGpu(canvas->stage);
    return canvas;
}

void DestroyCanvas(Canvas* canvas)
{
    if (!canvas)
    {
        return;
    }
    if (canvas->stage)
    {
        swStage_Wait(canvas->stage);
        swStage_DestroyTargets(canvas->stage, &canvas->targets);
        swStage_DestroyBuffer(canvas->stage, &canvas->readback);
        swDestroyStage(canvas->stage);
    }
    free(canvas);
}

static void DestroySea(const Canvas* canvas, Sea* sea)
{
    swStage_DestroyTerrain(canvas->stage, sea->terrain);
    swDestroyPicture(sea->picture);
    swDestroyRenderer(sea->renderer);
    swDestroyGpuWorld(sea->gpuWorld);
    swDestroyView(sea->view);
    swDestroyWorld(sea->world);
}

static bool CreateSea(const Canvas* canvas, const Shot* shot, Sea* sea)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = shot->hasCoreLayers;
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum.windSpeed = shot->windSpeed;
    waves.spectrum.direction = SW_DIRECTION_FROM_BEARING(240.0);
    waves = shot->waves != NULL ? *shot->waves : waves;
    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.spectrum.kind = SW_SPECTRUM_JONSWAP;
    swell.spectrum.significantHeight = shot->swellHeight;
    swell.spectrum.peakPeriod = 11.0f;
    swell.spectrum.gamma = 5.0f;
    swell.spectrum.spreadExponent = 60.0f;
    swell.spectrum.direction = SW_DIRECTION_FROM_BEARING(300.0);
    swell.minWavelength = 32.0f;
    swell.seed = 7;
    swViewDef viewDef = swDefaultViewDef();
    viewDef.enableCpuLayers = shot->hasCoreLayers;
    swPictureDef pictureDef = swDefaultPictureDef();
    swStageTerrainDef land = swDefaultStageTerrainDef();
    land.floor = shot->floor;
    land.context = shot->floorContext;
    swWaveSystemId id;
    return swCreateWorld(&canvas->host, &worldDef, &sea->world) == SW_SUCCESS &&
           swCreateWaveSystem(sea->world, &waves, &id) == SW_SUCCESS &&
           (shot->swellHeight <= 0.0f || swCreateWaveSystem(sea->world, &swell, &id) == SW_SUCCESS) &&
           swCreateView(sea->world, &viewDef, &sea->view) == SW_SUCCESS &&
           swCreateGpuWorld(canvas->gpu, sea->world, &sea->gpuWorld) == SW_SUCCESS &&
           swCreateRenderer(sea->gpuWorld, &sea->renderer) == SW_SUCCESS &&
           swCreatePicture(sea->renderer, &pictureDef, &sea->picture) == SW_SUCCESS &&
           (shot->floor == NULL || swStage_CreateTerrain(canvas->stage, &land, &sea->terrain) == SW_SUCCESS);
}

static bool PutInputs(swWorld* world, const Shot* shot)
{
    bool isGood = true;
    for (int i = 0; i < shot->inputCount; ++i)
    {
        swInputId id;
        isGood = isGood && swCreateInput(world, &shot->inputs[i], &id) == SW_SUCCESS;
    }
    for (int i = 0; i < shot->bodyCount; ++i)
    {
        swWaterBodyId id;
        isGood = isGood && swCreateWaterBody(world, &shot->bodies[i], &id) == SW_SUCCESS;
    }
    return isGood;
}

static float HalfToFloat(uint16_t half)
{
    int exponent = (half >> 10) & 31;
    float mantissa = (float)(half & 1023) / 1024.0f;
    float value = exponent == 0    ? ldexpf(mantissa, -14)
                  : exponent == 31 ? (half & 1023 ? NAN : INFINITY)
                                   : ldexpf(1.0f + mantissa, exponent - 15);
    return half & 0x8000 ? -value : value;
}

static bool RecordAll(Canvas* canvas, Sea* sea, swShot* what, bool readHdr, const swStageFrame* frame)
{
    if (swGpuWorld_Record(sea->gpuWorld, frame->commands, frame->index) != SW_SUCCESS)
    {
        return false;
    }
    if (!what)
    {
        return true;
    }
    if (sea->terrain && swStageTerrain_Prepare(sea->terrain, &canvas->targets, what) != SW_SUCCESS)
    {
        return false;
    }
    if (swPicture_Prepare(sea->picture, frame->commands, what, frame->index) != SW_SUCCESS)
    {
        return false;
    }
    const swStageTargets* targets = &canvas->targets;
    swStage_DrawPicture(canvas->stage, frame->commands, sea->picture, targets, sea->terrain, 0.0f, true);
    swStage_CopyToHost(canvas->stage, frame->commands, readHdr ? &targets->hdr : &targets->output,
                       readHdr ? SW_STAGE_USE_SAMPLED : SW_STAGE_USE_COLOR_TARGET, &canvas->readback);
    return true;
}

// One frame, of the waves alone or with the what.
static bool RunFrame(Canvas* canvas, Sea* sea, swShot* what, bool readHdr, bool isDroppedFirst)
{
    swStageFrame frame;
    if (isDroppedFirst)
    {
        bool isRecorded =
            swStage_BeginFrame(canvas->stage, &frame) == SW_SUCCESS && RecordAll(canvas, sea, what, readHdr, &frame);
        if (!isRecorded)
        {
            return false;
        }
        swStage_DropFrame(canvas->stage, &frame);
        swGpuWorld_Discard(sea->gpuWorld, frame.index);
    }
    if (swStage_BeginFrame(canvas->stage, &frame) != SW_SUCCESS)
    {
        return false;
    }
    if (!RecordAll(canvas, sea, what, readHdr, &frame))
    {
        swStage_DropFrame(canvas->stage, &frame);
        return false;
    }
    return swStage_SubmitFrame(canvas->stage, &frame, NULL) == SW_SUCCESS && swStage_Wait(canvas->stage) == SW_SUCCESS;
}

static bool DrawSea(Canvas* canvas, Sea* sea, const Shot* shot, uint8_t* pixels, float* hdr)
{
    swShot what = {.view = sea->view, .sky = swDefaultSkyDef(), .water = swDefaultWaterDef()};
    what.water.foamAlbedo = shot->hasBlackFoam ? (swVec3){0.0f, 0.0f, 0.0f} : what.water.foamAlbedo;
    what.camera = swMakeCamera((swPos){shot->x, (double)shot->height, shot->z}, Radians(shot->headingDeg),
                               Radians(shot->pitchDeg), 0.0f, Radians(shot->fovDeg), canvas->width, canvas->height);
    what.sky.sunAzimuth = Radians(shot->sunAzimuthDeg);
    what.sky.sunElevation = Radians(shot->sunElevationDeg);
    what.sky.haze = shot->haze;
    what.sky.clouds = shot->clouds;
    what.water.windSpeed = shot->windSpeed;
    what.bodyWaters = shot->bodyWaters;
    what.bodyWaterCount = shot->bodyWaterCount;
    what.debug = shot->debug;
    what.time = shot->time;

    swView_SetViewpoint(sea->view, what.camera.position);
    swWorld_SetTime(sea->world, shot->time - 0.1 * shot->steps);
    bool isGood = swWorld_Step(sea->world, 0.0) == SW_SUCCESS;
    for (int i = 0; i < shot->steps && isGood; ++i)
    {
        isGood = RunFrame(canvas, sea, NULL, false, shot->dropsCommands) && swWorld_Step(sea->world, 0.1) == SW_SUCCESS;
    }
    size_t count = 4ull * canvas->width * canvas->height;
    if (isGood && pixels)
    {
        isGood = RunFrame(canvas, sea, &what, false, shot->dropsCommands);
        memcpy(pixels, canvas->readback.data, count);
    }
    if (isGood && hdr)
    {
        isGood = RunFrame(canvas, sea, &what, true, shot->dropsCommands);
        const uint16_t* halves = canvas->readback.data;
        for (size_t i = 0; i < count; ++i)
        {
            hdr[i] = HalfToFloat(halves[i]);
        }
    }
    return isGood;
}

bool DrawShot(Canvas* canvas, const Shot* shot, uint8_t* pixels, float* hdr)
{
    Sea sea = {0};
    bool isGood =
        CreateSea(canvas, shot, &sea) && PutInputs(sea.world, shot) && DrawSea(canvas, &sea, shot, pixels, hdr);
    swStage_Wait(canvas->stage);
    DestroySea(canvas, &sea);
    return isGood;
}

swStage* GetCanvasStage(const Canvas* canvas)
{
    return canvas->stage;
}

const swGpu* GetCanvasGpu(const Canvas* canvas)
{
    return canvas->gpu;
}

const char* GetCanvasDevice(const Canvas* canvas)
{
    return swGpu_GetDeviceName(canvas->gpu);
}

int GetCanvasValidationCount(const Canvas* canvas)
{
    return swGpu_GetValidationCount(canvas->gpu);
}

void PrintCanvasTimes(const Canvas* canvas)
{
    swPassTime times[MAX_PASSES];
    int count = swGpu_GetPassTimes(canvas->gpu, times, MAX_PASSES);
    for (int i = 0; i < count; ++i)
    {
        printf("%-16s %9.2f ms\n", times[i].name, (double)times[i].milliseconds);
    }
}
