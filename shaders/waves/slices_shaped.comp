// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// The waves of slices that are shaped by their place: those that feel the floor or have a weight of their own somewhere
// in a block of SW_SLICE_WIDTH x SW_SLICE_HEIGHT texels. The pass of fields says of each block how deep its shallowest
// texel is and which wave systems have weights there, and nothing is done in blocks of which it says nothing. The sums
// go to a buffer, and slices.comp adds to them the waves that are the same everywhere. Both know which waves are whose
// by isShapedIn(), so each is added once. The twin of core/surface/evaluate_shaped.c.
//
// Everything that makes waves differ from place to place is added here, in addAllShaped(), and slices.comp knows
// nothing of it. A workgroup makes SW_SHAPED_ROWS rows of a block, a thread a texel. The spline is separable: for each
// tile, what its columns are at each of the rows is interpolated along z once for all texels, in shared memory, and
// each texel interpolates that along x. Runs of four texels a thread, which share cubics along z in registers, need
// fewer operations, but took as long or longer, with 37 KB of code and 143 to 191 registers instead of 18 KB and 64.

#include "shared/fields.h"
#include "shared/spline.h"
#include "shared/waves.h"

layout(local_size_x = SW_SLICE_WIDTH, local_size_y = SW_SHAPED_ROWS) in;
layout(constant_id = 0) const bool WITH_WAVES = true;        // free waves
layout(constant_id = 1) const bool WITH_WEIGHTS = true;      // systems may have weights of their own there
layout(constant_id = 2) const bool WITH_FLOW = true;         // a flow may carry waves
layout(constant_id = 3) const bool WITH_DISPLACEMENT = true; // inputs may displace the water
layout(constant_id = 4) const bool WITH_RIBBONS = true;      // some waves run along splines
const bool WITH_HOLES = false;

layout(std430, binding = 0) readonly buffer Lists
{
    swSliceList lists[];
};
layout(std430, binding = 1) readonly buffer Tiles
{
    swSliceTile tiles[];
};
layout(std430, binding = 2) readonly buffer Texels
{
    vec4 texels[];
};
layout(std430, binding = 3) readonly buffer Waves
{
    swSliceWave waves[];
};
layout(binding = 4, rgba32f) uniform readonly image2DArray places; // depth, its slopes along x and z, level
layout(std430, binding = 5) readonly buffer Blocks
{
    swFieldBlock blocks[];
};
layout(std430, binding = 6) readonly buffer FieldSlices
{
    swFieldSlice fieldSlices[];
};
layout(std430, binding = 7) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 8) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 9) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 10) readonly buffer InputWords
{
    float inputWords[];
};
// Of each texel of all slices x, y and z of the displacement and the slope of x along x; then of each the slopes of y
// and z along x, and of y and z along z.
layout(std430, binding = 11) writeonly buffer Shaped
{
    vec4 shaped[];
};
layout(binding = 12, rgba32f) uniform readonly image2DArray flow;       // velocity along x and z
layout(binding = 13, rgba16f) uniform readonly image2DArray flowSlopes; // of that along x by x and z, of that along z
layout(std430, binding = 14) readonly buffer Likeness
{
    float likeness[]; // see lib/likeness.glsl
};
layout(push_constant) uniform Push
{
    uint resolution;
};

#include "lib/ask.glsl"
#include "lib/displaced.glsl"
#include "lib/likeness.glsl"
#include "lib/places.glsl"
#include "lib/ribbons.glsl"
#include "lib/slice_waves.glsl"

// A part of the slice's tiles.
shared swSliceTile blockTiles[SW_SHAPED_TILES];
// Columns of a batch of them at each row: displacement and the slope of y along z; the slope of z along z.
shared vec4 laidOut[SW_SHAPED_ROWS * SW_SHAPED_COLUMNS];
shared float laidOutSlope[SW_SHAPED_ROWS * SW_SHAPED_COLUMNS];

swFieldBlock fieldBlock;

