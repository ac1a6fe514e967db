// SPDX-License-Identifier: MIT
#pragma once

// Pipelines from embedded SPIR-V. Every pipeline has one descriptor set (set 0) that is pushed with each bind, push
// constants of at most 128 bytes, and specialisation constants of 32 bits.

#include "gpu/vk/vk_buffer.h"
#include "gpu/vk/vk_image.h"
#include "gpu/vk/vk_upload.h"

#define SW_MAX_BINDINGS 25
#define SW_MAX_PUSH_BYTES 128
#define SW_MAX_CONSTANTS 16

// A shader as the build reflects it: scripts/reflect_spirv.py writes a header with one of these for every shader, a
// struct with a binding for each name, another with its specialisation constants, and a function that binds by them:
//   #include "foam_shader.h"
//   swCreateComputePipeline(gpu, &swFoamShader, NULL, &pipeline);
//   swBindFoam(gpu, commands, &pipeline, &(swFoamBindings){.slices = ...}, &push);
// The stages of a graphics pipeline share bindings and constants, so both have all of them.
typedef struct swShader
{
    const char* name;
    const uint32_t* words; // SPIR-V
    size_t size;           // bytes
    VkShaderStageFlags stage;
    uint32_t pushSize;
    uint32_t bindingCount; // ascending by number
    struct
    {
        uint32_t number;
        VkDescriptorType type;
    } bindings[SW_MAX_BINDINGS];
    uint32_t constantCount;
    uint32_t constantIds[SW_MAX_CONSTANTS]; // of the struct's members, in order
} swShader;

typedef struct swPipeline
{
    VkPipeline handle; // null if there is none
    VkPipelineLayout layout;
    VkDescriptorSetLayout setLayout;
    VkPipelineBindPoint bindPoint;
    VkShaderStageFlags stages;
    const swShader* shader; // whose bindings and push constants are the pipeline's
} swPipeline;

// `constants` is the shader's struct of specialisation constants, NULL if it has none.
// @return SW_ERROR_INVALID, and an assert, for more than the limits above; likewise below
swResult swCreateComputePipeline(swGpu* gpu, const swShader* shader, const void* constants, swPipeline* pipeline);

typedef enum swBlend
{
    SW_DRAWS_OVER,
    SW_DRAWS_ALPHA,         // source alpha over
    SW_DRAWS_PREMULTIPLIED, // source + (1 - source alpha) destination
    SW_DRAWS_ADDED
} swBlend;

// Vertex-less: vertices come from gl_VertexIndex and storage buffers. Dynamic rendering, one colour target, viewport
// and scissor dynamic. Front faces are counter-clockwise as seen on the screen (y down:
// VK_FRONT_FACE_COUNTER_CLOCKWISE).
typedef struct swGraphicsDef
{
    const swShader *vertex, *fragment; // fragment NULL: depth only. Both have the same bindings
    const void* constants;             // as above
    VkFormat colorFormat;              // VK_FORMAT_UNDEFINED: none
    VkFormat depthFormat;              // VK_FORMAT_UNDEFINED: none
    VkPrimitiveTopology topology;      // 0 is a point list; give VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST
    VkPolygonMode polygonMode;         // 0 fills
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

// Bind the pipeline, push its descriptors and its push constants. Headers of shaders call it with types of their own:
// `bindings` is the first of the struct's, of which none may be left out.
void swBindPipeline(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swBinding* bindings,
                    const void* push);
