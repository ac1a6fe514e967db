// SPDX-License-Identifier: MIT
// One bad point spoils no other: its answers are NaN and it is counted, and those of all others are, to the bit, as
// without it. Tried with every query, also of another time and of waves that are in no tile.

#include "support/cmocka_setup.h"
#include "support/scatter.h"

#include <math.h>
#include <string.h>

#include "core/waves/waves_fft.h"
#include "seaway/seaway.h"

enum
{
    GOOD = 500,
    MOST = 2 * GOOD,
    MAP = 70
};

#define NO_NUMBER ((double)NAN)
#define FAR_OFF ((double)INFINITY)

typedef struct Bad
{
    double x, y, z;
} Bad;

static const Bad bads[] = {
    {NO_NUMBER, 0.0, 1.0}, {1.0, 0.0, NO_NUMBER}, {FAR_OFF, 0.0, 1.0}, {1.0, 0.0, -FAR_OFF},
    {1.0000001e12, 0., 0}, {0.0, 0.0, -2e12},     {1e300, 0.0, 1e300}, {-1e300, 0.0, 0.0},
    {1.0, NO_NUMBER, 1.0}, {1.0, FAR_OFF, 1.0},   {1.0, 1e300, 1.0},   {1.0, -2e12, 1.0},
};

#define BADS (int)(sizeof bads / sizeof bads[0])
#define FLAT_BADS 8 // the others are bad in height only

static swWorld* OpenSea(bool isGerstner, float depth)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = 3.0;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.method = isGerstner ? SW_WAVES_GERSTNER : SW_WAVES_FFT;
    def.spectrum.depth = depth;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 20.0), SW_SUCCESS);
    return world;
}

// Good and bad places as they come: runs of either, in every order.
typedef struct Places
{
    int count;
    swPos all[MOST];
    bool isBad[MOST];
    swPos good[GOOD];
} Places;

static Places places;

static void MixPlaces(int badKinds)
{
    uint32_t seed = 7;
    places.count = 0;
    for (int good = 0, bad = 0; good < GOOD;)
    {
        bool isBad = NextPart(&seed) < 0.3 && places.count - good < GOOD;
        double depth = NextPart(&seed);
        swPos place = {400.0 * NextPart(&seed), 6.0 - 60.0 * depth * depth, 400.0 * NextPart(&seed)};
        if (isBad)
        {
            const Bad* b = &bads[bad++ % badKinds];
            place = (swPos){b->x, b->y, b->z};
        }
        else
        {
            places.good[good++] = place;
        }
        places.isBad[places.count] = isBad;
        places.all[places.count++] = place;
    }
}

static int CountBads(void)
{
    return places.count - GOOD;
}

static void Flatten(swPosXZ* to, const swPos* from, int count)
{
    for (int i = 0; i < count; ++i)
    {
        to[i] = (swPosXZ){from[i].x, from[i].z};
    }
}

// `all` has an answer of `size` bytes, which is a number of floats, for each place, `good` for each good one.
static void CheckArray(const char* what, const void* all, const void* good, size_t size)
{
    const char* of = good;
    for (int i = 0; i < places.count; ++i)
    {
        const char* at = (const char*)all + (size_t)i * size;
        if (!places.isBad[i])
        {
            if (memcmp(at, of, size) != 0)
            {
                fail_msg("%s of place %d is not what it is without bad ones", what, i);
            }
            of += size;
            continue;
        }
        for (size_t k = 0; k < size; k += sizeof(float))
        {
            float value;
            memcpy(&value, at + k, sizeof value);
            if (!isnan(value))
            {
                fail_msg("%s of bad place %d is %g", what, i, (double)value);
            }
        }
    }
}

static void CheckStats(const swQueryStats* all, const swQueryStats* good)
{
    assert_int_equal(all->badCount, CountBads());
    assert_int_equal(good->badCount, 0);
    assert_int_equal(all->convergedCount, good->convergedCount);
    assert_int_equal(all->iterationCount, good->iterationCount);
    assert_true(all->worstResidual == good->worstResidual);
}

// ---- the surface, and particles ----

typedef struct Answers
{
    float height[MOST], jacobian[MOST], residual[MOST];
    swVec3 displacement[MOST], normal[MOST], velocity[MOST], acceleration[MOST];
    swVec2 slopes[MOST];
    swQueryStats stats;
} Answers;

static Answers all, good;

