// SPDX-License-Identifier: MIT
// Times the GPU passes by timestamps, and says beside each what it cannot do without: bytes moved, operations,
// barriers. Medians over many frames, several in flight, so that the device keeps its clock. Measured on the same
// device in the same run: the bandwidth of a pass over a large buffer, and a chain of dispatches that do next to
// nothing, each with its barrier.
//
// Pass times come from frames with timestamps around each pass, which keep passes apart. Frame times come from frames
// with one pair around everything: that is what a host pays.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <seaway/seaway.h>
#include <seaway/stage.h>

#include "gpu/pass/passes.h"
#include "gpu/record/record.h"
#include "touch_shader.h"

#define SLOTS 4
#define MAX_PASSES 16
#define MOST_WARM_UP 32
#define CHAIN 64

typedef struct Options
{
    swDeviceChoice choice;
    int deviceIndex;
    int frames, slices, resolution, tileResolution, queryPoints;
    bool json;
} Options;

typedef struct Bench
{
    Options options;
    swStage* stage;
    swGpu* gpu; // of the stage
    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swPosXZ* points;
    swPos* places;
    swRay* rays;
    swGpuQuery* query; // while queries are measured
    bool isStill;      // the view stays where it is
    uint64_t stepCount;
    VkQueryPool queries; // two a slot
    bool hasTimes[SLOTS];
} Bench;

// Times of one thing over the frames, microseconds.
typedef struct Series
{
    const char* name;
    int count;
    double* values;
} Series;

typedef struct Floor
{
    double bytes, flops;
} Floor;

static void Fail(const char* what)
{
    fprintf(stderr, "seaway-bench-gpu: %s\n", what);
    exit(1);
}

static void Check(swResult result, const char* what)
{
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "seaway-bench-gpu: %s: %s\n", what, swResult_GetText(result));
        exit(1);
    }
}

static void CheckVk(VkResult result, const char* what)
{
    if (result != VK_SUCCESS)
    {
        Fail(what);
    }
}

static int CompareDoubles(const void* a, const void* b)
{
    double x = *(const double*)a, y = *(const double*)b;
    return x < y ? -1 : x > y ? 1 : 0;
}

static double Median(Series* series)
{
    if (series->count == 0)
    {
        return 0.0;
    }
    qsort(series->values, (size_t)series->count, sizeof(double), CompareDoubles);
    return series->values[series->count / 2];
}

static void AddValue(Series* series, int capacity, double value)
{
    if (series->values == NULL)
    {
        series->values = calloc((size_t)capacity, sizeof(double));
    }
    if (series->values != NULL && series->count < capacity)
    {
        series->values[series->count++] = value;
    }
}

// Set-up -------------------------------------------------------------------------------------------------------------

static void CreateTimestamps(Bench* bench)
{
    swGpu* gpu = bench->gpu;
    const VkQueryPoolCreateInfo queries = {
        .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
        .queryType = VK_QUERY_TYPE_TIMESTAMP,
        .queryCount = 2 * SLOTS,
    };
    CheckVk(gpu->vk.CreateQueryPool(gpu->device, &queries, NULL, &bench->queries), "no query pool");
}

static void CreateBench(Bench* bench)
{
    swHost host = swDefaultHost();
    swGpuDef gpuDef = swDefaultGpuDef();
    gpuDef.layers = SW_LAYERS_GPU; // it is the passes that are timed, whatever the device
    gpuDef.choice = bench->options.choice;
    gpuDef.deviceIndex = bench->options.deviceIndex;
    gpuDef.framesInFlight = SLOTS;
    Check(swCreateStage(&host, &gpuDef, &bench->stage), "no device");
    bench->gpu = swStage_GetGpu(bench->stage);
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = false;
    Check(swCreateWorld(&host, &worldDef, &bench->world), "no world");
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.resolution = bench->options.tileResolution;
    sea.tileWaves = sea.resolution / 4 < 32 ? sea.resolution / 4 : 32;
    swWaveSystemId id;
    Check(swCreateWaveSystem(bench->world, &sea, &id), "no waves");
    Check(swCreateGpuWorld(bench->gpu, bench->world, &bench->gpuWorld), "no GPU world");
    CreateTimestamps(bench);
}

static void DestroyBench(Bench* bench)
{
    swGpu* gpu = bench->gpu;
    Check(swStage_Wait(bench->stage), "waiting failed");
    gpu->vk.DestroyQueryPool(gpu->device, bench->queries, NULL);
    swDestroyGpuWorld(bench->gpuWorld);
    swDestroyStage(bench->stage);
    swDestroyView(bench->view);
    swDestroyWorld(bench->world);
}

// Frames -------------------------------------------------------------------------------------------------------------

