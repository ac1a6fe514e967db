// SPDX-License-Identifier: MIT
// One measured sea is measured in its own bins; else in bins a twentieth of the lowest peak wide and wider for short
// waves, from 0.4 of the lowest peak to 4 times the highest. Buoys record worlds that hold the bins' waves only, which
// saves time; slopes and whitecaps are those of all waves. Seeds run side by side, each on one thread.

#include "sea_measure.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "common.h"

#define GAUGE_COUNT 512
#define SURFACE_POINTS 16384
#define SURFACE_TIMES 4
// Squares that each seed is looked at.
#define PATCHES_PER_SEED 2

// What one seed gave.
typedef struct SeedResult
{
    swSeaSums groups[MEASURE_GROUPS];
    swSurfaceSums surface;
    swSeaPatches* patches; // NULL without directions
    double whitecaps;      // mean foam
    swFoamState foam;
    bool isFine;
} SeedResult;

typedef struct Job
{
    SeaMeasurement* sea;
    const swHost* host;
    SeedResult* seeds;
    atomic_int doneCount; // seeds
} Job;

// ---- waves by hand ----

// The frequency of a wave that was given by hand, Hz, and its variance with the system's weight, m^2.
static double FindComponent(const swScene* scene, const swWaveSystemDef* def, int index, double* variance)
{
    const swWaveComponent* component = &def->components[index];
    double amplitude = (double)def->weight * (double)component->amplitude;
    *variance = 0.5 * amplitude * amplitude;
    return swGetWaveFrequency((double)component->wavelength, (double)def->spectrum.depth, (double)scene->world.gravity);
}

static double SumComponents(const swScene* scene, const swWaveSystemDef* def, double low, double high)
{
    double sum = 0.0, variance = 0.0;
    for (int i = 0; i < def->componentCount; ++i)
    {
        double frequency = FindComponent(scene, def, i, &variance);
        sum += frequency >= low && frequency < high ? variance : 0.0;
    }
    return sum;
}

static double SumComponentSlopes(const swWaveSystemDef* def)
{
    double sum = 0.0;
    for (int i = 0; i < def->componentCount; ++i)
    {
        const swWaveComponent* component = &def->components[i];
        double steepness =
            2.0 * SW_PI * (double)def->weight * (double)component->amplitude / (double)component->wavelength;
        sum += 0.5 * steepness * steepness;
    }
    return sum;
}

static double FindComponentPeak(const swScene* scene, const swWaveSystemDef* def)
{
    double peak = 0.0, most = 0.0, variance = 0.0;
    for (int i = 0; i < def->componentCount; ++i)
    {
        double frequency = FindComponent(scene, def, i, &variance);
        peak = variance > most ? frequency : peak;
        most = fmax(most, variance);
    }
    return peak;
}

// Bins reach to every wave that was given, however far it is from the peak.
static void WidenByComponents(const swScene* scene, double* low, double* high)
{
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        const swWaveSystemDef* def = &scene->waves[i].def;
        for (int j = 0; j < def->componentCount; ++j)
        {
            double variance = 0.0, frequency = FindComponent(scene, def, j, &variance);
            *low = fmin(*low, 0.9 * frequency);
            *high = fmax(*high, 1.1 * frequency);
        }
    }
}

static int FindBin(const swSeaBins* bins, double frequency)
{
    for (int i = 0; i < bins->count; ++i)
    {
        if (frequency >= bins->low[i] && frequency < bins->high[i])
        {
            return i;
        }
    }
    return -1;
}

// A line has no density: its variance is shared out over the bin that it falls into.
static double SpreadOverBin(const SeaMeasurement* sea, const swWaveSystemDef* def, double frequency)
{
    int bin = FindBin(&sea->bins, frequency);
    if (bin < 0)
    {
        return 0.0;
    }
    double low = sea->bins.low[bin], high = sea->bins.high[bin];
    return SumComponents(sea->scene, def, low, high) / (high - low);
}

