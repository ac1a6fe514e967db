// SPDX-License-Identifier: MIT
// The life of a world: memory comes back, an allocation that fails is survived, a warm step takes none, and the surface
// is a function of time alone, with the same bits for any number of threads and any instruction set.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#include <math.h>
#include <string.h>

#include "core/frame/frame.h"
#include "scenarios/scenario.h"

// Small enough to be made a hundred times: five bands of 16 x 16.
static swWaveSystemDef MakeSmallSystem(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 16;
    def.tileWaves = 4;
    def.minWavelength = 8.0f;
    def.maxWavelength = 256.0f;
    return def;
}

static swViewDef MakeSmallView(void)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = 2;
    def.resolution = 64;
    def.enableCpuLayers = true;
    return def;
}

typedef struct SmallWorld
{
    swWorld* world;
    swWaveSystemId waves;
    swView* view;
} SmallWorld;

static swResult CreateSmallWorld(const swHost* host, SmallWorld* small)
{
    *small = (SmallWorld){0};
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef systemDef = MakeSmallSystem();
    swViewDef viewDef = MakeSmallView();
    swResult result = swCreateWorld(host, &worldDef, &small->world);
    result = result == SW_SUCCESS ? swCreateWaveSystem(small->world, &systemDef, &small->waves) : result;
    result = result == SW_SUCCESS ? swCreateView(small->world, &viewDef, &small->view) : result;
    result = result == SW_SUCCESS ? swWorld_Step(small->world, 0.1) : result;
    if (result == SW_SUCCESS)
    {
        systemDef.spectrum.windSpeed = 15.0f;
        result = swWaveSystem_SetSpectrum(small->world, small->waves, &systemDef.spectrum);
    }
    return result == SW_SUCCESS ? swWorld_Step(small->world, 0.1) : result;
}

static void AWorldGivesItsMemoryBack(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    assert_int_equal(swWorld_GetMemory(small.world), atomic_load(&memory.bytes));
    swDestroyView(small.view);
    swDestroyWaveSystem(small.world, small.waves);
    assert_int_equal(swWorld_Step(small.world, 0.1), SW_SUCCESS);
    assert_int_equal(swWorld_GetMemory(small.world), atomic_load(&memory.bytes));
    swDestroyWorld(small.world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    assert_int_equal(atomic_load(&memory.messages), 0);
    swDestroyWorld(NULL);
    swDestroyView(NULL);
}

static void DestroyingAWorldTakesEverythingWithIt(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    swDestroyWaveSystem(small.world, small.waves); // retired, not yet freed
    swDestroyWorld(small.world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void EveryAllocationMayFail(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    swDestroyWorld(small.world);
    long long total = atomic_load(&memory.allocations);
    assert_true(total > 20);
    for (long long i = 0; i < total; ++i)
    {
        host = MakeCountingHost(&memory);
        atomic_store(&memory.failAt, i);
        assert_int_equal(CreateSmallWorld(&host, &small), SW_ERROR_NO_MEMORY);
        assert_true(atomic_load(&memory.messages) >= 1);
        if (small.world != NULL)
        {
            // What is there goes on working.
            assert_int_equal(swWorld_Step(small.world, 0.1), SW_SUCCESS);
            assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(small.world), 1.0, 2.0)));
        }
        swDestroyWorld(small.world);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    print_message("%lld allocations failed once each\n", total);
}

static void AWarmStepOrQueryAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    long long before = atomic_load(&memory.allocations);
    for (int i = 0; i < 10; ++i)
    {
        swView_SetViewpoint(small.view, (swPos){3.0 * i, 5.0 * i, 0.0});
        assert_int_equal(swWorld_Step(small.world, 1.0 / 60.0), SW_SUCCESS);
        swWaveSystem_SetWeight(small.world, small.waves, 0.1f * (float)i);
        swMoment_GetHeight(swWorld_GetMoment(small.world), 0.0, 0.0);
        swWorld_GetDigest(small.world);
    }
    assert_int_equal(atomic_load(&memory.allocations), before);
    swDestroyWorld(small.world);
}

