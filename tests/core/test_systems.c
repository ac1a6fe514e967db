// SPDX-License-Identifier: MIT

// Wave systems that change while they run, share their waves, or are made of free waves.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "core/world/world.h"
#include "support/counting_host.h"
#include <seaway/seaway.h>

static swWaveSystemDef MakeDef(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.minWavelength = 2.0f;
    def.maxWavelength = 512.0f;
    return def;
}

typedef struct Sea
{
    swWorld* world;
    swWaveSystemId waves;
} Sea;

static Sea OpenSea(const swWaveSystemDef* def)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    Sea sea = {0};
    assert_int_equal(swCreateWorld(&host, &worldDef, &sea.world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(sea.world, def, &sea.waves), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
    return sea;
}

// Heights of particles at rest points, so that only time and the sea itself move them.
enum
{
    POINTS = 400
};
static void GetHeights(const swWorld* world, float heights[POINTS])
{
    swPosXZ points[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){(double)(i % 20) * 37.3, (double)(i / 20) * 41.9};
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = heights};
    swMoment_QueryParticles(swWorld_GetMoment(world), &def, POINTS, points, &samples, NULL, NULL);
}

static float GetVariance(const swWorld* world)
{
    const swFrame* frame = swGetWorldFrame(world);
    float variance = 0.0f;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        variance += frame->tiles[i].variance;
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        variance += 0.5f * frame->waves[i].amplitude * frame->waves[i].amplitude;
    }
    return variance;
}

// The largest change of a height in one step, over a change that begins now and takes `seconds`, and some time after.
static double FindLargestStep(const Sea* sea, double dt, double seconds)
{
    float before[POINTS], after[POINTS];
    double largest = 0.0;
    GetHeights(sea->world, before);
    for (int step = 0; step < (int)(seconds / dt) + 20; ++step)
    {
        assert_int_equal(swWorld_Step(sea->world, dt), SW_SUCCESS);
        GetHeights(sea->world, after);
        for (int i = 0; i < POINTS; ++i)
        {
            largest = fmax(largest, fabs((double)after[i] - (double)before[i]));
        }
        memcpy(before, after, sizeof before);
    }
    return largest;
}

typedef void (*Change)(swWaveSystemDef* def);

static void ChangeWind(swWaveSystemDef* def)
{
    def->spectrum.windSpeed = 14.0f;
    def->spectrum.direction = 1.0f;
}
static void ChangeKind(swWaveSystemDef* def)
{
    def->spectrum.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
    def->chop = 0.4f;
    def->maxWavelength = 300.0f;
}
static void ChangeToSwell(swWaveSystemDef* def)
{
    def->spectrum = swMakeSwellSpectrum(1.2f, 9.0f, 0.4f, 0.15f);
}
static void ChangeSeed(swWaveSystemDef* def)
{
    def->seed = 99;
}
static void ChangeDepth(swWaveSystemDef* def)
{
    def->spectrum.depth = 12.0f;
}
static void ChangeTiles(swWaveSystemDef* def)
{
    def->tileWaves = 8;
    def->resolution = 32;
}
static void ChangeLoop(swWaveSystemDef* def)
{
    def->loopPeriod = 60.0f;
}
static void ChangeMethod(swWaveSystemDef* def)
{
    def->method = SW_WAVES_GERSTNER;
}
static void ChangeWeight(swWaveSystemDef* def)
{
    def->weight = 0.3f;
}

static const struct
{
    const char* name;
    Change change;
} changes[] = {
    {"wind and direction", ChangeWind},
    {"kind, chop, lengths", ChangeKind},
    {"a narrow swell", ChangeToSwell}, // some bands get parallel tiles
    {"seed", ChangeSeed},
    {"depth", ChangeDepth},
    {"tiles", ChangeTiles},
    {"loop", ChangeLoop},
    {"method", ChangeMethod},
    {"weight", ChangeWeight},
};
enum
{
    CHANGES = sizeof changes / sizeof changes[0]
};

