// SPDX-License-Identifier: MIT
#include "picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "vulkan_calls.h"

typedef struct Target
{
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
} Target;

typedef struct Readback
{
    VkBuffer buffer;
    VkDeviceMemory memory;
    void* data;
} Readback;

struct PictureMaker
{
    PictureMakerDef def;
    uint32_t width, height; // rendered
    swGpu* gpu;
    swGpuWorld* world;
    swRenderer* renderer;
    VulkanCalls calls;
    VkDevice device;
    Target hdr, depth, output;
    Readback hdrData, outputData; // 4 half floats and 4 bytes a pixel
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkFence fence;
    uint64_t frameIndex;
};

static bool Succeed(VkResult result, const char* what)
{
    if (result != VK_SUCCESS)
    {
        Complain("%s (Vulkan error %d)", what, (int)result);
    }
    return result == VK_SUCCESS;
}

static bool TryMemory(PictureMaker* maker, VkMemoryRequirements needs, VkMemoryPropertyFlags wanted,
                      VkDeviceMemory* memory)
{
    VkPhysicalDeviceMemoryProperties properties;
    maker->calls.GetPhysicalDeviceMemoryProperties(swGpu_GetPhysicalDevice(maker->gpu), &properties);
    for (uint32_t i = 0; i < properties.memoryTypeCount; ++i)
    {
        bool fits =
            (needs.memoryTypeBits >> i & 1) != 0 && (properties.memoryTypes[i].propertyFlags & wanted) == wanted;
        VkMemoryAllocateInfo info = {
            .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = i};
        if (fits && maker->calls.AllocateMemory(maker->device, &info, NULL, memory) == VK_SUCCESS)
        {
            return true;
        }
    }
    return false;
}

static bool AllocateMemory(PictureMaker* maker, VkMemoryRequirements needs, VkMemoryPropertyFlags wanted,
                           VkMemoryPropertyFlags preferred, VkDeviceMemory* memory)
{
    if (TryMemory(maker, needs, wanted | preferred, memory) || TryMemory(maker, needs, wanted, memory))
    {
        return true;
    }
    Complain("the device has no memory for %.0f MB of the picture; make it smaller", 1e-6 * (double)needs.size);
    return false;
}

static bool CreateTarget(PictureMaker* maker, VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect,
                         Target* target)
{
    VkImageCreateInfo imageInfo = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                   .imageType = VK_IMAGE_TYPE_2D,
                                   .format = format,
                                   .extent = {maker->width, maker->height, 1},
                                   .mipLevels = 1,
                                   .arrayLayers = 1,
                                   .samples = VK_SAMPLE_COUNT_1_BIT,
                                   .tiling = VK_IMAGE_TILING_OPTIMAL,
                                   .usage = usage};
    VkMemoryRequirements needs;
    if (!Succeed(maker->calls.CreateImage(maker->device, &imageInfo, NULL, &target->image), "no image was made"))
    {
        return false;
    }
    maker->calls.GetImageMemoryRequirements(maker->device, target->image, &needs);
    if (!AllocateMemory(maker, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &target->memory) ||
        !Succeed(maker->calls.BindImageMemory(maker->device, target->image, target->memory, 0), "no memory was bound"))
    {
        return false;
    }
    VkImageViewCreateInfo viewInfo = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                      .image = target->image,
                                      .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                      .format = format,
                                      .subresourceRange = {aspect, 0, 1, 0, 1}};
    return Succeed(maker->calls.CreateImageView(maker->device, &viewInfo, NULL, &target->view), "no view was made");
}

static bool CreateReadback(PictureMaker* maker, uint32_t pixelSize, Readback* readback)
{
    VkDeviceSize size = (VkDeviceSize)maker->width * maker->height * pixelSize;
    VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    VkMemoryRequirements needs;
    if (!Succeed(maker->calls.CreateBuffer(maker->device, &info, NULL, &readback->buffer), "no buffer was made"))
    {
        return false;
    }
    maker->calls.GetBufferMemoryRequirements(maker->device, readback->buffer, &needs);
    VkMemoryPropertyFlags visible = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    // Uncached memory is read by the processor at a hundredth of the speed.
    return AllocateMemory(maker, needs, visible, VK_MEMORY_PROPERTY_HOST_CACHED_BIT, &readback->memory) &&
           Succeed(maker->calls.BindBufferMemory(maker->device, readback->buffer, readback->memory, 0),
                   "no memory was bound") &&
           Succeed(maker->calls.MapMemory(maker->device, readback->memory, 0, VK_WHOLE_SIZE, 0, &readback->data),
                   "no memory was mapped");
}

