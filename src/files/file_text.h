// SPDX-License-Identifier: MIT
#pragma once

// Whole files into the host's memory.

#include <stdbool.h>
#include <stddef.h>

#include "seaway/base.h"

#define SW_MAX_PATH 4096 // bytes, with its zero

typedef struct swFileText
{
    char* data;
    size_t size;
    size_t capacity;
    bool isPacked; // by gzip, in the file
} swFileText;

// Read a file, unpacking it if it is gzip, whatever its name. More than `limit` bytes are refused.
// SW_ERROR_FILE and a sentence in the log if it cannot be read.
swResult swReadText(const swHost* host, const char* path, size_t limit, swFileText* text);
void swFreeText(const swHost* host, swFileText* text);

// Whether there is a file that can be opened for reading.
bool swHasFile(const char* path);

// Whether a path leads to what has no end of its own, such as a pipe or /dev/zero.
bool swIsDevice(const char* path);

// Whether two paths lead to one file or folder that is there, however they are spelled.
bool swIsSameFile(const char* a, const char* b);

// The folder that a path has before its last slash, empty if there is none.
void swFindFolder(const char* path, char folder[SW_MAX_PATH]);

// Write a whole file so that the one that is there stays whole whatever happens: into a new file beside it, which takes
// its place once all of it is on the disk. Permissions stay; a link leads to the file that is replaced.
// SW_ERROR_FILE and a sentence in the log if it cannot be written.
swResult swWriteText(const swHost* host, const char* path, const char* text, size_t size);
