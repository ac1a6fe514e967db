// SPDX-License-Identifier: MIT
#include "messages.h"

#include <stdio.h>

#include "text.h"

#define LONGEST_LINE 10000 // of the library's messages, which hold a path

void OpenMessages(Messages* messages)
{
    *messages = (Messages){0};
    pthread_mutex_init(&messages->mutex, NULL);
}

void CloseMessages(Messages* messages)
{
    pthread_mutex_destroy(&messages->mutex);
}

void WriteMessage(void* context, swLogLevel level, const char* text)
{
    Messages* messages = context;
    pthread_mutex_lock(&messages->mutex);
    Message* line = &messages->lines[messages->count % MAX_MESSAGES];
    line->level = level;
    snprintf(line->text, sizeof(line->text), "%s", text);
    messages->count++;
    pthread_mutex_unlock(&messages->mutex);
    if (level != SW_LOG_INFO)
    {
        char shown[LONGEST_LINE];
        fprintf(stderr, "seaway: %s\n", CopyPrintable(shown, sizeof(shown), text));
    }
}

int ReadMessages(Messages* messages, Message* lines, int capacity)
{
    pthread_mutex_lock(&messages->mutex);
    int kept = messages->count < MAX_MESSAGES ? messages->count : MAX_MESSAGES;
    int count = kept < capacity ? kept : capacity;
    for (int i = 0; i < count; i++)
    {
        lines[i] = messages->lines[(messages->count - count + i) % MAX_MESSAGES];
    }
    pthread_mutex_unlock(&messages->mutex);
    return count;
}

int CountMessages(Messages* messages)
{
    pthread_mutex_lock(&messages->mutex);
    int count = messages->count;
    pthread_mutex_unlock(&messages->mutex);
    return count;
}
