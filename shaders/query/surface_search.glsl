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
// From then on steps shrink fast: decimetres, centimetres, millimetres. A tile whose waves are long against a step is
// not looked up again but taken on from where it was, by its derivatives up to the second: the first evaluation leaves
// those of the tiles that stay good over decimetres, the next adds those that stay good over centimetres. The host
// counts both and says how far each carries (findSmoothTiles() in gpu_query_water.c); a step beyond that starts anew.
//
// SW_QUERY_LANES (4) lanes share a place. Each takes one column of a tile's window of 4 x 4 texels, so that the four
// read 64 bytes side by side, and every fourth free wave. Sums meet once an evaluation, in shared memory.
//
// Where inputs shape waves (WITH_INPUTS), all waves are looked up at each evaluation, each with the weight that the
// place at rest gives it, as swEvaluateShaped() does it in core/surface/evaluate_shaped.c. The level of still water is
// that of the place asked for.
//
// Before including: query_place.glsl, the buffers `tiles`, `waves` and `texels`, `swQueryWater params.water`,
// `swQuerySea params.sea`, `shared float shares[8][]` with an element for each thread, what lib/inputs.glsl wants,
// `shared vec3 placeValues[3 + SW_LIMIT_SYSTEMS][]` with an element for each point, and the constants `bool
// WITH_INPUTS` and, where some waves run along splines, `bool WITH_RIBBONS`.

#include "lib/inputs.glsl"
#include "lib/places.glsl"
#include "lib/ribbons.glsl"
#include "shared/spline.h"
#include "shared/surface_normal.h"

// Displacement of a particle by its place at rest, and its derivatives along x and z; along z those of y and z alone,
// since dDx/dz is dDz/dx. Of a lane: its share.
struct Sum
{
    vec3 value;
    vec3 alongX;
    vec2 alongZ;
};

// A lane's share of the tiles that are taken on, around a rest point: their sum, and its second derivatives.
struct Smooth
{
    uint tileCount; // the longest
    vec2 offset;    // of the rest point from the place
    Sum sum;
    float xAlongZ; // which Sum leaves out
    vec3 bendX, bendXZ, bendZ;
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

float slopeAlongX(Column column, vec4 cubic)
{
    return fma(fma(3.0 * cubic.w, column.fractionX, 2.0 * cubic.z), column.fractionX, cubic.y);
}

vec2 weigh(vec4 weights, vec2 a, vec2 b, vec2 c, vec2 d)
{
    return fma(vec2(weights.w), d, fma(vec2(weights.z), c, fma(vec2(weights.y), b, weights.x * a)));
}

void addTile(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Sum sum)
{
    Column column = findColumn(tile, cell, rest, lane);
    vec3 a = texelOf(column, 0, 0), b = texelOf(column, 0, 1), c = texelOf(column, 0, 2), d = texelOf(column, 0, 3);
    float valueX = weightAlongX(column, cubic);
    float slopeX = slopeAlongX(column, cubic) * tile.texelsPerMetre;
    vec3 value = weigh(swSplineWeights(column.fractionZ), a, b, c, d);
    vec2 slope = weigh(swSplineSlopes(column.fractionZ) * tile.texelsPerMetre, a.yz, b.yz, c.yz, d.yz);
    sum.value = fma(vec3(valueX), value, sum.value);
    sum.alongX = fma(vec3(slopeX), value, sum.alongX);
    sum.alongZ = fma(vec2(valueX), slope, sum.alongZ);
}

// The same with second derivatives.
void addSmoothTile(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Smooth part)
{
    Column column = findColumn(tile, cell, rest, lane);
    vec3 a = texelOf(column, 0, 0), b = texelOf(column, 0, 1), c = texelOf(column, 0, 2), d = texelOf(column, 0, 3);
    float perMetre = tile.texelsPerMetre;
    float t = column.fractionZ;
    float valueX = weightAlongX(column, cubic);
    float slopeX = slopeAlongX(column, cubic) * perMetre;
    float bendX = fma(6.0 * cubic.w, column.fractionX, 2.0 * cubic.z) * (perMetre * perMetre);
    vec3 value = weigh(swSplineWeights(t), a, b, c, d);
    vec3 slope = weigh(swSplineSlopes(t) * perMetre, a, b, c, d);
    vec3 bend = weigh(vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t) * (perMetre * perMetre), a, b, c, d);
    part.sum.value = fma(vec3(valueX), value, part.sum.value);
    part.sum.alongX = fma(vec3(slopeX), value, part.sum.alongX);
    part.sum.alongZ = fma(vec2(valueX), slope.yz, part.sum.alongZ);
    part.xAlongZ = fma(valueX, slope.x, part.xAlongZ);
    part.bendX = fma(vec3(bendX), value, part.bendX);
    part.bendXZ = fma(vec3(slopeX), slope, part.bendXZ);
    part.bendZ = fma(vec3(valueX), bend, part.bendZ);
}

