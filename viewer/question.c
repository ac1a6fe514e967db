// SPDX-License-Identifier: MIT
#include "question.h"

#include <stdio.h>

bool MayProceed(Asked* question, Asked wish, int changeCount)
{
    bool isYes = changeCount == 0 || *question == wish;
    *question = isYes ? ASKED_NOTHING : wish;
    return isYes;
}

void WriteQuestion(Asked question, int changeCount, const char* fileName, char* text, size_t size)
{
    char values[96];
    snprintf(values, sizeof(values), changeCount == 1 ? "There is %d change from %s" : "There are %d changes from %s",
             changeCount, fileName);
    switch (question)
    {
    case ASKED_QUIT:
        snprintf(text, size, "%s. Quitting loses what you changed; Ctrl+S saves it.", values);
        break;
    case ASKED_FOLLOW_FILE:
        snprintf(text, size, "The file has changed on disk. %s, and reading it loses what you changed.", values);
        break;
    default:
        snprintf(text, size, "%s. Reading the file again loses what you changed; Ctrl+S saves it.", values);
        break;
    }
}

const char* GetYes(Asked question)
{
    return question == ASKED_QUIT ? "quit (Esc)" : "read the file (R)";
}

const char* GetNo(Asked question)
{
    return question == ASKED_QUIT ? "stay" : "keep mine";
}
