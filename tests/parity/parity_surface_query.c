// SPDX-License-Identifier: MIT
// Queries on the GPU give the core's answers. Two things are held against the core for every point: the particle that
// the GPU names is where it says (asked of the core at that particle's rest, no search), and its height is that of the
// core's own search. The second may differ in a fold, where several particles are above a point; how many do is
// printed.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/vk/vk_submit.h"
#include "support/counting_host.h"

// The bounds that gpu.h states, near the first point and up to 1,000 km from it. Measured: 0.01 mm and 0.3 mm.
#define HEIGHT_M 1e-4
#define FAR_HEIGHT_M 1e-3

// Likewise of motion. Measured: 0.1 mm/s and 2.3 mm/s^2.
#define VELOCITY_MPS 1e-3
#define ACCELERATION_MPS2 1e-2

#define MOST 20000

typedef struct Answers
{
    float height[MOST], jacobian[MOST], residual[MOST];
    swVec3 displacement[MOST], normal[MOST], velocity[MOST], acceleration[MOST];
    swQueryStats stats;
} Answers;

static Answers gpuAnswers, cpuAnswers, particles;
static swPosXZ points[MOST], rests[MOST];

static swSurfaceSamples SamplesOf(Answers* answers)
{
    return (swSurfaceSamples){.height = answers->height,
                              .displacement = answers->displacement,
                              .normal = answers->normal,
                              .jacobian = answers->jacobian,
                              .residual = answers->residual};
}

static swGpuQuery* MakeQuery(Parity* parity, int capacity)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = capacity;
    def.outputs = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    return query;
}

// StepParity() waits, so the frame is done.
static void FetchAnswers(Parity* parity, const swGpuQuery* query, int count)
{
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    assert_int_equal(results.count, count);
    assert_true(results.frameIndex == parity->gpu->frameIndex);
    assert_true(results.time == swWorld_GetTime(parity->world));
    swSurfaceSamples samples = SamplesOf(&gpuAnswers);
    swGpuQueryResults_Unpack(&results, &samples, &gpuAnswers.stats);
}

static void AskCore(Parity* parity, const swQueryDef* def, int count)
{
    swSurfaceSamples samples = SamplesOf(&cpuAnswers);
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), def, count, points, &samples, &cpuAnswers.stats);
    for (int i = 0; i < count; ++i)
    {
        rests[i].x = points[i].x - (double)gpuAnswers.displacement[i].x;
        rests[i].z = points[i].z - (double)gpuAnswers.displacement[i].z;
    }
    samples = SamplesOf(&particles);
    swMoment_QueryParticles(swWorld_GetMoment(parity->world), def, count, rests, &samples, NULL, NULL);
}

static double Length(swVec3 a, swVec3 b)
{
    double x = (double)a.x - (double)b.x, y = (double)a.y - (double)b.y, z = (double)a.z - (double)b.z;
    return sqrt(x * x + y * y + z * z);
}

static double SlopeAt(swVec3 normal)
{
    return hypot((double)normal.x, (double)normal.z) / fmax((double)normal.y, 1e-6);
}

typedef struct Errors
{
    double height, normal, jacobian; // of the particle that the GPU names
    double search;                   // heights of both searches, beyond what residuals explain
    int others;                      // other particles
} Errors;

static Errors FindErrors(int count)
{
    Errors worst = {0};
    for (int i = 0; i < count; ++i)
    {
        // The rest asked for is off by the residual, which changes the particle by its strain.
        double slack = 3.0 * (double)gpuAnswers.residual[i];
        double off = Length(gpuAnswers.displacement[i], particles.displacement[i]) - slack;
        worst.height = fmax(worst.height, off);
        worst.normal = fmax(worst.normal, Length(gpuAnswers.normal[i], particles.normal[i]));
        worst.jacobian = fmax(worst.jacobian, fabs((double)gpuAnswers.jacobian[i] - (double)particles.jacobian[i]));
        double residuals = (double)gpuAnswers.residual[i] + (double)cpuAnswers.residual[i];
        bool isOther = hypot((double)(gpuAnswers.displacement[i].x - cpuAnswers.displacement[i].x),
                             (double)(gpuAnswers.displacement[i].z - cpuAnswers.displacement[i].z)) > 0.02 + residuals;
        worst.others += isOther ? 1 : 0;
        if (!isOther)
        {
            double slope = fmax(SlopeAt(gpuAnswers.normal[i]), SlopeAt(cpuAnswers.normal[i]));
            double error = fabs((double)gpuAnswers.height[i] - (double)cpuAnswers.height[i]) - slope * residuals;
            worst.search = fmax(worst.search, error);
        }
    }
    return worst;
}

