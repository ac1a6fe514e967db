// SPDX-License-Identifier: MIT

// A band's tile at a time, and its spline at points. Written on the wide float and compiled per instruction set.
//
// A tile is three real fields: horizontal displacements X and Z, height H. Their spectra are conjugate-symmetric, so
// that half a plane says all. The first axis transforms x for bins qz >= 0 of each real field: lanes are qz. What it
// leaves, T(qz, x), obeys T(-qz, x) = conj T(qz, x), so that two real fields make one complex transform along z: lanes
// are x, and
//   G(qz, x) = Ta(qz, x) + i Tb(qz, x),  G(-qz, x) = conj Ta(qz, x) + i conj Tb(qz, x)
// is formed as the second axis reads its first rows. X and Z of a tile go together, and the heights of two tiles.
// Both axes see bins -N/4 .. N/4 only. The second works on eight columns at a time, in 24 KiB of the nearest cache for
// N = 128, and ends in texels.

#include "core/math/fft.inl"
#include "shared/spline.h"

// Real fields of a pair of tiles.
enum
{
    FIELD_AX,
    FIELD_AZ,
    FIELD_AH,
    FIELD_BX,
    FIELD_BZ,
    FIELD_BH,
    FIELD_COUNT
};

#define ROW_BYTES (SW_PANEL_ROW * sizeof(float))
#define MODE_CHUNK 64

// Where things lie in a worker's scratch.
typedef struct Scratch
{
    int size;         // N
    int panelCount;   // of a field's first axis
    float* panels;    // [FIELD_COUNT][panelCount][N] rows: spectra, then T in place
    float* columns;   // [FIELD_COUNT][N/4 + 8 and more] rows: T of eight columns, by qz
    float* work;      // [N] rows
    float* planes[3]; // [N] rows each: X + iZ of a, of b, heights
} Scratch;

static int getColumnRows(int size)
{
    return 8 * swGetPanelCount(size);
}

static Scratch layOutScratch(int size, void* memory)
{
    Scratch s;
    s.size = size;
    s.panelCount = swGetPanelCount(size);
    s.panels = memory;
    s.columns = s.panels + FIELD_COUNT * s.panelCount * size * SW_PANEL_ROW;
    s.work = s.columns + FIELD_COUNT * getColumnRows(size) * SW_PANEL_ROW;
    for (int i = 0; i < 3; ++i)
    {
        s.planes[i] = s.work + (i + 1) * size * SW_PANEL_ROW;
    }
    return s;
}

static float* getPanel(const Scratch* s, int field, int panel)
{
    return s->panels + (field * s->panelCount + panel) * s->size * SW_PANEL_ROW;
}

// Panels that hold modes of a tile.
static int countUsedPanels(const swTile* tile)
{
    return tile->maxBin / 8 + 1;
}

// rad/s of turns per tick.
static inline float getModeOmega(uint64_t frequency)
{
    return (float)((double)frequency * (SW_TICKS_PER_SECOND * 6.283185307179586 * 0x1p-64));
}

// Spectra of up to MODE_CHUNK modes: real and imaginary parts of X, Z and H.
typedef struct ModeSpectra
{
    float parts[6][MODE_CHUNK];
} ModeSpectra;

