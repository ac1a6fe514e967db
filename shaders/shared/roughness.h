// SPDX-License-Identifier: MIT
// How rough the sea is beyond the waves that any band holds. Slopes of the whole sea under a wind are known from the
// sun's glitter [Cox 1954]: 0.003 + 0.00512 U, upwind and crosswind together, U in m/s. What the bands do not have of
// that is ripples, which become part of the glitter's width.
#ifndef SW_SHARED_ROUGHNESS_H
#define SW_SHARED_ROUGHNESS_H
#include "types.h"

// Ripples below the shortest band hold a fifth of the sea's slopes at least.
#define SW_RIPPLE_SHARE 0.2f

SW_FORMULA float swSeaSlopeVariance(float windSpeed)
{
    return 0.003f + 5.12e-3f * windSpeed;
}

// Slope variance of ripples, of each of two axes; `resolved` is that of all bands, both axes together.
SW_FORMULA float swRippleVariance(float windSpeed, float resolved)
{
    float total = swSeaSlopeVariance(windSpeed);
    float missing = total - resolved;
    return 0.5f * (missing > SW_RIPPLE_SHARE * total ? missing : SW_RIPPLE_SHARE * total);
}
#endif
