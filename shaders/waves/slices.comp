// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Displacement and its derivatives at every texel of every slice of a view: the sum over the slice's tiles of their
// cubic B-splines, with exact weights (a texture unit's have 8 bits, which would be millimetres wrong), and of its free
// waves.
//
// The axes of slices and tiles are parallel, so the spline is separable over the whole slice: all texels of a column
// share their weights along x, all texels of a row their weights along z. A thread owns a column of SW_SLICE_HEIGHT
// texels. Columns lie side by side, a workgroup's make a block, so a tile's knots along z lie between the same two rows
// of texels for the whole block.
//
// Along z the sum of all tiles is one cubic from knot to knot. Each tile's columns are turned into cubics once for the
// block, in shared memory, together with what changes at each knot: only the third derivative does, by the fourth
// difference of the tile's coefficients. A thread weighs four columns of each tile along x (value and slope), which
// gives the cubic of its middle texel; then it goes along its column, takes in a knot where one is passed, and
// evaluates the cubic at each texel. A tile costs 12 bytes of shared memory a texel, whatever its resolution, and a
// little more at each of its knots. It is exact, not an approximation.
//
// Tiles that have more than three samples in four texels would have too many knots. They are added texel by texel, and
// so are free waves, with their phases in integers: four texels at a time, each by turning the sine and cosine of the
// one before on. Pipelines of views that have neither are compiled without (WITH_OTHERS).
//
// Where waves differ from place to place (WITH_PLACES), slices_shaped.comp has added up those that are shaped somewhere
// in the block. The others are added here as above, so that over a floor of 20 m only waves of more than 40 m are not.
//
// What decides is how many blocks run at once, and the length of the code. A compiler gives a thread as many registers
// as shared memory leaves it, whatever would fit. Slower on an H100 than what is here (33.6 us): columns of eight
// texels (40.7), texels that change places, so that stores fill whole pieces of images (36.4; stores alone take 10 us
// in two rows of sixteen and 21 in rows of thirty-two, but each pair of rows needs barriers), steps written out twice
// (30 KB of code), blocks of 64, 192 and 384 columns, and cubics and knots laid out one after the other in the same
// memory.

#include "shared/fields.h"
#include "shared/spline.h"
#include "shared/surface_normal.h"
#include "shared/waves.h"

layout(local_size_x = SW_SLICE_WIDTH) in;
layout(constant_id = 0) const bool WITH_OTHERS = true;  // tiles added texel by texel, and free waves
layout(constant_id = 1) const bool WITH_PLACES = false; // waves differ from place to place

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
layout(binding = 3, rgba32f) uniform writeonly image2DArray displacement;
layout(binding = 4, rgba16f) uniform writeonly image2DArray derivatives;
layout(std430, binding = 5) readonly buffer Waves
{
    swSliceWave waves[];
};
layout(std430, binding = 6) readonly buffer Blocks
{
    swFieldBlock blocks[];
};
// See slices_shaped.comp.
layout(std430, binding = 7) readonly buffer Shaped
{
    vec4 shaped[];
};
layout(push_constant) uniform Push
{
    uint resolution;
};

#include "lib/slice_waves.glsl"
#include "lib/slice_cubics.glsl"

// The slice's tiles that are added as cubics.
shared swSliceTile blockTiles[SW_SLICE_TILES];
// Columns of a batch of tiles: x, y and z of each, as cubics along z in powers of texels from the block's middle row.
shared vec4 laidOut[3 * SW_SLICE_COLUMNS];
// By how much the coefficient of the third power changes at the knots of each column of all tiles; x, then y, then z.
shared float jumps[3 * SW_SLICE_JUMPS];
// Bit b of a row: tile b has a knot between the row before and this one.
shared uint knotTiles[SW_SLICE_HEIGHT];

// What shapes waves in this block.
swFieldBlock fieldBlock = swFieldBlock(SW_NO_DEPTH, 0, 0, SW_NO_DEPTH, 0);

// Whether waves are added by slices_shaped.comp.
bool isShaped(uint system, float k, swAttenuation attenuation)
{
    return WITH_PLACES && isShapedIn(fieldBlock, system, k, attenuation);
}

bool isShapedTile(uint b)
{
    return isShaped(blockTiles[b].system, blockTiles[b].waveNumber, blockTiles[b].attenuation);
}

float splineOfRow(swSliceTile tile, uint row)
{
    return splineZ(tile, gl_WorkGroupID.y * SW_SLICE_HEIGHT + row);
}

