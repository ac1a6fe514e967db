// SPDX-License-Identifier: MIT
// Inputs along splines by the public API: rivers, and waves that turn with a line. Most seas have one wave whose shape
// is known everywhere, so that it can be held against the coordinates along and across the line.

#include "support/cmocka_setup.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>
#include <string.h>

#include <seaway/seaway.h>

#define WAVELENGTH 20.0f
#define AMPLITUDE 0.25f

// ---- seas ----

typedef struct Sea
{
    swHost host;
    swWorld* world;
    swWaveSystemId waves;
    swSpline* spline;
    swInputDef def;
    swInputId input;
} Sea;

// One wave, which goes along x in its own coordinates.
static void OpenSea(Sea* sea, float chop, bool isLocal)
{
    static const swWaveComponent wave = {.wavelength = WAVELENGTH, .amplitude = AMPLITUDE};
    sea->host = MakeHost();
    swWorldDef worldDef = swDefaultWorldDef();
    assert_int_equal(swCreateWorld(&sea->host, &worldDef, &sea->world), SW_SUCCESS);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.method = SW_WAVES_GERSTNER;
    waves.components = &wave;
    waves.componentCount = 1;
    waves.chop = chop;
    waves.isLocal = isLocal;
    assert_int_equal(swCreateWaveSystem(sea->world, &waves, &sea->waves), SW_SUCCESS);
}

