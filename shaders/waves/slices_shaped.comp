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
// nothing of it. A thread adds up a run of SW_SHAPED_RUN texels of a column, which share the rows of a tile's
// coefficients that it has weighed along x.

#include "shared/fields.h"
#include "shared/spline.h"
#include "shared/waves.h"

layout(local_size_x = SW_SLICE_WIDTH) in;
layout(constant_id = 0) const bool WITH_WAVES = true;        // free waves
layout(constant_id = 1) const bool WITH_WEIGHTS = true;      // systems may have weights of their own there
layout(constant_id = 2) const bool WITH_FLOW = true;         // a flow may carry waves
layout(constant_id = 3) const bool WITH_DISPLACEMENT = true; // inputs may displace the water
layout(constant_id = 4) const bool WITH_RIBBONS = true;      // some waves run along splines

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

#include "lib/inputs.glsl"

#include "lib/displaced.glsl"
#include "lib/likeness.glsl"
#include "lib/places.glsl"
#include "lib/ribbons.glsl"
#include "lib/slice_waves.glsl"

swFieldBlock fieldBlock;

// Texels of a column that follow each other. They have names, not indices: an array that is indexed would leave the
// registers.
struct Run
{
    Texel a, b, c, d;
};

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

// The weight of a system's waves where a texel rests.
Shape weightOf(uint system, uint column, uint row)
{
    if (!WITH_WEIGHTS || (fieldBlock.systems >> (system & 31u) & 1u) == 0)
    {
        return Shape(1.0, vec2(0.0));
    }
    SeaPlace place = placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, row);
    swInputValue value;
    if (WITH_RIBBONS)
    {
        value = looksAt(SW_FIELD_OF_WAVES, system, place).plain;
    }
    else
    {
        value = fieldAt(SW_FIELD_OF_WAVES, system, place);
    }
    vec3 weight = firstOf(value);
    return Shape(weight.x, weight.yz);
}

bool doesCarry()
{
    return WITH_FLOW && (fieldBlock.flags & SW_BLOCK_FLOWS) != 0;
}

Flow flowAt(uint column, uint row)
{
    ivec3 texel = ivec3(column, row, gl_WorkGroupID.z);
    return Flow(imageLoad(flow, texel).xy, imageLoad(flowSlopes, texel));
}

// Adds waves of one shape.
void addShaped(inout Texel texel, Texel own, Shape shape)
{
    texel.sum += shape.weight * own.sum;
    texel.alongX += shape.weight * own.alongX + shape.slope.x * own.sum;
    texel.alongZ += shape.weight * own.alongZ + shape.slope.y * own.sum.yz;
}

void addToRun(inout Run run, uint i, Texel own, Shape shape)
{
    if (i == 0)
    {
        addShaped(run.a, own, shape);
    }
    else if (i == 1)
    {
        addShaped(run.b, own, shape);
    }
    else if (i == 2)
    {
        addShaped(run.c, own, shape);
    }
    else
    {
        addShaped(run.d, own, shape);
    }
}

// ---- tiles ----

// Four rows of a tile's coefficients around a texel, weighed along x: values, and slopes along x.
struct Rows
{
    uint first; // row of the tile
    vec3 valueA, valueB, valueC, valueD;
    vec3 slopeA, slopeB, slopeC, slopeD;
};

void shiftRows(inout Rows rows, swSliceTile tile, uint first, vec4 value, vec4 slope)
{
    rows.valueA = rows.valueB;
    rows.valueB = rows.valueC;
    rows.valueC = rows.valueD;
    rows.slopeA = rows.slopeB;
    rows.slopeB = rows.slopeC;
    rows.slopeC = rows.slopeD;
    vec3 a = texelOf(tile, first, rows.first + 4), b = texelOf(tile, first + 1, rows.first + 4);
    vec3 c = texelOf(tile, first + 2, rows.first + 4), d = texelOf(tile, first + 3, rows.first + 4);
    rows.valueD = weigh(value, a, b, c, d);
    rows.slopeD = weigh(slope, a, b, c, d);
    rows.first += 1;
}