// Takes the tiles on to another rest point.
void moveSmooth(inout Smooth part, vec2 offset)
{
    vec2 way = offset - part.offset;
    vec3 turnX = part.bendX * way.x + part.bendXZ * way.y;
    vec3 turnZ = part.bendXZ * way.x + part.bendZ * way.y;
    vec3 alongZ = vec3(part.xAlongZ, part.sum.alongZ);
    part.sum.value += (part.sum.alongX + 0.5 * turnX) * way.x + (alongZ + 0.5 * turnZ) * way.y;
    part.sum.alongX += turnX;
    part.sum.alongZ += turnZ.yz;
    part.xAlongZ += turnZ.x;
    part.offset = offset;
}

void addWave(swQueryWave wave, ivec2 cell, vec2 rest, inout Sum sum)
{
    vec2 unit = swingOf(wave, cell, rest);
    vec3 slope = vec3(-wave.dx * unit.x, -unit.y, -wave.dz * unit.x) * 6.28318530718;
    sum.value += vec3(-wave.dx * unit.y, unit.x, -wave.dz * unit.y);
    sum.alongX += slope * wave.turnsX;
    sum.alongZ += slope.yz * wave.turnsZ;
}

// Adds a lane's share of tiles and of the first `waveCount` free waves.
void addWater(uint firstTile, uint tileCount, uint waveCount, ivec2 cell, vec2 rest, uint lane, inout Sum sum)
{
    vec4 cubic = splineCubic(lane);
    for (uint i = firstTile; i < tileCount; ++i)
    {
        addTile(tiles[i], cell, rest, lane, cubic, sum);
    }
    for (uint i = lane; i < waveCount; i += SW_QUERY_LANES)
    {
        addWave(waves[i], cell, rest, sum);
    }
}

// ---- where inputs shape it ----

SeaPlace seaPlaceAt(ivec2 cell, vec2 rest)
{
    return seaPlaceOf(cell + ivec2(params.sea.cellX, params.sea.cellZ),
                      rest + vec2(params.sea.restX, params.sea.restZ));
}

// What is asked of inputs for a point, an element of `placeValues` each: values and slopes of the level at the place
// that was asked for and at the place at rest, of the floor there, and of the weight of each wave system.
#define ASKED_PLACE_LEVEL 0
#define ASKED_LEVEL 1
#define ASKED_FLOOR 2
#define ASKED_SYSTEMS 3

bool areSystemsWeighted(SeaPlace place)
{
    return inputHead.localSystems != 0 || touchesInputs(SW_FIELD_OF_WAVES, place.cell, place.cell);
}

// Bits of the systems that are added by addRibbonWater().
uint ribbonSystemsNear(SeaPlace place)
{
    return WITH_RIBBONS ? ribbonSystemsAt(place) : 0u;
}

