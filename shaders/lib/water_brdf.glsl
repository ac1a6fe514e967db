// SPDX-License-Identifier: MIT
// Reflection by a rough sea: a normal distribution of slopes around a mean, as [Ross 2005] and [Bruneton 2010].
// Slopes are dh/dx and dh/dz; a facet of slope s has the normal (-s.x, 1, -s.y) normalised. The two axes have variances
// of their own and no correlation.
#ifndef SW_LIB_WATER_BRDF
#define SW_LIB_WATER_BRDF
#include "shared/fresnel.h"

vec3 facetNormal(vec2 slope)
{
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// Standard normal distribution function, to 1e-3 (logistic form).
float normalBelow(float x)
{
    return 1.0 / (1.0 + exp(-x * (1.5976 + 0.070566 * x * x)));
}

// Area of facets that face `to`, projected towards it, per level area: the mean of max(0, to.y - slope . to.xz). For a
// level sea seen from high up it is to.y.
float facingArea(vec3 to, vec2 slope, vec2 variance)
{
    float mean = to.y - dot(slope, to.xz);
    float deviation = sqrt(max(dot(to.xz * to.xz, variance), 1e-8));
    float x = mean / deviation;
    return max(mean * normalBelow(x) + deviation * 0.39894228 * exp(-0.5 * x * x), 1e-4);
}

// Sunlight reflected towards `view`, for unit illuminance. Facets between slope and slope + ds fill p(s) ds of the
// level area, and half vectors map to slopes with the Jacobian 4 (v . h) h.y^3.
float sunGlitter(vec3 view, vec3 sun, vec2 slope, vec2 variance, float area, float index)
{
    vec3 h = normalize(view + sun);
    if (h.y <= 0.05)
    {
        return 0.0;
    }
    vec2 away = -h.xz / h.y - slope;
    float exponent = -0.5 * dot(away * away, 1.0 / variance);
    float density = exp(exponent) / (6.2831853 * sqrt(variance.x * variance.y));
    // Facets that see the sun over their neighbours.
    float lit = max(sun.y, 0.0) / facingArea(sun, vec2(0.0), variance);
    float h2 = h.y * h.y;
    return swFresnel(dot(view, h), index) * density * min(lit, 1.0) / (4.0 * h2 * h2 * area);
}
#endif
