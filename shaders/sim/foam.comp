// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Foam of every slice of a view after this frame, from the foam of the frame before, wherever its texels were then. The
// formulas are those of shared/foam.h, the search for the past that of lib/past.glsl; the folding J comes in full
// precision from the displacement's fourth component.

#include "lib/blocks.glsl"
#include "lib/past.glsl"
#include "shared/foam.h"
#include "shared/waves.h"

layout(local_size_x = SW_FOAM_BLOCK * SW_FOAM_BLOCK) in;

layout(std430, binding = 0) readonly buffer Slices
{
    swFoamSliceParams slices[];
};
layout(std430, binding = 1) readonly buffer Sources
{
    swPastSource sources[]; // SW_PAST_SOURCES a slice for the past, and one for the fold
};
layout(binding = 2, rgba32f) uniform readonly image2DArray displacement;
layout(binding = 3, r32f) uniform readonly image2DArray previous;
layout(binding = 4, r32f) uniform writeonly image2DArray nextFoam;
layout(push_constant) uniform Push
{
    int resolution;
};

float foamAt(int slice, int x, int z)
{
    return imageLoad(previous, ivec3(x, z, slice)).x;
}

float jacobianAt(int slice, int x, int z)
{
    return imageLoad(displacement, ivec3(x, z, slice)).w;
}

// Foam of the frame before at a texel; false if no slice of the previous stack held it.
bool readPrevious(ivec3 at, out float foam)
{
    foam = 0.0;
    for (int i = 0; i < SW_PAST_SOURCES; ++i)
    {
        swPastSource source = sources[at.z * (SW_PAST_SOURCES + 1) + i];
        if (source.slice < 0)
        {
            return false;
        }
        PastTap tap = findTap(source, at.xy, resolution);
        if (tap.isHeld)
        {
            ivec2 next = nextTexel(tap);
            foam = blend(foamAt(source.slice, tap.texel.x, tap.texel.y), foamAt(source.slice, next.x, tap.texel.y),
                         foamAt(source.slice, tap.texel.x, next.y), foamAt(source.slice, next.x, next.y), tap.along);
            return true;
        }
    }
    return false;
}

// J where the slice finds its folds; flat water beyond what is known.
float readJacobian(ivec3 at)
{
    swPastSource source = sources[at.z * (SW_PAST_SOURCES + 1) + SW_PAST_SOURCES];
    if (source.slice == at.z)
    {
        return jacobianAt(at.z, at.x, at.y);
    }
    PastTap tap = findTap(source, at.xy, resolution);
    if (!tap.isHeld)
    {
        return 1.0;
    }
    ivec2 next = nextTexel(tap);
    return blend(jacobianAt(source.slice, tap.texel.x, tap.texel.y), jacobianAt(source.slice, next.x, tap.texel.y),
                 jacobianAt(source.slice, tap.texel.x, next.y), jacobianAt(source.slice, next.x, next.y), tap.along);
}

void main()
{
    ivec3 at = ivec3(gl_WorkGroupID.xy * SW_FOAM_BLOCK + blockPlace(gl_LocalInvocationIndex), gl_WorkGroupID.z);
    swFoamSliceParams slice = slices[at.z];
    float birth = slice.growth * swFoamFold(readJacobian(at), slice.threshold, slice.rest);
    float foam;
    bool hasPast = slice.isSteady == 0 && readPrevious(at, foam);
    foam =
        hasPast ? swFoamStep(foam, birth, slice.fadeRate, slice.dt) : swFoamStart(birth, slice.fadeRate, slice.start);
    imageStore(nextFoam, at, vec4(foam, 0.0, 0.0, 0.0));
}
