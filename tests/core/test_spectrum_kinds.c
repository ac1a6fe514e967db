// SPDX-License-Identifier: MIT
// Every kind of spectrum against published tables: heights and periods of wind seas over deep water and over a sea
// floor, the unified spectrum by wave number, the equaliser's energy.

#include "support/cmocka_setup.h"

#include "core/spectra/compiled.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/math/random.h"
#include "seaway/math.h"

static swSeaState GetSeaState(const swSpectrumDef* def, float maxFrequency)
{
    swSeaState seaState;
    assert_int_equal(swSpectrum_GetSeaState(def, 0.0f, maxFrequency, &seaState), SW_SUCCESS);
    return seaState;
}

static bool IsNear(double value, double expected, double tolerance)
{
    bool isNear = fabs(value - expected) <= tolerance;
    if (!isNear)
    {
        print_error("%.8g is not %.8g +- %g\n", value, expected, tolerance);
    }
    return isNear;
}

static bool IsWithin(double value, double expected, double part)
{
    return IsNear(value, expected, part * fabs(expected));
}

static swCompiledSpectrum* Compile(const swSpectrumDef* def)
{
    swHost host = swDefaultHost();
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&host, def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
    return spectrum;
}

static void Free(swCompiledSpectrum* spectrum)
{
    swHost host = swDefaultHost();
    swFreeCompiledSpectrum(&host, spectrum);
}

// ---- Pierson and Moskowitz ----

static void DevelopedSeasHavePublishedMoments(void** state)
{
    (void)state;
    // Wind at 19.5 m; Hs, Tp, Tm01, Tm02, Te [Pierson 1964], integrated exactly.
    static const double rows[][6] = {
        {5, 0.5332, 3.651, 2.818, 2.593, 3.130},      {7.5, 1.1998, 5.476, 4.226, 3.890, 4.694},
        {10, 2.1330, 7.302, 5.635, 5.187, 6.259},     {12.5, 3.3328, 9.127, 7.044, 6.484, 7.824},
        {15, 4.7992, 10.953, 8.453, 7.780, 9.389},    {17, 6.1643, 12.413, 9.580, 8.818, 10.641},
        {20, 8.5319, 14.604, 11.271, 10.374, 12.519}, {25, 13.3312, 18.255, 14.088, 12.967, 15.648},
    };
    for (int i = 0; i < 8; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        def.windSpeed = (float)(rows[i][0] / 1.026);
        swSeaState sea = GetSeaState(&def, 100.0f);
        assert_true(IsWithin((double)sea.significantHeight, rows[i][1], 5e-4));
        assert_true(IsWithin((double)sea.peakPeriod, rows[i][2], 5e-4));
        assert_true(IsWithin((double)sea.periodTm01, rows[i][3], 5e-4));
        assert_true(IsWithin((double)sea.periodTm02, rows[i][4], 5e-4));
        assert_true(IsWithin((double)sea.energyPeriod, rows[i][5], 5e-4));
    }
}

static void DevelopedSeasHavePublishedDensityByWaveNumber(void** state)
{
    (void)state;
    // S(k) = alpha / 2 k^-3 exp(-beta g^2 / (k^2 U^4)) at multiples of 0.0628319 rad/m, wind at 19.5 m.
    static const double winds[3] = {5.0, 10.0, 15.0};
    static const double tolerances[3] = {1e-8, 1e-7, 5e-6};
    static const double densities[3][7] = {
        {4.76656355e-12, 1.50019573e-3, 2.44797002e-2, 4.20064584e-2, 4.11734258e-2, 3.39059000e-2, 2.64125839e-2},
        {2.68841334, 1.30008153, 0.49488587, 0.22791438, 0.12152584, 0.07189522, 0.04588103},
        {11.43315027, 1.86697307, 0.58124237, 0.24949601, 0.12877022, 0.07484505, 0.04725667},
    };
    for (int i = 0; i < 3; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        def.windSpeed = (float)(winds[i] / 1.026);
        swCompiledSpectrum spectrum;
        swComplaint complaint;
        assert_true(swPrepareSpectrum(&spectrum, &def, 9.81, 0.0, &complaint));
        spectrum.peakOmega = swGetDevelopedOmega(9.81, winds[i] / 1.026); // not rounded to float
        for (int j = 0; j < 7; ++j)
        {
            double k = 2.0 * SW_PI / 100.0 * (j + 1), omega = sqrt(9.81 * k);
            double density = swGetCompiledDensity(&spectrum, omega) * 0.5 * 9.81 / omega;
            assert_true(IsNear(density, densities[i][j], tolerances[i]));
        }
    }
}

