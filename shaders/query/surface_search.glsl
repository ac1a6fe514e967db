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
// `swQuerySea params.sea`, `shared float shares[9][]` with an element for each thread, what lib/inputs.glsl wants,
// `shared vec3 placeValues[6 + SW_LIMIT_SYSTEMS][]` with an element for each point, and the constants `bool
// WITH_INPUTS`, WITH_FLOW (inputs make the water flow; the buffer `likeness` is there), WITH_PLACE_FLOW (the flow is
// wanted at the place that is asked for), WITH_DISPLACEMENT, and WITH_RIBBONS (some waves run along splines, and
// `shared vec4 keptLooks[8 * SW_QUERY_RIBBON_SYSTEMS][]` is there, with an element for each point); WITH_HOLES is for
// lib/ask.glsl.

#include "lib/inputs.glsl"

#include "lib/ask.glsl"
#include "lib/displaced.glsl"
#include "lib/likeness.glsl"
#include "lib/places.glsl"
#include "lib/ribbons.glsl"
#include "shared/spline.h"
#include "shared/surface_normal.h"

// Displacement of a particle by its place at rest, and its derivatives along x and z; along z those of y and z alone,
// since dDx/dz is dDz/dx, but for what places make of waves: `skew` is the first less the second. Of a lane: its share.
struct Sum
{
    vec3 value;
    vec3 alongX;
    vec2 alongZ;
    float skew;
};

const Sum NO_WATER = Sum(vec3(0.0), vec3(0.0), vec2(0.0), 0.0);

// dDx/dz.
float xAlongZOf(Sum sum)
{
    return sum.alongX.z + sum.skew;
}

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
// that was asked for and at the place at rest, of the floor and both numbers of the flow there, and of the weight of
// each wave system; both numbers of the flow at the place that was asked for.
#define ASKED_PLACE_LEVEL 0
#define ASKED_LEVEL 1
#define ASKED_FLOOR 2
#define ASKED_FLOW_X 3
#define ASKED_FLOW_Z 4
#define ASKED_PLACE_FLOW 5
#define ASKED_SYSTEMS 6

bool areSystemsWeighted(SeaPlace place)
{
    return inputHead.localSystems != 0 || touchesInputs(SW_FIELD_OF_WAVES, place.cell, place.cell);
}

// Bits of the systems of which some waves run along splines near a place.
uint ribbonSystemsNear(SeaPlace place)
{
    return WITH_RIBBONS ? ribbonSystemsAt(place) : 0u;
}

// Where a system's looks are kept.
uint slotOf(uint system)
{
    return bitCount(inputHead.ribbonSystems & ((1u << system) - 1u));
}

void keepLook(uint at, swRibbonLook look)
{
    uint point = gl_LocalInvocationIndex / SW_QUERY_LANES;
    swRibbonSource source = look.source;
    keptLooks[at][point] = vec4(look.weight.value, look.weight.alongX, look.weight.alongZ, 0.0);
    keptLooks[at + 1][point] =
        vec4(intBitsToFloat(source.cellX), intBitsToFloat(source.cellZ), source.restX, source.restZ);
    keptLooks[at + 2][point] = source.way;
    keptLooks[at + 3][point] = vec4(source.cosine, source.sine, source.turnX, source.turnZ);
}

// The first or the second look at a system's waves along splines, of what was asked last.
Look askedLook(uint system, uint l)
{
    uint point = gl_LocalInvocationIndex / SW_QUERY_LANES, at = (slotOf(system) * 2 + l) * 4;
    vec4 weight = keptLooks[at][point], place = keptLooks[at + 1][point], turn = keptLooks[at + 3][point];
    swRibbonSource source = swRibbonSource(floatBitsToInt(place.x), floatBitsToInt(place.y), place.z, place.w,
                                           keptLooks[at + 2][point], turn.x, turn.y, turn.z, turn.w);
    return lookOf(swRibbonLook(swInputChannel(weight.x, weight.y, weight.z), source));
}

