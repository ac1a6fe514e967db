// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// The water below its surface by linear theory: the GPU's twin of core/query/volume.c. The surface above each place was
// searched by surface_query.comp. Every wave fades with depth at its own rate, so that no tile can hold the motion and
// waves are summed one by one; those too short to reach a place are skipped, a tile at once.
//
// Four lanes share a place and take every fourth wave; the waves of a tile pass through shared memory, which 64 places
// read.
//
// Floor: some 50 operations a place and wave, 15,000 pairs of a default sea: 75 Gflop for 100,000 places at the
// surface. Memory does not count: the waves are 0.7 MB, read by each workgroup.

#include "shared/query.h"

const uint THREADS = SW_QUERY_LANES * SW_VOLUME_POINTS;
layout(local_size_x = THREADS) in;

layout(std140, binding = 0) uniform Tiles
{
    swVolumeTile tiles[SW_LIMIT_TILES];
};
layout(std430, binding = 1) readonly buffer FreeWaves
{
    swQueryWave freeWaves[];
};
layout(std430, binding = 2) readonly buffer Waves
{
    uvec4 waves[]; // swVolumeWave, three each
};
layout(std430, binding = 3) readonly buffer Points
{
    uint points[];
};
layout(std430, binding = 4) readonly buffer Levels
{
    float levels[]; // of the places, m above the places' zero; unless points are floats
};
layout(std430, binding = 5) readonly buffer Heights
{
    vec2 heights[]; // of the surface above
};
layout(std430, binding = 6) writeonly buffer Depths
{
    vec2 depths[]; // depth, pressure head
};
layout(std430, binding = 7) writeonly buffer Velocities
{
    vec4 velocities[]; // and 0
};
layout(std430, binding = 8) writeonly buffer Accelerations
{
    vec4 accelerations[]; // and 0
};
layout(std430, binding = 9) readonly buffer Stills
{
    vec2 stills[]; // level of still water above sea level; and holes, which do not count here
};
layout(push_constant) uniform Push
{
    swVolumeParams params;
};

#include "lib/turns.glsl"
#include "query/query_place.glsl"
#include "query/query_points.glsl"

shared uvec4 chunk[3 * SW_VOLUME_CHUNK];
shared uint highest; // the least way down to a place of the workgroup, m, as bits
shared vec4 shares[2][THREADS];

// A place in the water.
struct Below
{
    float depth;  // under the surface, m
    float height; // that counts, above still water there, at most 0
    bool isWet;
};

// Heights between trough and crest, as stretch() in core/query/volume.c has them.
float stretched(float y, float eta)
{
    float below = y - eta;
    if (params.isWheeler == 0)
    {
        return y;
    }
    float column = params.bottom + eta;
    return params.bottom < 1e9 ? (column > 0.0 ? params.bottom * below / column : 0.0) : below;
}

Below findBelow(uint point, Place place)
{
    if (place.isBad)
    {
        return Below(0.0, 0.0, false);
    }
    float y = params.source.isFloatPoint != 0
                  ? uintBitsToFloat(points[params.source.firstWord + point * params.source.pointWords + 1])
                  : levels[point];
    float still = stills[point].x;
    y += params.level - still;
    float eta = heights[point].x - still;
    return Below(eta - y, min(stretched(y, eta), 0.0), eta >= y);
}

// Of a lane: its share.
struct Sum
{
    vec4 velocity; // and pressure head
    vec3 acceleration;
};

// How a wave's motion has faded at a height above still water.
struct Fading
{
    float horizontal, vertical, pressure;
};

Fading fadingOf(float k, float height, float depth, float overSinh, float overCosh)
{
    float down = exp(k * height);
    float up = depth < 1e9 ? exp(-k * (height + 2.0 * depth)) : 0.0;
    return Fading((down + up) * overSinh, (down - up) * overSinh, (down + up) * overCosh);
}

void addMotion(vec2 wave, vec2 rate, float square, vec2 unit, Fading fading, inout Sum sum)
{
    vec3 way = vec3(unit.x * fading.horizontal, fading.vertical, unit.y * fading.horizontal);
    sum.velocity += vec4(way * vec3(-rate.y, rate.x, -rate.y), fading.pressure * wave.x);
    sum.acceleration += square * way * vec3(wave.y, -wave.x, wave.y);
}

// (Re, Im) of a number turned by an angle, given its cosine and sine.
vec2 turned(vec2 number, vec2 unit)
{
    return vec2(number.x * unit.x - number.y * unit.y, number.x * unit.y + number.y * unit.x);
}

void addChunk(uint count, uvec2 turns, float height, float depth, uint lane, inout Sum sum)
{
    for (uint i = lane; i < count; i += SW_QUERY_LANES)
    {
        vec4 swing = uintBitsToFloat(chunk[3 * i]);
        vec4 kind = uintBitsToFloat(chunk[3 * i + 1]);
        uvec4 rest = chunk[3 * i + 2];
        vec2 unit = unitOf(rest.x * turns.x + rest.y * turns.y);
        Fading fading = fadingOf(kind.x, height, depth, uintBitsToFloat(rest.z), uintBitsToFloat(rest.w));
        addMotion(turned(swing.xy, unit), turned(swing.zw, unit), kind.y, kind.zw, fading, sum);
    }
}

