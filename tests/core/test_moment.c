// SPDX-License-Identifier: MIT
// Moments: the water of any time in memory of its own. It is, to the bit, what a world that steps to that time has; it
// may be asked while the world steps on, and copied or mapped; what it cannot know is said.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/scatter.h"

#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <seaway/seaway.h>

#include "core/world/moment.h"

#define POINTS 120
#define RAYS 12

// All that can be asked, of points around a place. Structs without padding, so that bytes may be compared.
typedef struct Answers
{
    swVec3 displacement[POINTS], normal[POINTS], velocity[POINTS], acceleration[POINTS];
    float height[POINTS], jacobian[POINTS], residual[POINTS];
    swVec3 resting[POINTS];
    swVec2 slopes[POINTS];
    float depth[POINTS], head[POINTS];
    swVec3 below[POINTS];
    float map[POINTS];
    float distance[RAYS];
    swVec2 drift;
} Answers;

static void Ask(const swMoment* moment, const swQueryDef* def, Answers* to)
{
    memset(to, 0, sizeof *to);
    swPosXZ points[POINTS];
    swPos places[POINTS];
    ScatterPoints(points, POINTS, 300.0, -200.0, 500.0);
    for (int i = 0; i < POINTS; ++i)
    {
        places[i] = (swPos){points[i].x, -0.1 * i, points[i].z};
    }
    const swSurfaceSamples surface = {
        .height = to->height,
        .displacement = to->displacement,
        .normal = to->normal,
        .jacobian = to->jacobian,
        .residual = to->residual,
        .velocity = to->velocity,
        .acceleration = to->acceleration,
    };
    swMoment_QuerySurface(moment, def, POINTS, points, &surface, NULL);
    const swSurfaceSamples particles = {.displacement = to->resting};
    swMoment_QueryParticles(moment, def, POINTS, points, &particles, to->slopes, NULL);
    const swVolumeSamples volume = {.depth = to->depth, .velocity = to->below, .pressureHead = to->head};
    swMoment_QueryVolume(moment, def, POINTS, places, &volume, NULL);
    const swHeightMapDef map = {.originX = -20.0, .originZ = 9.0, .spacing = 1.7, .width = 12, .height = POINTS / 12};
    swMoment_QueryHeightMap(moment, def, &map, to->map, NULL);
    for (int i = 0; i < RAYS; ++i)
    {
        swRay ray = swDefaultRay((swPos){10.0 * i, 12.0, 5.0}, (swVec3){1.0f, -0.5f, 0.1f * (float)i});
        swRayHit hit;
        swMoment_CastRays(moment, def, 1, &ray, &hit, NULL);
        to->distance[i] = hit.distance;
    }
    to->drift = swMoment_GetStokesDrift(moment, 1.0);
}

static void AskPlainly(const swMoment* moment, Answers* to)
{
    swQueryDef def = swDefaultQueryDef();
    Ask(moment, &def, to);
}

static void AssertSame(const swMoment* a, const swMoment* b)
{
    static Answers left, right;
    AskPlainly(a, &left);
    AskPlainly(b, &right);
    assert_memory_equal(&left, &right, sizeof left);
    float least = 1e9f, most = -1e9f;
    for (int i = 0; i < POINTS; ++i)
    {
        least = fminf(least, left.height[i]);
        most = fmaxf(most, left.height[i]);
    }
    assert_true(most - least > 0.2f); // there is a sea at all
}

static swWaveSystemDef MakeWaves(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.minWavelength = 1.0f;
    return def;
}

