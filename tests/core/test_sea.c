// SPDX-License-Identifier: MIT
// Seas by one knob are as high as seamen say, and a sea of several wave systems comes and goes as one.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdio.h>

#include <seaway/seaway.h>

static swSeaState GetSeaState(const swSpectrumDef* def)
{
    swSeaState seaState;
    assert_int_equal(swSpectrum_GetSeaState(def, 0.0f, 20.0f, &seaState), SW_SUCCESS);
    return seaState;
}

static bool IsWithin(float value, double expected, double part)
{
    bool isWithin = fabs((double)value - expected) <= part * expected;
    if (!isWithin)
    {
        print_error("%.6g is not %.6g +- %g %%\n", (double)value, expected, 100.0 * part);
    }
    return isWithin;
}

// ---- one knob ----

static void BeaufortsNumbersHaveTheirHeights(void** state)
{
    (void)state;
    // Probable heights in the open sea, and the winds between which the numbers lie.
    static const double heights[13] = {0.0, 0.1, 0.2, 0.6, 1.0, 2.0, 3.0, 4.0, 5.5, 7.0, 9.0, 11.5, 14.0};
    static const double winds[14] = {0.0, 0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7, 40.0};
    for (int i = 1; i <= 12; ++i)
    {
        swSpectrumDef def = swMakeBeaufortSpectrum((float)i, 1.5f);
        swSeaState sea = GetSeaState(&def);
        print_message("Beaufort %2d: %4.1f m/s, Hs %5.2f m, Tp %5.2f s, gamma %.2f\n", i, (double)def.windSpeed,
                      (double)sea.significantHeight, (double)sea.peakPeriod, (double)def.gamma);
        double height = (double)sea.significantHeight;
        assert_true(height < 1.5 * heights[i] && height > heights[i] / 1.5);
        assert_true((double)def.windSpeed >= winds[i] - 0.05 && (double)def.windSpeed <= winds[i + 1]);
        assert_true(sea.meanDirection == 1.5f);
    }
    float before = -1.0f, windBefore = -1.0f, periodBefore = 0.0f;
    for (int i = 0; i <= 120; ++i)
    {
        swSpectrumDef def = swMakeBeaufortSpectrum(0.1f * (float)i, 0.0f);
        assert_true(def.significantHeight > before && def.windSpeed >= windBefore);
        assert_true(def.peakPeriod >= periodBefore);
        // No steeper than water stands: 2 pi Hs / (g Tp^2).
        float steepness = 6.2831853f * def.significantHeight / (9.81f * def.peakPeriod * def.peakPeriod);
        assert_true(steepness < 0.0401f);
        before = def.significantHeight;
        windBefore = def.windSpeed;
        periodBefore = def.peakPeriod;
    }
    assert_true(swMakeBeaufortSpectrum(0.0f, 0.0f).significantHeight <= 0.001f);
    assert_true(swMakeBeaufortSpectrum(99.0f, 0.0f).significantHeight == 14.0f);
    assert_true(swMakeBeaufortSpectrum(-1.0f, 0.0f).significantHeight <= 0.001f);
    assert_true(swMakeBeaufortSpectrum(NAN, 0.0f).significantHeight <= 0.001f);
}

static void StatesOfTheSeaLieInTheirRanges(void** state)
{
    (void)state;
    static const double edges[11] = {0.0, 0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0, 20.0};
    for (int i = 1; i <= 9; ++i)
    {
        swSpectrumDef def = swMakeSeaStateSpectrum((float)i, 0.0f);
        swSeaState sea = GetSeaState(&def);
        assert_true((double)sea.significantHeight > edges[i] && (double)sea.significantHeight < edges[i + 1]);
    }
    float before = -1.0f;
    for (int i = 0; i <= 90; ++i)
    {
        swSpectrumDef def = swMakeSeaStateSpectrum(0.1f * (float)i, 0.0f);
        assert_true(def.significantHeight > before || i == 1);
        before = def.significantHeight;
    }
}

