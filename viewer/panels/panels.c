// SPDX-License-Identifier: MIT
#include "panels.h"

float ToDegrees(float radians)
{
    return radians * (float)(180.0 / SW_PI);
}

float ToBearing(float direction)
{
    return ShowValue(&(Knob){.isBearing = true}, direction);
}

// How many values differ from the file's, and the way back.
static void DrawChanges(App* app)
{
    if (app->changeCount == 0)
    {
        return;
    }
    UiWarning("%d value%s from %s.", app->changeCount, app->changeCount == 1 ? " differs" : "s differ",
              GetSceneName(app));
    if (UiButton("all as in the file") && !ResetChanges(&app->sea))
    {
        ShowNote(app, "not all came back; see Messages");
    }
    UiTip("Each changed value has a dot beside its name: click on it to set that one back");
}

static void DrawPace(const App* app)
{
    if (IsSeaSlow(&app->pace))
    {
        UiWarning("The sea runs at %.2g x of the clock: frames take %.0f ms.", (double)app->pace.ratio,
                  (double)app->pace.frameMs);
    }
}

static void DrawSummary(App* app)
{
    const Sea* sea = &app->sea;
    double seaLevel = swWorld_GetSeaLevel(sea->world);
    UiText("Hs %.2f m asked, %.2f m in the bands", (double)GetAskedHeight(sea), (double)GetCarriedHeight(sea));
    UiText("Water here %+.2f m, eye %.1f m above it", app->waterHeight - seaLevel,
           GetCameraEye(&app->camera).y - app->waterHeight);
}

void DrawPanels(App* app)
{
    BeginUiPanel("Seaway (F1)");
    DrawSummary(app);
    DrawPace(app);
    DrawMessagePanel(app);
    DrawChanges(app);
    DrawTimePanel(app);
    DrawSeaPanel(app);
    DrawSkyPanel(app);
    DrawViewPanel(app);
    DrawTimingPanel(app);
    DrawKeyPanel();
    EndUiPanel();
}
