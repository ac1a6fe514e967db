// SPDX-License-Identifier: MIT
// What cannot be measured is refused, or answered with NaN.
#include "support/cmocka_setup.h"

#include <math.h>

#include <seaway/measure.h>

#include "support/messages.h"

static void LengthsAndFrequenciesOfNothingAreNan(void** state)
{
    (void)state;
    const double deep = (double)INFINITY, bad[] = {(double)NAN, -1.0, 0.0};
    for (int i = 0; i < 3; ++i)
    {
        assert_true(isnan(swGetWaveFrequency(bad[i], deep, 9.81)) && isnan(swGetWaveFrequency(10.0, bad[i], 9.81)));
        assert_true(isnan(swGetWaveFrequency(10.0, deep, bad[i])) && isnan(swGetWavelength(0.1, bad[i], 9.81)));
        assert_true(isnan(swGetWavelength(0.1, deep, bad[i])));
    }
    assert_true(isnan(swGetWavelength((double)NAN, deep, 9.81)) && isnan(swGetWavelength(-1.0, deep, 9.81)));
    double length = swGetWavelength(0.1, 20.0, 9.81);
    assert_true(fabs(swGetWaveFrequency(length, 20.0, 9.81) - 0.1) < 1e-9);
}

static void VarianceUpToNowhereIsNan(void** state)
{
    (void)state;
    static swSeaBins bins;
    static swSeaSums sums;
    swMakeEqualBins(0.1, 0.3, 2, &bins);
    sums.weight = 1.0;
    sums.h[0] = sums.h[1] = 1.0;
    assert_true(swEstimateVariance(&bins, &sums, 0.1, 0.3) > 0.0);
    assert_true(isnan(swEstimateVariance(&bins, &sums, (double)NAN, 0.3)));
    assert_true(isnan(swEstimateVariance(&bins, &sums, 0.1, (double)NAN)));
}

#ifdef NDEBUG // misuse: where asserts are on, the program stops
static void WhatTheWorldDoesNotReachIsRefused(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    static swSeaBins bins;
    static swSeaSums sums;
    swMakeEqualBins(0.1, 0.3, 4, &bins);
    const swSeaGauges gauges = {.area = 100.0, .gaugeCount = 1, .duration = 10.0};
    swSeaGauges far = gauges, late = gauges;
    far.area = 1e300;
    late.begin = 1e300;
    assert_int_equal(swRecordSea(world, &far, &bins, 1, &sums), SW_ERROR_INVALID);
    assert_int_equal(swRecordSea(world, &late, &bins, 1, &sums), SW_ERROR_INVALID);
    assert_int_equal(swRecordSea(world, &gauges, &bins, 1, &sums), SW_SUCCESS);
    bins.low[1] = (double)NAN;
    assert_int_equal(swRecordSea(world, &gauges, &bins, 1, &sums), SW_ERROR_INVALID);
    swSurfaceSums surface = {0};
    assert_int_equal(swLookAtSurface(world, 1e300, 10, &surface), SW_ERROR_INVALID);
    assert_int_equal(swLookAtSurface(world, 100.0, 10, &surface), SW_SUCCESS);
    swDestroyWorld(world);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LengthsAndFrequenciesOfNothingAreNan),
        cmocka_unit_test(VarianceUpToNowhereIsNan),
#ifdef NDEBUG
        cmocka_unit_test(WhatTheWorldDoesNotReachIsRefused),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
