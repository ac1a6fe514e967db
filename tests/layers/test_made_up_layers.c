// SPDX-License-Identifier: MIT
// What every layer gets by its line in layers.inl, shown on two that are made up: wetness, a look in views, and ink, a
// simulated field in zones. Both scroll, step at their rate whatever the host's frames, and are saved; ink is digested
// and rolled back with the world as well.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/saved.h"

#include <math.h>
#include <string.h>

#include <seaway/waves.h>

#include "core/world/zone.h"
#include "shared/ink.h"
#include "shared/wetness.h"

#define RESOLUTION 64
#define TEXELS (RESOLUTION * RESOLUTION)

typedef struct Sea
{
    swWorld* world;
    swView* view;
    swZone* zone;
} Sea;

static swZoneDef MakeZoneDef(void)
{
    return (swZoneDef){.levelCount = 2, .resolution = RESOLUTION, .finestTexel = 1.0f};
}

static swResult MakeSea(const swHost* host, bool hasView, Sea* sea)
{
    *sea = (Sea){0};
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef systemDef = swDefaultWaveSystemDef();
    systemDef.resolution = 16;
    systemDef.tileWaves = 4;
    systemDef.minWavelength = 8.0f;
    systemDef.maxWavelength = 256.0f;
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = RESOLUTION;
    viewDef.finestTexel = 1.0f;
    viewDef.enableCpuLayers = true;
    swZoneDef zoneDef = MakeZoneDef();
    swWaveSystemId waves;
    swResult result = swCreateWorld(host, &worldDef, &sea->world);
    result = result == SW_SUCCESS ? swCreateWaveSystem(sea->world, &systemDef, &waves) : result;
    result = result == SW_SUCCESS && hasView ? swCreateView(sea->world, &viewDef, &sea->view) : result;
    result = result == SW_SUCCESS ? swAddZone(sea->world, &zoneDef, &sea->zone) : result;
    return result == SW_SUCCESS ? swWorld_StepTo(sea->world, 0.0) : result;
}

static Sea OpenSea(bool hasView)
{
    swHost host = swDefaultHost();
    Sea sea;
    assert_int_equal(MakeSea(&host, hasView, &sea), SW_SUCCESS);
    return sea;
}

static const float* GetInk(const swZone* zone)
{
    return swGetLayerTexels(&zone->layers, SW_LAYER_INDEX_INK);
}

static const float* GetWetness(const swView* view)
{
    return swGetLayerTexels(&view->layers, SW_LAYER_INDEX_WETNESS);
}

// Of the finest level or slice, at a place on its lattice.
static float ReadTexel(const swLayerStack* layers, int layer, int64_t x, int64_t z)
{
    const swSlice* slice = &layers->stack.slices[0];
    int64_t column = x - slice->firstX, row = z - slice->firstZ;
    assert_in_range(column, 0, RESOLUTION - 1);
    assert_in_range(row, 0, RESOLUTION - 1);
    return swGetLayerTexels(layers, layer)[row * RESOLUTION + column];
}

static double SumInk(const swZone* zone)
{
    double sum = 0.0;
    for (int i = 0; i < TEXELS; ++i)
    {
        sum += (double)GetInk(zone)[i];
    }
    return sum;
}

static void StepTo(const Sea* sea, double time)
{
    assert_int_equal(swWorld_StepTo(sea->world, time), SW_SUCCESS);
}

// ---- a look in a view ----

static void WetnessIsWhatTheWaterLeaves(void** state)
{
    (void)state;
    Sea sea = OpenSea(true);
    float expected = GetWetness(sea.view)[TEXELS / 2 + RESOLUTION / 2]; // no more than what soaked
    for (int i = 1; i <= 8; ++i)
    {
        StepTo(&sea, i * 0.05); // one step of the layer each
        float height = swView_GetDisplacement(sea.view, 0)[4 * (TEXELS / 2 + RESOLUTION / 2) + 1];
        expected = swWetnessStep(expected, height, 2.0f, 0.5f, 0.05f);
        assert_float_equal(GetWetness(sea.view)[TEXELS / 2 + RESOLUTION / 2], expected, 1e-6f);
    }
    swDestroyWorld(sea.world);
}

