// SPDX-License-Identifier: MIT
#include "core/input/hull.h"

#include <math.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/base/misuse.h"
#include "shared/shape_hull.h"

static void writeHead(swHull* hull)
{
    hull->words[0] = hull->grid.low.x;
    hull->words[1] = hull->grid.low.y;
    hull->words[2] = hull->grid.low.z;
    hull->words[3] = hull->grid.spacing;
    swHash hash = swBeginHash();
    swAddHash(&hash, (uint64_t)hull->grid.countX << 32 | (uint64_t)hull->grid.countY);
    swAddHash(&hash, (uint64_t)hull->grid.countZ);
    swAddHashFloats(&hash, hull->words, (size_t)hull->wordCount);
    hull->hash = swEndHash(&hash);
}

static void warnOfMesh(const swHull* hull)
{
    if (hull->grid.isSelfCrossing)
    {
        swLog(&hull->host, SW_LOG_WARNING,
              "%s crosses itself; whatever it encloses is taken as inside, and distances inside are only good near its "
              "outside.",
              hull->name);
    }
}

// The mesh's bounds lie in the middle of the grid.
static void findBounds(swHull* hull, const swHullMesh* mesh)
{
    hull->low = hull->high = mesh->vertices[mesh->indices[0]];
    for (int i = 0; i < 3 * mesh->triangleCount; ++i)
    {
        swVec3 v = mesh->vertices[mesh->indices[i]];
        hull->low = (swVec3){fminf(hull->low.x, v.x), fminf(hull->low.y, v.y), fminf(hull->low.z, v.z)};
        hull->high = (swVec3){fmaxf(hull->high.x, v.x), fmaxf(hull->high.y, v.y), fmaxf(hull->high.z, v.z)};
    }
}

// A hull of a mesh whose corners are joined.
static swResult makeHull(const swHost* host, const swHullMesh* mesh, int resolution, swHull** hull)
{
    swHullGrid grid;
    swResult result = swPlanHullGrid(host, mesh, resolution, &grid);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t head = (sizeof(swHull) + 63) & ~(size_t)63;
    size_t count = (size_t)grid.countX * (size_t)grid.countY * (size_t)grid.countZ + SW_HULL_HEAD;
    size_t size = head + count * sizeof(float);
    swHull* made = swAllocate(host, size);
    if (made == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the grid of %s, %zu bytes.", mesh->name, size);
    }
    *made = (swHull){.host = *host,
                     .references = 1,
                     .grid = grid,
                     .memory = size,
                     .wordCount = (int)count,
                     .words = (float*)((char*)made + head)};
    strncpy(made->name, mesh->name, sizeof(made->name) - 1);
    findBounds(made, mesh);
    result = swFillHullGrid(host, mesh, &made->grid, made->words + SW_HULL_HEAD);
    if (result != SW_SUCCESS)
    {
        swDestroyHull(made);
        return result;
    }
    writeHead(made);
    warnOfMesh(made);
    *hull = made;
    return SW_SUCCESS;
}

swResult swCreateHull(const swHost* host, const swHullDef* def, swHull** hull)
{
    SW_REQUIRE_PLACE(host, hull, "swCreateHull()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE && def->vertices != NULL && def->indices != NULL &&
                   def->vertexCount > 0 && def->triangleCount > 0 && def->triangleCount <= 50000000,
               SW_ERROR_INVALID, host,
               "swCreateHull() needs a def made by swDefaultHullDef(), vertices, and 1 to 50,000,000 triangles");
    swResult result = swCheckDef(host, &swHullFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swHullMesh mesh = {def->name != NULL ? def->name : "hull", def->vertexCount, def->vertices, def->triangleCount,
                       def->indices};
    size_t size = (size_t)def->vertexCount * sizeof(swVec3);
    swVec3* places = swAllocate(host, size);
    result = places != NULL ? swWeldHullMesh(host, &mesh, places)
                            : swFail(host, SW_ERROR_NO_MEMORY, "No memory for the corners of %s.", mesh.name);
    mesh.vertices = places;
    result = result == SW_SUCCESS ? makeHull(host, &mesh, def->resolution, hull) : result;
    swFree(host, places, size);
    return result;
}

void swRetainHull(const swHull* hull)
{
    if (hull != NULL)
    {
        atomic_fetch_add(&((swHull*)hull)->references, 1);
    }
}

void swReleaseHull(const swHull* hull)
{
    if (hull != NULL && atomic_fetch_sub(&((swHull*)hull)->references, 1) == 1)
    {
        swHost host = hull->host;
        swFree(&host, (swHull*)hull, hull->memory);
    }
}

void swDestroyHull(swHull* hull)
{
    swReleaseHull(hull);
}

swHullInfo swHull_GetInfo(const swHull* hull)
{
    SW_REQUIRE(hull != NULL, ((swHullInfo){.name = ""}), NULL, "swHull_GetInfo() needs a hull");
    return (swHullInfo){.name = hull->name,
                        .low = hull->low,
                        .high = hull->high,
                        .spacing = hull->grid.spacing,
                        .countX = hull->grid.countX,
                        .countY = hull->grid.countY,
                        .countZ = hull->grid.countZ,
                        .isSelfCrossing = hull->grid.isSelfCrossing,
                        .isInsideOut = hull->grid.isInsideOut,
                        .memory = hull->memory,
                        .hash = hull->hash};
}

static float sample(const swHull* hull, swVec3 p)
{
    if (!(isfinite(p.x) && isfinite(p.y) && isfinite(p.z)))
    {
        return (float)NAN;
    }
    return swHullDistance(hull->words, (sw_uint)hull->grid.countX, (sw_uint)hull->grid.countY,
                          (sw_uint)hull->grid.countZ, p.x, p.y, p.z)
        .w;
}

void swHull_Sample(const swHull* hull, int count, const swVec3* points, float* distances)
{
    SW_REQUIRE_VOID(hull != NULL && count >= 0 && (count == 0 || (points != NULL && distances != NULL)),
                    hull != NULL ? &hull->host : NULL,
                    "swHull_Sample() needs a hull, points and a place for their distances");
    for (int i = 0; i < count; ++i)
    {
        distances[i] = sample(hull, points[i]);
    }
}
