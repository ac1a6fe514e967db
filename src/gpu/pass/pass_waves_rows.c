// SPDX-License-Identifier: MIT
// One dispatch a tile resolution: a workgroup for each row of each tile and field.

#include "gpu/pass/passes.h"

static const uint32_t wavesRowsCode[] =
#include "waves_rows.comp.inc"
    ;

swResult swCreateWavesRows(swGpu* gpu, int resolution, swPasses* passes)
{
    swPipeline* pipeline = &passes->wavesRows[swTileSizeIndex(resolution)];
    if (pipeline->handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const uint32_t constants[] = {(uint32_t)resolution, 3 * (uint32_t)resolution / 4};
    const swComputeDef def = {
        .shader = SW_SHADER(wavesRowsCode),
        .bindingCount = 6,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        .pushSize = sizeof(swWavesParams),
        .constantCount = 2,
        .constants = constants,
        .name = "waves_rows",
    };
    return swCreateComputePipeline(gpu, &def, pipeline);
}

void swRecordWavesRows(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    const swBinding bindings[] = {
        swBindUpload(&gpuWorld->tileParams), swBindUpload(&gpuWorld->order), swBindBuffer(&gpuWorld->rows),
        swBindBuffer(&gpuWorld->modes),      swBindBuffer(&gpuWorld->roots), swBindBuffer(&gpuWorld->lines),
    };
    swBeginPass(gpu, commands, "waves_rows");
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        if (gpuWorld->groupCount[size] > 0)
        {
            uint32_t rowCount = (16u << size) / 4 + 1;
            swWavesParams params = swMakeWavesParams(gpuWorld, size);
            swBindPipeline(gpu, commands, &gpuWorld->passes.wavesRows[size], bindings, &params);
            gpu->vk.CmdDispatch(commands, rowCount, gpuWorld->groupCount[size], gpuWorld->fields.count);
        }
    }
    swEndPass(gpu, commands);
}
