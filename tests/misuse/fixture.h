// SPDX-License-Identifier: MIT
#pragma once

// What generated misuses work with: one valid object of each kind, and a child process for each misuse, so that one
// that crashes is counted and the others are still tried.

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "seaway/measure.h"
#include "seaway/seaway.h"
#if MISUSE_GPU
#include "gpu/record/record.h"
#include "seaway/layers.h"
#include "seaway/lines.h"
#include "seaway/sheet.h"
#include "seaway/stage.h"
#endif
#if MISUSE_SCENE
#include "seaway/files.h"
#include "seaway/scene.h"
#endif

typedef struct Fixture
{
    swHost host;
    int sentences;
    char last[600];
    bool isTold; // messages that are no misuse go elsewhere

    swWorld* world;
    swMoment* moment;
    swView* view;
    swWaveSystemId id, staleId;
    swTaskPool* taskPool;
    swMeasuredSea* measuredSea;
    swMeasuredSpectrumDef spectrumDef;
    swSeaReplay* seaReplay;
    swSeaReplayDef replayDef;
    swWaveSystemDef wavesDef;
    swSea sea;
    swNdbcTexts texts;
    swSurfaceSamples samples;
    swVolumeSamples volume;
    swHeightMapDef map;
    swSeaPatches* seaPatches;
    swRaster* raster;
    swRaster* rasters[4];
    swRasterDef rasterDef;
    swSpline* spline;
    swSplineDef splineDef;
    swFieldSamples fieldSamples;
    swInputId inputId, staleInputId;
    swWaterBodyDef waterBodyDef;
    swWaterBodyId waterBodyId, staleWaterBodyId;
    swHull* hull;
    swHullDef hullDef;
    swMesh* mesh;
    swMeshDef meshDef;
    swSeaBins bins;
    swSeaGauges gauges;
#if MISUSE_GPU
    swStage* stage;
    swStageTargets targets;
    swStageImage image;
    swStageBuffer buffer;
    swStageFrame frame;
    swStageTerrain* stageTerrain;
    swStageTerrainDef terrainDef;
    swSheet* sheet;
    swStageLines* stageLines;
    swSheetDef sheetDef;
    swGpu* gpu;
    swGpuWorld* gpuWorld;
    swGpuQuery* gpuQuery;
    swRenderer* renderer;
    swPicture* picture;
    swShot shot;
    VkCommandBuffer VkCommandBuffer;
    VkInstance VkInstance;
    VkPhysicalDevice VkPhysicalDevice;
    VkImageView VkImageView;
    VkBuffer VkBuffer;
    PFN_vkGetInstanceProcAddr PFN_vkGetInstanceProcAddr;
#endif
#if MISUSE_SCENE
    swScene* scene;
    swSceneSea sceneSea;
    swSceneView sceneView;
#endif

    char text[64];
    _Alignas(64) char zeros[1 << 16];
    _Alignas(64) char room[1 << 16];
} Fixture;

#define FIX_swFields (swGetFoamFields())
#define FIX_swField (&swGetFoamFields()->fields[0])
#define FIX_swHost (&f->host)
#define FIX_swWaveSystemId (f->id)
#define FIX_swInputId (f->inputId)
#define FIX_swWaterBodyDef (&f->waterBodyDef)
#define FIX_swWaterBodyId (f->waterBodyId)
#define FIX_STALE_swInputId (f->staleInputId)
#define FIX_STALE_swWaterBodyId (f->staleWaterBodyId)
#define FIX_STALE_swWaveSystemId (f->staleId)
#define FIX_swFieldSamples (&f->fieldSamples)
#define FIX_swSeaReplayDef (&f->replayDef)
#define FIX_swMeasuredSpectrumDef (&f->spectrumDef)
#define FIX_swWaveSystemDef (&f->wavesDef)
#define FIX_swSea (&f->sea)
#define FIX_swNdbcTexts (&f->texts)
#define FIX_swSurfaceSamples (&f->samples)
#define FIX_swVolumeSamples (&f->volume)
#define FIX_swHeightMapDef (&f->map)
#define FIX_swRasterDef (&f->rasterDef)
#define FIX_swSplineDef (&f->splineDef)
#define FIX_swHullDef (&f->hullDef)
#define FIX_swMeshDef (&f->meshDef)
#define FIX_swSeaBins (&f->bins)
#define FIX_swSeaGauges (&f->gauges)
#define FIX_swShot (&f->shot)
#define FIX_swStageImage (&f->image)
#define FIX_swStageBuffer (&f->buffer)
#define FIX_swStageFrame (&f->frame)
#define FIX_swStageTargets (&f->targets)
#define FIX_swStageTerrainDef (&f->terrainDef)
#define FIX_swSheetDef (&f->sheetDef)
#define FIX_swScene (f->scene)
#define FIX_swSceneSea (&f->sceneSea)
#define FIX_swSceneView (&f->sceneView)

