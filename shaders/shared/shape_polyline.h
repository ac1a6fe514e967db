// SPDX-License-Identifier: MIT
// A line through points that have a width, a weight and values each: trails. Between two points all of that runs
// evenly; at each point the line is round. Of all its pieces the one counts at a place that counts most there, so that
// a line which bends or crosses itself has no seam in how much it counts.
//
// Words: a box for each SW_POLYLINE_CHUNK pieces, of all that they cover, then the points. `extra0` is the number of
// points.
#ifndef SW_SHARED_SHAPE_POLYLINE_H
#define SW_SHARED_SHAPE_POLYLINE_H
#include "input.h"

#define SW_POLYLINE_CHUNK 8u
#define SW_POLYLINE_BOX_WORDS 4u // least x, least z, most x, most z, m

#define SW_POLYLINE_X 0u
#define SW_POLYLINE_Z 1u
#define SW_POLYLINE_RADIUS 2u // half the width, m
#define SW_POLYLINE_WEIGHT 3u
#define SW_POLYLINE_VALUE 4u // four
#define SW_POLYLINE_POINT_WORDS 8u

SW_FORMULA sw_uint swCountPolylineChunks(sw_uint pointCount)
{
    return (pointCount - 1u + SW_POLYLINE_CHUNK - 1u) / SW_POLYLINE_CHUNK;
}

// What a piece says: how much it counts, and where along it a place is.
SW_PARAMS(swPolylinePiece)
{
    swInputChannel share;
    swInputChannel part; // 0 at its first point, 1 at its second
};

SW_FORMULA swPolylinePiece swSamplePiece(SW_WORDS words, sw_uint point, float feather, float x, float z)
{
    sw_uint next = point + SW_POLYLINE_POINT_WORDS;
    float ax = SW_WORD(words, point + SW_POLYLINE_X);
    float az = SW_WORD(words, point + SW_POLYLINE_Z);
    float wayX = SW_WORD(words, next + SW_POLYLINE_X) - ax;
    float wayZ = SW_WORD(words, next + SW_POLYLINE_Z) - az;
    float square = wayX * wayX + wayZ * wayZ;
    float t = square > 0.0f ? ((x - ax) * wayX + (z - az) * wayZ) / square : 0.0f;
    swPolylinePiece piece;
    piece.part = swMakeChannel(0.0f, 0.0f, 0.0f);
    if (t >= 1.0f)
    {
        piece.part.value = 1.0f;
    }
    else if (t > 0.0f)
    {
        piece.part = swMakeChannel(t, wayX / square, wayZ / square);
    }
    float dx = x - (ax + wayX * piece.part.value);
    float dz = z - (az + wayZ * piece.part.value);
    float distance = SW_INPUT_SQRT(dx * dx + dz * dz);
    float from = SW_WORD(words, point + SW_POLYLINE_RADIUS);
    float widening = SW_WORD(words, next + SW_POLYLINE_RADIUS) - from;
    float inverse = distance > 0.0f ? 1.0f / distance : 0.0f;
    // The foot moves along the piece, to which the way to the place is straight: its own motion adds nothing.
    swInputChannel inside =
        swMakeChannel(from + widening * piece.part.value - distance, widening * piece.part.alongX - dx * inverse,
                      widening * piece.part.alongZ - dz * inverse);
    sw_vec2 cover = swFeatherInput(inside.value, feather);
    float first = SW_WORD(words, point + SW_POLYLINE_WEIGHT);
    float more = SW_WORD(words, next + SW_POLYLINE_WEIGHT) - first;
    float weight = first + more * piece.part.value;
    piece.share = swMakeChannel(cover.x * weight, cover.y * inside.alongX * weight + cover.x * more * piece.part.alongX,
                                cover.y * inside.alongZ * weight + cover.x * more * piece.part.alongZ);
    return piece;
}

SW_FORMULA bool swIsInPolylineBox(SW_WORDS words, sw_uint chunk, float x, float z)
{
    sw_uint box = chunk * SW_POLYLINE_BOX_WORDS;
    return x >= SW_WORD(words, box) && z >= SW_WORD(words, box + 1u) && x <= SW_WORD(words, box + 2u) &&
           z <= SW_WORD(words, box + 3u);
}

SW_FORMULA swInputChannel swMixAlongPiece(SW_WORDS words, sw_uint word, swInputChannel part)
{
    float from = SW_WORD(words, word);
    float way = SW_WORD(words, word + SW_POLYLINE_POINT_WORDS) - from;
    return swMakeChannel(from + way * part.value, way * part.alongX, way * part.alongZ);
}

SW_FORMULA swInputSample swSamplePolyline(SW_WORDS words, swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    sw_uint chunks = swCountPolylineChunks(record.extra0);
    sw_uint points = chunks * SW_POLYLINE_BOX_WORDS;
    sw_uint best = points;
    swPolylinePiece most;
    most.share = swMakeChannel(0.0f, 0.0f, 0.0f);
    most.part = most.share;
    for (sw_uint chunk = 0u; chunk < chunks; ++chunk)
    {
        if (!swIsInPolylineBox(words, chunk, x, z))
        {
            continue;
        }
        sw_uint end = (chunk + 1u) * SW_POLYLINE_CHUNK;
        end = end < record.extra0 - 1u ? end : record.extra0 - 1u;
        for (sw_uint i = chunk * SW_POLYLINE_CHUNK; i < end; ++i)
        {
            sw_uint point = points + i * SW_POLYLINE_POINT_WORDS;
            swPolylinePiece piece = swSamplePiece(words, point, record.feather, x, z);
            if (piece.share.value > most.share.value)
            {
                most = piece;
                best = point;
            }
        }
    }
    s.share = most.share.value;
    s.shareX = most.share.alongX;
    s.shareZ = most.share.alongZ;
    if (s.share > 0.0f)
    {
        swInputChannel x0 = swMixAlongPiece(words, best + SW_POLYLINE_VALUE, most.part);
        swInputChannel x1 = swMixAlongPiece(words, best + SW_POLYLINE_VALUE + 1u, most.part);
        swInputChannel x2 = swMixAlongPiece(words, best + SW_POLYLINE_VALUE + 2u, most.part);
        swInputChannel x3 = swMixAlongPiece(words, best + SW_POLYLINE_VALUE + 3u, most.part);
        s.value.x = s.value.x + x0.value;
        s.value.y = s.value.y + x1.value;
        s.value.z = s.value.z + x2.value;
        s.value.w = s.value.w + x3.value;
        s.valueX.x = x0.alongX;
        s.valueX.y = x1.alongX;
        s.valueX.z = x2.alongX;
        s.valueX.w = x3.alongX;
        s.valueZ.x = x0.alongZ;
        s.valueZ.y = x1.alongZ;
        s.valueZ.z = x2.alongZ;
        s.valueZ.w = x3.alongZ;
    }
    return s;
}
#endif
