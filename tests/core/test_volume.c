// SPDX-License-Identifier: MIT

// The motion of the water: at the surface, at other times, and below.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "core/math/random.h"
#include <seaway/seaway.h>

enum
{
    POINTS = 200
};

static swWorld* OpenSea(bool withTexels, float depth, bool withFreeWaves)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableVelocity = withTexels;
    worldDef.enableAcceleration = withTexels;
    worldDef.seaLevel = 3.0;
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.depth = depth;
    def.minWavelength = 0.5f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    if (withFreeWaves)
    {
        def.method = SW_WAVES_GERSTNER;
        def.spectrum.direction = 1.0f;
        def.spectrum.significantHeight = 1.0f;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    }
    assert_int_equal(swWorld_Step(world, 30.0), SW_SUCCESS);
    return world;
}

static void MakePoints(swPosXZ points[POINTS])
{
    for (int i = 0; i < POINTS; ++i)
    {
        points[i].x = 2000.0 * (swHashToUnit(swHashWave(3, 0, i, 0, 0)) - 0.5);
        points[i].z = 2000.0 * (swHashToUnit(swHashWave(3, 0, i, 1, 0)) - 0.5);
    }
}

static double Distance(swVec3 a, swVec3 b)
{
    double x = (double)(a.x - b.x), y = (double)(a.y - b.y), z = (double)(a.z - b.z);
    return sqrt(x * x + y * y + z * z);
}

static double RootMeanSquare(const swVec3* a, const swVec3* b)
{
    swVec3 zero = {0.0f, 0.0f, 0.0f};
    double sum = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        double d = Distance(a[i], b != NULL ? b[i] : zero);
        sum += d * d;
    }
    return sqrt(sum / POINTS);
}

// Velocity and acceleration of particles against differences of their places.
static void VelocityIsTheRateOfDisplacement(void** state)
{
    (void)state;
    const double h = 1.0 / 64.0;
    for (int withTexels = 0; withTexels < 2; ++withTexels)
    {
        swWorld* world = OpenSea(withTexels, INFINITY, true);
        static swPosXZ points[POINTS];
        static swVec3 at[3][POINTS], velocity[POINTS], acceleration[POINTS], rate[POINTS], second[POINTS];
        MakePoints(points);
        swQueryDef query = swDefaultQueryDef();
        swSurfaceSamples motion = {.velocity = velocity, .acceleration = acceleration};
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, POINTS, points, &motion, NULL, NULL);
        for (int k = 0; k < 3; ++k)
        {
            swWorld_SetTime(world, 30.0 + (k - 1) * h);
            swWorld_Step(world, 0.0);
            swSurfaceSamples samples = {.displacement = at[k]};
            swMoment_QueryParticles(swWorld_GetMoment(world), &query, POINTS, points, &samples, NULL, NULL);
        }
        for (int i = 0; i < POINTS; ++i)
        {
            rate[i] =
                (swVec3){(at[2][i].x - at[0][i].x) / (float)(2.0 * h), (at[2][i].y - at[0][i].y) / (float)(2.0 * h),
                         (at[2][i].z - at[0][i].z) / (float)(2.0 * h)};
            second[i] = (swVec3){(at[2][i].x - 2.0f * at[1][i].x + at[0][i].x) / (float)(h * h),
                                 (at[2][i].y - 2.0f * at[1][i].y + at[0][i].y) / (float)(h * h),
                                 (at[2][i].z - 2.0f * at[1][i].z + at[0][i].z) / (float)(h * h)};
        }
        double velocityError = RootMeanSquare(velocity, rate) / RootMeanSquare(velocity, NULL);
        double accelerationError = RootMeanSquare(acceleration, second) / RootMeanSquare(acceleration, NULL);
        print_message("%s: velocity within %.2f %%, acceleration within %.2f %% of differences\n",
                      withTexels ? "texels" : "one by one", 100.0 * velocityError, 100.0 * accelerationError);
        assert_true(velocityError < 0.01);
        assert_true(accelerationError < 0.04); // differences of floats a 64th of a second apart
        swDestroyWorld(world);
    }
}

