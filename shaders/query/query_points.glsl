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
        Place place = placeOfBits(uvec2(points[at], points[at + params.source.pointWords - 1]));
        place.isBad =
            place.isBad || !isNumber(points[at + params.source.pointWords - 2], SW_QUERY_HIGHEST); // y of three
        return place;
    }
    ivec2 cell = ivec2(points[at + 2], points[at + 3]);
    return Place(cell, uintBitsToFloat(uvec2(points[at], points[at + 1])), cell.x == SW_QUERY_NOWHERE);
}
