// SPDX-License-Identifier: MIT
#include "picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/lines.h"

#include "common.h"

struct PictureMaker
{
    PictureMakerDef def;
    uint32_t width, height; // rendered
    swStage* stage;
    swGpu* gpu;
    swGpuWorld* world;
    swRenderer* renderer;
    swPicture* picture;
    swStageTerrain* terrain;
    uint32_t marks;
    swStageLines* lines; // NULL without marks
    const swWorld* shownWorld;
    swStageTargets targets;
    swStageBuffer hdrData, outputData; // 4 half floats and 4 bytes a pixel
};

static swResult CreateStage(PictureMaker* maker, const swHost* host)
{
    swGpuDef def = swDefaultGpuDef();
    def.choice = maker->def.device;
    def.deviceIndex = maker->def.deviceIndex;
    def.enableValidation = maker->def.enableValidation;
    swResult result = swCreateStage(host, &def, &maker->stage);
    maker->gpu = result == SW_SUCCESS ? swStage_GetGpu(maker->stage) : NULL;
    return result;
}

static swResult CreateTargets(PictureMaker* maker)
{
    const VkDeviceSize pixels = (VkDeviceSize)maker->width * maker->height;
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    swResult result = swStage_CreateTargets(maker->stage, maker->width, maker->height, 0, 0, &maker->targets);
    if (result == SW_ERROR_UNSUPPORTED)
    {
        Complain("use a smaller --size or fewer --samples");
    }
    result = result == SW_SUCCESS ? swStage_CreateBuffer(maker->stage, 8 * pixels, usage, &maker->hdrData) : result;
    return result == SW_SUCCESS ? swStage_CreateBuffer(maker->stage, 4 * pixels, usage, &maker->outputData) : result;
}

swViewDef FitPictureView(const PictureMaker* maker, const swViewDef* def)
{
    return swGpu_FitView(maker->gpu, def, maker->height);
}

bool ShowWorld(PictureMaker* maker, const swWorld* world)
{
    swResult result = swCreateGpuWorld(maker->gpu, world, &maker->world);
    const swPictureDef def = swDefaultPictureDef();
    result = result == SW_SUCCESS ? swCreateRenderer(maker->world, &maker->renderer) : result;
    result = result == SW_SUCCESS ? swCreatePicture(maker->renderer, &def, &maker->picture) : result;
    swStageTerrainDef land = swDefaultStageTerrainDef();
    land.world = world;
    maker->shownWorld = world;
    result = result == SW_SUCCESS ? swStage_CreateTerrain(maker->stage, &land, &maker->terrain) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the sea cannot be drawn");
    }
    return result == SW_SUCCESS;
}

PictureMaker* CreatePictureMaker(const swHost* host, const PictureMakerDef* def)
{
    PictureMaker* maker = calloc(1, sizeof(PictureMaker));
    if (maker == NULL)
    {
        Complain("no memory for a picture");
        return NULL;
    }
    maker->def = *def;
    maker->width = (uint32_t)(def->width * def->supersample);
    maker->height = (uint32_t)(def->height * def->supersample);
    swResult result = CreateStage(maker, host);
    result = result == SW_SUCCESS ? CreateTargets(maker) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "no Vulkan device can be used");
        DestroyPictureMaker(maker);
        return NULL;
    }
    return maker;
}

int DestroyPictureMaker(PictureMaker* maker)
{
    if (maker == NULL)
    {
        return 0;
    }
    int messageCount = 0;
    if (maker->stage != NULL)
    {
        swStage_Wait(maker->stage);
        swStage_DestroyTerrain(maker->stage, maker->terrain);
        swStage_DestroyLines(maker->stage, maker->lines);
        swDestroyPicture(maker->picture);
        swDestroyRenderer(maker->renderer);
        swDestroyGpuWorld(maker->world);
        swStage_DestroyTargets(maker->stage, &maker->targets);
        swStage_DestroyBuffer(maker->stage, &maker->hdrData);
        swStage_DestroyBuffer(maker->stage, &maker->outputData);
        messageCount = swGpu_GetValidationCount(maker->gpu);
        swDestroyStage(maker->stage);
    }
    free(maker);
    return messageCount;
}

// Frames run one after the other: record, submit, wait.
static bool BeginFrame(PictureMaker* maker, swStageFrame* frame)
{
    swResult result = swStage_BeginFrame(maker->stage, frame);
    if (result == SW_SUCCESS)
    {
        result = swGpuWorld_Record(maker->world, frame->commands, frame->index);
        if (result != SW_SUCCESS)
        {
            swStage_DropFrame(maker->stage, frame);
        }
    }
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the passes could not be recorded");
    }
    return result == SW_SUCCESS;
}

static bool FinishFrame(PictureMaker* maker, const swStageFrame* frame)
{
    swResult result = swStage_SubmitFrame(maker->stage, frame, NULL);
    result = result == SW_SUCCESS ? swStage_Wait(maker->stage) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the device did not finish the picture");
    }
    return result == SW_SUCCESS;
}

bool AdvancePicture(PictureMaker* maker)
{
    swStageFrame frame;
    return swGpu_WantsCpuLayers(maker->gpu) || (BeginFrame(maker, &frame) && FinishFrame(maker, &frame));
}