// ---- JONSWAP ----

static void GrowingSeasHavePublishedMoments(void** state)
{
    (void)state;
    // Wind, fetch, omega_p, Tp, Hs, Tm01, Tm02 with gamma 3.3.
    static const double rows[][7] = {
        {5, 10e3, 2.8120, 2.234, 0.304, 1.864, 1.737},        {5, 50e3, 1.6533, 3.800, 0.737, 3.171, 2.954},
        {5, 100e3, 1.3153, 4.777, 1.079, 3.986, 3.714},       {5, 300e3, 0.9153, 6.865, 1.974, 5.727, 5.337},
        {5, 1000e3, 0.6152, 10.213, 3.828, 8.521, 7.940},     {10, 10e3, 2.2216, 2.828, 0.567, 2.360, 2.199},
        {10, 50e3, 1.3062, 4.810, 1.375, 4.013, 3.740},       {10, 100e3, 1.0391, 6.047, 2.013, 5.045, 4.701},
        {10, 300e3, 0.7231, 8.689, 3.684, 7.249, 6.755},      {10, 1000e3, 0.4860, 12.927, 7.143, 10.786, 10.050},
        {15, 10e3, 1.9355, 3.246, 0.817, 2.708, 2.524},       {15, 50e3, 1.1380, 5.521, 1.981, 4.607, 4.292},
        {15, 100e3, 0.9053, 6.940, 2.900, 5.791, 5.396},      {15, 300e3, 0.6300, 9.973, 5.306, 8.321, 7.753},
        {15, 1000e3, 0.4234, 14.838, 10.288, 12.380, 11.535}, {20, 10e3, 1.7552, 3.580, 1.059, 2.987, 2.783},
        {20, 50e3, 1.0319, 6.089, 2.566, 5.080, 4.733},       {20, 100e3, 0.8209, 7.654, 3.757, 6.386, 5.950},
        {20, 300e3, 0.5713, 10.998, 6.874, 9.176, 8.550},     {20, 1000e3, 0.3840, 16.363, 13.329, 13.652, 12.721},
        {25, 10e3, 1.6269, 3.862, 1.294, 3.222, 3.002},       {25, 50e3, 0.9565, 6.569, 3.136, 5.480, 5.106},
        {25, 100e3, 0.7610, 8.257, 4.592, 6.889, 6.419},      {25, 300e3, 0.5296, 11.865, 8.403, 9.899, 9.224},
        {25, 1000e3, 0.3559, 17.653, 16.293, 14.728, 13.723},
    };
    int count = (int)(sizeof(rows) / sizeof(rows[0]));
    for (int i = 0; i < count; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.windSpeed = (float)rows[i][0];
        def.fetch = (float)rows[i][1];
        swSeaState sea = GetSeaState(&def, 100.0f);
        assert_true(IsWithin(2.0 * SW_PI / (double)sea.peakPeriod, rows[i][2], 0.001));
        assert_true(IsWithin((double)sea.significantHeight, rows[i][4], 0.002));
        assert_true(IsWithin((double)sea.peakPeriod, rows[i][3], 0.001));
        assert_true(IsWithin((double)sea.periodTm01, rows[i][5], 0.002));
        assert_true(IsWithin((double)sea.periodTm02, rows[i][6], 0.002));
    }
    assert_int_equal(count, 25);
}

static void ASharperPeakIsHigherAndNoneIsDeveloped(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef(), developed = swDefaultSpectrumDef();
    developed.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
    def.significantHeight = developed.significantHeight = 2.0f;
    def.peakPeriod = developed.peakPeriod = 10.0f;
    def.gamma = 1.0f;
    for (int i = 1; i < 100; ++i)
    {
        float f = 0.01f * (float)i;
        double a = (double)swSpectrum_GetDensity(&def, f), b = (double)swSpectrum_GetDensity(&developed, f);
        assert_true(fabs(a - b) <= 1e-6 * b);
    }
    float before = 0.0f;
    for (int i = 1; i <= 7; ++i)
    {
        def.gamma = (float)i;
        float peak = swSpectrum_GetDensity(&def, 0.1f);
        swSeaState sea = GetSeaState(&def, 100.0f);
        assert_true(peak > before && IsWithin((double)sea.significantHeight, 2.0, 1e-3));
        assert_true(IsWithin((double)sea.peakPeriod, 10.0, 1e-3));
        before = peak;
    }
    assert_true(swSpectrum_GetDensity(&def, 0.0f) == 0.0f);
}

