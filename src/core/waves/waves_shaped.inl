// SPDX-License-Identifier: MIT

// Tiles whose waves are shaped by where they are: see core/surface/evaluate_shaped.c. Included after waves_kernels.inl.

// Points that go through a tile together.
#define SHAPED_POINTS 8

// The next points of which anything counts. A point of which nothing does costs nothing. Returns the point to go on
// with.
static int listShaped(const swTile* tile, int first, int count, const swPosXZ* points, const swTileShape* shape,
                      bool withSlopes, int* which, double* u, int* some)
{
    *some = 0;
    for (; first < count && *some < SHAPED_POINTS; ++first)
    {
        which[*some] = first;
        u[2 * *some] = points[first].x - tile->shiftX;
        u[2 * *some + 1] = points[first].z - tile->shiftZ;
        bool hasSlopes = withSlopes && (shape->alongX[first] != 0.0f || shape->alongZ[first] != 0.0f);
        *some += shape->weight[first] != 0.0f || hasSlopes ? 1 : 0;
    }
    for (int i = *some; i < SHAPED_POINTS; ++i)
    {
        u[2 * i] = u[2 * i + 1] = 0.0;
    }
    return first;
}

// Chain rule, then product rule.
static inline void addShaped(const swTileShape* shape, int point, WindowSums own, swPointSums* sums)
{
    if (shape->way != NULL)
    {
        const float* way = shape->way[point];
        swQuads alongX = swAddQ(swMulQ(own.alongX, swSplatQ(1.0f + way[0], 1.0f + way[0])),
                                swMulQ(own.alongZ, swSplatQ(way[2], way[2])));
        own.alongZ = swAddQ(swMulQ(own.alongX, swSplatQ(way[1], way[1])),
                            swMulQ(own.alongZ, swSplatQ(1.0f + way[3], 1.0f + way[3])));
        own.alongX = alongX;
    }
    swQuads weight = swSplatQ(shape->weight[point], shape->weight[point]);
    swQuads x = swSplatQ(shape->alongX[point], shape->alongX[point]);
    swQuads z = swSplatQ(shape->alongZ[point], shape->alongZ[point]);
    addQuads(sums->value, swMulQ(weight, own.value));
    addQuads(sums->alongX, swAddQ(swMulQ(weight, own.alongX), swMulQ(x, own.value)));
    addQuads(sums->alongZ, swAddQ(swMulQ(weight, own.alongZ), swMulQ(z, own.value)));
}

static inline void addShapedValue(const swTileShape* shape, int point, swQuads value, swPointSums* sums)
{
    addQuads(sums->value, swMulQ(swSplatQ(shape->weight[point], shape->weight[point]), value));
}

static void addShapedTile(const swTile* tile, int field, int count, const swPosXZ* points, const swTileShape* shape,
                          bool withSlopes, swPointSums* sums)
{
    const float* texels = getFieldTexels(tile, field);
    double scale = tile->resolution / tile->side;
    int pitch4 = (tile->resolution + 3) * 4;
    int which[SHAPED_POINTS], some;
    double u[2 * SHAPED_POINTS];
    int32_t cell[2 * SHAPED_POINTS];
    float fraction[2 * SHAPED_POINTS];
    for (int next = 0; next < count;)
    {
        next = listShaped(tile, next, count, points, shape, withSlopes, which, u, &some);
        if (some == 0)
        {
            return;
        }
        Weights weights;
        findCells(u, 2 * SHAPED_POINTS, scale, tile->resolution, cell, fraction);
        findWeights(fraction, &weights);
        if (withSlopes)
        {
            findSlopes(fraction, (float)scale, &weights);
        }
        for (int i = 0; i < some; ++i)
        {
            const float* window = texels + (size_t)cell[2 * i + 1] * (size_t)pitch4 + (size_t)cell[2 * i] * 4;
            int point = which[i];
            if (withSlopes)
            {
                addShaped(shape, point, sumWindow(window, pitch4, &weights, 2 * i, 2 * i + 1), &sums[point]);
            }
            else
            {
                swRow rows = sumRows(window, pitch4, &weights.value, 2 * i + 1);
                addShapedValue(shape, point, swFoldR(rows, &weights.value, 2 * i), &sums[point]);
            }
        }
    }
}

// ---- what the depth leaves ----

static inline swWide clampW(swWide x, float most)
{
    return swMinW(swMaxW(x, swSplatW(0.0f)), swSplatW(most));
}

// swFindDepthShare() without a branch: its blends begin with 0 and end with 1, each exactly.
static void findDepthShares(swAttenuation law, float k, int count, const float* depths, float* shares, float* slopes)
{
    const swWide one = swSplatW(1.0f), three = swSplatW(3.0f), six = swSplatW(6.0f);
    const swWide strength = swSplatW(law.strength);
    for (int i = 0; i < count; i += SW_WIDTH)
    {
        swWide depth = swMinW(swLoadW(depths + i), swSplatW(1e30f)); // none is infinite
        swWide kd = clampW(swMulW(swSplatW(k), depth), SW_DEEP_KD);
        swWide e = swExpW(swMulW(swSplatW(-2.0f), kd));
        swWide t = swDivW(swSubW(one, e), swAddW(one, e));
        swWide slope = swSubW(one, swMulW(t, t));
        swWide share = t;
        const swWide ends[2] = {swDivW(swSubW(kd, swSplatW(SW_BLEND_KD)), swSplatW(SW_DEEP_KD - SW_BLEND_KD)),
                                swMulW(depth, swSplatW(law.perFreeDepth))};
        const float perDepth[2] = {1.0f / (SW_DEEP_KD - SW_BLEND_KD), law.perFreeDepth};
        for (int b = 0; b < 2; ++b)
        {
            swWide part = clampW(ends[b], 1.0f);
            swWide rest = swSubW(one, share);
            swWide blend = swMulW(swMulW(part, part), swSubW(three, swAddW(part, part)));
            swWide blendSlope = swMulW(swMulW(swMulW(six, part), swSubW(one, part)), swSplatW(perDepth[b]));
            slope = swAddW(swMulW(slope, swSubW(one, blend)), swMulW(rest, blendSlope));
            slope = b == 0 ? swMulW(slope, swSplatW(k)) : slope;
            share = swAddW(share, swMulW(rest, blend));
        }
        swStoreW(slopes + i, swMulW(strength, slope));
        swStoreW(shares + i, swSubW(one, swMulW(strength, swSubW(one, share))));
    }
}
