// SPDX-License-Identifier: MIT
#include "gpu/draw/surface.h"

#include <string.h>

#include "surface_cull_shader.h"
#include "surface_shader.h"

// RGBA, SW_FOAM_TEXTURE_SIDE squared. See generators/foam_texture.c.
static const uint8_t foamPixels[] = {
#include "foam_texture.inc"
};
static_assert(sizeof(foamPixels) == 4 * SW_FOAM_TEXTURE_SIDE * SW_FOAM_TEXTURE_SIDE, "the foam texture has its size");

static swResult createSurfacePipelines(swGpu* gpu, const swRendererDef* def, swSurface* surface)
{
    swResult result = swCreateComputePipeline(gpu, &swSurfaceCullShader, NULL, &surface->cullPipeline);
    const swSurfaceConstants constants = {
        .isSoftware = gpu->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 1 : 0,
    };
    swGraphicsDef draw = {
        .vertex = &swSurfaceVertex,
        .fragment = &swSurfaceFragment,
        .constants = &constants,
        .colorFormat = def->colorFormat,
        .depthFormat = def->depthFormat,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL,
        .depthWrite = true,
        .name = "surface",
    };
    if (result == SW_SUCCESS)
    {
        result = swCreateGraphicsPipeline(gpu, &draw, &surface->drawPipeline);
    }
    if (result == SW_SUCCESS && gpu->hasWireframe)
    {
        draw.polygonMode = VK_POLYGON_MODE_LINE;
        draw.name = "surface wireframe";
        result = swCreateGraphicsPipeline(gpu, &draw, &surface->wirePipeline);
    }
    return result;
}

swResult swCreateSurface(swGpu* gpu, const swRendererDef* def, swSurface* surface)
{
    swResult result = createSurfacePipelines(gpu, def, surface);
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, SW_MAX_MESH_TILES * sizeof(swMeshTile), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                SW_MEMORY_DEVICE, "visible mesh tiles", &surface->visible);
    }
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, sizeof(VkDrawIndexedIndirectCommand),
                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                SW_MEMORY_DEVICE, "surface draw arguments", &surface->arguments);
    }
    if (result == SW_SUCCESS)
    {
        const swImageDef foam = {
            .format = VK_FORMAT_R16G16B16A16_SFLOAT,
            .width = SW_FOAM_TEXTURE_SIDE,
            .height = SW_FOAM_TEXTURE_SIDE,
            .mips = SW_FOAM_TEXTURE_MIPS,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .layout = VK_IMAGE_LAYOUT_GENERAL,
            .name = "foam texture",
        };
        result = swCreateImage(gpu, &foam, &surface->foamTexture);
    }
    return result;
}

