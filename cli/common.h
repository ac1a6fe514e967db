// SPDX-License-Identifier: MIT
#pragma once

// What the files of the command line share: exit codes, messages, the host that they give to the library, and the
// sea-state keys that are the same in every verb.

#include <stdbool.h>
#include <stdio.h>

#include "seaway/scene.h"

#include "json.h"

// Exit codes of every verb.
#define EXIT_FINE 0
#define EXIT_PROBLEM 1 // ran and found problems
#define EXIT_USAGE 2   // asked for something that cannot be asked

// What --debug shows instead of the picture, by the names of swDebugMode_GetName().
#define DEBUG_MODE_HELP "slices, wireframe, normals, height, jacobian, foam, roughness, or layer:NAME[.CHANNEL][:SLICE]"

// One sentence on stderr, with the program's name before it.
void Complain(const char* format, ...) __attribute__((format(printf, 1, 2)));

// The C library's memory, and messages by way of Complain(). Warnings and errors are counted.
swHost MakeHost(void);

// After a library call failed: the library's log has named the reason; if it has not, this does.
void ComplainAboutResult(swResult result, const char* what);

// Let the host run on `threadCount` threads (0: as many as the machine has). NULL if one is enough or no more start.
swTaskPool* AttachThreads(swHost* host, int threadCount);

// A machine's name: its processor, as the system tells it.
void GetMachineName(char* name, size_t size);

// Standard output has been written, all of it. Complains if not (a full disk, a closed pipe).
bool FinishOutput(void);

// Degrees clockwise from north that waves come from, of a direction where they go (see math.h). In [0, 360).
double BearingFrom(double direction);

// The keys of a sea state that the spectrum alone decides, into the open JSON object.
void WriteSeaState(Json* json, const swSeaState* state);
