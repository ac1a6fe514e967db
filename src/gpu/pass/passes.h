// SPDX-License-Identifier: MIT
#pragma once

// The table of passes: a swPass for each line of core/frame/passes.inl, in that order. A pass owns its pipelines, its
// images and buffers, and what it uploads for a frame, all in a struct of its own that nobody else sees; what others
// read of it has a function below. record/ runs the table and puts the barriers that follow from reads and writes.
//
// To add a pass: its line in passes.inl, its shader, pass_<name>.c with swPass_<name>, its lines in sources.cmake.

#include "gpu/pass/gpu_world.h"
#include "gpu/pass/hazards.h"

// Resources: a layer of all views, what a pass makes beside layers, and what is only uploaded. Layers come first.
#define SW_LAYER_BIT(layer) ((swResources)1 << (layer))
#define SW_OUTPUT_BIT(pass) ((swResources)1 << (32 + (pass)))
#define SW_MODES_BIT ((swResources)1 << 31)
#define SW_INPUTS_BIT ((swResources)1 << 30)
#define SW_TEXELS_BIT SW_OUTPUT_BIT(SW_PASS_WAVES_COLUMNS) // or copied, where the core makes them
#define SW_ALL_LAYERS_BITS (((swResources)1 << SW_LAYERS) - 1)
static_assert(SW_LAYERS < 30 && SW_PASS_COUNT <= 32, "a bit for each");

// `state` is the pass's own struct. Functions that a pass does not need are NULL, but for record.
struct swPass
{
    const char* name; // of its label and timestamps
    size_t stateSize;
    swStepStage stage;
    swResources reads, writes;

    // All that may fail for this frame, but for pipelines; records nothing. Says whether there is anything to record.
    swResult (*upload)(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded);
    // Pipelines that this frame needs and that are not there yet; called after upload, or by who needs them early.
    swResult (*create)(swGpuWorld* gpuWorld, void* state);
    // Cannot fail.
    void (*record)(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands);
    // Take back the notes of frame `frameIndex` and all later ones, which will not run.
    void (*discard)(swGpuWorld* gpuWorld, void* state, uint64_t frameIndex);
    // At once; the device is idle. The struct itself is freed by the table.
    void (*destroy)(swGpu* gpu, void* state);
    size_t (*getMemory)(const void* state); // bytes of device memory
};

#define SW_PASS(NAME, name, text) extern const swPass swPass_##name;
#include "core/frame/passes.inl"
#undef SW_PASS

const swPass* swGetPass(swPassId id);

// For all passes of the table, in order.
swResult swCreatePasses(swGpuWorld* gpuWorld);
void swDestroyPasses(swGpuWorld* gpuWorld);
swResult swPreparePasses(swGpuWorld* gpuWorld, const swFrame* frame);
void swRecordPasses(swGpuWorld* gpuWorld, VkCommandBuffer commands, swHazards* hazards);
void swDiscardPasses(swGpuWorld* gpuWorld, uint64_t frameIndex);
size_t swGetPassMemory(const swGpuWorld* gpuWorld);

// Pipelines of one pass, before a frame asks for them.
swResult swCreatePass(swGpuWorld* gpuWorld, swPassId id);
// Note a step of a frame, and record the barrier that it needs.
void swOrderStep(swGpu* gpu, VkCommandBuffer commands, swHazards* hazards, swStepStage stage, swResources reads,
                 swResources writes);

// Pipelines of one shader that differ in their constants, made as they are asked for.
#define SW_MAX_VARIANTS 64
typedef struct swVariants
{
    int count;
    uint32_t constants[SW_MAX_VARIANTS][SW_MAX_CONSTANTS];
    swPipeline pipelines[SW_MAX_VARIANTS];
} swVariants;
// `constants` is the shader's struct. A second call with the same does nothing.
swResult swCreateVariant(swGpu* gpu, const swShader* shader, const void* constants, swVariants* variants);
// One that was made; NULL, and an assert, if it was not.
const swPipeline* swFindVariant(const swVariants* variants, const swShader* shader, const void* constants);
void swDestroyVariants(swGpu* gpu, swVariants* variants);

// A pipeline without constants, unless it is there.
swResult swCreateOnce(swGpu* gpu, const swShader* shader, swPipeline* pipeline);

// Side of the detail layers, texels: the largest tile resolution, kept within these.
#define SW_DETAIL_MIN 32
#define SW_DETAIL_MAX 256

// What passes make beside layers, for those that read it.
const swImage* swGetDetailImage(const swGpuWorld* gpuWorld);
// Of the view with that index: swFieldSlice of each slice and swFieldBlock of each block of texels. Nothing where there
// are no inputs.
void swBindFieldPlaces(const swGpuWorld* gpuWorld, int view, swBinding* slices, swBinding* blocks);
// Where the texels of each slice lie in the sea.
void swFillFieldSlices(const swStackFrame* stack, swFieldSlice slices[SW_MAX_SLICES]);
// Of the view with that index: swSliceList of each slice, and what they list of swSliceTile and swSliceWave.
#define SW_SLICE_WAVE_BINDINGS 3
void swBindSliceWaves(const swGpuWorld* gpuWorld, int view, swBinding waves[SW_SLICE_WAVE_BINDINGS]);
// What slices_shaped.comp leaves of that view. Nothing where there are no inputs.
const swBuffer* swGetShapedWaves(const swGpuWorld* gpuWorld, int view);
const swBuffer* swGetVolumeWaves(const swGpuWorld* gpuWorld);
