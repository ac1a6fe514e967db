// SPDX-License-Identifier: MIT
#include "app.h"

#include <math.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "screenshot.h"
#include "ui_scale.h"

#define RADIANS_PER_PIXEL 0.0025f

static void ScaleTime(App* app, double factor)
{
    double scale = app->clock.scale * factor;
    app->clock.scale = fabs(scale) < 1.0 / 16.0 || fabs(scale) > 1000.0 ? app->clock.scale : scale;
    ShowNote(app, "time x %.3g", app->clock.scale);
}

static void ToggleFullscreen(App* app)
{
    int* place = app->windowPlace;
    if (glfwGetWindowMonitor(app->window) != NULL)
    {
        glfwSetWindowMonitor(app->window, NULL, place[0], place[1], place[2], place[3], 0);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (mode == NULL)
    {
        ShowNote(app, "there is no monitor to fill");
        return;
    }
    glfwGetWindowPos(app->window, &place[0], &place[1]);
    glfwGetWindowSize(app->window, &place[2], &place[3]);
    glfwSetWindowMonitor(app->window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

static void CycleDebug(App* app, int by)
{
    app->debug = (swDebugMode)(((int)app->debug + by + SW_DEBUG_COUNT) % SW_DEBUG_COUNT);
    ShowNote(app, "view: %s", swDebugMode_GetName(app->debug));
}

static void TogglePause(App* app)
{
    app->clock.isPaused = !app->clock.isPaused;
    ShowNote(app, app->clock.isPaused ? "paused" : "running");
}

static void ScaleUi(App* app, float factor)
{
    app->uiFactor = factor;
    app->showPanel = true;
    ShowNote(app, "panel x %.2f", (double)factor);
}

static void PressKey(App* app, int key, int modifiers)
{
    bool hasShift = (modifiers & GLFW_MOD_SHIFT) != 0;
    if ((modifiers & GLFW_MOD_CONTROL) != 0)
    {
        app->wantsSave = app->wantsSave || key == GLFW_KEY_S;
        return;
    }
    switch (key)
    {
    case GLFW_KEY_ESCAPE:
        WishQuit(app);
        break;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
        ScaleUi(app, StepUiFactor(app->uiFactor, -1));
        break;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
        ScaleUi(app, StepUiFactor(app->uiFactor, 1));
        break;
    case GLFW_KEY_0:
        ScaleUi(app, 1.0f);
        break;
    case GLFW_KEY_SPACE:
        TogglePause(app);
        break;
    case GLFW_KEY_PERIOD:
        app->clock.isPaused = true;
        app->stepOnce = true;
        break;
    case GLFW_KEY_LEFT_BRACKET:
        ScaleTime(app, 0.5);
        break;
    case GLFW_KEY_RIGHT_BRACKET:
        ScaleTime(app, 2.0);
        break;
    case GLFW_KEY_O:
        ToggleOrbit(&app->camera, swWorld_GetSeaLevel(app->sea.world));
        ShowNote(app, app->camera.mode == CAMERA_ORBIT ? "orbiting" : "flying");
        break;
    case GLFW_KEY_U:
        app->camera.mayDive = !app->camera.mayDive;
        ShowNote(app, app->camera.mayDive ? "the camera may go under the water" : "the camera stays above the water");
        break;
    case GLFW_KEY_R:
        WishReload(app);
        break;
    case GLFW_KEY_F1:
        app->showPanel = !app->showPanel;
        break;
    case GLFW_KEY_F2:
        CycleDebug(app, hasShift ? -1 : 1);
        break;
    case GLFW_KEY_F3:
        app->sheetView.isShown = !app->sheetView.isShown;
        ShowNote(app, app->sheetView.isShown ? "layer: %s" : "the picture", swLayer_GetName(app->sheetView.def.layer));
        break;
    case GLFW_KEY_F11:
        ToggleFullscreen(app);
        break;
    case GLFW_KEY_F12:
        if (NameScreenshot(app->capturePath, sizeof(app->capturePath)))
        {
            app->capture = hasShift ? CAPTURE_WINDOW : CAPTURE_SEA;
        }
        else
        {
            ShowNote(app, "no screenshot: seaway_0001.png to seaway_9999.png are all there");
        }
        break;
    default:
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9)
        {
            GoToView(app, key - GLFW_KEY_1);
        }
        break;
    }
}

static void OnKey(GLFWwindow* window, int key, int scancode, int action, int modifiers)
{
    App* app = glfwGetWindowUserPointer(window);
    if (action != GLFW_REPEAT) // the panel repeats by itself
    {
        PushInput(&app->input,
                  (InputEvent){
                      .kind = INPUT_KEY, .code = key, .scancode = scancode, .action = action, .modifiers = modifiers});
    }
}

static void OnLetter(GLFWwindow* window, unsigned codePoint)
{
    App* app = glfwGetWindowUserPointer(window);
    PushInput(&app->input, (InputEvent){.kind = INPUT_LETTER, .code = (int)codePoint});
}

static void OnButton(GLFWwindow* window, int button, int action, int modifiers)
{
    App* app = glfwGetWindowUserPointer(window);
    InputEvent event = {.kind = INPUT_BUTTON, .code = button, .action = action, .modifiers = modifiers};
    glfwGetCursorPos(window, &event.x, &event.y);
    PushInput(&app->input, event);
}

static void OnScroll(GLFWwindow* window, double x, double y)
{
    App* app = glfwGetWindowUserPointer(window);
    PushInput(&app->input, (InputEvent){.kind = INPUT_WHEEL, .x = x, .y = y});
}

static void OnFocus(GLFWwindow* window, int isFocused)
{
    const App* app = glfwGetWindowUserPointer(window);
    if (app->hasUi)
    {
        FeedUiFocus(window, isFocused != 0);
    }
}

static void OnEntry(GLFWwindow* window, int isInside)
{
    const App* app = glfwGetWindowUserPointer(window);
    if (app->hasUi)
    {
        FeedUiEntry(window, isInside != 0);
    }
}

static void OnClose(GLFWwindow* window)
{
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    WishQuit(glfwGetWindowUserPointer(window));
}

void OpenInput(App* app)
{
    glfwSetWindowUserPointer(app->window, app);
    glfwSetKeyCallback(app->window, OnKey);
    glfwSetCharCallback(app->window, OnLetter);
    glfwSetMouseButtonCallback(app->window, OnButton);
    glfwSetScrollCallback(app->window, OnScroll);
    glfwSetWindowFocusCallback(app->window, OnFocus);
    glfwSetCursorEnterCallback(app->window, OnEntry);
    glfwSetWindowCloseCallback(app->window, OnClose);
}

void HandleInput(App* app)
{
    InputEvent batch[MAX_INPUT_EVENTS];
    int count = TakeInput(&app->input, batch);
    bool hasKeyboard = HasUiKeyboard(), hasMouse = HasUiMouse();
    for (int i = 0; i < count; i++)
    {
        const InputEvent* event = &batch[i];
        FeedUi(app->window, event);
        if (event->kind == INPUT_KEY && event->action == GLFW_PRESS && !hasKeyboard)
        {
            PressKey(app, event->code, event->modifiers);
        }
        if (event->kind == INPUT_WHEEL && !hasMouse)
        {
            app->wheel += (float)event->y;
        }
    }
}

static float GetAxis(GLFWwindow* window, int positive, int negative)
{
    return (float)(glfwGetKey(window, positive) == GLFW_PRESS) - (float)(glfwGetKey(window, negative) == GLFW_PRESS);
}

// Looking starts on the picture, not on a widget, and goes on until the button is released.
static void UpdateLooking(App* app)
{
    bool isHeld =
        glfwGetMouseButton(app->window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS ||
        (app->camera.mode == CAMERA_ORBIT && glfwGetMouseButton(app->window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS);
    bool isLooking = isHeld && (app->isLooking || !HasUiMouse());
    if (isLooking != app->isLooking)
    {
        app->isLooking = isLooking;
        glfwSetInputMode(app->window, GLFW_CURSOR, isLooking ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        glfwGetCursorPos(app->window, &app->cursorX, &app->cursorY);
    }
}

CameraInput ReadCameraInput(App* app)
{
    GLFWwindow* window = app->window;
    CameraInput input = {.wheel = app->wheel};
    app->wheel = 0.0f;
    UpdateLooking(app);
    bool isCommand = glfwGetKey(window, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS ||
                     glfwGetKey(window, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS; // Ctrl+S does not fly backwards
    if (!HasUiKeyboard() && !isCommand)
    {
        input.right = GetAxis(window, GLFW_KEY_D, GLFW_KEY_A);
        input.up = GetAxis(window, GLFW_KEY_E, GLFW_KEY_Q);
        input.forward = GetAxis(window, GLFW_KEY_W, GLFW_KEY_S);
        input.isFast = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                       glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
    }
    if (app->isLooking)
    {
        double x = 0.0, y = 0.0;
        glfwGetCursorPos(window, &x, &y);
        input.turnRight = (float)(x - app->cursorX) * RADIANS_PER_PIXEL;
        input.turnUp = (float)(app->cursorY - y) * RADIANS_PER_PIXEL;
        app->cursorX = x;
        app->cursorY = y;
    }
    return input;
}
