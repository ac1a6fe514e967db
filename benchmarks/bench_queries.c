// SPDX-License-Identifier: MIT
// How many heights a second one core answers, with every band of a sea and the default tolerance. One line of JSON a
// row. The floor of a height is one evaluation of the surface, at which a query with nothing to search (particles)
// runs: per evaluation and band a window of 4 x 4 texels of 16 bytes is read, and 2 * (16 + 4) * 3 operations weigh it.

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "scenarios/scenario.h"

enum
{
    POINT_COUNT = 16384,
    ROUNDS = 25,
    MAX_THREADS = 64
};

typedef struct Answers
{
    swPosXZ points[POINT_COUNT];
    float heights[POINT_COUNT];
    float residuals[POINT_COUNT];
    swVec3 normals[POINT_COUNT];
    swSurfaceHint hints[POINT_COUNT];
} Answers;

typedef enum Question
{
    QUESTION_HEIGHTS,
    QUESTION_HEIGHTS_AND_NORMALS,
    QUESTION_PARTICLES,
    QUESTION_PARTICLES_AND_NORMALS,
    QUESTION_HEIGHTS_4M, // waves of 4 m and more
    QUESTION_WARM,       // the same points in each step of 1/60 s, with hints
    QUESTION_WARM_4M,
    QUESTION_WARM_NORMALS,
    QUESTION_MAP,          // heights of a grid of half a metre
    QUESTION_LATTICE,      // particles and normals of such a grid
    QUESTION_MOTION,       // velocities from texels
    QUESTION_ANOTHER_TIME, // wave by wave
    QUESTION_BELOW,        // velocity and pressure 5 m below still water
    QUESTION_RAYS,         // 45 degrees down from 20 m above
    QUESTION_COUNT
} Question;

// Time of the process, so that a busy machine does not count: a query runs on one thread.
static double Now(void)
{
    return (double)clock() / (double)CLOCKS_PER_SEC;
}

static int CompareDoubles(const void* a, const void* b)
{
    double x = *(const double*)a;
    double y = *(const double*)b;
    return (x > y) - (x < y);
}

// Points of a square as wide as `side` metres, in no order.
static void Scatter(Answers* answers, double side)
{
    uint32_t seed = 1;
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        seed = seed * 1664525u + 1013904223u;
        answers->points[i].x = side * (double)(seed >> 8) * 0x1p-24;
        seed = seed * 1664525u + 1013904223u;
        answers->points[i].z = side * (double)(seed >> 8) * 0x1p-24;
    }
}

// What takes long is asked of fewer points.
static int CountPoints(Question question)
{
    return question == QUESTION_ANOTHER_TIME || question == QUESTION_BELOW ? 256
           : question == QUESTION_RAYS                                     ? 4096
                                                                           : POINT_COUNT;
}

static void AskBelow(const swWorld* world, const swQueryDef* def, int count, const Answers* answers)
{
    static swPos places[POINT_COUNT];
    static swVec3 velocity[POINT_COUNT];
    static float head[POINT_COUNT];
    for (int i = 0; i < count; ++i)
    {
        places[i] = (swPos){answers->points[i].x, -5.0, answers->points[i].z};
    }
    swVolumeSamples samples = {.velocity = velocity, .pressureHead = head};
    swMoment_QueryVolume(swWorld_GetMoment(world), def, count, places, &samples, NULL);
}

static void AskRays(const swWorld* world, const swQueryDef* def, int count, const Answers* answers)
{
    static swRay rays[POINT_COUNT];
    static swRayHit hits[POINT_COUNT];
    for (int i = 0; i < count; ++i)
    {
        rays[i] = swDefaultRay((swPos){answers->points[i].x, 20.0, answers->points[i].z}, (swVec3){1.0f, -1.0f, 0.0f});
    }
    swMoment_CastRays(swWorld_GetMoment(world), def, count, rays, hits, NULL);
}

