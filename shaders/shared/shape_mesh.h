// SPDX-License-Identifier: MIT
// Meshes as inputs: triangles seen from above, found through a grid of square cells in the mesh's own plane. On a
// triangle values are linear, and their derivatives exactly those of that. The highest triangle counts, of those parts
// that do not lie above a given height. Beside the mesh there is no share.
//
// Words: x and z of the grid's corner, the side of a cell, the height above which nothing counts; for each cell, row by
// row, the number of the first of its entries, and one more for the end; the entries, which are numbers of triangles;
// the triangles, each with three corners x, y, z and then three times the corners' values. Numbers are floats, exact
// below 2^24. extra0 and extra1 count cells along x and z, extra2 is the number of values a corner has, extra3 the word
// of the first entry, extra4 that of the first triangle.
#ifndef SW_SHARED_SHAPE_MESH_H
#define SW_SHARED_SHAPE_MESH_H
#include "input.h"

#define SW_MESH_HEAD 4u // words before the cells

// Twice the area of the triangle a, b and the point, the same but for its sign from both sides of the edge: a point on
// an edge is in one of its triangles at least.
SW_FORMULA float swMeshEdge(float ax, float az, float bx, float bz, float x, float z)
{
    bool isTurned = ax > bx || (ax == bx && az > bz);
    float fromX = isTurned ? bx : ax;
    float fromZ = isTurned ? bz : az;
    float toX = isTurned ? ax : bx;
    float toZ = isTurned ? az : bz;
    float edge = (toX - fromX) * (z - fromZ) - (toZ - fromZ) * (x - fromX);
    return isTurned ? -edge : edge;
}

// A linear function over a triangle whose first word is `at`; its corners' numbers are `a`, `b` and `c`. Held between
// them: on a wall that is hardly off the vertical, rounding would reach beyond.
SW_FORMULA swInputChannel swMixMeshCorners(SW_WORDS words, sw_uint at, float a, float b, float c, float x, float z)
{
    float ax = SW_WORD(words, at), az = SW_WORD(words, at + 2u);
    float bx = SW_WORD(words, at + 3u) - ax, bz = SW_WORD(words, at + 5u) - az;
    float cx = SW_WORD(words, at + 6u) - ax, cz = SW_WORD(words, at + 8u) - az;
    float area = bx * cz - bz * cx; // never 0: such triangles have no entries
    float alongX = ((b - a) * cz - (c - a) * bz) / area;
    float alongZ = ((c - a) * bx - (b - a) * cx) / area;
    float value = a + alongX * (x - ax) + alongZ * (z - az);
    float low = a < b ? (a < c ? a : c) : (b < c ? b : c);
    float high = a > b ? (a > c ? a : c) : (b > c ? b : c);
    value = value < low ? low : value > high ? high : value;
    return swMakeChannel(value, alongX, alongZ);
}

SW_FORMULA bool swIsInMeshTriangle(SW_WORDS words, sw_uint at, float x, float z)
{
    float ax = SW_WORD(words, at), az = SW_WORD(words, at + 2u);
    float bx = SW_WORD(words, at + 3u), bz = SW_WORD(words, at + 5u);
    float cx = SW_WORD(words, at + 6u), cz = SW_WORD(words, at + 8u);
    float ab = swMeshEdge(ax, az, bx, bz, x, z);
    float bc = swMeshEdge(bx, bz, cx, cz, x, z);
    float ca = swMeshEdge(cx, cz, ax, az, x, z);
    return (ab >= 0.0f && bc >= 0.0f && ca >= 0.0f) || (ab <= 0.0f && bc <= 0.0f && ca <= 0.0f);
}

// What lies at a place: the triangle's first word, or SW_NO_MESH, and the height there.
#define SW_NO_MESH 0xffffffffu
SW_PARAMS(swMeshHit)
{
    sw_uint at;
    swInputChannel height;
};

