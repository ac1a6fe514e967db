// SPDX-License-Identifier: MIT
// A vertex of the surface: an instance is a tile of a ring, the vertex index a corner of its grid. Smaller tiles fold
// the rest of the grid into their last row and column, where its triangles have no area.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/fields.h"
#include "shared/picture.h"
#include "shared/mesh.h"

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
layout(binding = 3) uniform sampler2DArray displacement;
layout(binding = 15) uniform sampler2DArray places; // depth of still water, its slopes, its level

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
layout(std430, binding = 22) readonly buffer Bodies
{
    swMeshBody bodies[];
};
#include "lib/holes.glsl"

// 1 where inputs say how deep the water is, or how high it stands.
layout(constant_id = 3) const uint hasPlaces = 0;
// 1 where there are bodies of water.
layout(constant_id = 7) const uint hasBodies = 0;

layout(location = 0) out vec2 place;    // at rest, finest steps from the anchor
layout(location = 1) out vec3 position; // displaced, metres from the camera
layout(location = 2) out float blend;
layout(location = 3) out float height; // of the displaced point above sea level, m
layout(location = 4) flat out uint ring;
layout(location = 5) flat out int body; // of the list, or SW_NO_MESH_BODY

// Bilinear by hand: filtering hardware rounds its weights, and most vertices lie on a texel anyway.
vec4 layerAt(sampler2DArray layer, uint index, vec2 at)
{
    swMeshSlice slice = slices[index];
    vec2 texel = vec2(swMeshTexel(at.x, slice.originX, slice.texelX, slice.scale),
                      swMeshTexel(at.y, slice.originZ, slice.texelZ, slice.scale));
    texel = clamp(texel, vec2(0.0), vec2(float(picture.resolution) - 1.0));
    vec2 low = floor(texel);
    vec2 f = texel - low;
    ivec3 t = ivec3(ivec2(low), int(index));
    vec4 value = texelFetch(layer, t, 0);
    if (f.x > 0.0 || f.y > 0.0)
    {
        ivec2 next = min(t.xy + 1, ivec2(int(picture.resolution) - 1));
        vec4 b = texelFetch(layer, ivec3(next.x, t.y, t.z), 0);
        vec4 c = texelFetch(layer, ivec3(t.x, next.y, t.z), 0);
        vec4 d = texelFetch(layer, ivec3(next, t.z), 0);
        value = mix(mix(value, b, f.x), mix(c, d, f.x), f.y);
    }
    return value;
}

// What waves do at a place of a ring: of its slice and the next, as far as each is shown; the rest is at rest.
vec3 offsetAt(uint ring, vec2 at)
{
    vec3 offset = vec3(0.0);
    float fine = (1.0 - blend) * slices[ring].weight;
    if (fine > 0.0)
    {
        offset += fine * layerAt(displacement, ring, at).xyz;
    }
    if (blend > 0.0 && ring + 1 < picture.ringCount)
    {
        offset += blend * slices[ring + 1].weight * layerAt(displacement, ring + 1, at).xyz;
    }
    return offset;
}

// How high still water stands, m above sea level, at a place of a ring. Slices know nothing of shores: near one their
// levels are mixed, so a body has its own, and what lies between bodies is asked without them.
float levelAt(uint ring, vec2 at)
{
    if (hasBodies != 0 && body != SW_NO_MESH_BODY && bodies[body].setsLevel != 0)
    {
        return bodies[body].level;
    }
    if (hasBodies != 0)
    {
        return levelBetweenBodies(seaPlaceOf(ivec2(picture.anchorCellX, picture.anchorCellZ),
                                             vec2(picture.anchorRestX, picture.anchorRestZ) + at * picture.step))
            .x;
    }
    float level = layerAt(places, ring, at).w;
    return blend > 0.0 && ring + 1 < picture.ringCount ? mix(level, layerAt(places, ring + 1, at).w, blend) : level;
}

void placeOnRing(swMeshTile tile, ivec2 corner)
{
    swMeshSlice slice = slices[tile.ring];
    ivec2 at = ivec2(tile.x, tile.z) + min(corner, ivec2(tile.width, tile.height));
    vec2 view = (vec2(picture.viewX, picture.viewZ) - vec2(slice.originX, slice.originZ)) / slice.scale;
    blend = swMeshBlend(float(at.x), float(at.y), view.x, view.y, picture.quads, tile.ring == 0 ? picture.fade : 0.0);
    place = vec2(swMeshPlace(at.x, slice.phaseX, slice.originX, slice.scale, blend),
                 swMeshPlace(at.y, slice.phaseZ, slice.originZ, slice.scale, blend));

    vec3 offset = offsetAt(tile.ring, place);
    vec2 rest = place * picture.step + vec2(picture.anchorX, picture.anchorZ);
    position = vec3(rest.x + offset.x, picture.seaY + offset.y, rest.y + offset.z);
    height = offset.y;
    if (hasPlaces != 0 || hasBodies != 0) // the level is that of where the water is, not of where it rests
    {
        position.y += levelAt(tile.ring, place + offset.xz / picture.step);
    }
}

// The strip continues the rim along rays from the viewer, farther by a constant factor with each row.
void placeOnHorizon(swMeshTile tile, ivec2 corner)
{
    uint last = picture.ringCount - 1;
    swMeshSlice slice = slices[last];
    int side = 4 * int(picture.quads);
    int along = 2 * (tile.x + min(corner.x, tile.width));
    ivec2 at = ivec2(along, 0);
    at = tile.height == 1 ? ivec2(side, along) : at;
    at = tile.height == 2 ? ivec2(side - along, side) : at;
    at = tile.height == 3 ? ivec2(0, side - along) : at;
    place = vec2(swMeshPlace(at.x, slice.phaseX, slice.originX, slice.scale, 1.0),
                 swMeshPlace(at.y, slice.phaseZ, slice.originZ, slice.scale, 1.0));
    blend = 1.0;
    if (corner.y > 0)
    {
        float row = float(corner.y) / float(picture.tileSide);
        vec2 view = vec2(picture.viewX, picture.viewZ);
        place = view + (place - view) * exp2(row * picture.horizonScale);
    }
    vec2 rest = place * picture.step + vec2(picture.anchorX, picture.anchorZ);
    position = vec3(rest.x, picture.seaY, rest.y);
    height = 0.0;
    bool isBody = hasBodies != 0 && body != SW_NO_MESH_BODY;
    if (isBody || ((hasPlaces != 0 || hasBodies != 0) && corner.y == 0)) // a sea does so where it meets the last ring
    {
        position.y += levelAt(last, place);
    }
}

void main()
{
    swMeshTile tile = tiles[gl_InstanceIndex];
    uint row = picture.tileSide + 1;
    ivec2 corner = ivec2(uint(gl_VertexIndex) % row, uint(gl_VertexIndex) / row);
    ring = min(tile.ring, picture.ringCount - 1);
    body = tile.body;
    if (tile.ring < picture.ringCount)
    {
        placeOnRing(tile, corner);
    }
    else
    {
        placeOnHorizon(tile, corner);
    }
    position.y -= swMeshDrop(length(position.xz), picture.flatDistance, picture.earthRadius);
    gl_Position =
        picture.clip[0] * position.x + picture.clip[1] * position.y + picture.clip[2] * position.z + picture.clip[3];
}
