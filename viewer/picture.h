// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame on the GPU, and the images that it goes through: HDR and depth, the finished picture, the
// window.

#include "screen.h"
#include "sea.h"
#include "ui_draw.h"

// The picture holds sRGB bytes in a UNORM image: the panel blends them as they are, tone mapping encodes through a
// second view in the picture's output format.
#define PICTURE_FORMAT VK_FORMAT_R8G8B8A8_UNORM

typedef struct Targets
{
    Image hdr; // and depth: the sea and the sky, of DrawnExtent()
    Image depth;
    Image picture;   // of the window's extent
    Buffer readback; // RGBA bytes; empty until a screenshot is taken
} Targets;

// Pixels that a software device draws of the sea before tone mapping stretches them over the window: what two cores do
// ten times a second. Never less than half of a side.
#define SOFTWARE_PIXELS 70000.0

// A GPU draws every pixel of the window.
VkExtent2D DrawnExtent(VkExtent2D window, bool isSoftware);

// `extent` is the window's, `drawn` that of the sea.
bool OpenTargets(Targets* targets, const Graphics* graphics, VkExtent2D extent, VkExtent2D drawn);

// The device must be idle.
void CloseTargets(Targets* targets, const Graphics* graphics);

typedef enum CaptureStage
{
    CAPTURE_NONE,
    CAPTURE_SEA,   // before the panel is drawn
    CAPTURE_WINDOW // with the panel
} CaptureStage;

typedef struct PictureDef
{
    const Graphics* graphics;
    const Screen* screen;
    Targets* targets;
    Sea* sea;
    UiDrawer* drawer;
    const UiMesh* mesh;
    swShot shot;
    uint64_t frameIndex;
    float dt;          // s since the last frame, for exposure
    bool jumpExposure; // the first frame, or a new place
    CaptureStage capture;
} PictureDef;

// Record one frame, from the sea's waves to the window's image.
bool RecordPicture(const PictureDef* def, VkCommandBuffer commands);
