// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_upload.h"

#include <string.h>

#include "gpu/vk/vk_device.h"

// A default frame needs about 40 KiB.
#define SW_UPLOAD_BYTES (256u << 10)
// At least what any device asks of a descriptor's offset (the limit of the specification).
#define SW_UPLOAD_ALIGNMENT 256u

#define SW_UPLOAD_USAGE                                                                                                \
    (VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |      \
     VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT)

swResult swReserveUpload(swGpu* gpu, VkDeviceSize size, swUpload* upload)
{
    swUploadRing* ring = &gpu->uploads[gpu->frameSlot];
    *upload = (swUpload){0};
    VkDeviceSize needed = (size + SW_UPLOAD_ALIGNMENT - 1) / SW_UPLOAD_ALIGNMENT * SW_UPLOAD_ALIGNMENT;
    if (ring->buffer.handle == VK_NULL_HANDLE || ring->used + needed > ring->buffer.size)
    {
        VkDeviceSize grown = 2 * ring->buffer.size > SW_UPLOAD_BYTES ? 2 * ring->buffer.size : SW_UPLOAD_BYTES;
        grown = grown > needed ? grown : needed;
        swResult result = swGrowBuffer(gpu, grown, SW_UPLOAD_USAGE, SW_MEMORY_UPLOAD, "upload ring", &ring->buffer);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        ring->used = 0;
    }
    *upload = (swUpload){
        .buffer = ring->buffer.handle,
        .offset = ring->used,
        .size = size,
        .data = (uint8_t*)ring->buffer.mapped + ring->used,
    };
    ring->used += needed;
    return SW_SUCCESS;
}

swResult swUploadData(swGpu* gpu, const void* data, VkDeviceSize size, swUpload* upload)
{
    swResult result = swReserveUpload(gpu, size, upload);
    if (result == SW_SUCCESS)
    {
        memcpy(upload->data, data, (size_t)size);
    }
    return result;
}

void swRecordImageUpload(swGpu* gpu, VkCommandBuffer commands, const swUpload* upload, swImage* image)
{
    swImageBarrier(gpu, commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                   VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0, VK_PIPELINE_STAGE_2_COPY_BIT,
                   VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const VkBufferImageCopy copy = {
        .bufferOffset = upload->offset,
        .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = image->layers},
        .imageExtent = {image->width, image->height, image->depth},
    };
    gpu->vk.CmdCopyBufferToImage(commands, upload->buffer, image->handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                                 &copy);
    swImageBarrier(gpu, commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, image->layout,
                   VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                   VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
    image->isInitialized = true;
}

void swResetUpload(swGpu* gpu, int slot)
{
    gpu->uploads[slot].used = 0;
}

void swDestroyUploads(swGpu* gpu)
{
    for (int i = 0; i < SW_MAX_FRAMES_IN_FLIGHT; ++i)
    {
        swDestroyBuffer(gpu, &gpu->uploads[i].buffer);
    }
}