// ---- what a place does ----

// The texel of the authored fields.
Ground groundOf(uint column, uint row)
{
    if (fieldBlock.leastDepth >= SW_NO_DEPTH) // perhaps there is no such layer
    {
        return NO_GROUND;
    }
    vec4 texel = imageLoad(places, ivec3(column, row, gl_WorkGroupID.z));
    return Ground(texel.x, texel.yz, texel.w);
}

bool doesCarry()
{
    return WITH_FLOW && (fieldBlock.flags & SW_BLOCK_FLOWS) != 0;
}

Flow flowAt(uint column, uint row)
{
    ivec3 texel = ivec3(column, row, gl_WorkGroupID.z);
    return besideEven(Flow(imageLoad(flow, texel).xy, imageLoad(flowSlopes, texel)));
}

// Adds waves of one shape.
void addShaped(inout Texel texel, Texel own, Shape shape)
{
    texel.sum += shape.weight * own.sum;
    texel.alongX += shape.weight * own.alongX + shape.slope.x * own.sum;
    texel.alongZ += shape.weight * own.alongZ + shape.slope.y * own.sum.yz;
}

// ---- tiles ----

bool isShapedTile(uint b)
{
    return isShapedIn(fieldBlock, blockTiles[b].system, blockTiles[b].waveNumber, blockTiles[b].attenuation);
}

// First column of a tile that a block of texels touches, not wrapped.
float firstOfBlock(swSliceTile tile)
{
    return floor(splineX(tile, gl_WorkGroupID.x * SW_SLICE_WIDTH));
}

// A column of a tile, interpolated along z at a row of texels.
void placeColumn(swSliceTile tile, uint column, uint row, uint to)
{
    float s = splineZ(tile, row);
    float cell = floor(s);
    vec4 value = swSplineWeights(s - cell), slope = swSplineSlopes(s - cell) * tile.perMetre;
    uint x = (tile.base & 0xffffu) + uint(firstOfBlock(tile)) + column;
    uint z = (tile.base >> 16) + uint(cell);
    vec3 a = texelOf(tile, x, z), b = texelOf(tile, x, z + 1);
    vec3 c = texelOf(tile, x, z + 2), d = texelOf(tile, x, z + 3);
    vec3 along = weigh(slope, a, b, c, d);
    laidOut[to] = vec4(weigh(value, a, b, c, d), along.y);
    laidOutSlope[to] = along.z;
}

// Lays out the shaped ones of tiles [first, end): the threads of a row all columns at that row.
void placeColumns(uint first, uint end, uint row)
{
    uint count = blockTiles[first].firstShaped + blockTiles[first].shapedColumns;
    for (uint i = gl_LocalInvocationID.x; i < count; i += SW_SLICE_WIDTH)
    {
        uint b = end - 1; // places begin with the last
        while (b > first && i >= blockTiles[b - 1].firstShaped)
        {
            b -= 1;
        }
        if (isShapedTile(b))
        {
            placeColumn(blockTiles[b], i - blockTiles[b].firstShaped, row,
                        gl_LocalInvocationID.y * SW_SHAPED_COLUMNS + i);
        }
    }
}

bool isAnyShaped(uint first, uint end)
{
    bool isAny = false;
    for (uint b = first; b < end; ++b)
    {
        isAny = isAny || isShapedTile(b);
    }
    return isAny;
}

// A tile that is laid out, at a texel: interpolated along x.
Texel laidOutAt(swSliceTile tile, uint column)
{
    float s = splineX(tile, column);
    float cell = floor(s);
    vec4 value = swSplineWeights(s - cell), slope = swSplineSlopes(s - cell) * tile.perMetre;
    uint at = gl_LocalInvocationID.y * SW_SHAPED_COLUMNS + tile.firstShaped + uint(cell - firstOfBlock(tile));
    vec4 a = laidOut[at], b = laidOut[at + 1], c = laidOut[at + 2], d = laidOut[at + 3];
    vec4 along = vec4(laidOutSlope[at], laidOutSlope[at + 1], laidOutSlope[at + 2], laidOutSlope[at + 3]);
    Texel own;
    own.sum = weigh(value, a.xyz, b.xyz, c.xyz, d.xyz);
    own.alongX = weigh(slope, a.xyz, b.xyz, c.xyz, d.xyz);
    own.alongZ = vec2(dot(value, vec4(a.w, b.w, c.w, d.w)), dot(value, along));
    return own;
}

