// SPDX-License-Identifier: MIT
// What a frame brings to the GPU: waves when a spectrum or the list of tiles changed, images when a view is new, and the
// small parameters of every frame. Where a slice lies on a tile is reduced in double here, so that shaders see small
// numbers wherever in the world the viewer is.

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"
#include "gpu/pass/passes.h"
#include "gpu/record/record.h"

// Tiles ------------------------------------------------------------------------------------------------------------------

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
        swResult result = swGrowBuffer(gpuWorld->gpu, size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE,
                                       needs[i].name, needs[i].buffer);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

static swResult growDetail(swGpuWorld* gpuWorld, VkCommandBuffer commands, int tileCount, int side)
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
    swInitializeImage(gpu, commands, detail);
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

static swResult uploadModes(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame,
                            const swTileLayout* layout)
{
    swGpu* gpu = gpuWorld->gpu;
    swUpload modes, rows;
    swResult result = swReserveUpload(gpu, layout->modeCount * sizeof(swMode), &modes);
    result = result == SW_SUCCESS ? swReserveUpload(gpu, layout->rowCount * sizeof(uint32_t), &rows) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swMode* modeData = modes.data;
    uint32_t* rowData = rows.data;
    uint32_t firstMode = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        memcpy(modeData + firstMode, tile->modes, sizeof(swMode) * (size_t)tile->modeCount);
        fillRows(tile, firstMode, rowData + gpuWorld->params[i].firstRow);
        firstMode += (uint32_t)tile->modeCount;
        gpuWorld->spectrumVersions[i] = tile->spectrumVersion;
    }
    recordCopy(gpu, commands, &modes, &gpuWorld->modes);
    recordCopy(gpu, commands, &rows, &gpuWorld->rows);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
    gpuWorld->tilesVersion = frame->tilesVersion;
    gpuWorld->hasTiles = true;
    return SW_SUCCESS;
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

static swResult uploadTiles(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame)
{
    swTileLayout layout;
    fillTileParams(gpuWorld, frame, &layout);
    chooseFields(gpuWorld, &layout);
    bool isChanged = tilesChanged(gpuWorld, frame);
    gpuWorld->hasTiles = gpuWorld->hasTiles && !isChanged; // until all of it succeeded
    swResult result = growBuffers(gpuWorld, &layout);
    if (result == SW_SUCCESS && isChanged)
    {
        result = createTilePipelines(gpuWorld, frame);
        result = result == SW_SUCCESS ? growDetail(gpuWorld, commands, frame->tileCount, layout.detailSide) : result;
        result = result == SW_SUCCESS ? uploadModes(gpuWorld, commands, frame, &layout) : result;
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    gpuWorld->tileCount = frame->tileCount;
    gpuWorld->tiles = frame->tiles;
    result = uploadOrder(gpuWorld, frame);
    if (result == SW_SUCCESS)
    {
        result =
            swUploadData(gpuWorld->gpu, gpuWorld->params, sizeof(swTileParams) * SW_MAX_TILES, &gpuWorld->tileParams);
    }
    return result;
}

// Views ------------------------------------------------------------------------------------------------------------------

static void retireView(swGpu* gpu, swGpuView* view)
{
    swRetireImage(gpu, &view->displacement);
    swRetireImage(gpu, &view->derivatives);
    swRetireImage(gpu, &view->foam[0]);
    swRetireImage(gpu, &view->foam[1]);
    *view = (swGpuView){0};
}

static void retireGoneViews(swGpuWorld* gpuWorld, const swFrame* frame)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &gpuWorld->views[i];
        bool isGone = view->isUsed;
        for (int v = 0; v < frame->viewCount; ++v)
        {
            isGone = isGone && frame->views[v].viewVersion != view->viewVersion;
        }
        if (isGone)
        {
            retireView(gpuWorld->gpu, view);
        }
    }
}

static swResult createViewImages(swGpu* gpu, swGpuView* view)
{
    const struct
    {
        swImage* image;
        VkFormat format;
        const char* name;
    } images[] = {
        {&view->displacement, VK_FORMAT_R32G32B32A32_SFLOAT, "displacement"},
        {&view->derivatives, VK_FORMAT_R16G16B16A16_SFLOAT, "derivatives"},
        {&view->foam[0], VK_FORMAT_R32_SFLOAT, "foam 0"},
        {&view->foam[1], VK_FORMAT_R32_SFLOAT, "foam 1"},
    };
    for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i)
    {
        const swImageDef def = {
            .format = images[i].format,
            .width = (uint32_t)view->resolution,
            .height = (uint32_t)view->resolution,
            .layers = (uint32_t)view->sliceCount,
            .isArray = true,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .layout = VK_IMAGE_LAYOUT_GENERAL,
            .name = images[i].name,
        };
        swResult result = swCreateImage(gpu, &def, images[i].image);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

// The entry of a view, made if it is new.
static swResult findOrCreateView(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swViewFrame* frame,
                                 swGpuView** out)
{
    swGpuView* unused = NULL;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &gpuWorld->views[i];
        if (view->isUsed && view->viewVersion == frame->viewVersion)
        {
            *out = view;
            return SW_SUCCESS;
        }
        unused = !view->isUsed && unused == NULL ? view : unused;
    }
    swGpu* gpu = gpuWorld->gpu;
    if (unused == NULL) // a world has no more views than there are entries, and views that are gone were retired
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "more than %d views", SW_MAX_VIEWS);
    }
    *unused = (swGpuView){
        .viewVersion = frame->viewVersion,
        .view = frame->view,
        .sliceCount = frame->sliceCount,
        .resolution = frame->resolution,
    };
    swResult result = createViewImages(gpu, unused);
    if (result != SW_SUCCESS)
    {
        retireView(gpu, unused);
        return result;
    }
    swInitializeImage(gpu, commands, &unused->displacement);
    swInitializeImage(gpu, commands, &unused->derivatives);
    swInitializeImage(gpu, commands, &unused->foam[0]);
    swInitializeImage(gpu, commands, &unused->foam[1]);
    unused->isUsed = true;
    *out = unused;
    return SW_SUCCESS;
}

