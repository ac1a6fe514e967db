// SPDX-License-Identifier: MIT
// How many heights a second one core answers, with every band of a sea and the default tolerance. One line of JSON a row.
// The floor of a height is one evaluation of the surface, at which a query with nothing to search (particles) runs:
// per evaluation and band a window of 4 x 4 texels of 16 bytes is read, and 2 * (16 + 4) * 3 operations weigh it.

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "scenarios/scenario.h"

enum
{
    POINT_COUNT = 16384,
    ROUNDS = 25
};

typedef struct Answers
{
    swPosXZ points[POINT_COUNT];
    float heights[POINT_COUNT];
    float residuals[POINT_COUNT];
    swVec3 normals[POINT_COUNT];
} Answers;

typedef enum Question
{
    QUESTION_HEIGHTS,
    QUESTION_HEIGHTS_AND_NORMALS,
    QUESTION_PARTICLES,
    QUESTION_PARTICLES_AND_NORMALS,
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

static void Ask(const swWorld* world, Question question, Answers* answers, swQueryStats* stats)
{
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = answers->heights, .residual = answers->residuals};
    if (question == QUESTION_HEIGHTS_AND_NORMALS || question == QUESTION_PARTICLES_AND_NORMALS)
    {
        samples.normal = answers->normals;
    }
    if (question == QUESTION_PARTICLES || question == QUESTION_PARTICLES_AND_NORMALS)
    {
        *stats = (swQueryStats){.convergedCount = POINT_COUNT, .iterationCount = POINT_COUNT};
        swWorld_QueryParticles(world, &def, POINT_COUNT, answers->points, &samples, NULL);
        return;
    }
    swWorld_QuerySurface(world, &def, POINT_COUNT, answers->points, &samples, stats);
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
    static const char* const names[QUESTION_COUNT] = {"heights", "heights_and_normals", "particles",
                                                      "particles_and_normals"};
    double seconds[ROUNDS];
    swQueryStats stats;
    Scatter(answers, side);
    for (int i = 0; i < ROUNDS; ++i)
    {
        double start = Now();
        Ask(scenario->world, question, answers, &stats);
        seconds[i] = Now() - start;
    }
    qsort(seconds, ROUNDS, sizeof seconds[0], CompareDoubles);
    int bands = CountBands(scenario);
    printf("{\"bench\": \"queries\", \"scenario\": \"%s\", \"isa\": \"%s\", \"question\": \"%s\", \"bands\": %d, "
           "\"side_m\": %g, \"points_per_s\": %.0f, \"best_points_per_s\": %.0f, \"evaluations_per_point\": %.2f, "
           "\"converged\": %.5f, \"worst_residual_m\": %.2g, \"floor_bytes_per_evaluation\": %d, "
           "\"floor_flops_per_evaluation\": %d}\n",
           name, swIsa_GetName(swWorld_GetIsa(scenario->world)), names[question], bands, side,
           POINT_COUNT / seconds[ROUNDS / 2], POINT_COUNT / seconds[0], (double)stats.iterationCount / POINT_COUNT,
           (double)stats.convergedCount / POINT_COUNT, (double)stats.worstResidual, bands * 16 * 16, bands * 120);
    fflush(stdout);
}

int main(void)
{
    Answers* answers = malloc(sizeof *answers);
    if (answers == NULL)
    {
        fprintf(stderr, "bench_queries: no memory\n");
        return 1;
    }
    for (int kind = SCENARIO_BREEZE; kind < SCENARIO_COUNT; ++kind)
    {
        ScenarioDef def = DefaultScenarioDef((ScenarioKind)kind);
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
    free(answers);
    return 0;
}
