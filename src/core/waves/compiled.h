// SPDX-License-Identifier: MIT
#pragma once

// Inside of spectra: what the formulas, the tables and the sea state share. Not for other modules, which see only
// core/waves/spectrum.h.

#include <stdbool.h>

#include "core/base/host.h"
#include "core/waves/spectrum.h"
#include "seaway/math.h"

#define SW_TURN (2.0 * SW_PI)

// Set by swDefaultSpectrumDef().
#define SW_SPECTRUM_COOKIE 0x5350

#define SW_MAX_TABLE_FREQUENCIES 1024

// What GetSeaState and the formulas' heights are worked out with.
#define SW_STANDARD_GRAVITY 9.81
#define SW_STANDARD_SURFACE_TENSION 7.4e-5

struct swCompiledSpectrum
{
    swSpectrumKind kind;
    swDispersion dispersion;
    double direction; // mean direction of a formula; what a table turns by

    // Formulas.
    double level; // alpha g^2, rescaled to the significant height
    double peakOmega;
    double gamma;
    double spreadExponent;
    double spreadScale;

    // Tables; frequencies in Hz.
    swSpectrumTable table;
    double scale;                            // from the table's density to calibrated density
    double binScale;                         // the same where bins are summed by their widths instead of integrated
    double lowEdge;                          // of the first bin
    double highEdge;                         // of the last bin, where the tail begins
    double tailLevel;                        // S(f) = tailLevel f^-5, calibrated; 0 without tail
    double energy[SW_MAX_TABLE_FREQUENCIES]; // of each bin, all directions, not yet scaled

    // Owned copy of the table, if any.
    void* memory;
    size_t memorySize;
};

// What is wrong with a def, as a sentence.
typedef struct swComplaint
{
    char text[256];
} swComplaint;

SW_PRINTF(2, 3) bool swComplain(swComplaint* complaint, const char* format, ...); // returns false
bool swCheckSpectrumDef(swComplaint* complaint, const swSpectrumDef* def);

// Everything but copying: a table stays the caller's. False with a complaint if the def is wrong.
bool swPrepareSpectrum(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity, double surfaceTension,
                       swComplaint* complaint);

// What is integrated together over omega: S times 1 / omega, 1, omega, omega^2, and k^2.
typedef struct swSpectrumMoments
{
    double minusOne, zero, one, two, slope;
    bool wantsSlope; // else k, which costs more than all the rest, is not looked for and `slope` stays 0
} swSpectrumMoments;

void swAddSpectrumMoments(swSpectrumMoments* moments, const swCompiledSpectrum* spectrum, double omega,
                          double variance);

// S(omega) of a compiled spectrum, m^2 s.
typedef double (*swSpectrumDensityFcn)(const swCompiledSpectrum* spectrum, double omega);

// Gauss-Legendre of order 8 over one panel, on which the density must be smooth.
void swAddSpectrumPanel(swSpectrumMoments* moments, swSpectrumDensityFcn density, const swCompiledSpectrum* spectrum,
                        double omega0, double omega1);

void swIntegrateMoments(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments);

// ---- formulas ----

void swPrepareFormula(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity);
double swGetFormulaDensity(const swCompiledSpectrum* spectrum, double omega);
void swIntegrateFormula(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments);

// ---- tables ----

// A frequency between the centres of bins `index` and `index` + 1, a fraction of the way. Outside: the nearest centre.
typedef struct swTablePlace
{
    int index;
    double fraction;
} swTablePlace;

bool swPrepareTable(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint);
swTablePlace swFindTablePlace(const swSpectrumTable* table, double frequency);
int swGetTailBins(const swSpectrumTable* table); // the last bins, which shape the tail
double swGetTableDensity(const swCompiledSpectrum* spectrum, double omega);
double swGetTableSpreading(const swCompiledSpectrum* spectrum, double frequency, double theta);
void swIntegrateTable(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments);
