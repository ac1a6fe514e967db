// SPDX-License-Identifier: MIT
// The foam that a picture shows is the foam that the sea has: the mean of its layer over the pixels, seen from straight
// above, and the share of pixels that are white with it.

#include <math.h>
#include <stdlib.h>

#include "core/sim/whitecaps.h"
#include "golden/canvas.h"
#include "support/cmocka_setup.h"

#define SIDE 160
#define PIXELS (SIDE * SIDE)
#define PLACES 2

static Canvas* s_canvas;

static Shot MakeShot(float wind, int place)
{
    return (Shot){.name = "foam",
                  .windSpeed = wind,
                  .height = 120.0f,
                  .pitchDeg = -90.0f,
                  .fovDeg = 60.0f,
                  .sunElevationDeg = 40.0f,
                  .haze = 0.0f,
                  .time = 40.0,
                  .x = 3000.0 * place,
                  .z = -77.5,
                  .steps = 40,
                  .hasCoreLayers = true};
}

static double GetMeanFoam(Shot shot)
{
    static float hdr[4 * PIXELS];
    shot.debug = SW_DEBUG_FOAM;
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    double sum = 0.0;
    for (int i = 0; i < PIXELS; ++i)
    {
        sum += (double)hdr[4 * i] / PIXELS;
    }
    return sum;
}

// The share of pixels that foam makes brighter by a part of what it makes the brightest.
static double GetWhiteShare(Shot shot)
{
    static float white[4 * PIXELS], black[4 * PIXELS];
    assert_true(DrawShot(s_canvas, &shot, NULL, white));
    shot.hasBlackFoam = true;
    assert_true(DrawShot(s_canvas, &shot, NULL, black));
    float brightest = 0.0f;
    for (int i = 0; i < PIXELS; ++i)
    {
        brightest = fmaxf(brightest, white[4 * i + 1] - black[4 * i + 1]);
    }
    double share = 0.0;
    for (int i = 0; i < PIXELS; ++i)
    {
        share += white[4 * i + 1] - black[4 * i + 1] > 0.1f * brightest ? 1.0 / PIXELS : 0.0;
    }
    return share;
}

static void PixelsShowTheFoamOfTheWind(void** state)
{
    (void)state;
    static const float winds[] = {10.0f, 20.0f};
    for (int i = 0; i < 2; ++i)
    {
        double mean = 0.0, white = 0.0, asked = (double)swGetWhitecapCover(winds[i]);
        for (int place = 0; place < PLACES; ++place)
        {
            mean += GetMeanFoam(MakeShot(winds[i], place)) / PLACES;
            white += GetWhiteShare(MakeShot(winds[i], place)) / PLACES;
        }
        print_message("%.0f m/s from 120 m: %.2f %% asked, %.2f %% in the layer's pixels, %.2f %% of pixels white\n",
                      (double)winds[i], 100.0 * asked, 100.0 * mean, 100.0 * white);
        assert_true(mean > 0.6 * asked && mean < 1.6 * asked);
        assert_true(white > 0.35 * asked && white < 2.0 * asked);
    }
}

static void SwellShowsNone(void** state)
{
    (void)state;
    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.spectrum = swMakeSwellSpectrum(3.0f, 12.0f, 0.0f, 0.3f);
    Shot shot = MakeShot(0.0f, 0);
    shot.waves = &swell;
    assert_true(GetMeanFoam(shot) < 1e-4);
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
        cmocka_unit_test(PixelsShowTheFoamOfTheWind),
        cmocka_unit_test(SwellShowsNone),
    };
    return cmocka_run_group_tests(tests, OpenCanvas, CloseCanvas);
}
