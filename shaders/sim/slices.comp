// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their
// cubic B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong), and of its free
// waves.
//
// The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a column
// share their weights along x, all texels of a row their weights along z. A thread owns a column of eight texels, two
// runs of four. Columns of texels lie side by side, a workgroup's make a block, so whether a tile has a knot between
// two rows of texels is the same for the whole block. A tile is added in one of four ways:
//
//   no knot in the eight rows, and the block touches few of the tile's columns
//                       The spline along z is one cubic there. The tile's columns are turned into cubics once, in
//                       shared memory, and each thread adds four of them, weighted along x, to the coefficients of its
//                       own.
//   no knot in the eight rows
//                       The same, but each thread takes the four tile rows itself, each interpolated along x (value and
//                       slope). That costs the same however many texels there are, and slopes along z come with it.
//   no knot in a run    The same, for the run's cubic.
//   else                Row by row, to the texels whose windows of four rows may hold it: at most five rows for most,
//   six for
//                       the shortest waves. Weights along z lie in shared memory, by tile row, with zeros where a row
//                       is outside a texel's window, so that no branch depends on them.
//
// A cubic is exact, not an approximation. In a default view, by the steps of its tiles, an average slice has eight:
// three or four are added as blocks, one as a cubic of a column or a run, the rest row by row; the shortest always is.
//
// Free waves are evaluated one by one, with their phases in integers: a run turns the first texel's sine and cosine on.
//
// Measured on an H100, a default view: 39 us. An empty pass takes 12 and its stores 15 more; what is added row by row
// takes 14, the blocks 2.5. Registers decide: 128 a thread here, and the compiler takes 168 (47 us) where a block's
// shared memory is 12 KB instead of 7, whatever would fit; so cubics and weights share theirs. Tiles' parameters from
// shared memory instead of the buffer save 1.4 us of the load unit, dDz/dx in place of dDx/dz 0.5. Slower were, of the
// same sums and before blocks (44.6): one run a thread (48), batches of eight (47), every tile row by row, columns of
// sixteen texels, weights along z in registers and four rows kept from texel to texel, workgroups of 768 and 1,024
// threads, which hold the compiler to 80 and 64 registers, a cubic shared by two threads through shared memory, tile
// texels in shared memory; and with blocks, 64 columns (43), 256 columns (54) and slices in another order (42). Lanes
// that trade texels by shuffles, so that stores fill whole sectors, save 1.2 us; not every device can. A load of a
// tile's texel takes the load unit four cycles a warp, whatever the addresses; a vec4 of weights from shared memory
// two. Waves of 64 texels and more summed with their derivatives at every fourth texel, with bicubic Hermite
// polynomials between, were slower as well (barriers, shared memory and registers), and not exact.

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

// The tiles of the batch.
shared swSliceTile batchTiles[SW_SLICE_BATCH];
// What is laid out of each tile. Of one that is added row by row: by run and tile row, the weights of the run's four
// texels for values and for slopes. Of one that is added as a block: its columns' cubics along z, of x, y and z.
shared vec4 layouts[SW_SLICE_BATCH][SW_SLICE_LAYOUT];
// Of each tile and run: its first row (not wrapped), and how many rows it touches.
shared uvec2 rowsZ[SW_SLICE_BATCH][SW_SLICE_RUNS];
// Bit b: how tile b of the batch is added, to the block, to the whole column or to a run.
shared uint blockCubics;
shared uint columnCubics;
shared uint runCubics[SW_SLICE_RUNS];
shared uint rowByRow[SW_SLICE_RUNS];

// Cubics along z -----------------------------------------------------------------------------------------------------

// Displacement is x[0] + x[1] t + x[2] t^2 + x[3] t^3, t texels from where the cubic begins, y and z the same; slopeX
// to slopeZ are its slope along x.
struct Cubic
{
    vec4 x, y, z;
    vec4 slopeX, slopeY, slopeZ;
};

const Cubic FLAT = Cubic(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));

// The spline's piece t beyond a knot is a cubic: what each of its four coefficients adds to it, as Taylor polynomials.
mat4 cubicPieces(float t, float step)
{
    float halfSquare = 0.5 * step * step;
    vec4 w1 = swSplineSlopes(t) * step;
    vec4 w2 = vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t) * halfSquare;
    vec4 w3 = vec4(-1.0, 3.0, -3.0, 1.0) * (halfSquare * step * (1.0 / 3.0));
    return transpose(mat4(swSplineWeights(t), w1, w2, w3));
}

