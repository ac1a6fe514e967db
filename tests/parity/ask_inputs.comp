// SPDX-License-Identifier: MIT
// What inputs say of a field at given places of the sea, for parity_inputs.c.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/fields.h"

layout(local_size_x = 64) in;
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
struct Asked
{
    ivec2 cell;
    vec2 rest;
};
layout(std430, binding = 4) readonly buffer Places
{
    Asked places[];
};
layout(std430, binding = 5) writeonly buffer Answers
{
    swInputValue answers[]; // of all places for the first field, then for the next
};
layout(push_constant) uniform Push
{
    uint count;
};

#include "lib/inputs.glsl"

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < count)
    {
        answers[gl_WorkGroupID.y * count + i] = fieldAt(gl_WorkGroupID.y, 0, SeaPlace(places[i].cell, places[i].rest));
    }
}
