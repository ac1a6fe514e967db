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
    swDestroyPipeline(gpu, &passes->volumeWaves);
    swDestroyPipeline(gpu, &passes->volumeQuery);
}

// What offsets of storage buffers are rounded down to: the most that a device may ask for.
#define SW_OFFSET_ALIGNMENT 256u

// Workgroups along an axis that every device can have.
#define SW_MOST_GROUPS 65535u

static uint32_t countPointWords(const swGpuQuery* query)
{
    bool isFloat = query->hostPoints != VK_NULL_HANDLE;
    return !isFloat ? sizeof(swQueryPoint) / 4 : query->def.kind == SW_GPU_QUERY_KIND_VOLUME ? 3 : 2;
}

swBinding swBindPoints(const swGpuQuery* query, swQuerySource* source)
{
    bool isFloat = query->hostPoints != VK_NULL_HANDLE;
    *source = (swQuerySource){
        .count = (uint32_t)query->count,
        .pointWords = countPointWords(query),
        .isFloatPoint = isFloat ? 1 : 0,
    };
    if (!isFloat)
    {
        VkDeviceSize size = query->points.size / (VkDeviceSize)query->slotCount;
        return (swBinding){query->points.handle, .offset = size * (VkDeviceSize)query->pointSlot, .range = size};
    }
    VkDeviceSize aligned = query->hostOffset / SW_OFFSET_ALIGNMENT * SW_OFFSET_ALIGNMENT;
    VkDeviceSize skipped = query->hostOffset - aligned;
    source->firstWord = (uint32_t)(skipped / 4);
    return (swBinding){
        .buffer = query->hostPoints,
        .offset = aligned,
        .range = skipped + (VkDeviceSize)query->count * source->pointWords * 4,
    };
}

swBinding swBindPlane(const swGpuQuery* query, VkDeviceSize offset)
{
    return (swBinding){.buffer = query->answers.handle, .offset = offset};
}

void swDispatchPoints(swGpu* gpu, VkCommandBuffer commands, const swGpuQuery* query, uint32_t points)
{
    uint32_t groups = ((uint32_t)query->count + points - 1) / points;
    uint32_t columns = groups < SW_MOST_GROUPS ? groups : SW_MOST_GROUPS;
    gpu->vk.CmdDispatch(commands, columns, (groups + columns - 1) / columns, 1);
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
