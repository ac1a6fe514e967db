// SPDX-License-Identifier: MIT
// Holes and bodies of water in the picture: what is cut shows what is behind it, and nothing else changes; a hole is as
// large far away as near; the levels of two lakes that lie close together do not mix, however coarse the mesh is there.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "golden/canvas.h"
#include "support/cmocka_setup.h"
#include "support/hull_meshes.h"

#define SIDE 160
#define PIXELS (SIDE * SIDE)

static Canvas* s_canvas;
static swWaveSystemDef s_calm;

// A floor 15 m below sea level.
static void Flat(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    (void)points;
    for (int i = 0; i < count; ++i)
    {
        heights[i] = -15.0f;
    }
}

// Straight down, so that a picture is a map of `across` metres.
static Shot MakeMap(double height, double across)
{
    return (Shot){.name = "holes",
                  .windSpeed = 3.0f,
                  .height = (float)height,
                  .pitchDeg = -90.0f,
                  .fovDeg = (float)(2.0 * atan(0.5 * across / height) * 180.0 / SW_PI),
                  .sunElevationDeg = 50.0f,
                  .sunAzimuthDeg = 90.0f,
                  .time = 10.0,
                  .waves = &s_calm,
                  .hasCoreLayers = true,
                  .floor = Flat};
}

static float* Draw(const Shot* shot)
{
    float* hdr = malloc(PIXELS * 4 * sizeof(float));
    assert_true(DrawShot(s_canvas, shot, NULL, hdr));
    assert_int_equal(GetCanvasValidationCount(s_canvas), 0);
    return hdr;
}

static swInputDef MakeClip(swInputShape shape)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_CLIP;
    def.shape = shape;
    def.value[0] = 1.0f;
    return def;
}

static float Difference(const float* a, const float* b, int pixel)
{
    float sum = 0.0f;
    for (int i = 0; i < 3; ++i)
    {
        sum += fabsf(a[4 * pixel + i] - b[4 * pixel + i]);
    }
    return sum / (a[4 * pixel] + a[4 * pixel + 1] + a[4 * pixel + 2]);
}

// The share of the way from wet to dry that each pixel of a picture is, and the sum of all.
static double SumOfHoles(const float* picture, const float* wet, const float* dry, int* mixed)
{
    double sum = 0.0;
    *mixed = 0;
    for (int i = 0; i < PIXELS; ++i)
    {
        float way = dry[4 * i] - wet[4 * i], share = (picture[4 * i] - wet[4 * i]) / way;
        assert_true(fabsf(way) > 0.0f);
        sum += (double)share;
        *mixed += share > 0.02f && share < 0.98f ? 1 : 0;
        assert_true(share > -0.02f && share < 1.02f);
    }
    return sum;
}

// Pictures of a hole of 20 m in a map of 80 m.
static void CheckHole(double height, const swInputDef* hole, double area)
{
    Shot shot = MakeMap(height, 80.0);
    float* wet = Draw(&shot);
    shot.inputs = hole;
    shot.inputCount = 1;
    float* cut = Draw(&shot);
    const swInputDef everywhere = MakeClip(SW_SHAPE_EVERYWHERE);
    shot.inputs = &everywhere;
    float* dry = Draw(&shot);
    int mixed;
    double pixels = SumOfHoles(cut, wet, dry, &mixed), expected = area * PIXELS / 6400.0;
    printf("from %.0f m: a hole of %.1f pixels, should be %.1f; %d at its edge\n", height, pixels, expected, mixed);
    assert_true(fabs(pixels - expected) < 0.01 * expected + 0.15 * mixed);
    assert_true(mixed > 20 && mixed < 500); // a soft edge of one pixel
    free(wet);
    free(cut);
    free(dry);
}

static void AHoleShowsWhatIsBehindItAndIsAsLargeNearAndFar(void** state)
{
    (void)state;
    swInputDef hole = MakeClip(SW_SHAPE_CYLINDER);
    hole.size = (swVec3){20.0f, 60.0f, 20.0f};
    CheckHole(60.0, &hole, 314.159);
    CheckHole(600.0, &hole, 314.159);
    CheckHole(6000.0, &hole, 314.159);
}

static void AConcaveHullIsCutAsItStands(void** state)
{
    (void)state;
    static TestMesh mesh;
    AddDock(&mesh);
    swHullDef def = MakeHullDef(&mesh, "dock");
    swHost host = swDefaultHost();
    swHull* hull = NULL;
    assert_int_equal(swCreateHull(&host, &def, &hull), SW_SUCCESS);
    swInputDef dock = MakeClip(SW_SHAPE_HULL);
    dock.hull = hull;
    dock.rotation.yaw = 0.5f;
    CheckHole(60.0, &dock, 30.0 * 4.0 * 2.0 + 12.0 * 4.0);
    CheckHole(2000.0, &dock, 30.0 * 4.0 * 2.0 + 12.0 * 4.0);
    swDestroyHull(hull);
}