static void AnotherTimeIsWhatASteppedWorldHas(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY, true);
    static swPosXZ points[POINTS];
    static float then[POINTS], stepped[POINTS];
    static swVec3 normalThen[POINTS], normalStepped[POINTS];
    MakePoints(points);
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 1.0f;
    for (int past = 0; past < 2; ++past)
    {
        double time = past ? -250.0 : 400.0;
        query.time = time;
        swSurfaceSamples samples = {.height = then, .normal = normalThen};
        swQueryStats stats;
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &samples, &stats);
        assert_true(stats.convergedCount > POINTS * 98 / 100);
        swWorld_SetTime(world, time);
        swWorld_Step(world, 0.0);
        query.time = SW_QUERY_NOW;
        samples = (swSurfaceSamples){.height = stepped, .normal = normalStepped};
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &samples, NULL);
        double sum = 0.0;
        for (int i = 0; i < POINTS; ++i)
        {
            sum += ((double)then[i] - (double)stepped[i]) * ((double)then[i] - (double)stepped[i]);
        }
        double height = sqrt(sum / POINTS);
        double normal = RootMeanSquare(normalThen, normalStepped);
        print_message("at %.0f s: heights differ by %.2f mm (rms), normals by %.4f\n", time, 1000.0 * height, normal);
        assert_true(height < 0.006 && normal < 0.02);
        swWorld_SetTime(world, 30.0);
        swWorld_Step(world, 0.0);
    }
    swDestroyWorld(world);
}

// One wave, all depths, against Airy's formulas.
static void OneWaveMovesTheWaterAsAiryHasIt(void** state)
{
    (void)state;
    const double depths[] = {20.0, 5.0, HUGE_VAL};
    for (int d = 0; d < 3; ++d)
    {
        double period = 8.0, a = 1.0, depth = depths[d];
        double omega = 2.0 * SW_PI / period;
        double k = omega * omega / 9.81;
        for (int i = 0; i < 200 && depth < 1e9; ++i)
        {
            k = omega * omega / (9.81 * tanh(k * depth)) * 0.5 + 0.5 * k;
        }
        const swWaveComponent wave = {
            .wavelength = (float)(2.0 * SW_PI / k), .direction = -0.4f, .amplitude = (float)a};
        swHost host = swDefaultHost();
        swWorldDef worldDef = swDefaultWorldDef();
        worldDef.surfaceTension = 0.0f;
        swWorld* world;
        swWaveSystemId id;
        assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.method = SW_WAVES_GERSTNER;
        def.components = &wave;
        def.componentCount = 1;
        def.spectrum.depth = (float)depth;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
        swWorld_Step(world, 3.0);
        double worst = 0.0;
        for (int i = 0; i < 300; ++i)
        {
            double bottom = depth < 1e9 ? depth : 60.0;
            swPos place = {3.3 * i, -bottom * (i % 30) / 29.0, -1.1 * i};
            swQueryDef query = swDefaultQueryDef();
            query.stretching = SW_STRETCHING_LINEAR;
            swVec3 v, acceleration;
            float head, below;
            swVolumeSamples samples = {
                .depth = &below, .velocity = &v, .acceleration = &acceleration, .pressureHead = &head};
            swMoment_QueryVolume(swWorld_GetMoment(world), &query, 1, &place, &samples, NULL);
            if (below < 0.0f)
            {
                continue; // in a trough
            }
            double theta = k * (cos(-0.4) * place.x + sin(-0.4) * place.z) - omega * 3.0;
            bool isDeep = depth > 1e9;
            double fh = isDeep ? exp(k * place.y) : cosh(k * (place.y + depth)) / sinh(k * depth);
            double fv = isDeep ? exp(k * place.y) : sinh(k * (place.y + depth)) / sinh(k * depth);
            double fp = isDeep ? exp(k * place.y) : cosh(k * (place.y + depth)) / cosh(k * depth);
            double u = a * omega * fh * cos(theta);
            worst = fmax(worst, fabs((double)v.x - u * cos(-0.4)));
            worst = fmax(worst, fabs((double)v.z - u * sin(-0.4)));
            worst = fmax(worst, fabs((double)v.y - a * omega * fv * sin(theta)));
            worst = fmax(worst, fabs((double)acceleration.y + a * omega * omega * fv * cos(theta)));
            worst = fmax(worst, fabs((double)head - a * fp * cos(theta)));
        }
        print_message("depth %g m: worst difference to Airy %.2g\n", depth, worst);
        assert_true(worst < 2e-3);
        swVec2 drift = swMoment_GetStokesDrift(swWorld_GetMoment(world), 5.0);
        if (depth > 1e9)
        {
            assert_float_equal(sqrt((double)drift.x * (double)drift.x + (double)drift.y * (double)drift.y), 0.02633,
                               2e-4);
            assert_float_equal(atan2((double)drift.y, (double)drift.x), -0.4, 1e-4);
        }
        swDestroyWorld(world);
    }
}

