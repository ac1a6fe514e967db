// SPDX-License-Identifier: MIT

// Elementary functions in plain IEEE arithmetic. Each reduces its argument until a short series converges below the
// last bit, and sums that series in one fixed order; exp and ln in pairs, because a chain of twelve products and sums
// takes three times as long. The series are Taylor's, whose coefficients anyone can check; the ranges are small enough
// that a minimax fit would save one term at most.

#include "core/math/scalar.h"

#include <math.h>
#include <string.h>

#include "core/math/turns.h"

// ln 2 and pi / 2 in parts: the leading parts have trailing zero bits, so that a small integer times them is exact.
#define LN2_HIGH 0x1.62e42fefap-1
#define LN2_LOW 0x1.cf79abc9e3b3ap-40
#define HALF_PI_HIGH 0x1.921fb544p+0
#define HALF_PI_MIDDLE 0x1.0b4611a6p-34
#define HALF_PI_LOW 0x1.3198a2e037073p-69
#define LOG2_E 0x1.71547652b82fep+0
#define TWO_OVER_PI 0x1.45f306dc9c883p-1
#define HALF_LN_TWO_PI 0x1.d67f1c864beb5p-1
#define PI 0x1.921fb54442d18p+1

static uint64_t bitsOf(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double fromBits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

// 2^n for n in [-1022, 1023].
static double powerOfTwo(int n)
{
    return fromBits((uint64_t)(n + 1023) << 52);
}

double swExp(double x)
{
    if (x != x)
    {
        return x;
    }
    if (x > 709.79)
    {
        return HUGE_VAL;
    }
    if (x < -745.2)
    {
        return 0.0;
    }
    // x = n ln 2 + r with |r| <= 0.347; r^14 / 14! is below 2^-57.
    int n = (int)floor(x * LOG2_E + 0.5);
    double r = (x - n * LN2_HIGH) - n * LN2_LOW;
    double r2 = r * r;
    double r4 = r2 * r2;
    double low = (0.5 + r * (1.0 / 6.0)) + r2 * (1.0 / 24.0 + r * (1.0 / 120.0));
    double middle = (1.0 / 720.0 + r * (1.0 / 5040.0)) + r2 * (1.0 / 40320.0 + r * (1.0 / 362880.0));
    double high = (1.0 / 3628800.0 + r * (1.0 / 39916800.0)) + r2 * (1.0 / 479001600.0 + r * (1.0 / 6227020800.0));
    double sum = 1.0 + (r + r2 * (low + r4 * (middle + r4 * high)));
    // In two steps, so that results below the smallest normal number round once.
    int half = n / 2;
    return sum * powerOfTwo(half) * powerOfTwo(n - half);
}

double swLn(double x)
{
    if (!(x > 0.0) || x == HUGE_VAL)
    {
        return x > 0.0 ? x : (x == 0.0 ? -HUGE_VAL : (double)NAN);
    }
    int n = 0;
    if (x < 0x1p-1022)
    {
        x *= 0x1p54;
        n = -54;
    }
    // x = 2^n m with m in [sqrt(1/2), sqrt(2)).
    uint64_t bits = bitsOf(x);
    n += (int)(bits >> 52) - 1023;
    double m = fromBits((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    if (m >= 0x1.6a09e667f3bcdp+0)
    {
        m *= 0.5;
        n += 1;
    }
    // ln m = 2 artanh s, |s| <= 0.1716; s^24 / 25 is below 2^-60.
    double f = m - 1.0;
    double s = f / (m + 1.0);
    double s2 = s * s;
    double s4 = s2 * s2;
    double s8 = s4 * s4;
    double low = (1.0 / 3.0 + s2 * (1.0 / 5.0)) + s4 * (1.0 / 7.0 + s2 * (1.0 / 9.0));
    double middle = (1.0 / 11.0 + s2 * (1.0 / 13.0)) + s4 * (1.0 / 15.0 + s2 * (1.0 / 17.0));
    double high = (1.0 / 19.0 + s2 * (1.0 / 21.0)) + s4 * (1.0 / 23.0);
    double sum = low + s8 * (middle + s8 * high);
    // 2 s = f - s f, and f is exact: so the rounding of s hardly shows.
    double tail = 2.0 * s * (s2 * sum) - s * f;
    return n * LN2_HIGH + (f + (tail + n * LN2_LOW));
}

double swPow(double x, double y)
{
    if (y == 0.0)
    {
        return 1.0;
    }
    return swExp(y * swLn(x));
}

// x = (n + r) pi / 2 turned into r in radians, |r| <= pi / 4. Good while |x| stays below some 10^6.
static int reduceQuarterTurns(double x, double* r)
{
    double n = floor(x * TWO_OVER_PI + 0.5);
    *r = ((x - n * HALF_PI_HIGH) - n * HALF_PI_MIDDLE) - n * HALF_PI_LOW;
    return (int)((int64_t)n & 3);
}

// x^19 / 19! is below 2^-63 on the range.
static double sineSeries(double x)
{
    double x2 = x * x;
    double sum = 1.0 / 355687428096000.0;
    sum = 1.0 / 1307674368000.0 - sum * x2;
    sum = 1.0 / 6227020800.0 - sum * x2;
    sum = 1.0 / 39916800.0 - sum * x2;
    sum = 1.0 / 362880.0 - sum * x2;
    sum = 1.0 / 5040.0 - sum * x2;
    sum = 1.0 / 120.0 - sum * x2;
    sum = 1.0 / 6.0 - sum * x2;
    return x - x * (x2 * sum);
}

static double cosineSeries(double x)
{
    double x2 = x * x;
    double sum = 1.0 / 6402373705728000.0;
    sum = 1.0 / 20922789888000.0 - sum * x2;
    sum = 1.0 / 87178291200.0 - sum * x2;
    sum = 1.0 / 479001600.0 - sum * x2;
    sum = 1.0 / 3628800.0 - sum * x2;
    sum = 1.0 / 40320.0 - sum * x2;
    sum = 1.0 / 720.0 - sum * x2;
    sum = 1.0 / 24.0 - sum * x2;
    sum = 0.5 - sum * x2;
    return 1.0 - sum * x2;
}

static double sineOfQuadrant(int quadrant, double r)
{
    double value = (quadrant & 1) ? cosineSeries(r) : sineSeries(r);
    return (quadrant & 2) ? -value : value;
}

double swSin(double x)
{
    double r;
    int quadrant = reduceQuarterTurns(x, &r);
    return sineOfQuadrant(quadrant, r);
}

double swCos(double x)
{
    double r;
    int quadrant = reduceQuarterTurns(x, &r);
    return sineOfQuadrant(quadrant + 1, r);
}

// Arctangent of x in [0, 1]: the angle of the nearest eighth, and a series in what is left (at most 1/16).
static double arctangent(double x)
{
    static const double eighths[9] = {
        0x0p+0,
        0x1.fd5ba9aac2f6ep-4,
        0x1.f5b75f92c80ddp-3,
        0x1.6f61941e4def1p-2,
        0x1.dac670561bb4fp-2,
        0x1.1e00babdefeb4p-1,
        0x1.4978fa3269ee1p-1,
        0x1.700a7c5784634p-1,
        0x1.921fb54442d18p-1,
    };
    int eighth = (int)(x * 8.0 + 0.5);
    double c = eighth * 0.125;
    double d = (x - c) / (1.0 + x * c);
    double d2 = d * d;
    double sum = 1.0 / 15.0;
    sum = 1.0 / 13.0 - sum * d2;
    sum = 1.0 / 11.0 - sum * d2;
    sum = 1.0 / 9.0 - sum * d2;
    sum = 1.0 / 7.0 - sum * d2;
    sum = 1.0 / 5.0 - sum * d2;
    sum = 1.0 / 3.0 - sum * d2;
    return eighths[eighth] + (d - d * (d2 * sum));
}

double swAtan2(double y, double x)
{
    double ax = fabs(x);
    double ay = fabs(y);
    if (ax == 0.0 && ay == 0.0)
    {
        return 0.0;
    }
    double angle = ay <= ax ? arctangent(ay / ax) : 0.5 * PI - arctangent(ax / ay);
    if (x < 0.0)
    {
        angle = PI - angle;
    }
    return y < 0.0 ? -angle : angle;
}

double swTanh(double x)
{
    double a = fabs(x);
    double value;
    if (a < 0.6)
    {
        // The continued fraction of Lambert; nine levels reach 2^-60 at 0.6.
        double x2 = a * a;
        double fraction = 17.0;
        for (int level = 15; level >= 1; level -= 2)
        {
            fraction = level + x2 / fraction;
        }
        value = a / fraction;
    }
    else if (a < 22.0)
    {
        value = 1.0 - 2.0 / (swExp(2.0 * a) + 1.0);
    }
    else
    {
        value = 1.0;
    }
    return x < 0.0 ? -value : value;
}

double swLogGamma(double x)
{
    // Stirling's series from 12 up, where its eighth term is below 2^-58; below, Gamma(x) = Gamma(x + 1) / x.
    double product = 1.0;
    while (x < 12.0)
    {
        product *= x;
        x += 1.0;
    }
    double inverse = 1.0 / x;
    double i2 = inverse * inverse;
    double sum = 1.0 / 156.0;
    sum = sum * i2 - 691.0 / 360360.0;
    sum = sum * i2 + 1.0 / 1188.0;
    sum = sum * i2 - 1.0 / 1680.0;
    sum = sum * i2 + 1.0 / 1260.0;
    sum = sum * i2 - 1.0 / 360.0;
    sum = sum * i2 + 1.0 / 12.0;
    return (x - 0.5) * swLn(x) - x + HALF_LN_TWO_PI + sum * inverse - swLn(product);
}

double swGamma(double x)
{
    return swExp(swLogGamma(x));
}

float swExpF(float x)
{
    if (x != x)
    {
        return x;
    }
    if (x > 88.73f)
    {
        return HUGE_VALF;
    }
    if (x < -103.98f)
    {
        return 0.0f;
    }
    float n = floorf(x * 1.44269504f + 0.5f);
    float r = (x - n * 0.693359375f) - n * -2.12194440e-4f;
    float sum = 1.0f / 5040.0f;
    sum = sum * r + 1.0f / 720.0f;
    sum = sum * r + 1.0f / 120.0f;
    sum = sum * r + 1.0f / 24.0f;
    sum = sum * r + 1.0f / 6.0f;
    sum = sum * r + 0.5f;
    sum = 1.0f + (r + sum * (r * r));
    // Through double: its range holds every power of two that is needed, and the product rounds once.
    return (float)((double)sum * powerOfTwo((int)n));
}

void swSinCosTurns(uint32_t phase, float* sine, float* cosine)
{
    uint32_t quadrant = (phase + 0x20000000u) >> 30;
    float x = (float)(int32_t)(phase - (quadrant << 30)) * SW_TURNS_TO_RADIANS;
    float x2 = x * x;
    float s = SW_TURNS_SINE(x, x2);
    float c = SW_TURNS_COSINE(x2);
    float first = (quadrant & 1) ? c : s;
    float second = (quadrant & 1) ? s : c;
    *sine = (quadrant & 2) ? -first : first;
    *cosine = ((quadrant + 1) & 2) ? -second : second;
}
