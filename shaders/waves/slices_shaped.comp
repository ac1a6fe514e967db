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
#include "lib/slice_waves.glsl"
#include "lib/slice_cubics.glsl"

// A part of the slice's tiles.
shared swSliceTile blockTiles[SW_SHAPED_TILES];
// Cubics of columns of a batch of them, x, y and z of each.
shared vec4 laidOut[3 * SW_SHAPED_COLUMNS];

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
    vec3 weight = firstOf(fieldAt(SW_FIELD_OF_WAVES, system, placeOfTexel(fieldSlices[gl_WorkGroupID.z], column, row)));
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

// Whether a place leaves anything of waves, in a run.
bool isAnything(Shape shapes[SW_SHAPED_RUN])
{
    bool isAny = false;
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        isAny = isAny || shapes[i].weight != 0.0 || shapes[i].slope != vec2(0.0);
    }
    return isAny;
}

// ---- tiles ----

uint lowestRow()
{
    return gl_WorkGroupID.y * SW_SHAPED_RUN;
}

bool isShapedTile(uint b)
{
    return isShapedIn(fieldBlock, blockTiles[b].system, blockTiles[b].waveNumber, blockTiles[b].attenuation);
}

// The cubic of a column of a tile in one of the cells that the run touches, by texels from the run's first row.
void placeCubic(swSliceTile tile, uint column, uint cell, uint to)
{
    float s = splineZ(tile, lowestRow());
    float first = floor(s) + float(cell);
    uint x = (tile.base & 0xffffu) + uint(firstOfBlock(tile)) + column;
    uint z = (tile.base >> 16) + uint(first);
    vec3 a = texelOf(tile, x, z), b = texelOf(tile, x, z + 1);
    vec3 c = texelOf(tile, x, z + 2), d = texelOf(tile, x, z + 3);
    mat4 pieces = cubicPieces(s - first, tile.step);
    laidOut[to] = pieces * vec4(a.x, b.x, c.x, d.x);
    laidOut[SW_SHAPED_COLUMNS + to] = pieces * vec4(a.y, b.y, c.y, d.y);
    laidOut[2 * SW_SHAPED_COLUMNS + to] = pieces * vec4(a.z, b.z, c.z, d.z);
}

// Lays out the shaped ones of tiles [first, end), each cubic by a thread.
void placeCubics(uint first, uint end)
{
    uint count = blockTiles[first].firstShaped + blockTiles[first].shapedCells * blockTiles[first].columnCount;
    for (uint i = gl_LocalInvocationIndex; i < count; i += SW_SLICE_WIDTH)
    {
        uint b = end - 1; // places begin with the last
        while (b > first && i >= blockTiles[b - 1].firstShaped)
        {
            b -= 1;
        }
        uint at = i - blockTiles[b].firstShaped;
        if (isShapedTile(b))
        {
            placeCubic(blockTiles[b], at % blockTiles[b].columnCount, at / blockTiles[b].columnCount, i);
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

void addLaidOut(inout Cubic cubic, uint at, float value, float slope)
{
    addColumn(cubic, laidOut[at], laidOut[SW_SHAPED_COLUMNS + at], laidOut[2 * SW_SHAPED_COLUMNS + at], value, slope);
}

// Adds a tile that is laid out to the texels of a run.
void addShapedTile(inout Run run, swSliceTile tile, uint column, float texelsPerMetre, Shape shapes[SW_SHAPED_RUN])
{
    Window window = makeWindow(tile, column);
    float origin = floor(splineZ(tile, lowestRow()));
    float last = -1.0;
    Cubic cubic = FLAT;
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        float cell = floor(splineZ(tile, lowestRow() + i)) - origin;
        if (cell != last)
        {
            uint at = tile.firstShaped + uint(cell) * tile.columnCount + window.first;
            cubic = FLAT;
            addLaidOut(cubic, at, window.value.x, window.slope.x);
            addLaidOut(cubic, at + 1, window.value.y, window.slope.y);
            addLaidOut(cubic, at + 2, window.value.z, window.slope.z);
            addLaidOut(cubic, at + 3, window.value.w, window.slope.w);
            last = cell;
        }
        addToRun(run, i, evaluateCubic(cubic, float(i), texelsPerMetre), shapes[i]);
    }
}

// Adds a tile of which a block has too many columns.
void addShapedWindow(inout Run run, swSliceTile tile, uint column, Shape shapes[SW_SHAPED_RUN])
{
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        Texel own = CALM;
        addWindow(own, tile, column, lowestRow() + i);
        addToRun(run, i, own, shapes[i]);
    }
}

// ---- free waves ----

void addShapedWave(inout Run run, swSliceWave wave, uint column, Shape shapes[SW_SHAPED_RUN])
{
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        Texel own = CALM;
        addWave(own, wave, swingOf(wave, column, lowestRow() + i));
        addToRun(run, i, own, shapes[i]);
    }
}

