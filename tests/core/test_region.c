// SPDX-License-Identifier: MIT
// Waves by place: the formulas of shared/region.h, then seas.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "seaway/seaway.h"
#include "shared/region.h"

// ---- formulas ----

static void TwoWeightsHaveSquaresThatAddUpToOne(void** state)
{
    (void)state;
    double worst = 0.0, worstSlope = 0.0;
    const double step = 1e-3;
    for (int i = -100; i <= 1100; i++)
    {
        double share = 1e-3 * i;
        swWeightPair p = swPairWeights((float)share), smooth = swPairSmoothly((float)share);
        worst = fmax(worst, fabs((double)(p.first * p.first + p.second * p.second) - 1.0));
        worst = fmax(worst, fabs((double)(smooth.first * smooth.first + smooth.second * smooth.second) - 1.0));
        if (share > 0.01 && share < 0.99)
        {
            swWeightPair a = swPairWeights((float)(share - step)), b = swPairWeights((float)(share + step));
            swWeightPair c = swPairSmoothly((float)(share - step)), d = swPairSmoothly((float)(share + step));
            worstSlope = fmax(worstSlope, fabs((double)(b.first - a.first) / (2.0 * step) - (double)p.firstSlope));
            worstSlope = fmax(worstSlope, fabs((double)(b.second - a.second) / (2.0 * step) - (double)p.secondSlope));
            worstSlope = fmax(worstSlope, fabs((double)(d.first - c.first) / (2.0 * step) - (double)smooth.firstSlope));
        }
    }
    print_message("squares add up to 1 within %.1e; slopes are off by %.1e\n", worst, worstSlope);
    assert_true(worst < 1e-6 && worstSlope < 1e-3);
}

// One of `count` headings, at the middle of three speeds of a sea whose heights grow with the square of the speed.
static swInputRecord MakeWindRecord(int heading, int count, float speed, float below, float above)
{
    double turn = 2.0 * SW_PI / count, angle = turn * heading;
    swInputRecord record = {0};
    record.flags = SW_INPUT_TAKES_WIND;
    record.turn = (sw_vec4){(float)cos(angle), (float)sin(angle), (float)cos(turn), (float)sin(turn)};
    record.size = (sw_vec4){speed, below, above, 0.0f};
    record.value.z = below > 0.0f ? below * below / (speed * speed) : 1.0f;
    record.value.w = above > 0.0f ? above * above / (speed * speed) : 1.0f;
    return record;
}

static swInputChannel Constant(double value)
{
    return swMakeChannel((float)value, 0.0f, 0.0f);
}

static void HeadingsMixWithoutJumpsAndKeepTheEnergy(void** state)
{
    (void)state;
    const int count = 12, steps = 3600;
    double worst = 0.0, worstTurn = 0.0, jump = 0.0, before[12] = {0.0};
    for (int i = 0; i <= steps; i++)
    {
        double angle = 2.0 * SW_PI * i / steps, square = 0.0, x = 0.0, z = 0.0;
        int some = 0;
        for (int h = 0; h < count; h++)
        {
            swInputRecord record = MakeWindRecord(h, count, 10.0f, 0.0f, 0.0f);
            double w = (double)swFindWindWeight(record, Constant(10.0 * cos(angle)), Constant(10.0 * sin(angle))).value;
            square += w * w;
            x += w * w * (double)record.turn.x;
            z += w * w * (double)record.turn.y;
            some += w > 0.0 ? 1 : 0;
            jump = i > 0 ? fmax(jump, fabs(w - before[h])) : 0.0;
            before[h] = w;
        }
        worst = fmax(worst, fabs(square - 1.0));
        double off = remainder(atan2(z, x) - angle, 2.0 * SW_PI);
        worstTurn = fmax(worstTurn, fabs(off) * 180.0 / SW_PI);
        assert_true(some >= 1 && some <= 2);
    }
    print_message("of %d headings two are mixed: energy within %.1e, mean direction within %.2f degrees; a tenth of a "
                  "degree changes a weight by at most %.4f\n",
                  count, worst, worstTurn, jump);
    assert_true(worst < 1e-5 && worstTurn < 0.25 * 360.0 / count && jump < 0.01);
}

