// SPDX-License-Identifier: MIT
#include "gpu/layer/gpu_view.h"

#include <string.h>

static swResult createImages(swGpu* gpu, swGpuView* view)
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

swResult swMakeGpuView(swGpu* gpu, const swViewFrame* frame, swGpuView* view)
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
        swRetireGpuView(gpu, view);
        return result;
    }
    view->isUsed = true;
    return SW_SUCCESS;
}

void swRetireGpuView(swGpu* gpu, swGpuView* view)
{
    swRetireImage(gpu, &view->displacement);
    swRetireImage(gpu, &view->derivatives);
    swRetireImage(gpu, &view->foam[0]);
    swRetireImage(gpu, &view->foam[1]);
    *view = (swGpuView){0};
}

void swDestroyGpuView(swGpu* gpu, swGpuView* view)
{
    swDestroyImage(gpu, &view->displacement);
    swDestroyImage(gpu, &view->derivatives);
    swDestroyImage(gpu, &view->foam[0]);
    swDestroyImage(gpu, &view->foam[1]);
}

size_t swGetGpuViewMemory(const swGpuView* view)
{
    return (size_t)(view->displacement.memory.size + view->derivatives.memory.size + view->foam[0].memory.size +
                    view->foam[1].memory.size);
}

void swBeginGpuView(swGpu* gpu, VkCommandBuffer commands, swGpuView* view)
{
    if (!view->foam[0].isInitialized)
    {
        view->firstFrame = gpu->frameIndex;
    }
    swInitializeImage(gpu, commands, &view->displacement);
    swInitializeImage(gpu, commands, &view->derivatives);
    swInitializeImage(gpu, commands, &view->foam[0]);
    swInitializeImage(gpu, commands, &view->foam[1]);
}

void swCommitGpuFoam(uint64_t frameIndex, const swViewFrame* frame, swGpuView* view)
{
    if (!view->foamMoves)
    {
        return;
    }
    memmove(view->earlier + 1, view->earlier, sizeof(view->earlier) - sizeof(view->earlier[0]));
    view->earlier[0] = view->mark;
    swFoamMark* mark = &view->mark;
    bool isBehind = mark->resetCount == frame->foamResetCount && mark->clock > frame->foamClock &&
                    mark->clock - frame->foamClock <= SW_FOAM_RATE;
    mark->frameIndex = frameIndex;
    mark->hasFoam = true;
    mark->index ^= 1;
    mark->clock = isBehind ? mark->clock : frame->foamClock;
    mark->resetCount = frame->foamResetCount;
    memcpy(mark->slices, frame->slices, sizeof(mark->slices));
}

// Images that each frame writes anew are simply begun again. Foam has a past: it goes back to what the last frame
// before left, which lies untouched in the other image, or begins again if that frame is too long ago.
void swDiscardGpuView(swGpuView* view, uint64_t frameIndex)
{
    view->displacement.isInitialized = false;
    view->derivatives.isInitialized = false;
    if (view->firstFrame >= frameIndex)
    {
        view->foam[0].isInitialized = false;
        view->foam[1].isInitialized = false;
    }
    if (view->mark.hasFoam && view->mark.frameIndex >= frameIndex)
    {
        swFoamMark found = {0};
        for (int i = SW_FOAM_MARKS - 1; i >= 0; --i)
        {
            bool isBefore = view->earlier[i].hasFoam && view->earlier[i].frameIndex < frameIndex;
            found = isBefore ? view->earlier[i] : found;
            view->earlier[i].hasFoam = isBefore;
        }
        view->mark = found;
    }
}
