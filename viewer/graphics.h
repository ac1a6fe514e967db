// SPDX-License-Identifier: MIT
#pragma once

// The device that the viewer draws with, and the few Vulkan objects that it makes for itself: images, buffers,
// barriers. Functions are looked up through GLFW's loader and kept in a table, so the program links no Vulkan library.

#include <stdbool.h>

#include "seaway/gpu.h"

typedef struct VulkanTable
{
#define VK_INSTANCE_FUNCTION(name) PFN_vk##name name;
#define VK_DEVICE_FUNCTION(name) PFN_vk##name name;
#include "vk_functions.inl"
#undef VK_INSTANCE_FUNCTION
#undef VK_DEVICE_FUNCTION
} VulkanTable;

typedef struct Graphics
{
    VulkanTable vk;
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    uint32_t queueFamily;
    VkPhysicalDeviceMemoryProperties memory;
} Graphics;

// Take over instance, device and queue of `gpu` and look all functions up.
bool OpenGraphics(Graphics* graphics, const swGpu* gpu);

// Whether a call succeeded; if not, a sentence says what the viewer was doing.
bool CheckVulkan(VkResult result, const char* what);

// A 2-D image with one view, or two where `otherFormat` reads the same bytes as another format.
typedef struct Image
{
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
    VkImageView otherView;
    VkImageAspectFlags aspect;
    uint32_t width, height;
} Image;

typedef struct ImageDef
{
    VkFormat format;
    VkFormat otherFormat; // VK_FORMAT_UNDEFINED: none
    VkImageUsageFlags usage;
    VkImageAspectFlags aspect;
    uint32_t width, height;
} ImageDef;

bool CreateImage(const Graphics* graphics, const ImageDef* def, Image* image);
void DestroyImage(const Graphics* graphics, Image* image);

// A buffer that stays mapped, in memory that host and device both see.
typedef struct Buffer
{
    VkBuffer buffer;
    VkDeviceMemory memory;
    void* data;
    VkDeviceSize size;
} Buffer;

bool CreateBuffer(const Graphics* graphics, VkDeviceSize size, VkBufferUsageFlags usage, Buffer* buffer);
void DestroyBuffer(const Graphics* graphics, Buffer* buffer);

// What an image was last used for, and what comes next.
typedef struct ImageUse
{
    VkImageLayout layout;
    VkPipelineStageFlags2 stage;
    VkAccessFlags2 access;
} ImageUse;

extern const ImageUse USE_DISCARD; // contents may be lost; waits for everything before
extern const ImageUse USE_COLOR_TARGET;
extern const ImageUse USE_DEPTH_TARGET;
extern const ImageUse USE_SAMPLED;
extern const ImageUse USE_COPY_FROM;
extern const ImageUse USE_COPY_TO;
extern const ImageUse USE_PRESENT;

void UseImage(const Graphics* graphics, VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect,
              ImageUse before, ImageUse after);
