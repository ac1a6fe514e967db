// SPDX-License-Identifier: MIT
#pragma once

// What a step leaves for its readers: queries, layers and the GPU. Everything below world/ and the whole gpu half see
// the world only through this. Plain data; the world owns all memory; pointers are valid until the next step.
//
// A tile holds uniform cubic B-spline coefficients of one band: displacement (x, y, z) at wrapped sample (i, j) is
// texels[(j * pitch + i) * 4 + {0, 1, 2}], element 3 is 0, with pitch = resolution + 3: columns and rows resolution ..
// resolution + 2 repeat 0 .. 2, so that a 4x4 window never wraps. i runs along x, j along z. A point u of the rest
// plane has spline coordinate s = frac(u / side) * resolution; its window starts at floor(s) - 1, so the window of s in
// [0, resolution) would start at -1: therefore texel (i, j) stores sample (i - 1, j - 1) mod resolution and the window
// starts at column floor(s). The surface is the spline, not the coefficients: f(s) = sum B3(s - n) c_n.

#include <math.h>

#include <string.h>

#include "seaway/view.h"
#include "seaway/waves.h"
#include "core/base/seam.h"
#include "core/frame/input_set.h"
#include "core/frame/layers.h"
#include "shared/depth_share.h"
#include "shared/foam.h"

// One pair of opposite waves k and -k of a band, on the half plane (qz > 0, or qz == 0 and qx > 0) of integer bins.
// Height spectrum at time t, with theta = phase turns * 2 pi:
//   H(k) = (pr cos + qi sin) + i (pi cos - qr sin),  H(-k) = conj(H(k)),
// where p = (a(k) + conj a(-k)) / 2, q = (a(k) - conj a(-k)) / 2, and a is divided by the spline's response.
// Horizontal spectra: i chop k_x / |k| H and i chop k_z / |k| H.
// Phase in turns, exactly the same on every machine: the top 32 bits of the low 64 bits of frequency * ticks, with
// frequency in turns per tick as unsigned Q0.64 and ticks = round(time * SW_TICKS_PER_SECOND) as two's complement; of a
// tile that loops, what swGetTileTicks() leaves of them.
typedef struct swMode
{
    int16_t qx, qz;
    float dx, dz; // chop k / |k|
    float pr, pi, qr, qi;
    uint32_t frequencyLow, frequencyHigh;
} swMode;

// How waves strain the surface sideways: sums over waves of half (chop k amplitude)^2 times powers of the cosine c and
// sine s of their direction. cccc is the variance of dDx/dx, ssss that of dDz/dz, ccss their covariance and the
// variance of dDx/dz; cccs and csss are what the others need when axes turn.
typedef struct swStrain
{
    float cccc, cccs, ccss, csss, ssss;
} swStrain;

#define SW_TICKS_PER_SECOND 16777216.0      // 2^24
#define SW_LARGEST_TICKS ((int64_t)1 << 62) // more than those of SW_LARGEST_TIME

// Ticks from one time to another. Two legal times may lie almost 2^63 ticks apart.
static inline int64_t swGetTicksBetween(int64_t from, int64_t to)
{
    bool isTooLong = from < 0 && to > INT64_MAX + from;
    return isTooLong ? INT64_MAX : to - from;
}

// How far a current has carried waves: the path of a velocity that runs evenly from one to another. A wave of h(x, t)
// in still water is h(x - path(t), t) in the current, so that its frequency becomes omega + k . U, with no float that
// grows. Before the change the velocity is the first.
typedef struct swDrift
{
    int64_t begin, length;        // of the change, in ticks
    double x, z;                  // of the path at its beginning, m
    float fromX, fromZ, toX, toZ; // m/s
} swDrift;

static inline bool swIsDriftStill(const swDrift* drift)
{
    return drift->x == 0.0 && drift->z == 0.0 && drift->fromX == 0.0f && drift->fromZ == 0.0f && drift->toX == 0.0f &&
           drift->toZ == 0.0f;
}

static inline double swFollowDrift(double from, double to, double passed, double length)
{
    double during = passed < 0.0 ? 0.0 : passed < length ? passed : length;
    double bend = length > 0.0 ? 0.5 * (to - from) * during * during / length : 0.0;
    return from * (passed < 0.0 ? passed : during) + bend + to * (passed - during > 0.0 ? passed - during : 0.0);
}

