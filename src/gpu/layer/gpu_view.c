// SPDX-License-Identifier: MIT
#include "gpu/layer/gpu_view.h"

#include <string.h>

#include "core/lod/scroll.h"

static const VkFormat formats[] = {
    [SW_TEXEL_R32F] = VK_FORMAT_R32_SFLOAT,
    [SW_TEXEL_RGBA32F] = VK_FORMAT_R32G32B32A32_SFLOAT,
    [SW_TEXEL_RGBA16F] = VK_FORMAT_R16G16B16A16_SFLOAT,
};

bool swIsLayerInView(int layer)
{
    return swGetLayerInfo(layer)->kind != SW_LAYER_IS_SIMULATED;
}

swSamplerKind swChooseLayerSampler(const swGpu* gpu, int layer)
{
    const swLayerInfo* info = swGetLayerInfo(layer);
    bool canFilter = info->format == SW_TEXEL_RGBA16F || gpu->filtersFloats;
    return info->isLinear && canFilter ? SW_SAMPLER_LINEAR_CLAMP : SW_SAMPLER_NEAREST_CLAMP;
}

static swResult createImage(swGpu* gpu, const swGpuView* view, int layer, int side, swImage* image)
{
    const swLayerInfo* info = swGetLayerInfo(layer);
    const swImageDef def = {
        .format = formats[info->format],
        .width = (uint32_t)side,
        .height = (uint32_t)side,
        .layers = (uint32_t)view->sliceCount,
        .isArray = true,
        .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
        .layout = VK_IMAGE_LAYOUT_GENERAL,
        .name = info->name,
    };
    return swCreateImage(gpu, &def, image);
}

static swResult createImages(swGpu* gpu, swGpuView* view)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        const swLayerInfo* info = swGetLayerInfo(i);
        int count = !swIsLayerInView(i) || swIsOnDemand(info) ? 0 : info->hasPast ? 2 : 1;
        for (int k = 0; k < count; ++k)
        {
            swResult result = createImage(gpu, view, i, view->resolution, &view->layers[i].images[k]);
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
    }
    return SW_SUCCESS;
}

// Images of a layer on demand, of a side: 1 for the texel that stands for all of it.
static swResult remakeImages(swGpu* gpu, swGpuView* view, int layer, int side)
{
    swGpuLayer* of = &view->layers[layer];
    int count = side > 1 && swGetLayerInfo(layer)->hasPast ? 2 : 1;
    swImage images[2] = {{0}};
    swResult result = swMakeRoomToRetire(gpu);
    for (int k = 0; k < count && result == SW_SUCCESS; ++k)
    {
        result = createImage(gpu, view, layer, side, &images[k]);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyImage(gpu, &images[0]);
        return result;
    }
    swRetireImage(gpu, &of->images[0]);
    swRetireImage(gpu, &of->images[1]);
    swRetireImage(gpu, &of->between);
    *of = (swGpuLayer){.images = {images[0], images[1]}}; // without a past
    return SW_SUCCESS;
}

// A layer on demand has images while there is something in it; one texel of what it is elsewhere otherwise.
static swResult fitLayer(swGpu* gpu, swGpuView* view, int layer)
{
    const swImage* image = &view->layers[layer].images[0];
    int side = view->frame->stack.layers[layer].isAuthored ? view->resolution : 1;
    swResult result = image->width != (uint32_t)side ? remakeImages(gpu, view, layer, side) : SW_SUCCESS;
    bool needsRest = side == 1 && !image->isInitialized;
    return result == SW_SUCCESS && needsRest ? swPrepareRestTexel(gpu, view, layer) : result;
}

// Once a layer was carried it keeps the image for it.
static swResult fitBetween(swGpu* gpu, swGpuView* view, int layer)
{
    swGpuLayer* of = &view->layers[layer];
    bool isHeld = of->images[0].width == (uint32_t)view->resolution;
    bool isField = swGetLayerInfo(layer)->kind == SW_LAYER_IS_FIELD;
    bool isWanted = isField || view->frame->stack.layers[layer].isCarried;
    bool isMissing = isWanted && isHeld && of->between.handle == VK_NULL_HANDLE;
    return isMissing ? createImage(gpu, view, layer, view->resolution, &of->between) : SW_SUCCESS;
}

static swResult fitLayers(swGpu* gpu, swGpuView* view)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_LAYERS && result == SW_SUCCESS; ++i)
    {
        result = swIsLayerInView(i) && swIsOnDemand(swGetLayerInfo(i)) ? fitLayer(gpu, view, i) : SW_SUCCESS;
        result = result == SW_SUCCESS && !view->isCore ? fitBetween(gpu, view, i) : result;
    }
    return result;
}

