// SPDX-License-Identifier: MIT
// How waves are made of a spectrum, the equaliser, and waves by hand.

#include <math.h>
#include <stdio.h>

#include "panels.h"

static bool DrawOctave(swOctave* octave, int index)
{
    PushUiScope(index);
    UiCell("%.4g", (double)ldexpf(1.0f, index - 4));
    UiNextCell();
    bool hasChanged = UiCheckbox("##on", &octave->isEnabled);
    UiNextCell();
    hasChanged |= UiSlider("##power", &octave->power, -10.0f, 5.0f, "%.1f");
    UiNextCell();
    hasChanged |= UiSlider("##chop", &octave->chop, 0.0f, 4.0f, "%.2f");
    UiNextCell();
    hasChanged |= UiSlider("##gravity", &octave->gravityScale, 0.0f, 4.0f, "%.2f");
    PopUiScope();
    return hasChanged;
}

bool DrawEqualiser(swSpectrumDef* spectrum)
{
    static const char* const titles[] = {"from m", "on", "power", "chop", "gravity"};
    swOctaves* octaves = &spectrum->octaves;
    bool hasChanged = false;
    if (BeginUiTable("octaves", 5, titles))
    {
        for (int i = SW_OCTAVE_COUNT - 1; i >= 0; i--)
        {
            hasChanged |= DrawOctave(&octaves->octaves[i], i);
        }
        EndUiTable();
    }
    hasChanged |= UiSlider("all heights", &octaves->multiplier, 0.0f, 10.0f, "x %.2f");
    hasChanged |= UiSlider("all chops", &octaves->chop, 0.0f, 4.0f, "x %.2f");
    hasChanged |= UiSlider("all gravities", &octaves->gravityScale, 0.0f, 25.0f, "x %.2f");
    hasChanged |= UiCheckbox("limited by the wind", &octaves->limitByWind);
    UiTip("Takes away waves that are too long for the wind");
    return hasChanged;
}

static const char* GetMethodName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"Fourier transforms", "few waves (Gerstner)"};
    return names[index];
}

bool DrawMethod(swWaveSystemDef* def)
{
    int method = (int)def->method;
    bool hasChanged = UiChoice("made by", &method, SW_WAVE_METHOD_COUNT, GetMethodName, NULL);
    def->method = (swWaveMethod)method;
    if (def->method == SW_WAVES_GERSTNER)
    {
        float variance = ToDegrees(def->directionVariance);
        hasChanged |= UiSliderInt("waves an octave", &def->componentsPerOctave, 1, 32, "%d");
        hasChanged |= UiSlider("twins running back", &def->reverseWeight, 0.0f, 1.0f, "%.2f");
        UiTip("Height of a twin of each wave that runs the other way: 1 makes standing waves");
        if (UiSlider("directions within", &variance, 0.0f, 180.0f, variance > 0.0f ? "%.0f deg" : "as it spreads"))
        {
            def->directionVariance = ToRadians(variance);
            hasChanged = true;
        }
        hasChanged |= UiSlider("least Jacobian", &def->leastJacobian, -1.0f, 0.9f, "%.2f");
        UiTip("Sideways motion is held back where water would fold more than that: 1 is flat, 0 a fold");
    }
    return hasChanged;
}

static bool DrawComponent(swWaveComponent* component)
{
    float bearing = ToBearing(component->direction);
    float phase = ToDegrees(component->phase);
    UiNextCell();
    bool hasChanged = UiLogSlider("##length", &component->wavelength, 0.0625f, 4096.0f, "%.3g m");
    UiNextCell();
    hasChanged |= UiLogSlider("##height", &component->amplitude, 0.0f, 40.0f, "%.3g m");
    UiNextCell();
    if (UiSlider("##from", &bearing, 0.0f, 360.0f, "%.0f deg"))
    {
        component->direction = SW_DIRECTION_FROM_BEARING((double)bearing);
        hasChanged = true;
    }
    UiNextCell();
    if (UiSlider("##phase", &phase, -360.0f, 360.0f, "%.0f deg"))
    {
        component->phase = ToRadians(phase);
        hasChanged = true;
    }
    return hasChanged;
}

bool DrawComponents(SeaWaves* waves)
{
    static const char* const titles[] = {"length", "amplitude", "from", "phase"};
    bool hasChanged = false;
    if (waves->components == NULL || !BeginUiTable("components", 4, titles))
    {
        return false;
    }
    for (int i = 0; i < waves->def.componentCount && i < 64; i++)
    {
        PushUiScope(i);
        hasChanged |= DrawComponent(&waves->components[i]);
        PopUiScope();
    }
    EndUiTable();
    if (waves->def.componentCount > 64)
    {
        UiFaint("and %d more", waves->def.componentCount - 64);
    }
    return hasChanged;
}
