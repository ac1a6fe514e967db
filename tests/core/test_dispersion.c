// SPDX-License-Identifier: MIT
// Waves run as fast as water lets them: published lengths and speeds, ripples, and the way back from a frequency.

#include "support/cmocka_setup.h"

#include "core/spectra/dispersion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/math/scalar.h"
#include "seaway/math.h"

#define OTHERS SW_SOURCE_DIR "/../shared/data/spectra/cdip_mhkit/dispersion_ValData1.json"

static void GravityWavesHavePublishedLengths(void** state)
{
    (void)state;
    // Airy's waves at g = 9.81 m/s^2 [Dean and Dalrymple 1991]: period s, depth m, k rad/m, phase and group speed m/s.
    static const double rows[][5] = {
        {4, HUGE_VAL, 0.251519, 6.2452, 3.1226},   {4, 20, 0.251540, 6.2447, 3.1250},
        {4, 10, 0.254628, 6.1690, 3.2775},         {4, 5, 0.283050, 5.5495, 3.7045},
        {4, 2, 0.387236, 4.0564, 3.4263},          {6, HUGE_VAL, 0.111786, 9.3679, 4.6839},
        {6, 20, 0.114137, 9.1749, 5.0233},         {6, 10, 0.129801, 8.0677, 5.6044},
        {6, 5, 0.164957, 6.3483, 5.2633},          {6, 2, 0.245596, 4.2639, 3.9560},
        {8, HUGE_VAL, 0.062880, 12.4905, 6.2452},  {8, 100, 0.062880, 12.4904, 6.2457},
        {8, 50, 0.063109, 12.4452, 6.3653},        {8, 20, 0.070762, 11.0991, 7.4090},
        {8, 10, 0.088622, 8.8623, 7.1795},         {8, 5, 0.118369, 6.6352, 5.9707},
        {8, 2, 0.181116, 4.3364, 4.1578},          {10, HUGE_VAL, 0.040243, 15.6131, 7.8065},
        {10, 100, 0.040269, 15.6032, 7.8415},      {10, 50, 0.041528, 15.1298, 8.5529},
        {10, 20, 0.051826, 12.1237, 9.2745},       {10, 10, 0.068019, 9.2374, 8.0699},
        {10, 5, 0.092836, 6.7680, 6.3268},         {10, 2, 0.143781, 4.3700, 4.2540},
        {12, HUGE_VAL, 0.027947, 18.7357, 9.3679}, {12, 100, 0.028148, 18.6017, 9.6768},
        {12, 50, 0.030675, 17.0694, 10.9767},      {12, 20, 0.041239, 12.6966, 10.5265},
        {12, 10, 0.055457, 9.4416, 8.5966},        {12, 5, 0.076548, 6.8401, 6.5276},
        {12, 2, 0.119321, 4.3881, 4.3070},         {16, HUGE_VAL, 0.015720, 24.9810, 12.4905},
        {16, 100, 0.016842, 23.3172, 14.3673},     {16, 50, 0.020412, 19.2383, 14.8065},
        {16, 20, 0.029592, 13.2704, 11.9415},      {16, 10, 0.040718, 9.6445, 9.1500},
        {16, 5, 0.056816, 6.9117, 6.7326},         {16, 2, 0.089124, 4.4062, 4.3602},
    };
    int count = (int)(sizeof(rows) / sizeof(rows[0]));
    for (int i = 0; i < count; ++i)
    {
        swDispersion water = {9.81, 0.0, rows[i][1]};
        double omega = 2.0 * SW_PI / rows[i][0];
        double k = swGetWaveNumber(&water, omega);
        assert_true(fabs(k / rows[i][2] - 1.0) < 1e-5 + 1e-6 / rows[i][2]);
        assert_true(fabs(omega / k / rows[i][3] - 1.0) < 2e-5);
        assert_true(fabs(swGetGroupSpeed(&water, k) / rows[i][4] - 1.0) < 2e-5);
    }
}

