// SPDX-License-Identifier: MIT
// All mistakes of a scene file are told at once, ranges are those of the library, and what is no scene is refused
// before it costs time.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/scene.h"

#define SCENES SW_SOURCE_DIR "/scenes"

static swResult ReadText(const char* text, swScene** scene)
{
    swHost host = MakeHost();
    return swReadSceneText(&host, text, strlen(text), "a.yaml", SCENES, scene);
}

// Mistakes of one file are told together, each with its line and code, and none twice.
static void EveryMistakeIsTold(void** state)
{
    (void)state;
    static const char text[] = "nam: a\n"                                       // 1 unknown_key
                               "time_s: 1e12\n"                                 // 2 out_of_range
                               "sky: {haze: 30, haze: 1}\n"                     // 3 out_of_range, repeated
                               "sun: 3\n"                                       // 4 wrong_form
                               "view: {resolution: 100, finest_texel_m: 0.1}\n" // 5 out_of_range twice
                               "water:\n"
                               "  absorption_per_m: [a, 1, 200]\n" // 7 wrong_form, out_of_range
                               "waves:\n"
                               "  - spectrum: jonswop\n" // 9 unknown_word; what goes with it cannot be known
                               "    resolution: 100\n"   // 10 out_of_range
                               "    fetch_m: 1e5\n"
                               "  - spectrum: swell\n" // 12 missing_key
                               "    gamma: 3\n"        // 13 no_effect
                               "    fetch_m: 1e5\n"    // 14 no_effect
                               "    chop: 5\n"         // 15 out_of_range
                               "  - seed: -1\n"        // 16 out_of_range, missing_key
                               "  - spectrum: file\n"
                               "    file: none.spec\n" // 18 bad_file
                               "    weight: heavy\n"   // 19 wrong_form
                               "  - components:\n"
                               "      - {wavelength_m: 50, amplitude_m: 99, direction_from_deg: 1}\n" // 21 out_of_range
                               "      - {wavelength_m: 50}\n" // 22 missing_key twice
                               "    seed: 4\n"                // with which of the two?
                               "    beaufort: 4\n"            // 24 conflict
                               "views:\n"
                               "  - {name: a, fov_deg: 500}\n"        // 26 out_of_range
                               "  - {name: a, sun_azimuth_deg: 3}\n"; // 27 repeated, missing_key
    static const char* const wanted[] = {
        "1 unknown_key",  "2 out_of_range",  "3 out_of_range",  "3 repeated",      "4 wrong_form",    "5 out_of_range",
        "5 out_of_range", "7 wrong_form",    "7 out_of_range",  "9 unknown_word",  "10 out_of_range", "12 missing_key",
        "13 no_effect",   "14 no_effect",    "15 out_of_range", "16 out_of_range", "16 missing_key",  "18 bad_file",
        "19 wrong_form",  "21 out_of_range", "22 missing_key",  "22 missing_key",  "24 conflict",     "26 out_of_range",
        "27 repeated",    "27 missing_key",
    };
    const int wantedCount = (int)(sizeof(wanted) / sizeof(wanted[0]));
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_ERROR_FORMAT);
    assert_null(scene);
    char found[64][32];
    bool isFound[64] = {false};
    int count = 0;
    for (char* line = strtok(s_messages, "\n"); line != NULL; line = strtok(NULL, "\n"))
    {
        char* code = strrchr(line, '[');
        if (strncmp(line, "a.yaml:", 7) == 0)
        {
            assert_non_null(code);
            assert_true(count < 64);
            snprintf(found[count++], sizeof(found[0]), "%d %.*s", atoi(line + 7), (int)strcspn(code + 1, "]"),
                     code + 1);
        }
    }
    for (int i = 0; i < wantedCount; ++i)
    {
        int j = 0;
        while (j < count && (isFound[j] || strcmp(found[j], wanted[i]) != 0))
        {
            ++j;
        }
        if (j == count)
        {
            fail_msg("\"%s\" is not told", wanted[i]);
        }
        isFound[j] = true;
    }
    for (int j = 0; j < count; ++j)
    {
        if (!isFound[j])
        {
            fail_msg("\"%s\" is told, but there is no such mistake", found[j]);
        }
    }
}

