// SPDX-License-Identifier: MIT
// Where a layer with a past finds it. When slices scroll or the stack's scale changes, a texel takes its value from the
// stack of the step before: from the same lattice, else from a coarser one (linear between texels), else from a finer
// one (every 2^shift-th texel coincides), else it starts anew.
#ifndef SW_SHARED_LAYERS_H
#define SW_SHARED_LAYERS_H
#include "types.h"

// Sources that a slice may have in the previous stack, in the order to try.
#define SW_PAST_SOURCES 3

// Where a slice's texels were in one slice of the previous stack.
SW_PARAMS(swPastSource)
{
    sw_int slice; // of the previous stack; -1: none
    sw_int shift; // level of the slice minus level of the source: 0 same lattice, < 0 the source is coarser, > 0 finer
    sw_int baseX; // source index of column 0, see swLayerTap
    sw_int baseZ;
    sw_int restX; // source coarser: column 0's offset from the source texel at or below it, in columns
    sw_int restZ;
    sw_int unused0;
    sw_int unused1;
};
SW_PARAMS_SIZE(swPastSource, 32);

// Source index at or below column (or row) `index`.
SW_FORMULA sw_int swLayerTap(sw_int shift, sw_int base, sw_int rest, sw_int index)
{
    return shift < 0 ? base + ((rest + index) >> -shift) : base + index * (1 << shift);
}

// Fraction of the way from that texel to the next, in [0, 1).
SW_FORMULA float swLayerTapFraction(sw_int shift, sw_int rest, sw_int index)
{
    sw_int steps = shift < 0 ? 1 << -shift : 1;
    return shift < 0 ? SW_FLOAT((rest + index) & (steps - 1)) / SW_FLOAT(steps) : 0.0f;
}
#endif
