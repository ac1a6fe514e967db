// SPDX-License-Identifier: MIT
// Foam is born where the surface folds and fades with time: df/dt = gain fold - fadeRate f, kept within [0, 1]. Over one
// step with the fold constant the solution is exact, so that the result does not depend on the rate: n steps of dt are one
// of n dt.
//
// The fold is max(threshold - J, 0) with J of the whole surface. A coarse slice knows only the long waves' part of J; of
// the others it knows how much J varies by them, so it grows foam by the fold's expectation. Slices of
// different fineness then hold the same mean foam, the coarse one spread thinner, as a mip level would be.
//
// Foam lives at the texels of a view's slices, in rest space. When slices scroll or the stack's scale changes, a texel
// takes its foam from the stack of the step before: from the same lattice, else from a coarser one (linear between
// texels), else from a finer one (every 2^shift-th texel coincides), else from the steady state.
#ifndef SW_SHARED_FOAM_H
#define SW_SHARED_FOAM_H
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

// Sources that a slice may have in the previous stack, in the order to try.
#define SW_FOAM_SOURCES 3

// Where a slice's texels were in one slice of the previous stack.
SW_PARAMS(swFoamSource)
{
    sw_int slice; // of the previous stack; -1: none
    sw_int shift; // level of the slice minus level of the source: 0 same lattice, < 0 the source is coarser, > 0 finer
    sw_int baseX; // source index of column 0, see swFoamTap
    sw_int baseZ;
    sw_int restX; // source coarser: column 0's offset from the source texel at or below it, in columns
    sw_int restZ;
    sw_int unused0;
    sw_int unused1;
};
SW_PARAMS_SIZE(swFoamSource, 32);

// Source index at or below column (or row) `index`.
SW_FORMULA sw_int swFoamTap(sw_int shift, sw_int base, sw_int rest, sw_int index)
{
    return shift < 0 ? base + ((rest + index) >> -shift) : base + index * (1 << shift);
}

// Fraction of the way from that texel to the next, in [0, 1).
SW_FORMULA float swFoamTapFraction(sw_int shift, sw_int rest, sw_int index)
{
    sw_int steps = shift < 0 ? 1 << -shift : 1;
    return shift < 0 ? SW_FLOAT((rest + index) & (steps - 1)) / SW_FLOAT(steps) : 0.0f;
}

// E[max(x + n, 0)] of a standard normal n. The tail is the density over a cubic fitted to the exact ratio: its relative
// error stays below 0.5 % down to x = -5, where foam in a light breeze is decided.
SW_FORMULA float swFoamExcess(float x)
{
    float a = x < 0.0f ? -x : x;
    float tail = 0.39894228f * SW_FOAM_EXP(-0.5f * a * a) / (1.0f + a * (1.20958f + a * (0.67168f + a * 0.032667f)));
    return x < 0.0f ? tail : x + tail;
}

// J to the power 3/4, J >= 0.
SW_FORMULA float swFoamMeasure(float jacobian)
{
    float root = SW_FOAM_SQRT(jacobian);
    return root * SW_FOAM_SQRT(root);
}

// Expectation of max(threshold - J, 0) for the J that a slice knows and waves it does not carry, of which J has
// `deviation`. J itself is skewed: waves that are squeezed already strain less. J^(3/4) is close to Gaussian: with it,
// slices whose shortest wave is 0.25 to 32 m expect the fold of the whole sea within 25 % (measured, JONSWAP, 10 to
// 20 m/s); with J the coarse ones expect fifteen times as much.
SW_FORMULA float swFoamFold(float jacobian, float threshold, float deviation)
{
    float margin = threshold - jacobian;
    if (deviation < 1e-4f || jacobian <= 0.0f)
    {
        return margin > 0.0f ? margin : 0.0f;
    }
    float spread = 0.75f * deviation;
    float edge = swFoamMeasure(threshold);
    float inside = edge - swFoamMeasure(jacobian);
    // Back from the measure to J: the secant within the fold, the derivative 4/3 threshold^(1/4) at its edge.
    float slope = inside > 0.02f * edge ? margin / inside : 4.0f / 3.0f * SW_FOAM_SQRT(SW_FOAM_SQRT(threshold));
    return slope * spread * swFoamExcess(inside / spread);
}

// keep = exp(-fadeRate dt); grow = gain (1 - keep) / fadeRate.
SW_FORMULA float swFoamStep(float foam, float fold, float keep, float grow)
{
    float next = foam * keep + fold * grow;
    return next < 1.0f ? next : 1.0f;
}

// The steady state under a constant fold; ceiling = gain / fadeRate.
SW_FORMULA float swFoamSteady(float fold, float ceiling)
{
    float foam = fold * ceiling;
    return foam < 1.0f ? foam : 1.0f;
}
#endif