static void WetnessFadesOnAWorldWithoutWaves(void** state)
{
    (void)state;
    Sea sea = OpenSea(true);
    swWaveSystemId id = {.index1 = 1, .generation = sea.world->systemIds.generations[0]};
    swWaveSystem_SetWeight(sea.world, id, 0.0f);
    StepTo(&sea, 0.5);
    float* wall = (float*)GetWetness(sea.view);
    for (int i = 0; i < 2 * TEXELS; ++i)
    {
        wall[i] = 1.0f;
    }
    for (int i = 1; i <= 10; ++i)
    {
        StepTo(&sea, 0.5 + i * 0.1);
    }
    assert_float_equal(ReadTexel(&sea.view->layers, SW_LAYER_INDEX_WETNESS, 3, 3), expf(-0.5f), 1e-4f);
    swDestroyWorld(sea.world);
}

static void WetnessStaysInTheWorldWhileItsViewMoves(void** state)
{
    (void)state;
    Sea sea = OpenSea(true);
    float* wall = (float*)GetWetness(sea.view);
    memset(wall, 0, 2 * TEXELS * sizeof(float));
    const swSlice* slice = &sea.view->layers.stack.slices[0];
    wall[(5 - slice->firstZ) * RESOLUTION + (7 - slice->firstX)] = 1.0f;
    swView_SetViewpoint(sea.view, (swPos){9.0, 0.0, -4.0});
    StepTo(&sea, 0.0);
    assert_true(sea.view->layers.stack.slices[0].firstX == 9 - RESOLUTION / 2);
    assert_float_equal(ReadTexel(&sea.view->layers, SW_LAYER_INDEX_WETNESS, 7, 5), 1.0f, 0.0f);
    swDestroyWorld(sea.world);
}

static void ALookIsNoPartOfTheDigest(void** state)
{
    (void)state;
    Sea with = OpenSea(true), without = OpenSea(false);
    StepTo(&with, 1.0);
    StepTo(&without, 1.0);
    assert_true(GetWetness(with.view)[0] >= 0.0f);
    ((float*)GetWetness(with.view))[0] = 0.123f;
    assert_int_equal(swWorld_GetDigest(with.world), swWorld_GetDigest(without.world));
    swDestroyWorld(with.world);
    swDestroyWorld(without.world);
}

// ---- a simulated field in a zone ----

static void InkSpreadsAndSettles(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.05); // the first drop
    assert_float_equal(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0), 1.0f, 0.0f);
    StepTo(&sea, 0.1);
    assert_float_equal(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0), 0.98f * 0.8f, 1e-6f);
    assert_float_equal(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 1, 0), 0.98f * 0.05f, 1e-6f);
    assert_float_equal(SumInk(sea.zone), 0.98, 1e-5);
    swDestroyWorld(sea.world);
}

static void InkDoesNotDependOnTheLengthOfFrames(void** state)
{
    (void)state;
    Sea fine = OpenSea(false), coarse = OpenSea(false);
    for (int i = 1; i <= 96; ++i)
    {
        StepTo(&fine, i / 64.0);
    }
    StepTo(&coarse, 0.75);
    StepTo(&coarse, 1.5);
    assert_true(SumInk(fine.zone) > 1.0);
    assert_memory_equal(GetInk(fine.zone), GetInk(coarse.zone), 2 * TEXELS * sizeof(float));
    print_message("digest of ink after 1.5 s: %016llx\n", (unsigned long long)swWorld_GetDigest(fine.world));
    assert_int_equal(swWorld_GetDigest(fine.world), swWorld_GetDigest(coarse.world));
    swDestroyWorld(fine.world);
    swDestroyWorld(coarse.world);
}

static void InkStaysInTheSeaWhileItsZoneMoves(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.6);
    float drop = ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0);
    float beside = ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 2, 1);
    assert_true(drop > beside && beside > 0.0f);
    swPlaceZone(sea.zone, (swPosXZ){20.0, -11.0});
    StepTo(&sea, 0.6);
    assert_true(sea.zone->layers.stack.slices[0].firstX == 20 - RESOLUTION / 2);
    assert_true(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0) == drop);
    assert_true(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 2, 1) == beside);
    swWorld_SetOrigin(sea.world, (swPosXZ){100.0, 0.0});
    swPlaceZone(sea.zone, (swPosXZ){-90.0, 0.0}); // 10 m in the sea
    StepTo(&sea, 0.6);
    assert_true(sea.zone->layers.stack.slices[0].firstX == 10 - RESOLUTION / 2);
    assert_true(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0) == drop);
    swDestroyWorld(sea.world);
}

