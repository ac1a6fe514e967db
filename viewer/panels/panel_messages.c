// SPDX-License-Identifier: MIT
// Errors of the scene file and of Seaway, and the list of keys.

#include "panels.h"

#define SHOWN_MESSAGES 8

static void DrawMessage(const Message* message)
{
    if (message->level == SW_LOG_INFO)
    {
        UiText("%s", message->text);
    }
    else
    {
        UiWarning("%s", message->text);
    }
}

void DrawMessagePanel(App* app)
{
    static Message lines[SHOWN_MESSAGES];
    int count = ReadMessages(&app->messages, lines, SHOWN_MESSAGES);
    if (app->hasSceneFailed)
    {
        int fresh = CountMessages(&app->messages) - app->messagesBefore;
        UiWarning("%s was not read again; the sea before it is shown.", GetSceneName(app));
        for (int i = fresh < count ? count - fresh : 0; i < count; i++)
        {
            DrawMessage(&lines[i]);
        }
        UiSpace();
    }
    if (count == 0 || !BeginUiSection("Messages", false))
    {
        return;
    }
    for (int i = 0; i < count; i++)
    {
        DrawMessage(&lines[i]);
    }
}

void DrawKeyPanel(void)
{
    if (!BeginUiSection("Keys", false))
    {
        return;
    }
#define VIEWER_KEY(keys, text)                                                                                         \
    UiText("%-11s", keys);                                                                                             \
    UiSameLine();                                                                                                      \
    UiFaint("%s", text);
#include "keys.inl"
#undef VIEWER_KEY
}
