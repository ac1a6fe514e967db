// SPDX-License-Identifier: MIT
#pragma once

// The inputs of a world on the GPU, as lib/inputs.glsl reads them: ranges of fields, records, nodes of the index, and
// words of data. Brought when they change; passes that evaluate fields bind all four.

#include "core/base/array.h"
#include "core/frame/frame.h"
#include "gpu/vk/vk_device.h"
#include "gpu/vk/vk_pipeline.h"
#include "shared/fields.h"

// Most bytes of data of inputs (rasters, meshes, points) that a device holds.
#define SW_MOST_INPUT_BYTES ((VkDeviceSize)1 << 30)

#define SW_INPUT_BINDINGS 4

// Cells are kept to this far out, where 32 bits still hold what is added to them.
#define SW_FARTHEST_CELL 1e9

typedef struct swGpuInputs
{
    swBuffer head;    // swInputHead
    swBuffer records; // swInputRecord[]
    swBuffer nodes;   // swInputNode[]
    swBuffer words;   // float[]; records that share data share their words

    uint32_t toldLacks; // what is left out of answers, as bits: what was said of it
    bool isHeld;        // version and wordsVersion are of what the buffers hold
    uint32_t version, wordsVersion;
    swArray blocks; // of data, see gpu_inputs.c

    // Set by each swGpuWorld_Record(), valid for this frame.
    bool isAuthored; // there are inputs: otherwise nothing is held
    bool hasFlow, hasDisplacement;
    bool hasRibbons; // waves of some systems run along splines
    bool isBrought;
    uint32_t lacks; // what is left out of answers, see gpu_inputs.c
    swUpload headUpload, recordsUpload, nodesUpload;
    swBuffer staging; // of words, retired in the frame that copies them
} swGpuInputs;

void swDestroyGpuInputs(swGpu* gpu, swGpuInputs* inputs);
size_t swGetGpuInputMemory(const swGpuInputs* inputs);

// All that may fail for a frame; records nothing.
swResult swPrepareGpuInputs(swGpuWorld* gpuWorld, const swFrame* frame);
void swCopyGpuInputs(swGpu* gpu, VkCommandBuffer commands, swGpuInputs* inputs);
// Head, records, nodes and words, for passes that evaluate inputs; something that is not read where there are none.
void swBindInputs(const swGpuWorld* gpuWorld, swBinding bindings[SW_INPUT_BINDINGS]);
// A coordinate in the sea as a cell and a rest, m; too far out the last cell.
void swSplitSeaPlace(double metres, int32_t* cell, float* rest);
void swCommitGpuInputs(swGpuInputs* inputs, const swFrame* frame);
void swDiscardGpuInputs(swGpuInputs* inputs);
