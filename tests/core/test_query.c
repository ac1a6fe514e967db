// SPDX-License-Identifier: MIT
// Queries answer for the surface: the particle that is said to be above a point is there, its height is that of a dense
// search, the normal is that of the heights around, and neither batch, thread nor view changes a bit.

#include "support/cmocka_setup.h"
#include "support/scatter.h"

#include <math.h>
#include <pthread.h>
#include <string.h>

#include "scenarios/scenario.h"

#define POINT_COUNT 3000

static Scenario OpenSea(ScenarioKind kind, float chop, int resolution)
{
    ScenarioDef def = DefaultScenarioDef(kind);
    def.chop = chop;
    def.resolution = resolution;
    Scenario scenario;
    assert_int_equal(CreateScenario(&def, &scenario), SW_SUCCESS);
    swWorld_Step(scenario.world, 33.0);
    return scenario;
}

static void ResidualIsWhatItSaysAndWithinTheTolerance(void** state)
{
    (void)state;
    static swPosXZ points[POINT_COUNT];
    static float heights[POINT_COUNT], residuals[POINT_COUNT];
    static swVec3 moved[POINT_COUNT];
    for (int far = 0; far < 2; ++far)
    {
        Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 128);
        ScatterPoints(points, POINT_COUNT, far * 1e6, far * -1e6, 2000.0);
        swQueryDef def = swDefaultQueryDef();
        swQueryStats stats;
        swSurfaceSamples samples = {.height = heights, .displacement = moved, .residual = residuals};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, &stats);
        assert_int_equal(stats.convergedCount, POINT_COUNT);
        double worst = 0.0;
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            // The particle that rests at the point less the displacement must be found above the point.
            swPosXZ rest = {points[i].x - (double)moved[i].x, points[i].z - (double)moved[i].z};
            swVec3 there;
            swSurfaceSamples particle = {.displacement = &there};
            swMoment_QueryParticles(swWorld_GetMoment(sea.world), &def, 1, &rest, &particle, NULL, NULL);
            double error = hypot(rest.x + (double)there.x - points[i].x, rest.z + (double)there.z - points[i].z);
            worst = error > worst ? error : worst;
            assert_true(residuals[i] <= def.tolerance);
            assert_true(heights[i] == moved[i].y);
        }
        print_message("%d km away: worst residual %.2g m as reported, %.2g m as measured, %.2f evaluations a point\n",
                      far * 1000, (double)stats.worstResidual, worst, (double)stats.iterationCount / POINT_COUNT);
        assert_true(worst < 1e-3);
        DestroyScenario(&sea);
    }
}

// Height above (x, z) by brute force: the finest of particles that rest around it, the nearest refined.
static double SearchDensely(const swWorld* world, double x, double z)
{
    swQueryDef def = swDefaultQueryDef();
    double centreX = x, centreZ = z, reach = 8.0;
    double height = 0.0;
    for (int level = 0; level < 9; ++level)
    {
        enum
        {
            SIDE = 33
        };
        static swPosXZ rest[SIDE * SIDE];
        static swVec3 moved[SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; ++i)
        {
            rest[i].x = centreX + reach * ((i % SIDE) * 2.0 / (SIDE - 1) - 1.0);
            rest[i].z = centreZ + reach * ((i / SIDE) * 2.0 / (SIDE - 1) - 1.0);
        }
        swSurfaceSamples samples = {.displacement = moved};
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, SIDE * SIDE, rest, &samples, NULL, NULL);
        double nearest = 1e30;
        int best = 0;
        for (int i = 0; i < SIDE * SIDE; ++i)
        {
            double distance = hypot(rest[i].x + (double)moved[i].x - x, rest[i].z + (double)moved[i].z - z);
            best = distance < nearest ? i : best;
            nearest = distance < nearest ? distance : nearest;
        }
        centreX = rest[best].x;
        centreZ = rest[best].z;
        height = (double)moved[best].y;
        reach *= 0.2;
    }
    return height;
}

