// SPDX-License-Identifier: MIT

// Worlds as bytes: what is restored goes on with the same bits.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "core/world/world.h"
#include "support/counting_host.h"
#include "support/saved.h"
#include <seaway/seaway.h>

enum
{
    POINTS = 100
};

static swRestoreDef restoreDef;

static swWaveSystemDef MakeDef(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.minWavelength = 2.0f;
    return def;
}

// Tiles, free waves by spectrum and by hand, a table, a system that was destroyed, a view with foam, an origin.
static swWorld* MakeWorld(const swHost* host)
{
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = 2.5;
    worldDef.enableVelocity = true;
    swWorld* world;
    assert_int_equal(swCreateWorld(host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = MakeDef();
    swWaveSystemId id, gone;
    assert_int_equal(swCreateWaveSystem(world, &def, &gone), SW_SUCCESS);
    def.seed = 7;
    def.loopPeriod = 300.0f;
    def.spectrum.growth = SW_GROWTH_CUBE_ROOT;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swDestroyWaveSystem(world, gone);
    def = MakeDef();
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 3;
    def.leastJacobian = 0.8f;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    const swWaveComponent wave = {60.0f, 1.0f, 0.3f, 0.2f};
    def.components = &wave;
    def.componentCount = 1;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    const float frequencies[3] = {0.1f, 0.15f, 0.2f}, widths[3] = {0.05f, 0.05f, 0.05f};
    float density[3 * 4] = {0.1f, 0.5f, 0.1f, 0.0f, 0.2f, 0.9f, 0.2f, 0.0f, 0.1f, 0.4f, 0.1f, 0.0f};
    swSpectrumTable table = {
        .frequencyCount = 3, .directionCount = 4, .frequencies = frequencies, .bandwidths = widths, .density = density};
    def = MakeDef();
    def.spectrum.kind = SW_SPECTRUM_TABLE;
    def.spectrum.table = &table;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 3;
    viewDef.resolution = 64;
    viewDef.enableCpuLayers = true;
    swView* view;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    swView_SetViewpoint(view, (swPos){10.0, 30.0, -4.0});
    for (int i = 0; i < 20; ++i)
    {
        swWorld_Step(world, 0.05);
    }
    return world;
}

static swWaveSystemId GetSystem(const swWorld* world, int slot)
{
    return (swWaveSystemId){slot + 1, world->systemIds.generations[slot]};
}

static swWorld* SaveAndRestore(const swWorld* world, swIsa isa)
{
    size_t size = 0;
    assert_int_equal(swWorld_Save(world, NULL, &size), SW_SUCCESS);
    void* data = malloc(size);
    assert_non_null(data);
    assert_int_equal(swWorld_Save(world, data, &size), SW_SUCCESS);
    swHost host = swDefaultHost();
    swWorld* restored = NULL;
    swRestoreDef def = swDefaultRestoreDef();
    def.isa = isa;
    assert_int_equal(swRestoreWorld(&host, data, size, &def, &restored), SW_SUCCESS);
    size_t again = size;
    void* other = malloc(size);
    assert_non_null(other);
    assert_int_equal(swWorld_Save(restored, other, &again), SW_SUCCESS);
    assert_int_equal(again, size);
    assert_memory_equal(data, other, size);
    free(data);
    free(other);
    return restored;
}

// Of a layer that may not be held.
static void CompareTexels(const float* a, const float* b, size_t count)
{
    assert_int_equal(a == NULL, b == NULL);
    if (a != NULL)
    {
        assert_memory_equal(a, b, count * sizeof(float));
    }
}

static void CompareWorlds(swWorld* a, swWorld* b)
{
    assert_int_equal(swWorld_GetDigest(a), swWorld_GetDigest(b));
    swPosXZ points[POINTS];
    float heights[2][POINTS];
    swVec3 velocities[2][POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){3.7 * i - 100.0, 0.9 * i * i};
    }
    for (int k = 0; k < 2; ++k)
    {
        swQueryDef def = swDefaultQueryDef();
        swSurfaceSamples samples = {.height = heights[k], .velocity = velocities[k]};
        swMoment_QuerySurface(swWorld_GetMoment(k == 0 ? a : b), &def, POINTS, points, &samples, NULL);
    }
    assert_memory_equal(heights[0], heights[1], sizeof heights[0]);
    assert_memory_equal(velocities[0], velocities[1], sizeof velocities[0]);
    assert_int_equal(swWorld_GetViewCount(a), swWorld_GetViewCount(b));
    for (int v = 0; v < swWorld_GetViewCount(a); ++v)
    {
        swView *va = swWorld_GetView(a, v), *vb = swWorld_GetView(b, v);
        for (int slice = 0; slice < swView_GetSliceCount(va); ++slice)
        {
            size_t texels = (size_t)64 * 64;
            assert_memory_equal(swView_GetDisplacement(va, slice), swView_GetDisplacement(vb, slice),
                                texels * 4 * sizeof(float));
            assert_memory_equal(swView_GetFoam(va, slice), swView_GetFoam(vb, slice), texels * sizeof(float));
            CompareTexels(swView_GetWakeFoam(va, slice), swView_GetWakeFoam(vb, slice), texels);
            CompareTexels(swView_GetShoreFoam(va, slice), swView_GetShoreFoam(vb, slice), texels);
        }
    }
}

static void GoOnTogether(swWorld* a, swWorld* b)
{
    for (int step = 0; step < 40; ++step)
    {
        swWorld* worlds[2] = {a, b};
        for (int k = 0; k < 2; ++k)
        {
            swView_SetViewpoint(swWorld_GetView(worlds[k], 0), (swPos){10.0 + 0.3 * step, 30.0 + step, -4.0});
            assert_int_equal(swWorld_Step(worlds[k], 0.11), SW_SUCCESS);
        }
        if (step % 8 == 0)
        {
            CompareWorlds(a, b);
        }
    }
    CompareWorlds(a, b);
}

static void ARestoredWorldGoesOnWithTheSameBits(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host);
    swWorld* restored = SaveAndRestore(world, SW_ISA_SCALAR);
    CompareWorlds(world, restored);
    for (int slot = 0; slot < 4; ++slot)
    {
        assert_int_equal(swWaveSystem_IsValid(world, GetSystem(world, slot)),
                         swWaveSystem_IsValid(restored, GetSystem(world, slot)));
    }
    GoOnTogether(world, restored);
    swDestroyWorld(world);
    swDestroyWorld(restored);
}