void addCubic(inout Cubic cubic, vec4 piece, vec3 value, vec3 slope)
{
    cubic.x = fma(piece, vec4(value.x), cubic.x);
    cubic.y = fma(piece, vec4(value.y), cubic.y);
    cubic.z = fma(piece, vec4(value.z), cubic.z);
    cubic.slopeX = fma(piece, vec4(slope.x), cubic.slopeX);
    cubic.slopeY = fma(piece, vec4(slope.y), cubic.slopeY);
    cubic.slopeZ = fma(piece, vec4(slope.z), cubic.slopeZ);
}

// The same polynomial, beginning a run later.
vec4 movePowers(vec4 c)
{
    const float RUN = float(SW_SLICE_RUN);
    return vec4(c.x + RUN * (c.y + RUN * (c.z + RUN * c.w)), c.y + RUN * (2.0 * c.z + 3.0 * RUN * c.w),
                c.z + 3.0 * RUN * c.w, c.w);
}

Cubic moveByRun(Cubic c)
{
    return Cubic(movePowers(c.x), movePowers(c.y), movePowers(c.z), movePowers(c.slopeX), movePowers(c.slopeY),
                 movePowers(c.slopeZ));
}

float evaluate(vec4 c, float t)
{
    return fma(fma(fma(c.w, t, c.z), t, c.y), t, c.x);
}

float evaluateSlope(vec4 c, float t)
{
    return fma(fma(3.0 * c.w, t, 2.0 * c.z), t, c.y);
}

// Tiles of a batch ---------------------------------------------------------------------------------------------------

// Spline coordinate of a row of the block. The same bits wherever it is asked for: windows and weights must not
// disagree.
float splineZ(swSliceTile tile, uint row)
{
    return fma(float(gl_WorkGroupID.y * SW_SLICE_HEIGHT + row), tile.step, tile.fractionZ);
}

float splineX(swSliceTile tile, uint column)
{
    return fma(float(column), tile.step, tile.fractionX);
}

// First tile column that the block touches, not wrapped.
float firstOfBlock(swSliceTile tile)
{
    return floor(splineX(tile, gl_WorkGroupID.x * SW_SLICE_WIDTH));
}

// Whether the block touches few columns of the tile.
bool isNarrow(swSliceTile tile)
{
    float last = floor(splineX(tile, gl_WorkGroupID.x * SW_SLICE_WIDTH + SW_SLICE_WIDTH - 1));
    return last - firstOfBlock(tile) <= float(SW_SLICE_COLUMNS - 4);
}

// Whether no knot lies between two rows of the block, so that one cubic passes through them and all between.
bool isCubic(swSliceTile tile, uint firstRow, uint lastRow)
{
    return tile.runMask == (1u << SW_SLICE_RUN) - 1 && floor(splineZ(tile, firstRow)) == floor(splineZ(tile, lastRow));
}

uint weightsAt(uint run, uint row)
{
    return 2 * (run * SW_SLICE_ROWS + row);
}

void placeWeights(uint b, uint run, uint t, swSliceTile tile)
{
    float top = floor(splineZ(tile, run * SW_SLICE_RUN + findLSB(tile.runMask)));
    float s = splineZ(tile, run * SW_SLICE_RUN + t);
    float cell = floor(s);
    uint first = uint(cell - top);
    for (uint k = 0; k < SW_SLICE_ROWS; ++k)
    {
        layouts[b][weightsAt(run, k)][t] = 0.0;
        layouts[b][weightsAt(run, k) + 1][t] = 0.0;
    }
    if ((tile.runMask >> t & 1) == 0)
    {
        return;
    }
    vec4 value = swSplineWeights(s - cell);
    vec4 slope = swSplineSlopes(s - cell) * tile.perMetre;
    for (uint k = 0; k < 4; ++k)
    {
        layouts[b][weightsAt(run, first + k)][t] = value[k];
        layouts[b][weightsAt(run, first + k) + 1][t] = slope[k];
    }
    if (t == findMSB(tile.runMask))
    {
        rowsZ[b][run] = uvec2((tile.base >> 16) + uint(top), first + 4);
    }
}

