// SPDX-License-Identifier: MIT
// One bad point of a query on the GPU spoils no other: its answers are NaN, also in the buffers that shaders see, and
// those of all others are, to the bit, those of a query without it. Two queries share a frame, one with bad points
// among the good ones and one without; points come from the host, and from a buffer of floats on the device.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    GOOD = 300,
    MOST = 2 * GOOD
};

// Doubles, and floats, that can be no place.
static const double badDoubles[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1.1e12, -1e300};
static const float badFloats[] = {NAN, -NAN, INFINITY, -INFINITY, 2e11f, -3e38f};

typedef struct Mix
{
    int count;
    bool isBad[MOST];
    swRay all[MOST]; // a point is where its ray begins
    swRay good[GOOD];
} Mix;

static Mix mix;

static void SpoilPlace(swPos* place, int number, bool isSurface)
{
    double* axes[3] = {&place->x, &place->z, &place->y};
    *axes[number % (isSurface ? 2 : 3)] = badDoubles[number % 5];
}

static void SpoilRay(swRay* ray, int number)
{
    switch (number % 8)
    {
    case 0:
        ray->direction = (swVec3){0.0f, 0.0f, 0.0f};
        break;
    case 1:
        ray->direction.y = NAN;
        break;
    case 2:
        ray->direction.z = -INFINITY;
        break;
    case 3:
        ray->maxDistance = NAN;
        break;
    case 4:
        ray->maxDistance = -1.0f;
        break;
    case 5:
        ray->radius = NAN;
        break;
    case 6:
        ray->radius = 1000.0f;
        break;
    default:
        SpoilPlace(&ray->origin, number / 8, false);
        break;
    }
}

// The first is bad: what is counted from the first point must be counted from the first good one.
static void MixAll(swGpuQueryKind kind)
{
    uint32_t seed = 17;
    mix.count = 0;
    for (int good = 0, bad = 0; good < GOOD; ++mix.count)
    {
        double depth = NextPart(&seed);
        swPos origin = {1e5 + 500.0 * NextPart(&seed), 8.0 - 40.0 * depth * depth, 500.0 * NextPart(&seed)};
        origin.y = kind == SW_GPU_QUERY_KIND_RAYS ? origin.y + 30.0 : origin.y;
        swRay ray = swDefaultRay(origin, (swVec3){(float)NextPart(&seed), -0.7f, (float)NextPart(&seed)});
        ray.radius = mix.count % 3 == 0 ? 0.5f : 0.0f;
        bool isBad = mix.count == 0 || (NextPart(&seed) < 0.3 && mix.count - good < GOOD);
        mix.isBad[mix.count] = isBad;
        if (!isBad)
        {
            mix.good[good++] = ray;
        }
        else if (kind == SW_GPU_QUERY_KIND_RAYS)
        {
            SpoilRay(&ray, bad++);
        }
        else
        {
            SpoilPlace(&ray.origin, bad++, kind == SW_GPU_QUERY_KIND_SURFACE);
        }
        mix.all[mix.count] = ray;
    }
}

static swGpuQuery* MakeQuery(Parity* parity, swGpuQueryKind kind)
{
    const uint32_t motion = SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    const uint32_t outputs[] = {SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | motion, motion, SW_GPU_QUERY_NORMAL};
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.kind = kind;
    def.capacity = MOST;
    def.outputs = outputs[kind];
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    return query;
}

static void SetPoints(swGpuQuery* query, int count, const swRay* rays)
{
    static swPos places[MOST];
    static swPosXZ points[MOST];
    for (int i = 0; i < count; ++i)
    {
        places[i] = rays[i].origin;
        points[i] = (swPosXZ){rays[i].origin.x, rays[i].origin.z};
    }
    switch (query->def.kind)
    {
    case SW_GPU_QUERY_KIND_SURFACE:
        swGpuQuery_SetPoints(query, count, points);
        break;
    case SW_GPU_QUERY_KIND_VOLUME:
        swGpuQuery_SetPlaces(query, count, places);
        break;
    default:
        swGpuQuery_SetRays(query, count, rays);
        break;
    }
}

static bool AreAllNaN(const float* values, size_t count)
{
    bool are = true;
    for (size_t i = 0; i < count; ++i)
    {
        are = are && isnan(values[i]);
    }
    return are;
}

