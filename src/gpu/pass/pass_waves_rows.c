// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each row of each tile and field.

#include "gpu/pass/passes.h"
#include "waves_rows_shader.h"

swResult swCreateWavesRows(swGpu* gpu, int resolution, swPasses* passes)
{
    swPipeline* pipeline = &passes->wavesRows[swTileSizeIndex(resolution)];
    if (pipeline->handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swWavesRowsConstants constants = {
        .fftSize = (uint32_t)resolution,
        .workgroupX = 3 * (uint32_t)resolution / 4,
    };
    return swCreateComputePipeline(gpu, &swWavesRowsShader, &constants, pipeline);
}

void swRecordWavesRows(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    static_assert(sizeof(swWavesParams) == SW_WAVES_ROWS_PUSH_SIZE, "what waves_rows.comp is given");
    swGpu* gpu = gpuWorld->gpu;
    const swWavesRowsBindings bindings = {
        .tiles = swBindUpload(&gpuWorld->tileParams),
        .order = swBindUpload(&gpuWorld->order),
        .rows = swBindBuffer(&gpuWorld->rows),
        .modes = swBindBuffer(&gpuWorld->modes),
        .roots = swBindBuffer(&gpuWorld->roots),
        .lines = swBindBuffer(&gpuWorld->lines),
    };
    swBeginPass(gpu, commands, "waves_rows");
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (gpuWorld->groupCount[size] > 0)
        {
            uint32_t rowCount = (16u << size) / 4 + 1;
            swWavesParams params = swMakeWavesParams(gpuWorld, size);
            swBindWavesRows(gpu, commands, &gpuWorld->passes.wavesRows[size], &bindings, &params);
            gpu->vk.CmdDispatch(commands, rowCount, gpuWorld->groupCount[size], gpuWorld->fields.count);
        }
    }
    swEndPass(gpu, commands);
}
