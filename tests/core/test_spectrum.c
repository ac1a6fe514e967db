// SPDX-License-Identifier: MIT
// Spectra hold the energy they say: published heights and periods of the formulas, tables to the last bin.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include "core/spectra/spectrum.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "seaway/math.h"

#define TURN (2.0 * SW_PI)

static swSeaState GetSeaState(const swSpectrumDef* def)
{
    swSeaState seaState;
    assert_int_equal(swSpectrum_GetSeaState(def, 0.0f, 0.0f, &seaState), SW_SUCCESS);
    return seaState;
}

static bool IsNear(float value, double expected, double tolerance)
{
    if (fabs((double)value - expected) > tolerance)
    {
        print_error("%.6f is not %.6f +- %g\n", (double)value, expected, tolerance);
        return false;
    }
    return true;
}

static void JonswapHasPublishedHeights(void** state)
{
    (void)state;
    static const struct
    {
        float wind, fetch;
        double height, period, zeroCrossing;
        swGrowthLaw growth;
    } rows[] = {
        {10, 100e3f, 2.01, 6.05, 4.70, SW_GROWTH_HASSELMANN}, {10, 300e3f, 3.68, 8.69, 0, SW_GROWTH_HASSELMANN},
        {15, 300e3f, 5.31, 9.97, 0, SW_GROWTH_HASSELMANN},    {20, 300e3f, 6.87, 11.00, 0, SW_GROWTH_HASSELMANN},
        {10, 100e3f, 2.14, 6.23, 4.85, SW_GROWTH_CUBE_ROOT},  {10, 300e3f, 3.94, 8.99, 0, SW_GROWTH_CUBE_ROOT},
        {15, 300e3f, 5.65, 10.29, 0, SW_GROWTH_CUBE_ROOT},    {20, 500e3f, 9.69, 13.43, 0, SW_GROWTH_CUBE_ROOT}};
    for (int i = 0; i < 8; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        assert_int_equal(def.growth, SW_GROWTH_HASSELMANN);
        def.growth = rows[i].growth;
        def.windSpeed = rows[i].wind;
        def.fetch = rows[i].fetch;
        swSeaState seaState = GetSeaState(&def);
        assert_true(IsNear(seaState.significantHeight, rows[i].height, 0.005));
        assert_true(IsNear(seaState.peakPeriod, rows[i].period, 0.005));
        assert_true(rows[i].zeroCrossing == 0 || IsNear(seaState.periodTm02, rows[i].zeroCrossing, 0.005));
    }
}

static void PiersonMoskowitzHasPublishedHeights(void** state)
{
    (void)state;
    static const double heights[] = {0.56, 2.25, 5.05, 8.98};
    static const double periods[] = {3.75, 7.49, 11.24, 14.98};
    for (int i = 0; i < 4; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        def.windSpeed = 5.0f * (float)(i + 1);
        swSeaState seaState = GetSeaState(&def);
        assert_true(IsNear(seaState.significantHeight, heights[i], 0.006));
        assert_true(IsNear(seaState.peakPeriod, periods[i], 0.006));
    }
}

static void HeightAndPeriodAreAsAsked(void** state)
{
    (void)state;
    for (int kind = SW_SPECTRUM_JONSWAP; kind <= SW_SPECTRUM_PIERSON_MOSKOWITZ; ++kind)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = (swSpectrumKind)kind;
        def.significantHeight = 2.0f;
        def.peakPeriod = 10.0f;
        def.gamma = 10.0f;
        swSeaState seaState = GetSeaState(&def);
        assert_true(IsNear(seaState.significantHeight, 2.0, 1e-3));
        assert_true(IsNear(seaState.peakPeriod, 10.0, 1e-5));
    }
}

