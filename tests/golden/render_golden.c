// SPDX-License-Identifier: MIT
// Golden pictures: a few seas from a few heights, drawn small, held against references block by block, and looked over
// for what no picture may have: numbers that are none, fireflies, a horizon with an edge.
//
//   render_golden                  the tests
//   render_golden --update         draw the references anew
//   render_golden --out FILE.png [--size WxH] [--shot NAME] [--wind MPS] [--swell M] [--height M] [--heading DEG]
//       [--pitch DEG] [--fov DEG] [--sun AZIMUTH,ELEVATION] [--haze H] [--clouds C] [--time S] [--at X,Z]
//       [--steps N] [--debug MODE]   one picture, for looking

#include <math.h>
#include <stdio.h>
#include <time.h>

#include "golden/canvas.h"
#include "golden/png_file.h"
#include "support/cmocka_setup.h"

#define WIDTH 320
#define HEIGHT 180
#define BLOCK 10
#define AUREOLE_BEND 0.003f
#define NADIR_CONTRAST 1.02f

// clang-format off
static const Shot s_shots[] = {
    // name                 wind swell height head pitch  fov  sun az, el  haze cloud  time
    {"calm_2m_noon",        3.5f, 0.4f,    2.0f, 200, -4.0f, 55, 160, 55, 1.0f, 0.35f, 20.0, .steps = 2},
    {"breeze_20m_noon",     9.0f, 1.0f,   20.0f, 200, -9.0f, 50, 160, 50, 1.0f, 0.35f, 20.0, .steps = 3},
    {"breeze_20m_sunset",   9.0f, 1.0f,   20.0f, 265, -6.0f, 50, 270,  4, 1.0f, 0.35f, 20.0, .steps = 3},
    {"gale_8m_noon",       20.0f, 0.0f,    8.0f,  80, -4.0f, 55, 160, 45, 1.5f, 0.50f, 20.0, .steps = 4},
    {"gale_200m_noon",     20.0f, 0.0f,  200.0f, 200, -14.0f, 45, 160, 50, 1.5f, 0.35f, 20.0, .steps = 4},
    {"breeze_5km_sunset",   9.0f, 1.0f, 5000.0f, 260, -20.0f, 45, 270,  6, 1.0f, 0.35f, 20.0, .steps = 2},
};
// clang-format on
#define SHOT_COUNT ((int)(sizeof(s_shots) / sizeof(s_shots[0])))

static Canvas* s_canvas;

static void MakePath(char* path, size_t size, const char* folder, const char* name, const char* suffix)
{
    snprintf(path, size, "%s/%s%s.png", folder, name, suffix);
}

typedef struct Difference
{
    double mean;  // of all blocks, in steps of 1 / 255
    double worst; // block
} Difference;

// Blocks forgive a wave crest that stands a pixel aside on another device, but not another colour or brightness.
static Difference Compare(const uint8_t* a, const uint8_t* b)
{
    Difference difference = {0};
    int count = 0;
    for (int y = 0; y < HEIGHT; y += BLOCK)
    {
        for (int x = 0; x < WIDTH; x += BLOCK)
        {
            double sum[3] = {0};
            for (int i = 0; i < BLOCK * BLOCK; ++i)
            {
                size_t pixel = 4 * ((size_t)(y + i / BLOCK) * WIDTH + (size_t)(x + i % BLOCK));
                for (int c = 0; c < 3; ++c)
                {
                    sum[c] += (double)a[pixel + (size_t)c] - (double)b[pixel + (size_t)c];
                }
            }
            double block = (fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2])) / (3.0 * BLOCK * BLOCK);
            difference.mean += block;
            difference.worst = fmax(difference.worst, block);
            ++count;
        }
    }
    difference.mean /= count;
    return difference;
}

static void PicturesLookAsTheirReferences(void** state)
{
    (void)state;
    static uint8_t pixels[4 * WIDTH * HEIGHT];
    int badCount = 0;
    for (int i = 0; i < SHOT_COUNT; ++i)
    {
        char path[512];
        MakePath(path, sizeof(path), SW_SOURCE_DIR "/tests/golden/reference", s_shots[i].name, "");
        uint8_t* reference = ReadPng(path, WIDTH, HEIGHT);
        assert_non_null(reference);
        assert_true(DrawShot(s_canvas, &s_shots[i], pixels, NULL));
        Difference difference = Compare(pixels, reference);
        free(reference);
        bool isGood = difference.mean < 2.0 && difference.worst < 16.0;
        print_message("%-20s mean %.2f, worst block %.2f of 255%s\n", s_shots[i].name, difference.mean,
                      difference.worst, isGood ? "" : "  DIFFERS");
        if (!isGood)
        {
            MakePath(path, sizeof(path), ".", s_shots[i].name, ".actual");
            WritePng(path, WIDTH, HEIGHT, pixels);
            ++badCount;
        }
    }
    assert_int_equal(badCount, 0);
}