static bool CheckSize(PictureMaker* maker)
{
    VkPhysicalDeviceProperties properties;
    maker->calls.GetPhysicalDeviceProperties(swGpu_GetPhysicalDevice(maker->gpu), &properties);
    uint32_t most = properties.limits.maxFramebufferWidth < properties.limits.maxImageDimension2D
                        ? properties.limits.maxFramebufferWidth
                        : properties.limits.maxImageDimension2D;
    if (maker->width > most || maker->height > most)
    {
        Complain("%u x %u rendered pixels are more than the %u a side that %s can draw; use a smaller --size or fewer "
                 "--samples",
                 maker->width, maker->height, most, properties.deviceName);
        return false;
    }
    return true;
}

static bool CreateTargets(PictureMaker* maker)
{
    VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    return CreateTarget(maker, VK_FORMAT_R16G16B16A16_SFLOAT, drawn | VK_IMAGE_USAGE_SAMPLED_BIT,
                        VK_IMAGE_ASPECT_COLOR_BIT, &maker->hdr) &&
           CreateTarget(maker, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                        VK_IMAGE_ASPECT_DEPTH_BIT, &maker->depth) &&
           CreateTarget(maker, VK_FORMAT_R8G8B8A8_SRGB, drawn, VK_IMAGE_ASPECT_COLOR_BIT, &maker->output) &&
           CreateReadback(maker, 8, &maker->hdrData) && CreateReadback(maker, 4, &maker->outputData);
}

static bool CreateCommands(PictureMaker* maker)
{
    VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                        .queueFamilyIndex = swGpu_GetQueueFamily(maker->gpu)};
    if (!Succeed(maker->calls.CreateCommandPool(maker->device, &poolInfo, NULL, &maker->pool), "no command pool"))
    {
        return false;
    }
    VkCommandBufferAllocateInfo bufferInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .commandPool = maker->pool,
                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                              .commandBufferCount = 1};
    VkFenceCreateInfo fenceInfo = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    return Succeed(maker->calls.AllocateCommandBuffers(maker->device, &bufferInfo, &maker->commands),
                   "no command buffer") &&
           Succeed(maker->calls.CreateFence(maker->device, &fenceInfo, NULL, &maker->fence), "no fence");
}

static bool CreateDevice(PictureMaker* maker, const swHost* host)
{
    swGpuDef def = swDefaultGpuDef();
    def.choice = maker->def.device;
    def.deviceIndex = maker->def.deviceIndex;
    def.enableValidation = maker->def.enableValidation;
    swResult result = swCreateGpu(host, &def, &maker->gpu);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "no Vulkan device can be used");
        return false;
    }
    maker->device = swGpu_GetDevice(maker->gpu);
    return LoadInstanceCalls(&maker->calls, swGpu_GetInstance(maker->gpu)) &&
           LoadDeviceCalls(&maker->calls, maker->device);
}

swViewDef FitPictureView(const PictureMaker* maker, const swViewDef* def)
{
    return swGpu_FitView(maker->gpu, def, maker->height);
}

bool ShowWorld(PictureMaker* maker, const swWorld* world)
{
    swResult result = swCreateGpuWorld(maker->gpu, world, &maker->world);
    if (result == SW_SUCCESS)
    {
        swRendererDef def = swDefaultRendererDef();
        result = swCreateRenderer(maker->world, &def, &maker->renderer);
    }
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the sea cannot be drawn");
    }
    return result == SW_SUCCESS;
}

PictureMaker* CreatePictureMaker(const swHost* host, const PictureMakerDef* def)
{
    PictureMaker* maker = calloc(1, sizeof(PictureMaker));
    if (maker == NULL)
    {
        Complain("no memory for a picture");
        return NULL;
    }
    maker->def = *def;
    maker->width = (uint32_t)(def->width * def->supersample);
    maker->height = (uint32_t)(def->height * def->supersample);
    if (!CreateDevice(maker, host) || !CheckSize(maker) || !CreateTargets(maker) || !CreateCommands(maker))
    {
        DestroyPictureMaker(maker);
        return NULL;
    }
    return maker;
}

static void DestroyTarget(PictureMaker* maker, Target* target)
{
    maker->calls.DestroyImageView(maker->device, target->view, NULL);
    maker->calls.DestroyImage(maker->device, target->image, NULL);
    maker->calls.FreeMemory(maker->device, target->memory, NULL);
}

static void DestroyReadback(PictureMaker* maker, Readback* readback)
{
    maker->calls.DestroyBuffer(maker->device, readback->buffer, NULL);
    maker->calls.FreeMemory(maker->device, readback->memory, NULL);
}

