// SPDX-License-Identifier: MIT
#pragma once

// How much foam a sea has, and where its waves must fold to make as much. See whitecaps.c.

#include "core/frame/frame.h"

// The last law with what it was made from.
typedef struct swWhitecaps
{
    bool isKnown;
    float inputs[16];
    swFoamLaw law;
} swWhitecaps;

// Share of the sea's surface under foam at a wind at 10 m, m/s: zero up to 3.7 m/s, always below 1.
float swGetWhitecapCover(float wind);

// Sets frame->foamLaw from the frame's waves, wind and foam def.
void swFindFoamLaw(swWhitecaps* whitecaps, swFrame* frame);
