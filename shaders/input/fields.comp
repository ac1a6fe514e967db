// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Authored fields at every texel of every slice of a view: the twin of core/surface/fields.c. A workgroup makes the
// block of texels that one of slices.comp adds up waves for, and tells it what shapes waves there.
//
// Of a block that no input touches only the layers' texels are written.

#include "shared/fields.h"

layout(local_size_x = SW_SLICE_WIDTH) in;
layout(constant_id = 0) const bool WITH_GROUND = true; // the layer of depths is made

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
layout(std430, binding = 5) writeonly buffer Blocks
{
    swFieldBlock blocks[];
};
layout(binding = 6, rgba32f) uniform writeonly image2DArray places; // depth, its slopes along x and z, level
layout(push_constant) uniform Push
{
    uint resolution;
};

shared uint leastDepth; // as bits: no depth is below 0
shared uint systems;

#include "lib/inputs.glsl"
#include "lib/places.glsl"

const uint FIELDS[2] = {SW_FIELD_OF_LEVEL, SW_FIELD_OF_FLOOR};

// Bits of the systems that inputs weigh between two cells.
uint findSystems(ivec2 low, ivec2 high)
{
    uint found = inputHead.localSystems;
    uint record = findInput(SW_FIELD_OF_WAVES, low, high, 0);
    while (record != SW_NO_RECORD)
    {
        uint system = inputRecords[record].system;
        bool isOfAll = system == SW_ALL_SYSTEMS || (inputRecords[record].flags & SW_INPUT_REMOVES_WAVES) != 0u;
        found |= isOfAll ? SW_ALL_SYSTEMS : 1u << (system & 31u);
        record = findInput(SW_FIELD_OF_WAVES, low, high, record + 1);
    }
    return found;
}

void main()
{
    swFieldSlice slice = slices[gl_WorkGroupID.z];
    if (slice.isKept != 0)
    {
        return;
    }
    uint column = gl_GlobalInvocationID.x;
    uvec2 first = gl_WorkGroupID.xy * uvec2(SW_SLICE_WIDTH, SW_SLICE_HEIGHT);
    ivec2 low = placeOfTexel(slice, first.x, first.y).cell;
    ivec2 high = placeOfTexel(slice, first.x + SW_SLICE_WIDTH - 1, first.y + SW_SLICE_HEIGHT - 1).cell;
    bool hasGround = touchesInputs(SW_FIELD_OF_FLOOR, low, high) || touchesInputs(SW_FIELD_OF_LEVEL, low, high);
    if (gl_LocalInvocationIndex == 0)
    {
        leastDepth = floatBitsToUint(SW_NO_DEPTH);
        systems = findSystems(low, high);
    }
    barrier();
    float least = SW_NO_DEPTH;
    for (uint row = first.y; row < first.y + SW_SLICE_HEIGHT; ++row)
    {
        Ground ground = NO_GROUND;
        if (hasGround)
        {
            SeaPlace place = placeOfTexel(slice, column, row);
            vec3 values[2];
            for (uint i = 0; i < 2; ++i)
            {
                values[i] = firstOf(fieldAt(FIELDS[i], 0, place));
            }
            ground = groundBetween(values[0], values[1]);
            least = column < resolution ? min(least, ground.depth) : least;
        }
        if (WITH_GROUND && column < resolution)
        {
            imageStore(places, ivec3(column, row, gl_WorkGroupID.z), vec4(ground.depth, ground.slope, ground.level));
        }
    }
    atomicMin(leastDepth, floatBitsToUint(max(least, 0.0)));
    barrier();
    if (gl_LocalInvocationIndex == 0)
    {
        uint block = (gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y) * gl_NumWorkGroups.x + gl_WorkGroupID.x;
        blocks[block] = swFieldBlock(uintBitsToFloat(leastDepth), systems);
    }
}