static Errors CheckAnswers(const char* what, int count, double tolerance)
{
    Errors errors = FindErrors(count);
    printf("  %-34s particle %.2g m, search %.2g m, normal %.2g, J %.2g; %d of %d others; converged %d, core %d; "
           "worst residual %.2g m\n",
           what, errors.height, errors.search, errors.normal, errors.jacobian, errors.others, count,
           gpuAnswers.stats.convergedCount, cpuAnswers.stats.convergedCount, (double)gpuAnswers.stats.worstResidual);
    assert_true(errors.height < tolerance);
    assert_true(errors.search < tolerance);
    return errors;
}

static void CheckPlaces(Parity* parity, swGpuQuery* query, const char* what, int count, swPosXZ around, double side)
{
    ScatterPoints(points, count, around.x, around.z, side);
    swGpuQuery_SetPoints(query, count, points);
    StepParity(parity, 0.7);
    FetchAnswers(parity, query, count);
    swQueryDef def = swDefaultQueryDef();
    AskCore(parity, &def, count);
    Errors errors = CheckAnswers(what, count, side > 1e5 ? FAR_HEIGHT_M : HEIGHT_M);
    assert_true(errors.others <= count / 500);
    assert_true(gpuAnswers.stats.convergedCount >= cpuAnswers.stats.convergedCount - count / 1000);
    assert_true(errors.normal < 0.02 && errors.jacobian < 0.05);
}

static void AnswersAreTheCoresEverywhere(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    swGpuQuery* query = MakeQuery(&parity, MOST);
    CheckPlaces(&parity, query, "default sea, 10 km around", MOST, (swPosXZ){0.0, 0.0}, 1e4);
    CheckPlaces(&parity, query, "1,000 km away", MOST, (swPosXZ){1e6, -1e6}, 1e4);
    CheckPlaces(&parity, query, "50 m around", 5000, (swPosXZ){-40.0, 17.0}, 50.0);
    CheckPlaces(&parity, query, "scattered over 1,000 km", 5000, (swPosXZ){3e5, 2e5}, 1e6);
    FreeParity(&parity);
}

static void AGaleWithSwellAgrees(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 24.0f;
    def.spectrum.fetch = 800e3f;
    AddParitySea(&parity, &def);
    def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.spectrum.significantHeight = 2.0f;
    def.spectrum.peakPeriod = 14.0f;
    def.seed = 4;
    AddParitySea(&parity, &def);
    swGpuQuery* query = MakeQuery(&parity, MOST);
    CheckPlaces(&parity, query, "gale of 24 m/s and a swell", MOST, (swPosXZ){0.0, 0.0}, 1e4);
    FreeParity(&parity);
}

static void ASeaThatFoldsHasParticlesToo(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.chop = 2.0f;
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, MOST);
    ScatterPoints(points, MOST, 0.0, 0.0, 3000.0);
    swGpuQuery_SetPoints(query, MOST, points);
    StepParity(&parity, 0.7);
    FetchAnswers(&parity, query, MOST);
    swQueryDef def = swDefaultQueryDef();
    AskCore(&parity, &def, MOST);
    CheckAnswers("chop 2, folded", MOST, HEIGHT_M);
    assert_true(gpuAnswers.stats.convergedCount >= 0.98 * MOST);
    FreeParity(&parity);
}

static void WavesOneByOneAgree(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    const swWaveComponent components[] = {
        {180.0f, 0.3f, 1.5f, 0.2f}, {60.0f, -0.8f, 0.4f, 1.0f}, {9.0f, 2.0f, 0.08f, 2.0f},
        {3.0f, 1.0f, 0.02f, 3.0f},  {1.0f, -2.5f, 0.01f, 4.0f},
    };
    def.method = SW_WAVES_GERSTNER;
    def.components = components;
    def.componentCount = 5;
    AddParitySea(&parity, &def);
    swGpuQuery* query = MakeQuery(&parity, MOST);
    CheckPlaces(&parity, query, "tiles and 5 free waves", 5000, (swPosXZ){0.0, 0.0}, 1e4);
    CheckPlaces(&parity, query, "the same 1,000 km away", 5000, (swPosXZ){-1e6, 1e6}, 1e4);
    FreeParity(&parity);
}

