// SPDX-License-Identifier: MIT
#pragma once

// What stands behind swSpline. Inputs share it: each holds it, and the last that lets it go frees it.
//
// The Bezier curve between two points, a span, is cut into segments of equal length. Through their ends, the knots, a
// cubic spline is laid whose parameter is the length of the line [de Boor 1978]: it is smooth to the second derivative,
// so that nothing looked up along it and beside it has a kink, and its speed is 1. shaders/shared/shape_spline.h
// evaluates it from the words that are made here.

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
    double* starts;           // [spanCount + 1]: of spans, along the line
    double originX, originZ;  // of the coordinates in words
    int spanCount, segmentCount;
    double leastX, leastZ, mostX, mostZ; // of the ribbon, in the coordinates of words
    double leastRadius;
    float* words; // as shape_spline.h reads them
    size_t wordCount;
    size_t memory;
    uint64_t hash;
};

void swHoldSpline(const swSpline* spline);
void swDropSpline(const swSpline* spline);

// What is left of a span when it is cut: its length, and into how many segments.
typedef struct swSplineSpan
{
    double length;
    int segmentCount;
    double leastRadius;
} swSplineSpan;

// A point of the curve and its direction.
typedef struct swSplineKnot
{
    double x, z;
    double tangentX, tangentZ; // of length 1
    double bendX, bendZ;       // second derivative by the length, 1/m
} swSplineKnot;

// Most segments of a span, and into how many it is cut at least.
#define SW_MOST_SPAN_SEGMENTS 192
#define SW_LEAST_SPAN_SEGMENTS 6

// How long a span is and how finely it has to be cut. SW_ERROR_INVALID and a sentence if it turns on the spot.
swResult swMeasureSpan(const swSpline* spline, int span, swSplineSpan* measured);

// Points after equal lengths of a span, from its first on: segmentCount of them.
void swCutSpan(const swSpline* spline, int span, const swSplineSpan* measured, swSplineKnot* knots);

// The directions at which the line leaves its first point and reaches its last one.
void swGetEndDirections(const swSpline* spline, double start[2], double end[2]);

// Bends and directions of a smooth line through knots that are steps[] apart; `scratch` has 4 * (count + 1) doubles.
// Knot `count` ends an open line and is the first one of a closed line.
void swFitKnots(int count, bool isClosed, const double* steps, const double start[2], const double end[2],
                swSplineKnot* knots, double* scratch);

// The words of a spline whose points and spans are there.
swResult swMakeSplineWords(swSpline* spline, const swSplineSpan* spans, const swSplineKnot* knots);