// The velocity at a time, m/s.
static inline swVec2 swFindDriftVelocity(const swDrift* drift, int64_t ticks)
{
    double passed = (double)ticks - (double)drift->begin;
    double share = drift->length > 0 ? passed / (double)drift->length : passed < 0.0 ? 0.0 : 1.0;
    float done = share < 0.0 ? 0.0f : share < 1.0 ? (float)share : 1.0f;
    return (swVec2){drift->fromX + (drift->toX - drift->fromX) * done,
                    drift->fromZ + (drift->toZ - drift->fromZ) * done};
}

// The path at a time, m.
static inline swPosXZ swFindDrift(const swDrift* drift, int64_t ticks)
{
    swPosXZ path = {0.0, 0.0};
    if (!swIsDriftStill(drift))
    {
        double passed = ((double)ticks - (double)drift->begin) / SW_TICKS_PER_SECOND;
        double length = (double)drift->length / SW_TICKS_PER_SECOND;
        path.x = drift->x + swFollowDrift((double)drift->fromX, (double)drift->toX, passed, length);
        path.z = drift->z + swFollowDrift((double)drift->fromZ, (double)drift->toZ, passed, length);
    }
    return path;
}

// A flow that is the same everywhere and swings with the tides carries all waves by its path, as a drift does:
// velocity + sum of cosine cos(speed t) + sine sin(speed t), integrated in a closed form from the tick `begin` on, so
// that the path does not depend on steps. See core/input/even_flow.h.
#define SW_MAX_EVEN_SWINGS 48

typedef struct swEvenSwing
{
    double speed; // rad/s, above 0
    float cosineX, cosineZ, sineX, sineZ;
} swEvenSwing;

typedef struct swEvenFlow
{
    int64_t begin; // in ticks
    double x, z;   // of the path then, m
    float velocityX, velocityZ;
    int swingCount;
    swEvenSwing swings[SW_MAX_EVEN_SWINGS];
    int64_t ticks; // of the step, for which the path is known
    swPosXZ path;
} swEvenFlow;

static inline bool swIsEvenFlowStill(const swEvenFlow* flow)
{
    return flow->x == 0.0 && flow->z == 0.0 && flow->velocityX == 0.0f && flow->velocityZ == 0.0f &&
           flow->swingCount == 0;
}

SW_SEAM_BEGIN

// The path of a flow at a time, m.
swPosXZ swIntegrateEvenFlow(const swEvenFlow* flow, int64_t ticks);

SW_SEAM_END

// The same, by what is known; 0 with no flow.
static inline swPosXZ swFindEvenPath(const swEvenFlow* flow, int64_t ticks)
{
    if (flow == NULL || swIsEvenFlowStill(flow))
    {
        return (swPosXZ){0.0, 0.0};
    }
    return ticks == flow->ticks ? flow->path : swIntegrateEvenFlow(flow, ticks);
}

typedef struct swTile
{
    int system;        // index of the wave system, of several that share the tile the first
    int band;          // octave, see SW_MAX_BANDS
    int resolution;    // N
    int maxBin;        // largest |qx| or |qz| of a mode, at most N / 4
    double side;       // m
    int64_t loopTicks; // the waves repeat exactly after so many ticks; 0: never
    float minWavelength, maxWavelength;
    float weight;                         // the system's weight; already in the texels
    float variance;                       // of height, m^2, with weight
    float slopeVarianceX, slopeVarianceZ; // E[(dh/dx)^2], E[(dh/dz)^2], with weight
    swStrain strain;                      // with weight
    float depth;                          // m, of the waves' dispersion
    swDrift drift;
    const swEvenFlow* evenFlow; // which carries it as well, or NULL
    double shiftX, shiftZ;      // the path of both at the time of the texels, m, in [0, side)
    swAttenuation attenuation;  // over a floor
    int modeCount;
    const swMode* modes;      // ordered by qz, then qx
    uint32_t spectrumVersion; // changes when modes do
    const float* response;    // [N / 4 + 1]: what the spline leaves of bin |q| along an axis; modes are divided by it
    const float* texels;      // [N + 3][N + 3][4], NULL without CPU queries
    const float* velocity;    // the same for the rates of displacement, NULL unless the world has them
    const float* acceleration;
    // How alike the heights are a way apart: their correlation as component y, 1 at no way. Of a spectrum, not a time.
    // NULL where no flow that varies carries waves.
    const float* likeness;
} swTile;