// Spline coordinate of the slice's first texel along one axis, as a texel column and a fraction.
static void reduceOffset(int64_t first, double texel, const swTile* tile, float* fraction, uint32_t* base)
{
    double turns = (double)first * texel / tile->side;
    double coordinate = (turns - floor(turns)) * tile->resolution;
    double cell = floor(coordinate);
    *fraction = (float)(coordinate - cell);
    *base = (uint32_t)cell & (uint32_t)(tile->resolution - 1);
}

static swSliceTile makeSliceTile(const swSlice* slice, const swTile* tile, uint32_t firstTexel)
{
    swSliceTile out = {
        .step = (float)(slice->texel * tile->resolution / tile->side),
        .perMetre = (float)(tile->resolution / tile->side),
        .firstTexel = firstTexel,
        .resolution = (uint32_t)tile->resolution,
        .runMask = (1u << SW_SLICE_RUN) - 1,
    };
    uint32_t baseX, baseZ;
    reduceOffset(slice->firstX, slice->texel, tile, &out.fractionX, &baseX);
    reduceOffset(slice->firstZ, slice->texel, tile, &out.fractionZ, &baseZ);
    out.base = baseX | baseZ << 16;
    return out;
}

// Everything is written once, in order: uploads are slow to read.
static uint32_t fillSliceTiles(const swGpuWorld* gpuWorld, const swFrame* frame, const swSlice* slice,
                               swSliceTile* tiles)
{
    uint32_t count = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (frame->tiles[i].minWavelength < slice->minWavelength)
        {
            continue;
        }
        swSliceTile tile = makeSliceTile(slice, &frame->tiles[i], gpuWorld->params[i].firstTexel);
        bool isSparse = (SW_SLICE_RUN - 1) * tile.step > SW_SLICE_ROWS - 4;
        for (uint32_t t = 0; t < (isSparse ? SW_SLICE_RUN : 1); ++t)
        {
            tile.runMask = isSparse ? 1u << t : tile.runMask;
            tiles[count++] = tile;
        }
    }
    return count;
}

// Turns as a fraction of 2^32.
static uint32_t toPhase(double turns)
{
    return (uint32_t)(uint64_t)floor((turns - floor(turns)) * 0x1p32);
}

static swSliceWave makeSliceWave(const swSlice* slice, const swFreeWave* wave, int64_t ticks)
{
    uint32_t passed = (uint32_t)((wave->frequency * (uint64_t)swGetFreeWaveTicks(wave, ticks)) >> 32);
    double place =
        wave->turnsX * ((double)slice->firstX * slice->texel) + wave->turnsZ * ((double)slice->firstZ * slice->texel);
    swSliceWave out = {
        .phase = toPhase(place) + wave->phase - passed,
        .stepX = toPhase(wave->turnsX * slice->texel + 0x1p-33),
        .stepZ = toPhase(wave->turnsZ * slice->texel + 0x1p-33),
        .amplitude = wave->amplitude,
        .dx = wave->dx,
        .dz = wave->dz,
        .kx = (float)(2.0 * SW_PI * wave->turnsX),
        .kz = (float)(2.0 * SW_PI * wave->turnsZ),
    };
    swSinCosTurns(out.stepZ, &out.sinZ, &out.cosZ);
    return out;
}

// Longest first, as the frame has them.
static void fillSliceWaves(const swFrame* frame, const swSlice* slice, swSliceWave* waves, swSliceList* list)
{
    for (int i = 0; i < frame->waveCount && frame->waves[i].wavelength >= slice->minWavelength; ++i)
    {
        waves[list->waveCount++] = makeSliceWave(slice, &frame->waves[i], frame->ticks);
    }
}

