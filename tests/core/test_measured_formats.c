// SPDX-License-Identifier: MIT
// Spectra of models and of other buoys than NDBC's: directions on any grid, synthetic files of each format in orders
// and units that its writers may choose, files of others where they lie beside the sources, and texts that are wrong.

#include "support/cmocka_setup.h"
#include "support/text_file.h"
#include "support/sea_states.h"
#include "support/messages.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define DATA SW_SOURCE_DIR "/../shared/data/spectra"
#define DEGREE (SW_PI / 180.0)

// ---- a text that grows ----

typedef struct Text
{
    size_t size;
    char data[1 << 20];
} Text;

static Text* NewText(void)
{
    return calloc(1, sizeof(Text));
}

__attribute__((format(printf, 2, 3))) static void Print(Text* text, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    text->size += (size_t)vsnprintf(text->data + text->size, sizeof(text->data) - text->size, format, arguments);
    va_end(arguments);
    assert_true(text->size < sizeof(text->data) - 1);
}

static swMeasuredSea* Parse(const Text* text, const char* name)
{
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    swResult result = swParseMeasuredSea(&host, text->data, text->size, name, &sea);
    if (result != SW_SUCCESS)
    {
        print_message("%s", s_messages);
    }
    assert_int_equal(result, SW_SUCCESS);
    return sea;
}

// ---- the sea that all synthetic files hold ----

// A swell and a wind sea; `bearing` is where waves come from, degrees. m^2/Hz/degree.
static double Density(double frequency, double bearing)
{
    const double peaks[2] = {0.08, 0.17}, directions[2] = {250.0, 310.0}, heights[2] = {2.0, 1.2};
    double sum = 0.0;
    for (int i = 0; i < 2; ++i)
    {
        double x = log(frequency / peaks[i]) / 0.15;
        double half = 0.5 * (bearing - directions[i]) * DEGREE;
        double spread = pow(cos(half) * cos(half), i == 0 ? 20.0 : 6.0);
        sum += heights[i] * heights[i] * exp(-0.5 * x * x) / frequency * spread * (i == 0 ? 0.027 : 0.015) / 16.0;
    }
    return sum;
}

typedef struct Truth
{
    double height, tm01, tm02, direction;
} Truth;

// Sums over the file's own grid.
static Truth SumGrid(const double* frequencies, const double* widths, int frequencyCount, int directionCount)
{
    double m0 = 0.0, m1 = 0.0, m2 = 0.0, east = 0.0, north = 0.0, step = 360.0 / directionCount;
    for (int i = 0; i < frequencyCount; ++i)
    {
        for (int j = 0; j < directionCount; ++j)
        {
            double bearing = step * j;
            double variance = Density(frequencies[i], bearing) * step * widths[i];
            m0 += variance;
            m1 += variance * frequencies[i];
            m2 += variance * frequencies[i] * frequencies[i];
            east += variance * sin(bearing * DEGREE);
            north += variance * cos(bearing * DEGREE);
        }
    }
    double bearing = atan2(east, north) / DEGREE;
    return (Truth){4.0 * sqrt(m0), m0 / m1, sqrt(m0 / m2), bearing < 0.0 ? bearing + 360.0 : bearing};
}

#define FREQUENCIES 30

static void FillFrequencies(double* frequencies, double* widths)
{
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        frequencies[i] = 0.035 * pow(1.1, i);
    }
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        int low = i > 0 ? i - 1 : i, high = i + 1 < FREQUENCIES ? i + 1 : i;
        widths[i] = (frequencies[high] - frequencies[low]) / (high - low);
    }
}

static void CheckSea(const char* what, const swMeasuredSea* sea, int index, double heightTolerance)
{
    double frequencies[FREQUENCIES], widths[FREQUENCIES];
    FillFrequencies(frequencies, widths);
    Truth truth = SumGrid(frequencies, widths, FREQUENCIES, 720);
    swSeaState state = GetSeaState(sea, index, true);
    double height = (double)state.significantHeight / truth.height - 1.0;
    double direction = GetAngleBetween(GetBearing(state.meanDirection), truth.direction);
    print_message("%s: Hs %.4f m, off by %.4f %%, Tm01 %.3f %%, Tm02 %.3f %%, direction %.3f degrees\n", what,
                  (double)state.significantHeight, 100.0 * height,
                  100.0 * ((double)state.periodTm01 / truth.tm01 - 1.0),
                  100.0 * ((double)state.periodTm02 / truth.tm02 - 1.0), direction);
    assert_true(fabs(height) < heightTolerance);
    assert_true(fabs((double)state.periodTm02 / truth.tm02 - 1.0) < 0.01);
    assert_true(direction < 0.1);
}

// ---- directions ----

