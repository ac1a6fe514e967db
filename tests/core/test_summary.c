// SPDX-License-Identifier: MIT
// Summaries of buoys become seas with the heights, periods and directions that they print: lines of our own, the buoys'
// own files where they lie beside the sources, and every way for a line to be wrong.

#include "support/cmocka_setup.h"
#include "support/text_file.h"
#include "support/sea_states.h"
#include "support/messages.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define BUOYS SW_SOURCE_DIR "/../shared/data/spectra"

#define HEADING "#YY  MM DD hh mm WVHT  SwH  SwP  WWH  WWP SwD WWD  STEEPNESS  APD MWD\n"
#define UNITS "#yr  mo dy hr mn    m    m  sec    m  sec  -  degT     -      sec degT\n"

static swResult ParseText(const char* text, swMeasuredSea** sea)
{
    swHost host = MakeHost();
    return swParseNdbcSummary(&host, text, strlen(text), "s.spec", sea);
}

static swMeasuredSea* MakeSea(const char* text)
{
    swMeasuredSea* sea = NULL;
    swResult result = ParseText(text, &sea);
    if (result != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return sea;
}

static swSeaState GetBandState(const swMeasuredRecord* record, float minFrequency, float maxFrequency)
{
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record->table;
    def.extendTail = false;
    swSeaState seaState;
    assert_int_equal(swSpectrum_GetSeaState(&def, minFrequency, maxFrequency, &seaState), SW_SUCCESS);
    return seaState;
}

static bool IsNear(double value, double expected, double tolerance)
{
    if (fabs(value - expected) > tolerance)
    {
        print_message("%.9g is not %.9g within %g\n", value, expected, tolerance);
        return false;
    }
    return true;
}

// ---- one line ----

static void SwellAndWindSeaStandApart(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING UNITS "2022 05 10 10 40  5.0  4.0 16.0  3.0  5.0   W  NE  STEEP  6.0  265\n");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(record.time, "2022-05-10 10:40");
    assert_int_equal(record.partitionCount, 2);
    assert_int_equal(record.correctedCount, 0);

    swSeaState whole = GetBandState(&record, 0.0f, 0.0f);
    assert_true(IsNear((double)whole.significantHeight, 5.0, 1e-4));
    assert_true(IsNear((double)whole.peakPeriod, 16.0, 1e-4));
    swSeaState swell = GetBandState(&record, 0.001f, 0.12f);
    assert_true(IsNear((double)swell.significantHeight, 4.0, 0.15));            // some of it lies above
    assert_true(GetAngleBetween(GetBearing(swell.peakDirection), 265.0) < 0.5); // the mean direction, not W
    swSeaState wind = GetBandState(&record, 0.16f, 0.5f);
    assert_true(IsNear((double)wind.peakPeriod, 5.0, 1e-4));
    assert_true(IsNear((double)wind.significantHeight, 3.0, 0.15));
    assert_true(GetAngleBetween(GetBearing(wind.peakDirection), 45.0) < 3.0); // some swell is left there
    swDestroyMeasuredSea(sea);
}

static void HeightIsThatOfTheWholeSea(void** state)
{
    (void)state;
    // The parts are rounded: 0.3 and 0.3 are 0.42.
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40  0.5  0.3 8.0  0.3  4.0   W  W  STEEP  MM  MM\n"
                                         "2022 05 10 11 40   MM  3.0 8.0  4.0  4.0   W  W  STEEP  MM  MM\n");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(IsNear((double)GetBandState(&record, 0.0f, 0.0f).significantHeight, 0.5, 1e-5));
    record = swMeasuredSea_GetRecord(sea, 1);
    assert_true(IsNear((double)GetBandState(&record, 0.0f, 0.0f).significantHeight, 5.0, 1e-4)); // from the parts
    swDestroyMeasuredSea(sea);
}