static void AskSurface(const swWorld* world, const swQueryDef* def, bool isParticles, int count, const swPos* of,
                       Answers* to)
{
    static swPosXZ points[MOST];
    Flatten(points, of, count);
    memset(to, 0x55, sizeof *to);
    const swSurfaceSamples samples = {to->height,   to->displacement, to->normal, to->jacobian, to->residual,
                                      to->velocity, to->acceleration, NULL,       NULL};
    if (isParticles)
    {
        swMoment_QueryParticles(swWorld_GetMoment(world), def, count, points, &samples, to->slopes, &to->stats);
        return;
    }
    swMoment_QuerySurface(swWorld_GetMoment(world), def, count, points, &samples, &to->stats);
    memset(to->slopes, 0xff, sizeof to->slopes); // NaN: it has none
}

static void CheckSurface(const swWorld* world, const swQueryDef* def, bool isParticles)
{
    MixPlaces(FLAT_BADS);
    AskSurface(world, def, isParticles, places.count, places.all, &all);
    AskSurface(world, def, isParticles, GOOD, places.good, &good);
    CheckArray("height", all.height, good.height, sizeof(float));
    CheckArray("Jacobian", all.jacobian, good.jacobian, sizeof(float));
    CheckArray("residual", all.residual, good.residual, sizeof(float));
    CheckArray("displacement", all.displacement, good.displacement, sizeof(swVec3));
    CheckArray("normal", all.normal, good.normal, sizeof(swVec3));
    CheckArray("velocity", all.velocity, good.velocity, sizeof(swVec3));
    CheckArray("acceleration", all.acceleration, good.acceleration, sizeof(swVec3));
    CheckArray("slope", all.slopes, good.slopes, sizeof(swVec2));
    CheckStats(&all.stats, &good.stats);
}

// ---- the water below ----

typedef struct Volume
{
    float depth[MOST], head[MOST];
    swVec3 velocity[MOST], acceleration[MOST];
    swQueryStats stats;
} Volume;

static Volume allBelow, goodBelow;

static void AskVolume(const swWorld* world, const swQueryDef* def, int count, const swPos* of, Volume* to)
{
    memset(to, 0x55, sizeof *to);
    const swVolumeSamples samples = {
        .depth = to->depth, .velocity = to->velocity, .acceleration = to->acceleration, .pressureHead = to->head};
    swMoment_QueryVolume(swWorld_GetMoment(world), def, count, of, &samples, &to->stats);
}

static void CheckVolume(const swWorld* world, const swQueryDef* def)
{
    MixPlaces(BADS);
    AskVolume(world, def, places.count, places.all, &allBelow);
    AskVolume(world, def, GOOD, places.good, &goodBelow);
    CheckArray("depth", allBelow.depth, goodBelow.depth, sizeof(float));
    CheckArray("pressure head", allBelow.head, goodBelow.head, sizeof(float));
    CheckArray("velocity", allBelow.velocity, goodBelow.velocity, sizeof(swVec3));
    CheckArray("acceleration", allBelow.acceleration, goodBelow.acceleration, sizeof(swVec3));
    CheckStats(&allBelow.stats, &goodBelow.stats);
}

// Each place alone has the bits that it has among others: those next to it may be far above or below.
static void CheckVolumeOneByOne(const swWorld* world, const swQueryDef* def)
{
    static Volume one;
    MixPlaces(BADS);
    AskVolume(world, def, GOOD, places.good, &goodBelow);
    for (int i = 0; i < GOOD; i += 7)
    {
        AskVolume(world, def, 1, &places.good[i], &one);
        assert_memory_equal(&one.velocity[0], &goodBelow.velocity[i], sizeof(swVec3));
        assert_memory_equal(&one.acceleration[0], &goodBelow.acceleration[i], sizeof(swVec3));
        assert_true(one.head[0] == goodBelow.head[i] && one.depth[0] == goodBelow.depth[i]);
    }
}

// ---- rays ----

static swRay allRays[MOST], goodRays[GOOD];
static swRayHit allHits[MOST], goodHits[MOST];

// What can be bad about a ray beside where it begins.
static void SpoilRay(swRay* ray, int way)
{
    const swVec3 directions[] = {{0.0f, 0.0f, 0.0f}, {NAN, -1.0f, 0.0f}, {0.0f, INFINITY, 0.0f}, {0.0f, 0.0f, -NAN}};
    float* fields[] = {&ray->maxDistance, &ray->radius, &ray->duration};
    const float values[] = {NAN, -1.0f, INFINITY};
    if (way < 4)
    {
        ray->direction = directions[way];
    }
    else if (way < 13)
    {
        *fields[(way - 4) / 3] = values[(way - 4) % 3];
    }
    else
    {
        *ray = (swRay){0};
    }
}

