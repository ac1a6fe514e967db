// SPDX-License-Identifier: MIT
// Why not Dear ImGui's own Vulkan backend: the packaged one links the loader, so that not even `seaway query` would
// start on a machine without Vulkan, needs a render pass object, and writes encoded colours into whatever target it
// gets, which washes them out on an sRGB one.

#include "ui_draw.h"

#include <stddef.h>
#include <string.h>

static const uint32_t vertexCode[] =
#include "ui.vert.inc"
    ;
static const uint32_t fragmentCode[] =
#include "ui.frag.inc"
    ;

static VkResult CreateModule(const UiDrawer* drawer, const uint32_t* code, size_t size, VkShaderModule* module)
{
    VkShaderModuleCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = size, .pCode = code};
    return drawer->vk->CreateShaderModule(drawer->device, &info, NULL, module);
}

static VkResult CreateLayouts(UiDrawer* drawer)
{
    VkDescriptorSetLayoutBinding binding = {
        .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        .descriptorCount = 1,
        .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT,
        .pImmutableSamplers = &drawer->sampler,
    };
    VkDescriptorSetLayoutCreateInfo setInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 1, .pBindings = &binding};
    VkResult result = drawer->vk->CreateDescriptorSetLayout(drawer->device, &setInfo, NULL, &drawer->setLayout);
    if (result != VK_SUCCESS)
    {
        return result;
    }
    VkPushConstantRange range = {VK_SHADER_STAGE_VERTEX_BIT, 0, 2 * sizeof(float)};
    VkPipelineLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
        .setLayoutCount = 1,
        .pSetLayouts = &drawer->setLayout,
        .pushConstantRangeCount = 1,
        .pPushConstantRanges = &range,
    };
    return drawer->vk->CreatePipelineLayout(drawer->device, &info, NULL, &drawer->layout);
}

static VkResult CreateSet(UiDrawer* drawer)
{
    VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
    VkDescriptorPoolCreateInfo poolInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    VkResult result = drawer->vk->CreateDescriptorPool(drawer->device, &poolInfo, NULL, &drawer->pool);
    if (result != VK_SUCCESS)
    {
        return result;
    }
    VkDescriptorSetAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
        .descriptorPool = drawer->pool,
        .descriptorSetCount = 1,
        .pSetLayouts = &drawer->setLayout,
    };
    result = drawer->vk->AllocateDescriptorSets(drawer->device, &info, &drawer->set);
    if (result != VK_SUCCESS)
    {
        return result;
    }
    VkDescriptorImageInfo image = {.imageView = drawer->atlas.view,
                                   .imageLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write = {
        .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
        .dstSet = drawer->set,
        .descriptorCount = 1,
        .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        .pImageInfo = &image,
    };
    drawer->vk->UpdateDescriptorSets(drawer->device, 1, &write, 0, NULL);
    return VK_SUCCESS;
}

// Everything of the pipeline but its two modules.
static VkResult CreatePipeline(UiDrawer* drawer, VkFormat format, VkShaderModule vertex, VkShaderModule fragment)
{
    VkPipelineShaderStageCreateInfo stages[2] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex,
         .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment,
         .pName = "main"},
    };
    VkVertexInputBindingDescription binding = {0, sizeof(UiVertex), VK_VERTEX_INPUT_RATE_VERTEX};
    VkVertexInputAttributeDescription attributes[3] = {
        {0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(UiVertex, position)},
        {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(UiVertex, uv)},
        {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(UiVertex, color)},
    };
    VkPipelineVertexInputStateCreateInfo input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
        .vertexBindingDescriptionCount = 1,
        .pVertexBindingDescriptions = &binding,
        .vertexAttributeDescriptionCount = 3,
        .pVertexAttributeDescriptions = attributes,
    };
    VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
    };
    VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
    VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .polygonMode = VK_POLYGON_MODE_FILL,
        .cullMode = VK_CULL_MODE_NONE,
        .lineWidth = 1.0f,
    };
    VkPipelineMultisampleStateCreateInfo samples = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT,
    };
    VkPipelineColorBlendAttachmentState over = {
        .blendEnable = VK_TRUE,
        .srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA,
        .dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
        .colorBlendOp = VK_BLEND_OP_ADD,
        .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
        .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
        .alphaBlendOp = VK_BLEND_OP_ADD,
        .colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT,
    };
    VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO, .attachmentCount = 1, .pAttachments = &over};
    VkDynamicState dynamicStates[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = dynamicStates,
    };
    VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1,
        .pColorAttachmentFormats = &format,
    };
    VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .stageCount = 2,
        .pStages = stages,
        .pVertexInputState = &input,
        .pInputAssemblyState = &assembly,
        .pViewportState = &viewport,
        .pRasterizationState = &raster,
        .pMultisampleState = &samples,
        .pColorBlendState = &blend,
        .pDynamicState = &dynamic,
        .layout = drawer->layout,
    };
    return drawer->vk->CreateGraphicsPipelines(drawer->device, VK_NULL_HANDLE, 1, &info, NULL, &drawer->pipeline);
}