static void ChangesUnderWayGoOn(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host);
    swWaveSystemId id = GetSystem(world, 1);
    swWaveSystemDef def = swWaveSystem_Get(world, id);
    def.spectrum.windSpeed = 15.0f;
    def.weight = 0.6f;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 3.0), SW_SUCCESS); // a mix
    swWorld_Step(world, 0.7);
    def.spectrum.direction = 1.0f;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 3.0), SW_SUCCESS); // a mix of a mix
    def.seed = 12;
    swWorld_Step(world, 0.4);
    assert_int_equal(swWaveSystem_Set(world, id, &def, 2.0), SW_SUCCESS); // a cross-fade over both
    swWorld_Step(world, 0.5);
    swWorld* restored = SaveAndRestore(world, SW_ISA_BEST);
    CompareWorlds(world, restored);
    GoOnTogether(world, restored);
    swDestroyWorld(world);
    swDestroyWorld(restored);
}

// A shoal, an input that makes foam, and a stream that carries both.
static swInputId AddFoamMakers(swWorld* world)
{
    swInputDef shoal = swDefaultInputDef(), maker = swDefaultInputDef(), stream = swDefaultInputDef();
    shoal.shape = maker.shape = stream.shape = SW_SHAPE_CIRCLE;
    shoal.size = (swVec3){60.0f, 0.0f, 60.0f};
    shoal.feather = 28.0f;
    shoal.value[0] = 3.0f;
    maker.field = SW_INPUT_FOAM;
    maker.size = (swVec3){12.0f, 0.0f, 12.0f};
    maker.value[0] = 1.5f;
    stream.field = SW_INPUT_FLOW;
    stream.size = (swVec3){40.0f, 0.0f, 40.0f};
    stream.feather = 15.0f;
    stream.value[0] = 1.2f;
    swInputId id, makerId;
    assert_int_equal(swCreateInput(world, &shoal, &id), SW_SUCCESS);
    assert_int_equal(swCreateInput(world, &stream, &id), SW_SUCCESS);
    assert_int_equal(swCreateInput(world, &maker, &makerId), SW_SUCCESS);
    return makerId;
}

static float SumFoam(const float* texels)
{
    float sum = 0.0f;
    for (int i = 0; i < 64 * 64; ++i)
    {
        sum += texels[i];
    }
    return sum;
}

