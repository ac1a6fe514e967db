// SPDX-License-Identifier: MIT
// Heights from tiles that displace sideways too. The water above q belongs to the particle that rests at u with
// u + D(u) = q. With the offset d = u - q this is a root of r(d) = d + D(q + d), two equations in two unknowns, found
// by a quasi-Newton iteration: the Jacobian starts as the identity (which makes the first step the classic fixed-point
// one) and is corrected after each step by what the residual did [Broyden 1965]. That needs no gradients, which cost as
// much as the displacement itself. A step that made the residual worse is taken back and tried again shorter.
//
// Points run in blocks, and within a block the kernels see only points that are not yet done. A point's iteration
// depends on nothing but itself, so its bits do not depend on the batch that it came in.
//
// Offsets are float: they are metres at most. q + d is double, so the answer is as good far away as at the origin.

#include "core/surface/search.h"

#include <math.h>
#include <string.h>

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

void swFindParticles(const swQuery* query, int count, const swPosXZ* points, swFound* found)
{
    swSearch searches[SW_QUERY_BLOCK];
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
    found->evaluations = 0;
    const swEvaluation evaluation = {.displacement = displacement};
    for (int iteration = 0; iteration < query->def->maxIterations && activeCount > 0; ++iteration)
    {
        for (int i = 0; i < activeCount; ++i)
        {
            const swSearch* search = &searches[active[i]];
            tried[i].x = points[active[i]].x + (double)search->dx;
            tried[i].z = points[active[i]].z + (double)search->dz;
        }
        swEvaluate(query, activeCount, tried, &evaluation);
        found->evaluations += activeCount;
        int stillActive = 0;
        for (int i = 0; i < activeCount; ++i)
        {
            int point = active[i];
            float before = searches[point].bestSquare;
            bool isDone = !advanceSearch(&searches[point], displacement[i], toleranceSquare);
            if (searches[point].bestSquare < before)
            {
                memcpy(found->displacement[point], displacement[i], sizeof displacement[i]);
            }
            active[stillActive] = point;
            stillActive += isDone ? 0 : 1;
        }
        activeCount = stillActive;
    }
    for (int i = 0; i < count; ++i)
    {
        found->rest[i].x = points[i].x + (double)searches[i].bestX;
        found->rest[i].z = points[i].z + (double)searches[i].bestZ;
        found->residual[i] = sqrtf(searches[i].bestSquare);
    }
}