static void CheckPlane(const char* what, const void* all, const void* good, size_t size)
{
    assert_true((all == NULL) == (good == NULL));
    const uint8_t* of = good;
    for (int i = 0; i < mix.count && all != NULL; ++i)
    {
        const uint8_t* at = (const uint8_t*)all + (size_t)i * size;
        bool isFine =
            mix.isBad[i] ? AreAllNaN((const float*)(const void*)at, size / sizeof(float)) : memcmp(at, of, size) == 0;
        if (!isFine)
        {
            fail_msg("%s of %s point %d is wrong", what, mix.isBad[i] ? "bad" : "good", i);
        }
        of += mix.isBad[i] ? 0 : size;
    }
}

static void CheckStats(swGpuQueryKind kind, const swGpuQueryResults* results)
{
    static float numbers[2][MOST];
    static swRayHit hits[MOST];
    swQueryStats stats;
    if (kind == SW_GPU_QUERY_KIND_SURFACE)
    {
        const swSurfaceSamples samples = {.height = numbers[0], .residual = numbers[1]};
        swGpuQueryResults_Unpack(results, &samples, &stats);
    }
    else if (kind == SW_GPU_QUERY_KIND_VOLUME)
    {
        const swVolumeSamples samples = {.depth = numbers[0], .pressureHead = numbers[1]};
        swGpuQueryResults_UnpackVolume(results, &samples, &stats);
    }
    else
    {
        swGpuQueryResults_UnpackHits(results, mix.all, hits, &stats);
    }
    for (int i = 0; i < mix.count; ++i)
    {
        bool isNaN = kind == SW_GPU_QUERY_KIND_RAYS
                         ? isnan(hits[i].distance) && isnan(hits[i].point.x) && !hits[i].isHit
                         : isnan(numbers[0][i]) && isnan(numbers[1][i]);
        assert_true(isNaN == mix.isBad[i]);
    }
    assert_int_equal(stats.badCount, mix.count - GOOD);
    assert_int_equal(stats.convergedCount, GOOD);
}

static void CheckAnswers(Parity* parity, const swGpuQuery* all, const swGpuQuery* good)
{
    swGpuQueryResults a, g;
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(all, &a) && swGpuQuery_GetResults(good, &g));
    assert_int_equal(a.count, mix.count);
    assert_int_equal(g.count, GOOD);
    CheckPlane("height", a.heights, g.heights, sizeof(swGpuHeight));
    CheckPlane("depth", a.depths, g.depths, sizeof(swGpuDepth));
    CheckPlane("hit", a.hits, g.hits, sizeof(swGpuHit));
    CheckPlane("sideways", a.sideways, g.sideways, sizeof(swVec2));
    CheckPlane("still", a.stills, g.stills, sizeof(swGpuStill));
    CheckPlane("normal", a.normals, g.normals, sizeof(swVec4));
    CheckPlane("velocity", a.velocities, g.velocities, sizeof(swVec4));
    CheckPlane("acceleration", a.accelerations, g.accelerations, sizeof(swVec4));
    CheckStats(all->def.kind, &a);
}

static Parity OpenSea(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    const swWaveComponent components[] = {{180.0f, 0.3f, 1.5f, 0.2f}, {9.0f, 2.0f, 0.08f, 2.0f}};
    def.method = SW_WAVES_GERSTNER;
    def.components = components;
    def.componentCount = 2;
    AddParitySea(&parity, &def);
    return parity;
}

static void BadPointsOfTheHostAreAnsweredAlone(void** state)
{
    Parity parity = OpenSea(state);
    for (int kind = 0; kind <= SW_GPU_QUERY_KIND_RAYS; ++kind)
    {
        MixAll((swGpuQueryKind)kind);
        swGpuQuery* all = MakeQuery(&parity, (swGpuQueryKind)kind);
        swGpuQuery* good = MakeQuery(&parity, (swGpuQueryKind)kind);
        SetPoints(all, mix.count, mix.all);
        SetPoints(good, GOOD, mix.good);
        StepParity(&parity, 0.7);
        CheckAnswers(&parity, all, good);
        swDestroyGpuQuery(all);
        swDestroyGpuQuery(good);
    }
    FreeParity(&parity);
}

// ---- from a buffer ----

static int CountWords(swGpuQueryKind kind)
{
    const int words[] = {2, 3, 8};
    return words[kind];
}

