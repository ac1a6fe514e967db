// SPDX-License-Identifier: MIT
// V2, V3: seas of JONSWAP and Pierson-Moskowitz have the heights and periods of the published formulas, which others
// have integrated with the published constants. No number here was worked out by this project's own formulas. Buoys on
// the generated surface measure them; waves beyond the buoys' last frequency are added from the density's f^-5 tail.
// The peak of a broad spectrum is hard to see in scattered bins: its period is that of the formula's shape, written
// down here once more, that is likeliest to have given all the bins between 0.6 and 3 peak frequencies [Whittle 1953].

#include "truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SEED_COUNT 48

typedef struct FormulaCase
{
    swSpectrumDef spectrum;
    swWaveMethod method;
    double peak; // Hz, only to choose bins
    swSeaBins bins;
    swSeaSums sums[SEED_COUNT];
} FormulaCase;

static void MeasureFormula(void* context, int seed)
{
    FormulaCase* formula = context;
    double length = swGetWavelength(formula->peak, (double)INFINITY, 9.81);
    double shortest = swGetWavelength(1.02 * formula->bins.high[formula->bins.count - 1], (double)INFINITY, 9.81);
    swWaveSystemDef def = MakeWaves(&formula->spectrum, shortest, 4096.0, 1u + (uint32_t)seed);
    def.method = formula->method;
    def.componentsPerOctave = 32;
    def.spectrum.direction = 2.39996f * (float)seed; // other waves of the lattice stand at the peak
    swWorld* world = CreateTruthSea(&def);
    swSeaGauges gauges = {.area = 120.0 * length,
                          .gaugeCount = formula->method == SW_WAVES_FFT ? 192 : 32,
                          .duration = 70.0 / formula->peak};
    if (swRecordSea(world, &gauges, &formula->bins, 1, formula->sums + seed) != SW_SUCCESS)
    {
        abort();
    }
    swDestroyWorld(world);
}

static FormulaCase* MeasureSpectrum(const swSpectrumDef* spectrum, swWaveMethod method, double peak)
{
    FormulaCase* formula = calloc(1, sizeof(FormulaCase));
    assert_non_null(formula);
    formula->spectrum = *spectrum;
    formula->method = method;
    formula->peak = peak;
    swMakeEqualBins(0.4 * peak, 3.2 * peak, 140, &formula->bins);
    int count = Seeds(method == SW_WAVES_FFT ? 8 : SEED_COUNT); // few waves: more seeds
    RunJobs(MeasureFormula, formula, count);
    for (int i = 1; i < count; ++i)
    {
        swAddSeaSums(formula->sums + i, formula->sums);
    }
    return formula;
}

// 4 sqrt(m0) with the tail beyond the last bin: m0 of c f^-5 from f on is S(f) f / 4.
static double FindHeight(const FormulaCase* formula, const swSeaState* state)
{
    double end = formula->bins.high[formula->bins.count - 1];
    double measured = (double)state->significantHeight / 4.0;
    double tail = (double)swSpectrum_GetDensity(&formula->spectrum, (float)end) * end / 4.0;
    return 4.0 * sqrt(measured * measured + tail);
}

// sqrt(m0 / m2) with the tail of both moments: m2 of c f^-5 from f on is S(f) f^3 / 2.
static double FindMeanPeriod(const FormulaCase* formula, const swSeaState* state)
{
    double end = formula->bins.high[formula->bins.count - 1];
    double density = (double)swSpectrum_GetDensity(&formula->spectrum, (float)end);
    double zero = (double)(state->significantHeight * state->significantHeight) / 16.0;
    double two = zero / (double)(state->periodTm02 * state->periodTm02);
    return sqrt((zero + density * end / 4.0) / (two + density * end * end * end / 2.0));
}

// Both formulas but for their level; gamma 1 is Pierson-Moskowitz.
static double FindShape(double frequency, double peak, double gamma)
{
    double x = frequency / peak, sigma = x <= 1.0 ? 0.07 : 0.09;
    double excess = exp(-(x - 1.0) * (x - 1.0) / (2.0 * sigma * sigma));
    return pow(x, -5.0) * exp(-1.25 * pow(x, -4.0)) * pow(gamma, excess);
}

// Minus the logarithm of how likely the bins are, the best level given: the mean of what is measured over the shape.
static double FindUnlikelihood(const FormulaCase* formula, double peak, double gamma)
{
    double ratios = 0.0, logarithms = 0.0;
    int count = 0;
    for (int i = 0; i < formula->bins.count; ++i)
    {
        double f = formula->bins.center[i];
        if (f > 0.6 * formula->peak && f < 3.0 * formula->peak)
        {
            double shape = FindShape(f, peak, gamma);
            ratios += swEstimateDensity(&formula->bins, formula->sums, i) / shape;
            logarithms += log(shape);
            count += 1;
        }
    }
    return log(ratios / count) + logarithms / count;
}

static double FitPeriod(const FormulaCase* formula, double gamma)
{
    const double section = 0.6180339887498949;
    double low = 0.8 * formula->peak, high = 1.25 * formula->peak;
    while (high - low > 1e-7 * formula->peak)
    {
        double left = high - section * (high - low), right = low + section * (high - low);
        if (FindUnlikelihood(formula, left, gamma) < FindUnlikelihood(formula, right, gamma))
        {
            high = right;
        }
        else
        {
            low = left;
        }
    }
    return 2.0 / (low + high);
}