static void HeightIsThatOfADenseSearch(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE, 0.7f, 64);
    swPosXZ points[40];
    ScatterPoints(points, 40, 500.0, 500.0, 1000.0);
    double worst = 0.0;
    for (int i = 0; i < 40; ++i)
    {
        double found = swMoment_GetHeight(swWorld_GetMoment(sea.world), points[i].x, points[i].z);
        double error = fabs(found - SearchDensely(sea.world, points[i].x, points[i].z));
        worst = error > worst ? error : worst;
    }
    print_message("worst height error against the dense search: %.2g m\n", worst);
    assert_true(worst < 1e-3);
    DestroyScenario(&sea);
}

static void NormalIsThatOfTheHeightsAround(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 64);
    swPosXZ points[200];
    ScatterPoints(points, 200, 0.0, 0.0, 1000.0);
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = 4.0f; // smooth over the differences' baseline
    def.tolerance = 2e-6f;
    swVec3 normals[200];
    float jacobians[200];
    swSurfaceSamples samples = {.normal = normals, .jacobian = jacobians};
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, 200, points, &samples, NULL);
    const double step = 0.02;
    double worst = 0.0;
    for (int i = 0; i < 200; ++i)
    {
        swPosXZ around[4] = {{points[i].x - step, points[i].z},
                             {points[i].x + step, points[i].z},
                             {points[i].x, points[i].z - step},
                             {points[i].x, points[i].z + step}};
        float heights[4];
        swSurfaceSamples at = {.height = heights};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, 4, around, &at, NULL);
        double slopeX = ((double)heights[1] - (double)heights[0]) / (2.0 * step);
        double slopeZ = ((double)heights[3] - (double)heights[2]) / (2.0 * step);
        double length = sqrt(1.0 + slopeX * slopeX + slopeZ * slopeZ);
        double error = fmax(fabs((double)normals[i].x + slopeX / length), fabs((double)normals[i].z + slopeZ / length));
        error = fmax(error, fabs((double)normals[i].y - 1.0 / length));
        worst = error > worst ? error : worst;
        assert_true(jacobians[i] > 0.0f);
    }
    print_message("worst component error of a normal against differences over 4 cm: %.2g\n", worst);
    assert_true(worst < 2e-3);
    DestroyScenario(&sea);
}

static void ParticlesAndSurfaceAgree(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_GALE, 1.0f, 64);
    static swPosXZ points[500];
    static swVec3 moved[500], normals[500], again[500], againNormals[500];
    static float jacobians[500], againJacobians[500];
    ScatterPoints(points, 500, 0.0, 0.0, 1000.0);
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.displacement = moved, .normal = normals, .jacobian = jacobians};
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, 500, points, &samples, NULL);
    for (int i = 0; i < 500; ++i)
    {
        points[i].x -= (double)moved[i].x;
        points[i].z -= (double)moved[i].z;
    }
    swVec2 slopes[500];
    float residuals[500];
    swSurfaceSamples particles = {
        .displacement = again, .normal = againNormals, .jacobian = againJacobians, .residual = residuals};
    swMoment_QueryParticles(swWorld_GetMoment(sea.world), &def, 500, points, &particles, slopes, NULL);
    for (int i = 0; i < 500; ++i)
    {
        assert_float_equal(moved[i].y, again[i].y, 1e-3);
        assert_float_equal(normals[i].x, againNormals[i].x, 0.02);
        assert_float_equal(jacobians[i], againJacobians[i], 0.02);
        assert_true(residuals[i] == 0.0f);
        assert_true(isfinite(slopes[i].x) && isfinite(slopes[i].y));
        float length = normals[i].x * normals[i].x + normals[i].y * normals[i].y + normals[i].z * normals[i].z;
        assert_float_equal(length, 1.0f, 1e-5f);
        assert_true(normals[i].y >= 0.0f);
    }
    DestroyScenario(&sea);
}

