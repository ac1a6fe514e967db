// SPDX-License-Identifier: MIT
#pragma once

// The window's side of Vulkan: surface, swapchain, frames in flight. The swapchain is UNORM and receives a picture that
// is already encoded as sRGB, so one path serves every surface.

#include "graphics.h"

struct GLFWwindow;

#define FRAMES_IN_FLIGHT 2
#define MAX_SWAPCHAIN_IMAGES 8

typedef struct FrameInFlight
{
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkFence isDone;
    VkSemaphore isAcquired;
} FrameInFlight;

typedef struct Screen
{
    const Graphics* graphics;
    struct GLFWwindow* window;
    bool enableVsync;

    VkSurfaceKHR surface;
    VkSwapchainKHR swapchain;
    VkExtent2D windowExtent; // what the window measured when the swapchain was made
    VkExtent2D extent;       // of its images, pixels
    uint32_t imageCount;
    VkImage images[MAX_SWAPCHAIN_IMAGES];
    VkSemaphore isDrawn[MAX_SWAPCHAIN_IMAGES]; // one per image: presenting may still wait on it when a frame is done

    FrameInFlight frames[FRAMES_IN_FLIGHT];
    uint32_t imageIndex;
} Screen;

typedef enum ScreenStatus
{
    SCREEN_READY,
    SCREEN_HIDDEN,  // minimised: nothing to draw to
    SCREEN_CHANGED, // made anew: targets must follow `extent`, the frame is skipped
    SCREEN_FAILED
} ScreenStatus;

bool OpenScreen(Screen* screen, const Graphics* graphics, struct GLFWwindow* window, bool enableVsync);
void CloseScreen(Screen* screen);

// Wait for the frame that used this slot and take the next image; `frame` is then ready to record.
ScreenStatus BeginScreenFrame(Screen* screen, uint64_t frameIndex, FrameInFlight** frame);

// Submit what was recorded and show the image.
ScreenStatus EndScreenFrame(Screen* screen, FrameInFlight* frame);
