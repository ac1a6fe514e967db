// SPDX-License-Identifier: MIT
#pragma once

// How the sea's time keeps up with the clock: frames that take longer than the sea may advance at once slow it down,
// and the user is told.

#include <stdbool.h>

// Measured over the last whole span of PACE_SPAN s of the wall's clock.
#define PACE_SPAN 1.5

typedef struct Pace
{
    double wall, sea; // s since the span began
    float ratio;      // of the sea's time to what it should have been; 0 until a span is over
    float frameMs;    // mean of a frame
    int frameCount;
} Pace;

// One frame: it took `wall` s, the clock runs `scale` times as fast as the wall's, and the sea advanced by `sea` s.
void MeasurePace(Pace* pace, double wall, double scale, double sea);

// Time was halted, set or scaled: begin anew.
void ForgetPace(Pace* pace);

// Whether the sea lags by more than a twentieth.
bool IsSeaSlow(const Pace* pace);
