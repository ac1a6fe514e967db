// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Each pair of opposite waves of each tile at the step's time, ready to be summed at any depth: height and rate as
// complex numbers, wave number, and how the pair fades towards the bottom. What fillTileChunk() of
// core/waves/waves_sum.inl makes for every block of points is made once here. Runs only in frames with a query of the
// water below.
//
// Floor: 40 bytes read and 48 written a pair; 1.3 MB for the 15,000 pairs of a default sea.

#include "shared/query.h"
#include "shared/waves.h"

#include "lib/turns.glsl"

layout(local_size_x = SW_VOLUME_MODES) in;

layout(std430, binding = 0) readonly buffer Tiles
{
    swTileParams tiles[];
};
layout(std430, binding = 1) readonly buffer Modes
{
    uint modes[]; // swMode, nine words each, see waves_rows.comp
};
layout(std430, binding = 2) writeonly buffer Waves
{
    swVolumeWave waves[];
};

// What the spline leaves of bin q along an axis: (sin(pi q / N) / (pi q / N))^4.
float responseOf(uint q, uint resolution)
{
    if (q == 0)
    {
        return 1.0;
    }
    float sine = unitOf(q * (0x80000000u / resolution)).y;
    float sinc = sine / (3.14159265359 * float(q) / float(resolution));
    return (sinc * sinc) * (sinc * sinc);
}

void main()
{
    swTileParams tile = tiles[gl_WorkGroupID.y];
    uint index = gl_GlobalInvocationID.x;
    if (index >= tile.modeCount)
    {
        return;
    }
    uint at = 9 * (tile.firstMode + index);
    ivec2 bin = ivec2(int(modes[at] << 16) >> 16, int(modes[at]) >> 16);
    vec2 p = vec2(uintBitsToFloat(modes[at + 3]), uintBitsToFloat(modes[at + 4]));
    vec2 q = vec2(uintBitsToFloat(modes[at + 5]), uintBitsToFloat(modes[at + 6]));
    vec2 unit = unitOf(phaseOf(modes[at + 7], modes[at + 8], tile.ticksLow, tile.ticksHigh));
    float omega = omegaOf(modes[at + 7], modes[at + 8]);
    float scale =
        2.0 * tile.weight * responseOf(uint(abs(bin.x)), tile.resolution) * responseOf(uint(bin.y), tile.resolution);
    float size = sqrt(float(bin.x * bin.x + bin.y * bin.y));

    swVolumeWave wave;
    wave.re = scale * (p.x * unit.x + q.y * unit.y);
    wave.im = scale * (p.y * unit.x - q.x * unit.y);
    wave.rateRe = scale * omega * (q.y * unit.x - p.x * unit.y);
    wave.rateIm = -scale * omega * (p.y * unit.y + q.x * unit.x);
    wave.k = 6.28318530718 / tile.side * size;
    wave.square = omega * omega;
    wave.unitX = float(bin.x) / size;
    wave.unitZ = float(bin.y) / size;
    wave.binX = uint(bin.x);
    wave.binZ = uint(bin.y);
    float fade = tile.depth < 1e9 ? exp(-2.0 * tile.depth * wave.k) : 0.0;
    wave.overSinh = fade < 1.0 ? 1.0 / (1.0 - fade) : 0.0;
    wave.overCosh = 1.0 / (1.0 + fade);
    waves[tile.firstMode + index] = wave;
}
