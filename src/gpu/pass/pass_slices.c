// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; nothing waits between views.

#include "gpu/pass/passes.h"
#include "slices_shader.h"

swResult swCreateSlices(swGpu* gpu, swPasses* passes)
{
    if (passes->slices.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    return swCreateComputePipeline(gpu, &swSlicesShader, NULL, &passes->slices);
}

void swRecordSlices(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swBeginPass(gpu, commands, "slices");
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (!view->isUsed || view->isCore)
        {
            continue;
        }
        const swSlicesBindings bindings = {
            .lists = swBindUpload(&view->sliceLists),
            .tiles = swBindUpload(&view->sliceTiles),
            .texels = swBindBuffer(&gpuWorld->texels),
            .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
            .derivatives = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DERIVATIVES), SW_SAMPLER_NEAREST_CLAMP),
            .waves = swBindUpload(&view->sliceWaves),
        };
        uint32_t resolution = (uint32_t)view->resolution;
        swBindSlices(gpu, commands, &gpuWorld->passes.slices, &bindings);
        gpu->vk.CmdDispatch(commands, (resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH, resolution / SW_SLICE_HEIGHT,
                            (uint32_t)view->sliceCount);
    }
    swEndPass(gpu, commands);
}
