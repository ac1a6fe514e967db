// SPDX-License-Identifier: MIT
#include "golden/canvas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/vk/vk_device.h"
#include "gpu/vk/vk_submit.h"

struct Canvas
{
    swHost host;
    swGpu* gpu;
    swImage hdr, depth, output;
    swBuffer readback;
    uint32_t width, height;
    PFN_vkCmdBeginRendering beginRendering;
    PFN_vkCmdEndRendering endRendering;
    PFN_vkCmdSetViewport setViewport;
    PFN_vkCmdSetScissor setScissor;
    uint64_t frameIndex;
};

// One sea and its twin.
typedef struct Sea
{
    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swRenderer* renderer;
} Sea;

static float Radians(float degrees)
{
    return degrees * (float)(SW_PI / 180.0);
}

static bool CreateTarget(Canvas* canvas, VkFormat format, VkImageUsageFlags usage, VkImageLayout layout,
                         const char* name, swImage* image)
{
    const swImageDef def = {.format = format,
                            .width = canvas->width,
                            .height = canvas->height,
                            .usage = usage,
                            .layout = layout,
                            .name = name};
    return swCreateImage(canvas->gpu, &def, image) == SW_SUCCESS;
}

Canvas* CreateCanvas(uint32_t width, uint32_t height, bool enableValidation)
{
    Canvas* canvas = calloc(1, sizeof(*canvas));
    if (!canvas)
    {
        return NULL;
    }
    canvas->host = swDefaultHost();
    canvas->width = width;
    canvas->height = height;
    swGpuDef def = swDefaultGpuDef();
    def.enableValidation = enableValidation;
    def.layers = SW_LAYERS_CORE; // where a shot has them
    VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    bool isReady = swCreateGpu(&canvas->host, &def, &canvas->gpu) == SW_SUCCESS &&
                   CreateTarget(canvas, VK_FORMAT_R16G16B16A16_SFLOAT, drawn | VK_IMAGE_USAGE_SAMPLED_BIT,
                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, "hdr", &canvas->hdr) &&
                   CreateTarget(canvas, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, "depth", &canvas->depth) &&
                   CreateTarget(canvas, VK_FORMAT_R8G8B8A8_SRGB, drawn, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                "output", &canvas->output) &&
                   swCreateBuffer(canvas->gpu, 8ull * width * height, 0, SW_MEMORY_READBACK, "readback",
                                  &canvas->readback) == SW_SUCCESS;
    if (!isReady)
    {
        DestroyCanvas(canvas);
        return NULL;
    }
    PFN_vkGetDeviceProcAddr get = canvas->gpu->vk.GetDeviceProcAddr;
    VkDevice device = canvas->gpu->device;
    canvas->beginRendering = (PFN_vkCmdBeginRendering)get(device, "vkCmdBeginRendering");
    canvas->endRendering = (PFN_vkCmdEndRendering)get(device, "vkCmdEndRendering");
    canvas->setViewport = (PFN_vkCmdSetViewport)get(device, "vkCmdSetViewport");
    canvas->setScissor = (PFN_vkCmdSetScissor)get(device, "vkCmdSetScissor");
    return canvas;
}

void DestroyCanvas(Canvas* canvas)
{
    if (!canvas)
    {
        return;
    }
    if (canvas->gpu)
    {
        canvas->gpu->vk.DeviceWaitIdle(canvas->gpu->device);
        swDestroyImage(canvas->gpu, &canvas->hdr);
        swDestroyImage(canvas->gpu, &canvas->depth);
        swDestroyImage(canvas->gpu, &canvas->output);
        swDestroyBuffer(canvas->gpu, &canvas->readback);
        swDestroyGpu(canvas->gpu);
    }
    free(canvas);
}

static void DestroySea(Sea* sea)
{
    swDestroyRenderer(sea->renderer);
    swDestroyGpuWorld(sea->gpuWorld);
    swDestroyView(sea->view);
    swDestroyWorld(sea->world);
}