static void InkThatTheFinestLevelLostComesBackFromTheNext(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.6);
    swPlaceZone(sea.zone, (swPosXZ){40.0, 0.0}); // the origin is in the second level only
    StepTo(&sea, 0.6);
    float coarse = GetInk(sea.zone)[TEXELS + (0 - sea.zone->layers.stack.slices[1].firstZ) * RESOLUTION +
                                    (0 - sea.zone->layers.stack.slices[1].firstX)];
    assert_true(coarse > 0.0f);
    swPlaceZone(sea.zone, (swPosXZ){0.0, 0.0});
    StepTo(&sea, 0.6);
    assert_true(ReadTexel(&sea.zone->layers, SW_LAYER_INDEX_INK, 0, 0) == coarse);
    swDestroyWorld(sea.world);
}

static void AJumpInTimeClearsInk(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.6);
    assert_true(SumInk(sea.zone) > 0.0);
    swWorld_SetTime(sea.world, 10.0);
    StepTo(&sea, 10.0);
    assert_true(SumInk(sea.zone) == 0.0);
    swDestroyWorld(sea.world);
}

static void InkIsPartOfTheDigest(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.6);
    uint64_t digest = swWorld_GetDigest(sea.world);
    float* ink = (float*)GetInk(sea.zone);
    ink[17] += 0.25f;
    assert_int_not_equal(swWorld_GetDigest(sea.world), digest);
    ink[17] -= 0.25f;
    assert_int_equal(swWorld_GetDigest(sea.world), digest);
    swPlaceZone(sea.zone, (swPosXZ){1.0, 0.0}); // ordered, not yet done
    assert_int_not_equal(swWorld_GetDigest(sea.world), digest);
    swDestroyWorld(sea.world);
}

// ---- saving ----

static void RunOn(const Sea* sea)
{
    swPlaceZone(sea->zone, (swPosXZ){6.0, 3.0});
    for (int i = 1; i <= 20; ++i)
    {
        StepTo(sea, 0.7 + i * 0.04);
    }
}

static void BothGoOnInARestoredWorld(void** state)
{
    (void)state;
    Sea sea = OpenSea(true);
    StepTo(&sea, 0.66);
    swPlaceZone(sea.zone, (swPosXZ){5.0, 0.0});
    StepTo(&sea, 0.7);
    swPlaceZone(sea.zone, (swPosXZ){9.0, 2.0}); // waits for the next step
    Saved saved = Save(sea.world);
    swHost host = swDefaultHost();
    swRestoreDef def = swDefaultRestoreDef();
    Sea other = {0};
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &def, &other.world), SW_SUCCESS);
    assert_int_equal(other.world->zoneCount, 1);
    other.zone = other.world->zones[0];
    other.view = swWorld_GetView(other.world, 0);
    assert_int_equal(swWorld_GetDigest(other.world), swWorld_GetDigest(sea.world));
    assert_memory_equal(GetWetness(other.view), GetWetness(sea.view), 2 * TEXELS * sizeof(float));
    RunOn(&sea);
    RunOn(&other);
    assert_int_equal(swWorld_GetDigest(other.world), swWorld_GetDigest(sea.world));
    assert_memory_equal(GetInk(other.zone), GetInk(sea.zone), 2 * TEXELS * sizeof(float));
    assert_memory_equal(GetWetness(other.view), GetWetness(sea.view), 2 * TEXELS * sizeof(float));
    Saved again = Save(other.world);
    Saved first = Save(sea.world);
    assert_int_equal(first.size, again.size);
    assert_memory_equal(first.data, again.data, first.size);
    free(first.data);
    free(again.data);
    free(saved.data);
    swDestroyWorld(sea.world);
    swDestroyWorld(other.world);
}

static void AWorldThatIsRewoundHasItsInkAgain(void** state)
{
    (void)state;
    Sea sea = OpenSea(true);
    StepTo(&sea, 0.7);
    swPlaceZone(sea.zone, (swPosXZ){9.0, 2.0});
    Saved saved = Save(sea.world);
    uint64_t then = swWorld_GetDigest(sea.world);
    RunOn(&sea);
    uint64_t later = swWorld_GetDigest(sea.world);
    assert_int_not_equal(later, then);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_SUCCESS);
    assert_int_equal(swWorld_GetDigest(sea.world), then);
    RunOn(&sea);
    assert_int_equal(swWorld_GetDigest(sea.world), later);
    free(saved.data);
    swDestroyWorld(sea.world);
}

