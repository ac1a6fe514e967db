// SPDX-License-Identifier: MIT
#pragma once

// The surface mesh of a view: which rectangles of which ring are drawn this frame. See shaders/shared/mesh.h for where
// their vertices lie. No Vulkan here.

#include "core/frame/frame.h"
#include "shared/mesh.h"

// Twelve tiles a ring (four more fill the first one's middle) and eight of the horizon strip.
#define SW_MAX_MESH_TILES (12 * SW_MAX_SLICES + 4 + 8)

typedef struct swMeshRings
{
    int ringCount;           // slices of the view
    int quads;               // d: a quarter of a block's side
    int tileSide;            // d + 1: most quads along a tile's side
    double step;             // of the finest ring, m
    double anchorX, anchorZ; // world position that vertices are counted from, m
    float viewX, viewZ;      // the viewer, finest steps from the anchor
    float fade;              // of the finest ring into the next
    swMeshSlice slices[SW_MAX_SLICES];
    int tileCount;
    swMeshTile tiles[SW_MAX_MESH_TILES];
} swMeshRings;

void swBuildMeshRings(const swViewFrame* frame, swMeshRings* rings);

// Distance from the viewer's axis to the nearest point of the mesh's rim, m.
double swGetMeshRim(const swMeshRings* rings);
