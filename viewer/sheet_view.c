// SPDX-License-Identifier: MIT
#include "sheet_view.h"

#define LEAST_WIDTH 64 // pixels; in less there is nothing to see

void CloseSheetView(SheetView* view, swStage* stage)
{
    swDestroySheet(view->sheet);
    swStage_DestroyBuffer(stage, &view->pixels);
    view->sheet = NULL;
    view->isRead = false;
}

static bool FitPixels(SheetView* view, swStage* stage)
{
    VkDeviceSize size = (VkDeviceSize)view->width * (VkDeviceSize)view->height * 4;
    if (view->pixels.size == size)
    {
        return true;
    }
    if (swStage_Wait(stage) != SW_SUCCESS)
    {
        return false;
    }
    swStage_DestroyBuffer(stage, &view->pixels);
    return swStage_CreateBuffer(stage, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, &view->pixels) == SW_SUCCESS;
}

bool UpdateSheetView(SheetView* view, const swHost* host, swStage* stage, swGpuWorld* gpuWorld, const swView* from,
                     int left, int width, int height)
{
    view->isRead = false;
    view->x = left > 0 && left < width - LEAST_WIDTH ? left : 0;
    view->width = width - view->x;
    view->height = height;
    swSheetDef def = view->def;
    int sliceCount = swView_GetSliceCount(from);
    def.slice = def.slice < sliceCount ? def.slice : sliceCount - 1;
    def.hasRange = def.hasRange && def.low < def.high;
    if ((view->sheet == NULL && swCreateSheet(host, &view->sheet) != SW_SUCCESS) || !FitPixels(view, stage) ||
        swSheet_Read(view->sheet, gpuWorld, from, &def) != SW_SUCCESS) // it waits for frames that read the pixels
    {
        return false;
    }
    swSheet_Draw(view->sheet, view->width, view->height, view->pixels.data);
    view->isRead = true;
    return true;
}

void CopySheetView(const SheetView* view, swStage* stage, VkCommandBuffer commands, const swStageImage* picture)
{
    const VkBufferImageCopy region = {
        .imageSubresource = {picture->aspect, 0, 0, 1},
        .imageOffset = {view->x, 0, 0},
        .imageExtent = {(uint32_t)view->width, (uint32_t)view->height, 1},
    };
    swStage_UseImage(stage, commands, picture, SW_STAGE_USE_COLOR_TARGET, SW_STAGE_USE_COPY_TO);
    swStage_GetVk(stage)->CmdCopyBufferToImage(commands, view->pixels.buffer, picture->image,
                                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    swStage_UseImage(stage, commands, picture, SW_STAGE_USE_COPY_TO, SW_STAGE_USE_COLOR_TARGET);
}
