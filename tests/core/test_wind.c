// SPDX-License-Identifier: MIT
// The wind of a world: gusts, changes, and who takes it.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "seaway/seaway.h"

static swWindDef MakeWind(float speed, float direction)
{
    swWindDef wind = swDefaultWindDef();
    wind.speed = speed;
    wind.direction = direction;
    return wind;
}

static swWorld* MakeWorld(const swWindDef* wind)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    def.wind = *wind;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    return world;
}

static swWaveSystemDef MakeSmallSystem(float speed, float direction)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.minWavelength = 4.0f;
    def.spectrum.windSpeed = speed;
    def.spectrum.direction = direction;
    def.spectrum.hasWind = true;
    return def;
}

static swWaveSystemId AddSystem(swWorld* world, const swWaveSystemDef* def)
{
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, def, &id), SW_SUCCESS);
    return id;
}

static swVec2 FindWind(const swWorld* world, double time, double x, double z)
{
    swVec2 wind;
    swWorld_FindWind(world, time, 1, &(swPosXZ){x, z}, &wind);
    return wind;
}

static void AWorldThatNamesNoWindHasNone(void** state)
{
    (void)state;
    swWindDef none = swDefaultWindDef();
    swWorld* world = MakeWorld(&none);
    swVec2 wind = FindWind(world, 10.0, 3.0, 4.0);
    assert_true(wind.x == 0.0f && wind.y == 0.0f);
    uint64_t digest = swWorld_GetDigest(world);
    none.direction = 1.0f;
    none.gustStrength = 0.5f;
    assert_int_equal(swWorld_SetWind(world, &none, 0.0), SW_SUCCESS);
    assert_true(swWorld_GetDigest(world) == digest);
    none.speed = 5.0f;
    assert_int_equal(swWorld_SetWind(world, &none, 0.0), SW_SUCCESS);
    assert_true(swWorld_GetDigest(world) != digest);
    swDestroyWorld(world);
}

// Over many time scales, at one place.
static void GustsHaveTheAskedMeanAndDeviation(void** state)
{
    (void)state;
    swWindDef def = MakeWind(12.0f, 0.7f);
    def.gustStrength = 0.15f;
    swWorld* world = MakeWorld(&def);
    const double unitX = cos(0.7), unitZ = sin(0.7);
    double sums[2] = {0.0}, squares[2] = {0.0};
    const int count = 40000;
    for (int i = 0; i < count; i++)
    {
        swVec2 wind = FindWind(world, 1.7 * i, 1e5, -3e5);
        double along = (double)wind.x * unitX + (double)wind.y * unitZ - 12.0;
        double across = (double)wind.y * unitX - (double)wind.x * unitZ;
        sums[0] += along / count;
        sums[1] += across / count;
        squares[0] += along * along / count;
        squares[1] += across * across / count;
    }
    double along = sqrt(squares[0]), across = sqrt(squares[1]);
    print_message("mean off by %.3f and %.3f m/s, deviations %.3f (1.8) and %.3f (1.35) m/s\n", sums[0], sums[1], along,
                  across);
    assert_true(fabs(sums[0]) < 0.05 && fabs(sums[1]) < 0.05);
    assert_true(fabs(along - 1.8) < 0.05 && fabs(across - 1.35) < 0.05);
    swDestroyWorld(world);
}

static void TheMeanCarriesItsGusts(void** state)
{
    (void)state;
    swWindDef def = MakeWind(8.0f, -2.0f);
    def.gustStrength = 0.2f;
    swWorld* world = MakeWorld(&def);
    double worst = 0.0, change = 0.0;
    for (int i = 0; i < 200; i++)
    {
        double x = 57.0 * i, z = -31.0 * i, time = 3.0 * i, later = 7.5;
        swVec2 here = FindWind(world, time, x, z);
        swVec2 there = FindWind(world, time + later, x + 8.0 * later * cos(-2.0), z + 8.0 * later * sin(-2.0));
        swVec2 stays = FindWind(world, time + later, x, z);
        worst = fmax(worst, hypot((double)(here.x - there.x), (double)(here.y - there.y)));
        change = fmax(change, hypot((double)(here.x - stays.x), (double)(here.y - stays.y)));
    }
    print_message("a gust carried for 7.5 s differs by %.1e m/s; at a place the wind changes by up to %.1f\n", worst,
                  change);
    assert_true(worst < 1e-4 && change > 1.0);
    swDestroyWorld(world);
}

