// SPDX-License-Identifier: MIT
#include "vulkan_calls.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

#include "common.h"

PFN_vkGetInstanceProcAddr FindVulkanLoader(void)
{
    void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    void* symbol = library != NULL ? dlsym(library, "vkGetInstanceProcAddr") : NULL;
    PFN_vkGetInstanceProcAddr function = NULL;
    memcpy(&function, &symbol, sizeof(function)); // ISO C has no cast from an object pointer to a function's
    return function;
}

static bool Check(PFN_vkVoidFunction function, const char* name)
{
    if (function == NULL)
    {
        Complain("the Vulkan driver has no vk%s", name);
    }
    return function != NULL;
}

bool LoadInstanceCalls(VulkanCalls* calls, VkInstance instance)
{
    PFN_vkGetInstanceProcAddr find = FindVulkanLoader();
    if (find == NULL)
    {
        Complain("this machine has no Vulkan loader (libvulkan.so.1)");
        return false;
    }
    bool isComplete = true;
#define SW_INSTANCE_CALL(name)                                                                                         \
    calls->name = (PFN_vk##name)find(instance, "vk" #name);                                                            \
    isComplete = isComplete && Check((PFN_vkVoidFunction)calls->name, #name);
#define SW_DEVICE_CALL(name)
#include "vulkan_calls.inl"
#undef SW_INSTANCE_CALL
#undef SW_DEVICE_CALL
    return isComplete;
}

bool LoadDeviceCalls(VulkanCalls* calls, VkDevice device)
{
    bool isComplete = true;
#define SW_INSTANCE_CALL(name)
#define SW_DEVICE_CALL(name)                                                                                           \
    calls->name = (PFN_vk##name)calls->GetDeviceProcAddr(device, "vk" #name);                                          \
    isComplete = isComplete && Check((PFN_vkVoidFunction)calls->name, #name);
#include "vulkan_calls.inl"
#undef SW_INSTANCE_CALL
#undef SW_DEVICE_CALL
    return isComplete;
}