// A wave that is no part of a tile: evaluated where it is asked for, with its exact wave vector. With
// theta = 2 pi (turnsX x + turnsZ z - frequency ticks + phase): height a cos theta, sideways -(dx, dz) a sin theta.
typedef struct swFreeWave
{
    double turnsX, turnsZ; // wave vector over 2 pi, turns per metre
    uint64_t frequency;    // turns per tick, as swMode has it
    int64_t loopTicks;     // as swTile has it
    uint32_t phase;        // at the origin at tick 0, a fraction of 2^32
    float amplitude;       // m, with weight
    float dx, dz;          // chop k / |k|
    float wavelength;      // m
    float depth;           // m
    swAttenuation attenuation;
    int system;
    swDrift drift;
    const swEvenFlow* evenFlow; // which carries it as well, or NULL
} swFreeWave;

// One slice of a view, snapped. See swSliceInfo.
typedef struct swSlice
{
    double texel;
    int64_t firstX, firstZ;
    int level;           // log2 of texel over the view's finestTexel: slice index plus scale level
    float minWavelength; // tiles with minWavelength >= this are in the slice
} swSlice;

// How one slice grows foam: what the foam layer's parameters hold. Folds are looked up in slice `fold.slice`, the slice
// itself or a coarser one that leaves out short waves.
typedef struct swFoamBirth
{
    swPastSource fold;
    swFoamRest rest; // waves that are not known
    float growth;    // per second and unit of fold
} swFoamBirth;

// Room for what a layer's maker tells both halves of a slice.
#define SW_LAYER_PARAM_WORDS 16
static_assert(sizeof(swFoamBirth) <= SW_LAYER_PARAM_WORDS * sizeof(uint32_t), "foam's parameters of a slice");

// One layer in this frame.
typedef struct swLayerFrame
{
    int steps;    // to take now, 0 .. mostSteps
    float stepDt; // s
    int64_t due;  // steps of the layer's rate that passed
    bool isReset; // first step, or a jump in time: nothing has a past
    // Of a layer on demand, set by its swPlan function: there is something in it. It has no texels otherwise, and is
    // the same everywhere, see swLayerInfo::rest. Before, what it was in the step before.
    bool isAuthored;
    bool isBegun; // of one with a past: it was held in the step before
    // Set by its swPlan function: water carries it. Steps are then taken one by one, also of an exact layer.
    bool isCarried;
    // For a reader that did not see every step: since it last looked, clock - then steps have passed, and there was a
    // reset if resetCount differs. It keeps the slices that it last saw, see core/lod/scroll.h.
    int64_t clock;
    uint32_t resetCount;
    uint32_t params[SW_MAX_SLICES][SW_LAYER_PARAM_WORDS]; // of each slice, written by the layer's swPlan function
    const float* texels; // [slice][R][R][channels], NULL where the core does not make the layer, or nothing is authored
} swLayerFrame;

// A stack of slices in this frame, of a view or of a zone, and its layers.
typedef struct swStackFrame
{
    int sliceCount;
    int resolution;
    swSlice slices[SW_MAX_SLICES];
    swSlice previousSlices[SW_MAX_SLICES];                // of the step before
    swPastSource sources[SW_MAX_SLICES][SW_PAST_SOURCES]; // from previousSlices to slices
    swLayerFrame layers[SW_LAYERS];
} swStackFrame;

typedef struct swViewFrame
{
    const swView* view;   // identity only
    uint32_t viewVersion; // unique per created view; never reused
    swPos viewpoint;
    float fade; // of the finest slice into the next as the stack is about to double; also shows the last slice
    int scaleLevel;
    swStackFrame stack;
} swViewFrame;

#define SW_MAX_ZONES 8

typedef struct swZoneFrame
{
    uint32_t zoneVersion; // unique per created zone; never reused
    swPosXZ centre;       // in the sea
    swStackFrame stack;   // its levels
} swZoneFrame;

// A wave number in the middle of a tile's waves, rad/m.
static inline float swGetTileWaveNumber(const swTile* tile)
{
    return 6.2831853f / sqrtf(tile->minWavelength * tile->maxWavelength);
}