#define RAY_BADS (BADS + 14)

static void MixRays(bool isMoving)
{
    MixPlaces(BADS);
    uint32_t seed = 3;
    for (int i = 0, goodCount = 0, bad = 0; i < places.count; ++i)
    {
        swVec3 down = {(float)NextPart(&seed), -0.5f, (float)NextPart(&seed)};
        int kind = bad % RAY_BADS;
        bool isPlaceBad = places.isBad[i] && kind < BADS;
        swPos begin = {0.0, 20.0, 0.0};
        if (isPlaceBad)
        {
            begin = (swPos){bads[kind].x, bads[kind].y, bads[kind].z};
        }
        allRays[i] = swDefaultRay(places.isBad[i] ? begin : places.all[i], down);
        allRays[i].origin.y += places.isBad[i] ? 0.0 : 10.0;
        allRays[i].radius = i % 3 == 0 ? 0.5f : 0.0f;
        allRays[i].duration = isMoving && i % 2 == 0 ? 10.0f : 0.0f;
        if (places.isBad[i] && !isPlaceBad)
        {
            SpoilRay(&allRays[i], kind - BADS);
        }
        bad += places.isBad[i] ? 1 : 0;
        if (!places.isBad[i])
        {
            goodRays[goodCount++] = allRays[i];
        }
    }
}

static bool IsNowhere(swPos p)
{
    return isnan(p.x) && isnan(p.y) && isnan(p.z);
}

static void CheckRays(const swWorld* world, const swQueryDef* def, bool isMoving)
{
    swQueryStats allStats, goodStats;
    MixRays(isMoving);
    memset(allHits, 0x55, sizeof allHits);
    memset(goodHits, 0x55, sizeof goodHits);
    int count = isMoving ? 60 : places.count;
    int goodCount = 0, hitCount = 0;
    for (int i = 0; i < count; ++i)
    {
        goodCount += places.isBad[i] ? 0 : 1;
    }
    swMoment_CastRays(swWorld_GetMoment(world), def, count, allRays, allHits, &allStats);
    swMoment_CastRays(swWorld_GetMoment(world), def, goodCount, goodRays, goodHits, &goodStats);
    for (int i = 0, g = 0; i < count; ++i)
    {
        const swRayHit* hit = &allHits[i];
        if (places.isBad[i])
        {
            assert_true(!hit->isHit && isnan(hit->distance) && IsNowhere(hit->position) && IsNowhere(hit->point));
            assert_true(isnan(hit->normal.x) && isnan(hit->normal.y) && isnan(hit->normal.z));
            continue;
        }
        const swRayHit* of = &goodHits[g++];
        assert_true(hit->isHit == of->isHit && hit->fromBelow == of->fromBelow && hit->distance == of->distance);
        assert_memory_equal(&hit->position, &of->position, sizeof(swPos));
        assert_memory_equal(&hit->point, &of->point, sizeof(swPos));
        assert_memory_equal(&hit->normal, &of->normal, sizeof(swVec3));
        hitCount += hit->isHit ? 1 : 0;
    }
    assert_int_equal(allStats.badCount, count - goodCount);
    assert_int_equal(goodStats.badCount, 0);
    assert_int_equal(allStats.iterationCount, goodStats.iterationCount);
    assert_int_equal(goodStats.convergedCount, goodCount);
    assert_true(hitCount > goodCount / 10);
}

static void CheckAll(const swWorld* world, const swQueryDef* def)
{
    CheckSurface(world, def, false);
    CheckSurface(world, def, true);
    CheckVolume(world, def);
    CheckVolumeOneByOne(world, def);
    CheckRays(world, def, false);
}

static void BadPointsAreAnsweredAloneInTiles(void** state)
{
    (void)state;
    for (int shallow = 0; shallow < 2; ++shallow)
    {
        swWorld* world = OpenSea(false, shallow != 0 ? 30.0f : INFINITY);
        swQueryDef def = swDefaultQueryDef();
        CheckAll(world, &def);
        CheckRays(world, &def, true);
        def.minWavelength = 4.0f;
        def.time = 11.0;
        CheckAll(world, &def);
        swDestroyWorld(world);
    }
}

static void BadPointsAreAnsweredAloneInFreeWaves(void** state)
{
    (void)state;
    swWorld* world = OpenSea(true, INFINITY);
    swQueryDef def = swDefaultQueryDef();
    CheckAll(world, &def);
    swWorld_SetOrigin(world, (swPosXZ){1e9, -1e9});
    CheckAll(world, &def);
    swDestroyWorld(world);
}

