// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame on the GPU, and the images that it goes through: HDR and depth, the finished picture, the
// window.

#include "seaway/lines.h"

#include "screen.h"
#include "sea.h"
#include "sheet_view.h"
#include "ui_draw.h"

// Of the first view of the stage's output: the panel blends sRGB bytes as they are.
#define PICTURE_FORMAT VK_FORMAT_R8G8B8A8_UNORM

typedef struct Targets
{
    swStageTargets stage;   // the sea of DrawnExtent(), the picture of the window's extent
    swStageBuffer readback; // RGBA bytes; empty until a screenshot is taken
} Targets;

// Pixels that a software device draws of the sea before tone mapping stretches them over the window: what two cores do
// ten times a second. Never less than half of a side.
#define SOFTWARE_PIXELS 70000.0

// A GPU draws every pixel of the window.
VkExtent2D DrawnExtent(VkExtent2D window, bool isSoftware);

// `extent` is the window's, `drawn` that of the sea.
bool OpenTargets(Targets* targets, swStage* stage, VkExtent2D extent, VkExtent2D drawn);

// The device must be idle.
void CloseTargets(Targets* targets, swStage* stage);

typedef enum CaptureStage
{
    CAPTURE_NONE,
    CAPTURE_SEA,   // before the panel is drawn
    CAPTURE_WINDOW // with the panel
} CaptureStage;

typedef struct PictureDef
{
    swStage* stage;
    const Screen* screen;
    Targets* targets;
    Sea* sea;
    swStageTerrain* land; // NULL: none
    UiDrawer* drawer;
    const UiMesh* mesh;
    swStageLines* lines; // over the picture; NULL: none
    uint32_t marks;
    const SheetView* sheet; // in place of the picture, if it has been read
    swShot shot;
    swStageFrame frame;
    float dt;          // s since the last frame, for exposure
    bool jumpExposure; // the first frame, or a new place
    CaptureStage capture;
} PictureDef;

// Record one frame, from the sea's waves to the window's image.
bool RecordPicture(PictureDef* def);
