// SPDX-License-Identifier: MIT
// Rays on the GPU meet the water that the core's rays meet. Every hit is held against the core's surface at that place;
// and the distance against that of the core's own ray. The second may differ where a ray grazes a crest that one of the
// two just misses; how many do is printed.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>

#define MOST 2000
#define TOLERANCE_M 5e-4

// Of the gap at a hit beyond what the tolerance and the residuals of searches explain, for ways of up to 400 m.
// Measured: 0.
#define GAP_M 1e-4

static swRay rays[MOST];
static swRayHit gpuHits[MOST], cpuHits[MOST];
static swPosXZ places[MOST];
static float heights[MOST], residuals[MOST];
static swVec3 normals[MOST];

// Origins over 2 km and `low` to `high`, directions with a slope of `down` and half of it more or less.
static void ScatterRays(int count, swPosXZ around, double low, double high, double down, float radius)
{
    uint32_t seed = 99;
    for (int i = 0; i < count; ++i)
    {
        double angle = 2.0 * SW_PI * NextPart(&seed);
        swPos origin = {around.x + 2000.0 * (NextPart(&seed) - 0.5), low + (high - low) * NextPart(&seed),
                        around.z + 2000.0 * (NextPart(&seed) - 0.5)};
        double slope = down * (0.5 + NextPart(&seed));
        rays[i] = swDefaultRay(origin, (swVec3){(float)cos(angle), -(float)slope, (float)sin(angle)});
        rays[i].maxDistance = 400.0f;
        rays[i].radius = radius;
    }
}

static swGpuQuery* MakeQuery(Parity* parity, int capacity, float minWavelength)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.kind = SW_GPU_QUERY_KIND_RAYS;
    def.outputs = SW_GPU_QUERY_NORMAL;
    def.capacity = capacity;
    def.minWavelength = minWavelength;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    return query;
}

static void FetchHits(Parity* parity, const swGpuQuery* query, int count)
{
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    swGpuQueryResults results;
    assert_true(swGpuQuery_GetResults(query, &results));
    assert_true(results.frameIndex == parity->gpu->frameIndex && results.count == count);
    swGpuQueryResults_UnpackHits(&results, rays, gpuHits, NULL);
}

// The largest distance of hits from the core's surface, of a sphere from its touching plane, beyond what is allowed.
static double FindGap(Parity* parity, const swQueryDef* def, int count)
{
    for (int i = 0; i < count; ++i)
    {
        places[i] = (swPosXZ){gpuHits[i].position.x, gpuHits[i].position.z};
    }
    const swSurfaceSamples samples = {.height = heights, .normal = normals, .residual = residuals};
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), def, count, places, &samples, NULL);
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
    {
        if (!gpuHits[i].isHit || gpuHits[i].distance == 0.0f) // it may have begun deep in the water
        {
            continue;
        }
        double up = rays[i].radius > 0.0f ? (double)normals[i].y : 1.0;
        double gap = fabs((gpuHits[i].position.y - (double)heights[i]) * up) - (double)rays[i].radius;
        double slope = hypot((double)normals[i].x, (double)normals[i].z) / fmax((double)normals[i].y, 1e-3);
        // Normals of two searches differ by what the shortest waves make of their residuals.
        double slack = TOLERANCE_M + slope * (TOLERANCE_M + (double)residuals[i]) + 0.01 * (double)rays[i].radius;
        double error = fabs(gap) - slack;
        worst = error <= worst ? worst : error; // NaN counts as worst
    }
    return worst;
}

