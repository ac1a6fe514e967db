// SPDX-License-Identifier: MIT
// Images and buffers, each with memory of its own.

#include "stage/stage_base.h"

// The first type that has all properties and gives memory.
static VkResult tryMemory(const swStage* stage, const VkMemoryRequirements* needs, VkMemoryPropertyFlags wanted,
                          VkDeviceMemory* memory)
{
    VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
    for (uint32_t i = 0; i < stage->memory.memoryTypeCount; ++i)
    {
        bool fits =
            (needs->memoryTypeBits >> i & 1) != 0 && (stage->memory.memoryTypes[i].propertyFlags & wanted) == wanted;
        const VkMemoryAllocateInfo info = {
            .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs->size, .memoryTypeIndex = i};
        if (fits)
        {
            result = stage->vk.AllocateMemory(stage->device, &info, NULL, memory);
        }
        if (result == VK_SUCCESS)
        {
            return result;
        }
    }
    return result;
}

static swResult allocateMemory(const swStage* stage, const VkMemoryRequirements* needs, VkMemoryPropertyFlags wanted,
                               VkMemoryPropertyFlags preferred, const char* name, VkDeviceMemory* memory)
{
    VkResult result = tryMemory(stage, needs, wanted | preferred, memory);
    result = result == VK_SUCCESS ? result : tryMemory(stage, needs, wanted, memory);
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    {
        return swFail(&stage->host, SW_ERROR_NO_MEMORY,
                      "%s has no memory for %.0f MB of %s; a smaller picture needs less", stage->properties.deviceName,
                      1e-6 * (double)needs->size, name);
    }
    return swCheckStage(stage, result, "allocating device memory");
}

static swResult checkSize(const swStage* stage, const swStageImageDef* def)
{
    const VkPhysicalDeviceLimits* limits = &stage->properties.limits;
    uint32_t most = limits->maxFramebufferWidth < limits->maxImageDimension2D ? limits->maxFramebufferWidth
                                                                              : limits->maxImageDimension2D;
    most = limits->maxFramebufferHeight < most ? limits->maxFramebufferHeight : most;
    if (def->width > most || def->height > most)
    {
        return swFail(&stage->host, SW_ERROR_UNSUPPORTED, "%u x %u pixels are more than the %u a side that %s can draw",
                      def->width, def->height, most, stage->properties.deviceName);
    }
    return SW_SUCCESS;
}

// A driver may take a format that it cannot do, and draw anything.
static swResult checkFormat(const swStage* stage, const swStageImageDef* def, VkFormat format)
{
    VkImageFormatProperties properties;
    VkResult result = stage->vk.GetPhysicalDeviceImageFormatProperties(
        stage->physicalDevice, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, def->usage, 0, &properties);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED)
    {
        return swFail(&stage->host, SW_ERROR_UNSUPPORTED, "%s cannot use images of VkFormat %d for %s",
                      stage->properties.deviceName, (int)format, def->name);
    }
    return swCheckStage(stage, result, "asking for an image's format");
}

// 0 for formats that the stage does not know.
static uint32_t findTexelBytes(VkFormat format)
{
    switch (format)
    {
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_SRGB:
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_R32_SFLOAT:
        return 4;
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
        return 16;
    default:
        return 0;
    }
}

static VkResult createBareImage(const swStage* stage, const swStageImageDef* def, VkImage* image)
{
    const VkFormat formats[2] = {def->format, def->otherFormat};
    const VkImageFormatListCreateInfo list = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO,
        .viewFormatCount = 2,
        .pViewFormats = formats,
    };
    bool isMutable = def->otherFormat != VK_FORMAT_UNDEFINED;
    const VkImageCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .pNext = isMutable ? &list : NULL,
        .flags = isMutable ? VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT : 0,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = def->format,
        .extent = {def->width, def->height, 1},
        .mipLevels = 1,
        .arrayLayers = 1,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .usage = def->usage,
    };
    return stage->vk.CreateImage(stage->device, &info, NULL, image);
}

static VkResult createView(const swStage* stage, const swStageImage* image, VkFormat format, VkImageView* view)
{
    const VkImageViewCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = image->image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = format,
        .subresourceRange = {image->aspect, 0, 1, 0, 1},
    };
    return stage->vk.CreateImageView(stage->device, &info, NULL, view);
}

