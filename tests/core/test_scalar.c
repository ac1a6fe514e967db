// SPDX-License-Identifier: MIT

// Our elementary functions against the C library's, and their bits against those of every other machine.

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include "core/base/hash.h"
#include "core/math/random.h"
#include "core/math/scalar.h"
#include "seaway/math.h"

enum
{
    COUNT = 200000
};

// Uniform in [low, high), by number.
static double Pick(int index, double low, double high)
{
    return low + (high - low) * swHashToUnit(swHashWave(11, 0, index, 0, 0));
}

typedef double (*Function)(double x);

// The largest error relative to the larger of the truth and `floor`.
static double FindWorst(Function ours, Function theirs, double low, double high, double floorValue)
{
    double worst = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        double x = Pick(i, low, high);
        double truth = theirs(x);
        worst = fmax(worst, fabs(ours(x) - truth) / fmax(fabs(truth), floorValue));
    }
    return worst;
}

static void CheckWorst(const char* name, Function ours, Function theirs, double low, double high, double floorValue,
                       double limit)
{
    double worst = FindWorst(ours, theirs, low, high, floorValue);
    print_message("%s on [%g, %g]: %.2e\n", name, low, high, worst);
    assert_true(worst <= limit);
}

static void ExponentialIsAccurate(void** state)
{
    (void)state;
    CheckWorst("exp", swExp, exp, -700.0, 709.0, 0.0, 5e-16);
    CheckWorst("exp", swExp, exp, -1.0, 1.0, 0.0, 5e-16);
    assert_true(swExp(0.0) == 1.0);
    assert_true(swExp(800.0) == HUGE_VAL && swExp(-800.0) == 0.0);
    assert_true(fabs(swExp(-740.0) - exp(-740.0)) <= 0x1p-1074);
}

static void LogarithmIsAccurate(void** state)
{
    (void)state;
    CheckWorst("ln", swLn, log, 1e-3, 3.0, 0.0, 5e-16);
    CheckWorst("ln", swLn, log, 0.99, 1.01, 0.0, 5e-16);
    CheckWorst("ln", swLn, log, 1.0, 1e300, 0.0, 5e-16);
    assert_true(swLn(1.0) == 0.0);
    assert_true(fabs(swLn(0x1p-1070) / log(0x1p-1070) - 1.0) < 1e-15);
    assert_true(swLn(0.0) == -HUGE_VAL && isnan(swLn(-1.0)));
}

static void PowerIsAccurate(void** state)
{
    (void)state;
    double worst = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        double x = Pick(i, 0.01, 20.0);
        double y = Pick(i + COUNT, -6.0, 6.0);
        worst = fmax(worst, fabs(swPow(x, y) / pow(x, y) - 1.0));
    }
    print_message("pow: %.2e\n", worst);
    assert_true(worst < 1e-14);
    assert_true(swPow(7.0, 0.0) == 1.0);
}

static void SineAndCosineAreAccurate(void** state)
{
    (void)state;
    CheckWorst("sin", swSin, sin, -10.0, 10.0, 1e-3, 5e-16);
    CheckWorst("cos", swCos, cos, -10.0, 10.0, 1e-3, 5e-16);
    CheckWorst("sin", swSin, sin, -1e6, 1e6, 1.0, 1e-15);
    CheckWorst("cos", swCos, cos, -1e6, 1e6, 1.0, 1e-15);
}

static void ArctangentIsAccurate(void** state)
{
    (void)state;
    double worst = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        double x = Pick(i, -3.0, 3.0);
        double y = Pick(i + COUNT, -3.0, 3.0);
        double truth = atan2(y, x);
        worst = fmax(worst, fabs(swAtan2(y, x) - truth) / fmax(fabs(truth), 1e-3));
    }
    print_message("atan2: %.2e\n", worst);
    assert_true(worst < 5e-16);
    assert_true(swAtan2(0.0, 1.0) == 0.0 && swAtan2(1.0, 0.0) == 0.5 * SW_PI && swAtan2(0.0, -1.0) == SW_PI);
    assert_true(swAtan2(-1.0, 0.0) == -0.5 * SW_PI && swAtan2(0.0, 0.0) == 0.0);
}

static void HyperbolicTangentIsAccurate(void** state)
{
    (void)state;
    CheckWorst("tanh", swTanh, tanh, -3.0, 3.0, 0.0, 1e-15);
    CheckWorst("tanh", swTanh, tanh, 0.0, 1e-5, 0.0, 1e-15);
    CheckWorst("tanh", swTanh, tanh, -30.0, 30.0, 0.0, 1e-15);
}