// ---- TMA ----

static void TheDepthFactorIsTheExactOne(void** state)
{
    (void)state;
    static const double rows[][2] = {{0.25, 0.03125}, {0.50, 0.12480}, {0.75, 0.27868},
                                     {1.00, 0.48277}, {1.25, 0.70381}, {1.50, 0.87853},
                                     {1.75, 0.96618}, {2.00, 0.99336}, {2.50, 0.99989}};
    for (int i = 0; i < 9; ++i)
    {
        double depth = 3.0 + 5.0 * i;
        double factor = swGetDepthFactor(9.81, depth, rows[i][0] * sqrt(9.81 / depth));
        assert_true(IsNear(factor, rows[i][1], 6e-6));
    }
    assert_true(swGetDepthFactor(9.81, (double)INFINITY, 0.1) == 1.0);
}

static void SeasOverAFloorHavePublishedHeights(void** state)
{
    (void)state;
    // Depth, Hs at 15 and 20 m/s over 300 km, whose peaks are at 0.6300 and 0.5713 rad/s.
    static const double rows[][3] = {
        {5, 2.099, 2.481},  {10, 2.870, 3.413},  {20, 3.799, 4.568},   {30, 4.359, 5.301},
        {50, 4.948, 6.153}, {100, 5.278, 6.785}, {1000, 5.306, 6.874},
    };
    static const double peaks[2] = {0.6300, 0.5713};
    for (int i = 0; i < 7; ++i)
    {
        for (int j = 0; j < 2; ++j)
        {
            swSpectrumDef def = swDefaultSpectrumDef();
            def.kind = SW_SPECTRUM_TMA;
            def.windSpeed = 15.0f + 5.0f * (float)j;
            def.peakPeriod = (float)(2.0 * SW_PI / peaks[j]);
            def.depth = (float)rows[i][0];
            swSeaState sea = GetSeaState(&def, 100.0f);
            assert_true(IsWithin((double)sea.significantHeight, rows[i][1 + j], 0.002));
            assert_true(sea.peakPeriod >= (j == 0 ? 9.85f : 10.85f) && sea.peakPeriod <= (j == 0 ? 9.98f : 11.01f));
        }
    }
}

static void OverDeepWaterTmaIsJonswap(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef(), deep = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TMA;
    for (int i = 1; i < 200; ++i)
    {
        float f = 0.01f * (float)i;
        assert_true(swSpectrum_GetDensity(&def, f) == swSpectrum_GetDensity(&deep, f));
    }
    def.peakPeriod = deep.peakPeriod = 10.0f;
    def.depth = 80.0f;
    assert_true(IsWithin((double)GetSeaState(&def, 100.0f).significantHeight,
                         (double)GetSeaState(&deep, 100.0f).significantHeight, 0.02));
    def.depth = 300.0f;
    for (int i = 8; i < 100; ++i)
    {
        double a = (double)swSpectrum_GetDensity(&def, 0.01f * (float)i);
        assert_true(IsWithin(a, (double)swSpectrum_GetDensity(&deep, 0.01f * (float)i), 1e-4));
    }
    def.significantHeight = 2.0f;
    // However shallow, the height is the one asked for.
    static const float depths[] = {0.05f, 1.0f, 6.0f, 30.0f};
    for (int i = 0; i < 4; ++i)
    {
        def.depth = depths[i];
        assert_true(IsWithin((double)GetSeaState(&def, 200.0f).significantHeight, 2.0, 2e-3));
    }
}

// ---- Elfouhaily ----