// ---- waves that a flow carries ----

// Adds a copy of waves: what it counts, and the slopes of where it is looked up less where that is.
void addCopy(inout Texel texel, float weight, vec4 way, Texel own)
{
    vec3 alongZ = vec3(own.alongX.z, own.alongZ);
    texel.sum += weight * own.sum;
    texel.alongX += weight * (own.alongX * (1.0 + way.x) + alongZ * way.z);
    texel.alongZ += weight * (own.alongX.yz * way.y + own.alongZ * (1.0 + way.w));
}

// Adds both copies of a tile to a texel, from all sixteen coefficients around each.
void addCarriedTile(inout Texel texel, swSliceTile tile, uint column, uint row, Flow moved, Shape shape)
{
    Texel sum = CALM;
    Carry carry = carryOf(tile.carryTurns, tile.carryPeriod);
    float between = 0.5 * tile.carryPeriod;
    vec3 rho = likenessOf(tile.firstTexel, tile.resolution, tile.perMetre, between * moved.velocity);
    for (uint c = 0; c < 2; ++c)
    {
        vec2 way = -carry.seconds[c] * moved.velocity * tile.perMetre;
        Texel own = CALM;
        addWindowAt(own, tile, splineX(tile, column) + way.x, splineZ(tile, row) + way.y);
        addCopy(sum, carry.weights[c], -carry.seconds[c] * moved.slopes, own);
    }
    addShaped(texel, sum, carried(shape, carry, between, moved, rho));
}

// The same of the tiles that were joined: how alike copies are is each one's own.
void addCarriedTiles(inout Texel texel, swSliceTile tile, uint column, uint row, Flow moved, Shape shape)
{
    uint second = tile.secondTexel;
    tile.secondTexel = SW_NO_TEXEL;
    for (uint i = 0; i < 2 && tile.firstTexel != SW_NO_TEXEL; ++i)
    {
        addCarriedTile(texel, tile, column, row, moved, shape);
        tile.firstTexel = second;
    }
}

float turnsOf(swSliceWave wave, vec2 way)
{
    return (wave.kx * way.x + wave.kz * way.y) * (1.0 / 6.28318530718);
}

// How alike the heights of free waves [first, end) are a way apart: the mean of cos(k . way), by energy.
vec3 likenessOf(uint first, uint end, vec2 way)
{
    float energy = 0.0;
    vec3 found = vec3(0.0);
    for (uint i = first; i < end; ++i)
    {
        swSliceWave wave = waves[i];
        float square = wave.amplitude * wave.amplitude;
        vec2 unit = square * unitOf(toTurns(turnsOf(wave, way)));
        energy += square;
        found += vec3(unit.x, -unit.y * vec2(wave.kx, wave.kz));
    }
    return energy > 0.0 ? found / energy : vec3(1.0, 0.0, 0.0);
}

// Both copies of free waves [first, end), which are of one octave and one system.
void addCarriedWaves(inout Texel texel, uint first, uint end, uint column, uint row, Flow moved, Shape shape)
{
    Carry carry = carryOf(waves[first].carryTurns, waves[first].carryPeriod);
    float between = 0.5 * waves[first].carryPeriod;
    vec3 rho = likenessOf(first, end, between * moved.velocity);
    Texel sum = CALM;
    for (uint c = 0; c < 2; ++c)
    {
        vec2 way = -carry.seconds[c] * moved.velocity;
        Texel own = CALM;
        for (uint k = first; k < end; ++k)
        {
            swSliceWave wave = waves[k];
            addWave(own, wave, wave.amplitude * unitOf(phaseOfTexel(wave, column, row) + toTurns(turnsOf(wave, way))));
        }
        addCopy(sum, carry.weights[c], -carry.seconds[c] * moved.slopes, own);
    }
    addShaped(texel, sum, carried(shape, carry, between, moved, rho));
}