static void AskMap(const swWorld* world, const swQueryDef* def, Answers* answers, swQueryStats* stats)
{
    const swHeightMapDef map = {.spacing = 0.5, .width = 128, .height = POINT_COUNT / 128};
    swMoment_QueryHeightMap(swWorld_GetMoment(world), def, &map, answers->heights, stats);
}

static void AskLattice(const swWorld* world, const swQueryDef* def, Answers* answers)
{
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        answers->points[i] = (swPosXZ){0.5 * (i % 128), 0.5 * (i / 128)};
    }
    const swSurfaceSamples samples = {.height = answers->heights, .normal = answers->normals};
    swMoment_QueryParticles(swWorld_GetMoment(world), def, POINT_COUNT, answers->points, &samples, NULL, NULL);
}

static bool IsWarm(Question question)
{
    return question == QUESTION_WARM || question == QUESTION_WARM_4M || question == QUESTION_WARM_NORMALS;
}

static void Ask(const swWorld* world, Question question, Answers* answers, swQueryStats* stats)
{
    int count = CountPoints(question);
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = answers->heights, .residual = answers->residuals};
    *stats = (swQueryStats){.convergedCount = count, .iterationCount = count};
    switch (question)
    {
    case QUESTION_PARTICLES_AND_NORMALS:
        samples.normal = answers->normals;
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, count, answers->points, &samples, NULL, NULL);
        return;
    case QUESTION_PARTICLES:
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, count, answers->points, &samples, NULL, NULL);
        return;
    case QUESTION_BELOW:
        AskBelow(world, &def, count, answers);
        return;
    case QUESTION_RAYS:
        AskRays(world, &def, count, answers);
        return;
    case QUESTION_MAP:
        AskMap(world, &def, answers, stats);
        return;
    case QUESTION_LATTICE:
        AskLattice(world, &def, answers);
        return;
    case QUESTION_HEIGHTS_AND_NORMALS:
    case QUESTION_WARM_NORMALS:
        samples.normal = answers->normals;
        break;
    case QUESTION_MOTION:
        samples.velocity = answers->normals;
        break;
    case QUESTION_HEIGHTS_4M:
    case QUESTION_WARM_4M:
        def.minWavelength = 4.0f;
        break;
    case QUESTION_ANOTHER_TIME:
        def.time = -1000.0;
        break;
    default:
        break;
    }
    samples.hints = IsWarm(question) ? answers->hints : NULL;
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, count, answers->points, &samples, stats);
}

static int CountBands(const Scenario* scenario)
{
    int count = 0;
    for (int i = 0; i < scenario->systemCount; ++i)
    {
        swBandInfo bands[SW_MAX_BANDS];
        count += swWaveSystem_GetBands(scenario->world, scenario->systems[i], bands);
    }
    return count;
}

static void Measure(const Scenario* scenario, const char* name, Question question, double side, Answers* answers)
{
    static const char* const names[QUESTION_COUNT] = {"heights",
                                                      "heights_and_normals",
                                                      "particles",
                                                      "particles_and_normals",
                                                      "heights_4m",
                                                      "heights_warm",
                                                      "heights_warm_4m",
                                                      "heights_warm_and_normals",
                                                      "height_map",
                                                      "particles_of_a_grid_and_normals",
                                                      "heights_and_velocities",
                                                      "heights_another_time",
                                                      "motion_5m_below",
                                                      "rays"};
    double seconds[ROUNDS];
    swQueryStats stats;
    Scatter(answers, side);
    memset(answers->hints, 0, sizeof answers->hints);
    for (int i = 0; i < ROUNDS; ++i)
    {
        if (IsWarm(question))
        {
            swWorld_Step(scenario->world, 1.0 / 60.0);
        }
        double start = Now();
        Ask(scenario->world, question, answers, &stats);
        seconds[i] = Now() - start;
    }
    qsort(seconds, ROUNDS, sizeof seconds[0], CompareDoubles);
    int bands = CountBands(scenario);
    double points = CountPoints(question);
    printf("{\"bench\": \"queries\", \"scenario\": \"%s\", \"isa\": \"%s\", \"question\": \"%s\", \"bands\": %d, "
           "\"side_m\": %g, \"points_per_s\": %.0f, \"best_points_per_s\": %.0f, \"evaluations_per_point\": %.2f, "
           "\"converged\": %.5f, \"worst_residual_m\": %.2g, \"floor_bytes_per_evaluation\": %d, "
           "\"floor_flops_per_evaluation\": %d}\n",
           name, swIsa_GetName(swWorld_GetIsa(scenario->world)), names[question], bands, side,
           points / seconds[ROUNDS / 2], points / seconds[0], (double)stats.iterationCount / points,
           (double)stats.convergedCount / points, (double)stats.worstResidual, bands * 16 * 16, bands * 120);
    fflush(stdout);
}

