// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their cubic
// B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong), and of its free waves.
//
// Short tiles. The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a
// column share their weights along x, all texels of a row their weights along z. A thread owns a run of four texels along
// z and takes the tile rows that the run touches one by one: each is interpolated along x (value and slope) and added to
// the texels whose windows of four rows may hold it. Weights along z are the same for a whole row of texels; a workgroup
// lays them out in shared memory, by tile row, with zeros where a row is outside a texel's window, so that no branch
// depends on them.
//
// Long tiles, whose shortest wave is 64 texels or more, are not worth that at every texel. They are summed at nodes, every
// fourth texel along both axes, with their derivatives d/dx, d/dz and d2/dxdz, and interpolated between nodes by bicubic
// Hermite polynomials: off by (2 pi 4 / 64)^4 / 384 = 6e-5 of the waves' height. A run is one cell of nodes, so weights
// along z are constants. Sums at nodes are separable too: tile rows are combined along z first, for the few columns that
// a workgroup touches, then along x for each node.
//
// Free waves are evaluated one by one: at texels with their phases in integers, a run by rotating the first texel's sine
// and cosine; long ones at nodes.
//
// Measured on an H100, a default view, all at texels: 64 us, of which stores alone took 21. Slower were: runs of eight (76,
// registers), four rows kept in registers from texel to texel (68), tile texels copied to shared memory first (129), and
// threads that trade texels so that stores fill whole sectors (69).

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

const uint THREADS = SW_SLICE_WIDTH * SW_SLICE_RUNS;

// ---- long waves, at nodes ----

const uint NODES_X = SW_SLICE_WIDTH / 4 + 1;
const uint NODES_Z = SW_SLICE_HEIGHT / 4 + 1;
const uint NODES = NODES_X * NODES_Z;

// Of each node: displacement, and its derivatives d/dx, d/dz, d2/dxdz by steps of a node.
shared vec4 nodes[NODES][4];
// Of each long tile, row of nodes and tile column: displacement and its slope along z, a component an array.
shared float lines[SW_SLICE_LONG_BATCH][NODES_Z][2][3][SW_SLICE_LONG_COLUMNS];
// Of each long tile and column of nodes: weights along x for values, and for slopes.
shared vec4 nodeWeights[SW_SLICE_LONG_BATCH][NODES_X][2];

uvec2 blockOrigin()
{
    return gl_WorkGroupID.xy * uvec2(SW_SLICE_WIDTH, SW_SLICE_HEIGHT);
}

// Spline coordinate of a texel column or row of the slice. The same bits wherever it is asked for.
float splineAt(uint texel, float step, float fraction)
{
    return fma(float(texel), step, fraction);
}

void combineAlongZ(uint b, uint row, uint column, swSliceTile tile)
{
    float s = splineAt(blockOrigin().y + 4 * row, tile.step, tile.fractionZ);
    float cell = floor(s);
    vec4 value = swSplineWeights(s - cell);
    vec4 slope = swSplineSlopes(s - cell) * (4.0 * tile.step);
    uint mask = tile.resolution - 1;
    uint cellX = uint(floor(splineAt(blockOrigin().x, tile.step, tile.fractionX)));
    uint at = tile.firstTexel + (((tile.base & 0xffffu) + cellX + column) & mask);
    uint top = (tile.base >> 16) + uint(cell);
    vec3 along = vec3(0.0), slopes = vec3(0.0);
    for (uint k = 0; k < 4; ++k)
    {
        vec3 texel = texels[at + ((top + k) & mask) * (tile.resolution + 3)].xyz;
        along = fma(vec3(value[k]), texel, along);
        slopes = fma(vec3(slope[k]), texel, slopes);
    }
    for (uint c = 0; c < 3; ++c)
    {
        lines[b][row][0][c][column] = along[c];
        lines[b][row][1][c][column] = slopes[c];
    }
}

void prepareLongTiles(uint first, uint count)
{
    for (uint i = gl_LocalInvocationIndex; i < count * NODES_X; i += THREADS)
    {
        uint b = i / NODES_X;
        swSliceTile tile = tiles[first + b];
        float s = splineAt(blockOrigin().x + 4 * (i % NODES_X), tile.step, tile.fractionX);
        nodeWeights[b][i % NODES_X][0] = swSplineWeights(s - floor(s));
        nodeWeights[b][i % NODES_X][1] = swSplineSlopes(s - floor(s)) * (4.0 * tile.step);
    }
    const uint LINE = NODES_Z * SW_SLICE_LONG_COLUMNS;
    for (uint i = gl_LocalInvocationIndex; i < count * LINE; i += THREADS)
    {
        uint rest = i % LINE;
        combineAlongZ(i / LINE, rest / SW_SLICE_LONG_COLUMNS, rest % SW_SLICE_LONG_COLUMNS, tiles[first + i / LINE]);
    }
}

