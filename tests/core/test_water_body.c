// SPDX-License-Identifier: MIT
// Bodies of water: levels, waves, holes and numbers by place; saved and taken back.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/saved.h"

#include <math.h>
#include <stdio.h>

#include <seaway/seaway.h>

static const swVec2 s_square[4] = {{-50.0f, -50.0f}, {50.0f, -50.0f}, {50.0f, 50.0f}, {-50.0f, 50.0f}};

static swWorld* MakeWorld(const swHost* host)
{
    swWorldDef def = swDefaultWorldDef();
    def.seaLevel = 2.0;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(host, &def, &world), SW_SUCCESS);
    return world;
}

static swWaveSystemId AddWaves(swWorld* world, bool isLocal, uint32_t seed)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.isLocal = isLocal;
    def.seed = seed;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    return id;
}

static swWaterBodyDef MakeLake(const char* name, double x, double level)
{
    swWaterBodyDef def = swDefaultWaterBodyDef();
    snprintf(def.name, sizeof def.name, "%s", name);
    def.position = (swPos){x, level, 0.0};
    def.points = s_square;
    def.pointCount = 4;
    return def;
}

static swWaterBodyId Add(swWorld* world, const swWaterBodyDef* def)
{
    swWaterBodyId id;
    s_messages[0] = '\0';
    if (swCreateWaterBody(world, def, &id) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return id;
}

static double HeightAt(const swWorld* world, double x)
{
    return swMoment_GetHeight(swWorld_GetMoment(world), x, 0.0);
}

static bool IsClippedAt(const swWorld* world, double x)
{
    bool isClipped;
    const swQueryDef query = swDefaultQueryDef();
    const swSurfaceSamples samples = {.isClipped = &isClipped};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 1, &(swPosXZ){x, 0.0}, &samples, NULL);
    return isClipped;
}

static bool IsAt(const swWorld* world, double x, swWaterBodyId id)
{
    swWaterBodyId found = swWorld_FindWaterBody(world, x, 0.0);
    return SW_ID_EQUALS(found, id);
}

static void TwoLakesTenMetresApartKeepTheirLevels(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    const swWaterBodyDef high = MakeLake("high", 0.0, 310.0), low = MakeLake("low", 110.0, 295.5);
    swWaterBodyId highId = Add(world, &high), lowId = Add(world, &low);
    swWorld_Step(world, 0.0);
    assert_true(HeightAt(world, 49.999) == 310.0);
    assert_true(HeightAt(world, 50.001) == 2.0);
    assert_true(HeightAt(world, 59.999) == 2.0);
    assert_true(HeightAt(world, 60.001) == 295.5);
    assert_true(IsAt(world, 49.999, highId));
    assert_true(IsAt(world, 55.0, (swWaterBodyId){0}));
    assert_true(IsAt(world, 60.001, lowId));
    assert_true(IsAt(world, (double)NAN, (swWaterBodyId){0}));
    int numbers[3];
    float levels[3];
    const swPosXZ points[3] = {{0.0, 0.0}, {55.0, 0.0}, {110.0, 0.0}};
    const swFieldSamples samples = {.body = numbers, .level = levels};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 3, points, &samples), 0);
    assert_int_equal(numbers[1], -1);
    swWaterBodyId named = swWorld_GetNumberedWaterBody(world, numbers[2]);
    assert_true(SW_ID_EQUALS(named, lowId));
    assert_true(levels[0] == 308.0f && levels[1] == 0.0f && levels[2] == 293.5f);
    assert_int_equal(swWorld_GetWaterBodyCount(world), 2);
    swWaterBodyId first = swWorld_GetWaterBody(world, 0);
    assert_true(SW_ID_EQUALS(first, highId));

    // Rays from above find either water.
    const swQueryDef query = swDefaultQueryDef();
    const swRay rays[2] = {swDefaultRay((swPos){0.0, 400.0, 0.0}, (swVec3){0.0f, -1.0f, 0.0f}),
                           swDefaultRay((swPos){110.0, 400.0, 0.0}, (swVec3){0.0f, -1.0f, 0.0f})};
    swRayHit hits[2];
    swMoment_CastRays(swWorld_GetMoment(world), &query, 2, rays, hits, NULL);
    assert_true(hits[0].isHit && fabs(hits[0].point.y - 310.0) < 0.002);
    assert_true(hits[1].isHit && fabs(hits[1].point.y - 295.5) < 0.002);
    swDestroyWorld(world);
}

