// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>

#include <seaway/spline.h>

#include "core/input/spline.h"
#include "shared/shape_spline.h"

// ---- support ----

static swSpline* Create(const swSplineDef* def)
{
    swHost host = MakeHost();
    swSpline* spline = NULL;
    swResult result = swCreateSpline(&host, def, &spline);
    if (result != SW_SUCCESS)
    {
        print_error("%s", s_messages);
    }
    assert_int_equal(result, SW_SUCCESS);
    return spline;
}

static swSpline* CreateThrough(int count, const swSplinePoint* points, bool isClosed, float width)
{
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = count;
    def.isClosed = isClosed;
    def.width = width;
    return Create(&def);
}

static swInputRecord MakeRecord(int field, float feather)
{
    return (swInputRecord){.cosine = 1.0f, .weight = 1.0f, .gain = 1.0f, .field = (sw_uint)field, .feather = feather};
}

static swInputSample SampleAt(const swSpline* spline, const swInputRecord* record, double x, double z)
{
    return swSampleSpline(spline->words, *record, (float)(x - spline->originX), (float)(z - spline->originZ));
}

static swRibbonWaves FindWavesAt(const swSpline* spline, const swInputRecord* record, double x, double z)
{
    return swFindRibbonWaves(spline->words, *record, (float)(x - spline->originX), (float)(z - spline->originZ));
}

static float CoverAt(const swSpline* spline, double x, double z)
{
    swInputRecord record = MakeRecord(SW_FIELD_OF_WAVES, 0.0f);
    return SampleAt(spline, &record, x, z).share;
}

// A point beside the line.
static swPosXZ StepAside(const swSplinePlace* place, double aside)
{
    return (swPosXZ){place->point.x + aside * (double)place->tangent.y,
                     place->point.z - aside * (double)place->tangent.x};
}

// A river of a dozen points that falls, and whose numbers differ.
#define RIVER_POINTS 12
static void MakeRiver(swSplinePoint* points)
{
    uint32_t seed = 7;
    for (int i = 0; i < RIVER_POINTS; ++i)
    {
        points[i] = swDefaultSplinePoint(1000.0 + 60.0 * i, 30.0 - 2.0 * i - 3.0 * NextPart(&seed),
                                         -5000.0 + 50.0 * NextPart(&seed));
        points[i].width = (float)(0.8 + 0.5 * NextPart(&seed));
        points[i].flow = (float)(1.0 + 2.0 * NextPart(&seed));
        points[i].foam = (float)NextPart(&seed);
        points[i].level = (float)NextPart(&seed);
        points[i].weight = (float)(0.5 + 0.5 * NextPart(&seed));
        points[i].depth = (float)(1.0 + NextPart(&seed));
    }
}

#define RING_POINTS 7
static void MakeRing(swSplinePoint* points, double radius)
{
    for (int i = 0; i < RING_POINTS; ++i)
    {
        double angle = 2.0 * SW_PI * i / RING_POINTS;
        points[i] = swDefaultSplinePoint(radius * cos(angle), 1.0 + i, radius * sin(angle));
        points[i].flow = (float)(i - 3);
        points[i].foam = (float)(i * i);
        points[i].width = 1.0f + 0.1f * (float)i;
    }
}

// ---- the line ----

static void TheLinePassesThroughItsPoints(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    swSpline* spline = CreateThrough(RIVER_POINTS, points, false, 20.0f);
    for (int i = 0; i < RIVER_POINTS; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(spline, spline->starts[i < RIVER_POINTS - 1 ? i : RIVER_POINTS - 1]);
        assert_true(fabs(place.point.x - points[i].x) < 1e-4 && fabs(place.point.z - points[i].z) < 1e-4);
        assert_true(fabs(place.point.y - points[i].y) < 1e-4);
        swSplinePlace nearest = swSpline_FindNearest(spline, (swPosXZ){points[i].x, points[i].z});
        assert_true(fabs(nearest.aside) < 1e-3);
    }
    swDestroySpline(spline);
}

