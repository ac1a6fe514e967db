// SPDX-License-Identifier: MIT

// The wide float: every instruction set gives the bits that plain C gives.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/wide_probe.h"

// Any finite float, denormals and both zeros among them.
static float GetFloat(int index, int stream)
{
    uint32_t bits = (uint32_t)swHashWave(5, stream, index, 0, 0);
    if ((bits & 0x7f800000u) == 0x7f800000u)
    {
        bits &= 0x807fffffu;
    }
    if (index % 17 == 0)
    {
        bits &= 0x80000000u;
    }
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void EveryOperationGivesTheSameBits(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int round = 0; round < 2000; ++round)
    {
        float a[PROBE_LANES], b[PROBE_LANES];
        uint32_t m[PROBE_LANES], n[PROBE_LANES];
        for (int i = 0; i < PROBE_LANES; ++i)
        {
            a[i] = GetFloat(round * PROBE_LANES + i, 0);
            b[i] = GetFloat(round * PROBE_LANES + i, 1);
            m[i] = (uint32_t)swHashWave(5, 2, round, i, 0);
            n[i] = (uint32_t)swHashWave(5, 3, round, i, 0);
        }
        float wanted[PROBE_OPERATIONS * PROBE_LANES];
        probes[0]->runOperations(a, b, m, n, wanted);
        assert_true(wanted[0] == a[0] + b[0]);
        for (int probe = 1; probe < count; ++probe)
        {
            float got[PROBE_OPERATIONS * PROBE_LANES];
            probes[probe]->runOperations(a, b, m, n, got);
            for (int operation = 0; operation < PROBE_OPERATIONS; ++operation)
            {
                if (memcmp(got + operation * PROBE_LANES, wanted + operation * PROBE_LANES,
                           PROBE_LANES * sizeof(float)) != 0)
                {
                    fail_msg("operation %d differs in %s", operation, swIsa_GetName(probes[probe]->isa));
                }
            }
        }
    }
}

static void SineAndCosineAreTheScalarOnes(void** state)
{
    (void)state;
    enum
    {
        COUNT = 8192
    };
    static uint32_t phases[COUNT];
    static float sines[COUNT], cosines[COUNT];
    for (int i = 0; i < COUNT; ++i)
    {
        // Random phases, and those around every eighth of a turn.
        phases[i] =
            i < 256 ? (uint32_t)(i / 32) * 0x20000000u + (uint32_t)(i % 32) - 16u : (uint32_t)swHashWave(1, 2, i, 3, 4);
    }
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int probe = 0; probe < count; ++probe)
    {
        probes[probe]->sinCosTurns(phases, COUNT, sines, cosines);
        for (int i = 0; i < COUNT; ++i)
        {
            float s, c;
            swSinCosTurns(phases[i], &s, &c);
            assert_memory_equal(&s, &sines[i], sizeof s);
            assert_memory_equal(&c, &cosines[i], sizeof c);
        }
    }
}

static void ExponentialIsExact(void** state)
{
    (void)state;
    enum
    {
        ROW = 18 // where runOperations() leaves exp(m / 2^24)
    };
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    double worst = 0.0;
    for (int probe = 0; probe < count; ++probe)
    {
        for (int round = 0; round < 4000; ++round)
        {
            float zero[PROBE_LANES] = {0.0f}, out[PROBE_OPERATIONS * PROBE_LANES];
            uint32_t m[PROBE_LANES];
            for (int i = 0; i < PROBE_LANES; ++i)
            {
                double x = -86.9 + 166.8 * (round * PROBE_LANES + i) / (4000.0 * PROBE_LANES);
                m[i] = (uint32_t)(int32_t)(x * 0x1p24);
            }
            probes[probe]->runOperations(zero, zero, m, m, out);
            for (int i = 0; i < PROBE_LANES; ++i)
            {
                double wanted = exp((double)(float)(int32_t)m[i] * 0x1p-24);
                double error = fabs((double)out[ROW * PROBE_LANES + i] / wanted - 1.0);
                worst = error > worst ? error : worst;
            }
        }
    }
    print_message("exponential: worst relative error %.2g\n", worst);
    assert_true(worst < 2.5e-7);
}

static void TransposeMovesEveryElement(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int probe = 0; probe < count; ++probe)
    {
        float from[8 * 16], to[8 * 24];
        for (int i = 0; i < 8 * 16; ++i)
        {
            from[i] = (float)i;
        }
        memset(to, 0, sizeof to);
        probes[probe]->transpose8(from, 16, to, 24);
        for (int row = 0; row < 8; ++row)
        {
            for (int column = 0; column < 24; ++column)
            {
                assert_true(to[row * 24 + column] == (column < 8 ? from[column * 16 + row] : 0.0f));
            }
        }
    }
}

static void WidthsAreWhatTheSetsHold(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int probe = 0; probe < count; ++probe)
    {
        print_message("%s: %d wide\n", swIsa_GetName(probes[probe]->isa), probes[probe]->width);
        assert_int_equal(PROBE_LANES % probes[probe]->width, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryOperationGivesTheSameBits),
        cmocka_unit_test(SineAndCosineAreTheScalarOnes),
        cmocka_unit_test(ExponentialIsExact),
        cmocka_unit_test(TransposeMovesEveryElement),
        cmocka_unit_test(WidthsAreWhatTheSetsHold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