// Waves of one octave, 4 to 8 m: a patch of one tile, as many renderers have it.
static void MeasurePatch(Answers* answers)
{
    ScenarioDef def = DefaultScenarioDef(SCENARIO_CALM);
    Scenario patch;
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.minWavelength = 4.0f;
    waves.maxWavelength = 8.0f;
    if (CreateScenario(&def, &patch) != SW_SUCCESS)
    {
        return;
    }
    if (swCreateWaveSystem(patch.world, &waves, &patch.systems[0]) == SW_SUCCESS &&
        swWorld_Step(patch.world, 1.0) == SW_SUCCESS)
    {
        patch.systemCount = 1;
        Measure(&patch, "patch", QUESTION_HEIGHTS, 100.0, answers);
        Measure(&patch, "patch", QUESTION_WARM, 100.0, answers);
    }
    DestroyScenario(&patch);
}

// The same heights asked by several threads at once, each with points of its own: no lock, no allocation between them.
typedef struct Asker
{
    pthread_t thread;
    const swWorld* world;
    Answers* answers;
} Asker;

static void* AskOften(void* argument)
{
    Asker* asker = argument;
    for (int i = 0; i < ROUNDS; ++i)
    {
        swQueryStats stats;
        Ask(asker->world, QUESTION_HEIGHTS, asker->answers, &stats);
    }
    return NULL;
}

