// SPDX-License-Identifier: MIT
// `seaway stats`: the sea state that a scene's surface has, beside the one that was asked for.

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "progress.h"
#include "sea_estimate.h"
#include "verbs.h"

#define GAUGE_COUNT 256
#define SURFACE_POINTS 16384
#define SURFACE_TIMES 4
#define MAX_SEEDS 256

typedef struct StatsOptions
{
    double area;     // 0: chosen by the peak
    double duration; // 0: chosen by the peak
    int seeds;
    bool asJson;
} StatsOptions;

// What one seed gave.
typedef struct SeedResult
{
    SeaSums sums;
    SurfaceSums surface;
    double significantHeight;
    bool isFine;
} SeedResult;

typedef struct Stats
{
    StatsOptions options;
    const swHost* host;
    const swScene* scene;
    SeaBins bins;
    SeaGauges gauges;
    SeedResult* seeds;
    atomic_int doneCount; // seeds
} Stats;

// Frequencies that the system makes waves of, Hz.
static void FindRange(const swScene* scene, const swWaveSystemDef* def, double* low, double* high)
{
    double gravity = (double)scene->world.gravity, depth = (double)def->spectrum.depth;
    *low = FindFrequency((double)def->maxWavelength, depth, gravity);
    *high = FindFrequency((double)def->minWavelength, depth, gravity);
}

static double FindPeakFrequency(const swSceneWaves* waves)
{
    swSeaState state;
    if (swSpectrum_GetSeaState(&waves->def.spectrum, 0.0f, 0.0f, &state) != SW_SUCCESS || state.peakPeriod <= 0.0f)
    {
        return 0.0;
    }
    return 1.0 / (double)state.peakPeriod;
}

// One measured sea is measured in its own bins; else in bins a twentieth of the lowest peak wide, from 0.4 of the lowest
// peak to 4 times the highest.
static bool ChooseBins(Stats* stats)
{
    const swScene* scene = stats->scene;
    double first = 1e9, last = 0.0, low = 1e9, high = 0.0;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        double peak = FindPeakFrequency(scene->waves + i), systemLow = 0.0, systemHigh = 0.0;
        FindRange(scene, &scene->waves[i].def, &systemLow, &systemHigh);
        first = peak > 0.0 ? fmin(first, peak) : first;
        last = fmax(last, peak);
        low = fmin(low, systemLow);
        high = fmax(high, systemHigh);
    }
    if (last <= 0.0)
    {
        Complain("the scene has no waves to measure");
        return false;
    }
    const swSpectrumDef* only = &scene->waves[0].def.spectrum;
    if (scene->wavesCount == 1 && only->kind == SW_SPECTRUM_TABLE)
    {
        UseTableBins(only->table, &stats->bins);
    }
    else
    {
        low = fmax(low, 0.4 * first);
        high = fmin(high, 4.0 * last);
        UseEqualBins(low, high, (int)fmin(ceil((high - low) * 20.0 / first), 512.0), &stats->bins);
    }
    double period = 1.0 / first, length = FindWavelength(first, (double)INFINITY, (double)scene->world.gravity);
    stats->gauges.gaugeCount = GAUGE_COUNT;
    stats->gauges.duration = stats->options.duration > 0.0 ? stats->options.duration : 40.0 * period;
    stats->gauges.area = stats->options.area > 0.0 ? stats->options.area : 40.0 * length;
    return true;
}

// A world of the scene with another seed; with waves of the bins only, or with all.
static swWorld* CreateSea(const Stats* stats, int seed, bool onlyBins)
{
    swScene* scene = malloc(sizeof(swScene));
    swWorld* world = NULL;
    if (scene == NULL)
    {
        return NULL;
    }
    *scene = *stats->scene; // tables stay with the scene that was read
    scene->world.enableQueries = true;
    double last = stats->bins.high[stats->bins.count - 1];
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        swWaveSystemDef* def = &scene->waves[i].def;
        def->seed += (uint32_t)seed * 1000u;
        double shortest = FindWavelength(1.02 * last, (double)def->spectrum.depth, (double)scene->world.gravity);
        if (onlyBins && shortest > (double)def->minWavelength && shortest < (double)def->maxWavelength)
        {
            def->minWavelength = (float)shortest;
        }
    }
    if (swCreateSceneWorld(stats->host, scene, &world) != SW_SUCCESS)
    {
        world = NULL;
    }
    free(scene);
    return world;
}

static bool MeasureSurface(const Stats* stats, int seed, SurfaceSums* sums)
{
    swWorld* world = CreateSea(stats, seed, false);
    bool isFine = world != NULL;
    for (int i = 0; i < SURFACE_TIMES && isFine; ++i)
    {
        swWorld_SetTime(world, stats->gauges.duration * i / SURFACE_TIMES);
        isFine = swWorld_Step(world, 0.0) == SW_SUCCESS &&
                 LookAtSurface(world, stats->gauges.area, SURFACE_POINTS, stats->scene->world.foam.threshold, sums);
    }
    swDestroyWorld(world);
    return isFine;
}