// The time of a slot's last frame, which is done, from first to last timestamp.
static void ReadTimes(Bench* bench, uint32_t slot, Series* frames)
{
    swGpu* gpu = bench->gpu;
    uint64_t times[2];
    CheckVk(gpu->vk.GetQueryPoolResults(gpu->device, bench->queries, 2 * slot, 2, sizeof(times), times,
                                        sizeof(uint64_t), VK_QUERY_RESULT_64_BIT),
            "no timestamps");
    double period = (double)gpu->properties.limits.timestampPeriod * 1e-3;
    AddValue(frames, bench->options.frames, (double)(times[1] - times[0]) * period);
}

// Waits for a slot; `frames` gets the time of the frame that was in it.
static swStageFrame BeginFrame(Bench* bench, Series* frames)
{
    swGpu* gpu = bench->gpu;
    swStageFrame frame;
    Check(swStage_BeginFrame(bench->stage, &frame), "no command buffer");
    uint32_t slot = (uint32_t)(frame.index % SLOTS);
    if (bench->hasTimes[slot] && frames != NULL)
    {
        ReadTimes(bench, slot, frames);
    }
    bench->hasTimes[slot] = false;
    gpu->vk.CmdResetQueryPool(frame.commands, bench->queries, 2 * slot, 2);
    gpu->vk.CmdWriteTimestamp2(frame.commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, bench->queries, 2 * slot);
    return frame;
}

static void SubmitFrame(Bench* bench, const swStageFrame* frame)
{
    swGpu* gpu = bench->gpu;
    uint32_t slot = (uint32_t)(frame->index % SLOTS);
    gpu->vk.CmdWriteTimestamp2(frame->commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, bench->queries, 2 * slot + 1);
    Check(swStage_SubmitFrame(bench->stage, frame, NULL), "submitting failed");
    bench->hasTimes[slot] = true;
}

// Submit, wait, and take the time.
static void RunFrame(Bench* bench, const swStageFrame* frame, Series* times)
{
    uint32_t slot = (uint32_t)(frame->index % SLOTS);
    SubmitFrame(bench, frame);
    Check(swStage_Wait(bench->stage), "waiting failed");
    ReadTimes(bench, slot, times);
    bench->hasTimes[slot] = false;
}

static void AddPassTimes(Bench* bench, Series* passes)
{
    swPassTime times[MAX_PASSES];
    int count = swGpu_GetPassTimes(bench->gpu, times, MAX_PASSES);
    for (int i = 0; i < count; ++i)
    {
        passes[i].name = times[i].name;
        AddValue(&passes[i], bench->options.frames, (double)times[i].milliseconds * 1e3);
    }
}

static void SetQueryPoints(Bench* bench)
{
    if (bench->query->def.kind == SW_GPU_QUERY_KIND_RAYS)
    {
        swGpuQuery_SetRays(bench->query, bench->options.queryPoints, bench->rays);
    }
    else if (bench->query->def.kind == SW_GPU_QUERY_KIND_VOLUME)
    {
        swGpuQuery_SetPlaces(bench->query, bench->options.queryPoints, bench->places);
    }
    else
    {
        swGpuQuery_SetPoints(bench->query, bench->options.queryPoints, bench->points);
    }
}

// The warm-up's frames are not counted. `passes` NULL: no timestamps inside a frame.
static void RunFrames(Bench* bench, Series* passes, Series* frame)
{
    bench->gpu->timer.isEnabled = passes != NULL;
    bench->gpu->timer.resultCount = 0;
    int warmUp = bench->options.frames < MOST_WARM_UP ? bench->options.frames : MOST_WARM_UP;
    for (int i = 0; i < warmUp + bench->options.frames; ++i)
    {
        if (bench->view != NULL && !bench->isStill) // 10 m/s, so that foam scrolls
        {
            double x = (double)bench->stepCount / 6.0;
            swView_SetViewpoint(bench->view, (swPos){x, 2.0, 0.3 * x});
        }
        Check(swWorld_Step(bench->world, 1.0 / 60.0), "a step failed");
        if (bench->query != NULL)
        {
            SetQueryPoints(bench);
        }
        bool isCounted = i >= warmUp;
        swStageFrame recorded = BeginFrame(bench, isCounted ? frame : NULL);
        Check(swGpuWorld_Record(bench->gpuWorld, recorded.commands, recorded.index), "recording failed");
        SubmitFrame(bench, &recorded);
        if (passes != NULL && isCounted)
        {
            AddPassTimes(bench, passes);
        }
        bench->stepCount += 1;
    }
    Check(swStage_Wait(bench->stage), "waiting failed");
    memset(bench->hasTimes, 0, sizeof(bench->hasTimes));
}

// What the device can do ---------------------------------------------------------------------------------------------

