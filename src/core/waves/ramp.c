// SPDX-License-Identifier: MIT
#include "core/waves/ramp.h"

#include <math.h>

#include "core/frame/frame.h"
#include "core/math/scalar.h"

swRamp swMakeConstantRamp(float value)
{
    return (swRamp){.from = value, .to = value};
}

swRamp swMakeRamp(int64_t begin, float from, float to, double seconds)
{
    return (swRamp){
        .from = from,
        .to = to,
        .begin = begin,
        .length = (int64_t)floor(seconds * SW_TICKS_PER_SECOND + 0.5),
    };
}

double swGetRampProgress(const swRamp* ramp, int64_t ticks)
{
    int64_t passed = swGetTicksBetween(ramp->begin, ticks);
    if (ramp->length <= 0 || passed >= ramp->length)
    {
        return 1.0;
    }
    return passed > 0 ? (double)passed / (double)ramp->length : 0.0;
}

bool swIsRampOver(const swRamp* ramp, int64_t ticks)
{
    return swGetRampProgress(ramp, ticks) >= 1.0;
}

float swGetRamp(const swRamp* ramp, int64_t ticks)
{
    float part = (float)swGetRampProgress(ramp, ticks);
    return ramp->from + (ramp->to - ramp->from) * part;
}

float swGetFade(const swRamp* fade, int64_t ticks)
{
    double part = swGetRampProgress(fade, ticks);
    if (part >= 1.0)
    {
        return fade->to;
    }
    float sine, cosine;
    swSinCosTurns((uint32_t)(part * 0x1p30), &sine, &cosine);
    return fade->from * cosine + fade->to * sine;
}
