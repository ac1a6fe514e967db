// SPDX-License-Identifier: MIT
#pragma once

// A layer of the view in place of the picture: read back after each frame, beside the panel.

#include "seaway/sheet.h"
#include "seaway/stage.h"

typedef struct SheetView
{
    bool isShown;
    swSheetDef def;
    swSheet* sheet;       // NULL until it is shown
    swStageBuffer pixels; // RGBA, as large as the part of the window that it covers
    int x, width, height; // of that part, pixels; it reaches from top to bottom
    bool isRead;          // there is something to show
} SheetView;

// The device must be idle.
void CloseSheetView(SheetView* view, swStage* stage);

// Read the layer as the last frame left it, and draw it for the part of the window right of `left` pixels. False if the
// host's log has a reason.
bool UpdateSheetView(SheetView* view, const swHost* host, swStage* stage, swGpuWorld* gpuWorld, const swView* from,
                     int left, int width, int height);

// Copy it over the picture, which is a colour target before and after.
void CopySheetView(const SheetView* view, swStage* stage, VkCommandBuffer commands, const swStageImage* picture);