// What the reader takes, the world takes, and what lies beyond has its line.
static void EndsOfRangesMakeWorlds(void** state)
{
    (void)state;
    static const struct
    {
        const char *text, *key; // with %s for the value
        double low, high;
    } cases[] = {
        {"world: {gravity_mps2: %s}\n", "gravity_mps2", 0.1, 100.0},
        {"world: {surface_tension_m3ps2: %s}\n", "surface_tension_m3ps2", 0.0, 1e-3},
        {"world: {sea_level_m: %s}\n", "sea_level_m", -1e6, 1e6},
        {"foam: {fade_rate_per_s: %s}\n", "fade_rate_per_s", 0.01, 10.0},
        {"foam: {threshold: %s}\n", "threshold", -4.0, 1.0},
        {"foam: {coverage: %s}\n", "coverage", 0.0, 100.0},
        {"foam: {wind_speed_mps: %s}\n", "wind_speed_mps", 0.0, 100.0},
        {"foam: {min_wavelength_m: %s}\n", "min_wavelength_m", 0.0, 1024.0},
        {"time_s: %s\n", "time_s", -2.7e11, 2.7e11},
        {"waves: [{beaufort: %s}]\n", "beaufort", 0.0, 12.0},
        {"waves: [{sea_state: %s}]\n", "sea_state", 0.0, 9.0},
        {"waves: [{spectrum: jonswap, wind_speed_mps: %s}]\n", "wind_speed_mps", 0.1, 100.0},
        {"waves: [{spectrum: jonswap, fetch_m: %s}]\n", "fetch_m", 1e3, 1e7},
        {"waves: [{spectrum: jonswap, gamma: %s}]\n", "gamma", 1.0, 10.0},
        {"waves: [{spectrum: jonswap, significant_height_m: %s}]\n", "significant_height_m", 0.0, 40.0},
        {"waves: [{spectrum: jonswap, peak_period_s: %s}]\n", "peak_period_s", 0.0, 60.0},
        {"waves: [{spectrum: jonswap, spread_exponent: %s}]\n", "spread_exponent", 0.0, 200.0},
        {"waves: [{spectrum: jonswap, turbulence: %s}]\n", "turbulence", 0.0, 1.0},
        {"waves: [{spectrum: jonswap, swell: %s}]\n", "swell", 0.0, 1.0},
        {"waves: [{spectrum: jonswap, min_wavelength_m: %s, max_wavelength_m: 4096}]\n", "min_wavelength_m", 0.0625,
         2000.0},
        {"waves: [{spectrum: jonswap, max_wavelength_m: %s}]\n", "max_wavelength_m", 0.125, 4096.0},
        {"waves: [{spectrum: jonswap, chop: %s}]\n", "chop", 0.0, 2.0},
        {"waves: [{spectrum: jonswap, weight: %s}]\n", "weight", 0.0, 10.0},
        {"waves: [{spectrum: jonswap, depth_m: %s}]\n", "depth_m", 0.001, 1e9},
        {"waves: [{spectrum: jonswap, loop_period_s: %s}]\n", "loop_period_s", 0.0, 2.7e11},
        {"waves: [{spectrum: jonswap, seed: %s}]\n", "seed", 0.0, 4294967295.0},
        {"waves: [{spectrum: jonswap, method: gerstner, components_per_octave: %s}]\n", "components_per_octave", 1.0,
         32.0},
        {"waves: [{spectrum: jonswap, method: gerstner, reverse_weight: %s}]\n", "reverse_weight", 0.0, 1.0},
        {"waves: [{spectrum: jonswap, method: gerstner, direction_variance_deg: %s}]\n", "direction_variance_deg", 0.0,
         180.0},
        {"waves: [{spectrum: octaves, multiplier: %s}]\n", "multiplier", 0.1, 10.0},
        {"waves: [{spectrum: octaves, gravity_scale: %s}]\n", "gravity_scale", 0.0, 25.0},
        {"waves: [{spectrum: wind_sea, duration_h: %s}]\n", "duration_h", 0.1, 1000.0},
        {"waves: [{spectrum: swell, significant_height_m: 1, peak_period_s: 9, spread_deg: %s}]\n", "spread_deg", 6.0,
         80.0},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        double step = 0.01 * (cases[i].high - cases[i].low);
        const double values[] = {cases[i].low, cases[i].high, cases[i].low - step, cases[i].high + step};
        // Of these the other key or the waves' energy ends the range before.
        bool isInner = strstr(cases[i].key, "wavelength") != NULL || strcmp(cases[i].key, "multiplier") == 0 ||
                       strcmp(cases[i].key, "depth_m") == 0; // there is no end to that one
        for (int j = 0; j < (isInner ? 2 : 4); ++j)
        {
            char value[40], text[256], words[80];
            snprintf(value, sizeof(value), "%.17g", values[j]);
            int before = (int)(strstr(cases[i].text, "%s") - cases[i].text);
            snprintf(text, sizeof(text), "%.*s%s%s", before, cases[i].text, value, cases[i].text + before + 2);
            snprintf(words, sizeof(words), "a.yaml:1: %s is ", cases[i].key);
            swHost host = MakeHost();
            swScene* scene = NULL;
            swWorld* world = NULL;
            swResult result = swReadSceneText(&host, text, strlen(text), "a.yaml", SCENES, &scene);
            result = result == SW_SUCCESS ? swCreateSceneWorld(&host, scene, &world) : result;
            if ((result == SW_SUCCESS) != (j < 2) || (j >= 2 && strstr(s_messages, words) == NULL))
            {
                fail_msg("%s%s", text, s_messages);
            }
            swDestroyWorld(world);
            swDestroyScene(scene);
        }
    }
}