static void MeasureSeeds(void* context, int begin, int end, int worker)
{
    Stats* stats = context;
    for (int i = begin; i < end; ++i)
    {
        SeedResult* seed = stats->seeds + i;
        swWorld* world = CreateSea(stats, i, true);
        seed->isFine = world != NULL && RecordSea(world, &stats->gauges, &stats->bins, 1, &seed->sums);
        swDestroyWorld(world);
        seed->isFine = seed->isFine && MeasureSurface(stats, i, &seed->surface);
        swSeaState state;
        FindSeaState(&stats->bins, &seed->sums, &state);
        seed->significantHeight = (double)state.significantHeight;
        int doneCount = atomic_fetch_add(&stats->doneCount, 1) + 1;
        if (worker == 0) // the bar is one thread's
        {
            UpdateProgress(doneCount);
        }
    }
}

// One system's spectrum over the range it was measured in. Variance goes with the square of the weight.
static bool AskSystem(const Stats* stats, const swSceneWaves* waves, bool whole, swSeaState* state)
{
    double low = stats->bins.low[0], high = stats->bins.high[stats->bins.count - 1];
    if (whole)
    {
        FindRange(stats->scene, &waves->def, &low, &high);
    }
    else if (stats->scene->wavesCount == 1 && waves->def.spectrum.kind == SW_SPECTRUM_TABLE)
    {
        low = high = 0.0; // its own bins
    }
    if (swSpectrum_GetSeaState(&waves->def.spectrum, (float)low, (float)high, state) != SW_SUCCESS)
    {
        return false;
    }
    state->significantHeight *= waves->def.weight;
    state->meanSquareSlope *= waves->def.weight * waves->def.weight;
    return true;
}

// Several systems together, from their densities at a few frequencies of each bin.
static void AskBins(const Stats* stats, SeaSums* sums)
{
    enum
    {
        PARTS = 4,
        DIRECTIONS = 72
    };
    memset(sums, 0, sizeof(*sums));
    sums->weight = 1.0;
    for (int i = 0; i < stats->bins.count * PARTS; ++i)
    {
        int bin = i / PARTS;
        double width = (stats->bins.high[bin] - stats->bins.low[bin]) / PARTS;
        double f = stats->bins.low[bin] + width * (i % PARTS + 0.5);
        for (int j = 0; j < stats->scene->wavesCount; ++j)
        {
            const swWaveSystemDef* def = &stats->scene->waves[j].def;
            double length = FindWavelength(f, (double)def->spectrum.depth, (double)stats->scene->world.gravity);
            double k = 2.0 * SW_PI / length;
            double weight2 = (double)def->weight * (double)def->weight;
            double energy = weight2 * width * (double)swSpectrum_GetDensity(&def->spectrum, (float)f);
            for (int direction = 0; direction < DIRECTIONS && energy > 0.0; ++direction)
            {
                double angle = 2.0 * SW_PI * direction / DIRECTIONS, x = k * cos(angle), z = k * sin(angle);
                double share = energy * (2.0 * SW_PI / DIRECTIONS) *
                               (double)swSpectrum_GetSpreading(&def->spectrum, (float)f, (float)angle);
                sums->h[bin] += share;
                sums->hx[bin] += share * x;
                sums->hz[bin] += share * z;
                sums->xx[bin] += share * x * x;
                sums->zz[bin] += share * z * z;
                sums->xz[bin] += share * x * z;
            }
        }
    }
}

static bool AskSea(const Stats* stats, swSeaState* state)
{
    const swScene* scene = stats->scene;
    bool isFine = true;
    if (scene->wavesCount == 1)
    {
        isFine = AskSystem(stats, scene->waves, false, state);
    }
    else
    {
        SeaSums* sums = malloc(sizeof(SeaSums));
        isFine = sums != NULL;
        if (isFine)
        {
            AskBins(stats, sums);
            FindSeaState(&stats->bins, sums, state);
        }
        free(sums);
    }
    state->meanSquareSlope = 0.0f; // of all waves, also those beyond the bins
    for (int i = 0; i < scene->wavesCount && isFine; ++i)
    {
        swSeaState system;
        isFine = AskSystem(stats, scene->waves + i, true, &system);
        state->meanSquareSlope += isFine ? system.meanSquareSlope : 0.0f;
    }
    return isFine;
}