static void SpeedsMixToTheEnergyThatTheLawAsksFor(void** state)
{
    (void)state;
    const float speeds[4] = {0.0f, 5.0f, 10.0f, 20.0f};
    double worst = 0.0;
    for (double speed = 2.0; speed < 40.0; speed *= 1.01)
    {
        double square = 0.0;
        for (int i = 1; i < 4; i++)
        {
            float above = i < 3 ? speeds[i + 1] : 0.0f;
            swInputRecord record = MakeWindRecord(0, 8, speeds[i], speeds[i - 1], above);
            double w = (double)swFindSpeedWeight(record, (float)speed).x;
            double own = (double)(speeds[i] * speeds[i]);
            // Each speed's system answers for its own half of the ends only.
            bool isMine = (i > 1 || speed >= 0.0) && (i < 3 || speed >= 0.0);
            square += isMine ? w * w * own * own : 0.0;
        }
        worst = fmax(worst, fabs(sqrt(square) / (speed * speed) - 1.0));
    }
    print_message("heights grow with the square of the speed within %.1e\n", worst);
    assert_true(worst < 1e-5);
}

static void GradientsOfWeightsAreDerivatives(void** state)
{
    (void)state;
    const double d = 1e-3;
    double worst = 0.0, largest = 0.0;
    for (int i = 0; i < 4000; i++)
    {
        double x = 0.37 * i - 700.0, z = 911.0 - 0.53 * i;
        swInputRecord record = MakeWindRecord(i % 16, 16, 9.0f, 5.0f, 16.0f);
        double w[5] = {0.0};
        swInputChannel here = Constant(0.0);
        for (int k = 0; k < 5; k++)
        {
            double px = x + (k == 1 ? d : k == 2 ? -d : 0.0) * 100.0, pz = z + (k == 3 ? d : k == 4 ? -d : 0.0) * 100.0;
            // A wind that turns and grows over some hundred metres.
            double angle = 0.004 * px + 0.003 * pz, speed = 10.0 + 4.0 * sin(0.01 * px - 0.005 * pz);
            double speedX = 0.04 * cos(0.01 * px - 0.005 * pz), speedZ = -0.02 * cos(0.01 * px - 0.005 * pz);
            swInputChannel u =
                swMakeChannel((float)(speed * cos(angle)), (float)(speedX * cos(angle) - speed * sin(angle) * 0.004),
                              (float)(speedZ * cos(angle) - speed * sin(angle) * 0.003));
            swInputChannel v =
                swMakeChannel((float)(speed * sin(angle)), (float)(speedX * sin(angle) + speed * cos(angle) * 0.004),
                              (float)(speedZ * sin(angle) + speed * cos(angle) * 0.003));
            swInputChannel found = swFindWindWeight(record, u, v);
            w[k] = (double)found.value;
            here = k == 0 ? found : here;
        }
        if (w[0] > 0.0 && w[1] > 0.0 && w[2] > 0.0 && w[3] > 0.0 && w[4] > 0.0)
        {
            worst = fmax(worst, fabs((w[1] - w[2]) / (200.0 * d) - (double)here.alongX));
            worst = fmax(worst, fabs((w[3] - w[4]) / (200.0 * d) - (double)here.alongZ));
            largest = fmax(largest, fabs((double)here.alongX));
        }
    }
    print_message("gradients of up to %.4f per metre are off by %.1e\n", largest, worst);
    assert_true(largest > 0.01 && worst < 2e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TwoWeightsHaveSquaresThatAddUpToOne),
        cmocka_unit_test(HeadingsMixWithoutJumpsAndKeepTheEnergy),
        cmocka_unit_test(SpeedsMixToTheEnergyThatTheLawAsksFor),
        cmocka_unit_test(GradientsOfWeightsAreDerivatives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
