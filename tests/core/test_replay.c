// SPDX-License-Identifier: MIT

// A series of spectra as a sea that changes all the time.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "support/counting_host.h"
#include "support/saved.h"
#include <seaway/seaway.h>

enum
{
    RECORDS = 4,
    FREQUENCIES = 24,
    DIRECTIONS = 36
};

// An hour apart; the wind veers and rises.
static swMeasuredSea* MakeSeries(const swHost* host)
{
    swMeasuredSea* sea;
    assert_int_equal(swCreateMeasuredSea(host, "series", &sea), SW_SUCCESS);
    int location;
    assert_int_equal(swMeasuredSea_AddLocation(sea, "here", 0.0, 0.0, &location), SW_SUCCESS);
    for (int r = 0; r < RECORDS; ++r)
    {
        double frequencies[FREQUENCIES], directions[DIRECTIONS], density[FREQUENCIES * DIRECTIONS];
        swSpectrumDef wind = swDefaultSpectrumDef();
        wind.windSpeed = 8.0f + (float)r;
        wind.direction = 0.8f * (float)r;
        for (int i = 0; i < FREQUENCIES; ++i)
        {
            frequencies[i] = 0.06 + 0.015 * i;
            float energy = swSpectrum_GetDensity(&wind, (float)frequencies[i]);
            for (int j = 0; j < DIRECTIONS; ++j)
            {
                directions[j] = 2.0 * SW_PI * j / DIRECTIONS;
                float spreading = swSpectrum_GetSpreading(&wind, (float)frequencies[i], (float)directions[j]);
                density[i * DIRECTIONS + j] = (double)energy * (double)spreading;
            }
        }
        swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
        def.location = location;
        def.seconds = 1e9 + 3600.0 * r;
        def.frequencyCount = FREQUENCIES;
        def.frequencies = frequencies;
        def.directionCount = DIRECTIONS;
        def.directions = directions;
        def.density = density;
        assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
    }
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    return sea;
}

typedef struct Played
{
    swWorld* world;
    swMeasuredSea* sea;
    swSeaReplay* replay;
} Played;

static Played Play(const swHost* host, double speed)
{
    Played played;
    played.sea = MakeSeries(host);
    swWorldDef worldDef = swDefaultWorldDef();
    assert_int_equal(swCreateWorld(host, &worldDef, &played.world), SW_SUCCESS);
    swSeaReplayDef def = swDefaultSeaReplayDef();
    def.sea = played.sea;
    def.speed = speed;
    def.waves.resolution = 64;
    def.waves.tileWaves = 16;
    def.waves.minWavelength = 2.0f;
    assert_int_equal(swCreateSeaReplay(played.world, &def, &played.replay), SW_SUCCESS);
    swWorld_Step(played.world, 0.0);
    return played;
}

static void Stop(Played* played)
{
    swDestroySeaReplay(played->replay);
    swDestroyWorld(played->world);
    swDestroyMeasuredSea(played->sea);
}

static void GoTo(const Played* played, double time)
{
    assert_int_equal(swSeaReplay_Advance(played->replay, time), SW_SUCCESS);
    swWorld_SetTime(played->world, time);
    swWorld_Step(played->world, 0.0);
}

static double GetVariance(const Played* played)
{
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(played->world, swSeaReplay_GetSystem(played->replay), bands);
    double variance = 0.0;
    for (int i = 0; i < count; ++i)
    {
        variance += (double)bands[i].variance;
    }
    return variance;
}

static void EnergyRunsFromRecordToRecord(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    double at[RECORDS];
    for (int r = 0; r < RECORDS; ++r)
    {
        GoTo(&played, 3600.0 * r);
        at[r] = GetVariance(&played);
        assert_true(r == 0 || at[r] > 1.1 * at[r - 1]);
    }
    for (int r = 0; r + 1 < RECORDS; ++r)
    {
        for (int quarter = 1; quarter < 4; ++quarter)
        {
            GoTo(&played, 3600.0 * (r + 0.25 * quarter));
            double wanted = at[r] + (at[r + 1] - at[r]) * 0.25 * quarter;
            assert_true(fabs(GetVariance(&played) / wanted - 1.0) < 2e-3);
            int before, after;
            double fraction;
            swSeaReplay_GetRecords(played.replay, &before, &after, &fraction);
            assert_int_equal(before, r);
            assert_int_equal(after, r + 1);
            assert_true(fabs(fraction - 0.25 * quarter) < 1e-9);
        }
    }
    GoTo(&played, -5000.0);
    assert_true(fabs(GetVariance(&played) / at[0] - 1.0) < 1e-6);
    GoTo(&played, 1e6);
    assert_true(fabs(GetVariance(&played) / at[RECORDS - 1] - 1.0) < 1e-6);
    Stop(&played);
}