// Foam of inputs and shores has a past as whitecaps have: also where the inputs are gone, and what they made is left.
static void FoamOfInputsAndShoresGoesOnWhereItWas(void** state)
{
    (void)state;
    for (int kind = 0; kind < 2; ++kind)
    {
        swHost host = swDefaultHost();
        swWorld* world = MakeWorld(&host);
        swInputId maker = AddFoamMakers(world);
        for (int i = 0; i < 20; ++i)
        {
            swWorld_Step(world, 0.05);
        }
        if (kind == 1)
        {
            swDestroyInput(world, maker);
            swWorld_Step(world, 0.05);
        }
        assert_true(SumFoam(swView_GetWakeFoam(swWorld_GetView(world, 0), 0)) > 1.0f);
        assert_true(SumFoam(swView_GetShoreFoam(swWorld_GetView(world, 0), 0)) > 1.0f);
        swWorld* restored = SaveAndRestore(world, SW_ISA_BEST);
        CompareWorlds(world, restored);
        GoOnTogether(world, restored);
        swDestroyWorld(world);
        swDestroyWorld(restored);
    }
}

static void FoamOfInputsAndShoresGoesBack(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host);
    AddFoamMakers(world);
    for (int i = 0; i < 20; ++i)
    {
        swWorld_Step(world, 0.05);
    }
    size_t size = 0;
    assert_int_equal(swWorld_Save(world, NULL, &size), SW_SUCCESS);
    void* data = malloc(size);
    assert_non_null(data);
    assert_int_equal(swWorld_Save(world, data, &size), SW_SUCCESS);
    swWorld* restored = SaveAndRestore(world, SW_ISA_BEST);
    for (int i = 0; i < 30; ++i)
    {
        swWorld_Step(world, 0.05);
    }
    assert_int_equal(swWorld_Rewind(world, data, size), SW_SUCCESS);
    CompareWorlds(world, restored);
    GoOnTogether(world, restored);
    free(data);
    swDestroyWorld(world);
    swDestroyWorld(restored);
}

// Foam of a first step has no past, whether a save came before it or not.
static void AViewMadeSinceTheLastStepHasNoPast(void** state)
{
    (void)state;
    for (int stepCount = 0; stepCount < 2; ++stepCount)
    {
        swHost host = swDefaultHost();
        swWorldDef worldDef = swDefaultWorldDef();
        swWorld* world;
        assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.spectrum.windSpeed = 25.0f; // foam everywhere
        def.chop = 1.6f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        for (int i = 0; i < stepCount; ++i)
        {
            swWorld_Step(world, 1.0);
        }
        swViewDef viewDef = swDefaultViewDef();
        viewDef.sliceCount = 3;
        viewDef.resolution = 64;
        viewDef.enableCpuLayers = true;
        swView* view;
        assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
        swWorld* restored = SaveAndRestore(world, SW_ISA_BEST);
        swWorld_Step(world, 0.5);
        swWorld_Step(restored, 0.5);
        CompareWorlds(world, restored);
        swDestroyWorld(world);
        swDestroyWorld(restored);
    }
}

static void DamagedBytesAreRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host);
    size_t size = 0;
    swWorld_Save(world, NULL, &size);
    unsigned char* data = malloc(size);
    assert_non_null(data);
    size_t less = size - 1;
    assert_int_equal(swWorld_Save(world, data, &less), SW_ERROR_LIMIT);
    assert_int_equal(swWorld_Save(world, data, &size), SW_SUCCESS);
    swDestroyWorld(world);
    swWorld* restored;
    for (size_t at = 0; at < size; at += 1 + at / 7)
    {
        data[at] ^= 0x10;
        assert_int_equal(swRestoreWorld(&host, data, size, &restoreDef, &restored), SW_ERROR_FORMAT);
        assert_null(restored);
        data[at] ^= 0x10;
        assert_int_equal(swRestoreWorld(&host, data, at, &restoreDef, &restored), SW_ERROR_FORMAT);
    }
    for (int fail = 0;; ++fail)
    {
        assert_true(fail < 1000);
        atomic_store(&memory.failAt, atomic_load(&memory.allocations) + fail);
        swResult result = swRestoreWorld(&host, data, size, &restoreDef, &restored);
        atomic_store(&memory.failAt, -1);
        if (result == SW_SUCCESS)
        {
            break;
        }
        assert_int_equal(result, SW_ERROR_NO_MEMORY);
    }
    swDestroyWorld(restored);
    free(data);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- back to a state of the same world ----