static void ASquareIsNearlyACircle(void** state)
{
    (void)state;
    swSplinePoint points[4];
    for (int i = 0; i < 4; ++i)
    {
        points[i] = swDefaultSplinePoint(100.0 * cos(0.5 * SW_PI * i), 0.0, 100.0 * sin(0.5 * SW_PI * i));
    }
    swSpline* spline = CreateThrough(4, points, true, 20.0f);
    double least = 1e9, most = 0.0, length = swSpline_GetInfo(spline).length;
    for (int i = 0; i < 400; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(spline, length * i / 400.0);
        double radius = sqrt(place.point.x * place.point.x + place.point.z * place.point.z);
        least = fmin(least, radius);
        most = fmax(most, radius);
    }
    print_message("radius of a square of 100 m: %.4f to %.4f m, length %.4f of the circle's\n", least, most,
                  length / (200.0 * SW_PI));
    assert_true(least > 99.9 && most < 100.1);
    swDestroySpline(spline);
}

static void EqualDistancesAreEqualWays(void** state)
{
    (void)state;
    // Points 1 m and 300 m apart: by the curve's own parameter, steps would differ by hundreds.
    const swSplinePoint points[5] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(1.0, 0.0, 0.2),
                                     swDefaultSplinePoint(300.0, 0.0, 80.0), swDefaultSplinePoint(310.0, 0.0, 60.0),
                                     swDefaultSplinePoint(400.0, 0.0, -100.0)};
    swSpline* spline = CreateThrough(5, points, false, 4.0f);
    double length = swSpline_GetInfo(spline).length, step = length / 20000.0, worst = 0.0;
    swSplinePlace before = swSpline_FindPlace(spline, 0.0);
    for (int i = 1; i <= 20000; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(spline, step * i);
        double x = place.point.x - before.point.x, z = place.point.z - before.point.z;
        worst = fmax(worst, fabs(sqrt(x * x + z * z) / step - 1.0));
        before = place;
    }
    print_message("steps along the line differ by %.2g\n", worst);
    assert_true(worst < 0.01);
    swDestroySpline(spline);
}

static void HeightsNeitherOvershootNorAreSmoothedAway(void** state)
{
    (void)state;
    // A fall between flat reaches.
    const double heights[6] = {20.0, 20.0, 20.0, 5.0, 5.0, 4.9};
    swSplinePoint points[6];
    for (int i = 0; i < 6; ++i)
    {
        points[i] = swDefaultSplinePoint(40.0 * i, heights[i], 10.0 * (i % 2));
    }
    swSpline* spline = CreateThrough(6, points, false, 10.0f);
    double before = 20.0, length = swSpline_GetInfo(spline).length;
    for (int i = 0; i <= 1000; ++i)
    {
        double y = swSpline_FindPlace(spline, length * i / 1000.0).point.y;
        assert_true(y <= before + 1e-5);
        before = y;
    }
    for (int i = 0; i < 6; ++i)
    {
        assert_true(fabs(swSpline_FindPlace(spline, spline->starts[i]).point.y - heights[i]) < 1e-5);
    }
    swDestroySpline(spline);
}

// ---- numbers of points ----

static void NumbersOfPointsAreExactAtEachPoint(const swSplinePoint* points, int count, bool isClosed)
{
    swSpline* spline = CreateThrough(count, points, isClosed, 20.0f);
    const swInputRecord level = MakeRecord(SW_FIELD_OF_LEVEL, 0.0f), floor = MakeRecord(SW_FIELD_OF_FLOOR, 0.0f);
    const swInputRecord flow = MakeRecord(SW_FIELD_OF_FLOW, 0.0f), foam = MakeRecord(SW_FIELD_OF_FOAM, 0.0f);
    for (int i = isClosed ? 0 : 1; i < (isClosed ? count : count - 1); ++i)
    {
        const swSplinePoint* point = &points[i];
        double x = point->x, z = point->z;
        assert_float_equal(SampleAt(spline, &level, x, z).value.x, (float)point->y + point->level, 1e-4f);
        assert_float_equal(SampleAt(spline, &floor, x, z).value.x, (float)point->y - point->depth, 1e-4f);
        assert_float_equal(SampleAt(spline, &foam, x, z).value.x, point->foam, 1e-4f);
        swInputSample s = SampleAt(spline, &flow, x, z);
        assert_float_equal(s.share, point->weight, 1e-4f);
        assert_float_equal(sqrtf(s.value.x * s.value.x + s.value.y * s.value.y), fabsf(point->flow), 1e-4f);
        swSplinePlace place = swSpline_FindNearest(spline, (swPosXZ){x, z});
        assert_float_equal(s.value.x, point->flow * place.tangent.x, 1e-3f);
        assert_float_equal(s.value.y, point->flow * place.tangent.y, 1e-3f);
        // The edge of the ribbon is where this point's own width says.
        double edge = 10.0 * (double)point->width;
        for (int side = -1; side <= 1; side += 2)
        {
            swPosXZ in = StepAside(&place, side * (edge - 0.01)), out = StepAside(&place, side * (edge + 0.01));
            assert_true(CoverAt(spline, in.x, in.z) > 0.0f && CoverAt(spline, out.x, out.z) == 0.0f);
        }
    }
    swDestroySpline(spline);
}

