// SPDX-License-Identifier: MIT
// `seaway devices`: every Vulkan device in Vulkan's order, which is what --device INDEX counts, and what each lacks.

#include <string.h>

#include "args.h"
#include "verbs.h"
#include "vulkan_calls.h"

#define MAX_DEVICES 64

static const char* GetTypeName(VkPhysicalDeviceType type)
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

static VkInstance CreateInstance(PFN_vkGetInstanceProcAddr find)
{
    PFN_vkCreateInstance create = (PFN_vkCreateInstance)find(NULL, "vkCreateInstance");
    VkApplicationInfo application = {
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "seaway", .apiVersion = VK_API_VERSION_1_3};
    VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    VkInstance instance = VK_NULL_HANDLE;
    return create != NULL && create(&info, NULL, &instance) == VK_SUCCESS ? instance : VK_NULL_HANDLE;
}

static void PrintDevice(Json* json, int index, const VkPhysicalDeviceProperties* properties, bool isUsable,
                        const char* missing)
{
    char version[32];
    snprintf(version, sizeof(version), "%u.%u.%u", VK_API_VERSION_MAJOR(properties->apiVersion),
             VK_API_VERSION_MINOR(properties->apiVersion), VK_API_VERSION_PATCH(properties->apiVersion));
    if (json == NULL)
    {
        printf("%d  %s, %s, Vulkan %s: %s%s\n", index, properties->deviceName, GetTypeName(properties->deviceType),
               version, isUsable ? "usable" : "lacks ", isUsable ? "" : missing);
        return;
    }
    JsonOpenObject(json, NULL);
    JsonInteger(json, "index", index);
    JsonText(json, "name", properties->deviceName);
    JsonText(json, "type", GetTypeName(properties->deviceType));
    JsonText(json, "vulkan", version);
    JsonFlag(json, "usable", isUsable);
    JsonText(json, "missing", isUsable ? NULL : missing);
    JsonCloseObject(json);
}

// Prints all devices; returns how many are usable.
static int PrintDevices(Json* json, PFN_vkGetInstanceProcAddr find, VkInstance instance, const VulkanCalls* calls)
{
    uint32_t count = MAX_DEVICES;
    VkPhysicalDevice devices[MAX_DEVICES];
    VkResult result = calls->EnumeratePhysicalDevices(instance, &count, devices);
    count = result == VK_SUCCESS || result == VK_INCOMPLETE ? count : 0;
    int usableCount = 0;
    for (uint32_t i = 0; i < count; ++i)
    {
        VkPhysicalDeviceProperties properties;
        calls->GetPhysicalDeviceProperties(devices[i], &properties);
        char missing[1024] = "";
        bool isUsable = swGpu_CheckDevice(find, instance, devices[i], missing, sizeof(missing));
        usableCount += isUsable;
        PrintDevice(json, (int)i, &properties, isUsable, missing);
    }
    return usableCount;
}

int RunDevices(int argumentCount, char** arguments)
{
    bool asJson = false;
    const Option options[] = {{.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"}};
    const Verb verb = {.name = "devices",
                       .synopsis = "[--json]",
                       .text = "List the Vulkan devices of this machine in Vulkan's order, the one that --device INDEX "
                               "counts,\nand what each of them lacks. Exit code 1 if none is usable.",
                       .options = options,
                       .optionCount = 1};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    PFN_vkGetInstanceProcAddr find = FindVulkanLoader();
    if (find == NULL)
    {
        Complain("this machine has no Vulkan loader (libvulkan.so.1); Debian's package libvulkan1 has it");
        return EXIT_PROBLEM;
    }
    VulkanCalls calls = {0};
    VkInstance instance = CreateInstance(find);
    if (instance == VK_NULL_HANDLE || !LoadInstanceCalls(&calls, instance))
    {
        Complain("no Vulkan driver is installed; Debian's package mesa-vulkan-drivers has a software one");
        return EXIT_PROBLEM;
    }
    Json json = OpenJson(stdout);
    if (asJson)
    {
        JsonOpenObject(&json, NULL);
        JsonOpenArray(&json, "devices");
    }
    int usableCount = PrintDevices(asJson ? &json : NULL, find, instance, &calls);
    if (asJson)
    {
        JsonCloseArray(&json);
        JsonCloseObject(&json);
    }
    calls.DestroyInstance(instance, NULL);
    if (usableCount == 0)
    {
        Complain("no Vulkan device here is usable");
    }
    return FinishOutput() && usableCount > 0 ? EXIT_FINE : EXIT_PROBLEM;
}