// `others` may see other water than the core's. Returns the largest gap.
static double CompareHits(Parity* parity, const swGpuQuery* query, const char* what, int count, int others)
{
    FetchHits(parity, query, count);
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = query->def.minWavelength;
    swMoment_CastRays(swWorld_GetMoment(parity->world), &def, count, rays, cpuHits, NULL);
    double gap = FindGap(parity, &def, count);
    int different = 0, hitCount = 0;
    double distance = 0.0, point = 0.0;
    for (int i = 0; i < count; ++i)
    {
        const swRayHit *gpu = &gpuHits[i], *cpu = &cpuHits[i];
        hitCount += cpu->isHit ? 1 : 0;
        double apart = fabs((double)gpu->distance - (double)cpu->distance);
        if (gpu->isHit != cpu->isHit || gpu->fromBelow != cpu->fromBelow || apart > 0.1)
        {
            different += 1;
            continue;
        }
        distance = fmax(distance, apart);
        point = fmax(point, hypot(gpu->point.x - cpu->point.x, gpu->point.z - cpu->point.z));
    }
    printf("  %-30s gap %.2g m, distance %.2g m, point %.2g m; %d of %d hit, %d other water\n", what, gap, distance,
           point, hitCount, count, different);
    assert_true(different <= others);
    return gap;
}

static void CheckHits(Parity* parity, const swGpuQuery* query, const char* what, int count, int others)
{
    assert_true(CompareHits(parity, query, what, count, others) < GAP_M);
}

typedef struct Aim
{
    const char* what;
    double low, high; // m
    double down;      // slope
    float radius;     // m
} Aim;

static void CheckAims(Parity* parity, swPosXZ around, int count)
{
    static const Aim aims[] = {
        {"down from above", 10.0, 30.0, 1.0, 0.0f},
        {"steeply", 10.0, 30.0, 20.0, 0.0f},
        {"grazing", 2.0, 4.0, 0.05, 0.0f},
        {"up from below", -30.0, -10.0, -1.0, 0.0f},
        {"spheres from above", 10.0, 30.0, 1.0, 0.5f},
        {"spheres from below", -30.0, -10.0, -1.0, 0.5f},
        {"from around the surface", -1.0, 1.0, 0.3, 0.2f},
        {"away from the water", 20.0, 30.0, -0.3, 0.0f},
    };
    swGpuQuery* query = MakeQuery(parity, count, 0.0f);
    for (size_t i = 0; i < sizeof(aims) / sizeof(aims[0]); ++i)
    {
        ScatterRays(count, around, aims[i].low, aims[i].high, aims[i].down, aims[i].radius);
        swGpuQuery_SetRays(query, count, rays);
        StepParity(parity, 0.7);
        CheckHits(parity, query, aims[i].what, count, count / 100);
    }
    swDestroyGpuQuery(query);
}

static void RaysMeetTheWaterThatTheCoresMeet(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    CheckAims(&parity, (swPosXZ){0.0, 0.0}, 500);
    FreeParity(&parity);
}

static void AndSoTheyDoFarAwayAndOverAnotherSeaLevel(void** state)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = -0.75;
    Parity parity = MakeParityOf(state, &worldDef);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = 0.5f;
    def.spectrum.windSpeed = 16.0f;
    AddParitySea(&parity, &def);
    const swWaveComponent components[] = {{60.0f, -0.8f, 0.4f, 1.0f}, {9.0f, 2.0f, 0.08f, 2.0f}};
    def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = components;
    def.componentCount = 2;
    AddParitySea(&parity, &def);
    CheckAims(&parity, (swPosXZ){1e6, -1e6}, 300);
    FreeParity(&parity);
}

static void ShortWavesCanBeLeftOut(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 300, 4.0f);
    ScatterRays(300, (swPosXZ){0.0, 0.0}, 10.0, 30.0, 0.3, 0.0f);
    swGpuQuery_SetRays(query, 300, rays);
    StepParity(&parity, 0.7);
    CheckHits(&parity, query, "waves of 4 m and more", 300, 3);
    FreeParity(&parity);
}

