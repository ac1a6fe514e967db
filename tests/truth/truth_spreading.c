// SPDX-License-Identifier: MIT
// V5: the distribution of direction integrates to one at every frequency, and the circular moments that buoys measure on
// the surface, frequency by frequency, are those of the model.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#include "sea_patches.h"

#define SEED_COUNT 12
#define BIN_COUNT 8

typedef struct SpreadingCase
{
    swSpectrumDef spectrum;
    double peak;
    SeaBins bins;
    SeaSums sums[SEED_COUNT];
} SpreadingCase;

static void MeasureSpreading(void* context, int seed)
{
    SpreadingCase* spreading = context;
    double length = FindWavelength(spreading->peak, (double)INFINITY, 9.81);
    double highest = 1.05 * spreading->bins.high[spreading->bins.count - 1];
    swWaveSystemDef def =
        MakeWaves(&spreading->spectrum, FindWavelength(highest, (double)INFINITY, 9.81), 4096.0, 1u + (uint32_t)seed);
    swWorld* world = CreateTruthSea(&def);
    SeaGauges gauges = {.area = 120.0 * length, .gaugeCount = 512, .duration = 60.0 / spreading->peak};
    if (!RecordSea(world, &gauges, &spreading->bins, 1, spreading->sums + seed))
    {
        abort();
    }
    swDestroyWorld(world);
}

// Integral of D and its moments over the circle, by the trapezoid rule, which is exact for what is smooth and periodic.
static double IntegrateModel(const swSpectrumDef* spectrum, double frequency, SeaMoments* moments)
{
    const int count = 720;
    double sum = 0.0;
    *moments = (SeaMoments){0};
    for (int i = 0; i < count; ++i)
    {
        double theta = TURN * i / count;
        double share = TURN / count * (double)swSpectrum_GetSpreading(spectrum, (float)frequency, (float)theta);
        sum += share;
        moments->a1 += share * cos(theta);
        moments->b1 += share * sin(theta);
        moments->a2 += share * cos(2.0 * theta);
        moments->b2 += share * sin(2.0 * theta);
    }
    return sum;
}

static double FindWorst(const SeaMoments* a, const SeaMoments* b)
{
    return fmax(fmax(fabs(a->a1 - b->a1), fabs(a->b1 - b->b1)), fmax(fabs(a->a2 - b->a2), fabs(a->b2 - b->b2)));
}

static void CheckSpreading(const char* name, const char* source, const swSpectrumDef* spectrum, double peak)
{
    SpreadingCase* spreading = calloc(1, sizeof(SpreadingCase));
    assert_non_null(spreading);
    spreading->spectrum = *spectrum;
    spreading->peak = peak;
    UseEqualBins(0.7 * peak, 2.5 * peak, BIN_COUNT, &spreading->bins);
    int count = Seeds(SEED_COUNT);
    RunJobs(MeasureSpreading, spreading, count);
    for (int i = 1; i < count; ++i)
    {
        AddSums(spreading->sums + i, spreading->sums);
    }
    double worst = 0.0, worstIntegral = 0.0;
    for (int i = 0; i < BIN_COUNT; ++i)
    {
        SeaMoments model, measured = FindMoments(spreading->sums, i);
        double integral = IntegrateModel(spectrum, spreading->bins.center[i], &model);
        worstIntegral = fmax(worstIntegral, fabs(integral - 1.0));
        worst = fmax(worst, FindWorst(&model, &measured));
        print_message("     %.3f Hz: a1 %.3f %.3f  b1 %.3f %.3f  a2 %.3f %.3f  b2 %.3f %.3f\n",
                      spreading->bins.center[i], model.a1, measured.a1, model.b1, measured.b1, model.a2, measured.a2,
                      model.b2, measured.b2);
    }
    char what[128];
    snprintf(what, sizeof(what), "Integral of D less 1, %s, worst of 8 frequencies", name);
    FindBelow(&(Finding){"V5", what, source, "%", 3}, 0.5, 100.0 * worstIntegral);
    snprintf(what, sizeof(what), "a1, b1, a2, b2 on the surface, %s, worst of 8 frequencies", name);
    FindBelow(&(Finding){"V5", what, source, "", 3}, Loosen(0.02), worst);
    free(spreading);
}

