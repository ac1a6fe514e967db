// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each block of columns of each tile and field.

#include "gpu/pass/passes.h"

static const uint32_t wavesColumnsCode[] =
#include "waves_columns.comp.inc"
    ;

swResult swCreateWavesColumns(swGpu* gpu, int resolution, swPasses* passes)
{
    swPipeline* pipeline = &passes->wavesColumns[swTileSizeIndex(resolution)];
    if (pipeline->handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const uint32_t constants[] = {(uint32_t)resolution, 6 * (uint32_t)resolution / 4};
    const swComputeDef def = {
        .shader = SW_SHADER(wavesColumnsCode),
        .bindingCount = 5,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        .pushSize = sizeof(swWavesParams),
        .constantCount = 2,
        .constants = constants,
        .name = "waves_columns",
    };
    return swCreateComputePipeline(gpu, &def, pipeline);
}

void swRecordWavesColumns(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    const swBinding bindings[] = {
        swBindUpload(&gpuWorld->tileParams), swBindUpload(&gpuWorld->order),  swBindBuffer(&gpuWorld->roots),
        swBindBuffer(&gpuWorld->lines),      swBindBuffer(&gpuWorld->texels),
    };
    swBeginPass(gpu, commands, "waves_columns");
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (gpuWorld->groupCount[size] > 0)
        {
            uint32_t blockCount = (16u << size) / SW_COLUMN_BLOCK;
            swWavesParams params = swMakeWavesParams(gpuWorld, size);
            swBindPipeline(gpu, commands, &gpuWorld->passes.wavesColumns[size], bindings, &params);
            gpu->vk.CmdDispatch(commands, blockCount, gpuWorld->groupCount[size], gpuWorld->fields.count);
        }
    }
    swEndPass(gpu, commands);
}
