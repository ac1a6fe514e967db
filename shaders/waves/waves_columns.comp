// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// The transform along z, and the tile's texels. One workgroup takes four columns of one tile: twelve real results,
// packed in pairs into six complex transforms: (Dx, Dz) of each column, and h of two columns at a time. The lines of
// rows -qz are the conjugates of rows qz; bins beyond N / 4 are empty. Fields are layers of the dispatch, as in
// waves_rows.comp.

#include "shared/waves.h"

layout(constant_id = 0) const uint FFT_SIZE = 128;
layout(local_size_x_id = 1) in; // 6 N / 4

layout(std430, binding = 0) readonly buffer Tiles
{
    swTileParams tiles[];
};
layout(std430, binding = 1) readonly buffer Order
{
    uint order[]; // tiles of this resolution
};
layout(std430, binding = 2) readonly buffer Roots
{
    vec2 roots[];
};
layout(std430, binding = 3) readonly buffer Lines
{
    vec2 lines[]; // see waves_rows.comp
};
layout(std430, binding = 4) writeonly buffer Texels
{
    vec4 texels[];
};
layout(push_constant) uniform Push
{
    swWavesParams params;
};

shared vec2 fftLine[6 * FFT_SIZE];

vec2 fftRoot(uint index)
{
    return roots[index];
}

#include "lib/fft.glsl"

// Bin qz >= 0 of two real fields packed as first + i second, or its mirror image at -qz.
vec2 packedBin(uint first, uint second, uint maxBin, uint qz, bool isMirrored)
{
    if (qz > maxBin)
    {
        return vec2(0.0);
    }
    vec2 a = lines[first + 4 * qz];
    vec2 b = lines[second + 4 * qz];
    return isMirrored ? vec2(a.x + b.y, b.x - a.y) : vec2(a.x - b.y, a.y + b.x);
}

// Samples 0 .. N - 1 of a row lie at columns 1 .. N; 0, N + 1 and N + 2 repeat.
void storeTexel(swTileParams tile, uint x, uint z, vec4 texel)
{
    uint first = gl_WorkGroupID.z * params.fieldTexels + tile.firstTexel + ((z + 1) & (FFT_SIZE - 1)) * (FFT_SIZE + 3);
    texels[first + x + 1] = texel;
    if (x < 2)
    {
        texels[first + x + 1 + FFT_SIZE] = texel;
    }
    if (x == FFT_SIZE - 1)
    {
        texels[first] = texel;
    }
}

void main()
{
    const uint QUARTER = FFT_SIZE / 4;
    swTileParams tile = tiles[order[params.firstOrder + gl_WorkGroupID.y]];
    uint block = gl_WorkGroupID.x;
    uint thread = gl_LocalInvocationID.x;
    uint transform = thread / QUARTER;
    uint i = thread % QUARTER;

    uint componentLines = 4 * (tile.maxBin + 1);
    uint blockLines = gl_WorkGroupID.z * params.fieldLines + tile.firstLine + block * 3 * componentLines;
    bool isHeight = transform >= 4;
    uint column = isHeight ? 2 * (transform - 4) : transform;
    uint first = blockLines + (isHeight ? componentLines : 0) + column;
    uint second = isHeight ? first + 1 : first + 2 * componentLines;

    vec2 v[4];
    v[0] = packedBin(first, second, tile.maxBin, i, false);
    v[1] = packedBin(first, second, tile.maxBin, i + QUARTER, false); // none but N / 4 itself
    v[2] = vec2(0.0);
    v[3] = packedBin(first, second, tile.maxBin, QUARTER - i, true);
    uint line = transform * FFT_SIZE;
    fftTransform(line, i, v);

    barrier();
    for (uint k = 0; k < 4; ++k)
    {
        fftLine[line + i + k * QUARTER] = v[k];
    }
    barrier();
    for (uint texel = thread; texel < SW_COLUMN_BLOCK * FFT_SIZE; texel += 6 * QUARTER)
    {
        uint x = texel % SW_COLUMN_BLOCK;
        uint z = texel / SW_COLUMN_BLOCK;
        vec2 sideways = fftLine[x * FFT_SIZE + z];
        vec2 heights = fftLine[(4 + x / 2) * FFT_SIZE + z];
        float height = (x & 1) == 0 ? heights.x : heights.y;
        storeTexel(tile, block * SW_COLUMN_BLOCK + x, z, vec4(sideways.x, height, sideways.y, 0.0));
    }
}