SW_FORMULA swMeshHit swFindOnMesh(SW_WORDS words, swInputRecord record, float x, float z)
{
    swMeshHit hit;
    hit.at = SW_NO_MESH;
    hit.height = swMakeChannel(0.0f, 0.0f, 0.0f);
    float cellX = (x - SW_WORD(words, 0u)) / SW_WORD(words, 2u);
    float cellZ = (z - SW_WORD(words, 1u)) / SW_WORD(words, 2u);
    if (!(cellX >= 0.0f && cellZ >= 0.0f && cellX < SW_FLOAT(record.extra0) && cellZ < SW_FLOAT(record.extra1)))
    {
        return hit;
    }
    sw_uint cell = SW_MESH_HEAD + SW_UINT(cellZ) * record.extra0 + SW_UINT(cellX);
    sw_uint entry = record.extra3 + SW_UINT(SW_WORD(words, cell));
    sw_uint end = record.extra3 + SW_UINT(SW_WORD(words, cell + 1u));
    sw_uint triangleWords = 9u + 3u * record.extra2;
    for (; entry < end; ++entry)
    {
        sw_uint at = record.extra4 + SW_UINT(SW_WORD(words, entry)) * triangleWords;
        if (!swIsInMeshTriangle(words, at, x, z))
        {
            continue;
        }
        swInputChannel height = swMixMeshCorners(words, at, SW_WORD(words, at + 1u), SW_WORD(words, at + 4u),
                                                 SW_WORD(words, at + 7u), x, z);
        if (height.value <= SW_WORD(words, 3u) && (hit.at == SW_NO_MESH || height.value > hit.height.value))
        {
            hit.at = at;
            hit.height = height;
        }
    }
    return hit;
}

// The value of a corner, by number; without values the mesh says 1.
SW_FORMULA swInputChannel swSampleMeshValue(SW_WORDS words, swInputRecord record, sw_uint at, sw_uint channel, float x,
                                            float z)
{
    if (channel >= record.extra2)
    {
        return swMakeChannel(1.0f, 0.0f, 0.0f);
    }
    sw_uint first = at + 9u + channel;
    return swMixMeshCorners(words, at, SW_WORD(words, first), SW_WORD(words, first + record.extra2),
                            SW_WORD(words, first + 2u * record.extra2), x, z);
}

// In own coordinates. A floor is the height of the mesh; other fields have its corners' values.
SW_FORMULA swInputSample swSampleMeshInput(SW_WORDS words, swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    swMeshHit hit = swFindOnMesh(words, record, x, z);
    if (hit.at == SW_NO_MESH)
    {
        s.share = 0.0f;
        return s;
    }
    swInputChannel c = hit.height;
    if (record.field != SW_FIELD_OF_FLOOR)
    {
        c = swSampleMeshValue(words, record, hit.at, 0u, x, z);
        swInputChannel y = swSampleMeshValue(words, record, hit.at, 1u, x, z);
        swInputChannel w = swSampleMeshValue(words, record, hit.at, 2u, x, z);
        swInputChannel v = swSampleMeshValue(words, record, hit.at, 3u, x, z);
        s.value.y = s.value.y + record.gain * y.value;
        s.valueX.y = record.gain * y.alongX;
        s.valueZ.y = record.gain * y.alongZ;
        s.value.z = s.value.z + record.gain * w.value;
        s.valueX.z = record.gain * w.alongX;
        s.valueZ.z = record.gain * w.alongZ;
        s.value.w = s.value.w + record.gain * v.value;
        s.valueX.w = record.gain * v.alongX;
        s.valueZ.w = record.gain * v.alongZ;
    }
    s.value.x = s.value.x + record.gain * c.value;
    s.valueX.x = record.gain * c.alongX;
    s.valueZ.x = record.gain * c.alongZ;
    return swCoverRectangle(s, x - record.middleX, z - record.middleZ, record.halfX, record.halfZ, record.feather);
}
#endif