static void AddComponentDirections(const SeaMeasurement* sea, const swWaveSystemDef* def, double frequency, int count,
                                   double* density)
{
    int bin = FindBin(&sea->bins, frequency);
    for (int i = 0; i < def->componentCount && bin >= 0; ++i)
    {
        double variance = 0.0, own = FindComponent(sea->scene, def, i, &variance);
        if (FindBin(&sea->bins, own) == bin)
        {
            double turns = (double)def->components[i].direction / (2.0 * SW_PI);
            int sector = (int)floor((turns - floor(turns)) * count + 0.5) % count;
            double width = sea->bins.high[bin] - sea->bins.low[bin];
            density[sector] += variance / width * count / (2.0 * SW_PI);
        }
    }
}

static bool HasComponents(const swScene* scene)
{
    int count = 0;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        count += scene->waves[i].def.componentCount;
    }
    return count > 0;
}

// ---- what to measure ----

// Frequencies that the system makes waves of, Hz.
static void FindRange(const swScene* scene, const swWaveSystemDef* def, double* low, double* high)
{
    double gravity = (double)scene->world.gravity, depth = (double)def->spectrum.depth;
    *low = swGetWaveFrequency((double)def->maxWavelength, depth, gravity);
    *high = swGetWaveFrequency((double)def->minWavelength, depth, gravity);
}

static double FindPeakFrequency(const swScene* scene, const swSceneWaves* waves)
{
    if (waves->def.componentCount > 0)
    {
        return FindComponentPeak(scene, &waves->def);
    }
    swSeaState state;
    if (swSpectrum_GetSeaState(&waves->def.spectrum, 0.0f, 0.0f, &state) != SW_SUCCESS || state.peakPeriod <= 0.0f)
    {
        return 0.0;
    }
    return 1.0 / (double)state.peakPeriod;
}

static bool ChooseBins(SeaMeasurement* sea)
{
    const swScene* scene = sea->scene;
    double first = 1e9, last = 0.0, low = 1e9, high = 0.0, longest = 0.0;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        double peak = FindPeakFrequency(scene, scene->waves + i), systemLow = 0.0, systemHigh = 0.0;
        FindRange(scene, &scene->waves[i].def, &systemLow, &systemHigh);
        first = peak > 0.0 ? fmin(first, peak) : first;
        last = fmax(last, peak);
        low = fmin(low, systemLow);
        high = fmax(high, systemHigh);
    }
    if (last <= 0.0)
    {
        Complain("there are no waves to measure");
        return false;
    }
    sea->depth = (double)scene->waves[0].def.spectrum.depth;
    const swSpectrumDef* only = &scene->waves[0].def.spectrum;
    if (scene->wavesCount == 1 && only->kind == SW_SPECTRUM_TABLE)
    {
        swMakeTableBins(only->table, &sea->bins);
        longest = swGetTableDuration(only->table);
    }
    else
    {
        low = fmax(low, 0.4 * first);
        high = fmin(high, 4.0 * last);
        WidenByComponents(scene, &low, &high);
        swMakeGrowingBins(low, high, 0.05 * first, 0.03, &sea->bins);
    }
    double period = 1.0 / first, length = swGetWavelength(first, (double)INFINITY, (double)scene->world.gravity);
    sea->gauges.gaugeCount = GAUGE_COUNT;
    sea->gauges.duration = sea->options.duration > 0.0 ? sea->options.duration : fmax(40.0 * period, longest);
    sea->gauges.area = sea->options.area > 0.0 ? sea->options.area : 40.0 * length;
    return true;
}

