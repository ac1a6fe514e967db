// SPDX-License-Identifier: MIT
// `seaway render`: pictures and video without a window.
//
// The sea is stepped before the first frame so that foam has gathered. Between two views the camera moves so that its
// height grows by the same factor every second (a dolly from 2 m to 2 km spends as long from 2 to 20 m as from 200 m to
// 2 km), along the straight line between the two; angles go the short way round.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "image.h"
#include "output.h"
#include "picture.h"
#include "progress.h"
#include "render_options.h"
#include "verbs.h"
#include "video.h"

#include "seaway/lines.h"

typedef struct Render
{
    RenderOptions options;
    swHost host;
    swScene* scene;
    swSceneSea sea;
    double seaTime; // of the last step, or where the sea was set to, s
    swWorld* world;
    swView* view;
    PictureMaker* maker;
    swSheet* sheet; // where a layer is shown instead of the picture
    const swSceneView* from;
    const swSceneView* to; // NULL: the camera stands still
    Video* video;
    uint8_t* bytes;
    float* floats;
} Render;

static double Mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

static float MixAngle(float a, float b, double t)
{
    return (float)((double)a + remainder((double)b - (double)a, 2.0 * SW_PI) * t);
}

// The viewpoint at fraction t of the way.
static swSceneView MixViews(const swSceneView* a, const swSceneView* b, double t)
{
    swSceneView view = *a;
    double heightA = a->position.y, heightB = b->position.y;
    double height = Mix(heightA, heightB, t), along = t;
    if (heightA > 0.0 && heightB > 0.0)
    {
        height = heightA * pow(heightB / heightA, t);
        double ratio = heightB / heightA;
        along = ratio > 0.99 && ratio < 1.01 ? t : (height - heightA) / (heightB - heightA);
    }
    view.position = (swPos){Mix(a->position.x, b->position.x, along), height, Mix(a->position.z, b->position.z, along)};
    view.heading = MixAngle(a->heading, b->heading, t);
    view.pitch = MixAngle(a->pitch, b->pitch, t);
    view.roll = MixAngle(a->roll, b->roll, t);
    view.verticalFov = (float)Mix((double)a->verticalFov, (double)b->verticalFov, t);
    return view;
}

static double FindProgress(const RenderOptions* options, int frame)
{
    double t = options->frames > 1 ? (double)frame / (options->frames - 1) : 0.0;
    return options->ease ? t * t * (3.0 - 2.0 * t) : t;
}

// Where the camera is in the world. With --ride its height counts from the water under it, without the short waves.
static swPos PlaceCamera(const Render* render, const swSceneView* view)
{
    swPos position = view->position;
    position.y += swWorld_GetSeaLevel(render->world);
    if (render->options.ride)
    {
        swQueryDef def = swDefaultQueryDef();
        def.minWavelength = 4.0f;
        swPosXZ point = {position.x, position.z};
        float height = 0.0f;
        swSurfaceSamples samples = {.height = &height};
        swMoment_QuerySurface(swWorld_GetMoment(render->world), &def, 1, &point, &samples, NULL);
        position.y = view->position.y + (double)height;
    }
    return position;
}

static swSceneView FindFrameView(const Render* render, int frame)
{
    return render->to == NULL ? *render->from
                              : MixViews(render->from, render->to, FindProgress(&render->options, frame));
}

// The sun moves with the camera from one view's to the other's, unless the command line names another.
static swSkyDef FindFrameSky(const Render* render, int frame)
{
    const RenderOptions* options = &render->options;
    swSkyDef sky = swScene_GetSky(render->scene, render->from);
    if (render->to != NULL)
    {
        swSkyDef last = swScene_GetSky(render->scene, render->to);
        double t = FindProgress(options, frame);
        sky.sunAzimuth = MixAngle(sky.sunAzimuth, last.sunAzimuth, t);
        sky.sunElevation = MixAngle(sky.sunElevation, last.sunElevation, t);
    }
    if (!isnan(options->sunElevation))
    {
        sky.sunElevation = (float)(options->sunElevation * (SW_PI / 180.0));
    }
    if (!isnan(options->sunAzimuth))
    {
        sky.sunAzimuth = (float)(options->sunAzimuth * (SW_PI / 180.0));
    }
    return sky;
}

