// SPDX-License-Identifier: MIT
// What a device must have: Vulkan 1.3, a handful of features that every such device of note has, and push descriptors.
// Everything is in one place, so that the check, the device that we create and what we tell a host that creates its own
// can never disagree.

#include <stdio.h>
#include <string.h>

#include "gpu/vk/vk_device.h"

const char* const swDeviceExtensions[SW_DEVICE_EXTENSION_COUNT] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};

// SW_FEATURE(member of swGpuFeatures, feature): all required.
#define SW_FEATURES(SW_FEATURE)                                                                                        \
    SW_FEATURE(features.features, drawIndirectFirstInstance)                                                           \
    SW_FEATURE(features.features, samplerAnisotropy)                                                                   \
    SW_FEATURE(features12, timelineSemaphore)                                                                          \
    SW_FEATURE(features13, dynamicRendering)                                                                           \
    SW_FEATURE(features13, synchronization2)                                                                           \
    SW_FEATURE(features13, maintenance4)                                                                               \
    SW_FEATURE(features13, shaderTerminateInvocation)                                                                  \
    SW_FEATURE(features13, shaderDemoteToHelperInvocation)

static void chainFeatures(swGpuFeatures* storage)
{
    *storage = (swGpuFeatures){0};
    storage->features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    storage->features11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    storage->features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    storage->features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    storage->features.pNext = &storage->features11;
    storage->features11.pNext = &storage->features12;
    storage->features12.pNext = &storage->features13;
}

void swFillDeviceFeatures(swGpuFeatures* storage)
{
    chainFeatures(storage);
#define SW_FEATURE(block, feature) storage->block.feature = VK_TRUE;
    SW_FEATURES(SW_FEATURE)
#undef SW_FEATURE
}

// The list of what is missing, "a, b, c", cut off where the buffer ends.
typedef struct MissingList
{
    char* text;
    size_t size;
    bool isEmpty;
} MissingList;

static void addMissing(MissingList* list, const char* name)
{
    if (list->text != NULL && list->size > 0)
    {
        size_t used = list->isEmpty ? 0 : strlen(list->text);
        snprintf(list->text + used, list->size - used, "%s%s", list->isEmpty ? "" : ", ", name);
    }
    list->isEmpty = false;
}

#define SW_LOAD(name) PFN_vk##name name = (PFN_vk##name)getInstanceProcAddr(instance, "vk" #name)

static void checkExtensions(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                            MissingList* missing)
{
    SW_LOAD(EnumerateDeviceExtensionProperties);
    enum
    {
        MAX_EXTENSIONS = 512
    };
    VkExtensionProperties extensions[MAX_EXTENSIONS]; // 130 KiB; devices list about 250
    uint32_t count = MAX_EXTENSIONS;
    EnumerateDeviceExtensionProperties(device, NULL, &count, extensions);
    for (int wanted = 0; wanted < SW_DEVICE_EXTENSION_COUNT; ++wanted)
    {
        bool isFound = false;
        for (uint32_t i = 0; i < count && !isFound; ++i)
        {
            isFound = strcmp(extensions[i].extensionName, swDeviceExtensions[wanted]) == 0;
        }
        if (!isFound)
        {
            addMissing(missing, swDeviceExtensions[wanted]);
        }
    }
}

static void checkFormats(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                         MissingList* missing)
{
    SW_LOAD(GetPhysicalDeviceFormatProperties);
    const struct
    {
        VkFormat format;
        VkFormatFeatureFlags features;
        const char* text;
    } needs[] = {
        {VK_FORMAT_R32_SFLOAT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT,
         "storage images of R32_SFLOAT"},
        {VK_FORMAT_R16G16B16A16_SFLOAT,
         VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT,
         "storage images of R16G16B16A16_SFLOAT"},
        {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT,
         "storage images of R32G32B32A32_SFLOAT"},
    };
    for (size_t i = 0; i < sizeof(needs) / sizeof(needs[0]); ++i)
    {
        VkFormatProperties properties;
        GetPhysicalDeviceFormatProperties(device, needs[i].format, &properties);
        if ((properties.optimalTilingFeatures & needs[i].features) != needs[i].features)
        {
            addMissing(missing, needs[i].text);
        }
    }
}

static void checkQueues(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                        MissingList* missing)
{
    SW_LOAD(GetPhysicalDeviceQueueFamilyProperties);
    VkQueueFamilyProperties families[32];
    uint32_t count = 32;
    GetPhysicalDeviceQueueFamilyProperties(device, &count, families);
    const VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i)
    {
        if ((families[i].queueFlags & both) == both)
        {
            return;
        }
    }
    addMissing(missing, "a queue family with graphics and compute");
}

bool swCheckDeviceFeatures(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                           char* missing, size_t size)
{
    SW_LOAD(GetPhysicalDeviceProperties);
    SW_LOAD(GetPhysicalDeviceFeatures2);
    MissingList list = {.text = missing, .size = size, .isEmpty = true};
    if (missing != NULL && size > 0)
    {
        missing[0] = '\0';
    }
    VkPhysicalDeviceProperties properties;
    GetPhysicalDeviceProperties(device, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_3)
    {
        addMissing(&list, "Vulkan 1.3"); // the feature structs below do not exist there
        return false;
    }
    swGpuFeatures have;
    chainFeatures(&have);
    GetPhysicalDeviceFeatures2(device, &have.features);
#define SW_FEATURE(block, feature)                                                                                     \
    if (!have.block.feature)                                                                                           \
    {                                                                                                                  \
        addMissing(&list, #feature);                                                                                   \
    }
    SW_FEATURES(SW_FEATURE)
#undef SW_FEATURE
    if (properties.limits.maxComputeSharedMemorySize < 32768)
    {
        addMissing(&list, "32 KiB of shared memory");
    }
    if (properties.limits.maxComputeWorkGroupInvocations < 768 || properties.limits.maxComputeWorkGroupSize[0] < 768)
    {
        addMissing(&list, "workgroups of 768");
    }
    checkExtensions(getInstanceProcAddr, instance, device, &list);
    checkFormats(getInstanceProcAddr, instance, device, &list);
    checkQueues(getInstanceProcAddr, instance, device, &list);
    return list.isEmpty;
}

bool swFiltersFloats(const swGpu* gpu)
{
    VkFormatProperties properties;
    gpu->vk.GetPhysicalDeviceFormatProperties(gpu->physicalDevice, VK_FORMAT_R32_SFLOAT, &properties);
    return (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
}