// Adds a spectrum of one frequency's shape on any directions (bearings from), and returns how far energy and direction
// are from those of the function that runs linearly between them.
static void CheckDirections(const char* what, const double* bearings, int count, int expectedCount)
{
    double frequencies[2] = {0.1, 0.11}, directions[720], density[1440], fine = 0.0, x = 0.0, y = 0.0;
    for (int j = 0; j < count; ++j)
    {
        directions[j] = (bearings[j] + 90.0) * DEGREE;
        density[j] = density[count + j] = Density(0.1, bearings[j]) / DEGREE;
    }
    // By brute force: between each direction and the next one clockwise.
    for (int j = 0; j < count; ++j)
    {
        double gap = 360.0;
        int next = j;
        for (int k = 0; k < count; ++k)
        {
            double ahead = bearings[k] - bearings[j] - 360.0 * floor((bearings[k] - bearings[j]) / 360.0);
            if (ahead > 1e-6 && ahead < 360.0 - 1e-6 && ahead < gap)
            {
                gap = ahead;
                next = k;
            }
        }
        bool isDouble = false; // 0 and 360: the first counts
        for (int k = 0; k < j; ++k)
        {
            isDouble = isDouble || fabs(remainder(bearings[k] - bearings[j], 360.0)) < 1e-6;
        }
        for (int k = 0; k < 2000 && !isDouble; ++k)
        {
            double part = (k + 0.5) / 2000.0;
            double value = (density[j] + part * (density[next] - density[j])) * gap * DEGREE / 2000.0;
            double angle = directions[j] + part * gap * DEGREE;
            fine += value;
            x += value * cos(angle);
            y += value * sin(angle);
        }
    }
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swCreateMeasuredSea(&host, what, &sea), SW_SUCCESS);
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.frequencyCount = 2;
    def.frequencies = frequencies;
    def.directionCount = count;
    def.directions = directions;
    def.density = density;
    assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    double energy = fabs((double)record.energy[0] / fine - 1.0);
    double angle = GetAngleBetween((double)GetSeaState(sea, 0, true).meanDirection / DEGREE, atan2(y, x) / DEGREE);
    print_message("%s: %d directions become %d, energy off by %.1e, direction by %.4f degrees\n", what, count,
                  record.table.directionCount, energy, angle);
    assert_int_equal(record.table.directionCount, expectedCount);
    assert_true(energy < 1e-6);
    assert_true(angle < 0.1);
    swDestroyMeasuredSea(sea);
}

static void DirectionsOfAnyOrderKeepEnergyAndMoments(void** state)
{
    (void)state;
    double bearings[720];
    for (int i = 0; i < 36; ++i)
    {
        bearings[i] = 5.0 + 10.0 * i;
    }
    CheckDirections("ascending, half a step off", bearings, 36, 36);
    for (int i = 0; i < 36; ++i)
    {
        bearings[i] = 85.0 - 10.0 * i;
    }
    CheckDirections("descending, below zero", bearings, 36, 36);
    for (int i = 0; i < 36; ++i)
    {
        bearings[i] = 3.3 + 10.0 * ((i * 7) % 36);
    }
    CheckDirections("shuffled, from 3.3 degrees", bearings, 36, 36);
    for (int i = 0; i < 121; ++i)
    {
        bearings[i] = 3.0 * i;
    }
    CheckDirections("0 and 360 both", bearings, 121, 120);
    for (int i = 0; i < 40; ++i)
    {
        bearings[i] = 360.0 * i / 40.0 + 3.0 * sin(0.7 * i);
    }
    CheckDirections("unequal", bearings, 40, 360);
    for (int i = 0; i < 200; ++i)
    {
        bearings[i] = 180.0 + 360.0 * i / 200.0 + 0.4 * sin(2.1 * i);
    }
    CheckDirections("unequal and fine", bearings, 200, 720);
}

// A sector's directions have whole cells: nothing is lost at its ends, nothing appears outside.
static void SectorsStayWithinTheirEnds(void** state)
{
    (void)state;
    double frequencies[2] = {0.1, 0.11}, directions[19], density[38];
    for (int j = 0; j < 19; ++j)
    {
        directions[j] = (180.0 + 5.0 * j) * DEGREE;
        density[j] = density[19 + j] = 2.0;
    }
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swCreateMeasuredSea(&host, "sector", &sea), SW_SUCCESS);
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.frequencyCount = 2;
    def.frequencies = frequencies;
    def.directionCount = 19;
    def.directions = directions;
    def.density = density;
    assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(fabs((double)record.energy[0] / (19.0 * 5.0 * DEGREE * 2.0) - 1.0) < 1e-6);
    assert_true(record.table.density[90] == 0.0f);
    swDestroyMeasuredSea(sea);
}

// ---- SWAN ----

