// SPDX-License-Identifier: MIT
#include "pace.h"

#include <math.h>

#include "support/cmocka_setup.h"

static Pace Run(double frame, double scale, double longest, int frames)
{
    Pace pace = {0};
    for (int i = 0; i < frames; i++)
    {
        double passed = frame < longest ? frame : longest;
        MeasurePace(&pace, frame, scale, passed * scale);
    }
    return pace;
}

static void AQuickSeaKeepsUp(void** state)
{
    (void)state;
    Pace pace = Run(1.0 / 60.0, 1.0, 0.25, 200);
    assert_true(fabsf(pace.ratio - 1.0f) < 1e-4f);
    assert_false(IsSeaSlow(&pace));
}

static void SlowFramesAreTold(void** state)
{
    (void)state;
    Pace pace = Run(0.5, 1.0, 0.25, 6);
    assert_true(fabsf(pace.ratio - 0.5f) < 1e-4f && fabsf(pace.frameMs - 500.0f) < 0.1f);
    assert_true(IsSeaSlow(&pace));
    pace = Run(5.0, 1.0, 0.25, 4); // one frame is longer than the span
    assert_true(fabsf(pace.ratio - 0.05f) < 1e-4f);
}

static void ScaledAndBackwardTimeIsMeasuredByItsOwnClock(void** state)
{
    (void)state;
    Pace pace = Run(1.0 / 30.0, -8.0, 0.25, 100);
    assert_true(fabsf(pace.ratio - 1.0f) < 1e-4f);
    pace = Run(0.5, 1000.0, 0.25, 6);
    assert_true(fabsf(pace.ratio - 0.5f) < 1e-4f);
    pace = Run(0.5, 0.0, 0.25, 6);
    assert_false(IsSeaSlow(&pace));
}

static void NothingIsSaidBeforeASpanIsOver(void** state)
{
    (void)state;
    Pace pace = Run(0.5, 1.0, 0.25, 2);
    assert_false(IsSeaSlow(&pace));
    pace = Run(0.5, 1.0, 0.25, 6);
    ForgetPace(&pace);
    assert_false(IsSeaSlow(&pace));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AQuickSeaKeepsUp),
        cmocka_unit_test(SlowFramesAreTold),
        cmocka_unit_test(ScaledAndBackwardTimeIsMeasuredByItsOwnClock),
        cmocka_unit_test(NothingIsSaidBeforeASpanIsOver),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
