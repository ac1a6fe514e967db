// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"
#include "math.h"

/// @file
/// Hulls: the inside of closed meshes, for cutting the water out of ships, docks and caissons. A hull keeps the signed
/// distance from its mesh on a grid in the mesh's own axes, made once; it may be concave, have cavities and several
/// parts. It never changes once it is made; any number of threads may read it.
///
/// Between the grid's values distances are trilinear. The edge of a hole is then off by at most about a quarter of a
/// spacing along sharp edges of the mesh, and by the square of the spacing times half the curvature on smooth ones.
/// Memory is 4 bytes a value: a ship 6 times as long as wide and high takes some 90 KB at the default resolution, a
/// cube
/// 1.3 MB.

typedef struct swHull swHull;

/// Must be initialized with swDefaultHullDef().
typedef struct swHullDef
{
    /// For messages. At most 255 characters are kept. Default "hull".
    const char* name;

    /// Spacings of the grid along the mesh's longest side. Range [8, 256]. Default 64.
    int resolution;

    /// Corners, m: finite, within 100 km of the mesh's origin. They are read, not kept.
    const swVec3* vertices;
    int vertexCount;

    /// [triangleCount][3], counted from 0; faces run counterclockwise as seen from outside (all of them the other way
    /// round will do as well). Corners at the same place count as one. Each edge has to be shared, so that the mesh is
    /// closed.
    const uint32_t* indices;
    int triangleCount;

    /// Set by swDefaultHullDef().
    int internalValue;
} swHullDef;

SW_API swHullDef swDefaultHullDef(void);
SW_API const swFields* swGetHullFields(void);

/// @return SW_ERROR_INVALID (the host's log says what is wrong: an open mesh, faces turned against each other, NaN, no
/// volume), SW_ERROR_NO_MEMORY. A mesh that crosses itself is taken, with a warning: what it encloses at all is inside.
SW_API swResult swCreateHull(const swHost* host, const swHullDef* def, swHull** hull);

/// Inputs that use it keep it.
SW_API void swDestroyHull(swHull* hull);

typedef struct swHullInfo
{
    const char* name; ///< lives as long as the hull
    swVec3 low, high; ///< corners of the mesh's bounds, m
    float spacing;    ///< of the grid, m
    int countX, countY, countZ;
    bool isSelfCrossing; ///< faces cross or lie inside of others
    bool isInsideOut;    ///< all faces were turned inwards
    size_t memory;       ///< bytes
    uint64_t hash;       ///< of the grid: the same on every machine
} swHullInfo;

SW_API swHullInfo swHull_GetInfo(const swHull* hull);

/// Signed distances from the hull at points of its own axes, m: below 0 inside. NaN at points that are not finite.
SW_API void swHull_Sample(const swHull* hull, int count, const swVec3* points, float* distances);
