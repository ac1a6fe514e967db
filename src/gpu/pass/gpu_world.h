// SPDX-License-Identifier: MIT
#pragma once

// The GPU's twin of a world: what recorded passes leave for each other and for drawing. What only one pass needs is in
// that pass's own state. After swGpuWorld_Record() a barrier has made everything visible to vertex, fragment and
// compute shaders of the same queue.

#include "gpu/layer/gpu_view.h"
#include "gpu/pass/gpu_inputs.h"
#include "gpu/pass/gpu_tiles.h"

typedef enum swPassId
{
#define SW_PASS(NAME, name, text) SW_PASS_##NAME,
#include "core/frame/passes.inl"
#undef SW_PASS
    SW_PASS_COUNT
} swPassId;

typedef struct swPass swPass; // see passes.h

typedef struct swPassRun
{
    void* state;   // the pass's own
    bool isNeeded; // it has something to record in this frame
} swPassRun;

struct swGpuWorld
{
    swGpu* gpu;
    const swWorld* world;

    uint64_t frameIndex; // of the last recorded frame
    bool isRecorded;     // the last swGpuWorld_Record() succeeded, and its commands were not discarded
    uint32_t discardCount;
    uint64_t discardedFrom; // frame index of the last discard

    swGpuTiles tiles;
    swGpuInputs inputs;
    swGpuView views[SW_MAX_VIEWS];
    swGpuQuery* firstQuery; // see query_passes.h
    swPassRun passes[SW_PASS_COUNT];
};

// The layers of a view, or NULL if the last frame was not recorded, or without it.
const swGpuView* swFindGpuView(const swGpuWorld* gpuWorld, const swView* view);
