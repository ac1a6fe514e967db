// SPDX-License-Identifier: MIT
// Inputs that displace the water: particles, textures, pushes, set heights, scaled waves, and what slices have of them.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "seaway/seaway.h"

static swWorld* MakeWorld(bool withWaves)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    def.seaLevel = 3.0;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    if (withWaves)
    {
        swWaveSystemDef waves = swDefaultWaveSystemDef();
        waves.resolution = 64;
        waves.tileWaves = 16;
        waves.minWavelength = 2.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(world, &waves, &id), SW_SUCCESS);
    }
    return world;
}

static swInputDef MakeDisplacement(swInputBlend blend, float diameter, float y)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_DISPLACEMENT;
    def.shape = SW_SHAPE_CIRCLE;
    def.blend = blend;
    def.size.x = diameter;
    def.value[1] = y;
    return def;
}

static swInputId AddInput(swWorld* world, const swInputDef* def)
{
    swInputId id;
    assert_int_equal(swCreateInput(world, def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    return id;
}

static swVec3 Rest(const swWorld* world, double x, double z, swVec2* slope)
{
    swVec3 displacement;
    swVec2 slopes;
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.displacement = &displacement};
    swMoment_QueryParticles(swWorld_GetMoment(world), &def, 1, &(swPosXZ){x, z}, &samples, &slopes, NULL);
    if (slope != NULL)
    {
        *slope = slopes;
    }
    return displacement;
}

static double Height(const swWorld* world, double x, double z)
{
    return swMoment_GetHeight(swWorld_GetMoment(world), x, z);
}

// Gradients of height and sideways displacement by rest place against differences. Returns the worst.
static double CheckSlopes(const swWorld* world, double from, double step, int count)
{
    const double d = 0.01;
    double worst = 0.0;
    for (int i = 0; i < count; i++)
    {
        double x = from + step * i, z = 0.3 * from + 0.7 * step * i;
        swVec2 slope;
        Rest(world, x, z, &slope);
        double alongX = (double)(Rest(world, x + d, z, NULL).y - Rest(world, x - d, z, NULL).y) / (2.0 * d);
        double alongZ = (double)(Rest(world, x, z + d, NULL).y - Rest(world, x, z - d, NULL).y) / (2.0 * d);
        worst = fmax(worst, fmax(fabs(alongX - (double)slope.x), fabs(alongZ - (double)slope.y)));
    }
    return worst;
}

static void AWaveParticleIsABump(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swInputDef def = MakeDisplacement(SW_BLEND_ADD, 6.0f, 1.5f);
    def.isBump = true;
    AddInput(world, &def);
    double worst = 0.0;
    for (int i = 0; i < 40; i++)
    {
        double r = 0.1 * i, square = fmin(r * r / 9.0, 1.0);
        worst = fmax(worst, fabs(Height(world, r, 0.0) - 3.0 - 1.5 * (1.0 - square) * (1.0 - square)));
    }
    double slopes = CheckSlopes(world, -2.5, 0.11, 40);
    print_message("a particle is off by %.1e m, its slopes by %.1e\n", worst, slopes);
    assert_true(worst < 1e-5 && slopes < 2e-4);
    swDestroyWorld(world);
}

static void WhatFollowsTheWavesJoinsTheirDisplacement(void** state)
{
    (void)state;
    swWorld* plain = MakeWorld(true);
    swWorld* world = MakeWorld(true);
    swInputDef def = MakeDisplacement(SW_BLEND_ADD, 60.0f, 0.8f);
    def.value[0] = 1.0f;
    def.value[2] = -0.5f;
    def.isBump = true;
    def.followsWaves = true;
    swInputId id = AddInput(world, &def);
    assert_int_equal(swWorld_StepTo(world, 20.0), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(plain, 20.0), SW_SUCCESS);
    swVec3 a = Rest(plain, 0.0, 0.0, NULL), b = Rest(world, 0.0, 0.0, NULL);
    assert_float_equal(b.x, a.x + 1.0f, 1e-6f);
    assert_float_equal(b.y, a.y + 0.8f, 1e-6f);
    assert_float_equal(b.z, a.z - 0.5f, 1e-6f);
    // The water above a point belongs to the particle that has come there.
    double worst = 0.0;
    for (int i = 0; i < 100; i++)
    {
        double x = -30.0 + 0.6 * i, z = 5.0;
        swVec3 there = Rest(world, x, z, NULL);
        worst = fmax(worst, fabs(Height(world, x + (double)there.x, z + (double)there.z) - 3.0 - (double)there.y));
    }
    double slopes = CheckSlopes(world, -25.0, 0.7, 60);
    print_message("searches are off by %.1e m, slopes by %.1e\n", worst, slopes);
    assert_true(worst < 5e-3 && slopes < 3e-3);
    assert_true(Height(world, 500.0, 500.0) == Height(plain, 500.0, 500.0));

    def.blend = SW_BLEND_MULTIPLY;
    def.isBump = false;
    def.value[0] = def.value[1] = def.value[2] = 0.35f;
    assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    b = Rest(world, 0.0, 0.0, NULL);
    assert_float_equal(b.x, 0.35f * a.x, 1e-6f);
    assert_float_equal(b.y, 0.35f * a.y, 1e-6f);
    swDestroyWorld(world);
    swDestroyWorld(plain);
}

// Spec N11: wherever waves have brought it from, no water stands above a hull's underside.
static void NoWaterStandsAboveWhatPressesItDown(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(true);
    swInputDef def = MakeDisplacement(SW_BLEND_MIN, 20.0f, 0.0f);
    def.position = (swPos){4.0, 2.5, -3.0}; // half a metre below the sea level
    AddInput(world, &def);
    double highest = -1e9, around = -1e9;
    for (int time = 0; time < 5; time++)
    {
        assert_int_equal(swWorld_Step(world, 1.3), SW_SUCCESS);
        for (int i = 0; i < 400; i++)
        {
            double x = 9.9 * sqrt(i / 400.0) * cos(2.4 * i), z = 9.9 * sqrt(i / 400.0) * sin(2.4 * i);
            highest = fmax(highest, Height(world, 4.0 + x, -3.0 + z));
            around = fmax(around, Height(world, 60.0 + x, -3.0 + z));
        }
    }
    print_message("water under the hull stands at %.4f m at most (2.5 allowed), beside it at %.2f m\n", highest,
                  around);
    assert_true(highest <= 2.5 + 1e-5 && around > 3.0);
    swDestroyWorld(world);
}

static void AHeightCanBeSetAndMixed(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(true);
    swInputDef level = swDefaultInputDef();
    level.field = SW_INPUT_LEVEL;
    level.value[0] = 1.0f;
    AddInput(world, &level);
    swInputDef def = MakeDisplacement(SW_BLEND_ALPHA, 60.0f, 0.25f);
    def.feather = 10.0f;
    def.position.y = 5.0;
    AddInput(world, &def);
    assert_int_equal(swWorld_Step(world, 2.0), SW_SUCCESS);
    assert_true(fabs(Height(world, 3.0, 4.0) - 5.25) < 1e-5);
    assert_true(fabs(Height(world, -8.0, 9.0) - 5.25) < 1e-5);
    double slopes = CheckSlopes(world, -28.0, 0.13, 60);
    print_message("slopes within the feather are off by %.1e\n", slopes);
    assert_true(slopes < 3e-3);
    swDestroyWorld(world);
}

// A raster of heights that plays.
static void ATextureDisplacesAndPlays(void** state)
{
    (void)state;
    float values[2][4][4];
    for (int i = 0; i < 32; i++)
    {
        (&values[0][0][0])[i] = i < 16 ? 0.5f : 1.5f;
    }
    swHost host = swDefaultHost();
    swRasterDef raster = swDefaultRasterDef();
    raster.width = raster.height = 4;
    raster.frames = 2;
    raster.spacingX = raster.spacingZ = 10.0;
    raster.values = &values[0][0][0];
    swRaster* made = NULL;
    assert_int_equal(swCreateRaster(&host, &raster, &made), SW_SUCCESS);
    swWorld* world = MakeWorld(false);
    swInputDef def = MakeDisplacement(SW_BLEND_ADD, 0.0f, 0.0f);
    def.shape = SW_SHAPE_RASTER;
    def.raster = made;
    def.framesPerSecond = 1.0f;
    AddInput(world, &def);
    swDestroyRaster(made);
    const double expected[] = {0.5, 1.0, 1.5, 1.0, 0.5};
    for (int i = 0; i < 5; i++)
    {
        assert_int_equal(swWorld_StepTo(world, 0.5 * i), SW_SUCCESS);
        assert_true(fabs(Height(world, 11.0, 12.0) - 3.0 - expected[i]) < 1e-6);
    }
    swDestroyWorld(world);
}

// Each slice has what a query of its shortest wave has: an input once, or not at all.
static void ASliceHasWhatItsWavesAreLongEnoughFor(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(true);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.resolution = 64;
    viewDef.sliceCount = 4;
    viewDef.finestTexel = 0.25f;
    viewDef.enableCpuLayers = true;
    swView* view = NULL;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    swInputDef def = MakeDisplacement(SW_BLEND_ADD, 8.0f, 1.0f);
    def.isBump = true;
    def.followsWaves = true;
    def.wavelength = 4.0f;
    AddInput(world, &def);
    def.followsWaves = false;
    def.position.x = 3.0;
    AddInput(world, &def);
    int with = 0, without = 0;
    double worst = 0.0;
    for (int slice = 0; slice < 4; slice++)
    {
        swSliceInfo info = swView_GetSlice(view, slice);
        const float* texels = swView_GetDisplacement(view, slice);
        assert_non_null(texels);
        swQueryDef query = swDefaultQueryDef();
        query.minWavelength = info.minWavelength;
        for (int i = 0; i < 64 * 64; i += 7)
        {
            swPosXZ at = {(double)(info.firstX + i % 64) * info.texel, (double)(info.firstZ + i / 64) * info.texel};
            swVec3 d;
            swSurfaceSamples samples = {.displacement = &d};
            swMoment_QueryParticles(swWorld_GetMoment(world), &query, 1, &at, &samples, NULL, NULL);
            worst = fmax(worst, fabs((double)(d.y - texels[4 * i + 1])));
        }
        with += info.minWavelength <= 4.0f;
        without += info.minWavelength > 4.0f;
    }
    print_message("%d slices have the inputs, %d have not; texels and queries differ by %.1e m\n", with, without,
                  worst);
    assert_true(with > 0 && without > 0 && worst < 1e-5);
    swDestroyWorld(world);
}

static void WhatDisplacesNothingIsRefused(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(false);
    swInputId id;
    swInputDef def = MakeDisplacement(SW_BLEND_ADD, 8.0f, 1.0f);
    def.value[0] = 1.0f; // sideways, and stays put
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_UNSUPPORTED);
    def = MakeDisplacement(SW_BLEND_ADD, 8.0f, 1.0f);
    def.shape = SW_SHAPE_RECTANGLE;
    def.isBump = true;
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_UNSUPPORTED);
    def = MakeDisplacement(SW_BLEND_ADD, 8.0f, 1.0f);
    def.field = SW_INPUT_LEVEL;
    def.wavelength = 3.0f;
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_UNSUPPORTED);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWaveParticleIsABump),
        cmocka_unit_test(WhatFollowsTheWavesJoinsTheirDisplacement),
        cmocka_unit_test(NoWaterStandsAboveWhatPressesItDown),
        cmocka_unit_test(AHeightCanBeSetAndMixed),
        cmocka_unit_test(ATextureDisplacesAndPlays),
        cmocka_unit_test(ASliceHasWhatItsWavesAreLongEnoughFor),
        cmocka_unit_test(WhatDisplacesNothingIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