// The wave runs along a spline.
static void RunAlong(Sea* sea, const swSplineDef* splineDef, float headingDegrees)
{
    assert_int_equal(swCreateSpline(&sea->host, splineDef, &sea->spline), SW_SUCCESS);
    sea->def = swDefaultInputDef();
    sea->def.field = SW_INPUT_WAVES;
    sea->def.shape = SW_SHAPE_SPLINE;
    sea->def.system = sea->waves;
    sea->def.spline = sea->spline;
    sea->def.alongSpline = true;
    sea->def.heading = headingDegrees * (float)(SW_PI / 180.0);
    if (swCreateInput(sea->world, &sea->def, &sea->input) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    assert_int_equal(swWorld_Step(sea->world, 0.0), SW_SUCCESS);
}

static void CloseSea(Sea* sea)
{
    swDestroyWorld(sea->world);
    swDestroySpline(sea->spline);
}

static float HeightAt(const Sea* sea, double x, double z)
{
    return swMoment_GetHeight(swWorld_GetMoment(sea->world), x, z);
}

static swPosXZ StepAside(const swSplinePlace* place, double aside)
{
    return (swPosXZ){place->point.x + aside * (double)place->tangent.y,
                     place->point.z - aside * (double)place->tangent.x};
}

#define RING_POINTS 4
static void MakeRing(swSplinePoint* points, double radius)
{
    for (int i = 0; i < RING_POINTS; ++i)
    {
        double angle = 2.0 * SW_PI * i / RING_POINTS;
        points[i] = swDefaultSplinePoint(radius * cos(angle), 0.0, radius * sin(angle));
    }
}

#define SHORE_POINTS 8
static swSplineDef MakeShore(swSplinePoint* points, float width)
{
    for (int i = 0; i < SHORE_POINTS; ++i)
    {
        points[i] = swDefaultSplinePoint(3000.0 + 90.0 * i, 0.0, -800.0 + (i % 3 == 0 ? 0.0 : 35.0));
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = SHORE_POINTS;
    def.width = width;
    return def;
}

// ---- wavelengths ----

static float GetWaveHeight(double way)
{
    return AMPLITUDE * (float)cos(2.0 * SW_PI / (double)WAVELENGTH * way);
}

// The height of each place is that of the wave by its metres along and across.
static void ExpectWavesBy(float headingDegrees)
{
    swSplinePoint points[SHORE_POINTS];
    swSplineDef def = MakeShore(points, 60.0f);
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    RunAlong(&sea, &def, headingDegrees);
    double heading = (double)sea.def.heading, length = swSpline_GetInfo(sea.spline).length, worst = 0.0;
    for (int i = 1; i < 1000; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(sea.spline, length * i / 1000.0);
        double aside = 20.0 * sin(0.9 * i);
        swPosXZ p = StepAside(&place, aside);
        double way = cos(heading) * aside + sin(heading) * place.distance;
        worst = fmax(worst, fabs((double)(HeightAt(&sea, p.x, p.z) - GetWaveHeight(way))));
    }
    print_message("heading %g: heights are off by %.2g m of %g\n", (double)headingDegrees, worst, (double)AMPLITUDE);
    assert_true(worst < 0.002);
    CloseSea(&sea);
}

static void WavesLieByTheMetresAlongAndAcross(void** state)
{
    (void)state;
    ExpectWavesBy(0.0f);
    ExpectWavesBy(90.0f);
    ExpectWavesBy(180.0f);
    ExpectWavesBy(35.0f);
}

// Metres of the way for one wave, on a circle around the ring's middle.
static double MeasureWavelength(const Sea* sea, double radius, double from, double to)
{
    int crossings = 0, steps = 40000;
    double first = 0.0, last = 0.0, step = (to - from) / steps;
    float before = HeightAt(sea, radius * cos(from), radius * sin(from));
    for (int i = 1; i <= steps; ++i)
    {
        double angle = from + step * i;
        float height = HeightAt(sea, radius * cos(angle), radius * sin(angle));
        if (before < 0.0f && height >= 0.0f)
        {
            last = angle - step * (double)(height / (height - before));
            first = crossings == 0 ? last : first;
            crossings += 1;
        }
        before = height;
    }
    return radius * (last - first) / (crossings - 1);
}

static void ALineIsAsLongAsItsWavesSayAndABendChangesThemBeside(void** state)
{
    (void)state;
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 200.0);
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = RING_POINTS;
    def.isClosed = true;
    def.width = 200.0f;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    RunAlong(&sea, &def, 90.0f);
    // Beyond the seam. Points go round from +x to +z, to the right: the left is outside.
    for (int i = -2; i <= 2; ++i)
    {
        double radius = 200.0 + 25.0 * i, length = MeasureWavelength(&sea, radius, 1.2, 5.5);
        double expected = (double)WAVELENGTH * radius / 200.0;
        print_message("%g m from the line: a wave of %.4f m, %.4f expected\n", radius - 200.0, length, expected);
        assert_true(fabs(length / expected - 1.0) < 2e-3);
    }
    CloseSea(&sea);
}

// ---- nothing jumps ----

static void ARingHasNoSeamInItsWaves(void** state)
{
    (void)state;
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 150.3);
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = RING_POINTS;
    def.isClosed = true;
    def.width = 80.0f;
    Sea sea;
    OpenSea(&sea, 0.7f, true);
    RunAlong(&sea, &def, 70.0f);
    double worst = 0.0, energy = 0.0;
    float before = HeightAt(&sea, 160.0 * cos(-0.5), 160.0 * sin(-0.5));
    for (int i = 1; i <= 40000; ++i)
    {
        double angle = -0.5 + 2.0 * i / 40000.0; // 8 mm a step
        float height = HeightAt(&sea, 160.0 * cos(angle), 160.0 * sin(angle));
        worst = fmax(worst, fabs((double)(height - before)));
        energy += (double)(height * height);
        before = height;
    }
    double rms = sqrt(energy / 40000.0) / (double)AMPLITUDE;
    print_message("across a ring's seam: %.2g m within 8 mm at most, root mean square %.3f of the amplitude\n", worst,
                  rms);
    assert_true(worst < 1.6 * 0.008 * 2.0 * SW_PI / (double)WAVELENGTH * (double)AMPLITUDE);
    assert_true(rms > 0.45 && rms < 0.95);
    CloseSea(&sea);
}

