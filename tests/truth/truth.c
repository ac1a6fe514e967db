// SPDX-License-Identifier: MIT

#include "truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/math/random.h"

static char outPath[1024];
static bool isOptionalNow;

static const char* GetMarker(void)
{
    return isOptionalNow ? "optional" : "always";
}

void BeginTruth(const char* program)
{
    const char* folder = getenv("SEAWAY_TRUTH_OUT");
    outPath[0] = 0;
    if (folder != NULL && Seeds(8) == 8)
    {
        snprintf(outPath, sizeof(outPath), "%s/%s.tsv", folder, program);
        remove(outPath);
    }
}

void MarkOptional(bool isOptional)
{
    isOptionalNow = isOptional;
}

// Minus zero is zero to a reader.
static void PrintNumber(char* text, size_t size, double value, int digits)
{
    snprintf(text, size, "%.*f", digits, value);
    if (text[0] == '-' && strspn(text, "-0.") == strlen(text))
    {
        memmove(text, text + 1, strlen(text));
    }
}

static void Record(const Finding* finding, const char* target, double measured, const char* tolerance, bool isFine)
{
    char value[64];
    PrintNumber(value, sizeof(value), measured, finding->digits);
    print_message("%-4s %s: %s %s, target %s, tolerance %s%s\n", finding->number, finding->what, value, finding->unit,
                  target, tolerance, isFine ? "" : "  <-- FAILED");
    if (outPath[0] != 0)
    {
        FILE* file = fopen(outPath, "a");
        assert_non_null(file);
        fprintf(file, "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", finding->number, finding->what, finding->source,
                finding->unit, target, value, tolerance, isFine ? "yes" : "no", GetMarker());
        fclose(file);
    }
    assert_true(isFine);
}

void FindNear(const Finding* finding, double target, double measured, double tolerance)
{
    char targetText[64], toleranceText[64];
    PrintNumber(targetText, sizeof(targetText), target, finding->digits);
    snprintf(toleranceText, sizeof(toleranceText), "\xc2\xb1 %.4g", tolerance);
    Record(finding, targetText, measured, toleranceText, fabs(measured - target) <= tolerance);
}

void FindWithin(const Finding* finding, double target, double measured, double part)
{
    char targetText[64], toleranceText[64];
    PrintNumber(targetText, sizeof(targetText), target, finding->digits);
    snprintf(toleranceText, sizeof(toleranceText), "\xc2\xb1 %.4g %%", 100.0 * part);
    Record(finding, targetText, measured, toleranceText, fabs(measured - target) <= part * fabs(target));
}

void FindBetween(const Finding* finding, double low, double high, double measured)
{
    char lowText[64], highText[64], targetText[160];
    PrintNumber(lowText, sizeof(lowText), low, finding->digits);
    PrintNumber(highText, sizeof(highText), high, finding->digits);
    snprintf(targetText, sizeof(targetText), "%s to %s", lowText, highText);
    Record(finding, targetText, measured, "within", measured >= low && measured <= high);
}

void FindBelow(const Finding* finding, double limit, double measured)
{
    char limitText[64];
    snprintf(limitText, sizeof(limitText), "\xe2\x89\xa4 %.4g", limit);
    Record(finding, "0", measured, limitText, measured <= limit);
}

int Seeds(int count)
{
#ifdef SW_TRUTH_SHORT
    return count < 2 ? count : count < 16 ? 2 : count / 8;
#else
    return count;
#endif
}

double Loosen(double tolerance)
{
#ifdef SW_TRUTH_SHORT
    return 4.0 * tolerance;
#else
    return tolerance;
#endif
}

typedef struct Jobs
{
    TruthJob* job;
    void* context;
} Jobs;

static void RunSome(void* context, int begin, int end, int worker)
{
    const Jobs* jobs = context;
    (void)worker;
    for (int i = begin; i < end; ++i)
    {
        jobs->job(jobs->context, i);
    }
}

void RunJobs(TruthJob* job, void* context, int count)
{
    swHost host = swDefaultHost();
    swTaskPool* pool = NULL;
    Jobs jobs = {job, context};
    assert_int_equal(swCreateTaskPool(&host, (int)sysconf(_SC_NPROCESSORS_ONLN) - 1, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    host.parallelFor(host.taskContext, RunSome, &jobs, count, 1);
    swDestroyTaskPool(pool);
}

swWorld* CreateTruthSea(const swWaveSystemDef* def)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swWaveSystemId id;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS || swCreateWaveSystem(world, def, &id) != SW_SUCCESS ||
        swWorld_Step(world, 0.0) != SW_SUCCESS)
    {
        fprintf(stderr, "a sea for the test could not be made\n");
        abort(); // jobs run on other threads, where an assertion of cmocka would jump astray
    }
    return world;
}

swWaveSystemDef MakeWaves(const swSpectrumDef* spectrum, double shortest, double longest, uint32_t seed)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum = *spectrum;
    def.minWavelength = (float)shortest;
    def.maxWavelength = (float)longest;
    def.seed = seed;
    return def;
}

swSpectrumDef MakeSpectrum(swSpectrumKind kind, double height, double period, double direction, double spreadExponent)
{
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = kind;
    def.significantHeight = (float)height;
    def.peakPeriod = (float)period;
    def.direction = (float)direction;
    def.spreadExponent = (float)spreadExponent;
    return def;
}

void ScatterPoints(double side, int index, int count, swPosXZ* points)
{
    for (int i = 0; i < count; ++i)
    {
        points[i].x = side * swHashToUnit(swHashWave(71, index, i, 0, 0));
        points[i].z = side * swHashToUnit(swHashWave(71, index, i, 0, 1));
    }
}

typedef struct HeightJob
{
    const swWaveSystemDef* def;
    bool isSurface;
    double* heights;
} HeightJob;

static void MeasureHeight(void* context, int seed)
{
    const HeightJob* job = context;
    swWaveSystemDef def = *job->def;
    def.seed = 1000u + (uint32_t)seed;
    swWorld* world = CreateTruthSea(&def);
    swPosXZ points[HEIGHT_POINTS];
    float heights[HEIGHT_POINTS];
    swVec3 displacement[HEIGHT_POINTS];
    swQueryDef query = swDefaultQueryDef();
    double sum = 0.0, square = 0.0;
    for (int time = 0; time < HEIGHT_TIMES; ++time)
    {
        ScatterPoints(23000.0, time, HEIGHT_POINTS, points);
        swWorld_SetTime(world, 2000.0 * (time + swHashToUnit(swHashWave(72, time, 0, 0, 0))));
        swWorld_Step(world, 0.0);
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, job->isSurface ? HEIGHT_POINTS : 0, points,
                              &(swSurfaceSamples){.height = heights}, NULL);
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, job->isSurface ? 0 : HEIGHT_POINTS, points,
                                &(swSurfaceSamples){.displacement = displacement}, NULL, NULL);
        for (int i = 0; i < HEIGHT_POINTS; ++i)
        {
            double h = job->isSurface ? (double)heights[i] : (double)displacement[i].y;
            sum += h;
            square += h * h;
        }
    }
    swDestroyWorld(world);
    double mean = sum / HEIGHT_SAMPLES;
    job->heights[seed] = 4.0 * sqrt(square / HEIGHT_SAMPLES - mean * mean);
}

void MeasureHeights(const swWaveSystemDef* def, bool isSurface, int seedCount, double* heights)
{
    HeightJob job = {def, isSurface, heights};
    RunJobs(MeasureHeight, &job, seedCount);
}
