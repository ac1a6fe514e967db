// SPDX-License-Identifier: MIT
// Heights from tiles that displace sideways too. The water above q belongs to the particle that rests at u with
// u + D(u) = q. With the offset d = u - q this is a root of r(d) = d + D(q + d), two equations in two unknowns, found by a
// quasi-Newton iteration: the Jacobian starts as the identity (which makes the first step the classic fixed-point one)
// and is corrected after each step by what the residual did [Broyden 1965]. That needs no gradients, which cost as much
// as the displacement itself. A step that made the residual worse is taken back and tried again shorter.
//
// Points run in blocks, and within a block the kernels see only points that are not yet done. A point's iteration
// depends on nothing but itself, so its bits do not depend on the batch that it came in.
//
// Offsets are float: they are metres at most. q + d is double, so the answer is as good far away as at the origin.

#include "core/query/sample.h"

#include <math.h>

#include "shared/surface_normal.h"

// Points worked on together; everything about a block lives on the stack.
#define SW_QUERY_BLOCK 128

typedef struct swSearch
{
    float dx, dz; // offset being tried
    float rx, rz; // its residual
    float bestX, bestZ;
    float bestRx, bestRz;
    float bestSquare;         // of the best residual
    float b00, b01, b10, b11; // inverse Jacobian
    float reach;              // share of the full step, below 1 after a bad one
} swSearch;

typedef struct swQuery
{
    const swWaveKernels* kernels;
    const swQueryDef* def;
    double seaLevel;
    int tileCount;
    swTile tiles[SW_MAX_TILES];
} swQuery;

static void beginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def)
{
    query->kernels = kernels;
    query->def = def;
    query->seaLevel = frame->seaLevel;
    query->tileCount = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        if (tile->texels != NULL && tile->maxWavelength > def->minWavelength)
        {
            query->tiles[query->tileCount++] = *tile;
        }
    }
}

// Good Broyden update of the inverse Jacobian for a step (sx, sz) that changed the residual by (yx, yz).
static void correctJacobian(swSearch* search, float sx, float sz, float yx, float yz)
{
    float byX = search->b00 * yx + search->b01 * yz;
    float byZ = search->b10 * yx + search->b11 * yz;
    float scale = sx * byX + sz * byZ;
    float square = sx * sx + sz * sz;
    if (fabsf(scale) <= 1e-3f * square)
    {
        return; // the update would blow up; the old Jacobian is the better guess
    }
    float ux = (sx - byX) / scale;
    float uz = (sz - byZ) / scale;
    float rowX = sx * search->b00 + sz * search->b10;
    float rowZ = sx * search->b01 + sz * search->b11;
    search->b00 += ux * rowX;
    search->b01 += ux * rowZ;
    search->b10 += uz * rowX;
    search->b11 += uz * rowZ;
}

// Take in the displacement at the tried offset and choose the next. False when done.
static bool advanceSearch(swSearch* search, const float* displacement, float toleranceSquare)
{
    search->rx = search->dx + displacement[0];
    search->rz = search->dz + displacement[2];
    float square = search->rx * search->rx + search->rz * search->rz;
    float sx = search->dx - search->bestX;
    float sz = search->dz - search->bestZ;
    if (sx != 0.0f || sz != 0.0f)
    {
        correctJacobian(search, sx, sz, search->rx - search->bestRx, search->rz - search->bestRz);
    }
    if (square < search->bestSquare)
    {
        search->bestX = search->dx;
        search->bestZ = search->dz;
        search->bestRx = search->rx;
        search->bestRz = search->rz;
        search->bestSquare = square;
        search->reach = 1.0f;
    }
    else
    {
        search->reach *= 0.5f;
    }
    if (search->bestSquare <= toleranceSquare)
    {
        return false;
    }
    search->dx = search->bestX - search->reach * (search->b00 * search->bestRx + search->b01 * search->bestRz);
    search->dz = search->bestZ - search->reach * (search->b10 * search->bestRx + search->b11 * search->bestRz);
    return true;
}

// Find the particles above a block of points. `found` receives the displacement at each answer.
static int searchBlock(const swQuery* query, int count, const swPosXZ* points, swSearch* searches, float (*found)[4])
{
    swPosXZ tried[SW_QUERY_BLOCK];
    float displacement[SW_QUERY_BLOCK][4];
    int active[SW_QUERY_BLOCK];
    int activeCount = count;
    float toleranceSquare = query->def->tolerance * query->def->tolerance;
    for (int i = 0; i < count; ++i)
    {
        searches[i] = (swSearch){.b00 = 1.0f, .b11 = 1.0f, .bestSquare = INFINITY, .reach = 1.0f};
        active[i] = i;
    }
    int evaluations = 0;
    for (int iteration = 0; iteration < query->def->maxIterations && activeCount > 0; ++iteration)
    {
        for (int i = 0; i < activeCount; ++i)
        {
            const swSearch* search = &searches[active[i]];
            tried[i].x = points[active[i]].x + (double)search->dx;
            tried[i].z = points[active[i]].z + (double)search->dz;
        }
        swSampleTiles(query->kernels, query->tileCount, query->tiles, activeCount, tried, displacement[0], NULL);
        evaluations += activeCount;
        int stillActive = 0;
        for (int i = 0; i < activeCount; ++i)
        {
            int point = active[i];
            float before = searches[point].bestSquare;
            bool isDone = !advanceSearch(&searches[point], displacement[i], toleranceSquare);
            if (searches[point].bestSquare < before)
            {
                for (int c = 0; c < 4; ++c)
                {
                    found[point][c] = displacement[i][c];
                }
            }
            active[stillActive] = point;
            stillActive += isDone ? 0 : 1;
        }
        activeCount = stillActive;
    }
    return evaluations;
}