static void WindSeasGrowAndStop(void** state)
{
    (void)state;
    // Hs = 0.0016 x^0.5 U^2 / g by fetch [Hasselmann 1973], until the developed sea.
    static const double rows[][3] = {{5, 10e3, 0.255},   {10, 10e3, 0.511},  {10, 100e3, 1.615}, {15, 50e3, 1.713},
                                     {15, 300e3, 4.197}, {20, 100e3, 3.231}, {20, 300e3, 5.596}, {25, 300e3, 6.995}};
    for (int i = 0; i < 8; ++i)
    {
        swSpectrumDef def = swMakeWindSeaSpectrum((float)rows[i][0], (float)rows[i][1], INFINITY, 0.0f);
        assert_true(IsWithin(GetSeaState(&def).significantHeight, rows[i][2], 0.002));
    }
    for (float wind = 2.0f; wind < 40.0f; wind *= 1.3f)
    {
        swSpectrumDef developed = swDefaultSpectrumDef();
        developed.kind = SW_SPECTRUM_PIERSON_MOSKOWITZ;
        developed.windSpeed = wind;
        swSeaState most = GetSeaState(&developed);
        float before = 0.0f, periodBefore = 0.0f;
        for (float fetch = 100.0f; fetch < 1e8f; fetch *= 2.0f)
        {
            swSpectrumDef def = swMakeWindSeaSpectrum(wind, fetch, INFINITY, 0.0f);
            assert_true(def.significantHeight >= before && def.peakPeriod >= periodBefore);
            assert_true(def.significantHeight <= most.significantHeight * 1.001f);
            assert_true(def.peakPeriod <= most.peakPeriod * 1.001f);
            before = def.significantHeight;
            periodBefore = def.peakPeriod;
        }
        assert_true(IsWithin(before, (double)most.significantHeight, 0.001));
        assert_true(IsWithin(periodBefore, (double)most.peakPeriod, 0.001));
    }
    // Hs = 0.0146 D^(5/7) U^(9/7), hours [Carter 1982].
    for (int hours = 2; hours <= 12; hours += 5)
    {
        swSpectrumDef def = swMakeWindSeaSpectrum(15.0f, INFINITY, 3600.0f * (float)hours, 0.0f);
        assert_true(IsWithin(def.significantHeight, 0.0146 * pow(hours, 5.0 / 7.0) * pow(15.0, 9.0 / 7.0), 0.02));
    }
    assert_true(swMakeWindSeaSpectrum(NAN, NAN, NAN, 0.0f).significantHeight > 0.0f);
}

static void SwellsAreAsAsked(void** state)
{
    (void)state;
    swSpectrumDef def = swMakeSwellSpectrum(1.8f, 14.0f, -2.0f, 0.2f);
    swSeaState sea = GetSeaState(&def);
    assert_true(IsWithin(sea.significantHeight, 1.8, 1e-4) && IsWithin(sea.peakPeriod, 14.0, 1e-5));
    assert_true(IsWithin(sea.spread, 0.2, 1e-4) && sea.meanDirection == -2.0f);
}

// ---- a sea of several systems ----

static swSeaDef MakeSea(void)
{
    swSeaDef def = swDefaultSeaDef();
    def.windSea.resolution = 32;
    def.windSea.tileWaves = 8;
    def.windSea.minWavelength = 4.0f;
    def.windSea.spectrum = swMakeBeaufortSpectrum(5.0f, 0.3f);
    def.swellCount = 2;
    def.swells[0] = swMakeSwellSpectrum(1.5f, 13.0f, 1.0f, 0.2f);
    def.swells[1] = swMakeSwellSpectrum(1.5f, 13.0f, 1.0f, 0.2f); // the same, yet another sea
    return def;
}

static double GetVariance(const swWorld* world, swWaveSystemId id)
{
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(world, id, bands);
    double variance = 0.0;
    for (int i = 0; i < count; ++i)
    {
        variance += (double)bands[i].variance;
    }
    return variance;
}

static double MeasureHeight(swWorld* world)
{
    enum
    {
        POINTS = 4000
    };
    static swPosXZ points[POINTS];
    static float heights[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){(i % 63) * 97.3, (i / 63.0) * 89.1};
    }
    swQueryDef query = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = heights};
    double square = 0.0;
    int times = 10;
    for (int i = 0; i < times; ++i)
    {
        assert_int_equal(swWorld_Step(world, 53.0), SW_SUCCESS);
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &samples, NULL);
        for (int j = 0; j < POINTS; ++j)
        {
            square += (double)heights[j] * (double)heights[j];
        }
    }
    return 4.0 * sqrt(square / (POINTS * times));
}

