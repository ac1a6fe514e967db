// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame, and what the GPU keeps of a world.

#include "gpu/pass/gpu_world.h"

swResult swMakeGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);
void swFreeGpuWorld(swGpuWorld* gpuWorld);

// Record all passes of the world's last frame.
swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);

// Bring buffers, images and this frame's parameters up to the frame. Records copies of what changed.
swResult swUploadFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame);

// Copy one slice of a layer to the host; waits.
swResult swReadLayer(swGpuWorld* gpuWorld, const swGpuView* view, swLayer layer, int slice, float* texels);
// Copy one mip of one tile's detail to the host, 4 floats a texel; waits. For tests.
swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels);
// Copy the tiles' texels (resolution rows of resolution + 3 columns) to the host; waits. For tests.
swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels);
