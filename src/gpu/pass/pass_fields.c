// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices, where inputs say anything at all; none where all slices are as they were.
// Slices that have moved are first copied aside, so that the dispatch can move on what is kept of them:
// core/lod/redraw.h says what that is.

#include <string.h>

#include "core/lod/redraw.h"
#include "fields_shader.h"
#include "gpu/pass/passes.h"

// What a view's layers and blocks hold, as of the last recorded frame.
typedef struct Made
{
    bool isThere;
    uint32_t viewVersion, version;
    swSlice slices[SW_MAX_SLICES];
} Made;

// Of one view.
typedef struct ViewState
{
    Made made;
    swBuffer blocks; // swFieldBlock[slices][rows of blocks][columns of blocks]
    // Of this frame.
    swUpload slices;  // swFieldSlice[sliceCount]
    swUpload redraws; // swFieldRedraw[sliceCount]
    bool isStill;     // all is kept where it is
    bool isMoved[SW_MAX_SLICES];
    swFieldsConstants constants;
} ViewState;

typedef struct State
{
    swVariants pipelines;
    ViewState views[SW_MAX_VIEWS];
} State;

static bool isMade(const swGpuWorld* gpuWorld, const swGpuView* view)
{
    return view->isUsed && !view->isCore && gpuWorld->inputs.isAuthored;
}

static uint32_t countColumns(const swGpuView* view)
{
    return ((uint32_t)view->resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH;
}

static uint32_t countRows(const swGpuView* view)
{
    return (uint32_t)view->resolution / SW_SLICE_HEIGHT;
}

void swFillFieldSlices(const swStackFrame* stack, swFieldSlice slices[SW_MAX_SLICES])
{
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        const swSlice* slice = &stack->slices[i];
        swSplitSeaPlace((double)slice->firstX * slice->texel, &slices[i].cellX, &slices[i].restX);
        swSplitSeaPlace((double)slice->firstZ * slice->texel, &slices[i].cellZ, &slices[i].restZ);
        slices[i].texel = (float)slice->texel;
    }
}

// Whether the layers and blocks hold what was made last.
static bool isMadeStill(const swGpuView* view, const ViewState* state)
{
    const int layers[3] = {SW_LAYER_PLACES, SW_LAYER_FLOW, SW_LAYER_FLOW_SLOPES};
    bool isStill = state->made.isThere && state->made.viewVersion == view->viewVersion;
    for (int i = 0; i < 3; ++i)
    {
        bool isHeld = view->frame->stack.layers[layers[i]].isAuthored;
        isStill = isStill && (!isHeld || swGetLayerImage(view, layers[i])->isInitialized);
    }
    return isStill;
}

static swFieldRedraw planSlice(const swGpuView* view, const swInputSet* inputs, const Made* made, int slice,
                               bool isStill)
{
    static_assert(SW_MAX_REDRAWS == SW_MAX_FIELD_RECTS, "room for all of them");
    const swSlice* now = &view->frame->stack.slices[slice];
    swRedraw redraw;
    swRedrawAll(view->resolution, &redraw);
    if (isStill)
    {
        swPlanRedraw(now, &made->slices[slice], view->resolution, inputs, made->version, &redraw);
    }
    bool isSame = redraw.count == 0 && redraw.shiftX == 0 && redraw.shiftZ == 0 && made->version == inputs->version;
    swFieldRedraw told = {
        .shiftX = redraw.shiftX,
        .shiftZ = redraw.shiftZ,
        .isStill = isStill && isSame ? 1 : 0,
        .count = (sw_uint)redraw.count,
    };
    memcpy(told.rects, redraw.rects, sizeof(told.rects));
    return told;
}

static swResult uploadView(swGpuWorld* gpuWorld, const swGpuView* view, ViewState* state)
{
    const swStackFrame* stack = &view->frame->stack;
    const swInputSet* inputs = swGetWorldFrame(gpuWorld->world)->inputs;
    swFieldSlice slices[SW_MAX_SLICES] = {0};
    swFieldRedraw redraws[SW_MAX_SLICES] = {0};
    VkBuffer before = state->blocks.handle;
    VkDeviceSize blocks = (VkDeviceSize)view->sliceCount * countRows(view) * countColumns(view);
    swResult result = swGrowBuffer(gpuWorld->gpu, blocks * sizeof(swFieldBlock), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                   SW_MEMORY_DEVICE, "blocks of fields", &state->blocks);
    bool isStill = before == state->blocks.handle && isMadeStill(view, state);
    swFillFieldSlices(stack, slices);
    state->isStill = true;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        redraws[i] = planSlice(view, inputs, &state->made, i, isStill);
        state->isStill = state->isStill && redraws[i].isStill != 0;
        state->isMoved[i] = redraws[i].shiftX != 0 || redraws[i].shiftZ != 0;
    }
    state->made.isThere = state->isStill; // else until it is recorded
    state->constants = (swFieldsConstants){
        .withGround = stack->layers[SW_LAYER_PLACES].isAuthored ? 1 : 0,
        .withFlow = stack->layers[SW_LAYER_FLOW].isAuthored ? 1 : 0,
    };
    result = result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, slices, sizeof(slices), &state->slices) : result;
    return result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, redraws, sizeof(redraws), &state->redraws) : result;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isMade(gpuWorld, &gpuWorld->views[i]))
        {
            result = uploadView(gpuWorld, &gpuWorld->views[i], &s->views[i]);
            *isNeeded = *isNeeded || !s->views[i].isStill;
        }
        else
        {
            swRetireBuffer(gpuWorld->gpu, &s->views[i].blocks);
            s->views[i].made.isThere = false;
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isMade(gpuWorld, &gpuWorld->views[i]))
        {
            result = swCreateVariant(gpuWorld->gpu, &swFieldsShader, &s->views[i].constants, &s->pipelines);
        }
    }
    return result;
}