static void ShortWavesCanBeLeftOut(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = 2000;
    def.outputs = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL;
    def.minWavelength = 4.0f;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &query), SW_SUCCESS);
    ScatterPoints(points, 2000, 0.0, 0.0, 2000.0);
    swGpuQuery_SetPoints(query, 2000, points);
    StepParity(&parity, 0.7);
    FetchAnswers(&parity, query, 2000);
    swQueryDef core = swDefaultQueryDef();
    core.minWavelength = 4.0f;
    AskCore(&parity, &core, 2000);
    assert_int_equal(CheckAnswers("waves of 4 m and more", 2000, HEIGHT_M).others, 0);
    FreeParity(&parity);
}

// ---- motion ----

// A world whose tiles move, so that the core's answers come from tiles too.
static Parity MakeMovingParity(void** state)
{
    swWorldDef def = swDefaultWorldDef();
    def.enableVelocity = true;
    def.enableAcceleration = true;
    return MakeParityOf(state, &def);
}

static swSurfaceSamples MotionOf(Answers* answers, uint32_t outputs)
{
    swSurfaceSamples samples = {.displacement = answers->displacement, .residual = answers->residual};
    samples.velocity = (outputs & SW_GPU_QUERY_VELOCITY) != 0 ? answers->velocity : NULL;
    samples.acceleration = (outputs & SW_GPU_QUERY_ACCELERATION) != 0 ? answers->acceleration : NULL;
    return samples;
}

static double FindWorst(int count, const swVec3* a, const swVec3* b)
{
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
    {
        double length = Length(a[i], b[i]);
        worst = length <= worst ? worst : length; // NaN counts as worst
    }
    return worst;
}

// Motion of the last step at the scattered points: the core is asked about the particles that the GPU names.
static void CheckMotion(Parity* parity, const swGpuQuery* query, const char* what, int count)
{
    uint32_t outputs = query->def.outputs;
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    assert_true(results.frameIndex == parity->gpu->frameIndex && results.count == count);
    assert_true((results.velocities != NULL) == ((outputs & SW_GPU_QUERY_VELOCITY) != 0));
    assert_true((results.accelerations != NULL) == ((outputs & SW_GPU_QUERY_ACCELERATION) != 0));
    swSurfaceSamples samples = MotionOf(&gpuAnswers, outputs);
    swGpuQueryResults_Unpack(&results, &samples, NULL);
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = query->def.minWavelength;
    for (int i = 0; i < count; ++i)
    {
        rests[i].x = points[i].x - (double)gpuAnswers.displacement[i].x;
        rests[i].z = points[i].z - (double)gpuAnswers.displacement[i].z;
    }
    samples = MotionOf(&particles, outputs);
    swMoment_QueryParticles(swWorld_GetMoment(parity->world), &def, count, rests, &samples, NULL, NULL);
    double velocity = samples.velocity != NULL ? FindWorst(count, gpuAnswers.velocity, particles.velocity) : 0.0;
    double acceleration =
        samples.acceleration != NULL ? FindWorst(count, gpuAnswers.acceleration, particles.acceleration) : 0.0;
    printf("  %-34s velocity %.2g m/s, acceleration %.2g m/s^2\n", what, velocity, acceleration);
    assert_true(velocity < VELOCITY_MPS);
    assert_true(acceleration < ACCELERATION_MPS2);
}

// With a tolerance so small that residuals do not count.
static swGpuQuery* AskMotion(Parity* parity, int count, uint32_t outputs, swPosXZ around)
{
    ScatterPoints(points, count, around.x, around.z, 3000.0);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = count;
    def.outputs = SW_GPU_QUERY_SIDEWAYS | outputs;
    def.tolerance = 1e-5f;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    swGpuQuery_SetPoints(query, count, points);
    return query;
}

static void ParticlesMoveAsTheCoresDo(void** state)
{
    const uint32_t both = SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    Parity parity = MakeMovingParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQuery* query = AskMotion(&parity, 5000, both, (swPosXZ){0.0, 0.0});
    StepParity(&parity, 0.7);
    CheckMotion(&parity, query, "default sea", 5000);
    swDestroyGpuQuery(query);
    query = AskMotion(&parity, 5000, both, (swPosXZ){1e6, -1e6});
    StepParity(&parity, 3600.0);
    CheckMotion(&parity, query, "1,000 km away, an hour later", 5000);
    FreeParity(&parity);
}

