// SPDX-License-Identifier: MIT
// Tides: the sum of their constituents, equal everywhere to the bit, as levels and as streams.

#include "support/cmocka_setup.h"

#include <math.h>

#include <seaway/seaway.h>

#include "scenarios/scenario.h"

static void SpeedsAreThoseOfTheMoonAndTheSun(void** state)
{
    (void)state;
    const double day = 86400.0;
    const double turn = 2.0 * 3.14159265358979;
    assert_float_equal((float)(turn / (double)swGetTideSpeed("S2")), (float)(day / 2.0), 0.01f);
    assert_float_equal((float)(turn / (double)swGetTideSpeed("M2")), 44714.16f, 0.1f); // 12.4206012 h
    assert_float_equal((float)(turn / (double)swGetTideSpeed("K1")), 86164.09f, 0.1f); // a sidereal day
    assert_float_equal((float)(turn / (double)swGetTideSpeed("O1")), 92949.63f, 0.1f); // 25.8193417 h
    assert_true(swGetTideSpeed("M9") == 0.0f && swGetTideSpeed(NULL) == 0.0f);
    swTideConstituent none;
    assert_false(swSetTideConstituent("nothing", 1.0f, 0.0f, &none));
    assert_true(none.amplitude == 0.0f);
}

static swInputDef MakeTide(swInputField field)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.blend = SW_BLEND_ADD;
    assert_true(swSetTideConstituent("M2", 2.1f, 1.2f, &def.tide[0]));
    assert_true(swSetTideConstituent("S2", 0.7f, -0.4f, &def.tide[1]));
    assert_true(swSetTideConstituent("K1", 0.3f, 2.0f, &def.tide[2]));
    def.tide[0].amplitudeAcross = 0.5f;
    def.tide[0].phaseAcross = 1.2f + 1.5707963f;
    return def;
}

// In double, by the C library.
static double SumUp(const swInputDef* def, double time, bool isAcross)
{
    double sum = 0.0;
    for (int i = 0; i < SW_MAX_TIDE; ++i)
    {
        const swTideConstituent* c = &def->tide[i];
        double amplitude = (double)(isAcross ? c->amplitudeAcross : c->amplitude);
        sum += amplitude * cos((double)c->speed * time - (double)(isAcross ? c->phaseAcross : c->phase));
    }
    return sum;
}

static void LevelsAreTheSumOfConstituentsEverywhere(void** state)
{
    (void)state;
    Scenario sea;
    ScenarioDef calm = DefaultScenarioDef(SCENARIO_CALM);
    assert_int_equal(CreateScenario(&calm, &sea), SW_SUCCESS);
    swInputDef def = MakeTide(SW_INPUT_LEVEL);
    def.value[0] = 0.25f;
    swInputId id;
    assert_int_equal(swCreateInput(sea.world, &def, &id), SW_SUCCESS);
    const swPosXZ points[4] = {{0.0, 0.0}, {1e6, -1e6}, {-37.3, 12345.6}, {5e7, 1.0}};
    double worst = 0.0, highest = 0.0;
    for (int i = 0; i < 120; ++i)
    {
        assert_int_equal(swWorld_Step(sea.world, 1800.0), SW_SUCCESS);
        float heights[4];
        swQueryDef query = swDefaultQueryDef();
        const swSurfaceSamples samples = {.height = heights};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &query, 4, points, &samples, NULL);
        for (int p = 1; p < 4; ++p)
        {
            assert_true(heights[p] == heights[0]);
        }
        double expected = 0.25 + SumUp(&def, swWorld_GetTime(sea.world), false);
        worst = fmax(worst, fabs((double)heights[0] - expected));
        highest = fmax(highest, fabs(expected));
    }
    print_message("two and a half days of tide, up to %.2f m: off by %.2g m\n", highest, worst);
    assert_true(worst < 2e-6 && highest > 2.0);
    DestroyScenario(&sea);
}

static void StreamsGoAroundTheirEllipses(void** state)
{
    (void)state;
    Scenario sea;
    ScenarioDef calm = DefaultScenarioDef(SCENARIO_CALM);
    calm.enableMotion = true;
    assert_int_equal(CreateScenario(&calm, &sea), SW_SUCCESS);
    swInputDef def = MakeTide(SW_INPUT_FLOW);
    swInputId id;
    assert_int_equal(swCreateInput(sea.world, &def, &id), SW_SUCCESS);
    for (int i = 0; i < 48; ++i)
    {
        assert_int_equal(swWorld_Step(sea.world, 1800.0), SW_SUCCESS);
        const swPosXZ point = {100.0, -20.0};
        swVec3 velocity;
        swQueryDef query = swDefaultQueryDef();
        const swSurfaceSamples samples = {.velocity = &velocity};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &query, 1, &point, &samples, NULL);
        double time = swWorld_GetTime(sea.world);
        assert_float_equal(velocity.x, (float)SumUp(&def, time, false), 2e-6f);
        assert_float_equal(velocity.z, (float)SumUp(&def, time, true), 2e-6f);
    }
    DestroyScenario(&sea);
}

