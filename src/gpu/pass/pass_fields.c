// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices, where inputs say anything at all.

#include <string.h>

#include "fields_shader.h"
#include "gpu/pass/passes.h"

// What a view's layers and blocks hold, as of the last recorded frame.
typedef struct Made
{
    bool isThere;
    uint32_t viewVersion, version, wordsVersion;
    swSlice slices[SW_MAX_SLICES];
} Made;

// Of one view.
typedef struct ViewState
{
    Made made;
    swBuffer blocks; // swFieldBlock[slices][rows of blocks][columns of blocks]
    swUpload slices; // swFieldSlice[sliceCount]; of this frame
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

static bool isSamePlace(const swSlice* a, const swSlice* b)
{
    return a->firstX == b->firstX && a->firstZ == b->firstZ && a->texel == b->texel;
}

// Whether the texels of slices that have not moved are still what they were.
static bool isMadeStill(const swGpuWorld* gpuWorld, const swGpuView* view, const Made* made)
{
    const swInputSet* inputs = swGetWorldFrame(gpuWorld->world)->inputs;
    return made->isThere && made->viewVersion == view->viewVersion && made->version == inputs->version &&
           made->wordsVersion == inputs->wordsVersion && swGetLayerImage(view, SW_LAYER_PLACES)->isInitialized;
}

static swResult uploadView(swGpuWorld* gpuWorld, const swGpuView* view, ViewState* state)
{
    const swStackFrame* stack = &view->frame->stack;
    swFieldSlice slices[SW_MAX_SLICES] = {0};
    VkBuffer before = state->blocks.handle;
    VkDeviceSize blocks = (VkDeviceSize)view->sliceCount * countRows(view) * countColumns(view);
    swResult result = swGrowBuffer(gpuWorld->gpu, blocks * sizeof(swFieldBlock), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                   SW_MEMORY_DEVICE, "blocks of fields", &state->blocks);
    bool isStill = before == state->blocks.handle && isMadeStill(gpuWorld, view, &state->made);
    state->made.isThere = false; // until it is recorded
    swFillFieldSlices(stack, slices);
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        slices[i].isKept = isStill && isSamePlace(&stack->slices[i], &state->made.slices[i]) ? 1 : 0;
    }
    state->constants = (swFieldsConstants){
        .withGround = stack->layers[SW_LAYER_PLACES].isAuthored ? 1 : 0,
        .withFlow = stack->layers[SW_LAYER_FLOW].isAuthored ? 1 : 0,
    };
    return result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, slices, sizeof(slices), &state->slices) : result;
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
            *isNeeded = true;
            result = uploadView(gpuWorld, &gpuWorld->views[i], &s->views[i]);
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
        .wordsVersion = inputs->wordsVersion,
    };
    memcpy(made->slices, view->frame->stack.slices, sizeof(made->slices));
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    State* s = state;
    static_assert(sizeof(uint32_t) == SW_FIELDS_PUSH_SIZE, "what fields.comp is given");
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (!isMade(gpuWorld, view))
        {
            continue;
        }
        const swFieldsBindings bindings = {
            .inputHead = inputs[0],
            .inputRecords = inputs[1],
            .inputNodes = inputs[2],
            .inputWords = inputs[3],
            .slices = swBindUpload(&s->views[i].slices),
            .blocks = swBindBuffer(&s->views[i].blocks),
            .places = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
            .flow = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
            .flowSlopes = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
        };
        uint32_t resolution = (uint32_t)view->resolution;
        swBindFields(gpu, commands, swFindVariant(&s->pipelines, &swFieldsShader, &s->views[i].constants), &bindings,
                     &resolution);
        gpu->vk.CmdDispatch(commands, countColumns(view), countRows(view), (uint32_t)view->sliceCount);
        noteMade(gpuWorld, view, &s->views[i].made);
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