static void LevelsChangeWhileRunning(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swWaterBodyDef lock = MakeLake("lock", 0.0, 10.0);
    swWaterBodyId id = Add(world, &lock);
    swWorld_Step(world, 0.0);
    swWaterBody_SetLevel(world, id, 4.25);
    assert_true(HeightAt(world, 0.0) == 10.0);
    swWorld_Step(world, 0.1);
    assert_true(HeightAt(world, 0.0) == 4.25);
    assert_true(swWaterBody_Get(world, id).position.y == 4.25);
    lock = swWaterBody_Get(world, id);
    lock.position.x = 500.0;
    assert_int_equal(swWaterBody_Set(world, id, &lock), SW_SUCCESS);
    swWorld_Step(world, 0.1);
    assert_true(HeightAt(world, 0.0) == 2.0 && HeightAt(world, 500.0) == 4.25);
    lock = swWaterBody_Get(world, id);
    lock.isEnabled = false;
    assert_int_equal(swWaterBody_Set(world, id, &lock), SW_SUCCESS);
    swWorld_Step(world, 0.1);
    assert_true(HeightAt(world, 500.0) == 2.0);
    assert_true(SW_IS_NULL(swWorld_FindWaterBody(world, 500.0, 0.0)));
    swDestroyWaterBody(world, id);
    assert_false(swWaterBody_IsValid(world, id));
    assert_int_equal(swWorld_GetInputCount(world), 0);
    swDestroyWorld(world);
}

static void BodiesFollowTheOriginOfTheHost(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swWorld_SetOrigin(world, (swPosXZ){1000.0, 0.0});
    const swWaterBodyDef lake = MakeLake("lake", 300.0, 7.0);
    swWaterBodyId id = Add(world, &lake);
    swWorld_Step(world, 0.0);
    assert_true(IsAt(world, 300.0, id));
    swWorld_SetOrigin(world, (swPosXZ){1200.0, 0.0});
    assert_true(IsAt(world, 100.0, id));
    assert_true(swWaterBody_Get(world, id).position.x == 100.0);
    swDestroyWorld(world);
}

static void ADrySeaHasWaterInItsBodiesAlone(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swInputDef dry = swDefaultInputDef();
    dry.field = SW_INPUT_CLIP;
    dry.value[0] = 1.0f;
    dry.order = -1000000;
    swInputId dryId;
    assert_int_equal(swCreateInput(world, &dry, &dryId), SW_SUCCESS);
    swWaterBodyDef lake = MakeLake("lake", 0.0, 20.0), basin = MakeLake("basin", 200.0, 20.0);
    basin.leavesWater = false;
    Add(world, &lake);
    Add(world, &basin);
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, 49.9));
    assert_true(IsClippedAt(world, 50.1));
    assert_true(IsClippedAt(world, 200.0));
    swDestroyWorld(world);
}

static void WhereBodiesOverlapTheGreatestOrderCounts(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swWaterBodyDef a = MakeLake("a", 0.0, 10.0), b = MakeLake("b", 60.0, 20.0), c = MakeLake("c", 60.0, 30.0);
    a.order = 5;
    swWaterBodyId aId = Add(world, &a);
    Add(world, &b);
    swWaterBodyId cId = Add(world, &c);
    swWorld_Step(world, 0.0);
    assert_true(IsAt(world, 49.0, aId) && HeightAt(world, 49.0) == 10.0);
    assert_true(IsAt(world, 51.0, cId) && HeightAt(world, 51.0) == 30.0);
    swDestroyWorld(world);
}

// Root mean square of the heights about the level along a line through the body.
static double Deviation(const swWorld* world, double x)
{
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 400; ++i)
    {
        double height = swMoment_GetHeight(swWorld_GetMoment(world), x + 0.05 * i - 10.0, 0.37 * (i % 50) - 9.0);
        sum += height;
        squares += height * height;
    }
    double mean = sum / 400.0;
    return sqrt(squares / 400.0 - mean * mean);
}

