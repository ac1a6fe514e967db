// SPDX-License-Identifier: MIT
#pragma once

// Everything that the running viewer holds. The panels read and change it.

#include "camera.h"
#include "messages.h"
#include "picture.h"
#include "viewer.h"

#define FRAME_TIME_COUNT 180

// How long frames take.
typedef struct FrameTimes
{
    double last;                          // when the last frame began, s of the window's clock
    float milliseconds[FRAME_TIME_COUNT]; // a ring
    int next;
} FrameTimes;

typedef struct App
{
    ViewerOptions options;
    Messages messages;
    swHost host;
    swTaskPool* pool;

    struct GLFWwindow* window;
    bool hasUi;
    swGpu* gpu;
    Graphics graphics;
    Screen screen;
    Targets targets;
    UiDrawer drawer;
    UiMesh mesh;

    Sea sea;
    int64_t sceneStamp; // when the scene file was last written
    double nextStampCheck;
    bool wantsReload;
    bool hasSceneFailed; // the last reload; the sea before it is still shown

    swClock clock; // the sea's
    bool stepOnce; // one step on, also while paused
    FrameTimes frameTimes;
    Camera camera;
    double waterHeight; // under the camera, m
    float wheel;        // clicks since the last frame
    double cursorX, cursorY;
    bool isLooking; // the mouse turns the camera

    swDebugMode debug;
    bool showPanel;
    bool jumpExposure;
    int windowPlace[4]; // x, y, width, height before full screen
    CaptureStage capture;
    char capturePath[512];
    char note[600];
    double noteUntil;
    uint64_t frameIndex;
} App;

// A line over the picture for a few seconds.
void ShowNote(App* app, const char* format, ...);

void GoToView(App* app, int index);

// keys.c: what the keyboard and the mouse do.
void OpenInput(App* app);
CameraInput ReadCameraInput(App* app);