// [Monahan and O'Muircheartaigh 1980], of the strongest wind that a formula of the scene names; NAN if none does.
static double AskWhitecaps(const swScene* scene)
{
    double wind = 0.0;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        const swSpectrumDef* def = &scene->waves[i].def.spectrum;
        wind = def->kind == SW_SPECTRUM_TABLE ? wind : fmax(wind, (double)def->windSpeed);
    }
    return wind > 0.0 ? fmin(3.84e-6 * pow(wind, 3.41), 1.0) : (double)NAN;
}

typedef struct Report
{
    swSeaState asked, measured;
    double askedWhitecaps, whitecaps;
    double surfaceHeight;   // 4 times the deviation of heights above points
    double surfaceSlope;    // mean square, of the true surface
    double heightDeviation; // of Hs from seed to seed
} Report;

static bool MakeReport(const Stats* stats, Report* report)
{
    SeaSums* sums = calloc(1, sizeof(SeaSums));
    if (sums == NULL || !AskSea(stats, &report->asked))
    {
        free(sums);
        return false;
    }
    SurfaceSums surface = {0};
    double mean = 0.0, square = 0.0;
    for (int i = 0; i < stats->options.seeds; ++i)
    {
        const SeedResult* seed = stats->seeds + i;
        AddSums(&seed->sums, sums);
        surface.count += seed->surface.count;
        surface.height += seed->surface.height;
        surface.heightSquare += seed->surface.heightSquare;
        surface.slopeSquare += seed->surface.slopeSquare;
        surface.particleSlopeSquare += seed->surface.particleSlopeSquare;
        surface.whitecaps += seed->surface.whitecaps;
        mean += seed->significantHeight / stats->options.seeds;
        square += seed->significantHeight * seed->significantHeight / stats->options.seeds;
    }
    FindSeaState(&stats->bins, sums, &report->measured);
    report->measured.meanSquareSlope = (float)(surface.particleSlopeSquare / surface.count);
    report->askedWhitecaps = AskWhitecaps(stats->scene);
    report->whitecaps = surface.whitecaps / surface.count;
    double average = surface.height / surface.count;
    report->surfaceHeight = 4.0 * sqrt(fmax(surface.heightSquare / surface.count - average * average, 0.0));
    report->surfaceSlope = surface.slopeSquare / surface.count;
    report->heightDeviation = sqrt(fmax(square - mean * mean, 0.0));
    free(sums);
    return true;
}

static void PrintLine(const char* name, const char* unit, int digits, double asked, double measured)
{
    char left[32] = "-";
    if (isfinite(asked))
    {
        snprintf(left, sizeof(left), "%.*f", digits, asked);
    }
    printf("%-18s %9s  %9.*f  %s\n", name, left, digits, measured, unit);
}

static void PrintReport(const Stats* stats, const Report* report)
{
    const swSeaState *a = &report->asked, *m = &report->measured;
    printf("%-18s %9s  %9s\n", "", "asked", "measured");
    PrintLine("Hs", "m", 3, (double)a->significantHeight, (double)m->significantHeight);
    PrintLine("Tp", "s", 2, (double)a->peakPeriod, (double)m->peakPeriod);
    PrintLine("Tm01", "s", 2, (double)a->periodTm01, (double)m->periodTm01);
    PrintLine("Tm02", "s", 2, (double)a->periodTm02, (double)m->periodTm02);
    PrintLine("Te", "s", 2, (double)a->energyPeriod, (double)m->energyPeriod);
    PrintLine("from, mean", "deg", 1, BearingFrom((double)a->meanDirection), BearingFrom((double)m->meanDirection));
    PrintLine("from, at the peak", "deg", 1, BearingFrom((double)a->peakDirection),
              BearingFrom((double)m->peakDirection));
    PrintLine("spread", "deg", 1, (double)a->spread * 180.0 / SW_PI, (double)m->spread * 180.0 / SW_PI);
    PrintLine("mean square slope", "all waves", 5, (double)a->meanSquareSlope, (double)m->meanSquareSlope);
    PrintLine("whitecap cover", "of the area", 5, report->askedWhitecaps, report->whitecaps);
    printf("\nThe surface itself: 4 sigma %.3f m, mean square slope %.5f\n", report->surfaceHeight,
           report->surfaceSlope);
    printf("%.4g to %.4g Hz, %d seeds, Hs %.3f m from seed to seed; %d gauges over %.0f m, %.0f s\n",
           stats->bins.low[0], stats->bins.high[stats->bins.count - 1], stats->options.seeds, report->heightDeviation,
           stats->gauges.gaugeCount, stats->gauges.area, stats->gauges.duration);
}

