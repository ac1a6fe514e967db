// SPDX-License-Identifier: MIT
// V5: the distribution of direction integrates to one at every frequency, and the circular moments that buoys measure
// on the surface, frequency by frequency, are those of the model. Distributions that the literature gives by frequency
// are written down here once more.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#include "seaway/measure.h"

#define SEED_COUNT 160
#define BIN_COUNT 8

typedef struct SpreadingCase
{
    swWaveSystemDef def;
    double peak;
    int gaugeCount;
    swSeaBins bins;
    swSeaSums sums[SEED_COUNT];
} SpreadingCase;

static void MeasureSpreading(void* context, int seed)
{
    SpreadingCase* spreading = context;
    double length = swGetWavelength(spreading->peak, (double)INFINITY, 9.81);
    double highest = 1.05 * spreading->bins.high[spreading->bins.count - 1];
    swWaveSystemDef def = spreading->def;
    def.minWavelength = (float)swGetWavelength(highest, (double)INFINITY, 9.81);
    def.seed = 1u + (uint32_t)seed;
    swWorld* world = CreateTruthSea(&def);
    swSeaGauges gauges = {
        .area = 120.0 * length, .gaugeCount = spreading->gaugeCount, .duration = 60.0 / spreading->peak};
    if (swRecordSea(world, &gauges, &spreading->bins, 1, spreading->sums + seed) != SW_SUCCESS)
    {
        abort();
    }
    swDestroyWorld(world);
}

