// SPDX-License-Identifier: MIT
#include "gpu/draw/renderer.h"

#include <math.h>

static swResult createShared(swGpu* gpu, swRenderer* renderer)
{
    swResult result = swCreateSkyPipelines(gpu, &renderer->sky);
    result = result == SW_SUCCESS ? swCreateCullPipeline(gpu, &renderer->cull) : result;
    result = result == SW_SUCCESS ? swCreateExposePipeline(gpu, &renderer->expose) : result;
    return result == SW_SUCCESS ? swCreateFoamTexture(gpu, &renderer->foam) : result;
}

swResult swMakeRenderer(swGpuWorld* gpuWorld, swRenderer** renderer)
{
    swGpu* gpu = gpuWorld->gpu;
    swRenderer* created = swAllocateZero(&gpu->host, sizeof(*created));
    if (created == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "No memory for a renderer.");
    }
    created->gpuWorld = gpuWorld;
    created->discardCount = gpuWorld->discardCount;
    swResult result = createShared(gpu, created);
    if (result != SW_SUCCESS)
    {
        swFreeRenderer(created);
        return result;
    }
    *renderer = created;
    return SW_SUCCESS;
}

static void freeFormats(swGpu* gpu, swFormatPipelines* formats)
{
    for (int i = 0; i < SW_SURFACE_KIND_COUNT; ++i)
    {
        swDestroyPipeline(gpu, &formats->surfaces[i]);
    }
    swDestroyPipeline(gpu, &formats->sky);
    swDestroyPipeline(gpu, &formats->tonemap);
    swFree(&gpu->host, formats, sizeof(*formats));
}

void swFreeRenderer(swRenderer* renderer)
{
    swGpu* gpu = renderer->gpuWorld->gpu;
    while (renderer->firstPicture != NULL)
    {
        swFreePicture(renderer->firstPicture);
    }
    while (renderer->firstFormats != NULL)
    {
        swFormatPipelines* formats = renderer->firstFormats;
        renderer->firstFormats = formats->next;
        freeFormats(gpu, formats);
    }
    swDestroySkyPipelines(gpu, &renderer->sky);
    swDestroyPipeline(gpu, &renderer->cull);
    swDestroyPipeline(gpu, &renderer->expose);
    swDestroyFoamTexture(gpu, &renderer->foam);
    swFree(&gpu->host, renderer, sizeof(*renderer));
}

static swResult checkFormats(const swGpu* gpu, const swPictureDef* def)
{
    const struct
    {
        const char* name;
        VkFormat format;
        VkFormatFeatureFlags features;
    } formats[] = {
        // Integers can be neither filtered nor blended, and no shader of a picture writes them.
        {"colour", def->colorFormat,
         VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT},
        {"depth", def->depthFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT},
        {"output", def->outputFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT},
    };
    for (size_t i = 0; i < sizeof(formats) / sizeof(formats[0]); ++i)
    {
        VkFormatProperties properties;
        gpu->vk.GetPhysicalDeviceFormatProperties(gpu->physicalDevice, formats[i].format, &properties);
        bool hasNoDepth = formats[i].format == VK_FORMAT_S8_UINT; // a stencil alone has the same feature as depth
        if (hasNoDepth || (properties.optimalTilingFeatures & formats[i].features) != formats[i].features)
        {
            return swFail(&gpu->host, SW_ERROR_UNSUPPORTED,
                          "The device %s cannot draw to the picture's %s format (VkFormat %d).",
                          gpu->properties.deviceName, formats[i].name, (int)formats[i].format);
        }
    }
    return SW_SUCCESS;
}

static swResult makeFormats(swRenderer* renderer, const swPictureDef* def)
{
    swGpu* gpu = renderer->gpuWorld->gpu;
    swResult result = checkFormats(gpu, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swFormatPipelines* created = swAllocateZero(&gpu->host, sizeof(*created));
    if (created == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "No memory for a picture's pipelines.");
    }
    created->color = def->colorFormat;
    created->depth = def->depthFormat;
    created->output = def->outputFormat;
    result = swCreateSurfacePipeline(gpu, created->color, created->depth, 0, &created->surfaces[0]);
    result = result == SW_SUCCESS ? swCreateSkyPipeline(gpu, def, &created->sky) : result;
    result = result == SW_SUCCESS ? swCreateTonemapPipeline(gpu, def, &created->tonemap) : result;
    if (result != SW_SUCCESS)
    {
        freeFormats(gpu, created);
        return result;
    }
    created->next = renderer->firstFormats;
    renderer->firstFormats = created;
    return SW_SUCCESS;
}