// Rows are made from the middle to the end, then from the middle back to the beginning: step by step a cubic loses
// digits with the third power of the way. Of the group of steps that begins with one: the rows between which its knots
// lie.
const uint MIDDLE = SW_SLICE_HEIGHT / 2;

uvec2 rowsOfGroup(swSliceList list, uint step)
{
    if (list.groupRows == SW_SLICE_HEIGHT)
    {
        return uvec2(0, SW_SLICE_HEIGHT - 1);
    }
    return step < MIDDLE ? MIDDLE - 1 + uvec2(max(step, 1u), step + list.groupRows)
                         : SW_SLICE_HEIGHT - step - uvec2(list.groupRows, 0);
}

// Laying out tiles ---------------------------------------------------------------------------------------------------

// Lays out by how much the coefficient of the third power changes at a knot, from the five coefficients around it.
void placeJump(uint at, vec3 a, vec3 b, vec3 c, vec3 d, vec3 e, float cube)
{
    vec3 jump = (a + e - 4.0 * (b + d) + 6.0 * c) * cube;
    jumps[at] = jump.x;
    jumps[SW_SLICE_JUMPS + at] = jump.y;
    jumps[2 * SW_SLICE_JUMPS + at] = jump.z;
}

// The cubic of a column of a tile, at the block's middle.
void placeCubic(swSliceTile tile, uint column, uint at)
{
    float s = splineOfRow(tile, MIDDLE);
    float cell = floor(s);
    uint row = (tile.base >> 16) + uint(cell);
    vec3 a = texelOf(tile, at, row), b = texelOf(tile, at, row + 1);
    vec3 c = texelOf(tile, at, row + 2), d = texelOf(tile, at, row + 3);
    mat4 pieces = cubicPieces(s - cell, tile.step);
    laidOut[tile.firstColumn + column] = pieces * vec4(a.x, b.x, c.x, d.x);
    laidOut[SW_SLICE_COLUMNS + tile.firstColumn + column] = pieces * vec4(a.y, b.y, c.y, d.y);
    laidOut[2 * SW_SLICE_COLUMNS + tile.firstColumn + column] = pieces * vec4(a.z, b.z, c.z, d.z);
}

// Lays out a column of a tile: its cubic if it is the first time, and what changes at its knots between two rows.
void placeColumn(swSliceTile tile, uint column, bool isFirst, uvec2 rows)
{
    float cell = floor(splineOfRow(tile, rows.x));
    uint row = (tile.base >> 16) + uint(cell);
    uint at = (tile.base & 0xffffu) + uint(firstOfBlock(tile)) + column;
    if (isFirst)
    {
        placeCubic(tile, column, at);
    }
    vec3 a = texelOf(tile, at, row), b = texelOf(tile, at, row + 1);
    vec3 c = texelOf(tile, at, row + 2), d = texelOf(tile, at, row + 3);
    uint knotCount = uint(floor(splineOfRow(tile, rows.y)) - cell);
    uint to = tile.firstJump + column;
    float cube = tile.step * tile.step * tile.step * (1.0 / 6.0);
    for (uint k = 0; k < knotCount; k += 3) // three loads at a time
    {
        vec3 e = texelOf(tile, at, row + k + 4), f = texelOf(tile, at, row + k + 5), g = texelOf(tile, at, row + k + 6);
        placeJump(to, a, b, c, d, e, cube);
        if (k + 1 < knotCount)
        {
            placeJump(to + tile.columnCount, b, c, d, e, f, cube);
        }
        if (k + 2 < knotCount)
        {
            placeJump(to + 2 * tile.columnCount, c, d, e, f, g, cube);
        }
        a = d;
        b = e;
        c = f;
        d = g;
        to += 3 * tile.columnCount;
    }
}

// Lays out the columns of tiles [first, end), each by a thread.
void placeColumns(uint first, uint end, bool isFirst, uvec2 rows)
{
    uint begin = blockTiles[first].firstOfAll;
    uint columnCount = blockTiles[end - 1].firstOfAll + blockTiles[end - 1].columnCount - begin;
    for (uint i = gl_LocalInvocationIndex; i < columnCount; i += SW_SLICE_WIDTH)
    {
        uint b = first;
        for (uint next = first + 1; next < end; ++next)
        {
            b += begin + i >= blockTiles[next].firstOfAll ? 1 : 0;
        }
        if (!isShapedTile(b))
        {
            placeColumn(blockTiles[b], begin + i - blockTiles[b].firstOfAll, isFirst, rows);
        }
    }
}