static bool MovesFloor(const swScene* scene)
{
    for (int i = 0; i < scene->inputCount; ++i)
    {
        if (scene->inputs[i].def.field == SW_INPUT_FLOOR && swSceneInput_IsMoving(&scene->inputs[i]))
        {
            return true;
        }
    }
    return false;
}

static void JumpTo(Render* render, double time)
{
    swWorld_SetTime(render->world, time);
    render->seaTime = time;
}

static bool Step(Render* render, double dt)
{
    render->seaTime += dt;
    swResult result = swSceneSea_Advance(&render->sea, render->seaTime);
    result = result == SW_SUCCESS ? swWorld_Step(render->world, dt) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the sea could not be stepped");
    }
    return result == SW_SUCCESS;
}

// From `warmup` seconds before the first frame to one step before it.
static bool WarmUp(Render* render, double time)
{
    double warmup = render->options.warmup;
    int stepCount = (int)ceil(fmin(warmup, 1.0) / WARMUP_STEP - 1e-9);
    int earlyCount = (int)ceil(fmax(warmup - 1.0, 0.0) / EARLY_WARMUP_STEP - 1e-9);
    swSceneView view = FindFrameView(render, 0);
    JumpTo(render, time - stepCount * WARMUP_STEP - earlyCount * EARLY_WARMUP_STEP);
    BeginProgress("steps of foam", earlyCount + stepCount);
    bool isFine = true;
    for (int i = 0; i < earlyCount + stepCount && isFine; ++i)
    {
        swView_SetViewpoint(render->view, PlaceCamera(render, &view));
        double dt = i <= earlyCount && earlyCount > 0 ? EARLY_WARMUP_STEP : WARMUP_STEP;
        isFine = Step(render, i == 0 ? 0.0 : dt) && AdvancePicture(render->maker);
        UpdateProgress(i + 1);
    }
    EndProgress();
    return isFine;
}

static void PrintSheet(const Render* render, double time)
{
    swSheetInfo info = swSheet_GetInfo(render->sheet);
    FILE* to = IsDevice(render->options.outPath) ? stderr : stdout; // which may be the picture itself
    fprintf(to, "%s.%s at %.10g s: ", swLayer_GetName(info.def.layer),
            swLayer_GetChannelName(info.def.layer, info.def.channel), time);
    if (info.sliceCount == 1)
    {
        fprintf(to, "slice %d", info.firstSlice);
    }
    else
    {
        fprintf(to, "slices 0 to %d", info.sliceCount - 1);
    }
    fprintf(to, " of %d x %d texels, least %.6g, greatest %.6g, shown from %.6g to %.6g", info.resolution,
            info.resolution, (double)info.least, (double)info.greatest, (double)info.low, (double)info.high);
    fprintf(to, info.unknownCount > 0 ? ", %d texels hold nothing\n" : "\n", info.unknownCount);
}

static bool DrawFrame(Render* render, int frame, double time)
{
    const RenderOptions* options = &render->options;
    swSceneView view = FindFrameView(render, frame);
    double dt = frame > 0 ? 1.0 / options->fps : options->warmup > 0.0 ? WARMUP_STEP : 0.0;
    if (frame == 0 && options->warmup <= 0.0)
    {
        JumpTo(render, time);
    }
    swView_SetViewpoint(render->view, PlaceCamera(render, &view));
    if (!Step(render, dt))
    {
        return false;
    }
    if (options->debug.isSheet)
    {
        bool isFine = MakeSheet(render->maker, render->view, &options->debug.sheet, render->sheet);
        if (isFine)
        {
            PrintSheet(render, time + frame / options->fps);
        }
        return isFine;
    }
    swPos position = PlaceCamera(render, &view); // on the water of this step
    swShot shot = {.view = render->view,
                   .camera = swMakeCamera(position, view.heading, view.pitch, view.roll, view.verticalFov,
                                          (uint32_t)options->size.width, (uint32_t)options->size.height),
                   .sky = FindFrameSky(render, frame),
                   .water = render->scene->water,
                   .debug = options->debug.mode,
                   .time = time + frame / options->fps,
                   .exposureEv = render->scene->exposureEv + (float)options->exposureEv,
                   .bodyWaters = render->scene->looks,
                   .bodyWaterCount = render->scene->lookCount};
    int factor = (int)lround(sqrt((double)options->samples));
    shot.camera.width *= (uint32_t)factor;
    shot.camera.height *= (uint32_t)factor;
    if (frame > 0 && MovesFloor(render->scene))
    {
        ForgetPictureLand(render->maker);
    }
    return MakePicture(render->maker, &shot, (float)dt, frame == 0);
}

