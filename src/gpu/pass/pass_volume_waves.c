// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of modes of each tile. Only in frames with a query of the water below.

#include "gpu/pass/passes.h"
#include "volume_waves_shader.h"

swResult swCreateVolumeWaves(swGpu* gpu, swPasses* passes)
{
    if (passes->volumeWaves.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    return swCreateComputePipeline(gpu, &swVolumeWavesShader, NULL, &passes->volumeWaves);
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
    const swVolumeWavesBindings bindings = {
        .tiles = swBindUpload(&gpuWorld->tileParams),
        .modes = swBindBuffer(&gpuWorld->modes),
        .waves = swBindBuffer(&gpuWorld->volumeWaves),
    };
    swBeginPass(gpu, commands, "volume_waves");
    swBindVolumeWaves(gpu, commands, &gpuWorld->passes.volumeWaves, &bindings);
    gpu->vk.CmdDispatch(commands, (most + SW_VOLUME_MODES - 1) / SW_VOLUME_MODES, (uint32_t)gpuWorld->tileCount, 1);
    swEndPass(gpu, commands);
}