// A world of the scene with another seed; with waves of the bins only, or with all.
static swWorld* CreateSea(const swHost* host, const SeaMeasurement* sea, int seed, bool onlyBins)
{
    swScene* scene = malloc(sizeof(swScene));
    swWorld* world = NULL;
    if (scene == NULL)
    {
        return NULL;
    }
    *scene = *sea->scene; // tables stay with the scene that was read
    scene->world.enableQueries = true;
    double last = sea->bins.high[sea->bins.count - 1];
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        scene->waves[i].isReplay = false; // the record nearest to the scene's time, for as long as it takes
        swWaveSystemDef* def = &scene->waves[i].def;
        def->seed += (uint32_t)seed * 1000u;
        double shortest = swGetWavelength(1.02 * last, (double)def->spectrum.depth, (double)scene->world.gravity);
        if (onlyBins && shortest > (double)def->minWavelength && shortest < (double)def->maxWavelength)
        {
            def->minWavelength = (float)shortest;
        }
    }
    if (swCreateSceneWorld(host, scene, &world) != SW_SUCCESS)
    {
        world = NULL;
    }
    free(scene);
    return world;
}

static bool LookAtSea(const Job* job, int index, SeedResult* seed)
{
    const SeaMeasurement* sea = job->sea;
    swWorld* world = CreateSea(job->host, sea, index, false);
    bool isFine = world != NULL;
    for (int i = 0; i < SURFACE_TIMES && isFine; ++i)
    {
        swWorld_SetTime(world, sea->gauges.duration * i / SURFACE_TIMES);
        isFine = swWorld_Step(world, 0.0) == SW_SUCCESS &&
                 swLookAtSurface(world, sea->gauges.area, SURFACE_POINTS, &seed->surface) == SW_SUCCESS;
    }
    for (int i = 0; i < PATCHES_PER_SEED && isFine && sea->options.withDirections; ++i)
    {
        double begin = sea->gauges.duration * (i + 0.5) / PATCHES_PER_SEED;
        isFine = swLookAtPatches(world, begin, sea->depth, i, seed->patches) == SW_SUCCESS;
    }
    if (isFine)
    {
        seed->whitecaps = swMeasureFoam(world, 0.0, 0.0);
        seed->foam = swWorld_GetFoamState(world);
        isFine = isfinite(seed->whitecaps);
    }
    swDestroyWorld(world);
    return isFine;
}

static void MeasureSeeds(void* context, int begin, int end, int worker)
{
    Job* job = context;
    const SeaMeasurement* sea = job->sea;
    for (int i = begin; i < end; ++i)
    {
        SeedResult* seed = job->seeds + i;
        swWorld* world = CreateSea(job->host, sea, i, true);
        seed->isFine =
            world != NULL && swRecordSea(world, &sea->gauges, &sea->bins, MEASURE_GROUPS, seed->groups) == SW_SUCCESS;
        swDestroyWorld(world);
        seed->isFine = seed->isFine && LookAtSea(job, i, seed);
        int doneCount = atomic_fetch_add(&job->doneCount, 1) + 1;
        if (worker == 0) // the bar is one thread's
        {
            UpdateProgress(doneCount);
        }
    }
}

// Waves that the system leaves out by their length are not asked for.
static bool IsInRange(const SeaMeasurement* sea, const swWaveSystemDef* def, double frequency)
{
    double low = 0.0, high = 0.0;
    FindRange(sea->scene, def, &low, &high);
    return frequency >= low && frequency <= high;
}