static swFormatPipelines* findFormats(const swRenderer* renderer, const swPictureDef* def)
{
    swFormatPipelines* formats = renderer->firstFormats;
    while (formats != NULL && (formats->color != def->colorFormat || formats->depth != def->depthFormat ||
                               formats->output != def->outputFormat))
    {
        formats = formats->next;
    }
    return formats;
}

static swResult fillPicture(swGpu* gpu, swPicture* picture)
{
    swResult result = swCreateSky(gpu, &picture->sky);
    result = result == SW_SUCCESS ? swCreateSurface(gpu, &picture->surface) : result;
    return result == SW_SUCCESS ? swCreateTonemap(gpu, &picture->tonemap) : result;
}

swResult swMakePicture(swRenderer* renderer, const swPictureDef* formats, swPicture** picture)
{
    swGpu* gpu = renderer->gpuWorld->gpu;
    if (findFormats(renderer, formats) == NULL)
    {
        swResult made = makeFormats(renderer, formats);
        if (made != SW_SUCCESS)
        {
            return made;
        }
    }
    swPicture* created = swAllocateZero(&gpu->host, sizeof(*created));
    if (created == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "No memory for a picture.");
    }
    created->renderer = renderer;
    created->pipelines = findFormats(renderer, formats);
    created->discardCount = renderer->gpuWorld->discardCount;
    created->next = renderer->firstPicture;
    if (created->next != NULL)
    {
        created->next->previous = created;
    }
    renderer->firstPicture = created;
    swResult result = fillPicture(gpu, created);
    if (result != SW_SUCCESS)
    {
        swFreePicture(created);
        return result;
    }
    *picture = created;
    return SW_SUCCESS;
}

void swFreePicture(swPicture* picture)
{
    swRenderer* renderer = picture->renderer;
    swGpu* gpu = renderer->gpuWorld->gpu;
    *(picture->previous != NULL ? &picture->previous->next : &renderer->firstPicture) = picture->next;
    if (picture->next != NULL)
    {
        picture->next->previous = picture->previous;
    }
    swRetireTonemap(gpu, &picture->tonemap);
    swRetireSurface(gpu, &picture->surface);
    swRetireSky(gpu, &picture->sky);
    swFree(&gpu->host, picture, sizeof(*picture));
}

// Frames of the world were thrown away: what their commands were to leave is not there.
static void forgetDiscarded(swPicture* picture)
{
    swRenderer* renderer = picture->renderer;
    const swGpuWorld* gpuWorld = renderer->gpuWorld;
    if (renderer->discardCount != gpuWorld->discardCount)
    {
        swForgetFoamTexture(&renderer->foam);
        renderer->discardCount = gpuWorld->discardCount;
    }
    uint32_t missed = gpuWorld->discardCount - picture->discardCount;
    if (missed > 0)
    {
        swForgetSky(&picture->sky);
        swForgetExposure(&picture->tonemap, missed == 1 ? gpuWorld->discardedFrom : 0);
        picture->discardCount = gpuWorld->discardCount;
    }
}

static const swViewFrame* findViewFrame(const swFrame* frame, const swView* view)
{
    for (int i = 0; i < frame->viewCount; ++i)
    {
        if (frame->views[i].view == view)
        {
            return &frame->views[i];
        }
    }
    return NULL;
}

int swChooseSurface(const swPicture* picture)
{
    bool isWire = picture->debug == SW_DEBUG_WIREFRAME && picture->renderer->gpuWorld->gpu->hasWireframe;
    return (isWire ? SW_SURFACE_IS_WIRE : 0) | (picture->opaqueColor != VK_NULL_HANDLE ? SW_SURFACE_IS_CLEAR : 0) |
           (picture->hasPlaces ? SW_SURFACE_HAS_PLACES : 0) | (picture->hasColors ? SW_SURFACE_HAS_COLORS : 0) |
           (picture->hasHoles ? SW_SURFACE_HAS_HOLES : 0) |
           (picture->frame.params.bodyCount > 0 ? SW_SURFACE_HAS_BODIES : 0) |
           (picture->hasMadeFoam ? SW_SURFACE_HAS_MADE_FOAM : 0) | (picture->hasWeights ? SW_SURFACE_HAS_WEIGHTS : 0) |
           (picture->carriesFoam ? SW_SURFACE_CARRIES_FOAM : 0);
}