static void PrintSwanHead(Text* text, bool isNautical, const double* bearings, int directionCount)
{
    double frequencies[FREQUENCIES], widths[FREQUENCIES];
    FillFrequencies(frequencies, widths);
    Print(text, "SWAN   1   Swan standard spectral file, version\n$   Data produced by a test\n$\n");
    Print(text, "TIME   time-dependent data\n     2   time coding option\nLONLAT   locations\n     2   number\n");
    Print(text, "  4.10  52.20\n  4.30  52.40\nRFREQ   relative frequencies in Hz\n  %d  number\n", FREQUENCIES);
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        Print(text, " %.8f\n", frequencies[i]);
    }
    Print(text, "%s   directions\n  %d   number\n", isNautical ? "NDIR" : "CDIR", directionCount);
    for (int j = 0; j < directionCount; ++j)
    {
        // Cartesian: where waves go, counterclockwise from east.
        Print(text, " %.4f\n", isNautical ? bearings[j] : 90.0 - (bearings[j] + 180.0));
    }
    Print(text, "QUANT\n  1  number of quantities\n%s\nunit\n  -99  exception value\n",
          isNautical ? "VaDens" : "EnDens");
}

static void PrintSwanMatrix(Text* text, double scale, const double* bearings, int directionCount)
{
    double frequencies[FREQUENCIES], widths[FREQUENCIES];
    FillFrequencies(frequencies, widths);
    double factor = 2e-6;
    Print(text, "FACTOR\n  %.8E\n", factor * scale);
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        for (int j = 0; j < directionCount; ++j)
        {
            double value = Density(frequencies[i], bearings[j]) / factor;
            Print(text, " %6ld", value < 0.5 ? (j % 2 == 0 ? -99L : 0L) : lround(value));
        }
        Print(text, "\n");
    }
}

static void CheckSwan(bool isNautical)
{
    double bearings[45];
    for (int j = 0; j < 45; ++j)
    {
        bearings[j] = isNautical ? 352.0 - 8.0 * j : 4.0 + 8.0 * j;
    }
    Text* text = NewText();
    PrintSwanHead(text, isNautical, bearings, 45);
    Print(text, "30-Aug-87 15:30:00   date and time\n");
    PrintSwanMatrix(text, isNautical ? 1.0 : 1025.0 * 9.81, bearings, 45);
    Print(text, "NODATA\n31-Aug-1987 03:00:30\nZERO\n");
    PrintSwanMatrix(text, isNautical ? 1.0 : 1025.0 * 9.81, bearings, 45);
    swMeasuredSea* sea = Parse(text, "swan.spec");
    assert_int_equal(swMeasuredSea_GetCount(sea), 3);
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), 2);
    assert_true(swMeasuredSea_GetLocation(sea, 1).latitude == 52.4);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "1987-08-30 15:30");
    assert_true(swMeasuredSea_GetRecord(sea, 2).seconds == 557377230.0);
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).table.directionCount, 45);
    assert_true(swMeasuredSea_GetRecord(sea, 1).energy[5] == 0.0f);
    CheckSea(isNautical ? "SWAN, nautical" : "SWAN, Cartesian", sea, 0, 1e-3);
    CheckSea("SWAN, second place", sea, 2, 1e-3);
    swDestroyMeasuredSea(sea);
    free(text);
}

static void SwanIsReadInBothConventions(void** state)
{
    (void)state;
    CheckSwan(true);
    CheckSwan(false);
}

static void OneDimensionalSwanIsRead(void** state)
{
    (void)state;
    Text* text = NewText();
    Print(text,
          "SWAN 1\nLOCATIONS\n 1\n 1000. 2000.\nAFREQ\n 3\n 0.1\n 0.2\n 0.3\nQUANT\n 3\nVaDens\nm2/Hz\n -0.9900E+02\n"
          "NDIR\ndegr\n -0.9990E+03\nDSPRDEGR\ndegr\n -0.9000E+01\n"
          "LOCATION 1\n 0.5000E+00 270.0 20.0\n 0.2000E+00 260.0 30.0\n -0.9900E+02 -999.0 -9.0\n");
    swMeasuredSea* sea = Parse(text, "swan1d.spec");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(record.time, "");
    assert_true(record.energy[0] == 0.5f && record.energy[2] == 0.0f);
    assert_true(GetAngleBetween(GetBearing(record.meanDirection[0]), 270.0) < 0.01);
    assert_true(fabs(sqrt(2.0 - 2.0 * (double)record.r1[1]) / DEGREE - 30.0) < 0.1);
    swDestroyMeasuredSea(sea);
    free(text);
}

static void EverySwanTimeCodingIsRead(void** state)
{
    (void)state;
    const char* const times[] = {"1", "20240229.133005",   "3", "02/29/24 13:30:05",
                                 "5", "24/02/29 13:30:05", "6", "2402291330"};
    for (int i = 0; i < 8; i += 2)
    {
        Text* text = NewText();
        Print(
            text,
            "SWAN 1\nTIME\n %s\nLONLAT\n1\n1 2\nAFREQ\n2\n.1\n.2\nNDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\nx\n-99\n",
            times[i]);
        Print(text, "%s\nFACTOR\n1\n1 2 3 4\n1 2 3 4\n", times[i + 1]);
        swMeasuredSea* sea = Parse(text, "times.spec");
        assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2024-02-29 13:30");
        swDestroyMeasuredSea(sea);
        free(text);
    }
}

// ---- WAVEWATCH III ----

