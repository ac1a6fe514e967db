// SPDX-License-Identifier: MIT
#pragma once

// The wide float of plain C: one lane. What the other flavours are held against.

#define SW_WIDTH 1

typedef float swWide;
typedef uint32_t swWideI;

static inline swWide swLoadW(const float* p)
{
    return *p;
}

static inline void swStoreW(float* p, swWide a)
{
    *p = a;
}

static inline swWide swSplatW(float a)
{
    return a;
}

static inline swWide swAddW(swWide a, swWide b)
{
    return a + b;
}

static inline swWide swSubW(swWide a, swWide b)
{
    return a - b;
}

static inline swWide swMulW(swWide a, swWide b)
{
    return a * b;
}

static inline swWide swDivW(swWide a, swWide b)
{
    return a / b;
}

// The second operand where one is NaN.
static inline swWide swMinW(swWide a, swWide b)
{
    return a < b ? a : b;
}

static inline swWide swMaxW(swWide a, swWide b)
{
    return a > b ? a : b;
}

static inline swWideI swLoadI(const uint32_t* p)
{
    return *p;
}

static inline void swStoreI(uint32_t* p, swWideI a)
{
    *p = a;
}

static inline swWideI swSplatI(uint32_t a)
{
    return a;
}

static inline swWideI swAddI(swWideI a, swWideI b)
{
    return a + b;
}

static inline swWideI swSubI(swWideI a, swWideI b)
{
    return a - b;
}

// Low 32 bits of the products.
static inline swWideI swMulI(swWideI a, swWideI b)
{
    return a * b;
}

// The same bits.
static inline swWide swAsFloatI(swWideI a)
{
    float f;
    memcpy(&f, &a, sizeof f);
    return f;
}

static inline swWideI swAsIntW(swWide a)
{
    uint32_t u;
    memcpy(&u, &a, sizeof u);
    return u;
}

static inline swWideI swAndI(swWideI a, swWideI b)
{
    return a & b;
}

// Logical shifts by a constant.
static inline swWideI swShiftLeftI(swWideI a, int count)
{
    return a << count;
}

static inline swWideI swShiftRightI(swWideI a, int count)
{
    return a >> count;
}

// Signed integers to the nearest floats.
static inline swWide swToFloatI(swWideI a)
{
    return (float)(int32_t)a;
}

// a where mask is all ones, b where it is 0.
static inline swWide swSelectW(swWideI mask, swWide a, swWide b)
{
    return mask ? a : b;
}

// Negate where the top bit is set.
static inline swWide swFlipSignW(swWide a, swWideI sign)
{
    return (sign & 0x80000000u) ? -a : a;
}

// SW_WIDTH rows of four floats, `stride` floats apart, into four columns.
static inline void swLoadColumns4(const float* p, int stride, swWide columns[4])
{
    (void)stride;
    memcpy(columns, p, 4 * sizeof(float));
}

// The inverse, rows packed: x y z w, x y z w, ...
static inline void swStoreRows4(float* p, swWide x, swWide y, swWide z, swWide w)
{
    p[0] = x;
    p[1] = y;
    p[2] = z;
    p[3] = w;
}

// Eight rows of eight floats to their transpose; strides in floats.
static inline void swTranspose8(const float* from, int fromStride, float* to, int toStride)
{
    for (int row = 0; row < 8; ++row)
    {
        for (int column = 0; column < 8; ++column)
        {
            to[column * toStride + row] = from[row * fromStride + column];
        }
    }
}

typedef struct swQuads
{
    float v[8];
} swQuads;

static inline swQuads swLoadQ(const float* p)
{
    swQuads a;
    memcpy(a.v, p, sizeof a.v);
    return a;
}

// a four times, then b four times.
static inline swQuads swSplatQ(float a, float b)
{
    return (swQuads){{a, a, a, a, b, b, b, b}};
}

static inline swQuads swAddQ(swQuads a, swQuads b)
{
    for (int i = 0; i < 8; ++i)
    {
        a.v[i] = a.v[i] + b.v[i];
    }
    return a;
}

static inline swQuads swMulQ(swQuads a, swQuads b)
{
    for (int i = 0; i < 8; ++i)
    {
        a.v[i] = a.v[i] * b.v[i];
    }
    return a;
}

static inline void swStoreQ(float* p, swQuads a)
{
    memcpy(p, a.v, sizeof a.v);
}

// The first group plus the second: four floats.
static inline void swStoreSumQ(float* p, swQuads a)
{
    for (int i = 0; i < 4; ++i)
    {
        p[i] = a.v[i] + a.v[i + 4];
    }
}

// The same of two, in pairs of which the second and the third are swapped: x0 z0 x2 z2 x1 z1 x3 z3.
static inline void swStorePairsQ(float* p, swQuads x, swQuads z)
{
    static const int order[4] = {0, 2, 1, 3};
    for (int i = 0; i < 4; ++i)
    {
        p[2 * i] = x.v[order[i]] + x.v[order[i] + 4];
        p[2 * i + 1] = z.v[order[i]] + z.v[order[i] + 4];
    }
}
