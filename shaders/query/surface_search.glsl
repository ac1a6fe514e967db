// SPDX-License-Identifier: MIT
// The surface above a place: the GPU's twin of swFindParticles() in core/surface/search.c. The particle that is above q
// rests at q + d with r(d) = d + D(q + d) = 0. The core avoids gradients, which cost it as much as displacement; here
// texels cost, and gradients come from the same window of texels for a few multiply-adds. So this is Newton's
// iteration, which needs two evaluations fewer, and the last one has the normal. A step that made the residual worse is
// taken back and halved, and no step is longer than four residuals: where the surface nearly folds, its inverse
// gradient has no meaning.
//
// The first evaluation adds up only waves that are long against the way that it goes: gradients of waves shorter than
// that say nothing about where it leads.
//
// SW_QUERY_LANES (4) lanes share a place. Each takes one column of a tile's window of 4 x 4 texels, so that the four
// read 64 bytes side by side, and every fourth free wave. Sums meet once an evaluation, in shared memory.
//
// Before including: query_place.glsl, the buffers `tiles`, `waves` and `texels`, `swQueryWater params.water`, and
// `shared vec3 shares[3][]` with an element for each thread.

#include "shared/spline.h"
#include "shared/surface_normal.h"

// Displacement of a particle by its place at rest, and its derivatives along x and z. Of a lane: its share.
struct Sum
{
    vec3 value;
    vec3 alongX;
    vec3 alongZ;
};

// ---- the surface at a rest point ----

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
    ivec2 cell;
    vec2 place;  // of the point in its cell, m
    vec2 offset; // being tried
    uint iteration;
    float reach;
    float bestSquare;
    vec2 bestOffset;
    Sum best;
};

Search beginSearch(Place place)
{
    Search search;
    search.cell = place.cell;
    search.place = place.rest;
    search.offset = vec2(0.0);
    search.iteration = 0;
    search.reach = 1.0;
    search.bestSquare = 3e38;
    search.bestOffset = vec2(0.0);
    return search;
}

vec2 newtonStep(vec2 residual, Sum sum)
{
    float jacobian = swSurfaceJacobian(sum.alongX.x, sum.alongX.z, sum.alongZ.z);
    vec2 step = vec2((1.0 + sum.alongZ.z) * residual.x - sum.alongZ.x * residual.y,
                     (1.0 + sum.alongX.x) * residual.y - sum.alongX.z * residual.x);
    float longest = 4.0 * length(residual) * abs(jacobian);
    float size = length(step);
    return size > longest ? step * (4.0 * length(residual) / size) * (jacobian < 0.0 ? -1.0 : 1.0) : step / jacobian;
}

bool isGuess(Search search)
{
    return search.iteration == 0 &&
           (params.water.longTileCount < params.water.tileCount || params.water.longWaveCount < params.water.waveCount);
}

// A lane's share of the surface at the tried offset.
Sum addSearched(Search search, uint lane)
{
    bool isFirst = isGuess(search);
    return addWater(isFirst ? params.water.longTileCount : params.water.tileCount,
                    isFirst ? params.water.longWaveCount : params.water.waveCount, search.cell,
                    search.place + search.offset, lane);
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
    return search.bestSquare > params.water.toleranceSquare && search.iteration < params.water.maxIterations;
}

// Normal and J of the surface, from a particle's derivatives. The underside of a fold is turned over.
vec4 normalOf(Sum sum)
{
    float jacobian = swSurfaceJacobian(sum.alongX.x, sum.alongX.z, sum.alongZ.z);
    float x = swSurfaceNormalX(sum.alongX.z, sum.alongZ.z, sum.alongX.y, sum.alongZ.y);
    float z = swSurfaceNormalZ(sum.alongX.x, sum.alongX.z, sum.alongX.y, sum.alongZ.y);
    vec3 normal = vec3(-x, jacobian, -z);
    float size = length(normal);
    normal = size < 1e-20 ? vec3(0.0, 1.0, 0.0) : normal * ((jacobian < 0.0 ? -1.0 : 1.0) / size);
    return vec4(normal, jacobian);
}