static void PrintWrapped(Text* text, int* column, int width, const char* format, double value)
{
    Print(text, format, value);
    *column = (*column + 1) % width;
    Print(text, *column == 0 ? "\n" : "");
}

static void WavewatchIsReadWithSeveralPointsAndTimes(void** state)
{
    (void)state;
    double frequencies[FREQUENCIES], widths[FREQUENCIES];
    FillFrequencies(frequencies, widths);
    Text* text = NewText();
    int column = 0;
    Print(text, "'WAVEWATCH III SPECTRA'     %d    24     2 'a title with 3 numbers 1 2'\n", FREQUENCIES);
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        PrintWrapped(text, &column, 8, " %9.6f", frequencies[i]);
    }
    Print(text, "\n");
    column = 0;
    for (int j = 0; j < 24; ++j)
    {
        double to = (82.5 - 15.0 * j) * DEGREE;
        PrintWrapped(text, &column, 7, "  %.3E", to < 0.0 ? to + 2.0 * SW_PI : to);
    }
    for (int time = 0; time < 2; ++time)
    {
        Print(text, "\n20200101 %02d3000\n", 6 * time);
        for (int point = 0; point < 2; ++point)
        {
            Print(text, "'POINT %d   '  40.98-171.12      46.6   1.45 225.6   0.18  94.1\n", point);
            column = 0;
            for (int j = 0; j < 24; ++j)
            {
                for (int i = 0; i < FREQUENCIES; ++i)
                {
                    double value = Density(frequencies[i], 82.5 - 15.0 * j + 180.0) / DEGREE * (1 + point);
                    if (i == 0 && j == 0)
                    {
                        Print(text, "  0.261-100"); // as Fortran writes it
                        column = (column + 1) % 7;
                        continue;
                    }
                    PrintWrapped(text, &column, 7, "  %.5E", value);
                }
            }
            Print(text, "\n");
        }
    }
    swMeasuredSea* sea = Parse(text, "ww3.spec");
    assert_int_equal(swMeasuredSea_GetCount(sea), 4);
    assert_int_equal(swMeasuredSea_FindLocation(sea, "POINT 1"), 1);
    assert_true(swMeasuredSea_GetLocation(sea, 1).longitude == -171.12);
    assert_int_equal(swMeasuredSea_GetLocation(sea, 1).firstRecord, 2);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 3).time, "2020-01-01 06:30");
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).table.directionCount, 24);
    CheckSea("WAVEWATCH III", sea, 0, 1e-3);
    assert_true(
        fabs((double)GetSeaState(sea, 2, true).significantHeight / (double)GetSeaState(sea, 0, true).significantHeight -
             sqrt(2.0)) < 1e-4);

    int before = -1, after = -1;
    double fraction = -1.0, first = swMeasuredSea_GetRecord(sea, 2).seconds;
    assert_true(swMeasuredSea_Bracket(sea, 1, first + 1.5 * 3600.0, &before, &after, &fraction));
    assert_true(before == 2 && after == 3 && fabs(fraction - 0.25) < 1e-12);
    assert_true(swMeasuredSea_Bracket(sea, 1, first - 1.0, &before, &after, &fraction));
    assert_true(before == 2 && after == 2 && fraction == 0.0);
    assert_true(swMeasuredSea_Bracket(sea, 1, first + 1e9, &before, &after, &fraction));
    assert_true(before == 3 && after == 3 && fraction == 0.0);
    assert_true(swMeasuredSea_Bracket(sea, 1, first + 6.0 * 3600.0, &before, &after, &fraction));
    assert_true(before == 3 && after == 3 && fraction == 0.0);
    assert_true(swMeasuredSea_Bracket(sea, 0, first, &before, &after, &fraction) && before == 0);
    assert_false(swMeasuredSea_Bracket(sea, 2, first, &before, &after, &fraction));
    assert_false(swMeasuredSea_Bracket(sea, 0, (double)NAN, &before, &after, &fraction));
    swDestroyMeasuredSea(sea);
    free(text);
}

// ---- buoys ----

static void TriaxysIsReadOnOtherGrids(void** state)
{
    (void)state;
    Text* text = NewText();
    Print(text,
          "TRIAXYS BUOY DATA REPORT - TAS1 - 4830.0000N12330.0000W\nVERSION = WV\nTYPE	= DIRECTIONAL SPECTRUM\n"
          "DATE    = 2020-02-29 23:30(UTC)\nNUMBER OF FREQUENCIES = 120\nINITIAL FREQUENCY (Hz) = 0.000\n"
          "FREQUENCY SPACING (Hz) = 0.005\nNUMBER OF DIRECTIONS = 72\nDIRECTION SPACING (DEG) = 5\n"
          "COLUMNS = 0.00 TO 355.00 DEG\nROWS	= 0.00 TO   0.6 Hz\n");
    double m0 = 0.0;
    for (int i = 0; i < 120; ++i)
    {
        for (int j = 0; j < 72; ++j)
        {
            double value = i > 0 ? Density(0.005 * i, 5.0 * j) : 0.0;
            m0 += value * 0.005 * 5.0;
            Print(text, " %.5E", value);
        }
        Print(text, "\n");
    }
    swMeasuredSea* sea = Parse(text, "buoy.DIRSPEC");
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2020-02-29 23:30");
    assert_true(fabs(swMeasuredSea_GetLocation(sea, 0).latitude - 48.5) < 1e-9);
    assert_true(fabs(swMeasuredSea_GetLocation(sea, 0).longitude + 123.5) < 1e-9);
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).table.frequencyCount, 119);
    assert_true(fabs((double)GetSeaState(sea, 0, true).significantHeight / (4.0 * sqrt(m0)) - 1.0) < 1e-3);
    swDestroyMeasuredSea(sea);
    free(text);
}

