// SPDX-License-Identifier: MIT
#include "gpu/pass/query_passes.h"

bool swHasQuery(const swGpuWorld* gpuWorld, swGpuQueryKind kind)
{
    const swGpuQuery* query = gpuWorld->firstQuery;
    while (query != NULL && (query->count == 0 || query->def.kind != kind))
    {
        query = query->next;
    }
    return query != NULL;
}

// What offsets of storage buffers are rounded down to: the most that a device may ask for.
#define SW_OFFSET_ALIGNMENT 256u

// Workgroups along an axis that every device can have.
#define SW_MOST_GROUPS 65535u

// Of the host's floats: places, places with a height, or rays; of ours otherwise.
static uint32_t countPointWords(const swGpuQuery* query)
{
    bool isFloat = query->hostPoints != VK_NULL_HANDLE;
    switch (query->def.kind)
    {
    case SW_GPU_QUERY_KIND_RAYS:
        return isFloat ? 8 : sizeof(swQueryRay) / 4;
    case SW_GPU_QUERY_KIND_VOLUME:
        return isFloat ? 3 : sizeof(swQueryPoint) / 4;
    case SW_GPU_QUERY_KIND_SURFACE:
        break;
    }
    return isFloat ? 2 : sizeof(swQueryPoint) / 4;
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
    // The rest of a large buffer may be more than a device binds at once; no plane is larger than one of four floats.
    VkDeviceSize most = (VkDeviceSize)query->def.capacity * sizeof(swVec4);
    VkDeviceSize rest = query->answers.size - offset;
    return (swBinding){.buffer = query->answers.handle, .offset = offset, .range = rest < most ? rest : most};
}

void swDispatchPoints(swGpu* gpu, VkCommandBuffer commands, const swGpuQuery* query, uint32_t points)
{
    uint32_t groups = ((uint32_t)query->count + points - 1) / points;
    uint32_t columns = groups < SW_MOST_GROUPS ? groups : SW_MOST_GROUPS;
    gpu->vk.CmdDispatch(commands, columns, (groups + columns - 1) / columns, 1);
}
