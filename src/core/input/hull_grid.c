// SPDX-License-Identifier: MIT
// A grid of signed distances from a mesh. Near its faces each value is the exact distance from the nearest triangle;
// farther off, neighbours hand on which triangle was nearest to them, in sweeps over the grid [Zhao 2005], and the
// distance from that one is exact again.
//
// The sign comes from winding numbers: along each line of the grid in x, faces that are entered count one up, faces
// that are left one down. That is exact for a closed mesh, concave or of many parts. Where it is neither 0 nor 1 the
// mesh crosses itself: what has any winding is inside, and places inside take their distances from what is nearest to
// places outside, so that faces in the middle count for nothing.

#include "core/input/hull_grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PAD 2 // spacings around the mesh
#define NO_TRIANGLE (-1)

// ---- is it a mesh that has an inside ----

typedef struct Edge
{
    swVec3 low, high; // its ends in order of place
    int way;          // +1: its triangle runs from low to high
} Edge;

static int comparePlaces(const swVec3* a, const swVec3* b)
{
    const float pairs[3][2] = {{a->x, b->x}, {a->y, b->y}, {a->z, b->z}};
    for (int i = 0; i < 3; ++i)
    {
        if (pairs[i][0] != pairs[i][1])
        {
            return pairs[i][0] < pairs[i][1] ? -1 : 1;
        }
    }
    return 0;
}

static int compareEdges(const void* first, const void* second)
{
    const Edge *a = first, *b = second;
    int low = comparePlaces(&a->low, &b->low);
    return low != 0 ? low : comparePlaces(&a->high, &b->high);
}

static const swVec3* getCorner(const swHullMesh* mesh, int triangle, int corner)
{
    return &mesh->vertices[mesh->indices[3 * (size_t)triangle + (size_t)corner]];
}

static swResult checkNumbers(const swHost* host, const swHullMesh* mesh)
{
    for (int i = 0; i < mesh->vertexCount; ++i)
    {
        const swVec3* v = &mesh->vertices[i];
        if (!(fabsf(v->x) <= 1e5f && fabsf(v->y) <= 1e5f && fabsf(v->z) <= 1e5f))
        {
            return swFail(host, SW_ERROR_INVALID,
                          "%s has vertex %d, counted from 0, at (%g, %g, %g); a hull's vertices are finite and within "
                          "100 km of its origin.",
                          mesh->name, i, (double)v->x, (double)v->y, (double)v->z);
        }
    }
    for (int i = 0; i < 3 * mesh->triangleCount; ++i)
    {
        if (mesh->indices[i] >= (uint32_t)mesh->vertexCount)
        {
            return swFail(host, SW_ERROR_INVALID, "%s has index %u in triangle %d, counted from 0, but %d vertices.",
                          mesh->name, mesh->indices[i], i / 3, mesh->vertexCount);
        }
    }
    return SW_SUCCESS;
}

// ---- corners at one place ----

typedef struct Key
{
    double along; // a direction in which no mesh is flat
    int vertex;
} Key;

