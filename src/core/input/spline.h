// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swSpline. Inputs share it: each holds it, and the last that lets it go frees it.
//
// The Bezier curve between two points, a span, is cut into segments, shorter ones where it turns. Through their ends,
// the knots, a cubic spline is laid whose parameter is the length of the line [de Boor 1978]: it is smooth to the
// second derivative, so that nothing looked up along it and beside it has a kink, and its speed is 1.
// shaders/shared/shape_spline.h evaluates it from the words that are made here.

#include <stdatomic.h>

#include "core/base/field.h"
#include "seaway/spline.h"

extern const swFields swSplinePointFields;
extern const swFields swSplineFields;

struct swSpline
{
    swHost host;
    atomic_int holderCount;
    char name[256];
    swSplineDef def; // its name and points are those here
    swSplinePoint* points;
    double* starts;          // [spanCount + 1]: of spans, along the line
    double originX, originZ; // of the coordinates in words
    int spanCount, segmentCount;
    double leastX, leastZ, mostX, mostZ; // of the ribbon, in the coordinates of words
    double leastRadius;
    float* words; // as shape_spline.h reads them
    size_t wordCount;
    size_t memory;
    uint64_t hash;
};

// NULL is allowed.
void swRetainSpline(const swSpline* spline);
void swReleaseSpline(const swSpline* spline);

// Whether words that come from outside are such that reading them leads nowhere else.
bool swAreSplineWordsGood(const float* words, size_t count);

// Between which levels of still water lie along it: heights of points and of water above them, m.
void swGetSplineHeights(const swSpline* spline, float* least, float* most);

float swGetFastestSplineFlow(const swSpline* spline); // m/s, either way

// From one point to the next.
typedef struct swSplineSpan
{
    double length;
    int segmentCount;
} swSplineSpan;

// A point of the curve and its direction.
typedef struct swSplineKnot
{
    double x, z;
    double tangentX, tangentZ; // of length 1
    double bendX, bendZ;       // second derivative by the length, 1/m
} swSplineKnot;

// How long a span is and into how many segments it is cut, so that none turns much. SW_ERROR_INVALID and a sentence if
// it turns on the spot.
swResult swMeasureSpan(const swSpline* spline, int span, swSplineSpan* measured);

// The beginnings of its segments and their lengths.
void swCutSpan(const swSpline* spline, int span, swSplineKnot* knots, double* steps);

// The directions at which the line leaves its first point and reaches its last one.
void swGetEndDirections(const swSpline* spline, double start[2], double end[2]);

// Bends and directions of a smooth line through knots that are steps[] apart; `scratch` has 4 * (count + 1) doubles.
// Knot `count` ends an open line and is the first one of a closed line.
void swFitKnots(int count, bool isClosed, const double* steps, const double start[2], const double end[2],
                swSplineKnot* knots, double* scratch);

// The most between a fitted knot and the next one.
double swGetMostCurvature(const swSplineKnot* knot, double step);

// The words of a spline whose points and spans are there. Knots have their places; they are fitted.
swResult swMakeSplineWords(swSpline* spline, const swSplineSpan* spans, swSplineKnot* knots, const double* steps);
