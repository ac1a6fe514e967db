// SPDX-License-Identifier: MIT
// The unified spectrum of Elfouhaily, Chapron, Katsaros and Vandemark [Elfouhaily 1997] by wave number k over all
// directions: S(k) = (B_l + B_h) / k^3, with c(k) = sqrt(g / k (1 + (k / k_m)^2)), k_m = 370 rad/m, c_m = 0.23 m/s,
//   B_l = alpha_p / 2 (c_p / c) L J exp(-age / sqrt 10 (sqrt(k / k_p) - 1)),   alpha_p = 0.006 sqrt(age),
//   B_h = alpha_m / 2 (c_m / c) L J exp(-(k / k_m - 1)^2 / 4),
//   alpha_m = 0.01 (1 + ln(u* / c_m)) for u* up to c_m, 0.01 (1 + 3 ln(u* / c_m)) above,
//   L = exp(-5/4 (k_p / k)^2),  J = gamma^exp(-(sqrt(k / k_p) - 1)^2 / (2 sigma^2)),
//   gamma = 1.7 + 6 log10 age (1.7 for an age below 1),  sigma = 0.08 (1 + 4 / age^3),  k_p = g (age / U)^2.
//
// Where the paper and those who took it over differ, this is what is taken here:
// - alpha_p has the square root of the age, as the paper's equation 34 and its author's own program have it. Many later
//   programs have the exponent 0.55, which [Donelan 1985] found for another range of the spectrum.
// - The short waves have L and J as well. They are missing in the paper's equation 41; without them ripples would go on
//   through the longest waves, which adds half a percent to the slopes.
// - The logarithm in gamma is to the base of ten, as in JONSWAP's growth curves.
// - u* is that of [Wu 1982], as for all spreadings. The paper's own roughness, z0 = 3.7e-5 U^2 / g age^0.9, makes
//   slopes 1 % larger in a developed sea, and 8 % in a young one of age 2.

#include "core/spectra/compiled.h"

#include <math.h>

#include "core/math/scalar.h"

#define RIPPLE_NUMBER 370.0
#define RIPPLE_SPEED 0.23
#define LN_10 2.302585092994046

static double getShortLevel(double friction)
{
    if (!(friction > 0.0))
    {
        return 0.0;
    }
    double growth = swLn(friction / RIPPLE_SPEED);
    double level = 0.01 * (1.0 + (friction > RIPPLE_SPEED ? 3.0 : 1.0) * growth);
    return level > 0.0 ? level : 0.0; // a breath of wind has no ripples
}

swElfouhaily swMakeElfouhaily(double gravity, double windSpeed, double age, double drag)
{
    double inverse = age / windSpeed;
    return (swElfouhaily){
        .gravity = gravity,
        .peakNumber = gravity * inverse * inverse,
        .peakSpeed = windSpeed / age,
        .age = age,
        .longLevel = 0.006 * sqrt(age),
        .shortLevel = getShortLevel(sqrt(drag) * windSpeed),
        .gammaLn = swLn(1.7 + (age > 1.0 ? 6.0 * swLn(age) / LN_10 : 0.0)),
        .sigma = 0.08 * (1.0 + 4.0 / (age * age * age)),
    };
}

double swGetElfouhailyDensity(const swElfouhaily* shape, double k)
{
    double ratio = shape->peakNumber / k;
    if (!(k > 0.0) || ratio > 25.0)
    {
        return 0.0; // exp(-781)
    }
    double ripple = k / RIPPLE_NUMBER;
    double speed = sqrt(shape->gravity / k * (1.0 + ripple * ripple));
    double root = sqrt(1.0 / ratio) - 1.0;
    double enhancement = shape->gammaLn * swExp(-0.5 * root * root / (shape->sigma * shape->sigma));
    double common = -1.25 * ratio * ratio + enhancement;
    double longWaves = shape->longLevel * shape->peakSpeed * swExp(common - shape->age * 0.31622776601683794 * root);
    double shortWaves = shape->shortLevel * RIPPLE_SPEED * swExp(common - 0.25 * (ripple - 1.0) * (ripple - 1.0));
    return 0.5 * (longWaves + shortWaves) / (speed * k * k * k);
}