static void JonswapWithoutEnhancementIsPiersonMoskowitz(void** state)
{
    (void)state;
    swSpectrumDef jonswap = swDefaultSpectrumDef();
    jonswap.significantHeight = 3.0f;
    jonswap.peakPeriod = 9.0f;
    jonswap.gamma = 1.0f;
    swSpectrumDef pierson = jonswap;
    pierson.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
    for (int i = 1; i < 40; ++i)
    {
        float a = swSpectrum_GetDensity(&jonswap, 0.025f * (float)i);
        float b = swSpectrum_GetDensity(&pierson, 0.025f * (float)i);
        assert_true(fabsf(a - b) <= 1e-5f * b);
    }
}

static void IntegralsOfNarrowPeaksAreAccurate(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swSpectrumDef def = swDefaultSpectrumDef();
    def.significantHeight = 1.0f;
    def.peakPeriod = 14.0f;
    def.gamma = 10.0f;
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    static const double ranges[][2] = {{0.0, 100.0}, {0.2, 0.3}, {0.3, 0.44}, {0.44, 0.46}, {0.449, 1.3}, {2.0, 40.0}};
    double worst = 0.0;
    for (int i = 0; i < 6; ++i)
    {
        // A brute-force sum in long double as the oracle, over ln omega.
        int steps = 400000;
        double low = log(fmax(ranges[i][0], 0.05));
        double step = (log(ranges[i][1]) - low) / steps;
        long double sum = 0.0L;
        for (int j = 0; j < steps; ++j)
        {
            double omega = exp(low + (j + 0.5) * step);
            sum += (long double)(swGetCompiledDensity(spectrum, omega) * omega);
        }
        double expected = (double)sum * step;
        double got = swIntegrateCompiled(spectrum, ranges[i][0], ranges[i][1]);
        worst = fmax(worst, fabs(got - expected) / expected);
    }
    print_message("worst relative error of six integrals: %.2e\n", worst);
    assert_true(worst < 1e-7);
    assert_true(fabs(swIntegrateCompiled(spectrum, 0.0, 1000.0) - 1.0 / 16.0) < 1e-6 / 16.0);
    swFreeCompiledSpectrum(&host, spectrum);
}

static void DirectionsIntegrateToOne(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swSpectrumDef def = swDefaultSpectrumDef();
    def.direction = 1.0f;
    def.spreadExponent = 20.0f;
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    for (int i = 1; i < 10; ++i)
    {
        double omega = 0.4 * i;
        double sum = 0.0;
        for (int j = 0; j < 720; ++j)
        {
            sum += swGetCompiledDensity2(spectrum, omega, TURN * j / 720.0) * TURN / 720.0;
        }
        assert_true(fabs(sum - swGetCompiledDensity(spectrum, omega)) <= 1e-9 * sum);
    }
    swFreeCompiledSpectrum(&host, spectrum);
    swSeaState seaState = GetSeaState(&def);
    assert_true(IsNear(seaState.meanDirection, 1.0, 1e-6));
    assert_true(IsNear(seaState.spread, sqrt(2.0 / 21.0), 1e-6)); // r1 = 20 / 21
}

// Bins of unequal width, one empty, all energy of a bin in one direction and its neighbours.
static const float s_frequencies[5] = {0.05f, 0.06f, 0.08f, 0.12f, 0.20f};
static const float s_bandwidths[5] = {0.01f, 0.015f, 0.03f, 0.06f, 0.08f};
static const float s_energies[5] = {1.0f, 8.0f, 20.0f, 0.0f, 2.0f};
static float s_density[5][36];

static swSpectrumDef MakeTableDef(swSpectrumTable* table)
{
    memset(s_density, 0, sizeof(s_density));
    for (int i = 0; i < 5; ++i)
    {
        s_density[i][9] = s_energies[i] * (float)(36.0 / TURN);
    }
    *table = (swSpectrumTable){5, 36, s_frequencies, s_bandwidths, s_density[0], 0.0f};
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = table;
    return def;
}

static double GetTableVariance(void)
{
    double variance = 0.0;
    for (int i = 0; i < 5; ++i)
    {
        variance += (double)s_energies[i] * (double)s_bandwidths[i];
    }
    return variance;
}