static void NumbersOfPointsAreExactAtEachPointOfARiverAndARing(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    NumbersOfPointsAreExactAtEachPoint(points, RIVER_POINTS, false);
    MakeRing(points, 80.0);
    NumbersOfPointsAreExactAtEachPoint(points, RING_POINTS, true);
}

// ---- coordinates ----

// The coordinates at a place: how far along, to the side, both with derivatives.
typedef struct Coordinates
{
    swInputChannel along, aside, stretch;
} Coordinates;

static Coordinates Locate(const swSpline* spline, double x, double z)
{
    const swInputRecord record = MakeRecord(SW_FIELD_OF_WAVES, 0.0f);
    swRibbonWaves waves = FindWavesAt(spline, &record, x, z);
    assert_true(waves.share.value > 0.0f);
    return (Coordinates){swMeasureAlong(spline->words, waves.foot), waves.foot.aside, waves.foot.stretch};
}

static void CoordinatesAreThoseOfThePlace(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    swSpline* spline = CreateThrough(RIVER_POINTS, points, false, 30.0f);
    double length = swSpline_GetInfo(spline).length, worst = 0.0;
    for (int i = 0; i < 3000; ++i)
    {
        double distance = length * (i + 0.5) / 3000.0, aside = 8.0 * sin(0.37 * i);
        swSplinePlace place = swSpline_FindPlace(spline, distance);
        swPosXZ point = StepAside(&place, aside);
        Coordinates c = Locate(spline, point.x, point.z);
        worst = fmax(worst, fabs((double)c.along.value - distance));
        worst = fmax(worst, fabs((double)c.aside.value - aside));
        assert_float_equal(c.stretch.value, 1.0f - place.curvature * (float)aside, 2e-3f);
    }
    print_message("coordinates are off by %.2g m\n", worst);
    assert_true(worst < 2e-3);
    swDestroySpline(spline);
}

// Walks across all joints beside the line in small steps. Along, aside and their derivatives change by what the line's
// bending asks for, never by a step.
static void NothingJumpsAtJointsOf(const swSplinePoint* points, int count, bool isClosed, double aside)
{
    swSpline* spline = CreateThrough(count, points, isClosed, 30.0f);
    double length = swSpline_GetInfo(spline).length, step = 0.002;
    double worstValue = 0.0, worstSlope = 0.0;
    for (int i = 0; i < spline->segmentCount; ++i)
    {
        // The joint at this segment's beginning.
        const float* knot = spline->words + (size_t)spline->words[SW_RIBBON_KNOTS] + (size_t)i * SW_KNOT_WORDS;
        double x = spline->originX + (double)knot[SW_KNOT_X], z = spline->originZ + (double)knot[SW_KNOT_Z];
        if (i == 0 && !isClosed)
        {
            continue;
        }
        double tx = (double)knot[SW_KNOT_TANGENT_X], tz = (double)knot[SW_KNOT_TANGENT_Z];
        x += aside * tz;
        z -= aside * tx;
        Coordinates a = Locate(spline, x - step * tx, z - step * tz), b = Locate(spline, x + step * tx, z + step * tz);
        double way = (double)(b.along.value - a.along.value);
        way += i == 0 ? length : 0.0;
        double expected = step * (1.0 / (double)a.stretch.value + 1.0 / (double)b.stretch.value);
        worstValue = fmax(worstValue, fabs(way - expected));
        worstValue = fmax(worstValue, fabs((double)(b.aside.value - a.aside.value)));
        worstSlope = fmax(worstSlope, fabs((double)(b.along.alongX - a.along.alongX)));
        worstSlope = fmax(worstSlope, fabs((double)(b.along.alongZ - a.along.alongZ)));
        worstSlope = fmax(worstSlope, fabs((double)(b.aside.alongX - a.aside.alongX)));
    }
    print_message("%s, %g m aside: steps of at most %.2g m, of derivatives %.2g\n", isClosed ? "ring" : "river", aside,
                  worstValue, worstSlope);
    assert_true(worstValue < 1e-3 && worstSlope < 2e-3);
    swDestroySpline(spline);
}