// A wind sea, and what `way` adds: 1 velocities, 2 a swell with parallel tiles, 3 free waves, 4 loops, 5 all of it.
static swWorld* MakeWorld(const swHost* host, int way)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableVelocity = worldDef.enableAcceleration = way == 1 || way == 5;
    worldDef.seaLevel = 1.5;
    swWorld* world;
    assert_int_equal(swCreateWorld(host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = MakeWaves();
    def.loopPeriod = way == 4 ? 12.0f : 0.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    if (way == 2 || way == 5)
    {
        def = MakeWaves();
        def.spectrum = swMakeSwellSpectrum(1.5f, 11.0f, 2.0f, 0.15f);
        def.seed = 77;
        def.weight = 0.8f;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    }
    if (way == 3 || way == 5)
    {
        def = MakeWaves();
        def.method = SW_WAVES_GERSTNER;
        def.seed = 5;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    }
    assert_int_equal(swWorld_Step(world, 20.0), SW_SUCCESS);
    return world;
}

static swMoment* MakeMoment(const swWorld* world, double time)
{
    swMomentDef def = swDefaultMomentDef();
    def.time = time;
    swMoment* moment;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    assert_true(swMoment_GetTime(moment) == time);
    return moment;
}

static const double times[] = {20.0, 20.016666666666667, 3.25, -1e6, 1234567.75};
enum
{
    TIMES = sizeof times / sizeof times[0]
};

static void AMomentIsTheWorldOfThatTimeToTheBit(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    for (int way = 0; way <= 5; ++way)
    {
        swWorld* world = MakeWorld(&host, way);
        swWorld* other = MakeWorld(&host, way);
        swWorld_SetOrigin(world, (swPosXZ){100.0, -50.0});
        swWorld_SetOrigin(other, (swPosXZ){100.0, -50.0});
        for (int i = 0; i < TIMES; ++i)
        {
            swMoment* moment = MakeMoment(world, times[i]);
            assert_int_equal(swWorld_StepTo(other, times[i]), SW_SUCCESS);
            AssertSame(moment, swWorld_GetMoment(other));
            assert_false(swMoment_IsHeld(moment));
            swDestroyMoment(moment);
        }
        swDestroyWorld(world);
        swDestroyWorld(other);
    }
}

// 0: amplitudes alone, so a mix; 1: another seed, so a cross-fade; 2: a weight.
static void Change(swWorld* world, int kind)
{
    const swWaveSystemId first = {1, 1};
    swWaveSystemDef def = swWaveSystem_Get(world, first);
    def.spectrum.windSpeed = kind == 0 ? 17.0f : def.spectrum.windSpeed;
    def.seed = kind == 1 ? 9 : def.seed;
    def.weight = kind == 2 ? 0.25f : def.weight;
    assert_int_equal(swWaveSystem_Set(world, first, &def, 10.0), SW_SUCCESS);
}

static void ChangesUnderWayAreAsFarAsTheyAreThen(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    const double during[] = {12.0, 20.0, 21.0, 24.5, 29.999, 30.0, 31.0};
    for (int kind = 0; kind < 3; ++kind)
    {
        for (int i = 0; i < (int)(sizeof during / sizeof during[0]); ++i)
        {
            swWorld* world = MakeWorld(&host, 0);
            swWorld* other = MakeWorld(&host, 0);
            Change(world, kind);
            Change(other, kind);
            assert_int_equal(swWorld_StepTo(world, 22.0), SW_SUCCESS); // under way
            assert_int_equal(swWorld_StepTo(other, 22.0), SW_SUCCESS);
            uint64_t before = swWorld_GetDigest(world);
            swMoment* moment = MakeMoment(world, during[i]);
            assert_true(swWorld_GetDigest(world) == before);
            assert_int_equal(swWorld_StepTo(other, during[i]), SW_SUCCESS);
            AssertSame(moment, swWorld_GetMoment(other));
            swDestroyMoment(moment);
            swDestroyWorld(world);
            swDestroyWorld(other);
        }
    }
}

static void SettingAMomentAgainAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host, 5);
    Change(world, 0);
    swMoment* moment = MakeMoment(world, 25.0);
    long long allocations = atomic_load(&memory.allocations);
    for (int i = 0; i < TIMES; ++i)
    {
        assert_int_equal(swMoment_Set(moment, world, times[i]), SW_SUCCESS);
        assert_true(swMoment_GetTime(moment) == times[i]);
    }
    assert_int_equal(atomic_load(&memory.allocations), allocations);
    // It outlives the world, and grows with another.
    swDestroyWorld(world);
    static Answers before, after;
    AskPlainly(moment, &before);
    world = MakeWorld(&host, 0);
    swWorld* large = MakeWorld(&host, 5);
    swWaveSystemDef def = MakeWaves();
    def.resolution = 256;
    def.seed = 31;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(large, &def, &id), SW_SUCCESS);
    AskPlainly(moment, &after);
    assert_memory_equal(&before, &after, sizeof before);
    assert_int_equal(swMoment_Set(moment, large, 40.0), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(large, 40.0), SW_SUCCESS);
    AssertSame(moment, swWorld_GetMoment(large));
    swDestroyMoment(moment);
    swDestroyWorld(world);
    swDestroyWorld(large);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void EveryAllocationMayFail(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host, 2);
    long long held = atomic_load(&memory.bytes);
    swMomentDef def = swDefaultMomentDef();
    swMoment* moment = NULL;
    int failures = 0;
    do
    {
        atomic_store(&memory.failAt, atomic_load(&memory.allocations) + failures);
        swResult result = swCreateMoment(world, &def, &moment);
        assert_true(result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY);
        assert_true((moment != NULL) == (result == SW_SUCCESS));
        failures += moment == NULL ? 1 : 0;
        assert_true(moment != NULL || atomic_load(&memory.bytes) == held);
    } while (moment == NULL);
    atomic_store(&memory.failAt, -1);
    assert_int_equal(failures, 3); // the moment, its scratch, its block
    swDestroyMoment(moment);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void TheHostMayGiveTheMemory(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host, 5);
    Change(world, 0);
    size_t size = swWorld_GetMomentSize(world);
    void* room = aligned_alloc(64, (size + 63) / 64 * 64);
    swMomentDef def = swDefaultMomentDef();
    def.memory = room;
    def.memorySize = size;
    def.time = 25.0;
    swMoment* moment;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    size_t used;
    assert_ptr_equal(swMoment_GetMemory(moment, &used), room);
    print_message("a moment takes %zu bytes of %zu\n", used, size);
    assert_true(used <= size && used > size / 2);
    for (int i = 0; i < TIMES; ++i)
    {
        assert_int_equal(swMoment_Set(moment, world, times[i]), SW_SUCCESS);
    }
    // Too much for it: it stays as it was.
    static Answers before, after;
    AskPlainly(moment, &before);
    swWaveSystemDef more = MakeWaves();
    more.seed = 99;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &more, &id), SW_SUCCESS);
    long long messages = atomic_load(&memory.messages);
    assert_int_equal(swMoment_Set(moment, world, 30.0), SW_ERROR_LIMIT);
    assert_int_equal(atomic_load(&memory.messages), messages + 1);
    AskPlainly(moment, &after);
    assert_memory_equal(&before, &after, sizeof before);
    swDestroyMoment(moment);
    def.memorySize = size / 2;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_ERROR_LIMIT);
    assert_null(moment);
    swDestroyWorld(world);
    free(room);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- mapped ----