// Bits of the systems of the query's waves.
uint systemsOfQuery()
{
    uint systems = 0;
    for (uint i = 0; i < params.water.tileCount; ++i)
    {
        systems |= 1u << tiles[i].system;
    }
    for (uint i = 0; i < params.water.waveCount; i = waves[i].groupEnd)
    {
        systems |= 1u << waves[i].system;
    }
    return systems;
}

uint querySystems; // once main() has found them

vec3 askedOf(uint i)
{
    return placeValues[i][gl_LocalInvocationIndex / SW_QUERY_LANES];
}

// What a place does to waves, from what was asked.
struct Shaper
{
    Ground ground;
    Flow flow;
    bool isWeighted; // inputs weigh systems
    uint ribbonSystems;
};

Flow askedFlow()
{
    vec3 x = askedOf(ASKED_FLOW_X), z = askedOf(ASKED_FLOW_Z);
    return besideEven(Flow(vec2(x.x, z.x), vec4(x.yz, z.yz)));
}

Shaper shaperAt(SeaPlace place)
{
    Ground ground = groundBetween(askedOf(ASKED_LEVEL), askedOf(ASKED_FLOOR));
    return Shaper(ground, WITH_FLOW ? askedFlow() : STILL, areSystemsWeighted(place), ribbonSystemsNear(place));
}

bool doesCarry(Shaper shaper)
{
    return WITH_FLOW && isMoved(shaper.flow);
}

bool doesShape(Shaper shaper)
{
    return shaper.isWeighted || shaper.ground.depth < SW_NO_DEPTH || doesCarry(shaper);
}

Shape shapeOf(Shaper shaper, uint system, float k, swAttenuation attenuation)
{
    vec3 weight = shaper.isWeighted ? askedOf(ASKED_SYSTEMS + system) : vec3(1.0, 0.0, 0.0);
    return attenuated(Shape(weight.x, weight.yz), shaper.ground, k, attenuation);
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
    sum.skew += shape.weight * own.skew + shape.slope.y * own.value.x - shape.slope.x * own.value.z;
}

// ---- where a flow carries them ----

// How alike a tile's heights are a way apart, and the slopes of that by the way. All lanes know all of it.
vec3 likenessOf(swQueryTile tile, vec2 way)
{
    return likenessOf(tile.firstTexel, 1u << tile.resolutionBits, tile.texelsPerMetre, way);
}

// The same of free waves [first, end): the mean of cos(k . way), by energy.
vec3 likenessOf(uint first, uint end, vec2 way)
{
    float energy = 0.0;
    vec3 found = vec3(0.0);
    for (uint i = first; i < end; ++i)
    {
        swQueryWave wave = waves[i];
        vec2 unit = wave.amplitude * wave.amplitude * unitOf(toTurns(wave.turnsX * way.x + wave.turnsZ * way.y));
        energy += wave.amplitude * wave.amplitude;
        found += vec3(unit.x, -6.28318530718 * unit.y * vec2(wave.turnsX, wave.turnsZ));
    }
    return energy > 0.0 ? found / energy : vec3(1.0, 0.0, 0.0);
}

// Adds a copy of waves: what it counts, and the slopes of where it is looked up less where that is.
void addCopy(float weight, vec4 way, Sum own, inout Sum sum)
{
    vec3 alongZ = vec3(xAlongZOf(own), own.alongZ);
    vec3 x = weight * (own.alongX * (1.0 + way.x) + alongZ * way.z);
    vec3 z = weight * (own.alongX * way.y + alongZ * (1.0 + way.w));
    sum.value += weight * own.value;
    sum.alongX += x;
    sum.alongZ += z.yz;
    sum.skew += z.x - x.z;
}

