// SPDX-License-Identifier: MIT
#pragma once

// Files that appear whole or not at all: written beside their place under a temporary name, then renamed.

#include <stdbool.h>

#define MAX_PATH_LENGTH 1024

typedef struct OutputFile
{
    char finalPath[MAX_PATH_LENGTH];
    char path[MAX_PATH_LENGTH + 64]; // write here
} OutputFile;

// Makes the temporary file, empty. Complains if the folder is missing or cannot be written to.
// One at a time; if the program is interrupted meanwhile, the temporary file goes.
bool BeginOutput(OutputFile* output, const char* finalPath);

// Give the file its name, or drop it if it was not written well.
bool EndOutput(OutputFile* output, bool isWritten);

// Make a folder if there is none. Its parent must exist.
bool MakeFolder(const char* path);

bool HasEnding(const char* path, const char* ending);
