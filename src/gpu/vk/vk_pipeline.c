// SPDX-License-Identifier: MIT
#include "gpu/vk/vk_pipeline.h"

#include "core/base/assert.h"
#include "gpu/vk/vk_device.h"

typedef struct Constants
{
    VkSpecializationMapEntry entries[SW_MAX_CONSTANTS];
    VkSpecializationInfo info;
} Constants;

// A shader that wants more than there is room for is a mistake in the caller.
static swResult checkShader(const swGpu* gpu, const swShader* shader, const void* constants)
{
    bool isGood = shader->bindingCount <= SW_MAX_BINDINGS && shader->pushSize <= SW_MAX_PUSH_BYTES &&
                  shader->constantCount <= SW_MAX_CONSTANTS && (shader->constantCount == 0) == (constants == NULL);
    SW_ASSERT(isGood);
    return isGood ? SW_SUCCESS
                  : swFail(&gpu->host, SW_ERROR_INVALID,
                           "the pipeline %s has %u bindings, %u bytes of push constants and %u constants, %s; the most "
                           "are %d, %d and %d",
                           shader->name, shader->bindingCount, shader->pushSize, shader->constantCount,
                           constants != NULL ? "given" : "not given", SW_MAX_BINDINGS, SW_MAX_PUSH_BYTES,
                           SW_MAX_CONSTANTS);
}

static void fillConstants(const swShader* shader, const void* values, Constants* out)
{
    for (uint32_t i = 0; i < shader->constantCount; ++i)
    {
        out->entries[i] =
            (VkSpecializationMapEntry){shader->constantIds[i], i * (uint32_t)sizeof(uint32_t), sizeof(uint32_t)};
    }
    out->info = (VkSpecializationInfo){
        .mapEntryCount = shader->constantCount,
        .pMapEntries = out->entries,
        .dataSize = shader->constantCount * sizeof(uint32_t),
        .pData = values,
    };
}

static VkResult createModule(swGpu* gpu, const swShader* shader, VkShaderModule* module)
{
    const VkShaderModuleCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
        .codeSize = shader->size,
        .pCode = shader->words,
    };
    return gpu->vk.CreateShaderModule(gpu->device, &info, NULL, module);
}

static VkResult createLayouts(swGpu* gpu, swPipeline* pipeline)
{
    const swShader* shader = pipeline->shader;
    VkDescriptorSetLayoutBinding bindings[SW_MAX_BINDINGS];
    for (uint32_t i = 0; i < shader->bindingCount; ++i)
    {
        bindings[i] = (VkDescriptorSetLayoutBinding){
            .binding = shader->bindings[i].number,
            .descriptorType = shader->bindings[i].type,
            .descriptorCount = 1,
            .stageFlags = pipeline->stages,
        };
    }
    const VkDescriptorSetLayoutCreateInfo setInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR,
        .bindingCount = shader->bindingCount,
        .pBindings = bindings,
    };
    VkResult result = gpu->vk.CreateDescriptorSetLayout(gpu->device, &setInfo, NULL, &pipeline->setLayout);
    if (result != VK_SUCCESS)
    {
        return result;
    }
    const VkPushConstantRange range = {.stageFlags = pipeline->stages, .size = shader->pushSize};
    const VkPipelineLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
        .setLayoutCount = 1,
        .pSetLayouts = &pipeline->setLayout,
        .pushConstantRangeCount = shader->pushSize > 0 ? 1 : 0,
        .pPushConstantRanges = &range,
    };
    return gpu->vk.CreatePipelineLayout(gpu->device, &info, NULL, &pipeline->layout);
}

static swResult finishPipeline(swGpu* gpu, VkResult result, const char* name, swPipeline* pipeline)
{
    if (result != VK_SUCCESS)
    {
        swDestroyPipeline(gpu, pipeline);
        return swCheckVk(gpu, result, name);
    }
    swNameObject(gpu, VK_OBJECT_TYPE_PIPELINE, (uint64_t)pipeline->handle, name);
    return SW_SUCCESS;
}

