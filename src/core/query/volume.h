// SPDX-License-Identifier: MIT
#pragma once

// The motion of the water below its surface. See volume.c.

#include "core/surface/evaluate.h"

void swRefuseVolume(int count, const swVolumeSamples* samples, swQueryStats* stats);
void swQueryVolume(const swQuery* query, int count, const swPos* points, const swVolumeSamples* samples,
                   swQueryStats* stats);

// Along x and z, at a depth below still water.
swVec2 swFindStokesDrift(const swQuery* query, double depthBelow);