static void EveryPointOfTheCompassIsUnderstood(void** state)
{
    (void)state;
    static const char* const points[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                         "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
    for (int i = 0; i < 16; ++i)
    {
        char text[256];
        snprintf(text, sizeof(text), HEADING "2022 05 10 10 40 1.0 1.0 9.1 0.0 MM %s MM SWELL 6.0 MM\n", points[i]);
        swMeasuredSea* sea = MakeSea(text);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        assert_int_equal(record.partitionCount, 1);
        swSeaState seaState = GetBandState(&record, 0.0f, 0.0f);
        assert_true(GetAngleBetween(GetBearing(seaState.meanDirection), 22.5 * i) < 1e-3);
        assert_true(GetAngleBetween(GetBearing(record.meanDirection[20]), 22.5 * i) < 1e-3);
        swDestroyMeasuredSea(sea);
    }
    // Degrees do too.
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40 1.0 1.0 9.1 0.0 MM 123 MM SWELL 6.0 MM\n");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(GetAngleBetween(GetBearing(GetBandState(&record, 0.0f, 0.0f).meanDirection), 123.0) < 1e-3);
    swDestroyMeasuredSea(sea);
}

static void MeanDirectionRefinesOnlyThePointItAgreesWith(void** state)
{
    (void)state;
    static const struct
    {
        const char* line;
        double bearing;
    } cases[] = {
        {"2022 05 10 10 40 1.0 1.0 9.1 0.0 MM NNW MM SWELL 6.0 349\n", 349.0},
        {"2022 05 10 10 40 1.0 1.0 9.1 0.0 MM N MM SWELL 6.0 350\n", 350.0},
        {"2022 05 10 10 40 1.0 1.0 9.1 0.0 MM N MM SWELL 6.0 20\n", 0.0},
        {"2022 05 10 10 40 1.0 1.0 9.1 0.0 MM MM MM SWELL 6.0 20\n", 20.0},
        {"2022 05 10 10 40 1.0 0.0 MM 1.0 4.0 MM SE STEEP 3.3 130\n", 130.0},
        {"2022 05 10 10 40 1.4 1.0 9.1 1.0 4.0 MM SE STEEP 3.3 MM\n", 135.0}, // the other part's
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        char text[256];
        snprintf(text, sizeof(text), HEADING "%s", cases[i].line);
        swMeasuredSea* sea = MakeSea(text);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        double bearing = GetBearing(GetBandState(&record, 0.0f, 0.0f).peakDirection);
        assert_true(IsNear(GetAngleBetween(bearing, cases[i].bearing), 0.0, 1e-3));
        swDestroyMeasuredSea(sea);
    }
}

static void MomentsAreThoseOfTheTable(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40 2.0 1.4 9.0 1.4 6.0 W NE AVERAGE 5.0 275\n");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    double worst = 0.0;
    for (int i = 0; i < record.table.frequencyCount; ++i)
    {
        const float* density = record.table.density + i * record.table.directionCount;
        double sums[5] = {0};
        for (int j = 0; j < record.table.directionCount; ++j)
        {
            double angle = 2.0 * SW_PI * j / record.table.directionCount;
            double share = (double)density[j] * 2.0 * SW_PI / record.table.directionCount;
            sums[0] += share;
            sums[1] += share * cos(angle);
            sums[2] += share * sin(angle);
            sums[3] += share * cos(2.0 * angle);
            sums[4] += share * sin(2.0 * angle);
        }
        double energy = (double)record.energy[i];
        double mean = (double)record.meanDirection[i];
        double second = 2.0 * (double)record.direction2[i];
        worst = fmax(worst, fabs(sums[0] / energy - 1.0));
        worst = fmax(worst, hypot(sums[1] / energy - (double)record.r1[i] * cos(mean),
                                  sums[2] / energy - (double)record.r1[i] * sin(mean)));
        worst = fmax(worst, hypot(sums[3] / energy - (double)record.r2[i] * cos(second),
                                  sums[4] / energy - (double)record.r2[i] * sin(second)));
    }
    print_message("worst moment error: %.2e\n", worst);
    assert_true(worst < 1e-4); // the sampled directions
    swDestroyMeasuredSea(sea);
}

static int FindFrequency(const swMeasuredRecord* record, float frequency)
{
    int best = 0;
    for (int i = 1; i < record->table.frequencyCount; ++i)
    {
        float distance = fabsf(record->table.frequencies[i] - frequency);
        best = distance < fabsf(record->table.frequencies[best] - frequency) ? i : best;
    }
    return best;
}

static void SwellIsNarrowerThanWindSea(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL MM 270\n"
                                         "2022 05 10 11 40 1.0 0.0 MM 1.0 8.0 MM W STEEP MM 270\n");
    swMeasuredRecord swell = swMeasuredSea_GetRecord(sea, 0);
    swMeasuredRecord wind = swMeasuredSea_GetRecord(sea, 1);
    assert_true(IsNear((double)swell.r1[FindFrequency(&swell, 0.125f)], 25.0 / 26.0, 1e-4));
    assert_true(IsNear((double)wind.r1[FindFrequency(&wind, 0.125f)], 10.0 / 11.0, 1e-4));
    assert_true(swell.r1[FindFrequency(&swell, 0.25f)] < 25.0f / 26.0f);
    assert_true(GetBandState(&swell, 0.0f, 0.0f).periodTm02 > GetBandState(&wind, 0.0f, 0.0f).periodTm02);
    swDestroyMeasuredSea(sea);
}