// Adds a tile to the texels of a run, from row `lowest` on.
void addShapedTile(inout Run run, swSliceTile tile, uint column, uint lowest, Shape shapes[SW_SHAPED_RUN])
{
    float x = splineX(tile, column);
    float cellX = floor(x);
    uint first = (tile.base & 0xffffu) + uint(cellX);
    vec4 value = swSplineWeights(x - cellX), slope = swSplineSlopes(x - cellX) * tile.perMetre;
    Rows rows;
    rows.first = uint(floor(splineZ(tile, lowest))) + (tile.base >> 16) - 4u;
    for (uint i = 0; i < 4; ++i)
    {
        shiftRows(rows, tile, first, value, slope);
    }
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        float z = splineZ(tile, lowest + i);
        float cellZ = floor(z);
        uint row = uint(cellZ) + (tile.base >> 16);
        while (rows.first != row)
        {
            shiftRows(rows, tile, first, value, slope);
        }
        vec4 valueZ = swSplineWeights(z - cellZ), slopeZ = swSplineSlopes(z - cellZ) * tile.perMetre;
        Texel own;
        own.sum = weigh(valueZ, rows.valueA, rows.valueB, rows.valueC, rows.valueD);
        own.alongX = weigh(valueZ, rows.slopeA, rows.slopeB, rows.slopeC, rows.slopeD);
        own.alongZ = weigh(slopeZ, rows.valueA, rows.valueB, rows.valueC, rows.valueD).yz;
        addToRun(run, i, own, shapes[i]);
    }
}

// ---- free waves ----

void addShapedWave(inout Run run, swSliceWave wave, uint column, uint lowest, Shape shapes[SW_SHAPED_RUN])
{
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        Texel own = CALM;
        addWave(own, wave, swingOf(wave, column, lowest + i));
        addToRun(run, i, own, shapes[i]);
    }
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

// Adds both copies of a tile to a texel of the run, from all sixteen coefficients around each.
void addCarriedTile(inout Run run, swSliceTile tile, uint column, uint row, uint i, Flow moved, Shape shape)
{
    Texel sum = CALM;
    if (!isMoved(moved)) // of the block's other texels
    {
        addWindow(sum, tile, column, row);
        addToRun(run, i, sum, shape);
        return;
    }
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
    addToRun(run, i, sum, carried(shape, carry, between, moved, rho));
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
void addCarriedWaves(inout Run run, uint first, uint end, uint column, uint row, uint i, Flow moved, Shape shape)
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
    addToRun(run, i, sum, carried(shape, carry, between, moved, rho));
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
void addLooked(inout Run run, uint i, Look look, Flow moved, Shape shape, float weight, float seconds, Texel own)
{
    turnWaterByLook(look, look.source.way - seconds * moved.slopes, own.sum, own.alongX, own.alongZ);
    addToRun(run, i, own, Shape(weight * shape.weight, weight * shape.slope));
}

void addLookedTile(inout Run run, uint i, swSliceTile tile, Look look, Flow moved, Shape shape)
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
        addLooked(run, i, look, moved, shape, carry.weights[c], carry.seconds[c], own);
    }
}

// Free waves [first, end), which are of one octave and one system.
void addLookedWaves(inout Run run, uint i, uint first, uint end, Look look, Flow moved, Shape shape)
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
        addLooked(run, i, look, moved, shape, carry.weights[c], carry.seconds[c], own);
    }
}

