// SPDX-License-Identifier: MIT
#pragma once

// Files that appear whole or not at all: written beside their place under a temporary name, then renamed. A link is
// followed, and what it leads to is replaced. What is no regular file, such as a device or a FIFO, stays what it is:
// the finished bytes are copied into it at the end.

#include <stdbool.h>
#include <sys/types.h>

#define MAX_PATH_LENGTH 4096 // with its zero, as the kernel has it

typedef struct OutputFile
{
    const char* name;                // as it was given, for messages; outlives the file
    char finalPath[MAX_PATH_LENGTH]; // links followed
    char path[MAX_PATH_LENGTH];      // write here
    bool isCopied;                   // into what is there, rather than renamed
} OutputFile;

// Makes the temporary file, empty. Complains if the file could not be written in the end, and says why.
// One at a time; if the program is interrupted meanwhile, the temporary file goes.
bool BeginOutput(OutputFile* output, const char* path);

// Give the file its name, or drop it if it was not written well.
bool EndOutput(OutputFile* output, bool isWritten);

// Whether BeginOutput() would succeed: for finding it out before long work.
bool ProbeOutput(const char* path);

// The process that writes into the temporary file, or 0: an interrupt ends it too.
void SetOutputProcess(pid_t process);

// Make a folder if there is none. Its parent must exist. Complains, also if nothing can be written into it.
bool MakeFolder(const char* path);

// Whether there is something at the path that is neither a regular file nor a folder: a device, a FIFO, a socket, or
// what a process has open, such as /dev/stdout.
bool IsDevice(const char* path);

bool HasEnding(const char* path, const char* ending);