static void ExpectSaved(const swWorld* world, const Saved* wanted)
{
    Saved now = Save(world);
    assert_int_equal(now.size, wanted->size);
    assert_memory_equal(now.data, wanted->data, now.size);
    free(now.data);
}

static void StepSome(swWorld* world, int count)
{
    for (int i = 0; i < count; ++i)
    {
        swView_SetViewpoint(swWorld_GetView(world, 0), (swPos){10.0 + 7.0 * i, 30.0 + 9.0 * i, -4.0});
        assert_int_equal(swWorld_Step(world, 0.07), SW_SUCCESS);
    }
}

static void ARollBackGoesOnWithTheSameBits(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host);
    swWaveSystemId id = GetSystem(world, 1);
    swWaveSystemDef def = swWaveSystem_Get(world, id);
    def.spectrum.windSpeed = 15.0f;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 30.0), SW_SUCCESS); // a mix all the while
    def.seed = 12;
    StepSome(world, 2);
    assert_int_equal(swWaveSystem_Set(world, id, &def, 30.0), SW_SUCCESS); // and a cross-fade
    StepSome(world, 2);
    swWaveSystem_FadeWeight(world, id, 0.3f, 0.4);
    Saved then = Save(world);
    uint64_t digest = swWorld_GetDigest(world);
    StepSome(world, 12);
    Saved wanted = Save(world);
    swFoamDef foam = swDefaultFoamDef();
    foam.fadeRate = 2.0f;
    swWorld_SetFoam(world, &foam);
    swWaveSystem_SetWeight(world, id, 2.0f);
    swWorld_SetOrigin(world, (swPosXZ){1e5, 3.0});
    def.seed = 99;
    swWaveSystemId late;
    assert_int_equal(swCreateWaveSystem(world, &def, &late), SW_SUCCESS);
    StepSome(world, 7);
    swWorld_SetTime(world, 12.0);
    StepSome(world, 3);
    int allocations = atomic_load(&memory.allocations);
    for (int i = 0; i < 2; ++i)
    {
        assert_int_equal(swWorld_Rewind(world, then.data, then.size), SW_SUCCESS);
        assert_int_equal(swWorld_GetDigest(world), digest);
        ExpectSaved(world, &then);
        assert_false(swWaveSystem_IsValid(world, late));
        StepSome(world, 12);
        ExpectSaved(world, &wanted);
    }
    assert_int_equal(atomic_load(&memory.allocations), allocations);
    free(then.data);
    free(wanted.data);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void ExpectRefusal(swWorld* world, const Saved* saved, swResult wanted)
{
    Saved before = Save(world);
    assert_int_equal(swWorld_Rewind(world, saved->data, saved->size), wanted);
    ExpectSaved(world, &before);
    free(before.data);
}

static void WhatAWorldNoLongerHasItDoesNotGoBackTo(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host);
    Saved then = Save(world);
    swWaveSystemId id = GetSystem(world, 1);
    swWaveSystemDef def = swWaveSystem_Get(world, id);
    def.seed = 99;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 0.0), SW_SUCCESS);
    StepSome(world, 2);
    ExpectRefusal(world, &then, SW_ERROR_UNSUPPORTED);
    def.seed = 7;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 0.0), SW_SUCCESS);
    StepSome(world, 2);
    swViewDef viewDef = swDefaultViewDef();
    swView* view;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    ExpectRefusal(world, &then, SW_ERROR_UNSUPPORTED);
    swDestroyView(view);
    assert_int_equal(swWorld_Rewind(world, then.data, then.size), SW_SUCCESS); // the same waves, made anew
    ExpectSaved(world, &then);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* other;
    assert_int_equal(swCreateWorld(&host, &worldDef, &other), SW_SUCCESS);
    ExpectRefusal(other, &then, SW_ERROR_UNSUPPORTED);
    then.data[then.size / 2] ^= 1;
    ExpectRefusal(world, &then, SW_ERROR_FORMAT);
    swDestroyWorld(other);
    swDestroyWorld(world);
    free(then.data);
}

// ---- crafted bytes ----

