// SPDX-License-Identifier: MIT
// Made up for tests: what a wall standing in the water at each texel would look like. It is as wet as the water is high
// above sea level, and dries: w = max(soak, w exp(-dryRate dt)). Exact for a surface that stays over a frame, so that n
// steps of dt are one of n dt, and one of no time changes nothing.
#ifndef SW_SHARED_WETNESS_H
#define SW_SHARED_WETNESS_H
#include "shared/types.h"

#ifdef __STDC__
#include "core/math/scalar.h"
#define SW_WETNESS_EXP swExpF
#else
#define SW_WETNESS_EXP exp
#endif

SW_PARAMS(swWetnessParams)
{
    float soak;    // per metre of height
    float dryRate; // per second
    float dt;      // s
    sw_uint isDry; // 1: no texel has a past
};
SW_PARAMS_SIZE(swWetnessParams, 16);

SW_FORMULA float swWetnessStep(float wetness, float height, float soak, float dryRate, float dt)
{
    float soaked = soak * height;
    soaked = soaked > 1.0f ? 1.0f : soaked;
    float kept = wetness * SW_WETNESS_EXP(-dryRate * dt);
    return dt > 0.0f && soaked > kept ? soaked : kept;
}
#endif