// Digest of all steps of a short sail.
static uint64_t DigestOf(const ScenarioDef* def)
{
    Scenario scenario;
    assert_int_equal(CreateScenario(def, &scenario), SW_SUCCESS);
    uint64_t digest = 0;
    for (int i = 0; i < 5; ++i)
    {
        assert_int_equal(swWorld_Step(scenario.world, 7.3), SW_SUCCESS);
        digest = digest * 31 + swWorld_GetDigest(scenario.world);
    }
    DestroyScenario(&scenario);
    return digest;
}

static void AnyNumberOfThreadsAndAnyInstructionSetGiveTheSameBits(void** state)
{
    (void)state;
    ScenarioDef def = DefaultScenarioDef(SCENARIO_GALE);
    def.resolution = 64;
    uint64_t expected = DigestOf(&def);
    print_message("digest of the gale: %016llx\n", (unsigned long long)expected);
    const int threadCounts[] = {1, 2, 5};
    for (int isa = SW_ISA_BEST; isa < SW_ISA_COUNT; ++isa)
    {
        def.isa = (swIsa)isa;
        swHost silent = swDefaultHost();
        silent.log = NULL;
        def.host = silent;
        def.threadCount = 1;
        Scenario scenario;
        swResult result = CreateScenario(&def, &scenario);
        if (result == SW_ERROR_UNSUPPORTED)
        {
            continue; // not this machine's
        }
        assert_int_equal(result, SW_SUCCESS);
        print_message("%s runs as %s\n", swIsa_GetName(def.isa), swIsa_GetName(swWorld_GetIsa(scenario.world)));
        DestroyScenario(&scenario);
        for (int t = 0; t < 3; ++t)
        {
            def.threadCount = threadCounts[t];
            assert_true(DigestOf(&def) == expected);
        }
    }
}

static void DigestSeesSeedTimeAndWeight(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    uint64_t digest = swWorld_GetDigest(small.world);
    assert_int_equal(swWorld_GetDigest(small.world), digest);
    swWorld_Step(small.world, 0x1p-24);
    assert_int_not_equal(swWorld_GetDigest(small.world), digest);
    digest = swWorld_GetDigest(small.world);
    swWaveSystem_SetWeight(small.world, small.waves, 1.0f + 0x1p-20f);
    assert_int_not_equal(swWorld_GetDigest(small.world), digest); // it decides what comes
    swWorld_Step(small.world, 0.0);
    assert_int_not_equal(swWorld_GetDigest(small.world), digest);
    swDestroyWorld(small.world);
}

static void TimeStaysWithinItsRange(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    swWorld_SetTime(small.world, SW_LARGEST_TIME - 2.0);
    assert_int_equal(swWorld_Step(small.world, 2.0), SW_SUCCESS);
    assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(small.world), 1.0, 2.0)));
#ifdef NDEBUG // otherwise it stops here
    assert_int_equal(swWorld_Step(small.world, 1.0), SW_ERROR_INVALID);
    assert_true(swWorld_GetTime(small.world) == SW_LARGEST_TIME);
#endif
    assert_int_equal(swWorld_StepTo(small.world, 0.0), SW_SUCCESS);
    swDestroyWorld(small.world);
}

static void GoingBackInTimeGivesTheSameSurface(void** state)
{
    (void)state;
    ScenarioDef def = DefaultScenarioDef(SCENARIO_BREEZE);
    def.resolution = 32;
    Scenario scenario;
    assert_int_equal(CreateScenario(&def, &scenario), SW_SUCCESS);
    swWorld_SetTime(scenario.world, 100.0);
    swWorld_Step(scenario.world, 0.0);
    uint64_t digest = swWorld_GetDigest(scenario.world);
    double height = swMoment_GetHeight(swWorld_GetMoment(scenario.world), 12.0, -7.0);
    assert_true(swWorld_GetTime(scenario.world) == 100.0);
    const double detours[] = {-5e4, 1e9, 99.9};
    for (int i = 0; i < 3; ++i)
    {
        swWorld_SetTime(scenario.world, detours[i]);
        swWorld_Step(scenario.world, 1.0);
        assert_int_not_equal(swWorld_GetDigest(scenario.world), digest);
        swWorld_SetTime(scenario.world, 99.0);
        swWorld_Step(scenario.world, 1.0);
        assert_int_equal(swWorld_GetDigest(scenario.world), digest);
        assert_true(swMoment_GetHeight(swWorld_GetMoment(scenario.world), 12.0, -7.0) == height);
    }
    DestroyScenario(&scenario);
}