static void* CopyBlock(const swMoment* moment, size_t* size)
{
    const void* block = swMoment_GetMemory(moment, size);
    void* copy = aligned_alloc(64, (*size + 63) / 64 * 64);
    memcpy(copy, block, *size);
    return copy;
}

static void ACopyElsewhereAnswersTheSame(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    for (int way = 0; way <= 5; way += 5)
    {
        swWorld* world = MakeWorld(&host, way);
        Change(world, 0);
        swMoment* moment = MakeMoment(world, 26.0);
        static Answers wanted, found;
        AskPlainly(moment, &wanted);
        size_t size;
        void* copy = CopyBlock(moment, &size);
        char name[] = "/tmp/moment_XXXXXX";
        int file = mkstemp(name);
        assert_true(file >= 0 && write(file, copy, size) == (ssize_t)size);
        swDestroyMoment(moment);
        swDestroyWorld(world);
        assert_int_equal(swMapMoment(&host, copy, size, &moment), SW_SUCCESS);
        assert_true(swMoment_GetTime(moment) == 26.0);
        AskPlainly(moment, &found);
        assert_memory_equal(&wanted, &found, sizeof wanted);
        swDestroyMoment(moment);
        void* mapped = mmap(NULL, size, PROT_READ, MAP_SHARED, file, 0);
        assert_true(mapped != MAP_FAILED);
        assert_int_equal(swMapMoment(&host, mapped, size, &moment), SW_SUCCESS);
        AskPlainly(moment, &found);
        assert_memory_equal(&wanted, &found, sizeof wanted);
        swDestroyMoment(moment);
        munmap(mapped, size);
        close(file);
        unlink(name);
        free(copy);
    }
}

