// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their cubic
// B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong).
//
// The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a column
// share their weights along x, all texels of a row their weights along z. A thread owns a run of SW_SLICE_RUN texels along
// z and walks down the tile's rows once: each row is interpolated along x (value and slope) when the window first
// reaches it, and stays in registers as long as four-row windows contain it. Long waves move less than a row over a whole
// run; the shortest band of a slice about one row a texel. That is some 5.5 rows read a texel for all nine tiles of an
// average slice, where windows of 4 x 4 would read 36 rows' worth.

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

// Weights along z of the workgroup's rows, and the tile row at which a row's window begins (not wrapped).
shared vec4 valueZ[SW_SLICE_BATCH][SW_SLICE_HEIGHT];
shared vec4 slopeZ[SW_SLICE_BATCH][SW_SLICE_HEIGHT];
shared int rowZ[SW_SLICE_BATCH][SW_SLICE_HEIGHT];

void prepareRows(uint first, uint count)
{
    const uint THREADS = SW_SLICE_WIDTH * SW_SLICE_RUNS;
    for (uint i = gl_LocalInvocationIndex; i < count * SW_SLICE_HEIGHT; i += THREADS)
    {
        uint b = i / SW_SLICE_HEIGHT;
        uint row = i % SW_SLICE_HEIGHT;
        swSliceTile tile = tiles[first + b];
        float s = tile.fractionZ + float(gl_WorkGroupID.y * SW_SLICE_HEIGHT + row) * tile.step;
        float cell = floor(s);
        valueZ[b][row] = swSplineWeights(s - cell);
        slopeZ[b][row] = swSplineSlopes(s - cell) * tile.perMetre;
        rowZ[b][row] = int(tile.baseZ) + int(cell);
    }
}

// Four rows of a tile at a thread's column: displacement interpolated along x, and its derivative along x.
vec3 value0, value1, value2, value3;
vec3 slope0, slope1, slope2, slope3;

// The thread's place on the tile along x.
vec4 valueX, slopeX;
uint firstTexel, mask, pitch;

void interpolateRow(int row, out vec3 value, out vec3 slope)
{
    uint at = firstTexel + (uint(row) & mask) * pitch;
    vec3 a = texels[at].xyz;
    vec3 b = texels[at + 1].xyz;
    vec3 c = texels[at + 2].xyz;
    vec3 d = texels[at + 3].xyz;
    value = valueX.x * a + valueX.y * b + valueX.z * c + valueX.w * d;
    slope = slopeX.x * a + slopeX.y * b + slopeX.z * c + slopeX.w * d;
}

void shiftWindow(int row)
{
    value0 = value1;
    value1 = value2;
    value2 = value3;
    slope0 = slope1;
    slope1 = slope2;
    slope2 = slope3;
    interpolateRow(row, value3, slope3);
}

// Sums of a run's texels. Written out texel by texel: an array that a loop indexes would leave the registers.
#define FOR_RUN(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)

#define DECLARE_SUMS(t) vec3 sum##t = vec3(0.0), alongX##t = vec3(0.0), alongZ##t = vec3(0.0);

#define ADD_TEXEL(t)                                                                                                   \
    {                                                                                                                  \
        int target = rowZ[b][run + t];                                                                                 \
        top = max(top, target - 4); /* a tile finer than the slice: rows in between are of no use */                   \
        while (top < target)                                                                                           \
        {                                                                                                              \
            top += 1;                                                                                                  \
            shiftWindow(top + 3);                                                                                      \
        }                                                                                                              \
        vec4 v = valueZ[b][run + t];                                                                                   \
        vec4 d = slopeZ[b][run + t];                                                                                   \
        sum##t += v.x * value0 + v.y * value1 + v.z * value2 + v.w * value3;                                           \
        alongX##t += v.x * slope0 + v.y * slope1 + v.z * slope2 + v.w * slope3;                                        \
        alongZ##t += d.x * value0 + d.y * value1 + d.z * value2 + d.w * value3;                                        \
    }

#define STORE_TEXEL(t) storeTexel(ivec3(column, firstRow + t, slice), sum##t, alongX##t, alongZ##t);

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
    uint run = gl_LocalInvocationID.y * SW_SLICE_RUN;
    uint firstRow = gl_WorkGroupID.y * SW_SLICE_HEIGHT + run;
    FOR_RUN(DECLARE_SUMS)

    swSliceList list = lists[slice];
    for (uint batch = 0; batch < list.count; batch += SW_SLICE_BATCH)
    {
        uint batchCount = min(list.count - batch, uint(SW_SLICE_BATCH));
        barrier();
        prepareRows(list.first + batch, batchCount);
        barrier();
        for (uint b = 0; b < batchCount; ++b)
        {
            swSliceTile tile = tiles[list.first + batch + b];
            float s = tile.fractionX + float(column) * tile.step;
            float cell = floor(s);
            valueX = swSplineWeights(s - cell);
            slopeX = swSplineSlopes(s - cell) * tile.perMetre;
            mask = tile.resolution - 1;
            pitch = tile.resolution + 3;
            firstTexel = tile.firstTexel + ((tile.baseX + uint(cell)) & mask);
            int top = rowZ[b][run]; // row of the window's first entry
            interpolateRow(top, value0, slope0);
            interpolateRow(top + 1, value1, slope1);
            interpolateRow(top + 2, value2, slope2);
            interpolateRow(top + 3, value3, slope3);
            FOR_RUN(ADD_TEXEL)
        }
    }
    FOR_RUN(STORE_TEXEL)
}
