// SPDX-License-Identifier: MIT
// Holes in the water: what queries and rays say of them.

#include "support/cmocka_setup.h"
#include "support/hull_meshes.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>

#include <seaway/seaway.h>

#include "shared/shape_solids.h"

#define POINTS 2000

static swWorld* MakeWorld(bool hasWaves)
{
    swHost host = MakeHost();
    swWorldDef def = swDefaultWorldDef();
    def.seaLevel = 3.0;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    if (hasWaves)
    {
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.resolution = 32;
        waves.tileWaves = 8;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &waves, &id), SW_SUCCESS);
    }
    return world;
}

static swInputDef MakeClip(swInputShape shape, float value, int order)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_CLIP;
    def.shape = shape;
    def.value[0] = value;
    def.order = order;
    return def;
}

static swInputId Add(swWorld* world, const swInputDef* def)
{
    swInputId id;
    s_messages[0] = '\0';
    if (swCreateInput(world, def, &id) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return id;
}

static bool IsClippedAt(const swWorld* world, double x, double z)
{
    bool isClipped;
    const swQueryDef query = swDefaultQueryDef();
    const swSurfaceSamples samples = {.isClipped = &isClipped};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 1, &(swPosXZ){x, z}, &samples, NULL);
    return isClipped;
}

static float ClipFieldAt(const swWorld* world, double x, double z)
{
    float clip;
    const swFieldSamples samples = {.clip = &clip};
    swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, z}, &samples);
    return clip;
}

static void WithoutInputsNothingIsClipped(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, 0.0, 0.0));
    assert_false(IsClippedAt(world, (double)NAN, 0.0));
    assert_float_equal(ClipFieldAt(world, 0.0, 0.0), 0.0f, 0.0f);
    swDestroyWorld(world);
}

static void AnAreaIsCutAndAnotherWithinIsLeft(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swInputDef cut = MakeClip(SW_SHAPE_CIRCLE, 1.0f, 0), leave = MakeClip(SW_SHAPE_RECTANGLE, 0.0f, 1);
    swInputDef again = MakeClip(SW_SHAPE_CIRCLE, 1.0f, 2);
    cut.size.x = 100.0f;
    leave.size = (swVec3){40.0f, 0.0f, 20.0f};
    again.size.x = 4.0f;
    // Made in another order than they join in.
    Add(world, &again);
    Add(world, &leave);
    swInputId first = Add(world, &cut);
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, 50.1, 0.0));
    assert_true(IsClippedAt(world, 49.9, 0.0));
    assert_true(IsClippedAt(world, 0.0, 10.1));
    assert_false(IsClippedAt(world, 0.0, 9.9));
    assert_true(IsClippedAt(world, 1.9, 0.0));
    assert_float_equal(ClipFieldAt(world, 50.2, 0.0), 0.3f, 1e-4f);
    assert_float_equal(ClipFieldAt(world, 49.8, 0.0), 0.7f, 1e-4f);

    // Moved, disabled, destroyed while running.
    swInput_Move(world, first, (swPos){1000.0, 0.0, 0.0}, (swAngles){0.0f, 0.0f, 0.0f});
    assert_true(IsClippedAt(world, 49.9, 0.0)); // until the next step
    swWorld_Step(world, 0.1);
    assert_false(IsClippedAt(world, 49.9, 0.0));
    assert_true(IsClippedAt(world, 1049.9, 0.0));
    swInput_Enable(world, first, false);
    swWorld_Step(world, 0.1);
    assert_false(IsClippedAt(world, 1049.9, 0.0));
    swInput_Enable(world, first, true);
    swWorld_Step(world, 0.1);
    assert_true(IsClippedAt(world, 1049.9, 0.0));
    swDestroyInput(world, first);
    swWorld_Step(world, 0.1);
    assert_false(IsClippedAt(world, 1049.9, 0.0));
    swDestroyWorld(world);
}

static void ASeaThatIsDryHasWaterWhereItIsLeft(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swInputDef dry = MakeClip(SW_SHAPE_EVERYWHERE, 1.0f, -1000000), lake = MakeClip(SW_SHAPE_POLYGON, 0.0f, 0);
    const swInputPoint shore[] = {{.x = -50.0f, .z = -50.0f},
                                  {.x = 50.0f, .z = -50.0f},
                                  {.x = 0.0f, .z = 0.0f},
                                  {.x = 50.0f, .z = 50.0f},
                                  {.x = -50.0f, .z = 50.0f}};
    lake.points = shore;
    lake.pointCount = 5;
    Add(world, &dry);
    Add(world, &lake);
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, -10.0, 0.0));
    assert_true(IsClippedAt(world, 10.0, 0.0)); // the notch
    assert_false(IsClippedAt(world, 10.0, 11.0));
    assert_true(IsClippedAt(world, 1e9, 1e9));
    assert_true(IsClippedAt(world, 9e11, 1e9)); // where cells do not fit 32 bits
    swDestroyWorld(world);
}

