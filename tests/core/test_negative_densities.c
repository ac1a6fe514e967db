// SPDX-License-Identifier: MIT
// Densities below zero, which noise and smoothing leave in files: each frequency keeps its energy, what could not be
// kept is told, and numbers that only mark what is missing take nothing away.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define FREQUENCIES 5
#define DIRECTIONS 8

static const double s_frequencies[FREQUENCIES] = {0.06, 0.08, 0.10, 0.12, 0.14};
static swMeasuredSea* Store(swMeasuredSpectrumDef* def)
{
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    def->frequencyCount = FREQUENCIES;
    def->frequencies = s_frequencies;
    assert_int_equal(swCreateMeasuredSea(&host, "noisy", &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_AddSpectrum(sea, def), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    return sea;
}

static swMeasuredSea* StoreTable(double density[FREQUENCIES][DIRECTIONS], bool isUnequal)
{
    double directions[DIRECTIONS];
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        directions[j] = 2.0 * SW_PI * (j + (isUnequal && j == 3 ? 0.3 : 0.0)) / DIRECTIONS;
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.directionCount = DIRECTIONS;
    def.directions = directions;
    def.density = density[0];
    return Store(&def);
}

static void FillTable(double density[FREQUENCIES][DIRECTIONS])
{
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            density[i][j] = (i == 2 ? 3.0 : 1.0) * (j == 2 ? 4.0 : j == 1 || j == 3 ? 2.0 : 0.5);
        }
    }
}

static double SumRow(const double* row)
{
    double sum = 0.0;
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        sum += row[j] * 2.0 * SW_PI / DIRECTIONS;
    }
    return sum;
}

static void EachFrequencyKeepsItsEnergy(void** state)
{
    (void)state;
    double density[FREQUENCIES][DIRECTIONS];
    FillTable(density);
    density[1][6] = density[1][7] = -0.7;
    density[4][5] = -2.0;
    swMeasuredSea* sea = StoreTable(density, false);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    double variance = 0.0;
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        assert_true(fabs((double)record.energy[i] / SumRow(density[i]) - 1.0) < 1e-6);
        variance += SumRow(density[i]) * 0.02;
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            assert_true(record.table.density[i * DIRECTIONS + j] >= 0.0f);
        }
    }
    assert_int_equal(record.negativeCount, 3);
    double taken = 3.4 * 2.0 * SW_PI / DIRECTIONS * 0.02 / variance;
    assert_true(fabs((double)record.negativePart / taken - 1.0) < 1e-5);
    assert_true(record.addedPart == 0.0f);
    assert_non_null(strstr(s_messages, "noisy: 1 of 1 records hold negative densities"));
    swDestroyMeasuredSea(sea);
}

static void UnequalDirectionsKeepTheirEnergyToo(void** state)
{
    (void)state;
    double density[FREQUENCIES][DIRECTIONS], without[FREQUENCIES];
    for (int pass = 0; pass < 2; ++pass)
    {
        FillTable(density);
        if (pass == 1)
        {
            // Between columns 6 and 7, equally far apart as all around them, what one gains the other loses.
            density[1][6] -= 1.5;
            density[1][7] += 1.5;
        }
        swMeasuredSea* sea = StoreTable(density, true);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        assert_int_equal(record.negativeCount, pass);
        for (int i = 0; i < FREQUENCIES; ++i)
        {
            without[i] = pass == 0 ? (double)record.energy[i] : without[i];
            assert_true(fabs((double)record.energy[i] / without[i] - 1.0) < 1e-5);
        }
        swDestroyMeasuredSea(sea);
    }
}

static void AFrequencyThatIsNegativeAsAWholeIsNothingAndToldOf(void** state)
{
    (void)state;
    double density[FREQUENCIES][DIRECTIONS];
    FillTable(density);
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        density[4][j] = j == 0 ? 0.01 : -0.02;
    }
    swMeasuredSea* sea = StoreTable(density, false);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(record.energy[4] == 0.0f);
    assert_int_equal(record.negativeCount, 7);
    assert_true(record.addedPart > 0.0f && record.addedPart < record.negativePart);
    swDestroyMeasuredSea(sea);
}

static void MarksOfMissingValuesTakeNothingAway(void** state)
{
    (void)state;
    for (int unequal = 0; unequal < 2; ++unequal)
    {
        double density[FREQUENCIES][DIRECTIONS];
        FillTable(density);
        density[2][6] = -99.0;
        swMeasuredSea* sea = StoreTable(density, unequal != 0);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        density[2][6] = 0.0;
        swMeasuredSea* blank = StoreTable(density, unequal != 0);
        swMeasuredRecord other = swMeasuredSea_GetRecord(blank, 0);
        assert_memory_equal(record.energy, other.energy, FREQUENCIES * sizeof(float));
        assert_int_equal(record.negativeCount, 1);
        assert_true(record.negativePart == 0.0f && record.addedPart == 0.0f);
        assert_int_equal(other.negativeCount, 0);
        swDestroyMeasuredSea(blank);
        swDestroyMeasuredSea(sea);
    }
}

static void NegativeEnergiesWithoutDirectionsAreToldOf(void** state)
{
    (void)state;
    const double energy[FREQUENCIES] = {0.1, 2.0, 1.0, -0.02, (double)NAN};
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.energy = energy;
    swMeasuredSea* sea = Store(&def);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(record.energy[3] == 0.0f && record.energy[4] == 0.0f);
    assert_int_equal(record.negativeCount, 1);
    assert_true(fabs((double)record.addedPart - 0.02 / 3.1) < 1e-6);
    assert_true(record.addedPart == record.negativePart);
    swDestroyMeasuredSea(sea);
}

static void AFileOfASwanModelKeepsItsEnergy(void** state)
{
    (void)state;
    static const char text[] = "SWAN 1\nLOCATIONS\n1\n0 0\nAFREQ\n2\n0.1\n0.2\nNDIR\n4\n0\n90\n180\n270\n"
                               "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\nFACTOR\n0.001\n 10 -4 3 7\n 0 5 -99 -1\n";
    swHost host = MakeHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseMeasuredSea(&host, text, strlen(text), "noisy.spc", &sea), SW_SUCCESS);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(fabs((double)record.energy[0] - 0.016 * 90.0) < 1e-5);
    assert_true(fabs((double)record.energy[1] - 0.004 * 90.0) < 1e-5);
    assert_int_equal(record.negativeCount, 2);
    assert_non_null(strstr(s_messages, "negative densities"));
    swDestroyMeasuredSea(sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EachFrequencyKeepsItsEnergy),
        cmocka_unit_test(UnequalDirectionsKeepTheirEnergyToo),
        cmocka_unit_test(AFrequencyThatIsNegativeAsAWholeIsNothingAndToldOf),
        cmocka_unit_test(MarksOfMissingValuesTakeNothingAway),
        cmocka_unit_test(NegativeEnergiesWithoutDirectionsAreToldOf),
        cmocka_unit_test(AFileOfASwanModelKeepsItsEnergy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
