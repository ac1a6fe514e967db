// SPDX-License-Identifier: MIT
// What a spectrum is, how waves are made of it, and the equaliser.

#include <math.h>

#include "panels.h"

const char* GetKindName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"JONSWAP", "Pierson-Moskowitz", "TMA", "Elfouhaily", "Phillips", "octaves"};
    return names[index];
}

// The address of a member of the file's twin, if there is a file.
#define FILED(member) (filed != NULL ? &filed->member : NULL)

static const char* GetSpreadingName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"cos^2s", "Mitsuyasu", "Hasselmann", "Donelan-Banner", "flat", "Elfouhaily"};
    return names[index];
}

static const char* GetGrowthName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"Hasselmann 1973", "cube root"};
    return names[index];
}

static bool DrawGrowth(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    int growth = (int)spectrum->growth, other = filed != NULL ? (int)filed->growth : 0;
    bool hasChanged =
        TurnChoice("growth law", &growth, filed != NULL ? &other : NULL, SW_GROWTH_LAW_COUNT, GetGrowthName, NULL);
    UiTip(
        "How the peak follows from wind and fetch: as printed in 1973, or by the rounded law that many programs take");
    spectrum->growth = (swGrowthLaw)growth;
    return hasChanged;
}

static bool DrawSpreading(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    int spreading = (int)spectrum->spreading, other = filed != NULL ? (int)filed->spreading : 0;
    bool hasChanged = TurnChoice("spreading", &spreading, filed != NULL ? &other : NULL, SW_SPREADING_KIND_COUNT,
                                 GetSpreadingName, NULL);
    spectrum->spreading = (swSpreadingKind)spreading;
    if (spreading == SW_SPREADING_COSINE_2S)
    {
        hasChanged |=
            TurnKnob(&(Knob){.label = "spreading s",
                             .high = 75.0f,
                             .format = "%.0f",
                             .tip = "cos^2s of half the angle: 0 is from all sides, 8 a wind sea, 75 a swell"},
                     &spectrum->spreadExponent, FILED(spreadExponent));
    }
    hasChanged |= TurnKnob(&(Knob){.label = "turbulence",
                                   .high = 1.0f,
                                   .format = "%.2f",
                                   .tip = "Part of the energy that goes in all directions alike"},
                           &spectrum->turbulence, FILED(turbulence));
    hasChanged |= TurnKnob(&(Knob){.label = "swell",
                                   .high = 1.0f,
                                   .format = "%.2f",
                                   .tip = "Draws the longest waves out into parallel crests"},
                           &spectrum->swell, FILED(swell));
    return hasChanged;
}

// One number that sets wind, height and period; it follows them where they are set by themselves.
static bool DrawBeaufort(swSpectrumDef* spectrum)
{
    BeaufortNumber beaufort = FindBeaufort(spectrum);
    bool hasChanged = UiSlider("Beaufort", &beaufort.number, 0.0f, 12.0f, beaufort.isExact ? "%.1f" : "(wind of %.1f)");
    UiTip("Sets wind, height and period together, as `beaufort` in a scene file.\n"
          "In brackets: the wind has this number, but the sea is another one.");
    if (hasChanged)
    {
        SetBeaufort(spectrum, beaufort.number);
    }
    return hasChanged;
}

static bool DrawKind(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    int kind = (int)spectrum->kind, other = filed != NULL ? (int)filed->kind : 0;
    bool hasFiled = filed != NULL && other != SW_SPECTRUM_TABLE;
    bool hasChanged = TurnChoice("spectrum", &kind, hasFiled ? &other : NULL, SW_SPECTRUM_TABLE, GetKindName, NULL);
    if (hasChanged && kind == SW_SPECTRUM_OCTAVES && !(hasFiled && kind == other))
    {
        *spectrum = swMakeOctaveSpectrum(spectrum); // begins as what was there
    }
    spectrum->kind = (swSpectrumKind)kind;
    return hasChanged;
}

bool DrawFormula(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    bool hasChanged = DrawKind(spectrum, filed);
    hasChanged |= spectrum->kind != SW_SPECTRUM_OCTAVES && DrawBeaufort(spectrum);
    hasChanged |= TurnKnob(&(Knob){.label = "wind", .low = 1.0f, .high = 40.0f, .format = "%.1f m/s"},
                           &spectrum->windSpeed, FILED(windSpeed));
    bool hasGamma = spectrum->kind == SW_SPECTRUM_JONSWAP || spectrum->kind == SW_SPECTRUM_TMA;
    if (hasGamma || spectrum->kind == SW_SPECTRUM_ELFOUHAILY)
    {
        hasChanged |= TurnKnob(&(Knob){.label = "fetch",
                                       .low = 1.0f,
                                       .high = 2000.0f,
                                       .format = "%.0f km",
                                       .unit = 1e3f,
                                       .isLogarithmic = true},
                               &spectrum->fetch, FILED(fetch));
    }
    if (hasGamma)
    {
        hasChanged |= spectrum->peakPeriod <= 0.0f && DrawGrowth(spectrum, filed);
        hasChanged |= TurnKnob(&(Knob){.label = "peak enhancement", .low = 1.0f, .high = 10.0f, .format = "%.2f"},
                               &spectrum->gamma, FILED(gamma));
    }
    hasChanged |= TurnKnob(&(Knob){.label = "height Hs", .high = 20.0f, .format = "%.2f m", .zero = "from the wind"},
                           &spectrum->significantHeight, FILED(significantHeight));
    hasChanged |=
        TurnKnob(&(Knob){.label = "peak period Tp", .high = 25.0f, .format = "%.1f s", .zero = "from the wind"},
                 &spectrum->peakPeriod, FILED(peakPeriod));
    hasChanged |= TurnKnob(&(Knob){.label = "comes from", .high = 360.0f, .format = "%.0f deg", .isBearing = true},
                           &spectrum->direction, FILED(direction));
    if (BeginUiGroup("Directions", false))
    {
        hasChanged |= DrawSpreading(spectrum, filed);
    }
    if (spectrum->kind == SW_SPECTRUM_OCTAVES && BeginUiGroup("Octaves", true))
    {
        hasChanged |= DrawEqualiser(spectrum, filed != NULL && filed->kind == SW_SPECTRUM_OCTAVES ? filed : NULL);
    }
    return hasChanged;
}