static void DatawellHasItsSecondMomentsFromSkewnessAndKurtosis(void** state)
{
    (void)state;
    // cos^2s with s = 10 from 300 degrees: m1 = 10 / 11, m2 = 90 / 132, no skewness.
    double m1 = 10.0 / 11.0, m2 = 90.0 / 132.0, spread = sqrt(2.0 * (1.0 - m1)) / DEGREE;
    double kurtosis = (6.0 - 8.0 * m1 + 2.0 * m2) / (4.0 * (1.0 - m1) * (1.0 - m1));
    Text* text = NewText();
    Print(text, "5\n212\n5.1\n2.5\n20.0\n18.5\n4\n0.1\n0.2\n0.3\n12\n68.1\n");
    for (int i = 0; i < 64; ++i)
    {
        double f = i < 16 ? 0.025 + 0.005 * i : 0.11 + 0.01 * (i - 16);
        double x = log(f / 0.1) / 0.2;
        Print(text, "%.3f,%.5E,300.0,%.4f,0.000,%.4f\n", f, exp(-0.5 * x * x), spread, kurtosis);
    }
    swMeasuredSea* sea = Parse(text, "data/buoy}2013-06-03T00h30.spt");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(record.time, "2013-06-03 00:30");
    assert_true(fabsf(record.energy[15] - 2.5f) < 1e-5f);
    assert_true(fabsf(record.table.bandwidths[15] - 0.0075f) < 1e-6f);
    assert_true(GetAngleBetween(GetBearing(record.meanDirection[20]), 300.0) < 0.01);
    assert_true(fabs((double)record.r1[20] - m1) < 1e-4 && fabs((double)record.r2[20] - m2) < 1e-3);
    swDestroyMeasuredSea(sea);
    sea = Parse(text, "unnamed.spt");
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "");
    swDestroyMeasuredSea(sea);
    free(text);
}

// ---- partitions ----

static void PartitionsOfATableHaveWhatItSays(void** state)
{
    (void)state;
    Text* text = NewText();
    Print(text, "# a comment\ngamma,time,hs_m,tp_s,direction_from_deg,spread_deg,remark\n"
                "3.3,2024-11-16 06:50,3.0,12.5,270,20,swell\n,2024-11-16T06:50Z,4,6.25,270,20,\n"
                "5,2024-11-16 03:50,1.5,15.2,10,15,alone\n1,2024-11-16 09:50,0,,,,calm\n"
                ",2024-11-16 12:50,2,8,,,\n");
    swMeasuredSea* sea = Parse(text, "p.csv");
    assert_int_equal(swMeasuredSea_GetCount(sea), 4);
    swMeasuredRecord alone = swMeasuredSea_GetRecord(sea, 0);
    swSeaState seaState = GetSeaState(sea, 0, true);
    assert_int_equal(alone.partitionCount, 1);
    assert_true(fabs((double)seaState.significantHeight - 1.5) < 1e-3);
    assert_true(fabs((double)seaState.peakPeriod - 15.2) < 0.01);
    assert_true(GetAngleBetween(GetBearing(seaState.meanDirection), 10.0) < 0.1);
    print_message("spread %.2f degrees of 15\n", (double)seaState.spread / DEGREE);
    assert_true(fabs((double)seaState.spread / DEGREE - 15.0) < 0.3);
    swMeasuredRecord both = swMeasuredSea_GetRecord(sea, 1);
    seaState = GetSeaState(sea, 1, true);
    assert_int_equal(both.partitionCount, 2);
    assert_true(fabs((double)seaState.significantHeight - 5.0) < 2e-3);
    assert_true(fabs((double)seaState.spread / DEGREE - 20.0) < 0.5);
    assert_true(swMeasuredSea_GetRecord(sea, 2).energy[40] == 0.0f);
    assert_null(swMeasuredSea_GetRecord(sea, 3).meanDirection);
    swDestroyMeasuredSea(sea);
    free(text);
}

