// SPDX-License-Identifier: MIT
// Barriers, rendering, and the order of a picture from the sea to bytes.

#include "stage/stage_base.h"

typedef struct swImageState
{
    VkImageLayout layout;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
} swImageState;

static const swImageState states[SW_STAGE_USE_COUNT] = {
    [SW_STAGE_USE_DISCARD] = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE},
    [SW_STAGE_USE_ACQUIRED] = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE},
    [SW_STAGE_USE_COLOR_TARGET] = {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                   VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                   VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT},
    [SW_STAGE_USE_DEPTH_TARGET] = {VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                   VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                                       VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
                                   VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                       VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT},
    [SW_STAGE_USE_SAMPLED] = {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                              VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT},
    [SW_STAGE_USE_COPY_FROM] = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                VK_ACCESS_2_TRANSFER_READ_BIT},
    [SW_STAGE_USE_COPY_TO] = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                              VK_ACCESS_2_TRANSFER_WRITE_BIT},
    [SW_STAGE_USE_PRESENT] = {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE},
};

static bool canRecord(const swStage* stage, VkCommandBuffer commands, const char* call)
{
    SW_REQUIRE(stage != NULL && commands != VK_NULL_HANDLE, false, stage != NULL ? &stage->host : NULL,
               "%s needs a stage and a command buffer", call);
    return true;
}

static bool isImage(const swStageImage* image)
{
    return image != NULL && image->image != VK_NULL_HANDLE;
}

void swStage_UseImage(swStage* stage, VkCommandBuffer commands, const swStageImage* image, swStageUse before,
                      swStageUse after)
{
    if (!canRecord(stage, commands, "swStage_UseImage()"))
    {
        return;
    }
    SW_REQUIRE_VOID(isImage(image) && (unsigned)before < SW_STAGE_USE_COUNT && (unsigned)after < SW_STAGE_USE_COUNT,
                    &stage->host, "swStage_UseImage() needs an image and two uses of swStageUse");
    const VkImageMemoryBarrier2 barrier = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = states[before].stages,
        .srcAccessMask = states[before].access,
        .dstStageMask = states[after].stages,
        .dstAccessMask = states[after].access,
        .oldLayout = states[before].layout,
        .newLayout = states[after].layout,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image->image,
        .subresourceRange = {image->aspect, 0, 1, 0, 1},
    };
    const VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
        .imageMemoryBarrierCount = 1,
        .pImageMemoryBarriers = &barrier,
    };
    stage->vk.CmdPipelineBarrier2(commands, &dependency);
}

void swStage_CopyToHost(swStage* stage, VkCommandBuffer commands, const swStageImage* image, swStageUse use,
                        const swStageBuffer* buffer)
{
    if (!canRecord(stage, commands, "swStage_CopyToHost()"))
    {
        return;
    }
    SW_REQUIRE_VOID(isImage(image) && (unsigned)use < SW_STAGE_USE_COUNT && buffer != NULL &&
                        buffer->buffer != VK_NULL_HANDLE,
                    &stage->host, "swStage_CopyToHost() needs an image, its use and a buffer");
    VkDeviceSize needed = (VkDeviceSize)image->width * image->height * image->texelBytes;
    SW_REQUIRE_VOID(buffer->size >= needed, &stage->host,
                    "swStage_CopyToHost() needs a buffer of %.0f bytes for this image, and was given one of %.0f",
                    (double)needed, (double)buffer->size);
    const VkBufferImageCopy region = {
        .imageSubresource = {image->aspect, 0, 0, 1},
        .imageExtent = {image->width, image->height, 1},
    };
    swStage_UseImage(stage, commands, image, use, SW_STAGE_USE_COPY_FROM);
    stage->vk.CmdCopyImageToBuffer(commands, image->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer->buffer, 1,
                                   &region);
    swStage_UseImage(stage, commands, image, SW_STAGE_USE_COPY_FROM, use);
    const VkMemoryBarrier2 toHost = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
        .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
        .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT,
    };
    const VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &toHost};
    stage->vk.CmdPipelineBarrier2(commands, &dependency);
}