// A lane's share of a tile's copies, and their part of the shape.
Sum carriedTile(swQueryTile tile, Flow flow, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Shape shape)
{
    Carry carry = carryOf(tile.carryTurns, tile.carryPeriod);
    float between = 0.5 * tile.carryPeriod;
    shape = carried(shape, carry, between, flow, likenessOf(tile, between * flow.velocity));
    Sum sum = NO_WATER;
    for (uint c = 0; c < 2; ++c)
    {
        Sum own = NO_WATER;
        addTile(tile, cell, rest - carry.seconds[c] * flow.velocity, lane, cubic, own);
        addCopy(carry.weights[c], -carry.seconds[c] * flow.slopes, own, sum);
    }
    return sum;
}

// Free waves [first, end), which are of one octave and one system.
Sum carriedWaves(uint first, uint end, Flow flow, ivec2 cell, vec2 rest, inout Shape shape)
{
    Carry carry = carryOf(waves[first].carryTurns, waves[first].carryPeriod);
    float between = 0.5 * waves[first].carryPeriod;
    shape = carried(shape, carry, between, flow, likenessOf(first, end, between * flow.velocity));
    Sum sum = NO_WATER;
    for (uint c = 0; c < 2; ++c)
    {
        Sum own = NO_WATER;
        for (uint i = first; i < end; ++i)
        {
            addWave(waves[i], cell, rest - carry.seconds[c] * flow.velocity, own);
        }
        addCopy(carry.weights[c], -carry.seconds[c] * flow.slopes, own, sum);
    }
    return sum;
}

// Groups of the first free waves go round the lanes.
void addCarriedWaves(Shaper shaper, uint waveCount, ivec2 cell, vec2 rest, uint lane, inout Sum sum)
{
    uint turn = 0;
    for (uint first = 0; first < waveCount; ++turn)
    {
        uint end = min(waves[first].groupEnd, waveCount);
        if (turn % SW_QUERY_LANES == lane)
        {
            Shape shape = shapeOf(shaper, waves[first].system, waves[first].waveNumber, waves[first].attenuation);
            Sum own = carriedWaves(first, end, shaper.flow, cell, rest, shape);
            addShaped(shape, own, sum);
        }
        first = end;
    }
}

// A place of the sea as a cell and a rest of the query's.
ivec2 queryCellOf(SeaPlace place)
{
    return place.cell - ivec2(params.sea.cellX, params.sea.cellZ);
}

vec2 queryRestOf(SeaPlace place)
{
    return place.rest - vec2(params.sea.restX, params.sea.restZ);
}

// The copies of a tile that a flow carries, and their part of the shape: a single one where it does not.
Carry carriedCopies(swQueryTile tile, Flow flow, inout Shape shape)
{
    if (!WITH_FLOW || !isMoved(flow) || tile.carryPeriod <= 0.0)
    {
        return Carry(vec2(1.0, 0.0), vec2(0.0));
    }
    Carry carry = carryOf(tile.carryTurns, tile.carryPeriod);
    float between = 0.5 * tile.carryPeriod;
    shape = carried(shape, carry, between, flow, likenessOf(tile, between * flow.velocity));
    return carry;
}

// Likewise of free waves [first, end).
Carry carriedCopies(uint first, uint end, Flow flow, inout Shape shape)
{
    if (!WITH_FLOW || !isMoved(flow))
    {
        return Carry(vec2(1.0, 0.0), vec2(0.0));
    }
    Carry carry = carryOf(waves[first].carryTurns, waves[first].carryPeriod);
    float between = 0.5 * waves[first].carryPeriod;
    shape = carried(shape, carry, between, flow, likenessOf(first, end, between * flow.velocity));
    return carry;
}

uint copyCount(Carry carry)
{
    return carry.weights.y != 0.0 ? 2 : 1;
}

// Adds a copy of waves as a look sees them. `flow` is in the look's axes.
void addLooked(Look look, Flow flow, Shape shape, float weight, float seconds, Sum own, inout Sum sum)
{
    turnWaterByLook(look, look.source.way - seconds * flow.slopes, own.value, own.alongX, own.alongZ, own.skew);
    addShaped(Shape(weight * shape.weight, weight * shape.slope), own, sum);
}

