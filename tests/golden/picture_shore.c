// SPDX-License-Identifier: MIT
// Land and sea floor in the picture: the bottom is seen through water that is not deep, fades with depth as the water's
// def says, and water ends softly; land that stands out of the water is not touched by it, at any distance.

#include <math.h>
#include <stdlib.h>

#include "golden/canvas.h"
#include "support/cmocka_setup.h"

#define SIDE 128
#define PIXELS (SIDE * SIDE)

static Canvas* s_canvas;
static swWaveSystemDef s_calm;

// A floor at one height.
static void Flat(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)points;
    for (int i = 0; i < count; ++i)
    {
        heights[i] = *(const float*)context;
    }
}

// A beach that rises eastwards by a tenth, and at x = 0 comes out of the water.
static void Beach(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    for (int i = 0; i < count; ++i)
    {
        heights[i] = (float)(0.1 * points[i].x);
    }
}

// Hills with valleys and a part without any floor.
static void Hills(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x, z = points[i].z;
        heights[i] = (float)(200.0 + 60.0 * sin(0.01 * x) * cos(0.013 * z) + 5.0 * sin(0.11 * x + 0.07 * z));
        heights[i] = x > 900.0 && x < 1100.0 ? NAN : heights[i];
    }
}

static Shot MakeShot(swStageFloorFcn* floor, void* context)
{
    return (Shot){.name = "shore",
                  .windSpeed = 3.0f,
                  .height = 20.0f,
                  .pitchDeg = -90.0f,
                  .fovDeg = 20.0f,
                  .sunElevationDeg = 50.0f,
                  .sunAzimuthDeg = 90.0f,
                  .time = 10.0,
                  .waves = &s_calm,
                  .hasCoreLayers = true,
                  .floor = floor,
                  .floorContext = context};
}

static void GetMean(const Shot* shot, double mean[3])
{
    static float hdr[4 * PIXELS];
    assert_true(DrawShot(s_canvas, shot, NULL, hdr));
    for (int c = 0; c < 3; ++c)
    {
        mean[c] = 0.0;
        for (int i = 0; i < PIXELS; ++i)
        {
            mean[c] += (double)hdr[4 * i + c] / PIXELS;
        }
    }
}

static void SandIsSeenAndFadesWithDepth(void** state)
{
    (void)state;
    const float depths[] = {0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f, 32.0f};
    const swWaterDef water = swDefaultWaterDef();
    const float lost[3] = {water.absorption.x, water.absorption.y, water.absorption.z};
    double red[7], deep[3], last[3] = {1e9, 1e9, 1e9};
    Shot none = MakeShot(NULL, NULL);
    GetMean(&none, deep);
    for (int i = 0; i < 7; ++i)
    {
        float floor = -depths[i];
        Shot shot = MakeShot(Flat, &floor);
        double mean[3];
        GetMean(&shot, mean);
        print_message("%4.1f m: %.3f %.3f %.3f of deep water's light\n", (double)depths[i], mean[0] / deep[0],
                      mean[1] / deep[1], mean[2] / deep[2]);
        for (int c = 0; c < 3; ++c)
        {
            double left = exp(-2.3 * (double)(lost[c] * depths[i])); // both ways, a little aslant
            assert_true(left < 0.02 || mean[c] > 1.02 * deep[c]);
            assert_true(mean[c] < last[c] && mean[c] > 0.97 * deep[c]);
            last[c] = mean[c];
        }
        red[i] = mean[0] - deep[0];
        assert_true(depths[i] < 16.0f || fabs(mean[0] / deep[0] - 1.0) < 0.05);
    }
    // [Lee 1998]: down along the sun's path, 1.14 of the depth, and up straight, 1.08 of it for light from all around.
    double rate = log(red[1] / red[2]) / (double)(depths[2] - depths[1]);
    double lostRed = (double)water.absorption.x + 0.0183 * (double)water.scattering.x + 0.0006;
    print_message("red fades by %.4f per m of depth, %.4f by the law\n", rate, 2.22 * lostRed);
    assert_true(fabs(rate / (2.22 * lostRed) - 1.0) < 0.03);
}

static void ABottomWithoutEndIsDeepWater(void** state)
{
    (void)state;
    float floor = -500.0f;
    Shot none = MakeShot(NULL, NULL), shot = MakeShot(Flat, &floor);
    static float with[4 * PIXELS], without[4 * PIXELS];
    assert_true(DrawShot(s_canvas, &none, NULL, without));
    assert_true(DrawShot(s_canvas, &shot, NULL, with));
    for (int i = 0; i < 4 * PIXELS; ++i)
    {
        assert_true(fabsf(with[i] - without[i]) <= 0.002f * without[i]);
    }
}

// A bottom 6 m deep with a wall around the camera, 25 m away, that stands a little out of the water.
static void Wall(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    for (int i = 0; i < count; ++i)
    {
        double away = sqrt(points[i].x * points[i].x + points[i].z * points[i].z);
        heights[i] = away > 23.0 && away < 26.0 ? 1.5f : -6.0f;
    }
}

