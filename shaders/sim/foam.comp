// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Foam of every slice of a view after this frame, from the foam of the frame before, wherever its texels were then. The
// formulas and the search for the past are those of shared/foam.h; the folding J comes in full precision from the
// displacement's fourth component.

#include "lib/blocks.glsl"
#include "shared/foam.h"
#include "shared/waves.h"

layout(local_size_x = SW_FOAM_BLOCK * SW_FOAM_BLOCK) in;

layout(std430, binding = 0) readonly buffer Slices
{
    swFoamSliceParams slices[];
};
layout(std430, binding = 1) readonly buffer Sources
{
    swFoamSource sources[]; // SW_FOAM_SOURCES a slice
};
layout(binding = 2, rgba32f) uniform readonly image2DArray displacement;
layout(binding = 3, r32f) uniform readonly image2DArray previous;
layout(binding = 4, r32f) uniform writeonly image2DArray next;
layout(push_constant) uniform Push
{
    int resolution;
};

float foamAt(int slice, int x, int z)
{
    return imageLoad(previous, ivec3(x, z, slice)).x;
}

// Linear between four texels, whose corner may be exact on either axis.
float blendTexels(int slice, int x, int z, float alongX, float alongZ)
{
    int stepX = alongX > 0.0 ? 1 : 0;
    int stepZ = alongZ > 0.0 ? 1 : 0;
    float a = foamAt(slice, x, z);
    a += (foamAt(slice, x + stepX, z) - a) * alongX;
    float b = foamAt(slice, x, z + stepZ);
    b += (foamAt(slice, x + stepX, z + stepZ) - b) * alongX;
    return a + (b - a) * alongZ;
}

// Foam of the frame before at a texel; false if no slice of the previous stack held it.
bool readPrevious(ivec3 at, out float foam)
{
    foam = 0.0;
    for (int i = 0; i < SW_FOAM_SOURCES; ++i)
    {
        swFoamSource source = sources[at.z * SW_FOAM_SOURCES + i];
        if (source.slice < 0)
        {
            return false;
        }
        int x = swFoamTap(source.shift, source.baseX, source.restX, at.x);
        int z = swFoamTap(source.shift, source.baseZ, source.restZ, at.y);
        float alongX = swFoamTapFraction(source.shift, source.restX, at.x);
        float alongZ = swFoamTapFraction(source.shift, source.restZ, at.y);
        int lastX = resolution - (alongX > 0.0 ? 2 : 1);
        int lastZ = resolution - (alongZ > 0.0 ? 2 : 1);
        if (x >= 0 && z >= 0 && x <= lastX && z <= lastZ)
        {
            foam = blendTexels(source.slice, x, z, alongX, alongZ);
            return true;
        }
    }
    return false;
}

void main()
{
    ivec3 at = ivec3(gl_WorkGroupID.xy * SW_FOAM_BLOCK + blockPlace(gl_LocalInvocationIndex), gl_WorkGroupID.z);
    swFoamSliceParams slice = slices[at.z];
    float jacobian = imageLoad(displacement, at).w;
    float fold = swFoamFold(jacobian, slice.threshold, slice.deviation);
    float foam;
    bool hasPast = slice.isSteady == 0 && readPrevious(at, foam);
    foam = hasPast ? swFoamStep(foam, fold, slice.keep, slice.grow) : swFoamSteady(fold, slice.ceiling);
    imageStore(next, at, vec4(foam, 0.0, 0.0, 0.0));
}
