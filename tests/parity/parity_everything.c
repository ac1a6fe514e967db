// SPDX-License-Identifier: MIT
// All that a host can put into the sea, at once: the surface that the core answers and the one that the GPU answers are
// the same within a millimetre, around the view and 100 km away, and so are the slices that pictures are drawn from.
// Each feature is alone once, so that the error of each is seen.
//
//     parity_everything [POINTS [FEATURE [queries]]]
//
// asks for so many points at each of the two places, and for a tenth of that of each feature alone; with the name of a
// feature, or `all`, only of that one; with `queries`, slices are left out. Without, few enough for a software device.
// It needs libc and a Vulkan driver, so that it can be carried to a machine with a GPU.
//
// A point is left out if the two halves differ there and it, or where its particle rests, lies within a texel of a
// place where the surface jumps: a dam, the edge of a hole, a fold, where several particles are above a point and
// either half may have found another one. Those are counted.
//
// A slice's texel says where the particle that rests there is. The core is asked for the surface above that place, with
// the slice's shortest wave. No half filters fields: a texel of any slice reads them as they are where it rests, so
// that slices are held against fields as they are.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/host.h"
#include "gpu/vk/vk_submit.h"
#include "parity/everything_sea.h"
#include "seaway/gpu.h"
#include "support/scatter.h"

#define MOST_OFF_M 1e-3
#define MOST_TURNED 2e-3   // of unit normals
#define MOST_FOLDED 2e-3   // of Jacobians
#define MOST_SLOWER 2e-3   // m/s
#define MOST_LEFT_OUT 1e-3 // of all points
#define TEXEL 0.25         // m, of the finest slice
#define LEAST_JACOBIAN 0.1f
#define TOLERANCE 5e-5f // of searches, m
#define SLICES 5
#define RESOLUTION 64

static const swPosXZ places[2] = {{20.0, -30.0}, {1e5 + 17.3, -1e5 - 40.6}};
static const char* const placeNames[2] = {"here", "100 km away"};

static int failureCount;

static void Check(bool isFine, const char* what)
{
    if (!isFine)
    {
        printf("    FAILED: %s\n", what);
        failureCount += 1;
    }
}

static void Need(swResult result, const char* what)
{
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "%s: %s\n", what, swResult_GetText(result));
        exit(2);
    }
}

static void* Allocate(size_t count, size_t size)
{
    void* memory = calloc(count, size);
    if (memory == NULL)
    {
        fprintf(stderr, "no memory for %zu points\n", count);
        exit(2);
    }
    return memory;
}

// ---- what differs ----

typedef struct Worst
{
    double height, way, normal, jacobian, velocity;
    int count, leftOut, holes;
} Worst;

static double LengthOf(swVec3 a, swVec3 b)
{
    double x = (double)(a.x - b.x), y = (double)(a.y - b.y), z = (double)(a.z - b.z);
    return sqrt(x * x + y * y + z * z);
}

// The larger; NaN is the largest.
static double Larger(double most, double x)
{
    return x <= most ? most : x;
}

static void Print(const char* what, const Worst* w)
{
    printf("    %-14s height %.2g m, displacement %.2g m, normal %.2g, J %.2g, velocity %.2g m/s; %d of %d left out, "
           "%d in "
           "holes\n",
           what, w->height, w->way, w->normal, w->jacobian, w->velocity, w->leftOut, w->count, w->holes);
}

static void CheckWorst(const Worst* worst)
{
    Check(worst->height < MOST_OFF_M, "heights are more than a millimetre apart");
    Check(worst->way < 5.0 * MOST_OFF_M, "displacements are more than 5 mm apart");
    Check(worst->normal < MOST_TURNED, "normals differ");
    Check(worst->jacobian < MOST_FOLDED, "Jacobians differ");
    Check(worst->velocity < MOST_SLOWER, "velocities differ");
    Check(worst->leftOut <= MOST_LEFT_OUT * worst->count, "more than 0.1 % of the points had to be left out");
}

// ---- answers ----

// Of `count` points.
typedef struct Answers
{
    float *height, *residual, *jacobian;
    swVec3 *way, *normal, *velocity;
    bool* isClipped;
} Answers;

static Answers MakeAnswers(size_t count)
{
    return (Answers){
        .height = Allocate(count, sizeof(float)),
        .residual = Allocate(count, sizeof(float)),
        .jacobian = Allocate(count, sizeof(float)),
        .way = Allocate(count, sizeof(swVec3)),
        .normal = Allocate(count, sizeof(swVec3)),
        .velocity = Allocate(count, sizeof(swVec3)),
        .isClipped = Allocate(count, sizeof(bool)),
    };
}

static void FreeAnswers(Answers* answers)
{
    free(answers->height);
    free(answers->residual);
    free(answers->jacobian);
    free(answers->way);
    free(answers->normal);
    free(answers->velocity);
    free(answers->isClipped);
}

