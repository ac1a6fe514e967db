// SPDX-License-Identifier: MIT
#include "core/input/polygon.h"

#include <math.h>

#define FARTHEST 1e6f // m, of a point from its polygon's place

static swResult checkPoints(const swHost* host, const char* name, int count, const swVec2* points)
{
    for (int i = 0; i < count; ++i)
    {
        const swVec2* p = &points[i];
        if (!(fabsf(p->x) <= FARTHEST && fabsf(p->y) <= FARTHEST))
        {
            return swFail(host, SW_ERROR_INVALID,
                          "%s has point %d, counted from 0, at (%g, %g); a polygon's points are finite and within 1000 "
                          "km of its place.",
                          name, i, (double)p->x, (double)p->y);
        }
    }
    for (int i = 0; i < count; ++i)
    {
        const swVec2 *p = &points[i], *next = &points[(i + 1) % count];
        if (p->x == next->x && p->y == next->y)
        {
            return swFail(host, SW_ERROR_INVALID,
                          "%s has points %d and %d at the same place, (%g, %g); remove one of them.", name, i,
                          (i + 1) % count, (double)p->x, (double)p->y);
        }
    }
    return SW_SUCCESS;
}

// Which side of a to b the point c is on: exact in double but for points of very different sizes.
static int findSide(const swVec2* a, const swVec2* b, const swVec2* c)
{
    double left = ((double)b->x - (double)a->x) * ((double)c->y - (double)a->y);
    double right = ((double)b->y - (double)a->y) * ((double)c->x - (double)a->x);
    return left > right ? 1 : (left < right ? -1 : 0);
}

// Of a point on the line through a and b.
static bool isBetween(const swVec2* a, const swVec2* b, const swVec2* c)
{
    return fminf(a->x, b->x) <= c->x && c->x <= fmaxf(a->x, b->x) && fminf(a->y, b->y) <= c->y &&
           c->y <= fmaxf(a->y, b->y);
}

static bool doMeet(const swVec2* a, const swVec2* b, const swVec2* c, const swVec2* d)
{
    if (fmaxf(a->x, b->x) < fminf(c->x, d->x) || fmaxf(c->x, d->x) < fminf(a->x, b->x) ||
        fmaxf(a->y, b->y) < fminf(c->y, d->y) || fmaxf(c->y, d->y) < fminf(a->y, b->y))
    {
        return false;
    }
    int abc = findSide(a, b, c), abd = findSide(a, b, d), cda = findSide(c, d, a), cdb = findSide(c, d, b);
    if (abc != abd && cda != cdb)
    {
        return true;
    }
    return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) || (cda == 0 && isBetween(c, d, a)) ||
           (cdb == 0 && isBetween(c, d, b));
}

// Edges that follow each other meet in a point; they must not run back on themselves.
static bool turnsBack(const swVec2* a, const swVec2* b, const swVec2* c)
{
    double dot = ((double)b->x - (double)a->x) * ((double)c->x - (double)b->x) +
                 ((double)b->y - (double)a->y) * ((double)c->y - (double)b->y);
    return findSide(a, b, c) == 0 && dot < 0.0;
}

static swResult checkCrossings(const swHost* host, const char* name, int count, const swVec2* points)
{
    for (int i = 0; i < count; ++i)
    {
        const swVec2 *a = &points[i], *b = &points[(i + 1) % count];
        if (turnsBack(a, b, &points[(i + 2) % count]))
        {
            return swFail(host, SW_ERROR_INVALID,
                          "%s turns back on itself at point %d, (%g, %g); a polygon encloses its area once.", name,
                          (i + 1) % count, (double)b->x, (double)b->y);
        }
        for (int k = i + 2; k < count - (i == 0 ? 1 : 0); ++k)
        {
            const swVec2 *c = &points[k], *d = &points[(k + 1) % count];
            if (doMeet(a, b, c, d))
            {
                return swFail(host, SW_ERROR_INVALID,
                              "%s crosses itself: its edge from point %d, (%g, %g), meets the one from point %d, (%g, "
                              "%g); points are counted from 0, in order around the area.",
                              name, i, (double)a->x, (double)a->y, k, (double)c->x, (double)c->y);
            }
        }
    }
    return SW_SUCCESS;
}

swResult swCheckPolygon(const swHost* host, const char* name, int count, const swVec2* points)
{
    if (count < 3 || count > SW_MAX_POLYGON_POINTS)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %d points; a polygon has 3 to %d.", name, count,
                      SW_MAX_POLYGON_POINTS);
    }
    swResult result = checkPoints(host, name, count, points);
    return result == SW_SUCCESS ? checkCrossings(host, name, count, points) : result;
}
