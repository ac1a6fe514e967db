// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Foam of every slice of a view after this frame, from the foam of the frame before, wherever its texels were then. The
// formulas are those of shared/foam.h, the search for the past that of lib/past.glsl; the folding J comes in full
// precision from the displacement's fourth component.

#include "lib/blocks.glsl"
#include "lib/past.glsl"
#include "shared/fields.h"
#include "shared/foam.h"
#include "shared/waves.h"

layout(local_size_x = SW_FOAM_BLOCK * SW_FOAM_BLOCK) in;
layout(constant_id = 0) const bool WITH_TRANSPORT = true; // water carries foam,
layout(constant_id = 1) const bool WITH_FLOW = true;      // and not only a current that is the same everywhere

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
layout(binding = 5, rgba32f) uniform readonly image2DArray flow;
layout(binding = 6, rgba16f) uniform readonly image2DArray flowSlopes;
// What the pass of fields tells of blocks of texels; read if WITH_FLOW.
layout(std430, binding = 7) readonly buffer Blocks
{
    swFieldBlock blocks[];
};
layout(push_constant) uniform Push
{
    int resolution;
};

float jacobianAt(int slice, int x, int z)
{
    return imageLoad(displacement, ivec3(x, z, slice)).w;
}

swPastSource pastSource(int slice, int i)
{
    return sources[slice * (SW_PAST_SOURCES + 1) + i];
}

float pastAt(int slice, int x, int z)
{
    return imageLoad(previous, ivec3(x, z, slice)).x;
}

#include "lib/transport.glsl"

// How far upstream a texel's foam was, in texels.
vec2 upstreamOf(ivec3 at, swFoamSliceParams slice)
{
    if (!WITH_TRANSPORT)
    {
        return vec2(0.0);
    }
    vec2 velocity = vec2(slice.currentX, slice.currentZ);
    vec4 slopes = vec4(0.0);
    if (WITH_FLOW && (blocks[fieldBlockOf(gl_WorkGroupID, uint(resolution))].foam & SW_BLOCK_CARRIES_FOAM) != 0)
    {
        velocity += imageLoad(flow, at).xy;
        slopes = imageLoad(flowSlopes, at);
    }
    return findUpstream(velocity, slopes, slice.dt, slice.texel);
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
    bool hasPast = slice.isSteady == 0 && readPast(at, upstreamOf(at, slice), foam);
    foam =
        hasPast ? swFoamStep(foam, birth, slice.fadeRate, slice.dt) : swFoamStart(birth, slice.fadeRate, slice.start);
    imageStore(nextFoam, at, vec4(foam, 0.0, 0.0, 0.0));
}