static void ADamagedHeadIsRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host, 3);
    swMoment* moment = MakeMoment(world, 26.0);
    size_t size;
    uint8_t* copy = CopyBlock(moment, &size);
    swDestroyMoment(moment);
    swDestroyWorld(world);
    for (size_t at = 0; at < 4096; ++at) // head and tiles
    {
        copy[at] ^= 0x41;
        assert_int_equal(swMapMoment(&host, copy, size, &moment), SW_ERROR_FORMAT);
        assert_null(moment);
        copy[at] ^= 0x41;
    }
    const size_t sizes[] = {0, 1, 100, 4096, size / 2, size - 1};
    for (int i = 0; i < 6; ++i)
    {
        assert_int_equal(swMapMoment(&host, copy, sizes[i], &moment), SW_ERROR_FORMAT);
    }
    assert_int_equal(swMapMoment(&host, copy, size, &moment), SW_SUCCESS);
    swDestroyMoment(moment);
    free(copy);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// Whatever numbers stand in the head and the tiles: the block is refused, or it answers something and reads nothing
// beyond itself, which sanitizers watch.
static void WrongNumbersThatAreSignedLeadNowhere(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host, 5);
    swMoment* moment = MakeMoment(world, 26.0);
    size_t size;
    uint8_t* copy = CopyBlock(moment, &size);
    swDestroyMoment(moment);
    swDestroyWorld(world);
    const uint64_t wrong[] = {
        0, 1, 64, (uint64_t)size - 64, (uint64_t)size, UINT64_MAX, (uint64_t)1 << 63, 4000000, 4032, 0x7ff8ull << 48};
    swPosXZ points[40];
    float heights[40];
    ScatterPoints(points, 40, 0.0, 0.0, 1000.0);
    swQueryDef def = swDefaultQueryDef();
    def.maxIterations = 2;
    int mapped = 0, refused = 0;
    for (size_t at = 0; at + 8 <= 2048; at += 4)
    {
        for (int i = 0; i < (int)(sizeof wrong / sizeof wrong[0]); ++i)
        {
            uint64_t kept;
            memcpy(&kept, copy + at, sizeof kept);
            memcpy(copy + at, &wrong[i], at % 8 == 0 ? 8 : 4);
            swSignMoment(copy);
            swResult result = swMapMoment(&host, copy, size, &moment);
            assert_true(result == SW_SUCCESS || result == SW_ERROR_FORMAT);
            if (result == SW_SUCCESS)
            {
                swMoment_QuerySurface(moment, &def, 40, points, &(swSurfaceSamples){.height = heights}, NULL);
                swDestroyMoment(moment);
            }
            mapped += result == SW_SUCCESS ? 1 : 0;
            refused += result == SW_SUCCESS ? 0 : 1;
            memcpy(copy + at, &kept, sizeof kept);
        }
    }
    print_message("%d blocks with a wrong number were refused, %d answered\n", refused, mapped);
    assert_true(refused > mapped / 4 && mapped > 0);
    free(copy);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void AWorldWithoutQueriesHasMomentsOfStillWater(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = false;
    worldDef.seaLevel = 3.0;
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swMoment* moment = MakeMoment(world, 5.0); // of no waves at all
    assert_true(swMoment_GetHeight(moment, 1.0, 2.0) == 3.0);
    swWaveSystemDef def = MakeWaves();
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swMoment_Set(moment, world, 6.0), SW_SUCCESS);
    assert_true(swMoment_GetHeight(moment, 1.0, 2.0) == 3.0);
    size_t size;
    void* copy = CopyBlock(moment, &size);
    swDestroyMoment(moment);
    assert_int_equal(swMapMoment(&host, copy, size, &moment), SW_SUCCESS);
    assert_true(swMoment_GetHeight(moment, 1.0, 2.0) == 3.0);
    swDestroyMoment(moment);
    free(copy);
    swDestroyWorld(world);
}

// ---- threads ----

typedef struct Reader
{
    const swMoment* moment;
    const Answers* wanted;
    atomic_bool* isOver;
    bool isSame;
} Reader;

static void* ReadOn(void* context)
{
    Reader* reader = context;
    Answers* found = malloc(sizeof *found);
    do
    {
        AskPlainly(reader->moment, found);
        reader->isSame = reader->isSame && memcmp(found, reader->wanted, sizeof *found) == 0;
    } while (!atomic_load(reader->isOver));
    free(found);
    return NULL;
}