// ---- waves along splines ----

// Bits of the systems of which some waves run along splines in the block.
uint ribbonSystemsOfBlock()
{
    return WITH_RIBBONS ? fieldBlock.systems & inputHead.ribbonSystems : 0u;
}

// The way from the slice's first texel to so many seconds against a flow from a place.
Way wayTo(SeaPlace place, float seconds, Flow moved)
{
    swFieldSlice slice = fieldSlices[gl_WorkGroupID.z];
    return Way(place.cell - ivec2(slice.cellX, slice.cellZ),
               place.rest - vec2(slice.restX, slice.restZ) - seconds * moved.velocity);
}

// Adds one of the copies of waves as a look sees them. `moved` is in the look's axes.
void addLooked(inout Texel texel, Look look, Flow moved, Shape shape, float weight, float seconds, Texel own)
{
    float skew = 0.0; // slices keep three of the four derivatives
    turnWaterByLook(look, look.source.way - seconds * moved.slopes, own.sum, own.alongX, own.alongZ, skew);
    addShaped(texel, own, Shape(weight * shape.weight, weight * shape.slope));
}

void addLookedTile(inout Texel texel, swSliceTile tile, Look look, Flow moved, Shape shape)
{
    Carry carry = Carry(vec2(1.0, 0.0), vec2(0.0));
    if (isMoved(moved) && tile.carryPeriod > 0.0)
    {
        float between = 0.5 * tile.carryPeriod;
        carry = carryOf(tile.carryTurns, tile.carryPeriod);
        shape = carried(shape, carry, between, moved,
                        likenessOf(tile.firstTexel, tile.resolution, tile.perMetre, between * moved.velocity));
    }
    for (uint c = 0; c < (carry.weights.y != 0.0 ? 2 : 1); ++c)
    {
        Texel own = CALM;
        addTileAt(own, tile, wayTo(look.at, carry.seconds[c], moved));
        addLooked(texel, look, moved, shape, carry.weights[c], carry.seconds[c], own);
    }
}

// Free waves [first, end), which are of one octave and one system.
void addLookedWaves(inout Texel texel, uint first, uint end, Look look, Flow moved, Shape shape)
{
    Carry carry = Carry(vec2(1.0, 0.0), vec2(0.0));
    if (isMoved(moved))
    {
        float between = 0.5 * waves[first].carryPeriod;
        carry = carryOf(waves[first].carryTurns, waves[first].carryPeriod);
        shape = carried(shape, carry, between, moved, likenessOf(first, end, between * moved.velocity));
    }
    for (uint c = 0; c < (carry.weights.y != 0.0 ? 2 : 1); ++c)
    {
        Texel own = CALM;
        for (uint k = first; k < end; ++k)
        {
            addWaveAt(own, waves[k], wayTo(look.at, carry.seconds[c], moved));
        }
        addLooked(texel, look, moved, shape, carry.weights[c], carry.seconds[c], own);
    }
}

