// SPDX-License-Identifier: MIT
// The water below as the GPU answers it is the core's: depth, orbital velocity, local acceleration and pressure, at
// every depth, in the air, in deep and shallow water, with either stretching. Both sum the same waves one by one.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>

// The bounds that gpu.h states. Measured: 0.01 mm, 0.03 mm/s, 0.6 mm/s^2 and 0.01 mm.
#define DEPTH_M 1e-4
#define VELOCITY_MPS 3e-4
#define ACCELERATION_MPS2 3e-3
#define HEAD_M 1e-4

#define MOST 3000

typedef struct Answers
{
    float depth[MOST], head[MOST];
    swVec3 velocity[MOST], acceleration[MOST];
} Answers;

static Answers gpuAnswers, cpuAnswers;
static swPos places[MOST];

static swVolumeSamples SamplesOf(Answers* answers)
{
    return (swVolumeSamples){.depth = answers->depth,
                             .velocity = answers->velocity,
                             .acceleration = answers->acceleration,
                             .pressureHead = answers->head};
}

// Over 2 km, from `deepest` to a little above where crests are.
static void ScatterPlaces(int count, swPosXZ around, double deepest)
{
    uint32_t seed = 4711;
    for (int i = 0; i < count; ++i)
    {
        double part[3];
        for (int axis = 0; axis < 3; ++axis)
        {
            seed = seed * 1664525u + 1013904223u;
            part[axis] = (double)(seed >> 8) * 0x1p-24;
        }
        double down = part[1] * part[1]; // more of them near the surface
        places[i] = (swPos){around.x + 2000.0 * (part[0] - 0.5), 3.0 + down * (deepest - 3.0),
                            around.z + 2000.0 * (part[2] - 0.5)};
    }
}

static swGpuQueryDef MakeDef(int capacity)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.kind = SW_GPU_QUERY_KIND_VOLUME;
    def.capacity = capacity;
    def.outputs = SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    def.tolerance = 1e-5f; // so small that residuals do not count
    return def;
}

static swGpuQuery* MakeQuery(Parity* parity, const swGpuQueryDef* def)
{
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, def, &query), SW_SUCCESS);
    return query;
}

static void FetchAnswers(Parity* parity, const swGpuQuery* query, int count)
{
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    assert_true(results.frameIndex == parity->gpu->frameIndex && results.count == count);
    swVolumeSamples samples = SamplesOf(&gpuAnswers);
    swGpuQueryResults_UnpackVolume(&results, &samples, NULL);
}

static double Worse(double worst, double error)
{
    return error <= worst ? worst : error; // NaN counts as worst
}

static double Length(swVec3 a, swVec3 b)
{
    double x = (double)a.x - (double)b.x, y = (double)a.y - (double)b.y, z = (double)a.z - (double)b.z;
    return sqrt(x * x + y * y + z * z);
}

static void CheckAnswers(Parity* parity, const swGpuQuery* query, const char* what, int count)
{
    FetchAnswers(parity, query, count);
    swQueryDef def = swDefaultQueryDef();
    def.tolerance = query->def.tolerance;
    def.minWavelength = query->def.minWavelength;
    def.stretching = query->def.stretching;
    swVolumeSamples samples = SamplesOf(&cpuAnswers);
    swMoment_QueryVolume(swWorld_GetMoment(parity->world), &def, count, places, &samples, NULL);
    double depth = 0.0, velocity = 0.0, acceleration = 0.0, head = 0.0;
    int dry = 0;
    for (int i = 0; i < count; ++i)
    {
        depth = Worse(depth, fabs((double)gpuAnswers.depth[i] - (double)cpuAnswers.depth[i]));
        bool isAtSurface = fabs((double)cpuAnswers.depth[i]) < DEPTH_M; // wet for one and dry for the other
        if (isAtSurface)
        {
            continue;
        }
        dry += cpuAnswers.depth[i] < 0.0f ? 1 : 0;
        velocity = Worse(velocity, Length(gpuAnswers.velocity[i], cpuAnswers.velocity[i]));
        acceleration = Worse(acceleration, Length(gpuAnswers.acceleration[i], cpuAnswers.acceleration[i]));
        head = Worse(head, fabs((double)gpuAnswers.head[i] - (double)cpuAnswers.head[i]));
    }
    printf("  %-34s depth %.2g m, velocity %.2g m/s, acceleration %.2g m/s^2, head %.2g m; %d of %d in the air\n", what,
           depth, velocity, acceleration, head, dry, count);
    assert_true(depth < DEPTH_M);
    assert_true(velocity < VELOCITY_MPS);
    assert_true(acceleration < ACCELERATION_MPS2);
    assert_true(head < HEAD_M);
}