static swSurfaceSamples SamplesOf(const Answers* answers, size_t first)
{
    return (swSurfaceSamples){
        .height = answers->height + first,
        .residual = answers->residual + first,
        .jacobian = answers->jacobian + first,
        .displacement = answers->way + first,
        .normal = answers->normal + first,
        .velocity = answers->velocity + first,
        .isClipped = answers->isClipped + first,
    };
}

// ---- the core ----

typedef struct CoreJob
{
    const swMoment* moment;
    float minWavelength;
    const swPosXZ* points;
    const Answers* answers;
} CoreJob;

static void AskSome(void* context, int begin, int end, int worker)
{
    (void)worker;
    const CoreJob* job = context;
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = job->minWavelength;
    def.tolerance = TOLERANCE;
    swSurfaceSamples samples = SamplesOf(job->answers, (size_t)begin);
    swMoment_QuerySurface(job->moment, &def, end - begin, job->points + begin, &samples, NULL);
}

static void AskCore(const swHost* host, const swMoment* moment, float minWavelength, int count, const swPosXZ* points,
                    const Answers* answers)
{
    CoreJob job = {moment, minWavelength, points, answers};
    swParallelFor(host, AskSome, &job, count, 1024);
}

enum
{
    AROUND = 9
};

// A place and eight around it, a texel away.
static void PlaceAround(swPosXZ middle, swPosXZ* points)
{
    for (int i = 0; i < AROUND; ++i)
    {
        points[i] = (swPosXZ){middle.x + TEXEL * (i % 3 - 1), middle.z + TEXEL * (i / 3 - 1)};
    }
}

// Whether the level of still water jumps within a texel of a place.
static bool IsAtDam(const swMoment* moment, swPosXZ place)
{
    swPosXZ points[AROUND];
    float level[AROUND];
    PlaceAround(place, points);
    const swFieldSamples fields = {.level = level};
    swMoment_QueryFields(moment, AROUND, points, &fields);
    bool isAt = false;
    for (int i = 1; i < AROUND; ++i)
    {
        isAt = isAt || fabsf(level[i] - level[0]) > 0.5f;
    }
    return isAt;
}

// Whether the surface jumps within a texel of a point, as the core has it.
static bool DoesJump(const swMoment* moment, float minWavelength, swPosXZ point)
{
    swPosXZ points[AROUND];
    float jacobian[AROUND], residual[AROUND];
    bool isClipped[AROUND];
    PlaceAround(point, points);
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = minWavelength;
    def.tolerance = TOLERANCE;
    const swSurfaceSamples samples = {.jacobian = jacobian, .residual = residual, .isClipped = isClipped};
    swMoment_QuerySurface(moment, &def, AROUND, points, &samples, NULL);
    bool isNear = IsAtDam(moment, point);
    for (int i = 0; i < AROUND; ++i)
    {
        isNear = isNear || jacobian[i] < LEAST_JACOBIAN || residual[i] > TOLERANCE || isClipped[i] != isClipped[0];
    }
    return isNear;
}

// Whether a point where the halves differ may be left out. `way` is the displacement of the particle that one of them
// found: where a particle rests at a dam, the depth jumps that shapes its waves, and another one from the other side of
// the dam may be above the same point. No more points are looked at than are allowed.
static bool MayLeaveOut(const swMoment* moment, float minWavelength, swPosXZ point, swVec3 way, const Worst* worst)
{
    const swPosXZ rest = {point.x - (double)way.x, point.z - (double)way.z};
    return worst->leftOut <= MOST_LEFT_OUT * worst->count &&
           (DoesJump(moment, minWavelength, point) || IsAtDam(moment, rest));
}

// ---- a world on both halves ----

typedef struct Sides
{
    swHost host;
    swGpu* gpu;
    swWorld* world;
    swGpuWorld* gpuWorld;
    const swMoment* moment;
} Sides;

static void RecordFrame(Sides* sides, double dt)
{
    VkCommandBuffer commands;
    Need(swWorld_Step(sides->world, dt), "a step");
    Need(swBeginSubmit(sides->gpu, &commands), "a frame");
    static uint64_t frameIndex; // they grow over all worlds of a device
    frameIndex += 1;
    Need(swGpuWorld_Record(sides->gpuWorld, commands, frameIndex), "a frame");
    Need(swEndSubmit(sides->gpu), "a frame");
    swGpu_SetFinishedFrame(sides->gpu, frameIndex);
    sides->moment = swWorld_GetMoment(sides->world);
}

static Sides OpenSides(const swHost* host, swGpu* gpu, uint32_t features)
{
    Sides sides = {.host = *host, .gpu = gpu, .world = MakeEverything(host, features, 2, places)};
    Need(swCreateGpuWorld(gpu, sides.world, &sides.gpuWorld), "a world on the GPU");
    RecordFrame(&sides, 3456.7);
    return sides;
}