static void NothingJumpsAtJoints(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    NothingJumpsAtJointsOf(points, RIVER_POINTS, false, 0.0);
    NothingJumpsAtJointsOf(points, RIVER_POINTS, false, 9.0);
    NothingJumpsAtJointsOf(points, RIVER_POINTS, false, -9.0);
    // A ring has a joint more, where its end is its beginning: both of its edges are closed.
    MakeRing(points, 80.0);
    NothingJumpsAtJointsOf(points, RING_POINTS, true, 14.0);
    NothingJumpsAtJointsOf(points, RING_POINTS, true, -14.0);
}

static double Differ(double a, double b, double step)
{
    return (a - b) / (2.0 * step);
}

static void DerivativesAreThoseOfTheValues(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    swSpline* spline = CreateThrough(RIVER_POINTS, points, false, 60.0f);
    const int fields[4] = {SW_FIELD_OF_LEVEL, SW_FIELD_OF_FLOW, SW_FIELD_OF_FOAM, SW_FIELD_OF_FLOOR};
    const double h = 0.05;
    swPosXZ scattered[4000];
    ScatterPoints(scattered, 4000, 1330.0, -4975.0, 300.0);
    double worst = 0.0, worstWaves = 0.0;
    int count = 0;
    for (int i = 0; i < 4000; ++i)
    {
        swInputRecord record = MakeRecord(fields[i % 4], 12.0f);
        double x = scattered[i].x, z = scattered[i].z;
        swInputSample s = SampleAt(spline, &record, x, z);
        swInputSample e = SampleAt(spline, &record, x + h, z), w = SampleAt(spline, &record, x - h, z);
        swInputSample n = SampleAt(spline, &record, x, z + h), o = SampleAt(spline, &record, x, z - h);
        if (s.share <= 0.0f || e.share <= 0.0f || w.share <= 0.0f || n.share <= 0.0f || o.share <= 0.0f)
        {
            continue;
        }
        count += 1;
        worst = fmax(worst, fabs(Differ((double)e.value.x, (double)w.value.x, h) - (double)s.valueX.x));
        worst = fmax(worst, fabs(Differ((double)n.value.x, (double)o.value.x, h) - (double)s.valueZ.x));
        worst = fmax(worst, fabs(Differ((double)e.share, (double)w.share, h) - (double)s.shareX));
        worst = fmax(worst, fabs(Differ((double)n.share, (double)o.share, h) - (double)s.shareZ));
        swInputChannel c = FindWavesAt(spline, &record, x, z).share;
        double alongX = Differ((double)FindWavesAt(spline, &record, x + h, z).share.value,
                               (double)FindWavesAt(spline, &record, x - h, z).share.value, h);
        double alongZ = Differ((double)FindWavesAt(spline, &record, x, z + h).share.value,
                               (double)FindWavesAt(spline, &record, x, z - h).share.value, h);
        worstWaves = fmax(worstWaves, fmax(fabs(alongX - (double)c.alongX), fabs(alongZ - (double)c.alongZ)));
    }
    print_message("%d places: derivatives differ from differences by %.2g, of waves' weight %.2g\n", count, worst,
                  worstWaves);
    assert_true(count > 500 && worst < 0.02 && worstWaves < 0.02);
    swDestroySpline(spline);
}

// ---- loops, hairpins, wide ribbons ----

static void APlaceInTheMiddleOfAWideRingIsCovered(void** state)
{
    (void)state;
    // The ribbon is wider than the ring: all of its inside is covered, at one level, and waves fade to its middle.
    swSplinePoint points[4];
    for (int i = 0; i < 4; ++i)
    {
        points[i] = swDefaultSplinePoint(80.0 * cos(0.5 * SW_PI * i), 12.0, 80.0 * sin(0.5 * SW_PI * i));
    }
    swSpline* spline = CreateThrough(4, points, true, 400.0f);
    const swInputRecord level = MakeRecord(SW_FIELD_OF_LEVEL, 0.0f), flow = MakeRecord(SW_FIELD_OF_FLOW, 0.0f);
    float before = 1.0f;
    for (int i = 0; i <= 800; ++i)
    {
        double x = 80.0 - 0.1 * i, z = 1e-3;
        swInputSample s = SampleAt(spline, &level, x, z);
        assert_true(s.share == 1.0f);
        assert_float_equal(s.value.x, 12.0f, 1e-4f);
        assert_true(fabsf(s.valueX.x) < 1e-4f && fabsf(s.valueZ.x) < 1e-4f);
        float waves = FindWavesAt(spline, &level, x, z).share.value;
        assert_true(waves <= before + 1e-5f);
        before = waves;
    }
    assert_true(before == 0.0f);
    assert_true(SampleAt(spline, &flow, 0.0, 1e-3).share < 0.01f);
    swDestroySpline(spline);
}

