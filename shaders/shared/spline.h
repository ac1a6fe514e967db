// SPDX-License-Identifier: MIT
// Uniform cubic B-spline on four neighbours: weights of value and derivative at fraction t in [0, 1).
// The same operations in the same order in C and GLSL; the core's results hang on this order.
#ifndef SW_SHARED_SPLINE_H
#define SW_SHARED_SPLINE_H
#include "types.h"

SW_FORMULA sw_vec4 swSplineWeights(float t)
{
    float s = 1.0f - t;
    float t2 = t * t;
    float s2 = s * s;
    sw_vec4 w;
    w.x = (s2 * s) * (1.0f / 6.0f);
    w.y = (2.0f / 3.0f) - (t2 * (2.0f - t)) * 0.5f;
    w.z = (2.0f / 3.0f) - (s2 * (2.0f - s)) * 0.5f;
    w.w = (t2 * t) * (1.0f / 6.0f);
    return w;
}

SW_FORMULA sw_vec4 swSplineSlopes(float t)
{
    float s = 1.0f - t;
    sw_vec4 w;
    w.x = (s * s) * -0.5f;
    w.y = t * (1.5f * t - 2.0f);
    w.z = s * (2.0f - 1.5f * s);
    w.w = (t * t) * 0.5f;
    return w;
}
#endif
