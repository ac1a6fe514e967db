// SPDX-License-Identifier: MIT
// A frame is recorded all or nothing: first everything is prepared that may fail, and nothing is recorded; then
// commands are recorded, which cannot fail; then what the device will hold is noted. A host that drops the commands
// after all says so with swGpuWorld_Discard(), which takes the notes back.

#include "gpu/record/record.h"

#include "gpu/pass/passes.h"

swResult swMakeGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** out)
{
    *out = NULL;
    swGpuWorld* gpuWorld = swAllocateZero(&gpu->host, sizeof(swGpuWorld));
    if (gpuWorld == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "no memory for a swGpuWorld");
    }
    gpuWorld->gpu = gpu;
    gpuWorld->world = world;
    swResult result = swCreateGpuTiles(gpuWorld);
    result = result == SW_SUCCESS ? swCreatePasses(gpuWorld) : result;
    if (result != SW_SUCCESS)
    {
        swFreeGpuWorld(gpuWorld);
        return result;
    }
    *out = gpuWorld;
    return SW_SUCCESS;
}

void swFreeGpuWorld(swGpuWorld* gpuWorld)
{
    if (gpuWorld == NULL)
    {
        return;
    }
    swGpu* gpu = gpuWorld->gpu;
    while (gpuWorld->firstQuery != NULL)
    {
        swFreeGpuQuery(gpuWorld->firstQuery);
    }
    swDestroyGpuViews(gpu, gpuWorld->views);
    swDestroyPasses(gpuWorld);
    swDestroyGpuTiles(gpu, &gpuWorld->tiles);
    swDestroyGpuInputs(gpu, &gpuWorld->inputs);
    swFree(&gpu->host, gpuWorld, sizeof(swGpuWorld));
}

size_t swGetGpuWorldMemory(const swGpuWorld* gpuWorld)
{
    size_t bytes = swGetGpuTileMemory(&gpuWorld->tiles) + swGetGpuInputMemory(&gpuWorld->inputs) +
                   swGetGpuViewMemory(gpuWorld->views) + swGetPassMemory(gpuWorld);
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        bytes += swGetQueryMemory(query);
    }
    return bytes;
}

// Everything that recorded work may have written or may still read, before this frame's first write.
static void waitForFrameBefore(swGpu* gpu, VkCommandBuffer commands)
{
    const VkPipelineStageFlags2 shaders = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                          VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                          VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    swBarrier(gpu, commands, shaders | VK_PIPELINE_STAGE_2_COPY_BIT,
              VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_COPY_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                  VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

// To drawing, and answers to the host.
static void showFrame(swGpu* gpu, VkCommandBuffer commands, bool toHost)
{
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_COPY_BIT,
              VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | (toHost ? VK_PIPELINE_STAGE_2_HOST_BIT : 0),
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT |
                  (toHost ? VK_ACCESS_2_HOST_READ_BIT : 0));
}

static swResult prepareFrame(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swResult result = swPrepareGpuTiles(gpuWorld, frame);
    result = result == SW_SUCCESS ? swPrepareGpuInputs(gpuWorld, frame) : result;
    result = result == SW_SUCCESS ? swPrepareGpuViews(gpuWorld->gpu, frame, gpuWorld->views) : result;
    result = result == SW_SUCCESS ? swUploadQueries(gpuWorld, frame) : result;
    return result == SW_SUCCESS ? swPreparePasses(gpuWorld, frame) : result;
}

static void recordCopies(swGpuWorld* gpuWorld, VkCommandBuffer commands, swHazards* hazards)
{
    swGpu* gpu = gpuWorld->gpu;
    const swGpuTiles* tiles = &gpuWorld->tiles;
    swCopyGpuTiles(gpu, commands, tiles);
    swCopyGpuInputs(gpu, commands, &gpuWorld->inputs);
    bool hasLayers = swCopyGpuViews(gpu, commands, gpuWorld->views);
    swResources writes = (tiles->bringsModes || tiles->bringsLikeness ? SW_MODES_BIT : 0) |
                         (tiles->isCore ? SW_TEXELS_BIT : 0) | (gpuWorld->inputs.isBrought ? SW_INPUTS_BIT : 0) |
                         (hasLayers ? SW_ALL_LAYERS_BITS : 0);
    swOrderStep(gpu, commands, hazards, SW_STAGE_COPY, 0, writes);
}

// Answers of queries to where the host reads them. Returns whether there were any.
static bool recordAnswers(swGpuWorld* gpuWorld, VkCommandBuffer commands, swHazards* hazards)
{
    if (!swHasAnswers(gpuWorld))
    {
        return false;
    }
    const swResources answers =
        SW_OUTPUT_BIT(SW_PASS_SURFACE_QUERY) | SW_OUTPUT_BIT(SW_PASS_VOLUME_QUERY) | SW_OUTPUT_BIT(SW_PASS_RAY_QUERY);
    swOrderStep(gpuWorld->gpu, commands, hazards, SW_STAGE_COPY, answers, 0);
    swCopyAnswers(gpuWorld, commands);
    return true;
}

swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex)
{
    swGpu* gpu = gpuWorld->gpu;
    const swFrame* frame = swGetWorldFrame(gpuWorld->world);
    gpuWorld->isRecorded = false;
    swBeginGpuFrame(gpu, frameIndex);
    swResult result = prepareFrame(gpuWorld, frame);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swHazards hazards = {0};
    swStartPassTimer(gpu, commands);
    waitForFrameBefore(gpu, commands);
    recordCopies(gpuWorld, commands, &hazards);
    swRecordPasses(gpuWorld, commands, &hazards);
    bool toHost = recordAnswers(gpuWorld, commands, &hazards);
    showFrame(gpu, commands, toHost);

    gpuWorld->frameIndex = frameIndex;
    gpuWorld->isRecorded = true;
    swCommitGpuTiles(&gpuWorld->tiles, frame);
    swCommitGpuInputs(&gpuWorld->inputs, frame);
    swCommitGpuViews(frameIndex, gpuWorld->views);
    swCommitQueries(gpuWorld, frame);
    return SW_SUCCESS;
}

void swDiscardFrames(swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    gpuWorld->isRecorded = false;
    gpuWorld->discardCount += 1;
    gpuWorld->discardedFrom = frameIndex;
    swDiscardGpuFrame(gpuWorld->gpu);
    swDiscardGpuTiles(&gpuWorld->tiles);
    swDiscardGpuInputs(&gpuWorld->inputs);
    swDiscardGpuViews(gpuWorld->views, frameIndex);
    swDiscardPasses(gpuWorld, frameIndex);
    swDiscardQueries(gpuWorld, frameIndex);
}

swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels)
{
    return swReadHalves(gpuWorld->gpu, swGetDetailImage(gpuWorld), (uint32_t)tile, mip, texels);
}

swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels)
{
    const VkDeviceSize texel = 4 * sizeof(float);
    const swTileParams* params = &gpuWorld->tiles.params[tile];
    return swReadBuffer(gpuWorld->gpu, &gpuWorld->tiles.texels, params->firstTexel * texel,
                        (VkDeviceSize)params->resolution * (params->resolution + 3) * texel, texels);
}