// Whatever float of a state is no number: refused, or without effect on the surface.
static void NoNumbersAreLetIn(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    host.log = NULL;
    swWorld* world = MakeWorld(&host);
    swWaveSystemId id = GetSystem(world, 1);
    swWaveSystemDef def = swWaveSystem_Get(world, id);
    def.spectrum.windSpeed = 15.0f;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 30.0), SW_SUCCESS);
    StepSome(world, 2);
    Saved saved = Save(world);
    static const unsigned char nan[4] = {0, 0, 0xc0, 0x7f};
    int refused = 0, tried = 0;
    for (size_t at = 30; at + 12 < saved.size; at += 1 + saved.size / 100)
    {
        unsigned char kept[4];
        memcpy(kept, saved.data + at, 4);
        memcpy(saved.data + at, nan, 4);
        Sign(&saved);
        swWorld* restored = NULL;
        tried += 1;
        if (swRestoreWorld(&host, saved.data, saved.size, &restoreDef, &restored) == SW_SUCCESS)
        {
            swWorld_Step(restored, 0.1);
            assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(restored), 1.0, 2.0)));
            const float* foam = swView_GetFoam(swWorld_GetView(restored, 0), 0);
            for (int i = 0; i < 64 * 64; ++i)
            {
                assert_true(foam[i] >= 0.0f && foam[i] <= 1.0f);
            }
            swDestroyWorld(restored);
        }
        else
        {
            refused += 1;
        }
        if (swWorld_Rewind(world, saved.data, saved.size) == SW_SUCCESS)
        {
            assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(world), 1.0, 2.0)));
        }
        memcpy(saved.data + at, kept, 4);
    }
    print_message("%d of %d refused\n", refused, tried);
    Sign(&saved);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_SUCCESS);
    ExpectSaved(world, &saved);
    swDestroyWorld(world);
    free(saved.data);
}

// What was ordered shows before it begins, and a world has the digest of the one that it was saved from.
static void DigestsSeeWhatIsToCome(void** state)
{
    (void)state;
    for (int queries = 0; queries < 2; ++queries)
    {
        swHost host = swDefaultHost();
        swWorldDef worldDef = swDefaultWorldDef();
        worldDef.enableQueries = queries == 1;
        swWorld* world;
        assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
        uint64_t digests[8] = {swWorld_GetDigest(world)};
        swWaveSystemDef def = MakeDef();
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        digests[1] = swWorld_GetDigest(world);
        swWorld_Step(world, 0.5);
        digests[2] = swWorld_GetDigest(world);
        swWaveSystem_FadeWeight(world, id, 0.5f, 3.0);
        digests[3] = swWorld_GetDigest(world);
        def.spectrum.windSpeed += 0.001f;
        assert_int_equal(swWaveSystem_Set(world, id, &def, 3.0), SW_SUCCESS);
        digests[4] = swWorld_GetDigest(world);
        def.seed += 1;
        assert_int_equal(swWaveSystem_Set(world, id, &def, 0.0), SW_SUCCESS);
        digests[5] = swWorld_GetDigest(world);
        swWorld_SetTime(world, 9.0);
        digests[6] = swWorld_GetDigest(world);
        swWorld* restored = SaveAndRestore(world, SW_ISA_SCALAR);
        assert_int_equal(swWorld_GetDigest(restored), digests[6]);
        swWorld_Step(world, 0.5);
        swWorld_Step(restored, 0.5);
        digests[7] = swWorld_GetDigest(world);
        assert_int_equal(swWorld_GetDigest(restored), digests[7]);
        for (int i = 0; i < 8; ++i)
        {
            for (int k = 0; k < i; ++k)
            {
                assert_true(digests[i] != digests[k]);
            }
        }
        swDestroyWorld(world);
        swDestroyWorld(restored);
    }
}

int main(void)
{
    restoreDef = swDefaultRestoreDef();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ARestoredWorldGoesOnWithTheSameBits),
        cmocka_unit_test(ChangesUnderWayGoOn),
        cmocka_unit_test(FoamOfInputsAndShoresGoesOnWhereItWas),
        cmocka_unit_test(FoamOfInputsAndShoresGoesBack),
        cmocka_unit_test(AViewMadeSinceTheLastStepHasNoPast),
        cmocka_unit_test(DamagedBytesAreRefused),
        cmocka_unit_test(ARollBackGoesOnWithTheSameBits),
        cmocka_unit_test(WhatAWorldNoLongerHasItDoesNotGoBackTo),
        cmocka_unit_test(NoNumbersAreLetIn),
        cmocka_unit_test(DigestsSeeWhatIsToCome),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
