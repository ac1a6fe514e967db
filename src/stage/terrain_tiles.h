// SPDX-License-Identifier: MIT
#pragma once

// Which tiles of the land a camera sees, and their vertices, sampled once and kept.

#include "seaway/stage.h"
#include "shared/terrain.h"
#include "stage/stage_base.h"

#define SW_TERRAIN_SLOTS 1024
#define SW_TERRAIN_LEVELS 20
#define SW_TERRAIN_VERTICES (SW_TERRAIN_SIDE * SW_TERRAIN_SIDE)

// A square of the plane: side 2^level times the finest, x and z count such squares.
typedef struct swTerrainKey
{
    int64_t x, z;
    int level;
} swTerrainKey;

typedef struct swTerrainSlot
{
    swTerrainKey key;
    bool isFilled;
    bool isEmpty;      // no floor anywhere on it
    uint64_t lastUsed; // frame
} swTerrainSlot;

typedef struct swTerrainTiles
{
    swStageFloorFcn* floor;
    void* context;
    double finestSide; // m
    double reach;      // m
    int levelCount;
    uint64_t frame;
    int hash[2 * SW_TERRAIN_SLOTS]; // slot + 1, open addressing; 0 is free
    swTerrainSlot slots[SW_TERRAIN_SLOTS];
    swTerrainVertex* vertices; // [SW_TERRAIN_SLOTS][SW_TERRAIN_VERTICES]
} swTerrainTiles;

void swForgetTerrain(swTerrainTiles* tiles);

// Tiles that the camera sees, at most `capacity`, from its place in double. `eyeHeight` counts in distances.
int swChooseTerrain(swTerrainTiles* tiles, const swCamera* camera, double eyeHeight, swTerrainTile* chosen,
                    int capacity);
