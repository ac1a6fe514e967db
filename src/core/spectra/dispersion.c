// SPDX-License-Identifier: MIT
// Gravity and surface tension pull a wave back, the sea floor shortens its stroke [Lamb 1932]:
//   omega^2 = (g k + sigma k^3) tanh(k d).
// Long waves feel the floor and all run at sqrt(g d); waves below 17 mm are ripples, drawn by surface tension, and the
// shorter the faster.

#include "core/spectra/dispersion.h"

#include <math.h>

#include "core/math/scalar.h"

#define MAX_STEPS 60

// omega^2 and its derivative by k.
static double getSquare(const swDispersion* dispersion, double k, double* derivative)
{
    double pull = dispersion->gravity * k + dispersion->surfaceTension * k * k * k;
    double pullRate = dispersion->gravity + 3.0 * dispersion->surfaceTension * k * k;
    if (isinf(dispersion->depth))
    {
        *derivative = pullRate;
        return pull;
    }
    double t = swTanh(k * dispersion->depth);
    *derivative = pullRate * t + pull * dispersion->depth * (1.0 - t * t);
    return pull * t;
}

double swGetOmega(const swDispersion* dispersion, double k)
{
    double derivative;
    return sqrt(getSquare(dispersion, k, &derivative));
}

double swGetGroupSpeed(const swDispersion* dispersion, double k)
{
    double derivative;
    double square = getSquare(dispersion, k, &derivative);
    return 0.5 * derivative / sqrt(square);
}

// Eckart's guess for waves drawn by gravity, off by 5 % at most, or the ripple of that frequency if it is longer.
static double guessWaveNumber(const swDispersion* dispersion, double square)
{
    double k = square / dispersion->gravity;
    if (!isinf(dispersion->depth))
    {
        k /= sqrt(swTanh(k * dispersion->depth));
    }
    if (dispersion->surfaceTension > 0.0)
    {
        double ripple = swPow(square / dispersion->surfaceTension, 1.0 / 3.0);
        k = ripple < k ? ripple : k;
    }
    return k;
}

double swGetWaveNumber(const swDispersion* dispersion, double omega)
{
    double square = omega * omega;
    if (!(square > 1e-30))
    {
        return 0.0;
    }
    // Newton's method; three or four steps in the sea, more where ripples feel the floor.
    double k = guessWaveNumber(dispersion, square);
    for (int i = 0; i < MAX_STEPS; ++i)
    {
        double derivative;
        double step = (getSquare(dispersion, k, &derivative) - square) / derivative;
        double next = k - step;
        k = next > 0.1 * k ? next : 0.1 * k;
        if (fabs(step) <= 1e-14 * k)
        {
            break;
        }
    }
    return k;
}