static void WindsDependOnPlaceAndTimeAlone(void** state)
{
    (void)state;
    swWindDef def = MakeWind(10.0f, 0.3f);
    def.gustStrength = 0.1f;
    swWorld* world = MakeWorld(&def);
    swVec2 before = FindWind(world, 5.0, 1e6, 2e6);
    assert_int_equal(swWorld_StepTo(world, 5.0), SW_SUCCESS);
    swVec2 now = FindWind(world, SW_QUERY_NOW, 1e6, 2e6);
    assert_memory_equal(&before, &now, sizeof(now));
    swWorld_SetOrigin(world, (swPosXZ){1e6, 1e6});
    swVec2 moved = FindWind(world, SW_QUERY_NOW, 0.0, 1e6);
    assert_memory_equal(&before, &moved, sizeof(now));
    swPosXZ bad[3] = {{(double)NAN, 0.0}, {0.0, 1e13}, {0.0, 0.0}};
    swVec2 winds[3];
    swWorld_FindWind(world, 0.0, 3, bad, winds);
    assert_true(isnan(winds[0].x) && isnan(winds[1].y) && isfinite(winds[2].x));
    swDestroyWorld(world);
}

static void AWindTurnsIntoAnotherWithoutAJump(void** state)
{
    (void)state;
    swWindDef def = MakeWind(10.0f, 0.0f), other = MakeWind(6.0f, 1.5f), third = MakeWind(14.0f, -1.0f);
    swWorld* world = MakeWorld(&def);
    swVec2 before = FindWind(world, 0.0, 0.0, 0.0);
    assert_int_equal(swWorld_SetWind(world, &other, 20.0), SW_SUCCESS);
    double worst = 0.0;
    for (int i = 1; i <= 300; i++)
    {
        if (i == 100)
        {
            assert_int_equal(swWorld_SetWind(world, &third, 10.0), SW_SUCCESS);
        }
        assert_int_equal(swWorld_StepTo(world, 0.1 * i), SW_SUCCESS);
        swVec2 now = FindWind(world, SW_QUERY_NOW, 0.0, 0.0);
        worst = fmax(worst, hypot((double)(now.x - before.x), (double)(now.y - before.y)));
        before = now;
    }
    print_message("within a tenth of a second the wind changes by at most %.3f m/s\n", worst);
    assert_true(worst < 0.25);
    assert_true(fabs((double)before.x - 14.0 * cos(-1.0)) < 1e-5 && fabs((double)before.y - 14.0 * sin(-1.0)) < 1e-5);
    swDestroyWorld(world);
}