// Derived `derivative` times by time: with dH/dt of the form that H has, p' = omega (q_im, -q_re) and q' = omega (p_im,
// -p_re) as (re, im) pairs, and the second derivative is -omega^2 H.
static void computeSpectra(const swMode* modes, int count, int64_t ticks, float weight, int derivative,
                           ModeSpectra* spectra)
{
    uint32_t phases[MODE_CHUNK];
    float factors[MODE_CHUNK];
    for (int i = 0; i < count; ++i)
    {
        uint64_t frequency = ((uint64_t)modes[i].frequencyHigh << 32) | modes[i].frequencyLow;
        phases[i] = (uint32_t)((frequency * (uint64_t)ticks) >> 32);
        if (derivative > 0)
        {
            float omega = getModeOmega(frequency);
            factors[i] = derivative == 1 ? omega : -omega * omega;
        }
    }
    const int stride = (int)(sizeof(swMode) / sizeof(float));
    swWide scale = swSplatW(weight);
    for (int i = 0; i < count; i += SW_WIDTH)
    {
        swWide sine, cosine, direction[4], amplitude[4];
        swSinCosTurnsW(swLoadI(phases + i), &sine, &cosine);
        swLoadColumns4(&modes[i].dx, stride, direction);
        swLoadColumns4(&modes[i].pr, stride, amplitude);
        swWide dx = direction[0];
        swWide dz = direction[1];
        swWide re, im;
        if (derivative == 1)
        {
            re = swSubW(swMulW(amplitude[3], cosine), swMulW(amplitude[0], sine));
            im = swSubW(swSplatW(0.0f), swAddW(swMulW(amplitude[1], sine), swMulW(amplitude[2], cosine)));
        }
        else
        {
            re = swAddW(swMulW(amplitude[0], cosine), swMulW(amplitude[3], sine));
            im = swSubW(swMulW(amplitude[1], cosine), swMulW(amplitude[2], sine));
        }
        if (derivative > 0)
        {
            swWide factor = swLoadW(factors + i);
            re = swMulW(re, factor);
            im = swMulW(im, factor);
        }
        re = swMulW(re, scale);
        im = swMulW(im, scale);
        swWide minus = swSplatW(-1.0f);
        swStoreW(spectra->parts[0] + i, swMulW(swMulW(dx, im), minus));
        swStoreW(spectra->parts[1] + i, swMulW(dx, re));
        swStoreW(spectra->parts[2] + i, swMulW(swMulW(dz, im), minus));
        swStoreW(spectra->parts[3] + i, swMulW(dz, re));
        swStoreW(spectra->parts[4] + i, re);
        swStoreW(spectra->parts[5] + i, im);
    }
}

// Row of a panel that holds bin qx, see swFftFirstPruned().
static inline int getSpectrumRow(int qx, int size)
{
    if (qx >= 0)
    {
        return qx < size / 4 ? qx : size / 2;
    }
    return size / 2 + qx;
}

static void placeSpectra(const Scratch* s, int firstField, const swMode* modes, int count, const ModeSpectra* spectra)
{
    const int fieldStep = s->panelCount * s->size * SW_PANEL_ROW;
    for (int i = 0; i < count; ++i)
    {
        int qx = modes[i].qx;
        int qz = modes[i].qz;
        float* at = getPanel(s, firstField, qz / 8) + getSpectrumRow(qx, s->size) * SW_PANEL_ROW + qz % 8;
        for (int field = 0; field < 3; ++field)
        {
            at[field * fieldStep] = spectra->parts[2 * field][i];
            at[field * fieldStep + SW_PANEL_LANES] = spectra->parts[2 * field + 1][i];
        }
        if (qz == 0)
        {
            // The line of its own mirror image: the other half is not in the list.
            at = getPanel(s, firstField, 0) + getSpectrumRow(-qx, s->size) * SW_PANEL_ROW;
            for (int field = 0; field < 3; ++field)
            {
                at[field * fieldStep] = spectra->parts[2 * field][i];
                at[field * fieldStep + SW_PANEL_LANES] = -spectra->parts[2 * field + 1][i];
            }
        }
    }
}

// Modes whose amplitudes are the powers of the tile's, at rest. Amplitudes were divided by the spline's response once,
// so that of their squares one is left to multiply with.
static void copyPowers(const swTile* tile, const swMode* modes, int count, swMode* powers)
{
    memset(powers, 0, MODE_CHUNK * sizeof(swMode));
    for (int i = 0; i < count; ++i)
    {
        const swMode* m = modes + i;
        int qx = m->qx < 0 ? -m->qx : m->qx;
        powers[i].qx = m->qx;
        powers[i].qz = m->qz;
        powers[i].pr = (m->pr * m->pr + m->pi * m->pi + m->qr * m->qr + m->qi * m->qi) *
                       (tile->response[qx] * tile->response[m->qz]);
    }
}

