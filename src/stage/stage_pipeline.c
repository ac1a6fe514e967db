// SPDX-License-Identifier: MIT
// Pipelines of what the stage draws by itself: land and lines.

#include "stage/stage_base.h"

static VkResult createModule(const swStage* stage, const uint32_t* code, size_t size, VkShaderModule* module)
{
    const VkShaderModuleCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = size, .pCode = code};
    return stage->vk.CreateShaderModule(stage->device, &info, NULL, module);
}

VkResult swCreateStageLayout(const swStage* stage, uint32_t bindingCount, const VkDescriptorSetLayoutBinding* bindings,
                             uint32_t pushSize, VkDescriptorSetLayout* setLayout, VkPipelineLayout* layout)
{
    const VkDescriptorSetLayoutCreateInfo setInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR,
        .bindingCount = bindingCount,
        .pBindings = bindings,
    };
    VkResult result = stage->vk.CreateDescriptorSetLayout(stage->device, &setInfo, NULL, setLayout);
    if (result != VK_SUCCESS)
    {
        return result;
    }
    const VkPushConstantRange range = {VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, pushSize};
    const VkPipelineLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
        .setLayoutCount = 1,
        .pSetLayouts = setLayout,
        .pushConstantRangeCount = 1,
        .pPushConstantRanges = &range,
    };
    return stage->vk.CreatePipelineLayout(stage->device, &info, NULL, layout);
}

static VkResult createPipeline(const swStage* stage, const swStagePipelineDef* def, VkShaderModule vertex,
                               VkShaderModule fragment, VkPipeline* pipeline)
{
    const VkBool32 hasDepth = def->depthFormat != VK_FORMAT_UNDEFINED ? VK_TRUE : VK_FALSE;
    const VkPipelineShaderStageCreateInfo stages[2] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex,
         .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment,
         .pName = "main"},
    };
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = def->topology};
    const VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1.0f};
    const VkPipelineMultisampleStateCreateInfo samples = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT,
    };
    const VkPipelineDepthStencilStateCreateInfo depth = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = hasDepth,
        .depthWriteEnable = hasDepth,
        .depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL,
    };
    const VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1,
        .pAttachments = &def->blend,
    };
    const VkDynamicState dynamicStates[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = dynamicStates,
    };
    const VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1,
        .pColorAttachmentFormats = &def->colorFormat,
        .depthAttachmentFormat = def->depthFormat,
    };
    const VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .stageCount = 2,
        .pStages = stages,
        .pVertexInputState = &def->input,
        .pInputAssemblyState = &assembly,
        .pViewportState = &viewport,
        .pRasterizationState = &raster,
        .pMultisampleState = &samples,
        .pDepthStencilState = &depth,
        .pColorBlendState = &blend,
        .pDynamicState = &dynamic,
        .layout = def->layout,
    };
    return stage->vk.CreateGraphicsPipelines(stage->device, VK_NULL_HANDLE, 1, &info, NULL, pipeline);
}

VkResult swCreateStagePipeline(const swStage* stage, const swStagePipelineDef* def, VkPipeline* pipeline)
{
    VkShaderModule vertex = VK_NULL_HANDLE, fragment = VK_NULL_HANDLE;
    VkResult result = createModule(stage, def->vertex, def->vertexSize, &vertex);
    result = result != VK_SUCCESS ? result : createModule(stage, def->fragment, def->fragmentSize, &fragment);
    result = result != VK_SUCCESS ? result : createPipeline(stage, def, vertex, fragment, pipeline);
    stage->vk.DestroyShaderModule(stage->device, vertex, NULL);
    stage->vk.DestroyShaderModule(stage->device, fragment, NULL);
    return result;
}
