// SPDX-License-Identifier: MIT
#pragma once

// The wide float: as many floats as the instruction set holds in a register. A kernel is written once on it, in an
// .inl, and compiled once per instruction set by a small .c that defines SW_WIDE_ISA before including this. Every
// flavour does the same operations on each lane in the same order, and none of them contracts a product and a sum; so a
// kernel gives the same bits in all of them as long as it keeps lanes apart.
//
//   swWide   SW_WIDTH floats                    swWideI  SW_WIDTH 32-bit integers
//   swQuads  two groups of four floats, whatever SW_WIDTH is: for texels of four floats, two at a time
//   swRow    four groups of four floats: a row of a tile's window; swFours, weights for its groups

#define SW_WIDE_SCALAR 1
#define SW_WIDE_SSE2 2
#define SW_WIDE_AVX2 3
#define SW_WIDE_NEON 4
#define SW_WIDE_AVX512 5

#ifndef SW_WIDE_ISA
#error "Define SW_WIDE_ISA before including wide.h"
#endif

#include <stdint.h>
#include <string.h>

#include "core/math/turns.h"

#if SW_WIDE_ISA == SW_WIDE_SCALAR
#include "core/math/wide_scalar.h"
#elif SW_WIDE_ISA == SW_WIDE_SSE2
#include "core/math/wide_sse2.h"
#elif SW_WIDE_ISA == SW_WIDE_AVX2
#include "core/math/wide_avx2.h"
#elif SW_WIDE_ISA == SW_WIDE_NEON
#include "core/math/wide_neon.h"
#elif SW_WIDE_ISA == SW_WIDE_AVX512
#include "core/math/wide_avx512.h"
#endif

#ifndef SW_HAS_ROWS
typedef struct swRow
{
    swQuads left, right;
} swRow;

static inline swRow swLoadR(const float* p)
{
    return (swRow){swLoadQ(p), swLoadQ(p + 8)};
}

static inline void swStoreR(float* p, swRow a)
{
    swStoreQ(p, a.left);
    swStoreQ(p + 8, a.right);
}

static inline swRow swAddR(swRow a, swRow b)
{
    return (swRow){swAddQ(a.left, b.left), swAddQ(a.right, b.right)};
}

static inline swRow swScaleR(swRow a, float b)
{
    return (swRow){swMulQ(a.left, swSplatQ(b, b)), swMulQ(a.right, swSplatQ(b, b))};
}

// Sixteen times four weights, laid out as folds like it.
typedef struct swFours
{
    float v[4][16];
} swFours;

static inline void swStoreFours(swFours* fours, int i, swWide a, swWide b, swWide c, swWide d)
{
    swStoreW(fours->v[0] + i, a);
    swStoreW(fours->v[1] + i, b);
    swStoreW(fours->v[2] + i, c);
    swStoreW(fours->v[3] + i, d);
}

static inline float swGetOfFour(const swFours* fours, int i, int which)
{
    return fours->v[which][i];
}

// Each group times its weight of four, the last two added to the first two.
static inline swQuads swFoldR(swRow a, const swFours* fours, int i)
{
    const float(*v)[16] = fours->v;
    return swAddQ(swMulQ(swSplatQ(v[0][i], v[1][i]), a.left), swMulQ(swSplatQ(v[2][i], v[3][i]), a.right));
}
#endif

// swSinCosTurns on all lanes.
static inline void swSinCosTurnsW(swWideI phase, swWide* sine, swWide* cosine)
{
    swWideI quadrant = swShiftRightI(swAddI(phase, swSplatI(0x20000000u)), 30);
    swWide x = swMulW(swToFloatI(swSubI(phase, swShiftLeftI(quadrant, 30))), swSplatW(SW_TURNS_TO_RADIANS));
    swWide x2 = swMulW(x, x);

    swWide s = swMulW(x2, swSplatW(SW_SINE_9));
    s = swMulW(x2, swSubW(swSplatW(SW_SINE_7), s));
    s = swMulW(x2, swSubW(swSplatW(SW_SINE_5), s));
    s = swMulW(x2, swSubW(swSplatW(SW_SINE_3), s));
    s = swSubW(x, swMulW(x, s));

    swWide c = swMulW(x2, swSplatW(SW_COSINE_8));
    c = swMulW(x2, swSubW(swSplatW(SW_COSINE_6), c));
    c = swMulW(x2, swSubW(swSplatW(SW_COSINE_4), c));
    c = swMulW(x2, swSubW(swSplatW(SW_COSINE_2), c));
    c = swSubW(swSplatW(1.0f), c);

    // Odd quadrants swap; the second half of the circle is negative, for the cosine a quarter earlier.
    swWideI one = swSplatI(1);
    swWideI odd = swSubI(swSplatI(0), swAndI(quadrant, one));
    *sine = swFlipSignW(swSelectW(odd, c, s), swShiftLeftI(quadrant, 30));
    *cosine = swFlipSignW(swSelectW(odd, s, c), swShiftLeftI(swAddI(quadrant, one), 30));
}

// exp(x) for x in [-87, 80], below which it stays at exp(-87); 2 ulp. Cephes' reduction: x = n ln 2 + r, with ln 2 in
// two parts so that r is exact.
static inline swWide swExpW(swWide x)
{
    const float round = 12582912.0f; // 1.5 * 2^23: adding it leaves the nearest integer in the low bits
    x = swMaxW(swMinW(x, swSplatW(80.0f)), swSplatW(-87.0f));
    swWide shifted = swAddW(swMulW(x, swSplatW(1.44269504f)), swSplatW(round));
    swWide n = swSubW(shifted, swSplatW(round));
    swWide r = swSubW(swSubW(x, swMulW(n, swSplatW(0.693359375f))), swMulW(n, swSplatW(-2.12194440e-4f)));
    swWide sum = swSplatW(1.0f / 5040.0f);
    sum = swAddW(swMulW(sum, r), swSplatW(1.0f / 720.0f));
    sum = swAddW(swMulW(sum, r), swSplatW(1.0f / 120.0f));
    sum = swAddW(swMulW(sum, r), swSplatW(1.0f / 24.0f));
    sum = swAddW(swMulW(sum, r), swSplatW(1.0f / 6.0f));
    sum = swAddW(swMulW(sum, r), swSplatW(0.5f));
    sum = swAddW(swSplatW(1.0f), swAddW(r, swMulW(sum, swMulW(r, r))));
    swWideI power = swShiftLeftI(swAddI(swAsIntW(shifted), swSplatI(127)), 23);
    return swMulW(sum, swAsFloatI(power));
}
