// SPDX-License-Identifier: MIT
// The waves of a frame: modes when a spectrum or the list of tiles changed, the tiles' parameters, and where the core
// makes the tiles, their texels.

#include <math.h>
#include <string.h>

#include "gpu/pass/gpu_tiles.h"
#include "gpu/pass/query_passes.h"
#include "gpu/vk/vk_submit.h"

// exp(2 pi i n / SW_TWIDDLES), through the upload ring of a frame that is waited for.
swResult swCreateGpuTiles(swGpuWorld* gpuWorld)
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
                                     "roots of unity", &gpuWorld->tiles.roots);
    VkCommandBuffer commands = VK_NULL_HANDLE;
    result = result == SW_SUCCESS ? swBeginSubmit(gpu, &commands) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    gpu->vk.CmdUpdateBuffer(commands, gpuWorld->tiles.roots.handle, 0, sizeof(roots), roots);
    return swEndSubmit(gpu);
}

void swDestroyGpuTiles(swGpu* gpu, swGpuTiles* tiles)
{
    swDestroyBuffer(gpu, &tiles->roots);
    swDestroyBuffer(gpu, &tiles->modes);
    swDestroyBuffer(gpu, &tiles->rows);
    swDestroyBuffer(gpu, &tiles->lines);
    swDestroyBuffer(gpu, &tiles->texels);
    swDestroyBuffer(gpu, &tiles->likeness);
}

size_t swGetGpuTileMemory(const swGpuTiles* tiles)
{
    return (size_t)(tiles->roots.memory.size + tiles->modes.memory.size + tiles->rows.memory.size +
                    tiles->lines.memory.size + tiles->texels.memory.size + tiles->likeness.memory.size);
}

static bool tilesChanged(const swGpuWorld* gpuWorld, const swFrame* frame)
{
    if (!gpuWorld->tiles.hasModes || gpuWorld->tiles.tilesVersion != frame->tilesVersion)
    {
        return true;
    }
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (gpuWorld->tiles.spectrumVersions[i] != frame->tiles[i].spectrumVersion)
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
} swTileLayout;

static void fillTileParams(swGpuWorld* gpuWorld, const swFrame* frame, swTileLayout* layout)
{
    *layout = (swTileLayout){0};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        uint64_t ticks = (uint64_t)swGetTileTicks(tile, frame->ticks);
        uint32_t resolution = (uint32_t)tile->resolution;
        uint32_t maxBin = (uint32_t)tile->maxBin;
        gpuWorld->tiles.params[i] = (swTileParams){
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
    }
}

// Bits of swGpuQueryOutput that the queries of this frame want of the tiles.
static uint32_t findWantedFields(const swGpuWorld* gpuWorld)
{
    uint32_t wanted = 0;
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        bool isSurface = query->def.kind == SW_GPU_QUERY_KIND_SURFACE;
        wanted |= query->count > 0 && isSurface ? query->def.outputs : 0;
    }
    return wanted & (SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION);
}

// What queries of this frame want of the tiles.
static void chooseFields(swGpuWorld* gpuWorld, const swTileLayout* layout)
{
    uint32_t wanted = findWantedFields(gpuWorld);
    swTileFields* fields = &gpuWorld->tiles.fields;
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
    VkDeviceSize fields = gpuWorld->tiles.fields.count;
    const struct
    {
        swBuffer* buffer;
        VkDeviceSize size;
        const char* name;
    } needs[] = {
        {&gpuWorld->tiles.modes, layout->modeCount * sizeof(swMode), "modes"},
        {&gpuWorld->tiles.rows, layout->rowCount * sizeof(uint32_t), "mode rows"},
        {&gpuWorld->tiles.lines, fields * layout->lineCount * 2 * sizeof(float), "FFT lines"},
        {&gpuWorld->tiles.texels, fields * layout->texelCount * 4 * sizeof(float), "tile texels"},
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
        bool isKept = needs[i].buffer == &gpuWorld->tiles.modes || needs[i].buffer == &gpuWorld->tiles.rows;
        if (isKept && needs[i].buffer->handle != before)
        {
            gpuWorld->tiles.hasModes = false; // what it held is gone, whatever becomes of this frame
        }
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
    swUpload* modes = &gpuWorld->tiles.modesUpload;
    swUpload* rows = &gpuWorld->tiles.rowsUpload;
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
        fillRows(tile, firstMode, rowData + gpuWorld->tiles.params[i].firstRow);
        firstMode += (uint32_t)tile->modeCount;
    }
    return SW_SUCCESS;
}

// The core's texels are the GPU's with the first three rows once more at the end.
static swResult uploadTexels(swGpuWorld* gpuWorld, const swFrame* frame, const swTileLayout* layout)
{
    const size_t texel = 4 * sizeof(float);
    swResult result = swReserveUpload(gpuWorld->gpu, layout->texelCount * texel, &gpuWorld->tiles.texelsUpload);
    for (int i = 0; i < frame->tileCount && result == SW_SUCCESS; ++i)
    {
        size_t resolution = (size_t)frame->tiles[i].resolution;
        uint8_t* to = (uint8_t*)gpuWorld->tiles.texelsUpload.data + gpuWorld->tiles.params[i].firstTexel * texel;
        memcpy(to, frame->tiles[i].texels, resolution * (resolution + 3) * texel);
    }
    return result;
}

// Whether inputs make the water flow, and the core has what their waves' copies are divided by.
static bool findCarried(const swFrame* frame)
{
    bool isCarried = swHasInputs(frame->inputs, SW_INPUT_FLOW) && frame->tileCount > 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        isCarried = isCarried && frame->tiles[i].likeness != NULL;
    }
    return isCarried;
}

