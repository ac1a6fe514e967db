// SPDX-License-Identifier: MIT
#pragma once

// The signed distance from a closed triangle mesh on a grid, see hull_grid.c.

#include "core/base/host.h"
#include "seaway/math.h"

typedef struct swHullMesh
{
    const char* name; // for messages
    int vertexCount;
    const swVec3* vertices;
    int triangleCount;
    const uint32_t* indices; // [triangleCount][3], counterclockwise as seen from outside
} swHullMesh;

typedef struct swHullGrid
{
    swVec3 low; // where the first value lies
    float spacing;
    int countX, countY, countZ;
    bool isSelfCrossing; // faces cross, or lie inside of others
    bool isInsideOut;    // faces were turned inwards
} swHullGrid;

// Where each vertex lies once corners that are as near as floats can tell are at one place, as files of single
// triangles have them. `places` has room for all vertices. The log names a vertex or an index that is no good.
swResult swWeldHullMesh(const swHost* host, const swHullMesh* mesh, swVec3* places);

// The grid's shape for a number of spacings along the mesh's longest side. The log says what is wrong with a mesh that
// has no inside: an open one, one without a volume.
swResult swPlanHullGrid(const swHost* host, const swHullMesh* mesh, int resolution, swHullGrid* grid);

// Fill [countZ][countY][countX] values, m; says whether the mesh crosses itself.
swResult swFillHullGrid(const swHost* host, const swHullMesh* mesh, swHullGrid* grid, float* values);