static void NothingJumpsWhateverChanges(void** state)
{
    (void)state;
    const double dt = 1.0 / 60.0;
    for (int c = 0; c < CHANGES; ++c)
    {
        swWaveSystemDef def = MakeDef();
        swWaveSystemDef other = def;
        changes[c].change(&other);
        Sea calm = OpenSea(&other);
        double usual = FindLargestStep(&calm, dt, 2.0);
        swDestroyWorld(calm.world);
        Sea sea = OpenSea(&def);
        usual = fmax(usual, FindLargestStep(&sea, dt, 2.0));
        assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &other, 4.0), SW_SUCCESS);
        double largest = FindLargestStep(&sea, dt, 4.0);
        print_message("%-20s largest step %.4f m, of a sea that stays %.4f m\n", changes[c].name, largest, usual);
        assert_true(largest < 1.6 * usual);
        swDestroyWorld(sea.world);
    }
}

static void WhatChangesBackGivesTheSameBits(void** state)
{
    (void)state;
    for (int c = 0; c < CHANGES; ++c)
    {
        swWaveSystemDef def = MakeDef();
        swWaveSystemDef other = def;
        changes[c].change(&other);
        Sea sea = OpenSea(&def);
        swWorld_SetTime(sea.world, 100.0);
        swWorld_Step(sea.world, 0.0);
        uint64_t wanted = swWorld_GetDigest(sea.world);
        swWorld_SetTime(sea.world, 0.0);
        swWorld_Step(sea.world, 0.0);
        for (int gently = 0; gently < 2; ++gently)
        {
            double seconds = gently ? 3.0 : 0.0;
            assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &other, seconds), SW_SUCCESS);
            swWorld_Step(sea.world, 2.0);
            assert_int_not_equal(swWorld_GetDigest(sea.world), wanted);
            swWorld_Step(sea.world, 2.0);
            assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &def, seconds), SW_SUCCESS);
            swWorld_Step(sea.world, 2.0);
            swWorld_Step(sea.world, 2.0);
            swWorld_SetTime(sea.world, 100.0);
            swWorld_Step(sea.world, 0.0);
            assert_int_equal(swWorld_GetDigest(sea.world), wanted);
            swWorld_SetTime(sea.world, 0.0);
            swWorld_Step(sea.world, 0.0);
        }
        swDestroyWorld(sea.world);
    }
}

static void EnergyStaysOnTheWay(void** state)
{
    (void)state;
    for (int c = 0; c < CHANGES - 1; ++c)
    {
        swWaveSystemDef def = MakeDef();
        swWaveSystemDef other = def;
        changes[c].change(&other);
        Sea end = OpenSea(&other);
        float last = GetVariance(end.world);
        swDestroyWorld(end.world);
        Sea sea = OpenSea(&def);
        float first = GetVariance(sea.world);
        assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &other, 8.0), SW_SUCCESS);
        for (int step = 0; step <= 8; ++step)
        {
            float share = (float)step / 8.0f;
            float variance = GetVariance(sea.world);
            float least = fminf(first, last), most = fmaxf(first, last);
            assert_true(variance > 0.999f * least && variance < 1.001f * most);
            if (sea.world->waves.systems[0].partCount == 1)
            {
                assert_float_equal(variance / (first + (last - first) * share), 1.0f, 1e-3f);
            }
            swWorld_Step(sea.world, 1.0);
        }
        swDestroyWorld(sea.world);
    }
}

// The same with what the modes say, not what the bands do.
static void AMixHasTheVarianceThatItSays(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeDef();
    swWaveSystemDef other = def;
    other.spectrum.direction = 1.57f; // hardly a wave in common
    Sea sea = OpenSea(&def);
    assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &other, 2.0), SW_SUCCESS);
    swWorld_Step(sea.world, 1.0);
    const swFrame* frame = swGetWorldFrame(sea.world);
    double measured = 0.0, said = 0.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        double sum = 0.0;
        for (int z = 1; z <= tile->resolution; ++z)
        {
            for (int x = 1; x <= tile->resolution; ++x)
            {
                // Samples of the spline at its knots: 1 4 1 / 6 along each axis.
                double value = 0.0;
                for (int j = -1; j <= 1; ++j)
                {
                    for (int k = -1; k <= 1; ++k)
                    {
                        double weight = (j == 0 ? 4.0 : 1.0) * (k == 0 ? 4.0 : 1.0) / 36.0;
                        value +=
                            weight *
                            (double)tile
                                ->texels[((size_t)(z + j) * (size_t)(tile->resolution + 3) + (size_t)(x + k)) * 4 + 1];
                    }
                }
                sum += value * value;
            }
        }
        measured += sum / (tile->resolution * tile->resolution);
        said += (double)tile->variance;
    }
    // At one moment: opposite waves of a pair interfere.
    print_message("variance %.4f m^2, said %.4f m^2\n", measured, said);
    assert_true(fabs(measured / said - 1.0) < 0.03);
    swDestroyWorld(sea.world);
}

