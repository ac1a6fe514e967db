// SPDX-License-Identifier: MIT
// Waves by place: the formulas of shared/region.h, then seas.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "seaway/seaway.h"
#include "shared/region.h"

// ---- formulas ----

static void TwoWeightsHaveSquaresThatAddUpToOne(void** state)
{
    (void)state;
    double worst = 0.0, worstSlope = 0.0;
    const double step = 1e-3;
    for (int i = -100; i <= 1100; i++)
    {
        double share = 1e-3 * i;
        swWeightPair p = swPairWeights((float)share), smooth = swPairSmoothly((float)share);
        worst = fmax(worst, fabs((double)(p.first * p.first + p.second * p.second) - 1.0));
        worst = fmax(worst, fabs((double)(smooth.first * smooth.first + smooth.second * smooth.second) - 1.0));
        if (share > 0.01 && share < 0.99)
        {
            swWeightPair a = swPairWeights((float)(share - step)), b = swPairWeights((float)(share + step));
            swWeightPair c = swPairSmoothly((float)(share - step)), d = swPairSmoothly((float)(share + step));
            worstSlope = fmax(worstSlope, fabs((double)(b.first - a.first) / (2.0 * step) - (double)p.firstSlope));
            worstSlope = fmax(worstSlope, fabs((double)(b.second - a.second) / (2.0 * step) - (double)p.secondSlope));
            worstSlope = fmax(worstSlope, fabs((double)(d.first - c.first) / (2.0 * step) - (double)smooth.firstSlope));
        }
    }
    print_message("squares add up to 1 within %.1e; slopes are off by %.1e\n", worst, worstSlope);
    assert_true(worst < 1e-6 && worstSlope < 1e-3);
}

// One of `count` headings, at the middle of three speeds of a sea whose heights grow with the square of the speed.
static swInputRecord MakeWindRecord(int heading, int count, float speed, float below, float above)
{
    double turn = 2.0 * SW_PI / count, angle = turn * heading;
    swInputRecord record = {0};
    record.flags = SW_INPUT_TAKES_WIND;
    record.turn = (sw_vec4){(float)cos(angle), (float)sin(angle), (float)cos(turn), (float)sin(turn)};
    record.size = (sw_vec4){speed, below, above, 0.0f};
    record.value.z = below > 0.0f ? below * below / (speed * speed) : 1.0f;
    record.value.w = above > 0.0f ? above * above / (speed * speed) : 1.0f;
    return record;
}

static swInputChannel Constant(double value)
{
    return swMakeChannel((float)value, 0.0f, 0.0f);
}

static void HeadingsMixWithoutJumpsAndKeepTheEnergy(void** state)
{
    (void)state;
    const int count = 12, steps = 3600;
    double worst = 0.0, worstTurn = 0.0, jump = 0.0, before[12] = {0.0};
    for (int i = 0; i <= steps; i++)
    {
        double angle = 2.0 * SW_PI * i / steps, square = 0.0, x = 0.0, z = 0.0;
        int some = 0;
        for (int h = 0; h < count; h++)
        {
            swInputRecord record = MakeWindRecord(h, count, 10.0f, 0.0f, 0.0f);
            double w = (double)swFindWindWeight(record, Constant(10.0 * cos(angle)), Constant(10.0 * sin(angle))).value;
            square += w * w;
            x += w * w * (double)record.turn.x;
            z += w * w * (double)record.turn.y;
            some += w > 0.0 ? 1 : 0;
            jump = i > 0 ? fmax(jump, fabs(w - before[h])) : 0.0;
            before[h] = w;
        }
        worst = fmax(worst, fabs(square - 1.0));
        double off = remainder(atan2(z, x) - angle, 2.0 * SW_PI);
        worstTurn = fmax(worstTurn, fabs(off) * 180.0 / SW_PI);
        assert_true(some >= 1 && some <= 2);
    }
    print_message("of %d headings two are mixed: energy within %.1e, mean direction within %.2f degrees; a tenth of a "
                  "degree changes a weight by at most %.4f\n",
                  count, worst, worstTurn, jump);
    assert_true(worst < 1e-5 && worstTurn < 0.25 * 360.0 / count && jump < 0.01);
}

