// SPDX-License-Identifier: MIT
// What a frame brings to the GPU: waves (upload_tiles.c), images when a view is new, and the small parameters of every
// frame. Where a slice lies on a tile is reduced in double here, so that shaders see small numbers wherever in the
// world the viewer is.
//
// All or nothing: first everything is prepared that may fail, and nothing is recorded; then commands are recorded,
// which cannot fail; then what the device will hold is noted. A host that drops the commands after all says so with
// swGpuWorld_Discard(), which takes the notes back.

#include <math.h>
#include <string.h>

#include "core/lod/scroll.h"
#include "core/math/scalar.h"
#include "gpu/pass/passes.h"
#include "gpu/record/record.h"

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
            swRetireGpuView(gpuWorld->gpu, view);
        }
    }
}

// The entry of a view, made if it is new.
static swResult findOrCreateView(swGpuWorld* gpuWorld, const swViewFrame* frame, swGpuView** out)
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
    *out = unused;
    return swMakeGpuView(gpu, frame, unused);
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

static swResult uploadSlices(swGpuWorld* gpuWorld, const swFrame* frame, const swStackFrame* stack, swGpuView* view)
{
    swGpu* gpu = gpuWorld->gpu;
    swSliceList lists[SW_MAX_SLICES] = {0};
    size_t slices = (size_t)stack->sliceCount;
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
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        const swSlice* slice = &stack->slices[i];
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

static swResult uploadFoam(swGpuWorld* gpuWorld, const swFrame* frame, const swStackFrame* stack, swGpuView* view)
{
    const swGpuLayer* foam = &view->layers[SW_LAYER_FOAM];
    if (!foam->due.isDue)
    {
        return SW_SUCCESS;
    }
    float seconds = (float)foam->due.steps / (float)SW_FOAM_RATE;
    swFoamSliceParams params[SW_MAX_SLICES] = {0};
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES + 1] = {0};
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        params[i] = swGetFoamParams(frame, stack, i, seconds, foam->due.isReset);
        swFindPastSources(&stack->slices[i], stack->resolution, foam->due.isReset ? 0 : stack->sliceCount,
                          foam->mark.at.slices, sources[i]);
        sources[i][SW_PAST_SOURCES] = swGetFoamBirth(stack, i).fold;
    }
    swResult result = swUploadData(gpuWorld->gpu, params, sizeof(params), &view->foamParams);
    result = result == SW_SUCCESS ? swUploadData(gpuWorld->gpu, sources, sizeof(sources), &view->foamSources) : result;
    return result;
}

static swResult prepareView(swGpuWorld* gpuWorld, const swFrame* frame, const swViewFrame* viewFrame)
{
    swGpu* gpu = gpuWorld->gpu;
    swGpuView* view = NULL;
    swResult result = findOrCreateView(gpuWorld, viewFrame, &view);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    view->frame = viewFrame;
    view->isCore = gpu->usesCoreLayers && viewFrame->stack.layers[SW_LAYER_DISPLACEMENT].texels != NULL;
    swPlanGpuView(view);
    if (view->isCore)
    {
        return swPrepareCoreLayers(gpu, viewFrame, view);
    }
    result = swCreateSlices(gpu, &gpuWorld->passes);
    result = result == SW_SUCCESS ? swCreateFoam(gpu, &gpuWorld->passes) : result;
    result = result == SW_SUCCESS ? uploadSlices(gpuWorld, frame, &viewFrame->stack, view) : result;
    return result == SW_SUCCESS ? uploadFoam(gpuWorld, frame, &viewFrame->stack, view) : result;
}

swResult swPrepareFrame(swGpuWorld* gpuWorld, const swFrame* frame)
{
    retireGoneViews(gpuWorld, frame);
    swResult result = swPrepareTiles(gpuWorld, frame);
    for (int i = 0; i < frame->viewCount && result == SW_SUCCESS; ++i)
    {
        result = prepareView(gpuWorld, frame, &frame->views[i]);
    }
    return result == SW_SUCCESS ? swUploadQueries(gpuWorld, frame) : result;
}

void swRecordUploads(swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    swRecordTiles(gpuWorld, commands);
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &gpuWorld->views[i];
        if (!view->isUsed)
        {
            continue;
        }
        swBeginGpuView(gpu, commands, view);
        if (view->isCore)
        {
            swRecordCoreLayers(gpu, commands, view);
        }
    }
}

void swCommitFrame(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swCommitTiles(gpuWorld, frame);
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &gpuWorld->views[i];
        if (view->isUsed)
        {
            swCommitGpuView(gpuWorld->frameIndex, view);
        }
    }
}

void swDiscardFrames(swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    gpuWorld->hasTiles = false;
    gpuWorld->isRecorded = false;
    gpuWorld->discardCount += 1;
    gpuWorld->discardedFrom = frameIndex;
    swDiscardGpuFrame(gpuWorld->gpu);
    gpuWorld->detail.isInitialized = false;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        if (gpuWorld->views[i].isUsed)
        {
            swDiscardGpuView(&gpuWorld->views[i], frameIndex);
        }
    }
    swDiscardQueries(gpuWorld, frameIndex);
}
