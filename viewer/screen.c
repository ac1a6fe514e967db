// SPDX-License-Identifier: MIT
#include "screen.h"

#include <stdio.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

static const char* GetResultText(VkResult result)
{
    switch (result)
    {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_DEVICE_LOST:
        return "the device was lost";
    case VK_ERROR_SURFACE_LOST_KHR:
        return "the window's surface was lost";
    case VK_ERROR_NATIVE_WINDOW_IN_USE_KHR:
        return "the window is in use by another program";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialization failed";
    default:
        return "an error of Vulkan";
    }
}

bool CheckVulkan(VkResult result, const char* what)
{
    if (result >= 0)
    {
        return true;
    }
    fprintf(stderr, "seaway: the viewer could not %s: %s (VkResult %d)\n", what, GetResultText(result), (int)result);
    return false;
}

static bool CreateSurface(Screen* screen)
{
    VkResult result = glfwCreateWindowSurface(screen->instance, screen->window, NULL, &screen->surface);
    if (!CheckVulkan(result, "draw to the window"))
    {
        return false;
    }
    VkBool32 canPresent = VK_FALSE;
    screen->vk->GetPhysicalDeviceSurfaceSupportKHR(
        screen->physicalDevice, swGpu_GetQueueFamily(swStage_GetGpu(screen->stage)), screen->surface, &canPresent);
    if (!canPresent)
    {
        fprintf(stderr, "seaway: this device cannot show pictures in this window; try another with --device\n");
    }
    return canPresent;
}

// Prefers 8 bits; what is written is encoded already, so the format must not encode again.
static bool ChooseFormat(const Screen* screen, VkSurfaceFormatKHR* chosen)
{
    VkSurfaceFormatKHR formats[64];
    uint32_t count = 64;
    screen->vk->GetPhysicalDeviceSurfaceFormatsKHR(screen->physicalDevice, screen->surface, &count, formats);
    const VkFormat wanted[] = {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_A8B8G8R8_UNORM_PACK32,
                               VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_A2R10G10B10_UNORM_PACK32};
    for (size_t w = 0; w < sizeof(wanted) / sizeof(wanted[0]); w++)
    {
        for (uint32_t i = 0; i < count; i++)
        {
            if (formats[i].format == wanted[w] && formats[i].colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
            {
                *chosen = formats[i];
                return true;
            }
        }
    }
    fprintf(stderr, "seaway: the window offers no 8- or 10-bit UNORM format in the sRGB colour space\n");
    return false;
}

// Without vsync the newest frame replaces the waiting one, or, failing that, tears.
static VkPresentModeKHR ChoosePresentMode(const Screen* screen)
{
    VkPresentModeKHR modes[16];
    uint32_t count = 16;
    screen->vk->GetPhysicalDeviceSurfacePresentModesKHR(screen->physicalDevice, screen->surface, &count, modes);
    VkPresentModeKHR chosen = VK_PRESENT_MODE_FIFO_KHR;
    for (uint32_t i = 0; i < count && !screen->enableVsync; i++)
    {
        bool isBetter = modes[i] == VK_PRESENT_MODE_MAILBOX_KHR ||
                        (modes[i] == VK_PRESENT_MODE_IMMEDIATE_KHR && chosen == VK_PRESENT_MODE_FIFO_KHR);
        chosen = isBetter ? modes[i] : chosen;
    }
    return chosen;
}

static uint32_t Clamp(uint32_t value, uint32_t low, uint32_t high)
{
    return value < low ? low : value > high ? high : value;
}

static VkExtent2D GetWindowExtent(const Screen* screen)
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(screen->window, &width, &height);
    return (VkExtent2D){width > 0 ? (uint32_t)width : 0, height > 0 ? (uint32_t)height : 0};
}

// The surface's size, or the window's where the surface takes any.
static VkExtent2D ChooseExtent(const Screen* screen, const VkSurfaceCapabilitiesKHR* can)
{
    if (can->currentExtent.width != UINT32_MAX)
    {
        return can->currentExtent;
    }
    return (VkExtent2D){Clamp(screen->windowExtent.width, can->minImageExtent.width, can->maxImageExtent.width),
                        Clamp(screen->windowExtent.height, can->minImageExtent.height, can->maxImageExtent.height)};
}