int DestroyPictureMaker(PictureMaker* maker)
{
    if (maker == NULL)
    {
        return 0;
    }
    if (maker->calls.DeviceWaitIdle != NULL)
    {
        maker->calls.DeviceWaitIdle(maker->device);
        swDestroyRenderer(maker->renderer);
        swDestroyGpuWorld(maker->world);
        DestroyTarget(maker, &maker->hdr);
        DestroyTarget(maker, &maker->depth);
        DestroyTarget(maker, &maker->output);
        DestroyReadback(maker, &maker->hdrData);
        DestroyReadback(maker, &maker->outputData);
        maker->calls.DestroyFence(maker->device, maker->fence, NULL);
        maker->calls.DestroyCommandPool(maker->device, maker->pool, NULL);
    }
    int messageCount = maker->gpu != NULL ? swGpu_GetValidationCount(maker->gpu) : 0;
    swDestroyGpu(maker->gpu);
    free(maker);
    return messageCount;
}

static void MoveImage(PictureMaker* maker, VkImage image, VkImageAspectFlags aspect, VkImageLayout oldLayout,
                      VkImageLayout newLayout)
{
    // Everything before, everything after: this program runs one frame at a time, and its time is in the drawing.
    VkImageMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                     .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                     .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                                     .oldLayout = oldLayout,
                                     .newLayout = newLayout,
                                     .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .image = image,
                                     .subresourceRange = {aspect, 0, 1, 0, 1}};
    VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
    maker->calls.CmdPipelineBarrier2(maker->commands, &info);
}

static void BeginRendering(PictureMaker* maker, const Target* color, VkAttachmentLoadOp load, const Target* depth)
{
    VkRenderingAttachmentInfo colorInfo = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = color->view,
                                           .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                           .loadOp = load,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    VkRenderingAttachmentInfo depthInfo = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = depth != NULL ? depth->view : VK_NULL_HANDLE,
                                           .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                           .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE};
    VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                            .renderArea = {{0, 0}, {maker->width, maker->height}},
                            .layerCount = 1,
                            .colorAttachmentCount = 1,
                            .pColorAttachments = &colorInfo,
                            .pDepthAttachment = depth != NULL ? &depthInfo : NULL};
    VkViewport viewport = {0.0f, 0.0f, (float)maker->width, (float)maker->height, 0.0f, 1.0f};
    maker->calls.CmdBeginRendering(maker->commands, &info);
    maker->calls.CmdSetViewport(maker->commands, 0, 1, &viewport);
    maker->calls.CmdSetScissor(maker->commands, 0, 1, &info.renderArea);
}

static void CopyToHost(PictureMaker* maker, const Target* target, const Readback* readback)
{
    VkBufferImageCopy region = {.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                .imageExtent = {maker->width, maker->height, 1}};
    maker->calls.CmdCopyImageToBuffer(maker->commands, target->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                      readback->buffer, 1, &region);
}

static void ShowToHost(PictureMaker* maker)
{
    VkMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
    maker->calls.CmdPipelineBarrier2(maker->commands, &info);
}

static bool BeginCommands(PictureMaker* maker)
{
    VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                     .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    if (!Succeed(maker->calls.ResetCommandPool(maker->device, maker->pool, 0), "the commands could not be reset") ||
        !Succeed(maker->calls.BeginCommandBuffer(maker->commands, &info), "the commands could not be begun"))
    {
        return false;
    }
    swResult result = swGpuWorld_Record(maker->world, maker->commands, maker->frameIndex++);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the passes could not be recorded");
    }
    return result == SW_SUCCESS;
}

static bool FinishCommands(PictureMaker* maker)
{
    VkSubmitInfo info = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &maker->commands};
    return Succeed(maker->calls.EndCommandBuffer(maker->commands), "the commands could not be ended") &&
           Succeed(maker->calls.QueueSubmit(swGpu_GetQueue(maker->gpu), 1, &info, maker->fence),
                   "the device took no commands") &&
           Succeed(maker->calls.WaitForFences(maker->device, 1, &maker->fence, VK_TRUE, UINT64_MAX),
                   "the device did not finish the picture") &&
           Succeed(maker->calls.ResetFences(maker->device, 1, &maker->fence), "the fence could not be reset");
}

bool AdvancePicture(PictureMaker* maker)
{
    return swGpu_WantsCpuLayers(maker->gpu) || (BeginCommands(maker) && FinishCommands(maker));
}

