// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Wetness of every slice of a view after this frame: shared/wetness.h has the law, and lib/past.glsl the search for the
// past.

#include "lib/blocks.glsl"
#include "lib/past.glsl"
#include "shared/wetness.h"

layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer Slices
{
    swWetnessParams slices[];
};
layout(std430, binding = 1) readonly buffer Sources
{
    swPastSource sources[]; // SW_PAST_SOURCES a slice
};
layout(binding = 2, rgba32f) uniform readonly image2DArray displacement;
layout(binding = 3, r32f) uniform readonly image2DArray previous;
layout(binding = 4, r32f) uniform writeonly image2DArray nextWetness;
layout(push_constant) uniform Push
{
    int resolution;
};

float wetnessAt(int slice, int x, int z)
{
    return imageLoad(previous, ivec3(x, z, slice)).x;
}

// 0 where no slice of the previous stack held the texel.
float readPrevious(ivec3 at)
{
    for (int i = 0; i < SW_PAST_SOURCES; ++i)
    {
        swPastSource source = sources[at.z * SW_PAST_SOURCES + i];
        if (source.slice < 0)
        {
            return 0.0;
        }
        PastTap tap = findTap(source, at.xy, resolution);
        if (tap.isHeld)
        {
            ivec2 next = nextTexel(tap);
            return blend(wetnessAt(source.slice, tap.texel.x, tap.texel.y),
                         wetnessAt(source.slice, next.x, tap.texel.y), wetnessAt(source.slice, tap.texel.x, next.y),
                         wetnessAt(source.slice, next.x, next.y), tap.along);
        }
    }
    return 0.0;
}

void main()
{
    ivec3 at = ivec3(gl_WorkGroupID.xy * 16 + blockPlace(gl_LocalInvocationIndex), gl_WorkGroupID.z);
    swWetnessParams slice = slices[at.z];
    float past = slice.isDry == 0 ? readPrevious(at) : 0.0;
    float height = imageLoad(displacement, at).y;
    imageStore(nextWetness, at, vec4(swWetnessStep(past, height, slice.soak, slice.dryRate, slice.dt), 0.0, 0.0, 0.0));
}