static void PeaksThatTouchStillMakeATable(void** state)
{
    (void)state;
    static const double periods[][2] = {{10.0, 10.0}, {10.0, 9.9}, {9.9, 10.0}, {10.0, 9.6},
                                        {4.0, 20.0},  {40.0, 1.0}, {1.0, 1.0},  {40.0, 40.0}};
    for (size_t i = 0; i < sizeof(periods) / sizeof(periods[0]); ++i)
    {
        char text[256];
        snprintf(text, sizeof(text), HEADING "2022 05 10 10 40 2.8 2.0 %.1f 2.0 %.1f W W STEEP MM MM\n", periods[i][0],
                 periods[i][1]);
        swMeasuredSea* sea = MakeSea(text);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        for (int j = 1; j < record.table.frequencyCount; ++j)
        {
            assert_true(record.table.frequencies[j] > record.table.frequencies[j - 1]);
            assert_true(record.table.bandwidths[j] > 0.0f && record.energy[j] >= 0.0f);
        }
        assert_true(IsNear((double)GetBandState(&record, 0.0f, 0.0f).significantHeight, 2.8, 1e-4));
        swDestroyMeasuredSea(sea);
    }
}

// ---- lines that do not tell swell from wind sea ----

static void MeteorologicalFilesGiveOneSystem(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea("YYYY MM DD hh WD WSPD GST WVHT DPD APD MWD BAR\n"
                                 "1999 01 01 00 120 5.0 6.0 2.50 9.09 6.10 45 1012.0\n"
                                 "1999 01 01 01 120 5.0 6.0 99.00 99.00 99.00 999 1012.0\n"
                                 "1999 01 01 02 120 5.0 6.0 1.50 99.00 5.20 999 1012.0\n");
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    assert_string_equal(s_messages, "");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(record.time, "1999-01-01 00:00");
    assert_int_equal(record.partitionCount, 1);
    swSeaState seaState = GetBandState(&record, 0.0f, 0.0f);
    assert_true(IsNear((double)seaState.significantHeight, 2.5, 1e-4));
    assert_true(IsNear((double)seaState.peakPeriod, 9.09, 1e-3));
    assert_true(IsNear(GetBearing(seaState.meanDirection), 45.0, 1e-3));
    record = swMeasuredSea_GetRecord(sea, 1);
    assert_null(record.meanDirection); // spread around east
    assert_true(IsNear((double)GetBandState(&record, 0.0f, 0.0f).meanDirection, 0.0, 1e-4));
    swDestroyMeasuredSea(sea);
}

static void AveragePeriodIsThatOfTheTable(void** state)
{
    (void)state;
    double worst = 0.0;
    for (double period = 2.5; period < 15.0; period += 0.5)
    {
        char text[256];
        // A swell without its period cannot be placed.
        snprintf(text, sizeof(text), HEADING "2022 05 10 10 40 2.0 1.0 MM 1.7 5.0 W W N/A %.1f 180\n", period);
        swMeasuredSea* sea = MakeSea(text);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        assert_int_equal(record.partitionCount, 1);
        double sums[2] = {0};
        for (int i = 0; i < record.table.frequencyCount; ++i)
        {
            double variance = (double)record.energy[i] * (double)record.table.bandwidths[i];
            double frequency = (double)record.table.frequencies[i];
            sums[0] += variance;
            sums[1] += variance * frequency * frequency;
        }
        worst = fmax(worst, fabs(sqrt(sums[0] / sums[1]) / period - 1.0));
        swDestroyMeasuredSea(sea);
    }
    print_message("worst average period: %.2e\n", worst);
    assert_true(worst < 1e-3);
}

// ---- height, peak and average period at once ----

