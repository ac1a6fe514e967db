// SPDX-License-Identifier: MIT
#pragma once

// Measures the sea state of a world as an array of moored buoys would: heave and slopes of particles, recorded over time,
// to cross spectra, to energy and directional moments by frequency bin, to integral parameters.
// Shared by `seaway stats` and the truth tests.

#include <stdbool.h>

#include "seaway/seaway.h"

#define SEA_MAX_BINS 1024

// Frequency bins, Hz.
typedef struct SeaBins
{
    int count;
    double low[SEA_MAX_BINS], high[SEA_MAX_BINS], center[SEA_MAX_BINS];
} SeaBins;

// Variances and covariances of heave h and slopes in x and z, by bin; the quadrature parts for hx and hz.
// Sums over seas add up: only ratios and `weight` matter.
typedef struct SeaSums
{
    double weight; // number of records summed
    double h[SEA_MAX_BINS];
    double hx[SEA_MAX_BINS], hz[SEA_MAX_BINS];
    double xx[SEA_MAX_BINS], zz[SEA_MAX_BINS], xz[SEA_MAX_BINS];
} SeaSums;

// Where and how long to record.
typedef struct SeaGauges
{
    double area;     // side of the square that holds the gauges, m
    int gaugeCount;  // spread evenly over it
    double duration; // at least, s
} SeaGauges;

// A table's own bins.
void UseTableBins(const swSpectrumTable* table, SeaBins* bins);

// `count` equal bins over [low, high] Hz.
void UseEqualBins(double low, double high, int count, SeaBins* bins);

// Record the world from time 0 on and add to `sums`. The world should hold no waves much above the last bin's frequency,
// see FindWavelength(): they would cost time. Steps the world; returns false if a step or memory failed.
bool RecordSea(swWorld* world, const SeaGauges* gauges, const SeaBins* bins, SeaSums* sums);

void AddSums(const SeaSums* from, SeaSums* to);

// Integral parameters of what was recorded. The peak is the bin of the largest density.
void FindSeaState(const SeaBins* bins, const SeaSums* sums, swSeaState* state);

// The bin of the largest density.
int FindPeakBin(const SeaBins* bins, const SeaSums* sums);

// Length of a wave of `frequency` Hz over `depth` m (infinity is allowed), and back. With the surface tension of water.
double FindWavelength(double frequency, double depth, double gravity);
double FindFrequency(double wavelength, double depth, double gravity);

// What a still picture of the surface tells, without time.
typedef struct SurfaceSums
{
    double count;
    double height, heightSquare; // of the surface above points (Eulerian), from sea level
    double slopeSquare;          // of its normal
    double particleSlopeSquare;  // per rest metre, what the spectrum means
    double whitecaps;            // points where the fold is below the world's foam threshold
} SurfaceSums;

// Add `count` points over the area, of the world as its last step left it. Returns false without memory.
bool LookAtSurface(const swWorld* world, double area, int count, float foamThreshold, SurfaceSums* sums);