static void DestroySwapchain(Screen* screen)
{
    for (uint32_t i = 0; i < MAX_SWAPCHAIN_IMAGES; i++)
    {
        screen->vk->DestroySemaphore(screen->device, screen->isDrawn[i], NULL);
        screen->isDrawn[i] = VK_NULL_HANDLE;
    }
    if (screen->swapchain != VK_NULL_HANDLE)
    {
        screen->vk->DestroySwapchainKHR(screen->device, screen->swapchain, NULL);
        screen->swapchain = VK_NULL_HANDLE;
    }
    screen->imageCount = 0;
}

static bool ListImages(Screen* screen)
{
    uint32_t count = 0;
    screen->vk->GetSwapchainImagesKHR(screen->device, screen->swapchain, &count, NULL);
    if (count > MAX_SWAPCHAIN_IMAGES)
    {
        fprintf(stderr, "seaway: the swapchain has %u images, more than the %d that the viewer handles\n", count,
                MAX_SWAPCHAIN_IMAGES);
        return false;
    }
    screen->imageCount = count;
    VkResult result = screen->vk->GetSwapchainImagesKHR(screen->device, screen->swapchain, &count, screen->images);
    VkSemaphoreCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    for (uint32_t i = 0; i < count && result == VK_SUCCESS; i++)
    {
        result = screen->vk->CreateSemaphore(screen->device, &info, NULL, &screen->isDrawn[i]);
    }
    return CheckVulkan(result, "list the swapchain's images");
}

