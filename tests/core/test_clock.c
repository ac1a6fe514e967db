// SPDX-License-Identifier: MIT

// Where a world's time comes from.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include <seaway/seaway.h>

static void TimeIsTheHostsTimesTheScale(void** state)
{
    (void)state;
    swClock clock = swDefaultClock();
    assert_true(swClock_Advance(&clock, 0.5) == 0.5);
    clock.scale = 4.0;
    assert_true(swClock_Advance(&clock, 0.5) == 2.5);
    clock.scale = -1.0;
    assert_true(swClock_Advance(&clock, 1.0) == 1.5);
    clock.time = 100.0; // scrubbed
    clock.scale = 1.0;
    assert_true(swClock_Advance(&clock, 0.25) == 100.25);
}

static void APausedClockStandsAndStepsOnce(void** state)
{
    (void)state;
    swClock clock = swDefaultClock();
    clock.fixedStep = 0.125;
    swClock_Advance(&clock, 1.0);
    clock.isPaused = true;
    for (int i = 0; i < 10; ++i)
    {
        assert_true(swClock_Advance(&clock, 1.0) == 1.0);
    }
    assert_true(swClock_StepOnce(&clock) == 1.125);
    clock.isPaused = false;
    assert_true(swClock_Advance(&clock, 0.125) == 1.25);
}

static void FixedStepsComeOutAtTheSameTimesWhateverTheFrames(void** state)
{
    (void)state;
    swClock a = swDefaultClock(), b = swDefaultClock();
    a.fixedStep = b.fixedStep = 1.0 / 30.0;
    for (int i = 0; i < 600; ++i)
    {
        swClock_Advance(&a, 1.0 / 60.0 + 1e-9);
    }
    for (int i = 0; i < 1440; ++i)
    {
        swClock_Advance(&b, 1.0 / 144.0 + 1e-9);
    }
    assert_true(a.time == b.time && a.time == 300.0 * (1.0 / 30.0));
    double before = a.time;
    swClock_Advance(&a, 100.0); // a long halt is not caught up with
    assert_true(a.time - before <= 8.01 / 30.0);
    assert_true(a.rest < a.fixedStep);
}

static void AFollowingClockMeetsTheServerWithoutRunningBack(void** state)
{
    (void)state;
    for (int ahead = 0; ahead < 2; ++ahead)
    {
        swClock clock = swDefaultClock();
        double server = ahead ? 0.5 : -0.5;
        double before = clock.time;
        for (int i = 0; i < 60 * 15; ++i)
        {
            server += 1.0 / 60.0;
            if (i % 6 == 0)
            {
                swClock_Follow(&clock, server - 1.0 / 60.0);
            }
            double now = swClock_Advance(&clock, 1.0 / 60.0);
            assert_true(now > before && now - before < 1.06 / 60.0);
            before = now;
        }
        assert_true(fabs(clock.time - server) < 1e-3);
    }
    swClock clock = swDefaultClock();
    swClock_Follow(&clock, 50.0);
    assert_true(clock.time == 50.0);
}

static void SteppingToATimeComesOutThere(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    uint64_t digests[2];
    for (int k = 0; k < 2; ++k)
    {
        swWorldDef def = swDefaultWorldDef();
        swWorld* world;
        swWaveSystemId id;
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.resolution = 32;
        waves.tileWaves = 8;
        assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
        assert_int_equal(swCreateWaveSystem(world, &waves, &id), SW_SUCCESS);
        int frames = k == 0 ? 7 : 31;
        for (int i = 1; i <= frames; ++i)
        {
            assert_int_equal(swWorld_StepTo(world, 3.1 * i / frames), SW_SUCCESS);
        }
        assert_true(swWorld_GetTime(world) == 3.1 * frames / frames);
        digests[k] = swWorld_GetDigest(world);
        swDestroyWorld(world);
    }
    assert_true(digests[0] == digests[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TimeIsTheHostsTimesTheScale),
        cmocka_unit_test(APausedClockStandsAndStepsOnce),
        cmocka_unit_test(FixedStepsComeOutAtTheSameTimesWhateverTheFrames),
        cmocka_unit_test(AFollowingClockMeetsTheServerWithoutRunningBack),
        cmocka_unit_test(SteppingToATimeComesOutThere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
