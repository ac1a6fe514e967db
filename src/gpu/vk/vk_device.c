// SPDX-License-Identifier: MIT
// A device of the host's or of our own: entry points, instance, choice, features, and what is kept per device.

#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include "gpu/vk/vk_device.h"
#include "gpu/vk/vk_submit.h"

#define SW_VALIDATION_LAYER "VK_LAYER_KHRONOS_validation"
#define SW_MAX_DEVICES 32
#define SW_MAX_EXTENSIONS 32

// Entry points -------------------------------------------------------------------------------------------------------

static swResult loadLibrary(swGpu* gpu)
{
#ifdef _WIN32
    gpu->loader = (void*)LoadLibraryA("vulkan-1.dll");
    PFN_vkVoidFunction entry =
        gpu->loader ? (PFN_vkVoidFunction)GetProcAddress((HMODULE)gpu->loader, "vkGetInstanceProcAddr") : NULL;
    gpu->getInstanceProcAddr = (PFN_vkGetInstanceProcAddr)entry;
#else
    const char* const names[] = {"libvulkan.so.1", "libvulkan.so", "libvulkan.1.dylib"};
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]) && gpu->loader == NULL; ++i)
    {
        gpu->loader = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    }
    void* entry = gpu->loader ? dlsym(gpu->loader, "vkGetInstanceProcAddr") : NULL;
    memcpy(&gpu->getInstanceProcAddr, &entry, sizeof(entry)); // C has no cast from object to function pointers
#endif
    if (gpu->getInstanceProcAddr == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE,
                      "Vulkan is not installed: the library libvulkan.so.1 was not found (Debian: libvulkan1 and "
                      "mesa-vulkan-drivers)");
    }
    return SW_SUCCESS;
}