// A lane's part of what is asked for a point of a cell, at a place in it and a rest place. Lanes meet before they read.
void askInputs(ivec2 cell, vec2 place, vec2 rest, uint lane)
{
    SeaPlace atRest = seaPlaceAt(cell, rest);
    uint count = areSystemsWeighted(atRest) ? ASKED_SYSTEMS + SW_LIMIT_SYSTEMS : ASKED_SYSTEMS;
    uint ribbonSystems = ribbonSystemsNear(atRest); // which are asked for where they are added
    for (uint i = lane; i < count; i += SW_QUERY_LANES)
    {
        if (i >= ASKED_SYSTEMS && (ribbonSystems >> (i - ASKED_SYSTEMS) & 1u) != 0)
        {
            continue;
        }
        uint field = i == ASKED_FLOOR ? SW_FIELD_OF_FLOOR : i < ASKED_FLOOR ? SW_FIELD_OF_LEVEL : SW_FIELD_OF_WAVES;
        SeaPlace asked = i == ASKED_PLACE_LEVEL ? seaPlaceAt(cell, place) : atRest;
        placeValues[i][gl_LocalInvocationIndex / SW_QUERY_LANES] = firstOf(fieldAt(field, i - ASKED_SYSTEMS, asked));
    }
}

vec3 askedOf(uint i)
{
    return placeValues[i][gl_LocalInvocationIndex / SW_QUERY_LANES];
}

// What a place does to waves, from what was asked.
struct Shaper
{
    Ground ground;
    bool isWeighted; // inputs weigh systems
    uint ribbonSystems;
};

Shaper shaperAt(SeaPlace place)
{
    return Shaper(groundBetween(askedOf(ASKED_LEVEL), askedOf(ASKED_FLOOR)), areSystemsWeighted(place),
                  ribbonSystemsNear(place));
}

bool doesShape(Shaper shaper)
{
    return shaper.isWeighted || shaper.ground.depth < SW_NO_DEPTH;
}

Shape shapeOf(Shaper shaper, uint system, float k, swAttenuation attenuation)
{
    vec3 weight = shaper.isWeighted ? askedOf(ASKED_SYSTEMS + system) : vec3(1.0, 0.0, 0.0);
    return attenuated(Shape(weight.x, weight.yz), shaper.ground, k, attenuation);
}

bool runsAlong(Shaper shaper, uint system)
{
    return WITH_RIBBONS && (shaper.ribbonSystems >> system & 1u) != 0;
}

swAttenuation attenuationOf(swQueryTile tile)
{
    return swAttenuation(tile.strength, tile.perFreeDepth);
}

void addShaped(Shape shape, Sum own, inout Sum sum)
{
    sum.value += shape.weight * own.value;
    sum.alongX += shape.weight * own.alongX + shape.slope.x * own.value;
    sum.alongZ += shape.weight * own.alongZ + shape.slope.y * own.value.yz;
}

const Sum NO_WATER = Sum(vec3(0.0), vec3(0.0), vec2(0.0));

// A place of the sea as a cell and a rest of the query's.
ivec2 queryCellOf(SeaPlace place)
{
    return place.cell - ivec2(params.sea.cellX, params.sea.cellZ);
}

vec2 queryRestOf(SeaPlace place)
{
    return place.rest - vec2(params.sea.restX, params.sea.restZ);
}

// Bits of the systems of the first tiles and of a lane's waves.
uint systemsOf(uint tileCount, uint waveCount, uint lane)
{
    uint systems = 0;
    for (uint i = 0; i < tileCount; ++i)
    {
        systems |= 1u << tiles[i].system;
    }
    for (uint i = lane; i < waveCount; i += SW_QUERY_LANES)
    {
        systems |= 1u << waves[i].system;
    }
    return systems;
}

void addLooked(Look look, Shape shape, Sum own, inout Sum sum)
{
    turnWaterByLook(look, own.value, own.alongX, own.alongZ);
    addShaped(shape, own, sum);
}

