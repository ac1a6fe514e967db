// SPDX-License-Identifier: MIT
// The points that a query was asked.
//
// Before including: query_place.glsl, the buffer `uint points[]`, and `swQuerySource params.source`.

// Points are swQueryPoint, or floats.
Place readPlace(uint point)
{
    uint at = params.source.firstWord + point * params.source.pointWords;
    if (params.source.isFloatPoint != 0)
    {
        return placeOf(uintBitsToFloat(uvec2(points[at], points[at + params.source.pointWords - 1])));
    }
    return Place(ivec2(points[at + 2], points[at + 3]), uintBitsToFloat(uvec2(points[at], points[at + 1])));
}
