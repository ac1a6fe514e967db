// SPDX-License-Identifier: MIT
#include "gpu/draw/sky.h"

#include <math.h>
#include <string.h>

#include "halve_shader.h"
#include "sky_air_shader.h"
#include "sky_light_shader.h"
#include "sky_map_shader.h"
#include "sky_multiple_shader.h"
#include "sky_shader.h"
#include "sky_transmittance_shader.h"
#include "sky_view_shader.h"

swResult swCreateSkyPipelines(swGpu* gpu, swSkyPipelines* pipelines)
{
    const struct
    {
        const swShader* shader;
        swPipeline* pipeline;
    } computes[] = {
        {&swSkyTransmittanceShader, &pipelines->transmittance},
        {&swSkyMultipleShader, &pipelines->multiple},
        {&swSkyViewShader, &pipelines->view},
        {&swSkyAirShader, &pipelines->air},
        {&swSkyLightShader, &pipelines->light},
        {&swSkyMapShader, &pipelines->map},
        {&swHalveShader, &pipelines->halve},
    };
    for (size_t i = 0; i < sizeof(computes) / sizeof(computes[0]); ++i)
    {
        swResult result = swCreateComputePipeline(gpu, computes[i].shader, NULL, computes[i].pipeline);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

void swDestroySkyPipelines(swGpu* gpu, swSkyPipelines* pipelines)
{
    swPipeline* all[] = {&pipelines->transmittance, &pipelines->multiple, &pipelines->view, &pipelines->air,
                         &pipelines->light,         &pipelines->map,      &pipelines->halve};
    for (size_t i = 0; i < sizeof(all) / sizeof(all[0]); ++i)
    {
        swDestroyPipeline(gpu, all[i]);
    }
}

swResult swCreateSkyPipeline(swGpu* gpu, const swPictureDef* formats, swPipeline* pipeline)
{
    const swGraphicsDef draw = {
        .vertex = &swSkyVertex,
        .fragment = &swSkyFragment,
        .colorFormat = formats->colorFormat,
        .depthFormat = formats->depthFormat,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL,
        .name = "sky",
    };
    return swCreateGraphicsPipeline(gpu, &draw, pipeline);
}

static swResult createTable(swGpu* gpu, uint32_t width, uint32_t height, uint32_t layers, uint32_t mips,
                            const char* name, swImage* image)
{
    const swImageDef def = {
        .format = VK_FORMAT_R16G16B16A16_SFLOAT,
        .width = width,
        .height = height,
        .layers = layers,
        .mips = mips,
        .isArray = layers > 1,
        .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
        .layout = VK_IMAGE_LAYOUT_GENERAL,
        .name = name,
    };
    return swCreateImage(gpu, &def, image);
}

swResult swCreateSky(swGpu* gpu, swSky* sky)
{
    swResult result = createTable(gpu, SW_SKY_TRANSMITTANCE_WIDTH, SW_SKY_TRANSMITTANCE_HEIGHT, 1, 1,
                                  "sky transmittance", &sky->transmittance);
    if (result == SW_SUCCESS)
    {
        result = createTable(gpu, SW_SKY_MULTIPLE_SIDE, SW_SKY_MULTIPLE_SIDE, 1, 1, "sky multiple scattering",
                             &sky->multiple);
    }
    if (result == SW_SUCCESS)
    {
        result = createTable(gpu, SW_SKY_VIEW_WIDTH, SW_SKY_VIEW_HEIGHT, 4, 1, "sky view", &sky->view);
    }
    if (result == SW_SUCCESS)
    {
        result = createTable(gpu, SW_SKY_AIR_SIDE, SW_SKY_AIR_SIDE, 3, 1, "sky air", &sky->air);
    }
    if (result == SW_SUCCESS)
    {
        result = createTable(gpu, SW_SKY_VIEW_WIDTH, SW_SKY_VIEW_HEIGHT, 1, SW_SKY_MAP_MIPS, "sky map", &sky->map);
    }
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, sizeof(swSkyLight), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                "sky light", &sky->light);
    }
    return result;
}

void swRetireSky(swGpu* gpu, swSky* sky)
{
    swImage* images[] = {&sky->transmittance, &sky->multiple, &sky->view, &sky->air, &sky->map};
    for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i)
    {
        swRetireImage(gpu, images[i]);
    }
    swRetireBuffer(gpu, &sky->light);
}