// Adds a system's tiles and free waves as they are seen by a look to a texel of the run.
void addLook(inout Run run, uint i, swSliceList list, uint system, Look look, uint column, uint row)
{
    if (!isLookThere(look))
    {
        return;
    }
    Ground ground = groundOf(column, row);
    Flow moved = STILL;
    if (doesCarry())
    {
        moved = turnFlowByLook(look, flowAt(column, row));
    }
    for (uint k = 0; k < list.count + list.windowCount; ++k)
    {
        swSliceTile tile = tiles[list.first + k];
        if (tile.system == system)
        {
            addLookedTile(run, i, tile, look, moved, attenuated(look.shape, ground, tile.waveNumber, tile.attenuation));
        }
    }
    uint end = 0;
    for (uint k = 0; k < (WITH_WAVES ? list.waveCount : 0); k = end)
    {
        swSliceWave wave = waves[list.firstWave + k];
        end = wave.groupEnd;
        if (wave.system == system)
        {
            addLookedWaves(run, i, list.firstWave + k, list.firstWave + end, look, moved,
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

// Adds waves along splines.
void addRibbons(inout Run run, swSliceList list, uint column, uint lowest)
{
    for (uint systems = ribbonSystemsOfBlock() & systemsOf(list); systems != 0; systems &= systems - 1)
    {
        uint system = findLSB(systems);
        for (uint i = 0; i < SW_SHAPED_RUN; ++i)
        {
            SeaPlace place = placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, lowest + i);
            swRibbonLooks looks = looksAt(SW_FIELD_OF_WAVES, system, place).ribbons;
            addLook(run, i, list, system, lookOf(looks.first), column, lowest + i);
            addLook(run, i, list, system, lookOf(looks.second), column, lowest + i);
        }
    }
}

// ---- all of a run ----

// Adds the tiles and free waves that are shaped in this block.
void addAllShaped(inout Run run, swSliceList list, uint column, uint lowest)
{
    Ground grounds[SW_SHAPED_RUN];
    Flow flows[SW_SHAPED_RUN];
    Shape weights[SW_SHAPED_RUN], shapes[SW_SHAPED_RUN];
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        grounds[i] = groundOf(column, lowest + i);
        weights[i] = Shape(1.0, vec2(0.0));
        flows[i] = STILL;
        if (doesCarry())
        {
            flows[i] = flowAt(column, lowest + i);
        }
    }
    uint system = ~0u; // that `weights` are of
    uint tileCount = list.count + list.windowCount;
    for (uint k = 0; k < tileCount + (WITH_WAVES ? list.waveCount : 0); ++k)
    {
        bool isTile = k < tileCount;
        swSliceTile tile = tiles[list.first + min(k, tileCount - 1)];
        swSliceWave wave = waves[list.firstWave + (isTile ? 0 : k - tileCount)];
        uint its = isTile ? tile.system : wave.system;
        float number = isTile ? tile.waveNumber : wave.waveNumber;
        swAttenuation attenuation = isTile ? tile.attenuation : wave.attenuation;
        if (!isShapedIn(fieldBlock, its, number, attenuation))
        {
            continue;
        }
        for (uint i = 0; i < SW_SHAPED_RUN; ++i)
        {
            if (WITH_WEIGHTS && its != system)
            {
                weights[i] = weightOf(its, column, lowest + i);
            }
            shapes[i] = attenuated(weights[i], grounds[i], number, attenuation);
        }
        system = its;
        if (doesCarry() && isTile && tile.carryPeriod > 0.0)
        {
            for (uint i = 0; i < SW_SHAPED_RUN; ++i)
            {
                addCarriedTile(run, tile, column, lowest + i, i, flows[i], shapes[i]);
            }
        }
        else if (doesCarry() && !isTile)
        {
            uint first = k - tileCount;
            for (uint i = 0; i < SW_SHAPED_RUN; ++i)
            {
                addCarriedWaves(run, list.firstWave + first, list.firstWave + wave.groupEnd, column, lowest + i, i,
                                flows[i], shapes[i]);
            }
            k += wave.groupEnd - first - 1;
        }
        else if (isTile)
        {
            addShapedTile(run, tile, column, lowest, shapes);
        }
        else if (WITH_WAVES)
        {
            addShapedWave(run, wave, column, lowest, shapes);
        }
    }
}

void storeShaped(uint column, uint row, Texel texel)
{
    uint at = (gl_WorkGroupID.z * resolution + row) * resolution + column;
    shaped[at] = vec4(texel.sum, texel.alongX.x);
    shaped[at + gl_NumWorkGroups.z * resolution * resolution] = vec4(texel.alongX.yz, texel.alongZ);
}

Texel texelOfRun(Run run, uint i)
{
    if (i < 2)
    {
        return i == 0 ? run.a : run.b;
    }
    return i == 2 ? run.c : run.d;
}

// Once inputs have joined that displace the water.
Texel displacedTexel(Texel texel, float least, uint column, uint row)
{
    swInputValue waves =
        swInputValue(vec4(texel.sum, 0.0), vec4(texel.alongX, 0.0), vec4(texel.alongX.z, texel.alongZ, 0.0));
    waves = displacedWater(placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, row), swDisplaceRange(least, 0.0, 0.0),
                           waves);
    return Texel(waves.value.xyz, waves.alongX.xyz, waves.alongZ.yz);
}

void main()
{
    uint column = gl_GlobalInvocationID.x;
    uint lowest = gl_WorkGroupID.y * SW_SHAPED_RUN;
    uint blockRow = lowest / SW_SLICE_HEIGHT;
    fieldBlock =
        blocks[(gl_WorkGroupID.z * (resolution / SW_SLICE_HEIGHT) + blockRow) * gl_NumWorkGroups.x + gl_WorkGroupID.x];
    if (!isTouched(fieldBlock) || column >= resolution)
    {
        return;
    }
    Run run = Run(CALM, CALM, CALM, CALM);
    addAllShaped(run, lists[gl_WorkGroupID.z], column, lowest);
    if (ribbonSystemsOfBlock() != 0)
    {
        addRibbons(run, lists[gl_WorkGroupID.z], column, lowest);
    }
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        Texel texel = texelOfRun(run, i);
        if (WITH_DISPLACEMENT && (fieldBlock.flags & SW_BLOCK_DISPLACED) != 0)
        {
            texel = displacedTexel(texel, lists[gl_WorkGroupID.z].minWavelength, column, lowest + i);
        }
        storeShaped(column, lowest + i, texel);
    }
}
