// SPDX-License-Identifier: MIT
// What a saved world may hold and take: every legal world can be saved, one that cannot says so, few bytes cannot ask
// for much memory, and a world goes back only to waves that are the same in all that they answer.

#include "support/cmocka_setup.h"
#include "support/saved.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/world/world.h"
#include "seaway/seaway.h"

// ---- a host that keeps the peak of its memory and its last sentence ----

typedef struct Keeper
{
    size_t held, peak;
    int sentences;
    char last[512];
} Keeper;

static void* KeepAllocate(void* context, size_t size, size_t alignment)
{
    Keeper* keeper = context;
    keeper->held += size;
    keeper->peak = keeper->held > keeper->peak ? keeper->held : keeper->peak;
    return aligned_alloc(alignment, (size + alignment - 1) & ~(alignment - 1));
}

static void KeepFree(void* context, void* memory, size_t size)
{
    Keeper* keeper = context;
    keeper->held -= memory != NULL ? size : 0;
    free(memory);
}

static void KeepLog(void* context, swLogLevel level, const char* message)
{
    Keeper* keeper = context;
    (void)level;
    keeper->sentences += 1;
    snprintf(keeper->last, sizeof keeper->last, "%s", message);
}

static swHost MakeHost(Keeper* keeper)
{
    *keeper = (Keeper){0};
    swHost host = swDefaultHost();
    host.allocate = KeepAllocate;
    host.free = KeepFree;
    host.memoryContext = keeper;
    host.log = KeepLog;
    host.logContext = keeper;
    return host;
}

// ---- bytes ----

static swWorld* Restore(const swHost* host, const Saved* saved, size_t budget, swResult wanted)
{
    swRestoreDef def = swDefaultRestoreDef();
    def.memoryBudget = budget;
    swWorld* world = (swWorld*)1;
    assert_int_equal(swRestoreWorld(host, saved->data, saved->size, &def, &world), wanted);
    assert_true((world != NULL) == (wanted == SW_SUCCESS));
    return world;
}

static swWaveSystemDef MakeDef(void)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.minWavelength = 2.0f;
    return def;
}

static swWorld* MakeWorld(const swHost* host, const swWaveSystemDef* def)
{
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swWaveSystemId id;
    assert_int_equal(swCreateWorld(host, &worldDef, &world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(world, def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    return world;
}

static const swWaveSystemId FIRST = {1, 1};

// ---- every legal world can be saved ----

static void CheckSaved(const swHost* host, swWorld* world)
{
    Saved saved = Save(world);
    swWorld* again = Restore(host, &saved, (size_t)1 << 30, SW_SUCCESS);
    assert_int_equal(swWorld_GetDigest(again), swWorld_GetDigest(world));
    Saved other = Save(again);
    assert_int_equal(other.size, saved.size);
    assert_memory_equal(other.data, saved.data, saved.size);
    swDestroyWorld(again);
    free(saved.data);
    free(other.data);
}

static void AViewpointAsFarAsItMayBeIsSaved(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWaveSystemDef def = MakeDef();
    swWorld* world = MakeWorld(&host, &def);
    swViewDef viewDef = swDefaultViewDef();
    swView* view = NULL;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    for (int corner = 0; corner < 8; ++corner)
    {
        double x = (corner & 1) != 0 ? 1.0 : -1.0, z = (corner & 2) != 0 ? 1.0 : -1.0;
        double away = (corner & 4) != 0 ? 1.0 : -1.0;
        swWorld_SetOrigin(world, (swPosXZ){away * x * 1e9, z * 1e9});
        swView_SetViewpoint(view, (swPos){x * 1e12, z * 1e12, z * 1e12});
        CheckSaved(&host, world);
        assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
        CheckSaved(&host, world);
    }
    swDestroyWorld(world);
}

static void AChangeAtTheEndOfTimeIsSaved(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    const double ends[] = {SW_LARGEST_TIME, -SW_LARGEST_TIME};
    for (int end = 0; end < 2; ++end)
    {
        swWaveSystemDef def = MakeDef();
        swWorld* world = MakeWorld(&host, &def);
        assert_int_equal(swWorld_StepTo(world, ends[end]), SW_SUCCESS);
        swWaveSystem_FadeWeight(world, FIRST, 0.5f, 100.0);
        CheckSaved(&host, world);
        def.spectrum.windSpeed = 15.0f;
        assert_int_equal(swWaveSystem_Set(world, FIRST, &def, SW_MAX_TRANSITION), SW_SUCCESS);
        def.seed = 9;
        assert_int_equal(swWaveSystem_Set(world, FIRST, &def, 50.0), SW_SUCCESS);
        CheckSaved(&host, world);
        swWorld_SetTime(world, -ends[end]);
        CheckSaved(&host, world);
        swDestroyWorld(world);
    }
}

// From one end of time to the other are 2^63 ticks.
static void TimeJumpsFromEndToEnd(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWaveSystemDef def = MakeDef();
    swWorld* world = MakeWorld(&host, &def);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = 64;
    swView* view = NULL;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    swWorld_SetTime(world, -SW_LARGEST_TIME);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swWaveSystem_FadeWeight(world, FIRST, 0.25f, 10.0);
    def.spectrum.windSpeed = 15.0f;
    assert_int_equal(swWaveSystem_Set(world, FIRST, &def, 10.0), SW_SUCCESS);
    swWorld_SetTime(world, SW_LARGEST_TIME);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_true(swWaveSystem_GetWeight(world, FIRST) == 1.0f); // what Set() asked for, long over
    assert_null(world->waves.systems[0].parts[0].set->mix);
    assert_true(swFindViewFrame(view)->stack.layers[SW_LAYER_FOAM].isReset);
    swWorld_SetTime(world, -SW_LARGEST_TIME);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_true(swFindViewFrame(view)->stack.layers[SW_LAYER_FOAM].isReset);
    assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(world), 1.0, 2.0)));
    swDestroyWorld(world);
}