static void ASteepSeaConvergesOrSaysSo(void** state)
{
    (void)state;
    static swPosXZ points[POINT_COUNT];
    static float residuals[POINT_COUNT], jacobians[POINT_COUNT];
    const float chops[] = {1.0f, 1.5f, 2.0f};
    const double leastConverged[] = {1.0, 0.999, 0.98};
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 3000.0);
    for (int c = 0; c < 3; ++c)
    {
        Scenario sea = OpenSea(SCENARIO_GALE, chops[c], 128);
        swQueryDef def = swDefaultQueryDef();
        swQueryStats stats;
        swSurfaceSamples samples = {.jacobian = jacobians, .residual = residuals};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, &stats);
        int within = 0, folded = 0;
        float worst = 0.0f;
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            within += residuals[i] <= def.tolerance ? 1 : 0;
            folded += jacobians[i] < 0.0f ? 1 : 0;
            worst = residuals[i] > worst ? residuals[i] : worst;
        }
        print_message("chop %.1f: %d of %d converged, %d folded, worst residual %.2g m, %.2f evaluations a point\n",
                      (double)chops[c], within, POINT_COUNT, folded, (double)worst,
                      (double)stats.iterationCount / POINT_COUNT);
        assert_int_equal(within, stats.convergedCount);
        assert_true(worst == stats.worstResidual);
        assert_true(within >= leastConverged[c] * POINT_COUNT);
        DestroyScenario(&sea);
    }
}

// As steep as a sum of waves can be without folding for certain: chop * sum of a k just below one.
static void ASeaThatNearlyFoldsConvergesEverywhere(void** state)
{
    (void)state;
    swWaveComponent waves[6];
    float steepness = 0.0f;
    for (int i = 0; i < 6; ++i)
    {
        float wavelength = 80.0f / (float)(1 << i);
        waves[i] = (swWaveComponent){.wavelength = wavelength, .direction = 0.9f * (float)i, .phase = (float)i};
        waves[i].amplitude = 0.95f / 6.0f * wavelength / 6.2831853f;
        steepness += waves[i].amplitude * 6.2831853f / wavelength;
    }
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    swWaveSystemId id;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = waves;
    def.componentCount = 6;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swWorld_Step(world, 1.0);
    static swPosXZ points[50000];
    static float heights[50000];
    ScatterPoints(points, 50000, 0.0, 0.0, 400.0);
    swQueryDef query = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = heights};
    swQueryStats stats;
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 50000, points, &samples, &stats);
    print_message("chop * sum of a k = %.3f: %d of 50000 converged, %.2f evaluations a point\n", (double)steepness,
                  stats.convergedCount, (double)stats.iterationCount / 50000.0);
    assert_int_equal(stats.convergedCount, 50000);
    swDestroyWorld(world);
}

static void TheBatchDoesNotMatter(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_GALE, 1.0f, 64);
    static swPosXZ points[POINT_COUNT];
    static float whole[POINT_COUNT], parts[POINT_COUNT];
    static swVec3 wholeNormals[POINT_COUNT], partNormals[POINT_COUNT];
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 3000.0);
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = whole, .normal = wholeNormals};
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, NULL);
    for (int first = 0, size = 1; first < POINT_COUNT; first += size, size = size % 97 + 1)
    {
        int count = POINT_COUNT - first < size ? POINT_COUNT - first : size;
        swSurfaceSamples part = {.height = parts + first, .normal = partNormals + first};
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, count, points + first, &part, NULL);
    }
    assert_memory_equal(whole, parts, sizeof whole);
    assert_memory_equal(wholeNormals, partNormals, sizeof wholeNormals);
    DestroyScenario(&sea);
}

// ---- points that are asked about in each step ----

enum
{
    WARM_STEPS = 12
};

