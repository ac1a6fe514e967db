// SPDX-License-Identifier: MIT
// What lib/surface_sample.glsl reads of a layer at given levels, for parity_slice_reading.c.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/surface_sample.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Slices
{
    swMeshSlice slices[];
};
layout(std430, binding = 1) readonly buffer Levels
{
    float levels[];
};
layout(std430, binding = 2) writeonly buffer Answers
{
    vec2 answers[]; // read by the device's filter, and by hand
};
layout(binding = 3) uniform sampler2DArray layer;
layout(push_constant) uniform Push
{
    uint count, ringCount, resolution;
    float beyond;
};

swMeshSlice meshSlice(uint index)
{
    return slices[index];
}

swDetailParams detailBand(uint index)
{
    return swDetailParams(0.0, 0.0, 1.0, 1.0, 2.0, 0.0, 0.0, 0u);
}

swDetailWave detailWave(uint index)
{
    return swDetailWave(1.0, 0.0, 0.0, 0.1, 6.0, 0.0, 0.0, 0u);
}

float shareOf(uint system)
{
    return 1.0;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
    {
        return;
    }
    SurfaceGrid grid = SurfaceGrid(ringCount, 0, 0, resolution, 2.0, 0.0);
    Footprint footprint = Footprint(vec2(1.0, 0.0), 0.0, 0.0);
    SlicePair pair = slicePairAt(grid, sliceLevelAt(grid, levels[i], footprint));
    answers[i] = vec2(sampleSlices(layer, grid, pair, vec2(0.0), vec4(beyond), false).x,
                      sampleSlices(layer, grid, pair, vec2(0.0), vec4(beyond), true).x);
}
