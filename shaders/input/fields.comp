// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Authored fields at every texel of every slice of a view: the twin of core/surface/fields.c. A workgroup makes the
// block of texels that one of slices.comp adds up waves for, and tells it what shapes waves there.
//
// Of a block that no input touches only the layers' texels are written.

#include "shared/fields.h"
#include "shared/foam.h"

layout(local_size_x = SW_SLICE_WIDTH) in;
layout(constant_id = 0) const bool WITH_GROUND = true; // the layer of depths is made
layout(constant_id = 1) const bool WITH_FLOW = true;   // the layers of flow are

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
layout(std430, binding = 5) buffer Blocks
{
    swFieldBlock blocks[];
};
layout(binding = 6, rgba32f) uniform image2DArray places;     // depth, its slopes along x and z, level
layout(binding = 7, rgba32f) uniform image2DArray flow;       // velocity along x and z
layout(binding = 8, rgba16f) uniform image2DArray flowSlopes; // of that along x by x and z, of that along z
layout(std430, binding = 9) readonly buffer Redraws
{
    swFieldRedraw redraws[]; // of each slice
};
// The same of slices that have moved, as they were.
layout(binding = 10, rgba32f) uniform readonly image2DArray placesBefore;
layout(binding = 11, rgba32f) uniform readonly image2DArray flowBefore;
layout(binding = 12, rgba16f) uniform readonly image2DArray flowSlopesBefore;
layout(push_constant) uniform Push
{
    uint resolution;
};

// As bits: neither is below 0.
shared uint leastDepth;
shared uint leastShore;
shared uint systems;
shared uint flags;
shared uint foam;

#include "lib/inputs.glsl"
#include "lib/places.glsl"

const uint FIELDS[3] = {SW_FIELD_OF_LEVEL, SW_FIELD_OF_FLOOR, SW_FIELD_OF_FLOW};

// What the layers want of a texel.
struct Fields
{
    Ground ground;
    Flow flow;
};
const Fields NO_FIELDS = Fields(NO_GROUND, STILL);

Fields fieldsAt(SeaPlace place, bool hasGround, bool hasFlow)
{
    Fields fields = NO_FIELDS;
    vec3 level = vec3(0.0);
    for (uint i = hasGround ? 0 : 2; i < (hasFlow ? 3 : 2); ++i)
    {
        swInputValue value = fieldAt(FIELDS[i], 0, place);
        if (i == 0)
        {
            level = firstOf(value);
        }
        else if (i == 1)
        {
            fields.ground = groundBetween(level, firstOf(value));
        }
        else
        {
            fields.flow = flowOf(value);
        }
    }
    return fields;
}

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

// Inputs that stay put are read where waves have brought the water, from the next cell perhaps.
uint findDisplaced(ivec2 low, ivec2 high)
{
    return touchesInputs(SW_FIELD_OF_DISPLACEMENT, low - 1, high + 1) ? SW_BLOCK_DISPLACED : 0u;
}

// Likewise.
uint findFoam(ivec2 low, ivec2 high)
{
    return touchesInputs(SW_FIELD_OF_FOAM, low - 1, high + 1) ? SW_BLOCK_MAKES_FOAM : 0u;
}

void store(ivec3 texel, Fields fields)
{
    if (WITH_GROUND)
    {
        imageStore(places, texel, vec4(fields.ground.depth, fields.ground.slope, fields.ground.level));
    }
    if (WITH_FLOW)
    {
        imageStore(flow, texel, vec4(fields.flow.velocity, 0.0, 0.0));
        imageStore(flowSlopes, texel, fields.flow.slopes);
    }
}

// First column and row, column and row behind.
ivec4 rectOf(uint slice, uint i)
{
    return ivec4(redraws[slice].rects[4 * i], redraws[slice].rects[4 * i + 1], redraws[slice].rects[4 * i + 2],
                 redraws[slice].rects[4 * i + 3]);
}

// Whether a texel of the slice is to be made.
bool isNew(uint slice, ivec2 texel)
{
    bool found = false;
    for (uint i = 0; i < redraws[slice].count; ++i)
    {
        ivec4 rect = rectOf(slice, i);
        found = found || (all(greaterThanEqual(texel, rect.xy)) && all(lessThan(texel, rect.zw)));
    }
    return found;
}

// Whether any of a block is.
bool hasNew(uint slice, ivec2 low, ivec2 high)
{
    bool found = false;
    for (uint i = 0; i < redraws[slice].count; ++i)
    {
        ivec4 rect = rectOf(slice, i);
        found = found || (all(lessThanEqual(rect.xy, high)) && all(greaterThan(rect.zw, low)));
    }
    return found;
}

