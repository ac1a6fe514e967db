// SPDX-License-Identifier: MIT
// What seaway/layers.glsl says at given places, for parity_view_layers.c.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SW_LAYERS_SET 1
#include "seaway/layers.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places
{
    vec4 places[]; // x, z, slice
};
layout(std430, set = 0, binding = 1) writeonly buffer Answers
{
    vec4 answers[]; // four a place
};
layout(push_constant) uniform Push
{
    uint count;
};

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
    {
        return;
    }
    vec2 at = places[i].xy;
    int slice = int(places[i].z);
    swLayerPair pair = swFindLayers(at);
    answers[4 * i] = swReadSlice(swDisplacementLayer, slice, at);
    answers[4 * i + 1] = swReadSlice(swDerivativesLayer, slice, at);
    answers[4 * i + 2] = vec4(swWaterHeight(at), swFoamAt(at), float(pair.first), float(pair.second));
    answers[4 * i + 3] =
        vec4(pair.firstWeight, pair.secondWeight, swReadSlice(swFoamLayer, slice, at).x, swNormalAt(at).w);
}
