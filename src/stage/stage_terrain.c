// SPDX-License-Identifier: MIT
// Land and sea floor behind and under the water: a pipeline by public calls alone, as a host would have it.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/input.h"
#include "stage/terrain_tiles.h"

#define SW_TERRAIN_COOKIE 0x544552
#define SW_TERRAIN_MOST_TILES 768  // drawn at once
#define SW_TERRAIN_PERIOD 262144.0 // m, of the patterns on the ground

static const uint32_t vertexCode[] =
#include "terrain.vert.inc"
    ;
static const uint32_t fragmentCode[] =
#include "terrain.frag.inc"
    ;

struct swStageTerrain
{
    swStage* stage;
    swTerrainTiles tiles;
    VkSampler sampler;
    VkDescriptorSetLayout setLayout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    swStageBuffer indices, vertices;
    swStageBuffer chosen[SW_STAGE_MAX_SLOTS]; // of frames in flight
    int slot;
    int tileCount; // of the prepared shot
    swTerrainPush push;
};

swStageTerrainDef swDefaultStageTerrainDef(void)
{
    return (swStageTerrainDef){.finestSpacing = 0.5f, .reach = 50e3f, .internalValue = SW_TERRAIN_COOKIE};
}

static VkResult createLayouts(swStageTerrain* terrain)
{
    const VkShaderStageFlags both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorType buffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    const VkDescriptorSetLayoutBinding bindings[] = {
        {.binding = 0, .descriptorType = buffer, .descriptorCount = 1, .stageFlags = both},
        {.binding = 1, .descriptorType = buffer, .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT},
        {.binding = 2,
         .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
         .descriptorCount = 1,
         .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT},
        {.binding = 3, .descriptorType = buffer, .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_VERTEX_BIT},
        {.binding = 4, .descriptorType = buffer, .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_VERTEX_BIT},
    };
    return swCreateStageLayout(terrain->stage, 5, bindings, sizeof(swTerrainPush), &terrain->setLayout,
                               &terrain->layout);
}

static VkResult createPipeline(swStageTerrain* terrain)
{
    const swPictureDef formats = swDefaultPictureDef();
    const swStagePipelineDef def = {
        .vertex = vertexCode,
        .fragment = fragmentCode,
        .vertexSize = sizeof(vertexCode),
        .fragmentSize = sizeof(fragmentCode),
        .layout = terrain->layout,
        .input = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO},
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
        .blend = {.colorWriteMask = 15},
        .colorFormat = formats.colorFormat,
        .depthFormat = formats.depthFormat,
    };
    return swCreateStagePipeline(terrain->stage, &def, &terrain->pipeline);
}

static VkResult createObjects(swStageTerrain* terrain)
{
    const swStage* stage = terrain->stage;
    const VkSamplerCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
        .magFilter = VK_FILTER_LINEAR,
        .minFilter = VK_FILTER_LINEAR,
        .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
    };
    VkResult result = stage->vk.CreateSampler(stage->device, &info, NULL, &terrain->sampler);
    result = result != VK_SUCCESS ? result : createLayouts(terrain);
    return result != VK_SUCCESS ? result : createPipeline(terrain);
}

static void fillIndices(uint16_t* index)
{
    for (int i = 0; i < SW_TERRAIN_QUADS * SW_TERRAIN_QUADS; ++i)
    {
        int a = i / SW_TERRAIN_QUADS * SW_TERRAIN_SIDE + i % SW_TERRAIN_QUADS;
        int b = a + SW_TERRAIN_SIDE;
        const int corners[6] = {a, b, b + 1, a, b + 1, a + 1};
        for (int k = 0; k < 6; ++k)
        {
            *index++ = (uint16_t)corners[k];
        }
    }
}

