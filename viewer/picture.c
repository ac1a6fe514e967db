// SPDX-License-Identifier: MIT
#include "picture.h"

#include <math.h>

static ImageDef DescribeTarget(VkExtent2D extent, VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect)
{
    return (ImageDef){
        .format = format, .usage = usage, .aspect = aspect, .width = extent.width, .height = extent.height};
}

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

bool OpenTargets(Targets* targets, const Graphics* graphics, VkExtent2D extent, VkExtent2D drawn)
{
    swPictureDef formats = swDefaultPictureDef();
    ImageDef hdr =
        DescribeTarget(drawn, formats.colorFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                       VK_IMAGE_ASPECT_COLOR_BIT);
    ImageDef depth = DescribeTarget(drawn, formats.depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                    VK_IMAGE_ASPECT_DEPTH_BIT);
    ImageDef picture =
        DescribeTarget(extent, PICTURE_FORMAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                       VK_IMAGE_ASPECT_COLOR_BIT);
    picture.otherFormat = formats.outputFormat;
    return CreateImage(graphics, &hdr, &targets->hdr) && CreateImage(graphics, &depth, &targets->depth) &&
           CreateImage(graphics, &picture, &targets->picture);
}

void CloseTargets(Targets* targets, const Graphics* graphics)
{
    DestroyImage(graphics, &targets->hdr);
    DestroyImage(graphics, &targets->depth);
    DestroyImage(graphics, &targets->picture);
    DestroyBuffer(graphics, &targets->readback);
}

static void BeginDrawing(const PictureDef* def, VkCommandBuffer commands, const Image* target,
                         const VkRenderingAttachmentInfo* color, const VkRenderingAttachmentInfo* depth)
{
    const VulkanTable* vk = &def->graphics->vk;
    VkExtent2D extent = {target->width, target->height};
    VkRenderingInfo info = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
        .renderArea = {{0, 0}, extent},
        .layerCount = 1,
        .colorAttachmentCount = 1,
        .pColorAttachments = color,
        .pDepthAttachment = depth,
    };
    VkViewport viewport = {0.0f, 0.0f, (float)extent.width, (float)extent.height, 0.0f, 1.0f};
    VkRect2D scissor = {{0, 0}, extent};
    vk->CmdBeginRendering(commands, &info);
    vk->CmdSetViewport(commands, 0, 1, &viewport);
    vk->CmdSetScissor(commands, 0, 1, &scissor);
}

static VkRenderingAttachmentInfo DescribeAttachment(VkImageView view, VkImageLayout layout, VkAttachmentLoadOp load,
                                                    VkAttachmentStoreOp store)
{
    return (VkRenderingAttachmentInfo){
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = view,
        .imageLayout = layout,
        .loadOp = load,
        .storeOp = store,
    };
}

static void DrawSea(const PictureDef* def, VkCommandBuffer commands)
{
    const Graphics* graphics = def->graphics;
    const Image* hdr = &def->targets->hdr;
    const Image* depth = &def->targets->depth;
    UseImage(graphics, commands, hdr->image, hdr->aspect, USE_DISCARD, USE_COLOR_TARGET);
    UseImage(graphics, commands, depth->image, depth->aspect, USE_DISCARD, USE_DEPTH_TARGET);
    VkRenderingAttachmentInfo color = DescribeAttachment(hdr->view, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                                         VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_STORE);
    VkRenderingAttachmentInfo far = DescribeAttachment(depth->view, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                                       VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_DONT_CARE);
    BeginDrawing(def, commands, hdr, &color, &far);
    swPicture_DrawSurface(def->sea->picture, commands);
    swPicture_DrawSky(def->sea->picture, commands);
    graphics->vk.CmdEndRendering(commands);
    UseImage(graphics, commands, hdr->image, hdr->aspect, USE_COLOR_TARGET, USE_SAMPLED);
}

static void Tonemap(const PictureDef* def, VkCommandBuffer commands)
{
    const Graphics* graphics = def->graphics;
    const Image* picture = &def->targets->picture;
    swPicture_Expose(def->sea->picture, commands, def->targets->hdr.view, def->dt, def->jumpExposure);
    UseImage(graphics, commands, picture->image, picture->aspect, USE_DISCARD, USE_COLOR_TARGET);
    VkRenderingAttachmentInfo color = DescribeAttachment(picture->otherView, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                                         VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_STORE);
    BeginDrawing(def, commands, picture, &color, NULL);
    swPicture_Tonemap(def->sea->picture, commands, def->targets->hdr.view);
    graphics->vk.CmdEndRendering(commands);
}