// Recording cannot fail any more.
static void noteMade(const swGpuWorld* gpuWorld, const swGpuView* view, Made* made)
{
    const swInputSet* inputs = swGetWorldFrame(gpuWorld->world)->inputs;
    *made = (Made){
        .isThere = true,
        .viewVersion = view->viewVersion,
        .version = inputs->version,
    };
    memcpy(made->slices, view->frame->stack.slices, sizeof(made->slices));
}

// Copy the slices that have moved aside.
static void copySlices(const swGpuWorld* gpuWorld, const swGpuView* view, const ViewState* state, int layer,
                       VkCommandBuffer commands)
{
    const swImage* image = swGetLayerImage(view, layer);
    for (uint32_t i = 0; i < (uint32_t)view->sliceCount; ++i)
    {
        const VkImageCopy copy = {
            .srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, i, 1},
            .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, i, 1},
            .extent = {image->width, image->height, 1},
        };
        if (state->isMoved[i])
        {
            gpuWorld->gpu->vk.CmdCopyImage(commands, image->handle, image->layout, view->layers[layer].between.handle,
                                           view->layers[layer].between.layout, 1, &copy);
        }
    }
}

static void moveAside(const swGpuWorld* gpuWorld, const swGpuView* view, const ViewState* state,
                      VkCommandBuffer commands)
{
    bool isMoved = false;
    for (int i = 0; i < view->sliceCount; ++i)
    {
        isMoved = isMoved || state->isMoved[i];
    }
    if (!isMoved)
    {
        return;
    }
    const VkPipelineStageFlags2 compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    const VkPipelineStageFlags2 copy = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    swBarrier(gpuWorld->gpu, commands, compute, VK_ACCESS_2_SHADER_WRITE_BIT, copy,
              VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    if (state->constants.withGround != 0)
    {
        copySlices(gpuWorld, view, state, SW_LAYER_PLACES, commands);
    }
    if (state->constants.withFlow != 0)
    {
        copySlices(gpuWorld, view, state, SW_LAYER_FLOW, commands);
        copySlices(gpuWorld, view, state, SW_LAYER_FLOW_SLOPES, commands);
    }
    swBarrier(gpuWorld->gpu, commands, copy, VK_ACCESS_2_TRANSFER_WRITE_BIT, compute,
              VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT);
}

// Of a layer that is not held, its one texel.
static const swImage* findBefore(const swGpuView* view, int layer)
{
    const swImage* between = &view->layers[layer].between;
    return between->handle != VK_NULL_HANDLE ? between : swGetLayerImage(view, layer);
}

static void recordView(const swGpuWorld* gpuWorld, const State* s, int index, VkCommandBuffer commands)
{
    static_assert(sizeof(uint32_t) == SW_FIELDS_PUSH_SIZE, "what fields.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swGpuView* view = &gpuWorld->views[index];
    const ViewState* state = &s->views[index];
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    const swFieldsBindings bindings = {
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .slices = swBindUpload(&state->slices),
        .blocks = swBindBuffer(&state->blocks),
        .redraws = swBindUpload(&state->redraws),
        .places = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .flow = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .flowSlopes = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
        .placesBefore = swBindImage(gpu, findBefore(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .flowBefore = swBindImage(gpu, findBefore(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .flowSlopesBefore = swBindImage(gpu, findBefore(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
    };
    uint32_t resolution = (uint32_t)view->resolution;
    moveAside(gpuWorld, view, state, commands);
    swBindFields(gpu, commands, swFindVariant(&s->pipelines, &swFieldsShader, &state->constants), &bindings,
                 &resolution);
    gpu->vk.CmdDispatch(commands, countColumns(view), countRows(view), (uint32_t)view->sliceCount);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    State* s = state;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (isMade(gpuWorld, view) && !s->views[i].isStill)
        {
            recordView(gpuWorld, s, i, commands);
            noteMade(gpuWorld, view, &s->views[i].made);
        }
    }
}

static void discard(swGpuWorld* gpuWorld, void* state, uint64_t frameIndex)
{
    (void)gpuWorld;
    (void)frameIndex;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        ((State*)state)->views[i].made.isThere = false;
    }
}

static void destroy(swGpu* gpu, void* state)
{
    State* s = state;
    swDestroyVariants(gpu, &s->pipelines);
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swDestroyBuffer(gpu, &s->views[i].blocks);
    }
}

static size_t getMemory(const void* state)
{
    const State* s = state;
    size_t size = 0;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        size += s->views[i].blocks.memory.size;
    }
    return size;
}

void swBindFieldPlaces(const swGpuWorld* gpuWorld, int view, swBinding* slices, swBinding* blocks)
{
    const State* s = gpuWorld->passes[SW_PASS_FIELDS].state;
    if (isMade(gpuWorld, &gpuWorld->views[view]))
    {
        *slices = swBindUpload(&s->views[view].slices);
        *blocks = swBindBuffer(&s->views[view].blocks);
    }
}

const swPass swPass_fields = {
    .name = "fields",
    .stateSize = sizeof(State),
    .reads = SW_INPUTS_BIT,
    .writes = SW_LAYER_BIT(SW_LAYER_PLACES) | SW_LAYER_BIT(SW_LAYER_FLOW) | SW_LAYER_BIT(SW_LAYER_FLOW_SLOPES) |
              SW_OUTPUT_BIT(SW_PASS_FIELDS),
    .upload = upload,
    .create = create,
    .record = record,
    .discard = discard,
    .destroy = destroy,
    .getMemory = getMemory,
};