static void CheckPlaces(Parity* parity, const swGpuQueryDef* def, const char* what, swPosXZ around, double deepest)
{
    swGpuQuery* query = MakeQuery(parity, def);
    ScatterPlaces(def->capacity, around, deepest);
    swGpuQuery_SetPlaces(query, def->capacity, places);
    StepParity(parity, 0.7);
    CheckAnswers(parity, query, what, def->capacity);
    swDestroyGpuQuery(query);
}

static void TheDeepMovesAsTheCoresDoes(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = MakeDef(1000);
    CheckPlaces(&parity, &def, "default sea", (swPosXZ){0.0, 0.0}, -60.0);
    CheckPlaces(&parity, &def, "1,000 km away", (swPosXZ){1e6, -1e6}, -60.0);
    CheckPlaces(&parity, &def, "at the surface", (swPosXZ){50.0, 50.0}, -1.0);
    def.stretching = SW_STRETCHING_LINEAR;
    CheckPlaces(&parity, &def, "without stretching", (swPosXZ){0.0, 0.0}, -60.0);
    def.minWavelength = 4.0f;
    CheckPlaces(&parity, &def, "waves of 4 m and more", (swPosXZ){0.0, 0.0}, -60.0);
    assert_int_equal(parity.gpuWorld->tiles.fields.count, 1); // no tiles of motion
    FreeParity(&parity);
}

static void ShallowWaterMovesAsTheCoresDoes(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.spectrum.depth = 8.0f;
    sea.minWavelength = 1.0f;
    sea.currentX = 1.0f;
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = MakeDef(1000);
    CheckPlaces(&parity, &def, "8 m of water", (swPosXZ){0.0, 0.0}, -8.0);
    CheckPlaces(&parity, &def, "and below its bottom", (swPosXZ){0.0, 0.0}, -12.0);
    def.stretching = SW_STRETCHING_LINEAR;
    CheckPlaces(&parity, &def, "8 m without stretching", (swPosXZ){0.0, 0.0}, -8.0);
    FreeParity(&parity);
}

static void AnySeaAndSeaLevelWillDo(void** state)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = 1.25;
    Parity parity = MakeParityOf(state, &worldDef);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = 2.0f;
    def.weight = 0.8f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity.world, &def, &id), SW_SUCCESS);
    const swWaveComponent components[] = {
        {180.0f, 0.3f, 0.5f, 0.2f}, {60.0f, -0.8f, 0.4f, 1.0f}, {9.0f, 2.0f, 0.08f, 2.0f}};
    swWaveSystemDef free = swDefaultWaveSystemDef();
    free.method = SW_WAVES_GERSTNER;
    free.components = components;
    free.componentCount = 3;
    AddParitySea(&parity, &free);
    free.spectrum.depth = 30.0f;
    AddParitySea(&parity, &free);
    swGpuQueryDef queryDef = MakeDef(1000);
    CheckPlaces(&parity, &queryDef, "tiles and 6 free waves", (swPosXZ){0.0, 0.0}, -25.0);
    def.spectrum.windSpeed = 18.0f;
    assert_int_equal(swWaveSystem_Set(parity.world, id, &def, 4.0), SW_SUCCESS);
    CheckPlaces(&parity, &queryDef, "a sea that changes", (swPosXZ){0.0, 0.0}, -25.0);
    def.seed = 99;
    assert_int_equal(swWaveSystem_Set(parity.world, id, &def, 4.0), SW_SUCCESS);
    CheckPlaces(&parity, &queryDef, "one that fades into another", (swPosXZ){0.0, 0.0}, -25.0);
    FreeParity(&parity);
}

static void AddLevel(Parity* parity, swInputShape shape, swPosXZ middle, float level)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_LEVEL;
    def.shape = shape;
    def.position = (swPos){middle.x, 0.0, middle.z};
    def.size = (swVec3){900.0f, 1.0f, 900.0f};
    def.feather = 200.0f;
    def.value[0] = level;
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, &def, &id), SW_SUCCESS);
}

// Still water 1.5 m higher everywhere, and a lake and a hollow in it.
static void LakesMoveAsTheCoresDo(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.spectrum.depth = 12.0f;
    sea.minWavelength = 1.0f;
    AddParitySea(&parity, &sea);
    AddLevel(&parity, SW_SHAPE_EVERYWHERE, (swPosXZ){0.0, 0.0}, 1.5f);
    AddLevel(&parity, SW_SHAPE_CIRCLE, (swPosXZ){-400.0, 300.0}, 4.0f);
    AddLevel(&parity, SW_SHAPE_CIRCLE, (swPosXZ){500.0, -200.0}, -6.0f);
    swGpuQueryDef def = MakeDef(1000);
    CheckPlaces(&parity, &def, "lakes", (swPosXZ){0.0, 0.0}, -10.0);
    def.stretching = SW_STRETCHING_LINEAR;
    CheckPlaces(&parity, &def, "lakes without stretching", (swPosXZ){0.0, 0.0}, -10.0);
    FreeParity(&parity);
}

