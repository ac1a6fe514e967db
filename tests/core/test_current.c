// SPDX-License-Identifier: MIT
// Waves in a current that is the same everywhere: those of still water, carried. Their frequencies are those of the
// dispersion plus k . U, for a day; a change of the current never moves them.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/frame/frame.h"
#include "core/surface/evaluate.h"
#include "scenarios/scenario.h"
#include "support/saved.h"
#include "support/scatter.h"

#define POINTS 60

// The breeze's FFT system, and some free waves, in a current.
static void OpenSea(Scenario* sea, float currentX, float currentZ)
{
    ScenarioDef def = DefaultScenarioDef(SCENARIO_BREEZE);
    def.resolution = 64;
    def.enableMotion = true;
    assert_int_equal(CreateScenario(&def, sea), SW_SUCCESS);
    swWaveSystemDef waves = swWaveSystem_Get(sea->world, sea->systems[0]);
    swDestroyWaveSystem(sea->world, sea->systems[0]);
    waves.currentX = currentX;
    waves.currentZ = currentZ;
    assert_int_equal(swCreateWaveSystem(sea->world, &waves, &sea->systems[0]), SW_SUCCESS);
    waves.method = SW_WAVES_GERSTNER;
    waves.componentsPerOctave = 2;
    waves.minWavelength = 8.0f;
    waves.seed = 9;
    assert_int_equal(swCreateWaveSystem(sea->world, &waves, &sea->systems[1]), SW_SUCCESS);
    sea->systemCount = 2;
    assert_int_equal(swWorld_Step(sea->world, 0.0), SW_SUCCESS);
}

static void FindParticles(const swMoment* moment, double time, double shiftX, double shiftZ, const swPosXZ* points,
                          swVec3* moved, swVec3* velocity)
{
    swPosXZ places[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        places[i] = (swPosXZ){points[i].x - shiftX, points[i].z - shiftZ};
    }
    swQueryDef def = swDefaultQueryDef();
    def.time = time;
    const swSurfaceSamples samples = {.displacement = moved, .velocity = velocity};
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

static void TheSeaIsThatOfStillWaterCarried(void** state)
{
    (void)state;
    Scenario still, carried;
    OpenSea(&still, 0.0f, 0.0f);
    OpenSea(&carried, 1.5f, -0.75f);
    swPosXZ points[POINTS];
    ScatterPoints(points, POINTS, 3000.0, -2000.0, 400.0);
    const double times[] = {0.0, 12.5, 3600.0, 86400.0, 1e7};
    double worst = 0.0, worstSpeed = 0.0;
    for (int i = 0; i < 5; ++i)
    {
        swVec3 before[POINTS], after[POINTS], beforeSpeed[POINTS], afterSpeed[POINTS];
        assert_int_equal(swWorld_StepTo(still.world, times[i]), SW_SUCCESS);
        assert_int_equal(swWorld_StepTo(carried.world, times[i]), SW_SUCCESS);
        for (int ahead = 0; ahead < 2; ++ahead) // the tiles, and waves one by one
        {
            double asked = ahead == 0 ? SW_QUERY_NOW : times[i] + 30.0;
            double time = times[i] + 30.0 * ahead;
            FindParticles(swWorld_GetMoment(still.world), asked, 1.5 * time, -0.75 * time, points, before, beforeSpeed);
            FindParticles(swWorld_GetMoment(carried.world), asked, 0.0, 0.0, points, after, afterSpeed);
            worst = fmax(worst, Farthest(before, after));
            worstSpeed = fmax(worstSpeed, Farthest(beforeSpeed, afterSpeed));
        }
    }
    print_message("particles of the carried sea are off by %.2g m and %.2g m/s\n", worst, worstSpeed);
    assert_true(worst < 2e-5 && worstSpeed < 2e-5);
    DestroyScenario(&still);
    DestroyScenario(&carried);
}

// V6 of the dispersion, in a current: what a pole that stands in the water counts over a day.
static void FrequenciesShiftByDoppler(void** state)
{
    (void)state;
    Scenario sea;
    ScenarioDef calm = DefaultScenarioDef(SCENARIO_CALM);
    assert_int_equal(CreateScenario(&calm, &sea), SW_SUCCESS);
    const double g = (double)swDefaultWorldDef().gravity;
    const float speeds[] = {0.5f, -2.0f, 3.0f};
    for (int s = 0; s < 3; ++s)
    {
        swWaveComponent wave = {.wavelength = 25.0f, .direction = 0.4f, .amplitude = 0.3f};
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.method = SW_WAVES_GERSTNER;
        def.components = &wave;
        def.componentCount = 1;
        def.currentX = speeds[s];
        def.currentZ = 0.25f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(sea.world, &def, &id), SW_SUCCESS);
        assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
        double k = 2.0 * 3.14159265358979 / 25.0;
        double tension = (double)swDefaultWorldDef().surfaceTension;
        double omega = sqrt(g * k + tension * k * k * k);
        double doppler = k * (cos((double)0.4f) * (double)speeds[s] + sin((double)0.4f) * 0.25);
        double worst = 0.0;
        for (int i = 0; i < 200; ++i)
        {
            double time = 432.1 * i;
            swQueryDef at = swDefaultQueryDef();
            at.time = time;
            const swPosXZ origin = {0.0, 0.0};
            swVec3 moved;
            const swSurfaceSamples samples = {.displacement = &moved};
            swMoment_QueryParticles(swWorld_GetMoment(sea.world), &at, 1, &origin, &samples, NULL, NULL);
            double expected = 0.3 * cos((omega + doppler) * time);
            worst = fmax(worst, fabs((double)moved.y - expected));
        }
        // An error of a frequency by one part in a million would be 0.1 rad by then.
        print_message("%4.1f m/s: height off by %.2g m of 0.3 over a day\n", (double)speeds[s], worst);
        assert_true(worst < 0.01);
        swDestroyWaveSystem(sea.world, id);
    }
    DestroyScenario(&sea);
}