// ---- what cannot be saved ----

static void AStateThatCannotBeSavedIsRefused(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWaveSystemDef def = MakeDef();
    swWorld* world = MakeWorld(&host, &def);
    Saved room = Save(world);
    for (int way = 0; way < 3; ++way)
    {
        struct swWorld kept = *world;
        world->origin.x = way == 0 ? (double)NAN : world->origin.x;
        world->waves.systems[0].weight.to = way == 1 ? 11.0f : world->waves.systems[0].weight.to;
        world->waves.systems[0].parts[0].fade.begin = way == 2 ? INT64_MIN : 0;
        int before = keeper.sentences;
        size_t size = 1;
        assert_int_equal(swWorld_Save(world, NULL, &size), SW_ERROR_LIMIT);
        assert_int_equal(size, 0);
        assert_int_equal(keeper.sentences, before + 1);
        size = room.size;
        assert_int_equal(swWorld_Save(world, room.data, &size), SW_ERROR_LIMIT);
        assert_int_equal(keeper.sentences, before + 2);
        world->origin = kept.origin;
        world->waves.systems[0].weight = kept.waves.systems[0].weight;
        world->waves.systems[0].parts[0].fade = kept.waves.systems[0].parts[0].fade;
    }
    print_message("%s\n", keeper.last);
    CheckSaved(&host, world);
    free(room.data);
    swDestroyWorld(world);
}

// ---- memory ----

// Bytes before the first set: mark, version, def, clocks, number of sets.
static size_t FindSets(const swWorld* world)
{
    swStream count = {.purpose = SW_STREAM_COUNT};
    swWorldDef def = world->def;
    swWind wind = world->wind;
    swStreamDef(&count, &swWorldFields, &def);
    swStreamWind(&count, &def.wind, &wind);
    return 12 + count.at + 41 + 4;
}

// The bytes of a world with the first of its sets `copies` times, each with another seed.
static Saved RepeatSet(const swWorld* world, int copies)
{
    Saved one = Save(world);
    size_t at = FindSets(world);
    uint32_t size;
    memcpy(&size, one.data + at + 8, 4);
    size_t record = 12 + (size_t)size;
    Saved many = {.size = one.size + (size_t)(copies - 1) * record};
    many.data = malloc(many.size);
    assert_non_null(many.data);
    memcpy(many.data, one.data, at);
    memcpy(many.data + at - 4, &copies, 4);
    for (int i = 0; i < copies; ++i)
    {
        uint8_t* to = many.data + at + (size_t)i * record;
        memcpy(to, one.data + at, record);
        uint32_t seed = 1 + (uint32_t)i;
        memcpy(to + record - 9, &seed, 4); // before takesWind and the number of components
    }
    memcpy(many.data + at + (size_t)copies * record, one.data + at + record, one.size - at - record);
    Sign(&many);
    free(one.data);
    return many;
}

