// SPDX-License-Identifier: MIT
#pragma once

// What the files of the stage share.

#include "core/base/misuse.h"
#include "seaway/lines.h"

#define SW_STAGE_MAX_SLOTS 4

// The commands of one frame in flight.
typedef struct swStageSlot
{
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkFence isDone;
    bool isSubmitted; // and not waited for
    uint64_t index;   // of the frame
} swStageSlot;

struct swStage
{
    swHost host;
    swGpu* gpu;
    swStageVk vk;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    VkPhysicalDeviceProperties properties;
    VkPhysicalDeviceMemoryProperties memory;
    uint64_t nextIndex;
    bool isRecording; // between beginning a frame and submitting or dropping it
    int slotCount;
    swStageSlot slots[SW_STAGE_MAX_SLOTS];
};

// A sentence in the log and the swResult that a VkResult means; VK_SUCCESS gives SW_SUCCESS.
swResult swCheckStage(const swStage* stage, VkResult result, const char* what);

// Whether the prepared shot shows any of it; `terrain` may be NULL.
bool swIsTerrainSeen(const swStageTerrain* terrain);
// Inside of rendering to targets of a picture's default formats.
void swDrawTerrain(const swStageTerrain* terrain, VkCommandBuffer commands, const swPicture* picture);

// What differs between the stage's pipelines; viewport and scissor are dynamic, and nothing is culled.
typedef struct swStagePipelineDef
{
    const uint32_t *vertex, *fragment; // SPIR-V
    size_t vertexSize, fragmentSize;   // bytes
    VkPipelineLayout layout;
    VkPipelineVertexInputStateCreateInfo input;
    VkPrimitiveTopology topology;
    VkPipelineColorBlendAttachmentState blend;
    VkFormat colorFormat;
    VkFormat depthFormat; // undefined: depth is neither tested nor written; else what is nearer stays
} swStagePipelineDef;

VkResult swCreateStagePipeline(const swStage* stage, const swStagePipelineDef* def, VkPipeline* pipeline);

// One set that is pushed, and push constants of both shaders.
VkResult swCreateStageLayout(const swStage* stage, uint32_t bindingCount, const VkDescriptorSetLayoutBinding* bindings,
                             uint32_t pushSize, VkDescriptorSetLayout* setLayout, VkPipelineLayout* layout);

// NULL for NULL.
const swHost* swFindLinesHost(const swStageLines* lines);

swResult swCreateStageSlots(swStage* stage, int count);
void swDestroyStageSlots(swStage* stage);
