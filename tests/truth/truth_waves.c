// SPDX-License-Identifier: MIT
// V7: waves counted one by one, from one upward crossing of the resting level to the next, as in a buoy's record. In a
// narrow spectrum heights from crest to trough follow Rayleigh's law, and the highest of 1000 is what the law says. In
// a spectrum as broad as a wind sea's, heights are a few percent lower, as measured seas are.
//
// A sum of N waves of fixed heights is only nearly Gaussian: its kurtosis is 3 - 3 / (2 N) where they are equally high,
// so the highest waves are a little too rare. A Gerstner system by spectrum has at most 32 waves an octave, eleven in
// the narrow spectrum here; several of them with other seeds, each with its part of the energy, make up for that.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define SEED_COUNT 8
#define GAUGE_COUNT 48
#define MOST_WAVES 1100
#define SAMPLES 12 // a wave; extremes are those of the parabola through three samples

// One gauge, sample by sample.
typedef struct Counter
{
    double before, last; // samples
    double highest, lowest;
    int count;
    bool hasBegun;
    float heights[MOST_WAVES]; // from crest to trough
} Counter;

typedef struct WavesCase
{
    swSpectrumDef spectrum;
    int gerstnerCount; // systems of Gerstner waves; 0: one of transforms
    double shortest, longest, period;
    int waveCount;
    Counter* counters; // [SEED_COUNT][GAUGE_COUNT]
    double squares[SEED_COUNT], samples[SEED_COUNT];
} WavesCase;

static void AddSample(Counter* counter, double now)
{
    double before = counter->before, middle = counter->last;
    double bend = before - 2.0 * middle + now;
    bool isExtreme = (middle - before) * (now - middle) <= 0.0 && bend != 0.0;
    double extreme = isExtreme ? middle - 0.125 * (now - before) * (now - before) / bend : middle;
    counter->highest = fmax(counter->highest, extreme);
    counter->lowest = fmin(counter->lowest, extreme);
    if (middle < 0.0 && now >= 0.0)
    {
        if (counter->hasBegun && counter->count < MOST_WAVES)
        {
            counter->heights[counter->count++] = (float)(counter->highest - counter->lowest);
        }
        counter->hasBegun = true;
        counter->highest = counter->lowest = 0.0;
    }
    counter->before = middle;
    counter->last = now;
}

static swWorld* CreateCountedSea(const WavesCase* waves, int seed)
{
    swWaveSystemDef def = MakeWaves(&waves->spectrum, waves->shortest, waves->longest, 1u + (uint32_t)seed);
    if (waves->gerstnerCount == 0)
    {
        return CreateTruthSea(&def);
    }
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 32;
    def.weight = 1.0f / sqrtf((float)waves->gerstnerCount);
    swWorld* world = CreateTruthSea(&def);
    for (int i = 1; i < waves->gerstnerCount; ++i)
    {
        swWaveSystemId id;
        def.seed = 1u + (uint32_t)(seed + 100 * i);
        if (swCreateWaveSystem(world, &def, &id) != SW_SUCCESS)
        {
            abort();
        }
    }
    return world;
}

static void CountWaves(void* context, int seed)
{
    WavesCase* waves = context;
    swWorld* world = CreateCountedSea(waves, seed);
    swQueryDef query = swDefaultQueryDef();
    swPosXZ points[GAUGE_COUNT];
    swVec3 displacement[GAUGE_COUNT];
    for (int i = 0; i < GAUGE_COUNT; ++i)
    {
        double x = 0.7548776662466927 * (i + 1), z = 0.5698402909980532 * (i + 1);
        points[i] = (swPosXZ){20000.0 * (x - floor(x)), 20000.0 * (z - floor(z))};
    }
    for (int j = 0; j < SAMPLES * waves->waveCount; ++j)
    {
        swWorld_SetTime(world, waves->period / SAMPLES * j);
        swWorld_Step(world, 0.0);
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, GAUGE_COUNT, points,
                                &(swSurfaceSamples){.displacement = displacement}, NULL, NULL);
        for (int i = 0; i < GAUGE_COUNT; ++i)
        {
            double h = (double)displacement[i].y;
            AddSample(waves->counters + seed * GAUGE_COUNT + i, h);
            waves->squares[seed] += h * h;
        }
        waves->samples[seed] += GAUGE_COUNT;
    }
    swDestroyWorld(world);
}

static int CompareHeights(const void* a, const void* b)
{
    float x = *(const float*)a, y = *(const float*)b;
    return (x > y) - (x < y);
}

// All heights over Hm0, gauge after gauge.
static float* ListHeights(const WavesCase* waves, int seeds, int* count)
{
    double squares = 0.0, samples = 0.0;
    for (int i = 0; i < seeds; ++i)
    {
        squares += waves->squares[i];
        samples += waves->samples[i];
    }
    float* heights = malloc((size_t)seeds * GAUGE_COUNT * MOST_WAVES * sizeof(float));
    assert_non_null(heights);
    *count = 0;
    for (int i = 0; i < seeds * GAUGE_COUNT; ++i)
    {
        for (int j = 0; j < waves->counters[i].count; ++j)
        {
            heights[(*count)++] = (float)((double)waves->counters[i].heights[j] / (4.0 * sqrt(squares / samples)));
        }
    }
    return heights;
}

