// SPDX-License-Identifier: MIT
// V5: the distribution of direction integrates to one at every frequency, and the circular moments that buoys measure on
// the surface, frequency by frequency, are those of the model.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NarrowAndWideSeasSpreadAsCosines),
    };
    BeginTruth("truth_spreading");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
