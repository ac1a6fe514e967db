// SPDX-License-Identifier: MIT
#pragma once

// Inside of spectra: what the formulas, the tables and the sea state share. Not for other modules, which see only
// core/spectra/spectrum.h.

#include <stdbool.h>

#include "core/base/host.h"
#include "core/spectra/spectrum.h"
#include "core/spectra/spread_models.h"
#include "seaway/math.h"

#define SW_TURN (2.0 * SW_PI)

#define SW_MAX_TABLE_FREQUENCIES 1024

// What GetSeaState and the formulas' heights are worked out with.
#define SW_STANDARD_GRAVITY 9.81
#define SW_STANDARD_SURFACE_TENSION 7.4e-5

#define SW_MAX_BREAKS (SW_OCTAVE_COUNT + 4)

// [Elfouhaily 1997] by wave number.
typedef struct swElfouhaily
{
    double gravity;
    double peakNumber; // rad/m
    double peakSpeed;  // m/s
    double age;        // wind over the peak's phase speed
    double longLevel;  // alpha_p
    double shortLevel; // alpha_m
    double gammaLn;
    double sigma;
} swElfouhaily;

// The equaliser by frequency: ln S runs linearly over ln omega between edges, which descend as wavelengths grow.
typedef struct swOctaveShape
{
    double omega[SW_OCTAVE_COUNT + 1];
    double logOmega[SW_OCTAVE_COUNT + 1];
    double logDensity[SW_OCTAVE_COUNT + 1];
    bool isEnabled[SW_OCTAVE_COUNT];
    bool isLimited;
    double chop[SW_OCTAVE_COUNT];
    double gravityScale[SW_OCTAVE_COUNT];
    double wholeChop;
    double wholeGravityScale;
} swOctaveShape;

struct swCompiledSpectrum
{
    swSpectrumKind kind;
    swDispersion dispersion;
    double direction; // mean direction of a formula; what a table turns by

    // Formulas.
    double level;     // alpha g^2, or a factor on the density; rescaled to the significant height
    double peakOmega; // of the peak over deep water, or where the wind cuts the octaves off
    double gamma;
    swSpreadModel spreading;
    double breaks[SW_MAX_BREAKS]; // ascending: where the density or the directions jump or have a kink
    int breakCount;
    swElfouhaily elfouhaily;
    swOctaveShape octaves;

    // Tables; frequencies in Hz. See spectrum_table.c.
    swSpectrumTable table;
    double scale;     // from the table's density to calibrated density
    double lowEdge;   // of the first bin
    double highEdge;  // of the last bin, where the tail begins
    double tailLevel; // S(f) = tailLevel f^-5, calibrated; 0 without tail
    double edges[SW_MAX_TABLE_FREQUENCIES + 1];
    double energy[SW_MAX_TABLE_FREQUENCIES];         // mean over a bin, all directions, not yet scaled
    double edgeEnergy[SW_MAX_TABLE_FREQUENCIES + 1]; // at the edges, likewise

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

// Whether the def's windSpeed blows over its waves: it was said, or nothing but wind and fetch made them.
bool swHasSpectrumWind(const swSpectrumDef* def);

// Everything but copying: a table stays the caller's. False with a complaint if the def is wrong.
bool swPrepareSpectrum(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity, double surfaceTension,
                       swComplaint* complaint);

// What is integrated together over omega: S times 1 / omega, 1, omega, omega^2, k^2, and, of a formula, r1.
typedef struct swSpectrumMoments
{
    double minusOne, zero, one, two, slope, r1;
    bool isFull; // else k and r1, which cost more than all the rest, are not looked for and the last two stay 0
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

bool swPrepareFormula(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint);
double swGetFormulaDensity(const swCompiledSpectrum* spectrum, double omega);
void swIntegrateFormula(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments);

// Frequency in [omega0, omega1] with the largest density.
double swFindFormulaPeak(const swCompiledSpectrum* spectrum, double omega0, double omega1);

// What limits waves longer than a wind can make: exp(-5/4 (peakOmega / omega)^4).
double swGetWindLimit(double peakOmega, double omega);

// omega_p U / g of a growing sea by g F / U^2.
double swGetGrownOmega(swGrowthLaw law, double scaledFetch);

// The peak of the fully developed sea under a wind, rad/s.
double swGetDevelopedOmega(double gravity, double windSpeed);

// Kitaigorodskii's depth factor.
double swGetDepthFactor(double gravity, double depth, double omega);

// `age` in [0.84, 5], `drag` coefficient of the wind at 10 m. Density by k over all directions, m^3.
swElfouhaily swMakeElfouhaily(double gravity, double windSpeed, double age, double drag);
double swGetElfouhailyDensity(const swElfouhaily* shape, double k);

// Shortest wave of an octave, m; of SW_OCTAVE_COUNT the longest wave of all.
double swGetShortestOfOctave(int octave);

swOctaveShape swMakeOctaveShape(const swOctaves* octaves, const swDispersion* dispersion);
double swGetOctaveDensity(const swOctaveShape* shape, double omega); // before the wind's limit
int swFindOctave(double k);                                          // SW_OCTAVE_COUNT - 1 or 0 for waves outside

// ---- tables ----

bool swPrepareTable(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint);

// The bin in which a frequency lies; -1 below the first, the number of bins above the last.
int swFindTableBin(const swCompiledSpectrum* spectrum, double frequency);

// Density of a bin times its bandwidth over the bin's true width: densities of the table times this are the bin's
// means.
double swGetBinFactor(const swCompiledSpectrum* spectrum, int bin);

// Of one bin, all directions, a mean over its width: the integral over the circle of density times cos and sin. Not
// scaled.
void swGetBinVector(const swCompiledSpectrum* spectrum, int bin, double* x, double* z);

int swGetTailBins(const swSpectrumTable* table); // the last bins, which shape the tail
double swGetTableDensity(const swCompiledSpectrum* spectrum, double omega);
double swGetTableDensity2(const swCompiledSpectrum* spectrum, double omega, double theta);
void swIntegrateTable(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments);

// Part of a bin's energy that lies between two frequencies, in [0, 1].
double swGetBinPart(const swCompiledSpectrum* spectrum, int bin, double frequency0, double frequency1);