// Adds a system's tiles and free waves as they are seen by a look to a texel.
void addLook(inout Texel texel, swSliceList list, uint system, Look look, Ground ground, Flow flowThere)
{
    if (!isLookThere(look))
    {
        return;
    }
    Flow moved = STILL;
    if (doesCarry())
    {
        moved = turnFlowByLook(look, flowThere);
    }
    for (uint k = 0; k < list.count + list.windowCount; ++k)
    {
        swSliceTile tile = tiles[list.first + k];
        if (tile.system == system)
        {
            addLookedTile(texel, tile, look, moved, attenuated(look.shape, ground, tile.waveNumber, tile.attenuation));
        }
    }
    uint end = 0;
    for (uint k = 0; k < (WITH_WAVES ? list.waveCount : 0); k = end)
    {
        swSliceWave wave = waves[list.firstWave + k];
        end = wave.groupEnd;
        if (wave.system == system)
        {
            addLookedWaves(texel, list.firstWave + k, list.firstWave + end, look, moved,
                           attenuated(look.shape, ground, wave.waveNumber, wave.attenuation));
        }
    }
}

// Bits of the systems of a slice.
uint systemsOf(swSliceList list)
{
    uint systems = 0;
    for (uint k = 0; k < list.count + list.windowCount; ++k)
    {
        systems |= 1u << tiles[list.first + k].system;
    }
    for (uint k = 0; k < (WITH_WAVES ? list.waveCount : 0); k = waves[list.firstWave + k].groupEnd)
    {
        systems |= 1u << waves[list.firstWave + k].system;
    }
    return systems;
}

// ---- all of a texel ----

// What a place does to a texel.
struct TexelPlace
{
    SeaPlace rest;
    Ground ground;
    Flow flow;
    Shape weight; // of the system asked last
    uint system;
    swInputChannel level; // of still water where the texel's particle is, once it was asked for
};

bool isAnything(Shape shape)
{
    return shape.weight != 0.0 || shape.slope != vec2(0.0);
}

void addTile(inout Texel texel, TexelPlace place, uint b, uint column, uint row)
{
    Shape shape = attenuated(place.weight, place.ground, blockTiles[b].waveNumber, blockTiles[b].attenuation);
    if (!isAnything(shape))
    {
        return;
    }
    if (doesCarry() && blockTiles[b].carryPeriod > 0.0 && isMoved(place.flow))
    {
        addCarriedTiles(texel, blockTiles[b], column, row, place.flow, shape);
        return;
    }
    Texel own = CALM;
    if (blockTiles[b].shapedColumns > 0)
    {
        own = laidOutAt(blockTiles[b], column);
    }
    else
    {
        addWindow(own, blockTiles[b], column, row);
    }
    addShaped(texel, own, shape);
}

// Free waves [first, end); one where no flow carries them.
void addFreeWaves(inout Texel texel, TexelPlace place, uint first, uint end, uint column, uint row)
{
    swSliceWave wave = waves[first];
    Shape shape = attenuated(place.weight, place.ground, wave.waveNumber, wave.attenuation);
    if (doesCarry())
    {
        addCarriedWaves(texel, first, end, column, row, place.flow, shape);
        return;
    }
    Texel own = CALM;
    addWave(own, wave, swingOf(wave, column, row));
    addShaped(texel, own, shape);
}

// ---- parts ----

// Inputs are sampled in one place, so all that is added to a texel goes through one loop: the tiles, a part of
// SW_SHAPED_TILES after the other, then free waves, what runs along splines, and what displaces the water. Units of a
// part are tiles, free waves, systems, and the three that displace: waves, the level of still water, heights.
#define PART_WAVES 0u
#define PART_RIBBONS 1u
#define PART_DISPLACED 2u
#define PART_TILES 3u

#define DISPLACED_WAVES 0u
#define DISPLACED_LEVEL 1u
#define DISPLACED_HEIGHT 2u
#define DISPLACED_UNITS 3u

uint unitsOf(uint part, swSliceList list)
{
    if (part == PART_WAVES)
    {
        return WITH_WAVES ? list.waveCount : 0u;
    }
    if (part == PART_RIBBONS)
    {
        return ribbonSystemsOfBlock() != 0 ? SW_LIMIT_SYSTEMS : 0u;
    }
    return WITH_DISPLACEMENT && (fieldBlock.flags & SW_BLOCK_DISPLACED) != 0 ? DISPLACED_UNITS : 0u;
}