static void TheUnifiedSpectrumIsThePublishedOne(void** state)
{
    (void)state;
    // By wave number at multiples of 0.0628319 rad/m, an age of 0.84, a drag of 0.00144. The values were made with
    // 0.3162 for 1 / sqrt(10), which is worth 6e-5 of them, and with the exponent 0.55 for the long waves' level.
    static const double winds[3] = {5.0, 10.0, 15.0};
    static const double densities[3][7] = {
        {2.60276926e-10, 3.85980085e-3, 4.11638703e-2, 6.43908578e-2, 6.17616606e-2, 5.05207166e-2, 3.91055100e-2},
        {4.21641049, 1.95535142, 0.70164121, 0.30549674, 0.15782445, 0.0924573, 0.05921628},
        {16.9746576, 2.45350994, 0.74821723, 0.32892719, 0.17409368, 0.10300532, 0.06576126},
    };
    double worst = 0.0;
    for (int i = 0; i < 3; ++i)
    {
        swElfouhaily shape = swMakeElfouhaily(9.81, winds[i], 0.84, 0.00144);
        assert_true(IsWithin(shape.longLevel, 0.006 * sqrt(0.84), 1e-12));
        shape.longLevel *= pow(0.84, 0.05);
        for (int j = 0; j < 7; ++j)
        {
            double k = 2.0 * SW_PI / 100.0 * (j + 1);
            // Take the rounding out again, from the long waves; the short ones have next to none of it.
            double root = sqrt(k / shape.peakNumber) - 1.0;
            double rounding = exp(-0.84 * (0.3162 - 1.0 / sqrt(10.0)) * root);
            double density = swGetElfouhailyDensity(&shape, k) * rounding;
            worst = fmax(worst, fabs(density / densities[i][j] - 1.0));
        }
        assert_true(swGetElfouhailyDensity(&shape, 0.0) == 0.0);
    }
    print_message("worst relative difference of 21 densities: %.1e\n", worst);
    assert_true(worst < 1e-5);
}

static void TheUnifiedSpectrumHasTheSlopesOfTheSea(void** state)
{
    (void)state;
    // A fully developed sea's total against [Cox 1954], 0.003 + 0.00512 U: within a fifth, and of 14 m/s at 12.5 m.
    static const float winds[] = {5.0f, 7.5f, 10.0f, 12.5f, 14.0f};
    for (int i = 0; i < 5; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = SW_SPECTRUM_ELFOUHAILY;
        def.windSpeed = winds[i];
        def.fetch = 1e7f;
        swSeaState sea = GetSeaState(&def, 500.0f);
        double measured = 0.003 + 0.00512 * (double)winds[i];
        print_message("%.1f m/s: Hs %.2f m, Tp %.2f s, mean square slope %.4f (%.4f measured)\n", (double)winds[i],
                      (double)sea.significantHeight, (double)sea.peakPeriod, (double)sea.meanSquareSlope, measured);
        assert_true(IsWithin((double)sea.meanSquareSlope, measured, 0.2));
        // As high as a developed sea is.
        def.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        assert_true(IsWithin((double)sea.significantHeight, (double)GetSeaState(&def, 500.0f).significantHeight, 0.2));
    }
}

// ---- Phillips ----

static void PhillipsEndsWhereTheWindDoes(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_PHILLIPS;
    swSeaState sea = GetSeaState(&def, 200.0f);
    // m0 = alpha U^4 / (4 g^2)
    double height = 4.0 * sqrt(0.0081 * 1e4 / (4.0 * 9.81 * 9.81));
    assert_true(IsWithin((double)sea.significantHeight, height, 1e-4));
    assert_true(IsWithin((double)sea.peakPeriod, 2.0 * SW_PI * 10.0 / (sqrt(sqrt(0.8)) * 9.81), 1e-5));
    double f = 3.0;
    double tail = 0.0081 * 9.81 * 9.81 * pow(2.0 * SW_PI, -4.0) * pow(f, -5.0);
    assert_true(IsWithin((double)swSpectrum_GetDensity(&def, (float)f), tail, 1e-3));
}

// ---- the equaliser ----