static swResult uploadSlices(swGpuWorld* gpuWorld, const swFrame* frame, const swViewFrame* viewFrame, swGpuView* view)
{
    swGpu* gpu = gpuWorld->gpu;
    swSliceList lists[SW_MAX_SLICES] = {0};
    size_t slices = (size_t)viewFrame->sliceCount;
    size_t mostTiles = slices * (size_t)(frame->tileCount > 0 ? frame->tileCount : 1) * SW_SLICE_RUN;
    size_t mostWaves = slices * (size_t)(frame->waveCount > 0 ? frame->waveCount : 1);
    swResult result = swReserveUpload(gpu, mostTiles * sizeof(swSliceTile), &view->sliceTiles);
    result = result == SW_SUCCESS ? swReserveUpload(gpu, mostWaves * sizeof(swSliceWave), &view->sliceWaves) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    uint32_t tileCount = 0;
    uint32_t waveCount = 0;
    for (int i = 0; i < viewFrame->sliceCount; ++i)
    {
        const swSlice* slice = &viewFrame->slices[i];
        swSliceList* list = &lists[i];
        swSliceTile* tiles = (swSliceTile*)view->sliceTiles.data + tileCount;
        list->first = tileCount;
        list->count = fillSliceTiles(gpuWorld, frame, slice, tiles);
        list->firstWave = waveCount;
        fillSliceWaves(frame, slice, (swSliceWave*)view->sliceWaves.data + waveCount, list);
        tileCount += list->count;
        waveCount += list->waveCount;
        list->texelsPerMetre = (float)(1.0 / slice->texel);
    }
    return swUploadData(gpu, lists, sizeof(lists), &view->sliceLists);
}

static bool slicesMoved(const swGpuView* view, const swViewFrame* frame)
{
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        const swSlice* a = &view->foamSlices[i];
        const swSlice* b = &frame->slices[i];
        if (a->level != b->level || a->firstX != b->firstX || a->firstZ != b->firstZ)
        {
            return true;
        }
    }
    return false;
}

static swResult uploadFoam(swGpuWorld* gpuWorld, const swFrame* frame, const swViewFrame* viewFrame, swGpuView* view)
{
    int64_t passed = viewFrame->foamClock - view->foamClock;
    bool isSteady = !view->hasFoam || view->foamResetCount != viewFrame->foamResetCount || passed < -SW_FOAM_RATE;
    int64_t steps = isSteady || passed < 0 ? 0 : passed; // a world that went back a little meets its foam again
    view->foamMoves = isSteady || steps != 0 || slicesMoved(view, viewFrame);
    if (!view->foamMoves)
    {
        return SW_SUCCESS;
    }
    const swFoamDef* def = &frame->foam;
    float keep = swExpF(-def->fadeRate * ((float)steps / (float)SW_FOAM_RATE));
    swFoamSliceParams params[SW_MAX_SLICES] = {0};
    swFoamSource sources[SW_MAX_SLICES][SW_FOAM_SOURCES] = {0};
    for (int i = 0; i < viewFrame->sliceCount; ++i)
    {
        params[i] = (swFoamSliceParams){
            .deviation = viewFrame->foamDeviation[i],
            .threshold = def->threshold,
            .keep = keep,
            .grow = def->gain * (1.0f - keep) / def->fadeRate,
            .ceiling = def->gain / def->fadeRate,
            .isSteady = isSteady ? 1 : 0,
        };
        swFindFoamSources(&viewFrame->slices[i], viewFrame->resolution, isSteady ? 0 : viewFrame->sliceCount,
                          view->foamSlices, sources[i]);
    }
    swResult result = swUploadData(gpuWorld->gpu, params, sizeof(params), &view->foamParams);
    result = result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, sources, sizeof(sources), &view->foamSources) : result;
    return result;
}

// After everything that can fail: the foam pass will be recorded.
static void commitFoam(const swViewFrame* viewFrame, swGpuView* view)
{
    if (view->foamMoves)
    {
        view->foamIndex ^= 1;
        view->hasFoam = true;
        bool isBehind = view->foamResetCount == viewFrame->foamResetCount && view->foamClock > viewFrame->foamClock &&
                        view->foamClock - viewFrame->foamClock <= SW_FOAM_RATE;
        view->foamClock = isBehind ? view->foamClock : viewFrame->foamClock;
        view->foamResetCount = viewFrame->foamResetCount;
        memcpy(view->foamSlices, viewFrame->slices, sizeof(view->foamSlices));
    }
}

swResult swUploadFrame(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame)
{
    swResult result = uploadTiles(gpuWorld, commands, frame);
    retireGoneViews(gpuWorld, frame);
    swGpuView* views[SW_MAX_VIEWS];
    for (int i = 0; i < frame->viewCount && result == SW_SUCCESS; ++i)
    {
        result = findOrCreateView(gpuWorld, commands, &frame->views[i], &views[i]);
        result = result == SW_SUCCESS ? uploadSlices(gpuWorld, frame, &frame->views[i], views[i]) : result;
        result = result == SW_SUCCESS ? uploadFoam(gpuWorld, frame, &frame->views[i], views[i]) : result;
    }
    result = result == SW_SUCCESS ? swUploadQueries(gpuWorld, frame) : result;
    for (int i = 0; i < frame->viewCount && result == SW_SUCCESS; ++i)
    {
        commitFoam(&frame->views[i], views[i]);
    }
    return result;
}