static void TheSeaDependsOnTheTimeAlone(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played there = Play(&host, 60.0);
    GoTo(&there, 100.0);
    uint64_t wanted = swWorld_GetDigest(there.world);
    GoTo(&there, 170.0);
    assert_int_not_equal(swWorld_GetDigest(there.world), wanted);
    GoTo(&there, -20.0);
    GoTo(&there, 100.0);
    assert_int_equal(swWorld_GetDigest(there.world), wanted);
    Stop(&there);
    Played stepped = Play(&host, 60.0);
    for (int step = 1; step <= 400; ++step)
    {
        assert_int_equal(swSeaReplay_Advance(stepped.replay, 0.25 * step), SW_SUCCESS);
        swWorld_Step(stepped.world, 0.25);
    }
    assert_int_equal(swWorld_GetDigest(stepped.world), wanted);
    Stop(&stepped);
}

// Across a record, at 1,000 times its speed: the surface moves as waves do.
static void NothingJumpsAtARecord(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 100.0);
    enum
    {
        POINTS = 200
    };
    float before[POINTS], after[POINTS];
    swPosXZ points[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){17.0 * i, 5.0 * (i % 13)};
    }
    swQueryDef def = swDefaultQueryDef();
    double usual = 0.0, across = 0.0;
    for (int step = 0; step < 240; ++step)
    {
        double time = 34.0 + step / 60.0; // the second record is at 36 s
        GoTo(&played, time);
        swSurfaceSamples samples = {.height = after};
        swMoment_QueryParticles(swWorld_GetMoment(played.world), &def, POINTS, points, &samples, NULL, NULL);
        double largest = 0.0;
        for (int i = 0; i < POINTS && step > 0; ++i)
        {
            largest = fmax(largest, fabs((double)after[i] - (double)before[i]));
        }
        bool isAcross = step >= 115 && step <= 125;
        *(isAcross ? &across : &usual) = fmax(isAcross ? across : usual, largest);
        memcpy(before, after, sizeof before);
    }
    print_message("largest step %.4f m across a record, %.4f m otherwise\n", across, usual);
    assert_true(across < 1.2 * usual);
    Stop(&played);
}

static void AdvancingBetweenRecordsAllocatesNothingAndFailuresChangeNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Played played = Play(&host, 1.0);
    GoTo(&played, 100.0);
    long long allocations = atomic_load(&memory.allocations);
    for (int step = 0; step < 20; ++step)
    {
        GoTo(&played, 110.0 + 10.0 * step);
    }
    assert_int_equal(atomic_load(&memory.allocations), allocations);
    GoTo(&played, 100.0);
    uint64_t digest = swWorld_GetDigest(played.world);
    for (int fail = 0;; ++fail)
    {
        assert_true(fail < 200);
        atomic_store(&memory.failAt, atomic_load(&memory.allocations) + fail);
        swResult result = swSeaReplay_Advance(played.replay, 4000.0);
        atomic_store(&memory.failAt, -1);
        if (result == SW_SUCCESS)
        {
            break;
        }
        assert_int_equal(result, SW_ERROR_NO_MEMORY);
        swWorld_Step(played.world, 0.0);
        assert_int_equal(swWorld_GetDigest(played.world), digest);
    }
    Stop(&played);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- moments ----

static bool IsSameWater(const swMoment* a, const swMoment* b)
{
    bool isSame = true;
    for (int i = 0; i < 30; ++i)
    {
        isSame = isSame && swMoment_GetHeight(a, 7.0 * i, 3.0 * i) == swMoment_GetHeight(b, 7.0 * i, 3.0 * i);
    }
    return isSame;
}

static void AMomentKnowsThePresentPairOfRecordsAndSaysSo(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    const double speeds[] = {1.0, -1.0, 60.0};
    for (int k = 0; k < 3; ++k)
    {
        double speed = speeds[k];
        Played played = Play(&host, speed);
        Played other = Play(&host, speed);
        double hour = 3600.0 / speed;
        GoTo(&played, 1.25 * hour);
        swMomentDef def = swDefaultMomentDef();
        swMoment* moment;
        assert_int_equal(swCreateMoment(played.world, &def, &moment), SW_SUCCESS);
        const double parts[] = {1.0, 1.1, 1.75, 1.99999};
        for (int i = 0; i < 4; ++i)
        {
            assert_int_equal(swMoment_Set(moment, played.world, parts[i] * hour), SW_SUCCESS);
            GoTo(&other, parts[i] * hour);
            assert_false(swMoment_IsHeld(moment));
            assert_true(IsSameWater(moment, swWorld_GetMoment(other.world)) || i == 0); // a record may be no mix at all
        }
        // Beyond the pair: the nearer record, and it says so.
        assert_int_equal(swMoment_Set(moment, played.world, 2.5 * hour), SW_SUCCESS);
        assert_true(swMoment_IsHeld(moment));
        assert_int_equal(swMoment_Set(moment, played.world, 0.5 * hour), SW_SUCCESS);
        assert_true(swMoment_IsHeld(moment));
        // After the last record the sea stays as it is, for good.
        GoTo(&played, 3.5 * hour);
        GoTo(&other, 9.0 * hour);
        assert_int_equal(swMoment_Set(moment, played.world, 9.0 * hour), SW_SUCCESS);
        assert_false(swMoment_IsHeld(moment));
        assert_true(IsSameWater(moment, swWorld_GetMoment(other.world)));
        swDestroyMoment(moment);
        Stop(&played);
        Stop(&other);
    }
}

