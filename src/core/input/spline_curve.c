// SPDX-License-Identifier: MIT
// The curve through a spline's points, seen from above, and its length. All in double and without libm but for sqrt.

#include "core/input/spline.h"

#include <math.h>

#define HANDLE 0.39 // of the distance between two points: makes a square nearly a circle
// A span is halved at least and at most so often.
#define LEAST_HALVINGS 3
#define MOST_HALVINGS 12

typedef struct Plane
{
    double x, z;
} Plane;

typedef struct Bezier
{
    Plane p[4];
} Bezier;

// ---- directions ----

static Plane getPoint(const swSpline* spline, int index)
{
    int count = spline->def.pointCount;
    const swSplinePoint* point = &spline->points[(index + count) % count];
    return (Plane){point->x - spline->originX, point->z - spline->originZ};
}

static double getLength(Plane v)
{
    return sqrt(v.x * v.x + v.z * v.z);
}

static Plane normalize(Plane v, Plane otherwise)
{
    double length = getLength(v);
    return length > 1e-9 ? (Plane){v.x / length, v.z / length} : otherwise;
}

// From one point to the next.
static Plane getChord(const swSpline* spline, int index)
{
    Plane a = getPoint(spline, index), b = getPoint(spline, index + 1);
    return normalize((Plane){b.x - a.x, b.z - a.z}, (Plane){1.0, 0.0});
}

// Where the neighbours are one place there is no direction between them: the line goes to the left there.
static Plane getInnerDirection(const swSpline* spline, int index)
{
    Plane before = getPoint(spline, index - 1), after = getPoint(spline, index + 1), in = getChord(spline, index - 1);
    return normalize((Plane){after.x - before.x, after.z - before.z}, (Plane){in.z, -in.x});
}

static Plane mirror(Plane direction, Plane chord)
{
    double along = 2.0 * (direction.x * chord.x + direction.z * chord.z);
    return (Plane){along * chord.x - direction.x, along * chord.z - direction.z};
}

static Plane getDirection(const swSpline* spline, int index)
{
    int last = spline->def.pointCount - 1;
    if (spline->def.isClosed || (index > 0 && index < last))
    {
        return getInnerDirection(spline, index);
    }
    Plane chord = getChord(spline, index == 0 ? 0 : last - 1);
    return last == 1 ? chord : mirror(getInnerDirection(spline, index == 0 ? 1 : last - 1), chord);
}

void swGetEndDirections(const swSpline* spline, double start[2], double end[2])
{
    Plane a = getDirection(spline, 0), b = getDirection(spline, spline->spanCount % spline->def.pointCount);
    start[0] = a.x;
    start[1] = a.z;
    end[0] = b.x;
    end[1] = b.z;
}

// ---- the curve ----

static Bezier getBezier(const swSpline* spline, int span)
{
    int count = spline->def.pointCount;
    Plane a = getPoint(spline, span), b = getPoint(spline, span + 1);
    Plane leaves = getDirection(spline, span), reaches = getDirection(spline, (span + 1) % count);
    double handle = HANDLE * getLength((Plane){b.x - a.x, b.z - a.z});
    return (Bezier){{a,
                     {a.x + handle * leaves.x, a.z + handle * leaves.z},
                     {b.x - handle * reaches.x, b.z - handle * reaches.z},
                     b}};
}

static double blend4(double a, double b, double c, double d, double t)
{
    double s = 1.0 - t;
    return s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d);
}

static double blend3(double a, double b, double c, double t)
{
    double s = 1.0 - t;
    return s * s * a + 2.0 * s * t * b + t * t * c;
}

static Plane getPlace(const Bezier* curve, double t)
{
    const Plane* p = curve->p;
    return (Plane){blend4(p[0].x, p[1].x, p[2].x, p[3].x, t), blend4(p[0].z, p[1].z, p[2].z, p[3].z, t)};
}