static void MotionOfAGaleAndOfFreeWavesAgrees(void** state)
{
    Parity parity = MakeMovingParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.windSpeed = 24.0f;
    def.spectrum.fetch = 800e3f;
    AddParitySea(&parity, &def);
    def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.spectrum.significantHeight = 2.0f;
    def.spectrum.peakPeriod = 14.0f;
    def.spectrum.depth = 40.0f;
    def.loopPeriod = 60.0f;
    def.weight = 0.6f;
    def.seed = 4;
    AddParitySea(&parity, &def);
    const swWaveComponent components[] = {{180.0f, 0.3f, 1.5f, 0.2f}, {9.0f, 2.0f, 0.08f, 2.0f}};
    def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = components;
    def.componentCount = 2;
    AddParitySea(&parity, &def);
    swGpuQuery* query =
        AskMotion(&parity, 5000, SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION, (swPosXZ){0.0, 0.0});
    StepParity(&parity, 100.3);
    CheckMotion(&parity, query, "gale, looping swell, 2 free waves", 5000);
    FreeParity(&parity);
}

// Tiles and free waves in currents, an hour on.
static void SeasInCurrentsAgree(void** state)
{
    Parity parity = MakeMovingParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.currentX = 2.0f;
    def.currentZ = -0.7f;
    AddParitySea(&parity, &def);
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 2;
    def.minWavelength = 4.0f;
    def.currentX = -1.0f;
    AddParitySea(&parity, &def);
    swGpuQuery* query =
        AskMotion(&parity, 5000, SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION, (swPosXZ){1e6, 0.0});
    StepParity(&parity, 3599.3);
    CheckMotion(&parity, query, "in currents", 5000);
    FreeParity(&parity);
}

static void MotionOfASeaThatChangesAgrees(void** state)
{
    Parity parity = MakeMovingParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = 1.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity.world, &def, &id), SW_SUCCESS);
    swGpuQuery* query =
        AskMotion(&parity, 2000, SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION, (swPosXZ){0.0, 0.0});
    StepParity(&parity, 1.0);
    def.spectrum.windSpeed = 18.0f; // the same waves with other heights
    assert_int_equal(swWaveSystem_Set(parity.world, id, &def, 4.0), SW_SUCCESS);
    StepParity(&parity, 1.5);
    CheckMotion(&parity, query, "halfway to more wind", 2000);
    def.seed = 77; // other waves: one sea fades into the other
    assert_int_equal(swWaveSystem_Set(parity.world, id, &def, 4.0), SW_SUCCESS);
    StepParity(&parity, 1.5);
    CheckMotion(&parity, query, "halfway to other waves", 2000);
    FreeParity(&parity);
}

static void MotionIsMadeOnlyWhereAskedFor(void** state)
{
    Parity parity = MakeMovingParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 4.0f;
    AddParitySea(&parity, &sea);
    swGpuQuery* still = AskMotion(&parity, 500, 0, (swPosXZ){0.0, 0.0});
    StepParity(&parity, 0.7);
    size_t memory = swGpuWorld_GetMemory(parity.gpuWorld);
    assert_int_equal(parity.gpuWorld->tiles.fields.count, 1);
    swGpuQuery* resting = AskMotion(&parity, 500, SW_GPU_QUERY_VELOCITY, (swPosXZ){0.0, 0.0});
    swGpuQuery_SetPoints(resting, 0, NULL);
    StepParity(&parity, 0.7);
    assert_int_equal(parity.gpuWorld->tiles.fields.count, 1);
    swDestroyGpuQuery(resting);
    assert_true(swGpuWorld_GetMemory(parity.gpuWorld) == memory);

    const uint32_t outputs[] = {SW_GPU_QUERY_VELOCITY, SW_GPU_QUERY_ACCELERATION};
    for (int i = 0; i < 2; ++i)
    {
        swGpuQuery* query = AskMotion(&parity, 500, outputs[i], (swPosXZ){0.0, 0.0});
        StepParity(&parity, 0.7);
        assert_int_equal(parity.gpuWorld->tiles.fields.count, 2);
        CheckMotion(&parity, query, i == 0 ? "velocity alone" : "acceleration alone", 500);
        CheckMotion(&parity, still, "a query without, beside it", 500);
        swDestroyGpuQuery(query);
    }
    // Each by its own query, of one frame.
    swGpuQuery* first = AskMotion(&parity, 500, outputs[0], (swPosXZ){0.0, 0.0});
    swGpuQuery* second = AskMotion(&parity, 500, outputs[1], (swPosXZ){0.0, 0.0});
    StepParity(&parity, 0.7);
    assert_int_equal(parity.gpuWorld->tiles.fields.count, 3);
    CheckMotion(&parity, first, "velocity by one query", 500);
    CheckMotion(&parity, second, "acceleration by another", 500);
    FreeParity(&parity);
}

