// SPDX-License-Identifier: MIT
#include "seaway/draw.h"

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "gpu/draw/sky.h"
#include "gpu/draw/surface.h"
#include "gpu/draw/tonemap.h"

#define SW_RENDERER_COOKIE 0x524e44

#define SW_NEAR_PLANE 0.1f

struct swRenderer
{
    swGpuWorld* gpuWorld;
    swRendererDef def;
    swSky sky;
    swSurface surface;
    swTonemap tonemap;
    bool isPrepared;
    uint32_t discardCount;  // of the world, as far as the renderer knows
    swPictureFrame picture; // of the last swRenderer_Prepare()
    const swGpuView* view;
    float time, exposureEv;
    swDebugMode debug;
};

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

const char* swDebugMode_GetName(swDebugMode mode)
{
    static const char* const names[SW_DEBUG_COUNT] = {
        [SW_DEBUG_NONE] = "none",       [SW_DEBUG_SLICES] = "slices",       [SW_DEBUG_WIREFRAME] = "wireframe",
        [SW_DEBUG_NORMALS] = "normals", [SW_DEBUG_HEIGHT] = "height",       [SW_DEBUG_JACOBIAN] = "jacobian",
        [SW_DEBUG_FOAM] = "foam",       [SW_DEBUG_ROUGHNESS] = "roughness",
    };
    return (unsigned)mode < SW_DEBUG_COUNT ? names[mode] : "unknown";
}

swRendererDef swDefaultRendererDef(void)
{
    return (swRendererDef){
        .colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT,
        .depthFormat = VK_FORMAT_D32_SFLOAT,
        .outputFormat = VK_FORMAT_R8G8B8A8_SRGB,
        .internalValue = SW_RENDERER_COOKIE,
    };
}

static bool isDrawable(const swGpu* gpu, VkFormat format, VkFormatFeatureFlags feature)
{
    VkFormatProperties properties;
    gpu->vk.GetPhysicalDeviceFormatProperties(gpu->physicalDevice, format, &properties);
    return (properties.optimalTilingFeatures & feature) == feature;
}

static swResult checkFormats(const swGpu* gpu, const swRendererDef* def)
{
    const struct
    {
        const char* name;
        VkFormat format;
        VkFormatFeatureFlags feature;
    } formats[] = {
        {"colour", def->colorFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT},
        {"depth", def->depthFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT},
        {"output", def->outputFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT},
    };
    for (size_t i = 0; i < sizeof(formats) / sizeof(formats[0]); ++i)
    {
        if (!isDrawable(gpu, formats[i].format, formats[i].feature))
        {
            return swFail(&gpu->host, SW_ERROR_UNSUPPORTED,
                          "The device %s cannot draw to the renderer's %s format (VkFormat %d).",
                          gpu->properties.deviceName, formats[i].name, (int)formats[i].format);
        }
    }
    return SW_SUCCESS;
}

swResult swCreateRenderer(swGpuWorld* gpuWorld, const swRendererDef* def, swRenderer** renderer)
{
    if (renderer != NULL)
    {
        *renderer = NULL;
    }
    const swHost* host = gpuWorld != NULL ? &gpuWorld->gpu->host : NULL;
    SW_REQUIRE(gpuWorld != NULL && renderer != NULL, SW_ERROR_INVALID, host,
               "swCreateRenderer() needs a swGpuWorld and a place for the renderer");
    SW_REQUIRE(def != NULL && def->internalValue == SW_RENDERER_COOKIE, SW_ERROR_INVALID, host,
               "swCreateRenderer() needs a def made by swDefaultRendererDef()");
    swGpu* gpu = gpuWorld->gpu;
    swResult result = checkFormats(gpu, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swRenderer* created = swAllocateZero(&gpu->host, sizeof(*created));
    if (!created)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "No memory for a renderer.");
    }
    created->gpuWorld = gpuWorld;
    created->def = *def;
    result = swCreateSky(gpu, def, &created->sky);
    if (result == SW_SUCCESS)
    {
        result = swCreateSurface(gpu, def, &created->surface);
    }
    if (result == SW_SUCCESS)
    {
        result = swCreateTonemap(gpu, def, &created->tonemap);
    }
    if (result != SW_SUCCESS)
    {
        swDestroyRenderer(created);
        return result;
    }
    *renderer = created;
    return SW_SUCCESS;
}