static float Luminance(const float* hdr, int x, int y)
{
    const float* p = hdr + 4 * ((size_t)y * WIDTH + (size_t)x);
    return 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
}

// Pixels that outshine all their neighbours eight times.
static int CountFireflies(const float* hdr)
{
    int count = 0;
    for (int y = 1; y < HEIGHT - 1; ++y)
    {
        for (int x = 1; x < WIDTH - 1; ++x)
        {
            float brightest = 0.0f;
            for (int i = 0; i < 9; ++i)
            {
                brightest = i == 4 ? brightest : fmaxf(brightest, Luminance(hdr, x + i % 3 - 1, y + i / 3 - 1));
            }
            count += Luminance(hdr, x, y) > 8.0f * brightest;
        }
    }
    return count;
}

static void PicturesHoldNoFirefliesAndOnlyNumbers(void** state)
{
    (void)state;
    static float hdr[4 * WIDTH * HEIGHT];
    for (int i = 0; i < SHOT_COUNT; ++i)
    {
        assert_true(DrawShot(s_canvas, &s_shots[i], NULL, hdr));
        for (int k = 0; k < 4 * WIDTH * HEIGHT; ++k)
        {
            assert_true(isfinite(hdr[k]) && hdr[k] >= 0.0f);
        }
        int fireflies = CountFireflies(hdr);
        print_message("%-20s %d fireflies\n", s_shots[i].name, fireflies);
        assert_int_equal(fireflies, 0);
    }
}

// Steepest change of brightness between rows near the horizon, as a ratio.
static float HorizonEdge(const float* hdr)
{
    float steepest = 1.0f;
    float before = 0.0f;
    for (int y = 0; y < HEIGHT; ++y)
    {
        float row = 0.0f;
        for (int x = 0; x < WIDTH; ++x)
        {
            row += Luminance(hdr, x, y);
        }
        if (y > 0)
        {
            steepest = fmaxf(steepest, fmaxf(row / before, before / row));
        }
        before = row;
    }
    return steepest;
}

static void SeaAndSkyJoinAtTheHorizon(void** state)
{
    (void)state;
    static float hdr[4 * WIDTH * HEIGHT];
    Shot high = {"high", 9.0f, 1.0f, 5000.0f, 20.0f, -2.0f, 20.0f, 160.0f, 50.0f, 1.0f, 0.0f, 20.0, .steps = 0};
    assert_true(DrawShot(s_canvas, &high, NULL, hdr));
    float edge = HorizonEdge(hdr);
    print_message("5 km: rows of the horizon differ by a factor of at most %.3f\n", (double)edge);
    assert_true(edge < 1.12f);
    Shot low = high;
    low.height = 20.0f;
    assert_true(DrawShot(s_canvas, &low, NULL, hdr));
    edge = HorizonEdge(hdr);
    print_message("20 m: rows of the horizon differ by a factor of at most %.3f\n", (double)edge);
    assert_true(edge < 2.2f);
}

// Largest bend of the brightness across the aureole, over the brightness: a table's columns would show as kinks,
// upright ones above each other. A mean over rows, since half floats step by a thousandth.
static float AureoleKink(const float* hdr)
{
    enum
    {
        ROWS = 9,
        REACH = 2
    };
    float worst = 0.0f;
    for (int x = REACH; x < WIDTH - REACH; ++x)
    {
        float left = 0.0f, middle = 0.0f, right = 0.0f;
        for (int y = HEIGHT / 2 - ROWS / 2; y <= HEIGHT / 2 + ROWS / 2; ++y)
        {
            left += Luminance(hdr, x - REACH, y);
            middle += Luminance(hdr, x, y);
            right += Luminance(hdr, x + REACH, y);
        }
        bool isNearSun = abs(x - WIDTH / 2) < 8;
        worst = isNearSun ? worst : fmaxf(worst, fabsf(left - 2.0f * middle + right) / middle);
    }
    return worst;
}

static void TheAureoleHasNoUprightEdges(void** state)
{
    (void)state;
    static float hdr[4 * WIDTH * HEIGHT];
    Shot shot = {"aureole", 3.0f, 0.0f, 20.0f, 180.0f, 30.0f, 30.0f, 180.0f, 30.0f, 4.0f, 0.0f, 0.0, .steps = 0};
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    float kink = AureoleKink(hdr);
    print_message("the aureole's brightness bends by at most %.4f\n", (double)kink);
    assert_true(kink < AUREOLE_BEND);
}

