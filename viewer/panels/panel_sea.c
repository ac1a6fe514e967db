// SPDX-License-Identifier: MIT
// Sea state: the wave systems at a glance, systems that come and go, and of each what it is made of.

#include <stdio.h>

#include "panels.h"

static const char* NameKind(const SeaWaves* waves)
{
    return waves->isRemoved          ? "removed"
           : waves->replay != NULL   ? "replay"
           : waves->measured != NULL ? "measured"
           : waves->hand != NULL     ? "by hand"
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

// Returns whether it shall go.
static bool DrawSystemRow(const Sea* sea, int index)
{
    const SeaWaves* waves = &sea->waves[index];
    bool hasShape = waves->asked.peakPeriod > 0.0f;
    UiCell("%d %s", index + 1, NameKind(waves));
    UiCell("%.2f", (double)(waves->asked.significantHeight * waves->def.weight));
    UiCell(hasShape ? "%.1f" : "-", (double)waves->asked.peakPeriod);
    UiCell(hasShape ? "%.0f" : "-", (double)ToBearing(waves->asked.meanDirection));
    UiCell("%d", CountModes(sea, index));
    UiNextCell();
    PushUiScope(waves->serial);
    bool mustGo = UiSmallButton("-");
    UiTip("Remove it; its waves run down over the time below");
    PopUiScope();
    return mustGo;
}

// All systems at a glance.
static void DrawSystems(Sea* sea)
{
    static const UiColumn columns[] = {{"kind", 0.0f}, {"Hs m", 5.0f},  {"Tp s", 4.0f},
                                       {"from", 4.0f}, {"waves", 5.0f}, {"", 2.0f}};
    int goes = -1;
    if (!BeginUiTable("systems", 6, columns))
    {
        return;
    }
    for (int i = 0; i < sea->wavesCount; i++)
    {
        if (!sea->waves[i].isRemoved)
        {
            goes = DrawSystemRow(sea, i) ? i : goes;
        }
    }
    EndUiTable();
    if (goes >= 0)
    {
        RemoveWaves(sea, goes);
    }
}

static const char* GetNewName(void* context, int index)
{
    (void)context;
    static const char* const names[] = {"wind sea", "swell", "equaliser", "waves by hand", "choose ..."};
    return names[index];
}

static void DrawAdding(App* app)
{
    int kind = NEW_WAVES_COUNT;
    if (UiChoice("add a system", &kind, NEW_WAVES_COUNT, GetNewName, NULL) && !AddWaves(&app->sea, (NewWaves)kind))
    {
        ShowNote(app, "no wave system was added; see Messages");
    }
    UiTip("Its waves rise over the time below");
}

static bool DrawContents(App* app, int index)
{
    SeaWaves* waves = &app->sea.waves[index];
    swWaveSystemDef* def = &waves->def;
    const swWaveSystemDef* filed = waves->isAdded ? NULL : &waves->filedDef;
    bool hasChanged = false;
    if (waves->measured != NULL)
    {
        hasChanged = DrawMeasured(&app->sea, index);
    }
    else if (waves->hand != NULL)
    {
        hasChanged = DrawHandWaves(app, index);
    }
    else
    {
        hasChanged = DrawFormula(&def->spectrum, filed != NULL ? &filed->spectrum : NULL);
    }
    if (waves->replay == NULL && waves->hand == NULL && BeginUiGroup("Method", def->method == SW_WAVES_GERSTNER))
    {
        hasChanged |= DrawMethod(def, filed);
    }
    hasChanged |= TurnMember(swGetWaveSystemFields(), "weight", def, filed);
    hasChanged |= TurnMember(swGetWaveSystemFields(), "chop", def, filed);
    return hasChanged;
}

// Reset and remove. Returns whether the system has left the list.
static bool DrawSystemButtons(App* app, int index, int changes)
{
    SeaWaves* waves = &app->sea.waves[index];
    if (UiButton("remove"))
    {
        RemoveWaves(&app->sea, index);
        return true;
    }
    UiTip("Its waves run down over the time that changes take");
    if (changes > 0 && !waves->isAdded)
    {
        UiSameLine();
        if (UiButton("as in the file"))
        {
            ResetWaves(waves);
        }
    }
    return false;
}

static void DrawRemoved(App* app, int index)
{
    UiFaint("Waves %d of the file: removed", index + 1);
    UiSameLine();
    if (UiSmallButton("bring back") && !BringBackWaves(&app->sea, index))
    {
        ShowNote(app, "they were not brought back; see Messages");
    }
}

static bool DrawWaves(App* app, int index)
{
    SeaWaves* waves = &app->sea.waves[index];
    if (waves->isRemoved)
    {
        DrawRemoved(app, index);
        return false;
    }
    char label[96], state[32] = "";
    int changes = CountWavesChanges(waves);
    if (waves->isAdded || changes > 0)
    {
        snprintf(state, sizeof(state), waves->isAdded ? ", new" : ", %d changed", changes);
    }
    snprintf(label, sizeof(label), "Waves %d: %s%s###waves", index + 1, NameKind(waves), state);
    if (!BeginUiSection(label, index == 0 || waves->isAdded))
    {
        return false;
    }
    if (DrawContents(app, index))
    {
        waves->hasChanged = true;
    }
    return DrawSystemButtons(app, index, changes);
}

void DrawSeaPanel(App* app)
{
    Sea* sea = &app->sea;
    if (BeginUiSection("Wave systems", true))
    {
        DrawSystems(sea);
        DrawAdding(app);
        UiSlider("changes take", &sea->transition, 0.0f, 30.0f, sea->transition > 0.0f ? "%.1f s" : "no time");
        UiTip("How long the sea takes to become what was set, without a jump");
    }
    for (int i = 0; i < sea->wavesCount; i++)
    {
        PushUiScope(sea->waves[i].serial);
        bool isGone = DrawWaves(app, i);
        PopUiScope();
        if (isGone)
        {
            break; // the others are drawn with the next frame
        }
    }
}
