// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// The surface above points of the plane: the GPU's twin of core/query/sample.c. The particle that is above q rests at
// q + d with r(d) = d + D(q + d) = 0. The core avoids gradients, which cost it as much as displacement; here texels cost,
// and gradients come from the same window of texels for a few multiply-adds. So this is Newton's iteration, which needs
// two evaluations fewer, and the last one has the normal. A step that made the residual worse is taken back and halved,
// and no step is longer than four residuals: where the surface nearly folds, its inverse gradient has no meaning.
//
// The first evaluation adds up only waves that are long against the way that it goes: gradients of waves shorter than
// that say nothing about where it leads.
//
// Four lanes share a point. Each takes one column of a tile's window of 4 x 4 texels, so that the four read 64 bytes side
// by side, and every fourth free wave. Sums meet once an evaluation, in shared memory.
//
// Measured on an H100, 100,000 points of a default sea: 190 us scattered over 10 km, 125 to 175 us on a grid of 0.5 m;
// points take 2.6 evaluations after the first guess. Slower were: no first guess (40 more), lanes that take another point
// as soon as theirs is done (7 more with two points a lane, 10 with four), tiles in a storage buffer (6 more), all four
// weights along x in every lane (8 more), two tiles at a time (6 more), and workgroups of 128 (4 more).

#include "shared/query.h"
#include "shared/spline.h"
#include "shared/surface_normal.h"

#include "lib/turns.glsl"

const uint THREADS = SW_QUERY_LANES * SW_QUERY_POINTS;
layout(local_size_x = THREADS) in;

layout(std140, binding = 0) uniform Tiles
{
    swQueryTile tiles[SW_LIMIT_TILES];
};
layout(std430, binding = 1) readonly buffer Waves
{
    swQueryWave waves[];
};
layout(std430, binding = 2) readonly buffer Texels
{
    vec4 texels[];
};
layout(std430, binding = 3) readonly buffer Points
{
    uvec2 points[];
};
layout(std430, binding = 4) writeonly buffer Heights
{
    vec2 heights[]; // above sea level, residual
};
layout(std430, binding = 5) writeonly buffer Sideways
{
    vec2 sideways[];
};
layout(std430, binding = 6) writeonly buffer Normals
{
    vec4 normals[]; // and J
};
layout(push_constant) uniform Push
{
    swQueryParams params;
};

// Displacement of a particle by its place at rest, and its derivatives along x and z. Of a lane: its share.
struct Sum
{
    vec3 value;
    vec3 alongX;
    vec3 alongZ;
};

shared vec3 shares[3][THREADS];
shared uint isBusy[2]; // whether a point goes on; in turns, so that one can be read while the other is cleared

// ---- the surface at a rest point ----

// The nearest whole turn is taken off first, so that the integer cannot overflow.
uint toTurns(float turns)
{
    return uint(int((turns - round(turns)) * 2147483648.0)) << 1;
}

// The spline's weight of column `lane` of a window as a polynomial of the fraction, lowest power first.
vec4 splineCubic(uint lane)
{
    const vec4 cubics[4] = {vec4(1.0, -3.0, 3.0, -1.0), vec4(4.0, 0.0, -6.0, 3.0), vec4(1.0, 3.0, 3.0, -3.0),
                            vec4(0.0, 0.0, 0.0, 1.0)};
    return cubics[lane] / 6.0;
}

