// SPDX-License-Identifier: MIT
#pragma once

// Closed meshes for tests of hulls.

#include <math.h>
#include <stdlib.h>

#include <seaway/hull.h>

typedef struct TestMesh
{
    swVec3 vertices[20000];
    uint32_t indices[60000];
    int vertexCount, triangleCount;
} TestMesh;

static inline void AddTriangle(TestMesh* mesh, int a, int b, int c)
{
    uint32_t* to = &mesh->indices[3 * mesh->triangleCount++];
    to[0] = (uint32_t)a;
    to[1] = (uint32_t)b;
    to[2] = (uint32_t)c;
}

static inline void AddQuad(TestMesh* mesh, int a, int b, int c, int d)
{
    AddTriangle(mesh, a, b, c);
    AddTriangle(mesh, a, c, d);
}

// An upright prism over a polygon of the plane, which runs clockwise as seen from above (from x towards z) and may be
// concave: `triangles` are those of its lid, in the same order.
static inline void AddPrism(TestMesh* mesh, int count, const swVec2* outline, int lidCount, const int (*lid)[3],
                            float low, float high)
{
    int first = mesh->vertexCount;
    for (int i = 0; i < count; ++i)
    {
        mesh->vertices[mesh->vertexCount++] = (swVec3){outline[i].x, low, outline[i].y};
        mesh->vertices[mesh->vertexCount++] = (swVec3){outline[i].x, high, outline[i].y};
    }
    for (int i = 0; i < count; ++i)
    {
        int a = first + 2 * i, b = first + 2 * ((i + 1) % count);
        AddQuad(mesh, a, a + 1, b + 1, b);
    }
    for (int i = 0; i < lidCount; ++i)
    {
        AddTriangle(mesh, first + 2 * lid[i][2] + 1, first + 2 * lid[i][1] + 1, first + 2 * lid[i][0] + 1);
        AddTriangle(mesh, first + 2 * lid[i][0], first + 2 * lid[i][1], first + 2 * lid[i][2]);
    }
}

static inline void AddBox(TestMesh* mesh, swVec3 low, swVec3 high)
{
    const swVec2 outline[] = {{low.x, low.z}, {high.x, low.z}, {high.x, high.z}, {low.x, high.z}};
    const int lid[][3] = {{0, 1, 2}, {0, 2, 3}};
    AddPrism(mesh, 4, outline, 2, lid, low.y, high.y);
}

// A dock seen from above: a U that is open to the east, walls 4 m thick, 30 m long, 20 m wide, 10 m high.
static inline void AddDock(TestMesh* mesh)
{
    const swVec2 outline[] = {{-15.0f, -10.0f}, {15.0f, -10.0f}, {15.0f, -6.0f}, {-11.0f, -6.0f},
                              {-11.0f, 6.0f},   {15.0f, 6.0f},   {15.0f, 10.0f}, {-15.0f, 10.0f}};
    const int lid[][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 6}, {4, 6, 7}};
    AddPrism(mesh, 8, outline, 6, lid, -5.0f, 5.0f);
}

// A ring that lies flat: radii of its middle and of its tube.
static inline void AddRing(TestMesh* mesh, float radius, float tube, int around, int along)
{
    int first = mesh->vertexCount;
    for (int i = 0; i < around; ++i)
    {
        for (int j = 0; j < along; ++j)
        {
            float a = 6.2831853f * (float)i / (float)around, b = 6.2831853f * (float)j / (float)along;
            float from = radius + tube * cosf(b);
            mesh->vertices[mesh->vertexCount++] = (swVec3){from * cosf(a), tube * sinf(b), from * sinf(a)};
        }
    }
    for (int i = 0; i < around; ++i)
    {
        for (int j = 0; j < along; ++j)
        {
            int right = (i + 1) % around, up = (j + 1) % along;
            AddQuad(mesh, first + i * along + j, first + i * along + up, first + right * along + up,
                    first + right * along + j);
        }
    }
}

static inline swHullDef MakeHullDef(const TestMesh* mesh, const char* name)
{
    swHullDef def = swDefaultHullDef();
    def.name = name;
    def.vertices = mesh->vertices;
    def.vertexCount = mesh->vertexCount;
    def.indices = mesh->indices;
    def.triangleCount = mesh->triangleCount;
    return def;
}