// Mean of the highest of `size` waves. Waves of a narrow spectrum come in groups, so neighbours say the same twice: the
// waves of a sample are taken far apart.
static double FindMeanHighest(const float* heights, int count, int size)
{
    int stride = count / size;
    double sum = 0.0;
    for (int sample = 0; sample < stride; ++sample)
    {
        double highest = 0.0;
        for (int i = 0; i < size; ++i)
        {
            highest = fmax(highest, (double)heights[sample + i * stride]);
        }
        sum += highest;
    }
    return sum / stride;
}

static double FindMeanOfHighest(const float* heights, int count, double part)
{
    int first = count - (int)(part * count);
    double sum = 0.0;
    for (int i = first; i < count; ++i)
    {
        sum += (double)heights[i];
    }
    return sum / (count - first);
}

static double FindShareAbove(const float* heights, int count, double height)
{
    int above = 0;
    for (int i = count; i > 0 && (double)heights[i - 1] > height; --i)
    {
        above += 1;
    }
    return (double)above / count;
}

static void MeasureWaves(WavesCase* waves, int seeds)
{
    waves->period = (double)waves->spectrum.peakPeriod;
    waves->counters = calloc(SEED_COUNT * GAUGE_COUNT, sizeof(Counter));
    assert_non_null(waves->counters);
    RunJobs(CountWaves, waves, seeds);
}

// 100 m at the peak, and 12 percent more or less.
static void CheckNarrowSea(const char* sea, int gerstnerCount)
{
    WavesCase waves = {
        .spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 5.0),
        .gerstnerCount = gerstnerCount,
        .shortest = 88.0,
        .longest = 112.0,
        .waveCount = 1040,
    };
    int count, seeds = Seeds(SEED_COUNT);
    MeasureWaves(&waves, seeds);
    float* heights = ListHeights(&waves, seeds, &count);
    double highest = FindMeanHighest(heights, count, 1000);
    qsort(heights, (size_t)count, sizeof(float), CompareHeights);
    static const double levels[4] = {0.5, 1.0, 1.5, 2.0}, tolerances[4] = {0.02, 0.04, 0.08, 0.3};
    const char* const source = "[Longuet-Higgins 1952]";
    char what[128];
    for (int i = 0; i < 4; ++i)
    {
        snprintf(what, sizeof(what), "Share of waves higher than %.1f Hs, %s", levels[i], sea);
        FindWithin(&(Finding){"V7", what, "exp(-2 (h / Hs)\xc2\xb2)", "", 5}, exp(-2.0 * levels[i] * levels[i]),
                   FindShareAbove(heights, count, levels[i]), Loosen(tolerances[i]));
    }
    snprintf(what, sizeof(what), "Mean of the highest third over Hs, %s", sea);
    FindWithin(&(Finding){"V7", what, source, "", 3}, 1.0011, FindMeanOfHighest(heights, count, 1.0 / 3.0),
               Loosen(0.01));
    snprintf(what, sizeof(what), "Mean of the highest tenth over Hs, %s", sea);
    FindWithin(&(Finding){"V7", what, source, "", 3}, 1.2727, FindMeanOfHighest(heights, count, 0.1), Loosen(0.015));
    snprintf(what, sizeof(what), "Highest of 1000 independent waves over Hs, mean, %s", sea);
    FindWithin(&(Finding){"V7", what, source, "", 3}, 1.936, highest, Loosen(0.03));
    free(heights);
    free(waves.counters);
}

static void HeightsInANarrowSpectrumAreRayleighs(void** state)
{
    (void)state;
    CheckNarrowSea("narrow spectrum", 0);
}

static void HeightsOfManyGerstnerWavesAreRayleighs(void** state)
{
    (void)state;
    CheckNarrowSea("narrow spectrum, 12 systems of Gerstner waves", 12);
}

static void CheckWindSea(const char* sea, int gerstnerCount)
{
    WavesCase waves = {
        .spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0),
        .gerstnerCount = gerstnerCount,
        .shortest = 16.0,
        .longest = 1024.0,
        .waveCount = 200,
    };
    int count, seeds = Seeds(SEED_COUNT);
    MeasureWaves(&waves, seeds);
    float* heights = ListHeights(&waves, seeds, &count);
    qsort(heights, (size_t)count, sizeof(float), CompareHeights);
    char what[128];
    snprintf(what, sizeof(what), "Mean of the highest third over Hs, %s", sea);
    FindBetween(&(Finding){"V7", what, "measured seas", "", 3}, 0.92, 0.99,
                FindMeanOfHighest(heights, count, 1.0 / 3.0));
    free(heights);
    free(waves.counters);
}

static void HeightsInAWindSeaAreALittleLower(void** state)
{
    (void)state;
    CheckWindSea("JONSWAP", 0);
    CheckWindSea("JONSWAP, 32 Gerstner waves an octave", 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(HeightsInANarrowSpectrumAreRayleighs),
        cmocka_unit_test(HeightsOfManyGerstnerWavesAreRayleighs),
        cmocka_unit_test(HeightsInAWindSeaAreALittleLower),
    };
    BeginTruth("truth_waves");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