swResult swCreateComputePipeline(swGpu* gpu, const swShader* shader, const void* values, swPipeline* pipeline)
{
    *pipeline = (swPipeline){
        .bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE,
        .stages = VK_SHADER_STAGE_COMPUTE_BIT,
        .shader = shader,
    };
    swResult checked = checkShader(gpu, shader, values);
    if (checked != SW_SUCCESS)
    {
        return checked;
    }
    Constants constants;
    fillConstants(shader, values, &constants);
    VkShaderModule module = VK_NULL_HANDLE;
    VkResult result = createLayouts(gpu, pipeline);
    result = result == VK_SUCCESS ? createModule(gpu, shader, &module) : result;
    if (result == VK_SUCCESS)
    {
        const VkComputePipelineCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
            .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                      .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                      .module = module,
                      .pName = "main",
                      .pSpecializationInfo = &constants.info},
            .layout = pipeline->layout,
        };
        result = gpu->vk.CreateComputePipelines(gpu->device, gpu->pipelineCache, 1, &info, NULL, &pipeline->handle);
    }
    gpu->vk.DestroyShaderModule(gpu->device, module, NULL);
    return finishPipeline(gpu, result, shader->name, pipeline);
}

static VkPipelineColorBlendAttachmentState blendState(swBlend blend)
{
    VkPipelineColorBlendAttachmentState state = {
        .blendEnable = blend != SW_DRAWS_OVER,
        .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
        .dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
        .colorBlendOp = VK_BLEND_OP_ADD,
        .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
        .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
        .alphaBlendOp = VK_BLEND_OP_ADD,
        .colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT,
    };
    if (blend == SW_DRAWS_ALPHA)
    {
        state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    }
    if (blend == SW_DRAWS_ADDED)
    {
        state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
        state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    }
    return state;
}

// The fixed state, and the call. Modules exist; fragment may be null.
static VkResult createGraphics(swGpu* gpu, const swGraphicsDef* def, VkShaderModule vertex, VkShaderModule fragment,
                               const VkSpecializationInfo* constants, swPipeline* pipeline)
{
    const VkPipelineShaderStageCreateInfo stages[2] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex,
         .pName = "main",
         .pSpecializationInfo = constants},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment,
         .pName = "main",
         .pSpecializationInfo = constants},
    };
    const VkPipelineVertexInputStateCreateInfo input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
    };
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = def->topology,
    };
    const VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1,
    };
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .polygonMode = gpu->hasWireframe ? def->polygonMode : VK_POLYGON_MODE_FILL,
        .cullMode = def->cullMode,
        .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
        .lineWidth = 1.0f,
    };
    const VkPipelineMultisampleStateCreateInfo samples = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT,
    };
    const VkPipelineDepthStencilStateCreateInfo depth = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = def->depthCompare != VK_COMPARE_OP_NEVER,
        .depthWriteEnable = def->depthWrite,
        .depthCompareOp = def->depthCompare,
    };
    bool hasColor = def->colorFormat != VK_FORMAT_UNDEFINED;
    const VkPipelineColorBlendAttachmentState attachment = blendState(def->blend);
    const VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = hasColor ? 1 : 0,
        .pAttachments = &attachment,
    };
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = states,
    };
    const VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = hasColor ? 1 : 0,
        .pColorAttachmentFormats = &def->colorFormat,
        .depthAttachmentFormat = def->depthFormat,
    };
    const VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .stageCount = fragment != VK_NULL_HANDLE ? 2 : 1,
        .pStages = stages,
        .pVertexInputState = &input,
        .pInputAssemblyState = &assembly,
        .pViewportState = &viewport,
        .pRasterizationState = &raster,
        .pMultisampleState = &samples,
        .pDepthStencilState = &depth,
        .pColorBlendState = &blend,
        .pDynamicState = &dynamic,
        .layout = pipeline->layout,
    };
    return gpu->vk.CreateGraphicsPipelines(gpu->device, gpu->pipelineCache, 1, &info, NULL, &pipeline->handle);
}