static void ABodyHasItsOwnWavesAndKeepsThoseOfTheSeaOut(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    AddWaves(world, false, 1);
    swWaveSystemId own = AddWaves(world, true, 2);
    swWaterBodyDef calm = MakeLake("calm", 0.0, 5.0), wavy = MakeLake("wavy", 300.0, 5.0);
    calm.isCalm = wavy.isCalm = true;
    wavy.waves = own;
    wavy.wavesFeather = 5.0f;
    Add(world, &calm);
    Add(world, &wavy);
    swWorld_Step(world, 1.0);
    assert_true(Deviation(world, 0.0) == 0.0);
    assert_true(Deviation(world, 300.0) > 0.05);
    assert_true(Deviation(world, 600.0) > 0.05);
    // A system that comes later stays out as well.
    AddWaves(world, false, 3);
    swWorld_Step(world, 0.1);
    assert_true(Deviation(world, 0.0) == 0.0);
    float weights[2];
    const swPosXZ points[2] = {{300.0, 0.0}, {600.0, 0.0}};
    const swFieldSamples samples = {.weight = weights, .system = own};
    swMoment_QueryFields(swWorld_GetMoment(world), 2, points, &samples);
    assert_true(weights[0] == 1.0f && weights[1] == 0.0f);
    swDestroyWorld(world);
}

static void Refuses(const swWaterBodyDef* def, const char* sentence)
{
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swWaterBodyId id;
    s_messages[0] = '\0';
    assert_int_equal(swCreateWaterBody(world, def, &id), SW_ERROR_INVALID);
    printf("%s", s_messages);
    assert_non_null(strstr(s_messages, sentence));
    assert_true(SW_IS_NULL(id));
    assert_int_equal(swWorld_GetWaterBodyCount(world), 0);
    assert_int_equal(swWorld_GetInputCount(world), 0);
    swDestroyWorld(world);
}

static void ABadShoreIsRefusedAndNothingIsMade(void** state)
{
    (void)state;
    const swVec2 bow[] = {{0.0f, 0.0f}, {10.0f, 10.0f}, {10.0f, 0.0f}, {0.0f, 10.0f}};
    swWaterBodyDef def = MakeLake("pond", 0.0, 1.0);
    def.points = bow;
    Refuses(&def, "the body of water 'pond' crosses itself");
    const swVec2 nan[] = {{0.0f, 0.0f}, {(float)NAN, 10.0f}, {10.0f, 0.0f}};
    def.points = nan;
    def.pointCount = 3;
    Refuses(&def, "has point 1, counted from 0, at (nan, 10)");
    def.pointCount = 2;
    Refuses(&def, "has 2 points");
    def.points = NULL;
    Refuses(&def, "has no shore");
    def = MakeLake("pond", 0.0, 1.0);
    def.position.y = (double)NAN;
    Refuses(&def, "swWaterBodyDef::position");
    def = MakeLake("pond", 0.0, 1.0);
    def.waves = (swWaveSystemId){3, 1};
    Refuses(&def, "has the waves of system 3");
}

static void NothingIsHalfMadeWithoutMemory(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host);
    swWaterBodyDef def = MakeLake("lake", 0.0, 10.0);
    def.isCalm = true;
    swWaterBodyId id;
    int failures = 0;
    for (;; ++failures)
    {
        atomic_store(&memory.failAt, atomic_load(&memory.allocations) + failures);
        if (swCreateWaterBody(world, &def, &id) == SW_SUCCESS)
        {
            break;
        }
        assert_int_equal(swWorld_GetInputCount(world), 0);
        assert_int_equal(swWorld_GetWaterBodyCount(world), 0);
        assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    }
    printf("%d allocations failed in turn\n", failures);
    assert_true(failures > 5);
    // A change that fails leaves the body as it was.
    def.position.y = 20.0;
    atomic_store(&memory.failAt, atomic_load(&memory.allocations) + 3);
    assert_int_equal(swWaterBody_Set(world, id, &def), SW_ERROR_NO_MEMORY);
    atomic_store(&memory.failAt, -1);
    swWorld_Step(world, 0.1);
    assert_true(HeightAt(world, 0.0) == 10.0);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- saving ----

