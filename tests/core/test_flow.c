// SPDX-License-Identifier: MIT
// Waves in a flow that differs from place to place: their heights stay what they are, they begin anew unseen, and the
// water's velocity has the flow.

#include "support/cmocka_setup.h"

#include <math.h>
#include <string.h>

#include "core/surface/carry.h"
#include "core/surface/evaluate.h"
#include "core/world/world.h"
#include "scenarios/scenario.h"
#include "support/scatter.h"

#define POINTS 4096

typedef struct Stream
{
    double x, z;  // m/s
    double width; // of the edge, m; 0: there is none
} Stream;

static void FindStream(const void* context, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[2],
                       float (*gradients)[4])
{
    const Stream* stream = context;
    (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double across = stream->width > 0.0 ? tanh(points[i].x / stream->width) : 1.0;
        double slope = stream->width > 0.0 ? 0.5 * (1.0 - across * across) / stream->width : 0.0;
        double part = stream->width > 0.0 ? 0.5 + 0.5 * across : 1.0;
        velocities[i][0] = (float)(stream->x * part);
        velocities[i][1] = (float)(stream->z * part);
        gradients[i][0] = (float)(stream->x * slope);
        gradients[i][2] = (float)(stream->z * slope);
        gradients[i][1] = gradients[i][3] = 0.0f;
    }
}

typedef struct Sea
{
    Scenario scenario;
    swQueryDef def;
} Sea;

static void OpenSea(Sea* sea, ScenarioKind kind, bool isCarried)
{
    ScenarioDef def = DefaultScenarioDef(kind);
    def.resolution = 64;
    def.enableMotion = true;
    assert_int_equal(CreateScenario(&def, &sea->scenario), SW_SUCCESS);
    if (isCarried)
    {
        assert_int_equal(swCarryWaves(&sea->scenario.world->waves), SW_SUCCESS);
    }
    sea->def = swDefaultQueryDef();
}

static void BeginAt(Sea* sea, double time, const swPlaces* places, swQuery* query)
{
    assert_int_equal(swWorld_StepTo(sea->scenario.world, time), SW_SUCCESS);
    swBeginQuery(query, swGetWorldFrame(sea->scenario.world), swGetWaveKernels(SW_ISA_BEST), &sea->def,
                 (swPosXZ){0.0, 0.0});
    query->places = places;
}

static void Evaluate(const swQuery* query, int count, const swPosXZ* points, float (*moved)[4])
{
    for (int i = 0; i < count; i += SW_QUERY_BLOCK)
    {
        const swEvaluation out = {.displacement = moved + i};
        swEvaluate(query, count - i < SW_QUERY_BLOCK ? count - i : SW_QUERY_BLOCK, points + i, &out);
    }
}

static double MeanSquare(int count, float (*moved)[4])
{
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
        sum += (double)moved[i][1] * (double)moved[i][1];
    }
    return sum / count;
}

static float moved[POINTS][4], still[POINTS][4];
static swPosXZ points[POINTS];

// Places all over a tile, of which the mean square is that of the tile's waves.
static void FillTile(double side)
{
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){side * (i % 64) / 64.0, side * (i / 64) / 64.0};
    }
}

// Each octave for itself, over one of its own periods: a sum of all would hide one that breathes.
static double FindBreathing(Sea* sea, const Stream* stream)
{
    const swPlaces places = {.context = stream, .flow = FindStream};
    double worst = 0.0;
    for (int t = 0; t < swGetWorldFrame(sea->scenario.world)->tileCount; ++t)
    {
        swWaveGroup group = swGroupTile(&swGetWorldFrame(sea->scenario.world)->tiles[t]);
        float period;
        swFindCarryPhase(&group, 0, &period);
        FillTile(group.tile->side);
        double own[16], calm = 0.0;
        for (int i = 0; i < 16; ++i)
        {
            swQuery query;
            BeginAt(sea, 1000.0 + (double)period * i / 16.0, &places, &query);
            query.tileCount = 1;
            query.tiles = &swGetWorldFrame(sea->scenario.world)->tiles[t];
            Evaluate(&query, POINTS, points, moved);
            own[i] = MeanSquare(POINTS, moved);
            query.places = NULL;
            Evaluate(&query, POINTS, points, moved);
            calm += MeanSquare(POINTS, moved) / 16.0;
        }
        for (int i = 0; i < 16; ++i)
        {
            worst = fmax(worst, fabs(sqrt(own[i] / calm) - 1.0));
        }
    }
    return worst;
}

