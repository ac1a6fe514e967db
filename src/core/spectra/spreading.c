// SPDX-License-Identifier: MIT
// Two ways to spread the energy of one frequency over directions.
//
// Formula: D = scale cos^2s(theta / 2) [Longuet-Higgins 1963], scale = Gamma(s + 1) / (2 sqrt(pi) Gamma(s + 1/2)). Its
// moments are r1 = s / (s + 1) and r2 = s (s - 1) / ((s + 1) (s + 2)).
//
// Measurement: a buoy reports the first two circular moments c1 and c2 (complex, c_n = integral of D exp(i n theta)).
// Among the distributions with these moments the one of largest entropy, in the sense of Burg, is [Lygre and Krogstad
// 1986]
//   D = (1 - p1 conj c1 - p2 conj c2) / (2 pi |1 - p1 exp(-i theta) - p2 exp(-2 i theta)|^2),
//   p1 = (c1 - c2 conj c1) / (1 - |c1|^2),  p2 = c2 - c1 p1.
// It is never negative. Moments are possible exactly if |c1| <= 1 and |c2 - c1^2| <= 1 - |c1|^2; at the border the
// distribution is one or two infinitely narrow peaks.

#include "core/spectra/spreading.h"

#include <math.h>

#include "core/math/scalar.h"
#include "seaway/math.h"

// Largest r1, and largest part of 1 - |c1|^2 that |c2 - c1^2| may have: peaks stay wider than about half a degree.
#define MAX_R1 0.99
#define MAX_SECOND 0.98

// Finest sampling of the distribution: parts of one of the table's directions.
#define MAX_PARTS 64

typedef struct Complex
{
    double re, im;
} Complex;

static Complex multiply(Complex a, Complex b)
{
    return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static Complex conjugate(Complex a)
{
    return (Complex){a.re, -a.im};
}

static double squareOf(Complex a)
{
    return a.re * a.re + a.im * a.im;
}

// Gamma(s + 1) / Gamma(s + 1/2), as builders of seas ask for it at every wave: from one s to the next it grows by
// (s + 1) / (s + 1/2), and for large s it is sqrt(x) (1 + 1 / (64 x^2) - 19 / (8192 x^4) + ...), x = s + 1/4
// [Fields 1966]. Good to 2e-13.
double swGetCosineSpreadScale(double exponent)
{
    double numerator = 1.0;
    double denominator = 1.0;
    while (exponent < 12.0)
    {
        numerator *= exponent + 0.5;
        denominator *= exponent + 1.0;
        exponent += 1.0;
    }
    double x = exponent + 0.25;
    double y = 1.0 / (x * x);
    double series =
        1.0 + y * (1.0 / 64.0 + y * (-19.0 / 8192.0 + y * (631.0 / 524288.0 - y * (174317.0 / 134217728.0))));
    return sqrt(x) * series * numerator / (denominator * 2.0 * sqrt(SW_PI));
}

double swGetCosineSpread(double scale, double exponent, double angle)
{
    if (exponent == 0.0)
    {
        return scale;
    }
    double square = 0.5 + 0.5 * swCos(angle); // cos^2(angle / 2)
    return square > 1e-30 ? scale * swExp(exponent * swLn(square)) : 0.0;
}

void swGetCosineMoments(double exponent, double* r1, double* r2)
{
    *r1 = exponent / (exponent + 1.0);
    *r2 = exponent * (exponent - 1.0) / ((exponent + 1.0) * (exponent + 2.0));
}

bool swCorrectMoments(swMoments* moments)
{
    Complex first = {moments->a1, moments->b1};
    Complex second = {moments->a2, moments->b2};
    bool impossible = false;

    double r1 = sqrt(squareOf(first));
    if (r1 > MAX_R1)
    {
        impossible = r1 > 1.0;
        // As wide as can be told; a second moment that stayed would then need waves from the other side.
        double shrink = MAX_R1 / r1, most = squareOf(second);
        first.re *= shrink;
        first.im *= shrink;
        double narrow = MAX_R1 * MAX_R1 * MAX_R1 * MAX_R1;
        double keep = most > narrow * narrow ? narrow / sqrt(most) : 1.0;
        second.re *= keep;
        second.im *= keep;
    }

    Complex square = multiply(first, first);
    Complex rest = {second.re - square.re, second.im - square.im};
    double room = 1.0 - squareOf(first);
    double length = sqrt(squareOf(rest));
    if (length > MAX_SECOND * room)
    {
        impossible = impossible || length > room;
        double keep = MAX_SECOND * room / length;
        second = (Complex){square.re + keep * rest.re, square.im + keep * rest.im};
    }

    *moments = (swMoments){first.re, first.im, second.re, second.im};
    return impossible;
}

// Averages over cells of width 2 pi / count around each direction, from `parts` samples a cell. Returns the integral.
static double averageCells(Complex p1, Complex p2, double level, int count, int parts, float* density)
{
    double cell = 2.0 * SW_PI / count;
    double start = -0.5 * cell + 0.5 * cell / parts;
    // exp(-i theta) by rotation: 46,000 steps lose some 1e-12.
    Complex turn = {swCos(cell / parts), -swSin(cell / parts)};
    Complex unit = {swCos(start), -swSin(start)};
    double total = 0.0;
    for (int i = 0; i < count; ++i)
    {
        double sum = 0.0;
        for (int j = 0; j < parts; ++j)
        {
            // Horner: 1 - u (p1 + p2 u)
            Complex pole = multiply(p2, unit);
            pole = multiply(unit, (Complex){p1.re + pole.re, p1.im + pole.im});
            sum += level / squareOf((Complex){1.0 - pole.re, -pole.im});
            unit = multiply(unit, turn);
        }
        density[i] = (float)(sum / parts);
        total += sum / parts * cell;
    }
    return total;
}

static void normalize(int count, float* density)
{
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
        sum += (double)density[i];
    }
    double scale = count / (2.0 * SW_PI * sum);
    for (int i = 0; i < count; ++i)
    {
        density[i] = (float)((double)density[i] * scale);
    }
}