static void CreateTouch(Bench* bench, VkDeviceSize bytes, swPipeline* pipeline, swBuffer* words)
{
    Check(swCreateComputePipeline(bench->gpu, &swTouchShader, NULL, pipeline), "no pipeline");
    Check(swCreateBuffer(bench->gpu, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_DEVICE, "words", words),
          "no buffer");
}

// A thread of touch.comp moves 16 bytes, a workgroup has 256.
#define TOUCH_BYTES (256 * 16)

// Bytes per microsecond, read and written, of a shader that adds one to every word of a large buffer: best of ten.
static double MeasureBandwidth(Bench* bench)
{
    swGpu* gpu = bench->gpu;
    const uint32_t columns = 4096, rows = swGpu_IsSoftware(gpu) ? 1 : 64;
    VkDeviceSize bytes = (VkDeviceSize)columns * rows * TOUCH_BYTES;
    swPipeline pipeline;
    swBuffer words;
    CreateTouch(bench, bytes, &pipeline, &words);
    const swTouchBindings bindings = {.words = swBindBuffer(&words)};
    Series times = {0};
    for (int i = 0; i < 10; ++i)
    {
        swStageFrame frame = BeginFrame(bench, NULL);
        swBindTouch(gpu, frame.commands, &pipeline, &bindings);
        gpu->vk.CmdDispatch(frame.commands, columns, rows, 1);
        RunFrame(bench, &frame, &times);
    }
    Median(&times);
    double best = times.values[0];
    free(times.values);
    swDestroyPipeline(gpu, &pipeline);
    swDestroyBuffer(gpu, &words);
    return 2.0 * (double)bytes / best;
}

// Microseconds of one small dispatch and its barrier in a long chain.
static double MeasureBarrier(Bench* bench)
{
    swGpu* gpu = bench->gpu;
    swPipeline pipeline;
    swBuffer words;
    CreateTouch(bench, 16 * TOUCH_BYTES, &pipeline, &words);
    const swTouchBindings bindings = {.words = swBindBuffer(&words)};
    Series times = {0};
    for (int i = 0; i < 20; ++i)
    {
        swStageFrame frame = BeginFrame(bench, NULL);
        swBindTouch(gpu, frame.commands, &pipeline, &bindings);
        for (int link = 0; link < CHAIN; ++link)
        {
            gpu->vk.CmdDispatch(frame.commands, 16, 1, 1);
            swComputeBarrier(gpu, frame.commands);
        }
        RunFrame(bench, &frame, &times);
    }
    double median = Median(&times);
    free(times.values);
    swDestroyPipeline(gpu, &pipeline);
    swDestroyBuffer(gpu, &words);
    return median / CHAIN;
}

// Floors -------------------------------------------------------------------------------------------------------------

// Least bytes through memory and operations (a multiply and an add count as two) of a pass.
static Floor WavesFloor(const swFrame* frame, bool isRows)
{
    Floor least = {0};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        double n = tile->resolution;
        double lines = 3.0 * (tile->maxBin + 1);
        double fft = 5.0 * n * log2(n);
        least.bytes += lines * n * 8.0;
        least.bytes += isRows ? tile->modeCount * (double)sizeof(swMode) : n * (n + 3.0) * 16.0;
        least.flops += isRows ? lines * fft + 60.0 * tile->modeCount : 1.5 * n * fft;
    }
    return least;
}

static Floor DetailFloor(const Bench* bench, const swFrame* frame)
{
    Floor least = {0};
    double texels = pow((double)swGetDetailImage(bench->gpuWorld)->width, 2.0);
    for (int i = 0; i < frame->tileCount; ++i)
    {
        double n = frame->tiles[i].resolution;
        least.bytes += n * (n + 3.0) * 16.0 + texels * 8.0 * 4.0 / 3.0;
        least.flops += texels * 110.0;
    }
    return least;
}

// Where a tile is smooth, a column of texels adds four weighted cubics of six numbers to its own, 96 multiply-adds;
// each texel then evaluates three values, their slopes along x and z. Where it is not, more.
static Floor SlicesFloor(const swFrame* frame)
{
    const swViewFrame* view = &frame->views[0];
    Floor least = {0};
    double texels = (double)view->stack.resolution * view->stack.resolution;
    for (int s = 0; s < view->stack.sliceCount; ++s)
    {
        least.bytes += texels * 24.0;
        least.flops += texels * 2.0 * 27.0;
        for (int i = 0; i < frame->tileCount; ++i)
        {
            bool isCarried = frame->tiles[i].minWavelength >= view->stack.slices[s].minWavelength;
            least.flops += isCarried ? texels * 2.0 * 96.0 / SW_SLICE_HEIGHT : 0.0;
        }
    }
    for (int i = 0; i < frame->tileCount; ++i)
    {
        double n = frame->tiles[i].resolution;
        least.bytes += n * (n + 3.0) * 16.0;
    }
    return least;
}

