// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"
#include "math.h"

/// @file
/// Meshes as seen from above: a sea floor, a quay, a shoal, colours on the water. Any triangles will do: they need not
/// be closed, joined or turned the same way. Where several lie above each other, the highest counts. A mesh never
/// changes once it is made; any number of threads may read it. Files of them are read by files.h; the inside of a
/// closed mesh, for cutting water out of a ship, is a swHull.

typedef struct swMesh swMesh;

/// Most triangles, and most numbers that a vertex may have beside its place.
#define SW_MAX_MESH_TRIANGLES 1000000
#define SW_MAX_MESH_CHANNELS 4

/// Must be initialized with swDefaultMeshDef().
typedef struct swMeshDef
{
    /// For messages. At most 255 characters are kept. Default "mesh".
    const char* name;

    /// What lies above this height, in the mesh's own y, is left out: a bridge over a channel is no land. Range [-1e6,
    /// 1e6]. Default 1e6: nothing is left out. A triangle that crosses the height counts up to it.
    float highest;

    /// Corners, m: finite, within 1e6 m of the mesh's origin. Copied.
    const swVec3* vertices;
    int vertexCount;

    /// [triangleCount][3], counted from 0. At most SW_MAX_MESH_TRIANGLES. Triangles without an area as seen from above
    /// (walls) are kept for whoever asks for them, but nothing lies on them. Copied.
    const uint32_t* indices;
    int triangleCount;

    /// [vertexCount][channelCount]: what the mesh says where it is no sea floor, such as a colour. At most 1e6 either
    /// way. Copied. Default NULL, 0: it says 1.
    const float* values;
    int channelCount;

    /// Set by swDefaultMeshDef().
    int internalValue;
} swMeshDef;

SW_API swMeshDef swDefaultMeshDef(void);
SW_API const swFields* swGetMeshFields(void);

/// @return SW_ERROR_INVALID (the host's log names the vertex or the triangle), SW_ERROR_LIMIT (too many triangles above
/// each other), SW_ERROR_NO_MEMORY
SW_API swResult swCreateMesh(const swHost* host, const swMeshDef* def, swMesh** mesh);

/// Inputs that use it keep it.
SW_API void swDestroyMesh(swMesh* mesh);

typedef struct swMeshInfo
{
    const char* name; ///< lives as long as the mesh
    swVec3 low, high; ///< corners of its bounds, m
    float highest;    ///< of the def
    int vertexCount, triangleCount, channelCount;
    size_t memory; ///< bytes
    uint64_t hash; ///< of all that it was made from, bit by bit: the same on every machine
} swMeshInfo;

SW_API swMeshInfo swMesh_GetInfo(const swMesh* mesh);

/// The corners, the triangles and the values as they were given; no values are NULL.
SW_API const swVec3* swMesh_GetVertices(const swMesh* mesh);
SW_API const uint32_t* swMesh_GetIndices(const swMesh* mesh);
SW_API const float* swMesh_GetValues(const swMesh* mesh);

/// Heights of the mesh as seen from above, in its own coordinates: exact on each triangle, without a gap where two
/// share an edge. NaN where there is no triangle, and at points that are not finite. The same bits on every machine.
SW_API void swMesh_Sample(const swMesh* mesh, int count, const swVec2* points, float* heights);
