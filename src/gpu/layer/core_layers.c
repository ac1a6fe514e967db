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

swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view)
{
    size_t texels = (size_t)view->sliceCount * (size_t)view->resolution * (size_t)view->resolution;
    swResult result =
        swUploadData(gpu, frame->displacement, texels * 4 * sizeof(float), &view->layers[SW_LAYER_DISPLACEMENT].upload);
    result = result == SW_SUCCESS
                 ? swReserveUpload(gpu, texels * 4 * sizeof(uint16_t), &view->layers[SW_LAYER_DERIVATIVES].upload)
                 : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    HalfJob job = {.from = frame->derivatives, .to = view->layers[SW_LAYER_DERIVATIVES].upload.data};
    swParallelFor(&gpu->host, makeHalves, &job, (int)(texels * 4 / CHUNK), 4); // a slice has at least 64 x 64 texels
    return swUploadData(gpu, frame->foam, texels * sizeof(float), &view->layers[SW_LAYER_FOAM].upload);
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
    for (int layer = 0; layer < SW_LAYER_COUNT; ++layer)
    {
        copyLayer(gpu, commands, &view->layers[layer].upload, swGetLayerImage(view, (swLayer)layer));
    }
}
