// SPDX-License-Identifier: MIT
#include <stdlib.h>
#include <string.h>

#include "stage/stage_base.h"

swResult swCheckStage(const swStage* stage, VkResult result, const char* what)
{
    const char* device = stage->properties.deviceName;
    switch (result)
    {
    case VK_SUCCESS:
        return SW_SUCCESS;
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return swFail(&stage->host, SW_ERROR_NO_MEMORY, "%s: %s has no memory for it (VkResult %d)", what, device,
                      (int)result);
    case VK_ERROR_DEVICE_LOST:
        return swFail(&stage->host, SW_ERROR_DEVICE_LOST, "%s: the device %s was lost", what, device);
    default:
        return swFail(&stage->host, SW_ERROR_DEVICE, "%s: %s answers with VkResult %d", what, device, (int)result);
    }
}

// The first function that is missing, or NULL.
static const char* loadFunctions(swStage* stage, bool isPresentable)
{
    PFN_vkGetInstanceProcAddr find = swGpu_GetInstanceProcAddr(stage->gpu);
    VkInstance instance = swGpu_GetInstance(stage->gpu);
    swStageVk* vk = &stage->vk;
    const char* missing = NULL;
#define SW_STAGE_INSTANCE(name)                                                                                        \
    vk->name = (PFN_vk##name)find(instance, "vk" #name);                                                               \
    missing = missing == NULL && vk->name == NULL ? "vk" #name : missing;
#define SW_STAGE_DEVICE(name)                                                                                          \
    vk->name = missing == NULL ? (PFN_vk##name)vk->GetDeviceProcAddr(stage->device, "vk" #name) : NULL;                \
    missing = missing == NULL && vk->name == NULL ? "vk" #name : missing;
#define SW_STAGE_SURFACE(name)                                                                                         \
    vk->name = isPresentable ? (PFN_vk##name)find(instance, "vk" #name) : NULL;                                        \
    missing = missing == NULL && isPresentable && vk->name == NULL ? "vk" #name : missing;
#define SW_STAGE_SWAPCHAIN(name)                                                                                       \
    vk->name =                                                                                                         \
        isPresentable && missing == NULL ? (PFN_vk##name)vk->GetDeviceProcAddr(stage->device, "vk" #name) : NULL;      \
    missing = missing == NULL && isPresentable && vk->name == NULL ? "vk" #name : missing;
#include "seaway/stage_functions.inl"
#undef SW_STAGE_INSTANCE
#undef SW_STAGE_DEVICE
#undef SW_STAGE_SURFACE
#undef SW_STAGE_SWAPCHAIN
    return missing;
}

static swResult openDevice(swStage* stage, const swGpuDef* def)
{
    swResult result = swCreateGpu(&stage->host, def, &stage->gpu);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    stage->physicalDevice = swGpu_GetPhysicalDevice(stage->gpu);
    stage->device = swGpu_GetDevice(stage->gpu);
    stage->queue = swGpu_GetQueue(stage->gpu);
    const char* missing = loadFunctions(stage, def->presentable);
    if (missing != NULL)
    {
        return swFail(&stage->host, SW_ERROR_UNSUPPORTED, "the Vulkan driver of %s has no %s",
                      swGpu_GetDeviceName(stage->gpu), missing);
    }
    stage->vk.GetPhysicalDeviceProperties(stage->physicalDevice, &stage->properties);
    stage->vk.GetPhysicalDeviceMemoryProperties(stage->physicalDevice, &stage->memory);
    return swCreateStageSlots(stage, def->framesInFlight);
}

swResult swCreateStage(const swHost* host, const swGpuDef* def, swStage** stage)
{
    SW_REQUIRE_PLACE(host, stage, "swCreateStage()");
    swGpuDef standard = swDefaultGpuDef();
    SW_REQUIRE(def != NULL && def->internalValue == standard.internalValue, SW_ERROR_INVALID, host,
               "swCreateStage() needs a def made by swDefaultGpuDef()");
    swStage* created = swAllocateZero(host, sizeof(*created));
    if (created == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a stage");
    }
    created->host = *host;
    swResult result = openDevice(created, def);
    if (result != SW_SUCCESS)
    {
        swDestroyStage(created);
        return result;
    }
    *stage = created;
    return SW_SUCCESS;
}

void swDestroyStage(swStage* stage)
{
    if (stage == NULL)
    {
        return;
    }
    if (stage->vk.DeviceWaitIdle != NULL)
    {
        stage->vk.DeviceWaitIdle(stage->device);
        swDestroyStageSlots(stage);
    }
    swDestroyGpu(stage->gpu);
    swHost host = stage->host;
    swFree(&host, stage, sizeof(*stage));
}

swGpu* swStage_GetGpu(const swStage* stage)
{
    SW_REQUIRE(stage != NULL, NULL, NULL, "swStage_GetGpu() needs a stage");
    return stage->gpu;
}

const swStageVk* swStage_GetVk(const swStage* stage)
{
    SW_REQUIRE(stage != NULL, NULL, NULL, "swStage_GetVk() needs a stage");
    return &stage->vk;
}

bool swParseStageDevice(const char* text, swDeviceChoice* choice, int* index)
{
    SW_REQUIRE(text != NULL && choice != NULL && index != NULL, false, NULL,
               "swParseStageDevice() needs a text and places for choice and index");
    static const struct
    {
        const char* word;
        swDeviceChoice choice;
    } words[] = {{"auto", SW_DEVICE_AUTO}, {"gpu", SW_DEVICE_GPU}, {"software", SW_DEVICE_SOFTWARE}};
    for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); ++i)
    {
        if (strcmp(text, words[i].word) == 0)
        {
            *choice = words[i].choice;
            *index = 0;
            return true;
        }
    }
    size_t length = strspn(text, "0123456789");
    if (length == 0 || length > 2 || text[length] != '\0' || atoi(text) > 63)
    {
        return false;
    }
    *choice = SW_DEVICE_INDEX;
    *index = atoi(text);
    return true;
}