// Answers of several steps, all hashed by the last; returns evaluations a point after the first three steps.
static double AskOften(const swQueryDef* def, swSurfaceHint* hints, double speed, float* heights, float* worstResidual)
{
    Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 128);
    static swPosXZ points[POINT_COUNT];
    static float residuals[POINT_COUNT];
    int evaluations = 0;
    for (int step = 0; step < WARM_STEPS; ++step)
    {
        assert_int_equal(swWorld_Step(sea.world, 1.0 / 60.0), SW_SUCCESS);
        ScatterPoints(points, POINT_COUNT, speed * step / 60.0, 0.0, 1000.0);
        const swSurfaceSamples samples = {.height = heights, .residual = residuals, .hints = hints};
        swQueryStats stats;
        swMoment_QuerySurface(swWorld_GetMoment(sea.world), def, POINT_COUNT, points, &samples, &stats);
        assert_int_equal(stats.convergedCount, POINT_COUNT);
        *worstResidual = fmaxf(*worstResidual, stats.worstResidual);
        evaluations += step >= 3 ? stats.iterationCount : 0;
    }
    DestroyScenario(&sea);
    return evaluations / (double)(POINT_COUNT * (WARM_STEPS - 3));
}

static void HintsSaveEvaluationsAndNotAccuracy(void** state)
{
    (void)state;
    static float cold[POINT_COUNT], warm[POINT_COUNT];
    static swSurfaceHint hints[POINT_COUNT];
    const double speeds[] = {0.0, 10.0};
    for (int moving = 0; moving < 2; ++moving)
    {
        swQueryDef def = swDefaultQueryDef();
        def.minWavelength = moving ? 4.0f : 0.0f; // a ship, which does not feel short waves
        float coldWorst = 0.0f, warmWorst = 0.0f;
        memset(hints, 0, sizeof hints);
        double coldCount = AskOften(&def, NULL, speeds[moving], cold, &coldWorst);
        double warmCount = AskOften(&def, hints, speeds[moving], warm, &warmWorst);
        double worst = 0.0;
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            worst = fmax(worst, fabs((double)warm[i] - (double)cold[i]));
        }
        print_message("at %g m/s: %.2f evaluations a point, %.2f with hints; heights differ by %.2g m\n",
                      speeds[moving], coldCount, warmCount, worst);
        assert_true(warmCount < 1.6 && warmCount < 0.7 * coldCount);
        assert_true(coldWorst <= def.tolerance && warmWorst <= def.tolerance);
        assert_true(worst < 1e-3);
    }
}

static void SameHintsGiveTheSameBits(void** state)
{
    (void)state;
    static float first[POINT_COUNT], second[POINT_COUNT];
    static swSurfaceHint hints[2][POINT_COUNT];
    swQueryDef def = swDefaultQueryDef();
    float worst = 0.0f;
    AskOften(&def, hints[0], 3.0, first, &worst);
    AskOften(&def, hints[1], 3.0, second, &worst);
    assert_memory_equal(first, second, sizeof first);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        assert_true(hints[0][i].offsetX == hints[1][i].offsetX && hints[0][i].bendZ == hints[1][i].bendZ);
        assert_int_equal(hints[0][i].searchCount, 3);
    }
}