static int compareKeys(const void* first, const void* second)
{
    const Key *a = first, *b = second;
    if (a->along != b->along)
    {
        return a->along < b->along ? -1 : 1;
    }
    return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

static void weld(const swHullMesh* mesh, Key* keys, double tolerance, swVec3* places)
{
    int first = 0;
    for (int i = 0; i < mesh->vertexCount; ++i)
    {
        swVec3 v = mesh->vertices[keys[i].vertex];
        swVec3* place = &places[keys[i].vertex];
        *place = v;
        while (keys[i].along - keys[first].along > 2.0 * tolerance)
        {
            first += 1;
        }
        for (int k = first; k < i; ++k)
        {
            swVec3 other = places[keys[k].vertex];
            if (fabs((double)v.x - (double)other.x) <= tolerance && fabs((double)v.y - (double)other.y) <= tolerance &&
                fabs((double)v.z - (double)other.z) <= tolerance)
            {
                *place = other;
                break;
            }
        }
    }
}

swResult swWeldHullMesh(const swHost* host, const swHullMesh* mesh, swVec3* places)
{
    swResult result = checkNumbers(host, mesh);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t size = (size_t)mesh->vertexCount * sizeof(Key);
    Key* keys = swAllocate(host, size);
    if (keys == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to join the corners of %s.", mesh->name);
    }
    double most = 0.0;
    for (int i = 0; i < mesh->vertexCount; ++i)
    {
        swVec3 v = mesh->vertices[i];
        keys[i] = (Key){0.57 * (double)v.x + 0.31 * (double)v.y + 0.76 * (double)v.z, i};
        double farthest = fmax(fabs((double)v.x), fmax(fabs((double)v.y), fabs((double)v.z)));
        most = farthest > most ? farthest : most; // fmax() here ends GCC 12 for AArch64 with an internal error
    }
    qsort(keys, (size_t)mesh->vertexCount, sizeof(Key), compareKeys);
    weld(mesh, keys, 2e-6 * most, places);
    swFree(host, keys, size);
    return SW_SUCCESS;
}

// ---- edges ----

static size_t listEdges(const swHullMesh* mesh, Edge* edges)
{
    size_t count = 0;
    for (int i = 0; i < mesh->triangleCount; ++i)
    {
        for (int corner = 0; corner < 3; ++corner)
        {
            const swVec3* from = getCorner(mesh, i, corner);
            const swVec3* to = getCorner(mesh, i, (corner + 1) % 3);
            int order = comparePlaces(from, to);
            if (order != 0)
            {
                edges[count++] = order < 0 ? (Edge){*from, *to, 1} : (Edge){*to, *from, -1};
            }
        }
    }
    qsort(edges, count, sizeof(Edge), compareEdges);
    return count;
}

// Each edge has to be run along as often one way as the other.
static swResult checkClosed(const swHost* host, const swHullMesh* mesh)
{
    size_t size = 3 * (size_t)mesh->triangleCount * sizeof(Edge);
    Edge* edges = swAllocate(host, size);
    if (edges == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to check the edges of %s.", mesh->name);
    }
    size_t count = listEdges(mesh, edges);
    int openCount = 0, turnedCount = 0;
    Edge first = {0};
    for (size_t i = 0; i < count;)
    {
        size_t end = i;
        int sum = 0;
        for (; end < count && compareEdges(&edges[i], &edges[end]) == 0; ++end)
        {
            sum += edges[end].way;
        }
        first = sum != 0 && openCount + turnedCount == 0 ? edges[i] : first;
        openCount += sum != 0 && (end - i) % 2 == 1 ? 1 : 0;
        turnedCount += sum != 0 && (end - i) % 2 == 0 ? 1 : 0;
        i = end;
    }
    swFree(host, edges, size);
    if (openCount > 0)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "%s is open: %d edges have no face on one side, the first from (%g, %g, %g) to (%g, %g, %g); a "
                      "hull is a closed mesh, so fill its holes.",
                      mesh->name, openCount, (double)first.low.x, (double)first.low.y, (double)first.low.z,
                      (double)first.high.x, (double)first.high.y, (double)first.high.z);
    }
    if (turnedCount > 0)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "%s has faces that are turned against their neighbours at %d edges, the first from (%g, %g, %g) "
                      "to (%g, %g, %g); turn all faces outwards.",
                      mesh->name, turnedCount, (double)first.low.x, (double)first.low.y, (double)first.low.z,
                      (double)first.high.x, (double)first.high.y, (double)first.high.z);
    }
    return SW_SUCCESS;
}

static void findBounds(const swHullMesh* mesh, swVec3* low, swVec3* high)
{
    *low = *high = *getCorner(mesh, 0, 0);
    for (int i = 0; i < 3 * mesh->triangleCount; ++i)
    {
        const swVec3* v = getCorner(mesh, i / 3, i % 3);
        *low = (swVec3){fminf(low->x, v->x), fminf(low->y, v->y), fminf(low->z, v->z)};
        *high = (swVec3){fmaxf(high->x, v->x), fmaxf(high->y, v->y), fmaxf(high->z, v->z)};
    }
}