static double AskAtOnce(const swWorld* world, int threadCount, Answers* answers)
{
    Asker askers[MAX_THREADS];
    struct timespec begin, end;
    timespec_get(&begin, TIME_UTC);
    for (int i = 0; i < threadCount; ++i)
    {
        askers[i] = (Asker){.world = world, .answers = &answers[i]};
        pthread_create(&askers[i].thread, NULL, AskOften, &askers[i]);
    }
    for (int i = 0; i < threadCount; ++i)
    {
        pthread_join(askers[i].thread, NULL);
    }
    timespec_get(&end, TIME_UTC);
    double seconds = (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
    return (double)threadCount * ROUNDS * POINT_COUNT / seconds;
}

static void MeasureThreads(int most)
{
    Answers* answers = malloc((size_t)most * sizeof *answers);
    ScenarioDef def = DefaultScenarioDef(SCENARIO_BREEZE);
    Scenario scenario;
    if (answers == NULL || CreateScenario(&def, &scenario) != SW_SUCCESS)
    {
        free(answers);
        return;
    }
    for (int i = 0; i < most; ++i)
    {
        Scatter(&answers[i], 1000.0);
    }
    double one = AskAtOnce(scenario.world, 1, answers);
    for (int threads = 1; threads <= most; threads *= 2)
    {
        double rate = AskAtOnce(scenario.world, threads, answers);
        printf("{\"bench\": \"queries\", \"question\": \"heights_at_once\", \"threads\": %d, \"points_per_s\": %.0f, "
               "\"per_core\": %.3f}\n",
               threads, rate, rate / one / threads);
        fflush(stdout);
    }
    DestroyScenario(&scenario);
    free(answers);
}

// ---- moments ----

static double MeasureHeights(const swMoment* moment, const swQueryDef* def, Answers* answers)
{
    double best = 1e9;
    const swSurfaceSamples samples = {.height = answers->heights};
    for (int i = 0; i < ROUNDS; ++i)
    {
        double start = Now();
        swMoment_QuerySurface(moment, def, POINT_COUNT, answers->points, &samples, NULL);
        double seconds = Now() - start;
        best = seconds < best ? seconds : best;
    }
    return POINT_COUNT / best;
}

// What a moment of another time costs beside a step, and what it answers.
static void MeasureMoments(Answers* answers)
{
    ScenarioDef scenarioDef = DefaultScenarioDef(SCENARIO_BREEZE);
    Scenario scenario;
    if (CreateScenario(&scenarioDef, &scenario) != SW_SUCCESS)
    {
        return;
    }
    swMomentDef def = swDefaultMomentDef();
    swMoment *moment = NULL, *later = NULL;
    Scatter(answers, 1000.0);
    if (swCreateMoment(scenario.world, &def, &moment) == SW_SUCCESS &&
        swCreateMoment(scenario.world, &def, &later) == SW_SUCCESS)
    {
        double step = 1e9, set = 1e9;
        for (int i = 0; i < ROUNDS; ++i)
        {
            double start = Now();
            swWorld_Step(scenario.world, 1.0 / 60.0);
            double middle = Now();
            swMoment_Set(moment, scenario.world, 100.0 + i);
            double end = Now();
            step = middle - start < step ? middle - start : step;
            set = end - middle < set ? end - middle : set;
        }
        swQueryDef query = swDefaultQueryDef();
        double own = MeasureHeights(swWorld_GetMoment(scenario.world), &query, answers);
        double other = MeasureHeights(moment, &query, answers);
        swMoment_Set(later, scenario.world, swMoment_GetTime(moment) + 1.0 / 60.0);
        query.time = swMoment_GetTime(moment) + 1.0 / 120.0;
        query.after = later;
        double between = MeasureHeights(moment, &query, answers);
        size_t bytes;
        swMoment_GetMemory(moment, &bytes);
        printf("{\"bench\": \"moments\", \"bytes\": %zu, \"step_ms\": %.3f, \"set_ms\": %.3f, "
               "\"world_heights_per_s\": %.0f, \"moment_heights_per_s\": %.0f, \"between_heights_per_s\": %.0f}\n",
               bytes, 1e3 * step, 1e3 * set, own, other, between);
        fflush(stdout);
    }
    swDestroyMoment(moment);
    swDestroyMoment(later);
    DestroyScenario(&scenario);
}

// ---- inputs ----

enum
{
    INPUT_COUNT = 1000,
    SHORE_SIDE = 64 // cells of the floor
};

// Shoals, levels and currents all around, none of which lies under the points.
static bool AddInputsElsewhere(swWorld* world)
{
    const swInputField fields[3] = {SW_INPUT_FLOOR, SW_INPUT_LEVEL, SW_INPUT_FLOW};
    swInputDef def = swDefaultInputDef();
    def.shape = SW_SHAPE_CIRCLE;
    def.size = (swVec3){200.0f, 0.0f, 200.0f};
    def.feather = 50.0f;
    def.value[0] = -2.0f;
    for (int i = 0; i < INPUT_COUNT; ++i)
    {
        double side = i % 2 == 0 ? 2500.0 : -1500.0; // the points lie within 0 and 1000 m
        def.field = fields[i % 3];
        def.position.x = 300.0 * (i % 32) - 4500.0;
        def.position.z = side + (side > 0.0 ? 300.0 : -300.0) * (i / 64);
        swInputId id;
        if (swCreateInput(world, &def, &id) != SW_SUCCESS)
        {
            return false;
        }
    }
    return true;
}

// A beach: 40 m deep in the west, 2 m above the water in the east.
static bool AddShore(swWorld* world)
{
    static float heights[SHORE_SIDE * SHORE_SIDE];
    for (int i = 0; i < SHORE_SIDE * SHORE_SIDE; ++i)
    {
        heights[i] = -40.0f + 42.0f * (float)(i % SHORE_SIDE) / (float)(SHORE_SIDE - 1);
    }
    swHost host = swDefaultHost();
    swRasterDef rasterDef = swDefaultRasterDef();
    rasterDef.width = rasterDef.height = SHORE_SIDE;
    rasterDef.spacingX = rasterDef.spacingZ = 1100.0 / (SHORE_SIDE - 1);
    rasterDef.x = rasterDef.z = -50.0;
    rasterDef.values = heights;
    swRaster* raster = NULL;
    if (swCreateRaster(&host, &rasterDef, &raster) != SW_SUCCESS)
    {
        return false;
    }
    swInputDef def = swDefaultInputDef();
    def.shape = SW_SHAPE_RASTER;
    def.raster = raster;
    swInputId id;
    bool isFine = swCreateInput(world, &def, &id) == SW_SUCCESS;
    swDestroyRaster(raster);
    return isFine;
}

// A stream of 1 m/s along the beach, even in its middle and with an edge of 100 m.
static bool AddStream(swWorld* world)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.shape = SW_SHAPE_RECTANGLE;
    def.position = (swPos){650.0, 0.0, 500.0};
    def.size = (swVec3){400.0f, 0.0f, 2000.0f};
    def.feather = 100.0f;
    def.value[1] = 1.0f;
    swInputId id;
    return swCreateInput(world, &def, &id) == SW_SUCCESS;
}

