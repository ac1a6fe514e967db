// SPDX-License-Identifier: MIT
// The sum of the water where places shape it: weights, depths, warps and levels that are made up here, constant or
// varying, with exact gradients. Shapes that leave waves alone change no bit, whoever is asked about together.

#include "support/cmocka_setup.h"

#include <math.h>
#include <string.h>

#include "core/query/query_surface.h"
#include "core/surface/search.h"
#include "core/world/world.h"
#include "scenarios/scenario.h"
#include "support/scatter.h"

#define POINTS 150

// ---- made-up fields ----

static void FindOne(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                    float (*gradients)[2])
{
    (void)context, (void)system, (void)ticks, (void)points;
    for (int i = 0; i < count; ++i)
    {
        values[i] = 1.0f;
        gradients[i][0] = gradients[i][1] = 0.0f;
    }
}

static void FindHalf(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                     float (*gradients)[2])
{
    FindOne(context, system, ticks, count, points, values, gradients);
    for (int i = 0; i < count; ++i)
    {
        values[i] = 0.5f;
    }
}

// 1 for x below 0, from there falling along x and swinging along z.
static void FindLee(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                    float (*gradients)[2])
{
    (void)context, (void)system, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x > 0.0 ? points[i].x : 0.0;
        double fade = exp(-0.0004 * x * x), swing = 1.0 + 0.3 * (1.0 - fade) * sin(0.05 * points[i].z);
        values[i] = (float)(fade * swing);
        gradients[i][0] = (float)(-0.0008 * x * fade * (swing - 0.3 * fade * sin(0.05 * points[i].z)));
        gradients[i][1] = (float)(fade * 0.3 * (1.0 - fade) * 0.05 * cos(0.05 * points[i].z));
    }
}

static void FindDepth(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                      float (*gradients)[2])
{
    (void)context, (void)system, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        values[i] = (float)(6.0 + 2.0 * sin(0.04 * points[i].x + 0.03 * points[i].z));
        double slope = 2.0 * cos(0.04 * points[i].x + 0.03 * points[i].z);
        gradients[i][0] = (float)(0.04 * slope);
        gradients[i][1] = (float)(0.03 * slope);
    }
}

// 30 m for x below 0, from there sloping to 3 m.
static void FindShelf(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                      float (*gradients)[2])
{
    (void)context, (void)system, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x > 0.0 ? points[i].x : 0.0, fade = exp(-0.0004 * x * x);
        values[i] = (float)(3.0 + 27.0 * fade);
        gradients[i][0] = (float)(-27.0 * 0.0008 * x * fade);
        gradients[i][1] = 0.0f;
    }
}

static void FindFlatDepth(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                          float* values, float (*gradients)[2])
{
    FindOne(context, system, ticks, count, points, values, gradients);
    for (int i = 0; i < count; ++i)
    {
        values[i] = 5.0f;
    }
}

// A lake's swell of level: 3 m higher, and a slope.
static void FindLevel(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                      float (*gradients)[2])
{
    (void)context, (void)system, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        values[i] = (float)(3.0 + 0.5 * sin(0.1 * points[i].x) + 0.02 * points[i].z);
        gradients[i][0] = (float)(0.05 * cos(0.1 * points[i].x));
        gradients[i][1] = 0.02f;
    }
}

// Coordinates that bend, and by up to 0.3 rad turned axes.
static int FindWarps(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                     swWarp (*warps)[SW_PLACE_BLOCK])
{
    (void)context, (void)system, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x, z = points[i].z, angle = 0.3 * sin(0.03 * x - 0.02 * z);
        double swing = 0.3 * cos(0.03 * x - 0.02 * z);
        warps[0][i] = (swWarp){
            .weight = (float)(0.7 + 0.2 * sin(0.06 * x)),
            .alongX = (float)(0.012 * cos(0.06 * x)),
            .source = {x + 1.5 * sin(0.05 * z), z + 0.8 * cos(0.07 * x)},
            .gradients = {0.0f, (float)(0.075 * cos(0.05 * z)), (float)(-0.056 * sin(0.07 * x)), 0.0f},
            .cosine = (float)cos(angle),
            .sine = (float)sin(angle),
            .turnX = (float)(0.03 * swing),
            .turnZ = (float)(-0.02 * swing),
        };
    }
    return 1;
}

