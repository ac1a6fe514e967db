// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Spectra at the step's time, and the transform along x. One workgroup makes one row qz of one tile, for the three
// components Dx, h, Dz side by side. Heights are real, so row -qz is the conjugate of row qz and is never made.
//
// Leaves complex line values at firstLine + (((x / 4) * 3 + component) * (maxBin + 1) + qz) * 4 + x % 4: what one
// workgroup of the second axis reads lies together.
//
// A derivative by time turns each wave by a quarter and scales it by its frequency, so velocity and acceleration are
// the same pass over other spectra. Each is a layer of the dispatch, there only if a query wants it.

#include "shared/waves.h"

layout(constant_id = 0) const uint FFT_SIZE = 128;
layout(local_size_x_id = 1) in; // 3 N / 4

layout(std430, binding = 0) readonly buffer Tiles
{
    swTileParams tiles[];
};
layout(std430, binding = 1) readonly buffer Order
{
    uint order[]; // tiles of this resolution
};
layout(std430, binding = 2) readonly buffer Rows
{
    uint rows[]; // first mode of each row
};
layout(std430, binding = 3) readonly buffer Modes
{
    uint modes[]; // swMode, nine words each: qx qz | dx dz pr pi qr qi | frequency
};
layout(std430, binding = 4) readonly buffer Roots
{
    vec2 roots[];
};
layout(std430, binding = 5) writeonly buffer Lines
{
    vec2 lines[];
};
layout(push_constant) uniform Push
{
    swWavesParams params;
};

shared vec2 fftLine[3 * FFT_SIZE];

vec2 fftRoot(uint index)
{
    return roots[index];
}

#include "lib/fft.glsl"
#include "lib/turns.glsl"

// Put mode's spectra into the three lines, at bin qx; in row 0 its mirror image too.
void placeMode(swTileParams tile, uint mode, uint derivative, bool isRowZero)
{
    uint at = 9 * mode;
    uint bin = modes[at] & (FFT_SIZE - 1); // the low half is qx; its sign falls to the mask
    vec2 direction = vec2(uintBitsToFloat(modes[at + 1]), uintBitsToFloat(modes[at + 2]));
    vec2 p = vec2(uintBitsToFloat(modes[at + 3]), uintBitsToFloat(modes[at + 4]));
    vec2 q = vec2(uintBitsToFloat(modes[at + 5]), uintBitsToFloat(modes[at + 6]));
    uint phase = phaseOf(modes[at + 7], modes[at + 8], tile.ticksLow, tile.ticksHigh);
    vec2 unit = unitOf(phase + (derivative << 30));
    float scale = tile.weight;
    for (uint i = 0; i < derivative; ++i)
    {
        scale *= omegaOf(modes[at + 7], modes[at + 8]);
    }
    vec2 height = scale * vec2(p.x * unit.x + q.y * unit.y, p.y * unit.x - q.x * unit.y);
    vec2 alongX = direction.x * timesI(height);
    vec2 alongZ = direction.y * timesI(height);
    fftLine[bin] = alongX;
    fftLine[FFT_SIZE + bin] = height;
    fftLine[2 * FFT_SIZE + bin] = alongZ;
    if (isRowZero)
    {
        bin = (FFT_SIZE - bin) & (FFT_SIZE - 1);
        fftLine[bin] = vec2(alongX.x, -alongX.y);
        fftLine[FFT_SIZE + bin] = vec2(height.x, -height.y);
        fftLine[2 * FFT_SIZE + bin] = vec2(alongZ.x, -alongZ.y);
    }
}

void main()
{
    const uint QUARTER = FFT_SIZE / 4;
    swTileParams tile = tiles[order[params.firstOrder + gl_WorkGroupID.y]];
    uint field = gl_WorkGroupID.z;
    uint derivative = (params.derivatives >> (2 * field)) & 3u;
    uint row = gl_WorkGroupID.x;
    if (row > tile.maxBin)
    {
        return;
    }
    uint thread = gl_LocalInvocationID.x;
    uint component = thread / QUARTER;
    uint i = thread % QUARTER;
    uint line = component * FFT_SIZE;
    for (uint k = 0; k < 4; ++k)
    {
        fftLine[line + i + k * QUARTER] = vec2(0.0);
    }
    barrier();
    uint end = rows[tile.firstRow + row + 1];
    for (uint mode = rows[tile.firstRow + row] + thread; mode < end; mode += 3 * QUARTER)
    {
        placeMode(tile, mode, derivative, row == 0);
    }
    barrier();
    vec2 v[4];
    for (uint k = 0; k < 4; ++k)
    {
        v[k] = fftLine[line + i + k * QUARTER];
    }
    fftTransform(line, i, v);
    uint first = field * params.fieldLines + tile.firstLine;
    for (uint k = 0; k < 4; ++k)
    {
        uint x = i + k * QUARTER;
        lines[first + (((x >> 2) * 3 + component) * (tile.maxBin + 1) + row) * 4 + (x & 3)] = v[k];
    }
}