// What averaging over cells leaves of the n-th moment.
static double getResponse(int count, int n)
{
    double half = SW_PI * n / count;
    return swSin(half) / half;
}

void swFillMaximumEntropy(const swMoments* moments, int count, float* density)
{
    double response1 = getResponse(count, 1);
    double response2 = getResponse(count, 2);
    swMoments sharp = {moments->a1 / response1, moments->b1 / response1, moments->a2 / response2,
                       moments->b2 / response2};
    swCorrectMoments(&sharp);

    Complex c1 = {sharp.a1, sharp.b1};
    Complex c2 = {sharp.a2, sharp.b2};
    double room = 1.0 - squareOf(c1);
    Complex p1 = multiply(c2, conjugate(c1));
    p1 = (Complex){(c1.re - p1.re) / room, (c1.im - p1.im) / room};
    Complex p2 = multiply(c1, p1);
    p2 = (Complex){c2.re - p2.re, c2.im - p2.im};
    double level = (1.0 - multiply(p1, conjugate(c1)).re - multiply(p2, conjugate(c2)).re) / (2.0 * SW_PI);

    // The integral is exactly one; sampling is fine enough once it says so.
    for (int parts = 1; parts <= MAX_PARTS; parts *= 2)
    {
        double total = averageCells(p1, p2, level, count, parts, density);
        if (parts > 1 && fabs(total - 1.0) < 1e-5)
        {
            break;
        }
    }
    normalize(count, density);
}

void swFillCosineSpread(double exponent, double meanDirection, int count, float* density)
{
    double scale = swGetCosineSpreadScale(exponent);
    for (int i = 0; i < count; ++i)
    {
        density[i] = (float)swGetCosineSpread(scale, exponent, 2.0 * SW_PI * i / count - meanDirection);
    }
    normalize(count, density);
}