static void SpeedsMixToTheEnergyThatTheLawAsksFor(void** state)
{
    (void)state;
    const float speeds[4] = {0.0f, 5.0f, 10.0f, 20.0f};
    double worst = 0.0;
    for (double speed = 2.0; speed < 40.0; speed *= 1.01)
    {
        double square = 0.0;
        for (int i = 1; i < 4; i++)
        {
            float above = i < 3 ? speeds[i + 1] : 0.0f;
            swInputRecord record = MakeWindRecord(0, 8, speeds[i], speeds[i - 1], above);
            double w = (double)swFindSpeedWeight(record, (float)speed).x;
            double own = (double)(speeds[i] * speeds[i]);
            // Each speed's system answers for its own half of the ends only.
            bool isMine = (i > 1 || speed >= 0.0) && (i < 3 || speed >= 0.0);
            square += isMine ? w * w * own * own : 0.0;
        }
        worst = fmax(worst, fabs(sqrt(square) / (speed * speed) - 1.0));
    }
    print_message("heights grow with the square of the speed within %.1e\n", worst);
    assert_true(worst < 1e-5);
}

static void GradientsOfWeightsAreDerivatives(void** state)
{
    (void)state;
    const double d = 1e-3;
    double worst = 0.0, largest = 0.0;
    for (int i = 0; i < 4000; i++)
    {
        double x = 0.37 * i - 700.0, z = 911.0 - 0.53 * i;
        swInputRecord record = MakeWindRecord(i % 16, 16, 9.0f, 5.0f, 16.0f);
        double w[5] = {0.0};
        swInputChannel here = Constant(0.0);
        for (int k = 0; k < 5; k++)
        {
            double px = x + (k == 1 ? d : k == 2 ? -d : 0.0) * 100.0, pz = z + (k == 3 ? d : k == 4 ? -d : 0.0) * 100.0;
            // A wind that turns and grows over some hundred metres.
            double angle = 0.004 * px + 0.003 * pz, speed = 10.0 + 4.0 * sin(0.01 * px - 0.005 * pz);
            double speedX = 0.04 * cos(0.01 * px - 0.005 * pz), speedZ = -0.02 * cos(0.01 * px - 0.005 * pz);
            swInputChannel u =
                swMakeChannel((float)(speed * cos(angle)), (float)(speedX * cos(angle) - speed * sin(angle) * 0.004),
                              (float)(speedZ * cos(angle) - speed * sin(angle) * 0.003));
            swInputChannel v =
                swMakeChannel((float)(speed * sin(angle)), (float)(speedX * sin(angle) + speed * cos(angle) * 0.004),
                              (float)(speedZ * sin(angle) + speed * cos(angle) * 0.003));
            swInputChannel found = swFindWindWeight(record, u, v);
            w[k] = (double)found.value;
            here = k == 0 ? found : here;
        }
        if (w[0] > 0.0 && w[1] > 0.0 && w[2] > 0.0 && w[3] > 0.0 && w[4] > 0.0)
        {
            worst = fmax(worst, fabs((w[1] - w[2]) / (200.0 * d) - (double)here.alongX));
            worst = fmax(worst, fabs((w[3] - w[4]) / (200.0 * d) - (double)here.alongZ));
            largest = fmax(largest, fabs((double)here.alongX));
        }
    }
    print_message("gradients of up to %.4f per metre are off by %.1e\n", largest, worst);
    assert_true(largest > 0.01 && worst < 2e-5);
}

// ---- seas ----

static swWorld* MakeWorld(void)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    return world;
}