static void FlatWaterIsMetWhereItIs(void** state)
{
    Parity parity = MakeParity(state);
    swGpuQuery* query = MakeQuery(&parity, 5, 0.0f);
    rays[0] = swDefaultRay((swPos){1.0, 10.0, 2.0}, (swVec3){0.0f, -3.0f, 0.0f});
    rays[1] = swDefaultRay((swPos){1.0, -10.0, 2.0}, (swVec3){0.0f, 1.0f, 0.0f});
    rays[2] = swDefaultRay((swPos){1.0, 3.0, 2.0}, (swVec3){3.0f, -3.0f, 0.0f});
    rays[2].radius = 1.0f;
    rays[3] = swDefaultRay((swPos){1.0, 0.5, 2.0}, (swVec3){3.0f, -3.0f, 0.0f}); // it touches from the start
    rays[3].radius = 1.0f;
    rays[4] = swDefaultRay((swPos){1.0, 10.0, 2.0}, (swVec3){0.0f, -1.0f, 0.0f});
    rays[4].maxDistance = 9.0f;
    swGpuQuery_SetRays(query, 5, rays);
    StepParity(&parity, 0.5);
    FetchHits(&parity, query, 5);
    const double distances[] = {10.0, 10.0, 2.0 * sqrt(2.0), 0.0, 9.0};
    for (int i = 0; i < 5; ++i)
    {
        assert_float_equal(gpuHits[i].distance, distances[i], 2e-3);
        assert_int_equal(gpuHits[i].isHit, i < 4);
        assert_int_equal(gpuHits[i].fromBelow, i == 1);
        assert_true(i == 4 || fabs(gpuHits[i].point.y) < 2e-3);
    }
    FreeParity(&parity);
}

static void RaysMayLieInABufferOfTheHosts(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 2.0f;
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 200, 0.0f);
    const swPosXZ origin = {2.5e5 + 0.125, -17.0};
    const VkDeviceSize offset = 268;
    swBuffer buffer;
    assert_int_equal(swCreateBuffer(parity.gpu, offset + 200 * 8 * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                    SW_MEMORY_UPLOAD, "rays", &buffer),
                     SW_SUCCESS);
    ScatterRays(200, (swPosXZ){0.0, 0.0}, 10.0, 30.0, 1.0, 0.25f);
    float* to = (float*)((uint8_t*)buffer.mapped + offset);
    for (int i = 0; i < 200; ++i)
    {
        swRay* ray = &rays[i];
        const float ours[8] = {(float)ray->origin.x, (float)ray->origin.y, (float)ray->origin.z, ray->maxDistance,
                               ray->direction.x,     ray->direction.y,     ray->direction.z,     ray->radius};
        for (int word = 0; word < 8; ++word)
        {
            to[8 * i + word] = ours[word];
        }
        ray->origin = (swPos){origin.x + (double)ours[0], (double)ours[1], origin.z + (double)ours[2]};
    }
    swGpuQuery_SetPointBuffer(query, 200, buffer.handle, offset, origin);
    StepParity(&parity, 0.7);
    CheckHits(&parity, query, "floats from an origin", 200, 2);
    swDestroyGpuWorld(parity.gpuWorld);
    parity.gpuWorld = NULL;
    swDestroyBuffer(parity.gpu, &buffer);
    FreeParity(&parity);
}

// A way of 100 km just above ripples has more looks than a ray may take.
static void ARayThatLooksTooOftenSaysHowFarItCame(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.spectrum.windSpeed = 2.0f;
    sea.maxWavelength = 0.25f;
    AddParitySea(&parity, &sea);
    swGpuQuery* query = MakeQuery(&parity, 1, 0.0f);
    StepParity(&parity, 0.5);
    const swFrame* frame = swGetWorldFrame(parity.world);
    double variance = 0.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        variance += (double)frame->tiles[i].variance;
    }
    rays[0] = swDefaultRay((swPos){0.0, 5.9 * sqrt(variance), 0.0}, (swVec3){1.0f, 0.0f, 0.0f});
    rays[0].maxDistance = 1e5f;
    swGpuQuery_SetRays(query, 1, rays);
    StepParity(&parity, 0.5);
    FetchHits(&parity, query, 1);
    printf("  came %.0f m\n", (double)gpuHits[0].distance);
    assert_false(gpuHits[0].isHit);
    assert_true(gpuHits[0].distance > 10.0f && gpuHits[0].distance < 1e5f);
    FreeParity(&parity);
}