static void NothingButBadPointsIsAnsweredToo(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY);
    swQueryDef def = swDefaultQueryDef();
    static swPosXZ points[1000];
    static float heights[1000];
    for (int i = 0; i < 1000; ++i)
    {
        points[i] = (swPosXZ){NO_NUMBER, 0.0};
    }
    swQueryStats stats;
    const swSurfaceSamples samples = {.height = heights};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, 1000, points, &samples, &stats);
    assert_int_equal(stats.badCount, 1000);
    assert_int_equal(stats.convergedCount, 0);
    for (int i = 0; i < 1000; ++i)
    {
        assert_true(isnan(heights[i]));
    }
    swDestroyWorld(world);
}

static void OneValueIsNaNToo(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY);
    assert_true(isnan(swMoment_GetHeight(swWorld_GetMoment(world), NO_NUMBER, 0.0)));
    assert_true(isnan(swMoment_GetHeight(swWorld_GetMoment(world), 0.0, -FAR_OFF)));
    assert_true(isnan(swMoment_GetHeight(swWorld_GetMoment(world), 3e12, 0.0)));
    assert_true(isfinite(swMoment_GetHeight(swWorld_GetMoment(world), 1e12, -1e12)));
    const double depths[] = {NO_NUMBER, -1.0, -FAR_OFF};
    for (int i = 0; i < 3; ++i)
    {
        swVec2 drift = swMoment_GetStokesDrift(swWorld_GetMoment(world), depths[i]);
        assert_true(isnan(drift.x) && isnan(drift.y));
    }
    swVec2 deep = swMoment_GetStokesDrift(swWorld_GetMoment(world), FAR_OFF);
    assert_true(deep.x == 0.0f && deep.y == 0.0f);
    swDestroyWorld(world);
}

// ---- maps ----

static void APointOfAMapMayBeBad(void** state)
{
    (void)state;
    static float map[MAP * MAP], whole[MAP * MAP];
    swWorld* world = OpenSea(false, INFINITY);
    swQueryDef def = swDefaultQueryDef();
    // Its last columns lie beyond what can be asked.
    swHeightMapDef mapDef = {.originX = 1e12 - 40.5 * 1024.0, .spacing = 1024.0, .width = MAP, .height = MAP};
    swQueryStats stats;
    swMoment_QueryHeightMap(swWorld_GetMoment(world), &def, &mapDef, map, &stats);
    assert_int_equal(stats.badCount, (MAP - 41) * MAP);
    for (int i = 0; i < MAP * MAP; ++i)
    {
        assert_true(isnan(map[i]) == (i % MAP > 40));
    }
    swHeightMapDef few = mapDef;
    few.width = 41;
    swMoment_QueryHeightMap(swWorld_GetMoment(world), &def, &few, whole, &stats);
    assert_int_equal(stats.badCount, 0);
    for (int row = 0; row < MAP; ++row)
    {
        assert_memory_equal(map + row * MAP, whole + row * 41, 41 * sizeof(float));
    }
    const swHeightMapDef nowhere[] = {{.originX = NO_NUMBER, .spacing = 1.0, .width = MAP, .height = MAP},
                                      {.originZ = FAR_OFF, .spacing = 1.0, .width = MAP, .height = MAP},
                                      {.originX = 2e12, .spacing = NO_NUMBER, .width = MAP, .height = MAP}};
    for (int k = 0; k < 3; ++k)
    {
        swMoment_QueryHeightMap(swWorld_GetMoment(world), &def, &nowhere[k], map, &stats);
        assert_int_equal(stats.badCount, MAP * MAP);
        assert_true(isnan(map[0]) && isnan(map[MAP * MAP - 1]));
    }
    swDestroyWorld(world);
}

// ---- where cells overflow ----

// Kernels count a tile's cells exactly below 2^51 (findCells() in waves_kernels.inl): every tile that a def may ask
// for, as far out as a point may be, with the origin of the host's coordinates as far out as that may be.
static void CellsOfEveryTileCanBeCountedWhereverAPointMayBe(void** state)
{
    (void)state;
    double most = 0.0;
    for (int band = 0; band < SW_SET_TILES; ++band)
    {
        if (band >= SW_MAX_BANDS && band % SW_MAX_BANDS < SW_FIRST_PARALLEL_BAND)
        {
            continue;
        }
        for (int tileWaves = 4; tileWaves <= 128; ++tileWaves)
        {
            double cells = 512.0 / swGetTileSide(band, tileWaves) * (SW_FARTHEST_POINT + 1e9 + 1e5);
            most = cells > most ? cells : most;
        }
    }
    print_message("at most %.4g cells, of 2^51 = %.4g\n", most, 0x1p51);
    assert_true(most < 0x1p51);
}