// Waves of 8 m and more.
static swWaveSystemDef MakeSystem(float height, float period, float direction, uint32_t seed)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 64;
    def.tileWaves = 16;
    def.minWavelength = 8.0f;
    def.spectrum.significantHeight = height;
    def.spectrum.peakPeriod = period;
    def.spectrum.direction = direction;
    def.seed = seed;
    return def;
}

static swWaveSystemId AddSystem(swWorld* world, const swWaveSystemDef* def)
{
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, def, &id), SW_SUCCESS);
    return id;
}

#define POINTS 4000

// What the surface has within a square.
typedef struct Measured
{
    double deviation;  // of heights, m
    double axis;       // along which slopes are steepest, radians in (-pi/2, pi/2]
    double crestRatio; // slopes across that axis over those along it
} Measured;

static Measured Measure(const swWorld* world, double x, double z, double side)
{
    static swPosXZ points[POINTS];
    static swVec3 displacement[POINTS];
    static swVec2 slopes[POINTS];
    uint32_t random = 7;
    for (int i = 0; i < POINTS; i++)
    {
        random = random * 1664525u + 1013904223u;
        points[i].x = x + side * ((double)(random >> 8) / 16777216.0 - 0.5);
        random = random * 1664525u + 1013904223u;
        points[i].z = z + side * ((double)(random >> 8) / 16777216.0 - 0.5);
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.displacement = displacement};
    swMoment_QueryParticles(swWorld_GetMoment(world), &def, POINTS, points, &samples, slopes, NULL);
    double square = 0.0, xx = 0.0, xz = 0.0, zz = 0.0;
    for (int i = 0; i < POINTS; i++)
    {
        square += (double)displacement[i].y * (double)displacement[i].y / POINTS;
        xx += (double)slopes[i].x * (double)slopes[i].x;
        xz += (double)slopes[i].x * (double)slopes[i].y;
        zz += (double)slopes[i].y * (double)slopes[i].y;
    }
    double half = 0.5 * (xx + zz), off = sqrt(0.25 * (xx - zz) * (xx - zz) + xz * xz);
    return (Measured){sqrt(square), 0.5 * atan2(2.0 * xz, xx - zz), (half - off) / fmax(half + off, 1e-12)};
}

static void ARegionBringsItsWavesAndRemovesThoseBelow(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swWaveSystemDef sea = MakeSystem(2.0f, 8.0f, 0.0f, 1), lagoon = MakeSystem(0.8f, 4.0f, 1.5707964f, 2);
    lagoon.isLocal = true;
    AddSystem(world, &sea);
    swInputDef region = swDefaultInputDef();
    region.field = SW_INPUT_WAVES;
    region.shape = SW_SHAPE_CIRCLE;
    region.size.x = 20000.0f;
    region.feather = 6000.0f;
    region.value[0] = 1.0f;
    region.removesWaves = true;
    region.system = AddSystem(world, &lagoon);
    swInputId id;
    assert_int_equal(swCreateInput(world, &region, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 100.0), SW_SUCCESS);
    Measured inside = Measure(world, 0.0, 0.0, 4000.0), outside = Measure(world, 30000.0, 0.0, 8000.0);
    print_message("heights deviate by %.3f m inside (0.2 of the lagoon), %.3f m outside (0.5 of the sea)\n",
                  inside.deviation, outside.deviation);
    assert_true(fabs(inside.deviation / 0.2 - 1.0) < 0.08 && fabs(outside.deviation / 0.5 - 1.0) < 0.08);
    assert_true(fabs(fabs(inside.axis) - 0.5 * SW_PI) < 0.2 && fabs(outside.axis) < 0.2);

    // Without removing, both are there.
    region.removesWaves = false;
    assert_int_equal(swInput_Set(world, id, &region), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    Measured both = Measure(world, 0.0, 0.0, 4000.0);
    assert_true(fabs(both.deviation / sqrt(0.2 * 0.2 + 0.5 * 0.5) - 1.0) < 0.08);
    swDestroyWorld(world);
}

static float FindWeight(const swWorld* world, swWaveSystemId system, double x)
{
    float weight = 0.0f;
    swFieldSamples samples = {.system = system, .weight = &weight};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, 1.0}, &samples), 0);
    return weight;
}