// The upward unit normal; the underside of a fold is turned over.
static swVec3 makeNormal(const float* g, float jacobian)
{
    float x = swSurfaceNormalX(g[2], g[3], g[4], g[5]);
    float z = swSurfaceNormalZ(g[0], g[1], g[4], g[5]);
    float length = sqrtf(x * x + jacobian * jacobian + z * z);
    if (length < 1e-20f)
    {
        return (swVec3){0.0f, 1.0f, 0.0f};
    }
    float scale = (jacobian < 0.0f ? -1.0f : 1.0f) / length;
    return (swVec3){-x * scale, jacobian * scale, -z * scale};
}

// Write answers [first, first + count); gradients may be NULL if neither normals nor Jacobians are wanted.
static void writeSamples(const swSurfaceSamples* samples, double seaLevel, int first, int count,
                         float (*displacement)[4], float (*gradients)[8])
{
    for (int i = 0; i < count; ++i)
    {
        const float* d = displacement[i];
        if (samples->height != NULL)
        {
            samples->height[first + i] = (float)(seaLevel + (double)d[1]);
        }
        if (samples->displacement != NULL)
        {
            samples->displacement[first + i] = (swVec3){d[0], d[1], d[2]};
        }
        if (gradients == NULL)
        {
            continue;
        }
        const float* g = gradients[i];
        float jacobian = swSurfaceJacobian(g[0], g[1], g[2], g[3]);
        if (samples->normal != NULL)
        {
            samples->normal[first + i] = makeNormal(g, jacobian);
        }
        if (samples->jacobian != NULL)
        {
            samples->jacobian[first + i] = jacobian;
        }
    }
}

static void countBlock(swQueryStats* stats, const swSearch* searches, int count, float tolerance)
{
    for (int i = 0; i < count; ++i)
    {
        float residual = sqrtf(searches[i].bestSquare);
        stats->convergedCount += residual <= tolerance ? 1 : 0;
        stats->worstResidual = residual > stats->worstResidual ? residual : stats->worstResidual;
    }
}

void swQuerySurface(const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def, int count,
                    const swPosXZ* points, const swSurfaceSamples* samples, swQueryStats* stats)
{
    swQuery query;
    beginQuery(&query, frame, kernels, def);
    bool needsGradients = samples->normal != NULL || samples->jacobian != NULL;
    swQueryStats total = {0};
    for (int first = 0; first < count; first += SW_QUERY_BLOCK)
    {
        int blockCount = count - first < SW_QUERY_BLOCK ? count - first : SW_QUERY_BLOCK;
        swSearch searches[SW_QUERY_BLOCK];
        float found[SW_QUERY_BLOCK][4];
        float gradients[SW_QUERY_BLOCK][8];
        total.iterationCount += searchBlock(&query, blockCount, points + first, searches, found);
        if (needsGradients)
        {
            swPosXZ rest[SW_QUERY_BLOCK];
            float again[SW_QUERY_BLOCK][4];
            for (int i = 0; i < blockCount; ++i)
            {
                rest[i].x = points[first + i].x + (double)searches[i].bestX;
                rest[i].z = points[first + i].z + (double)searches[i].bestZ;
            }
            swSampleTiles(kernels, query.tileCount, query.tiles, blockCount, rest, again[0], gradients[0]);
            total.iterationCount += blockCount;
        }
        writeSamples(samples, query.seaLevel, first, blockCount, found, needsGradients ? gradients : NULL);
        for (int i = 0; i < blockCount && samples->residual != NULL; ++i)
        {
            samples->residual[first + i] = sqrtf(searches[i].bestSquare);
        }
        countBlock(&total, searches, blockCount, def->tolerance);
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}

void swQueryParticles(const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def, int count,
                      const swPosXZ* points, const swSurfaceSamples* samples, swVec2* slopes)
{
    swQuery query;
    beginQuery(&query, frame, kernels, def);
    bool needsGradients = samples->normal != NULL || samples->jacobian != NULL || slopes != NULL;
    for (int first = 0; first < count; first += SW_QUERY_BLOCK)
    {
        int blockCount = count - first < SW_QUERY_BLOCK ? count - first : SW_QUERY_BLOCK;
        float found[SW_QUERY_BLOCK][4];
        float gradients[SW_QUERY_BLOCK][8];
        swSampleTiles(kernels, query.tileCount, query.tiles, blockCount, points + first, found[0],
                      needsGradients ? gradients[0] : NULL);
        writeSamples(samples, query.seaLevel, first, blockCount, found, needsGradients ? gradients : NULL);
        for (int i = 0; i < blockCount; ++i)
        {
            if (slopes != NULL)
            {
                slopes[first + i] = (swVec2){gradients[i][4], gradients[i][5]};
            }
            if (samples->residual != NULL)
            {
                samples->residual[first + i] = 0.0f;
            }
        }
    }
}
