// SPDX-License-Identifier: MIT
// One wave given by hand has a closed form, exact at any place and time: V6 (its speed, without drift, for thirty
// days), V8 (the trochoid's mean and shape above fixed places), V23 (a million metres from the origin).

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define POINT_COUNT 4096

static swWorld* CreateWave(const swWaveComponent* wave, double chop, double depth)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = wave;
    def.componentCount = 1;
    def.chop = (float)chop;
    def.spectrum.depth = (float)depth;
    return CreateTruthSea(&def);
}

// Largest error of heights at places around `center`, at a time.
static double FindHeightError(swWorld* world, const swWaveComponent* wave, double depth, swPosXZ center, double time)
{
    double k = TURN / (double)wave->wavelength,
           omega = TURN * swGetWaveFrequency((double)wave->wavelength, depth, (double)9.81f);
    double x = k * cos((double)wave->direction), z = k * sin((double)wave->direction), worst = 0.0;
    static swPosXZ points[POINT_COUNT];
    static float heights[POINT_COUNT];
    swQueryDef query = swDefaultQueryDef();
    ScatterPoints(1000.0, 3, POINT_COUNT, points);
    swWorld_SetTime(world, time);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i] = (swPosXZ){center.x + points[i].x, center.z + points[i].z};
    }
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINT_COUNT, points, &(swSurfaceSamples){.height = heights},
                          NULL);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        double phase = fmod(x * points[i].x, TURN) + fmod(z * points[i].z, TURN) - fmod(omega * time, TURN);
        double asked = (double)wave->amplitude * cos(phase + (double)wave->phase);
        worst = fmax(worst, fabs((double)heights[i] - asked));
    }
    return worst;
}

static const swPosXZ nearOrigin = {0.0, 0.0};

static void OneWaveIsWhereItShouldBeAfterThirtyDays(void** state)
{
    (void)state;
    static const double depths[2] = {(double)INFINITY, 10.0}, days[3] = {0.0, 1.0, 30.0};
    const swWaveComponent wave = {.wavelength = 64.0f, .direction = 0.7f, .amplitude = 1.0f, .phase = 0.3f};
    for (int i = 0; i < 2; ++i)
    {
        swWorld* world = CreateWave(&wave, 0.0, depths[i]);
        for (int j = 0; j < 3; ++j)
        {
            char what[128], over[32] = "deep water";
            if (isfinite(depths[i]))
            {
                snprintf(over, sizeof(over), "%.0f m", depths[i]);
            }
            snprintf(what, sizeof(what), "A Gerstner wave of 64 m and 1 m over %s after %.0f days, worst height", over,
                     days[j]);
            FindBelow(&(Finding){"V6", what, "a cos(k x - \xcf\x89 t)", "mm", 3}, 0.1,
                      1e3 * FindHeightError(world, &wave, depths[i], nearOrigin, 86400.0 * days[j] + 12.5));
        }
        swDestroyWorld(world);
    }
}

static void OneWaveIsTheSameAThousandKilometresAway(void** state)
{
    (void)state;
    double worst = 0.0;
    for (int i = 0; i < 12; ++i)
    {
        double heading = TURN * (i + 0.3) / 12.0;
        const swWaveComponent wave = {.wavelength = 8.0f, .direction = 0.7f, .amplitude = 0.5f, .phase = 0.3f};
        swWorld* world = CreateWave(&wave, 0.0, (double)INFINITY);
        worst = fmax(worst, FindHeightError(world, &wave, (double)INFINITY,
                                            (swPosXZ){1e6 * sin(heading), -1e6 * cos(heading)}, 100.0));
        swDestroyWorld(world);
    }
    FindBelow(&(Finding){"V23", "A Gerstner wave of 8 m and 0.5 m, 1000 km away at 12 headings, worst height",
                         "a cos(k x - \xcf\x89 t)", "mm", 3},
              0.1, 1e3 * worst);
}

static void ATrochoidIsSharpAboveAndFlatBelow(void** state)
{
    (void)state;
    const swWaveComponent wave = {.wavelength = 20.0f, .amplitude = 1.0f};
    swWorld* world = CreateWave(&wave, 1.0, (double)INFINITY);
    static swPosXZ points[POINT_COUNT];
    static float heights[POINT_COUNT], residuals[POINT_COUNT];
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i] = (swPosXZ){20.0 * (i + 0.5) / POINT_COUNT, 0.0};
    }
    swQueryDef query = swDefaultQueryDef();
    query.tolerance = 1e-5f;
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, POINT_COUNT, points,
                          &(swSurfaceSamples){.height = heights, .residual = residuals}, NULL);
    double mean = 0.0, square = 0.0, cube = 0.0, highest = -10.0, lowest = 10.0;
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        assert_true(residuals[i] <= 1e-5f);
        mean += (double)heights[i] / POINT_COUNT;
        highest = fmax(highest, (double)heights[i]);
        lowest = fmin(lowest, (double)heights[i]);
    }
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        double h = (double)heights[i] - mean;
        square += h * h / POINT_COUNT;
        cube += h * h * h / POINT_COUNT;
    }
    const double steepness = TURN / 20.0;
    const char* const source = "[Gerstner 1802]";
    FindNear(&(Finding){"V8", "Mean of a trochoid of 1 m and 20 m", "-k a\xc2\xb2 / 2", "m", 5}, -0.15708, mean, 1e-4);
    FindNear(&(Finding){"V8", "Crest of the same", source, "m", 4}, 1.0, highest, 1e-4);
    FindNear(&(Finding){"V8", "Trough of the same", source, "m", 4}, -1.0, lowest, 1e-4);
    // Exact for the trochoid: with x = u - a sin ku the moments of z = a cos ku above x are those above u times 1 - ka
    // cos ku.
    double s = steepness, variance = 0.5 - 0.25 * s * s, third = -0.375 * s + 0.75 * s - 0.25 * s * s * s;
    FindNear(&(Finding){"V8", "Variance of the same", "a\xc2\xb2 / 2 - (k a\xc2\xb2)\xc2\xb2 / 4", "m\xc2\xb2", 5},
             variance, square, 1e-4);
    FindNear(&(Finding){"V8", "Skewness of the same", "exact", "", 4}, third / pow(variance, 1.5),
             cube / pow(square, 1.5), 1e-3);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OneWaveIsWhereItShouldBeAfterThirtyDays),
        cmocka_unit_test(OneWaveIsTheSameAThousandKilometresAway),
        cmocka_unit_test(ATrochoidIsSharpAboveAndFlatBelow),
    };
    BeginTruth("truth_gerstner");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
