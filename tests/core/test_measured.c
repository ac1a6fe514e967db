// SPDX-License-Identifier: MIT
// NDBC texts become seas: the sample that we ship, the buoys' own files where they lie beside the sources, and every
// way for a text to be wrong.

#include "support/cmocka_setup.h"
#include "support/text_file.h"
#include "support/sea_states.h"
#include "support/messages.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/spectra/spectrum.h"
#include "seaway/math.h"
#include "seaway/measured.h"

#define SAMPLE SW_SOURCE_DIR "/scenes/data/harbour_storm"
#define BUOYS SW_SOURCE_DIR "/../shared/data/spectra"

static swNdbcTexts ReadSet(const char* stem)
{
    static const char* const endings[] = {"data_spec", "swdir", "swdir2", "swr1", "swr2"};
    char* texts[5];
    size_t sizes[5] = {0};
    for (int i = 0; i < 5; ++i)
    {
        char path[512];
        snprintf(path, sizeof(path), "%s.%s", stem, endings[i]);
        texts[i] = ReadTextFile(path, &sizes[i]);
    }
    return (swNdbcTexts){.energy = texts[0],
                         .alpha1 = texts[1],
                         .alpha2 = texts[2],
                         .r1 = texts[3],
                         .r2 = texts[4],
                         .energySize = sizes[0],
                         .alpha1Size = sizes[1],
                         .alpha2Size = sizes[2],
                         .r1Size = sizes[3],
                         .r2Size = sizes[4]};
}

static void FreeSet(swNdbcTexts* texts)
{
    free((void*)texts->energy);
    free((void*)texts->alpha1);
    free((void*)texts->alpha2);
    free((void*)texts->r1);
    free((void*)texts->r2);
}

static swResult ParseStrings(const swHost* host, const char* energy, const char* alpha1, const char* r1,
                             swMeasuredSea** sea)
{
    swNdbcTexts texts = {
        .energy = energy, .alpha1 = alpha1, .r1 = r1, .energyName = "e.txt", .alpha1Name = "a.txt", .r1Name = "r.txt"};
    texts.energySize = strlen(energy);
    texts.alpha1Size = alpha1 != NULL ? strlen(alpha1) : 0;
    texts.r1Size = r1 != NULL ? strlen(r1) : 0;
    return swParseNdbc(host, &texts, sea);
}

static void SampleStormGrows(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swNdbcTexts texts = ReadSet(SAMPLE);
    assert_non_null(texts.energy);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
    FreeSet(&texts);
    assert_int_equal(swMeasuredSea_GetCount(sea), 3);
    assert_int_equal(swMeasuredSea_FindLargest(sea), 2);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2024-11-16 04:50");
    assert_string_equal(swMeasuredSea_GetRecord(sea, 2).time, "2024-11-16 06:50");
    assert_int_equal(swMeasuredSea_FindTime(sea, "2024-11-16 05:29"), 1);
    assert_int_equal(swMeasuredSea_FindTime(sea, "2024-11-16T04:20"), 0); // half an hour before the first
    assert_int_equal(swMeasuredSea_FindTime(sea, "2024-11-16T04:19"), -1);
    assert_int_equal(swMeasuredSea_FindTime(sea, "2024-11-16 07:20"), 2);
    assert_int_equal(swMeasuredSea_FindTime(sea, "2031-01-01 00:00"), -1);
    assert_int_equal(swMeasuredSea_FindTime(sea, "yesterday"), -1);
    assert_int_equal(swMeasuredSea_FindTime(sea, "2024-02-30 00:00"), -1);

    swSeaState storm = GetSeaState(sea, 2, true); // 2.4 m wind sea and 1.1 m swell: 2.64 m
    assert_true(fabs((double)storm.significantHeight - 2.64) < 0.1);
    assert_true(fabs((double)storm.peakPeriod - 8.33) < 0.1);
    assert_true(GetAngleBetween(GetBearing(storm.peakDirection), 233.0) < 5.0);
    assert_int_equal(swMeasuredSea_GetRecord(sea, 2).correctedCount, 0);

    // Printed 0.033, meant 0.0325.
    assert_true(swMeasuredSea_GetRecord(sea, 0).table.frequencies[0] == 0.0325f);
    assert_true(swMeasuredSea_GetRecord(sea, 0).table.bandwidths[0] == 0.005f);
    swDestroyMeasuredSea(sea);
}

