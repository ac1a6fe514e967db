// SPDX-License-Identifier: MIT
// The scene that is open: reading it, following its file, its views, and what is asked before changes are dropped.

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app.h"
#include "save.h"
#include "text.h"
#include "tuning.h"

#define STAMP_INTERVAL 0.5 // s between looks at the scene file

// A view may bring a sun of its own, which counts as the file's from then on; a sun that the user has moved stays.
static void PlaceSun(Sea* sea, const swSceneView* view)
{
    swSkyDef from = swScene_GetSky(sea->scene, view);
    swSkyDef *sky = &sea->look.sky, *filed = &sea->filedLook.sky;
    if (sky->sunAzimuth == filed->sunAzimuth && sky->sunElevation == filed->sunElevation)
    {
        sky->sunAzimuth = from.sunAzimuth;
        sky->sunElevation = from.sunElevation;
    }
    filed->sunAzimuth = from.sunAzimuth;
    filed->sunElevation = from.sunElevation;
}

static void PlaceInView(App* app, const swSceneView* view)
{
    PlaceSun(&app->sea, view);
    PlaceCamera(&app->camera, view, swWorld_GetSeaLevel(app->sea.world));
    swPosXZ origin = swWorld_GetOrigin(app->sea.world); // views are places in the sea
    ShiftCamera(&app->camera, -origin.x, -origin.z);
    app->jumpExposure = true;
}

void GoToView(App* app, int index)
{
    const swScene* scene = app->sea.scene;
    if (scene == NULL || index >= scene->viewCount)
    {
        ShowNote(app, "the scene has no view %d", index + 1);
        return;
    }
    PlaceInView(app, &scene->views[index]);
    ShowNote(app, "view: %s", scene->views[index].name);
}

static int64_t GetSceneStamp(const App* app)
{
    struct stat status;
    if (app->options.scenePath == NULL || stat(app->options.scenePath, &status) != 0)
    {
        return 0;
    }
    return (int64_t)status.st_mtim.tv_sec * 1000000000 + status.st_mtim.tv_nsec;
}

const char* GetSceneName(const App* app)
{
    const char* path = app->options.scenePath;
    const char* slash = path != NULL ? strrchr(path, '/') : NULL;
    return path == NULL ? "the open sea's own" : slash != NULL ? slash + 1 : path;
}

void UpdateTitle(App* app)
{
    char title[sizeof(app->title)], pace[64] = "";
    if (IsSeaSlow(&app->pace))
    {
        snprintf(pace, sizeof(pace), " (the sea runs at %.2g x of the clock)", (double)app->pace.ratio);
    }
    snprintf(title, sizeof(title), "Seaway: %s%s%s", app->sea.name, app->changeCount > 0 ? " *" : "", pace);
    if (strcmp(title, app->title) != 0)
    {
        snprintf(app->title, sizeof(app->title), "%s", title);
        glfwSetWindowTitle(app->window, title);
    }
}

static bool OpenLand(App* app)
{
    swStageTerrainDef def = swDefaultStageTerrainDef();
    def.world = app->sea.world;
    app->landVersion = app->sea.floorVersion;
    return swStage_CreateTerrain(app->stage, &def, &app->land) == SW_SUCCESS;
}

void ForgetLand(App* app)
{
    app->landVersion = app->sea.floorVersion;
    app->landAge = 0.0;
    if (app->land != NULL)
    {
        swStageTerrain_Refresh(app->land);
    }
}

bool OpenFirstSea(App* app)
{
    app->sceneStamp = GetSceneStamp(app);
    if (!OpenSea(&app->sea, &app->host, app->gpu, app->screen.extent.height, app->options.scenePath))
    {
        return false;
    }
    if (!OpenLand(app))
    {
        return false;
    }
    app->clock.time = app->sea.scene ? app->sea.scene->time : 0.0;
    app->camera = DefaultCamera(swWorld_GetSeaLevel(app->sea.world));
    const swSceneView* view = app->sea.scene ? swScene_FindView(app->sea.scene, app->options.viewName) : NULL;
    if (view != NULL)
    {
        PlaceInView(app, view);
    }
    else if (app->options.viewName != NULL)
    {
        char name[256];
        fprintf(stderr, "seaway: the scene has no view named \"%s\"\n",
                CopyPrintable(name, sizeof(name), app->options.viewName));
        return false;
    }
    return true;
}

