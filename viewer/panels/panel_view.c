// SPDX-License-Identifier: MIT
// Camera, the scene's views, debug views and the slices around the viewer.

#include "panels.h"

static const char* GetDebugName(void* context, int index)
{
    (void)context;
    return swDebugMode_GetName((swDebugMode)index);
}

static void DrawCamera(App* app)
{
    Camera* camera = &app->camera;
    swPos eye = GetCameraEye(camera);
    float fov = ToDegrees(camera->verticalFov);
    swPosXZ origin = swWorld_GetOrigin(app->sea.world);
    UiText("x %.1f  y %.1f  z %.1f m", origin.x + eye.x, eye.y, origin.z + eye.z);
    if (origin.x != 0.0 || origin.z != 0.0)
    {
        UiFaint("origin of coordinates at x %.0f, z %.0f m", origin.x, origin.z);
        UiTip("Moved along with the camera; the sea stays where it is");
    }
    UiText("heading %.0f deg, pitch %.0f deg", (double)ToDegrees(camera->heading), (double)ToDegrees(camera->pitch));
    bool isOrbit = camera->mode == CAMERA_ORBIT;
    if (UiCheckbox("orbit", &isOrbit))
    {
        ToggleOrbit(camera, swWorld_GetSeaLevel(app->sea.world));
    }
    UiSameLine();
    UiCheckbox("may dive", &camera->mayDive);
    UiLogSlider("speed", &camera->speed, 0.05f, 50.0f, "x %.2f");
    if (UiSlider("field of view", &fov, 10.0f, 110.0f, "%.0f deg"))
    {
        camera->verticalFov = fov * DEGREE;
    }
}

static void DrawNamedViews(App* app)
{
    const swScene* scene = app->sea.scene;
    for (int i = 0; scene != NULL && i < scene->viewCount; i++)
    {
        if (i % 4 != 0)
        {
            UiSameLine();
        }
        if (UiButton(scene->views[i].name))
        {
            GoToView(app, i);
        }
    }
}

// Lines over the picture.
static void DrawMarks(App* app)
{
    static const struct
    {
        const char *label, *tip;
        uint32_t mark;
    } marks[] = {
        {"queries", "The surface as queries answer it, and its normals", SW_MARKS_QUERIES},
        {"ray", "A ray from beside the camera to what it looks at", SW_MARKS_RAY},
        {"tiles", "Bounds of the mesh's tiles", SW_MARKS_TILES},
        {"inputs", "Outlines of inputs and bodies of water", SW_MARKS_INPUTS},
    };
    for (int i = 0; i < 4; i++)
    {
        bool isOn = (app->marks & marks[i].mark) != 0;
        if (i > 0)
        {
            UiSameLine();
        }
        if (UiCheckbox(marks[i].label, &isOn))
        {
            app->marks ^= marks[i].mark;
        }
        UiTip(marks[i].tip);
    }
}

static void DrawSlices(const swView* view)
{
    static const UiColumn columns[] = {
        {"slice", 5.0f}, {"texel m", 0.0f}, {"side m", 0.0f}, {"waves m", 0.0f}, {"fade", 4.0f}};
    if (!BeginUiTable("slices", 5, columns))
    {
        return;
    }
    for (int i = 0; i < swView_GetSliceCount(view); i++)
    {
        swSliceInfo slice = swView_GetSlice(view, i);
        UiCell("%d", i);
        UiCell("%.4g", slice.texel);
        UiCell("%.4g", slice.texel * slice.resolution);
        UiCell("%.3g", (double)slice.minWavelength);
        UiCell("%.2f", (double)slice.fade);
    }
    EndUiTable();
}

void DrawViewPanel(App* app)
{
    if (BeginUiSection("Camera", false))
    {
        DrawCamera(app);
        DrawNamedViews(app);
    }
    if (BeginUiSection("Debug views", false))
    {
        int mode = (int)app->debug;
        if (UiChoice("show", &mode, SW_DEBUG_COUNT, GetDebugName, NULL))
        {
            app->debug = (swDebugMode)mode;
        }
        DrawMarks(app);
        DrawSlices(app->sea.view);
    }
}
