// SPDX-License-Identifier: MIT
// The signed distance from a closed mesh, read from a grid in the mesh's own axes. Its words: where the first value
// lies (x, y, z) and the spacing, in the mesh's own lengths; then the values, x running fastest, then y, then z.
// Between eight values it is trilinear, and its gradient is exactly that function's. Beyond the grid, whose rim lies
// outside of the mesh, it is the least distance that the mesh can have: way to the rim and distance there, at a right
// angle.
#ifndef SW_SHARED_SHAPE_HULL_H
#define SW_SHARED_SHAPE_HULL_H
#include "input.h"
#include "shape_solids.h"

#define SW_HULL_HEAD 4u // words before the values

// A place along an axis in spacings from the first value, held inside of the grid.
SW_FORMULA float swHullHold(float at, sw_uint count)
{
    float last = SW_FLOAT(count - 1u);
    return swSolidMost(swSolidLeast(at, last), SW_FLOAT(0.0));
}

// The cell that it is in.
SW_FORMULA sw_uint swHullCell(float at, sw_uint count)
{
    sw_uint cell = SW_UINT(at);
    return cell < count - 1u ? cell : count - 2u;
}

// Gradient (x, y, z) and distance (w) at a place in the mesh's own axes and lengths. Each count is at least 2.
SW_FORMULA sw_vec4 swHullDistance(SW_WORDS words, sw_uint countX, sw_uint countY, sw_uint countZ, float x, float y,
                                  float z)
{
    float spacing = SW_WORD(words, 3u);
    float atX = (x - SW_WORD(words, 0u)) / spacing;
    float atY = (y - SW_WORD(words, 1u)) / spacing;
    float atZ = (z - SW_WORD(words, 2u)) / spacing;
    float inX = swHullHold(atX, countX), inY = swHullHold(atY, countY), inZ = swHullHold(atZ, countZ);
    sw_uint cellX = swHullCell(inX, countX), cellY = swHullCell(inY, countY), cellZ = swHullCell(inZ, countZ);
    float u = inX - SW_FLOAT(cellX), v = inY - SW_FLOAT(cellY), w = inZ - SW_FLOAT(cellZ);
    sw_uint row = countX, sheet = countX * countY;
    sw_uint first = SW_HULL_HEAD + cellX + cellY * row + cellZ * sheet;
    float a = SW_WORD(words, first), ax = SW_WORD(words, first + 1u) - a;
    float b = SW_WORD(words, first + row), bx = SW_WORD(words, first + row + 1u) - b;
    float c = SW_WORD(words, first + sheet), cx = SW_WORD(words, first + sheet + 1u) - c;
    float d = SW_WORD(words, first + sheet + row), dx = SW_WORD(words, first + sheet + row + 1u) - d;
    float ab = (b + bx * u) - (a + ax * u), cd = (d + dx * u) - (c + cx * u);
    float near = (a + ax * u) + ab * v, far = (c + cx * u) + cd * v;
    float nearX = ax + (bx - ax) * v, farX = cx + (dx - cx) * v;
    sw_vec4 result;
    result.x = (nearX + (farX - nearX) * w) / spacing;
    result.y = (ab + (cd - ab) * w) / spacing;
    result.z = (far - near) / spacing;
    result.w = near + (far - near) * w;
    float outX = (atX - inX) * spacing, outY = (atY - inY) * spacing, outZ = (atZ - inZ) * spacing;
    if (outX != SW_FLOAT(0.0) || outY != SW_FLOAT(0.0) || outZ != SW_FLOAT(0.0))
    {
        float away = SW_SOLID_SQRT(outX * outX + outY * outY + outZ * outZ + result.w * result.w);
        result.x = (outX + result.w * result.x) / away;
        result.y = (outY + result.w * result.y) / away;
        result.z = (outZ + result.w * result.z) / away;
        result.w = away;
    }
    return result;
}
#endif