static void CloseSides(Sides* sides)
{
    swDestroyGpuWorld(sides->gpuWorld);
    swDestroyWorld(sides->world);
}

// ---- queries ----

#define BATCH 262144

static void AskGpu(Sides* sides, int count, const swPosXZ* points, const Answers* answers)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = count < BATCH ? count : BATCH;
    def.outputs = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | SW_GPU_QUERY_VELOCITY;
    def.tolerance = TOLERANCE;
    swGpuQuery* query = NULL;
    Need(swCreateGpuQuery(sides->gpuWorld, &def, &query), "a query");
    for (int first = 0; first < count; first += def.capacity)
    {
        int some = count - first < def.capacity ? count - first : def.capacity;
        swGpuQuery_SetPoints(query, some, points + first);
        RecordFrame(sides, 0.0);
        swGpuQueryResults results;
        if (!swGpuQuery_GetResults(query, &results) || results.count != some)
        {
            fprintf(stderr, "the GPU gave no answers\n");
            exit(2);
        }
        swSurfaceSamples samples = SamplesOf(answers, (size_t)first);
        swGpuQueryResults_Unpack(&results, &samples, NULL);
    }
    swDestroyGpuQuery(query);
}

static bool IsSame(const Answers* a, const Answers* b, int i)
{
    return fabsf(a->height[i] - b->height[i]) < (float)MOST_OFF_M &&
           LengthOf(a->way[i], b->way[i]) < 5.0 * MOST_OFF_M && a->isClipped[i] == b->isClipped[i];
}

static Worst CompareAnswers(Sides* sides, int count, const swPosXZ* points, const Answers* core, const Answers* gpu)
{
    Worst worst = {.count = count};
    for (int i = 0; i < count; ++i)
    {
        if (!IsSame(core, gpu, i) && MayLeaveOut(sides->moment, 0.0f, points[i], core->way[i], &worst))
        {
            worst.leftOut += 1;
            continue;
        }
        worst.height = Larger(worst.height, fabs((double)core->height[i] - (double)gpu->height[i]));
        worst.height = core->isClipped[i] == gpu->isClipped[i] ? worst.height : 1e30;
        worst.way = Larger(worst.way, LengthOf(core->way[i], gpu->way[i]));
        worst.normal = Larger(worst.normal, LengthOf(core->normal[i], gpu->normal[i]));
        worst.jacobian = Larger(worst.jacobian, fabs((double)core->jacobian[i] - (double)gpu->jacobian[i]));
        worst.velocity = Larger(worst.velocity, LengthOf(core->velocity[i], gpu->velocity[i]));
        worst.holes += core->isClipped[i] ? 1 : 0;
    }
    return worst;
}

static void CompareQueries(Sides* sides, int count)
{
    swPosXZ* points = Allocate((size_t)count, sizeof(swPosXZ));
    Answers core = MakeAnswers((size_t)count), gpu = MakeAnswers((size_t)count);
    for (int p = 0; p < 2; ++p)
    {
        ScatterPoints(points, count, places[p].x, places[p].z, 2.0 * FEATURE_REACH);
        AskGpu(sides, count, points, &gpu);
        AskCore(&sides->host, sides->moment, 0.0f, count, points, &core);
        Worst worst = CompareAnswers(sides, count, points, &core, &gpu);
        Print(placeNames[p], &worst);
        CheckWorst(&worst);
    }
    FreeAnswers(&core);
    FreeAnswers(&gpu);
    free(points);
}

// ---- slices ----

// Where the particles of a slice's texels are, and their heights.
static void PlaceTexels(const Sides* sides, const swSliceInfo* slice, const float* texels, swPosXZ* points,
                        Answers* answers)
{
    int count = slice->resolution * slice->resolution;
    for (int i = 0; i < count; ++i)
    {
        const float* d = texels + 4 * i;
        points[i].x = (double)(slice->firstX + i % slice->resolution) * slice->texel + (double)d[0];
        points[i].z = (double)(slice->firstZ + i / slice->resolution) * slice->texel + (double)d[2];
        answers->way[i] = (swVec3){d[0], d[1], d[2]};
    }
    const swFieldSamples fields = {.level = answers->height};
    swMoment_QueryFields(sides->moment, count, points, &fields);
    for (int i = 0; i < count; ++i)
    {
        answers->height[i] += texels[4 * i + 1];
    }
}

