// SPDX-License-Identifier: MIT
#version 460

// Next to nothing: what a dispatch and a barrier cost by themselves, and over a large buffer what memory gives.

layout(local_size_x = 256) in;

layout(std430, binding = 0) buffer Words
{
    uvec4 words[];
};

void main()
{
    words[gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 256 + gl_GlobalInvocationID.x] += 1u;
}