static Floor FoamFloor(const swFrame* frame)
{
    const swViewFrame* view = &frame->views[0];
    double texels = (double)view->stack.resolution * view->stack.resolution * view->stack.sliceCount;
    return (Floor){.bytes = texels * (16.0 + 4.0 + 4.0), .flops = texels * 40.0};
}

static Floor FloorOf(const Bench* bench, const char* pass)
{
    const swFrame* frame = swGetWorldFrame(bench->world);
    if (strcmp(pass, "waves_rows") == 0 || strcmp(pass, "waves_columns") == 0)
    {
        return WavesFloor(frame, strcmp(pass, "waves_rows") == 0);
    }
    return strcmp(pass, "detail") == 0   ? DetailFloor(bench, frame)
           : strcmp(pass, "slices") == 0 ? SlicesFloor(frame)
                                         : FoamFloor(frame);
}

// Queries ------------------------------------------------------------------------------------------------------------

// Points that other points are near, and points that are not.
typedef struct QueryCase
{
    const char* name;
    double side; // m, of the square that they are scattered over; below 0: a grid of points so far apart
    uint32_t outputs;
    bool readBack;
    swGpuQueryKind kind;
    double first, last; // heights of places and rays, m
} QueryCase;

#define SURFACE SW_GPU_QUERY_KIND_SURFACE, 0.0, 0.0
#define NORMAL SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL
#define MOTION SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION
static const QueryCase queryCases[] = {
    {"heights, scattered over 10 km", 1e4, 0, true, SURFACE},
    {"heights, scattered over 1 km", 1e3, 0, true, SURFACE},
    {"heights, a grid of 0.5 m", -0.5, 0, true, SURFACE},
    {"with normals, scattered over 10 km", 1e4, NORMAL, true, SURFACE},
    {"with normals, on the GPU", 1e4, NORMAL, false, SURFACE},
    {"with velocity, on the GPU", 1e4, SW_GPU_QUERY_VELOCITY, false, SURFACE},
    {"with acceleration too, on the GPU", 1e4, MOTION, false, SURFACE},
    {"the water below, 0 to 20 m, on the GPU", 1e4, MOTION, false, SW_GPU_QUERY_KIND_VOLUME, 0.0, -20.0},
    {"the water 5 m below, on the GPU", 1e4, MOTION, false, SW_GPU_QUERY_KIND_VOLUME, -5.0, -5.0},
    {"rays, 45 degrees down from 20 m", 1e4, SW_GPU_QUERY_NORMAL, false, SW_GPU_QUERY_KIND_RAYS, 20.0, 20.0},
};
#define QUERY_CASES (int)(sizeof(queryCases) / sizeof(queryCases[0]))

typedef struct QueryTimes
{
    double pass;  // us, between timestamps around the dispatches of the query
    double frame; // us that a frame without a view takes longer: the pass, tiles of motion, copies and barriers
} QueryTimes;

static void PlacePoints(Bench* bench, const QueryCase* what)
{
    int count = bench->options.queryPoints;
    int columns = (int)ceil(sqrt((double)count));
    uint32_t seed = 12345;
    for (int i = 0; i < count; ++i)
    {
        double place[2] = {-what->side * (i % columns), -what->side * (i / columns)};
        for (int axis = 0; axis < 2 && what->side > 0.0; ++axis)
        {
            seed = seed * 1664525u + 1013904223u;
            place[axis] = what->side * ((double)(seed >> 8) * 0x1p-24 - 0.5);
        }
        bench->points[i] = (swPosXZ){place[0], place[1]};
        bench->places[i] = (swPos){place[0], what->first + (what->last - what->first) * i / count, place[1]};
        double angle = 2.399963 * i; // any direction
        bench->rays[i] = swDefaultRay(bench->places[i], (swVec3){(float)cos(angle), -1.0f, (float)sin(angle)});
    }
}

static QueryTimes MeasureQuery(Bench* bench, const QueryCase* what, double frameWithout)
{
    PlacePoints(bench, what);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = bench->options.queryPoints;
    def.kind = what->kind;
    def.outputs = what->outputs;
    def.readBack = what->readBack;
    Check(swCreateGpuQuery(bench->gpuWorld, &def, &bench->query), "no query");
    Series frame = {0};
    Series passes[MAX_PASSES] = {0};
    RunFrames(bench, NULL, &frame);
    RunFrames(bench, passes, NULL);
    QueryTimes times = {.frame = Median(&frame) - frameWithout};
    for (int i = 0; i < MAX_PASSES; ++i)
    {
        if (passes[i].name != NULL &&
            (strstr(passes[i].name, "query") != NULL || strstr(passes[i].name, "volume") != NULL))
        {
            times.pass += Median(&passes[i]);
        }
        free(passes[i].values);
    }
    free(frame.values);
    swDestroyGpuQuery(bench->query);
    bench->query = NULL;
    return times;
}

