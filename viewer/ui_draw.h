// SPDX-License-Identifier: MIT
#pragma once

// Draws the panel's mesh into a picture that holds sRGB bytes.

#include "screen.h"
#include "ui.h"

typedef struct UiDrawer
{
    swStage* stage;
    const swStageVk* vk;
    VkDevice device;
    swStageImage atlas;
    VkSampler sampler;
    VkDescriptorSetLayout setLayout;
    VkDescriptorPool pool;
    VkDescriptorSet set;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    swStageBuffer vertices[FRAMES_IN_FLIGHT];
    swStageBuffer indices[FRAMES_IN_FLIGHT];
} UiDrawer;

// `format` is the target's, UNORM. Uploads the atlas and waits for it.
bool OpenUiDrawer(UiDrawer* drawer, swStage* stage, VkFormat format);

// The device must be idle.
void CloseUiDrawer(UiDrawer* drawer);

// Inside rendering to a target of `extent` pixels; the slot's last frame must be done.
bool DrawUi(UiDrawer* drawer, VkCommandBuffer commands, int slot, const UiMesh* mesh, VkExtent2D extent);
