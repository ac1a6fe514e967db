// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each block of columns of each tile and field.

#include "gpu/pass/passes.h"
#include "waves_columns_shader.h"

swResult swCreateWavesColumns(swGpu* gpu, int resolution, swPasses* passes)
{
    swPipeline* pipeline = &passes->wavesColumns[swTileSizeIndex(resolution)];
    if (pipeline->handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swWavesColumnsConstants constants = {
        .fftSize = (uint32_t)resolution,
        .workgroupX = 6 * (uint32_t)resolution / 4,
    };
    return swCreateComputePipeline(gpu, &swWavesColumnsShader, &constants, pipeline);
}

void swRecordWavesColumns(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    static_assert(sizeof(swWavesParams) == SW_WAVES_COLUMNS_PUSH_SIZE, "what waves_columns.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swWavesColumnsBindings bindings = {
        .tiles = swBindUpload(&gpuWorld->tileParams),
        .order = swBindUpload(&gpuWorld->order),
        .roots = swBindBuffer(&gpuWorld->roots),
        .lines = swBindBuffer(&gpuWorld->lines),
        .texels = swBindBuffer(&gpuWorld->texels),
    };
    swBeginPass(gpu, commands, "waves_columns");
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (gpuWorld->groupCount[size] > 0)
        {
            uint32_t blockCount = (16u << size) / SW_COLUMN_BLOCK;
            swWavesParams params = swMakeWavesParams(gpuWorld, size);
            swBindWavesColumns(gpu, commands, &gpuWorld->passes.wavesColumns[size], &bindings, &params);
            gpu->vk.CmdDispatch(commands, blockCount, gpuWorld->groupCount[size], gpuWorld->fields.count);
        }
    }
    swEndPass(gpu, commands);
}
