// SPDX-License-Identifier: MIT
// VkResult ends here: everything above the toolbox sees swResult and a sentence in the log.

#include "gpu/vk/vk_device.h"

const char* swVkResultName(VkResult result)
{
    switch (result)
    {
#define SW_CASE(name)                                                                                                  \
    case name:                                                                                                         \
        return #name;
        SW_CASE(VK_SUCCESS)
        SW_CASE(VK_NOT_READY)
        SW_CASE(VK_TIMEOUT)
        SW_CASE(VK_INCOMPLETE)
        SW_CASE(VK_ERROR_OUT_OF_HOST_MEMORY)
        SW_CASE(VK_ERROR_OUT_OF_DEVICE_MEMORY)
        SW_CASE(VK_ERROR_INITIALIZATION_FAILED)
        SW_CASE(VK_ERROR_DEVICE_LOST)
        SW_CASE(VK_ERROR_MEMORY_MAP_FAILED)
        SW_CASE(VK_ERROR_LAYER_NOT_PRESENT)
        SW_CASE(VK_ERROR_EXTENSION_NOT_PRESENT)
        SW_CASE(VK_ERROR_FEATURE_NOT_PRESENT)
        SW_CASE(VK_ERROR_INCOMPATIBLE_DRIVER)
        SW_CASE(VK_ERROR_TOO_MANY_OBJECTS)
        SW_CASE(VK_ERROR_FORMAT_NOT_SUPPORTED)
        SW_CASE(VK_ERROR_FRAGMENTED_POOL)
#undef SW_CASE
    default:
        return "an unnamed VkResult";
    }
}

swResult swCheckVk(const swGpu* gpu, VkResult result, const char* what)
{
    switch (result)
    {
    case VK_SUCCESS:
        return SW_SUCCESS;
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "%s: %s on %s", what, swVkResultName(result),
                      gpu->properties.deviceName);
    case VK_ERROR_DEVICE_LOST:
        return swFail(&gpu->host, SW_ERROR_DEVICE_LOST, "%s: the device %s was lost", what, gpu->properties.deviceName);
    default:
        return swFail(&gpu->host, SW_ERROR_DEVICE, "%s: %s (%d) on %s", what, swVkResultName(result), (int)result,
                      gpu->properties.deviceName);
    }
}