void prepareTiles(swSliceList list)
{
    uint thread = gl_LocalInvocationIndex;
    if (thread < list.count)
    {
        blockTiles[thread] = tiles[list.first + thread];
    }
    if (thread < SW_SLICE_HEIGHT)
    {
        knotTiles[thread] = 0;
    }
    barrier();
    for (uint i = thread; i < list.count * SW_SLICE_HEIGHT; i += SW_SLICE_WIDTH)
    {
        uint b = i / SW_SLICE_HEIGHT, row = i % SW_SLICE_HEIGHT;
        if (row > 0 && !isShapedTile(b) &&
            floor(splineOfRow(blockTiles[b], row)) != floor(splineOfRow(blockTiles[b], row - 1)))
        {
            atomicOr(knotTiles[row], 1u << b);
        }
    }
}

// A column of texels -------------------------------------------------------------------------------------------------

void addCubic(inout Cubic cubic, vec4 piece, vec3 value, vec3 slope)
{
    cubic.x = fma(piece, vec4(value.x), cubic.x);
    cubic.y = fma(piece, vec4(value.y), cubic.y);
    cubic.z = fma(piece, vec4(value.z), cubic.z);
    cubic.slopeX = fma(piece, vec4(slope.x), cubic.slopeX);
    cubic.slopeY = fma(piece, vec4(slope.y), cubic.slopeY);
    cubic.slopeZ = fma(piece, vec4(slope.z), cubic.slopeZ);
}

void addLaidOut(inout Cubic cubic, uint at, float value, float slope)
{
    addColumn(cubic, laidOut[at], laidOut[SW_SLICE_COLUMNS + at], laidOut[2 * SW_SLICE_COLUMNS + at], value, slope);
}

// Adds a tile to a column's cubic.
void addTile(inout Cubic cubic, swSliceTile tile, uint column)
{
    Window window = makeWindow(tile, column);
    uint at = tile.firstColumn + window.first;
    addLaidOut(cubic, at, window.value.x, window.slope.x);
    addLaidOut(cubic, at + 1, window.value.y, window.slope.y);
    addLaidOut(cubic, at + 2, window.value.z, window.slope.z);
    addLaidOut(cubic, at + 3, window.value.w, window.slope.w);
}

vec3 readJump(uint at)
{
    return vec3(jumps[at], jumps[SW_SLICE_JUMPS + at], jumps[2 * SW_SLICE_JUMPS + at]);
}

// Takes in the knots between a row and the one before, or leaves them behind (`sign` -1). `origin` is the row from
// which those laid out are counted.
void addKnots(inout Cubic cubic, uint row, uint origin, float sign, uint column)
{
    for (uint bits = knotTiles[row]; bits != 0; bits &= bits - 1)
    {
        swSliceTile tile = blockTiles[findLSB(bits)];
        float cell = floor(splineOfRow(tile, row));
        uint knot = uint(cell - floor(splineOfRow(tile, origin))) - 1;
        float t = (cell - splineOfRow(tile, MIDDLE)) * tile.texelsPerUnit;
        Window window = makeWindow(tile, column);
        uint at = tile.firstJump + knot * tile.columnCount + window.first;
        vec3 a = readJump(at), b = readJump(at + 1), c = readJump(at + 2), d = readJump(at + 3);
        addCubic(cubic, sign * vec4(-t * t * t, 3.0 * t * t, -3.0 * t, 1.0), weigh(window.value, a, b, c, d),
                 weigh(window.slope, a, b, c, d));
    }
}

// Texels -------------------------------------------------------------------------------------------------------------

// Columns beyond a narrow slice's edge store nothing: Vulkan drops what is outside an image.
void storeTexel(ivec3 at, Texel texel)
{
    float jacobian = swSurfaceJacobian(texel.alongX.x, texel.alongX.z, texel.alongZ.y);
    float gx = swSurfaceNormalX(texel.alongX.z, texel.alongZ.y, texel.alongX.y, texel.alongZ.x);
    float gz = swSurfaceNormalZ(texel.alongX.x, texel.alongX.z, texel.alongX.y, texel.alongZ.x);
    imageStore(displacement, at, vec4(texel.sum, jacobian));
    imageStore(derivatives, at, vec4(gx, gz, jacobian, 0.0));
}

// Four texels that follow each other. They have names, not indices: an array that is indexed would leave the registers.
struct Run
{
    Texel a, b, c, d;
};