static bool differs(float a, float b, float limit)
{
    return !(fabsf(a - b) <= limit);
}

static bool vectorDiffers(swVec3 a, swVec3 b, float limit)
{
    return differs(a.x, b.x, limit) || differs(a.y, b.y, limit) || differs(a.z, b.z, limit);
}

static swSkyState getState(const swPictureParams* p)
{
    return (swSkyState){
        .haze = p->haze,
        .sun = p->sun,
        .sunLight = p->sunLight,
        .cameraHeight = p->cameraHeight,
        .clouds = p->clouds,
        .cloudX = p->cloudX,
        .cloudZ = p->cloudZ,
    };
}

void swRecordMips(swGpu* gpu, VkCommandBuffer commands, const swPipeline* halve, const swImage* image)
{
    for (uint32_t mip = 1; mip < image->mips; ++mip)
    {
        const swHalveBindings bindings = {
            .source = swBindView(gpu, image->mipViews[mip - 1], VK_IMAGE_LAYOUT_GENERAL, SW_SAMPLER_NEAREST_CLAMP),
            .target = swBindView(gpu, image->mipViews[mip], VK_IMAGE_LAYOUT_GENERAL, SW_SAMPLER_NEAREST_CLAMP),
        };
        swComputeBarrier(gpu, commands);
        swBindHalve(gpu, commands, halve, &bindings);
        uint32_t width = image->width >> mip;
        uint32_t height = image->height >> mip;
        gpu->vk.CmdDispatch(commands, (width + 7) / 8, (height + 7) / 8, 1);
    }
}

static void recordAirTables(swGpu* gpu, VkCommandBuffer commands, const swSkyPipelines* pipelines, swSky* sky,
                            swBinding params)
{
    swBinding transmittance = swBindImage(gpu, &sky->transmittance, SW_SAMPLER_LINEAR_CLAMP);
    const swSkyTransmittanceBindings first = {.picture = params, .target = transmittance};
    swBindSkyTransmittance(gpu, commands, &pipelines->transmittance, &first);
    gpu->vk.CmdDispatch(commands, SW_SKY_TRANSMITTANCE_WIDTH / 8, SW_SKY_TRANSMITTANCE_HEIGHT / 8, 1);
    swComputeBarrier(gpu, commands);
    const swSkyMultipleBindings second = {
        .picture = params,
        .transmittance = transmittance,
        .target = swBindImage(gpu, &sky->multiple, SW_SAMPLER_LINEAR_CLAMP),
    };
    swBindSkyMultiple(gpu, commands, &pipelines->multiple, &second);
    gpu->vk.CmdDispatch(commands, SW_SKY_MULTIPLE_SIDE / 8, SW_SKY_MULTIPLE_SIDE / 8, 1);
    swComputeBarrier(gpu, commands);
}

static void recordLightTables(swGpu* gpu, VkCommandBuffer commands, const swSkyPipelines* pipelines, swSky* sky,
                              swBinding params)
{
    swBinding transmittance = swBindImage(gpu, &sky->transmittance, SW_SAMPLER_LINEAR_CLAMP);
    swBinding multiple = swBindImage(gpu, &sky->multiple, SW_SAMPLER_LINEAR_CLAMP);
    swBinding view = swBindImage(gpu, &sky->view, SW_SAMPLER_LINEAR_REPEAT_X);
    const swSkyViewBindings seen = {
        .picture = params,
        .transmittance = transmittance,
        .multiple = multiple,
        .target = view,
    };
    swBindSkyView(gpu, commands, &pipelines->view, &seen);
    gpu->vk.CmdDispatch(commands, SW_SKY_VIEW_WIDTH / 8, SW_SKY_VIEW_HEIGHT / 8, 2);
    const swSkyAirBindings air = {
        .picture = params,
        .transmittance = transmittance,
        .multiple = multiple,
        .target = swBindImage(gpu, &sky->air, SW_SAMPLER_LINEAR_CLAMP),
    };
    swBindSkyAir(gpu, commands, &pipelines->air, &air);
    gpu->vk.CmdDispatch(commands, SW_SKY_AIR_SIDE / 8, SW_SKY_AIR_SIDE / 8, 1);
    swComputeBarrier(gpu, commands);
    const swSkyLightBindings light = {
        .picture = params,
        .transmittance = transmittance,
        .skyView = view,
        .light = swBindBuffer(&sky->light),
    };
    swBindSkyLight(gpu, commands, &pipelines->light, &light);
    gpu->vk.CmdDispatch(commands, 1, 1, 1);
    swComputeBarrier(gpu, commands);
}

