// SPDX-License-Identifier: MIT
#pragma once

#include "measured.h"
#include "query.h"
#include "sea.h"
#include "view.h"
#include "world.h"

/// @file
/// What a sea is: sea states and spectra estimated from its surface, as buoys and cameras would measure them. For
/// checking a world against what it was asked for. A library of its own, `measure`, that needs the core only.
///
/// A sum belongs to the bins that it was recorded with; sums of several seas are added up before anything is estimated.
/// Functions that take a swWorld* step it and want it to themselves.

/// Most frequency bins.
#define SW_MAX_SEA_BINS 1024

/// Frequency bins, Hz, ascending: bin i reaches from low[i] to high[i], and center[i] stands for it in periods.
typedef struct swSeaBins
{
    /// Range [1, SW_MAX_SEA_BINS].
    int count;
    double low[SW_MAX_SEA_BINS], high[SW_MAX_SEA_BINS], center[SW_MAX_SEA_BINS];
} swSeaBins;

/// Bins of a table, at most SW_MAX_SEA_BINS of them, with the edges of swSpectrumTable_GetEdges().
SW_API void swMakeTableBins(const swSpectrumTable* table, swSeaBins* bins);

/// Longest record that swGetTableDuration() asks for, s.
#define SW_LONGEST_TABLE_RECORD 3600.0

/// How long to record for a table's bins, s. The window of a record moves energy by about one over its length, so it
/// wants to be eight times as long as one over the width of the narrowest bin that holds much.
SW_API double swGetTableDuration(const swSpectrumTable* table);

/// `count` bins of equal width over [low, high] Hz; at most SW_MAX_SEA_BINS.
SW_API void swMakeEqualBins(double low, double high, int count, swSeaBins* bins);

/// Bins of the width `width` Hz and, from some frequency on, of the share `part` of their frequency.
SW_API void swMakeGrowingBins(double low, double high, double width, double part, swSeaBins* bins);

/// Frequency of a wave over `depth` m (INFINITY: deep water), Hz, and its length, m. With the surface tension of water.
/// NaN of a wavelength, depth or gravity that is not above 0, and of a frequency below 0. Lengths lie within 1e-4 and
/// 1e7 m: lower frequencies have the longest.
/// @param gravity m/s^2
SW_API double swGetWaveFrequency(double wavelength, double depth, double gravity);
SW_API double swGetWavelength(double frequency, double depth, double gravity);

/// Gauges that follow particles of the water, spread evenly over a square around the origin, and how long they record.
typedef struct swSeaGauges
{
    /// Side of the square, m. Range (0, SW_FARTHEST_POINT].
    double area;

    /// Number of gauges, at least 1.
    int gaugeCount;

    /// Shortest length of a record, s, above 0. It becomes a power of two of samples.
    double duration;

    /// Time of the first sample, s, within SW_LARGEST_TIME of 0.
    double begin;
} swSeaGauges;

/// Variances and covariances by bin, summed over records: of heave h, and of the slopes x and z; the quadrature parts
/// for hx and hz. All zero before the first record.
typedef struct swSeaSums
{
    /// Number of records summed.
    double weight;
    double h[SW_MAX_SEA_BINS];
    double hx[SW_MAX_SEA_BINS], hz[SW_MAX_SEA_BINS];
    double xx[SW_MAX_SEA_BINS], zz[SW_MAX_SEA_BINS], xz[SW_MAX_SEA_BINS];
} swSeaSums;

/// Record heave and slopes of particles and add their cross spectra to sums[groupCount]. The gauges are dealt out to
/// the groups, each spread over the whole area, so that the groups' scatter tells the error (swEstimateSeaError()).
/// Heave and slopes of particles are linear in the waves' amplitudes, so the estimate has no harmonics however steep
/// the sea. Steps the world. Waves far above the last bin's frequency cost time: leave them out (swGetWavelength()).
/// [Welch 1967] [Longuet-Higgins 1963]
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT for records of too many samples, or what a step returns
SW_API swResult swRecordSea(swWorld* world, const swSeaGauges* gauges, const swSeaBins* bins, int groupCount,
                            swSeaSums* sums);

