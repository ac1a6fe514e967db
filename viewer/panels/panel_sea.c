// SPDX-License-Identifier: MIT
// Sea state: the wave systems and what each is made of, live: a formula, an equaliser, a record or a replay; foam.

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

float ToBearing(float direction)
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

static const char* GetGrowthName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"Hasselmann 1973", "cube root"};
    return names[index];
}

static bool DrawGrowth(swSpectrumDef* spectrum)
{
    int growth = (int)spectrum->growth;
    bool hasChanged = UiChoice("growth law", &growth, SW_GROWTH_LAW_COUNT, GetGrowthName, NULL);
    UiTip(
        "How the peak follows from wind and fetch: as printed in 1973, or by the rounded law that many programs take");
    spectrum->growth = (swGrowthLaw)growth;
    return hasChanged;
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

bool DrawFormula(swSpectrumDef* spectrum)
{
    int kind = (int)spectrum->kind;
    float fetch = spectrum->fetch * 1e-3f;
    float bearing = ToBearing(spectrum->direction);
    bool hasChanged = UiChoice("spectrum", &kind, SW_SPECTRUM_TABLE, GetKindName, NULL);
    if (hasChanged && kind == SW_SPECTRUM_OCTAVES)
    {
        *spectrum = swMakeOctaveSpectrum(spectrum); // begins as what was there
    }
    hasChanged |= UiSlider("wind", &spectrum->windSpeed, 1.0f, 40.0f, "%.1f m/s");
    bool hasGamma = kind == SW_SPECTRUM_JONSWAP || kind == SW_SPECTRUM_TMA;
    if (hasGamma || kind == SW_SPECTRUM_ELFOUHAILY)
    {
        hasChanged |= UiLogSlider("fetch", &fetch, 1.0f, 2000.0f, "%.0f km");
    }
    if (hasGamma)
    {
        hasChanged |= spectrum->peakPeriod <= 0.0f && DrawGrowth(spectrum);
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
    hasChanged |= BeginUiGroup("Directions", false) && DrawSpreading(spectrum);
    spectrum->kind = (swSpectrumKind)kind;
    spectrum->fetch = fetch * 1e3f;
    if (kind == SW_SPECTRUM_OCTAVES && BeginUiGroup("Octaves", true))
    {
        hasChanged |= DrawEqualiser(spectrum);
    }
    return hasChanged;
}

static bool DrawRecord(SeaWaves* waves)
{
    int* record = &waves->record;
    int last = swMeasuredSea_GetCount(waves->measured) - 1;
    bool hasChanged = UiChoice("record", record, last + 1, GetRecordTime, (void*)(uintptr_t)waves->measured);
    hasChanged |= last > 0 && UiSliderInt("record number", record, 0, last, "%d");
    if (UiButton("largest"))
    {
        *record = swMeasuredSea_FindLargest(waves->measured);
        hasChanged = true;
    }
    UiTip("The record with the largest significant height");
    return hasChanged;
}

// Where a replay is, and how fast it runs.
static void DrawReplay(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    double seconds = GetReplaySeconds(sea, index), fraction = 0.0;
    float speed = (float)waves->replayDef.speed;
    int before = 0, after = 0;
    char now[20];
    WriteUtc(seconds, now);
    UiText("%s UTC", now);
    swSeaReplay_GetRecords(waves->replay, &before, &after, &fraction);
    swMeasuredRecord a = swMeasuredSea_GetRecord(waves->measured, before);
    swMeasuredRecord b = swMeasuredSea_GetRecord(waves->measured, after);
    char text[64];
    snprintf(text, sizeof(text), "%.11s %.5s to %.5s", a.time, a.time + 11, b.time + 11);
    UiBar((float)fraction, text);
    if (UiLogSlider("replay speed", &speed, -1e5f, 1e5f, "x %.0f"))
    {
        ChangeReplay(sea, index, seconds, (double)speed);
    }
    UiTip("Seconds of records that pass in one of the sea; the timeline above moves through them");
}

static bool DrawMeasured(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    swSpectrumDef* spectrum = &waves->def.spectrum;
    float turn = ToDegrees(spectrum->direction);
    bool hasChanged = false;
    UiFaint("%s", waves->file);
    if (waves->replay != NULL)
    {
        DrawReplay(sea, index);
    }
    else
    {
        hasChanged = DrawRecord(waves);
    }
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

static const char* NameKind(const SeaWaves* waves)
{
    return waves->replay != NULL           ? "replay"
           : waves->measured != NULL       ? "measured"
           : waves->def.componentCount > 0 ? "by hand"
                                           : GetKindName(NULL, (int)waves->def.spectrum.kind);
}

static int CountModes(const Sea* sea, int index)
{
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(sea->world, sea->waves[index].id, bands), sum = 0;
    for (int i = 0; i < count; i++)
    {
        sum += bands[i].modeCount;
    }
    return sum;
}

// All systems at a glance.
static void DrawSystems(const Sea* sea)
{
    static const char* const titles[] = {"", "kind", "Hs m", "Tp s", "from", "waves"};
    if (!BeginUiTable("systems", 6, titles))
    {
        return;
    }
    for (int i = 0; i < sea->wavesCount; i++)
    {
        const SeaWaves* waves = &sea->waves[i];
        bool hasShape = waves->asked.peakPeriod > 0.0f;
        UiCell("%d", i + 1);
        UiCell("%s", NameKind(waves));
        UiCell("%.2f", (double)(waves->asked.significantHeight * waves->def.weight));
        UiCell(hasShape ? "%.1f" : "-", (double)waves->asked.peakPeriod);
        UiCell(hasShape ? "%.0f" : "-", (double)ToBearing(waves->asked.meanDirection));
        UiCell("%d", CountModes(sea, i));
    }
    EndUiTable();
}

static void DrawWaves(App* app, int index)
{
    SeaWaves* waves = &app->sea.waves[index];
    swWaveSystemDef* def = &waves->def;
    char label[64];
    snprintf(label, sizeof(label), "Waves %d: %s###waves", index + 1, NameKind(waves));
    PushUiScope(index);
    if (BeginUiSection(label, index == 0))
    {
        bool hasChanged = waves->measured           ? DrawMeasured(&app->sea, index)
                          : def->componentCount > 0 ? DrawComponents(waves)
                                                    : DrawFormula(&def->spectrum);
        hasChanged |= waves->replay == NULL && def->componentCount == 0 &&
                      BeginUiGroup("Method", def->method == SW_WAVES_GERSTNER) && DrawMethod(def);
        hasChanged |= UiSlider("weight", &def->weight, 0.0f, 2.0f, "%.2f");
        hasChanged |= UiSlider("chop", &def->chop, 0.0f, 2.0f, "%.2f");
        UiTip("Horizontal motion; 1 is that of a trochoidal wave");
        waves->hasChanged |= hasChanged;
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
    if (BeginUiSection("Wave systems", true))
    {
        DrawSystems(&app->sea);
        UiSlider("changes take", &app->sea.transition, 0.0f, 30.0f, app->sea.transition > 0.0f ? "%.1f s" : "no time");
        UiTip("How long the sea takes to become what was set, without a jump");
    }
    for (int i = 0; i < app->sea.wavesCount; i++)
    {
        DrawWaves(app, i);
    }
    DrawFoam(app);
}