// The system whose weight a tile or a free wave takes.
uint systemOf(uint part, swSliceList list, uint unit)
{
    return part == PART_TILES ? blockTiles[unit].system : waves[list.firstWave + unit].system;
}

// Whether a unit is anything in this block. All of a workgroup say the same. `ribbons` has bits of systems.
bool isShapedUnit(uint part, swSliceList list, uint unit, uint ribbons)
{
    if (part == PART_TILES)
    {
        return isShapedTile(unit);
    }
    if (part == PART_WAVES)
    {
        swSliceWave wave = waves[list.firstWave + unit];
        return isShapedIn(fieldBlock, wave.system, wave.waveNumber, wave.attenuation);
    }
    return part == PART_DISPLACED || (ribbons >> unit & 1u) != 0;
}

SeaPlace placeOfParticle(TexelPlace place, Texel texel)
{
    return seaPlaceOf(place.rest.cell, place.rest.rest + texel.sum.xz);
}

swInputChannel heightOf(Texel texel)
{
    return heightByPlace(texel.sum.y, vec2(texel.alongX.y, texel.alongZ.x), texel.alongX.xz,
                         vec2(texel.alongX.z, texel.alongZ.y));
}

Ask askDisplaced(uint unit, float least, TexelPlace place, Texel texel)
{
    if (unit == DISPLACED_WAVES)
    {
        return askWaves(
            place.rest, least,
            swInputValue(vec4(texel.sum, 0.0), vec4(texel.alongX, 0.0), vec4(texel.alongX.z, texel.alongZ, 0.0)));
    }
    if (unit == DISPLACED_LEVEL)
    {
        return askField(ASK_FIELD, SW_FIELD_OF_LEVEL, SW_ALL_SYSTEMS, placeOfParticle(place, texel));
    }
    return askHeight(placeOfParticle(place, texel), least, place.level, heightOf(texel));
}

void takeDisplaced(uint unit, Ask ask, inout TexelPlace place, inout Texel texel)
{
    if (unit == DISPLACED_WAVES)
    {
        swInputValue value = ask.said.plain;
        texel = Texel(value.value.xyz, value.alongX.xyz, value.alongZ.yz);
    }
    else if (unit == DISPLACED_LEVEL)
    {
        place.level = channelOf(ask);
    }
    else
    {
        vec2 slope =
            slopeByRest(heightOf(texel), channelOf(ask), texel.alongX.xz, vec2(texel.alongX.z, texel.alongZ.y));
        texel.sum.y = channelOf(ask).value;
        texel.alongX.y += slope.x;
        texel.alongZ.x += slope.y;
    }
}

// Adds one unit of a part, up to the next, to a texel.
void addUnit(inout Texel texel, inout TexelPlace place, uint part, swSliceList list, uint unit, uint next, uint column,
             uint row)
{
    bool isOfWaves = part == PART_TILES || part == PART_WAVES;
    uint system = isOfWaves ? systemOf(part, list, unit) : unit;
    bool isNew = WITH_WEIGHTS && isOfWaves && system != place.system;
    bool isWeighed = isNew && (fieldBlock.systems >> (system & 31u) & 1u) != 0;
    Ask ask;
    if (isWeighed || (WITH_RIBBONS && part == PART_RIBBONS) || (WITH_DISPLACEMENT && part == PART_DISPLACED))
    {
        if (part == PART_DISPLACED)
        {
            ask = askDisplaced(unit, list.minWavelength, place, texel);
        }
        else
        {
            ask = askField(ASK_FIELD, SW_FIELD_OF_WAVES, system, place.rest);
        }
        answer(ask);
    }
    if (isNew)
    {
        place.weight = Shape(1.0, vec2(0.0));
        place.system = system;
        if (isWeighed)
        {
            place.weight = Shape(ask.said.plain.value.x, vec2(ask.said.plain.alongX.x, ask.said.plain.alongZ.x));
        }
    }
    if (part == PART_TILES)
    {
        addTile(texel, place, unit, column, row);
    }
    else if (part == PART_WAVES)
    {
        addFreeWaves(texel, place, list.firstWave + unit, list.firstWave + next, column, row);
    }
    else if (WITH_RIBBONS && part == PART_RIBBONS)
    {
        for (uint l = 0; l < 2; ++l)
        {
            swRibbonLook look = ask.said.ribbons.first;
            if (l == 1)
            {
                look = ask.said.ribbons.second;
            }
            addLook(texel, list, system, lookOf(look), place.ground, place.flow);
        }
    }
    else if (WITH_DISPLACEMENT)
    {
        takeDisplaced(unit, ask, place, texel);
    }
}