// All threads of the workgroup call it together.
void addTile(swVolumeTile tile, Place place, Below below, bool isReached, uint lane, inout Sum sum)
{
    uvec2 turns = uvec2(tile.turnsX, tile.turnsZ) + uvec2(place.cell) * tile.cellTurns +
                  uvec2(toTurns(place.rest.x * tile.turnsPerMetre), toTurns(place.rest.y * tile.turnsPerMetre));
    float height = max(below.height, -tile.depth);
    for (uint first = 0; first < tile.waveCount; first += SW_VOLUME_CHUNK)
    {
        uint count = min(tile.waveCount - first, SW_VOLUME_CHUNK);
        barrier(); // others may still read the chunk before
        for (uint i = gl_LocalInvocationIndex; i < 3 * count; i += THREADS)
        {
            chunk[i] = waves[3 * (tile.firstWave + first) + i];
        }
        barrier();
        if (isReached)
        {
            addChunk(count, turns, height, tile.depth, lane, sum);
        }
    }
}

void addFreeWave(swQueryWave wave, Place place, Below below, inout Sum sum)
{
    float size = length(vec2(wave.turnsX, wave.turnsZ));
    float k = 6.28318530718 * size;
    float fade = wave.depth < 1e9 ? exp(-2.0 * k * wave.depth) : 0.0;
    float overSinh = fade < 1.0 ? 1.0 / (1.0 - fade) : 0.0;
    Fading fading = fadingOf(k, max(below.height, -wave.depth), wave.depth, overSinh, 1.0 / (1.0 + fade));
    vec2 swing = swingOf(wave, place.cell, place.rest);
    vec2 rate = wave.rate * vec2(swing.y, -swing.x);
    addMotion(swing, rate, wave.rate * wave.rate, vec2(wave.turnsX, wave.turnsZ) / size, fading, sum);
}

// Of tiles whose waves reach the place, and of free waves. Waves that reach no place of the workgroup are not even
// read.
Sum addWaves(Place place, Below below, uint lane)
{
    Sum sum = Sum(vec4(0.0), vec3(0.0));
    const float LENGTHS = 6.28318530718 / SW_VOLUME_FADED; // waves so many depths long, and longer, reach it
    float shortest = uintBitsToFloat(highest) * LENGTHS;
    for (uint i = 0; i < params.tileCount; ++i)
    {
        if (tiles[i].maxWavelength > shortest)
        {
            bool isReached = below.isWet && tiles[i].maxWavelength > abs(below.height) * LENGTHS;
            addTile(tiles[i], place, below, isReached, lane, sum);
        }
    }
    for (uint i = lane; i < params.waveCount && below.isWet; i += SW_QUERY_LANES)
    {
        addFreeWave(freeWaves[i], place, below, sum);
    }
    return sum;
}

vec4 gather(uint part)
{
    uint first = gl_LocalInvocationIndex / SW_QUERY_LANES * SW_QUERY_LANES;
    return shares[part][first] + shares[part][first + 1] + (shares[part][first + 2] + shares[part][first + 3]);
}

// One lane for each output.
void store(uint point, float depth, bool isBad, uint lane)
{
    float none = noNumber();
    if (lane == 0)
    {
        depths[point] = isBad ? vec2(none) : vec2(depth, gather(0).w);
    }
    else if (lane == 1 && (params.outputs & SW_QUERY_WANTS_VELOCITY) != 0)
    {
        velocities[point] = isBad ? vec4(none) : vec4(gather(0).xyz, 0.0);
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_ACCELERATION) != 0)
    {
        accelerations[point] = isBad ? vec4(none) : gather(1);
    }
}

void main()
{
    uint lane = gl_LocalInvocationIndex % SW_QUERY_LANES;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint point = group * SW_VOLUME_POINTS + gl_LocalInvocationIndex / SW_QUERY_LANES;
    uint known = min(point, params.source.count - 1);
    Place place = readPlace(known);
    Below below = findBelow(known, place);
    if (gl_LocalInvocationIndex == 0)
    {
        highest = 0x7f7fffffu;
    }
    barrier();
    if (below.isWet && lane == 0)
    {
        atomicMin(highest, floatBitsToUint(abs(below.height)));
    }
    barrier();
    Sum sum = addWaves(place, below, lane);
    shares[0][gl_LocalInvocationIndex] = sum.velocity;
    shares[1][gl_LocalInvocationIndex] = vec4(sum.acceleration, 0.0);
    barrier();
    if (point < params.source.count)
    {
        store(point, below.depth, place.isBad, lane);
    }
}