// Any average period from two thirds of the dominant one down to nine tenths above it: a shape has all three.
static void OneSystemHasHeightPeakAndAveragePeriod(void** state)
{
    (void)state;
    double worst = 0.0, worstPeak = 0.0, worstHeight = 0.0;
    int count = 0;
    for (double dominant = 4.0; dominant < 16.0; dominant += 0.7)
    {
        for (double ratio = 0.9; ratio < 1.95; ratio += 0.05)
        {
            char text[256];
            double average = floor(10.0 * dominant / ratio + 0.5) / 10.0;
            if (average < 3.8) // the buoy ends at 0.485 Hz
            {
                continue;
            }
            snprintf(text, sizeof(text), "#YY MM DD hh mm WVHT DPD APD MWD\n2022 05 10 10 40 1.7 %.1f %.1f 180\n",
                     dominant, average);
            swMeasuredSea* sea = MakeSea(text);
            swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
            swSeaState seaState = GetBandState(&record, 0.0f, 0.0f);
            double error = fabs((double)seaState.periodTm02 / average - 1.0);
            if (error > 0.02)
            {
                print_message("DPD %.1f s, APD %.1f s: Tm02 %.2f s\n", dominant, average, (double)seaState.periodTm02);
            }
            worst = fmax(worst, error);
            worstPeak =
                fmax(worstPeak, fabs((double)seaState.peakPeriod / (floor(10.0 * dominant + 0.5) / 10.0) - 1.0));
            worstHeight = fmax(worstHeight, fabs((double)seaState.significantHeight / 1.7 - 1.0));
            assert_true(IsNear((double)record.averagePeriod, average, 1e-5));
            assert_true(record.gamma >= 0.999f && record.gamma <= 20.01f);
            assert_true(record.tailExponent >= 1.49f && record.tailExponent <= 5.0f);
            assert_true((error > 0.01) == (s_messages[0] != '\0'));
            ++count;
            swDestroyMeasuredSea(sea);
        }
    }
    print_message("%d pairs of periods, worst: Tm02 %.2f %%, Tp %.2f %%, Hs %.3f %%\n", count, 100.0 * worst,
                  100.0 * worstPeak, 100.0 * worstHeight);
    assert_true(count > 200 && worst < 0.02 && worstPeak < 0.01 && worstHeight < 1e-3);
}

static void SwellAndWindSeaHaveTheAveragePeriod(void** state)
{
    (void)state;
    static const double averages[] = {4.6, 4.9, 5.2, 5.5, 5.8, 6.1, 6.4};
    for (size_t i = 0; i < sizeof(averages) / sizeof(averages[0]); ++i)
    {
        char text[256];
        snprintf(text, sizeof(text), HEADING "2022 05 10 10 40 2.4 1.5 10.0 1.9 6.2 W S STEEP %.1f 270\n", averages[i]);
        swMeasuredSea* sea = MakeSea(text);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        swSeaState seaState = GetBandState(&record, 0.0f, 0.0f);
        assert_true(IsNear((double)seaState.periodTm02, averages[i], 0.02 * averages[i]));
        assert_true(IsNear((double)seaState.significantHeight, 2.4, 1e-4));
        double peak = (double)seaState.peakPeriod;
        assert_true(fabs(peak / 10.0 - 1.0) < 0.03 || fabs(peak / 6.2 - 1.0) < 0.03);
        swDestroyMeasuredSea(sea);
    }
}

static void AveragePeriodsThatNoShapeHasAreTold(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea("#YY MM DD hh mm WVHT DPD APD MWD\n2022 05 10 10 40 1.7 8.0 6.0 180\n"
                                 "2022 05 10 11 40 1.7 4.0 9.0 180\n2022 05 10 12 40 1.7 12.0 2.5 180\n");
    assert_int_equal(swMeasuredSea_GetCount(sea), 3);
    assert_non_null(strstr(s_messages, "s.spec:3: 2 of 3 records have an average period (APD) that no shape"));
    for (int i = 0; i < 3; ++i)
    {
        static const double peaks[] = {8.0, 4.0, 12.0};
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        swSeaState seaState = GetBandState(&record, 0.0f, 0.0f);
        assert_true(IsNear((double)seaState.peakPeriod, peaks[i], 0.01 * peaks[i]));
        assert_true(IsNear((double)seaState.significantHeight, 1.7, 1e-4));
    }
    swDestroyMeasuredSea(sea);
}