bool MakePicture(PictureMaker* maker, const swPicture* picture, float dt, bool isFirst)
{
    const VkImageAspectFlags color = VK_IMAGE_ASPECT_COLOR_BIT, depth = VK_IMAGE_ASPECT_DEPTH_BIT;
    const VkImageLayout none = VK_IMAGE_LAYOUT_UNDEFINED, drawn = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                        read = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    if (!BeginCommands(maker))
    {
        return false;
    }
    swResult result = swRenderer_Prepare(maker->renderer, maker->commands, picture, maker->frameIndex - 1);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the picture could not be prepared");
        return false;
    }
    MoveImage(maker, maker->hdr.image, color, none, drawn);
    MoveImage(maker, maker->depth.image, depth, none, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    BeginRendering(maker, &maker->hdr, VK_ATTACHMENT_LOAD_OP_CLEAR, &maker->depth);
    swRenderer_DrawSurface(maker->renderer, maker->commands);
    swRenderer_DrawSky(maker->renderer, maker->commands);
    maker->calls.CmdEndRendering(maker->commands);

    MoveImage(maker, maker->hdr.image, color, drawn, read);
    swRenderer_Expose(maker->renderer, maker->commands, maker->hdr.view, dt, isFirst);
    MoveImage(maker, maker->output.image, color, none, drawn);
    BeginRendering(maker, &maker->output, VK_ATTACHMENT_LOAD_OP_DONT_CARE, NULL);
    swRenderer_Tonemap(maker->renderer, maker->commands, maker->hdr.view);
    maker->calls.CmdEndRendering(maker->commands);

    MoveImage(maker, maker->hdr.image, color, read, copied);
    MoveImage(maker, maker->output.image, color, drawn, copied);
    CopyToHost(maker, &maker->hdr, &maker->hdrData);
    CopyToHost(maker, &maker->output, &maker->outputData);
    ShowToHost(maker);
    return FinishCommands(maker);
}

static float LinearFromSrgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : powf((value + 0.055f) / 1.055f, 2.4f);
}

static float SrgbFromLinear(float value)
{
    return value <= 0.0031308f ? value * 12.92f : 1.055f * powf(value, 1.0f / 2.4f) - 0.055f;
}

static float FloatFromHalf(uint16_t half)
{
    int exponent = half >> 10 & 31;
    float mantissa = (float)(half & 1023);
    float value = exponent == 0 ? ldexpf(mantissa, -24) : ldexpf(mantissa + 1024.0f, exponent - 25);
    value = exponent == 31 ? (mantissa == 0.0f ? INFINITY : NAN) : value;
    return half & 0x8000 ? -value : value;
}

// The mean over the rendered pixels of a finished one: of the bytes by way of a table, or of the half floats.
static void ReadPixel(const PictureMaker* maker, int column, int row, const float* byteTable, float* rgb)
{
    int factor = maker->def.supersample;
    const uint8_t* bytes = maker->outputData.data;
    const uint16_t* halves = maker->hdrData.data;
    float sum[3] = {0.0f, 0.0f, 0.0f};
    for (int y = 0; y < factor; ++y)
    {
        size_t first = ((size_t)row * (size_t)factor + (size_t)y) * maker->width + (size_t)column * (size_t)factor;
        for (int i = 0; i < factor * 4; ++i)
        {
            if ((i & 3) != 3)
            {
                size_t index = first * 4 + (size_t)i;
                sum[i & 3] += byteTable != NULL ? byteTable[bytes[index]] : FloatFromHalf(halves[index]);
            }
        }
    }
    for (int i = 0; i < 3; ++i)
    {
        rgb[i] = sum[i] / (float)(factor * factor);
    }
}

void ReadPictureBytes(const PictureMaker* maker, uint8_t* rgb)
{
    float table[256]; // pixels are averaged in linear light
    for (int i = 0; i < 256; ++i)
    {
        table[i] = LinearFromSrgb((float)i / 255.0f);
    }
    const uint8_t* bytes = maker->outputData.data;
    for (int row = 0; row < maker->def.height; ++row)
    {
        for (int column = 0; column < maker->def.width; ++column)
        {
            size_t index = (size_t)row * (size_t)maker->def.width + (size_t)column;
            float mean[3];
            if (maker->def.supersample == 1)
            {
                memcpy(rgb + 3 * index, bytes + 4 * index, 3);
                continue;
            }
            ReadPixel(maker, column, row, table, mean);
            for (int i = 0; i < 3; ++i)
            {
                rgb[3 * index + (size_t)i] = (uint8_t)(SrgbFromLinear(mean[i]) * 255.0f + 0.5f);
            }
        }
    }
}

void ReadPictureFloats(const PictureMaker* maker, float* rgb)
{
    for (int row = 0; row < maker->def.height; ++row)
    {
        for (int column = 0; column < maker->def.width; ++column)
        {
            ReadPixel(maker, column, row, NULL, rgb + 3 * ((size_t)row * (size_t)maker->def.width + (size_t)column));
        }
    }
}

const swGpu* GetPictureGpu(const PictureMaker* maker)
{
    return maker->gpu;
}

size_t GetPictureMemory(const PictureMaker* maker)
{
    return swGpuWorld_GetMemory(maker->world);
}