static void OctavesHoldTheIntegralOfWhatTheySay(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_OCTAVES;
    def.octaves.limitByWind = false;
    swCompiledSpectrum* spectrum = Compile(&def);
    swDispersion water = swGetCompiledDispersion(spectrum);
    double total = 0.0;
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        double high = swGetOmega(&water, 2.0 * SW_PI / ldexp(1.0, i - 4));
        double low = swGetOmega(&water, 2.0 * SW_PI / ldexp(1.0, i - 3));
        // A power law between two edges: its integral is closed.
        double a = (double)def.octaves.octaves[i].power;
        double b = i < 13 ? (double)def.octaves.octaves[i + 1].power : a + 5.0 * log10(high / low);
        double exponent = (a - b) / log10(high / low);
        double area = pow(10.0, a) * high / (exponent + 1.0) * (1.0 - pow(low / high, exponent + 1.0));
        area = def.octaves.octaves[i].isEnabled ? area : 0.0;
        double got = swIntegrateCompiled(spectrum, low, high);
        assert_true(IsNear(got, area, 1e-7 * area));
        if (def.octaves.octaves[i].isEnabled)
        {
            assert_true(IsWithin(swGetCompiledDensity(spectrum, high), pow(10.0, a), 1e-9));
        }
        total += got;
    }
    assert_true(IsWithin(swIntegrateCompiled(spectrum, 0.0, 1000.0), total, 1e-9));
    Free(spectrum);

    // The multiplier is one of height; the height asked for comes out.
    double height = (double)GetSeaState(&def, 6.0f).significantHeight;
    def.octaves.multiplier = 2.0f;
    assert_true(IsWithin((double)GetSeaState(&def, 6.0f).significantHeight, 2.0 * height, 1e-6));
    def.significantHeight = 1.5f;
    assert_true(IsWithin((double)GetSeaState(&def, 6.0f).significantHeight, 1.5, 1e-5));
}

static void OctavesCanBeTurnedOff(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_OCTAVES;
    def.octaves = swDefaultSwellOctaves();
    swCompiledSpectrum* spectrum = Compile(&def);
    assert_true(swIntegrateCompiled(spectrum, swGetOmega(&spectrum->dispersion, 2.0 * SW_PI / 16.0), 1000.0) == 0.0);
    assert_true(swIntegrateCompiled(spectrum, 0.0, swGetOmega(&spectrum->dispersion, 2.0 * SW_PI / 16.0)) > 0.0);
    Free(spectrum);
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        def.octaves.octaves[i].isEnabled = false;
    }
    swSeaState sea;
    assert_int_equal(swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &sea), SW_ERROR_INVALID);
}

static void OctavesHaveChopAndGravityOfTheirOwn(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_OCTAVES;
    def.octaves.chop = 0.5f;
    def.octaves.gravityScale = 3.0f;
    def.octaves.octaves[6].chop = 3.0f; // 4 to 8 m
    def.octaves.octaves[7].gravityScale = 0.25f;
    swCompiledSpectrum* spectrum = Compile(&def);
    assert_true(swGetCompiledChop(spectrum, 2.0 * SW_PI / 5.0) == 1.5);
    assert_true(swGetCompiledChop(spectrum, 2.0 * SW_PI / 3.9) == 0.5);
    assert_true(swGetCompiledChop(spectrum, 2.0 * SW_PI / 1e5) == 0.5);
    assert_true(swGetCompiledGravityScale(spectrum, 2.0 * SW_PI / 15.9) == 0.75);
    assert_true(swGetCompiledGravityScale(spectrum, 2.0 * SW_PI / 1e-3) == 3.0);
    Free(spectrum);
    swSpectrumDef other = swDefaultSpectrumDef();
    spectrum = Compile(&other);
    assert_true(swGetCompiledChop(spectrum, 1.0) == 1.0 && swGetCompiledGravityScale(spectrum, 1.0) == 1.0);
    Free(spectrum);
}

