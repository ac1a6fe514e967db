// SPDX-License-Identifier: MIT
#include "core/input/polygon.h"

#include <math.h>

#define FARTHEST 1e6f // m, of a point from its polygon's place

// A polygon as it was given.
typedef struct Polygon
{
    const swHost* host;
    const char* name;
    int count;
    const float* points;
    size_t stride;
} Polygon;

typedef struct Point
{
    float x, z;
} Point;

// Indices go round.
static Point getPoint(const Polygon* polygon, int i)
{
    const float* at = polygon->points + polygon->stride * (size_t)(i % polygon->count);
    return (Point){at[0], at[1]};
}

static swResult checkPoints(const Polygon* polygon)
{
    for (int i = 0; i < polygon->count; ++i)
    {
        Point p = getPoint(polygon, i);
        if (!(fabsf(p.x) <= FARTHEST && fabsf(p.z) <= FARTHEST))
        {
            return swFail(polygon->host, SW_ERROR_INVALID,
                          "%s has point %d, counted from 0, at (%g, %g); a polygon's points are finite and within 1000 "
                          "km of its place.",
                          polygon->name, i, (double)p.x, (double)p.z);
        }
    }
    for (int i = 0; i < polygon->count; ++i)
    {
        Point p = getPoint(polygon, i), next = getPoint(polygon, i + 1);
        if (p.x == next.x && p.z == next.z)
        {
            return swFail(polygon->host, SW_ERROR_INVALID,
                          "%s has points %d and %d at the same place, (%g, %g); remove one of them.", polygon->name, i,
                          (i + 1) % polygon->count, (double)p.x, (double)p.z);
        }
    }
    return SW_SUCCESS;
}

// Which side of a to b the point c is on: exact in double but for points of very different sizes.
static int findSide(Point a, Point b, Point c)
{
    double left = ((double)b.x - (double)a.x) * ((double)c.z - (double)a.z);
    double right = ((double)b.z - (double)a.z) * ((double)c.x - (double)a.x);
    return left > right ? 1 : (left < right ? -1 : 0);
}

// Of a point on the line through a and b.
static bool isBetween(Point a, Point b, Point c)
{
    return fminf(a.x, b.x) <= c.x && c.x <= fmaxf(a.x, b.x) && fminf(a.z, b.z) <= c.z && c.z <= fmaxf(a.z, b.z);
}

static bool doMeet(Point a, Point b, Point c, Point d)
{
    if (fmaxf(a.x, b.x) < fminf(c.x, d.x) || fmaxf(c.x, d.x) < fminf(a.x, b.x) || fmaxf(a.z, b.z) < fminf(c.z, d.z) ||
        fmaxf(c.z, d.z) < fminf(a.z, b.z))
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
static bool turnsBack(Point a, Point b, Point c)
{
    double dot = ((double)b.x - (double)a.x) * ((double)c.x - (double)b.x) +
                 ((double)b.z - (double)a.z) * ((double)c.z - (double)b.z);
    return findSide(a, b, c) == 0 && dot < 0.0;
}

static swResult checkCrossings(const Polygon* polygon)
{
    for (int i = 0; i < polygon->count; ++i)
    {
        Point a = getPoint(polygon, i), b = getPoint(polygon, i + 1);
        if (turnsBack(a, b, getPoint(polygon, i + 2)))
        {
            return swFail(polygon->host, SW_ERROR_INVALID,
                          "%s turns back on itself at point %d, (%g, %g); a polygon encloses its area once.",
                          polygon->name, (i + 1) % polygon->count, (double)b.x, (double)b.z);
        }
        for (int k = i + 2; k < polygon->count - (i == 0 ? 1 : 0); ++k)
        {
            Point c = getPoint(polygon, k);
            if (doMeet(a, b, c, getPoint(polygon, k + 1)))
            {
                return swFail(polygon->host, SW_ERROR_INVALID,
                              "%s crosses itself: its edge from point %d, (%g, %g), meets the one from point %d, (%g, "
                              "%g); points are counted from 0, in order around the area.",
                              polygon->name, i, (double)a.x, (double)a.z, k, (double)c.x, (double)c.z);
            }
        }
    }
    return SW_SUCCESS;
}

swResult swCheckPolygon(const swHost* host, const char* name, int count, const float* points, size_t stride)
{
    if (count < 3 || count > SW_MAX_POLYGON_POINTS)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %d points; a polygon has 3 to %d.", name, count,
                      SW_MAX_POLYGON_POINTS);
    }
    const Polygon polygon = {host, name, count, points, stride};
    swResult result = checkPoints(&polygon);
    return result == SW_SUCCESS ? checkCrossings(&polygon) : result;
}
