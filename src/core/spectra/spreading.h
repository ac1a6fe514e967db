// SPDX-License-Identifier: MIT
#pragma once

// Distributions of direction D(theta): densities per radian that integrate to one over the circle.

#include <stdbool.h>

// cos^2s(angle / 2) is to be multiplied by this [Longuet-Higgins 1963]. Exponent s in [0, 200].
double swGetCosineSpreadScale(double exponent);

// D at `angle` from the mean direction, radians. `scale` is swGetCosineSpreadScale(exponent).
double swGetCosineSpread(double scale, double exponent, double angle);

// The first two circular moments of cos^2s about its mean direction.
void swGetCosineMoments(double exponent, double* r1, double* r2);

// Circular moments of a distribution: a_n = integral of D cos(n theta), b_n of D sin(n theta).
typedef struct swMoments
{
    double a1, b1, a2, b2;
} swMoments;

// Move moments that no distribution can have, or only one of infinitely sharp peaks, to the nearest useful ones,
// keeping the mean direction.
// Returns whether they were impossible.
bool swCorrectMoments(swMoments* moments);

// The maximum-entropy distribution of possible moments on directions 2 pi j / count, each the mean of its cell. The
// sums over these directions have the given moments.
void swFillMaximumEntropy(const swMoments* moments, int count, float* density);

// cos^2s around a mean direction on directions 2 pi j / count, with integral one.
void swFillCosineSpread(double exponent, double meanDirection, int count, float* density);