swResult swCreateGraphicsPipeline(swGpu* gpu, const swGraphicsDef* def, swPipeline* pipeline)
{
    *pipeline = (swPipeline){
        .bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
        .stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
        .shader = def->vertex,
    };
    swResult checked = checkShader(gpu, def->vertex, def->constants);
    if (checked != SW_SUCCESS)
    {
        return checked;
    }
    Constants constants;
    fillConstants(def->vertex, def->constants, &constants);
    VkShaderModule vertex = VK_NULL_HANDLE, fragment = VK_NULL_HANDLE;
    VkResult result = createLayouts(gpu, pipeline);
    result = result == VK_SUCCESS ? createModule(gpu, def->vertex, &vertex) : result;
    if (result == VK_SUCCESS && def->fragment != NULL)
    {
        result = createModule(gpu, def->fragment, &fragment);
    }
    result = result == VK_SUCCESS ? createGraphics(gpu, def, vertex, fragment, &constants.info, pipeline) : result;
    gpu->vk.DestroyShaderModule(gpu->device, vertex, NULL);
    gpu->vk.DestroyShaderModule(gpu->device, fragment, NULL);
    return finishPipeline(gpu, result, def->name, pipeline);
}

void swDestroyPipeline(swGpu* gpu, swPipeline* pipeline)
{
    gpu->vk.DestroyPipeline(gpu->device, pipeline->handle, NULL);
    gpu->vk.DestroyPipelineLayout(gpu->device, pipeline->layout, NULL);
    gpu->vk.DestroyDescriptorSetLayout(gpu->device, pipeline->setLayout, NULL);
    *pipeline = (swPipeline){0};
}

swBinding swBindBuffer(const swBuffer* buffer)
{
    return (swBinding){.buffer = buffer->handle};
}

swBinding swBindUpload(const swUpload* upload)
{
    return (swBinding){.buffer = upload->buffer, .offset = upload->offset, .range = upload->size};
}

swBinding swBindImage(const swGpu* gpu, const swImage* image, swSamplerKind sampler)
{
    return swBindView(gpu, image->view, image->layout, sampler);
}

swBinding swBindView(const swGpu* gpu, VkImageView view, VkImageLayout layout, swSamplerKind sampler)
{
    return (swBinding){.view = view, .layout = layout, .sampler = gpu->samplers[sampler]};
}

static bool isImageType(VkDescriptorType type)
{
    return type == VK_DESCRIPTOR_TYPE_SAMPLER || type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER ||
           type == VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE || type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

void swBindPipeline(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swBinding* bindings,
                    const void* push)
{
    VkWriteDescriptorSet writes[SW_MAX_BINDINGS];
    VkDescriptorBufferInfo buffers[SW_MAX_BINDINGS];
    VkDescriptorImageInfo images[SW_MAX_BINDINGS];
    const swShader* shader = pipeline->shader;
    for (uint32_t i = 0; i < shader->bindingCount; ++i)
    {
        const swBinding* binding = &bindings[i];
        bool isImage = isImageType(shader->bindings[i].type);
        SW_ASSERT(isImage ? binding->view != VK_NULL_HANDLE : binding->buffer != VK_NULL_HANDLE); // was left out
        buffers[i] = (VkDescriptorBufferInfo){binding->buffer, binding->offset,
                                              binding->range > 0 ? binding->range : VK_WHOLE_SIZE};
        images[i] = (VkDescriptorImageInfo){binding->sampler, binding->view, binding->layout};
        writes[i] = (VkWriteDescriptorSet){
            .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
            .dstBinding = shader->bindings[i].number,
            .descriptorCount = 1,
            .descriptorType = shader->bindings[i].type,
            .pImageInfo = isImage ? &images[i] : NULL,
            .pBufferInfo = isImage ? NULL : &buffers[i],
        };
    }
    gpu->vk.CmdBindPipeline(commands, pipeline->bindPoint, pipeline->handle);
    if (shader->bindingCount > 0)
    {
        gpu->vk.CmdPushDescriptorSetKHR(commands, pipeline->bindPoint, pipeline->layout, 0, shader->bindingCount,
                                        writes);
    }
    if (shader->pushSize > 0)
    {
        gpu->vk.CmdPushConstants(commands, pipeline->layout, pipeline->stages, 0, shader->pushSize, push);
    }
}
