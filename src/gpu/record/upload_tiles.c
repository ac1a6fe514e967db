// SPDX-License-Identifier: MIT
// The waves of a frame: modes when a spectrum or the list of tiles changed, the tiles' parameters, and where the core
// makes the tiles, their texels.

#include <math.h>
#include <string.h>

#include "gpu/pass/passes.h"
#include "gpu/record/record.h"

static bool tilesChanged(const swGpuWorld* gpuWorld, const swFrame* frame)
{
    if (!gpuWorld->hasTiles || gpuWorld->tilesVersion != frame->tilesVersion)
    {
        return true;
    }
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (gpuWorld->spectrumVersions[i] != frame->tiles[i].spectrumVersion)
        {
            return true;
        }
    }
    return false;
}

// Where each tile's part of the buffers begins; the totals come last.
typedef struct swTileLayout
{
    uint32_t modeCount, rowCount, lineCount, texelCount;
    int detailSide;
} swTileLayout;

static void fillTileParams(swGpuWorld* gpuWorld, const swFrame* frame, swTileLayout* layout)
{
    *layout = (swTileLayout){.detailSide = SW_DETAIL_MIN};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        uint64_t ticks = (uint64_t)swGetTileTicks(tile, frame->ticks);
        uint32_t resolution = (uint32_t)tile->resolution;
        uint32_t maxBin = (uint32_t)tile->maxBin;
        gpuWorld->params[i] = (swTileParams){
            .firstRow = layout->rowCount,
            .firstLine = layout->lineCount,
            .firstTexel = layout->texelCount,
            .resolution = resolution,
            .maxBin = maxBin,
            .ticksLow = (uint32_t)ticks,
            .ticksHigh = (uint32_t)(ticks >> 32),
            .weight = tile->weight,
            .side = (float)tile->side,
            .minWavelength = tile->minWavelength,
            .maxWavelength = tile->maxWavelength,
            .slopeVarianceX = tile->slopeVarianceX,
            .slopeVarianceZ = tile->slopeVarianceZ,
            .depth = fminf(tile->depth, 1e30f), // shaders need not know infinity
            .firstMode = layout->modeCount,
            .modeCount = (uint32_t)tile->modeCount,
        };
        layout->rowCount += maxBin + 2;
        layout->lineCount += 3 * (maxBin + 1) * resolution;
        layout->texelCount += resolution * (resolution + 3);
        layout->modeCount += (uint32_t)tile->modeCount;
        layout->detailSide = tile->resolution > layout->detailSide ? tile->resolution : layout->detailSide;
    }
    layout->detailSide = layout->detailSide < SW_DETAIL_MAX ? layout->detailSide : SW_DETAIL_MAX;
}

// What queries of this frame want of the tiles.
static void chooseFields(swGpuWorld* gpuWorld, const swTileLayout* layout)
{
    uint32_t wanted = swFindWantedFields(gpuWorld);
    swTileFields* fields = &gpuWorld->fields;
    *fields = (swTileFields){.count = 1, .lines = layout->lineCount, .texels = layout->texelCount};
    if ((wanted & SW_GPU_QUERY_VELOCITY) != 0)
    {
        fields->derivatives |= 1u << (2 * fields->count);
        fields->velocity = fields->count++;
    }
    if ((wanted & SW_GPU_QUERY_ACCELERATION) != 0)
    {
        fields->derivatives |= 2u << (2 * fields->count);
        fields->acceleration = fields->count++;
    }
}