// Where the water hardly moves the copies lie on each other, and together they are one.
static void CopiesOfStillWaterAreOne(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_GALE, true);
    const Stream stream = {1e-7, 0.0, 0.0};
    const swPlaces places = {.context = &stream, .flow = FindStream};
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    double worst = 0.0;
    for (int i = 0; i < 8; ++i)
    {
        swQuery query;
        BeginAt(&sea, 100.0 + 0.7 * i, &places, &query);
        Evaluate(&query, POINTS, points, moved);
        query.places = NULL;
        Evaluate(&query, POINTS, points, still);
        for (int p = 0; p < POINTS; ++p)
        {
            worst = fmax(worst, fabs((double)moved[p][1] - (double)still[p][1]));
        }
    }
    print_message("in a flow of 1e-7 m/s heights are off by %.2g m\n", worst);
    assert_true(worst < 1e-5);
    DestroyScenario(&sea.scenario);
}

static void HeightsDoNotBreathe(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_GALE, true);
    const double speeds[] = {0.0, 0.02, 0.2, 2.0, 8.0};
    for (int i = 0; i < 5; ++i)
    {
        const Stream stream = {0.8 * speeds[i], -0.6 * speeds[i], 0.0};
        double worst = FindBreathing(&sea, &stream);
        print_message("%5.2f m/s: RMS of each octave within %.2f %% of its own over a period\n", speeds[i],
                      100.0 * worst);
        assert_true(worst < 0.03);
    }
    DestroyScenario(&sea.scenario);
}

// All waves, at places within an edge 30 m wide, over a minute.
static void HeightsAreTheSameAcrossAnEdge(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_GALE, true);
    const Stream stream = {0.5, 3.0, 30.0};
    const swPlaces places = {.context = &stream, .flow = FindStream};
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){-45.0 + 90.0 * (i % 16) / 15.0, 97.3 * (i / 16)};
    }
    double all = 0.0, calm = 0.0, most = 0.0;
    for (int i = 0; i < 24; ++i)
    {
        swQuery query;
        BeginAt(&sea, 500.0 + 2.5 * i, &places, &query);
        Evaluate(&query, POINTS, points, moved);
        query.places = NULL;
        Evaluate(&query, POINTS, points, still);
        all += MeanSquare(POINTS, moved);
        calm += MeanSquare(POINTS, still);
        most = fmax(most, fabs(sqrt(MeanSquare(POINTS, moved) / MeanSquare(POINTS, still)) - 1.0));
    }
    print_message("across an edge: RMS %+.2f %% over a minute, at most %.2f %% at one time\n",
                  100.0 * (sqrt(all / calm) - 1.0), 100.0 * most);
    assert_true(fabs(sqrt(all / calm) - 1.0) < 0.03);
    DestroyScenario(&sea.scenario);
}

// What the copies do in a hundredth of a second, beside what the waves do: nothing jumps where one begins anew.
static void NothingJumpsWhenCopiesBeginAnew(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_GALE, true);
    const Stream stream = {1.0, -2.0, 40.0};
    const swPlaces places = {.context = &stream, .flow = FindStream};
    ScatterPoints(points, 256, 0.0, 0.0, 300.0);
    double carried = 0.0, calm = 0.0;
    for (int i = 0; i < 1200; ++i)
    {
        static float before[2][256][4];
        for (int k = 0; k < 2; ++k)
        {
            swQuery query;
            BeginAt(&sea, 100.0 + 0.01 * i, k == 0 ? &places : NULL, &query);
            Evaluate(&query, 256, points, moved);
            for (int p = 0; p < 256 && i > 0; ++p)
            {
                double step = fabs((double)moved[p][1] - (double)before[k][p][1]);
                carried = k == 0 ? fmax(carried, step) : carried;
                calm = k == 0 ? calm : fmax(calm, step);
            }
            memcpy(before[k], moved, sizeof before[k]);
        }
    }
    print_message("in 10 ms heights move by %.4f m at most in still water, by %.4f m in the flow\n", calm, carried);
    assert_true(carried < 2.5 * calm);
    DestroyScenario(&sea.scenario);
}