static swResult loadInstanceFunctions(swGpu* gpu)
{
    const char* missing = NULL;
#define SW_VK_INSTANCE(name)                                                                                           \
    gpu->vk.name = (PFN_vk##name)gpu->getInstanceProcAddr(gpu->instance, "vk" #name);                                  \
    missing = gpu->vk.name ? missing : "vk" #name;
#define SW_VK_DEVICE(name)
#include "gpu/vk/vk_functions.inl"
#undef SW_VK_INSTANCE
#undef SW_VK_DEVICE
#define SW_OPTIONAL(name) gpu->vk.name = (PFN_vk##name)gpu->getInstanceProcAddr(gpu->instance, "vk" #name)
    SW_OPTIONAL(CmdBeginDebugUtilsLabelEXT);
    SW_OPTIONAL(CmdEndDebugUtilsLabelEXT);
    SW_OPTIONAL(SetDebugUtilsObjectNameEXT);
    SW_OPTIONAL(CreateDebugUtilsMessengerEXT);
    SW_OPTIONAL(DestroyDebugUtilsMessengerEXT);
#undef SW_OPTIONAL
    if (missing != NULL)
    {
        return swFail(&gpu->host, SW_ERROR_UNSUPPORTED, "the Vulkan instance has no function %s", missing);
    }
    return SW_SUCCESS;
}

static swResult loadDeviceFunctions(swGpu* gpu)
{
    const char* missing = NULL;
#define SW_VK_INSTANCE(name)
#define SW_VK_DEVICE(name)                                                                                             \
    gpu->vk.name = (PFN_vk##name)gpu->vk.GetDeviceProcAddr(gpu->device, "vk" #name);                                   \
    missing = gpu->vk.name ? missing : "vk" #name;
#include "gpu/vk/vk_functions.inl"
#undef SW_VK_INSTANCE
#undef SW_VK_DEVICE
    if (missing != NULL)
    {
        return swFail(&gpu->host, SW_ERROR_UNSUPPORTED,
                      "the Vulkan device %s has no function %s: enable what swGpu_GetDeviceExtensions() lists",
                      gpu->properties.deviceName, missing);
    }
    return SW_SUCCESS;
}

// Instance -----------------------------------------------------------------------------------------------------------

static VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                VkDebugUtilsMessageTypeFlagsEXT types,
                                                const VkDebugUtilsMessengerCallbackDataEXT* data, void* context)
{
    swGpu* gpu = context;
    (void)types;
    char text[1024];
    snprintf(text, sizeof(text), "%s", data->pMessage ? data->pMessage : "");
    for (char* c = text; *c; ++c)
    {
        *c = *c == '\n' ? ' ' : *c;
    }
    atomic_fetch_add(&gpu->validationCount, 1);
    bool isError = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
    swLog(&gpu->host, isError ? SW_LOG_ERROR : SW_LOG_WARNING, "Vulkan validation: %s", text);
    return VK_FALSE;
}

static VkDebugUtilsMessengerCreateInfoEXT messengerInfo(swGpu* gpu)
{
    return (VkDebugUtilsMessengerCreateInfoEXT){
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
        .pfnUserCallback = onMessage,
        .pUserData = gpu,
    };
}

// Whether the loader (layer NULL) or a layer offers an instance extension.
static bool hasInstanceExtension(const swGpu* gpu, const char* layer, const char* name)
{
    PFN_vkEnumerateInstanceExtensionProperties enumerate =
        (PFN_vkEnumerateInstanceExtensionProperties)gpu->getInstanceProcAddr(NULL,
                                                                             "vkEnumerateInstanceExtensionProperties");
    VkExtensionProperties extensions[128];
    uint32_t count = 128;
    if (enumerate == NULL || enumerate(layer, &count, extensions) < 0)
    {
        return false;
    }
    for (uint32_t i = 0; i < count; ++i)
    {
        if (strcmp(extensions[i].extensionName, name) == 0)
        {
            return true;
        }
    }
    return false;
}

static bool hasLayer(const swGpu* gpu, const char* name)
{
    PFN_vkEnumerateInstanceLayerProperties enumerate =
        (PFN_vkEnumerateInstanceLayerProperties)gpu->getInstanceProcAddr(NULL, "vkEnumerateInstanceLayerProperties");
    VkLayerProperties layers[64];
    uint32_t count = 64;
    if (enumerate == NULL || enumerate(&count, layers) < 0)
    {
        return false;
    }
    for (uint32_t i = 0; i < count; ++i)
    {
        if (strcmp(layers[i].layerName, name) == 0)
        {
            return true;
        }
    }
    return false;
}

static swResult checkInstanceVersion(const swGpu* gpu)
{
    PFN_vkEnumerateInstanceVersion enumerate =
        (PFN_vkEnumerateInstanceVersion)gpu->getInstanceProcAddr(NULL, "vkEnumerateInstanceVersion");
    uint32_t version = VK_API_VERSION_1_0;
    if (enumerate != NULL)
    {
        enumerate(&version);
    }
    if (version < VK_API_VERSION_1_3)
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE, "the Vulkan loader knows Vulkan %u.%u only; 1.3 is needed",
                      VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version));
    }
    return SW_SUCCESS;
}