typedef struct Row
{
    double wind, fetch, height, period;
    double meanPeriod; // Tm02, or 0
} Row;

static void CheckRow(const char* number, const char* source, const Row* row, double gamma,
                     const swSpectrumDef* spectrum, swWaveMethod method, const char* name)
{
    FormulaCase* formula = MeasureSpectrum(spectrum, method, 1.0 / row->period);
    swSeaState state;
    swEstimateSeaState(&formula->bins, formula->sums, &state);
    char what[128];
    snprintf(what, sizeof(what), "Hs, %s", name);
    FindWithin(&(Finding){number, what, source, "m", 3}, row->height, FindHeight(formula, &state), Loosen(0.01));
    snprintf(what, sizeof(what), "Tp, %s", name);
    FindWithin(&(Finding){number, what, source, "s", 3}, row->period, FitPeriod(formula, gamma), Loosen(0.005));
    if (row->meanPeriod > 0.0)
    {
        snprintf(what, sizeof(what), "Tm02, %s", name);
        FindWithin(&(Finding){number, what, source, "s", 3}, row->meanPeriod, FindMeanPeriod(formula, &state),
                   Loosen(0.01));
    }
    free(formula);
}

static void JonswapSeasHaveTheirHeightsAndPeriods(void** state)
{
    (void)state;
    static const Row rows[] = {{10.0, 100e3, 2.013, 6.047, 4.701},
                               {10.0, 300e3, 3.684, 8.689, 6.755},
                               {15.0, 300e3, 5.306, 9.973, 7.753},
                               {20.0, 300e3, 6.874, 10.998, 8.550}};
    for (int i = 0; i < (int)(sizeof(rows) / sizeof(rows[0])); ++i)
    {
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.windSpeed = (float)rows[i].wind;
        spectrum.fetch = (float)rows[i].fetch;
        char name[64];
        snprintf(name, sizeof(name), "U10 %.0f m/s over %.0f km", rows[i].wind, rows[i].fetch / 1e3);
        CheckRow("V2", "[Hasselmann 1973]", rows + i, 3.3, &spectrum, SW_WAVES_FFT, name);
        if (i < 2)
        {
            strcat(name, ", Gerstner waves");
            CheckRow("V2", "[Hasselmann 1973]", rows + i, 3.3, &spectrum, SW_WAVES_GERSTNER, name);
        }
    }
}

static void PiersonMoskowitzSeasHaveTheirHeightsAndPeriods(void** state)
{
    (void)state;
    static const Row rows[] = {{5.0, 0.0, 0.5613, 3.7458, 0.0},
                               {10.0, 0.0, 2.2453, 7.4917, 0.0},
                               {15.0, 0.0, 5.0520, 11.2375, 0.0},
                               {20.0, 0.0, 8.9814, 14.9833, 0.0}};
    for (int i = 0; i < (int)(sizeof(rows) / sizeof(rows[0])); ++i)
    {
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        spectrum.windSpeed = (float)rows[i].wind;
        char name[64];
        snprintf(name, sizeof(name), "U10 %.0f m/s", rows[i].wind);
        CheckRow("V3", "[Pierson 1964]", rows + i, 1.0, &spectrum, SW_WAVES_FFT, name);
        if (i == 2)
        {
            strcat(name, ", Gerstner waves");
            CheckRow("V3", "[Pierson 1964]", rows + i, 1.0, &spectrum, SW_WAVES_GERSTNER, name);
        }
    }
}

static void PeriodsOfADevelopedSeaHaveTheirRatios(void** state)
{
    (void)state;
    swSpectrumDef spectrum = swDefaultSpectrumDef();
    spectrum.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
    FormulaCase* formula = MeasureSpectrum(&spectrum, SW_WAVES_FFT, 1.0 / 7.4917);
    swSeaState sea;
    swEstimateSeaState(&formula->bins, formula->sums, &sea);
    // Of the frequencies that were recorded, in both.
    swSeaState asked;
    double low = formula->bins.low[0], high = formula->bins.high[formula->bins.count - 1];
    assert_int_equal(swSpectrum_GetSeaState(&spectrum, (float)low, (float)high, &asked), SW_SUCCESS);
    FindWithin(&(Finding){"V3", "Tm01, U10 10 m/s, 0.4 to 3.2 fp", "m0 / m1", "s", 3}, (double)asked.periodTm01,
               (double)sea.periodTm01, Loosen(0.005));
    FindWithin(&(Finding){"V3", "Tm02, U10 10 m/s, 0.4 to 3.2 fp", "sqrt(m0 / m2)", "s", 3}, (double)asked.periodTm02,
               (double)sea.periodTm02, Loosen(0.005));
    FindWithin(&(Finding){"V3", "Te, U10 10 m/s, 0.4 to 3.2 fp", "m-1 / m0", "s", 3}, (double)asked.energyPeriod,
               (double)sea.energyPeriod, Loosen(0.005));
    free(formula);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(JonswapSeasHaveTheirHeightsAndPeriods),
        cmocka_unit_test(PiersonMoskowitzSeasHaveTheirHeightsAndPeriods),
        cmocka_unit_test(PeriodsOfADevelopedSeaHaveTheirRatios),
    };
    BeginTruth("truth_formulas");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