// Around the point straight below, at a distance of some pixels: highest over lowest brightness.
static float NadirContrast(const float* hdr)
{
    float low = 1e30f, high = 0.0f;
    for (int i = 0; i < 16; ++i)
    {
        double angle = 2.0 * SW_PI * i / 16.0;
        float sum = 0.0f;
        for (int k = 0; k < 9; ++k) // of waves that a pixel does not hide
        {
            int x = WIDTH / 2 + (int)lround(9.0 * cos(angle)) + k % 3 - 1;
            int y = HEIGHT / 2 + (int)lround(9.0 * sin(angle)) + k / 3 - 1;
            sum += Luminance(hdr, x, y);
        }
        low = fminf(low, sum);
        high = fmaxf(high, sum);
    }
    return high / low;
}

static void NoWedgeShowsStraightBelow(void** state)
{
    (void)state;
    static float hdr[4 * WIDTH * HEIGHT];
    Shot shot = {"nadir", 1.0f, 0.0f, 1000.0f, 0.0f, -90.0f, 55.0f, 135.0f, 8.0f, 2.0f, 0.0f, 0.0, .steps = 0};
    assert_true(DrawShot(s_canvas, &shot, NULL, hdr));
    float contrast = NadirContrast(hdr);
    print_message("1 km up: around the nadir brightness differs by a factor of %.3f\n", (double)contrast);
    assert_true(contrast < NADIR_CONTRAST);
}

// From the same sea by other ways.
static void LayersOfTheCoreGiveTheSamePicture(void** state)
{
    (void)state;
    static uint8_t passes[4 * WIDTH * HEIGHT], core[4 * WIDTH * HEIGHT];
    Shot shot = s_shots[3];
    assert_true(DrawShot(s_canvas, &shot, passes, NULL));
    shot.hasCoreLayers = true;
    assert_true(DrawShot(s_canvas, &shot, core, NULL));
    Difference difference = Compare(passes, core);
    print_message("layers of the core: mean %.3f, worst block %.3f of 255\n", difference.mean, difference.worst);
    assert_true(difference.mean < 0.1 && difference.worst < 1.5);
}

static void ThrownAwayCommandsLeaveThePictureAsItIs(void** state)
{
    (void)state;
    static uint8_t sound[4 * WIDTH * HEIGHT], hurt[4 * WIDTH * HEIGHT];
    Shot shot = s_shots[0];
    shot.hasCoreLayers = true;
    assert_true(DrawShot(s_canvas, &shot, sound, NULL));
    for (int way = 0; way < 2; ++way)
    {
        shot.hasCoreLayers = way == 0;
        shot.dropsCommands = true;
        assert_true(DrawShot(s_canvas, &shot, hurt, NULL));
        Difference difference = Compare(sound, hurt);
        print_message("thrown away: mean %.3f, worst block %.3f of 255\n", difference.mean, difference.worst);
        assert_true(way == 0 ? difference.worst == 0.0 : difference.mean < 0.1);
    }
}

static int OpenCanvas(void** state)
{
    (void)state;
    s_canvas = CreateCanvas(WIDTH, HEIGHT, false);
    return s_canvas ? 0 : -1;
}

static int CloseCanvas(void** state)
{
    (void)state;
    DestroyCanvas(s_canvas);
    return 0;
}

static int UpdateReferences(void)
{
    static uint8_t pixels[4 * WIDTH * HEIGHT];
    Canvas* canvas = CreateCanvas(WIDTH, HEIGHT, false);
    bool isGood = canvas != NULL;
    for (int i = 0; i < SHOT_COUNT && isGood; ++i)
    {
        char path[512];
        MakePath(path, sizeof(path), SW_SOURCE_DIR "/tests/golden/reference", s_shots[i].name, "");
        isGood = DrawShot(canvas, &s_shots[i], pixels, NULL) && WritePng(path, WIDTH, HEIGHT, pixels);
        printf("%s\n", path);
    }
    DestroyCanvas(canvas);
    return isGood ? 0 : 1;
}

typedef struct Request
{
    Shot shot;
    const char* out;
    unsigned width, height;
    bool validate, times;
} Request;

static bool ParseFloat(const char* text, float* value)
{
    char* end;
    *value = strtof(text, &end);
    return end != text && *end == '\0';
}

