// SPDX-License-Identifier: MIT
#pragma once

// Layers with a past scroll: shared/layers.h says where a texel finds its value of the step before. The GPU's twin of
// the reading is shaders/lib/layers.glsl; where the sources lie is worked out here for both.

#include "core/frame/frame.h"

SW_SEAM_BEGIN

// Where the texels of `slice` were in a previous stack of slices of the same resolution: fills SW_PAST_SOURCES
// sources.
void swFindPastSources(const swSlice* slice, int resolution, int previousCount, const swSlice* previous,
                       swPastSource* sources);

// Whether any slice lies elsewhere than in `previous`.
bool swHasStackMoved(const swStackFrame* frame, const swSlice* previous);

SW_SEAM_END

// Linear between four texels of `stride` floats, whose corner (x, z) may be exact on either axis.
static inline float swBlendTexels(const float* texels, int stride, int resolution, int x, int z, float alongX,
                                  float alongZ)
{
    size_t stepX = alongX > 0.0f ? (size_t)stride : 0;
    const float* near = texels + ((size_t)z * (size_t)resolution + (size_t)x) * (size_t)stride;
    const float* far = alongZ > 0.0f ? near + (size_t)resolution * (size_t)stride : near;
    float a = near[0] + (near[stepX] - near[0]) * alongX;
    float b = far[0] + (far[stepX] - far[0]) * alongX;
    return a + (b - a) * alongZ;
}

// A texel's value in another slice; false if that does not hold it.
static inline bool swReadSource(const swPastSource* source, const float* slices, int stride, int resolution, int column,
                                int row, float* value)
{
    int x = swLayerTap(source->shift, source->baseX, source->restX, column);
    int z = swLayerTap(source->shift, source->baseZ, source->restZ, row);
    float alongX = swLayerTapFraction(source->shift, source->restX, column);
    float alongZ = swLayerTapFraction(source->shift, source->restZ, row);
    int lastX = resolution - (alongX > 0.0f ? 2 : 1);
    int lastZ = resolution - (alongZ > 0.0f ? 2 : 1);
    if (x < 0 || z < 0 || x > lastX || z > lastZ)
    {
        return false;
    }
    size_t sliceSize = (size_t)resolution * (size_t)resolution * (size_t)stride;
    const float* texels = slices + (size_t)source->slice * sliceSize;
    *value = swBlendTexels(texels, stride, resolution, x, z, alongX, alongZ);
    return true;
}

// A texel's value of the step before; false if no slice of the previous stack held it.
static inline bool swReadPast(const swPastSource* sources, const float* previous, int stride, int resolution,
                              int column, int row, float* value)
{
    for (int i = 0; i < SW_PAST_SOURCES && sources[i].slice >= 0; ++i)
    {
        if (swReadSource(&sources[i], previous, stride, resolution, column, row, value))
        {
            return true;
        }
    }
    return false;
}
