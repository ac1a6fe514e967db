// SPDX-License-Identifier: MIT
#pragma once

// The wide float of AVX-512: eight lanes as AVX2 has them, because that is how wide panels of transforms are, in twice
// as many registers. Rows of four texels take one register instead of two. Fused multiply-adds stay unused.

#include "core/math/wide_avx2.h"

#define SW_HAS_ROWS 1

typedef __m512 swRow;

static inline swRow swLoadR(const float* p)
{
    return _mm512_loadu_ps(p);
}

static inline void swStoreR(float* p, swRow a)
{
    _mm512_storeu_ps(p, a);
}

static inline swRow swAddR(swRow a, swRow b)
{
    return _mm512_add_ps(a, b);
}

static inline swRow swScaleR(swRow a, float b)
{
    return _mm512_mul_ps(a, _mm512_set1_ps(b));
}

typedef struct swFours
{
    float v[16][4];
} swFours;

static inline void swStoreFours(swFours* fours, int i, swWide a, swWide b, swWide c, swWide d)
{
    swStoreRows4(fours->v[i], a, b, c, d);
}

static inline float swGetOfFour(const swFours* fours, int i, int which)
{
    return fours->v[i][which];
}

static inline swQuads swFoldR(swRow a, const swFours* fours, int i)
{
    const __m512i each = _mm512_set_epi32(3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0);
    __m512 w = _mm512_permutevar_ps(_mm512_broadcast_f32x4(_mm_loadu_ps(fours->v[i])), each);
    __m512 weighed = _mm512_mul_ps(w, a);
    return _mm256_add_ps(_mm512_castps512_ps256(weighed), _mm512_extractf32x8_ps(weighed, 1));
}
