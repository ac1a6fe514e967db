// SPDX-License-Identifier: MIT
// V7, V8: how heights are distributed above fixed places.
//
// A linear sea (chop 0) is Gaussian. Where particles also move sideways, as those of Gerstner's waves do, crests are
// sharper than troughs: what lies above a place is h - X h' to second order, X being the sideways displacement. Nothing
// corrects for that silently; what it comes to is stated here.
//   - The mean lies below the resting level, by the integral of k S, which is k a^2 / 2 summed over waves.
//   - Of one regular wave the heights are skewed, by 3 k a / (2 sqrt 2). Of many independent waves they are not, to
//     this order: the third moment of h - X h' holds only products with the means of h X and h h', which are zero.
//   - The curvature of crests against that of troughs is what the eye sees; it is skewed in both.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define SEED_COUNT 16
#define POINT_COUNT 2048
// Between the three heights that give a curvature, m; waves are 8 m long at least.
#define SPACING 1.0
#define TIME_COUNT 4

// Sums of powers, of heights above fixed places and of curvature.
typedef struct Powers
{
    double count, one, two, three, four;
} Powers;

typedef struct ChoppyCase
{
    swWaveSystemDef def;
    Powers heights[SEED_COUNT], curvatures[SEED_COUNT];
    double unconverged[SEED_COUNT];
} ChoppyCase;

static void AddPowers(Powers* powers, double value)
{
    powers->count += 1.0;
    powers->one += value;
    powers->two += value * value;
    powers->three += value * value * value;
    powers->four += value * value * value * value;
}

static void MeasureSurface(void* context, int seed)
{
    ChoppyCase* choppy = context;
    swWaveSystemDef def = choppy->def;
    def.seed = 1u + (uint32_t)seed;
    swWorld* world = CreateTruthSea(&def);
    swPosXZ* points = malloc(3 * POINT_COUNT * sizeof(swPosXZ));
    float* heights = malloc(3 * POINT_COUNT * sizeof(float));
    if (points == NULL || heights == NULL)
    {
        abort();
    }
    for (int i = 0; i < 3 * POINT_COUNT; ++i)
    {
        double x = 0.7548776662466927 * (i / 3 + 1), z = 0.5698402909980532 * (i / 3 + 1);
        points[i] = (swPosXZ){23000.0 * (x - floor(x)) + SPACING * (i % 3 - 1), 23000.0 * (z - floor(z))};
    }
    swQueryDef query = swDefaultQueryDef();
    for (int time = 0; time < TIME_COUNT; ++time)
    {
        swQueryStats stats;
        swWorld_SetTime(world, 61.0 * time);
        swWorld_Step(world, 0.0);
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, 3 * POINT_COUNT, points,
                              &(swSurfaceSamples){.height = heights}, &stats);
        choppy->unconverged[seed] += 3 * POINT_COUNT - stats.convergedCount;
        for (int i = 0; i < 3 * POINT_COUNT; i += 3)
        {
            double left = (double)heights[i], middle = (double)heights[i + 1], right = (double)heights[i + 2];
            AddPowers(choppy->heights + seed, middle);
            AddPowers(choppy->curvatures + seed, (2.0 * middle - left - right) / (SPACING * SPACING));
        }
    }
    free(points);
    free(heights);
    swDestroyWorld(world);
}

// Mean, variance, skewness and kurtosis.
typedef struct Shape
{
    double mean, variance, skewness, kurtosis;
} Shape;

static Shape FindShape(const Powers* seeds, int count)
{
    Powers sum = {0};
    for (int i = 0; i < count; ++i)
    {
        sum.count += seeds[i].count;
        sum.one += seeds[i].one;
        sum.two += seeds[i].two;
        sum.three += seeds[i].three;
        sum.four += seeds[i].four;
    }
    double m1 = sum.one / sum.count, m2 = sum.two / sum.count, m3 = sum.three / sum.count, m4 = sum.four / sum.count;
    Shape shape = {.mean = m1, .variance = m2 - m1 * m1};
    double deviation = sqrt(shape.variance);
    shape.skewness = (m3 - 3.0 * m1 * m2 + 2.0 * m1 * m1 * m1) / (deviation * deviation * deviation);
    shape.kurtosis =
        (m4 - 4.0 * m1 * m3 + 6.0 * m1 * m1 * m2 - 3.0 * m1 * m1 * m1 * m1) / (shape.variance * shape.variance);
    return shape;
}

