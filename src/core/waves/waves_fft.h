// SPDX-License-Identifier: MIT
#pragma once

// From a spectrum to tiles: waves on each band's lattice, and their transform at a time. See core/frame/frame.h for
// what modes and tiles are.

#include "core/frame/frame.h"
#include "core/spectra/spectrum.h"
#include "core/waves/wind_level.h"

// A band has one tile, or up to three parallel ones. Tile i is of band i % SW_MAX_BANDS; the first SW_MAX_BANDS are
// there wherever a band has energy. No swell is shorter than the first band that may have more, of waves from 1 m up.
#define SW_BAND_TILES 3
#define SW_FIRST_PARALLEL_BAND 4
#define SW_SET_TILES (SW_BAND_TILES * SW_MAX_BANDS)

// The waves of one tile. `modes` is NULL if there are none.
typedef struct swBandModes
{
    int band;
    int maxBin;
    double side;
    int64_t loopTicks; // for swTile
    float minWavelength, maxWavelength;
    float variance, slopeVarianceX, slopeVarianceZ; // at weight 1
    swStrain strain;
    float wind[SW_WIND_STEPS]; // of the band, in its first tile; see wind_level.h
    float knownWind;           // m/s, of the whole sea, in each of its first tiles; 0 where the waves tell it
    float depth;               // m, of the dispersion
    float
        breadth; // the number of waves that would share the energy evenly, (sum E)^2 / sum E^2, over all of the octave
    int modeCount;
    swMode* modes;
} swBandModes;

// Fill bands[SW_SET_TILES] for a system, at weight 1. Frees nothing on failure that it did not allocate.
swResult swBuildModes(const swHost* host, const swWaveSystemDef* def, float gravity, float surfaceTension,
                      swBandModes* bands);
void swFreeModes(const swHost* host, swBandModes* bands);

// What a cubic B-spline over N samples leaves of bin q along an axis: sinc^4(q / N) for q = 0 .. N / 4.
void swFillSplineResponse(int resolution, float* response);

// The free waves of a system with method SW_WAVES_GERSTNER, at weight 1, longest first; `waves` needs
// swFree(host, *waves, *waveCount * sizeof(swFreeWave)). Of the bands only `wind` is filled.
swResult swBuildFreeWaves(const swHost* host, const swWaveSystemDef* def, float gravity, float surfaceTension,
                          swFreeWave** waves, int* waveCount, swBandModes* bands);

// Turns per tick as Q0.64, and whole turns a loop if there is one (0 ticks: none).
uint64_t swGetTurnsPerTick(double omega, int64_t loopTicks);
int64_t swGetLoopTicks(const swWaveSystemDef* def);

// omega of a wave as it runs: that of the dispersion, with an equaliser's factor on gravity.
double swGetWaveOmega(const swCompiledSpectrum* spectrum, double k);

// Sideways displacement of a wave relative to its height: chop, times coth(k depth), which makes the particles' orbits
// the ellipses of shallow water.
double swGetOrbitRatio(const swCompiledSpectrum* spectrum, const swWaveSystemDef* def, double k);

// The side of tile i, m: tileWaves * shortest wavelength * a factor that is different for each tile, in (0.85, 1] of a
// band's first and in (0.6, 0.85) of those parallel to it.
double swGetTileSide(int tile, int tileWaves);

// The kernels of one instruction set. NULL if this machine or build lacks it; SW_ISA_BEST never returns NULL.
typedef struct swWaveKernels swWaveKernels;
const swWaveKernels* swGetWaveKernels(swIsa isa);
swIsa swGetWaveKernelsIsa(const swWaveKernels* kernels);

// Scratch bytes that one worker needs for tiles of that resolution, 64-byte aligned.
size_t swGetTileScratchSize(int resolution);

// Transform one tile, or two of the same resolution at once (b may be NULL; two are cheaper than one and one), at
// `ticks` into texels ((N + 3)^2 * 4 floats each, 64-byte aligned), times the tile's weight. A tile's bits depend on
// its partner, so the world pairs the tiles of a system in a fixed order. `derivative` 1 and 2 make the first and
// second derivative by time instead: velocity and acceleration.
void swTransformTiles(const swWaveKernels* kernels, const swTile* a, float* texelsA, const swTile* b, float* texelsB,
                      int64_t ticks, int derivative, void* scratch);

// Instead of a derivative: no field of a time, but the inverse transform of each wave's power, which is the correlation
// of the tile's heights by the way between two places, as the vertical component.
#define SW_LIKENESS 3

// Of the powers, with the spline's response taken out: half the value of the texels' spline at no way, at weight 1.
double swSumTilePowers(const swTile* tile);

// Which tiles of a list count, and which of their texels. Tiles count whose longest wave is in (shortest, longest],
// where 0 is no bound.
typedef struct swTileChoice
{
    int count;
    const swTile* tiles;
    float shortest, longest; // m
    int field;               // 0: displacement, 1: velocity, 2: acceleration
} swTileChoice;

static inline bool swIsTileChosen(const swTile* tile, float shortest, float longest)
{
    return (shortest <= 0.0f || tile->maxWavelength > shortest) && (longest <= 0.0f || tile->maxWavelength <= longest);
}

// As swSampleTiles() below, of some tiles of a list.
void swSampleChosenTiles(const swWaveKernels* kernels, const swTileChoice* choice, int count, const swPosXZ* points,
                         float* out, float* gradients);

// What tiles add up to at a point. Even and odd columns of their texels stay apart until the end.
typedef struct swPointSums
{
    float value[8];
    float alongX[8], alongZ[8];
} swPointSums;

// How much of a tile counts at each of some points, for a look-up elsewhere than where they rest.
typedef struct swTileShape
{
    const float* weight;
    const float *alongX, *alongZ; // of the weight
    const float (*way)[4];        // gradients of place - rest: of its x along x and z, then of its z; NULL: none
} swTileShape;

// Add one tile to the sums of at most SW_SUM_BLOCK points, and make of sums what swSampleTiles() answers: the same
// bits, for callers that do something to a tile's part on the way. With a shape gradients are by where points rest.
#define SW_SUM_BLOCK 64
void swAddTile(const swWaveKernels* kernels, const swTile* tile, int field, int count, const swPosXZ* points,
               const swTileShape* shape, bool withSlopes, swPointSums* sums);
void swStorePointSums(const swWaveKernels* kernels, int count, const swPointSums* sums, float* out, float* gradients);

// Evaluate the spline sum of tiles at `count` rest points (double, metres), out[count][4] = x, y, z displacement, 0;
// gradients (may be NULL) [count][8] = dDx/dx, dDx/dz, dDz/dx, dDz/dz, dh/dx, dh/dz, 0, 0.
// Order of summation: tiles in the order given, then within a tile as in shaders/shared/spline.h.
void swSampleTiles(const swWaveKernels* kernels, int tileCount, const swTile* tiles, int count, const swPosXZ* points,
                   float* out, float* gradients);

// The same bits for a row of points with one z, whose x ascend: what slices and height maps are made of, in a third of
// the time. `gradients` may be NULL.
void swSampleRow(const swWaveKernels* kernels, const swTileChoice* choice, int count, const double* x, double z,
                 float* out, float (*gradients)[8]);

// swFindDepthShare() of `count` depths in water that is not dry. All arrays have room for a multiple of
// SW_SHARE_LANES, and all of that many depths are numbers.
#define SW_SHARE_LANES 8
void swFindDepthShares(const swWaveKernels* kernels, swAttenuation law, float k, int count, const float* depths,
                       float* shares, float* slopes);
