// SPDX-License-Identifier: MIT
// An engine's own Vulkan: the host makes instance, device, queue and command buffer; Seaway only records into it. The
// host submits, waits, reads a layer back and prints what each pass took.
#include <seaway/gpu.h>
#include <seaway/seaway.h>

#include <vulkan/vulkan.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FRAME_COUNT 8
#define MAX_DEVICES 16

typedef struct Host
{
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    uint32_t queueFamily;
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkFence fence;
} Host;

static bool PickDevice(Host* host)
{
    VkPhysicalDevice devices[MAX_DEVICES];
    uint32_t count = MAX_DEVICES;
    if (vkEnumeratePhysicalDevices(host->instance, &count, devices) < 0)
    {
        return false;
    }
    for (uint32_t i = 0; i < count; ++i)
    {
        char missing[512];
        if (swGpu_CheckDevice(vkGetInstanceProcAddr, host->instance, devices[i], missing, sizeof(missing)))
        {
            host->physicalDevice = devices[i];
            return true;
        }
        fprintf(stderr, "device %u lacks: %s\n", i, missing);
    }
    return false;
}

static bool FindQueueFamily(Host* host)
{
    VkQueueFamilyProperties families[MAX_DEVICES];
    uint32_t count = MAX_DEVICES;
    vkGetPhysicalDeviceQueueFamilyProperties(host->physicalDevice, &count, families);
    VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i)
    {
        if ((families[i].queueFlags & wanted) == wanted)
        {
            host->queueFamily = i;
            return true;
        }
    }
    return false;
}

// A device with what Seaway needs; a real host chains its own features to these.
static bool CreateDevice(Host* host)
{
    swGpuFeatures storage;
    uint32_t extensionCount;
    const char* const* extensions = swGpu_GetDeviceExtensions(&extensionCount);
    float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                         .queueFamilyIndex = host->queueFamily,
                                         .queueCount = 1,
                                         .pQueuePriorities = &priority};
    VkDeviceCreateInfo deviceInfo = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                     .pNext = swGpu_GetFeatures(&storage),
                                     .queueCreateInfoCount = 1,
                                     .pQueueCreateInfos = &queueInfo,
                                     .enabledExtensionCount = extensionCount,
                                     .ppEnabledExtensionNames = extensions};
    if (vkCreateDevice(host->physicalDevice, &deviceInfo, NULL, &host->device) != VK_SUCCESS)
    {
        return false;
    }
    vkGetDeviceQueue(host->device, host->queueFamily, 0, &host->queue);
    return true;
}

static bool CreateCommands(Host* host)
{
    VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                        .queueFamilyIndex = host->queueFamily};
    VkFenceCreateInfo fenceInfo = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    if (vkCreateCommandPool(host->device, &poolInfo, NULL, &host->pool) != VK_SUCCESS ||
        vkCreateFence(host->device, &fenceInfo, NULL, &host->fence) != VK_SUCCESS)
    {
        return false;
    }
    VkCommandBufferAllocateInfo allocateInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                .commandPool = host->pool,
                                                .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                .commandBufferCount = 1};
    return vkAllocateCommandBuffers(host->device, &allocateInfo, &host->commands) == VK_SUCCESS;
}

static bool CreateHost(Host* host)
{
    VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                     .pApplicationName = "03_host_device",
                                     .apiVersion = VK_API_VERSION_1_3};
    VkInstanceCreateInfo instanceInfo = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                         .pApplicationInfo = &application};
    return vkCreateInstance(&instanceInfo, NULL, &host->instance) == VK_SUCCESS && PickDevice(host) &&
           FindQueueFamily(host) && CreateDevice(host) && CreateCommands(host);
}

static void DestroyHost(Host* host)
{
    if (host->device)
    {
        vkDestroyFence(host->device, host->fence, NULL);
        vkDestroyCommandPool(host->device, host->pool, NULL);
        vkDestroyDevice(host->device, NULL);
    }
    if (host->instance)
    {
        vkDestroyInstance(host->instance, NULL);
    }
}

// [frame]
// One frame of the engine: step the world, record the water among the engine's own work, submit, wait.
static bool RunFrame(Host* host, swWorld* world, swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    VkCommandBufferBeginInfo beginInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                          .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    VkSubmitInfo submitInfo = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &host->commands};
    return swWorld_Step(world, 1.0 / 60.0) == SW_SUCCESS &&
           vkBeginCommandBuffer(host->commands, &beginInfo) == VK_SUCCESS &&
           swGpuWorld_Record(gpuWorld, host->commands, frameIndex) == SW_SUCCESS &&
           vkEndCommandBuffer(host->commands) == VK_SUCCESS &&
           vkQueueSubmit(host->queue, 1, &submitInfo, host->fence) == VK_SUCCESS &&
           vkWaitForFences(host->device, 1, &host->fence, VK_TRUE, UINT64_MAX) == VK_SUCCESS &&
           vkResetFences(host->device, 1, &host->fence) == VK_SUCCESS;
}
// [/frame]

