// SPDX-License-Identifier: MIT
// The devices of this machine, asked of an instance that lives as long as the question.

#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include "stage/stage_base.h"

#define SW_STAGE_MAX_DEVICES 64

typedef struct swDeviceLister
{
    PFN_vkGetInstanceProcAddr find;
    VkInstance instance;
    PFN_vkDestroyInstance DestroyInstance;
    PFN_vkEnumeratePhysicalDevices EnumeratePhysicalDevices;
    PFN_vkGetPhysicalDeviceProperties GetPhysicalDeviceProperties;
} swDeviceLister;

// The loader's entry point, or NULL. The library stays open until the program ends.
static PFN_vkGetInstanceProcAddr findLoader(void)
{
#ifdef _WIN32
    HMODULE library = LoadLibraryA("vulkan-1.dll");
    return library != NULL ? (PFN_vkGetInstanceProcAddr)GetProcAddress(library, "vkGetInstanceProcAddr") : NULL;
#else
    void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    library = library != NULL ? library : dlopen("libvulkan.1.dylib", RTLD_NOW | RTLD_LOCAL);
    void* symbol = library != NULL ? dlsym(library, "vkGetInstanceProcAddr") : NULL;
    PFN_vkGetInstanceProcAddr function = NULL;
    memcpy(&function, &symbol, sizeof(function)); // ISO C has no cast from an object pointer to a function's
    return function;
#endif
}

static swResult openLister(const swHost* host, swDeviceLister* lister)
{
    lister->find = findLoader();
    if (lister->find == NULL)
    {
        return swFail(host, SW_ERROR_NO_DEVICE,
                      "this machine has no Vulkan loader (libvulkan.so.1); Debian's package libvulkan1 has it");
    }
    PFN_vkCreateInstance create = (PFN_vkCreateInstance)lister->find(NULL, "vkCreateInstance");
    VkApplicationInfo application = {
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "seaway", .apiVersion = VK_API_VERSION_1_3};
    VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    if (create == NULL || create(&info, NULL, &lister->instance) != VK_SUCCESS)
    {
        return swFail(host, SW_ERROR_NO_DEVICE,
                      "no Vulkan driver is installed; Debian's package mesa-vulkan-drivers has a software one");
    }
    lister->DestroyInstance = (PFN_vkDestroyInstance)lister->find(lister->instance, "vkDestroyInstance");
    lister->EnumeratePhysicalDevices =
        (PFN_vkEnumeratePhysicalDevices)lister->find(lister->instance, "vkEnumeratePhysicalDevices");
    lister->GetPhysicalDeviceProperties =
        (PFN_vkGetPhysicalDeviceProperties)lister->find(lister->instance, "vkGetPhysicalDeviceProperties");
    if (lister->DestroyInstance == NULL || lister->EnumeratePhysicalDevices == NULL ||
        lister->GetPhysicalDeviceProperties == NULL)
    {
        return swFail(host, SW_ERROR_NO_DEVICE, "the Vulkan loader lacks a function of Vulkan 1.0");
    }
    return SW_SUCCESS;
}

static const char* getTypeName(VkPhysicalDeviceType type)
{
    switch (type)
    {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "software";
    default:
        return "other";
    }
}

static void describeDevice(const swDeviceLister* lister, VkPhysicalDevice physicalDevice, swStageDevice* device)
{
    VkPhysicalDeviceProperties properties;
    lister->GetPhysicalDeviceProperties(physicalDevice, &properties);
    *device = (swStageDevice){.type = getTypeName(properties.deviceType), .version = properties.apiVersion};
    snprintf(device->name, sizeof(device->name), "%s", properties.deviceName);
    device->isUsable =
        swGpu_CheckDevice(lister->find, lister->instance, physicalDevice, device->missing, sizeof(device->missing));
}

swResult swListStageDevices(const swHost* host, int capacity, swStageDevice* devices, int* count)
{
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host,
               "swListStageDevices() needs a host made by swDefaultHost()");
    SW_REQUIRE(capacity >= 0 && devices != NULL && count != NULL, SW_ERROR_INVALID, host,
               "swListStageDevices() needs room for devices and a place for their number");
    *count = 0;
    swDeviceLister lister = {0};
    swResult result = openLister(host, &lister);
    if (result == SW_SUCCESS)
    {
        uint32_t found = SW_STAGE_MAX_DEVICES;
        VkPhysicalDevice physicalDevices[SW_STAGE_MAX_DEVICES];
        VkResult listed = lister.EnumeratePhysicalDevices(lister.instance, &found, physicalDevices);
        *count = listed == VK_SUCCESS || listed == VK_INCOMPLETE ? (int)found : 0;
        for (int i = 0; i < *count && i < capacity; ++i)
        {
            describeDevice(&lister, physicalDevices[i], &devices[i]);
        }
    }
    if (lister.DestroyInstance != NULL)
    {
        lister.DestroyInstance(lister.instance, NULL);
    }
    return result;
}