static void AChangeMayInterruptAnother(void** state)
{
    (void)state;
    const double dt = 1.0 / 60.0;
    swWaveSystemDef def = MakeDef();
    Sea sea = OpenSea(&def);
    double usual = FindLargestStep(&sea, dt, 2.0);
    double largest = 0.0;
    for (int round = 0; round < 3; ++round)
    {
        for (int c = 0; c < 3; ++c)
        {
            swWaveSystemDef other = def;
            changes[c].change(&other);
            other.weight = 0.8f + 0.1f * (float)c;
            assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &other, 2.0), SW_SUCCESS);
            largest = fmax(largest, FindLargestStep(&sea, dt, 0.4));
        }
        FindLargestStep(&sea, 0.1, 3.0);
    }
    print_message("largest step %.4f m, usual %.4f m\n", largest, usual);
    assert_true(largest < 3.0 * usual); // 14 m/s has waves of twice the height
    swDestroyWorld(sea.world);
}

static void CrossFadesHaveALimitAndRefusingChangesNothing(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeDef();
    Sea sea = OpenSea(&def);
    swResult result = SW_SUCCESS;
    int made = 0;
    while (made < 10 && result == SW_SUCCESS)
    {
        def.seed += 1;
        result = swWaveSystem_Set(sea.world, sea.waves, &def, 10.0);
        made += result == SW_SUCCESS ? 1 : 0;
        swWorld_Step(sea.world, 0.1);
    }
    assert_int_equal(result, SW_ERROR_LIMIT);
    assert_int_equal(made, SW_MAX_WAVE_PARTS - 1);
    assert_int_equal(swWaveSystem_Get(sea.world, sea.waves).seed, def.seed - 1);
    swWorld_Step(sea.world, 11.0);
    assert_int_equal(sea.world->waves.systems[0].partCount, 1);
    assert_int_equal(swWaveSystem_Set(sea.world, sea.waves, &def, 10.0), SW_SUCCESS);
    swDestroyWorld(sea.world);
}

static void SystemsThatAskForTheSameShareTheirWaves(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeDef();
    Sea sea = OpenSea(&def);
    int tiles = swGetWorldFrame(sea.world)->tileCount;
    size_t memory = swWorld_GetMemory(sea.world);
    float one[POINTS], two[POINTS];
    GetHeights(sea.world, one);
    swWaveSystemId second;
    def.weight = 0.5f;
    assert_int_equal(swCreateWaveSystem(sea.world, &def, &second), SW_SUCCESS);
    swWorld_Step(sea.world, 0.0);
    assert_int_equal(swGetWorldFrame(sea.world)->tileCount, tiles);
    assert_int_equal(swWorld_GetMemory(sea.world), memory);
    GetHeights(sea.world, two);
    for (int i = 0; i < POINTS; ++i)
    {
        assert_float_equal(two[i], 1.5f * one[i], 1e-5f);
    }
    // One of them goes its own way.
    swWaveSystemDef other = def;
    other.seed = 5;
    assert_int_equal(swWaveSystem_Set(sea.world, second, &other, 0.0), SW_SUCCESS);
    swDestroyWaveSystem(sea.world, sea.waves);
    swWorld_Step(sea.world, 0.0);
    assert_int_equal(swGetWorldFrame(sea.world)->tileCount, tiles);
    assert_int_equal(swWorld_GetMemory(sea.world), memory);
    swDestroyWorld(sea.world);
}