static void recordMap(swGpu* gpu, VkCommandBuffer commands, const swSkyPipelines* pipelines, swSky* sky,
                      swBinding params)
{
    const swSkyMapBindings bindings = {
        .picture = params,
        .light = swBindBuffer(&sky->light),
        .skyView = swBindImage(gpu, &sky->view, SW_SAMPLER_LINEAR_REPEAT_X),
        .target = swBindView(gpu, sky->map.mipViews[0], VK_IMAGE_LAYOUT_GENERAL, SW_SAMPLER_NEAREST_CLAMP),
    };
    swBindSkyMap(gpu, commands, &pipelines->map, &bindings);
    gpu->vk.CmdDispatch(commands, SW_SKY_VIEW_WIDTH / 8, SW_SKY_VIEW_HEIGHT / 8, 1);
    swRecordMips(gpu, commands, &pipelines->halve, &sky->map);
}

void swRecordSkyTables(swGpu* gpu, VkCommandBuffer commands, const swSkyPipelines* pipelines, swSky* sky,
                       const swPictureFrame* picture)
{
    swSkyState now = getState(&picture->params);
    const swSkyState* old = &sky->state;
    float heightLimit = 0.02f * fmaxf(now.cameraHeight, 50.0f);
    bool isNew = !sky->isValid;
    bool airChanged = isNew || now.haze != old->haze;
    bool lightChanged = airChanged || vectorDiffers(now.sun, old->sun, 1e-4f) ||
                        vectorDiffers(now.sunLight, old->sunLight, 0.0f) ||
                        differs(now.cameraHeight, old->cameraHeight, heightLimit);
    bool mapChanged =
        lightChanged || now.clouds != old->clouds ||
        (now.clouds > 0.0f && (differs(now.cloudX, old->cloudX, 0.02f) || differs(now.cloudZ, old->cloudZ, 0.02f)));
    if (!mapChanged)
    {
        return;
    }
    swBinding params = swBindUpload(&picture->paramsUpload);
    swBeginPass(gpu, commands, "sky_tables");
    swImage* images[] = {&sky->transmittance, &sky->multiple, &sky->view, &sky->air, &sky->map};
    for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i)
    {
        swInitializeImage(gpu, commands, images[i]);
    }
    // The frame before may still read them.
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, 0, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_WRITE_BIT);
    if (airChanged)
    {
        recordAirTables(gpu, commands, pipelines, sky, params);
        sky->state.haze = now.haze;
    }
    if (lightChanged)
    {
        recordLightTables(gpu, commands, pipelines, sky, params);
        sky->state = now;
    }
    recordMap(gpu, commands, pipelines, sky, params);
    sky->state.clouds = now.clouds;
    sky->state.cloudX = now.cloudX;
    sky->state.cloudZ = now.cloudZ;
    sky->isValid = true;
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT);
    swEndPass(gpu, commands);
}

void swForgetSky(swSky* sky)
{
    swImage* images[] = {&sky->transmittance, &sky->multiple, &sky->view, &sky->air, &sky->map};
    for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i)
    {
        images[i]->isInitialized = false;
    }
    sky->isValid = false;
}

void swDrawSky(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swSky* sky,
               const swPictureFrame* picture)
{
    const swSkyBindings bindings = {
        .picture = swBindUpload(&picture->paramsUpload),
        .light = swBindBuffer(&sky->light),
        .skyView = swBindImage(gpu, &sky->view, SW_SAMPLER_LINEAR_REPEAT_X),
        .transmittance = swBindImage(gpu, &sky->transmittance, SW_SAMPLER_LINEAR_CLAMP),
    };
    swBeginPass(gpu, commands, "sky");
    swBindSky(gpu, commands, pipeline, &bindings);
    gpu->vk.CmdDraw(commands, 3, 1, 0, 0);
    swEndPass(gpu, commands);
}