static void WeightScalesTheSurface(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    swQueryDef def = swDefaultQueryDef();
    swPosXZ point = {30.0, -4.0};
    swVec3 whole, half, none;
    swSurfaceSamples samples = {.displacement = &whole};
    swMoment_QueryParticles(swWorld_GetMoment(small.world), &def, 1, &point, &samples, NULL, NULL);
    swWaveSystem_SetWeight(small.world, small.waves, 0.5f);
    assert_true(swWaveSystem_GetWeight(small.world, small.waves) == 0.5f);
    swWorld_Step(small.world, 0.0);
    samples.displacement = &half;
    swMoment_QueryParticles(swWorld_GetMoment(small.world), &def, 1, &point, &samples, NULL, NULL);
    assert_true(half.x == 0.5f * whole.x && half.y == 0.5f * whole.y && half.z == 0.5f * whole.z);
    assert_true(swGetWorldFrame(small.world)->tiles[0].weight == 0.5f);
    swWaveSystem_SetWeight(small.world, small.waves, 0.0f);
    swWorld_Step(small.world, 0.0);
    samples.displacement = &none;
    swMoment_QueryParticles(swWorld_GetMoment(small.world), &def, 1, &point, &samples, NULL, NULL);
    assert_true(none.x == 0.0f && none.y == 0.0f && none.z == 0.0f);
    swDestroyWorld(small.world);
}

// What the frame says of the surface, as the last step left it, must hold until the next one.
static void TheFrameOutlivesItsWaveSystemUntilTheNextStep(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    SmallWorld small;
    assert_int_equal(CreateSmallWorld(&host, &small), SW_SUCCESS);
    const swFrame* frame = swGetWorldFrame(small.world);
    uint64_t digest = swWorld_GetDigest(small.world);
    double height = swMoment_GetHeight(swWorld_GetMoment(small.world), 5.0, 5.0);
    uint32_t version = frame->tilesVersion;
    swDestroyWaveSystem(small.world, small.waves);
    assert_false(swWaveSystem_IsValid(small.world, small.waves));
    swWaveSystemDef def = MakeSmallSystem();
    def.seed = 2;
    swWaveSystemId other;
    assert_int_equal(swCreateWaveSystem(small.world, &def, &other), SW_SUCCESS); // takes the same slot
    assert_int_equal(other.index1, small.waves.index1);
    assert_int_not_equal(swWorld_GetDigest(small.world), digest); // of what comes
    assert_true(swMoment_GetHeight(swWorld_GetMoment(small.world), 5.0, 5.0) == height);
    assert_true(frame->tiles[0].modes[0].qz >= 0 && frame->tilesVersion == version);
    swWorld_Step(small.world, 0.0);
    assert_true(frame->tilesVersion != version);
    assert_int_not_equal(swWorld_GetDigest(small.world), digest);
    assert_false(swWaveSystem_IsValid(small.world, small.waves));
    assert_true(swWaveSystem_IsValid(small.world, other));
    swDestroyWorld(small.world);
}

static void BandsHoldTheEnergyThatWasAskedFor(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.spectrum.significantHeight = 3.0f;
    def.spectrum.peakPeriod = 8.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(world, id, bands);
    assert_true(count > 8);
    double variance = 0.0;
    for (int i = 0; i < count; ++i)
    {
        assert_true(i == 0 || bands[i].minWavelength >= bands[i - 1].maxWavelength);
        assert_true(bands[i].modeCount > 0 && bands[i].tileSide > 0.0f);
        variance += (double)bands[i].variance;
    }
    assert_true(fabs(4.0 * sqrt(variance) - 3.0) < 0.06);
    swDestroyWorld(world);
}

