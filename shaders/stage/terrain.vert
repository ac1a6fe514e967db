// SPDX-License-Identifier: MIT
// A vertex of the land: an instance is a tile, the vertex index a corner of its grid.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/mesh.h"
#include "shared/picture.h"
#include "shared/terrain.h"

layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 3) readonly buffer Tiles
{
    swTerrainTile tiles[];
};
layout(std430, binding = 4) readonly buffer Vertices
{
    swTerrainVertex vertices[];
};
layout(push_constant) uniform Push
{
    swTerrainPush push;
};

layout(location = 0) out vec3 position; // m from the camera, before the earth's curve
layout(location = 1) out vec2 slopes;
layout(location = 2) out float known;

void main()
{
    swTerrainTile tile = tiles[gl_InstanceIndex];
    uvec2 corner = uvec2(uint(gl_VertexIndex) % SW_TERRAIN_SIDE, uint(gl_VertexIndex) / SW_TERRAIN_SIDE);
    uvec2 even = corner & ~1u;
    swTerrainVertex own = vertices[tile.firstVertex + corner.y * SW_TERRAIN_SIDE + corner.x];
    swTerrainVertex far = vertices[tile.firstVertex + even.y * SW_TERRAIN_SIDE + even.x];
    vec2 start = vec2(tile.x, tile.z);
    vec2 place = start + vec2(corner) * tile.spacing;
    float range = length(vec3(place.x, push.eyeHeight, place.y));
    float slide = clamp((range - tile.slideFrom) / (tile.slideEnd - tile.slideFrom), 0.0, 1.0);
    place = mix(place, start + vec2(even) * tile.spacing, slide);
    position = vec3(place.x, mix(own.height, far.height, slide) - push.cameraY, place.y);
    slopes = mix(unpackHalf2x16(own.slopes), unpackHalf2x16(far.farSlopes), slide);
    known = mix(own.known, far.known, slide);
    float y = position.y - swMeshDrop(length(place), picture.flatDistance, picture.earthRadius);
    gl_Position = picture.clip[0] * position.x + picture.clip[1] * y + picture.clip[2] * position.z + picture.clip[3];
}
