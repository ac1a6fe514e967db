// SPDX-License-Identifier: MIT
// Records and nodes go through the upload ring of a frame in which they changed. Data goes through a staging buffer of
// its own, since a raster may be larger than all that frames bring otherwise; each block of data once, however many
// records use it.

#include "gpu/pass/gpu_inputs.h"

#include <math.h>
#include <string.h>

#include "core/base/array.h"
#include "gpu/pass/query_passes.h"

// Data that records share, and where it lies among the words.
typedef struct swInputBlock
{
    const float* words;
    size_t count, first;
} swInputBlock;

static const VkBufferUsageFlags USAGE = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

void swDestroyGpuInputs(swGpu* gpu, swGpuInputs* inputs)
{
    swDestroyBuffer(gpu, &inputs->head);
    swDestroyBuffer(gpu, &inputs->records);
    swDestroyBuffer(gpu, &inputs->nodes);
    swDestroyBuffer(gpu, &inputs->words);
    swDestroyBuffer(gpu, &inputs->staging);
    swFreeItems(&gpu->host, &inputs->blocks, sizeof(swInputBlock));
}

size_t swGetGpuInputMemory(const swGpuInputs* inputs)
{
    return (size_t)(inputs->head.memory.size + inputs->records.memory.size + inputs->nodes.memory.size +
                    inputs->words.memory.size + inputs->staging.memory.size);
}

// ---- data ----

static const swInputBlock* findBlock(const swArray* blocks, const float* words, size_t count)
{
    const swInputBlock* block = blocks->data;
    for (size_t i = 0; i < blocks->count; ++i)
    {
        if (block[i].words == words && block[i].count == count)
        {
            return &block[i];
        }
    }
    return NULL;
}

// Lays out the data of all records; `total` words.
static swResult listBlocks(swGpu* gpu, const swInputSet* set, swArray* blocks, size_t* total)
{
    blocks->count = 0;
    *total = 0;
    for (int i = 0; i < set->recordCount; ++i)
    {
        size_t count = set->records[i].wordCount;
        if (count == 0 || findBlock(blocks, set->words[i], count) != NULL)
        {
            continue;
        }
        swInputBlock* block = swAppendItems(&gpu->host, blocks, 1, sizeof(swInputBlock));
        if (block == NULL)
        {
            return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "no memory for a list of the data of inputs");
        }
        *block = (swInputBlock){set->words[i], count, *total};
        *total += count;
    }
    VkDeviceSize most = gpu->properties.limits.maxStorageBufferRange;
    most = most < SW_MOST_INPUT_BYTES ? most : SW_MOST_INPUT_BYTES;
    if (*total * sizeof(float) > most)
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT,
                      "rasters, meshes and points of inputs have %.0f MB together, and %s holds %.0f of them: use "
                      "coarser rasters, or crop them",
                      (double)*total * 4e-6, gpu->properties.deviceName, (double)most * 1e-6);
    }
    return SW_SUCCESS;
}

static swResult stageWords(swGpu* gpu, swGpuInputs* inputs, size_t total)
{
    swResult result = swMakeRoomToRetire(gpu);
    result = result == SW_SUCCESS ? swCreateBuffer(gpu, total * sizeof(float), 0, SW_MEMORY_UPLOAD,
                                                   "data of inputs for the device", &inputs->staging)
                                  : result;
    const swInputBlock* blocks = inputs->blocks.data;
    for (size_t i = 0; i < inputs->blocks.count && result == SW_SUCCESS; ++i)
    {
        memcpy((float*)inputs->staging.mapped + blocks[i].first, blocks[i].words, blocks[i].count * sizeof(float));
    }
    return result;
}

// ---- a frame ----

static swResult growBuffers(swGpu* gpu, const swInputSet* set, size_t words, swGpuInputs* inputs)
{
    const struct
    {
        swBuffer* buffer;
        VkDeviceSize size;
        const char* name;
    } needs[] = {
        {&inputs->head, sizeof(swInputHead), "head of inputs"},
        {&inputs->records, (VkDeviceSize)set->recordCount * sizeof(swInputRecord), "records of inputs"},
        {&inputs->nodes, (VkDeviceSize)set->nodeCount * sizeof(swInputNode), "nodes of inputs"},
        {&inputs->words, words * sizeof(float), "data of inputs"},
    };
    swResult result = SW_SUCCESS;
    for (size_t i = 0; i < sizeof(needs) / sizeof(needs[0]) && result == SW_SUCCESS; ++i)
    {
        VkDeviceSize size = needs[i].size > 256 ? needs[i].size : 256; // something to bind where there is nothing
        result = swGrowBuffer(gpu, size, USAGE, SW_MEMORY_DEVICE, needs[i].name, needs[i].buffer);
    }
    return result;
}