static swResult createInstance(swGpu* gpu, const swGpuDef* def)
{
    swResult result = checkInstanceVersion(gpu);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const char* extensions[SW_MAX_EXTENSIONS];
    uint32_t count = 0;
    if (def->instanceExtensionCount > SW_MAX_EXTENSIONS - 2)
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "more than %d instance extensions were asked for",
                      SW_MAX_EXTENSIONS - 2);
    }
    for (uint32_t i = 0; i < def->instanceExtensionCount; ++i)
    {
        extensions[count++] = def->instanceExtensions[i];
    }
    bool hasDebug = hasInstanceExtension(gpu, NULL, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (hasDebug)
    {
        extensions[count++] = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    }
    const char* layer = SW_VALIDATION_LAYER;
    if (def->enableValidation && !(hasLayer(gpu, layer) && hasDebug))
    {
        return swFail(&gpu->host, SW_ERROR_UNSUPPORTED,
                      "validation was asked for, but the layer %s is not installed (Debian: vulkan-validationlayers)",
                      layer);
    }
    VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(gpu);
    const VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT validation = {
        .sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
        .pNext = &messenger,
        .enabledValidationFeatureCount = 1,
        .pEnabledValidationFeatures = &synchronization,
    };
    const void* chain = NULL;
    if (def->enableValidation)
    {
        chain = &messenger;
        if (hasInstanceExtension(gpu, layer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME))
        {
            extensions[count++] = VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME;
            chain = &validation;
        }
    }
    const VkApplicationInfo application = {
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
        .pEngineName = "Seaway",
        .engineVersion = VK_MAKE_API_VERSION(0, SW_VERSION_MAJOR, SW_VERSION_MINOR, SW_VERSION_PATCH),
        .apiVersion = VK_API_VERSION_1_3,
    };
    const VkInstanceCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
        .pNext = chain,
        .pApplicationInfo = &application,
        .enabledLayerCount = def->enableValidation ? 1 : 0,
        .ppEnabledLayerNames = &layer,
        .enabledExtensionCount = count,
        .ppEnabledExtensionNames = extensions,
    };
    PFN_vkCreateInstance create = (PFN_vkCreateInstance)gpu->getInstanceProcAddr(NULL, "vkCreateInstance");
    VkResult created = create(&info, NULL, &gpu->instance);
    if (created != VK_SUCCESS)
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE, "no Vulkan instance could be created: %s%s",
                      swVkResultName(created),
                      created == VK_ERROR_INCOMPATIBLE_DRIVER
                          ? " (no Vulkan driver is installed: install the GPU's, or Debian's mesa-vulkan-drivers)"
                          : "");
    }
    gpu->ownsInstance = true;
    return SW_SUCCESS;
}

// Choice of the device -----------------------------------------------------------------------------------------------

static bool isSoftwareType(VkPhysicalDeviceType type)
{
    return type == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

// Higher is better; 0 is not wanted.
static int rankDevice(const VkPhysicalDeviceProperties* properties, swDeviceChoice choice)
{
    if (choice == SW_DEVICE_GPU && isSoftwareType(properties->deviceType))
    {
        return 0;
    }
    if (choice == SW_DEVICE_SOFTWARE && !isSoftwareType(properties->deviceType))
    {
        return 0;
    }
    switch (properties->deviceType)
    {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 5;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 4;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 3;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return 2;
    default:
        return 1;
    }
}

static const char* choiceText(swDeviceChoice choice)
{
    return choice == SW_DEVICE_GPU ? "a GPU" : choice == SW_DEVICE_SOFTWARE ? "a software device" : "any device";
}

static swResult chooseDevice(swGpu* gpu, const swGpuDef* def)
{
    VkPhysicalDevice devices[SW_MAX_DEVICES];
    uint32_t count = SW_MAX_DEVICES;
    VkResult result = gpu->vk.EnumeratePhysicalDevices(gpu->instance, &count, devices);
    if (result < 0 || count == 0)
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE,
                      "Vulkan lists no device (Debian: mesa-vulkan-drivers has a software one)");
    }
    if (def->choice == SW_DEVICE_INDEX && (def->deviceIndex < 0 || (uint32_t)def->deviceIndex >= count))
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE, "there is no Vulkan device %d: Vulkan lists %u, from 0 to %u",
                      def->deviceIndex, count, count - 1);
    }
    char report[1024] = "";
    int best = 0;
    for (uint32_t i = 0; i < count; ++i)
    {
        char missing[512];
        VkPhysicalDeviceProperties properties;
        gpu->vk.GetPhysicalDeviceProperties(devices[i], &properties);
        bool isUsable =
            swCheckDeviceFeatures(gpu->getInstanceProcAddr, gpu->instance, devices[i], missing, sizeof(missing));
        bool isExcluded = def->choice == SW_DEVICE_INDEX && i != (uint32_t)def->deviceIndex;
        int rank = isExcluded ? 0 : rankDevice(&properties, def->choice);
        size_t used = strlen(report);
        snprintf(report + used, sizeof(report) - used, "%s%u: %s %s%s", i > 0 ? "; " : "", i, properties.deviceName,
                 !isUsable    ? "lacks "
                 : isExcluded ? "was not asked for"
                 : rank == 0  ? "is of another kind"
                              : "would do",
                 isUsable ? "" : missing);
        if (isUsable && rank > best)
        {
            best = rank;
            gpu->physicalDevice = devices[i];
        }
    }
    if (best == 0)
    {
        return swFail(&gpu->host, SW_ERROR_NO_DEVICE, "no usable Vulkan device (%s was asked for): %s",
                      def->choice == SW_DEVICE_INDEX ? "one by its index" : choiceText(def->choice), report);
    }
    return SW_SUCCESS;
}

