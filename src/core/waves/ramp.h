// SPDX-License-Identifier: MIT
#pragma once

// A value that runs from one number to another over a time.

#include <stdbool.h>
#include <stdint.h>

typedef struct swRamp
{
    float from, to;
    int64_t begin, length; // ticks
} swRamp;

swRamp swMakeConstantRamp(float value);
swRamp swMakeRamp(int64_t begin, float from, float to, double seconds);

// How far a ramp has come, 0 to 1.
double swGetRampProgress(const swRamp* ramp, int64_t ticks);
bool swIsRampOver(const swRamp* ramp, int64_t ticks);
float swGetRamp(const swRamp* ramp, int64_t ticks);

// The same along a quarter of a sine: what comes and what goes have squares that add up to one.
float swGetFade(const swRamp* fade, int64_t ticks);