// Lines of sight that go into the water right behind the wall end where the wall hides the bottom on the screen.
static void AWallInFrontIsNotTheBottom(void** state)
{
    (void)state;
    static float hdr[2][4 * PIXELS];
    float floor = -6.0f;
    Shot shots[2] = {MakeShot(Flat, &floor), MakeShot(Wall, NULL)};
    double means[2][3] = {{0.0}};
    for (int i = 0; i < 2; ++i)
    {
        shots[i].pitchDeg = -34.0f;
        assert_true(DrawShot(s_canvas, &shots[i], NULL, hdr[i]));
        for (int pixel = 0; pixel < PIXELS; ++pixel)
        {
            int column = pixel % SIDE, row = pixel / SIDE;
            bool isBehind = row >= 56 && row < 70 && column >= 40 && column < 88;
            for (int c = 0; c < 3 && isBehind; ++c)
            {
                means[i][c] += (double)hdr[i][4 * pixel + c];
            }
        }
    }
    print_message("behind a wall: %.3f %.3f %.3f of what is there without it\n", means[1][0] / means[0][0],
                  means[1][1] / means[0][1], means[1][2] / means[0][2]);
    for (int c = 0; c < 3; ++c)
    {
        assert_true(fabs(means[1][c] / means[0][c] - 1.0) < 0.1);
    }
}

static void WaterEndsSoftly(void** state)
{
    (void)state;
    static float hdr[4 * PIXELS];
    Shot shot = MakeShot(Beach, NULL);
    shot.height = 12.0f;
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    const float* row = hdr + 4 * (SIDE / 2) * SIDE;
    float first = row[0], last = row[4 * (SIDE - 1)], steepest = 0.0f;
    for (int i = 1; i < SIDE; ++i)
    {
        steepest = fmaxf(steepest, fabsf(row[4 * i] - row[4 * (i - 1)]));
    }
    print_message("red from %.4f to %.4f, at most %.4f from pixel to pixel\n", (double)first, (double)last,
                  (double)steepest);
    assert_true(last > 1.05f * first);
    assert_true(steepest < 0.15f * (last - first)); // a pixel is 3 cm
}

static void LandAboveWaterIsUntouched(void** state)
{
    (void)state;
    static float clear[4 * PIXELS], ink[4 * PIXELS];
    Shot shot = MakeShot(Hills, NULL);
    shot.height = 420.0f;
    shot.pitchDeg = -25.0f;
    shot.fovDeg = 60.0f;
    assert_true(DrawShot(s_canvas, &shot, NULL, clear));
    shot.hasBlackFoam = true;
    shot.windSpeed = 30.0f;
    assert_true(DrawShot(s_canvas, &shot, NULL, ink));
    int landCount = 0;
    for (int i = SIDE / 2 * SIDE; i < PIXELS; ++i) // below the middle there is land alone: no crack shows the sea
    {
        landCount += clear[4 * i] == ink[4 * i] && clear[4 * i + 1] == ink[4 * i + 1];
        assert_true(clear[4 * i + 1] > 0.0f);
    }
    assert_int_equal(landCount, SIDE / 2 * SIDE);
}

static void BadTerrainIsRefused(void** state)
{
    (void)state;
    swStage* stage = GetCanvasStage(s_canvas);
    swStageTerrainDef def = swDefaultStageTerrainDef();
    swStageTerrain* terrain;
    assert_int_equal(swStage_CreateTerrain(stage, &def, &terrain), SW_ERROR_INVALID); // no floor
    def.floor = Beach;
    def.finestSpacing = NAN;
    assert_int_equal(swStage_CreateTerrain(stage, &def, &terrain), SW_ERROR_INVALID);
    def.finestSpacing = 0.0f;
    assert_int_equal(swStage_CreateTerrain(stage, &def, &terrain), SW_ERROR_INVALID);
    assert_null(terrain);
    swStage_DestroyTerrain(stage, NULL);
}

static int OpenCanvas(void** state)
{
    (void)state;
    s_calm = swDefaultWaveSystemDef();
    s_calm.spectrum = swMakeSwellSpectrum(0.002f, 6.0f, 0.0f, 0.3f);
    s_canvas = CreateCanvas(SIDE, SIDE, true);
    return s_canvas != NULL ? 0 : -1;
}

static int CloseCanvas(void** state)
{
    (void)state;
    int messages = GetCanvasValidationCount(s_canvas);
    DestroyCanvas(s_canvas);
    return messages;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SandIsSeenAndFadesWithDepth), cmocka_unit_test(ABottomWithoutEndIsDeepWater),
        cmocka_unit_test(AWallInFrontIsNotTheBottom),  cmocka_unit_test(WaterEndsSoftly),
        cmocka_unit_test(LandAboveWaterIsUntouched),   cmocka_unit_test(BadTerrainIsRefused),
    };
    return cmocka_run_group_tests(tests, OpenCanvas, CloseCanvas);
}