static void EveryFrequencyHasItsWave(void** state)
{
    (void)state;
    static const double depths[] = {0.005, 0.3, 4.0, 60.0, 5000.0, HUGE_VAL};
    static const double tensions[] = {0.0, 7.4e-5, 1e-3};
    double worst = 0.0;
    for (int i = 0; i < 18; ++i)
    {
        swDispersion water = {9.81, tensions[i % 3], depths[i / 3]};
        for (double k = 1e-5; k < 1e4; k *= 1.7)
        {
            double back = swGetWaveNumber(&water, swGetOmega(&water, k));
            worst = fmax(worst, fabs(back / k - 1.0));
        }
        assert_true(swGetWaveNumber(&water, 0.0) == 0.0);
    }
    print_message("worst relative error of a wave number: %.1e\n", worst);
    assert_true(worst < 1e-12);
}

static void GroupSpeedIsTheSlopeOfFrequency(void** state)
{
    (void)state;
    static const double depths[] = {0.02, 3.0, HUGE_VAL};
    for (int i = 0; i < 3; ++i)
    {
        swDispersion water = {9.81, 7.4e-5, depths[i]};
        for (double k = 1e-3; k < 3000.0; k *= 2.3)
        {
            double slope = (swGetOmega(&water, k * 1.0001) - swGetOmega(&water, k * 0.9999)) / (2e-4 * k);
            assert_true(fabs(swGetGroupSpeed(&water, k) / slope - 1.0) < 1e-6);
        }
    }
}

static void RipplesHaveASlowestSpeed(void** state)
{
    (void)state;
    // 0.074 N/m and 1000 kg/m^3: 0.2321 m/s at 17.26 mm and 13.45 Hz, where phase and group run together [Lamb 1932].
    swDispersion water = {9.81, 7.4e-5, HUGE_VAL};
    double slowest = 1.0, at = 0.0;
    for (double k = 200.0; k < 600.0; k += 0.01)
    {
        double speed = swGetOmega(&water, k) / k;
        if (speed < slowest)
        {
            slowest = speed;
            at = k;
        }
    }
    assert_true(fabs(slowest - 0.2321) < 1e-4);
    assert_true(fabs(2.0 * SW_PI / at - 0.01726) < 1e-5);
    assert_true(fabs(swGetOmega(&water, at) / (2.0 * SW_PI) - 13.45) < 0.01);
    assert_true(fabs(swGetGroupSpeed(&water, at) / slowest - 1.0) < 1e-4);
}

// The numbers of a list `"name": [...]` that comes after `from`. Returns where it ends.
static const char* ReadList(const char* from, const char* name, int count, double* values)
{
    const char* at = strstr(from, name);
    assert_non_null(at);
    at = strchr(at, '[');
    for (int i = 0; i < count; ++i)
    {
        char* end = NULL;
        values[i] = strtod(at + 1, &end);
        at = end;
    }
    return at;
}

static void WaveNumbersAreThoseOfOthers(void** state)
{
    (void)state;
    // 30 pairs each at 10 and 50 m, which MHKiT's tests hold to a summed squared error of 1e-6.
    FILE* file = fopen(OTHERS, "rb");
    if (file == NULL)
    {
        print_message("skipped: " OTHERS " is absent\n");
        skip();
    }
    static char text[65536];
    text[fread(text, 1, sizeof(text) - 1, file)] = '\0';
    fclose(file);
    const char* at = text;
    static const double depths[2] = {10.0, 50.0};
    for (int i = 0; i < 2; ++i)
    {
        double k[30], omega[30], error = 0.0;
        at = ReadList(at, "\"k\"", 30, k);
        at = ReadList(at, "\"w\"", 30, omega);
        swDispersion water = {9.81, 0.0, depths[i]};
        for (int j = 0; j < 30; ++j)
        {
            double difference = swGetWaveNumber(&water, omega[j]) - k[j];
            error += difference * difference;
        }
        print_message("%g m: squared error %.1e\n", depths[i], error);
        assert_true(error < 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(GravityWavesHavePublishedLengths), cmocka_unit_test(EveryFrequencyHasItsWave),
        cmocka_unit_test(GroupSpeedIsTheSlopeOfFrequency),  cmocka_unit_test(RipplesHaveASlowestSpeed),
        cmocka_unit_test(WaveNumbersAreThoseOfOthers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
