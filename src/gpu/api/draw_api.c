// SPDX-License-Identifier: MIT
#include "seaway/draw.h"

#include <math.h>

#include "core/base/misuse.h"
#include "gpu/draw/renderer.h"

#define SW_PICTURE_COOKIE 0x504943

#define SW_NEAR_PLANE 0.1f
#define SW_MOST_STOPS 40.0f // of a shot's exposure; the product of light and exposure stays a number

// Camera axes from heading, pitch and roll; the projection maps the near plane to depth 1 and infinity to 0.
swCamera swMakeCamera(swPos position, float heading, float pitch, float roll, float verticalFov, uint32_t width,
                      uint32_t height)
{
    double sh = sin((double)heading), ch = cos((double)heading);
    double sp = sin((double)pitch), cp = cos((double)pitch);
    double sr = sin((double)roll), cr = cos((double)roll);
    double right[3] = {ch, 0.0, sh};
    double forward[3] = {sh * cp, sp, -ch * cp};
    double up[3] = {-sh * sp, cp, ch * sp};
    swCamera camera = {.position = position, .nearPlane = SW_NEAR_PLANE, .width = width, .height = height};
    for (int i = 0; i < 3; ++i)
    {
        camera.view.m[4 * i + 0] = (float)(right[i] * cr - up[i] * sr);
        camera.view.m[4 * i + 1] = (float)(right[i] * sr + up[i] * cr);
        camera.view.m[4 * i + 2] = (float)-forward[i];
    }
    camera.view.m[15] = 1.0f;
    double focal = 1.0 / tan(0.5 * (double)verticalFov);
    camera.projection.m[0] = (float)(focal * height / width);
    camera.projection.m[5] = (float)-focal;
    camera.projection.m[11] = -1.0f;
    camera.projection.m[14] = SW_NEAR_PLANE;
    return camera;
}

#define SW_DEBUG_MODE(name, number, word) _Static_assert((name) == (number), #name " has another number in shaders");
#include "shared/debug_modes.inl"
#undef SW_DEBUG_MODE

const char* swDebugMode_GetName(swDebugMode mode)
{
    static const char* const names[] = {
#define SW_DEBUG_MODE(name, number, word) [name] = #word,
#include "shared/debug_modes.inl"
#undef SW_DEBUG_MODE
    };
    _Static_assert(sizeof(names) / sizeof(names[0]) == SW_DEBUG_COUNT, "a debug mode has no word");
    return (unsigned)mode < SW_DEBUG_COUNT ? names[mode] : "unknown";
}

swPictureDef swDefaultPictureDef(void)
{
    return (swPictureDef){
        .colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT,
        .depthFormat = VK_FORMAT_D32_SFLOAT,
        .outputFormat = VK_FORMAT_R8G8B8A8_SRGB,
        .internalValue = SW_PICTURE_COOKIE,
    };
}

swResult swCreateRenderer(swGpuWorld* gpuWorld, swRenderer** renderer)
{
    if (renderer != NULL)
    {
        *renderer = NULL;
    }
    const swHost* host = gpuWorld != NULL ? &gpuWorld->gpu->host : NULL;
    SW_REQUIRE(gpuWorld != NULL && renderer != NULL, SW_ERROR_INVALID, host,
               "swCreateRenderer() needs a swGpuWorld and a place for the renderer");
    return swMakeRenderer(gpuWorld, renderer);
}

void swDestroyRenderer(swRenderer* renderer)
{
    if (renderer != NULL)
    {
        swFreeRenderer(renderer);
    }
}

static const swHost* findHost(const swRenderer* renderer)
{
    return renderer != NULL ? &renderer->gpuWorld->gpu->host : NULL;
}

swResult swCreatePicture(swRenderer* renderer, const swPictureDef* def, swPicture** picture)
{
    if (picture != NULL)
    {
        *picture = NULL;
    }
    SW_REQUIRE(renderer != NULL && picture != NULL, SW_ERROR_INVALID, findHost(renderer),
               "swCreatePicture() needs a renderer and a place for the picture");
    SW_REQUIRE(def != NULL && def->internalValue == SW_PICTURE_COOKIE, SW_ERROR_INVALID, findHost(renderer),
               "swCreatePicture() needs a def made by swDefaultPictureDef()");
    return swMakePicture(renderer, def, picture);
}

void swDestroyPicture(swPicture* picture)
{
    if (picture != NULL)
    {
        swFreePicture(picture);
    }
}

