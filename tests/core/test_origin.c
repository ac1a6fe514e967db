// SPDX-License-Identifier: MIT

// The host's coordinates move, the sea does not.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include <seaway/seaway.h>

enum
{
    POINTS = 64,
    SIDE = 64,
    SLICES = 3
};

typedef struct Answers
{
    float heights[POINTS];
    swVec3 normals[POINTS];
    swVec3 below[POINTS];
    float displacement[SLICES][SIDE * SIDE * 4];
    float foam[SLICES][SIDE * SIDE];
    swSliceInfo slices[SLICES];
} Answers;

// The same places of the sea, whatever the origin.
static void Ask(swWorld* world, swView* view, swPosXZ origin, swPosXZ centre, Answers* answers)
{
    swWorld_SetOrigin(world, origin);
    swPosXZ points[POINTS];
    swPos places[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = (swPosXZ){centre.x + 7.25 * i - origin.x, centre.z + 0.5 * i * i - origin.z};
        places[i] = (swPos){points[i].x, -5.0, points[i].z};
    }
    swView_SetViewpoint(view, (swPos){centre.x - origin.x, 12.0, centre.z - origin.z});
    swWorld_Step(world, 0.0);
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples surface = {.height = answers->heights, .normal = answers->normals};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, POINTS, points, &surface, NULL);
    swVolumeSamples volume = {.velocity = answers->below};
    swMoment_QueryVolume(swWorld_GetMoment(world), &def, POINTS, places, &volume, NULL);
    for (int s = 0; s < SLICES; ++s)
    {
        memcpy(answers->displacement[s], swView_GetDisplacement(view, s), sizeof answers->displacement[s]);
        memcpy(answers->foam[s], swView_GetFoam(view, s), sizeof answers->foam[s]);
        answers->slices[s] = swView_GetSlice(view, s);
    }
}

static void AShiftOfTheOriginChangesNothing(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = 1.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    def.method = SW_WAVES_GERSTNER;
    def.spectrum.direction = 2.0f;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = SLICES;
    viewDef.resolution = SIDE;
    viewDef.enableCpuLayers = true;
    swView* view;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    static Answers wanted, got;
    const swPosXZ centre = {123.5, -77.25};
    swView_SetViewpoint(view, (swPos){centre.x, 12.0, centre.z});
    for (int i = 0; i < 20; ++i)
    {
        swWorld_Step(world, 0.1); // some foam
    }
    Ask(world, view, (swPosXZ){0.0, 0.0}, centre, &wanted);
    double worst = 0.0;
    for (int heading = 0; heading < 8; ++heading)
    {
        for (int far = 0; far < 2; ++far)
        {
            double distance = far ? 1e6 : 1234.567;
            swPosXZ origin = {distance * cos(0.3 + heading * 0.785), distance * sin(0.3 + heading * 0.785)};
            Ask(world, view, origin, centre, &got);
            for (int s = 0; s < SLICES; ++s)
            {
                assert_true(got.slices[s].firstX == wanted.slices[s].firstX);
                assert_true(got.slices[s].firstZ == wanted.slices[s].firstZ);
                assert_true(got.slices[s].texel == wanted.slices[s].texel);
            }
            assert_memory_equal(got.displacement, wanted.displacement, sizeof got.displacement);
            assert_memory_equal(got.foam, wanted.foam, sizeof got.foam);
            swPos viewpoint = swView_GetViewpoint(view);
            assert_true(fabs(viewpoint.x + origin.x - centre.x) < 1e-9);
            for (int i = 0; i < POINTS; ++i)
            {
                worst = fmax(worst, fabs((double)got.heights[i] - (double)wanted.heights[i]));
                worst = fmax(worst, fabs((double)got.normals[i].x - (double)wanted.normals[i].x));
                worst = fmax(worst, fabs((double)got.below[i].z - (double)wanted.below[i].z));
            }
        }
    }
    print_message("worst change by shifts of up to 1,000 km: %.2g m\n", worst);
    assert_true(worst <= 1e-4);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AShiftOfTheOriginChangesNothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
