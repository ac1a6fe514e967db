// SPDX-License-Identifier: MIT
#pragma once

// Foam on a view's slices: shared/foam.h has the law and the rule for scrolling. The GPU's twin is shaders/sim/foam.comp.

#include "core/frame/frame.h"

// What one view's foam keeps between steps.
typedef struct swFoamState
{
    bool isRunning;    // there is a past
    int64_t remainder; // time not yet stepped, in ticks times SW_FOAM_RATE
    int64_t clock;     // steps since the start
    uint32_t resetCount;
} swFoamState;

// Decide the foam steps of a frame that comes `elapsedTicks` after the one before; negative or more than
// SW_LONGEST_FOAM_GAP seconds is a jump. Fills the foam fields of the view frame but its layers.
#define SW_LONGEST_FOAM_GAP 1.0
void swPlanFoam(swFoamState* state, int64_t elapsedTicks, swViewFrame* view);

// How much J varies at a place by waves that a slice does not carry: the deviation of the sum of tiles shorter than
// minWavelength. To first order J = 1 + dDx/dx + dDz/dz.
float swGetFoamDeviation(const swFrame* frame, float minWavelength);

// Mean foam of the steady state where no wave is known: what the sea beyond the slices is drawn with.
float swGetFoamAtRest(const swFrame* frame);

// Take the steps: from `previous` to `next`, [slice][R][R] each.
void swStepFoam(const swHost* host, const swFoamDef* def, const swViewFrame* view, const float* previous, float* next);