// One system's spectrum over the range it was measured in. Variance goes with the square of the weight.
static bool AskSystem(const SeaMeasurement* sea, const swSceneWaves* waves, bool whole, swSeaState* state)
{
    double low = sea->bins.low[0], high = sea->bins.high[sea->bins.count - 1];
    if (waves->def.componentCount > 0)
    {
        state->meanSquareSlope = (float)SumComponentSlopes(&waves->def);
        return true; // AskBins() has the rest
    }
    if (whole)
    {
        FindRange(sea->scene, &waves->def, &low, &high);
    }
    else if (sea->scene->wavesCount == 1 && waves->def.spectrum.kind == SW_SPECTRUM_TABLE)
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

// Add one system's density at frequency and 2 pi i / count.
static void AddDirections(const SeaMeasurement* sea, const swWaveSystemDef* def, double frequency, int count,
                          double* density)
{
    if (def->componentCount > 0)
    {
        AddComponentDirections(sea, def, frequency, count, density);
        return;
    }
    if (!IsInRange(sea, def, frequency))
    {
        return;
    }
    double energy =
        (double)def->weight * (double)def->weight * (double)swSpectrum_GetDensity(&def->spectrum, (float)frequency);
    swSpectrumDef shape = def->spectrum;
    shape.significantHeight = 0.0f; // says nothing of directions, and takes time to find a level for
    for (int i = 0; i < count && energy > 0.0; ++i)
    {
        double theta = 2.0 * SW_PI * i / count;
        density[i] += energy * (double)swSpectrum_GetSpreading(&shape, (float)frequency, (float)theta);
    }
}

// Several systems together, or waves by hand, from their densities at a few frequencies of each bin.
static void AskBins(const SeaMeasurement* sea, swSeaSums* sums)
{
    enum
    {
        PARTS = 2,
        DIRECTIONS = 72
    };
    memset(sums, 0, sizeof(*sums));
    sums->weight = 1.0;
    for (int i = 0; i < sea->bins.count * PARTS * sea->scene->wavesCount; ++i)
    {
        int part = i / sea->scene->wavesCount, bin = part / PARTS;
        const swWaveSystemDef* def = &sea->scene->waves[i % sea->scene->wavesCount].def;
        double width = (sea->bins.high[bin] - sea->bins.low[bin]) / PARTS;
        double f = sea->bins.low[bin] + width * (part % PARTS + 0.5);
        double k = 2.0 * SW_PI / swGetWavelength(f, (double)def->spectrum.depth, (double)sea->scene->world.gravity);
        double density[DIRECTIONS] = {0.0};
        AddDirections(sea, def, f, DIRECTIONS, density);
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            double angle = 2.0 * SW_PI * j / DIRECTIONS, x = k * cos(angle), z = k * sin(angle);
            double share = density[j] * width * (2.0 * SW_PI / DIRECTIONS);
            sums->h[bin] += share;
            sums->hx[bin] += share * x;
            sums->hz[bin] += share * z;
            sums->xx[bin] += share * x * x;
            sums->zz[bin] += share * z * z;
            sums->xz[bin] += share * x * z;
        }
    }
}

static bool AskSea(const SeaMeasurement* sea, swSeaState* state)
{
    const swScene* scene = sea->scene;
    bool isFine = true;
    if (scene->wavesCount == 1 && !HasComponents(scene))
    {
        isFine = AskSystem(sea, scene->waves, false, state);
    }
    else
    {
        swSeaSums* sums = malloc(sizeof(swSeaSums));
        isFine = sums != NULL;
        if (isFine)
        {
            AskBins(sea, sums);
            swEstimateSeaState(&sea->bins, sums, state);
        }
        free(sums);
    }
    state->meanSquareSlope = 0.0f; // of all waves, also those beyond the bins
    for (int i = 0; i < scene->wavesCount && isFine; ++i)
    {
        swSeaState system; // one without energy adds nothing
        bool hasEnergy = AskSystem(sea, scene->waves + i, true, &system);
        state->meanSquareSlope += hasEnergy ? system.meanSquareSlope : 0.0f;
    }
    return isFine;
}

double AskDensity(const SeaMeasurement* sea, double frequency)
{
    double sum = 0.0;
    for (int i = 0; i < sea->scene->wavesCount; ++i)
    {
        const swWaveSystemDef* def = &sea->scene->waves[i].def;
        double square = (double)def->weight * (double)def->weight;
        if (def->componentCount > 0)
        {
            sum += SpreadOverBin(sea, def, frequency);
        }
        else if (IsInRange(sea, def, frequency))
        {
            sum += square * (double)swSpectrum_GetDensity(&def->spectrum, (float)frequency);
        }
    }
    return sum;
}