// The viewer's own column in the finest slice, against the same particle on the CPU.
static bool CompareWithCpu(swWorld* world, swView* view, swGpuWorld* gpuWorld)
{
    swSliceInfo slice = swView_GetSlice(view, 0);
    size_t resolution = (size_t)slice.resolution;
    float* texels = malloc(4 * resolution * resolution * sizeof(float));
    bool isEqual = texels && swGpuWorld_ReadLayer(gpuWorld, view, SW_LAYER_DISPLACEMENT, 0, texels) == SW_SUCCESS;
    if (isEqual)
    {
        size_t middle = resolution / 2;
        swPosXZ rest = {(double)(slice.firstX + (int64_t)middle) * slice.texel,
                        (double)(slice.firstZ + (int64_t)middle) * slice.texel};
        swVec3 cpu;
        swSurfaceSamples samples = {.displacement = &cpu};
        swQueryDef query = swDefaultQueryDef();
        query.minWavelength = slice.minWavelength; // shorter waves do not fit the slice's texels
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, 1, &rest, &samples, NULL, NULL);
        const float* gpu = texels + 4 * (middle * resolution + middle);
        printf("displacement at (%.2f, %.2f): GPU %.3f %.3f %.3f, CPU %.3f %.3f %.3f m\n", rest.x, rest.z,
               (double)gpu[0], (double)gpu[1], (double)gpu[2], (double)cpu.x, (double)cpu.y, (double)cpu.z);
        isEqual = fabsf(gpu[0] - cpu.x) < 1e-3f && fabsf(gpu[1] - cpu.y) < 1e-3f && fabsf(gpu[2] - cpu.z) < 1e-3f;
    }
    free(texels);
    return isEqual;
}

static void PrintPassTimes(const swGpu* gpu)
{
    swPassTime times[32];
    int count = swGpu_GetPassTimes(gpu, times, 32);
    for (int i = 0; i < count; ++i)
    {
        printf("%-16s %7.3f ms\n", times[i].name, (double)times[i].milliseconds);
    }
}

static bool RunSea(Host* host, swWorld* world)
{
    swHost seawayHost = swDefaultHost();
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.getInstanceProcAddr = vkGetInstanceProcAddr;
    gpuDef.instance = host->instance;
    gpuDef.physicalDevice = host->physicalDevice;
    gpuDef.device = host->device;
    gpuDef.queue = host->queue;
    gpuDef.queueFamily = host->queueFamily;

    swGpu* gpu = NULL;
    swGpuWorld* gpuWorld = NULL;
    swView* view = NULL;
    swWaveSystemId sea;
    swViewDef viewDef = swDefaultViewDef();
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    bool isFine = swCreateGpu(&seawayHost, &gpuDef, &gpu) == SW_SUCCESS &&
                  swCreateWaveSystem(world, &waves, &sea) == SW_SUCCESS &&
                  swCreateView(world, &viewDef, &view) == SW_SUCCESS &&
                  swCreateGpuWorld(gpu, world, &gpuWorld) == SW_SUCCESS;
    if (isFine)
    {
        printf("device: %s\n", swGpu_GetDeviceName(gpu));
        swView_SetViewpoint(view, (swPos){0.0, 2.0, 0.0});
    }
    for (uint64_t frame = 0; isFine && frame < FRAME_COUNT; ++frame)
    {
        isFine = RunFrame(host, world, gpuWorld, frame);
    }
    isFine = isFine && CompareWithCpu(world, view, gpuWorld);
    if (isFine)
    {
        PrintPassTimes(gpu);
    }
    swDestroyGpuWorld(gpuWorld);
    swDestroyView(view);
    swDestroyGpu(gpu);
    return isFine;
}

int main(void)
{
    swHost seawayHost = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    Host host = {0};
    bool isFine = CreateHost(&host) && swCreateWorld(&seawayHost, &worldDef, &world) == SW_SUCCESS;
    isFine = isFine && RunSea(&host, world);
    swDestroyWorld(world);
    DestroyHost(&host);
    if (!isFine)
    {
        fprintf(stderr, "03_host_device: no Vulkan 1.3 device that will do, or a call failed; see above\n");
    }
    return isFine ? 0 : 1;
}
