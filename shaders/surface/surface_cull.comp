// SPDX-License-Identifier: MIT
// The mesh tiles that the camera may see, in their order, and the arguments of the one indirect draw. A single
// workgroup does all, since there are never more tiles than workers.
//
// A tile is drawn for the sea, and once for each body of water that it meets: that part of it which may hold water of
// the body. Where the sea is dry but for what inputs leave, tiles that meet none of those are not drawn for the sea.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/fields.h"
#include "shared/picture.h"
#include "shared/mesh.h"

layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 1) readonly buffer Slices
{
    swMeshSlice slices[];
};
layout(std430, binding = 2) readonly buffer Tiles
{
    swMeshTile tiles[];
};
layout(std430, binding = 3) writeonly buffer Visible
{
    swMeshTile visible[];
};
layout(std430, binding = 4) writeonly buffer Arguments
{
    uint indexCount, instanceCount, firstIndex;
    int vertexOffset;
    uint firstInstance;
};

layout(std430, binding = 5) readonly buffer Bodies
{
    swMeshBody bodies[];
};
layout(std430, binding = 16) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 17) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 18) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 19) readonly buffer InputWords
{
    float inputWords[];
};
#include "lib/inputs.glsl"

shared uint keep[256];

// Outside if all corners of the box lie beyond one side of the view. Without a far plane there are five.
bool isOutside(vec3 low, vec3 high)
{
    uint outside = 31;
    for (int i = 0; i < 8; ++i)
    {
        vec3 corner = vec3((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
        vec4 c = picture.clip[0] * corner.x + picture.clip[1] * corner.y + picture.clip[2] * corner.z + picture.clip[3];
        outside &= (c.x < -c.w ? 1u : 0u) | (c.x > c.w ? 2u : 0u) | (c.y < -c.w ? 4u : 0u) | (c.y > c.w ? 8u : 0u) |
                   (c.w < 0.0 ? 16u : 0u);
    }
    return outside != 0;
}

// Whether inputs leave water in a rectangle, m from the anchor, of a sea that is dry.
bool hasWater(vec2 low, vec2 high)
{
    ivec2 cell = ivec2(picture.anchorCellX, picture.anchorCellZ);
    vec2 rest = vec2(picture.anchorRestX, picture.anchorRestZ);
    return findInput(SW_FIELD_OF_CLIP, seaPlaceOf(cell, rest + low).cell, seaPlaceOf(cell, rest + high).cell,
                     picture.firstHole) != SW_NO_RECORD;
}

// The strip beyond the last ring is level.
bool isStripVisible()
{
    return picture.isDry == 0 ||
           inputHead.ranges[SW_FIELD_OF_CLIP].firstRecord + inputHead.ranges[SW_FIELD_OF_CLIP].recordCount >
               picture.firstHole;
}

// Between the levels `lowest` and `highest`, of the sea (`isSea`) or of a body.
bool isVisible(swMeshTile tile, float lowest, float highest, bool isSea)
{
    if (tile.ring >= picture.ringCount)
    {
        return !isSea || isStripVisible();
    }
    swMeshSlice slice = slices[tile.ring];
    vec2 origin = vec2(slice.originX, slice.originZ);
    // A morphing vertex moves by at most one step.
    vec2 low = origin + (vec2(tile.x, tile.z) - 1.0) * slice.scale;
    vec2 high = origin + (vec2(tile.x + tile.width, tile.z + tile.height) + 1.0) * slice.scale;
    vec2 anchor = vec2(picture.anchorX, picture.anchorZ);
    low = low * picture.step - picture.horizontalReach;
    high = high * picture.step + picture.horizontalReach;
    if (isSea && picture.isDry != 0 && !hasWater(low, high))
    {
        return false;
    }
    low += anchor;
    high += anchor;
    float farthest = length(max(abs(low), abs(high)));
    float drop = swMeshDrop(farthest, picture.flatDistance, picture.earthRadius);
    return !isOutside(vec3(low.x, picture.seaY + lowest - picture.verticalReach - drop, low.y),
                      vec3(high.x, picture.seaY + highest + picture.verticalReach, high.y));
}

// The part of a tile that may hold water of a body; without one its width is 0.
swMeshTile cutToBody(swMeshTile tile, int body)
{
    vec2 low = vec2(bodies[body].lowX, bodies[body].lowZ) - picture.horizontalReach;
    vec2 high = vec2(bodies[body].highX, bodies[body].highZ) + picture.horizontalReach;
    swMeshSlice slice = slices[min(tile.ring, picture.ringCount - 1)];
    vec2 origin = vec2(slice.originX, slice.originZ);
    low = (low / picture.step - origin) / slice.scale;
    high = (high / picture.step - origin) / slice.scale;
    tile.body = body;
    if (tile.ring >= picture.ringCount) // the strip, if the body reaches beyond the last ring
    {
        float side = 4.0 * picture.quads;
        bool isInside = all(greaterThan(low, vec2(0.0))) && all(lessThan(high, vec2(side)));
        tile.width = isInside ? 0 : tile.width;
        return tile;
    }
    // A morphing vertex moves by at most one step.
    ivec2 first = max(ivec2(clamp(floor(low), -1e6, 1e6)) - 1, ivec2(tile.x, tile.z));
    ivec2 last = min(ivec2(clamp(ceil(high), -1e6, 1e6)) + 1, ivec2(tile.x + tile.width, tile.z + tile.height));
    tile.x = first.x;
    tile.z = first.y;
    tile.width = last.y > first.y ? max(last.x - first.x, 0) : 0;
    tile.height = max(last.y - first.y, 0);
    return tile;
}

// Writes the instances of a tile from `at` on unless that is SW_NO_RECORD. Returns how many there are.
uint listInstances(swMeshTile tile, uint at)
{
    uint count = 0;
    if (isVisible(tile, picture.lowestLevel, picture.highestLevel, true))
    {
        count = 1;
        if (at != SW_NO_RECORD)
        {
            visible[at] = tile;
        }
    }
    for (int body = 0; body < int(picture.bodyCount); ++body)
    {
        swMeshTile part = cutToBody(tile, body);
        bool setsLevel = bodies[body].setsLevel != 0;
        float lowest = setsLevel ? bodies[body].level : picture.lowestLevel;
        float highest = setsLevel ? bodies[body].level : picture.highestLevel;
        if (part.width > 0 && isVisible(part, lowest, highest, false))
        {
            if (at != SW_NO_RECORD)
            {
                visible[at + count] = part;
            }
            count += 1;
        }
    }
    return count;
}

void main()
{
    uint i = gl_LocalInvocationIndex;
    keep[i] = i < picture.tileCount ? listInstances(tiles[i], SW_NO_RECORD) : 0;
    barrier();
    uint before = 0;
    for (uint k = 0; k < i; ++k)
    {
        before += keep[k];
    }
    if (keep[i] > 0)
    {
        listInstances(tiles[i], before);
    }
    if (i == 255)
    {
        indexCount = 6 * picture.tileSide * picture.tileSide;
        instanceCount = before + keep[255];
        firstIndex = 0;
        vertexOffset = 0;
        firstInstance = 0;
    }
}
