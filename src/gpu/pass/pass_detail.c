// SPDX-License-Identifier: MIT
// One dispatch: a workgroup for each block of detail texels of each tile, all mips.

#include "gpu/pass/passes.h"
#include "detail_shader.h"

swResult swCreateDetail(swGpu* gpu, swPasses* passes)
{
    return swCreateComputePipeline(gpu, &swDetailShader, NULL, &passes->detail);
}

void swRecordDetail(const swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    if (gpuWorld->tileCount == 0)
    {
        return;
    }
    swGpu* gpu = gpuWorld->gpu;
    const swImage* detail = &gpuWorld->detail;
    swBinding mips[SW_DETAIL_MIPS];
    for (uint32_t mip = 0; mip < SW_DETAIL_MIPS; ++mip)
    {
        mips[mip] = swBindView(gpu, detail->mipViews[mip], detail->layout, SW_SAMPLER_NEAREST_CLAMP);
    }
    static_assert(SW_DETAIL_MIPS == 6, "detail.comp has a binding for each");
    const swDetailBindings bindings = {
        .tiles = swBindUpload(&gpuWorld->tileParams),
        .texels = swBindBuffer(&gpuWorld->texels),
        .mip0 = mips[0],
        .mip1 = mips[1],
        .mip2 = mips[2],
        .mip3 = mips[3],
        .mip4 = mips[4],
        .mip5 = mips[5],
    };
    static_assert(sizeof(uint32_t) == SW_DETAIL_PUSH_SIZE, "what detail.comp is given");
    uint32_t side = detail->width;
    swBeginPass(gpu, commands, "detail");
    swBindDetail(gpu, commands, &gpuWorld->passes.detail, &bindings, &side);
    gpu->vk.CmdDispatch(commands, side / SW_DETAIL_BLOCK, side / SW_DETAIL_BLOCK, (uint32_t)gpuWorld->tileCount);
    swEndPass(gpu, commands);
}