// First axis of a tile's three fields: spectra at `ticks`, and their transforms along x.
static void transformRows(const Scratch* s, int firstField, const swTile* tile, int64_t ticks, int derivative)
{
    int usedPanels = countUsedPanels(tile);
    for (int field = firstField; field < firstField + 3; ++field)
    {
        for (int panel = 0; panel < usedPanels; ++panel)
        {
            memset(getPanel(s, field, panel), 0, (size_t)(s->size / 2 + 1) * ROW_BYTES);
        }
    }
    int64_t tileTicks = swGetTileTicks(tile, ticks);
    for (int first = 0; first < tile->modeCount; first += MODE_CHUNK)
    {
        const swMode* modes = tile->modes + first;
        int count = tile->modeCount - first < MODE_CHUNK ? tile->modeCount - first : MODE_CHUNK;
        swMode padded[MODE_CHUNK];
        if (derivative == SW_LIKENESS)
        {
            copyPowers(tile, modes, count, padded);
            modes = padded;
        }
        else if (count % SW_WIDTH != 0)
        {
            memset(padded, 0, sizeof padded);
            memcpy(padded, modes, (size_t)count * sizeof(swMode));
            modes = padded;
        }
        ModeSpectra spectra;
        computeSpectra(modes, (count + SW_WIDTH - 1) / SW_WIDTH * SW_WIDTH, tileTicks, tile->weight,
                       derivative == SW_LIKENESS ? 0 : derivative, &spectra);
        placeSpectra(s, firstField, modes, count, &spectra);
    }
    for (int field = firstField; field < firstField + 3; ++field)
    {
        for (int panel = 0; panel < usedPanels; ++panel)
        {
            float* rows = getPanel(s, field, panel);
            swFftFirstPruned(s->size, rows, s->work);
            swFftRest(s->size, s->work, rows);
        }
    }
}

static float* getColumns(const Scratch* s, int field)
{
    return s->columns + field * getColumnRows(s->size) * SW_PANEL_ROW;
}

// T at columns x .. x + 7, turned so that rows are qz and lanes are x.
static void turnColumns(const Scratch* s, int firstField, const swTile* tile, int x)
{
    int usedPanels = countUsedPanels(tile);
    for (int field = firstField; field < firstField + 3; ++field)
    {
        float* to = getColumns(s, field);
        for (int panel = 0; panel < usedPanels; ++panel)
        {
            const float* from = getPanel(s, field, panel) + x * SW_PANEL_ROW;
            float* out = to + panel * 8 * SW_PANEL_ROW;
            swTranspose8(from, SW_PANEL_ROW, out, SW_PANEL_ROW);
            swTranspose8(from + SW_PANEL_LANES, SW_PANEL_ROW, out + SW_PANEL_LANES, SW_PANEL_ROW);
        }
    }
}

// G at bin qz and at bin -qz.
static inline swComplexW joinFields(const float* a, const float* b)
{
    return addTurned(loadComplex(a), loadComplex(b));
}

static inline swComplexW joinMirrored(const float* a, const float* b)
{
    swComplexW ta = loadComplex(a);
    swComplexW tb = loadComplex(b);
    return (swComplexW){swAddW(ta.re, tb.im), swSubW(tb.re, ta.im)};
}

