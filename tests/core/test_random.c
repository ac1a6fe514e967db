// SPDX-License-Identifier: MIT

// Hashed random numbers: the same everywhere, uniform, and unrelated for neighbouring waves.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include "core/math/random.h"

static void HashIsTheSameEverywhere(void** state)
{
    (void)state;
    uint64_t hash = swHashWave(1, 5, -3, 17, 0);
    print_message("hash of a wave: %016llx\n", (unsigned long long)hash);
    assert_true(hash == 0xa52d4ff43a53dbf0u);
}

static void UnitsAreInsideZeroAndOne(void** state)
{
    (void)state;
    assert_true(swHashToUnit(0) > 0.0);
    assert_true(swHashToUnit(UINT64_MAX) < 1.0);
    assert_true(swHashToUnit(0) == 0x1p-53);
    assert_true(1.0 - swHashToUnit(UINT64_MAX) == 0x1p-53);
}

// Chi squared over 64 equal parts: mean 63, deviation 11.2.
static void UnitsAreUniform(void** state)
{
    (void)state;
    for (int stream = 0; stream < 4; ++stream)
    {
        int counts[64] = {0};
        for (int qz = -64; qz < 64; ++qz)
        {
            for (int qx = -64; qx < 64; ++qx)
            {
                counts[(int)(64.0 * swHashToUnit(swHashWave(1, 3, qx, qz, (uint32_t)stream)))] += 1;
            }
        }
        double chi = 0.0;
        for (int i = 0; i < 64; ++i)
        {
            chi += (counts[i] - 256.0) * (counts[i] - 256.0) / 256.0;
        }
        assert_true(chi > 63.0 - 45.0 && chi < 63.0 + 45.0);
    }
}

// The correlation of n independent pairs is about 1 / sqrt(n), here 0.008.
static double Correlate(int dSeed, int dBand, int dx, int dz, uint32_t dStream)
{
    double sum = 0.0;
    for (int qz = -64; qz < 64; ++qz)
    {
        for (int qx = -64; qx < 64; ++qx)
        {
            double a = swHashToUnit(swHashWave(1, 3, qx, qz, 0)) - 0.5;
            double b = swHashToUnit(swHashWave((uint32_t)(1 + dSeed), 3 + dBand, qx + dx, qz + dz, dStream)) - 0.5;
            sum += a * b;
        }
    }
    return 12.0 * sum / 16384.0;
}

static void NeighboursAreUnrelated(void** state)
{
    (void)state;
    assert_true(fabs(Correlate(0, 0, 0, 0, 0) - 1.0) < 0.03);
    assert_true(fabs(Correlate(1, 0, 0, 0, 0)) < 0.04);
    assert_true(fabs(Correlate(0, 1, 0, 0, 0)) < 0.04);
    assert_true(fabs(Correlate(0, 0, 1, 0, 0)) < 0.04);
    assert_true(fabs(Correlate(0, 0, 0, 1, 0)) < 0.04);
    assert_true(fabs(Correlate(0, 0, 1, -1, 0)) < 0.04);
    assert_true(fabs(Correlate(0, 0, 0, 0, 1)) < 0.04);
}

static void OneBitChangesHalfOfTheOthers(void** state)
{
    (void)state;
    for (int bit = 0; bit < 32; ++bit)
    {
        int changed = 0;
        for (uint32_t seed = 0; seed < 256; ++seed)
        {
            uint64_t difference = swHashWave(seed, 1, 2, 3, 4) ^ swHashWave(seed ^ (1u << bit), 1, 2, 3, 4);
            for (; difference != 0; difference &= difference - 1)
            {
                changed += 1;
            }
        }
        assert_in_range(changed, 256 * 30, 256 * 34);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(HashIsTheSameEverywhere),
        cmocka_unit_test(UnitsAreInsideZeroAndOne),
        cmocka_unit_test(UnitsAreUniform),
        cmocka_unit_test(NeighboursAreUnrelated),
        cmocka_unit_test(OneBitChangesHalfOfTheOthers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
