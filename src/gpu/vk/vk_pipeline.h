// SPDX-License-Identifier: MIT
#pragma once

// Pipelines from embedded SPIR-V. Every pipeline has one descriptor set (set 0) that is pushed with each bind, push
// constants of at most 128 bytes, and specialisation constants 0 .. n - 1 of 32 bits.

#include "gpu/vk/vk_buffer.h"
#include "gpu/vk/vk_image.h"
#include "gpu/vk/vk_upload.h"

#define SW_MAX_BINDINGS 16
#define SW_MAX_PUSH_BYTES 128
#define SW_MAX_CONSTANTS 16

// SPIR-V words. In a .c file:
//   static const uint32_t slicesCode[] =
//   #include "slices.comp.inc"
//       ;
//   ... .shader = SW_SHADER(slicesCode)
typedef struct swShader
{
    const uint32_t* words;
    size_t size; // bytes
} swShader;
#define SW_SHADER(words) ((swShader){(words), sizeof(words)})

typedef struct swPipeline
{
    VkPipeline handle; // null if there is none
    VkPipelineLayout layout;
    VkDescriptorSetLayout setLayout;
    VkPipelineBindPoint bindPoint;
    VkShaderStageFlags stages;
    uint32_t bindingCount;
    VkDescriptorType types[SW_MAX_BINDINGS];
    uint32_t pushSize;
} swPipeline;

typedef struct swComputeDef
{
    swShader shader;
    uint32_t bindingCount; // binding b has types[b]
    VkDescriptorType types[SW_MAX_BINDINGS];
    uint32_t pushSize;
    uint32_t constantCount; // specialisation constants
    const uint32_t* constants;
    const char* name;
} swComputeDef;

// @return SW_ERROR_INVALID, and an assert, for more than the limits above; likewise below
swResult swCreateComputePipeline(swGpu* gpu, const swComputeDef* def, swPipeline* pipeline);

typedef enum swBlend
{
    SW_BLEND_NONE,
    SW_BLEND_ALPHA,         // source alpha over
    SW_BLEND_PREMULTIPLIED, // source + (1 - source alpha) destination
    SW_BLEND_ADD
} swBlend;

// Vertex-less: vertices come from gl_VertexIndex and storage buffers. Dynamic rendering, one colour target, viewport
// and scissor dynamic. Front faces are counter-clockwise as seen on the screen (y down:
// VK_FRONT_FACE_COUNTER_CLOCKWISE).
typedef struct swGraphicsDef
{
    swShader vertex, fragment; // fragment.words NULL: depth only
    uint32_t bindingCount;
    VkDescriptorType types[SW_MAX_BINDINGS]; // visible to both stages
    uint32_t pushSize;
    uint32_t constantCount;
    const uint32_t* constants;
    VkFormat colorFormat;         // VK_FORMAT_UNDEFINED: none
    VkFormat depthFormat;         // VK_FORMAT_UNDEFINED: none
    VkPrimitiveTopology topology; // 0 is a point list; give VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST
    VkPolygonMode polygonMode;    // 0 fills
    VkCullModeFlags cullMode;
    VkCompareOp depthCompare; // VK_COMPARE_OP_NEVER (0) turns the test off; reversed Z wants GREATER_OR_EQUAL
    bool depthWrite;
    swBlend blend;
    const char* name;
} swGraphicsDef;

swResult swCreateGraphicsPipeline(swGpu* gpu, const swGraphicsDef* def, swPipeline* pipeline);

// Clears the pipeline; null is allowed.
void swDestroyPipeline(swGpu* gpu, swPipeline* pipeline);

// What is bound at one binding; which members count follows from the binding's type.
typedef struct swBinding
{
    VkBuffer buffer;
    VkDeviceSize offset, range; // range 0: to the end
    VkImageView view;
    VkImageLayout layout;
    VkSampler sampler;
} swBinding;

swBinding swBindBuffer(const swBuffer* buffer);
swBinding swBindUpload(const swUpload* upload);
// Sampled with one of the fixed samplers, or as a storage image (the sampler is ignored then).
swBinding swBindImage(const swGpu* gpu, const swImage* image, swSamplerKind sampler);
swBinding swBindView(const swGpu* gpu, VkImageView view, VkImageLayout layout, swSamplerKind sampler);

// Bind the pipeline, push its descriptors (bindingCount of them) and its push constants (pushSize bytes; NULL if 0).
void swBindPipeline(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swBinding* bindings,
                    const void* push);
