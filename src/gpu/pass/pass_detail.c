// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of detail texels of each tile, all mips.
//
// The image is RGBA16F, a 2D array with one layer a tile and SW_DETAIL_MIPS mips: (sx, sz, sx^2, sz^2) with s the slope
// of the tile's height by rest position at sample points; mips are averages, so that slopes lost by filtering have
// variance s2 - s s. Rest point u of the plane is at uv = u / side + 0.5 / width. Repeats.

#include "detail_shader.h"
#include "gpu/pass/passes.h"

typedef struct State
{
    swPipeline pipeline;
    swImage image;
} State;

// The largest tile resolution, within limits.
static uint32_t findSide(const swFrame* frame)
{
    int side = SW_DETAIL_MIN;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        side = frame->tiles[i].resolution > side ? frame->tiles[i].resolution : side;
    }
    return (uint32_t)(side < SW_DETAIL_MAX ? side : SW_DETAIL_MAX);
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    swGpu* gpu = gpuWorld->gpu;
    State* s = state;
    uint32_t layers = frame->tileCount > 0 ? (uint32_t)frame->tileCount : 1;
    uint32_t side = findSide(frame);
    if (s->image.handle == VK_NULL_HANDLE || s->image.layers != layers || s->image.width != side)
    {
        const swImageDef def = {
            .format = VK_FORMAT_R16G16B16A16_SFLOAT,
            .width = side,
            .height = side,
            .layers = layers,
            .mips = SW_DETAIL_MIPS,
            .isArray = true,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .layout = VK_IMAGE_LAYOUT_GENERAL,
            .name = "detail",
        };
        swImage grown;
        swResult result = swCreateImage(gpu, &def, &grown);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        swRetireImage(gpu, &s->image);
        s->image = grown;
    }
    *isNeeded = gpuWorld->tiles.count > 0 || !s->image.isInitialized; // drawing binds it, also where there are no waves
    return SW_SUCCESS;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    return swCreateOnce(gpuWorld->gpu, &swDetailShader, &((State*)state)->pipeline);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(uint32_t) == SW_DETAIL_PUSH_SIZE, "what detail.comp is given");
    static_assert(SW_DETAIL_MIPS == 6, "detail.comp has a binding for each");
    swGpu* gpu = gpuWorld->gpu;
    State* s = state;
    swInitializeImage(gpu, commands, &s->image);
    if (gpuWorld->tiles.count == 0)
    {
        return;
    }
    swBinding mips[SW_DETAIL_MIPS];
    for (uint32_t mip = 0; mip < SW_DETAIL_MIPS; ++mip)
    {
        mips[mip] = swBindView(gpu, s->image.mipViews[mip], s->image.layout, SW_SAMPLER_NEAREST_CLAMP);
    }
    const swDetailBindings bindings = {
        .tiles = swBindUpload(&gpuWorld->tiles.paramsUpload),
        .texels = swBindBuffer(&gpuWorld->tiles.texels),
        .mip0 = mips[0],
        .mip1 = mips[1],
        .mip2 = mips[2],
        .mip3 = mips[3],
        .mip4 = mips[4],
        .mip5 = mips[5],
    };
    uint32_t side = s->image.width;
    swBindDetail(gpu, commands, &s->pipeline, &bindings, &side);
    gpu->vk.CmdDispatch(commands, side / SW_DETAIL_BLOCK, side / SW_DETAIL_BLOCK, (uint32_t)gpuWorld->tiles.count);
}

static void discard(swGpuWorld* gpuWorld, void* state, uint64_t frameIndex)
{
    (void)gpuWorld;
    (void)frameIndex;
    ((State*)state)->image.isInitialized = false; // each frame makes it anew
}

static void destroy(swGpu* gpu, void* state)
{
    State* s = state;
    swDestroyPipeline(gpu, &s->pipeline);
    swDestroyImage(gpu, &s->image);
}

static size_t getMemory(const void* state)
{
    return (size_t)((const State*)state)->image.memory.size;
}

const swImage* swGetDetailImage(const swGpuWorld* gpuWorld)
{
    return &((const State*)gpuWorld->passes[SW_PASS_DETAIL].state)->image;
}

const swPass swPass_detail = {
    .name = "detail",
    .stateSize = sizeof(State),
    .reads = SW_TEXELS_BIT,
    .writes = SW_OUTPUT_BIT(SW_PASS_DETAIL),
    .upload = upload,
    .create = create,
    .record = record,
    .discard = discard,
    .destroy = destroy,
    .getMemory = getMemory,
};