// Adds the systems of which some waves run along splines, one after the other: what is asked for one of them is too
// much to be kept for all.
void addRibbonWater(Shaper shaper, uint tileCount, uint waveCount, ivec2 cell, vec2 rest, uint lane, vec4 cubic,
                    inout Sum sum)
{
    SeaPlace place = seaPlaceAt(cell, rest);
    uint systems = shaper.ribbonSystems & systemsOf(tileCount, waveCount, lane);
    for (; systems != 0; systems &= systems - 1)
    {
        uint system = findLSB(systems);
        swWaveLooks looks = looksAt(system, place);
        for (uint l = 0; l < SW_LOOKS; ++l)
        {
            Look look = lookOf(looks, l, place);
            ivec2 cellThere = queryCellOf(look.at);
            vec2 restThere = queryRestOf(look.at);
            for (uint i = 0; i < tileCount && isLookThere(look); ++i)
            {
                if (tiles[i].system == system)
                {
                    Sum own = NO_WATER;
                    addTile(tiles[i], cellThere, restThere, lane, cubic, own);
                    addLooked(look, attenuated(look.shape, shaper.ground, tiles[i].waveNumber, attenuationOf(tiles[i])),
                              own, sum);
                }
            }
            for (uint i = lane; i < waveCount && isLookThere(look); i += SW_QUERY_LANES)
            {
                if (waves[i].system == system)
                {
                    Sum own = NO_WATER;
                    addWave(waves[i], cellThere, restThere, own);
                    addLooked(look, attenuated(look.shape, shaper.ground, waves[i].waveNumber, waves[i].attenuation),
                              own, sum);
                }
            }
        }
    }
}

// addWater() of the first tiles and waves, shaped.
void addShapedWater(Shaper shaper, uint tileCount, uint waveCount, ivec2 cell, vec2 rest, uint lane, inout Sum sum)
{
    vec4 cubic = splineCubic(lane);
    for (uint i = 0; i < tileCount; ++i)
    {
        if (runsAlong(shaper, tiles[i].system))
        {
            continue;
        }
        Sum own = NO_WATER;
        addTile(tiles[i], cell, rest, lane, cubic, own);
        addShaped(shapeOf(shaper, tiles[i].system, tiles[i].waveNumber, attenuationOf(tiles[i])), own, sum);
    }
    for (uint i = lane; i < waveCount; i += SW_QUERY_LANES)
    {
        if (runsAlong(shaper, waves[i].system))
        {
            continue;
        }
        Sum own = NO_WATER;
        addWave(waves[i], cell, rest, own);
        addShaped(shapeOf(shaper, waves[i].system, waves[i].waveNumber, waves[i].attenuation), own, sum);
    }
    if (WITH_RIBBONS && shaper.ribbonSystems != 0)
    {
        addRibbonWater(shaper, tileCount, waveCount, cell, rest, lane, cubic, sum);
    }
}

// ---- lanes together ----

void shareVector(uint part, vec3 value)
{
    shares[part][gl_LocalInvocationIndex] = value.x;
    shares[part + 1][gl_LocalInvocationIndex] = value.y;
    shares[part + 2][gl_LocalInvocationIndex] = value.z;
}

float gather(uint part)
{
    uint first = gl_LocalInvocationIndex / SW_QUERY_LANES * SW_QUERY_LANES;
    return shares[part][first] + shares[part][first + 1] + (shares[part][first + 2] + shares[part][first + 3]);
}

vec3 gatherVector(uint part)
{
    return vec3(gather(part), gather(part + 1), gather(part + 2));
}

void share(Sum sum)
{
    shareVector(0, sum.value);
    shareVector(3, sum.alongX);
    shares[6][gl_LocalInvocationIndex] = sum.alongZ.x;
    shares[7][gl_LocalInvocationIndex] = sum.alongZ.y;
}

Sum gatherSum()
{
    return Sum(gatherVector(0), gatherVector(3), vec2(gather(6), gather(7)));
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
    Smooth part;
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
    search.part.tileCount = 0;
    return search;
}

