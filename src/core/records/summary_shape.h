// SPDX-License-Identifier: MIT
#pragma once

// Shapes of spectra that have a height, a peak and an average period.

#include <stdbool.h>

#define SW_SHAPE_FREQUENCIES 64

// How far shapes go: the least have the most energy in short waves, 0 is the usual one, 1 the narrowest, beyond it
// longer waves stand beside the peak.
#define SW_SHAPE_LEAST (-2.0)
#define SW_SHAPE_MOST 2.0

// One system of waves.
typedef struct swShape
{
    double height; // significant, m
    double peak;   // Hz
    double usualGamma;

    // Chosen: the enhancement of the peak, the exponent of the tail, and how high longer waves stand beside the peak.
    double gamma, tail, shelf;

    double energy[SW_SHAPE_FREQUENCIES]; // m^2/Hz

    // By frequency: what does not depend on what is chosen.
    double logarithm[SW_SHAPE_FREQUENCIES];
    double cut[SW_SHAPE_FREQUENCIES];
    double bump[SW_SHAPE_FREQUENCIES];
    double plateau[SW_SHAPE_FREQUENCIES];
} swShape;

// After height, peak, usual gamma or frequencies have changed.
void swPrepareShape(swShape* shape, const float* frequencies);

// Energies of systems, all with the same part of the way from the usual shape.
void swFillShapes(swShape* shapes, int count, double way, const float* widths);

// Tm02 = sqrt(m0 / m2) of the sum of systems, over bins.
double swGetAveragePeriod(const swShape* shapes, int count, const float* frequencies, const float* widths);

// The way, at most `most`, whose sum has an average period, or comes nearest. Fills the energies and returns the
// period.
double swFitShapes(swShape* shapes, int count, double period, double most, const float* frequencies,
                   const float* widths);