static VkResult CreateUiPipeline(UiDrawer* drawer, VkFormat format)
{
    VkShaderModule vertex = VK_NULL_HANDLE, fragment = VK_NULL_HANDLE;
    VkResult result = CreateModule(drawer, vertexCode, sizeof(vertexCode), &vertex);
    result = result ? result : CreateModule(drawer, fragmentCode, sizeof(fragmentCode), &fragment);
    result = result ? result : CreatePipeline(drawer, format, vertex, fragment);
    drawer->vk->DestroyShaderModule(drawer->device, vertex, NULL);
    drawer->vk->DestroyShaderModule(drawer->device, fragment, NULL);
    return result;
}

static void RecordUpload(const UiDrawer* drawer, VkCommandBuffer commands, VkBuffer source)
{
    const swStageImage* atlas = &drawer->atlas;
    VkBufferImageCopy region = {
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageExtent = {atlas->width, atlas->height, 1},
    };
    swStage_UseImage(drawer->stage, commands, atlas, SW_STAGE_USE_DISCARD, SW_STAGE_USE_COPY_TO);
    drawer->vk->CmdCopyBufferToImage(commands, source, atlas->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    swStage_UseImage(drawer->stage, commands, atlas, SW_STAGE_USE_COPY_TO, SW_STAGE_USE_SAMPLED);
}

static bool UploadAtlas(const UiDrawer* drawer, const uint8_t* pixels, VkDeviceSize size)
{
    swStageBuffer staging;
    if (swStage_CreateBuffer(drawer->stage, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, &staging) != SW_SUCCESS)
    {
        return false;
    }
    memcpy(staging.data, pixels, (size_t)size);
    swStageFrame frame;
    swResult result = swStage_BeginFrame(drawer->stage, &frame);
    if (result == SW_SUCCESS)
    {
        RecordUpload(drawer, frame.commands, staging.buffer);
        result = swStage_SubmitFrame(drawer->stage, &frame, NULL);
    }
    result = result == SW_SUCCESS ? swStage_Wait(drawer->stage) : result;
    swStage_DestroyBuffer(drawer->stage, &staging);
    return result == SW_SUCCESS;
}

static bool CreateAtlas(UiDrawer* drawer)
{
    int width = 0, height = 0;
    const uint8_t* pixels = GetUiAtlas(&width, &height);
    swStageImageDef def = {
        .name = "the panel's letters",
        .format = VK_FORMAT_R8_UNORM,
        .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        .width = (uint32_t)width,
        .height = (uint32_t)height,
    };
    VkDeviceSize size = (VkDeviceSize)width * (VkDeviceSize)height;
    if (swStage_CreateImage(drawer->stage, &def, &drawer->atlas) != SW_SUCCESS || !UploadAtlas(drawer, pixels, size))
    {
        return false;
    }
    VkSamplerCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
        .magFilter = VK_FILTER_LINEAR,
        .minFilter = VK_FILTER_LINEAR,
        .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
    };
    VkResult result = drawer->vk->CreateSampler(drawer->device, &info, NULL, &drawer->sampler);
    return CheckVulkan(result, "sample the panel's letters");
}