static void WavesOfAHairpinFadeWhereBothBranchesAreAsNear(void** state)
{
    (void)state;
    const swSplinePoint points[6] = {swDefaultSplinePoint(0.0, 0.0, -20.0),   swDefaultSplinePoint(100.0, 0.0, -20.0),
                                     swDefaultSplinePoint(200.0, 0.0, -20.0), swDefaultSplinePoint(200.0, 0.0, 20.0),
                                     swDefaultSplinePoint(100.0, 0.0, 20.0),  swDefaultSplinePoint(0.0, 0.0, 20.0)};
    swSpline* spline = CreateThrough(6, points, false, 60.0f);
    const swInputRecord record = MakeRecord(SW_FIELD_OF_WAVES, 5.0f);
    float before = FindWavesAt(spline, &record, 50.0, -20.0).share.value;
    assert_float_equal(before, 1.0f, 1e-6f);
    for (int i = 1; i <= 2000; ++i)
    {
        float share = FindWavesAt(spline, &record, 50.0, -20.0 + 0.02 * i).share.value;
        assert_true(share <= before + 1e-5f || i > 1000);
        assert_true(fabsf(share - before) < 0.03f);
        before = share;
    }
    assert_float_equal(FindWavesAt(spline, &record, 50.0, 0.0).share.value, 0.0f, 1e-3f);
    assert_float_equal(before, 1.0f, 1e-6f);
    swDestroySpline(spline);
}

static void AReversedLineHasItsSidesChanged(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    swSpline* there = CreateThrough(RIVER_POINTS, points, false, 30.0f);
    swReverseSplinePoints(RIVER_POINTS, points);
    swSpline* back = CreateThrough(RIVER_POINTS, points, false, 30.0f);
    double length = swSpline_GetInfo(there).length;
    assert_true(fabs(length - swSpline_GetInfo(back).length) < 1e-6);
    const swInputRecord level = MakeRecord(SW_FIELD_OF_LEVEL, 3.0f), flow = MakeRecord(SW_FIELD_OF_FLOW, 3.0f);
    for (int i = 1; i < 500; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(there, length * i / 500.0);
        swPosXZ p = StepAside(&place, 9.0 * sin(0.7 * i));
        swInputSample a = SampleAt(there, &level, p.x, p.z), b = SampleAt(back, &level, p.x, p.z);
        assert_float_equal(a.value.x, b.value.x, 1e-3f);
        assert_float_equal(a.share, b.share, 1e-3f);
        assert_float_equal(a.valueX.x, b.valueX.x, 1e-3f);
        a = SampleAt(there, &flow, p.x, p.z);
        b = SampleAt(back, &flow, p.x, p.z);
        assert_float_equal(a.value.x, -b.value.x, 2e-3f);
        assert_float_equal(a.value.y, -b.value.y, 2e-3f);
        Coordinates c = Locate(there, p.x, p.z), d = Locate(back, p.x, p.z);
        assert_float_equal(c.aside.value, -d.aside.value, 1e-3f);
        assert_true(fabs((double)c.along.value + (double)d.along.value - length) < 2e-3);
    }
    swDestroySpline(there);
    swDestroySpline(back);
}

static void AMirroredLineSaysTheSameOnTheOtherSide(void** state)
{
    (void)state;
    swSplinePoint points[RIVER_POINTS];
    MakeRiver(points);
    swSpline* spline = CreateThrough(RIVER_POINTS, points, false, 30.0f);
    for (int i = 0; i < RIVER_POINTS; ++i)
    {
        points[i].z = -points[i].z;
    }
    swSpline* mirrored = CreateThrough(RIVER_POINTS, points, false, 30.0f);
    double length = swSpline_GetInfo(spline).length;
    for (int i = 1; i < 500; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(spline, length * i / 500.0);
        swPosXZ p = StepAside(&place, 9.0 * sin(0.7 * i));
        Coordinates c = Locate(spline, p.x, p.z), d = Locate(mirrored, p.x, -p.z);
        assert_float_equal(c.aside.value, -d.aside.value, 1e-3f);
        assert_float_equal(c.along.value, d.along.value, 2e-3f);
        assert_float_equal(c.stretch.value, d.stretch.value, 2e-3f);
    }
    swDestroySpline(spline);
    swDestroySpline(mirrored);
}