// Words of a point as SetPointBuffer() has them. A bad one has a bad word instead of one of its own.
static void WriteWords(swGpuQueryKind kind, const swRay* ray, int badNumber, float* to)
{
    float x = (float)(ray->origin.x - 1e5), y = (float)ray->origin.y, z = (float)ray->origin.z;
    const float ofRay[8] = {x,          y, z, ray->maxDistance, ray->direction.x, ray->direction.y, ray->direction.z,
                            ray->radius};
    const float ofPoint[2] = {x, z};
    int words = CountWords(kind);
    memcpy(to, kind == SW_GPU_QUERY_KIND_SURFACE ? ofPoint : ofRay, (size_t)words * sizeof(float));
    if (badNumber >= 0)
    {
        int word = badNumber % words;
        bool isPlace = word < 3;
        float value = badFloats[badNumber % (isPlace ? 6 : 4)]; // of the others only what is no number
        to[word] = word == 1 && kind != SW_GPU_QUERY_KIND_SURFACE && value == 2e11f ? 2e12f : value;
    }
}

static void BadFloatsInABufferAreAnsweredAlone(void** state)
{
    Parity parity = OpenSea(state);
    for (int kind = 0; kind <= SW_GPU_QUERY_KIND_RAYS; ++kind)
    {
        swGpuQueryKind ofKind = (swGpuQueryKind)kind;
        size_t size = (size_t)CountWords(ofKind) * sizeof(float);
        const VkDeviceSize goodAt = 256 * 1024;
        swBuffer buffer;
        assert_int_equal(swCreateBuffer(parity.gpu, 2 * goodAt, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, SW_MEMORY_UPLOAD,
                                        "points", &buffer),
                         SW_SUCCESS);
        MixAll(ofKind);
        uint8_t* data = buffer.mapped;
        for (int i = 0, good = 0, bad = 0; i < mix.count; ++i)
        {
            mix.all[i] = mix.isBad[i] ? mix.good[0] : mix.all[i];
            WriteWords(ofKind, &mix.all[i], mix.isBad[i] ? bad++ : -1, (float*)(void*)(data + (size_t)i * size));
            if (!mix.isBad[i])
            {
                WriteWords(ofKind, &mix.all[i], -1, (float*)(void*)(data + goodAt + (size_t)good++ * size));
            }
        }
        swGpuQuery* all = MakeQuery(&parity, ofKind);
        swGpuQuery* good = MakeQuery(&parity, ofKind);
        swGpuQuery_SetPointBuffer(all, mix.count, buffer.handle, 0, (swPosXZ){1e5, 0.0});
        swGpuQuery_SetPointBuffer(good, GOOD, buffer.handle, goodAt, (swPosXZ){1e5, 0.0});
        StepParity(&parity, 0.7);
        CheckAnswers(&parity, all, good);
        swDestroyGpuQuery(all);
        swDestroyGpuQuery(good);
        StepParity(&parity, 0.1);
        swDestroyBuffer(parity.gpu, &buffer);
    }
    FreeParity(&parity);
}

// ---- the water below ----

// Waves that are too short for a place are left out of its sums, whatever places share its workgroup.
static void NeighboursBelowDoNotMatter(void** state)
{
    Parity parity = OpenSea(state);
    enum
    {
        DEEP = 40
    };
    static swPos mixed[2 * DEEP], deep[DEEP];
    for (int i = 0; i < DEEP; ++i)
    {
        deep[i] = (swPos){3.0 * i, -12.0 - 0.5 * i, 7.0 * i};
        mixed[2 * i] = deep[i];
        mixed[2 * i + 1] = (swPos){3.0 * i, 0.3 * (i % 5) - 0.5, 7.0 * i};
    }
    swGpuQuery* both = MakeQuery(&parity, SW_GPU_QUERY_KIND_VOLUME);
    swGpuQuery* alone = MakeQuery(&parity, SW_GPU_QUERY_KIND_VOLUME);
    swGpuQuery_SetPlaces(both, 2 * DEEP, mixed);
    swGpuQuery_SetPlaces(alone, DEEP, deep);
    StepParity(&parity, 0.7);
    swGpuQueryResults b, a;
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(both, &b) && swGpuQuery_GetResults(alone, &a));
    for (int i = 0; i < DEEP; ++i)
    {
        assert_memory_equal(&b.velocities[2 * i], &a.velocities[i], sizeof(swVec4));
        assert_memory_equal(&b.accelerations[2 * i], &a.accelerations[i], sizeof(swVec4));
        assert_memory_equal(&b.depths[2 * i], &a.depths[i], sizeof(swGpuDepth));
    }
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(BadPointsOfTheHostAreAnsweredAlone),
        cmocka_unit_test(BadFloatsInABufferAreAnsweredAlone),
        cmocka_unit_test(NeighboursBelowDoNotMatter),
    };
    return cmocka_run_group_tests_name("bad points of queries on the GPU", tests, OpenParityGpu, CloseParityGpu);
}
