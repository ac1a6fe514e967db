// SPDX-License-Identifier: MIT
#include "render_options.h"

#include <math.h>
#include <string.h>

#include "output.h"

#include "seaway/lines.h"

bool IsRenderedExr(const RenderOptions* options)
{
    return options->kind == OUTPUT_EXR || (options->kind == OUTPUT_FRAMES && options->frameFormat == 1);
}

bool CheckRenderTimes(const RenderOptions* options, double time)
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
    else if (options->singlePrecision && !IsRenderedExr(options))
    {
        useless = "--exr-float";
        where = "without .exr";
    }
    else if (options->exposureEv != 0.0 && IsRenderedExr(options))
    {
        useless = "--exposure";
        where = "on .exr, which holds the light before exposure";
    }
    else if (options->marksText != NULL && IsRenderedExr(options))
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
        options->size = options->size.width > 0 ? options->size : usualPictureSize;
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

bool CheckRenderOptions(RenderOptions* options)
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
    return isnan(options->time) || CheckRenderTimes(options, options->time);
}

ParseResult ParseRenderOptions(int argumentCount, char** arguments, RenderOptions* render, const char** scenePath)
{
    static const char* const formats[] = {"png", "exr", NULL};
    static const char* const debugWords[] = {"debug", NULL};
    *render = (RenderOptions){.time = (double)NAN,
                              .frames = 1,
                              .fps = (double)NAN,
                              .sunElevation = (double)NAN,
                              .sunAzimuth = (double)NAN,
                              .warmup = 5.0,
                              .samples = 1};
    const Option options[] = {
        {.name = "out",
         .kind = OPTION_OUTPUT,
         .value = &render->outPath,
         .placeholder = "FILE",
         .help = "name.png, name.exr (linear light), name.mp4, or a folder"},
        {.name = "size",
         .kind = OPTION_SIZE,
         .value = &render->size,
         .placeholder = "WxH",
         .help = "pixels (default 1280x720; of a layer, a pixel for each texel)",
         .min = 16,
         .max = 16384},
        {.name = "time",
         .kind = OPTION_NUMBER,
         .value = &render->time,
         .placeholder = "T",
         .help = "of the first frame, s (default: the scene's)",
         .min = -SW_LARGEST_TIME,
         .max = SW_LARGEST_TIME},
        {.name = "frames",
         .kind = OPTION_INT,
         .value = &render->frames,
         .placeholder = "N",
         .help = "frames of a video or a folder (default 1)",
         .min = 1,
         .max = 1e6},
        {.name = "fps",
         .kind = OPTION_NUMBER,
         .value = &render->fps,
         .placeholder = "F",
         .help = "frames per second of the sea and the video (default 30)",
         .min = 0.01,
         .max = 1000},
        {.name = "view",
         .kind = OPTION_TEXT,
         .value = &render->viewName,
         .placeholder = "NAME",
         .help = "a view of the scene (default: its first)"},
        {.name = "to-view",
         .kind = OPTION_TEXT,
         .value = &render->toViewName,
         .placeholder = "NAME",
         .help = "move there over the frames, height growing by equal factors"},
        {.name = "ease",
         .kind = OPTION_FLAG,
         .value = &render->ease,
         .help = "of --to-view: start and end that move gently",
         .needs = "to-view"},
        {.name = "ride",
         .kind = OPTION_FLAG,
         .value = &render->ride,
         .help = "the view's height counts from the water under it"},
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &render->device,
         .placeholder = "D",
         .help = "auto, gpu, software, or a number of `seaway devices`"},
        {.name = "samples",
         .kind = OPTION_INT,
         .value = &render->samples,
         .placeholder = "N",
         .help = "rendered pixels for each finished one, a square (default 1)",
         .min = 1,
         .max = 64},
        {.name = "sun-elevation",
         .kind = OPTION_NUMBER,
         .value = &render->sunElevation,
         .placeholder = "DEG",
         .help = "of the sun, in place of the scene's",
         .min = -90,
         .max = 90},
        {.name = "sun-azimuth",
         .kind = OPTION_NUMBER,
         .value = &render->sunAzimuth,
         .placeholder = "DEG",
         .help = "bearing of the sun, in place of the scene's",
         .min = -360,
         .max = 360},
        {.name = "exposure",
         .kind = OPTION_NUMBER,
         .value = &render->exposureEv,
         .placeholder = "EV",
         .help = "stops to add to the scene's exposure",
         .min = -20,
         .max = 20,
         .without = debugWords},
        {.name = "warmup",
         .kind = OPTION_NUMBER,
         .value = &render->warmup,
         .placeholder = "S",
         .help = "seconds of foam before the first frame (default 5)",
         .max = 600},
        {.name = "debug",
         .kind = OPTION_DEBUG,
         .value = &render->debug,
         .placeholder = "MODE",
         .help = DEBUG_MODE_HELP},
        {.name = "layer-range",
         .kind = OPTION_TEXT,
         .value = &render->rangeText,
         .placeholder = "A:B",
         .help = "numbers of a layer's first and last colour (default: its least and greatest)",
         .needs = "debug"},
        {.name = "show",
         .kind = OPTION_TEXT,
         .value = &render->marksText,
         .placeholder = "LIST",
         .help = "lines over the picture: any of queries,ray,tiles,inputs"},
        {.name = "frame-format",
         .kind = OPTION_CHOICE,
         .value = &render->frameFormat,
         .placeholder = "F",
         .help = "of frames in a folder: png (default) or exr",
         .choices = formats},
        {.name = "exr-float",
         .kind = OPTION_FLAG,
         .value = &render->singlePrecision,
         .help = "32 instead of 16 bits a component"},
        {.name = "validate",
         .kind = OPTION_FLAG,
         .value = &render->enableValidation,
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
                       .positionals = scenePath};
    return ParseArguments(&verb, argumentCount, arguments);
}