// The pipeline of the shot's surface, which the first picture that needs it makes.
static swResult prepareSurfacePipeline(swGpu* gpu, swPicture* picture)
{
    swFormatPipelines* formats = picture->pipelines;
    int kind = swChooseSurface(picture);
    swPipeline* pipeline = &formats->surfaces[kind];
    return pipeline->handle != VK_NULL_HANDLE
               ? SW_SUCCESS
               : swCreateSurfacePipeline(gpu, formats->color, formats->depth, kind, pipeline);
}

static void recordPreparation(swPicture* picture, VkCommandBuffer commands)
{
    swRenderer* renderer = picture->renderer;
    swGpu* gpu = renderer->gpuWorld->gpu;
    swStartPassTimer(gpu, commands);
    swClearExposure(gpu, commands, &picture->tonemap);
    swRecordSkyTables(gpu, commands, &renderer->sky, &picture->sky, &picture->frame);
    swRecordFoamTexture(gpu, commands, &renderer->sky.halve, &renderer->foam);
    swRecordSurface(renderer->gpuWorld, commands, &renderer->cull, &picture->surface, &picture->frame);
}

// Each body of water has a look that the shot has.
static bool areLooksThere(const swGpu* gpu, const swShot* shot, const swFrame* frame)
{
    for (int i = 0; i < frame->bodyCount; ++i)
    {
        if (frame->bodies[i].look > shot->bodyWaterCount)
        {
            swFail(&gpu->host, SW_ERROR_INVALID,
                   "A body of water has the look %d, and the shot has %d waters of bodies: set swShot::bodyWaters.",
                   frame->bodies[i].look, shot->bodyWaterCount);
            return false;
        }
    }
    return true;
}

swResult swPreparePicture(swPicture* picture, VkCommandBuffer commands, const swShot* shot, uint64_t frameIndex)
{
    swGpuWorld* gpuWorld = picture->renderer->gpuWorld;
    swGpu* gpu = gpuWorld->gpu;
    const swFrame* frame = swGetWorldFrame(gpuWorld->world);
    const swViewFrame* view = findViewFrame(frame, shot->view);
    picture->isPrepared = false;
    picture->view = swFindGpuView(gpuWorld, shot->view);
    if (view == NULL || picture->view == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_INVALID,
                      "The shot's view was not recorded: step the world and call swGpuWorld_Record() first.");
    }
    forgetDiscarded(picture);
    swBeginGpuFrame(gpu, frameIndex);
    picture->time = (float)fmod(shot->time, 4096.0);
    picture->exposureEv = shot->exposureEv;
    picture->debug = shot->debug;
    picture->opaqueColor = shot->opaqueColor;
    picture->opaqueDepth = shot->opaqueDepth;
    picture->hasPlaces = view->stack.layers[SW_LAYER_PLACES].isAuthored;
    picture->hasMadeFoam =
        view->stack.layers[SW_LAYER_WAKE_FOAM].isAuthored || view->stack.layers[SW_LAYER_SHORE_FOAM].isAuthored;
    picture->hasColors = swHasInputs(frame->inputs, SW_INPUT_ALBEDO) || swHasInputs(frame->inputs, SW_INPUT_SHADOW);
    picture->hasHoles = swHasInputs(frame->inputs, SW_INPUT_CLIP);
    picture->hasWeights = swHasInputs(frame->inputs, SW_INPUT_WAVES);
    picture->carriesFoam = swIsFoamCarried(frame);
    if (!areLooksThere(gpu, shot, frame))
    {
        return SW_ERROR_INVALID;
    }
    swBuildPicture(shot, swGetWorldOrigin(gpuWorld->world), frame, view, swGetDetailImage(gpuWorld)->width,
                   &picture->frame);
    swResult result = swUploadPicture(gpu, &picture->frame);
    result = result == SW_SUCCESS ? prepareSurfacePipeline(gpu, picture) : result;
    result = result == SW_SUCCESS ? swPrepareSurface(gpu, &picture->surface, &picture->frame) : result;
    result = result == SW_SUCCESS ? swPrepareFoamTexture(gpu, &picture->renderer->foam) : result;
    if (result != SW_SUCCESS)
    {
        return result; // nothing is recorded yet
    }
    recordPreparation(picture, commands);
    picture->isPrepared = true;
    return SW_SUCCESS;
}