static void WavesWithoutWeightCostNothing(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeDef();
    Sea sea = OpenSea(&def);
    swWaveSystem_FadeWeight(sea.world, sea.waves, 0.0f, 2.0);
    swWorld_Step(sea.world, 1.0);
    assert_float_equal(swWaveSystem_GetWeight(sea.world, sea.waves), 0.5f, 1e-6f);
    assert_true(swGetWorldFrame(sea.world)->tileCount > 0);
    swWorld_Step(sea.world, 1.0);
    assert_int_equal(swGetWorldFrame(sea.world)->tileCount, 0);
    swWaveSystem_SetWeight(sea.world, sea.waves, 1.0f);
    swWorld_Step(sea.world, 0.0);
    assert_true(swGetWorldFrame(sea.world)->tileCount > 0);
    swDestroyWorld(sea.world);
}

static void EveryAllocationOfAChangeMayFail(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    for (int c = 0; c < CHANGES; ++c)
    {
        swWorldDef worldDef = swDefaultWorldDef();
        worldDef.enableVelocity = true;
        swWorld* world;
        swWaveSystemId waves;
        swWaveSystemDef def = MakeDef();
        def.resolution = 32;
        def.tileWaves = 8;
        swWaveSystemDef other = def;
        changes[c].change(&other);
        assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
        assert_int_equal(swCreateWaveSystem(world, &def, &waves), SW_SUCCESS);
        swWorld_Step(world, 0.0);
        uint64_t digest = swWorld_GetDigest(world);
        for (int fail = 0;; ++fail)
        {
            assert_true(fail < 1000);
            atomic_store(&memory.failAt, atomic_load(&memory.allocations) + fail);
            swResult result = swWaveSystem_Set(world, waves, &other, 1.0);
            atomic_store(&memory.failAt, -1);
            if (result == SW_SUCCESS)
            {
                break;
            }
            assert_int_equal(result, SW_ERROR_NO_MEMORY);
            swWorld_Step(world, 0.0);
            assert_int_equal(swWorld_GetDigest(world), digest);
        }
        swWorld_Step(world, 0.5);
        swDestroyWorld(world);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
}

static void AStepThatChangesTheSeaAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    swWaveSystemId waves;
    swWaveSystemDef def = MakeDef();
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(world, &def, &waves), SW_SUCCESS);
    swWorld_Step(world, 0.0);
    for (int c = 0; c < CHANGES; ++c)
    {
        swWaveSystemDef other = def;
        changes[c].change(&other);
        assert_int_equal(swWaveSystem_Set(world, waves, &other, 1.0), SW_SUCCESS);
        long long before = atomic_load(&memory.allocations);
        for (int step = 0; step < 12; ++step)
        {
            swWorld_Step(world, 0.1);
        }
        assert_int_equal(atomic_load(&memory.allocations), before);
    }
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- parallel tiles ----

static void NarrowSwellsHaveParallelTiles(void** state)
{
    (void)state;
    static const float periods[] = {7.0f, 8.0f, 10.0f, 12.0f, 14.0f, 18.0f};
    for (int i = 0; i < 12; ++i)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        bool isSwell = i < 6;
        def.spectrum = isSwell ? swMakeSwellSpectrum(2.0f, periods[i], 0.4f, 0.05f * (float)(i % 4 + 2))
                               : swMakeBeaufortSpectrum((float)(2 * i - 10), 0.4f);
        Sea sea = OpenSea(&def);
        const swFrame* frame = swGetWorldFrame(sea.world);
        swBandInfo bands[SW_MAX_BANDS];
        int count = swWaveSystem_GetBands(sea.world, sea.waves, bands), tiles = 0;
        double variance = 0.0;
        for (int k = 0; k < count; ++k)
        {
            tiles += bands[k].tileCount;
            variance += (double)bands[k].variance;
        }
        double largest = 0.0;
        for (int k = 0; k < frame->tileCount; ++k)
        {
            largest = fmax(largest, (double)frame->tiles[k].variance / variance);
            assert_true(k == 0 || frame->tiles[k].minWavelength >= frame->tiles[k - 1].minWavelength);
        }
        print_message("%s %d: %d bands, %d tiles, the largest has %.0f %% of the energy\n",
                      isSwell ? "swell" : "wind sea", i % 6, count, tiles, 100.0 * largest);
        assert_int_equal(tiles, frame->tileCount);
        assert_true(isSwell ? tiles > count && tiles <= count + 3 && largest < 0.3 : tiles == count);
        double height = (double)def.spectrum.significantHeight;
        assert_true(fabs(4.0 * sqrt(variance) / height - 1.0) < 2e-3);
        swDestroyWorld(sea.world);
    }
}