vec2 turnOn(vec2 unit, vec2 turn)
{
    return vec2(unit.x * turn.x - unit.y * turn.y, unit.x * turn.y + unit.y * turn.x);
}

// The free waves of a run that begins at a row and goes on or back.
Run sumWaves(swSliceList list, uint column, uint row, bool isBack)
{
    Run run = Run(CALM, CALM, CALM, CALM);
    for (uint i = 0; i < list.waveCount; ++i)
    {
        swSliceWave wave = waves[list.firstWave + i];
        if (isShaped(wave.system, wave.waveNumber, wave.attenuation))
        {
            continue;
        }
        vec2 turn = vec2(wave.cosZ, isBack ? -wave.sinZ : wave.sinZ);
        vec2 unit = swingOf(wave, column, gl_WorkGroupID.y * SW_SLICE_HEIGHT + row);
        addWave(run.a, wave, unit);
        unit = turnOn(unit, turn);
        addWave(run.b, wave, unit);
        unit = turnOn(unit, turn);
        addWave(run.c, wave, unit);
        unit = turnOn(unit, turn);
        addWave(run.d, wave, unit);
    }
    return run;
}

// Tiles that are no cubics, and the free waves of texel `i` of a run.
void addOthers(inout Texel texel, swSliceList list, uint column, uint row, Run run, uint i)
{
    for (uint k = list.count; k < list.count + list.windowCount; ++k)
    {
        swSliceTile tile = tiles[list.first + k];
        if (!isShaped(tile.system, tile.waveNumber, tile.attenuation))
        {
            addWindow(texel, tile, column, gl_WorkGroupID.y * SW_SLICE_HEIGHT + row);
        }
    }
    if (i < 2)
    {
        addTexel(texel, i == 0 ? run.a : run.b);
    }
    else
    {
        addTexel(texel, i == 2 ? run.c : run.d);
    }
}

// What slices_shaped.comp has added up.
Texel shapedAt(uint column, uint row)
{
    uint at = (gl_WorkGroupID.z * resolution + row) * resolution + column;
    vec4 a = shaped[at], b = shaped[at + gl_NumWorkGroups.z * resolution * resolution];
    return Texel(a.xyz, vec3(a.w, b.xy), b.zw);
}

void main()
{
    uint column = gl_GlobalInvocationID.x;
    swSliceList list = lists[gl_WorkGroupID.z];
    if (WITH_PLACES)
    {
        uint block = (gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y) * gl_NumWorkGroups.x + gl_WorkGroupID.x;
        fieldBlock = blocks[block];
    }
    prepareTiles(list);
    Cubic middle = FLAT;
    Cubic cubic = FLAT;
    Run run = Run(CALM, CALM, CALM, CALM);
    for (uint group = 0; group < SW_SLICE_HEIGHT; group += list.groupRows)
    {
        uvec2 rows = rowsOfGroup(list, group);
        for (uint first = 0; first < list.count; first = blockTiles[first].batchEnd)
        {
            uint end = blockTiles[first].batchEnd;
            barrier(); // nobody reads what was laid out
            placeColumns(first, end, group == 0, rows);
            barrier();
            for (uint b = group == 0 ? first : end; b < end; ++b)
            {
                if (!isShapedTile(b))
                {
                    addTile(middle, blockTiles[b], column);
                }
            }
        }
        for (uint i = group; i < group + list.groupRows; ++i)
        {
            bool isBack = i >= MIDDLE;
            uint row = isBack ? SW_SLICE_HEIGHT - 1 - i : MIDDLE + i;
            if (i == 0 || i == MIDDLE)
            {
                cubic = middle;
            }
            if (i > 0)
            {
                addKnots(cubic, isBack ? row + 1 : row, rows.x, isBack ? -1.0 : 1.0, column);
            }
            Texel texel = evaluateCubic(cubic, float(row) - float(MIDDLE), list.texelsPerMetre);
            if (WITH_OTHERS && i % 4 == 0)
            {
                run = sumWaves(list, column, row, isBack);
            }
            if (WITH_OTHERS)
            {
                addOthers(texel, list, column, row, run, i % 4);
            }
            uint z = gl_WorkGroupID.y * SW_SLICE_HEIGHT + row;
            if (WITH_PLACES && isTouched(fieldBlock) && column < resolution)
            {
                addTexel(texel, shapedAt(column, z));
            }
            storeTexel(ivec3(column, z, gl_WorkGroupID.z), texel);
        }
    }
}
