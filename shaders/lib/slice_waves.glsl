// SPDX-License-Identifier: MIT
// Waves at a texel of a slice, for the passes that add them up: slices.comp where they are the same everywhere, and
// slices_shaped.comp where their place shapes them.
//
// Before including: the buffers `swSliceTile tiles[]`, `vec4 texels[]` and `swSliceWave waves[]`.
#ifndef SW_LIB_SLICE_WAVES
#define SW_LIB_SLICE_WAVES
#include "lib/turns.glsl"
#include "shared/fields.h"
#include "shared/spline.h"
#include "shared/waves.h"

// What is known of a texel: displacement, and its slopes; along z those of y and z only.
struct Texel
{
    vec3 sum;
    vec3 alongX;
    vec2 alongZ;
};

const Texel CALM = Texel(vec3(0.0), vec3(0.0), vec2(0.0));

void addTexel(inout Texel texel, Texel other)
{
    texel.sum += other.sum;
    texel.alongX += other.alongX;
    texel.alongZ += other.alongZ;
}

// ---- who adds what ----

// Whether waves of a system, of wave number k, are shaped anywhere in a block. Inputs that displace the water do so to
// the sum of all waves, so where there are any, all are.
bool isShapedIn(swFieldBlock block, uint system, float k, swAttenuation attenuation)
{
    return block.flags != 0 || !swIsDeepFor(attenuation, k, block.leastDepth) ||
           (block.systems >> (system & 31u) & 1u) != 0;
}

// Whether any waves are: the block's longest may feel its depth.
bool isTouched(swFieldBlock block)
{
    return block.leastDepth < SW_NO_DEPTH || block.systems != 0 || block.flags != 0;
}

// ---- tiles ----

// Spline coordinates. The same bits wherever they are asked for: cells and weights must not disagree.
float splineX(swSliceTile tile, uint column)
{
    return fma(float(column), tile.step, tile.fractionX);
}

float splineZ(swSliceTile tile, uint row)
{
    return fma(float(row), tile.step, tile.fractionZ);
}

// A coefficient of a tile, or of two that lie alike and are added as one.
vec3 texelOf(swSliceTile tile, uint column, uint row)
{
    uint mask = tile.resolution - 1;
    uint at = (column & mask) + (row & mask) * (tile.resolution + 3);
    vec3 texel = texels[tile.firstTexel + at].xyz;
    if (tile.secondTexel != SW_NO_TEXEL)
    {
        texel += texels[tile.secondTexel + at].xyz;
    }
    return texel;
}

// Interpolated along an axis.
vec3 weigh(vec4 weights, vec3 a, vec3 b, vec3 c, vec3 d)
{
    return fma(vec3(weights.w), d, fma(vec3(weights.z), c, fma(vec3(weights.y), b, weights.x * a)));
}

// Adds a tile to one texel, from all sixteen coefficients from one on, and the fractions that it lies beyond that.
void addCoefficients(inout Texel texel, swSliceTile tile, uint firstX, uint firstZ, float x, float z)
{
    vec4 valueX = swSplineWeights(x), slopeX = swSplineSlopes(x) * tile.perMetre;
    vec4 valueZ = swSplineWeights(z), slopeZ = swSplineSlopes(z) * tile.perMetre;
    for (uint k = 0; k < 4; ++k)
    {
        vec3 a = texelOf(tile, firstX, firstZ + k), b = texelOf(tile, firstX + 1, firstZ + k);
        vec3 c = texelOf(tile, firstX + 2, firstZ + k), d = texelOf(tile, firstX + 3, firstZ + k);
        vec3 value = weigh(valueX, a, b, c, d);
        texel.sum = fma(vec3(valueZ[k]), value, texel.sum);
        texel.alongX = fma(vec3(valueZ[k]), weigh(slopeX, a, b, c, d), texel.alongX);
        texel.alongZ = fma(vec2(slopeZ[k]), value.yz, texel.alongZ);
    }
}

// Adds a tile at spline coordinates.
void addWindowAt(inout Texel texel, swSliceTile tile, float x, float z)
{
    float cellX = floor(x), cellZ = floor(z);
    addCoefficients(texel, tile, (tile.base & 0xffffu) + uint(int(cellX)), (tile.base >> 16) + uint(int(cellZ)),
                    x - cellX, z - cellZ);
}

// Adds a tile to one texel.
void addWindow(inout Texel texel, swSliceTile tile, uint column, uint row)
{
    addWindowAt(texel, tile, splineX(tile, column), splineZ(tile, row));
}

// ---- free waves ----

uint phaseOfTexel(swSliceWave wave, uint column, uint row)
{
    return wave.phase + column * wave.stepX + row * wave.stepZ;
}

// A free wave's amplitude times cosine and sine of its phase.
vec2 swingOf(swSliceWave wave, uint column, uint row)
{
    return wave.amplitude * unitOf(phaseOfTexel(wave, column, row));
}

// Adds a free wave, `unit` its swing there.
void addWave(inout Texel texel, swSliceWave wave, vec2 unit)
{
    vec3 rate = vec3(wave.dx * unit.x, unit.y, wave.dz * unit.x);
    texel.sum -= vec3(wave.dx * unit.y, -unit.x, wave.dz * unit.y);
    texel.alongX = fma(vec3(-wave.kx), rate, texel.alongX);
    texel.alongZ = fma(vec2(-wave.kz), rate.yz, texel.alongZ);
}

// ---- waves of any other place ----

// How far a place is from the slice's first texel, in cells of SW_QUERY_CELL and metres.
struct Way
{
    ivec2 cells;
    vec2 metres;
};

// Of a tile along an axis: the fraction of 2^32 of a turn. `base` and `fraction` are those of the first texel.
uint turnsInTile(swSliceTile tile, uint base, float fraction, int cells, float metres)
{
    int bits = 32 - findMSB(tile.resolution);
    return (base << bits) + uint(fraction * exp2(float(bits))) + uint(cells) * tile.cellTurns +
           toTurns(metres * tile.perMetre / float(tile.resolution));
}

void addTileAt(inout Texel texel, swSliceTile tile, Way way)
{
    int bits = findMSB(tile.resolution);
    uint x = turnsInTile(tile, tile.base & 0xffffu, tile.fractionX, way.cells.x, way.metres.x);
    uint z = turnsInTile(tile, tile.base >> 16, tile.fractionZ, way.cells.y, way.metres.y);
    addCoefficients(texel, tile, x >> (32 - bits), z >> (32 - bits), float((x << bits) >> 8) * (1.0 / 16777216.0),
                    float((z << bits) >> 8) * (1.0 / 16777216.0));
}

void addWaveAt(inout Texel texel, swSliceWave wave, Way way)
{
    vec2 turns = vec2(wave.kx, wave.kz) * way.metres * (1.0 / 6.28318530718);
    uint phase = wave.phase + uint(way.cells.x) * wave.cellTurnsX + uint(way.cells.y) * wave.cellTurnsZ +
                 toTurns(turns.x + turns.y);
    addWave(texel, wave, wave.amplitude * unitOf(phase));
}
#endif