// Every line that a buoy printed, but those of flat water whose heights have one digit.
static void CompareAveragePeriods(const char* path, int feasiblePercent)
{
    char* text = ReadTextFile(path, &(size_t){0});
    if (text == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        return;
    }
    swMeasuredSea* sea = MakeSea(text);
    int count = 0, near = 0;
    double worst = 0.0, sum = 0.0;
    for (int i = 0; i < swMeasuredSea_GetCount(sea); ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        if (record.averagePeriod > 0.0f)
        {
            double period = (double)GetBandState(&record, 0.0f, 0.0f).periodTm02;
            double error = fabs(period / (double)record.averagePeriod - 1.0);
            ++count;
            sum += error;
            near += error < 0.02 ? 1 : 0;
            worst = fmax(worst, error);
        }
    }
    print_message("%s: Tm02 is APD within 2 %% in %d of %d records, %.2f %% apart on average, %.1f %% at worst\n", path,
                  near, count, 100.0 * sum / count, 100.0 * worst);
    assert_true(count > 100 && 100 * near >= feasiblePercent * count);
    free(text);
    swDestroyMeasuredSea(sea);
}

static void BuoysAveragePeriodsAreKept(void** state)
{
    (void)state;
    CompareAveragePeriods(BUOYS "/ndbc_44013_2022-05/44013.txt", 98);
    CompareAveragePeriods(BUOYS "/ndbc_44013_2022-05/44013.spec", 96);
    CompareAveragePeriods(BUOYS "/ndbc_41010_2020-06/41010.spec", 98);
}

static void CalmHasNoEnergy(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40 0.0 0.0 MM 0.0 MM MM MM N/A MM MM\n"
                                         "2022 05 10 11 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n");
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    assert_int_equal(swMeasuredSea_FindLargest(sea), 1);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_int_equal(record.partitionCount, 0);
    for (int i = 0; i < record.table.frequencyCount; ++i)
    {
        assert_true(record.energy[i] == 0.0f && record.table.frequencies[i] > 0.0f);
    }
    swDestroyMeasuredSea(sea);
}

static void RecordsComeInOrderOfTime(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 11 40 2.0 2.0 8.0 0.0 MM W MM SWELL 6.0 270\n"
                                         "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n"
                                         "2022 05 10 11 40 3.0 3.0 8.0 0.0 MM W MM SWELL 6.0 270\n");
    assert_int_equal(swMeasuredSea_GetCount(sea), 2);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2022-05-10 10:40");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 1);
    assert_true(IsNear((double)GetBandState(&record, 0.0f, 0.0f).significantHeight, 2.0, 1e-4));
    assert_non_null(strstr(s_messages, "s.spec:4: a second record of 2022-05-10 11:40"));
    swDestroyMeasuredSea(sea);
}

// ---- the buoys ----

typedef struct Printed
{
    char time[20];
    double height, swellHeight, swellPeriod, windHeight, windPeriod;
    char swellPoint[8], windPoint[8];
    double averagePeriod, meanDirection;
} Printed;

static double GetNumber(const char* text)
{
    return strcmp(text, "MM") == 0 ? -1.0 : atof(text);
}

static bool ReadLine(const char* line, Printed* printed)
{
    char fields[8][16];
    int date[5];
    if (sscanf(line, "%d %d %d %d %d %15s %15s %15s %15s %15s %7s %7s %*s %15s %15s", &date[0], &date[1], &date[2],
               &date[3], &date[4], fields[0], fields[1], fields[2], fields[3], fields[4], printed->swellPoint,
               printed->windPoint, fields[5], fields[6]) != 14)
    {
        return false;
    }
    char time[64];
    snprintf(time, sizeof(time), "%04d-%02d-%02d %02d:%02d", date[0], date[1], date[2], date[3], date[4]);
    memcpy(printed->time, time, 17);
    printed->height = GetNumber(fields[0]);
    printed->swellHeight = GetNumber(fields[1]);
    printed->swellPeriod = GetNumber(fields[2]);
    printed->windHeight = GetNumber(fields[3]);
    printed->windPeriod = GetNumber(fields[4]);
    printed->averagePeriod = GetNumber(fields[5]);
    printed->meanDirection = GetNumber(fields[6]);
    return true;
}