// Falls below 12 m, and is then no more than a wave's k times it.
static void Attenuate(const void* context, const swWaveKernels* kernels, const swWaveGroup* group, int count,
                      const float* depths, float* shares, float* slopes)
{
    (void)context, (void)kernels;
    for (int i = 0; i < count; ++i)
    {
        float k = group->k, kd = k * depths[i], root = 1.0f + kd;
        bool isDeep = depths[i] >= 12.0f;
        slopes[i] = isDeep ? 0.0f : k / (root * root);
        shares[i] = isDeep ? 1.0f : kd / root;
    }
}

// A current of 2 m/s whose edge lies along z and swings.
static void FindFlow(const void* context, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[2],
                     float (*gradients)[4])
{
    (void)context, (void)ticks;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x, z = points[i].z, t = tanh(0.04 * x + 0.5 * sin(0.03 * z)), slope = 1.0 - t * t;
        velocities[i][0] = (float)(0.5 * t);
        velocities[i][1] = (float)(1.0 + t);
        double alongX = 0.04 * slope, alongZ = 0.015 * cos(0.03 * z) * slope;
        gradients[i][0] = (float)(0.5 * alongX);
        gradients[i][1] = (float)(0.5 * alongZ);
        gradients[i][2] = (float)alongX;
        gradients[i][3] = (float)alongZ;
    }
}

// ---- seas ----

typedef struct Sea
{
    Scenario scenario;
    swQueryDef def;
    swQuery query;
} Sea;

// A gale with a swell, and free waves beside it.
static void OpenSea(Sea* sea, float minWavelength, bool withFreeWaves)
{
    ScenarioDef def = DefaultScenarioDef(SCENARIO_GALE);
    def.resolution = 64;
    assert_int_equal(CreateScenario(&def, &sea->scenario), SW_SUCCESS);
    if (withFreeWaves)
    {
        swWaveSystemDef free = swDefaultWaveSystemDef();
        free.method = SW_WAVES_GERSTNER;
        free.componentsPerOctave = 2;
        free.minWavelength = 8.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(sea->scenario.world, &free, &id), SW_SUCCESS);
    }
    assert_int_equal(swCarryWaves(&sea->scenario.world->waves), SW_SUCCESS);
    assert_int_equal(swWorld_Step(sea->scenario.world, 33.0), SW_SUCCESS);
    sea->def = swDefaultQueryDef();
    sea->def.minWavelength = minWavelength;
    swBeginQuery(&sea->query, swGetWorldFrame(sea->scenario.world), swGetWaveKernels(SW_ISA_BEST), &sea->def,
                 (swPosXZ){0.0, 0.0});
}

typedef struct Answers
{
    swPosXZ points[POINTS];
    float displacement[POINTS][4], levels[POINTS], gradients[POINTS][8], velocity[POINTS][4];
} Answers;

static void Evaluate(const Sea* sea, const swPlaces* places, int first, int count, Answers* to)
{
    swQuery query = sea->query;
    query.places = places;
    for (int i = first; i < first + count; i += SW_QUERY_BLOCK)
    {
        int some = first + count - i < SW_QUERY_BLOCK ? first + count - i : SW_QUERY_BLOCK;
        const swEvaluation out = {
            .displacement = to->displacement + i,
            .levels = to->levels + i,
            .gradients = to->gradients + i,
            .velocity = to->velocity + i,
        };
        swEvaluate(&query, some, to->points + i, &out);
    }
}

// ---- tests ----

static void ShapesThatLeaveWavesAloneChangeNoBit(void** state)
{
    (void)state;
    static Answers plain, shaped, mixed;
    Sea sea;
    OpenSea(&sea, 0.0f, false);
    ScatterPoints(plain.points, POINTS, 0.0, 0.0, 400.0);
    memcpy(shaped.points, plain.points, sizeof plain.points);
    memcpy(mixed.points, plain.points, sizeof plain.points);
    Evaluate(&sea, NULL, 0, POINTS, &plain);
    const swPlaces ones = {.weight = FindOne};
    Evaluate(&sea, &ones, 0, POINTS, &shaped);
    assert_memory_equal(plain.displacement, shaped.displacement, sizeof plain.displacement);
    assert_memory_equal(plain.gradients, shaped.gradients, sizeof plain.gradients);
    // Beside points whose waves are shaped as well.
    const swPlaces lee = {.weight = FindLee};
    Evaluate(&sea, &lee, 0, POINTS, &mixed);
    int alone = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        bool isSame = memcmp(plain.gradients[i], mixed.gradients[i], sizeof plain.gradients[i]) == 0;
        assert_true(isSame == (plain.points[i].x <= 0.0));
        alone += isSame ? 1 : 0;
    }
    assert_in_range(alone, POINTS / 4, POINTS * 3 / 4);
    DestroyScenario(&sea.scenario);
}