static void TablesKeepTheirEnergy(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swSpectrumTable table;
    swSpectrumDef def = MakeTableDef(&table);
    double variance = GetTableVariance();
    swSeaState seaState = GetSeaState(&def);
    assert_true(IsNear(seaState.significantHeight, 4.0 * sqrt(variance), 1e-6));
    assert_true(IsNear(seaState.peakPeriod, 1.0 / 0.08, 1e-5));
    assert_true(IsNear(seaState.meanDirection, SW_PI / 2.0, 1e-6));

    swCompiledSpectrum* spectrum = NULL;
    def.extendTail = false;
    assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    memset(s_density, 0, sizeof(s_density)); // a copy was taken
    assert_true(fabs(swIntegrateCompiled(spectrum, 0.0, TURN * 0.2401) - variance) < 3e-7);
    assert_true(swIntegrateCompiled(spectrum, 0.0, TURN * 0.045) < 1e-12);
    double parts = 0.0;
    for (int i = 0; i < 100; ++i)
    {
        parts += swIntegrateCompiled(spectrum, 0.0025 * TURN * i, 0.0025 * TURN * (i + 1));
    }
    assert_true(fabs(parts - variance) < 3e-7);
    swFreeCompiledSpectrum(&host, spectrum);
}

static void TablesTurnAndScale(void** state)
{
    (void)state;
    swSpectrumTable table;
    swSpectrumDef def = MakeTableDef(&table);
    def.direction = 0.5f;
    def.significantHeight = 3.0f;
    swSeaState seaState = GetSeaState(&def);
    assert_true(IsNear(seaState.significantHeight, 3.0, 1e-5));
    assert_true(IsNear(seaState.meanDirection, SW_PI / 2.0 + 0.5, 1e-6));
    swHost host = MakeHost();
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    assert_true(fabs(swIntegrateCompiled(spectrum, 0.0, TURN * 0.24) - 9.0 / 16.0) < 1e-6);
    swFreeCompiledSpectrum(&host, spectrum);
    assert_true(swSpectrum_GetSpreading(&def, 0.08f, (float)(SW_PI / 2.0 + 0.5)) > 5.0f);
    assert_true(swSpectrum_GetSpreading(&def, 0.08f, (float)(SW_PI / 2.0)) == 0.0f);
}

static void TailContinuesTheLastBins(void** state)
{
    (void)state;
    swSpectrumTable table;
    swSpectrumDef def = MakeTableDef(&table);
    float one = swSpectrum_GetDensity(&def, 0.5f);
    float two = swSpectrum_GetDensity(&def, 1.0f);
    assert_true(one > 0.0f && fabsf(one / two - 32.0f) < 1e-3f);
    def.extendTail = false;
    assert_true(swSpectrum_GetDensity(&def, 0.5f) == 0.0f);

    // A table of the tail's own shape goes on without a step.
    float frequencies[40];
    float widths[40];
    float density[40][4];
    for (int i = 0; i < 40; ++i)
    {
        frequencies[i] = 0.1f + 0.01f * (float)i;
        widths[i] = 0.01f;
        for (int j = 0; j < 4; ++j)
        {
            density[i][j] = powf(frequencies[i], -5.0f);
        }
    }
    swSpectrumTable phillips = {40, 4, frequencies, widths, density[0], 0.0f};
    def.table = &phillips;
    def.extendTail = true;
    double below = (double)swSpectrum_GetDensity(&def, 0.49f) * pow(0.49, 5.0);
    double above = (double)swSpectrum_GetDensity(&def, 0.51f) * pow(0.51, 5.0);
    assert_true(fabs(above / below - 1.0) < 0.002);
}

