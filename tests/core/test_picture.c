// SPDX-License-Identifier: MIT
// The picture's numbers, worked out without a device: a host that moves its coordinates sees the same picture.

#include "gpu/draw/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/frame/frame.h"
#include "seaway/seaway.h"
#include "support/cmocka_setup.h"

static swWorld* MakeSea(swView** view)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    def.method = SW_WAVES_GERSTNER;
    def.componentsPerOctave = 2;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    assert_int_equal(swCreateView(world, &viewDef, view), SW_SUCCESS);
    return world;
}

// The picture from a place of the sea, in coordinates that begin at `origin`.
static void Build(swWorld* world, swView* view, swPosXZ origin, swPos place, double time, swPictureFrame* built)
{
    swWorld_SetOrigin(world, origin);
    swPos inHost = {place.x - origin.x, place.y, place.z - origin.z};
    swShot shot = {
        .view = view,
        .camera = swMakeCamera(inHost, 0.7f, -0.1f, 0.0f, 1.0f, 64, 64),
        .sky = swDefaultSkyDef(),
        .water = swDefaultWaterDef(),
        .time = time,
    };
    swView_SetViewpoint(view, shot.camera.position);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    const swFrame* frame = swGetWorldFrame(world);
    memset(built, 0, sizeof(*built));
    swBuildPicture(&shot, swGetWorldOrigin(world), frame, &frame->views[0], 1024, built);
}

static void AShiftOfTheOriginChangesNoNumber(void** state)
{
    (void)state;
    swView* view = NULL;
    swWorld* world = MakeSea(&view);
    static swPictureFrame wanted, got;
    const swPos place = {12345.5, 6.0, -777.25}; // sums with the origins below are exact
    Build(world, view, (swPosXZ){0.0, 0.0}, place, 100.0, &wanted);
    static const swPosXZ origins[4] = {{1e6, 0.0}, {-3e5, 8e5}, {1e9, -1e9}, {12288.0, -512.0}};
    for (int i = 0; i < 4; ++i)
    {
        Build(world, view, origins[i], place, 100.0, &got);
        assert_memory_equal(&got.params, &wanted.params, sizeof(got.params));
        assert_memory_equal(&got.rings, &wanted.rings, sizeof(got.rings));
        assert_memory_equal(got.bands, wanted.bands, sizeof(got.bands));
        assert_memory_equal(got.waves, wanted.waves, sizeof(got.waves));
    }
    swDestroyWorld(world);
}

// However far out and late, a camera that moves by a metre moves the clouds by a metre.
static void CloudsDoNotJumpFarAway(void** state)
{
    (void)state;
    swView* view = NULL;
    swWorld* world = MakeSea(&view);
    static swPictureFrame before, after;
    static const double distances[3] = {0.0, 1e6, 1e9};
    for (int i = 0; i < 3; ++i)
    {
        swPos place = {distances[i] + 64.0, 6.0, -distances[i] + 64.0};
        Build(world, view, (swPosXZ){0.0, 0.0}, place, 3e7, &before);
        place.x += 16.0;
        place.z -= 16.0;
        Build(world, view, (swPosXZ){0.0, 0.0}, place, 3e7, &after);
        double x = (double)after.params.cloudX - (double)before.params.cloudX;
        double z = (double)after.params.cloudZ - (double)before.params.cloudZ;
        assert_true(fabs(x * (double)after.params.cloudWayX - 0.016) < 1.1e-3);
        assert_true(fabs(z * (double)after.params.cloudWayZ + 0.016) < 1.1e-3);
    }
    swDestroyWorld(world);
}

// The place of the clouds' noise that is seen `distance` km east of the camera.
static double SeenPlace(const swPictureParams* params, float distance)
{
    return (double)swMirrorClouds(params->cloudX + params->cloudWayX * distance);
}

// Every 8,192 km their noise begins to run the other way; nobody who flies across sees it jump.
static void CloudsDoNotJumpAtTheEdgesOfTheirNoise(void** state)
{
    (void)state;
    swView* view = NULL;
    swWorld* world = MakeSea(&view);
    static swPictureFrame before, after;
    static const double edges[6] = {8192e3, -8192e3, 16384e3, 24576e3, -24576e3, 32768e3};
    static const float distances[5] = {0.0f, -300.0f, 300.0f, -3.0f, 40.0f};
    for (int i = 0; i < 6; ++i)
    {
        Build(world, view, (swPosXZ){0.0, 0.0}, (swPos){edges[i] - 4.0, 6.0, 0.0}, 0.0, &before);
        Build(world, view, (swPosXZ){0.0, 0.0}, (swPos){edges[i] + 4.0, 6.0, 0.0}, 0.0, &after);
        for (int k = 0; k < 5; ++k)
        {
            double moved = SeenPlace(&after.params, distances[k]) - SeenPlace(&before.params, distances[k]);
            assert_true(fabs(moved) < 0.011); // 8 m, and what floats round
        }
    }
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AShiftOfTheOriginChangesNoNumber),
        cmocka_unit_test(CloudsDoNotJumpFarAway),
        cmocka_unit_test(CloudsDoNotJumpAtTheEdgesOfTheirNoise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