static void PrintReportJson(const Stats* stats, const char* path, const Report* report)
{
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "scene", path);
    JsonOpenObject(&json, "asked");
    WriteSeaState(&json, &report->asked);
    JsonNumber(&json, "whitecap_fraction", report->askedWhitecaps);
    JsonCloseObject(&json);
    JsonOpenObject(&json, "measured");
    WriteSeaState(&json, &report->measured);
    JsonNumber(&json, "whitecap_fraction", report->whitecaps);
    JsonCloseObject(&json);
    JsonOpenObject(&json, "surface");
    JsonNumber(&json, "hs_m", report->surfaceHeight);
    JsonNumber(&json, "mean_square_slope", report->surfaceSlope);
    JsonCloseObject(&json);
    JsonNumber(&json, "min_frequency_hz", stats->bins.low[0]);
    JsonNumber(&json, "max_frequency_hz", stats->bins.high[stats->bins.count - 1]);
    JsonInteger(&json, "seed_count", stats->options.seeds);
    JsonNumber(&json, "hs_deviation_m", report->heightDeviation);
    JsonInteger(&json, "gauge_count", stats->gauges.gaugeCount);
    JsonNumber(&json, "area_m", stats->gauges.area);
    JsonNumber(&json, "duration_s", stats->gauges.duration);
    JsonCloseObject(&json);
}

static bool Measure(Stats* stats, const swHost* pool)
{
    stats->seeds = calloc((size_t)stats->options.seeds, sizeof(SeedResult));
    if (stats->seeds == NULL)
    {
        Complain("no memory for %d seeds", stats->options.seeds);
        return false;
    }
    BeginProgress("seeds", stats->options.seeds);
    if (pool->workerCount > 1)
    {
        pool->parallelFor(pool->taskContext, MeasureSeeds, stats, stats->options.seeds, 1);
    }
    else
    {
        MeasureSeeds(stats, 0, stats->options.seeds, 0);
    }
    EndProgress();
    for (int i = 0; i < stats->options.seeds; ++i)
    {
        if (!stats->seeds[i].isFine)
        {
            Complain("the sea of seed %d could not be made", i);
            return false;
        }
    }
    return true;
}

static int MeasureScene(const StatsOptions* options, const char* path)
{
    swHost host = MakeHost(), pooled = MakeHost();
    swTaskPool* pool = AttachThreads(&pooled, 0); // seeds run side by side, each on one thread
    swScene* scene = NULL;
    Stats* stats = calloc(1, sizeof(Stats));
    Report report = {0};
    swResult result = swReadScene(&host, path, &scene);
    bool isFine = result == SW_SUCCESS && stats != NULL;
    if (isFine)
    {
        stats->options = *options;
        stats->host = &host;
        stats->scene = scene;
        isFine = ChooseBins(stats) && Measure(stats, &pooled) && MakeReport(stats, &report);
    }
    else
    {
        ComplainAboutResult(result, path);
    }
    if (isFine && options->asJson)
    {
        PrintReportJson(stats, path, &report);
    }
    else if (isFine)
    {
        PrintReport(stats, &report);
    }
    if (stats != NULL)
    {
        free(stats->seeds);
    }
    free(stats);
    swDestroyScene(scene);
    swDestroyTaskPool(pool);
    return FinishOutput() && isFine ? EXIT_FINE : EXIT_PROBLEM;
}

int RunStats(int argumentCount, char** arguments)
{
    const char* path = NULL;
    StatsOptions stats = {.seeds = 4};
    const Option options[] = {
        {.name = "area",
         .kind = OPTION_NUMBER,
         .value = &stats.area,
         .placeholder = "L",
         .help = "side of the square with gauges, m (default: 40 wavelengths of the peak)",
         .min = 1,
         .max = 1e6},
        {.name = "seeds",
         .kind = OPTION_INT,
         .value = &stats.seeds,
         .placeholder = "N",
         .help = "seas of the same statistics to average (default 4)",
         .min = 1,
         .max = MAX_SEEDS},
        {.name = "duration",
         .kind = OPTION_NUMBER,
         .value = &stats.duration,
         .placeholder = "S",
         .help = "of a record, s (default: 40 periods of the peak)",
         .min = 10,
         .max = 1e5},
        {.name = "json", .kind = OPTION_FLAG, .value = &stats.asJson, .help = "print JSON"},
    };
    const Verb verb = {
        .name = "stats",
        .synopsis = "SCENE [--area L] [--seeds N] [--duration S] [--json]",
        .text =
            "Measure the sea of a scene as moored buoys would, beside what its spectra ask for: significant height,\n"
            "periods, direction, spread, slope and whitecaps. A measured sea is measured in its own frequency bins.",
        .options = options,
        .optionCount = sizeof(options) / sizeof(options[0]),
        .positionalMin = 1,
        .positionalMax = 1,
        .positionalName = "a scene file",
        .positionals = &path};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    return MeasureScene(&stats, path);
}
