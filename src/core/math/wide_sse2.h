// SPDX-License-Identifier: MIT
#pragma once

// The wide float of every x86-64 processor: four lanes.

#include <emmintrin.h>

#define SW_WIDTH 4

typedef __m128 swWide;
typedef __m128i swWideI;

static inline swWide swLoadW(const float* p)
{
    return _mm_loadu_ps(p);
}

static inline void swStoreW(float* p, swWide a)
{
    _mm_storeu_ps(p, a);
}

static inline swWide swSplatW(float a)
{
    return _mm_set1_ps(a);
}

static inline swWide swAddW(swWide a, swWide b)
{
    return _mm_add_ps(a, b);
}

static inline swWide swSubW(swWide a, swWide b)
{
    return _mm_sub_ps(a, b);
}

static inline swWide swMulW(swWide a, swWide b)
{
    return _mm_mul_ps(a, b);
}

static inline swWide swDivW(swWide a, swWide b)
{
    return _mm_div_ps(a, b);
}

static inline swWide swMinW(swWide a, swWide b)
{
    return _mm_min_ps(a, b);
}

static inline swWide swMaxW(swWide a, swWide b)
{
    return _mm_max_ps(a, b);
}

static inline swWideI swLoadI(const uint32_t* p)
{
    return _mm_loadu_si128((const __m128i*)(const void*)p);
}

static inline void swStoreI(uint32_t* p, swWideI a)
{
    _mm_storeu_si128((__m128i*)(void*)p, a);
}

static inline swWideI swSplatI(uint32_t a)
{
    return _mm_set1_epi32((int)a);
}

static inline swWideI swAddI(swWideI a, swWideI b)
{
    return _mm_add_epi32(a, b);
}

static inline swWideI swSubI(swWideI a, swWideI b)
{
    return _mm_sub_epi32(a, b);
}

static inline swWideI swMulI(swWideI a, swWideI b)
{
    __m128i even = _mm_mul_epu32(a, b);
    __m128i odd = _mm_mul_epu32(_mm_srli_si128(a, 4), _mm_srli_si128(b, 4));
    return _mm_unpacklo_epi32(_mm_shuffle_epi32(even, 0x08), _mm_shuffle_epi32(odd, 0x08));
}

static inline swWide swAsFloatI(swWideI a)
{
    return _mm_castsi128_ps(a);
}

static inline swWideI swAsIntW(swWide a)
{
    return _mm_castps_si128(a);
}

static inline swWideI swAndI(swWideI a, swWideI b)
{
    return _mm_and_si128(a, b);
}

static inline swWideI swShiftLeftI(swWideI a, int count)
{
    return _mm_slli_epi32(a, count);
}

static inline swWideI swShiftRightI(swWideI a, int count)
{
    return _mm_srli_epi32(a, count);
}

static inline swWide swToFloatI(swWideI a)
{
    return _mm_cvtepi32_ps(a);
}

static inline swWide swSelectW(swWideI mask, swWide a, swWide b)
{
    __m128 m = _mm_castsi128_ps(mask);
    return _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b));
}

static inline swWide swFlipSignW(swWide a, swWideI sign)
{
    return _mm_xor_ps(a, _mm_and_ps(_mm_castsi128_ps(sign), _mm_set1_ps(-0.0f)));
}

static inline void swLoadColumns4(const float* p, int stride, swWide columns[4])
{
    __m128 a = _mm_loadu_ps(p);
    __m128 b = _mm_loadu_ps(p + stride);
    __m128 c = _mm_loadu_ps(p + 2 * stride);
    __m128 d = _mm_loadu_ps(p + 3 * stride);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    columns[0] = a;
    columns[1] = b;
    columns[2] = c;
    columns[3] = d;
}

static inline void swStoreRows4(float* p, swWide x, swWide y, swWide z, swWide w)
{
    _MM_TRANSPOSE4_PS(x, y, z, w);
    _mm_storeu_ps(p, x);
    _mm_storeu_ps(p + 4, y);
    _mm_storeu_ps(p + 8, z);
    _mm_storeu_ps(p + 12, w);
}

static inline void swTranspose8(const float* from, int fromStride, float* to, int toStride)
{
    for (int row = 0; row < 8; row += 4)
    {
        for (int column = 0; column < 8; column += 4)
        {
            swWide c[4];
            swLoadColumns4(from + row * fromStride + column, fromStride, c);
            float* out = to + column * toStride + row;
            _mm_storeu_ps(out, c[0]);
            _mm_storeu_ps(out + toStride, c[1]);
            _mm_storeu_ps(out + 2 * toStride, c[2]);
            _mm_storeu_ps(out + 3 * toStride, c[3]);
        }
    }
}

typedef struct swQuads
{
    __m128 a, b;
} swQuads;

static inline swQuads swLoadQ(const float* p)
{
    return (swQuads){_mm_loadu_ps(p), _mm_loadu_ps(p + 4)};
}

static inline swQuads swSplatQ(float a, float b)
{
    return (swQuads){_mm_set1_ps(a), _mm_set1_ps(b)};
}

static inline swQuads swAddQ(swQuads a, swQuads b)
{
    return (swQuads){_mm_add_ps(a.a, b.a), _mm_add_ps(a.b, b.b)};
}

static inline swQuads swMulQ(swQuads a, swQuads b)
{
    return (swQuads){_mm_mul_ps(a.a, b.a), _mm_mul_ps(a.b, b.b)};
}

static inline void swStoreQ(float* p, swQuads a)
{
    _mm_storeu_ps(p, a.a);
    _mm_storeu_ps(p + 4, a.b);
}

static inline void swStoreSumQ(float* p, swQuads a)
{
    _mm_storeu_ps(p, _mm_add_ps(a.a, a.b));
}

static inline void swStorePairsQ(float* p, swQuads x, swQuads z)
{
    __m128 sumX = _mm_add_ps(x.a, x.b), sumZ = _mm_add_ps(z.a, z.b);
    __m128 low = _mm_unpacklo_ps(sumX, sumZ), high = _mm_unpackhi_ps(sumX, sumZ);
    _mm_storeu_ps(p, _mm_movelh_ps(low, high));
    _mm_storeu_ps(p + 4, _mm_movehl_ps(high, low));
}
