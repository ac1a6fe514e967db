// SPDX-License-Identifier: MIT
// Foam is born where the surface folds and fades with time: df/dt = gain fold - fadeRate f, kept within [0, 1]. Over one
// step with the fold constant the solution is exact, so that the result does not depend on the rate: n steps of dt are one
// of n dt.
//
// The fold is max(threshold - J, 0) with J of the whole surface. A coarse slice knows only the long waves' part of J; the
// waves that it does not carry add a Gaussian of known deviation, so it grows foam by the fold's expectation. Slices of
// different fineness then hold the same mean foam, the coarse one spread thinner, as a mip level would be.
//
// Foam lives at the texels of a view's slices, in rest space. When slices scroll or the stack's scale changes, a texel
// takes its foam from the stack of the step before: from the same lattice, else from a coarser one (linear between
// texels), else from a finer one (every 2^shift-th texel coincides), else from the steady state.
#ifndef SW_SHARED_FOAM_H
#define SW_SHARED_FOAM_H
#include "types.h"

#ifdef __STDC__
#include "core/math/scalar.h"
#define SW_FOAM_EXP swExpF
#else
#define SW_FOAM_EXP exp
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

// E[max(threshold - J - n, 0)] for n Gaussian with `deviation`: d G(m / d), G(x) = x Phi(x) + phi(x), with Phi
// approximated by a logistic of a cubic, good to 1.4e-4 [Bowling 2009].
SW_FORMULA float swFoamFold(float jacobian, float threshold, float deviation)
{
    float margin = threshold - jacobian;
    if (deviation < 1e-4f || margin > 4.0f * deviation)
    {
        return margin > 0.0f ? margin : 0.0f;
    }
    if (margin < -4.0f * deviation)
    {
        return 0.0f;
    }
    float x = margin / deviation;
    float cumulative = 1.0f / (1.0f + SW_FOAM_EXP(-x * (1.5976f + 0.07056f * x * x)));
    float fold = deviation * (x * cumulative + 0.39894228f * SW_FOAM_EXP(-0.5f * x * x));
    return fold > 0.0f ? fold : 0.0f;
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
