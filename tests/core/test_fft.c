// SPDX-License-Identifier: MIT

// The panel transform against a naive one in double, at every size and for every instruction set.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/wide_probe.h"
#include "seaway/math.h"

enum
{
    MAX_SIZE = 512,
    ROW = 16
};

static float input[MAX_SIZE * ROW];
static float work[MAX_SIZE * ROW];
static float output[MAX_SIZE * ROW];

static void FillPanel(float* panel, int rows, int seed)
{
    for (int i = 0; i < rows * ROW; ++i)
    {
        panel[i] = (float)(2.0 * swHashToUnit(swHashWave((uint32_t)seed, 0, i, 0, 0)) - 1.0);
    }
}

// Column `lane` of a panel, transformed by the definition.
static void TransformNaively(int size, const float* panel, int lane, double* re, double* im)
{
    for (int k = 0; k < size; ++k)
    {
        re[k] = 0.0;
        im[k] = 0.0;
        for (int n = 0; n < size; ++n)
        {
            double angle = 2.0 * SW_PI * ((n * k) % size) / size;
            double x = (double)panel[n * ROW + lane];
            double y = (double)panel[n * ROW + 8 + lane];
            re[k] += x * cos(angle) - y * sin(angle);
            im[k] += x * sin(angle) + y * cos(angle);
        }
    }
}

// RMS error relative to the RMS of the result, over all lanes.
static double CompareWithNaive(int size, const float* panel, const float* got)
{
    double re[MAX_SIZE], im[MAX_SIZE];
    double error = 0.0;
    double square = 0.0;
    for (int lane = 0; lane < 8; ++lane)
    {
        TransformNaively(size, panel, lane, re, im);
        for (int k = 0; k < size; ++k)
        {
            double er = (double)got[k * ROW + lane] - re[k];
            double ei = (double)got[k * ROW + 8 + lane] - im[k];
            error += er * er + ei * ei;
            square += re[k] * re[k] + im[k] * im[k];
        }
    }
    return sqrt(error / square);
}

static void TransformIsTheNaiveOne(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int size = 16; size <= MAX_SIZE; size *= 2)
    {
        FillPanel(input, size, size);
        static float first[MAX_SIZE * ROW];
        for (int probe = 0; probe < count; ++probe)
        {
            probes[probe]->transform(size, false, input, work, output);
            if (probe == 0)
            {
                memcpy(first, output, sizeof first);
                double error = CompareWithNaive(size, input, output);
                print_message("N = %3d: error %.2e\n", size, error);
                assert_true(error < 3e-7);
            }
            assert_memory_equal(first, output, (size_t)size * ROW * sizeof(float));
        }
    }
}

static void PrunedTransformIsTheNaiveOneOfABand(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int size = 16; size <= MAX_SIZE; size *= 2)
    {
        static float band[(MAX_SIZE / 2 + 1) * ROW];
        FillPanel(band, size / 2 + 1, 3 * size);
        // Bins 0 .. N/4 - 1, -N/4 .. -1, and N/4.
        memset(input, 0, sizeof input);
        size_t row = ROW * sizeof(float);
        memcpy(input, band, (size_t)(size / 4) * row);
        memcpy(input + 3 * size / 4 * ROW, band + size / 4 * ROW, (size_t)(size / 4) * row);
        memcpy(input + size / 4 * ROW, band + size / 2 * ROW, row);
        for (int probe = 0; probe < count; ++probe)
        {
            probes[probe]->transform(size, true, band, work, output);
            assert_true(CompareWithNaive(size, input, output) < 3e-7);
        }
    }
}

static void ImpulseBecomesAPureWave(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int probe = 0; probe < count; ++probe)
    {
        for (int lane = 0; lane < 8; ++lane)
        {
            memset(input, 0, sizeof input);
            input[3 * ROW + lane] = 1.0f;
            probes[probe]->transform(128, false, input, work, output);
            for (int k = 0; k < 128; ++k)
            {
                for (int other = 0; other < 8; ++other)
                {
                    double angle = 2.0 * SW_PI * 3.0 * k / 128.0;
                    double re = other == lane ? cos(angle) : 0.0;
                    double im = other == lane ? sin(angle) : 0.0;
                    assert_true(fabs((double)output[k * ROW + other] - re) < 2e-7);
                    assert_true(fabs((double)output[k * ROW + 8 + other] - im) < 2e-7);
                }
            }
        }
    }
}

// Swapping real and imaginary parts before and after turns the transform into its inverse times N.
static void SwapParts(float* panel, int size)
{
    for (int n = 0; n < size; ++n)
    {
        for (int lane = 0; lane < 8; ++lane)
        {
            float re = panel[n * ROW + lane];
            panel[n * ROW + lane] = panel[n * ROW + 8 + lane];
            panel[n * ROW + 8 + lane] = re;
        }
    }
}

static void ThereAndBackIsTheSame(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    for (int size = 16; size <= MAX_SIZE; size *= 2)
    {
        for (int probe = 0; probe < count; ++probe)
        {
            static float back[MAX_SIZE * ROW];
            FillPanel(input, size, 9);
            probes[probe]->transform(size, false, input, work, output);
            SwapParts(output, size);
            probes[probe]->transform(size, false, output, work, back);
            SwapParts(back, size);
            for (int i = 0; i < size * ROW; ++i)
            {
                assert_true(fabs((double)back[i] / size - (double)input[i]) < 1e-6);
            }
        }
    }
}

static void TransformIsLinear(void** state)
{
    (void)state;
    const WideProbe* probes[8];
    int count = ListWideProbes(probes);
    static float a[MAX_SIZE * ROW], b[MAX_SIZE * ROW], ta[MAX_SIZE * ROW], tb[MAX_SIZE * ROW];
    const int size = 256;
    FillPanel(a, size, 1);
    FillPanel(b, size, 2);
    for (int i = 0; i < size * ROW; ++i)
    {
        input[i] = 2.0f * a[i] - 0.5f * b[i];
    }
    for (int probe = 0; probe < count; ++probe)
    {
        probes[probe]->transform(size, false, a, work, ta);
        probes[probe]->transform(size, false, b, work, tb);
        probes[probe]->transform(size, false, input, work, output);
        for (int i = 0; i < size * ROW; ++i)
        {
            assert_float_equal(output[i], 2.0f * ta[i] - 0.5f * tb[i], 1e-4f);
        }
    }
}

static void TwiddlesAreSinesAndCosines(void** state)
{
    (void)state;
    static const float table[2 * MAX_SIZE] = {
#include "core/math/fft_twiddles.inl"
    };
    for (int n = 0; n < MAX_SIZE; ++n)
    {
        double angle = 2.0 * SW_PI * n / MAX_SIZE;
        assert_true(fabs((double)table[2 * n] - swCos(angle)) < 3.1e-8);
        assert_true(fabs((double)table[2 * n + 1] - swSin(angle)) < 3.1e-8);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TransformIsTheNaiveOne),  cmocka_unit_test(PrunedTransformIsTheNaiveOneOfABand),
        cmocka_unit_test(ImpulseBecomesAPureWave), cmocka_unit_test(ThereAndBackIsTheSame),
        cmocka_unit_test(TransformIsLinear),       cmocka_unit_test(TwiddlesAreSinesAndCosines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
