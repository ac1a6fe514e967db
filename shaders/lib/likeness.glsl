// SPDX-License-Identifier: MIT
// How alike the heights of a tile are a way apart: the twin of correlateTile() in core/surface/carry.c.
//
// Before including: the buffer `float likeness[]`, a number for each texel of the tiles.
#ifndef SW_LIB_LIKENESS
#define SW_LIB_LIKENESS
#include "shared/spline.h"

// Their correlation at a way, m, and its slopes by the way.
vec3 likenessOf(uint firstTexel, uint resolution, float texelsPerMetre, vec2 way)
{
    vec2 coordinate = way * texelsPerMetre;
    vec2 cell = floor(coordinate);
    vec2 t = coordinate - cell;
    uint mask = resolution - 1u;
    uint first = firstTexel + (uint(int(cell.x)) & mask);
    uint row = uint(int(cell.y));
    vec4 valueX = swSplineWeights(t.x), slopeX = swSplineSlopes(t.x) * texelsPerMetre;
    vec4 valueZ = swSplineWeights(t.y), slopeZ = swSplineSlopes(t.y) * texelsPerMetre;
    vec3 found = vec3(0.0);
    for (uint i = 0; i < 4; ++i)
    {
        uint at = first + ((row + i) & mask) * (resolution + 3u); // columns repeat, rows do not
        vec4 texel = vec4(likeness[at], likeness[at + 1], likeness[at + 2], likeness[at + 3]);
        float value = dot(valueX, texel);
        found += vec3(valueZ[i] * value, valueZ[i] * dot(slopeX, texel), slopeZ[i] * value);
    }
    return found;
}
#endif
