// SPDX-License-Identifier: MIT
#pragma once

// Spectra ready for integration: what swSpectrumDef means, with energy calibrated and everything looked up once.
// Angular frequency omega in rad/s, direction theta in radians where waves go, densities in m^2 s / rad^2.

#include <stdbool.h>

#include "core/base/field.h"
#include "core/spectra/dispersion.h"
#include "seaway/spectrum.h"

typedef struct swCompiledSpectrum swCompiledSpectrum;

// Checks ranges (a sentence goes to the log) and copies tables.
// Gravity is needed by the formulas (Hasselmann 1973 and Pierson 1964 scale with g) and, with surface tension over
// density (m^3/s^2), by the dispersion.
swResult swCompileSpectrum(const swHost* host, const swSpectrumDef* def, double gravity, double surfaceTension,
                           swCompiledSpectrum** spectrum);
void swFreeCompiledSpectrum(const swHost* host, swCompiledSpectrum* spectrum);

// Gravity, surface tension and the def's depth.
swDispersion swGetCompiledDispersion(const swCompiledSpectrum* spectrum);

// S(omega): the integral over all directions, m^2 s. Includes the table's tail if asked for.
double swGetCompiledDensity(const swCompiledSpectrum* spectrum, double omega);

// S(omega, theta) = S(omega) D(omega, theta).
double swGetCompiledDensity2(const swCompiledSpectrum* spectrum, double omega, double theta);

// Integral of S(omega) over [omega0, omega1], m^2; accurate to 1e-5 relative however narrow the peak.
double swIntegrateCompiled(const swCompiledSpectrum* spectrum, double omega0, double omega1);

// A table has bins whose energy the waves in them share; any other spectrum is one bin. Bin 0 is below the table's
// first, the last one above its last.
#define SW_MAX_SPECTRUM_BINS 1026
int swFindCompiledBin(const swCompiledSpectrum* spectrum, double omega);

// What of each bin lies in [omega0, omega1], m^2, into variances[SW_MAX_SPECTRUM_BINS]. Returns how many bins there
// are.
int swGetCompiledBins(const swCompiledSpectrum* spectrum, double omega0, double omega1, double* variances);

// Means of cos and sin of the direction over a table's bin. False if there is no such bin or no energy in it.
bool swGetCompiledBinMean(const swCompiledSpectrum* spectrum, int bin, double* x, double* z);

// Factors that an equaliser has by wave number: on the waves' horizontal displacement, and on gravity for their speed.
// Energy is where the true dispersion puts it, so that neither changes heights. 1 for every other kind.
double swGetCompiledChop(const swCompiledSpectrum* spectrum, double k);
double swGetCompiledGravityScale(const swCompiledSpectrum* spectrum, double k);

// SW_ERROR_INVALID and a sentence in the log if a def is outside of its ranges.
swResult swCheckSpectrum(const swHost* host, const swSpectrumDef* def);

// Whether the measured tables of two checked defs hold the same, or neither has one. The rest is in swSpectrumFields.
bool swIsSameTable(const swSpectrumDef* a, const swSpectrumDef* b);

extern const swFields swSpectrumFields;
extern const swFields swOctavesFields;
extern const swFields swOctaveFields;