static double GetPointDegrees(const char* point)
{
    static const char* const points[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                         "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
    for (int i = 0; i < 16; ++i)
    {
        if (strcmp(points[i], point) == 0)
        {
            return 22.5 * i;
        }
    }
    return -1.0;
}

static swMeasuredSea* ReadSpectra(const char* stem)
{
    static const char* const endings[] = {"data_spec", "swdir", "swdir2", "swr1", "swr2"};
    char* texts[5];
    for (int i = 0; i < 5; ++i)
    {
        char path[512];
        snprintf(path, sizeof(path), "%s.%s", stem, endings[i]);
        texts[i] = ReadTextFile(path, &(size_t){0});
        assert_non_null(texts[i]);
    }
    swNdbcTexts set = {.energy = texts[0],
                       .alpha1 = texts[1],
                       .alpha2 = texts[2],
                       .r1 = texts[3],
                       .r2 = texts[4],
                       .energySize = strlen(texts[0]),
                       .alpha1Size = strlen(texts[1]),
                       .alpha2Size = strlen(texts[2]),
                       .r1Size = strlen(texts[3]),
                       .r2Size = strlen(texts[4])};
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &set, &sea), SW_SUCCESS);
    for (int i = 0; i < 5; ++i)
    {
        free(texts[i]);
    }
    return sea;
}

// What is summed up over the records of a buoy.
typedef struct Comparison
{
    int count, peaksFound;
    double worstHeight, worstPeak, worstPeakDirection;          // against the printed numbers
    double periodBias, periodError, directionError, spreadBias; // against the spectra of the same buoy
} Comparison;

// Against the line itself: height exactly, the peak one of the two, its direction the printed one but for the other
// part.
static void CompareWithLine(const swMeasuredRecord* record, const Printed* printed, Comparison* sums)
{
    swSeaState seaState = GetBandState(record, 0.0f, 0.0f);
    sums->worstHeight = fmax(sums->worstHeight, fabs((double)seaState.significantHeight - printed->height));
    double peak = (double)seaState.peakPeriod;
    bool isSwell = fabs(peak - printed->swellPeriod) < fabs(peak - printed->windPeriod);
    double period = isSwell ? printed->swellPeriod : printed->windPeriod;
    double point = GetPointDegrees(isSwell ? printed->swellPoint : printed->windPoint);
    sums->worstPeak = fmax(sums->worstPeak, fabs(peak / period - 1.0));
    sums->worstPeakDirection =
        fmax(sums->worstPeakDirection, GetAngleBetween(GetBearing(seaState.peakDirection), point));
}

static void CompareWithSpectrum(const swMeasuredRecord* record, const swMeasuredRecord* spectrum, Comparison* sums)
{
    swSeaState ours = GetBandState(record, 0.0f, 0.0f);
    swSeaState theirs = GetBandState(spectrum, 0.0f, 0.0f);
    double period = (double)ours.periodTm02 / (double)theirs.periodTm02 - 1.0;
    sums->periodBias += period;
    sums->periodError += fabs(period);
    sums->directionError += GetAngleBetween(GetBearing(ours.meanDirection), GetBearing(theirs.meanDirection));
    sums->spreadBias += ((double)ours.spread - (double)theirs.spread) * 180.0 / SW_PI;
    sums->peaksFound += fabs((double)ours.peakPeriod / (double)theirs.peakPeriod - 1.0) < 0.03 ? 1 : 0;
}

static void CompareBuoy(const char* stem)
{
    char path[512];
    snprintf(path, sizeof(path), "%s.spec", stem);
    char* text = ReadTextFile(path, &(size_t){0});
    if (text == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        skip();
    }
    swMeasuredSea* sea = MakeSea(text);
    swMeasuredSea* spectra = ReadSpectra(stem);
    Comparison sums = {0};
    for (char* line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n"))
    {
        Printed printed;
        if (!ReadLine(line, &printed))
        {
            continue;
        }
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, swMeasuredSea_FindTime(sea, printed.time));
        swMeasuredRecord spectrum = swMeasuredSea_GetRecord(spectra, swMeasuredSea_FindTime(spectra, printed.time));
        assert_string_equal(record.time, printed.time);
        CompareWithLine(&record, &printed, &sums);
        CompareWithSpectrum(&record, &spectrum, &sums);
        ++sums.count;
    }
    assert_int_equal(sums.count, swMeasuredSea_GetCount(sea));
    print_message("%d records, worst from the line: Hs %.4f m, Tp %.2f %%, direction at the peak %.1f degrees\n",
                  sums.count, sums.worstHeight, 100.0 * sums.worstPeak, sums.worstPeakDirection);
    print_message("mean from the spectra: Tm02 %+.1f %% (%.1f %% apart), direction %.1f degrees apart, spread %+.1f "
                  "degrees; the peak of %d %%\n",
                  100.0 * sums.periodBias / sums.count, 100.0 * sums.periodError / sums.count,
                  sums.directionError / sums.count, sums.spreadBias / sums.count, 100 * sums.peaksFound / sums.count);
    assert_true(sums.count > 100);
    assert_true(sums.worstHeight < 1e-3);
    assert_true(sums.worstPeak < 0.05); // two close peaks add up to one between them
    assert_true(sums.worstPeakDirection < 22.5);
    assert_true(sums.periodError / sums.count < 0.10);
    assert_true(sums.directionError / sums.count < 15.0);
    assert_true(fabs(sums.spreadBias / sums.count) < 20.0);
    assert_true(100 * sums.peaksFound / sums.count >= 80);
    free(text);
    swDestroyMeasuredSea(sea);
    swDestroyMeasuredSea(spectra);
}