// The beach with a stream, a lake and a hole.
static bool AddShoreScene(swWorld* world)
{
    swInputDef lake = swDefaultInputDef(), dock = swDefaultInputDef();
    lake.field = SW_INPUT_LEVEL;
    lake.shape = SW_SHAPE_CIRCLE;
    lake.position = (swPos){900.0, 0.0, 200.0};
    lake.size = (swVec3){200.0f, 0.0f, 200.0f};
    lake.value[0] = 3.0f;
    dock.field = SW_INPUT_CLIP;
    dock.shape = SW_SHAPE_BOX;
    dock.position = (swPos){800.0, 0.0, 700.0};
    dock.size = (swVec3){60.0f, 30.0f, 20.0f};
    swInputId id;
    return AddShore(world) && AddStream(world) && swCreateInput(world, &lake, &id) == SW_SUCCESS &&
           swCreateInput(world, &dock, &id) == SW_SUCCESS;
}

typedef struct InputScene
{
    const char* name;
    bool (*add)(swWorld* world);
    ScenarioKind sea;
    bool arePatches;
} InputScene;

// 64 points of a ship, on a lattice.
static void MakePatches(Answers* answers)
{
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        const swPosXZ* first = &answers->points[i - i % 64];
        answers->points[i].x = first->x + 4.0 * (i % 8);
        answers->points[i].z = first->z + 4.0 * (i / 8 % 8);
    }
}

static void AskInTurns(const InputScene* scene, const swWorld* plain, const swWorld* shaped, Answers* answers)
{
    double seconds[2][ROUNDS], ratios[ROUNDS];
    swQueryStats stats;
    for (int i = 0; i < ROUNDS; ++i)
    {
        double start = Now();
        Ask(plain, QUESTION_HEIGHTS, answers, &stats);
        double middle = Now();
        Ask(shaped, QUESTION_HEIGHTS, answers, &stats);
        seconds[0][i] = middle - start;
        seconds[1][i] = Now() - middle;
        ratios[i] = seconds[0][i] / seconds[1][i];
    }
    qsort(seconds[0], ROUNDS, sizeof(double), CompareDoubles);
    qsort(seconds[1], ROUNDS, sizeof(double), CompareDoubles);
    qsort(ratios, ROUNDS, sizeof(double), CompareDoubles);
    double none = POINT_COUNT / seconds[0][0], some = POINT_COUNT / seconds[1][0];
    printf("{\"bench\": \"inputs\", \"scene\": \"%s\", \"points_per_s\": %.0f, \"without_inputs\": %.0f, "
           "\"ratio\": %.4f, \"evaluations_per_point\": %.2f, \"converged\": %.5f}\n",
           scene->name, some, none, ratios[ROUNDS / 2], (double)stats.iterationCount / POINT_COUNT,
           (double)stats.convergedCount / POINT_COUNT);
    fflush(stdout);
}