static VkResult CreateSwapchain(Screen* screen, const VkSurfaceCapabilitiesKHR* can, VkSurfaceFormatKHR format)
{
    uint32_t most = can->maxImageCount > 0 ? can->maxImageCount : MAX_SWAPCHAIN_IMAGES;
    bool canBeOpaque = (can->supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0;
    VkSwapchainKHR old = screen->swapchain;
    VkSwapchainCreateInfoKHR info = {
        .sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
        .surface = screen->surface,
        .minImageCount = Clamp(can->minImageCount + 1, can->minImageCount, most),
        .imageFormat = format.format,
        .imageColorSpace = format.colorSpace,
        .imageExtent = screen->extent,
        .imageArrayLayers = 1,
        .imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        .preTransform = can->currentTransform,
        .compositeAlpha = canBeOpaque ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
        .presentMode = ChoosePresentMode(screen),
        .clipped = VK_TRUE,
        .oldSwapchain = old,
    };
    VkSwapchainKHR swapchain = VK_NULL_HANDLE;
    VkResult result = screen->vk->CreateSwapchainKHR(screen->device, &info, NULL, &swapchain);
    DestroySwapchain(screen);
    screen->swapchain = swapchain;
    return result;
}

// Make the swapchain anew for the window as it is now. The surface itself is renewed if it was lost.
static ScreenStatus RenewSwapchain(Screen* screen)
{
    if (!CheckVulkan(screen->vk->DeviceWaitIdle(screen->device), "wait for the device"))
    {
        return SCREEN_FAILED;
    }
    VkSurfaceCapabilitiesKHR can;
    VkResult result =
        screen->vk->GetPhysicalDeviceSurfaceCapabilitiesKHR(screen->physicalDevice, screen->surface, &can);
    if (result == VK_ERROR_SURFACE_LOST_KHR)
    {
        DestroySwapchain(screen);
        screen->vk->DestroySurfaceKHR(screen->instance, screen->surface, NULL);
        screen->surface = VK_NULL_HANDLE;
        if (!CreateSurface(screen))
        {
            return SCREEN_FAILED;
        }
        result = screen->vk->GetPhysicalDeviceSurfaceCapabilitiesKHR(screen->physicalDevice, screen->surface, &can);
    }
    if (!CheckVulkan(result, "ask the window's surface"))
    {
        return SCREEN_FAILED;
    }
    screen->windowExtent = GetWindowExtent(screen);
    screen->extent = ChooseExtent(screen, &can);
    if (screen->extent.width == 0 || screen->extent.height == 0)
    {
        return SCREEN_HIDDEN;
    }
    if ((can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) == 0)
    {
        fprintf(stderr, "seaway: the window's images cannot be copied to on this device\n");
        return SCREEN_FAILED;
    }
    VkSurfaceFormatKHR format;
    if (!ChooseFormat(screen, &format) || !CheckVulkan(CreateSwapchain(screen, &can, format), "make a swapchain") ||
        !ListImages(screen))
    {
        return SCREEN_FAILED;
    }
    return SCREEN_CHANGED;
}

static bool CreateSemaphores(Screen* screen)
{
    VkSemaphoreCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkResult result = VK_SUCCESS;
    for (int i = 0; i < FRAMES_IN_FLIGHT && result == VK_SUCCESS; i++)
    {
        result = screen->vk->CreateSemaphore(screen->device, &info, NULL, &screen->isAcquired[i]);
    }
    return CheckVulkan(result, "make semaphores");
}

bool OpenScreen(Screen* screen, swStage* stage, struct GLFWwindow* window, bool enableVsync)
{
    const swGpu* gpu = swStage_GetGpu(stage);
    *screen = (Screen){
        .stage = stage,
        .vk = swStage_GetVk(stage),
        .instance = swGpu_GetInstance(gpu),
        .physicalDevice = swGpu_GetPhysicalDevice(gpu),
        .device = swGpu_GetDevice(gpu),
        .window = window,
        .enableVsync = enableVsync,
    };
    return CreateSurface(screen) && CreateSemaphores(screen) && RenewSwapchain(screen) != SCREEN_FAILED;
}

void CloseScreen(Screen* screen)
{
    if (screen->stage == NULL)
    {
        return;
    }
    screen->vk->DeviceWaitIdle(screen->device);
    for (int i = 0; i < FRAMES_IN_FLIGHT; i++)
    {
        screen->vk->DestroySemaphore(screen->device, screen->isAcquired[i], NULL);
    }
    DestroySwapchain(screen);
    if (screen->surface != VK_NULL_HANDLE)
    {
        screen->vk->DestroySurfaceKHR(screen->instance, screen->surface, NULL);
    }
    *screen = (Screen){0};
}

static bool IsScreenGone(VkResult result)
{
    return result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_ERROR_SURFACE_LOST_KHR;
}

ScreenStatus BeginScreenFrame(Screen* screen, swStageFrame* frame)
{
    VkExtent2D size = GetWindowExtent(screen);
    if (size.width == 0 || size.height == 0)
    {
        return SCREEN_HIDDEN;
    }
    bool hasChanged = size.width != screen->windowExtent.width || size.height != screen->windowExtent.height;
    if (screen->swapchain == VK_NULL_HANDLE || hasChanged)
    {
        return RenewSwapchain(screen);
    }
    if (swStage_BeginFrame(screen->stage, frame) != SW_SUCCESS)
    {
        return SCREEN_FAILED;
    }
    VkResult result = screen->vk->AcquireNextImageKHR(screen->device, screen->swapchain, UINT64_MAX,
                                                      screen->isAcquired[frame->index % FRAMES_IN_FLIGHT],
                                                      VK_NULL_HANDLE, &screen->imageIndex);
    if (IsScreenGone(result))
    {
        swStage_DropFrame(screen->stage, frame);
        return RenewSwapchain(screen);
    }
    return CheckVulkan(result, "begin a frame") ? SCREEN_READY : SCREEN_FAILED;
}

ScreenStatus EndScreenFrame(Screen* screen, const swStageFrame* frame)
{
    const swStageSync sync = {
        .wait = screen->isAcquired[frame->index % FRAMES_IN_FLIGHT],
        .waitStages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
        .signal = screen->isDrawn[screen->imageIndex],
    };
    if (swStage_SubmitFrame(screen->stage, frame, &sync) != SW_SUCCESS)
    {
        return SCREEN_FAILED;
    }
    VkPresentInfoKHR info = {
        .sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
        .waitSemaphoreCount = 1,
        .pWaitSemaphores = &screen->isDrawn[screen->imageIndex],
        .swapchainCount = 1,
        .pSwapchains = &screen->swapchain,
        .pImageIndices = &screen->imageIndex,
    };
    VkResult result = screen->vk->QueuePresentKHR(swGpu_GetQueue(swStage_GetGpu(screen->stage)), &info);
    if (IsScreenGone(result) || result == VK_SUBOPTIMAL_KHR)
    {
        return RenewSwapchain(screen);
    }
    return CheckVulkan(result, "show a frame") ? SCREEN_READY : SCREEN_FAILED;
}