// Where copies are alike, a pattern goes with the water: heights follow those of a sea that is carried as a whole.
static void WavesGoWithTheWater(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_BREEZE, true);
    const Stream stream = {0.4, 0.1, 0.0};
    const swPlaces places = {.context = &stream, .flow = FindStream};
    double error = 0.0, all = 0.0;
    int count = 0;
    for (int t = 0; t < swGetWorldFrame(sea.scenario.world)->tileCount; ++t)
    {
        swWaveGroup group = swGroupTile(&swGetWorldFrame(sea.scenario.world)->tiles[t]);
        float period;
        swFindCarryPhase(&group, 0, &period);
        swQuery query;
        BeginAt(&sea, 200.0, &places, &query);
        double phase = swFindCarryPhase(&group, query.ticks, &period) * 0x1p-32;
        if (fabs(phase - 0.5) > 0.05)
        {
            continue; // the first copy is not alone by now
        }
        FillTile(group.tile->side);
        query.tileCount = 1;
        query.tiles = &swGetWorldFrame(sea.scenario.world)->tiles[t];
        Evaluate(&query, POINTS, points, moved);
        query.places = NULL;
        for (int i = 0; i < POINTS; ++i)
        {
            points[i].x -= stream.x * (phase - 0.5) * (double)period;
            points[i].z -= stream.z * (phase - 0.5) * (double)period;
        }
        Evaluate(&query, POINTS, points, still);
        for (int i = 0; i < POINTS; ++i)
        {
            error += pow((double)moved[i][1] - (double)still[i][1], 2.0);
            all += pow((double)still[i][1], 2.0);
        }
        count += 1;
    }
    print_message("%d octaves: the copy that counts most is off by %.1f %% of its RMS\n", count,
                  100.0 * sqrt(error / all));
    assert_true(count > 0 && sqrt(error / all) < 0.2);
    DestroyScenario(&sea.scenario);
}

// An input of the flow: velocities of particles and of the water above points have it.
static void VelocitiesHaveTheFlow(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, SCENARIO_CALM, false);
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.shape = SW_SHAPE_CIRCLE;
    def.size.x = 200.0f;
    def.feather = 50.0f;
    def.value[0] = 1.5f;
    def.value[1] = -0.5f;
    swInputId id;
    assert_int_equal(swCreateInput(sea.scenario.world, &def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea.scenario.world, 0.1), SW_SUCCESS);
    const swPosXZ asked[3] = {{0.0, 10.0}, {75.0, 0.0}, {500.0, 0.0}};
    const float expected[3] = {1.5f, 0.75f, 0.0f};
    for (int i = 0; i < 2; ++i)
    {
        swVec3 velocity[3];
        const swSurfaceSamples samples = {.velocity = velocity};
        const swMoment* moment = swWorld_GetMoment(sea.scenario.world);
        if (i == 0)
        {
            swMoment_QuerySurface(moment, &sea.def, 3, asked, &samples, NULL);
        }
        else
        {
            swMoment_QueryParticles(moment, &sea.def, 3, asked, &samples, NULL, NULL);
        }
        for (int p = 0; p < 3; ++p)
        {
            assert_float_equal(velocity[p].x, expected[p], 1e-5f);
            assert_float_equal(velocity[p].z, -expected[p] / 3.0f, 1e-5f);
        }
    }
    const swPos below[2] = {{0.0, -3.0, 10.0}, {0.0, 3.0, 10.0}}; // in the water, and in the air
    swVec3 deep[2];
    const swVolumeSamples volume = {.velocity = deep};
    swMoment_QueryVolume(swWorld_GetMoment(sea.scenario.world), &sea.def, 2, below, &volume, NULL);
    assert_float_equal(deep[0].x, 1.5f, 1e-5f);
    assert_float_equal(deep[0].z, -0.5f, 1e-5f);
    assert_true(deep[1].x == 0.0f && deep[1].z == 0.0f);
    DestroyScenario(&sea.scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(CopiesOfStillWaterAreOne),      cmocka_unit_test(HeightsDoNotBreathe),
        cmocka_unit_test(HeightsAreTheSameAcrossAnEdge), cmocka_unit_test(NothingJumpsWhenCopiesBeginAnew),
        cmocka_unit_test(WavesGoWithTheWater),           cmocka_unit_test(VelocitiesHaveTheFlow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
