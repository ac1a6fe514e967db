// SPDX-License-Identifier: MIT
// Sun and air, the look of the water, and foam.

#include "panels.h"

static void DrawSky(SeaLook* look, const SeaLook* filed)
{
    TurnKnob(&(Knob){.label = "sun azimuth", .high = 360.0f, .format = "%.0f deg", .unit = DEGREE},
             &look->sky.sunAzimuth, &filed->sky.sunAzimuth);
    TurnKnob(&(Knob){.label = "sun elevation", .low = -10.0f, .high = 90.0f, .format = "%.1f deg", .unit = DEGREE},
             &look->sky.sunElevation, &filed->sky.sunElevation);
    TurnKnob(&(Knob){.label = "haze", .high = 20.0f, .format = "%.2f", .tip = "Dust and salt relative to clear air"},
             &look->sky.haze, &filed->sky.haze);
    TurnKnob(&(Knob){.label = "clouds", .high = 1.0f, .format = "%.2f"}, &look->sky.clouds, &filed->sky.clouds);
    TurnKnob(
        &(Knob){
            .label = "exposure", .low = -6.0f, .high = 6.0f, .format = "%+.2f EV", .tip = "Added to what is measured"},
        &look->exposureEv, &filed->exposureEv);
}

static void DrawColors(const char* const labels[3], Knob knob, swVec3* value, const swVec3* filed)
{
    float* values[3] = {&value->x, &value->y, &value->z};
    const float* others[3] = {&filed->x, &filed->y, &filed->z};
    for (int i = 0; i < 3; i++)
    {
        knob.label = labels[i];
        TurnKnob(&knob, values[i], others[i]);
    }
}

static void DrawWater(swWaterDef* water, const swWaterDef* filed)
{
    static const char* const absorption[3] = {"absorption red", "absorption green", "absorption blue"};
    static const char* const scattering[3] = {"scattering red", "scattering green", "scattering blue"};
    DrawColors(absorption, (Knob){.low = 1e-3f, .high = 5.0f, .format = "%.3f /m", .isLogarithmic = true},
               &water->absorption, &filed->absorption);
    DrawColors(scattering, (Knob){.low = 1e-4f, .high = 1.0f, .format = "%.4f /m", .isLogarithmic = true},
               &water->scattering, &filed->scattering);
    TurnKnob(&(Knob){.label = "refractive index", .low = 1.30f, .high = 1.40f, .format = "%.3f"},
             &water->refractiveIndex, &filed->refractiveIndex);
    TurnKnob(&(Knob){.label = "wind on ripples",
                     .high = 40.0f,
                     .format = "%.1f m/s",
                     .tip = "Roughness of the ripples that are too short for any band"},
             &water->windSpeed, &filed->windSpeed);
    TurnColor("foam colour", &water->foamAlbedo, &filed->foamAlbedo);
}

static void DrawFoam(App* app)
{
    swFoamDef* foam = &app->sea.look.foam;
    const swFoamDef* filed = &app->sea.filedLook.foam;
    swFoamState state = swWorld_GetFoamState(app->sea.world);
    UiFaint("%.1f m/s of wind cover %.2g %%", (double)state.windSpeed, 100.0 * (double)state.cover);
    bool hasChanged = TurnKnob(
        &(Knob){
            .label = "coverage", .high = 5.0f, .format = "%.2f", .tip = "Factor on the whitecaps that the wind gives"},
        &foam->coverage, &filed->coverage);
    hasChanged |= TurnKnob(&(Knob){.label = "wind",
                                   .high = 40.0f,
                                   .format = foam->windSpeed > 0.0f ? "%.1f m/s" : "by the waves",
                                   .tip = "Wind that makes the whitecaps; at 0 the waves tell it"},
                           &foam->windSpeed, &filed->windSpeed);
    hasChanged |= TurnKnob(
        &(Knob){.label = "shortest wave", .high = 16.0f, .format = "%.2f m", .tip = "Shorter waves make no foam"},
        &foam->minWavelength, &filed->minWavelength);
    hasChanged |=
        TurnKnob(&(Knob){.label = "threshold",
                         .low = -4.0f,
                         .high = 1.0f,
                         .format = "%.2f",
                         .tip = "Folding below which foam is born even without wind: 1 is flat water, 0 a fold"},
                 &foam->threshold, &filed->threshold);
    hasChanged |=
        TurnKnob(&(Knob){.label = "fading", .low = 0.01f, .high = 10.0f, .format = "%.2f /s", .isLogarithmic = true},
                 &foam->fadeRate, &filed->fadeRate);
    if (hasChanged)
    {
        swWorld_SetFoam(app->sea.world, foam);
    }
}

void DrawSkyPanel(App* app)
{
    Sea* sea = &app->sea;
    if (BeginUiSection("Foam", false))
    {
        DrawFoam(app);
    }
    if (BeginUiSection("Sun and air", true))
    {
        DrawSky(&sea->look, &sea->filedLook);
    }
    if (BeginUiSection("Water", false))
    {
        DrawWater(&sea->look.water, &sea->filedLook.water);
    }
}