// The box that the test cuts, turned by all three angles, 1,000 km out.
static const swPos s_boxPlace = {1000000.25, 3.4, -2000000.5};
static const swAngles s_boxTurn = {0.7f, 0.3f, -0.2f};

// Into the box's axes in double: yaw, then pitch, then roll.
static double BoxDistance(double x, double y, double z)
{
    double dx = x - s_boxPlace.x, dy = y - s_boxPlace.y, dz = z - s_boxPlace.z;
    double c = cos((double)s_boxTurn.yaw), s = sin((double)s_boxTurn.yaw);
    double x1 = c * dx + s * dz, z1 = c * dz - s * dx;
    c = cos((double)s_boxTurn.pitch);
    s = sin((double)s_boxTurn.pitch);
    double x2 = c * x1 + s * dy, y2 = c * dy - s * x1;
    c = cos((double)s_boxTurn.roll);
    s = sin((double)s_boxTurn.roll);
    double y3 = c * y2 + s * z1, z3 = c * z1 - s * y2;
    return (double)swBoxDistance((float)x2, (float)y3, (float)z3, 20.0f, 1.0f, 10.0f, 0.5f);
}

static void ATurnedBoxFarOutIsCutWhereTheWaterIsInIt(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(true);
    swInputDef box = MakeClip(SW_SHAPE_BOX, 1.0f, 0);
    box.position = s_boxPlace;
    box.rotation = s_boxTurn;
    box.size = (swVec3){40.0f, 2.0f, 20.0f};
    box.rounding = 0.5f;
    Add(world, &box);
    swWorld_Step(world, 1.0);
    static swPosXZ points[POINTS];
    static float heights[POINTS];
    static bool isClipped[POINTS];
    ScatterPoints(points, POINTS, s_boxPlace.x, s_boxPlace.z, 50.0);
    const swQueryDef query = swDefaultQueryDef();
    const swSurfaceSamples samples = {.height = heights, .isClipped = isClipped};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINTS, points, &samples, NULL);
    int inside = 0, near = 0, below = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        double distance = BoxDistance(points[i].x, (double)heights[i], points[i].z);
        inside += distance < 0.0 ? 1 : 0;
        near += fabs(distance) < 0.002 ? 1 : 0; // the search's tolerance, and the heights' floats
        below += distance > 0.0 && BoxDistance(points[i].x, 3.4, points[i].z) < 0.0 ? 1 : 0;
        assert_true(fabs(distance) < 0.002 || isClipped[i] == (distance < 0.0));
    }
    printf("box: %d of %d points are in it, %d at its edge, %d only of still water\n", inside, POINTS, near, below);
    assert_true(inside > POINTS / 20 && inside < POINTS / 2 && near < POINTS / 100 && below > 10);

    // Particles that rest there are asked where they are.
    static swVec3 moved[POINTS];
    const swSurfaceSamples particles = {.height = heights, .displacement = moved, .isClipped = isClipped};
    swMoment_QueryParticles(swWorld_GetMoment(world), &query, POINTS, points, &particles, NULL, NULL);
    for (int i = 0; i < POINTS; ++i)
    {
        double distance =
            BoxDistance(points[i].x + (double)moved[i].x, (double)heights[i], points[i].z + (double)moved[i].z);
        assert_true(fabs(distance) < 0.002 || isClipped[i] == (distance < 0.0));
    }
    swDestroyWorld(world);
}

static void EachSolidIsCutAtItsWaterline(void** state)
{
    (void)state;
    const struct
    {
        swInputShape shape;
        float atX, atZ; // half width of the hole where still water is 1 m above the middle
    } solids[] = {{SW_SHAPE_BOX, 10.0f, 3.0f},
                  {SW_SHAPE_ELLIPSOID, 8.6602540f, 2.5980762f},
                  {SW_SHAPE_CYLINDER, 10.0f, 3.0f},
                  {SW_SHAPE_CAPSULE, 10.0f, 10.0f}};
    for (int i = 0; i < 4; ++i)
    {
        swWorld* world = MakeWorld(false);
        swInputDef def = MakeClip(solids[i].shape, 1.0f, 0);
        def.size = (swVec3){20.0f, solids[i].shape == SW_SHAPE_CAPSULE ? 24.0f : 4.0f, 6.0f};
        def.position.y = 2.0;
        Add(world, &def);
        swWorld_Step(world, 0.0);
        assert_true(IsClippedAt(world, (double)solids[i].atX - 0.01, 0.0));
        assert_false(IsClippedAt(world, (double)solids[i].atX + 0.01, 0.0));
        assert_true(IsClippedAt(world, 0.0, (double)solids[i].atZ - 0.01));
        assert_false(IsClippedAt(world, 0.0, (double)solids[i].atZ + 0.01));
        swDestroyWorld(world);
    }
}

