// SPDX-License-Identifier: MIT

// Complex Fourier transforms along the rows of a panel, for sizes N of 16, 32, 64, 128, 256 and 512:
//   X[k] = sum over n of x[n] exp(2 pi i n k / N), without a factor.
// A panel holds eight independent columns: row n is eight real parts, then eight imaginary parts, one line of the
// cache. Lanes are columns, so no instruction set needs a shuffle and all give the same bits. A panel of 512 rows is 32
// KiB.
//
// Decimation in frequency by four [Gentleman 1966]: after a stage, quarter j of a block holds what leads to the outputs
// that are j modulo 4. The last stage takes four or eight rows at once, needs no twiddles and writes in natural order.
// The first stage is the caller's choice: swFftFirst() for any input, swFftFirstPruned() for one that is zero but for
// bins -N/4 .. N/4 (a band's tile is), which saves half of its reads and sums.
//
// Include after wide.h.

#include <stdbool.h>

#define SW_PANEL_LANES 8
#define SW_PANEL_ROW (2 * SW_PANEL_LANES)
#define SW_FFT_MAX 512

static const float fftTwiddles[2 * SW_FFT_MAX] = {
#include "core/math/fft_twiddles.inl"
};

typedef struct swComplexW
{
    swWide re, im;
} swComplexW;

static inline swComplexW loadComplex(const float* row)
{
    return (swComplexW){swLoadW(row), swLoadW(row + SW_PANEL_LANES)};
}

static inline void storeComplex(float* row, swComplexW a)
{
    swStoreW(row, a.re);
    swStoreW(row + SW_PANEL_LANES, a.im);
}

static inline swComplexW addComplex(swComplexW a, swComplexW b)
{
    return (swComplexW){swAddW(a.re, b.re), swAddW(a.im, b.im)};
}

static inline swComplexW subComplex(swComplexW a, swComplexW b)
{
    return (swComplexW){swSubW(a.re, b.re), swSubW(a.im, b.im)};
}

// a + i b and a - i b.
static inline swComplexW addTurned(swComplexW a, swComplexW b)
{
    return (swComplexW){swSubW(a.re, b.im), swAddW(a.im, b.re)};
}

static inline swComplexW subTurned(swComplexW a, swComplexW b)
{
    return (swComplexW){swAddW(a.re, b.im), swSubW(a.im, b.re)};
}

static inline swComplexW mulComplex(swComplexW a, swComplexW w)
{
    return (swComplexW){swSubW(swMulW(a.re, w.re), swMulW(a.im, w.im)), swAddW(swMulW(a.re, w.im), swMulW(a.im, w.re))};
}

// exp(2 pi i n / size) on all lanes.
static inline swComplexW splatTwiddle(int n, int size)
{
    const float* w = fftTwiddles + 2 * (n * (SW_FFT_MAX / size));
    return (swComplexW){swSplatW(w[0]), swSplatW(w[1])};
}

// Twiddles of one butterfly in a block of `size` rows.
typedef struct swTwiddles
{
    swComplexW w1, w2, w3;
} swTwiddles;

static inline swTwiddles loadTwiddles(int n, int size)
{
    return (swTwiddles){splatTwiddle(n, size), splatTwiddle(2 * n, size), splatTwiddle(3 * n, size)};
}

// Four outputs of a butterfly to rows a quarter of the block apart, times their twiddles unless n is 0.
static inline void storeButterfly(float* row, int quarter, swComplexW y0, swComplexW y1, swComplexW y2, swComplexW y3,
                                  const swTwiddles* w)
{
    float* row1 = row + quarter * SW_PANEL_ROW;
    float* row2 = row1 + quarter * SW_PANEL_ROW;
    float* row3 = row2 + quarter * SW_PANEL_ROW;
    storeComplex(row, y0);
    storeComplex(row1, w ? mulComplex(y1, w->w1) : y1);
    storeComplex(row2, w ? mulComplex(y2, w->w2) : y2);
    storeComplex(row3, w ? mulComplex(y3, w->w3) : y3);
}