// Integral of D and its moments over the circle, by the trapezoid rule, which is exact for what is smooth and periodic.
static double IntegrateModel(const swSpectrumDef* spectrum, double frequency, swDirectionMoments* moments)
{
    const int count = 720;
    double sum = 0.0;
    *moments = (swDirectionMoments){0};
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

// What a buoy would find in a bin of the model, whose directions differ over the bin: moments of its cross spectra.
static swDirectionMoments AverageModel(const swSpectrumDef* spectrum, double low, double high, double* integral)
{
    const int parts = 16;
    swSeaSums* sums = calloc(1, sizeof(swSeaSums));
    assert_non_null(sums);
    *integral = 1.0;
    for (int i = 0; i < parts; ++i)
    {
        swDirectionMoments moments;
        double f = low + (high - low) * (i + 0.5) / parts, energy = (double)swSpectrum_GetDensity(spectrum, (float)f);
        double k = TURN / swGetWavelength(f, (double)INFINITY, 9.81), whole = IntegrateModel(spectrum, f, &moments);
        *integral = fabs(whole - 1.0) > fabs(*integral - 1.0) ? whole : *integral;
        sums->h[0] += energy;
        sums->hx[0] += energy * k * moments.a1;
        sums->hz[0] += energy * k * moments.b1;
        sums->xx[0] += energy * k * k * 0.5 * (1.0 + moments.a2);
        sums->zz[0] += energy * k * k * 0.5 * (1.0 - moments.a2);
        sums->xz[0] += energy * k * k * 0.5 * moments.b2;
    }
    swDirectionMoments found = swEstimateMoments(sums, 0);
    free(sums);
    return found;
}

static double FindWorst(const swDirectionMoments* a, const swDirectionMoments* b)
{
    return fmax(fmax(fabs(a->a1 - b->a1), fabs(a->b1 - b->b1)), fmax(fabs(a->a2 - b->a2), fabs(a->b2 - b->b2)));
}

static void CheckSpreading(const char* name, const char* source, const swWaveSystemDef* def, double peak,
                           int gaugeCount, int seeds)
{
    SpreadingCase* spreading = calloc(1, sizeof(SpreadingCase));
    assert_non_null(spreading);
    spreading->def = *def;
    spreading->peak = peak;
    spreading->gaugeCount = gaugeCount;
    swMakeEqualBins(0.7 * peak, 2.5 * peak, BIN_COUNT, &spreading->bins);
    int count = Seeds(seeds);
    RunJobs(MeasureSpreading, spreading, count);
    for (int i = 1; i < count; ++i)
    {
        swAddSeaSums(spreading->sums + i, spreading->sums);
    }
    double worst = 0.0, worstIntegral = 0.0;
    for (int i = 0; i < BIN_COUNT; ++i)
    {
        double integral = 0.0;
        swDirectionMoments measured = swEstimateMoments(spreading->sums, i);
        swDirectionMoments model =
            AverageModel(&def->spectrum, spreading->bins.low[i], spreading->bins.high[i], &integral);
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
        swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
        char name[64];
        snprintf(name, sizeof(name), "cos\xc2\xb2\xcb\xa2, s = %.0f", exponents[i]);
        CheckSpreading(name, "[Longuet-Higgins 1963]", &def, 1.0 / 8.0, 512, 12);
    }
}

// Few waves: many seeds make up for it.
static void GerstnerSeasSpreadAsCosines(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.7, 10.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 32;
    CheckSpreading("Gerstner waves, cos\xc2\xb2\xcb\xa2, s = 10", "[Longuet-Higgins 1963]", &def, 1.0 / 8.0, 64, 160);
}

typedef struct Model
{
    swSpreadingKind kind;
    const char *name, *source;
    double exponents[7]; // s (or beta) at 0.5, 0.8, 0.95, 1.2, 1.6, 2 and 3 peak frequencies
} Model;

static void SeasSpreadByFrequencyAsPublished(void** state)
{
    (void)state;
    static const double ratios[7] = {0.5, 0.8, 0.95, 1.2, 1.6, 2.0, 3.0};
    // Of a wind of 10 m/s over 100 km, omega_p = 1.03912 rad/s.
    static const Model models[3] = {
        {SW_SPREADING_MITSUYASU, "Mitsuyasu's", "[Mitsuyasu 1975]", {0.311, 3.263, 7.706, 6.313, 3.075, 1.760, 0.639}},
        {SW_SPREADING_HASSELMANN,
         "Hasselmann's",
         "[Hasselmann 1980]",
         {0.418, 2.817, 5.660, 6.578, 3.524, 2.172, 0.901}},
        {SW_SPREADING_DONELAN_BANNER,
         "Donelan's and Banner's",
         "[Donelan 1985]",
         {1.0600, 1.9528, 2.4372, 1.7989, 1.2375, 0.9603, 0.6942}}};
    for (int i = 0; i < 3; ++i)
    {
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.fetch = 100e3f;
        spectrum.peakPeriod = (float)(TURN / 1.03912);
        spectrum.direction = 0.7f;
        spectrum.spreading = models[i].kind;
        double worst = 0.0;
        for (int j = 0; j < 7; ++j)
        {
            swDirectionMoments moments;
            double f = ratios[j] * 1.03912 / TURN, s = models[i].exponents[j];
            IntegrateModel(&spectrum, f, &moments);
            // r1 is s / (s + 1) of a cosine; of sech^2 it has no short form, so that is held by its density ahead.
            double ahead = (double)swSpectrum_GetSpreading(&spectrum, (float)f, 0.7f);
            double asked = models[i].kind == SW_SPREADING_DONELAN_BANNER ? 0.5 * s / tanh(SW_PI * s) : s / (s + 1.0);
            double got = models[i].kind == SW_SPREADING_DONELAN_BANNER ? ahead : hypot(moments.a1, moments.b1);
            worst = fmax(worst, fabs(got / asked - 1.0));
        }
        char what[128];
        snprintf(what, sizeof(what), "r1 or D(0) of %s spreading, 0.5 to 3 fp, worst", models[i].name);
        FindBelow(&(Finding){"V5", what, models[i].source, "%", 2}, 0.5, 100.0 * worst);
        swWaveSystemDef def = MakeWaves(&spectrum, 1.0, 4096.0, 1);
        snprintf(what, sizeof(what), "%s spreading", models[i].name);
        CheckSpreading(what, models[i].source, &def, 1.03912 / TURN, 512, 12);
    }
}

typedef struct PatchCase
{
    swSpectrumDef spectrum;
    swSeaPatches* patches[12];
} PatchCase;

static void LookAtSquares(void* context, int seed)
{
    PatchCase* looked = context;
    swWaveSystemDef def = MakeWaves(&looked->spectrum, 16.0, 1024.0, 1u + (uint32_t)seed);
    swWorld* world = CreateTruthSea(&def);
    swHost host = swDefaultHost();
    if (swCreateSeaPatches(&host, 16.0, 512.0, &looked->patches[seed]) != SW_SUCCESS ||
        swLookAtPatches(world, 50.0, (double)INFINITY, seed, looked->patches[seed]) != SW_SUCCESS)
    {
        abort();
    }
    swDestroyWorld(world);
}

// Energy and first moments of what the squares saw, over the frequencies of waves of 512 m to 16 m.
static double SumSquares(const swSeaPatches* patches, double low, double high, double* a1, double* b1)
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
        double energy = swEstimatePatchDensity(patches, f, theta, (double)INFINITY, 9.81) * (high - low) / FREQUENCIES *
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
    int count = Seeds(12);
    RunJobs(LookAtSquares, looked, count);
    for (int i = 1; i < count; ++i)
    {
        swAddSeaPatches(looked->patches[i], looked->patches[0]);
    }
    double low = swGetWaveFrequency(512.0, (double)INFINITY, 9.81),
           high = swGetWaveFrequency(16.0, (double)INFINITY, 9.81), a1, b1;
    double variance = SumSquares(looked->patches[0], low, high, &a1, &b1);
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
        swDestroySeaPatches(looked->patches[i]);
    }
    free(looked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NarrowAndWideSeasSpreadAsCosines),
        cmocka_unit_test(GerstnerSeasSpreadAsCosines),
        cmocka_unit_test(SeasSpreadByFrequencyAsPublished),
        cmocka_unit_test(SquaresOfTheSurfaceSeeTheSameSea),
    };
    BeginTruth("truth_spreading");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
