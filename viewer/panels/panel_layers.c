// SPDX-License-Identifier: MIT
// Layers of the view in place of the picture, and what is under the mouse: of a layer its texel, of the picture the
// water.

#include <math.h>
#include <stdio.h>

#include "panels.h"

static const char* GetLayerName(void* context, int index)
{
    (void)context;
    return swLayer_GetName((swLayer)index);
}

static const char* GetChannelName(void* context, int index)
{
    const swSheetDef* def = context;
    return swLayer_GetChannelName(def->layer, index);
}

static int CountChannels(swLayer layer)
{
    int count = 0;
    while (swLayer_GetChannelName(layer, count) != NULL)
    {
        count++;
    }
    return count;
}

static void DrawLayerChoice(SheetView* view, int sliceCount)
{
    swSheetDef* def = &view->def;
    int layer = (int)def->layer;
    if (UiChoice("layer", &layer, SW_LAYER_COUNT, GetLayerName, NULL))
    {
        swParseSheet(swLayer_GetName((swLayer)layer), def, NULL, 0); // with the channel that it begins with
        view->def.hasRange = false;
    }
    if (UiChoice("channel", &def->channel, CountChannels(def->layer), GetChannelName, def))
    {
        view->def.hasRange = false;
    }
    UiSliderInt("slice", &def->slice, -1, sliceCount - 1, def->slice < 0 ? "all" : "%d");
}

static void DrawRange(SheetView* view)
{
    swSheetInfo info = view->sheet != NULL ? swSheet_GetInfo(view->sheet) : (swSheetInfo){0};
    if (info.sliceCount == 0)
    {
        return;
    }
    UiText("least %.5g, greatest %.5g", (double)info.least, (double)info.greatest);
    bool isAutomatic = !view->def.hasRange;
    if (UiCheckbox("colours from the least to the greatest", &isAutomatic))
    {
        view->def.hasRange = !isAutomatic;
        view->def.low = info.low;
        view->def.high = info.high;
    }
    if (view->def.hasRange)
    {
        float span = fmaxf(info.greatest - info.least, 1e-3f);
        UiSlider("first colour", &view->def.low, fminf(info.least, view->def.low) - span, info.greatest, "%.4g");
        UiSlider("last colour", &view->def.high, info.least, fmaxf(info.greatest, view->def.high) + span, "%.4g");
    }
}

// A place in the sea, whatever coordinates the world has now.
static void DrawTexel(const App* app)
{
    const SheetView* view = &app->sheetView;
    swSheetPick pick;
    if (!view->isRead || !app->isPointerFree ||
        !swSheet_Pick(view->sheet, view->width, view->height, (int)floor(app->pointerX) - view->x,
                      (int)floor(app->pointerY), &pick))
    {
        UiFaint("Point at a slice to read it");
        return;
    }
    swSliceInfo slice = swView_GetSlice(app->sea.view, pick.slice);
    UiText("slice %d: x %.2f  z %.2f m", pick.slice, (double)(slice.firstX + pick.column) * slice.texel,
           (double)(slice.firstZ + pick.row) * slice.texel);
    if (isnan(pick.value))
    {
        UiText("nothing there");
    }
    else
    {
        UiText("%s %.6g", swLayer_GetChannelName(view->def.layer, view->def.channel), (double)pick.value);
    }
}

static const char* NameBody(const App* app, int number)
{
    static char name[SW_MAX_INPUT_NAME];
    swWaterBodyId id = swWorld_GetNumberedWaterBody(app->sea.world, number);
    if (number < 0 || !swWaterBody_IsValid(app->sea.world, id))
    {
        return "none";
    }
    swWaterBodyDef def = swWaterBody_Get(app->sea.world, id);
    snprintf(name, sizeof(name), "%s", def.name[0] != '\0' ? def.name : "without a name");
    return name;
}

static void DrawWater(const App* app)
{
    if (!app->isPointerFree)
    {
        UiFaint("Point at the water to ask for it");
        return;
    }
    PointerWater water = FindWater(app->sea.world, &app->camera, app->pointerX, app->pointerY,
                                   (double)app->screen.extent.width, (double)app->screen.extent.height);
    if (!water.isHit)
    {
        UiFaint("No water there");
        return;
    }
    swPosXZ origin = swWorld_GetOrigin(app->sea.world);
    UiText("x %.2f  z %.2f m, %.1f m away", origin.x + water.place.x, origin.z + water.place.z, (double)water.distance);
    UiText("water at %.2f m, level %+.2f m", water.place.y, (double)water.level);
    UiText(isinf(water.depth) ? "no floor" : "depth %.2f m", (double)water.depth);
    UiText("flow %.2f, %.2f m/s along x, z", (double)water.flow.x, (double)water.flow.y);
    UiText("body of water: %s%s", NameBody(app, water.body), water.clip > 0.5f ? ", in a hole" : "");
}

void DrawLayerPanel(App* app)
{
    SheetView* view = &app->sheetView;
    if (BeginUiSection("Layers", view->isShown))
    {
        UiCheckbox("show a layer", &view->isShown);
        UiTip("The layers of the view that is drawn, read back from the device");
        if (view->isShown)
        {
            DrawLayerChoice(view, swView_GetSliceCount(app->sea.view));
            DrawRange(view);
            DrawTexel(app);
        }
    }
    if (!view->isShown && BeginUiSection("Under the mouse", false))
    {
        DrawWater(app);
    }
}