// Of one evaluation of a point: 16 texels of 16 bytes a tile, which hardly any memory but caches serve, and 135
// multiply-adds. A point needs two evaluations at least; the first guess is a part of one.
static Floor QueryFloor(const Bench* bench, double evaluations)
{
    double tiles = swGetWorldFrame(bench->world)->tileCount;
    double sum = evaluations * bench->options.queryPoints * tiles;
    return (Floor){.bytes = sum * 256.0, .flops = sum * 270.0};
}

// Of the water below at its surface, where every pair of waves counts: some 50 operations each.
static double VolumeFlops(const Bench* bench)
{
    const swFrame* frame = swGetWorldFrame(bench->world);
    double pairs = 0.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        pairs += frame->tiles[i].modeCount;
    }
    return 50.0 * pairs * bench->options.queryPoints;
}

static void MeasureQueries(Bench* bench, double frameWithout, QueryTimes* times)
{
    bench->points = malloc(sizeof(swPosXZ) * (size_t)bench->options.queryPoints);
    bench->places = malloc(sizeof(swPos) * (size_t)bench->options.queryPoints);
    bench->rays = malloc(sizeof(swRay) * (size_t)bench->options.queryPoints);
    if (bench->points == NULL || bench->places == NULL || bench->rays == NULL)
    {
        Fail("no memory for points");
    }
    for (int i = 0; i < QUERY_CASES; ++i)
    {
        times[i] = MeasureQuery(bench, &queryCases[i], frameWithout);
    }
    free(bench->points);
    free(bench->places);
    free(bench->rays);
}

// Authored fields ----------------------------------------------------------------------------------------------------

// Water over a floor in a part of the view, all slices alike: a wedge from the viewer on.
typedef struct PlaceCase
{
    const char* name;
    double wedge; // degrees; 0: the floor is far away, 360: everywhere
    float depth;  // m; 0: a beach, which rises from 8 m deep by one in fifty
    bool isFull;  // with a second wave system, a lake at another level, foam that inputs make, and holes
    bool flows;   // and with a stream
} PlaceCase;

#define NO_FLOOR (-1.0)
static const PlaceCase placeCases[] = {
    {"a floor, but far away", 0.0, 5.0f, false, false},
    {"5 m under a third of each slice", 120.0, 5.0f, false, false},
    {"5 m under all", 360.0, 5.0f, false, false},
    {"20 m under all", 360.0, 20.0f, false, false},
    {"two systems, nothing authored but a level", NO_FLOOR, 5.0f, true, false},
    {"two systems, all fields, 5 m under a third", 120.0, 5.0f, true, false},
    {"two systems, all fields, 5 m under all", 360.0, 5.0f, true, false},
    {"two systems, all fields, a beach", 360.0, 0.0f, true, false},
    {"the same and a stream, 5 m under a third", 120.0, 5.0f, true, true},
    {"the same and a stream, a beach", 360.0, 0.0f, true, true},
};
#define PLACE_CASES (int)(sizeof(placeCases) / sizeof(placeCases[0]))

// Passes that inputs lengthen, and the rest.
static const char* const placePasses[] = {"fields", "slices_shaped", "slices", "foam", "made_foam"};
#define PLACE_PASSES (int)(sizeof(placePasses) / sizeof(placePasses[0]))

typedef struct PlaceTimes
{
    double passes[PLACE_PASSES]; // us
    double frame, moving;        // whole frames, the view standing still and scrolling
} PlaceTimes;

static void AddInput(Bench* bench, const swInputDef* def)
{
    swInputId id;
    Check(swCreateInput(bench->world, def, &id), "no input");
}

static swInputDef InputHere(const Bench* bench, swInputField field, swInputShape shape, float size, float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = swView_GetViewpoint(bench->view);
    def.position.y = 0.0;
    def.size = (swVec3){size, 4.0f, size};
    def.value[0] = value;
    return def;
}

// Land on one side of the viewer, and a floor of 8 m from 300 m on at the other.
static void AddBeach(Bench* bench)
{
    const float far = 3e4f;
    const float across[] = {-far, -200.0f, 300.0f, far}, heights[] = {2.0f, 2.0f, -8.0f, -8.0f};
    swVec3 vertices[8];
    uint32_t faces[6][3];
    for (uint32_t i = 0; i < 8; ++i)
    {
        vertices[i] = (swVec3){across[i / 2], heights[i / 2], i % 2 == 0 ? -far : far};
    }
    for (uint32_t i = 0; i < 6; ++i)
    {
        memcpy(faces[i], (uint32_t[3]){i, i + 1, i + 2}, sizeof(faces[i]));
    }
    swHost host = swDefaultHost();
    swMeshDef meshDef = swDefaultMeshDef();
    meshDef.vertices = vertices;
    meshDef.vertexCount = 8;
    meshDef.indices = faces[0];
    meshDef.triangleCount = 6;
    swMesh* mesh = NULL;
    Check(swCreateMesh(&host, &meshDef, &mesh), "no mesh");
    swInputDef def = InputHere(bench, SW_INPUT_FLOOR, SW_SHAPE_MESH, 1.0f, 0.0f);
    def.mesh = mesh;
    AddInput(bench, &def);
    swDestroyMesh(mesh);
}

