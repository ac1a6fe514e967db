// SPDX-License-Identifier: MIT
// Waves that are too short for the slices are seen all the same: the picture has their slopes, and what its pixels do
// not resolve of them it has as roughness. Drawn from straight above, where a pixel shows one place.

#include <math.h>
#include <stdlib.h>

#include "golden/canvas.h"
#include "shared/roughness.h"
#include "support/cmocka_setup.h"

#define SIDE 96
#define PIXELS (SIDE * SIDE)
#define WIND 9.0f
#define TIME 12.0

static Canvas* s_canvas;

static Shot MakeShot(const swWaveSystemDef* waves, float height, swDebugMode debug)
{
    return (Shot){.name = "ripples",
                  .windSpeed = WIND,
                  .height = height,
                  .pitchDeg = -90.0f,
                  .fovDeg = 30.0f,
                  .sunElevationDeg = 40.0f,
                  .haze = 1.0f,
                  .time = TIME,
                  .x = 1000.25,
                  .z = -77.5,
                  .debug = debug,
                  .waves = waves};
}

// Where the ray through each pixel meets still water.
static void FindPlaces(const Shot* shot, swPosXZ* places)
{
    swPos eye = {shot->x, (double)shot->height, shot->z};
    swCamera camera =
        swMakeCamera(eye, 0.0f, (float)(-0.5 * SW_PI), 0.0f, shot->fovDeg * (float)(SW_PI / 180.0), SIDE, SIDE);
    const float *view = camera.view.m, *projection = camera.projection.m;
    for (int i = 0; i < PIXELS; ++i)
    {
        double x = (2.0 * (i % SIDE + 0.5) / SIDE - 1.0) / (double)projection[0];
        double y = (2.0 * (i / SIDE + 0.5) / SIDE - 1.0) / (double)projection[5];
        double ray[3];
        for (int k = 0; k < 3; ++k)
        {
            ray[k] = x * (double)view[4 * k] + y * (double)view[4 * k + 1] - (double)view[4 * k + 2];
        }
        double range = -(double)shot->height / ray[1];
        places[i] = (swPosXZ){shot->x + range * ray[0], shot->z + range * ray[2]};
    }
}

static void FindSlopes(const swWaveSystemDef* waves, const swPosXZ* places, swVec2* slopes)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    swWaveSystemId id;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(world, waves, &id), SW_SUCCESS);
    swWorld_SetTime(world, TIME);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swQueryDef query = swDefaultQueryDef();
    static float heights[PIXELS];
    swSurfaceSamples samples = {.height = heights};
    swMoment_QueryParticles(swWorld_GetMoment(world), &query, PIXELS, places, &samples, slopes, NULL);
    swDestroyWorld(world);
}

// The slope that a picture of normals shows.
static swVec2 ReadSlope(const float* pixel)
{
    float x = 2.0f * pixel[0] - 1.0f, z = 2.0f * pixel[1] - 1.0f, y = 2.0f * pixel[2] - 1.0f;
    return (swVec2){-x / y, -z / y};
}

static void RipplesAreDrawnWhereTheyAre(void** state)
{
    (void)state;
    static float hdr[4 * PIXELS];
    static swPosXZ places[PIXELS];
    static swVec2 slopes[PIXELS];
    for (int method = 0; method < SW_WAVE_METHOD_COUNT; ++method)
    {
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.spectrum.windSpeed = WIND;
        waves.method = (swWaveMethod)method;
        waves.maxWavelength = 0.45f; // the finest slice carries half a metre
        waves.reverseWeight = method == SW_WAVES_GERSTNER ? 0.3f : 0.0f;
        Shot shot = MakeShot(&waves, 1.0f, SW_DEBUG_NORMALS); // six millimetres a pixel
        FindPlaces(&shot, places);
        FindSlopes(&waves, places, slopes);
        assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
        double wanted = 0.0, error = 0.0, product = 0.0, drawn = 0.0;
        for (int i = 0; i < PIXELS; ++i)
        {
            swVec2 got = ReadSlope(hdr + (size_t)4 * (size_t)i);
            double x = (double)slopes[i].x, z = (double)slopes[i].y;
            double dx = (double)got.x - x, dz = (double)got.y - z;
            wanted += x * x + z * z;
            drawn += (double)(got.x * got.x + got.y * got.y);
            product += x * (double)got.x + z * (double)got.y;
            error += dx * dx + dz * dz;
        }
        print_message("%s: mean square slope %.5f asked, %.5f drawn, correlation %.4f, error %.1f %%\n",
                      method == SW_WAVES_FFT ? "tiles" : "free waves", wanted / PIXELS, drawn / PIXELS,
                      product / sqrt(wanted * drawn), 100.0 * sqrt(error / wanted));
        assert_true(wanted / PIXELS > 0.005);
        assert_true(product > 0.97 * sqrt(wanted * drawn));
        assert_true(drawn > 0.8 * wanted && drawn < 1.05 * wanted);
    }
}

// Mean over a picture of what is shown: slopes squared, and the variance of those that are not.
static double MeasureDrawn(const swWaveSystemDef* waves, float height)
{
    static float hdr[4 * PIXELS];
    double sum = 0.0;
    Shot shot = MakeShot(waves, height, SW_DEBUG_NORMALS);
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    for (int i = 0; i < PIXELS; ++i)
    {
        swVec2 slope = ReadSlope(hdr + (size_t)4 * (size_t)i);
        sum += (double)(slope.x * slope.x + slope.y * slope.y);
    }
    shot.debug = SW_DEBUG_ROUGHNESS;
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    for (int i = 0; i < PIXELS; ++i)
    {
        double x = (double)hdr[4 * i] / 4.0, z = (double)hdr[4 * i + 1] / 4.0;
        sum += x * x + z * z;
    }
    return sum / PIXELS;
}

// From wherever it is seen, a sea of few waves has the slopes that the glitter has: in its waves, or in its roughness.
// Waves longer than the picture is wide have no mean in it.
static void NoSlopeIsLostOnTheWay(void** state)
{
    (void)state;
    static const float heights[] = {2.0f, 8.0f, 40.0f, 300.0f};
    for (int i = 0; i < 4; ++i)
    {
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.spectrum.windSpeed = WIND;
        waves.method = SW_WAVES_GERSTNER;
        waves.chop = 0.0f; // slopes by rest position
        waves.maxWavelength = 0.25f * heights[i];
        double drawn = MeasureDrawn(&waves, heights[i]);
        double wanted = (double)swSeaSlopeVariance(WIND);
        print_message("from %3.0f m: mean square slope %.4f drawn, %.4f of the sea\n", (double)heights[i], drawn,
                      wanted);
        assert_true(fabs(drawn / wanted - 1.0) < 0.15);
    }
}

static int OpenCanvas(void** state)
{
    (void)state;
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
        cmocka_unit_test(RipplesAreDrawnWhereTheyAre),
        cmocka_unit_test(NoSlopeIsLostOnTheWay),
    };
    return cmocka_run_group_tests(tests, OpenCanvas, CloseCanvas);
}
