// SPDX-License-Identifier: MIT
#include "gpu/pass/passes.h"

void swDestroyPasses(swGpu* gpu, swPasses* passes)
{
    for (int i = 0; i < SW_TILE_SIZES; ++i)
    {
        swDestroyPipeline(gpu, &passes->wavesRows[i]);
        swDestroyPipeline(gpu, &passes->wavesColumns[i]);
    }
    swDestroyPipeline(gpu, &passes->detail);
    swDestroyPipeline(gpu, &passes->slices);
    swDestroyPipeline(gpu, &passes->foam);
    swDestroyPipeline(gpu, &passes->surfaceQuery[0]);
    swDestroyPipeline(gpu, &passes->surfaceQuery[1]);
}

const swGpuView* swFindGpuView(const swGpuWorld* gpuWorld, const swView* view)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        if (gpuWorld->views[i].isUsed && gpuWorld->views[i].view == view)
        {
            return &gpuWorld->views[i];
        }
    }
    return NULL;
}
