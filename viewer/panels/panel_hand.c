// SPDX-License-Identifier: MIT
// Waves by hand: a row each, which come and go.

#include "panels.h"

// The next cell of a row that the file does not have: a slot for a mark, as wide as those of other rows.
static void NextCell(const swWaveComponent* filed, bool isFirst)
{
    UiNextCell();
    if (filed == NULL)
    {
        UiMarkNext(isFirst, "This wave is not in the file");
    }
}

static bool DrawHandWave(swWaveComponent* wave, const swWaveComponent* filed)
{
    NextCell(filed, true);
    bool hasChanged = TurnKnob(&(Knob){.label = "##length",
                                       .low = 0.0625f,
                                       .high = 4096.0f,
                                       .format = "%.3g",
                                       .isLogarithmic = true,
                                       .tip = "wavelength, m"},
                               &wave->wavelength, filed != NULL ? &filed->wavelength : NULL);
    NextCell(filed, false);
    hasChanged |= TurnKnob(&(Knob){.label = "##height",
                                   .low = 1e-3f,
                                   .high = 40.0f,
                                   .format = "%.3g",
                                   .isLogarithmic = true,
                                   .tip = "amplitude, half the height, m"},
                           &wave->amplitude, filed != NULL ? &filed->amplitude : NULL);
    NextCell(filed, false);
    hasChanged |= TurnKnob(&(Knob){.label = "##from",
                                   .high = 360.0f,
                                   .format = "%.0f",
                                   .isBearing = true,
                                   .tip = "where it comes from, degrees clockwise from north"},
                           &wave->direction, filed != NULL ? &filed->direction : NULL);
    NextCell(filed, false);
    hasChanged |= TurnKnob(&(Knob){.label = "##phase",
                                   .low = -360.0f,
                                   .high = 360.0f,
                                   .format = "%.0f",
                                   .unit = DEGREE,
                                   .tip = "phase at the origin at time 0, degrees"},
                           &wave->phase, filed != NULL ? &filed->phase : NULL);
    return hasChanged;
}

// What the buttons behind a row ask for: 1 another row, -1 this one away.
static int DrawRowButtons(bool isOnly)
{
    int wish = 0;
    UiNextCell();
    wish = UiSmallButton("+") ? 1 : wish;
    UiTip("Another wave like this one");
    if (!isOnly)
    {
        UiSameLine();
        wish = UiSmallButton("-") ? -1 : wish;
        UiTip("Take this wave away");
    }
    return wish;
}

bool DrawHandWaves(App* app, int index)
{
    static const UiColumn columns[] = {{"length", 0.0f}, {"ampl.", 0.0f}, {"from", 0.0f}, {"phase", 0.0f}, {"", 6.0f}};
    SeaWaves* waves = &app->sea.waves[index];
    HandWaves* hand = waves->hand;
    bool hasChanged = false;
    int wish = 0, wishedRow = 0, first = 0, end = 0;
    UiText("%d wave%s, m and degrees", waves->def.componentCount, waves->def.componentCount == 1 ? "" : "s");
    if (BeginUiTable("rows", 5, columns))
    {
        BeginUiRows(waves->def.componentCount);
        while (StepUiRows(&first, &end))
        {
            for (int i = first; i < end; i++)
            {
                int filed = hand->filedRows[i];
                PushUiScope(i);
                hasChanged |= DrawHandWave(&hand->waves[i], filed >= 0 ? &hand->filed[filed] : NULL);
                int asked = DrawRowButtons(waves->def.componentCount == 1);
                PopUiScope();
                wishedRow = asked != 0 ? i : wishedRow;
                wish = asked != 0 ? asked : wish;
            }
        }
        EndUiTable();
    }
    if (wish > 0 && !AddRow(&app->sea, index, wishedRow))
    {
        ShowNote(app, "a world has %d waves by hand at most", SW_MAX_FREE_WAVES);
    }
    if (wish < 0)
    {
        RemoveRow(&app->sea, index, wishedRow);
    }
    int missing = CountMissingRows(waves);
    if (missing > 0)
    {
        UiFaint("%d of the file's removed", missing);
        UiSameLine();
        if (UiSmallButton("bring back"))
        {
            BringBackRows(&app->sea, index);
        }
    }
    return hasChanged;
}