typedef struct Case
{
    const char* text;
    void (*run)(Fixture* f);
} Case;

// What a child says by its exit code.
enum
{
    FINE = 0,
    SUCCEEDED = 101,
    NOT_NULL,
    NOT_TOLD
};

static void CountSentence(void* context, swLogLevel level, const char* message)
{
    Fixture* f = context;
    (void)level;
    f->sentences += 1;
    snprintf(f->last, sizeof f->last, "%s", message);
}

// Used by some programs and not by others.
static inline void CheckRefused(swResult result)
{
    if (result == SW_SUCCESS)
    {
        _exit(SUCCEEDED);
    }
}

static inline void CheckNull(const void* made)
{
    if (made != NULL)
    {
        _exit(NOT_NULL);
    }
}

static inline void CheckTold(const Fixture* f)
{
    if (f->sentences == 0)
    {
        _exit(NOT_TOLD);
    }
}

static Fixture fixture;

static inline void Need(swResult result, const char* what)
{
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "the fixture has no %s: %s: %s\n", what, swResult_GetText(result), fixture.last);
        exit(2);
    }
}

static inline void MakeMeasured(Fixture* f)
{
    static const double frequencies[3] = {0.1, 0.15, 0.2};
    static const double densities[3 * 8] = {0.1, 0.5, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2, 0.9, 0.2, 0.0,
                                            0.0, 0.0, 0.0, 0.0, 0.1, 0.4, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0};
    static const double directions[8] = {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0};
    int location = 0;
    Need(swCreateMeasuredSea(&f->host, "fixture", &f->measuredSea), "measured sea");
    Need(swMeasuredSea_AddLocation(f->measuredSea, "place", 5.0, 50.0, &location), "place");
    f->spectrumDef = swDefaultMeasuredSpectrumDef();
    f->spectrumDef.frequencyCount = 3;
    f->spectrumDef.frequencies = frequencies;
    f->spectrumDef.directionCount = 8;
    f->spectrumDef.directions = directions;
    f->spectrumDef.density = densities;
    Need(swMeasuredSea_AddSpectrum(f->measuredSea, &f->spectrumDef), "spectrum");
    f->spectrumDef.seconds = 3600.0;
    Need(swMeasuredSea_AddSpectrum(f->measuredSea, &f->spectrumDef), "spectrum");
    Need(swMeasuredSea_Finish(f->measuredSea), "records");
}

