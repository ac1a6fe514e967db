// SPDX-License-Identifier: MIT
#pragma once

// What `seaway render` is asked for.

#include "args.h"
#include "common.h"

// Foam gathers by steps that are longer further back, where what they miss between them has faded and spread: the mean
// stays within 2 % of that of steps of 1/30 s.
#define WARMUP_STEP 0.1        // s, in the last second
#define EARLY_WARMUP_STEP 0.25 // before

// Of a picture whose size is not said.
static const PixelSize usualPictureSize = {1280, 720};

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

// From the command line; what is not said is a default, or NAN. Words and ranges are checked, how options go together
// is not yet.
ParseResult ParseRenderOptions(int argumentCount, char** arguments, RenderOptions* options, const char** scenePath);

// How they go together, and what follows from them: the kind of output, lines, ranges. Complains and returns false if
// they cannot be.
bool CheckRenderOptions(RenderOptions* options);

// Whether the sea has times from the first step of the warm-up to the last frame. Complains if not.
bool CheckRenderTimes(const RenderOptions* options, double time);

// Whether .exr files are written.
bool IsRenderedExr(const RenderOptions* options);