void swDestroySurface(swGpu* gpu, swSurface* surface)
{
    swDestroyPipeline(gpu, &surface->cullPipeline);
    swDestroyPipeline(gpu, &surface->drawPipeline);
    swDestroyPipeline(gpu, &surface->wirePipeline);
    swDestroyBuffer(gpu, &surface->indices);
    swDestroyBuffer(gpu, &surface->visible);
    swDestroyBuffer(gpu, &surface->arguments);
    swDestroyImage(gpu, &surface->foamTexture);
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

static swResult prepareFoamTexture(swGpu* gpu, swSurface* surface)
{
    swResult result = swReserveUpload(gpu, sizeof(foamPixels) * sizeof(uint16_t), &surface->foamUpload);
    uint16_t* pixels = surface->foamUpload.data;
    for (size_t i = 0; i < sizeof(foamPixels) && result == SW_SUCCESS; ++i)
    {
        pixels[i] = halfOfByte(foamPixels[i]);
    }
    return result;
}

// Two triangles a quad, all with the same diagonal: a ring that moves on by one step must not turn a quad over.
static swResult fillIndices(swGpu* gpu, swSurface* surface, uint32_t side)
{
    if (surface->indicesSide == side)
    {
        return SW_SUCCESS;
    }
    swBuffer created;
    swResult result = swCreateBuffer(gpu, 6 * side * side * sizeof(uint16_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                     SW_MEMORY_UPLOAD, "surface indices", &created);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swRetireBuffer(gpu, &surface->indices);
    surface->indices = created;
    uint16_t* index = surface->indices.mapped;
    for (uint32_t z = 0; z < side; ++z)
    {
        for (uint32_t x = 0; x < side; ++x)
        {
            uint32_t a = z * (side + 1) + x;
            uint32_t b = a + side + 1;
            *index++ = (uint16_t)a;
            *index++ = (uint16_t)b;
            *index++ = (uint16_t)(b + 1);
            *index++ = (uint16_t)a;
            *index++ = (uint16_t)(b + 1);
            *index++ = (uint16_t)(a + 1);
        }
    }
    surface->indicesSide = side;
    return SW_SUCCESS;
}

swResult swPrepareSurface(swGpu* gpu, swSurface* surface, const swPictureFrame* picture)
{
    swResult result = fillIndices(gpu, surface, picture->params.tileSide);
    return result == SW_SUCCESS && !surface->foamTexture.isInitialized ? prepareFoamTexture(gpu, surface) : result;
}

void swForgetSurface(swSurface* surface)
{
    surface->foamTexture.isInitialized = false;
}

void swRecordSurface(swGpu* gpu, VkCommandBuffer commands, swSurface* surface, const swPipeline* halve,
                     const swPictureFrame* picture)
{
    if (!surface->foamTexture.isInitialized)
    {
        swRecordImageUpload(gpu, commands, &surface->foamUpload, &surface->foamTexture);
        swRecordMips(gpu, commands, halve, &surface->foamTexture);
    }
    const swSurfaceCullBindings bindings = {
        .picture = swBindUpload(&picture->paramsUpload),
        .slices = swBindUpload(&picture->slicesUpload),
        .tiles = swBindUpload(&picture->tilesUpload),
        .visible = swBindBuffer(&surface->visible),
        .arguments = swBindBuffer(&surface->arguments),
    };
    swBeginPass(gpu, commands, "surface_cull");
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT, 0,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT);
    swBindSurfaceCull(gpu, commands, &surface->cullPipeline, &bindings);
    gpu->vk.CmdDispatch(commands, 1, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                  VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_READ_BIT);
    swEndPass(gpu, commands);
}

void swDrawSurface(swGpu* gpu, VkCommandBuffer commands, const swSurface* surface, const swSky* sky,
                   const swGpuWorld* gpuWorld, const swGpuView* view, const swPictureFrame* picture)
{
    const swSurfaceBindings bindings = {
        .picture = swBindUpload(&picture->paramsUpload),
        .slices = swBindUpload(&picture->slicesUpload),
        .tiles = swBindBuffer(&surface->visible),
        .displacement = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
        .bands = swBindUpload(&picture->bandsUpload),
        .light = swBindBuffer(&sky->light),
        .derivatives = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_DERIVATIVES), SW_SAMPLER_LINEAR_CLAMP),
        .foamLayer = swBindImage(gpu, swGetLayerImage(view, SW_LAYER_FOAM), SW_SAMPLER_LINEAR_CLAMP),
        .detail = swBindImage(gpu, &gpuWorld->detail, SW_SAMPLER_LINEAR_REPEAT),
        .skyMap = swBindImage(gpu, &sky->map, SW_SAMPLER_LINEAR_REPEAT_X),
        .air = swBindImage(gpu, &sky->air, SW_SAMPLER_LINEAR_CLAMP),
        .foamTexture = swBindImage(gpu, &surface->foamTexture, SW_SAMPLER_LINEAR_REPEAT),
        .waves = swBindUpload(&picture->wavesUpload),
    };
    bool isWire = picture->params.debugMode == SW_DEBUG_WIREFRAME && surface->wirePipeline.handle != VK_NULL_HANDLE;
    swBeginPass(gpu, commands, "surface");
    swBindSurface(gpu, commands, isWire ? &surface->wirePipeline : &surface->drawPipeline, &bindings);
    gpu->vk.CmdBindIndexBuffer(commands, surface->indices.handle, 0, VK_INDEX_TYPE_UINT16);
    gpu->vk.CmdDrawIndexedIndirect(commands, surface->arguments.handle, 0, 1, 0);
    swEndPass(gpu, commands);
}