static bool isNumber(double value)
{
    return value - value == 0.0; // neither NaN nor infinite
}

static bool areNumbers(const float* values, int count)
{
    bool are = true;
    for (int i = 0; i < count; ++i)
    {
        are = are && isNumber((double)values[i]);
    }
    return are;
}

static bool isLookGood(const swSkyDef* sky, const swWaterDef* water)
{
    return swFields_Check(swGetSkyFields(), sky, NULL, 0) && swFields_Check(swGetWaterFields(), water, NULL, 0);
}

static bool isCameraGood(const swCamera* camera)
{
    return camera->width > 0 && camera->height > 0 && isNumber(camera->position.x) && isNumber(camera->position.y) &&
           isNumber(camera->position.z) && areNumbers(camera->view.m, 16) && areNumbers(camera->projection.m, 16);
}

swResult swPicture_Prepare(swPicture* picture, VkCommandBuffer commands, const swShot* shot, uint64_t frameIndex)
{
    SW_REQUIRE(picture != NULL, SW_ERROR_INVALID, NULL, "swPicture_Prepare() needs a picture");
    const swHost* host = findHost(picture->renderer);
    picture->isPrepared = false;
    SW_REQUIRE(commands != VK_NULL_HANDLE && shot != NULL, SW_ERROR_INVALID, host,
               "swPicture_Prepare() needs a command buffer and a shot");
    SW_REQUIRE(isLookGood(&shot->sky, &shot->water), SW_ERROR_INVALID, host,
               "swPicture_Prepare() needs a sky made by swDefaultSkyDef() and water made by swDefaultWaterDef(), with "
               "numbers in their fields");
    SW_REQUIRE((unsigned)shot->debug < SW_DEBUG_COUNT && isNumber(shot->time) &&
                   fabsf(shot->exposureEv) <= SW_MOST_STOPS,
               SW_ERROR_INVALID, host,
               "swPicture_Prepare() was given the debug mode %d, the time %g s and the exposure %g; they must be a "
               "mode of swDebugMode, a number, and at most %g stops either way",
               (int)shot->debug, shot->time, (double)shot->exposureEv, (double)SW_MOST_STOPS);
    SW_REQUIRE(isCameraGood(&shot->camera), SW_ERROR_INVALID, host,
               "swPicture_Prepare() needs a camera with numbers and a size, as swMakeCamera() makes it");
    SW_REQUIRE((shot->opaqueColor != VK_NULL_HANDLE) == (shot->opaqueDepth != VK_NULL_HANDLE), SW_ERROR_INVALID, host,
               "swPicture_Prepare() was given a shot with opaque %s alone; the water needs both images or none",
               shot->opaqueColor != VK_NULL_HANDLE ? "colour" : "depth");
    SW_REQUIRE(shot->bodyWaterCount >= 0 && shot->bodyWaterCount <= SW_MAX_BODY_WATERS &&
                   (shot->bodyWaterCount == 0 || shot->bodyWaters != NULL),
               SW_ERROR_INVALID, host, "swPicture_Prepare() was given %d waters of bodies; a shot has 0 to %d",
               shot->bodyWaterCount, SW_MAX_BODY_WATERS);
    for (int i = 0; i < shot->bodyWaterCount; ++i)
    {
        SW_REQUIRE(isLookGood(&shot->sky, &shot->bodyWaters[i]), SW_ERROR_INVALID, host,
                   "swPicture_Prepare() needs waters made by swDefaultWaterDef(); number %d of the bodies' is not", i);
    }
    return swPreparePicture(picture, commands, shot, frameIndex);
}

static bool canDraw(const swPicture* picture, VkCommandBuffer commands, const char* call)
{
    SW_REQUIRE(picture != NULL && commands != VK_NULL_HANDLE, false,
               picture != NULL ? findHost(picture->renderer) : NULL, "%s needs a picture and a command buffer", call);
    return true;
}

static bool checkPrepared(const swPicture* picture)
{
    SW_REQUIRE(picture->isPrepared, false, findHost(picture->renderer),
               "a picture was asked to draw before swPicture_Prepare(), or after it failed");
    return true;
}