void AskDirections(const SeaMeasurement* sea, double frequency, int count, double* density)
{
    memset(density, 0, (size_t)count * sizeof(double));
    for (int i = 0; i < sea->scene->wavesCount; ++i)
    {
        AddDirections(sea, &sea->scene->waves[i].def, frequency, count, density);
    }
}

double AskVariance(const SeaMeasurement* sea, double low, double high)
{
    double sum = 0.0;
    for (int i = 0; i < sea->scene->wavesCount; ++i)
    {
        const swWaveSystemDef* def = &sea->scene->waves[i].def;
        swSeaState state;
        double first = 0.0, last = 0.0;
        FindRange(sea->scene, def, &first, &last);
        first = fmax(first, low);
        last = fmin(last, high);
        if (def->componentCount > 0)
        {
            sum += SumComponents(sea->scene, def, low, high);
        }
        else if (first < last &&
                 swSpectrum_GetSeaState(&def->spectrum, (float)first, (float)last, &state) == SW_SUCCESS)
        {
            double height = (double)def->weight * (double)state.significantHeight;
            sum += height * height / 16.0;
        }
    }
    return sum;
}

// Of all seeds together, and how they differ.
static void SumSeeds(SeaMeasurement* sea, const SeedResult* seeds, swSurfaceSums* surface)
{
    double mean = 0.0, square = 0.0;
    int count = sea->options.seeds;
    for (int i = 0; i < count; ++i)
    {
        swSeaSums alone = {0};
        swSeaState state;
        for (int j = 0; j < MEASURE_GROUPS; ++j)
        {
            swAddSeaSums(seeds[i].groups + j, &alone);
        }
        swAddSeaSums(&alone, &sea->sums);
        swEstimateSeaState(&sea->bins, &alone, &state);
        mean += (double)state.significantHeight / count;
        square += (double)state.significantHeight * (double)state.significantHeight / count;
        surface->count += seeds[i].surface.count;
        surface->height += seeds[i].surface.height;
        surface->heightSquare += seeds[i].surface.heightSquare;
        surface->slopeSquare += seeds[i].surface.slopeSquare;
        surface->particleSlopeSquare += seeds[i].surface.particleSlopeSquare;
        sea->whitecaps += seeds[i].whitecaps / sea->options.seeds;
        if (sea->options.withDirections)
        {
            swAddSeaPatches(seeds[i].patches, sea->patches);
        }
    }
    sea->heightDeviation = sqrt(fmax(square - mean * mean, 0.0));
}

// Densities with the standard errors of their means over all groups.
static void FindDensities(SeaMeasurement* sea, int groupCount, const swSeaSums* groups)
{
    for (int i = 0; i < sea->bins.count; ++i)
    {
        double mean = swEstimateDensity(&sea->bins, &sea->sums, i), square = 0.0;
        for (int j = 0; j < groupCount; ++j)
        {
            double off = swEstimateDensity(&sea->bins, groups + j, i) - mean;
            square += off * off / groupCount;
        }
        sea->density[i] = mean;
        sea->densityError[i] = groupCount > 1 ? sqrt(square / (groupCount - 1)) : (double)NAN;
    }
}

static bool FindResults(const swHost* host, SeaMeasurement* sea, const SeedResult* seeds)
{
    swSurfaceSums surface = {0};
    int groupCount = sea->options.seeds * MEASURE_GROUPS;
    swSeaSums* groups = malloc((size_t)groupCount * sizeof(swSeaSums));
    if (groups == NULL || !AskSea(sea, &sea->asked))
    {
        free(groups);
        return false;
    }
    for (int i = 0; i < groupCount; ++i)
    {
        groups[i] = seeds[i / MEASURE_GROUPS].groups[i % MEASURE_GROUPS];
    }
    SumSeeds(sea, seeds, &surface);
    swEstimateSeaState(&sea->bins, &sea->sums, &sea->measured);
    FindDensities(sea, groupCount, groups);
    bool isFine = swEstimateSeaError(host, &sea->bins, groupCount, groups, &sea->error) == SW_SUCCESS;
    free(groups);
    sea->measured.meanSquareSlope = (float)(surface.particleSlopeSquare / surface.count);
    sea->error.meanSquareSlope = NAN; // of all waves, not of the bins
    sea->askedWhitecaps = (double)seeds[0].foam.cover;
    sea->foamWind = (double)seeds[0].foam.windSpeed;
    double average = surface.height / surface.count;
    sea->surfaceHeight = 4.0 * sqrt(fmax(surface.heightSquare / surface.count - average * average, 0.0));
    sea->surfaceSlope = surface.slopeSquare / surface.count;
    return isFine;
}