static void retireView(swGpu* gpu, swGpuView* view)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        swRetireImage(gpu, &view->layers[i].images[0]);
        swRetireImage(gpu, &view->layers[i].images[1]);
        swRetireImage(gpu, &view->layers[i].between);
    }
    *view = (swGpuView){0};
}

static swResult makeView(swGpu* gpu, const swViewFrame* frame, swGpuView* view)
{
    *view = (swGpuView){
        .viewVersion = frame->viewVersion,
        .view = frame->view,
        .sliceCount = frame->stack.sliceCount,
        .resolution = frame->stack.resolution,
    };
    swResult result = createImages(gpu, view);
    if (result != SW_SUCCESS)
    {
        retireView(gpu, view);
        return result;
    }
    view->isUsed = true;
    return SW_SUCCESS;
}

static void retireGoneViews(swGpu* gpu, const swFrame* frame, swGpuView* views)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        bool isGone = views[i].isUsed;
        for (int v = 0; v < frame->viewCount; ++v)
        {
            isGone = isGone && frame->views[v].viewVersion != views[i].viewVersion;
        }
        if (isGone)
        {
            retireView(gpu, &views[i]);
        }
    }
}

// The entry of a view, made if it is new.
static swResult findOrMakeView(swGpu* gpu, const swViewFrame* frame, swGpuView* views, swGpuView** out)
{
    swGpuView* unused = NULL;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &views[i];
        if (view->isUsed && view->viewVersion == frame->viewVersion)
        {
            *out = view;
            return SW_SUCCESS;
        }
        unused = !view->isUsed && unused == NULL ? view : unused;
    }
    if (unused == NULL) // a world has no more views than there are entries, and views that are gone were retired
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "more than %d views", SW_MAX_VIEWS);
    }
    *out = unused;
    return makeView(gpu, frame, unused);
}

static void planView(swGpuView* view)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (swIsLayerInView(i) && swGetLayerInfo(i)->hasPast)
        {
            view->layers[i].due = swFindCatchUp(&view->layers[i].mark.at, i, &view->frame->stack);
            bool isHeld = !swIsOnDemand(swGetLayerInfo(i)) || view->frame->stack.layers[i].isAuthored;
            view->layers[i].due.isDue = view->layers[i].due.isDue && !view->isCore && isHeld;
        }
    }
}

static swViewPlace notePlace(const swFrame* frame, const swViewFrame* view)
{
    swViewPlace place = {
        .viewpoint = view->viewpoint,
        .seaLevel = frame->seaLevel,
        .fade = view->fade,
        .scaleLevel = view->scaleLevel,
        .foamAtRest = frame->foamLaw.cover,
    };
    memcpy(place.slices, view->stack.slices, sizeof(place.slices));
    return place;
}

swResult swPrepareGpuViews(swGpu* gpu, const swFrame* frame, swGpuView* views)
{
    retireGoneViews(gpu, frame, views);
    swResult result = SW_SUCCESS;
    for (int i = 0; i < frame->viewCount && result == SW_SUCCESS; ++i)
    {
        const swViewFrame* viewFrame = &frame->views[i];
        swGpuView* view = NULL;
        result = findOrMakeView(gpu, viewFrame, views, &view);
        if (result == SW_SUCCESS)
        {
            view->frame = viewFrame;
            view->place = notePlace(frame, viewFrame);
            view->isCore = gpu->usesCoreLayers && viewFrame->stack.layers[SW_LAYER_DISPLACEMENT].texels != NULL;
            result = fitLayers(gpu, view);
            planView(view);
            result = result == SW_SUCCESS && view->isCore ? swPrepareCoreLayers(gpu, viewFrame, view) : result;
        }
    }
    return result;
}

static void beginImages(swGpu* gpu, VkCommandBuffer commands, swGpuView* view)
{
    if (!view->hasBegun)
    {
        view->firstFrame = gpu->frameIndex;
        view->hasBegun = true;
    }
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        swImage* images = view->layers[i].images;
        if (images[0].width == 1 && !images[0].isInitialized)
        {
            swRecordImageUpload(gpu, commands, &view->layers[i].upload, &images[0]);
        }
        view->layers[i].firstFrame = images[0].isInitialized ? view->layers[i].firstFrame : gpu->frameIndex;
        for (int k = 0; k < 2 && images[k].handle != VK_NULL_HANDLE; ++k)
        {
            swInitializeImage(gpu, commands, &images[k]);
        }
        if (view->layers[i].between.handle != VK_NULL_HANDLE)
        {
            swInitializeImage(gpu, commands, &view->layers[i].between);
        }
    }
}