// What is kept of a texel: from where it is, or of a slice that has moved from where it was.
Fields keptAt(ivec3 texel, ivec2 shift)
{
    bool isMoved = any(notEqual(shift, ivec2(0)));
    ivec3 from = texel + ivec3(shift, 0);
    Fields fields = NO_FIELDS;
    if (WITH_GROUND)
    {
        vec4 place = isMoved ? imageLoad(placesBefore, from) : imageLoad(places, from);
        fields.ground = Ground(place.x, place.yz, place.w);
    }
    if (WITH_FLOW)
    {
        fields.flow.velocity = isMoved ? imageLoad(flowBefore, from).xy : imageLoad(flow, from).xy;
        fields.flow.slopes = isMoved ? imageLoad(flowSlopesBefore, from) : imageLoad(flowSlopes, from);
    }
    return fields;
}

void main()
{
    uint at = gl_WorkGroupID.z;
    swFieldSlice slice = slices[at];
    if (redraws[at].isStill != 0)
    {
        return;
    }
    uint column = gl_GlobalInvocationID.x;
    uvec2 first = gl_WorkGroupID.xy * uvec2(SW_SLICE_WIDTH, SW_SLICE_HEIGHT);
    uint block = (at * gl_NumWorkGroups.y + gl_WorkGroupID.y) * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    ivec2 low = placeOfTexel(slice, first.x, first.y).cell;
    ivec2 high = placeOfTexel(slice, first.x + SW_SLICE_WIDTH - 1, first.y + SW_SLICE_HEIGHT - 1).cell;
    ivec2 shift = ivec2(redraws[at].shiftX, redraws[at].shiftZ);
    bool isKept =
        shift == ivec2(0) && !hasNew(at, ivec2(first), ivec2(first) + ivec2(SW_SLICE_WIDTH, SW_SLICE_HEIGHT) - 1);
    if (isKept)
    {
        if (gl_LocalInvocationIndex == 0)
        {
            // Inputs of waves, of displacement and of foam may have changed all the same.
            blocks[block].systems = findSystems(low, high);
            blocks[block].flags = (blocks[block].flags & SW_BLOCK_FLOWS) | findDisplaced(low, high);
            blocks[block].foam = (blocks[block].foam & SW_BLOCK_CARRIES_FOAM) | findFoam(low, high);
        }
        return;
    }
    bool hasGround = touchesInputs(SW_FIELD_OF_FLOOR, low, high) || touchesInputs(SW_FIELD_OF_LEVEL, low, high);
    bool hasFlow = WITH_FLOW && touchesInputs(SW_FIELD_OF_FLOW, low, high);
    if (gl_LocalInvocationIndex == 0)
    {
        leastDepth = floatBitsToUint(SW_NO_DEPTH);
        leastShore = floatBitsToUint(SW_NO_DEPTH);
        systems = findSystems(low, high);
        flags = findDisplaced(low, high);
        foam = findFoam(low, high);
    }
    barrier();
    float least = SW_NO_DEPTH, shore = SW_NO_DEPTH;
    bool flows = false, carries = false;
    for (uint row = first.y; row < first.y + SW_SLICE_HEIGHT && column < resolution; ++row)
    {
        ivec3 texel = ivec3(column, row, at);
        bool isMade = isNew(at, texel.xy);
        Fields fields = NO_FIELDS;
        if (isMade && (hasGround || hasFlow))
        {
            fields = fieldsAt(placeOfTexel(slice, column, row), hasGround, hasFlow);
        }
        if (!isMade)
        {
            fields = keptAt(texel, shift);
        }
        least = min(least, fields.ground.depth);
        vec2 slope = fields.ground.slope;
        shore = min(shore, swFindShoreDistance(fields.ground.depth, slope.x, slope.y));
        flows = flows || isMoved(besideEven(fields.flow));
        carries = carries || isMoved(fields.flow);
        if (isMade || shift != ivec2(0))
        {
            store(texel, fields);
        }
    }
    if (flows)
    {
        atomicOr(flags, SW_BLOCK_FLOWS);
    }
    if (carries)
    {
        atomicOr(foam, SW_BLOCK_CARRIES_FOAM);
    }
    atomicMin(leastDepth, floatBitsToUint(max(least, 0.0)));
    atomicMin(leastShore, floatBitsToUint(shore));
    barrier();
    if (gl_LocalInvocationIndex == 0)
    {
        blocks[block] = swFieldBlock(uintBitsToFloat(leastDepth), systems, flags, uintBitsToFloat(leastShore), foam);
    }
}