static swWorld* Restore(const Saved* saved)
{
    swHost host = MakeHost();
    const swRestoreDef def = swDefaultRestoreDef();
    swWorld* world = NULL;
    if (swRestoreWorld(&host, saved->data, saved->size, &def, &world) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return world;
}

static void ARestoredWorldHasItsBodies(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    AddWaves(world, false, 1);
    swWaterBodyDef lake = MakeLake("lake", 0.0, 10.0), wavy = MakeLake("wavy", 200.0, 12.0);
    const swWaterBodyDef gone = MakeLake("gone", 400.0, 5.0);
    wavy.isCalm = true;
    wavy.waves = AddWaves(world, true, 2);
    wavy.wavesFeather = 5.0f;
    wavy.look = 3;
    swWaterBodyId lakeId = Add(world, &lake), goneId = Add(world, &gone), wavyId = Add(world, &wavy);
    swDestroyWaterBody(world, goneId);
    swWaterBody_SetLevel(world, lakeId, 11.5);
    swWorld_Step(world, 1.0);
    Saved saved = Save(world);
    swWorld* restored = Restore(&saved);
    Saved again = Save(restored);
    assert_int_equal(again.size, saved.size);
    assert_memory_equal(again.data, saved.data, saved.size);
    assert_true(swWorld_GetDigest(restored) == swWorld_GetDigest(world));
    assert_int_equal(swWorld_GetWaterBodyCount(restored), 2);
    assert_true(swWaterBody_IsValid(restored, lakeId) && !swWaterBody_IsValid(restored, goneId));
    assert_true(IsAt(restored, 0.0, lakeId) && IsAt(restored, 200.0, wavyId));
    assert_true(HeightAt(restored, 0.0) == HeightAt(world, 0.0));
    assert_true(HeightAt(restored, 200.0) == HeightAt(world, 200.0));
    const swWaterBodyDef got = swWaterBody_Get(restored, wavyId);
    assert_string_equal(got.name, "wavy");
    assert_true(got.look == 3 && got.isCalm && got.wavesFeather == 5.0f && SW_ID_EQUALS(got.waves, wavy.waves));
    assert_int_equal(got.pointCount, 4);
    assert_memory_equal(got.points, s_square, sizeof s_square);
    assert_true(swWaterBody_Get(restored, lakeId).position.y == 11.5);

    // They are the world's own as before: they change, go, and come where they would have come.
    swWaterBodyId made[2];
    swWorld* const both[2] = {world, restored};
    for (int i = 0; i < 2; ++i)
    {
        swWaterBody_SetLevel(both[i], wavyId, 20.0);
        swDestroyWaterBody(both[i], lakeId);
        made[i] = Add(both[i], &gone);
        swWorld_Step(both[i], 0.5);
        assert_true(IsAt(both[i], 400.0, made[i]) && SW_IS_NULL(swWorld_FindWaterBody(both[i], 0.0, 0.0)));
    }
    assert_true(SW_ID_EQUALS(made[0], made[1]));
    assert_true(HeightAt(restored, 200.0) == HeightAt(world, 200.0));
    assert_true(swWorld_GetDigest(restored) == swWorld_GetDigest(world));
    swDestroyWorld(world);
    swDestroyWorld(restored);
    free(saved.data);
    free(again.data);
}

static void AWorldGoesBackOverLevelsAndBodiesThatWereMade(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    const swWaterBodyDef lake = MakeLake("lake", 0.0, 10.0), later = MakeLake("later", 300.0, 4.0);
    swWaterBodyId id = Add(world, &lake);
    swWorld_Step(world, 1.0);
    Saved saved = Save(world);
    uint64_t digest = swWorld_GetDigest(world);
    swWaterBody_SetLevel(world, id, 15.0);
    swWaterBodyId laterId = Add(world, &later);
    swWorld_Step(world, 1.0);
    assert_true(HeightAt(world, 0.0) == 15.0 && IsAt(world, 300.0, laterId));
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_SUCCESS);
    assert_true(swWorld_GetDigest(world) == digest);
    assert_true(HeightAt(world, 0.0) == 10.0 && swWaterBody_Get(world, id).position.y == 10.0);
    assert_true(!swWaterBody_IsValid(world, laterId) && swWorld_GetWaterBodyCount(world) == 1);
    swWaterBodyId again = Add(world, &later);
    assert_true(SW_ID_EQUALS(again, laterId));

    // Not over one that was destroyed; then nothing changes.
    swDestroyWaterBody(world, id);
    swWorld_Step(world, 1.0);
    digest = swWorld_GetDigest(world);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_ERROR_UNSUPPORTED);
    assert_true(swWorld_GetDigest(world) == digest && IsAt(world, 300.0, again));
    swDestroyWorld(world);
    free(saved.data);
}

// An origin and a place may each be 1e9 m away, which a restored world knows as one place.
static void ABodyFarFromTheFirstOriginIsRestored(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorld* world = MakeWorld(&host);
    swWorld_SetOrigin(world, (swPosXZ){9e8, 0.0});
    const swWaterBodyDef lake = MakeLake("lake", 3e8, 10.0);
    swWaterBodyId id = Add(world, &lake);
    swWorld_Step(world, 1.0);
    Saved saved = Save(world);
    swWorld* restored = Restore(&saved);
    assert_true(swWaterBody_Get(restored, id).position.x == 3e8);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_SUCCESS);
    swDestroyWorld(world);
    swDestroyWorld(restored);
    free(saved.data);
}

