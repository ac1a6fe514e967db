// SPDX-License-Identifier: MIT
// Sea state: every wave system's spectrum, live, and the record of a measured one; foam.

#include <math.h>
#include <stdio.h>

#include "panels.h"

static const char* GetKindName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"JONSWAP", "Pierson-Moskowitz", "TMA", "Elfouhaily", "Phillips", "octaves"};
    return names[index];
}

static const char* GetRecordTime(void* context, int index)
{
    static char text[20];
    swMeasuredRecord record = swMeasuredSea_GetRecord(context, index);
    snprintf(text, sizeof(text), "%s", record.time);
    return text;
}

// Where waves come from, degrees clockwise from north, of a direction they go.
static float ToBearing(float direction)
{
    float degrees = fmodf(ToDegrees(direction) - 90.0f, 360.0f);
    return degrees < 0.0f ? degrees + 360.0f : degrees;
}

static const char* GetSpreadingName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"cos^2s", "Mitsuyasu", "Hasselmann", "Donelan-Banner", "flat", "Elfouhaily"};
    return names[index];
}

static bool DrawSpreading(swSpectrumDef* spectrum)
{
    int spreading = (int)spectrum->spreading;
    bool hasChanged = UiChoice("spreading", &spreading, SW_SPREADING_KIND_COUNT, GetSpreadingName, NULL);
    spectrum->spreading = (swSpreadingKind)spreading;
    if (spreading == SW_SPREADING_COSINE_2S)
    {
        hasChanged |= UiSlider("spreading s", &spectrum->spreadExponent, 0.0f, 75.0f, "%.0f");
        UiTip("cos^2s of half the angle: 0 is from all sides, 8 a wind sea, 75 a swell");
    }
    hasChanged |= UiSlider("turbulence", &spectrum->turbulence, 0.0f, 1.0f, "%.2f");
    UiTip("Part of the energy that goes in all directions alike");
    hasChanged |= UiSlider("swell", &spectrum->swell, 0.0f, 1.0f, "%.2f");
    UiTip("Draws the longest waves out into parallel crests");
    return hasChanged;
}

static bool DrawFormula(swSpectrumDef* spectrum)
{
    int kind = (int)spectrum->kind;
    float fetch = spectrum->fetch * 1e-3f;
    float bearing = ToBearing(spectrum->direction);
    bool hasChanged = UiChoice("spectrum", &kind, SW_SPECTRUM_TABLE, GetKindName, NULL);
    hasChanged |= UiSlider("wind", &spectrum->windSpeed, 1.0f, 40.0f, "%.1f m/s");
    bool hasGamma = kind == SW_SPECTRUM_JONSWAP || kind == SW_SPECTRUM_TMA;
    if (hasGamma || kind == SW_SPECTRUM_ELFOUHAILY)
    {
        hasChanged |= UiLogSlider("fetch", &fetch, 1.0f, 2000.0f, "%.0f km");
    }
    if (hasGamma)
    {
        hasChanged |= UiSlider("peak enhancement", &spectrum->gamma, 1.0f, 10.0f, "%.2f");
    }
    hasChanged |= UiSlider("height Hs", &spectrum->significantHeight, 0.0f, 20.0f,
                           spectrum->significantHeight > 0.0f ? "%.2f m" : "from the wind");
    hasChanged |= UiSlider("peak period Tp", &spectrum->peakPeriod, 0.0f, 25.0f,
                           spectrum->peakPeriod > 0.0f ? "%.1f s" : "from the wind");
    if (UiSlider("comes from", &bearing, 0.0f, 360.0f, "%.0f deg"))
    {
        spectrum->direction = SW_DIRECTION_FROM_BEARING((double)bearing);
        hasChanged = true;
    }
    hasChanged |= DrawSpreading(spectrum);
    spectrum->kind = (swSpectrumKind)kind;
    spectrum->fetch = fetch * 1e3f;
    return hasChanged;
}

static bool DrawMeasured(SeaWaves* waves, swSpectrumDef* spectrum, int* record)
{
    float turn = ToDegrees(spectrum->direction);
    int last = swMeasuredSea_GetCount(waves->measured) - 1;
    UiFaint("%s", waves->file);
    bool hasChanged = UiChoice("record", record, last + 1, GetRecordTime, (void*)(uintptr_t)waves->measured);
    hasChanged |= last > 0 && UiSliderInt("record number", record, 0, last, "%d");
    if (UiButton("largest"))
    {
        *record = swMeasuredSea_FindLargest(waves->measured);
        hasChanged = true;
    }
    UiTip("The record with the largest significant height");
    hasChanged |= UiSlider("height Hs", &spectrum->significantHeight, 0.0f, 20.0f,
                           spectrum->significantHeight > 0.0f ? "%.2f m" : "as measured");
    if (UiSlider("turned by", &turn, -180.0f, 180.0f, "%.0f deg"))
    {
        spectrum->direction = ToRadians(turn);
        hasChanged = true;
    }
    hasChanged |= UiCheckbox("short waves beyond the record", &spectrum->extendTail);
    UiTip("Continues the record with an f^-5 tail; a buoy does not feel short waves");
    return hasChanged;
}

static void DrawAsked(const SeaWaves* waves)
{
    const swSeaState* asked = &waves->asked;
    UiFaint("Hs %.2f m  Tp %.1f s  Tm02 %.1f s", (double)asked->significantHeight, (double)asked->peakPeriod,
            (double)asked->periodTm02);
    UiFaint("from %.0f deg, spread %.0f deg", (double)ToBearing(asked->meanDirection),
            (double)ToDegrees(asked->spread));
}

static void DrawWaves(App* app, int index)
{
    SeaWaves* waves = &app->sea.waves[index];
    swWaveSystemDef def = waves->def;
    int record = waves->record;
    char label[64];
    snprintf(label, sizeof(label), "Waves %d: %s", index + 1,
             waves->measured ? "measured" : GetKindName(NULL, (int)def.spectrum.kind));
    PushUiScope(index);
    if (BeginUiSection(label, index == 0))
    {
        bool hasChanged = waves->measured ? DrawMeasured(waves, &def.spectrum, &record) : DrawFormula(&def.spectrum);
        hasChanged |= UiSlider("weight", &def.weight, 0.0f, 2.0f, "%.2f");
        hasChanged |= UiSlider("chop", &def.chop, 0.0f, 2.0f, "%.2f");
        UiTip("Horizontal motion; 1 is that of a trochoidal wave");
        DrawAsked(waves);
        if (hasChanged)
        {
            ChangeWaves(&app->sea, index, &def, record);
        }
    }
    PopUiScope();
}

static void DrawFoam(App* app)
{
    swFoamDef* foam = &app->sea.worldDef.foam;
    if (!BeginUiSection("Foam", false))
    {
        return;
    }
    bool hasChanged = UiSlider("threshold", &foam->threshold, 0.0f, 1.0f, "%.2f");
    UiTip("Folding below which foam is born: 1 is flat water, 0 a fold");
    hasChanged |= UiLogSlider("gain", &foam->gain, 0.05f, 1000.0f, "%.2f /s");
    hasChanged |= UiLogSlider("fading", &foam->fadeRate, 0.01f, 10.0f, "%.2f /s");
    if (hasChanged)
    {
        swWorld_SetFoam(app->sea.world, foam);
    }
}

void DrawSeaPanel(App* app)
{
    for (int i = 0; i < app->sea.wavesCount; i++)
    {
        DrawWaves(app, i);
    }
    DrawFoam(app);
}