// Second axis of two real fields: along z, real parts become field a, imaginary parts field b.
static void transformColumns(const Scratch* s, const float* a, const float* b, float* plane)
{
    int quarter = s->size / 4;
    int step = quarter * SW_PANEL_ROW;
    for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
    {
        const float* la = a + lane;
        const float* lb = b + lane;
        swComplexW zero = {swSplatW(0.0f), swSplatW(0.0f)};
        butterfly4(s->work + lane, quarter, joinFields(la, lb), joinFields(la + step, lb + step), zero,
                   joinMirrored(la + step, lb + step), NULL);
    }
    for (int n = 1; n < quarter; ++n)
    {
        swTwiddles w = loadTwiddles(n, s->size);
        int mirrored = step - n * SW_PANEL_ROW;
        for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
        {
            const float* la = a + lane;
            const float* lb = b + lane;
            butterfly4Pruned(s->work + n * SW_PANEL_ROW + lane, quarter,
                             joinFields(la + n * SW_PANEL_ROW, lb + n * SW_PANEL_ROW),
                             joinMirrored(la + mirrored, lb + mirrored), &w);
        }
    }
    swFftRest(s->size, s->work, plane);
}

// Eight columns of texels: sample (x, z) goes to texel (x + 1, z + 1). `height` is the real or imaginary part of a
// plane.
static void writeTexels(const Scratch* s, const float* horizontal, const float* height, int x, float* texels)
{
    int pitch = s->size + 3;
    swWide zero = swSplatW(0.0f);
    for (int z = 0; z < s->size; ++z)
    {
        float* out = texels + ((z + 1) * pitch + x + 1) * 4;
        // The next block's lines, most of which lie beyond the second cache by now: 0.13 to 0.07 ms a tile.
        __builtin_prefetch(out + 47, 1, 3);
        __builtin_prefetch(out + 63, 1, 3);
        for (int lane = 0; lane < SW_PANEL_LANES; lane += SW_WIDTH)
        {
            const float* d = horizontal + z * SW_PANEL_ROW + lane;
            swStoreRows4(out + lane * 4, swLoadW(d), swLoadW(height + z * SW_PANEL_ROW + lane),
                         swLoadW(d + SW_PANEL_LANES), zero);
        }
    }
}

// Repeat what wraps: column and row 0 are sample N - 1, the last two are samples 0 and 1.
static void padTexels(int size, float* texels)
{
    int pitch = size + 3;
    size_t texel = 4 * sizeof(float);
    for (int row = 1; row <= size; ++row)
    {
        float* first = texels + row * pitch * 4;
        memcpy(first, first + size * 4, texel);
        memcpy(first + (size + 1) * 4, first + 4, 2 * texel);
    }
    memcpy(texels, texels + size * pitch * 4, (size_t)pitch * texel);
    memcpy(texels + (size + 1) * pitch * 4, texels + pitch * 4, 2 * (size_t)pitch * texel);
}

static void transformTiles(const swTile* a, float* texelsA, const swTile* b, float* texelsB, int64_t ticks,
                           int derivative, void* scratch)
{
    Scratch s = layOutScratch(a->resolution, scratch);
    transformRows(&s, FIELD_AX, a, ticks, derivative);
    if (b != NULL)
    {
        transformRows(&s, FIELD_BX, b, ticks, derivative);
    }
    // Bins that no mode reaches stay zero throughout.
    memset(s.columns, 0, (size_t)(FIELD_COUNT * getColumnRows(s.size)) * ROW_BYTES);
    for (int x = 0; x < s.size; x += SW_PANEL_LANES)
    {
        turnColumns(&s, FIELD_AX, a, x);
        transformColumns(&s, getColumns(&s, FIELD_AX), getColumns(&s, FIELD_AZ), s.planes[0]);
        if (b != NULL)
        {
            turnColumns(&s, FIELD_BX, b, x);
            transformColumns(&s, getColumns(&s, FIELD_BX), getColumns(&s, FIELD_BZ), s.planes[1]);
        }
        transformColumns(&s, getColumns(&s, FIELD_AH), getColumns(&s, FIELD_BH), s.planes[2]);
        writeTexels(&s, s.planes[0], s.planes[2], x, texelsA);
        if (b != NULL)
        {
            writeTexels(&s, s.planes[1], s.planes[2] + SW_PANEL_LANES, x, texelsB);
        }
    }
    padTexels(s.size, texelsA);
    if (b != NULL)
    {
        padTexels(s.size, texelsB);
    }
}

