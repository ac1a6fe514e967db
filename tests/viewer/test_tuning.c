// SPDX-License-Identifier: MIT
// Every value that the panel turns is known to differ from the file's; what a knob shows comes back as the same value;
// and Beaufort's number of the panel is that of a scene file.

#include "tuning.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/cmocka_setup.h"

// Parts of a def that no widget turns.
typedef struct Part
{
    size_t offset, size;
} Part;

#define PART(type, member)                                                                                             \
    {                                                                                                                  \
        offsetof(type, member), sizeof(((type*)0)->member)                                                             \
    }

static bool IsInParts(size_t offset, const Part* parts, int count)
{
    for (int i = 0; i < count; i++)
    {
        if (offset >= parts[i].offset && offset < parts[i].offset + parts[i].size)
        {
            return true;
        }
    }
    return false;
}

// Flip word after word: each that is not left out must be counted, so a new field of a def fails here until it is
// known.
static void CheckWords(Sea* sea, void* start, size_t size, const Part* left, int leftCount)
{
    for (size_t offset = 0; offset + 4 <= size; offset += 4)
    {
        char* word = (char*)start + offset;
        word[0] ^= 1;
        int count = CountChanges(sea);
        word[0] ^= 1;
        if ((count == 1) == IsInParts(offset, left, leftCount))
        {
            fail_msg("the word at %zu counts as %d changes", offset, count);
        }
    }
}

static Sea* MakeSea(void)
{
    Sea* sea = calloc(1, sizeof(Sea));
    assert_non_null(sea);
    sea->look.sky = swDefaultSkyDef();
    sea->look.water = swDefaultWaterDef();
    sea->look.foam = swDefaultFoamDef();
    sea->filedLook = sea->look;
    sea->wavesCount = 1;
    sea->waves[0].def = sea->waves[0].filedDef = swDefaultWaveSystemDef();
    return sea;
}

static void EveryValueOfTheLookCounts(void** state)
{
    (void)state;
    Sea* sea = MakeSea();
    const Part left[] = {PART(SeaLook, sky.internalValue), PART(SeaLook, water.internalValue),
                         PART(SeaLook, foam.internalValue)};
    assert_int_equal(CountChanges(sea), 0);
    CheckWords(sea, &sea->look, sizeof(SeaLook), left, 3);
    free(sea);
}

static void EveryValueOfASystemCounts(void** state)
{
    (void)state;
    Sea* sea = MakeSea();
    const size_t table = offsetof(swWaveSystemDef, spectrum.table);
    const Part left[] = {
        {table, sizeof(void*)},
        PART(swWaveSystemDef, spectrum.internalValue),
        PART(swWaveSystemDef, internalValue),
        {offsetof(swWaveSystemDef, components), sizeof(void*)},
        PART(swWaveSystemDef, componentCount),
    };
    // Holes between members hold nothing.
    memset(&sea->waves[0].def, 0, sizeof(swWaveSystemDef));
    sea->waves[0].filedDef = sea->waves[0].def;
    size_t words = sizeof(swWaveSystemDef) / 4;
    int counted = 0;
    for (size_t i = 0; i < words; i++)
    {
        char* word = (char*)&sea->waves[0].def + 4 * i;
        word[0] ^= 1;
        int count = CountChanges(sea);
        word[0] ^= 1;
        // Another kind of spectrum has other octaves, which then do not count one by one.
        assert_true(count <= 1);
        counted += count;
        if (count == 1 && IsInParts(4 * i, left, 5))
        {
            fail_msg("the word at %zu should not count", 4 * i);
        }
    }
    size_t uncounted = 0;
    for (int i = 0; i < 5; i++)
    {
        uncounted += left[i].size / 4;
    }
    size_t holes = words - uncounted - (size_t)counted;
    print_message("%d values of %zu words count, %zu words are left out, %zu are holes\n", counted, words, uncounted,
                  holes);
    assert_true(holes <= 4);
    free(sea);
}

