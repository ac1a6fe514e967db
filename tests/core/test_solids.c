// SPDX-License-Identifier: MIT
// Distances from solids against the nearest of many points on their surfaces.

#include "support/cmocka_setup.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "shared/shape_solids.h"

#define SURFACE_POINTS 1000000

typedef struct Solid
{
    const char* name;
    float (*distance)(float x, float y, float z);
    swVec3 (*surface)(float u, float v); // u, v in [0, 1)
    float half;                          // of a cube around it
} Solid;

static float EllipsoidDistance(float x, float y, float z)
{
    return swEllipsoidDistance(x, y, z, 5.0f, 1.0f, 2.0f);
}

static swVec3 EllipsoidSurface(float u, float v)
{
    float up = 2.0f * v - 1.0f, around = 6.2831853f * u, level = sqrtf(1.0f - up * up);
    return (swVec3){5.0f * level * cosf(around), 1.0f * up, 2.0f * level * sinf(around)};
}

static float DiscDistance(float x, float y, float z)
{
    return swEllipsoidDistance(x, y, z, 4.0f, 0.2f, 4.0f);
}

static swVec3 DiscSurface(float u, float v)
{
    swVec3 p = EllipsoidSurface(u, v);
    return (swVec3){p.x * 0.8f, p.y * 0.2f, p.z * 2.0f};
}

static float CylinderDistance(float x, float y, float z)
{
    return swCylinderDistance(x, y, z, 3.0f, 1.5f, 1.0f, 0.0f);
}

// Half of the points on the side, a quarter on each end.
static swVec3 CylinderSurface(float u, float v)
{
    float around = 6.2831853f * u;
    if (v < 0.5f)
    {
        return (swVec3){3.0f * cosf(around), 6.0f * v - 1.5f, sinf(around)};
    }
    float part = v < 0.75f ? sqrtf(4.0f * (v - 0.5f)) : sqrtf(4.0f * (v - 0.75f));
    return (swVec3){3.0f * part * cosf(around), v < 0.75f ? 1.5f : -1.5f, part * sinf(around)};
}

static float CapsuleDistance(float x, float y, float z)
{
    return swCapsuleDistance(x, y, z, 1.0f, 2.5f);
}

static swVec3 CapsuleSurface(float u, float v)
{
    float around = 6.2831853f * u, w = 5.0f * v - 2.5f;
    float beyond = fabsf(w) - 1.5f;
    float radius = beyond > 0.0f ? sqrtf(fmaxf(1.0f - beyond * beyond, 0.0f)) : 1.0f;
    return (swVec3){radius * cosf(around), w, radius * sinf(around)};
}

static float BoxDistance(float x, float y, float z)
{
    return swBoxDistance(x, y, z, 3.0f, 1.0f, 2.0f, 0.0f);
}

static swVec3 BoxSurface(float u, float v)
{
    float face = floorf(6.0f * u), a = 2.0f * (6.0f * u - face) - 1.0f, b = 2.0f * v - 1.0f;
    float side = face < 3.0f ? 1.0f : -1.0f;
    int axis = (int)face % 3;
    swVec3 p = axis == 0 ? (swVec3){side, a, b} : (axis == 1 ? (swVec3){a, side, b} : (swVec3){a, b, side});
    return (swVec3){3.0f * p.x, p.y, 2.0f * p.z};
}

static const Solid s_solids[] = {
    {"ellipsoid 5 x 1 x 2", EllipsoidDistance, EllipsoidSurface, 6.0f},
    {"disc 4 x 0.2 x 4", DiscDistance, DiscSurface, 5.0f},
    {"elliptic cylinder", CylinderDistance, CylinderSurface, 4.0f},
    {"capsule", CapsuleDistance, CapsuleSurface, 3.5f},
    {"box", BoxDistance, BoxSurface, 4.0f},
};

static float FindNearest(const swVec3* surface, swVec3 p)
{
    float least = INFINITY;
    for (int i = 0; i < SURFACE_POINTS; ++i)
    {
        float x = surface[i].x - p.x, y = surface[i].y - p.y, z = surface[i].z - p.z;
        least = fminf(least, x * x + y * y + z * z);
    }
    return sqrtf(least);
}