static void PartsOfASeaAddUp(void** state)
{
    (void)state;
    swSpectrumTable table;
    swSpectrumDef defs[2] = {swDefaultSpectrumDef(), MakeTableDef(&table)};
    for (int i = 0; i < 2; ++i)
    {
        double sum = 0.0;
        for (int j = 0; j < 10; ++j)
        {
            swSeaState part;
            if (swSpectrum_GetSeaState(&defs[i], 0.1f * (float)j, 0.1f * (float)(j + 1), &part) == SW_SUCCESS)
            {
                sum += (double)part.significantHeight * (double)part.significantHeight;
                assert_true(part.peakPeriod >= 0.999f / (0.1f * (float)(j + 1)));
            }
        }
        swSeaState whole;
        assert_int_equal(swSpectrum_GetSeaState(&defs[i], 0.0f, 1.0f, &whole), SW_SUCCESS);
        assert_true(IsNear(whole.significantHeight, sqrt(sum), 1e-5));
    }
}

static void WrongSpectraAreNamed(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swSpectrumTable table;
    struct
    {
        swSpectrumDef def;
        const char* words;
    } cases[10];
    for (int i = 0; i < 10; ++i)
    {
        cases[i].def = swDefaultSpectrumDef();
    }
    cases[0].def.windSpeed = 0.0f;
    cases[0].words = "windSpeed is 0 m/s; its range is (0, 100]";
    cases[1].def.windSpeed = NAN;
    cases[1].words = "windSpeed is nan";
    cases[2].def.fetch = 10.0f;
    cases[2].words = "fetch is 10 m; its range is [1000, 10000000]";
    cases[3].def.gamma = 11.0f;
    cases[3].words = "gamma is 11";
    cases[4].def.significantHeight = -1.0f;
    cases[4].words = "significantHeight is -1";
    cases[5].def.spreadExponent = 300.0f;
    cases[5].words = "spreadExponent is 300";
    cases[6].def.kind = SW_SPECTRUM_TABLE;
    cases[6].words = "is NULL";
    cases[7].def = MakeTableDef(&table);
    s_density[3][5] = -1.0f;
    cases[7].words = "frequency 3, direction 5 is -1";
    cases[8].def.direction = INFINITY;
    cases[8].words = "direction is inf";
    cases[9].def.growth = SW_GROWTH_LAW_COUNT;
    cases[9].words = "growth is 2; its range is [0, 1]";
    for (int i = 0; i < 10; ++i)
    {
        swCompiledSpectrum* spectrum = NULL;
        assert_int_equal(swCompileSpectrum(&host, &cases[i].def, 9.81, 7.4e-5, &spectrum), SW_ERROR_INVALID);
        assert_null(spectrum);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
        swSeaState seaState;
        assert_int_equal(swSpectrum_GetSeaState(&cases[i].def, 0.0f, 0.0f, &seaState), SW_ERROR_INVALID);
    }
}

static void ManyDensitiesAreThoseOfOneByOne(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    float frequencies[40], densities[40];
    for (int i = 0; i < 40; ++i)
    {
        frequencies[i] = 0.02f * (float)i;
    }
    swSpectrum_GetDensities(&def, 40, frequencies, densities);
    for (int i = 0; i < 40; ++i)
    {
        assert_true(densities[i] == swSpectrum_GetDensity(&def, frequencies[i]));
    }
    assert_true(densities[8] > 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(JonswapHasPublishedHeights),
        cmocka_unit_test(PiersonMoskowitzHasPublishedHeights),
        cmocka_unit_test(HeightAndPeriodAreAsAsked),
        cmocka_unit_test(JonswapWithoutEnhancementIsPiersonMoskowitz),
        cmocka_unit_test(IntegralsOfNarrowPeaksAreAccurate),
        cmocka_unit_test(DirectionsIntegrateToOne),
        cmocka_unit_test(TablesKeepTheirEnergy),
        cmocka_unit_test(TablesTurnAndScale),
        cmocka_unit_test(TailContinuesTheLastBins),
        cmocka_unit_test(PartsOfASeaAddUp),
        cmocka_unit_test(WrongSpectraAreNamed),
        cmocka_unit_test(ManyDensitiesAreThoseOfOneByOne),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
