// SPDX-License-Identifier: MIT
#pragma once

// The verbs of the command line, each in its cmd_x.c. Each is listed in main.c.

#include "common.h"

// A verb gets its own arguments: arguments[0] is its name.
typedef int VerbFcn(int argumentCount, char** arguments);

VerbFcn RunView, RunRender, RunQuery, RunStats, RunSpectrum, RunCheck, RunBench, RunDevices, RunBake;
