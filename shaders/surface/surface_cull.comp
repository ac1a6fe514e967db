// SPDX-License-Identifier: MIT
// The mesh tiles that the camera may see, in their order, and the arguments of the one indirect draw. A single
// workgroup does all, since there are never more tiles than workers.
#version 460
#extension GL_GOOGLE_include_directive : require
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

bool isVisible(swMeshTile tile)
{
    if (tile.ring >= picture.ringCount)
    {
        return true; // the horizon's strip
    }
    swMeshSlice slice = slices[tile.ring];
    vec2 origin = vec2(slice.originX, slice.originZ);
    // A morphing vertex moves by at most one step.
    vec2 low = origin + (vec2(tile.x, tile.z) - 1.0) * slice.scale;
    vec2 high = origin + (vec2(tile.x + tile.width, tile.z + tile.height) + 1.0) * slice.scale;
    vec2 anchor = vec2(picture.anchorX, picture.anchorZ);
    low = low * picture.step + anchor - picture.horizontalReach;
    high = high * picture.step + anchor + picture.horizontalReach;
    float farthest = length(max(abs(low), abs(high)));
    float drop = swMeshDrop(farthest, picture.flatDistance, picture.earthRadius);
    return !isOutside(vec3(low.x, picture.seaY - picture.verticalReach - drop, low.y),
                      vec3(high.x, picture.seaY + picture.verticalReach, high.y));
}

void main()
{
    uint i = gl_LocalInvocationIndex;
    bool seen = i < picture.tileCount && isVisible(tiles[i]);
    keep[i] = seen ? 1u : 0u;
    barrier();
    uint before = 0;
    for (uint k = 0; k < i; ++k)
    {
        before += keep[k];
    }
    if (seen)
    {
        visible[before] = tiles[i];
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
