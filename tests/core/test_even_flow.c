// SPDX-License-Identifier: MIT
// Inputs of flow that are everywhere carry all waves by one exact path: frequencies are those of the dispersion plus
// k . U, tides are integrated in a closed form, and what other inputs say beside it changes nothing elsewhere.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/frame/frame.h"
#include "scenarios/scenario.h"
#include "support/saved.h"
#include "support/scatter.h"

#define POINTS 60

static swInputDef Everywhere(float x, float z)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.shape = SW_SHAPE_EVERYWHERE;
    def.value[0] = x;
    def.value[1] = z;
    return def;
}

static void TwoTides(swInputDef* def)
{
    def->tide[0] = (swTideConstituent){
        .speed = swGetTideSpeed("M2"), .amplitude = 1.2f, .phase = 0.7f, .amplitudeAcross = 0.4f, .phaseAcross = 2.1f};
    def->tide[1] = (swTideConstituent){.speed = 0.01f, .amplitude = 0.5f, .phase = -1.0f};
}

static swInputId Add(swWorld* world, const swInputDef* def)
{
    swInputId id;
    assert_int_equal(swCreateInput(world, def, &id), SW_SUCCESS);
    return id;
}

// An FFT system and some free waves.
static void OpenSea(Scenario* sea)
{
    ScenarioDef def = DefaultScenarioDef(SCENARIO_BREEZE);
    def.resolution = 64;
    assert_int_equal(CreateScenario(&def, sea), SW_SUCCESS);
    swWaveSystemDef waves = swWaveSystem_Get(sea->world, sea->systems[0]);
    waves.method = SW_WAVES_GERSTNER;
    waves.componentsPerOctave = 2;
    waves.minWavelength = 8.0f;
    waves.seed = 9;
    assert_int_equal(swCreateWaveSystem(sea->world, &waves, &sea->systems[1]), SW_SUCCESS);
    sea->systemCount = 2;
}

static void FindParticles(const swMoment* moment, double time, swPosXZ shift, const swPosXZ* points, swVec3* moved)
{
    swPosXZ places[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        places[i] = (swPosXZ){points[i].x - shift.x, points[i].z - shift.z};
    }
    swQueryDef def = swDefaultQueryDef();
    def.time = time;
    const swSurfaceSamples samples = {.displacement = moved};
    swMoment_QueryParticles(moment, &def, POINTS, places, &samples, NULL, NULL);
}

static double Farthest(const swVec3* a, const swVec3* b)
{
    double worst = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        double x = (double)a[i].x - (double)b[i].x, y = (double)a[i].y - (double)b[i].y;
        double z = (double)a[i].z - (double)b[i].z;
        worst = fmax(worst, sqrt(x * x + y * y + z * z));
    }
    return worst;
}

