// SPDX-License-Identifier: MIT
#pragma once

// Which triangles lie over which cells of a mesh's plane.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "seaway/math.h"

typedef struct swMeshGrid
{
    double x, z, side; // corner and side of a cell
    int countX, countZ;
    size_t entryCount;
} swMeshGrid;

// Entries that a mesh may have: their numbers are floats.
#define SW_MAX_MESH_ENTRIES (1u << 23)

// Cells about as many as triangles, fewer where that would make too many entries. False if even one cell does.
bool swPlanMeshGrid(const swVec3* vertices, const uint32_t* indices, int triangleCount, float highest, swVec3 low,
                    swVec3 high, swMeshGrid* grid);

// `starts` has room for one more than there are cells, `entries` for all.
void swFillMeshGrid(const swVec3* vertices, const uint32_t* indices, int triangleCount, float highest,
                    const swMeshGrid* grid, float* starts, float* entries);