// Two seas take turns, so that a busy machine counts for both.
static void CompareInputs(const InputScene* scene, Answers* answers)
{
    ScenarioDef def = DefaultScenarioDef(scene->sea);
    Scenario plain, shaped;
    if (CreateScenario(&def, &plain) != SW_SUCCESS)
    {
        return;
    }
    if (CreateScenario(&def, &shaped) == SW_SUCCESS)
    {
        Scatter(answers, 1000.0);
        if (scene->arePatches)
        {
            MakePatches(answers);
        }
        if (scene->add(shaped.world) && swWorld_Step(shaped.world, 0.0) == SW_SUCCESS)
        {
            AskInTurns(scene, plain.world, shaped.world, answers);
        }
        DestroyScenario(&shaped);
    }
    DestroyScenario(&plain);
}

// Those whose name has `part` in it.
static void MeasureInputs(const char* part, Answers* answers)
{
    static const InputScene scenes[] = {
        {"open sea, 1000 inputs elsewhere", AddInputsElsewhere, SCENARIO_BREEZE, false},
        {"beach, points anywhere", AddShore, SCENARIO_BREEZE, false},
        {"beach, patches of 64 points", AddShore, SCENARIO_BREEZE, true},
        {"stream, points anywhere", AddStream, SCENARIO_BREEZE, false},
        {"shore, points anywhere", AddShoreScene, SCENARIO_GALE, false},
        {"shore, patches of 64 points", AddShoreScene, SCENARIO_GALE, true},
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; ++i)
    {
        if (strstr(scenes[i].name, part) != NULL)
        {
            CompareInputs(&scenes[i], answers);
        }
    }
}

// bench_queries [THREADS], or bench_queries inputs [PART of a scene's name]
int main(int argumentCount, char** arguments)
{
    Answers* answers = malloc(sizeof *answers);
    if (answers == NULL)
    {
        fprintf(stderr, "bench_queries: no memory\n");
        return 1;
    }
    if (argumentCount > 1 && strcmp(arguments[1], "inputs") == 0)
    {
        MeasureInputs(argumentCount > 2 ? arguments[2] : "", answers);
        free(answers);
        return 0;
    }
    for (int kind = SCENARIO_BREEZE; kind < SCENARIO_COUNT; ++kind)
    {
        ScenarioDef def = DefaultScenarioDef((ScenarioKind)kind);
        def.enableMotion = true;
        Scenario scenario;
        if (CreateScenario(&def, &scenario) != SW_SUCCESS)
        {
            free(answers);
            return 1;
        }
        for (int question = 0; question < QUESTION_COUNT; ++question)
        {
            Measure(&scenario, ScenarioName(def.kind), (Question)question, 1000.0, answers);
        }
        Measure(&scenario, ScenarioName(def.kind), QUESTION_HEIGHTS, 50.0, answers); // a ship's own water
        DestroyScenario(&scenario);
    }
    MeasureMoments(answers);
    MeasurePatch(answers);
    MeasureInputs("", answers);
    free(answers);
    int threads = argumentCount > 1 ? atoi(arguments[1]) : 2;
    MeasureThreads(threads < 1 ? 1 : threads > MAX_THREADS ? MAX_THREADS : threads);
    return 0;
}
