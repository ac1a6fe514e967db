// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame, and the making of a world's twin.

#include "gpu/query/gpu_query.h"

swResult swMakeGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);
void swFreeGpuWorld(swGpuWorld* gpuWorld);
size_t swGetGpuWorldMemory(const swGpuWorld* gpuWorld);

// Record all passes of the world's last frame.
swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);
// Take back the notes of `frameIndex` and all later frames, which will not run.
void swDiscardFrames(swGpuWorld* gpuWorld, uint64_t frameIndex);

// Copy one mip of one tile's detail to the host, 4 floats a texel; waits. For tests.
swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels);
// Copy the tiles' texels (resolution rows of resolution + 3 columns) to the host; waits. For tests.
swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels);