static uint32_t findQueueFamily(const swGpu* gpu)
{
    VkQueueFamilyProperties families[32];
    uint32_t count = 32;
    gpu->vk.GetPhysicalDeviceQueueFamilyProperties(gpu->physicalDevice, &count, families);
    const VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    uint32_t family = 0;
    while (family < count && (families[family].queueFlags & both) != both)
    {
        family += 1;
    }
    return family; // exists: swCheckDeviceFeatures() looked
}

static swResult createLogicalDevice(swGpu* gpu, const swGpuDef* def)
{
    gpu->queueFamily = findQueueFamily(gpu);
    swGpuFeatures have, enabled;
    swFillDeviceFeatures(&have);
    gpu->vk.GetPhysicalDeviceFeatures2(gpu->physicalDevice, &have.features);
    swFillDeviceFeatures(&enabled);
    gpu->hasWireframe = have.features.features.fillModeNonSolid;
    enabled.features.features.fillModeNonSolid = have.features.features.fillModeNonSolid;
    const char* extensions[SW_DEVICE_EXTENSION_COUNT + 1];
    uint32_t count = 0;
    for (; count < SW_DEVICE_EXTENSION_COUNT; ++count)
    {
        extensions[count] = swDeviceExtensions[count];
    }
    if (def->presentable)
    {
        extensions[count++] = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    }
    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
        .queueFamilyIndex = gpu->queueFamily,
        .queueCount = 1,
        .pQueuePriorities = &priority,
    };
    const VkDeviceCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
        .pNext = &enabled.features,
        .queueCreateInfoCount = 1,
        .pQueueCreateInfos = &queue,
        .enabledExtensionCount = count,
        .ppEnabledExtensionNames = extensions,
    };
    VkResult result = gpu->vk.CreateDevice(gpu->physicalDevice, &info, NULL, &gpu->device);
    gpu->ownsDevice = result == VK_SUCCESS;
    return swCheckVk(gpu, result, "creating a Vulkan device");
}

// Parts of a swGpu ---------------------------------------------------------------------------------------------------

