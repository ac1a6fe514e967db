// SPDX-License-Identifier: MIT

// A row of points on a lattice that runs along x: the same sums as sampleTiles(), bit for bit, for a third of the work.
// All points of a row have the same weights along z, so the four texels above each other are added up once a column of
// the tile, and a point is left with four columns instead of sixteen texels. Included after waves_kernels.inl.

// Most columns that are added up for a row. A row that touches more of a tile has fewer than one point a column, and
// gains nothing.
#define MOST_COLUMNS 80

// Some of a tile's columns summed along z, with the weights of value and of slope.
typedef struct Columns
{
    int first;
    float value[MOST_COLUMNS * 4];
    float alongZ[MOST_COLUMNS * 4];
} Columns;

static void sumColumns(const swTile* tile, const float* texels, double z, int count, bool withSlopes, Columns* columns)
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
    const float* row = texels + (size_t)cells.cell[0] * (size_t)pitch4;
    for (int i = 0; i < count; i += 2)
    {
        int column = i + 2 <= count ? i : count - 2; // the last pair of an odd count overlaps the one before
        int texel = columns->first + column;
        texel -= texel > tile->resolution + 1 ? tile->resolution : 0; // beyond the tile it begins again
        const float* window = row + texel * 4;
        swStoreQ(columns->value + column * 4, sumRows(window, pitch4, v0, v1, v2, v3));
        if (withSlopes)
        {
            swStoreQ(columns->alongZ + column * 4, sumRows(window, pitch4, d0, d1, d2, d3));
        }
    }
}

// Columns that the windows of ascending points touch, from the first point's on: all of the tile if they go around it.
// 0 if they are too many.
static int countColumns(const swTile* tile, int count, const double* x)
{
    double span = (x[count - 1] - x[0]) * tile->resolution / tile->side + 6.0;
    int most = tile->resolution + 3 < MOST_COLUMNS ? tile->resolution + 3 : MOST_COLUMNS;
    return span <= most ? (int)span : tile->resolution + 3 <= MOST_COLUMNS ? most : 0;
}

static inline void addPoint(const Columns* columns, int cell, const Weights* w, int i, bool withSlopes,
                            swPointSums* sums)
{
    const float(*v)[16] = w->value;
    const float(*d)[16] = w->slope;
    swQuads left = swLoadQ(columns->value + cell * 4);
    swQuads right = swLoadQ(columns->value + cell * 4 + 8);
    swQuads leftX = swSplatQ(v[0][i], v[1][i]);
    swQuads rightX = swSplatQ(v[2][i], v[3][i]);
    swQuads sum = swAddQ(swMulQ(leftX, left), swMulQ(rightX, right));
    swStoreQ(sums->value, swAddQ(swLoadQ(sums->value), sum));
    if (!withSlopes)
    {
        return;
    }
    sum = swAddQ(swMulQ(swSplatQ(d[0][i], d[1][i]), left), swMulQ(swSplatQ(d[2][i], d[3][i]), right));
    swStoreQ(sums->alongX, swAddQ(swLoadQ(sums->alongX), sum));
    left = swLoadQ(columns->alongZ + cell * 4);
    right = swLoadQ(columns->alongZ + cell * 4 + 8);
    sum = swAddQ(swMulQ(leftX, left), swMulQ(rightX, right));
    swStoreQ(sums->alongZ, swAddQ(swLoadQ(sums->alongZ), sum));
}

// Add one tile to the sums of a row if its points lie close enough. Not inlined, for the sake of the stack.
__attribute__((noinline)) static bool addTileRow(const swTile* tile, const float* texels, int count, const double* x,
                                                 double z, bool withSlopes, swPointSums* sums)
{
    double scale = tile->resolution / tile->side;
    Cells cells;
    Columns columns;
    findCells(x, (count + 15) / 16 * 16, scale, tile->resolution, &cells);
    columns.first = cells.cell[0];
    int columnCount = countColumns(tile, count, x);
    if (columnCount == 0)
    {
        return false;
    }
    sumColumns(tile, texels, z, columnCount, withSlopes, &columns);
    for (int block = 0; block < count; block += 16)
    {
        Weights weights;
        findWeights(cells.fraction + block, &weights);
        if (withSlopes)
        {
            findSlopes(cells.fraction + block, (float)scale, &weights);
        }
        int last = count - block < 16 ? count - block : 16;
        for (int i = 0; i < last; ++i)
        {
            int column = (cells.cell[block + i] - columns.first) & (tile->resolution - 1);
            addPoint(&columns, column, &weights, i, withSlopes, sums + block + i);
        }
    }
    return true;
}

// The same tile, as points that lie anywhere.
__attribute__((noinline)) static void addTileScattered(const swTile* tile, const float* texels, int count,
                                                       const double* x, double z, bool withSlopes, swPointSums* sums)
{
    double u[2 * POINT_BLOCK];
    Cells cells;
    for (int i = 0; i < padToEight(count); ++i)
    {
        u[2 * i] = x[i < count ? i : 0];
        u[2 * i + 1] = z;
    }
    addTile(tile, texels, count, u, withSlopes, &cells, sums);
}

static void sampleRow(const swTileChoice* choice, int count, const double* x, double z, float* out,
                      float (*gradients)[8])
{
    double padded[POINT_BLOCK];
    swPointSums sums[POINT_BLOCK];
    bool withSlopes = gradients != NULL;
    for (int first = 0; first < count; first += POINT_BLOCK)
    {
        int blockCount = count - first < POINT_BLOCK ? count - first : POINT_BLOCK;
        for (int i = 0; i < (blockCount + 15) / 16 * 16; ++i)
        {
            padded[i] = x[first + (i < blockCount ? i : 0)];
        }
        memset(sums, 0, (size_t)blockCount * sizeof(swPointSums));
        for (int i = 0; i < choice->count; ++i)
        {
            const swTile* tile = &choice->tiles[i];
            const float* texels = getFieldTexels(tile, choice->field);
            if (isChosen(choice, i) && !addTileRow(tile, texels, blockCount, padded, z, withSlopes, sums))
            {
                addTileScattered(tile, texels, blockCount, padded, z, withSlopes, sums);
            }
        }
        storeAllSums(blockCount, sums, out + (size_t)first * 4, withSlopes ? gradients[first] : NULL);
    }
}
