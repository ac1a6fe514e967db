// SPDX-License-Identifier: MIT
// Islands out of a seed.
#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>

#include "seaway/island.h"

static swRaster* Make(const swIslandDef* def)
{
    swHost host = MakeHost();
    swRaster* raster = NULL;
    if (swCreateIsland(&host, def, &raster) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return raster;
}

static swIslandDef Small(uint32_t seed)
{
    swIslandDef def = swDefaultIslandDef();
    def.seed = seed;
    def.cells = 257;
    return def;
}

// The hash is that of every machine and compiler.
static void ASeedIsAnIsland(void** state)
{
    (void)state;
    swIslandDef def = Small(1);
    swRaster *one = Make(&def), *same = Make(&def);
    def.seed = 2;
    swRaster* other = Make(&def);
    assert_true(swRaster_GetInfo(one).hash == swRaster_GetInfo(same).hash);
    assert_true(swRaster_GetInfo(one).hash != swRaster_GetInfo(other).hash);
    print_message("hash of seed 1: %016llx\n", (unsigned long long)swRaster_GetInfo(one).hash);
    assert_true(swRaster_GetInfo(one).hash == 0xa4ca62b635a965e3u);
    swDestroyRaster(one);
    swDestroyRaster(same);
    swDestroyRaster(other);
}

// One piece of land in the middle, deep water at the rim, and heights as asked.
static void AnIslandIsLandInDeepWater(void** state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 12; ++seed)
    {
        swIslandDef def = Small(seed);
        swRaster* raster = Make(&def);
        swRasterInfo info = swRaster_GetInfo(raster);
        const float* heights = swRaster_GetValues(raster);
        int land = 0, rimLand = 0, beach = 0;
        for (int i = 0; i < info.width * info.height; ++i)
        {
            bool isRim = i % info.width == 0 || i < info.width;
            land += heights[i] > 0.0f ? 1 : 0;
            rimLand += isRim && heights[i] > -75.0f ? 1 : 0;
            beach += heights[i] > -10.0f && heights[i] <= 0.0f ? 1 : 0;
        }
        double area = land * info.spacingX * info.spacingZ, circle = SW_PI * 1e6;
        assert_true(area > 0.4 * circle && area < 1.8 * circle);
        assert_true(rimLand == 0 && beach > 300);
        assert_true(info.most > 120.0f && info.most < 500.0f && info.least < -140.0f && info.least > -260.0f);
        swDestroyRaster(raster);
    }
}

// Nowhere a cliff by noise: from cell to cell, 23 m apart, a slope of 3.2 at most.
static void AnIslandHasNoSteps(void** state)
{
    (void)state;
    swIslandDef def = Small(5);
    swRaster* raster = Make(&def);
    swRasterInfo info = swRaster_GetInfo(raster);
    const float* heights = swRaster_GetValues(raster);
    float steepest = 0.0f;
    for (int i = 0; i + 1 < info.width * info.height; ++i)
    {
        bool isEnd = i % info.width == info.width - 1;
        steepest = isEnd ? steepest : fmaxf(steepest, fabsf(heights[i + 1] - heights[i]));
    }
    print_message("steepest %.2f\n", (double)steepest / info.spacingX);
    assert_true((double)steepest < 3.2 * info.spacingX);
    swDestroyRaster(raster);
}

static void ASmoothIslandIsACone(void** state)
{
    (void)state;
    swIslandDef def = Small(1);
    def.ruggedness = 0.0f;
    def.x = 1e6;
    swRaster* raster = Make(&def);
    float coast[2];
    swRaster_Sample(raster, 2, (const swPosXZ[]){{1e6 + 2000.0, 0.0}, {1e6, 0.0}}, coast);
    assert_true(coast[0] < 0.0f && coast[1] > 50.0f);
    swDestroyRaster(raster);
}

static void IslandsOutOfRangeAreRefused(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swRaster* raster = NULL;
    swIslandDef def = swDefaultIslandDef();
    def.radius = 1.0f;
    assert_int_equal(swCreateIsland(&host, &def, &raster), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "radius"));
    def = swDefaultIslandDef();
    def.cells = 10000;
    assert_int_equal(swCreateIsland(&host, &def, &raster), SW_ERROR_INVALID);
    assert_null(raster);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ASeedIsAnIsland),
        cmocka_unit_test(AnIslandIsLandInDeepWater),
        cmocka_unit_test(AnIslandHasNoSteps),
        cmocka_unit_test(ASmoothIslandIsACone),
        cmocka_unit_test(IslandsOutOfRangeAreRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
