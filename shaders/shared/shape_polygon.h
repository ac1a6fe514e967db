// SPDX-License-Identifier: MIT
// The signed distance from a polygon's edge, below 0 inside. Words: x and z of each point, in order around the area,
// either way round. Own coordinates, m.
#ifndef SW_SHARED_SHAPE_POLYGON_H
#define SW_SHARED_SHAPE_POLYGON_H
#include "input.h"

// Distance (x) and its gradient along x and z (y, z).
SW_FORMULA sw_vec3 swPolygonDistance(SW_WORDS words, sw_uint count, float x, float z)
{
    float least = 3e38f, awayX = 1.0f, awayZ = 0.0f;
    bool isInside = false;
    float fromX = SW_WORD(words, 2u * count - 2u) - x, fromZ = SW_WORD(words, 2u * count - 1u) - z;
    for (sw_uint i = 0u; i < count; ++i)
    {
        float toX = SW_WORD(words, 2u * i) - x, toZ = SW_WORD(words, 2u * i + 1u) - z;
        float alongX = toX - fromX, alongZ = toZ - fromZ;
        float part = -(fromX * alongX + fromZ * alongZ) / (alongX * alongX + alongZ * alongZ);
        part = part < 0.0f ? 0.0f : (part > 1.0f ? 1.0f : part);
        float nearX = fromX + part * alongX, nearZ = fromZ + part * alongZ;
        float square = nearX * nearX + nearZ * nearZ;
        if (square < least)
        {
            least = square;
            awayX = -nearX;
            awayZ = -nearZ;
        }
        // A line towards +x crosses the edge.
        if ((fromZ > 0.0f) != (toZ > 0.0f))
        {
            float side = alongX * fromZ - alongZ * fromX;
            isInside = (side > 0.0f) == (toZ < fromZ) ? !isInside : isInside;
        }
        fromX = toX;
        fromZ = toZ;
    }
    float distance = SW_INPUT_SQRT(least);
    float sign = isInside ? -1.0f : 1.0f;
    sw_vec3 result;
    result.x = sign * distance;
    result.y = distance > 0.0f ? sign * awayX / distance : 0.0f;
    result.z = distance > 0.0f ? sign * awayZ / distance : 0.0f;
    return result;
}

SW_FORMULA swInputSample swSamplePolygon(SW_WORDS words, swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    if (SW_INPUT_ABS(x - record.middleX) > record.halfX || SW_INPUT_ABS(z - record.middleZ) > record.halfZ)
    {
        s.share = 0.0f;
        return s;
    }
    sw_vec3 distance = swPolygonDistance(words, record.extra0, x, z);
    sw_vec2 cover = swFeatherInput(-distance.x, record.feather);
    s.share = cover.x;
    s.shareX = -cover.y * distance.y;
    s.shareZ = -cover.y * distance.z;
    return s;
}
#endif
