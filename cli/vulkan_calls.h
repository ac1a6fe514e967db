// SPDX-License-Identifier: MIT
#pragma once

// The Vulkan functions of one instance and device. The loader is opened at run time, so that the program starts where
// no Vulkan is installed.

#include <stdbool.h>
#include <vulkan/vulkan_core.h>

typedef struct VulkanCalls
{
#define SW_INSTANCE_CALL(name) PFN_vk##name name;
#define SW_DEVICE_CALL(name) PFN_vk##name name;
#include "vulkan_calls.inl"
#undef SW_INSTANCE_CALL
#undef SW_DEVICE_CALL
} VulkanCalls;

// The loader's entry point, or NULL if this machine has no Vulkan loader. Stays open until the program ends.
PFN_vkGetInstanceProcAddr FindVulkanLoader(void);

// Both complain and return false if a function is missing.
bool LoadInstanceCalls(VulkanCalls* calls, VkInstance instance);
bool LoadDeviceCalls(VulkanCalls* calls, VkDevice device); // after the instance's
