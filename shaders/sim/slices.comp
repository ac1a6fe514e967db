// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their cubic
// B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong), and of its free waves.
//
// The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a column
// share their weights along x, all texels of a row their weights along z. A thread owns a column of eight texels, two runs
// of four, and takes the tile rows that they touch one by one, each interpolated along x (value and slope). Columns of
// texels lie side by side, so whether a tile has a knot between two rows of texels is the same for a whole workgroup. A
// tile is added in one of three ways:
//
//   no knot in the eight texels  The spline along z is one cubic there: its four coefficients are added to the column's.
//                                That costs the same however many texels there are, and slopes along z come with it.
//   no knot in a run             The same, for the run's cubic.
//   else                         Row by row, to the texels whose windows of four rows may hold it: at most five rows for
//                                most, up to eight for the shortest. Weights along z lie in shared memory, by tile row,
//                                with zeros where a row is outside a texel's window, so that no branch depends on them.
//
// A cubic is exact, not an approximation. In a default view six of the nine tiles of an average slice are added as cubics;
// the two shortest never are.
//
// Free waves are evaluated one by one, with their phases in integers: a run turns the first texel's sine and cosine on.
//
// Measured on an H100, a default view: 53.5 us. Stores alone take 22, and 9 if lanes trade texels by shuffles so that
// stores fill whole sectors, yet in the whole shader trading gains nothing; without stores it takes 48, without loads 35,
// without what is added row by row 31. Registers decide: 128 a thread here. The compiler takes more where more shared memory
// keeps workgroups away anyway: 176 and 63 us with a batch of 32. Slower were, of the same sums: every tile row by row (63),
// 64 columns (61, 168 registers), columns of sixteen (58), weights along z in registers and four rows kept from texel to
// texel (69 to 79), loops over rows instead of blocks of five (54 to 58), workgroups of 768 and 1,024 threads, which hold the
// compiler to 80 and 64 registers (70, 77 to 99), a cubic shared by two threads through shared memory (65 to 77), tile texels
// in shared memory (129). Runs of four alone were as fast (53, 96 registers) and 1.7 times as slow on a CPU. A load of a
// tile's texel takes the load unit four cycles a warp, whatever the addresses; a vec4 of weights from shared memory two.
// Waves of 64 texels and more summed with their derivatives at every fourth texel, with bicubic Hermite polynomials between,
// were slower as well (74: barriers, shared memory and registers), and not exact.

#include "lib/turns.glsl"
#include "shared/spline.h"
#include "shared/surface_normal.h"
#include "shared/waves.h"

layout(local_size_x = SW_SLICE_WIDTH) in;

layout(std430, binding = 0) readonly buffer Lists
{
    swSliceList lists[];
};
layout(std430, binding = 1) readonly buffer Tiles
{
    swSliceTile tiles[];
};
layout(std430, binding = 2) readonly buffer Texels
{
    vec4 texels[];
};
layout(binding = 3, rgba32f) uniform writeonly image2DArray displacement;
layout(binding = 4, rgba16f) uniform writeonly image2DArray derivatives;
layout(std430, binding = 5) readonly buffer Waves
{
    swSliceWave waves[];
};

// Of each tile, run and tile row: weights of the run's four texels for values, and for slopes.
shared vec4 weightsZ[SW_SLICE_BATCH][SW_SLICE_RUNS][SW_SLICE_ROWS][2];
// Of each tile and run: its first row (not wrapped), and how many rows it touches.
shared uvec2 rowsZ[SW_SLICE_BATCH][SW_SLICE_RUNS];
// Bit b: how tile b of the batch is added, to the whole column or to a run.
shared uint columnCubics;
shared uint runCubics[SW_SLICE_RUNS];
shared uint rowByRow[SW_SLICE_RUNS];

// Tiles of a batch ---------------------------------------------------------------------------------------------------

// Spline coordinate of a row of the block. The same bits wherever it is asked for: windows and weights must not disagree.
float splineZ(swSliceTile tile, uint row)
{
    return fma(float(gl_WorkGroupID.y * SW_SLICE_HEIGHT + row), tile.step, tile.fractionZ);
}

// Whether no knot lies between two rows of the block, so that one cubic passes through them and all between.
bool isCubic(swSliceTile tile, uint firstRow, uint lastRow)
{
    return tile.runMask == (1u << SW_SLICE_RUN) - 1 && floor(splineZ(tile, firstRow)) == floor(splineZ(tile, lastRow));
}