// ---- Sampling ----

// Points that go through the tiles together: few enough for the nearest cache and for the stacks of fibres, many enough
// that a tile's texels stay in the next cache while it is their turn.
#define POINT_BLOCK SW_SUM_BLOCK

static inline int padToEight(int count)
{
    return (count + 7) / 8 * 8;
}

// Coordinates of a point, interleaved x, z: which cell of a tile, and where in it.
typedef struct Cells
{
    int32_t cell[2 * POINT_BLOCK];
    float fraction[2 * POINT_BLOCK];
} Cells;

// u * scale = cell + fraction, with cell modulo N (a power of two). Adding 3 * 2^51 leaves the nearest integer in the
// low bits of a double, exactly as long as |u * scale| < 2^51; taking it away again shows whether that was above. Not
// inlined: of a count that it knows GCC takes the loop apart before it would make vectors of it.
__attribute__((noinline)) static void findCells(const double* u, int count, double scale, int size, int32_t* cell,
                                                float* fraction)
{
    const double shift = 6755399441055744.0;
    for (int i = 0; i < count; ++i)
    {
        double s = u[i] * scale;
        double shifted = s + shift;
        double rest = s - (shifted - shift);
        int64_t bits;
        memcpy(&bits, &shifted, sizeof bits);
        int32_t below = rest < 0.0 ? 1 : 0;
        cell[i] = ((int32_t)bits - below) & (size - 1);
        fraction[i] = (float)(rest < 0.0 ? rest + 1.0 : rest);
    }
}

// Weights of four neighbours for sixteen fractions, as swSplineWeights() has them.
typedef struct Weights
{
    swFours value, slope;
} Weights;

static void findWeights(const float* fraction, Weights* weights)
{
    swWide one = swSplatW(1.0f);
    swWide two = swSplatW(2.0f);
    swWide sixth = swSplatW(1.0f / 6.0f);
    swWide half = swSplatW(0.5f);
    swWide twoThirds = swSplatW(2.0f / 3.0f);
    for (int i = 0; i < 16; i += SW_WIDTH)
    {
        swWide t = swLoadW(fraction + i);
        swWide s = swSubW(one, t);
        swWide t2 = swMulW(t, t);
        swWide s2 = swMulW(s, s);
        swStoreFours(&weights->value, i, swMulW(swMulW(s2, s), sixth),
                     swSubW(twoThirds, swMulW(swMulW(t2, swSubW(two, t)), half)),
                     swSubW(twoThirds, swMulW(swMulW(s2, swSubW(two, s)), half)), swMulW(swMulW(t2, t), sixth));
    }
}

// Slopes as swSplineSlopes() has them, per metre: times `scale`.
static void findSlopes(const float* fraction, float scale, Weights* weights)
{
    swWide one = swSplatW(1.0f);
    swWide two = swSplatW(2.0f);
    swWide half = swSplatW(0.5f);
    swWide oneAndHalf = swSplatW(1.5f);
    swWide perMetre = swSplatW(scale);
    for (int i = 0; i < 16; i += SW_WIDTH)
    {
        swWide t = swLoadW(fraction + i);
        swWide s = swSubW(one, t);
        swWide first = swMulW(swMulW(s, s), swSplatW(-0.5f));
        swWide second = swMulW(t, swSubW(swMulW(oneAndHalf, t), two));
        swWide third = swMulW(s, swSubW(two, swMulW(oneAndHalf, s)));
        swWide fourth = swMulW(swMulW(t, t), half);
        swStoreFours(&weights->slope, i, swMulW(first, perMetre), swMulW(second, perMetre), swMulW(third, perMetre),
                     swMulW(fourth, perMetre));
    }
}

