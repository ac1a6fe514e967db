// SPDX-License-Identifier: MIT
#pragma once

// Measures the sea state of a world as an array of moored buoys would: heave and slopes of particles, recorded over
// time, to cross spectra, to energy and directional moments by frequency bin, to integral parameters.
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
    double begin;    // time of the first sample, s
} SeaGauges;

// A table's own bins.
void UseTableBins(const swSpectrumTable* table, SeaBins* bins);

// How long to record for a table's bins, s: the window of a record moves energy by about one over its length, so that
// it wants to be eight times as long as one over the width of the narrowest bin that holds much; at most an hour.
double FindTableDuration(const swSpectrumTable* table);

// `count` equal bins over [low, high] Hz.
void UseEqualBins(double low, double high, int count, SeaBins* bins);

// Bins of the width `width`, from some frequency on of the width `part` of their frequency, Hz.
void UseGrowingBins(double low, double high, double width, double part, SeaBins* bins);

// Record the world and add to sums[groupCount]: the gauges are dealt out to so many groups, each spread over the whole
// area, so that the groups' scatter tells the error (FindSeaError()). The world should hold no waves much above the
// last bin's frequency, see FindWavelength(): they would cost time. Steps the world; returns false if a step or memory
// failed.
bool RecordSea(swWorld* world, const SeaGauges* gauges, const SeaBins* bins, int groupCount, SeaSums* sums);

void AddSums(const SeaSums* from, SeaSums* to);

// Integral parameters of what was recorded. The peak is the bin of the largest density.
void FindSeaState(const SeaBins* bins, const SeaSums* sums, swSeaState* state);

// Standard errors of FindSeaState() of all groups together, by leaving out one group after another (the jackknife).
// Angles in radians, as in the state. Returns false without memory; with less than two groups all are NAN.
bool FindSeaError(const SeaBins* bins, int groupCount, const SeaSums* groups, swSeaState* error);

// The bin of the largest density.
int FindPeakBin(const SeaBins* bins, const SeaSums* sums);

// Density of a bin, m^2/Hz, and its circular moments: the means of cos, sin of theta and of 2 theta.
double FindDensity(const SeaBins* bins, const SeaSums* sums, int bin);
typedef struct SeaMoments
{
    double a1, b1, a2, b2;
} SeaMoments;
SeaMoments FindMoments(const SeaSums* sums, int bin);

// Variance between two frequencies, m^2; bins are shared out by overlap.
double FindVariance(const SeaBins* bins, const SeaSums* sums, double low, double high);

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
} SurfaceSums;

// Add `count` points over the area, of the world as its last step left it. Returns false without memory.
bool LookAtSurface(const swWorld* world, double area, int count, SurfaceSums* sums);

// Mean foam of a view's slices in the steady state, which the world steps into from its present time; NAN if it cannot.
double MeasureFoam(swWorld* world, double x, double z);