static void WaterWithoutWavesIsFlat(void** state)
{
    Parity parity = MakeParity(state);
    swGpuQuery* query = MakeQuery(&parity, 100);
    ScatterPoints(points, 100, 0.0, 0.0, 100.0);
    swGpuQuery_SetPoints(query, 100, points);
    StepParity(&parity, 1.0);
    FetchAnswers(&parity, query, 100);
    for (int i = 0; i < 100; ++i)
    {
        assert_true(gpuAnswers.height[i] == 0.0f && gpuAnswers.jacobian[i] == 1.0f && gpuAnswers.normal[i].y == 1.0f);
    }
    assert_int_equal(gpuAnswers.stats.convergedCount, 100);
    FreeParity(&parity);
}

static void PointsMayLieInABufferOfTheHosts(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 3000);
    const swPosXZ origin = {2.5e5 + 0.125, -17.0};
    const VkDeviceSize offset = 264;
    swBuffer buffer;
    assert_int_equal(swCreateBuffer(parity.gpu, offset + 3000 * sizeof(swVec2), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                    SW_MEMORY_UPLOAD, "places", &buffer),
                     SW_SUCCESS);
    ScatterPoints(points, 3000, 0.0, 0.0, 2000.0);
    swVec2* places = (swVec2*)((uint8_t*)buffer.mapped + offset);
    for (int i = 0; i < 3000; ++i)
    {
        swVec2 place = {(float)points[i].x, (float)points[i].z};
        places[i] = place;
        points[i] = (swPosXZ){origin.x + (double)place.x, origin.z + (double)place.y};
    }
    swGpuQuery_SetPointBuffer(query, 3000, buffer.handle, offset, origin);
    StepParity(&parity, 0.7);
    FetchAnswers(&parity, query, 3000);
    swQueryDef def = swDefaultQueryDef();
    AskCore(&parity, &def, 3000);
    CheckAnswers("floats from an origin", 3000, HEIGHT_M);
    swDestroyGpuWorld(parity.gpuWorld);
    parity.gpuWorld = NULL;
    swDestroyBuffer(parity.gpu, &buffer);
    FreeParity(&parity);
}

static void AnswersCarryTheStampOfTheirFrame(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 8.0f;
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 64);
    ScatterPoints(points, 64, 0.0, 0.0, 500.0);
    swGpuQueryResults results;
    StepParity(&parity, 0.1);
    assert_false(swGpuQuery_GetResults(query, &results)); // nothing was asked yet
    double times[6];
    uint64_t first = parity.gpu->frameIndex + 1;
    for (int i = 0; i < 6; ++i)
    {
        points[0].x = i;
        swGpuQuery_SetPoints(query, 64 - i, points);
        StepParity(&parity, 0.1);
        times[i] = swWorld_GetTime(parity.world);
        bool hasArrived = swGpuQuery_GetResults(query, &results);
        int expected = i - parity.gpu->framesInFlight;
        assert_int_equal(hasArrived, expected >= 0);
        if (hasArrived)
        {
            assert_true(results.frameIndex == first + (uint64_t)expected);
            assert_true(results.time == times[expected]);
            assert_int_equal(results.count, 64 - expected);
            assert_int_equal(results.pointsVersion, 1 + expected);
        }
    }
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    assert_true(results.frameIndex == first + 5 && results.count == 59);
    FreeParity(&parity);
}