static int countSpacings(float extent, float spacing)
{
    return (int)ceilf(extent / spacing) + 1 + 2 * PAD;
}

swResult swPlanHullGrid(const swHost* host, const swHullMesh* mesh, int resolution, swHullGrid* grid)
{
    if (mesh->triangleCount < 4)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %d triangles; a closed hull has at least 4.", mesh->name,
                      mesh->triangleCount);
    }
    swResult result = checkClosed(host, mesh);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swVec3 low, high;
    findBounds(mesh, &low, &high);
    swVec3 size = {high.x - low.x, high.y - low.y, high.z - low.z};
    float longest = fmaxf(size.x, fmaxf(size.y, size.z));
    if (!(fminf(size.x, fminf(size.y, size.z)) > 1e-4f * longest && longest > 1e-4f))
    {
        return swFail(host, SW_ERROR_INVALID, "%s is %g x %g x %g m large; a hull has a volume.", mesh->name,
                      (double)size.x, (double)size.y, (double)size.z);
    }
    float spacing = longest / (float)resolution;
    *grid = (swHullGrid){.spacing = spacing,
                         .countX = countSpacings(size.x, spacing),
                         .countY = countSpacings(size.y, spacing),
                         .countZ = countSpacings(size.z, spacing)};
    // The mesh lies in the middle.
    grid->low = (swVec3){0.5f * (low.x + high.x - spacing * (float)(grid->countX - 1)),
                         0.5f * (low.y + high.y - spacing * (float)(grid->countY - 1)),
                         0.5f * (low.z + high.z - spacing * (float)(grid->countZ - 1))};
    return SW_SUCCESS;
}

// ---- distances ----

typedef struct Work
{
    const swHullMesh* mesh;
    swHullGrid* grid;
    float* values; // squares of distances, until they are signed
    int* nearest;  // triangle of each value
    int* winding;  // of each value
    swVec3* found; // nearest place of each value, of a mesh that crosses itself
} Work;