static swResult createSamplers(swGpu* gpu)
{
    const struct
    {
        VkFilter filter;
        VkSamplerMipmapMode mips;
        VkSamplerAddressMode u, v;
        bool isAnisotropic;
    } kinds[SW_SAMPLER_COUNT] = {
        [SW_SAMPLER_NEAREST_CLAMP] = {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                      VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                      false},
        [SW_SAMPLER_LINEAR_CLAMP] = {VK_FILTER_LINEAR, VK_SAMPLER_MIPMAP_MODE_LINEAR,
                                     VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                     false},
        [SW_SAMPLER_LINEAR_REPEAT] = {VK_FILTER_LINEAR, VK_SAMPLER_MIPMAP_MODE_LINEAR, VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                      VK_SAMPLER_ADDRESS_MODE_REPEAT, false},
        [SW_SAMPLER_ANISOTROPIC_REPEAT] = {VK_FILTER_LINEAR, VK_SAMPLER_MIPMAP_MODE_LINEAR,
                                           VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_REPEAT, true},
        [SW_SAMPLER_LINEAR_REPEAT_X] = {VK_FILTER_LINEAR, VK_SAMPLER_MIPMAP_MODE_LINEAR, VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                        VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, false},
    };
    for (int i = 0; i < SW_SAMPLER_COUNT; ++i)
    {
        const VkSamplerCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
            .magFilter = kinds[i].filter,
            .minFilter = kinds[i].filter,
            .mipmapMode = kinds[i].mips,
            .addressModeU = kinds[i].u,
            .addressModeV = kinds[i].v,
            .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
            .anisotropyEnable = kinds[i].isAnisotropic,
            .maxAnisotropy = gpu->maxAnisotropy,
            .maxLod = VK_LOD_CLAMP_NONE,
        };
        VkResult result = gpu->vk.CreateSampler(gpu->device, &info, NULL, &gpu->samplers[i]);
        if (result != VK_SUCCESS)
        {
            return swCheckVk(gpu, result, "creating a sampler");
        }
    }
    return SW_SUCCESS;
}

static swResult createPipelineCache(swGpu* gpu, const swGpuDef* def)
{
    VkPipelineCacheCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
        .initialDataSize = def->pipelineCache ? def->pipelineCacheSize : 0,
        .pInitialData = def->pipelineCache,
    };
    // A cache of another driver or version is ignored by the driver, but a damaged one may be refused.
    VkPipelineCacheHeaderVersionOne header;
    if (info.initialDataSize >= sizeof(header))
    {
        memcpy(&header, def->pipelineCache, sizeof(header));
    }
    if (info.initialDataSize < sizeof(header) || header.vendorID != gpu->properties.vendorID ||
        header.deviceID != gpu->properties.deviceID ||
        memcmp(header.pipelineCacheUUID, gpu->properties.pipelineCacheUUID, VK_UUID_SIZE) != 0)
    {
        info.initialDataSize = 0;
        info.pInitialData = NULL;
    }
    VkResult result = gpu->vk.CreatePipelineCache(gpu->device, &info, NULL, &gpu->pipelineCache);
    if (result != VK_SUCCESS && info.initialDataSize > 0)
    {
        info.initialDataSize = 0;
        info.pInitialData = NULL;
        result = gpu->vk.CreatePipelineCache(gpu->device, &info, NULL, &gpu->pipelineCache);
    }
    return swCheckVk(gpu, result, "creating a pipeline cache");
}

static swResult takeHostDevice(swGpu* gpu, const swGpuDef* def)
{
    if (def->instance == VK_NULL_HANDLE || def->physicalDevice == VK_NULL_HANDLE || def->device == VK_NULL_HANDLE ||
        def->queue == VK_NULL_HANDLE)
    {
        return swFail(&gpu->host, SW_ERROR_INVALID,
                      "swGpuDef wants all of instance, physicalDevice, device and queue, or none of them");
    }
    gpu->instance = def->instance;
    gpu->physicalDevice = def->physicalDevice;
    gpu->device = def->device;
    gpu->queue = def->queue;
    gpu->queueFamily = def->queueFamily;
    swResult result = loadInstanceFunctions(gpu);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    gpu->vk.GetPhysicalDeviceProperties(gpu->physicalDevice, &gpu->properties);
    char missing[512];
    if (!swCheckDeviceFeatures(gpu->getInstanceProcAddr, gpu->instance, gpu->physicalDevice, missing, sizeof(missing)))
    {
        return swFail(&gpu->host, SW_ERROR_UNSUPPORTED, "the Vulkan device %s lacks %s", gpu->properties.deviceName,
                      missing);
    }
    return loadDeviceFunctions(gpu);
}