// Three regions, one over the other: each removes those before it in order, and none after it.
static void RegionsRemoveWhatIsOrderedBeforeThem(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swWaveSystemId systems[3];
    swInputId inputs[3];
    for (int i = 0; i < 3; i++)
    {
        swWaveSystemDef def = MakeSystem(1.0f, 6.0f, 0.0f, 1 + (uint32_t)i);
        def.isLocal = i > 0;
        systems[i] = AddSystem(world, &def);
    }
    for (int i = 0; i < 3; i++)
    {
        swInputDef region = swDefaultInputDef();
        region.field = SW_INPUT_WAVES;
        region.shape = SW_SHAPE_CIRCLE;
        region.size.x = 1000.0f;
        region.value[0] = 1.0f;
        region.blend = i == 0 ? SW_BLEND_MULTIPLY : SW_BLEND_ADD;
        region.value[0] = i == 0 ? 0.5f : 1.0f;
        region.order = i == 2 ? 1 : 2; // the third joins first
        region.removesWaves = i > 0;
        region.weight = i == 1 ? 0.5f : 1.0f;
        region.system = systems[i];
        assert_int_equal(swCreateInput(world, &region, &inputs[i]), SW_SUCCESS);
    }
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    // First the third takes all of the sea; the first's factor has nothing left; the second takes its half of the
    // third's: both are then the root of a half.
    float w[3];
    for (int i = 0; i < 3; i++)
    {
        w[i] = FindWeight(world, systems[i], 10.0);
    }
    print_message("weights %.4f, %.4f, %.4f\n", (double)w[0], (double)w[1], (double)w[2]);
    assert_true(w[0] == 0.0f);
    assert_float_equal(w[1], 0.70710678f, 1e-6f);
    assert_float_equal(w[2], 0.70710678f, 1e-6f);
    assert_true(FindWeight(world, systems[0], 600.0) == 1.0f && FindWeight(world, systems[1], 600.0) == 0.0f);
    swDestroyWorld(world);
}

// Three winds on plateaus as wide as what mixes them.
#define MAP_WIDTH 6
static const double mapSpeeds[3] = {12.0, 7.0, 12.0}, mapHeadings[3] = {0.2, 0.9, 2.2};

static swRaster* MakeMap(double spacing)
{
    float values[2 * MAP_WIDTH * 2];
    for (int row = 0; row < 2; row++)
    {
        for (int i = 0; i < MAP_WIDTH; i++)
        {
            values[2 * (row * MAP_WIDTH + i)] = (float)(mapSpeeds[i / 2] * cos(mapHeadings[i / 2]));
            values[2 * (row * MAP_WIDTH + i) + 1] = (float)(mapSpeeds[i / 2] * sin(mapHeadings[i / 2]));
        }
    }
    swHost host = swDefaultHost();
    swRasterDef def = swDefaultRasterDef();
    def.name = "winds";
    def.width = MAP_WIDTH;
    def.height = 2;
    def.channels = 2;
    def.spacingX = def.spacingZ = spacing;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    return raster;
}

static swWindSeaDef MakeWindSea(const swRaster* raster)
{
    swWindSeaDef def = swDefaultWindSeaDef();
    def.waves = MakeSystem(0.0f, 0.0f, 0.0f, 5);
    def.raster = raster;
    return def;
}