// The surface's velocity tells how far it may go in a short step.
static void ChangesDoNotJump(void** state)
{
    (void)state;
    const double lengths[] = {0.0, 8.0};
    for (int l = 0; l < 2; ++l)
    {
        Scenario sea;
        OpenSea(&sea, 0.0f, 0.0f);
        swPosXZ points[POINTS];
        ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
        swVec3 before[POINTS], after[POINTS], velocity[POINTS];
        double most = 0.0, travelled = 0.0;
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, 0.0, 0.0, points, before, velocity);
        for (int step = 0; step < 600; ++step)
        {
            if (step % 150 == 0)
            {
                for (int i = 0; i < 2; ++i)
                {
                    swWaveSystemDef def = swWaveSystem_Get(sea.world, sea.systems[i]);
                    def.currentX = step % 300 == 0 ? 2.0f : -1.0f;
                    def.currentZ = 0.5f;
                    assert_int_equal(swWaveSystem_Set(sea.world, sea.systems[i], &def, lengths[l]), SW_SUCCESS);
                    assert_true(swWaveSystem_Get(sea.world, sea.systems[i]).currentX == def.currentX);
                }
            }
            assert_int_equal(swWorld_Step(sea.world, 0.01), SW_SUCCESS);
            FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, 0.0, 0.0, points, after, velocity);
            most = fmax(most, Farthest(before, after));
            memcpy(before, after, sizeof before);
        }
        swPosXZ path = swFindDrift(&swGetWorldFrame(sea.world)->tiles[0].drift, swGetWorldFrame(sea.world)->ticks);
        travelled = sqrt(path.x * path.x + path.z * path.z);
        print_message("changes over %g s: at most %.3f m a step of 10 ms, path %.2f m\n", lengths[l], most, travelled);
        assert_true(most < 0.12);
        assert_true(travelled > 1.0);
        // By wave after wave the path is the same.
        swVec3 summed[POINTS];
        FindParticles(swWorld_GetMoment(sea.world), swWorld_GetTime(sea.world) + 1e-7, 0.0, 0.0, points, summed,
                      velocity);
        assert_true(Farthest(after, summed) < 0.02);
        DestroyScenario(&sea);
    }
}

