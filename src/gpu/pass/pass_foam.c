// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; a view whose foam stays as it is has none.

#include "gpu/pass/passes.h"
#include "foam_shader.h"

swResult swCreateFoam(swGpu* gpu, swPasses* passes)
{
    if (passes->foam.handle != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    return swCreateComputePipeline(gpu, &swFoamShader, NULL, &passes->foam);
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
        const swFoamBindings bindings = {
            .slices = swBindUpload(&view->foamParams),
            .sources = swBindUpload(&view->foamSources),
            .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
            .previous = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
            .nextFoam = swBindImage(gpu, swGetNextLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_NEAREST_CLAMP),
        };
        static_assert(sizeof(int32_t) == SW_FOAM_PUSH_SIZE, "what foam.comp is given");
        int32_t resolution = view->resolution;
        uint32_t blocks = (uint32_t)resolution / SW_FOAM_BLOCK;
        swBindFoam(gpu, commands, &gpuWorld->passes.foam, &bindings, &resolution);
        gpu->vk.CmdDispatch(commands, blocks, blocks, (uint32_t)view->sliceCount);
    }
    swEndPass(gpu, commands);
}
