// SPDX-License-Identifier: MIT
#pragma once

// What would drop the user's tuning is asked first. Asking a second time for the same is a yes.

#include <stdbool.h>
#include <stddef.h>

typedef enum Asked
{
    ASKED_NOTHING,
    ASKED_RELOAD,      // the user wants the file again
    ASKED_FOLLOW_FILE, // the file has changed on disk
    ASKED_QUIT
} Asked;

// Whether to go on at once: nothing has changed, or the same was asked for while the question stood. Else the question
// stands now.
bool MayProceed(Asked* question, Asked wish, int changeCount);

// The question in words, and the answers.
void WriteQuestion(Asked question, int changeCount, const char* fileName, char* text, size_t size);
const char* GetYes(Asked question);
const char* GetNo(Asked question);
