// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Foam that inputs make, or shores, at every texel of a view after this frame: the twin of core/surface/made_foam.c.
//
// The pass of fields has told of each block of texels how far a shore is, whether inputs make foam and whether the
// water flows. Where a block has none of these, nothing is read but the foam that was there.

#include "lib/blocks.glsl"
#include "lib/past.glsl"
#include "shared/fields.h"
#include "shared/foam.h"
#include "shared/waves.h"

layout(local_size_x = SW_FOAM_BLOCK * SW_FOAM_BLOCK) in;
layout(constant_id = 0) const bool WITH_INPUTS = true;    // some input makes foam
layout(constant_id = 1) const bool WITH_TRANSPORT = true; // water carries foam,
layout(constant_id = 2) const bool WITH_FLOW = true;      // and not only a current that is the same everywhere

layout(std430, binding = 0) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 1) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 2) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 3) readonly buffer InputWords
{
    float inputWords[];
};
layout(std430, binding = 4) readonly buffer Slices
{
    swFieldSlice slices[];
};
layout(std430, binding = 5) readonly buffer Sources
{
    swPastSource sources[]; // SW_PAST_SOURCES a slice
};
layout(std430, binding = 6) readonly buffer Params
{
    swMadeFoamParams params;
};
layout(binding = 7, rgba32f) uniform readonly image2DArray displacement;
layout(binding = 8, rgba32f) uniform readonly image2DArray places;
layout(binding = 9, r32f) uniform readonly image2DArray previous;
layout(binding = 10, r32f) uniform writeonly image2DArray nextFoam;
layout(binding = 11, rgba32f) uniform readonly image2DArray flow;
layout(binding = 12, rgba16f) uniform readonly image2DArray flowSlopes;
// Of a view without inputs there are none; it has neither a shore, nor WITH_INPUTS, nor WITH_FLOW.
layout(std430, binding = 13) readonly buffer Blocks
{
    swFieldBlock blocks[];
};
layout(push_constant) uniform Push
{
    int resolution;
};

#include "lib/inputs.glsl"
#include "lib/places.glsl"

swPastSource pastSource(int slice, int i)
{
    return sources[slice * SW_PAST_SOURCES + i];
}

float pastAt(int slice, int x, int z)
{
    return imageLoad(previous, ivec3(x, z, slice)).x;
}

#include "lib/transport.glsl"

uint blockHere()
{
    return fieldBlockOf(gl_WorkGroupID, uint(resolution));
}

// How far upstream a texel's foam was, in texels.
vec2 upstreamOf(ivec3 at)
{
    if (!WITH_TRANSPORT)
    {
        return vec2(0.0);
    }
    vec2 velocity = vec2(params.currentX, params.currentZ);
    vec4 slopes = vec4(0.0);
    if (WITH_FLOW && (blocks[blockHere()].foam & SW_BLOCK_CARRIES_FOAM) != 0)
    {
        velocity += imageLoad(flow, at).xy;
        slopes = imageLoad(flowSlopes, at);
    }
    return findUpstream(velocity, slopes, params.dt, slices[at.z].texel);
}

// Per second.
float birthAt(ivec3 at)
{
    if (params.isWake == 0)
    {
        if (blocks[blockHere()].leastShore > 1.0001 * params.shoreWidth)
        {
            return 0.0;
        }
        vec4 place = imageLoad(places, at);
        return swFindShoreBirth(swFindShoreDistance(place.x, place.y, place.z), params.shoreWidth, params.shoreRate);
    }
    if (!WITH_INPUTS || (blocks[blockHere()].foam & SW_BLOCK_MAKES_FOAM) == 0)
    {
        return 0.0;
    }
    SeaPlace rest = placeOfTexel(slices[at.z], uint(at.x), uint(at.y));
    SeaPlace here = seaPlaceOf(rest.cell, rest.rest + imageLoad(displacement, at).xz);
    return max(fieldOnWater(SW_FIELD_OF_FOAM, here, rest).x, 0.0);
}

void main()
{
    ivec3 at = ivec3(gl_WorkGroupID.xy * SW_FOAM_BLOCK + blockPlace(gl_LocalInvocationIndex), gl_WorkGroupID.z);
    float foam;
    bool hasPast = params.isSteady == 0 && readPast(at, upstreamOf(at), foam);
    imageStore(nextFoam, at, vec4(swMadeFoamStep(foam, hasPast, birthAt(at), params), 0.0, 0.0, 0.0));
}
