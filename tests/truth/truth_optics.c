// SPDX-License-Identifier: MIT
// V20: the reflectance that the shaders use, compiled as C: against the published table, at the critical angle, and in
// a white furnace, where what is not reflected has to come out on the other side.

#include "truth.h"

#include <math.h>

#include "shared/fresnel.h"

#define INDEX 1.333

static double Reflect(double degrees, double index)
{
    return (double)swFresnel((float)cos(degrees * DEGREE), (float)index);
}

static void WaterReflectsAsTheTableSays(void** state)
{
    (void)state;
    static const double table[][2] = {{0, 0.02037},  {10, 0.02038}, {20, 0.02056}, {30, 0.02144}, {40, 0.02450},
                                      {50, 0.03367}, {60, 0.05969}, {65, 0.08712}, {70, 0.13348}, {75, 0.21238},
                                      {80, 0.34792}, {85, 0.58352}, {88, 0.80404}, {89, 0.89628}, {90, 1.0}};
    for (int i = 0; i < (int)(sizeof(table) / sizeof(table[0])); ++i)
    {
        char what[64];
        snprintf(what, sizeof(what), "Reflectance from air at %.0f\xc2\xb0", table[i][0]);
        FindNear(&(Finding){"V20", what, "Fresnel, n = 1.333", "", 4}, table[i][1], Reflect(table[i][0], INDEX), 2e-5);
    }
    static const double below[][2] = {{0, 0.02037},  {20, 0.02105}, {30, 0.02552},
                                      {40, 0.05558}, {45, 0.13946}, {48, 0.43308}};
    for (int i = 0; i < (int)(sizeof(below) / sizeof(below[0])); ++i)
    {
        char what[64];
        snprintf(what, sizeof(what), "Reflectance from water at %.0f\xc2\xb0", below[i][0]);
        FindNear(&(Finding){"V20", what, "Fresnel, n = 1 / 1.333", "", 4}, below[i][1],
                 Reflect(below[i][0], 1.0 / INDEX), 2e-5);
    }
}

static void BeyondTheCriticalAngleEverythingIsReflected(void** state)
{
    (void)state;
    double open = 45.0, closed = 60.0;
    while (closed - open > 1e-4)
    {
        double middle = 0.5 * (open + closed);
        if (Reflect(middle, 1.0 / INDEX) < 1.0)
        {
            open = middle;
        }
        else
        {
            closed = middle;
        }
    }
    FindNear(&(Finding){"V20", "Critical angle in water", "arcsin(1 / n)", "\xc2\xb0", 2}, 48.607, closed, 0.01);
    for (double angle = 48.61; angle <= 90.0; angle += 0.1)
    {
        assert_true(Reflect(angle, 1.0 / INDEX) == 1.0);
    }
}

// Mean reflectance under a uniform sky, 2 integral of R(c) c dc, by the midpoint rule.
static double IntegrateDiffuse(double index)
{
    const int count = 20000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
        double cosine = (i + 0.5) / count;
        sum += 2.0 * (double)swFresnel((float)cosine, (float)index) * cosine / count;
    }
    return sum;
}

static void NoLightIsMadeOrLostAtTheSurface(void** state)
{
    (void)state;
    double above = IntegrateDiffuse(INDEX), below = IntegrateDiffuse(1.0 / INDEX);
    FindNear(&(Finding){"V20", "Reflectance under a uniform sky", "2 \xe2\x88\xab R cos d(cos)", "", 4}, 0.0664, above,
             1e-4);
    FindNear(&(Finding){"V20", "Reflectance of uniform light from below", "2 \xe2\x88\xab R cos d(cos)", "", 4}, 0.4746,
             below, 1e-4);
    // Radiance grows by n^2 as it enters, so in a white furnace as much leaves as enters.
    FindNear(&(Finding){"V20", "White furnace: what leaves over what enters", "n\xc2\xb2 (1 - R below) / (1 - R above)",
                        "", 4},
             1.0, INDEX * INDEX * (1.0 - below) / (1.0 - above), 2e-4);
    double worst = 0.0;
    for (double angle = 0.0; angle < 89.0; angle += 1.0)
    {
        double inside = asin(sin(angle * DEGREE) / INDEX) / DEGREE;
        worst = fmax(worst, fabs(Reflect(angle, INDEX) - Reflect(inside, 1.0 / INDEX)));
    }
    FindBelow(
        &(Finding){"V20", "Reflectance from above less that from below along one ray, worst", "reciprocity", "", 4},
        1e-4, worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WaterReflectsAsTheTableSays),
        cmocka_unit_test(BeyondTheCriticalAngleEverythingIsReflected),
        cmocka_unit_test(NoLightIsMadeOrLostAtTheSurface),
    };
    BeginTruth("truth_optics");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