// The number before the index-th parenthesis of a text's second line.
static double GetPrinted(const char* text, int index)
{
    const char* at = strchr(text, '\n') + 1;
    for (int i = 0; i < index; ++i)
    {
        at = strchr(at, ')') + 1;
    }
    const char* parenthesis = strchr(at, '(');
    const char* number = parenthesis - 1;
    while (number > text && number[-1] != ' ' && number[-1] != ')')
    {
        --number;
    }
    return atof(number);
}

static void RecordsHoldThePrintedMoments(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swNdbcTexts texts = ReadSet(SAMPLE);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 2); // the newest, which the files have first
    int compared = 0;
    for (int i = 0; i < record.table.frequencyCount; ++i)
    {
        assert_true(fabs((double)record.energy[i] - GetPrinted(texts.energy, i)) < 1e-6);
        if (record.energy[i] > 0.0f)
        {
            assert_true(GetAngleBetween(GetBearing(record.meanDirection[i]), GetPrinted(texts.alpha1, i)) < 1e-3);
            double across = GetAngleBetween(GetBearing(record.direction2[i]), GetPrinted(texts.alpha2, i));
            assert_true(across < 1e-3 || fabs(across - 180.0) < 1e-3); // an axis has two ends
            assert_true(fabs((double)record.r1[i] - GetPrinted(texts.r1, i)) < 1e-6);
            assert_true(fabs((double)record.r2[i] - GetPrinted(texts.r2, i)) < 1e-6);
            ++compared;
        }
    }
    assert_true(compared > 40);
    FreeSet(&texts);
    swDestroyMeasuredSea(sea);
}

// Moments of one bin, by a sum over the density that the sea is made of.
static void SumBin(const swCompiledSpectrum* spectrum, double low, double high, double sums[5])
{
    enum
    {
        PARTS = 16,
        DIRECTIONS = 720
    };
    for (int i = 0; i < PARTS * DIRECTIONS; ++i)
    {
        double f = low + (high - low) * (i / DIRECTIONS + 0.5) / PARTS;
        double angle = 2.0 * SW_PI * (i % DIRECTIONS) / DIRECTIONS;
        double density = swGetCompiledDensity2(spectrum, 2.0 * SW_PI * f, angle);
        sums[0] += density;
        sums[1] += density * cos(angle);
        sums[2] += density * sin(angle);
        sums[3] += density * cos(2.0 * angle);
        sums[4] += density * sin(2.0 * angle);
    }
}

static void TablesHaveTheMomentsOfTheRecord(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swNdbcTexts texts = ReadSet(SAMPLE);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
    FreeSet(&texts);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 2);
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record.table;
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    double edges[1025], worst = 0.0;
    swSpectrumTable_GetEdges(&record.table, edges);
    for (int i = 0; i < record.table.frequencyCount; ++i)
    {
        if (record.energy[i] <= 0.0f)
        {
            continue;
        }
        double sums[5] = {0};
        SumBin(spectrum, edges[i], edges[i + 1], sums);
        double mean = (double)record.meanDirection[i];
        double second = 2.0 * (double)record.direction2[i];
        double r1 = (double)record.r1[i], r2 = (double)record.r2[i];
        worst = fmax(worst, hypot(sums[1] / sums[0] - r1 * cos(mean), sums[2] / sums[0] - r1 * sin(mean)));
        worst = fmax(worst, hypot(sums[3] / sums[0] - r2 * cos(second), sums[4] / sums[0] - r2 * sin(second)));
    }
    print_message("worst moment error: %.2e\n", worst);
    assert_true(worst < 2e-3);
    swFreeCompiledSpectrum(&host, spectrum);
    swDestroyMeasuredSea(sea);
}

// A field of a line of comma-separated values.
static double GetField(const char* line, int index)
{
    for (; index > 0 && line != NULL; --index)
    {
        line = strchr(line, ',');
        line = line != NULL ? line + 1 : NULL;
    }
    return line != NULL ? atof(line) : -1.0;
}

