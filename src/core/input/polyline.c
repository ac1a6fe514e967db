// SPDX-License-Identifier: MIT
#include "core/input/polyline.h"

#include <math.h>
#include <string.h>

int swCountPolylineWords(int count)
{
    return count < 2 ? 0
                     : (int)(swCountPolylineChunks((sw_uint)count) * SW_POLYLINE_BOX_WORDS) +
                           count * (int)SW_POLYLINE_POINT_WORDS;
}

static void growBox(const float* point, float box[4])
{
    // A little more, so that rounding leaves no place out.
    float radius = point[SW_POLYLINE_RADIUS] + 1e-6f * (fabsf(point[SW_POLYLINE_X]) + fabsf(point[SW_POLYLINE_Z]));
    box[0] = fminf(box[0], point[SW_POLYLINE_X] - radius);
    box[1] = fminf(box[1], point[SW_POLYLINE_Z] - radius);
    box[2] = fmaxf(box[2], point[SW_POLYLINE_X] + radius);
    box[3] = fmaxf(box[3], point[SW_POLYLINE_Z] + radius);
}

static void emptyBox(float box[4])
{
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
}

int swWritePolyline(int count, const swInputPoint* points, float width, float* words)
{
    int chunks = (int)swCountPolylineChunks((sw_uint)count), chunk = (int)SW_POLYLINE_CHUNK;
    float* written = words + chunks * (int)SW_POLYLINE_BOX_WORDS;
    for (int i = 0; i < count; ++i)
    {
        float* point = written + i * (int)SW_POLYLINE_POINT_WORDS;
        point[SW_POLYLINE_X] = points[i].x;
        point[SW_POLYLINE_Z] = points[i].z;
        point[SW_POLYLINE_RADIUS] = points[i].radius > 0.0f ? points[i].radius : 0.5f * width;
        point[SW_POLYLINE_WEIGHT] = points[i].weight;
        memcpy(point + SW_POLYLINE_VALUE, points[i].value, sizeof points[i].value);
    }
    for (int c = 0; c < chunks; ++c)
    {
        float* box = words + c * (int)SW_POLYLINE_BOX_WORDS;
        emptyBox(box);
        for (int i = c * chunk; i <= (c + 1) * chunk && i < count; ++i)
        {
            growBox(written + i * (int)SW_POLYLINE_POINT_WORDS, box);
        }
    }
    return swCountPolylineWords(count);
}

void swBoundPolyline(int count, const float* words, float bounds[4])
{
    emptyBox(bounds);
    for (int c = 0; c < (int)swCountPolylineChunks((sw_uint)count); ++c)
    {
        const float* box = words + c * (int)SW_POLYLINE_BOX_WORDS;
        for (int k = 0; k < 2; ++k)
        {
            bounds[k] = fminf(bounds[k], box[k]);
            bounds[k + 2] = fmaxf(bounds[k + 2], box[k + 2]);
        }
    }
}