static void RibbonsLieOnTheSideTheyAreAskedFor(void** state)
{
    (void)state;
    // Eastwards: left is north, -z.
    const swSplinePoint points[2] = {swDefaultSplinePoint(-100.0, 0.0, 0.0), swDefaultSplinePoint(100.0, 0.0, 0.0)};
    const double edges[SW_SPLINE_OFFSET_COUNT][2] = {{-10.0, 10.0}, {-20.0, 0.0}, {0.0, 20.0}};
    for (int offset = 0; offset < SW_SPLINE_OFFSET_COUNT; ++offset)
    {
        swSplineDef def = swDefaultSplineDef();
        def.points = points;
        def.pointCount = 2;
        def.offset = (swSplineOffset)offset;
        swSpline* spline = Create(&def);
        for (int side = 0; side < 2; ++side)
        {
            double in = side == 0 ? 0.01 : -0.01;
            assert_true(CoverAt(spline, 3.0, edges[offset][side] + in) == 1.0f);
            assert_true(CoverAt(spline, 3.0, edges[offset][side] - in) == 0.0f);
        }
        assert_true(CoverAt(spline, -100.01, 0.0) == 0.0f && CoverAt(spline, 100.01, 0.0) == 0.0f);
        swDestroySpline(spline);
    }
}

static void RampsGrowFromTheEnds(void** state)
{
    (void)state;
    const swSplinePoint points[2] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(100.0, 0.0, 0.0)};
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 2;
    def.startRamp = 40.0f;
    def.endRamp = 10.0f;
    swSpline* spline = Create(&def);
    assert_float_equal(CoverAt(spline, 20.0, 0.0), 0.5f, 1e-5f);
    assert_float_equal(CoverAt(spline, 60.0, 0.0), 1.0f, 1e-5f);
    assert_float_equal(CoverAt(spline, 95.0, 0.0), 0.5f, 1e-5f);
    swDestroySpline(spline);
}

// ---- what is refused ----

static void ExpectRefused(const swSplineDef* def, const char* part)
{
    swHost host = MakeHost();
    swSpline* spline = (swSpline*)&host;
    assert_int_equal(swCreateSpline(&host, def, &spline), SW_ERROR_INVALID);
    assert_null(spline);
    if (strstr(s_messages, part) == NULL)
    {
        print_error("%s has no \"%s\"\n", s_messages, part);
    }
    assert_non_null(strstr(s_messages, part));
    assert_true(strchr(s_messages, '\n') == s_messages + strlen(s_messages) - 1); // one sentence
}

static void BadSplinesAreRefusedWithASentence(void** state)
{
    (void)state;
    swSplinePoint points[4] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(100.0, 0.0, 0.0),
                               swDefaultSplinePoint(100.0, 0.0, 100.0), swDefaultSplinePoint(0.0, 0.0, 100.0)};
    swSplineDef def = swDefaultSplineDef();
    def.name = "brook";
    def.points = points;
    def.pointCount = 1;
    ExpectRefused(&def, "brook has 1 points; a spline needs 2 or more");
    def.pointCount = 0;
    ExpectRefused(&def, "brook has 0 points");
    def.pointCount = 2;
    def.isClosed = true;
    ExpectRefused(&def, "a closed spline needs 3 or more");
    def.isClosed = false;
    def.points = NULL;
    ExpectRefused(&def, "brook has 0 points");
    def.points = points;
    def.pointCount = 4;
    points[2] = points[1];
    ExpectRefused(&def, "Points 1 and 2 of brook");
    points[2] = points[0];
    def.pointCount = 3;
    def.isClosed = true;
    ExpectRefused(&def, "Points 2 and 0 of brook");
    def.isClosed = false;
    points[2] = swDefaultSplinePoint(100.0, (double)NAN, 100.0);
    ExpectRefused(&def, "Point 2 of brook, counted from 0: swSplinePoint::y is");
    points[2] = swDefaultSplinePoint(2e5, 0.0, 100.0);
    ExpectRefused(&def, "brook is 200000 m by 100 m large");
    points[2] = swDefaultSplinePoint(50.0, 0.0, 0.0); // straight back over itself
    ExpectRefused(&def, "brook turns on the spot between point 1 and point 2");
    points[2] = swDefaultSplinePoint(100.0, 0.0, 100.0);
    points[1].flow = 1e6f;
    ExpectRefused(&def, "Point 1 of brook, counted from 0: swSplinePoint::flow is");
    points[1].flow = 1.0f;
    def.width = (float)NAN;
    ExpectRefused(&def, "swSplineDef::width is");
}