static Worst CompareSlice(Sides* sides, const swView* view, int index, float* texels)
{
    swSliceInfo slice = swView_GetSlice(view, index);
    int count = slice.resolution * slice.resolution;
    swPosXZ* points = Allocate((size_t)count, sizeof(swPosXZ));
    Answers core = MakeAnswers((size_t)count), drawn = MakeAnswers((size_t)count);
    Need(swGpuWorld_ReadLayer(sides->gpuWorld, view, SW_LAYER_DISPLACEMENT, index, texels), "a slice");
    PlaceTexels(sides, &slice, texels, points, &drawn);
    AskCore(&sides->host, sides->moment, slice.minWavelength, count, points, &core);
    Worst worst = {.count = count};
    for (int i = 0; i < count; ++i)
    {
        double height = fabs((double)core.height[i] - (double)drawn.height[i]);
        double way = LengthOf(core.way[i], drawn.way[i]);
        if (!(height < MOST_OFF_M && way < 5.0 * MOST_OFF_M) &&
            MayLeaveOut(sides->moment, slice.minWavelength, points[i], drawn.way[i], &worst))
        {
            worst.leftOut += 1;
            continue;
        }
        worst.height = Larger(worst.height, height);
        worst.way = Larger(worst.way, way);
    }
    FreeAnswers(&core);
    FreeAnswers(&drawn);
    free(points);
    return worst;
}

static void CompareSlices(Sides* sides, int resolution)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = SLICES;
    def.resolution = resolution;
    def.finestTexel = (float)TEXEL;
    for (int p = 0; p < 2; ++p)
    {
        swView* view = NULL;
        Need(swCreateView(sides->world, &def, &view), "a view");
        swView_SetViewpoint(view, (swPos){places[p].x, 2.0, places[p].z});
        RecordFrame(sides, 0.0);
        float* texels = Allocate((size_t)resolution * (size_t)resolution * 4, sizeof(float));
        Worst all = {0};
        for (int i = 0; i < SLICES; ++i)
        {
            Worst worst = CompareSlice(sides, view, i, texels);
            all.height = Larger(all.height, worst.height);
            all.way = Larger(all.way, worst.way);
            all.count += worst.count;
            all.leftOut += worst.leftOut;
        }
        printf("    slices %-7s height %.2g m, displacement %.2g m; %d of %d left out\n", p == 0 ? "here" : "away",
               all.height, all.way, all.leftOut, all.count);
        CheckWorst(&all);
        free(texels);
        swDestroyView(view);
    }
}

// ---- the program ----

static void CompareSea(const swHost* host, swGpu* gpu, const char* name, uint32_t features, int count, bool withSlices)
{
    printf("  %s\n", name);
    Sides sides = OpenSides(host, gpu, features);
    CompareQueries(&sides, count);
    if (withSlices)
    {
        CompareSlices(&sides, RESOLUTION);
    }
    CloseSides(&sides);
}

static swGpu* OpenGpu(const swHost* host)
{
    swGpuDef def = swDefaultGpuDef();
    def.enableValidation = true;
    def.layers = SW_LAYERS_GPU;
    swGpu* gpu = NULL;
    swResult result = swCreateGpu(host, &def, &gpu);
    if (result == SW_ERROR_UNSUPPORTED)
    {
        puts("the validation layers are not installed: this run checks numbers only");
        def.enableValidation = false;
        result = swCreateGpu(host, &def, &gpu);
    }
    Need(result, "a device");
    printf("device: %s\n", swGpu_GetDeviceName(gpu));
    return gpu;
}

int main(int argc, char** argv)
{
    int count = argc > 1 ? atoi(argv[1]) : 3000;
    const char* only = argc > 2 ? argv[2] : NULL;
    bool withSlices = argc <= 3 || strcmp(argv[3], "queries") != 0;
    if (count < 1)
    {
        fprintf(stderr, "parity_everything [POINTS [FEATURE [queries]]]\n");
        return 2;
    }
    swHost host = swDefaultHost();
    swTaskPool* pool = NULL;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int workers = processors < 2 ? 0 : processors > 32 ? 31 : (int)processors - 1;
    Need(swCreateTaskPool(&host, workers, &pool), "threads");
    swTaskPool_Attach(pool, &host);
    swGpu* gpu = OpenGpu(&host);
    int alone = count / 10 > 1000 ? count / 10 : count < 1000 ? count : 1000;
    for (int f = 0; f < FEATURE_COUNT; ++f)
    {
        const char* name = GetFeatureName((Feature)f);
        if (only == NULL || strcmp(only, name) == 0)
        {
            CompareSea(&host, gpu, name, 1u << f, alone, withSlices);
        }
    }
    if (only == NULL || strcmp(only, "all") == 0)
    {
        CompareSea(&host, gpu, "all at once", ALL_FEATURES, count, withSlices);
    }
    Check(swGpu_GetValidationCount(gpu) == 0, "the validation layers had messages");
    swDestroyGpu(gpu);
    swDestroyTaskPool(pool);
    printf("%s\n", failureCount == 0 ? "core and GPU agree" : "core and GPU do NOT agree");
    return failureCount == 0 ? 0 : 1;
}