swResult swPicture_GetSources(const swPicture* picture, swPictureSources* sources)
{
    if (sources != NULL)
    {
        *sources = (swPictureSources){0};
    }
    SW_REQUIRE(picture != NULL && sources != NULL, SW_ERROR_INVALID,
               picture != NULL ? findHost(picture->renderer) : NULL,
               "swPicture_GetSources() needs a picture and a place for the sources");
    if (!checkPrepared(picture))
    {
        return SW_ERROR_INVALID;
    }
    const swUpload* params = &picture->frame.paramsUpload;
    *sources = (swPictureSources){
        .params = params->buffer,
        .paramsOffset = params->offset,
        .paramsSize = params->size,
        .light = picture->sky.light.handle,
        .air = picture->sky.air.view,
    };
    return SW_SUCCESS;
}

int swPicture_GetTiles(const swPicture* picture, int capacity, swTileBounds* tiles)
{
    SW_REQUIRE(picture != NULL && capacity >= 0 && (tiles != NULL || capacity == 0), 0,
               picture != NULL ? findHost(picture->renderer) : NULL,
               "swPicture_GetTiles() needs a picture and room for the tiles");
    if (!checkPrepared(picture))
    {
        return 0;
    }
    const swMeshRings* rings = &picture->frame.rings;
    const swWorld* world = picture->renderer->gpuWorld->world;
    swPosXZ origin = swGetWorldOrigin(world);
    int count = 0;
    for (int i = 0; i < rings->tileCount; ++i)
    {
        const swMeshTile* tile = &rings->tiles[i];
        if ((int)tile->ring >= rings->ringCount)
        {
            continue;
        }
        const swMeshSlice* slice = &rings->slices[tile->ring];
        double step = rings->step * (double)slice->scale;
        swPosXZ low = {rings->anchorX - origin.x + rings->step * slice->originX + step * tile->x,
                       rings->anchorZ - origin.z + rings->step * slice->originZ + step * tile->z};
        if (count < capacity)
        {
            tiles[count] = (swTileBounds){.slice = (int)tile->ring,
                                          .low = low,
                                          .high = {low.x + step * tile->width, low.z + step * tile->height},
                                          .seaLevel = swWorld_GetSeaLevel(world)};
        }
        ++count;
    }
    return count;
}

void swPicture_DrawSurface(swPicture* picture, VkCommandBuffer commands)
{
    if (!canDraw(picture, commands, "swPicture_DrawSurface()") || !checkPrepared(picture))
    {
        return;
    }
    const swRenderer* renderer = picture->renderer;
    const swSurfaceSources sources = {
        .gpuWorld = renderer->gpuWorld,
        .view = picture->view,
        .foam = &renderer->foam,
        .sky = &picture->sky,
        .opaqueColor = picture->opaqueColor,
        .opaqueDepth = picture->opaqueDepth,
    };
    swDrawSurface(renderer->gpuWorld->gpu, commands, &picture->pipelines->surfaces[swChooseSurface(picture)], &sources,
                  &picture->surface, &picture->frame);
}

void swPicture_DrawSky(swPicture* picture, VkCommandBuffer commands)
{
    if (canDraw(picture, commands, "swPicture_DrawSky()") && checkPrepared(picture))
    {
        swDrawSky(picture->renderer->gpuWorld->gpu, commands, &picture->pipelines->sky, &picture->sky, &picture->frame);
    }
}

void swPicture_Expose(swPicture* picture, VkCommandBuffer commands, VkImageView hdr, float dt, bool immediate)
{
    if (!canDraw(picture, commands, "swPicture_Expose()"))
    {
        return;
    }
    swGpu* gpu = picture->renderer->gpuWorld->gpu;
    SW_REQUIRE_VOID(hdr != VK_NULL_HANDLE && isNumber((double)dt), &gpu->host,
                    "swPicture_Expose() needs an image, and a time that is a number");
    swClearExposure(gpu, commands, &picture->tonemap);
    if (picture->debug == SW_DEBUG_NONE)
    {
        swRecordExposure(gpu, commands, &picture->renderer->expose, &picture->tonemap, hdr, dt, immediate);
    }
}

void swPicture_Tonemap(swPicture* picture, VkCommandBuffer commands, VkImageView hdr)
{
    if (!canDraw(picture, commands, "swPicture_Tonemap()"))
    {
        return;
    }
    swGpu* gpu = picture->renderer->gpuWorld->gpu;
    SW_REQUIRE_VOID(hdr != VK_NULL_HANDLE, &gpu->host, "swPicture_Tonemap() needs an image");
    bool isRaw = picture->debug != SW_DEBUG_NONE;
    swDrawTonemap(gpu, commands, &picture->pipelines->tonemap, &picture->tonemap, hdr, picture->time,
                  picture->exposureEv, isRaw);
}