static void BostonsSummaryIsLikeItsSpectra(void** state)
{
    (void)state;
    CompareBuoy(BUOYS "/ndbc_44013_2022-05/44013");
}

static void CanaveralsSummaryIsLikeItsSpectra(void** state)
{
    (void)state;
    CompareBuoy(BUOYS "/ndbc_41010_2020-06/41010");
}

// ---- wrong texts ----

static void SummariesAreToldFromSpectra(void** state)
{
    (void)state;
    static const char summary[] = HEADING;
    static const char meteorology[] = "#YY  MM DD hh mm WDIR WSPD GST  WVHT   DPD   APD MWD\n";
    static const char realTime[] =
        "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n2022 05 12 23 50 0.25 1 (0.1)\n";
    static const char archive[] = "YYYY MM DD hh .030 .040\n2000 01 01 00 .00 .10\n" HEADING;
    static const char commented[] = "\n# WVHT is the height\r\n" HEADING;
    assert_true(swIsNdbcSummary(summary, sizeof(summary) - 1));
    assert_true(swIsNdbcSummary(meteorology, sizeof(meteorology) - 1));
    assert_true(swIsNdbcSummary(commented, sizeof(commented) - 1));
    assert_false(swIsNdbcSummary(realTime, sizeof(realTime) - 1));
    assert_false(swIsNdbcSummary(archive, sizeof(archive) - 1));
    assert_false(swIsNdbcSummary("", 0));
    assert_false(swIsNdbcSummary(NULL, 0));
}

