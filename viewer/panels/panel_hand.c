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
    static const char* const members[4] = {"wavelength", "amplitude", "direction", "phase"};
    static const char* const labels[4] = {"##length", "##height", "##from", "##phase"};
    bool hasChanged = false;
    for (int i = 0; i < 4; i++)
    {
        const swField* field = swFields_Find(swGetWaveComponentFields(), members[i]);
        const char* other = (const char*)filed;
        NextCell(filed, i == 0);
        hasChanged |=
            TurnValue(field, labels[i], (char*)wave + field->offset, other != NULL ? other + field->offset : NULL);
    }
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