// Hints of nothing, of other points, or not numbers at all: answers are as exact, and the hints become good ones.
static void BadHintsDoNoHarm(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_GALE, 1.0f, 64);
    static swPosXZ points[POINT_COUNT];
    static float cold[POINT_COUNT], warm[POINT_COUNT];
    static swSurfaceHint hints[POINT_COUNT];
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 1000.0);
    double time = swWorld_GetTime(sea.world);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        const swSurfaceHint bad[] = {
            {.time = time, .offsetX = NAN, .searchCount = 3},
            {.time = (double)NAN, .offsetX = 1.0f, .searchCount = 3},
            {.time = time, .offsetX = 2.0f, .offsetZ = -3.0f, .searchCount = 1},
            {.time = time - 0.1, .rateX = INFINITY, .searchCount = 2},
            {.time = time - 0.1, .bendZ = 1e30f, .lastStep = -0.1f, .searchCount = 3},
            {.time = time - 0.1, .bendZ = 1.0f, .lastStep = NAN, .searchCount = 3},
            {.time = time + 1e9, .offsetX = 5.0f, .searchCount = INT32_MAX},
        };
        hints[i] = bad[i % 7];
    }
    swQueryDef def = swDefaultQueryDef();
    swQueryStats stats;
    swSurfaceSamples samples = {.height = cold};
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, NULL);
    samples = (swSurfaceSamples){.height = warm, .hints = hints};
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, &stats);
    assert_int_equal(stats.convergedCount, POINT_COUNT);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        assert_float_equal(warm[i], cold[i], 1e-3f);
        assert_true(hints[i].time == time && isfinite(hints[i].offsetX) && isfinite(hints[i].rateX));
    }
    swMoment_QuerySurface(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, &stats);
    assert_int_equal(stats.iterationCount, POINT_COUNT);
    DestroyScenario(&sea);
}

typedef struct Reader
{
    const swWorld* world;
    const swPosXZ* points;
    float heights[POINT_COUNT];
} Reader;

static void* ReadHeights(void* argument)
{
    Reader* reader = argument;
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = reader->heights};
    swMoment_QuerySurface(swWorld_GetMoment(reader->world), &def, POINT_COUNT, reader->points, &samples, NULL);
    return NULL;
}

static void ManyThreadsReadAtOnce(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 64);
    static swPosXZ points[POINT_COUNT];
    static Reader readers[6];
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 500.0);
    pthread_t threads[6];
    for (int i = 0; i < 6; ++i)
    {
        readers[i].world = sea.world;
        readers[i].points = points;
        assert_int_equal(pthread_create(&threads[i], NULL, ReadHeights, &readers[i]), 0);
    }
    for (int i = 0; i < 6; ++i)
    {
        pthread_join(threads[i], NULL);
        assert_memory_equal(readers[i].heights, readers[0].heights, sizeof readers[0].heights);
    }
    DestroyScenario(&sea);
}

// ---- while another thread steps ----

static swWorld* MakeTwin(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(world, 0.0), SW_SUCCESS);
    return world;
}

typedef struct Stepper
{
    swWorld* world;
    double time;
} Stepper;

static void* StepOther(void* argument)
{
    Stepper* stepper = argument;
    swWorld_StepTo(stepper->world, stepper->time);
    return NULL;
}

// Two worlds take turns: one is asked while the other steps. Each makes every other step, and the answers have the bits
// of one world that makes them all.
static void TwoWorldsTakeTurns(void** state)
{
    (void)state;
    enum
    {
        FRAMES = 20
    };
    swWorld* alone = MakeTwin();
    swWorld* twins[2] = {MakeTwin(), MakeTwin()};
    static swPosXZ points[POINT_COUNT];
    static Reader reader, expected;
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 500.0);
    for (int frame = 0; frame < FRAMES; ++frame)
    {
        Stepper stepper = {twins[(frame + 1) % 2], (frame + 1) / 30.0};
        pthread_t stepping, reading;
        reader = (Reader){.world = twins[frame % 2], .points = points};
        assert_int_equal(pthread_create(&stepping, NULL, StepOther, &stepper), 0);
        assert_int_equal(pthread_create(&reading, NULL, ReadHeights, &reader), 0);
        pthread_join(stepping, NULL);
        pthread_join(reading, NULL);
        assert_int_equal(swWorld_StepTo(alone, frame / 30.0), SW_SUCCESS);
        expected = (Reader){.world = alone, .points = points};
        ReadHeights(&expected);
        assert_memory_equal(reader.heights, expected.heights, sizeof reader.heights);
    }
    swDestroyWorld(alone);
    swDestroyWorld(twins[0]);
    swDestroyWorld(twins[1]);
}