// Half of the plane in squares of 30 m, cut from 0.2 m below sea level up.
static void AddSquares(Parity* parity)
{
    for (int i = 0; i < 8 * 8; ++i)
    {
        swInputDef def = swDefaultInputDef();
        def.field = SW_INPUT_CLIP;
        def.shape = SW_SHAPE_BOX;
        def.position = (swPos){60.0 * (i % 8) - 210.0, 4.8, 60.0 * (double)(i / 8) - 210.0};
        def.size = (swVec3){42.0f, 10.0f, 42.0f};
        def.rotation.yaw = 0.3f;
        def.value[0] = 1.0f;
        swInputId id;
        assert_int_equal(swCreateInput(parity->world, &def, &id), SW_SUCCESS);
    }
}

// Hits, and those of them where the core has a hole.
static int CountHits(Parity* parity, int count, int* clipped)
{
    static bool isClipped[MOST];
    for (int i = 0; i < count; ++i)
    {
        places[i] = (swPosXZ){gpuHits[i].point.x, gpuHits[i].point.z};
    }
    swQueryDef def = swDefaultQueryDef();
    const swSurfaceSamples samples = {.isClipped = isClipped};
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), &def, count, places, &samples, NULL);
    int hitCount = 0;
    *clipped = 0;
    for (int i = 0; i < count; ++i)
    {
        hitCount += gpuHits[i].isHit ? 1 : 0;
        *clipped += gpuHits[i].isHit && isClipped[i] ? 1 : 0;
    }
    return hitCount;
}

// A sphere that comes out of a hole may touch at once, farther than its radius in: the core's does, too.
static void RaysPassHolesAsTheCoresDo(void** state)
{
    enum
    {
        COUNT = 600
    };
    for (int i = 0; i < 2; ++i)
    {
        Parity parity = MakeParity(state);
        swWaveSystemDef sea = swDefaultWaveSystemDef();
        AddParitySea(&parity, &sea);
        swGpuQuery* query = MakeQuery(&parity, COUNT, 0.0f);
        ScatterRays(COUNT, (swPosXZ){0.0, 0.0}, 10.0, 30.0, 1.0, i == 0 ? 0.0f : 0.5f);
        for (int k = 0; k < COUNT; ++k)
        {
            rays[k].origin.x *= 0.2; // to where the holes are
            rays[k].origin.z *= 0.2;
        }
        swGpuQuery_SetRays(query, COUNT, rays);
        StepParity(&parity, 0.7);
        CheckHits(&parity, query, "without holes", COUNT, COUNT / 100);
        int clipped;
        int without = CountHits(&parity, COUNT, &clipped);
        AddSquares(&parity);
        StepParity(&parity, 0.7);
        double gap =
            CompareHits(&parity, query, i == 0 ? "rays through holes" : "spheres through holes", COUNT, COUNT / 100);
        int with = CountHits(&parity, COUNT, &clipped);
        printf("  of %d hits %d are left, %d of them where the core has a hole\n", without, with, clipped);
        assert_true(i == 1 || gap < GAP_M);
        assert_true(with < without - COUNT / 10);
        assert_true(clipped <= COUNT / 100);
        FreeParity(&parity);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(RaysMeetTheWaterThatTheCoresMeet), cmocka_unit_test(AndSoTheyDoFarAwayAndOverAnotherSeaLevel),
        cmocka_unit_test(ShortWavesCanBeLeftOut),           cmocka_unit_test(FlatWaterIsMetWhereItIs),
        cmocka_unit_test(RaysMayLieInABufferOfTheHosts),    cmocka_unit_test(ARayThatLooksTooOftenSaysHowFarItCame),
        cmocka_unit_test(RaysPassHolesAsTheCoresDo),
    };
    return cmocka_run_group_tests_name("rays: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
