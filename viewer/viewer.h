// SPDX-License-Identifier: MIT
#pragma once

// The viewer: a window on a scene. `seaway view` fills the options and runs it.

#include <stdbool.h>

#include "seaway/draw.h"
#include "seaway/sheet.h"

typedef struct ViewerOptions
{
    const char* scenePath; // NULL: an open sea without a file
    const char* viewName;  // where the camera starts; NULL: the scene's first view

    swDeviceChoice device;
    int deviceIndex; // for SW_DEVICE_INDEX

    int width, height; // of the window, in screen units
    bool isFullscreen;
    bool enableValidation; // validation layers; their messages count as problems and make RunViewer() return 1
    bool enableVsync;
    bool hidePanel;
    float uiScale;     // factor on the size of letters and panel, which suits the window by itself; range [0.5, 4]
    swDebugMode debug; // what is shown instead of the picture
    bool showSheet;    // begin with a layer in place of the picture
    swSheetDef sheet;  // which one

    int frameCount; // 0: until the window is closed; else leave after that many frames, 1/30 s of the sea each
    const char* screenshotPath; // PNG of the last of `frameCount` frames, panel included; NULL: none
} ViewerOptions;

// A window of 1280 x 720 on any device, with vsync.
ViewerOptions DefaultViewerOptions(void);

// Open the window and stay until it is closed. Every failure is a sentence on stderr.
// Returns an exit code: 0, or 1 if the scene, the display or the device fails.
int RunViewer(const ViewerOptions* options);
