// SPDX-License-Identifier: MIT
// Layers copied back to the host: for tests, bakes and tools. Slow: each call waits for the device.

#include <math.h>
#include <string.h>

#include "gpu/layer/gpu_view.h"
#include "gpu/vk/vk_submit.h"

static float halfToFloat(uint16_t half)
{
    int exponent = (half >> 10) & 31;
    float mantissa = (float)(half & 1023);
    float magnitude = exponent == 0    ? ldexpf(mantissa, -24)
                      : exponent == 31 ? (mantissa == 0.0f ? INFINITY : NAN)
                                       : ldexpf(mantissa + 1024.0f, exponent - 25);
    return (half & 0x8000) != 0 ? -magnitude : magnitude;
}

static void waitForAll(swGpu* gpu, VkCommandBuffer commands, VkPipelineStageFlags2 toStages, VkAccessFlags2 toAccess)
{
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, toStages, toAccess);
}

// One layer and mip of an image into a new mapped buffer.
static swResult copyImage(swGpu* gpu, const swImage* image, uint32_t layer, uint32_t mip, size_t texelBytes,
                          swBuffer* buffer)
{
    VkExtent3D extent = {image->width >> mip, image->height >> mip, 1};
    size_t bytes = (size_t)extent.width * extent.height * texelBytes;
    swResult result = swCreateBuffer(gpu, bytes, 0, SW_MEMORY_READBACK, "readback", buffer);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    VkCommandBuffer commands;
    result = swBeginSubmit(gpu, &commands);
    if (result == SW_SUCCESS)
    {
        const VkBufferImageCopy copy = {
            .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                                 .mipLevel = mip,
                                 .baseArrayLayer = layer,
                                 .layerCount = 1},
            .imageExtent = extent,
        };
        waitForAll(gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
        gpu->vk.CmdCopyImageToBuffer(commands, image->handle, image->layout, buffer->handle, 1, &copy);
        waitForAll(gpu, commands, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
        result = swEndSubmit(gpu);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyBuffer(gpu, buffer);
    }
    return result;
}

swResult swReadHalves(swGpu* gpu, const swImage* image, uint32_t layer, uint32_t mip, float* texels)
{
    swBuffer buffer;
    swResult result = copyImage(gpu, image, layer, mip, 4 * sizeof(uint16_t), &buffer);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const uint16_t* halves = buffer.mapped;
    size_t count = (size_t)(image->width >> mip) * (image->height >> mip) * 4;
    for (size_t i = 0; i < count; ++i)
    {
        texels[i] = halfToFloat(halves[i]);
    }
    swDestroyBuffer(gpu, &buffer);
    return SW_SUCCESS;
}

static swResult readFloats(swGpu* gpu, const swImage* image, uint32_t layer, size_t channels, float* texels)
{
    swBuffer buffer;
    swResult result = copyImage(gpu, image, layer, 0, channels * sizeof(float), &buffer);
    if (result == SW_SUCCESS)
    {
        memcpy(texels, buffer.mapped, (size_t)image->width * image->height * channels * sizeof(float));
        swDestroyBuffer(gpu, &buffer);
    }
    return result;
}

// Of a field that is not authored.
static void fillRest(const swGpuView* view, int layer, float* texels)
{
    const swLayerInfo* info = swGetLayerInfo(layer);
    size_t channels = info->format == SW_TEXEL_R32F ? 1 : 4;
    size_t count = (size_t)view->resolution * (size_t)view->resolution * channels;
    for (size_t i = 0; i < count; ++i)
    {
        texels[i] = info->rest[i % channels];
    }
}

swResult swReadLayer(swGpu* gpu, const swGpuView* view, int layer, int slice, float* texels)
{
    const swImage* image = swGetLayerImage(view, layer);
    swTexelFormat format = swGetLayerInfo(layer)->format;
    if (image->width == 1)
    {
        fillRest(view, layer, texels);
        return SW_SUCCESS;
    }
    if (format == SW_TEXEL_RGBA16F)
    {
        return swReadHalves(gpu, image, (uint32_t)slice, 0, texels);
    }
    swResult result = readFloats(gpu, image, (uint32_t)slice, format == SW_TEXEL_R32F ? 1 : 4, texels);
    size_t count = (size_t)view->resolution * (size_t)view->resolution;
    for (size_t i = 0; i < count && result == SW_SUCCESS && layer == SW_LAYER_DISPLACEMENT; ++i)
    {
        texels[4 * i + 3] = 0.0f; // J is the library's own business
    }
    return result;
}

swResult swReadBuffer(swGpu* gpu, const swBuffer* from, VkDeviceSize offset, VkDeviceSize size, void* data)
{
    swBuffer buffer;
    swResult result = swCreateBuffer(gpu, size, 0, SW_MEMORY_READBACK, "readback", &buffer);
    VkCommandBuffer commands = VK_NULL_HANDLE;
    result = result == SW_SUCCESS ? swBeginSubmit(gpu, &commands) : result;
    if (result == SW_SUCCESS)
    {
        const VkBufferCopy copy = {.srcOffset = offset, .size = size};
        waitForAll(gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
        gpu->vk.CmdCopyBuffer(commands, from->handle, buffer.handle, 1, &copy);
        waitForAll(gpu, commands, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
        result = swEndSubmit(gpu);
    }
    if (result == SW_SUCCESS)
    {
        memcpy(data, buffer.mapped, (size_t)size);
    }
    swDestroyBuffer(gpu, &buffer);
    return result;
}
