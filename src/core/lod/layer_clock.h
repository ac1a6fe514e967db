// SPDX-License-Identifier: MIT
#pragma once

// Layers with a past step at a fixed rate, whatever the host's frames: time that is left over waits for the next frame.

#include "core/frame/frame.h"

// What a layer keeps of time between frames.
typedef struct swLayerClock
{
    bool isRunning;    // there is a past
    int64_t remainder; // time not yet stepped, in ticks times the layer's rate
    int64_t clock;     // steps since the start
    uint32_t resetCount;
} swLayerClock;

// Decide the steps of a frame that comes `elapsedTicks` after the one before; negative or more than the layer's longest
// gap is a jump, after which nothing has a past.
void swAdvanceLayerClock(swLayerClock* clock, const swLayerInfo* info, int64_t elapsedTicks, swLayerFrame* frame);

// Steps of a layer that water carries are taken one by one: a third of a second's in a frame. More are taken as so many
// longer ones.
#define SW_MOST_CARRIED_STEPS 10

typedef struct swCarriedSteps
{
    int count;
    float dt; // s, of each
} swCarriedSteps;

// Where a reader's copy of a layer stands that does not see every step, as the GPU's.
typedef struct swLayerMark
{
    bool hasPast;
    int64_t clock;
    uint32_t resetCount;
    swSlice slices[SW_MAX_SLICES]; // where the copy lies
} swLayerMark;

// What the reader has to make up for.
typedef struct swLayerCatchUp
{
    bool isReset;  // nothing has a past
    int64_t steps; // of the layer's rate
    bool isDue;    // steps were taken, or slices have moved
} swLayerCatchUp;

SW_SEAM_BEGIN
swCarriedSteps swFindCarriedSteps(const swLayerInfo* info, int64_t due);
swLayerCatchUp swFindCatchUp(const swLayerMark* mark, int layer, const swStackFrame* stack);
void swMoveMark(swLayerMark* mark, int layer, const swStackFrame* stack); // it has made up for it
SW_SEAM_END