static void WhatCannotBeMadeIsSaid(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    worldDef.gravity = NAN;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_ERROR_INVALID);
    assert_null(world);
    worldDef = swDefaultWorldDef();
    worldDef.surfaceTension = 0.01f;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_ERROR_INVALID);
    worldDef = swDefaultWorldDef();
    worldDef.foam.fadeRate = 0.0f;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_ERROR_INVALID);
    worldDef = swDefaultWorldDef();
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    long long before = atomic_load(&memory.messages);

    swWaveSystemDef systemDef = MakeSmallSystem();
    swWaveSystemId id;
    systemDef.resolution = 48;
    assert_int_equal(swCreateWaveSystem(world, &systemDef, &id), SW_ERROR_INVALID);
    systemDef = MakeSmallSystem();
    systemDef.tileWaves = 5;
    assert_int_equal(swCreateWaveSystem(world, &systemDef, &id), SW_ERROR_INVALID);
    systemDef = MakeSmallSystem();
    systemDef.chop = NAN;
    assert_int_equal(swCreateWaveSystem(world, &systemDef, &id), SW_ERROR_INVALID);
    systemDef = MakeSmallSystem();
    systemDef.spectrum.windSpeed = -1.0f;
    assert_int_equal(swCreateWaveSystem(world, &systemDef, &id), SW_ERROR_INVALID);
    assert_true(SW_IS_NULL(id));

    swViewDef viewDef = MakeSmallView();
    swView* view;
    viewDef.resolution = 100;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_ERROR_INVALID);
    viewDef = MakeSmallView();
    viewDef.finestTexel = 0.1f;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_ERROR_INVALID);
    assert_null(view);
    assert_int_equal(atomic_load(&memory.messages) - before, 6);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void SystemsTilesAndViewsHaveALimit(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = MakeSmallSystem(); // 5 tiles each
    swWaveSystemId ids[SW_MAX_WAVE_SYSTEMS];
    int made = 0;
    swResult result = SW_SUCCESS;
    while (made < SW_MAX_WAVE_SYSTEMS && result == SW_SUCCESS)
    {
        def.seed = 1 + (uint32_t)made; // the same sea would share its tiles
        result = swCreateWaveSystem(world, &def, &ids[made]);
        made += result == SW_SUCCESS ? 1 : 0;
    }
    assert_int_equal(result, SW_ERROR_LIMIT);
    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    assert_true(swGetWorldFrame(world)->tileCount <= SW_MAX_TILES);
    assert_true(swGetWorldFrame(world)->tileCount > SW_MAX_TILES - 6);
    swDestroyWaveSystem(world, ids[0]);
    assert_int_equal(swCreateWaveSystem(world, &def, &ids[0]), SW_SUCCESS);

    swViewDef viewDef = MakeSmallView();
    viewDef.enableCpuLayers = false;
    swView* views[SW_MAX_VIEWS + 1];
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        assert_int_equal(swCreateView(world, &viewDef, &views[i]), SW_SUCCESS);
    }
    assert_int_equal(swCreateView(world, &viewDef, &views[SW_MAX_VIEWS]), SW_ERROR_LIMIT);
    swWorld_Step(world, 0.1);
    swDestroyView(views[3]);
    assert_int_equal(swGetWorldFrame(world)->viewCount, SW_MAX_VIEWS - 1);
    assert_ptr_equal(swGetWorldFrame(world)->views[3].view, views[4]);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void AWorldWithoutQueriesIsFlatForTheCpu(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    host.log = NULL;
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = false;
    worldDef.seaLevel = 12.5;
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = MakeSmallSystem();
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    assert_true(swMoment_GetHeight(swWorld_GetMoment(world), 3.0, 4.0) == 12.5);
    assert_int_equal(swGetWorldFrame(world)->tileCount, 5);
    swViewDef viewDef = MakeSmallView();
    swView* view;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_ERROR_INVALID);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWorldGivesItsMemoryBack),
        cmocka_unit_test(DestroyingAWorldTakesEverythingWithIt),
        cmocka_unit_test(EveryAllocationMayFail),
        cmocka_unit_test(AWarmStepOrQueryAllocatesNothing),
        cmocka_unit_test(AnyNumberOfThreadsAndAnyInstructionSetGiveTheSameBits),
        cmocka_unit_test(DigestSeesSeedTimeAndWeight),
        cmocka_unit_test(TimeStaysWithinItsRange),
        cmocka_unit_test(GoingBackInTimeGivesTheSameSurface),
        cmocka_unit_test(WeightScalesTheSurface),
        cmocka_unit_test(TheFrameOutlivesItsWaveSystemUntilTheNextStep),
        cmocka_unit_test(BandsHoldTheEnergyThatWasAskedFor),
        cmocka_unit_test(WhatCannotBeMadeIsSaid),
        cmocka_unit_test(SystemsTilesAndViewsHaveALimit),
        cmocka_unit_test(AWorldWithoutQueriesIsFlatForTheCpu),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