static void NarrowAndWideSeasSpreadAsCosines(void** state)
{
    (void)state;
    static const double exponents[] = {2.0, 10.0, 50.0};
    for (int i = 0; i < 3; ++i)
    {
        swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.7, exponents[i]);
        char name[64];
        snprintf(name, sizeof(name), "cos\xc2\xb2\xcb\xa2, s = %.0f", exponents[i]);
        CheckSpreading(name, "[Longuet-Higgins 1963]", &spectrum, 1.0 / 8.0);
    }
}

typedef struct PatchCase
{
    swSpectrumDef spectrum;
    SeaPatches patches[SEED_COUNT];
} PatchCase;

static void LookAtSquares(void* context, int seed)
{
    PatchCase* looked = context;
    swWaveSystemDef def = MakeWaves(&looked->spectrum, 16.0, 1024.0, 1u + (uint32_t)seed);
    swWorld* world = CreateTruthSea(&def);
    if (!CreatePatches(16.0, 512.0, looked->patches + seed) ||
        !LookAtPatches(world, 50.0, (double)INFINITY, seed, looked->patches + seed))
    {
        abort();
    }
    swDestroyWorld(world);
}

// Energy and first moments of what the squares saw, over the frequencies of waves of 512 m to 16 m.
static double SumSquares(const SeaPatches* patches, double low, double high, double* a1, double* b1)
{
    enum
    {
        FREQUENCIES = 400,
        DIRECTIONS = 180
    };
    double sum = 0.0;
    *a1 = *b1 = 0.0;
    for (int i = 0; i < FREQUENCIES * DIRECTIONS; ++i)
    {
        double f = low + (high - low) * (i / DIRECTIONS + 0.5) / FREQUENCIES,
               theta = TURN * (i % DIRECTIONS) / DIRECTIONS;
        double energy = FindPatchDensity(patches, f, theta, (double)INFINITY, 9.81) * (high - low) / FREQUENCIES *
                        TURN / DIRECTIONS;
        sum += energy;
        *a1 += energy * cos(theta);
        *b1 += energy * sin(theta);
    }
    return sum;
}

static void SquaresOfTheSurfaceSeeTheSameSea(void** state)
{
    (void)state;
    PatchCase* looked = calloc(1, sizeof(PatchCase));
    assert_non_null(looked);
    looked->spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.7, 10.0);
    int count = Seeds(SEED_COUNT);
    RunJobs(LookAtSquares, looked, count);
    for (int i = 1; i < count; ++i)
    {
        AddPatches(looked->patches + i, looked->patches);
    }
    double low = FindFrequency(512.0, (double)INFINITY, 9.81), high = FindFrequency(16.0, (double)INFINITY, 9.81), a1,
           b1;
    double variance = SumSquares(looked->patches, low, high, &a1, &b1);
    swSeaState asked;
    assert_int_equal(swSpectrum_GetSeaState(&looked->spectrum, (float)low, (float)high, &asked), SW_SUCCESS);
    FindWithin(&(Finding){"V5", "Hs of the directional spectrum that squares of the surface show, s = 10", "4 sqrt(m0)",
                          "m", 3},
               (double)asked.significantHeight, 4.0 * sqrt(variance), Loosen(0.02));
    FindNear(&(Finding){"V5", "Mean direction of the same", "atan2(b1, a1)", "\xc2\xb0", 1}, 0.7 / DEGREE,
             atan2(b1, a1) / DEGREE, Loosen(1.0));
    FindNear(&(Finding){"V5", "Spread of the same", "sqrt(2 (1 - r1))", "\xc2\xb0", 1}, (double)asked.spread / DEGREE,
             sqrt(2.0 * (1.0 - sqrt(a1 * a1 + b1 * b1) / variance)) / DEGREE, Loosen(1.0));
    for (int i = 0; i < count; ++i)
    {
        DestroyPatches(looked->patches + i);
    }
    free(looked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NarrowAndWideSeasSpreadAsCosines),
        cmocka_unit_test(SquaresOfTheSurfaceSeeTheSameSea),
    };
    BeginTruth("truth_spreading");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