// ---- all of a run ----

// What a place does to a run of texels of a column.
struct RunPlaces
{
    Ground grounds[SW_SHAPED_RUN];
    Shape weights[SW_SHAPED_RUN]; // of the system asked last
    uint system;
};

RunPlaces placesOf(uint column)
{
    RunPlaces places;
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        places.grounds[i] = groundOf(column, lowestRow() + i);
        places.weights[i] = Shape(1.0, vec2(0.0));
    }
    places.system = ~0u;
    return places;
}

// How waves of a system, of wave number k, are shaped in a run.
Shape[SW_SHAPED_RUN] shapesOf(inout RunPlaces places, uint column, uint system, float k, swAttenuation attenuation)
{
    Shape shapes[SW_SHAPED_RUN];
    for (uint i = 0; i < SW_SHAPED_RUN; ++i)
    {
        if (WITH_WEIGHTS && system != places.system)
        {
            places.weights[i] = weightOf(system, column, lowestRow() + i);
        }
        shapes[i] = attenuated(places.weights[i], places.grounds[i], k, attenuation);
    }
    places.system = system;
    return shapes;
}

// Adds the shaped ones of tiles [first, end), which are laid out together.
void addTiles(inout Run run, inout RunPlaces places, uint first, uint end, uint column, float texelsPerMetre)
{
    for (uint b = first; b < end; ++b)
    {
        if (!isShapedTile(b))
        {
            continue;
        }
        swSliceTile tile = blockTiles[b];
        Shape shapes[SW_SHAPED_RUN] = shapesOf(places, column, tile.system, tile.waveNumber, tile.attenuation);
        if (!isAnything(shapes))
        {
            continue;
        }
        if (tile.shapedCells > 0)
        {
            addShapedTile(run, tile, column, texelsPerMetre, shapes);
        }
        else
        {
            addShapedWindow(run, tile, column, shapes);
        }
    }
}

// Adds the tiles and free waves that are shaped in this block.
void addAllShaped(inout Run run, swSliceList list, uint column)
{
    RunPlaces places = placesOf(column);
    uint count = list.count + list.windowCount;
    for (uint part = (count + SW_SHAPED_TILES - 1) / SW_SHAPED_TILES; part-- > 0;)
    {
        uint first = part * SW_SHAPED_TILES, last = min(first + SW_SHAPED_TILES, count) - first;
        barrier(); // nobody reads the part before
        if (gl_LocalInvocationIndex < last)
        {
            blockTiles[gl_LocalInvocationIndex] = tiles[list.first + first + gl_LocalInvocationIndex];
        }
        barrier();
        for (uint end = last, begin; end > 0; end = begin)
        {
            begin = blockTiles[end - 1].shapedBegin - first;
            if (isAnyShaped(begin, end))
            {
                placeCubics(begin, end);
                barrier();
                addTiles(run, places, begin, end, column, list.texelsPerMetre);
                barrier(); // nobody reads what was laid out
            }
        }
    }
    for (uint k = 0; WITH_WAVES && k < list.waveCount; ++k)
    {
        swSliceWave wave = waves[list.firstWave + k];
        if (isShapedIn(fieldBlock, wave.system, wave.waveNumber, wave.attenuation))
        {
            addShapedWave(run, wave, column, shapesOf(places, column, wave.system, wave.waveNumber, wave.attenuation));
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
    uint lowest = lowestRow();
    uint blockRow = lowest / SW_SLICE_HEIGHT;
    fieldBlock =
        blocks[(gl_WorkGroupID.z * (resolution / SW_SLICE_HEIGHT) + blockRow) * gl_NumWorkGroups.x + gl_WorkGroupID.x];
    if (!isTouched(fieldBlock))
    {
        return;
    }
    Run run = Run(CALM, CALM, CALM, CALM);
    addAllShaped(run, lists[gl_WorkGroupID.z], column);
    if (column < resolution)
    {
        storeShaped(column, lowest, run.a);
        storeShaped(column, lowest + 1, run.b);
        storeShaped(column, lowest + 2, run.c);
        storeShaped(column, lowest + 3, run.d);
    }
}