static void GroupsOfShapedPointsChangeNoBit(void** state)
{
    (void)state;
    static Answers whole, parts;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    ScatterPoints(whole.points, POINTS, 0.0, 0.0, 400.0);
    memcpy(parts.points, whole.points, sizeof whole.points);
    const swPlaces all = {
        .level = FindLevel, .depth = FindDepth, .weight = FindLee, .warps = FindWarps, .attenuate = Attenuate};
    Evaluate(&sea, &all, 0, POINTS, &whole);
    for (int first = 0, size = 1; first < POINTS; first += size, size = size % 37 + 1)
    {
        Evaluate(&sea, &all, first, POINTS - first < size ? POINTS - first : size, &parts);
    }
    assert_memory_equal(whole.displacement, parts.displacement, sizeof whole.displacement);
    assert_memory_equal(whole.gradients, parts.gradients, sizeof whole.gradients);
    assert_memory_equal(whole.levels, parts.levels, sizeof whole.levels);
    DestroyScenario(&sea.scenario);
}

static void AConstantWeightScalesEverything(void** state)
{
    (void)state;
    static Answers plain, half;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    ScatterPoints(plain.points, POINTS, 0.0, 0.0, 400.0);
    memcpy(half.points, plain.points, sizeof plain.points);
    const swPlaces places = {.weight = FindHalf};
    Evaluate(&sea, NULL, 0, POINTS, &plain);
    Evaluate(&sea, &places, 0, POINTS, &half);
    for (int i = 0; i < POINTS; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            assert_float_equal(half.displacement[i][c], 0.5f * plain.displacement[i][c], 2e-6f);
            assert_float_equal(half.velocity[i][c], 0.5f * plain.velocity[i][c], 1e-5f);
        }
        for (int c = 0; c < 6; ++c)
        {
            assert_float_equal(half.gradients[i][c], 0.5f * plain.gradients[i][c], 1e-6f);
        }
    }
    DestroyScenario(&sea.scenario);
}

static void AConstantDepthTakesItsShareOfEachBand(void** state)
{
    (void)state;
    static Answers shaped;
    Sea sea;
    OpenSea(&sea, 0.0f, false);
    ScatterPoints(shaped.points, POINTS, 0.0, 0.0, 400.0);
    const swPlaces places = {.depth = FindFlatDepth, .attenuate = Attenuate};
    Evaluate(&sea, &places, 0, POINTS, &shaped);
    for (int i = 0; i < POINTS; ++i)
    {
        double expected[4] = {0.0};
        for (int t = 0; t < sea.query.tileCount; ++t)
        {
            const swTile* tile = &sea.query.tiles[t];
            const float depth = 5.0f;
            float out[4], share, slope;
            swSampleTiles(sea.query.kernels, 1, tile, 1, &shaped.points[i], out, NULL);
            const swWaveGroup group = swGroupTile(tile);
            Attenuate(NULL, NULL, &group, 1, &depth, &share, &slope);
            for (int c = 0; c < 3; ++c)
            {
                expected[c] += (double)share * (double)out[c];
            }
        }
        for (int c = 0; c < 3; ++c)
        {
            assert_float_equal(shaped.displacement[i][c], expected[c], 2e-6f);
        }
    }
    DestroyScenario(&sea.scenario);
}

