// SPDX-License-Identifier: MIT

#include "core/math/wide.h"

#include "core/math/fft.inl"

static void RunOperations(const float* pa, const float* pb, const uint32_t* pm, const uint32_t* pn, float* out)
{
    for (int i = 0; i < PROBE_LANES; i += SW_WIDTH)
    {
        swWide a = swLoadW(pa + i);
        swWide b = swLoadW(pb + i);
        swWideI m = swLoadI(pm + i);
        swWideI n = swLoadI(pn + i);
        const swWide results[] = {swAddW(a, b), swSubW(a, b),   swMulW(a, b),  swMinW(a, b),
                                  swMaxW(a, b), swSplatW(0.1f), swToFloatI(m), swFlipSignW(a, m)};
        const swWideI integers[] = {swAddI(m, n),         swSubI(m, n), swAndI(m, n), swShiftLeftI(m, 7),
                                    swShiftRightI(m, 30), swSplatI(77), swMulI(m, n), swAsIntW(swAddW(a, b))};
        int row = 0;
        for (int k = 0; k < 8; ++k)
        {
            swStoreW(out + PROBE_LANES * row++ + i, results[k]);
        }
        for (int k = 0; k < 8; ++k)
        {
            uint32_t lanes[SW_WIDTH];
            swStoreI(lanes, integers[k]);
            memcpy(out + PROBE_LANES * row++ + i, lanes, sizeof lanes);
        }
        // A mask from the lowest bit.
        swWideI mask = swSubI(swSplatI(0), swAndI(m, swSplatI(1)));
        swStoreW(out + PROBE_LANES * row++ + i, swSelectW(mask, a, b));
        swStoreW(out + PROBE_LANES * row++ + i, swAsFloatI(swShiftLeftI(swSplatI(127), 23)));
        swStoreW(out + PROBE_LANES * row++ + i, swExpW(swMulW(swToFloatI(m), swSplatW(0x1p-24f))));
    }
    swQuads left = swLoadQ(pa);
    swQuads right = swLoadQ(pb);
    swStoreQ(out + PROBE_LANES * 19, swAddQ(swMulQ(left, right), swSplatQ(pa[0], pb[0])));
    swStoreSumQ(out + PROBE_LANES * 20, left);
    swStoreSumQ(out + PROBE_LANES * 20 + 4, right);
    // Four rows of four columns, there and back, as many at a time as the width has.
    float table[8 * 4];
    memcpy(table, pa, 8 * sizeof(float));
    memcpy(table + 8, pb, 8 * sizeof(float));
    memcpy(table + 16, pa, 8 * sizeof(float));
    memcpy(table + 24, pb, 8 * sizeof(float));
    float back[8 * 4];
    for (int i = 0; i < 8; i += SW_WIDTH)
    {
        swWide columns[4];
        swLoadColumns4(table + 4 * i, 4, columns);
        swStoreRows4(back + 4 * i, columns[1], columns[0], columns[3], columns[2]);
    }
    memcpy(out + PROBE_LANES * 21, back + 4, PROBE_LANES * sizeof(float));
    // A row of four texels: scaled, added, and folded to two.
    swRow row = swAddR(swScaleR(swLoadR(table), pa[1]), swLoadR(table + 4));
    float texels[16];
    swStoreR(texels, row);
    memcpy(out + PROBE_LANES * 22, texels, sizeof texels);
    swFours fours;
    for (int i = 0; i < 16; i += SW_WIDTH)
    {
        swStoreFours(&fours, i, swLoadW(pa + i % 8), swLoadW(pb + i % 8), swLoadW(pb + i % 8), swLoadW(pa + i % 8));
    }
    swStoreQ(out + PROBE_LANES * 24, swMulQ(swFoldR(row, &fours, 5), swSplatQ(swGetOfFour(&fours, 3, 1), pb[3])));
    swStorePairsQ(out + PROBE_LANES * 25, left, right);
}

static void SinCosTurns(const uint32_t* phases, int count, float* sines, float* cosines)
{
    for (int i = 0; i < count; i += SW_WIDTH)
    {
        swWide s, c;
        swSinCosTurnsW(swLoadI(phases + i), &s, &c);
        swStoreW(sines + i, s);
        swStoreW(cosines + i, c);
    }
}

static void Transpose8(const float* from, int fromStride, float* to, int toStride)
{
    swTranspose8(from, fromStride, to, toStride);
}

static void Transform(int size, bool pruned, const float* from, float* work, float* out)
{
    if (pruned)
    {
        swFftFirstPruned(size, from, work);
    }
    else
    {
        swFftFirst(size, from, work);
    }
    swFftRest(size, work, out);
}
