// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

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

// Four rows of a tile at a thread's column.
struct Window
{
    vec3 value[4]; // displacement, interpolated along x
    vec3 slope[4]; // its derivative along x
};

void main()
{
    uint slice = gl_WorkGroupID.z;
    uint column = gl_WorkGroupID.x * SW_SLICE_WIDTH + gl_LocalInvocationID.x;
    uint run = gl_LocalInvocationID.y * SW_SLICE_RUN;
    vec3 sum[SW_SLICE_RUN], alongX[SW_SLICE_RUN], alongZ[SW_SLICE_RUN];
    [[unroll]] for (uint t = 0; t < SW_SLICE_RUN; ++t)
    {
        sum[t] = alongX[t] = alongZ[t] = vec3(0.0);
    }

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
            vec4 valueX = swSplineWeights(s - cell);
            vec4 slopeX = swSplineSlopes(s - cell) * tile.perMetre;
            uint mask = tile.resolution - 1;
            uint pitch = tile.resolution + 3;
            uint first = tile.firstTexel + ((tile.baseX + uint(cell)) & mask);

            Window w;
            [[unroll]] for (uint k = 0; k < 4; ++k)
            {
                w.value[k] = w.slope[k] = vec3(0.0);
            }
            int top = rowZ[b][run] - 4; // row of the window's first entry
            [[unroll]] for (uint t = 0; t < SW_SLICE_RUN; ++t)
            {
                int target = rowZ[b][run + t];
                top = max(top, target - 4); // a tile finer than the slice: rows in between are of no use
                while (top < target)
                {
                    top += 1;
                    uint at = first + (uint(top + 3) & mask) * pitch;
                    vec3 p0 = texels[at].xyz;
                    vec3 p1 = texels[at + 1].xyz;
                    vec3 p2 = texels[at + 2].xyz;
                    vec3 p3 = texels[at + 3].xyz;
                    w.value[0] = w.value[1];
                    w.value[1] = w.value[2];
                    w.value[2] = w.value[3];
                    w.value[3] = valueX.x * p0 + valueX.y * p1 + valueX.z * p2 + valueX.w * p3;
                    w.slope[0] = w.slope[1];
                    w.slope[1] = w.slope[2];
                    w.slope[2] = w.slope[3];
                    w.slope[3] = slopeX.x * p0 + slopeX.y * p1 + slopeX.z * p2 + slopeX.w * p3;
                }
                vec4 v = valueZ[b][run + t];
                vec4 d = slopeZ[b][run + t];
                sum[t] += v.x * w.value[0] + v.y * w.value[1] + v.z * w.value[2] + v.w * w.value[3];
                alongX[t] += v.x * w.slope[0] + v.y * w.slope[1] + v.z * w.slope[2] + v.w * w.slope[3];
                alongZ[t] += d.x * w.value[0] + d.y * w.value[1] + d.z * w.value[2] + d.w * w.value[3];
            }
        }
    }

    [[unroll]] for (uint t = 0; t < SW_SLICE_RUN; ++t)
    {
        ivec3 at = ivec3(column, gl_WorkGroupID.y * SW_SLICE_HEIGHT + run + t, slice);
        float jacobian = swSurfaceJacobian(alongX[t].x, alongZ[t].x, alongX[t].z, alongZ[t].z);
        float gx = swSurfaceNormalX(alongX[t].z, alongZ[t].z, alongX[t].y, alongZ[t].y);
        float gz = swSurfaceNormalZ(alongX[t].x, alongZ[t].x, alongX[t].y, alongZ[t].y);
        imageStore(displacement, at, vec4(sum[t], jacobian));
        imageStore(derivatives, at, vec4(gx, gz, jacobian, 0.0));
    }
}