// Columns of expected.csv: height, peak period, Tm02, direction at the peak, mean direction.
static void CompareSet(const char* name, const char* stem, const int columns[5])
{
    char path[512];
    snprintf(path, sizeof(path), BUOYS "/%s/expected.csv", name);
    size_t size = 0;
    char* expected = ReadTextFile(path, &size);
    if (expected == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        skip();
    }
    swHost host = MakeHost();
    snprintf(path, sizeof(path), BUOYS "/%s/%s", name, stem);
    swNdbcTexts texts = ReadSet(path);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
    FreeSet(&texts);

    int compared = 0;
    int corrected = 0;
    double worst[5] = {0};
    for (char* line = strtok(expected, "\n"); line != NULL; line = strtok(NULL, "\n"))
    {
        int date[5];
        if (sscanf(line, "%d %d %d %d %d", &date[0], &date[1], &date[2], &date[3], &date[4]) != 5)
        {
            continue;
        }
        char time[64];
        snprintf(time, sizeof(time), "%04d-%02d-%02d %02d:%02d", date[0], date[1], date[2], date[3], date[4]);
        int index = swMeasuredSea_FindTime(sea, time);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
        assert_string_equal(record.time, time);
        corrected += record.correctedCount;
        swSeaState seaState = GetSeaState(sea, index, true);
        const double errors[5] = {
            fabs((double)seaState.significantHeight - GetField(line, columns[0])),
            fabs((double)seaState.peakPeriod - GetField(line, columns[1])) / GetField(line, columns[1]),
            fabs((double)seaState.periodTm02 - GetField(line, columns[2])) / GetField(line, columns[2]),
            GetAngleBetween(GetBearing(seaState.peakDirection), GetField(line, columns[3])),
            GetAngleBetween(GetBearing(seaState.meanDirection), GetField(line, columns[4])),
        };
        for (int i = 0; i < 5; ++i)
        {
            worst[i] = fmax(worst[i], errors[i]);
        }
        ++compared;
    }
    print_message("%s: %d records, worst: Hs %.3f m, Tp %.2f %%, Tm02 %.2f %%, direction at the peak %.2f, mean %.2f "
                  "degrees; %d impossible moments\n",
                  name, compared, worst[0], 100.0 * worst[1], 100.0 * worst[2], worst[3], worst[4], corrected);
    assert_true(compared > 100);
    // The expected values take printed frequencies and half-way bands, where we take the buoy's true ones.
    assert_true(worst[0] < 0.05);
    assert_true(worst[1] < 0.03); // half a bin
    assert_true(worst[2] < 0.02);
    assert_true(worst[3] < 2.0);
    assert_true(worst[4] < 2.0);
    free(expected);
    swDestroyMeasuredSea(sea);
}

static void BostonBuoyIsReadAsExpected(void** state)
{
    (void)state;
    CompareSet("ndbc_44013_2022-05", "44013", (const int[5]){13, 14, 15, 17, 18});
}

static void CanaveralBuoyIsReadAsExpected(void** state)
{
    (void)state;
    CompareSet("ndbc_41010_2020-06", "41010", (const int[5]){9, 10, 11, 12, 13});
}

static void OldArchiveOfABuoyIsRead(void** state)
{
    (void)state;
    size_t size = 0;
    char* text = ReadTextFile(BUOYS "/ndbc_44004_2000_old_format/44004w2000.txt", &size);
    if (text == NULL)
    {
        print_message("skipped: " BUOYS "/ndbc_44004_2000_old_format is absent\n");
        skip();
    }
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseStrings(&host, text, NULL, NULL, &sea), SW_SUCCESS);
    free(text);
    assert_int_equal(swMeasuredSea_GetCount(sea), 3);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 1);
    assert_string_equal(record.time, "2000-01-01 01:00");
    assert_int_equal(record.table.frequencyCount, 38);
    assert_true(fabsf(record.table.bandwidths[5] - 0.01f) < 1e-6f);
    assert_true(fabsf(record.energy[17] - 2.37f) < 1e-6f);
    assert_null(record.meanDirection);
    swDestroyMeasuredSea(sea);
}