static Plane getVelocity(const Bezier* curve, double t)
{
    const Plane* p = curve->p;
    return (Plane){3.0 * blend3(p[1].x - p[0].x, p[2].x - p[1].x, p[3].x - p[2].x, t),
                   3.0 * blend3(p[1].z - p[0].z, p[2].z - p[1].z, p[3].z - p[2].z, t)};
}

// By Gauss's rule of five points.
static double measurePart(const Bezier* curve, double from, double to)
{
    static const double places[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
    static const double weights[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = weights[0] * getLength(getVelocity(curve, middle));
    for (int i = 1; i < 3; ++i)
    {
        sum += weights[i] * (getLength(getVelocity(curve, middle - half * places[i])) +
                             getLength(getVelocity(curve, middle + half * places[i])));
    }
    return half * sum;
}

// ---- cutting it ----

// Where a span is cut, by halving it until no part turns much.
typedef struct Cut
{
    const Bezier* curve;
    swSplineKnot* knots; // NULL: only counts
    double* steps;
    int count;
    double length;
    bool turnsOnTheSpot;
} Cut;

// Of the angle between two directions its sine, or 2 if it is more than a right one.
static double getTurn(Plane a, Plane b)
{
    double dot = a.x * b.x + a.z * b.z, cross = fabs(a.x * b.z - a.z * b.x);
    return dot > 0.0 ? cross / (getLength(a) * getLength(b)) : 2.0;
}

static void cutPart(Cut* cut, double from, double to, int depth)
{
    double middle = 0.5 * (from + to);
    Plane a = getVelocity(cut->curve, from), m = getVelocity(cut->curve, middle), b = getVelocity(cut->curve, to);
    double turn = getTurn(a, m) + getTurn(m, b);
    if ((turn > 0.15 && depth < MOST_HALVINGS) || depth < LEAST_HALVINGS)
    {
        cutPart(cut, from, middle, depth + 1);
        cutPart(cut, middle, to, depth + 1);
        return;
    }
    double length = measurePart(cut->curve, from, middle) + measurePart(cut->curve, middle, to);
    cut->turnsOnTheSpot |= turn > 0.4 || !(length > 0.0);
    if (cut->knots != NULL)
    {
        Plane place = getPlace(cut->curve, from);
        cut->knots[cut->count] = (swSplineKnot){.x = place.x, .z = place.z};
        cut->steps[cut->count] = length;
    }
    cut->count += 1;
    cut->length += length;
}

swResult swMeasureSpan(const swSpline* spline, int span, swSplineSpan* measured)
{
    Bezier curve = getBezier(spline, span);
    Cut cut = {.curve = &curve};
    cutPart(&cut, 0.0, 1.0, 0);
    *measured = (swSplineSpan){cut.length, cut.count};
    if (cut.turnsOnTheSpot)
    {
        return swFail(&spline->host, SW_ERROR_INVALID,
                      "%s turns on the spot between point %d and point %d, counted from 0; move one of them, or put "
                      "points round the bend.",
                      spline->name, span, (span + 1) % spline->def.pointCount);
    }
    return SW_SUCCESS;
}

void swCutSpan(const swSpline* spline, int span, swSplineKnot* knots, double* steps)
{
    Bezier curve = getBezier(spline, span);
    Cut cut = {.curve = &curve, .knots = knots, .steps = steps};
    cutPart(&cut, 0.0, 1.0, 0);
}

// ---- a smooth line through knots ----

// Of a cubic spline by its second derivatives [de Boor 1978]: row i says
//     steps[i - 1] b[i - 1] + middle[i] b[i] + steps[i] b[i + 1] = v[i].
// Solves it in place; `scratch` has `count`.
static void solveRows(int count, const double* steps, const double* middle, double* v, double* scratch)
{
    double pivot = middle[0];
    v[0] /= pivot;
    for (int i = 1; i < count; ++i)
    {
        scratch[i] = steps[i - 1] / pivot;
        pivot = middle[i] - steps[i - 1] * scratch[i];
        v[i] = (v[i] - steps[i - 1] * v[i - 1]) / pivot;
    }
    for (int i = count - 2; i >= 0; --i)
    {
        v[i] -= scratch[i + 1] * v[i + 1];
    }
}

// The same where the last row goes on to the first: a matrix that differs by one product of vectors
// [Sherman and Morrison 1950].
static void solveRing(int count, const double* steps, double* middle, double* v, double* scratch)
{
    double* other = scratch + count;
    double corner = steps[count - 1], gamma = -middle[0];
    middle[0] -= gamma;
    middle[count - 1] -= corner * corner / gamma;
    for (int i = 0; i < count; ++i)
    {
        other[i] = i == 0 ? gamma : i == count - 1 ? corner : 0.0;
    }
    solveRows(count, steps, middle, v, scratch);
    solveRows(count, steps, middle, other, scratch);
    double factor = (v[0] + corner * v[count - 1] / gamma) / (1.0 + other[0] + corner * other[count - 1] / gamma);
    for (int i = 0; i < count; ++i)
    {
        v[i] -= factor * other[i];
    }
}

static double getCoordinate(const swSplineKnot* knot, int axis)
{
    return axis == 0 ? knot->x : knot->z;
}

static double getSecant(const double* steps, const swSplineKnot* knots, int segment, int axis)
{
    return (getCoordinate(&knots[segment + 1], axis) - getCoordinate(&knots[segment], axis)) / steps[segment];
}

static void fitAxis(int count, bool isClosed, const double* steps, double start, double end, swSplineKnot* knots,
                    int axis, double* scratch)
{
    int rows = isClosed ? count : count + 1;
    double *bends = scratch, *middle = scratch + count + 1, *rest = scratch + 2 * (count + 1);
    for (int i = 0; i < rows; ++i)
    {
        int before = i > 0 ? i - 1 : isClosed ? count - 1 : -1, after = i < count ? i : -1;
        double in = before >= 0 ? getSecant(steps, knots, before, axis) : start;
        double out = after >= 0 ? getSecant(steps, knots, after, axis) : end;
        middle[i] = 2.0 * ((before >= 0 ? steps[before] : 0.0) + (after >= 0 ? steps[after] : 0.0));
        bends[i] = 6.0 * (out - in);
    }
    (isClosed ? solveRing(rows, steps, middle, bends, rest) : solveRows(rows, steps, middle, bends, rest));
    for (int i = 0; i <= count; ++i)
    {
        double bend = bends[i % rows];
        int segment = i < count ? i : count - 1;
        double step = steps[segment], other = i < count ? bends[(i + 1) % rows] : bends[count - 1];
        double turn = step * (2.0 * bend + other) / 6.0;
        double tangent = getSecant(steps, knots, segment, axis) + (i < count ? -turn : turn);
        *(axis == 0 ? &knots[i].bendX : &knots[i].bendZ) = bend;
        *(axis == 0 ? &knots[i].tangentX : &knots[i].tangentZ) = tangent;
    }
}

void swFitKnots(int count, bool isClosed, const double* steps, const double start[2], const double end[2],
                swSplineKnot* knots, double* scratch)
{
    for (int axis = 0; axis < 2; ++axis)
    {
        fitAxis(count, isClosed, steps, start[axis], end[axis], knots, axis, scratch);
    }
}

double swGetMostCurvature(const swSplineKnot* knot, double step)
{
    double jx = (knot[1].bendX - knot[0].bendX) / step, jz = (knot[1].bendZ - knot[0].bendZ) / step, most = 0.0;
    for (int i = 0; i <= 4; ++i)
    {
        double a = step * i / 4.0;
        Plane d = {knot->tangentX + a * (knot->bendX + 0.5 * a * jx),
                   knot->tangentZ + a * (knot->bendZ + 0.5 * a * jz)};
        Plane dd = {knot->bendX + a * jx, knot->bendZ + a * jz};
        double speed = getLength(d);
        double curvature = fabs(d.x * dd.z - d.z * dd.x) / (speed * speed * speed);
        most = curvature > most ? curvature : most; // fmax() here ends GCC 12 for AArch64 with an internal error
    }
    return most;
}