// Systems of one def share their waves; a current of its own makes a system leave them.
static void SystemsThatShareWavesPart(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea, 0.0f, 0.0f);
    swWaveSystemDef def = swWaveSystem_Get(sea.world, sea.systems[0]);
    swWaveSystemId twin;
    assert_int_equal(swCreateWaveSystem(sea.world, &def, &twin), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 1.0), SW_SUCCESS);
    int shared = swGetWorldFrame(sea.world)->tileCount;
    def.currentX = 1.0f;
    assert_int_equal(swWaveSystem_Set(sea.world, twin, &def, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 1.0), SW_SUCCESS);
    const swFrame* frame = swGetWorldFrame(sea.world);
    assert_int_equal(frame->tileCount, 2 * shared);
    assert_true(frame->tiles[0].shiftX == 0.0);
    assert_true(swWaveSystem_Get(sea.world, sea.systems[0]).currentX == 0.0f);
    DestroyScenario(&sea);
}

// A world goes back over a change that is under way, not over the beginning of one.
static void PathsAreSavedAndRewound(void** state)
{
    (void)state;
    Scenario sea;
    OpenSea(&sea, 1.0f, 0.0f);
    assert_int_equal(swWorld_Step(sea.world, 5.0), SW_SUCCESS);
    swWaveSystemDef def = swWaveSystem_Get(sea.world, sea.systems[0]);
    def.currentX = -2.0f;
    assert_int_equal(swWaveSystem_Set(sea.world, sea.systems[0], &def, 10.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 4.0), SW_SUCCESS);
    Saved saved = Save(sea.world);
    uint64_t early = swWorld_GetDigest(sea.world);
    swHost host = swDefaultHost();
    swRestoreDef restore = swDefaultRestoreDef();
    swWorld* copy = NULL;
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restore, &copy), SW_SUCCESS);
    assert_true(swWorld_GetDigest(copy) == early);
    assert_int_equal(swWorld_Step(sea.world, 4.0), SW_SUCCESS);
    assert_true(swWorld_GetDigest(sea.world) != early);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_SUCCESS);
    assert_true(swWorld_GetDigest(sea.world) == early);
    swPosXZ points[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    swVec3 a[POINTS], b[POINTS], velocity[POINTS];
    for (int i = 0; i < 3; ++i)
    {
        FindParticles(swWorld_GetMoment(sea.world), SW_QUERY_NOW, 0.0, 0.0, points, a, velocity);
        FindParticles(swWorld_GetMoment(copy), SW_QUERY_NOW, 0.0, 0.0, points, b, velocity);
        assert_memory_equal(a, b, sizeof a);
        assert_int_equal(swWorld_Step(sea.world, 3.0), SW_SUCCESS);
        assert_int_equal(swWorld_Step(copy, 3.0), SW_SUCCESS);
    }
    def.currentX = 0.0f;
    assert_int_equal(swWaveSystem_Set(sea.world, sea.systems[0], &def, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.world, 1.0), SW_SUCCESS);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_ERROR_UNSUPPORTED);
    swDestroyWorld(copy);
    free(saved.data);
    DestroyScenario(&sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheSeaIsThatOfStillWaterCarried),
        cmocka_unit_test(FrequenciesShiftByDoppler),
        cmocka_unit_test(ChangesDoNotJump),
        cmocka_unit_test(SystemsThatShareWavesPart),
        cmocka_unit_test(PathsAreSavedAndRewound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
