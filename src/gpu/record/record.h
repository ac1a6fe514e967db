// SPDX-License-Identifier: MIT
#pragma once

// The order of a frame, and what the GPU keeps of a world.

#include "gpu/query/gpu_query.h"

swResult swMakeGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);
void swFreeGpuWorld(swGpuWorld* gpuWorld);

// Record all passes of the world's last frame.
swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);

// Bring buffers, images and this frame's parameters up to the frame: all that may fail. Records nothing; after a
// failure the next call makes up for everything.
swResult swPrepareFrame(swGpuWorld* gpuWorld, const swFrame* frame);
swResult swPrepareTiles(swGpuWorld* gpuWorld, const swFrame* frame);
// Record the copies that it prepared. Cannot fail.
void swRecordUploads(swGpuWorld* gpuWorld, VkCommandBuffer commands);
void swRecordTiles(swGpuWorld* gpuWorld, VkCommandBuffer commands);
// Note what the device will hold. `frame` is that of swPrepareFrame().
void swCommitFrame(swGpuWorld* gpuWorld, const swFrame* frame);
void swCommitTiles(swGpuWorld* gpuWorld, const swFrame* frame);
// Take back the notes of `frameIndex` and all later frames, which will not run.
void swDiscardFrames(swGpuWorld* gpuWorld, uint64_t frameIndex);

// Copy one mip of one tile's detail to the host, 4 floats a texel; waits. For tests.
swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels);
// Copy the tiles' texels (resolution rows of resolution + 3 columns) to the host; waits. For tests.
swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels);
