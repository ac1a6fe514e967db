// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"
#include "math.h"

/// @file
/// Splines: smooth lines through points, with a width, for rivers, shores, channels and lakes. An input of shape
/// SW_SHAPE_SPLINE says what is along one (input.h); docs/splines.md shows how a river, a shore and a trail are made.
/// A spline never changes once it is made; any number of threads may read it.
///
/// Seen from above, the line is a cubic Bezier curve from point to point. At a point it runs parallel to the line
/// between the point's neighbours [Catmull and Rom 1974], and handles are 0.39 of the distance between points long, so
/// that a square becomes nearly a circle; the ends of an open line mirror the direction of their neighbour. Everything
/// goes by the length of the line as seen from above: heights run evenly from point to point without overshooting, so a
/// river whose points fall does not rise in between, and numbers of points blend by 3 t^2 - 2 t^3.
///
/// A point of the plane belongs to the line where it lies straight beside it. Inside of a bend that is narrower than
/// the ribbon, and where a line comes near itself, it may lie beside it more than once; what the line says there is a
/// mix that changes smoothly.

/// Points of a spline.
#define SW_MAX_SPLINE_POINTS 4096

/// Farthest that points of a spline may be from each other, along x and along z, m.
#define SW_MAX_SPLINE_SIDE 1e5

/// Points of a spline that follow each other are at least so far apart as seen from above, m.
#define SW_LEAST_SPLINE_STEP 0.01

/// On which side of its line a ribbon lies, as seen by somebody who follows the points.
typedef enum swSplineOffset
{
    SW_SPLINE_CENTRE, ///< half of the width to each side
    SW_SPLINE_LEFT,   ///< from the line to the left
    SW_SPLINE_RIGHT,  ///< from the line to the right
    SW_SPLINE_OFFSET_COUNT
} swSplineOffset;

/// Begin with swDefaultSplinePoint().
typedef struct swSplinePoint
{
    double x, z;  ///< m. Range [-1e9, 1e9]
    double y;     ///< height, m. Range [-1e6, 1e6]. Default 0
    float width;  ///< factor on swSplineDef::width. Range [0, 100]. Default 1
    float weight; ///< factor on how much of an input counts. Range [0, 10]. Default 1
    float flow;   ///< speed of the water along the line, m/s; below 0 against it. Range [-100, 100]. Default 2
    float foam;   ///< foam that is made, per second. Range [0, 100]. Default 1
    float level;  ///< of still water above y, m. Range [-1e4, 1e4]. Default 0
    float depth;  ///< of the sea floor under y, m. Range [-1e4, 1e4]. Default 0
} swSplinePoint;

SW_API swSplinePoint swDefaultSplinePoint(double x, double y, double z);
SW_API const swFields* swGetSplinePointFields(void);

/// Must be initialized with swDefaultSplineDef().
typedef struct swSplineDef
{
    /// For messages. At most 255 characters are kept. Default "spline".
    const char* name;

    /// In order; 2 or more, 3 or more if closed. They are copied. Default NULL, 0.
    const swSplinePoint* points;
    int pointCount;

    /// Whether the last point leads on to the first. Default false.
    bool isClosed;

    /// Default SW_SPLINE_CENTRE.
    swSplineOffset offset;

    /// All of the ribbon's width, m. Range [0.01, 10000]. Default 20.
    float width;

    /// Along the line from an end of an open ribbon, what is there grows from nothing to all, m. Range [0, 1e5].
    /// Default 0, 0: a hard edge.
    float startRamp, endRamp;

    /// Set by swDefaultSplineDef().
    int internalValue;
} swSplineDef;

SW_API swSplineDef swDefaultSplineDef(void);
SW_API const swFields* swGetSplineFields(void);

typedef struct swSpline swSpline;

/// @return SW_ERROR_INVALID (the host's log names the point and what is wrong with it), SW_ERROR_NO_MEMORY
SW_API swResult swCreateSpline(const swHost* host, const swSplineDef* def, swSpline** spline);

/// Inputs that use the spline keep what they need. NULL is allowed.
SW_API void swDestroySpline(swSpline* spline);

/// What it was made of. Name and points live as long as the spline.
SW_API swSplineDef swSpline_GetDef(const swSpline* spline);

typedef struct swSplineInfo
{
    double length;                       ///< of the line as seen from above, m
    double leastX, leastZ, mostX, mostZ; ///< of the line and its ribbon, m
    float leastRadius;                   ///< of its narrowest bend, m
    size_t memory;                       ///< bytes
    uint64_t hash;                       ///< of what it was made of but its name: the same on every machine
} swSplineInfo;

SW_API swSplineInfo swSpline_GetInfo(const swSpline* spline);

/// A place on or beside the line.
typedef struct swSplinePlace
{
    double distance;     ///< from the first point along the line as seen from above, m
    double aside;        ///< of a point that was asked about: how far it is from the line, to the left above 0, m
    int pointIndex;      ///< the last point before the place, or at it
    float curvature;     ///< 1/m; above 0 where the line bends to the left
    swVec2 tangent;      ///< unit vector along the line, x and z
    swSplinePoint point; ///< on the line; insert it behind pointIndex for a point more that says the same there
} swSplinePlace;

/// The place after a distance along the line, m: of an open line held within its ends, of a closed one taken round.
SW_API swSplinePlace swSpline_FindPlace(const swSpline* spline, double distance);

/// The place that is nearest to a point of the plane. Goes through the whole line: for editors, not for each frame.
SW_API swSplinePlace swSpline_FindNearest(const swSpline* spline, swPosXZ point);

/// Turn the order of points round, so that the line runs the other way. Flow and what is left and right of the line
/// change with it: set swSplinePoint::flow to its negative to keep the water's direction.
SW_API void swReverseSplinePoints(int count, swSplinePoint* points);