static void SystemsRowsAndReplaysCount(void** state)
{
    (void)state;
    Sea* sea = MakeSea();
    SeaWaves* waves = &sea->waves[0];
    waves->record = 3;
    assert_int_equal(CountChanges(sea), 1);
    waves->replayDef.speed = 60.0;
    waves->replayDef.startTime = 1.0;
    assert_int_equal(CountChanges(sea), 2);
    waves->isRemoved = true;
    assert_int_equal(CountChanges(sea), 1);
    free(sea);
}

static void KnobsShowAndReadTheSame(void** state)
{
    (void)state;
    Knob bearing = {.isBearing = true}, degrees = {.unit = DEGREE}, plain = {0};
    assert_true(fabsf(ShowValue(&bearing, SW_DIRECTION_FROM_BEARING(225.0)) - 225.0f) < 1e-3f);
    assert_true(fabsf(ShowValue(&bearing, -7.0f) - ShowValue(&bearing, -7.0f + (float)(4.0 * SW_PI))) < 1e-2f);
    assert_true(fabsf(ShowValue(&degrees, ReadShown(&degrees, 33.0f)) - 33.0f) < 1e-4f);
    assert_true(ReadShown(&plain, ShowValue(&plain, 0.3f)) == 0.3f);
    Knob height = {.format = "%.2f m", .zero = "from the wind"};
    assert_string_equal(ChooseFormat(&height, 0.0f), "from the wind");
    assert_string_equal(ChooseFormat(&height, 1.0f), "%.2f m");
}

static swSpectrumDef ReadBeaufort(float number)
{
    char text[160];
    swScene* scene = NULL;
    swHost host = swDefaultHost();
    int length = snprintf(text, sizeof(text), "waves:\n  - {beaufort: %.9g, direction_from_deg: 200, depth_m: 40}\n",
                          (double)number);
    assert_int_equal(swReadSceneText(&host, text, (size_t)length, "test", ".", &scene), SW_SUCCESS);
    swSpectrumDef spectrum = scene->waves[0].def.spectrum;
    swDestroyScene(scene);
    return spectrum;
}

static void BeaufortsNumberIsThatOfASceneFile(void** state)
{
    (void)state;
    for (int i = 0; i <= 120; i++)
    {
        float number = (float)i / 10.0f;
        swSpectrumDef filed = ReadBeaufort(number);
        BeaufortNumber found = FindBeaufort(&filed);
        // Below about a third the wind is the least that a spectrum takes.
        assert_true(fabsf(found.number - number) < 2e-3f || (number < 0.3f && found.number < 0.3f));
        swSpectrumDef set = filed;
        set.kind = SW_SPECTRUM_TMA;
        set.windSpeed = 3.0f;
        set.significantHeight = set.peakPeriod = 0.0f;
        SetBeaufort(&set, number);
        assert_true(set.kind == filed.kind && set.windSpeed == filed.windSpeed && set.depth == filed.depth);
        assert_true(set.significantHeight == filed.significantHeight && set.peakPeriod == filed.peakPeriod);
        assert_true(set.direction == filed.direction && set.gamma == filed.gamma && set.spreading == filed.spreading);
        assert_true(found.isExact || number < 0.3f);
    }
}

static void ASeaOfOtherHeightHasNoNumber(void** state)
{
    (void)state;
    swSpectrumDef spectrum = ReadBeaufort(6.0f);
    spectrum.significantHeight *= 1.1f;
    assert_false(FindBeaufort(&spectrum).isExact);
    spectrum = swDefaultSpectrumDef();
    assert_false(FindBeaufort(&spectrum).isExact);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryValueOfTheLookCounts),         cmocka_unit_test(EveryValueOfASystemCounts),
        cmocka_unit_test(SystemsRowsAndReplaysCount),        cmocka_unit_test(KnobsShowAndReadTheSame),
        cmocka_unit_test(BeaufortsNumberIsThatOfASceneFile), cmocka_unit_test(ASeaOfOtherHeightHasNoNumber),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
