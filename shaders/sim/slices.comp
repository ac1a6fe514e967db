// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their cubic
// B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong), and of its free waves.
//
// The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a column
// share their weights along x, all texels of a row their weights along z. A thread owns a run of four texels along z and
// takes the tile rows that the run touches one by one: each is interpolated along x (value and slope) and added to the
// texels whose windows of four rows may hold it. Most tiles of a slice are so long that a run touches five rows at most;
// the shortest touches up to eight. That is some 11 rows a texel for all nine tiles of an average slice, where windows of
// 4 x 4 would read 36. Weights along z are the same for a whole row of texels; a workgroup lays them out in shared
// memory, by tile row, with zeros where a row is outside a texel's window, so that no branch depends on them.
//
// Free waves are evaluated one by one, with their phases in integers: a run turns the first texel's sine and cosine on.
//
// Measured on an H100, a default view: 64 us, of which stores alone take 21 and everything but loads 45. Slower were: runs of
// eight (76, registers), four rows kept in registers from texel to texel (68), tile texels copied to shared memory first
// (129), threads that trade texels so that stores fill whole sectors (69; stores alone then take 9), and tiles whose waves
// are 64 texels and longer summed with their derivatives at every fourth texel and interpolated by bicubic Hermite
// polynomials (74: the sums at nodes cost barriers and shared memory that the texels do not win back).

#include "lib/turns.glsl"
#include "shared/spline.h"
#include "shared/surface_normal.h"
#include "shared/waves.h"

layout(local_size_x = SW_SLICE_WIDTH, local_size_y = SW_SLICE_RUNS) in;

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

// Spline coordinate of a row of the block. The same bits wherever it is asked for: windows and weights must not disagree.
float splineZ(swSliceTile tile, uint row)
{
    return fma(float(gl_WorkGroupID.y * SW_SLICE_HEIGHT + row), tile.step, tile.fractionZ);
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

void prepareTiles(uint first, uint count)
{
    const uint THREADS = SW_SLICE_WIDTH * SW_SLICE_RUNS;
    for (uint i = gl_LocalInvocationIndex; i < count * SW_SLICE_HEIGHT; i += THREADS)
    {
        uint b = i / SW_SLICE_HEIGHT;
        uint row = i % SW_SLICE_HEIGHT;
        placeWeights(b, row / SW_SLICE_RUN, row % SW_SLICE_RUN, tiles[first + b]);
    }
}

// Displacement interpolated along x.
vec3 weigh(vec4 weights, vec3 a, vec3 b, vec3 c, vec3 d)
{
    return fma(vec3(weights.w), d, fma(vec3(weights.z), c, fma(vec3(weights.y), b, weights.x * a)));
}

// The texels of a run have names, not indices: an array that a loop indexes would leave the registers.
#define FOR_RUN(DO) DO(0) DO(1) DO(2) DO(3)

#define DECLARE_SUMS(t) vec3 sum##t = vec3(0.0), alongX##t = vec3(0.0), alongZ##t = vec3(0.0);

#define LOAD_ROW(k)                                                                                                    \
    uint at##k = first + ((top + k) & mask) * pitch;                                                                   \
    vec3 a##k = texels[at##k].xyz, b##k = texels[at##k + 1].xyz;                                                       \
    vec3 c##k = texels[at##k + 2].xyz, d##k = texels[at##k + 3].xyz;

#define WEIGH_ROW(k)                                                                                                   \
    vec3 value##k = weigh(valueX, a##k, b##k, c##k, d##k);                                                             \
    vec3 slope##k = weigh(slopeX, a##k, b##k, c##k, d##k);                                                             \
    vec4 v##k = weightsZ[b][run][k][0], w##k = weightsZ[b][run][k][1];

#define ADD_ROW(k, t, component)                                                                                       \
    sum##t = fma(vec3(v##k.component), value##k, sum##t);                                                              \
    alongX##t = fma(vec3(v##k.component), slope##k, alongX##t);                                                        \
    alongZ##t = fma(vec3(w##k.component), value##k, alongZ##t);

#define ADD_TO_ALL(k) ADD_ROW(k, 0, x) ADD_ROW(k, 1, y) ADD_ROW(k, 2, z) ADD_ROW(k, 3, w)

// The wave at a texel, then turned on to the next one.
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

void storeTexel(ivec3 at, vec3 sum, vec3 alongX, vec3 alongZ)
{
    float jacobian = swSurfaceJacobian(alongX.x, alongZ.x, alongX.z, alongZ.z);
    float gx = swSurfaceNormalX(alongX.z, alongZ.z, alongX.y, alongZ.y);
    float gz = swSurfaceNormalZ(alongX.x, alongZ.x, alongX.y, alongZ.y);
    imageStore(displacement, at, vec4(sum, jacobian));
    imageStore(derivatives, at, vec4(gx, gz, jacobian, 0.0));
}

void main()
{
    uint slice = gl_WorkGroupID.z;
    uint column = gl_WorkGroupID.x * SW_SLICE_WIDTH + gl_LocalInvocationID.x;
    uint run = gl_LocalInvocationID.y;
    FOR_RUN(DECLARE_SUMS)

    swSliceList list = lists[slice];
    for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
    {
        uint batchCount = min(list.count - batch, uint(SW_SLICE_BATCH));
        barrier();
        prepareTiles(list.first + batch, batchCount);
        barrier();
        for (uint b = 0; b < batchCount; ++b)
        {
            swSliceTile tile = tiles[list.first + batch + b];
            float s = fma(float(column), tile.step, tile.fractionX);
            float cell = floor(s);
            vec4 valueX = swSplineWeights(s - cell);
            vec4 slopeX = swSplineSlopes(s - cell) * tile.perMetre;
            uint mask = tile.resolution - 1;
            uint pitch = tile.resolution + 3;
            uint first = tile.firstTexel + (((tile.base & 0xffffu) + uint(cell)) & mask);
            uint top = rowsZ[b][run].x;
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
            ADD_ROW(4, 1, y)
            ADD_ROW(4, 2, z)
            ADD_ROW(4, 3, w)
            if (rowsZ[b][run].y > 5)
            {
                LOAD_ROW(5)
                LOAD_ROW(6)
                LOAD_ROW(7)
                WEIGH_ROW(5)
                ADD_ROW(5, 1, y)
                ADD_ROW(5, 2, z)
                ADD_ROW(5, 3, w)
                WEIGH_ROW(6)
                ADD_ROW(6, 2, z)
                ADD_ROW(6, 3, w)
                WEIGH_ROW(7)
                ADD_ROW(7, 3, w)
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
}
