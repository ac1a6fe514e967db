// SPDX-License-Identifier: MIT
// A pass of lines over the finished picture. The depth of the scene is read, not tested: it may have fewer pixels.

#include <string.h>

#include "core/base/host.h"
#include "seaway/lines.h"
#include "stage/stage_base.h"

static const uint32_t vertexCode[] =
#include "lines.vert.inc"
    ;
static const uint32_t fragmentCode[] =
#include "lines.frag.inc"
    ;

typedef struct swLine
{
    swPos from, to;
    uint8_t color[4];
} swLine;

// As lines.vert reads it.
typedef struct swLineVertex
{
    float position[3];
    uint8_t color[4];
} swLineVertex;

typedef struct swLinePush
{
    float clip[16];
    float perPixel[2];
} swLinePush;

struct swStageLines
{
    swStage* stage;
    int count;
    swLine* lines; // [SW_MAX_STAGE_LINES]
    VkSampler sampler;
    VkDescriptorSetLayout setLayout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    swStageBuffer vertices[SW_STAGE_MAX_SLOTS]; // of frames in flight
    int slot;
};

static VkResult createLayouts(swStageLines* lines)
{
    const VkDescriptorSetLayoutBinding binding = {.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                                  .descriptorCount = 1,
                                                  .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT};
    return swCreateStageLayout(lines->stage, 1, &binding, sizeof(swLinePush), &lines->setLayout, &lines->layout);
}

static VkResult createPipeline(swStageLines* lines)
{
    const VkVertexInputBindingDescription binding = {0, sizeof(swLineVertex), VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription attributes[2] = {
        {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(swLineVertex, position)},
        {1, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(swLineVertex, color)}};
    const swStagePipelineDef def = {
        .vertex = vertexCode,
        .fragment = fragmentCode,
        .vertexSize = sizeof(vertexCode),
        .fragmentSize = sizeof(fragmentCode),
        .layout = lines->layout,
        .input = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
                  .vertexBindingDescriptionCount = 1,
                  .pVertexBindingDescriptions = &binding,
                  .vertexAttributeDescriptionCount = 2,
                  .pVertexAttributeDescriptions = attributes},
        .topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST,
        .blend = {.blendEnable = VK_TRUE,
                  .srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA,
                  .dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                  .srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO,
                  .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                  .colorWriteMask = 15},
        .colorFormat = VK_FORMAT_R8G8B8A8_UNORM, // of the output's first view: sRGB bytes as they are
    };
    return swCreateStagePipeline(lines->stage, &def, &lines->pipeline);
}

static VkResult createObjects(swStageLines* lines)
{
    const swStage* stage = lines->stage;
    const VkSamplerCreateInfo nearest = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                         .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                         .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
    VkResult result = stage->vk.CreateSampler(stage->device, &nearest, NULL, &lines->sampler);
    result = result != VK_SUCCESS ? result : createLayouts(lines);
    return result != VK_SUCCESS ? result : createPipeline(lines);
}

swResult swStage_CreateLines(swStage* stage, swStageLines** lines)
{
    if (lines != NULL)
    {
        *lines = NULL;
    }
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_CreateLines() needs a stage");
    SW_REQUIRE(lines != NULL, SW_ERROR_INVALID, &stage->host, "swStage_CreateLines() needs a place for the lines");
    swStageLines* created = swAllocateZero(&stage->host, sizeof(*created));
    swLine* room = swAllocate(&stage->host, SW_MAX_STAGE_LINES * sizeof(*room));
    if (created == NULL || room == NULL)
    {
        swFree(&stage->host, created, created != NULL ? sizeof(*created) : 0);
        swFree(&stage->host, room, room != NULL ? SW_MAX_STAGE_LINES * sizeof(*room) : 0);
        return swFail(&stage->host, SW_ERROR_NO_MEMORY, "No memory for %d lines.", SW_MAX_STAGE_LINES);
    }
    created->stage = stage;
    created->lines = room;
    swResult result = swCheckStage(stage, createObjects(created), "making the pipeline of lines");
    for (int i = 0; i < SW_STAGE_MAX_SLOTS && result == SW_SUCCESS; ++i)
    {
        result = swStage_CreateBuffer(stage, 2 * SW_MAX_STAGE_LINES * sizeof(swLineVertex),
                                      VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, &created->vertices[i]);
    }
    if (result != SW_SUCCESS)
    {
        swStage_DestroyLines(stage, created);
        return result;
    }
    *lines = created;
    return SW_SUCCESS;
}