static bool ParseName(Request* request, const char* option, const char* value)
{
    if (strcmp(option, "--shot") == 0)
    {
        for (int i = 0; i < SHOT_COUNT; ++i)
        {
            if (strcmp(value, s_shots[i].name) == 0)
            {
                request->shot = s_shots[i];
                return true;
            }
        }
        return false;
    }
    for (int i = 0; i < SW_DEBUG_COUNT; ++i)
    {
        if (strcmp(value, swDebugMode_GetName((swDebugMode)i)) == 0)
        {
            request->shot.debug = (swDebugMode)i;
            return true;
        }
    }
    return false;
}

static bool ParseOption(Request* request, const char* option, const char* value)
{
    Shot* shot = &request->shot;
    const struct
    {
        const char* name;
        float* target;
    } numbers[] = {
        {"--wind", &shot->windSpeed},     {"--swell", &shot->swellHeight}, {"--height", &shot->height},
        {"--heading", &shot->headingDeg}, {"--pitch", &shot->pitchDeg},    {"--fov", &shot->fovDeg},
        {"--haze", &shot->haze},          {"--clouds", &shot->clouds},
    };
    for (size_t i = 0; i < sizeof(numbers) / sizeof(numbers[0]); ++i)
    {
        if (strcmp(option, numbers[i].name) == 0)
        {
            return ParseFloat(value, numbers[i].target);
        }
    }
    if (strcmp(option, "--out") == 0)
    {
        request->out = value;
        return true;
    }
    if (strcmp(option, "--size") == 0)
    {
        return sscanf(value, "%ux%u", &request->width, &request->height) == 2;
    }
    if (strcmp(option, "--sun") == 0)
    {
        return sscanf(value, "%f,%f", &shot->sunAzimuthDeg, &shot->sunElevationDeg) == 2;
    }
    if (strcmp(option, "--at") == 0)
    {
        return sscanf(value, "%lf,%lf", &shot->x, &shot->z) == 2;
    }
    if (strcmp(option, "--time") == 0)
    {
        return sscanf(value, "%lf", &shot->time) == 1;
    }
    if (strcmp(option, "--steps") == 0)
    {
        return sscanf(value, "%d", &shot->steps) == 1;
    }
    return (strcmp(option, "--shot") == 0 || strcmp(option, "--debug") == 0) && ParseName(request, option, value);
}

static int DrawRequest(const Request* request)
{
    size_t count = 4ull * request->width * request->height;
    uint8_t* pixels = malloc(count);
    float* hdr = request->times ? malloc(count * sizeof(float)) : NULL; // a second frame, so that times have arrived
    Canvas* canvas = CreateCanvas(request->width, request->height, request->validate);
    struct timespec begin, end;
    timespec_get(&begin, TIME_UTC);
    bool isGood = pixels && canvas && DrawShot(canvas, &request->shot, pixels, hdr);
    timespec_get(&end, TIME_UTC);
    isGood = isGood && WritePng(request->out, request->width, request->height, pixels);
    if (isGood)
    {
        double seconds = (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
        printf("%s: %s, %.2f s, %d validation messages\n", request->out, GetCanvasDevice(canvas), seconds,
               GetCanvasValidationCount(canvas));
    }
    if (isGood && request->times)
    {
        PrintCanvasTimes(canvas);
    }
    DestroyCanvas(canvas);
    free(hdr);
    free(pixels);
    return isGood ? 0 : 1;
}

int main(int argc, char** argv)
{
    Request request = {.shot = s_shots[1], .width = 1280, .height = 720};
    for (int i = 1; i < argc; ++i)
    {
        if (strcmp(argv[i], "--update") == 0)
        {
            return UpdateReferences();
        }
        if (strcmp(argv[i], "--validate") == 0 || strcmp(argv[i], "--times") == 0)
        {
            request.validate = request.validate || argv[i][2] == 'v';
            request.times = request.times || argv[i][2] == 't';
        }
        else if (i + 1 >= argc || !ParseOption(&request, argv[i], argv[i + 1]))
        {
            fprintf(stderr, "render_golden: do not understand %s\n", argv[i]);
            return 2;
        }
        else
        {
            ++i;
        }
    }
    if (request.out)
    {
        return DrawRequest(&request);
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(PicturesLookAsTheirReferences),
        cmocka_unit_test(PicturesHoldNoFirefliesAndOnlyNumbers),
        cmocka_unit_test(SeaAndSkyJoinAtTheHorizon),
        cmocka_unit_test(TheAureoleHasNoUprightEdges),
        cmocka_unit_test(NoWedgeShowsStraightBelow),
        cmocka_unit_test(LayersOfTheCoreGiveTheSamePicture),
        cmocka_unit_test(ThrownAwayCommandsLeaveThePictureAsItIs),
    };
    return cmocka_run_group_tests(tests, OpenCanvas, CloseCanvas);
}
