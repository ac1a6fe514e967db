// SPDX-License-Identifier: MIT
// `seaway bench`: what a step, a query and each GPU pass of a full open sea cost on this machine. Medians of many runs.

#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "picture.h"
#include "progress.h"
#include "seconds.h"
#include "verbs.h"

#define STEP_COUNT 60
#define QUERY_COUNT 16384
#define QUERY_ROUNDS 9
#define FRAME_COUNT 24
#define MAX_PASSES 32
#define MAX_ROUNDS 64

typedef struct CpuResult
{
    int threads;
    swIsa isa;
    int tileCount;
    size_t memory;
    double stepMs;
    double heightsPerSecond; // one thread, all bands
    double particlesPerSecond;
    double evaluationsPerHeight;
    double worstResidual; // m
    double convergedShare;
} CpuResult;

typedef struct GpuResult
{
    bool isPresent;
    char device[256];
    bool isSoftware;
    PixelSize size;
    int passCount;
    char names[MAX_PASSES][64];
    double passMs[MAX_PASSES];
    double frameMs; // on the host's clock: record, submit, wait, copy back
    size_t memory;
} GpuResult;

static int CompareNumbers(const void* a, const void* b)
{
    double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

static double FindMedian(double* values, int count)
{
    qsort(values, (size_t)count, sizeof(double), CompareNumbers);
    return count > 0 ? values[count / 2] : 0.0;
}

// A gale's sea, which has waves in all octaves.
static swWorld* CreateSea(const swHost* host, bool enableQueries, int* tileCount)
{
    swWorld* world = NULL;
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = enableQueries;
    swResult result = swCreateWorld(host, &worldDef, &world);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 18.0f;
    swWaveSystemId id;
    result = result == SW_SUCCESS ? swCreateWaveSystem(world, &def, &id) : result;
    result = result == SW_SUCCESS ? swWorld_Step(world, 0.0) : result;
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, "the sea could not be made");
        swDestroyWorld(world);
        return NULL;
    }
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(world, id, bands);
    *tileCount = 0;
    for (int i = 0; i < count; ++i)
    {
        *tileCount += bands[i].tileCount;
    }
    return world;
}

static void TimeSteps(swWorld* world, CpuResult* cpu)
{
    double times[STEP_COUNT];
    for (int i = 0; i < STEP_COUNT; ++i)
    {
        double begin = GetSeconds();
        (void)swWorld_Step(world, 1.0 / 60.0);
        times[i] = 1e3 * (GetSeconds() - begin);
    }
    cpu->stepMs = FindMedian(times, STEP_COUNT);
}

static bool TimeQueries(const swWorld* world, CpuResult* cpu)
{
    swPosXZ* points = malloc(QUERY_COUNT * sizeof(swPosXZ));
    float* heights = malloc(QUERY_COUNT * sizeof(float));
    swVec3* displacements = malloc(QUERY_COUNT * sizeof(swVec3));
    bool isFine = points != NULL && heights != NULL && displacements != NULL;
    double times[2][QUERY_ROUNDS];
    swQueryDef def = swDefaultQueryDef();
    swQueryStats stats = {0};
    for (int i = 0; i < QUERY_COUNT && isFine; ++i)
    {
        points[i] = (swPosXZ){(i % 128) * 7.3, (i / 128) * 7.9};
    }
    for (int i = 0; i < QUERY_ROUNDS && isFine; ++i)
    {
        double begin = GetSeconds();
        swMoment_QuerySurface(swWorld_GetMoment(world), &def, QUERY_COUNT, points,
                              &(swSurfaceSamples){.height = heights}, &stats);
        double middle = GetSeconds();
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, QUERY_COUNT, points,
                                &(swSurfaceSamples){.displacement = displacements}, NULL, NULL);
        times[0][i] = middle - begin;
        times[1][i] = GetSeconds() - middle;
    }
    if (isFine)
    {
        cpu->heightsPerSecond = QUERY_COUNT / FindMedian(times[0], QUERY_ROUNDS);
        cpu->particlesPerSecond = QUERY_COUNT / FindMedian(times[1], QUERY_ROUNDS);
        cpu->evaluationsPerHeight = (double)stats.iterationCount / QUERY_COUNT;
        cpu->worstResidual = (double)stats.worstResidual;
        cpu->convergedShare = (double)stats.convergedCount / QUERY_COUNT;
    }
    free(points);
    free(heights);
    free(displacements);
    return isFine;
}

static bool BenchCpu(int threads, CpuResult* cpu)
{
    swHost host = MakeHost();
    swTaskPool* pool = threads == 1 ? NULL : AttachThreads(&host, threads);
    cpu->threads = host.workerCount;
    swWorld* world = CreateSea(&host, true, &cpu->tileCount);
    bool isFine = world != NULL;
    if (isFine)
    {
        cpu->isa = swWorld_GetIsa(world);
        cpu->memory = swWorld_GetMemory(world);
        TimeSteps(world, cpu);
        isFine = TimeQueries(world, cpu);
    }
    swDestroyWorld(world);
    swDestroyTaskPool(pool);
    return isFine;
}