void swStage_DestroyLines(swStage* stage, swStageLines* lines)
{
    if (lines == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(stage == lines->stage, &lines->stage->host,
                    "swStage_DestroyLines() needs the stage that made the lines");
    stage->vk.DestroyPipeline(stage->device, lines->pipeline, NULL);
    stage->vk.DestroyPipelineLayout(stage->device, lines->layout, NULL);
    stage->vk.DestroyDescriptorSetLayout(stage->device, lines->setLayout, NULL);
    stage->vk.DestroySampler(stage->device, lines->sampler, NULL);
    for (int i = 0; i < SW_STAGE_MAX_SLOTS; ++i)
    {
        swStage_DestroyBuffer(stage, &lines->vertices[i]);
    }
    swFree(&stage->host, lines->lines, SW_MAX_STAGE_LINES * sizeof(swLine));
    swFree(&stage->host, lines, sizeof(*lines));
}

const swHost* swFindLinesHost(const swStageLines* lines)
{
    return lines != NULL ? &lines->stage->host : NULL;
}

void swStageLines_Clear(swStageLines* lines)
{
    SW_REQUIRE_VOID(lines != NULL, NULL, "swStageLines_Clear() needs lines");
    lines->count = 0;
}

int swStageLines_GetCount(const swStageLines* lines)
{
    SW_REQUIRE(lines != NULL, 0, NULL, "swStageLines_GetCount() needs lines");
    return lines->count;
}

static uint8_t toByte(float value)
{
    return (uint8_t)(255.0f * (value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f) + 0.5f);
}

static bool isPlace(swPos p)
{
    return p.x - p.x == 0.0 && p.y - p.y == 0.0 && p.z - p.z == 0.0;
}

void swStageLines_Add(swStageLines* lines, swPos from, swPos to, swVec3 color)
{
    SW_REQUIRE_VOID(lines != NULL, NULL, "swStageLines_Add() needs lines");
    if (lines->count < SW_MAX_STAGE_LINES && isPlace(from) && isPlace(to))
    {
        lines->lines[lines->count++] = (swLine){from, to, {toByte(color.x), toByte(color.y), toByte(color.z), 255}};
    }
}

// Projection times rotation; both hold columns.
static void multiply(const float* a, const float* b, float* product)
{
    for (int column = 0; column < 4; ++column)
    {
        for (int row = 0; row < 4; ++row)
        {
            float sum = 0.0f;
            for (int k = 0; k < 4; ++k)
            {
                sum += a[4 * k + row] * b[4 * column + k];
            }
            product[4 * column + row] = sum;
        }
    }
}

static void putVertex(swLineVertex* vertex, swPos place, swPos eye, const uint8_t* color)
{
    vertex->position[0] = (float)(place.x - eye.x);
    vertex->position[1] = (float)(place.y - eye.y);
    vertex->position[2] = (float)(place.z - eye.z);
    memcpy(vertex->color, color, 4);
}

static void fillVertices(swStageLines* lines, swPos eye)
{
    swLineVertex* vertices = lines->vertices[lines->slot].data;
    for (int i = 0; i < lines->count; ++i)
    {
        const swLine* line = &lines->lines[i];
        putVertex(&vertices[2 * i], line->from, eye, line->color);
        putVertex(&vertices[2 * i + 1], line->to, eye, line->color);
    }
}

void swStage_DrawLines(swStage* stage, VkCommandBuffer commands, swStageLines* lines, const swStageTargets* targets,
                       const swCamera* camera)
{
    SW_REQUIRE_VOID(stage != NULL && lines != NULL && stage == lines->stage && commands != VK_NULL_HANDLE &&
                        targets != NULL && targets->output.image != VK_NULL_HANDLE && camera != NULL,
                    stage != NULL ? &stage->host : NULL,
                    "swStage_DrawLines() needs a stage, its lines, a command buffer, targets and a camera");
    if (lines->count == 0)
    {
        return;
    }
    lines->slot = (lines->slot + 1) % SW_STAGE_MAX_SLOTS;
    fillVertices(lines, camera->position);
    swLinePush push = {.perPixel = {1.0f / (float)targets->output.width, 1.0f / (float)targets->output.height}};
    multiply(camera->projection.m, camera->view.m, push.clip);
    swStage_UseImage(stage, commands, &targets->depth, SW_STAGE_USE_DEPTH_TARGET, SW_STAGE_USE_SAMPLED);
    swStage_UseImage(stage, commands, &targets->output, SW_STAGE_USE_COLOR_TARGET, SW_STAGE_USE_COLOR_TARGET);
    swStage_BeginDrawing(stage, commands, &targets->output, targets->output.view, true, NULL);
    const VkDescriptorImageInfo depth = {lines->sampler, targets->depth.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                        .descriptorCount = 1,
                                        .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                        .pImageInfo = &depth};
    const VkDeviceSize offset = 0;
    const swStageVk* vk = &stage->vk;
    vk->CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, lines->pipeline);
    vk->CmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, lines->layout, 0, 1, &write);
    vk->CmdPushConstants(commands, lines->layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                         sizeof(push), &push);
    vk->CmdBindVertexBuffers(commands, 0, 1, &lines->vertices[lines->slot].buffer, &offset);
    vk->CmdDraw(commands, 2 * (uint32_t)lines->count, 1, 0, 0);
    swStage_EndDrawing(stage, commands);
}
