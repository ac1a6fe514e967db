// SPDX-License-Identifier: MIT
#pragma once

// Elementary functions with the same bits on every compiler and machine: polynomials in plain IEEE arithmetic, no libm
// (sqrt, floor, fabs and the like are exact and allowed). Double versions are good to about 1e-14 relative, float ones to
// 2 ulp. Used wherever a result reaches the surface.

#include <stdint.h>

double swExp(double x);
double swLn(double x);            // x > 0
double swPow(double x, double y); // x > 0
double swSin(double x);
double swCos(double x);
double swAtan2(double y, double x);
double swTanh(double x);
double swGamma(double x); // x in (0, 500): as exp of lgamma; see swLogGamma
double swLogGamma(double x);

float swExpF(float x);

// Sine and cosine of phase * 2 pi / 2^32.
void swSinCosTurns(uint32_t phase, float* sine, float* cosine);