// Lays out column `k` of a tile that is added as a block.
void placeColumn(uint b, uint k, swSliceTile tile)
{
    float s = splineZ(tile, 0);
    float cell = floor(s);
    uint top = (tile.base >> 16) + uint(cell);
    uint mask = tile.resolution - 1;
    uint at = tile.firstTexel + (((tile.base & 0xffffu) + uint(firstOfBlock(tile)) + k) & mask);
    mat4 pieces = cubicPieces(s - cell, tile.step);
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);
    for (uint row = 0; row < 4; ++row)
    {
        vec3 texel = texels[at + ((top + row) & mask) * (tile.resolution + 3)].xyz;
        x = fma(vec4(texel.x), pieces[row], x);
        y = fma(vec4(texel.y), pieces[row], y);
        z = fma(vec4(texel.z), pieces[row], z);
    }
    layouts[b][3 * k + 0] = x;
    layouts[b][3 * k + 1] = y;
    layouts[b][3 * k + 2] = z;
}

// Decides how a tile is added to a row's run, and lays out what that takes.
void placeTile(uint b, uint row, swSliceTile tile)
{
    uint run = row / SW_SLICE_RUN;
    if (isCubic(tile, 0, SW_SLICE_HEIGHT - 1))
    {
        if (isNarrow(tile))
        {
            placeColumn(b, row, tile);
            atomicOr(blockCubics, 1u << b);
        }
        else
        {
            atomicOr(columnCubics, 1u << b);
        }
    }
    else if (isCubic(tile, run * SW_SLICE_RUN, run * SW_SLICE_RUN + SW_SLICE_RUN - 1))
    {
        atomicOr(runCubics[run], 1u << b);
    }
    else
    {
        placeWeights(b, run, row % SW_SLICE_RUN, tile);
        atomicOr(rowByRow[run], 1u << b);
    }
}

