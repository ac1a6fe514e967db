// SPDX-License-Identifier: MIT
#include "gpu/draw/surface.h"

#include <string.h>

#include "surface_cull_shader.h"
#include "surface_shader.h"

swResult swCreateSurfacePipeline(swGpu* gpu, VkFormat color, VkFormat depth, int kind, swPipeline* pipeline)
{
    const swSurfaceConstants constants = {
        .isSoftware = gpu->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 1 : 0,
        .filtersByHand = gpu->filtersFloats ? 0 : 1,
        .isClear = (kind & SW_SURFACE_IS_CLEAR) != 0 ? 1 : 0,
        .hasPlaces = (kind & SW_SURFACE_HAS_PLACES) != 0 ? 1 : 0,
        .hasMadeFoam = (kind & SW_SURFACE_HAS_MADE_FOAM) != 0 ? 1 : 0,
        .hasColors = (kind & SW_SURFACE_HAS_COLORS) != 0 ? 1 : 0,
        .hasHoles = (kind & SW_SURFACE_HAS_HOLES) != 0 ? 1 : 0,
        .hasBodies = (kind & SW_SURFACE_HAS_BODIES) != 0 ? 1 : 0,
        .carriesFoam = (kind & SW_SURFACE_CARRIES_FOAM) != 0 ? 1 : 0,
        .hasWeights = (kind & SW_SURFACE_HAS_WEIGHTS) != 0 ? 1 : 0,
    };
    bool isWire = (kind & SW_SURFACE_IS_WIRE) != 0;
    const swGraphicsDef draw = {
        .vertex = &swSurfaceVertex,
        .fragment = &swSurfaceFragment,
        .constants = &constants,
        .colorFormat = color,
        .depthFormat = depth,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .polygonMode = isWire ? VK_POLYGON_MODE_LINE : VK_POLYGON_MODE_FILL,
        .depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL,
        .depthWrite = true,
        .name = isWire ? "surface wireframe" : "surface",
    };
    return swCreateGraphicsPipeline(gpu, &draw, pipeline);
}

swResult swCreateCullPipeline(swGpu* gpu, swPipeline* pipeline)
{
    return swCreateComputePipeline(gpu, &swSurfaceCullShader, NULL, pipeline);
}

swResult swCreateSurface(swGpu* gpu, swSurface* surface)
{
    swResult result = swCreateBuffer(gpu, SW_MAX_MESH_TILES * sizeof(swMeshTile), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                     SW_MEMORY_DEVICE, "visible mesh tiles", &surface->visible);
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, sizeof(VkDrawIndexedIndirectCommand),
                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                SW_MEMORY_DEVICE, "surface draw arguments", &surface->arguments);
    }
    return result;
}

void swRetireSurface(swGpu* gpu, swSurface* surface)
{
    swRetireBuffer(gpu, &surface->indices);
    swRetireBuffer(gpu, &surface->visible);
    swRetireBuffer(gpu, &surface->arguments);
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
    VkDeviceSize most = (VkDeviceSize)picture->params.tileCount * (picture->params.bodyCount + 1);
    swResult result = swGrowBuffer(gpu, most * sizeof(swMeshTile), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                   "visible mesh tiles", &surface->visible);
    return result == SW_SUCCESS ? fillIndices(gpu, surface, picture->params.tileSide) : result;
}

void swRecordSurface(const swGpuWorld* gpuWorld, VkCommandBuffer commands, const swPipeline* cull, swSurface* surface,
                     const swPictureFrame* picture)
{
    swGpu* gpu = gpuWorld->gpu;
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(gpuWorld, inputs);
    const swSurfaceCullBindings bindings = {
        .picture = swBindUpload(&picture->paramsUpload),
        .slices = swBindUpload(&picture->slicesUpload),
        .tiles = swBindUpload(&picture->tilesUpload),
        .visible = swBindBuffer(&surface->visible),
        .arguments = swBindBuffer(&surface->arguments),
        .bodies = swBindUpload(&picture->bodiesUpload),
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
    };
    swBeginPass(gpu, commands, "surface_cull");
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT, 0,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT);
    swBindSurfaceCull(gpu, commands, cull, &bindings);
    gpu->vk.CmdDispatch(commands, 1, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                  VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_READ_BIT);
    swEndPass(gpu, commands);
}