static void WavewatchsPartitionsAreRead(void** state)
{
    (void)state;
    Text* text = NewText();
    Print(text, " WAVEWATCH III PARTITIONED DATA FILE         III  1.01 \n"
                " yyyymmdd hhmmss     lat     lon   name       nprt depth ubas  udir cabs  cdir\n"
                "        hs     tp     lp       theta     sp      wf\n"
                "20080522 003000  58.500  15.250  'grid_point'  2  100.0  5.3 120.5 0.00   0.0\n"
                "  0    2.50   10.00  156.00   200.00    40.00   0.30\n"
                "  1    2.00   10.00  156.00   210.00    25.00   0.00\n"
                "  2    1.50    5.00   39.00   120.00    30.00   0.90\n"
                "20080522 003000  58.750  15.250  'grid_point'  0  100.0  5.3 120.5 0.00   0.0\n"
                "  0    0.40    4.00   25.00    90.00    40.00   1.00\n");
    swMeasuredSea* sea = Parse(text, "partition.ww3");
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), 2);
    assert_true(swMeasuredSea_GetLocation(sea, 1).latitude == 58.75);
    assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2008-05-22 00:30");
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).partitionCount, 2);
    swSeaState seaState = GetSeaState(sea, 0, true);
    assert_true(fabs((double)seaState.significantHeight - 2.5) < 1e-3);
    assert_true(fabs((double)seaState.peakPeriod - 10.0) < 0.01);
    assert_true(GetAngleBetween(GetBearing(seaState.peakDirection), 210.0) < 1.0);
    assert_true(fabs((double)GetSeaState(sea, 1, true).significantHeight - 0.4) < 1e-3);
    swDestroyMeasuredSea(sea);
    free(text);
}

// ---- files of others ----

static swMeasuredSea* ReadSea(const char* path)
{
    size_t size = 0;
    char* text = ReadTextFile(path, &size);
    if (text == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        skip();
    }
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseMeasuredSea(&host, text, size, path, &sea), SW_SUCCESS);
    free(text);
    return sea;
}

// The bins that a period may be off by: the frequency's neighbours.
static bool IsWithinABin(const swMeasuredRecord* record, double period, double expected)
{
    int bins[2] = {0, 0};
    for (int i = 0; i < record->table.frequencyCount; ++i)
    {
        double f = (double)record->table.frequencies[i];
        bins[0] =
            fabs(f - 1.0 / period) < fabs((double)record->table.frequencies[bins[0]] - 1.0 / period) ? i : bins[0];
        bins[1] =
            fabs(f - 1.0 / expected) < fabs((double)record->table.frequencies[bins[1]] - 1.0 / expected) ? i : bins[1];
    }
    return abs(bins[0] - bins[1]) <= 1;
}

static void RaglansSwanFileHasItsStatistics(void** state)
{
    (void)state;
    swMeasuredSea* sea = ReadSea(DATA "/swan_raglan_2016-10/swanfile.spec");
    // Hs, Tm01, Tm02, spread at the peak aside, of the control file; Hs, direction, Tp of SWAN's own table.
    static const double control[5][3] = {{1.719, 8.950, 7.624},
                                         {2.765, 9.102, 7.590},
                                         {2.926, 10.936, 9.596},
                                         {2.678, 7.633, 6.587},
                                         {4.263, 8.457, 7.348}};
    static const double table[5][4] = {{1.71903, 250.226, 249.091, 12.9023},
                                       {2.76712, 264.233, 252.339, 14.5011},
                                       {2.92970, 255.912, 251.593, 15.1047},
                                       {2.67841, 266.949, 249.865, 13.1753},
                                       {4.26364, 254.099, 251.603, 12.9766}};
    assert_int_equal(swMeasuredSea_GetCount(sea), 5);
    double worst[5] = {0};
    for (int i = 0; i < 5; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        swSeaState seaState = GetSeaState(sea, i, true);
        worst[0] = fmax(worst[0], fabs((double)seaState.significantHeight / control[i][0] - 1.0));
        worst[1] = fmax(worst[1], fabs((double)seaState.periodTm01 / control[i][1] - 1.0));
        worst[2] = fmax(worst[2], fabs((double)seaState.periodTm02 / control[i][2] - 1.0));
        worst[3] = fmax(worst[3], GetAngleBetween(GetBearing(seaState.meanDirection), table[i][1]));
        worst[4] = fmax(worst[4], GetAngleBetween(GetBearing(seaState.peakDirection), table[i][2]));
        assert_true(fabs((double)seaState.significantHeight / table[i][0] - 1.0) < 0.005);
        assert_true(IsWithinABin(&record, (double)seaState.peakPeriod, table[i][3]));
    }
    print_message("SWAN: Hs %.3f %%, Tm01 %.3f %%, Tm02 %.3f %%, direction %.2f, at the peak %.2f degrees\n",
                  100.0 * worst[0], 100.0 * worst[1], 100.0 * worst[2], worst[3], worst[4]);
    assert_true(worst[0] < 0.005 && worst[1] < 0.005 && worst[2] < 0.005);
    assert_true(worst[3] < 3.0 && worst[4] < 3.0);
    swDestroyMeasuredSea(sea);
}

