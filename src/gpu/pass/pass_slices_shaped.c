// SPDX-License-Identifier: MIT
// One dispatch a view for all blocks of its slices, where inputs say anything at all; those that nothing shapes end at
// once.

#include "gpu/pass/passes.h"
#include "slices_shaped_shader.h"

typedef struct State
{
    swVariants pipelines;
    swSlicesShapedConstants constants; // of this frame
    swBuffer shaped[SW_MAX_VIEWS];     // two vec4 of each texel
} State;

static bool isMade(const swGpuWorld* gpuWorld, const swGpuView* view)
{
    return view->isUsed && !view->isCore && gpuWorld->inputs.isAuthored;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    s->constants = (swSlicesShapedConstants){
        .withWaves = frame->waveCount > 0 ? 1 : 0,
        .withFlow = gpuWorld->inputs.hasFlow ? 1 : 0,
        .withDisplacement = gpuWorld->inputs.hasDisplacement ? 1 : 0,
        .withWeights = swHasInputs(frame->inputs, SW_INPUT_WAVES) || frame->inputs->localSystems != 0 ? 1 : 0,
        .withRibbons = gpuWorld->inputs.hasRibbons ? 1 : 0,
    };
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (isMade(gpuWorld, view))
        {
            VkDeviceSize texels = (VkDeviceSize)view->sliceCount * (VkDeviceSize)(view->resolution * view->resolution);
            result = swGrowBuffer(gpuWorld->gpu, 2 * texels * sizeof(float[4]), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                  SW_MEMORY_DEVICE, "shaped waves", &s->shaped[i]);
            *isNeeded = true;
        }
        else
        {
            swRetireBuffer(gpuWorld->gpu, &s->shaped[i]);
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    return swCreateVariant(gpuWorld->gpu, &swSlicesShapedShader, &s->constants, &s->pipelines);
}

static void recordView(const swGpuWorld* gpuWorld, int index, const State* s, VkCommandBuffer commands)
{
    static_assert(sizeof(uint32_t) == SW_SLICES_SHAPED_PUSH_SIZE, "what slices_shaped.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swGpuView* view = &gpuWorld->views[index];
    uint32_t resolution = (uint32_t)view->resolution;
    swBinding inputs[SW_INPUT_BINDINGS], waves[SW_SLICE_WAVE_BINDINGS], fields[2];
    swBindInputs(gpuWorld, inputs);
    swBindSliceWaves(gpuWorld, index, waves);
    swBindFieldPlaces(gpuWorld, index, &fields[0], &fields[1]);
    const swSlicesShapedBindings bindings = {
        .lists = waves[0],
        .tiles = waves[1],
        .texels = swBindBuffer(&gpuWorld->tiles.texels),
        .waves = waves[2],
        .places = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .fieldSlices = fields[0],
        .blocks = fields[1],
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .shaped = swBindBuffer(&s->shaped[index]),
        .flow = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .flowSlopes = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FLOW_SLOPES), SW_SAMPLER_NEAREST_CLAMP),
        .likeness = swBindLikeness(gpuWorld),
    };
    swBindSlicesShaped(gpu, commands, swFindVariant(&s->pipelines, &swSlicesShapedShader, &s->constants), &bindings,
                       &resolution);
    gpu->vk.CmdDispatch(commands, (resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH, resolution / SW_SHAPED_ROWS,
                        (uint32_t)view->sliceCount);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        if (isMade(gpuWorld, &gpuWorld->views[i]))
        {
            recordView(gpuWorld, i, state, commands);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    State* s = state;
    swDestroyVariants(gpu, &s->pipelines);
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swDestroyBuffer(gpu, &s->shaped[i]);
    }
}

static size_t getMemory(const void* state)
{
    const State* s = state;
    size_t size = 0;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        size += s->shaped[i].memory.size;
    }
    return size;
}

const swBuffer* swGetShapedWaves(const swGpuWorld* gpuWorld, int view)
{
    const State* s = gpuWorld->passes[SW_PASS_SLICES_SHAPED].state;
    return &s->shaped[view];
}

const swPass swPass_slices_shaped = {
    .name = "slices_shaped",
    .stateSize = sizeof(State),
    .reads = SW_TEXELS_BIT | SW_MODES_BIT | SW_INPUTS_BIT | SW_LAYER_BIT(SW_LAYER_PLACES) |
             SW_LAYER_BIT(SW_LAYER_FLOW) | SW_LAYER_BIT(SW_LAYER_FLOW_SLOPES) | SW_OUTPUT_BIT(SW_PASS_FIELDS),
    .writes = SW_OUTPUT_BIT(SW_PASS_SLICES_SHAPED),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
    .getMemory = getMemory,
};