// Points in deep water have the bits of a sea without places, now and at other times, whoever is asked about together.
static void DeepPointsBesideShallowsChangeNoBit(void** state)
{
    (void)state;
    static Answers plain, shaped;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    ScatterPoints(plain.points, POINTS, 0.0, 0.0, 300.0);
    memcpy(shaped.points, plain.points, sizeof plain.points);
    const swPlaces shelf = {.depth = FindShelf, .attenuate = Attenuate};
    for (int isNow = 0; isNow < 2; ++isNow)
    {
        sea.query.isNow = isNow != 0;
        Evaluate(&sea, NULL, 0, POINTS, &plain);
        Evaluate(&sea, &shelf, 0, POINTS, &shaped);
        int alone = 0;
        for (int i = 0; i < POINTS; ++i)
        {
            bool isSame = memcmp(plain.gradients[i], shaped.gradients[i], sizeof plain.gradients[i]) == 0 &&
                          memcmp(plain.velocity[i], shaped.velocity[i], sizeof plain.velocity[i]) == 0;
            double fade = exp(-0.0004 * plain.points[i].x * plain.points[i].x);
            assert_true(isSame == (plain.points[i].x <= 0.0 || 3.0 + 27.0 * fade >= 12.0));
            alone += isSame ? 1 : 0;
        }
        assert_in_range(alone, POINTS / 4, POINTS * 9 / 10);
    }
    DestroyScenario(&sea.scenario);
}

// A system that lives in a place only is nowhere else, and others are as they are without it.
static void LocalSystemsAreWhereTheirWeightIs(void** state)
{
    (void)state;
    static Answers all, one, local;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    ScatterPoints(all.points, POINTS, 0.0, 0.0, 400.0);
    memcpy(one.points, all.points, sizeof all.points);
    memcpy(local.points, all.points, sizeof all.points);
    int freeSystem = sea.query.waves[0].system;
    const swPlaces without = {.localSystems = 1u << freeSystem};
    Evaluate(&sea, &without, 0, POINTS, &local);
    int waveCount = sea.query.waveCount;
    sea.query.waveCount = 0;
    Evaluate(&sea, NULL, 0, POINTS, &one);
    sea.query.waveCount = waveCount;
    Evaluate(&sea, NULL, 0, POINTS, &all);
    for (int i = 0; i < POINTS; ++i)
    {
        assert_memory_equal(one.displacement[i], local.displacement[i], sizeof one.displacement[i]);
        assert_true(memcmp(one.displacement[i], all.displacement[i], sizeof one.displacement[i]) != 0);
    }
    DestroyScenario(&sea.scenario);
}

// Every gradient against differences of displacement, and of the height with its level.
static void CheckGradients(const Sea* sea, const swPlaces* places)
{
    static Answers at, around[4];
    const double step = 0.05;
    ScatterPoints(at.points, POINTS, 0.0, 0.0, 200.0);
    Evaluate(sea, places, 0, POINTS, &at);
    double worst = 0.0;
    for (int side = 0; side < 4; ++side)
    {
        for (int i = 0; i < POINTS; ++i)
        {
            around[side].points[i] = at.points[i];
            *(side < 2 ? &around[side].points[i].x : &around[side].points[i].z) += side % 2 == 0 ? -step : step;
        }
        Evaluate(sea, places, 0, POINTS, &around[side]);
    }
    for (int i = 0; i < POINTS; ++i)
    {
        const int components[3] = {0, 2, 1}; // dDx, dDz, dh
        for (int g = 0; g < 6; ++g)
        {
            int component = components[g / 2], side = g % 2 == 0 ? 0 : 2;
            double before = (double)around[side].displacement[i][component];
            double after = (double)around[side + 1].displacement[i][component];
            before += component == 1 ? (double)around[side].levels[i] : 0.0;
            after += component == 1 ? (double)around[side + 1].levels[i] : 0.0;
            double error = fabs((after - before) / (2.0 * step) - (double)at.gradients[i][g]);
            worst = error > worst ? error : worst;
        }
    }
    print_message("worst gradient against differences over %g m: %.2g\n", 2.0 * step, worst);
    assert_true(worst < 5e-4);
}