// A scene that cannot be read leaves the sea as it is; the log, which the panel shows, says why.
static void ReloadSea(App* app)
{
    Sea fresh;
    app->sceneStamp = GetSceneStamp(app);
    app->messagesBefore = CountMessages(&app->messages);
    app->hasSceneFailed = !OpenSea(&fresh, &app->host, app->gpu, app->screen.extent.height, app->options.scenePath);
    if (app->hasSceneFailed)
    {
        ShowNote(app, "the scene has an error; see the panel");
        return;
    }
    fresh.transition = app->sea.transition;
    swWorld_SetTime(fresh.world, app->clock.time);
    swWorld_SetOrigin(fresh.world, swWorld_GetOrigin(app->sea.world));
    swStage_Wait(app->stage);
    swStage_DestroyTerrain(app->stage, app->land);
    CloseSea(&app->sea);
    app->sea = fresh;
    if (!OpenLand(app))
    {
        app->land = NULL; // the log says why; the sea goes on without
    }
    app->jumpExposure = true;
    ShowNote(app, "scene read");
}

// The file is read again at once: then it is the file's values that stand.
void SaveScene(App* app)
{
    char made[64] = "";
    const char* path = app->options.scenePath;
    if (path == NULL && !NameScene(made, sizeof(made)))
    {
        ShowNote(app, "not saved: seaway_0001.yaml to seaway_9999.yaml are all there");
        return;
    }
    if (path != NULL && GetSceneStamp(app) != app->sceneStamp)
    {
        ShowNote(app, "not saved: the file has changed on disk; read it, or answer that yours is kept");
        return;
    }
    app->messagesBefore = CountMessages(&app->messages);
    if (SaveSea(&app->sea, path, path != NULL ? path : made) != SW_SUCCESS)
    {
        ShowNote(app, "not saved; see Messages");
        return;
    }
    if (path != NULL)
    {
        app->question = ASKED_NOTHING;
        ReloadSea(app);
    }
    if (!app->hasSceneFailed)
    {
        ShowNote(app, "saved to %s", path != NULL ? GetSceneName(app) : made);
    }
}

// Changes that a user could lose; nobody is there to be asked where frames are counted.
static int CountAskedChanges(const App* app)
{
    return app->options.frameCount > 0 ? 0 : app->changeCount;
}

void WishReload(App* app)
{
    // Where the question is about the changed file, the user has answered it.
    Asked wish = app->question == ASKED_FOLLOW_FILE ? ASKED_FOLLOW_FILE : ASKED_RELOAD;
    if (MayProceed(&app->question, wish, CountAskedChanges(app)))
    {
        ReloadSea(app);
    }
}

void WishQuit(App* app)
{
    if (MayProceed(&app->question, ASKED_QUIT, CountAskedChanges(app)))
    {
        glfwSetWindowShouldClose(app->window, GLFW_TRUE);
    }
}

void FollowSceneFile(App* app)
{
    double now = glfwGetTime();
    if (now < app->nextStampCheck)
    {
        return;
    }
    app->nextStampCheck = now + STAMP_INTERVAL;
    int64_t stamp = GetSceneStamp(app);
    bool isAsked = app->question == ASKED_FOLLOW_FILE && CountAskedChanges(app) > 0;
    if (stamp != 0 && stamp != app->sceneStamp && !isAsked &&
        MayProceed(&app->question, ASKED_FOLLOW_FILE, CountAskedChanges(app)))
    {
        ReloadSea(app);
    }
}

void AskQuestion(App* app)
{
    if (app->question == ASKED_NOTHING)
    {
        return;
    }
    if (app->changeCount == 0)
    {
        app->question = ASKED_NOTHING;
        return;
    }
    char text[300];
    WriteQuestion(app->question, app->changeCount, GetSceneName(app), text, sizeof(text));
    int answer = AskUiQuestion(text, GetYes(app->question), GetNo(app->question));
    if (answer > 0 && app->question == ASKED_QUIT)
    {
        WishQuit(app);
    }
    else if (answer > 0)
    {
        app->wantsReload = true; // between two frames
    }
    else if (answer < 0)
    {
        app->sceneStamp = GetSceneStamp(app);
        app->question = ASKED_NOTHING;
    }
}