SW_API void swAddSeaSums(const swSeaSums* from, swSeaSums* to);

/// Integral parameters of what was recorded. The peak is the bin of the largest density. All zero without energy.
SW_API void swEstimateSeaState(const swSeaBins* bins, const swSeaSums* sums, swSeaState* state);

/// Standard errors of swEstimateSeaState() of all groups together, by leaving out one group after another (the
/// jackknife). Angles in radians, as in the state. With fewer than two groups all are NaN.
/// @return SW_ERROR_NO_MEMORY
SW_API swResult swEstimateSeaError(const swHost* host, const swSeaBins* bins, int groupCount, const swSeaSums* groups,
                                   swSeaState* error);

/// The bin of the largest density.
SW_API int swFindPeakBin(const swSeaBins* bins, const swSeaSums* sums);

/// Density of a bin, m^2/Hz.
SW_API double swEstimateDensity(const swSeaBins* bins, const swSeaSums* sums, int bin);

/// Circular moments of the directions where waves go: means of cos theta, sin theta, cos 2 theta and sin 2 theta.
typedef struct swDirectionMoments
{
    double a1, b1, a2, b2;
} swDirectionMoments;

/// Of one bin; zero without energy.
SW_API swDirectionMoments swEstimateMoments(const swSeaSums* sums, int bin);

/// Variance between two frequencies, m^2; bins are shared out by overlap. NaN if one of them is.
SW_API double swEstimateVariance(const swSeaBins* bins, const swSeaSums* sums, double low, double high);

/// What a still picture of the surface tells, summed over points.
typedef struct swSurfaceSums
{
    double count;
    /// Of the surface above points (Eulerian), m and m^2 from sea level.
    double height, heightSquare;
    /// Of the surface's normal.
    double slopeSquare;
    /// Per metre of the resting water: what a spectrum means by slope.
    double particleSlopeSquare;
} swSurfaceSums;

/// Add `count` points spread evenly over a square of side `area` m around the origin, of the world as its last step
/// left it. `sums` is all zero at first.
SW_API swResult swLookAtSurface(const swWorld* world, double area, int count, swSurfaceSums* sums);

/// Mean foam of a view's slices around (x, z) in the steady state, which the world steps into from its present time;
/// NaN if it cannot.
SW_API double swMeasureFoam(swWorld* world, double x, double z);

/// Samples along a square of swSeaPatches.
#define SW_PATCH_SIDE 128

/// Directional spectra from squares of the surface, octave of wavelength by octave, as a camera over the sea would see
/// them. Gauges tell four moments of directions; this tells their distribution.
typedef struct swSeaPatches swSeaPatches;

/// Empty patches for the octaves that hold waves between two lengths, m, the shorter one first.
/// @return SW_ERROR_NO_MEMORY
SW_API swResult swCreateSeaPatches(const swHost* host, double shortest, double longest, swSeaPatches** patches);
SW_API void swDestroySeaPatches(swSeaPatches* patches);

/// Add squares of every octave, around a place of their own for each `index`. Steps the world from `begin` s on.
/// @param depth of the waves, m, which tells how long their periods are; INFINITY: deep water
/// @return SW_ERROR_NO_MEMORY, or what a step returns
SW_API swResult swLookAtPatches(swWorld* world, double begin, double depth, int index, swSeaPatches* patches);

/// Both of the same wavelengths.
SW_API void swAddSeaPatches(const swSeaPatches* from, swSeaPatches* to);

/// S(f, theta), m^2/Hz/rad, of waves that go to theta; 0 outside the octaves, NaN for what cannot be answered.
SW_API double swEstimatePatchDensity(const swSeaPatches* patches, double frequency, double theta, double depth,
                                     double gravity);