static void FewBytesCannotAskForMuch(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWaveSystemDef def = MakeDef();
    def.resolution = 128;
    swWorld* world = MakeWorld(&host, &def);
    size_t held = swWorld_GetMemory(world);
    Saved two = RepeatSet(world, 2);
    Saved many = RepeatSet(world, 128);
    swDestroyWorld(world);
    assert_int_equal(keeper.held, 0);
    assert_true(many.size < 64 * 1024);

    swDestroyWorld(Restore(&host, &two, (size_t)1 << 30, SW_SUCCESS)); // sets that no system uses go again
    const size_t budgets[] = {1, 100000, held - 1000, 4 * held};
    for (int i = 0; i < 4; ++i)
    {
        keeper.peak = 0;
        int before = keeper.sentences;
        Restore(&host, &many, budgets[i], SW_ERROR_LIMIT);
        print_message("%zu bytes of budget, %zu at most held: %s\n", budgets[i], keeper.peak, keeper.last);
        assert_int_equal(keeper.sentences, before + 1);
        assert_non_null(strstr(keeper.last, "memory"));
        assert_true(keeper.peak <= (budgets[i] > sizeof(swWorld) ? budgets[i] : sizeof(swWorld)));
        assert_int_equal(keeper.held, 0);
    }
    // Without a budget to speak of: more tiles than any world has.
    keeper.peak = 0;
    Restore(&host, &many, SIZE_MAX, SW_ERROR_FORMAT);
    print_message("without a budget %zu bytes were held\n", keeper.peak);
    assert_true(keeper.peak < 40 * held);
    assert_int_equal(keeper.held, 0);
    free(two.data);
    free(many.data);
}

static void ABudgetThatSufficesChangesNothing(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWaveSystemDef def = MakeDef();
    swWorld* world = MakeWorld(&host, &def);
    def.spectrum.windSpeed = 14.0f;
    assert_int_equal(swWaveSystem_Set(world, FIRST, &def, 30.0), SW_SUCCESS);
    Saved saved = Save(world);
    size_t most = 0;
    for (size_t budget = sizeof(swWorld); most == 0; budget += budget / 16)
    {
        swRestoreDef restore = swDefaultRestoreDef();
        restore.memoryBudget = budget;
        swWorld* again = NULL;
        swResult result = swRestoreWorld(&host, saved.data, saved.size, &restore, &again);
        assert_true(result == SW_SUCCESS || result == SW_ERROR_LIMIT);
        if (result == SW_SUCCESS)
        {
            assert_int_equal(swWorld_GetDigest(again), swWorld_GetDigest(world));
            def.resolution = 256; // afterwards there is no budget
            assert_int_equal(swWaveSystem_Set(again, FIRST, &def, 0.0), SW_SUCCESS);
            most = budget;
        }
        swDestroyWorld(again);
    }
    free(saved.data);
    swDestroyWorld(world);
    assert_int_equal(keeper.held, 0);
}