static void AddFloor(Bench* bench, const PlaceCase* what)
{
    const double far = 3e4;
    swInputDef def = InputHere(bench, SW_INPUT_FLOOR, SW_SHAPE_EVERYWHERE, 1.0f, -what->depth);
    def.feather = 5.0f;
    const double half = what->wedge * SW_PI / 360.0;
    const swInputPoint corners[] = {{.x = 0.0, .z = 0.0},
                                    {.x = far * cos(half), .z = -far * sin(half)},
                                    {.x = 2.0 * far, .z = 0.0},
                                    {.x = far * cos(half), .z = far * sin(half)}};
    if (what->wedge == 0.0)
    {
        def.shape = SW_SHAPE_CIRCLE;
        def.position.x += 5e5;
    }
    else if (what->wedge < 360.0)
    {
        def.shape = SW_SHAPE_POLYGON;
        def.points = corners;
        def.pointCount = 4;
    }
    AddInput(bench, &def);
}

static void AddFields(Bench* bench, bool flows)
{
    swInputDef def = InputHere(bench, SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 200.0f, 0.5f);
    def.feather = 50.0f;
    AddInput(bench, &def);
    def = InputHere(bench, SW_INPUT_FOAM, SW_SHAPE_CIRCLE, 100.0f, 1.0f);
    def.feather = 20.0f;
    AddInput(bench, &def);
    def = InputHere(bench, SW_INPUT_CLIP, SW_SHAPE_BOX, 20.0f, 1.0f);
    AddInput(bench, &def);
    if (flows)
    {
        def = InputHere(bench, SW_INPUT_FLOW, SW_SHAPE_CIRCLE, 200.0f, 1.0f);
        def.feather = 50.0f;
        AddInput(bench, &def);
    }
}

static double MedianOf(Series* passes, const char* name)
{
    double median = 0.0;
    for (int i = 0; i < MAX_PASSES; ++i)
    {
        median = passes[i].name != NULL && strcmp(passes[i].name, name) == 0 ? Median(&passes[i]) : median;
    }
    return median;
}

static PlaceTimes MeasurePlace(Bench* bench)
{
    Series passes[MAX_PASSES] = {0}, frame = {0}, moving = {0};
    bench->isStill = true;
    RunFrames(bench, NULL, &frame);
    RunFrames(bench, passes, NULL);
    bench->isStill = false;
    RunFrames(bench, NULL, &moving);
    PlaceTimes times = {.frame = Median(&frame), .moving = Median(&moving)};
    for (int i = 0; i < PLACE_PASSES; ++i)
    {
        times.passes[i] = MedianOf(passes, placePasses[i]);
    }
    for (int i = 0; i < MAX_PASSES; ++i)
    {
        free(passes[i].values);
    }
    free(frame.values);
    free(moving.values);
    return times;
}

static void MeasurePlaces(Bench* bench, PlaceTimes* times)
{
    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.seed = 2;
    swell.spectrum.direction = 1.2f;
    for (int c = 0; c < PLACE_CASES; ++c)
    {
        const PlaceCase* what = &placeCases[c];
        swWaveSystemId second = {0, 0};
        if (what->depth == 0.0f)
        {
            AddBeach(bench);
        }
        else if (what->wedge != NO_FLOOR)
        {
            AddFloor(bench, what);
        }
        if (what->isFull)
        {
            Check(swCreateWaveSystem(bench->world, &swell, &second), "no second system");
            AddFields(bench, what->flows);
        }
        times[c] = MeasurePlace(bench);
        while (swWorld_GetInputCount(bench->world) > 0)
        {
            swDestroyInput(bench->world, swWorld_GetInput(bench->world, 0));
        }
        if (what->isFull)
        {
            swDestroyWaveSystem(bench->world, second);
        }
    }
}

// Report -------------------------------------------------------------------------------------------------------------

typedef struct Report
{
    double bandwidth; // bytes a microsecond
    double barrier;   // microseconds
    double waves;     // frame without a view: rows, columns, detail
    double frame;     // frame with the view
    Series passes[MAX_PASSES];
    PlaceTimes places[PLACE_CASES];
    QueryTimes queries[QUERY_CASES];
} Report;

