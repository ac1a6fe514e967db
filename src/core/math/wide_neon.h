// SPDX-License-Identifier: MIT
#pragma once

// The wide float of AArch64: four lanes. Products and sums stay apart (vmulq, vaddq; never vfmaq).

#include <arm_neon.h>

#define SW_WIDTH 4

typedef float32x4_t swWide;
typedef uint32x4_t swWideI;

static inline swWide swLoadW(const float* p)
{
    return vld1q_f32(p);
}

static inline void swStoreW(float* p, swWide a)
{
    vst1q_f32(p, a);
}

static inline swWide swSplatW(float a)
{
    return vdupq_n_f32(a);
}

static inline swWide swAddW(swWide a, swWide b)
{
    return vaddq_f32(a, b);
}

static inline swWide swSubW(swWide a, swWide b)
{
    return vsubq_f32(a, b);
}

static inline swWide swMulW(swWide a, swWide b)
{
    return vmulq_f32(a, b);
}

static inline swWide swDivW(swWide a, swWide b)
{
    return vdivq_f32(a, b);
}

// Compare and select, because vminq treats NaN and signed zeros in a way of its own.
static inline swWide swMinW(swWide a, swWide b)
{
    return vbslq_f32(vcltq_f32(a, b), a, b);
}

static inline swWide swMaxW(swWide a, swWide b)
{
    return vbslq_f32(vcgtq_f32(a, b), a, b);
}

static inline swWideI swLoadI(const uint32_t* p)
{
    return vld1q_u32(p);
}

static inline void swStoreI(uint32_t* p, swWideI a)
{
    vst1q_u32(p, a);
}

static inline swWideI swSplatI(uint32_t a)
{
    return vdupq_n_u32(a);
}

static inline swWideI swAddI(swWideI a, swWideI b)
{
    return vaddq_u32(a, b);
}

static inline swWideI swSubI(swWideI a, swWideI b)
{
    return vsubq_u32(a, b);
}

static inline swWideI swMulI(swWideI a, swWideI b)
{
    return vmulq_u32(a, b);
}

static inline swWide swAsFloatI(swWideI a)
{
    return vreinterpretq_f32_u32(a);
}

static inline swWideI swAsIntW(swWide a)
{
    return vreinterpretq_u32_f32(a);
}

static inline swWideI swAndI(swWideI a, swWideI b)
{
    return vandq_u32(a, b);
}

static inline swWideI swShiftLeftI(swWideI a, int count)
{
    return vshlq_u32(a, vdupq_n_s32(count));
}

static inline swWideI swShiftRightI(swWideI a, int count)
{
    return vshlq_u32(a, vdupq_n_s32(-count));
}

static inline swWide swToFloatI(swWideI a)
{
    return vcvtq_f32_s32(vreinterpretq_s32_u32(a));
}

static inline swWide swSelectW(swWideI mask, swWide a, swWide b)
{
    return vbslq_f32(mask, a, b);
}

static inline swWide swFlipSignW(swWide a, swWideI sign)
{
    uint32x4_t top = vandq_u32(sign, vdupq_n_u32(0x80000000u));
    return vreinterpretq_f32_u32(veorq_u32(vreinterpretq_u32_f32(a), top));
}

// Four by four.
static inline void transposeRows(float32x4_t rows[4])
{
    float32x4x2_t ab = vtrnq_f32(rows[0], rows[1]);
    float32x4x2_t cd = vtrnq_f32(rows[2], rows[3]);
    rows[0] = vcombine_f32(vget_low_f32(ab.val[0]), vget_low_f32(cd.val[0]));
    rows[1] = vcombine_f32(vget_low_f32(ab.val[1]), vget_low_f32(cd.val[1]));
    rows[2] = vcombine_f32(vget_high_f32(ab.val[0]), vget_high_f32(cd.val[0]));
    rows[3] = vcombine_f32(vget_high_f32(ab.val[1]), vget_high_f32(cd.val[1]));
}

static inline void swLoadColumns4(const float* p, int stride, swWide columns[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i] = vld1q_f32(p + i * stride);
    }
    transposeRows(columns);
}

static inline void swStoreRows4(float* p, swWide x, swWide y, swWide z, swWide w)
{
    vst4q_f32(p, ((float32x4x4_t){{x, y, z, w}}));
}

static inline void swTranspose8(const float* from, int fromStride, float* to, int toStride)
{
    for (int row = 0; row < 8; row += 4)
    {
        for (int column = 0; column < 8; column += 4)
        {
            swWide c[4];
            swLoadColumns4(from + row * fromStride + column, fromStride, c);
            for (int i = 0; i < 4; ++i)
            {
                vst1q_f32(to + (column + i) * toStride + row, c[i]);
            }
        }
    }
}

typedef struct swQuads
{
    float32x4_t a, b;
} swQuads;

static inline swQuads swLoadQ(const float* p)
{
    return (swQuads){vld1q_f32(p), vld1q_f32(p + 4)};
}

static inline swQuads swSplatQ(float a, float b)
{
    return (swQuads){vdupq_n_f32(a), vdupq_n_f32(b)};
}

static inline swQuads swAddQ(swQuads a, swQuads b)
{
    return (swQuads){vaddq_f32(a.a, b.a), vaddq_f32(a.b, b.b)};
}

static inline swQuads swMulQ(swQuads a, swQuads b)
{
    return (swQuads){vmulq_f32(a.a, b.a), vmulq_f32(a.b, b.b)};
}

static inline void swStoreQ(float* p, swQuads a)
{
    vst1q_f32(p, a.a);
    vst1q_f32(p + 4, a.b);
}

static inline void swStoreSumQ(float* p, swQuads a)
{
    vst1q_f32(p, vaddq_f32(a.a, a.b));
}

static inline void swStorePairsQ(float* p, swQuads x, swQuads z)
{
    float32x4x2_t pairs = vzipq_f32(vaddq_f32(x.a, x.b), vaddq_f32(z.a, z.b));
    vst1q_f32(p, vcombine_f32(vget_low_f32(pairs.val[0]), vget_low_f32(pairs.val[1])));
    vst1q_f32(p + 4, vcombine_f32(vget_high_f32(pairs.val[0]), vget_high_f32(pairs.val[1])));
}