static void ReadBytes(Render* render)
{
    PixelSize size = render->options.size;
    if (!render->options.debug.isSheet)
    {
        ReadPictureBytes(render->maker, render->bytes);
        return;
    }
    uint8_t* rgba = (uint8_t*)render->floats; // 12 bytes a pixel, and not used otherwise
    swSheet_Draw(render->sheet, size.width, size.height, rgba);
    size_t pixelCount = (size_t)size.width * (size_t)size.height;
    for (size_t i = 0; i < pixelCount; ++i)
    {
        memcpy(render->bytes + 3 * i, rgba + 4 * i, 3);
    }
}

static void ReadFloats(Render* render)
{
    PixelSize size = render->options.size;
    if (render->options.debug.isSheet)
    {
        swSheet_DrawValues(render->sheet, size.width, size.height, render->floats);
    }
    else
    {
        ReadPictureFloats(render->maker, render->floats);
    }
}

static bool SaveFrame(Render* render, int frame)
{
    const RenderOptions* options = &render->options;
    char path[MAX_PATH_LENGTH];
    bool asExr = IsRenderedExr(options);
    int length = snprintf(path, sizeof(path), "%s", options->outPath);
    if (options->kind == OUTPUT_FRAMES)
    {
        bool hasSlash = length > 0 && options->outPath[length - 1] == '/';
        length = snprintf(path, sizeof(path), "%s%sframe_%05d.%s", options->outPath, hasSlash ? "" : "/", frame,
                          asExr ? "exr" : "png");
    }
    if (length >= (int)sizeof(path))
    {
        Complain("cannot write frame %d: its path in %s has more than %d bytes", frame, options->outPath,
                 MAX_PATH_LENGTH - 1);
        return false;
    }
    if (asExr)
    {
        ReadFloats(render);
        return WriteExr(path, options->size.width, options->size.height, render->floats, !options->singlePrecision);
    }
    ReadBytes(render);
    return options->kind == OUTPUT_VIDEO ? WriteVideoFrame(render->video, render->bytes)
                                         : WritePng(path, options->size.width, options->size.height, render->bytes);
}

static bool DrawFrames(Render* render)
{
    const RenderOptions* options = &render->options;
    double time = isnan(options->time) ? render->scene->time : options->time;
    bool isFine = WarmUp(render, time);
    BeginProgress("frames", options->frames);
    for (int frame = 0; frame < options->frames && isFine; ++frame)
    {
        isFine = DrawFrame(render, frame, time) && SaveFrame(render, frame);
        UpdateProgress(frame + 1);
    }
    EndProgress();
    return isFine;
}

static const swSceneView* FindView(const swScene* scene, const char* path, const char* name)
{
    const swSceneView* view = swScene_FindView(scene, name);
    if (view != NULL)
    {
        return view;
    }
    if (name == NULL)
    {
        Complain("%s has no views; add one under `views`", path);
        return NULL;
    }
    const char* names[SW_MAX_SCENE_VIEWS + 1] = {NULL};
    for (int i = 0; i < scene->viewCount; ++i)
    {
        names[i] = scene->views[i].name;
    }
    const char* nearest = FindNearestName(name, names);
    if (nearest != NULL)
    {
        Complain("%s has no view \"%s\"; did you mean %s?", path, name, nearest);
    }
    else
    {
        Complain("%s has no view \"%s\"; its first is %s", path, name, scene->viewCount > 0 ? names[0] : "missing");
    }
    return NULL;
}

static bool ReadSea(Render* render, const char* scenePath)
{
    const RenderOptions* options = &render->options;
    swResult result = swReadScene(&render->host, scenePath, &render->scene);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, scenePath);
        return false;
    }
    swScene* scene = render->scene;
    render->from = FindView(scene, scenePath, options->viewName);
    render->to = options->toViewName != NULL ? FindView(scene, scenePath, options->toViewName) : NULL;
    return render->from != NULL && (options->toViewName == NULL || render->to != NULL) &&
           (!isnan(options->time) || CheckRenderTimes(options, scene->time));
}

