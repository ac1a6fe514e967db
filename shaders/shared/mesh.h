// SPDX-License-Identifier: MIT
// Where a vertex of the surface mesh lies. The mesh is concentric square rings, ring i on the lattice of slice i:
// vertices stand two texels apart, on texel centres. Towards a ring's outer edge its odd vertices slide onto even ones,
// which are the next ring's vertices, and its data blend into the next slice's; so rings meet without a crack, and a
// ring that moves on by whole cells changes nothing that can be seen.
//
// All coordinates are whole steps of the finest ring, counted from an anchor near the viewer. They stay below 2^24,
// steps are powers of two, and a blend of 0 or 1 is exact: two rings that share a vertex compute the same bits for it.
#ifndef SW_SHARED_MESH_H
#define SW_SHARED_MESH_H
#include "types.h"

// One ring and its slice.
SW_PARAMS(swMeshSlice)
{
    sw_int originX, originZ; // first vertex of the block, finest steps from the anchor
    sw_int phaseX, phaseZ;   // that vertex's index on the world's lattice, modulo 4
    sw_int texelX, texelZ;   // that vertex's texel in the slice
    float scale;             // finest steps to one step of this ring: 2^ring
    float weight;            // how much of the slice's waves is shown
    float layer;             // the slice's number, as samplers take it
};
SW_PARAMS_SIZE(swMeshSlice, 36);

// A rectangle of one ring, at most swMeshParams::tileSide quads wide and high. Ring == sliceCount is the horizon strip:
// x counts steps along the rim, z along the ray to the horizon, and height says which side of the rim (0 .. 3).
SW_PARAMS(swMeshTile)
{
    sw_uint ring;
    sw_int x, z; // first vertex within the block
    sw_int width, height;
    sw_int body; // of the picture's list, the one that it is a part of; SW_NO_MESH_BODY: of none
};
SW_PARAMS_SIZE(swMeshTile, 24);

#define SW_NO_MESH_BODY (-1)

// A body of water. It is drawn by itself: the tiles that meet it are drawn once more, at its level, and each pixel of
// them stays inside of its shore. So a level ends at the shore, however coarse the mesh is.
SW_PARAMS(swMeshBody)
{
    float lowX, lowZ, highX, highZ; // bounds, metres from the anchor
    float level;                    // of still water above sea level, m
    sw_int number;                  // that the field BODY has in it
    sw_uint look;                   // of the picture's list
    sw_uint setsLevel;              // 0: it has the level that other inputs say
};
SW_PARAMS_SIZE(swMeshBody, 32);

// Blend into the next ring at a vertex `x`, `z` of the block. `viewX`, `viewZ` are the viewer's place in steps of this
// ring from the block's first vertex, `quads` is a quarter of the block's side. The block is centred on the viewer's
// position rounded down to two steps, so its outer edge lies more than 2 quads - 2 and its inner edge at most quads + 1
// steps from the viewer: half a step of slack on each side makes the blend exactly 1 and 0 there.
SW_FORMULA float swMeshBlend(float x, float z, float viewX, float viewZ, float quads, float fade)
{
    float dx = x < viewX ? viewX - x : x - viewX;
    float dz = z < viewZ ? viewZ - z : z - viewZ;
    float r = dx > dz ? dx : dz;
    float blend = (r - (quads + 1.5f)) / (quads - 4.0f);
    blend = blend > 0.0f ? blend : 0.0f;
    blend = blend + fade;
    return blend < 1.0f ? blend : 1.0f;
}

// Where an odd vertex slides: towards the nearer multiple of four, so that triangles keep their diagonals.
SW_FORMULA float swMeshSlide(sw_int coordinate, sw_int phase)
{
    sw_int residue = (coordinate + phase) & 3;
    return residue == 1 ? -1.0f : (residue == 3 ? 1.0f : 0.0f);
}

// Place of a vertex along one axis, in finest steps from the anchor.
SW_FORMULA float swMeshPlace(sw_int coordinate, sw_int phase, sw_int origin, float scale, float blend)
{
    return SW_FLOAT(origin) + (SW_FLOAT(coordinate) + swMeshSlide(coordinate, phase) * blend) * scale;
}

// Texel coordinate of a place in a slice.
SW_FORMULA float swMeshTexel(float place, sw_int origin, sw_int texel, float scale)
{
    return (place - SW_FLOAT(origin)) * (2.0f / scale) + SW_FLOAT(texel);
}

// How far the sea falls below the tangent plane at a distance, m. The drawn water is flat, as queries have it, up to
// `flatDistance`; beyond, it bends to the earth's radius so that the horizon lies where it should.
SW_FORMULA float swMeshDrop(float distance, float flatDistance, float earthRadius)
{
    float beyond = distance > flatDistance ? distance - flatDistance : 0.0f;
    return beyond * beyond / (2.0f * earthRadius);
}
#endif