static void BlockIslandsWavewatchFileIsReadAsExpected(void** state)
{
    (void)state;
    swMeasuredSea* sea = ReadSea(DATA "/ww3_44097_2022-09/ww3station.spec");
    static const double expected[4][5] = {{1.16, 13.57, 9.84, 8.10, 113.5},
                                          {1.13, 13.57, 9.99, 8.36, 113.2},
                                          {1.10, 13.57, 10.12, 8.58, 113.1},
                                          {1.08, 13.57, 10.14, 8.53, 113.1}};
    assert_int_equal(swMeasuredSea_GetCount(sea), 4);
    for (int i = 0; i < 4; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        swSeaState seaState = GetSeaState(sea, i, true);
        assert_true(fabs((double)seaState.significantHeight / expected[i][0] - 1.0) < 0.02);
        assert_true(IsWithinABin(&record, (double)seaState.peakPeriod, expected[i][1]));
        assert_true(fabs((double)seaState.periodTm01 / expected[i][2] - 1.0) < 0.01);
        assert_true(fabs((double)seaState.periodTm02 / expected[i][3] - 1.0) < 0.01);
        assert_true(GetAngleBetween(GetBearing(seaState.meanDirection), expected[i][4]) < 1.0);
    }
    swDestroyMeasuredSea(sea);
}

static void BothTriaxysFilesAreReadAsExpected(void** state)
{
    (void)state;
    swMeasuredSea* whole = ReadSea(DATA "/triaxys_2018-01/triaxys.DIRSPEC");
    swMeasuredSea* flat = ReadSea(DATA "/triaxys_2018-01/triaxys.NONDIRSPEC");
    double heights[2] = {(double)GetSeaState(whole, 0, true).significantHeight,
                         (double)GetSeaState(flat, 0, true).significantHeight};
    assert_true(fabs(heights[0] - 3.413) < 0.01 && fabs(heights[1] - 3.435) < 0.01);
    assert_true(fabs((double)GetSeaState(whole, 0, true).peakPeriod - 11.11) < 0.01);
    assert_true(fabs((double)GetSeaState(flat, 0, true).peakPeriod - 11.11) < 0.01);
    assert_true(fabs((double)GetSeaState(flat, 0, true).periodTm02 - 6.92) < 0.02);
    assert_int_equal(swMeasuredSea_GetRecord(whole, 0).table.directionCount, 120);
    assert_null(swMeasuredSea_GetRecord(flat, 0).meanDirection);
    swDestroyMeasuredSea(whole);
    swDestroyMeasuredSea(flat);
}

// ---- what is wrong ----