void placeWeights(uint b, uint run, uint t, swSliceTile tile)
{
    float top = floor(splineZ(tile, run * SW_SLICE_RUN + findLSB(tile.runMask)));
    float s = splineZ(tile, run * SW_SLICE_RUN + t);
    float cell = floor(s);
    uint first = uint(cell - top);
    for (uint k = 0; k < SW_SLICE_ROWS; ++k)
    {
        weightsZ[b][run][k][0][t] = 0.0;
        weightsZ[b][run][k][1][t] = 0.0;
    }
    if ((tile.runMask >> t & 1) == 0)
    {
        return;
    }
    vec4 value = swSplineWeights(s - cell);
    vec4 slope = swSplineSlopes(s - cell) * tile.perMetre;
    for (uint k = 0; k < 4; ++k)
    {
        weightsZ[b][run][first + k][0][t] = value[k];
        weightsZ[b][run][first + k][1][t] = slope[k];
    }
    if (t == findMSB(tile.runMask))
    {
        rowsZ[b][run] = uvec2((tile.base >> 16) + uint(top), first + 4);
    }
}

void sortTile(uint b, uint run, swSliceTile tile)
{
    if (isCubic(tile, 0, SW_SLICE_HEIGHT - 1))
    {
        atomicOr(columnCubics, 1u << b);
    }
    else if (isCubic(tile, run * SW_SLICE_RUN, run * SW_SLICE_RUN + SW_SLICE_RUN - 1))
    {
        atomicOr(runCubics[run], 1u << b);
    }
    else
    {
        atomicOr(rowByRow[run], 1u << b);
    }
}

void prepareTiles(uint first, uint count)
{
    barrier(); // nobody reads the last batch any more
    if (gl_LocalInvocationIndex < SW_SLICE_RUNS)
    {
        columnCubics = 0;
        runCubics[gl_LocalInvocationIndex] = 0;
        rowByRow[gl_LocalInvocationIndex] = 0;
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < count * SW_SLICE_HEIGHT; i += SW_SLICE_WIDTH)
    {
        uint b = i / SW_SLICE_HEIGHT;
        uint row = i % SW_SLICE_HEIGHT;
        uint run = row / SW_SLICE_RUN;
        swSliceTile tile = tiles[first + b];
        placeWeights(b, run, row % SW_SLICE_RUN, tile);
        if (row % SW_SLICE_RUN == 0)
        {
            sortTile(b, run, tile);
        }
    }
    barrier();
}

// Rows of a tile -----------------------------------------------------------------------------------------------------

// Where a column's windows of four tile columns lie, and their weights.
struct Window
{
    vec4 value, slope;
    uint first, mask, pitch;
};

Window makeWindow(swSliceTile tile, uint column)
{
    Window window;
    float s = fma(float(column), tile.step, tile.fractionX);
    float cell = floor(s);
    window.value = swSplineWeights(s - cell);
    window.slope = swSplineSlopes(s - cell) * tile.perMetre;
    window.mask = tile.resolution - 1;
    window.pitch = tile.resolution + 3;
    window.first = tile.firstTexel + (((tile.base & 0xffffu) + uint(cell)) & window.mask);
    return window;
}

// Displacement interpolated along x.
vec3 weigh(vec4 weights, vec3 a, vec3 b, vec3 c, vec3 d)
{
    return fma(vec3(weights.w), d, fma(vec3(weights.z), c, fma(vec3(weights.y), b, weights.x * a)));
}

// Rows and the texels of a run have names, not indices: an array that a loop indexes would leave the registers.
#define LOAD_ROW(k)                                                                                                    \
    uint at##k = window.first + ((top + k) & window.mask) * window.pitch;                                              \
    vec3 a##k = texels[at##k].xyz, b##k = texels[at##k + 1].xyz;                                                       \
    vec3 c##k = texels[at##k + 2].xyz, d##k = texels[at##k + 3].xyz;

#define WEIGH_ROW(k)                                                                                                   \
    vec3 value##k = weigh(window.value, a##k, b##k, c##k, d##k);                                                       \
    vec3 slope##k = weigh(window.slope, a##k, b##k, c##k, d##k);

// Cubics along z -----------------------------------------------------------------------------------------------------

// Displacement is v0 + v1 t + v2 t^2 + v3 t^3, t texels from where the cubic begins; x0 to x3 give its slope along x.
struct Cubic
{
    vec3 v0, v1, v2, v3;
    vec3 x0, x1, x2, x3;
};

const Cubic FLAT = Cubic(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));