static swHull* MakeDock(void)
{
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);
    swHullDef def = MakeHullDef(&mesh, "dock");
    swHost host = MakeHost();
    swHull* hull = NULL;
    assert_int_equal(swCreateHull(&host, &def, &hull), SW_SUCCESS);
    return hull;
}

static void OverlappingConcaveHullsAreOneHole(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swHull* hull = MakeDock();
    swInputDef dock = MakeClip(SW_SHAPE_HULL, 1.0f, 0), other = dock;
    dock.hull = other.hull = hull;
    other.position = (swPos){20.0, 0.0, 0.0};
    other.rotation.yaw = (float)SW_PI; // it opens to the west
    other.scale = (swVec3){0.5f, 2.0f, 1.0f};
    dock.name[0] = 'd';
    Add(world, &dock);
    Add(world, &other);
    swDestroyHull(hull); // inputs hold it
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, 0.0, 0.0));
    assert_true(IsClippedAt(world, -13.0, 0.0));
    assert_true(IsClippedAt(world, 0.0, 8.0));
    assert_true(IsClippedAt(world, 14.0, 8.0));  // both walls
    assert_true(IsClippedAt(world, 20.0, -8.0)); // the other's wall
    assert_true(IsClippedAt(world, 26.5, 0.0));  // and end: 5.5 to 7.5 m from its middle
    assert_false(IsClippedAt(world, 27.7, 0.0));
    assert_false(IsClippedAt(world, 20.0, 0.0)); // its basin
    swDestroyWorld(world);
}

