// SPDX-License-Identifier: MIT
#include "gpu/draw/tonemap.h"

#include <math.h>

static const uint32_t exposeCode[] =
#include "expose.comp.inc"
    ;
static const uint32_t fullscreenCode[] =
#include "fullscreen.vert.inc"
    ;
static const uint32_t tonemapCode[] =
#include "tonemap.frag.inc"
    ;

#define SW_STORAGE VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
#define SW_SAMPLED VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
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

swResult swCreateTonemap(swGpu* gpu, const swRendererDef* def, swTonemap* tonemap)
{
    const swComputeDef expose = {
        .shader = SW_SHADER(exposeCode),
        .bindingCount = 2,
        .types = {SW_SAMPLED, SW_STORAGE},
        .pushSize = sizeof(float),
        .name = "expose",
    };
    swResult result = swCreateComputePipeline(gpu, &expose, &tonemap->exposePipeline);
    const uint32_t constants[] = {encodesItself(def->outputFormat)};
    const swGraphicsDef draw = {
        .vertex = SW_SHADER(fullscreenCode),
        .fragment = SW_SHADER(tonemapCode),
        .bindingCount = 2,
        .types = {SW_SAMPLED, SW_STORAGE},
        .pushSize = 3 * sizeof(float),
        .constantCount = 1,
        .constants = constants,
        .colorFormat = def->outputFormat,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .name = "tonemap",
    };
    if (result == SW_SUCCESS)
    {
        result = swCreateGraphicsPipeline(gpu, &draw, &tonemap->tonemapPipeline);
    }
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, sizeof(swExposure), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                "exposure", &tonemap->exposure);
    }
    return result;
}

void swDestroyTonemap(swGpu* gpu, swTonemap* tonemap)
{
    swDestroyPipeline(gpu, &tonemap->exposePipeline);
    swDestroyPipeline(gpu, &tonemap->tonemapPipeline);
    swDestroyBuffer(gpu, &tonemap->exposure);
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

void swRecordExposure(swGpu* gpu, VkCommandBuffer commands, swTonemap* tonemap, VkImageView hdr, float dt,
                      bool immediate)
{
    const swBinding bindings[] = {
        swBindView(gpu, hdr, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SW_SAMPLER_LINEAR_CLAMP),
        swBindBuffer(&tonemap->exposure),
    };
    float keep = immediate ? 0.0f : expf(-fmaxf(dt, 0.0f) / SW_ADAPTATION_TIME);
    swBeginPass(gpu, commands, "expose");
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT);
    swBindPipeline(gpu, commands, &tonemap->exposePipeline, bindings, &keep);
    gpu->vk.CmdDispatch(commands, 1, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT);
    swEndPass(gpu, commands);
}

void swDrawTonemap(swGpu* gpu, VkCommandBuffer commands, const swTonemap* tonemap, VkImageView hdr, float time,
                   float stops, bool isRaw)
{
    const swBinding bindings[] = {
        swBindView(gpu, hdr, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SW_SAMPLER_LINEAR_CLAMP),
        swBindBuffer(&tonemap->exposure),
    };
    const float push[3] = {time, stops, isRaw ? 1.0f : 0.0f};
    swBeginPass(gpu, commands, "tonemap");
    swBindPipeline(gpu, commands, &tonemap->tonemapPipeline, bindings, push);
    gpu->vk.CmdDraw(commands, 3, 1, 0, 0);
    swEndPass(gpu, commands);
}
