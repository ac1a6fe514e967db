// SPDX-License-Identifier: MIT
#include "gpu/layer/gpu_view.h"

#include <string.h>

// What the images of a layer are.
typedef struct Kind
{
    VkFormat format;
    bool hasPast; // two images, written in turns
    const char* name;
} Kind;

static const Kind kinds[SW_LAYER_COUNT] = {
    // x, y, z, J: foam grows by J in full precision
    [SW_LAYER_DISPLACEMENT] = {VK_FORMAT_R32G32B32A32_SFLOAT, false, "displacement"},
    // gx, gz, J, 0
    [SW_LAYER_DERIVATIVES] = {VK_FORMAT_R16G16B16A16_SFLOAT, false, "derivatives"},
    [SW_LAYER_FOAM] = {VK_FORMAT_R32_SFLOAT, true, "foam"},
};

static int countImages(int layer)
{
    return kinds[layer].hasPast ? 2 : 1;
}

static swResult createImages(swGpu* gpu, swGpuView* view)
{
    for (int layer = 0; layer < SW_LAYER_COUNT; ++layer)
    {
        const swImageDef def = {
            .format = kinds[layer].format,
            .width = (uint32_t)view->resolution,
            .height = (uint32_t)view->resolution,
            .layers = (uint32_t)view->sliceCount,
            .isArray = true,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .layout = VK_IMAGE_LAYOUT_GENERAL,
            .name = kinds[layer].name,
        };
        for (int i = 0; i < countImages(layer); ++i)
        {
            swResult result = swCreateImage(gpu, &def, &view->layers[layer].images[i]);
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
    }
    return SW_SUCCESS;
}

static void retireView(swGpu* gpu, swGpuView* view)
{
    for (int layer = 0; layer < SW_LAYER_COUNT; ++layer)
    {
        swRetireImage(gpu, &view->layers[layer].images[0]);
        swRetireImage(gpu, &view->layers[layer].images[1]);
    }
    *view = (swGpuView){0};
}

static swResult makeView(swGpu* gpu, const swViewFrame* frame, swGpuView* view)
{
    *view = (swGpuView){
        .viewVersion = frame->viewVersion,
        .view = frame->view,
        .sliceCount = frame->sliceCount,
        .resolution = frame->resolution,
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

swResult swPrepareGpuViews(swGpu* gpu, const swFrame* frame, swGpuView* views)
{
    retireGoneViews(gpu, frame, views);
    for (int i = 0; i < frame->viewCount; ++i)
    {
        const swViewFrame* viewFrame = &frame->views[i];
        swGpuView* view = NULL;
        swResult result = findOrMakeView(gpu, viewFrame, views, &view);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        view->frame = viewFrame;
        view->isCore = gpu->usesCoreLayers && viewFrame->displacement != NULL;
        result = view->isCore ? swPrepareCoreLayers(gpu, viewFrame, view) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

static void beginImages(swGpu* gpu, VkCommandBuffer commands, swGpuView* view)
{
    for (int i = 0; i < SW_LAYER_COUNT; ++i)
    {
        swGpuLayer* layer = &view->layers[i];
        layer->firstFrame = layer->images[0].isInitialized ? layer->firstFrame : gpu->frameIndex;
        for (int image = 0; image < countImages(i); ++image)
        {
            swInitializeImage(gpu, commands, &layer->images[image]);
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

void swTurnLayer(swGpuView* view, swLayer which, const swLayerMark* now)
{
    swGpuLayer* layer = &view->layers[which];
    int next = layer->mark.index ^ 1;
    memmove(layer->earlier + 1, layer->earlier, sizeof(layer->earlier) - sizeof(layer->earlier[0]));
    layer->earlier[0] = layer->mark;
    layer->mark = *now;
    layer->mark.index = next;
}

// Goes back to what the last frame before left, which lies untouched in the other image, or begins again if that frame
// is too long ago.
static void discardPast(swGpuLayer* layer, uint64_t frameIndex)
{
    if (layer->firstFrame >= frameIndex)
    {
        layer->images[0].isInitialized = false;
        layer->images[1].isInitialized = false;
    }
    if (layer->mark.isHeld && layer->mark.frameIndex >= frameIndex)
    {
        swLayerMark found = {0};
        for (int i = SW_LAYER_MARKS - 1; i >= 0; --i)
        {
            bool isBefore = layer->earlier[i].isHeld && layer->earlier[i].frameIndex < frameIndex;
            found = isBefore ? layer->earlier[i] : found;
            layer->earlier[i].isHeld = isBefore;
        }
        layer->mark = found;
    }
}

// Images that each frame writes anew are simply begun again.
void swDiscardGpuViews(swGpuView* views, uint64_t frameIndex)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        for (int layer = 0; layer < SW_LAYER_COUNT && views[i].isUsed; ++layer)
        {
            if (kinds[layer].hasPast)
            {
                discardPast(&views[i].layers[layer], frameIndex);
            }
            else
            {
                views[i].layers[layer].images[0].isInitialized = false;
            }
        }
    }
}

void swDestroyGpuViews(swGpu* gpu, swGpuView* views)
{
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        for (int layer = 0; layer < SW_LAYER_COUNT; ++layer)
        {
            swDestroyImage(gpu, &views[i].layers[layer].images[0]);
            swDestroyImage(gpu, &views[i].layers[layer].images[1]);
        }
    }
}

size_t swGetGpuViewMemory(const swGpuView* views)
{
    size_t bytes = 0;
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        for (int layer = 0; layer < SW_LAYER_COUNT; ++layer)
        {
            const swImage* images = views[i].layers[layer].images;
            bytes += (size_t)(images[0].memory.size + images[1].memory.size);
        }
    }
    return bytes;
}
