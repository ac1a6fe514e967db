// SPDX-License-Identifier: MIT
#include <string.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "gpu/record/record.h"

static const swHost* findHost(const swGpu* gpu)
{
    return gpu != NULL ? &gpu->host : NULL;
}

static const swHost* findWorldHost(const swGpuWorld* gpuWorld)
{
    return gpuWorld != NULL ? &gpuWorld->gpu->host : NULL;
}

swResult swCreateGpu(const swHost* host, const swGpuDef* def, swGpu** gpu)
{
    SW_REQUIRE_PLACE(host, gpu, "swCreateGpu()");
    SW_REQUIRE(def != NULL, SW_ERROR_INVALID, host, "swCreateGpu() needs a def");
    swResult result = swCheckDef(host, swGetGpuFields(), def);
    return result == SW_SUCCESS ? swCreateDevice(host, def, gpu) : result;
}

void swDestroyGpu(swGpu* gpu)
{
    swDestroyDevice(gpu);
}

bool swGpu_CheckDevice(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance, VkPhysicalDevice device,
                       char* missing, size_t size)
{
    if (missing != NULL && size > 0)
    {
        missing[0] = '\0';
    }
    SW_REQUIRE(getInstanceProcAddr != NULL && instance != VK_NULL_HANDLE && device != VK_NULL_HANDLE, false, NULL,
               "swGpu_CheckDevice() needs a loader, an instance and a device");
    return swCheckDeviceFeatures(getInstanceProcAddr, instance, device, missing, size);
}

const VkPhysicalDeviceFeatures2* swGpu_GetFeatures(swGpuFeatures* storage)
{
    SW_REQUIRE(storage != NULL, NULL, NULL, "swGpu_GetFeatures() needs storage");
    swFillDeviceFeatures(storage);
    return &storage->features;
}

const char* const* swGpu_GetDeviceExtensions(uint32_t* count)
{
    SW_REQUIRE(count != NULL, NULL, NULL, "swGpu_GetDeviceExtensions() needs a place for the count");
    *count = SW_DEVICE_EXTENSION_COUNT;
    return swDeviceExtensions;
}

PFN_vkGetInstanceProcAddr swGpu_GetInstanceProcAddr(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, NULL, NULL, "swGpu_GetInstanceProcAddr() needs a swGpu");
    return gpu->getInstanceProcAddr;
}

VkInstance swGpu_GetInstance(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, VK_NULL_HANDLE, NULL, "swGpu_GetInstance() needs a swGpu");
    return gpu->instance;
}

VkPhysicalDevice swGpu_GetPhysicalDevice(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, VK_NULL_HANDLE, NULL, "swGpu_GetPhysicalDevice() needs a swGpu");
    return gpu->physicalDevice;
}

VkDevice swGpu_GetDevice(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, VK_NULL_HANDLE, NULL, "swGpu_GetDevice() needs a swGpu");
    return gpu->device;
}

VkQueue swGpu_GetQueue(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, VK_NULL_HANDLE, NULL, "swGpu_GetQueue() needs a swGpu");
    return gpu->queue;
}

uint32_t swGpu_GetQueueFamily(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, 0, NULL, "swGpu_GetQueueFamily() needs a swGpu");
    return gpu->queueFamily;
}

const char* swGpu_GetDeviceName(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, "", NULL, "swGpu_GetDeviceName() needs a swGpu");
    return gpu->properties.deviceName;
}

bool swGpu_IsSoftware(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, false, NULL, "swGpu_IsSoftware() needs a swGpu");
    return gpu->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

bool swGpu_WantsCpuLayers(const swGpu* gpu)
{
    SW_ASSERT(gpu != NULL);
    return gpu != NULL && gpu->usesCoreLayers;
}

swViewDef swGpu_FitView(const swGpu* gpu, const swViewDef* def, uint32_t height)
{
    swViewDef usual = swDefaultViewDef();
    SW_REQUIRE(gpu != NULL && def != NULL && def->internalValue == SW_DEF_COOKIE, usual, findHost(gpu),
               "swGpu_FitView() needs a swGpu and a def made by swDefaultViewDef()");
    swViewDef fitted = *def;
    if (!gpu->usesCoreLayers)
    {
        return fitted;
    }
    fitted.enableCpuLayers = true;
    bool isUsual = def->resolution == usual.resolution && def->finestTexel == usual.finestTexel;
    if (isUsual && swGpu_IsSoftware(gpu) && height < 540)
    {
        fitted.resolution = height < 270 ? usual.resolution / 3 : usual.resolution / 2;
        fitted.finestTexel = height < 270 ? 4.0f * usual.finestTexel : 2.0f * usual.finestTexel;
    }
    return fitted;
}