static void ARasterCutsWhereItsValuesAreAboveAHalf(void** state)
{
    (void)state;
    float values[9 * 9];
    for (int i = 0; i < 81; ++i)
    {
        values[i] = (float)(i % 9) / 8.0f; // from west to east
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = 9;
    def.x = def.z = -40.0;
    def.spacingX = def.spacingZ = 10.0;
    def.values = values;
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    swWorld* world = MakeWorld(false);
    swInputDef clip = MakeClip(SW_SHAPE_RASTER, 0.0f, 0);
    clip.raster = raster;
    swInputId id = Add(world, &clip);
    swDestroyRaster(raster);
    swWorld_Step(world, 0.0);
    assert_false(IsClippedAt(world, -0.1, 0.0));
    assert_true(IsClippedAt(world, 0.1, 0.0));
    assert_true(IsClippedAt(world, 39.9, 0.0));
    assert_false(IsClippedAt(world, 40.1, 0.0)); // beyond its rim
    assert_float_equal(ClipFieldAt(world, 0.2, 0.0), 0.7f, 1e-3f);

    // Turned round it leaves water in a dry sea.
    swInputDef dry = MakeClip(SW_SHAPE_EVERYWHERE, 1.0f, -1);
    Add(world, &dry);
    clip = swInput_Get(world, id);
    clip.gain = -1.0f;
    assert_int_equal(swInput_Set(world, id, &clip), SW_SUCCESS);
    swWorld_Step(world, 0.1);
    assert_true(IsClippedAt(world, -0.1, 0.0));
    assert_false(IsClippedAt(world, 0.1, 0.0));
    assert_true(IsClippedAt(world, 40.1, 0.0));
    swDestroyWorld(world);
}

static swRayHit Cast(const swWorld* world, swPos origin, swVec3 direction, float radius)
{
    const swQueryDef query = swDefaultQueryDef();
    swRay ray = swDefaultRay(origin, direction);
    ray.radius = radius;
    ray.maxDistance = 200.0f;
    swRayHit hit;
    swMoment_CastRays(swWorld_GetMoment(world), &query, 1, &ray, &hit, NULL);
    return hit;
}

static void RaysPassThroughHoles(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swInputDef clip = MakeClip(SW_SHAPE_CYLINDER, 1.0f, 0);
    clip.size = (swVec3){20.0f, 100.0f, 20.0f};
    swInputId id = Add(world, &clip);
    swWorld_Step(world, 0.0);
    const swVec3 down = {0.0f, -1.0f, 0.0f}, up = {0.0f, 1.0f, 0.0f}, slant = {1.0f, -1.0f, 0.0f};
    assert_false(Cast(world, (swPos){0.0, 20.0, 0.0}, down, 0.0f).isHit);
    assert_float_equal(Cast(world, (swPos){0.0, 20.0, 0.0}, down, 0.0f).distance, 200.0f, 0.0f);
    assert_false(Cast(world, (swPos){5.0, 20.0, 5.0}, down, 0.5f).isHit);
    assert_true(Cast(world, (swPos){10.5, 20.0, 0.0}, down, 0.0f).isHit);
    assert_false(Cast(world, (swPos){0.0, -20.0, 0.0}, up, 0.0f).isHit);
    assert_true(Cast(world, (swPos){11.0, -20.0, 0.0}, up, 0.0f).fromBelow);
    // One that goes in beside the hole meets the water, one that begins in it and leaves by it does not.
    assert_true(Cast(world, (swPos){0.0, 20.0, 0.0}, slant, 0.0f).isHit);
    assert_false(Cast(world, (swPos){-10.0, 20.0, 0.0}, slant, 0.0f).isHit);
    swInput_Enable(world, id, false);
    swWorld_Step(world, 0.1);
    assert_true(Cast(world, (swPos){0.0, 20.0, 0.0}, down, 0.0f).isHit);
    swDestroyWorld(world);
}

static void InWavesRaysMeetTheWaterBesideAHoleOnly(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(true);
    swInputDef clip = MakeClip(SW_SHAPE_CYLINDER, 1.0f, 0);
    clip.size = (swVec3){30.0f, 100.0f, 30.0f};
    Add(world, &clip);
    swWorld_Step(world, 1.0);
    int before = 0, behind = 0, through = 0;
    uint32_t seed = 9;
    for (int i = 0; i < 300; ++i)
    {
        const swPos origin = {80.0 * NextPart(&seed) - 70.0, 6.0, 20.0 * NextPart(&seed) - 10.0};
        swRayHit hit = Cast(world, origin, (swVec3){1.0f, -0.12f, 0.0f}, 0.0f);
        double fromMiddle = sqrt(hit.point.x * hit.point.x + hit.point.z * hit.point.z);
        before += hit.isHit && hit.point.x < 0.0 ? 1 : 0;
        behind += hit.isHit && hit.point.x > 0.0 ? 1 : 0;
        through += hit.isHit ? 0 : 1;
        assert_true(!hit.isHit || fromMiddle > 14.999);
    }
    printf("rays: %d of 300 met the water before the hole, %d behind it, %d went through\n", before, behind, through);
    assert_true(before > 30 && behind > 10 && through > 50);
    swDestroyWorld(world);
}

static void Refuses(const swInputDef* def, const char* sentence)
{
    swWorld* world = MakeWorld(false);
    s_messages[0] = '\0';
    swInputId id;
    assert_int_not_equal(swCreateInput(world, def, &id), SW_SUCCESS);
    assert_true(SW_IS_NULL(id));
    assert_int_equal(swWorld_GetInputCount(world), 0);
    printf("%s", s_messages);
    assert_non_null(strstr(s_messages, sentence));
    swDestroyWorld(world);
}

static void WhatCanCutNothingIsRefusedInASentence(void** state)
{
    (void)state;
    swInputDef def = MakeClip(SW_SHAPE_ELLIPSOID, 1.0f, 0);
    def.size.z = 0.0f;
    Refuses(&def, "has no extent");
    def = MakeClip(SW_SHAPE_HULL, 1.0f, 0);
    Refuses(&def, "has no hull");
    def = MakeClip(SW_SHAPE_BOX, 1.0f, 0);
    def.field = SW_INPUT_LEVEL;
    Refuses(&def, "has a height, which only clip looks at");
    const swInputPoint bow[] = {
        {.x = 0.0f, .z = 0.0f}, {.x = 10.0f, .z = 10.0f}, {.x = 10.0f, .z = 0.0f}, {.x = 0.0f, .z = 10.0f}};
    def = MakeClip(SW_SHAPE_POLYGON, 1.0f, 0);
    Refuses(&def, "has no points");
    def.points = bow;
    def.pointCount = 4;
    snprintf(def.name, sizeof def.name, "bow");
    Refuses(&def, "the input 'bow' crosses itself");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WithoutInputsNothingIsClipped),
        cmocka_unit_test(AnAreaIsCutAndAnotherWithinIsLeft),
        cmocka_unit_test(ASeaThatIsDryHasWaterWhereItIsLeft),
        cmocka_unit_test(ATurnedBoxFarOutIsCutWhereTheWaterIsInIt),
        cmocka_unit_test(EachSolidIsCutAtItsWaterline),
        cmocka_unit_test(OverlappingConcaveHullsAreOneHole),
        cmocka_unit_test(ARasterCutsWhereItsValuesAreAboveAHalf),
        cmocka_unit_test(RaysPassThroughHoles),
        cmocka_unit_test(InWavesRaysMeetTheWaterBesideAHoleOnly),
        cmocka_unit_test(WhatCanCutNothingIsRefusedInASentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