static void OnlyLevelsAndFlowsHaveTides(void** state)
{
    (void)state;
    Scenario sea;
    ScenarioDef calm = DefaultScenarioDef(SCENARIO_CALM);
    assert_int_equal(CreateScenario(&calm, &sea), SW_SUCCESS);
    swInputDef def = MakeTide(SW_INPUT_FOAM);
    swInputId id;
    assert_int_equal(swCreateInput(sea.world, &def, &id), SW_ERROR_INVALID);
    DestroyScenario(&sea);
}

// High and low waters, unevenly apart.
static const swTideLevel waters[] = {{0.0, 1.0f},      {22000.0, -1.4f}, {45000.0, 1.3f},
                                     {66000.0, -1.0f}, {90000.0, 1.8f},  {111000.0, -1.6f}};

static void ATableOfHighAndLowWatersIsReadAsByACosine(void** state)
{
    (void)state;
    double worst = 0.0;
    for (int i = 0; i + 1 < 6; ++i)
    {
        double from = (double)waters[i].level, to = (double)waters[i + 1].level;
        assert_true(swGetTideOfTable(6, waters, waters[i].time) == waters[i].level);
        for (int k = 0; k <= 50; ++k)
        {
            double t = k / 50.0, time = waters[i].time + t * (waters[i + 1].time - waters[i].time);
            double level = (double)swGetTideOfTable(6, waters, time);
            double cosine = 0.5 * (from + to) + 0.5 * (from - to) * cos(SW_PI * t);
            worst = fmax(worst, fabs(level - cosine) / fabs(to - from));
            assert_true(level <= fmax(from, to) && level >= fmin(from, to));
        }
    }
    print_message("at most %.4f of a rise off the cosine\n", worst);
    assert_true(worst < 0.0101);
}

static void ATableOfEachHalfHourFollowsItsTide(void** state)
{
    (void)state;
    swInputDef def = MakeTide(SW_INPUT_LEVEL);
    swTideLevel table[120];
    double largest = 0.0, worst = 0.0;
    for (int i = 0; i < 120; ++i)
    {
        table[i] = (swTideLevel){1800.0 * i, (float)SumUp(&def, 1800.0 * i, false)};
        largest = fmax(largest, fabs((double)table[i].level));
    }
    for (int i = 18; i < 118 * 18; ++i) // at its ends the level stands
    {
        double time = 100.0 * i, level = (double)swGetTideOfTable(120, table, time);
        worst = fmax(worst, fabs(level - SumUp(&def, time, false)));
    }
    print_message("a table of half hours is off by %.4f of %.2f m\n", worst, largest);
    assert_true(worst < 0.01 * largest);
}

static void BeyondATableTheLevelStandsAndBadLinesAreNoNumber(void** state)
{
    (void)state;
    assert_true(swGetTideOfTable(6, waters, -1e6) == 1.0f && swGetTideOfTable(6, waters, 1e6) == -1.6f);
    assert_true(swGetTideOfTable(1, waters, 50.0) == 1.0f);
    assert_true(isnan(swGetTideOfTable(6, waters, (double)NAN)));
    const swTideLevel bad[3] = {{0.0, 1.0f}, {(double)NAN, 2.0f}, {10.0, 1.0f}};
    assert_true(isnan(swGetTideOfTable(3, bad, 5.0)));
    const swTideLevel none[2] = {{(double)NAN, 1.0f}, {10.0, 2.0f}};
    assert_true(isnan(swGetTideOfTable(2, none, 5.0)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SpeedsAreThoseOfTheMoonAndTheSun),
        cmocka_unit_test(LevelsAreTheSumOfConstituentsEverywhere),
        cmocka_unit_test(StreamsGoAroundTheirEllipses),
        cmocka_unit_test(OnlyLevelsAndFlowsHaveTides),
        cmocka_unit_test(ATableOfHighAndLowWatersIsReadAsByACosine),
        cmocka_unit_test(ATableOfEachHalfHourFollowsItsTide),
        cmocka_unit_test(BeyondATableTheLevelStandsAndBadLinesAreNoNumber),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
