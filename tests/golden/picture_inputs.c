// SPDX-License-Identifier: MIT
// What inputs say is seen in the picture: levels lift the water and lean it, colours and shade lie where they were put,
// near and far, and the rest of the picture stays as it is.

#include <math.h>
#include <stdlib.h>

#include "golden/canvas.h"
#include "support/cmocka_setup.h"

#define SIDE 128
#define PIXELS (SIDE * SIDE)
#define MIDDLE (4 * (SIDE / 2 * SIDE + SIDE / 2))

static Canvas* s_canvas;
static swWaveSystemDef s_calm;

static Shot MakeShot(const swInputDef* inputs, int inputCount)
{
    return (Shot){.name = "inputs",
                  .windSpeed = 3.0f,
                  .height = 60.0f,
                  .pitchDeg = -90.0f,
                  .fovDeg = 40.0f,
                  .sunElevationDeg = 35.0f,
                  .sunAzimuthDeg = 90.0f,
                  .time = 10.0,
                  .waves = &s_calm,
                  .hasCoreLayers = true,
                  .inputs = inputs,
                  .inputCount = inputCount};
}

static swInputDef MakeCircle(swInputField field, float diameter)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = SW_SHAPE_CIRCLE;
    def.size = (swVec3){diameter, 0.0f, diameter};
    return def;
}

static void Draw(const Shot* shot, float* hdr)
{
    assert_true(DrawShot(s_canvas, shot, NULL, hdr));
}

