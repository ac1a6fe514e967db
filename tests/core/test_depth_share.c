// SPDX-License-Identifier: MIT

// The law by which waves die out towards the shore.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include "seaway/math.h"
#include "shared/depth_share.h"

static const swAttenuation Nature = {.strength = 1.0f, .freeDepth = 0.0f};

static void InShallowWaterTheShareIsTanh(void** state)
{
    (void)state;
    for (float kd = 1e-4f; kd <= 0.5f * (float)SW_PI; kd += 0.001f)
    {
        swDepthShare found = swFindNaturalShare(kd);
        double truth = tanh((double)kd);
        assert_true(fabs((double)found.share - truth) < 2e-7);
        assert_true(fabs((double)found.slope - (1.0 - truth * truth)) < 1e-6);
    }
}

// The blend lifts the share by less than 0.01, so that nothing is seen of it.
static void TheShareStaysNearTanh(void** state)
{
    (void)state;
    double worst = 0.0;
    for (float kd = 0.0f; kd < 8.0f; kd += 0.0005f)
    {
        worst = fmax(worst, fabs((double)swFindNaturalShare(kd).share - tanh((double)kd)));
    }
    print_message("farthest from tanh: %.5f\n", worst);
    assert_true(worst < 0.01);
}

static void DeepWaterLeavesWavesAloneToTheBit(void** state)
{
    (void)state;
    for (float wavelength = 0.0625f; wavelength < 5000.0f; wavelength *= 1.37f)
    {
        float k = (float)(2.0 * SW_PI) / wavelength;
        const float depths[] = {0.5001f * wavelength, wavelength, 11000.0f, INFINITY};
        for (int i = 0; i < 4; ++i)
        {
            swDepthShare found = swFindDepthShare(Nature, k, depths[i]);
            bool isDeep = depths[i] > 0.5f * wavelength;
            assert_true(!isDeep || (found.share == 1.0f && found.slope == 0.0f && swIsDeepFor(Nature, k, depths[i])));
        }
        assert_true(swFindDepthShare(Nature, k, 0.4f * wavelength).share < 1.0f);
        assert_false(swIsDeepFor(Nature, k, 0.49f * wavelength));
    }
}

static void NothingIsLeftAtTheWatersEdge(void** state)
{
    (void)state;
    const float depths[] = {0.0f, -0.0f, -1e-3f, -8000.0f, -INFINITY};
    for (int i = 0; i < 5; ++i)
    {
        swDepthShare found = swFindDepthShare(Nature, 0.3f, depths[i]);
        assert_true(found.share == 0.0f && found.slope == 0.0f);
    }
    assert_true(swFindDepthShare(Nature, 0.3f, 1e-4f).share < 1e-4f);
    assert_true(swFindDepthShare((swAttenuation){1.0f, 20.0f}, 0.3f, 0.0f).share == 0.0f);
}

// Whatever a host asks for: never less where it is deeper, and slopes that are those of the values.
static void CheckCurve(swAttenuation attenuation, float k)
{
    const double step = 1e-3;
    float last = 0.0f, lastSlope = swFindDepthShare(attenuation, k, 1e-6f).slope;
    float steepest = 0.0f;
    for (double kd = 2e-3; kd < 4.0; kd += step)
    {
        float depth = (float)(kd / (double)k);
        float less = (float)((kd - step) / (double)k), more = (float)((kd + step) / (double)k);
        swDepthShare found = swFindDepthShare(attenuation, k, depth);
        assert_true(found.share >= last && found.share <= 1.0f);
        assert_true(found.slope >= 0.0f);
        double difference = ((double)swFindDepthShare(attenuation, k, more).share -
                             (double)swFindDepthShare(attenuation, k, less).share) /
                            ((double)more - (double)less);
        assert_true(fabs((double)found.slope - difference) < 2e-3 * (double)k);
        assert_float_equal(found.slope / k, lastSlope / k, 0.02f); // no jump of the slope
        last = found.share;
        lastSlope = found.slope;
        steepest = fmaxf(steepest, found.slope / k);
    }
    assert_true(steepest > 0.4f * attenuation.strength);
}

static void TheShareNeverFallsWithDepthAndItsSlopeIsExact(void** state)
{
    (void)state;
    const float waveNumbers[] = {0.0015f, 0.1f, 2.0f, 70.0f};
    for (int i = 0; i < 4; ++i)
    {
        float k = waveNumbers[i];
        CheckCurve(Nature, k);
        CheckCurve((swAttenuation){0.95f, 0.0f}, k);
        CheckCurve((swAttenuation){1.0f, 1.3f / k}, k);
        CheckCurve((swAttenuation){0.5f, 2.5f / k}, k);
    }
}

static void AHostMayAskForLess(void** state)
{
    (void)state;
    swAttenuation none = {.strength = 0.0f, .freeDepth = 0.0f};
    assert_true(swFindDepthShare(none, 0.1f, 1.0f).share == 1.0f);
    assert_true(swFindDepthShare(none, 0.1f, -5.0f).share == 1.0f);
    swAttenuation most = {.strength = 0.95f, .freeDepth = 0.0f};
    assert_float_equal(swFindDepthShare(most, 0.1f, 0.0f).share, 0.05f, 1e-7f);
    swAttenuation shallows = {.strength = 1.0f, .freeDepth = 20.0f};
    assert_true(swFindDepthShare(shallows, 0.01f, 20.0f).share == 1.0f);
    assert_true(swIsDeepFor(shallows, 0.01f, 20.0f) && !swIsDeepFor(shallows, 0.01f, 19.9f));
    assert_true(swFindDepthShare(shallows, 0.01f, 10.0f).share > swFindDepthShare(Nature, 0.01f, 10.0f).share);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(InShallowWaterTheShareIsTanh),
        cmocka_unit_test(TheShareStaysNearTanh),
        cmocka_unit_test(DeepWaterLeavesWavesAloneToTheBit),
        cmocka_unit_test(NothingIsLeftAtTheWatersEdge),
        cmocka_unit_test(TheShareNeverFallsWithDepthAndItsSlopeIsExact),
        cmocka_unit_test(AHostMayAskForLess),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
