// SPDX-License-Identifier: MIT

// A row of points on a lattice that runs along x: the same sums as sampleTiles(), bit for bit, for a third of the work.
// All points of a row have the same weights along z, so the four texels above each other are added up once a column of
// the tile, and a point is left with four columns instead of sixteen texels. Included after waves_kernels.inl.

#include "shared/limits.h"

// The tile's columns summed along z, with the weights of value and of slope.
typedef struct Columns
{
    float value[(SW_LIMIT_RESOLUTION + 3) * 4];
    float alongZ[(SW_LIMIT_RESOLUTION + 3) * 4];
} Columns;

static void sumColumns(const swTile* tile, double z, int first, int count, Columns* columns)
{
    int pitch4 = (tile->resolution + 3) * 4;
    double scale = tile->resolution / tile->side;
    Cells cells;
    const double places[8] = {z, z, z, z, z, z, z, z};
    float fractions[16] = {0.0f};
    findCells(places, 8, scale, tile->resolution, &cells);
    fractions[0] = cells.fraction[0];
    Weights weights;
    findWeights(fractions, &weights);
    findSlopes(fractions, (float)scale, &weights);
    const Weights* w = &weights;
    const float(*v)[16] = w->value;
    const float(*d)[16] = w->slope;
    swQuads v0 = SPLAT(v[0], 0), v1 = SPLAT(v[1], 0), v2 = SPLAT(v[2], 0), v3 = SPLAT(v[3], 0);
    swQuads d0 = SPLAT(d[0], 0), d1 = SPLAT(d[1], 0), d2 = SPLAT(d[2], 0), d3 = SPLAT(d[3], 0);
    const float* row = tile->texels + (size_t)cells.cell[0] * (size_t)pitch4;
    for (int i = 0; i < count; i += 2)
    {
        int column = first + (i + 2 <= count ? i : count - 2); // the last pair of an odd count overlaps the one before
        const float* window = row + column * 4;
        swStoreQ(columns->value + column * 4, sumRows(window, pitch4, v0, v1, v2, v3));
        swStoreQ(columns->alongZ + column * 4, sumRows(window, pitch4, d0, d1, d2, d3));
    }
}

// Columns that the windows of ascending points touch: of a part of the tile, or all.
static void findColumns(const swTile* tile, int count, const double* x, int firstCell, int* first, int* columnCount)
{
    int span = (int)((x[count - 1] - x[0]) * tile->resolution / tile->side) + 6;
    bool isPart = firstCell + span <= tile->resolution + 3;
    *first = isPart ? firstCell : 0;
    *columnCount = isPart ? span : tile->resolution + 3;
}

static inline void addPoint(const Columns* columns, int cell, const Weights* w, int i, PointSums* sums)
{
    const float(*v)[16] = w->value;
    const float(*d)[16] = w->slope;
    swQuads left = swLoadQ(columns->value + cell * 4);
    swQuads right = swLoadQ(columns->value + cell * 4 + 8);
    swQuads leftX = swSplatQ(v[0][i], v[1][i]);
    swQuads rightX = swSplatQ(v[2][i], v[3][i]);
    swQuads sum = swAddQ(swMulQ(leftX, left), swMulQ(rightX, right));
    swStoreQ(sums->value, swAddQ(swLoadQ(sums->value), sum));
    sum = swAddQ(swMulQ(swSplatQ(d[0][i], d[1][i]), left), swMulQ(swSplatQ(d[2][i], d[3][i]), right));
    swStoreQ(sums->alongX, swAddQ(swLoadQ(sums->alongX), sum));
    left = swLoadQ(columns->alongZ + cell * 4);
    right = swLoadQ(columns->alongZ + cell * 4 + 8);
    sum = swAddQ(swMulQ(leftX, left), swMulQ(rightX, right));
    swStoreQ(sums->alongZ, swAddQ(swLoadQ(sums->alongZ), sum));
}

static void addTileRow(const swTile* tile, int count, const double* x, double z, Cells* cells, PointSums* sums)
{
    double scale = tile->resolution / tile->side;
    Columns columns;
    int first, columnCount;
    findCells(x, (count + 15) / 16 * 16, scale, tile->resolution, cells);
    findColumns(tile, count, x, cells->cell[0], &first, &columnCount);
    sumColumns(tile, z, first, columnCount, &columns);
    for (int block = 0; block < count; block += 16)
    {
        Weights weights;
        findWeights(cells->fraction + block, &weights);
        findSlopes(cells->fraction + block, (float)scale, &weights);
        int last = count - block < 16 ? count - block : 16;
        for (int i = 0; i < last; ++i)
        {
            addPoint(&columns, cells->cell[block + i], &weights, i, sums + block + i);
        }
    }
}

static void sampleRow(int tileCount, const swTile* tiles, int count, const double* x, double z, float* out,
                      float (*gradients)[8])
{
    double padded[2 * POINT_BLOCK];
    Cells cells;
    PointSums sums[POINT_BLOCK];
    for (int first = 0; first < count; first += POINT_BLOCK)
    {
        int blockCount = count - first < POINT_BLOCK ? count - first : POINT_BLOCK;
        for (int i = 0; i < (blockCount + 15) / 16 * 16; ++i)
        {
            padded[i] = x[first + (i < blockCount ? i : 0)];
        }
        memset(sums, 0, (size_t)blockCount * sizeof(PointSums));
        for (int tile = 0; tile < tileCount; ++tile)
        {
            addTileRow(tiles + tile, blockCount, padded, z, &cells, sums);
        }
        for (int i = 0; i < blockCount; ++i)
        {
            storeSums(&sums[i], out + (size_t)(first + i) * 4, gradients[first + i]);
        }
    }
}
