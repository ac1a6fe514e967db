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
// Velocity and acceleration are looked up once, where the search ended, in texels of their own. A query that wants neither
// has a pipeline without them.
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
layout(constant_id = 0) const bool WITH_MOTION = false;

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
layout(std430, binding = 7) writeonly buffer Velocities
{
    vec4 velocities[]; // and 0
};
layout(std430, binding = 8) writeonly buffer Accelerations
{
    vec4 accelerations[]; // and 0
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

// A lane's column of the window of texels around a rest point.
struct Column
{
    uint first, row, mask, pitch;
    float fractionX, fractionZ;
};

Column findColumn(swQueryTile tile, ivec2 cell, vec2 rest, uint lane)
{
    vec2 way = rest * tile.turnsPerMetre;
    uint turnsX = tile.turnsX + uint(cell.x) * tile.cellTurns + toTurns(way.x);
    uint turnsZ = tile.turnsZ + uint(cell.y) * tile.cellTurns + toTurns(way.y);
    Column column;
    column.first = tile.firstTexel + (turnsX >> (32 - tile.resolutionBits)) + lane;
    column.row = turnsZ >> (32 - tile.resolutionBits);
    column.mask = (1u << tile.resolutionBits) - 1u;
    column.pitch = column.mask + 4u;
    column.fractionX = float((turnsX << tile.resolutionBits) >> 8) * (1.0 / 16777216.0);
    column.fractionZ = float((turnsZ << tile.resolutionBits) >> 8) * (1.0 / 16777216.0);
    return column;
}

// Texel `i` of four along z; `field` is how far the texels lie from displacement's.
vec3 texelOf(Column column, uint field, uint i)
{
    return texels[column.first + field + ((column.row + i) & column.mask) * column.pitch].xyz;
}

float weightAlongX(Column column, vec4 cubic)
{
    float t = column.fractionX;
    return fma(fma(fma(cubic.w, t, cubic.z), t, cubic.y), t, cubic.x);
}

vec3 weigh(vec4 weights, vec3 a, vec3 b, vec3 c, vec3 d)
{
    return fma(vec3(weights.w), d, fma(vec3(weights.z), c, fma(vec3(weights.y), b, weights.x * a)));
}

void addTile(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Sum sum)
{
    Column column = findColumn(tile, cell, rest, lane);
    vec3 a = texelOf(column, 0, 0), b = texelOf(column, 0, 1), c = texelOf(column, 0, 2), d = texelOf(column, 0, 3);
    float valueX = weightAlongX(column, cubic);
    float slopeX =
        fma(fma(3.0 * cubic.w, column.fractionX, 2.0 * cubic.z), column.fractionX, cubic.y) * tile.texelsPerMetre;
    vec3 value = weigh(swSplineWeights(column.fractionZ), a, b, c, d);
    vec3 slope = weigh(swSplineSlopes(column.fractionZ) * tile.texelsPerMetre, a, b, c, d);
    sum.value = fma(vec3(valueX), value, sum.value);
    sum.alongX = fma(vec3(slopeX), value, sum.alongX);
    sum.alongZ = fma(vec3(valueX), slope, sum.alongZ);
}

// Cosine and sine, times the amplitude.
vec2 swingOf(swQueryWave wave, ivec2 cell, vec2 rest)
{
    uint phase = wave.phase + uint(cell.x) * wave.cellTurnsX + uint(cell.y) * wave.cellTurnsZ +
                 toTurns(rest.x * wave.turnsX + rest.y * wave.turnsZ);
    return wave.amplitude * unitOf(phase);
}

void addWave(swQueryWave wave, ivec2 cell, vec2 rest, inout Sum sum)
{
    vec2 unit = swingOf(wave, cell, rest);
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

// Velocity and acceleration of a particle. Of a lane: its share.
struct Motion
{
    vec3 velocity;
    vec3 acceleration;
};

void addTileMotion(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Motion motion)
{
    Column column = findColumn(tile, cell, rest, lane);
    float valueX = weightAlongX(column, cubic);
    vec4 valueZ = swSplineWeights(column.fractionZ);
    if (params.velocityTexels != 0)
    {
        uint field = params.velocityTexels;
        motion.velocity += valueX * weigh(valueZ, texelOf(column, field, 0), texelOf(column, field, 1),
                                          texelOf(column, field, 2), texelOf(column, field, 3));
    }
    if (params.accelerationTexels != 0)
    {
        uint field = params.accelerationTexels;
        motion.acceleration += valueX * weigh(valueZ, texelOf(column, field, 0), texelOf(column, field, 1),
                                              texelOf(column, field, 2), texelOf(column, field, 3));
    }
}

Motion addMotion(ivec2 cell, vec2 rest, uint lane)
{
    vec4 cubic = splineCubic(lane);
    Motion motion = Motion(vec3(0.0), vec3(0.0));
    for (uint i = 0; i < params.tileCount; ++i)
    {
        addTileMotion(tiles[i], cell, rest, lane, cubic, motion);
    }
    for (uint i = lane; i < params.waveCount; i += SW_QUERY_LANES)
    {
        swQueryWave wave = waves[i];
        vec2 rate = wave.rate * swingOf(wave, cell, rest);
        motion.velocity += vec3(wave.dx * rate.x, rate.y, wave.dz * rate.x);
        motion.acceleration += wave.rate * vec3(wave.dx * rate.y, -rate.x, wave.dz * rate.y);
    }
    return motion;
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

// How the particle that was found moves. All threads of the workgroup call it together.
void storeMotion(Search search, uint lane, bool isPoint)
{
    Motion motion = addMotion(search.cell, search.place + search.bestOffset, lane);
    shares[0][gl_LocalInvocationIndex] = motion.velocity;
    shares[1][gl_LocalInvocationIndex] = motion.acceleration;
    barrier();
    if (isPoint && lane == 0 && (params.outputs & SW_QUERY_WANTS_VELOCITY) != 0)
    {
        velocities[search.point] = vec4(gather(0), 0.0);
    }
    else if (isPoint && lane == 1 && (params.outputs & SW_QUERY_WANTS_ACCELERATION) != 0)
    {
        accelerations[search.point] = vec4(gather(1), 0.0);
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
            break;
        }
    }
    if (WITH_MOTION)
    {
        storeMotion(search, lane, point < params.pointCount);
    }
}