// Sum over the four rows of a window, with the weights of coordinate i.
static inline swRow sumRows(const float* window, int pitch4, const swFours* weights, int i)
{
    swRow sum = swScaleR(swLoadR(window), swGetOfFour(weights, i, 0));
    for (int row = 1; row < 4; ++row)
    {
        sum = swAddR(sum, swScaleR(swLoadR(window + row * pitch4), swGetOfFour(weights, i, row)));
    }
    return sum;
}

static inline void addQuads(float* sum, swQuads a)
{
    swStoreQ(sum, swAddQ(swLoadQ(sum), a));
}

static inline void addValue(const float* window, int pitch4, const Weights* w, int x, int z, swPointSums* sums)
{
    addQuads(sums->value, swFoldR(sumRows(window, pitch4, &w->value, z), &w->value, x));
}

// What a tile's window says at a point: its value and its derivatives.
typedef struct WindowSums
{
    swQuads value, alongX, alongZ;
} WindowSums;

#ifdef SW_HAS_ROWS

// There are registers to sum up rows for value and slope at once.
static inline void sumRowsTwice(const float* window, int pitch4, const Weights* w, int z, swRow* row, swRow* slope)
{
    swRow texels = swLoadR(window);
    *row = swScaleR(texels, swGetOfFour(&w->value, z, 0));
    *slope = swScaleR(texels, swGetOfFour(&w->slope, z, 0));
    for (int i = 1; i < 4; ++i)
    {
        texels = swLoadR(window + i * pitch4);
        *row = swAddR(*row, swScaleR(texels, swGetOfFour(&w->value, z, i)));
        *slope = swAddR(*slope, swScaleR(texels, swGetOfFour(&w->slope, z, i)));
    }
}

static inline WindowSums sumWindow(const float* window, int pitch4, const Weights* w, int x, int z)
{
    swRow row, slope;
    sumRowsTwice(window, pitch4, w, z, &row, &slope);
    return (WindowSums){swFoldR(row, &w->value, x), swFoldR(row, &w->slope, x), swFoldR(slope, &w->value, x)};
}

#else

static inline WindowSums sumWindow(const float* window, int pitch4, const Weights* w, int x, int z)
{
    swRow row = sumRows(window, pitch4, &w->value, z);
    return (WindowSums){swFoldR(row, &w->value, x), swFoldR(row, &w->slope, x),
                        swFoldR(sumRows(window, pitch4, &w->slope, z), &w->value, x)};
}

#endif

static inline void addSlopes(const float* window, int pitch4, const Weights* w, int x, int z, swPointSums* sums)
{
    WindowSums own = sumWindow(window, pitch4, w, x, z);
    addQuads(sums->value, own.value);
    addQuads(sums->alongX, own.alongX);
    addQuads(sums->alongZ, own.alongZ);
}

// Where points are, interleaved, on to a multiple of eight of them.
static void listPlaces(int count, const swPosXZ* points, double* u)
{
    for (int i = 0; i < padToEight(count); ++i)
    {
        const swPosXZ* point = points + (i < count ? i : 0);
        u[2 * i] = point->x;
        u[2 * i + 1] = point->z;
    }
}

// Add one tile to the sums of `count` points.
static void addTileAt(const swTile* tile, const float* texels, int count, const double* u, bool withSlopes,
                      Cells* cells, swPointSums* sums)
{
    double scale = tile->resolution / tile->side;
    int pitch4 = (tile->resolution + 3) * 4;
    findCells(u, 2 * padToEight(count), scale, tile->resolution, cells->cell, cells->fraction);
    for (int first = 0; first < count; first += 8)
    {
        Weights weights;
        findWeights(cells->fraction + 2 * first, &weights);
        if (withSlopes)
        {
            findSlopes(cells->fraction + 2 * first, (float)scale, &weights);
        }
        int last = count - first < 8 ? count - first : 8;
        for (int i = 0; i < last; ++i)
        {
            const int32_t* cell = cells->cell + 2 * (first + i);
            const float* window = texels + (size_t)cell[1] * (size_t)pitch4 + (size_t)cell[0] * 4;
            if (withSlopes)
            {
                addSlopes(window, pitch4, &weights, 2 * i, 2 * i + 1, sums + first + i);
            }
            else
            {
                addValue(window, pitch4, &weights, 2 * i, 2 * i + 1, sums + first + i);
            }
        }
    }
}

