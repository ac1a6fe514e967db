// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Slopes of each tile's height, for shading what a slice is too coarse to hold: (sx, sz, sx^2, sz^2), with mips that
// average all four. Where a mip has lost slopes, their variance s2 - s s is left for the roughness of the surface
// [Bruneton 2010]. Slopes are the spline's own, by rest position, at points i side / D; one workgroup makes 32 x 32 of
// them and averages down to one, so that all mips come from one dispatch.

#include "lib/blocks.glsl"
#include "shared/spline.h"
#include "shared/waves.h"

layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer Tiles
{
    swTileParams tiles[];
};
layout(std430, binding = 1) readonly buffer Texels
{
    vec4 texels[];
};
layout(binding = 2, rgba16f) uniform writeonly image2DArray mip0;
layout(binding = 3, rgba16f) uniform writeonly image2DArray mip1;
layout(binding = 4, rgba16f) uniform writeonly image2DArray mip2;
layout(binding = 5, rgba16f) uniform writeonly image2DArray mip3;
layout(binding = 6, rgba16f) uniform writeonly image2DArray mip4;
layout(binding = 7, rgba16f) uniform writeonly image2DArray mip5;
layout(push_constant) uniform Push
{
    uint side; // D, texels
};

// A tile has at most two samples a detail texel (512 samples on 256 texels).
#define MAX_SPAN (2 * SW_DETAIL_BLOCK + 3)
shared float heights[MAX_SPAN * MAX_SPAN]; // then the slopes made of them
shared vec4 means[16][16];

// Coefficients that the block's windows touch.
void loadHeights(swTileParams tile, ivec2 corner, uint span)
{
    uint mask = tile.resolution - 1;
    for (uint i = gl_LocalInvocationIndex; i < span * span; i += 256)
    {
        uvec2 at = uvec2(corner) + uvec2(i % span, i / span);
        heights[i] = texels[tile.firstTexel + (at.y & mask) * (tile.resolution + 3) + (at.x & mask)].y;
    }
}

vec2 slopeAt(vec2 spline, uint span, float perMetre)
{
    vec2 cell = floor(spline);
    vec2 t = spline - cell;
    vec4 valueX = swSplineWeights(t.x), slopeX = swSplineSlopes(t.x);
    vec4 valueZ = swSplineWeights(t.y), slopeZ = swSplineSlopes(t.y);
    uint first = uint(cell.y) * span + uint(cell.x);
    vec2 slope = vec2(0.0);
    for (uint j = 0; j < 4; ++j)
    {
        uint at = first + j * span;
        vec4 row = vec4(heights[at], heights[at + 1], heights[at + 2], heights[at + 3]);
        slope += vec2(dot(row, slopeX) * valueZ[j], dot(row, valueX) * slopeZ[j]);
    }
    return slope * perMetre;
}

vec4 meanOfFour(uint x, uint y)
{
    return 0.25 * (means[y][x] + means[y][x + 1] + means[y + 1][x] + means[y + 1][x + 1]);
}

void storeMean(uint level, ivec3 at, vec4 mean)
{
    if (level == 2)
    {
        imageStore(mip2, at, mean);
    }
    else if (level == 3)
    {
        imageStore(mip3, at, mean);
    }
    else if (level == 4)
    {
        imageStore(mip4, at, mean);
    }
    else
    {
        imageStore(mip5, at, mean);
    }
}

void main()
{
    uint tileIndex = gl_WorkGroupID.z;
    swTileParams tile = tiles[tileIndex];
    float ratio = float(tile.resolution) / float(side); // a power of two: all coordinates are exact
    ivec2 corner = ivec2(vec2(gl_WorkGroupID.xy * SW_DETAIL_BLOCK) * ratio);
    uint span = max(uint(ratio * float(SW_DETAIL_BLOCK)), 1u) + 3u;
    loadHeights(tile, corner, span);
    barrier();

    // A thread makes four neighbours, whose mean is a texel of mip 1.
    uvec2 thread = blockPlace(gl_LocalInvocationIndex);
    ivec2 block = ivec2(gl_WorkGroupID.xy);
    float perMetre = float(tile.resolution) / tile.side;
    vec2 slopes[4];
    vec4 mean = vec4(0.0);
    for (uint q = 0; q < 4; ++q)
    {
        slopes[q] = slopeAt(vec2(2 * thread + uvec2(q & 1, q >> 1)) * ratio, span, perMetre);
        mean += 0.25 * vec4(slopes[q], slopes[q] * slopes[q]);
    }
    imageStore(mip1, ivec3(block * 16 + ivec2(thread), tileIndex), mean);
    means[thread.y][thread.x] = mean;

    // They change places, so that threads side by side store texels side by side.
    barrier();
    for (uint q = 0; q < 4; ++q)
    {
        uint at = (2 * thread.y + (q >> 1)) * SW_DETAIL_BLOCK + 2 * thread.x + (q & 1);
        heights[2 * at] = slopes[q].x;
        heights[2 * at + 1] = slopes[q].y;
    }
    barrier();
    for (uint q = 0; q < 4; ++q)
    {
        uvec2 local = thread + 16 * uvec2(q & 1, q >> 1);
        uint at = local.y * SW_DETAIL_BLOCK + local.x;
        vec2 slope = vec2(heights[2 * at], heights[2 * at + 1]);
        imageStore(mip0, ivec3(block * SW_DETAIL_BLOCK + ivec2(local), tileIndex), vec4(slope, slope * slope));
    }
    for (uint level = 2; level < SW_DETAIL_MIPS; ++level)
    {
        uint width = 32 >> level;
        barrier();
        bool isActive = thread.x < width && thread.y < width;
        if (isActive)
        {
            mean = meanOfFour(2 * thread.x, 2 * thread.y);
            storeMean(level, ivec3(block * int(width) + ivec2(thread), tileIndex), mean);
        }
        barrier();
        if (isActive)
        {
            means[thread.y][thread.x] = mean;
        }
    }
}