static void beginDrawing(swStage* stage, VkCommandBuffer commands, const swStageImage* color, VkImageView view,
                         bool keepsColor, const swStageImage* depth, bool keepsDepth)
{
    const VkRenderingAttachmentInfo colorInfo = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = view,
        .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
        .loadOp = keepsColor ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
    };
    const VkRenderingAttachmentInfo depthInfo = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = depth != NULL ? depth->view : VK_NULL_HANDLE,
        .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
        .loadOp = keepsDepth ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
    };
    const VkRenderingInfo info = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
        .renderArea = {{0, 0}, {color->width, color->height}},
        .layerCount = 1,
        .colorAttachmentCount = 1,
        .pColorAttachments = &colorInfo,
        .pDepthAttachment = depth != NULL ? &depthInfo : NULL,
    };
    const VkViewport viewport = {0.0f, 0.0f, (float)color->width, (float)color->height, 0.0f, 1.0f};
    stage->vk.CmdBeginRendering(commands, &info);
    stage->vk.CmdSetViewport(commands, 0, 1, &viewport);
    stage->vk.CmdSetScissor(commands, 0, 1, &info.renderArea);
}

void swStage_BeginDrawing(swStage* stage, VkCommandBuffer commands, const swStageImage* color, VkImageView view,
                          bool keepsColor, const swStageImage* depth)
{
    if (!canRecord(stage, commands, "swStage_BeginDrawing()"))
    {
        return;
    }
    SW_REQUIRE_VOID(isImage(color) && view != VK_NULL_HANDLE, &stage->host,
                    "swStage_BeginDrawing() needs an image and one of its views");
    beginDrawing(stage, commands, color, view, keepsColor, depth, false);
}

void swStage_EndDrawing(swStage* stage, VkCommandBuffer commands)
{
    if (canRecord(stage, commands, "swStage_EndDrawing()"))
    {
        stage->vk.CmdEndRendering(commands);
    }
}

swResult swStage_CreateTargets(swStage* stage, uint32_t width, uint32_t height, uint32_t drawnWidth,
                               uint32_t drawnHeight, swStageTargets* targets)
{
    if (targets != NULL)
    {
        *targets = (swStageTargets){0};
    }
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_CreateTargets() needs a stage");
    SW_REQUIRE(targets != NULL && width > 0 && height > 0, SW_ERROR_INVALID, &stage->host,
               "swStage_CreateTargets() needs a size and a place for the targets");
    const swPictureDef formats = swDefaultPictureDef();
    const VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const swStageImageDef hdr = {.name = "the drawn picture",
                                 .format = formats.colorFormat,
                                 .usage = drawn | VK_IMAGE_USAGE_SAMPLED_BIT,
                                 .width = drawnWidth != 0 ? drawnWidth : width,
                                 .height = drawnHeight != 0 ? drawnHeight : height};
    const swStageImageDef depth = {.name = "the picture's depth",
                                   .format = formats.depthFormat,
                                   .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                            VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                   .width = hdr.width,
                                   .height = hdr.height};
    const swStageImageDef output = {.name = "the finished picture",
                                    .format = VK_FORMAT_R8G8B8A8_UNORM,
                                    .otherFormat = formats.outputFormat,
                                    .usage = drawn | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                    .width = width,
                                    .height = height};
    swResult result = swStage_CreateImage(stage, &hdr, &targets->hdr);
    result = result == SW_SUCCESS ? swStage_CreateImage(stage, &depth, &targets->depth) : result;
    result = result == SW_SUCCESS ? swStage_CreateImage(stage, &output, &targets->output) : result;
    if (result != SW_SUCCESS)
    {
        swStage_DestroyTargets(stage, targets);
    }
    return result;
}