void swDestroyRenderer(swRenderer* renderer)
{
    if (!renderer)
    {
        return;
    }
    swGpu* gpu = renderer->gpuWorld->gpu;
    swDestroyTonemap(gpu, &renderer->tonemap);
    swDestroySurface(gpu, &renderer->surface);
    swDestroySky(gpu, &renderer->sky);
    swFree(&gpu->host, renderer, sizeof(*renderer));
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

// Frames of the world were thrown away: what their commands were to leave is not there.
static void forgetDiscarded(swRenderer* renderer)
{
    const swGpuWorld* gpuWorld = renderer->gpuWorld;
    uint32_t missed = gpuWorld->discardCount - renderer->discardCount;
    if (missed > 0)
    {
        uint64_t from = missed == 1 ? gpuWorld->discardedFrom : 0;
        swForgetSky(&renderer->sky);
        swForgetSurface(&renderer->surface);
        swForgetExposure(&renderer->tonemap, from);
        renderer->discardCount = gpuWorld->discardCount;
    }
}

swResult swRenderer_Prepare(swRenderer* renderer, VkCommandBuffer commands, const swPicture* picture,
                            uint64_t frameIndex)
{
    SW_REQUIRE(renderer != NULL, SW_ERROR_INVALID, NULL, "swRenderer_Prepare() needs a renderer");
    swGpu* gpu = renderer->gpuWorld->gpu;
    renderer->isPrepared = false;
    SW_REQUIRE(commands != VK_NULL_HANDLE && picture != NULL, SW_ERROR_INVALID, &gpu->host,
               "swRenderer_Prepare() needs a command buffer and a picture");
    SW_REQUIRE(isLookGood(&picture->sky, &picture->water), SW_ERROR_INVALID, &gpu->host,
               "swRenderer_Prepare() needs a sky made by swDefaultSkyDef() and water made by swDefaultWaterDef(), with "
               "numbers in their fields");
    SW_REQUIRE(
        (unsigned)picture->debug < SW_DEBUG_COUNT && isNumber(picture->time) && isNumber((double)picture->exposureEv),
        SW_ERROR_INVALID, &gpu->host,
        "swRenderer_Prepare() was given the debug mode %d, the time %g s and the exposure %g; they must be a mode "
        "of swDebugMode and numbers",
        (int)picture->debug, picture->time, (double)picture->exposureEv);
    SW_REQUIRE(isCameraGood(&picture->camera), SW_ERROR_INVALID, &gpu->host,
               "swRenderer_Prepare() needs a camera with numbers and a size, as swMakeCamera() makes it");
    const swFrame* frame = swGetWorldFrame(renderer->gpuWorld->world);
    const swViewFrame* view = findViewFrame(frame, picture->view);
    renderer->view = swFindGpuView(renderer->gpuWorld, picture->view);
    if (!view || !renderer->view)
    {
        return swFail(&gpu->host, SW_ERROR_INVALID,
                      "The picture's view was not recorded: step the world and call swGpuWorld_Record() first.");
    }
    forgetDiscarded(renderer);
    swBeginGpuFrame(gpu, frameIndex);
    renderer->time = (float)fmod(picture->time, 4096.0);
    renderer->exposureEv = picture->exposureEv;
    renderer->debug = picture->debug;
    swBuildPicture(picture, swGetWorldOrigin(renderer->gpuWorld->world), frame, view, renderer->gpuWorld->detail.width,
                   &renderer->picture);
    swResult result = swUploadPicture(gpu, &renderer->picture);
    result = result == SW_SUCCESS ? swPrepareSurface(gpu, &renderer->surface, &renderer->picture) : result;
    if (result != SW_SUCCESS)
    {
        return result; // nothing is recorded yet
    }
    swStartPassTimer(gpu, commands);
    swClearExposure(gpu, commands, &renderer->tonemap);
    swRecordSkyTables(gpu, commands, &renderer->sky, &renderer->picture);
    swRecordSurface(gpu, commands, &renderer->surface, &renderer->sky.halvePipeline, &renderer->picture);
    renderer->isPrepared = true;
    return SW_SUCCESS;
}

static bool canDraw(const swRenderer* renderer, VkCommandBuffer commands, const char* call)
{
    SW_REQUIRE(renderer != NULL && commands != VK_NULL_HANDLE, false,
               renderer != NULL ? &renderer->gpuWorld->gpu->host : NULL, "%s needs a renderer and a command buffer",
               call);
    return true;
}

static bool checkPrepared(const swRenderer* renderer)
{
    SW_REQUIRE(renderer->isPrepared, false, &renderer->gpuWorld->gpu->host,
               "a renderer was asked to draw before swRenderer_Prepare(), or after it failed");
    return true;
}

void swRenderer_DrawSurface(swRenderer* renderer, VkCommandBuffer commands)
{
    if (canDraw(renderer, commands, "swRenderer_DrawSurface()") && checkPrepared(renderer))
    {
        swDrawSurface(renderer->gpuWorld->gpu, commands, &renderer->surface, &renderer->sky, renderer->gpuWorld,
                      renderer->view, &renderer->picture);
    }
}

void swRenderer_DrawSky(swRenderer* renderer, VkCommandBuffer commands)
{
    if (canDraw(renderer, commands, "swRenderer_DrawSky()") && checkPrepared(renderer))
    {
        swDrawSky(renderer->gpuWorld->gpu, commands, &renderer->sky, &renderer->picture);
    }
}

void swRenderer_Expose(swRenderer* renderer, VkCommandBuffer commands, VkImageView hdr, float dt, bool immediate)
{
    if (!canDraw(renderer, commands, "swRenderer_Expose()"))
    {
        return;
    }
    swGpu* gpu = renderer->gpuWorld->gpu;
    SW_REQUIRE_VOID(hdr != VK_NULL_HANDLE && isNumber((double)dt), &gpu->host,
                    "swRenderer_Expose() needs a picture, and a time that is a number");
    swClearExposure(gpu, commands, &renderer->tonemap);
    if (renderer->debug == SW_DEBUG_NONE)
    {
        swRecordExposure(gpu, commands, &renderer->tonemap, hdr, dt, immediate);
    }
}

void swRenderer_Tonemap(swRenderer* renderer, VkCommandBuffer commands, VkImageView hdr)
{
    if (!canDraw(renderer, commands, "swRenderer_Tonemap()"))
    {
        return;
    }
    SW_REQUIRE_VOID(hdr != VK_NULL_HANDLE, &renderer->gpuWorld->gpu->host, "swRenderer_Tonemap() needs a picture");
    bool isRaw = renderer->debug != SW_DEBUG_NONE;
    swDrawTonemap(renderer->gpuWorld->gpu, commands, &renderer->tonemap, hdr, renderer->time, renderer->exposureEv,
                  isRaw);
}