// Lines and texels are made anew in each frame, so they may grow in any; modes and rows grow only when they change.
static swResult growBuffers(swGpuWorld* gpuWorld, const swTileLayout* layout)
{
    VkDeviceSize fields = gpuWorld->fields.count;
    const struct
    {
        swBuffer* buffer;
        VkDeviceSize size;
        const char* name;
    } needs[] = {
        {&gpuWorld->modes, layout->modeCount * sizeof(swMode), "modes"},
        {&gpuWorld->rows, layout->rowCount * sizeof(uint32_t), "mode rows"},
        {&gpuWorld->lines, fields * layout->lineCount * 2 * sizeof(float), "FFT lines"},
        {&gpuWorld->texels, fields * layout->texelCount * 4 * sizeof(float), "tile texels"},
    };
    for (size_t i = 0; i < sizeof(needs) / sizeof(needs[0]); ++i)
    {
        VkDeviceSize size = needs[i].size > 256 ? needs[i].size : 256; // something to bind when there are no waves
        VkBuffer before = needs[i].buffer->handle;
        swResult result = swGrowBuffer(gpuWorld->gpu, size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                       needs[i].name, needs[i].buffer);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        bool isKept = needs[i].buffer == &gpuWorld->modes || needs[i].buffer == &gpuWorld->rows;
        if (isKept && needs[i].buffer->handle != before)
        {
            gpuWorld->hasTiles = false; // what it held is gone, whatever becomes of this frame
        }
    }
    return SW_SUCCESS;
}

static swResult growDetail(swGpuWorld* gpuWorld, int tileCount, int side)
{
    swGpu* gpu = gpuWorld->gpu;
    uint32_t layers = tileCount > 0 ? (uint32_t)tileCount : 1;
    swImage* detail = &gpuWorld->detail;
    if (detail->handle == VK_NULL_HANDLE || detail->layers != layers || detail->width != (uint32_t)side)
    {
        const swImageDef def = {
            .format = VK_FORMAT_R16G16B16A16_SFLOAT,
            .width = (uint32_t)side,
            .height = (uint32_t)side,
            .layers = layers,
            .mips = SW_DETAIL_MIPS,
            .isArray = true,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .layout = VK_IMAGE_LAYOUT_GENERAL,
            .name = "detail",
        };
        swImage grown;
        swResult result = swCreateImage(gpu, &def, &grown);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        swRetireImage(gpu, detail);
        *detail = grown;
    }
    return SW_SUCCESS;
}

// Row table of one tile: index of the first mode of each row, and one past the last.
static void fillRows(const swTile* tile, uint32_t firstMode, uint32_t* rows)
{
    int mode = 0;
    for (int row = 0; row <= tile->maxBin; ++row)
    {
        rows[row] = firstMode + (uint32_t)mode;
        while (mode < tile->modeCount && tile->modes[mode].qz <= row)
        {
            mode += 1;
        }
    }
    rows[tile->maxBin + 1] = firstMode + (uint32_t)mode;
}

static void recordCopy(swGpu* gpu, VkCommandBuffer commands, const swUpload* from, const swBuffer* to)
{
    if (from->size > 0)
    {
        const VkBufferCopy copy = {.srcOffset = from->offset, .size = from->size};
        gpu->vk.CmdCopyBuffer(commands, from->buffer, to->handle, 1, &copy);
    }
}

static swResult uploadModes(swGpuWorld* gpuWorld, const swFrame* frame, const swTileLayout* layout)
{
    swGpu* gpu = gpuWorld->gpu;
    swUpload* modes = &gpuWorld->modesUpload;
    swUpload* rows = &gpuWorld->rowsUpload;
    swResult result = swReserveUpload(gpu, layout->modeCount * sizeof(swMode), modes);
    result = result == SW_SUCCESS ? swReserveUpload(gpu, layout->rowCount * sizeof(uint32_t), rows) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swMode* modeData = modes->data;
    uint32_t* rowData = rows->data;
    uint32_t firstMode = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        memcpy(modeData + firstMode, tile->modes, sizeof(swMode) * (size_t)tile->modeCount);
        fillRows(tile, firstMode, rowData + gpuWorld->params[i].firstRow);
        firstMode += (uint32_t)tile->modeCount;
    }
    return SW_SUCCESS;
}

// The core's texels are the GPU's with the first three rows once more at the end.
static swResult uploadTexels(swGpuWorld* gpuWorld, const swFrame* frame, const swTileLayout* layout)
{
    const size_t texel = 4 * sizeof(float);
    swResult result = swReserveUpload(gpuWorld->gpu, layout->texelCount * texel, &gpuWorld->texelsUpload);
    for (int i = 0; i < frame->tileCount && result == SW_SUCCESS; ++i)
    {
        size_t resolution = (size_t)frame->tiles[i].resolution;
        uint8_t* to = (uint8_t*)gpuWorld->texelsUpload.data + gpuWorld->params[i].firstTexel * texel;
        memcpy(to, frame->tiles[i].texels, resolution * (resolution + 3) * texel);
    }
    return result;
}