static swShot MakeBenchShot(const swView* view, const swWorld* world, PixelSize size)
{
    swPos position = {0.0, swWorld_GetSeaLevel(world) + 12.0, 0.0};
    return (swShot){.view = view,
                    .camera =
                        swMakeCamera(position, 0.6f, -0.08f, 0.0f, 0.9f, (uint32_t)size.width, (uint32_t)size.height),
                    .sky = swDefaultSkyDef(),
                    .water = swDefaultWaterDef(),
                    .time = swWorld_GetTime(world)};
}

static void NotePasses(const swGpu* gpu, double times[MAX_PASSES][MAX_ROUNDS], int round, GpuResult* result)
{
    swPassTime passes[MAX_PASSES];
    result->passCount = swGpu_GetPassTimes(gpu, passes, MAX_PASSES);
    for (int i = 0; i < result->passCount; ++i)
    {
        snprintf(result->names[i], sizeof(result->names[i]), "%s", passes[i].name);
        times[i][round] = (double)passes[i].milliseconds;
    }
}

static bool TimeFrames(PictureMaker* maker, swWorld* world, swView* view, GpuResult* result)
{
    static double times[MAX_PASSES][MAX_ROUNDS];
    double frameTimes[MAX_ROUNDS];
    bool isFine = true;
    BeginProgress("frames", FRAME_COUNT);
    for (int i = 0; i < FRAME_COUNT && isFine; ++i)
    {
        swView_SetViewpoint(view, (swPos){0.0, 12.0, 0.0});
        double begin = GetSeconds();
        isFine = swWorld_Step(world, 1.0 / 60.0) == SW_SUCCESS;
        swShot shot = MakeBenchShot(view, world, result->size);
        isFine = isFine && MakePicture(maker, &shot, 1.0f / 60.0f, i == 0);
        frameTimes[i] = 1e3 * (GetSeconds() - begin);
        NotePasses(GetPictureGpu(maker), times, i, result);
        UpdateProgress(i + 1);
    }
    EndProgress();
    int warm = 4; // the first frames make pipelines and tables
    for (int i = 0; i < result->passCount && isFine; ++i)
    {
        result->passMs[i] = FindMedian(times[i] + warm, FRAME_COUNT - warm);
    }
    result->frameMs = isFine ? FindMedian(frameTimes + warm, FRAME_COUNT - warm) : 0.0;
    return isFine;
}

static bool BenchGpu(DeviceName device, PixelSize size, GpuResult* result)
{
    swHost host = MakeHost();
    swTaskPool* pool = AttachThreads(&host, 0);
    int tileCount = 0;
    PictureMakerDef def = {.device = device.choice,
                           .deviceIndex = device.index,
                           .width = size.width,
                           .height = size.height,
                           .supersample = 1};
    PictureMaker* maker = CreatePictureMaker(&host, &def);
    swViewDef viewDef = swDefaultViewDef();
    viewDef = maker != NULL ? FitPictureView(maker, &viewDef) : viewDef;
    swWorld* world = maker != NULL ? CreateSea(&host, viewDef.enableCpuLayers, &tileCount) : NULL;
    swView* view = NULL;
    if (world != NULL && swCreateView(world, &viewDef, &view) == SW_SUCCESS && ShowWorld(maker, world))
    {
        result->size = size;
        snprintf(result->device, sizeof(result->device), "%s", swGpu_GetDeviceName(GetPictureGpu(maker)));
        result->isSoftware = swGpu_IsSoftware(GetPictureGpu(maker));
        result->isPresent = TimeFrames(maker, world, view, result);
        result->memory = GetPictureMemory(maker);
    }
    DestroyPictureMaker(maker);
    swDestroyView(view);
    swDestroyWorld(world);
    swDestroyTaskPool(pool);
    return result->isPresent;
}

static void PrintResults(const char* machine, const CpuResult* cpus, int cpuCount, const GpuResult* gpu)
{
    printf("%s, %s, %d tiles of 128 x 128\n", machine, swIsa_GetName(cpus[0].isa), cpus[0].tileCount);
    for (int i = 0; i < cpuCount; ++i)
    {
        printf("  step, %d thread%s  %8.3f ms\n", cpus[i].threads, cpus[i].threads == 1 ? " " : "s", cpus[i].stepMs);
    }
    printf("  heights, 1 thread %7.3f million/s, %.2f evaluations each, worst residual %.3g m\n",
           1e-6 * cpus[0].heightsPerSecond, cpus[0].evaluationsPerHeight, cpus[0].worstResidual);
    printf("  particles, 1 thread %5.3f million/s\n", 1e-6 * cpus[0].particlesPerSecond);
    printf("  memory            %8.2f MB\n", 1e-6 * (double)cpus[0].memory);
    if (!gpu->isPresent)
    {
        return;
    }
    printf("%s%s, %dx%d\n", gpu->device, gpu->isSoftware ? " (software)" : "", gpu->size.width, gpu->size.height);
    for (int i = 0; i < gpu->passCount; ++i)
    {
        printf("  %-17s %8.3f ms\n", gpu->names[i], gpu->passMs[i]);
    }
    printf("  %-17s %8.3f ms with the host's part and the copy back\n", "frame", gpu->frameMs);
    printf("  %-17s %8.2f MB\n", "memory", 1e-6 * (double)gpu->memory);
}

