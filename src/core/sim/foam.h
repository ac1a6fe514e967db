// SPDX-License-Identifier: MIT
#pragma once

// Foam on a view's slices: shared/foam.h has the law and the rule for scrolling. The GPU's twin is
// shaders/sim/foam.comp.

#include "core/base/field.h"
#include "core/frame/frame.h"

extern const swFields swFoamFields;

// What one view's foam keeps between steps.
typedef struct swFoamClock
{
    bool isRunning;    // there is a past
    int64_t remainder; // time not yet stepped, in ticks times SW_FOAM_RATE
    int64_t clock;     // steps since the start
    uint32_t resetCount;
} swFoamClock;

// Decide the foam steps of a frame that comes `elapsedTicks` after the one before; negative or more than
// SW_LONGEST_FOAM_GAP seconds is a jump. Fills the
// clocks of the view frame.
#define SW_LONGEST_FOAM_GAP 1.0
void swPlanFoam(swFoamClock* state, int64_t elapsedTicks, swViewFrame* view);

// Take the steps: from `previous` to `next`, [slice][R][R] each.
void swStepFoam(const swHost* host, const swFrame* frame, const swViewFrame* view, const float* previous, float* next);
