// SPDX-License-Identifier: MIT
// Sun and air, the look of the water, and foam.

#include "panels.h"

static void DrawFoam(App* app)
{
    swFoamDef* foam = &app->sea.look.foam;
    swFoamState state = swWorld_GetFoamState(app->sea.world);
    UiFaint("%.1f m/s of wind cover %.2g %%", (double)state.windSpeed, 100.0 * (double)state.cover);
    if (TurnFields(swGetFoamFields(), foam, &app->sea.filedLook.foam))
    {
        swWorld_SetFoam(app->sea.world, foam);
    }
}

void DrawSkyPanel(App* app)
{
    SeaLook *look = &app->sea.look, *filed = &app->sea.filedLook;
    if (BeginUiSection("Foam", false))
    {
        DrawFoam(app);
    }
    if (BeginUiSection("Sun and air", true))
    {
        TurnFields(swGetSkyFields(), &look->sky, &filed->sky);
        TurnValue(swFields_Find(swGetSceneFields(), "exposureEv"), NULL, &look->exposureEv, &filed->exposureEv);
    }
    if (BeginUiSection("Water", false))
    {
        TurnFields(swGetWaterFields(), &look->water, &filed->water);
    }
}