// Adds all that is shaped in this block.
void addAllShaped(inout Texel texel, swSliceList list, uint column, uint row)
{
    TexelPlace place = TexelPlace(placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, row), groundOf(column, row),
                                  STILL, Shape(1.0, vec2(0.0)), ~0u, swKeepChannel(0.0));
    if (doesCarry())
    {
        place.flow = flowAt(column, row);
    }
    uint ribbons = ribbonSystemsOfBlock() != 0 ? ribbonSystemsOfBlock() & systemsOf(list) : 0u;
    uint tileCount = list.count + list.windowCount;
    uint tileParts = (tileCount + SW_SHAPED_TILES - 1) / SW_SHAPED_TILES;
    for (uint i = 0; i < tileParts + PART_TILES; ++i)
    {
        bool isOfTiles = i < tileParts;
        uint part = isOfTiles ? PART_TILES : i - tileParts;
        uint first = isOfTiles ? (tileParts - 1 - i) * SW_SHAPED_TILES : 0;
        uint last = isOfTiles ? min(first + SW_SHAPED_TILES, tileCount) - first : unitsOf(part, list);
        if (isOfTiles)
        {
            barrier(); // nobody reads the part before
            if (gl_LocalInvocationIndex < last)
            {
                blockTiles[gl_LocalInvocationIndex] = tiles[list.first + first + gl_LocalInvocationIndex];
            }
            barrier();
        }
        for (uint end = last, begin; end > 0; end = begin)
        {
            begin = isOfTiles ? blockTiles[end - 1].shapedBegin - first : 0;
            if (isOfTiles)
            {
                if (!isAnyShaped(begin, end))
                {
                    continue;
                }
                placeColumns(begin, end, row);
                barrier();
            }
            for (uint unit = begin, next; unit < end; unit = next)
            {
                bool isGroup = part == PART_WAVES && doesCarry();
                next = isGroup ? waves[list.firstWave + unit].groupEnd : unit + 1;
                if (isShapedUnit(part, list, unit, ribbons))
                {
                    addUnit(texel, place, part, list, unit, next, column, row);
                }
            }
            if (isOfTiles)
            {
                barrier(); // nobody reads what was laid out
            }
        }
    }
}

void storeShaped(uint column, uint row, Texel texel)
{
    uint at = (gl_WorkGroupID.z * resolution + row) * resolution + column;
    shaped[at] = vec4(texel.sum, texel.alongX.x);
    shaped[at + gl_NumWorkGroups.z * resolution * resolution] = vec4(texel.alongX.yz, texel.alongZ);
}

void main()
{
    uint column = gl_GlobalInvocationID.x;
    uint row = gl_GlobalInvocationID.y;
    uint blockRow = row / SW_SLICE_HEIGHT;
    fieldBlock =
        blocks[(gl_WorkGroupID.z * (resolution / SW_SLICE_HEIGHT) + blockRow) * gl_NumWorkGroups.x + gl_WorkGroupID.x];
    if (!isTouched(fieldBlock))
    {
        return;
    }
    Texel texel = CALM;
    addAllShaped(texel, lists[gl_WorkGroupID.z], column, row);
    if (column < resolution)
    {
        storeShaped(column, row, texel);
    }
}