static void PrintTable(const Bench* bench, Report* report)
{
    const swFrame* frame = swGetWorldFrame(bench->world);
    printf("%s\n%d tiles, N = %d; %d slices of %d^2; median of %d frames\n", swGpu_GetDeviceName(bench->gpu),
           frame->tileCount, bench->options.tileResolution, bench->options.slices, bench->options.resolution,
           bench->options.frames);
    printf("memory gives %.0f GB/s; a small dispatch and its barrier take %.2f us\n\n", report->bandwidth * 1e-3,
           report->barrier);
    printf("%-16s %10s %10s %10s %12s %10s\n", "pass", "us", "MB least", "us in mem", "Mflop least", "Gflop/s");
    double sum = 0.0;
    for (int i = 0; i < MAX_PASSES && report->passes[i].name != NULL; ++i)
    {
        double time = Median(&report->passes[i]);
        Floor least = FloorOf(bench, report->passes[i].name);
        printf("%-16s %10.2f %10.2f %10.2f %12.1f %10.0f\n", report->passes[i].name, time, least.bytes * 1e-6,
               least.bytes / report->bandwidth, least.flops * 1e-6, least.flops * 1e-3 / time);
        sum += time;
    }
    printf("%-16s %10.2f\n\n", "sum", sum);
    printf("frame without a view (rows, columns, detail; 4 barriers): %.2f us\n", report->waves);
    printf("whole frame (5 passes, 5 barriers, no timestamps inside):  %.2f us\n", report->frame);
    printf("\n%-44s", "where inputs shape waves, us");
    for (int i = 0; i < PLACE_PASSES; ++i)
    {
        printf(" %13s", placePasses[i]);
    }
    printf(" %13s %13s\n", "whole frame", "moving");
    for (int i = 0; i < PLACE_CASES; ++i)
    {
        const PlaceTimes* times = &report->places[i];
        printf("%-44s", placeCases[i].name);
        for (int p = 0; p < PLACE_PASSES; ++p)
        {
            printf(" %13.2f", times->passes[p]);
        }
        printf(" %13.2f %13.2f\n", times->frame, times->moving);
    }
    if (bench->options.queryPoints > 0)
    {
        Floor least = QueryFloor(bench, 2.0);
        printf(
            "\nqueries of %d points; two evaluations a point read %.0f MB of texels (%.0f us were they memory's) and "
            "take %.0f Mflop;\nall waves one by one, at the top of the water, take %.1f Gflop\n%-40s %10s %14s\n",
            bench->options.queryPoints, least.bytes * 1e-6, least.bytes / report->bandwidth, least.flops * 1e-6,
            VolumeFlops(bench) * 1e-9, "", "pass us", "more frame us");
    }
    for (int i = 0; i < QUERY_CASES && bench->options.queryPoints > 0; ++i)
    {
        printf("%-40s %10.2f %14.2f\n", queryCases[i].name, report->queries[i].pass, report->queries[i].frame);
    }
}

static void PrintJson(const Bench* bench, Report* report)
{
    const swFrame* frame = swGetWorldFrame(bench->world);
    printf("{\"device\": \"%s\", \"tiles\": %d, \"tile_resolution\": %d, \"slices\": %d, \"slice_resolution\": %d, "
           "\"frames\": %d,\n \"memory_gb_per_s\": %.1f, \"barrier_us\": %.3f, \"waves_frame_us\": %.3f, "
           "\"waves_frame_barriers\": 4, \"frame_us\": %.3f, \"frame_barriers\": 5,\n \"passes\": [",
           swGpu_GetDeviceName(bench->gpu), frame->tileCount, bench->options.tileResolution, bench->options.slices,
           bench->options.resolution, bench->options.frames, report->bandwidth * 1e-3, report->barrier, report->waves,
           report->frame);
    for (int i = 0; i < MAX_PASSES && report->passes[i].name != NULL; ++i)
    {
        double time = Median(&report->passes[i]);
        Floor least = FloorOf(bench, report->passes[i].name);
        printf("%s\n  {\"name\": \"%s\", \"time_us\": %.3f, \"least_bytes\": %.0f, \"bytes_floor_us\": %.3f, "
               "\"least_flops\": %.0f, \"barriers\": 1}",
               i > 0 ? "," : "", report->passes[i].name, time, least.bytes, least.bytes / report->bandwidth,
               least.flops);
    }
    printf("],\n \"places\": [");
    for (int i = 0; i < PLACE_CASES; ++i)
    {
        const PlaceTimes* times = &report->places[i];
        printf("%s\n  {\"name\": \"%s\", ", i > 0 ? "," : "", placeCases[i].name);
        for (int p = 0; p < PLACE_PASSES; ++p)
        {
            printf("\"%s_us\": %.3f, ", placePasses[p], times->passes[p]);
        }
        printf("\"frame_us\": %.3f, \"moving_frame_us\": %.3f}", times->frame, times->moving);
    }
    printf("],\n \"query_points\": %d, \"queries\": [", bench->options.queryPoints);
    for (int i = 0; i < QUERY_CASES && bench->options.queryPoints > 0; ++i)
    {
        printf("%s\n  {\"name\": \"%s\", \"time_us\": %.3f, \"more_frame_us\": %.3f}", i > 0 ? "," : "",
               queryCases[i].name, report->queries[i].pass, report->queries[i].frame);
    }
    printf("]}\n");
}

