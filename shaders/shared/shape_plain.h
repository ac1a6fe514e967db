// SPDX-License-Identifier: MIT
// Shapes of inputs that need no data: the whole sea, circles and rectangles. Own coordinates, m.
#ifndef SW_SHARED_SHAPE_PLAIN_H
#define SW_SHARED_SHAPE_PLAIN_H
#include "input.h"

// Fades along the radius within the feather.
SW_FORMULA swInputSample swSampleCircle(swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    float distance = SW_INPUT_SQRT(x * x + z * z);
    sw_vec2 cover = swCoverDisc(record, distance, 0.5f * record.size.x);
    s.share = cover.x;
    if (cover.y < 0.0f && distance > 0.0f)
    {
        s.shareX = cover.y * (x / distance);
        s.shareZ = cover.y * (z / distance);
    }
    return s;
}

SW_FORMULA swInputSample swSampleRectangle(swInputRecord record, float x, float z)
{
    return swCoverRectangle(swBeginInputSample(record), x, z, 0.5f * record.size.x, 0.5f * record.size.z,
                            record.feather);
}
#endif