static void ASeaHasTheEnergyOfAllItsSystems(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swSeaDef def = MakeSea();
    swSea sea;
    assert_int_equal(swCreateSea(world, &def, &sea), SW_SUCCESS);
    assert_int_equal(sea.swellCount, 2);
    assert_true(swWaveSystem_IsValid(world, sea.windSea) && swWaveSystem_IsValid(world, sea.swells[1]));
    assert_true(sea.swells[2].index1 == 0);
    double swell = GetVariance(world, sea.swells[0]);
    // Four times the peak's frequency and more is left out of a swell.
    assert_true(IsWithin((float)(4.0 * sqrt(swell)), 1.5, 0.01));
    double whole = 4.0 * sqrt(swell + GetVariance(world, sea.swells[1]) + GetVariance(world, sea.windSea));
    double measured = MeasureHeight(world);
    print_message("wind sea and two swells: Hs %.3f m, %.3f m measured\n", whole, measured);
    assert_true(IsWithin((float)measured, whole, 0.06)); // two alike swells in step would make 22 % more

    swDestroySea(world, &sea);
    assert_true(sea.swellCount == 0 && sea.windSea.index1 == 0);
    assert_true(MeasureHeight(world) == 0.0);
    def.enableWindSea = false;
    assert_int_equal(swCreateSea(world, &def, &sea), SW_SUCCESS);
    assert_true(sea.windSea.index1 == 0 && swWaveSystem_IsValid(world, sea.swells[0]));
    swDestroyWaveSystem(world, sea.swells[0]);
    swDestroySea(world, &sea); // what is left of it
    swDestroyWorld(world);
}

static void EverySpectrumAndSpreadingMakesItsEnergy(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = false;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    double worst = 0.0;
    for (int i = 0; i < SW_SPECTRUM_TABLE * SW_SPREADING_KIND_COUNT; ++i)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.resolution = 32;
        def.tileWaves = 8;
        def.spectrum.kind = (swSpectrumKind)(i / SW_SPREADING_KIND_COUNT);
        def.spectrum.spreading = (swSpreadingKind)(i % SW_SPREADING_KIND_COUNT);
        def.spectrum.turbulence = 0.1f;
        def.spectrum.swell = 0.3f;
        def.spectrum.depth = 25.0f;
        def.spectrum.significantHeight = 2.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        swSeaState sea;
        assert_int_equal(swSpectrum_GetSeaState(&def.spectrum, 0.0f, 5.18f, &sea), SW_SUCCESS); // 0.0625 m
        worst = fmax(worst, fabs(4.0 * sqrt(GetVariance(world, id)) / (double)sea.significantHeight - 1.0));
        swDestroyWaveSystem(world, id);
    }
    print_message("36 systems: worst height off by %.1e\n", worst);
    assert_true(worst < 1e-3);
    swDestroyWorld(world);
}

static void ACalmIsNoError(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swSeaDef def = MakeSea();
    def.windSea.spectrum = swMakeBeaufortSpectrum(0.0f, 0.0f);
    def.swellCount = 0;
    swSea sea;
    assert_int_equal(swCreateSea(world, &def, &sea), SW_SUCCESS);
    assert_true(MeasureHeight(world) < 1e-5);
    swDestroySea(world, &sea);
    swDestroyWorld(world);
}

static void AFailureLeavesNothingBehind(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swSeaDef def = MakeSea();
    swSea sea;
    // The world keeps its scratch, and a system's memory until the next step.
    assert_int_equal(swCreateSea(world, &def, &sea), SW_SUCCESS);
    swDestroySea(world, &sea);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    long long before = atomic_load(&memory.bytes);
    swResult result = SW_ERROR_NO_MEMORY;
    int failures = 0;
    for (int i = 0; result != SW_SUCCESS && i < 1000; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        result = swCreateSea(world, &def, &sea);
        atomic_store(&memory.failAt, -1);
        if (result != SW_SUCCESS)
        {
            assert_int_equal(result, SW_ERROR_NO_MEMORY);
            assert_true(sea.windSea.index1 == 0 && sea.swells[0].index1 == 0 && sea.swellCount == 0);
            assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
            assert_true(atomic_load(&memory.bytes) == before);
            failures += 1;
        }
    }
    print_message("%d allocations failed in turn\n", failures);
    assert_true(failures > 20);
    swDestroySea(world, &sea);

    def.swells[1].gamma = 0.0f; // the last of them is wrong
    assert_int_equal(swCreateSea(world, &def, &sea), SW_ERROR_INVALID);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_true(atomic_load(&memory.bytes) == before);
    def.swellCount = 5;
    assert_int_equal(swCreateSea(world, &def, &sea), SW_ERROR_INVALID);
    swDestroyWorld(world);
    assert_true(atomic_load(&memory.bytes) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(BeaufortsNumbersHaveTheirHeights),
        cmocka_unit_test(StatesOfTheSeaLieInTheirRanges),
        cmocka_unit_test(WindSeasGrowAndStop),
        cmocka_unit_test(SwellsAreAsAsked),
        cmocka_unit_test(ASeaHasTheEnergyOfAllItsSystems),
        cmocka_unit_test(EverySpectrumAndSpreadingMakesItsEnergy),
        cmocka_unit_test(ACalmIsNoError),
        cmocka_unit_test(AFailureLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
