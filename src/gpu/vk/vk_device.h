// SPDX-License-Identifier: MIT
#pragma once

// The device and everything that is kept per device. The whole toolbox takes a swGpu*; it knows no water.
// Vulkan functions are called through the table: gpu->vk.CmdDispatch(commands, ...). A function that is not there yet
// gets a line in vk_functions.inl.

#include <stdatomic.h>

#include "core/base/host.h"
#include "gpu/vk/vk_buffer.h"
#include "gpu/vk/vk_image.h"
#include "gpu/vk/vk_memory.h"
#include "gpu/vk/vk_pass.h"
#include "gpu/vk/vk_sets.h"
#include "gpu/vk/vk_upload.h"

typedef struct swVkFunctions
{
#define SW_VK_INSTANCE(name) PFN_vk##name name;
#define SW_VK_DEVICE(name) PFN_vk##name name;
#include "gpu/vk/vk_functions.inl"
#undef SW_VK_INSTANCE
#undef SW_VK_DEVICE
    // Optional: NULL without VK_EXT_debug_utils.
    PFN_vkCmdBeginDebugUtilsLabelEXT CmdBeginDebugUtilsLabelEXT;
    PFN_vkCmdEndDebugUtilsLabelEXT CmdEndDebugUtilsLabelEXT;
    PFN_vkSetDebugUtilsObjectNameEXT SetDebugUtilsObjectNameEXT;
    PFN_vkCreateDebugUtilsMessengerEXT CreateDebugUtilsMessengerEXT;
    PFN_vkDestroyDebugUtilsMessengerEXT DestroyDebugUtilsMessengerEXT;
} swVkFunctions;

// Something that frames in flight may still use.
typedef struct swRetired
{
    uint64_t frameIndex; // the frame that was being recorded
    VkBuffer buffer;
    VkImage image;
    VkImageView views[SW_MAX_MIPS + 1];
    swAllocation memory;
} swRetired;

struct swGpu
{
    swHost host;
    swVkFunctions vk;
    void* loader; // handle of the loaded Vulkan library, NULL if the host gave its own entry point
    PFN_vkGetInstanceProcAddr getInstanceProcAddr;
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    uint32_t queueFamily;
    bool ownsInstance, ownsDevice;
    VkDebugUtilsMessengerEXT messenger;
    atomic_int validationCount; // counted on whatever thread calls Vulkan

    VkPhysicalDeviceProperties properties;
    float maxAnisotropy;
    bool hasWireframe;  // fillModeNonSolid
    bool filtersFloats; // linear filtering of 32-bit floats; not on many mobile GPUs
    VkPipelineCache pipelineCache;
    VkSampler samplers[SW_SAMPLER_COUNT];
    VkDescriptorSetLayout layersLayout; // of swGpu_GetLayersLayout(), once it was asked for
    swMemory memory;

    bool usesCoreLayers; // where a view has them, see swGpuDef::layers
    int framesInFlight;
    bool hasFrame;       // a frame was begun
    uint64_t frameIndex; // of the frame being recorded
    int frameSlot;       // frameIndex % framesInFlight
    bool hasFinished;    // the host said that a frame is done
    uint64_t finishedFrame;
    swUploadRing uploads[SW_MAX_FRAMES_IN_FLIGHT];
    swSetRing sets[SW_MAX_FRAMES_IN_FLIGHT];
    swPassTimer timer;
    int retiredCount, retiredCapacity;
    swRetired* retired;

    VkCommandPool submitPool;
    VkCommandBuffer submitCommands;
    VkFence submitFence;
};

swResult swCreateDevice(const swHost* host, const swGpuDef* def, swGpu** gpu);
void swDestroyDevice(swGpu* gpu);

// Features and extensions: what a device must have and what is enabled on one of our own.
bool swCheckDeviceFeatures(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                           char* missing, size_t size);
void swFillDeviceFeatures(swGpuFeatures* storage);
// What is used where it is there.
bool swFiltersFloats(const swGpu* gpu);
extern const char* const swDeviceExtensions[];
#define SW_DEVICE_EXTENSION_COUNT 1

// Log "what failed: VK_ERROR_..." and give the swResult that a VkResult means; VK_SUCCESS gives SW_SUCCESS.
swResult swCheckVk(const swGpu* gpu, VkResult result, const char* what);
const char* swVkResultName(VkResult result);

// A name for debuggers and validation messages. Does nothing without VK_EXT_debug_utils.
void swNameObject(const swGpu* gpu, VkObjectType type, uint64_t handle, const char* name);

// Takes the record's handles over; they are destroyed once frames in flight are done.
// Without memory for the list it waits for the device and destroys at once.
void swRetire(swGpu* gpu, const swRetired* retired);

// Room for one more, so that the next swRetire() keeps it alive and does not have to wait and destroy.
swResult swMakeRoomToRetire(swGpu* gpu);
// Destroy what was retired at least framesInFlight frames before `frameIndex`; UINT64_MAX destroys all.
void swDestroyRetired(swGpu* gpu, uint64_t frameIndex);
