// SPDX-License-Identifier: MIT
// The viewer's life: open, frame after frame, close.

#include "viewer.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app.h"
#include "panels/panels.h"
#include "screenshot.h"
#include "tuning.h"
#include "ui_scale.h"

#define TEST_STEP (1.0 / 30.0) // s of the sea per frame when frames are counted
#define LONGEST_STEP 0.25      // a frame that took longer slows the sea instead of making it jump
#define LAND_AGE 0.5           // s after which land whose floor moves is sampled anew
#define NEAR_ORIGIN 4096.0     // m from the host's origin that the camera may be
#define MAX_WORKERS 15

ViewerOptions DefaultViewerOptions(void)
{
    return (ViewerOptions){.device = SW_DEVICE_AUTO,
                           .width = 1280,
                           .height = 720,
                           .enableVsync = true,
                           .uiScale = 1.0f,
                           .sheet = swDefaultSheetDef()};
}

void ShowNote(App* app, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(app->note, sizeof(app->note), format, arguments);
    va_end(arguments);
    app->noteUntil = glfwGetTime() + 3.0;
}

static const char* GetGlfwError(void)
{
    const char* text = NULL;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

static bool OpenWindow(App* app)
{
    const ViewerOptions* options = &app->options;
    if (!glfwInit())
    {
        fprintf(stderr, "seaway: there is no display to open a window on (%s); `seaway render` needs none\n",
                GetGlfwError());
        return false;
    }
    if (!glfwVulkanSupported())
    {
        fprintf(stderr, "seaway: no Vulkan loader or driver that can show a window was found (%s)\n", GetGlfwError());
        return false;
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWmonitor* monitor = options->isFullscreen ? glfwGetPrimaryMonitor() : NULL;
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    app->windowPlace[0] = 60;
    app->windowPlace[1] = 60;
    app->windowPlace[2] = options->width;
    app->windowPlace[3] = options->height;
    app->window = glfwCreateWindow(mode ? mode->width : options->width, mode ? mode->height : options->height, "Seaway",
                                   monitor, NULL);
    if (app->window == NULL)
    {
        fprintf(stderr, "seaway: a window of %d x %d could not be opened (%s)\n", options->width, options->height,
                GetGlfwError());
        return false;
    }
    OpenInput(app);
    return true;
}

static void OpenHost(App* app)
{
    OpenMessages(&app->messages);
    app->host = swDefaultHost();
    app->host.log = WriteMessage;
    app->host.logContext = &app->messages;
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    int workers = cores < 1 ? 0 : cores > MAX_WORKERS ? MAX_WORKERS : (int)cores - 1;
    if (swCreateTaskPool(&app->host, workers, &app->pool) == SW_SUCCESS)
    {
        swTaskPool_Attach(app->pool, &app->host);
    }
}

static bool OpenDevice(App* app)
{
    swGpuDef def = swDefaultGpuDef();
    def.choice = app->options.device;
    def.deviceIndex = app->options.deviceIndex;
    def.enableValidation = app->options.enableValidation;
    def.framesInFlight = FRAMES_IN_FLIGHT;
    def.presentable = true;
    def.instanceExtensions = glfwGetRequiredInstanceExtensions(&def.instanceExtensionCount);
    if (swCreateStage(&app->host, &def, &app->stage) != SW_SUCCESS)
    {
        return false; // the log has named each device and what it lacks
    }
    app->gpu = swStage_GetGpu(app->stage);
    return OpenScreen(&app->screen, app->stage, app->window, app->options.enableVsync);
}

static bool OpenPanel(App* app)
{
    app->hasUi = OpenUi(app->window);
    return app->hasUi && OpenUiDrawer(&app->drawer, app->stage, PICTURE_FORMAT);
}

static void RecordFrameTime(FrameTimes* times, double seconds)
{
    times->milliseconds[times->next] = (float)(seconds * 1e3);
    times->next = (times->next + 1) % FRAME_TIME_COUNT;
}

// Seconds since the last frame, as the camera moves by them.
static double TakeFrameTime(App* app)
{
    double now = glfwGetTime();
    double passed = now - app->frameTimes.last;
    app->frameTimes.last = now;
    app->wallPassed = passed;
    RecordFrameTime(&app->frameTimes, passed);
    if (app->options.frameCount > 0)
    {
        return TEST_STEP;
    }
    return passed < LONGEST_STEP ? passed : LONGEST_STEP;
}

static double AdvanceTime(App* app, double passed)
{
    swClock* clock = &app->clock;
    if (app->stepOnce || clock->isPaused || app->options.frameCount > 0)
    {
        ForgetPace(&app->pace);
    }
    if (app->stepOnce)
    {
        app->stepOnce = false;
        return swClock_StepOnce(clock);
    }
    double before = clock->time, after = swClock_Advance(clock, passed);
    if (!clock->isPaused && app->options.frameCount == 0)
    {
        MeasurePace(&app->pace, app->wallPassed, clock->scale, after - before);
    }
    return after;
}

// Coordinates move along with the camera, as those of a game do: none is ever far from 0, and the sea does not notice.
static void KeepOriginNear(App* app)
{
    Camera* camera = &app->camera;
    if (fabs(camera->position.x) < NEAR_ORIGIN && fabs(camera->position.z) < NEAR_ORIGIN)
    {
        return;
    }
    swPosXZ origin = swWorld_GetOrigin(app->sea.world);
    double x = floor(camera->position.x), z = floor(camera->position.z);
    swWorld_SetOrigin(app->sea.world, (swPosXZ){origin.x + x, origin.z + z});
    ShiftCamera(camera, -x, -z);
    ForgetLand(app);
}

static bool StepSea(App* app, double passed)
{
    CameraInput input = ReadCameraInput(app);
    MoveCamera(&app->camera, &input, passed, swWorld_GetSeaLevel(app->sea.world));
    KeepOriginNear(app);
    swView_SetViewpoint(app->sea.view, GetCameraEye(&app->camera));
    ApplyChanges(&app->sea, app->clock.isPaused);
    double time = AdvanceTime(app, passed);
    if (!AdvanceSea(&app->sea, time) || swWorld_StepTo(app->sea.world, time) != SW_SUCCESS)
    {
        return false;
    }
    app->landAge += app->wallPassed;
    bool isLate = app->sea.movesFloor && !app->clock.isPaused && app->landAge > LAND_AGE;
    if (app->landVersion != app->sea.floorVersion || isLate)
    {
        ForgetLand(app);
    }
    app->waterHeight =
        swMoment_GetHeight(swWorld_GetMoment(app->sea.world), app->camera.position.x, app->camera.position.z);
    KeepCameraDry(&app->camera, app->waterHeight);
    return true;
}

static void BuildPanel(App* app)
{
    SetUiScale(ChooseUiScale((float)app->screen.windowExtent.width, (float)app->screen.windowExtent.height,
                             GetUiDensity(app->window), app->uiFactor));
    HandleInput(app);
    BeginUiFrame();
    if (app->showPanel)
    {
        DrawPanels(app);
    }
    AskQuestion(app);
    if (glfwGetTime() < app->noteUntil)
    {
        ShowUiNote(app->note);
    }
    EndUiFrame(&app->mesh);
}

static bool SaveCapture(App* app)
{
    swStage_Wait(app->stage);
    const swStageImage* picture = &app->targets.stage.output;
    char reason[600];
    bool isWritten = WriteScreenshot(app->capturePath, app->targets.readback.data, picture->width, picture->height,
                                     reason, sizeof(reason));
    if (isWritten)
    {
        ShowNote(app, "saved %s", app->capturePath);
    }
    else
    {
        WriteMessage(&app->messages, SW_LOG_ERROR, reason);
        ShowNote(app, "%s", reason);
    }
    app->capture = CAPTURE_NONE;
    return isWritten;
}

static bool IsLastFrame(const App* app)
{
    return app->options.frameCount > 0 && app->frameIndex + 1 >= (uint64_t)app->options.frameCount;
}

static PictureDef DescribePicture(App* app, const swStageFrame* frame, double passed)
{
    const Sea* sea = &app->sea;
    return (PictureDef){
        .stage = app->stage,
        .screen = &app->screen,
        .targets = &app->targets,
        .sea = &app->sea,
        .land = app->land,
        .sheet = &app->sheetView,
        .lines = app->lines,
        .marks = app->marks,
        .drawer = &app->drawer,
        .mesh = &app->mesh,
        .shot =
            {
                .view = sea->view,
                .camera = MakePictureCamera(&app->camera, app->targets.stage.hdr.width, app->targets.stage.hdr.height),
                .sky = sea->look.sky,
                .water = sea->look.water,
                .debug = app->debug,
                .time = swWorld_GetTime(sea->world),
                .exposureEv = sea->look.exposureEv,
                .bodyWaters = sea->scene != NULL ? sea->scene->looks : NULL,
                .bodyWaterCount = sea->scene != NULL ? sea->scene->lookCount : 0,
            },
        .frame = *frame,
        .dt = (float)passed,
        .jumpExposure = app->jumpExposure,
        .capture = app->capture,
    };
}

// Where the mouse is in the picture. A widget that has it comes first.
static void FindPointer(App* app)
{
    int isHovered = glfwGetWindowAttrib(app->window, GLFW_HOVERED);
    glfwGetCursorPos(app->window, &app->pointerX, &app->pointerY);
    app->pointerX *= (double)app->screen.extent.width / app->screen.windowExtent.width;
    app->pointerY *= (double)app->screen.extent.height / app->screen.windowExtent.height;
    app->isPointerFree = isHovered != 0 && !app->isLooking && !HasUiMouse();
}

// The layer as the last frame left it.
static void ReadSheet(App* app)
{
    SheetView* view = &app->sheetView;
    view->isRead = false;
    if (!view->isShown || !app->sea.hasRecorded)
    {
        return;
    }
    float left = app->showPanel ? GetUiPanelRight() : 0.0f;
    VkExtent2D extent = app->screen.extent;
    int x = (int)ceil((double)left * extent.width / app->screen.windowExtent.width);
    if (!UpdateSheetView(view, &app->host, app->stage, app->sea.gpuWorld, app->sea.view, x, (int)extent.width,
                         (int)extent.height))
    {
        view->isShown = false;
        ShowNote(app, "the layer could not be read; see Messages");
    }
}

// One frame into the image that was acquired.
static bool MakeFrame(App* app, const swStageFrame* frame)
{
    double passed = TakeFrameTime(app);
    FindPointer(app);
    ReadSheet(app);
    BuildPanel(app);
    app->changeCount = CountChanges(&app->sea);
    UpdateTitle(app);
    if (!StepSea(app, passed))
    {
        return false;
    }
    bool isLast = IsLastFrame(app);
    if (isLast && app->options.screenshotPath != NULL)
    {
        snprintf(app->capturePath, sizeof(app->capturePath), "%s", app->options.screenshotPath);
        app->capture = CAPTURE_WINDOW;
    }
    if (app->marks != 0 && app->lines == NULL && swStage_CreateLines(app->stage, &app->lines) != SW_SUCCESS)
    {
        app->marks = 0; // the log says why
    }
    PictureDef picture = DescribePicture(app, frame, passed);
    app->jumpExposure = app->frameIndex == 0;
    if (!RecordPicture(&picture) || EndScreenFrame(&app->screen, frame) == SCREEN_FAILED)
    {
        return false;
    }
    bool isSaved = app->capture == CAPTURE_NONE || SaveCapture(app);
    app->frameIndex++;
    if (isLast)
    {
        glfwSetWindowShouldClose(app->window, GLFW_TRUE);
    }
    return isSaved || !isLast;
}

// Targets follow the window's size.
static bool FitTargets(App* app)
{
    VkExtent2D extent = app->screen.extent;
    if (extent.width == app->targets.stage.output.width && extent.height == app->targets.stage.output.height)
    {
        return true;
    }
    if (swStage_Wait(app->stage) != SW_SUCCESS)
    {
        return false;
    }
    CloseTargets(&app->targets, app->stage);
    return OpenTargets(&app->targets, app->stage, extent, DrawnExtent(extent, swGpu_IsSoftware(app->gpu)));
}

static bool RunFrames(App* app)
{
    while (!glfwWindowShouldClose(app->window))
    {
        glfwPollEvents();
        FollowSceneFile(app);
        if (app->wantsSave)
        {
            app->wantsSave = false;
            SaveScene(app);
        }
        if (app->wantsReload)
        {
            app->wantsReload = false;
            WishReload(app);
        }
        swStageFrame frame;
        switch (BeginScreenFrame(&app->screen, &frame))
        {
        case SCREEN_READY:
            if (!FitTargets(app) || !MakeFrame(app, &frame))
            {
                return false;
            }
            break;
        case SCREEN_HIDDEN:
            glfwWaitEventsTimeout(0.2);
            app->frameTimes.last = glfwGetTime();
            break;
        case SCREEN_CHANGED:
            break;
        case SCREEN_FAILED:
            return false;
        }
    }
    return true;
}

static bool OpenApp(App* app)
{
    OpenHost(app);
    app->clock = swDefaultClock();
    app->showPanel = !app->options.hidePanel;
    app->uiFactor = app->options.uiScale;
    app->debug = app->options.debug;
    app->sheetView.isShown = app->options.showSheet;
    app->sheetView.def = app->options.sheet;
    app->jumpExposure = true;
    if (!OpenWindow(app) || !OpenDevice(app) || !OpenPanel(app) || !OpenFirstSea(app))
    {
        return false;
    }
    app->frameTimes.last = glfwGetTime();
    return true;
}

static void CloseApp(App* app)
{
    if (app->stage != NULL)
    {
        swStage_GetVk(app->stage)->DeviceWaitIdle(swGpu_GetDevice(app->gpu));
        swStage_DestroyTerrain(app->stage, app->land);
        CloseSea(&app->sea);
        swStage_DestroyLines(app->stage, app->lines);
        CloseSheetView(&app->sheetView, app->stage);
        CloseUiDrawer(&app->drawer);
        CloseTargets(&app->targets, app->stage);
        CloseScreen(&app->screen);
    }
    if (app->hasUi)
    {
        CloseUi();
    }
    swDestroyStage(app->stage);
    if (app->window != NULL)
    {
        glfwDestroyWindow(app->window);
    }
    glfwTerminate();
    swDestroyTaskPool(app->pool);
    CloseMessages(&app->messages);
}

int RunViewer(const ViewerOptions* options)
{
    App* app = calloc(1, sizeof(App));
    if (app == NULL)
    {
        fprintf(stderr, "seaway: out of memory\n");
        return 1;
    }
    app->options = *options;
    bool isGood = OpenApp(app) && RunFrames(app);
    int problems = app->gpu != NULL && options->enableValidation ? swGpu_GetValidationCount(app->gpu) : 0;
    if (problems > 0)
    {
        fprintf(stderr, "seaway: the validation layers had %d message%s\n", problems, problems == 1 ? "" : "s");
    }
    CloseApp(app);
    free(app);
    return isGood && problems == 0 ? 0 : 1;
}