static void NormalsAreThoseOfTheHeights(void** state)
{
    (void)state;
    swSplinePoint points[SHORE_POINTS];
    swSplineDef def = MakeShore(points, 70.0f);
    def.startRamp = def.endRamp = 60.0f;
    Sea sea;
    OpenSea(&sea, 1.0f, true);
    RunAlong(&sea, &def, 25.0f);
    sea.def.feather = 20.0f;
    assert_int_equal(swInput_Set(sea.world, sea.input, &sea.def), SW_SUCCESS);
    swWorld_Step(sea.world, 0.0);
    enum
    {
        COUNT = 3000
    };
    static swPosXZ at[COUNT], beside[4][COUNT];
    static float heights[4][COUNT];
    static swVec3 normals[COUNT];
    ScatterPoints(at, COUNT, 3310.0, -790.0, 600.0);
    const double h = 0.02;
    swQueryDef query = swDefaultQueryDef();
    query.tolerance = 1e-5f;
    const swSurfaceSamples samples = {.normal = normals};
    const swMoment* moment = swWorld_GetMoment(sea.world);
    swMoment_QuerySurface(moment, &query, COUNT, at, &samples, NULL);
    for (int side = 0; side < 4; ++side)
    {
        for (int i = 0; i < COUNT; ++i)
        {
            beside[side][i] = (swPosXZ){at[i].x + (side == 0   ? h
                                                   : side == 1 ? -h
                                                               : 0.0),
                                        at[i].z + (side == 2   ? h
                                                   : side == 3 ? -h
                                                               : 0.0)};
        }
        const swSurfaceSamples others = {.height = heights[side]};
        swMoment_QuerySurface(moment, &query, COUNT, beside[side], &others, NULL);
    }
    double worst = 0.0, most = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        double slopeX = (double)(heights[0][i] - heights[1][i]) / (2.0 * h);
        double slopeZ = (double)(heights[2][i] - heights[3][i]) / (2.0 * h);
        worst = fmax(worst, fabs(slopeX + (double)(normals[i].x / normals[i].y)));
        worst = fmax(worst, fabs(slopeZ + (double)(normals[i].z / normals[i].y)));
        most = fmax(most, fabs(slopeX));
    }
    print_message("slopes of up to %.3f differ from those of normals by %.2g\n", most, worst);
    assert_true(most > 0.05 && worst < 0.003);
    CloseSea(&sea);
}

static void SidewaysMotionTurnsWithTheLine(void** state)
{
    (void)state;
    // Onto the shore: particles move across the line, never along it.
    swSplinePoint points[RING_POINTS];
    MakeRing(points, 200.0);
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = RING_POINTS;
    def.isClosed = true;
    def.width = 200.0f;
    Sea sea;
    OpenSea(&sea, 1.0f, true);
    RunAlong(&sea, &def, 0.0f);
    double most = 0.0, along = 0.0;
    for (int i = 0; i < 200; ++i)
    {
        double angle = 1.2 + 4.0 * i / 200.0;
        swPosXZ p = {205.0 * cos(angle), 205.0 * sin(angle)};
        swVec3 moved;
        const swSurfaceSamples samples = {.displacement = &moved};
        const swQueryDef query = swDefaultQueryDef();
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &query, 1, &p, &samples, NULL);
        most = fmax(most, fabs((double)moved.x * cos(angle) + (double)moved.z * sin(angle)));
        along = fmax(along, fabs(-(double)moved.x * sin(angle) + (double)moved.z * cos(angle)));
    }
    print_message("particles move by %.3f m across and %.3f m along\n", most, along);
    assert_true(most > 0.05 && along < 0.01 * (double)AMPLITUDE);
    CloseSea(&sea);
}