static void WrongTextsAreNamedWithTheirLine(void** state)
{
    (void)state;
#define SWAN "SWAN 1\nLONLAT\n1\n1 2\nAFREQ\n2\n.1\n.2\nNDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\nx\n-99\n"
#define WW3 "'WAVEWATCH III SPECTRA' 2 4 1 'x'\n.1 .2\n0 1.57 3.14 4.71\n"
#define TRIAXYS "TRIAXYS BUOY DATA REPORT - 1\nTYPE = NON-DIRECTIONAL SPECTRUM\nNUMBER OF FREQUENCIES = 3\n"
#define DATAWELL "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n"
    static const struct
    {
        const char* text;
        const char* complaint;
    } cases[] = {
        {"", "x:1: the format is not known"},
        {"SWAN 1\nWORDS\n", "x:2: 'WORDS' is not understood"},
        {"SWAN 1\nAFREQ\n2\n.1\nsoon\n", "x:5: a frequency should be a number, not 'soon'"},
        {"SWAN 1\nQUANT\n1\nVaDens\nm2\n-99\n", "x:6: before QUANT there must be"},
        {"SWAN 1\nQUANT\n1\nDepth\nm\n-99\n", "x:6: among the quantities"},
        {"SWAN 1\nTIME\n9\n", "x:3: the time coding option is 9"},
        {SWAN, "x:19: only 0 of 1 locations have a spectrum before this line"},
        {SWAN "FACTOR\n1e-3\n1 2 3 4\n1 2\n", "x:23: the file ends where a density"},
        {SWAN "FACTOR\n1e9\n1 2 3 4\n1 2 3 4\n", "x:22: a density is"},
        {SWAN "NODATA\n", "holds no spectrum"},
        {SWAN "LOCATION 1\n", "x:20: FACTOR, ZERO or NODATA should follow"},
        {WW3, "holds no spectrum"},
        {WW3 "20200101 250000\n", "x:4: 20200101 250000 is no date"},
        {WW3 "20200101 000000\nname\n", "x:5: a point's name in quotes"},
        {WW3 "20200101 000000\n'a' x 1\n", "x:5: a point's latitude should be a number"},
        {WW3 "20200101 000000\n'a' 5 1\n1 2 3 4 5 6 7", "x:6: the file ends where a density"},
        {WW3 "20200101 000000\n'a' 5 1\n1 2 3 4 5 6 7 1e9\n", "x:6: a density is 1e+09"},
        {"'WAVEWATCH III SPECTRA' 2 2 1 'x'\n", "x:1: the number of directions is 2"},
        {"'WAVEWATCH III SPECTRA' 2 4 1 'x'\n.1 .1\n0 1.57 3.14 4.71\n20200101 0\n'a' 5 1\n1 2 3 4 5 6 7 8\n", "twice"},
        {TRIAXYS ".1 2\n.2 3\n", "x:5: the file ends where a frequency"},
        {TRIAXYS "DATE = yesterday\n", "x:4: DATE should be"},
        {"TRIAXYS BUOY DATA REPORT\nTYPE = HNE\n", "x:2: TYPE is 'HNE'"},
        {"TRIAXYS BUOY DATA REPORT\n1 2 3\n", "x:2: the heading lacks"},
        {DATAWELL ".1,2,3,4,5,6\n", "x:13: a relative density is 2"},
        {"time,hs_m,tp_s\nnoon,1,2\n", "x:2: time is 'noon'"},
        {"time,hs_m,tp_s\n2020-01-01,50,2\n", "x:2: hs_m is '50'"},
        {"time,hs_m,tp_s\n2020-01-01,5\n", "x:2: the line has 2 fields, the heading 3"},
        {"time,hs_m,tp_s\n2020-01-01,5,\n", "x:2: there is a height but no tp_s"},
        {"time,hs_m,tp_s\n", "holds no spectrum"},
        {"WAVEWATCH III PARTITIONED DATA FILE\n20200101 0 1 2 'a' 1\n0 1 2\n", "x:3: a wavelength should be a number"},
        {DATAWELL ".1,.2,3,4,5,6\n.2,.3,4\n", "x:14: the file ends where a spread"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swHost host = MakeHost();
        swMeasuredSea* sea = NULL;
        swResult result = swParseMeasuredSea(&host, cases[i].text, strlen(cases[i].text), "x", &sea);
        if (result != SW_ERROR_FORMAT || strstr(s_messages, cases[i].complaint) == NULL)
        {
            print_message("'%s' says '%s', not '%s'\n", cases[i].text, s_messages, cases[i].complaint);
        }
        assert_int_equal(result, SW_ERROR_FORMAT);
        assert_null(sea);
        assert_non_null(strstr(s_messages, cases[i].complaint));
    }
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    static const char* const texts[] = {
        SWAN "FACTOR\n1e-3\n1 2 3 4\n1 2 3 4\n",
        WW3 "20200101 000000\n'a' 5 1\n1 2 3 4 5 6 7 8\n",
        TRIAXYS ".1 2\n.2 3\n.3 4\n",
        DATAWELL ".1,.2,3,4,5,6\n.2,.3,4,5,6,7\n",
        "time,hs_m,tp_s\n2020-01-01,1,5\n",
        "WAVEWATCH III PARTITIONED DATA FILE\n20200101 0 1 2 'a' 0\n0 1 2 3 4 15 6\n",
    };
    for (size_t k = 0; k < sizeof(texts) / sizeof(texts[0]); ++k)
    {
        CountingMemory memory;
        swHost host = MakeCountingHost(&memory);
        swMeasuredSea* sea = NULL;
        assert_int_equal(swParseMeasuredSea(&host, texts[k], strlen(texts[k]), "x", &sea), SW_SUCCESS);
        long long allocations = atomic_load(&memory.allocations);
        swDestroyMeasuredSea(sea);
        assert_int_equal(atomic_load(&memory.bytes), 0);
        for (long long i = 0; i < allocations; ++i)
        {
            host = MakeCountingHost(&memory);
            atomic_store(&memory.failAt, i);
            assert_int_equal(swParseMeasuredSea(&host, texts[k], strlen(texts[k]), "x", &sea), SW_ERROR_NO_MEMORY);
            assert_null(sea);
            assert_int_equal(atomic_load(&memory.bytes), 0);
            assert_int_equal(atomic_load(&memory.messages), 1);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(DirectionsOfAnyOrderKeepEnergyAndMoments),
        cmocka_unit_test(SectorsStayWithinTheirEnds),
        cmocka_unit_test(SwanIsReadInBothConventions),
        cmocka_unit_test(OneDimensionalSwanIsRead),
        cmocka_unit_test(EverySwanTimeCodingIsRead),
        cmocka_unit_test(WavewatchIsReadWithSeveralPointsAndTimes),
        cmocka_unit_test(TriaxysIsReadOnOtherGrids),
        cmocka_unit_test(DatawellHasItsSecondMomentsFromSkewnessAndKurtosis),
        cmocka_unit_test(PartitionsOfATableHaveWhatItSays),
        cmocka_unit_test(WavewatchsPartitionsAreRead),
        cmocka_unit_test(RaglansSwanFileHasItsStatistics),
        cmocka_unit_test(BlockIslandsWavewatchFileIsReadAsExpected),
        cmocka_unit_test(BothTriaxysFilesAreReadAsExpected),
        cmocka_unit_test(WrongTextsAreNamedWithTheirLine),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
