// SPDX-License-Identifier: MIT
#pragma once

// Everything that the running viewer holds. The panels read and change it.

#include "camera.h"
#include "input_queue.h"
#include "messages.h"
#include "pace.h"
#include "picture.h"
#include "pointer.h"
#include "question.h"
#include "viewer.h"

#define FRAME_TIME_COUNT 180

// How long frames take.
typedef struct FrameTimes
{
    double last;                          // when the last frame began, s of the window's clock
    float milliseconds[FRAME_TIME_COUNT]; // a ring
    int next;
} FrameTimes;

typedef struct App
{
    ViewerOptions options;
    Messages messages;
    swHost host;
    swTaskPool* pool;

    struct GLFWwindow* window;
    bool hasUi;
    swStage* stage;
    swGpu* gpu; // of the stage
    Screen screen;
    Targets targets;
    UiDrawer drawer;
    UiMesh mesh;

    Sea sea;
    swStageLines* lines;  // over the picture; NULL until something is to be seen by them
    uint32_t marks;       // what: bits of swStageMarks
    swStageTerrain* land; // of the sea's world
    int landVersion;      // of the sea's floor that it was sampled from
    double landAge;       // s since then, of the clock on the wall
    int64_t sceneStamp;   // when the scene file was last written
    double nextStampCheck;
    bool wantsReload;    // with the next frame
    bool wantsSave;      // likewise
    bool hasSceneFailed; // the last reload; the sea before it is still shown
    int messagesBefore;  // how many there were when it began
    Asked question;      // that stands
    int changeCount;     // values that differ from the file's

    swClock clock; // the sea's
    bool stepOnce; // one step on, also while paused
    FrameTimes frameTimes;
    double wallPassed; // s that the last frame took
    Pace pace;
    Camera camera;
    double waterHeight; // under the camera, m
    float wheel;        // clicks since the last frame
    double cursorX, cursorY;
    InputQueue input;
    bool isLooking; // the mouse turns the camera

    int chosenInput, chosenBody; // of the panel
    int newField;                // swInputField of the next one that is added
    swDebugMode debug;
    SheetView sheetView;
    double pointerX, pointerY; // of the mouse, pixels of the window
    bool isPointerFree;        // it is over the picture
    bool showPanel;
    float uiFactor; // on the size of letters and panel that suits the window
    bool jumpExposure;
    char title[256];
    int windowPlace[4]; // x, y, width, height before full screen
    CaptureStage capture;
    char capturePath[4096];
    char note[600];
    double noteUntil;
    uint64_t frameIndex; // frames shown so far
} App;

// A line over the picture for a few seconds.
void ShowNote(App* app, const char* format, ...);

// document.c: the scene that is open.
void GoToView(App* app, int index);

bool OpenFirstSea(App* app);

// Land and sea floor are sampled again with the next picture: they have changed, or their coordinates have.
void ForgetLand(App* app);

// Read the scene file again when it has changed on disk.
void FollowSceneFile(App* app);

// What the window's frame says: the scene, whether it has changed, and whether the sea lags behind the clock.
void UpdateTitle(App* app);

// Draw the question that stands, if one does, and do what is answered. Inside the panel's frame.
void AskQuestion(App* app);

// Write what was changed into the scene file, or, where there is none, into a new one. Between two frames.
void SaveScene(App* app);

// Read the scene again, or quit; what would drop changes is asked first.
void WishReload(App* app);
void WishQuit(App* app);

// The scene file's name without its folders, or what there is without a file.
const char* GetSceneName(const App* app);

// keys.c: what the keyboard and the mouse do.
void OpenInput(App* app);
CameraInput ReadCameraInput(App* app);

// What was pressed since the last frame, as far as this one can take it: to the panel, and keys that it does not want
// to the viewer. Before BeginUiFrame().
void HandleInput(App* app);