void addTile(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Sum sum)
{
    vec2 way = rest * tile.turnsPerMetre;
    uint turnsX = tile.turnsX + uint(cell.x) * tile.cellTurns + toTurns(way.x);
    uint turnsZ = tile.turnsZ + uint(cell.y) * tile.cellTurns + toTurns(way.y);
    uint column = turnsX >> (32 - tile.resolutionBits);
    uint row = turnsZ >> (32 - tile.resolutionBits);
    float fractionX = float((turnsX << tile.resolutionBits) >> 8) * (1.0 / 16777216.0);
    float fractionZ = float((turnsZ << tile.resolutionBits) >> 8) * (1.0 / 16777216.0);
    uint mask = (1u << tile.resolutionBits) - 1u;
    uint pitch = mask + 4u;
    uint first = tile.firstTexel + column + lane;
    vec3 a = texels[first + row * pitch].xyz;
    vec3 b = texels[first + ((row + 1) & mask) * pitch].xyz;
    vec3 c = texels[first + ((row + 2) & mask) * pitch].xyz;
    vec3 d = texels[first + ((row + 3) & mask) * pitch].xyz;
    vec4 valueZ = swSplineWeights(fractionZ);
    vec4 slopeZ = swSplineSlopes(fractionZ) * tile.texelsPerMetre;
    float valueX = fma(fma(fma(cubic.w, fractionX, cubic.z), fractionX, cubic.y), fractionX, cubic.x);
    float slopeX = fma(fma(3.0 * cubic.w, fractionX, 2.0 * cubic.z), fractionX, cubic.y) * tile.texelsPerMetre;
    vec3 value = fma(vec3(valueZ.w), d, fma(vec3(valueZ.z), c, fma(vec3(valueZ.y), b, valueZ.x * a)));
    vec3 slope = fma(vec3(slopeZ.w), d, fma(vec3(slopeZ.z), c, fma(vec3(slopeZ.y), b, slopeZ.x * a)));
    sum.value = fma(vec3(valueX), value, sum.value);
    sum.alongX = fma(vec3(slopeX), value, sum.alongX);
    sum.alongZ = fma(vec3(valueX), slope, sum.alongZ);
}

void addWave(swQueryWave wave, ivec2 cell, vec2 rest, inout Sum sum)
{
    uint phase = wave.phase + uint(cell.x) * wave.cellTurnsX + uint(cell.y) * wave.cellTurnsZ +
                 toTurns(rest.x * wave.turnsX + rest.y * wave.turnsZ);
    vec2 unit = wave.amplitude * unitOf(phase); // cosine, sine
    vec3 slope = vec3(-wave.dx * unit.x, -unit.y, -wave.dz * unit.x) * 6.28318530718;
    sum.value += vec3(-wave.dx * unit.y, unit.x, -wave.dz * unit.y);
    sum.alongX += slope * wave.turnsX;
    sum.alongZ += slope * wave.turnsZ;
}

// A lane's share of the first `tileCount` tiles and `waveCount` free waves.
Sum addWater(uint tileCount, uint waveCount, ivec2 cell, vec2 rest, uint lane)
{
    vec4 cubic = splineCubic(lane);
    Sum sum = Sum(vec3(0.0), vec3(0.0), vec3(0.0));
    for (uint i = 0; i < tileCount; ++i)
    {
        addTile(tiles[i], cell, rest, lane, cubic, sum);
    }
    for (uint i = lane; i < waveCount; i += SW_QUERY_LANES)
    {
        addWave(waves[i], cell, rest, sum);
    }
    return sum;
}

void share(Sum sum)
{
    shares[0][gl_LocalInvocationIndex] = sum.value;
    shares[1][gl_LocalInvocationIndex] = sum.alongX;
    shares[2][gl_LocalInvocationIndex] = sum.alongZ;
}

vec3 gather(uint part)
{
    uint first = gl_LocalInvocationIndex / SW_QUERY_LANES * SW_QUERY_LANES;
    return shares[part][first] + shares[part][first + 1] + (shares[part][first + 2] + shares[part][first + 3]);
}

// ---- the search ----

struct Search
{
    uint point;
    ivec2 cell;
    vec2 place;  // of the point in its cell, m
    vec2 offset; // being tried
    uint iteration;
    float reach;
    float bestSquare;
    vec2 bestOffset;
    Sum best;
};

Search beginSearch(uint point)
{
    Search search;
    search.point = point;
    search.offset = vec2(0.0);
    search.iteration = 0;
    search.reach = 1.0;
    search.bestSquare = 3e38;
    uint at = params.firstPoint + point;
    if (params.isFloatPoint != 0)
    {
        vec2 place = uintBitsToFloat(points[at]);
        vec2 cell = floor(place / SW_QUERY_CELL);
        search.cell = ivec2(cell);
        search.place = place - cell * SW_QUERY_CELL;
    }
    else
    {
        search.place = uintBitsToFloat(points[2 * at]);
        search.cell = ivec2(points[2 * at + 1]);
    }
    return search;
}