static char* Repeat(const char* word, int count, const char* end)
{
    size_t size = strlen(word);
    char* text = malloc(size * (size_t)count + strlen(end) + 1);
    assert_non_null(text);
    for (int i = 0; i < count; ++i)
    {
        memcpy(text + size * (size_t)i, word, size);
    }
    strcpy(text + size * (size_t)count, end);
    return text;
}

// The parser's time grows with the square of the depth: a million brackets took minutes.
static void WhatIsTooLargeIsRefusedAtOnce(void** state)
{
    (void)state;
    static const struct
    {
        const char* word;
        int count;
        const char *end, *words;
    } cases[] = {
        {"[", 1000000, "", "a.yaml:1: lists and mappings are nested more than 16 deep; remove what is no scene."},
        {"{a: ", 200000, "", "a.yaml:1: lists and mappings are nested more than 16 deep"},
        {"- ", 400000, "a", "a.yaml:1: lists and mappings are nested more than 16 deep"},
        {"? ", 400000, "a", "a.yaml:1: lists and mappings are nested more than 16 deep"},
        {"- a\n", 200000, "", "there are more than 100000 values; remove what is no scene. [too_large]"},
        {"- &a b\n", 90000, "", "a.yaml:1001: there are more than 1000 anchors (&); remove what is no scene."},
        {"%TAG ! a\n", 90000, "", "a.yaml:1001: there are more than 1000 directives (%); remove what is no scene."},
        {"a: b\n", 100, "", "a.yaml:64: here is mistake 64, and more are not looked for; mend those above."},
        {"waves:\n  - a: {b: [c]}\n", 1, "    d: e\n", "a.yaml:3: 'd' is no key of waves"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swScene* scene = NULL;
        char* text = Repeat(cases[i].word, cases[i].count, cases[i].end);
        swHost host = MakeHost();
        assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", SCENES, &scene), SW_ERROR_FORMAT);
        free(text);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryMistakeIsTold),
        cmocka_unit_test(EndsOfRangesMakeWorlds),
        cmocka_unit_test(WhatIsTooLargeIsRefusedAtOnce),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