static void WaterWithoutWavesIsStill(void** state)
{
    Parity parity = MakeParity(state);
    swGpuQueryDef def = MakeDef(100);
    CheckPlaces(&parity, &def, "no waves", (swPosXZ){0.0, 0.0}, -10.0);
    for (int i = 0; i < 100; ++i)
    {
        assert_true(gpuAnswers.velocity[i].x == 0.0f && gpuAnswers.head[i] == 0.0f);
        assert_float_equal(gpuAnswers.depth[i], -places[i].y, 1e-5);
    }
    FreeParity(&parity);
}

static void PlacesMayLieInABufferOfTheHosts(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 2.0f;
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = MakeDef(500);
    swGpuQuery* query = MakeQuery(&parity, &def);
    const swPosXZ origin = {2.5e5 + 0.125, -17.0};
    const VkDeviceSize offset = 268;
    swBuffer buffer;
    assert_int_equal(swCreateBuffer(parity.gpu, offset + 500 * sizeof(swVec3), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                    SW_MEMORY_UPLOAD, "places", &buffer),
                     SW_SUCCESS);
    ScatterPlaces(500, (swPosXZ){0.0, 0.0}, -30.0);
    float* floats = (float*)((uint8_t*)buffer.mapped + offset);
    for (int i = 0; i < 500; ++i)
    {
        const float place[3] = {(float)places[i].x, (float)places[i].y, (float)places[i].z};
        floats[3 * i] = place[0];
        floats[3 * i + 1] = place[1];
        floats[3 * i + 2] = place[2];
        places[i] = (swPos){origin.x + (double)place[0], (double)place[1], origin.z + (double)place[2]};
    }
    swGpuQuery_SetPointBuffer(query, 500, buffer.handle, offset, origin);
    StepParity(&parity, 0.7);
    CheckAnswers(&parity, query, "floats from an origin", 500);
    swDestroyGpuWorld(parity.gpuWorld);
    parity.gpuWorld = NULL;
    swDestroyBuffer(parity.gpu, &buffer);
    FreeParity(&parity);
}

static void QueriesOfBothKindsShareAFrame(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 4.0f;
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = MakeDef(200);
    swGpuQuery* below = MakeQuery(&parity, &def);
    def = swDefaultGpuQueryDef();
    def.outputs = SW_GPU_QUERY_VELOCITY;
    swGpuQuery* surface = MakeQuery(&parity, &def);
    ScatterPlaces(200, (swPosXZ){0.0, 0.0}, -20.0);
    swPosXZ points[200];
    for (int i = 0; i < 200; ++i)
    {
        points[i] = (swPosXZ){places[i].x, places[i].z};
    }
    swGpuQuery_SetPlaces(below, 200, places);
    swGpuQuery_SetPoints(surface, 200, points);
    for (int i = 0; i < 6; ++i) // more than slots
    {
        StepParity(&parity, 0.3);
        CheckAnswers(&parity, below, "beside a query of the surface", 200);
        swGpuQueryResults results;
        assert_true(swGpuQuery_GetResults(surface, &results));
        assert_true(results.depths == NULL && results.velocities != NULL);
        swGpuQueryResults deep;
        assert_true(swGpuQuery_GetResults(below, &deep));
        for (int p = 0; p < 200; ++p)
        {
            assert_float_equal(results.heights[p].height, deep.heights[p].height, 2e-3);
        }
    }
    size_t memory = swGpuWorld_GetMemory(parity.gpuWorld);
    swDestroyGpuQuery(below);
    StepParity(&parity, 0.3);
    assert_false(parity.gpuWorld->passes[SW_PASS_VOLUME_QUERY].isNeeded);
    assert_true(swGpuWorld_GetMemory(parity.gpuWorld) < memory);
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheDeepMovesAsTheCoresDoes),      cmocka_unit_test(ShallowWaterMovesAsTheCoresDoes),
        cmocka_unit_test(AnySeaAndSeaLevelWillDo),         cmocka_unit_test(WaterWithoutWavesIsStill),
        cmocka_unit_test(PlacesMayLieInABufferOfTheHosts), cmocka_unit_test(QueriesOfBothKindsShareAFrame),
        cmocka_unit_test(LakesMoveAsTheCoresDo),
    };
    return cmocka_run_group_tests_name("queries of the water below: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