// ---- free waves ----

static void AGerstnerSeaHasTheEnergyOfItsSpectrum(void** state)
{
    (void)state;
    swWaveSystemDef def = swDefaultWaveSystemDef();
    swSeaState asked;
    assert_int_equal(swSpectrum_GetSeaState(&def.spectrum, 0.0f, 0.0f, &asked), SW_SUCCESS);
    for (int reverse = 0; reverse < 2; ++reverse)
    {
        def.method = SW_WAVES_GERSTNER;
        def.reverseWeight = reverse ? 0.5f : 0.0f;
        Sea sea = OpenSea(&def);
        float height = 4.0f * sqrtf(GetVariance(sea.world));
        print_message("Hs %.4f m of %d waves, asked %.4f m\n", (double)height, swGetWorldFrame(sea.world)->waveCount,
                      (double)asked.significantHeight);
        assert_float_equal(height / asked.significantHeight, 1.0f, 2e-3f);
        swBandInfo bands[SW_MAX_BANDS];
        assert_true(swWaveSystem_GetBands(sea.world, sea.waves, bands) > 10);
        swDestroyWorld(sea.world);
    }
}

static int CompareFloats(const void* a, const void* b)
{
    float x = *(const float*)a, y = *(const float*)b;
    return x < y ? -1 : x > y ? 1 : 0;
}

#define FOLD_POINTS 100000

// The Jacobian that one place in ten thousand is below, over places and times.
static float FindRareJacobian(const swWaveSystemDef* def, float* height)
{
    static swPosXZ points[FOLD_POINTS / 4];
    static float jacobians[FOLD_POINTS];
    Sea sea = OpenSea(def);
    swQueryDef query = swDefaultQueryDef();
    for (int k = 0; k < 4; ++k)
    {
        swWorld_SetTime(sea.world, 100.0 * k);
        swWorld_Step(sea.world, 0.0);
        for (int i = 0; i < FOLD_POINTS / 4; ++i)
        {
            points[i] = (swPosXZ){fmod(7919.37 * i, 6000.0), fmod(104729.71 * i, 6173.0)};
        }
        swSurfaceSamples samples = {.jacobian = jacobians + (size_t)k * (FOLD_POINTS / 4)};
        swMoment_QueryParticles(swWorld_GetMoment(sea.world), &query, FOLD_POINTS / 4, points, &samples, NULL, NULL);
    }
    *height = 4.0f * sqrtf(GetVariance(sea.world));
    swDestroyWorld(sea.world);
    qsort(jacobians, FOLD_POINTS, sizeof(float), CompareFloats);
    return jacobians[FOLD_POINTS / 10000];
}

// The fetch of an hour in a storm, an equaliser turned up, more chop than there is, many waves and few, twins, a ready
// sea.
static swWaveSystemDef MakeFoldingCase(int i)
{
    static const int counts[] = {8, 1, 3, 32, 8, 8, 8};
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.spectrum.windSpeed = i < 4 ? 30.0f : 15.0f;
    def.spectrum.fetch = i < 4 ? 3e3f : 300e3f;
    def.componentsPerOctave = counts[i];
    def.chop = i == 1 || i == 4 || i == 6 ? 2.0f : 1.0f;
    if (i == 5)
    {
        def.spectrum.kind = SW_SPECTRUM_OCTAVES;
        def.spectrum.octaves.chop = 2.0f;
        def.spectrum.octaves.multiplier = 1.5f;
    }
    def.reverseWeight = i == 6 ? 1.0f : 0.0f;
    return def;
}

