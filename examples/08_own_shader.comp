// SPDX-License-Identifier: MIT
// A beach that falls towards the west, asked texel by texel how deep it is under water, and how much foam lies there.
#version 460
#extension GL_GOOGLE_include_directive : require
// [shader]
#define SW_LAYERS_SET 1
#include "seaway/layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Beach
{
    vec4 beach[]; // height of the water and of the ground, m from the reference; foam; the normal's y
};
layout(push_constant) uniform Push
{
    uint side;
    float spacing; // m
    float slope;   // of the ground
};

void main()
{
    uvec2 texel = gl_GlobalInvocationID.xy;
    vec2 place = (vec2(texel) - 0.5 * float(side)) * spacing;
    vec2 rest = swRestOf(place);
    float water = swWaterHeight(place);
    float ground = place.x * slope;
    beach[texel.y * side + texel.x] = vec4(water, ground, swFoamAt(rest), swNormalAt(rest).y);
}
// [/shader]