static void ArchivesAreRead(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    // With minutes, CRLF, comments, trailing spaces, r1 times 100; the second file has other records and frequencies.
    assert_int_equal(
        ParseStrings(&host,
                     "#YY  MM DD hh mm .0325 .0375 .0425\r\n# a comment\r\n"
                     "2021 01 02 00 40 1.00 2.00 3.00  \r\n\r\n2021 01 01 00 40 4.00 999.00 6.00\r\n",
                     "#YY  MM DD hh mm .0375 .0425\n2021 01 02 00 40 90.0 180.0\n2021 01 03 00 40 1.0 2.0\n",
                     "#YY  MM DD hh mm .0375 .0425\n2021 01 02 00 40 85.0 40.0\n", &sea),
        SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    swMeasuredRecord first = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(first.time, "2021-01-01 00:40");
    assert_null(first.meanDirection);
    assert_true(first.energy[0] == 4.0f && first.energy[1] == 0.0f && first.energy[2] == 6.0f);
    swMeasuredRecord second = swMeasuredSea_GetRecord(sea, 1);
    assert_non_null(second.meanDirection);
    assert_true(fabsf(second.r1[1] - 0.85f) < 1e-6f && fabsf(second.r1[2] - 0.40f) < 1e-6f);
    assert_true(GetAngleBetween(GetBearing(second.meanDirection[1]), 90.0) < 1e-4);
    assert_true(GetAngleBetween(GetBearing(second.meanDirection[2]), 180.0) < 1e-4);
    assert_true(GetAngleBetween(GetBearing(second.meanDirection[0]), 90.0) < 1e-4); // its neighbour's
    swDestroyMeasuredSea(sea);

    // Two-digit years without minutes.
    assert_int_equal(ParseStrings(&host, "YY MM DD hh .03 .04\n98 12 31 23 1.0 2.0\n", NULL, NULL, &sea), SW_SUCCESS);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "1998-12-31 23:00");
    swDestroyMeasuredSea(sea);
}

static void WavesFromNorthGoSouth(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseStrings(&host, "2022 05 12 23 50 0.2 1.0 (0.1) 1.0 (0.2)\n",
                                  "2022 05 12 23 50 0.0 (0.1) 270.0 (0.2)\n", NULL, &sea),
                     SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(fabs(cos((double)record.meanDirection[0])) < 1e-6 && sin((double)record.meanDirection[0]) > 0.99); // +z
    assert_true(cos((double)record.meanDirection[1]) > 0.99);                                                      // +x
    assert_true(fabsf(record.r1[0] - 8.0f / 9.0f) < 1e-6f);
    swDestroyMeasuredSea(sea);
}

static void ImpossibleMomentsAreCounted(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseStrings(&host, "2022 05 12 23 50 0.2 1.0 (0.1) 1.0 (0.2)\n",
                                  "2022 05 12 23 50 10.0 (0.1) 20.0 (0.2)\n", "2022 05 12 23 50 1.30 (0.1) 0.5 (0.2)\n",
                                  &sea),
                     SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).correctedCount, 1);
    assert_true(swMeasuredSea_GetRecord(sea, 0).r1[0] < 1.0f);
    swDestroyMeasuredSea(sea);
}

static void SecondRecordOfATimeIsIgnoredWithAWarning(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(
        ParseStrings(&host, "2022 05 12 23 50 0.2 1.0 (0.1) 1.0 (0.2)\n2022 05 12 23 50 0.2 2.0 (0.1) 1.0 (0.2)\n",
                     NULL, NULL, &sea),
        SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetCount(sea), 1);
    assert_true(swMeasuredSea_GetRecord(sea, 0).energy[0] == 1.0f);
    assert_non_null(strstr(s_messages, "e.txt:2: a second record of 2022-05-12 23:50"));
    swDestroyMeasuredSea(sea);
}