static inline void butterfly4(float* row, int quarter, swComplexW x0, swComplexW x1, swComplexW x2, swComplexW x3,
                              const swTwiddles* w)
{
    swComplexW t0 = addComplex(x0, x2);
    swComplexW t1 = subComplex(x0, x2);
    swComplexW t2 = addComplex(x1, x3);
    swComplexW t3 = subComplex(x1, x3);
    storeButterfly(row, quarter, addComplex(t0, t2), addTurned(t1, t3), subComplex(t0, t2), subTurned(t1, t3), w);
}

// The same with x1 = x2 = 0.
static inline void butterfly4Pruned(float* row, int quarter, swComplexW x0, swComplexW x3, const swTwiddles* w)
{
    storeButterfly(row, quarter, addComplex(x0, x3), subTurned(x0, x3), subComplex(x0, x3), addTurned(x0, x3), w);
}

// First stage of a transform of `from`, N rows, into `work`, N rows. They may be the same.
static inline void swFftFirst(int size, const float* from, float* work)
{
    int quarter = size / 4;
    for (int n = 0; n < quarter; ++n)
    {
        swTwiddles w = loadTwiddles(n, size);
        for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
        {
            const float* x = from + n * SW_PANEL_ROW + lane;
            int step = quarter * SW_PANEL_ROW;
            butterfly4(work + n * SW_PANEL_ROW + lane, quarter, loadComplex(x), loadComplex(x + step),
                       loadComplex(x + 2 * step), loadComplex(x + 3 * step), n > 0 ? &w : NULL);
        }
    }
}

// First stage of an input that lives in bins -N/4 .. N/4. `from` has N/2 + 1 rows: bins 0 .. N/4 - 1, then -N/4 .. -1,
// and bin N/4 last.
static inline void swFftFirstPruned(int size, const float* from, float* work)
{
    int quarter = size / 4;
    for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
    {
        swComplexW zero = {swSplatW(0.0f), swSplatW(0.0f)};
        butterfly4(work + lane, quarter, loadComplex(from + lane),
                   loadComplex(from + 2 * quarter * SW_PANEL_ROW + lane), zero,
                   loadComplex(from + quarter * SW_PANEL_ROW + lane), NULL);
    }
    for (int n = 1; n < quarter; ++n)
    {
        swTwiddles w = loadTwiddles(n, size);
        for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
        {
            const float* x = from + n * SW_PANEL_ROW + lane;
            butterfly4Pruned(work + n * SW_PANEL_ROW + lane, quarter, loadComplex(x),
                             loadComplex(x + quarter * SW_PANEL_ROW), &w);
        }
    }
}

// One stage in place: all blocks of `block` rows.
static inline void fftMiddleStage(int size, int block, float* work)
{
    int quarter = block / 4;
    int step = quarter * SW_PANEL_ROW;
    for (int n = 0; n < quarter; ++n)
    {
        swTwiddles w = loadTwiddles(n, block);
        for (int start = n; start < size; start += block)
        {
            for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
            {
                float* x = work + start * SW_PANEL_ROW + lane;
                butterfly4(x, quarter, loadComplex(x), loadComplex(x + step), loadComplex(x + 2 * step),
                           loadComplex(x + 3 * step), n > 0 ? &w : NULL);
            }
        }
    }
}

// Which output the block at `index` begins with: its base-4 digits in reverse. `count` is the number of blocks.
static inline int reverseDigits(int index, int count)
{
    int reversed = 0;
    for (int rest = count; rest > 1; rest /= 4)
    {
        reversed = reversed * 4 + index % 4;
        index /= 4;
    }
    return reversed;
}