static inline void MakeWorld(Fixture* f)
{
    swWorldDef worldDef = swDefaultWorldDef();
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = 64;
    f->wavesDef = swDefaultWaveSystemDef();
    f->wavesDef.resolution = 32;
    f->wavesDef.tileWaves = 8;
    f->wavesDef.minWavelength = 4.0f;
    Need(swCreateWorld(&f->host, &worldDef, &f->world), "world");
    const swMomentDef momentDef = swDefaultMomentDef();
    Need(swCreateMoment(f->world, &momentDef, &f->moment), "moment");
    Need(swCreateView(f->world, &viewDef, &f->view), "view");
    Need(swCreateWaveSystem(f->world, &f->wavesDef, &f->staleId), "waves");
    swDestroyWaveSystem(f->world, f->staleId);
    Need(swCreateWaveSystem(f->world, &f->wavesDef, &f->id), "waves");
    f->replayDef = swDefaultSeaReplayDef();
    f->replayDef.sea = f->measuredSea;
    f->replayDef.waves = f->wavesDef;
    Need(swCreateSeaReplay(f->world, &f->replayDef, &f->seaReplay), "replay");
    Need(swWorld_Step(f->world, 0.0), "step");
    f->map = (swHeightMapDef){.spacing = 1.0, .width = 4, .height = 4};
    swMakeEqualBins(0.05, 0.3, 10, &f->bins);
    f->gauges = (swSeaGauges){.area = 100.0, .gaugeCount = 4, .duration = 10.0};
    static const float cells[4] = {1.0f, 2.0f, 3.0f, 4.0f};
    f->rasterDef = swDefaultRasterDef();
    f->rasterDef.width = f->rasterDef.height = 2;
    f->rasterDef.values = cells;
    Need(swCreateRaster(&f->host, &f->rasterDef, &f->raster), "raster");
    f->rasters[0] = f->rasters[1] = f->rasters[2] = f->rasters[3] = f->raster;
    const swInputDef inputDef = swDefaultInputDef();
    Need(swCreateInput(f->world, &inputDef, &f->staleInputId), "input");
    swDestroyInput(f->world, f->staleInputId);
    Need(swCreateInput(f->world, &inputDef, &f->inputId), "input");
    static const swVec2 shore[3] = {{0.0f, 0.0f}, {10.0f, 0.0f}, {0.0f, 10.0f}};
    f->waterBodyDef = swDefaultWaterBodyDef();
    f->waterBodyDef.points = shore;
    f->waterBodyDef.pointCount = 3;
    Need(swCreateWaterBody(f->world, &f->waterBodyDef, &f->staleWaterBodyId), "body of water");
    swDestroyWaterBody(f->world, f->staleWaterBodyId);
    Need(swCreateWaterBody(f->world, &f->waterBodyDef, &f->waterBodyId), "body of water");
    static const swVec3 corners[4] = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    f->hullDef = swDefaultHullDef();
    f->hullDef.vertices = corners;
    f->hullDef.vertexCount = f->hullDef.triangleCount = 4;
    f->hullDef.indices = faces;
    f->hullDef.resolution = 8;
    Need(swCreateHull(&f->host, &f->hullDef, &f->hull), "hull");
    f->meshDef = swDefaultMeshDef();
    f->meshDef.vertices = corners;
    f->meshDef.vertexCount = f->meshDef.triangleCount = 4;
    f->meshDef.indices = faces;
    Need(swCreateMesh(&f->host, &f->meshDef, &f->mesh), "mesh");
    static swSplinePoint points[2];
    points[0] = swDefaultSplinePoint(0.0, 0.0, 0.0);
    points[1] = swDefaultSplinePoint(9.0, 0.0, 0.0);
    f->splineDef = swDefaultSplineDef();
    f->splineDef.points = points;
    f->splineDef.pointCount = 2;
    Need(swCreateSpline(&f->host, &f->splineDef, &f->spline), "spline");
    Need(swCreateSeaPatches(&f->host, 16.0, 64.0, &f->seaPatches), "patches");
    Need(swCreateTaskPool(&f->host, 0, &f->taskPool), "task pool");
}

#if MISUSE_GPU
static inline void GiveFloor(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    (void)points;
    memset(heights, 0, (size_t)count * sizeof(float));
}