static void WithoutLandAHoleIsStillCut(void** state)
{
    (void)state;
    swInputDef hole = MakeClip(SW_SHAPE_CIRCLE);
    hole.size.x = 40.0f;
    Shot shot = MakeMap(60.0, 80.0);
    shot.floor = NULL;
    float* wet = Draw(&shot);
    shot.inputs = &hole;
    shot.inputCount = 1;
    float* cut = Draw(&shot);
    int changed = 0;
    for (int i = 0; i < PIXELS; ++i)
    {
        changed += Difference(wet, cut, i) > 0.0f ? 1 : 0;
    }
    double expected = 0.25 * SW_PI * 1600.0 * PIXELS / 6400.0;
    printf("without land: %d pixels of the sky's lower half, should be %.0f\n", changed, expected);
    assert_true(fabs(changed / expected - 1.0) < 0.02);
    free(wet);
    free(cut);
}

// Two lakes of 30 x 30 m, 10 m apart, one red and one green, above a blue sea.
static void CheckLakes(double height, bool isDry)
{
    static const swVec2 square[4] = {{-15.0f, -15.0f}, {15.0f, -15.0f}, {15.0f, 15.0f}, {-15.0f, 15.0f}};
    swWaterBodyDef lakes[2] = {swDefaultWaterBodyDef(), swDefaultWaterBodyDef()};
    swWaterDef waters[2] = {swDefaultWaterDef(), swDefaultWaterDef()};
    for (int i = 0; i < 2; ++i)
    {
        lakes[i].points = square;
        lakes[i].pointCount = 4;
        lakes[i].position = (swPos){i == 0 ? -20.0 : 20.0, i == 0 ? 6.0 : 3.0, 0.0};
        lakes[i].look = i + 1;
        waters[i].scattering = (swVec3){0.0f, 0.0f, 0.0f};
        waters[i].absorption = (swVec3){1.0f, 1.0f, 1.0f};
        *(i == 0 ? &waters[i].scattering.x : &waters[i].scattering.y) = 20.0f;
        *(i == 0 ? &waters[i].absorption.x : &waters[i].absorption.y) = 0.1f;
    }
    const swInputDef everywhere = MakeClip(SW_SHAPE_EVERYWHERE);
    Shot shot = MakeMap(height, 80.0);
    shot.bodies = lakes;
    shot.bodyCount = 2;
    shot.bodyWaters = waters;
    shot.bodyWaterCount = 2;
    shot.inputs = &everywhere;
    shot.inputCount = isDry ? 1 : 0;
    shot.floor = NULL;
    float* picture = Draw(&shot);
    int counts[3] = {0}, gap = 0;
    for (int i = 0; i < PIXELS; ++i)
    {
        const float* color = &picture[4 * i];
        int which = color[0] > 1.3f * color[1] ? 0 : (color[1] > 1.2f * color[2] ? 1 : 2);
        counts[which] += 1;
        double x = 80.0 * ((i % SIDE + 0.5) / SIDE - 0.5);
        gap += fabs(x) < 4.0 && which != 2 ? 1 : 0;
    }
    double nearer[2] = {height / (height - 6.0), height / (height - 3.0)};
    double expected[2];
    for (int i = 0; i < 2; ++i)
    {
        expected[i] = 900.0 * nearer[i] * nearer[i] * PIXELS / 6400.0;
    }
    printf("from %.0f m: lakes of %d and %d pixels, should be %.0f and %.0f; %d of the gap's\n", height, counts[0],
           counts[1], expected[0], expected[1], gap);
    assert_true(fabs(counts[0] / expected[0] - 1.0) < 0.03 && fabs(counts[1] / expected[1] - 1.0) < 0.03);
    assert_int_equal(gap, 0);
    free(picture);
}

static void LakesTenMetresApartDoNotMixAtAnyDistance(void** state)
{
    (void)state;
    CheckLakes(150.0, false);
    CheckLakes(5000.0, false);
    CheckLakes(5000.0, true);
}

static void ABodyWhoseLookTheShotLacksIsRefused(void** state)
{
    (void)state;
    static const swVec2 square[4] = {{-15.0f, -15.0f}, {15.0f, -15.0f}, {15.0f, 15.0f}, {-15.0f, 15.0f}};
    swWaterBodyDef lake = swDefaultWaterBodyDef();
    lake.points = square;
    lake.pointCount = 4;
    lake.look = 1;
    Shot shot = MakeMap(100.0, 80.0);
    shot.bodies = &lake;
    shot.bodyCount = 1;
    assert_false(DrawShot(s_canvas, &shot, NULL, malloc(PIXELS * 4 * sizeof(float))));
}

int main(void)
{
    s_canvas = CreateCanvas(SIDE, SIDE, true);
    if (s_canvas == NULL)
    {
        printf("skipped: there is no Vulkan device\n");
        return 77;
    }
    s_calm = swDefaultWaveSystemDef();
    s_calm.spectrum.windSpeed = 1.0f;
    s_calm.weight = 0.0f;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AHoleShowsWhatIsBehindItAndIsAsLargeNearAndFar),
        cmocka_unit_test(AConcaveHullIsCutAsItStands),
        cmocka_unit_test(WithoutLandAHoleIsStillCut),
        cmocka_unit_test(LakesTenMetresApartDoNotMixAtAnyDistance),
        cmocka_unit_test(ABodyWhoseLookTheShotLacksIsRefused),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    DestroyCanvas(s_canvas);
    return failed;
}