static void BesideTheRibbonTheSeaIsUntouched(void** state)
{
    (void)state;
    swSplinePoint points[SHORE_POINTS];
    swSplineDef def = MakeShore(points, 60.0f);
    for (int isLocal = 0; isLocal < 2; ++isLocal)
    {
        Sea with, without;
        OpenSea(&with, 1.0f, isLocal == 1);
        OpenSea(&without, 1.0f, false);
        without.spline = NULL;
        RunAlong(&with, &def, 0.0f);
        swWorld_Step(without.world, 0.0);
        for (int i = 0; i < 200; ++i)
        {
            double x = 2900.0 + 5.0 * i, z = i % 2 == 0 ? -860.0 : -700.0;
            float there = HeightAt(&with, x, z), plain = HeightAt(&without, x, z);
            assert_true(isLocal == 1 ? there == 0.0f : memcmp(&there, &plain, sizeof there) == 0);
        }
        CloseSea(&with);
        CloseSea(&without);
    }
}

static void BlendTakesAwayWhatIsBelowAndAddLeavesIt(void** state)
{
    (void)state;
    const swSplinePoint points[2] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(0.0, 0.0, 500.0)};
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 2;
    def.width = 100.0f;
    for (int blend = 0; blend < 2; ++blend)
    {
        Sea sea;
        OpenSea(&sea, 0.0f, false);
        RunAlong(&sea, &def, 90.0f);
        sea.def.blend = blend == 0 ? SW_BLEND_ALPHA : SW_BLEND_ADD;
        sea.def.feather = 50.0f;
        assert_int_equal(swInput_Set(sea.world, sea.input, &sea.def), SW_SUCCESS);
        swWorld_Step(sea.world, 0.0);
        for (int i = 1; i < 100; ++i)
        {
            double x = -50.0 + i, z = 100.0 + 3.0 * i, inside = 50.0 - fabs(x), t = inside / 50.0;
            float share = (float)(t * t * (3.0 - 2.0 * t)), plain = GetWaveHeight(x), along = GetWaveHeight(z);
            float expected = share * along + (blend == 0 ? 1.0f - share : 1.0f) * plain;
            assert_float_equal(HeightAt(&sea, x, z), expected, 1e-3f);
        }
        CloseSea(&sea);
    }
}

static void BranchesOfAHairpinFadeIntoEachOther(void** state)
{
    (void)state;
    const swSplinePoint points[6] = {swDefaultSplinePoint(0.0, 0.0, -20.0),   swDefaultSplinePoint(100.0, 0.0, -20.0),
                                     swDefaultSplinePoint(200.0, 0.0, -20.0), swDefaultSplinePoint(200.0, 0.0, 20.0),
                                     swDefaultSplinePoint(100.0, 0.0, 20.0),  swDefaultSplinePoint(0.0, 0.0, 20.0)};
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 6;
    def.width = 80.0f;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    RunAlong(&sea, &def, 40.0f);
    double worst = 0.0;
    for (int line = 0; line < 10; ++line)
    {
        double x = 20.0 + 15.0 * line;
        float before = HeightAt(&sea, x, -19.0);
        for (int i = 1; i <= 4000; ++i)
        {
            float height = HeightAt(&sea, x, -19.0 + 38.0 * i / 4000.0); // 1 cm a step
            worst = fmax(worst, fabs((double)(height - before)));
            before = height;
        }
        assert_float_equal(HeightAt(&sea, x, 0.0), 0.0f, 1e-3f);
    }
    print_message("between a hairpin's branches: %.2g m within 1 cm\n", worst);
    assert_true(worst < 0.006);
    CloseSea(&sea);
}

// ---- rivers ----

