// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_image.h"

#include "gpu/vk/vk_device.h"

static VkImageAspectFlags aspectOf(VkFormat format)
{
    switch (format)
    {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
        return VK_IMAGE_ASPECT_DEPTH_BIT;
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
        return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    default:
        return VK_IMAGE_ASPECT_COLOR_BIT;
    }
}

static VkResult createView(swGpu* gpu, const swImage* image, bool isArray, uint32_t firstMip, uint32_t mipCount,
                           VkImageView* view)
{
    const VkImageViewCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = image->handle,
        .viewType = image->depth > 1 ? VK_IMAGE_VIEW_TYPE_3D
                    : isArray        ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                     : VK_IMAGE_VIEW_TYPE_2D,
        .format = image->format,
        .subresourceRange = {.aspectMask = aspectOf(image->format),
                             .baseMipLevel = firstMip,
                             .levelCount = mipCount,
                             .layerCount = image->layers},
    };
    return gpu->vk.CreateImageView(gpu->device, &info, NULL, view);
}

static VkResult createViews(swGpu* gpu, bool isArray, swImage* image)
{
    VkResult result = createView(gpu, image, isArray, 0, image->mips, &image->view);
    for (uint32_t mip = 0; mip < image->mips && image->mips > 1 && result == VK_SUCCESS; ++mip)
    {
        result = createView(gpu, image, isArray, mip, 1, &image->mipViews[mip]);
    }
    return result;
}

swResult swCreateImage(swGpu* gpu, const swImageDef* def, swImage* image)
{
    *image = (swImage){
        .format = def->format,
        .layout = def->layout,
        .width = def->width,
        .height = def->height,
        .depth = def->depth > 0 ? def->depth : 1,
        .layers = def->layers > 0 ? def->layers : 1,
        .mips = def->mips > 0 ? def->mips : 1,
    };
    const VkImageCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .imageType = image->depth > 1 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
        .format = def->format,
        .extent = {image->width, image->height, image->depth},
        .mipLevels = image->mips,
        .arrayLayers = image->layers,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .tiling = VK_IMAGE_TILING_OPTIMAL,
        .usage = def->usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
        .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED,
    };
    VkResult created = gpu->vk.CreateImage(gpu->device, &info, NULL, &image->handle);
    if (created != VK_SUCCESS)
    {
        *image = (swImage){0};
        return swCheckVk(gpu, created, def->name);
    }
    VkMemoryRequirements needs;
    gpu->vk.GetImageMemoryRequirements(gpu->device, image->handle, &needs);
    swResult result = swAllocateDeviceMemory(gpu, &needs, SW_MEMORY_DEVICE, true, def->name, &image->memory);
    if (result == SW_SUCCESS)
    {
        created = gpu->vk.BindImageMemory(gpu->device, image->handle, image->memory.memory, image->memory.offset);
        created = created == VK_SUCCESS ? createViews(gpu, def->isArray || image->layers > 1, image) : created;
        result = swCheckVk(gpu, created, def->name);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyImage(gpu, image);
        return result;
    }
    swNameObject(gpu, VK_OBJECT_TYPE_IMAGE, (uint64_t)image->handle, def->name);
    return SW_SUCCESS;
}

void swDestroyImage(swGpu* gpu, swImage* image)
{
    gpu->vk.DestroyImageView(gpu->device, image->view, NULL);
    for (int mip = 0; mip < SW_MAX_MIPS; ++mip)
    {
        gpu->vk.DestroyImageView(gpu->device, image->mipViews[mip], NULL);
    }
    gpu->vk.DestroyImage(gpu->device, image->handle, NULL);
    swFreeDeviceMemory(gpu, &image->memory);
    *image = (swImage){0};
}

void swRetireImage(swGpu* gpu, swImage* image)
{
    if (image->handle != VK_NULL_HANDLE)
    {
        swRetired retired = {.image = image->handle, .memory = image->memory};
        for (int mip = 0; mip < SW_MAX_MIPS; ++mip)
        {
            retired.views[mip] = image->mipViews[mip];
        }
        retired.views[SW_MAX_MIPS] = image->view;
        swRetire(gpu, &retired);
    }
    *image = (swImage){0};
}

void swInitializeImage(swGpu* gpu, VkCommandBuffer commands, swImage* image)
{
    if (image->isInitialized)
    {
        return;
    }
    const VkPipelineStageFlags2 all = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    swImageBarrier(gpu, commands, image, VK_IMAGE_LAYOUT_UNDEFINED, image->layout, all, 0, all,
                   VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
    image->isInitialized = true;
}
