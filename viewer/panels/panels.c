// SPDX-License-Identifier: MIT
#include "panels.h"

// These lines are always there, so that nothing below them moves when they have something to say.
static void DrawChanges(App* app)
{
    if (app->changeCount == 0)
    {
        UiFaint("As in %s", GetSceneName(app));
        return;
    }
    app->wantsSave = UiSmallButton("save") || app->wantsSave;
    UiTip("Write what was changed into the scene file (Ctrl+S); the rest of it stays as it is");
    UiSameLine();
    if (UiSmallButton("reset") && !ResetChanges(&app->sea))
    {
        ShowNote(app, "not all came back; see Messages");
    }
    UiTip("Everything as in the file. A dot beside a name sets that value back alone.");
    UiSameLine();
    UiMarked("%d change%s from %s", app->changeCount, app->changeCount == 1 ? "" : "s", GetSceneName(app));
}

static void DrawPace(const App* app)
{
    if (IsSeaSlow(&app->pace))
    {
        UiMarked("Sea at %.2g x the clock, %.0f ms a frame", (double)app->pace.ratio, (double)app->pace.frameMs);
        UiTip("Frames take longer than the sea may advance at once, so it runs slower than the clock");
    }
    else if (app->options.frameCount > 0)
    {
        UiFaint("Frames are counted, 1/30 s of the sea each");
    }
    else
    {
        UiFaint("%s", app->clock.isPaused       ? "The sea is paused"
                      : app->pace.ratio == 0.0f ? "Sea and clock are being compared"
                                                : "The sea keeps up with the clock");
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
    DrawChanges(app);
    DrawMessagePanel(app);
    DrawTimePanel(app);
    DrawSeaPanel(app);
    DrawInputPanel(app);
    DrawSkyPanel(app);
    DrawViewPanel(app);
    DrawLayerPanel(app);
    DrawTimingPanel(app);
    DrawKeyPanel();
    EndUiPanel();
}