static swResult makeOwnDevice(swGpu* gpu, const swGpuDef* def)
{
    swResult result = createInstance(gpu, def);
    result = result == SW_SUCCESS ? loadInstanceFunctions(gpu) : result;
    if (result == SW_SUCCESS && def->enableValidation && gpu->vk.CreateDebugUtilsMessengerEXT != NULL)
    {
        const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(gpu);
        gpu->vk.CreateDebugUtilsMessengerEXT(gpu->instance, &info, NULL, &gpu->messenger);
    }
    result = result == SW_SUCCESS ? chooseDevice(gpu, def) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    gpu->vk.GetPhysicalDeviceProperties(gpu->physicalDevice, &gpu->properties);
    result = createLogicalDevice(gpu, def);
    result = result == SW_SUCCESS ? loadDeviceFunctions(gpu) : result;
    if (result == SW_SUCCESS)
    {
        gpu->vk.GetDeviceQueue(gpu->device, gpu->queueFamily, 0, &gpu->queue);
    }
    return result;
}

static swResult createParts(swGpu* gpu, const swGpuDef* def)
{
    gpu->framesInFlight = def->framesInFlight;
    gpu->usesCoreLayers =
        def->layers == SW_LAYERS_CORE || (def->layers == SW_LAYERS_AUTO && isSoftwareType(gpu->properties.deviceType));
    float anisotropy = gpu->properties.limits.maxSamplerAnisotropy;
    gpu->maxAnisotropy = anisotropy < 16.0f ? anisotropy : 16.0f;
    gpu->filtersFloats = swFiltersFloats(gpu);
    gpu->vk.GetPhysicalDeviceMemoryProperties(gpu->physicalDevice, &gpu->memory.properties);
    swResult result = createSamplers(gpu);
    result = result == SW_SUCCESS ? createPipelineCache(gpu, def) : result;
    result = result == SW_SUCCESS ? swCreatePassTimer(gpu) : result;
    return result;
}

swResult swCreateDevice(const swHost* host, const swGpuDef* def, swGpu** out)
{
    *out = NULL;
    swGpu* gpu = swAllocateZero(host, sizeof(swGpu));
    if (gpu == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a swGpu");
    }
    gpu->host = *host;
    gpu->getInstanceProcAddr = def->getInstanceProcAddr;
    atomic_init(&gpu->validationCount, 0);
    swResult result = gpu->getInstanceProcAddr ? SW_SUCCESS : loadLibrary(gpu);
    if (result == SW_SUCCESS)
    {
        bool isHosts = def->instance != VK_NULL_HANDLE || def->device != VK_NULL_HANDLE;
        result = isHosts ? takeHostDevice(gpu, def) : makeOwnDevice(gpu, def);
    }
    result = result == SW_SUCCESS ? createParts(gpu, def) : result;
    if (result != SW_SUCCESS)
    {
        swDestroyDevice(gpu);
        return result;
    }
    *out = gpu;
    return SW_SUCCESS;
}

static void destroyParts(swGpu* gpu)
{
    swDestroyRetired(gpu, UINT64_MAX);
    swDestroyUploads(gpu);
    swDestroySets(gpu);
    gpu->vk.DestroyDescriptorSetLayout(gpu->device, gpu->layersLayout, NULL);
    swDestroyPassTimer(gpu);
    swDestroySubmit(gpu);
    for (int i = 0; i < SW_SAMPLER_COUNT; ++i)
    {
        gpu->vk.DestroySampler(gpu->device, gpu->samplers[i], NULL);
    }
    gpu->vk.DestroyPipelineCache(gpu->device, gpu->pipelineCache, NULL);
    swDestroyDeviceMemory(gpu);
}

