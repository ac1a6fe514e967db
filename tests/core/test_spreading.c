// SPDX-License-Identifier: MIT
// Directions keep their moments: whatever goes in as mean direction and spread comes out of the distribution.

#include "support/cmocka_setup.h"

#include "core/spectra/spreading.h"

#include <math.h>
#include <stdio.h>

#include "seaway/math.h"

#define DIRECTIONS 72

// Moment n of the sum over a table's directions.
static void MeasureMoment(const float* density, int count, int n, double* cosine, double* sine)
{
    double step = 2.0 * SW_PI / count;
    *cosine = 0.0;
    *sine = 0.0;
    for (int i = 0; i < count; ++i)
    {
        *cosine += (double)density[i] * cos(n * i * step) * step;
        *sine += (double)density[i] * sin(n * i * step) * step;
    }
}

static void CosineSpreadingHasIntegralOne(void** state)
{
    (void)state;
    static const double exponents[] = {0.0, 0.5, 1.0, 8.0, 75.0, 200.0};
    for (int i = 0; i < 6; ++i)
    {
        double scale = swGetCosineSpreadScale(exponents[i]);
        double sum = 0.0;
        for (int j = 0; j < 3600; ++j)
        {
            sum += swGetCosineSpread(scale, exponents[i], 2.0 * SW_PI * j / 3600.0) * 2.0 * SW_PI / 3600.0;
        }
        assert_true(fabs(sum - 1.0) < 1e-6);
    }
}

static void CosineSpreadingHasItsMoments(void** state)
{
    (void)state;
    static const double exponents[] = {1.0, 8.0, 75.0};
    for (int i = 0; i < 3; ++i)
    {
        float density[360];
        double r1 = 0.0;
        double r2 = 0.0;
        double cosine = 0.0;
        double sine = 0.0;
        swFillCosineSpread(exponents[i], 0.7, 360, density);
        swGetCosineMoments(exponents[i], &r1, &r2);
        MeasureMoment(density, 360, 1, &cosine, &sine);
        assert_true(fabs(cosine - r1 * cos(0.7)) < 2e-4 && fabs(sine - r1 * sin(0.7)) < 2e-4);
        MeasureMoment(density, 360, 2, &cosine, &sine);
        assert_true(fabs(cosine - r2 * cos(1.4)) < 4e-4 && fabs(sine - r2 * sin(1.4)) < 4e-4);
    }
}

static void CosineSpreadingHasPublishedShape(void** state)
{
    (void)state;
    // cos^20(theta / 2) at multiples of 18 degrees.
    static const double shape[] = {1.0, 0.78055, 0.36654, 0.099452, 0.014426};
    double peak = swGetCosineSpread(1.0, 10.0, 0.0);
    for (int i = 0; i < 5; ++i)
    {
        assert_true(fabs(swGetCosineSpread(1.0, 10.0, SW_PI * i / 10.0) / peak - shape[i]) < 2e-5);
    }
}

static void MaximumEntropyKeepsItsMoments(void** state)
{
    (void)state;
    double worst = 0.0;
    int count = 0;
    for (double r1 = 0.0; r1 < 0.97; r1 += 0.08)
    {
        for (double inner = -0.9; inner < 0.95; inner += 0.2)
        {
            // Any second moment inside of the circle of possible ones, about a turned mean direction.
            double angle = 0.37 + r1 + inner;
            swMoments wanted = {r1 * cos(angle), r1 * sin(angle), r1 * r1 * cos(2.0 * angle),
                                r1 * r1 * sin(2.0 * angle)};
            wanted.a2 += inner * (1.0 - r1 * r1) * cos(1.1);
            wanted.b2 += inner * (1.0 - r1 * r1) * sin(1.1);
            float density[DIRECTIONS];
            swFillMaximumEntropy(&wanted, DIRECTIONS, density);
            double a1 = 0.0;
            double b1 = 0.0;
            double a2 = 0.0;
            double b2 = 0.0;
            MeasureMoment(density, DIRECTIONS, 1, &a1, &b1);
            MeasureMoment(density, DIRECTIONS, 2, &a2, &b2);
            worst = fmax(worst, hypot(a1 - wanted.a1, b1 - wanted.b1));
            worst = fmax(worst, hypot(a2 - wanted.a2, b2 - wanted.b2));
            ++count;
            for (int i = 0; i < DIRECTIONS; ++i)
            {
                assert_true(density[i] >= 0.0f);
            }
        }
    }
    print_message("worst moment error of %d distributions: %.2e\n", count, worst);
    assert_true(worst < 5e-3); // the sharpest of them have peaks of a degree, a fifth of the table's step
}

static void MaximumEntropyOfNothingIsEven(void** state)
{
    (void)state;
    swMoments none = {0.0, 0.0, 0.0, 0.0};
    float density[DIRECTIONS];
    swFillMaximumEntropy(&none, DIRECTIONS, density);
    for (int i = 0; i < DIRECTIONS; ++i)
    {
        assert_true(fabs((double)density[i] - 1.0 / (2.0 * SW_PI)) < 1e-7);
    }
}

static void ImpossibleMomentsAreCorrectedAndTold(void** state)
{
    (void)state;
    swMoments tooLong = {1.2, 0.0, 1.0, 0.0};
    assert_true(swCorrectMoments(&tooLong));
    assert_true(tooLong.a1 < 1.0 && tooLong.a1 > 0.9 && tooLong.b1 == 0.0);

    swMoments contradictory = {0.9, 0.0, -0.9, 0.0}; // narrow, yet across itself
    assert_true(swCorrectMoments(&contradictory));
    double room = 1.0 - 0.81;
    assert_true(fabs(contradictory.a2 - 0.81) < room);

    swMoments sound = {0.5, 0.1, 0.3, 0.0};
    swMoments copy = sound;
    assert_false(swCorrectMoments(&sound));
    assert_memory_equal(&sound, &copy, sizeof(sound));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(CosineSpreadingHasIntegralOne),    cmocka_unit_test(CosineSpreadingHasItsMoments),
        cmocka_unit_test(CosineSpreadingHasPublishedShape), cmocka_unit_test(MaximumEntropyKeepsItsMoments),
        cmocka_unit_test(MaximumEntropyOfNothingIsEven),    cmocka_unit_test(ImpossibleMomentsAreCorrectedAndTold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
