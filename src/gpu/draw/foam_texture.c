// SPDX-License-Identifier: MIT
#include "gpu/draw/foam_texture.h"

#include <string.h>

#include "gpu/draw/sky.h"

// RGBA, SW_FOAM_TEXTURE_SIDE squared. See generators/foam_texture.c.
static const uint8_t foamPixels[] = {
#include "foam_texture.inc"
};
static_assert(sizeof(foamPixels) == 4 * SW_FOAM_TEXTURE_SIDE * SW_FOAM_TEXTURE_SIDE, "the foam texture has its size");

swResult swCreateFoamTexture(swGpu* gpu, swFoamTexture* foam)
{
    const swImageDef def = {
        .format = VK_FORMAT_R16G16B16A16_SFLOAT,
        .width = SW_FOAM_TEXTURE_SIDE,
        .height = SW_FOAM_TEXTURE_SIDE,
        .mips = SW_FOAM_TEXTURE_MIPS,
        .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
        .layout = VK_IMAGE_LAYOUT_GENERAL,
        .name = "foam texture",
    };
    return swCreateImage(gpu, &def, &foam->image);
}

void swDestroyFoamTexture(swGpu* gpu, swFoamTexture* foam)
{
    swDestroyImage(gpu, &foam->image);
}

// Half float of n / 255, exact to its last bit: the bytes are below 2^11, and halves of them are too.
static uint16_t halfOfByte(uint32_t byte)
{
    if (byte == 0)
    {
        return 0;
    }
    float value = (float)byte / 255.0f;
    uint32_t bits;
    memcpy(&bits, &value, sizeof(bits));
    uint32_t exponent = (bits >> 23) - 112;
    return (uint16_t)((exponent << 10) + ((bits & 0x7fffffu) >> 13));
}

swResult swPrepareFoamTexture(swGpu* gpu, swFoamTexture* foam)
{
    if (foam->image.isInitialized)
    {
        return SW_SUCCESS;
    }
    swResult result = swReserveUpload(gpu, sizeof(foamPixels) * sizeof(uint16_t), &foam->upload);
    uint16_t* pixels = foam->upload.data;
    for (size_t i = 0; i < sizeof(foamPixels) && result == SW_SUCCESS; ++i)
    {
        pixels[i] = halfOfByte(foamPixels[i]);
    }
    return result;
}

void swRecordFoamTexture(swGpu* gpu, VkCommandBuffer commands, const swPipeline* halve, swFoamTexture* foam)
{
    if (!foam->image.isInitialized)
    {
        swRecordImageUpload(gpu, commands, &foam->upload, &foam->image);
        swRecordMips(gpu, commands, halve, &foam->image);
        swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT);
    }
}

void swForgetFoamTexture(swFoamTexture* foam)
{
    foam->image.isInitialized = false;
}