// One component at one node: value, d/dx, d/dz, d2/dxdz of a long tile.
vec4 combineAlongX(uint b, uint nodeX, uint nodeZ, uint c, swSliceTile tile)
{
    float origin = floor(splineAt(blockOrigin().x, tile.step, tile.fractionX));
    float cell = floor(splineAt(blockOrigin().x + 4 * nodeX, tile.step, tile.fractionX));
    uint at = uint(cell - origin);
    vec4 line = vec4(lines[b][nodeZ][0][c][at], lines[b][nodeZ][0][c][at + 1], lines[b][nodeZ][0][c][at + 2],
                     lines[b][nodeZ][0][c][at + 3]);
    vec4 slope = vec4(lines[b][nodeZ][1][c][at], lines[b][nodeZ][1][c][at + 1], lines[b][nodeZ][1][c][at + 2],
                      lines[b][nodeZ][1][c][at + 3]);
    vec4 value = nodeWeights[b][nodeX][0], slopeX = nodeWeights[b][nodeX][1];
    return vec4(dot(value, line), dot(slopeX, line), dot(value, slope), dot(slopeX, slope));
}

// The same of a free wave.
vec4 freeWaveAtNode(swSliceWave wave, uint nodeX, uint nodeZ, uint c, float nodeSide)
{
    uvec2 texel = blockOrigin() + 4 * uvec2(nodeX, nodeZ);
    vec2 unit = wave.amplitude * unitOf(wave.phase + texel.x * wave.stepX + texel.y * wave.stepZ);
    float kx = wave.kx * nodeSide, kz = wave.kz * nodeSide;
    if (c == 1)
    {
        return vec4(unit.x, -kx * unit.y, -kz * unit.y, -kx * kz * unit.x);
    }
    float d = c == 0 ? wave.dx : wave.dz;
    return d * vec4(-unit.y, -kx * unit.x, -kz * unit.x, kx * kz * unit.y);
}

// A thread makes one component of one node.
void sumNodes(swSliceList list)
{
    uint firstLong = list.first + list.count - list.longCount;
    uint node = gl_LocalInvocationIndex / 3, c = gl_LocalInvocationIndex % 3;
    uint nodeX = node % NODES_X, nodeZ = node / NODES_X;
    bool hasNode = node < NODES;
    vec4 sum = vec4(0.0);
    for (uint batch = 0; batch < list.longCount; batch += SW_SLICE_LONG_BATCH)
    {
        uint batchCount = min(list.longCount - batch, uint(SW_SLICE_LONG_BATCH));
        barrier();
        prepareLongTiles(firstLong + batch, batchCount);
        barrier();
        for (uint b = 0; hasNode && b < batchCount; ++b)
        {
            sum += combineAlongX(b, nodeX, nodeZ, c, tiles[firstLong + batch + b]);
        }
    }
    for (uint i = 0; hasNode && i < list.longWaveCount; ++i)
    {
        sum += freeWaveAtNode(waves[list.firstWave + i], nodeX, nodeZ, c, list.nodeSide);
    }
    if (hasNode)
    {
        for (uint q = 0; q < 4; ++q)
        {
            nodes[node][q][c] = sum[q];
        }
    }
}

// Hermite's polynomials for value and derivative at the left, then at the right, and their derivatives.
vec4 hermite(float t)
{
    float t2 = t * t, t3 = t2 * t;
    return vec4(1.0 - 3.0 * t2 + 2.0 * t3, t - 2.0 * t2 + t3, 3.0 * t2 - 2.0 * t3, t3 - t2);
}

vec4 hermiteSlope(float t)
{
    float t2 = t * t;
    return vec4(6.0 * t2 - 6.0 * t, 1.0 - 4.0 * t + 3.0 * t2, 6.0 * t - 6.0 * t2, 3.0 * t2 - 2.0 * t);
}