static void TheWorldStepsOnWhileThreadsAskAMoment(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host, 5);
    Change(world, 0);
    Change(world, 1);
    swMoment* moment = MakeMoment(world, 24.0);
    static Answers wanted;
    AskPlainly(moment, &wanted);
    atomic_bool isOver = false;
    pthread_t threads[3];
    Reader readers[3];
    for (int i = 0; i < 3; ++i)
    {
        readers[i] = (Reader){moment, &wanted, &isOver, true};
        assert_int_equal(pthread_create(&threads[i], NULL, ReadOn, &readers[i]), 0);
    }
    swMoment* later = MakeMoment(world, 24.0);
    for (int i = 0; i < 40; ++i)
    {
        assert_int_equal(swWorld_Step(world, 0.5), SW_SUCCESS);
        assert_int_equal(swMoment_Set(later, world, 20.0 + i), SW_SUCCESS);
    }
    atomic_store(&isOver, true);
    for (int i = 0; i < 3; ++i)
    {
        pthread_join(threads[i], NULL);
        assert_true(readers[i].isSame);
    }
    swDestroyMoment(later);
    swDestroyMoment(moment);
    swDestroyWorld(world);
}

typedef struct Maker
{
    const swWorld* world;
    uint32_t seed;
    float height;
} Maker;

static void* MakeOne(void* context)
{
    Maker* maker = context;
    swMomentDef def = swDefaultMomentDef();
    def.time = 25.0;
    swMoment* moment = NULL;
    if (swCreateMoment(maker->world, &def, &moment) == SW_SUCCESS)
    {
        maker->height = (float)swMoment_GetHeight(moment, 1.0, 2.0);
    }
    swDestroyMoment(moment);
    return NULL;
}

static void ThreadsMayMakeMomentsOfOneWorldAtOnce(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host, 5);
    Change(world, 0);
    pthread_t threads[4];
    Maker makers[4];
    for (int i = 0; i < 4; ++i)
    {
        makers[i] = (Maker){.world = world};
        assert_int_equal(pthread_create(&threads[i], NULL, MakeOne, &makers[i]), 0);
    }
    swWorld* other = MakeWorld(&host, 5);
    Change(other, 0);
    swWorld_StepTo(other, 25.0);
    float wanted = (float)swMoment_GetHeight(swWorld_GetMoment(other), 1.0, 2.0);
    for (int i = 0; i < 4; ++i)
    {
        pthread_join(threads[i], NULL);
        assert_true(makers[i].height == wanted);
    }
    swDestroyWorld(world);
    swDestroyWorld(other);
}

// ---- between two moments ----

// Root mean square of the difference to a moment of that time, over that of the heights.
static double FindBetweenError(float shortest, double dt)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = shortest;
    def.maxWavelength = shortest * 2.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swMoment* first = MakeMoment(world, 50.0);
    swMoment* last = MakeMoment(world, 50.0 + dt);
    swMoment* middle = MakeMoment(world, 50.0 + 0.5 * dt);
    static swPosXZ points[2000];
    static swVec3 blended[2000], exact[2000];
    ScatterPoints(points, 2000, 0.0, 0.0, 300.0);
    swQueryDef query = swDefaultQueryDef();
    swMoment_QueryParticles(middle, &query, 2000, points, &(swSurfaceSamples){.displacement = exact}, NULL, NULL);
    query.time = 50.0 + 0.5 * dt;
    query.after = last;
    swMoment_QueryParticles(first, &query, 2000, points, &(swSurfaceSamples){.displacement = blended}, NULL, NULL);
    double error = 0.0, all = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
        error += ((double)blended[i].y - (double)exact[i].y) * ((double)blended[i].y - (double)exact[i].y);
        all += (double)exact[i].y * (double)exact[i].y;
    }
    swDestroyMoment(first);
    swDestroyMoment(last);
    swDestroyMoment(middle);
    swDestroyWorld(world);
    return sqrt(error / all);
}