// ---- directions ----

static void ADefOutOfItsRangeMakesEveryPointBad(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY);
    swQueryDef defs[3] = {swDefaultQueryDef(), swDefaultQueryDef(), swDefaultQueryDef()};
    defs[0].tolerance = NAN;
    defs[1].maxIterations = 0;
    defs[2].minWavelength = -1.0f;
    for (int i = 0; i < 3; ++i)
    {
        float height = 0.0f;
        swQueryStats stats;
        swMoment_QuerySurface(swWorld_GetMoment(world), &defs[i], 1, &(swPosXZ){1.0, 2.0},
                              &(swSurfaceSamples){.height = &height}, &stats);
        assert_true(isnan(height) && stats.badCount == 1);
    }
    swDestroyWorld(world);
}

static void ADirectionMayHaveAnyLength(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY);
    swQueryDef def = swDefaultQueryDef();
    const float lengths[] = {1e-30f, 1e-23f, 1e-10f, 1e10f, 1e20f, 1e38f};
    swRay ray = swDefaultRay((swPos){3.0, 20.0, 4.0}, (swVec3){0.75f, -1.0f, 0.5f});
    swRayHit unit;
    swMoment_CastRays(swWorld_GetMoment(world), &def, 1, &ray, &unit, NULL);
    assert_true(unit.isHit);
    for (int i = 0; i < 6; ++i)
    {
        swRay scaled = ray;
        scaled.direction = (swVec3){0.75f * lengths[i], -lengths[i], 0.5f * lengths[i]};
        swRayHit hit;
        memset(&hit, 0x55, sizeof hit);
        swQueryStats stats;
        swMoment_CastRays(swWorld_GetMoment(world), &def, 1, &scaled, &hit, &stats);
        assert_true(stats.badCount == 0 && hit.isHit);
        assert_float_equal(hit.distance, unit.distance, 1e-3);
    }
    swDestroyWorld(world);
}

// Level, just above waves of millimetres, where steps are as short as they get.
static void ARayThatComesToNoEndSaysSo(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY);
    swWaveSystemId id = {1, 1};
    swWaveSystem_SetWeight(world, id, 0.002f);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swBandInfo bands[SW_MAX_BANDS];
    float variance = 0.0f;
    for (int i = 0, count = swWaveSystem_GetBands(world, id, bands); i < count; ++i)
    {
        variance += bands[i].variance;
    }
    swQueryDef def = swDefaultQueryDef();
    swRay rays[2];
    rays[0] = swDefaultRay((swPos){0.0, 3.0 + 5.9 * (double)sqrtf(variance), 0.0}, (swVec3){1.0f, 0.0f, 0.0f});
    rays[0].maxDistance = 100000.0f;
    rays[1] = swDefaultRay((swPos){0.0, 30.0, 0.0}, (swVec3){0.1f, -1.0f, 0.0f});
    swRayHit hits[2];
    swQueryStats stats;
    swMoment_CastRays(swWorld_GetMoment(world), &def, 2, rays, hits, &stats);
    print_message("a level ray %.3g mm above waves of %.3g mm ends after %.0f m\n", 1e3 * (rays[0].origin.y - 3.0),
                  4e3 * (double)sqrtf(variance), (double)hits[0].distance);
    assert_true(!hits[0].isHit && hits[0].distance > 100.0f && hits[0].distance < 99999.0f);
    assert_true(hits[1].isHit);
    assert_int_equal(stats.convergedCount, 1);
    assert_int_equal(stats.badCount, 0);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(BadPointsAreAnsweredAloneInTiles),
        cmocka_unit_test(BadPointsAreAnsweredAloneInFreeWaves),
        cmocka_unit_test(NothingButBadPointsIsAnsweredToo),
        cmocka_unit_test(OneValueIsNaNToo),
        cmocka_unit_test(APointOfAMapMayBeBad),
        cmocka_unit_test(CellsOfEveryTileCanBeCountedWhereverAPointMayBe),
        cmocka_unit_test(ADefOutOfItsRangeMakesEveryPointBad),
        cmocka_unit_test(ADirectionMayHaveAnyLength),
        cmocka_unit_test(ARayThatComesToNoEndSaysSo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
