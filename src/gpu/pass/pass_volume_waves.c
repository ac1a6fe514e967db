// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of modes of each tile. Only in frames with a query of the water below.

#include "gpu/pass/passes.h"

static const uint32_t volumeWavesCode[] =
#include "volume_waves.comp.inc"
    ;

swResult swCreateVolumeWaves(swGpu* gpu, swPasses* passes)
{
    if (passes->volumeWaves.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swComputeDef def = {
        .shader = SW_SHADER(volumeWavesCode),
        .bindingCount = 3,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        .name = "volume_waves",
    };
    return swCreateComputePipeline(gpu, &def, &passes->volumeWaves);
}

void swRecordVolumeWaves(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (!gpuWorld->hasVolume || gpuWorld->tileCount == 0)
    {
        return;
    }
    swGpu* gpu = gpuWorld->gpu;
    uint32_t most = 0;
    for (int i = 0; i < gpuWorld->tileCount; ++i)
    {
        most = gpuWorld->params[i].modeCount > most ? gpuWorld->params[i].modeCount : most;
    }
    const swBinding bindings[] = {
        swBindUpload(&gpuWorld->tileParams),
        swBindBuffer(&gpuWorld->modes),
        swBindBuffer(&gpuWorld->volumeWaves),
    };
    swBeginPass(gpu, commands, "volume_waves");
    swBindPipeline(gpu, commands, &gpuWorld->passes.volumeWaves, bindings, NULL);
    gpu->vk.CmdDispatch(commands, (most + SW_VOLUME_MODES - 1) / SW_VOLUME_MODES, (uint32_t)gpuWorld->tileCount, 1);
    swEndPass(gpu, commands);
}
