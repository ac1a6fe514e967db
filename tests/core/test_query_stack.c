// SPDX-License-Identifier: MIT
// A query takes at most SW_QUERY_STACK bytes of its caller's stack, so that fibres with small stacks may ask. Each
// query runs on a stack of its own of just that size with a page below it that cannot be touched, and the stack is
// painted before, so that what was used can be told.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>

#include "core/frame/frame.h"
#include "seaway/seaway.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define HAS_SANITIZER 1
#endif
#endif

#define PAGE 4096
#define PAINT 0xa5
#define POINTS 300

typedef void (*Ask)(const swWorld* world, const swQueryDef* def);

static swPosXZ points[POINTS];
static swPos places[POINTS];
static swRay rays[POINTS];
static float numbers[3][POINTS];
static swVec3 vectors[4][POINTS];
static swVec2 slopes[POINTS];
static swRayHit hits[POINTS];
static swSurfaceHint hints[POINTS];

static void AskHeights(const swWorld* world, const swQueryDef* def)
{
    const swSurfaceSamples samples = {.height = numbers[0]};
    swMoment_QuerySurface(swWorld_GetMoment(world), def, POINTS, points, &samples, NULL);
}

static bool clipped[POINTS];

static void AskSurface(const swWorld* world, const swQueryDef* def)
{
    const swSurfaceSamples samples = {numbers[0], vectors[0], vectors[1], numbers[1], numbers[2],
                                      vectors[2], vectors[3], hints,      clipped};
    swQueryStats stats;
    swMoment_QuerySurface(swWorld_GetMoment(world), def, POINTS, points, &samples, &stats);
}

static void AskParticles(const swWorld* world, const swQueryDef* def)
{
    const swSurfaceSamples samples = {numbers[0], vectors[0], vectors[1], numbers[1], numbers[2],
                                      vectors[2], vectors[3], NULL,       clipped};
    swQueryStats stats;
    swMoment_QueryParticles(swWorld_GetMoment(world), def, POINTS, points, &samples, slopes, &stats);
}

static void AskMap(const swWorld* world, const swQueryDef* def)
{
    const swHeightMapDef map = {.spacing = 0.7, .width = 75, .height = 4};
    swMoment_QueryHeightMap(swWorld_GetMoment(world), def, &map, numbers[0], NULL);
}

static void AskHeight(const swWorld* world, const swQueryDef* def)
{
    (void)def;
    numbers[0][0] = (float)swMoment_GetHeight(swWorld_GetMoment(world), 3.0, 4.0);
}

static void AskVolume(const swWorld* world, const swQueryDef* def)
{
    const swVolumeSamples samples = {
        .depth = numbers[0], .velocity = vectors[0], .acceleration = vectors[1], .pressureHead = numbers[1]};
    swMoment_QueryVolume(swWorld_GetMoment(world), def, POINTS, places, &samples, NULL);
}

static void AskDrift(const swWorld* world, const swQueryDef* def)
{
    (void)def;
    slopes[0] = swMoment_GetStokesDrift(swWorld_GetMoment(world), 1.0);
}

static void AskRays(const swWorld* world, const swQueryDef* def)
{
    for (int i = 0; i < POINTS; ++i)
    {
        rays[i].duration = 0.0f;
    }
    swMoment_CastRays(swWorld_GetMoment(world), def, POINTS, rays, hits, NULL);
}

static void AskMovingRays(const swWorld* world, const swQueryDef* def)
{
    for (int i = 0; i < 10; ++i)
    {
        rays[i].duration = 3.0f;
    }
    swMoment_CastRays(swWorld_GetMoment(world), def, 10, rays, hits, NULL);
}

static const struct
{
    const char* name;
    Ask ask;
} asks[] = {
    {"heights", AskHeights}, {"surface", AskSurface}, {"particles", AskParticles},
    {"map", AskMap},         {"height", AskHeight},   {"volume", AskVolume},
    {"drift", AskDrift},     {"rays", AskRays},       {"moving rays", AskMovingRays},
};

#define ASKS (int)(sizeof asks / sizeof asks[0])

// ---- a stack of its own ----

typedef struct Fibre
{
    ucontext_t caller, context;
    const swWorld* world;
    const swQueryDef* def;
    Ask ask;
} Fibre;

static Fibre fibre;

static void RunFibre(void)
{
    fibre.ask(fibre.world, fibre.def);
}

