// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each row of each tile and field.

#include "gpu/pass/passes.h"
#include "waves_rows_shader.h"

typedef struct State
{
    swVariants pipelines; // of each resolution
} State;

static swWavesRowsConstants constantsOf(uint32_t resolution)
{
    return (swWavesRowsConstants){.fftSize = resolution, .workgroupX = 3 * resolution / 4};
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    (void)state;
    *isNeeded = gpuWorld->tiles.count > 0 && !gpuWorld->tiles.isCore;
    return SW_SUCCESS;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int size = 0; size < SW_TILE_SIZES && result == SW_SUCCESS; ++size)
    {
        if (gpuWorld->tiles.groupCount[size] > 0)
        {
            swWavesRowsConstants constants = constantsOf(16u << size);
            result = swCreateVariant(gpuWorld->gpu, &swWavesRowsShader, &constants, &s->pipelines);
        }
    }
    return result;
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(swWavesParams) == SW_WAVES_ROWS_PUSH_SIZE, "what waves_rows.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const State* s = state;
    const swGpuTiles* tiles = &gpuWorld->tiles;
    const swWavesRowsBindings bindings = {
        .tiles = swBindUpload(&tiles->paramsUpload),
        .order = swBindUpload(&tiles->order),
        .rows = swBindBuffer(&tiles->rows),
        .modes = swBindBuffer(&tiles->modes),
        .roots = swBindBuffer(&tiles->roots),
        .lines = swBindBuffer(&tiles->lines),
    };
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (tiles->groupCount[size] > 0)
        {
            uint32_t resolution = 16u << size;
            uint32_t rowCount = resolution / 4 + 1;
            swWavesParams params = swMakeWavesParams(tiles, size);
            swWavesRowsConstants constants = constantsOf(resolution);
            const swPipeline* pipeline = swFindVariant(&s->pipelines, &swWavesRowsShader, &constants);
            swBindWavesRows(gpu, commands, pipeline, &bindings, &params);
            gpu->vk.CmdDispatch(commands, rowCount, tiles->groupCount[size], tiles->fields.count);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_waves_rows = {
    .name = "waves_rows",
    .stateSize = sizeof(State),
    .reads = SW_MODES_BIT,
    .writes = SW_OUTPUT_BIT(SW_PASS_WAVES_ROWS),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