static double FindAskedDeviation(double speed)
{
    swWorld* world = MakeWorld();
    swWaveSystemDef def = MakeSystem(0.0f, 0.0f, 0.0f, 1);
    def.spectrum.windSpeed = (float)speed;
    swWaveSystemId id = AddSystem(world, &def);
    swBandInfo bands[SW_MAX_BANDS];
    int count = swWaveSystem_GetBands(world, id, bands);
    double variance = 0.0;
    for (int i = 0; i < count; i++)
    {
        variance += (double)bands[i].variance;
    }
    swDestroyWorld(world);
    return sqrt(variance);
}

static void AWindMapTurnsAndScalesTheSea(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swRaster* raster = MakeMap(20000.0);
    swWindSeaDef def = MakeWindSea(raster);
    swWindSea sea;
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_SUCCESS);
    swDestroyRaster(raster);
    assert_int_equal(swWorld_Step(world, 50.0), SW_SUCCESS);
    print_message("%d systems\n", sea.count);
    for (int i = 0; i < 3; i++)
    {
        Measured here = Measure(world, 10000.0 + 40000.0 * i, 10000.0, 16000.0);
        double asked = FindAskedDeviation(mapSpeeds[i]);
        double off = remainder(here.axis - mapHeadings[i], SW_PI) * 180.0 / SW_PI;
        print_message(
            "a wind of %.0f m/s from place %d: deviation %.3f m (%.3f asked), direction off by %.1f degrees\n",
            mapSpeeds[i], i, here.deviation, asked, off);
        assert_true(fabs(here.deviation / asked - 1.0) < 0.06 && fabs(off) < 8.0);
    }
    // Between two plateaus the energy of what is mixed is that of the wind there.
    for (int i = 1; i < 8; i++)
    {
        double x = 20000.0 + 2500.0 * i, way = i / 8.0, square = 0.0;
        double u = (1.0 - way) * mapSpeeds[0] * cos(mapHeadings[0]) + way * mapSpeeds[1] * cos(mapHeadings[1]);
        double v = (1.0 - way) * mapSpeeds[0] * sin(mapHeadings[0]) + way * mapSpeeds[1] * sin(mapHeadings[1]);
        for (int s = 0; s < sea.count; s++)
        {
            swWaveSystemDef system = swWaveSystem_Get(world, sea.systems[s]);
            double own = FindAskedDeviation((double)system.spectrum.windSpeed);
            double weight = (double)FindWeight(world, sea.systems[s], x);
            square += weight * weight * own * own;
        }
        double asked = FindAskedDeviation(sqrt(u * u + v * v));
        assert_true(fabs(sqrt(square) / asked - 1.0) < 0.03);
    }
    assert_true(Measure(world, -30000.0, 10000.0, 16000.0).deviation == 0.0);
    swDestroyWindSea(world, &sea);
    assert_int_equal(sea.count, 0);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_true(Measure(world, 10000.0, 10000.0, 16000.0).deviation == 0.0);
    swDestroyWorld(world);
}

// Slopes of the surface by rest position against differences of its height, where headings and a feather mix.
static void SlopesKnowTheGradientsOfWeights(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swRaster* raster = MakeMap(500.0);
    swWindSeaDef def = MakeWindSea(raster);
    swWaveSystemDef swell = MakeSystem(1.0f, 9.0f, 2.0f, 77);
    AddSystem(world, &swell);
    def.removesWaves = true;
    def.feather = 300.0f;
    def.position = (swPos){-200.0, 0.0, 0.0};
    swWindSea sea;
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_SUCCESS);
    swDestroyRaster(raster);
    assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
    const double d = 0.02;
    double worst = 0.0, steepest = 0.0;
    for (int i = 0; i < 400; i++)
    {
        // Across the feathered edge of the map, and on it.
        swPosXZ at = {-210.0 + 5.3 * i, 40.0 + 1.1 * i};
        swPosXZ points[5] = {at, {at.x + d, at.z}, {at.x - d, at.z}, {at.x, at.z + d}, {at.x, at.z - d}};
        swVec3 displacement[5];
        swVec2 slopes[5];
        swQueryDef query = swDefaultQueryDef();
        swSurfaceSamples samples = {.displacement = displacement};
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, 5, points, &samples, slopes, NULL);
        double alongX = (double)(displacement[1].y - displacement[2].y) / (2.0 * d);
        double alongZ = (double)(displacement[3].y - displacement[4].y) / (2.0 * d);
        worst = fmax(worst, fmax(fabs(alongX - (double)slopes[0].x), fabs(alongZ - (double)slopes[0].y)));
        steepest = fmax(steepest, fabs(alongX));
    }
    print_message("slopes of up to %.3f are off by %.1e\n", steepest, worst);
    assert_true(steepest > 0.02 && worst < 1e-4);
    swDestroyWorld(world);
}