static void WrongTextsAreNamedWithTheirLine(void** state)
{
    (void)state;
    static const struct
    {
        const char *energy, *alpha1, *words;
    } cases[] = {
        {"", NULL, "e.txt:1: the file ends without a record"},
        {"# only a comment\n", NULL, "e.txt:1: the file ends without a record"},
        {"hello world\n", NULL, "e.txt:1: no frequencies"},
        {"YYYY MM DD hh .1 .2\n2021 01 01 00 1.0\n", NULL, "e.txt:2: the line has 1 values for the heading's 2"},
        {"YYYY MM DD hh .1 .2\n2021 01 01 00 1.0 2.0 3.0\n", NULL, "e.txt:2: the line has 3 values"},
        {"YYYY MM DD hh .1 .2\n2021 13 01 00 1.0 2.0\n", NULL, "e.txt:2: the month is '13'"},
        {"YYYY MM DD hh .1 .2\n2021 02 29 00 1.0 2.0\n", NULL, "e.txt:2: the day is '29'"},
        {"YYYY MM DD hh .1 .2\n2021 02 28 24 1.0 2.0\n", NULL, "e.txt:2: the hour is '24'"},
        {"YYYY MM DD hh .1 .2\n1021 02 28 22 1.0 2.0\n", NULL, "e.txt:2: the year is 1021"},
        {"YYYY MM DD hh .1 .2\n2021 02 28 22 1.0 two\n", NULL, "e.txt:2: 'two' is not a number"},
        {"YYYY MM DD hh .1 .2\n2021 02 28 22 1.0 -2\n", NULL, "e.txt:2: the value is -2"},
        {"YYYY MM DD hh .1 .2\n2021 02 28 22 1.0 1e99999\n", NULL, "e.txt:2: '1e99999' is not a number"},
        {"YYYY MM DD hh .2 .1\n", NULL, "e.txt:1: the frequency 0.1 Hz follows 0.2 Hz"},
        {"YYYY MM DD hh .2\n", NULL, "e.txt:1: the heading names fewer than 2"},
        {"2021 02 28 22 10 0.2 1.0 (0.1) 2.0 (0.2\n", NULL, "e.txt:1: the value '2.0' is not followed by"},
        {"2021 02 28 22 10 0.2 1.0 (0.1)\n", NULL, "e.txt:1: the line has fewer than 2"},
        {"2021 02 28 22 10 0.2 MM (0.1) 999.0 (0.2)\n", NULL, "e.txt:1: every energy in the file is missing"},
        {"2021 02 28 22 10 0.2 1 (0.1) 1 (0.2)\n", "\n2021 02 28 22 10 400 (0.1) 1 (0.2)\n",
         "a.txt:2: the value is 400; it must be from 0 to 360"},
    };
    swHost host = MakeHost();
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        s_messages[0] = '\0';
        assert_int_equal(ParseStrings(&host, cases[i].energy, cases[i].alpha1, NULL, &sea), SW_ERROR_FORMAT);
        assert_null(sea);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
}

static void TooMuchIsRefusedByName(void** state)
{
    (void)state;
    swHost host = MakeHost();
    char* text = malloc(64 + 1100 * 12);
    size_t used = (size_t)sprintf(text, "YYYY MM DD hh");
    for (int i = 0; i < 1100; ++i)
    {
        used += (size_t)sprintf(text + used, " %.4f", 0.001 * (i + 1));
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseStrings(&host, text, NULL, NULL, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "more than 1024 frequencies"));
    free(text);
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    swNdbcTexts texts = ReadSet(SAMPLE);
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
    swDestroyMeasuredSea(sea);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    long long allocations = atomic_load(&memory.allocations);
    for (long long i = 0; i < allocations; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        sea = NULL;
        assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_ERROR_NO_MEMORY);
        assert_null(sea);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    print_message("%lld allocations, each failed once\n", allocations);
    assert_int_equal(atomic_load(&memory.messages), allocations);
    FreeSet(&texts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SampleStormGrows),
        cmocka_unit_test(RecordsHoldThePrintedMoments),
        cmocka_unit_test(TablesHaveTheMomentsOfTheRecord),
        cmocka_unit_test(BostonBuoyIsReadAsExpected),
        cmocka_unit_test(CanaveralBuoyIsReadAsExpected),
        cmocka_unit_test(OldArchiveOfABuoyIsRead),
        cmocka_unit_test(ArchivesAreRead),
        cmocka_unit_test(WavesFromNorthGoSouth),
        cmocka_unit_test(ImpossibleMomentsAreCounted),
        cmocka_unit_test(SecondRecordOfATimeIsIgnoredWithAWarning),
        cmocka_unit_test(WrongTextsAreNamedWithTheirLine),
        cmocka_unit_test(TooMuchIsRefusedByName),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