static void PrintResultsJson(const char* machine, const CpuResult* cpus, int cpuCount, const GpuResult* gpu)
{
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "machine", machine);
    JsonText(&json, "isa", swIsa_GetName(cpus[0].isa));
    JsonInteger(&json, "tile_count", cpus[0].tileCount);
    JsonInteger(&json, "cpu_memory_bytes", (long long)cpus[0].memory);
    JsonOpenArray(&json, "steps");
    for (int i = 0; i < cpuCount; ++i)
    {
        JsonOpenObject(&json, NULL);
        JsonInteger(&json, "threads", cpus[i].threads);
        JsonNumber(&json, "step_ms", cpus[i].stepMs);
        JsonCloseObject(&json);
    }
    JsonCloseArray(&json);
    JsonNumber(&json, "heights_per_s", cpus[0].heightsPerSecond);
    JsonNumber(&json, "evaluations_per_height", cpus[0].evaluationsPerHeight);
    JsonNumber(&json, "worst_residual_m", cpus[0].worstResidual);
    JsonNumber(&json, "converged_fraction", cpus[0].convergedShare);
    JsonNumber(&json, "particles_per_s", cpus[0].particlesPerSecond);
    if (!gpu->isPresent)
    {
        JsonNull(&json, "gpu");
        JsonCloseObject(&json);
        return;
    }
    JsonOpenObject(&json, "gpu");
    JsonText(&json, "device", gpu->device);
    JsonFlag(&json, "software", gpu->isSoftware);
    JsonInteger(&json, "width_px", gpu->size.width);
    JsonInteger(&json, "height_px", gpu->size.height);
    JsonOpenArray(&json, "passes");
    for (int i = 0; i < gpu->passCount; ++i)
    {
        JsonOpenObject(&json, NULL);
        JsonText(&json, "name", gpu->names[i]);
        JsonNumber(&json, "time_ms", gpu->passMs[i]);
        JsonCloseObject(&json);
    }
    JsonCloseArray(&json);
    JsonNumber(&json, "frame_ms", gpu->frameMs);
    JsonInteger(&json, "gpu_memory_bytes", (long long)gpu->memory);
    JsonCloseObject(&json);
    JsonCloseObject(&json);
}

int RunBench(int argumentCount, char** arguments)
{
    bool asJson = false, cpuOnly = false;
    DeviceName device = {SW_DEVICE_AUTO, 0};
    PixelSize size = {1280, 720};
    static const char* const ofTheGpu[] = {"device", "size", NULL};
    const Option options[] = {
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &device,
         .placeholder = "D",
         .help = "auto, gpu, software, or a number of `seaway devices`"},
        {.name = "size",
         .kind = OPTION_SIZE,
         .value = &size,
         .placeholder = "WxH",
         .help = "of the picture that the GPU draws (default 1280x720)",
         .min = 16,
         .max = 16384},
        {.name = "cpu-only", .kind = OPTION_FLAG, .value = &cpuOnly, .help = "leave the GPU out", .without = ofTheGpu},
        {.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"},
    };
    const Verb verb = {
        .name = "bench",
        .synopsis = "[--device D] [--size WxH] [--cpu-only] [--json]",
        .text = "Time a step, queries and every GPU pass of a gale's sea with all its octaves, a default view\n"
                "and a picture. Times are medians; the machine is named.",
        .options = options,
        .optionCount = sizeof(options) / sizeof(options[0])};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    char machine[128];
    GetMachineName(machine, sizeof(machine));
    CpuResult cpus[2] = {0};
    GpuResult gpu = {0};
    int cpuCount = 0;
    bool isFine = BenchCpu(1, &cpus[0]) && BenchCpu(0, &cpus[1]);
    cpuCount = cpus[1].threads > 1 ? 2 : 1;
    bool hasDevice = cpuOnly || (isFine && BenchGpu(device, size, &gpu));
    if (!isFine)
    {
        return EXIT_PROBLEM;
    }
    if (asJson)
    {
        PrintResultsJson(machine, cpus, cpuCount, &gpu);
    }
    else
    {
        PrintResults(machine, cpus, cpuCount, &gpu);
    }
    return FinishOutput() && hasDevice ? EXIT_FINE : EXIT_PROBLEM;
}
