// SPDX-License-Identifier: MIT
#pragma once

// Small data for one frame, written by the host into mapped memory that the GPU reads in place. Each frame slot has a
// buffer of its own, which grows by retiring; after a few frames nothing is allocated any more.

#include "gpu/vk/vk_buffer.h"

// A place to write `size` bytes for this frame. Storage, uniform, index, indirect and transfer-source use.
typedef struct swUpload
{
    VkBuffer buffer;
    VkDeviceSize offset, size;
    void* data;
} swUpload;

typedef struct swUploadRing
{
    swBuffer buffer;
    VkDeviceSize used;
} swUploadRing;

// After swBeginGpuFrame(). The offset suits every kind of descriptor.
swResult swReserveUpload(swGpu* gpu, VkDeviceSize size, swUpload* upload);
// The same, with a copy of `data`.
swResult swUploadData(swGpu* gpu, const void* data, VkDeviceSize size, swUpload* upload);
void swResetUpload(swGpu* gpu, int slot);
void swDestroyUploads(swGpu* gpu);

// Record a copy of pixels (tightly packed, all layers of mip 0) into an image, from UNDEFINED to its resting layout.
struct swImage;
void swRecordImageUpload(swGpu* gpu, VkCommandBuffer commands, const swUpload* upload, struct swImage* image);
