// SPDX-License-Identifier: MIT
// Sun, air and the look of the water.

#include "panels.h"

static void DrawSky(swSkyDef* sky, float* exposureEv)
{
    float azimuth = ToDegrees(sky->sunAzimuth);
    float elevation = ToDegrees(sky->sunElevation);
    if (UiSlider("sun azimuth", &azimuth, 0.0f, 360.0f, "%.0f deg"))
    {
        sky->sunAzimuth = ToRadians(azimuth);
    }
    if (UiSlider("sun elevation", &elevation, -10.0f, 90.0f, "%.1f deg"))
    {
        sky->sunElevation = ToRadians(elevation);
    }
    UiSlider("haze", &sky->haze, 0.0f, 20.0f, "%.2f");
    UiTip("Dust and salt relative to clear air");
    UiSlider("clouds", &sky->clouds, 0.0f, 1.0f, "%.2f");
    UiSlider("exposure", exposureEv, -6.0f, 6.0f, "%+.2f EV");
    UiTip("Added to what is measured");
}

static void DrawWater(swWaterDef* water)
{
    UiLogSlider("absorption red", &water->absorption.x, 1e-3f, 5.0f, "%.3f /m");
    UiLogSlider("absorption green", &water->absorption.y, 1e-3f, 5.0f, "%.3f /m");
    UiLogSlider("absorption blue", &water->absorption.z, 1e-3f, 5.0f, "%.3f /m");
    UiLogSlider("scattering red", &water->scattering.x, 1e-4f, 1.0f, "%.4f /m");
    UiLogSlider("scattering green", &water->scattering.y, 1e-4f, 1.0f, "%.4f /m");
    UiLogSlider("scattering blue", &water->scattering.z, 1e-4f, 1.0f, "%.4f /m");
    UiSlider("refractive index", &water->refractiveIndex, 1.30f, 1.40f, "%.3f");
    UiSlider("wind on ripples", &water->windSpeed, 0.0f, 40.0f, "%.1f m/s");
    UiTip("Roughness of the ripples that are too short for any band");
    UiColor("foam colour", &water->foamAlbedo);
}

void DrawSkyPanel(App* app)
{
    if (BeginUiSection("Sun and air", true))
    {
        DrawSky(&app->sea.sky, &app->sea.exposureEv);
    }
    if (BeginUiSection("Water", false))
    {
        DrawWater(&app->sea.water);
    }
}
