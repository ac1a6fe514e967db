// SPDX-License-Identifier: MIT
#include "gpu/record/record.h"

#include <math.h>

#include "gpu/pass/passes.h"
#include "gpu/vk/vk_submit.h"

// exp(2 pi i n / SW_TWIDDLES), through the upload ring of a frame that is waited for.
static swResult makeRoots(swGpuWorld* gpuWorld)
{
    swGpu* gpu = gpuWorld->gpu;
    float roots[SW_TWIDDLES][2];
    for (int n = 0; n < SW_TWIDDLES; ++n)
    {
        double angle = 2.0 * SW_PI * n / SW_TWIDDLES;
        roots[n][0] = (float)cos(angle);
        roots[n][1] = (float)sin(angle);
    }
    swResult result = swCreateBuffer(gpu, sizeof(roots), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                     "roots of unity", &gpuWorld->roots);
    VkCommandBuffer commands = VK_NULL_HANDLE;
    result = result == SW_SUCCESS ? swBeginSubmit(gpu, &commands) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    gpu->vk.CmdUpdateBuffer(commands, gpuWorld->roots.handle, 0, sizeof(roots), roots);
    return swEndSubmit(gpu);
}

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
    swResult result = makeRoots(gpuWorld);
    result = result == SW_SUCCESS ? swCreateDetail(gpu, &gpuWorld->passes) : result;
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
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swDestroyGpuView(gpu, &gpuWorld->views[i]);
    }
    swDestroyImage(gpu, &gpuWorld->detail);
    swDestroyBuffer(gpu, &gpuWorld->roots);
    swDestroyBuffer(gpu, &gpuWorld->modes);
    swDestroyBuffer(gpu, &gpuWorld->rows);
    swDestroyBuffer(gpu, &gpuWorld->lines);
    swDestroyBuffer(gpu, &gpuWorld->texels);
    swDestroyBuffer(gpu, &gpuWorld->volumeWaves);
    swDestroyPasses(gpu, &gpuWorld->passes);
    swFree(&gpu->host, gpuWorld, sizeof(swGpuWorld));
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

static void showToDrawing(swGpu* gpu, VkCommandBuffer commands)
{
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_COPY_BIT,
              VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

// Spectra to tiles, unless the core has made them.
static void recordWaves(swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swRecordVolumeWaves(gpuWorld, commands); // beside the rows: both read modes only
    if (gpuWorld->hasCoreTiles)
    {
        return;
    }
    swRecordWavesRows(gpuWorld, commands);
    swComputeBarrier(gpu, commands);
    swRecordWavesColumns(gpuWorld, commands);
    swComputeBarrier(gpu, commands);
}

swResult swRecordFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex)
{
    swGpu* gpu = gpuWorld->gpu;
    const swFrame* frame = swGetWorldFrame(gpuWorld->world);
    gpuWorld->isRecorded = false;
    swBeginGpuFrame(gpu, frameIndex);
    swResult result = swPrepareFrame(gpuWorld, frame);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swStartPassTimer(gpu, commands);
    waitForFrameBefore(gpu, commands);
    swRecordUploads(gpuWorld, commands);
    recordWaves(gpuWorld, commands);
    swRecordDetail(gpuWorld, commands); // beside the slices: both read tiles only
    swRecordSlices(gpuWorld, commands);
    swRecordSurfaceQuery(gpuWorld, commands); // likewise
    swRecordRayQuery(gpuWorld, commands);
    swComputeBarrier(gpu, commands);
    swRecordFoam(gpuWorld, commands);
    swRecordVolumeQuery(gpuWorld, commands); // beside the foam: it reads the surface's heights
    swRecordQueryCopies(gpuWorld, commands, frame);
    showToDrawing(gpu, commands);
    gpuWorld->frameIndex = frameIndex;
    gpuWorld->isRecorded = true;
    swCommitFrame(gpuWorld, frame);
    return SW_SUCCESS;
}

swResult swReadDetail(swGpuWorld* gpuWorld, int tile, uint32_t mip, float* texels)
{
    return swReadHalves(gpuWorld->gpu, &gpuWorld->detail, (uint32_t)tile, mip, texels);
}

swResult swReadTile(swGpuWorld* gpuWorld, int tile, float* texels)
{
    const VkDeviceSize texel = 4 * sizeof(float);
    const swTileParams* params = &gpuWorld->params[tile];
    return swReadBuffer(gpuWorld->gpu, &gpuWorld->texels, params->firstTexel * texel,
                        (VkDeviceSize)params->resolution * (params->resolution + 3) * texel, texels);
}