static void ARiverHasLevelFlowAndBed(void** state)
{
    (void)state;
    swSplinePoint points[5];
    for (int i = 0; i < 5; ++i)
    {
        points[i] = swDefaultSplinePoint(100.0 * i, 12.0 - 2.0 * i, 0.0);
        points[i].depth = 3.0f;
        points[i].flow = 1.5f;
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 5;
    def.width = 30.0f;
    swHost host = MakeHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = 5.0;
    swWorld* world = NULL;
    swSpline* spline = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    assert_int_equal(swCreateSpline(&host, &def, &spline), SW_SUCCESS);
    const swInputField fields[3] = {SW_INPUT_LEVEL, SW_INPUT_FLOW, SW_INPUT_FLOOR};
    for (int i = 0; i < 3; ++i)
    {
        swInputDef input = swDefaultInputDef();
        input.field = fields[i];
        input.shape = SW_SHAPE_SPLINE;
        input.spline = spline;
        // Moved far, turned to run southwards, and lifted.
        input.position = (swPos){1e6, 7.0, -2e5};
        input.rotation.yaw = (float)(0.5 * SW_PI);
        swInputId id;
        assert_int_equal(swCreateInput(world, &input, &id), SW_SUCCESS);
    }
    swDestroySpline(spline); // the inputs hold it
    swWorld_Step(world, 0.0);
    for (int i = 0; i < 200; ++i)
    {
        double along = 1.0 + 2.0 * i, aside = 14.0 * sin(0.6 * i);
        const swPosXZ p = {1e6 - aside, -2e5 + along};
        float level, floor, depth;
        swVec2 flow;
        const swFieldSamples samples = {.level = &level, .floor = &floor, .depth = &depth, .flow = &flow};
        assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &p, &samples), 0);
        assert_float_equal(level, (float)(12.0 - 0.02 * along + 7.0 - 5.0), 1e-3f);
        assert_float_equal(floor, (float)(12.0 - 0.02 * along + 7.0 - 3.0), 1e-3f);
        assert_float_equal(depth, 3.0f, 1e-3f);
        assert_float_equal(flow.x, 0.0f, 1e-4f);
        assert_float_equal(flow.y, 1.5f, 1e-4f);
        // The water's surface lies there and slopes.
        swVec3 normal;
        float height;
        const swSurfaceSamples surface = {.height = &height, .normal = &normal};
        const swQueryDef query = swDefaultQueryDef();
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, 1, &p, &surface, NULL);
        assert_float_equal(height, (float)(12.0 - 0.02 * along + 7.0), 1e-3f);
        assert_float_equal(normal.z / normal.y, 0.02f, 1e-4f);
    }
    swDestroyWorld(world);
}

static void WhatASplineCannotSayIsRefused(void** state)
{
    (void)state;
    swSplinePoint points[SHORE_POINTS];
    swSplineDef def = MakeShore(points, 60.0f);
    Sea sea;
    OpenSea(&sea, 1.0f, true);
    RunAlong(&sea, &def, 0.0f);
    swInputDef bad = sea.def;
    swInputId id;
    bad.spline = NULL;
    assert_int_equal(swCreateInput(sea.world, &bad, &id), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "has no spline"));
    bad = sea.def;
    bad.blend = SW_BLEND_MAX;
    assert_int_equal(swCreateInput(sea.world, &bad, &id), SW_ERROR_UNSUPPORTED);
    bad = sea.def;
    bad.field = SW_INPUT_FOAM;
    assert_int_equal(swCreateInput(sea.world, &bad, &id), SW_ERROR_UNSUPPORTED);
    bad.field = SW_INPUT_FLOW;
    bad.alongSpline = false;
    bad.gain = 1000.0f;
    s_messages[0] = '\0';
    assert_int_equal(swCreateInput(sea.world, &bad, &id), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "flow of up to 2000 m/s"));
    CloseSea(&sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WavesLieByTheMetresAlongAndAcross),
        cmocka_unit_test(ALineIsAsLongAsItsWavesSayAndABendChangesThemBeside),
        cmocka_unit_test(ARingHasNoSeamInItsWaves),
        cmocka_unit_test(NormalsAreThoseOfTheHeights),
        cmocka_unit_test(SidewaysMotionTurnsWithTheLine),
        cmocka_unit_test(BesideTheRibbonTheSeaIsUntouched),
        cmocka_unit_test(BlendTakesAwayWhatIsBelowAndAddLeavesIt),
        cmocka_unit_test(BranchesOfAHairpinFadeIntoEachOther),
        cmocka_unit_test(ARiverHasLevelFlowAndBed),
        cmocka_unit_test(WhatASplineCannotSayIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
