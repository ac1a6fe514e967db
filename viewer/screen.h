// SPDX-License-Identifier: MIT
#pragma once

// The window's side of Vulkan: surface and swapchain; the device and frames in flight are the stage's. The swapchain is
// UNORM and receives a picture that is already encoded as sRGB, so one path serves every surface.

#include <stdbool.h>

#include "seaway/stage.h"

struct GLFWwindow;

#define FRAMES_IN_FLIGHT 2
#define MAX_SWAPCHAIN_IMAGES 8

// Whether a call succeeded; if not, a sentence says what the viewer was doing.
bool CheckVulkan(VkResult result, const char* what);

typedef struct Screen
{
    swStage* stage;
    const swStageVk* vk;
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    struct GLFWwindow* window;
    bool enableVsync;

    VkSurfaceKHR surface;
    VkSwapchainKHR swapchain;
    VkExtent2D windowExtent; // what the window measured when the swapchain was made
    VkExtent2D extent;       // of its images, pixels
    uint32_t imageCount;
    VkImage images[MAX_SWAPCHAIN_IMAGES];
    VkSemaphore isDrawn[MAX_SWAPCHAIN_IMAGES]; // one per image: presenting may still wait on it when a frame is done

    VkSemaphore isAcquired[FRAMES_IN_FLIGHT];
    uint32_t imageIndex;
} Screen;

typedef enum ScreenStatus
{
    SCREEN_READY,
    SCREEN_HIDDEN,  // minimised: nothing to draw to
    SCREEN_CHANGED, // made anew: targets must follow `extent`, the frame is skipped
    SCREEN_FAILED
} ScreenStatus;

bool OpenScreen(Screen* screen, swStage* stage, struct GLFWwindow* window, bool enableVsync);
void CloseScreen(Screen* screen);

// Wait for a frame in flight and take the next image; `frame` is then ready to record.
ScreenStatus BeginScreenFrame(Screen* screen, swStageFrame* frame);

// Submit what was recorded and show the image.
ScreenStatus EndScreenFrame(Screen* screen, const swStageFrame* frame);
