// SPDX-License-Identifier: MIT
#pragma once

// Elementary functions with the same bits on every compiler and machine: polynomials in plain IEEE arithmetic, no libm
// (sqrt, floor, fabs and the like are exact and allowed). Double versions are good to about 1e-14 relative, float ones
// to 2 ulp. Used wherever a result reaches the surface.

#include <stdint.h>

#include "core/base/seam.h"

SW_SEAM_BEGIN

double swExp(double x);
double swLn(double x);            // x > 0
double swPow(double x, double y); // x > 0
double swSin(double x);
double swCos(double x);
double swAtan2(double y, double x);
double swTanh(double x);
double swGamma(double x);    // x > 0: 2e-14 up to 20, 3e-13 at 170, above which it leaves the range of double
double swLogGamma(double x); // x > 0; 1e-14 absolute near its zeros at 1 and 2

float swExpF(float x);

// Sine and cosine of phase * 2 pi / 2^32.
void swSinCosTurns(uint32_t phase, float* sine, float* cosine);

SW_SEAM_END
