// SPDX-License-Identifier: MIT

// Rays and sweeping spheres against the surface.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "core/math/random.h"
#include <seaway/seaway.h>

static swWorld* OpenSea(bool withWaves)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.seaLevel = 10.0;
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    if (withWaves)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.minWavelength = 2.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    }
    assert_int_equal(swWorld_Step(world, 5.0), SW_SUCCESS);
    return world;
}

static void FlatWaterIsHitWhereGeometrySays(void** state)
{
    (void)state;
    swWorld* world = OpenSea(false);
    swQueryDef query = swDefaultQueryDef();
    swRay rays[5];
    swRayHit hits[5];
    rays[0] = swDefaultRay((swPos){5.0, 40.0, -2.0}, (swVec3){0.0f, -2.0f, 0.0f});
    rays[1] = swDefaultRay((swPos){0.0, 40.0, 0.0}, (swVec3){1.0f, -1.0f, 0.0f});
    rays[2] = swDefaultRay((swPos){0.0, 4.0, 0.0}, (swVec3){0.0f, 1.0f, 0.0f});  // from below
    rays[3] = swDefaultRay((swPos){0.0, 40.0, 0.0}, (swVec3){1.0f, 0.0f, 0.0f}); // past it
    rays[4] = swDefaultRay((swPos){0.0, 40.0, 0.0}, (swVec3){0.0f, -1.0f, 0.0f});
    rays[4].radius = 2.0f;
    swMoment_CastRays(swWorld_GetMoment(world), &query, 5, rays, hits, NULL);
    assert_true(hits[0].isHit && fabsf(hits[0].distance - 30.0f) < 0.001f);
    assert_true(hits[1].isHit && fabsf(hits[1].distance - 42.4264f) < 0.002f);
    assert_float_equal(hits[1].position.x, 30.0, 0.002);
    assert_true(hits[1].normal.y == 1.0f && !hits[1].fromBelow);
    assert_true(hits[2].isHit && fabsf(hits[2].distance - 6.0f) < 0.001f && hits[2].fromBelow);
    assert_false(hits[3].isHit);
    assert_true(hits[3].distance == 1000.0f);
    assert_true(hits[4].isHit && fabsf(hits[4].distance - 28.0f) < 0.001f);
    assert_float_equal(hits[4].point.y, 10.0, 0.001);
    swDestroyWorld(world);
}

// Marches in millimetres near the hit and centimetres before: no earlier crossing, and a crossing there.
static void HitsAreTheFirstCrossing(void** state)
{
    (void)state;
    swWorld* world = OpenSea(true);
    enum
    {
        RAYS = 120
    };
    static swRay rays[RAYS];
    static swRayHit hits[RAYS];
    for (int i = 0; i < RAYS; ++i)
    {
        double u[6];
        for (int k = 0; k < 6; ++k)
        {
            u[k] = swHashToUnit(swHashWave(9, 0, i, k, 0));
        }
        bool isBelow = i % 4 == 3;
        rays[i] = swDefaultRay(
            (swPos){400.0 * u[0], isBelow ? 0.0 : 16.0 + 10.0 * u[1], 400.0 * u[2]},
            (swVec3){(float)(u[3] - 0.5), (float)((isBelow ? 0.6 : -0.6) * u[4] - 0.02), (float)(u[5] - 0.5)});
        rays[i].maxDistance = 200.0f;
    }
    swQueryDef query = swDefaultQueryDef();
    swMoment_CastRays(swWorld_GetMoment(world), &query, RAYS, rays, hits, NULL);
    int hitCount = 0;
    double worst = 0.0;
    for (int i = 0; i < RAYS; ++i)
    {
        double length =
            sqrt((double)(rays[i].direction.x * rays[i].direction.x + rays[i].direction.y * rays[i].direction.y +
                          rays[i].direction.z * rays[i].direction.z));
        double end = hits[i].isHit ? (double)hits[i].distance : 200.0;
        double side = i % 4 == 3 ? -1.0 : 1.0;
        for (double at = 0.0; at < end - 0.02; at += 0.1)
        {
            double x = rays[i].origin.x + (double)rays[i].direction.x / length * at;
            double y = rays[i].origin.y + (double)rays[i].direction.y / length * at;
            double z = rays[i].origin.z + (double)rays[i].direction.z / length * at;
            double gap = side * (y - swMoment_GetHeight(swWorld_GetMoment(world), x, z));
            assert_true(gap > -0.01);
        }
        if (hits[i].isHit)
        {
            double height = swMoment_GetHeight(swWorld_GetMoment(world), hits[i].position.x, hits[i].position.z);
            worst = fmax(worst, fabs(height - hits[i].position.y));
            hitCount += 1;
        }
    }
    print_message("%d of %d rays hit, at most %.2f mm from the surface\n", hitCount, RAYS, 1000.0 * worst);
    assert_true(hitCount > RAYS / 2 && worst < 0.0015);
    swDestroyWorld(world);
}

static void ASphereStopsItsRadiusBeforeTheSurface(void** state)
{
    (void)state;
    swWorld* world = OpenSea(true);
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 32.0f;
    for (int i = 0; i < 30; ++i)
    {
        swRay ray = swDefaultRay((swPos){13.0 * i, 30.0, 7.0 * i}, (swVec3){0.5f, -1.0f, 0.1f});
        ray.radius = 1.5f;
        swRayHit hit;
        swMoment_CastRays(swWorld_GetMoment(world), &query, 1, &ray, &hit, NULL);
        assert_true(hit.isHit);
        // The nearest water of a dense patch below.
        double nearest = 1e9;
        for (int j = 0; j < 41 * 41; ++j)
        {
            swPosXZ point = {hit.position.x + 0.1 * (j % 41 - 20), hit.position.z + 0.1 * (j / 41 - 20)};
            float height;
            swSurfaceSamples samples = {.height = &height};
            swMoment_QuerySurface(swWorld_GetMoment(world), &query, 1, &point, &samples, NULL);
            double dx = point.x - hit.position.x, dy = (double)height - hit.position.y, dz = point.z - hit.position.z;
            nearest = fmin(nearest, sqrt(dx * dx + dy * dy + dz * dz));
        }
        assert_float_equal(nearest, 1.5, 0.05);
    }
    swDestroyWorld(world);
}

static void ASlowBallMeetsTheWaterOfItsMoment(void** state)
{
    (void)state;
    swWorld* world = OpenSea(true);
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 4.0f;
    swRay ray = swDefaultRay((swPos){50.0, 30.0, 20.0}, (swVec3){0.2f, -1.0f, 0.0f});
    ray.maxDistance = 40.0f;
    ray.duration = 20.0f;
    swRayHit hit;
    swMoment_CastRays(swWorld_GetMoment(world), &query, 1, &ray, &hit, NULL);
    assert_true(hit.isHit);
    query.time = 5.0 + 20.0 * (double)hit.distance / 40.0;
    swPosXZ point = {hit.position.x, hit.position.z};
    float height;
    swSurfaceSamples samples = {.height = &height};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 1, &point, &samples, NULL);
    assert_float_equal(height, hit.position.y, 0.002);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(FlatWaterIsHitWhereGeometrySays),
        cmocka_unit_test(HitsAreTheFirstCrossing),
        cmocka_unit_test(ASphereStopsItsRadiusBeforeTheSurface),
        cmocka_unit_test(ASlowBallMeetsTheWaterOfItsMoment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