// What a pole counts over a day of a single wave: now, at other times, and in moments of other times.
static void FrequenciesShiftByDoppler(void** state)
{
    (void)state;
    ScenarioDef calm = DefaultScenarioDef(SCENARIO_CALM);
    const float speeds[] = {0.5f, -2.0f, 3.0f};
    for (int s = 0; s < 3; ++s)
    {
        Scenario sea;
        assert_int_equal(CreateScenario(&calm, &sea), SW_SUCCESS);
        swWaveComponent wave = {.wavelength = 25.0f, .direction = 0.4f, .amplitude = 0.3f};
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.method = SW_WAVES_GERSTNER;
        def.components = &wave;
        def.componentCount = 1;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(sea.world, &def, &id), SW_SUCCESS);
        swInputDef flow = Everywhere(speeds[s], 0.25f);
        Add(sea.world, &flow);
        assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
        double k = 2.0 * 3.14159265358979 / 25.0;
        double tension = (double)swDefaultWorldDef().surfaceTension;
        double omega = sqrt((double)swDefaultWorldDef().gravity * k + tension * k * k * k);
        double doppler = k * (cos((double)0.4f) * (double)speeds[s] + sin((double)0.4f) * 0.25);
        double worst[3] = {0.0};
        for (int i = 0; i < 200; ++i)
        {
            double time = 432.1 * i;
            double expected = 0.3 * cos((omega + doppler) * time);
            const swPosXZ origin = {0.0, 0.0};
            swVec3 moved;
            const swSurfaceSamples samples = {.displacement = &moved};
            swQueryDef at = swDefaultQueryDef();
            at.time = time;
            swMoment_QueryParticles(swWorld_GetMoment(sea.world), &at, 1, &origin, &samples, NULL, NULL);
            worst[0] = fmax(worst[0], fabs((double)moved.y - expected));
            swMomentDef momentDef = swDefaultMomentDef();
            momentDef.time = time;
            swMoment* moment;
            assert_int_equal(swCreateMoment(sea.world, &momentDef, &moment), SW_SUCCESS);
            at.time = SW_QUERY_NOW;
            swMoment_QueryParticles(moment, &at, 1, &origin, &samples, NULL, NULL);
            worst[1] = fmax(worst[1], fabs((double)moved.y - expected));
            swDestroyMoment(moment);
            assert_int_equal(swWorld_StepTo(sea.world, time), SW_SUCCESS);
            swMoment_QueryParticles(swWorld_GetMoment(sea.world), &at, 1, &origin, &samples, NULL, NULL);
            worst[2] = fmax(worst[2], fabs((double)moved.y - expected));
        }
        print_message("%4.1f m/s: height off by %.2g m of 0.3 at other times, %.2g in moments, %.2g in steps\n",
                      (double)speeds[s], worst[0], worst[1], worst[2]);
        // An error of a frequency by one part in a million would be 0.1 rad by then.
        assert_true(worst[0] < 1e-6 && worst[1] < 1e-6 && worst[2] < 1e-6);
        DestroyScenario(&sea);
    }
}

// Midpoints of many short steps.
static swPosXZ SumTides(const swInputDef* def, double seconds)
{
    swPosXZ path = {0.0, 0.0};
    const int count = 200000;
    for (int i = 0; i < count; ++i)
    {
        double time = seconds * (i + 0.5) / count, x = (double)def->value[0], z = (double)def->value[1];
        for (int k = 0; k < SW_MAX_TIDE; ++k)
        {
            const swTideConstituent* tide = &def->tide[k];
            x += (double)tide->amplitude * cos((double)tide->speed * time - (double)tide->phase);
            z += (double)tide->amplitudeAcross * cos((double)tide->speed * time - (double)tide->phaseAcross);
        }
        path.x += x * seconds / count;
        path.z += z * seconds / count;
    }
    return path;
}

static void TheSeaIsThatOfStillWaterCarriedByTides(void** state)
{
    (void)state;
    Scenario still, carried;
    OpenSea(&still);
    OpenSea(&carried);
    swInputDef flow = Everywhere(0.8f, -0.3f);
    TwoTides(&flow);
    Add(carried.world, &flow);
    swPosXZ points[POINTS];
    ScatterPoints(points, POINTS, 3000.0, -2000.0, 400.0);
    const double times[] = {0.0, 12.5, 3600.0, 86400.0};
    double worst = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        swVec3 before[POINTS], after[POINTS];
        assert_int_equal(swWorld_StepTo(still.world, times[i]), SW_SUCCESS);
        assert_int_equal(swWorld_StepTo(carried.world, times[i]), SW_SUCCESS);
        for (int ahead = 0; ahead < 2; ++ahead) // the tiles, and waves one by one
        {
            double asked = ahead == 0 ? SW_QUERY_NOW : times[i] + 30.0;
            swPosXZ path = SumTides(&flow, times[i] + 30.0 * ahead);
            FindParticles(swWorld_GetMoment(still.world), asked, path, points, before);
            FindParticles(swWorld_GetMoment(carried.world), asked, (swPosXZ){0.0, 0.0}, points, after);
            worst = fmax(worst, Farthest(before, after));
        }
    }
    print_message("particles of a sea that tides carry over a day are off by %.2g m\n", worst);
    assert_true(worst < 5e-5);
    DestroyScenario(&still);
    DestroyScenario(&carried);
}