static void AZoneThatHasNotSteppedYetIsSavedAsSuch(void** state)
{
    (void)state;
    Sea sea = OpenSea(false);
    StepTo(&sea, 0.6);
    swZoneDef def = MakeZoneDef();
    swZone* late = NULL;
    assert_int_equal(swAddZone(sea.world, &def, &late), SW_SUCCESS);
    swPlaceZone(late, (swPosXZ){30.0, 0.0});
    Saved saved = Save(sea.world);
    uint64_t digest = swWorld_GetDigest(sea.world);
    swHost host = swDefaultHost();
    swRestoreDef restoreDef = swDefaultRestoreDef();
    Sea other = {0};
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restoreDef, &other.world), SW_SUCCESS);
    assert_int_equal(swWorld_GetDigest(other.world), digest);
    assert_null(swFindZoneFrame(other.world->zones[1]));
    StepTo(&sea, 0.7);
    StepTo(&other, 0.7);
    uint64_t later = swWorld_GetDigest(sea.world);
    assert_int_equal(swWorld_GetDigest(other.world), later);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_SUCCESS);
    assert_int_equal(swWorld_GetDigest(sea.world), digest);
    StepTo(&sea, 0.7);
    assert_int_equal(swWorld_GetDigest(sea.world), later);
    free(saved.data);
    swDestroyWorld(sea.world);
    swDestroyWorld(other.world);
}

static void OtherZonesAreRefusedAndNothingChanges(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Sea sea;
    assert_int_equal(MakeSea(&host, false, &sea), SW_SUCCESS);
    StepTo(&sea, 0.7);
    Saved saved = Save(sea.world);
    swRemoveZone(sea.zone);
    swZoneDef wide = MakeZoneDef();
    uint64_t digest = swWorld_GetDigest(sea.world);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_ERROR_UNSUPPORTED);
    wide.finestTexel = 2.0f;
    assert_int_equal(swAddZone(sea.world, &wide, &sea.zone), SW_SUCCESS);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_ERROR_UNSUPPORTED);
    swRemoveZone(sea.zone);
    assert_int_equal(swWorld_GetDigest(sea.world), digest);
    assert_int_equal(atomic_load(&memory.messages), 2);
    free(saved.data);
    swDestroyWorld(sea.world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void TexelsThatCannotBeAreRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Sea sea;
    assert_int_equal(MakeSea(&host, false, &sea), SW_SUCCESS);
    StepTo(&sea, 0.7);
    Saved saved = Save(sea.world);
    const float tooMuch = 1.5f;
    memcpy(saved.data + saved.size - 8 - sizeof tooMuch, &tooMuch, sizeof tooMuch); // the last texel of ink
    Sign(&saved);
    swRestoreDef def = swDefaultRestoreDef();
    swWorld* world = NULL;
    uint64_t digest = swWorld_GetDigest(sea.world);
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &def, &world), SW_ERROR_FORMAT);
    assert_int_equal(swWorld_Rewind(sea.world, saved.data, saved.size), SW_ERROR_FORMAT);
    assert_int_equal(swWorld_GetDigest(sea.world), digest);
    free(saved.data);
    swDestroyWorld(sea.world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- memory ----

static void AZoneThatCannotBeIsRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Sea sea;
    assert_int_equal(MakeSea(&host, false, &sea), SW_SUCCESS);
    const swZoneDef bad[] = {{0, 64, 1.0f},      {SW_MAX_SLICES + 1, 64, 1.0f},
                             {2, 40, 1.0f},      {2, 2048, 1.0f},
                             {2, 64, 0.75f},     {2, 64, 32.0f},
                             {2, 64, (float)NAN}};
    int count = (int)(sizeof bad / sizeof bad[0]);
    swZone* zone = NULL;
    for (int i = 0; i < count; ++i)
    {
        assert_int_equal(swAddZone(sea.world, &bad[i], &zone), SW_ERROR_INVALID);
        assert_null(zone);
        assert_int_equal(atomic_load(&memory.messages), i + 1);
    }
    swZoneDef def = MakeZoneDef();
    for (int i = 1; i < SW_MAX_ZONES; ++i)
    {
        assert_int_equal(swAddZone(sea.world, &def, &zone), SW_SUCCESS);
    }
    assert_int_equal(swAddZone(sea.world, &def, &zone), SW_ERROR_LIMIT);
    swDestroyWorld(sea.world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void AnAllocationThatFailsIsSurvived(void** state)
{
    (void)state;
    CountingMemory memory;
    swResult result = SW_ERROR_NO_MEMORY;
    for (long long i = 0; result != SW_SUCCESS; ++i)
    {
        swHost host = MakeCountingHost(&memory);
        atomic_store(&memory.failAt, i);
        Sea sea;
        result = MakeSea(&host, true, &sea);
        assert_true(result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY);
        swDestroyWorld(sea.world);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
}

static void AWarmStepAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Sea sea;
    assert_int_equal(MakeSea(&host, true, &sea), SW_SUCCESS);
    StepTo(&sea, 0.1);
    long long before = atomic_load(&memory.allocations);
    swPlaceZone(sea.zone, (swPosXZ){13.0, 5.0});
    StepTo(&sea, 0.2);
    StepTo(&sea, 20.0);
    assert_int_equal(atomic_load(&memory.allocations), before);
    swDestroyWorld(sea.world);
}

// A def is a part of the world's, and all that follows from tables follows for it.
static void WetnessHasADefThatIsCheckedAndSaved(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef def = swDefaultWorldDef();
    assert_true(def.wetness.soak == 2.0f && def.wetness.dryRate == 0.5f);
    swWorld* world = NULL;
    def.wetness.dryRate = -1.0f;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_ERROR_INVALID);
    assert_int_equal(atomic_load(&memory.messages), 1);
    def.wetness.dryRate = 0.125f;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    Saved saved = Save(world);
    swRestoreDef restoreDef = swDefaultRestoreDef();
    swWorld* other = NULL;
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restoreDef, &other), SW_SUCCESS);
    assert_true(other->def.wetness.dryRate == 0.125f);
    free(saved.data);
    swDestroyWorld(other);
    swDestroyWorld(world);
}