vec2 newtonStep(vec2 residual, Sum sum)
{
    float jacobian = swSurfaceJacobian(sum.alongX.x, sum.alongX.z, sum.alongZ.y);
    vec2 step = vec2((1.0 + sum.alongZ.y) * residual.x - sum.alongX.z * residual.y,
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

// Takes the smooth tiles on to the tried offset, or begins with them anew, and adds those that are smooth enough over
// the next step.
void followSmooth(inout Search search, uint lane)
{
    vec2 way = search.offset - search.part.offset;
    uint had = search.part.tileCount;
    float reach = had > params.water.farTileCount ? params.water.nearReach : params.water.farReach;
    uint tileCount = params.water.nearTileCount;
    if (had == 0 || dot(way, way) > reach * reach)
    {
        search.part = Smooth(0, search.offset, NO_WATER, 0.0, vec3(0.0), vec3(0.0), vec3(0.0));
        had = 0;
        tileCount = params.water.farTileCount;
    }
    moveSmooth(search.part, search.offset);
    vec4 cubic = splineCubic(lane);
    for (uint i = had; i < tileCount; ++i)
    {
        addSmoothTile(tiles[i], search.cell, search.place + search.offset, lane, cubic, search.part);
    }
    search.part.tileCount = tileCount;
}

// A lane's share of the surface at the tried offset.
Sum addSearched(inout Search search, uint lane)
{
    vec2 rest = search.place + search.offset;
    Sum sum = NO_WATER;
    bool isFirst = isGuess(search);
    if (WITH_INPUTS)
    {
        Shaper shaper = shaperAt(seaPlaceAt(search.cell, rest));
        if (doesShape(shaper))
        {
            addShapedWater(shaper, isFirst ? params.water.longTileCount : params.water.tileCount,
                           isFirst ? params.water.longWaveCount : params.water.waveCount, search.cell, rest, lane, sum);
            return sum;
        }
    }
    if (isFirst)
    {
        addWater(0, params.water.longTileCount, params.water.longWaveCount, search.cell, rest, lane, sum);
        return sum;
    }
    followSmooth(search, lane);
    sum = search.part.sum;
    addWater(search.part.tileCount, params.water.tileCount, params.water.waveCount, search.cell, rest, lane, sum);
    return sum;
}

// A lane's part of what inputs say for the tried offset.
void askSearched(Search search, uint lane)
{
    askInputs(search.cell, search.place, search.place + search.offset, lane);
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

// What was found, as the surface stands on its level. Chain rule: the level is a function of where particles are,
// derivatives are by where they rest.
Sum surfaceOf(Search search)
{
    Sum sum = search.best;
    vec3 level = WITH_INPUTS ? askedOf(ASKED_PLACE_LEVEL) : vec3(0.0);
    sum.value.y += level.x;
    sum.alongX.y += level.y * (1.0 + sum.alongX.x) + level.z * sum.alongX.z;
    sum.alongZ.x += level.y * sum.alongX.z + level.z * (1.0 + sum.alongZ.y);
    return sum;
}

// Normal and J of the surface, from a particle's derivatives. The underside of a fold is turned over.
vec4 normalOf(Sum sum)
{
    float jacobian = swSurfaceJacobian(sum.alongX.x, sum.alongX.z, sum.alongZ.y);
    float x = swSurfaceNormalX(sum.alongX.z, sum.alongZ.y, sum.alongX.y, sum.alongZ.x);
    float z = swSurfaceNormalZ(sum.alongX.x, sum.alongX.z, sum.alongX.y, sum.alongZ.x);
    vec3 normal = vec3(-x, jacobian, -z);
    float size = length(normal);
    normal = size < 1e-20 ? vec3(0.0, 1.0, 0.0) : normal * ((jacobian < 0.0 ? -1.0 : 1.0) / size);
    return vec4(normal, jacobian);
}