static void WrongLinesAreNamed(void** state)
{
    (void)state;
    static const struct
    {
        const char *text, *words;
    } cases[] = {
        {"", "s.spec:1: the file ends without a record"},
        {HEADING UNITS, "s.spec:2: the file ends without a record"},
        {"2022 05 10 10 40 1.0\n", "s.spec:1: no heading (#YY MM DD hh mm WVHT ...) above the line"},
        {HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0\n",
         "s.spec:2: the line has 9 values after its date, the heading 10; it may be cut off"},
        {HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270 1\n",
         "s.spec:2: the line has 11 values after its date, the heading 10."},
        {HEADING "\n\n2022 05 32", "s.spec:4: the day is '32'"},
        {HEADING "2022 05 10 10 60 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n", "s.spec:2: the minute is '60'"},
        {HEADING "2022 05 10 10 40 high 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n",
         "s.spec:2: WVHT is 'high'; it must be a number, or MM"},
        {HEADING "2022 05 10 10 40 -1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n",
         "s.spec:2: WVHT is -1; it must be from 0 to 40"},
        {HEADING "2022 05 10 10 40 1.0 41 8.0 0.0 MM W MM SWELL 6.0 270\n", "s.spec:2: SwH is 41"},
        {HEADING "2022 05 10 10 40 1.0 1.0 0.5 0.0 MM W MM SWELL 6.0 270\n",
         "s.spec:2: SwP is 0.5; it must be from 1 to 40"},
        {HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 41 W MM SWELL 6.0 270\n", "s.spec:2: WWP is 41"},
        {HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM WWW MM SWELL 6.0 270\n",
         "s.spec:2: SwD is 'WWW'; it must be a point of the compass"},
        {HEADING "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 361\n", "s.spec:2: MWD is 361"},
        {HEADING "2022 05 10 10 40 1.0 1.0 MM 0.0 MM W MM SWELL MM 270\n",
         "s.spec:2: no line of the file has both a wave height and a period"},
        {HEADING "2022 05 10 10 40 MM MM MM MM MM MM MM N/A MM MM\n", "s.spec:2: no line of the file has both"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        assert_int_equal(ParseText(cases[i].text, &sea), SW_ERROR_FORMAT);
        assert_null(sea);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
}

static void HeightsWithoutPeriodsAreLeftOutWithAWarning(void** state)
{
    (void)state;
    swMeasuredSea* sea = MakeSea(HEADING "2022 05 10 10 40 1.0 1.0 MM 0.0 MM W MM SWELL MM 270\n"
                                         "2022 05 10 11 40 MM MM MM MM MM MM MM N/A MM MM\n"
                                         "2022 05 10 12 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n");
    assert_int_equal(swMeasuredSea_GetCount(sea), 1);
    assert_non_null(strstr(s_messages, "s.spec: 1 records have a wave height but no period and are left out"));
    swDestroyMeasuredSea(sea);
}

static void TooMuchIsRefusedByName(void** state)
{
    (void)state;
    char* text = malloc(1 << 21);
    size_t used = (size_t)sprintf(text, "#YY MM DD hh mm WVHT APD\n");
    for (int i = 0; i < 16385; ++i)
    {
        used += (size_t)sprintf(text + used, "2022 %02d %02d %02d %02d 1.0 6.0\n", 1 + i / 40320, 1 + i / 1440 % 28,
                                i / 60 % 24, i % 60);
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseText(text, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "more than 16384 records"));

    used = (size_t)sprintf(text, "#YY MM DD hh mm WVHT");
    for (int i = 0; i < 64; ++i)
    {
        used += (size_t)sprintf(text + used, " APD");
    }
    assert_int_equal(ParseText(text, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "s.spec:1: the heading names 65 columns; at most 64 are read"));
    free(text);
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    static const char text[] = HEADING UNITS "2022 05 10 11 40 2.0 1.5 8.0 1.3 5.0 W S SWELL 6.0 270\n"
                                             "2022 05 10 10 40 1.0 1.0 8.0 0.0 MM W MM SWELL 6.0 270\n";
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbcSummary(&host, text, sizeof(text) - 1, NULL, &sea), SW_SUCCESS);
    swDestroyMeasuredSea(sea);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    long long allocations = atomic_load(&memory.allocations);
    for (long long i = 0; i < allocations; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        sea = NULL;
        assert_int_equal(swParseNdbcSummary(&host, text, sizeof(text) - 1, NULL, &sea), SW_ERROR_NO_MEMORY);
        assert_null(sea);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    print_message("%lld allocations, each failed once\n", allocations);
    assert_true(allocations >= 7);
    assert_int_equal(atomic_load(&memory.messages), allocations);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SwellAndWindSeaStandApart),
        cmocka_unit_test(HeightIsThatOfTheWholeSea),
        cmocka_unit_test(EveryPointOfTheCompassIsUnderstood),
        cmocka_unit_test(MeanDirectionRefinesOnlyThePointItAgreesWith),
        cmocka_unit_test(MomentsAreThoseOfTheTable),
        cmocka_unit_test(SwellIsNarrowerThanWindSea),
        cmocka_unit_test(PeaksThatTouchStillMakeATable),
        cmocka_unit_test(MeteorologicalFilesGiveOneSystem),
        cmocka_unit_test(AveragePeriodIsThatOfTheTable),
        cmocka_unit_test(OneSystemHasHeightPeakAndAveragePeriod),
        cmocka_unit_test(SwellAndWindSeaHaveTheAveragePeriod),
        cmocka_unit_test(AveragePeriodsThatNoShapeHasAreTold),
        cmocka_unit_test(BuoysAveragePeriodsAreKept),
        cmocka_unit_test(CalmHasNoEnergy),
        cmocka_unit_test(RecordsComeInOrderOfTime),
        cmocka_unit_test(BostonsSummaryIsLikeItsSpectra),
        cmocka_unit_test(CanaveralsSummaryIsLikeItsSpectra),
        cmocka_unit_test(SummariesAreToldFromSpectra),
        cmocka_unit_test(WrongLinesAreNamed),
        cmocka_unit_test(HeightsWithoutPeriodsAreLeftOutWithAWarning),
        cmocka_unit_test(TooMuchIsRefusedByName),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
