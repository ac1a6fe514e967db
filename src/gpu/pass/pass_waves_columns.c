// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each block of columns of each tile and field.

#include "gpu/pass/passes.h"
#include "waves_columns_shader.h"

typedef struct State
{
    swVariants pipelines; // of each resolution
} State;

static swWavesColumnsConstants constantsOf(uint32_t resolution)
{
    return (swWavesColumnsConstants){.fftSize = resolution, .workgroupX = 6 * resolution / 4};
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
            swWavesColumnsConstants constants = constantsOf(16u << size);
            result = swCreateVariant(gpuWorld->gpu, &swWavesColumnsShader, &constants, &s->pipelines);
        }
    }
    return result;
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    static_assert(sizeof(swWavesParams) == SW_WAVES_COLUMNS_PUSH_SIZE, "what waves_columns.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const State* s = state;
    const swGpuTiles* tiles = &gpuWorld->tiles;
    const swWavesColumnsBindings bindings = {
        .tiles = swBindUpload(&tiles->paramsUpload),
        .order = swBindUpload(&tiles->order),
        .roots = swBindBuffer(&tiles->roots),
        .lines = swBindBuffer(&tiles->lines),
        .texels = swBindBuffer(&tiles->texels),
    };
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (tiles->groupCount[size] > 0)
        {
            uint32_t resolution = 16u << size;
            uint32_t blockCount = resolution / SW_COLUMN_BLOCK;
            swWavesParams params = swMakeWavesParams(tiles, size);
            swWavesColumnsConstants constants = constantsOf(resolution);
            const swPipeline* pipeline = swFindVariant(&s->pipelines, &swWavesColumnsShader, &constants);
            swBindWavesColumns(gpu, commands, pipeline, &bindings, &params);
            gpu->vk.CmdDispatch(commands, blockCount, tiles->groupCount[size], tiles->fields.count);
        }
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

const swPass swPass_waves_columns = {
    .name = "waves_columns",
    .stateSize = sizeof(State),
    .reads = SW_OUTPUT_BIT(SW_PASS_WAVES_ROWS),
    .writes = SW_OUTPUT_BIT(SW_PASS_WAVES_COLUMNS),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