bool MakeSheet(PictureMaker* maker, const swView* view, const swSheetDef* def, swSheet* sheet)
{
    swStageFrame frame;
    if (!BeginFrame(maker, &frame) || !FinishFrame(maker, &frame))
    {
        return false;
    }
    swResult result = swSheet_Read(sheet, maker->world, view, def);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the layer could not be read");
    }
    return result == SW_SUCCESS;
}

bool SetPictureMarks(PictureMaker* maker, uint32_t marks)
{
    maker->marks = marks;
    swResult result = marks != 0 ? swStage_CreateLines(maker->stage, &maker->lines) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "lines cannot be drawn");
    }
    return result == SW_SUCCESS;
}

void ForgetPictureLand(PictureMaker* maker)
{
    swStageTerrain_Refresh(maker->terrain);
}

bool MakePicture(PictureMaker* maker, const swShot* shot, float dt, bool isFirst)
{
    swStageFrame frame;
    if (!BeginFrame(maker, &frame))
    {
        return false;
    }
    swShot withLand = *shot;
    swResult result = swStageTerrain_Prepare(maker->terrain, &maker->targets, &withLand);
    result = result == SW_SUCCESS ? swPicture_Prepare(maker->picture, frame.commands, &withLand, frame.index) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the picture could not be prepared");
        swStage_DropFrame(maker->stage, &frame);
        return false;
    }
    const swStageTargets* targets = &maker->targets;
    swStage_DrawPicture(maker->stage, frame.commands, maker->picture, targets, maker->terrain, dt, isFirst);
    if (maker->lines != NULL)
    {
        swStageLines_Clear(maker->lines);
        swStageLines_AddMarks(maker->lines, maker->shownWorld, maker->picture, &withLand.camera, maker->marks);
        swStage_DrawLines(maker->stage, frame.commands, maker->lines, targets, &withLand.camera);
    }
    swStage_CopyToHost(maker->stage, frame.commands, &targets->hdr, SW_STAGE_USE_SAMPLED, &maker->hdrData);
    swStage_CopyToHost(maker->stage, frame.commands, &targets->output, SW_STAGE_USE_COLOR_TARGET, &maker->outputData);
    return FinishFrame(maker, &frame);
}

static float LinearFromSrgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : powf((value + 0.055f) / 1.055f, 2.4f);
}

static float SrgbFromLinear(float value)
{
    return value <= 0.0031308f ? value * 12.92f : 1.055f * powf(value, 1.0f / 2.4f) - 0.055f;
}

static float FloatFromHalf(uint16_t half)
{
    int exponent = half >> 10 & 31;
    float mantissa = (float)(half & 1023);
    float value = exponent == 0 ? ldexpf(mantissa, -24) : ldexpf(mantissa + 1024.0f, exponent - 25);
    value = exponent == 31 ? (mantissa == 0.0f ? INFINITY : NAN) : value;
    return half & 0x8000 ? -value : value;
}

// The mean over the rendered pixels of a finished one: of the bytes by way of a table, or of the half floats.
static void ReadPixel(const PictureMaker* maker, int column, int row, const float* byteTable, float* rgb)
{
    int factor = maker->def.supersample;
    const uint8_t* bytes = maker->outputData.data;
    const uint16_t* halves = maker->hdrData.data;
    float sum[3] = {0.0f, 0.0f, 0.0f};
    for (int y = 0; y < factor; ++y)
    {
        size_t first = ((size_t)row * (size_t)factor + (size_t)y) * maker->width + (size_t)column * (size_t)factor;
        for (int i = 0; i < factor * 4; ++i)
        {
            if ((i & 3) != 3)
            {
                size_t index = first * 4 + (size_t)i;
                sum[i & 3] += byteTable != NULL ? byteTable[bytes[index]] : FloatFromHalf(halves[index]);
            }
        }
    }
    for (int i = 0; i < 3; ++i)
    {
        rgb[i] = sum[i] / (float)(factor * factor);
    }
}

void ReadPictureBytes(const PictureMaker* maker, uint8_t* rgb)
{
    float table[256]; // pixels are averaged in linear light
    for (int i = 0; i < 256; ++i)
    {
        table[i] = LinearFromSrgb((float)i / 255.0f);
    }
    const uint8_t* bytes = maker->outputData.data;
    for (int row = 0; row < maker->def.height; ++row)
    {
        for (int column = 0; column < maker->def.width; ++column)
        {
            size_t index = (size_t)row * (size_t)maker->def.width + (size_t)column;
            float mean[3];
            if (maker->def.supersample == 1)
            {
                memcpy(rgb + 3 * index, bytes + 4 * index, 3);
                continue;
            }
            ReadPixel(maker, column, row, table, mean);
            for (int i = 0; i < 3; ++i)
            {
                rgb[3 * index + (size_t)i] = (uint8_t)(SrgbFromLinear(mean[i]) * 255.0f + 0.5f);
            }
        }
    }
}

void ReadPictureFloats(const PictureMaker* maker, float* rgb)
{
    for (int row = 0; row < maker->def.height; ++row)
    {
        for (int column = 0; column < maker->def.width; ++column)
        {
            ReadPixel(maker, column, row, NULL, rgb + 3 * ((size_t)row * (size_t)maker->def.width + (size_t)column));
        }
    }
}

const swGpu* GetPictureGpu(const PictureMaker* maker)
{
    return maker->gpu;
}

size_t GetPictureMemory(const PictureMaker* maker)
{
    return swGpuWorld_GetMemory(maker->world);
}
