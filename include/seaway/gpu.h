// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan_core.h>

#include "view.h"
#include "world.h"

/// @file
/// The same waves on Vulkan 1.3, recorded into the host's command buffers. Seaway never submits, never waits and owns no
/// queue unless it is asked to create a device itself.

/// A device that Seaway may record for: pipelines, memory, upload ring. External synchronization: one thread at a time.
typedef struct swGpu swGpu;

typedef enum swDeviceChoice
{
    SW_DEVICE_AUTO,     ///< a GPU if there is one, else a software device
    SW_DEVICE_GPU,      ///< discrete or integrated only
    SW_DEVICE_SOFTWARE, ///< a CPU device such as Mesa's lavapipe only
    SW_DEVICE_INDEX     ///< swGpuDef::deviceIndex in Vulkan's order
} swDeviceChoice;

/// Must be initialized with swDefaultGpuDef().
typedef struct swGpuDef
{
    /// The host's device. Give all of instance, physicalDevice, device, queue and queueFamily, or leave all null to let
    /// Seaway create its own. The device needs what swGpu_CheckDevice() and swGpu_GetFeatures() say.
    PFN_vkGetInstanceProcAddr getInstanceProcAddr; ///< NULL: load the system's Vulkan loader
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    uint32_t queueFamily;

    /// When Seaway creates the device: which one. Default SW_DEVICE_AUTO.
    swDeviceChoice choice;
    int deviceIndex;

    /// When Seaway creates the device: extra instance extensions (a window system's), device extensions are added when
    /// `presentable`. Read only during the call.
    const char* const* instanceExtensions;
    uint32_t instanceExtensionCount;
    bool presentable; ///< enable VK_KHR_swapchain. Default false

    /// When Seaway creates the device: enable the Khronos validation layer and send its messages to the log.
    /// Default false.
    bool enableValidation;

    /// Frames that may be in flight: the host waits for frame n - framesInFlight before it records frame n.
    /// Range [1, 4]. Default 2.
    int framesInFlight;

    /// Pipeline cache of an earlier run, see swGpu_GetPipelineCache(). May be NULL; bad data are ignored.
    const void* pipelineCache;
    size_t pipelineCacheSize;

    /// Set by swDefaultGpuDef().
    int internalValue;
} swGpuDef;

SW_API swGpuDef swDefaultGpuDef(void);

/// @return SW_ERROR_NO_DEVICE (the log names each device and what it lacks), SW_ERROR_UNSUPPORTED (the host's device
/// lacks something), SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swCreateGpu(const swHost* host, const swGpuDef* def, swGpu** gpu);

/// The device must be idle. NULL is allowed.
SW_API void swDestroyGpu(swGpu* gpu);

/// Whether a physical device can be used; otherwise `missing` (of `size` bytes) names every missing feature.
SW_API bool swGpu_CheckDevice(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance,
                              VkPhysicalDevice device, char* missing, size_t size);

/// For a host that creates its own device: extensions and the chain of features to enable. The chain points into
/// `storage`, which the caller keeps until vkCreateDevice returns.
typedef struct swGpuFeatures
{
    VkPhysicalDeviceFeatures2 features;
    VkPhysicalDeviceVulkan11Features features11;
    VkPhysicalDeviceVulkan12Features features12;
    VkPhysicalDeviceVulkan13Features features13;
} swGpuFeatures;
SW_API const VkPhysicalDeviceFeatures2* swGpu_GetFeatures(swGpuFeatures* storage);
SW_API const char* const* swGpu_GetDeviceExtensions(uint32_t* count);

/// What is in use, also when Seaway created it.
SW_API VkInstance swGpu_GetInstance(const swGpu* gpu);
SW_API VkPhysicalDevice swGpu_GetPhysicalDevice(const swGpu* gpu);
SW_API VkDevice swGpu_GetDevice(const swGpu* gpu);
SW_API VkQueue swGpu_GetQueue(const swGpu* gpu);
SW_API uint32_t swGpu_GetQueueFamily(const swGpu* gpu);
SW_API const char* swGpu_GetDeviceName(const swGpu* gpu);
SW_API bool swGpu_IsSoftware(const swGpu* gpu);

/// Number of validation errors and warnings seen since creation (0 without enableValidation).
SW_API int swGpu_GetValidationCount(const swGpu* gpu);

/// Pipeline cache data to store; call with NULL for the size.
SW_API swResult swGpu_GetPipelineCache(const swGpu* gpu, void* data, size_t* size);

/// The GPU twin of a world: its spectra, tiles and the layers of its views.
typedef struct swGpuWorld swGpuWorld;

/// The world must outlive it. Memory grows when the world gets wave systems or views, at the next swGpuWorld_Record().
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swCreateGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);

/// The device must be idle. NULL is allowed.
SW_API void swDestroyGpuWorld(swGpuWorld* gpuWorld);

/// Record all passes of the world's last step and all its views: spectra to tiles to slices to foam. Compute only,
/// outside of a render pass. `frameIndex` grows by one per recorded frame.
/// @return SW_ERROR_NO_MEMORY or SW_ERROR_DEVICE when something new could not be allocated; nothing is recorded then
SW_API swResult swGpuWorld_Record(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);

/// Bytes of device memory in use.
SW_API size_t swGpuWorld_GetMemory(const swGpuWorld* gpuWorld);

/// Layers that can be read back.
typedef enum swLayer
{
    SW_LAYER_DISPLACEMENT, ///< 4 floats a texel: x, y, z, 0
    SW_LAYER_DERIVATIVES,  ///< 4 floats a texel: gx, gz, J, 0, see swView_GetDerivatives()
    SW_LAYER_FOAM,         ///< 1 float a texel
    SW_LAYER_COUNT
} swLayer;

/// Read a slice's layer of the last recorded frame to the host. For tests and tools: submits to the device's queue and
/// waits, so the recorded work must have been submitted. `texels` has room for resolution^2 * channels floats.
SW_API swResult swGpuWorld_ReadLayer(swGpuWorld* gpuWorld, const swView* view, swLayer layer, int slice, float* texels);

/// Time of each pass in the latest frame whose timestamps arrived, ms; names are those of passes.inl and of the
/// renderer's stages.
typedef struct swPassTime
{
    const char* name;
    float milliseconds;
} swPassTime;

/// @return number of passes written, at most `capacity`
SW_API int swGpu_GetPassTimes(const swGpu* gpu, swPassTime* times, int capacity);
