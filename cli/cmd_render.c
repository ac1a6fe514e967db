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
#include "verbs.h"
#include "video.h"

#include "seaway/lines.h"

// Foam gathers by steps that are longer further back, where what they miss between them has faded and spread: the mean
// stays within 2 % of that of steps of 1/30 s.
#define WARMUP_STEP 0.1        // s, in the last second
#define EARLY_WARMUP_STEP 0.25 // before

static const PixelSize usualSize = {1280, 720};

typedef enum OutputKind
{
    OUTPUT_PNG,
    OUTPUT_EXR,
    OUTPUT_FRAMES,
    OUTPUT_VIDEO
} OutputKind;

typedef struct RenderOptions
{
    const char* outPath;
    OutputKind kind;
    PixelSize size; // 0 x 0: not said, of a sheet
    DeviceName device;
    double time; // NAN: the scene's
    int frames;
    double fps; // NAN: not said
    const char* viewName;
    const char* toViewName;
    bool ease;
    bool ride;
    DebugName debug;
    const char* rangeText; // of the sheet
    const char* marksText;
    uint32_t marks; // lines over the picture
    double exposureEv;
    double sunElevation, sunAzimuth; // degrees; NAN: the scene's
    double warmup;
    int samples;
    int frameFormat; // 0 png, 1 exr
    bool singlePrecision;
    bool enableValidation;
} RenderOptions;

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

static bool IsExr(const RenderOptions* options)
{
    return options->kind == OUTPUT_EXR || (options->kind == OUTPUT_FRAMES && options->frameFormat == 1);
}

