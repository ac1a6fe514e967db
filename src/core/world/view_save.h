// SPDX-License-Identifier: MIT
#pragma once

// Views as bytes, read or written by the same functions.

#include "core/base/stream.h"
#include "core/world/world.h"

// What a view has beside its def and its layers.
typedef struct swViewState
{
    swPos viewpoint, last; // of the next step, of the last one
    bool isPlaced;
    bool hasFields; // there is room for layers on demand
    int scaleLevel;
} swViewState;

void swStreamViewState(swStream* stream, int maxScaleLevel, swViewState* state);
void swSetViewState(swView* view, const swViewState* state);

// All views of a world; those that are read are made. `last`: where each was in the last step.
swResult swStreamViews(swWorld* world, swStream* stream, swPos last[SW_MAX_VIEWS]);