vec3 mixNodes(vec4 weights, vec4 a, vec4 b, vec4 c, vec4 d)
{
    return weights.x * a.xyz + weights.y * b.xyz + weights.z * c.xyz + weights.w * d.xyz;
}

// ---- short tiles, at texels ----

// Of each tile, run and tile row: weights of the run's four texels for values, and for slopes.
shared vec4 weightsZ[SW_SLICE_BATCH][SW_SLICE_RUNS][SW_SLICE_ROWS][2];
// Of each tile and run: its first row (not wrapped), and how many rows it touches.
shared uvec2 rowsZ[SW_SLICE_BATCH][SW_SLICE_RUNS];

void placeWeights(uint b, uint run, uint t, swSliceTile tile)
{
    uint firstRow = blockOrigin().y + run * SW_SLICE_RUN;
    float top = floor(splineAt(firstRow + findLSB(tile.runMask), tile.step, tile.fractionZ));
    float s = splineAt(firstRow + t, tile.step, tile.fractionZ);
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

#define ADD_NODES(t)                                                                                                   \
    {                                                                                                                  \
        vec4 h = hermite(0.25 * t);                                                                                    \
        vec4 slope = hermiteSlope(0.25 * t) * perMetre;                                                                \
        sum##t = h.x * p0 + h.y * q0 + h.z * p1 + h.w * q1;                                                            \
        alongX##t = h.x * p0x + h.y * q0x + h.z * p1x + h.w * q1x;                                                     \
        alongZ##t = slope.x * p0 + slope.y * q0 + slope.z * p1 + slope.w * q1;                                         \
    }

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
    uint column = blockOrigin().x + gl_LocalInvocationID.x;
    uint run = gl_LocalInvocationID.y;
    FOR_RUN(DECLARE_SUMS)

    swSliceList list = lists[slice];
    if (list.longCount + list.longWaveCount > 0)
    {
        sumNodes(list);
        barrier();
        float perMetre = 1.0 / list.nodeSide;
        float t = 0.25 * float(gl_LocalInvocationID.x & 3);
        vec4 h = hermite(t), slope = hermiteSlope(t) * perMetre;
        uint n = run * NODES_X + (gl_LocalInvocationID.x >> 2), m = n + NODES_X;
        vec3 p0 = mixNodes(h, nodes[n][0], nodes[n][1], nodes[n + 1][0], nodes[n + 1][1]);
        vec3 q0 = mixNodes(h, nodes[n][2], nodes[n][3], nodes[n + 1][2], nodes[n + 1][3]);
        vec3 p0x = mixNodes(slope, nodes[n][0], nodes[n][1], nodes[n + 1][0], nodes[n + 1][1]);
        vec3 q0x = mixNodes(slope, nodes[n][2], nodes[n][3], nodes[n + 1][2], nodes[n + 1][3]);
        vec3 p1 = mixNodes(h, nodes[m][0], nodes[m][1], nodes[m + 1][0], nodes[m + 1][1]);
        vec3 q1 = mixNodes(h, nodes[m][2], nodes[m][3], nodes[m + 1][2], nodes[m + 1][3]);
        vec3 p1x = mixNodes(slope, nodes[m][0], nodes[m][1], nodes[m + 1][0], nodes[m + 1][1]);
        vec3 q1x = mixNodes(slope, nodes[m][2], nodes[m][3], nodes[m + 1][2], nodes[m + 1][3]);
        FOR_RUN(ADD_NODES)
    }
    uint shortCount = list.count - list.longCount;
    for (uint batch = 0; batch < shortCount; batch += SW_SLICE_BATCH)
    {
        uint batchCount = min(shortCount - batch, uint(SW_SLICE_BATCH));
        barrier();
        prepareTiles(list.first + batch, batchCount);
        barrier();
        for (uint b = 0; b < batchCount; ++b)
        {
            swSliceTile tile = tiles[list.first + batch + b];
            float s = splineAt(column, tile.step, tile.fractionX);
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
    uint row = blockOrigin().y + run * SW_SLICE_RUN;
    for (uint i = list.longWaveCount; i < list.waveCount; ++i)
    {
        swSliceWave wave = waves[list.firstWave + i];
        vec2 unit = wave.amplitude * unitOf(wave.phase + column * wave.stepX + row * wave.stepZ);
        FOR_RUN(ADD_WAVE)
    }
    ivec3 at = ivec3(column, row, slice);
    FOR_RUN(STORE_TEXEL)
}