vec2 newtonStep(vec2 residual, Sum sum)
{
    float jacobian = swSurfaceJacobian(sum.alongX.x, sum.alongZ.x, sum.alongX.z, sum.alongZ.z);
    vec2 step = vec2((1.0 + sum.alongZ.z) * residual.x - sum.alongZ.x * residual.y,
                     (1.0 + sum.alongX.x) * residual.y - sum.alongX.z * residual.x);
    float longest = 4.0 * length(residual) * abs(jacobian);
    float size = length(step);
    return size > longest ? step * (4.0 * length(residual) / size) * (jacobian < 0.0 ? -1.0 : 1.0) : step / jacobian;
}

bool isGuess(Search search)
{
    return search.iteration == 0 &&
           (params.longTileCount < params.tileCount || params.longWaveCount < params.waveCount);
}

// Takes in the surface at the tried offset and chooses the next. False when done.
bool advance(inout Search search, Sum sum)
{
    vec2 residual = search.offset + sum.value.xz;
    bool wasGuess = isGuess(search);
    search.iteration += 1;
    if (wasGuess)
    {
        search.offset -= newtonStep(residual, sum);
        return true;
    }
    float square = dot(residual, residual);
    search.reach *= 0.5;
    if (square < search.bestSquare)
    {
        search.bestSquare = square;
        search.bestOffset = search.offset;
        search.best = sum;
        search.reach = 1.0;
    }
    vec2 bestResidual = search.bestOffset + search.best.value.xz;
    search.offset = search.bestOffset - search.reach * newtonStep(bestResidual, search.best);
    return search.bestSquare > params.toleranceSquare && search.iteration < params.maxIterations;
}

// ---- answers ----

void storeNormal(uint point, vec3 alongX, vec3 alongZ)
{
    float jacobian = swSurfaceJacobian(alongX.x, alongZ.x, alongX.z, alongZ.z);
    float x = swSurfaceNormalX(alongX.z, alongZ.z, alongX.y, alongZ.y);
    float z = swSurfaceNormalZ(alongX.x, alongZ.x, alongX.y, alongZ.y);
    vec3 normal = vec3(-x, jacobian, -z);
    float size = length(normal);
    normal = size < 1e-20 ? vec3(0.0, 1.0, 0.0) : normal * ((jacobian < 0.0 ? -1.0 : 1.0) / size);
    normals[point] = vec4(normal, jacobian);
}

// One lane for each output.
void store(Search search, uint lane)
{
    if (lane == 0)
    {
        heights[search.point] = vec2(search.best.value.y, sqrt(search.bestSquare));
    }
    else if (lane == 1 && (params.outputs & SW_QUERY_WANTS_SIDEWAYS) != 0)
    {
        sideways[search.point] = search.best.value.xz;
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_NORMAL) != 0)
    {
        storeNormal(search.point, search.best.alongX, search.best.alongZ);
    }
}

void main()
{
    uint lane = gl_LocalInvocationIndex % SW_QUERY_LANES;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint point = group * SW_QUERY_POINTS + gl_LocalInvocationIndex / SW_QUERY_LANES;
    bool isSearching = point < params.pointCount;
    Search search = beginSearch(min(point, params.pointCount - 1));
    if (gl_LocalInvocationIndex == 0)
    {
        isBusy[0] = 0;
    }
    for (uint turn = 0;; turn ^= 1)
    {
        if (isSearching)
        {
            bool isFirst = isGuess(search);
            share(addWater(isFirst ? params.longTileCount : params.tileCount,
                           isFirst ? params.longWaveCount : params.waveCount, search.cell, search.place + search.offset,
                           lane));
        }
        barrier();
        if (isSearching)
        {
            isSearching = advance(search, Sum(gather(0), gather(1), gather(2)));
            if (!isSearching)
            {
                store(search, lane);
            }
        }
        if (isSearching)
        {
            isBusy[turn] = 1;
        }
        if (gl_LocalInvocationIndex == 0)
        {
            isBusy[turn ^ 1] = 0;
        }
        barrier();
        if (isBusy[turn] == 0)
        {
            return;
        }
    }
}