static swResult uploadRecords(swGpu* gpu, const swInputSet* set, swGpuInputs* inputs)
{
    swResult result =
        swReserveUpload(gpu, (VkDeviceSize)set->recordCount * sizeof(swInputRecord), &inputs->recordsUpload);
    swInputRecord* records = inputs->recordsUpload.data;
    for (int i = 0; i < set->recordCount && result == SW_SUCCESS; ++i)
    {
        swInputRecord record = set->records[i];
        const swInputBlock* block = findBlock(&inputs->blocks, set->words[i], record.wordCount);
        record.firstWord = block != NULL ? (uint32_t)block->first : 0;
        records[i] = record;
    }
    return result;
}

// What this half leaves out of the core's answers. Each is said once, by name: answers would differ without a word.
enum
{
    LACKS_FUNCTIONS,
    LACKS_RIBBONS,
    LACKS_FLOORS_BELOW, // of queries of the water below, like the next
    LACKS_WEIGHTS_BELOW,
    LACKS_FLOW_BELOW,
    LACKS_COUNT
};

#define OF_VOLUMES (1u << LACKS_FLOORS_BELOW | 1u << LACKS_WEIGHTS_BELOW | 1u << LACKS_FLOW_BELOW)

static uint32_t findLacks(const swInputSet* set)
{
    uint32_t lacks = 0;
    for (int i = 0; i < set->recordCount; ++i)
    {
        lacks |= (set->records[i].shape == SW_FORM_FUNCTION ? 1u : 0u) << LACKS_FUNCTIONS;
    }
    lacks |= (swHasInputs(set, SW_INPUT_FLOOR) ? 1u : 0u) << LACKS_FLOORS_BELOW;
    lacks |= (swHasInputs(set, SW_INPUT_WAVES) || set->localSystems != 0 ? 1u : 0u) << LACKS_WEIGHTS_BELOW;
    lacks |= (swHasInputs(set, SW_INPUT_FLOW) ? 1u : 0u) << LACKS_FLOW_BELOW;
    return lacks;
}

// Whether waves of a system run along splines that queries have no room for, see keepLook() in surface_search.glsl.
static bool isRibbonLeftOut(const swInputSet* set, int system)
{
    uint32_t below = set->ribbonSystems & ((1u << system) - 1u);
    int slot = 0;
    for (; below != 0; below &= below - 1)
    {
        slot += 1;
    }
    return (set->ribbonSystems >> system & 1u) != 0 && slot >= SW_QUERY_RIBBON_SYSTEMS;
}

static uint32_t findLackedRibbons(const swFrame* frame)
{
    bool isLeftOut = false;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        isLeftOut = isLeftOut || isRibbonLeftOut(frame->inputs, frame->tiles[i].system);
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        isLeftOut = isLeftOut || isRibbonLeftOut(frame->inputs, frame->waves[i].system);
    }
    return (isLeftOut ? 1u : 0u) << LACKS_RIBBONS;
}

static void tellLacks(swGpuWorld* gpuWorld)
{
    static const char* const told[LACKS_COUNT] = {
        [LACKS_FUNCTIONS] = "layers, queries and rays of the GPU leave out functions of the host",
        [LACKS_RIBBONS] = "queries and rays of the GPU leave out waves along splines of all but the first 8 systems "
                          "that have such waves",
        [LACKS_FLOORS_BELOW] = "queries of the water below on the GPU leave out what a floor does to the motion there",
        [LACKS_WEIGHTS_BELOW] = "queries of the water below on the GPU leave out what weights of wave systems do to "
                                "the motion there",
        [LACKS_FLOW_BELOW] = "queries of the water below on the GPU leave out the flow there",
    };
    swGpuInputs* inputs = &gpuWorld->inputs;
    uint32_t lacks = inputs->lacks & ~inputs->toldLacks;
    lacks &= swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_VOLUME) ? ~0u : ~OF_VOLUMES;
    for (int i = 0; i < LACKS_COUNT && lacks != 0; ++i)
    {
        if ((lacks >> i & 1u) != 0)
        {
            swLog(&gpuWorld->gpu->host, SW_LOG_WARNING, "%s; the core's answers do not", told[i]);
        }
    }
    inputs->toldLacks |= lacks;
}