static inline void fftLast4(const float* x, float* out, int outStep)
{
    swComplexW x0 = loadComplex(x);
    swComplexW x1 = loadComplex(x + SW_PANEL_ROW);
    swComplexW x2 = loadComplex(x + 2 * SW_PANEL_ROW);
    swComplexW x3 = loadComplex(x + 3 * SW_PANEL_ROW);
    swComplexW t0 = addComplex(x0, x2);
    swComplexW t1 = subComplex(x0, x2);
    swComplexW t2 = addComplex(x1, x3);
    swComplexW t3 = subComplex(x1, x3);
    storeComplex(out, addComplex(t0, t2));
    storeComplex(out + outStep, addTurned(t1, t3));
    storeComplex(out + 2 * outStep, subComplex(t0, t2));
    storeComplex(out + 3 * outStep, subTurned(t1, t3));
}

// Outputs k and k + 4 from the halves' outputs k, the odd half already turned by exp(2 pi i k / 8).
static inline void storeHalves(float* out, int outStep, swComplexW even, swComplexW odd)
{
    storeComplex(out, addComplex(even, odd));
    storeComplex(out + 4 * outStep, subComplex(even, odd));
}

static inline void fftLast8(const float* x, float* out, int outStep)
{
    swComplexW t0, t1, t2, t3;
    {
        swComplexW x1 = loadComplex(x + SW_PANEL_ROW);
        swComplexW x3 = loadComplex(x + 3 * SW_PANEL_ROW);
        swComplexW x5 = loadComplex(x + 5 * SW_PANEL_ROW);
        swComplexW x7 = loadComplex(x + 7 * SW_PANEL_ROW);
        t0 = addComplex(x1, x5);
        t1 = subComplex(x1, x5);
        t2 = addComplex(x3, x7);
        t3 = subComplex(x3, x7);
    }
    swComplexW odd0 = addComplex(t0, t2);
    swComplexW odd2 = subComplex(t0, t2);
    swComplexW a = addTurned(t1, t3);
    swComplexW b = subTurned(t1, t3);
    // Times (1 + i) / sqrt 2, and times (1 - i) / sqrt 2.
    swWide root = swSplatW(0.707106781f);
    swComplexW odd1 = {swMulW(root, swSubW(a.re, a.im)), swMulW(root, swAddW(a.re, a.im))};
    swComplexW odd3 = {swMulW(root, swAddW(b.re, b.im)), swMulW(root, swSubW(b.im, b.re))};

    swComplexW x0 = loadComplex(x);
    swComplexW x2 = loadComplex(x + 2 * SW_PANEL_ROW);
    swComplexW x4 = loadComplex(x + 4 * SW_PANEL_ROW);
    swComplexW x6 = loadComplex(x + 6 * SW_PANEL_ROW);
    t0 = addComplex(x0, x4);
    t1 = subComplex(x0, x4);
    t2 = addComplex(x2, x6);
    t3 = subComplex(x2, x6);
    storeHalves(out, outStep, addComplex(t0, t2), odd0);
    storeHalves(out + outStep, outStep, addTurned(t1, t3), odd1);
    swComplexW even2 = subComplex(t0, t2);
    storeComplex(out + 2 * outStep, addTurned(even2, odd2));
    storeComplex(out + 6 * outStep, subTurned(even2, odd2));
    // (-1 + i) b = -(b.re + b.im) + i (b.re - b.im): odd3 is the negative of it.
    swComplexW even3 = subTurned(t1, t3);
    storeComplex(out + 3 * outStep, subComplex(even3, odd3));
    storeComplex(out + 7 * outStep, addComplex(even3, odd3));
}

// Everything after the first stage: from `work`, which is destroyed, to `out` in natural order.
static inline void swFftRest(int size, float* work, float* out)
{
    int block = size / 4;
    while (block > 8)
    {
        fftMiddleStage(size, block, work);
        block /= 4;
    }
    int count = size / block;
    int outStep = count * SW_PANEL_ROW;
    for (int index = 0; index < count; ++index)
    {
        float* first = out + reverseDigits(index, count) * SW_PANEL_ROW;
        const float* x = work + index * block * SW_PANEL_ROW;
        for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
        {
            if (block == 8)
            {
                fftLast8(x + lane, first + lane, outStep);
            }
            else
            {
                fftLast4(x + lane, first + lane, outStep);
            }
        }
    }
}