static void GradientsOfPlacesEnterThoseOfTheSurface(void** state)
{
    (void)state;
    Sea sea;
    OpenSea(&sea, 8.0f, true);
    const swPlaces weight = {.weight = FindLee};
    const swPlaces depth = {.depth = FindDepth, .attenuate = Attenuate};
    const swPlaces warp = {.warps = FindWarps};
    const swPlaces level = {.level = FindLevel};
    const swPlaces all = {
        .level = FindLevel, .depth = FindDepth, .weight = FindLee, .warps = FindWarps, .attenuate = Attenuate};
    const swPlaces flow = {.flow = FindFlow};
    swPlaces everything = all;
    everything.flow = FindFlow;
    CheckGradients(&sea, &flow);
    CheckGradients(&sea, &everything);
    CheckGradients(&sea, &weight);
    CheckGradients(&sea, &depth);
    CheckGradients(&sea, &warp);
    CheckGradients(&sea, &level);
    CheckGradients(&sea, &all);
    DestroyScenario(&sea.scenario);
}

static void OtherTimesAreShapedAlike(void** state)
{
    (void)state;
    static Answers now, summed;
    Sea sea;
    OpenSea(&sea, 8.0f, true);
    ScatterPoints(now.points, POINTS, 0.0, 0.0, 200.0);
    memcpy(summed.points, now.points, sizeof now.points);
    const swPlaces all = {
        .level = FindLevel, .depth = FindDepth, .weight = FindLee, .warps = FindWarps, .attenuate = Attenuate};
    Evaluate(&sea, &all, 0, POINTS, &now);
    sea.query.isNow = false; // the same time, wave by wave
    Evaluate(&sea, &all, 0, POINTS, &summed);
    for (int i = 0; i < POINTS; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            assert_float_equal(now.displacement[i][c], summed.displacement[i][c], 0.02f);
            assert_float_equal(now.velocity[i][c], summed.velocity[i][c], 0.02f);
        }
        assert_float_equal(now.gradients[i][4], summed.gradients[i][4], 0.02f);
    }
    DestroyScenario(&sea.scenario);
}

// The level is that of where the water is asked about, and normals are those of the heights around.
static void QueriesFindTheShapedSurface(void** state)
{
    (void)state;
    static swPosXZ points[POINTS], aside[POINTS];
    static float heights[POINTS], residuals[POINTS], asideHeights[2][POINTS];
    static swVec3 moved[POINTS], normals[POINTS];
    Sea sea;
    OpenSea(&sea, 4.0f, true);
    sea.def.tolerance = 5e-6f;
    ScatterPoints(points, POINTS, 0.0, 0.0, 200.0);
    const swPlaces all = {
        .level = FindLevel, .depth = FindDepth, .weight = FindLee, .warps = FindWarps, .attenuate = Attenuate};
    sea.query.places = &all;
    swQueryStats stats;
    const swSurfaceSamples samples = {
        .height = heights, .displacement = moved, .normal = normals, .residual = residuals};
    swQuerySurface(&sea.query, POINTS, points, &samples, &stats);
    assert_int_equal(stats.convergedCount, POINTS);
    const double step = 0.05;
    for (int side = 0; side < 2; ++side)
    {
        for (int i = 0; i < POINTS; ++i)
        {
            aside[i] = (swPosXZ){points[i].x + (side == 0 ? -step : step), points[i].z};
        }
        const swSurfaceSamples beside = {.height = asideHeights[side]};
        swQuerySurface(&sea.query, POINTS, aside, &beside, NULL);
    }
    for (int i = 0; i < POINTS; ++i)
    {
        float level, slope[1][2];
        FindLevel(NULL, -1, 0, 1, &points[i], &level, slope);
        assert_float_equal(heights[i], level + moved[i].y, 1e-5f);
        assert_float_equal(swFindHeight(&sea.query, points[i].x, points[i].z), heights[i], 1e-5f);
        float difference = (asideHeights[1][i] - asideHeights[0][i]) / (float)(2.0 * step);
        assert_float_equal(-normals[i].x / normals[i].y, difference, 3e-3f);
    }
    DestroyScenario(&sea.scenario);
}