static bool DrawPanel(const PictureDef* def, VkCommandBuffer commands)
{
    const Graphics* graphics = def->graphics;
    const Image* picture = &def->targets->picture;
    VkExtent2D extent = {picture->width, picture->height};
    UseImage(graphics, commands, picture->image, picture->aspect, USE_COLOR_TARGET, USE_COLOR_TARGET);
    VkRenderingAttachmentInfo color = DescribeAttachment(picture->view, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                                         VK_ATTACHMENT_LOAD_OP_LOAD, VK_ATTACHMENT_STORE_OP_STORE);
    BeginDrawing(def, commands, picture, &color, NULL);
    bool isDrawn = DrawUi(def->drawer, commands, (int)(def->frameIndex % FRAMES_IN_FLIGHT), def->mesh, extent);
    graphics->vk.CmdEndRendering(commands);
    return isDrawn;
}

// Copy the picture as it is now to the host, for a screenshot.
static bool Capture(const PictureDef* def, VkCommandBuffer commands)
{
    const Graphics* graphics = def->graphics;
    const Image* picture = &def->targets->picture;
    Buffer* readback = &def->targets->readback;
    VkDeviceSize size = (VkDeviceSize)picture->width * picture->height * 4;
    if (readback->size != size && !CreateBuffer(graphics, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, readback))
    {
        return false;
    }
    VkBufferImageCopy region = {
        .imageSubresource = {picture->aspect, 0, 0, 1},
        .imageExtent = {picture->width, picture->height, 1},
    };
    UseImage(graphics, commands, picture->image, picture->aspect, USE_COLOR_TARGET, USE_COPY_FROM);
    graphics->vk.CmdCopyImageToBuffer(commands, picture->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback->buffer,
                                      1, &region);
    UseImage(graphics, commands, picture->image, picture->aspect, USE_COPY_FROM, USE_COLOR_TARGET);
    VkMemoryBarrier2 toHost = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
        .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
        .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT,
    };
    VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &toHost};
    graphics->vk.CmdPipelineBarrier2(commands, &dependency);
    return true;
}

// The image itself is UNORM, like the window's, so the blit moves encoded bytes and only reorders components.
static void CopyToWindow(const PictureDef* def, VkCommandBuffer commands)
{
    const Graphics* graphics = def->graphics;
    const Image* picture = &def->targets->picture;
    VkImage window = def->screen->images[def->screen->imageIndex];
    VkExtent2D extent = def->screen->extent;
    VkImageBlit region = {
        .srcSubresource = {picture->aspect, 0, 0, 1},
        .srcOffsets = {{0, 0, 0}, {(int32_t)picture->width, (int32_t)picture->height, 1}},
        .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .dstOffsets = {{0, 0, 0}, {(int32_t)extent.width, (int32_t)extent.height, 1}},
    };
    ImageUse acquired = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE};
    UseImage(graphics, commands, picture->image, picture->aspect, USE_COLOR_TARGET, USE_COPY_FROM);
    UseImage(graphics, commands, window, VK_IMAGE_ASPECT_COLOR_BIT, acquired, USE_COPY_TO);
    graphics->vk.CmdBlitImage(commands, picture->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, window,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_NEAREST);
    UseImage(graphics, commands, window, VK_IMAGE_ASPECT_COLOR_BIT, USE_COPY_TO, USE_PRESENT);
}

bool RecordPicture(const PictureDef* def, VkCommandBuffer commands)
{
    if (swGpuWorld_Record(def->sea->gpuWorld, commands, def->frameIndex) != SW_SUCCESS ||
        swPicture_Prepare(def->sea->picture, commands, &def->shot, def->frameIndex) != SW_SUCCESS)
    {
        return false;
    }
    DrawSea(def, commands);
    Tonemap(def, commands);
    if (def->capture == CAPTURE_SEA && !Capture(def, commands))
    {
        return false;
    }
    if (!DrawPanel(def, commands) || (def->capture == CAPTURE_WINDOW && !Capture(def, commands)))
    {
        return false;
    }
    CopyToWindow(def, commands);
    return true;
}
