// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; nothing waits between views.

#include "gpu/pass/passes.h"

static const uint32_t slicesCode[] =
#include "slices.comp.inc"
    ;

swResult swCreateSlices(swGpu* gpu, swPasses* passes)
{
    if (passes->slices.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swComputeDef def = {
        .shader = SW_SHADER(slicesCode),
        .bindingCount = 6,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        .name = "slices",
    };
    return swCreateComputePipeline(gpu, &def, &passes->slices);
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
        const swBinding bindings[] = {
            swBindUpload(&view->sliceLists),
            swBindUpload(&view->sliceTiles),
            swBindBuffer(&gpuWorld->texels),
            swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
            swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DERIVATIVES), SW_SAMPLER_NEAREST_CLAMP),
            swBindUpload(&view->sliceWaves),
        };
        uint32_t resolution = (uint32_t)view->resolution;
        swBindPipeline(gpu, commands, &gpuWorld->passes.slices, bindings, NULL);
        gpu->vk.CmdDispatch(commands, (resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH, resolution / SW_SLICE_HEIGHT,
                            (uint32_t)view->sliceCount);
    }
    swEndPass(gpu, commands);
}