static bool OpenSea(Render* render, const char* scenePath)
{
    swScene* scene = render->scene;
    scene->view.enableCpuLayers = false;
    swViewDef view = FitPictureView(render->maker, &scene->view);
    scene->world.enableQueries = render->options.ride || render->options.marks != 0 ||
                                 view.enableCpuLayers; // else a picture needs no surface on the CPU
    swResult result = swOpenScene(&render->host, scene, &render->world, &render->sea);
    result = result == SW_SUCCESS ? swCreateView(render->world, &view, &render->view) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, scenePath);
    }
    return result == SW_SUCCESS && ShowWorld(render->maker, render->world);
}

static bool OpenPixels(Render* render)
{
    const RenderOptions* options = &render->options;
    size_t pixelCount = (size_t)options->size.width * (size_t)options->size.height;
    render->bytes = malloc(pixelCount * 3);
    render->floats = malloc(pixelCount * 3 * sizeof(float));
    if (render->bytes == NULL || render->floats == NULL)
    {
        Complain("no memory for a picture of %dx%d", options->size.width, options->size.height);
        return false;
    }
    if (options->kind == OUTPUT_VIDEO)
    {
        render->video = OpenVideo(options->outPath, options->size.width, options->size.height, options->fps);
        return render->video != NULL;
    }
    return true;
}

// A sheet has a pixel for each texel, unless a size was asked for.
static bool OpenSheet(Render* render)
{
    const swView* view = render->view;
    PixelSize* size = &render->options.size;
    const swSheetDef* def = &render->options.debug.sheet;
    if (!render->options.debug.isSheet)
    {
        return true;
    }
    if (swCreateSheet(&render->host, &render->sheet) != SW_SUCCESS)
    {
        return false; // the log has said why
    }
    if (size->width == 0)
    {
        swFindSheetSize(def->slice >= 0 ? 1 : swView_GetSliceCount(view), swView_GetSlice(view, 0).resolution,
                        &size->width, &size->height);
    }
    return OpenPixels(render);
}

// Whether the output can be written is found out before the sea is made, which may take minutes.
static bool OpenOutput(Render* render)
{
    const RenderOptions* options = &render->options;
    if (!options->debug.isSheet && !OpenPixels(render))
    {
        return false;
    }
    switch (options->kind)
    {
    case OUTPUT_PNG:
    case OUTPUT_EXR:
        return ProbeOutput(options->outPath);
    case OUTPUT_FRAMES:
        return MakeFolder(options->outPath);
    case OUTPUT_VIDEO:
        return true;
    }
    return false;
}

static int RenderScene(const RenderOptions* options, const char* scenePath)
{
    Render render = {.options = *options, .host = MakeHost()};
    swTaskPool* pool = AttachThreads(&render.host, 0);
    bool isFine = OpenOutput(&render) && ReadSea(&render, scenePath);
    if (isFine)
    {
        PictureMakerDef def = {.device = options->device.choice,
                               .deviceIndex = options->device.index,
                               .width = options->size.width > 0 ? options->size.width : usualPictureSize.width,
                               .height = options->size.height > 0 ? options->size.height : usualPictureSize.height,
                               .supersample = (int)lround(sqrt((double)options->samples)),
                               .enableValidation = options->enableValidation};
        render.maker = CreatePictureMaker(&render.host, &def);
        isFine = render.maker != NULL && SetPictureMarks(render.maker, options->marks) && OpenSea(&render, scenePath) &&
                 OpenSheet(&render) && DrawFrames(&render);
    }
    if (render.video != NULL)
    {
        isFine = CloseVideo(render.video, isFine) && isFine;
    }
    swDestroySheet(render.sheet);
    int messageCount = DestroyPictureMaker(render.maker);
    if (messageCount > 0)
    {
        Complain("the validation layers gave %d messages", messageCount);
        isFine = false;
    }
    isFine = FinishOutput() && isFine;
    swDestroyView(render.view);
    swDestroySceneSea(&render.sea);
    swDestroyWorld(render.world);
    swDestroyScene(render.scene);
    swDestroyTaskPool(pool);
    free(render.bytes);
    free(render.floats);
    return isFine ? EXIT_FINE : EXIT_PROBLEM;
}

int RunRender(int argumentCount, char** arguments)
{
    RenderOptions options;
    const char* scenePath = NULL;
    ParseResult parsed = ParseRenderOptions(argumentCount, arguments, &options, &scenePath);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    return CheckRenderOptions(&options) ? RenderScene(&options, scenePath) : EXIT_USAGE;
}