void addLookedTile(Look look, Flow flow, Ground ground, swQueryTile tile, uint lane, vec4 cubic, inout Sum sum)
{
    Shape shape = attenuated(look.shape, ground, tile.waveNumber, attenuationOf(tile));
    Carry carry = carriedCopies(tile, flow, shape);
    for (uint c = 0; c < copyCount(carry); ++c)
    {
        Sum own = NO_WATER;
        addTile(tile, queryCellOf(look.at), queryRestOf(look.at) - carry.seconds[c] * flow.velocity, lane, cubic, own);
        addLooked(look, flow, shape, carry.weights[c], carry.seconds[c], own, sum);
    }
}

void addLookedWaves(Look look, Flow flow, Ground ground, uint first, uint end, inout Sum sum)
{
    Shape shape = attenuated(look.shape, ground, waves[first].waveNumber, waves[first].attenuation);
    Carry carry = carriedCopies(first, end, flow, shape);
    for (uint c = 0; c < copyCount(carry); ++c)
    {
        Sum own = NO_WATER;
        for (uint i = first; i < end; ++i)
        {
            addWave(waves[i], queryCellOf(look.at), queryRestOf(look.at) - carry.seconds[c] * flow.velocity, own);
        }
        addLooked(look, flow, shape, carry.weights[c], carry.seconds[c], own, sum);
    }
}

// Bits of the query's systems some of whose waves run along splines here.
uint ribbonSystemsOf(Shaper shaper)
{
    uint systems = shaper.ribbonSystems & querySystems;
    for (uint bits = systems; bits != 0; bits &= bits - 1)
    {
        systems &= slotOf(findLSB(bits)) < SW_QUERY_RIBBON_SYSTEMS ? ~0u : ~(1u << findLSB(bits));
    }
    return systems;
}

