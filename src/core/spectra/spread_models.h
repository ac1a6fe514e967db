// SPDX-License-Identifier: MIT
#pragma once

// How wind seas spread about their mean direction, by frequency. Everything here integrates to one over the circle.

#include "core/spectra/dispersion.h"
#include "seaway/spectrum.h"

#define SW_SPREAD_NODES 97

// What a def says of directions, looked up once.
typedef struct swSpreadModel
{
    swSpreadingKind kind;
    double exponent;   // COSINE_2S
    double turbulence; // part that goes everywhere
    double swell;
    double peakOmega;
    double windRatio;                  // wind over the phase speed of the peak: how young the sea is
    double friction;                   // ELFOUHAILY: friction velocity, m/s
    swDispersion deep;                 // ELFOUHAILY: of deep water
    bool hasScales;                    // swTabulateSpreadScales() was called
    double scales[3][SW_SPREAD_NODES]; // DONELAN_BANNER with swell: normalisers below, at and above the peak
} swSpreadModel;

// The distribution at one frequency, about the mean direction:
//   D(a) = turbulence / 2 pi + (1 - turbulence) scale cos^2s(a / 2) sech^2(beta a) (1 + delta cos 2 a).
typedef struct swSpread
{
    double turbulence;
    double scale;
    double exponent; // s; 0 for none
    double beta;     // 0 for none
    double delta;    // 0 for none
} swSpread;

swSpreadModel swMakeSpreadModel(const swSpectrumDef* def, double gravity, double surfaceTension, double peakOmega);

// Where the model needs numerical normalisers, have them at hand. swFindSpread() works without, but is slower.
void swTabulateSpreadScales(swSpreadModel* model);

// Frequencies at which the model jumps, as multiples of the peak's. Returns how many, at most 2.
int swGetSpreadJumps(const swSpreadModel* model, double* ratios);

swSpread swFindSpread(const swSpreadModel* model, double omega);

// D at `angle` from the mean direction, in any turn of the circle.
double swGetSpread(const swSpread* spread, double angle);

// The first two circular moments about the mean direction: integrals of D cos a and D cos 2a.
void swGetSpreadMoments(const swSpread* spread, double* r1, double* r2);

// Drag coefficient of the wind at 10 m [Wu 1982], and Delta of ECKV's spreading.
double swGetDragCoefficient(double windSpeed);
double swGetElfouhailyDelta(double phaseSpeed, double peakSpeed, double friction);