static void PointsStayUntilOthersAreSet(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 500);
    ScatterPoints(points, 500, 0.0, 0.0, 500.0);
    swGpuQuery_SetPoints(query, 500, points);
    swQueryDef def = swDefaultQueryDef();
    for (int i = 0; i < 8; ++i) // more than slots
    {
        StepParity(&parity, 0.3);
    }
    FetchAnswers(&parity, query, 500);
    AskCore(&parity, &def, 500);
    CheckAnswers("eight frames later", 500, HEIGHT_M);
    swGpuQuery_SetPoints(query, 0, NULL);
    StepParity(&parity, 0.3);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results)); // the last that there are
    assert_true(results.frameIndex < parity.gpu->frameIndex);
    FreeParity(&parity);
}

static void QueriesComeAndGo(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 8.0f;
    AddParitySea(&parity, &sea);
    StepParity(&parity, 0.1);
    size_t before = swGpuWorld_GetMemory(parity.gpuWorld);
    swGpuQuery* queries[5];
    ScatterPoints(points, 100, 0.0, 0.0, 500.0);
    for (int round = 0; round < 3; ++round)
    {
        for (int i = 0; i < 5; ++i)
        {
            queries[i] = MakeQuery(&parity, 100);
            swGpuQuery_SetPoints(queries[i], 20 * i, points);
        }
        StepParity(&parity, 0.1);
        swDestroyGpuQuery(queries[2]);
        swDestroyGpuQuery(queries[0]);
        StepParity(&parity, 0.1);
        FetchAnswers(&parity, queries[4], 80);
        swQueryDef def = swDefaultQueryDef();
        AskCore(&parity, &def, 80);
        assert_true(FindErrors(80).search < HEIGHT_M);
        swDestroyGpuQuery(queries[4]);
        swDestroyGpuQuery(queries[3]);
        swDestroyGpuQuery(queries[1]);
        assert_true(swGpuWorld_GetMemory(parity.gpuWorld) == before);
    }
    MakeQuery(&parity, 100); // goes with its world
    FreeParity(&parity);
}

static void AnswersCanStayOnTheGpu(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = 200;
    def.outputs = SW_GPU_QUERY_NORMAL;
    def.readBack = false;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &query), SW_SUCCESS);
    ScatterPoints(points, 200, 0.0, 0.0, 300.0);
    swGpuQuery_SetPoints(query, 200, points);
    StepParity(&parity, 0.7);
    swGpuQueryBuffer planes = swGpuQuery_GetBuffer(query);
    assert_true(planes.sideways == 0 && planes.normals != 0);
    swBuffer copy;
    VkCommandBuffer commands;
    assert_int_equal(swCreateBuffer(parity.gpu, 200 * sizeof(swGpuHeight), 0, SW_MEMORY_READBACK, "copy", &copy),
                     SW_SUCCESS);
    assert_int_equal(swBeginSubmit(parity.gpu, &commands), SW_SUCCESS);
    const VkBufferCopy region = {.srcOffset = planes.heights, .size = 200 * sizeof(swGpuHeight)};
    parity.gpu->vk.CmdCopyBuffer(commands, planes.buffer, copy.handle, 1, &region);
    assert_int_equal(swEndSubmit(parity.gpu), SW_SUCCESS);
    const swGpuHeight* heights = copy.mapped;
    swQueryDef core = swDefaultQueryDef();
    AskCore(&parity, &core, 200);
    for (int i = 0; i < 200; ++i)
    {
        assert_float_equal(heights[i].height, cpuAnswers.displacement[i].y, 3e-3);
    }
    swDestroyBuffer(parity.gpu, &copy);
    FreeParity(&parity);
}

static void AMillionPointsAreAnsweredToTheLast(void** state)
{
    enum
    {
        COUNT = 1100000 // more than 65,535 workgroups
    };
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 64.0f;
    AddParitySea(&parity, &sea);
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = COUNT;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &def, &query), SW_SUCCESS);
    swPosXZ* many = malloc(sizeof(swPosXZ) * COUNT);
    assert_non_null(many);
    for (int i = 0; i < COUNT; ++i)
    {
        many[i] = (swPosXZ){0.01 * i, -0.02 * i};
    }
    swGpuQuery_SetPoints(query, COUNT, many);
    StepParity(&parity, 0.7);
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    for (int i = 0; i < COUNT; i += i < COUNT - 100 ? 997 : 1)
    {
        assert_float_equal(results.heights[i].height,
                           swMoment_GetHeight(swWorld_GetMoment(parity.world), many[i].x, many[i].z), 2e-3);
    }
    free(many);
    FreeParity(&parity);
}