static void AnEqualiserTakesAnotherSpectrumsShape(void** state)
{
    (void)state;
    // A developed sea is a straight line on the equaliser: the same to the last octave.
    swSpectrumDef source = swDefaultSpectrumDef();
    source.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
    source.direction = 1.0f;
    swSpectrumDef def = swMakeOctaveSpectrum(&source);
    assert_int_equal(def.kind, SW_SPECTRUM_OCTAVES);
    assert_true(def.direction == 1.0f && IsNear((double)def.octaves.multiplier, 1.0, 1e-4));
    for (float f = 0.06f; f < 5.0f; f *= 1.1f)
    {
        double a = (double)swSpectrum_GetDensity(&def, f), b = (double)swSpectrum_GetDensity(&source, f);
        assert_true(IsWithin(a, b, 1e-3));
    }
    // -0.07 at 64 m, as the published power law has it; 0.7526 more an octave.
    assert_true(IsNear((double)def.octaves.octaves[10].power, -0.07, 0.01));
    assert_true(IsNear((double)def.octaves.octaves[4].power, -4.58, 0.01));

    // Any other keeps height and, nearly, periods.
    for (int kind = 0; kind < SW_SPECTRUM_OCTAVES; ++kind)
    {
        source.kind = (swSpectrumKind)kind;
        source.depth = kind == SW_SPECTRUM_TMA ? 15.0f : (float)INFINITY;
        def = swMakeOctaveSpectrum(&source);
        swSeaState a = GetSeaState(&def, 0.0f), b = GetSeaState(&source, 0.0f);
        assert_true(IsWithin((double)a.significantHeight, (double)b.significantHeight, 1e-4));
        assert_true(IsWithin((double)a.periodTm02, (double)b.periodTm02, 0.15));
        assert_true(IsWithin((double)a.peakPeriod, (double)b.peakPeriod, 0.15));
    }
}

static void WrongOctavesAreNamed(void** state)
{
    (void)state;
    swSpectrumDef def = swDefaultSpectrumDef();
    swComplaint complaint;
    def.kind = SW_SPECTRUM_OCTAVES;
    def.octaves.octaves[5].power = 7.0f;
    assert_false(swCheckSpectrumDef(&complaint, &def));
    assert_non_null(strstr(complaint.text, "octaves.octaves[5].power is 7; its range is [-10, 5]"));
    def.octaves = swDefaultOctaves();
    def.octaves.gravityScale = NAN;
    assert_false(swCheckSpectrumDef(&complaint, &def));
    assert_non_null(strstr(complaint.text, "octaves.gravityScale is nan"));
    def.octaves = swDefaultOctaves();
    def.octaves.multiplier = 0.0f;
    def.significantHeight = 1.0f;
    swCompiledSpectrum spectrum;
    assert_false(swPrepareSpectrum(&spectrum, &def, 9.81, 0.0, &complaint));
    assert_non_null(strstr(complaint.text, "no energy"));
    def = swDefaultSpectrumDef();
    def.spreading = (swSpreadingKind)9;
    assert_false(swCheckSpectrumDef(&complaint, &def));
    assert_non_null(strstr(complaint.text, "spreading is 9"));
    def = swDefaultSpectrumDef();
    def.swell = 1.5f;
    assert_false(swCheckSpectrumDef(&complaint, &def));
    assert_non_null(strstr(complaint.text, "swell is 1.5; its range is [0, 1]"));
    def = swDefaultSpectrumDef();
    def.depth = 0.0f;
    assert_false(swCheckSpectrumDef(&complaint, &def));
    assert_non_null(strstr(complaint.text, "depth is 0 m; its range is [0.001, inf]"));
}

// ---- all of them ----

static void EveryKindHasTheHeightAndTheMomentsOfItsIntegral(void** state)
{
    (void)state;
    double worst = 0.0;
    for (int kind = 0; kind < SW_SPECTRUM_TABLE; ++kind)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = (swSpectrumKind)kind;
        def.depth = 12.0f;
        def.significantHeight = 2.0f;
        swSeaState sea = GetSeaState(&def, 0.0f);
        assert_true(IsNear((double)sea.significantHeight, 2.0, 4e-3)); // up to 5 Hz
        // A sum of many small steps as the oracle.
        swCompiledSpectrum* spectrum = Compile(&def);
        int steps = 200000;
        double low = log(0.05), step = (log(2.0 * SW_PI * 5.0) - low) / steps, sums[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < steps; ++i)
        {
            double omega = exp(low + (i + 0.5) * step);
            double part = swGetCompiledDensity(spectrum, omega) * omega * step;
            sums[0] += part;
            sums[1] += part * omega;
            sums[2] += part * omega * omega;
        }
        Free(spectrum);
        worst = fmax(worst, fabs((double)sea.significantHeight / (4.0 * sqrt(sums[0])) - 1.0));
        worst = fmax(worst, fabs((double)sea.periodTm01 * sums[1] / (2.0 * SW_PI * sums[0]) - 1.0));
        worst = fmax(worst, fabs((double)sea.periodTm02 * sqrt(sums[2] / sums[0]) / (2.0 * SW_PI) - 1.0));
    }
    print_message("worst relative error of heights and periods: %.1e\n", worst);
    assert_true(worst < 2e-6);
}

