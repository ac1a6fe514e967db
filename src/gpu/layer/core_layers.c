// SPDX-License-Identifier: MIT
// Layers that the core has made already, brought to the images that the passes would write. On a device that is a CPU
// the core's kernels make them many times faster than compute shaders do.

#include <string.h>

#include "gpu/layer/gpu_view.h"

// To the nearest half float, ties to even; what is too large becomes infinite.
static uint16_t halfOfFloat(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof(bits));
    uint32_t sign = bits >> 16 & 0x8000u;
    bits &= 0x7fffffffu;
    if (bits >= 0x47800000u)
    {
        return (uint16_t)(sign | (bits > 0x7f800000u ? 0x7e00u : 0x7c00u));
    }
    if (bits < 0x38800000u) // a half's subnormal numbers: the sum rounds as they do
    {
        float magnitude;
        memcpy(&magnitude, &bits, sizeof(magnitude));
        magnitude += 0.5f;
        memcpy(&bits, &magnitude, sizeof(bits));
        return (uint16_t)(sign | (bits - 0x3f000000u));
    }
    bits += 0xc8000fffu + (bits >> 13 & 1u);
    return (uint16_t)(sign | bits >> 13);
}

#define CHUNK 4096 // floats that a worker turns into halves at once

typedef struct HalfJob
{
    const float* from;
    uint16_t* to;
} HalfJob;

static void makeHalves(void* context, int begin, int end, int worker)
{
    const HalfJob* job = context;
    (void)worker;
    for (size_t i = (size_t)begin * CHUNK; i < (size_t)end * CHUNK; ++i)
    {
        job->to[i] = halfOfFloat(job->from[i]);
    }
}

static swResult uploadHalves(swGpu* gpu, const float* texels, size_t count, swUpload* upload)
{
    swResult result = swReserveUpload(gpu, count * sizeof(uint16_t), upload);
    if (result == SW_SUCCESS)
    {
        HalfJob job = {.from = texels, .to = upload->data};
        swParallelFor(&gpu->host, makeHalves, &job, (int)(count / CHUNK), 4); // a slice has at least 64 x 64 texels
    }
    return result;
}

swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view)
{
    size_t texels = (size_t)view->sliceCount * (size_t)view->resolution * (size_t)view->resolution;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_LAYERS && result == SW_SUCCESS; ++i)
    {
        const float* from = frame->stack.layers[i].texels;
        swTexelFormat format = swGetLayerInfo(i)->format;
        size_t count = texels * (format == SW_TEXEL_R32F ? 1 : 4);
        if (from != NULL)
        {
            result = format == SW_TEXEL_RGBA16F
                         ? uploadHalves(gpu, from, count, &view->layers[i].upload)
                         : swUploadData(gpu, from, count * sizeof(float), &view->layers[i].upload);
        }
    }
    return result;
}

swResult swPrepareRestTexel(swGpu* gpu, swGpuView* view, int layer)
{
    const swLayerInfo* info = swGetLayerInfo(layer);
    size_t channels = info->format == SW_TEXEL_R32F ? 1 : 4;
    size_t count = (size_t)view->sliceCount * channels;
    float floats[SW_MAX_SLICES * 4] = {0.0f};
    uint16_t halves[SW_MAX_SLICES * 4] = {0};
    for (size_t i = 0; i < count; ++i)
    {
        floats[i] = info->rest[i % channels];
        halves[i] = halfOfFloat(floats[i]);
    }
    swUpload* upload = &view->layers[layer].upload;
    return info->format == SW_TEXEL_RGBA16F ? swUploadData(gpu, halves, count * sizeof(uint16_t), upload)
                                            : swUploadData(gpu, floats, count * sizeof(float), upload);
}

static void copyLayer(swGpu* gpu, VkCommandBuffer commands, const swUpload* from, const swImage* to)
{
    const VkBufferImageCopy copy = {
        .bufferOffset = from->offset,
        .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = to->layers},
        .imageExtent = {to->width, to->height, 1},
    };
    gpu->vk.CmdCopyBufferToImage(commands, from->buffer, to->handle, to->layout, 1, &copy);
}

void swCopyCoreLayers(swGpu* gpu, VkCommandBuffer commands, const swGpuView* view)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (view->frame->stack.layers[i].texels != NULL)
        {
            copyLayer(gpu, commands, &view->layers[i].upload, swGetLayerImage(view, i));
        }
    }
}
