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
layout(constant_id = 0) const bool WITH_WAVES = true;   // free waves
layout(constant_id = 1) const bool WITH_WEIGHTS = true; // systems may have weights of their own there
layout(constant_id = 2) const bool WITH_RIBBONS = true; // some waves run along splines

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
layout(push_constant) uniform Push
{
    uint resolution;
};

#include "lib/inputs.glsl"
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

// ---- waves along splines ----

// Bits of the systems of which some waves run along splines in the block.
uint ribbonSystemsOfBlock()
{
    return WITH_RIBBONS ? fieldBlock.systems & inputHead.ribbonSystems : 0u;
}

Way wayTo(SeaPlace place)
{
    swFieldSlice slice = fieldSlices[gl_WorkGroupID.z];
    return Way(place.cell - ivec2(slice.cellX, slice.cellZ), place.rest - vec2(slice.restX, slice.restZ));
}

// Adds a system's tiles and free waves as they are seen by a look to a texel of the run.
void addLook(inout Run run, uint i, swSliceList list, uint system, Look look, Ground ground)
{
    Way way = wayTo(look.at);
    uint tileCount = list.count + list.windowCount;
    if (!isLookThere(look))
    {
        return;
    }
    for (uint k = 0; k < tileCount; ++k)
    {
        if (tiles[list.first + k].system == system)
        {
            swSliceTile tile = tiles[list.first + k];
            Texel own = CALM;
            addTileAt(own, tile, way);
            turnWaterByLook(look, look.source.way, own.sum, own.alongX, own.alongZ);
            addToRun(run, i, own, attenuated(look.shape, ground, tile.waveNumber, tile.attenuation));
        }
    }
    for (uint k = 0; k < (WITH_WAVES ? list.waveCount : 0); ++k)
    {
        if (waves[list.firstWave + k].system == system)
        {
            swSliceWave wave = waves[list.firstWave + k];
            Texel own = CALM;
            addWaveAt(own, wave, way);
            turnWaterByLook(look, look.source.way, own.sum, own.alongX, own.alongZ);
            addToRun(run, i, own, attenuated(look.shape, ground, wave.waveNumber, wave.attenuation));
        }
    }
}

// Adds waves along splines.
void addRibbons(inout Run run, swSliceList list, uint column, uint lowest)
{
    uint systems = 0;
    for (uint k = 0; k < list.count + list.windowCount; ++k)
    {
        systems |= 1u << tiles[list.first + k].system;
    }
    for (uint k = 0; k < (WITH_WAVES ? list.waveCount : 0); ++k)
    {
        systems |= 1u << waves[list.firstWave + k].system;
    }
    for (systems &= ribbonSystemsOfBlock(); systems != 0; systems &= systems - 1)
    {
        uint system = findLSB(systems);
        for (uint i = 0; i < SW_SHAPED_RUN; ++i)
        {
            SeaPlace place = placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, lowest + i);
            swRibbonLooks looks = looksAt(SW_FIELD_OF_WAVES, system, place).ribbons;
            addLook(run, i, list, system, lookOf(looks.first), groundOf(column, lowest + i));
            addLook(run, i, list, system, lookOf(looks.second), groundOf(column, lowest + i));
        }
    }
}

// ---- all of a run ----

// Adds the tiles and free waves that are shaped in this block.
void addAllShaped(inout Run run, swSliceList list, uint column, uint lowest)
{
    Ground grounds[SW_SHAPED_RUN];
    Shape weights[SW_SHAPED_RUN], shapes[SW_SHAPED_RUN];
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        grounds[i] = groundOf(column, lowest + i);
        weights[i] = Shape(1.0, vec2(0.0));
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
        if (isTile)
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
    storeShaped(column, lowest, run.a);
    storeShaped(column, lowest + 1, run.b);
    storeShaped(column, lowest + 2, run.c);
    storeShaped(column, lowest + 3, run.d);
}
