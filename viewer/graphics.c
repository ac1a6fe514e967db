// SPDX-License-Identifier: MIT
#include "graphics.h"

#include <stdio.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

const ImageUse USE_DISCARD = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE};
const ImageUse USE_COLOR_TARGET = {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                   VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                   VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
const ImageUse USE_DEPTH_TARGET = {
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
const ImageUse USE_SAMPLED = {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                              VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
const ImageUse USE_COPY_FROM = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                VK_ACCESS_2_TRANSFER_READ_BIT};
const ImageUse USE_COPY_TO = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                              VK_ACCESS_2_TRANSFER_WRITE_BIT};
const ImageUse USE_PRESENT = {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE};

static bool LoadTable(Graphics* graphics)
{
    VulkanTable* vk = &graphics->vk;
    bool isComplete = true;
#define VK_INSTANCE_FUNCTION(name)                                                                                     \
    vk->name = (PFN_vk##name)glfwGetInstanceProcAddress(graphics->instance, "vk" #name);                               \
    isComplete = isComplete && vk->name != NULL;
#define VK_DEVICE_FUNCTION(name)                                                                                       \
    vk->name = isComplete ? (PFN_vk##name)vk->GetDeviceProcAddr(graphics->device, "vk" #name) : NULL;                  \
    isComplete = isComplete && vk->name != NULL;
#include "vk_functions.inl"
#undef VK_INSTANCE_FUNCTION
#undef VK_DEVICE_FUNCTION
    return isComplete;
}

bool OpenGraphics(Graphics* graphics, const swGpu* gpu)
{
    graphics->instance = swGpu_GetInstance(gpu);
    graphics->physicalDevice = swGpu_GetPhysicalDevice(gpu);
    graphics->device = swGpu_GetDevice(gpu);
    graphics->queue = swGpu_GetQueue(gpu);
    graphics->queueFamily = swGpu_GetQueueFamily(gpu);
    if (!LoadTable(graphics))
    {
        fprintf(stderr, "seaway: %s lacks a Vulkan 1.3 or swapchain function that the viewer needs\n",
                swGpu_GetDeviceName(gpu));
        return false;
    }
    graphics->vk.GetPhysicalDeviceMemoryProperties(graphics->physicalDevice, &graphics->memory);
    return true;
}

static const char* GetResultText(VkResult result)
{
    switch (result)
    {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_DEVICE_LOST:
        return "the device was lost";
    case VK_ERROR_SURFACE_LOST_KHR:
        return "the window's surface was lost";
    case VK_ERROR_NATIVE_WINDOW_IN_USE_KHR:
        return "the window is in use by another program";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialization failed";
    default:
        return "an error of Vulkan";
    }
}

bool CheckVulkan(VkResult result, const char* what)
{
    if (result >= 0)
    {
        return true;
    }
    fprintf(stderr, "seaway: the viewer could not %s: %s (VkResult %d)\n", what, GetResultText(result), (int)result);
    return false;
}

// The first allowed type with the wanted properties, or any allowed one.
static uint32_t FindMemoryType(const Graphics* graphics, uint32_t allowed, VkMemoryPropertyFlags wanted)
{
    uint32_t fallback = 0;
    for (uint32_t i = graphics->memory.memoryTypeCount; i-- > 0;)
    {
        fallback = (allowed & (1u << i)) ? i : fallback;
    }
    for (uint32_t i = 0; i < graphics->memory.memoryTypeCount; i++)
    {
        bool isAllowed = (allowed & (1u << i)) != 0;
        if (isAllowed && (graphics->memory.memoryTypes[i].propertyFlags & wanted) == wanted)
        {
            return i;
        }
    }
    return fallback;
}

static VkResult AllocateMemory(const Graphics* graphics, const VkMemoryRequirements* needs,
                               VkMemoryPropertyFlags wanted, VkDeviceMemory* memory)
{
    VkMemoryAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
        .allocationSize = needs->size,
        .memoryTypeIndex = FindMemoryType(graphics, needs->memoryTypeBits, wanted),
    };
    return graphics->vk.AllocateMemory(graphics->device, &info, NULL, memory);
}

static VkResult CreateView(const Graphics* graphics, const Image* image, VkFormat format, VkImageView* view)
{
    VkImageViewCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = image->image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = format,
        .subresourceRange = {image->aspect, 0, 1, 0, 1},
    };
    return graphics->vk.CreateImageView(graphics->device, &info, NULL, view);
}

static VkResult CreateBareImage(const Graphics* graphics, const ImageDef* def, VkImage* image)
{
    VkFormat formats[2] = {def->format, def->otherFormat};
    VkImageFormatListCreateInfo list = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO,
        .viewFormatCount = 2,
        .pViewFormats = formats,
    };
    bool isMutable = def->otherFormat != VK_FORMAT_UNDEFINED;
    VkImageCreateInfo info = {
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
    return graphics->vk.CreateImage(graphics->device, &info, NULL, image);
}

bool CreateImage(const Graphics* graphics, const ImageDef* def, Image* image)
{
    *image = (Image){.aspect = def->aspect, .width = def->width, .height = def->height};
    VkResult result = CreateBareImage(graphics, def, &image->image);
    if (result == VK_SUCCESS)
    {
        VkMemoryRequirements needs;
        graphics->vk.GetImageMemoryRequirements(graphics->device, image->image, &needs);
        result = AllocateMemory(graphics, &needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &image->memory);
    }
    if (result == VK_SUCCESS)
    {
        result = graphics->vk.BindImageMemory(graphics->device, image->image, image->memory, 0);
    }
    if (result == VK_SUCCESS)
    {
        result = CreateView(graphics, image, def->format, &image->view);
    }
    if (result == VK_SUCCESS && def->otherFormat != VK_FORMAT_UNDEFINED)
    {
        result = CreateView(graphics, image, def->otherFormat, &image->otherView);
    }
    if (!CheckVulkan(result, "make an image"))
    {
        DestroyImage(graphics, image);
        return false;
    }
    return true;
}

void DestroyImage(const Graphics* graphics, Image* image)
{
    graphics->vk.DestroyImageView(graphics->device, image->otherView, NULL);
    graphics->vk.DestroyImageView(graphics->device, image->view, NULL);
    graphics->vk.DestroyImage(graphics->device, image->image, NULL);
    graphics->vk.FreeMemory(graphics->device, image->memory, NULL);
    *image = (Image){0};
}

bool CreateBuffer(const Graphics* graphics, VkDeviceSize size, VkBufferUsageFlags usage, Buffer* buffer)
{
    *buffer = (Buffer){.size = size};
    VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    VkResult result = graphics->vk.CreateBuffer(graphics->device, &info, NULL, &buffer->buffer);
    if (result == VK_SUCCESS)
    {
        VkMemoryRequirements needs;
        graphics->vk.GetBufferMemoryRequirements(graphics->device, buffer->buffer, &needs);
        result =
            AllocateMemory(graphics, &needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                           &buffer->memory);
    }
    if (result == VK_SUCCESS)
    {
        result = graphics->vk.BindBufferMemory(graphics->device, buffer->buffer, buffer->memory, 0);
    }
    if (result == VK_SUCCESS)
    {
        result = graphics->vk.MapMemory(graphics->device, buffer->memory, 0, VK_WHOLE_SIZE, 0, &buffer->data);
    }
    if (!CheckVulkan(result, "make a buffer"))
    {
        DestroyBuffer(graphics, buffer);
        return false;
    }
    return true;
}

void DestroyBuffer(const Graphics* graphics, Buffer* buffer)
{
    graphics->vk.DestroyBuffer(graphics->device, buffer->buffer, NULL);
    graphics->vk.FreeMemory(graphics->device, buffer->memory, NULL);
    *buffer = (Buffer){0};
}

void UseImage(const Graphics* graphics, VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect,
              ImageUse before, ImageUse after)
{
    VkImageMemoryBarrier2 barrier = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = before.stage,
        .srcAccessMask = before.access,
        .dstStageMask = after.stage,
        .dstAccessMask = after.access,
        .oldLayout = before.layout,
        .newLayout = after.layout,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image,
        .subresourceRange = {aspect, 0, 1, 0, 1},
    };
    VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
        .imageMemoryBarrierCount = 1,
        .pImageMemoryBarriers = &barrier,
    };
    graphics->vk.CmdPipelineBarrier2(commands, &dependency);
}