static void GammaIsAccurate(void** state)
{
    (void)state;
    CheckWorst("gamma", swGamma, tgamma, 0.01, 20.0, 0.0, 3e-14);
    CheckWorst("gamma", swGamma, tgamma, 20.0, 170.0, 0.0, 3e-13);
    CheckWorst("ln gamma", swLogGamma, lgamma, 0.01, 500.0, 1.0, 1e-14);
}

static void FloatFunctionsAreWithinTwoUlp(void** state)
{
    (void)state;
    double worst = 0.0;
    double worstTurn = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        float x = (float)Pick(i, -87.0, 88.0);
        worst = fmax(worst, fabs((double)swExpF(x) / exp((double)x) - 1.0));
        uint32_t phase = (uint32_t)swHashWave(3, 0, i, 0, 0);
        float s, c;
        swSinCosTurns(phase, &s, &c);
        double angle = 2.0 * SW_PI * phase / 4294967296.0;
        worstTurn = fmax(worstTurn, fabs((double)s - sin(angle)));
        worstTurn = fmax(worstTurn, fabs((double)c - cos(angle)));
    }
    print_message("float exp: %.2f ulp; sine and cosine of turns: %.2f of 2^-24\n", worst / (double)FLT_EPSILON,
                  worstTurn * 16777216.0);
    assert_true(worst < 2.0 * (double)FLT_EPSILON);
    assert_true(worstTurn < 2.0 / 16777216.0);
    assert_true(swExpF(0.0f) == 1.0f && swExpF(-200.0f) == 0.0f && isinf(swExpF(200.0f)));
}

static void QuarterTurnsAreExact(void** state)
{
    (void)state;
    static const float wanted[5] = {0.0f, 1.0f, 0.0f, -1.0f, 0.0f};
    for (uint32_t quarter = 0; quarter < 4; ++quarter)
    {
        float s, c;
        swSinCosTurns(quarter << 30, &s, &c);
        assert_true(s == wanted[quarter]);
        assert_true(c == wanted[quarter + 1]);
    }
}

static void AddDouble(swHash* hash, double value)
{
    union
    {
        double value;
        uint64_t bits;
    } word = {.value = value};
    swAddHash(hash, word.bits);
}

// The digest is the one of x86-64 with gcc; any other machine must find the same.
static void BitsAreTheSameEverywhere(void** state)
{
    (void)state;
    swHash hash = swBeginHash();
    for (int i = 0; i < 20000; ++i)
    {
        AddDouble(&hash, swExp(Pick(i, -700.0, 700.0)));
        AddDouble(&hash, swLn(Pick(i, 1e-6, 1e6)));
        AddDouble(&hash, swPow(Pick(i, 0.1, 10.0), Pick(i + COUNT, -5.0, 5.0)));
        AddDouble(&hash, swSin(Pick(i, -100.0, 100.0)));
        AddDouble(&hash, swCos(Pick(i, -100.0, 100.0)));
        AddDouble(&hash, swAtan2(Pick(i, -1.0, 1.0), Pick(i + COUNT, -1.0, 1.0)));
        AddDouble(&hash, swTanh(Pick(i, -5.0, 5.0)));
        AddDouble(&hash, swLogGamma(Pick(i, 0.1, 300.0)));
        float floats[4] = {swExpF((float)Pick(i, -80.0, 80.0)), 0.0f, 0.0f, 0.0f};
        swSinCosTurns((uint32_t)swHashWave(1, 1, i, 1, 1), &floats[1], &floats[2]);
        swAddHashFloats(&hash, floats, 4);
    }
    uint64_t digest = swEndHash(&hash);
    print_message("digest of all functions: %016llx\n", (unsigned long long)digest);
    assert_true(digest == 0x3c43a883930052c0u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ExponentialIsAccurate), cmocka_unit_test(LogarithmIsAccurate),
        cmocka_unit_test(PowerIsAccurate),       cmocka_unit_test(SineAndCosineAreAccurate),
        cmocka_unit_test(ArctangentIsAccurate),  cmocka_unit_test(HyperbolicTangentIsAccurate),
        cmocka_unit_test(GammaIsAccurate),       cmocka_unit_test(FloatFunctionsAreWithinTwoUlp),
        cmocka_unit_test(QuarterTurnsAreExact),  cmocka_unit_test(BitsAreTheSameEverywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