// Eight local systems are no sea of eight times the energy.
static void WhitecapsOfAWindMapAreThoseOfItsStrongestWind(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swRaster* raster = MakeMap(20000.0);
    swWindSeaDef def = MakeWindSea(raster);
    swWindSea sea;
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_SUCCESS);
    swDestroyRaster(raster);
    swWorld* single = MakeWorld();
    swWaveSystemDef own = MakeSystem(0.0f, 0.0f, 0.2f, 9);
    own.spectrum.windSpeed = 12.0f;
    AddSystem(single, &own);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    assert_int_equal(swWorld_Step(single, 0.0), SW_SUCCESS);
    swFoamState map = swWorld_GetFoamState(world), one = swWorld_GetFoamState(single);
    print_message("wind %.2f and %.2f m/s, cover %.4f and %.4f, threshold %.3f and %.3f\n", (double)map.windSpeed,
                  (double)one.windSpeed, (double)map.cover, (double)one.cover, (double)map.threshold,
                  (double)one.threshold);
    assert_true(fabsf(map.windSpeed - one.windSpeed) < 0.5f);
    assert_true(fabsf(map.cover / one.cover - 1.0f) < 0.1f && fabsf(map.threshold - one.threshold) < 0.05f);
    swDestroyWindSea(world, &sea);
    swDestroyWorld(world);
    swDestroyWorld(single);
}

static void WhatIsNoWindSeaIsRefused(void** state)
{
    (void)state;
    swWorld* world = MakeWorld();
    swRaster* raster = MakeMap(20000.0);
    swWindSeaDef def = MakeWindSea(raster);
    swWindSea sea;
    def.waves.spectrum.significantHeight = 2.0f;
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_ERROR_INVALID);
    def = MakeWindSea(NULL);
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_ERROR_INVALID);
    def = MakeWindSea(raster);
    def.gain = 0.01f;
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_ERROR_INVALID);
    def.gain = 1.0f;
    def.waves.minWavelength = 0.25f;
    def.headingCount = 64;
    def.speedCount = 4;
    size_t before = swWorld_GetMemory(world);
    assert_int_equal(swCreateWindSea(world, &def, &sea), SW_ERROR_LIMIT);
    assert_int_equal(sea.count, 0);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    print_message("%zu bytes before, %zu after\n", before, swWorld_GetMemory(world));
    swDestroyRaster(raster);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TwoWeightsHaveSquaresThatAddUpToOne),
        cmocka_unit_test(HeadingsMixWithoutJumpsAndKeepTheEnergy),
        cmocka_unit_test(SpeedsMixToTheEnergyThatTheLawAsksFor),
        cmocka_unit_test(GradientsOfWeightsAreDerivatives),
        cmocka_unit_test(ARegionBringsItsWavesAndRemovesThoseBelow),
        cmocka_unit_test(RegionsRemoveWhatIsOrderedBeforeThem),
        cmocka_unit_test(AWindMapTurnsAndScalesTheSea),
        cmocka_unit_test(SlopesKnowTheGradientsOfWeights),
        cmocka_unit_test(WhitecapsOfAWindMapAreThoseOfItsStrongestWind),
        cmocka_unit_test(WhatIsNoWindSeaIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