static swResult createBuffers(swStageTerrain* terrain)
{
    swStage* stage = terrain->stage;
    const VkDeviceSize quads = SW_TERRAIN_QUADS * SW_TERRAIN_QUADS;
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    swResult result =
        swStage_CreateBuffer(stage, 6 * quads * sizeof(uint16_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT, &terrain->indices);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    fillIndices(terrain->indices.data);
    result = swStage_CreateBuffer(stage, sizeof(swTerrainVertex) * SW_TERRAIN_SLOTS * SW_TERRAIN_VERTICES, storage,
                                  &terrain->vertices);
    for (int i = 0; i < SW_STAGE_MAX_SLOTS && result == SW_SUCCESS; ++i)
    {
        result =
            swStage_CreateBuffer(stage, SW_TERRAIN_MOST_TILES * sizeof(swTerrainTile), storage, &terrain->chosen[i]);
    }
    terrain->tiles.vertices = terrain->vertices.data;
    return result;
}

// Land and sea floor as the world's inputs have them.
static void findWorldFloor(void* context, int count, const swPosXZ* points, float* heights)
{
    const swFieldSamples samples = {.floor = heights};
    swMoment_QueryFields(swWorld_GetMoment(context), count, points, &samples);
    for (int i = 0; i < count; ++i)
    {
        heights[i] = isfinite(heights[i]) ? heights[i] : NAN;
    }
}

// Squares from the finest up to one that is as wide as a third of the reach.
static void setTree(swTerrainTiles* tiles, const swStageTerrainDef* def)
{
    tiles->floor = def->world != NULL ? findWorldFloor : def->floor;
    tiles->context = def->world != NULL ? (void*)(uintptr_t)def->world : def->context;
    tiles->reach = (double)def->reach;
    tiles->finestSide = SW_TERRAIN_QUADS * (double)def->finestSpacing;
    tiles->levelCount = 1;
    while (tiles->levelCount < SW_TERRAIN_LEVELS && ldexp(tiles->finestSide, tiles->levelCount) < tiles->reach / 3.0)
    {
        ++tiles->levelCount;
    }
}

static bool isTerrainDefGood(const swStageTerrainDef* def)
{
    return (def->floor != NULL) != (def->world != NULL) && def->finestSpacing >= 0.01f &&
           def->finestSpacing <= 1000.0f && def->reach >= 10.0f && def->reach <= 1e6f;
}

swResult swStage_CreateTerrain(swStage* stage, const swStageTerrainDef* def, swStageTerrain** terrain)
{
    if (terrain != NULL)
    {
        *terrain = NULL;
    }
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_CreateTerrain() needs a stage");
    SW_REQUIRE(def != NULL && def->internalValue == SW_TERRAIN_COOKIE && terrain != NULL, SW_ERROR_INVALID,
               &stage->host,
               "swStage_CreateTerrain() needs a def made by swDefaultStageTerrainDef() and a place for the terrain");
    SW_REQUIRE(isTerrainDefGood(def), SW_ERROR_INVALID, &stage->host,
               "swStage_CreateTerrain() needs a world or a function of the floor, not both, a spacing from 0.01 to "
               "1000 m and a reach from 10 "
               "m to 1000 km; it was given %g m and %g m",
               (double)def->finestSpacing, (double)def->reach);
    swStageTerrain* created = swAllocateZero(&stage->host, sizeof(*created));
    if (created == NULL)
    {
        return swFail(&stage->host, SW_ERROR_NO_MEMORY, "No memory for a terrain.");
    }
    created->stage = stage;
    setTree(&created->tiles, def);
    swResult result = createBuffers(created);
    result = result == SW_SUCCESS ? swCheckStage(stage, createObjects(created), "making the land's pipeline") : result;
    if (result != SW_SUCCESS)
    {
        swStage_DestroyTerrain(stage, created);
        return result;
    }
    *terrain = created;
    return SW_SUCCESS;
}

void swStage_DestroyTerrain(swStage* stage, swStageTerrain* terrain)
{
    if (terrain == NULL)
    {
        return;
    }
    SW_REQUIRE_VOID(stage == terrain->stage, &terrain->stage->host,
                    "swStage_DestroyTerrain() needs the stage that made the terrain");
    stage->vk.DestroyPipeline(stage->device, terrain->pipeline, NULL);
    stage->vk.DestroyPipelineLayout(stage->device, terrain->layout, NULL);
    stage->vk.DestroyDescriptorSetLayout(stage->device, terrain->setLayout, NULL);
    stage->vk.DestroySampler(stage->device, terrain->sampler, NULL);
    for (int i = 0; i < SW_STAGE_MAX_SLOTS; ++i)
    {
        swStage_DestroyBuffer(stage, &terrain->chosen[i]);
    }
    swStage_DestroyBuffer(stage, &terrain->vertices);
    swStage_DestroyBuffer(stage, &terrain->indices);
    swFree(&stage->host, terrain, sizeof(*terrain));
}

void swStageTerrain_Refresh(swStageTerrain* terrain)
{
    SW_REQUIRE_VOID(terrain != NULL, NULL, "swStageTerrain_Refresh() needs a terrain");
    if (swStage_Wait(terrain->stage) == SW_SUCCESS) // frames in flight read the vertices
    {
        swForgetTerrain(&terrain->tiles);
    }
}

static swResult createOpaque(swStage* stage, swStageTargets* targets)
{
    if (targets->opaqueColor.image != VK_NULL_HANDLE)
    {
        return SW_SUCCESS;
    }
    const swPictureDef formats = swDefaultPictureDef();
    const VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    const swStageImageDef color = {.name = "the land's picture",
                                   .format = formats.colorFormat,
                                   .usage = usage,
                                   .width = targets->hdr.width,
                                   .height = targets->hdr.height};
    swStageImageDef depth = color;
    depth.name = "the land's depth";
    depth.format = formats.depthFormat;
    swResult result = swStage_CreateImage(stage, &color, &targets->opaqueColor);
    if (result == SW_SUCCESS)
    {
        depth.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT; // so that its view is one of depth
        result = swStage_CreateImage(stage, &depth, &targets->opaqueDepth);
    }
    if (result != SW_SUCCESS)
    {
        swStage_DestroyImage(stage, &targets->opaqueColor);
    }
    return result;
}

static float wrapPlace(double x)
{
    return (float)(x - floor(x / SW_TERRAIN_PERIOD) * SW_TERRAIN_PERIOD);
}

swResult swStageTerrain_Prepare(swStageTerrain* terrain, swStageTargets* targets, swShot* shot)
{
    SW_REQUIRE(terrain != NULL, SW_ERROR_INVALID, NULL, "swStageTerrain_Prepare() needs a terrain");
    SW_REQUIRE(targets != NULL && targets->hdr.image != VK_NULL_HANDLE && shot != NULL, SW_ERROR_INVALID,
               &terrain->stage->host, "swStageTerrain_Prepare() needs targets and a shot");
    const swPos* eye = &shot->camera.position;
    SW_REQUIRE(fabs(eye->x) < 1e12 && fabs(eye->y) < 1e12 && fabs(eye->z) < 1e12, SW_ERROR_INVALID,
               &terrain->stage->host, "swStageTerrain_Prepare() needs a camera within 1e12 m of the origin");
    double eyeHeight = fabs(eye->y);
    terrain->slot = (terrain->slot + 1) % SW_STAGE_MAX_SLOTS;
    terrain->tileCount = swChooseTerrain(&terrain->tiles, &shot->camera, eyeHeight, terrain->chosen[terrain->slot].data,
                                         SW_TERRAIN_MOST_TILES);
    swResult result = terrain->tileCount > 0 ? createOpaque(terrain->stage, targets) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    terrain->push = (swTerrainPush){.cameraY = (float)eye->y,
                                    .eyeHeight = (float)eyeHeight,
                                    .wetHeight = 1.0f,
                                    .placeX = wrapPlace(eye->x),
                                    .placeZ = wrapPlace(eye->z)};
    bool isSeen = terrain->tileCount > 0;
    shot->opaqueColor = isSeen ? targets->opaqueColor.view : VK_NULL_HANDLE;
    shot->opaqueDepth = isSeen ? targets->opaqueDepth.view : VK_NULL_HANDLE;
    return SW_SUCCESS;
}

bool swIsTerrainSeen(const swStageTerrain* terrain)
{
    return terrain != NULL && terrain->tileCount > 0;
}

static void pushDescriptors(const swStageTerrain* terrain, VkCommandBuffer commands, const swPictureSources* sources)
{
    const VkDescriptorBufferInfo buffers[4] = {
        {sources->params, sources->paramsOffset, sources->paramsSize},
        {sources->light, 0, VK_WHOLE_SIZE},
        {terrain->chosen[terrain->slot].buffer, 0, VK_WHOLE_SIZE},
        {terrain->vertices.buffer, 0, VK_WHOLE_SIZE},
    };
    const VkDescriptorImageInfo air = {terrain->sampler, sources->air, VK_IMAGE_LAYOUT_GENERAL};
    const uint32_t bindings[4] = {0, 1, 3, 4};
    VkWriteDescriptorSet writes[5];
    for (int i = 0; i < 4; ++i)
    {
        writes[i] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                           .dstBinding = bindings[i],
                                           .descriptorCount = 1,
                                           .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                           .pBufferInfo = &buffers[i]};
    }
    writes[4] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                       .dstBinding = 2,
                                       .descriptorCount = 1,
                                       .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                       .pImageInfo = &air};
    terrain->stage->vk.CmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, terrain->layout, 0, 5,
                                               writes);
}

void swDrawTerrain(const swStageTerrain* terrain, VkCommandBuffer commands, const swPicture* picture)
{
    swPictureSources sources;
    if (terrain->tileCount == 0 || swPicture_GetSources(picture, &sources) != SW_SUCCESS)
    {
        return;
    }
    const swStageVk* vk = &terrain->stage->vk;
    vk->CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, terrain->pipeline);
    pushDescriptors(terrain, commands, &sources);
    vk->CmdBindIndexBuffer(commands, terrain->indices.buffer, 0, VK_INDEX_TYPE_UINT16);
    vk->CmdPushConstants(commands, terrain->layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                         sizeof(terrain->push), &terrain->push);
    vk->CmdDrawIndexed(commands, 6 * SW_TERRAIN_QUADS * SW_TERRAIN_QUADS, (uint32_t)terrain->tileCount, 0, 0, 0);
}
