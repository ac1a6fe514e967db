// SPDX-License-Identifier: MIT
// The share of its amplitude that a wave keeps over a bottom, by k times the depth: tanh, which is 1 to a tenth of a
// percent where the water is deeper than 0.6 wavelengths.
#ifndef SW_SHARED_DEPTH_SHARE_H
#define SW_SHARED_DEPTH_SHARE_H
#include "types.h"

#ifdef __STDC__
#include "core/math/scalar.h"
#define SW_DEPTH_EXP swExpF
#else
#define SW_DEPTH_EXP exp
#endif

SW_FORMULA float swDepthShare(float kd)
{
    float e = SW_DEPTH_EXP(-2.0f * (kd < 20.0f ? kd : 20.0f));
    return (1.0f - e) / (1.0f + e);
}

// Its derivative by kd.
SW_FORMULA float swDepthShareSlope(float share)
{
    return 1.0f - share * share;
}
#endif
