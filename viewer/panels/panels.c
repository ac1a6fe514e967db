// SPDX-License-Identifier: MIT
#include "panels.h"

#include <math.h>

float ToDegrees(float radians)
{
    return radians * (float)(180.0 / SW_PI);
}

float ToRadians(float degrees)
{
    return degrees * (float)(SW_PI / 180.0);
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
    DrawMessagePanel(app);
    DrawTimePanel(app);
    DrawSeaPanel(app);
    DrawSkyPanel(app);
    DrawViewPanel(app);
    DrawTimingPanel(app);
    DrawKeyPanel();
    EndUiPanel();
}