// One that a current has carried. Not inlined, for the sake of the stack.
__attribute__((noinline)) static void addCarriedTile(const swTile* tile, const float* texels, int count,
                                                     const double* u, bool withSlopes, Cells* cells, swPointSums* sums)
{
    double moved[2 * POINT_BLOCK];
    for (int i = 0; i < padToEight(count); ++i)
    {
        moved[2 * i] = u[2 * i] - tile->shiftX;
        moved[2 * i + 1] = u[2 * i + 1] - tile->shiftZ;
    }
    addTileAt(tile, texels, count, moved, withSlopes, cells, sums);
}

static void addTile(const swTile* tile, const float* texels, int count, const double* u, bool withSlopes, Cells* cells,
                    swPointSums* sums)
{
    if (tile->shiftX != 0.0 || tile->shiftZ != 0.0)
    {
        addCarriedTile(tile, texels, count, u, withSlopes, cells, sums);
        return;
    }
    addTileAt(tile, texels, count, u, withSlopes, cells, sums);
}

static const float* getFieldTexels(const swTile* tile, int field)
{
    return field == 0 ? tile->texels : field == 1 ? tile->velocity : tile->acceleration;
}

static void addOneTile(const swTile* tile, int field, int count, const swPosXZ* points, bool withSlopes,
                       swPointSums* sums)
{
    double u[2 * POINT_BLOCK];
    Cells cells;
    listPlaces(count, points, u);
    addTile(tile, getFieldTexels(tile, field), count, u, withSlopes, &cells, sums);
}

// `gradients` may be NULL. Texels have no fourth component, so the last two elements become 0.
static inline void storeSums(const swPointSums* sums, float* out, float* gradients)
{
    swStoreSumQ(out, swLoadQ(sums->value));
    if (gradients != NULL)
    {
        swStorePairsQ(gradients, swLoadQ(sums->alongX), swLoadQ(sums->alongZ));
    }
}

static void storeAllSums(int count, const swPointSums* sums, float* out, float* gradients)
{
    for (int i = 0; i < count; ++i)
    {
        storeSums(&sums[i], out + (size_t)i * 4, gradients != NULL ? gradients + (size_t)i * 8 : NULL);
    }
}

static bool isChosen(const swTileChoice* choice, int tile)
{
    return swIsTileChosen(&choice->tiles[tile], choice->shortest, choice->longest);
}

static void sampleTiles(const swTileChoice* choice, int count, const swPosXZ* points, float* out, float* gradients)
{
    double u[2 * POINT_BLOCK];
    Cells cells;
    swPointSums sums[POINT_BLOCK];
    for (int first = 0; first < count; first += POINT_BLOCK)
    {
        int blockCount = count - first < POINT_BLOCK ? count - first : POINT_BLOCK;
        listPlaces(blockCount, points + first, u);
        memset(sums, 0, (size_t)blockCount * sizeof(swPointSums));
        for (int i = 0; i < choice->count; ++i)
        {
            if (isChosen(choice, i))
            {
                const swTile* tile = &choice->tiles[i];
                addTile(tile, getFieldTexels(tile, choice->field), blockCount, u, gradients != NULL, &cells, sums);
            }
        }
        storeAllSums(blockCount, sums, out + (size_t)first * 4,
                     gradients != NULL ? gradients + (size_t)first * 8 : NULL);
    }
}