static inline void MakeGpu(Fixture* f)
{
    swGpuDef gpuDef = swDefaultGpuDef();
    swResult result = swCreateStage(&f->host, &gpuDef, &f->stage);
    if (result == SW_ERROR_NO_DEVICE)
    {
        printf("skipped: there is no Vulkan device\n");
        exit(77);
    }
    Need(result, "device");
    f->gpu = swStage_GetGpu(f->stage);
    Need(swStage_CreateTargets(f->stage, 64, 64, 0, 0, &f->targets), "targets");
    Need(swStage_CreateBuffer(f->stage, 4 * 64 * 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &f->buffer), "buffer");
    f->image = f->targets.output;
    f->terrainDef = swDefaultStageTerrainDef();
    f->terrainDef.floor = GiveFloor;
    Need(swStage_CreateTerrain(f->stage, &f->terrainDef, &f->stageTerrain), "land");
    f->sheetDef = swDefaultSheetDef();
    Need(swStage_CreateLines(f->stage, &f->stageLines), "lines");
    Need(swCreateSheet(&f->host, &f->sheet), "sheet");
    f->VkImageView = f->targets.hdr.view;
    swGpuQueryDef queryDef = swDefaultGpuQueryDef();
    swPictureDef pictureDef = swDefaultPictureDef();
    Need(swCreateGpuWorld(f->gpu, f->world, &f->gpuWorld), "world on the device");
    Need(swCreateGpuQuery(f->gpuWorld, &queryDef, &f->gpuQuery), "query");
    Need(swCreateRenderer(f->gpuWorld, &f->renderer), "renderer");
    Need(swCreatePicture(f->renderer, &pictureDef, &f->picture), "picture");
    Need(swStage_BeginFrame(f->stage, &f->frame), "commands");
    f->VkCommandBuffer = f->frame.commands;
    Need(swGpuWorld_Record(f->gpuWorld, f->VkCommandBuffer, f->frame.index), "frame");
    f->shot = (swShot){.view = f->view, .sky = swDefaultSkyDef(), .water = swDefaultWaterDef()};
    f->shot.camera = swMakeCamera((swPos){0.0, 5.0, 0.0}, 0.0f, -0.1f, 0.0f, 1.0f, 64, 64);
    f->VkInstance = swGpu_GetInstance(f->gpu);
    f->VkPhysicalDevice = swGpu_GetPhysicalDevice(f->gpu);
    f->VkBuffer = f->gpuQuery->answers.handle;
    f->PFN_vkGetInstanceProcAddr = f->gpu->getInstanceProcAddr;
}
#endif

#if MISUSE_SCENE
static inline void MakeScene(Fixture* f)
{
    const char* text = "name: fixture\nwaves:\n  - spectrum: jonswap\n";
    Need(swReadSceneText(&f->host, text, strlen(text), "fixture", ".", &f->scene), "scene");
    Need(swCreateSceneSea(f->world, f->scene, &f->sceneSea), "sea of a scene");
}
#endif

static inline void MakeFixture(Fixture* f)
{
    f->host = swDefaultHost();
    f->host.log = CountSentence;
    f->host.logContext = f;
    snprintf(f->text, sizeof f->text, "text");
    MakeMeasured(f);
    MakeWorld(f);
#if MISUSE_GPU
    MakeGpu(f);
#endif
#if MISUSE_SCENE
    MakeScene(f);
#endif
}

static inline const char* DescribeEnd(int status)
{
    static char text[64];
    if (WIFSIGNALED(status))
    {
        snprintf(text, sizeof text, "crashed by signal %d", WTERMSIG(status));
        return text;
    }
    switch (WEXITSTATUS(status))
    {
    case SUCCEEDED:
        return "returned success";
    case NOT_NULL:
        return "left the object as it was instead of NULL";
    case NOT_TOLD:
        return "logged no sentence";
    default:
        return "ended strangely";
    }
}

static inline bool IsFine(int status)
{
#if !defined(NDEBUG)
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT)
    {
        return true; // misuse asserts in this build
    }
#endif
    return WIFEXITED(status) && WEXITSTATUS(status) == FINE;
}

static inline int RunCases(const Case* cases, int count)
{
    MakeFixture(&fixture);
    int failed = 0;
    for (int i = 0; i < count; ++i)
    {
        fflush(NULL);
        pid_t child = fork();
        if (child == 0)
        {
#if !defined(NDEBUG)
            if (freopen("/dev/null", "w", stderr) == NULL)
            {
                _exit(2);
            }
#endif
            alarm(60);
            fixture.sentences = 0;
            cases[i].run(&fixture);
            _exit(FINE);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (!IsFine(status))
        {
            printf("FAILED: %s: %s\n", cases[i].text, DescribeEnd(status));
            failed += 1;
        }
    }
    printf("%d misuses, %d of them failed\n", count, failed);
    return failed == 0 ? 0 : 1;
}