static void BetweenTwoMomentsTheErrorIsThatOfAChord(void** state)
{
    (void)state;
    const float lengths[] = {0.0625f, 0.25f, 1.0f, 4.0f, 16.0f};
    for (int i = 0; i < 5; ++i)
    {
        for (int rate = 30; rate <= 60; rate *= 2)
        {
            double omega = sqrt(9.81 * 2.0 * SW_PI / (double)lengths[i]);
            double bound = omega / rate * omega / rate / 8.0;
            double error = FindBetweenError(lengths[i], 1.0 / rate);
            print_message("waves of %6.4f to %6.4f m, steps of 1/%d s: %.3f %% of the height, bound %.3f %%\n",
                          (double)lengths[i], 2.0 * (double)lengths[i], rate, 100.0 * error, 100.0 * bound);
            assert_true(error < 1.1 * bound + 1e-5 && error > 0.3 * bound);
        }
    }
}

static void AtBothEndsBetweenIsTheMomentItself(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host, 5);
    swMoment* first = MakeMoment(world, 30.0);
    swMoment* last = MakeMoment(world, 30.0 + 1.0 / 60.0);
    static Answers wanted, found;
    swQueryDef def = swDefaultQueryDef();
    def.after = last;
    AskPlainly(first, &wanted);
    Ask(first, &def, &found);
    assert_memory_equal(&wanted, &found, sizeof wanted);
    // At the later end the bits are those of a sum a + (b - a); outside it is as without.
    def.time = swMoment_GetTime(last);
    AskPlainly(last, &wanted);
    Ask(first, &def, &found);
    for (int i = 0; i < POINTS; ++i)
    {
        assert_float_equal(found.height[i], wanted.height[i], 1e-4);
        assert_float_equal(found.velocity[i].x, wanted.velocity[i].x, 1e-3);
        assert_float_equal(found.normal[i].y, wanted.normal[i].y, 1e-3);
    }
    def.time = 31.0;
    Ask(first, &def, &found);
    def.after = NULL;
    Ask(first, &def, &wanted);
    assert_memory_equal(&wanted, &found, sizeof wanted);
    swDestroyMoment(first);
    swDestroyMoment(last);
    swDestroyWorld(world);
}

static void AShotThatTakesTimeMeetsTheSameWaterBetweenMoments(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host, 0);
    swMoment* first = MakeMoment(world, 30.0);
    swMoment* last = MakeMoment(world, 30.0 + 1.0 / 30.0);
    swQueryDef summed = swDefaultQueryDef();
    swQueryDef blended = summed;
    blended.after = last;
    int hits = 0;
    for (int i = 0; i < 20; ++i)
    {
        swRay ray = swDefaultRay((swPos){3.0 * i, 10.0, -4.0 * i}, (swVec3){1.0f, -0.6f, 0.2f});
        ray.maxDistance = 40.0f;
        ray.duration = 1.0f / 30.0f;
        swRayHit wanted, found;
        swMoment_CastRays(first, &summed, 1, &ray, &wanted, NULL);
        swMoment_CastRays(first, &blended, 1, &ray, &found, NULL);
        assert_true(wanted.isHit == found.isHit);
        hits += wanted.isHit ? 1 : 0;
        assert_float_equal(wanted.distance, found.distance, 0.02); // tiles are a spline through the waves
    }
    assert_true(hits > 10);
    swDestroyMoment(first);
    swDestroyMoment(last);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AMomentIsTheWorldOfThatTimeToTheBit),
        cmocka_unit_test(ChangesUnderWayAreAsFarAsTheyAreThen),
        cmocka_unit_test(SettingAMomentAgainAllocatesNothing),
        cmocka_unit_test(EveryAllocationMayFail),
        cmocka_unit_test(TheHostMayGiveTheMemory),
        cmocka_unit_test(ACopyElsewhereAnswersTheSame),
        cmocka_unit_test(ADamagedHeadIsRefused),
        cmocka_unit_test(WrongNumbersThatAreSignedLeadNowhere),
        cmocka_unit_test(AWorldWithoutQueriesHasMomentsOfStillWater),
        cmocka_unit_test(TheWorldStepsOnWhileThreadsAskAMoment),
        cmocka_unit_test(ThreadsMayMakeMomentsOfOneWorldAtOnce),
        cmocka_unit_test(BetweenTwoMomentsTheErrorIsThatOfAChord),
        cmocka_unit_test(AtBothEndsBetweenIsTheMomentItself),
        cmocka_unit_test(AShotThatTakesTimeMeetsTheSameWaterBetweenMoments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
