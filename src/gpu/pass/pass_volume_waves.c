// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of modes of each tile. Only in frames with a query of the water below.

#include "gpu/pass/passes.h"
#include "gpu/pass/query_passes.h"
#include "volume_waves_shader.h"

typedef struct State
{
    swPipeline pipeline;
    swBuffer waves; // of each mode, swVolumeWave
} State;

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    (void)frame;
    const swGpuTiles* tiles = &gpuWorld->tiles;
    if (!swHasQuery(gpuWorld, SW_GPU_QUERY_KIND_VOLUME))
    {
        return SW_SUCCESS;
    }
    *isNeeded = tiles->count > 0;
    VkDeviceSize count = 1; // something to bind when there are no waves
    for (int i = 0; i < tiles->count; ++i)
    {
        count += tiles->params[i].modeCount;
    }
    return swGrowBuffer(gpuWorld->gpu, count * sizeof(swVolumeWave), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                        SW_MEMORY_DEVICE, "waves one by one", &((State*)state)->waves);
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    return swCreateOnce(gpuWorld->gpu, &swVolumeWavesShader, &((State*)state)->pipeline);
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    const State* s = state;
    const swGpuTiles* tiles = &gpuWorld->tiles;
    uint32_t most = 0;
    for (int i = 0; i < tiles->count; ++i)
    {
        most = tiles->params[i].modeCount > most ? tiles->params[i].modeCount : most;
    }
    const swVolumeWavesBindings bindings = {
        .tiles = swBindUpload(&tiles->paramsUpload),
        .modes = swBindBuffer(&tiles->modes),
        .waves = swBindBuffer(&s->waves),
    };
    swBindVolumeWaves(gpu, commands, &s->pipeline, &bindings);
    gpu->vk.CmdDispatch(commands, (most + SW_VOLUME_MODES - 1) / SW_VOLUME_MODES, (uint32_t)tiles->count, 1);
}

static void destroy(swGpu* gpu, void* state)
{
    State* s = state;
    swDestroyPipeline(gpu, &s->pipeline);
    swDestroyBuffer(gpu, &s->waves);
}

static size_t getMemory(const void* state)
{
    return (size_t)((const State*)state)->waves.memory.size;
}

const swBuffer* swGetVolumeWaves(const swGpuWorld* gpuWorld)
{
    return &((const State*)gpuWorld->passes[SW_PASS_VOLUME_WAVES].state)->waves;
}

const swPass swPass_volume_waves = {
    .name = "volume_waves",
    .stateSize = sizeof(State),
    .reads = SW_MODES_BIT,
    .writes = SW_OUTPUT_BIT(SW_PASS_VOLUME_WAVES),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
    .getMemory = getMemory,
};