// Command line -------------------------------------------------------------------------------------------------------

static void PrintUsage(void)
{
    puts("seaway-bench-gpu [--device auto|gpu|software|INDEX] [--frames N] [--slices N] [--resolution N]\n"
         "                 [--tile-resolution N] [--query-points N] [--json]\n"
         "Frames are 300 unless given, points 100000; 5 and 1000 on a software device.\n"
         "Times each GPU pass of a default sea and queries of its surface, beside the bytes, operations and barriers "
         "that it needs at least.");
}

static int ParseNumber(const char* text, const char* option)
{
    char* end = NULL;
    long value = text != NULL ? strtol(text, &end, 10) : 0;
    if (text == NULL || end == text || *end != '\0' || value < 0 || value > 1000000)
    {
        fprintf(stderr, "seaway-bench-gpu: %s wants a number\n", option);
        exit(2);
    }
    return (int)value;
}

static void ParseDevice(const char* text, Options* options)
{
    if (text == NULL || !swParseStageDevice(text, &options->choice, &options->deviceIndex))
    {
        fprintf(stderr, "seaway-bench-gpu: --device wants auto, gpu, software or a number\n");
        exit(2);
    }
}

static Options ParseOptions(int argc, char** argv)
{
    Options options = {.frames = -1, .slices = 7, .resolution = 384, .tileResolution = 128, .queryPoints = -1};
    for (int i = 1; i < argc; ++i)
    {
        const char* value = i + 1 < argc ? argv[i + 1] : NULL;
        const struct
        {
            const char* name;
            int* number;
        } numbers[] = {{"--frames", &options.frames},
                       {"--slices", &options.slices},
                       {"--resolution", &options.resolution},
                       {"--tile-resolution", &options.tileResolution},
                       {"--query-points", &options.queryPoints}};
        bool isKnown = false;
        for (size_t n = 0; n < sizeof(numbers) / sizeof(numbers[0]) && !isKnown; ++n)
        {
            if (strcmp(argv[i], numbers[n].name) == 0)
            {
                *numbers[n].number = ParseNumber(value, argv[i]);
                isKnown = true;
                i += 1;
            }
        }
        if (!isKnown && strcmp(argv[i], "--device") == 0)
        {
            ParseDevice(value, &options);
            i += 1;
        }
        else if (!isKnown && strcmp(argv[i], "--json") == 0)
        {
            options.json = true;
        }
        else if (!isKnown)
        {
            bool isHelp = strcmp(argv[i], "--help") == 0;
            PrintUsage();
            exit(isHelp ? 0 : 2);
        }
    }
    return options;
}

// A software device takes seconds for what a GPU does in a moment.
static void ChooseCounts(Bench* bench)
{
    Options* options = &bench->options;
    bool isSoftware = swGpu_IsSoftware(bench->gpu);
    options->frames = options->frames < 0 ? (isSoftware ? 5 : 300) : options->frames > 0 ? options->frames : 1;
    options->queryPoints = options->queryPoints < 0 ? (isSoftware ? 1000 : 100000) : options->queryPoints;
}

int main(int argc, char** argv)
{
    Bench bench = {.options = ParseOptions(argc, argv)};
    CreateBench(&bench);
    ChooseCounts(&bench);
    Report report = {0};
    report.bandwidth = MeasureBandwidth(&bench);
    report.barrier = MeasureBarrier(&bench);

    Series waves = {0}, frame = {0};
    RunFrames(&bench, NULL, &waves);
    report.waves = Median(&waves);
    if (bench.options.queryPoints > 0)
    {
        MeasureQueries(&bench, report.waves, report.queries);
    }
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = bench.options.slices;
    viewDef.resolution = bench.options.resolution;
    Check(swCreateView(bench.world, &viewDef, &bench.view), "no view");
    RunFrames(&bench, NULL, &frame);
    RunFrames(&bench, report.passes, NULL);
    report.frame = Median(&frame);
    MeasurePlaces(&bench, report.places);

    if (bench.options.json)
    {
        PrintJson(&bench, &report);
    }
    else
    {
        PrintTable(&bench, &report);
    }
    for (int i = 0; i < MAX_PASSES; ++i)
    {
        free(report.passes[i].values);
    }
    free(waves.values);
    free(frame.values);
    DestroyBench(&bench);
    return 0;
}
