// SPDX-License-Identifier: MIT
#pragma once

// A sea drawn without a window: everything that a picture needs, and the picture read back.

#include <seaway/draw.h>
#include <seaway/gpu.h>
#include <seaway/seaway.h>
#include <seaway/stage.h>

// What is in front of the lens.
typedef struct Shot
{
    const char* name;
    float windSpeed;   // of the sea, m/s
    float swellHeight; // of a swell from another direction, m; 0 for none
    float height;      // of the camera above sea level, m
    float headingDeg, pitchDeg, fovDeg;
    float sunAzimuthDeg, sunElevationDeg;
    float haze, clouds;
    double time;
    double x, z;
    swDebugMode debug;
    int steps;                    // simulated before the picture, a tenth of a second each, so that foam has a past
    bool hasCoreLayers;           // the core makes the layers
    bool dropsCommands;           // each frame is recorded once more before, and thrown away
    bool hasBlackFoam;            // so that foam is seen by the difference
    const swWaveSystemDef* waves; // instead of a sea of that wind and swell; NULL for none
    swStageFloorFcn* floor;       // of land and sea floor; NULL for none
    void* floorContext;
    const swInputDef* inputs; // of the world
    int inputCount;
    const swWaterBodyDef* bodies; // of water
    int bodyCount;
    const swWaterDef* bodyWaters; // that they look like
    int bodyWaterCount;
} Shot;

typedef struct Canvas Canvas;

// NULL if there is no device; the log has said why.
Canvas* CreateCanvas(uint32_t width, uint32_t height, bool enableValidation);
// The same by another loader of Vulkan than the system's; NULL: the system's.
Canvas* CreateCanvasBy(uint32_t width, uint32_t height, bool enableValidation, PFN_vkGetInstanceProcAddr loader);
void DestroyCanvas(Canvas* canvas);

// Draw; `pixels` (RGBA, sRGB) and `hdr` (RGBA, linear) have width * height * 4 elements; either may be NULL.
bool DrawShot(Canvas* canvas, const Shot* shot, uint8_t* pixels, float* hdr);

swStage* GetCanvasStage(const Canvas* canvas);
const swGpu* GetCanvasGpu(const Canvas* canvas);
const char* GetCanvasDevice(const Canvas* canvas);
int GetCanvasValidationCount(const Canvas* canvas);
void PrintCanvasTimes(const Canvas* canvas);