static bool CreateSea(const Canvas* canvas, const Shot* shot, Sea* sea)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = shot->hasCoreLayers;
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum.windSpeed = shot->windSpeed;
    waves.spectrum.direction = SW_DIRECTION_FROM_BEARING(240.0);
    waves = shot->waves != NULL ? *shot->waves : waves;
    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.spectrum.kind = SW_SPECTRUM_JONSWAP;
    swell.spectrum.significantHeight = shot->swellHeight;
    swell.spectrum.peakPeriod = 11.0f;
    swell.spectrum.gamma = 5.0f;
    swell.spectrum.spreadExponent = 60.0f;
    swell.spectrum.direction = SW_DIRECTION_FROM_BEARING(300.0);
    swell.minWavelength = 32.0f;
    swell.seed = 7;
    swViewDef viewDef = swDefaultViewDef();
    viewDef.enableCpuLayers = shot->hasCoreLayers;
    swRendererDef rendererDef = swDefaultRendererDef();
    swWaveSystemId id;
    return swCreateWorld(&canvas->host, &worldDef, &sea->world) == SW_SUCCESS &&
           swCreateWaveSystem(sea->world, &waves, &id) == SW_SUCCESS &&
           (shot->swellHeight <= 0.0f || swCreateWaveSystem(sea->world, &swell, &id) == SW_SUCCESS) &&
           swCreateView(sea->world, &viewDef, &sea->view) == SW_SUCCESS &&
           swCreateGpuWorld(canvas->gpu, sea->world, &sea->gpuWorld) == SW_SUCCESS &&
           swCreateRenderer(sea->gpuWorld, &rendererDef, &sea->renderer) == SW_SUCCESS;
}

static void BeginRendering(const Canvas* canvas, VkCommandBuffer commands, const swImage* color, const swImage* depth)
{
    const VkRenderingAttachmentInfo colorInfo = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = color->view,
        .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
    };
    const VkRenderingAttachmentInfo depthInfo = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = depth ? depth->view : VK_NULL_HANDLE,
        .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
    };
    const VkRenderingInfo info = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
        .renderArea = {{0, 0}, {canvas->width, canvas->height}},
        .layerCount = 1,
        .colorAttachmentCount = 1,
        .pColorAttachments = &colorInfo,
        .pDepthAttachment = depth ? &depthInfo : NULL,
    };
    const VkViewport viewport = {0.0f, 0.0f, (float)canvas->width, (float)canvas->height, 0.0f, 1.0f};
    const VkRect2D scissor = {{0, 0}, {canvas->width, canvas->height}};
    canvas->beginRendering(commands, &info);
    canvas->setViewport(commands, 0, 1, &viewport);
    canvas->setScissor(commands, 0, 1, &scissor);
}

static void Move(const Canvas* canvas, VkCommandBuffer commands, const swImage* image, VkImageLayout from,
                 VkImageLayout to)
{
    VkAccessFlags2 all = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    swImageBarrier(canvas->gpu, commands, image, from, to, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, all,
                   VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, all);
}