// The same of the octave that a wave is in, as far as floats can tell.
static inline float swGetOctaveWaveNumber(float wavelength)
{
    int exponent;
    float fraction = frexpf(wavelength, &exponent); // in [0.5, 1): the octave is [2^(exponent - 1), 2^exponent)
    (void)fraction;
    return 6.2831853f / ldexpf(0.70710678f, exponent);
}

// Ticks to multiply a tile's frequencies with, on either half.
static inline int64_t swGetTileTicks(const swTile* tile, int64_t ticks)
{
    if (tile->loopTicks <= 0)
    {
        return ticks;
    }
    int64_t rest = ticks % tile->loopTicks;
    return rest < 0 ? rest + tile->loopTicks : rest;
}

static inline int64_t swGetFreeWaveTicks(const swFreeWave* wave, int64_t ticks)
{
    if (wave->loopTicks <= 0)
    {
        return ticks;
    }
    int64_t rest = ticks % wave->loopTicks;
    return rest < 0 ? rest + wave->loopTicks : rest;
}

// A fraction of a turn, of 2^32.
static inline uint32_t swGetFractionOfTurn(double turns)
{
    return (uint32_t)(int64_t)floor((turns - floor(turns)) * 4294967296.0);
}

// What a free wave's theta has lost since tick 0, a fraction of 2^32.
static inline uint32_t swGetPassedTurns(const swFreeWave* wave, int64_t ticks)
{
    uint32_t passed = (uint32_t)((wave->frequency * (uint64_t)swGetFreeWaveTicks(wave, ticks)) >> 32);
    bool isCarried = wave->evenFlow != NULL && !swIsEvenFlowStill(wave->evenFlow);
    if (swIsDriftStill(&wave->drift) && !isCarried)
    {
        return passed;
    }
    swPosXZ path = swFindDrift(&wave->drift, ticks), even = swFindEvenPath(wave->evenFlow, ticks);
    path.x += even.x;
    path.z += even.z;
    return passed + swGetFractionOfTurn(wave->turnsX * path.x + wave->turnsZ * path.z);
}

// Where a current and the flow that is the same everywhere have carried a tile's waves at a time, in [0, side).
static inline swPosXZ swGetTileShift(const swTile* tile, int64_t ticks)
{
    swPosXZ path = swFindDrift(&tile->drift, ticks), even = swFindEvenPath(tile->evenFlow, ticks);
    path.x += even.x;
    path.z += even.z;
    return (swPosXZ){path.x - floor(path.x / tile->side) * tile->side,
                     path.z - floor(path.z / tile->side) * tile->side};
}

// Variance of one free wave's slope.
static inline float swGetFreeWaveSlope(const swFreeWave* wave)
{
    float steepness = 6.2831853f / wave->wavelength * wave->amplitude;
    return 0.5f * steepness * steepness;
}

// Adds what one free wave strains.
static inline void swAddFreeWaveStrain(swStrain* strain, const swFreeWave* wave)
{
    float steepness = 6.2831853f / wave->wavelength * wave->amplitude;
    float chop2 = wave->dx * wave->dx + wave->dz * wave->dz;
    if (chop2 <= 0.0f)
    {
        return;
    }
    float share = 0.5f * steepness * steepness / chop2; // of chop^2, as a direction's powers hold chop^4
    strain->cccc += share * wave->dx * wave->dx * wave->dx * wave->dx;
    strain->cccs += share * wave->dx * wave->dx * wave->dx * wave->dz;
    strain->ccss += share * wave->dx * wave->dx * wave->dz * wave->dz;
    strain->csss += share * wave->dx * wave->dz * wave->dz * wave->dz;
    strain->ssss += share * wave->dz * wave->dz * wave->dz * wave->dz;
}

static inline void swScaleStrain(swStrain* strain, float factor)
{
    strain->cccc *= factor;
    strain->cccs *= factor;
    strain->ccss *= factor;
    strain->csss *= factor;
    strain->ssss *= factor;
}

// Variance of dDx/dx + dDz/dz: of J to first order.
static inline float swGetStrainVariance(const swStrain* strain)
{
    return strain->cccc + 2.0f * strain->ccss + strain->ssss;
}

#define SW_MAX_VIEWS 16

