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
    findCells(places, 8, scale, tile->resolution, cells.cell, cells.fraction);
    fractions[0] = cells.fraction[0];
    Weights weights;
    findWeights(fractions, &weights);
    findSlopes(fractions, (float)scale, &weights);
    const float* row = texels + (size_t)cells.cell[0] * (size_t)pitch4;
    for (int i = 0; i < count; i += 4)
    {
        int column = i + 4 <= count ? i : count - 4; // the last four overlap those before
        int texel = columns->first + column;
        texel -= texel >= tile->resolution ? tile->resolution : 0; // beyond the tile it begins again
        const float* window = row + texel * 4;
        swStoreR(columns->value + column * 4, sumRows(window, pitch4, &weights.value, 0));
        if (withSlopes)
        {
            swStoreR(columns->alongZ + column * 4, sumRows(window, pitch4, &weights.slope, 0));
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

static inline void addPoint(const Columns* columns, int column, const Weights* w, int i, bool withSlopes,
                            swPointSums* sums)
{
    swRow row = swLoadR(columns->value + column * 4);
    swQuads value = swFoldR(row, &w->value, i);
    if (withSlopes)
    {
        swQuads alongX = swFoldR(row, &w->slope, i);
        swQuads alongZ = swFoldR(swLoadR(columns->alongZ + column * 4), &w->value, i);
        addQuads(sums->alongX, alongX);
        addQuads(sums->alongZ, alongZ);
    }
    addQuads(sums->value, value);
}

// Add one tile to the sums of a row if its points lie close enough. Not inlined, for the sake of the stack.
__attribute__((noinline)) static bool addTileRowAt(const swTile* tile, const float* texels, int count, const double* x,
                                                   double z, bool withSlopes, swPointSums* sums)
{
    double scale = tile->resolution / tile->side;
    Cells cells;
    Columns columns;
    findCells(x, (count + 15) / 16 * 16, scale, tile->resolution, cells.cell, cells.fraction);
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

static bool addTileRow(const swTile* tile, const float* texels, int count, const double* x, double z, bool withSlopes,
                       swPointSums* sums)
{
    if (tile->shiftX == 0.0 && tile->shiftZ == 0.0)
    {
        return addTileRowAt(tile, texels, count, x, z, withSlopes, sums);
    }
    double moved[POINT_BLOCK];
    for (int i = 0; i < (count + 15) / 16 * 16; ++i)
    {
        moved[i] = x[i] - tile->shiftX;
    }
    return addTileRowAt(tile, texels, count, moved, z - tile->shiftZ, withSlopes, sums);
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