static bool SaveFrame(Render* render, int frame)
{
    const RenderOptions* options = &render->options;
    char path[MAX_PATH_LENGTH];
    bool asExr = IsExr(options);
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

// From the first step of the warm-up to the last frame.
static bool CheckTimes(const RenderOptions* options, double time)
{
    double first = time - options->warmup - EARLY_WARMUP_STEP - WARMUP_STEP,
           last = time + options->frames / options->fps;
    if (first < -SW_LARGEST_TIME || last > SW_LARGEST_TIME)
    {
        Complain("render: the time %.17g s with its warm-up and frames goes beyond %.2g s, the largest of a sea", time,
                 SW_LARGEST_TIME);
        return false;
    }
    return true;
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
           (!isnan(options->time) || CheckTimes(options, scene->time));
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
                               .width = options->size.width > 0 ? options->size.width : usualSize.width,
                               .height = options->size.height > 0 ? options->size.height : usualSize.height,
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

// What is written is known by the ending. A device or a FIFO without one takes a picture.
static bool ChooseKind(RenderOptions* options)
{
    const char* path = options->outPath;
    const char* slash = strrchr(path, '/');
    const char* dot = strrchr(slash != NULL ? slash : path, '.');
    options->kind = HasEnding(path, ".png")   ? OUTPUT_PNG
                    : HasEnding(path, ".exr") ? OUTPUT_EXR
                    : HasEnding(path, ".mp4") ? OUTPUT_VIDEO
                    : IsDevice(path)          ? OUTPUT_PNG
                                              : OUTPUT_FRAMES;
    if (options->kind == OUTPUT_FRAMES && dot != NULL && dot[1] != 0 && dot[1] != '.')
    {
        Complain("render: --out %s: \"%s\" is none of .png, .exr and .mp4; end a folder's name with /", path, dot);
        return false;
    }
    return true;
}

// Options that would do nothing to this kind of output.
static bool CheckEffects(const RenderOptions* options)
{
    const char* useless = NULL;
    const char* where = NULL;
    if (options->frameFormat != 0 && options->kind != OUTPUT_FRAMES)
    {
        useless = "--frame-format";
        where = "without a folder to write frames to";
    }
    else if (options->singlePrecision && !IsExr(options))
    {
        useless = "--exr-float";
        where = "without .exr";
    }
    else if (options->exposureEv != 0.0 && IsExr(options))
    {
        useless = "--exposure";
        where = "on .exr, which holds the light before exposure";
    }
    else if (options->marksText != NULL && IsExr(options))
    {
        useless = "--show";
        where = "on .exr, which holds the light before lines are drawn";
    }
    else if (!isnan(options->fps) && options->frames == 1 && options->kind != OUTPUT_VIDEO)
    {
        useless = "--fps";
        where = "on a single picture";
    }
    if (useless != NULL)
    {
        Complain("render: %s has no effect %s; leave it out", useless, where);
    }
    return useless == NULL;
}

static bool ParseRange(const char* text, swSheetDef* def)
{
    char low[64];
    const char* colon = strchr(text, ':');
    double numbers[2];
    bool isPair = colon != NULL && (size_t)(colon - text) < sizeof(low);
    if (isPair)
    {
        memcpy(low, text, (size_t)(colon - text));
        low[colon - text] = '\0';
    }
    if (!isPair || !ParseNumber(low, &numbers[0]) || !ParseNumber(colon + 1, &numbers[1]) ||
        !((float)numbers[0] < (float)numbers[1]) || fabs(numbers[0]) > 1e9 || fabs(numbers[1]) > 1e9)
    {
        Complain("render: --layer-range wants two numbers within 1e9, the lower first, such as -2:2, not \"%s\"", text);
        return false;
    }
    def->hasRange = true;
    def->low = (float)numbers[0];
    def->high = (float)numbers[1];
    return true;
}

// What is drawn has no effect on a layer.
static bool CheckSheet(RenderOptions* options)
{
    if (!options->debug.isSheet)
    {
        options->size = options->size.width > 0 ? options->size : usualSize;
        if (options->rangeText != NULL)
        {
            Complain("render: --layer-range has no effect without --debug layer:NAME; add that, or leave it out");
        }
        return options->rangeText == NULL;
    }
    if (options->marksText != NULL)
    {
        Complain("render: --show has no effect on a layer; leave it out");
        return false;
    }
    if (options->samples > 1)
    {
        Complain("render: --samples has no effect on a layer; leave it out");
        return false;
    }
    return options->rangeText == NULL || ParseRange(options->rangeText, &options->debug.sheet);
}

static bool CheckOptions(RenderOptions* options)
{
    const char* path = options->outPath;
    if (path == NULL)
    {
        Complain("render: --out is missing: a name.png, name.exr, name.mp4, or a folder");
        return false;
    }
    if (options->marksText != NULL && !swParseStageMarks(options->marksText, &options->marks))
    {
        Complain("render: --show is a list of queries, ray, tiles and inputs, such as ray,inputs, not \"%s\"",
                 options->marksText);
        return false;
    }
    if (!ChooseKind(options) || !CheckEffects(options) || !CheckSheet(options))
    {
        return false;
    }
    options->fps = isnan(options->fps) ? 30.0 : options->fps;
    bool isPicture = options->kind == OUTPUT_PNG || options->kind == OUTPUT_EXR;
    if (isPicture && options->frames > 1)
    {
        Complain("render: %d frames do not fit into %s; give --out a folder or a name.mp4", options->frames, path);
        return false;
    }
    if (options->toViewName != NULL && options->frames < 2)
    {
        Complain("render: --to-view wants --frames N of at least 2");
        return false;
    }
    if (options->kind == OUTPUT_VIDEO && (options->size.width % 2 != 0 || options->size.height % 2 != 0))
    {
        Complain("render: a video wants an even width and height, not %dx%d", options->size.width,
                 options->size.height);
        return false;
    }
    int factor = (int)lround(sqrt((double)options->samples));
    if (factor * factor != options->samples)
    {
        Complain("render: --samples is a square: 1, 4, 9, 16, 25, 36, 49 or 64, not %d", options->samples);
        return false;
    }
    return isnan(options->time) || CheckTimes(options, options->time);
}

int RunRender(int argumentCount, char** arguments)
{
    static const char* const formats[] = {"png", "exr", NULL};
    static const char* const debugWords[] = {"debug", NULL};
    const char* scenePath = NULL;
    RenderOptions render = {.time = (double)NAN,
                            .frames = 1,
                            .fps = (double)NAN,
                            .sunElevation = (double)NAN,
                            .sunAzimuth = (double)NAN,
                            .warmup = 5.0,
                            .samples = 1};
    const Option options[] = {
        {.name = "out",
         .kind = OPTION_OUTPUT,
         .value = &render.outPath,
         .placeholder = "FILE",
         .help = "name.png, name.exr (linear light), name.mp4, or a folder"},
        {.name = "size",
         .kind = OPTION_SIZE,
         .value = &render.size,
         .placeholder = "WxH",
         .help = "pixels (default 1280x720; of a layer, a pixel for each texel)",
         .min = 16,
         .max = 16384},
        {.name = "time",
         .kind = OPTION_NUMBER,
         .value = &render.time,
         .placeholder = "T",
         .help = "of the first frame, s (default: the scene's)",
         .min = -SW_LARGEST_TIME,
         .max = SW_LARGEST_TIME},
        {.name = "frames",
         .kind = OPTION_INT,
         .value = &render.frames,
         .placeholder = "N",
         .help = "frames of a video or a folder (default 1)",
         .min = 1,
         .max = 1e6},
        {.name = "fps",
         .kind = OPTION_NUMBER,
         .value = &render.fps,
         .placeholder = "F",
         .help = "frames per second of the sea and the video (default 30)",
         .min = 0.01,
         .max = 1000},
        {.name = "view",
         .kind = OPTION_TEXT,
         .value = &render.viewName,
         .placeholder = "NAME",
         .help = "a view of the scene (default: its first)"},
        {.name = "to-view",
         .kind = OPTION_TEXT,
         .value = &render.toViewName,
         .placeholder = "NAME",
         .help = "move there over the frames, height growing by equal factors"},
        {.name = "ease",
         .kind = OPTION_FLAG,
         .value = &render.ease,
         .help = "of --to-view: start and end that move gently",
         .needs = "to-view"},
        {.name = "ride",
         .kind = OPTION_FLAG,
         .value = &render.ride,
         .help = "the view's height counts from the water under it"},
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &render.device,
         .placeholder = "D",
         .help = "auto, gpu, software, or a number of `seaway devices`"},
        {.name = "samples",
         .kind = OPTION_INT,
         .value = &render.samples,
         .placeholder = "N",
         .help = "rendered pixels for each finished one, a square (default 1)",
         .min = 1,
         .max = 64},
        {.name = "sun-elevation",
         .kind = OPTION_NUMBER,
         .value = &render.sunElevation,
         .placeholder = "DEG",
         .help = "of the sun, in place of the scene's",
         .min = -90,
         .max = 90},
        {.name = "sun-azimuth",
         .kind = OPTION_NUMBER,
         .value = &render.sunAzimuth,
         .placeholder = "DEG",
         .help = "bearing of the sun, in place of the scene's",
         .min = -360,
         .max = 360},
        {.name = "exposure",
         .kind = OPTION_NUMBER,
         .value = &render.exposureEv,
         .placeholder = "EV",
         .help = "stops to add to the scene's exposure",
         .min = -20,
         .max = 20,
         .without = debugWords},
        {.name = "warmup",
         .kind = OPTION_NUMBER,
         .value = &render.warmup,
         .placeholder = "S",
         .help = "seconds of foam before the first frame (default 5)",
         .max = 600},
        {.name = "debug", .kind = OPTION_DEBUG, .value = &render.debug, .placeholder = "MODE", .help = DEBUG_MODE_HELP},
        {.name = "layer-range",
         .kind = OPTION_TEXT,
         .value = &render.rangeText,
         .placeholder = "A:B",
         .help = "numbers of a layer's first and last colour (default: its least and greatest)",
         .needs = "debug"},
        {.name = "show",
         .kind = OPTION_TEXT,
         .value = &render.marksText,
         .placeholder = "LIST",
         .help = "lines over the picture: any of queries,ray,tiles,inputs"},
        {.name = "frame-format",
         .kind = OPTION_CHOICE,
         .value = &render.frameFormat,
         .placeholder = "F",
         .help = "of frames in a folder: png (default) or exr",
         .choices = formats},
        {.name = "exr-float",
         .kind = OPTION_FLAG,
         .value = &render.singlePrecision,
         .help = "32 instead of 16 bits a component"},
        {.name = "validate",
         .kind = OPTION_FLAG,
         .value = &render.enableValidation,
         .help = "Vulkan validation layers; a message of theirs is a problem"},
    };
    const Verb verb = {.name = "render",
                       .synopsis = "SCENE --out FILE [options]",
                       .text =
                           "Make a picture, numbered frames or a video of a scene, without a window.\n\n"
                           "  seaway render scenes/gale.yaml --out gale.png\n"
                           "  seaway render scenes/open_sea.yaml --out up.mp4 --frames 300 --view low --to-view high",
                       .options = options,
                       .optionCount = sizeof(options) / sizeof(options[0]),
                       .positionalMin = 1,
                       .positionalMax = 1,
                       .positionalName = "a scene file",
                       .positionals = &scenePath};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    return CheckOptions(&render) ? RenderScene(&render, scenePath) : EXIT_USAGE;
}