void swDestroyDevice(swGpu* gpu)
{
    if (gpu == NULL)
    {
        return;
    }
    swHost host = gpu->host;
    if (gpu->framesInFlight > 0) // createParts() began
    {
        destroyParts(gpu);
    }
    if (gpu->ownsDevice && gpu->vk.DestroyDevice != NULL)
    {
        gpu->vk.DestroyDevice(gpu->device, NULL);
    }
    if (gpu->messenger != VK_NULL_HANDLE)
    {
        gpu->vk.DestroyDebugUtilsMessengerEXT(gpu->instance, gpu->messenger, NULL);
    }
    if (gpu->ownsInstance && gpu->vk.DestroyInstance != NULL)
    {
        gpu->vk.DestroyInstance(gpu->instance, NULL);
    }
    if (gpu->loader != NULL)
    {
#ifdef _WIN32
        FreeLibrary((HMODULE)gpu->loader);
#else
        dlclose(gpu->loader);
#endif
    }
    swFree(&host, gpu->retired, sizeof(swRetired) * (size_t)gpu->retiredCapacity);
    swFree(&host, gpu, sizeof(swGpu));
}

void swNameObject(const swGpu* gpu, VkObjectType type, uint64_t handle, const char* name)
{
    if (gpu->vk.SetDebugUtilsObjectNameEXT == NULL || name == NULL)
    {
        return;
    }
    const VkDebugUtilsObjectNameInfoEXT info = {
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
        .objectType = type,
        .objectHandle = handle,
        .pObjectName = name,
    };
    gpu->vk.SetDebugUtilsObjectNameEXT(gpu->device, &info);
}

// Retirement ---------------------------------------------------------------------------------------------------------

static void destroyOne(swGpu* gpu, swRetired* retired)
{
    for (int i = 0; i <= SW_MAX_MIPS; ++i)
    {
        gpu->vk.DestroyImageView(gpu->device, retired->views[i], NULL);
    }
    gpu->vk.DestroyImage(gpu->device, retired->image, NULL);
    gpu->vk.DestroyBuffer(gpu->device, retired->buffer, NULL);
    swFreeDeviceMemory(gpu, &retired->memory);
}

static bool growRetired(swGpu* gpu)
{
    int capacity = gpu->retiredCapacity > 0 ? 2 * gpu->retiredCapacity : 16;
    swRetired* list = swAllocate(&gpu->host, sizeof(swRetired) * (size_t)capacity);
    if (list == NULL)
    {
        return false;
    }
    if (gpu->retiredCount > 0)
    {
        memcpy(list, gpu->retired, sizeof(swRetired) * (size_t)gpu->retiredCount);
    }
    swFree(&gpu->host, gpu->retired, sizeof(swRetired) * (size_t)gpu->retiredCapacity);
    gpu->retired = list;
    gpu->retiredCapacity = capacity;
    return true;
}

swResult swMakeRoomToRetire(swGpu* gpu)
{
    if (gpu->retiredCount == gpu->retiredCapacity && !growRetired(gpu))
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "No memory for the list of what the GPU still uses.");
    }
    return SW_SUCCESS;
}

void swRetire(swGpu* gpu, const swRetired* retired)
{
    swRetired entry = *retired;
    entry.frameIndex = gpu->frameIndex;
    if (gpu->retiredCount == gpu->retiredCapacity && !growRetired(gpu))
    {
        gpu->vk.DeviceWaitIdle(gpu->device);
        destroyOne(gpu, &entry);
        return;
    }
    gpu->retired[gpu->retiredCount++] = entry;
}

void swDestroyRetired(swGpu* gpu, uint64_t frameIndex)
{
    int kept = 0;
    for (int i = 0; i < gpu->retiredCount; ++i)
    {
        swRetired* entry = &gpu->retired[i];
        if (frameIndex == UINT64_MAX || entry->frameIndex + (uint64_t)gpu->framesInFlight <= frameIndex)
        {
            destroyOne(gpu, entry);
        }
        else
        {
            gpu->retired[kept++] = *entry;
        }
    }
    gpu->retiredCount = kept;
}