bool swCopyGpuViews(swGpu* gpu, VkCommandBuffer commands, swGpuView* views)
{
    bool hasCopies = false;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        swGpuView* view = &views[i];
        if (!view->isUsed)
        {
            continue;
        }
        beginImages(gpu, commands, view);
        if (view->isCore)
        {
            swCopyCoreLayers(gpu, commands, view);
            hasCopies = true;
        }
    }
    return hasCopies;
}

void swFillPastSources(const swGpuView* view, int layer, int stride, swPastSource* sources)
{
    const swStackFrame* stack = &view->frame->stack;
    const swGpuLayer* past = &view->layers[layer];
    int count = past->due.isReset ? 0 : stack->sliceCount;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        swFindPastSources(&stack->slices[i], stack->resolution, count, past->mark.at.slices, sources + i * stride);
    }
}

void swFillStillSources(const swGpuView* view, int stride, swPastSource* sources)
{
    const swStackFrame* stack = &view->frame->stack;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        swFindPastSources(&stack->slices[i], stack->resolution, stack->sliceCount, stack->slices, sources + i * stride);
    }
}

swCarriedSteps swFindLayerSteps(const swGpuView* view, int layer)
{
    const swLayerInfo* info = swGetLayerInfo(layer);
    int64_t due = view->layers[layer].due.steps;
    if (view->frame->stack.layers[layer].isCarried && due > 1)
    {
        return swFindCarriedSteps(info, due);
    }
    return (swCarriedSteps){.count = 1, .dt = (float)due / (float)info->rate};
}

const swImage* swGetStepTarget(const swGpuView* view, int layer, int step, int count)
{
    bool isNext = (count - 1 - step) % 2 == 0;
    return isNext ? swGetNextLayerImage(view, layer) : &view->layers[layer].between;
}

const swImage* swGetStepSource(const swGpuView* view, int layer, int step, int count)
{
    return step == 0 ? swGetLayerImage(view, layer) : swGetStepTarget(view, layer, step - 1, count);
}

static void commitView(uint64_t frameIndex, swGpuView* view)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        swGpuLayer* layer = &view->layers[i];
        if (layer->due.isDue)
        {
            memmove(layer->earlier + 1, layer->earlier, sizeof(layer->earlier) - sizeof(layer->earlier[0]));
            layer->earlier[0] = layer->mark;
            layer->mark.frameIndex = frameIndex;
            layer->mark.index ^= 1;
            swMoveMark(&layer->mark.at, i, &view->frame->stack);
        }
    }
}

void swCommitGpuViews(uint64_t frameIndex, swGpuView* views)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        if (views[i].isUsed)
        {
            commitView(frameIndex, &views[i]);
        }
    }
}

// Images that each frame writes anew are simply begun again. A layer with a past goes back to what the last frame
// before left, which lies untouched in the other image, or begins again if that frame is too long ago.
static void discardLayer(swGpuLayer* layer, uint64_t frameIndex)
{
    if (!layer->mark.at.hasPast || layer->mark.frameIndex < frameIndex)
    {
        return;
    }
    swGpuLayerMark found = {0};
    for (int i = SW_LAYER_MARKS - 1; i >= 0; --i)
    {
        bool isBefore = layer->earlier[i].at.hasPast && layer->earlier[i].frameIndex < frameIndex;
        found = isBefore ? layer->earlier[i] : found;
        layer->earlier[i].at.hasPast = isBefore;
    }
    layer->mark = found;
}

static void discardView(swGpuView* view, uint64_t frameIndex)
{
    view->hasBegun = view->hasBegun && view->firstFrame < frameIndex;
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (!swGetLayerInfo(i)->hasPast || !view->hasBegun || view->layers[i].firstFrame >= frameIndex)
        {
            view->layers[i].images[0].isInitialized = false;
            view->layers[i].images[1].isInitialized = false;
        }
        view->layers[i].between.isInitialized = false;
        discardLayer(&view->layers[i], frameIndex);
    }
}

void swDiscardGpuViews(swGpuView* views, uint64_t frameIndex)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        if (views[i].isUsed)
        {
            discardView(&views[i], frameIndex);
        }
    }
}

void swDestroyGpuViews(swGpu* gpu, swGpuView* views)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        for (int layer = 0; layer < SW_LAYERS; ++layer)
        {
            swDestroyImage(gpu, &views[i].layers[layer].images[0]);
            swDestroyImage(gpu, &views[i].layers[layer].images[1]);
            swDestroyImage(gpu, &views[i].layers[layer].between);
        }
    }
}

size_t swGetGpuViewMemory(const swGpuView* views)
{
    VkDeviceSize size = 0;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        for (int layer = 0; layer < SW_LAYERS; ++layer)
        {
            const swImage* images = views[i].layers[layer].images;
            size += images[0].memory.size + images[1].memory.size + views[i].layers[layer].between.memory.size;
        }
    }
    return (size_t)size;
}