static void AViewChangesNothing(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 64);
    double before = swMoment_GetHeight(swWorld_GetMoment(sea.world), 17.0, 23.0);
    swViewDef def = swDefaultViewDef();
    swView* view;
    assert_int_equal(swCreateView(sea.world, &def, &view), SW_SUCCESS);
    swView_SetViewpoint(view, (swPos){1e5, 1e4, -1e5});
    swWorld_Step(sea.world, 0.0);
    assert_true(swMoment_GetHeight(swWorld_GetMoment(sea.world), 17.0, 23.0) == before);
    DestroyScenario(&sea);
}

static void CalmWaterIsFlat(void** state)
{
    (void)state;
    ScenarioDef scenarioDef = DefaultScenarioDef(SCENARIO_CALM);
    Scenario calm;
    assert_int_equal(CreateScenario(&scenarioDef, &calm), SW_SUCCESS);
    swQueryDef def = swDefaultQueryDef();
    swPosXZ point = {5.0, 6.0};
    float height, jacobian, residual;
    swVec3 normal;
    swSurfaceSamples samples = {.height = &height, .normal = &normal, .jacobian = &jacobian, .residual = &residual};
    swQueryStats stats;
    swMoment_QuerySurface(swWorld_GetMoment(calm.world), &def, 1, &point, &samples, &stats);
    assert_true(height == 0.0f && jacobian == 1.0f && residual == 0.0f && normal.y == 1.0f);
    assert_int_equal(stats.convergedCount, 1);
    swMoment_QuerySurface(swWorld_GetMoment(calm.world), &def, 0, NULL, &samples, &stats);
    assert_int_equal(stats.convergedCount, 0);
    DestroyScenario(&calm);
}

static void ShortWavesCanBeLeftOut(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE, 1.0f, 64);
    swQueryDef def = swDefaultQueryDef();
    static swPosXZ points[POINT_COUNT];
    static swVec2 slopes[POINT_COUNT];
    ScatterPoints(points, POINT_COUNT, 0.0, 0.0, 3000.0);
    double steepness[3];
    const float shortest[] = {0.0f, 8.0f, 1e9f};
    for (int i = 0; i < 3; ++i)
    {
        def.minWavelength = shortest[i];
        swSurfaceSamples samples = {0};
        swMoment_QueryParticles(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, slopes, NULL);
        steepness[i] = 0.0;
        for (int p = 0; p < POINT_COUNT; ++p)
        {
            steepness[i] += (double)(slopes[p].x * slopes[p].x + slopes[p].y * slopes[p].y) / POINT_COUNT;
        }
    }
    assert_true(steepness[0] > 1.5 * steepness[1]);
    assert_true(steepness[1] > 0.0);
    assert_true(steepness[2] == 0.0);
    DestroyScenario(&sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ResidualIsWhatItSaysAndWithinTheTolerance),
        cmocka_unit_test(HeightIsThatOfADenseSearch),
        cmocka_unit_test(NormalIsThatOfTheHeightsAround),
        cmocka_unit_test(ParticlesAndSurfaceAgree),
        cmocka_unit_test(ASteepSeaConvergesOrSaysSo),
        cmocka_unit_test(ASeaThatNearlyFoldsConvergesEverywhere),
        cmocka_unit_test(TheBatchDoesNotMatter),
        cmocka_unit_test(HintsSaveEvaluationsAndNotAccuracy),
        cmocka_unit_test(SameHintsGiveTheSameBits),
        cmocka_unit_test(BadHintsDoNoHarm),
        cmocka_unit_test(ManyThreadsReadAtOnce),
        cmocka_unit_test(TwoWorldsTakeTurns),
        cmocka_unit_test(AViewChangesNothing),
        cmocka_unit_test(CalmWaterIsFlat),
        cmocka_unit_test(ShortWavesCanBeLeftOut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