// What is simulated must be saved, and only what has a past can step at a rate.
static void EveryLineOfTheTableMakesSense(void** state)
{
    (void)state;
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        const swLayerInfo* info = swGetLayerInfo(i);
        print_message("%s\n", info->name);
        assert_true(info->kind != SW_LAYER_IS_SIMULATED || (info->hasPast && info->isSaved));
        assert_true(info->hasPast == (info->rate > 0) && info->hasPast == (info->mostSteps > 0));
        assert_true(info->hasPast == (info->longestGap > 0.0));
        assert_true(!info->isSaved || info->most > info->least);
        assert_true(info->kind != SW_LAYER_IS_SIMULATED || info->mostSteps >= info->rate * info->longestGap);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WetnessIsWhatTheWaterLeaves),
        cmocka_unit_test(WetnessFadesOnAWorldWithoutWaves),
        cmocka_unit_test(WetnessStaysInTheWorldWhileItsViewMoves),
        cmocka_unit_test(ALookIsNoPartOfTheDigest),
        cmocka_unit_test(InkSpreadsAndSettles),
        cmocka_unit_test(InkDoesNotDependOnTheLengthOfFrames),
        cmocka_unit_test(InkStaysInTheSeaWhileItsZoneMoves),
        cmocka_unit_test(InkThatTheFinestLevelLostComesBackFromTheNext),
        cmocka_unit_test(AJumpInTimeClearsInk),
        cmocka_unit_test(InkIsPartOfTheDigest),
        cmocka_unit_test(BothGoOnInARestoredWorld),
        cmocka_unit_test(AWorldThatIsRewoundHasItsInkAgain),
        cmocka_unit_test(AZoneThatHasNotSteppedYetIsSavedAsSuch),
        cmocka_unit_test(OtherZonesAreRefusedAndNothingChanges),
        cmocka_unit_test(TexelsThatCannotBeAreRefused),
        cmocka_unit_test(AZoneThatCannotBeIsRefused),
        cmocka_unit_test(AnAllocationThatFailsIsSurvived),
        cmocka_unit_test(AWarmStepAllocatesNothing),
        cmocka_unit_test(WetnessHasADefThatIsCheckedAndSaved),
        cmocka_unit_test(EveryLineOfTheTableMakesSense),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