static bool DrawOctave(swOctave* octave, const swOctave* filed, int index)
{
    PushUiScope(index);
    UiLabelCell("%.4g", (double)ldexpf(1.0f, index - 4));
    UiNextCell();
    bool hasChanged = TurnSwitch("##on", &octave->isEnabled, FILED(isEnabled));
    UiNextCell();
    hasChanged |= TurnKnob(&(Knob){.label = "##power", .low = -10.0f, .high = 5.0f, .format = "%.1f"}, &octave->power,
                           FILED(power));
    UiNextCell();
    hasChanged |= TurnKnob(&(Knob){.label = "##chop", .high = 4.0f, .format = "%.2f"}, &octave->chop, FILED(chop));
    UiNextCell();
    hasChanged |= TurnKnob(&(Knob){.label = "##gravity", .high = 4.0f, .format = "%.2f"}, &octave->gravityScale,
                           FILED(gravityScale));
    PopUiScope();
    return hasChanged;
}

bool DrawEqualiser(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    static const UiColumn columns[] = {
        {"from m", 6.0f}, {"on", 4.5f}, {"power", 0.0f}, {"chop", 0.0f}, {"gravity", 0.0f}};
    swOctaves* octaves = &spectrum->octaves;
    bool hasChanged = false;
    if (BeginUiTable("octaves", 5, columns))
    {
        for (int i = SW_OCTAVE_COUNT - 1; i >= 0; i--)
        {
            hasChanged |= DrawOctave(&octaves->octaves[i], FILED(octaves.octaves[i]), i);
        }
        EndUiTable();
    }
    hasChanged |= TurnKnob(&(Knob){.label = "all heights", .high = 10.0f, .format = "x %.2f"}, &octaves->multiplier,
                           FILED(octaves.multiplier));
    hasChanged |=
        TurnKnob(&(Knob){.label = "all chops", .high = 4.0f, .format = "x %.2f"}, &octaves->chop, FILED(octaves.chop));
    hasChanged |= TurnKnob(&(Knob){.label = "all gravities", .high = 25.0f, .format = "x %.2f"}, &octaves->gravityScale,
                           FILED(octaves.gravityScale));
    hasChanged |= TurnSwitch("limited by the wind", &octaves->limitByWind, FILED(octaves.limitByWind));
    UiTip("Takes away waves that are too long for the wind");
    return hasChanged;
}

static const char* GetMethodName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"Fourier transforms", "few waves (Gerstner)"};
    return names[index];
}

bool DrawMethod(swWaveSystemDef* def, const swWaveSystemDef* filed)
{
    int method = (int)def->method, other = filed != NULL ? (int)filed->method : 0;
    bool hasChanged =
        TurnChoice("made by", &method, filed != NULL ? &other : NULL, SW_WAVE_METHOD_COUNT, GetMethodName, NULL);
    def->method = (swWaveMethod)method;
    if (def->method == SW_WAVES_GERSTNER)
    {
        hasChanged |= TurnCount("waves an octave", &def->componentsPerOctave, FILED(componentsPerOctave), 1, 32, "%d");
        hasChanged |=
            TurnKnob(&(Knob){.label = "twins back",
                             .high = 1.0f,
                             .format = "%.2f",
                             .tip = "Height of a twin of each wave that runs the other way: 1 makes standing waves"},
                     &def->reverseWeight, FILED(reverseWeight));
        hasChanged |= TurnKnob(&(Knob){.label = "directions within",
                                       .high = 180.0f,
                                       .format = "%.0f deg",
                                       .unit = DEGREE,
                                       .zero = "as it spreads"},
                               &def->directionVariance, FILED(directionVariance));
        hasChanged |=
            TurnKnob(&(Knob){.label = "least Jacobian",
                             .low = -1.0f,
                             .high = 0.9f,
                             .format = "%.2f",
                             .tip = "Sideways motion is held back where water would fold more: 1 is flat, 0 a fold"},
                     &def->leastJacobian, FILED(leastJacobian));
    }
    return hasChanged;
}