static void AGerstnerSeaFoldsNoMoreThanAsked(void** state)
{
    (void)state;
    for (int i = 0; i < 7; ++i)
    {
        swWaveSystemDef def = MakeFoldingCase(i);
        float free = 0.0f, height = 0.0f, other = 0.0f;
        def.leastJacobian = -10.0f;
        free = FindRareJacobian(&def, &height);
        def.leastJacobian = 0.1f;
        float held = FindRareJacobian(&def, &other);
        assert_true(other == height);
        def.leastJacobian = 0.5f;
        float firm = FindRareJacobian(&def, &other);
        assert_true(other == height);
        print_message("case %d, Hs %.2f m: one place in 10,000 is below %.3f, held %.3f, %.3f\n", i, (double)height,
                      (double)free, (double)held, (double)firm);
        assert_true(free < 0.1f);
        assert_true(held > 0.1f && held < 0.4f);
        assert_true(firm > 0.5f && firm < 0.7f);
    }
    // A sea that folds less stays as it is.
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    float height = 0.0f, other = 0.0f, asked = FindRareJacobian(&def, &height);
    def.leastJacobian = -10.0f;
    assert_true(FindRareJacobian(&def, &other) == asked && other == height && asked > 0.3f);
}

static void AGivenWaveIsJustThatWave(void** state)
{
    (void)state;
    const swWaveComponent wave = {.wavelength = 40.0f, .direction = 0.7f, .amplitude = 0.9f, .phase = 1.1f};
    for (int shallow = 0; shallow < 2; ++shallow)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.method = SW_WAVES_GERSTNER;
        def.components = &wave;
        def.componentCount = 1;
        double depth = shallow ? 6.0 : (double)INFINITY;
        def.spectrum.depth = (float)depth;
        Sea sea = OpenSea(&def);
        double k = 2.0 * SW_PI / 40.0;
        double tension = 7.4e-5;
        double omega = sqrt((9.81 * k + tension * k * k * k) * (shallow ? tanh(k * depth) : 1.0));
        double worst = 0.0;
        for (int i = 0; i < 200; ++i)
        {
            double time = 0.37 * i;
            swWorld_SetTime(sea.world, time);
            swWorld_Step(sea.world, 0.0);
            swPosXZ point = {1e6 + 3.1 * i, -2e5 + 1.7 * i * i};
            swQueryDef query = swDefaultQueryDef();
            swVec3 d;
            swSurfaceSamples samples = {.displacement = &d};
            swMoment_QueryParticles(swWorld_GetMoment(sea.world), &query, 1, &point, &samples, NULL, NULL);
            double theta = k * (cos((double)wave.direction) * point.x + sin((double)wave.direction) * point.z) -
                           omega * time + (double)wave.phase;
            double side = -0.9 * sin(theta) * (shallow ? 1.0 / tanh(k * depth) : 1.0);
            worst = fmax(worst, fabs((double)d.y - 0.9 * cos(theta)));
            worst = fmax(worst, fabs((double)d.x - side * cos((double)wave.direction)));
            worst = fmax(worst, fabs((double)d.z - side * sin((double)wave.direction)));
        }
        print_message("worst difference to the formula, 1,000 km out: %.2g m\n", worst);
        assert_true(worst < 2e-4); // wavelength is a float
        swDestroyWorld(sea.world);
    }
}

static void GerstnerSeasLoopToTheBit(void** state)
{
    (void)state;
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.loopPeriod = 64.0f;
    Sea sea = OpenSea(&def);
    float first[POINTS], later[POINTS];
    swWorld_SetTime(sea.world, 3.25);
    swWorld_Step(sea.world, 0.0);
    GetHeights(sea.world, first);
    swWorld_SetTime(sea.world, 3.25 + 64.0 * 12345.0);
    swWorld_Step(sea.world, 0.0);
    GetHeights(sea.world, later);
    assert_memory_equal(first, later, sizeof first);
    swDestroyWorld(sea.world);
}