// All outputs of the most points are more bytes than a device must bind at once: each has a binding of its own.
static void TheLargestQueriesAreWithinWhatADeviceBinds(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    AddParitySea(&parity, &waves);
    int messages = swGpu_GetValidationCount(parity.gpu);
    const swGpuQueryKind kinds[] = {SW_GPU_QUERY_KIND_SURFACE, SW_GPU_QUERY_KIND_VOLUME, SW_GPU_QUERY_KIND_RAYS};
    const uint32_t outputs[] = {15, SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION, SW_GPU_QUERY_NORMAL};
    for (size_t i = 0; i < sizeof(kinds) / sizeof(kinds[0]); ++i)
    {
        swGpuQueryDef def = swDefaultGpuQueryDef();
        def.kind = kinds[i];
        def.outputs = outputs[i];
        def.capacity = 4194304;
        def.readBack = false;
        swGpuQuery* query = NULL;
        swResult result = swCreateGpuQuery(parity.gpuWorld, &def, &query);
        if (result == SW_ERROR_LIMIT && kinds[i] == SW_GPU_QUERY_KIND_RAYS) // a device that binds 128 MiB
        {
            def.capacity = 3355443;
            result = swCreateGpuQuery(parity.gpuWorld, &def, &query);
        }
        assert_int_equal(result, SW_SUCCESS);
        switch (kinds[i])
        {
        case SW_GPU_QUERY_KIND_SURFACE:
            swGpuQuery_SetPoints(query, 1, &(swPosXZ){1.0, 2.0});
            break;
        case SW_GPU_QUERY_KIND_VOLUME:
            swGpuQuery_SetPlaces(query, 1, &(swPos){1.0, -2.0, 3.0});
            break;
        case SW_GPU_QUERY_KIND_RAYS:
            swGpuQuery_SetRays(query, 1, &(swRay){.direction = {0.0f, -1.0f, 0.0f}, .maxDistance = 10.0f});
            break;
        }
        StepParity(&parity, 0.1);
        swDestroyGpuQuery(query);
    }
    assert_int_equal(swGpu_GetValidationCount(parity.gpu), messages);
    FreeParity(&parity);
}

static void AWarmQueryAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swGpuDef def = swDefaultGpuDef();
    swGpu* gpu = NULL;
    assert_int_equal(swCreateGpu(&host, &def, &gpu), SW_SUCCESS);
    void* opened = gpu;
    Parity parity = MakeParity(&opened);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 8.0f;
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 1000);
    ScatterPoints(points, 1000, 0.0, 0.0, 500.0);
    long long warm = 0;
    for (int i = 0; i < 12; ++i)
    {
        warm = i == 5 ? atomic_load(&memory.allocations) : warm;
        swGpuQuery_SetPoints(query, 1000, points);
        StepParity(&parity, 0.1);
        FetchAnswers(&parity, query, 1000);
    }
    assert_int_equal(atomic_load(&memory.allocations), warm);
    FreeParity(&parity);
    swDestroyGpu(gpu);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AnswersAreTheCoresEverywhere),
        cmocka_unit_test(AGaleWithSwellAgrees),
        cmocka_unit_test(ASeaThatFoldsHasParticlesToo),
        cmocka_unit_test(WavesOneByOneAgree),
        cmocka_unit_test(ShortWavesCanBeLeftOut),
        cmocka_unit_test(WaterWithoutWavesIsFlat),
        cmocka_unit_test(PointsMayLieInABufferOfTheHosts),
        cmocka_unit_test(AnswersCarryTheStampOfTheirFrame),
        cmocka_unit_test(PointsStayUntilOthersAreSet),
        cmocka_unit_test(QueriesComeAndGo),
        cmocka_unit_test(AnswersCanStayOnTheGpu),
        cmocka_unit_test(AMillionPointsAreAnsweredToTheLast),
        cmocka_unit_test(TheLargestQueriesAreWithinWhatADeviceBinds),
        cmocka_unit_test(AWarmQueryAllocatesNothing),
        cmocka_unit_test(ParticlesMoveAsTheCoresDo),
        cmocka_unit_test(MotionOfAGaleAndOfFreeWavesAgrees),
        cmocka_unit_test(SeasInCurrentsAgree),
        cmocka_unit_test(MotionOfASeaThatChangesAgrees),
        cmocka_unit_test(MotionIsMadeOnlyWhereAskedFor),
    };
    return cmocka_run_group_tests_name("surface queries: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
