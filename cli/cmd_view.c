// SPDX-License-Identifier: MIT
// `seaway view`: hands over to the viewer.

#include "args.h"
#include "verbs.h"
#include "viewer.h"

int RunView(int argumentCount, char** arguments)
{
    const char* scenePath = NULL;
    ViewerOptions viewer = DefaultViewerOptions();
    PixelSize size = {1280, 720};
    DeviceName device = {SW_DEVICE_AUTO, 0};
    bool disableVsync = false;
    double uiScale = 1.0;
    DebugName debug = {.mode = SW_DEBUG_NONE, .sheet = viewer.sheet};
    static const char* const pictureEndings[] = {".png", NULL};
    const Option options[] = {
        {.name = "size",
         .kind = OPTION_SIZE,
         .value = &size,
         .placeholder = "WxH",
         .help = "of the window (default 1280x720)",
         .min = 64,
         .max = 16384},
        {.name = "fullscreen", .kind = OPTION_FLAG, .value = &viewer.isFullscreen, .help = "cover the screen"},
        {.name = "view",
         .kind = OPTION_TEXT,
         .value = &viewer.viewName,
         .placeholder = "NAME",
         .help = "start at this view of the scene (default: its first)"},
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &device,
         .placeholder = "D",
         .help = "auto, gpu, software, or a number of `seaway devices`"},
        {.name = "no-vsync", .kind = OPTION_FLAG, .value = &disableVsync, .help = "draw as fast as possible"},
        {.name = "no-panel", .kind = OPTION_FLAG, .value = &viewer.hidePanel, .help = "start without the panel"},
        {.name = "ui-scale",
         .kind = OPTION_NUMBER,
         .value = &uiScale,
         .placeholder = "X",
         .help = "panel and letters so many times as large as suits the window",
         .min = 0.5,
         .max = 4.0},
        {.name = "debug", .kind = OPTION_DEBUG, .value = &debug, .placeholder = "MODE", .help = DEBUG_MODE_HELP},
        {.name = "frames",
         .kind = OPTION_INT,
         .value = &viewer.frameCount,
         .placeholder = "N",
         .help = "leave after N frames of 1/30 s of the sea each",
         .max = 1e9},
        {.name = "screenshot",
         .kind = OPTION_OUTPUT,
         .value = &viewer.screenshotPath,
         .placeholder = "FILE.png",
         .choices = pictureEndings,
         .help = "with --frames: PNG of the last one"},
        {.name = "validate",
         .kind = OPTION_FLAG,
         .value = &viewer.enableValidation,
         .help = "Vulkan validation layers; a message of theirs is a problem"},
    };
    const Verb verb = {
        .name = "view",
        .synopsis = "[SCENE] [options]",
        .text = "Look at a sea in a window: fly or orbit, change waves, wind and sun, save screenshots. Without\n"
                "SCENE an open sea is shown. The panel, F1, lists the keys. It marks what is changed; Ctrl+S\n"
                "writes that to SCENE, and a question comes before it is dropped.",
        .options = options,
        .optionCount = sizeof(options) / sizeof(options[0]),
        .positionalMax = 1,
        .positionals = &scenePath};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    if (viewer.screenshotPath != NULL && viewer.frameCount == 0)
    {
        Complain("view: --screenshot wants --frames N, which says when to take it");
        return EXIT_USAGE;
    }
    viewer.uiScale = (float)uiScale;
    viewer.debug = debug.mode;
    viewer.showSheet = debug.isSheet;
    viewer.sheet = debug.sheet;
    viewer.scenePath = scenePath;
    viewer.width = size.width;
    viewer.height = size.height;
    viewer.device = device.choice;
    viewer.deviceIndex = device.index;
    viewer.enableVsync = !disableVsync;
    return RunViewer(&viewer);
}