static void InstructionSetsAgreeOnFreeWavesAndOneByOneSums(void** state)
{
    (void)state;
    static float wanted[5][POINTS];
    bool isFirst = true;
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        swHost host = swDefaultHost();
        host.log = NULL;
        swWorldDef worldDef = swDefaultWorldDef();
        worldDef.isa = (swIsa)isa;
        swWorld* world;
        if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
        {
            continue;
        }
        swWaveSystemDef def = MakeDef();
        def.spectrum.depth = 30.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        def.method = SW_WAVES_GERSTNER;
        def.spectrum.direction = 2.0f;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        swWorld_Step(world, 12.0);
        static float got[5][POINTS];
        static swPosXZ points[POINTS];
        static swPos places[POINTS];
        static swVec3 velocity[POINTS], below[POINTS];
        for (int i = 0; i < POINTS; ++i)
        {
            points[i] = (swPosXZ){13.7 * i - 900.0, 0.31 * i * i};
            places[i] = (swPos){points[i].x, -0.05 * i, points[i].z};
        }
        swQueryDef query = swDefaultQueryDef();
        query.time = -77.7;
        swSurfaceSamples surface = {.height = got[0], .velocity = velocity};
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &surface, NULL);
        swVolumeSamples volume = {.velocity = below, .pressureHead = got[1]};
        swMoment_QueryVolume(swWorld_GetMoment(world), &query, POINTS, places, &volume, NULL);
        for (int i = 0; i < POINTS; ++i)
        {
            got[2][i] = velocity[i].x;
            got[3][i] = below[i].z;
        }
        query.time = SW_QUERY_NOW;
        surface = (swSurfaceSamples){.height = got[4]};
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &surface, NULL);
        if (isFirst)
        {
            memcpy(wanted, got, sizeof got);
        }
        assert_memory_equal(wanted, got, sizeof got);
        isFirst = false;
        swDestroyWorld(world);
    }
}

static void CountWarnings(void* context, swLogLevel level, const char* message)
{
    int* count = context;
    *count += level == SW_LOG_WARNING && strstr(message, "a seed of its own") != NULL ? 1 : 0;
}

static void SystemsOfOneSeedAreWarnedOf(void** state)
{
    (void)state;
    int count = 0;
    swHost host = swDefaultHost();
    host.log = CountWarnings;
    host.logContext = &count;
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef sea = swDefaultWaveSystemDef(), swell = sea;
    sea.resolution = swell.resolution = 32;
    sea.tileWaves = swell.tileWaves = 8;
    swell.spectrum = swMakeSwellSpectrum(2.0f, 8.0f, 0.3f, 0.3f);
    swWaveSystemId first, second;
    assert_int_equal(swCreateWaveSystem(world, &sea, &first), SW_SUCCESS);
    assert_int_equal(count, 0);
    assert_int_equal(swCreateWaveSystem(world, &swell, &second), SW_SUCCESS);
    assert_int_equal(count, 1); // most of the swell's waves are waves of the sea
    swell.seed = 2;
    assert_int_equal(swWaveSystem_Set(world, second, &swell, 1.0), SW_SUCCESS);
    assert_int_equal(count, 1);
    swell.seed = 1;
    assert_int_equal(swWaveSystem_Set(world, second, &swell, 1.0), SW_SUCCESS);
    assert_int_equal(count, 2);
    swDestroyWaveSystem(world, second);
    assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
    swell.spectrum = swMakeSwellSpectrum(2.0f, 22.0f, 0.3f, 0.3f); // hardly a wave in common
    swell.minWavelength = 256.0f;
    assert_int_equal(swCreateWaveSystem(world, &swell, &second), SW_SUCCESS);
    assert_int_equal(count, 2);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NothingJumpsWhateverChanges),
        cmocka_unit_test(WhatChangesBackGivesTheSameBits),
        cmocka_unit_test(EnergyStaysOnTheWay),
        cmocka_unit_test(AMixHasTheVarianceThatItSays),
        cmocka_unit_test(AChangeMayInterruptAnother),
        cmocka_unit_test(CrossFadesHaveALimitAndRefusingChangesNothing),
        cmocka_unit_test(SystemsThatAskForTheSameShareTheirWaves),
        cmocka_unit_test(WavesWithoutWeightCostNothing),
        cmocka_unit_test(EveryAllocationOfAChangeMayFail),
        cmocka_unit_test(AStepThatChangesTheSeaAllocatesNothing),
        cmocka_unit_test(NarrowSwellsHaveParallelTiles),
        cmocka_unit_test(AGerstnerSeaHasTheEnergyOfItsSpectrum),
        cmocka_unit_test(AGerstnerSeaFoldsNoMoreThanAsked),
        cmocka_unit_test(AGivenWaveIsJustThatWave),
        cmocka_unit_test(GerstnerSeasLoopToTheBit),
        cmocka_unit_test(InstructionSetsAgreeOnFreeWavesAndOneByOneSums),
        cmocka_unit_test(SystemsOfOneSeedAreWarnedOf),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
