// SPDX-License-Identifier: MIT
// Where the points of a query are, and free waves there. See shared/query.h for cells.
//
// Before including: lib/turns.glsl.

struct Place
{
    ivec2 cell;
    vec2 rest; // m from the cell's corner
};

// Two numbers of floats, m from the origin.
Place placeOf(vec2 metres)
{
    vec2 cell = floor(metres / SW_QUERY_CELL);
    return Place(ivec2(cell), metres - cell * SW_QUERY_CELL);
}

// The nearest whole turn is taken off first, so that the integer cannot overflow.
uint toTurns(float turns)
{
    return uint(int((turns - round(turns)) * 2147483648.0)) << 1;
}

// Cosine and sine, times the amplitude.
vec2 swingOf(swQueryWave wave, ivec2 cell, vec2 rest)
{
    uint phase = wave.phase + uint(cell.x) * wave.cellTurnsX + uint(cell.y) * wave.cellTurnsZ +
                 toTurns(rest.x * wave.turnsX + rest.y * wave.turnsZ);
    return wave.amplitude * unitOf(phase);
}
