// SPDX-License-Identifier: MIT
#include "picture.h"

#include <math.h>

VkExtent2D DrawnExtent(VkExtent2D window, bool isSoftware)
{
    double pixels = (double)window.width * (double)window.height;
    double scale = isSoftware ? sqrt(SOFTWARE_PIXELS / fmax(pixels, 1.0)) : 1.0;
    scale = scale < 0.5 ? 0.5 : scale;
    if (scale >= 1.0)
    {
        return window;
    }
    return (VkExtent2D){(uint32_t)ceil(scale * window.width), (uint32_t)ceil(scale * window.height)};
}

bool OpenTargets(Targets* targets, swStage* stage, VkExtent2D extent, VkExtent2D drawn)
{
    return swStage_CreateTargets(stage, extent.width, extent.height, drawn.width, drawn.height, &targets->stage) ==
           SW_SUCCESS;
}

void CloseTargets(Targets* targets, swStage* stage)
{
    swStage_DestroyTargets(stage, &targets->stage);
    swStage_DestroyBuffer(stage, &targets->readback);
}

static bool DrawPanel(const PictureDef* def)
{
    VkCommandBuffer commands = def->frame.commands;
    const swStageImage* picture = &def->targets->stage.output;
    VkExtent2D extent = {picture->width, picture->height};
    swStage_UseImage(def->stage, commands, picture, SW_STAGE_USE_COLOR_TARGET, SW_STAGE_USE_COLOR_TARGET);
    swStage_BeginDrawing(def->stage, commands, picture, picture->view, true, NULL);
    bool isDrawn = DrawUi(def->drawer, commands, (int)(def->frame.index % FRAMES_IN_FLIGHT), def->mesh, extent);
    swStage_EndDrawing(def->stage, commands);
    return isDrawn;
}

// Copy the picture as it is now to the host, for a screenshot.
static bool Capture(const PictureDef* def)
{
    const swStageImage* picture = &def->targets->stage.output;
    swStageBuffer* readback = &def->targets->readback;
    VkDeviceSize size = (VkDeviceSize)picture->width * picture->height * 4;
    if (readback->size != size &&
        swStage_CreateBuffer(def->stage, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, readback) != SW_SUCCESS)
    {
        return false;
    }
    swStage_CopyToHost(def->stage, def->frame.commands, picture, SW_STAGE_USE_COLOR_TARGET, readback);
    return true;
}

// The first view is UNORM, like the window's images, so the blit moves encoded bytes and only reorders components.
static void CopyToWindow(const PictureDef* def)
{
    VkCommandBuffer commands = def->frame.commands;
    const swStageImage* picture = &def->targets->stage.output;
    VkExtent2D extent = def->screen->extent;
    const swStageImage window = {.image = def->screen->images[def->screen->imageIndex],
                                 .aspect = VK_IMAGE_ASPECT_COLOR_BIT,
                                 .width = extent.width,
                                 .height = extent.height};
    VkImageBlit region = {
        .srcSubresource = {picture->aspect, 0, 0, 1},
        .srcOffsets = {{0, 0, 0}, {(int32_t)picture->width, (int32_t)picture->height, 1}},
        .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .dstOffsets = {{0, 0, 0}, {(int32_t)extent.width, (int32_t)extent.height, 1}},
    };
    swStage_UseImage(def->stage, commands, picture, SW_STAGE_USE_COLOR_TARGET, SW_STAGE_USE_COPY_FROM);
    swStage_UseImage(def->stage, commands, &window, SW_STAGE_USE_ACQUIRED, SW_STAGE_USE_COPY_TO);
    def->screen->vk->CmdBlitImage(commands, picture->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, window.image,
                                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_NEAREST);
    swStage_UseImage(def->stage, commands, &window, SW_STAGE_USE_COPY_TO, SW_STAGE_USE_PRESENT);
}

bool RecordPicture(PictureDef* def)
{
    VkCommandBuffer commands = def->frame.commands;
    swPicture* picture = def->sea->picture;
    if (swGpuWorld_Record(def->sea->gpuWorld, commands, def->frame.index) != SW_SUCCESS ||
        (def->land != NULL && swStageTerrain_Prepare(def->land, &def->targets->stage, &def->shot) != SW_SUCCESS) ||
        swPicture_Prepare(picture, commands, &def->shot, def->frame.index) != SW_SUCCESS)
    {
        return false;
    }
    swStage_DrawPicture(def->stage, commands, picture, &def->targets->stage, def->land, def->dt, def->jumpExposure);
    if (def->lines != NULL && def->marks != 0)
    {
        swStageLines_Clear(def->lines);
        swStageLines_AddMarks(def->lines, def->sea->world, picture, &def->shot.camera, def->marks);
        swStage_DrawLines(def->stage, commands, def->lines, &def->targets->stage, &def->shot.camera);
    }
    if (def->sheet->isRead)
    {
        CopySheetView(def->sheet, def->stage, commands, &def->targets->stage.output);
    }
    if (def->capture == CAPTURE_SEA && !Capture(def))
    {
        return false;
    }
    if (!DrawPanel(def) || (def->capture == CAPTURE_WINDOW && !Capture(def)))
    {
        return false;
    }
    CopyToWindow(def);
    def->sea->hasRecorded = true;
    return true;
}
