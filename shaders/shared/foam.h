// SPDX-License-Identifier: MIT
// Foam is born where the surface folds and fades with time: df/dt = growth fold (1 - f) - fadeRate f, which stays
// within [0, 1]. Over one step with the fold constant the solution is exact, so that the result does not depend on the
// rate: n steps of dt are one of n dt.
//
// The fold is max(threshold - J, 0) with J of the whole surface. core/sim/whitecaps.c chooses threshold and growth so
// that the steady state covers as much of the sea as whitecaps do. A slice knows only a part of the waves, and of the
// others how much J varies by them. It grows foam by the fold's expectation. So slices of different fineness hold the
// same mean foam, the coarse one spread thinner, as a mip level would be.
//
// Foam lives at the texels of a view's slices, in rest space, and scrolls as shared/layers.h says.
#ifndef SW_SHARED_FOAM_H
#define SW_SHARED_FOAM_H
#include "layers.h"
#include "types.h"

#ifdef __STDC__
#include <math.h>
#include "core/math/scalar.h"
#define SW_FOAM_EXP swExpF
#define SW_FOAM_SQRT sqrtf
#else
#define SW_FOAM_EXP exp
#define SW_FOAM_SQRT sqrt
#endif

// Waves that a slice does not know, by how much they move J.
SW_PARAMS(swFoamRest)
{
    float deviation; // of J about 1, to first order
    float bend;      // of the measure in which J is Gaussian, in (0, 1]
};
SW_PARAMS_SIZE(swFoamRest, 8);

// Foam of one slice over one frame.
SW_PARAMS(swFoamSliceParams)
{
    swFoamRest rest;
    float threshold;
    float growth;     // per second and unit of fold
    float fadeRate;   // per second
    float dt;         // s
    float start;      // of texels without a past
    sw_uint isSteady; // 1: no texel has a past
    float texel;      // m
    float currentX;   // that carries foam beside the flow, m/s
    float currentZ;
    float unused;
};
SW_PARAMS_SIZE(swFoamSliceParams, 48);

// Foam that inputs and shores make, over one frame, the same for all slices.
SW_PARAMS(swMadeFoamParams)
{
    float wakeFadeRate;  // per second
    float shoreFadeRate; // per second
    float shoreWidth;    // m
    float shoreRate;     // per second
    float dt;            // s
    sw_uint isSteady;    // 1: no texel has a past
    sw_uint isWake;      // 1: what inputs make, 0: what shores make
    float currentX;      // that carries foam beside the flow, m/s
    float currentZ;
};
SW_PARAMS_SIZE(swMadeFoamParams, 36);

// E[max(x + n, 0)] of a standard normal n. The tail is the density over a cubic fitted to the exact ratio: its relative
// error stays below 0.5 % down to x = -5, where foam in a light breeze is decided.
SW_FORMULA float swFoamExcess(float x)
{
    float a = x < 0.0f ? -x : x;
    float tail = 0.39894228f * SW_FOAM_EXP(-0.5f * a * a) / (1.0f + a * (1.20958f + a * (0.67168f + a * 0.032667f)));
    return x < 0.0f ? tail : x + tail;
}

// J itself is skewed: waves that are squeezed already strain less, the more so the more directions they have. With the
// right bend J / (bend + (1 - bend) J) is close to Gaussian, with `bend` times the deviation of J.
SW_FORMULA float swFoamMeasure(float jacobian, float bend)
{
    float j = jacobian < -1.0f ? -1.0f : jacobian;
    return j / (bend + (1.0f - bend) * j);
}

// Expectation of max(threshold - J, 0) for the J that a slice knows.
SW_FORMULA float swFoamFold(float jacobian, float threshold, swFoamRest rest)
{
    float margin = threshold - jacobian;
    if (rest.deviation < 1e-4f)
    {
        return margin > 0.0f ? margin : 0.0f;
    }
    float spread = rest.bend * rest.deviation;
    float inside = swFoamMeasure(threshold, rest.bend) - swFoamMeasure(jacobian, rest.bend);
    // Back from the measure to J: the secant within the fold, the tangent at its edge.
    float root = rest.bend + (1.0f - rest.bend) * threshold;
    float slope = inside > 0.02f ? margin / inside : root * root / rest.bend;
    return slope * spread * swFoamExcess(inside / spread);
}

// ---- foam of the shore ----

// The gentlest slope of the depth from which a distance to the edge is told.
#define SW_SHORE_LEAST_SLOPE 1e-4f
// And the steepest: where a floor ends, the depth runs to infinity as steeply, and there is no shore.
#define SW_SHORE_MOST_SLOPE 10.0f

// How far the water's edge is, m, from the depth of still water and its slopes along x and z: exact over an even slope,
// so that a band of foam is as wide over a steep shore as over a flat one. On land it is 0.
SW_FORMULA float swFindShoreDistance(float depth, float slopeX, float slopeZ)
{
    float steep = SW_FOAM_SQRT(slopeX * slopeX + slopeZ * slopeZ);
    float slope = steep > SW_SHORE_LEAST_SLOPE ? steep : SW_SHORE_LEAST_SLOPE;
    slope = slope < SW_SHORE_MOST_SLOPE ? slope : SW_SHORE_MOST_SLOPE;
    return depth > 0.0f ? depth / slope : 0.0f;
}

// Foam that is born there, per second: `rate` at the edge, none from `width` on, smooth at both ends.
SW_FORMULA float swFindShoreBirth(float distance, float width, float rate)
{
    if (!(distance < width))
    {
        return 0.0f;
    }
    float t = 1.0f - distance / width;
    return rate * t * t * (3.0f - 2.0f * t);
}

// ---- a step ----

// The steady state under a constant birth rate = growth fold.
SW_FORMULA float swFoamSteady(float birth, float fadeRate)
{
    return birth / (birth + fadeRate);
}

SW_FORMULA float swFoamStep(float foam, float birth, float fadeRate, float dt)
{
    float steady = swFoamSteady(birth, fadeRate);
    return foam + (steady - foam) * (1.0f - SW_FOAM_EXP(-(birth + fadeRate) * dt)); // exactly `foam` at dt = 0
}

// Foam that inputs or shores make, after a step. What has no past begins without what inputs make, and with all that
// a shore has in the end.
SW_FORMULA float swMadeFoamStep(float foam, bool hasPast, float birth, swMadeFoamParams params)
{
    if (params.isWake != 0u)
    {
        return swFoamStep(hasPast ? foam : 0.0f, birth, params.wakeFadeRate, params.dt);
    }
    return hasPast ? swFoamStep(foam, birth, params.shoreFadeRate, params.dt)
                   : swFoamSteady(birth, params.shoreFadeRate);
}

// What a texel without a past begins with: the foam that fresh folds make here, over the mean of the sea's. The mean
// is that of the sea or up to twice as much at first: it settles, and patches take the place of the even part, within
// 1 / fadeRate.
SW_FORMULA float swFoamStart(float birth, float fadeRate, float start)
{
    float steady = swFoamSteady(birth, fadeRate);
    return start > steady ? start : steady;
}
#endif