// Bytes of the stack that were touched.
static size_t RunOnStack(uint8_t* stack, size_t size)
{
    memset(stack, PAINT, size);
    assert_int_equal(getcontext(&fibre.context), 0);
    fibre.context.uc_stack.ss_sp = stack;
    fibre.context.uc_stack.ss_size = size;
    fibre.context.uc_link = &fibre.caller;
    makecontext(&fibre.context, RunFibre, 0);
    assert_int_equal(swapcontext(&fibre.caller, &fibre.context), 0);
    size_t untouched = 0;
    while (untouched < size && stack[untouched] == PAINT)
    {
        untouched += 1;
    }
    return size - untouched;
}

// Everything that shapes waves, at some of the points.
static void ShapeSea(swWorld* world, swWaveSystemId id)
{
    const swInputField fields[4] = {SW_INPUT_FLOOR, SW_INPUT_LEVEL, SW_INPUT_FLOW, SW_INPUT_WAVES};
    const float values[4] = {-5.0f, 2.0f, 1.5f, 0.5f};
    for (int i = 0; i < 4; ++i)
    {
        swInputDef def = swDefaultInputDef();
        def.field = fields[i];
        def.shape = SW_SHAPE_CIRCLE;
        def.size.x = 700.0f;
        def.feather = 100.0f;
        def.value[0] = values[i];
        def.system = id;
        swInputId input;
        assert_int_equal(swCreateInput(world, &def, &input), SW_SUCCESS);
    }
}

static swWorld* OpenSea(swIsa isa, bool hasMotion, bool isShaped)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.isa = isa;
    worldDef.enableVelocity = worldDef.enableAcceleration = hasMotion;
    swWorld* world = NULL;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
    {
        return NULL; // not on this machine
    }
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.minWavelength = 2.0f;
    def.spectrum.depth = 60.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    def.method = SW_WAVES_GERSTNER;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    if (isShaped)
    {
        ShapeSea(world, id);
    }
    assert_int_equal(swWorld_Step(world, 10.0), SW_SUCCESS);
    return world;
}

static void MakePoints(void)
{
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){3.7 * i - 500.0, 0.01 * i * i};
        places[i] = (swPos){points[i].x, -0.1 * (i % 50), points[i].z};
        rays[i] = swDefaultRay((swPos){points[i].x, 20.0, points[i].z}, (swVec3){0.3f, -1.0f, 0.2f});
        rays[i].radius = i % 2 == 0 ? 0.0f : 0.4f;
    }
}

static const char* const timeNames[] = {"now", "at 5 s", "between"};

static void NoQueryTakesMoreThanItsStack(void** state)
{
    (void)state;
#if defined(HAS_SANITIZER)
    print_message("sanitizers make stacks larger: nothing to tell\n");
    skip();
#endif
#if defined(__OPTIMIZE__)
    size_t allowed = SW_QUERY_STACK;
#else
    size_t allowed = 2 * SW_QUERY_STACK;
#endif
    size_t size = getenv("SW_STACK_PROBE") != NULL ? 1 << 20 : allowed;
    uint8_t* memory = mmap(NULL, size + PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(memory != MAP_FAILED);
    assert_int_equal(mprotect(memory, PAGE, PROT_NONE), 0);
    MakePoints();
    size_t most = 0;
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        for (int kind = 0; kind < 12; ++kind)
        {
            bool hasMotion = kind / 3 % 2 == 0, isShaped = kind >= 6;
            if (isShaped && kind % 3 == 2)
            {
                continue; // moments do not hold inputs yet
            }
            swWorld* world = OpenSea((swIsa)isa, hasMotion, isShaped);
            swQueryDef def = swDefaultQueryDef();
            def.time = kind % 3 == 0 ? SW_QUERY_NOW : kind % 3 == 1 ? 5.0 : 10.01;
            swMomentDef laterDef = swDefaultMomentDef();
            laterDef.time = 14.0;
            swMoment* later = NULL;
            if (world != NULL && kind % 3 == 2)
            {
                assert_int_equal(swCreateMoment(world, &laterDef, &later), SW_SUCCESS);
            }
            def.after = later;
            for (int i = 0; i < ASKS && world != NULL; ++i)
            {
                fibre = (Fibre){.world = world, .def = &def, .ask = asks[i].ask};
                size_t used = RunOnStack(memory + PAGE, size);
                print_message("%-7s %-6s %-10s %-8s %-12s %6zu bytes\n", swIsa_GetName((swIsa)isa),
                              isShaped ? "shaped" : "plain", hasMotion ? "motion" : "no motion", timeNames[kind % 3],
                              asks[i].name, used);
                most = used > most ? used : most;
            }
            swDestroyMoment(later);
            swDestroyWorld(world);
        }
    }
    munmap(memory, size + PAGE);
    print_message("at most %zu bytes; %zu are allowed\n", most, allowed);
    assert_true(most <= allowed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NoQueryTakesMoreThanItsStack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