static void NoMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 80.0);
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = RING_POINTS;
    def.isClosed = true;
    swSpline* spline = NULL;
    int failures = 0;
    for (;; ++failures)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, failures);
        if (swCreateSpline(&host, &def, &spline) == SW_SUCCESS)
        {
            break;
        }
        assert_null(spline);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    assert_int_equal(failures, 5);
    assert_int_equal((size_t)atomic_load(&memory.bytes), swSpline_GetInfo(spline).memory);
    // Who holds it keeps it alive.
    swRetainSpline(spline);
    swDestroySpline(spline);
    assert_true(swSpline_GetInfo(spline).length > 500.0);
    swReleaseSpline(spline);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    swDestroySpline(NULL);
}

// Words in saved moments come from outside: whatever one of them is changed to, reading leads nowhere else.
static void SpoiltWordsAreRefusedOrHarmless(void** state)
{
    (void)state;
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 80.0);
    swSpline* spline = CreateThrough(RING_POINTS, points, true, 30.0f);
    assert_true(swAreSplineWordsGood(spline->words, spline->wordCount));
    assert_false(swAreSplineWordsGood(spline->words, spline->wordCount - 1));
    const float bad[6] = {-1.0f, 0.5f, 1e6f, NAN, INFINITY, 3.0f};
    const swInputRecord record = MakeRecord(SW_FIELD_OF_LEVEL, 2.0f);
    int refused = 0;
    for (size_t i = 0; i < spline->wordCount; ++i)
    {
        float good = spline->words[i];
        for (int k = 0; k < 6; ++k)
        {
            spline->words[i] = bad[k];
            if (!swAreSplineWordsGood(spline->words, spline->wordCount))
            {
                refused += 1;
                continue;
            }
            SampleAt(spline, &record, 70.0, 3.0);
            FindWavesAt(spline, &record, 81.0, -3.0);
        }
        spline->words[i] = good;
    }
    assert_true(refused > 100);
    swDestroySpline(spline);
}

static void AnyChangeHasAnotherHash(void** state)
{
    (void)state;
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 80.0);
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = RING_POINTS;
    swSpline* spline = Create(&def);
    uint64_t hash = swSpline_GetInfo(spline).hash;
    swDestroySpline(spline);
    for (int change = 0; change < 5; ++change)
    {
        swSplineDef other = def;
        points[3].foam = change == 0 ? 9.5f : 9.0f;
        points[2].z += change == 1 ? 1e-9 : 0.0;
        other.isClosed = change == 2;
        other.offset = change == 3 ? SW_SPLINE_LEFT : SW_SPLINE_CENTRE;
        spline = Create(&other);
        assert_int_equal(swSpline_GetInfo(spline).hash == hash, change == 4);
        points[2].z = 80.0 * sin(2.0 * SW_PI * 2.0 / RING_POINTS);
        swDestroySpline(spline);
    }
}

// ---- any spline at all ----