static void MeasureShapes(const swWaveSystemDef* def, Shape* heights, Shape* curvatures)
{
    ChoppyCase choppy = {.def = *def};
    int count = Seeds(SEED_COUNT);
    double unconverged = 0.0;
    RunJobs(MeasureSurface, &choppy, count);
    for (int i = 0; i < count; ++i)
    {
        unconverged += choppy.unconverged[i];
    }
    assert_true(unconverged == 0.0);
    *heights = FindShape(choppy.heights, count);
    *curvatures = FindShape(choppy.curvatures, count);
}

// Integrals of k S, m, and of S, m^2, over the waves that the def makes.
static double IntegrateSteepness(const swWaveSystemDef* def, double* variance)
{
    double low = swGetWaveFrequency((double)def->maxWavelength, (double)INFINITY, 9.81);
    double high = swGetWaveFrequency((double)def->minWavelength, (double)INFINITY, 9.81), sum = 0.0;
    const int count = 20000;
    for (int i = 0; i < count; ++i)
    {
        double f = low + (high - low) * (i + 0.5) / count, omega = TURN * f;
        double energy = (double)swSpectrum_GetDensity(&def->spectrum, (float)f) * (high - low) / count;
        *variance += energy;
        sum += omega * omega / 9.81 * energy;
    }
    return sum;
}

static void ALinearSeaIsGaussian(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
    def.chop = 0.0f;
    Shape heights, curvatures;
    MeasureShapes(&def, &heights, &curvatures);
    FindNear(&(Finding){"V7", "Mean of heights, JONSWAP, Hs 2 m, Tp 8 s, chop 0", "linear sea", "m", 3}, 0.0,
             heights.mean, Loosen(0.005));
    FindNear(&(Finding){"V7", "Skewness of the same", "linear sea", "", 3}, 0.0, heights.skewness, Loosen(0.02));
    FindNear(&(Finding){"V7", "Kurtosis of the same", "linear sea", "", 3}, 3.0, heights.kurtosis, Loosen(0.04));
    FindNear(&(Finding){"V7", "Skewness of their curvature", "linear sea", "", 3}, 0.0, curvatures.skewness,
             Loosen(0.02));
}

// A few hundred waves, and chance favours none of them.
static void AGerstnerSeaIsNearlyGaussian(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 32;
    def.chop = 0.0f;
    Shape heights, curvatures;
    MeasureShapes(&def, &heights, &curvatures);
    FindNear(&(Finding){"V7", "Skewness of heights, 32 Gerstner waves an octave, chop 0", "linear sea", "", 3}, 0.0,
             heights.skewness, Loosen(0.03));
    FindNear(&(Finding){"V7", "Kurtosis of the same", "linear sea", "", 3}, 3.0, heights.kurtosis, Loosen(0.1));
}

static void AChoppySeaIsWhatItIsStatedToBe(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
    Shape heights, curvatures;
    MeasureShapes(&def, &heights, &curvatures);
    double asked = 0.0, steepness = IntegrateSteepness(&def, &asked);
    FindWithin(&(Finding){"V8", "Mean of heights above fixed places, JONSWAP, Hs 2 m, Tp 8 s, chop 1",
                          "-\xe2\x88\xab k S, second order", "m", 4},
               -steepness, heights.mean, Loosen(0.1));
    FindNear(&(Finding){"V8", "Variance of the same over that of particles", "stated", "", 3}, 1.0,
             heights.variance / asked, Loosen(0.01));
    FindNear(&(Finding){"V8", "Skewness of the same", "0 to second order", "", 3}, 0.0, heights.skewness, Loosen(0.02));
    FindNear(&(Finding){"V8", "Kurtosis of the same", "stated", "", 3}, 3.0, heights.kurtosis, Loosen(0.04));
    FindNear(&(Finding){"V8", "Skewness of their curvature: crests are sharper", "stated", "", 3}, 0.47,
             curvatures.skewness, Loosen(0.03));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ALinearSeaIsGaussian),
        cmocka_unit_test(AGerstnerSeaIsNearlyGaussian),
        cmocka_unit_test(AChoppySeaIsWhatItIsStatedToBe),
    };
    BeginTruth("truth_choppy");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