static swResult fillImage(const swStage* stage, const swStageImageDef* def, swStageImage* image)
{
    VkResult made = createBareImage(stage, def, &image->image);
    if (made != VK_SUCCESS)
    {
        return swCheckStage(stage, made, "making an image");
    }
    VkMemoryRequirements needs;
    stage->vk.GetImageMemoryRequirements(stage->device, image->image, &needs);
    swResult result = allocateMemory(stage, &needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, def->name, &image->memory);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    made = stage->vk.BindImageMemory(stage->device, image->image, image->memory, 0);
    made = made != VK_SUCCESS ? made : createView(stage, image, def->format, &image->view);
    if (made == VK_SUCCESS && def->otherFormat != VK_FORMAT_UNDEFINED)
    {
        made = createView(stage, image, def->otherFormat, &image->otherView);
    }
    return swCheckStage(stage, made, "making an image's view");
}

swResult swStage_CreateImage(swStage* stage, const swStageImageDef* def, swStageImage* image)
{
    if (image != NULL)
    {
        *image = (swStageImage){0};
    }
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_CreateImage() needs a stage");
    SW_REQUIRE(def != NULL && image != NULL && def->name != NULL && def->width > 0 && def->height > 0 &&
                   def->format != VK_FORMAT_UNDEFINED && def->usage != 0,
               SW_ERROR_INVALID, &stage->host,
               "swStage_CreateImage() needs a def with a name, a size, a format and a usage, and a place");
    bool isDepth = (def->usage & VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
    *image = (swStageImage){.aspect = isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT,
                            .width = def->width,
                            .height = def->height,
                            .texelBytes = findTexelBytes(def->format)};
    swResult result = checkSize(stage, def);
    result = result == SW_SUCCESS ? checkFormat(stage, def, def->format) : result;
    result = result == SW_SUCCESS && def->otherFormat != VK_FORMAT_UNDEFINED ? checkFormat(stage, def, def->otherFormat)
                                                                             : result;
    result = result == SW_SUCCESS ? fillImage(stage, def, image) : result;
    if (result != SW_SUCCESS)
    {
        swStage_DestroyImage(stage, image);
    }
    return result;
}

void swStage_DestroyImage(swStage* stage, swStageImage* image)
{
    SW_REQUIRE_VOID(stage != NULL && image != NULL, stage != NULL ? &stage->host : NULL,
                    "swStage_DestroyImage() needs a stage and an image");
    stage->vk.DestroyImageView(stage->device, image->otherView, NULL);
    stage->vk.DestroyImageView(stage->device, image->view, NULL);
    stage->vk.DestroyImage(stage->device, image->image, NULL);
    stage->vk.FreeMemory(stage->device, image->memory, NULL);
    *image = (swStageImage){0};
}

static swResult fillBuffer(const swStage* stage, VkBufferUsageFlags usage, swStageBuffer* buffer)
{
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = buffer->size, .usage = usage};
    VkResult made = stage->vk.CreateBuffer(stage->device, &info, NULL, &buffer->buffer);
    if (made != VK_SUCCESS)
    {
        return swCheckStage(stage, made, "making a buffer");
    }
    VkMemoryRequirements needs;
    stage->vk.GetBufferMemoryRequirements(stage->device, buffer->buffer, &needs);
    // Uncached memory is read by the processor at a hundredth of the speed.
    bool isRead = (usage & VK_BUFFER_USAGE_TRANSFER_DST_BIT) != 0;
    swResult result =
        allocateMemory(stage, &needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                       isRead ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : 0, "a buffer", &buffer->memory);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    made = stage->vk.BindBufferMemory(stage->device, buffer->buffer, buffer->memory, 0);
    made = made != VK_SUCCESS ? made
                              : stage->vk.MapMemory(stage->device, buffer->memory, 0, VK_WHOLE_SIZE, 0, &buffer->data);
    return swCheckStage(stage, made, "mapping a buffer");
}

swResult swStage_CreateBuffer(swStage* stage, VkDeviceSize size, VkBufferUsageFlags usage, swStageBuffer* buffer)
{
    if (buffer != NULL)
    {
        *buffer = (swStageBuffer){0};
    }
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_CreateBuffer() needs a stage");
    SW_REQUIRE(size > 0 && usage != 0 && buffer != NULL, SW_ERROR_INVALID, &stage->host,
               "swStage_CreateBuffer() needs a size, a usage and a place for the buffer");
    *buffer = (swStageBuffer){.size = size};
    swResult result = fillBuffer(stage, usage, buffer);
    if (result != SW_SUCCESS)
    {
        swStage_DestroyBuffer(stage, buffer);
    }
    return result;
}

void swStage_DestroyBuffer(swStage* stage, swStageBuffer* buffer)
{
    SW_REQUIRE_VOID(stage != NULL && buffer != NULL, stage != NULL ? &stage->host : NULL,
                    "swStage_DestroyBuffer() needs a stage and a buffer");
    stage->vk.DestroyBuffer(stage->device, buffer->buffer, NULL);
    stage->vk.FreeMemory(stage->device, buffer->memory, NULL);
    *buffer = (swStageBuffer){0};
}