bool OpenUiDrawer(UiDrawer* drawer, swStage* stage, VkFormat format)
{
    *drawer = (UiDrawer){.stage = stage, .vk = swStage_GetVk(stage), .device = swGpu_GetDevice(swStage_GetGpu(stage))};
    if (!CreateAtlas(drawer))
    {
        return false;
    }
    VkResult result = CreateLayouts(drawer);
    result = result ? result : CreateSet(drawer);
    result = result ? result : CreateUiPipeline(drawer, format);
    return CheckVulkan(result, "prepare the panel");
}

void CloseUiDrawer(UiDrawer* drawer)
{
    if (drawer->stage == NULL)
    {
        return;
    }
    for (int i = 0; i < FRAMES_IN_FLIGHT; i++)
    {
        swStage_DestroyBuffer(drawer->stage, &drawer->vertices[i]);
        swStage_DestroyBuffer(drawer->stage, &drawer->indices[i]);
    }
    drawer->vk->DestroyPipeline(drawer->device, drawer->pipeline, NULL);
    drawer->vk->DestroyPipelineLayout(drawer->device, drawer->layout, NULL);
    drawer->vk->DestroyDescriptorPool(drawer->device, drawer->pool, NULL);
    drawer->vk->DestroyDescriptorSetLayout(drawer->device, drawer->setLayout, NULL);
    drawer->vk->DestroySampler(drawer->device, drawer->sampler, NULL);
    swStage_DestroyImage(drawer->stage, &drawer->atlas);
    *drawer = (UiDrawer){0};
}

// Grow by half more than is needed, so that a panel that unfolds does not grow it every frame.
static bool Reserve(swStage* stage, swStageBuffer* buffer, VkDeviceSize size, VkBufferUsageFlags usage)
{
    if (size <= buffer->size)
    {
        return true;
    }
    swStage_DestroyBuffer(stage, buffer);
    return swStage_CreateBuffer(stage, size + size / 2, usage, buffer) == SW_SUCCESS;
}

static void DrawCommand(const UiDrawer* drawer, VkCommandBuffer commands, const UiCommand* command, VkExtent2D extent)
{
    float left = command->clip[0] > 0.0f ? command->clip[0] : 0.0f;
    float top = command->clip[1] > 0.0f ? command->clip[1] : 0.0f;
    float right = command->clip[2] < (float)extent.width ? command->clip[2] : (float)extent.width;
    float bottom = command->clip[3] < (float)extent.height ? command->clip[3] : (float)extent.height;
    if (right <= left || bottom <= top)
    {
        return;
    }
    VkRect2D scissor = {{(int32_t)left, (int32_t)top}, {(uint32_t)(right - left), (uint32_t)(bottom - top)}};
    drawer->vk->CmdSetScissor(commands, 0, 1, &scissor);
    drawer->vk->CmdDrawIndexed(commands, command->indexCount, 1, command->firstIndex, command->vertexOffset, 0);
}

bool DrawUi(UiDrawer* drawer, VkCommandBuffer commands, int slot, const UiMesh* mesh, VkExtent2D extent)
{
    swStageBuffer* vertices = &drawer->vertices[slot];
    swStageBuffer* indices = &drawer->indices[slot];
    if (mesh->indexCount == 0 || mesh->width <= 0.0f || mesh->height <= 0.0f)
    {
        return true;
    }
    if (!Reserve(drawer->stage, vertices, mesh->vertexCount * sizeof(UiVertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT) ||
        !Reserve(drawer->stage, indices, mesh->indexCount * sizeof(uint16_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT))
    {
        return false;
    }
    CopyUiMesh(vertices->data, indices->data);
    VkDeviceSize offset = 0;
    float scale[2] = {2.0f / mesh->width, 2.0f / mesh->height};
    drawer->vk->CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, drawer->pipeline);
    drawer->vk->CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, drawer->layout, 0, 1, &drawer->set, 0,
                                      NULL);
    drawer->vk->CmdBindVertexBuffers(commands, 0, 1, &vertices->buffer, &offset);
    drawer->vk->CmdBindIndexBuffer(commands, indices->buffer, 0, VK_INDEX_TYPE_UINT16);
    drawer->vk->CmdPushConstants(commands, drawer->layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(scale), scale);
    for (int i = 0; i < mesh->commandCount; i++)
    {
        DrawCommand(drawer, commands, &mesh->commands[i], extent);
    }
    return true;
}