// Between low and high on a scale of logarithms; now and then an end.
static float Pick(int* draw, double low, double high)
{
    double u = swHashToUnit(swHashWave(11, 0, (*draw)++, 0, 0));
    u = u < 0.1 ? 0.0 : u > 0.9 ? 1.0 : u;
    return (float)(low * pow(high / low, u));
}

static void WhateverIsInItsRangeIsFinite(void** state)
{
    (void)state;
    int draw = 0, seas = 0;
    for (int i = 0; i < 3000; ++i)
    {
        swSpectrumDef def = swDefaultSpectrumDef();
        def.kind = (swSpectrumKind)(i % SW_SPECTRUM_TABLE);
        def.spreading = (swSpreadingKind)(i / SW_SPECTRUM_TABLE % SW_SPREADING_KIND_COUNT);
        def.windSpeed = Pick(&draw, 1e-6, 99.9);
        def.fetch = Pick(&draw, 1001.0, 9.9e6);
        def.significantHeight = i % 2 == 0 ? 0.0f : Pick(&draw, 1e-6, 39.0);
        def.peakPeriod = i % 3 == 0 ? 0.0f : Pick(&draw, 1e-6, 59.0);
        def.spreadExponent = Pick(&draw, 1e-6, 199.0);
        def.turbulence = Pick(&draw, 1e-9, 0.999);
        def.swell = Pick(&draw, 1e-9, 0.999);
        def.depth = i % 5 == 0 ? (float)INFINITY : Pick(&draw, 0.00101, 1e20);
        def.octaves.limitByWind = i % 7 != 0;
        def.growth = (swGrowthLaw)(i % SW_GROWTH_LAW_COUNT);
        swSeaState sea;
        if (swSpectrum_GetSeaState(&def, 0.0f, i % 4 == 0 ? 900.0f : 0.0f, &sea) == SW_SUCCESS)
        {
            assert_true(isfinite(sea.significantHeight) && isfinite(sea.peakPeriod) && isfinite(sea.meanSquareSlope));
            assert_true(isfinite(sea.energyPeriod) && sea.spread >= 0.0f && sea.spread < 1.5f);
            seas += 1;
        }
        swCompiledSpectrum spectrum;
        swComplaint complaint;
        if (swPrepareSpectrum(&spectrum, &def, (double)Pick(&draw, 0.01, 100.0), 7.4e-5, &complaint))
        {
            double omega = (double)Pick(&draw, 1e-5, 1e5);
            double density = swGetCompiledDensity2(&spectrum, omega, 1.0 + i);
            assert_true(density >= 0.0 && density < 1e30);
        }
    }
    print_message("%d seas\n", seas);
    assert_true(seas > 800);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(DevelopedSeasHavePublishedMoments),
        cmocka_unit_test(DevelopedSeasHavePublishedDensityByWaveNumber),
        cmocka_unit_test(GrowingSeasHavePublishedMoments),
        cmocka_unit_test(ASharperPeakIsHigherAndNoneIsDeveloped),
        cmocka_unit_test(TheDepthFactorIsTheExactOne),
        cmocka_unit_test(SeasOverAFloorHavePublishedHeights),
        cmocka_unit_test(OverDeepWaterTmaIsJonswap),
        cmocka_unit_test(TheUnifiedSpectrumIsThePublishedOne),
        cmocka_unit_test(TheUnifiedSpectrumHasTheSlopesOfTheSea),
        cmocka_unit_test(PhillipsEndsWhereTheWindDoes),
        cmocka_unit_test(OctavesHoldTheIntegralOfWhatTheySay),
        cmocka_unit_test(OctavesCanBeTurnedOff),
        cmocka_unit_test(OctavesHaveChopAndGravityOfTheirOwn),
        cmocka_unit_test(AnEqualiserTakesAnotherSpectrumsShape),
        cmocka_unit_test(WrongOctavesAreNamed),
        cmocka_unit_test(EveryKindHasTheHeightAndTheMomentsOfItsIntegral),
        cmocka_unit_test(WhateverIsInItsRangeIsFinite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