static swVec3 GetVelocity(const swWorld* world, const swQueryDef* query, double x, double y, double z)
{
    swPos place = {x, y, z};
    swVec3 velocity;
    swVolumeSamples samples = {.velocity = &velocity};
    swMoment_QueryVolume(swWorld_GetMoment(world), query, 1, &place, &samples, NULL);
    return velocity;
}

static void LinearMotionIsFreeOfDivergence(void** state)
{
    (void)state;
    for (int shallow = 0; shallow < 2; ++shallow)
    {
        swWorld* world = OpenSea(false, shallow ? 25.0f : INFINITY, true);
        swQueryDef query = swDefaultQueryDef();
        query.stretching = SW_STRETCHING_LINEAR;
        double worst = 0.0;
        for (int i = 0; i < 40; ++i)
        {
            double x = 17.0 * i, y = 3.0 - 6.0 - 0.4 * i, z = 5.0 * i; // 6 m and more below still water
            double h = 0.25;
            double divergence =
                (double)(GetVelocity(world, &query, x + h, y, z).x - GetVelocity(world, &query, x - h, y, z).x);
            divergence +=
                (double)(GetVelocity(world, &query, x, y + h, z).y - GetVelocity(world, &query, x, y - h, z).y);
            divergence +=
                (double)(GetVelocity(world, &query, x, y, z + h).z - GetVelocity(world, &query, x, y, z - h).z);
            worst = fmax(worst, fabs(divergence / (2.0 * h)));
        }
        print_message("largest divergence %.2g per second\n", worst);
        assert_true(worst < 1e-4); // differences of floats near 1 over half a metre; rates themselves are near 0.1
        swDestroyWorld(world);
    }
}

static void StretchedMotionMeetsTheSurface(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY, false);
    static swPosXZ points[POINTS];
    static float heights[POINTS];
    MakePoints(points);
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 8.0f;
    swSurfaceSamples surface = {.height = heights};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &surface, NULL);
    static swPos places[POINTS];
    static float depth[POINTS];
    static swVec3 velocity[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        places[i] = (swPos){points[i].x, (double)heights[i] + (i % 2 == 0 ? -0.01 : 0.01), points[i].z};
    }
    swVolumeSamples volume = {.depth = depth, .velocity = velocity};
    swMoment_QueryVolume(swWorld_GetMoment(world), &query, POINTS, places, &volume, NULL);
    for (int i = 0; i < POINTS; ++i)
    {
        bool isMoving = velocity[i].x != 0.0f || velocity[i].y != 0.0f;
        assert_true(fabsf(depth[i] - (i % 2 == 0 ? 0.01f : -0.01f)) < 2e-3f);
        assert_int_equal(isMoving, i % 2 == 0);
    }
    swDestroyWorld(world);
}

static void AHeightMapHasTheHeightsOfItsPoints(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false, INFINITY, true);
    enum
    {
        WIDTH = 150,
        HEIGHT = 40
    };
    static float heights[HEIGHT][WIDTH], single[WIDTH];
    const double spacings[] = {0.5, 7.0};
    for (int s = 0; s < 2; ++s)
    {
        swHeightMapDef map = {-20.0, 55.0, spacings[s], WIDTH, HEIGHT};
        swQueryDef query = swDefaultQueryDef();
        swQueryStats stats;
        swMoment_QueryHeightMap(swWorld_GetMoment(world), &query, &map, heights[0], &stats);
        for (int j = 0; j < HEIGHT; ++j)
        {
            swPosXZ points[WIDTH];
            for (int i = 0; i < WIDTH; ++i)
            {
                points[i] = (swPosXZ){map.originX + map.spacing * i, map.originZ + map.spacing * j};
            }
            swSurfaceSamples samples = {.height = single};
            swMoment_QuerySurface(swWorld_GetMoment(world), &query, WIDTH, points, &samples, NULL);
            assert_memory_equal(single, heights[j], sizeof single);
        }
        assert_true(stats.convergedCount > WIDTH * HEIGHT * 99 / 100);
    }
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(VelocityIsTheRateOfDisplacement), cmocka_unit_test(AnotherTimeIsWhatASteppedWorldHas),
        cmocka_unit_test(OneWaveMovesTheWaterAsAiryHasIt), cmocka_unit_test(LinearMotionIsFreeOfDivergence),
        cmocka_unit_test(StretchedMotionMeetsTheSurface),  cmocka_unit_test(AHeightMapHasTheHeightsOfItsPoints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