static swSpline* CreateAny(uint32_t* seed, int* refused)
{
    swSplinePoint points[24];
    int count = 3 + (int)(20.0 * NextPart(seed));
    for (int i = 0; i < count; ++i)
    {
        points[i] = swDefaultSplinePoint(400.0 * NextPart(seed), 20.0 * NextPart(seed), 400.0 * NextPart(seed));
        points[i].width = (float)(0.2 + 2.0 * NextPart(seed));
        points[i].weight = (float)NextPart(seed);
        points[i].flow = (float)(6.0 * NextPart(seed) - 3.0);
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = count;
    def.isClosed = NextPart(seed) < 0.5;
    def.offset = (swSplineOffset)(int)(2.999 * NextPart(seed));
    def.width = (float)(1.0 + 60.0 * NextPart(seed));
    def.startRamp = def.endRamp = 10.0f;
    swHost host = MakeHost();
    swSpline* spline = NULL;
    *refused += swCreateSpline(&host, &def, &spline) == SW_SUCCESS ? 0 : 1;
    return spline;
}

typedef struct Walk
{
    const swSpline* spline;
    swInputRecord record;
    double z;
    int places, jumps;
} Walk;

typedef struct Said
{
    float share, waves, value;
} Said;

static Said AskAt(Walk* walk, double x)
{
    swInputSample s = SampleAt(walk->spline, &walk->record, x, walk->z);
    swInputChannel waves = FindWavesAt(walk->spline, &walk->record, x, walk->z).share;
    assert_true(isfinite(s.value.x) && isfinite(s.value.y) && isfinite(s.valueX.x) && isfinite(s.valueZ.y));
    assert_true(s.share >= 0.0f && s.share <= 1.0001f && isfinite(s.shareX) && isfinite(s.shareZ));
    assert_true(waves.value >= 0.0f && waves.value <= 1.0001f && isfinite(waves.alongX) && isfinite(waves.alongZ));
    walk->places += s.share > 0.0f ? 1 : 0;
    return (Said){s.share, waves.value, s.share * s.value.x};
}

// What differs much between two places is looked at more closely: a jump is one that is still there within 0.05 mm.
static void LookBetween(Walk* walk, double from, double to, Said a, Said b)
{
    if (fabsf(a.share - b.share) < 0.1f && fabsf(a.waves - b.waves) < 0.1f && fabsf(a.value - b.value) < 1.0f)
    {
        return;
    }
    if (to - from < 5e-5)
    {
        walk->jumps += 1;
        print_message("at %.4f %.3f field %u: share %g %g waves %g %g value %g %g\n", from, walk->z, walk->record.field,
                      (double)a.share, (double)b.share, (double)a.waves, (double)b.waves, (double)a.value,
                      (double)b.value);
        return;
    }
    double middle = 0.5 * (from + to);
    Said m = AskAt(walk, middle);
    LookBetween(walk, from, middle, a, m);
    LookBetween(walk, middle, to, m, b);
}

static void EachOfAThousandSplinesIsSoundEverywhere(void** state)
{
    (void)state;
    uint32_t seed = 99;
    int refused = 0, places = 0, jumps = 0;
    const int fields[3] = {SW_FIELD_OF_LEVEL, SW_FIELD_OF_FLOW, SW_FIELD_OF_WAVES};
    for (int i = 0; i < 1000; ++i)
    {
        swSpline* spline = CreateAny(&seed, &refused);
        for (int line = 0; line < 4 && spline != NULL; ++line)
        {
            Walk walk = {spline, MakeRecord(fields[i % 3], 5.0f), 400.0 * NextPart(&seed), 0, 0};
            Said before = AskAt(&walk, 150.0);
            for (int k = 1; k < 600; ++k)
            {
                Said said = AskAt(&walk, 150.0 + 0.1 * k);
                LookBetween(&walk, 149.9 + 0.1 * k, 150.0 + 0.1 * k, before, said);
                before = said;
            }
            places += walk.places;
            jumps += walk.jumps;
        }
        swDestroySpline(spline);
    }
    print_message("%d of 1000 refused, %d places in ribbons, %d jumps\n", refused, places, jumps);
    assert_true(refused < 100 && places > 100000);
    assert_int_equal(jumps, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheLinePassesThroughItsPoints),
        cmocka_unit_test(ASquareIsNearlyACircle),
        cmocka_unit_test(EqualDistancesAreEqualWays),
        cmocka_unit_test(HeightsNeitherOvershootNorAreSmoothedAway),
        cmocka_unit_test(NumbersOfPointsAreExactAtEachPointOfARiverAndARing),
        cmocka_unit_test(CoordinatesAreThoseOfThePlace),
        cmocka_unit_test(NothingJumpsAtJoints),
        cmocka_unit_test(DerivativesAreThoseOfTheValues),
        cmocka_unit_test(APlaceInTheMiddleOfAWideRingIsCovered),
        cmocka_unit_test(WavesOfAHairpinFadeWhereBothBranchesAreAsNear),
        cmocka_unit_test(AReversedLineHasItsSidesChanged),
        cmocka_unit_test(AMirroredLineSaysTheSameOnTheOtherSide),
        cmocka_unit_test(RibbonsLieOnTheSideTheyAreAskedFor),
        cmocka_unit_test(RampsGrowFromTheEnds),
        cmocka_unit_test(BadSplinesAreRefusedWithASentence),
        cmocka_unit_test(NoMemoryLeavesNothingBehind),
        cmocka_unit_test(SpoiltWordsAreRefusedOrHarmless),
        cmocka_unit_test(AnyChangeHasAnotherHash),
        cmocka_unit_test(EachOfAThousandSplinesIsSoundEverywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