// The path is a function of time: steps of any length lead to the same bits.
static void StepsLeaveNoTrace(void** state)
{
    (void)state;
    Scenario seas[2];
    swPosXZ points[POINTS];
    swVec3 moved[2][POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    for (int k = 0; k < 2; ++k)
    {
        OpenSea(&seas[k]);
        swInputDef flow = Everywhere(0.8f, -0.3f);
        TwoTides(&flow);
        Add(seas[k].world, &flow);
        for (int i = 0; i < 97 && k == 0; ++i)
        {
            assert_int_equal(swWorld_Step(seas[k].world, 0.003 * (i % 7) + 0.01), SW_SUCCESS);
        }
        assert_int_equal(swWorld_StepTo(seas[k].world, 100.0), SW_SUCCESS);
        FindParticles(swWorld_GetMoment(seas[k].world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, moved[k]);
    }
    assert_memory_equal(moved[0], moved[1], sizeof moved[0]);
    assert_true(swWorld_GetDigest(seas[0].world) == swWorld_GetDigest(seas[1].world));
    DestroyScenario(&seas[0]);
    DestroyScenario(&seas[1]);
}

// A river in a tidal stream: elsewhere waves keep their bits, as it comes and goes, whatever its blend.
static void OtherFlowsChangeNothingElsewhere(void** state)
{
    (void)state;
    const swInputBlend blends[] = {SW_BLEND_ADD, SW_BLEND_ALPHA, SW_BLEND_REPLACE, SW_BLEND_MAX};
    for (int b = 0; b < 4; ++b)
    {
        Scenario sea;
        OpenSea(&sea);
        swInputDef flow = Everywhere(0.8f, -0.3f);
        TwoTides(&flow);
        Add(sea.world, &flow);
        swInputDef eddy = Everywhere(1.5f, 1.0f);
        eddy.shape = SW_SHAPE_CIRCLE;
        eddy.size.x = 100.0f;
        eddy.feather = 20.0f;
        eddy.blend = blends[b];
        eddy.isEnabled = false;
        swInputId id = Add(sea.world, &eddy);
        swPosXZ points[POINTS];
        swVec3 without[POINTS], with[POINTS];
        ScatterPoints(points, POINTS, 0.0, 0.0, 40.0);
        for (int i = 0; i < POINTS; i += 2)
        {
            points[i].x += 300.0;
        }
        assert_int_equal(swWorld_StepTo(sea.world, 50.0), SW_SUCCESS);
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, without);
        eddy.isEnabled = true;
        assert_int_equal(swInput_Set(sea.world, id, &eddy), SW_SUCCESS);
        assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, with);
        double changed = 0.0;
        for (int i = 0; i < POINTS; ++i)
        {
            bool isSame = memcmp(&with[i], &without[i], sizeof with[i]) == 0;
            assert_true(isSame || i % 2 == 1);
            changed += i % 2 == 1 && !isSame ? 1.0 : 0.0;
        }
        assert_true(changed > 0.0);
        DestroyScenario(&sea);
    }
}

// Flows that are everywhere come, change and go: nothing moves farther in a step than waves and water do.
static void ChangesDoNotJump(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea);
    swInputDef flow = Everywhere(2.0f, 0.5f);
    swInputId id = Add(sea.world, &flow);
    swPosXZ points[POINTS];
    swVec3 before[POINTS], after[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
    FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, before);
    double most = 0.0;
    for (int step = 0; step < 600; ++step)
    {
        if (step % 100 == 50)
        {
            flow.value[0] = step % 200 == 50 ? -1.0f : 2.0f;
            flow.isEnabled = step != 250;
            assert_int_equal(swInput_Set(sea.world, id, &flow), SW_SUCCESS);
        }
        assert_int_equal(swWorld_Step(sea.world, 0.01), SW_SUCCESS);
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, after);
        most = fmax(most, Farthest(before, after));
        memcpy(before, after, sizeof before);
    }
    print_message("flows that change: at most %.3f m a step of 10 ms\n", most);
    assert_true(most < 0.12);
    DestroyScenario(&sea);
}

// What has no closed form is carried by copies, and not by the path: a tide below a greatest speed.
static void WhatHasNoClosedFormIsLeftToCopies(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea);
    swInputDef flow = Everywhere(0.8f, -0.3f);
    TwoTides(&flow);
    Add(sea.world, &flow);
    swInputDef bound = Everywhere(1.0f, 1.0f);
    bound.blend = SW_BLEND_MIN;
    bound.order = 1;
    Add(sea.world, &bound);
    assert_int_equal(swWorld_StepTo(sea.world, 30.0), SW_SUCCESS);
    const swFrame* frame = swGetWorldFrame(sea.world);
    assert_true(frame->inputs->hasOtherFlows);
    assert_true(frame->inputs->evenX == 0.0f && frame->tiles[0].shiftX == 0.0 && frame->tiles[0].shiftZ == 0.0);
    DestroyScenario(&sea);
}

