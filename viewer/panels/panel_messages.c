// SPDX-License-Identifier: MIT
// Errors of the scene file and of Seaway, and the list of keys.

#include "panels.h"

#define SHOWN_MESSAGES 8

void DrawMessagePanel(App* app)
{
    static Message lines[SHOWN_MESSAGES];
    int count = ReadMessages(&app->messages, lines, SHOWN_MESSAGES);
    if (app->hasSceneFailed)
    {
        UiWarning("%s was not read again; the sea before it is shown.", app->options.scenePath);
    }
    if (count == 0 || !BeginUiSection("Messages", app->hasSceneFailed))
    {
        return;
    }
    for (int i = 0; i < count; i++)
    {
        if (lines[i].level == SW_LOG_INFO)
        {
            UiText("%s", lines[i].text);
        }
        else
        {
            UiWarning("%s", lines[i].text);
        }
    }
}

void DrawKeyPanel(void)
{
    if (!BeginUiSection("Keys", false))
    {
        return;
    }
#define VIEWER_KEY(keys, text)                                                                                         \
    UiText("%-12s", keys);                                                                                             \
    UiSameLine();                                                                                                      \
    UiFaint("%s", text);
#include "keys.inl"
#undef VIEWER_KEY
}
