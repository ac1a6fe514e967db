// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; a view whose foam stays as it is has none.

#include "gpu/pass/passes.h"

static const uint32_t foamCode[] =
#include "foam.comp.inc"
    ;

swResult swCreateFoam(swGpu* gpu, swPasses* passes)
{
    if (passes->foam.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swComputeDef def = {
        .shader = SW_SHADER(foamCode),
        .bindingCount = 5,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                  VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
        .pushSize = sizeof(int32_t),
        .name = "foam",
    };
    return swCreateComputePipeline(gpu, &def, &passes->foam);
}

void swRecordFoam(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swBeginPass(gpu, commands, "foam");
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (!view->isUsed || !view->layers[SW_LAYER_FOAM].due.isDue)
        {
            continue;
        }
        const swBinding bindings[] = {
            swBindUpload(&view->foamParams),
            swBindUpload(&view->foamSources),
            swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
            swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
            swBindImage(gpu, swGetNextLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
        };
        int32_t resolution = view->resolution;
        uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
        swBindPipeline(gpu, commands, &gpuWorld->passes.foam, bindings, &resolution);
        gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
    }
    swEndPass(gpu, commands);
}