void prepareTiles(uint first, uint count)
{
    if (gl_LocalInvocationIndex < SW_SLICE_RUNS)
    {
        blockCubics = 0;
        columnCubics = 0;
        runCubics[gl_LocalInvocationIndex] = 0;
        rowByRow[gl_LocalInvocationIndex] = 0;
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < count * SW_SLICE_HEIGHT; i += SW_SLICE_WIDTH)
    {
        uint b = i / SW_SLICE_HEIGHT;
        swSliceTile tile = tiles[first + b];
        placeTile(b, i % SW_SLICE_HEIGHT, tile);
        if (i % SW_SLICE_HEIGHT == 0)
        {
            batchTiles[b] = tile;
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
    float s = splineX(tile, column);
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

// Adds a tile to the cubic that begins at a row of the block.
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
    mat4 pieces = cubicPieces(s - cell, tile.step);
    WEIGH_ROW(0)
    addCubic(cubic, pieces[0], value0, slope0);
    WEIGH_ROW(1)
    addCubic(cubic, pieces[1], value1, slope1);
    WEIGH_ROW(2)
    addCubic(cubic, pieces[2], value2, slope2);
    WEIGH_ROW(3)
    addCubic(cubic, pieces[3], value3, slope3);
}

#define ADD_COLUMN(k, component)                                                                                       \
    {                                                                                                                  \
        vec4 x = layouts[b][3 * (first + k) + 0];                                                                      \
        vec4 y = layouts[b][3 * (first + k) + 1];                                                                      \
        vec4 z = layouts[b][3 * (first + k) + 2];                                                                      \
        cubic.x = fma(vec4(value.component), x, cubic.x);                                                              \
        cubic.y = fma(vec4(value.component), y, cubic.y);                                                              \
        cubic.z = fma(vec4(value.component), z, cubic.z);                                                              \
        cubic.slopeX = fma(vec4(slope.component), x, cubic.slopeX);                                                    \
        cubic.slopeY = fma(vec4(slope.component), y, cubic.slopeY);                                                    \
        cubic.slopeZ = fma(vec4(slope.component), z, cubic.slopeZ);                                                    \
    }

// Adds a tile that is added as a block to a column's cubic.
void addBlock(inout Cubic cubic, uint b, swSliceTile tile, uint column)
{
    float s = splineX(tile, column);
    float cell = floor(s);
    vec4 value = swSplineWeights(s - cell);
    vec4 slope = swSplineSlopes(s - cell) * tile.perMetre;
    uint first = uint(cell - firstOfBlock(tile));
    ADD_COLUMN(0, x)
    ADD_COLUMN(1, y)
    ADD_COLUMN(2, z)
    ADD_COLUMN(3, w)
}

// Texels of a run ----------------------------------------------------------------------------------------------------

#define FOR_RUN(DO) DO(0) DO(1) DO(2) DO(3)

#define DECLARE_SUMS(t)                                                                                                \
    vec3 sum##t = vec3(evaluate(cubic.x, t), evaluate(cubic.y, t), evaluate(cubic.z, t));                              \
    vec3 alongX##t = vec3(evaluate(cubic.slopeX, t), evaluate(cubic.slopeY, t), evaluate(cubic.slopeZ, t));            \
    vec2 alongZ##t = list.texelsPerMetre * vec2(evaluateSlope(cubic.y, t), evaluateSlope(cubic.z, t));

#define WEIGHTS_OF_ROW(k) vec4 v##k = layouts[b][weightsAt(run, k)], w##k = layouts[b][weightsAt(run, k) + 1];

#define ADD_ROW(k, t, component)                                                                                       \
    sum##t = fma(vec3(v##k.component), value##k, sum##t);                                                              \
    alongX##t = fma(vec3(v##k.component), slope##k, alongX##t);                                                        \
    alongZ##t = fma(vec2(w##k.component), value##k.yz, alongZ##t);

#define ADD_TO_ALL(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 0, x) ADD_ROW(k, 1, y) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)
#define ADD_TO_LAST_THREE(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 1, y) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)
#define ADD_TO_LAST_TWO(k) WEIGHTS_OF_ROW(k) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)

// A free wave at a texel, then turned on to the next one.
#define ADD_WAVE(t)                                                                                                    \
    {                                                                                                                  \
        vec3 away = vec3(wave.dx * unit.y, -unit.x, wave.dz * unit.y);                                                 \
        vec3 rate = vec3(wave.dx * unit.x, unit.y, wave.dz * unit.x);                                                  \
        sum##t -= away;                                                                                                \
        alongX##t = fma(vec3(-wave.kx), rate, alongX##t);                                                              \
        alongZ##t = fma(vec2(-wave.kz), rate.yz, alongZ##t);                                                           \
        unit = vec2(unit.x * wave.cosZ - unit.y * wave.sinZ, unit.x * wave.sinZ + unit.y * wave.cosZ);                 \
    }

#define STORE_TEXEL(t) storeTexel(at + ivec3(0, t, 0), sum##t, alongX##t, alongZ##t);

// Columns beyond a narrow slice's edge store nothing: Vulkan drops what is outside an image.
// `alongZ` is of y and z.
void storeTexel(ivec3 at, vec3 sum, vec3 alongX, vec2 alongZ)
{
    float jacobian = swSurfaceJacobian(alongX.x, alongX.z, alongZ.y);
    float gx = swSurfaceNormalX(alongX.z, alongZ.y, alongX.y, alongZ.x);
    float gz = swSurfaceNormalZ(alongX.x, alongX.z, alongX.y, alongZ.x);
    imageStore(displacement, at, vec4(sum, jacobian));
    imageStore(derivatives, at, vec4(gx, gz, jacobian, 0.0));
}

// Lays out a batch of a list; the only batch of a list was laid out before everything.
void takeBatch(swSliceList list, uint batch)
{
    if (list.count > SW_SLICE_BATCH)
    {
        barrier(); // nobody reads the last batch any more
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
        for (uint bits = blockCubics; bits != 0; bits &= bits - 1)
        {
            uint b = findLSB(bits);
            addBlock(whole, b, batchTiles[b], column);
        }
        for (uint bits = columnCubics; bits != 0; bits &= bits - 1)
        {
            addToCubic(whole, batchTiles[findLSB(bits)], column, 0);
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
                addToCubic(cubic, batchTiles[findLSB(bits)], column, run * SW_SLICE_RUN);
            }
        }
        FOR_RUN(DECLARE_SUMS)
        for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
        {
            takeBatch(list, batch);
            for (uint bits = rowByRow[run]; bits != 0; bits &= bits - 1)
            {
                uint b = findLSB(bits);
                Window window = makeWindow(batchTiles[b], column);
                uint top = rowsZ[b][run].x;
                uint rowCount = rowsZ[b][run].y;
                // Texel 0's window begins at row 0, texel t's at row t + 1 at the latest: see isSparse in
                // pass_slices.c.
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
                    ADD_TO_LAST_TWO(5)
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
