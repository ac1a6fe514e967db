// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of detail texels of each tile, all mips.

#include "gpu/pass/passes.h"

static const uint32_t detailCode[] =
#include "detail.comp.inc"
    ;

swResult swCreateDetail(swGpu* gpu, swPasses* passes)
{
    swComputeDef def = {
        .shader = SW_SHADER(detailCode),
        .bindingCount = 2 + SW_DETAIL_MIPS,
        .types = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        .pushSize = sizeof(uint32_t),
        .name = "detail",
    };
    for (uint32_t mip = 0; mip < SW_DETAIL_MIPS; ++mip)
    {
        def.types[2 + mip] = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    }
    return swCreateComputePipeline(gpu, &def, &passes->detail);
}

void swRecordDetail(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (gpuWorld->tileCount == 0)
    {
        return;
    }
    swGpu* gpu = gpuWorld->gpu;
    const swImage* detail = &gpuWorld->detail;
    swBinding bindings[2 + SW_DETAIL_MIPS] = {
        swBindUpload(&gpuWorld->tileParams),
        swBindBuffer(&gpuWorld->texels),
    };
    for (uint32_t mip = 0; mip < SW_DETAIL_MIPS; ++mip)
    {
        bindings[2 + mip] = swBindView(gpu, detail->mipViews[mip], detail->layout, SW_SAMPLER_NEAREST_CLAMP);
    }
    uint32_t side = detail->width;
    swBeginPass(gpu, commands, "detail");
    swBindPipeline(gpu, commands, &gpuWorld->passes.detail, bindings, &side);
    gpu->vk.CmdDispatch(commands, side / SW_DETAIL_BLOCK, side / SW_DETAIL_BLOCK, (uint32_t)gpuWorld->tileCount);
    swEndPass(gpu, commands);
}
