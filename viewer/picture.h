// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame on the GPU, and the images that it goes through: HDR and depth, the finished picture, the
// window.

#include "screen.h"
#include "sea.h"
#include "ui_draw.h"

// The picture holds sRGB bytes in a UNORM image: the panel blends them as they are, tone mapping encodes through a
// second view in the renderer's output format.
#define PICTURE_FORMAT VK_FORMAT_R8G8B8A8_UNORM

typedef struct Targets
{
    Image hdr;
    Image depth;
    Image picture;
    Buffer readback; // RGBA bytes; empty until a screenshot is taken
} Targets;

bool OpenTargets(Targets* targets, const Graphics* graphics, VkExtent2D extent);

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
    swPicture picture;
    uint64_t frameIndex;
    float dt;          // s since the last frame, for exposure
    bool jumpExposure; // the first frame, or a new place
    CaptureStage capture;
} PictureDef;

// Record one frame, from the sea's waves to the window's image.
bool RecordPicture(const PictureDef* def, VkCommandBuffer commands);