static swResult bringInputs(swGpu* gpu, const swInputSet* set, swGpuInputs* inputs)
{
    size_t words;
    inputs->isHeld = false;
    swResult result = listBlocks(gpu, set, &inputs->blocks, &words);
    result = result == SW_SUCCESS ? growBuffers(gpu, set, words, inputs) : result;
    result = result == SW_SUCCESS && words > 0 ? stageWords(gpu, inputs, words) : result;
    result = result == SW_SUCCESS ? uploadRecords(gpu, set, inputs) : result;
    VkDeviceSize nodes = (VkDeviceSize)set->nodeCount * sizeof(swInputNode);
    result = result == SW_SUCCESS ? swUploadData(gpu, set->nodes, nodes, &inputs->nodesUpload) : result;
    swInputHead head = {.localSystems = set->localSystems,
                        .ribbonSystems = set->ribbonSystems,
                        .evenX = set->evenX,
                        .evenZ = set->evenZ};
    memcpy(head.ranges, set->ranges, sizeof(head.ranges));
    return result == SW_SUCCESS ? swUploadData(gpu, &head, sizeof(head), &inputs->headUpload) : result;
}

swResult swPrepareGpuInputs(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swGpuInputs* inputs = &gpuWorld->inputs;
    const swInputSet* set = frame->inputs;
    inputs->isAuthored = set != NULL && (set->recordCount > 0 || set->localSystems != 0);
    inputs->hasFlow = inputs->isAuthored && swHasInputs(set, SW_INPUT_FLOW);
    inputs->hasDisplacement = inputs->isAuthored && swHasInputs(set, SW_INPUT_DISPLACEMENT);
    inputs->hasRibbons = set != NULL && set->ribbonSystems != 0;
    inputs->isBrought = inputs->isAuthored && (!inputs->isHeld || inputs->version != set->version ||
                                               inputs->wordsVersion != set->wordsVersion);
    swRetireBuffer(gpuWorld->gpu, &inputs->staging); // of a frame that was not recorded
    inputs->lacks = inputs->isBrought ? findLacks(set) : inputs->isAuthored ? inputs->lacks : 0;
    inputs->lacks |= inputs->hasRibbons ? findLackedRibbons(frame) : 0;
    tellLacks(gpuWorld);
    return inputs->isBrought ? bringInputs(gpuWorld->gpu, set, inputs) : SW_SUCCESS;
}

static void recordCopy(swGpu* gpu, VkCommandBuffer commands, VkBuffer from, VkDeviceSize offset, VkDeviceSize size,
                       const swBuffer* to)
{
    const VkBufferCopy copy = {.srcOffset = offset, .size = size};
    if (size > 0)
    {
        gpu->vk.CmdCopyBuffer(commands, from, to->handle, 1, &copy);
    }
}

void swCopyGpuInputs(swGpu* gpu, VkCommandBuffer commands, swGpuInputs* inputs)
{
    if (!inputs->isBrought)
    {
        return;
    }
    const swUpload* uploads[] = {&inputs->headUpload, &inputs->recordsUpload, &inputs->nodesUpload};
    const swBuffer* buffers[] = {&inputs->head, &inputs->records, &inputs->nodes};
    for (int i = 0; i < 3; ++i)
    {
        recordCopy(gpu, commands, uploads[i]->buffer, uploads[i]->offset, uploads[i]->size, buffers[i]);
    }
    if (inputs->staging.handle != VK_NULL_HANDLE)
    {
        recordCopy(gpu, commands, inputs->staging.handle, 0, inputs->staging.size, &inputs->words);
        swRetireBuffer(gpu, &inputs->staging);
    }
}

void swSplitSeaPlace(double metres, int32_t* cell, float* rest)
{
    const double side = (double)SW_QUERY_CELL;
    double whole = floor(metres / side);
    *rest = (float)(metres - whole * side);
    *cell = (int32_t)fmin(fmax(whole, -SW_FARTHEST_CELL), SW_FARTHEST_CELL);
}

void swBindInputs(const swGpuWorld* gpuWorld, swBinding bindings[SW_INPUT_BINDINGS])
{
    const swGpuInputs* inputs = &gpuWorld->inputs;
    const swBuffer* buffers[] = {&inputs->head, &inputs->records, &inputs->nodes, &inputs->words};
    for (int i = 0; i < SW_INPUT_BINDINGS; ++i)
    {
        bindings[i] = swBindBuffer(inputs->isAuthored ? buffers[i] : &gpuWorld->tiles.texels);
    }
}

void swCommitGpuInputs(swGpuInputs* inputs, const swFrame* frame)
{
    if (inputs->isBrought)
    {
        inputs->isHeld = true;
        inputs->version = frame->inputs->version;
        inputs->wordsVersion = frame->inputs->wordsVersion;
    }
}

void swDiscardGpuInputs(swGpuInputs* inputs)
{
    inputs->isHeld = false;
}