static void PathsAreSavedAndRewound(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea);
    swInputDef flow = Everywhere(0.8f, -0.3f);
    TwoTides(&flow);
    swInputId id = Add(sea.world, &flow);
    assert_int_equal(swWorld_Step(sea.world, 5.0), SW_SUCCESS);
    flow.value[0] = -1.5f;
    assert_int_equal(swInput_Set(sea.world, id, &flow), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 4.0), SW_SUCCESS);
    Saved saved = Save(sea.world);
    uint64_t early = swWorld_GetDigest(sea.world);
    swHost host = swDefaultHost();
    swRestoreDef restore = swDefaultRestoreDef();
    swWorld* copy = NULL;
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restore, &copy), SW_SUCCESS);
    assert_true(swWorld_GetDigest(copy) == early);
    flow.value[0] = 0.25f;
    assert_int_equal(swInput_Set(sea.world, id, &flow), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 4.0), SW_SUCCESS);
    assert_true(swWorld_GetDigest(sea.world) != early);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_SUCCESS);
    assert_true(swWorld_GetDigest(sea.world) == early);
    swPosXZ points[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    swVec3 a[POINTS], b[POINTS];
    for (int i = 0; i < 3; ++i)
    {
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, a);
        FindParticles(swWorld_GetMoment(copy), SW_QUERY_NOW, (swPosXZ){0.0, 0.0}, points, b);
        assert_memory_equal(a, b, sizeof a);
        assert_int_equal(swWorld_Step(sea.world, 3.0), SW_SUCCESS);
        assert_int_equal(swWorld_Step(copy, 3.0), SW_SUCCESS);
    }
    swDestroyWorld(copy);
    free(saved.data);
    DestroyScenario(&sea);
}

// A moment in memory that another process maps.
static void MomentsHoldThePath(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea);
    swInputDef flow = Everywhere(0.8f, -0.3f);
    TwoTides(&flow);
    Add(sea.world, &flow);
    assert_int_equal(swWorld_StepTo(sea.world, 60.0), SW_SUCCESS);
    swMomentDef def = swDefaultMomentDef();
    def.time = 90.0;
    def.memorySize = swWorld_GetMomentSize(sea.world);
    def.memory = aligned_alloc(64, (def.memorySize + 63) / 64 * 64);
    assert_non_null(def.memory);
    swMoment *moment, *mapped;
    assert_int_equal(swCreateMoment(sea.world, &def, &moment), SW_SUCCESS);
    swHost host = swDefaultHost();
    assert_int_equal(swMapMoment(&host, def.memory, def.memorySize, &mapped), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(sea.world, 90.0), SW_SUCCESS);
    swPosXZ points[POINTS];
    swVec3 a[POINTS], b[POINTS], c[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    for (int i = 0; i < 2; ++i)
    {
        double time = i == 0 ? SW_QUERY_NOW : 120.0;
        FindParticles(swWorld_GetMoment(sea.world), time, (swPosXZ){0.0, 0.0}, points, a);
        FindParticles(moment, time, (swPosXZ){0.0, 0.0}, points, b);
        FindParticles(mapped, time, (swPosXZ){0.0, 0.0}, points, c);
        assert_memory_equal(a, b, sizeof a);
        assert_memory_equal(a, c, sizeof a);
    }
    swDestroyMoment(mapped);
    swDestroyMoment(moment);
    free(def.memory);
    DestroyScenario(&sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(FrequenciesShiftByDoppler), cmocka_unit_test(TheSeaIsThatOfStillWaterCarriedByTides),
        cmocka_unit_test(StepsLeaveNoTrace),         cmocka_unit_test(OtherFlowsChangeNothingElsewhere),
        cmocka_unit_test(ChangesDoNotJump),          cmocka_unit_test(WhatHasNoClosedFormIsLeftToCopies),
        cmocka_unit_test(PathsAreSavedAndRewound),   cmocka_unit_test(MomentsHoldThePath),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
