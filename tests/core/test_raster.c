// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>

#include <seaway/raster.h>

static swRasterDef MakeDef(int width, int height, const float* values)
{
    swRasterDef def = swDefaultRasterDef();
    def.name = "a.asc";
    def.width = width;
    def.height = height;
    def.x = -30.0;
    def.z = 7.5;
    def.spacingX = 10.0;
    def.spacingZ = 2.5;
    def.values = values;
    return def;
}

static swRaster* Create(const swRasterDef* def)
{
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, def, &raster), SW_SUCCESS);
    return raster;
}

static float SampleAt(const swRaster* raster, double x, double z)
{
    float value = 0.0f;
    swRaster_Sample(raster, 1, &(swPosXZ){x, z}, &value);
    return value;
}

static void MiddlesOfCellsHaveTheirValuesToTheBit(void** state)
{
    (void)state;
    float values[7 * 5];
    uint32_t seed = 3;
    for (int i = 0; i < 35; ++i)
    {
        values[i] = (float)(-4000.0 + 5000.0 * NextPart(&seed));
    }
    swRasterDef def = MakeDef(7, 5, values);
    swRaster* raster = Create(&def);
    for (int i = 0; i < 35; ++i)
    {
        float value = SampleAt(raster, -30.0 + 10.0 * (i % 7), 7.5 + 2.5 * (i / 7));
        assert_memory_equal(&value, &values[i], sizeof(value));
    }
    assert_memory_equal(swRaster_GetValues(raster), values, sizeof(values));
    swDestroyRaster(raster);
}

static void BetweenMiddlesItIsBilinear(void** state)
{
    (void)state;
    const float values[4] = {0.0f, 10.0f, 100.0f, 210.0f};
    swRasterDef def = MakeDef(2, 2, values);
    swRaster* raster = Create(&def);
    assert_float_equal(SampleAt(raster, -25.0, 7.5), 5.0f, 1e-6f);
    assert_float_equal(SampleAt(raster, -30.0, 8.125), 25.0f, 1e-5f);
    // 0.25 east, 0.5 south: (0.75 * 0 + 0.25 * 10 + 0.75 * 100 + 0.25 * 210) / 2
    assert_float_equal(SampleAt(raster, -27.5, 8.75), 65.0f, 1e-5f);
    swDestroyRaster(raster);
}

static void OutsideAndBesideUnknownCellsNothingIsKnown(void** state)
{
    (void)state;
    const float values[6] = {1.0f, 2.0f, 3.0f, 4.0f, NAN, 6.0f};
    swRasterDef def = MakeDef(3, 2, values);
    swRaster* raster = Create(&def);
    assert_true(isnan(SampleAt(raster, -30.001, 8.0)) && isnan(SampleAt(raster, -10.0 + 1e-6, 8.0)));
    assert_true(isnan(SampleAt(raster, -30.0, 7.499)) && isnan(SampleAt(raster, -30.0, 10.001)));
    assert_true(isnan(SampleAt(raster, (double)NAN, 8.0)) && isnan(SampleAt(raster, -30.0, (double)INFINITY)));
    assert_true(isnan(SampleAt(raster, -25.0, 8.0)) && isnan(SampleAt(raster, -20.0, 10.0)));
    // The unknown cell has no part in these.
    assert_float_equal(SampleAt(raster, -30.0, 8.75), 2.5f, 1e-6f);
    assert_float_equal(SampleAt(raster, -15.0, 7.5), 2.5f, 1e-6f);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.least == 1.0f && info.most == 6.0f);
    assert_int_equal(info.unknownCount, 1);
    assert_string_equal(info.name, "a.asc");
    swDestroyRaster(raster);
}

static void OneCellIsAPoint(void** state)
{
    (void)state;
    const float value = -3.0f;
    swRasterDef def = MakeDef(1, 1, &value);
    swRaster* raster = Create(&def);
    assert_true(SampleAt(raster, -30.0, 7.5) == -3.0f && isnan(SampleAt(raster, -29.999, 7.5)));
    swDestroyRaster(raster);
}

static void AnyChangeHasAnotherHash(void** state)
{
    (void)state;
    float values[4] = {0.0f, 1.0f, 2.0f, 3.0f};
    swRasterDef def = MakeDef(2, 2, values);
    swRaster* raster = Create(&def);
    uint64_t hash = swRaster_GetInfo(raster).hash;
    swDestroyRaster(raster);
    for (int change = 0; change < 6; ++change)
    {
        swRasterDef other = MakeDef(2, 2, values);
        values[2] = change == 0 ? 2.0000002f : change == 1 ? NAN : 2.0f;
        other.x += change == 2 ? 1e-9 : 0.0;
        other.spacingZ += change == 3 ? 1e-9 : 0.0;
        other.width = change == 4 ? 4 : 2;
        other.height = change == 4 ? 1 : 2;
        raster = Create(&other);
        assert_int_equal(swRaster_GetInfo(raster).hash == hash, change == 5);
        swDestroyRaster(raster);
    }
}

static void WhatCannotBeIsRefusedByName(void** state)
{
    (void)state;
    float values[4] = {0.0f, 1.0f, 2.0f, INFINITY};
    swHost host = MakeHost();
    swRaster* raster = NULL;
    const struct
    {
        int width, height;
        double x, spacingX;
        const char* words;
    } cases[] = {{0, 2, 0.0, 1.0, "swRasterDef::width is 0"},
                 {2, 0, 0.0, 1.0, "swRasterDef::height is 0"},
                 {SW_MAX_RASTER_SIDE + 1, 2, 0.0, 1.0, "swRasterDef::width is 16385"},
                 {-2, 2, 0.0, 1.0, "swRasterDef::width is -2"},
                 {2, 2, 0.0, 0.0, "swRasterDef::spacingX is 0"},
                 {2, 2, 0.0, (double)NAN, "its range is [0.001, 1"},
                 {2, 2, (double)NAN, 1.0, "swRasterDef::x is"},
                 {2, 2, 2e9, 1.0, "swRasterDef::x is"},
                 {2000, 2, 1e9, 1.0, "a.asc reaches to"},
                 {2, 2, 0.0, 1.0, "a.asc has inf in column 1, row 1"}};
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swRasterDef def = MakeDef(cases[i].width, cases[i].height, values);
        def.x = cases[i].x;
        def.spacingX = cases[i].spacingX;
        s_messages[0] = '\0';
        assert_int_equal(swCreateRaster(&host, &def, &raster), SW_ERROR_INVALID);
        assert_null(raster);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
}

static void MemoryIsGivenBack(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    const float values[4] = {0.0f, 1.0f, 2.0f, 3.0f};
    swRasterDef def = MakeDef(2, 2, values);
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    assert_int_equal(swRaster_GetInfo(raster).memory, memory.bytes);
    swDestroyRaster(raster);
    assert_int_equal(memory.bytes, 0);
    memory.failAt = memory.allocations;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_ERROR_NO_MEMORY);
    assert_null(raster);
    assert_int_equal(memory.messages, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(MiddlesOfCellsHaveTheirValuesToTheBit),
        cmocka_unit_test(BetweenMiddlesItIsBilinear),
        cmocka_unit_test(OutsideAndBesideUnknownCellsNothingIsKnown),
        cmocka_unit_test(OneCellIsAPoint),
        cmocka_unit_test(AnyChangeHasAnotherHash),
        cmocka_unit_test(WhatCannotBeIsRefusedByName),
        cmocka_unit_test(MemoryIsGivenBack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
