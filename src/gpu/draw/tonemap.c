// SPDX-License-Identifier: MIT
#include "gpu/draw/tonemap.h"

#include <math.h>

#include "expose_shader.h"
#include "tonemap_shader.h"

#define SW_ADAPTATION_TIME 0.7f // s

static bool encodesItself(VkFormat format)
{
    switch (format)
    {
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_B8G8R8A8_SRGB:
    case VK_FORMAT_A8B8G8R8_SRGB_PACK32:
    case VK_FORMAT_R8G8B8_SRGB:
    case VK_FORMAT_B8G8R8_SRGB:
        return true;
    default:
        return false;
    }
}

swResult swCreateExposePipeline(swGpu* gpu, swPipeline* pipeline)
{
    return swCreateComputePipeline(gpu, &swExposeShader, NULL, pipeline);
}

swResult swCreateTonemapPipeline(swGpu* gpu, const swPictureDef* formats, swPipeline* pipeline)
{
    const swTonemapConstants constants = {.targetEncodes = encodesItself(formats->outputFormat) ? 1 : 0};
    const swGraphicsDef draw = {
        .vertex = &swTonemapVertex,
        .fragment = &swTonemapFragment,
        .constants = &constants,
        .colorFormat = formats->outputFormat,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .name = "tonemap",
    };
    return swCreateGraphicsPipeline(gpu, &draw, pipeline);
}

swResult swCreateTonemap(swGpu* gpu, swTonemap* tonemap)
{
    return swCreateBuffer(gpu, sizeof(swExposure), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE, "exposure",
                          &tonemap->exposure);
}

void swRetireTonemap(swGpu* gpu, swTonemap* tonemap)
{
    swRetireBuffer(gpu, &tonemap->exposure);
}

void swClearExposure(swGpu* gpu, VkCommandBuffer commands, swTonemap* tonemap)
{
    if (tonemap->isCleared)
    {
        return;
    }
    gpu->vk.CmdFillBuffer(commands, tonemap->exposure.handle, 0, VK_WHOLE_SIZE, 0);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT);
    tonemap->isCleared = true;
    tonemap->clearedFrame = gpu->frameIndex;
}

void swForgetExposure(swTonemap* tonemap, uint64_t frameIndex)
{
    tonemap->isCleared = tonemap->isCleared && tonemap->clearedFrame < frameIndex;
}

void swRecordExposure(swGpu* gpu, VkCommandBuffer commands, const swPipeline* expose, swTonemap* tonemap,
                      VkImageView hdr, float dt, bool immediate)
{
    const swExposeBindings bindings = {
        .hdr = swBindView(gpu, hdr, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SW_SAMPLER_LINEAR_CLAMP),
        .exposure = swBindBuffer(&tonemap->exposure),
    };
    static_assert(sizeof(float) == SW_EXPOSE_PUSH_SIZE, "what expose.comp is given");
    float keep = immediate ? 0.0f : expf(-fmaxf(dt, 0.0f) / SW_ADAPTATION_TIME);
    swBeginPass(gpu, commands, "expose");
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT);
    swBindExpose(gpu, commands, expose, &bindings, &keep);
    gpu->vk.CmdDispatch(commands, 1, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT);
    swEndPass(gpu, commands);
}

void swDrawTonemap(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swTonemap* tonemap,
                   VkImageView hdr, float time, float stops, bool isRaw)
{
    const swTonemapBindings bindings = {
        .hdr = swBindView(gpu, hdr, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SW_SAMPLER_LINEAR_CLAMP),
        .exposure = swBindBuffer(&tonemap->exposure),
    };
    static_assert(3 * sizeof(float) == SW_TONEMAP_PUSH_SIZE, "what tonemap.frag is given");
    const float push[3] = {time, stops, isRaw ? 1.0f : 0.0f};
    swBeginPass(gpu, commands, "tonemap");
    swBindTonemap(gpu, commands, pipeline, &bindings, push);
    gpu->vk.CmdDraw(commands, 3, 1, 0, 0);
    swEndPass(gpu, commands);
}