// A row of a grid, which has a path of its own, and the same points in another order, which have not.
static void RowsHaveTheBitsOfPoints(void** state)
{
    (void)state;
    static Answers row, shuffled;
    Sea sea;
    OpenSea(&sea, 0.0f, true);
    const double spacings[] = {0.01, 0.4, 7.0, 500.0};
    for (int s = 0; s < 4; ++s)
    {
        for (int i = 0; i < SW_QUERY_BLOCK; ++i)
        {
            row.points[i] = (swPosXZ){-3.3 + spacings[s] * i, 12.5};
            shuffled.points[i * 5 % 64] = row.points[i];
        }
        Evaluate(&sea, NULL, 0, SW_QUERY_BLOCK, &row);
        Evaluate(&sea, NULL, 0, SW_QUERY_BLOCK, &shuffled);
        for (int i = 0; i < SW_QUERY_BLOCK; ++i)
        {
            assert_memory_equal(row.displacement[i], shuffled.displacement[i * 5 % 64], sizeof row.displacement[i]);
            assert_memory_equal(row.gradients[i], shuffled.gradients[i * 5 % 64], sizeof row.gradients[i]);
            assert_memory_equal(row.velocity[i], shuffled.velocity[i * 5 % 64], sizeof row.velocity[i]);
        }
    }
    DestroyScenario(&sea.scenario);
}

// Of what particles rest 5 cm on all sides: a plane through where they are.
static swVec3 MeasureNormal(const Sea* sea, const swPlaces* places, swPosXZ at)
{
    static Answers around;
    const double step = 0.05;
    for (int i = 0; i < 4; ++i)
    {
        double x = i == 0 ? step : i == 1 ? -step : 0.0, z = i == 2 ? step : i == 3 ? -step : 0.0;
        around.points[i] = (swPosXZ){at.x + x, at.z + z};
    }
    Evaluate(sea, places, 0, 4, &around);
    double along[3], across[3];
    for (int c = 0; c < 3; ++c)
    {
        along[c] =
            (double)(around.displacement[0][c] - around.displacement[1][c]) / (2.0 * step) + (c == 0 ? 1.0 : 0.0);
        across[c] =
            (double)(around.displacement[2][c] - around.displacement[3][c]) / (2.0 * step) + (c == 2 ? 1.0 : 0.0);
    }
    double x = across[1] * along[2] - across[2] * along[1], y = across[2] * along[0] - across[0] * along[2];
    double z = across[0] * along[1] - across[1] * along[0], length = sqrt(x * x + y * y + z * z);
    return (swVec3){(float)(x / length), (float)(y / length), (float)(z / length)};
}

// On a steep beach sideways motion is no gradient: dDx/dz is not dDz/dx.
static void NormalsOfShapedWavesAreThoseOfTheSurface(void** state)
{
    (void)state;
    static Answers answers;
    Sea sea;
    OpenSea(&sea, 4.0f, false);
    const swPlaces shelf = {.depth = FindShelf, .attenuate = Attenuate};
    ScatterPoints(answers.points, POINTS, 40.0, 0.0, 60.0);
    Evaluate(&sea, &shelf, 0, POINTS, &answers);
    double worst = 0.0, byThree = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        float jacobian, gradients[8];
        swVec3 truth = MeasureNormal(&sea, &shelf, answers.points[i]);
        swVec3 normal = swMakeNormal(answers.gradients[i], &jacobian);
        memcpy(gradients, answers.gradients[i], sizeof gradients);
        gradients[6] = 0.0f;
        swVec3 three = swMakeNormal(gradients, &jacobian);
        worst = fmax(worst, hypot((double)(normal.x - truth.x), (double)(normal.z - truth.z)));
        byThree = fmax(byThree, hypot((double)(three.x - truth.x), (double)(three.z - truth.z)));
    }
    print_message("normals off by %.2g, by three derivatives %.2g\n", worst, byThree);
    assert_true(worst < 5e-4);
    assert_true(byThree > 3.0 * worst);
    DestroyScenario(&sea.scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ShapesThatLeaveWavesAloneChangeNoBit),
        cmocka_unit_test(GroupsOfShapedPointsChangeNoBit),
        cmocka_unit_test(AConstantWeightScalesEverything),
        cmocka_unit_test(AConstantDepthTakesItsShareOfEachBand),
        cmocka_unit_test(DeepPointsBesideShallowsChangeNoBit),
        cmocka_unit_test(LocalSystemsAreWhereTheirWeightIs),
        cmocka_unit_test(GradientsOfPlacesEnterThoseOfTheSurface),
        cmocka_unit_test(OtherTimesAreShapedAlike),
        cmocka_unit_test(QueriesFindTheShapedSurface),
        cmocka_unit_test(RowsHaveTheBitsOfPoints),
        cmocka_unit_test(NormalsOfShapedWavesAreThoseOfTheSurface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
