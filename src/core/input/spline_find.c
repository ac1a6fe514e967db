// SPDX-License-Identifier: MIT
// Places on a spline for editors and hosts. What is asked of the water goes by shape_spline.h; here the same words are
// read, one segment after another.

#include <math.h>

#include "core/base/misuse.h"
#include "core/input/spline.h"
#include "shared/shape_spline.h"

static const float* getSpan(const swSpline* spline, int span)
{
    return spline->words + (size_t)spline->words[SW_RIBBON_SPANS] + (size_t)span * SW_SPAN_WORDS;
}

static sw_uint getKnotWord(const swSpline* spline, int segment)
{
    return (sw_uint)spline->words[SW_RIBBON_KNOTS] + (sw_uint)segment * SW_KNOT_WORDS;
}

// Where a segment's line is so far from its knot, in the coordinates of words.
static swPosXZ getLinePlace(const swSpline* spline, int segment, double a)
{
    const float* k = spline->words + getKnotWord(spline, segment);
    double step = (double)k[SW_KNOT_STEP];
    double place[2];
    for (int i = 0; i < 2; ++i)
    {
        double bend = (double)k[SW_KNOT_BEND_X + i], next = (double)k[SW_KNOT_WORDS + SW_KNOT_BEND_X + i];
        place[i] = (double)k[SW_KNOT_X + i] +
                   a * ((double)k[SW_KNOT_TANGENT_X + i] + a * (bend * 0.5 + a * (next - bend) / step / 6.0));
    }
    return (swPosXZ){place[0], place[1]};
}

// All about a foot on the line, from the shared formulas.
static swSplinePlace describe(const swSpline* spline, int segment, double a)
{
    sw_uint knot = getKnotWord(spline, segment);
    swPosXZ line = getLinePlace(spline, segment, a);
    float step = spline->words[knot + SW_KNOT_STEP];
    swFoot foot = swFindFoot(spline->words, knot, (float)line.x, (float)line.z, swMakeFootPlace(0.0f, (float)a, step));
    int index = (int)foot.span;
    double distance = spline->starts[index] + (double)spline->words[knot + SW_KNOT_ALONG] + a;
    return (swSplinePlace){
        .distance = distance,
        .pointIndex = index,
        .curvature = foot.curvature,
        .tangent = {foot.tangentX, foot.tangentZ},
        .point =
            {
                .x = spline->originX + line.x,
                .z = spline->originZ + line.z,
                .y = (double)swReadHeightAlong(spline->words, foot).value,
                .width = swReadAlong(spline->words, foot, SW_SPAN_WIDTH).value,
                .weight = swReadAlong(spline->words, foot, SW_SPAN_WEIGHT).value,
                .flow = swReadAlong(spline->words, foot, SW_SPAN_FLOW).value,
                .foam = swReadAlong(spline->words, foot, SW_SPAN_FOAM).value,
                .level = swReadAlong(spline->words, foot, SW_SPAN_LEVEL).value,
                .depth = swReadAlong(spline->words, foot, SW_SPAN_DEPTH).value,
            },
    };
}

static swSplinePlace noPlace(void)
{
    return (swSplinePlace){.distance = (double)NAN, .pointIndex = -1};
}

swSplinePlace swSpline_FindPlace(const swSpline* spline, double distance)
{
    SW_REQUIRE(spline != NULL, noPlace(), NULL, "swSpline_FindPlace() needs a spline");
    SW_REQUIRE(isfinite(distance), noPlace(), &spline->host, "swSpline_FindPlace() needs a finite distance");
    double length = spline->starts[spline->spanCount];
    double at = spline->def.isClosed ? distance - length * floor(distance / length) : fmin(fmax(distance, 0.0), length);
    int span = 0;
    while (span < spline->spanCount - 1 && spline->starts[span + 1] <= at)
    {
        span += 1;
    }
    const float* words = getSpan(spline, span);
    int first = (int)words[SW_SPAN_FIRST_KNOT];
    int end = span + 1 < spline->spanCount ? (int)words[SW_SPAN_WORDS + SW_SPAN_FIRST_KNOT] : spline->segmentCount;
    double along = at - spline->starts[span];
    int segment = end - 1;
    while (segment > first && (double)spline->words[getKnotWord(spline, segment) + SW_KNOT_ALONG] > along)
    {
        segment -= 1;
    }
    double start = (double)spline->words[getKnotWord(spline, segment) + SW_KNOT_ALONG];
    return describe(spline, segment, fmax(along - start, 0.0));
}

// The part of a segment that is nearest to a place of the words' coordinates, and the square of the distance. Between
// its ends it is where the way to the place is straight to the side; Newton's method goes there from the chord.
static double findNearestOfSegment(const swSpline* spline, int segment, swPosXZ place, double* a)
{
    double step = (double)spline->words[getKnotWord(spline, segment) + SW_KNOT_STEP];
    double best = (double)INFINITY;
    for (int i = 0; i <= 4; ++i)
    {
        swPosXZ line = getLinePlace(spline, segment, step * i / 4.0);
        double x = place.x - line.x, z = place.z - line.z;
        if (x * x + z * z < best)
        {
            best = x * x + z * z;
            *a = step * i / 4.0;
        }
    }
    // Golden section within a quarter to each side.
    double low = fmax(*a - step / 4.0, 0.0), high = fmin(*a + step / 4.0, step);
    for (int i = 0; i < 40; ++i)
    {
        double first = high - 0.6180339887498949 * (high - low), last = low + 0.6180339887498949 * (high - low);
        swPosXZ p = getLinePlace(spline, segment, first), q = getLinePlace(spline, segment, last);
        double pd = (place.x - p.x) * (place.x - p.x) + (place.z - p.z) * (place.z - p.z);
        double qd = (place.x - q.x) * (place.x - q.x) + (place.z - q.z) * (place.z - q.z);
        (pd < qd ? (high = last) : (low = first));
    }
    *a = 0.5 * (low + high);
    swPosXZ line = getLinePlace(spline, segment, *a);
    return (place.x - line.x) * (place.x - line.x) + (place.z - line.z) * (place.z - line.z);
}

swSplinePlace swSpline_FindNearest(const swSpline* spline, swPosXZ point)
{
    SW_REQUIRE(spline != NULL, noPlace(), NULL, "swSpline_FindNearest() needs a spline");
    SW_REQUIRE(isfinite(point.x) && isfinite(point.z), noPlace(), &spline->host,
               "swSpline_FindNearest() needs a finite point");
    swPosXZ place = {point.x - spline->originX, point.z - spline->originZ};
    double best = (double)INFINITY, at = 0.0;
    int nearest = 0;
    for (int i = 0; i < spline->segmentCount; ++i)
    {
        double a = 0.0, square = findNearestOfSegment(spline, i, place, &a);
        if (square < best)
        {
            best = square;
            at = a;
            nearest = i;
        }
    }
    swSplinePlace found = describe(spline, nearest, at);
    double side =
        (point.x - found.point.x) * (double)found.tangent.y - (point.z - found.point.z) * (double)found.tangent.x;
    found.aside = side >= 0.0 ? sqrt(best) : -sqrt(best);
    return found;
}

void swReverseSplinePoints(int count, swSplinePoint* points)
{
    SW_REQUIRE_VOID(count >= 0 && (count == 0 || points != NULL), NULL, "swReverseSplinePoints() needs points");
    for (int i = 0; i < count / 2; ++i)
    {
        swSplinePoint point = points[i];
        points[i] = points[count - 1 - i];
        points[count - 1 - i] = point;
    }
}