// A binding must have some image, also where the pipeline does not read it.
static swBinding bindOpaque(const swGpu* gpu, const swSurfaceSources* from, VkImageView view)
{
    return view != VK_NULL_HANDLE
               ? swBindView(gpu, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SW_SAMPLER_NEAREST_CLAMP)
               : swBindImage(gpu, &from->foam->image, SW_SAMPLER_NEAREST_CLAMP);
}

static swBinding bindFoam(const swGpu* gpu, const swSurfaceSources* from, int layer)
{
    return swBindImage(gpu, swGetLayerImage(from->view, layer), swChooseLayerSampler(gpu, layer));
}

void swDrawSurface(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swSurfaceSources* from,
                   const swSurface* surface, const swPictureFrame* picture)
{
    swBinding inputs[SW_INPUT_BINDINGS];
    swBindInputs(from->gpuWorld, inputs);
    const swSurfaceBindings bindings = {
        .picture = swBindUpload(&picture->paramsUpload),
        .slices = swBindUpload(&picture->slicesUpload),
        .tiles = swBindBuffer(&surface->visible),
        .displacement = swBindImage(gpu, swGetLayerImage(from->view, SW_LAYER_DISPLACEMENT), SW_SAMPLER_NEAREST_CLAMP),
        .bands = swBindUpload(&picture->bandsUpload),
        .light = swBindBuffer(&from->sky->light),
        .derivatives = swBindImage(gpu, swGetLayerImage(from->view, SW_LAYER_DERIVATIVES), SW_SAMPLER_LINEAR_CLAMP),
        .foamLayer = bindFoam(gpu, from, SW_LAYER_FOAM),
        .detail = swBindImage(gpu, swGetDetailImage(from->gpuWorld), SW_SAMPLER_LINEAR_REPEAT),
        .skyMap = swBindImage(gpu, &from->sky->map, SW_SAMPLER_LINEAR_REPEAT_X),
        .air = swBindImage(gpu, &from->sky->air, SW_SAMPLER_LINEAR_CLAMP),
        .foamTexture = swBindImage(gpu, &from->foam->image, SW_SAMPLER_LINEAR_REPEAT),
        .waves = swBindUpload(&picture->wavesUpload),
        .opaqueColor = bindOpaque(gpu, from, from->opaqueColor),
        .opaqueDepth = bindOpaque(gpu, from, from->opaqueDepth),
        .places = swBindImage(gpu, swGetLayerImage(from->view, SW_LAYER_PLACES), SW_SAMPLER_NEAREST_CLAMP),
        .wakeFoamLayer = bindFoam(gpu, from, SW_LAYER_WAKE_FOAM),
        .shoreFoamLayer = bindFoam(gpu, from, SW_LAYER_SHORE_FOAM),
        .flow = swBindImage(gpu, swGetLayerImage(from->view, SW_LAYER_FLOW), SW_SAMPLER_NEAREST_CLAMP),
        .inputHead = inputs[0],
        .inputRecords = inputs[1],
        .inputNodes = inputs[2],
        .inputWords = inputs[3],
        .bodies = swBindUpload(&picture->bodiesUpload),
        .looks = swBindUpload(&picture->looksUpload),
    };
    swBeginPass(gpu, commands, "surface");
    swBindSurface(gpu, commands, pipeline, &bindings);
    gpu->vk.CmdBindIndexBuffer(commands, surface->indices.handle, 0, VK_INDEX_TYPE_UINT16);
    gpu->vk.CmdDrawIndexedIndirect(commands, surface->arguments.handle, 0, 1, 0);
    swEndPass(gpu, commands);
}