// Adds waves along splines. Groups of free waves go round the lanes.
void addRibbonWater(Shaper shaper, uint tileCount, uint waveCount, uint lane, vec4 cubic, inout Sum sum)
{
    uint systems = ribbonSystemsOf(shaper);
    for (; systems != 0; systems &= systems - 1)
    {
        uint system = findLSB(systems);
        for (uint l = 0; l < 2; ++l)
        {
            Look look = askedLook(system, l);
            Flow flow = turnFlowByLook(look, shaper.flow);
            for (uint i = 0; i < tileCount && isLookThere(look); ++i)
            {
                if (tiles[i].system == system)
                {
                    addLookedTile(look, flow, shaper.ground, tiles[i], lane, cubic, sum);
                }
            }
            uint turn = 0;
            for (uint first = 0; first < waveCount && isLookThere(look); ++turn)
            {
                uint end = min(waves[first].groupEnd, waveCount);
                if (waves[first].system == system && turn % SW_QUERY_LANES == lane)
                {
                    addLookedWaves(look, flow, shaper.ground, first, end, sum);
                }
                first = end;
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
        Sum own = NO_WATER;
        Shape shape = shapeOf(shaper, tiles[i].system, tiles[i].waveNumber, attenuationOf(tiles[i]));
        if (doesCarry(shaper) && tiles[i].carryPeriod > 0.0)
        {
            own = carriedTile(tiles[i], shaper.flow, cell, rest, lane, cubic, shape);
        }
        else
        {
            addTile(tiles[i], cell, rest, lane, cubic, own);
        }
        addShaped(shape, own, sum);
    }
    if (WITH_RIBBONS && shaper.ribbonSystems != 0)
    {
        addRibbonWater(shaper, tileCount, waveCount, lane, cubic, sum);
    }
    if (doesCarry(shaper))
    {
        addCarriedWaves(shaper, waveCount, cell, rest, lane, sum);
        return;
    }
    for (uint i = lane; i < waveCount; i += SW_QUERY_LANES)
    {
        Sum own = NO_WATER;
        addWave(waves[i], cell, rest, own);
        addShaped(shapeOf(shaper, waves[i].system, waves[i].waveNumber, waves[i].attenuation), own, sum);
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
    if (WITH_INPUTS)
    {
        shares[8][gl_LocalInvocationIndex] = sum.skew;
    }
}

Sum gatherSum()
{
    return Sum(gatherVector(0), gatherVector(3), vec2(gather(6), gather(7)), WITH_INPUTS ? gather(8) : 0.0);
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
    Sum raised;    // best with what displaces heights where they are
    bool hasPlace; // the level and the flow at the place are known
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
    search.best = NO_WATER;
    search.hasPlace = false;
    search.part.tileCount = 0;
    return search;
}

vec2 newtonStep(vec2 residual, Sum sum)
{
    float jacobian = swSurfaceArea(sum.alongX.x, xAlongZOf(sum), sum.alongX.z, sum.alongZ.y);
    vec2 step = vec2((1.0 + sum.alongZ.y) * residual.x - xAlongZOf(sum) * residual.y,
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

// ---- what inputs are asked ----

// A lane asks for one thing after the other, see lib/ask.glsl. An element of placeValues is asked for as ASK_FIELD and
// its number.
#define ASK_END (ASK_FIELD + ASKED_SYSTEMS + SW_LIMIT_SYSTEMS)

// Whether an element of placeValues is asked for where the search is. `systems` are those that inputs weigh there. Of
// the flow both numbers come at once.
bool isAsked(Search search, uint systems, uint element)
{
    if (element >= ASKED_SYSTEMS)
    {
        return (systems >> (element - ASKED_SYSTEMS) & 1u) != 0;
    }
    bool isOfPlace = element == ASKED_PLACE_LEVEL || element == ASKED_PLACE_FLOW;
    bool isOfFlow = element == ASKED_FLOW_X || (WITH_PLACE_FLOW && element == ASKED_PLACE_FLOW);
    return (!isOfPlace || !search.hasPlace) && (element < ASKED_FLOW_X || (WITH_FLOW && isOfFlow));
}

// The next element from `what` on that a lane asks for, of every fourth one; or ASK_END.
uint nextElement(Search search, uint systems, uint what)
{
    while (what < ASK_END && !isAsked(search, systems, what - ASK_FIELD))
    {
        what += SW_QUERY_LANES;
    }
    return min(what, ASK_END);
}

// Systems that inputs weigh where the search tries.
uint weighedSystems(Search search)
{
    return areSystemsWeighted(seaPlaceAt(search.cell, search.place + search.offset)) ? querySystems : 0u;
}

Ask askElement(Search search, uint what)
{
    uint element = what - ASK_FIELD;
    uint field = element < ASKED_FLOOR     ? SW_FIELD_OF_LEVEL
                 : element == ASKED_FLOOR  ? SW_FIELD_OF_FLOOR
                 : element < ASKED_SYSTEMS ? SW_FIELD_OF_FLOW
                                           : SW_FIELD_OF_WAVES;
    bool isOfPlace = element == ASKED_PLACE_LEVEL || element == ASKED_PLACE_FLOW;
    vec2 at = isOfPlace ? search.place : search.place + search.offset;
    return askField(what, field, element - ASKED_SYSTEMS, seaPlaceAt(search.cell, at));
}

void keep(uint element, vec3 value)
{
    placeValues[element][gl_LocalInvocationIndex / SW_QUERY_LANES] = value;
}

// Keeps an element, and looks at a system's waves.
void keepElement(Ask ask)
{
    uint element = ask.what - ASK_FIELD;
    keep(element, element == ASKED_PLACE_FLOW ? ask.said.plain.value.xyz : firstOf(ask.said.plain));
    if (element == ASKED_FLOW_X)
    {
        keep(ASKED_FLOW_Z, secondOf(ask.said.plain));
    }
    bool isKept = WITH_RIBBONS && ask.field == SW_FIELD_OF_WAVES && (inputHead.ribbonSystems >> ask.system & 1u) != 0;
    if (isKept && slotOf(ask.system) < SW_QUERY_RIBBON_SYSTEMS)
    {
        keepLook(slotOf(ask.system) * 8, ask.said.ribbons.first);
        keepLook(slotOf(ask.system) * 8 + 4, ask.said.ribbons.second);
    }
}

// The sum of the waves at the tried offset, for inputs to join that follow them.
Ask askTried(Search search, Sum sum)
{
    swInputValue waves =
        swInputValue(vec4(sum.value, 0.0), vec4(sum.alongX, 0.0), vec4(xAlongZOf(sum), sum.alongZ, 0.0));
    return askWaves(seaPlaceAt(search.cell, search.place + search.offset), params.water.minWavelength, waves);
}

Sum sumOf(Ask ask)
{
    swInputValue value = ask.said.plain;
    return Sum(value.value.xyz, value.alongX.xyz, value.alongZ.yz, value.alongZ.x - value.alongX.z);
}

// The height of what was found, by the place where it is.
swInputChannel heightOf(Sum sum)
{
    return heightByPlace(sum.value.y, vec2(sum.alongX.y, sum.alongZ.x), sum.alongX.xz,
                         vec2(xAlongZOf(sum), sum.alongZ.y));
}

SeaPlace foundPlace(Search search)
{
    return seaPlaceAt(search.cell, search.place + search.bestOffset + search.best.value.xz);
}

Ask askFound(Search search)
{
    vec3 level = askedOf(ASKED_PLACE_LEVEL);
    return askHeight(foundPlace(search), params.water.minWavelength, swMakeChannel(level.x, level.y, level.z),
                     heightOf(search.best));
}

// What was found, with the height that inputs make of it.
Sum raisedBy(Ask ask, Sum found)
{
    vec2 slope = slopeByRest(heightOf(found), channelOf(ask), found.alongX.xz, vec2(xAlongZOf(found), found.alongZ.y));
    found.value.y = channelOf(ask).value;
    found.alongX.y += slope.x;
    found.alongZ.x += slope.y;
    return found;
}

// ---- what was found ----

// What was found, as the surface stands on its level. Chain rule: the level is a function of where particles are,
// derivatives are by where they rest.
Sum surfaceOf(Search search)
{
    Sum sum = search.best;
    if (WITH_DISPLACEMENT)
    {
        sum = search.raised;
    }
    vec3 level = WITH_INPUTS ? askedOf(ASKED_PLACE_LEVEL) : vec3(0.0);
    sum.value.y += level.x;
    sum.alongX.y += level.y * (1.0 + sum.alongX.x) + level.z * sum.alongX.z;
    sum.alongZ.x += level.y * xAlongZOf(sum) + level.z * (1.0 + sum.alongZ.y);
    return sum;
}

// Normal and J of the surface, from a particle's derivatives. The underside of a fold is turned over.
vec4 normalOf(Sum sum)
{
    float jacobian = swSurfaceArea(sum.alongX.x, xAlongZOf(sum), sum.alongX.z, sum.alongZ.y);
    float x = swSurfaceNormalX(sum.alongX.z, sum.alongZ.y, sum.alongX.y, sum.alongZ.x);
    float z = swSurfaceNormalZ(sum.alongX.x, xAlongZOf(sum), sum.alongX.y, sum.alongZ.x);
    vec3 normal = vec3(-x, jacobian, -z);
    float size = length(normal);
    normal = size < 1e-20 ? vec3(0.0, 1.0, 0.0) : normal * ((jacobian < 0.0 ? -1.0 : 1.0) / size);
    return vec4(normal, jacobian);
}
