// SPDX-License-Identifier: MIT
// Land and sea floor as the stage draws them: square tiles of one grid, which slide into the grid of twice the spacing
// with distance, so that neighbours of different fineness meet without a crack [Strugar 2010].
#ifndef SW_SHARED_TERRAIN_H
#define SW_SHARED_TERRAIN_H
#include "types.h"

// Quads along a tile's side: even, so that every other vertex is one of the coarser grid.
#define SW_TERRAIN_QUADS 32
#define SW_TERRAIN_SIDE (SW_TERRAIN_QUADS + 1)

SW_PARAMS(swTerrainTile)
{
    float x, z;                // of the first vertex from the camera, m
    float spacing;             // m
    sw_uint firstVertex;       // in the buffer of vertices
    float slideFrom, slideEnd; // distances between which the tile becomes the coarser grid, m
    float unused0, unused1;
};
SW_PARAMS_SIZE(swTerrainTile, 32);

SW_PARAMS(swTerrainVertex)
{
    float height;      // absolute, m
    float known;       // 1; 0 where there is no floor
    sw_uint slopes;    // along x and z, two half floats
    sw_uint farSlopes; // as the coarser grid has them
};
SW_PARAMS_SIZE(swTerrainVertex, 16);

SW_PARAMS(swTerrainPush)
{
    float cameraY;        // absolute, m
    float eyeHeight;      // of distances, m
    float wetHeight;      // above sea level that waves keep wet, m
    float placeX, placeZ; // of the camera, for patterns that lie still, m
    float unused0, unused1, unused2;
};
SW_PARAMS_SIZE(swTerrainPush, 32);
#endif