// What foam is born by, for the waves of this frame. See core/sim/whitecaps.h.
typedef struct swFoamLaw
{
    float wind;          // m/s: what the waves tell, or the def
    float cover;         // share of the sea under foam in the steady state
    float threshold;     // of J
    float growth;        // per second and unit of fold, where every wave is known
    float unknownGrowth; // the same where none is
    swFoamRest rest;     // of all waves that make foam
    float currentX,
        currentZ; // m/s along x and z: the waves' currents, of several the mean by how they strain the water
} swFoamLaw;

// A body of water as pictures see it, see core/input/water_bodies.h.
typedef struct swBodyFrame
{
    int number; // that the field BODY has in it
    int look;
    bool setsLevel;
    float level;       // of still water above sea level, m, if it sets one
    swPosXZ low, high; // bounds, in the sea
} swBodyFrame;

// One wave of a gust, and a wind with some, see core/input/wind.c. At a place and a tick: along cos(2 pi (turns -
// frequency ticks + phaseAlong)), and so across.
#define SW_GUSTS 12

typedef struct swGust
{
    double turnsX, turnsZ; // turns per metre
    uint64_t frequency;    // turns per tick, as swMode has it
    uint32_t phaseAlong, phaseAcross;
    float alongX, alongZ; // m/s
} swGust;

typedef struct swGustyWind
{
    float meanX, meanZ; // m/s
    int gustCount;
    swGust gusts[SW_GUSTS];
} swGustyWind;

// The wind of the world: one, or one that turns into another over `length` ticks.
typedef struct swWindFrame
{
    bool isNamed; // false: the world names no wind, and all winds here are 0
    int64_t begin, length;
    swGustyWind from, to;
    swWindDef fromDef, toDef; // that they are made of
} swWindFrame;

typedef struct swFrame
{
    double time;
    int64_t ticks;
    double dt;
    double seaLevel;
    float gravity;
    float wind; // m/s at 10 m: the world's mean, or where it names none, as the waves tell (core/waves/wind_level.h)
    swWindFrame windField;
    swFoamDef foam;
    swFoamLaw foamLaw;
    uint32_t tilesVersion; // changes when the list of tiles does
    int tileCount;
    const swTile* tiles; // all systems; within a system by band, shortest first
    int waveCount;
    const swFreeWave* waves; // of all systems, longest first
    int viewCount;
    const swViewFrame* views;
    int zoneCount;
    const swZoneFrame* zones;
    const swInputSet* inputs; // NULL: there are none
    int bodyCount;
    const swBodyFrame* bodies;
} swFrame;

// Whether water carries foam anywhere.
static inline bool swIsFoamCarried(const swFrame* frame)
{
    return swHasInputs(frame->inputs, SW_INPUT_FLOW) || frame->foamLaw.currentX != 0.0f ||
           frame->foamLaw.currentZ != 0.0f;
}

// The foam layer's parameters of slice `i`.
static inline swFoamBirth swGetFoamBirth(const swStackFrame* stack, int i)
{
    swFoamBirth birth;
    memcpy(&birth, stack->layers[SW_LAYER_FOAM].params[i], sizeof birth);
    return birth;
}

SW_SEAM_BEGIN

// How far the first of two copies of waves in a flow is in its period, see shared/carry.h, a fraction of 2^32; the
// second is half a turn ahead. `k` is swGetTileWaveNumber() or swGetOctaveWaveNumber(); `period` is in seconds.
uint32_t swGetCarryPhase(float k, int64_t loopTicks, int64_t ticks, float* period);

// One past the last of the free waves of a frame that a flow carries together with wave `first`, of the first `count`:
// those that follow it, of its system and its octave.
int swFindCarriedEnd(const swFreeWave* waves, int first, int count);

// The frame of the last step. Implemented by world/.
const swFrame* swGetWorldFrame(const swWorld* world);
const swHost* swGetWorldHost(const swWorld* world);
// Of the host's coordinates, in the sea.
swPosXZ swGetWorldOrigin(const swWorld* world);

// What layers.inl says of a layer.
const swLayerInfo* swGetLayerInfo(int layer);

// What slice `i` of a view steps its foam with over `seconds`.
swFoamSliceParams swGetFoamParams(const swFrame* frame, const swStackFrame* stack, int i, float seconds, bool isSteady);

// Over `seconds`, of SW_LAYER_WAKE_FOAM or SW_LAYER_SHORE_FOAM.
swMadeFoamParams swGetMadeFoamParams(const swFrame* frame, int layer, float seconds, bool isSteady);

SW_SEAM_END