// Whatever is changed in the bytes: they are refused, or make a world that can be asked.
static void DamagedBodiesAreRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorld* world = MakeWorld(&host);
    const swWaterBodyDef lake = MakeLake("lake", 0.0, 10.0);
    Add(world, &lake);
    swWorld_Step(world, 0.0);
    Saved saved = Save(world);
    swDestroyWorld(world);
    const swRestoreDef def = swDefaultRestoreDef();
    int refused = 0, made = 0;
    size_t first = saved.size > 400 ? saved.size - 400 : 0;
    for (size_t at = first; at < saved.size - 8; ++at)
    {
        uint8_t kept = saved.data[at];
        for (int bit = 0; bit < 8; ++bit)
        {
            saved.data[at] = (uint8_t)(kept ^ 1u << bit);
            Sign(&saved);
            swResult result = swRestoreWorld(&host, saved.data, saved.size, &def, &world);
            refused += result == SW_SUCCESS ? 0 : 1;
            if (result == SW_SUCCESS)
            {
                made += 1;
                for (int i = 0; i < swWorld_GetWaterBodyCount(world); ++i)
                {
                    swWaterBody_Get(world, swWorld_GetWaterBody(world, i));
                }
                swWorld_FindWaterBody(world, 0.0, 0.0);
                assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
                swDestroyWorld(world);
            }
        }
        saved.data[at] = kept;
    }
    print_message("%d changed bits were refused, %d made a world\n", refused, made);
    assert_true(refused > 100 && made > 100);
    free(saved.data);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// A basin behind a lock with a tide, beside a lake without: now, at a moment of another time, and taken back.
static void ABodyHasATideOfItsOwn(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorld* world = MakeWorld(&host);
    swWaterBodyDef basin = MakeLake("basin", 0.0, 5.0), lake = MakeLake("lake", 300.0, 7.0);
    assert_true(swSetTideConstituent("M2", 1.5f, 0.3f, &basin.tide[0]));
    swWaterBodyId id = Add(world, &basin);
    Add(world, &lake);
    swMomentDef momentDef = swDefaultMomentDef();
    swMoment* moment = NULL;
    momentDef.time = 30000.0;
    for (int i = 1; i <= 10; ++i)
    {
        float tide, none;
        assert_int_equal(swWorld_StepTo(world, 5000.0 * i), SW_SUCCESS);
        swGetTide(1, basin.tide, 5000.0 * i, &tide, &none);
        assert_float_equal((float)HeightAt(world, 0.0), 5.0f + tide, 1e-5f);
        assert_float_equal((float)HeightAt(world, 300.0), 7.0f, 1e-5f);
        assert_float_equal((float)HeightAt(world, -300.0), 2.0f, 1e-5f);
    }
    float tide, none;
    assert_int_equal(swCreateMoment(world, &momentDef, &moment), SW_SUCCESS);
    swGetTide(1, basin.tide, 30000.0, &tide, &none);
    assert_float_equal((float)swMoment_GetHeight(moment, 0.0, 0.0), 5.0f + tide, 1e-5f);
    swDestroyMoment(moment);
    swWaterBody_SetLevel(world, id, 6.0);
    assert_int_equal(swWorld_StepTo(world, 60000.0), SW_SUCCESS);
    swGetTide(1, basin.tide, 60000.0, &tide, &none);
    assert_float_equal((float)HeightAt(world, 0.0), 6.0f + tide, 1e-5f);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TwoLakesTenMetresApartKeepTheirLevels),
        cmocka_unit_test(LevelsChangeWhileRunning),
        cmocka_unit_test(BodiesFollowTheOriginOfTheHost),
        cmocka_unit_test(ADrySeaHasWaterInItsBodiesAlone),
        cmocka_unit_test(WhereBodiesOverlapTheGreatestOrderCounts),
        cmocka_unit_test(ABodyHasItsOwnWavesAndKeepsThoseOfTheSeaOut),
        cmocka_unit_test(ABadShoreIsRefusedAndNothingIsMade),
        cmocka_unit_test(NothingIsHalfMadeWithoutMemory),
        cmocka_unit_test(ARestoredWorldHasItsBodies),
        cmocka_unit_test(AWorldGoesBackOverLevelsAndBodiesThatWereMade),
        cmocka_unit_test(ABodyFarFromTheFirstOriginIsRestored),
        cmocka_unit_test(DamagedBodiesAreRefused),
        cmocka_unit_test(ABodyHasATideOfItsOwn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