static void DestroySeeds(SeedResult* seeds, int count)
{
    for (int i = 0; i < count && seeds != NULL; ++i)
    {
        swDestroySeaPatches(seeds[i].patches);
    }
    free(seeds);
}

static SeedResult* CreateSeeds(const swHost* host, SeaMeasurement* sea)
{
    double gravity = (double)sea->scene->world.gravity;
    double longest = swGetWavelength(sea->bins.low[0], sea->depth, gravity);
    double shortest = swGetWavelength(sea->bins.high[sea->bins.count - 1], sea->depth, gravity);
    SeedResult* seeds = calloc((size_t)sea->options.seeds, sizeof(SeedResult));
    bool isFine = seeds != NULL;
    if (sea->options.withDirections)
    {
        longest = fmin(longest, 4096.0);
        isFine = isFine && swCreateSeaPatches(host, shortest, longest, &sea->patches) == SW_SUCCESS;
        for (int i = 0; i < sea->options.seeds && isFine; ++i)
        {
            isFine = swCreateSeaPatches(host, shortest, longest, &seeds[i].patches) == SW_SUCCESS;
        }
    }
    if (!isFine)
    {
        Complain("no memory for %d seeds", sea->options.seeds);
        DestroySeeds(seeds, sea->options.seeds);
        return NULL;
    }
    return seeds;
}

static bool MeasureAll(SeaMeasurement* sea, SeedResult* seeds)
{
    swHost host = MakeHost(), pooled = MakeHost();
    swTaskPool* pool = AttachThreads(&pooled, 0);
    Job job = {.sea = sea, .host = &host, .seeds = seeds};
    BeginProgress("seeds", sea->options.seeds);
    if (pooled.workerCount > 1)
    {
        pooled.parallelFor(pooled.taskContext, MeasureSeeds, &job, sea->options.seeds, 1);
    }
    else
    {
        MeasureSeeds(&job, 0, sea->options.seeds, 0);
    }
    EndProgress();
    swDestroyTaskPool(pool);
    for (int i = 0; i < sea->options.seeds; ++i)
    {
        if (!seeds[i].isFine)
        {
            Complain("the sea of seed %d could not be made", i);
            return false;
        }
    }
    return true;
}

SeaMeasurement* MeasureSea(const swScene* scene, const MeasureOptions* options)
{
    SeaMeasurement* sea = calloc(1, sizeof(SeaMeasurement));
    if (sea == NULL)
    {
        Complain("no memory for a measurement");
        return NULL;
    }
    sea->scene = scene;
    sea->options = *options;
    if (!ChooseBins(sea))
    {
        free(sea);
        return NULL;
    }
    swHost host = MakeHost();
    SeedResult* seeds = CreateSeeds(&host, sea);
    bool isFine = seeds != NULL && MeasureAll(sea, seeds) && FindResults(&host, sea, seeds);
    DestroySeeds(seeds, options->seeds);
    if (!isFine)
    {
        DestroyMeasurement(sea);
        return NULL;
    }
    return sea;
}

void DestroyMeasurement(SeaMeasurement* sea)
{
    if (sea != NULL)
    {
        swDestroySeaPatches(sea->patches);
    }
    free(sea);
}