static void fillLikeness(const swTile* tile, float* to)
{
    size_t count = (size_t)tile->resolution * (size_t)(tile->resolution + 3);
    for (size_t i = 0; i < count; ++i)
    {
        to[i] = tile->likeness[4 * i + 1];
    }
}

static swResult uploadLikeness(swGpuWorld* gpuWorld, const swFrame* frame, const swTileLayout* layout)
{
    swGpuTiles* tiles = &gpuWorld->tiles;
    VkDeviceSize size = layout->texelCount * sizeof(float);
    swResult result = swGrowBuffer(gpuWorld->gpu, size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                   "likeness of tiles", &tiles->likeness);
    tiles->hasLikeness = false; // until this frame is recorded
    result = result == SW_SUCCESS ? swReserveUpload(gpuWorld->gpu, size, &tiles->likenessUpload) : result;
    for (int i = 0; i < frame->tileCount && result == SW_SUCCESS; ++i)
    {
        fillLikeness(&frame->tiles[i], (float*)tiles->likenessUpload.data + tiles->params[i].firstTexel);
    }
    return result;
}

static swResult prepareLikeness(swGpuWorld* gpuWorld, const swFrame* frame, const swTileLayout* layout)
{
    swGpuTiles* tiles = &gpuWorld->tiles;
    tiles->likenessUpload = (swUpload){0};
    tiles->isCarried = findCarried(frame);
    if (!tiles->isCarried)
    {
        swRetireBuffer(gpuWorld->gpu, &tiles->likeness);
        tiles->hasLikeness = tiles->bringsLikeness = false;
        return SW_SUCCESS;
    }
    tiles->bringsLikeness = tiles->bringsModes || !tiles->hasLikeness;
    return tiles->bringsLikeness ? uploadLikeness(gpuWorld, frame, layout) : SW_SUCCESS;
}

// Indices of tiles, grouped by resolution.
static swResult uploadOrder(swGpuWorld* gpuWorld, const swFrame* frame)
{
    uint32_t order[SW_MAX_TILES + 1] = {0};
    uint32_t count = 0;
    for (int size = 0; size < SW_TILE_SIZES; ++size)
    {
        gpuWorld->tiles.groupFirst[size] = count;
        for (int i = 0; i < frame->tileCount; ++i)
        {
            if (swTileSizeIndex(frame->tiles[i].resolution) == size)
            {
                order[count++] = (uint32_t)i;
            }
        }
        gpuWorld->tiles.groupCount[size] = count - gpuWorld->tiles.groupFirst[size];
    }
    return swUploadData(gpuWorld->gpu, order, sizeof(order), &gpuWorld->tiles.order);
}

// Whether the core has made all that this frame wants of the tiles.
static bool hasCoreTiles(const swGpuWorld* gpuWorld, const swFrame* frame)
{
    bool isCore = gpuWorld->gpu->usesCoreLayers && gpuWorld->tiles.fields.count == 1;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        isCore = isCore && frame->tiles[i].texels != NULL;
    }
    return isCore;
}

swResult swPrepareGpuTiles(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swGpuTiles* tiles = &gpuWorld->tiles;
    swTileLayout layout;
    fillTileParams(gpuWorld, frame, &layout);
    chooseFields(gpuWorld, &layout);
    tiles->isCore = hasCoreTiles(gpuWorld, frame);
    tiles->modesUpload = (swUpload){0};
    tiles->rowsUpload = (swUpload){0};
    tiles->texelsUpload = (swUpload){0};
    tiles->count = frame->tileCount;
    swResult result = growBuffers(gpuWorld, &layout);
    tiles->bringsModes = tilesChanged(gpuWorld, frame);
    if (result == SW_SUCCESS && tiles->bringsModes)
    {
        result = uploadModes(gpuWorld, frame, &layout);
    }
    result = result == SW_SUCCESS ? prepareLikeness(gpuWorld, frame, &layout) : result;
    if (result == SW_SUCCESS && tiles->isCore)
    {
        result = uploadTexels(gpuWorld, frame, &layout);
    }
    result = result == SW_SUCCESS ? uploadOrder(gpuWorld, frame) : result;
    return result == SW_SUCCESS
               ? swUploadData(gpuWorld->gpu, tiles->params, sizeof(tiles->params), &tiles->paramsUpload)
               : result;
}

void swCopyGpuTiles(swGpu* gpu, VkCommandBuffer commands, const swGpuTiles* tiles)
{
    recordCopy(gpu, commands, &tiles->modesUpload, &tiles->modes);
    recordCopy(gpu, commands, &tiles->rowsUpload, &tiles->rows);
    recordCopy(gpu, commands, &tiles->texelsUpload, &tiles->texels);
    recordCopy(gpu, commands, &tiles->likenessUpload, &tiles->likeness);
}

void swCommitGpuTiles(swGpuTiles* tiles, const swFrame* frame)
{
    for (int i = 0; i < frame->tileCount; ++i)
    {
        tiles->spectrumVersions[i] = frame->tiles[i].spectrumVersion;
    }
    tiles->tilesVersion = frame->tilesVersion;
    tiles->hasModes = true;
    tiles->hasLikeness = tiles->isCarried;
}

void swDiscardGpuTiles(swGpuTiles* tiles)
{
    tiles->hasModes = false;
    tiles->hasLikeness = false;
}

swBinding swBindLikeness(const swGpuWorld* gpuWorld)
{
    const swGpuTiles* tiles = &gpuWorld->tiles;
    return swBindBuffer(tiles->isCarried ? &tiles->likeness : &tiles->texels);
}