static swRaster* MakeSlope(float perMetre)
{
    static float values[9 * 9];
    for (int i = 0; i < 81; ++i)
    {
        values[i] = perMetre * 50.0f * (float)(i % 9 - 4);
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = 9;
    def.x = def.z = -200.0;
    def.spacingX = def.spacingZ = 50.0;
    def.values = values;
    swHost host = swDefaultHost();
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    return raster;
}

static void ARiverThatFallsLeans(void** state)
{
    (void)state;
    static float hdr[4 * PIXELS];
    const float slope = 0.2f;
    swRaster* raster = MakeSlope(slope);
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_LEVEL;
    def.shape = SW_SHAPE_RASTER;
    def.raster = raster;
    Shot shot = MakeShot(&def, 1);
    shot.debug = SW_DEBUG_NORMALS;
    Draw(&shot, hdr);
    float expected = 0.5f - 0.5f * slope / sqrtf(1.0f + slope * slope);
    print_message("normal's x %.4f, expected %.4f\n", (double)hdr[MIDDLE], (double)expected);
    assert_float_equal(hdr[MIDDLE], expected, 0.01f);
    swDestroyRaster(raster);
}

// Land at 3 m is seen in front of the sea at 0, and is under a lake at 5 m.
static void FlatLand(void* context, int count, const swPosXZ* points, float* heights)
{
    (void)context;
    (void)points;
    for (int i = 0; i < count; ++i)
    {
        heights[i] = 3.0f;
    }
}

static void ALakeStandsAtItsLevel(void** state)
{
    (void)state;
    static float land[4 * PIXELS], lake[4 * PIXELS];
    swInputDef def = MakeCircle(SW_INPUT_LEVEL, 20.0f);
    def.value[0] = 5.0f;
    Shot shot = MakeShot(NULL, 0);
    shot.floor = FlatLand;
    Draw(&shot, land);
    shot = MakeShot(&def, 1);
    shot.floor = FlatLand;
    Draw(&shot, lake);
    print_message("red of land %.4f, under 2 m of a lake %.4f\n", (double)land[MIDDLE], (double)lake[MIDDLE]);
    assert_true(lake[MIDDLE] < 0.7f * land[MIDDLE]);
    assert_true(lake[0] == land[0] && lake[1] == land[1]); // beside it
}

static void ColoursLieWhereTheyWerePut(void** state)
{
    (void)state;
    static float bare[4 * PIXELS], red[4 * PIXELS];
    swInputDef def = MakeCircle(SW_INPUT_ALBEDO, 16.0f);
    def.value[0] = 0.8f;
    def.value[3] = 1.0f;
    Shot shot = MakeShot(NULL, 0);
    Draw(&shot, bare);
    shot = MakeShot(&def, 1);
    Draw(&shot, red);
    int coloured = 0, others = 0;
    float metres = 2.0f * 60.0f * tanf(0.5f * 40.0f * (float)SW_PI / 180.0f) / SIDE; // of a pixel
    for (int i = 0; i < PIXELS; ++i)
    {
        float x = ((float)(i % SIDE) + 0.5f - SIDE / 2) * metres, z = ((float)(i / SIDE) + 0.5f - SIDE / 2) * metres;
        float r = sqrtf(x * x + z * z);
        coloured += r < 7.0f && red[4 * i] > 5.0f * bare[4 * i] && red[4 * i] > 4.0f * red[4 * i + 2] ? 1 : 0;
        others += r > 9.0f && red[4 * i] == bare[4 * i] && red[4 * i + 2] == bare[4 * i + 2] ? 1 : 0;
    }
    float inside = (float)SW_PI * 49.0f / (metres * metres),
          outside = PIXELS - (float)SW_PI * 81.0f / (metres * metres);
    print_message("%d of %.0f pixels coloured, %d of %.0f as they were\n", coloured, (double)inside, others,
                  (double)outside);
    assert_true((float)coloured > 0.97f * inside && (float)others > 0.99f * outside);
}

// A colour that covers half of the water is halfway between the water and itself.
static void HalfACoverIsHalfway(void** state)
{
    (void)state;
    static float bare[4 * PIXELS], half[4 * PIXELS], whole[4 * PIXELS];
    swInputDef def = MakeCircle(SW_INPUT_ALBEDO, 16.0f);
    def.value[0] = 0.8f;
    def.value[3] = 1.0f;
    Shot shot = MakeShot(NULL, 0);
    Draw(&shot, bare);
    shot = MakeShot(&def, 1);
    Draw(&shot, whole);
    def.value[3] = 0.5f;
    Draw(&shot, half);
    float wanted = 0.5f * (bare[MIDDLE] + whole[MIDDLE]);
    print_message("red of the water %g, of the colour %g, of half of it %g, wanted %g\n", (double)bare[MIDDLE],
                  (double)whole[MIDDLE], (double)half[MIDDLE], (double)wanted);
    assert_float_equal(half[MIDDLE], wanted, 0.01f * wanted);
}

// Several kilometres away a decal that is smaller than a pixel is long still has its share of the picture.
static void ColoursArePresentFarAway(void** state)
{
    (void)state;
    static float bare[4 * PIXELS], red[4 * PIXELS];
    swInputDef defs[12];
    for (int i = 0; i < 12; ++i)
    {
        defs[i] = MakeCircle(SW_INPUT_ALBEDO, 30.0f);
        defs[i].position = (swPos){60.0 * (i - 5.5), 0.0, -4000.0 - 37.0 * i};
        defs[i].value[0] = 1.0f;
        defs[i].value[3] = 1.0f;
    }
    Shot shot = MakeShot(NULL, 0);
    shot.height = 250.0f;
    shot.pitchDeg = -4.0f;
    shot.fovDeg = 10.0f;
    Draw(&shot, bare);
    shot.inputs = defs;
    shot.inputCount = 12;
    Draw(&shot, red);
    int columns = 0;
    for (int x = 0; x < SIDE; ++x)
    {
        float most = 0.0f;
        for (int z = 0; z < SIDE; ++z)
        {
            int i = 4 * (z * SIDE + x);
            most = fmaxf(most, (red[i] - bare[i]) / bare[i]);
        }
        columns += most > 0.1f ? 1 : 0;
    }
    print_message("%d columns of %d show one of 12 marks of 30 m at 4 km\n", columns, SIDE);
    assert_true(columns >= 24); // each is 5.5 pixels wide
}

static void ShadeTakesTheSunAway(void** state)
{
    (void)state;
    static float bare[4 * PIXELS], dark[4 * PIXELS];
    swInputDef def = MakeCircle(SW_INPUT_SHADOW, 16.0f);
    Shot shot = MakeShot(NULL, 0);
    Draw(&shot, bare);
    shot = MakeShot(&def, 1);
    Draw(&shot, dark);
    print_message("blue %.4f, in the shade %.4f\n", (double)bare[MIDDLE + 2], (double)dark[MIDDLE + 2]);
    assert_true(dark[MIDDLE + 2] < 0.9f * bare[MIDDLE + 2]);
    assert_true(dark[0] == bare[0] && dark[2] == bare[2]);
    def.value[0] = 1.0f; // as light as it is
    Draw(&shot, dark);
    assert_float_equal(dark[MIDDLE + 2], bare[MIDDLE + 2], 1e-3f * bare[MIDDLE + 2]);
}

// The share of pixels that differ by a hundredth and more from the mean of those beside them: waves, and no gradient.
static double MeasureRoughness(const float* picture)
{
    int count = 0;
    for (int i = 1; i < PIXELS - 1; ++i)
    {
        const float* pixel = &picture[4 * i + 2];
        bool isWithin = i % SIDE > 0 && i % SIDE < SIDE - 1;
        count += isWithin && fabsf(pixel[0] - 0.5f * (pixel[-4] + pixel[4])) > 0.01f * pixel[0] ? 1 : 0;
    }
    return (double)count / PIXELS;
}

// Waves that live somewhere else are not seen here: neither those that slices hold nor those that are too short for it.
static void WavesAreSeenWhereTheyHaveWeight(void** state)
{
    (void)state;
    static float with[4 * PIXELS], without[4 * PIXELS];
    const struct
    {
        const char* name;
        swWaveMethod method;
    } methods[] = {{"Fourier transforms", SW_WAVES_FFT}, {"Gerstner waves", SW_WAVES_GERSTNER}};
    for (int i = 0; i < 2; ++i)
    {
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.isLocal = true;
        waves.method = methods[i].method;
        waves.maxWavelength = 16.0f;
        swInputDef def = MakeCircle(SW_INPUT_WAVES, 4000.0f);
        def.value[0] = 1.0f;
        Shot shot = MakeShot(&def, 1);
        shot.waves = &waves;
        shot.height = 250.0f;
        shot.pitchDeg = -20.0f;
        shot.fovDeg = 20.0f;
        Draw(&shot, with);
        def.position.x = 9000.0;
        Draw(&shot, without);
        double there = MeasureRoughness(with), elsewhere = MeasureRoughness(without);
        print_message("%s: %.3f of the pixels are rough where the waves live, %.3f elsewhere\n", methods[i].name, there,
                      elsewhere);
        assert_true(there > 0.3 && elsewhere < 0.03);
    }
}

// How alike two pictures of foam are, the second taken `shift` columns further to the right; 1: the same.
static double FindLikeness(const float* a, const float* b, int shift)
{
    double sumA = 0.0, sumB = 0.0, squareA = 0.0, squareB = 0.0, product = 0.0, count = 0.0;
    for (int row = 16; row < SIDE - 16; ++row)
    {
        for (int column = 16; column < SIDE - 16; ++column)
        {
            double x = (double)a[4 * (row * SIDE + column) + 1];
            double y = (double)b[4 * (row * SIDE + column + shift) + 1];
            sumA += x;
            sumB += y;
            squareA += x * x;
            squareB += y * y;
            product += x * y;
            count += 1.0;
        }
    }
    double spread = (squareA - sumA * sumA / count) * (squareB - sumB * sumB / count);
    return (product - sumA * sumB / count) / sqrt(spread);
}

// From 60 m a pixel is 0.34 m wide. While a pattern counts most, 0.8 s of 4 m/s are nine of them.
static void FoamsPatternGoesWithTheFlow(void** state)
{
    (void)state;
    static float before[4 * PIXELS], after[4 * PIXELS];
    swInputDef defs[2] = {swDefaultInputDef(), swDefaultInputDef()};
    defs[0].field = SW_INPUT_FOAM;
    defs[0].value[0] = 0.1f;
    defs[1].field = SW_INPUT_FLOW;
    defs[1].value[0] = 4.0f;
    Shot shot = MakeShot(defs, 2);
    shot.steps = 20;
    shot.time = 13.6;
    Draw(&shot, before);
    shot.time = 14.4;
    Draw(&shot, after);
    double along = FindLikeness(before, after, 9), still = FindLikeness(before, after, 0);
    double against = FindLikeness(before, after, -9);
    print_message("likeness along the flow %.3f, in place %.3f, against it %.3f\n", along, still, against);
    assert_true(along > 0.6 && along > still + 0.3 && along > against + 0.3);
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
        cmocka_unit_test(ARiverThatFallsLeans),
        cmocka_unit_test(ALakeStandsAtItsLevel),
        cmocka_unit_test(ColoursLieWhereTheyWerePut),
        cmocka_unit_test(HalfACoverIsHalfway),
        cmocka_unit_test(ColoursArePresentFarAway),
        cmocka_unit_test(ShadeTakesTheSunAway),
        cmocka_unit_test(WavesAreSeenWhereTheyHaveWeight),
        cmocka_unit_test(FoamsPatternGoesWithTheFlow),
    };
    return cmocka_run_group_tests(tests, OpenCanvas, CloseCanvas);
}