void swStage_DestroyTargets(swStage* stage, swStageTargets* targets)
{
    SW_REQUIRE_VOID(stage != NULL && targets != NULL, stage != NULL ? &stage->host : NULL,
                    "swStage_DestroyTargets() needs a stage and targets");
    swStage_DestroyImage(stage, &targets->hdr);
    swStage_DestroyImage(stage, &targets->depth);
    swStage_DestroyImage(stage, &targets->output);
    swStage_DestroyImage(stage, &targets->opaqueColor);
    swStage_DestroyImage(stage, &targets->opaqueDepth);
}

static void copyImage(swStage* stage, VkCommandBuffer commands, const swStageImage* from, swStageUse use,
                      const swStageImage* to)
{
    const VkImageSubresourceLayers layers = {from->aspect, 0, 0, 1};
    const VkImageCopy region = {
        .srcSubresource = layers, .dstSubresource = layers, .extent = {from->width, from->height, 1}};
    swStage_UseImage(stage, commands, from, use, SW_STAGE_USE_COPY_FROM);
    swStage_UseImage(stage, commands, to, SW_STAGE_USE_DISCARD, SW_STAGE_USE_COPY_TO);
    stage->vk.CmdCopyImage(commands, from->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to->image,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    swStage_UseImage(stage, commands, to, SW_STAGE_USE_COPY_TO, SW_STAGE_USE_SAMPLED);
    swStage_UseImage(stage, commands, from, SW_STAGE_USE_COPY_FROM, use);
}

// The land, and copies of it for the water to be seen through.
static void drawOpaque(swStage* stage, VkCommandBuffer commands, swPicture* picture, const swStageTargets* targets,
                       const swStageTerrain* terrain)
{
    beginDrawing(stage, commands, &targets->hdr, targets->hdr.view, false, &targets->depth, false);
    swDrawTerrain(terrain, commands, picture);
    swStage_EndDrawing(stage, commands);
    copyImage(stage, commands, &targets->hdr, SW_STAGE_USE_COLOR_TARGET, &targets->opaqueColor);
    copyImage(stage, commands, &targets->depth, SW_STAGE_USE_DEPTH_TARGET, &targets->opaqueDepth);
}

void swStage_DrawPicture(swStage* stage, VkCommandBuffer commands, swPicture* picture, const swStageTargets* targets,
                         const swStageTerrain* terrain, float dt, bool immediate)
{
    if (!canRecord(stage, commands, "swStage_DrawPicture()"))
    {
        return;
    }
    SW_REQUIRE_VOID(picture != NULL && targets != NULL && isImage(&targets->hdr) && isImage(&targets->depth) &&
                        isImage(&targets->output),
                    &stage->host, "swStage_DrawPicture() needs a picture and targets");
    bool hasLand = swIsTerrainSeen(terrain);
    SW_REQUIRE_VOID(!hasLand || isImage(&targets->opaqueDepth), &stage->host,
                    "swStage_DrawPicture() needs targets that swStageTerrain_Prepare() has seen");
    swStage_UseImage(stage, commands, &targets->hdr, SW_STAGE_USE_DISCARD, SW_STAGE_USE_COLOR_TARGET);
    swStage_UseImage(stage, commands, &targets->depth, SW_STAGE_USE_DISCARD, SW_STAGE_USE_DEPTH_TARGET);
    if (hasLand)
    {
        drawOpaque(stage, commands, picture, targets, terrain);
    }
    beginDrawing(stage, commands, &targets->hdr, targets->hdr.view, hasLand, &targets->depth, hasLand);
    swPicture_DrawSurface(picture, commands);
    swPicture_DrawSky(picture, commands);
    swStage_EndDrawing(stage, commands);
    swStage_UseImage(stage, commands, &targets->hdr, SW_STAGE_USE_COLOR_TARGET, SW_STAGE_USE_SAMPLED);
    swPicture_Expose(picture, commands, targets->hdr.view, dt, immediate);
    swStage_UseImage(stage, commands, &targets->output, SW_STAGE_USE_DISCARD, SW_STAGE_USE_COLOR_TARGET);
    swStage_BeginDrawing(stage, commands, &targets->output, targets->output.otherView, false, NULL);
    swPicture_Tonemap(picture, commands, targets->hdr.view);
    swStage_EndDrawing(stage, commands);
}