// The same waves as those of a system whose own wind it is, to the bit.
static void SystemsThatTakeTheWindAreMadeOfIt(void** state)
{
    (void)state;
    swWindDef wind = MakeWind(9.0f, 0.5f);
    swWorld* taking = MakeWorld(&wind);
    swWorld* owning = MakeWorld(&wind);
    swWaveSystemDef def = MakeSmallSystem(15.0f, 2.0f);
    def.takesWind = true;
    swWaveSystemId id = AddSystem(taking, &def);
    swWaveSystemDef own = MakeSmallSystem(9.0f, 0.5f);
    AddSystem(owning, &own);
    assert_int_equal(swWorld_Step(taking, 1.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(owning, 1.0), SW_SUCCESS);
    double x = 3.0, z = 5.0;
    double expected = swMoment_GetHeight(swWorld_GetMoment(owning), x, z);
    assert_true(swMoment_GetHeight(swWorld_GetMoment(taking), x, z) == expected);
    swWaveSystemDef got = swWaveSystem_Get(taking, id);
    assert_true(got.takesWind && got.spectrum.windSpeed == 15.0f && got.spectrum.direction == 2.0f);

    // With the wind it changes, over a while, and to what another system of that wind is; its weight goes on running.
    wind = MakeWind(13.0f, 1.5f);
    swWaveSystem_FadeWeight(taking, id, 0.5f, 4.0);
    assert_int_equal(swWorld_SetWind(taking, &wind, 2.0), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(taking, 3.0), SW_SUCCESS);
    assert_true(swWaveSystem_GetWeight(taking, id) == 0.75f);
    assert_int_equal(swWorld_StepTo(taking, 6.0), SW_SUCCESS);
    own = MakeSmallSystem(13.0f, 1.5f);
    own.weight = 0.5f;
    swWorld* third = MakeWorld(&wind);
    AddSystem(third, &own);
    assert_int_equal(swWorld_StepTo(third, 6.0), SW_SUCCESS);
    assert_true(swMoment_GetHeight(swWorld_GetMoment(taking), x, z) ==
                swMoment_GetHeight(swWorld_GetMoment(third), x, z));

    // Without a wind of the world it has its own again.
    wind = swDefaultWindDef();
    assert_int_equal(swWorld_SetWind(taking, &wind, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(taking, 7.0), SW_SUCCESS);
    assert_true(swWorld_GetFoamState(taking).windSpeed < 15.1f && swWorld_GetFoamState(taking).windSpeed > 3.0f);
    got = swWaveSystem_Get(taking, id);
    assert_true(got.spectrum.windSpeed == 15.0f && got.weight == 0.5f);
    swDestroyWorld(taking);
    swDestroyWorld(owning);
    swDestroyWorld(third);
}

static void WhitecapsTakeTheWorldsWindUnlessTheyNameOne(void** state)
{
    (void)state;
    swWindDef wind = MakeWind(21.0f, 0.5f);
    swWorld* world = MakeWorld(&wind);
    swWaveSystemDef def = MakeSmallSystem(9.0f, 0.5f);
    AddSystem(world, &def);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_float_equal(swWorld_GetFoamState(world).windSpeed, 21.0f, 1e-4f);
    swFoamDef foam = swDefaultFoamDef();
    foam.windSpeed = 5.0f;
    swWorld_SetFoam(world, &foam);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_true(swWorld_GetFoamState(world).windSpeed == 5.0f);
    swDestroyWorld(world);
}

static void AWindIsSavedAndComesBackInTheMiddleOfAChange(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWindDef wind = MakeWind(7.0f, 0.5f), other = MakeWind(11.0f, 2.5f);
    wind.gustStrength = other.gustStrength = 0.12f;
    other.gustSeed = 9;
    swWorld* world = MakeWorld(&wind);
    swWaveSystemDef def = MakeSmallSystem(15.0f, 2.0f);
    def.takesWind = true;
    AddSystem(world, &def);
    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    assert_int_equal(swWorld_SetWind(world, &other, 10.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 4.0), SW_SUCCESS);
    size_t size = 0;
    swWorld_Save(world, NULL, &size);
    void* data = malloc(size);
    assert_non_null(data);
    assert_int_equal(swWorld_Save(world, data, &size), SW_SUCCESS);
    uint64_t digest = swWorld_GetDigest(world);
    swVec2 now = FindWind(world, SW_QUERY_NOW, 50.0, 60.0), later = FindWind(world, 9.0, 50.0, 60.0);

    swRestoreDef restore = swDefaultRestoreDef();
    swWorld* restored = NULL;
    assert_int_equal(swRestoreWorld(&host, data, size, &restore, &restored), SW_SUCCESS);
    assert_true(swWorld_GetDigest(restored) == digest);
    assert_true(swWorld_GetWind(restored).gustSeed == 9);
    swVec2 again[2] = {FindWind(restored, SW_QUERY_NOW, 50.0, 60.0), FindWind(restored, 9.0, 50.0, 60.0)};
    assert_memory_equal(&again[0], &now, sizeof(now));
    assert_memory_equal(&again[1], &later, sizeof(later));
    swWaveSystemDef back = swWaveSystem_Get(restored, (swWaveSystemId){1, 1});
    assert_true(back.takesWind && back.spectrum.windSpeed == 15.0f);

    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    assert_int_equal(swWorld_Rewind(world, data, size), SW_SUCCESS);
    assert_true(swWorld_GetDigest(world) == digest);
    swDestroyWorld(restored);
    swDestroyWorld(world);
    free(data);
}

static swVec2 AskWind(const swMoment* moment, double x)
{
    swVec2 wind;
    assert_int_equal(swMoment_QueryFields(moment, 1, &(swPosXZ){x, 40.0}, &(swFieldSamples){.wind = &wind}), 0);
    return wind;
}

// The world's wind lies below all inputs of wind: where none is, and in a lee that halves it.
static void FieldsHaveTheWorldsWindBelowTheInputs(void** state)
{
    (void)state;
    swWindDef def = MakeWind(12.0f, 0.5f);
    def.gustStrength = 0.2f;
    swWorld* world = MakeWorld(&def);
    assert_int_equal(swWorld_Step(world, 3.0), SW_SUCCESS);
    swVec2 there = FindWind(world, SW_QUERY_NOW, 0.0, 40.0), away = FindWind(world, SW_QUERY_NOW, 5000.0, 40.0);
    swVec2 found = AskWind(swWorld_GetMoment(world), 0.0);
    assert_true(found.x == there.x && found.y == there.y && there.x > 5.0f);
    swInputDef lee = swDefaultInputDef();
    swInputId id;
    lee.field = SW_INPUT_WIND;
    lee.shape = SW_SHAPE_CIRCLE;
    lee.size.x = 400.0f;
    lee.blend = SW_BLEND_MULTIPLY;
    lee.value[0] = lee.value[1] = 0.5f;
    assert_int_equal(swCreateInput(world, &lee, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    found = AskWind(swWorld_GetMoment(world), 0.0);
    assert_true(found.x == 0.5f * there.x && found.y == 0.5f * there.y);
    found = AskWind(swWorld_GetMoment(world), 5000.0);
    assert_true(found.x == away.x && found.y == away.y);
    // A moment has the wind of its time, and so has who maps it.
    swMomentDef later = swDefaultMomentDef();
    later.time = 60.0;
    swMoment* moment = NULL;
    assert_int_equal(swCreateMoment(world, &later, &moment), SW_SUCCESS);
    swVec2 then = FindWind(world, 60.0, 0.0, 40.0);
    found = AskWind(moment, 0.0);
    assert_true(found.x == 0.5f * then.x && found.y == 0.5f * then.y && then.x != there.x);
    swDestroyMoment(moment);
    swDestroyWorld(world);
}

static void WhatIsNoWindIsRefused(void** state)
{
    (void)state;
    swWindDef wind = MakeWind(7.0f, 0.5f);
    swWorld* world = MakeWorld(&wind);
    swWindDef bad = MakeWind(NAN, 0.0f);
    assert_int_equal(swWorld_SetWind(world, &bad, 0.0), SW_ERROR_INVALID);
    bad = MakeWind(101.0f, 0.0f);
    assert_int_equal(swWorld_SetWind(world, &bad, 0.0), SW_ERROR_INVALID);
    assert_true(swWorld_GetWind(world).speed == 7.0f);
    swWaveComponent component = {.wavelength = 20.0f, .amplitude = 0.5f};
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = &component;
    def.componentCount = 1;
    def.takesWind = true;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_ERROR_INVALID);
    swDestroyWorld(world);
}

static swVec2 QueryWind(const swMoment* moment, double x, double z)
{
    swVec2 wind;
    const swFieldSamples samples = {.wind = &wind};
    swMoment_QueryFields(moment, 1, &(swPosXZ){x, z}, &samples);
    return wind;
}

// A lee of half the wind around the origin.
static void InputsOfWindChangeTheWorldsWind(void** state)
{
    (void)state;
    swWindDef def = MakeWind(10.0f, 0.3f);
    def.gustStrength = 0.1f;
    swWorld* world = MakeWorld(&def);
    assert_int_equal(swWorld_StepTo(world, 5.0), SW_SUCCESS);
    swVec2 open = FindWind(world, SW_QUERY_NOW, 10.0, 20.0), asked = QueryWind(swWorld_GetMoment(world), 10.0, 20.0);
    assert_memory_equal(&open, &asked, sizeof open);
    swInputDef lee = swDefaultInputDef();
    lee.field = SW_INPUT_WIND;
    lee.shape = SW_SHAPE_CIRCLE;
    lee.blend = SW_BLEND_MULTIPLY;
    lee.value[0] = lee.value[1] = 0.5f;
    swInputId id;
    assert_int_equal(swCreateInput(world, &lee, &id), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(world, 6.0), SW_SUCCESS);
    open = FindWind(world, SW_QUERY_NOW, 10.0, 20.0);
    asked = QueryWind(swWorld_GetMoment(world), 10.0, 20.0);
    assert_true(open.x > 4.0f && asked.x == 0.5f * open.x && asked.y == 0.5f * open.y);
    open = FindWind(world, SW_QUERY_NOW, 900.0, 20.0);
    asked = QueryWind(swWorld_GetMoment(world), 900.0, 20.0);
    assert_memory_equal(&open, &asked, sizeof open);
    swMomentDef momentDef = swDefaultMomentDef();
    swMoment* moment = NULL;
    momentDef.time = 9.0;
    assert_int_equal(swCreateMoment(world, &momentDef, &moment), SW_SUCCESS);
    open = FindWind(world, 9.0, 10.0, 20.0);
    asked = QueryWind(moment, 10.0, 20.0);
    assert_true(asked.x == 0.5f * open.x && asked.y == 0.5f * open.y);
    swDestroyMoment(moment);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWorldThatNamesNoWindHasNone),
        cmocka_unit_test(GustsHaveTheAskedMeanAndDeviation),
        cmocka_unit_test(TheMeanCarriesItsGusts),
        cmocka_unit_test(WindsDependOnPlaceAndTimeAlone),
        cmocka_unit_test(AWindTurnsIntoAnotherWithoutAJump),
        cmocka_unit_test(SystemsThatTakeTheWindAreMadeOfIt),
        cmocka_unit_test(WhitecapsTakeTheWorldsWindUnlessTheyNameOne),
        cmocka_unit_test(AWindIsSavedAndComesBackInTheMiddleOfAChange),
        cmocka_unit_test(InputsOfWindChangeTheWorldsWind),
        cmocka_unit_test(FieldsHaveTheWorldsWindBelowTheInputs),
        cmocka_unit_test(WhatIsNoWindIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
