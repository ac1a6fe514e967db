// SPDX-License-Identifier: MIT
#pragma once

// The wide float of AVX2: eight lanes. Its fused multiply-add stays unused, for the sake of the same bits.

#include <immintrin.h>

#define SW_WIDTH 8

typedef __m256 swWide;
typedef __m256i swWideI;

static inline swWide swLoadW(const float* p)
{
    return _mm256_loadu_ps(p);
}

static inline void swStoreW(float* p, swWide a)
{
    _mm256_storeu_ps(p, a);
}

static inline swWide swSplatW(float a)
{
    return _mm256_set1_ps(a);
}

static inline swWide swAddW(swWide a, swWide b)
{
    return _mm256_add_ps(a, b);
}

static inline swWide swSubW(swWide a, swWide b)
{
    return _mm256_sub_ps(a, b);
}

static inline swWide swMulW(swWide a, swWide b)
{
    return _mm256_mul_ps(a, b);
}

static inline swWide swDivW(swWide a, swWide b)
{
    return _mm256_div_ps(a, b);
}

static inline swWide swMinW(swWide a, swWide b)
{
    return _mm256_min_ps(a, b);
}

static inline swWide swMaxW(swWide a, swWide b)
{
    return _mm256_max_ps(a, b);
}

static inline swWideI swLoadI(const uint32_t* p)
{
    return _mm256_loadu_si256((const __m256i*)(const void*)p);
}

static inline void swStoreI(uint32_t* p, swWideI a)
{
    _mm256_storeu_si256((__m256i*)(void*)p, a);
}

static inline swWideI swSplatI(uint32_t a)
{
    return _mm256_set1_epi32((int)a);
}

static inline swWideI swAddI(swWideI a, swWideI b)
{
    return _mm256_add_epi32(a, b);
}

static inline swWideI swSubI(swWideI a, swWideI b)
{
    return _mm256_sub_epi32(a, b);
}

static inline swWideI swMulI(swWideI a, swWideI b)
{
    return _mm256_mullo_epi32(a, b);
}

static inline swWide swAsFloatI(swWideI a)
{
    return _mm256_castsi256_ps(a);
}

static inline swWideI swAsIntW(swWide a)
{
    return _mm256_castps_si256(a);
}

static inline swWideI swAndI(swWideI a, swWideI b)
{
    return _mm256_and_si256(a, b);
}

static inline swWideI swShiftLeftI(swWideI a, int count)
{
    return _mm256_slli_epi32(a, count);
}

static inline swWideI swShiftRightI(swWideI a, int count)
{
    return _mm256_srli_epi32(a, count);
}

static inline swWide swToFloatI(swWideI a)
{
    return _mm256_cvtepi32_ps(a);
}

static inline swWide swSelectW(swWideI mask, swWide a, swWide b)
{
    return _mm256_blendv_ps(b, a, _mm256_castsi256_ps(mask));
}

static inline swWide swFlipSignW(swWide a, swWideI sign)
{
    return _mm256_xor_ps(a, _mm256_and_ps(_mm256_castsi256_ps(sign), _mm256_set1_ps(-0.0f)));
}

// Rows n and n + 4 share a register.
static inline __m256 loadHalves(const float* low, const float* high)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}

// The transpose of four by four floats in each half.
static inline void transposeHalves(__m256 rows[4])
{
    __m256 ab0 = _mm256_unpacklo_ps(rows[0], rows[1]);
    __m256 ab1 = _mm256_unpackhi_ps(rows[0], rows[1]);
    __m256 cd0 = _mm256_unpacklo_ps(rows[2], rows[3]);
    __m256 cd1 = _mm256_unpackhi_ps(rows[2], rows[3]);
    rows[0] = _mm256_shuffle_ps(ab0, cd0, 0x44);
    rows[1] = _mm256_shuffle_ps(ab0, cd0, 0xee);
    rows[2] = _mm256_shuffle_ps(ab1, cd1, 0x44);
    rows[3] = _mm256_shuffle_ps(ab1, cd1, 0xee);
}

static inline void swLoadColumns4(const float* p, int stride, swWide columns[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i] = loadHalves(p + i * stride, p + (i + 4) * stride);
    }
    transposeHalves(columns);
}

static inline void swStoreRows4(float* p, swWide x, swWide y, swWide z, swWide w)
{
    __m256 rows[4] = {x, y, z, w};
    transposeHalves(rows);
    _mm256_storeu_ps(p, _mm256_permute2f128_ps(rows[0], rows[1], 0x20));
    _mm256_storeu_ps(p + 8, _mm256_permute2f128_ps(rows[2], rows[3], 0x20));
    _mm256_storeu_ps(p + 16, _mm256_permute2f128_ps(rows[0], rows[1], 0x31));
    _mm256_storeu_ps(p + 24, _mm256_permute2f128_ps(rows[2], rows[3], 0x31));
}

static inline void swTranspose8(const float* from, int fromStride, float* to, int toStride)
{
    for (int half = 0; half < 8; half += 4)
    {
        swWide columns[4];
        swLoadColumns4(from + half, fromStride, columns);
        for (int i = 0; i < 4; ++i)
        {
            _mm256_storeu_ps(to + (half + i) * toStride, columns[i]);
        }
    }
}

typedef __m256 swQuads;

static inline swQuads swLoadQ(const float* p)
{
    return _mm256_loadu_ps(p);
}

static inline swQuads swSplatQ(float a, float b)
{
    return _mm256_blend_ps(_mm256_set1_ps(a), _mm256_set1_ps(b), 0xf0);
}

static inline swQuads swAddQ(swQuads a, swQuads b)
{
    return _mm256_add_ps(a, b);
}

static inline swQuads swMulQ(swQuads a, swQuads b)
{
    return _mm256_mul_ps(a, b);
}

static inline void swStoreQ(float* p, swQuads a)
{
    _mm256_storeu_ps(p, a);
}

static inline void swStoreSumQ(float* p, swQuads a)
{
    _mm_storeu_ps(p, _mm_add_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1)));
}

static inline void swStorePairsQ(float* p, swQuads x, swQuads z)
{
    __m128 sumX = _mm_add_ps(_mm256_castps256_ps128(x), _mm256_extractf128_ps(x, 1));
    __m128 sumZ = _mm_add_ps(_mm256_castps256_ps128(z), _mm256_extractf128_ps(z, 1));
    __m128 low = _mm_unpacklo_ps(sumX, sumZ), high = _mm_unpackhi_ps(sumX, sumZ);
    _mm_storeu_ps(p, _mm_movelh_ps(low, high));
    _mm_storeu_ps(p + 4, _mm_movehl_ps(high, low));
}