static void RecordImages(Canvas* canvas, swRenderer* renderer, VkCommandBuffer commands, bool readHdr)
{
    const VkImageLayout none = VK_IMAGE_LAYOUT_UNDEFINED;
    const VkImageLayout drawn = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkImageLayout read = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    const VkImageLayout copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    Move(canvas, commands, &canvas->hdr, none, drawn);
    Move(canvas, commands, &canvas->depth, none, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    BeginRendering(canvas, commands, &canvas->hdr, &canvas->depth);
    swRenderer_DrawSurface(renderer, commands);
    swRenderer_DrawSky(renderer, commands);
    canvas->endRendering(commands);
    Move(canvas, commands, &canvas->hdr, drawn, read);
    swRenderer_Expose(renderer, commands, canvas->hdr.view, 0.0f, true);
    Move(canvas, commands, &canvas->output, none, drawn);
    BeginRendering(canvas, commands, &canvas->output, NULL);
    swRenderer_Tonemap(renderer, commands, canvas->hdr.view);
    canvas->endRendering(commands);

    const swImage* wanted = readHdr ? &canvas->hdr : &canvas->output;
    Move(canvas, commands, wanted, readHdr ? read : drawn, copied);
    const VkBufferImageCopy copy = {
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageExtent = {canvas->width, canvas->height, 1},
    };
    canvas->gpu->vk.CmdCopyImageToBuffer(commands, wanted->handle, copied, canvas->readback.handle, 1, &copy);
    swBarrier(canvas->gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

static float HalfToFloat(uint16_t half)
{
    int exponent = (half >> 10) & 31;
    float mantissa = (float)(half & 1023) / 1024.0f;
    float value = exponent == 0    ? ldexpf(mantissa, -14)
                  : exponent == 31 ? (half & 1023 ? NAN : INFINITY)
                                   : ldexpf(1.0f + mantissa, exponent - 15);
    return half & 0x8000 ? -value : value;
}

static bool RecordAll(Canvas* canvas, Sea* sea, const swPicture* picture, bool readHdr, VkCommandBuffer commands)
{
    bool isGood = swGpuWorld_Record(sea->gpuWorld, commands, canvas->frameIndex) == SW_SUCCESS;
    if (isGood && picture)
    {
        isGood = swRenderer_Prepare(sea->renderer, commands, picture, canvas->frameIndex) == SW_SUCCESS;
        if (isGood)
        {
            RecordImages(canvas, sea->renderer, commands, readHdr);
        }
    }
    ++canvas->frameIndex;
    return isGood;
}

// One frame, of the waves alone or with the picture.
static bool RunFrame(Canvas* canvas, Sea* sea, const swPicture* picture, bool readHdr, bool isDroppedFirst)
{
    VkCommandBuffer commands;
    bool isGood = true;
    if (isDroppedFirst)
    {
        isGood =
            swBeginSubmit(canvas->gpu, &commands) == SW_SUCCESS && RecordAll(canvas, sea, picture, readHdr, commands);
        swGpuWorld_Discard(sea->gpuWorld, canvas->frameIndex - 1);
    }
    if (!isGood || swBeginSubmit(canvas->gpu, &commands) != SW_SUCCESS)
    {
        return false;
    }
    isGood = RecordAll(canvas, sea, picture, readHdr, commands);
    return swEndSubmit(canvas->gpu) == SW_SUCCESS && isGood;
}

static bool DrawSea(Canvas* canvas, Sea* sea, const Shot* shot, uint8_t* pixels, float* hdr)
{
    swPicture picture = {.view = sea->view, .sky = swDefaultSkyDef(), .water = swDefaultWaterDef()};
    picture.water.foamAlbedo = shot->hasBlackFoam ? (swVec3){0.0f, 0.0f, 0.0f} : picture.water.foamAlbedo;
    picture.camera = swMakeCamera((swPos){shot->x, (double)shot->height, shot->z}, Radians(shot->headingDeg),
                                  Radians(shot->pitchDeg), 0.0f, Radians(shot->fovDeg), canvas->width, canvas->height);
    picture.sky.sunAzimuth = Radians(shot->sunAzimuthDeg);
    picture.sky.sunElevation = Radians(shot->sunElevationDeg);
    picture.sky.haze = shot->haze;
    picture.sky.clouds = shot->clouds;
    picture.water.windSpeed = shot->windSpeed;
    picture.debug = shot->debug;
    picture.time = shot->time;

    swView_SetViewpoint(sea->view, picture.camera.position);
    swWorld_SetTime(sea->world, shot->time - 0.1 * shot->steps);
    bool isGood = swWorld_Step(sea->world, 0.0) == SW_SUCCESS;
    for (int i = 0; i < shot->steps && isGood; ++i)
    {
        isGood = RunFrame(canvas, sea, NULL, false, shot->dropsCommands) && swWorld_Step(sea->world, 0.1) == SW_SUCCESS;
    }
    size_t count = 4ull * canvas->width * canvas->height;
    if (isGood && pixels)
    {
        isGood = RunFrame(canvas, sea, &picture, false, shot->dropsCommands);
        memcpy(pixels, canvas->readback.mapped, count);
    }
    if (isGood && hdr)
    {
        isGood = RunFrame(canvas, sea, &picture, true, shot->dropsCommands);
        const uint16_t* halves = canvas->readback.mapped;
        for (size_t i = 0; i < count; ++i)
        {
            hdr[i] = HalfToFloat(halves[i]);
        }
    }
    return isGood;
}

bool DrawShot(Canvas* canvas, const Shot* shot, uint8_t* pixels, float* hdr)
{
    Sea sea = {0};
    bool isGood = CreateSea(canvas, shot, &sea) && DrawSea(canvas, &sea, shot, pixels, hdr);
    canvas->gpu->vk.DeviceWaitIdle(canvas->gpu->device);
    DestroySea(&sea);
    return isGood;
}

const char* GetCanvasDevice(const Canvas* canvas)
{
    return swGpu_GetDeviceName(canvas->gpu);
}

int GetCanvasValidationCount(const Canvas* canvas)
{
    return swGpu_GetValidationCount(canvas->gpu);
}

void PrintCanvasTimes(const Canvas* canvas)
{
    swPassTime times[SW_MAX_TIMED_PASSES];
    int count = swGpu_GetPassTimes(canvas->gpu, times, SW_MAX_TIMED_PASSES);
    for (int i = 0; i < count; ++i)
    {
        printf("%-16s %9.2f ms\n", times[i].name, (double)times[i].milliseconds);
    }
}