// Each count by itself, with less behind it than it counts: nothing is taken for it.
static void CountsAreHeldAgainstTheBytesLeft(void** state)
{
    (void)state;
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    // A mix: a count of modes, then bands and variances, and no mode.
    uint8_t bytes[2000] = {0};
    const int count = 10000;
    memcpy(bytes, &count, 4);
    swBandModes bands[SW_SET_TILES];
    swModeMix* mix = NULL;
    swStream stream = {.purpose = SW_STREAM_READ, .data = bytes, .size = sizeof bytes};
    assert_int_equal(swStreamModeMix(&stream, &host, 128, 512, bands, &mix), SW_ERROR_FORMAT);
    print_message("a mix of %d modes in %zu bytes took %zu bytes\n", count, sizeof bytes, keeper.peak);
    assert_true(keeper.peak < 16384); // the mix without a mode
    assert_int_equal(keeper.held, 0);

    // Whatever number of a file is a count: it takes no more than there are bytes for.
    swWaveSystemDef def = MakeDef();
    def.method = SW_WAVES_GERSTNER;
    const swWaveComponent wave = {60.0f, 1.0f, 0.3f, 0.2f};
    def.components = &wave;
    def.componentCount = 1;
    swWorld* world = MakeWorld(&host, &def);
    const float frequencies[3] = {0.1f, 0.15f, 0.2f}, widths[3] = {0.05f, 0.05f, 0.05f};
    const float density[3 * 4] = {0.1f, 0.5f, 0.1f, 0.0f, 0.2f, 0.9f, 0.2f, 0.0f, 0.1f, 0.4f, 0.1f, 0.0f};
    const swSpectrumTable table = {
        .frequencyCount = 3, .directionCount = 4, .frequencies = frequencies, .bandwidths = widths, .density = density};
    def = MakeDef();
    def.spectrum.kind = SW_SPECTRUM_TABLE;
    def.spectrum.table = &table;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    Saved saved = Save(world);
    swDestroyWorld(world);
    keeper.peak = 0;
    swDestroyWorld(Restore(&host, &saved, (size_t)1 << 30, SW_SUCCESS));
    size_t usual = keeper.peak;
    const int counts[] = {16, 128, 720, 1024, 0x7fffffff};
    size_t worst = 0;
    host.log = NULL;
    for (size_t at = 12; at + 4 <= saved.size - 8; ++at)
    {
        for (int k = 0; k < 5; ++k)
        {
            uint8_t kept[4];
            memcpy(kept, saved.data + at, 4);
            memcpy(saved.data + at, &counts[k], 4);
            Sign(&saved);
            keeper.peak = 0;
            swRestoreDef restore = swDefaultRestoreDef();
            swWorld* again = NULL;
            swRestoreWorld(&host, saved.data, saved.size, &restore, &again);
            bool isMoreTiles = again != NULL; // another resolution, say: that is no count
            worst = !isMoreTiles && keeper.peak > worst ? keeper.peak : worst;
            swDestroyWorld(again);
            memcpy(saved.data + at, kept, 4);
        }
    }
    print_message("usually %zu bytes, with any number as a count at most %zu\n", usual, worst);
    assert_true(worst < usual + 24576); // a set of waves without waves, and no array
    free(saved.data);
    assert_int_equal(keeper.held, 0);
}

// ---- the same waves ----

static void ExpectRefusedRewind(const swWaveSystemDef* then, const swWaveSystemDef* now, bool mustBeSame,
                                const char* what)
{
    Keeper keeper;
    swHost host = MakeHost(&keeper);
    swWorld* world = MakeWorld(&host, then);
    Saved saved = Save(world);
    uint64_t hash = world->waves.systems[0].parts[0].set->hash;
    assert_int_equal(swWaveSystem_Set(world, FIRST, now, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.5), SW_SUCCESS);
    bool isSame = world->waves.systems[0].parts[0].set->hash == hash;
    print_message("%s: %s waves\n", what, isSame ? "the same" : "other");
    assert_true(isSame || !mustBeSame);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_ERROR_UNSUPPORTED);
    assert_int_equal(swWaveSystem_Set(world, FIRST, then, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_SUCCESS);
    free(saved.data);
    swDestroyWorld(world);
}

static void WavesOfAnotherDepthOrBoundAreOthers(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeDef();
    def.maxWavelength = 64.0f;
    swWaveSystemDef other = def;
    other.spectrum.depth = 50000.0f; // no wave of 64 m feels it, but it is a bottom
    ExpectRefusedRewind(&def, &other, true, "another depth");
    other = def;
    other.minWavelength = nextafterf(2.0f, 3.0f);
    ExpectRefusedRewind(&def, &other, false, "another shortest wavelength");
    other = def;
    other.maxWavelength = nextafterf(64.0f, 3.0f);
    ExpectRefusedRewind(&def, &other, false, "another longest wavelength");
    def.method = other.method = SW_WAVES_GERSTNER;
    const swWaveComponent wave = {60.0f, 1.0f, 0.3f, 0.2f};
    def.components = &wave;
    def.componentCount = 1;
    other = def;
    other.spectrum.depth = 50000.0f;
    ExpectRefusedRewind(&def, &other, true, "another depth of a free wave");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AViewpointAsFarAsItMayBeIsSaved),
        cmocka_unit_test(AChangeAtTheEndOfTimeIsSaved),
        cmocka_unit_test(TimeJumpsFromEndToEnd),
        cmocka_unit_test(AStateThatCannotBeSavedIsRefused),
        cmocka_unit_test(FewBytesCannotAskForMuch),
        cmocka_unit_test(ABudgetThatSufficesChangesNothing),
        cmocka_unit_test(CountsAreHeldAgainstTheBytesLeft),
        cmocka_unit_test(WavesOfAnotherDepthOrBoundAreOthers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