static swResult createTilePipelines(swGpuWorld* gpuWorld, const swFrame* frame)
{
    for (int i = 0; i < frame->tileCount; ++i)
    {
        int resolution = frame->tiles[i].resolution;
        swResult result = swCreateWavesRows(gpuWorld->gpu, resolution, &gpuWorld->passes);
        result = result == SW_SUCCESS ? swCreateWavesColumns(gpuWorld->gpu, resolution, &gpuWorld->passes) : result;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

// Indices of tiles, grouped by resolution.
static swResult uploadOrder(swGpuWorld* gpuWorld, const swFrame* frame)
{
    uint32_t order[SW_MAX_TILES + 1] = {0};
    uint32_t count = 0;
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        gpuWorld->groupFirst[size] = count;
        for (int i = 0; i < frame->tileCount; ++i)
        {
            if (swTileSizeIndex(frame->tiles[i].resolution) == size)
            {
                order[count++] = (uint32_t)i;
            }
        }
        gpuWorld->groupCount[size] = count - gpuWorld->groupFirst[size];
    }
    return swUploadData(gpuWorld->gpu, order, sizeof(order), &gpuWorld->order);
}

// Whether the core has made all that this frame wants of the tiles.
static bool hasCoreTiles(const swGpuWorld* gpuWorld, const swFrame* frame)
{
    bool isCore = gpuWorld->gpu->usesCoreLayers && gpuWorld->fields.count == 1;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        isCore = isCore && frame->tiles[i].texels != NULL;
    }
    return isCore;
}

swResult swPrepareTiles(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swTileLayout layout;
    fillTileParams(gpuWorld, frame, &layout);
    chooseFields(gpuWorld, &layout);
    gpuWorld->hasCoreTiles = hasCoreTiles(gpuWorld, frame);
    gpuWorld->modesUpload = (swUpload){0};
    gpuWorld->rowsUpload = (swUpload){0};
    gpuWorld->texelsUpload = (swUpload){0};
    gpuWorld->tileCount = frame->tileCount;
    gpuWorld->tiles = frame->tiles;
    swResult result = growBuffers(gpuWorld, &layout);
    result = result == SW_SUCCESS ? growDetail(gpuWorld, frame->tileCount, layout.detailSide) : result;
    gpuWorld->bringsModes = tilesChanged(gpuWorld, frame);
    if (result == SW_SUCCESS && gpuWorld->bringsModes)
    {
        result = uploadModes(gpuWorld, frame, &layout);
    }
    if (result == SW_SUCCESS)
    {
        result = gpuWorld->hasCoreTiles ? uploadTexels(gpuWorld, frame, &layout) : createTilePipelines(gpuWorld, frame);
    }
    result = result == SW_SUCCESS ? uploadOrder(gpuWorld, frame) : result;
    if (result == SW_SUCCESS)
    {
        result =
            swUploadData(gpuWorld->gpu, gpuWorld->params, sizeof(swTileParams) * SW_MAX_TILES, &gpuWorld->tileParams);
    }
    return result;
}

void swRecordTiles(swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swInitializeImage(gpu, commands, &gpuWorld->detail);
    recordCopy(gpu, commands, &gpuWorld->modesUpload, &gpuWorld->modes);
    recordCopy(gpu, commands, &gpuWorld->rowsUpload, &gpuWorld->rows);
    recordCopy(gpu, commands, &gpuWorld->texelsUpload, &gpuWorld->texels);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

void swCommitTiles(swGpuWorld* gpuWorld, const swFrame* frame)
{
    for (int i = 0; i < frame->tileCount; ++i)
    {
        gpuWorld->spectrumVersions[i] = frame->tiles[i].spectrumVersion;
    }
    gpuWorld->tilesVersion = frame->tilesVersion;
    gpuWorld->hasTiles = true;
}