#define BEND(k, component)                                                                                             \
    cubic.v0 = fma(vec3(w0.component), value##k, cubic.v0);                                                            \
    cubic.v1 = fma(vec3(w1.component), value##k, cubic.v1);                                                            \
    cubic.v2 = fma(vec3(w2.component), value##k, cubic.v2);                                                            \
    cubic.v3 = fma(vec3(w3.component), value##k, cubic.v3);                                                            \
    cubic.x0 = fma(vec3(w0.component), slope##k, cubic.x0);                                                            \
    cubic.x1 = fma(vec3(w1.component), slope##k, cubic.x1);                                                            \
    cubic.x2 = fma(vec3(w2.component), slope##k, cubic.x2);                                                            \
    cubic.x3 = fma(vec3(w3.component), slope##k, cubic.x3);

// Adds a tile to the cubic that begins at a row of the block: the Taylor polynomial of the spline's piece there.
void addToCubic(inout Cubic cubic, swSliceTile tile, uint column, uint row)
{
    Window window = makeWindow(tile, column);
    float s = splineZ(tile, row);
    float cell = floor(s);
    uint top = (tile.base >> 16) + uint(cell);
    LOAD_ROW(0)
    LOAD_ROW(1)
    LOAD_ROW(2)
    LOAD_ROW(3)
    float t = s - cell;
    float halfSquare = 0.5 * tile.step * tile.step;
    vec4 w0 = swSplineWeights(t);
    vec4 w1 = swSplineSlopes(t) * tile.step;
    vec4 w2 = vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t) * halfSquare;
    vec4 w3 = vec4(-1.0, 3.0, -3.0, 1.0) * (halfSquare * tile.step * (1.0 / 3.0));
    WEIGH_ROW(0)
    BEND(0, x)
    WEIGH_ROW(1)
    BEND(1, y)
    WEIGH_ROW(2)
    BEND(2, z)
    WEIGH_ROW(3)
    BEND(3, w)
}

// The same cubic, beginning a run later.
Cubic moveByRun(Cubic c)
{
    const float RUN = float(SW_SLICE_RUN);
    return Cubic(c.v0 + RUN * (c.v1 + RUN * (c.v2 + RUN * c.v3)), c.v1 + RUN * (2.0 * c.v2 + 3.0 * RUN * c.v3),
                 c.v2 + 3.0 * RUN * c.v3, c.v3, c.x0 + RUN * (c.x1 + RUN * (c.x2 + RUN * c.x3)),
                 c.x1 + RUN * (2.0 * c.x2 + 3.0 * RUN * c.x3), c.x2 + 3.0 * RUN * c.x3, c.x3);
}

// Texels of a run ----------------------------------------------------------------------------------------------------

#define FOR_RUN(DO) DO(0) DO(1) DO(2) DO(3)

#define DECLARE_SUMS(t)                                                                                                \
    vec3 sum##t = fma(vec3(t), fma(vec3(t), fma(vec3(t), cubic.v3, cubic.v2), cubic.v1), cubic.v0);                    \
    vec3 alongX##t = fma(vec3(t), fma(vec3(t), fma(vec3(t), cubic.x3, cubic.x2), cubic.x1), cubic.x0);                 \
    vec3 alongZ##t = list.texelsPerMetre * fma(vec3(t), fma(vec3(3 * t), cubic.v3, 2.0 * cubic.v2), cubic.v1);

#define WEIGHTS_OF_ROW(k) vec4 v##k = weightsZ[b][run][k][0], w##k = weightsZ[b][run][k][1];

#define ADD_ROW(k, t, component)                                                                                       \
    sum##t = fma(vec3(v##k.component), value##k, sum##t);                                                              \
    alongX##t = fma(vec3(v##k.component), slope##k, alongX##t);                                                        \
    alongZ##t = fma(vec3(w##k.component), value##k, alongZ##t);

#define ADD_TO_ALL(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 0, x) ADD_ROW(k, 1, y) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)
#define ADD_TO_LAST_THREE(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 1, y) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)
#define ADD_TO_LAST_TWO(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)
#define ADD_TO_LAST(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 3, w)

// A free wave at a texel, then turned on to the next one.
#define ADD_WAVE(t)                                                                                                    \
    {                                                                                                                  \
        vec3 away = vec3(wave.dx * unit.y, -unit.x, wave.dz * unit.y);                                                 \
        vec3 rate = vec3(wave.dx * unit.x, unit.y, wave.dz * unit.x);                                                  \
        sum##t -= away;                                                                                                \
        alongX##t = fma(vec3(-wave.kx), rate, alongX##t);                                                              \
        alongZ##t = fma(vec3(-wave.kz), rate, alongZ##t);                                                              \
        unit = vec2(unit.x * wave.cosZ - unit.y * wave.sinZ, unit.x * wave.sinZ + unit.y * wave.cosZ);                 \
    }

#define STORE_TEXEL(t) storeTexel(at + ivec3(0, t, 0), sum##t, alongX##t, alongZ##t);

// Columns beyond a narrow slice's edge store nothing: Vulkan drops what is outside an image.
void storeTexel(ivec3 at, vec3 sum, vec3 alongX, vec3 alongZ)
{
    float jacobian = swSurfaceJacobian(alongX.x, alongZ.x, alongX.z, alongZ.z);
    float gx = swSurfaceNormalX(alongX.z, alongZ.z, alongX.y, alongZ.y);
    float gz = swSurfaceNormalZ(alongX.x, alongZ.x, alongX.y, alongZ.y);
    imageStore(displacement, at, vec4(sum, jacobian));
    imageStore(derivatives, at, vec4(gx, gz, jacobian, 0.0));
}

// Lays out a batch of a list; the only batch of a list was laid out before everything.
void takeBatch(swSliceList list, uint batch)
{
    if (list.count > SW_SLICE_BATCH)
    {
        prepareTiles(list.first + batch, min(list.count - batch, uint(SW_SLICE_BATCH)));
    }
}

void main()
{
    uint slice = gl_WorkGroupID.z;
    uint column = gl_GlobalInvocationID.x;
    swSliceList list = lists[slice];
    if (list.count <= SW_SLICE_BATCH)
    {
        prepareTiles(list.first, list.count);
    }
    Cubic whole = FLAT;
    for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
    {
        takeBatch(list, batch);
        for (uint bits = columnCubics; bits != 0; bits &= bits - 1)
        {
            addToCubic(whole, tiles[list.first + batch + findLSB(bits)], column, 0);
        }
    }
    for (uint run = 0; run < SW_SLICE_RUNS; ++run)
    {
        Cubic cubic = whole;
        for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
        {
            takeBatch(list, batch);
            for (uint bits = runCubics[run]; bits != 0; bits &= bits - 1)
            {
                addToCubic(cubic, tiles[list.first + batch + findLSB(bits)], column, run * SW_SLICE_RUN);
            }
        }
        FOR_RUN(DECLARE_SUMS)
        for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
        {
            takeBatch(list, batch);
            for (uint bits = rowByRow[run]; bits != 0; bits &= bits - 1)
            {
                uint b = findLSB(bits);
                Window window = makeWindow(tiles[list.first + batch + b], column);
                uint top = rowsZ[b][run].x;
                uint rowCount = rowsZ[b][run].y;
                // Texel 0's window begins at row 0, texel t's at row t + 1 at the latest: see isSparse in upload_frame.c.
                LOAD_ROW(0)
                LOAD_ROW(1)
                LOAD_ROW(2)
                LOAD_ROW(3)
                LOAD_ROW(4)
                WEIGH_ROW(0)
                ADD_TO_ALL(0)
                WEIGH_ROW(1)
                ADD_TO_ALL(1)
                WEIGH_ROW(2)
                ADD_TO_ALL(2)
                WEIGH_ROW(3)
                ADD_TO_ALL(3)
                WEIGH_ROW(4)
                ADD_TO_LAST_THREE(4)
                if (rowCount > 5)
                {
                    LOAD_ROW(5)
                    WEIGH_ROW(5)
                    ADD_TO_LAST_THREE(5)
                    if (rowCount > 6)
                    {
                        LOAD_ROW(6)
                        LOAD_ROW(7)
                        WEIGH_ROW(6)
                        ADD_TO_LAST_TWO(6)
                        WEIGH_ROW(7)
                        ADD_TO_LAST(7)
                    }
                }
            }
        }
        uint row = gl_WorkGroupID.y * SW_SLICE_HEIGHT + run * SW_SLICE_RUN;
        for (uint i = 0; i < list.waveCount; ++i)
        {
            swSliceWave wave = waves[list.firstWave + i];
            vec2 unit = wave.amplitude * unitOf(wave.phase + column * wave.stepX + row * wave.stepZ);
            FOR_RUN(ADD_WAVE)
        }
        ivec3 at = ivec3(column, row, slice);
        FOR_RUN(STORE_TEXEL)
        whole = moveByRun(whole);
    }
}