int swGpu_GetValidationCount(const swGpu* gpu)
{
    SW_REQUIRE(gpu != NULL, 0, NULL, "swGpu_GetValidationCount() needs a swGpu");
    return atomic_load(&gpu->validationCount);
}

swResult swGpu_GetPipelineCache(const swGpu* gpu, void* data, size_t* size)
{
    SW_REQUIRE(gpu != NULL && size != NULL, SW_ERROR_INVALID, findHost(gpu),
               "swGpu_GetPipelineCache() needs a swGpu and a place for the size");
    VkResult result = gpu->vk.GetPipelineCacheData(gpu->device, gpu->pipelineCache, size, data);
    if (result == VK_INCOMPLETE)
    {
        return swFail(&gpu->host, SW_ERROR_INVALID, "the pipeline cache has more than the %zu bytes given", *size);
    }
    return swCheckVk(gpu, result, "reading the pipeline cache");
}

void swGpu_SetFinishedFrame(swGpu* gpu, uint64_t frameIndex)
{
    SW_ASSERT(gpu != NULL);
    if (gpu != NULL)
    {
        gpu->finishedFrame = gpu->hasFinished && gpu->finishedFrame > frameIndex ? gpu->finishedFrame : frameIndex;
        gpu->hasFinished = true;
    }
}

swResult swCreateGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld)
{
    if (gpuWorld != NULL)
    {
        *gpuWorld = NULL;
    }
    SW_REQUIRE(gpu != NULL && world != NULL && gpuWorld != NULL, SW_ERROR_INVALID,
               gpu != NULL ? &gpu->host : swFindHost(world),
               "swCreateGpuWorld() needs a swGpu, a world and a place for its twin");
    return swMakeGpuWorld(gpu, world, gpuWorld);
}

void swDestroyGpuWorld(swGpuWorld* gpuWorld)
{
    swFreeGpuWorld(gpuWorld);
}

swResult swGpuWorld_Record(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex)
{
    SW_REQUIRE(gpuWorld != NULL && commands != VK_NULL_HANDLE, SW_ERROR_INVALID, findWorldHost(gpuWorld),
               "swGpuWorld_Record() needs a swGpuWorld and a command buffer");
    return swRecordFrame(gpuWorld, commands, frameIndex);
}

void swGpuWorld_Discard(swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    SW_ASSERT(gpuWorld != NULL);
    if (gpuWorld != NULL)
    {
        swDiscardFrames(gpuWorld, frameIndex);
    }
}

size_t swGpuWorld_GetMemory(const swGpuWorld* gpuWorld)
{
    SW_REQUIRE(gpuWorld != NULL, 0, NULL, "swGpuWorld_GetMemory() needs a swGpuWorld");
    return swGetGpuWorldMemory(gpuWorld);
}

swResult swGpuWorld_ReadLayer(swGpuWorld* gpuWorld, const swView* view, swLayer layer, int slice, float* texels)
{
    SW_REQUIRE(gpuWorld != NULL, SW_ERROR_INVALID, NULL, "swGpuWorld_ReadLayer() needs a swGpuWorld");
    const swGpuView* gpuView = swFindGpuView(gpuWorld, view);
    if (gpuView == NULL || texels == NULL || slice < 0 || slice >= gpuView->sliceCount || layer < 0 ||
        layer >= SW_LAYER_COUNT)
    {
        return swFail(&gpuWorld->gpu->host, SW_ERROR_INVALID,
                      "there is no layer %d of slice %d: the view was not recorded, or has fewer slices", (int)layer,
                      slice);
    }
    return swReadLayer(gpuWorld->gpu, gpuView, layer, slice, texels);
}

int swGpu_GetPassTimes(const swGpu* gpu, swPassTime* times, int capacity)
{
    SW_REQUIRE(gpu != NULL && (times != NULL || capacity == 0) && capacity >= 0, 0, findHost(gpu),
               "swGpu_GetPassTimes() needs a swGpu and room for at least 0 times");
    int count = gpu->timer.resultCount < capacity ? gpu->timer.resultCount : capacity;
    if (count > 0)
    {
        memcpy(times, gpu->timer.results, sizeof(swPassTime) * (size_t)count);
    }
    return count > 0 ? count : 0;
}