static void DistancesAreThoseOfTheNearestPointOfTheSurface(void** state)
{
    (void)state;
    swVec3* surface = malloc(SURFACE_POINTS * sizeof(swVec3));
    for (size_t s = 0; s < sizeof(s_solids) / sizeof(s_solids[0]); ++s)
    {
        const Solid* solid = &s_solids[s];
        for (int i = 0; i < SURFACE_POINTS; ++i)
        {
            surface[i] = solid->surface((float)(i % 1000) / 1000.0f, ((float)(i / 1000) + 0.5f) / 1000.0f);
        }
        uint32_t seed = 7;
        double worst = 0.0;
        for (int i = 0; i < 150; ++i)
        {
            float side = 2.0f * solid->half;
            swVec3 p = {side * ((float)NextPart(&seed) - 0.5f), side * ((float)NextPart(&seed) - 0.5f),
                        side * ((float)NextPart(&seed) - 0.5f)};
            float distance = solid->distance(p.x, p.y, p.z);
            worst = fmax(worst, (double)fabsf(fabsf(distance) - FindNearest(surface, p)));
        }
        printf("%s: off by at most %.4f m\n", solid->name, worst);
        assert_true(worst < 0.01);
    }
    free(surface);
}

// The measure of an ellipsoid: near its edge within one in a hundred of the distance.
static void NearTheEdgeOfAnEllipsoidTheErrorIsFarBelowAHundredth(void** state)
{
    (void)state;
    uint32_t seed = 11;
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i)
    {
        swVec3 on = EllipsoidSurface((float)NextPart(&seed), (float)NextPart(&seed));
        swVec3 n = {on.x / 25.0f, on.y, on.z / 4.0f};
        float length = sqrtf(n.x * n.x + n.y * n.y + n.z * n.z);
        // Less than the least radius of curvature on the inside, 1 / 5 m at the tips.
        float away = (float)(0.3 * NextPart(&seed) - 0.1);
        away = fabsf(away) < 0.001f ? 0.001f : away;
        float distance =
            EllipsoidDistance(on.x + away * n.x / length, on.y + away * n.y / length, on.z + away * n.z / length);
        worst = fmax(worst, (double)fabsf(distance - away) / fmax((double)fabsf(away), 0.01));
    }
    printf("ellipsoid 5 x 1 x 2 near its edge: off by at most %.2e of the distance\n", worst);
    assert_true(worst < 1e-3);
}

static void EdgesOfRoundedSolidsAreRound(void** state)
{
    (void)state;
    float diagonal = 0.5f / sqrtf(3.0f);
    float corner = swBoxDistance(1.0f + diagonal, 2.0f + diagonal, 3.0f + diagonal, 1.5f, 2.5f, 3.5f, 0.5f);
    assert_float_equal(corner, 0.0f, 1e-6f);
    assert_float_equal(swBoxDistance(1.5f, 0.0f, 0.0f, 1.5f, 2.5f, 3.5f, 0.5f), 0.0f, 1e-6f);
    assert_float_equal(swCylinderDistance(1.0f, 2.0f, 0.0f, 1.0f, 2.0f, 1.0f, 0.5f), 0.5f * (sqrtf(2.0f) - 1.0f),
                       1e-6f);
    // Rounded by more than it is wide, a box becomes a capsule or a sphere.
    assert_float_equal(swBoxDistance(0.0f, 3.0f, 0.0f, 1.0f, 2.0f, 1.0f, 50.0f), 1.0f, 1e-6f);
    assert_float_equal(swBoxDistance(0.0f, 0.0f, 2.0f, 1.0f, 2.0f, 1.0f, 50.0f), 1.0f, 1e-6f);
}

static void TheMiddleOfASolidIsInsideByItsLeastHalf(void** state)
{
    (void)state;
    assert_float_equal(swEllipsoidDistance(0.0f, 0.0f, 0.0f, 3.0f, 3.0f, 3.0f), -3.0f, 1e-3f);
    assert_float_equal(swEllipsoidDistance(0.0f, 0.0f, 0.0f, 5.0f, 1.0f, 2.0f), -1.0f, 1e-3f);
    assert_float_equal(swEllipseDistance(0.0f, 0.0f, 1.0f, 2.0f), -1.0f, 1e-3f);
    assert_float_equal(swBoxDistance(0.0f, 0.0f, 0.0f, 5.0f, 1.0f, 2.0f, 0.0f), -1.0f, 0.0f);
}

static void ATurnedVectorIsSeenFromTheTurnedAxes(void** state)
{
    (void)state;
    float half = sqrtf(0.5f);
    // A quarter of a turn about y, which takes z to x.
    swVec3 own = swTurnBack((swVec4){0.0f, half, 0.0f, half}, 1.0f, 2.0f, 0.0f);
    assert_float_equal(own.x, 0.0f, 1e-6f);
    assert_float_equal(own.y, 2.0f, 1e-6f);
    assert_float_equal(own.z, 1.0f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(DistancesAreThoseOfTheNearestPointOfTheSurface),
        cmocka_unit_test(NearTheEdgeOfAnEllipsoidTheErrorIsFarBelowAHundredth),
        cmocka_unit_test(EdgesOfRoundedSolidsAreRound),
        cmocka_unit_test(TheMiddleOfASolidIsInsideByItsLeastHalf),
        cmocka_unit_test(ATurnedVectorIsSeenFromTheTurnedAxes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
