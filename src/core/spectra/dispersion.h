// SPDX-License-Identifier: MIT
#pragma once

// How fast waves of one length run: omega^2 = (g k + sigma k^3) tanh(k depth). Wave numbers k in rad/m, frequencies
// omega in rad/s.

typedef struct swDispersion
{
    double gravity;        // m/s^2
    double surfaceTension; // over density, m^3/s^2; 0 for none
    double depth;          // m; may be infinite
} swDispersion;

// k > 0.
double swGetOmega(const swDispersion* dispersion, double k);

// d omega / d k, m/s. k > 0.
double swGetGroupSpeed(const swDispersion* dispersion, double k);

// The one k that has this omega, to 1e-12 relative. 0 for omega = 0.
double swGetWaveNumber(const swDispersion* dispersion, double omega);