static swVec3 subtract(swVec3 a, swVec3 b)
{
    return (swVec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static float dot(swVec3 a, swVec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static float clamp01(float x)
{
    return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; // NaN of an edge without a length becomes 0
}

static swVec3 nearestOnEdge(swVec3 p, swVec3 a, swVec3 b)
{
    swVec3 along = subtract(b, a);
    float t = clamp01(dot(subtract(p, a), along) / dot(along, along));
    return (swVec3){a.x + t * along.x, a.y + t * along.y, a.z + t * along.z};
}

static float squareBetween(swVec3 a, swVec3 b)
{
    swVec3 way = subtract(a, b);
    return dot(way, way);
}

static swVec3 nearestOnTriangle(const swHullMesh* mesh, int triangle, swVec3 p)
{
    swVec3 a = *getCorner(mesh, triangle, 0), b = *getCorner(mesh, triangle, 1), c = *getCorner(mesh, triangle, 2);
    swVec3 ab = subtract(b, a), ac = subtract(c, a), ap = subtract(p, a);
    float d00 = dot(ab, ab), d01 = dot(ab, ac), d11 = dot(ac, ac), d20 = dot(ap, ab), d21 = dot(ap, ac);
    float area = d00 * d11 - d01 * d01;
    float v = d11 * d20 - d01 * d21, w = d00 * d21 - d01 * d20;
    if (area > 0.0f && v >= 0.0f && w >= 0.0f && v + w <= area)
    {
        swVec3 n = {ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
        float height = dot(n, ap) / dot(n, n);
        return (swVec3){p.x - height * n.x, p.y - height * n.y, p.z - height * n.z};
    }
    swVec3 best = nearestOnEdge(p, a, b);
    const swVec3 others[2] = {nearestOnEdge(p, b, c), nearestOnEdge(p, c, a)};
    for (int i = 0; i < 2; ++i)
    {
        best = squareBetween(p, others[i]) < squareBetween(p, best) ? others[i] : best;
    }
    return best;
}

static size_t indexAt(const swHullGrid* grid, int x, int y, int z)
{
    return ((size_t)z * (size_t)grid->countY + (size_t)y) * (size_t)grid->countX + (size_t)x;
}

static swVec3 placeAt(const swHullGrid* grid, int x, int y, int z)
{
    return (swVec3){grid->low.x + grid->spacing * (float)x, grid->low.y + grid->spacing * (float)y,
                    grid->low.z + grid->spacing * (float)z};
}

static void offer(const Work* work, int x, int y, int z, int triangle)
{
    size_t at = indexAt(work->grid, x, y, z);
    swVec3 place = placeAt(work->grid, x, y, z);
    float square = squareBetween(place, nearestOnTriangle(work->mesh, triangle, place));
    if (square < work->values[at])
    {
        work->values[at] = square;
        work->nearest[at] = triangle;
    }
}

static int clampIndex(float at, int count)
{
    return at < 0.0f ? 0 : (at > (float)(count - 1) ? count - 1 : (int)at);
}

// The grid's points in a box around three corners, one spacing beyond.
static void findReach(const swHullGrid* grid, const swHullMesh* mesh, int triangle, int low[3], int high[3])
{
    const swVec3 *a = getCorner(mesh, triangle, 0), *b = getCorner(mesh, triangle, 1),
                 *c = getCorner(mesh, triangle, 2);
    const float corners[3][3] = {{a->x, b->x, c->x}, {a->y, b->y, c->y}, {a->z, b->z, c->z}};
    const float origin[3] = {grid->low.x, grid->low.y, grid->low.z};
    const int counts[3] = {grid->countX, grid->countY, grid->countZ};
    for (int i = 0; i < 3; ++i)
    {
        float least = fminf(corners[i][0], fminf(corners[i][1], corners[i][2]));
        float most = fmaxf(corners[i][0], fmaxf(corners[i][1], corners[i][2]));
        low[i] = clampIndex(floorf((least - origin[i]) / grid->spacing) - 1.0f, counts[i]);
        high[i] = clampIndex(ceilf((most - origin[i]) / grid->spacing) + 1.0f, counts[i]);
    }
}

static void fillNear(const Work* work)
{
    for (int i = 0; i < work->mesh->triangleCount; ++i)
    {
        int low[3], high[3];
        findReach(work->grid, work->mesh, i, low, high);
        for (int z = low[2]; z <= high[2]; ++z)
        {
            for (int y = low[1]; y <= high[1]; ++y)
            {
                for (int x = low[0]; x <= high[0]; ++x)
                {
                    offer(work, x, y, z, i);
                }
            }
        }
    }
}

// The nearest place that a neighbour knows, of a mesh that crosses itself; nothing is nearer than infinity.
static void offerPlace(const Work* work, int x, int y, int z, size_t neighbour)
{
    size_t at = indexAt(work->grid, x, y, z);
    float square = squareBetween(placeAt(work->grid, x, y, z), work->found[neighbour]);
    if (square < work->values[at])
    {
        work->values[at] = square;
        work->found[at] = work->found[neighbour];
    }
}

// Take in what the neighbours that a sweep has passed know to be nearest to them.
static void takeNeighbours(const Work* work, int x, int y, int z, const int way[3])
{
    for (int i = 1; i < 8; ++i)
    {
        int nx = x - ((i & 1) != 0 ? way[0] : 0), ny = y - ((i & 2) != 0 ? way[1] : 0);
        int nz = z - ((i & 4) != 0 ? way[2] : 0);
        if (nx < 0 || ny < 0 || nz < 0 || nx >= work->grid->countX || ny >= work->grid->countY ||
            nz >= work->grid->countZ)
        {
            continue;
        }
        size_t neighbour = indexAt(work->grid, nx, ny, nz);
        if (work->found != NULL)
        {
            offerPlace(work, x, y, z, neighbour);
        }
        else if (work->nearest[neighbour] != NO_TRIANGLE &&
                 work->nearest[neighbour] != work->nearest[indexAt(work->grid, x, y, z)])
        {
            offer(work, x, y, z, work->nearest[neighbour]);
        }
    }
}

static void sweep(const Work* work, int direction)
{
    const swHullGrid* grid = work->grid;
    const int way[3] = {(direction & 1) != 0 ? -1 : 1, (direction & 2) != 0 ? -1 : 1, (direction & 4) != 0 ? -1 : 1};
    for (int k = 0; k < grid->countZ; ++k)
    {
        for (int j = 0; j < grid->countY; ++j)
        {
            for (int i = 0; i < grid->countX; ++i)
            {
                takeNeighbours(work, way[0] > 0 ? i : grid->countX - 1 - i, way[1] > 0 ? j : grid->countY - 1 - j,
                               way[2] > 0 ? k : grid->countZ - 1 - k, way);
            }
        }
    }
}

// Two rounds in all eight directions.
static void sweepAll(const Work* work)
{
    for (int i = 0; i < 16; ++i)
    {
        sweep(work, i % 8);
    }
}

static size_t countValues(const swHullGrid* grid)
{
    return (size_t)grid->countX * (size_t)grid->countY * (size_t)grid->countZ;
}

static void findDistances(const Work* work)
{
    for (size_t i = 0; i < countValues(work->grid); ++i)
    {
        work->values[i] = INFINITY;
        work->nearest[i] = NO_TRIANGLE;
    }
    fillNear(work);
    sweepAll(work);
}

// ---- inside or outside ----

// Twice the signed area of a triangle of the y-z plane that the origin is a corner of, and its sign, which is never 0:
// where the area is, places decide. So a line through an edge or a corner meets exactly one of the faces that share it.
static int signArea(double ay, double az, double by, double bz, double* area)
{
    *area = az * by - ay * bz;
    if (*area != 0.0)
    {
        return *area > 0.0 ? 1 : -1;
    }
    if (bz != az)
    {
        return bz > az ? 1 : -1;
    }
    if (ay != by)
    {
        return ay > by ? 1 : -1;
    }
    return 0;
}

// Where a line along x through (y, z) meets a triangle; the sign says whether it goes in (+1) or out, 0: it does not.
static int crossTriangle(const swHullMesh* mesh, int triangle, double y, double z, double* x)
{
    const swVec3 *a = getCorner(mesh, triangle, 0), *b = getCorner(mesh, triangle, 1),
                 *c = getCorner(mesh, triangle, 2);
    double ay = (double)a->y - y, az = (double)a->z - z, by = (double)b->y - y, bz = (double)b->z - z;
    double cy = (double)c->y - y, cz = (double)c->z - z;
    double areaA, areaB, areaC;
    int sign = signArea(by, bz, cy, cz, &areaA);
    if (sign == 0 || signArea(cy, cz, ay, az, &areaB) != sign || signArea(ay, az, by, bz, &areaC) != sign)
    {
        return 0;
    }
    double sum = areaA + areaB + areaC;
    if (sum == 0.0)
    {
        return 0; // seen edge on
    }
    *x = (areaA * (double)a->x + areaB * (double)b->x + areaC * (double)c->x) / sum;
    return sign;
}

static void countWindings(const Work* work)
{
    const swHullGrid* grid = work->grid;
    memset(work->winding, 0, countValues(grid) * sizeof(int));
    for (int i = 0; i < work->mesh->triangleCount; ++i)
    {
        int low[3], high[3];
        findReach(grid, work->mesh, i, low, high);
        for (int k = low[2]; k <= high[2]; ++k)
        {
            for (int j = low[1]; j <= high[1]; ++j)
            {
                swVec3 place = placeAt(grid, 0, j, k);
                double x;
                int sign = crossTriangle(work->mesh, i, (double)place.y, (double)place.z, &x);
                double first = sign != 0 ? ceil((x - (double)place.x) / (double)grid->spacing) : 0.0;
                if (sign != 0 && first < (double)grid->countX)
                {
                    work->winding[indexAt(grid, first > 0.0 ? (int)first : 0, j, k)] += sign;
                }
            }
        }
    }
    for (size_t i = 0; i < countValues(grid); i += (size_t)grid->countX)
    {
        for (int x = 1; x < grid->countX; ++x)
        {
            work->winding[i + (size_t)x] += work->winding[i + (size_t)x - 1];
        }
    }
}

static swResult judgeWindings(const swHost* host, const Work* work)
{
    int least = 0, most = 0;
    for (size_t i = 0; i < countValues(work->grid); ++i)
    {
        least = work->winding[i] < least ? work->winding[i] : least;
        most = work->winding[i] > most ? work->winding[i] : most;
    }
    if (least == 0 && most == 0)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "%s has no inside that a grid of %d x %d x %d values finds; a hull has a volume, or needs more "
                      "resolution.",
                      work->mesh->name, work->grid->countX, work->grid->countY, work->grid->countZ);
    }
    work->grid->isInsideOut = least < 0 && most == 0;
    work->grid->isSelfCrossing = most > 1 || least < -1 || (least < 0 && most > 0);
    return SW_SUCCESS;
}

static bool isByOutside(const Work* work, int x, int y, int z)
{
    const swHullGrid* grid = work->grid;
    for (int i = 0; i < 27; ++i)
    {
        int nx = x + i % 3 - 1, ny = y + i / 3 % 3 - 1, nz = z + i / 9 - 1;
        bool isThere = nx >= 0 && ny >= 0 && nz >= 0 && nx < grid->countX && ny < grid->countY && nz < grid->countZ;
        if (isThere && work->winding[indexAt(grid, nx, ny, nz)] == 0)
        {
            return true;
        }
    }
    return false;
}

// What is nearest to a place outside lies on the outside of the mesh. So places inside, but for those beside the
// outside, find their distances anew from what their neighbours know. `found` is not set before all is laid out.
static void findOutside(Work* work, swVec3* found)
{
    const swHullGrid* grid = work->grid;
    for (int z = 0; z < grid->countZ; ++z)
    {
        for (int y = 0; y < grid->countY; ++y)
        {
            for (int x = 0; x < grid->countX; ++x)
            {
                size_t at = indexAt(grid, x, y, z);
                bool isKept = work->winding[at] == 0 || isByOutside(work, x, y, z);
                found[at] = isKept ? nearestOnTriangle(work->mesh, work->nearest[at], placeAt(grid, x, y, z))
                                   : (swVec3){1e18f, 1e18f, 1e18f};
                work->values[at] = isKept ? work->values[at] : INFINITY;
            }
        }
    }
    work->found = found;
    sweepAll(work);
}

static swResult repairInside(const swHost* host, Work* work)
{
    size_t size = countValues(work->grid) * sizeof(swVec3);
    swVec3* found = swAllocate(host, size);
    if (found == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to make the grid of %s.", work->mesh->name);
    }
    findOutside(work, found);
    swFree(host, found, size);
    return SW_SUCCESS;
}

static void signDistances(const Work* work)
{
    for (size_t i = 0; i < countValues(work->grid); ++i)
    {
        float distance = sqrtf(work->values[i]);
        work->values[i] = work->winding[i] != 0 ? -distance : distance;
    }
}

static swResult fill(const swHost* host, Work* work)
{
    findDistances(work);
    countWindings(work);
    swResult result = judgeWindings(host, work);
    if (result == SW_SUCCESS && work->grid->isSelfCrossing)
    {
        result = repairInside(host, work);
    }
    signDistances(work);
    return result;
}

swResult swFillHullGrid(const swHost* host, const swHullMesh* mesh, swHullGrid* grid, float* values)
{
    size_t count = countValues(grid);
    Work work = {.mesh = mesh,
                 .grid = grid,
                 .values = values,
                 .nearest = swAllocate(host, count * sizeof(int)),
                 .winding = swAllocate(host, count * sizeof(int))};
    swResult result = work.nearest != NULL && work.winding != NULL
                          ? fill(host, &work)
                          : swFail(host, SW_ERROR_NO_MEMORY, "No memory to make the grid of %s.", mesh->name);
    swFree(host, work.nearest, count * sizeof(int));
    swFree(host, work.winding, count * sizeof(int));
    return result;
}
