// SPDX-License-Identifier: MIT
// Where the points of a query are, and free waves there. See shared/query.h for cells.
//
// Before including: lib/turns.glsl.

struct Place
{
    ivec2 cell;
    vec2 rest;  // m from the cell's corner
    bool isBad; // NaN, infinite or too far out: the answers are NaN, and no other place's depend on it
};

// For what cannot be answered. Compilers may take it for granted that no number is NaN, so it is told by its bits.
float noNumber()
{
    return uintBitsToFloat(0x7fc00000u);
}

// Of the bits of a float: a number of at most `most`.
bool isNumber(uint bits, float most)
{
    return (bits & 0x7fffffffu) <= floatBitsToUint(most);
}

// Two numbers of floats, m from the origin.
Place placeOf(vec2 metres)
{
    vec2 cell = floor(metres / SW_QUERY_CELL);
    return Place(ivec2(cell), metres - cell * SW_QUERY_CELL, false);
}

// The same of bits that may be no numbers.
Place placeOfBits(uvec2 metres)
{
    bool isBad = !isNumber(metres.x, SW_QUERY_FARTHEST) || !isNumber(metres.y, SW_QUERY_FARTHEST);
    Place place = placeOf(isBad ? vec2(0.0) : uintBitsToFloat(metres));
    place.isBad = isBad;
    return place;
}

// Cosine and sine, times the amplitude.
vec2 swingOf(swQueryWave wave, ivec2 cell, vec2 rest)
{
    uint phase = wave.phase + uint(cell.x) * wave.cellTurnsX + uint(cell.y) * wave.cellTurnsZ +
                 toTurns(rest.x * wave.turnsX + rest.y * wave.turnsZ);
    return wave.amplitude * unitOf(phase);
}