// Before a step has shown the pair that the replay was advanced to.
static void AMomentOfAPairThatIsJustCurrentIsThatOfTheWorld(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    const double times[] = {9.0 * 3600.0, -3600.0, 1.5 * 3600.0, 0.0, 3.0 * 3600.0};
    swMomentDef def = swDefaultMomentDef();
    swMoment* moment;
    assert_int_equal(swCreateMoment(played.world, &def, &moment), SW_SUCCESS);
    for (int i = 0; i < 5; ++i)
    {
        GoTo(&played, 1.25 * 3600.0);
        assert_int_equal(swSeaReplay_Advance(played.replay, times[i]), SW_SUCCESS);
        assert_int_equal(swMoment_Set(moment, played.world, times[i]), SW_SUCCESS);
        assert_false(swMoment_IsHeld(moment));
        assert_int_equal(swWorld_StepTo(played.world, times[i]), SW_SUCCESS);
        assert_true(IsSameWater(moment, swWorld_GetMoment(played.world)));
    }
    swDestroyMoment(moment);
    Stop(&played);
}

// The sea stands still when its replay has been stopped, and so it is at every other time.
static void AMomentOfAStoppedReplayIsThatOfTheWorld(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    GoTo(&played, 4000.0);
    swDestroySeaReplay(played.replay);
    played.replay = NULL;
    swMomentDef def = swDefaultMomentDef();
    def.time = 5000.0;
    swMoment* moment;
    assert_int_equal(swCreateMoment(played.world, &def, &moment), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(played.world, 5000.0), SW_SUCCESS);
    assert_true(IsSameWater(moment, swWorld_GetMoment(played.world)));
    swDestroyMoment(moment);
    Stop(&played);
}

// A replay that is no longer advanced leaves what fades away as it was; so does a moment.
static void AMomentOfASeaThatLeavesItsReplayIsThatOfTheWorld(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    GoTo(&played, 4000.0);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.seed = 99;
    assert_int_equal(swWaveSystem_Set(played.world, swSeaReplay_GetSystem(played.replay), &waves, 1000.0), SW_SUCCESS);
    swMomentDef def = swDefaultMomentDef();
    def.time = 4500.0;
    swMoment* moment;
    assert_int_equal(swCreateMoment(played.world, &def, &moment), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(played.world, 4500.0), SW_SUCCESS);
    assert_true(IsSameWater(moment, swWorld_GetMoment(played.world)));
    swDestroyMoment(moment);
    Stop(&played);
}

// A world that was saved does not know the records of its replay until that is taken up again.
static void AReplayThatWasSavedIsHeldUntilItIsTakenUp(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    GoTo(&played, 4000.0);
    Saved saved = Save(played.world);
    swRestoreDef restoreDef = swDefaultRestoreDef();
    swWorld* world;
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restoreDef, &world), SW_SUCCESS);
    swMomentDef def = swDefaultMomentDef();
    def.time = 4000.0;
    swMoment* moment;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    assert_false(swMoment_IsHeld(moment));
    assert_true(IsSameWater(moment, swWorld_GetMoment(played.world)));
    assert_int_equal(swMoment_Set(moment, world, 5000.0), SW_SUCCESS);
    assert_true(swMoment_IsHeld(moment));
    swDestroyMoment(moment);
    swDestroyWorld(world);
    free(saved.data);
    Stop(&played);
}

// What a replay leaves behind changes as any sea does.
static void ASeaThatWasReplayedMayBeSetToAnother(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    Played played = Play(&host, 1.0);
    GoTo(&played, 1800.0);
    swWaveSystemId id = swSeaReplay_GetSystem(played.replay);
    swDestroySeaReplay(played.replay);
    played.replay = NULL;
    swWaveSystemDef def = swWaveSystem_Get(played.world, id);
    def.chop = 0.5f; // the same phases: a mix
    assert_int_equal(swWaveSystem_Set(played.world, id, &def, 10.0), SW_SUCCESS);
    for (int i = 0; i < 30; ++i)
    {
        assert_int_equal(swWorld_Step(played.world, 0.5), SW_SUCCESS);
    }
    assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(played.world), 1.0, 2.0)));
    Stop(&played);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EnergyRunsFromRecordToRecord),
        cmocka_unit_test(TheSeaDependsOnTheTimeAlone),
        cmocka_unit_test(NothingJumpsAtARecord),
        cmocka_unit_test(AMomentKnowsThePresentPairOfRecordsAndSaysSo),
        cmocka_unit_test(AMomentOfAPairThatIsJustCurrentIsThatOfTheWorld),
        cmocka_unit_test(AMomentOfAStoppedReplayIsThatOfTheWorld),
        cmocka_unit_test(AMomentOfASeaThatLeavesItsReplayIsThatOfTheWorld),
        cmocka_unit_test(AReplayThatWasSavedIsHeldUntilItIsTakenUp),
        cmocka_unit_test(ASeaThatWasReplayedMayBeSetToAnother),
        cmocka_unit_test(AdvancingBetweenRecordsAllocatesNothingAndFailuresChangeNothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
